//! The kit's own sources, as its packages carry them: what a student's tests and a grader elsewhere are built from,
//! wherever the folder goes.
//!
//! ```text
//!   package     files that it lists                       built for    with the features
//!   dcel-kit    src/…            ─▶ src/sources/list.rs   check        compare figure files script
//!                                                         program      all but png
//!   dcel-lab    src/lab/…        ─▶ kit/sources.rs        check        none
//!                                                         program      grade
//!   dcel        src/cli/…        ─▶ lab/kit/sources.rs    program
//!
//!   Cargo.toml, Cargo.lock ──dcel lab bundle──▶ kit/*.txt   manifests and versions for these files alone
//! ```
//!
//! A list holds names and no copies: what is compiled in is the file itself, and can never be an old one. A test
//! compares the lists with what the builds read. Files keep the places that they have in the checkout.

mod manifest;
mod sources;
mod walk;

use walk::files_of_build;

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
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

/// The files of the packages `dcel-kit` and `dcel-lab` that a build reads: path in the checkout, and text.
pub fn sources(build: KitBuild) -> impl Iterator<Item = (&'static str, &'static str)> {
    let further = [dcel_kit::sources::FURTHER, sources::FURTHER].concat();
    let further = if build == KitBuild::Program { further } else { Vec::new() };
    dcel_kit::sources::CHECK.iter().chain(sources::CHECK).copied().chain(further)
}

/// A package of the kit.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Package {
    /// `dcel-kit`, the library.
    Kit,
    /// `dcel-lab`, the engine of the labs.
    Lab,
    /// `dcel`, the program.
    Program,
}

impl Package {
    /// All, each after those that it needs.
    pub const ALL: [Self; 3] = [Self::Kit, Self::Lab, Self::Program];

    /// As it is published.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Kit => "dcel-kit",
            Self::Lab => "dcel-lab",
            Self::Program => "dcel",
        }
    }

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

    /// Where in a checkout its list of files is.
    #[must_use]
    pub fn list_file(self) -> &'static str {
        match self {
            Self::Kit => "src/sources/list.rs",
            Self::Lab => "src/lab/kit/sources.rs",
            Self::Program => "src/cli/lab/kit/sources.rs",
        }
    }

    /// The text of its list of files.
    ///
    /// # Errors
    /// A file that cannot be read.
    pub fn list(self, checkout: &Path) -> io::Result<String> {
        let check = self.files(KitBuild::Check, checkout)?;
        let all = self.files(KitBuild::Program, checkout)?;
        let mut out = "//! The files of this package. Generated: `dcel lab bundle`.\n".to_owned();
        // From the folder of the list to that of the package.
        let up = "../".repeat(self.list_file()[self.folder().len()..].matches('/').count());
        let mut array = |name: &str, about: &str, files: &mut dyn Iterator<Item = &String>| {
            let files: Vec<_> = files.collect();
            let visible = if self == Self::Kit { "pub" } else { "pub(super)" };
            let _ = writeln!(out, "\n/// {about}: path in the checkout, and text.\n#[rustfmt::skip]");
            let _ = writeln!(out, "{visible} const {name}: &[(&str, &str)] = &[");
            for file in files {
                let inside = file.strip_prefix(self.folder()).unwrap_or(file);
                let _ = writeln!(out, "    (\"{file}\", include_str!(\"{up}{inside}\")),");
            }
            out.push_str("];\n");
        };
        if self != Self::Program {
            array("CHECK", "What the tests in a student's folder need", &mut check.iter());
        }
        array("FURTHER", "What a grader needs besides", &mut all.difference(&check));
        Ok(out)
    }

    /// The files of this package that a build reads, as paths from the root of the checkout.
    ///
    /// # Errors
    /// A file that cannot be read.
    pub fn files(self, build: KitBuild, checkout: &Path) -> io::Result<BTreeSet<String>> {
        if !build.packages().contains(&self) {
            return Ok(BTreeSet::new());
        }
        let mut files = BTreeSet::new();
        for entry in self.entries() {
            files.extend(files_of_build(checkout, entry, build.features(self))?);
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

/// A build of the kit whose sources are carried along.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum KitBuild {
    /// What the graded tests in a student's folder need.
    Check,
    /// The program: for a grader elsewhere.
    Program,
}

impl KitBuild {
    /// Both, the smaller one first.
    pub const ALL: [Self; 2] = [Self::Check, Self::Program];

    /// The packages of this build, each after those that it needs.
    #[must_use]
    pub fn packages(self) -> &'static [Package] {
        match self {
            Self::Check => &[Package::Kit, Package::Lab],
            Self::Program => &Package::ALL,
        }
    }

    /// Where its manifests and its versions are in a checkout.
    #[must_use]
    pub fn folder(self) -> &'static str {
        match self {
            Self::Check => "src/lab/kit",
            Self::Program => "src/cli/lab/kit",
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
    fn a_build_has_each_file_once_and_the_program_has_all_of_the_check() {
        let paths = |build| sources(build).map(|(path, _)| path).collect::<Vec<_>>();
        let [check, program] = KitBuild::ALL.map(paths);
        let known: BTreeSet<&str> = program.iter().copied().collect();
        assert_eq!(known.len(), program.len());
        assert!(check.iter().all(|path| known.contains(path)) && check.len() < program.len());
        for (file, in_check) in [("src/lab/submission/scan.rs", true), ("src/lab/batch.rs", false)] {
            assert_eq!((check.contains(&file), known.contains(file)), (in_check, true), "{file}");
        }
    }
}
