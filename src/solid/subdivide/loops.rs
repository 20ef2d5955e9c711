//! Loop: four triangles from each.
//!
//! ```text
//!   edge vertex     3/8 of both ends and 1/8 of the two tips beside it;                     on a sharp edge its middle
//!   old vertex      (1 - n b) v + b (sum of its n neighbours),
//!                   b = (5/8 - (3/8 + cos(2 pi / n) / 4)^2) / n;                            with sharp edges: sharp.rs
//! ```

use super::refine::{Coarse, Fine, PIECE};
use super::sharp::{Point, add, held, weighted};
use super::{SubdivideError, Subdivided};
use crate::geometry::threads::{both, pieces};
use crate::ids::{EdgeId, VertexId};
use crate::solid::{Polyhedron, Selection};
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
    Coarse::room(old + edges, 2 * edges + corners, faces + d.face_count() - triangles)?;

    let linked = || {
        let mut fine = Fine::new(&coarse, old + edges, 2 * edges + corners, faces);
        let inner = |corner: u32| 2 * (2 * edges as u32 + corner);
        let mut middle = corners as u32;
        for (k, &h) in coarse.corners.iter().enumerate() {
            let (k, p, n) = (k as u32, d.prev(h), d.next(h));
            let on = |x: crate::ids::HalfEdgeId| old as u32 + x.edge().number();
            fine.inner_edge(inner(k), on(h), on(p));
            fine.face(k, &[2 * h.number(), inner(k), 2 * p.twin().number() + 1]);
            if d.half_edge(d.face(h)) == Some(h) {
                let round = [h, n, p].map(|x| inner(coarse.corner[x.index()]) + 1);
                fine.face(middle, &round);
                middle += 1;
            }
        }
        fine
    };
    let (fine, points) = both(linked, || points(&coarse));
    Ok(Subdivided { polyhedron: fine.finish(points, faces), creases: coarse.finer_creases() })
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
    pieces(of_vertices, PIECE, |first, piece| {
        for (v, point) in (first as u32..).map(VertexId::new).zip(piece) {
            let here = solid.point(v);
            *point = match d.outgoing(v) {
                None => here,
                Some(_) => held(coarse, v).unwrap_or_else(|| {
                    let (mut ends, mut n) = ([0.0; 3], 0);
                    for w in d.adjacent_vertices(v) {
                        add(&mut ends, solid.point(w));
                        n += 1;
                    }
                    let share = shares.get(n).copied().unwrap_or_else(|| share(n));
                    weighted([(1.0 - share, here), (share / n as f64, ends)])
                }),
            };
        }
    });
    pieces(of_edges, PIECE, |first, piece| {
        for (e, point) in (first as u32..).map(EdgeId::new).zip(piece) {
            let [a, b] = e.half_edges();
            let end = |h| solid.point(d.origin(h));
            *point = if coarse.is_sharp(a) {
                weighted([(0.5, end(a)), (0.5, end(b))])
            } else {
                let tips = [a, b].map(|h| end(d.prev(h)));
                weighted([(0.375, end(a)), (0.375, end(b)), (0.125, tips[0]), (0.125, tips[1])])
            };
        }
    });
    points
}
