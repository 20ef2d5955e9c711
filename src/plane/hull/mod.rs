//! The convex hull of points.
//!
//! ```text
//!             ●───────●             Sorted from left to right, the points are taken one by one; a corner that does
//!           ╱   ·   ·   ╲           not turn left is dropped again. Once for the lower side, once back for the
//!         ●   ┌───────┐   ●         upper one.
//!          ╲  │· · · ·│  ╱
//!            ●└───────┘●            Before that, points in the middle are put aside: those with points right and left
//!             ╲───────╱             of them both above and below. If many are left, `strips.rs` finds more of them.
//! ```
//!
//! Source: Andrew, *Another efficient algorithm for convex hulls in two dimensions*, Information Processing Letters 9,
//! 1979; de Berg et al., *Computational Geometry*, 3rd ed., section 1.1.

mod strips;

use super::{CoordinateError, Point, Subdivision};
use crate::geometry::predicates::orientation;
use crate::ids::MAX_IDS;
use crate::topology::{NoObserver, Observer, TooMany};

/// Why points have no convex hull.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum HullError {
    /// A point whose coordinates cannot be used.
    #[error("point {point}: {error}")]
    Coordinate {
        /// Which of the points.
        point: u32,
        /// What is wrong with it.
        error: CoordinateError,
    },
    /// More points than ids.
    #[error(transparent)]
    TooMany(#[from] TooMany),
}

/// What Andrew's scan does. Points are named by their numbers.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum HullEvent {
    /// The points that are left are in order from left to right; so many were put aside before.
    Sorted {
        /// How many points are inside for sure, or at the place of an earlier one.
        aside: u32,
    },
    /// The last corner goes again: with the new point it does not turn left.
    Dropped {
        /// The corner that goes.
        corner: u32,
        /// The new point.
        point: u32,
    },
    /// The point is the last corner for now.
    Taken(u32),
    /// The lower side is done; the same from right to left.
    Turned,
}

/// The corners of the convex hull, by their numbers among the points: counter-clockwise from the leftmost one on, of
/// several above each other the lowest.
///
/// Every corner turns left: points on a side are no corners. Of equal points the first one counts. If all points lie on
/// one line, its two ends are the corners; if they are all at one place, it is one; without points there is none.
///
/// Cost: O(n log n), and O(n) for points that fill an area evenly. All decisions are exact.
///
/// # Errors
/// [`HullError`] names the first point that cannot be used.
///
/// ```
/// use dcel_kit::plane::convex_hull;
/// let points = [(2., 1.), (0., 0.), (2., 2.), (4., 0.), (4., 3.), (2., 0.), (0., 3.)].map(Into::into);
/// assert_eq!(convex_hull(&points)?, [1, 3, 4, 6]);
/// # Ok::<(), dcel_kit::plane::HullError>(())
/// ```
pub fn convex_hull(points: &[Point]) -> Result<Vec<u32>, HullError> {
    convex_hull_observed(points, &mut NoObserver)
}

/// [`convex_hull`], watched.
///
/// # Errors
/// As [`convex_hull`].
pub fn convex_hull_observed(points: &[Point], observer: &mut impl Observer<HullEvent>) -> Result<Vec<u32>, HullError> {
    if points.len() > MAX_IDS {
        return Err(TooMany.into());
    }
    for (point, p) in points.iter().enumerate() {
        p.check().map_err(|error| HullError::Coordinate { point: point as u32, error })?;
    }
    let (mut lower, upper) = strips::sides(points, &strips::outer(points, outer_points(points)));
    let left = upper.as_ref().map_or(lower.len(), |upper| lower.len() + upper.len() - 2);
    observer.observe(|| HullEvent::Sorted { aside: (points.len() - left) as u32 });
    let mut upper = upper.unwrap_or_else(|| lower.clone());
    scan(&mut lower, observer);
    observer.observe(|| HullEvent::Turned);
    upper.reverse();
    scan(&mut upper, observer);
    // The last point of each way is the first of the other one; points at one place are one, which both ways begin with.
    lower.pop();
    if upper.len() > 1 {
        upper.pop();
    }
    Ok(lower.into_iter().chain(upper).map(|(_, i)| i).collect())
}

/// Drops those of some points in order that are no corners of their one side.
fn scan(order: &mut Vec<(Point, u32)>, observer: &mut impl Observer<HullEvent>) {
    let mut corners = 0;
    for next in 0..order.len() {
        let (p, point) = order[next];
        while let [.., (a, _), (b, corner)] = order[..corners]
            && !orientation(a, b, p).is_gt()
        {
            observer.observe(|| HullEvent::Dropped { corner, point });
            corners -= 1;
        }
        observer.observe(|| HullEvent::Taken(point));
        order[corners] = (p, point);
        corners += 1;
    }
    order.truncate(corners);
}

/// The points that may be corners, in increasing order.
///
/// ```text
///     b       a       The four points that reach furthest along the diagonals. A point strictly inside the
///      · ┌──┐·        rectangle between them has one of them in each of its four quadrants: it is no corner.
///        │  │         That holds for any four points, so nothing here needs to be exact.
///     c ·└──┘ · d
/// ```
fn outer_points(points: &[Point]) -> Vec<u32> {
    let Some(&first) = points.first() else { return Vec::new() };
    let [mut a, mut b, mut c, mut d] = [first; 4];
    for &p in points {
        if p.x + p.y > a.x + a.y {
            a = p;
        }
        if p.y - p.x > b.y - b.x {
            b = p;
        }
        if p.x + p.y < c.x + c.y {
            c = p;
        }
        if p.y - p.x < d.y - d.x {
            d = p;
        }
    }
    let (left, right) = (b.x.max(c.x), a.x.min(d.x));
    let (bottom, top) = (c.y.max(d.y), a.y.min(b.y));
    let is_outer = |p: &Point| p.x <= left || right <= p.x || p.y <= bottom || top <= p.y;
    (0..).zip(points).filter(|(_, p)| is_outer(p)).map(|(i, _)| i).collect()
}

impl Subdivision {
    /// The convex hull of points as a subdivision: its corners are v0, v1, ... in the order of [`convex_hull`], its
    /// inside is `f1`. Points on one line give a single edge, points at one place a vertex.
    ///
    /// Cost: that of [`convex_hull`].
    ///
    /// # Errors
    /// [`HullError`] names the first point that cannot be used.
    ///
    /// ```
    /// use dcel_kit::plane::Subdivision;
    /// let hull = Subdivision::convex_hull(&[(0., 0.), (2., 1.), (4., 0.), (2., 3.)].map(Into::into))?;
    /// assert_eq!((hull.vertex_count(), hull.edge_count(), hull.face_count()), (3, 3, 2));
    /// # Ok::<(), dcel_kit::plane::HullError>(())
    /// ```
    pub fn convex_hull(points: &[Point]) -> Result<Self, HullError> {
        let corners: Vec<Point> = convex_hull(points)?.into_iter().map(|i| points[i as usize]).collect();
        let n = corners.len() as u32;
        let sides: Vec<[u32; 2]> = match n {
            0 | 1 => Vec::new(),
            2 => vec![[0, 1]],
            _ => (0..n).map(|i| [i, (i + 1) % n]).collect(),
        };
        // The sides of a convex polygon meet at its corners only: nothing but their number can be refused.
        Self::from_graph(&corners, &sides).map_err(|_| TooMany.into())
    }
}
