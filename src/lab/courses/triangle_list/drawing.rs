//! The picture: the list of the handout as a structure.

use super::soup::Soup;
use crate::pictures::Plain;
use std::collections::BTreeSet;

/// The points of the handout's list.
pub(super) const POINTS: [[f64; 2]; 7] =
    [[-250.0, -150.0], [0.0, -150.0], [250.0, -150.0], [250.0, 150.0], [0.0, 150.0], [-250.0, 150.0], [0.0, 0.0]];

/// The handout's list.
pub(super) fn soup() -> Soup {
    Soup { vertices: 7, faces: vec![vec![0, 1, 6], vec![1, 2, 3, 6], vec![3, 4, 6], vec![6, 4, 5, 0]] }
}

/// The picture that the student's program should draw, with the coordinates that it writes: y points down in a file.
pub(super) fn reference() -> String {
    let at = |v: u32| POINTS[v as usize];
    let mut out = Plain::new("-270 -170 540 340");
    soup().faces.iter().for_each(|face| out.face(face.iter().map(|&v| at(v))));
    let edges: BTreeSet<[u32; 2]> = soup().half_edges().into_keys().filter(|[a, b]| a < b).collect();
    edges.into_iter().for_each(|[a, b]| out.edge(at(a), at(b)));
    POINTS.into_iter().for_each(|p| out.vertex(p));
    out.svg()
}
