//! Promise: vertices, edges and segments can be put in and taken out wherever faces, rings and components are; after
//! each call the subdivision is what its edges cut out of the plane, and a refused call changes nothing.

use crate::tracer::{Numbers, assert_traced};
use dcel_kit::plane::predicates::orientation;
use dcel_kit::plane::{
    InsertDanglingEdgeError, InsertEdgeError, InsertSegmentError, InsertVertexError, JoinFacesError, PlanarView, Point,
    RemoveEdgeError, RemoveVertexError, SplitEdgeError, Subdivision,
};
use dcel_kit::topology::{IdError, InnerComponent, Journal, Table, components, violations};
use dcel_kit::{EdgeId, Element, FaceId, HalfEdgeId, VertexId};
use std::cmp::Ordering;

fn v(number: u32) -> VertexId {
    VertexId::new(number)
}

fn f(number: u32) -> FaceId {
    FaceId::new(number)
}

fn point(x: i32, y: i32) -> Point {
    Point::new(f64::from(x), f64::from(y))
}

/// A triangle with a square in it, an isolated vertex in the square, an edge beside the square, a lone vertex outside.
fn start() -> Subdivision {
    start_at(0)
}

fn start_at(shift: i32) -> Subdivision {
    let points = [(0, 0), (24, 0), (0, 24), (3, 3), (7, 3), (7, 7), (3, 7), (5, 5), (10, 3), (12, 5), (30, 30)];
    let edges = [[0, 1], [1, 2], [2, 0], [3, 4], [4, 5], [5, 6], [6, 3], [8, 9]];
    Subdivision::from_graph(&points.map(|(x, y)| point(x + shift, y + shift)), &edges).unwrap()
}

fn assert_right(s: &Subdivision, context: &str) {
    let (vs, es, fs) = (s.vertex_count() as i64, s.edge_count() as i64, s.face_count() as i64);
    assert_eq!(violations(s), [], "{context}");
    assert_eq!(vs - es + fs, 1 + components(s).count() as i64, "{context}: Euler");
    assert_traced(s, context);
}

/// From here on crossings are rounded to multiples of 2^-40, which the tracer takes as whole numbers.
const FAR: i32 = 4096;

/// One call with random arguments, as a line of a script, and whether it was accepted.
fn one_random_edit(s: &mut Subdivision, numbers: &mut Numbers, journal: &mut Journal) -> (String, bool) {
    let vertices: Vec<VertexId> = s.vertices().collect();
    let edges: Vec<EdgeId> = s.edges().collect();
    let size = 24;
    let place = |numbers: &mut Numbers| {
        let [x, y] = [(); 2].map(|()| FAR + 2 * numbers.below(size) as i32);
        point(x, y)
    };
    let vertex = |numbers: &mut Numbers| vertices.get(numbers.below(vertices.len().max(1))).copied().unwrap_or(v(0));
    let edge = |numbers: &mut Numbers| edges.get(numbers.below(edges.len().max(1))).copied().unwrap_or(EdgeId::new(0));
    match numbers.below(12) {
        0 | 1 => {
            let p = place(numbers);
            (format!("insert_vertex {p}"), s.insert_vertex_with(p, journal).is_ok())
        }
        2 => {
            let (p, faces) = (place(numbers), s.faces().collect::<Vec<_>>());
            let face = faces[numbers.below(faces.len())];
            (format!("insert_vertex_in {face} {p}"), s.insert_vertex_in_with(face, p, journal).is_ok())
        }
        3..=6 => {
            let (a, b) = (vertex(numbers), vertex(numbers));
            (format!("insert_edge {a} {b}"), s.insert_edge_with(a, b, journal).is_ok())
        }
        7 => {
            let (a, p) = (vertex(numbers), place(numbers));
            (format!("insert_dangling_edge {a} {p}"), s.insert_dangling_edge_with(a, p, journal).is_ok())
        }
        8 | 9 => {
            let e = edge(numbers);
            (format!("remove_edge {e}"), s.remove_edge_with(e, journal).is_ok())
        }
        10 => {
            let a = vertex(numbers);
            (format!("remove_vertex {a}"), s.remove_vertex_with(a, journal).is_ok())
        }
        _ => {
            let (p, q) = (place(numbers), place(numbers));
            (format!("insert_segment {p} {q}"), s.insert_segment_with(p, q, journal).is_ok())
        }
    }
}

#[test]
fn random_scripts_keep_to_what_the_edges_cut_out() {
    let mut done = [0; 8];
    let kinds = [
        "insert_vertex ",
        "insert_vertex_in",
        "insert_edge",
        "insert_dangling_edge",
        "remove_edge",
        "remove_vertex",
        "insert_segment",
        "set_hole",
    ];
    for seed in 1..260 {
        let mut numbers = Numbers::new(seed);
        let mut s = match seed % 3 {
            0 => Subdivision::new(),
            1 => start_at(FAR),
            _ => Subdivision::polygon(&[(4, 4), (40, 6), (44, 40), (2, 44)].map(|(x, y)| point(FAR + x, FAR + y)))
                .unwrap(),
        };
        let mut script = String::new();
        for _ in 0..40 {
            if numbers.below(8) == 0 {
                let faces: Vec<_> = s.faces().collect();
                let (face, hole) = (faces[numbers.below(faces.len())], numbers.below(2) == 0);
                script.push_str(&format!("set_hole {face} {hole}\n"));
                done[7] += usize::from(s.set_hole(face, hole).is_some());
            }
            let before = s.clone();
            let mut journal = Journal::new();
            let (line, accepted) = one_random_edit(&mut s, &mut numbers, &mut journal);
            script.push_str(&line);
            script.push_str(if accepted { "\n" } else { "   # refused\n" });
            let context = format!("seed {seed}\n{script}");
            if accepted {
                done[kinds.iter().position(|k| line.starts_with(k)).unwrap()] += 1;
                assert_right(&s, &context);
                // The journal tells all of it: replayed on a table it gives the same links, undone the old ones.
                let mut table = Table::from_view(before.topology());
                journal.changes().iter().for_each(|change| table.apply(change));
                assert_eq!(table.half_edges, Table::from_view(s.topology()).half_edges, "{context}replay");
                let mut links = s.topology().clone();
                links.undo(&mut journal, 0);
                assert!(links == *before.topology(), "{context}undo");
            } else {
                assert!(s == before, "{context}refused, but changed");
                assert!(journal.is_empty(), "{context}refused, but recorded");
            }
        }
    }
    assert!(done.iter().all(|&n| n > 100), "too few of a kind: {done:?}");
}

#[test]
fn inserting_and_removing_undo_each_other() {
    for seed in 1..150 {
        let mut numbers = Numbers::new(seed);
        let mut s = start();
        for _ in 0..25 {
            let vertices: Vec<VertexId> = s.vertices().collect();
            let (a, b) = (vertices[numbers.below(vertices.len())], vertices[numbers.below(vertices.len())]);
            let before = crate::tracer::faces_of(&s);
            if let Ok(new) = s.insert_edge(a, b) {
                let mut back = s.clone();
                let gone = back.remove_edge(new.half_edge.edge()).unwrap();
                assert_eq!(gone.is_some(), new.new_face.is_some(), "seed {seed}: {a} {b}");
                assert_eq!(shapes(&crate::tracer::faces_of(&back)), shapes(&before), "seed {seed}: {a} {b}");
            }
        }
    }
}

/// The faces without their numbers.
fn shapes(
    (outer, faces): &(crate::tracer::Face, std::collections::BTreeMap<crate::tracer::Face, u32>),
) -> Vec<crate::tracer::Face> {
    std::iter::once(outer).chain(faces.keys()).cloned().collect()
}

#[test]
fn each_kind_of_insertion_does_what_it_says() {
    let mut s = start();
    // Ring and ring.
    let join = s.insert_edge(v(4), v(8)).unwrap();
    assert_eq!((join.new_face, s.inner_components(f(1)).len()), (None, 1));
    assert_right(&s, "ring to ring");
    // Ring and boundary.
    assert_eq!(s.insert_edge(v(0), v(3)).unwrap().new_face, None);
    assert!(s.inner_components(f(1)).is_empty());
    assert_right(&s, "ring to boundary");
    // A second join cuts a face off; the vertex in the square stays where it is.
    let cut = s.insert_edge(v(9), v(1)).unwrap();
    assert!(cut.new_face.is_some());
    assert_right(&s, "split");
    let square = s.face(s.find_half_edge(v(3), v(4)).unwrap());
    assert_eq!(s.inner_components(square), [InnerComponent::Isolated(v(7))]);
    // Isolated vertices: to a corner, and each other.
    s.insert_edge(v(7), v(5)).unwrap();
    assert!(s.inner_components(square).is_empty() && s.degree(v(7)) == 1);
    let lone = s.insert_vertex(point(40, 40)).unwrap();
    let outer = s.inner_components(f(0)).len();
    s.insert_edge(lone, v(10)).unwrap();
    assert_eq!(s.inner_components(f(0)).len(), outer - 1);
    assert_right(&s, "isolated");
    // A face cut off takes the rings that lie in it, and the hole flag.
    let mut s = start();
    s.set_hole(f(1), true);
    let new = s.insert_segment(point(0, 8), point(16, 8)).unwrap();
    assert_eq!((new.half_edges.len(), new.crossings.len()), (1, 0));
    assert_right(&s, "cut");
    let [above, below] = [new.half_edges[0], new.half_edges[0].twin()].map(|h| s.face(h));
    assert_eq!((s.inner_components(above).len(), s.inner_components(below).len()), (0, 2));
    assert!(s.is_hole(above) && s.is_hole(below));
}

#[test]
fn a_segment_walks_through_everything() {
    let mut s = start();
    // From outside through the triangle, the square, its lone vertex, the edge beside it, and out again.
    let cut = s.insert_segment(point(-4, 5), point(30, 5)).unwrap();
    assert_right(&s, "through");
    let places: Vec<Point> = cut.half_edges.iter().map(|&h| s.point(s.destination(h))).collect();
    assert_eq!(places, [(0, 5), (3, 5), (5, 5), (7, 5), (12, 5), (19, 5), (30, 5)].map(|(x, y)| point(x, y)));
    assert_eq!((cut.crossings.len(), cut.moved.len()), (4, 0));
    // Again, and backwards: everything is there.
    let before = s.clone();
    let again = s.insert_segment(point(30, 5), point(-4, 5)).unwrap();
    assert_eq!(again.half_edges.iter().rev().map(|h| h.twin()).collect::<Vec<_>>(), cut.half_edges);
    assert_eq!(s, before);
    // Inside an existing edge: only the ends are new.
    let inside = s.insert_segment(point(1, 5), point(2, 5)).unwrap();
    assert_eq!((inside.half_edges.len(), s.edge_count()), (1, before.edge_count() + 2));
    assert_right(&s, "inside an edge");
    // Rounded crossings: random segments over each other, all invariants after each.
    for seed in 1..40 {
        let mut numbers = Numbers::new(seed);
        let mut s = Subdivision::new();
        let (mut refused, mut moved) = (0, 0);
        for i in 0..14 {
            let [p, q] =
                [(); 2].map(|()| Point::new(numbers.below(1000) as f64 / 10.0, numbers.below(1000) as f64 / 10.0));
            let before = s.clone();
            match s.insert_segment(p, q) {
                Ok(done) => {
                    moved += done.moved.len();
                    assert!(done.moved.iter().all(|m| m.1 < 2e-14), "seed {seed}: {done:?}");
                    assert_eq!(s.point(s.origin(done.half_edges[0])), p);
                    assert_eq!(s.point(s.destination(done.half_edges[done.half_edges.len() - 1])), q);
                }
                Err(_) => {
                    refused += 1;
                    assert!(s == before, "seed {seed}: refused, but changed");
                }
            }
            assert_eq!(s.geometry_violations(), [], "seed {seed}, segment {i}");
            assert_eq!(violations(&s), [], "seed {seed}, segment {i}");
        }
        assert!(refused == 0 && moved > 3, "seed {seed}: {refused} refused, {moved} moved");
    }
}

#[test]
fn every_refusal_has_its_name_and_changes_nothing() {
    let s = start();
    let refused = |name: &str, call: &dyn Fn(&mut Subdivision) -> String, expected: &str| {
        let mut changed = s.clone();
        assert_eq!(call(&mut changed), expected, "{name}");
        assert!(changed == s, "{name}: refused, but changed");
    };
    let vertex = |p: Point| move |s: &mut Subdivision| s.insert_vertex(p).unwrap_err().to_string();
    refused("occupied", &vertex(point(5, 5)), "v7 is at (5, 5) already");
    refused(
        "coordinate",
        &vertex(Point::new(f64::NAN, 0.0)),
        "the new vertex: x is NaN: coordinates must be finite numbers",
    );
    let inside = |face: u32, p: Point| move |s: &mut Subdivision| s.insert_vertex_in(f(face), p).unwrap_err();
    let at = |face: u32, p, at: Option<Element>| InsertVertexError::NotInFace { face: f(face), point: p, at };
    assert_eq!(inside(1, point(4, 4))(&mut s.clone()), at(1, point(4, 4), None));
    assert_eq!(inside(0, point(4, 4))(&mut s.clone()), at(0, point(4, 4), None));
    assert_eq!(inside(2, point(5, 5))(&mut s.clone()), at(2, point(5, 5), Some(v(7).into())));
    assert!(matches!(
        inside(1, point(5, 3))(&mut s.clone()),
        InsertVertexError::NotInFace { at: Some(Element::HalfEdge(_)), .. }
    ));
    assert_eq!(
        inside(9, point(5, 3))(&mut s.clone()),
        IdError::OutOfRange { element: f(9).into(), count: 3, bound: 3 }.into()
    );
    assert!(
        s.clone().insert_vertex_in(f(1), point(2, 2)).is_ok() && s.clone().insert_vertex_in(f(0), point(31, 2)).is_ok()
    );

    let edge = |a: u32, b: u32| s.clone().insert_edge(v(a), v(b)).unwrap_err();
    assert_eq!(edge(3, 3), InsertEdgeError::SameVertex { vertex: v(3) });
    let existing = HalfEdgeId::new(6);
    assert_eq!(edge(3, 4), InsertEdgeError::EdgeExists { from: v(3), to: v(4), existing });
    assert_eq!(edge(3, 5), InsertEdgeError::ThroughVertex { from: v(3), to: v(5), vertex: v(7) });
    assert_eq!(edge(3, 8), InsertEdgeError::ThroughVertex { from: v(3), to: v(8), vertex: v(4) });
    assert!(matches!(edge(0, 5), InsertEdgeError::ThroughVertex { vertex, .. } if vertex == v(3)));
    assert!(matches!(edge(0, 10), InsertEdgeError::ThroughVertex { .. } | InsertEdgeError::Crosses { .. }));
    assert!(s.clone().insert_edge(v(2), v(10)).is_ok());
    assert!(matches!(edge(7, 8), InsertEdgeError::Crosses { .. }));
    assert!(matches!(edge(0, 99), InsertEdgeError::Id(IdError::OutOfRange { .. })));

    let antenna = |a: u32, p: Point| s.clone().insert_dangling_edge(v(a), p).unwrap_err();
    let in_the_way =
        |a: u32, p: Point, o: Element| InsertDanglingEdgeError::InTheWay { vertex: v(a), point: p, obstacle: o };
    assert_eq!(antenna(0, point(0, 0)), in_the_way(0, point(0, 0), v(0).into()));
    assert_eq!(antenna(0, point(4, 4)), in_the_way(0, point(4, 4), v(3).into()));
    assert_eq!(antenna(0, point(5, 0)), in_the_way(0, point(5, 0), HalfEdgeId::new(0).into()));
    assert!(matches!(
        antenna(0, point(5, 3)),
        InsertDanglingEdgeError::InTheWay { obstacle: Element::HalfEdge(_), .. }
    ));
    assert_eq!(antenna(7, point(7, 7)), in_the_way(7, point(7, 7), v(5).into()));
    assert!(matches!(antenna(0, Point::new(0.0, 1e300)), InsertDanglingEdgeError::Coordinate(_)));
    assert!(matches!(antenna(99, point(0, 1)), InsertDanglingEdgeError::Id(_)));

    let segment = |p: Point, q: Point| s.clone().insert_segment(p, q).unwrap_err();
    assert_eq!(segment(point(1, 1), point(1, 1)), InsertSegmentError::ZeroLength { at: point(1, 1) });
    assert!(matches!(segment(point(1, 1), Point::new(0.0, f64::INFINITY)), InsertSegmentError::Coordinate(_)));

    let gone = EdgeId::new(99);
    assert_eq!(
        s.clone().remove_edge(gone),
        Err(RemoveEdgeError::Id(IdError::OutOfRange { element: gone.into(), count: 8, bound: 8 }))
    );
    let mut with_hole = s.clone();
    with_hole.set_hole(f(2), true);
    let before = with_hole.clone();
    let faces = JoinFacesError::HoleAndDomain { hole: f(2), face: f(1) };
    let error = RemoveEdgeError::Faces { edge: EdgeId::new(3), error: faces };
    assert_eq!(with_hole.remove_edge(EdgeId::new(3)), Err(error));
    assert!(matches!(with_hole.remove_vertex(v(4)), Err(RemoveVertexError::Edge { vertex, .. }) if vertex == v(4)));
    assert!(with_hole == before);
    assert!(matches!(with_hole.remove_vertex(v(77)), Err(RemoveVertexError::Id(_))));
}

#[test]
fn a_vertex_goes_with_its_edges_or_not_at_all() {
    // A wheel; a spoke further on borders a hole face, so the last edge but one is refused after others went.
    let rim: Vec<Point> = [(0, 0), (8, -4), (16, 0), (16, 8), (8, 12), (0, 8)].map(|(x, y)| point(x, y)).to_vec();
    let points = [&rim[..], &[point(8, 4)]].concat();
    let edges: Vec<[u32; 2]> = (0..6).map(|i| [i, (i + 1) % 6]).chain((0..6).map(|i| [6, i])).collect();
    let wheel = Subdivision::from_graph(&points, &edges).unwrap();
    let mut s = wheel.clone();
    assert_eq!(s.remove_vertex(v(6)).unwrap().len(), 5);
    assert_right(&s, "no hub");
    assert_eq!((s.vertex_count(), s.edge_count(), s.face_count()), (6, 6, 2));
    // Of two holes side by side one goes before the call is refused.
    let holes = (1..7).flat_map(|face| [vec![face], vec![face, face % 6 + 1], vec![face, (face + 1) % 6 + 1]]);
    for holes in holes {
        let mut s = wheel.clone();
        // A removed vertex, so that the refused call takes and gives back a used slot.
        let spare = s.insert_vertex(point(50, 50)).unwrap();
        s.remove_vertex(spare).unwrap();
        for &face in &holes {
            s.set_hole(f(face), true);
        }
        let before = s.clone();
        assert!(s.remove_vertex(v(6)).is_err(), "holes {holes:?}");
        assert!(s == before, "holes {holes:?}: refused, but changed");
    }
}

#[test]
fn an_edge_cannot_be_bent_onto_a_vertex() {
    let points = [(0, 0), (8, 0), (4, 8), (4, 1)].map(|(x, y)| point(x, y));
    let mut s = Subdivision::from_graph(&points, &[[0, 1], [1, 2], [2, 0]]).unwrap();
    let h = HalfEdgeId::new(0);
    let error = SplitEdgeError::WouldCross { h, point: point(4, 1), obstacle: v(3).into() };
    assert_eq!(s.split_edge(h, point(4, 1)), Err(error));
}

#[test]
fn a_segment_that_would_bend_an_edge_over_something_is_refused_whole() {
    // Vertices on both sides of an edge, as close to it as doubles can be: between them there is hardly a place for a
    // crossing, and with nearly all of those that there are the edge would bend over one of the vertices.
    let ends = [point(0, 0), point(3, 1)];
    let mut points = ends.to_vec();
    for i in 0..16 {
        let x = 1.2 + f64::from(i) / 32.0;
        let y = x / 3.0;
        match orientation(ends[0], ends[1], Point::new(x, y)) {
            Ordering::Less => points.extend([Point::new(x, y), Point::new(x, y.next_up())]),
            Ordering::Greater => points.extend([Point::new(x, y), Point::new(x, y.next_down())]),
            Ordering::Equal => {}
        }
    }
    let map = Subdivision::from_graph(&points, &[[0, 1]]).unwrap();
    let (mut refused, mut done) = (0, 0);
    for i in 0..100 {
        let x = 1.1 + f64::from(i) / 147.0;
        let mut s = map.clone();
        match s.insert_segment(Point::new(x, 0.0), Point::new(x, 1.5)) {
            Ok(_) => done += 1,
            Err(error) => {
                refused += 1;
                let by_a_vertex = matches!(
                    error,
                    InsertSegmentError::Split {
                        error: SplitEdgeError::WouldCross { obstacle: Element::Vertex(_), .. },
                        ..
                    }
                );
                assert!(by_a_vertex, "{i}: {error}");
                assert!(s == map, "{i}: refused, but changed");
            }
        }
        assert_eq!(s.geometry_violations(), [], "{i}");
    }
    assert!(refused > 10 && done > 0, "{refused} refused, {done} inserted");
}

/// Two lines so close that both crossings with a third are rounded to the same point: the second is refused after three
/// vertices have been made, all of them in used slots.
#[test]
fn a_refused_segment_gives_back_the_slots_it_took() {
    let points = [(0.0, 0.0), (3.0, 1.0), (0.0, 2f64.powi(-54))].map(Point::from);
    let mut s = Subdivision::from_graph(&points, &[[0, 1], [2, 1]]).unwrap();
    let spare = [60, 70, 80, 90].map(|x| s.insert_vertex(point(x, 60)).unwrap());
    spare.into_iter().for_each(|v| assert!(s.remove_vertex(v).is_ok()));
    let mut refused = 0;
    for i in 0..40 {
        let x = 1.5 + f64::from(i) / 77.0;
        let before = s.clone();
        if s.insert_segment(Point::new(x, 0.0), Point::new(x + 0.001, 1.5)).is_err() {
            refused += 1;
            assert!(s == before, "{i}: refused, but changed");
        }
        s = before;
    }
    assert!(refused > 10, "{refused} of 40 refused");
}

#[test]
fn an_edge_comes_and_goes_step_by_step() {
    let numbers = |journal: &Journal| journal.steps().iter().map(|step| step.number).collect::<Vec<_>>();
    let (mut s, mut journal) = (start(), Journal::new());
    let new = s.insert_edge_with(v(7), v(5), &mut journal).unwrap();
    assert_eq!(numbers(&journal), [1, 2, 3], "an isolated vertex is joined to a cycle");
    let mut journal = Journal::new();
    s.remove_edge_with(new.half_edge.edge(), &mut journal).unwrap();
    assert_eq!(numbers(&journal), [1, 2]);
    assert_right(&s, "removed again");
}

/// The face keeps the half-edge of a dangling edge as its own; then that edge goes, from either end.
#[test]
fn an_edge_that_a_face_points_to_can_go() {
    for joined in 0..2 {
        let square = [point(0, 0), point(8, 0), point(8, 8), point(0, 8)];
        let mut s = Subdivision::polygon(&square).unwrap();
        let (diagonal, _) = s.split_face(HalfEdgeId::new(0), HalfEdgeId::new(4)).unwrap();
        let (middle, _) = s.split_edge(diagonal, point(4, 4)).unwrap();
        let halves: Vec<HalfEdgeId> = s.outgoing_half_edges(middle).collect();
        s.join_faces(halves[joined]).unwrap();
        let left = halves[1 - joined];
        assert_eq!(s.face(left), s.face(left.twin()), "it dangles");
        let face = s.face(left);
        for own in s.incident_half_edges(face).collect::<Vec<_>>() {
            let mut s = s.clone();
            // What a face points to moves on with what is split and joined; here it is put there by a table.
            let mut table = Table::from_view(&s);
            for u in s.vertices() {
                table.vertices[u.index()].as_mut().unwrap().position = s.position(u).map(|p| [p.x, p.y]);
            }
            table.faces[face.index()].as_mut().unwrap().half_edge = Some(own);
            s = Subdivision::from_table(&table).unwrap();
            s.remove_edge(left.edge()).unwrap();
            assert_right(&s, &format!("half {joined}, {own}"));
            assert!(own.edge() == left.edge() || s.half_edge(face) == Some(own), "{own} is still there");
        }
    }
}
