//! The folder in which a student does a lab: what is given, nothing of what is asked for.
//!
//! ```text
//!   my-lab/
//!     README.md  figures/  hints/      the handout, what it shows, help on demand
//!     Cargo.toml Cargo.lock            a workspace of its own, so that it can stand anywhere
//!     kit/                             the sources that the graded tests are built from
//!     lab.toml   answers.md
//!     src/lab.rs                       the file to fill in
//!     src/…      tests/                given
//! ```

use super::courses::FOLDERS;
use super::files::LabFiles;
use super::kit::{self, KitBuild};
use std::collections::BTreeMap;
use std::path::PathBuf;
use std::str::FromStr;

/// Folders of a lab that no student gets.
const KEPT: [&str; 4] = ["solution/", "bugs/", "program/", "idea.md"];
/// How a lab in the repository names the kit.
const IN_THE_REPOSITORY: &str = "path = \"../../src/lab\"";
/// The judge of a lab that is not one of the kit.
const JUDGE: &str = "judge/Cargo.toml";
/// The lab as it was handed out, beside its judge: what a student changes in given files is not what is judged.
pub(super) const ARCHIVE: &str = "judge/lab.txt";
/// The folder of the kit's sources.
const INSIDE: &str = "kit";
/// The folder of the package that the tests use, in a checkout of the kit.
const PACKAGE: &str = "src/lab";

/// Where the tests of a student's folder take the kit from.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub enum Kit {
    /// Its sources lie in the folder itself: it builds wherever it stands.
    #[default]
    Inside,
    /// A checkout on this machine.
    Path(PathBuf),
    /// A repository.
    Git(String),
    /// A published version.
    Version(String),
}

impl Kit {
    /// How a manifest names a package of the kit, `up` from the student's folder.
    pub(super) fn toml(&self, up: &str, package: &str) -> String {
        match self {
            Self::Inside => format!("path = \"{up}{INSIDE}/{package}\""),
            Self::Path(path) => format!("path = {}", quoted(&path.join(package).to_string_lossy())),
            Self::Git(url) => format!("git = {}", quoted(url)),
            Self::Version(version) => format!("version = {}", quoted(version)),
        }
    }
}

/// A kit that is not inside is written `path=…`, `git=…` or `version=…`.
impl FromStr for Kit {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text.split_once('=') {
            Some((_, "")) => Err("after the `=` comes where the kit is".to_owned()),
            Some(("path", path)) => Ok(Self::Path(path.into())),
            Some(("git", url)) => Ok(Self::Git(url.to_owned())),
            Some(("version", version)) => Ok(Self::Version(version.to_owned())),
            _ => Err("write path=FOLDER, git=URL or version=NUMBER".to_owned()),
        }
    }
}

/// The files of a student's folder, by path. Nothing in them names a place of this machine, unless `kit` does.
///
/// Cost: linear in their sizes.
#[must_use]
pub fn student_files(lab: &LabFiles, kit: &Kit) -> BTreeMap<String, String> {
    let given = lab.iter().filter(|(path, _)| !KEPT.iter().any(|kept| path.starts_with(kept)));
    let mut files: BTreeMap<String, String> = given.map(|(path, text)| (path.to_owned(), text.to_owned())).collect();
    let own = lab.get("Cargo.toml").unwrap_or_default();
    files.insert("README.md".to_owned(), lab.handout());
    files.insert("Cargo.toml".to_owned(), manifest(own, kit));
    files.insert("Cargo.lock".to_owned(), lock(own));
    if let Some(judge) = lab.get(JUDGE) {
        files.insert(JUDGE.to_owned(), judge_manifest(judge, kit));
        files.insert(ARCHIVE.to_owned(), lab.handed_out().to_archive());
    }
    files.insert(".gitignore".to_owned(), "/target\n".to_owned());
    if *kit == Kit::Inside {
        let made = kit::MANIFESTS.map(|(path, text)| (path.to_owned(), text));
        let sources = kit::sources(KitBuild::Check).into_iter().chain(made);
        let sources = sources.filter(|(path, _)| !of_other_lab(path, lab.name()));
        files.extend(sources.map(|(path, text)| (format!("{INSIDE}/{path}"), text.to_owned())));
    }
    files
}

/// Whether a source of the kit judges another lab than this one.
fn of_other_lab(path: &str, lab: &str) -> bool {
    let others = FOLDERS.iter().filter(|(name, _)| *name != lab);
    let mut theirs =
        others.flat_map(|(name, folder)| [format!("src/lab/courses/{folder}/"), format!("src/lab/bundle/{name}.txt")]);
    theirs.any(|begin| path.starts_with(&begin))
}

/// The lab's manifest as that of a workspace of its own, with the kit from somewhere.
fn manifest(text: &str, kit: &Kit) -> String {
    // A lab of an instructor is a workspace with a program that no student gets.
    let text = text.split("\n[workspace]").next().unwrap_or_default().trim_end();
    let mut out = text.replace(IN_THE_REPOSITORY, &kit.toml("", PACKAGE)) + "\n";
    out.push_str(
        "\n# Nobody debugs into what the tests use; without the means to do so it is compiled sooner.\n\
         [profile.dev.package.\"*\"]\ndebug = false\n\n\
         [profile.dev.package.dcel-kit]\ndebug = false\n\n\
         [profile.dev.package.dcel-lab]\ndebug = false\n\n\
         # This folder is a workspace of its own, wherever it stands.\n[workspace]\n",
    );
    out
}

/// The manifest of an own lab's judge, with the kit from somewhere.
fn judge_manifest(text: &str, kit: &Kit) -> String {
    let place = |line: &str| match line.starts_with("dcel-lab = ") {
        true => format!("dcel-lab = {{ {}, default-features = false }}\n", kit.toml("../", PACKAGE)),
        false => format!("{line}\n"),
    };
    text.lines().map(place).collect()
}

/// The versions of everything that the tests are built with.
fn lock(manifest: &str) -> String {
    let table: toml::Table = manifest.parse().unwrap_or_default();
    let word = |key: &str| Some(table.get("package")?.get(key)?.as_str()?.to_owned());
    let [name, version] =
        [("name", 0), ("version", 1)].map(|(key, i)| word(key).unwrap_or_else(|| kit::ANY_LAB[i].to_owned()));
    kit::lock_with(&name, &version)
}

/// A TOML string: the escapes of JSON mean the same there.
fn quoted(text: &str) -> String {
    serde_json::Value::from(text).to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_kit_is_read_and_written() {
        for (text, toml) in [
            ("path=/a b/\"c\\d", r#"path = "/a b/\"c\\d/src/lab""#),
            ("git=https://x.test/a=b", "git = \"https://x.test/a=b\""),
            ("version=0.1", "version = \"0.1\""),
        ] {
            assert_eq!(text.parse::<Kit>().unwrap().toml("", PACKAGE), toml);
        }
        for wrong in ["", "path", "path=", "dir=x"] {
            assert!(wrong.parse::<Kit>().is_err(), "{wrong}");
        }
    }

    #[test]
    fn a_student_gets_what_is_given_and_no_more() {
        let lab = LabFiles::bundled("04").unwrap();
        let files = student_files(&lab, &Kit::Version("9.9".to_owned()));
        assert!(files.keys().all(|path| !path.starts_with("solution/") && !path.starts_with("bugs/")));
        assert!(files.values().all(|text| !text.contains("BEGIN SOLUTION")));
        for needed in ["README.md", "src/lab.rs", "src/main.rs", "tests/graded.rs", "lab.toml", "Cargo.lock"] {
            assert!(files.contains_key(needed), "{needed}");
        }
        let manifest: toml::Table = files["Cargo.toml"].parse().unwrap();
        assert_eq!(manifest["dev-dependencies"]["dcel-lab"]["version"].as_str(), Some("9.9"));
        assert_eq!(manifest["dev-dependencies"]["dcel-lab"]["default-features"].as_bool(), Some(false));
        assert!(manifest.contains_key("workspace"));
        assert!(files.keys().all(|path| !path.starts_with("kit/")));
    }

    #[test]
    fn a_students_folder_needs_nothing_outside_of_it() {
        let files = student_files(&LabFiles::bundled("04").unwrap(), &Kit::default());
        for needed in ["kit/Cargo.toml", "kit/src/lib.rs", "kit/src/lab/submission/scan.rs", "kit/src/lab/Cargo.toml"] {
            assert!(files.contains_key(needed), "{needed}");
        }
        // Neither a place of this machine nor one beside the folder.
        let here = env!("CARGO_MANIFEST_DIR").strip_suffix(PACKAGE).unwrap();
        for (path, text) in &files {
            assert!(!text.contains(here), "{path} names the checkout");
        }
        let manifest: toml::Table = files["Cargo.toml"].parse().unwrap();
        assert_eq!(manifest["dev-dependencies"]["dcel-lab"]["path"].as_str(), Some("kit/src/lab"));
        let lock: toml::Table = files["Cargo.lock"].parse().unwrap();
        let packages = lock["package"].as_array().unwrap();
        let has = |name: &str| packages.iter().any(|package| package["name"].as_str() == Some(name));
        assert!(
            has("lab-04-half-edge") && has("dcel-kit") && has("dcel-lab") && has("toml") && !has("clap"),
            "{packages:?}"
        );
    }
}
