//! The grid: every cell knows the edges through it and the face at its corner.
//!
//! ```text
//!     ┌──────────╲─────┐      From p straight down: the first edge met inside the cell gives the face: it lies above
//!     │   p       ╲    │      that edge. If none is met: left along the bottom of the cell; the first edge met
//!     │   │    ────╲───┼      there tells the face, it lies right of that edge. If none is met, p lies in the face
//!     │   │         ╲  │      at the corner c.
//!     c<──┘          ╲─┘
//! ```
//!
//! All of it is decided by signs of [`orientation`]. Ties are broken as if the way down ran an infinitesimal to the
//! right of p, and the bottom lay a (greater) infinitesimal lower than it does: see `order.rs`.
//!
//! Rounding: corners are pulled to the lower left, and edges are listed in every cell that they pass within a margin of.

use super::Location;
use super::bands::Bands;
use super::frame::Frame;
use super::lines::{Lines, TAG};
use super::lists;
use crate::ids::{FaceId, HalfEdgeId, VertexId};
use crate::plane::Point;

/// A grid over edges that do not cross, and isolated vertices.
#[derive(Clone, Debug)]
pub(crate) struct Cells {
    frame: Frame,
    outer: FaceId,
    bands: Bands,
}

impl Cells {
    /// The grid over the edges, each by one of its halves, and the isolated vertices, with about `density` cells for
    /// each of them.
    ///
    /// Cost: O(n) while cells are not crowded, O(n log n) expected for whatever is crowded.
    pub(crate) fn new(
        lines: &impl Lines,
        edges: impl Iterator<Item = HalfEdgeId>,
        isolated: impl Iterator<Item = VertexId>,
        outer: FaceId,
        density: f64,
    ) -> Self {
        let words = edges.map(HalfEdgeId::number).chain(isolated.map(|v| v.number() | TAG));
        let (frame, bands) = Bands::filled(lines, words, outer, density);
        Self { frame, outer, bands }
    }

    /// Where the point lies; edges by their halves from left to right.
    #[inline]
    pub(crate) fn locate(&self, lines: &impl Lines, p: Point) -> Location {
        let Some(place) = self.frame.place_of(p) else { return Location::Face(self.outer) };
        let (band, cell) = self.bands.at(&self.frame, place);
        let found = match band.of(cell) {
            Ok([]) => None,
            Ok(list) => lists::locate(lines, list, self.frame.corner(place), p),
            Err(crowd) => band.crowds.locate(lines, crowd, self.frame.corner(place).y, p),
        };
        found.unwrap_or(Location::Face(band.corner_face(cell)))
    }

    /// The cell of a point, to ask for points of one cell together; points outside come last.
    pub(crate) fn cell_of(&self, p: Point) -> usize {
        self.frame.place_of(p).map_or(self.frame.count(), |place| self.frame.number(place))
    }

    /// The number of cells.
    pub(crate) fn count(&self) -> usize {
        self.frame.count()
    }

    /// The most edges that one query looks at.
    pub(crate) fn worst_case(&self) -> usize {
        self.bands.worst()
    }

    /// The bytes of all arrays.
    pub(crate) fn memory_bytes(&self) -> usize {
        self.bands.memory_bytes()
    }
}
