//! The geometry of closed walks: which way they run, what they surround. All exact.

use super::Point;
use crate::geometry::predicates::{left_to_right, orientation};
use std::cmp::Ordering;

/// Whether the region on the left of the closed walk is the bounded one, that is, whether the walk runs
/// counter-clockwise. The walk may touch itself at corners and run along an edge twice, but not cross itself.
///
/// ```text
///      u                     At the leftmost corner everything lies to the right. The region on the left of
///       ╲  region            the walk u -> v -> w opens to the right exactly if u lies to the left of v -> w;
///        v                   if it opens to the outside, it is unbounded.
///       ╱
///      w
/// ```
///
/// Cost: O(corners).
pub(crate) fn encloses(corners: impl Iterator<Item = Point> + Clone) -> bool {
    let Some(leftmost) = corners.clone().min_by(|&a, &b| left_to_right(a, b)) else { return false };
    windows(corners).filter(|[_, v, _]| *v == leftmost).all(|[u, v, w]| orientation(v, w, u).is_gt())
}

/// Whether the corners of a simple polygon run counter-clockwise, decided exactly. False if all of them lie on one line; of
/// a polygon that crosses itself, the leftmost corner decides.
///
/// Cost: O(corners).
///
/// ```
/// use dcel_kit::plane::{Point, is_counter_clockwise};
/// let mut square = [(0., 0.), (1., 0.), (1., 1.), (0., 1.)].map(Point::from);
/// assert!(is_counter_clockwise(&square));
/// square.reverse();
/// assert!(!is_counter_clockwise(&square));
/// ```
#[must_use]
pub fn is_counter_clockwise(corners: &[Point]) -> bool {
    encloses(corners.iter().copied())
}

/// Which way a closed walk runs round a convex region, once: `Greater` = counter-clockwise. `Equal` if all its corners lie on
/// one line, `None` if there is no convex region. Straight corners may be among its corners.
///
/// Cost: O(corners).
pub(super) fn convex_direction(corners: impl Iterator<Item = Point>) -> Option<Ordering> {
    let (mut direction, mut changes) = (Ordering::Equal, 0);
    let mut rest = corners;
    let (Some(first), Some(second)) = (rest.next(), rest.next()) else { return Some(direction) };
    let (mut u, mut v, mut way) = (first, second, left_to_right(first, second));
    rest.chain([first, second]).try_for_each(|w| {
        let (turn, next_way) = (orientation(u, v, w), left_to_right(v, w));
        if turn.is_ne() && turn == direction.reverse() {
            return None;
        }
        direction = direction.then(turn);
        // With turns to one side only, it is convex if it runs from left to right and back just once.
        changes += u32::from(way != next_way);
        (u, v, way) = (v, w, next_way);
        Some(())
    })?;
    (direction.is_eq() || changes == 2).then_some(direction)
}

/// Whether `q`, which must not lie on the walk, is on the bounded side of the closed walk: even-odd rule, so
/// that edges walked in both directions do not count. Cost: O(corners).
pub(crate) fn surrounds(corners: impl Iterator<Item = Point> + Clone, q: Point) -> bool {
    let crosses = |a: Point, b: Point| {
        (a.y > q.y) != (b.y > q.y) && orientation(a, b, q) == if b.y > a.y { Ordering::Greater } else { Ordering::Less }
    };
    windows(corners).filter(|&[_, a, b]| crosses(a, b)).count() % 2 == 1
}

/// Whether the direction from `v` to `q` points strictly into the corner u -> v -> w, on its left.
///
/// ```text
///        u       The corner reaches counter-clockwise from the direction of w to the direction of u.
///         ╲   q  If u and w are the same, it is everything but that one direction.
///          v ────── w
/// ```
pub(super) fn in_corner([u, v, w]: [Point; 3], q: Point) -> bool {
    match orientation(v, w, u) {
        Ordering::Greater => orientation(v, w, q).is_gt() && orientation(v, q, u).is_gt(),
        Ordering::Less => orientation(v, u, q).is_lt() || orientation(v, q, w).is_lt(),
        Ordering::Equal if same_direction(v, u, w) => !same_direction(v, q, w),
        Ordering::Equal => orientation(v, w, q).is_gt(),
    }
}

/// Whether `p` and `q` lie in exactly the same direction from `v`.
pub(super) fn same_direction(v: Point, p: Point, q: Point) -> bool {
    orientation(v, p, q).is_eq() && left_to_right(v, p) == left_to_right(v, q)
}

/// Whether `q` lies on the segment a-b, its ends included.
pub(crate) fn on_segment(a: Point, b: Point, q: Point) -> bool {
    orientation(a, b, q).is_eq() && left_to_right(a, q) != left_to_right(b, q) || q == a || q == b
}

/// Whether the corner u -> v -> w turns left, or runs straight on: a corner of a convex face.
#[cfg(feature = "navmesh")]
#[inline]
pub(crate) fn turns_left_or_runs_straight([u, v, w]: [Point; 3]) -> bool {
    match orientation(u, v, w) {
        Ordering::Greater => true,
        Ordering::Equal => left_to_right(u, v) == left_to_right(v, w),
        Ordering::Less => false,
    }
}

/// Order of the directions from `v` to `a` and `b`, counter-clockwise, starting just after straight down.
pub(crate) fn by_direction(v: Point, a: Point, b: Point) -> Ordering {
    let half = |p: Point| left_to_right(p, v);
    half(b).cmp(&half(a)).then_with(|| orientation(v, b, a))
}

/// Consecutive triples of a closed walk, each corner once in the middle.
fn windows(corners: impl Iterator<Item = Point> + Clone) -> impl Iterator<Item = [Point; 3]> {
    let ahead = corners.clone().skip(1).chain(corners.clone().take(1));
    let mut before = corners.clone().last();
    corners.zip(ahead).filter_map(move |(v, w)| before.replace(v).map(|u| [u, v, w]))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn walk(list: &[(i32, i32)]) -> Vec<Point> {
        list.iter().map(|&(x, y)| Point::new(f64::from(x), f64::from(y))).collect()
    }

    #[test]
    fn which_way_a_walk_runs() {
        let square = walk(&[(0, 0), (4, 0), (4, 4), (0, 4)]);
        assert!(encloses(square.iter().copied()));
        assert!(!encloses(square.iter().rev().copied()));
        // Dangling edges inside and outside do not change it, at the leftmost corner either.
        assert!(encloses(walk(&[(0, 0), (1, 1), (0, 0), (4, 0), (4, 4), (0, 4)]).into_iter()));
        assert!(encloses(walk(&[(0, 0), (4, 0), (4, 4), (0, 4), (0, 0), (1, 1)]).into_iter()));
        assert!(!encloses(walk(&[(4, 0), (0, 0), (-1, 0), (0, 0), (0, 4), (4, 4)]).into_iter()));
        // A chain walked on both sides, a single edge.
        assert!(!encloses(walk(&[(0, 0), (1, 1), (2, 0), (1, 1)]).into_iter()));
        assert!(!encloses(walk(&[(0, 0), (1, 1)]).into_iter()));
        // Two triangles that touch at their leftmost corner, seen from outside and one from inside.
        let bow = walk(&[(0, 0), (2, 3), (3, 2), (0, 0), (3, -2), (2, -3)]);
        assert!(!encloses(bow.iter().copied()));
        assert!(encloses(walk(&[(0, 0), (3, 2), (2, 3), (0, 0), (-3, -2), (-2, -3)]).into_iter()));
    }

    #[test]
    fn convex_walks() {
        let direction = |list: &[(i32, i32)]| convex_direction(walk(list).into_iter());
        let is = |list: &[(i32, i32)]| direction(list) == Some(Ordering::Greater);
        assert_eq!(direction(&[(0, 4), (4, 4), (4, 0), (0, 0)]), Some(Ordering::Less));
        assert_eq!(direction(&[(0, 0), (2, 0), (4, 0)]), Some(Ordering::Equal));
        assert_eq!(direction(&[(0, 0), (4, 0), (4, 4), (3, 1)]), None);
        assert!(is(&[(0, 0), (2, 0), (4, 0), (4, 4), (0, 4), (0, 1)]) && is(&[(0, 0), (1, 0), (0, 1)]));
        // The other way round, a dent, all on one line, a spike, two times round, no region.
        assert!(!is(&[(0, 4), (4, 4), (4, 0), (0, 0)]) && !is(&[(0, 0), (4, 0), (4, 4), (3, 1)]));
        assert!(!is(&[(0, 0), (2, 0), (4, 0)]) && !is(&[(0, 0), (5, 0), (4, 0), (4, 4)]));
        assert!(!is(&[(0, 0), (4, 0), (4, 4), (0, 4), (0, 0), (4, 0), (4, 4), (0, 4)]));
        assert!(!is(&[(0, 0), (3, 0)]) && !is(&[(0, 0)]) && !is(&[]));
    }

    #[test]
    fn inside_and_outside() {
        let c = walk(&[(0, 0), (6, 0), (6, 6), (4, 6), (4, 2), (2, 2), (2, 6), (0, 6)]);
        let inside = |x, y| surrounds(c.iter().copied(), Point::new(x, y));
        assert!(inside(1.0, 5.0) && inside(5.0, 2.0) && inside(3.0, 1.0));
        assert!(!inside(3.0, 4.0) && !inside(7.0, 2.0) && !inside(-1.0, 6.0) && !inside(3.0, 6.0));
    }

    #[test]
    fn corners_of_every_kind() {
        let p = |x, y| Point::new(f64::from(x), f64::from(y));
        let at = |u, w, q| in_corner([u, p(0, 0), w], q);
        assert!(at(p(0, 1), p(1, 0), p(2, 3)) && !at(p(0, 1), p(1, 0), p(-1, 3)));
        assert!(!at(p(0, 1), p(1, 0), p(5, 0)) && !at(p(0, 1), p(1, 0), p(0, 5)));
        assert!(at(p(1, 0), p(0, 1), p(-1, 3)) && !at(p(1, 0), p(0, 1), p(2, 3)) && !at(p(1, 0), p(0, 1), p(5, 0)));
        assert!(at(p(-1, 0), p(1, 0), p(0, 1)) && !at(p(-1, 0), p(1, 0), p(0, -1)) && !at(p(-1, 0), p(1, 0), p(3, 0)));
        assert!(at(p(1, 0), p(1, 0), p(-1, 0)) && !at(p(1, 0), p(1, 0), p(2, 0)));
    }
}
