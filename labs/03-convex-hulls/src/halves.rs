//! The hull by halves: divide the points, make the hull of each half, merge the two. `merge` is yours.
//!
//! ```text
//!   · · · ·  · · · ·        split in the middle, from left to right
//!   · · │· · │· · │·        and so on, until each part is one point: a polygon with one corner
//!   ●──●│●──●│●──●│●        then merged, two and two
//! ```

use crate::harness::Meter;
use crate::polygons::{CornerId, Point, Polygons, left_to_right};

/// Makes the hull of all points. Each merge has as many reads as a call by itself.
#[track_caller]
pub fn hull(polygons: &mut Polygons, meter: Meter, merge: Merge) -> Option<CornerId> {
    let mut points: Vec<Point> = polygons.points.iter().copied().collect();
    points.sort_by(left_to_right);
    points.dedup();
    hull_of(polygons, &points, meter, merge)
}

/// Your `Polygons::merge`.
pub type Merge = fn(&mut Polygons, CornerId, CornerId) -> CornerId;

#[track_caller]
fn hull_of(polygons: &mut Polygons, points: &[Point], meter: Meter, merge: Merge) -> Option<CornerId> {
    if points.len() < 2 {
        return polygons.new_polygon(points);
    }
    let (left, right) = points.split_at(points.len() / 2);
    let a = hull_of(polygons, left, meter, merge)?;
    let b = hull_of(polygons, right, meter, merge)?;
    meter.next_move(polygons.points.len() + polygons.corners.len());
    Some(merge(polygons, a, b))
}
