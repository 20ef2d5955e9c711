//! Edges that the reference does not have are told as soon as they show; ovals, rims of letters, helpers that nobody
//! sees and arrow heads are read as an eye reads them.

use super::arrows::heads_on_their_bases;
use super::declared::reference;
use super::judge;
use std::fmt::Write;

type P = [f64; 2];

const CORNERS: [P; 5] = [[100.0, 300.0], [500.0, 300.0], [500.0, 100.0], [100.0, 100.0], [300.0, 40.0]];
const EDGES: [[usize; 2]; 6] = [[0, 1], [1, 2], [2, 3], [3, 0], [0, 2], [2, 4]];
/// The other diagonal.
const STRANGER: &str = "<line x1=\"500\" y1=\"300\" x2=\"100\" y2=\"100\" stroke=\"#333\" stroke-width=\"1.5\"/>";

fn line([[a, b], [c, d]]: [P; 2], more: &str) -> String {
    format!("<line x1=\"{a}\" y1=\"{b}\" x2=\"{c}\" y2=\"{d}\" stroke=\"#333\" stroke-width=\"1.5\"{more}/>")
}

fn circle([x, y]: P) -> String {
    format!("<circle cx=\"{x}\" cy=\"{y}\" r=\"4\"/>")
}

/// The drawing: this behind all, its edges, its vertices, and this before all.
fn drawn(behind: &str, edge: impl Fn(usize, [P; 2]) -> String, vertex: impl Fn(P) -> String, before: &str) -> String {
    let edges = (0..).zip(EDGES).map(|(i, ends)| edge(i, ends.map(|v| CORNERS[v])));
    let parts: Vec<String> = edges.chain(CORNERS.map(vertex)).collect();
    let body = parts.join("\n");
    format!("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 600 400\">{behind}{body}{before}</svg>")
}

fn edge(_: usize, ends: [P; 2]) -> String {
    line(ends, "")
}

fn plain() -> String {
    drawn("", edge, circle, "")
}

#[track_caller]
fn same(svg: &str) {
    let answer = judge(&plain(), svg);
    assert!(answer.is_equal(), "{}\n{svg}", answer.text());
}

#[track_caller]
fn says(svg: &str, said: &str) {
    let answer = judge(&plain(), svg);
    assert!(answer.text().contains(said), "`{said}` not said: {}\n{svg}", answer.text());
}

#[test]
fn an_edge_too_many_is_told_if_a_part_of_it_shows() {
    let said = "edge between (500, 300) and (100, 100) is not in the reference";
    let bar = |from: f64, to: f64, wide: f64| {
        let at = |t: f64, aside: f64| format!("{},{}", 500.0 - 400.0 * t - aside, 300.0 - 200.0 * t + 2.0 * aside);
        let corners = [at(from, wide), at(to, wide), at(to, -wide), at(from, -wide)].join(" ");
        format!("<polygon points=\"{corners}\" fill=\"white\"/>")
    };
    for (from, to) in [(0.4, 0.6), (0.2, 0.7), (0.1, 0.8), (0.3, 1.0), (0.0, 0.75)] {
        says(&drawn(&format!("{STRANGER}{}", bar(from, to, 4.0)), edge, circle, ""), said);
    }
    let eraser = STRANGER.replace("#333", "white").replace("1.5", "4");
    for (scale, is_told) in [(1.0, false), (0.96, false), (0.6, true), (0.3, true)] {
        let shorter = format!("<g transform=\"translate(300 200) scale({scale}) translate(-300 -200)\">{eraser}</g>");
        let svg = drawn(&format!("{STRANGER}{shorter}"), edge, circle, "");
        if is_told { says(&svg, said) } else { same(&svg) }
    }
    // Below a face it is hidden, and below one of two it is not.
    let [lower, upper] = ["100,300 500,300 500,100", "100,300 500,100 100,100"]
        .map(|points| format!("<polygon points=\"{points}\" fill=\"pink\"/>"));
    same(&drawn(&format!("{STRANGER}{lower}{upper}"), edge, circle, ""));
    says(&drawn(&format!("{STRANGER}{lower}"), edge, circle, ""), said);
    // It passes below the circle of another vertex.
    let other = circle([200.0, 155.0]).replace("r=\"4\"", "r=\"24\" fill=\"white\" stroke=\"black\"");
    let answer = judge(&drawn("", edge, circle, &other), &drawn(STRANGER, edge, circle, &other));
    assert!(answer.text().contains(said), "{}", answer.text());
}

/// As programs draw boxes round what can be clicked.
#[test]
fn lines_that_nobody_sees_bind_no_ends() {
    let rims = |more: &dyn Fn([P; 2]) -> String| {
        let short = |_: usize, ends: [P; 2]| {
            let [[a, b], [c, d]] = ends;
            let part = 9.0 / (c - a).hypot(d - b);
            let [x, y] = [part * (c - a), part * (d - b)];
            let ends = [[a + x, b + y], [c - x, d - y]];
            line(ends, "") + &more(ends)
        };
        let hollow = |p: P| circle(p).replace("r=\"4\"", "r=\"9\" fill=\"white\" stroke=\"black\"");
        drawn("", short, hollow, "")
    };
    same(&rims(&|_| String::new()));
    same(&rims(&|[[a, b], [c, d]]| {
        let [x, y] = [a.min(c), b.min(d)];
        let (width, height) = ((a - c).abs() + 2.0, (b - d).abs() + 2.0);
        format!(
            "<rect x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\" fill=\"none\" stroke=\"none\"/>\
             <polyline points=\"{a},{b} {c},{d} 9,9\" fill=\"none\" stroke=\"red\" opacity=\"0\"/>"
        )
    }));
    // What is seen does bind them.
    let seen = rims(&|[[a, b], _]| format!("<path d=\"M{a} {b}l9 21\" stroke=\"red\"/>"));
    assert!(!judge(&plain(), &seen).is_equal());
}

/// An ellipse with these half axes, by an element, arcs or curves.
fn ovals([rx, ry]: [f64; 2], style: &str) -> [Box<dyn Fn(P) -> String>; 4] {
    let style = style.to_owned();
    let [s1, s2, s3, s4] = [style.clone(), style.clone(), style.clone(), style];
    let arcs =
        move |[x, y]: P| format!("M{} {y}A{rx} {ry} 0 1 1 {} {y}A{rx} {ry} 0 1 1 {} {y}z", x + rx, x - rx, x + rx);
    let turned = move |p: P| {
        let [x, y] = p;
        format!("<path transform=\"rotate(30 {x} {y})\" d=\"{}\" {s3}/>", arcs(p))
    };
    let curves = move |[x, y]: P| {
        let (a, b) = (0.5523 * rx, 0.5523 * ry);
        format!(
            "<path d=\"M{x} {}c{a} 0 {rx} {} {rx} {ry}s{} {ry} -{rx} {ry} -{rx} {} -{rx} -{ry} {} -{ry} {rx} -{ry}z\" {s4}/>",
            y - ry,
            ry - b,
            a - rx,
            b - ry,
            rx - a
        )
    };
    [
        Box::new(move |[x, y]| format!("<ellipse cx=\"{x}\" cy=\"{y}\" rx=\"{rx}\" ry=\"{ry}\" {s1}/>")),
        Box::new(move |p| format!("<path d=\"{}\" {s2}/>", arcs(p))),
        Box::new(turned),
        Box::new(curves),
    ]
}

#[test]
fn ellipses_are_vertices_whatever_draws_them() {
    for style in ["", "fill=\"none\" stroke=\"black\"", "fill=\"white\" stroke=\"black\" stroke-width=\".6\""] {
        for axes in [[6.0, 4.5], [27.0, 18.0], [9.0, 21.0], [8.0, 3.0]] {
            for vertex in ovals(axes, style) {
                same(&drawn("", edge, &vertex, ""));
                let all = drawn("", edge, &vertex, "");
                let last = vertex(CORNERS[4]);
                assert!(!judge(&plain(), &all.replace(&last, "")).is_equal(), "{last}");
                says(&all.replace(&last, &vertex([300.0, 46.0])), "vertex at (300, 4");
                says(
                    &drawn("", edge, &vertex, &vertex([560.0, 360.0])),
                    "vertex at (560, 360) is not in the reference",
                );
                says(&all.replace(&last, &last.replace("/>", " opacity=\"0\"/>")), "vertex at (300, 40)");
            }
        }
    }
    // Lines end at the rims of ellipses, as with programs that lay out graphs.
    let short = |_: usize, [[a, b], [c, d]]: [P; 2]| {
        let part = 1.0 / ((c - a) / 27.0).hypot((d - b) / 18.0);
        let [x, y] = [part * (c - a), part * (d - b)];
        line([[a + x, b + y], [c - x, d - y]], "")
    };
    for vertex in ovals([27.0, 18.0], "fill=\"none\" stroke=\"black\"").into_iter().take(2) {
        same(&drawn("", short, &vertex, ""));
    }
    // Too flat, or not all round.
    for path in ["M304 40A20 3 0 1 1 296 40A20 3 0 1 1 304 40z", "M327 40A27 18 0 0 1 273 40z"] {
        let other = |p: P| if p == CORNERS[4] { format!("<path d=\"{path}\"/>") } else { circle(p) };
        assert!(!judge(&plain(), &drawn("", edge, other, "")).is_equal(), "{path}");
    }
}

#[test]
fn letters_without_curves_have_rims() {
    // The letters v and 1.
    let letters = |x: f64, y: f64, style: &str| {
        let v = format!("M{x} {y}l2 0 4 -10 -2 0 -3 8 -3 -8 -2 0z");
        let one = format!("M{} {y}h6v-1h-2v-9h-2l-2 1v1l2 -1v8h-2z", x + 6.0);
        format!("<path d=\"{v}{one}\" {style}/>")
    };
    let faces = "<polygon points=\"100,300 500,300 500,100\" fill=\"#cfe3f5\"/>\
                 <polygon points=\"100,300 500,100 100,100\" fill=\"#f8dfc2\"/>";
    let reference = drawn(faces, edge, circle, "");
    for style in ["stroke=\"white\" stroke-width=\"3\"", "fill=\"#222\" stroke=\"#fff\" stroke-width=\"2\""] {
        for [x, y] in [[112.0, 288.0], [515.0, 95.0], [520.0, 300.0], [200.0, 150.0]] {
            let rim = letters(x, y, style);
            let svg = drawn(faces, edge, circle, &format!("{rim}{}", letters(x, y, "")));
            let answer = judge(&reference, &svg);
            assert!(answer.is_equal(), "{style} {x} {y}: {}", answer.text());
        }
    }
    // A rim that shows is drawn by lines, and so is a small triangle beside the structure, also of one colour.
    for style in [
        "fill=\"white\" stroke=\"black\"",
        "stroke=\"black\"",
        "fill=\"none\" stroke=\"black\"",
        "fill-opacity=\".1\" stroke=\"black\"",
    ] {
        let svg = drawn(faces, edge, circle, &format!("<path d=\"M520 200l40 0 -20 30z\" {style}/>"));
        assert!(!judge(&reference, &svg).is_equal(), "{style}");
    }
}

#[test]
fn a_box_is_as_wide_as_the_letters_of_its_name() {
    let boxed = |width: f64, text: &str| {
        let left = 300.0 - 0.5 * width;
        format!(
            "<rect x=\"{left}\" y=\"340\" width=\"{width}\" height=\"16\" fill=\"white\" stroke=\"black\"/>\
             <text x=\"300\" y=\"352\" text-anchor=\"middle\" font-size=\"12\">{text}</text>"
        )
    };
    for (width, text) in [(20.5, "v10"), (13.5, "f1"), (22.0, "v10"), (30.0, "v10")] {
        same(&drawn("", edge, circle, &boxed(width, text)));
    }
    for (width, text) in [(5.0, "v10"), (20.0, "the names of all vertices")] {
        assert!(!judge(&plain(), &drawn("", edge, circle, &boxed(width, text))).is_equal(), "{width} {text}");
    }
}

#[test]
fn an_isolated_triangle_stands_as_the_others_do() {
    // Two triangles stand on the middles of their boxes, as plotting programs draw them.
    let triangle = |[x, y]: P| format!("<path d=\"M{x} {}l6 12h-12z\" fill=\"green\"/>", y - 6.0);
    let alone = [550.0, 250.0];
    let reference = drawn("", edge, circle, &circle(alone));
    let answer = judge(&reference, &drawn("", edge, triangle, &triangle(alone)));
    assert!(answer.is_equal(), "{}", answer.text());
    assert!(!judge(&reference, &drawn("", edge, triangle, &triangle([550.0, 252.0]))).is_equal());
    assert!(!judge(&reference, &drawn("", edge, triangle, "")).is_equal());
}

#[test]
fn dashes_are_measured_by_the_length_that_is_stated() {
    let styled = |style: &str| drawn("", |i, ends| line(ends, if i == 4 { style } else { "" }), circle, "");
    for style in [
        " pathLength=\"1\" stroke-dasharray=\"1\"",
        " pathLength=\"10\" stroke-dasharray=\".2 .1\"",
        " pathLength=\"0\" stroke-dasharray=\"6 4\"",
        " pathLength=\"5000\" stroke-dasharray=\"50 50\"",
        " pathLength=\"1\" style=\"stroke-dasharray:1;stroke-dashoffset:0\"",
    ] {
        same(&styled(style));
    }
    for style in [
        " pathLength=\"1\" stroke-dasharray=\".3 .4 .3 0\"",
        " pathLength=\"100\" stroke-dasharray=\"50 100\"",
        " pathLength=\"1\" stroke-dasharray=\"0 1\"",
        " pathLength=\"1\" style=\"stroke-dasharray:1;stroke-dashoffset:1\"",
    ] {
        says(&styled(style), "edge between (100, 300) and (500, 100) cannot be seen: its dashes leave it out");
    }
    // Of a path it is the length of all of it.
    let mut path = String::new();
    for ends in EDGES.map(|ends| ends.map(|v| CORNERS[v])) {
        let _ = write!(path, "M{} {}L{} {}", ends[0][0], ends[0][1], ends[1][0], ends[1][1]);
    }
    let whole = |dashes: &str| {
        let path = format!(
            "<path d=\"{path}\" fill=\"none\" stroke=\"black\" pathLength=\"1\" stroke-dasharray=\"{dashes}\"/>"
        );
        drawn("", |_, _| String::new(), circle, &path)
    };
    same(&whole("1"));
    same(&whole(".004 .002"));
    assert!(!judge(&plain(), &whole(".1 .2")).is_equal());
}

#[test]
fn heads_stand_on_the_ends_of_their_lines() {
    for size in [4.0, 5.5, 6.0, 7.0] {
        let answer = judge(&reference(), &heads_on_their_bases(size));
        assert!(answer.is_equal(), "{size}: {}", answer.text());
    }
}

/// A small square at a corner of a drawing holds nothing, and all else is no tick of it. Lines that reach the squares end at
/// vertices: see `nodes`.
#[test]
fn a_frame_holds_something() {
    let short = |_: usize, [[a, b], [c, d]]: [P; 2]| {
        let part = 14.0 / (c - a).abs().max((d - b).abs());
        let [x, y] = [part * (c - a), part * (d - b)];
        line([[a + x, b + y], [c - x, d - y]], "")
    };
    let square = |[x, y]: P| {
        format!(
            "<rect x=\"{}\" y=\"{}\" width=\"20\" height=\"20\" fill=\"white\" stroke=\"black\"/>",
            x - 10.0,
            y - 10.0
        )
    };
    let answer = judge(&plain(), &drawn("", short, square, ""));
    assert!(
        answer.text().contains("vertices, expected 5") || answer.text().contains("a line ends at"),
        "{}",
        answer.text()
    );
}
