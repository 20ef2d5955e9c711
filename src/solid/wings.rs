//! The highest corner of a bent face beside each of its edges.
//!
//! ```text
//!            ● c'                  Seen along the edge from a to b, the corners of the face on its left lie to the left,
//!        ● c    ╲                  each at its own height. The plane through a, b and the highest one, c', has no
//!            ╲   ╲                 corner of the face above it: it is a side of the hull of the corners.
//!    ● ─ ─ ─ ─ ─ ─●  a, b
//! ```
//!
//! A face of a few corners is asked at each edge. Of a large one the hull of its corners is made once: beside an edge
//! that is an edge of the hull, too, the highest corner lies on the side of the hull to its left: seen from above, that
//! side runs counter-clockwise like the face.

use super::Polyhedron;
use super::flat::Shadow;
use super::hull::HullFaces;
use super::predicates::{are_collinear, orient3d};
use super::vector::Vector;
use crate::ids::{FaceId, FaceMap, HalfEdgeId, HalfEdgeMap, VertexId};
use crate::plane::predicates::orientation;
use std::cmp::Ordering;

/// Bent faces with more corners than this have a hull of their own.
const LARGE: usize = 16;

/// The highest corners of the large bent faces, by half-edge.
pub(super) struct Wings {
    /// The highest corner beside the half-edge; empty if no face is large and bent.
    of_hull: HalfEdgeMap<Option<VertexId>>,
}

impl Wings {
    /// Looks at the large bent faces. O(n log n) for each of n corners, expected.
    pub(super) fn new(solid: &Polyhedron, bent: &FaceMap<bool>) -> Self {
        let is_large = |f: &FaceId| bent[*f] && solid.corners(*f).nth(LARGE).is_some();
        let mut large = solid.faces().filter(is_large).peekable();
        if large.peek().is_none() {
            return Self { of_hull: HalfEdgeMap::filled(0, None) };
        }
        let mut of_hull = HalfEdgeMap::filled(solid.half_edge_bound(), None);
        large.for_each(|f| look_at(solid, f, &mut of_hull));
        Self { of_hull }
    }

    /// The highest corner of the face of `h`, whose shadow is convex, beside `h`. None if a corner lies straight above
    /// or below the line of `h` in the shadow: then each corner has to be asked.
    pub(super) fn highest(&self, solid: &Polyhedron, h: HalfEdgeId, shadow: Shadow) -> Option<Vector> {
        if let Some(&Some(corner)) = self.of_hull.get(h) {
            return Some(solid.point(corner));
        }
        let dcel = solid.topology();
        let (a, b) = (solid.point(dcel.origin(h)), solid.point(dcel.destination(h)));
        let mut highest: Option<Vector> = None;
        for p in other_corners(solid, h).filter(|&p| !are_collinear(a, b, p)) {
            if orientation(shadow.of(a), shadow.of(b), shadow.of(p)) != Ordering::Greater {
                return None;
            }
            if highest.is_none_or(|c| orient3d(a, b, c, p) == Ordering::Greater) {
                highest = Some(p);
            }
        }
        highest
    }
}

/// The corners of the face of `h` that are not its ends.
pub(super) fn other_corners(solid: &Polyhedron, h: HalfEdgeId) -> impl Iterator<Item = Vector> + '_ {
    let dcel = solid.topology();
    dcel.cycle(dcel.next(dcel.next(h))).take_while(move |&g| g != h).map(|g| solid.point(dcel.origin(g)))
}

/// Finds the sides of the hull of a face's corners that lie to the left of the face's own edges.
fn look_at(solid: &Polyhedron, f: FaceId, of_hull: &mut HalfEdgeMap<Option<VertexId>>) {
    let cycle: Vec<HalfEdgeId> = solid.incident_half_edges(f).collect();
    let points: Vec<Vector> = solid.corners(f).collect();
    // Corners that cannot have a hull are asked one by one.
    let Ok(hull) = Polyhedron::convex_hull(&points, HullFaces::Whole) else { return };
    let dcel = hull.solid.topology();
    let corner = |v: VertexId| hull.points[v] as usize;
    for g in hull.solid.half_edges() {
        let [from, to] = [dcel.origin(g), dcel.destination(g)].map(corner);
        if to == (from + 1) % cycle.len() {
            let third = dcel.destination(dcel.next(g));
            of_hull[cycle[from]] = Some(solid.topology().origin(cycle[corner(third)]));
        }
    }
}
