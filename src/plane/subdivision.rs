//! A subdivision of the plane: a [`Dcel`] with positions, whose faces cover the whole plane.
//!
//! ```text
//!   ┌─────────────────────┐   f0      f0, the outer face, is unbounded and always there.
//!   │ f1    ┌────┐        │           y points up; the face of a half-edge is on its LEFT; bounded faces
//!   │       │ f2 │    ·v8 │           run counter-clockwise, the cycles of the outer face clockwise.
//!   │       └────┘        │
//!   └─────────────────────┘           f1 has its boundary and two inner components: the cycle round f2, and v8.
//! ```
//!
//! *Inner component* = a further cycle of a face, or an isolated vertex in it. All cycles of `f0` are inner components
//! of the plane; `half_edge(f0)` is the first of them and the others are listed as its inner components. *Hole face* =
//! a bounded face that is not part of the domain.
//!
//! Source: de Berg et al., *Computational Geometry*, 3rd ed., section 2.2 (OuterComponent, InnerComponents).

use super::Point;
use crate::ids::{FaceId, HalfEdgeId, VertexId, VertexMap};
use crate::topology::{Dcel, InnerComponent, View};
use std::collections::{BTreeMap, BTreeSet};

/// A view whose vertices have positions.
pub trait PlanarView: View {
    /// Where `v` is; `None` if `v` does not exist or has no position.
    fn position(&self, v: VertexId) -> Option<Point>;
}

/// A planar subdivision: faces that cover the whole plane.
///
/// It has the walks and counts of a [`Dcel`], and edits of its own, which keep edges straight and disjoint. Edits that
/// only the kernel has are no methods of it; [`topology`](Self::topology) gives the structure to all that reads one.
///
/// ```compile_fail,E0599
/// use dcel_kit::{HalfEdgeId, plane::Subdivision};
/// let mut lab = Subdivision::lab_rectangle();
/// let _ = lab.split_vertex(HalfEdgeId::new(0), HalfEdgeId::new(0)); // where would the new vertex be?
/// ```
///
#[doc = include_str!("../../figures/rings.svg")]
///
/// `f1` has its boundary, through h0, and two inner components, through h8 and h16; `f4` and `f5` are hole faces, and `f4` has
/// an inner component round the island `f2`. `f0` has two cycles.
#[derive(Clone, PartialEq, Debug)]
pub struct Subdivision {
    pub(super) dcel: Dcel,
    pub(super) points: VertexMap<Point>,
    /// Only faces that have inner components are here, so that a simple face pays nothing.
    pub(super) inner_components: BTreeMap<FaceId, Vec<InnerComponent>>,
    pub(super) holes: BTreeSet<FaceId>,
}

impl Subdivision {
    crate::topology::reads_of_dcel!(dcel);

    /// The unbounded face: always `f0`.
    #[must_use]
    pub const fn outer_face(&self) -> FaceId {
        FaceId::new(0)
    }

    /// The structure without its positions.
    #[must_use]
    pub fn topology(&self) -> &Dcel {
        &self.dcel
    }

    /// Where the vertices are, by number; of removed ones, where they were.
    #[cfg(feature = "io")]
    pub(crate) fn points_by_number(&self) -> &[Point] {
        self.points.as_slice()
    }

    /// Where `v` is. O(1).
    ///
    /// # Panics
    /// If `v` was never allocated: `there is no v99: there are 5 vertices`.
    #[must_use]
    #[inline]
    #[track_caller]
    pub fn point(&self, v: VertexId) -> Point {
        match self.points.get(v) {
            Some(&point) => {
                self.dcel.debug_assert_not_removed(v);
                point
            }
            None => self.dcel.no_such(v),
        }
    }

    /// The cycles of `f` beside its boundary, and the isolated vertices in it.
    #[must_use]
    #[track_caller]
    pub fn inner_components(&self, f: FaceId) -> &[InnerComponent] {
        self.dcel.debug_assert_not_removed(f);
        self.known_inner_components(f)
    }

    fn known_inner_components(&self, f: FaceId) -> &[InnerComponent] {
        self.inner_components.get(&f).map_or(&[], Vec::as_slice)
    }

    /// One half-edge of every boundary cycle of `f`: `half_edge(f)` first, then the inner components.
    pub fn cycles(&self, f: FaceId) -> impl Iterator<Item = HalfEdgeId> + Clone + '_ {
        let rings = self.inner_components(f).iter().filter_map(|ring| ring.cycle());
        self.dcel.half_edge(f).into_iter().chain(rings)
    }

    /// Whether `f` is a bounded face outside the domain: a hole face.
    #[must_use]
    #[track_caller]
    pub fn is_hole(&self, f: FaceId) -> bool {
        self.dcel.debug_assert_not_removed(f);
        self.holes.contains(&f)
    }

    /// The hole faces in the order of their numbers.
    pub fn hole_faces(&self) -> impl Iterator<Item = FaceId> + '_ {
        self.holes.iter().copied()
    }
}

impl View for Subdivision {
    crate::topology::pointers_of_dcel!(dcel);

    fn inner_components(&self, f: FaceId) -> &[InnerComponent] {
        self.known_inner_components(f)
    }
    fn outer_face(&self) -> Option<FaceId> {
        Some(self.outer_face())
    }
    fn is_hole(&self, f: FaceId) -> bool {
        self.holes.contains(&f)
    }
}

impl PlanarView for Subdivision {
    fn position(&self, v: VertexId) -> Option<Point> {
        self.dcel.has_vertex(v).then(|| self.points[v])
    }
}

impl PlanarView for crate::topology::TableColumns {
    fn position(&self, v: VertexId) -> Option<Point> {
        Self::position(self, v).map(Point::from)
    }
}

impl PlanarView for crate::topology::Table {
    fn position(&self, v: VertexId) -> Option<Point> {
        self.vertices.get(v.index())?.as_ref()?.position.map(Point::from)
    }
}
