//! The picture of the handout: a regular solid and its dual, as the program of the lab draws them.

use super::dual::mean;
use super::regular;
use crate::pictures::Plain;
use dcel_kit::topology::View;

/// The solids whose pictures are judged, by the names that a case has for them.
pub(super) const DRAWN: [&str; 2] = ["cube", "dodecahedron"];

/// The ends of all edges, and the vertices, of a regular solid and of its dual.
fn lines(solid: &str) -> (Vec<[[f64; 3]; 2]>, Vec<[f64; 3]>) {
    let solid = regular::solid(solid);
    let middle = |f| {
        let corners: Vec<[f64; 3]> = solid.of_face(f).into_iter().filter_map(|h| solid.place(h)).collect();
        mean(corners.into_iter())
    };
    let mut lines = Vec::new();
    for h in solid.half_edges() {
        let Some(twin) = solid.table.twin(h).filter(|&twin| h < twin) else { continue };
        lines.extend(solid.place(h).zip(solid.place(twin)).map(|(p, q)| [p, q]));
        lines.extend(solid.table.face(h).zip(solid.table.face(twin)).map(|(f, g)| [middle(f), middle(g)]));
    }
    let dots = solid.points.iter().copied().chain(solid.faces().map(middle)).collect();
    (lines, dots)
}

/// Where a point of space is drawn; y points down.
fn place([x, y, z]: [f64; 3]) -> [f64; 2] {
    [100.0 * x + 40.0 * y, 0.0 - (15.0 * x - 30.0 * y - 100.0 * z)]
}

/// The picture, with the coordinates that the student's program writes.
pub(super) fn plain(solid: &str) -> String {
    let (lines, dots) = lines(solid);
    let mut out = Plain::new("-300 -250 600 500");
    lines.into_iter().for_each(|[p, q]| out.edge(place(p), place(q)));
    dots.into_iter().for_each(|p| out.vertex(place(p)));
    out.svg()
}
