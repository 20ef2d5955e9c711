//! The table of edits: one row for each, and everything else follows from the row.
//!
//! ```text
//!   rows.rs    split_face (a: half_edge, b: half_edge) -> [half_edge, face]     one help sentence
//!                │ kernel: d.split_face_with(a, b, log)
//!                └ plane:  s.split_face_with(a, b, log)
//!
//!   from it:   words of scripts and their checks, scripts printed back, answers in JSON, films, help, this page
//! ```
//!
//! A [`Row`] says the word of an edit, what it takes, what it gives back, how each structure makes it, and one sentence
//! of help. The rows of the kit are in [`rows`], all of them in [`TABLE`]. A [`Call`] is a row with its arguments.
//!
//! One word may take more in one structure than in another: a *place* is `X Y` in the plane, `X Y Z` in space, and
//! nothing in the kernel, which knows no coordinates.
//!
//! **A new edit** of the kit is a method on its structure, and a row here. Tried with `halve_face` for surfaces in space
//! (the middle of an edge joined to a corner), it was
//!
//! ```text
//!   src/solid/local/halve_face.rs    the method, with its docs and, if it has one of its own, its error     (new)
//!   src/solid/local/mod.rs           the name of that file
//!   src/edits/rows.rs                the row: word, arguments, results, one sentence of help
//!   tests/kernel/missing_ids.rs      what it says of an id that does not exist
//! ```
//!
//! An error of its own is named in `src/solid/mod.rs`, too. With that it is a word of scripts with its checks and its line
//! of help, in JSON, printed back, undone, in films, and tried by the tests that go through the table. One outside the kit
//! is a row, too: see [`Row::new`].
//!
//! ```text
//!   kind.rs       kinds of elements      arguments.rs  what a call is made with    returned.rs  its result or refusal
//!   row.rs        what a row says        structure.rs  what edits are made on      rows.rs      the table
//!   call.rs       a row with its arguments
//! ```
//!
//! ```
//! use dcel_kit::edits::{Call, rows};
//! use dcel_kit::plane::{PlaneJournal, Subdivision};
//! use dcel_kit::HalfEdgeId;
//! let [h2, h8] = [2, 8].map(HalfEdgeId::new);
//! let call = Call::<Subdivision>::new(&rows::split_face, [h2.into(), h8.into()])?;
//! assert_eq!(call, "split_face h2 h8".parse()?);
//! let (mut lab, mut log) = (Subdivision::lab_rectangle(), PlaneJournal::new());
//! assert_eq!(call.apply(&mut lab, &mut log)?.to_string(), "h12, f2");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod arguments;
mod call;
mod kind;
mod returned;
mod row;
pub mod rows;
mod structure;

pub use arguments::{Argument, Arguments, Map, Place};
pub use call::{Call, CallError};
pub(crate) use call::{element, switch};
pub use kind::{Given, Kind, Parameter, Takes};
pub use returned::{EditError, Returned, Returns};
pub use row::{Apply, Row};
pub use rows::TABLE;
pub use structure::Editable;

use crate::old_words::{Language, OldWord};

/// The rows of the edits that this structure has, in the order of the table.
pub fn rows_of<S: Editable>() -> impl Iterator<Item = &'static Row> {
    TABLE.iter().copied().filter(|row| S::column(row).is_some())
}

/// The row with this word, if the structure has such an edit.
#[must_use]
pub fn find<S: Editable>(word: &str) -> Option<&'static Row> {
    let word = OldWord::current(Language::Script, word);
    rows_of::<S>().find(|row| row.word == word)
}

/// One line for each edit of the structure: how it is written, and what it does.
///
/// ```
/// let help = dcel_kit::edits::help::<dcel_kit::topology::Dcel>();
/// assert!(help.starts_with("  split_face A B           Split a face"), "{help}");
/// ```
#[must_use]
pub fn help<S: Editable>() -> String {
    let lines = rows_of::<S>().map(|row| format!("  {:<23}  {}\n", row.usage::<S>(), row.help));
    lines.collect()
}
