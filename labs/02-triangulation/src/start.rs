//! What a case can begin with.

use crate::harness::{points, whole};
use crate::point::Point;
use crate::polygon::Polygons;

/// `polygon 0 0 4 0 3 3`: one polygon, its corners counter-clockwise.
pub fn polygon(words: &[&str]) -> Result<Polygons, String> {
    let corners = points(words)?;
    if corners.len() < 3 {
        return Err("a polygon has at least three corners".to_owned());
    }
    Ok(of_points(corners.into_iter().map(|[x, y]| Point { x, y })))
}

/// `convex 300`: a polygon with so many corners, on a parabola; no three of them are on one line.
pub fn convex(words: &[&str]) -> Result<Polygons, String> {
    let &[count] = words else { return Err("it takes one number".to_owned()) };
    let count = whole(count)?;
    if !(3..=200_000).contains(&count) {
        return Err("it takes a number from 3 to 200000".to_owned());
    }
    Ok(of_points((0..count).map(|i| Point { x: i as f64, y: (i * i) as f64 })))
}

fn of_points(points: impl Iterator<Item = Point>) -> Polygons {
    let mut polygons = Polygons::default();
    for point in points {
        polygons.new_corner(point);
    }
    let count = polygons.corners.len();
    for c in 0..count {
        polygons.make_next(c, (c + 1) % count);
    }
    polygons
}
