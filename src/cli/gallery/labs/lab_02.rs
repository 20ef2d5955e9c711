//! The reference figure of lab 02.

use super::{Made, dots};
use dcel_kit::figure::FigureOptions;
use dcel_kit::figure::sketch::{Role, Sketch};
use dcel_kit::plane::Point;
use dcel_lab::courses::triangulation::drawing;

/// The corners of the polygon of the handout.
pub(in crate::gallery) fn corners() -> Vec<Point> {
    drawing::DRAWING.into_iter().map(Point::from).collect()
}

/// The triangulation that lab 02 asks for: the only one that its polygon has.
pub(in crate::gallery) fn triangulation(options: &FigureOptions) -> Made<String> {
    let mut sketch = Sketch::new();
    let triangles = drawing::triangles();
    for &corners in &triangles {
        sketch.region(Role::Main, [corners]).plain();
    }
    let mut drawn: Vec<[[f64; 2]; 2]> = Vec::new();
    for [a, b, c] in triangles {
        // A diagonal is a side of two triangles, and runs the other way in the second.
        for [p, q] in [[a, b], [b, c], [c, a]] {
            if !drawn.contains(&[q, p]) {
                sketch.path(Role::Plain, [p, q]);
                drawn.push([p, q]);
            }
        }
    }
    dots(&mut sketch, Role::Plain, drawing::DRAWING);
    Ok(sketch.figure(options)?.to_svg())
}
