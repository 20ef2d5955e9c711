//! The map of wrong signs: the cells of a grid of points close to a line, where doubles say the wrong side.

use super::sum;
use std::fmt::Write;

/// Cells along a side.
const SIDE: usize = 32;
/// The distance of neighbouring points, 2^-51.
const STEP: f64 = 4.0 * (f64::EPSILON / 2.0);
/// The line goes through (24, 24) and a point one double above (12, 12).
pub(super) const Q: [f64; 2] = [12.0, 12.000_000_000_000_002];
pub(super) const R: [f64; 2] = [24.0, 24.0];
/// How large a cell is in the picture.
const CELL: usize = 10;

/// Which way three points turn by the formula of the handout, in doubles.
#[must_use]
pub fn naive([px, py]: [f64; 2], [qx, qy]: [f64; 2], [rx, ry]: [f64; 2]) -> i32 {
    let area = (qx - px) * (ry - py) - (qy - py) * (rx - px);
    area.partial_cmp(&0.0).map_or(0, |sign| sign as i32)
}

/// The point of a cell.
pub(super) fn point([column, row]: [usize; 2]) -> [f64; 2] {
    [0.5 + column as f64 * STEP, 0.5 + row as f64 * STEP]
}

/// The cells where doubles are wrong: column and row, both from 0, row by row from below.
#[must_use]
pub fn wrong_cells() -> Vec<[usize; 2]> {
    let cells = (0..SIDE * SIDE).map(|k| [k % SIDE, k / SIDE]);
    let wrong = |&cell: &[usize; 2]| naive(point(cell), Q, R) != sum::orientation(point(cell), Q, R);
    cells.filter(wrong).collect()
}

/// The map as a picture, with the coordinates that the program of the lab writes.
#[must_use]
pub fn picture() -> String {
    let size = CELL * (SIDE + 2);
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"-{CELL} -{CELL} {size} {size}\">\n  \
         <title>Where doubles say the wrong side of a line</title>\n"
    );
    for [column, row] in wrong_cells() {
        let (left, right) = (CELL * column, CELL * (column + 1));
        let (top, bottom) = (CELL * (SIDE - row - 1), CELL * (SIDE - row));
        let corners = format!("{left},{bottom} {right},{bottom} {right},{top} {left},{top}");
        let _ = writeln!(out, "  <polygon points=\"{corners}\" fill=\"#b3261e\" stroke=\"#111111\"/>");
    }
    out + "</svg>\n"
}

#[cfg(test)]
mod tests {
    use super::*;
    use dcel_kit::figure::NearlyCollinear;

    #[test]
    fn the_map_has_wrong_cells_of_every_kind() {
        let wrong = wrong_cells();
        assert_eq!(wrong.len(), 306);
        for sign in [-1, 0, 1] {
            assert!(wrong.iter().any(|&cell| naive(point(cell), Q, R) == sign), "{sign}");
        }
        let turned = |&[column, row]: &[usize; 2]| wrong.contains(&[row, column]);
        assert!(!wrong.iter().all(turned), "rows and columns are told apart");
    }

    #[test]
    fn it_counts_as_the_kit_does() {
        let kit = NearlyCollinear::new([0.5; 2], Q, R, STEP).unwrap();
        assert_eq!(kit.wrong_within(SIDE), wrong_cells().len());
    }
}
