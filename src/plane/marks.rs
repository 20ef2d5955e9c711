//! Boxes marked in a coarse grid: what none of them can meet is told at once.
//!
//! ```text
//!   ┌───┬───┬───┬───┐
//!   │▒▒▒│▒▒▒│   │   │      A box marks all cells that it meets. What lies in cells without a mark meets no box.
//!   ├───┼───┼───┼───┤
//!   │▒▒▒│▒▒▒│   │ p │
//!   └───┴───┴───┴───┘
//! ```

use super::Point;
use crate::geometry::both::of_both;
use std::ops::Range;

/// So many times as many marks as there are cells; then everything counts as marked.
const MOST: usize = 64;

/// A grid with the cells that boxes meet.
pub(super) struct Marks {
    low: Point,
    scale: [f64; 2],
    side: usize,
    is_marked: Vec<bool>,
    /// So many marks are left.
    left: usize,
}

impl Marks {
    /// So many columns and rows over a box, given by its corners; no marks. `side` is not 0.
    pub(super) fn new([low, high]: [Point; 2], side: usize) -> Self {
        let scale = of_both([high.x - low.x, high.y - low.y], |size| if size > 0.0 { side as f64 / size } else { 0.0 });
        Self { low, scale, side, is_marked: vec![false; side * side], left: MOST * side * side }
    }

    /// The columns and the rows of a box. Monotone, so that boxes with a point in common have a cell in common; a cast takes
    /// what is no number for 0.
    #[inline]
    fn cells(&self, bounds: [Point; 2]) -> [Range<usize>; 2] {
        let at = |x: f64, low: f64, scale: f64| (((x - low) * scale) as usize).min(self.side - 1);
        let column = |p: Point| at(p.x, self.low.x, self.scale[0]);
        let row = |p: Point| at(p.y, self.low.y, self.scale[1]);
        let [low, high] = bounds;
        [column(low)..column(high) + 1, row(low)..row(high) + 1]
    }

    /// Marks the cells of a box. Cost: O(cells), over all boxes at most 64 times the grid.
    pub(super) fn mark(&mut self, bounds: [Point; 2]) {
        let [columns, rows] = self.cells(bounds);
        self.left = self.left.saturating_sub(columns.len() * rows.len());
        if self.left > 0 {
            rows.for_each(|row| self.is_marked[row * self.side..][columns.clone()].fill(true));
        }
    }

    /// Whether a box may have a point in common with a marked one. O(cells).
    #[inline]
    pub(super) fn may_meet(&self, bounds: [Point; 2]) -> bool {
        let [columns, mut rows] = self.cells(bounds);
        self.left == 0 || rows.any(|row| self.is_marked[row * self.side..][columns.clone()].contains(&true))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plane::sweep::tests::numbers;

    #[test]
    fn boxes_that_meet_a_marked_one_may_and_most_others_may_not() {
        let (mut met, mut apart) = (0, 0);
        for seed in 1..600_u64 {
            let mut next = numbers(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15));
            let mut bounds = |reach: u64| {
                let [x, y] = [next(100), next(100)].map(|x| x as f64 * 0.1 - 3.0);
                let high = Point::new((x + next(reach) as f64 * 0.1).min(6.9), (y + next(reach) as f64 * 0.1).min(6.9));
                [Point::new(x, y), high]
            };
            let mut marks = Marks::new([Point::new(-3.0, -3.0), Point::new(6.9, 6.9)], 1 + seed as usize % 70);
            let marked: Vec<[Point; 2]> = (0..4).map(|_| bounds(9)).collect();
            marked.iter().for_each(|&bounds| marks.mark(bounds));
            for _ in 0..50 {
                let [low, high] = bounds(4);
                let meets = marked.iter().any(|[other_low, other_high]| {
                    low.x <= other_high.x && other_low.x <= high.x && low.y <= other_high.y && other_low.y <= high.y
                });
                let may = marks.may_meet([low, high]);
                assert!(may || !meets, "seed {seed}, {low:?} {high:?}");
                met += u32::from(meets);
                apart += u32::from(!may);
            }
        }
        assert!(met > 200 && apart > 5_000, "{met} meet, {apart} are apart");
    }

    #[test]
    fn many_large_boxes_mark_everything_and_cost_no_more() {
        let all = [Point::new(0.0, 0.0), Point::new(8.0, 8.0)];
        let (mut marks, corner) = (Marks::new(all, 8), [Point::new(7.5, 7.5); 2]);
        let large = [Point::new(0.0, 0.0), Point::new(6.5, 7.9)];
        let count = (0..10_000).take_while(|_| {
            marks.mark(large);
            !marks.may_meet(corner)
        });
        assert_eq!(count.count(), MOST * 64 / 56);
    }
}
