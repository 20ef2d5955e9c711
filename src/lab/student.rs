//! The folder in which a student does a lab: what is given, nothing of what is asked for.
//!
//! ```text
//!   my-lab/
//!     README.md  figures/  hints/      the handout, what it shows, help on demand
//!     Cargo.toml Cargo.lock            a workspace of its own, so that it can stand anywhere
//!     lab.toml   answers.md
//!     src/lab.rs                       the file to fill in
//!     src/…      tests/                given
//! ```

use super::files::LabFiles;
use std::collections::BTreeMap;
use std::path::PathBuf;
use std::str::FromStr;

/// Folders of a lab that no student gets.
const KEPT: [&str; 2] = ["solution/", "bugs/"];
/// How a lab in the repository names the kit.
const IN_THE_REPOSITORY: &str = "path = \"../..\"";
/// The versions of all dependencies; cargo drops those that a lab does not need.
const LOCK: &str = include_str!("../../Cargo.lock");

/// Where the tests of a student's folder take the kit from.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Kit {
    /// A checkout on this machine.
    Path(PathBuf),
    /// A repository.
    Git(String),
    /// A published version.
    Version(String),
}

impl Kit {
    /// The checkout that the running kit was built from, or its version if that is gone.
    #[must_use]
    pub fn running() -> Self {
        let checkout = PathBuf::from(env!("CARGO_MANIFEST_DIR"));
        if checkout.join("Cargo.toml").is_file() {
            Self::Path(checkout)
        } else {
            Self::Version(env!("CARGO_PKG_VERSION").to_owned())
        }
    }

    fn toml(&self) -> String {
        match self {
            Self::Path(path) => format!("path = {}", quoted(&path.to_string_lossy())),
            Self::Git(url) => format!("git = {}", quoted(url)),
            Self::Version(version) => format!("version = {}", quoted(version)),
        }
    }
}

/// A kit is written `path=…`, `git=…` or `version=…`.
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

/// The files of a student's folder, by path.
///
/// Cost: linear in their sizes.
#[must_use]
pub fn student_files(lab: &LabFiles, kit: &Kit) -> BTreeMap<String, String> {
    let given = lab.iter().filter(|(path, _)| !KEPT.iter().any(|kept| path.starts_with(kept)));
    let mut files: BTreeMap<String, String> = given.map(|(path, text)| (path.to_owned(), text.to_owned())).collect();
    files.insert("README.md".to_owned(), lab.handout());
    files.insert("Cargo.toml".to_owned(), manifest(lab.get("Cargo.toml").unwrap_or_default(), kit));
    files.insert("Cargo.lock".to_owned(), LOCK.to_owned());
    files.insert(".gitignore".to_owned(), "/target\n".to_owned());
    files
}

/// The lab's manifest as that of a workspace of its own, with the kit from somewhere.
fn manifest(text: &str, kit: &Kit) -> String {
    let mut out = text.replace(IN_THE_REPOSITORY, &kit.toml());
    out.push_str(
        "\n# The tests stay quick when the kit that they use is optimised.\n\
         [profile.dev.package.\"*\"]\nopt-level = 1\n\n\
         # This folder is a workspace of its own, wherever it stands.\n[workspace]\n",
    );
    out
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
            ("path=/a b/\"c\\d\"", r#"path = "/a b/\"c\\d\"""#),
            ("git=https://x.test/a=b", "git = \"https://x.test/a=b\""),
            ("version=0.1", "version = \"0.1\""),
        ] {
            assert_eq!(text.parse::<Kit>().unwrap().toml(), toml);
        }
        for wrong in ["", "path", "path=", "dir=x"] {
            assert!(wrong.parse::<Kit>().is_err(), "{wrong}");
        }
    }

    #[test]
    fn a_student_gets_what_is_given_and_no_more() {
        let lab = LabFiles::bundled("04").unwrap();
        let files = student_files(&lab, &Kit::Version("9.9".to_owned()));
        assert!(files.keys().all(|path| !path.contains("solution") && !path.contains("bugs")));
        assert!(files.values().all(|text| !text.contains("BEGIN SOLUTION")));
        for needed in ["README.md", "src/lab.rs", "src/main.rs", "tests/graded.rs", "lab.toml", "Cargo.lock"] {
            assert!(files.contains_key(needed), "{needed}");
        }
        let manifest: toml::Table = files["Cargo.toml"].parse().unwrap();
        assert_eq!(manifest["dev-dependencies"]["dcel-kit"]["version"].as_str(), Some("9.9"));
        assert_eq!(manifest["dev-dependencies"]["dcel-kit"]["default-features"].as_bool(), Some(false));
        assert!(manifest.contains_key("workspace"));
    }
}
