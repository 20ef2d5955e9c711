//! Points, boxes and distances of the canvas: x to the right, y DOWN, lengths in px.
//!
//! ```text
//!        left(u) = (u.y, -u.x)
//!            ^
//!            │          The plane's y points up, the canvas' y points down. The flip is done once, in the
//!       ●────┴───> u    numbers, so that "left of travel" looks the same on paper as in the structure.
//! ```
//!
//! Only `+ - * /` and `sqrt` are used: they give the same bits on every platform.

use std::ops::{Add, Mul, Sub};

/// A point or a vector of the canvas.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub(crate) struct Xy {
    pub(crate) x: f64,
    pub(crate) y: f64,
}

pub(crate) const fn xy(x: f64, y: f64) -> Xy {
    Xy { x, y }
}

impl Add for Xy {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        xy(self.x + other.x, self.y + other.y)
    }
}

impl Sub for Xy {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        xy(self.x - other.x, self.y - other.y)
    }
}

impl Mul<f64> for Xy {
    type Output = Self;
    fn mul(self, factor: f64) -> Self {
        xy(self.x * factor, self.y * factor)
    }
}

impl Xy {
    pub(crate) fn dot(self, other: Self) -> f64 {
        self.x * other.x + self.y * other.y
    }

    /// Positive if `other` lies to the LEFT of this direction as one sees it on the canvas.
    pub(crate) fn turn(self, other: Self) -> f64 {
        self.y * other.x - self.x * other.y
    }

    pub(crate) fn length(self) -> f64 {
        self.dot(self).sqrt()
    }

    /// The direction, or `None` for a vector too short to have one.
    pub(crate) fn unit(self) -> Option<Self> {
        let length = self.length();
        (length > 1e-9).then(|| self * (1.0 / length))
    }

    /// A quarter turn to the left.
    pub(crate) const fn left(self) -> Self {
        xy(self.y, -self.x)
    }

    /// A number that grows with the counter-clockwise angle from the positive x axis, from 0 up to 4.
    pub(crate) fn pseudo_angle(self) -> f64 {
        let p = self.x / (self.x.abs() + self.y.abs());
        if self.y <= 0.0 { 1.0 - p } else { 3.0 + p }
    }
}

/// A box with sides along the axes.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Bounds {
    pub(crate) min: Xy,
    pub(crate) max: Xy,
}

impl Bounds {
    pub(crate) fn around(centre: Xy, half_width: f64, half_height: f64) -> Self {
        let half = xy(half_width, half_height);
        Self { min: centre - half, max: centre + half }
    }

    /// The smallest box round all points; `None` without points.
    pub(crate) fn of(points: impl IntoIterator<Item = Xy>) -> Option<Self> {
        points.into_iter().fold(None, |bounds: Option<Self>, p| {
            let b = bounds.unwrap_or(Self { min: p, max: p });
            Some(Self { min: xy(b.min.x.min(p.x), b.min.y.min(p.y)), max: xy(b.max.x.max(p.x), b.max.y.max(p.y)) })
        })
    }

    /// Its four corners, one after the other.
    pub(crate) const fn corners(&self) -> [Xy; 4] {
        let Self { min, max } = *self;
        [min, xy(max.x, min.y), max, xy(min.x, max.y)]
    }

    pub(crate) fn size(&self) -> Xy {
        self.max - self.min
    }

    pub(crate) fn centre(&self) -> Xy {
        (self.min + self.max) * 0.5
    }

    pub(crate) fn grown(&self, by: f64) -> Self {
        Self { min: self.min - xy(by, by), max: self.max + xy(by, by) }
    }

    pub(crate) fn overlaps(&self, other: &Self) -> bool {
        self.min.x < other.max.x && other.min.x < self.max.x && self.min.y < other.max.y && other.min.y < self.max.y
    }

    pub(crate) fn contains(&self, inner: &Self) -> bool {
        self.min.x <= inner.min.x && inner.max.x <= self.max.x && self.min.y <= inner.min.y && inner.max.y <= self.max.y
    }

    /// Distance from `p` to the box; 0 inside.
    pub(crate) fn distance(&self, p: Xy) -> f64 {
        let dx = (self.min.x - p.x).max(p.x - self.max.x).max(0.0);
        let dy = (self.min.y - p.y).max(p.y - self.max.y).max(0.0);
        xy(dx, dy).length()
    }

    /// Whether the segment meets the box (clipping of the segment by the four sides, Liang and Barsky 1984).
    pub(crate) fn meets_segment(&self, a: Xy, b: Xy) -> bool {
        let d = b - a;
        let (mut enter, mut leave) = (0.0f64, 1.0f64);
        for (step, low, high) in [(d.x, self.min.x - a.x, self.max.x - a.x), (d.y, self.min.y - a.y, self.max.y - a.y)]
        {
            if step == 0.0 {
                if low > 0.0 || high < 0.0 {
                    return false;
                }
                continue;
            }
            let (near, far) = if step > 0.0 { (low / step, high / step) } else { (high / step, low / step) };
            enter = enter.max(near);
            leave = leave.min(far);
        }
        enter <= leave
    }
}

/// Distance from `p` to the segment `a b`.
pub(crate) fn segment_distance(p: Xy, a: Xy, b: Xy) -> f64 {
    let d = b - a;
    let length2 = d.dot(d);
    let t = if length2 > 0.0 { ((p - a).dot(d) / length2).clamp(0.0, 1.0) } else { 0.0 };
    (p - (a + d * t)).length()
}

/// Twice the signed area of a closed polygon, positive if it runs counter-clockwise as seen on the canvas.
pub(crate) fn doubled_area(points: &[Xy]) -> f64 {
    let Some(&base) = points.first() else { return 0.0 };
    points.windows(2).map(|w| (w[0] - base).turn(w[1] - base)).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn left_is_left_on_a_canvas_whose_y_points_down() {
        let east = xy(1.0, 0.0);
        assert_eq!(east.left(), xy(0.0, -1.0));
        assert!(east.turn(east.left()) > 0.0);
        let square = [xy(0.0, 10.0), xy(10.0, 10.0), xy(10.0, 0.0), xy(0.0, 0.0)];
        assert_eq!(doubled_area(&square).to_bits(), 200f64.to_bits());
    }

    #[test]
    fn pseudo_angles_grow_counter_clockwise() {
        let round =
            [(1.0, 0.0), (1.0, -1.0), (0.0, -1.0), (-1.0, -1.0), (-1.0, 0.0), (-1.0, 1.0), (0.0, 1.0), (1.0, 1.0)];
        let angles: Vec<f64> = round.iter().map(|&(x, y)| xy(x, y).pseudo_angle()).collect();
        assert!(angles.windows(2).all(|w| w[0] < w[1]), "{angles:?}");
    }

    #[test]
    fn a_segment_that_passes_a_corner_does_not_meet_the_box() {
        let b = Bounds::around(xy(0.0, 0.0), 1.0, 1.0);
        assert!(!b.meets_segment(xy(0.0, 3.0), xy(3.0, 0.0)));
        assert!(b.meets_segment(xy(0.0, 1.5), xy(1.5, 0.0)));
        assert!(b.meets_segment(xy(-5.0, 0.0), xy(5.0, 0.0)));
        assert!(!b.meets_segment(xy(-5.0, 2.0), xy(5.0, 2.0)));
    }
}
