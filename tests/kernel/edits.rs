//! Every promise that the documentation of an edit makes, on every kind of small structure and for all arguments,
//! and the journal: its steps, its changes, its undo.

use crate::common::script::{Call, Log, all_calls, config, scripts};
use crate::common::{f, h, zoo};
use dcel_kit::topology::{Change, Dcel, Journal, Slot, Table};
use dcel_kit::{Element, HalfEdgeId};
use proptest::prelude::*;

/// All pairs (structure, half-edge) for which the edit is accepted, with the structure before it.
fn each_half_edge(mut check: impl FnMut(&str, &Dcel, HalfEdgeId)) {
    for (name, dcel) in zoo() {
        dcel.half_edges().for_each(|a| check(&format!("{name}, {a}"), &dcel, a));
    }
}

fn halves(walk: impl Iterator<Item = HalfEdgeId>) -> Vec<HalfEdgeId> {
    walk.collect()
}

#[test]
fn split_face_puts_the_new_face_on_the_left_of_the_new_half_edge() {
    let mut accepted = 0;
    for (name, before) in zoo() {
        for (h1, h2) in before.half_edges().flat_map(|a| before.half_edges().map(move |b| (a, b))) {
            let context = format!("{name}, split_face {h1} {h2}");
            let mut after = before.clone();
            let Ok((a, new)) = after.split_face(h1, h2) else { continue };
            accepted += 1;
            let (old, b) = (before.face(h1), a.twin());
            assert!(!before.has_half_edge(a) && !before.has_face(new), "{context}: not new");
            assert_eq!((after.origin(a), after.origin(b)), (before.origin(h1), before.origin(h2)), "{context}");
            assert_eq!((after.face(a), after.face(b)), (new, old), "{context}");
            assert_eq!((after.half_edge(new), after.half_edge(old)), (Some(a), Some(b)), "{context}");
            // The cycle through h2 up to h1 is the new face's, the rest stays.
            let around = halves(before.cycle(h1));
            let (kept, moved) = around.split_at(around.iter().position(|&x| x == h2).unwrap());
            assert_eq!(halves(after.cycle(a)), [&[a], moved].concat(), "{context}");
            assert_eq!(halves(after.cycle(b)), [&[b], kept].concat(), "{context}");
            for v in before.vertices() {
                assert_eq!(after.outgoing(v), before.outgoing(v), "{context}: {v}.outgoing");
            }
            for face in before.faces().filter(|&x| x != old) {
                assert_eq!(after.half_edge(face), before.half_edge(face), "{context}: {face}.half_edge");
            }
        }
    }
    assert!(accepted > 50, "{accepted}");
}

#[test]
fn split_edge_keeps_the_origin_of_its_argument_and_gives_the_twin_the_new_vertex() {
    each_half_edge(|context, before, a| {
        let mut after = before.clone();
        let (m, c) = after.split_edge(a).unwrap();
        assert!(!before.has_vertex(m) && !before.has_half_edge(c), "{context}: not new");
        assert_eq!((after.origin(a), after.destination(a)), (before.origin(a), m), "{context}");
        assert_eq!((after.next(a), after.origin(c)), (c, m), "{context}");
        assert_eq!(after.destination(c), before.destination(a), "{context}");
        assert_eq!((after.face(c), after.face(c.twin())), (before.face(a), before.face(a.twin())), "{context}");
        assert_eq!(after.degree(m), 2, "{context}");
        for face in before.faces() {
            assert_eq!(after.half_edge(face), before.half_edge(face), "{context}: {face}.half_edge");
        }
    });
}

#[test]
fn join_faces_keeps_the_face_of_the_twin_and_its_half_edges_in_order() {
    let mut accepted = 0;
    each_half_edge(|context, before, a| {
        let mut after = before.clone();
        let Ok(gone) = after.join_faces(a) else { return };
        accepted += 1;
        let (b, kept) = (a.twin(), before.face(a.twin()));
        assert_eq!(gone, before.face(a), "{context}");
        assert!(!after.has_face(gone) && !after.has_half_edge(a) && !after.has_half_edge(b), "{context}");
        let expected = [&halves(before.cycle(a))[1..], &halves(before.cycle(b))[1..]].concat();
        assert_eq!(halves(after.cycle(expected[0])), expected, "{context}");
        assert!(expected.iter().all(|&x| after.face(x) == kept), "{context}");
        let stays = before.half_edge(kept).filter(|&x| x != b);
        assert!(stays.is_none() || after.half_edge(kept) == stays, "{context}: boundary moved without need");
    });
    assert!(accepted > 40, "{accepted}");
}

#[test]
fn join_edges_leads_its_argument_on_to_where_the_next_one_led() {
    let mut accepted = 0;
    each_half_edge(|context, before, a| {
        let mut after = before.clone();
        let Ok(gone) = after.join_edges(a) else { return };
        accepted += 1;
        let c = before.next(a);
        assert_eq!(gone, before.destination(a), "{context}");
        assert!(!after.has_vertex(gone) && !after.has_half_edge(c) && !after.has_half_edge(c.twin()), "{context}");
        assert_eq!((after.origin(a), after.destination(a)), (before.origin(a), before.destination(c)), "{context}");
        let without = |d: &Dcel, x| halves(d.cycle(x).filter(|y| y.edge() != c.edge()));
        assert_eq!(halves(after.cycle(a)), without(before, a), "{context}");
        assert_eq!(halves(after.cycle(a.twin())), without(before, a.twin()), "{context}");
    });
    assert!(accepted > 20, "{accepted}");
}

#[test]
fn the_first_split_of_a_square_is_the_one_of_the_handout() {
    // h0 v0->v1, h2 v1->v2, h4 v2->v3, h6 v3->v0 inside f1; the new edge runs from v0 to v2.
    let mut square = Dcel::polygon(4).unwrap();
    let (a, new) = square.split_face(h(0), h(4)).unwrap();
    assert_eq!((a, new), (h(8), f(2)));
    assert_eq!(halves(square.cycle(h(8))), [h(8), h(4), h(6)]);
    assert_eq!(halves(square.cycle(h(9))), [h(9), h(0), h(2)]);
}

#[test]
fn a_journal_names_the_steps_of_the_handout_in_order() {
    let names = |call: Call| {
        let mut journal = Journal::new();
        let mut dcel = Dcel::polygon(5).unwrap();
        dcel.split_edge(h(0)).unwrap();
        call.apply(&mut dcel, &mut journal).unwrap();
        let numbers: Vec<u32> = journal.steps().iter().map(|step| step.number).collect();
        assert_eq!(numbers, (1..=numbers.len() as u32).collect::<Vec<_>>(), "{call}");
        journal.steps().iter().map(|step| step.what).collect::<Vec<_>>()
    };
    assert_eq!(
        names(Call::SplitFace(h(2), h(6))),
        [
            "Create a new face for the second half of the split.",
            "Create two new half-edges for the splitting edge.",
            "Insert the new half-edges into the cyclic lists.",
            "Make all half-edges point to the right face.",
            "Make both faces point to one of their half-edges.",
        ]
    );
    assert_eq!(names(Call::SplitEdge(h(2))).len(), 3);
    assert_eq!(names(Call::JoinFaces(h(2))).len(), 4);
    assert_eq!(names(Call::JoinEdges(h(0))).len(), 3);
}

#[test]
fn the_other_edits_of_the_kernel_have_all_of_their_steps() {
    let mut dcel = Dcel::polygon(5).unwrap();
    let mut count = |edit: &mut dyn FnMut(&mut Dcel, &mut Journal)| {
        let mut journal = Journal::new();
        edit(&mut dcel, &mut journal);
        let numbers: Vec<u32> = journal.steps().iter().map(|step| step.number).collect();
        assert_eq!(numbers, (1..=numbers.len() as u32).collect::<Vec<_>>());
        assert!(journal.steps().iter().all(|step| step.what.ends_with('.')), "{:?}", journal.steps());
        numbers.len()
    };
    let mut new = h(0);
    assert_eq!(count(&mut |dcel, rec| new = dcel.split_vertex_with(h(0), h(9), rec).unwrap().0), 6);
    assert_eq!(count(&mut |dcel, rec| _ = dcel.join_vertices_with(new, rec).unwrap()), 4);
    assert_eq!(count(&mut |dcel, rec| new = dcel.split_face_with(h(0), h(4), rec).unwrap().0), 5);
    assert_eq!(count(&mut |dcel, rec| dcel.flip_edge_with(new, rec).unwrap()), 4);
}

/// Writes one change into a table, after checking that its old value is what the table holds.
fn replay(table: &mut Table, change: &Change, context: &str) {
    fn grow<T: Default>(rows: &mut Vec<Option<T>>, i: usize, reused: bool, context: &str) {
        assert_eq!(reused, i < rows.len(), "reused, {context}");
        rows.resize_with(rows.len().max(i + 1), || None);
        assert!(rows[i].is_none(), "added twice, {context}");
        rows[i] = Some(T::default());
    }
    match *change {
        Change::Added { element, reused } => match element {
            Element::Vertex(x) => grow(&mut table.vertices, x.index(), reused, context),
            Element::Face(x) => grow(&mut table.faces, x.index(), reused, context),
            Element::Edge(e) => {
                for a in e.half_edges() {
                    grow(&mut table.half_edges, a.index(), reused, context);
                    crate::common::row(table, a).twin = Some(a.twin());
                }
            }
            Element::HalfEdge(_) => panic!("half-edges come in pairs, {context}"),
        },
        Change::Removed { element } => match element {
            Element::Vertex(x) => table.vertices[x.index()] = None,
            Element::Face(x) => table.faces[x.index()] = None,
            Element::Edge(e) => e.half_edges().iter().for_each(|a| table.half_edges[a.index()] = None),
            Element::HalfEdge(_) => panic!("half-edges go in pairs, {context}"),
        },
        Change::Write { slot, old, new } => {
            let vertex =
                |to: Option<Element>| to.map(|to| if let Element::Vertex(x) = to { x } else { panic!("{context}") });
            let half =
                |to: Option<Element>| to.map(|to| if let Element::HalfEdge(x) = to { x } else { panic!("{context}") });
            let face =
                |to: Option<Element>| to.map(|to| if let Element::Face(x) = to { x } else { panic!("{context}") });
            let found: Option<Element> = match slot {
                Slot::Origin(a) => {
                    std::mem::replace(&mut crate::common::row(table, a).origin, vertex(new)).map(Into::into)
                }
                Slot::Next(a) => std::mem::replace(&mut crate::common::row(table, a).next, half(new)).map(Into::into),
                Slot::Prev(a) => std::mem::replace(&mut crate::common::row(table, a).prev, half(new)).map(Into::into),
                Slot::Face(a) => std::mem::replace(&mut crate::common::row(table, a).face, face(new)).map(Into::into),
                Slot::Outgoing(x) => {
                    let row = table.vertices[x.index()].as_mut().unwrap();
                    std::mem::replace(&mut row.outgoing, half(new)).map(Into::into)
                }
                Slot::HalfEdge(x) => {
                    let row = table.faces[x.index()].as_mut().unwrap();
                    std::mem::replace(&mut row.half_edge, half(new)).map(Into::into)
                }
            };
            assert_eq!(found, old, "{change}, {context}");
        }
    }
}

#[test]
fn a_journal_holds_every_change_and_undo_restores_every_bit() {
    for (name, before) in zoo() {
        for call in all_calls(&before) {
            let context = format!("{name}, {call}");
            let (mut plain, mut watched, mut journal) = (before.clone(), before.clone(), Journal::new());
            let done = call.apply(&mut plain, &mut dcel_kit::topology::NoRecorder);
            assert_eq!(call.apply(&mut watched, &mut journal), done, "{context}");
            assert_eq!(watched, plain, "watching changed the edit, {context}");
            assert_eq!(journal.is_empty(), done.is_err(), "{context}");
            let mut table = Table::from_view(&before);
            let by_steps: Vec<&Change> = (0..journal.steps().len()).flat_map(|i| journal.changes_of_step(i)).collect();
            assert_eq!(by_steps, journal.changes().iter().collect::<Vec<_>>(), "{context}");
            by_steps.iter().for_each(|change| replay(&mut table, change, &context));
            assert_eq!(table, Table::from_view(&watched), "{context}");
            watched.undo(&mut journal, 0);
            assert_eq!(watched, before, "undo, {context}");
            assert!(journal.is_empty() && journal.steps().is_empty(), "{context}");
        }
    }
}

proptest! {
    #![proptest_config(config(300))]

    #[test]
    fn undo_goes_back_to_any_mark_and_the_same_calls_then_give_the_same_ids((corners, ops) in scripts(30), cut in any::<u16>()) {
        let mut dcel = Dcel::polygon(corners as usize).unwrap();
        let (mut log, mut journal) = (Log::new(corners), Journal::new());
        let mut states = vec![(dcel.clone(), 0)];
        let mut calls = Vec::new();
        for op in ops {
            let call = op.resolve(&dcel);
            log.add(call);
            let _ = call.apply(&mut dcel, &mut journal);
            calls.push(call);
            states.push((dcel.clone(), journal.len()));
        }
        let context = log.text();
        let last = dcel.clone();
        let back = cut as usize % states.len();
        let (state, mark) = &states[back];
        dcel.undo(&mut journal, *mark);
        prop_assert_eq!(&dcel, state, "undo to call {}, {}", back, context);
        prop_assert_eq!(journal.len(), *mark, "{}", context);
        for call in &calls[back..] {
            let _ = call.apply(&mut dcel, &mut journal);
        }
        prop_assert_eq!(&dcel, &last, "redo from call {}, {}", back, context);
        dcel.undo(&mut journal, 0);
        prop_assert_eq!(&dcel, &states[0].0, "{}", context);
    }
}
