//! The picture of the handout: six surfaces of revolution, as the program of the lab draws them.

use crate::pictures::Plain;
use std::f64::consts::TAU;

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
    let mut out = Plain::new("-200 -250 1200 800");
    let mut dots = Vec::new();
    for (panel, (sides, rows, closed)) in PANELS.into_iter().enumerate() {
        let at = |row: usize, i: usize| {
            let [radius, z] = rows[row];
            let angle = TAU * (i % sides) as f64 / sides as f64;
            let (x, y) = (radius * angle.cos(), radius * angle.sin());
            let [right, down] = [panel % 3, panel / 3].map(|place| 400.0 * place as f64);
            [right + 100.0 * x + 45.0 * y, -(down + 10.0 * x - 60.0 * y - 100.0 * z)]
        };
        for (row, &[radius, _]) in rows.iter().enumerate() {
            let above = if row + 1 < rows.len() { Some(row + 1) } else { closed.then_some(0) };
            for i in 0..sides {
                if radius > 0.0 {
                    out.edge(at(row, i), at(row, i + 1));
                }
                if let Some(above) = above {
                    out.edge(at(row, i), at(above, i));
                }
                if radius > 0.0 || i == 0 {
                    dots.push(at(row, i));
                }
            }
        }
    }
    dots.into_iter().for_each(|dot| out.vertex(dot));
    out.svg()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pictures::assert_shown;

    /// E of the formulas: 6, 18, 30, 36, 42 and 64; V: 6, 12, 18, 19, 20 and 32.
    #[test]
    fn it_has_as_many_lines_and_dots_as_the_formulas_say() {
        assert_eq!(plain().matches("<line").count(), 6 + 18 + 30 + 36 + 42 + 64);
        assert_eq!(plain().matches("<circle").count(), 6 + 12 + 18 + 19 + 20 + 32);
    }

    #[test]
    fn the_figure_of_the_handout_shows_the_same() {
        assert_shown("lab-09-growth.svg", &plain());
    }
}
