//! Lines cut at the points they pass, by a grid over the points.
//!
//! ```text
//!   a ──●───●── b        one line through two points is three edges
//! ```

use super::pairing::{distance, lies_on};
use crate::plane::Point;

/// Work of one comparison: cells and points looked at. Drawings that need more are refused.
pub(super) const WORK: usize = 60_000_000;
/// Cells of a side.
const SIDE: f64 = 700.0;

/// Points in the cells of a grid.
pub(super) struct Grid {
    corner: Point,
    size: f64,
    columns: usize,
    rows: usize,
    /// Where the points of each cell begin in `order`.
    starts: Vec<u32>,
    order: Vec<u32>,
    work: usize,
}

impl Grid {
    /// O(points + cells), about as many cells as points.
    pub(super) fn new(points: &[Point]) -> Self {
        let low = points.iter().fold([f64::INFINITY; 2], |l, p| [l[0].min(p.x), l[1].min(p.y)]);
        let high = points.iter().fold([f64::NEG_INFINITY; 2], |h, p| [h[0].max(p.x), h[1].max(p.y)]);
        let sides = [0, 1].map(|i| (high[i] - low[i]).max(0.0));
        let cells = (points.len() as f64).sqrt().clamp(1.0, SIDE);
        let size = (sides[0].max(sides[1]) / cells).max(f64::MIN_POSITIVE);
        let count = |side: f64| ((side / size) as usize + 1).min(SIDE as usize + 2);
        let mut out = Self {
            corner: Point::new(low[0], low[1]),
            size,
            columns: count(sides[0]),
            rows: count(sides[1]),
            starts: Vec::new(),
            order: vec![0; points.len()],
            work: 0,
        };
        let cells: Vec<usize> = points.iter().map(|p| out.row(p.y) * out.columns + out.column(p.x)).collect();
        let mut starts = vec![0u32; out.columns * out.rows + 1];
        cells.iter().for_each(|&cell| starts[cell + 1] += 1);
        (0..out.columns * out.rows).for_each(|cell| starts[cell + 1] += starts[cell]);
        let mut next = starts.clone();
        for (i, &cell) in cells.iter().enumerate() {
            out.order[next[cell] as usize] = i as u32;
            next[cell] += 1;
        }
        out.starts = starts;
        out
    }

    fn column(&self, x: f64) -> usize {
        (((x - self.corner.x) / self.size).max(0.0) as usize).min(self.columns - 1)
    }

    fn row(&self, y: f64) -> usize {
        (((y - self.corner.y) / self.size).max(0.0) as usize).min(self.rows - 1)
    }

    /// The points, those the grid was made of, on the segment within the tolerance, in their order from its start; `None` if that takes too much
    /// work altogether.
    pub(super) fn along(&mut self, points: &[Point], [a, b]: [Point; 2], tolerance: f64) -> Option<Vec<u32>> {
        let mut hits = Vec::new();
        let (low, high) = if a.y <= b.y { (a, b) } else { (b, a) };
        for row in self.row(low.y - tolerance)..=self.row(high.y + tolerance) {
            // The part of the segment in this row, and a bit more.
            let bottom = self.corner.y + row as f64 * self.size - tolerance;
            let at = |y: f64| {
                let height = high.y - low.y;
                let t = if height > 0.0 { ((y - low.y) / height).clamp(0.0, 1.0) } else { 0.0 };
                low.x + t * (high.x - low.x)
            };
            let ends = if high.y - low.y > 0.0 {
                [at(bottom), at(bottom + self.size + 2.0 * tolerance)]
            } else {
                [low.x, high.x]
            };
            let (left, right) = (ends[0].min(ends[1]) - tolerance, ends[0].max(ends[1]) + tolerance);
            for column in self.column(left)..=self.column(right) {
                let cell = row * self.columns + column;
                let range = self.starts[cell] as usize..self.starts[cell + 1] as usize;
                self.work += 1 + range.len();
                let inside = self.order[range].iter().filter(|&&i| lies_on(points[i as usize], [a, b], tolerance));
                hits.extend(inside.copied());
            }
            if self.work > WORK {
                return None;
            }
        }
        hits.sort_by(|&i, &j| {
            let far = |i: u32| distance(a, points[i as usize]);
            far(i).total_cmp(&far(j)).then(i.cmp(&j))
        });
        hits.dedup();
        Some(hits)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_in_all_directions_pass_the_points_that_brute_force_finds() {
        let points: Vec<Point> = (0..400).map(|i| Point::new(f64::from(i % 20), f64::from(i / 20))).collect();
        let mut grid = Grid::new(&points);
        for (a, b) in [
            ((0.0, 0.0), (19.0, 19.0)),
            ((19.0, 3.0), (1.0, 12.0)),
            ((5.0, 0.0), (5.0, 19.0)),
            ((2.0, 7.0), (30.0, 7.0)),
        ] {
            let ends = [Point::new(a.0, a.1), Point::new(b.0, b.1)];
            let mut hits = grid.along(&points, ends, 1e-6).unwrap();
            assert!(
                hits.windows(2)
                    .all(|w| distance(ends[0], points[w[0] as usize]) < distance(ends[0], points[w[1] as usize]))
            );
            hits.sort_unstable();
            let brute: Vec<u32> = (0..400).filter(|&i| lies_on(points[i as usize], ends, 1e-6)).collect();
            assert_eq!(hits, brute, "{ends:?}");
            assert!(hits.len() > 2);
        }
    }
}
