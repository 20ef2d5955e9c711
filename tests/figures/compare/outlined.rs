//! Arrows that plotting programs draw as one filled outline, shaft and head together, are lines.

use super::judge;
use super::shown::{CORNERS, EDGES, P, circle, drawn, edge, line, same, says, square, vertex, with};
use dcel_kit::compare::{Options, compare};

/// One side of such an outline on its way from tail to tip, where it starts, and its stretches: the ends of lines, and the
/// second and third corners of curves, each by how far along it lies and how far aside.
type Side = fn(long: f64, scale: f64) -> (P, Vec<Vec<P>>);

/// The shapes that one plotting program calls `simple`, `fancy` and `wedge`.
const SHAPES: [(&str, Side); 3] = [
    ("simple", |long, k| {
        let neck = long - 5.0 * k;
        let head = vec![[long - 2.5 * k, 1.25 * k], [long, 0.0]];
        ([0.0, k], vec![vec![[0.5 * neck, k], [neck, k]], vec![[neck, 2.5 * k]], head])
    }),
    ("fancy", |long, k| {
        let neck = long - 3.2 * k;
        let shaft = vec![[0.5 * neck, 1.1 * k], [neck, 0.6 * k]];
        let head = vec![[long - 2.0 * k, 1.4 * k], [long, 0.0]];
        ([1.2 * k, 0.0], vec![vec![[0.0, 2.0 * k]], shaft, vec![[long - 4.0 * k, 2.0 * k]], head])
    }),
    ("wedge", |long, k| ([0.0, 1.5 * k], vec![vec![[0.5 * long, 0.75 * k], [long, 0.0]]])),
];

/// The outline with so much room at both ends, its other side so many times as wide.
fn arrow([[a, b], [c, d]]: [P; 2], room: f64, (side, scale, other): (Side, f64, f64), style: &str) -> String {
    let long = (c - a).hypot(d - b);
    let [x, y] = [(c - a) / long, (d - b) / long];
    let place = |[t, off]: P| {
        let t = t + room;
        format!("{:.6} {:.6} ", a + t * x - off * y, b + t * y + off * x)
    };
    let (start, stretches) = side(long - 2.0 * room, scale);
    let mut data = format!("M{}", place(start));
    let mut add = |points: &[P]| {
        data += if points.len() > 1 { "Q" } else { "L" };
        points.iter().for_each(|&p| data += &place(p));
    };
    stretches.iter().for_each(|points| add(points));
    // Back on the other side.
    let across = |[t, off]: P| [t, -other * off];
    for i in (0..stretches.len()).rev() {
        let before = if i == 0 { start } else { stretches[i - 1][stretches[i - 1].len() - 1] };
        let inner = stretches[i].iter().rev().skip(1).copied();
        add(&inner.chain([before]).map(across).collect::<Vec<_>>());
    }
    format!("<path d=\"{data}z\" {style}/>")
}

const STYLES: [&str; 2] = ["fill=\"#333\"", "fill=\"#333\" stroke=\"#333\""];

#[test]
fn outlines_of_arrows_are_lines_from_vertex_to_vertex() {
    for (name, side) in SHAPES {
        for style in STYLES {
            for (room, scale) in [(0.0, 1.0), (4.0, 1.0), (5.5, 2.0), (5.5, 5.0)] {
                let one = |ends: [P; 2]| arrow(ends, room, (side, scale, 1.0), style);
                let dots: [&dyn Fn(P) -> String; 2] = [&|p| circle(p, 5.5), &|p| square(p, 11.0, "fill=\"#1f78b4\"")];
                for dot in dots {
                    let arrows = |last: &str| drawn(|_, ends| one(ends), dot, last);
                    same(&arrows(""));
                    let answer = judge(&arrows(""), &with(""));
                    assert!(answer.is_equal(), "{name} {room} {scale} {style}: {}", answer.text());
                    let extra = one([CORNERS[0], CORNERS[2]]);
                    says(&arrows(&extra), "edge between (50, 350) and (550, 50) is not in the reference");
                    let less = arrows("").replacen(&one(EDGES[4].map(|v| CORNERS[v])), "", 1);
                    says(&less, "edge between (550, 350) and (450, 250) is missing");
                }
            }
        }
        // Lines and arrows in one drawing, and an arrow that runs the other way.
        let mixed = |i: usize, [p, q]: [P; 2]| match i {
            0 | 3 => edge(i, [p, q]),
            1 => arrow([q, p], 4.0, (side, 1.0, 1.0), STYLES[0]),
            _ => arrow([p, q], 4.0, (side, 1.0, 1.0), STYLES[1]),
        };
        same(&drawn(mixed, vertex, ""));
    }
}

#[test]
fn an_outline_that_ends_short_of_its_vertices_is_told_as_a_line() {
    for (name, side) in SHAPES {
        for style in STYLES {
            let arrows = drawn(|_, ends| arrow(ends, 12.0, (side, 1.0, 1.0), style), |p| circle(p, 5.5), "");
            let answer = judge(&with(""), &arrows);
            let told = answer.text();
            assert!(told.contains("a line ends at (62, 350), where there is no vertex"), "{name}: {told}");
        }
    }
}

#[test]
fn what_only_looks_like_an_arrow_is_told() {
    for (name, side) in SHAPES {
        let with_arrows = |other: f64, style: &str, dot: &dyn Fn(P) -> String| {
            drawn(|_, ends| arrow(ends, 4.0, (side, 1.0, other), style), dot, "")
        };
        // Not the same on both sides; of the colour of the paper; no vertices.
        for svg in [
            with_arrows(0.4, STYLES[0], &vertex),
            with_arrows(1.0, "fill=\"white\"", &vertex),
            with_arrows(1.0, STYLES[0], &|_| String::new()),
        ] {
            let answer = compare(&with(""), &svg, &Options::new());
            assert!(answer.map_or(true, |answer| !answer.is_equal()), "{name}\n{svg}");
        }
        // An area as large as a face.
        let broad = drawn(|_, ends| arrow(ends, 4.0, (side, 16.0, 1.0), STYLES[0]), vertex, "");
        assert!(!judge(&with(""), &broad).is_equal(), "{name}");
    }
}

/// A slender triangle with vertices at its corners is a face, whatever else stands on the middle of its base.
#[test]
fn a_slender_face_is_no_arrow() {
    let page =
        |inside: &str| format!("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"-20 -100 440 200\">{inside}</svg>");
    let ring: [P; 4] = [[0.0, 0.0], [400.0, -15.0], [400.0, 0.0], [400.0, 15.0]];
    let face = |stroke: &str| format!("<polygon points=\"0,0 400,-15 400,15\" fill=\"#e8f0ff\" {stroke}/>");
    let lines = |ends: &[[usize; 2]]| {
        ends.iter().map(|ends| line(ends.map(|v| ring[v]), "stroke=\"#333\"")).collect::<String>()
    };
    let dots: String = ring.iter().map(|&p| circle(p, 3.0)).collect();
    let reference = page(&(face("") + &lines(&[[0, 1], [1, 2], [2, 3], [3, 0]]) + &dots));
    let answer = judge(&reference, &page(&(face("stroke=\"#333\"") + &dots)));
    assert!(answer.is_equal(), "{}", answer.text());
    // The way from its point to the middle of its base is no edge of it.
    let crossed = page(&(face("") + &lines(&[[0, 1], [1, 2], [2, 3], [3, 0], [0, 2]]) + &dots));
    assert!(!judge(&crossed, &page(&(face("stroke=\"#333\"") + &dots))).is_equal());
}

/// A slender head is a part of its line, also on a line so short that the base of its head is near the other vertex.
#[test]
fn a_slender_head_is_no_arrow() {
    let corners: [P; 3] = [[50.0, 350.0], [86.0, 350.0], [550.0, 50.0]];
    let page = |edge: &dyn Fn([P; 2]) -> String| {
        let edges: String = [[0, 1], [1, 2]].map(|ends| edge(ends.map(|v| corners[v]))).concat();
        let dots = corners.map(|p| circle(p, 5.5)).concat();
        format!("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 600 400\">{edges}{dots}</svg>")
    };
    let arrow = |[[a, b], [c, d]]: [P; 2]| {
        let long = (c - a).hypot(d - b);
        let [x, y] = [(c - a) / long, (d - b) / long];
        let at = |t: f64, off: f64| [a + t * x - off * y, b + t * y + off * x];
        let (tip, base) = (long - 5.5, long - 12.5);
        let [p, q, r] = [at(base, 1.5), at(tip, 0.0), at(base, -1.5)].map(|[x, y]| format!("{x} {y}"));
        line([at(5.5, 0.0), at(base, 0.0)], "stroke=\"black\"") + &format!("<path d=\"M{p}L{q}L{r}z\"/>")
    };
    let answer = judge(&page(&|ends| line(ends, "stroke=\"black\"")), &page(&arrow));
    assert!(answer.is_equal(), "{}", answer.text());
}
