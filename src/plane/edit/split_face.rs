//! Splitting a face of a subdivision along a straight edge.
//!
//! ```text
//!   ┌────── h1 ─┬───────┐        The segment between the two corners must leave both of them into the face,
//!   │   f       │ new   │        cross no edge and pass no vertex. Inner components go to the side they lie on.
//!   │   ┌─┐    a│  ┌─┐  │
//!   │   └─┘     v  └─┘  │
//!   └───────────┴─ h2 ──┘
//! ```

use super::Obstacle;
use crate::ids::{FaceId, HalfEdgeId, VertexId};
use crate::plane::cycle::{encloses, in_corner, same_direction};
use crate::plane::{PlaneRecorder, Subdivision};
use crate::topology::{self, InnerComponent, NoRecorder};

/// Why a face of a subdivision cannot be split between the origins of two half-edges.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum SplitFaceError {
    /// The half-edges do not fit each other, whatever the positions.
    #[error(transparent)]
    Topology(#[from] topology::SplitFaceError),
    /// The face passes the same vertex at both corners: the new edge would have no length.
    #[error("{h1} and {h2} both start at {vertex}: the new edge would have no length")]
    SameVertex {
        /// The first half-edge.
        h1: HalfEdgeId,
        /// The second half-edge.
        h2: HalfEdgeId,
        /// Their common origin.
        vertex: VertexId,
    },
    /// The two vertices are joined by an edge already.
    #[error("the origins of {h1} and {h2} are joined by {existing} already")]
    EdgeExists {
        /// The first half-edge.
        h1: HalfEdgeId,
        /// The second half-edge.
        h2: HalfEdgeId,
        /// A half-edge of the edge between them.
        existing: HalfEdgeId,
    },
    /// The segment leaves one of the corners to the outside of the face.
    #[error("the segment between the origins of {h1} and {h2} runs outside {face} at the corner of {corner}")]
    EdgeOutsideFace {
        /// The first half-edge.
        h1: HalfEdgeId,
        /// The second half-edge.
        h2: HalfEdgeId,
        /// The face that was to be split.
        face: FaceId,
        /// Which of the two corners it leaves the wrong way.
        corner: HalfEdgeId,
    },
    /// The segment crosses an edge.
    #[error("the segment between the origins of {h1} and {h2} crosses {crossed}")]
    EdgeCrosses {
        /// The first half-edge.
        h1: HalfEdgeId,
        /// The second half-edge.
        h2: HalfEdgeId,
        /// The half-edge it crosses, on the side of the face.
        crossed: HalfEdgeId,
    },
    /// The segment passes through a vertex.
    #[error("the segment between the origins of {h1} and {h2} passes through {vertex}: split in two steps")]
    EdgeThroughVertex {
        /// The first half-edge.
        h1: HalfEdgeId,
        /// The second half-edge.
        h2: HalfEdgeId,
        /// The vertex on the segment.
        vertex: VertexId,
    },
}

impl Subdivision {
    /// Whether [`split_face`](Self::split_face) would succeed, and if not, why. Changes nothing.
    ///
    /// Cost: O(number of half-edges and isolated vertices of the face).
    pub fn can_split_face(&self, h1: HalfEdgeId, h2: HalfEdgeId) -> Result<(), SplitFaceError> {
        self.dcel.can_split_face(h1, h2)?;
        let (v1, v2) = (self.dcel.origin(h1), self.dcel.origin(h2));
        if v1 == v2 {
            return Err(SplitFaceError::SameVertex { h1, h2, vertex: v1 });
        }
        if let Some(existing) = self.dcel.find_half_edge(v1, v2) {
            return Err(SplitFaceError::EdgeExists { h1, h2, existing });
        }
        let (a, b) = (self.points[v1], self.points[v2]);
        let face = self.dcel.face(h1);
        for (corner, at, to) in [(h1, a, b), (h2, b, a)] {
            let after = self.points[self.dcel.destination(corner)];
            let before = self.points[self.dcel.origin(self.dcel.prev(corner))];
            for (end, g) in [(after, corner), (before, self.dcel.prev(corner).twin())] {
                if same_direction(at, end, to) {
                    return Err(SplitFaceError::EdgeThroughVertex { h1, h2, vertex: self.dcel.destination(g) });
                }
            }
            if !in_corner([before, at, after], to) {
                return Err(SplitFaceError::EdgeOutsideFace { h1, h2, face, corner });
            }
        }
        let refused = self.find_on_way(face, [a, b], |obstacle| match obstacle {
            Obstacle::Vertex(vertex) => Some(SplitFaceError::EdgeThroughVertex { h1, h2, vertex }),
            Obstacle::Edge(crossed) => Some(SplitFaceError::EdgeCrosses { h1, h2, crossed }),
        });
        refused.map_or(Ok(()), Err)
    }

    /// The half-edges that start at `v` and in whose corner the way to `q` begins: one, or two if it begins along an edge,
    /// which lies between their corners. None if `v` has no edge.
    #[cfg(feature = "play")]
    pub(crate) fn corners_towards(&self, v: VertexId, q: crate::plane::Point) -> Vec<HalfEdgeId> {
        let at = self.points[v];
        let end = |h: HalfEdgeId| self.points[self.dcel.destination(h)];
        let one_ring = || self.dcel.outgoing_half_edges(v);
        if let Some(along) = one_ring().find(|&h| same_direction(at, end(h), q)) {
            return vec![along, self.dcel.next(along.twin())];
        }
        let before = |h: HalfEdgeId| self.points[self.dcel.origin(self.dcel.prev(h))];
        one_ring().filter(|&h| in_corner([before(h), at, end(h)], q)).collect()
    }

    /// The lab's `splitFace`: joins the origins of `h1` and `h2`, which lie on one boundary cycle of the same
    /// face, by a straight edge.
    ///
    /// Returns the new half-edge from `origin(h1)` to `origin(h2)`, and the new face. Along the outer boundary
    /// of a bounded face the new face lies on the LEFT of that half-edge and the cycle through `h1` keeps the
    /// old face, as in the kernel. Along an inner component (so always for `f0`) the new face is the bounded piece that is
    /// cut off, on whichever side it lies: `f0` stays unbounded. Inner components of the old face that lie in the new one
    /// move over. If the old face is a hole, so is the new one.
    ///
    /// Cost: O(number of half-edges of the face), and O(length of the new boundary) for each inner component.
    ///
    /// # Errors
    /// See [`SplitFaceError`]; a refused call leaves everything bit for bit as it was.
    ///
    /// ```
    /// use dcel_kit::{HalfEdgeId, plane::Subdivision};
    /// let mut lab = Subdivision::lab_rectangle();
    /// let h = |i: u32| HalfEdgeId::new(2 * i); // h0, h2, ... h10 run round the inside
    /// let (a, new) = lab.split_face(h(1), h(4))?;
    /// assert_eq!((lab.origin(a), lab.destination(a)), (lab.origin(h(1)), lab.origin(h(4))));
    /// assert_eq!((lab.face(a), lab.face(h(4))), (new, new));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn split_face(&mut self, h1: HalfEdgeId, h2: HalfEdgeId) -> Result<(HalfEdgeId, FaceId), SplitFaceError> {
        self.split_face_with(h1, h2, &mut NoRecorder)
    }

    /// [`split_face`](Self::split_face), watched by a recorder.
    pub fn split_face_with(
        &mut self,
        h1: HalfEdgeId,
        h2: HalfEdgeId,
        rec: &mut impl PlaneRecorder,
    ) -> Result<(HalfEdgeId, FaceId), SplitFaceError> {
        self.can_split_face(h1, h2)?;
        Ok(self.split_face_unchecked(h1, h2, rec))
    }

    /// The write phase. The half-edges must have passed [`can_split_face`](Self::can_split_face).
    pub(super) fn split_face_unchecked(
        &mut self,
        h1: HalfEdgeId,
        h2: HalfEdgeId,
        rec: &mut impl PlaneRecorder,
    ) -> (HalfEdgeId, FaceId) {
        let old = self.dcel.face(h1);
        let (a, new) = if self.is_on_outer_boundary(h1) {
            let (a, new) = self.dcel.split_face_unchecked(h1, h2, rec);
            let rings = self.take_inner_components(old, rec);
            self.share_inner_components([old, new], rings, None, rec);
            (a, new)
        } else {
            self.split_inner_component(h1, h2, rec)
        };
        if self.holes.contains(&old) {
            self.mark_hole(new, true, rec);
        }
        (a, new)
    }

    /// Splits a face along one of its inner components: a bounded piece is cut off.
    fn split_inner_component(
        &mut self,
        h1: HalfEdgeId,
        h2: HalfEdgeId,
        rec: &mut impl PlaneRecorder,
    ) -> (HalfEdgeId, FaceId) {
        let old = self.dcel.face(h1);
        let boundary = self.dcel.half_edge(old);
        let mut rings = self.take_inner_components(old, rec);
        let split = self.inner_component_index(&rings, h1);
        let left_part = self.dcel.cycle(h2).take_while(|&h| h != h1).chain([h1]);
        let left_is_bounded = encloses(left_part.map(|h| self.points[self.dcel.origin(h)]));
        let (a, new) = if left_is_bounded {
            self.dcel.split_face_unchecked(h1, h2, rec)
        } else {
            let (twin, new) = self.dcel.split_face_unchecked(h2, h1, rec);
            (twin.twin(), new)
        };
        // The kernel took the half-edge outside the new face for the old face's boundary; it is an inner component's.
        let rest = if left_is_bounded { a.twin() } else { a };
        if let Some(i) = split {
            rings[i] = InnerComponent::Cycle(rest);
        }
        if old != self.outer_face() {
            self.dcel.set_half_edge(old, boundary, rec);
        }
        self.share_inner_components([old, new], rings, split, rec);
        (a, new)
    }
}
