//! Edits in several steps, done whole or not at all.
//!
//! ```text
//!   before ── step ── step ── refused        The steps are written into a journal of their own. If one is refused,
//!     ^                          │           the journal takes everything back.
//!     └────────── undo ──────────┘           If all succeed, the caller's recorder gets the journal.
//! ```

use crate::plane::{PlaneJournal, PlaneRecorder, Subdivision};

impl Subdivision {
    /// Runs `edit`; if it fails, everything is bit for bit as before. Cost: that of the edit.
    pub(crate) fn all_or_nothing<T, E>(
        &mut self,
        rec: &mut impl PlaneRecorder,
        edit: impl FnOnce(&mut Self, &mut PlaneJournal) -> Result<T, E>,
    ) -> Result<T, E> {
        let mut journal = PlaneJournal::new();
        let result = edit(self, &mut journal);
        if result.is_ok() {
            journal.replay(rec, |rec, change| rec.plane(|| change));
        } else {
            self.undo(&mut journal, 0);
        }
        result
    }
}
