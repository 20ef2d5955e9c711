//! Reference figures changed at random: what hides or moves something is refused, other ways to draw the same are not.

use super::pen::Pen;
use super::{Comparison, judge};
use crate::common::Random;
use dcel_kit::script::Script;
use std::fmt::Write;
use std::ops::ControlFlow;

type P = [f64; 2];

/// A drawing of 600 x 400 px: elements in layers, and what stands round them.
#[derive(Clone)]
struct Sheet {
    areas: Vec<Vec<P>>,
    lines: Vec<[P; 2]>,
    dots: Vec<P>,
    /// Further attributes of each element.
    area_style: Vec<String>,
    line_style: Vec<String>,
    dot_style: Vec<String>,
    /// Before everything, between areas and lines, between lines and dots, after everything.
    between: [String; 4],
    root: String,
}

impl Sheet {
    fn new(script: &str) -> Self {
        let plane = Script::parse(script, "script").unwrap().play(|_, _| ControlFlow::Continue(()));
        let pen = Pen::new(&plane);
        let corner = |of: fn(f64, f64) -> f64| [0, 1].map(|i| pen.dots.iter().map(|p| p[i]).reduce(of).unwrap());
        let (low, high) = (corner(f64::min), corner(f64::max));
        let scale = (480.0 / (high[0] - low[0])).min(280.0 / (high[1] - low[1]));
        let at = |p: P| [60.0 + scale * (p[0] - low[0]), 340.0 - scale * (p[1] - low[1])];
        let placed = pen.moved(at);
        Self {
            area_style: vec!["fill=\"#dde8f8\"".to_owned(); placed.areas.len()],
            line_style: vec!["stroke=\"#222\"".to_owned(); placed.lines.len()],
            dot_style: vec!["fill=\"#a00\"".to_owned(); placed.dots.len()],
            areas: placed.areas,
            lines: placed.lines,
            dots: placed.dots,
            between: Default::default(),
            root: "viewBox=\"0 0 600 400\"".to_owned(),
        }
    }

    fn line(&self, i: usize) -> String {
        let [[a, b], [c, d]] = self.lines[i];
        format!("<line x1=\"{a}\" y1=\"{b}\" x2=\"{c}\" y2=\"{d}\" {}/>", self.line_style[i])
    }

    fn dot(&self, i: usize) -> String {
        let [x, y] = self.dots[i];
        format!("<circle cx=\"{x}\" cy=\"{y}\" r=\"4\" {}/>", self.dot_style[i])
    }

    fn area(&self, i: usize) -> String {
        let points: Vec<String> = self.areas[i].iter().map(|[x, y]| format!("{x},{y}")).collect();
        format!("<polygon points=\"{}\" {}/>", points.join(" "), self.area_style[i])
    }

    fn svg(&self) -> String {
        let list = |count: usize, of: &dyn Fn(usize) -> String| (0..count).map(of).collect::<Vec<_>>().join("\n");
        self.with([
            list(self.areas.len(), &|i| self.area(i)),
            list(self.lines.len(), &|i| self.line(i)),
            list(self.dots.len(), &|i| self.dot(i)),
        ])
    }

    fn with(&self, [areas, lines, dots]: [String; 3]) -> String {
        let [first, second, third, last] = &self.between;
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" {}>\n{first}\n{areas}\n{second}\n{lines}\n{third}\n{dots}\n{last}\n</svg>\n",
            self.root
        )
    }

    /// The middle of a line.
    fn middle(&self, i: usize) -> P {
        let [[a, b], [c, d]] = self.lines[i];
        [0.5 * (a + c), 0.5 * (b + d)]
    }
}

/// The scripts behind the kit's reference figures.
fn references() -> Vec<(&'static str, Sheet)> {
    let all = [
        ("lab-04-drawing", include_str!("../../../figures/scripts/lab-04-drawing.dcels")),
        ("lab", include_str!("../../../figures/scripts/lab.dcels")),
        ("join-faces", include_str!("../../../figures/scripts/join-faces.dcels")),
    ];
    all.map(|(name, script)| (name, Sheet::new(script))).to_vec()
}

/// A box round a line, too wide to be a thick line itself.
fn box_over(sheet: &Sheet, i: usize, fill: &str) -> String {
    let [[a, b], [c, d]] = sheet.lines[i];
    let (x, y) = (a.min(c) - 12.0, b.min(d) - 12.0);
    let (width, height) = ((a - c).abs() + 24.0, (b - d).abs() + 24.0);
    format!("<rect x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\" fill=\"{fill}\"/>")
}

type Change = fn(&mut Sheet, &mut Random);
type Rewrite = fn(&Sheet, &mut Random) -> String;

/// Ways to make a drawing wrong; each changes one element at random.
#[rustfmt::skip]
const WRONG: [(&str, Change); 27] = [
    ("an edge dropped", |s, r| { let i = r.below(s.lines.len()); s.lines.remove(i); s.line_style.remove(i); }),
    ("a vertex moved", |s, r| {
        let (from, by) = (s.dots[r.below(s.dots.len())], 0.3 + r.below(40) as f64 / 10.0);
        let to = |p: &mut P| if *p == from { p[0] += by; p[1] -= 0.5 * by };
        s.dots.iter_mut().for_each(to);
        s.lines.iter_mut().flatten().for_each(to);
        s.areas.iter_mut().flatten().for_each(to);
    }),
    ("a vertex's circle dropped", |s, r| { let i = r.below(s.dots.len()); s.dots.remove(i); s.dot_style.remove(i); }),
    ("a face dropped", |s, r| { let i = r.below(s.areas.len()); s.areas.remove(i); s.area_style.remove(i); }),
    ("a face reversed", |s, r| { let i = r.below(s.areas.len()); s.areas[i].reverse(); }),
    ("a face in the colour of the paper", |s, r| { let i = r.below(s.areas.len()); s.area_style[i] = "fill=\"white\"".into(); }),
    ("faces in the colour of the background", |s, _| {
        s.between[0] = "<rect width=\"600\" height=\"400\" fill=\"#dde8f8\"/>".into();
    }),
    ("a line covered by the paper's colour", |s, r| { s.between[2] = box_over(s, r.below(s.lines.len()), "#ffffff"); }),
    ("a line covered in pink", |s, r| { s.between[2] = box_over(s, r.below(s.lines.len()), "pink"); }),
    ("a line transparent", |s, r| { let i = r.below(s.lines.len()); s.line_style[i] += " opacity=\"0\""; }),
    ("a line nearly transparent", |s, r| { let i = r.below(s.lines.len()); s.line_style[i] += " style=\"stroke-opacity:.01\""; }),
    ("a line of no width", |s, r| { let i = r.below(s.lines.len()); s.line_style[i] += " stroke-width=\"0\""; }),
    ("lines in white, without faces", |s, _| {
        s.area_style.iter_mut().for_each(|style| *style = "fill=\"white\"".into());
        s.line_style.iter_mut().for_each(|style| *style = "stroke=\"#fff\"".into());
    }),
    ("a line in the colour of its face", |s, r| {
        s.between[1] = "<rect x=\"30\" y=\"20\" width=\"540\" height=\"350\" fill=\"#345\"/>".into();
        let i = r.below(s.lines.len());
        s.line_style[i] = "stroke=\"#334455\"".into();
    }),
    ("a line clipped away", |s, r| {
        s.between[0] = "<clipPath id=\"c\"><rect x=\"0\" y=\"0\" width=\"9\" height=\"9\"/></clipPath>".into();
        let i = r.below(s.lines.len());
        s.line_style[i] += " clip-path=\"url(#c)\"";
    }),
    ("a line clipped to half", |s, r| {
        let i = r.below(s.lines.len());
        let ([x, y], [a, b]) = (s.middle(i), s.lines[i][0]);
        let (left, top) = (x.min(a) - 3.0, y.min(b) - 3.0);
        s.between[0] = format!(
            "<clipPath id=\"c\"><rect x=\"{left}\" y=\"{top}\" width=\"{}\" height=\"{}\"/></clipPath>",
            (x - a).abs() + 3.0, (y - b).abs() + 3.0
        );
        s.line_style[i] += " clip-path=\"url(#c)\"";
    }),
    ("everything behind a rectangle", |s, _| { s.between[3] = "<rect width=\"600\" height=\"400\" fill=\"white\"/>".into(); }),
    ("lines behind a rectangle", |s, _| { s.between[2] = "<rect width=\"600\" height=\"400\" fill=\"#fff\"/>".into(); }),
    ("a part outside of the viewBox", |s, _| { s.root = "viewBox=\"0 0 420 400\"".into(); }),
    ("a line that is not displayed", |s, r| { let i = r.below(s.lines.len()); s.line_style[i] += " display=\"none\""; }),
    ("a line by a style that hides", |s, r| {
        s.between[0] = "<style>.x{visibility:hidden}</style>".into();
        let i = r.below(s.lines.len());
        s.line_style[i] += " class=\"x\"";
    }),
    ("a line in defs", |s, r| {
        let i = r.below(s.lines.len());
        s.between[0] = format!("<defs>{}</defs>", s.line(i));
        s.lines.remove(i);
        s.line_style.remove(i);
    }),
    ("a line of dashes that are not there", |s, r| { let i = r.below(s.lines.len()); s.line_style[i] += " stroke-dasharray=\"0 2000\""; }),
    ("a line moved by its style", |s, r| { let i = r.below(s.lines.len()); s.line_style[i] += " style=\"transform:translate(3px,2px)\""; }),
    ("a line below a white one", |s, r| {
        let i = r.below(s.lines.len());
        let mut over = s.clone();
        over.line_style[i] = "stroke=\"white\" stroke-width=\"5\"".into();
        s.area_style.iter_mut().for_each(|style| *style = "fill=\"#f0f0f0\"".into());
        s.between[2] = over.line(i);
    }),
    ("a line below a picture", |s, r| { s.between[2] = box_over(s, r.below(s.lines.len()), "x").replace("<rect", "<image href=\"x.png\""); }),
    ("a circle over its neighbours", |s, r| {
        let i = r.below(s.dots.len());
        s.dots.push(s.dots[i]);
        s.dot_style.push("style=\"r:290px\"".into());
    }),
];

#[test]
fn whatever_hides_or_moves_something_is_refused() {
    for (reference, sheet) in references() {
        let expected = sheet.svg();
        assert!(judge(&expected, &expected.replace('\n', " ")).is_equal(), "{reference}");
        for (name, change) in WRONG {
            for seed in 0..2 {
                let (mut changed, mut random) = (sheet.clone(), Random(seed));
                change(&mut changed, &mut random);
                let answer = judge(&expected, &changed.svg());
                assert!(!answer.is_equal(), "{reference}, seed {seed}: {name}\n{}", changed.svg());
            }
        }
    }
}

fn path_of(lines: &[[P; 2]]) -> String {
    lines.iter().fold(String::new(), |mut out, [[a, b], [c, d]]| {
        write!(out, "M{a} {b}L{c},{d}").unwrap();
        out
    })
}

fn joined(count: usize, of: impl Fn(usize) -> String) -> String {
    (0..count).map(of).collect::<Vec<_>>().join("\n")
}

/// Other ways to write the same drawing.
#[rustfmt::skip]
const SAME: [(&str, Rewrite); 25] = [
    ("each layer in another order", |s, r| {
        let order = |n: usize, r: &mut Random| r.shuffled(n);
        let [a, l, d] = [s.areas.len(), s.lines.len(), s.dots.len()].map(|n| order(n, r));
        s.with([joined(a.len(), |i| s.area(a[i])), joined(l.len(), |i| s.line(l[i])), joined(d.len(), |i| s.dot(d[i]))])
    }),
    ("one path for all edges", |s, _| {
        let path = format!("<path fill=\"none\" stroke=\"navy\" d=\"{}\"/>", path_of(&s.lines));
        s.with([joined(s.areas.len(), |i| s.area(i)), path, joined(s.dots.len(), |i| s.dot(i))])
    }),
    ("all faces in one path", |s, _| {
        let ring = |i: usize| {
            let points: Vec<String> = s.areas[i].iter().map(|[x, y]| format!("{x} {y}")).collect();
            format!("M{}Z", points.join("L"))
        };
        let path = format!("<path fill=\"tan\" d=\"{}\"/>", joined(s.areas.len(), ring));
        s.with([path, joined(s.lines.len(), |i| s.line(i)), joined(s.dots.len(), |i| s.dot(i))])
    }),
    ("in a group with a transform", |s, _| {
        let mut t = s.clone();
        t.between[0] = "<g transform=\"translate(20 10) scale(.8)\"><g>".into();
        t.between[3] = "</g></g>".into();
        t.svg()
    }),
    ("turned there and back", |s, _| {
        let mut t = s.clone();
        t.between[0] = "<g transform=\"rotate(30)\"><g style=\"transform: rotate(-30deg)\">".into();
        t.between[3] = "</g></g>".into();
        t.svg()
    }),
    ("an inner svg with a viewBox", |s, _| {
        let mut t = s.clone();
        t.between[0] = "<svg x=\"30\" y=\"40\" width=\"300\" height=\"300\" viewBox=\"0 0 600 400\">".into();
        t.between[3] = "</svg>".into();
        t.svg()
    }),
    ("vertices by use of a symbol", |s, _| {
        let dots = joined(s.dots.len(), |i| {
            format!("<use href=\"#d\" x=\"{}\" y=\"{}\" width=\"8\" height=\"8\"/>", s.dots[i][0] - 4.0, s.dots[i][1] - 4.0)
        });
        let mut t = s.clone();
        t.between[0] = "<symbol id=\"d\" viewBox=\"-1 -1 2 2\"><circle r=\"1\"/></symbol>".into();
        t.with([joined(s.areas.len(), |i| s.area(i)), joined(s.lines.len(), |i| s.line(i)), dots])
    }),
    ("millimetres", |s, _| {
        let mm = |x: f64| format!("{:.9}mm", x * 25.4 / 96.0);
        let lines = joined(s.lines.len(), |i| {
            let [[a, b], [c, d]] = s.lines[i];
            format!("<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" stroke=\"#123\"/>", mm(a), mm(b), mm(c), mm(d))
        });
        let dots = joined(s.dots.len(), |i| {
            format!("<circle cx=\"{}\" cy=\"{}\" r=\"1mm\"/>", mm(s.dots[i][0]), mm(s.dots[i][1]))
        });
        s.with([joined(s.areas.len(), |i| s.area(i)), lines, dots])
    }),
    ("circles of Bezier curves", |s, _| {
        let k = 2.209_139;
        let dots = joined(s.dots.len(), |i| {
            let [x, y] = s.dots[i];
            format!(
                "<path fill=\"#a00\" d=\"M{} {y}c0 {k} {} 4 -4 4s-4 {} -4 -4 {} -4 4 -4 4 {} 4 4z\"/>",
                x + 4.0, k - 4.0, k - 4.0, 4.0 - k, 4.0 - k
            )
        });
        s.with([joined(s.areas.len(), |i| s.area(i)), joined(s.lines.len(), |i| s.line(i)), dots])
    }),
    ("circles of arcs", |s, _| {
        let dots = joined(s.dots.len(), |i| {
            let [x, y] = s.dots[i];
            format!("<path fill=\"none\" stroke=\"#a00\" d=\"M{} {y}a4 4 0 1 0 8 0a4 4 0 1 0 -8 0\"/>", x - 4.0)
        });
        s.with([joined(s.areas.len(), |i| s.area(i)), joined(s.lines.len(), |i| s.line(i)), dots])
    }),
    ("circles as lines of no length", |s, _| {
        let dots = joined(s.dots.len(), |i| {
            format!("<path stroke=\"red\" stroke-width=\"7\" stroke-linecap=\"round\" d=\"M{} {}h0\"/>", s.dots[i][0], s.dots[i][1])
        });
        s.with([joined(s.areas.len(), |i| s.area(i)), joined(s.lines.len(), |i| s.line(i)), dots])
    }),
    ("round rectangles as circles", |s, _| {
        let dots = joined(s.dots.len(), |i| {
            format!("<rect x=\"{}\" y=\"{}\" width=\"8\" height=\"8\" rx=\"4\"/>", s.dots[i][0] - 4.0, s.dots[i][1] - 4.0)
        });
        s.with([joined(s.areas.len(), |i| s.area(i)), joined(s.lines.len(), |i| s.line(i)), dots])
    }),
    ("lines as thin rectangles", |s, _| {
        let lines = joined(s.lines.len(), |i| {
            let [[a, b], [c, d]] = s.lines[i];
            let long = (c - a).hypot(d - b);
            let (x, y) = ((d - b) / long, (a - c) / long);
            format!(
                "<polygon points=\"{},{} {},{} {},{} {},{}\"/>",
                a + x, b + y, c + x, d + y, c - x, d - y, a - x, b - y
            )
        });
        s.with([joined(s.areas.len(), |i| s.area(i)), lines, joined(s.dots.len(), |i| s.dot(i))])
    }),
    ("every line twice", |s, _| {
        let lines = joined(2 * s.lines.len(), |i| s.line(i / 2));
        s.with([joined(s.areas.len(), |i| s.area(i)), lines, joined(s.dots.len(), |i| s.dot(i))])
    }),
    ("faces with their own borders", |s, _| {
        let mut t = s.clone();
        t.area_style.iter_mut().for_each(|style| *style += " stroke=\"black\" stroke-width=\".5\"");
        t.svg()
    }),
    ("translucent faces over the lines", |s, _| {
        let areas = joined(s.areas.len(), |i| s.area(i).replace("/>", " fill-opacity=\".5\"/>"));
        s.with([String::new(), joined(s.lines.len(), |i| s.line(i)) + &areas, joined(s.dots.len(), |i| s.dot(i))])
    }),
    ("a document type, as matplotlib writes it", |s, _| {
        format!(
            "<?xml version=\"1.0\" encoding=\"utf-8\" standalone=\"no\"?>\n<!DOCTYPE svg PUBLIC \"-//W3C//DTD SVG 1.1//EN\"\n  \
             \"http://www.w3.org/Graphics/SVG/1.1/DTD/svg11.dtd\">\n{}",
            s.svg()
        )
    }),
    ("a background, a frame, a title of curves", |s, _| {
        let mut t = s.clone();
        t.between[0] = "<rect width=\"600\" height=\"400\" fill=\"ivory\" stroke=\"black\"/>\
                        <path d=\"M280 9q4 8 9 0v4q-4 4 -9 0z\"/><path d=\"M300 9h4v6h-4z\"/>".into();
        t.svg()
    }),
    ("a background with round corners", |s, _| {
        let mut t = s.clone();
        t.between[0] = "<path fill=\"#fffbe8\" d=\"M20 5H580Q595 5 595 20V380Q595 395 580 395H20Q5 395 5 380V20Q5 5 20 5Z\"/>".into();
        t.svg()
    }),
    ("a legend", |s, _| {
        let mut t = s.clone();
        t.between[3] = "<g class=\"legend\"><rect x=\"20\" y=\"360\" width=\"90\" height=\"30\" fill=\"none\" stroke=\"#999\"/>\
                        <line x1=\"25\" y1=\"370\" x2=\"45\" y2=\"370\" stroke=\"#222\"/><circle cx=\"35\" cy=\"382\" r=\"4\"/></g>".into();
        t.svg()
    }),
    ("dark, by a style sheet", |s, _| {
        let mut t = s.clone();
        t.between[0] = "<style>* { stroke-linejoin: round } .p { fill: #111 } line { stroke: rgb(90% 90% 90%) !important }\n\
                        circle { fill: gold } polygon { fill: hsl(220 40% 25%) }</style><rect class=\"p\" width=\"100%\" height=\"100%\"/>".into();
        t.svg()
    }),
    ("dashed lines", |s, _| {
        let mut t = s.clone();
        t.line_style.iter_mut().for_each(|style| *style += " stroke-dasharray=\"5 3\"");
        t.svg()
    }),
    ("boxes of labels on the lines", |s, _| {
        let mut t = s.clone();
        t.between[2] = joined(s.lines.len(), |i| {
            let [x, y] = s.middle(i);
            format!("<rect x=\"{}\" y=\"{}\" width=\"12\" height=\"9\" fill=\"white\"/><text x=\"{x}\" y=\"{y}\">e</text>", x - 6.0, y - 4.5)
        });
        t.svg()
    }),
    ("a clip path round it all", |s, _| {
        let mut t = s.clone();
        t.between[0] = "<clipPath id=\"a\"><use href=\"#w\"/></clipPath><defs><rect id=\"w\" x=\"40\" y=\"40\" width=\"520\" height=\"320\"/></defs>\
                        <g clip-path=\"url(#a)\">".into();
        t.between[3] = "</g>".into();
        t.svg()
    }),
    ("hidden lines, and an area below all", |s, r| {
        let mut t = s.clone();
        let [a, b] = s.dots[r.below(s.dots.len())];
        t.between[0] = format!("<line x1=\"{a}\" y1=\"{b}\" x2=\"300\" y2=\"211\" stroke=\"red\"/>\
                        <rect x=\"0\" y=\"0\" width=\"600\" height=\"400\" fill=\"#fcfcfc\"/>");
        t.svg()
    }),
];

#[test]
fn other_ways_to_draw_the_same_are_equal() {
    for (reference, sheet) in references() {
        let expected = sheet.svg();
        for (name, write) in SAME {
            for seed in 0..2 {
                let svg = write(&sheet, &mut Random(seed));
                let answer: Comparison = judge(&expected, &svg);
                assert!(answer.is_equal(), "{reference}, seed {seed}: {name}: {}\n{svg}", answer.text());
            }
        }
    }
}
