//! Usual mistakes, carried out: does one of them show in a call?
//!
//! ```text
//!   points 0 0 1 3 2 5 3 3 …     the scan with `if` for `while`     ──▶  another hull: the mistake would show here
//! ```
//!
//! Nothing here decides a verdict. A feature of a call says that such a mistake shows in it; if the calls in which it
//! shows are those that fail, the report says so.

use super::polygons::{Corner, is_between, is_beyond};
use super::tangents::common;
use dcel_kit::plane::Point;
use dcel_kit::plane::predicates::{left_to_right, orientation};

/// How the scan goes wrong.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Scan {
    /// At most one point is taken off before the next is added.
    AtMostOne,
    /// Points above each other come in the order of the list.
    ByX,
}

/// The corners that a wrong scan finds.
pub(super) fn scan(points: &[Point], wrong: Scan) -> Vec<Point> {
    let mut sorted = points.to_vec();
    if wrong == Scan::ByX {
        sorted.sort_by(|p, q| p.x.total_cmp(&q.x));
    } else {
        sorted.sort_by(|p, q| left_to_right(*p, *q));
    }
    sorted.dedup();
    if sorted.len() < 2 {
        return sorted;
    }
    let mut found = Vec::new();
    for _ in 0..2 {
        let mut chain: Vec<Point> = Vec::new();
        for &p in &sorted {
            while let [.., a, b] = chain[..]
                && !orientation(a, b, p).is_gt()
            {
                chain.pop();
                if wrong == Scan::AtMostOne {
                    break;
                }
            }
            chain.push(p);
        }
        chain.pop();
        found.append(&mut chain);
        sorted.reverse();
    }
    found
}

/// How gift wrapping goes wrong.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Gift {
    /// Of points straight on, the first one that was met stays.
    AnyInLine,
    /// Of several leftmost points, the first one of the list is where it begins.
    AnyLeftmost,
}

/// The corners that a wrong gift wrapping finds; nothing if it does not come back.
pub(super) fn gift(points: &[Point], wrong: Gift) -> Vec<Point> {
    let before = |p: Point, q: Point| {
        if wrong == Gift::AnyLeftmost { p.x < q.x } else { left_to_right(p, q).is_lt() }
    };
    let Some(first) = points.iter().copied().reduce(|kept, p| if before(p, kept) { p } else { kept }) else {
        return Vec::new();
    };
    let (mut hull, mut here) = (Vec::new(), first);
    while hull.len() <= points.len() {
        hull.push(here);
        let mut kept = here;
        for &p in points {
            let side = orientation(here, kept, p);
            let further = wrong != Gift::AnyInLine && side.is_eq() && is_between(here, kept, p);
            if kept == here || side.is_lt() || further {
                kept = p;
            }
        }
        here = kept;
        if here == first {
            return hull;
        }
    }
    Vec::new()
}

/// The tangents, if of two corners on one of them the one that was met first is kept.
pub(super) fn first_met(corners: &[Corner], p: Point) -> Option<[u32; 2]> {
    let mut ends = [*corners.first()?; 2];
    for d in corners {
        let [right, left] = ends.map(|c| orientation(p, c.place, d.place));
        if right.is_lt() {
            ends[0] = *d;
        }
        if left.is_gt() {
            ends[1] = *d;
        }
    }
    Some(ends.map(|c| c.number))
}

/// Whether only the last side, from the first corner on, shows that the point is outside.
pub(super) fn only_last_side(corners: &[Corner], p: Point) -> bool {
    let n = corners.len();
    let shows = |i: usize| is_beyond(corners, i, p);
    n > 1 && shows(n - 1) && !(0..n - 1).any(shows)
}

/// How the walk to a common tangent goes wrong.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Walk {
    /// It begins at the given corners.
    FromGiven,
    /// Corners on the lower tangent are not passed.
    NotPast,
    /// For the lower tangent, the first end is not looked at again once the second one has moved.
    OnceEach,
}

/// Whether a wrong walk comes to other tangents than it should.
pub(super) fn walk_differs(first: &[Corner], second: &[Corner], wrong: Walk) -> Option<bool> {
    let (n, m) = (first.len(), second.len());
    let last = (0..n).max_by(|&i, &j| left_to_right(first[i].place, first[j].place))?;
    let begin = (0..m).min_by(|&i, &j| left_to_right(second[i].place, second[j].place))?;
    let start = if wrong == Walk::FromGiven { (0, 0) } else { (last, begin) };
    let walk = |is_lower: bool| {
        let (mut i, mut j) = start;
        // A walk that makes more steps than there are pairs goes in circles.
        for _ in 0..=n * m + n + m {
            let (p, q) = (first[i].place, second[j].place);
            let (near_i, near_j) =
                if is_lower { ((i + n - 1) % n, (j + 1) % m) } else { ((i + 1) % n, (j + m - 1) % m) };
            let beyond = |c: Point| {
                let side = orientation(p, q, c);
                (if is_lower { side.is_lt() } else { side.is_gt() }, side.is_eq())
            };
            let past = !(is_lower && wrong == Walk::NotPast);
            let (a, b) = (first[near_i].place, second[near_j].place);
            let is_closed = is_lower && wrong == Walk::OnceEach && j != start.1;
            if !is_closed && (beyond(a).0 || past && beyond(a).1 && left_to_right(a, p).is_lt()) {
                i = near_i;
            } else if beyond(b).0 || past && beyond(b).1 && left_to_right(q, b).is_lt() {
                j = near_j;
            } else {
                return Some([first[i].number, second[j].number]);
            }
        }
        None
    };
    let expected = common(first, second)?;
    Some([walk(true), walk(false)] != expected.map(Some))
}

#[cfg(test)]
mod tests {
    use super::super::hull::hull;
    use super::*;

    fn points<const N: usize>(places: [[f64; 2]; N]) -> Vec<Point> {
        places.map(Point::from).into()
    }

    fn corners(first: u32, places: &[Point]) -> Vec<Corner> {
        (first..).zip(places).map(|(number, &place)| Corner { number, place }).collect()
    }

    #[test]
    fn mistakes_show_where_they_should_and_nowhere_else() {
        let plain = points([[0., 0.], [7., 1.], [2., 6.]]);
        for wrong in [Scan::AtMostOne, Scan::ByX] {
            assert_eq!(scan(&plain, wrong), hull(&plain));
        }
        for wrong in [Gift::AnyInLine, Gift::AnyLeftmost] {
            assert_eq!(gift(&plain, wrong), hull(&plain));
        }
        let dented = points([[0., 0.], [1., 0.1], [2., 0.5], [3., 1.5], [3.5, -9.], [4., 5.]]);
        assert_ne!(scan(&dented, Scan::AtMostOne), hull(&dented));
        let upright = points([[0., 5.], [0., 2.], [0., 0.], [4., 3.]]);
        assert_ne!(scan(&upright, Scan::ByX), hull(&upright));
        let middle_first = points([[0., 2.], [0., 0.], [0., 5.], [4., 3.]]);
        assert_ne!(gift(&middle_first, Gift::AnyLeftmost), hull(&middle_first));
        let in_line = points([[1., 1.], [0., 0.], [2., 2.], [3., 0.]]);
        assert_ne!(gift(&in_line, Gift::AnyInLine), hull(&in_line));
    }

    #[test]
    fn walks_go_wrong_only_where_the_mistake_matters() {
        let first = corners(0, &points([[4., 2.], [2., 4.], [0., 2.], [2., 0.]]));
        let second = corners(4, &points([[6., 2.], [8., 0.], [10., 2.], [8., 4.]]));
        let differs = |wrong| walk_differs(&first, &second, wrong);
        assert_eq!([Walk::FromGiven, Walk::NotPast].map(differs), [Some(false); 2]);
        let line = [corners(0, &points([[0., 0.], [1., 1.]])), corners(2, &points([[2., 2.], [3., 3.]]))];
        assert_eq!(walk_differs(&line[0], &line[1], Walk::NotPast), Some(true));
        let square = corners(0, &points([[0., 0.], [4., 0.], [4., 4.], [0., 4.]]));
        assert!(only_last_side(&square, Point::new(-1., 2.)));
        assert!(!only_last_side(&square, Point::new(-1., -2.)));
        assert_eq!(first_met(&square, Point::new(8., 2.)), Some([2, 1]));
    }
}
