//! Edits in several steps, done whole or not at all.
//!
//! ```text
//!   before ── step ── step ── refused        The steps are written into a journal of their own, and what a plane has
//!     ^                          │           beside the links (positions, rings, holes) into a list of old values. If one
//!     └────────── undo ──────────┘           is refused, both are taken back. If all succeed, the caller's recorder
//!                                            gets the journal.
//! ```

use crate::ids::{FaceId, VertexId};
use crate::plane::{Point, Subdivision};
use crate::topology::{Journal, Recorder, Ring};

/// Old values of what an edit in several steps has changed, the newest last. Empty while no such edit is under way.
#[derive(Clone, PartialEq, Debug, Default)]
pub(in crate::plane) struct OldValues {
    /// How many such edits are under way, one inside the other.
    depth: usize,
    values: Vec<OldValue>,
}

#[derive(Clone, PartialEq, Debug)]
enum OldValue {
    /// `None`: there was no place for such a vertex.
    Point(VertexId, Option<Point>),
    Rings(FaceId, Option<Vec<Ring>>),
    Hole(FaceId, bool),
}

impl Subdivision {
    /// Runs `edit`; if it fails, everything is bit for bit as before. What `edit` writes beside the links it has to
    /// write through [`put_point`](Self::put_point), [`put_hole`](Self::put_hole), and after
    /// [`keep_rings`](Self::keep_rings), as all edits of this folder do.
    ///
    /// Cost: that of `edit`, and O(number of its changes).
    pub(crate) fn all_or_nothing<T, E>(
        &mut self,
        rec: &mut impl Recorder,
        edit: impl FnOnce(&mut Self, &mut Journal) -> Result<T, E>,
    ) -> Result<T, E> {
        let mut journal = Journal::new();
        let begin = self.old.values.len();
        self.old.depth += 1;
        let result = edit(self, &mut journal);
        self.old.depth -= 1;
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
            while self.old.values.len() > begin {
                match self.old.values.pop() {
                    Some(OldValue::Point(v, Some(point))) => self.points[v] = point,
                    Some(OldValue::Point(v, None)) => self.points.truncate(v.index()),
                    Some(OldValue::Rings(f, Some(rings))) => drop(self.rings.insert(f, rings)),
                    Some(OldValue::Rings(f, None)) => drop(self.rings.remove(&f)),
                    Some(OldValue::Hole(f, true)) => drop(self.holes.insert(f)),
                    Some(OldValue::Hole(f, false)) => drop(self.holes.remove(&f)),
                    None => {}
                }
            }
        }
        if self.old.depth == 0 {
            self.old.values = Vec::new();
        }
        result
    }

    /// Writes a position.
    pub(in crate::plane) fn put_point(&mut self, v: VertexId, point: Point) {
        if self.old.depth > 0 {
            self.old.values.push(OldValue::Point(v, self.points.get(v).copied()));
        }
        self.points.set(v, point, Point::default());
    }

    /// Says whether a face is a hole; returns whether it was one.
    pub(in crate::plane) fn put_hole(&mut self, f: FaceId, hole: bool) -> bool {
        let before = if hole { !self.holes.insert(f) } else { self.holes.remove(&f) };
        if self.old.depth > 0 && before != hole {
            self.old.values.push(OldValue::Hole(f, before));
        }
        before
    }

    /// The rings of a face are going to change.
    pub(in crate::plane) fn keep_rings(&mut self, f: FaceId) {
        if self.old.depth > 0 {
            self.old.values.push(OldValue::Rings(f, self.rings.get(&f).cloned()));
        }
    }
}
