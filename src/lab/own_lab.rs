//! An instructor's own lab: the folder that `dcel lab new` makes.
//!
//! ```text
//!   12-mine/
//!     README.md  lab.toml  hints/      what students read; what there is to do and what it is worth
//!     src/  solution/  bugs/  tests/   as in the labs of the kit
//!     judge/lib.rs                     the cases, and what is right: one `impl Judge`
//!     program/main.rs                  the program `dcel` with this lab in it
//! ```
//!
//! What it makes is a whole lab that grades rightly: `cargo run -- lab verify 12` in `program/` says so before anything
//! is changed.

use super::files::LabFiles;
use super::markers::starter;
use super::student::Kit;
use std::collections::BTreeMap;

/// The files of the template that are written for it.
const TEMPLATE: &[(&str, &str)] = &[
    ("Cargo.toml", include_str!("template/Cargo.toml.txt")),
    ("README.md", include_str!("template/README.md")),
    ("bugs/01-dangling-twice.toml", include_str!("template/bugs/01-dangling-twice.toml")),
    ("bugs/signatures.toml", include_str!("template/bugs/signatures.toml")),
    ("hints/task-1.md", include_str!("template/hints/task-1.md")),
    ("judge/Cargo.toml", include_str!("template/judge/Cargo.toml.txt")),
    ("judge/lib.rs", include_str!("template/judge/lib.rs")),
    ("lab.toml", include_str!("template/lab.toml")),
    ("program/Cargo.toml", include_str!("template/program/Cargo.toml.txt")),
    ("program/main.rs", include_str!("template/program/main.rs")),
    ("solution/lab.rs", include_str!("template/solution/lab.rs")),
    ("src/calls.rs", include_str!("template/src/calls.rs")),
    ("src/main.rs", include_str!("template/src/main.rs")),
    ("tests/graded.rs", include_str!("template/tests/graded.rs")),
];
/// The lab of the kit that lends its records and starts.
const LENDER: &str = "04-half-edge";
/// What it lends.
const LENT: [&str; 3] = ["src/dcel.rs", "src/records.rs", "src/start.rs"];

/// Why there is no such lab.
#[derive(Clone, PartialEq, Eq, Debug, thiserror::Error)]
#[non_exhaustive]
pub enum NewLabError {
    /// It cannot be called that.
    #[error("`{0}` cannot be a lab; write a number, `-` and small letters: 12-mine")]
    Name(String),
    /// The kit's sources cannot lie inside the folder of an instructor's lab.
    #[error("the lab needs to know where the kit is; write path=FOLDER, git=URL or version=NUMBER")]
    NoKit,
}

/// The files of a new lab with one task, two tests and one known mistake, by their paths in its folder.
///
/// # Errors
/// [`NewLabError`]: the name is not a number, `-` and small letters; the kit is [`Kit::Inside`].
pub fn new_lab(name: &str, kit: &Kit) -> Result<BTreeMap<String, String>, NewLabError> {
    let number = name.split('-').next().unwrap_or_default();
    let is_word = |word: &str| {
        !word.is_empty() && word.bytes().all(|b| b.is_ascii_lowercase() || b.is_ascii_digit() || b == b'-')
    };
    let words = name.get(number.len() + 1..).unwrap_or_default();
    let is_number = !number.is_empty() && number.len() <= 3 && number.bytes().all(|b| b.is_ascii_digit());
    if !is_number || !is_word(words) || words.ends_with('-') {
        return Err(NewLabError::Name(name.to_owned()));
    }
    if *kit == Kit::Inside {
        return Err(NewLabError::NoKit);
    }
    let (lab, program) = (kit.toml("", "src/lab"), kit.toml("", "src/cli"));
    let filled = |text: &str| {
        let text = text.replace("@NAME@", name).replace("@NUMBER@", number);
        text.replace("@KIT:src/lab@", &lab).replace("@KIT:src/cli@", &program)
    };
    let mut files: BTreeMap<String, String> =
        TEMPLATE.iter().map(|(path, text)| ((*path).to_owned(), filled(text))).collect();
    // The template's solution is marked rightly, and the kit has its own lab: tests make a lab and verify it.
    let given = starter(&files["solution/lab.rs"]).unwrap_or_default();
    files.insert("src/lab.rs".to_owned(), given);
    files.insert(".gitignore".to_owned(), "target/\n".to_owned());
    let lender = LabFiles::bundled(LENDER).ok();
    let lent = lender
        .iter()
        .flat_map(LabFiles::iter)
        .filter(|(path, _)| LENT.contains(path) || path.starts_with("src/harness/"));
    files.extend(lent.map(|(path, text)| (path.to_owned(), text.to_owned())));
    Ok(files)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_numbers_and_words() {
        let kit = Kit::Version("0.1".to_owned());
        for name in ["12-mine", "1-a", "120-a-b2"] {
            assert!(new_lab(name, &kit).is_ok(), "{name}");
        }
        for name in ["", "12", "mine", "12-", "12-Mine", "12-a b", "12-a-", "../12-a", "1234-a", "-a", "12-ä", "é"] {
            assert_eq!(new_lab(name, &kit), Err(NewLabError::Name(name.to_owned())));
        }
        assert_eq!(new_lab("12-mine", &Kit::Inside), Err(NewLabError::NoKit));
    }

    #[test]
    fn nothing_is_left_of_the_template_and_the_shared_program_is_there() {
        let files = new_lab("12-mine", &Kit::Path("/a kit".into())).unwrap();
        assert!(
            files.values().all(|text| !text.contains("@NAME") && !text.contains("@NUMBER") && !text.contains("@KIT"))
        );
        assert!(
            files["judge/Cargo.toml"].contains("dcel-lab = { path = \"/a kit/src/lab\", default-features = false }")
        );
        for path in ["src/harness/mod.rs", "src/dcel.rs", "src/records.rs", "src/start.rs", "src/lab.rs"] {
            assert!(files.contains_key(path), "{path}");
        }
        assert!(files["src/lab.rs"].contains("todo!") && !files["src/lab.rs"].contains("SOLUTION"));
    }
}
