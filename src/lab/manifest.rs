//! `lab.toml`: what there is to do in a lab, what it is worth, what a submission may use.
//!
//! ```text
//!   name = "04-half-edge"          [files]   graded, optional      [[task]]  number title section
//!   title, version, package        [limits]  seconds, memory_mb …  [[test]]  name title task points needs
//!                                  [drawing] reference                       visibility
//! ```
//!
//! Unknown keys are refused, so that a typing error does not become a default. `needs` names earlier tests only, so
//! the order of the file is an order in which to work, and there is no circle.

use super::toml_file::{ManifestError, TomlFile};
use super::{Limits, Points, Visibility};
use serde::Deserialize;
use std::collections::BTreeSet;
use toml::Spanned;

/// What a lab's manifest says.
#[derive(Clone, PartialEq, Debug)]
pub struct Manifest {
    /// As its folder is called: `04-half-edge`.
    pub name: String,
    /// A line for people.
    pub title: String,
    /// Written into every report.
    pub version: String,
    /// The package and the program that it builds: `lab-04-half-edge`.
    pub package: String,
    /// The files of the student that are taken, relative to the package, with `/`; at least one.
    pub graded: Vec<String>,
    /// Files of the student that are taken if they are there: answers, in Markdown.
    pub optional: Vec<String>,
    /// What the program may use.
    pub limits: Limits,
    /// In the order of the handout.
    pub tasks: Vec<Task>,
    /// In an order in which to work.
    pub tests: Vec<Test>,
    /// The figure that the drawing is compared with: a file of the folder `figures/`.
    pub drawing: Option<String>,
}

/// A task of the handout.
#[derive(Clone, PartialEq, Eq, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Task {
    /// Its number in the handout.
    pub number: u32,
    /// A line for people.
    pub title: String,
    /// The section of the handout that explains what it needs.
    pub section: String,
}

/// A graded test.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Test {
    /// Its name: the function in `tests/graded.rs`.
    pub name: String,
    /// A line for people.
    pub title: String,
    /// The number of its task.
    pub task: u32,
    /// What it is worth.
    pub points: Points,
    /// Who may see its result when.
    pub visibility: Visibility,
    /// The tests that it builds on, all of them earlier in the list: unless these pass, it is skipped.
    pub needs: Vec<String>,
}

impl Manifest {
    /// Reads a manifest; `source` is its name in messages. Cost: linear, but for the names, which are few.
    ///
    /// # Errors
    /// [`ManifestError`] with line and column: not TOML, a key that is missing or unknown, a value that does not fit
    /// the others.
    pub fn parse(text: &str, source: &str) -> Result<Self, ManifestError> {
        let toml = TomlFile { text, source };
        let file: File = toml.read()?;
        let reader = Reader(toml);
        reader.files(&file)?;
        if let Some(limits) = &file.limits {
            reader.limits(limits)?;
        }
        reader.tasks(&file)?;
        reader.tests(&file)?;
        Ok(file.into_manifest())
    }

    /// The test of this name.
    #[must_use]
    pub fn test(&self, name: &str) -> Option<&Test> {
        self.tests.iter().find(|test| test.name == name)
    }

    /// The task of this number.
    #[must_use]
    pub fn task(&self, number: u32) -> Option<&Task> {
        self.tasks.iter().find(|task| task.number == number)
    }

    /// Tests, and all that they need.
    pub(super) fn with_needs<'a>(&'a self, mut tests: BTreeSet<&'a str>) -> BTreeSet<&'a str> {
        // Tests need earlier ones only, so one way back through the list finds all.
        for test in self.tests.iter().rev() {
            if tests.contains(test.name.as_str()) {
                tests.extend(test.needs.iter().map(String::as_str));
            }
        }
        tests
    }

    /// The points that can be earned.
    #[must_use]
    pub fn max_points(&self) -> Points {
        self.tests.iter().map(|test| test.points).sum()
    }
}

// ---- the file as it is written -------------------------------------------------------------------------

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    name: String,
    title: String,
    version: String,
    package: String,
    files: Files,
    limits: Option<Spanned<LimitsTable>>,
    task: Vec<Spanned<Task>>,
    test: Vec<Spanned<TestTable>>,
    drawing: Option<DrawingTable>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Files {
    graded: Spanned<Vec<Spanned<String>>>,
    #[serde(default)]
    optional: Vec<Spanned<String>>,
}

/// What is not said stays as in [`Limits::default`].
#[derive(Deserialize, Default)]
#[serde(deny_unknown_fields)]
pub(super) struct LimitsTable {
    seconds: Option<f64>,
    cpu_seconds: Option<u64>,
    memory_mb: Option<u64>,
    output_kb: Option<u64>,
    file_kb: Option<u64>,
    files: Option<u64>,
    processes: Option<u64>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct TestTable {
    name: String,
    title: String,
    task: Spanned<u32>,
    points: Points,
    #[serde(default)]
    visibility: Visibility,
    #[serde(default)]
    needs: Vec<Spanned<String>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct DrawingTable {
    reference: String,
}

impl File {
    fn into_manifest(self) -> Manifest {
        let plain = |names: Vec<Spanned<String>>| names.into_iter().map(Spanned::into_inner).collect();
        let test = |test: Spanned<TestTable>| {
            let TestTable { name, title, task, points, visibility, needs } = test.into_inner();
            Test { name, title, task: task.into_inner(), points, visibility, needs: plain(needs) }
        };
        Manifest {
            name: self.name,
            title: self.title,
            version: self.version,
            package: self.package,
            graded: plain(self.files.graded.into_inner()),
            optional: plain(self.files.optional),
            limits: self.limits.map_or_else(Limits::default, |table| table.get_ref().limits()),
            tasks: self.task.into_iter().map(Spanned::into_inner).collect(),
            tests: self.test.into_iter().map(test).collect(),
            drawing: self.drawing.map(|drawing| drawing.reference),
        }
    }
}

impl LimitsTable {
    fn limits(&self) -> Limits {
        self.over(Limits::default())
    }

    /// The limits with those that the table names.
    pub(super) fn over(&self, usual: Limits) -> Limits {
        Limits {
            seconds: self.seconds.unwrap_or(usual.seconds),
            cpu_seconds: self.cpu_seconds.unwrap_or(usual.cpu_seconds),
            memory_mb: self.memory_mb.unwrap_or(usual.memory_mb),
            output_kb: self.output_kb.unwrap_or(usual.output_kb),
            file_kb: self.file_kb.unwrap_or(usual.file_kb),
            files: self.files.unwrap_or(usual.files),
            processes: self.processes.unwrap_or(usual.processes),
        }
    }

    /// Whether a program can run at all.
    pub(super) fn can_run(limits: &Limits) -> bool {
        let counts = [limits.cpu_seconds, limits.memory_mb, limits.output_kb, limits.files, limits.processes];
        limits.seconds.is_finite() && limits.seconds > 0.0 && counts.iter().all(|&count| count > 0)
    }
}

// ---- checks ---------------------------------------------------------------------------------------------

/// The text, for places in messages.
struct Reader<'a>(TomlFile<'a>);

impl Reader<'_> {
    fn files(&self, file: &File) -> Result<(), ManifestError> {
        let Files { graded, optional } = &file.files;
        if graded.get_ref().is_empty() {
            return Err(self.0.error(graded.span().start, "no file is graded; name one, such as \"src/lab.rs\""));
        }
        for path in graded.get_ref().iter().chain(optional) {
            let inside = |part: &str| !part.is_empty() && part != "." && part != ".." && !part.contains(['\\', ':']);
            if !path.get_ref().split('/').all(inside) {
                let what = format!(
                    "{:?} is not a file inside the lab's folder; write it as \"src/lab.rs\", with `/`",
                    path.get_ref()
                );
                return Err(self.0.error(path.span().start, what));
            }
        }
        Ok(())
    }

    fn limits(&self, table: &Spanned<LimitsTable>) -> Result<(), ManifestError> {
        if LimitsTable::can_run(&table.get_ref().limits()) {
            return Ok(());
        }
        Err(self.0.error(table.span().start, "a limit is not above 0; nothing could run"))
    }

    fn tasks(&self, file: &File) -> Result<(), ManifestError> {
        for (i, task) in file.task.iter().enumerate() {
            let number = task.get_ref().number;
            if file.task[..i].iter().any(|before| before.get_ref().number == number) {
                return Err(self.0.error(task.span().start, format!("task {number} was given before")));
            }
        }
        Ok(())
    }

    fn tests(&self, file: &File) -> Result<(), ManifestError> {
        for (i, test) in file.test.iter().enumerate() {
            let TestTable { name, task, points, needs, .. } = test.get_ref();
            let at = test.span().start;
            if name.is_empty() || !name.bytes().all(|b| b.is_ascii_lowercase() || b.is_ascii_digit() || b == b'_') {
                return Err(self.0.error(at, format!("{name:?} cannot be a test: its name is that of a function")));
            }
            if *points <= Points::ZERO {
                return Err(self.0.error(at, format!("the test {name} is worth nothing; give it points")));
            }
            let before = &file.test[..i];
            let is_before = |other: &str| before.iter().any(|test| test.get_ref().name == other);
            if is_before(name) {
                return Err(self
                    .0
                    .error(at, format!("the test {name} was given before; give one of them another name")));
            }
            if !file.task.iter().any(|known| known.get_ref().number == *task.get_ref()) {
                return Err(self.0.error(task.span().start, format!("there is no task {}", task.get_ref())));
            }
            if let Some(need) = needs.iter().find(|need| !is_before(need.get_ref())) {
                let what = format!("{name} needs {}, which is no earlier test", need.get_ref());
                return Err(self.0.error(need.span().start, what));
            }
        }
        Ok(())
    }
}
