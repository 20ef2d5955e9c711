//! The figures of lab 07: the reference, and what a flip does to the records.

use super::{Made, dots, triangles};
use dcel_kit::figure::FigureOptions;
use dcel_kit::figure::sketch::{Multiples, Role, Sketch};
use dcel_kit::plane::{Point, Subdivision};
use dcel_lab::cases::handouts::{SITES, circle};

/// The picture that lab 07 asks for.
pub(in crate::gallery) fn circles(options: &FigureOptions) -> Made<String> {
    let delaunay = Subdivision::delaunay(&SITES.map(Point::from))?.subdivision;
    let mut sketch = Sketch::new();
    for corners in triangles(&delaunay) {
        let mut circle = circle(corners);
        circle.push(circle[0]);
        sketch.path(Role::Secondary, circle).solid();
    }
    for edge in delaunay.edges() {
        let ends = edge.half_edges().map(|h| delaunay.point(delaunay.origin(h)));
        sketch.path(Role::Main, ends).solid();
    }
    dots(&mut sketch, Role::Plain, SITES);
    Ok(sketch.figure(options)?.to_svg())
}

/// The corners a, b, c, d of two triangles, counter-clockwise a, d, b, c.
const CORNERS_OF_A_FLIP: [(&str, [f64; 2]); 4] =
    [("a", [-210.0, 15.0]), ("b", [200.0, -15.0]), ("c", [-20.0, 190.0]), ("d", [30.0, -190.0])];
/// The half-edges run along a triangle that is smaller by this factor; their names stand along one smaller still.
const WITHIN: f64 = 0.76;
const NAMES: f64 = 0.44;
/// How far the half-edges end before the corners of that triangle.
const SHORT: f64 = 9.0;

/// One triangle: its half-edges with their names, and the name of its face.
fn triangle(sketch: &mut Sketch, corners: [[f64; 2]; 3], names: [&str; 3], face: &str) {
    let length = |p: [f64; 2], q: [f64; 2]| (q[0] - p[0]).hypot(q[1] - p[1]);
    // The centre of the circle that touches all sides: each corner has the weight of the side across.
    let weights = [0, 1, 2].map(|i| length(corners[(i + 1) % 3], corners[(i + 2) % 3]));
    let sum: f64 = weights.iter().sum();
    let centre = [0, 1].map(|axis| (0..3).map(|i| weights[i] * corners[i][axis]).sum::<f64>() / sum);
    let towards = |p: [f64; 2], by: f64| [0, 1].map(|axis| centre[axis] + by * (p[axis] - centre[axis]));
    for i in 0..3 {
        let [p, q] = [corners[i], corners[(i + 1) % 3]];
        let ends = [towards(p, WITHIN), towards(q, WITHIN)];
        let part = SHORT / length(ends[0], ends[1]);
        let at = |t: f64| [0, 1].map(|axis| ends[0][axis] + t * (ends[1][axis] - ends[0][axis]));
        let (role, key) = match names[i] {
            "h" | "twin" => (Role::Main, "changes its origin"),
            "bc" | "ad" => (Role::Secondary, "changes its face"),
            _ => (Role::Plain, "changes next and prev only, as all six do"),
        };
        sketch.path(role, [at(part), at(1.0 - part)]).arrow().solid().key(key);
        let middle = [0, 1].map(|axis| f64::midpoint(p[axis], q[axis]));
        sketch.text(role, towards(middle, NAMES), names[i]);
    }
    sketch.text(Role::Dimmed, centre, face);
}

/// The records of a flip, before and after.
pub(in crate::gallery) fn flip(options: &FigureOptions) -> Made<String> {
    let [a, b, c, d] = CORNERS_OF_A_FLIP.map(|(_, place)| place);
    let mut panels = Multiples::new();
    let all = [
        ("Before", "h runs from a to b", [a, b], [([a, b, c], ["h", "bc", "ca"]), ([b, a, d], ["twin", "ad", "db"])]),
        (
            "After",
            "h runs from d to c: it has turned counter-clockwise",
            [d, c],
            [([d, c, a], ["h", "ca", "ad"]), ([c, d, b], ["twin", "db", "bc"])],
        ),
    ];
    for (heading, words, edge, triangles) in all {
        let mut sketch = Sketch::new();
        for side in [[a, d], [d, b], [b, c], [c, a], edge] {
            sketch.path(Role::Dimmed, side).solid();
        }
        for ((corners, names), face) in triangles.into_iter().zip(["f", "g"]) {
            triangle(&mut sketch, corners, names, face);
        }
        for (name, place) in CORNERS_OF_A_FLIP {
            sketch.point(Role::Plain, place).label(name);
        }
        panels.sketch(heading, words, sketch);
    }
    Ok(panels.figure(options)?.to_svg())
}
