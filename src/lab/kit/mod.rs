//! The kit's own sources, as its packages carry them: what a student's tests and a grader elsewhere are built from,
//! wherever the folder goes.
//!
//! ```text
//!   package     its folders                               built for    with the features
//!   dcel-kit    src/…            ─▶ src/sources/mod.rs    check        compare figure files script
//!                                                         program      all but png
//!   dcel-lab    src/lab/…        ─▶ kit/mod.rs            check        none
//!                                                         program      grade
//!   dcel        src/cli/…        ─▶ lab/kit/mod.rs        program
//!
//!   Cargo.toml, Cargo.lock ──dcel lab bundle──▶ kit/*.txt   manifests and versions for these files alone
//! ```
//!
//! What is compiled in is the file itself, and can never be an old one; which of the files a build reads is read from
//! their lines. A test compares them with the checkout. Files keep the places that they have there.

mod manifest;
mod walk;

pub use walk::Read;

use walk::files_of_build;

use dcel_kit::sources::{self, Texts, include_dir};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io;
use std::path::Path;

/// The manifests in the folder `kit/` of a student: path and text.
pub(super) const MANIFESTS: [(&str, &str); 2] =
    [("Cargo.toml", include_str!("dcel-kit.toml.txt")), ("src/lab/Cargo.toml", include_str!("dcel-lab.toml.txt"))];
/// The versions that a student's folder is built with; the lab's own package stands there as [`ANY_LAB`].
pub(super) const LOCK: &str = include_str!("Cargo.lock.txt");
/// The name and the version of the lab in [`LOCK`].
pub(super) const ANY_LAB: [&str; 2] = ["lab-00", "0.0.0"];

/// Files of this package that are copies, and what they are copies of: a package reads nothing outside of its folder.
pub const COPIES: [(&str, &str); 1] =
    [("src/lab/courses/half_edge/drawing.dcels", "figures/scripts/lab-04-drawing.dcels")];

/// What goes wherever the sources go.
const LICENCES: [&str; 2] = ["LICENSE-APACHE", "LICENSE-MIT"];

/// What this package carries.
#[rustfmt::skip]
static TEXTS: Texts = dcel_kit::texts!(
    "src/lab/", "../",
    folders: [
        "$CARGO_MANIFEST_DIR/bundle", "$CARGO_MANIFEST_DIR/cases", "$CARGO_MANIFEST_DIR/checks",
        "$CARGO_MANIFEST_DIR/course", "$CARGO_MANIFEST_DIR/courses", "$CARGO_MANIFEST_DIR/feedback",
        "$CARGO_MANIFEST_DIR/kit", "$CARGO_MANIFEST_DIR/own_cases", "$CARGO_MANIFEST_DIR/program",
        "$CARGO_MANIFEST_DIR/protocol", "$CARGO_MANIFEST_DIR/reports", "$CARGO_MANIFEST_DIR/sandbox",
        "$CARGO_MANIFEST_DIR/similar", "$CARGO_MANIFEST_DIR/submission", "$CARGO_MANIFEST_DIR/template",
    ],
    files: [
        "LICENSE-APACHE", "LICENSE-MIT", "answers.rs", "batch.rs", "bug.rs", "cache.rs", "conditions.rs", "export.rs",
        "fault.rs", "features.rs", "files.rs", "findings.rs", "grade.rs", "judge.rs", "judged.rs", "lanes.rs", "learn.rs", "lib.rs",
        "manifest.rs", "many.rs", "markers.rs", "mutants.rs", "own_folder.rs", "own_lab.rs", "pictures.rs", "plan.rs",
        "points.rs", "program.rs", "report.rs", "run.rs", "signatures.rs", "stop.rs", "student.rs", "task.rs",
        "the_lab.rs", "told.rs", "toml_file.rs", "typed.rs", "vendor.rs", "verdict.rs", "verify.rs",
    ]
);

/// Files by their paths in the checkout.
pub type Sources = BTreeMap<String, &'static str>;

/// The files of the packages `dcel-kit` and `dcel-lab` that a build reads.
pub fn sources(build: KitBuild) -> Sources {
    texts_of(build, &[(Package::Kit, &sources::TEXTS), (Package::Lab, &TEXTS)])
}

/// The files that a build reads, of packages which carry these texts.
pub fn texts_of(build: KitBuild, packages: &[(Package, &'static Texts)]) -> Sources {
    let of = |&(package, texts): &(Package, &'static Texts)| {
        let read = |path: &str| texts.get(path).map(str::to_owned).ok_or_else(|| io::ErrorKind::NotFound.into());
        let files = package.files(build, &read).unwrap_or_default();
        files.into_iter().filter_map(|path| texts.get(&path).map(|text| (path, text)))
    };
    packages.iter().flat_map(of).collect()
}

dcel_kit::named! {
    /// A package of the kit.
    #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
    pub enum Package {
        /// `dcel-kit`, the library.
        Kit = "dcel-kit",
        /// `dcel-lab`, the engine of the labs.
        Lab = "dcel-lab",
        /// `dcel`, the program.
        Program = "dcel",
    }

    /// As it is published.
    fn name;
    /// All, each after those that it needs.
    const ALL;
}

impl Package {
    /// Its folder in a checkout, with a `/` at the end unless it is the root.
    #[must_use]
    pub fn folder(self) -> &'static str {
        match self {
            Self::Kit => "",
            Self::Lab => "src/lab/",
            Self::Program => "src/cli/",
        }
    }

    /// The roots of its crates.
    fn entries(self) -> &'static [&'static str] {
        match self {
            Self::Kit => &["src/lib.rs"],
            Self::Lab => &["src/lab/lib.rs"],
            Self::Program => &["src/cli/lib.rs", "src/cli/main.rs"],
        }
    }

    /// The files of this package that a build reads, as paths from the root of the checkout whose files `read` reads.
    ///
    /// # Errors
    /// A file that cannot be read.
    pub fn files(self, build: KitBuild, read: Read) -> io::Result<BTreeSet<String>> {
        if !build.packages().contains(&self) {
            return Ok(BTreeSet::new());
        }
        let mut files = BTreeSet::new();
        for entry in self.entries() {
            files.extend(files_of_build(read, entry, build.features(self))?);
        }
        files.extend(LICENCES.map(|licence| format!("{}{licence}", self.folder())));
        Ok(files)
    }
}

/// The features of `dcel-lab` that stand for labs.
const LABS: &[&str] = GRADE_AND_LABS.split_at(1).1;
const GRADE_AND_LABS: &[&str] = &[
    "grade", "lab-01", "lab-02", "lab-03", "lab-04", "lab-05", "lab-06", "lab-07", "lab-08", "lab-09", "lab-10",
    "lab-11",
];

dcel_kit::named! {
    /// A build of the kit whose sources are carried along.
    #[derive(Clone, Copy, PartialEq, Eq, Debug)]
    pub enum KitBuild {
        /// What the graded tests in a student's folder need.
        Check = "src/lab/kit",
        /// The program: for a grader elsewhere.
        Program = "src/cli/lab/kit",
    }

    /// Where its manifests and its versions are in a checkout.
    fn folder;
    /// Both, the smaller one first.
    const ALL;
}

impl KitBuild {
    /// The packages of this build, each after those that it needs.
    #[must_use]
    pub fn packages(self) -> &'static [Package] {
        match self {
            Self::Check => &[Package::Kit, Package::Lab],
            Self::Program => &Package::ALL,
        }
    }

    fn features(self, package: Package) -> &'static [&'static str] {
        match (self, package) {
            (Self::Check, Package::Kit) => &["compare", "figure", "files", "script"],
            (Self::Program, Package::Kit) => {
                &["compare", "figure", "files", "io", "navmesh", "play", "script", "solid", "sources"]
            }
            (Self::Check, Package::Lab) => LABS,
            (Self::Program, Package::Lab) => GRADE_AND_LABS,
            (_, Package::Program) => &[],
        }
    }

    /// The manifests of this build, from those of the checkout: without tests, and without the packages of labs.
    ///
    /// # Errors
    /// A file that cannot be read.
    pub fn manifests(self, checkout: &Path) -> io::Result<BTreeMap<Package, String>> {
        let of = |&package: &Package| {
            let path = format!("{}Cargo.toml", package.folder());
            let text = fs::read_to_string(checkout.join(&path));
            let text = text.map_err(|error| io::Error::other(format!("{path}: {error}")))?;
            Ok((package, manifest::of_build(self, package, &text)))
        };
        self.packages().iter().map(of).collect()
    }

    /// The least that cargo needs to settle the versions of this build: paths and texts.
    #[must_use]
    pub fn workspace(self, manifests: &BTreeMap<Package, String>) -> Vec<(String, String)> {
        let kit = match self {
            Self::Check => "kit/",
            Self::Program => "",
        };
        let mut files = Vec::new();
        for (package, manifest) in manifests {
            files.push((format!("{kit}{}Cargo.toml", package.folder()), manifest.clone()));
            files.extend(package.entries().iter().map(|entry| (format!("{kit}{entry}"), String::new())));
        }
        if self == Self::Check {
            let [name, version] = ANY_LAB;
            let lab = format!(
                "[package]\nname = \"{name}\"\nversion = \"{version}\"\nedition = \"2024\"\n\n\
                 [dev-dependencies]\ndcel-lab = {{ path = \"kit/src/lab\", default-features = false }}\n\n[workspace]\n"
            );
            files.extend([("Cargo.toml".to_owned(), lab), ("src/lib.rs".to_owned(), String::new())]);
        }
        files
    }
}

/// The lock file of a student's folder: that of [`LOCK`] with this lab in it.
///
/// Cargo keeps packages in the order of their names.
pub(super) fn lock_with(package: &str, version: &str) -> String {
    let [any, any_version] = ANY_LAB;
    let mut entries: Vec<String> = LOCK.trim_end().split("\n\n").map(str::to_owned).collect();
    let entry = entries.iter_mut().find(|entry| entry.contains(&format!("name = \"{any}\"\n")));
    if let Some(entry) = entry {
        *entry = entry.replacen(any, package, 1).replacen(any_version, version, 1);
    }
    let head = entries.iter().take_while(|entry| !entry.starts_with("[[package]]")).count();
    let name = |entry: &String| entry.lines().nth(1).unwrap_or_default().to_owned();
    entries[head..].sort_by_key(name);
    entries.join("\n\n") + "\n"
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_lock_file_of_a_lab_is_in_cargos_order() {
        let lock = lock_with("lab-04-half-edge", "1.2.3");
        assert!(lock.contains("name = \"lab-04-half-edge\"\nversion = \"1.2.3\"\n"), "{lock}");
        assert!(!lock.contains(ANY_LAB[0]));
        assert_eq!(lock_with(ANY_LAB[0], ANY_LAB[1]), LOCK);
        let first = lock_with("aaa", "1.0.0");
        assert!(first.find("name = \"aaa\"").unwrap() < first.find("name = \"dcel-kit\"").unwrap());
        assert!(first.starts_with("# This file is automatically"), "{first}");
    }

    #[test]
    fn the_program_has_all_files_of_the_check() {
        let [check, program] = KitBuild::ALL.map(sources);
        assert!(check.keys().all(|path| program.contains_key(path)) && check.len() < program.len());
        for (file, in_check) in [("src/lab/submission/scan.rs", true), ("src/lab/batch.rs", false)] {
            assert_eq!((check.contains_key(file), program.contains_key(file)), (in_check, true), "{file}");
        }
    }
}
