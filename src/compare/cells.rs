//! Where coats lie: cells in levels, each twice as large as the one below.
//!
//! ```text
//!   level 0   ┌─┬─┬─┬─┐      a coat is entered in the few cells of about its own size that it touches; a point asks one
//!             ├─┼─┼─┼─┤      cell of each level
//!   level 1   ├───┼───┤
//! ```

use super::pairing::distance;
use crate::plane::Point;

/// Level, column and row in one number.
pub(super) fn cell(level: i32, x: u64, y: u64) -> u64 {
    ((level + 64) as u64) << 56 | x << 28 | y
}

/// The level whose cells are at least so large.
pub(super) fn level(size: f64) -> i32 {
    size.log2().ceil().clamp(-60.0, 60.0) as i32
}

/// The number of a column, counted from the corner: all lie in 28 bits, or share the last.
pub(super) fn column(x: f64, level: i32) -> u64 {
    ((x * 2f64.powi(-level)).max(0.0) as u64).min((1 << 28) - 1)
}

/// The entries of the cell of a point.
pub(super) fn entries(cells: &[(u64, u32)], corner: Point, level: i32, p: Point) -> impl Iterator<Item = &(u64, u32)> {
    let cell = cell(level, column(p.x - corner.x, level), column(p.y - corner.y, level));
    let start = cells.partition_point(|entry| entry.0 < cell);
    cells[start..].iter().take_while(move |entry| entry.0 == cell)
}

/// The boxes of pieces of a line, each about so long.
pub(super) fn pieces([a, b]: [Point; 2], half: f64, size: f64) -> Vec<[Point; 2]> {
    let count = (distance(a, b) / size).ceil().clamp(1.0, 1024.0);
    let at = |i: f64| Point::new(a.x + i / count * (b.x - a.x), a.y + i / count * (b.y - a.y));
    (0..count as usize)
        .map(|i| {
            let (p, q) = (at(i as f64), at(i as f64 + 1.0));
            [Point::new(p.x.min(q.x) - half, p.y.min(q.y) - half), Point::new(p.x.max(q.x) + half, p.y.max(q.y) + half)]
        })
        .collect()
}
