//! The picture of the climb over the gem, as the student's program should draw it.

use super::model::Place;
use super::solids::gem;
use std::fmt::Write;

const FROM: usize = 0;
const DIRECTION: Place = [1.0, 2.0, 5.0];

/// The picture with the coordinates that the student's program writes: y points down in a file.
pub(super) fn reference() -> String {
    let model = gem().model();
    let at = |v: usize| {
        let [x, y, z] = model.place(v).unwrap_or_default();
        [x + 0.5 * y, 0.0 - (z + 0.25 * y)]
    };
    let mut out = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"-200 -200 400 400\">\n".to_owned();
    for &(a, b) in model.across.keys().filter(|(a, b)| a < b) {
        let ([x1, y1], [x2, y2]) = (at(a), at(b));
        let _ = writeln!(out, "<line x1=\"{x1}\" y1=\"{y1}\" x2=\"{x2}\" y2=\"{y2}\" stroke=\"#000000\"/>");
    }
    let mut v = FROM;
    loop {
        let [x, y] = at(v);
        let _ = writeln!(out, "<circle cx=\"{x}\" cy=\"{y}\" r=\"4\"/>");
        let highest =
            model.neighbours(v).into_iter().reduce(|a, b| if model.higher(DIRECTION, b, a).is_gt() { b } else { a });
        match highest.filter(|&next| model.higher(DIRECTION, next, v).is_gt()) {
            Some(next) => v = next,
            None => return out + "</svg>\n",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use dcel_kit::compare::{Options, compare};

    #[test]
    fn the_figure_of_the_handout_shows_the_same() {
        let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../figures/lab-11-climb.svg");
        let figure = std::fs::read_to_string(file).unwrap();
        let comparison = compare(&reference(), &figure, &Options::new()).unwrap();
        assert_eq!(comparison.differences().len(), 0, "{:?}", comparison.differences());
        assert_eq!(reference().matches("circle").count(), 3);
    }
}
