//! Films tell the truth: frame by frame they are the journal, and the last frame is the structure.

use crate::drawn;
use dcel_kit::figure::{Fate, FigureError, FigureOptions, Film, Frame, Slip, SlipError};
use dcel_kit::ids::{Element, FaceId, HalfEdgeId, VertexId};
use dcel_kit::plane::{PlanarView, Subdivision};
use dcel_kit::script::{Outcome, Script};
use dcel_kit::topology::{Change, Slot, Table, View};
use std::collections::BTreeSet;
use std::ops::ControlFlow;

/// All edits, twice with reused ids; a bent edge that is joined, a face with a ring, an edge of the outer face.
const SCRIPTS: [&str; 6] = [
    "rectangle\nsplit_face h2 h8",
    "polygon 0 0 7 0 6 4 1 4.6\nlet c = split_in_half h2\njoin_edges h2",
    "rectangle\nlet a = split_face h2 h8\nlet c = split_edge a 20 10\njoin_edges a\njoin_faces a\nsplit_face h0 h6",
    "triangles 0 0 9 0 0 9 1 1 3 1 1 3 / 0 1 3 1 4 3 1 5 4 1 2 5 2 0 5 0 3 5\njoin_faces h2\nsplit_in_half h0",
    "polygon 0 0 9 0 9 9 8 1\nsplit_face h7 h3",
    // A court with an island in it is closed: the island's ring moves from f0 to the new face.
    "triangles 0 0 9 0 9 9 6 9 6 3 3 3 3 9 0 9 4 5 5 5 4.5 6 / 0 1 4 0 4 5 1 2 3 1 3 4 0 5 6 0 6 7 8 9 10\n\
     split_face h13 h19",
];

/// A film, and the structure after each edit with the changes that led to it.
fn shoot(text: &str) -> (Film, Vec<(Vec<Change>, Subdivision)>) {
    let script = Script::parse(text, "test").unwrap_or_else(|error| panic!("{error}"));
    let mut film = Film::new(script.start());
    let mut edits = Vec::new();
    script.play(|step, after| {
        let Outcome::Edited { edit, journal, .. } = step.outcome else { panic!("{text}: {}", step.outcome) };
        film.edit(&edit.to_string(), "", &[], &journal, after);
        edits.push((journal.changes().to_vec(), after.clone()));
        ControlFlow::Continue(())
    });
    (film, edits)
}

/// The frames of each edit, without the still before it.
fn steps(frames: &[Frame]) -> Vec<&[Frame]> {
    let stills: Vec<usize> = (0..frames.len()).filter(|&i| !frames[i].heading.starts_with(char::is_numeric)).collect();
    stills.windows(2).map(|pair| &frames[pair[0] + 1..pair[1]]).collect()
}

fn snapshot(structure: &Subdivision) -> Table {
    let mut table = Table::from_view(structure);
    for v in structure.vertices() {
        table.vertices[v.index()].as_mut().unwrap().position = structure.position(v).map(|p| [p.x, p.y]);
    }
    table
}

fn target(table: &Table, slot: Slot) -> Option<Element> {
    match slot {
        Slot::Origin(h) => table.origin(h).map(Element::from),
        Slot::Next(h) => table.next(h).map(Element::from),
        Slot::Prev(h) => table.prev(h).map(Element::from),
        Slot::Face(h) => table.face(h).map(Element::from),
        Slot::Outgoing(v) => table.outgoing(v).map(Element::from),
        Slot::HalfEdge(f) => table.half_edge(f).map(Element::from),
    }
}

#[test]
fn the_changes_of_all_frames_are_the_journal_and_lead_to_the_structure() {
    for text in SCRIPTS {
        let (film, edits) = shoot(text);
        let frames = film.frames();
        let shots = steps(&frames);
        assert_eq!(shots.len(), edits.len(), "{text}");
        for (shot, (changes, after)) in shots.iter().zip(&edits) {
            let filmed: Vec<Change> = shot.iter().flat_map(|frame| frame.changes.clone()).collect();
            assert_eq!(&filmed, changes, "{text}");
            let last = &shot.last().unwrap().table;
            let expected = snapshot(after);
            assert_eq!(last.half_edges[..expected.half_edges.len()], expected.half_edges, "{text}");
            assert_eq!(*last, expected, "{text}");
        }
        assert_eq!(frames.last().unwrap().table, snapshot(&edits.last().unwrap().1), "{text}");
    }
}

/// What is drawn red was there a frame before and is not any more; what is drawn blue was not, and is.
#[test]
fn gone_pointers_were_there_and_new_ones_are() {
    for text in SCRIPTS {
        let frames = shoot(text).0.frames();
        let mut seen = 0;
        for pair in frames.windows(2) {
            let [before, frame] = [&pair[0].table, &pair[1].table];
            let slots: BTreeSet<String> = pair[1].written.iter().map(|w| w.slot.to_string()).collect();
            for written in &pair[1].written {
                let (then, now) = (target(before, written.slot), target(frame, written.slot));
                match written.fate {
                    Fate::Gone => assert!(then == Some(written.target) && now != then, "{text}: {written:?}"),
                    Fate::New => assert!(now == Some(written.target) && now != then, "{text}: {written:?}"),
                }
                seen += 1;
            }
            let halves = (0..before.half_edge_bound().max(frame.half_edge_bound()) as u32).map(HalfEdgeId::new);
            for slot in halves.map(Slot::Next) {
                let changed = target(before, slot) != target(frame, slot);
                assert_eq!(changed, slots.contains(&slot.to_string()), "{text}: {slot}");
            }
        }
        assert!(seen > 0, "{text}");
    }
}

fn document(svg: &str) -> roxmltree::Document<'_> {
    roxmltree::Document::parse(svg).unwrap()
}

#[test]
fn ids_are_unique_over_all_frames_and_links_lead_to_frames() {
    for text in SCRIPTS {
        let (film, _) = shoot(text);
        for figure in [film.strip(&FigureOptions::new("Film")), film.stepper(&FigureOptions::new("Film"))] {
            let svg = figure.unwrap().to_svg();
            let document = document(&svg);
            let ids: Vec<&str> = document.descendants().filter_map(|node| node.attribute("id")).collect();
            let unique: BTreeSet<&str> = ids.iter().copied().collect();
            assert_eq!(unique.len(), ids.len(), "{text}");
            for link in document.descendants().filter_map(|node| node.attribute("href")) {
                assert!(unique.contains(link.trim_start_matches('#')), "{text}: {link}");
            }
        }
    }
}

/// In the drawing itself: each frame has one arrow for every next pointer that is new, gone, or stays.
#[test]
fn every_next_pointer_of_a_frame_is_drawn_with_its_fate() {
    let (film, _) = shoot(SCRIPTS[0]);
    let frames = film.frames();
    let svg = film.strip(&FigureOptions::new("Film")).unwrap().to_svg();
    let document = document(&svg);
    let classes = |i: usize, fate: &str| -> BTreeSet<String> {
        let wanted = format!("ptr next {fate}");
        let prefix = format!("film-{i}-");
        let drawn = document.descendants().filter(|node| node.attribute("class") == Some(&wanted));
        drawn.filter_map(|node| node.attribute("id")?.strip_prefix(&prefix).map(str::to_owned)).collect()
    };
    for (i, frame) in frames.iter().enumerate() {
        let of = |fate: Fate, end: &str| -> BTreeSet<String> {
            let next = frame.written.iter().filter_map(|w| match w.slot {
                Slot::Next(h) if w.fate == fate => Some(format!("{h}-next{end}")),
                _ => None,
            });
            next.collect()
        };
        let (new, gone) = (of(Fate::New, ""), of(Fate::Gone, "-gone"));
        assert_eq!(classes(i, "made"), new, "frame {i}");
        assert_eq!(classes(i, "gone"), gone, "frame {i}");
        let all = (0..frame.table.half_edge_bound() as u32).map(HalfEdgeId::new);
        let set = all.filter(|&h| frame.table.next(h).is_some()).map(|h| format!("{h}-next"));
        assert_eq!(classes(i, "dim"), set.filter(|name| !new.contains(name)).collect(), "frame {i}");
    }
    assert_eq!((classes(3, "made").len(), classes(3, "gone").len()), (4, 2));
    for (step, class, id) in
        [(4, "face-of", "h8-face-of"), (5, "boundary", "f2-boundary"), (5, "boundary", "f1-boundary")]
    {
        let (class, id) = (format!("ptr {class} made"), format!("film-{step}-{id}"));
        let found = document.descendants().find(|node| node.attribute("id") == Some(&id));
        assert_eq!(found.and_then(|node| node.attribute("class")), Some(class.as_str()), "{id}");
    }
}

/// Half-edges that an edit does not move stand at the same place in all frames.
#[test]
fn frames_share_one_layout() {
    let (film, _) = shoot(SCRIPTS[0]);
    let svg = film.strip(&FigureOptions::new("Film")).unwrap().to_svg();
    let document = document(&svg);
    let shaft = |id: String| {
        let group = document.descendants().find(|node| node.attribute("id") == Some(&id))?;
        let line = group.children().find(|node| node.has_tag_name("line"))?;
        Some(["x1", "y1", "x2", "y2"].map(|name| line.attribute(name).map(str::to_owned)))
    };
    for h in 0..12 {
        let first = shaft(format!("film-0-h{h}"));
        assert!(first.is_some(), "h{h}");
        for frame in 1..7 {
            assert_eq!(shaft(format!("film-{frame}-h{h}")), first, "h{h} in frame {frame}");
        }
    }
    let film = shoot(SCRIPTS[1]).0.strip(&FigureOptions::new("Film")).unwrap().to_svg();
    let split = roxmltree::Document::parse(&film).unwrap();
    let disc = |id: String| {
        let group = split.descendants().find(|node| node.attribute("id") == Some(&id))?;
        let disc = group.children().find(|node| node.has_tag_name("circle"))?;
        Some(["cx", "cy"].map(|name| disc.attribute(name).map(str::to_owned)))
    };
    for frame in 0..8 {
        assert!(disc(format!("film-{frame}-v2")).is_some());
        assert_eq!(disc(format!("film-{frame}-v2")), disc("film-0-v2".to_owned()), "frame {frame}");
    }
    assert!(shaft("film-1-h12".to_owned()).is_none() && shaft("film-2-h12".to_owned()).is_some());
}

/// An edge that is bypassed is there until it is removed, and then red and dashed a last time.
#[test]
fn every_half_edge_with_two_ends_is_drawn_in_every_frame() {
    for text in SCRIPTS {
        let (film, _) = shoot(text);
        let drawing = drawn::read(&film.strip(&FigureOptions::new("Film")).unwrap().to_svg());
        for (i, frame) in film.frames().iter().enumerate() {
            let has_ends = |table: &Table, h: HalfEdgeId| {
                let [a, b] = [Some(h), table.twin(h)].map(|h| h.and_then(|h| table.origin(h)));
                a.zip(b).is_some_and(|(a, b)| table.has_vertex(a) && table.has_vertex(b))
            };
            let all = (0..frame.table.half_edge_bound() as u32).map(HalfEdgeId::new);
            let mut expected: BTreeSet<String> =
                all.filter(|&h| has_ends(&frame.table, h)).map(|h| h.to_string()).collect();
            for element in &frame.removed {
                if let Element::Edge(e) = element {
                    expected.extend(e.half_edges().map(|h| h.to_string()));
                }
            }
            let missing: Vec<&String> =
                expected.iter().filter(|h| !drawing.arrows.contains_key(&format!("{i}-{h}"))).collect();
            assert!(missing.is_empty(), "{text}: frame {i} ({}) lacks {missing:?}", frame.heading);
        }
    }
}

#[test]
fn labels_of_frames_cover_no_disc_and_no_arrow_comes_from_a_face_that_has_gone() {
    for text in SCRIPTS {
        let (film, _) = shoot(text);
        let svg = film.strip(&FigureOptions::new("Film")).unwrap().to_svg();
        let drawing = drawn::read(&svg);
        let frame_of = |owner: &str| owner.split('-').next().unwrap().to_owned();
        let mut checked = 0;
        for word in drawing.words.iter().filter(|word| word.class == "hl") {
            for (v, &(centre, radius)) in drawing.discs.iter().filter(|(v, _)| frame_of(v) == frame_of(&word.owner)) {
                assert!(word.distance(centre) > radius, "{text}: {word:?} is under {v}");
                checked += 1;
            }
        }
        assert!(checked > 100, "{checked}");
        for (i, frame) in film.frames().iter().enumerate() {
            for element in frame.removed.iter().filter(|element| matches!(element, Element::Face(_))) {
                assert!(!svg.contains(&format!("id=\"film-{i}-{element}-boundary-gone\"")), "{text}: frame {i}");
            }
        }
    }
}

#[test]
fn tables_follow_changes_of_rows_that_do_not_exist() {
    let mut table = Table::default();
    let write = |slot| Change::Write { slot, old: None, new: Some(HalfEdgeId::new(7).into()) };
    table.apply(&write(Slot::Next(HalfEdgeId::new(3))));
    table.apply(&write(Slot::Outgoing(VertexId::new(3))));
    table.apply(&write(Slot::HalfEdge(FaceId::new(3))));
    table.apply(&Change::Removed { element: VertexId::new(1).into() });
    assert_eq!((table.half_edge_bound(), table.vertex_bound(), table.face_bound()), (0, 2, 0));
}

/// Scripts without coordinates: splits and joins on a torus; loops, edges side by side and a dangling edge on a sphere;
/// two handles; two components.
const LAID_OUT: [&str; 4] = [
    "torus\nlet a = split_vertex h0 h1\nlet b = split_face h0 h1\nlet c = split_edge b\njoin_edges b\njoin_faces b\n\
     join_vertices a",
    "ring 1\nlet a = split_vertex h0 h0\nlet b = split_edge h0\nsplit_face a.twin h1\njoin_faces b",
    "surface 4 / 0 1 2 / 0 2 3 / 0 3 1 / 1 3 2\nlet a = split_edge h0\nlet b = split_face a h0.prev\nflip_edge b\njoin_vertices a",
    "surface 6 / 0 1 2 / 2 1 0 / 3 4 5 / 5 4 3\nsplit_edge h0",
];

fn film_of_kernel(text: &str) -> (Film, Script<dcel_kit::topology::Dcel>) {
    let script = Script::parse_kernel(text, "test").unwrap_or_else(|error| panic!("{error}"));
    (Film::of_script(&script), script)
}

#[test]
fn films_without_coordinates_are_the_journal_and_lead_to_the_structure() {
    for text in LAID_OUT {
        let (film, script) = film_of_kernel(text);
        let run = script.run();
        let made = run.edits().len();
        assert!(film.edit_count() == made && made > 0, "{text}");
        let last = film.frames().pop().unwrap().table;
        let end = Table::from_view(&run.end);
        assert_eq!(last.half_edges, end.half_edges, "{text}");
        let svg = film.strip(&FigureOptions::new("F")).unwrap_or_else(|error| panic!("{text}: {error}")).to_svg();
        let document = document(&svg);
        let ids: Vec<&str> = document.descendants().filter_map(|node| node.attribute("id")).collect();
        assert_eq!(ids.len(), ids.iter().collect::<BTreeSet<_>>().len(), "{text}: ids are unique");
        let count = film.frames().len() - 1;
        for h in run.end.half_edges() {
            assert!(ids.contains(&&*format!("f-{count}-{h}")), "{text}: {h} is drawn in the last frame");
        }
    }
}

/// A torus of m x n squares.
fn torus(m: usize, n: usize) -> String {
    let v = |i: usize, j: usize| (i % m) * n + j % n;
    let square = |i: usize, j: usize| format!("/ {} {} {} {}", v(i, j), v(i + 1, j), v(i + 1, j + 1), v(i, j + 1));
    let squares: Vec<String> = (0..m * n).map(|k| square(k / n, k % n)).collect();
    format!("surface {} {}", m * n, squares.join(" "))
}

#[test]
fn a_large_structure_without_coordinates_has_room_where_its_edits_are() {
    let edits = "let a = split_face h0 h4\nsplit_edge a\n";
    let starts = [("ring 60".to_owned(), 60), ("ring 200".to_owned(), 200), (torus(12, 12), 288)];
    for (start, edges) in starts {
        let (film, _) = film_of_kernel(&format!("{start}\n{edits}"));
        let frames = film.frames();
        let svg = film.strip(&FigureOptions::new("F")).unwrap_or_else(|error| panic!("{start}: {error}")).to_svg();
        let document = document(&svg);
        let width: f64 = document.root_element().attribute("width").unwrap().parse().unwrap();
        assert!(width <= 830.0, "{start}: {width} px");
        let group = |id: &str| document.descendants().find(|node| node.attribute("id") == Some(id));
        let shaft =
            |id: &str| group(id)?.children().find(|n| n.attribute("class").is_some_and(|c| c.starts_with("sh")));
        let length = |line: roxmltree::Node<'_, '_>| {
            let at = |name: &str| line.attribute(name).unwrap().parse::<f64>().unwrap();
            (at("x2") - at("x1")).hypot(at("y2") - at("y1"))
        };
        let mut named = 0;
        for (i, frame) in frames.iter().enumerate() {
            for written in &frame.written {
                let Slot::Next(h) = written.slot else { continue };
                let id = format!("f-{i}-{h}");
                // A half-edge has no place before both of its ends are known.
                let Some(line) = shaft(&id) else {
                    assert!(frame.table.origin(h).is_none() || written.target == Element::from(h), "{start}: no {id}");
                    continue;
                };
                assert!(length(line) > 12.0, "{start}: {id} is {} px long", length(line));
                named += usize::from(group(&id).unwrap().descendants().any(|n| n.text() == Some(&*h.to_string())));
            }
        }
        assert!(named > 10, "{start}: {named} half-edges that are written have names");
        let drawn = (0..2 * edges).filter(|h| shaft(&format!("f-0-h{h}")).is_some()).count();
        assert!(drawn > 8 && drawn < 3 * edges / 2, "{start}: {drawn} of {} half-edges have arrows", 2 * edges);
    }
}

#[test]
fn a_large_structure_that_is_marked_all_over_is_refused() {
    let marked: Vec<String> = (0..300).map(|i| format!("h{}", 2 * i)).collect();
    let (film, _) = film_of_kernel(&format!("ring 300\nhighlight {}\nsplit_edge h0", marked.join(" ")));
    assert!(matches!(film.strip(&FigureOptions::new("F")), Err(FigureError::NoRoom { .. })));
}

/// What is drawn in each frame: no captions, no names of links, no ids.
fn drawings(svg: &str) -> Vec<String> {
    let document = document(svg);
    let frames =
        document.descendants().filter(|n| n.attribute("class").is_some_and(|c| c.split(' ').next() == Some("fr")));
    let is_caption = |n: &roxmltree::Node<'_, '_>| matches!(n.attribute("class"), Some("ct" | "cs" | "cs nav"));
    let drawing = |frame: roxmltree::Node<'_, '_>| {
        let nodes = frame.descendants().skip(1).filter(|n| n.is_element() && !n.has_tag_name("title"));
        let nodes = nodes.filter(|n| !n.ancestors().any(|a| is_caption(&a)));
        let words = nodes.map(|n| {
            let attributes =
                n.attributes().filter(|a| !["id", "href"].contains(&a.name()) && !a.name().starts_with("data-"));
            let attributes: Vec<String> = attributes.map(|a| format!("{}={}", a.name(), a.value())).collect();
            format!("{} {} {:?}", n.tag_name().name(), attributes.join(" "), n.text().map(str::trim))
        });
        words.collect::<Vec<_>>().join("\n")
    };
    frames.map(drawing).collect()
}

#[test]
fn the_drawing_of_every_frame_differs_from_the_one_before() {
    let differ = |name: &str, svg: &str, count: usize| {
        let drawings = drawings(svg);
        assert_eq!(drawings.len(), count, "{name}");
        for (i, pair) in drawings.windows(2).enumerate() {
            assert_ne!(pair[0], pair[1], "{name}: frame {} shows nothing new", i + 1);
        }
    };
    let options = FigureOptions::new("F");
    for text in SCRIPTS {
        let (film, _) = shoot(text);
        differ(text, &film.strip(&options).unwrap().to_svg(), film.frames().len());
    }
    for text in LAID_OUT {
        let (film, _) = film_of_kernel(text);
        differ(text, &film.strip(&options).unwrap().to_svg(), film.frames().len());
    }
    let mut films = 0;
    for entry in std::fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/../figures")).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        if name.starts_with("film-") {
            let svg = std::fs::read_to_string(&path).unwrap();
            differ(&name, &svg, svg.matches("<g class=\"fr").count());
            films += 1;
        }
    }
    assert!(films >= 15, "{films}");
}

#[test]
fn no_frame_of_an_edit_has_more_than_four_assignments_of_several_families() {
    let family = |slot: Slot| match slot {
        Slot::Origin(_) => 0,
        Slot::Next(_) | Slot::Prev(_) => 1,
        Slot::Face(_) => 2,
        Slot::Outgoing(_) => 3,
        Slot::HalfEdge(_) => 4,
    };
    let mut cut = 0;
    for text in SCRIPTS {
        let (film, edits) = shoot(text);
        for frame in film.frames() {
            let assigned = frame.changes.iter().filter_map(|change| match *change {
                Change::Write { slot, new: Some(_), .. } if !matches!(slot, Slot::Prev(_)) => Some(family(slot)),
                _ => None,
            });
            let assigned: Vec<usize> = assigned.collect();
            let families: BTreeSet<usize> = assigned.iter().copied().collect();
            assert!(assigned.len() <= 4 || families.len() == 1, "{text}: {}", frame.heading);
            cut += usize::from(frame.heading.contains(" of "));
        }
        // Nothing is lost or said twice by the cut.
        let count = |changes: &[Change]| changes.len();
        let shown: usize = film.frames().iter().map(|frame| count(&frame.changes)).sum();
        assert_eq!(shown, edits.iter().map(|(changes, _)| count(changes)).sum::<usize>(), "{text}");
    }
    assert!(cut > 10, "{cut}");
}

#[test]
fn records_without_a_place_are_named_in_the_corner_until_they_have_one() {
    let (film, _) = shoot("polygon 0 0 7 0 6 4 1 4.6\nsplit_in_half h0\nsplit_face h0 h4");
    let svg = film.strip(&FigureOptions::new("F")).unwrap().to_svg();
    let document = document(&svg);
    let chips = |i: usize| -> Vec<String> {
        let group = document.descendants().find(|n| n.attribute("id") == Some(&format!("f-{i}-new")));
        let words = group.into_iter().flat_map(|g| g.descendants()).filter(|n| n.has_tag_name("text"));
        words.filter_map(|n| n.text()).map(|word| word.trim().to_owned()).collect()
    };
    let frames = film.frames();
    let mut seen = Vec::new();
    for (i, frame) in frames.iter().enumerate() {
        let table = &frame.table;
        let ends = |h: HalfEdgeId| table.origin(h).is_some() && table.twin(h).and_then(|t| table.origin(t)).is_some();
        let halves = (0..table.half_edge_bound() as u32).map(HalfEdgeId::new).filter(|&h| table.has_half_edge(h));
        let placeless: Vec<String> = halves.filter(|&h| !ends(h)).map(|h| h.to_string()).collect();
        let halves: Vec<String> = chips(i).into_iter().filter(|name| name.starts_with('h')).collect();
        assert_eq!(halves, placeless, "{}", frame.heading);
        seen.extend(chips(i));
    }
    assert!(seen.contains(&"h8".to_owned()) && seen.contains(&"f2".to_owned()), "{seen:?}");
    assert!(chips(frames.len() - 1).is_empty());
}

#[test]
fn an_edit_with_a_slip_is_the_edit_but_for_the_slip() {
    for text in SCRIPTS {
        let (film, _) = shoot(text);
        let script = Script::parse(text, "test").unwrap();
        let mut slots: BTreeSet<String> = BTreeSet::new();
        script.play(|step, _| {
            let Outcome::Edited { journal, .. } = step.outcome else { panic!("{text}") };
            for change in journal.changes() {
                if let Change::Write { slot, new: Some(_), .. } = change {
                    slots.insert(slot.to_string());
                }
            }
            ControlFlow::Continue(())
        });
        for slot in &slots {
            let slip: Slip = slot.parse().unwrap();
            let beside = film.beside(&[slip]).unwrap_or_else(|error| panic!("{text}: {slot}: {error}"));
            let frames = beside.frames();
            let slipped: Vec<usize> =
                (0..frames.len()).filter(|&i| frames[i][1].text.contains(&format!("left out: {slot} ="))).collect();
            assert!(!slipped.is_empty(), "{text}: {slot} is said");
            for (i, [right, wrong]) in frames.iter().enumerate() {
                let mut mended = wrong.table.clone();
                let write = Change::Write { slot: slip.slot, old: None, new: target(&right.table, slip.slot) };
                if i >= slipped[0] && target(&right.table, slip.slot) != target(&wrong.table, slip.slot) {
                    mended.apply(&write);
                }
                assert_eq!(mended.half_edges, right.table.half_edges, "{text}: {slot}: frame {i}");
                assert_eq!(mended.vertices, right.table.vertices, "{text}: {slot}: frame {i}");
            }
            let last = &frames.last().unwrap()[1];
            let found = dcel_kit::topology::violations(&last.table);
            assert_eq!(found.is_empty(), last.text.contains("all the same"), "{text}: {slot}: {}", last.text);
            let svg = beside.strip(&FigureOptions::new("F")).unwrap().to_svg();
            let ids: Vec<String> =
                document(&svg).descendants().filter_map(|n| n.attribute("id").map(str::to_owned)).collect();
            assert_eq!(ids.len(), ids.iter().collect::<BTreeSet<_>>().len(), "{text}: {slot}: ids are unique");
        }
    }
}

#[test]
fn the_ends_of_a_film_are_what_was_and_what_is_with_the_new_marked() {
    let solid = "solid cube\nextrude_face f2 1\nremove_face f0";
    let solid = Film::of_script(&Script::parse_solid(solid, "test").unwrap());
    let moved = Film::of_script(&Script::parse_solid("solid cube\nset_point v0 2 2 2", "test").unwrap());
    let plane = SCRIPTS.map(|text| shoot(text).0);
    let kernel = LAID_OUT.map(|text| film_of_kernel(text).0);
    for film in [solid, moved].iter().chain(&plane).chain(&kernel) {
        let (frames, ends) = (film.frames(), film.ends().frames());
        let [first, last] = &ends[..] else { panic!("{} frames", ends.len()) };
        assert_eq!(first.table, frames[0].table);
        assert_eq!(last.table, frames[frames.len() - 1].table);
        let vertices = (0..last.table.vertex_bound() as u32).map(VertexId::new);
        for v in vertices.filter(|&v| last.table.has_vertex(v)) {
            let is_new = !first.table.has_vertex(v);
            assert_eq!(last.marked.contains(&v.into()), is_new, "{v}");
        }
        film.ends().strip(&FigureOptions::new("F")).unwrap();
    }
}

#[test]
fn slips_that_cannot_be_shown_say_why() {
    let (film, _) = shoot(SCRIPTS[2]);
    let slip = |text: &str| text.parse::<Slip>().unwrap();
    let said = |slips: &[Slip]| film.beside(slips).unwrap_err().to_string();
    assert!(said(&[slip("h99.next")]).starts_with("no edit writes h99.next: written are h12.origin, "));
    assert_eq!(said(&[slip("h12.next=h99")]), "h12.next = h99: there is no such element after the edit");
    assert_eq!(said(&[slip("h12.next = h8")]), "h12.next = h8 is what the edit writes");
    assert_eq!(said(&[]), "there is no slip to show");
    assert_eq!(
        said(&[slip("h12.origin"), slip("v6.outgoing")]),
        "no edit writes both h12.origin and v6.outgoing: only one edit is shown"
    );
    // h12.next is written by the split and by what follows: the slips decide which edit is meant.
    let both = film.beside(&[slip("h12.next"), slip("v6.outgoing")]).unwrap();
    assert!(both.frames()[0][0].heading.starts_with("split_edge"), "{}", both.frames()[0][0].heading);
    let one = film.beside(&[slip("h12.next")]).unwrap();
    assert!(one.frames()[0][0].heading.starts_with("split_face"), "{}", one.frames()[0][0].heading);
    let solid = Script::parse_solid("solid cube\nextrude_face f2 1", "test").unwrap();
    let error = Film::of_script(&solid).beside(&[slip("h0.next")]).unwrap_err();
    assert_eq!(error, SlipError::InSpace);
    for wrong in ["", "h1", "h1.twin", "v1.next", "h1.next = f2", "h1.face = h2", "h1.next =", "h1.next = h2 = h3"] {
        assert!(wrong.parse::<Slip>().is_err(), "{wrong}");
    }
}

#[test]
fn the_sides_of_a_torus_are_lettered_in_pairs_of_one_colour() {
    let (film, _) = film_of_kernel("torus\nlet a = split_vertex h0 h1");
    let svg = film.strip(&FigureOptions::new("F")).unwrap().to_svg();
    let document = document(&svg);
    let frame = |i: usize| document.descendants().find(|n| n.attribute("id") == Some(&format!("f-step-{i}"))).unwrap();
    let last = film.frames().len() - 1;
    for (i, pairs) in [(0, 2), (last, 3)] {
        let glued = frame(i).descendants().filter(|n| n.attribute("class").is_some_and(|c| c.starts_with("glued")));
        let mut sides: Vec<(String, String)> = glued
            .map(|n| {
                let letter = n.descendants().find(|n| n.has_tag_name("text")).and_then(|n| n.text()).unwrap();
                (letter.to_owned(), n.attribute("class").unwrap().to_owned())
            })
            .collect();
        sides.sort();
        let distinct: BTreeSet<_> = sides.iter().cloned().collect();
        assert_eq!((sides.len(), distinct.len()), (2 * pairs, pairs), "{sides:?}");
        assert!(sides.chunks(2).all(|pair| pair[0] == pair[1]), "{sides:?}");
        let colours: BTreeSet<_> = distinct.iter().map(|side| &side.1).collect();
        assert_eq!(colours.len(), pairs, "each pair has a colour of its own");
    }
    let corners = frame(0).descendants().filter(|n| n.attribute("class") == Some("v"));
    let names: Vec<_> = corners.filter_map(|n| n.descendants().find(|n| n.has_tag_name("text"))?.text()).collect();
    assert_eq!(names, ["v0"; 4]);
}

#[test]
fn films_in_space_are_seen_from_one_place() {
    let script = Script::parse_solid("solid cube\nextrude_face f2 1\nremove_face f0", "test").unwrap();
    let film = Film::of_script(&script);
    let svg = film.strip(&FigureOptions::new("F")).unwrap().to_svg();
    let document = document(&svg);
    let frames = film.frames();
    let headings: Vec<&str> = frames.iter().map(|frame| frame.heading.as_str()).collect();
    assert_eq!(headings, ["start", "extrude_face f2 1", "remove_face f0"]);
    let disc = |i: usize, v: &str| {
        let group = document.descendants().find(|n| n.attribute("id") == Some(&format!("f-{i}-{v}")))?;
        let disc = group.descendants().find(|n| n.has_tag_name("circle"))?;
        Some(["cx", "cy"].map(|name| disc.attribute(name).unwrap().to_owned()))
    };
    let cube = script.start();
    let moved: Vec<String> = cube.vertices().map(|v| v.to_string()).collect();
    let both: Vec<_> = moved.iter().filter_map(|v| Some((disc(0, v)?, disc(1, v)?))).collect();
    assert!(both.len() >= 3, "some corners are seen in both");
    assert!(both.iter().all(|(before, after)| before == after), "{both:?}");
    assert!(svg.contains("id=\"f-1-v8\"") && !svg.contains("id=\"f-0-v8\""), "new corners come with their edit");
}

/// Inkscape drops a whole style sheet for one rule with @supports: the colours must stand in another one.
#[test]
fn rules_that_ask_what_a_program_supports_stand_in_a_sheet_of_their_own() {
    let (film, _) = shoot(SCRIPTS[0]);
    let svg = film.stepper(&FigureOptions::new("Steps")).unwrap().to_svg();
    let document = roxmltree::Document::parse(&svg).unwrap();
    let sheets: Vec<&str> = document
        .descendants()
        .filter(|n| n.tag_name().name() == "style")
        .filter_map(|n| n.text())
        .map(str::trim)
        .collect();
    assert_eq!(sheets.len(), 2);
    assert!(!sheets[0].contains("@supports") && sheets[0].contains(".sh{"), "{}", sheets[0]);
    assert!(sheets[1].starts_with("@supports selector(:has(a))"), "{}", sheets[1]);
    assert_eq!(film.strip(&FigureOptions::new("Steps")).unwrap().to_svg().matches("<style>").count(), 1);
}
