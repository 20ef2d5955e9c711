//! The known mistakes of a lab: wrong solutions with a name, each a small change of the right one.
//!
//! ```toml
//!   number = 35
//!   title = "the new face does not know a half-edge (step 5)"
//!   task = 5
//!   section = "Splitting a face"
//!   same_as = [12]        # bugs that fail in the same way, whatever is tried
//!
//!   [[edit]]
//!   find = "what stands in the solution, once"
//!   replace = "what is wrong"
//! ```

use super::toml_file::{ManifestError, TomlFile};
use serde::Deserialize;
use toml::Spanned;

/// A wrong solution, and what is wrong with it.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Bug {
    /// Its number, that of its file.
    pub number: u32,
    /// What the student reads after "Same failures as:".
    pub title: String,
    /// The task that it belongs to.
    pub task: u32,
    /// The section of the handout that explains it.
    pub section: String,
    /// The numbers of the bugs that cannot be told from it.
    pub same_as: Vec<u32>,
    /// What makes it of the solution, in order; none where only its name is known, as in the program.
    pub edits: Vec<Edit>,
}

/// A replacement in the solution.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Edit {
    /// What is replaced. It stands in the text exactly once.
    pub find: String,
    /// What it is replaced by.
    pub replace: String,
    /// Where this stands: `bugs/35-no-half-edge.toml:7:8`.
    pub place: String,
}

/// Why a bug does not fit the solution.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum BugError {
    /// The text to replace is not there, or more than once.
    #[error("{place}: {find:?} stands {times} times in the solution; copy lines of it that stand there exactly once")]
    NotOnce {
        /// Where it stands in the file of the bug.
        place: String,
        /// The text.
        find: String,
        /// How often it is there.
        times: usize,
    },
    /// Only its name is known.
    #[error("bug {number} has no text here: read it from the lab's folder in a checkout")]
    NameOnly {
        /// The bug.
        number: u32,
    },
    /// A replacement changes nothing.
    #[error("{place}: {find:?} is replaced by itself; write in `replace` what is wrong")]
    NoChange {
        /// Where it stands in the file of the bug.
        place: String,
        /// The text.
        find: String,
    },
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    number: u32,
    title: String,
    task: u32,
    section: String,
    same_as: Option<Spanned<Vec<u32>>>,
    edit: Option<Spanned<Vec<EditTable>>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct EditTable {
    find: Spanned<String>,
    replace: String,
}

impl Bug {
    /// Reads a bug; `source` is the name of the file in messages. Cost: linear.
    ///
    /// # Errors
    /// [`ManifestError`] with line and column.
    pub fn parse(text: &str, source: &str) -> Result<Self, ManifestError> {
        let toml = TomlFile { text, source };
        let File { number, title, task, section, same_as, edit } = toml.read()?;
        if let Some(edit) = edit.as_ref().filter(|edit| edit.get_ref().is_empty()) {
            return Err(toml.error(edit.span().start, "a bug without an edit is the solution; add an [[edit]]"));
        }
        if let Some(same_as) = same_as.as_ref().filter(|list| list.get_ref().contains(&number)) {
            return Err(toml.error(same_as.span().start, "a bug is the same as itself; name the other one"));
        }
        let same_as = same_as.map_or_else(Vec::new, Spanned::into_inner);
        let edits = edit.map_or_else(Vec::new, Spanned::into_inner).into_iter().map(|EditTable { find, replace }| {
            let ManifestError { source, line, column, .. } = toml.error(find.span().start, "");
            Edit { find: find.into_inner(), replace, place: format!("{source}:{line}:{column}") }
        });
        Ok(Self { number, title, task, section, same_as, edits: edits.collect() })
    }

    /// The wrong solution. Cost: linear for each edit.
    ///
    /// # Errors
    /// [`BugError`] if it has no edit, or if an edit does not find its text exactly once, or changes nothing.
    pub fn apply(&self, solution: &str) -> Result<String, BugError> {
        if self.edits.is_empty() {
            return Err(BugError::NameOnly { number: self.number });
        }
        let mut text = solution.to_owned();
        for Edit { find, replace, place } in &self.edits {
            let (place, find) = (place.clone(), find.clone());
            if &find == replace {
                return Err(BugError::NoChange { place, find });
            }
            let times = text.matches(&find).count();
            if times != 1 {
                return Err(BugError::NotOnce { place, find, times });
            }
            text = text.replacen(&find, replace, 1);
        }
        Ok(text)
    }
}
