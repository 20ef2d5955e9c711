//! Figures of structures and options that are hard to draw: read back from the SVG text.

use crate::cases;
use crate::cases::P;
use crate::drawn;
use crate::drawn::{Drawn, inside, read};
use dcel_kit::figure::{Colour, FigureError, FigureOptions, NearlyCollinear, Overrides, Style, Theme, Unit, structure};
use dcel_kit::topology::Table;
use dcel_kit::{FaceId, HalfEdgeId, VertexId};
use roxmltree::Document;

fn draw(table: &Table, options: &FigureOptions) -> String {
    structure(table, options).unwrap().to_svg()
}

fn face(i: u32) -> FaceId {
    FaceId::new(i)
}

/// A wide room, and rooms of a few px along its right wall.
fn narrow(count: usize) -> Table {
    let mut points: Vec<P> = vec![[0., 0.], [8., 0.], [8., 6.], [0., 6.]];
    let mut segments: Vec<_> = cases::closed(0, 4).collect();
    for i in 0..count {
        let y = 0.5 + 0.5 * i as f64;
        points.extend([[7.8, y], [7.88, y], [7.84, y + 0.08]]);
        segments.extend(cases::closed(4 + 3 * i, 3));
    }
    cases::plane(&points, &segments)
}

/// The ends of the line of a face's leader.
fn leader(svg: &str, id: &str) -> Option<(P, P)> {
    let document = Document::parse(svg).unwrap();
    let group =
        document.descendants().find(|n| n.attribute("id").is_some_and(|i| i.ends_with(&format!("-{id}-label"))))?;
    let line = group.children().find(|n| n.has_tag_name(("http://www.w3.org/2000/svg", "line")))?;
    let number = |name: &str| line.attribute(name).unwrap().parse::<f64>().unwrap();
    Some(([number("x1"), number("y1")], [number("x2"), number("y2")]))
}

fn distance(p: P, a: P, b: P) -> f64 {
    let (d, e) = ([b[0] - a[0], b[1] - a[1]], [p[0] - a[0], p[1] - a[1]]);
    let length2 = (d[0] * d[0] + d[1] * d[1]).max(1e-12);
    let t = ((d[0] * e[0] + d[1] * e[1]) / length2).clamp(0.0, 1.0);
    let q = [a[0] + d[0] * t - p[0], a[1] + d[1] * t - p[1]];
    (q[0] * q[0] + q[1] * q[1]).sqrt()
}

#[test]
fn a_face_without_room_has_its_label_at_a_leader_line() {
    for count in [1, 3, 6] {
        let svg = draw(&narrow(count), &FigureOptions::new("narrow"));
        let drawn = read(&svg);
        let mut lines: Vec<(P, P)> = Vec::new();
        for id in (0..drawn.areas.len()).map(|i| format!("f{i}")).filter(|id| drawn.areas[id][0].1.len() == 1) {
            let word =
                drawn.words.iter().find(|w| w.owner == id).unwrap_or_else(|| panic!("{count}: {id} has no label"));
            assert_eq!((word.class.as_str(), word.text.as_str()), ("ll", id.as_str()), "{count}");
            let (root, end) = leader(&svg, &id).unwrap();
            assert!(inside(&drawn.areas[&id][0].1, root), "{count}: the leader of {id} begins elsewhere");
            assert!(word.distance(end) < 5.0, "{count}: the leader of {id} ends far from its label");
            let tinted = drawn.areas.values().flatten().filter(|(class, _)| class.starts_with("face"));
            assert!(
                !tinted.into_iter().any(|(_, rings)| inside(rings, word.at)),
                "{count}: {id} stands in another face"
            );
            for other in drawn.words.iter().filter(|other| other.owner != id) {
                assert!(!other.overlaps(word), "{count}: {word:?} covers {other:?}");
                let half = other.half();
                for k in 0..=60 {
                    let t = f64::from(k) / 60.0;
                    let p = [0, 1].map(|i| root[i] + (end[i] - root[i]) * t);
                    let covers = (0..2).all(|i| (p[i] - other.at[i]).abs() < half[i]);
                    assert!(!covers, "{count}: the leader of {id} crosses {other:?}");
                }
            }
            let far = drawn.discs.iter().filter(|(_, (centre, _))| distance(*centre, root, root) > 10.0);
            for (v, &(centre, radius)) in far {
                assert!(distance(centre, root, end) > radius, "{count}: the leader of {id} crosses {v}");
            }
            lines.push((root, end));
        }
        assert_eq!(lines.len(), count);
        for (i, &(a, b)) in lines.iter().enumerate() {
            for &(p, q) in &lines[i + 1..] {
                let side = |a: P, b: P, p: P| (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
                let apart = side(a, b, p) * side(a, b, q) > 0.0 || side(p, q, a) * side(p, q, b) > 0.0;
                assert!(apart, "{count}: two leaders cross");
            }
        }
    }
}

#[test]
fn a_thicket_of_leaders_is_left_out_and_the_tooltips_stay() {
    let mut points: Vec<P> = vec![[0., 0.], [80., 0.], [80., 60.], [0., 60.]];
    let mut segments: Vec<_> = cases::closed(0, 4).collect();
    for i in 0..30 {
        let (x, y) = (5. + 12. * f64::from(i % 6), 5. + 9. * f64::from(i / 6));
        let first = points.len();
        points.extend([[x, y], [x + 0.3, y], [x, y + 0.3]]);
        segments.extend(cases::closed(first, 3));
    }
    let drawn = read(&draw(&cases::plane(&points, &segments), &FigureOptions::new("thicket")));
    assert!(drawn.words.iter().all(|word| word.class != "ll"));
    assert!((1..=31).all(|i| drawn.titles[&format!("f{i}")].starts_with(&format!("f{i}:"))));
}

#[test]
fn very_long_names_are_cut_short_and_whole_in_the_tooltip() {
    let long = "the northernmost of all the courtyards ".repeat(8);
    let overrides = Overrides::default()
        .label(VertexId::new(0), "a vertex with a name that is far too long for it")
        .label(HalfEdgeId::new(2), "a half-edge with a name that is far too long");
    let options = FigureOptions::new("long")
        .face_name(face(0), &long)
        .face_name(face(5), long.replace("north", "south"))
        .overrides(overrides);
    let drawn = read(&draw(&cases::cube(), &options));
    for id in ["f0", "f5"] {
        let words: Vec<_> = drawn.words.iter().filter(|word| word.owner == id).collect();
        assert!(words.last().unwrap().text.ends_with('…'), "{id}: {words:?}");
        assert!(drawn.titles[id].len() > long.len(), "{id}");
    }
    for id in ["v0", "h2"] {
        let word = drawn.words.iter().find(|word| word.owner == id).unwrap_or_else(|| panic!("{id} has no name"));
        assert!(word.text.ends_with('…') && (18..=20).contains(&word.text.chars().count()), "{word:?}");
    }
    for (i, word) in drawn.words.iter().enumerate() {
        let half = word.half();
        assert!((0..2).all(|k| (half[k]..drawn.size[k] - half[k]).contains(&word.at[k])), "{word:?} leaves the canvas");
        assert!(drawn.words[i + 1..].iter().all(|other| !word.overlaps(other)), "{word:?} covers another");
    }
}

#[test]
fn vertices_at_one_place_have_both_names_beside_it() {
    let points = [[0., 0.], [4., 0.], [4., 3.], [0., 3.], [4., 3.]];
    let drawn = read(&draw(&cases::plane(&points, &cases::closed(0, 4).collect::<Vec<_>>()), &FigureOptions::new("x")));
    let words: Vec<_> = ["v2", "v4"].map(|id| drawn.words.iter().find(|word| word.owner == id).unwrap()).into();
    assert!(!words[0].overlaps(words[1]), "{words:?}");
}

/// Powers of two change no digit of a number: the drawing must not change either.
#[test]
fn the_drawing_does_not_depend_on_the_size_or_the_place_of_the_plane() {
    let lines = |table: &Table| {
        let svg = draw(table, &FigureOptions::new("same"));
        let model = ["data-x", "data-y", "data-scale", "<title>", "(", "), outgoing"];
        let lines = svg.lines().filter(|line| !model.iter().any(|word| line.contains(word)));
        lines.map(str::to_owned).collect::<Vec<_>>()
    };
    let moved = |table: &Table, factor: f64, by: P| {
        let mut table = table.clone();
        for row in table.vertices.iter_mut().flatten() {
            row.position = row.position.map(|[x, y]| [x * factor + by[0], y * factor + by[1]]);
        }
        table
    };
    let lab = cases::lab();
    let usual = lines(&lab);
    let two = |exponent: i32| 2f64.powi(exponent);
    for (factor, by) in
        [(two(-30), [0.0; 2]), (two(30), [0.0; 2]), (1.0, [two(30), -two(30)]), (two(-20), [two(30), 0.0])]
    {
        assert_eq!(lines(&moved(&lab, factor, by)), usual, "{factor} {by:?}");
    }
    assert!(usual.len() > 100);
}

#[test]
fn a_part_of_the_faces_has_its_half_edges_and_no_others() {
    let table = cases::cube();
    let drawn = read(&draw(&table, &FigureOptions::new("part").faces([face(1), face(5)])));
    let of = |id: &str| drawn.data[id]["data-face"].clone();
    assert_eq!(drawn.areas.keys().collect::<Vec<_>>(), ["f1", "f5"]);
    assert_eq!(drawn.arrows.len(), 8);
    assert!(drawn.arrows.keys().all(|id| ["f1", "f5"].contains(&of(id).as_str())));
    assert_eq!((drawn.discs.len(), drawn.edges.len()), (6, 7), "one edge is shared");
    let error = structure(&table, &FigureOptions::new("part").faces([face(6)])).unwrap_err();
    assert_eq!(error, FigureError::UnknownFace { face: face(6), faces: 6 });
}

#[test]
fn a_crop_shows_what_lies_in_it_at_its_scale() {
    let table = cases::cube();
    let draw_at = |a: P, b: P| read(&draw(&table, &FigureOptions::new("crop").width(600.0).crop(a, b)));
    let drawn = draw_at([3.0, 3.0], [-1.0, -1.0]);
    assert!(drawn.size.iter().all(|side| (side - 600.0).abs() < 0.01), "{:?}", drawn.size);
    assert_eq!(drawn.discs.keys().collect::<Vec<_>>(), ["v0", "v4"], "the others lie outside");
    let at = drawn.discs["v4"].0;
    assert!((at[0] - 2.8 * 150.0).abs() < 0.01 && (at[1] - 1.2 * 150.0).abs() < 0.01, "{at:?}");
    assert!(!drawn.data.contains_key("h4"), "2 to 3 on the far side");
    for word in drawn.words.iter().filter(|word| word.class == "fl") {
        assert!(inside(&drawn.areas[&word.owner][0].1, word.at), "{word:?}");
    }
    for id in ["f1", "f4", "f5"] {
        assert!(drawn.words.iter().any(|word| word.text == id), "{id} is seen and has no label");
    }
    let corners = drawn.areas.values().flatten().flat_map(|(_, rings)| rings.iter().flatten());
    assert!(corners.into_iter().all(|p| p.iter().all(|x| (-0.01..=600.01).contains(x))), "areas end at the border");
    for tiny in [1e-6, 1e-12] {
        let near = [1.8 + tiny, 1.8 + tiny];
        let svg = draw(&table, &FigureOptions::new("crop").crop([1.8 - tiny, 1.8 - tiny], near));
        assert!(!svg.contains("NaN") && !svg.contains("inf"));
        assert_eq!(read(&svg).discs.keys().collect::<Vec<_>>(), ["v4"]);
    }
}

fn attribute<'a>(document: &'a Document<'_>, id: &str, name: &str, key: &str) -> Option<&'a str> {
    let group = document.descendants().find(|n| n.attribute("id") == Some(id))?;
    group.children().rfind(|n| n.tag_name().name() == name)?.attribute(key)
}

#[test]
fn a_plain_file_needs_no_style_sheet() {
    let overrides =
        Overrides::default().colour(HalfEdgeId::new(3), Colour(0x0012_3456)).colour(face(2), Colour(0x00ab_cdef));
    let options = FigureOptions::new("x").overrides(overrides);
    let styled = draw(&cases::islands(), &options);
    let svg = draw(&cases::islands(), &options.plain(true));
    assert!(!svg.contains("<style") && !svg.contains("class=") && !svg.contains("@media"));
    let document = Document::parse(&svg).unwrap();
    let count = |svg: &str, tag: &str| svg.matches(tag).count();
    for tag in ["<line", "<path", "<circle", "</g>", "<title"] {
        assert_eq!(count(&svg, tag), count(&styled, tag), "{tag}");
    }
    assert_eq!(count(&svg, "<text"), 2 * count(&styled, "<text"), "each text has a halo");
    for node in
        document.descendants().filter(|n| ["line", "circle", "text", "path", "rect"].contains(&n.tag_name().name()))
    {
        let has = |key: &str| node.attribute(key).is_some_and(|value| value != "none");
        assert!(has("fill") || has("stroke"), "{node:?} would be black");
        assert!(node.tag_name().name() != "text" || (has("font-family") && has("text-anchor")), "{node:?}");
    }
    let style = Style::default();
    assert_eq!(attribute(&document, "x-h2", "line", "stroke"), Some(style.light.half_edge.to_string().as_str()));
    assert_eq!(attribute(&document, "x-h3", "line", "stroke"), Some("#123456"));
    assert_eq!(attribute(&document, "x-f2", "path", "fill"), Some("#abcdef"));
    assert_eq!(attribute(&document, "x-v0", "circle", "stroke"), Some(style.light.ink.to_string().as_str()));
}

#[test]
fn themes_choose_one_palette() {
    let style = Style::default();
    let paper = |theme| {
        let svg = draw(&cases::cube(), &FigureOptions::new("x").style(style.clone().theme(theme)));
        let rule = svg.lines().find(|line| line.starts_with("#x .bg")).unwrap().to_owned();
        (rule, svg.contains("@media"))
    };
    let rule = |colour: Colour| format!("#x .bg{{fill:{colour}}}");
    let dark = style.dark.as_ref().unwrap().background;
    assert_eq!(paper(Theme::Auto), (rule(style.light.background), true));
    assert_eq!(paper(Theme::Light), (rule(style.light.background), false));
    assert_eq!(paper(Theme::Dark), (rule(dark), false));
}

#[test]
fn a_width_on_paper_is_stated_in_its_unit() {
    let options = FigureOptions::new("x").width(Unit::parse_length("12cm").unwrap().0);
    let size = |options: &FigureOptions| {
        let svg = draw(&cases::grid(4, false), options);
        let root = svg.lines().next().unwrap().to_owned();
        let value = |key: &str| root.split(&format!(" {key}=\"")).nth(1).unwrap().split('"').next().unwrap().to_owned();
        (value("width"), value("height"), value("viewBox"))
    };
    assert_eq!(size(&options), ("453.54".into(), "453.54".into(), "0 0 453.54 453.54".into()));
    assert_eq!(size(&options.clone().unit(Unit::Cm)), ("12cm".into(), "12cm".into(), "0 0 453.54 453.54".into()));
    assert_eq!(size(&options.unit(Unit::Mm)), ("120mm".into(), "120mm".into(), "0 0 453.54 453.54".into()));
}

#[test]
fn labels_of_single_elements_stand_in_place_of_their_ids() {
    let overrides = Overrides::parse("v0 \"A\"\nh5 \"e\"\nf3 #ffffff \"hall\"").unwrap();
    let drawn: Drawn = read(&draw(&cases::cube(), &FigureOptions::new("x").overrides(overrides)));
    let text = |id: &str| drawn.words.iter().find(|word| word.owner == id).unwrap().text.clone();
    assert_eq!(["v0", "h5", "f3", "v1"].map(text), ["A", "e", "hall", "v1"]);
    assert_eq!(drawn.data["f3"]["data-name"], "hall");
}

/// The classic neighbourhood in whole multiples of 2^-53, with 128-bit integers.
#[test]
fn the_robustness_map_shows_where_doubles_are_wrong() {
    let svg = dcel_kit::figure::robustness(&NearlyCollinear::default(), &FigureOptions::new("r")).to_svg();
    let unit = f64::EPSILON / 2.0;
    let whole = |x: i128| x << 53;
    let (mut wrong, mut counts) = (0u32, [0u32; 3]);
    for k in 0..65_536i128 {
        let (i, j) = (k % 256, k / 256);
        let (x, y) = ((1 << 52) + i, (1 << 52) + j);
        let exact = (whole(12) - x) * (whole(24) - y) - (whole(12) - y) * (whole(24) - x);
        let (px, py) = (0.5 + i as f64 * unit, 0.5 + j as f64 * unit);
        let naive = (12.0 - px) * (24.0 - py) - (12.0 - py) * (24.0 - px);
        let naive = naive.partial_cmp(&0.0).unwrap();
        if naive != exact.cmp(&0) {
            wrong += 1;
            counts[(naive as i8 + 1) as usize] += 1;
        }
    }
    assert!(wrong > 10_000, "{wrong}");
    let document = Document::parse(&svg).unwrap();
    assert_eq!(document.root_element().attribute("data-wrong"), Some(wrong.to_string().as_str()));
    for (class, count) in [("strong t3", counts[0]), ("strong t1", counts[1]), ("strong t0", counts[2])] {
        let areas = document.descendants().filter(|n| n.attribute("class") == Some(class));
        let rings = areas.into_iter().map(|n| drawn::path(n.attribute("d").unwrap())).max_by_key(Vec::len);
        let drawn: f64 = rings.unwrap_or_default().iter().map(|r| (r[1][0] - r[0][0]) * (r[0][1] - r[2][1])).sum();
        let cells = if count == 0 { 18.0 * 13.0 / 4.0 } else { f64::from(count) };
        assert!((drawn / 4.0 - cells).abs() < 0.5, "{class}: {} cells drawn of {cells}", drawn / 4.0);
    }
}
