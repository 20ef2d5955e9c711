//! Areas: exact sums, rounded once.
//!
//! ```text
//!      q ●              Twice the area is the sum of p.x q.y - p.y q.x over the half-edges p -> q of all cycles. Far
//!       ╱│   ╲          from the origin these products are large and nearly cancel each other: a square of 0.1 m on a
//!    p ● └────●         map in metres loses all its digits in doubles. Here nothing is lost.
//! ```

use super::{Expansion, Subdivision};
use crate::ids::FaceId;

impl Subdivision {
    /// The area of a bounded face without what lies in its inner components; infinite for `f0`. The exact one of its corners,
    /// rounded to the nearest double or the one beside it. O(corners).
    ///
    /// ```
    /// use dcel_kit::plane::{Point, Subdivision};
    /// let (x, y) = (4_000_000.0, 5_500_000.0);
    /// let corners = [(x, y), (x + 0.125, y), (x + 0.125, y + 0.125), (x, y + 0.125)].map(Point::from);
    /// let square = Subdivision::from_graph(&corners, &[[0, 1], [1, 2], [2, 3], [3, 0]])?;
    /// assert_eq!(square.area(dcel_kit::FaceId::new(1)), 0.015625);
    /// # Ok::<(), dcel_kit::plane::SegmentsError>(())
    /// ```
    #[must_use]
    pub fn area(&self, f: FaceId) -> f64 {
        if f == self.outer_face() { f64::INFINITY } else { self.area_of([f].into_iter()) }
    }

    /// The area of all bounded faces that are no hole faces, as exact as [`area`](Self::area). O(edges).
    #[must_use]
    pub fn domain_area(&self) -> f64 {
        self.area_of(self.dcel.faces().filter(|&f| f != self.outer_face() && !self.is_hole(f)))
    }

    /// The area of some bounded faces together, as exact as [`area`](Self::area).
    pub(crate) fn area_of(&self, faces: impl Iterator<Item = FaceId>) -> f64 {
        let mut twice = Expansion::default();
        for h in faces.flat_map(|f| self.cycles(f)).flat_map(|h| self.dcel.cycle(h)) {
            let [p, q] = [self.dcel.origin(h), self.dcel.destination(h)].map(|v| self.points[v]);
            twice.add_product(p.x, q.y);
            twice.add_product(-p.y, q.x);
        }
        0.5 * twice.rounded()
    }
}
