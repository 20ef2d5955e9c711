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
        // BEGIN SOLUTION
        // STARTER: todo!("gift_wrapping")
        // A corner for sure: the leftmost point, of several the lowest.
        let mut first = *self.points.get(0)?;
        for &p in &self.points {
            if p.is_before(first) {
                first = p;
            }
        }
        let mut hull = Vec::new();
        let mut here = first;
        loop {
            hull.push(here);
            // The next corner: everything else is on the left of the line to it, and on the line it is the last one.
            let mut best = here;
            for &p in &self.points {
                let better = best == here
                    || match turn(here, best, p) {
                        Turn::Right => true,
                        Turn::Straight => is_between(here, best, p),
                        Turn::Left => false,
                    };
                if better {
                    best = p;
                }
            }
            here = best;
            if here == first {
                break;
            }
        }
        self.new_polygon(&hull)
        // END SOLUTION
    }

    /// Task 2. Makes the convex hull of `self.points`, by Graham's scan, and returns any one of its corners; `None` if
    /// there is no point. The time is that of sorting the points.
    pub fn graham_scan(&mut self) -> Option<CornerId> {
        // BEGIN SOLUTION
        // STARTER: todo!("graham_scan")
        // Appends one side of the hull. Its last corner is left out: the other side begins with it.
        fn one_side(points: &[Point], hull: &mut Vec<Point>) {
            let mut side: Vec<Point> = Vec::new();
            for &p in points {
                while side.len() >= 2 && turn(side[side.len() - 2], side[side.len() - 1], p) != Turn::Left {
                    side.pop();
                }
                side.push(p);
            }
            side.pop();
            hull.append(&mut side);
        }

        let mut points: Vec<Point> = self.points.iter().copied().collect();
        points.sort_by(left_to_right);
        points.dedup();
        if points.len() == 1 {
            return self.new_polygon(&points);
        }
        let mut hull = Vec::new();
        one_side(&points, &mut hull);
        points.reverse();
        one_side(&points, &mut hull);
        self.new_polygon(&hull)
        // END SOLUTION
    }
}

/// Tangents.
impl Polygons {
    /// Task 3. The corners in which the two tangents from `p` touch the convex polygon of the corner `c`: first the
    /// right one, with the polygon on the left of the line from `p` to it, then the left one. Of two corners on one
    /// tangent it is the one nearer to `p`. `None` if `p` is not outside of the polygon.
    pub fn tangents(&self, c: CornerId, p: Point) -> Option<(CornerId, CornerId)> {
        // BEGIN SOLUTION
        // STARTER: let _ = (c, p);
        // STARTER: todo!("tangents")
        // Whether b is further to one side than a, seen from p; on one line, whether it is nearer.
        let further = |a: CornerId, b: CornerId, side: Turn| {
            let (a, b) = (self.position(a), self.position(b));
            let where_is_b = turn(p, a, b);
            where_is_b == side || where_is_b == Turn::Straight && is_between(p, b, a)
        };
        if !self.is_outside(c, p) {
            return None;
        }
        let (mut right, mut left) = (c, c);
        let mut d = self.next(c);
        while d != c {
            if further(right, d, Turn::Right) {
                right = d;
            }
            if further(left, d, Turn::Left) {
                left = d;
            }
            d = self.next(d);
        }
        Some((right, left))
        // END SOLUTION
    }
    // BEGIN SOLUTION
    // STARTER:

    /// Whether a point is outside of a convex polygon: on the right of a side, or beyond its end.
    fn is_outside(&self, c: CornerId, p: Point) -> bool {
        let mut d = c;
        loop {
            let (a, b) = (self.position(d), self.position(self.next(d)));
            match turn(a, b, p) {
                Turn::Right => return true,
                Turn::Straight if !is_between(a, p, b) => return true,
                _ => {}
            }
            d = self.next(d);
            if d == c {
                return false;
            }
        }
    }

    // END SOLUTION
    /// Task 4. The two common tangents of two convex polygons. All of the polygon of `a` comes before all of the
    /// polygon of `b`, from left to right. Each tangent is given by the corner of the first polygon and the corner of
    /// the second one in which it touches them; first the lower one, with both polygons on its left, then the upper
    /// one, with both on its right. Of several corners on one tangent it is the outermost two.
    pub fn common_tangents(&self, a: CornerId, b: CornerId) -> ((CornerId, CornerId), (CornerId, CornerId)) {
        // BEGIN SOLUTION
        // STARTER: let _ = (a, b);
        // STARTER: todo!("common_tangents")
        // The last corner of one polygon and the first one of the other: nothing is between them.
        let (mut last, mut first) = (a, b);
        let mut c = self.next(a);
        while c != a {
            if self.position(last).is_before(self.position(c)) {
                last = c;
            }
            c = self.next(c);
        }
        c = self.next(b);
        while c != b {
            if self.position(c).is_before(self.position(first)) {
                first = c;
            }
            c = self.next(c);
        }
        let lower = self.lower_tangent(last, first);
        let upper = self.upper_tangent(last, first);
        (lower, upper)
        // END SOLUTION
    }
    // BEGIN SOLUTION
    // STARTER:

    /// Moves both ends of a line down, until nothing is below it.
    fn lower_tangent(&self, mut a: CornerId, mut b: CornerId) -> (CornerId, CornerId) {
        loop {
            let (p, q) = (self.position(a), self.position(b));
            let (before, after) = (self.position(self.prev(a)), self.position(self.next(b)));
            let below_a = turn(p, q, before);
            let below_b = turn(p, q, after);
            if below_a == Turn::Right || below_a == Turn::Straight && before.is_before(p) {
                a = self.prev(a);
            } else if below_b == Turn::Right || below_b == Turn::Straight && q.is_before(after) {
                b = self.next(b);
            } else {
                return (a, b);
            }
        }
    }

    /// Moves both ends of a line up, until nothing is above it.
    fn upper_tangent(&self, mut a: CornerId, mut b: CornerId) -> (CornerId, CornerId) {
        loop {
            let (p, q) = (self.position(a), self.position(b));
            let (after, before) = (self.position(self.next(a)), self.position(self.prev(b)));
            let above_a = turn(p, q, after);
            let above_b = turn(p, q, before);
            if above_a == Turn::Left || above_a == Turn::Straight && after.is_before(p) {
                a = self.next(a);
            } else if above_b == Turn::Left || above_b == Turn::Straight && q.is_before(before) {
                b = self.prev(b);
            } else {
                return (a, b);
            }
        }
    }

    // END SOLUTION
    /// Task 5. Makes one convex polygon of two, their hull, and returns any one of its corners. The polygons are as in
    /// task 4. What becomes of the corners that are inside now is up to you.
    pub fn merge(&mut self, a: CornerId, b: CornerId) -> CornerId {
        // BEGIN SOLUTION
        // STARTER: let _ = (a, b);
        // STARTER: todo!("merge")
        let (lower, upper) = self.common_tangents(a, b);
        self.make_next(lower.0, lower.1);
        self.make_next(upper.1, upper.0);
        lower.0
        // END SOLUTION
    }
}

/// Task 6. Draws the hull of all points but the last one, and the tangents from the last one: a filled polygon, a line
/// for each side of it, a line from the last point to each of the two corners, a dot for every point.
pub fn picture(polygons: &mut Polygons, svg: &mut Svg) {
    // BEGIN SOLUTION
    // STARTER: let _ = (polygons, svg);
    // STARTER: todo!("picture")
    let dots: Vec<Point> = polygons.points.iter().copied().collect();
    let Some(eye) = polygons.points.pop() else { return };
    let Some(first) = polygons.graham_scan() else { return };
    let mut corners = vec![first];
    while polygons.next(corners[corners.len() - 1]) != first {
        corners.push(polygons.next(corners[corners.len() - 1]));
    }
    let places: Vec<Point> = corners.iter().map(|&c| polygons.position(c)).collect();
    svg.polygon(&places);
    for i in 0..places.len() {
        svg.line(places[i], places[(i + 1) % places.len()]);
    }
    if let Some((right, left)) = polygons.tangents(first, eye) {
        svg.line(eye, polygons.position(right));
        svg.line(eye, polygons.position(left));
    }
    for dot in dots {
        svg.dot(dot);
    }
    // END SOLUTION
}
