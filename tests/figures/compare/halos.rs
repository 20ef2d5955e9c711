//! White outlines of letters that are drawn by themselves part the letters from what lies below them, and are no edges.

use super::judge;
use super::shown::{line, same, with};

/// Three letters with straight sides.
fn word(x: f64, y: f64, style: &str) -> String {
    let letter = "M0 0L2.5 -9H4.5L7 0H5L4.4 -2H2.4L2 0ZM3 -4H4L3.5 -6Z";
    (0..3)
        .map(|i| format!("<path transform=\"translate({} {y})\" d=\"{letter}\" {style}/>", x + 8.0 * f64::from(i)))
        .collect()
}

/// The same in one path.
fn path(x: f64, y: f64, style: &str) -> String {
    let letter = |x: f64| {
        let at = |a: f64, b: f64| format!("{} {}", x + a, y + b);
        let [a, b, c, d] = [at(0.0, 0.0), at(2.5, -9.0), at(4.5, -9.0), at(7.0, 0.0)];
        format!("M{a}L{b}L{c}L{d}L{}L{}Z", at(5.0, 0.0), at(3.5, -6.0))
    };
    format!("<path d=\"{}{}\" {style}/>", letter(x), letter(x + 8.0))
}

const PLACES: [[f64; 2]; 5] = [[290.0, 354.0], [490.0, 304.0], [60.0, 344.0], [300.0, 150.0], [530.0, 345.0]];

#[test]
fn halos_that_are_drawn_by_themselves_are_no_edges() {
    let letters = "fill=\"black\"";
    for draw in [word, path] {
        for [x, y] in PLACES {
            for halo in ["fill=\"none\" stroke=\"white\" stroke-width=\"3\"", "fill=\"white\" stroke=\"white\""] {
                same(&with(&(draw(x, y, halo) + &draw(x, y, letters))));
            }
            // Behind the letters, and not quite at their place, as numbers are rounded.
            let thin = "fill=\"none\" stroke=\"white\" stroke-width=\"1\"";
            same(&with(&(draw(x, y, letters) + &draw(x, y, thin))));
            same(&with(&(draw(x, y, letters) + &draw(x + 0.002, y - 0.003, thin))));
        }
    }
}

#[test]
fn white_lines_that_hide_an_edge_are_told() {
    let letters = word(290.0, 354.0, "fill=\"black\"");
    let halo = word(290.0, 354.0, "fill=\"none\" stroke=\"white\" stroke-width=\"3\"");
    // Not only round the letters.
    let over = line([[60.0, 350.0], [540.0, 350.0]], "stroke=\"white\" stroke-width=\"3\"");
    let answer = judge(&with(""), &with(&(halo.clone() + &letters + &over)));
    assert!(answer.text().contains("edge between (50, 350) and (550, 350) cannot be seen"), "{}", answer.text());
    // Lines of another colour round letters are lines.
    let answer = judge(&with(""), &with(&(halo.replace("white", "#888") + &letters)));
    assert!(!answer.is_equal());
}
