//! Triangulations that cases begin with, beside those of lab 04.
//!
//! ```text
//!   sites            the twelve sites of the handout, joined from left to right: long thin triangles
//!   slanted 2 1      v3 ──── v4 ──── v5       cells that lean over, each cut along its long diagonal
//!                    ╱   __╱╱   __╱╱
//!                  v0 ──── v1 ──── v2
//! ```
//!
//! The triangle t has the half-edges h(3t), h(3t+1), h(3t+2), and is the face f(t+1); f0 is the outer face. Its
//! half-edges come last.

use crate::dcel::{Dcel, FaceId, HalfEdgeId, VertexId};
use crate::harness::whole;
use std::collections::HashMap;

/// The sites of the handout. Lab 08 has the same ones.
const SITES: [[i32; 2]; 12] = [
    [-180, -110],
    [-40, -150],
    [120, -120],
    [210, -20],
    [150, 110],
    [10, 150],
    [-150, 120],
    [-230, 10],
    [-60, -20],
    [60, 40],
    [-50, 70],
    [80, -60],
];

/// How they are joined if each site, from left to right, is joined with all that it sees.
const JOINED: [[usize; 3]; 14] = [
    [7, 0, 6],
    [6, 0, 8],
    [6, 8, 10],
    [8, 0, 1],
    [10, 8, 1],
    [10, 1, 5],
    [6, 10, 5],
    [5, 1, 9],
    [9, 1, 11],
    [11, 1, 2],
    [9, 11, 2],
    [9, 2, 4],
    [5, 9, 4],
    [4, 2, 3],
];

/// More cells than this are a slip of the keyboard.
const MOST: usize = 100_000;

/// `sites`: a triangulation of the sites of the handout that is not Delaunay.
pub fn sites(words: &[&str]) -> Result<Dcel, String> {
    if !words.is_empty() {
        return Err("the sites of the handout are always the same".to_owned());
    }
    Ok(of_triangles(&SITES.map(|site| site.map(f64::from)), &JOINED))
}

/// `slanted n m`: n times m cells, row by row.
pub fn slanted(words: &[&str]) -> Result<Dcel, String> {
    let &[n, m] = words else { return Err("it takes two numbers".to_owned()) };
    let (n, m) = (whole(n)?, whole(m)?);
    if n == 0 || m == 0 || n.saturating_mul(m) > MOST {
        return Err(format!("there are 1 to {MOST} cells"));
    }
    let points: Vec<[f64; 2]> = (0..=m).flat_map(|y| (0..=n).map(move |x| [(x + y) as f64, y as f64])).collect();
    let mut triangles = Vec::new();
    for y in 0..m {
        for x in 0..n {
            let below = y * (n + 1) + x;
            let above = below + n + 1;
            triangles.extend([[below, below + 1, above + 1], [below, above + 1, above]]);
        }
    }
    Ok(of_triangles(&points, &triangles))
}

/// The structure of triangles, their corners counter-clockwise. No border passes a vertex twice.
fn of_triangles(points: &[[f64; 2]], triangles: &[[VertexId; 3]]) -> Dcel {
    let mut dcel = Dcel::default();
    dcel.outer_face = dcel.new_face();
    points.iter().for_each(|[x, y]| {
        dcel.new_vertex(*x, *y);
    });
    let mut by_ends: HashMap<[VertexId; 2], HalfEdgeId> = HashMap::new();
    for corners in triangles {
        let face = dcel.new_face();
        let sides: Vec<HalfEdgeId> = corners.iter().map(|&v| side(&mut dcel, v, face)).collect();
        for i in 0..3 {
            let after = (i + 1) % 3;
            dcel.make_next(sides[i], sides[after]);
            by_ends.insert([corners[i], corners[after]], sides[i]);
        }
    }
    let outside = dcel.outer_face;
    let mut border: HashMap<VertexId, HalfEdgeId> = HashMap::new();
    for corners in triangles {
        for i in 0..3 {
            let [from, to] = [corners[i], corners[(i + 1) % 3]];
            let twin = match by_ends.get(&[to, from]) {
                Some(&twin) => twin,
                None => {
                    let new = side(&mut dcel, to, outside);
                    border.insert(to, new);
                    new
                }
            };
            dcel.make_twin(by_ends[&[from, to]], twin);
        }
    }
    for &h in border.values() {
        let end = dcel.origin(dcel.twin(h));
        dcel.make_next(h, border[&end]);
    }
    dcel
}

/// A new half-edge of a face; vertex and face know it.
fn side(dcel: &mut Dcel, from: VertexId, face: FaceId) -> HalfEdgeId {
    let h = dcel.new_half_edge(from);
    dcel.half_edges[h].face = Some(face);
    dcel.faces[face].incident_half_edge = Some(h);
    dcel.vertices[from].outgoing_half_edge = Some(h);
    h
}
