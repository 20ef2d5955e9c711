//! Small drawings that a reader would call equal are, and what hides or adds something is told.

use super::judge;
use dcel_kit::compare::{Options, compare};
use std::fmt::Write;

pub(super) type P = [f64; 2];

pub(super) const CORNERS: [P; 4] = [[50.0, 350.0], [550.0, 350.0], [550.0, 50.0], [450.0, 250.0]];
/// The last one is 141 px long.
pub(super) const EDGES: [[usize; 2]; 5] = [[0, 1], [1, 2], [2, 3], [3, 0], [1, 3]];

pub(super) fn line([[a, b], [c, d]]: [P; 2], style: &str) -> String {
    format!("<line x1=\"{a}\" y1=\"{b}\" x2=\"{c}\" y2=\"{d}\" {style}/>")
}

/// The drawing with its edges and its vertices drawn like this, and with this behind all.
pub(super) fn drawn(edge: impl Fn(usize, [P; 2]) -> String, vertex: impl Fn(P) -> String, last: &str) -> String {
    let edges = EDGES.iter().enumerate().map(|(i, ends)| edge(i, ends.map(|v| CORNERS[v])));
    let parts: Vec<String> = edges.chain(CORNERS.iter().map(|&p| vertex(p))).collect();
    format!("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 600 400\">\n{}{last}</svg>", parts.join("\n"))
}

pub(super) fn edge(_: usize, ends: [P; 2]) -> String {
    line(ends, "stroke=\"#333\" stroke-width=\"1.5\"")
}

pub(super) fn circle([x, y]: P, radius: f64) -> String {
    format!("<circle cx=\"{x}\" cy=\"{y}\" r=\"{radius}\"/>")
}

pub(super) fn vertex(p: P) -> String {
    circle(p, 4.0)
}

pub(super) fn square([x, y]: P, side: f64, style: &str) -> String {
    let half = 0.5 * side;
    format!("<rect x=\"{}\" y=\"{}\" width=\"{side}\" height=\"{side}\" {style}/>", x - half, y - half)
}

pub(super) fn with(last: &str) -> String {
    drawn(edge, vertex, last)
}

#[track_caller]
pub(super) fn same(svg: &str) {
    let answer = judge(&with(""), svg);
    assert!(answer.is_equal(), "{}\n{svg}", answer.text());
}

#[track_caller]
pub(super) fn says(svg: &str, said: &str) {
    let answer = judge(&with(""), svg);
    let texts: Vec<&str> = answer.differences().iter().map(|difference| difference.text.as_str()).collect();
    assert!(texts.len() == 1 && texts[0].contains(said), "`{said}` not said: {}\n{svg}", answer.text());
}

#[test]
fn letters_and_lines_that_cross_an_edge_hide_nothing_of_it() {
    // Outlines of letters across the start of the lowest edge, in the colours of text and of the paper.
    for fill in ["black", "#333", "white"] {
        let letters = [70.0, 91.0, 112.0, 133.0].map(|x| {
            format!(
                "<path fill=\"{fill}\" d=\"M{} 344Q{} 343 {} 344V356Q{} 357 {} 356z\"/>",
                x - 5.0,
                x,
                x + 5.0,
                x,
                x - 5.0
            )
        });
        same(&with(&letters.concat()));
        // Without room between them they are a bar.
        let bar = (0..20).map(|i| letters[0].replace("<path", &format!("<path transform=\"translate({} 0)\"", 10 * i)));
        let answer = judge(&with(""), &with(&bar.collect::<String>())).text();
        assert!(answer.contains("edge between (50, 350) and (550, 350) cannot be seen"), "{answer}");
    }
    // A thin line that crosses an edge at a small angle, of a figure in which it is decoration.
    let leader = line([[500.0, 301.0], [505.0, 304.0]], "class=\"leader\" stroke=\"#999\" stroke-width=\"3\"");
    same(&with(&leader).replacen("<svg", "<svg data-figure=\"structure\"", 1));
}

#[test]
fn a_box_hides_what_letters_would_not_hide() {
    let middle = [500.0, 300.0];
    let said = "edge between (550, 350) and (450, 250) cannot be seen: a filled shape is drawn over it";
    for fill in ["white", "pink", "#f8f8f8"] {
        let style = format!("fill=\"{fill}\"");
        says(&with(&square(middle, 32.0, &style)), said);
        says(&with(&square(middle, 26.0, &style)), said);
        // As large as a letter, and as the box of a label.
        same(&with(&square(middle, 12.0, &style)));
        let name = "<text x=\"486\" y=\"305\" font-size=\"14\">e12</text>";
        same(&with(&format!("{}{name}", square(middle, 32.0, &style))));
        // Letters that lie below the box are not in it, nor are those of its colour.
        says(&with(&format!("{name}{}", square(middle, 32.0, &style))), said);
        says(&with(&format!("{}{}", square(middle, 32.0, &style), square(middle, 20.0, &style))), said);
    }
}

#[test]
fn a_plain_area_that_hides_a_stretch_of_an_edge_is_told() {
    let [level, slanted] = [[300.0, 350.0], [500.0, 300.0]];
    let said = |ends: &str| format!("edge between {ends} cannot be seen: a filled shape is drawn over it");
    let [first, last] = ["(50, 350) and (550, 350)", "(550, 350) and (450, 250)"].map(said);
    for fill in ["white", "pink", "#f8f8f8"] {
        let style = format!("fill=\"{fill}\"");
        for side in [18.0, 20.0, 24.0, 30.0] {
            says(&with(&square(level, side, &style)), &first);
            says(&with(&square(slanted, side, &style)), &last);
            // As the ground of a label, and as large as a letter.
            let label = "<text x=\"294\" y=\"354\" font-size=\"11\">e1</text>";
            same(&with(&format!("{}{label}", square(level, side, &style))));
            says(&with(&format!("{label}{}", square(level, side, &style))), &first);
        }
        same(&with(&square(level, 14.0, &style)));
        // A triangle, and a bar along the edge; across the edge it hides next to nothing.
        says(&with(&format!("<path d=\"M285 360h30L300 335z\" {style}/>")), &first);
        says(&with(&format!("<rect x=\"280\" y=\"347\" width=\"40\" height=\"6\" {style}/>")), &first);
        same(&with(&format!("<rect x=\"297\" y=\"330\" width=\"6\" height=\"40\" {style}/>")));
        // Below the edges, and where another area lies over nothing of them.
        let below = with("").replacen("<line", &format!("{}<line", square(level, 30.0, &style)), 1);
        same(&below);
        same(&with(&square([300.0, 330.0], 30.0, &style)));
    }
    // A reference that hides it, too, asks for no more.
    let hidden = with(&square(level, 24.0, "fill=\"white\""));
    let answer = judge(&hidden, &hidden.replace('\n', " "));
    assert!(answer.is_equal(), "{}", answer.text());
}

/// The edges without so many px at each end.
fn short(less: f64, aside: f64) -> String {
    let cut = |_: usize, [[a, b], [c, d]]: [P; 2]| {
        let long = (c - a).hypot(d - b);
        let [x, y] = [(c - a) / long, (d - b) / long];
        let ends = [
            [a + less * x - aside * y, b + less * y + aside * x],
            [c - less * x - aside * y, d - less * y + aside * x],
        ];
        line(ends, "stroke=\"#333\" stroke-width=\"1.5\"")
    };
    drawn(cut, vertex, "")
}

/// As the corners of a circle that runs through a vertex: a side points to the middle of a disc, and the next one goes on.
#[test]
fn corners_of_outlines_beside_a_vertex_are_no_ends_of_lines() {
    let ring = "<polygon points=\"300,250 447,250 380,150\" fill=\"none\" stroke=\"#333\"/>";
    let sides = [[[300.0, 250.0], [447.0, 250.0]], [[447.0, 250.0], [380.0, 150.0]], [[380.0, 150.0], [300.0, 250.0]]];
    let lines: String = sides.map(|ends| edge(0, ends)).concat();
    for last in [ring, &lines] {
        let answer = judge(&drawn(edge, |p| circle(p, 2.0), ring), &drawn(edge, |p| circle(p, 6.0), last));
        assert!(answer.is_equal(), "{last}: {}", answer.text());
    }
    // Drawn twice, an end is as loose as before.
    let twice = line([[50.0, 350.0], [547.0, 350.0]], "stroke=\"#333\"").repeat(2);
    same(&with("").replace(&edge(0, EDGES[0].map(|v| CORNERS[v])), &twice));
}

#[test]
fn a_line_that_ends_at_the_rim_of_a_circle_ends_at_its_vertex() {
    for less in [0.5, 1.0, 3.0, 4.0, 4.7] {
        same(&short(less, 0.0));
        let answer = judge(&short(less, 0.0), &with(""));
        assert!(answer.is_equal(), "{less}: {}", answer.text());
    }
    // Short of the circle, beyond its middle, and beside it.
    for (less, aside) in [(6.0, 0.0), (-0.5, 0.0), (2.0, 1.0), (0.0, 1.0)] {
        let answer = judge(&with(""), &short(less, aside));
        assert!(answer.text().contains("where there is no vertex"), "{less} {aside}: {}", answer.text());
    }
    // Within two circles to whose middles it points it ends at neither.
    let two = drawn(edge, |p| circle(p, 10.0), &circle([545.0, 350.0], 4.0));
    let ends = line([[50.0, 350.0], [541.5, 350.0]], "stroke=\"#333\"");
    let first = edge(0, EDGES[0].map(|v| CORNERS[v]));
    let answer = judge(&two, &two.replace(&first, &ends));
    assert!(answer.text().contains("a line ends at (541.5, 350), where there is no vertex"), "{}", answer.text());
}

#[test]
fn a_curve_that_is_straight_but_for_rounded_numbers_is_a_line() {
    let curve = |off: f64| {
        move |_: usize, [[a, b], [c, d]]: [P; 2]| {
            let [x, y] = [0.1 * (c - a), 0.1 * (d - b)];
            let controls = format!("{} {} {} {}", a + x, b + y + off, a + 2.0 * x, b + 2.0 * y - off);
            format!("<path fill=\"none\" stroke=\"black\" d=\"M{a} {b}C{controls} {c} {d}\"/>")
        }
    };
    same(&drawn(curve(0.04), vertex, ""));
    assert!(!judge(&with(""), &drawn(curve(0.2), vertex, "")).is_equal());
    // In units ten times as large.
    let large = drawn(curve(0.04), vertex, "").replace("0 0 600 400", "0 0 60 40");
    let large = large.replacen('\n', "\n<g transform=\"scale(.1)\">", 1).replace("</svg>", "</g></svg>");
    same(&large);
}

#[test]
fn an_arc_with_a_very_large_radius_is_a_line() {
    let arc = |radius: &'static str| {
        move |_: usize, [[a, b], [c, d]]: [P; 2]| {
            format!("<path fill=\"none\" stroke=\"black\" d=\"M{a} {b}A{radius} 0 0 1 {c} {d}\"/>")
        }
    };
    for radius in ["1e6 1e6", "1e9 1e9", "1e12 1e12", "1e300 1e300", "2e9 1e9"] {
        same(&drawn(arc(radius), vertex, ""));
        let extra = format!("<path fill=\"none\" stroke=\"black\" d=\"M50 350A{radius} 0 0 0 550 50\"/>");
        says(&with(&extra), "edge between (50, 350) and (550, 50) is not in the reference");
    }
    // One that rises by 35 px is none, nor is the other part of the circle.
    assert!(!judge(&with(""), &drawn(arc("900 900"), vertex, "")).is_equal());
    let round = |i: usize, ends: [P; 2]| arc("1e6 1e6")(i, ends).replace(" 0 0 1 ", " 0 1 1 ");
    assert!(!judge(&with(""), &drawn(round, vertex, "")).is_equal());
}

#[test]
fn a_vertex_too_small_to_be_seen_is_told() {
    let all = |radius: f64| drawn(edge, |p| circle(p, radius), "");
    says(&all(0.01), "4 vertices cannot be seen, their radius is less than 0.1 px");
    for radius in [0.1, 0.3, 0.6] {
        says(&all(radius), "4 vertices cannot be seen, they cannot be told from the lines that end there");
    }
    same(&all(1.5));
    // In another colour it is seen on a thick line.
    let thick = |i: usize, ends: [P; 2]| edge(i, ends).replace("1.5", "6");
    same(&drawn(thick, |p| circle(p, 2.0).replace("/>", " fill=\"orange\"/>"), ""));
    says(&drawn(edge, vertex, "").replacen("r=\"4\"", "r=\"4\" fill=\"none\"", 1), "cannot be seen: it has no fill");
    let huge = drawn(edge, vertex, "").replacen("r=\"4\"", "r=\"1e200\"", 1);
    let error = compare(&with(""), &huge, &Options::new()).unwrap_err().to_string();
    assert!(error.contains("this circle is not finite or beyond"), "{error}");
    // Below an area, whatever lies over that.
    let area = "<polygon points=\"40,360 560,360 560,40\" fill=\"pink\"/>";
    let last: String = EDGES.iter().enumerate().map(|(i, ends)| edge(i, ends.map(|v| CORNERS[v]))).collect();
    let below = drawn(|_, _| String::new(), vertex, &format!("{area}{last}"));
    let answer = compare(&with(""), &below, &Options::new().faces(false)).unwrap();
    assert!(answer.text().contains("cannot be seen: a filled shape is drawn over it"), "{}", answer.text());
}

#[test]
fn of_a_line_both_width_and_opacity_count() {
    let one = |style: &str| drawn(|i, ends| if i == 4 { line(ends, style) } else { edge(i, ends) }, vertex, "");
    says(&one("stroke=\"#333\" stroke-width=\".11\" opacity=\".06\""), "it is almost transparent");
    same(&one("stroke=\"#333\" stroke-width=\".11\""));
    same(&one("stroke=\"#333\" stroke-width=\"1.5\" opacity=\".06\""));
    same(&one("stroke=\"#333\" stroke-width=\".5\" opacity=\".5\""));
}

#[test]
fn a_square_that_looks_like_the_vertices_is_one() {
    let squares = |last: &str| drawn(edge, |p| square(p, 8.0, ""), last);
    same(&squares(""));
    for (at, place) in [([500.0, 300.0], "(500, 300)"), ([520.0, 250.0], "(520, 250)"), ([20.0, 20.0], "(20, 20)")] {
        let said = format!("vertex at {place} is not in the reference");
        says(&squares(&square(at, 8.0, "")), &said);
        says(&with(&square(at, 8.0, "")), &said);
        // Of another size or colour it is none.
        same(&squares(&square(at, 3.0, "")));
        same(&with(&square(at, 3.0, "")));
        same(&squares(&square(at, 8.0, "fill=\"white\"")));
        same(&with(&square(at, 8.0, "fill=\"white\"")));
    }
}

#[test]
fn a_star_is_seen_where_many_lines_end() {
    let star = |[x, y]: P| {
        let corner = |i: u32| {
            let (s, c) = (std::f64::consts::TAU * f64::from(i) / 10.0).sin_cos();
            let radius = if i % 2 == 1 { 1.53 } else { 4.0 };
            format!("{} {}", x + radius * s, y - radius * c)
        };
        format!("<path d=\"M{}z\"/>", (0..10).map(corner).collect::<Vec<_>>().join("L"))
    };
    // Six spokes about the middle.
    let spokes = |dot: &dyn Fn(P) -> String| {
        let (mut lines, mut dots) = (String::new(), dot([300.0, 200.0]));
        for i in 0..6 {
            let (s, c) = (std::f64::consts::TAU * f64::from(i) / 6.0).sin_cos();
            let at = [(300.0 + 180.0 * c).round(), (200.0 + 180.0 * s).round()];
            let _ = write!(lines, "{}", line([[300.0, 200.0], at], "stroke=\"black\" stroke-width=\"1.5\""));
            dots += &dot(at);
        }
        format!("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 600 400\">{lines}{dots}</svg>")
    };
    let answer = judge(&spokes(&vertex), &spokes(&star));
    assert!(answer.is_equal(), "{}", answer.text());
}

#[test]
fn a_large_drawing_that_is_turned_is_told_so() {
    // A grid of 20 x 15 points, each a little off its place.
    let at = |i: u32, j: u32| {
        let off = |k: u32| f64::from((i * 37 + j * 91 + k * 53) % 17) * 0.5;
        [40.0 + 26.0 * f64::from(i) + off(1), 20.0 + 24.0 * f64::from(j) + off(2)]
    };
    let grid = |more: &str, skipped: usize| {
        let mut parts = Vec::new();
        for (i, j) in (0..20).flat_map(|i| (0..15).map(move |j| (i, j))) {
            parts.extend((i < 19).then(|| line([at(i, j), at(i + 1, j)], "stroke=\"black\"")));
            parts.extend((j < 14).then(|| line([at(i, j), at(i, j + 1)], "stroke=\"black\"")));
        }
        parts.remove(skipped);
        let dots: String =
            (0..20).flat_map(|i| (0..15).map(move |j| (i, j))).map(|(i, j)| circle(at(i, j), 3.0)).collect();
        let inside = parts.concat();
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"-200 -300 1000 1000\"><g {more}>{inside}{dots}</g></svg>"
        )
    };
    for degrees in ["17", "-133"] {
        let turned = grid(&format!("transform=\"rotate({degrees} 300 200)\""), 40);
        let answer = judge(&grid("", 40), &turned);
        let side = if degrees == "17" { "17° to the right" } else { "133° to the left" };
        assert_eq!(answer.differences().len(), 1, "{}", answer.text());
        assert!(answer.text().contains(&format!("the drawing is turned by {side}")), "{}", answer.text());
    }
    let answer = judge(&grid("", 40), &grid("transform=\"rotate(17 300 200)\"", 300));
    assert!(answer.text().contains("the drawing is turned by 17° to the right"), "{}", answer.text());
}
