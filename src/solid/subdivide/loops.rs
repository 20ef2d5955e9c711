//! Loop: four triangles from each.
//!
//! ```text
//!   edge vertex     3/8 of both ends and 1/8 of the two tips beside it;                     on a sharp edge its middle
//!   old vertex      (1 - n b) v + b (sum of its n neighbours),
//!                   b = (5/8 - (3/8 + cos(2 pi / n) / 4)^2) / n;                            with sharp edges: sharp.rs
//! ```

use super::refine::{Coarse, PIECE, Pointers, Scheme, Sizes};
use super::sharp::{Point, add, move_vertices, weighted};
use super::{SubdivideError, Subdivided};
use crate::geometry::threads::{both, pieces};
use crate::ids::{EdgeId, HalfEdgeId};
use crate::solid::{Polyhedron, Selection};
use crate::topology::TooMany;
use std::f64::consts::TAU;

pub(super) fn step(solid: &Polyhedron, creases: &Selection<EdgeId>) -> Result<Subdivided, SubdivideError> {
    let coarse = Coarse::new(solid, creases);
    let d = coarse.dcel();
    for f in solid.faces().filter(|&f| !solid.is_boundary_face(f)) {
        let sides = solid.incident_half_edges(f).count();
        if sides != 3 {
            return Err(SubdivideError::NotATriangle { face: f, sides });
        }
    }
    let (old, edges, corners) = (d.vertex_bound(), d.edge_bound(), coarse.corners.len());
    let triangles = corners / 3;
    let faces = corners + triangles;
    TooMany::check(old + edges, 2 * edges + corners, faces + d.face_count() - triangles)?;

    // The triangles in the middle come after those of the corners, in the order of their stored half-edges.
    let mut middle_of = vec![0; d.face_bound()];
    let is_stored = |h: &&HalfEdgeId| d.half_edge(d.face(**h)) == Some(**h);
    let stored: Vec<HalfEdgeId> = coarse.corners.iter().filter(is_stored).copied().collect();
    stored.iter().zip(corners as u32..).for_each(|(&h, face)| middle_of[d.face(h).index()] = face);
    let sizes = Sizes { vertices: old + edges, edges: 2 * edges + corners, faces };
    let linked = || coarse.refined(&Loop { coarse: &coarse, middle_of: &middle_of }, &sizes);
    let (mut columns, points) = both(linked, || points(&coarse));
    columns.boundary[corners..].iter_mut().zip(&stored).for_each(|(first, &h)| *first = coarse.inner(h) + 1);
    Ok(Subdivided { polyhedron: coarse.finish(columns, points, faces), creases: coarse.finer_creases() })
}

/// Corner k of h: `2h, inner(h), 2 prev(h).twin + 1`. The triangle in the middle has the other halves of the inner edges.
struct Loop<'c> {
    coarse: &'c Coarse<'c>,
    /// The triangle in the middle of each face.
    middle_of: &'c [u32],
}

impl Scheme for Loop<'_> {
    #[inline]
    fn before(&self, h: HalfEdgeId) -> u32 {
        self.coarse.inner(self.coarse.dcel().next(h))
    }

    #[inline]
    fn inner(&self, k: u32, h: HalfEdgeId) -> [Pointers; 2] {
        let (c, d) = (self.coarse, self.coarse.dcel());
        let [n, p] = [d.next(h), d.prev(h)];
        let corner = Pointers { origin: c.middle(h), next: 2 * p.twin().number() + 1, prev: 2 * h.number(), face: k };
        let face = self.middle_of[d.face(h).index()];
        [corner, Pointers { origin: c.middle(p), next: c.inner(n) + 1, prev: c.inner(p) + 1, face }]
    }
}

/// Loop's b for a vertex of degree n, times n.
fn share(n: usize) -> f64 {
    0.625 - (0.375 + 0.25 * (TAU / n as f64).cos()).powi(2)
}

fn points(coarse: &Coarse<'_>) -> Vec<Point> {
    let (d, solid) = (coarse.dcel(), &coarse.solid);
    let shares: [f64; 32] = std::array::from_fn(|n| share(n.max(1)));
    let mut points = vec![[0.0; 3]; d.vertex_bound() + d.edge_bound()];
    let (of_vertices, of_edges) = points.split_at_mut(d.vertex_bound());
    move_vertices(coarse, of_vertices, |v, here| {
        let (mut ends, mut n) = ([0.0; 3], 0);
        for w in d.adjacent_vertices(v) {
            add(&mut ends, solid.point(w));
            n += 1;
        }
        let share = shares.get(n).copied().unwrap_or_else(|| share(n));
        weighted([(1.0 - share, here), (share / n as f64, ends)])
    });
    pieces(of_edges, PIECE, |first, piece| {
        for (e, point) in (first as u32..).map(EdgeId::new).zip(piece) {
            let [a, b] = e.half_edges();
            let end = |h| solid.point(d.origin(h));
            *point = if coarse.is_sharp(a) {
                weighted([(0.5, end(a)), (0.5, end(b))])
            } else {
                let tip = |h| end(d.prev(h));
                weighted([(0.375, end(a)), (0.375, end(b)), (0.125, tip(a)), (0.125, tip(b))])
            };
        }
    });
    points
}
