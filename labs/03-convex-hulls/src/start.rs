//! What cases start from.

use crate::harness::{points as read_points, whole};
use crate::polygons::{Point, Polygons};

/// `points x y x y …`: points, and no polygon yet.
pub fn points(words: &[&str]) -> Result<Polygons, String> {
    Ok(with_points(places(words)?))
}

/// `polygons x y x y … / x y …`: polygons, the corners of each counter-clockwise. They are c0, c1, … in this order.
pub fn polygons(words: &[&str]) -> Result<Polygons, String> {
    let mut out = Polygons::default();
    for polygon in words.split(|word| *word == "/") {
        let corners = places(polygon)?;
        if out.new_polygon(&corners).is_none() {
            return Err("a polygon has at least one corner".to_owned());
        }
    }
    Ok(out)
}

/// `bowl n`: n points, some on a parabola, y = x², with x from -1200 to 1200, all others above it, mixed.
pub fn bowl(words: &[&str]) -> Result<Polygons, String> {
    let [count] = words else { return Err("a bowl has one number".to_owned()) };
    let points = (0..whole(count)?).map(|i| {
        // 7919 is a prime number: x takes all values before one comes again.
        let x = (i * 7919 % 2401) as f64 - 1200.0;
        // The first 2401 points are the bowl, the others what is in it.
        let y = if i < 2401 { x * x } else { 1_440_000.0 - (1_440_000.0 - x * x) * (i * 31 % 997) as f64 / 1024.0 };
        Point { x, y }
    });
    Ok(with_points(points))
}

/// The points of the handout: the last one is where the tangents come from.
pub fn handout(words: &[&str]) -> Result<Polygons, String> {
    if !words.is_empty() {
        return Err("the points of the handout are always the same".to_owned());
    }
    Ok(with_points(HANDOUT.map(|[x, y]| Point { x, y })))
}

const HANDOUT: [[f64; 2]; 15] = [
    [-250.0, -60.0],
    [-110.0, -150.0],
    [30.0, -150.0],
    [110.0, -90.0],
    [130.0, 40.0],
    [40.0, 140.0],
    [-130.0, 150.0],
    [-220.0, 80.0],
    [-40.0, -150.0],
    [-120.0, 20.0],
    [0.0, 60.0],
    [20.0, -60.0],
    [-60.0, 90.0],
    [-160.0, -60.0],
    [250.0, -10.0],
];

fn with_points(points: impl IntoIterator<Item = Point>) -> Polygons {
    let mut out = Polygons::default();
    points.into_iter().for_each(|point| out.points.push(point));
    out
}

fn places(words: &[&str]) -> Result<Vec<Point>, String> {
    Ok(read_points(words)?.into_iter().map(|[x, y]| Point { x, y }).collect())
}
