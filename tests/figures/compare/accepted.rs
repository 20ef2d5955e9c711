//! Further ways to draw the same that other programs and people use.

use super::pen::{P, Pen, document};
use super::{judge, refused, ship};

fn plain() -> String {
    Pen::new(&ship()).svg()
}

#[track_caller]
fn equal(svg: &str) {
    let answer = judge(&plain(), svg);
    assert!(answer.is_equal(), "{}\n{svg}", answer.text());
}

#[track_caller]
fn says(svg: &str, said: &str) {
    let answer = judge(&plain(), svg);
    assert!(!answer.is_equal() && answer.text().contains(said), "`{said}` not said: {}\n{svg}", answer.text());
}

/// The drawing with each line, each circle and each face written by these.
fn drawn(line: impl Fn(P, P) -> String, dot: impl Fn(P) -> String, area: impl Fn(&[P]) -> String) -> String {
    let pen = Pen::new(&ship());
    let areas = pen.areas.iter().map(|ring| area(&ring.iter().map(|&p| Pen::canvas(p)).collect::<Vec<_>>()));
    let lines = pen.lines.iter().map(|&[a, b]| line(Pen::canvas(a), Pen::canvas(b)));
    let dots = pen.dots.iter().map(|&p| dot(Pen::canvas(p)));
    document(&areas.chain(lines).chain(dots).collect::<Vec<_>>())
}

fn line([a, b]: P, [c, d]: P) -> String {
    format!("<line x1=\"{a}\" y1=\"{b}\" x2=\"{c}\" y2=\"{d}\" stroke=\"black\"/>")
}

fn dot([x, y]: P) -> String {
    format!("<circle cx=\"{x}\" cy=\"{y}\" r=\"4\"/>")
}

fn area(ring: &[P]) -> String {
    let points: Vec<String> = ring.iter().map(|[x, y]| format!("{x},{y}")).collect();
    format!("<polygon points=\"{}\" fill=\"#e8f0ff\"/>", points.join(" "))
}

#[test]
fn faces_may_be_filled_by_patterns_and_gradients() {
    let filled = |server: &str| {
        plain().replace("#e8f0ff", "url(#f)").replacen("400\">", &format!("400\"><defs>{server}</defs>"), 1)
    };
    let hatch = "<pattern id=\"f\" width=\"8\" height=\"8\" patternUnits=\"userSpaceOnUse\"><path d=\"M0 0L8 8\" stroke=\"navy\"/></pattern>";
    let tinted = hatch.replace("<path", "<rect width=\"8\" height=\"8\" fill=\"white\"/><path");
    let fading = "<linearGradient id=\"f\"><stop stop-color=\"gold\"/><stop offset=\"1\" stop-color=\"white\"/></linearGradient>";
    let linked = hatch.replace("\"f\"", "\"h\"") + "<pattern id=\"f\" href=\"#h\" patternTransform=\"rotate(45)\"/>";
    for server in [hatch, &tinted, fading, &linked] {
        equal(&filled(server));
    }
    // A hatch lets lines be seen in its own colour, and a full tile does not.
    equal(&filled(&hatch.replace("navy", "black")));
    let full = hatch.replace("<path d=\"M0 0L8 8\" stroke=\"navy\"", "<rect width=\"8\" height=\"8\"");
    says(&filled(&full), "33 edges cannot be seen");
    for (server, said) in [
        ("<pattern id=\"f\" width=\"8\" height=\"8\"/>".to_owned(), "no face is filled"),
        (hatch.replace("stroke=\"navy\"", ""), "no face is filled"),
        (hatch.replace("width=\"8\"", "width=\"0\""), "no face is filled"),
        (hatch.replace("navy", "white"), "cannot be told from the paper"),
        (hatch.replace("<path", "<path opacity=\"0\""), "no face is filled"),
    ] {
        says(&filled(&server), said);
    }
}

#[test]
fn style_rules_of_all_usual_kinds_are_read() {
    let with = |rules: &str| plain().replacen("400\">", &format!("400\"><style>{rules}</style>"), 1);
    let first = |attributes: &str, rules: &str| {
        with(rules).replacen("stroke=\"black\"", &format!("stroke=\"black\" {attributes}"), 1)
    };
    // Each of these hides all edges.
    for rule in [
        "*{stroke:none}",
        "svg > line{stroke:none}",
        "svg>line{stroke:white}",
        "[stroke]{stroke:white}",
        "line[stroke='black']{stroke:#fff}",
        "line:not(.x){stroke:white}",
        ":root line{stroke:white}",
        "line:not([class], #b):not(circle) { stroke: white }",
        "@media screen{line{stroke:white}}",
        "line:not(:hover){stroke:white}",
        "svg:not(:has(g:target)) line{stroke:white}",
        "@supports selector(:has(a)){@media screen{line{display:none}}}",
        "@media screen{line{stroke:none}}",
        "@media print, screen{line{stroke:white}}",
        "@media all{polygon{fill:gold}line{stroke:white}}",
        "@import 'x.css'; line{stroke:white}",
        "/* edges */ line{stroke:white}",
        "line/**/,a{stroke:white}",
    ] {
        let answer = judge(&plain(), &with(rule));
        assert!(!answer.is_equal() && answer.text().contains("33 edges "), "{rule}: {}", answer.text());
    }
    for (attributes, rule) in [
        ("class=\"a b\"", "[class~=b]{stroke:white}"),
        ("class=\"a b\"", "[class^=\"a b\"]{stroke:white}"),
        ("id=\"edge-1\"", "[id|=edge]{stroke:white}"),
        ("id=\"edge-1\"", "line[id$='-1']{stroke:white}"),
        ("id=\"edge-1\"", "svg *[id*=dge]{stroke:white}"),
    ] {
        says(&first(attributes, rule), "1 difference");
    }
    // And each of these none.
    for rule in [
        "g > line{stroke:none}",
        "svg > svg line{stroke:none}",
        "[class~=b]{stroke:none}",
        "line[stroke=red]{stroke:none}",
        "line:not([stroke]){stroke:none}",
        "line:root{stroke:none}",
        "@media print{line{stroke:white}}",
        "*{stroke:none}line{stroke:navy}",
        "@font-face{font-family:x;src:url(y)}",
        "line:nth-child(2){cursor:pointer}",
        "line:hover + line{stroke:none}",
        "svg:has(g:target) line{stroke:none}",
    ] {
        equal(&with(rule));
    }
    // What cannot be told is never passed over.
    for (rule, said) in [
        ("line:nth-child(2){stroke:white}", "the style rule `line:nth-child(2)` changes what is seen"),
        ("polygon + line{fill:red;stroke:white}", "the style rule `polygon + line` changes what is seen"),
        ("@supports (display:block){line{stroke:white}}", "the style rule `@supports (display:block)` changes"),
        ("@media (min-width:9px){line{stroke:white}}", "the style rule `@media (min-width:9px)` changes"),
        (
            "@media (prefers-color-scheme:light){line{stroke:none}}",
            "the style rule `@media (prefers-color-scheme:light)` hides",
        ),
        ("@media print, (min-width:1px){line{stroke:white}}", "the style rule `@media print, (min-width:1px)` changes"),
        ("@media not print{line{stroke:white}}", "the style rule `@media not print` changes"),
        ("svg{line{stroke:white}}", "the style rule `svg` changes"),
        ("line:nth-child(2):not(:hover){stroke:none}", "the style rule `line:nth-child(2):not(:hover)` hides"),
        ("line ~ line{stroke:none}", "the style rule `line ~ line` hides"),
    ] {
        let error = refused(&with(rule));
        assert!(error.contains(said), "{rule}: {error}");
    }
}

#[test]
fn dots_may_be_lines_of_hardly_any_length() {
    let round = "stroke=\"red\" stroke-width=\"7\" stroke-linecap=\"round\"";
    for end in ["h0", "z", "l0 0", "h.001", "l.02 -.02", "L{x} {y}"] {
        let dot = |[x, y]: P| {
            let end = end.replace("{x}", &x.to_string()).replace("{y}", &y.to_string());
            format!("<path {round} d=\"M{x} {y}{end}\"/>")
        };
        equal(&drawn(line, dot, area));
    }
    // All in one path, and as lines.
    let pen = Pen::new(&ship());
    let all: String = pen.dots.iter().map(|&p| Pen::canvas(p)).map(|[x, y]| format!("M{x} {y}h.002")).collect();
    equal(&drawn(line, |_| String::new(), area).replace("</svg>", &format!("<path {round} d=\"{all}\"/></svg>")));
    equal(&drawn(line, |[x, y]| format!("<line {round} x1=\"{x}\" y1=\"{y}\" x2=\"{}\" y2=\"{y}\"/>", x + 0.01), area));
    says(
        &drawn(line, |[x, y]| format!("<path stroke=\"red\" stroke-width=\"7\" d=\"M{x} {y}h0\"/>"), area),
        "no vertex is drawn",
    );
}

#[test]
fn curves_that_are_straight_are_lines() {
    let thirds = |[a, b]: P, [c, d]: P, t: f64| [a + t * (c - a), b + t * (d - b)];
    let path = |d: String| format!("<path fill=\"none\" stroke=\"black\" d=\"{d}\"/>");
    let cubic = |p: P, q: P| {
        let ([a, b], [c, d]) = (thirds(p, q, 0.3), thirds(p, q, 0.7));
        path(format!("M{} {}C{a} {b} {c} {d} {} {}", p[0], p[1], q[0], q[1]))
    };
    let quadratic = |p: P, q: P| {
        let [a, b] = thirds(p, q, 0.5);
        path(format!("M{} {}Q{a} {b} {} {}", p[0], p[1], q[0], q[1]))
    };
    let arc = |p: P, q: P| path(format!("M{} {}A0 9 0 0 1 {} {}", p[0], p[1], q[0], q[1]));
    let at_ends = |p: P, q: P| path(format!("M{0} {1}C{0} {1} {2} {3} {2} {3}", p[0], p[1], q[0], q[1]));
    equal(&drawn(cubic, dot, area));
    equal(&drawn(quadratic, dot, area));
    equal(&drawn(arc, dot, area));
    equal(&drawn(at_ends, dot, area));
    let bent = |p: P, q: P| {
        path(format!(
            "M{} {}Q{} {} {} {}",
            p[0],
            p[1],
            0.5 * (p[0] + q[0]) + 3.0,
            0.5 * (p[1] + q[1]) + 3.0,
            q[0],
            q[1]
        ))
    };
    assert!(!judge(&plain(), &drawn(bent, dot, area)).is_equal());
}

#[test]
fn of_a_switch_the_first_child_that_fits_is_drawn() {
    let switched = |before: &str| {
        let svg = plain().replacen("400\">", &format!("400\"><switch>{before}<g>"), 1);
        svg.replacen("</svg>", "</g></switch></svg>", 1)
    };
    equal(&switched(""));
    equal(&switched(
        "<g requiredExtensions=\"http://x.org/y\"><circle r=\"9\"/></g><g systemLanguage=\"de, fr\"><line x2=\"9\" stroke=\"red\"/></g>",
    ));
    assert!(
        !judge(&plain(), &switched("<g systemLanguage=\"de, en-GB\"><path d=\"M0 0L9 9\" stroke=\"red\"/></g>"))
            .is_equal()
    );
    // The condition counts everywhere.
    let foreign = plain().replacen("<line ", "<line systemLanguage=\"tlh\" ", 1);
    says(&foreign, "is missing");
    let second = plain().replacen("<line ", "<switch><g/><line ", 1).replacen(
        "stroke=\"black\"/>",
        "stroke=\"black\"/></switch>",
        1,
    );
    says(&second, "is missing");
}

#[test]
fn a_corner_on_a_straight_side_of_a_face_is_no_corner() {
    let with_middles = |ring: &[P]| {
        let ahead = |i: usize| ring[(i + 1) % ring.len()];
        let ring: Vec<P> =
            (0..ring.len()).flat_map(|i| [ring[i], [0, 1].map(|k| 0.5 * (ring[i][k] + ahead(i)[k]))]).collect();
        area(&ring)
    };
    equal(&drawn(line, dot, with_middles));
    let bent = |ring: &[P]| {
        let mut ring = ring.to_vec();
        ring.insert(1, [0.5 * (ring[0][0] + ring[1][0]) + 1.0, 0.5 * (ring[0][1] + ring[1][1]) + 1.0]);
        area(&ring)
    };
    says(&drawn(line, dot, bent), "is no face of the reference");
}

/// A drawing with a legend whose corner is here.
fn with_legend(drawing: &str, [x, y]: P, name: &str) -> String {
    let (right, low) = (x + 40.0, y + 20.0);
    let inside = format!(
        "<g {name}><polygon points=\"{x},{y} {right},{y} {right},{low} {x},{low}\" fill=\"white\" stroke=\"#ccc\"/>\
         <line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" stroke=\"black\"/><circle cx=\"{}\" cy=\"{}\" r=\"3\"/></g>",
        x + 4.0,
        y + 5.0,
        x + 16.0,
        y + 5.0,
        x + 10.0,
        y + 14.0
    );
    drawing.replacen("</svg>", &format!("{inside}</svg>"), 1)
}

#[test]
fn a_legend_may_stand_in_a_free_corner_of_the_drawing() {
    let legend = |x: f64, y: f64, name: &str| with_legend(&plain(), [x, y], name);
    let [x, y] = FREE;
    equal(&legend(x, y, "id=\"legend_1\""));
    equal(&legend(x, y, "class=\"my legend\""));
    assert!(!judge(&plain(), &legend(x, y, "id=\"key\"")).is_equal());
    // Over an edge, it is no part of its corner.
    let [a, b] = Pen::canvas(Pen::new(&ship()).dots[12]);
    assert!(!judge(&plain(), &legend(a - 9.0, b - 9.0, "id=\"legend_1\"")).is_equal());
}

#[test]
fn where_axes_are_part_of_the_reference_legends_are_not() {
    let axes =
        "<g id=\"matplotlib.axis_1\"><path d=\"M10 10H590V390H10ZM10 200H30\" fill=\"none\" stroke=\"black\"/></g>";
    let framed = plain().replacen("</svg>", &format!("{axes}</svg>"), 1);
    let keyed = with_legend(&framed, FREE, "id=\"legend_1\"");
    for [reference, student] in [[&framed, &keyed], [&keyed, &framed], [&keyed, &format!("{keyed} ")]] {
        let answer = judge(reference, student);
        assert!(answer.is_equal(), "{}", answer.text());
    }
    // Nothing else is left out with it.
    for less in ["H590", "V390", "ZM10 200H30"] {
        let student = keyed.replacen(less, "", 1);
        assert!(keyed != student && !judge(&framed, &student).is_equal(), "{less}");
        assert!(!judge(&student, &framed).is_equal(), "{less}");
    }
}

/// A corner of the drawing where a legend covers nothing.
const FREE: P = [480.0, 100.0];

#[test]
fn vertices_may_be_squares_or_crosses() {
    let square = |[x, y]: P| format!("<rect x=\"{}\" y=\"{}\" width=\"8\" height=\"8\"/>", x - 4.0, y - 4.0);
    let hollow = |[x, y]: P| format!("<path fill=\"none\" stroke=\"red\" d=\"M{} {}h8v8h-8z\"/>", x - 4.0, y - 4.0);
    let rimmed = |[x, y]: P| format!("<path fill=\"gold\" stroke=\"red\" d=\"M{x} {}l5 5l-5 5l-5 -5z\"/>", y - 5.0);
    let cross =
        |[x, y]: P| format!("<path stroke=\"red\" d=\"M{} {}l8 8M{} {}l-8 8\"/>", x - 4.0, y - 4.0, x + 4.0, y - 4.0);
    let plus = |[x, y]: P| format!("<path stroke=\"red\" d=\"M{} {y}h8M{x} {}v8\"/>", x - 4.0, y - 4.0);
    let ways: [&dyn Fn(P) -> String; 5] = [&square, &hollow, &rimmed, &cross, &plus];
    for dot in ways {
        let svg = drawn(line, dot, area);
        equal(&svg);
        let lines: Vec<&str> = svg.lines().collect();
        let without = [&lines[..lines.len() - 2], &lines[lines.len() - 1..]].concat().join("\n");
        says(&without, "is missing: no circle is drawn there");
        let moved = svg.replacen("<line", "<line transform=\"translate(2 0)\"", 1);
        assert!(!judge(&plain(), &moved).is_equal());
    }
    says(
        &drawn(line, |p| square(p).replace("/>", " fill=\"white\"/>"), area),
        "22 vertices have the colour of the paper",
    );
    let far = |[x, y]: P| square([x + 2.0, y]);
    says(&drawn(line, far, area), "no vertex is drawn");
    // Squares with a label in the middle of lines are no vertices.
    let pen = Pen::new(&ship());
    let boxes: Vec<String> = pen
        .lines
        .iter()
        .map(|&[a, b]| {
            square(Pen::canvas([0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])])).replace("/>", " fill=\"white\"/>")
        })
        .collect();
    equal(&plain().replacen("</svg>", &format!("{}</svg>", boxes.concat()), 1));
}

#[test]
fn vertices_may_be_small_figures() {
    // Corners about a vertex, as plotting programs have them; those of the triangles lie about the middle of their box.
    let ring = |count: u32, inner: f64, turn: f64| {
        let corner = move |i: u32| {
            let angle = turn + std::f64::consts::TAU * f64::from(i) / f64::from(count);
            let radius = if i % 2 == 1 { 5.0 * inner } else { 5.0 };
            [radius * angle.sin(), -radius * angle.cos()]
        };
        (0..count).map(corner).collect::<Vec<P>>()
    };
    let triangle = |side: f64| vec![[0.0, -side], [-4.0, side], [4.0, side]];
    let figures = [
        ring(5, 1.0, 0.0),
        ring(6, 1.0, 0.0),
        ring(6, 1.0, 0.5),
        ring(8, 1.0, 0.4),
        ring(10, 0.381_966, 0.0),
        ring(3, 1.0, 0.0),
        triangle(4.0),
        triangle(-4.0),
    ];
    for figure in figures {
        for style in ["", "fill=\"gold\" stroke=\"red\"", "fill=\"none\" stroke=\"red\" stroke-width=\"1.5\""] {
            let at = |[x, y]: P| {
                let points: Vec<String> = figure.iter().map(|[a, b]| format!("{:.4} {:.4}", x + a, y + b)).collect();
                format!("<path d=\"M{}z\" {style}/>", points.join("L"))
            };
            let svg = drawn(line, at, area);
            equal(&svg);
            let lines: Vec<&str> = svg.lines().collect();
            let without = [&lines[..lines.len() - 2], &lines[lines.len() - 1..]].concat().join("\n");
            says(&without, "is missing: no circle is drawn there");
            assert!(!judge(&plain(), &drawn(line, |[x, y]| at([x + 2.0, y]), area)).is_equal());
        }
    }
}

/// The drawing without circles; each line has this marker at its ends.
fn marked(marker: &str, line: &str) -> String {
    let bare = drawn(
        |[a, b], [c, d]| {
            format!("<path fill=\"none\" stroke=\"black\" stroke-width=\"2\" d=\"M{a} {b}L{c} {d}\" {line}/>")
        },
        |_| String::new(),
        area,
    );
    bare.replacen("400\">", &format!("400\"><defs>{marker}</defs>"), 1)
}

#[test]
fn vertices_may_be_circles_that_markers_draw() {
    let ends = "marker-start=\"url(#m)\" marker-end=\"url(#m)\"";
    let marker = |attributes: &str, inside: &str| format!("<marker id=\"m\" {attributes}>{inside}</marker>");
    let room = "markerWidth=\"5\" markerHeight=\"5\" refX=\"2.5\" refY=\"2.5\"";
    let circle = "<circle cx=\"2.5\" cy=\"2.5\" r=\"2\"/>";
    equal(&marked(&marker(room, circle), ends));
    equal(&marked(&marker(room, "<g fill=\"red\"><ellipse cx=\"2.5\" cy=\"2.5\" rx=\"2\"/></g>"), ends));
    equal(&marked(&marker(room, "<path d=\"M4.5 2.5a2 2 0 0 1 -4 0a2 2 0 0 1 4 0z\"/>"), ends));
    equal(&marked(&marker(&format!("{room} orient=\"auto\" viewBox=\"0 0 5 5\""), circle), ends));
    equal(&marked(&marker("overflow=\"visible\"", "<circle r=\"2\" fill=\"white\" stroke=\"red\"/>"), ends));
    // What is wrong with such a circle is wrong with any.
    let bare = marked(&marker(room, circle), "");
    says(&bare, "no vertex is drawn");
    says(
        &marked(&marker(room, &circle.replace("/>", " fill=\"white\"/>")), ends),
        "22 vertices have the colour of the paper",
    );
    says(&marked(&marker(room, &circle.replace("/>", " opacity=\"0\"/>")), ends), "22 vertices cannot be seen");
    says(&marked(&marker("overflow=\"visible\"", "<circle r=\"200\"/>"), ends), "make the circles smaller");
    let moved = marked(&marker(room, circle), ends).replacen("<path", "<path transform=\"translate(2 0)\"", 1);
    assert!(!judge(&plain(), &moved).is_equal());
    // A circle at the end of one more line is a vertex too much.
    let extra = plain().replacen(
        "</svg>",
        &format!("<defs>{}</defs><path d=\"M300 90L300 90.5\" marker-end=\"url(#m)\"/></svg>", marker(room, circle)),
        1,
    );
    says(&extra, "vertex at (300, 90.5) is not in the reference");
    // Heads of arrows are none, nor are circles beside the end.
    for head in
        ["<path d=\"M0 0L5 2.5L0 5z\"/>", "<circle cx=\"1\" cy=\"2.5\" r=\"1\"/>", "<rect width=\"5\" height=\"5\"/>"]
    {
        says(&marked(&marker(room, head), ends), "no vertex is drawn");
        equal(&plain().replace("stroke=\"black\"", &format!("stroke=\"black\" {ends}")).replacen(
            "400\">",
            &format!("400\"><defs>{}</defs>", marker(&format!("{room} orient=\"auto\""), head)),
            1,
        ));
    }
}

#[test]
fn of_a_stepper_the_frame_that_is_seen_is_read() {
    let stepper = include_str!("../../../figures/stepper-split-face.svg");
    let answer = judge(stepper, &stepper.replace('\n', " "));
    assert!(answer.is_equal(), "{}", answer.text());
    let white = stepper.replacen("<style>", "<style>.fr .edge{stroke:#fff!important}", 1);
    assert!(!judge(stepper, &white).is_equal());
}
