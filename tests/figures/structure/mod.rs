//! What a figure shows is what the structure says: read back from the SVG text.

mod broken;
mod conventions;
mod states;

use crate::cases;
use crate::cases::{P, h};
use crate::drawn;
use crate::drawn::{Drawn, inside, left_of, length, minus, read};
use dcel_kit::figure::{Detail, FigureOptions, structure};
use dcel_kit::topology::{Table, View};
use dcel_kit::{FaceId, HalfEdgeId, Id, VertexId};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::OnceLock;

fn draw(name: &str, table: &Table) -> String {
    structure(table, &FigureOptions::new(name)).unwrap().to_svg()
}

/// The small cases, long names in faces, the map of the states and a large grid.
fn gallery() -> Vec<(String, Table, FigureOptions)> {
    let mut out: Vec<_> =
        cases::all().into_iter().map(|(name, table)| (name.to_owned(), table, FigureOptions::new(name))).collect();
    let named = FigureOptions::new("names")
        .face_name(FaceId::new(0), "street")
        .face_name(FaceId::new(1), "the surrounding courtyard")
        .face_name(FaceId::new(2), "inner ring")
        .face_name(FaceId::new(4), "the house of the neighbour");
    out.push(("names".to_owned(), cases::islands(), named));
    let (table, names) = states::load();
    out.push(("states".to_owned(), table, FigureOptions::new("states").width(960.0).face_names(names)));
    for n in [12, 14, 16] {
        let name = format!("grid-{n} in 1600 px");
        out.push((name.clone(), cases::grid(n, true), FigureOptions::new(&name).width(1600.0)));
    }
    out.push(("grid-100".to_owned(), cases::grid(100, true), FigureOptions::new("grid-100")));
    out
}

/// What the figures of the gallery show: drawn once for all who look at them.
fn pictures() -> &'static [(String, Table, Drawn)] {
    static PICTURES: OnceLock<Vec<(String, Table, Drawn)>> = OnceLock::new();
    let read_back = |(name, table, options): (String, Table, FigureOptions)| {
        let drawn = read(&structure(&table, &options).unwrap().to_svg());
        (name, table, drawn)
    };
    PICTURES.get_or_init(|| gallery().into_iter().map(read_back).collect())
}

fn half_edges(table: &Table) -> impl Iterator<Item = HalfEdgeId> {
    (0..table.half_edges.len()).map(h)
}

/// The middle of the discs of the two ends of a half-edge.
fn ends(table: &Table, drawn: &Drawn, h: HalfEdgeId) -> (P, P) {
    let row = table.half_edges[h.index()].unwrap();
    let end = View::origin(table, row.twin.unwrap()).unwrap();
    let disc = |v: VertexId| drawn.discs[&v.to_string()].0;
    (disc(row.origin.unwrap()), disc(end))
}

#[test]
fn data_attributes_say_what_the_structure_says() {
    for (name, table, drawn) in pictures() {
        let get = |id: &str, key: &str| drawn.data.get(id).and_then(|data| data.get(key)).map(String::as_str);
        fn text<I: Id>(id: Option<I>) -> Option<String> {
            id.map(|id| id.to_string())
        }
        if drawn.data.keys().any(|id| id.starts_with('h')) {
            for (i, row) in table.half_edges.iter().enumerate() {
                let (id, row) = (h(i).to_string(), row.unwrap());
                assert_eq!(get(&id, "data-origin"), text(row.origin).as_deref(), "{name} {id}");
                assert_eq!(get(&id, "data-twin"), text(row.twin).as_deref(), "{name} {id}");
                assert_eq!(get(&id, "data-next"), text(row.next).as_deref(), "{name} {id}");
                assert_eq!(get(&id, "data-prev"), text(row.prev).as_deref(), "{name} {id}");
                assert_eq!(get(&id, "data-face"), text(row.face).as_deref(), "{name} {id}");
                for key in ["data-origin", "data-twin", "data-next", "data-prev", "data-face"] {
                    assert!(drawn.data.contains_key(get(&id, key).unwrap()), "{name} {id}: {key} is not in the figure");
                }
            }
        }
        if !drawn.discs.is_empty() {
            for (i, row) in table.vertices.iter().enumerate() {
                let (id, row) = (VertexId::new(i as u32).to_string(), row.unwrap());
                let [x, y] = row.position.unwrap();
                let number = |key| get(&id, key).unwrap().parse::<f64>().unwrap();
                assert_eq!(
                    (number("data-x").to_bits(), number("data-y").to_bits()),
                    (x.to_bits(), y.to_bits()),
                    "{name} {id}"
                );
                assert_eq!(get(&id, "data-he"), text(row.outgoing).as_deref(), "{name} {id}");
            }
        }
        if name != "grid-100" {
            for (i, row) in table.faces.iter().enumerate() {
                let (id, row) = (FaceId::new(i as u32).to_string(), row.as_ref().unwrap());
                assert_eq!(get(&id, "data-he"), text(row.half_edge).as_deref(), "{name} {id}");
                let rings = get(&id, "data-rings").map_or(0, |rings| rings.split(' ').count());
                assert_eq!(rings, row.inner_components.len(), "{name} {id}");
                assert_eq!(get(&id, "data-outer"), (i == 0).then_some("true"), "{name} {id}");
                assert_eq!(get(&id, "data-hole"), row.hole.then_some("true"), "{name} {id}");
            }
        }
    }
}

#[test]
fn points_are_drawn_to_scale_with_y_up() {
    for (name, table, options) in gallery() {
        let svg = structure(&table, &options).unwrap().to_svg();
        let drawn = read(&svg);
        let document = roxmltree::Document::parse(&svg).unwrap();
        let scale: f64 = document.root_element().attribute("data-scale").unwrap().parse().unwrap();
        let placed = |i: usize| {
            let disc = drawn.discs.get(&VertexId::new(i as u32).to_string())?.0;
            Some((table.vertices[i].unwrap().position.unwrap(), disc))
        };
        let Some((p, a)) = table.vertices.first().and_then(|_| placed(0)) else { continue };
        for i in 1..table.vertices.len() {
            let (q, b) = placed(i).unwrap();
            let expected = [(q[0] - p[0]) * scale, -(q[1] - p[1]) * scale];
            assert!(length(minus(minus(b, a), expected)) < 0.03, "{name}: v{i}");
            assert!(
                b[0] > 3.0 && b[1] > 3.0 && b[0] < drawn.size[0] - 3.0 && b[1] < drawn.size[1] - 3.0,
                "{name}: v{i}"
            );
        }
    }
}

#[test]
fn arrows_run_on_the_left_and_their_barbs_point_to_the_face() {
    let mut arrows = 0;
    for (name, table, drawn) in pictures() {
        for (id, arrow) in &drawn.arrows {
            let (a, b) = ends(table, drawn, id.parse().unwrap());
            if length(minus(b, a)) < 2.0 {
                continue; // 2 decimals do not tell the sides of an edge of one px
            }
            let along = |p: P| {
                let (d, e) = (minus(b, a), minus(p, a));
                (d[0] * e[0] + d[1] * e[1]) / length(d)
            };
            let [tip, corner, notch] = arrow.barb;
            let aside = left_of(a, b, arrow.tail);
            assert!(aside > 0.1, "{name} {id}: {aside} px to the left");
            assert!((left_of(a, b, arrow.head) - aside).abs() < 0.03, "{name} {id} is not parallel");
            assert!(along(arrow.tail) < along(arrow.head) && along(arrow.head) < along(tip), "{name} {id}");
            assert!(along(arrow.tail) > 0.0 && along(tip) < length(minus(b, a)), "{name} {id} is longer than its edge");
            assert!(left_of(a, b, corner) > aside + 1.0, "{name} {id}: the barb is on the wrong side");
            assert!(along(corner) < along(notch) && along(notch) < along(tip), "{name} {id}");
            arrows += 1;
        }
    }
    assert!(arrows > 1500, "{arrows}");
}

#[test]
fn shafts_lie_in_their_faces_even_in_sharp_corners() {
    for (name, table, drawn) in pictures() {
        if name == "flat" || name == "tall" {
            continue; // faces thinner than a line
        }
        for (id, arrow) in &drawn.arrows {
            let (a, b) = ends(table, drawn, id.parse().unwrap());
            let face = &drawn.data[id]["data-face"];
            let area = &drawn.areas[face][0].1;
            for p in [arrow.tail, arrow.head] {
                assert!(length(minus(b, a)) < 2.0 || inside(area, p), "{name}: {id} leaves {face}");
            }
        }
    }
}

#[test]
fn a_tip_never_touches_the_next_tail_or_a_disc() {
    for (name, table, drawn) in pictures() {
        if ["slivers", "hub-200", "tall"].contains(&name.as_str()) {
            continue; // corners with less room than two lines are wide
        }
        for (id, arrow) in &drawn.arrows {
            let row = table.half_edges[id.parse::<HalfEdgeId>().unwrap().index()].unwrap();
            let next = &drawn.arrows[&row.next.unwrap().to_string()];
            let (a, b) = ends(table, drawn, id.parse().unwrap());
            let gap = length(minus(arrow.barb[0], next.tail));
            let long = length(minus(b, a)) > 40.0;
            assert!(gap > if long { 6.0 } else { 1.5 }, "{name}: {id} ends {gap} px before {}", row.next.unwrap());
            for (v, &(centre, radius)) in &drawn.discs {
                for p in [arrow.tail, arrow.barb[0]] {
                    let gap = length(minus(p, centre)) - radius;
                    assert!(!long || gap > 2.0, "{name}: {id} is {gap} px from {v}");
                }
            }
        }
    }
}

#[test]
fn no_disc_hides_another_vertex_or_a_foreign_edge() {
    for (name, _, drawn) in pictures() {
        let discs: Vec<(P, f64)> = drawn.discs.values().copied().collect();
        for (i, &(p, r)) in discs.iter().enumerate() {
            for &(q, s) in &discs[i + 1..] {
                let distance = length(minus(q, p));
                assert!(distance < 5.0 || distance > r + s, "{name}: discs at {p:?} and {q:?} overlap");
            }
            for &(a, b) in drawn.edges.iter().filter(|&&(a, b)| length(minus(a, p)) > 0.0 && length(minus(b, p)) > 0.0)
            {
                let (d, e) = (minus(b, a), minus(p, a));
                let t = ((d[0] * e[0] + d[1] * e[1]) / (d[0] * d[0] + d[1] * d[1])).clamp(0.0, 1.0);
                let distance = length(minus(p, [a[0] + d[0] * t, a[1] + d[1] * t]));
                assert!(distance < 4.0 || distance > r, "{name}: the disc at {p:?} covers an edge");
            }
        }
    }
}

#[test]
fn words_cover_neither_words_nor_discs_nor_shafts() {
    let mut checked = 0;
    for (name, _, drawn) in pictures() {
        for (i, word) in drawn.words.iter().enumerate() {
            for other in &drawn.words[i + 1..] {
                assert!(!word.overlaps(other), "{name}: {word:?} covers {other:?}");
            }
            let half = word.half();
            let on_canvas = (0..2).all(|i| (half[i] + 2.0..drawn.size[i] - half[i] - 2.0).contains(&word.at[i]));
            assert!(on_canvas, "{name}: {word:?} leaves the canvas");
            for (v, &(centre, radius)) in &drawn.discs {
                if *v == word.owner && length(minus(centre, word.at)) <= 0.0 {
                    assert!(half[0] < radius, "{name}: {word:?} is wider than its disc");
                } else {
                    assert!(word.distance(centre) > radius, "{name}: {word:?} covers {v}");
                }
            }
            for (id, arrow) in &drawn.arrows {
                let (tail, tip) = (arrow.tail, arrow.barb[0]);
                // Beyond a side of the box with all its points, as nearly every shaft of a large figure is.
                let beyond = |i: usize| {
                    let (low, high) = (tail[i].min(tip[i]) - word.at[i], tail[i].max(tip[i]) - word.at[i]);
                    low > half[i] + 0.9 || high < -half[i] - 0.9
                };
                if beyond(0) || beyond(1) {
                    continue;
                }
                for k in 0..=40 {
                    let t = f64::from(k) / 40.0;
                    let p = [0, 1].map(|i| tail[i] + (tip[i] - tail[i]) * t);
                    assert!(word.distance(p) > 0.9, "{name}: {word:?} covers {id}");
                }
            }
            checked += 1;
        }
    }
    assert!(checked > 3000, "{checked}");
}

/// Labels must not be avoided by leaving them out.
#[test]
fn where_there_is_room_everything_is_named() {
    for (name, table, drawn) in pictures() {
        let count = |class: &str| drawn.words.iter().filter(|word| word.class == class).count();
        if ["cube", "lab", "touching", "dangling edge", "grid-4", "hub-12", "grid-12 in 1600 px"]
            .contains(&name.as_str())
        {
            assert_eq!(count("hl"), table.half_edges.len(), "{name}");
            assert_eq!(count("vl"), table.vertices.len(), "{name}");
            assert_eq!(count("fl"), table.faces.len(), "{name}");
        }
        if name == "stress" {
            assert_eq!((count("hl"), count("vl"), count("fl")), (24, 17, 3), "{name}");
        }
        if name == "states" {
            assert_eq!(count("fl") + count("ll"), 49, "all but those who share the room of another");
            assert!(count("fl") >= 38, "{}", count("fl"));
        }
    }
}

#[test]
fn face_labels_stand_in_their_own_face() {
    let mut labels = 0;
    for (name, _, drawn) in pictures() {
        for word in drawn.words.iter().filter(|word| word.class == "fl" && word.owner != "f0") {
            let half = word.half();
            let areas = &drawn.areas[&word.owner];
            for (dx, dy) in [(0.0, 0.0), (-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)] {
                let p = [word.at[0] + dx * half[0], word.at[1] + dy * half[1]];
                assert!(inside(&areas[0].1, p), "{name}: {word:?} leaves its face");
            }
            labels += 1;
        }
    }
    assert!(labels > 900, "{labels}");
}

#[test]
fn in_a_trapezoid_the_label_stands_on_the_axis() {
    let drawn = read(&draw("cube", &cases::cube()));
    let at = |text: &str| drawn.words.iter().find(|word| word.text == text).unwrap().at;
    let middle = drawn.size[0] / 2.0;
    for (face, axis) in [("f1", 0), ("f3", 0), ("f2", 1), ("f4", 1), ("f5", 0), ("f5", 1)] {
        assert!((at(face)[axis] - middle).abs() < 2.0, "{face} at {:?}", at(face));
    }
}

#[test]
fn faces_cover_the_canvas_once() {
    for name in ["islands", "stress", "touching", "dangling edge", "lab"] {
        let (_, table) = cases::all().into_iter().find(|(n, _)| *n == name).unwrap();
        let drawn = read(&draw(name, &table));
        for i in 0..400 {
            let p = [
                5.0 + f64::from(i % 20) * (drawn.size[0] - 10.0) / 19.3,
                5.0 + f64::from(i / 20) * (drawn.size[1] - 10.0) / 19.7,
            ];
            let mut faces: Vec<&String> =
                drawn.areas.iter().filter(|(_, areas)| inside(&areas[0].1, p)).map(|(face, _)| face).collect();
            faces.dedup();
            assert_eq!(faces.len(), 1, "{name}: {p:?} lies in {faces:?}");
        }
    }
}

#[test]
fn neighbours_have_different_tints_and_countries_have_one() {
    let mut borders = 0;
    for (name, table, drawn) in pictures() {
        let tint =
            |f: FaceId| drawn.areas.get(&f.to_string()).and_then(|a| a[0].0.strip_prefix("face ").map(str::to_owned));
        let country = |f: FaceId| drawn.data.get(&f.to_string()).and_then(|data| data.get("data-name").cloned());
        for h in half_edges(table) {
            let faces = [h, View::twin(table, h).unwrap()].map(|h| View::face(table, h).unwrap());
            if let [Some(a), Some(b)] = faces.map(tint)
                && faces[0] != faces[1]
            {
                assert_ne!(a, b, "{name}: {faces:?}");
                borders += 1;
            }
        }
        let mut by_name = BTreeMap::new();
        for f in (0..table.faces.len()).map(|i| FaceId::new(i as u32)) {
            if let (Some(name), Some(tint)) = (country(f), tint(f)) {
                assert_eq!(by_name.entry(name).or_insert_with(|| tint.clone()), &tint, "{f}");
            }
        }
    }
    assert!(borders > 3000, "{borders}");
}

#[test]
fn a_country_is_named_once_in_its_largest_part() {
    let (table, names) = states::load();
    let svg = structure(&table, &FigureOptions::new("states").width(960.0).face_names(names.clone())).unwrap().to_svg();
    let drawn = read(&svg);
    let names: BTreeMap<String, String> = names.into_iter().map(|(face, name)| (face.to_string(), name)).collect();
    let mut owners = BTreeMap::new();
    for word in drawn.words.iter().filter(|word| word.owner != "f0") {
        let name = &names[&word.owner];
        assert!(name.split(' ').any(|part| word.text.contains(part)), "{word:?} in {name}");
        assert_eq!(
            owners.entry(name.clone()).or_insert_with(|| word.owner.clone()),
            &word.owner,
            "{name} is named twice"
        );
    }
    let area = |face: &str| {
        let rings = &drawn.areas[face][0].1;
        let doubled = |r: &Vec<P>| {
            (0..r.len()).map(|i| (r[i], r[(i + 1) % r.len()])).map(|(a, b)| a[0] * b[1] - b[0] * a[1]).sum::<f64>()
        };
        rings.iter().map(doubled).sum::<f64>().abs()
    };
    for (name, owner) in &owners {
        let parts = names.iter().filter(|(_, n)| *n == name).map(|(face, _)| area(face));
        assert!(parts.fold(0.0, f64::max) <= area(owner) + 1e-6, "{name}: {owner} is not the largest part");
    }
}

#[test]
fn hole_faces_are_hatched_untinted_and_say_so() {
    let table = cases::islands();
    let svg = draw("islands", &table);
    let drawn = read(&svg);
    let hole = (0..table.faces.len()).find(|&i| table.faces[i].as_ref().unwrap().hole).unwrap();
    let id = format!("f{hole}");
    let classes: Vec<&str> = drawn.areas[&id].iter().map(|(class, _)| class.as_str()).collect();
    assert_eq!(classes, ["bg", "hatched"]);
    assert!(drawn.titles[&id].contains("hole"), "{}", drawn.titles[&id]);
    assert!(!drawn.titles["f1"].contains("hole"), "{}", drawn.titles["f1"]);
    let group = &svg[svg.find("islands-f3").unwrap()..];
    assert!(group[..group.find("</g>").unwrap()].contains("url(#islands-hole-hatch)"));
}

#[test]
fn detail_falls_with_the_length_of_the_edges() {
    let level = |table: &Table| structure(table, &FigureOptions::default()).unwrap().detail();
    assert_eq!(level(&cases::cube()), Detail::Full);
    assert_eq!(level(&cases::grid(10, true)), Detail::Arrows);
    assert_eq!(level(&cases::grid(25, false)), Detail::Edges);
    assert_eq!(level(&cases::grid(100, false)), Detail::Tiles);
    let words =
        |table: &Table, class: &str| read(&draw("x", table)).words.iter().filter(|word| word.class == class).count();
    assert_eq!(words(&cases::grid(10, true), "hl"), 0, "no half-edge labels at 57 px");
    let edges = read(&draw("x", &cases::grid(25, false)));
    assert!(edges.arrows.is_empty() && edges.edges.len() == 1200 && edges.discs.len() == 625);
    let forced = structure(&cases::cube(), &FigureOptions::default().detail(Detail::Tiles)).unwrap().to_svg();
    assert_eq!(read(&forced).edges.len(), 12);
}

#[test]
fn every_edge_is_in_the_tiles_once_and_a_large_mesh_stays_small() {
    let table = cases::grid(225, false);
    let svg = draw("mesh", &table);
    assert_eq!(table.half_edges.len(), 2 * 100_800);
    assert!(svg.len() < 2_000_000, "{} bytes", svg.len());
    let drawn = read(&svg);
    let grid = |p: P| [(p[0] * 10.0).round() as i64, (p[1] * 10.0).round() as i64];
    let mut lines = BTreeSet::new();
    for &(a, b) in &drawn.edges {
        let (a, b) = (grid(a), grid(b));
        assert!(lines.insert((a.min(b), a.max(b))), "{a:?} {b:?} is drawn twice");
    }
    assert_eq!(lines.len(), 100_800);
    let points: BTreeSet<_> = lines.iter().flat_map(|&(a, b)| [a, b]).collect();
    assert_eq!(points.len(), 225 * 225);
}

#[test]
fn tiles_show_lone_vertices_and_islands_smaller_than_a_pixel_do_no_harm() {
    let mut table = cases::grid(100, false);
    let row = dcel_kit::topology::VertexRow { position: Some([-3.0, -3.0]), outgoing: None };
    table.vertices.push(Some(row));
    let svg = draw("lone", &table);
    let dots = svg.split("class=\"dots\" d=\"").nth(1).unwrap();
    assert_eq!(drawn::path(&dots[..dots.find('"').unwrap()]).len(), 1);
}

#[test]
fn extreme_coordinates_fill_a_canvas_of_ordinary_size() {
    for (name, table, options) in gallery() {
        let (w, h) = structure(&table, &options).unwrap().size();
        assert!((100.0..=1600.0).contains(&w) && (100.0..=1600.0).contains(&h), "{name}: {w} x {h}");
    }
    for (name, table) in cases::all().into_iter().filter(|(name, _)| ["tiny", "huge", "far"].contains(name)) {
        let drawn = read(&draw(name, &table));
        let [a, b] = ["v0", "v1"].map(|v| drawn.discs[v].0);
        assert!(length(minus(b, a)) > 400.0, "{name}: {a:?} {b:?}");
    }
}
