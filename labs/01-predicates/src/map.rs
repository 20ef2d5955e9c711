//! The map of wrong signs: points very close to a line, one for each cell of a grid.
//!
//! ```text
//!   row 31   ■ □ □ …        cell (column, row) is the point  (0.5 + column · STEP, 0.5 + row · STEP)
//!     …                     the line goes through Q, one double above (12, 12), and R = (24, 24)
//!   row 0    □ □ ■ …        ■ a cell that you have coloured
//! ```

// You need not use every function that is given here.
#![allow(dead_code)]

use crate::point::Point;
use std::fmt::Write;

/// Cells along a side.
pub const SIDE: usize = 32;
/// The distance of neighbouring points: four times that of neighbouring doubles there.
pub const STEP: f64 = 1.0 / (1u64 << 51) as f64;
/// The line goes through these two points.
pub const Q: Point = Point { x: 12.0, y: 12.000000000000002 };
/// See [`Q`].
pub const R: Point = Point { x: 24.0, y: 24.0 };
/// How large a cell is in the picture.
const CELL: usize = 10;

/// The map that is being drawn.
#[derive(Default)]
pub struct Map {
    cells: String,
}

impl Map {
    /// The point of a cell; rows and columns are counted from 0.
    pub fn point(&self, column: usize, row: usize) -> Point {
        Point { x: 0.5 + column as f64 * STEP, y: 0.5 + row as f64 * STEP }
    }

    /// Colours a cell.
    pub fn colour(&mut self, column: usize, row: usize) {
        let (left, right) = (CELL * column, CELL * (column + 1));
        // y points down in a picture: row 0 is the lowest one.
        let (top, bottom) = (CELL * (SIDE - 1).saturating_sub(row), CELL * SIDE.saturating_sub(row));
        let _ = writeln!(
            self.cells,
            "  <polygon points=\"{left},{bottom} {right},{bottom} {right},{top} {left},{top}\" fill=\"#b3261e\" \
             stroke=\"#111111\"/>"
        );
    }

    /// The whole file.
    pub fn finish(&self) -> String {
        let size = CELL * (SIDE + 2);
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"-{CELL} -{CELL} {size} {size}\">\n{}</svg>\n",
            self.cells
        )
    }
}
