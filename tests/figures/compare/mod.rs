//! Drawings that mean the same are equal, and of others the difference is named.

#![allow(clippy::float_cmp, reason = "points are found again by the numbers they were made of")]

mod accepted;
mod around;
mod arrows;
mod declared;
mod foreign;
mod geometry;
mod halos;
mod halves;
mod heads;
mod hidden;
mod keyholes;
mod many;
mod moving;
mod names;
mod nodes;
mod numbered;
mod outlined;
mod pen;
mod rewrites;
mod seen;
mod sheets;
mod shown;
mod sparse;
mod square;
mod strangers;
mod tools;
mod values;
mod variants;
mod written;

use crate::common;
use crate::common::Random;
use cpu_time::ThreadTime;
use dcel_kit::compare::{Comparison, Layer, Options, Problem, Side, compare, compare_tables, diff_figure};
use dcel_kit::figure::{Detail, FigureOptions, Theme, structure};
use dcel_kit::plane::Subdivision;
use dcel_kit::script::Script;
use dcel_kit::topology::Table;
use pen::{Pen, document, renumbered, table};
use std::ops::ControlFlow;
use std::time::Duration;

/// The drawing of lab 04: a ship, with no symmetry.
fn ship() -> Subdivision {
    let script = Script::parse(include_str!("../../../figures/scripts/lab-04-drawing.dcels"), "ship").unwrap();
    script.play(|_, _| ControlFlow::Continue(()))
}

fn kit(table: &Table) -> String {
    structure(table, &FigureOptions::new("ship").detail(Detail::Full)).unwrap().to_svg()
}

/// The reference as the kit's figure with its structure, as the kit's figure of the lab, and as plain shapes.
fn references() -> [(&'static str, String); 3] {
    let lab = include_str!("../../../figures/lab-04-drawing.svg").to_owned();
    [("declared", kit(&table(&ship()))), ("figure", lab), ("plain", Pen::new(&ship()).svg())]
}

fn judge(reference: &str, student: &str) -> Comparison {
    compare(reference, student, &Options::new()).unwrap_or_else(|error| panic!("{error}\n{student}"))
}

/// The sentences.
fn texts(answer: &Comparison) -> Vec<&str> {
    answer.differences().iter().map(|difference| difference.text.as_str()).collect()
}

#[test]
fn figures_of_the_kit_are_equal_whatever_their_numbers_and_looks() {
    let plane = ship();
    let table = table(&plane);
    let reference = kit(&table);
    let mut random = Random(11);
    for round in 0..5 {
        let other = renumbered(&table, |n| random.shuffled(n));
        let mut options = FigureOptions::new(format!("mine {round}")).detail(Detail::Full);
        options = match round {
            0 => options,
            1 => options.width(1234.5),
            2 => options.plain(true).half_edge_labels(false),
            3 => options.style(dcel_kit::figure::Style::default().theme(Theme::Dark)),
            _ => options.interactive(true).id_prefix("my-own-v2"),
        };
        let svg = structure(&other, &options).unwrap().to_svg();
        let answer = judge(&reference, &svg);
        assert!(answer.is_equal() && answer.layer() == Layer::Declared, "round {round}: {}", answer.text());
        assert!(answer.notes().is_empty(), "{:?}", answer.notes());
        let named = compare(&reference, &svg, &Options::new().names(true)).unwrap();
        assert!(!named.is_equal(), "names were to be compared");
    }
    assert_eq!(judge(&reference, &reference).layer(), Layer::Bytes);
    let named = compare(&reference, &reference.replace('\n', "\r\n"), &Options::new().names(true)).unwrap();
    assert!(named.is_equal() && named.layer() == Layer::Declared);
}

/// A half-edge of the ship with its row, for changes by hand.
fn changed(change: impl FnOnce(&mut Table)) -> Comparison {
    let right = table(&ship());
    let mut wrong = right.clone();
    change(&mut wrong);
    let by_tables = compare_tables(&right, &wrong, &Options::new());
    assert!(diff_figure(&right, &wrong, &FigureOptions::new("diff")).is_ok());
    by_tables
}

#[test]
fn wrong_pointers_are_named_one_by_one() {
    let row = |table: &mut Table, i: usize, set: &dyn Fn(&mut dcel_kit::topology::HalfEdgeRow)| {
        set(table.half_edges[i].as_mut().unwrap());
    };
    let h = common::h;
    let right = table(&ship());
    let of = |i: usize| right.half_edges[i].unwrap();

    let answer = changed(|t| row(t, 40, &|r| r.next = Some(h(41))));
    let said =
        format!("half-edge h40 (0, 37.5) -> (0, -75): next is h41, its own twin; expected {}", of(40).next.unwrap());
    assert_eq!(answer.differences().len(), 1, "{}", answer.text());
    assert!(answer.differences()[0].text.starts_with(&said), "{}", answer.text());
    assert!(answer.notes().iter().any(|note| note.contains("N2: h40.next = h41")), "{}", answer.text());
    assert_eq!(answer.agreed(), "65 of 66 half-edges agree");

    let answer = changed(|t| row(t, 40, &|r| r.prev = Some(h(2))));
    assert!(texts(&answer)[0].contains(": prev is h2; expected "), "{}", answer.text());
    let answer = changed(|t| row(t, 40, &|r| r.twin = Some(h(3))));
    assert!(texts(&answer)[0].contains(": twin is h3; expected h41"), "{}", answer.text());
    let answer = changed(|t| row(t, 40, &|r| r.next = None));
    assert!(texts(&answer)[0].contains(": next is not set; expected "), "{}", answer.text());
    let answer = changed(|t| row(t, 40, &|r| r.next = Some(h(4000))));
    assert!(texts(&answer)[0].contains(": next is h4000, which does not exist; expected "), "{}", answer.text());

    // The new face was not given to its half-edges: one sentence for all of them.
    let lost = right.faces.len() - 1;
    let answer = changed(|t| {
        for row in t.half_edges.iter_mut().flatten().filter(|row| row.face == Some(common::f(lost as u32))) {
            row.face = Some(common::f(0));
        }
        t.faces.pop();
    });
    assert_eq!(answer.differences().len(), 1, "{}", answer.text());
    assert!(texts(&answer)[0].contains("have face f0; expected a face of their own"), "{}", answer.text());
    let answer = changed(|t| t.outer_face = Some(common::f(3)));
    assert_eq!(texts(&answer), ["outer face (data-outer): yours is f3; it should be your f0"]);
    let answer = changed(|t| t.faces[2].as_mut().unwrap().half_edge = Some(h(1)));
    assert!(texts(&answer)[0].starts_with("your structure breaks an invariant: B1"), "{}", answer.text());
}

#[test]
fn an_edge_that_differs_hides_no_other_fault_and_makes_no_false_one() {
    let mut plane = ship();
    let right = table(&plane);
    plane.join_faces(common::h(41)).unwrap();
    let mut wrong = table(&plane);
    let answer = compare_tables(&right, &wrong, &Options::new());
    assert_eq!(texts(&answer), ["edge v10-v15 between (0, -75) and (0, 37.5) is missing"]);
    let answer = compare_tables(&wrong, &right, &Options::new());
    assert_eq!(texts(&answer), ["edge between (0, -75) and (0, 37.5) is not in the reference"]);
    let twin = wrong.half_edges[9].unwrap().twin;
    wrong.half_edges[9].as_mut().unwrap().next = twin;
    let answer = compare_tables(&right, &wrong, &Options::new());
    assert_eq!(answer.differences().len(), 2, "{}", answer.text());
}

#[test]
fn parallel_edges_are_told_apart_by_what_hangs_on_them() {
    // Two edges between the same two points, numbered in any order; then with one wrong pointer.
    let mut base = Table::from_view(&dcel_kit::topology::Dcel::polygon(2).unwrap());
    for (v, x) in base.vertices.iter_mut().flatten().zip([0.0, 4.0]) {
        v.position = Some([x, 0.0]);
    }
    base.outer_face = Some(common::f(0));
    let mut random = Random(3);
    for _ in 0..10 {
        let other = renumbered(&base, |n| random.shuffled(n));
        let answer = compare_tables(&base, &other, &Options::new());
        assert!(answer.is_equal(), "{}", answer.text());
    }
    let mut wrong = base.clone();
    wrong.half_edges[0].as_mut().unwrap().next = Some(common::h(1));
    assert!(!compare_tables(&base, &wrong, &Options::new()).is_equal());
}

#[test]
fn a_file_must_draw_what_it_declares() {
    let reference = kit(&table(&ship()));
    let mast = reference.lines().find(|line| line.starts_with("<line class=\"edge\"")).unwrap();
    let draws_wrong = reference.replacen(&format!("{mast}\n"), "", 1);
    let answer = judge(&reference, &draws_wrong);
    assert_eq!((answer.layer(), answer.differences().len()), (Layer::Drawn, 1), "{}", answer.text());
    assert!(answer.notes().last().unwrap().starts_with("what the file declares (data-*) agrees"), "{}", answer.text());

    let next = reference.find("data-next=\"").unwrap() + 11;
    let end = next + reference[next..].find('"').unwrap();
    let declares_wrong = format!("{}h50{}", &reference[..next], &reference[end..]);
    let answer = judge(&reference, &declares_wrong);
    assert_eq!((answer.layer(), answer.differences().len()), (Layer::Declared, 1), "{}", answer.text());
    assert!(answer.notes().last().unwrap().starts_with("what the file draws agrees"), "{}", answer.text());

    // Against a plain reference the file is compared with itself.
    let plain = Pen::new(&ship()).svg();
    assert!(judge(&plain, &reference).is_equal());
    let lies = reference.replace("data-x=\"125\"", "data-x=\"120\"");
    assert_ne!(lies, reference);
    let answer = judge(&plain, &lies);
    assert!(texts(&answer)[0].starts_with("the file does not draw what it declares (data-*): "), "{}", answer.text());

    // A reference that contradicts itself is no reference.
    let error = compare(&draws_wrong, &plain, &Options::new()).unwrap_err();
    assert_eq!(error.side, Side::Reference);
    assert!(error.to_string().contains("it does not draw what it declares: edge"), "{error}");
}

fn refused(svg: &str) -> String {
    let reference = Pen::new(&ship()).svg();
    let started = ThreadTime::now();
    let error = compare(&reference, svg, &Options::new()).unwrap_err();
    assert!(started.elapsed() < Duration::from_secs(8), "{error}");
    assert_eq!(error.side, Side::Student);
    error.to_string()
}

#[test]
fn what_cannot_be_read_is_refused_with_its_place() {
    let svg = |inside: &str| format!("<svg xmlns='http://www.w3.org/2000/svg'>\n{inside}\n</svg>");
    for (text, said) in [
        (String::new(), "student: the file is empty"),
        ("<html/>".to_owned(), "student:1:1: the first element is <html>, not <svg>"),
        ("<svg>\n<g></svg>".to_owned(), "student:2:4: not well-formed XML: expected 'g' tag, not 'svg'"),
        (
            format!("<!DOCTYPE svg [<!ENTITY a 'b'>]>{}", svg("")),
            "student:1:1: a DOCTYPE with declarations ([ ... ]) is not read",
        ),
        (svg("<g>&a;</g>"), "student:2:4: not well-formed XML: unknown entity"),
        (svg("<script>1</script>"), "student:2:1: <script> is not read"),
        (svg("<g onclick='x()'/>"), "student:2:1: the attribute `onclick` is not read"),
        (svg("<line x1='5em'/>"), "student:2:7: `5em` is no number"),
        (svg("<line x1='NaN'/>"), "student:2:7: `NaN` is no number"),
        (svg(" <line x2='1e999'/>"), "student:2:2: a coordinate of this line is not finite"),
        (svg("<polygon points='1,2 3'/>"), "student:2:1: `1,2 3` is no list of points"),
        (svg("<path d='M0 0 L1 1 X2'/>"), "student:2:1: `X2` is no path data"),
        (svg("<g transform='spin(3)'/>"), "student:2:1: `spin(3)` is no transform"),
        (svg("<g id='h1' data-next='x'/>"), "student:2:12: `x` is no half-edge: write its name, such as h5"),
        (svg("<g id='h1' data-next='h1'/><g id='a-h1' data-next='h2'/>"), "h1 is declared twice, first in line 2"),
        (svg("<g id='h99999999' data-next='h1'/>"), "the number of h99999999 is too large"),
        (svg("<text>nothing</text>"), "student: nothing is drawn here"),
        (
            svg("<style>a{fill:red} .x:nth-child(2n), b { display : none }</style>"),
            "student: the style rule `.x:nth-child(2n)` hides something, and what it fits cannot be told",
        ),
        (
            svg("<style>@media screen, all{.x{opacity:.01!important}}</style>"),
            "the style rule `@media screen, all` hides",
        ),
    ] {
        let error = refused(&text);
        assert!(error.contains(said), "{error}\nexpected {said}");
    }
}

#[test]
fn rules_that_hide_nothing_or_only_for_readers_are_no_fault() {
    let plain = Pen::new(&ship()).svg();
    let rules = "*{stroke-linejoin:round} g > line{stroke:black} .x:hover{display:none} #a:not(:target){opacity:0} \
                 @media print{line{display:none}} @media (prefers-color-scheme:dark){line{stroke:none}}";
    let styled = plain.replacen('>', &format!("><style>{rules}</style>"), 1);
    assert!(judge(&plain, &styled).is_equal());
    let hidden = plain.replacen('>', "><style>line:first-of-type{stroke-width:0px}</style>", 1);
    assert!(refused(&hidden).contains("the style rule `line:first-of-type` hides"));
}

#[test]
fn lines_of_a_grid_are_beside_the_drawing_and_edges_called_so_are_not() {
    let plain = Pen::new(&ship()).svg();
    let with = |lines: &str| plain.replacen("</svg>", &format!("<g id='matplotlib.axis_1'>{lines}</g></svg>"), 1);
    let line = |x0, y0, x1, y1| format!("<line x1='{x0}' y1='{y0}' x2='{x1}' y2='{y1}' stroke='#bbb'/>");
    let grid = line(5, 120, 595, 120) + &line(5, 300, 595, 300) + &line(222, 3, 222, 397);
    let answer = judge(&plain, &with(&grid));
    assert!(answer.is_equal(), "{}", answer.text());
    assert!(answer.notes().iter().any(|note| note.contains("3 lines and circles of a legend or an axis")));
    // What ends within the drawing is no line of a grid, whatever it is called; nor is a slanted one.
    for edge in [line(300, 120, 595, 120), line(5, 20, 595, 380)] {
        assert!(!judge(&plain, &with(&edge)).is_equal(), "{edge}");
    }
}

#[test]
fn hostile_files_end_quickly_with_a_clear_error() {
    let svg = |inside: &str| format!("<svg xmlns='http://www.w3.org/2000/svg'>{inside}</svg>");
    let many = |part: &str, n: usize| part.repeat(n);
    let bomb: String =
        (1..40).map(|i| format!("<g id='a{i}'>{}</g>", many(&format!("<use href='#a{}'/>", i - 1), 10))).collect();
    let deep = 20_000;
    for (name, text, said) in [
        ("deep", svg(&format!("{}{}", many("<g>", deep), many("</g>", deep))), "nested too deeply"),
        ("use of itself", svg("<g id='a'><use href='#a'/></g>"), "nested too deeply"),
        ("use bomb", svg(&format!("<defs><path id='a0' d='M0 0H1'/></defs>{bomb}")), "too large: more than"),
        ("many elements", svg(&many("<a/>", 250_000)), "too large: more than 200000 elements"),
        ("many bytes", svg(&many(" ", 9 << 20)), "too large: more than 8388608 bytes"),
        (
            "many attributes",
            format!("<svg {}/>", (0..300).map(|i| format!("a{i}='' ")).collect::<String>()),
            "attributes of one",
        ),
        ("many namespaces", svg(&(0..300).map(|i| format!("<g xmlns:a{i}='b'/>")).collect::<String>()), "namespace"),
        (
            "long path",
            svg(&format!("<path stroke='red' d='M0 0{}'/>", many("h1v1", 500_000))),
            "too large: more than 400000 lines",
        ),
        (
            "curves again and again",
            svg(&format!("<path id='p' d='M0 0{}'/>{}", many("T1 1", 90_000), many("<use href='#p'/>", 9_000))),
            "too large",
        ),
        (
            "style rules",
            svg(&format!("<style>{}</style>{}", many("a b c{x:y}", 9_000), many("<g/>", 9_000))),
            "style rules",
        ),
        ("transforms", svg(&many("<g transform='scale(9)'>", 250)), "not well-formed"),
        (
            "huge",
            svg(&format!("<g transform='{}'><circle cx='1' r='1'/></g>", many("scale(9e9)", 100_000))),
            "not finite",
        ),
        ("only opens", many("<", 3 << 20), "not well-formed"),
        ("equals signs", format!("<svg a='{}'/>", many("=", 3 << 20)), "equals signs"),
        (
            "crossing lines",
            svg(&(0..60_000)
                .map(|i| format!("<line x1='{i}' y1='0' x2='{}' y2='60000' stroke='red'/>", 60_000 - i))
                .collect::<String>()),
            "",
        ),
    ] {
        let reference = Pen::new(&ship()).svg();
        let started = ThreadTime::now();
        match compare(&reference, &text, &Options::new()) {
            Ok(answer) => assert!(said.is_empty() && !answer.is_equal(), "{name}: {}", answer.text()),
            Err(error) => assert!(!said.is_empty() && error.to_string().contains(said), "{name}: {error}"),
        }
        assert!(started.elapsed() < Duration::from_secs(10), "{name}: {:?}", started.elapsed());
    }
}

#[test]
fn other_encodings_are_named() {
    use dcel_kit::compare::text;
    let svg = Pen::new(&ship()).svg();
    let utf16: Vec<u8> = [0xff, 0xfe].into_iter().chain(svg.encode_utf16().flat_map(u16::to_le_bytes)).collect();
    let error = text(&utf16, Side::Student).unwrap_err();
    assert_eq!(error.to_string(), "student: this is UTF-16 text: save the file as UTF-8");
    let error = text(&[0x1f, 0x8b, 8, 0], Side::Student).unwrap_err();
    assert_eq!(error.problem, Problem::Compressed);
    assert!(text(b"<svg>\xe9</svg>", Side::Student).is_err());
    assert_eq!(text("\u{feff}<svg/>".as_bytes(), Side::Student), Ok("<svg/>"));
}

/// How long a grid of n x n squares is compared with itself in another order, one edge of it too short.
fn time_of_grid(n: usize) -> Duration {
    let mut lines = Vec::new();
    for i in 0..n {
        for j in 0..=n {
            lines.push(format!("<path fill='none' stroke='red' stroke-width='.1' d='M{i} {j}h1M{j} {i}v1'/>"));
        }
    }
    assert_eq!(lines.len(), n * (n + 1));
    let mut other = lines.clone();
    other.reverse();
    other[77] = other[77].replace("h1", "h0");
    let (reference, student) = (document(&lines), document(&other));
    let started = ThreadTime::now();
    let answer = judge(&reference, &student);
    let time = started.elapsed();
    println!("{} edges: {time:?}", 2 * lines.len());
    assert_eq!(answer.differences().len(), 1, "{}", answer.text());
    time
}

#[test]
fn large_drawings_are_compared_in_about_a_second() {
    // 24,864 and 99,904 edges: four times as many may take eight times as long, on whatever machine; all pairs would
    // take sixteen times as long.
    let (small, large) = (time_of_grid(111), time_of_grid(223));
    assert!(large < 8 * small, "{small:?}, {large:?}");
    assert!(large < Duration::from_secs(6), "{large:?}");

    let (reference, student) = (kit(&table(&ship())), Pen::new(&ship()).svg());
    let started = ThreadTime::now();
    assert!((0..20).all(|_| judge(&reference, &student).is_equal()));
    println!("the drawing of the lab: {:?}", started.elapsed() / 20);
}

#[test]
fn the_picture_shows_what_differs() {
    let right = table(&ship());
    let mut other = ship();
    other.join_faces(common::h(41)).unwrap();
    let mut wrong = table(&other);
    let twin = wrong.half_edges[9].unwrap().twin;
    wrong.half_edges[9].as_mut().unwrap().next = twin;
    wrong.vertices[12].as_mut().unwrap().position = Some([-110.0, -60.0]);
    let answer = compare_tables(&right, &wrong, &Options::new());
    let svg = answer.figure(&FigureOptions::new("What differs").id_prefix("diff")).unwrap().to_svg();
    assert!(roxmltree::Document::parse(&svg).is_ok());
    for part in ["class=\"diff miss\"", "class=\"diff extra\"", "class=\"ring\"", "class=\"thread\"", "3 differences"] {
        assert!(svg.contains(part), "{part} is not in the picture: {}", answer.text());
    }
    // The student's drawing beside it, and the half-edges that the list names.
    assert!(svg.contains("your drawing, as it was read") && svg.contains("class=\"yl\""));
    let named: Vec<&str> = answer.differences().iter().flat_map(|d| d.text.split([' ', ',', ';', ':'])).collect();
    let labels =
        svg.split("class=\"hn\"").skip(1).map(|rest| rest.split('>').nth(1).unwrap().split('<').next().unwrap());
    let labels: Vec<&str> = labels.map(str::trim).collect();
    assert!(labels.len() > 1 && labels.iter().all(|label| named.contains(label)), "{labels:?} {named:?}");
    let badges = svg.matches("class=\"badge\"").count();
    assert_eq!(badges, 2 * answer.differences().len(), "each in the drawing and in the list");
    assert_eq!(svg, answer.figure(&FigureOptions::new("What differs").id_prefix("diff")).unwrap().to_svg());
    let plain = judge(&Pen::new(&ship()).svg(), &Pen::new(&other).svg());
    let svg = plain.figure(&FigureOptions::new("plain")).unwrap().to_svg();
    assert!(svg.contains("class=\"diff miss\"") && !svg.contains("class=\"sh\""), "drawings have no half-edges");
}

#[test]
fn what_is_the_same_is_told_once() {
    let pen = Pen::new(&ship());
    let reference = pen.svg();
    let white = reference.replace("r=\"4\"/>", "r=\"4\" fill=\"white\"/>");
    let answer = judge(&reference, &white);
    assert_eq!(answer.differences().len(), 1, "{}", answer.text());
    assert!(texts(&answer)[0].starts_with("22 vertices have the colour of the paper: at ("), "{}", answer.text());
    let thin = reference.replace("stroke=\"black\"", "stroke=\"black\" stroke-width=\"0\"");
    let answer = judge(&reference, &thin);
    assert_eq!(answer.differences().len(), 1, "{}", answer.text());
    assert!(texts(&answer)[0].starts_with("33 edges cannot be seen, their stroke-width is 0: "), "{}", answer.text());
    // Each badge of the picture has its number in the list.
    let svg = answer.figure(&FigureOptions::new("thin")).unwrap().to_svg();
    assert_eq!(svg.matches("class=\"badge\"").count(), 2);
}

#[test]
fn the_rows_of_a_focus_figure_are_no_part_of_its_structure() {
    let [cube, focus] = [include_str!("../../../figures/cube.svg"), include_str!("../../../figures/focus.svg")];
    for (reference, student) in [(cube, focus), (focus, cube)] {
        let answer = judge(reference, student);
        assert!(answer.is_equal() && answer.layer() == Layer::Declared, "{}", answer.text());
    }
    // A line that is missing is still seen.
    let line = focus.lines().find(|line| line.starts_with("<line class=\"edge\"")).unwrap();
    assert!(!judge(cube, &focus.replacen(line, "", 1)).is_equal());
}

#[test]
fn how_a_drawing_is_turned_or_stretched_is_named() {
    let pen = Pen::new(&ship());
    let reference = pen.svg();
    let (s, c) = 12f64.to_radians().sin_cos();
    for (changed, said) in [
        (
            pen.moved(|[x, y]| [0.6 * (c * x - s * y), 0.6 * (s * x + c * y)]),
            "the drawing is turned by 12° to the left",
        ),
        (
            pen.moved(|[x, y]| [0.6 * (c * x + s * y), 0.6 * (c * y - s * x)]),
            "the drawing is turned by 12° to the right",
        ),
        (pen.moved(|[x, y]| [0.6 * (c * x + s * y), 0.6 * (s * x - c * y)]), "the drawing is mirrored and turned"),
        (pen.moved(|[x, y]| [0.5 * x, y]), "the drawing is stretched: x is drawn 0.5 times as large as y"),
    ] {
        let answer = judge(&reference, &changed.svg());
        assert!(texts(&answer)[0].starts_with(said), "{said}: {}", answer.text());
    }
}
