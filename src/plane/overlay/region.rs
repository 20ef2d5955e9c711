//! Regions of an overlay: sets of its faces, as subdivisions of their own.
//!
//! ```text
//!   ┌─────┐                ┌─────┐            ┌─────┐         What is not in the region becomes part of f0, or a
//!   │  ┌──┼──┐   union     │  ┌──┼──┐         │     └──┐      hole face if the region surrounds it.
//!   └──┼──┘  │   ────>     └──┼──┘  │         └──┐     │
//!      └─────┘                └─────┘            └─────┘
//!                          Parts::Kept         Parts::Joined
//! ```

use super::Overlay;
use crate::geometry::both::of_both;
use crate::ids::{EdgeId, FaceId, FaceMap, must_be_below};
use crate::plane::{SegmentsError, Subdivision};
use std::str::FromStr;

crate::named! {
    /// What to make of two regions. The region of a subdivision is all its bounded faces but the hole faces.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    pub enum Operation {
        /// What is in a or in b.
        Union = "union",
        /// What is in a and in b.
        Intersection = "intersection",
        /// What is in a and not in b.
        Difference = "difference",
        /// What is in a or in b, but not in both.
        SymmetricDifference = "xor",
    }

    /// `union`, `intersection`, `difference`, `xor`.
    fn name as Display;
    /// All four.
    const ALL;
}

/// What becomes of edges with the region on both sides.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Parts {
    /// They stay, so that the region consists of the faces of the overlay.
    #[default]
    Kept,
    /// They go, and the faces at them are joined. Vertices on the outline stay, also where it runs straight on.
    Joined,
}

impl Operation {
    /// Whether a point belongs to the result, if it is known whether it is in a and in b.
    #[must_use]
    pub fn holds(self, in_a: bool, in_b: bool) -> bool {
        match self {
            Self::Union => in_a || in_b,
            Self::Intersection => in_a && in_b,
            Self::Difference => in_a && !in_b,
            Self::SymmetricDifference => in_a != in_b,
        }
    }
}

/// The text is not the name of an operation.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("`{text}` is not an operation: union, intersection, difference or xor")]
pub struct ParseOperationError {
    text: String,
}

impl FromStr for Operation {
    type Err = ParseOperationError;

    fn from_str(text: &str) -> Result<Self, ParseOperationError> {
        let named = Self::ALL.into_iter().find(|operation| operation.name() == text);
        named.ok_or_else(|| ParseOperationError { text: text.to_owned() })
    }
}

impl Overlay {
    /// Whether a face of the overlay lies in the region of a, and whether in that of b.
    ///
    /// # Panics
    /// If there is no such face: `there is no f99: there are 4 faces`.
    #[must_use]
    #[track_caller]
    pub fn is_in(&self, f: FaceId) -> [bool; 2] {
        must_be_below(f, f.index(), self.face_of_a.len());
        self.regions_at([self.face_of_a[f], self.face_of_b[f]])
    }

    /// Whether a face of a lies in the region of a, and a face of b in that of b.
    pub(super) fn regions_at(&self, [of_a, of_b]: [FaceId; 2]) -> [bool; 2] {
        let outer = self.subdivision.outer_face();
        let within = |label: FaceId, holes: &[FaceId]| label != outer && holes.binary_search(&label).is_err();
        [within(of_a, &self.holes[0]), within(of_b, &self.holes[1])]
    }

    /// The union, intersection, difference or symmetric difference of the regions of a and b.
    ///
    /// Bounded faces outside the result are hole faces. Vertices are those at edges that stay, in their order. The faces
    /// and edges of [`subdivision`](Overlay::subdivision) must still be those that the overlay made.
    ///
    /// Cost: O(n), apart from the order of the inner components; nothing is arranged again.
    ///
    /// # Errors
    /// [`SegmentsError::TooMany`], which cannot be: the result has no more elements than the overlay.
    pub fn region(&self, operation: Operation, parts: Parts) -> Result<Subdivision, SegmentsError> {
        self.region_where(parts, |f| {
            let [in_a, in_b] = self.is_in(f);
            operation.holds(in_a, in_b)
        })
    }

    /// The region of the bounded faces for which `inside` holds.
    ///
    /// ```
    /// # use dcel_kit::plane::{Parts, Point, Subdivision};
    /// # let c = [(0., 0.), (2., 0.), (2., 2.), (0., 2.)].map(Point::from);
    /// # let s = Subdivision::from_graph(&c, &[[0, 1], [1, 2], [2, 3], [3, 0]])?;
    /// let both = s.overlay(&s)?;
    /// // Wherever a and b have the same face.
    /// let same = both.region_where(Parts::Kept, |f| both.face_of_a[f] == both.face_of_b[f])?;
    /// assert_eq!(same.face_count(), 2);
    /// # Ok::<(), dcel_kit::plane::SegmentsError>(())
    /// ```
    ///
    /// # Errors
    /// As for [`region`](Self::region).
    pub fn region_where(&self, parts: Parts, inside: impl Fn(FaceId) -> bool) -> Result<Subdivision, SegmentsError> {
        let s = &self.subdivision;
        let mut chosen = FaceMap::filled(s.dcel.face_bound(), false);
        for f in s.dcel.faces().filter(|&f| f != s.outer_face()) {
            chosen[f] = inside(f);
        }
        let stays = |e: &EdgeId| {
            let [left, right] = of_both(e.half_edges(), |h| chosen[s.dcel.face(h)]);
            left != right || (left && parts == Parts::Kept)
        };
        let edges: Vec<EdgeId> = s.dcel.edges().filter(stays).collect();
        let mut region = s.part(&edges)?;
        // Half-edges of edge i run as those of edges[i]; faces at dropped edges are all inside, or all outside.
        let is_hole = |&f: &FaceId| {
            let old = |h: crate::HalfEdgeId| edges[h.edge().index()].half_edges()[h.index() & 1];
            region.dcel.half_edge(f).is_some_and(|h| !chosen[s.dcel.face(old(h))])
        };
        region.holes = region.dcel.faces().filter(|&f| f != region.outer_face()).filter(is_hole).collect();
        Ok(region)
    }
}
