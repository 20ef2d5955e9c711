//! Dead ends: faces through which no way leads anywhere but back.
//!
//! ```text
//!   ┌───┬───┬───┐        A face with one open side is entered only by who starts or ends in it. Take such faces
//!   │ ✕ │ ✕ │ · │        away, and again those that have one open side left, until there is none: what stays lies on
//!   └───┴───┼───┤        a round trip, or between two. From a dead end, portal after portal leads there.
//!           │ · │ ..
//! ```
//!
//! A search enters dead ends on the portals of its start and its goal only, and loses nothing. A component without any
//! round trip is peeled down to one face.
//!
//! Source: Demyen and Buro, *Efficient triangulation-based pathfinding*, AAAI 2006 (the tree parts of TRA*).

use super::marks::{CLOSED, DEAD_END, ID};
use super::mesh::NavMesh;
use crate::ids::FaceId;

impl NavMesh {
    /// Whether `f` leads nowhere but back. O(1).
    #[must_use]
    pub fn is_dead_end(&self, f: FaceId) -> bool {
        self.is_peeled(f.number())
    }

    /// The neighbour through which a dead end is left; `None` if `f` is none. O(sides of f).
    #[must_use]
    pub fn portal(&self, f: FaceId) -> Option<FaceId> {
        if !self.is_peeled(f.number()) {
            return None;
        }
        let mut open = self.sides_of(f).iter().filter(|side| side.across & (CLOSED | DEAD_END) == 0);
        open.next().map(|side| FaceId::new(side.across & ID))
    }

    /// The faces from `f` on, through portal after portal, to the first one that is no dead end; `f` is among them.
    pub fn portal_path(&self, f: FaceId) -> impl Iterator<Item = FaceId> + Clone + '_ {
        std::iter::successors(Some(f), |&f| self.portal(f))
    }

    /// Finds all dead ends anew. O(n).
    pub(super) fn peel_all(&mut self) {
        let mut ends: Vec<u32> = (0..self.faces.len() as u32).collect();
        self.peel(&mut ends);
    }

    /// Peels those of the faces that have one way out, and whatever gets only one by that. `ends` must have every
    /// face that may have one now.
    pub(super) fn peel(&mut self, ends: &mut Vec<u32>) {
        while let Some(f) = ends.pop() {
            self.visited += 1;
            if self.is_peeled(f) {
                continue;
            }
            let mut ways_out =
                self.sides_of(FaceId::new(f)).iter().filter(|side| side.across & (CLOSED | DEAD_END) == 0);
            let (Some(only), None) = (ways_out.next(), ways_out.next()) else { continue };
            let next = only.across;
            self.set_peeled(f, true);
            self.mark_dead_end(next, f, true);
            ends.push(next);
        }
    }

    /// Says on the open side from `f` to `behind` whether a dead end lies behind.
    pub(super) fn mark_dead_end(&mut self, f: u32, behind: u32, dead: bool) {
        self.note_written(f);
        for s in self.range(FaceId::new(f)) {
            let across = &mut self.sides[s].across;
            if *across & CLOSED == 0 && *across & ID == behind {
                *across = behind | if dead { DEAD_END } else { 0 };
            }
        }
    }
}
