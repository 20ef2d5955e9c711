//! The drawing vocabulary keeps its promises: what is cut ends on the frame, what is said stands where it can be
//! read, one layout serves all that is drawn together, and every colour that means something can be seen.

mod read;

mod contrast;
mod geometry;
mod many;
mod words;

use dcel_kit::figure::sketch::{Backdrop, Multiples, Role, Sketch, SketchError};
use dcel_kit::figure::{Detail, Figure, FigureOptions};
use dcel_kit::plane::Subdivision;
use read::{Drawing, number};
use std::collections::BTreeSet;
use std::path::Path;

/// One of everything.
fn everything() -> Sketch {
    let mut sketch = Sketch::new();
    let square = vec![[0.0, 0.0], [10.0, 0.0], [10.0, 8.0], [0.0, 8.0]];
    sketch.region(Role::Plain, [square, vec![[4.0, 4.0], [6.0, 4.0], [6.0, 6.0]]]).key("room");
    sketch.region(Role::Dimmed, [[[1.0, 6.0], [2.0, 6.0], [2.0, 7.0]]]).hatched().label("blocked");
    sketch.path(Role::Main, [[1.0, 1.0], [5.0, 3.0], [9.0, 7.0]]).arrow().key("path");
    sketch.path(Role::Secondary, [[1.0, 2.0], [3.0, 5.0]]).double_arrow().dashed();
    sketch.ray(Role::Secondary, [5.0, 3.0], [6.0, 3.5]).label("ray");
    sketch.line(Role::Goal, [0.0, 5.0], [1.0, 5.1]).solid().label("sweep");
    sketch.circle(Role::Right, [7.0, 2.0], 1.0).filled().label("clearance");
    sketch.circumcircle(Role::Wrong, [[0.0, 0.0], [10.0, 0.0], [6.0, 4.0]]);
    sketch.arc(Role::Event, [9.0, 1.0], [9.5, 1.0], [9.0, 2.0]);
    sketch.cone(Role::Start, [1.0, 1.0], [6.0, 4.0], [4.0, 4.0]).label("cone").key("what is seen");
    sketch.cone(Role::Event, [8.0, 7.0], [6.0, 6.0], [6.0, 4.0]).until([6.0, 6.0], [6.0, 4.0]);
    sketch.portal(Role::Secondary, [4.0, 4.0], [7.0, 1.0]).label("portal").key("portal");
    for (i, role) in Role::ALL.into_iter().enumerate() {
        sketch.point(role, [0.5 + i as f64, 0.5]).label(format!("{role:?}"));
    }
    sketch.text(Role::Plain, [8.0, 4.0], "words & <signs>");
    sketch.badge(Role::Wrong, [6.0, 4.0], "a corner that the path must not touch");
    sketch.badge(Role::Main, [1.0, 1.0], "the start");
    sketch
}

fn alone(sketch: &Sketch) -> String {
    sketch.figure(&FigureOptions::new("Test").width(900.0)).unwrap().to_svg()
}

/// Ids once, references to ids that exist, no number that is none.
fn is_sound(svg: &str, what: &str) {
    let document = roxmltree::Document::parse(svg).unwrap_or_else(|error| panic!("{what}: {error}"));
    let mut ids = BTreeSet::new();
    for id in document.descendants().filter_map(|node| node.attribute("id")) {
        assert!(ids.insert(id), "{what}: {id} twice");
    }
    for attribute in document.descendants().flat_map(|node| node.attributes()) {
        let value = attribute.value();
        if let Some(id) = value.strip_prefix("url(#").and_then(|rest| rest.strip_suffix(')')) {
            assert!(ids.contains(id), "{what}: {value} leads nowhere");
        }
        if attribute.name() == "aria-labelledby" {
            assert!(value.split(' ').all(|id| ids.contains(id)), "{what}: {value}");
        }
    }
    for attribute in document.descendants().flat_map(|node| node.attributes()) {
        let (name, value) = (attribute.name(), attribute.value());
        if ["x", "y", "cx", "cy", "r", "x1", "y1", "x2", "y2", "width", "height", "font-size"].contains(&name) {
            assert!(number(value).is_finite() && value != "-0", "{what}: {name} = {value}");
        } else if name == "d" {
            let wrong = value.find(|c: char| !c.is_ascii_digit() && !"MmLlHhQqCcAaZz,.- ".contains(c));
            assert_eq!(wrong, None, "{what}: {value}");
        }
    }
}

#[test]
fn every_drawing_is_sound_and_the_same_twice() {
    let sketch = everything();
    let lab = Subdivision::lab_rectangle();
    let options = FigureOptions::new("Test");
    let mut panels = Multiples::new();
    panels.sketch("a", "", sketch.clone()).structure("b", "", &lab).over(
        "c",
        "",
        &lab,
        Backdrop::Dimmed,
        sketch.clone(),
    );
    type Draw<'a> = &'a dyn Fn(&FigureOptions) -> Figure;
    let drawings: [(&str, Draw<'_>); 4] = [
        ("alone", &|options| sketch.figure(options).unwrap()),
        ("over", &|options| sketch.over(&lab, Backdrop::Dimmed, options).unwrap()),
        ("cropped", &|options| sketch.figure(&options.clone().crop([2.0, 2.0], [7.0, 6.0])).unwrap()),
        ("panels", &|options| panels.figure(options).unwrap()),
    ];
    for (name, draw) in drawings {
        let svg = draw(&options).to_svg();
        assert_eq!(svg, draw(&options).to_svg(), "{name}");
        is_sound(&svg, name);
        let plain = draw(&options.clone().plain(true)).to_svg();
        is_sound(&plain, name);
        assert!(!plain.contains("<style") && !plain.contains("class="), "{name}");
        assert!(plain.contains("stroke-dasharray=\"9 3\"") && plain.contains("fill=\"#0067a5\""), "{name}");
    }
}

#[test]
fn reference_figures_are_sound_and_small() {
    for file in ["vocabulary", "walk", "wrong-signs", "figure-sizes"] {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../figures/{file}.svg"));
        let svg = std::fs::read_to_string(path).unwrap();
        is_sound(&svg, file);
        assert!(svg.len() < 60_000, "{file}: {} bytes", svg.len());
    }
}

#[test]
fn roles_can_be_told_apart_without_colour() {
    let mut marks = BTreeSet::new();
    let mut lines = BTreeSet::new();
    for role in Role::ALL {
        assert!(marks.insert(role.glyph()), "{role:?} has the mark of another role");
        if let Some(dash) = role.dash() {
            assert!(lines.insert(dash), "{role:?} has the dash of another role");
        }
    }
    let svg = alone(&everything());
    let width = |class: &str| number(read::rule(&svg, &format!("#test .{class} .ln"), "stroke-width").unwrap());
    // The three solid ones differ in width, or are grey.
    assert!(width("r-main") > 1.5 * width("r-plain"));
}

#[test]
fn coordinates_that_are_no_numbers_are_refused_by_name() {
    let mut sketch = Sketch::new();
    sketch.point(Role::Main, [1.0, 2.0]);
    sketch.path(Role::Main, [[0.0, 0.0], [1.0, f64::NAN]]);
    let error = sketch.figure(&FigureOptions::new("x")).unwrap_err();
    assert!(matches!(&error, SketchError::Coordinate { item, .. } if item == "path-1"), "{error}");
    assert_eq!(error.to_string(), "path-1: y is NaN: coordinates must be finite numbers");
    let mut sketch = Sketch::new();
    sketch.circumcircle(Role::Main, [[0.0, 0.0], [1.0, f64::INFINITY], [2.0, 0.0]]);
    assert!(sketch.over(&Subdivision::lab_rectangle(), Backdrop::Plain, &FigureOptions::new("x")).is_err());
    let mut sketch = Sketch::new();
    sketch.circle(Role::Main, [0.0, 0.0], 1e70);
    assert!(sketch.figure(&FigureOptions::new("x")).is_err());
}

#[test]
fn what_cannot_be_seen_is_noted_and_nothing_panics() {
    assert!(Sketch::new().figure(&FigureOptions::new("empty")).unwrap().notes().is_empty());
    let mut sketch = Sketch::new();
    sketch.circumcircle(Role::Main, [[0.0, 0.0], [1.0, 1.0], [3.0, 3.0]]);
    sketch.path(Role::Main, [[1.0, 1.0], [1.0, 1.0]]);
    sketch.path::<[f64; 2]>(Role::Main, []);
    sketch.ray(Role::Main, [1.0, 1.0], [1.0, 1.0]);
    sketch.cone(Role::Main, [0.0, 0.0], [1.0, 1.0], [2.0, 2.0]);
    sketch.region(Role::Main, [[[0.0, 0.0], [1.0, 1.0]]]);
    sketch.portal(Role::Main, [2.0, 2.0], [2.0, 2.0]);
    let figure = sketch.figure(&FigureOptions::new("flat")).unwrap();
    let notes = figure.notes().join("\n");
    for name in ["circle-1", "path-1", "path-2", "ray-1", "cone-1", "region-1", "portal-1"] {
        assert!(notes.contains(name), "{name} in {notes}");
    }
    is_sound(&figure.to_svg(), "flat");
    let mut sketch = everything();
    sketch.point(Role::Main, [1e60, -1e60]);
    sketch.line(Role::Main, [1e-300, 0.0], [0.0, 1e-300]);
    is_sound(&alone(&sketch), "huge");
}

/// Written with the same decimals.
fn same(a: [f64; 2], b: [f64; 2]) -> bool {
    a.map(f64::to_bits) == b.map(f64::to_bits)
}

#[test]
fn a_sketch_and_the_structure_below_it_have_one_layout() {
    let lab = Subdivision::lab_rectangle();
    let mut sketch = Sketch::new();
    for v in lab.vertices() {
        sketch.point(Role::Main, lab.point(v));
    }
    // Further out than the structure: both must still fit.
    sketch.point(Role::Goal, [400.0, 300.0]);
    for detail in [Detail::Tiles, Detail::Edges, Detail::Full] {
        let svg = sketch.over(&lab, Backdrop::Dimmed, &FigureOptions::new("Test").detail(detail)).unwrap().to_svg();
        let drawn = Drawing::read(&svg);
        let inside = drawn.groups["s-point-7"].corners();
        assert!(inside.iter().all(|p| (0.0..=drawn.size[0]).contains(&p[0]) && (0.0..=drawn.size[1]).contains(&p[1])));
        if detail > Detail::Tiles {
            for v in 0..6 {
                let (vertex, point) = (&drawn.groups[&format!("v{v}")], &drawn.groups[&format!("s-point-{}", v + 1)]);
                assert!(same(vertex.discs[0].0, point.discs[0].0), "{detail:?} v{v}");
            }
        }
    }
}

#[test]
fn panels_have_one_layout_and_ids_of_their_own() {
    let lab = Subdivision::lab_rectangle();
    let mut mark = Sketch::new();
    mark.point(Role::Main, [0.0, 150.0]);
    let mut far = mark.clone();
    far.point(Role::Goal, [500.0, -400.0]);
    let mut panels = Multiples::new();
    panels.sketch("one", "", mark.clone()).over("two", "", &lab, Backdrop::Plain, far).structure("three", "", &lab);
    let svg = panels.columns(3).figure(&FigureOptions::new("Test")).unwrap().to_svg();
    is_sound(&svg, "panels");
    let drawn = Drawing::read(&svg);
    let (one, two) = (drawn.groups["p1-s-point-1"].discs[0].0, drawn.groups["p2-s-point-1"].discs[0].0);
    let vertices = ["p2-v4", "p3-v4"].map(|id| drawn.groups[id].discs[0].0);
    // Places on the sheet differ by the panels' places.
    let step = two[0] - one[0];
    assert!(step > 300.0 && (two[1] - one[1]).abs() < 0.011, "{one:?} {two:?}");
    assert!(same(vertices[0], two));
    assert!((vertices[1][0] - two[0] - step).abs() < 0.011 && (vertices[1][1] - two[1]).abs() < 0.011);
    assert!(drawn.groups.contains_key("p3-h0") && !drawn.groups.contains_key("h0"));
}
