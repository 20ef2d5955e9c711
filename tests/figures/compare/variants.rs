//! The table of drawings that mean the same as the reference and of those that do not: of each, what is said.

use super::pen::{P, Pen, document};
use super::{judge, references, ship, texts};
use crate::common::Random;

/// One line of the drawing: from the top of the mast's lower part to the deck.
const MAST: usize = 20;

/// The drawing with one change, and what is to be said about it.
struct Variant {
    name: &'static str,
    svg: String,
    /// A part of every sentence, in order; none: equal.
    said: Vec<&'static str>,
}

fn equal(name: &'static str, svg: String) -> Variant {
    Variant { name, svg, said: Vec::new() }
}

fn equal_variants(pen: &Pen) -> Vec<Variant> {
    let plain = pen.svg();
    // In another order within each layer: faces drawn over lines would hide them.
    let (all, mut random) = (pen.elements(), Random(7));
    let (areas, rest) = all.split_at(pen.areas.len());
    let (lines, dots) = rest.split_at(pen.lines.len());
    let mut shuffled = Vec::new();
    for layer in [areas, lines, dots] {
        shuffled.extend(random.shuffled(layer.len()).into_iter().map(|i| layer[i].clone()));
    }
    let mut reversed = pen.clone();
    reversed.dots.reverse();
    reversed.lines.reverse();
    reversed.lines.iter_mut().for_each(|line| line.reverse());
    reversed.areas.iter_mut().for_each(|area| area.rotate_left(2));
    let mut twice = pen.clone();
    twice.lines.extend(pen.lines.iter().map(|&[a, b]| [b, a]));
    vec![
        equal("elements of a layer in another order", document(&shuffled)),
        equal("attributes in another order, other quotes", attributes_reversed(pen)),
        equal("numbers written otherwise", numbers_rewritten(&plain)),
        equal("noise of a thousand-millionth", pen.moved(|[x, y]| [x + 1e-9 * y, y - 1e-9 * x]).svg()),
        equal("restyled, on dark paper", restyled(pen)),
        equal("lines as paths, their ends exchanged", as_paths(&reversed)),
        equal("vertices and edges numbered otherwise", reversed.svg()),
        equal("scaled", pen.moved(|[x, y]| [0.7 * x + 20.0, 0.7 * y - 3.0]).svg()),
        equal("the coordinates of the model under a transform", transformed(pen)),
        equal("a caption, a background, a comment", captioned(pen)),
        equal("every edge twice, as two half-edges", twice.svg()),
        equal("one line through several vertices", long_lines(pen)),
        equal("CRLF and a byte order mark", format!("\u{feff}{}", plain.replace('\n', "\r\n"))),
        equal("outer face drawn as well", with_outer_face(pen)),
    ]
}

fn attributes_reversed(pen: &Pen) -> String {
    let turned = |element: &String| {
        let inside = element.trim_start_matches('<').trim_end_matches("/>");
        let (name, attributes) = inside.split_once(' ').unwrap();
        let mut parts: Vec<&str> = attributes.split_inclusive("\" ").map(str::trim).collect();
        parts.reverse();
        format!("<{name}\n {}></{name}>", parts.join("\n ").replace('"', "'"))
    };
    document(&pen.elements().iter().map(turned).collect::<Vec<_>>())
}

/// `75` becomes `75.000000`, `12.5` becomes `+1.25e1`.
fn numbers_rewritten(svg: &str) -> String {
    let number = |word: &str| match word.parse::<f64>() {
        Ok(x) if word.contains('.') => format!("+{x:e}"),
        Ok(x) => format!("{x:.6}"),
        Err(_) => word.to_owned(),
    };
    let lines = svg.lines().map(|line| {
        if !line.starts_with("<line") && !line.starts_with("<polygon") && !line.starts_with("<circle") {
            return line.to_owned();
        }
        let words: Vec<String> = line
            .split('"')
            .map(|part| {
                part.split(' ')
                    .map(|w| w.split(',').map(number).collect::<Vec<_>>().join(","))
                    .collect::<Vec<_>>()
                    .join(" ")
            })
            .collect();
        words.join("\"")
    });
    lines.collect::<Vec<_>>().join("\n")
}

fn restyled(pen: &Pen) -> String {
    let mut elements = vec![
        "<style>.edge{stroke:white;stroke-width:3px} circle{fill:gold}</style>".to_owned(),
        "<rect width='600' height='400' fill='#101418'/>".to_owned(),
    ];
    let styled = |e: &String| e.replace("stroke=\"black\"", "class=\"edge\"").replace("#e8f0ff", "teal");
    elements.extend(pen.elements().iter().map(styled));
    document(&elements)
}

fn as_paths(pen: &Pen) -> String {
    let path = |e: &String| {
        let cut: Vec<&str> = e.split('"').collect();
        match e.starts_with("<line") {
            true => {
                let [a, b, c, d] = [1, 3, 5, 7].map(|i: usize| cut[i].parse::<f64>().unwrap());
                format!("<path fill=\"none\" stroke=\"black\" d=\"m{a} {b}l{},{}\"/>", c - a, d - b)
            }
            false if e.starts_with("<polygon") => {
                format!("<path fill=\"#e8f0ff\" fill-rule=\"evenodd\" d=\"M{}Z\"/>", cut[1].replacen(' ', " L", 1))
            }
            false => e.clone(),
        }
    };
    document(&pen.elements().iter().map(path).collect::<Vec<_>>())
}

fn transformed(pen: &Pen) -> String {
    let mut elements = vec!["<g transform=\"translate(300 200) scale(1,-1)\">".to_owned()];
    for area in &pen.areas {
        let points: Vec<String> = area.iter().map(|[x, y]| format!("{x} {y}")).collect();
        elements.push(format!("<polygon fill=\"pink\" points=\"{}\"/>", points.join(" ")));
    }
    elements.push("<g stroke=\"black\">".to_owned());
    for [a, b] in &pen.lines {
        elements.push(format!("<polyline fill=\"none\" points=\"{},{} {},{}\"/>", a[0], a[1], b[0], b[1]));
    }
    elements.push("</g>".to_owned());
    elements.push("<defs><circle id=\"dot\" r=\"3\"/></defs>".to_owned());
    for [x, y] in &pen.dots {
        elements.push(format!("<use href=\"#dot\" x=\"{x}\" y=\"{y}\"/>"));
    }
    elements.push("</g>".to_owned());
    document(&elements)
}

fn captioned(pen: &Pen) -> String {
    let mut elements = vec!["<rect width=\"100%\" height=\"100%\" fill=\"#fffff0\"/>".to_owned()];
    elements.extend(pen.elements());
    elements.push("<!-- drawn by me --><text x=\"9\" y=\"390\">My ship &amp; the sea</text>".to_owned());
    elements.push("<g display=\"none\"><line x1=\"0\" y1=\"0\" x2=\"600\" y2=\"400\" stroke=\"red\"/></g>".to_owned());
    document(&elements)
}

/// The lower side of the rectangle, in two edges, as one line.
fn long_lines(pen: &Pen) -> String {
    let mut other = pen.clone();
    let lower = |line: &[P; 2]| line.iter().all(|p| p[1] == -150.0);
    other.lines.retain(|line| !lower(line));
    other.lines.push([[-250.0, -150.0], [250.0, -150.0]]);
    assert_eq!(other.lines.len() + 1, pen.lines.len());
    other.svg()
}

fn with_outer_face(pen: &Pen) -> String {
    let plane = ship();
    let mut other = pen.clone();
    let at = |v| {
        let p = plane.point(v);
        [p.x, p.y]
    };
    other.areas.insert(0, plane.incident_vertices(plane.outer_face()).map(at).collect());
    other.svg()
}

fn wrong_variants(pen: &Pen) -> Vec<Variant> {
    let wrong = |name, svg, said: &[&'static str]| Variant { name, svg, said: said.to_vec() };
    let changed = |change: &dyn Fn(&mut Pen)| {
        let mut other = pen.clone();
        change(&mut other);
        other.svg()
    };
    let moved = |by: f64| {
        let from = pen.dots[12];
        pen.moved(|p| if p == from { [p[0] + by, p[1]] } else { p }).svg()
    };
    let [a, b] = pen.lines[MAST];
    let middle = [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])];
    let mut white = pen.elements();
    let mast = &mut white[pen.areas.len() + MAST];
    *mast = mast.replace("black", "#fefefe");
    vec![
        wrong("one edge missing", changed(&|pen| _ = pen.lines.remove(MAST)), &["edge MAST is missing"]),
        wrong(
            "an edge to the wrong vertex",
            changed(&|pen| pen.lines[MAST][1] = pen.dots[3]),
            &["edge MAST is missing", "edge between EXTRA is not in the reference"],
        ),
        wrong("a vertex 0.5 px off", moved(0.42), &["vertex DECK is 0.42 UNITS away: yours lies at NEAR"]),
        wrong("a vertex 3 px off", moved(2.5), &["vertex DECK is 2.5 UNITS away: yours lies at FAR"]),
        wrong(
            "a face clockwise",
            changed(&|pen| pen.areas[3].reverse()),
            &["face HULL … runs clockwise: list its corners counter-clockwise"],
        ),
        wrong("a face missing", changed(&|pen| _ = pen.areas.remove(3)), &["face HULL … is not filled"]),
        wrong("an edge in white", document(&white), &["edge MAST cannot be seen: it has the colour of the paper"]),
        wrong(
            "an edge in two without a vertex",
            changed(&|pen| {
                pen.lines[MAST] = [a, middle];
                pen.lines.push([middle, b]);
            }),
            &["edge MAST is cut in two at MIDDLE, where the reference has no vertex"],
        ),
        wrong("mirrored", pen.moved(|[x, y]| [-x, y]).svg(), &["the drawing is mirrored left-right"]),
        wrong("upside down", pen.moved(|[x, y]| [x, -y]).svg(), &["y points down: the drawing is upside down"]),
        wrong(
            "a vertex without its dot",
            changed(&|pen| _ = pen.dots.remove(12)),
            &["vertex DECK is missing: no circle is drawn there"],
        ),
        wrong(
            "no dots at all",
            changed(&|pen| pen.dots.clear()),
            &["no vertex is drawn: draw a circle at each vertex"],
        ),
        wrong("no faces at all", changed(&|pen| pen.areas.clear()), &["no face is filled"]),
        wrong(
            "turned",
            pen.moved(|[x, y]| [0.5 * y, -0.5 * x]).svg(),
            &["the drawing is turned by a quarter to the right"],
        ),
        wrong("all points elsewhere", pen.moved(|[x, y]| [x + 0.002 * y * y, y]).svg(), &["right shape, wrong place"]),
    ]
}

/// The words of a sentence that depend on the reference: names and coordinates, or px where it has none.
fn worded(said: &str, reference: &str) -> String {
    let plain = reference == "plain";
    let words = [
        ("MAST", "v10-v15 between (0, -75) and (0, 37.5)", "between (300, 275) and (300, 162.5)"),
        ("EXTRA", "(250, 150) and (0, 37.5)", "(550, 50) and (300, 162.5)"),
        ("DECK", "v12 at (-125, -75)", "at (175, 275)"),
        ("NEAR", "(-124.58, -75)", "(175.42, 275)"),
        ("FAR", "(-122.5, -75)", "(177.5, 275)"),
        ("HULL", "f4 along (62.5, -112.5), (0, -150)", "along (362.5, 312.5), (300, 350)"),
        ("MIDDLE", "(0, -18.75)", "(300, 218.75)"),
        ("UNITS", "units", "px"),
    ];
    words.iter().fold(said.to_owned(), |said, (word, model, px)| said.replace(word, if plain { px } else { model }))
}

#[test]
fn equal_drawings_are_equal_and_every_fault_is_named() {
    let pen = Pen::new(&ship());
    for (name, reference) in references() {
        for variant in equal_variants(&pen).into_iter().chain(wrong_variants(&pen)) {
            let answer = judge(&reference, &variant.svg);
            let said: Vec<String> = variant.said.iter().map(|said| worded(said, name)).collect();
            let texts = texts(&answer);
            let case = format!("{name}, {}: {}", variant.name, answer.text());
            assert_eq!(answer.is_equal(), said.is_empty(), "{case}");
            assert_eq!(texts.len(), said.len(), "{case}");
            for (text, said) in texts.iter().zip(&said) {
                let mut rest = *text;
                for part in said.split(" … ") {
                    let at = rest.find(part).unwrap_or_else(|| panic!("`{part}` not said; {case}"));
                    rest = &rest[at + part.len()..];
                }
            }
        }
    }
}
