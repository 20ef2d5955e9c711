//! What of an edge of the diagram lies in a window.
//!
//! ```text
//!        high             Inside, an edge ends at its corners. Where it leaves the window it ends on the border,
//!   ┌──────────┐          with the coordinate of that side exactly. A corner on the border or outside counts as
//!   │  ●───────┼── ·      being somewhere behind it.
//!   │  ╲       │
//!   └───╲──────┘
//!  low
//! ```

use super::{Voronoi, VoronoiEdge, VoronoiError};
use crate::geometry::point::corners;
use crate::plane::Point;

/// A rectangle with sides along the axes.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Window {
    /// The lower left corner.
    pub low: Point,
    /// The upper right corner.
    pub high: Point,
}

impl Window {
    /// A window around points: the smallest rectangle that holds them, with a margin of a quarter of its longer side.
    ///
    /// ```
    /// use dcel_kit::plane::{Point, Window};
    /// let window = Window::around(&[Point::new(0., 0.), Point::new(8., 4.)]);
    /// assert_eq!(window, Window { low: Point::new(-2., -2.), high: Point::new(10., 6.) });
    /// ```
    #[must_use]
    pub fn around(points: &[Point]) -> Self {
        let [low, high] = corners(points.iter().copied());
        let furthest = [low.x, high.x, low.y, high.y].into_iter().map(f64::abs).fold(0.0, f64::max);
        // Far from 0 a share of the side may be less than the distance of two doubles there.
        let margin = (0.25 * (high.x - low.x).max(high.y - low.y)).max(furthest * 2f64.powi(-40));
        let margin = if margin > 0.0 { margin } else { 1.0 };
        Self { low: Point::new(low.x - margin, low.y - margin), high: Point::new(high.x + margin, high.y + margin) }
    }

    /// Whether the point lies strictly inside.
    #[must_use]
    pub fn contains(&self, p: Point) -> bool {
        self.low.x < p.x && p.x < self.high.x && self.low.y < p.y && p.y < self.high.y
    }

    /// The corners, counter-clockwise from the lower left one.
    #[must_use]
    pub fn corners(&self) -> [Point; 4] {
        let Self { low, high } = *self;
        [low, Point::new(high.x, low.y), high, Point::new(low.x, high.y)]
    }

    pub(super) fn check(&self) -> Result<(), VoronoiError> {
        let Self { low, high } = *self;
        low.check().and(high.check()).map_err(VoronoiError::Coordinate)?;
        if low.x < high.x && low.y < high.y { Ok(()) } else { Err(VoronoiError::EmptyWindow { low, high }) }
    }

    /// Where a ray from inside leaves the window: how far along, and the place on the border.
    fn exit(&self, from: Point, direction: Point) -> (f64, Point) {
        let side = |d: f64, low: f64, high: f64| if d < 0.0 { low } else { high };
        let far = |from: f64, d: f64, side: f64| if d == 0.0 { f64::INFINITY } else { (side - from) / d };
        let (x, y) = (side(direction.x, self.low.x, self.high.x), side(direction.y, self.low.y, self.high.y));
        let (across, up) = (far(from.x, direction.x, x), far(from.y, direction.y, y));
        if across <= up {
            (across, Point::new(x, (from.y + across * direction.y).max(self.low.y).min(self.high.y)))
        } else {
            (up, Point::new((from.x + up * direction.x).max(self.low.x).min(self.high.x), y))
        }
    }
}

impl Voronoi<'_> {
    /// The part of an edge inside a window that holds all sites, from its left end as the edge runs: none if the edge
    /// passes by, or has no length in doubles. The ends are rounded; O(1).
    #[must_use]
    pub fn piece(&self, edge: &VoronoiEdge, window: &Window) -> Option<[Point; 2]> {
        let line = || self.line(edge);
        let back = |along: Point| Point::new(-along.x, -along.y);
        let corner = |i: usize| edge.ends[i].map(|corner| self.corners[corner as usize]);
        let [from, to] = [corner(0), corner(1)];
        let inside = |p: Option<Point>| p.filter(|&p| window.contains(p));
        let piece = match (inside(from), inside(to)) {
            (Some(from), Some(to)) => [from, to],
            (Some(from), None) => [from, window.exit(from, line()[1]).1],
            (None, Some(to)) => [window.exit(to, back(line()[1])).1, to],
            (None, None) => {
                let [middle, along] = line();
                // The middle of two sites lies inside. The corners lie outside: either both on one side of the
                // stretch inside, or one on each.
                let ((ahead, end), (behind, start)) = (window.exit(middle, along), window.exit(middle, back(along)));
                let centre = 0.5 * (ahead - behind);
                let square = along.x * along.x + along.y * along.y;
                let position = |p: Point| ((p.x - middle.x) * along.x + (p.y - middle.y) * along.y) / square;
                let passes = from.is_some_and(|p| position(p) > centre) || to.is_some_and(|p| position(p) < centre);
                if passes {
                    return None;
                }
                [start, end]
            }
        };
        (piece[0] != piece[1]).then_some(piece)
    }
}
