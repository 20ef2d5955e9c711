//! Closed paths that are ellipses.
//!
//! ```text
//!    ╭─────╮      all points lie on the ellipse that has the same area, middle and moments as the outline:
//!    │  ·  │      how the curve is cut into pieces does not matter
//!    ╰─────╯
//! ```
//!
//! A path of one stretch only: the letters O and 0 have two.

use crate::compare::painting::Disc;
use crate::compare::pairing::distance;
use crate::plane::Point;

/// How far from its circle a round path may lie, as a part of the radius.
pub(super) const ROUND: f64 = 0.03;
/// Pieces of curves that make a circle, at least.
pub(super) const PIECES: usize = 12;
/// How long they are at most, as a part of the radius.
pub(super) const STEP: f64 = 0.8;
/// The shorter axis of an ellipse that is a vertex is at least this part of the longer one.
const STOUT: f64 = 0.3;

/// An ellipse, or a circle.
pub(super) struct Oval {
    pub(super) centre: Point,
    /// Brings what lies round the centre to the circle of radius 1.
    pub(super) inverse: [f64; 4],
    /// The radius of the circle of the same area.
    pub(super) radius: f64,
    /// The longer half axis.
    pub(super) reach: f64,
}

impl Oval {
    pub(super) fn circle((centre, radius): (Point, f64)) -> Self {
        let one = 1.0 / radius;
        Self { centre, inverse: [one, 0.0, 0.0, one], radius, reach: radius }
    }

    /// All of the inside.
    pub(super) fn disc(&self) -> Disc {
        Disc { centre: self.centre, inverse: self.inverse, from: 0.0, to: 1.0, reach: self.reach }
    }

    /// The ellipse that a closed stretch of curves is.
    pub(super) fn of(points: &[(Point, bool)], closed: bool) -> Option<Self> {
        let (first, last) = (points.first()?.0, points.last()?.0);
        let curved = points.iter().filter(|p| p.1).count();
        if curved < PIECES || curved + 2 < points.len() {
            return None;
        }
        let (centre, [xx, xy, yy]) = moments(points, first)?;
        // Of an ellipse these are a quarter of the squares of its half axes.
        let determinant = xx * yy - xy * xy;
        if !(determinant > 0.0 && determinant.is_finite()) {
            return None;
        }
        let far = |p: Point| {
            let (x, y) = (p.x - centre.x, p.y - centre.y);
            (0.25 * (yy * x * x - 2.0 * xy * x * y + xx * y * y) / determinant).sqrt()
        };
        // The pieces lie within the curve, and so the moments are a little small.
        let scale = points.iter().map(|p| far(p.0)).sum::<f64>() / points.len() as f64;
        let grown = 4.0 * scale * scale;
        let (half, turn) = (0.5 * (xx + yy), (0.25 * (xx - yy).powi(2) + xy * xy).sqrt());
        let [long, short] = [half + turn, half - turn].map(|square| (grown * square).sqrt());
        let fits = points.iter().all(|p| (far(p.0) - scale).abs() <= ROUND * scale);
        let step = |p: Point, q: Point| distance(p, q) <= STEP * long;
        let ends = step(last, first) && (closed || distance(first, last) <= ROUND * long);
        let all = fits && points.windows(2).all(|w| step(w[0].0, w[1].0));
        if !(all && ends && short >= STOUT * long) {
            return None;
        }
        // The square root of the inverse, by Cholesky.
        let [p, q, r] = [yy, -xy, xx].map(|part| part / (grown * determinant));
        let a = p.sqrt();
        let b = q / a;
        let inverse = [a, b, 0.0, (r - b * b).sqrt()];
        Some(Self { centre, inverse, radius: (long * short).sqrt(), reach: long })
    }
}

/// The middle of the area within an outline, and its second moments about that, for each unit of area.
fn moments(points: &[(Point, bool)], origin: Point) -> Option<(Point, [f64; 3])> {
    let places: Vec<[f64; 2]> = points.iter().map(|p| [p.0.x - origin.x, p.0.y - origin.y]).collect();
    let mut sums = [0.0; 6];
    for (i, &[x, y]) in places.iter().enumerate() {
        let [u, v] = places[(i + 1) % places.len()];
        let cross = x * v - u * y;
        let parts = [
            0.5,
            (x + u) / 6.0,
            (y + v) / 6.0,
            (x * x + x * u + u * u) / 12.0,
            (2.0 * x * y + x * v + u * y + 2.0 * u * v) / 24.0,
            (y * y + y * v + v * v) / 12.0,
        ];
        sums.iter_mut().zip(parts).for_each(|(sum, part)| *sum += cross * part);
    }
    let [area, rest @ ..] = sums;
    let [x, y, xx, xy, yy] = rest.map(|sum| sum / area);
    let moments = [xx - x * x, xy - x * y, yy - y * y];
    moments.iter().all(|part| part.is_finite()).then(|| (Point::new(origin.x + x, origin.y + y), moments))
}
