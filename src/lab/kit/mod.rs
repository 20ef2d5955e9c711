//! The kit's own sources, as the program carries them: what a student's tests are built from wherever the folder goes.
//!
//! ```text
//!   src/…, Cargo.toml, Cargo.lock ──dcel lab bundle──▶ kit/sources.rs      one include_str! for each file
//!                                                      kit/Cargo.toml.txt  a manifest for these files alone
//!                                                      kit/Cargo.lock.txt  the versions, as cargo writes them
//! ```
//!
//! The list holds names and no copies: what is compiled in is the file itself, and can never be an old one. A test
//! compares the list with what a build reads.

mod sources;
mod walk;

use walk::files_of_build;

use std::collections::BTreeSet;
use std::fmt::Write;
use std::io;
use std::path::Path;

/// The manifest of the folder `kit/` of a student.
pub(super) const MANIFEST: &str = include_str!("Cargo.toml.txt");
/// The versions that a student's folder is built with; the lab's own package stands there as [`ANY_LAB`].
pub(super) const LOCK: &str = include_str!("Cargo.lock.txt");
/// The name and the version of the lab in [`LOCK`].
pub(super) const ANY_LAB: [&str; 2] = ["lab-00", "0.0.0"];

/// What goes wherever the sources go.
const LICENCES: [&str; 2] = ["LICENSE-APACHE", "LICENSE-MIT"];

/// The files of the kit that the graded tests of a lab need: path in the checkout, and text.
#[must_use]
pub fn lab_sources() -> &'static [(&'static str, &'static str)] {
    &sources::SOURCES
}

/// A build of the kit whose sources are carried along.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum KitBuild {
    /// The library with the engine of the labs: for the graded tests in a student's folder.
    Lab,
    /// The program: for a grader elsewhere.
    Program,
}

impl KitBuild {
    /// Both, the smaller one first.
    pub const ALL: [Self; 2] = [Self::Lab, Self::Program];

    /// Where the generated files of this build are in a checkout.
    #[must_use]
    pub fn folder(self) -> &'static str {
        match self {
            Self::Lab => "src/lab/kit",
            Self::Program => "src/cli/lab/kit",
        }
    }

    fn features(self) -> &'static [&'static str] {
        match self {
            Self::Lab => &["lab"],
            Self::Program => &["lab", "grade", "cli", "io", "navmesh", "solid"],
        }
    }

    /// The files of the checkout that this build reads. Those of the program are listed without those of the labs.
    ///
    /// # Errors
    /// A file that cannot be read.
    pub fn files(self, checkout: &Path) -> io::Result<BTreeSet<String>> {
        let mut library = files_of_build(checkout, &["src/lib.rs"], Self::Lab.features())?;
        library.extend(LICENCES.map(str::to_owned));
        match self {
            Self::Lab => Ok(library),
            Self::Program => {
                let all = files_of_build(checkout, &["src/lib.rs", "src/main.rs"], self.features())?;
                Ok(all.difference(&library).cloned().collect())
            }
        }
    }

    /// The text of `sources.rs`.
    #[must_use]
    pub fn list(self, files: &BTreeSet<String>) -> String {
        let up = "../".repeat(self.folder().matches('/').count() + 1);
        let mut out = "//! The files of this build. Generated: `dcel lab bundle`.\n\n".to_owned();
        let _ = writeln!(out, "#[rustfmt::skip]\npub(super) const SOURCES: [(&str, &str); {}] = [", files.len());
        for file in files {
            let _ = writeln!(out, "    (\"{file}\", include_str!(\"{up}{file}\")),");
        }
        out.push_str("];\n");
        out
    }

    /// The least that cargo needs to settle the versions of this build: paths and texts.
    #[must_use]
    pub fn workspace(self, manifest: &str) -> Vec<(&'static str, String)> {
        let (none, text) = (String::new, manifest.to_owned());
        match self {
            Self::Lab => {
                let [name, version] = ANY_LAB;
                let lab = format!(
                    "[package]\nname = \"{name}\"\nversion = \"{version}\"\nedition = \"2024\"\n\n\
                     [dev-dependencies]\ndcel-kit = {{ path = \"kit\", features = [\"lab\"] }}\n\n[workspace]\n"
                );
                vec![("Cargo.toml", lab), ("src/lib.rs", none()), ("kit/Cargo.toml", text), ("kit/src/lib.rs", none())]
            }
            Self::Program => vec![("Cargo.toml", text), ("src/lib.rs", none()), ("src/main.rs", none())],
        }
    }

    /// The manifest of this build, from that of the checkout: without tests, and without the package of a lab.
    #[must_use]
    pub fn manifest(self, checkout: &str) -> String {
        let sections = Sections(checkout);
        let mut out =
            "# The half-edge kit, as far as it is needed here. Generated: `dcel lab bundle`.\n[package]\n".to_owned();
        for key in ["name", "version", "edition", "rust-version", "description", "license"] {
            out.extend(sections.line("package", key).map(|line| format!("{line}\n")));
        }
        out.push_str("publish = false\nbuild = false\nautobins = false\nautotests = false\nautoexamples = false\nautobenches = false\n");
        match self {
            Self::Lab => {
                // What the feature switches on is always there: nobody builds this without it.
                let needs = sections.line("features", "lab").unwrap_or_default();
                out.push_str("\n[features]\nlab = []\n\n[dependencies]\n");
                for line in sections.lines("dependencies") {
                    let name = line.split(' ').next().unwrap_or_default();
                    if !line.contains("optional = true") || needs.contains(&format!("\"dep:{name}\"")) {
                        let _ = writeln!(out, "{}", line.replace(", optional = true", ""));
                    }
                }
            }
            Self::Program => {
                out.push_str("\n[[bin]]\nname = \"dcel\"\npath = \"src/main.rs\"\nrequired-features = [\"cli\"]\n");
                for section in ["features", "dependencies", "target.'cfg(target_os = \"linux\")'.dependencies"] {
                    let _ = writeln!(out, "\n[{section}]");
                    // Figures as PNG have fonts of their own, which a grader does without.
                    for line in
                        sections.lines(section).filter(|line| !line.starts_with("png ") && !line.starts_with("resvg "))
                    {
                        let _ = writeln!(out, "{line}");
                    }
                }
                out.push_str("\n[profile.release]\ndebug = false\n\n[workspace]\n");
            }
        }
        out.push_str(
            "\n[lints.rust]\nunexpected_cfgs = \"allow\" # features that this part of the kit does not have\n",
        );
        out
    }
}

/// A manifest by sections; each entry stands in one line.
struct Sections<'a>(&'a str);

impl<'a> Sections<'a> {
    fn lines(&self, section: &str) -> impl Iterator<Item = &'a str> {
        let head = format!("[{section}]");
        let lines = self.0.lines().skip_while(move |line| *line != head).skip(1);
        lines.take_while(|line| !line.starts_with('[')).filter(|line| line.contains(" = ") && !line.starts_with('#'))
    }

    fn line(&self, section: &str, key: &str) -> Option<&'a str> {
        self.lines(section).find(|line| line.split(" =").next() == Some(key))
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
    fn a_manifest_of_the_labs_has_what_the_feature_needs() {
        let root = "[package]\nname = \"k\"\nbuild = \"x.rs\"\n[features]\nlab = [\"dep:toml\"]\ncli = [\"dep:clap\"]\n\n\
            [dependencies]\n# why\nrobust = \"1\" # a\ntoml = { version = \"1\", optional = true } # b\n\
            clap = { version = \"4\", optional = true }\n\n[dev-dependencies]\ntempfile = \"3\"\n";
        let made = KitBuild::Lab.manifest(root);
        assert!(made.contains("[dependencies]\nrobust = \"1\" # a\ntoml = { version = \"1\" } # b\n\n"), "{made}");
        assert!(!made.contains("clap") && !made.contains("tempfile") && !made.contains("x.rs"), "{made}");
        let made = KitBuild::Program.manifest(root);
        assert!(made.contains("clap = { version = \"4\", optional = true }\n") && !made.contains("tempfile"), "{made}");
    }
}
