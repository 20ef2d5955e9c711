//! Half-edges are arrows, whatever draws these.

use super::declared::{BARB, LINE, changed, direction, reference, says, within};
use super::halves::{ends, names};
use super::pen::P;
use super::{judge, ship};
use crate::common::Random;
use dcel_kit::figure::{Detail, FaceLabels, FigureOptions, structure};
use dcel_kit::plane::{Point, Subdivision};
use dcel_kit::topology::PolygonList;

const MARKER: &str = "<defs><marker id=\"tip\" orient=\"auto-start-reverse\" markerWidth=\"8\" markerHeight=\"8\" \
                      refX=\"7\" refY=\"4\" markerUnits=\"userSpaceOnUse\"><path d=\"M0 0L8 4L0 8Z\" \
                      fill=\"#b5420a\"/></marker></defs></svg>";

/// The points of an arrow: those before and behind its end, aside by so much to the left.
struct Arrow {
    start: P,
    end: P,
    /// How far down it runs, and how far to the right.
    way: P,
}

impl Arrow {
    fn reversed(&self) -> Self {
        Self { start: self.end, end: self.start, way: self.way.map(|part| -part) }
    }

    fn at(&self, [x, y]: P, ahead: f64, aside: f64) -> String {
        let [s, c] = self.way;
        format!("{:.3} {:.3}", x + ahead * c + aside * s, y + ahead * s - aside * c)
    }

    fn line(&self, more: &str) -> String {
        let [start, end] = [self.start, self.end].map(|p| self.at(p, 0.0, 0.0));
        format!("<path class=\"sh\" d=\"M{start}L{end}\"{more}/>")
    }
}

type Form = (&'static str, fn(&Arrow) -> String);

/// A line with a marker or with strokes, or a filled outline.
const FORMS: [Form; 7] = [
    ("marker-end", |arrow| arrow.line(" marker-end=\"url(#tip)\"")),
    ("marker-start", |arrow| arrow.reversed().line(" marker-start=\"url(#tip)\"")),
    ("marker-mid", |arrow| {
        let middle = [0, 1].map(|i| 0.5 * (arrow.start[i] + arrow.end[i]));
        let [a, b, c] = [arrow.start, middle, arrow.end].map(|p| arrow.at(p, 0.0, 0.0));
        format!("<polyline class=\"sh\" marker-mid=\"url(#tip)\" points=\"{a} {b} {c}\"/>")
    }),
    ("two strokes", |arrow| {
        let [left, tip, right] = [(-6.0, 4.0), (0.0, 0.0), (-6.0, -4.0)].map(|(t, a)| arrow.at(arrow.end, t, a));
        arrow.line("") + &format!("<path class=\"sh\" d=\"M{left}L{tip}L{right}\"/>")
    }),
    ("two lines", |arrow| {
        let [left, tip, right] = [(-6.0, 4.0), (0.0, 0.0), (-6.0, -4.0)].map(|(t, a)| arrow.at(arrow.end, t, a));
        arrow.line("") + &format!("<path class=\"sh\" d=\"M{tip}L{left}M{tip}L{right}\"/>")
    }),
    ("one stroke", |arrow| {
        let [tip, outer] = [(0.0, 0.0), (-7.0, 4.0)].map(|(t, a)| arrow.at(arrow.end, t, a));
        format!("<path class=\"sh\" d=\"M{}L{tip}L{outer}\"/>", arrow.at(arrow.start, 0.0, 0.0))
    }),
    ("outline", |arrow| {
        let long = (arrow.end[0] - arrow.start[0]).hypot(arrow.end[1] - arrow.start[1]);
        if long < 16.0 {
            return arrow.line(" marker-end=\"url(#tip)\"");
        }
        let tail = [0.8, -0.8].map(|a| arrow.at(arrow.start, 0.0, a));
        let head = [(-6.0, -0.8), (-6.0, -4.0), (0.0, 0.0), (-6.0, 4.0), (-6.0, 0.8)];
        let head = head.map(|(t, a)| arrow.at(arrow.end, t, a)).join(" ");
        format!("<polygon class=\"barb\" points=\"{} {head}\"/>", tail.join(" "))
    }),
];

/// The reference with its half-edges drawn so.
fn drawn(form: impl Fn(&Arrow) -> String) -> String {
    let whole = reference();
    let svg = changed(|lines| {
        for name in names() {
            let [start, end] = ends(lines, &name);
            let arrow = Arrow { start, end, way: direction(&whole, &name) };
            let at = within(lines, &name, LINE);
            lines[at] = form(&arrow);
            let barb = within(lines, &name, BARB);
            lines[barb].clear();
        }
    });
    svg.replacen("</svg>", MARKER, 1)
}

/// The reference with lines that end at the bases of heads so long.
pub(super) fn heads_on_their_bases(size: f64) -> String {
    drawn(|arrow| {
        let long = (arrow.end[0] - arrow.start[0]).hypot(arrow.end[1] - arrow.start[1]);
        if long < 30.0 {
            return arrow.line(" marker-end=\"url(#tip)\"");
        }
        let base = arrow.at(arrow.end, -size, 0.0);
        let [left, tip, right] =
            [(-size, 0.45 * size), (0.0, 0.0), (-size, -0.45 * size)].map(|(t, a)| arrow.at(arrow.end, t, a));
        let start = arrow.at(arrow.start, 0.0, 0.0);
        format!("<path class=\"sh\" d=\"M{start}L{base}\"/><path class=\"barb\" d=\"M{left}L{tip}L{right}z\"/>")
    })
}

#[test]
fn arrows_are_drawn_in_many_ways() {
    for (name, form) in FORMS {
        let answer = judge(&reference(), &drawn(form));
        assert!(answer.is_equal(), "{name}: {}", answer.text());
    }
}

#[test]
fn arrows_that_point_back_are_told() {
    for (name, form) in FORMS {
        let answer = judge(&reference(), &drawn(|arrow| form(&arrow.reversed())));
        // One stroke lies on the side of the edge then, too.
        let many =
            if name == "one stroke" { "barbs" } else { "66 half-edges have barbs that do not point to the ends" };
        assert!(answer.text().contains(many), "{name}: {}", answer.text());
    }
    // Heads at both ends say nothing, and markers that do not turn with their lines point anywhere.
    let both = drawn(|arrow| arrow.line(" marker-start=\"url(#tip)\" marker-end=\"url(#tip)\""));
    says(&both, "66 half-edges have barbs that do not point to the ends of them");
    let fixed = drawn(FORMS[0].1).replacen("orient=\"auto-start-reverse\"", "", 1);
    assert!(judge(&reference(), &fixed).text().contains("have barbs that do not point to the ends of them"));
}

#[test]
fn lines_without_heads_are_told() {
    let said = "66 half-edges have no barbs that can be seen: h0, h1";
    says(&drawn(|arrow| arrow.line("")), said);
    let bar = |arrow: &Arrow| {
        let [a, b] = [0.8, -0.8].map(|a| arrow.at(arrow.start, 0.0, a));
        let [c, d] = [-0.8, 0.8].map(|a| arrow.at(arrow.end, 0.0, a));
        format!("<polygon class=\"barb\" points=\"{a} {b} {c} {d}\"/>")
    };
    says(&drawn(bar), said);
    // Markers without ink, with that of what lies below, and below a picture.
    let marked = drawn(FORMS[0].1);
    for ink in ["fill=\"none\"", "fill=\"#b5420a\" opacity=\"0\""] {
        says(&marked.replacen("fill=\"#b5420a\"", ink, 1), said);
    }
    let outlines = drawn(FORMS[6].1);
    let hidden = outlines.replacen("</style>", "#ship .barb{fill:none}</style>", 1);
    assert!(!judge(&reference(), &hidden).is_equal());
}

#[test]
fn barbs_of_the_colour_of_the_paper_are_told_on_a_hatch() {
    let outer = |lines: &[String]| -> Vec<usize> {
        let is_outer = |&i: &usize| lines[i].contains("class=\"he\"") && lines[i].contains("data-face=\"f0\"");
        (0..lines.len()).filter(is_outer).collect()
    };
    let svg = changed(|lines| {
        for at in outer(lines) {
            let barb = at + lines[at..].iter().position(|line| line.starts_with(BARB)).unwrap();
            lines[barb] = lines[barb].replacen("<path", "<path style=\"fill:#fff\"", 1);
        }
    });
    let lines: Vec<String> = reference().lines().map(str::to_owned).collect();
    let count = outer(&lines).len();
    assert!(count > 5, "{count}");
    says(&svg, &format!("{count} half-edges have no barbs that can be seen"));
}

#[test]
fn half_edges_may_be_drawn_twice() {
    let reference = reference();
    for name in ["h0", "h7", "h20"] {
        let lines: Vec<String> = reference.lines().map(str::to_owned).collect();
        let [line, barb] = [LINE, BARB].map(|start| lines[within(&lines, name, start)].clone());
        let behind = reference.replacen("</svg>", &format!("{line}{barb}</svg>"), 1);
        let within = changed(|lines| {
            let at = within(lines, name, LINE);
            lines.insert(at, line.clone() + &barb);
        });
        for svg in [behind, within] {
            let answer = judge(&reference, &svg);
            assert!(answer.is_equal(), "{name}: {}", answer.text());
        }
    }
    // What hides it is something else.
    let lines: Vec<String> = reference.lines().map(str::to_owned).collect();
    let line = lines[within(&lines, "h0", LINE)].replacen("/>", " style=\"stroke:#fff;stroke-width:4\"/>", 1);
    says(&reference.replacen("</svg>", &format!("{line}</svg>"), 1), "1 half-edge is declared and cannot be seen: h0");
}

/// Programs that keep no groups keep lines and areas.
#[test]
fn half_edges_that_are_drawn_and_not_declared_are_no_edges() {
    let options = FigureOptions::new("ship").detail(Detail::Full).plain(true);
    let reference = structure(&ship(), &options).unwrap().to_svg();
    let start = reference.find('>').unwrap();
    let at = reference.find("viewBox=").unwrap();
    let room = reference[at..start].split('"').nth(1).unwrap();
    let is_drawn = |line: &&str| !["<g", "</g", "<title", "<desc"].iter().any(|start| line.starts_with(start));
    let body: Vec<&str> = reference[start + 1..].lines().filter(is_drawn).collect();
    let bare = format!("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{room}\">{}", body.join("\n"));
    assert!(!bare.contains("data-"));
    let answer = judge(&reference, &bare);
    assert!(answer.is_equal(), "{}", answer.text());
    let larger =
        bare.replacen("\n", "\n<g transform=\"translate(7 3) scale(1.5)\">", 1).replacen("</svg>", "</g></svg>", 1);
    let larger = larger.replacen(&format!(" viewBox=\"{room}\""), "", 1);
    let answer = judge(&reference, &larger);
    assert!(answer.is_equal(), "{}", answer.text());
    // One line is none of these, and an edge is one still.
    let lines: Vec<&str> = bare.lines().filter(|line| line.starts_with("<line")).collect();
    let extra = "<line x1=\"150\" y1=\"60\" x2=\"190\" y2=\"140\" stroke=\"#b5420a\" stroke-width=\"2\"/></svg>";
    assert!(!judge(&reference, &bare.replacen("</svg>", extra, 1)).is_equal());
    let less = lines.iter().filter(|line| !judge(&reference, &bare.replacen(**line, "", 1)).is_equal());
    assert_eq!(less.count(), 33);
}

/// A grid of triangles that is bent at random.
fn triangles(seed: u64, columns: u32, rows: u32) -> Subdivision {
    let mut random = Random(seed);
    let mut off = || 0.006 * random.below(100) as f64 - 0.3;
    let corner = |i: u32, j: u32| j * (columns + 1) + i;
    let mut points = Vec::new();
    for j in 0..=rows {
        for i in 0..=columns {
            points.push(Point::new(f64::from(i) + off(), f64::from(j) + off()));
        }
    }
    let mut faces = PolygonList::new();
    for j in 0..rows {
        for i in 0..columns {
            faces.push_face(&[corner(i, j), corner(i + 1, j), corner(i + 1, j + 1)]);
            faces.push_face(&[corner(i, j), corner(i + 1, j + 1), corner(i, j + 1)]);
        }
    }
    Subdivision::from_polygons(points, &faces).unwrap()
}

/// Where arrows are short, their barbs begin before the middles of their edges.
#[test]
fn figures_of_the_kit_are_equal_at_every_width() {
    for seed in 1..7 {
        let plane = triangles(seed, 5, 4);
        let svg = |width: f64| {
            let options = FigureOptions::new("grid").detail(Detail::Full).width(width).face_labels(FaceLabels::Off);
            structure(&plane, &options).unwrap().to_svg()
        };
        let large = svg(1600.0);
        for width in [460.0, 520.0, 640.0, 900.0] {
            let small = svg(width);
            for [mine, theirs] in [[&large, &small], [&small, &large]] {
                let answer = judge(mine, theirs);
                assert!(answer.is_equal(), "{seed} {width}: {}", answer.text());
            }
        }
    }
}

/// As leaders do, and arrows of pointers, where a figure is drawn small.
#[test]
fn thin_lines_of_decoration_over_an_arrow_hide_nothing_of_it() {
    let whole = reference();
    let lines: Vec<String> = whole.lines().map(str::to_owned).collect();
    for name in ["h0", "h7", "h20"] {
        let [[a, b], [c, d]] = ends(&lines, name);
        let [x, y] = direction(&whole, name).map(|part| 0.8 * part);
        let over = |style: &str| {
            // Along nearly all of its line, and on over its barb.
            let leader = format!(
                "<line class=\"leader\" x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" {style}/></svg>",
                a - x,
                b + y,
                c + x,
                d - y
            );
            whole.replacen("</svg>", &leader, 1)
        };
        let answer = judge(&whole, &over("style=\"stroke:#7a5a00;stroke-width:2.4\""));
        assert!(answer.is_equal(), "{name}: {}", answer.text());
        // One that is not seen itself, and a broad one.
        for style in ["style=\"stroke:#fff;stroke-width:2.4\"", "style=\"stroke:#7a5a00;stroke-width:9\""] {
            says(&over(style), &format!("half-edge is declared and cannot be seen: {name}"));
        }
    }
}

/// A line along a whole arrow: what it covers is hidden, whatever its colour, and a rim on both sides shows what is there.
#[test]
fn decoration_along_a_whole_arrow_leaves_a_rim_of_it_or_hides_it() {
    let whole = reference();
    let lines: Vec<String> = whole.lines().map(str::to_owned).collect();
    for name in ["h0", "h7", "h20"] {
        let [[a, b], [c, d]] = ends(&lines, name);
        let along = |style: &str| {
            format!("<line class=\"leader\" x1=\"{a}\" y1=\"{b}\" x2=\"{c}\" y2=\"{d}\" style=\"{style}\"/>")
        };
        let over = |style: &str| whole.replacen("</svg>", &format!("{}</svg>", along(style)), 1);
        let under = |style: &str| {
            let first = whole.find("<g class=\"he\"").unwrap();
            format!("{}{}{}", &whole[..first], along(style), &whole[first..])
        };
        for colour in ["#ffd54a", "#ff9", "#fff", "#f00", "#7a5a00"] {
            let style =
                |width: f64, opacity: f64| format!("stroke:{colour};stroke-width:{width};stroke-opacity:{opacity}");
            // The arrow is 2 px wide.
            let shown =
                [over(&style(0.8, 1.0)), over(&style(1.4, 1.0)), over(&style(3.0, 0.4)), over(&style(9.0, 0.4))];
            for svg in shown.into_iter().chain([1.0, 3.0, 9.0].map(|width| under(&style(width, 1.0)))) {
                let answer = judge(&whole, &svg);
                assert!(answer.is_equal(), "{name} {colour}: {}", answer.text());
            }
            for width in [2.0, 2.6, 3.0, 9.0] {
                says(&over(&style(width, 1.0)), &format!("half-edge is declared and cannot be seen: {name}"));
            }
        }
        // Drawn once more in its own colour, it is what it was.
        let answer = judge(&whole, &over("stroke:#b5420a;stroke-width:2.6"));
        assert!(answer.is_equal(), "{name}: {}", answer.text());
    }
}

/// Each stroke could be a part of the head that each other one begins, and each head could be that of each copy of the line.
#[test]
fn a_half_edge_of_many_strokes_ends_quickly() {
    use cpu_time::ThreadTime;
    let strayed = |lines: &mut Vec<String>| {
        let stray = |i: usize| {
            let (x, y) = (100 + i % 300, 100 + 7 * i % 300);
            format!("<path class=\"sh\" d=\"M{x}.{} {y}l1 .5\"/>", i % 97)
        };
        let line = within(lines, "h3", LINE);
        lines[line].extend((0..40_000).map(stray));
    };
    let copied = |lines: &mut Vec<String>| {
        let [line, barb] = [LINE, BARB].map(|start| within(lines, "h3", start));
        lines[line] = lines[line].repeat(20_000);
        lines[barb] = lines[barb].repeat(20_000);
    };
    for svg in [changed(strayed), changed(copied)] {
        let started = ThreadTime::now();
        let answer = judge(&reference(), &svg);
        assert!(answer.is_equal(), "{}", answer.text());
        assert!(started.elapsed() < std::time::Duration::from_secs(10), "{:?}", started.elapsed());
    }
}
