//! What a figure of the kit declares is drawn where it is declared: lines, barbs and names of half-edges.

use super::pen::{P, Pen, table};
use super::{judge, kit, ship};
use dcel_kit::FaceId;
use dcel_kit::compare::{Options, compare};
use dcel_kit::figure::{self, Detail, FigureOptions, structure};
use dcel_kit::plane::{Point, Subdivision};
use dcel_kit::topology::PolygonList;

pub(super) fn reference() -> String {
    kit(&table(&ship()))
}

/// The place of the group of an element among the lines of a figure.
fn group(lines: &[String], name: &str) -> usize {
    lines.iter().position(|line| line.starts_with("<g ") && line.contains(&format!("id=\"ship-{name}\""))).unwrap()
}

/// The line within a group that starts so.
pub(super) fn within(lines: &[String], name: &str, start: &str) -> usize {
    let at = group(lines, name);
    at + lines[at..].iter().position(|line| line.starts_with(start)).unwrap()
}

pub(super) fn changed(change: impl FnOnce(&mut Vec<String>)) -> String {
    let mut lines: Vec<String> = reference().lines().map(str::to_owned).collect();
    change(&mut lines);
    lines.join("\n")
}

pub(super) const LINE: &str = "<line class=\"sh\"";
pub(super) const BARB: &str = "<path class=\"barb\"";
pub(super) const NAME: &str = "<text class=\"hl\"";

#[track_caller]
pub(super) fn says(svg: &str, said: &str) {
    // The same against what declares, and against what only draws.
    for reference in [reference(), Pen::new(&ship()).svg()] {
        let answer = judge(&reference, svg);
        assert!(!answer.is_equal() && answer.text().contains(said), "`{said}` not said: {}", answer.text());
    }
}

#[test]
fn half_edges_are_drawn_where_they_are_declared() {
    let is_part = |line: &str| [LINE, BARB, NAME].iter().any(|start| line.starts_with(start));
    says(&changed(|lines| lines.retain(|line| !is_part(line))), "66 half-edges are declared and not drawn: h0, h1");
    says(&changed(|lines| lines.retain(|line| !line.starts_with(LINE))), "66 half-edges are declared and not drawn");
    let one = |lines: &mut Vec<String>| {
        let at = within(lines, "h0", LINE);
        lines.drain(at..at + 2);
    };
    says(&changed(one), "1 half-edge is declared and not drawn: h0");
    let swap = |lines: &mut Vec<String>, start: &str| {
        let [a, b] = ["h0", "h1"].map(|name| within(lines, name, start));
        lines.swap(a, b);
    };
    let both = changed(|lines| [LINE, BARB].iter().for_each(|start| swap(lines, start)));
    says(&both, "2 half-edges are not drawn on the left of their edges, from vertex to vertex: h0, h1");
}

#[test]
fn barbs_point_to_the_ends_of_their_half_edges() {
    let reference = reference();
    for rule in ["#ship .barb{fill:none}", "#ship .barb{display:none}"] {
        let svg = reference.replacen("</style>", &format!("{rule}</style>"), 1);
        says(&svg, "66 half-edges have no barbs that can be seen: h0, h1");
    }
    says(&changed(|lines| lines.retain(|line| !line.starts_with(BARB))), "66 half-edges have no barbs");
    let swapped = changed(|lines| {
        let [a, b] = ["h0", "h1"].map(|name| within(lines, name, BARB));
        lines.swap(a, b);
    });
    says(&swapped, "2 half-edges have barbs that do not point to the ends of them: h0, h1");
}

/// Moves what a line of a figure draws.
pub(super) fn moved(lines: &mut [String], name: &str, start: &str, transform: &str) {
    let at = within(lines, name, start);
    lines[at] = lines[at].replacen(" class", &format!(" transform=\"{transform}\" class"), 1);
}

/// The place at which a path of a figure starts: the tip of a barb.
fn start_of(line: &str) -> [f64; 2] {
    let data = &line[line.find(" d=\"m").unwrap() + 5..];
    let end = |rest: &str| {
        let is_part = |(i, c): (usize, char)| c.is_ascii_digit() || c == '.' || i == 0 && c == '-';
        rest.char_indices().find(|&at| !is_part(at)).unwrap().0
    };
    let (x, rest) = data.split_at(end(data));
    let rest = rest.trim_start();
    [x, &rest[..end(rest)]].map(|number| number.parse().unwrap())
}

#[test]
fn barbs_lie_behind_their_tips_at_the_ends_of_their_own_lines() {
    let names: Vec<String> = (0..66).map(|h| format!("h{h}")).collect();
    for angle in [90, 135, 180, -90, -45] {
        let turned = changed(|lines| {
            for name in &names {
                let [x, y] = start_of(&lines[within(lines, name, BARB)]);
                moved(lines, name, BARB, &format!("rotate({angle} {x} {y})"));
            }
        });
        says(&turned, "66 half-edges have barbs that do not point to the ends of them: h0, h1");
    }
    for [x, y] in [[25, 25], [-25, 25], [25, -25], [-25, -25], [12, 0], [0, 12]] {
        for name in ["h0", "h7", "h20"] {
            let shifted = changed(|lines| moved(lines, name, BARB, &format!("translate({x} {y})")));
            says(&shifted, &format!("1 half-edge has a barb that does not point to the end of it: {name}"));
        }
    }
}

#[test]
fn lines_are_as_far_from_their_edges_as_others_are() {
    let reference = reference();
    let mut seen = 0;
    for name in (0..66).map(|h| format!("h{h}")) {
        for [x, y] in [[14, 14], [-14, 14], [14, -14], [-14, -14]] {
            let shifted = changed(|lines| {
                [LINE, BARB].iter().for_each(|start| moved(lines, &name, start, &format!("translate({x} {y})")));
            });
            let answer = judge(&reference, &shifted);
            let [sine, cosine] = direction(&reference, &name);
            // To the left, with y down.
            if f64::from(x) * sine - f64::from(y) * cosine > 11.5 {
                let said = format!("1 half-edge is not drawn on the left of its edge, from vertex to vertex: {name}");
                assert!(answer.text().contains(&said), "{name} {x} {y}: {}", answer.text());
                seen += 1;
            }
        }
    }
    assert!(seen > 60, "{seen}");
}

/// The direction of the line of a half-edge on the canvas: how far down it runs, and how far to the right.
pub(super) fn direction(svg: &str, name: &str) -> [f64; 2] {
    let lines: Vec<String> = svg.lines().map(str::to_owned).collect();
    let line = &lines[within(&lines, name, LINE)];
    let [x, u, y, v] = [" x1=\"", " x2=\"", " y1=\"", " y2=\""].map(|key| {
        let rest = &line[line.find(key).unwrap() + key.len()..];
        rest[..rest.find('"').unwrap()].parse::<f64>().unwrap()
    });
    let length = (u - x).hypot(v - y);
    [(v - y) / length, (u - x) / length]
}

/// All figures of the kit are drawn as they declare, whatever else they show.
#[test]
fn the_figures_of_the_kit_show_what_they_declare() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../figures");
    let mut seen = 0;
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|ending| ending != "svg") {
            continue;
        }
        let full = std::fs::read_to_string(&path).unwrap();
        if !full.contains("data-origin") || !full.contains("data-figure") {
            continue;
        }
        // A reference without any line or barb excuses none that is elsewhere or points backwards.
        let starts = ["<line class=\"sh", "<path class=\"barb"];
        let bare: Vec<&str> = full.lines().filter(|line| !starts.iter().any(|start| line.starts_with(start))).collect();
        if let Ok(answer) = compare(&bare.join("\n"), &full, &Options::new()) {
            assert!(answer.is_equal(), "{}: {}", path.display(), answer.text());
            seen += 1;
        }
    }
    assert!(seen > 5, "{seen}");
}

pub(super) fn named(svg: &str) -> String {
    compare(&reference(), svg, &Options::new().names(true)).unwrap().text()
}

#[test]
fn names_say_what_they_name_and_stand_where_it_is() {
    assert!(named(&reference().replace('\n', "\r\n")).starts_with("equal"));
    for (element, other) in [("v1", "v0"), ("h0", "h1"), ("f1", "f2")] {
        let says_other = changed(|lines| {
            let at = within(lines, element, "<text");
            lines[at] = lines[at].replace(&format!(">{element}<"), &format!(">{other}<"));
        });
        let said = format!("the name drawn at {element} is {other}");
        assert!(named(&says_other).contains(&said), "{said}: {}", named(&says_other));
        assert!(judge(&reference(), &says_other).is_equal());
        // The text of the one where that of the other stands.
        let elsewhere = changed(|lines| {
            let [a, b] = [element, other].map(|name| within(lines, name, "<text"));
            let moved = lines[b].replace(&format!(">{other}<"), &format!(">{element}<"));
            lines[a] = moved;
        });
        let said = format!("the name of {element} does not stand where {element} is drawn");
        assert!(named(&elsewhere).contains(&said), "{said}: {}", named(&elsewhere));
        let gone = changed(|lines| _ = lines.remove(within(lines, element, "<text")));
        assert!(named(&gone).contains(&format!("the name of {element} is not drawn")), "{}", named(&gone));
        let hidden = changed(|lines| {
            let at = within(lines, element, "<text");
            lines[at] = lines[at].replacen("<text", "<text visibility=\"hidden\"", 1);
        });
        assert!(named(&hidden).contains(&format!("the name of {element} cannot be seen")), "{}", named(&hidden));
    }
}

#[test]
fn names_of_half_edges_stand_at_their_edges() {
    let reference = reference();
    let mut seen = 0;
    for name in (0..66).map(|h| format!("h{h}")) {
        let [sine, cosine] = direction(&reference, &name);
        let lines: Vec<String> = reference.lines().map(str::to_owned).collect();
        if !lines[within(&lines, &name, "<text")].contains(&format!(">{name}<")) {
            continue;
        }
        seen += 1;
        // To the left of its own line, by so many px.
        for (far, stays) in [(12.0, true), (95.0, false)] {
            let shift = format!("translate({} {})", far * sine, -far * cosine);
            let answer = named(&changed(|lines| moved(lines, &name, NAME, &shift)));
            let said = ["does not stand where", "cannot be seen"].map(|said| format!("the name of {name} {said}"));
            assert!(said.iter().any(|said| answer.contains(said)) != stays, "{name} {far}: {answer}");
        }
    }
    assert!(seen > 40, "{seen}");
}

#[test]
fn names_of_drawings_that_declare_none_are_refused() {
    let plain = Pen::new(&ship()).svg();
    for [mine, theirs] in [[&plain, &reference()], [&reference(), &plain], [&plain, &plain]] {
        let error = compare(mine, theirs, &Options::new().names(true)).unwrap_err().to_string();
        assert!(error.contains("names cannot be compared: this drawing declares none in data-* attributes"), "{error}");
    }
}

/// Hole faces have the colour of the paper, and light lines over it.
#[test]
fn figures_with_holes_are_equal_to_themselves() {
    let points = [(0., 0.), (10., 0.), (10., 10.), (0., 10.), (2., 2.), (4., 2.), (4., 4.), (2., 4.)].map(Point::from);
    let mut garden = PolygonList::new();
    garden.push_face(&[0, 1, 2, 3]);
    garden.push_hole(&[4, 5, 6, 7]);
    let map = Subdivision::from_polygons(points.to_vec(), &garden).unwrap();
    assert!(map.is_hole(FaceId::new(2)));
    let svg = kit(&table(&map));
    let answer = judge(&svg, &svg.replacen("<desc", "<!-- other bytes --><desc", 1));
    assert!(answer.is_equal(), "{}", answer.text());
    // A face that is none is still missed.
    let unfilled = svg.replacen("class=\"face", "display=\"none\" class=\"face", 1);
    assert!(!judge(&svg, &unfilled).is_equal());
    // Of a figure that declares no pointers, too, another program may leave a hole open, or fill it.
    let simple = structure(&map, &FigureOptions::new("garden").detail(Detail::Edges)).unwrap().to_svg();
    let pen = Pen::new(&map).moved(|p| p.map(|x| 15.0 * x));
    let path = |rings: &[Vec<P>]| {
        let ring = |ring: &Vec<P>| {
            let corners: Vec<String> = ring.iter().map(|&p| Pen::canvas(p)).map(|[x, y]| format!("{x},{y}")).collect();
            format!("M{}Z", corners.join(" "))
        };
        let data: String = rings.iter().map(ring).collect();
        format!("<path fill=\"pink\" fill-rule=\"evenodd\" d=\"{data}\"/>")
    };
    let drawn = |areas: &[Vec<P>]| {
        Pen { areas: Vec::new(), ..pen.clone() }.svg().replacen('\n', &format!("\n{}\n", path(areas)), 1)
    };
    for areas in [&pen.areas[..], &pen.areas[..1]] {
        let answer = judge(&simple, &drawn(areas));
        assert!(answer.is_equal(), "{}", answer.text());
    }
    assert!(!judge(&simple, &drawn(&pen.areas[1..])).is_equal());
}

#[test]
fn vertices_drawn_at_each_others_places_are_named_first() {
    const DISC: &str = "<circle";
    let exchanged = changed(|lines| {
        let [a, b] = ["v1", "v2"].map(|name| within(lines, name, DISC));
        lines.swap(a, b);
    });
    let answer = judge(&reference(), &exchanged);
    assert_eq!(answer.differences()[0].text, "2 vertices are drawn where others belong: v1 at v2, v2 at v1");
    assert!(named(&exchanged).contains("1. 2 vertices are drawn where others belong"), "{}", named(&exchanged));
}

#[test]
fn tables_and_insets_are_no_part_of_the_structure() {
    let plane = ship();
    let options = |name: &str| FigureOptions::new(name).detail(Detail::Full);
    let inset = figure::inset(&plane, None, &options("ship")).unwrap().to_svg();
    let tables = |plain: bool| figure::tables(&plane, None, &options("ship").plain(plain)).unwrap().to_svg();
    let [simple, tabled, bare] = [reference(), tables(false), tables(true)];
    for other in [&inset, &tabled, &bare] {
        for [mine, theirs] in [[&simple, other], [other, &simple], [other, &other.replacen("<desc", " <desc", 1)]] {
            let answer = judge(mine, theirs);
            assert!(answer.is_equal(), "{}", answer.text());
        }
        // An edge less is still one less.
        let at = other.find("<line class=\"edge\"").or_else(|| other.find("<line fill")).unwrap();
        let less = format!("{}{}", &other[..at], &other[at + other[at..].find("/>").unwrap() + 2..]);
        assert!(!judge(&simple, &less).is_equal());
    }
}
