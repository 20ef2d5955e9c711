//! A case: a start, then calls, as text for a driver.

use super::structure::Structure;
use dcel_kit::topology::Table;
use std::fmt::{Display, Write};
use std::sync::Arc;

/// What a case begins with: a line that the student's program makes a structure of, or the lines of a table.
///
/// ```
/// use dcel_lab::protocol::{Case, Start, Step};
/// let case = Case::new("first", Start::line("polygon 0 0 4 0 3 3")).step(Step::Dump);
/// assert_eq!(case.script(), "polygon 0 0 4 0 3 3\ndump\n");
/// ```
#[derive(Clone, PartialEq, Debug)]
pub struct Start {
    /// Its lines, without the last line end; empty for a case that begins with nothing.
    text: String,
    /// The structure, if it need not be printed to be known.
    known: Option<Structure>,
}

impl Start {
    /// Nothing: for labs whose functions need no structure.
    #[must_use]
    pub fn none() -> Self {
        Self { text: String::new(), known: None }
    }

    /// A line whose structure is known once the program has printed it.
    pub fn line(line: impl Into<String>) -> Self {
        Self { text: line.into(), known: None }
    }

    /// A line that makes a structure which is known without being printed.
    pub fn known(line: impl Into<String>, structure: Structure) -> Self {
        Self { text: line.into(), known: Some(structure) }
    }

    /// Any structure, as the lines of a dump.
    #[must_use]
    pub fn structure_of(structure: Structure) -> Self {
        let mut text = String::from("table\n");
        structure.write(&mut text);
        text.push_str("end_table");
        Self { text, known: Some(structure) }
    }

    /// Half-edges, as the lines of a dump.
    #[must_use]
    pub fn table(table: impl Into<Arc<Table>>) -> Self {
        Self::structure_of(Structure::HalfEdges(table.into()))
    }

    /// Its lines.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Whether its records are written out.
    #[must_use]
    pub fn is_table(&self) -> bool {
        self.text.starts_with("table\n")
    }

    /// The structure, if it need not be printed to be known.
    #[must_use]
    pub fn structure(&self) -> Option<&Structure> {
        self.known.as_ref()
    }

    /// The half-edges, if they need not be printed to be known.
    #[must_use]
    pub fn half_edges(&self) -> Option<&Arc<Table>> {
        self.known.as_ref().and_then(Structure::half_edges)
    }

    /// How to show the structure after it: of a large one only what has changed.
    #[must_use]
    pub fn dump(&self) -> Step {
        let is_large = self.known.as_ref().is_some_and(|structure| structure.len() > LARGE);
        if is_large { Step::Changes } else { Step::Dump }
    }
}

/// Structures with more records are never printed whole.
const LARGE: usize = 10_000;

/// A line after the start.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub enum Step {
    /// A call of one of the student's functions; the arguments are words such as `h0.next`.
    Call {
        /// The function.
        function: String,
        /// Its arguments.
        arguments: Vec<String>,
    },
    /// The structure is to be printed.
    Dump,
    /// What has changed since it was printed last, or since the start, is to be printed.
    Changes,
    /// The number of records that the last call looked at is to be printed.
    Reads,
    /// A function of one element is to be called for many elements, evenly spread over all.
    Many {
        /// The function.
        function: String,
        /// For how many.
        count: usize,
        /// How many records they may look at together; then no more are asked.
        budget: u64,
    },
    /// The student's program is to draw the structure.
    Svg,
    /// The structure is to be remembered.
    Save,
    /// The remembered structure is to come back.
    Restore,
}

impl Step {
    /// A call with the words of its arguments.
    pub fn call<W: Display>(function: &str, arguments: impl IntoIterator<Item = W>) -> Self {
        let arguments = arguments.into_iter().map(|word| word.to_string()).collect();
        Self::Call { function: function.to_owned(), arguments }
    }

    /// A call as it is typed: the function, then its arguments.
    #[must_use]
    pub fn of_line(line: &str) -> Self {
        let mut words = line.split_whitespace();
        let function = words.next().unwrap_or_default();
        Self::call(function, words)
    }

    /// Whether the structure is shown.
    #[must_use]
    pub fn shows(&self) -> bool {
        matches!(self, Self::Dump | Self::Changes)
    }

    /// Whether it is answered.
    #[must_use]
    pub fn is_answered(&self) -> bool {
        !matches!(self, Self::Save | Self::Restore)
    }
}

/// A start and what to do with it.
#[derive(Clone, PartialEq, Debug)]
pub struct Case {
    /// Its name: letters, digits, `_`, `.` and `-`.
    pub name: String,
    /// What it begins with.
    pub start: Start,
    /// The lines after that.
    pub steps: Vec<Step>,
}

impl Case {
    /// A case without any step yet.
    pub fn new(name: impl Into<String>, start: Start) -> Self {
        Self { name: name.into(), start, steps: Vec::new() }
    }

    /// A case that calls a function of the line, `left_turn 0 0 1 0 0 1`, and no other.
    pub fn call(name: impl Into<String>, start: Start, line: &str) -> Self {
        Self::new(name, start).step(Step::of_line(line))
    }

    /// Adds a step.
    #[must_use]
    pub fn step(mut self, step: Step) -> Self {
        self.steps.push(step);
        self
    }

    /// Adds calls, each followed by these steps.
    #[must_use]
    pub fn calls(mut self, calls: impl IntoIterator<Item = Step>, after: &[Step]) -> Self {
        for call in calls {
            self.steps.push(call);
            self.steps.extend_from_slice(after);
        }
        self
    }

    /// Adds calls, each made on the structure as it is now, and shown after it.
    #[must_use]
    pub fn each_alone(self, calls: impl IntoIterator<Item = Step>) -> Self {
        self.step(Step::Save).calls(calls, &[Step::Dump, Step::Restore])
    }

    /// The shortest case with the same structure before step `at` and the same step `at`, and the number of the
    /// step in it: what was done and undone by `save` and `restore` is left out, and so are calls that only read
    /// (no dump follows them), and other dumps than the one just before. A picture shows what all calls have made. If a
    /// call changes the structure, a `dump` should follow: `with_dump`.
    #[must_use]
    pub fn reduced_to(&self, at: usize, with_dump: bool) -> (Self, usize) {
        let mut steps: Vec<Step> = Vec::new();
        let mut saved = 0;
        let is_picture = self.steps.get(at) == Some(&Step::Svg);
        let shows = |i: usize| self.steps.get(i).is_some_and(Step::shows);
        for (i, step) in self.steps.iter().enumerate().take(at) {
            match step {
                Step::Save => saved = steps.len(),
                Step::Restore => steps.truncate(saved),
                Step::Call { .. } if is_picture || shows(i + 1) => steps.push(step.clone()),
                _ => {}
            }
        }
        steps.push(self.start.dump());
        let place = steps.len();
        steps.extend(self.steps.get(at).filter(|step| step.is_answered()).cloned());
        if with_dump {
            steps.push(self.start.dump());
        }
        (Self { name: self.name.clone(), start: self.start.clone(), steps }, place)
    }

    /// The lines of the case without its name: what a student types.
    #[must_use]
    pub fn script(&self) -> String {
        let mut out = String::new();
        self.write_start(&mut out);
        for step in &self.steps {
            step.write(&mut out);
        }
        out
    }

    /// All cases as one input.
    pub fn input<'a>(token: &str, cases: impl IntoIterator<Item = &'a Self>) -> String {
        let mut out = format!("token {token}\n");
        for case in cases {
            let _ = writeln!(out, "case {}", case.name);
            case.write_start(&mut out);
            case.steps.iter().for_each(|step| step.write(&mut out));
        }
        out
    }

    fn write_start(&self, out: &mut String) {
        if !self.start.text.is_empty() {
            out.push_str(&self.start.text);
            out.push('\n');
        }
    }
}

impl Step {
    fn write(&self, out: &mut String) {
        match self {
            Self::Call { function, arguments } => {
                out.push_str(function);
                for word in arguments {
                    out.push(' ');
                    out.push_str(word);
                }
            }
            Self::Dump => out.push_str("dump"),
            Self::Changes => out.push_str("dump changes"),
            Self::Reads => out.push_str("reads"),
            Self::Many { function, count, budget } => {
                let _ = write!(out, "many {count} {function} {budget}");
            }
            Self::Svg => out.push_str("svg"),
            Self::Save => out.push_str("save"),
            Self::Restore => out.push_str("restore"),
        }
        out.push('\n');
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn calls(words: &[&str]) -> Vec<Step> {
        let step = |word: &&str| match *word {
            "save" => Step::Save,
            "restore" => Step::Restore,
            "dump" => Step::Dump,
            word => Step::call("split_in_half", [word]),
        };
        words.iter().map(step).collect()
    }

    #[test]
    fn a_case_is_reduced_to_what_leads_to_a_step() {
        let steps =
            calls(&["h0", "dump", "save", "h2", "dump", "restore", "h4", "dump", "restore", "h9", "h6", "dump"]);
        let case = Case { steps, ..Case::new("x", Start::line("rectangle")) };
        let (reduced, at) = case.reduced_to(10, true);
        assert_eq!(reduced.script(), "rectangle\nsplit_in_half h0\ndump\nsplit_in_half h6\ndump\n");
        assert_eq!(at, 2);
        assert_eq!(case.reduced_to(0, false).0.script(), "rectangle\ndump\nsplit_in_half h0\n");
        // A picture shows what was made by calls that no dump follows.
        let steps = [Step::call("from_faces", ["0", "1", "2"]), Step::call("outer", [] as [&str; 0]), Step::Svg];
        let drawn = Case { steps: steps.into(), ..Case::new("picture", Start::line("points 0 0 1 0 0 1")) };
        let (reduced, at) = drawn.reduced_to(2, false);
        assert_eq!(reduced.script(), "points 0 0 1 0 0 1\nfrom_faces 0 1 2\nouter\ndump\nsvg\n");
        assert_eq!(at, 3);
    }
}
