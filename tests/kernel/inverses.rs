//! An edit and its inverse give back the structure: the same elements under the same numbers, up to which
//! half-edge of a face or vertex is the stored one. And `compact`, which changes nothing but numbers.

use crate::common::script::{Call, Log, config, scripts};
use crate::common::{Random, h, v, zoo};
use dcel_kit::topology::{
    Dcel, IsomorphismOptions, Journal, NoRecorder, SplitFaceError, Table, View, isomorphic, isomorphic_with, violations,
};
use dcel_kit::{Element, FaceId, HalfEdgeId};
use proptest::prelude::*;

/// Asserts that both have the same elements and pointers under the same numbers, apart from representatives.
fn assert_restored(after: &Dcel, before: &Dcel, context: &str) {
    let everything = |_: Element| true;
    if let Err(difference) = isomorphic_with(after, before, &IsomorphismOptions::new().fixed(&everything)) {
        panic!("{context}: {difference}");
    }
    // `isomorphic` numbers what it compares itself; so the pointers once more, plainly.
    let plain = |d: &Dcel| {
        let halves = d.half_edges().map(|a| (a, d.origin(a), d.next(a), d.prev(a), d.face(a)));
        (halves.collect::<Vec<_>>(), d.vertices().collect::<Vec<_>>(), d.faces().collect::<Vec<_>>())
    };
    assert_eq!(plain(after), plain(before), "{context}");
    assert_eq!(violations(after), [], "{context}");
}

#[test]
fn join_faces_undoes_split_face() {
    for (name, before) in zoo() {
        for (h1, h2) in before.half_edges().flat_map(|a| before.half_edges().map(move |b| (a, b))) {
            let mut after = before.clone();
            let Ok((a, new)) = after.split_face(h1, h2) else { continue };
            assert!(isomorphic(&after, &before).is_err(), "{name}: a split must show");
            assert_eq!(after.join_faces(a), Ok(new), "{name}, {h1} {h2}");
            assert_restored(&after, &before, &format!("{name}, split_face {h1} {h2}, join_faces {a}"));
        }
    }
}

#[test]
fn join_edges_undoes_split_edge() {
    for (name, before) in zoo() {
        for a in before.half_edges() {
            let mut after = before.clone();
            let (m, c) = after.split_edge(a).unwrap();
            assert_eq!(after.join_edges(a), Ok(m), "{name}, {a}");
            assert_restored(&after, &before, &format!("{name}, split_edge {a}, join_edges {a}"));
            // From the other side the other half of the edge stays, so only the numbers differ.
            let mut after = before.clone();
            after.split_edge(a).unwrap();
            assert_eq!(after.join_edges(c.twin()), Ok(m), "{name}, {a}");
            assert_eq!(
                isomorphic(&after, &before).map(drop),
                Ok(()),
                "{name}, split_edge {a}, join_edges {}",
                c.twin()
            );
        }
    }
}

#[test]
fn split_face_undoes_join_faces_wherever_it_is_allowed_to() {
    let (mut undone, mut refused) = (0, 0);
    for (name, before) in zoo() {
        for a in before.half_edges() {
            let mut after = before.clone();
            let (n1, n2) = (before.next(a), before.next(a.twin()));
            let Ok(_) = after.join_faces(a) else { continue };
            let context = format!("{name}, join_faces {a}");
            // A face with one or two sides cannot come back: its corners are too close to each other.
            let sides = [a, a.twin()].map(|b| before.cycle(b).count());
            if sides.iter().all(|&n| n > 2) {
                undone += 1;
                let (b, _) = after.split_face(n2, n1).expect(&context);
                assert_eq!(b.edge(), a.edge(), "the freed slot comes back first, {context}");
                assert_eq!(after.next(b), n1, "{context}");
                assert_eq!(isomorphic(&after, &before).map(drop), Ok(()), "{context}, split_face {n2} {n1}");
            } else if sides[0] > 1 && sides[1] > 1 {
                refused += 1;
                let error = after.split_face(n2, n1).expect_err(&context);
                let near = matches!(error, SplitFaceError::NextOf { .. } | SplitFaceError::PrevOf { .. });
                assert!(near, "{context}: {error}");
            }
        }
    }
    assert!(undone > 20 && refused > 0, "{undone} {refused}");
}

#[test]
fn split_edge_undoes_join_edges() {
    let mut undone = 0;
    for (name, before) in zoo() {
        for a in before.half_edges() {
            let mut after = before.clone();
            let c = before.next(a);
            let Ok(gone) = after.join_edges(a) else { continue };
            undone += 1;
            let (m, d) = after.split_edge(a).unwrap();
            assert_eq!((m, d.edge()), (gone, c.edge()), "the freed slots come back first, {name}, {a}");
            assert_eq!(isomorphic(&after, &before).map(drop), Ok(()), "{name}, join_edges {a}, split_edge {a}");
        }
    }
    assert!(undone > 20, "{undone}");
}

proptest! {
    #![proptest_config(config(300))]

    #[test]
    fn undo_is_bit_for_bit_after_any_script((corners, ops) in scripts(40)) {
        let mut dcel = Dcel::polygon(corners as usize).unwrap();
        let (start, mut journal, mut log) = (dcel.clone(), Journal::new(), Log::new(corners));
        for op in ops {
            let call = op.resolve(&dcel);
            let context = log.add(call);
            let (before, mark) = (dcel.clone(), journal.len());
            let _ = call.apply(&mut dcel, &mut journal);
            let mut back = dcel.clone();
            back.undo(&mut journal.clone(), mark);
            prop_assert_eq!(&back, &before, "{}", context);
        }
        dcel.undo(&mut journal, 0);
        prop_assert_eq!(dcel, start, "{}", log.text());
    }

    #[test]
    fn compact_renumbers_and_changes_nothing_else((corners, ops) in scripts(60)) {
        let mut dcel = Dcel::polygon(corners as usize).unwrap();
        let mut log = Log::new(corners);
        for op in ops {
            let call = op.resolve(&dcel);
            log.add(call);
            // Removing f0 is legal in the kernel; here it stays, so that its number can be followed.
            if !matches!(call, Call::JoinFaces(a) if dcel.has_half_edge(a) && dcel.face(a) == FaceId::new(0)) {
                let _ = call.apply(&mut dcel, &mut NoRecorder);
            }
        }
        let context = log.text();
        let before = dcel.clone();
        let map = dcel.compact();
        prop_assert_eq!(violations(&dcel), [], "{}", context);
        let (vs, hs, fs) = (dcel.vertex_bound(), dcel.half_edge_bound(), dcel.face_bound());
        prop_assert_eq!((vs, hs, fs), (before.vertex_count(), before.half_edge_count(), before.face_count()));
        prop_assert_eq!((vs, hs, fs), (dcel.vertex_count(), dcel.half_edge_count(), dcel.face_count()), "{}", context);
        prop_assert_eq!(map.faces[FaceId::new(0)], Some(FaceId::new(0)), "{}", context);
        prop_assert_eq!(isomorphic(&before, &dcel).map(drop), Ok(()), "{}", context);

        // The renumbering is one such matching: all pointers, the stored representatives and parity included.
        let to = |a: HalfEdgeId| map.half_edge(a).unwrap();
        for a in before.half_edges() {
            let b = to(a);
            prop_assert_eq!(b.number() & 1, a.number() & 1, "{}", context);
            prop_assert_eq!((to(before.next(a)), to(before.prev(a))), (dcel.next(b), dcel.prev(b)), "{}", context);
            prop_assert_eq!(map.vertices[before.origin(a)], Some(dcel.origin(b)), "{}", context);
            prop_assert_eq!(map.faces[before.face(a)], Some(dcel.face(b)), "{}", context);
        }
        for x in before.vertices() {
            prop_assert_eq!(before.outgoing(x).map(to), dcel.outgoing(map.vertices[x].unwrap()), "{}", context);
        }
        for x in before.faces() {
            prop_assert_eq!(before.half_edge(x).map(to), dcel.half_edge(map.faces[x].unwrap()), "{}", context);
        }
        let dead_edges = (0..before.edge_bound() as u32).map(dcel_kit::EdgeId::new).filter(|&e| !before.has_edge(e));
        prop_assert!(dead_edges.clone().all(|e| map.edges[e].is_none()), "{}", context);
        prop_assert_eq!(dead_edges.count() + dcel.edge_count(), before.edge_bound());

        // Numbers follow the walk: the boundary of f0 comes first, in its order.
        let first: Vec<u32> = dcel.incident_edges(FaceId::new(0)).map(dcel_kit::EdgeId::number).collect();
        let mut met: Vec<u32> = Vec::new();
        first.into_iter().for_each(|e| if !met.contains(&e) { met.push(e) });
        prop_assert_eq!(&met, &(0..met.len() as u32).collect::<Vec<_>>(), "{}", context);

        let mut again = dcel.clone();
        let identity = again.compact();
        prop_assert_eq!(&again, &dcel, "a second compact changes nothing, {}", context);
        prop_assert!(identity.edges.iter().all(|(e, &to)| to == Some(e)), "{}", context);
        prop_assert!(identity.vertices.iter().all(|(x, &to)| to == Some(x)), "{}", context);
        prop_assert!(identity.faces.iter().all(|(x, &to)| to == Some(x)), "{}", context);
    }
}

#[test]
fn a_table_of_a_structure_with_removed_elements_shows_exactly_the_live_ones() {
    let (_, dcel) = zoo().pop().unwrap();
    let table = Table::from_view(&dcel);
    assert!(table.half_edges.iter().any(Option::is_none) && table.faces.iter().any(Option::is_none));
    assert_eq!(isomorphic(&dcel, &table).map(drop), Ok(()));
    let dead = (0..dcel.half_edge_bound() as u32).map(h).find(|&a| !dcel.has_half_edge(a)).unwrap();
    assert_eq!((View::next(&dcel, dead), View::origin(&dcel, dead), View::twin(&dcel, dead)), (None, None, None));
    assert_eq!(View::outgoing(&dcel, v(99)), None);
    let mut random = Random(1);
    assert_eq!(isomorphic(&dcel, &crate::common::renumbered(&table, &mut random)).map(drop), Ok(()));
}
