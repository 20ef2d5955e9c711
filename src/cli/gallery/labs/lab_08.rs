//! The figure of lab 08.

use super::{Made, dots};
use dcel_kit::figure::FigureOptions;
use dcel_kit::figure::sketch::{Role, Sketch};
use dcel_kit::plane::{Point, Subdivision, Window};
use dcel_lab::cases::handouts::SITES;

/// The picture that lab 08 asks for. All centres are inside of the frame, at which the rays end.
pub(in crate::gallery) fn picture(options: &FigureOptions) -> Made<String> {
    let delaunay = Subdivision::delaunay(&SITES.map(Point::from))?.subdivision;
    let voronoi = delaunay.voronoi()?;
    let frame = Window { low: Point::new(-320.0, -220.0), high: Point::new(320.0, 220.0) };
    let mut sketch = Sketch::new();
    for edge in voronoi.edges() {
        if let Some(ends) = voronoi.piece(edge, &frame) {
            sketch.path(Role::Main, ends).solid();
        }
    }
    dots(&mut sketch, Role::Plain, SITES);
    Ok(sketch.figure(options)?.to_svg())
}
