//! Every error of every edit, reached: nothing changes, and the next edit gives the ids it would have given
//! anyway.
//!
//! Not reachable from outside the crate: `SplitFaceError::DifferentCycles` needs a face with two cycles, which the
//! kernel's own edits never make (the plane does), and `TooMany` needs 2^31 elements. Both are reached by unit
//! tests in `src/topology/edit/mod.rs`.

use crate::common::script::{Call, Log, config, scripts};
use crate::common::{f, h, v, zoo};
use dcel_kit::HalfEdgeId;
use dcel_kit::topology::{
    Dcel, IdError, JoinEdgesError, JoinFacesError, NoRecorder, PolygonError, SplitEdgeError, SplitFaceError,
};
use proptest::prelude::*;
use std::collections::BTreeSet;
use std::fmt::Debug;

/// The names of the variants of `enum name` in its source.
fn variants(source: &str, name: &str) -> BTreeSet<String> {
    let body = source.split(&format!("pub enum {name} {{")).nth(1).expect("the enum").split("\n}").next().unwrap();
    let names = body.lines().filter_map(|line| line.strip_prefix("    "));
    let names = names.filter(|line| line.starts_with(|c: char| c.is_ascii_uppercase()));
    names.map(|line| line.split(|c: char| !c.is_alphanumeric()).next().unwrap().to_owned()).collect()
}

fn variant(error: &impl Debug) -> String {
    format!("{error:?}").split(|c: char| !c.is_alphanumeric()).next().unwrap().to_owned()
}

/// Refuses all calls of `errors`, and covers all variants of the enum but the `unreachable`.
fn covers<E: Debug>(source: &str, name: &str, errors: &[E], unreachable: &[&str]) {
    let reached: BTreeSet<String> =
        errors.iter().map(variant).chain(unreachable.iter().map(|&x| x.to_owned())).collect();
    assert_eq!(reached, variants(source, name), "variants of {name} that are reached, and those there are");
}

/// The error of a call that must be refused and must change nothing, not even the ids of later edits.
fn refused<T: Debug, E: Debug>(dcel: &Dcel, call: impl Fn(&mut Dcel) -> Result<T, E>) -> E {
    let mut after = dcel.clone();
    let error = call(&mut after).expect_err("this call must be refused");
    assert_eq!(&after, dcel, "refused with {error:?}, yet something changed");
    let next_ids = |mut d: Dcel| {
        let a = d.half_edges().find(|&a| d.cycle(a).count() > 3)?;
        let far = d.next(d.next(a));
        Some((d.split_face(a, far).unwrap(), d.split_edge(a).unwrap()))
    };
    assert_eq!(next_ids(after), next_ids(dcel.clone()), "ids after {error:?}");
    error
}

/// A hexagon cut in two, of which edge e7 and face f3 were removed again.
fn with_removed() -> Dcel {
    let mut dcel = Dcel::polygon(6).unwrap();
    dcel.split_face(h(0), h(6)).unwrap();
    let (a, _) = dcel.split_face(h(0), h(4)).unwrap();
    dcel.join_faces(a).unwrap();
    assert_eq!((a, dcel.has_face(f(3))), (h(14), false));
    dcel
}

const REMOVED: IdError = IdError::Removed(dcel_kit::Element::HalfEdge(HalfEdgeId::new(14)));

fn missing() -> IdError {
    IdError::OutOfRange { element: h(99).into(), count: 14, bound: 16 }
}

#[test]
fn split_face_refuses() {
    let dcel = with_removed();
    let call = |a, b| refused(&dcel, move |d| d.split_face(h(a), h(b)));
    let errors = [
        (call(14, 0), SplitFaceError::Id(REMOVED)),
        (call(0, 14), SplitFaceError::Id(REMOVED)),
        (call(99, 0), SplitFaceError::Id(missing())),
        (call(0, 99), SplitFaceError::Id(missing())),
        (call(0, 1), SplitFaceError::DifferentFaces { h1: h(0), f1: f(1), h2: h(1), f2: f(0) }),
        (call(0, 0), SplitFaceError::SameHalfEdge { h: h(0) }),
        (call(0, 2), SplitFaceError::NextOf { h1: h(0), h2: h(2) }),
        (call(2, 0), SplitFaceError::PrevOf { h1: h(2), h2: h(0) }),
    ];
    errors.iter().for_each(|(found, expected)| assert_eq!(found, expected));
    let texts: Vec<String> = errors[4..].iter().map(|(error, _)| error.to_string()).collect();
    assert_eq!(
        texts,
        [
            "h0 bounds f1, but h1 bounds f0: choose two half-edges of the same face",
            "h0 was given twice: the new edge needs two different corners of the face",
            "h2 is next of h0: their origins are the two ends of h0; choose corners further apart",
            "h0 is prev of h2: their origins are the two ends of h0; choose corners further apart",
        ]
    );
    let source = include_str!("../../src/topology/edit/split_face.rs");
    covers(source, "SplitFaceError", &errors.map(|(error, _)| error), &["DifferentCycles", "TooMany"]);
}

#[test]
fn split_edge_refuses() {
    let dcel = with_removed();
    let call = |a| refused(&dcel, move |d| d.split_edge(h(a)));
    let errors = [call(14), call(15), call(99)];
    assert_eq!(errors[0], SplitEdgeError::Id(REMOVED));
    assert_eq!(errors[2], SplitEdgeError::Id(missing()));
    covers(include_str!("../../src/topology/edit/split_edge.rs"), "SplitEdgeError", &errors, &["TooMany"]);
}

#[test]
fn join_faces_refuses() {
    let removed = with_removed();
    let mut loops = Dcel::polygon(2).unwrap();
    loops.join_edges(h(0)).unwrap();
    let path = zoo().into_iter().find(|(name, _)| *name == "a path of two edges").unwrap().1;
    let a = path.half_edges().next().unwrap();
    let errors = [
        refused(&removed, |d| d.join_faces(h(14))),
        refused(&removed, |d| d.join_faces(h(99))),
        refused(&path, |d| d.join_faces(a)),
        refused(&loops, |d| d.join_faces(h(0))),
        refused(&loops, |d| d.join_faces(h(1))),
    ];
    assert_eq!(errors[0], JoinFacesError::Id(REMOVED));
    assert_eq!(errors[1], JoinFacesError::Id(missing()));
    assert_eq!(errors[2], JoinFacesError::SameFace { h: a, face: path.face(a) });
    assert_eq!(errors[3..], [0, 1].map(|i| JoinFacesError::LastEdge { h: h(i) }));
    assert_eq!(errors[3].to_string(), "h0 is a loop and the only edge of both faces: without it no boundary is left");
    covers(include_str!("../../src/topology/edit/join_faces.rs"), "JoinFacesError", &errors, &[]);
}

#[test]
fn join_edges_refuses() {
    let removed = with_removed();
    let one_loop = Dcel::polygon(1).unwrap();
    let edge = zoo().into_iter().find(|(name, _)| *name == "one edge").unwrap().1;
    let a = edge.half_edges().next().unwrap();
    let busy = zoo().into_iter().find(|(name, _)| *name == "a loop round the end of a path").unwrap().1;
    let looped = busy.half_edges().find(|&a| busy.next(a) == a || busy.origin(a) == busy.destination(a)).unwrap();
    let errors = [
        refused(&removed, |d| d.join_edges(h(14))),
        refused(&removed, |d| d.join_edges(h(99))),
        refused(&one_loop, |d| d.join_edges(h(1))),
        refused(&edge, |d| d.join_edges(a)),
        refused(&removed, |d| d.join_edges(h(10))),
        refused(&busy, |d| d.join_edges(looped)),
        refused(&busy, |d| d.join_edges(looped.twin())),
    ];
    assert_eq!(errors[0], JoinEdgesError::Id(REMOVED));
    assert_eq!(errors[1], JoinEdgesError::Id(missing()));
    assert_eq!(errors[2], JoinEdgesError::Loop { h: h(1), vertex: v(0) });
    assert_eq!(errors[3], JoinEdgesError::NotDegreeTwo { h: a, vertex: edge.destination(a), degree: 1 });
    assert_eq!(errors[4], JoinEdgesError::NotDegreeTwo { h: h(10), vertex: v(0), degree: 3 });
    let vertex = busy.destination(looped);
    for (error, h) in errors[5..].iter().zip([looped, looped.twin()]) {
        assert_eq!(*error, JoinEdgesError::NotDegreeTwo { h, vertex, degree: busy.degree(vertex) });
    }
    covers(include_str!("../../src/topology/edit/join_edges.rs"), "JoinEdgesError", &errors, &[]);
}

#[test]
fn polygons_without_or_with_too_many_corners_are_refused() {
    let errors = [0, dcel_kit::ids::MAX_IDS / 2 + 1, usize::MAX].map(|n| Dcel::polygon(n).unwrap_err());
    assert_eq!(errors[0], PolygonError::NoCorner);
    covers(include_str!("../../src/topology/seed.rs"), "PolygonError", &errors, &[]);
}

#[test]
fn ids_of_every_kind_are_checked() {
    let dcel = with_removed();
    let mut joined = dcel.clone();
    joined.split_edge(h(0)).unwrap();
    let m = joined.join_edges(h(0)).unwrap();
    for (error, text) in [
        (dcel.check(h(14)), "h14 was removed earlier; ask the structure for a live element"),
        (dcel.check(f(3)), "f3 was removed earlier; ask the structure for a live element"),
        (dcel.check(h(14).edge()), "e7 was removed earlier; ask the structure for a live element"),
        (joined.check(m), "v6 was removed earlier; ask the structure for a live element"),
        (dcel.check(v(6)), "there is no v6: there are 6 vertices"),
        (dcel.check(f(4)), "there is no f4: there are 3 faces, up to f3"),
        (dcel.check(h(16).edge()), "there is no e8: there are 7 edges, up to e7"),
    ] {
        assert_eq!(error.unwrap_err().to_string(), text);
    }
    let live = [dcel.check(h(15 - 2)), dcel.check(v(5)), dcel.check(f(2)), dcel.check(h(0).edge())];
    assert_eq!(live, [Ok(()); 4]);
}

proptest! {
    #![proptest_config(config(300))]

    /// `can_...` says what the edit does, and a refused call leaves every bit and every later id alone.
    #[test]
    fn refused_calls_leave_no_trace((corners, ops) in scripts(40)) {
        let mut dcel = Dcel::polygon(corners as usize).unwrap();
        let mut without_refusals = dcel.clone();
        let mut log = Log::new(corners);
        for op in ops {
            let call = op.resolve(&dcel);
            let context = log.add(call);
            let can = match call {
                Call::SplitFace(a, b) => dcel.can_split_face(a, b).map_err(|e| e.to_string()),
                Call::SplitEdge(a) => dcel.can_split_edge(a).map_err(|e| e.to_string()),
                Call::JoinFaces(a) => dcel.can_join_faces(a).map_err(|e| e.to_string()),
                Call::JoinEdges(a) => dcel.can_join_edges(a).map_err(|e| e.to_string()),
            };
            let before = dcel.clone();
            let done = call.apply(&mut dcel, &mut NoRecorder);
            prop_assert_eq!(&can, &done, "{}", context);
            if done.is_ok() {
                call.apply(&mut without_refusals, &mut NoRecorder).unwrap();
            } else {
                prop_assert_eq!(&dcel, &before, "{}", context);
            }
            prop_assert_eq!(&dcel, &without_refusals, "{}", context);
        }
    }
}
