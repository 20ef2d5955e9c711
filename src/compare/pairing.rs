//! Which point is which: by place, within a tolerance.
//!
//! ```text
//!   expected  ● ● ●   ●         each found point takes the expected point at its place;
//!   found     × × ×  ×          of what is left, nearest neighbours are pairs that have moved
//! ```

use crate::geometry::interval::range;
use crate::geometry::point::corners;
use crate::plane::Point;
use std::collections::BTreeMap;

/// Pairs that have moved are looked for among at most this many points.
const LEFT: usize = 300;
/// How far a vertex may have moved, as a part of the whole.
const STRAYED: f64 = 0.15;

/// Points lie next to each other within this part of a size.
pub(super) const NEXT: f64 = 0.02;

/// Points in buckets of a size, to be found by place.
pub(super) struct Places {
    size: f64,
    buckets: BTreeMap<(i64, i64), Vec<u32>>,
    points: Vec<Point>,
}

impl Places {
    /// No points yet; questions reach at most `size` far.
    pub(super) fn new(size: f64) -> Self {
        Self { size: if size > 0.0 { size } else { 1.0 }, buckets: BTreeMap::new(), points: Vec::new() }
    }

    /// All these points, numbered as they come.
    pub(super) fn of(points: &[Point], size: f64) -> Self {
        let mut out = Self::new(size);
        for &p in points {
            out.add(p);
        }
        out
    }

    /// These points, but for those that lie next to an earlier one: to ask whether there are any, however many lie at one
    /// place.
    pub(super) fn thinned(points: impl IntoIterator<Item = Point>, size: f64) -> Self {
        let mut out = Self::new(size);
        for p in points {
            out.near_or_add(p, NEXT * size);
        }
        out
    }

    fn bucket(&self, x: f64) -> i64 {
        (x / self.size).floor() as i64
    }

    /// Adds a point and returns its number: they count from 0.
    pub(super) fn add(&mut self, p: Point) -> u32 {
        let number = self.points.len() as u32;
        let key = (self.bucket(p.x), self.bucket(p.y));
        self.buckets.entry(key).or_default().push(number);
        self.points.push(p);
        number
    }

    /// The nearest point within `reach`, which is at most the size.
    pub(super) fn near(&self, p: Point, reach: f64) -> Option<u32> {
        let mut best: Option<(f64, u32)> = None;
        for i in self.bucket(p.x - reach)..=self.bucket(p.x + reach) {
            for j in self.bucket(p.y - reach)..=self.bucket(p.y + reach) {
                for &number in self.buckets.get(&(i, j)).into_iter().flatten() {
                    let d = distance(self.points[number as usize], p);
                    if d <= reach && best.is_none_or(|(other, _)| d < other) {
                        best = Some((d, number));
                    }
                }
            }
        }
        best.map(|(_, number)| number)
    }

    /// The point within `reach`, or a new one.
    pub(super) fn near_or_add(&mut self, p: Point, reach: f64) -> u32 {
        self.near(p, reach).unwrap_or_else(|| self.add(p))
    }

    pub(super) fn points(&self) -> &[Point] {
        &self.points
    }
}

pub(super) fn distance(a: Point, b: Point) -> f64 {
    let (x, y) = (a.x - b.x, a.y - b.y);
    (x * x + y * y).sqrt()
}

/// The sides of a ring: from each corner to the next.
pub(super) fn ring_sides<T: Copy>(ring: &[T]) -> impl Iterator<Item = [T; 2]> + '_ {
    ring.iter().zip(ring.iter().cycle().skip(1)).map(|(&a, &b)| [a, b])
}

/// The point half way between two others.
pub(super) fn middle([a, b]: [Point; 2]) -> Point {
    Point::new(0.5 * (a.x + b.x), 0.5 * (a.y + b.y))
}

/// The ends of an edge by other numbers, the smaller one first, if both have one.
pub(super) fn edge_by(edge: [u32; 2], numbers: &[Option<u32>]) -> Option<[u32; 2]> {
    let [a, b] = edge.map(|v| numbers[v as usize]);
    a.zip(b).map(|(a, b)| [a.min(b), a.max(b)])
}

/// A point by its bits: corners of one outline are equal to the last.
pub(super) fn key(p: Point) -> [u64; 2] {
    [p.x, p.y].map(f64::to_bits)
}

/// How far a point is from a segment.
pub(super) fn distance_to(p: Point, [a, b]: [Point; 2]) -> f64 {
    let (x, y) = (b.x - a.x, b.y - a.y);
    let squared = x * x + y * y;
    if squared <= 0.0 {
        return distance(p, a);
    }
    let t = (((p.x - a.x) * x + (p.y - a.y) * y) / squared).clamp(0.0, 1.0);
    distance(p, Point::new(a.x + t * x, a.y + t * y))
}

/// Whether a point lies on a segment, within the tolerance.
pub(super) fn lies_on(p: Point, segment: [Point; 2], tolerance: f64) -> bool {
    distance_to(p, segment) <= tolerance
}

/// The sides of the box round some places.
pub(super) fn sides(places: &[[f64; 2]]) -> [f64; 2] {
    [0, 1].map(|i| {
        let [low, high] = range(places.iter().map(|place| place[i]));
        high - low
    })
}

/// The longer side of the box round all points.
pub(super) fn span(points: &[Point]) -> f64 {
    let [low, high] = corners(points.iter().copied());
    (high.x - low.x).max(high.y - low.y).max(0.0)
}

/// Pairs of points that are left over on both sides and nearest to each other, by position in the two lists.
/// `span` is the size of the whole.
pub(super) fn strays(expected: &[Point], found: &[Point], span: f64) -> Vec<(usize, usize)> {
    if expected.len().max(found.len()) > LEFT {
        return Vec::new();
    }
    let nearest = |p: Point, among: &[Point]| {
        let by_distance = |a: &usize, b: &usize| distance(p, among[*a]).total_cmp(&distance(p, among[*b]));
        (0..among.len()).min_by(by_distance)
    };
    let pairs = expected.iter().enumerate().filter_map(|(i, &p)| {
        let j = nearest(p, found)?;
        let mutual = nearest(found[j], expected) == Some(i) && distance(p, found[j]) <= STRAYED * span;
        mutual.then_some((i, j))
    });
    pairs.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_are_found_across_the_borders_of_buckets() {
        let mut places = Places::new(1.0);
        places.add(Point::new(0.99, 5.0));
        places.add(Point::new(-0.01, -0.01));
        assert_eq!(places.near(Point::new(1.01, 5.0), 0.03), Some(0));
        assert_eq!(places.near(Point::new(0.0, 0.0), 0.02), Some(1));
        assert_eq!(places.near(Point::new(0.0, 0.0), 0.01), None);
        assert_eq!(places.near_or_add(Point::new(0.98, 5.01), 0.05), 0);
    }

    #[test]
    fn only_mutual_neighbours_have_moved() {
        let p = |x: f64| Point::new(x, 0.0);
        assert_eq!(strays(&[p(0.0), p(10.0)], &[p(1.0)], 100.0), [(0, 0)]);
        assert_eq!(strays(&[p(0.0)], &[p(50.0)], 100.0), [], "too far");
    }
}
