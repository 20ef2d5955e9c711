//! Heads of arrows that plotting programs draw by lines and areas say no more than markers do.

use super::judge;
use super::shown::{CORNERS, EDGES, P, circle, drawn, line, same, says, square, with};
use dcel_kit::compare::{Options, compare};

const STROKE: &str = "stroke=\"black\" fill=\"none\" stroke-width=\"1\"";

/// An arrow that leaves so much room at both ends, with a head like this.
struct Style {
    room: f64,
    /// How long the head is, and half of how wide.
    size: P,
    filled: bool,
    /// Whether the line ends at the base of the head.
    at_base: bool,
    both: bool,
}

impl Style {
    fn arrow(&self, [[a, b], [c, d]]: [P; 2]) -> String {
        let long = (c - a).hypot(d - b);
        let [x, y] = [(c - a) / long, (d - b) / long];
        let at = |ahead: f64, aside: f64| [a + ahead * x - aside * y, b + ahead * y + aside * x];
        let [length, half] = self.size;
        // The ink of a stroked tip reaches beyond it.
        let ink = 0.5 * half.hypot(length) / half;
        let (first, last) = (self.room, long - self.room - ink);
        let start = if self.both { first + length } else { first };
        let ends = if self.at_base { [start, last - length] } else { [first, last] };
        let mut out = line(ends.map(|t| at(t, 0.0)), STROKE);
        let mut head = |tip: f64, back: f64| {
            let [left, right] = [half, -half].map(|aside| at(tip - back * length, aside));
            let points = [left, at(tip, 0.0), right].map(|[x, y]| format!("{x} {y}"));
            let (close, style) = if self.filled { ("z", "stroke=\"black\"") } else { ("", STROKE) };
            out += &format!("<path d=\"M{}{close}\" {style}/>", points.join("L"));
        };
        head(last, 1.0);
        if self.both {
            head(first, -1.0);
        }
        out
    }
}

const PLAIN: Style = Style { room: 3.0, size: [5.6, 2.8], filled: false, at_base: false, both: false };

fn styles() -> Vec<Style> {
    let mut out = Vec::new();
    for filled in [false, true] {
        for both in [false, true] {
            for room in [0.0, 3.0, 5.0] {
                for scale in [1.0, 2.0] {
                    out.push(Style { room, size: PLAIN.size.map(|part| scale * part), filled, both, ..PLAIN });
                }
            }
        }
    }
    out.push(Style { room: 5.0, filled: true, at_base: true, ..PLAIN });
    // Both heads are a good part of the shortest edge.
    out.push(Style { room: 4.0, size: [16.0, 5.0], filled: true, at_base: true, both: true });
    out
}

#[test]
fn arrows_with_heads_of_strokes_or_areas_are_edges() {
    for style in styles() {
        // Two heads leave room for their ink at both ends.
        let room = if style.both { style.room.max(1.2) } else { style.room };
        let style = Style { room, ..style };
        let arrows = |last: &str| drawn(|_, ends| style.arrow(ends), |p| circle(p, 5.5), last);
        same(&arrows(""));
        let extra = style.arrow([CORNERS[0], CORNERS[2]]);
        says(&arrows(&extra), "edge between (50, 350) and (550, 50) is not in the reference");
        let less = arrows("").replace(&style.arrow(EDGES[4].map(|v| CORNERS[v])), "");
        says(&less, "edge between (550, 350) and (450, 250) is missing");
    }
}

#[test]
fn arrows_between_squares_are_edges() {
    let style = Style { room: 4.0, ..PLAIN };
    same(&drawn(|_, ends| style.arrow(ends), |p| square(p, 10.0, ""), ""));
}

#[test]
fn an_arrow_that_does_not_reach_its_vertex_is_told() {
    let short = Style { room: 14.0, ..PLAIN };
    for filled in [false, true] {
        let arrows = drawn(|_, ends| Style { filled, ..short }.arrow(ends), |p| circle(p, 5.5), "");
        assert!(judge(&with(""), &arrows).text().contains("where there is no vertex"), "{filled}");
    }
    // Without circles, lines are all there is.
    let bare = drawn(|_, ends| PLAIN.arrow(ends), |_| String::new(), "");
    assert!(!judge(&with(""), &bare).is_equal());
}

/// How near a tip is to its vertex follows the tolerance.
#[test]
fn heads_follow_the_tolerance() {
    let equal = |svg: &str, px: f64| {
        compare(&with(""), svg, &Options::new().tolerance(px)).unwrap_or_else(|error| panic!("{error}")).is_equal()
    };
    for filled in [false, true] {
        let arrows = |room: f64| {
            drawn(|_, ends| Style { room, filled, both: true, ..PLAIN }.arrow(ends), |p| circle(p, 5.5), "")
        };
        assert!(equal(&arrows(5.0), 0.05) && !equal(&arrows(8.0), 0.05), "{filled}");
        assert!(equal(&arrows(8.0), 2.0) && !equal(&arrows(16.0), 2.0), "{filled}");
    }
}

#[test]
fn lines_that_only_look_like_a_head_are_told() {
    let with = |strokes: &str| drawn(|_, ends| line(ends, STROKE), |p| circle(p, 4.0), strokes);
    // Two edges to vertices of their own, at the end of another edge.
    let [p, q] = [[530.0, 340.0], [530.0, 360.0]];
    let edges = line([[550.0, 350.0], p], STROKE) + &line([[550.0, 350.0], q], STROKE);
    let branched = with(&(edges.clone() + &circle(p, 4.0) + &circle(q, 4.0)));
    let answer = judge(&with(""), &branched);
    assert!(answer.differences().len() > 1, "{}", answer.text());
    // One stroke alone, strokes of two lengths, and one on each side of the end.
    for strokes in [[p, p], [p, [520.0, 364.0]], [p, [570.0, 360.0]]] {
        let strokes = strokes.map(|end| line([[550.0, 350.0], end], STROKE)).concat();
        assert!(!judge(&with(""), &with(&strokes)).is_equal(), "{strokes}");
    }
    same(&with(&edges));
}

/// Two short edges that fold back along a third one are no head, whether they end at circles, at their rims or at squares.
#[test]
fn edges_that_fold_back_like_a_head_are_edges() {
    let corners: [P; 6] = [[0.0, 300.0], [500.0, 300.0], [475.0, 312.0], [475.0, 288.0], [600.0, 0.0], [0.0, 0.0]];
    let edges = [[0, 1], [1, 2], [1, 3], [1, 4], [4, 5], [5, 0]];
    let svg = |vertex: &dyn Fn(P) -> String, short: f64| {
        let lines = edges.map(|ends| {
            let [[a, b], [c, d]] = ends.map(|v| corners[v]);
            let part = short / f64::hypot(c - a, d - b);
            line([[a, b], [c - part * (c - a), d - part * (d - b)]], STROKE)
        });
        let vertices = corners.map(vertex);
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"-10 -10 620 330\">{}{}</svg>",
            lines.concat(),
            vertices.concat()
        )
    };
    let disc = |p: P| circle(p, 3.0);
    let reference = svg(&disc, 0.0);
    for drawing in [svg(&disc, 3.0), svg(&|p| square(p, 6.0, ""), 0.0)] {
        let answer = judge(&reference, &drawing);
        assert!(answer.is_equal(), "{}\n{drawing}", answer.text());
    }
}
