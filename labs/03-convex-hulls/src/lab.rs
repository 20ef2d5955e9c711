//! Your part of the lab: convex hulls in three ways, tangents, and a picture.
//!
//! The tasks are numbered as in the handout, README.md. Replace each `todo!(…)` by code; the functions that help
//! are in `polygons.rs`. `cargo test` says how far you are.

#[allow(unused_imports)]
use crate::polygons::{CornerId, Point, Polygons, Turn, is_between, left_to_right, turn};
use crate::svg::Svg;

/// Hulls of points.
impl Polygons {
    /// Task 1. Makes the convex hull of `self.points`, by gift wrapping, and returns any one of its corners; `None` if
    /// there is no point.
    pub fn gift_wrapping(&mut self) -> Option<CornerId> {
        todo!("gift_wrapping")
    }

    /// Task 2. Makes the convex hull of `self.points`, by Graham's scan, and returns any one of its corners; `None` if
    /// there is no point. The time is that of sorting the points.
    pub fn graham_scan(&mut self) -> Option<CornerId> {
        todo!("graham_scan")
    }
}

/// Tangents.
impl Polygons {
    /// Task 3. The corners in which the two tangents from `p` touch the convex polygon of the corner `c`: first the
    /// right one, with the polygon on the left of the line from `p` to it, then the left one. Of two corners on one
    /// tangent it is the one nearer to `p`. `None` if `p` is not outside of the polygon.
    pub fn tangents(&self, c: CornerId, p: Point) -> Option<(CornerId, CornerId)> {
        let _ = (c, p);
        todo!("tangents")
    }

    /// Task 4. The two common tangents of two convex polygons. All of the polygon of `a` comes before all of the
    /// polygon of `b`, from left to right. Each tangent is given by the corner of the first polygon and the corner of
    /// the second one in which it touches them; first the lower one, with both polygons on its left, then the upper
    /// one, with both on its right. Of several corners on one tangent it is the outermost two.
    pub fn common_tangents(&self, a: CornerId, b: CornerId) -> ((CornerId, CornerId), (CornerId, CornerId)) {
        let _ = (a, b);
        todo!("common_tangents")
    }

    /// Task 5. Makes one convex polygon of two, their hull, and returns any one of its corners. The polygons are as in
    /// task 4. What becomes of the corners that are inside now is up to you.
    pub fn merge(&mut self, a: CornerId, b: CornerId) -> CornerId {
        let _ = (a, b);
        todo!("merge")
    }
}

/// Task 6. Draws the hull of all points but the last one, and the tangents from the last one: a filled polygon, a line
/// for each side of it, a line from the last point to each of the two corners, a dot for every point.
pub fn picture(polygons: &mut Polygons, svg: &mut Svg) {
    let _ = (polygons, svg);
    todo!("picture")
}
