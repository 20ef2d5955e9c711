//! The picture: the list of the handout as a structure.

use super::soup::Soup;
use crate::cases::handouts::{LIST_FACES, LIST_POINTS};
use crate::pictures::Plain;
use std::collections::BTreeSet;

/// The handout's list.
pub(super) fn soup() -> Soup {
    Soup { vertices: 7, faces: LIST_FACES.map(<[u32]>::to_vec).to_vec() }
}

/// The picture that the student's program should draw, with the coordinates that it writes: y points down in a file.
pub(super) fn reference() -> String {
    let at = |v: u32| LIST_POINTS[v as usize];
    let mut out = Plain::new("-270 -170 540 340");
    soup().faces.iter().for_each(|face| out.face(face.iter().map(|&v| at(v))));
    let edges: BTreeSet<[u32; 2]> = soup().half_edges().into_keys().filter(|[a, b]| a < b).collect();
    edges.into_iter().for_each(|[a, b]| out.edge(at(a), at(b)));
    LIST_POINTS.into_iter().for_each(|p| out.vertex(p));
    out.svg()
}
