//! Edits in several steps, done whole or not at all.
//!
//! ```text
//!   before ── step ── step ── refused        The steps are written into a journal of their own. If one is refused,
//!     ^                          │           the journal takes the links back and the rest is put back from a copy.
//!     └────────── undo ──────────┘           If all succeed, the caller's recorder gets the journal.
//! ```

use crate::plane::Subdivision;
use crate::topology::{Journal, Recorder};

impl Subdivision {
    /// Runs `edit`; if it fails, everything is bit for bit as before. Copies rings and hole flags, and if any vertex
    /// was removed before, positions.
    pub(crate) fn all_or_nothing<T, E>(
        &mut self,
        rec: &mut impl Recorder,
        edit: impl FnOnce(&mut Self, &mut Journal) -> Result<T, E>,
    ) -> Result<T, E> {
        let mut journal = Journal::new();
        let (rings, holes, bound) = (self.rings.clone(), self.holes.clone(), self.points.len());
        let reused = self.dcel.vertex_count() < self.dcel.vertex_bound();
        let points = reused.then(|| self.points.clone());
        let result = edit(self, &mut journal);
        if result.is_ok() {
            let mut steps = journal.steps().iter().peekable();
            for (i, &change) in journal.changes().iter().enumerate() {
                while let Some(step) = steps.next_if(|step| step.start <= i) {
                    rec.step(step.number, step.what);
                }
                rec.record(change);
            }
        } else {
            self.dcel.undo(&mut journal, 0);
            (self.rings, self.holes) = (rings, holes);
            match points {
                Some(points) => self.points = points,
                None => self.points.truncate(bound),
            }
        }
        result
    }
}
