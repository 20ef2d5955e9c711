//! Where lines and barbs lie along an edge.
//!
//! ```text
//!   v0 ●───────────────● v1        places: how far along the edge, and how far to the left of it, as parts of it
//!         ──────────▸              a barb: its tip at the end of its line, its outer corner behind that
//! ```

use super::pairing::{distance, sides};
use crate::plane::Point;

/// How far a line may lie from its edge, and its ends from each other across the edge, as parts of the edge.
const ASIDE: f64 = 0.25;
const SLANT: f64 = 0.05;
/// How far it may reach beyond the edge, as a part of it.
const BEYOND: f64 = 0.02;
/// How far the tip of a barb may lie from the end of its line: behind it, before it, and across, as parts of its size.
/// Many programs end the line at the base of the barb.
const TIP: [f64; 3] = [0.25, 1.1, 0.5];
/// The outer corner of a barb lies at least so far behind the tip, as a part of what lies across, the line's own width
/// left out.
const SLIM: f64 = 0.35;
/// A barb stands in the middle of its line if it is no farther from there than its own size and this part of the line.
const MIDDLE: f64 = 0.1;
/// A barb lies on the side of its edge if it reaches so many times as far to that side of its line as to the other.
const INSIDE: f64 = 1.5;

/// An edge on the canvas, along one of its half-edges.
pub(super) struct Along {
    from: Point,
    direction: [f64; 2],
    pub(super) length: f64,
}

impl Along {
    pub(super) fn new(from: Point, to: Point) -> Option<Self> {
        let length = distance(from, to);
        let direction = [(to.x - from.x) / length, (to.y - from.y) / length];
        (length > 0.0).then_some(Self { from, direction, length })
    }

    /// Where a point lies along the edge and to the left of it, as parts of the edge.
    pub(super) fn place(&self, p: Point) -> [f64; 2] {
        let (x, y, [u, v]) = (p.x - self.from.x, p.y - self.from.y, self.direction);
        [(x * u + y * v) / self.length, (y * u - x * v) / self.length]
    }

    /// The point of such a place.
    pub(super) fn point(&self, [t, a]: [f64; 2]) -> Point {
        let ([u, v], length) = (self.direction, self.length);
        Point::new(self.from.x + length * (t * u - a * v), self.from.y + length * (t * v + a * u))
    }

    /// Whether a line runs beside the middle of the edge, on the left, and no further than its ends.
    pub(super) fn has_beside(&self, ends: [Point; 2]) -> bool {
        let [[t, a], [s, b]] = ends.map(|p| self.place(p));
        let (first, last) = (t.min(s), t.max(s));
        let lies_along = (-BEYOND..0.5).contains(&first) && (0.5..=1.0 + BEYOND).contains(&last);
        lies_along && a.min(b) > 0.0 && a.max(b) <= ASIDE && (a - b).abs() <= SLANT
    }

    /// How far a line lies from the edge, on the canvas.
    pub(super) fn distance(&self, ends: [Point; 2]) -> f64 {
        let [[_, a], [_, b]] = ends.map(|p| self.place(p));
        0.5 * (a + b) * self.length
    }

    /// Where the end of a line lies.
    fn front(&self, line: Stroke) -> [f64; 2] {
        let [start, end] = line.ends.map(|p| self.place(p));
        if end[0] > start[0] { end } else { start }
    }

    /// Whether a barb belongs to a line, and does not lie on its right.
    pub(super) fn has_barb(&self, line: Stroke, corners: &[Point]) -> bool {
        self.has_barb_before(self.front(line), line.half, corners)
    }

    /// The same for a barb that stands in the middle of its line.
    pub(super) fn has_middle_barb(&self, line: Stroke, corners: &[Point]) -> bool {
        let places = self.places(corners);
        let [[t, a], [s, b]] = line.ends.map(|p| self.place(p));
        let tip = places.iter().map(|place| place[0]).fold(f64::NEG_INFINITY, f64::max);
        let [long, wide] = sides(&places);
        let is_middle = (tip - 0.5 * (t + s)).abs() <= long.max(wide) + MIDDLE * (t - s).abs();
        is_middle && self.has_barb_before([tip, 0.5 * (a + b)], line.half, corners)
    }

    /// Whether a barb would belong to a line that ran the other way, on either side of it.
    pub(super) fn has_barb_back(&self, line: Stroke, corners: &[Point]) -> bool {
        let [start, end] = line.ends.map(|p| self.place(p));
        let back = if end[0] > start[0] { start } else { end };
        [1.0, -1.0].iter().any(|side| {
            let turned = |[t, a]: [f64; 2]| [1.0 - t, side * a];
            let places: Vec<[f64; 2]> = self.places(corners).into_iter().map(turned).collect();
            self.has_barb_at(turned(back), line.half, &places)
        })
    }

    /// Whether a barb would belong to a line if it lay on the other side of it: it reaches no farther aside than back,
    /// and its outer corner is the hindmost one.
    pub(super) fn has_turned_barb(&self, line: Stroke, corners: &[Point]) -> bool {
        let front = self.front(line);
        let places: Vec<[f64; 2]> = self.places(corners).into_iter().map(|[t, a]| [t, 2.0 * front[1] - a]).collect();
        let [long, wide] = sides(&places);
        let hindmost = places.iter().min_by(|p, q| p[0].total_cmp(&q[0]));
        let is_outer = hindmost.is_some_and(|hindmost| places.iter().all(|place| place[1] <= hindmost[1]));
        is_outer && wide <= long && self.has_barb_at(front, line.half, &places)
    }

    /// Whether a barb belongs to a line that ends here, and does not lie on its right.
    fn has_barb_before(&self, front: [f64; 2], half: f64, corners: &[Point]) -> bool {
        let places = self.places(corners);
        let far = |sign: f64| places.iter().map(|p| sign * (p[1] - front[1])).fold(f64::NEG_INFINITY, f64::max);
        far(-1.0) <= INSIDE * far(1.0) && self.has_barb_at(front, half, &places)
    }

    /// Whether a barb belongs to a line of this half width that ends here: its foremost corner is its tip and lies there,
    /// and the corner farthest to the left lies behind that and beyond the line.
    fn has_barb_at(&self, front: [f64; 2], half: f64, places: &[[f64; 2]]) -> bool {
        let most = |i: usize| places.iter().max_by(|p, q| p[i].total_cmp(&q[i]));
        let (Some(tip), Some(outer)) = (most(0), most(1)) else { return false };
        let [long, wide] = sides(places);
        let size = long.max(wide);
        let [ahead, across] = [0, 1].map(|i| tip[i] - front[i]);
        let is_at_end = ahead >= -TIP[0] * size && ahead <= TIP[1] * size && across.abs() <= TIP[2] * size;
        let is_within = tip[0] <= 1.0 + BEYOND;
        let is_behind = outer[0] < tip[0] && tip[0] - outer[0] >= SLIM * (wide - 4.0 * half / self.length);
        let is_aside = outer[1] > front[1] && outer[1] <= 2.0 * ASIDE + 2.0 / self.length;
        is_at_end && is_within && is_behind && is_aside
    }

    fn places(&self, corners: &[Point]) -> Vec<[f64; 2]> {
        corners.iter().map(|&p| self.place(p)).collect()
    }

    /// The size of a barb on the canvas, along the edge or across it.
    pub(super) fn size(&self, corners: &[Point]) -> f64 {
        let [long, wide] = sides(&self.places(corners));
        long.max(wide) * self.length
    }
}

/// A line on the canvas, with half its width.
#[derive(Clone, Copy)]
pub(super) struct Stroke {
    pub(super) ends: [Point; 2],
    pub(super) half: f64,
}
