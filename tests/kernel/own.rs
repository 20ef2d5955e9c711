//! Edits from outside the kit, and data that follow edits.

use crate::common::{Random, f, h, v};
use crate::examples::own_edit as example;
use dcel_kit::topology::{Change, Dcel, Editing, Followed, Journal, NoRecorder, OwnEditError, Recorder, violations};
use dcel_kit::{FaceId, HalfEdgeId, HalfEdgeMap};
use std::convert::Infallible;

#[test]
fn an_own_edit_is_refused_where_it_should_be() {
    let mut d = Dcel::polygon(4).unwrap();
    let before = d.clone();
    let error = example::poke_face(&mut d, f(9), &mut NoRecorder).unwrap_err();
    assert!(error.to_string().starts_with("there is no f9"), "{error}");
    assert_eq!(d, before);
}

/// One random write, on purpose or by mistake; edits of the kit only while the structure is whole.
fn scribble(random: &mut Random, e: &mut Editing<'_>, is_whole: bool) {
    let (hs, vs, fs) = (e.half_edge_bound(), e.vertex_bound(), e.face_bound());
    let half = |random: &mut Random| h(random.below(hs) as u32);
    let (a, b) = (half(random), half(random));
    let (x, y) = (v(random.below(vs) as u32), f(random.below(fs) as u32));
    match random.below(if is_whole { 12 } else { 10 }) {
        0 => e.set_next(a, b),
        1 => e.set_origin(a, x),
        2 => e.set_face(a, y),
        3 => e.set_outgoing(x, Some(a)),
        4 => e.set_half_edge(y, Some(a)),
        5 => e.set_outgoing(x, None),
        6 => drop(e.remove_vertex(x)),
        7 => drop(e.remove_edge(a.edge())),
        8 => drop(e.remove_face(y)),
        9 => drop(e.add_face()),
        10 => drop(e.split_face(a, b)),
        _ => drop(e.split_edge(a)),
    }
}

/// The look at what was touched says what the check of everything says, for right and wrong edits.
#[test]
fn the_local_check_agrees_with_the_full_one() {
    let mut verdicts = [0; 3];
    for seed in 0..4000 {
        let mut random = Random(seed);
        let mut start = if seed % 3 == 0 { Dcel::torus() } else { Dcel::polygon(1 + seed as usize % 5).unwrap() };
        let [a, b] = [0, 1].map(|_| h(random.below(start.half_edge_bound()) as u32));
        let _ = (start.split_edge(a), start.split_face(a, b), start.split_edge(b));
        let mut d = start.clone();
        let mut written = None;
        let answer = d.edit_with(&mut NoRecorder, |e| {
            for i in 0..1 + random.below(2) {
                scribble(&mut random, e, i == 0);
            }
            written = Some((**e).clone());
            Ok::<_, Infallible>(())
        });
        let sound = violations(&written.unwrap()).is_empty();
        let astray = matches!(answer, Err(OwnEditError::Id(_)));
        assert!(astray || answer.is_ok() == sound, "seed {seed}: {answer:?}");
        verdicts[if astray { 2 } else { usize::from(sound) }] += 1;
        if let Err(error) = answer {
            assert_eq!(d, start, "seed {seed}");
            assert!(!matches!(error, OwnEditError::Broken { violations } if violations.is_empty()), "seed {seed}");
        }
    }
    assert!(verdicts.iter().all(|&n| n > 20), "{verdicts:?}");
}

#[test]
fn an_edit_that_refuses_half_way_leaves_no_trace() {
    let mut d = Dcel::polygon(6).unwrap();
    let (before, mut journal) = (d.clone(), Journal::new());
    let answer: Result<(), _> = d.edit_with(&mut journal, |e| {
        e.split_face(h(0), h(4)).unwrap();
        e.remove_vertex(v(3)).unwrap();
        Err("enough")
    });
    assert_eq!(answer, Err(OwnEditError::Refused("enough")));
    assert_eq!((d, journal), (before, Journal::new()));
}

/// Values by element through random edits and a renumbering, against a list of what should be.
#[test]
fn data_follow_edits_and_renumbering() {
    for seed in 0..60 {
        let mut random = Random(seed);
        let mut d = Dcel::polygon(5).unwrap();
        let mut marks: Followed<FaceId, u64> = Followed::new(0);
        let mut halves: Followed<HalfEdgeId, u64> = Followed::new(0);
        let mut expected: std::collections::BTreeMap<FaceId, u64> = Default::default();
        for step in 1..40 {
            let [a, b] = [0, 1].map(|_| h(random.below(d.half_edge_bound()) as u32));
            let mut journal = Journal::new();
            let rec = &mut ((&mut marks, &mut halves), &mut journal);
            match random.below(4) {
                0 => drop(d.split_edge_with(a, rec)),
                1 => drop(d.join_faces_with(a, rec)),
                _ => drop(d.split_face_with(a, b, rec)),
            }
            for change in journal.changes() {
                if let Change::Removed { element: dcel_kit::Element::Face(f) } = change {
                    expected.remove(f);
                }
            }
            let face = d.faces().nth(random.below(d.face_count())).unwrap();
            marks[face] = step;
            expected.insert(face, step);
        }
        for f in (0..d.face_bound() as u32).map(FaceId::new) {
            assert_eq!(marks[f], expected.get(&f).copied().unwrap_or(0), "seed {seed}: {f}");
        }
        let old: Vec<(HalfEdgeId, u64)> = d.half_edges().map(|h| (h, u64::from(h.number()))).collect();
        let mut numbers = HalfEdgeMap::filled(d.half_edge_bound(), 0);
        old.iter().for_each(|&(h, n)| numbers[h] = n);
        let map = d.compact();
        let numbers = numbers.renumbered(&map);
        for (h, n) in old {
            assert_eq!(numbers[map.half_edge(h).unwrap()], n, "seed {seed}");
        }
        marks.renumber(&map);
        for (f, step) in expected {
            assert_eq!(marks[map.faces[f].unwrap()], step, "seed {seed}");
        }
    }
}

#[test]
fn two_recorders_hear_the_same() {
    let mut both = (Journal::new(), Journal::new());
    both.step(1, "One.");
    Dcel::polygon(4).unwrap().split_face_with(h(0), h(4), &mut both).unwrap();
    assert_eq!(both.0, both.1);
    assert!(both.0.len() > 10);
}
