//! The cells of a grid, and which of them an edge passes.
//!
//! ```text
//!     ┌───┬───┬───┬───┐       An edge is in each cell that it passes, and in some that it comes near to: whether it passes a
//!     │   │   │ ▒▒│▒╱ │       cell is asked in rounded numbers, with a margin far wider than the rounding.
//!     ├───┼───┼──╱┼───┤
//!     │   │▒╱▒│▒▒ │   │
//!     └───┴───┴───┴───┘
//! ```

use crate::geometry::both::of_both;

/// The margin round a cell, as a part of its side.
pub(in crate::plane) const MARGIN: f64 = 1.0 / 64.0;
/// No cell is narrower or lower than this part of the whole. Then places in a grid are off by a few 2^-21 of a cell.
const FINEST: f64 = 1.0 / (1_u64 << 32) as f64;
/// Edges that pass more columns than this in a row are in all cells of their box. The place where another one passes the side
/// of a row is off by so many times as much: less than the margin.
const FLAT: f64 = (1 << 10) as f64;

/// A rectangle, from the lower left corner of everything.
pub(in crate::plane) struct Frame {
    pub(in crate::plane) low: [f64; 2],
    pub(in crate::plane) size: [f64; 2],
}

impl Frame {
    /// How many columns and rows divide the frame best, with so many cells: but none narrower than things are wide on the
    /// average, nor lower than they are high, so that a thing is in few cells; and none smaller than is known.
    pub(in crate::plane) fn sides(&self, cells: usize, mean: [f64; 2], least: [f64; 2]) -> [usize; 2] {
        // A cast takes what is no number for 0.
        let most = [0, 1].map(|i| ((self.size[i] / mean[i].max(least[i])) as usize).max(1));
        let cells = cells.max(1);
        let side = (cells as f64).sqrt().ceil() as usize;
        let [columns, rows] = most.map(|most| side.min(most));
        [(cells / rows).clamp(1, most[0]), (cells / columns).clamp(1, most[1])]
    }

    /// What no cell may be smaller than, if this is the frame of everything.
    pub(in crate::plane) fn finest(&self) -> [f64; 2] {
        self.size.map(|size| FINEST * size)
    }
}

/// A grid over a frame.
pub(in crate::plane) struct Cells {
    low: [f64; 2],
    /// Cells for each unit of length.
    scale: [f64; 2],
    pub(in crate::plane) count: [usize; 2],
}

impl Cells {
    /// So many columns and rows; one where the frame has no width.
    pub(in crate::plane) fn new(frame: &Frame, sides: [usize; 2]) -> Self {
        let count = [0, 1].map(|i| if frame.size[i] > 0.0 { sides[i].max(1) } else { 1 });
        let scale = [0, 1].map(|i| if frame.size[i] > 0.0 { count[i] as f64 / frame.size[i] } else { 0.0 });
        Self { low: frame.low, scale, count }
    }

    /// A cell with its margin.
    pub(super) fn frame(&self, column: usize, row: usize) -> Frame {
        let side = |i: usize, at: usize| match self.scale[i] {
            0.0 => (self.low[i], 0.0),
            scale => (self.low[i] + (at as f64 - MARGIN) / scale, (1.0 + 2.0 * MARGIN) / scale),
        };
        let [(x, width), (y, height)] = [side(0, column), side(1, row)];
        Frame { low: [x, y], size: [width, height] }
    }

    /// Whether things that are not farther apart than this, in either direction, have a cell in common.
    pub(super) fn hold(&self, gap: f64) -> bool {
        self.scale.iter().all(|scale| 2.0 * gap * scale < MARGIN)
    }

    /// Where a point is, in columns and in rows.
    #[inline]
    pub(in crate::plane) fn place(&self, p: [f64; 2]) -> [f64; 2] {
        of_both([0, 1], |i: usize| (p[i] - self.low[i]) * self.scale[i])
    }

    /// Calls for each row of cells that an edge passes, with the columns from the first to the last.
    ///
    /// ```text
    ///     ┌───┬───┬───┬───┐       What an edge covers of a row lies between its places at the lower and the upper
    ///   1 │   │   │ ▒▒│▒╱ │       side of the row.
    ///     ├───┼───┼──╱┼───┤
    ///   0 │   │▒╱▒│▒▒ │   │
    ///     └───┴───┴───┴───┘
    /// ```
    #[inline]
    pub(in crate::plane) fn rows_of(&self, [a, b]: [[f64; 2]; 2], mut see: impl FnMut(usize, usize, usize)) {
        let ([mut u, mut v], [mut s, mut t]) = (self.place(a), self.place(b));
        if v > t {
            (u, v, s, t) = (s, t, u, v);
        }
        let Some((bottom, top)) = span(v, t, self.count[1]) else { return };
        let Some((left, right)) = span(u.min(s), u.max(s), self.count[0]) else { return };
        let slope = (s - u) / (t - v);
        if top - bottom < 2 || left == right || slope.abs() > FLAT {
            (bottom..=top).for_each(|row| see(row, left, right));
            return;
        }
        for row in bottom..=top {
            let [from, to] = of_both([row as f64 - MARGIN, (row + 1) as f64 + MARGIN], |at| at.clamp(v, t));
            let [from, to] = of_both([from, to], |at| u + (at - v) * slope);
            if let Some((first, last)) = span(from.min(to), from.max(to), self.count[0]) {
                see(row, first.max(left), last.min(right));
            }
        }
    }
}

/// The cells from one place to another of a row of so many, and those within the margin; none where all lies beside them.
#[inline]
fn span(low: f64, high: f64, count: usize) -> Option<(usize, usize)> {
    // Casts to signed numbers are the quick ones; they end at the greatest and the smallest number.
    let (first, last) = ((low - MARGIN) as i64, high + MARGIN);
    let is_inside = last >= 0.0 && first < count as i64;
    is_inside.then(|| (first.max(0) as usize, (last as i64 as usize).min(count - 1)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plane::sweep::tests::numbers;

    #[test]
    fn edges_within_the_gap_have_a_cell_in_common() {
        let (mut close, mut refused) = (0, 0);
        for seed in 1..4_000_u64 {
            let mut next = numbers(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15));
            let mut unit = || next(1 << 50) as f64 / (1_u64 << 50) as f64;
            let size = [10f64.powi((unit() * 9.0) as i32 - 4), 10f64.powi((unit() * 9.0) as i32 - 4)];
            let cells = Cells::new(
                &Frame { low: [0.0; 2], size },
                [1 + (unit() * 40.0) as usize, 1 + (unit() * 40.0) as usize],
            );
            // The widest gap that is held, and the next wider one.
            let side = [0, 1].map(|i| size[i] / cells.count[i] as f64);
            let gap = 0.499 * MARGIN * side[0].min(side[1]);
            assert!(cells.hold(gap));
            refused += u32::from(!cells.hold(1.01 * gap));
            for _ in 0..20 {
                // One edge begins beside a border of cells, the other one beside its end.
                let mut place = || [0, 1].map(|i| ((unit() * 40.0).floor().min(cells.count[i] as f64)) * side[i]);
                let (at, [p, q]) = (place(), [place(), place()]);
                let mut beside = |at: [f64; 2]| [0, 1].map(|i| (at[i] + (unit() - 0.5) * gap).clamp(0.0, size[i]));
                let ends = [[beside(at), p], [beside(at), q]];
                let passed = ends.map(|ends| {
                    let mut passed = Vec::new();
                    cells.rows_of(ends, |row, first, last| passed.extend((first..=last).map(|column| [column, row])));
                    passed
                });
                assert!(passed[0].iter().any(|cell| passed[1].contains(cell)), "seed {seed}: {ends:?}");
                close += u32::from(passed[0].len() < 12 && passed[1].len() < 12);
            }
        }
        assert!(close > 10_000 && refused > 3_000, "{close} {refused}");
    }
}
