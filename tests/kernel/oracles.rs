//! Every edit does what a naive model of face lists does, call by call, and the invariants hold after each.

use crate::common::model::{Model, No};
use crate::common::script::{Call, Log, Op, all_calls, config, scripts};
use crate::common::{brute, h};
use dcel_kit::HalfEdgeId;
use dcel_kit::topology::{Dcel, NoRecorder, Table, measure, violations};
use proptest::prelude::*;

/// Makes a call on both and compares what came of it. Whether it was accepted.
fn step(dcel: &mut Dcel, model: &mut Model, call: Call, context: &str) -> bool {
    let n = |a: HalfEdgeId| a.number();
    let (verdict, done): (Result<(), No>, Result<(), String>) = match call {
        Call::SplitFace(a, b) => {
            let verdict = model.can_split_face(n(a), n(b));
            let done = dcel.split_face(a, b).map_err(|e| e.to_string());
            (
                verdict,
                done.map(|(c, x)| verdict.into_iter().for_each(|()| model.split_face(n(a), n(b), n(c), x.number()))),
            )
        }
        Call::SplitEdge(a) => {
            let verdict = if model.origin.contains_key(&n(a)) { Ok(()) } else { Err(No::Missing) };
            let done = dcel.split_edge(a).map_err(|e| e.to_string());
            (verdict, done.map(|(m, c)| verdict.into_iter().for_each(|()| model.split_edge(n(a), m.number(), n(c)))))
        }
        Call::JoinFaces(a) => {
            let verdict = model.can_join_faces(n(a));
            let done = dcel.join_faces(a).map_err(|e| e.to_string());
            (verdict, done.map(|_| verdict.into_iter().for_each(|()| model.join_faces(n(a)))))
        }
        Call::JoinEdges(a) => {
            let verdict = model.can_join_edges(n(a));
            let done = dcel.join_edges(a).map_err(|e| e.to_string());
            (verdict, done.map(|_| verdict.into_iter().for_each(|()| model.join_edges(n(a)))))
        }
    };
    assert_eq!(verdict.is_ok(), done.is_ok(), "the model says {verdict:?}, the kit says {done:?}, {context}");
    model.assert_matches(dcel, context);
    done.is_ok()
}

proptest! {
    #![proptest_config(config(400))]

    #[test]
    fn random_scripts_agree_with_the_model_and_keep_the_laws((corners, ops) in scripts(40)) {
        let mut dcel = Dcel::polygon(corners as usize).unwrap();
        let mut model = Model::polygon(corners);
        let mut log = Log::new(corners);
        model.assert_matches(&dcel, "at the start");
        for op in ops {
            let call = op.resolve(&dcel);
            let context = log.add(call);
            step(&mut dcel, &mut model, call, context);
            prop_assert_eq!(violations(&dcel), [], "{}", context);
            let counts = measure(&dcel);
            prop_assert_eq!((counts.closed_euler(), counts.genus(), counts.components.len()), (2, 0, 1), "{}", context);
            prop_assert_eq!((counts.vertices, counts.edges), (dcel.vertex_count(), dcel.edge_count()), "{}", context);
            prop_assert_eq!((counts.cycles, counts.face_records), (dcel.face_count(), dcel.face_count()), "{}", context);
        }
    }
}

#[test]
fn long_scripts_agree_with_the_model() {
    for seed in 0..6 {
        let mut random = crate::common::Random(seed);
        let corners = 1 + random.below(7) as u32;
        let (mut dcel, mut model) = (Dcel::polygon(corners as usize).unwrap(), Model::polygon(corners));
        let mut accepted = 0;
        for i in 0..400 {
            let op = Op { kind: random.below(12) as u8, first: random.next() as u16, second: random.next() as u16 };
            let call = op.resolve(&dcel);
            accepted += usize::from(step(&mut dcel, &mut model, call, &format!("seed {seed}, call {i}: {call}")));
        }
        assert!(accepted > 100, "seed {seed}: only {accepted} of 400 calls were accepted");
        assert!(brute::legal(&Table::from_view(&dcel)), "seed {seed}");
    }
}

#[test]
fn on_everything_two_edits_from_a_small_polygon_exactly_the_legal_calls_are_accepted() {
    let (mut structures, mut calls, mut legal_pairs) = (0, 0, 0);
    for corners in 1..=5 {
        let mut layer = vec![(Dcel::polygon(corners).unwrap(), format!("polygon {corners}"))];
        for depth in 0..=2 {
            let mut fresh = Vec::new();
            for (dcel, context) in &layer {
                structures += 1;
                assert!(brute::legal(&Table::from_view(dcel)), "{context}");
                for call in all_calls(dcel) {
                    calls += 1;
                    let context = format!("{context}\n{call}");
                    let (mut after, mut model) = (dcel.clone(), Model::of(dcel));
                    if step(&mut after, &mut model, call, &context) {
                        legal_pairs += usize::from(matches!(call, Call::SplitFace(..)));
                        if depth < 2 {
                            fresh.push((after, context));
                        }
                    } else {
                        assert_eq!(&after, dcel, "a refused call changed something, {context}");
                    }
                }
            }
            layer = fresh;
        }
    }
    // The size of the enumeration: another number means that part of it was skipped.
    assert_eq!((structures, calls, legal_pairs), (4_007, 561_358, 81_468));
}

#[test]
fn halves_of_every_kind_of_structure_can_be_split_and_joined_as_the_model_does() {
    for (name, dcel) in crate::common::zoo() {
        assert_eq!(violations(&dcel), [], "{name}");
        for call in all_calls(&dcel) {
            let (mut after, mut model) = (dcel.clone(), Model::of(&dcel));
            let accepted = step(&mut after, &mut model, call, &format!("{name}: {call}"));
            let mut recorded = dcel.clone();
            assert_eq!(call.apply(&mut recorded, &mut NoRecorder).is_ok(), accepted, "{name}: {call}");
            assert_eq!(recorded, after, "{name}: {call}");
        }
        let missing = h(dcel.half_edge_bound() as u32);
        assert!(!step(&mut dcel.clone(), &mut Model::of(&dcel), Call::SplitEdge(missing), name));
    }
}
