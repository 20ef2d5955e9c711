//! Where there is ink already: a grid of buckets over the canvas.
//!
//! ```text
//!   ┌────┬────┬────┐
//!   │   \│    │    │     Every shape is listed in each bucket it touches. A question looks at the few
//!   ├────\────┼────┤     buckets under its own box only, so that placing labels is not quadratic.
//!   │    │\ ┌─┼─┐  │
//!   └────┴──\─┴─┴──┘
//! ```

use crate::figure::canvas::vector::{Bounds, Xy, segment_distance, xy};

/// Side of a bucket in px.
const CELL: f64 = 24.0;
/// No shape is fatter than this beyond its outline.
pub(crate) const FATTEST: f64 = 3.0;

/// A disc this near to the start of a way does not bar it.
const OWN: f64 = 6.0;
/// The number of ink that labels keep clear of although another drawing of the same layout shows it.
pub(crate) const INK: u32 = u32::MAX - 1;

/// Something drawn.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) enum Shape {
    /// A line with half its width.
    Segment(Xy, Xy, f64),
    Box(Bounds),
    Disc(Xy, f64),
}

impl Shape {
    fn bounds(&self) -> Bounds {
        match *self {
            Self::Segment(a, b, _) => {
                Bounds { min: xy(a.x.min(b.x), a.y.min(b.y)), max: xy(a.x.max(b.x), a.y.max(b.y)) }
            }
            Self::Box(bounds) => bounds,
            Self::Disc(centre, radius) => Bounds::around(centre, radius, radius),
        }
    }

    /// Distance from a point; 0 or less inside.
    pub(crate) fn distance(&self, p: Xy) -> f64 {
        match *self {
            Self::Segment(a, b, half_width) => segment_distance(p, a, b) - half_width,
            Self::Box(bounds) => bounds.distance(p),
            Self::Disc(centre, radius) => (p - centre).length() - radius,
        }
    }

    pub(crate) fn meets(&self, bounds: &Bounds) -> bool {
        match *self {
            Self::Segment(a, b, half_width) => bounds.grown(half_width).meets_segment(a, b),
            Self::Box(other) => bounds.overlaps(&other),
            Self::Disc(centre, radius) => bounds.distance(centre) < radius,
        }
    }
}

/// The shapes on a canvas, each with a number of the caller.
#[derive(Clone)]
pub(crate) struct Crowd {
    columns: usize,
    rows: usize,
    cells: Vec<Vec<u32>>,
    shapes: Vec<(Shape, u32)>,
}

impl Crowd {
    pub(crate) fn new(size: Xy) -> Self {
        let count = |length: f64| (length / CELL) as usize + 1;
        let (columns, rows) = (count(size.x), count(size.y));
        Self { columns, rows, cells: vec![Vec::new(); columns * rows], shapes: Vec::new() }
    }

    fn column(&self, x: f64) -> usize {
        ((x / CELL).max(0.0) as usize).min(self.columns - 1)
    }

    fn row(&self, y: f64) -> usize {
        ((y / CELL).max(0.0) as usize).min(self.rows - 1)
    }

    /// Adds a shape. O(buckets it touches).
    pub(crate) fn add(&mut self, shape: Shape, tag: u32) {
        let number = self.shapes.len() as u32;
        self.shapes.push((shape, tag));
        self.each_bucket(shape, |bucket| bucket.push(number));
    }

    /// Adds shapes with one tag.
    pub(crate) fn add_all(&mut self, shapes: impl IntoIterator<Item = Shape>, tag: u32) {
        shapes.into_iter().for_each(|shape| self.add(shape, tag));
    }

    /// The number of shapes.
    pub(crate) fn len(&self) -> usize {
        self.shapes.len()
    }

    /// Takes the latest shapes away until `len` are left. O(buckets they touch).
    pub(crate) fn truncate(&mut self, len: usize) {
        while self.shapes.len() > len {
            if let Some((shape, _)) = self.shapes.pop() {
                self.each_bucket(shape, |bucket| bucket.truncate(bucket.len() - 1));
            }
        }
    }

    fn each_bucket(&mut self, shape: Shape, mut visit: impl FnMut(&mut Vec<u32>)) {
        let bounds = shape.bounds();
        for row in self.row(bounds.min.y)..=self.row(bounds.max.y) {
            let (left, right) = match shape {
                Shape::Segment(a, b, _) => band(a, b, row as f64 * CELL),
                _ => (bounds.min.x, bounds.max.x),
            };
            for column in self.column(left)..=self.column(right) {
                visit(&mut self.cells[row * self.columns + column]);
            }
        }
    }

    /// The shapes in the buckets under `bounds`; a shape may come several times.
    fn under(&self, bounds: &Bounds) -> impl Iterator<Item = &(Shape, u32)> {
        self.numbers_under(bounds).map(|number| &self.shapes[number as usize])
    }

    fn numbers_under(&self, bounds: &Bounds) -> impl Iterator<Item = u32> {
        let bounds = bounds.grown(FATTEST);
        let (left, right) = (self.column(bounds.min.x), self.column(bounds.max.x));
        (self.row(bounds.min.y)..=self.row(bounds.max.y))
            .flat_map(move |row| &self.cells[row * self.columns + left..=row * self.columns + right])
            .flatten()
            .copied()
    }

    /// All shapes with this tag that may touch `bounds`, each once, in the order in which they were added.
    pub(crate) fn tagged(&self, bounds: &Bounds, tag: u32) -> Vec<Shape> {
        let mut numbers: Vec<u32> = self.numbers_under(bounds).filter(|&i| self.shapes[i as usize].1 == tag).collect();
        numbers.sort_unstable();
        numbers.dedup();
        numbers.into_iter().map(|i| self.shapes[i as usize].0).collect()
    }

    /// A shape that a box would cover.
    pub(crate) fn blocker(&self, bounds: &Bounds) -> Option<Shape> {
        self.under(bounds).map(|&(shape, _)| shape).find(|shape| shape.meets(bounds))
    }

    /// Whether a box of this half size has a place here: inside of a frame, with some air to every shape.
    pub(crate) fn has_room(&self, at: Xy, half: Xy, frame: &Bounds, air: f64) -> bool {
        let bounds = Bounds::around(at, half.x, half.y);
        frame.contains(&bounds) && self.blocker(&bounds.grown(air)).is_none()
    }

    /// The distance from `p` to the nearest shape whose tag passes, if that is below `limit`; else `limit`.
    pub(crate) fn nearest(&self, p: Xy, limit: f64, passes: impl Fn(u32) -> bool) -> f64 {
        self.under(&Bounds::around(p, limit, limit))
            .filter(|&&(_, tag)| passes(tag))
            .map(|(shape, _)| shape.distance(p))
            .fold(limit, f64::min)
    }

    /// How many lines the way from `p` to `q` crosses; `None` if it meets a box, or a disc that is not beside `p`.
    pub(crate) fn crossings(&self, p: Xy, q: Xy) -> Option<usize> {
        let way = Shape::Segment(p, q, 0.0).bounds();
        let mut crossed = Vec::new();
        for (shape, _) in self.under(&way) {
            match *shape {
                Shape::Segment(a, b, _) if crossing(p, q, a, b).is_some() => crossed.push(std::ptr::from_ref(shape)),
                Shape::Segment(..) => {}
                Shape::Box(bounds) if bounds.meets_segment(p, q) => return None,
                Shape::Disc(centre, radius)
                    if segment_distance(centre, p, q) < radius && (centre - p).length() > radius + OWN =>
                {
                    return None;
                }
                Shape::Box(_) | Shape::Disc(..) => {}
            }
        }
        crossed.sort_unstable();
        crossed.dedup();
        Some(crossed.len())
    }

    /// How far one can go from `p` to `q` before crossing a line whose tag passes: 1 = all the way.
    pub(crate) fn free_part(&self, p: Xy, q: Xy, passes: impl Fn(u32) -> bool) -> f64 {
        let way = Shape::Segment(p, q, 0.0).bounds();
        let crossing = |&(shape, tag): &(Shape, u32)| match shape {
            Shape::Segment(a, b, _) if passes(tag) => crossing(p, q, a, b),
            _ => None,
        };
        self.under(&way).filter_map(crossing).fold(1.0, f64::min)
    }
}

/// The x range of the segment within the row of buckets that begins at `top`.
fn band(a: Xy, b: Xy, top: f64) -> (f64, f64) {
    let (a, b) = if a.y <= b.y { (a, b) } else { (b, a) };
    let height = b.y - a.y;
    let at = |y: f64| if height > 0.0 { a.x + (b.x - a.x) * ((y - a.y) / height).clamp(0.0, 1.0) } else { a.x };
    if height <= 0.0 {
        return (a.x.min(b.x), a.x.max(b.x));
    }
    let (first, last) = (at(top), at(top + CELL));
    (first.min(last), first.max(last))
}

/// The parameter along `p q` at which it meets the segment `a b`.
fn crossing(p: Xy, q: Xy, a: Xy, b: Xy) -> Option<f64> {
    let (way, line) = (q - p, b - a);
    let across = way.turn(line);
    if across == 0.0 {
        return None;
    }
    let t = (a - p).turn(line) / across;
    let s = (a - p).turn(way) / across;
    ((0.0..=1.0).contains(&t) && (0.0..=1.0).contains(&s)).then_some(t)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_long_diagonal_is_found_wherever_it_passes_and_nowhere_else() {
        let mut crowd = Crowd::new(xy(500.0, 300.0));
        let (a, b) = (xy(10.0, 290.0), xy(490.0, 20.0));
        crowd.add(Shape::Segment(a, b, 1.0), 7);
        for i in 0..=40 {
            let on = a + (b - a) * (f64::from(i) / 40.0);
            assert!(crowd.blocker(&Bounds::around(on, 2.0, 2.0)).is_some(), "{on:?}");
            assert!(crowd.blocker(&Bounds::around(on + xy(20.0, 20.0), 2.0, 2.0)).is_none(), "{on:?}");
        }
        assert_eq!(crowd.nearest(xy(10.0, 280.0), 50.0, |tag| tag != 7).to_bits(), 50f64.to_bits());
        assert!(crowd.nearest(xy(10.0, 280.0), 50.0, |tag| tag == 7) < 10.0);
    }

    #[test]
    fn ink_is_found_once_and_without_what_is_not_ink() {
        let mut crowd = Crowd::new(xy(500.0, 300.0));
        let line = |y: f64| Shape::Segment(xy(0.0, y), xy(500.0, y), 1.0);
        for (y, tag) in [(60.0, INK), (61.0, 4), (59.0, INK), (250.0, INK)] {
            crowd.add(line(y), tag);
        }
        assert_eq!(crowd.tagged(&Bounds::around(xy(250.0, 60.0), 200.0, 5.0), INK), [line(60.0), line(59.0)]);
    }

    #[test]
    fn the_free_part_of_a_way_ends_at_the_first_line() {
        let mut crowd = Crowd::new(xy(200.0, 200.0));
        for x in [80.0, 60.0, 150.0] {
            crowd.add(Shape::Segment(xy(x, 0.0), xy(x, 200.0), 0.5), x as u32);
        }
        let part = |skip| crowd.free_part(xy(10.0, 100.0), xy(110.0, 100.0), |tag| tag != skip);
        assert!((part(0) - 0.5).abs() < 1e-12);
        assert!((part(60) - 0.7).abs() < 1e-12);
    }
}
