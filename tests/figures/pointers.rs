//! Arrows of pointers: from where to where, clear of what, told apart by what.

use crate::cases;
use crate::cases::{P, h};
use crate::drawn;
use crate::drawn::{Drawn, length, minus, read};
use dcel_kit::figure::{FigureError, FigureOptions, Pointers, focus, pointers};
use dcel_kit::topology::{Table, View};
use std::collections::{BTreeMap, BTreeSet};

/// A drawn arrow: its line in small steps, the letters of its commands, its heads by their tips.
struct Arrow {
    letters: String,
    points: Vec<P>,
    tips: Vec<P>,
}

fn numbers(text: &str) -> Vec<f64> {
    let (mut out, mut at) = (Vec::new(), 0);
    while at < text.len() {
        match text.as_bytes()[at] {
            b' ' | b',' => at += 1,
            _ => out.push(drawn::scan(text.as_bytes(), &mut at)),
        }
    }
    out
}

fn commands(data: &str) -> Vec<(char, Vec<f64>)> {
    let starts: Vec<usize> = data.match_indices(|c: char| c.is_ascii_alphabetic()).map(|(i, _)| i).collect();
    let ends = starts.iter().skip(1).copied().chain([data.len()]);
    let command =
        |(start, end): (&usize, usize)| (data[*start..].chars().next().unwrap(), numbers(&data[start + 1..end]));
    starts.iter().zip(ends).map(command).collect()
}

/// Points of a clockwise arc (in the sense of SVG: sweep 1).
fn arc(a: P, b: P, radius: f64, large: bool) -> Vec<P> {
    let (d, middle) = (minus(b, a), [(a[0] + b[0]) / 2.0, (a[1] + b[1]) / 2.0]);
    let half = length(d) / 2.0;
    let height = (radius * radius - half * half).max(0.0).sqrt() * if large { -1.0 } else { 1.0 };
    let centre = [middle[0] - d[1] / (2.0 * half) * height, middle[1] + d[0] / (2.0 * half) * height];
    let angle = |p: P| (p[1] - centre[1]).atan2(p[0] - centre[0]);
    let (from, mut to) = (angle(a), angle(b));
    if to < from {
        to += std::f64::consts::TAU;
    }
    let at = |t: f64| [centre[0] + radius * t.cos(), centre[1] + radius * t.sin()];
    (1..=32).map(|i| at(from + (to - from) * f64::from(i) / 32.0)).collect()
}

fn line(data: &str) -> (String, Vec<P>) {
    let (mut letters, mut points): (String, Vec<P>) = (String::new(), Vec::new());
    for (letter, mut n) in commands(data) {
        let at = points.last().copied().unwrap_or_default();
        if letter.is_ascii_lowercase() {
            let first = if letter == 'a' { 5 } else { 0 };
            n.iter_mut().skip(first).enumerate().for_each(|(i, x)| *x += at[i % 2]);
        }
        let letter = letter.to_ascii_uppercase();
        letters.push(letter);
        let step = |f: &dyn Fn(f64) -> P| (1..=16).map(|i| f(f64::from(i) / 16.0)).collect::<Vec<P>>();
        points.extend(match letter {
            'M' => vec![[n[0], n[1]]],
            'L' => step(&|t| [0, 1].map(|i| at[i] + (n[i] - at[i]) * t)),
            'Q' => {
                step(&|t| [0, 1].map(|i| at[i] * (1.0 - t) * (1.0 - t) + n[i] * 2.0 * t * (1.0 - t) + n[2 + i] * t * t))
            }
            'A' => arc(at, [n[5], n[6]], n[0], n[3] > 0.5),
            'C' => vec![[n[4], n[5]]],
            other => panic!("{other} in {data}"),
        });
    }
    (letters, points)
}

/// The arrows of a figure by their ids without the prefix.
fn arrows(svg: &str) -> BTreeMap<String, Arrow> {
    let document = roxmltree::Document::parse(svg).unwrap();
    let prefix = format!("{}-", document.root_element().attribute("id").unwrap());
    let mut out = BTreeMap::new();
    for group in document.descendants().filter(|n| n.attribute("class").is_some_and(|c| c.starts_with("ptr "))) {
        let path = |class: &str| {
            let found = group.children().find(|n| n.attribute("class") == Some(class)).unwrap();
            found.attribute("d").unwrap().to_owned()
        };
        let (letters, points) = line(&path("pl"));
        let tips = drawn::path(&path("ph")).iter().map(|head| head[0]).collect();
        let id = group.attribute("id").unwrap().strip_prefix(&prefix).unwrap().to_owned();
        assert!(out.insert(id.clone(), Arrow { letters, points, tips }).is_none(), "{id} twice");
    }
    out
}

fn figure(table: &Table, family: Pointers) -> (Drawn, BTreeMap<String, Arrow>) {
    let svg = pointers(table, &[family], &FigureOptions::new("p")).unwrap().to_svg();
    (read(&svg), arrows(&svg))
}

/// Those with room for half-edges.
fn hard_cases() -> Vec<(&'static str, Table)> {
    let wanted = ["cube", "lab", "stress", "dangling edge", "islands", "touching", "hub-12", "grid-4"];
    let out: Vec<_> = cases::all().into_iter().filter(|(name, _)| wanted.contains(name)).collect();
    assert_eq!(out.len(), wanted.len());
    out
}

#[test]
fn shafts_and_next_arrows_of_a_face_make_one_closed_loop() {
    let mut checked = 0;
    for (name, table) in hard_cases() {
        let (drawn, arrows) = figure(&table, Pointers::Next);
        for i in 0..table.half_edges.len() {
            let (from, next) = (h(i), View::next(&table, h(i)).unwrap());
            let arrow = &arrows[&format!("{from}-next")];
            let [tip, tail] = [drawn.arrows[&from.to_string()].barb[0], drawn.arrows[&next.to_string()].tail];
            let along = drawn.arrows[&from.to_string()].tail;
            let unit = length(minus(tip, along));
            // The barb's tip is one px beside the line of the shaft.
            assert!(
                length(minus(arrow.points[0], tip)) < 1.1,
                "{name}: the arrow of {from} starts off its tip ({unit})"
            );
            assert!(length(minus(arrow.tips[0], tail)) < 0.02, "{name}: the arrow of {from} misses the tail of {next}");
            assert_eq!(arrow.tips.len(), 1);
            checked += 1;
        }
    }
    assert!(checked > 200, "{checked}");
}

#[test]
fn no_next_arrow_touches_a_disc() {
    for (name, table) in hard_cases() {
        let (drawn, arrows) = figure(&table, Pointers::Next);
        for (id, arrow) in &arrows {
            let own: dcel_kit::HalfEdgeId = id.strip_suffix("-next").unwrap().parse().unwrap();
            let end = View::origin(&table, View::next(&table, own).unwrap()).unwrap().to_string();
            for (v, &(centre, radius)) in &drawn.discs {
                let nearest = arrow.points.iter().map(|&p| length(minus(p, centre))).fold(f64::INFINITY, f64::min);
                // 4 px and half the line; short edges have small discs and less room.
                let clear = if *v == end && radius > 8.0 { 3.9 } else { 0.9 };
                assert!(nearest > radius + clear, "{name}: {id} passes {v} at {} px", nearest - radius);
            }
        }
    }
}

#[test]
fn wide_corners_are_gone_round_and_narrow_ones_rounded_off() {
    let table = cases::antenna();
    let (_, arrows) = figure(&table, Pointers::Next);
    let mut dangling = 0;
    for i in 0..table.half_edges.len() {
        let letters = arrows[&format!("{}-next", h(i))].letters.as_str();
        if View::next(&table, h(i)) == View::twin(&table, h(i)) {
            assert_eq!(letters, "MQAQ", "h{i} turns round at a dangling end");
            dangling += 1;
        }
    }
    assert!(dangling > 0);
    let (_, arrows) = figure(&cases::cube(), Pointers::Next);
    let count = |letters: &str| arrows.values().filter(|arrow| arrow.letters == letters).count();
    // Only the four corners of the outer face are wide.
    assert_eq!((count("MQ"), count("MQAQ")), (20, 4));
}

#[test]
fn arrows_begin_and_end_where_the_pointer_says() {
    for (name, table) in hard_cases() {
        let near = |p: P, a: P, b: P| {
            let (d, e) = (minus(b, a), minus(p, a));
            let t = ((d[0] * e[0] + d[1] * e[1]) / (d[0] * d[0] + d[1] * d[1])).clamp(0.0, 1.0);
            length(minus(p, [a[0] + d[0] * t, a[1] + d[1] * t]))
        };
        let (drawn, twins) = figure(&table, Pointers::Twin);
        let shaft = |id: &str| (drawn.arrows[id].tail, drawn.arrows[id].barb[0]);
        assert_eq!(twins.len(), table.half_edges.len() / 2, "{name}");
        for (id, arrow) in &twins {
            let own = id.strip_suffix("-twin").unwrap();
            let twin = &drawn.data[own]["data-twin"];
            let on = |id: &str, p: P| near(p, shaft(id).0, shaft(id).1) < 1.6;
            assert_eq!(arrow.tips.len(), 2, "{name} {id}");
            assert!(on(twin, arrow.tips[0]) && on(own, arrow.tips[1]), "{name}: {id} does not join the two shafts");
        }
        let (drawn, outs) = figure(&table, Pointers::Outgoing);
        for (id, arrow) in &outs {
            let own = id.strip_suffix("-outgoing").unwrap();
            let target = &drawn.data[own]["data-he"];
            let (tail, tip) = (drawn.arrows[target].tail, drawn.arrows[target].barb[0]);
            let (d, e) = (minus(tip, tail), minus(arrow.tips[0], tail));
            let part = (d[0] * e[0] + d[1] * e[1]) / (d[0] * d[0] + d[1] * d[1]);
            assert!(near(arrow.tips[0], tail, tip) < 1.6 && part < 0.4, "{name}: {id} ends at {part} of {target}");
            let (centre, radius) = drawn.discs[own];
            assert!(
                (length(minus(arrow.points[0], centre)) - radius - 1.0).abs() < 0.1,
                "{name}: {id} starts elsewhere"
            );
        }
        let (drawn, known) = figure(&table, Pointers::Boundary);
        for (id, arrow) in &known {
            let target = &drawn.data[id.strip_suffix("-boundary").unwrap()]["data-he"];
            let (tail, tip) = (drawn.arrows[target].tail, drawn.arrows[target].barb[0]);
            assert!(near(arrow.tips[0], tail, tip) < 3.5, "{name}: {id} does not end at {target}");
        }
    }
}

#[test]
fn families_differ_in_class_and_in_shape() {
    let table = cases::cube();
    let mut seen = BTreeSet::new();
    for family in Pointers::ALL {
        let svg = pointers(&table, &[family], &FigureOptions::new("p")).unwrap().to_svg();
        let arrows = arrows(&svg);
        let dashed = svg.contains(&format!(".{} .pl{{stroke-dasharray", family.class()));
        let shaft = read(&svg).arrows;
        let first = arrows.values().next().unwrap();
        let from_shaft = shaft.values().any(|a| length(minus(a.barb[0], first.points[0])) < 2.0);
        let towards_shaft = shaft.values().any(|a| {
            let (d, e) = (minus(a.barb[0], a.tail), minus(first.tips[0], a.tail));
            (d[0] * e[1] - d[1] * e[0]).abs() / length(d) < 4.0
        });
        let kind = (first.letters.contains('Q'), first.tips.len(), dashed, from_shaft, towards_shaft);
        assert!(seen.insert(kind), "{family:?} looks like another family: {kind:?}");
        assert!(arrows.keys().all(|id| id.ends_with(&format!("-{}", family.class()))));
    }
}

#[test]
fn every_pointer_is_drawn_or_noted() {
    for (name, table) in hard_cases() {
        let count = [table.half_edges.len(), table.half_edges.len() / 2];
        let outgoing = table.vertices.iter().flatten().filter(|row| row.outgoing.is_some()).count();
        let boundary = table.faces.iter().flatten().filter(|row| row.half_edge.is_some()).count();
        let wanted = [count[0], count[1], outgoing, boundary, count[0]];
        for (family, wanted) in Pointers::ALL.into_iter().zip(wanted) {
            let figure = pointers(&table, &[family], &FigureOptions::new("p")).unwrap();
            let drawn = arrows(&figure.to_svg()).len();
            let note = figure.notes().iter().find(|note| note.starts_with("without room for an arrow"));
            let more =
                note.and_then(|n| n.split(" and ").nth(1)).map_or(0, |n| n.split(' ').next().unwrap().parse().unwrap());
            let noted = note.map_or(0, |note| note.matches('.').count()) + more;
            assert_eq!(drawn + noted, wanted, "{name} {family:?}: {note:?}");
            if matches!(family, Pointers::Next | Pointers::Twin | Pointers::Outgoing) || ["cube"].contains(&name) {
                assert_eq!(noted, 0, "{name} {family:?}: {note:?}");
            }
        }
    }
}

#[test]
fn names_cover_neither_names_nor_arrows() {
    let mut checked = 0;
    for (name, table) in hard_cases() {
        for family in Pointers::ALL {
            let (drawn, arrows) = figure(&table, family);
            let words: Vec<_> =
                drawn.words.iter().filter(|word| !["ct", "cs"].contains(&word.class.as_str())).collect();
            for (i, word) in words.iter().enumerate() {
                for other in &words[i + 1..] {
                    assert!(!word.overlaps(other), "{name} {family:?}: {word:?} overlaps {other:?}");
                }
                for (id, arrow) in &arrows {
                    for &p in arrow.points.iter().chain(&arrow.tips) {
                        assert!(word.distance(p) > 0.3, "{name} {family:?}: {word:?} is crossed by {id}");
                        checked += 1;
                    }
                }
            }
        }
    }
    assert!(checked > 100_000, "{checked}");
}

#[test]
fn panels_share_one_layout_and_no_id() {
    let table = cases::lab();
    let svg = pointers(&table, &Pointers::ALL, &FigureOptions::new("Lab")).unwrap().to_svg();
    let document = roxmltree::Document::parse(&svg).unwrap();
    let mut ids = BTreeSet::new();
    for id in document.descendants().filter_map(|n| n.attribute("id")) {
        assert!(ids.insert(id), "{id} twice");
    }
    let mut shapes = BTreeSet::new();
    for family in Pointers::ALL {
        let class = family.class();
        let panel = document.descendants().find(|n| n.attribute("id") == Some(&format!("lab-{class}"))).unwrap();
        let mut inside = panel.descendants().filter_map(|n| n.attribute("id")).skip(1);
        assert!(inside.all(|id| id.starts_with(&format!("lab-{class}-"))), "{class}");
        let elements = panel.descendants().filter(|n| {
            let class = n.attribute("class").unwrap_or_default();
            ["sh", "barb", "vd", "hl", "vl", "fl", "edge"].contains(&class)
        });
        let drawing: Vec<String> = elements
            .map(|n| n.attributes().map(|a| format!("{}={}", a.name(), a.value())).collect::<Vec<_>>().join(" "))
            .collect();
        assert!(drawing.len() > 60, "{class}");
        shapes.insert(drawing);
    }
    assert_eq!(shapes.len(), 1, "panels differ in layout");
}

#[test]
fn crowded_and_broken_structures_are_drawn_without_panic_and_always_alike() {
    let mut broken = cases::cube();
    broken.half_edges[3].as_mut().unwrap().next = Some(h(20));
    broken.half_edges[4].as_mut().unwrap().twin = Some(h(9));
    broken.half_edges[5].as_mut().unwrap().face = None;
    broken.half_edges[6] = None;
    broken.vertices[2].as_mut().unwrap().position = None;
    let crowded =
        cases::all().into_iter().filter(|(name, _)| ["hub-200", "slivers", "tall", "tiny", "far"].contains(name));
    for (name, table) in crowded.chain([("broken", broken)]) {
        let draw = || match pointers(&table, &Pointers::ALL, &FigureOptions::new(name)) {
            Ok(figure) => figure.to_svg(),
            Err(FigureError::NoRoom { detail }) => format!("{detail:?}"),
            Err(error) => panic!("{name}: {error}"),
        };
        let (svg, again) = std::thread::scope(|scope| {
            let again = scope.spawn(draw);
            (draw(), again.join().unwrap())
        });
        assert_eq!(svg, again, "{name}");
        assert!(!svg.contains("NaN") && !svg.contains("inf"), "{name}");
        for i in [0, 3, 4, 5] {
            let figure = focus(&table, h(i), &FigureOptions::new(name));
            assert!(matches!(figure, Ok(_) | Err(FigureError::NoRoom { .. })), "{name} h{i}");
        }
    }
}

#[test]
fn the_focus_figure_names_the_five_pointers_and_their_values() {
    let table = cases::cube();
    for i in 0..table.half_edges.len() {
        let figure = focus(&table, h(i), &FigureOptions::new("f")).unwrap();
        let drawn = read(&figure.to_svg());
        let row = table.half_edges[i].unwrap();
        let texts: Vec<&str> = drawn.words.iter().map(|word| word.text.as_str()).collect();
        for name in ["h", "h.prev", "h.next", "h.twin", "h.face", "h.origin"] {
            let count = texts.iter().filter(|text| **text == name).count();
            let beside = usize::from(name != "h");
            assert_eq!(count, 1 + beside, "h{i}: {name} in {texts:?}");
        }
        for (key, value) in [
            ("h.origin", row.origin.unwrap().to_string()),
            ("h.twin", row.twin.unwrap().to_string()),
            ("h.next", row.next.unwrap().to_string()),
            ("h.prev", row.prev.unwrap().to_string()),
            ("h.face", row.face.unwrap().to_string()),
        ] {
            let at = texts.iter().rposition(|text| *text == key).unwrap();
            assert_eq!(texts[at + 1], value, "h{i}: {key}");
        }
        let words: Vec<_> = drawn.words.iter().filter(|word| word.at[0] < drawn.size[0] - 324.0).collect();
        for (k, word) in words.iter().enumerate() {
            assert!(words[k + 1..].iter().all(|other| !word.overlaps(other)), "h{i}: {word:?} overlaps another name");
        }
    }
    let error = focus(&table, h(99), &FigureOptions::new("f")).unwrap_err();
    assert_eq!(error.to_string(), "there is no h99: there are 24 half-edges");
}
