//! The picture: the list of the handout as a structure.

use super::soup::Soup;
use std::collections::BTreeSet;
use std::fmt::Write;

/// The points of the handout's list.
pub(super) const POINTS: [[f64; 2]; 7] =
    [[-250.0, -150.0], [0.0, -150.0], [250.0, -150.0], [250.0, 150.0], [0.0, 150.0], [-250.0, 150.0], [0.0, 0.0]];

/// The handout's list.
pub(super) fn soup() -> Soup {
    Soup { vertices: 7, faces: vec![vec![0, 1, 6], vec![1, 2, 3, 6], vec![3, 4, 6], vec![6, 4, 5, 0]] }
}

/// The picture that the student's program should draw, with the coordinates that it writes: y points down in a file.
pub(super) fn reference() -> String {
    let at = |v: u32| {
        let [x, y] = POINTS[v as usize];
        (x, 0.0 - y)
    };
    let mut out = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"-270 -170 540 340\">\n".to_owned();
    for face in &soup().faces {
        let corners: Vec<String> = face.iter().map(|&v| format!("{},{}", at(v).0, at(v).1)).collect();
        let _ = writeln!(out, "<polygon points=\"{}\" fill=\"#dddddd\"/>", corners.join(" "));
    }
    let edges: BTreeSet<[u32; 2]> = soup().half_edges().into_keys().filter(|[a, b]| a < b).collect();
    for [a, b] in edges {
        let ((x1, y1), (x2, y2)) = (at(a), at(b));
        let _ = writeln!(out, "<line x1=\"{x1}\" y1=\"{y1}\" x2=\"{x2}\" y2=\"{y2}\" stroke=\"#000000\"/>");
    }
    for (x, y) in (0..soup().vertices).map(at) {
        let _ = writeln!(out, "<circle cx=\"{x}\" cy=\"{y}\" r=\"4\"/>");
    }
    out + "</svg>\n"
}
