//! The picture of the climb over the gem, as the student's program should draw it.

use super::mistakes::climb;
use super::model::Place;
use super::solids::gem;
use crate::pictures::Plain;

const FROM: usize = 0;
const DIRECTION: Place = [1.0, 2.0, 5.0];

/// The picture with the coordinates that the student's program writes: y points down in a file.
pub(super) fn reference() -> String {
    let model = gem().model();
    let at = |v: usize| {
        let [x, y, z] = model.place(v).unwrap_or_default();
        [x + 0.5 * y, z + 0.25 * y]
    };
    let mut out = Plain::new("-200 -200 400 400");
    for &(a, b) in model.across.keys().filter(|(a, b)| a < b) {
        out.edge(at(a), at(b));
    }
    climb(&model, FROM, DIRECTION).into_iter().for_each(|v| out.vertex(at(v)));
    out.svg()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pictures::assert_shown;

    #[test]
    fn the_figure_of_the_handout_shows_the_same() {
        assert_shown("lab-11-climb.svg", &reference());
        assert_eq!(reference().matches("circle").count(), 3);
    }
}
