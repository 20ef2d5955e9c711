//! The picture of the handout's polygon, cut into triangles. It has one triangulation only, so that all right pictures
//! are alike.

use super::geometry;
pub use super::polygons::DRAWING;
use std::fmt::Write;

/// The colours of the triangles, in turn.
const FILLS: [&str; 5] = ["#cfe3f5", "#f8dfc2", "#d6ecd2", "#eed6e8", "#f5eeb9"];

/// The triangles, by their corners.
#[must_use]
pub fn triangles() -> Vec<[[f64; 2]; 3]> {
    geometry::triangles(&DRAWING).into_iter().map(|corners| corners.map(|k| DRAWING[k])).collect()
}

/// The picture, with the coordinates that the program of the lab writes: y points down in a file.
#[must_use]
pub fn picture() -> String {
    let mut out = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"-110 -200 430 430\">\n  \
                   <title>A polygon cut into triangles</title>\n"
        .to_owned();
    let triangles: Vec<[[f64; 2]; 3]> =
        triangles().into_iter().map(|corners| corners.map(|[x, y]| [x, 0.0 - y])).collect();
    for (i, triangle) in triangles.iter().enumerate() {
        let corners: Vec<String> = triangle.iter().map(|[x, y]| format!("{x},{y}")).collect();
        let _ = writeln!(out, "  <polygon points=\"{}\" fill=\"{}\"/>", corners.join(" "), FILLS[i % FILLS.len()]);
    }
    for [a, b, c] in triangles {
        for ([x1, y1], [x2, y2]) in [(a, b), (b, c), (c, a)] {
            let ends = format!("x1=\"{x1}\" y1=\"{y1}\" x2=\"{x2}\" y2=\"{y2}\"");
            let _ = writeln!(out, "  <line {ends} stroke=\"#333333\" stroke-width=\"2\"/>");
        }
    }
    for [x, y] in DRAWING {
        let _ = writeln!(out, "  <circle cx=\"{x}\" cy=\"{}\" r=\"4\" fill=\"#111111\"/>", 0.0 - y);
    }
    out + "</svg>\n"
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::courses::triangulation::geometry::{Diagonal, diagonal};

    #[test]
    fn the_polygon_of_the_handout_has_one_triangulation() {
        let n = DRAWING.len();
        let diagonals = (0..n * n).filter(|k| k / n < k % n && diagonal(&DRAWING, k / n, k % n) == Diagonal::Yes);
        assert_eq!(diagonals.count(), n - 3, "as many diagonals as a triangulation has: all of them");
        assert_eq!(picture().matches("<polygon").count(), n - 2);
    }
}
