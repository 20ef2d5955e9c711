//! Lines cut at the points they pass, by a grid over the points.
//!
//! ```text
//!   a ──●───●── b        one line through two points is three edges
//! ```

use super::pairing::{distance, lies_on};
use crate::geometry::grouping::Groups;
use crate::geometry::point::corners;
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
    cells: Groups<u32>,
    work: usize,
}

impl Grid {
    /// O(points + cells), about as many cells as points.
    pub(super) fn new(points: &[Point]) -> Self {
        let [corner, high] = corners(points.iter().copied());
        let sides = [high.x - corner.x, high.y - corner.y].map(|side| side.max(0.0));
        let cells = (points.len() as f64).sqrt().clamp(1.0, SIDE);
        let size = (sides[0].max(sides[1]) / cells).max(f64::MIN_POSITIVE);
        let count = |side: f64| ((side / size) as usize + 1).min(SIDE as usize + 2);
        let mut out = Self {
            corner,
            size,
            columns: count(sides[0]),
            rows: count(sides[1]),
            cells: Groups::new(0, std::iter::empty()),
            work: 0,
        };
        let cell = |p: &Point| out.row(p.y) * out.columns + out.column(p.x);
        out.cells = Groups::new(out.columns * out.rows, points.iter().map(cell).zip(0..));
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
                let near = self.cells.of(cell);
                self.work += 1 + near.len();
                hits.extend(near.iter().filter(|&&i| lies_on(points[i as usize], [a, b], tolerance)));
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
