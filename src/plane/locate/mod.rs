//! Where a point lies: on a vertex, on an edge, or in a face. Always exact, for every subdivision.
//!
//! ```text
//!   scan.rs    a look at everything: O(n), nothing to go wrong         the answer the others are tested against
//!   walk.rs    from a vertex towards the point, face by face           nothing to prepare; changes are welcome
//!   index.rs   a grid made once, for very many points; order.rs breaks its ties
//!               lines.rs what lies in it   frame.rs where cells lie   bands.rs how they are filled
//!               lists.rs few edges in a cell   crowd.rs many   cells.rs the whole
//! ```
//!
//! All of them give the same answer. Points that do not pass [`Point::check`] get an answer, too, but where they are
//! closer to 0 than that allows it need not be exact; what is not a number, or infinite, lies in `f0`.

mod bands;
mod cells;
mod crowd;
mod frame;
mod index;
mod lines;
mod lists;
mod order;
mod scan;
mod walk;

pub(crate) use cells::Cells;
pub use index::PointIndex;
pub(crate) use lines::Lines;
pub use walk::{Walk, WalkEvent};

use super::{LARGEST, Point, Subdivision};
use crate::ids::{Element, FaceId, HalfEdgeId, VertexId};
use std::fmt;

/// Where a point lies. A point on an edge lies in no face, and a point on a vertex on no edge.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Location {
    /// On the vertex.
    Vertex(VertexId),
    /// Inside the edge, which is given by its half from left to right, or from bottom to top if it is vertical. So
    /// the face of the half-edge is the one above, or on the left.
    Edge(HalfEdgeId),
    /// Inside the face.
    Face(FaceId),
}

impl Location {
    /// The element, as messages name it.
    #[must_use]
    pub fn element(self) -> Element {
        match self {
            Self::Vertex(v) => v.into(),
            Self::Edge(h) => h.into(),
            Self::Face(f) => f.into(),
        }
    }
}

impl fmt::Display for Location {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.element().fmt(f)
    }
}

/// Whether the point is further out than any vertex can be, or no point at all.
fn is_beyond(p: Point) -> bool {
    !(p.x.abs() <= LARGEST && p.y.abs() <= LARGEST)
}

impl Subdivision {
    /// Where the point lies: the vertex there, else the edge through it, else the face around it.
    ///
    /// It jumps to the nearest of about n^(1/3) vertices and walks from there. For many points make a [`PointIndex`],
    /// or ask for [all of them at once](Self::locate_all).
    ///
    /// Cost: exact; O(n^(1/3)) expected for a triangulation of random points, in general O(size of the faces on the
    /// way), each of which is looked at once: never more than O(n).
    ///
    /// Source: Mücke, Saias, Zhu, *Fast randomized point location without preprocessing*, 1999.
    ///
    /// ```
    /// use dcel_kit::{FaceId, HalfEdgeId, VertexId, plane::{Location, Point, Subdivision}};
    /// let s = Subdivision::lab_rectangle();
    /// assert_eq!(s.locate(Point::new(10.0, 20.0)), Location::Face(FaceId::new(1)));
    /// assert_eq!(s.locate(Point::new(0.0, -150.0)), Location::Vertex(VertexId::new(1)));
    /// assert_eq!(s.locate(Point::new(100.0, 150.0)), Location::Edge(HalfEdgeId::new(7)));
    /// ```
    #[must_use]
    pub fn locate(&self, p: Point) -> Location {
        self.jump_and_walk(p)
    }

    /// Where each of the points lies, by a [`PointIndex`] made for them and asked cell by cell.
    ///
    /// Cost: that of the index, and O((n + k) log (n + k)) for k points; exact.
    #[must_use]
    pub fn locate_all(&self, points: &[Point]) -> Vec<Location> {
        PointIndex::new(self).locate_all(points)
    }
}
