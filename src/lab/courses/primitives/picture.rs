//! The picture of the handout: six surfaces of revolution, as the program of the lab draws them.

use std::f64::consts::TAU;
use std::fmt::Write;

type Rows = &'static [[f64; 2]];

/// How many sides, and the radius and height of each row; whether the last row is joined to the first.
const PANELS: [(usize, Rows, bool); 6] = [
    (6, &[[1.0, 0.0]], false),
    (6, &[[1.0, 0.0], [1.0, 0.7]], false),
    (6, &[[1.0, 0.0], [1.0, 0.7], [1.0, 1.4]], false),
    (6, &[[1.0, 0.0], [0.7, 0.5], [0.4, 1.0], [0.0, 1.6]], false),
    (6, &[[0.0, -1.0], [0.7, -0.7], [1.0, 0.0], [0.7, 0.7], [0.0, 1.0]], false),
    (8, &[[1.4, 0.0], [1.0, 0.4], [0.6, 0.0], [1.0, -0.4]], true),
];

/// The picture, with the coordinates that the student's program writes: y points down in a file.
pub(super) fn plain() -> String {
    let mut lines = String::new();
    let mut dots = String::new();
    for (panel, (sides, rows, closed)) in PANELS.into_iter().enumerate() {
        let at = |row: usize, i: usize| {
            let [radius, z] = rows[row];
            let angle = TAU * (i % sides) as f64 / sides as f64;
            let (x, y) = (radius * angle.cos(), radius * angle.sin());
            let [right, down] = [panel % 3, panel / 3].map(|place| 400.0 * place as f64);
            [right + 100.0 * x + 45.0 * y, down + 10.0 * x - 60.0 * y - 100.0 * z]
        };
        let mut line = |[x1, y1]: [f64; 2], [x2, y2]: [f64; 2]| {
            let _ = writeln!(lines, "<line x1=\"{x1}\" y1=\"{y1}\" x2=\"{x2}\" y2=\"{y2}\" stroke=\"#000000\"/>");
        };
        for (row, &[radius, _]) in rows.iter().enumerate() {
            let above = if row + 1 < rows.len() { Some(row + 1) } else { closed.then_some(0) };
            for i in 0..sides {
                if radius > 0.0 {
                    line(at(row, i), at(row, i + 1));
                }
                if let Some(above) = above {
                    line(at(row, i), at(above, i));
                }
                if radius > 0.0 || i == 0 {
                    let [x, y] = at(row, i);
                    let _ = writeln!(dots, "<circle cx=\"{x}\" cy=\"{y}\" r=\"4\"/>");
                }
            }
        }
    }
    format!("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"-200 -250 1200 800\">\n{lines}{dots}</svg>\n")
}

#[cfg(test)]
mod tests {
    use super::*;
    use dcel_kit::compare::{Options, compare};

    /// E of the formulas: 6, 18, 30, 36, 42 and 64; V: 6, 12, 18, 19, 20 and 32.
    #[test]
    fn it_has_as_many_lines_and_dots_as_the_formulas_say() {
        assert_eq!(plain().matches("<line").count(), 6 + 18 + 30 + 36 + 42 + 64);
        assert_eq!(plain().matches("<circle").count(), 6 + 12 + 18 + 19 + 20 + 32);
    }

    #[test]
    fn the_figure_of_the_handout_shows_the_same() {
        let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../figures/lab-09-growth.svg");
        let figure = std::fs::read_to_string(file).unwrap();
        let comparison = compare(&figure, &plain(), &Options::new()).unwrap();
        assert_eq!(comparison.differences().len(), 0, "{:?}", comparison.differences());
    }
}
