//! The table of edits: every row on every structure that has it, with random arguments. Refused edits change nothing,
//! made ones keep the invariants, are taken back bit for bit, and print a script that replays.

use crate::common::Random;
use dcel_kit::edits::{Argument, Call, Editable, Kind, Row, TABLE, Takes, find, help, rows_of};
use dcel_kit::plane::{LAB_RECTANGLE, PlaneJournal, Point, Subdivision};
use dcel_kit::script::{KernelStart, Script, SolidStart, of_edits, of_kernel_edits, of_solid_edits};
use dcel_kit::solid::{Platonic, Polyhedron, SurfaceJournal};
use dcel_kit::topology::{Dcel, Journal, View, violations};
use dcel_kit::{EdgeId, Element, FaceId, HalfEdgeId, VertexId};
use std::collections::BTreeMap;

fn element(random: &mut Random, kind: Kind, on: &Dcel) -> Element {
    // One beyond the last, so that missing ones are asked for, too.
    match kind {
        Kind::Vertex => VertexId::new(random.below(on.vertex_bound() + 1) as u32).into(),
        Kind::HalfEdge => HalfEdgeId::new(random.below(on.half_edge_bound() + 1) as u32).into(),
        Kind::Edge => EdgeId::new(random.below(on.edge_bound() + 1) as u32).into(),
        Kind::Face => FaceId::new(random.below(on.face_bound() + 1) as u32).into(),
    }
}

/// Arguments of the right kinds; half-edges after the first mostly on the cycle or round the origin of the first.
fn arguments<S: Editable>(random: &mut Random, row: &Row, s: &S) -> Vec<Argument> {
    let on = s.topology();
    let mut out: Vec<Argument> = Vec::new();
    for parameter in row.takes {
        match parameter.takes {
            Takes::Element(kind) => {
                let near = match out.first() {
                    Some(Argument::Element(Element::HalfEdge(a))) if kind == Kind::HalfEdge && on.has_half_edge(*a) => {
                        let turn = random.below(2) == 0;
                        let steps = 1 + random.below(4);
                        (random.below(5) > 0)
                            .then(|| (0..steps).fold(*a, |h, _| if turn { on.ccw(h) } else { on.next(h) }).into())
                    }
                    _ => None,
                };
                out.push(near.unwrap_or_else(|| element(random, kind, on)).into());
            }
            Takes::Place if S::DIMENSION == 0 => {}
            Takes::Place => {
                let mut x = || 25.0 * (random.below(23) as f64 - 11.0);
                out.push(Argument::Place([x(), x(), if S::DIMENSION == 3 { x() } else { 0.0 }]));
            }
            Takes::Number => out.push([0.25, 0.5, 0.75, 0.0, 1.0, -0.5, 3.0][random.below(7)].into()),
            Takes::Map => {
                let numbers = [1.0, 0.0, -1.0, 2.0, 0.5, 1.5];
                out.extend((0..S::DIMENSION * (S::DIMENSION + 1)).map(|_| Argument::from(numbers[random.below(6)])));
            }
            Takes::Switch => out.push((random.below(2) == 0).into()),
            Takes::Vertices => {
                let corners = 3 + random.below(2);
                out.extend((0..corners).map(|_| Argument::from(element(random, Kind::Vertex, on))));
            }
            other => panic!("{other:?} is new: let it be tried here"),
        }
    }
    out
}

/// A random script: its calls and the structure at the end. Counts for each word the calls that were made.
fn wander<S: Editable + View>(
    (seed, prelude): (u64, Option<&str>),
    start: &S,
    len: impl Fn(&S::Log) -> usize,
    invariants: impl Fn(&S) -> Vec<String>,
    made: &mut BTreeMap<&'static str, usize>,
) -> (Vec<Call<S>>, S) {
    let mut random = Random(seed);
    let mut s = start.clone();
    let rows: Vec<&'static Row> = rows_of::<S>().collect();
    let mut calls: Vec<Call<S>> = Vec::new();
    let mut all = S::Log::default();
    for step in 0..18 {
        let row = rows[random.below(rows.len())];
        // Some begin with an edit that makes others possible.
        let first = prelude.filter(|_| step == 0).map(|call| call.parse().unwrap());
        let call = first.unwrap_or_else(|| Call::new(row, arguments(&mut random, row, &s)).unwrap());
        let row = call.row();
        assert_eq!(call, call.to_string().parse().unwrap());
        let before = s.clone();
        let mut log = S::Log::default();
        let answer = call.apply(&mut s, &mut log);
        calls.push(call.clone());
        let script = format!("seed {seed}: {calls:?}");
        match answer {
            Err(error) => {
                assert!(!error.to_string().is_empty());
                assert_eq!(s, before, "{error}: a refusal left a trace: {script}");
                assert_eq!(len(&log), 0, "{error}: a refusal was recorded: {script}");
            }
            Ok(returned) => {
                assert_eq!(invariants(&s), [""; 0], "{script}");
                assert_eq!(
                    returned.named().map(Kind::of),
                    row.names().filter(|_| returned.named().is_some()),
                    "{script}"
                );
                *made.entry(row.word).or_default() += 1;
                let mut back = s.clone();
                back.take_back(&mut log);
                assert_eq!(back, before, "{script}");
                assert_eq!(len(&log), 0, "{script}");
                call.apply(&mut before.clone(), &mut all).unwrap();
            }
        }
    }
    let mut back = s.clone();
    back.take_back(&mut all);
    assert_eq!(&back, start, "seed {seed}: {calls:?}");
    (calls, s)
}

fn texts<V: View>(view: &V) -> Vec<String> {
    violations(view).iter().map(ToString::to_string).collect()
}

fn all_made<S: Editable>(made: &BTreeMap<&'static str, usize>, least: usize) {
    for row in rows_of::<S>() {
        assert!(
            made.get(row.word).is_some_and(|&n| n >= least),
            "{} was made {:?} times",
            row.word,
            made.get(row.word)
        );
    }
}

#[test]
fn every_row_of_the_kernel_is_undone_and_replayed() {
    let starts =
        [KernelStart::Torus, KernelStart::Ring(6), KernelStart::Surface { vertices: 2, faces: Default::default() }];
    let mut made = BTreeMap::new();
    for seed in 0..90 {
        let start = &starts[seed as usize % starts.len()];
        let (calls, end) = wander((seed, None), &start.build().unwrap(), Journal::len, texts, &mut made);
        let text = of_kernel_edits(start, &calls);
        let run = Script::parse_kernel(&text, "printed").unwrap_or_else(|e| panic!("{e}\n{text}")).run();
        assert_eq!(run.end, end, "{text}");
    }
    all_made::<Dcel>(&made, 10);
}

#[test]
fn every_row_of_the_plane_is_undone_and_replayed() {
    let invariants = |s: &Subdivision| {
        let geometry = s.geometry_violations();
        texts(s).into_iter().chain(geometry.iter().map(ToString::to_string)).collect()
    };
    let mut made = BTreeMap::new();
    for seed in 0..300 {
        // A quadrilateral, so that its diagonals can be flipped.
        let square = [[-275.0, -275.0], [275.0, -275.0], [275.0, 250.0], [-275.0, 275.0]].map(Point::from);
        let corners = if seed % 2 == 0 { &LAB_RECTANGLE[..] } else { &square[..] };
        let prelude = (seed % 2 == 1).then_some("split_face h0 h4");
        let start = Subdivision::polygon(corners).unwrap();
        let (calls, end) = wander((seed, prelude), &start, PlaneJournal::len, invariants, &mut made);
        let text = of_edits(corners, &calls);
        let run = Script::parse(&text, "printed").unwrap_or_else(|e| panic!("{e}\n{text}")).run();
        if !text.contains("no such") {
            assert_eq!(run.end, end, "{text}");
        }
    }
    all_made::<Subdivision>(&made, 2);
}

#[test]
fn every_row_of_space_is_undone_and_replayed() {
    let mut made = BTreeMap::new();
    for seed in 0..300 {
        let start = SolidStart::Platonic(Platonic::ALL[seed as usize % 3]);
        let prelude = (seed % 2 == 1).then_some("remove_face f0");
        let (calls, end) = wander((seed, prelude), &start.build().unwrap(), SurfaceJournal::len, texts, &mut made);
        let text = of_solid_edits(&start, &calls);
        let run = Script::parse_solid(&text, "printed").unwrap_or_else(|e| panic!("{e}\n{text}")).run();
        if !text.contains("no such") {
            assert_eq!(run.end, end, "{text}");
        }
    }
    all_made::<Polyhedron>(&made, 2);
}

/// Each word once, each row on some structure, each documented; help says all of them.
#[test]
fn the_table_is_complete() {
    let mut words: Vec<&str> = TABLE.iter().map(|row| row.word).collect();
    words.sort_unstable();
    words.dedup();
    assert_eq!(words.len(), TABLE.len());
    for row in TABLE {
        let places = [
            find::<Dcel>(row.word).is_some(),
            find::<Subdivision>(row.word).is_some(),
            find::<Polyhedron>(row.word).is_some(),
        ];
        assert!(places.contains(&true), "{} is made on nothing", row.word);
        assert!(row.help.len() > 10 && !row.help.ends_with('.'), "{}", row.word);
        let helps = [help::<Dcel>(), help::<Subdivision>(), help::<Polyhedron>()];
        for (has, help) in places.into_iter().zip(helps) {
            assert_eq!(help.lines().any(|line| line.split_whitespace().next() == Some(row.word)), has, "{}", row.word);
        }
    }
    // The edits that the plane had when the table was made.
    for word in "split_face split_in_half split_edge join_faces join_edges flip_edge insert_vertex insert_vertex_in \
                 insert_edge insert_dangling_edge insert_segment remove_edge remove_vertex"
        .split_whitespace()
    {
        assert!(find::<Subdivision>(word).is_some(), "{word}");
    }
}

#[test]
fn wrong_calls_say_how_they_are_written() {
    let cases = [
        ("split_vertex h0 h1", "the plane has no edit `split_vertex`; known: split_face split_in_half"),
        ("split_edge h0 1", "`split_edge h0 1` does not fit; write split_edge A X Y"),
        ("split_face h0 v1", "`split_face h0 v1` does not fit; write split_face A B"),
        ("remove_edge e0 e1", "`remove_edge e0 e1` does not fit; write remove_edge E"),
        ("insert_segment 0 0 1", "`insert_segment 0 0 1` does not fit; write insert_segment PX PY QX QY"),
        ("", "the plane has no edit ``"),
    ];
    for (text, expected) in cases {
        let error = text.parse::<Call<Subdivision>>().unwrap_err().to_string();
        assert!(error.starts_with(expected), "{text}: {error}");
    }
}

/// What edits make is named by `let`, whatever it is; edges and faces are said by links.
#[test]
fn new_words_take_and_give_all_kinds_of_elements() {
    let text = "rectangle\nlet p = insert_vertex -100 0\nlet q = insert_vertex_in f1 100 0\nlet a = insert_edge p q\n\
                let t = insert_dangling_edge q 100 50\nhighlight p q t.origin a.edge\nremove_edge a.edge\nremove_vertex q\n\
                let s = insert_segment 0 -200 0 200\nwalk_face s";
    let told: Vec<String> =
        Script::parse(text, "t").unwrap().run().steps.iter().map(|s| s.outcome.to_string()).collect();
    assert_eq!(told[0], "insert_vertex -100 0 returned v6");
    assert_eq!(told[2], "insert_edge v6 v7 returned h12");
    assert_eq!(told[3], "insert_dangling_edge v7 100 50 returned v8, h14");
    assert_eq!(told[5], "remove_edge e6 returned nothing");
    assert!(told[7].starts_with("insert_segment 0 -200 0 200 returned "), "{told:#?}");
    assert!(told.iter().all(|line| !line.contains("refused")), "{told:#?}");
    let end = Script::parse(text, "t").unwrap().run().end;
    assert!(end.vertices().any(|v| end.point(v) == Point::new(0.0, 200.0)));
}
