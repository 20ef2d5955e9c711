//! Promise: after any sequence of edits a subdivision is exactly what its edges cut out of the plane; a refused
//! edit changes nothing; splitting and joining undo each other.

use crate::tracer::{Numbers, assert_traced, faces_of};
use dcel_kit::plane::{
    JoinEdgesError, JoinFacesError, LAB_RECTANGLE, Point, SplitEdgeError, SplitFaceError, Subdivision,
};
use dcel_kit::topology::{self, IdError, PolygonList};
use dcel_kit::{FaceId, HalfEdgeId, VertexId};
use std::collections::BTreeSet;

fn h(number: u32) -> HalfEdgeId {
    HalfEdgeId::new(number)
}

/// A square in a square hole of a square in a square hole of a square, beside a triangle.
fn nested() -> Subdivision {
    let mut points = Vec::new();
    let mut list = PolygonList::new();
    for (i, r) in [64.0, 48.0, 32.0, 24.0, 16.0].into_iter().enumerate() {
        points.extend([(-r, -r), (r, -r), (r, r), (-r, r)].map(Point::from));
        let cycle: Vec<u32> = (0..4).map(|k| 4 * i as u32 + k).collect();
        if i % 2 == 0 { list.push_face(&cycle) } else { list.push_hole(&cycle) }
    }
    points.extend([(80.0, 0.0), (96.0, 0.0), (80.0, 16.0)].map(Point::from));
    list.push_face(&[20, 21, 22]);
    Subdivision::from_polygons(points, &list).unwrap()
}

fn euler_holds(s: &Subdivision, context: &str) {
    let mut component: Vec<usize> = (0..s.vertex_bound()).collect();
    fn root(component: &[usize], mut v: usize) -> usize {
        while component[v] != v {
            v = component[v];
        }
        v
    }
    for e in s.edges() {
        let [a, b] = e.half_edges().map(|h| root(&component, s.origin(h).index()));
        component[a] = b;
    }
    let components: BTreeSet<usize> = s.vertices().map(|v| root(&component, v.index())).collect();
    let (v, e, f) = (s.vertex_count() as i64, s.edge_count() as i64, s.face_count() as i64);
    assert_eq!(v - e + f, 1 + components.len() as i64, "{context}: Euler");
}

/// One edit with random arguments, as a line of a script, and whether it was accepted.
fn one_random_edit(s: &mut Subdivision, numbers: &mut Numbers) -> (String, bool) {
    let live: Vec<HalfEdgeId> = s.half_edges().collect();
    let pick = |numbers: &mut Numbers| live[numbers.below(live.len())];
    match numbers.below(8) {
        0..=3 => {
            let (a, mut b) = (pick(numbers), pick(numbers));
            if numbers.below(4) > 0 {
                let same_face: Vec<_> = live.iter().copied().filter(|&g| s.face(g) == s.face(a)).collect();
                b = same_face[numbers.below(same_face.len())];
            }
            (format!("split_face {a} {b}"), s.split_face(a, b).is_ok())
        }
        4 => {
            let a = pick(numbers);
            (format!("split_in_half {a}"), s.split_in_half(a).is_ok())
        }
        5 => {
            let a = pick(numbers);
            let m = s.midpoint(a);
            let p = Point::new(m.x + numbers.below(9) as f64 - 4.0, m.y + numbers.below(9) as f64 - 4.0);
            (format!("split_edge {a} {p}"), s.split_edge(a, p).is_ok())
        }
        6 => {
            let a = pick(numbers);
            (format!("join_faces {a}"), s.join_faces(a).is_ok())
        }
        _ => {
            let a = pick(numbers);
            (format!("join_edges {a}"), s.join_edges(a).is_ok())
        }
    }
}

#[test]
fn random_scripts_keep_to_what_the_edges_cut_out() {
    let mut done = [0; 8];
    for seed in 1..250 {
        let mut numbers = Numbers::new(seed);
        let mut s = if seed % 2 == 0 { nested() } else { Subdivision::lab_rectangle() };
        let mut script = String::new();
        for _ in 0..40 {
            let before = s.clone();
            let (line, accepted) = one_random_edit(&mut s, &mut numbers);
            script.push_str(&line);
            script.push_str(if accepted { "\n" } else { "   # refused\n" });
            let context = format!("seed {seed}\n{script}");
            if accepted {
                let kind = ["split_face", "split_in", "split_edge", "join_faces", "join_edges"];
                done[kind.iter().position(|k| line.starts_with(k)).unwrap()] += 1;
                assert_traced(&s, &context);
                euler_holds(&s, &context);
            } else {
                assert!(s == before, "{context}refused, but changed");
            }
        }
    }
    assert!(done[..5].iter().all(|&n| n > 200), "too few of a kind: {done:?}");
}

#[test]
fn joining_undoes_splitting() {
    for seed in 1..200 {
        let mut numbers = Numbers::new(seed);
        let mut s = nested();
        for _ in 0..30 {
            let before = s.clone();
            let live: Vec<HalfEdgeId> = s.half_edges().collect();
            let a = live[numbers.below(live.len())];
            let b = live[numbers.below(live.len())];
            if let Ok((new, face)) = s.split_face(a, b) {
                let side = if s.face(new) == face { new } else { new.twin() };
                let mut back = s.clone();
                assert_eq!(back.join_faces(side), Ok(face), "seed {seed}");
                assert_eq!(faces_of(&back), faces_of(&before), "seed {seed}: split_face {a} {b}, join_faces {side}");
            }
            let before = s.clone();
            if let Ok((m, _)) = s.split_in_half(a) {
                let mut back = s.clone();
                assert_eq!(back.join_edges(a), Ok(m), "seed {seed}");
                assert_eq!(faces_of(&back), faces_of(&before), "seed {seed}: split_in_half {a}");
            }
        }
    }
}

#[test]
fn split_face_accepts_exactly_the_diagonals_that_lie_inside() {
    // A comb with three teeth; whether a diagonal lies inside is decided by counting crossings of a fine ladder
    // of points on it, all off the boundary lines.
    let corners = [(0, 0), (12, 0), (12, 9), (10, 9), (9, 2), (7, 9), (5, 9), (4, 2), (2, 9), (0, 9)];
    let polygon: Vec<Point> = corners.map(|(x, y)| Point::new(f64::from(x), f64::from(y))).to_vec();
    let s = Subdivision::polygon(&polygon).unwrap();
    let n = polygon.len();
    let inside = |q: Point| {
        let crosses =
            |a: Point, b: Point| (a.y > q.y) != (b.y > q.y) && q.x < (b.x - a.x) * (q.y - a.y) / (b.y - a.y) + a.x;
        (0..n).filter(|&i| crosses(polygon[i], polygon[(i + 1) % n])).count() % 2 == 1
    };
    let mut accepted = 0;
    for i in 0..n {
        for j in 0..n {
            let apart = (i + n - j) % n;
            let (p, q) = (polygon[i], polygon[j]);
            let clear = (1..1000).all(|k| {
                let t = f64::from(k) / 1000.0 + 1e-7;
                inside(Point::new(p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)))
            });
            let legal = ![0, 1, n - 1].contains(&apart) && clear;
            assert_eq!(s.can_split_face(h(2 * i as u32), h(2 * j as u32)).is_ok(), legal, "{i} {j}");
            accepted += usize::from(legal);
        }
    }
    assert!(accepted >= 20, "{accepted}");
}

#[test]
fn every_refusal_of_split_face() {
    let mut u = Subdivision::polygon(
        &[(0., 0.), (6., 0.), (6., 4.), (4., 4.), (4., 2.), (2., 2.), (2., 4.), (0., 4.)].map(Point::from),
    )
    .unwrap();
    let before = u.clone();
    let f1 = FaceId::new(1);
    for (a, b, error) in [
        (
            h(0),
            h(99),
            topology::SplitFaceError::from(IdError::OutOfRange { element: h(99).into(), count: 16, bound: 16 }).into(),
        ),
        (h(0), h(1), topology::SplitFaceError::DifferentFaces { h1: h(0), f1, h2: h(1), f2: FaceId::new(0) }.into()),
        (h(4), h(4), topology::SplitFaceError::SameHalfEdge { h: h(4) }.into()),
        (h(4), h(6), topology::SplitFaceError::NextOf { h1: h(4), h2: h(6) }.into()),
        (h(6), h(4), topology::SplitFaceError::PrevOf { h1: h(6), h2: h(4) }.into()),
        (h(4), h(14), SplitFaceError::EdgeThroughVertex { h1: h(4), h2: h(14), vertex: VertexId::new(3) }),
        (h(6), h(12), SplitFaceError::EdgeOutsideFace { h1: h(6), h2: h(12), face: f1, corner: h(6) }),
        (h(4), h(0), SplitFaceError::EdgeCrosses { h1: h(4), h2: h(0), crossed: h(6) }),
    ] {
        assert_eq!(u.split_face(a, b), Err(error), "{a} {b}");
        assert!(u == before, "{a} {b}: refused, but changed");
    }
    // Through a vertex: from the middle of the bottom straight up through a corner.
    let (m, c) = u.split_edge(h(0), Point::new(2.0, 0.0)).unwrap();
    let before = u.clone();
    let corner = VertexId::new(5);
    assert_eq!(u.split_face(c, h(12)), Err(SplitFaceError::EdgeThroughVertex { h1: c, h2: h(12), vertex: corner }));
    assert_eq!(u.split_face(h(12), c), Err(SplitFaceError::EdgeThroughVertex { h1: h(12), h2: c, vertex: corner }));
    assert_eq!(u.origin(c), m);
    assert!(u == before);

    // Different cycles, an existing edge and one vertex at two corners: in the face round a chain of triangles.
    let mut n = nested();
    let before = n.clone();
    let (outer, ring) = (n.half_edge(FaceId::new(1)).unwrap(), n.cycles(FaceId::new(1)).nth(1).unwrap());
    assert_eq!(
        n.split_face(outer, ring),
        Err(topology::SplitFaceError::DifferentCycles { h1: outer, h2: ring, face: FaceId::new(1) }.into())
    );
    assert!(n == before);

    let points = [(0., 0.), (4., -2.), (4., 2.), (-4., 2.), (-4., -2.)].map(Point::from).to_vec();
    let mut bow = Subdivision::from_triangles(points, &[[0, 1, 2], [0, 3, 4]]).unwrap();
    let before = bow.clone();
    let at: Vec<_> = bow.outgoing_half_edges(VertexId::new(0)).filter(|&g| bow.face(g) == bow.outer_face()).collect();
    assert_eq!(
        bow.split_face(at[0], at[1]),
        Err(SplitFaceError::SameVertex { h1: at[0], h2: at[1], vertex: VertexId::new(0) })
    );
    let existing = |bow: &Subdivision, h1: HalfEdgeId, h2: HalfEdgeId| match bow.can_split_face(h1, h2) {
        Err(SplitFaceError::EdgeExists { existing, .. }) => Some(existing),
        _ => None,
    };
    let outside: Vec<_> = bow.incident_half_edges(bow.outer_face()).collect();
    let pairs = outside.iter().flat_map(|&a| outside.iter().map(move |&b| (a, b)));
    let named: Vec<_> = pairs.filter_map(|(a, b)| existing(&bow, a, b).map(|e| (a, b, e))).collect();
    assert!(!named.is_empty());
    for (a, b, e) in named {
        assert_eq!((bow.origin(e), bow.destination(e)), (bow.origin(a), bow.origin(b)));
        assert!(bow.split_face(a, b).is_err() && bow == before);
    }
}

#[test]
fn every_refusal_of_split_edge_and_the_midpoint() {
    let near = 1.0 + f64::EPSILON;
    let mut s = Subdivision::polygon(&[(1., 0.), (near, 0.), (1., 8.)].map(Point::from)).unwrap();
    let before = s.clone();
    let (from, to) = (Point::new(1.0, 0.0), Point::new(near, 0.0));
    assert_eq!(s.split_in_half(h(0)), Err(SplitEdgeError::NoRoomForMidpoint { h: h(0), from, to }));
    assert!(matches!(s.split_in_half(h(77)), Err(SplitEdgeError::Topology(_))));
    let nan = Point::new(f64::NAN, 0.0);
    assert!(matches!(s.split_edge(h(0), nan), Err(SplitEdgeError::Coordinate { .. })));
    let off = Point::new(1.0, 9.0);
    assert_eq!(s.split_edge(h(4), off), Err(SplitEdgeError::NotBetween { h: h(4), point: off }));
    assert!(s == before);

    let mut s = nested();
    let before = s.clone();
    let bottom = s.half_edge(FaceId::new(1)).unwrap();
    let deep = Point::new(0.0, 0.0);
    assert!(matches!(s.split_edge(bottom, deep), Err(SplitEdgeError::WouldCross { .. })));
    assert!(s == before);
    // Bent outwards over nothing: allowed.
    let out = Point::new(0.0, -70.0);
    s.split_edge(bottom, out).unwrap();
    assert_traced(&s, "bent outwards");
}

#[test]
fn a_rounded_midpoint_must_not_fold_a_sliver() {
    // In units of the last place: the midpoint (1.5, 0.5) of the long side is rounded to (2, 0), and the third
    // corner (1, 0) lies between.
    let at = |x: f64, y: f64| Point::new(1.0 + x * f64::EPSILON, 1.0 + y * f64::EPSILON);
    let mut s = Subdivision::polygon(&[at(0., 0.), at(1., 0.), at(3., 1.)]).unwrap();
    let before = s.clone();
    assert_eq!(
        s.split_in_half(h(4)),
        Err(SplitEdgeError::WouldCross { h: h(4), point: at(2., 0.), obstacle: VertexId::new(1).into() })
    );
    assert!(s == before);
    // Without anything in the way the edge may bend.
    let mut s = Subdivision::polygon(&[at(0., 0.), at(3., 1.), at(0., 9.)]).unwrap();
    s.split_in_half(h(0)).unwrap();
    assert_eq!(s.geometry_violations(), []);
}

#[test]
fn every_refusal_of_joining() {
    let mut s = nested();
    let before = s.clone();
    let hole = s.hole_faces().next().unwrap();
    let side = s.half_edge(hole).unwrap();
    let face = s.face(side.twin());
    assert_eq!(s.join_faces(side), Err(JoinFacesError::HoleAndDomain { hole, face }));
    assert_eq!(s.join_faces(side.twin()), Err(JoinFacesError::HoleAndDomain { hole, face }));
    assert!(matches!(s.join_faces(h(1000)), Err(JoinFacesError::Topology(topology::JoinFacesError::Id(_)))));
    assert!(s == before);
    assert_eq!(s.set_hole(hole, false), Some(true));
    s.join_faces(side).unwrap();
    assert_traced(&s, "hole filled");
    let chain = s.half_edges().find(|&g| s.face(g) == s.face(g.twin())).unwrap();
    assert!(matches!(s.join_faces(chain), Err(JoinFacesError::Topology(topology::JoinFacesError::SameFace { .. }))));

    let mut t = Subdivision::polygon(&[(0., 0.), (4., 0.), (0., 4.)].map(Point::from)).unwrap();
    let before = t.clone();
    let vertex = VertexId::new(1);
    let existing = h(5);
    assert_eq!(t.join_edges(h(0)), Err(JoinEdgesError::EdgeExists { h: h(0), vertex, existing }));
    assert!(t == before);
    let mut s = nested();
    let before = s.clone();
    let bottom = s.half_edge(FaceId::new(1)).unwrap();
    assert!(matches!(s.join_edges(bottom), Err(JoinEdgesError::WouldCross { .. })));
    assert!(matches!(s.join_edges(h(1000)), Err(JoinEdgesError::Topology(_))));
    assert!(s == before);
}

#[test]
fn splitting_the_outer_face_leaves_f0_outside_on_either_side() {
    for flip in [false, true] {
        let mut u = Subdivision::polygon(
            &[(0., 0.), (6., 0.), (6., 4.), (4., 4.), (4., 2.), (2., 2.), (2., 4.), (0., 4.)].map(Point::from),
        )
        .unwrap();
        // The two tips of the U, on the outside: between them lies a bay of f0.
        let tips =
            [3u32, 6].map(|v| u.outgoing_half_edges(VertexId::new(v)).find(|&g| u.face(g) == u.outer_face()).unwrap());
        let [a, b] = if flip { [tips[1], tips[0]] } else { tips };
        let (new_edge, bay) = u.split_face(a, b).unwrap();
        assert_eq!((u.origin(new_edge), u.destination(new_edge)), (u.origin(a), u.origin(b)));
        assert!(u.face(new_edge) == bay || u.face(new_edge.twin()) == bay);
        assert_eq!(u.incident_half_edges(bay).count(), 4);
        assert!(!u.is_hole(bay));
        assert_traced(&u, "bay cut off");
    }
}

#[test]
fn rings_move_into_the_face_that_is_cut_off_and_back() {
    let u = [(0., 0.), (60., 0.), (60., 40.), (40., 40.), (40., 20.), (20., 20.), (20., 40.), (0., 40.)];
    let island = [(28., 26.), (32., 26.), (30., 30.)];
    for island_first in [true, false] {
        let points: Vec<Point> = u.iter().chain(&island).map(|&p| p.into()).collect();
        let mut list = PolygonList::new();
        if island_first {
            list.push_face(&[8, 9, 10]);
        }
        list.push_face(&[0, 1, 2, 3, 4, 5, 6, 7]);
        if !island_first {
            list.push_face(&[8, 9, 10]);
        }
        let mut s = Subdivision::from_polygons(points, &list).unwrap();
        let before = s.clone();
        let outside = |v: u32| {
            let star: Vec<_> = s.outgoing_half_edges(VertexId::new(v)).collect();
            star.into_iter().find(|&g| s.face(g) == s.outer_face()).unwrap()
        };
        let (a, b) = (outside(3), outside(6));
        let (mouth, bay) = s.split_face(a, b).unwrap();
        assert_traced(&s, "bay with an island");
        assert_eq!((s.cycles(bay).count(), s.cycles(s.outer_face()).count()), (2, 1));
        let side = if s.face(mouth) == bay { mouth } else { mouth.twin() };
        assert_eq!(s.join_faces(side.twin()), Ok(bay), "f0 stays, whichever half-edge is named");
        assert_traced(&s, "bay opened");
        assert_eq!(faces_of(&s), faces_of(&before));
    }
}

#[test]
fn compacting_keeps_everything_but_the_numbers() {
    for seed in 1..100 {
        let mut numbers = Numbers::new(seed);
        let mut s = nested();
        for _ in 0..40 {
            one_random_edit(&mut s, &mut numbers);
        }
        let before = s.clone();
        let map = s.compact();
        assert_traced(&s, &format!("seed {seed}"));
        assert_eq!(
            (s.vertex_bound(), s.edge_bound(), s.face_bound()),
            (before.vertex_count(), before.edge_count(), before.face_count())
        );
        assert_eq!(map.faces[before.outer_face()], Some(s.outer_face()));
        for g in before.half_edges() {
            let new = map.half_edge(g).unwrap();
            assert_eq!(s.point(s.origin(new)), before.point(before.origin(g)));
            assert_eq!(map.half_edge(before.next(g)), Some(s.next(new)));
            assert_eq!(map.faces[before.face(g)], Some(s.face(new)));
            assert_eq!(before.is_hole(before.face(g)), s.is_hole(s.face(new)));
        }
    }
}

#[test]
fn the_lab_rectangle_is_the_one_of_the_lab() {
    let s = Subdivision::lab_rectangle();
    assert_eq!(s, Subdivision::polygon(&LAB_RECTANGLE).unwrap());
    assert_traced(&s, "lab rectangle");
    let inside: Vec<_> = s.incident_vertices(FaceId::new(1)).collect();
    assert_eq!(inside, (0..6).map(VertexId::new).collect::<Vec<_>>());
    assert_eq!(s.incident_half_edges(s.outer_face()).count(), 6);
    assert_eq!(s.half_edge(s.outer_face()), Some(h(1)));
}

#[test]
fn a_flip_turns_the_diagonal_of_the_two_faces_beside_it() {
    let square = [(0., 0.), (4., 0.), (4., 4.), (0., 4.)].map(Point::from);
    let mut s = Subdivision::polygon(&square).unwrap();
    let (diagonal, _) = s.split_face(h(0), h(4)).unwrap();
    assert_eq!((s.origin(diagonal), s.destination(diagonal)), (VertexId::new(0), VertexId::new(2)));
    s.flip_edge(diagonal).unwrap();
    let ends = BTreeSet::from([s.origin(diagonal), s.destination(diagonal)]);
    assert_eq!(ends, BTreeSet::from([VertexId::new(1), VertexId::new(3)]));
    assert_traced(&s, "flipped");
}

#[test]
fn an_edge_round_an_island_joins_it_to_the_face_that_surrounds_it() {
    // Every edge of squares in each other, all of whose faces belong to the domain, from either side.
    let square = |r: f64| [(-r, -r), (r, -r), (r, r), (-r, r)].map(Point::from);
    let sides = [8.0, 6.0, 4.0, 2.0].map(square).map(|c| [[c[0], c[1]], [c[1], c[2]], [c[2], c[3]], [c[3], c[0]]]);
    let s = Subdivision::from_segments(&sides.concat()).unwrap();
    let mut surrounded = 0;
    for a in s.half_edges() {
        let mut after = s.clone();
        let (f, g) = (s.face(a), s.face(a.twin()));
        let Ok(gone) = after.join_faces(a) else { continue };
        let kept = if gone == f { g } else { f };
        assert!(!after.has_face(gone) && after.has_face(kept), "{a}");
        assert_traced(&after, &format!("{a}: {gone} joined to {kept}"));
        surrounded += usize::from(s.half_edge(gone).is_some_and(|g| s.cycle(g).all(|g| g.edge() != a.edge())));
    }
    assert!(surrounded >= 12, "{surrounded}");
}

#[test]
fn a_hole_that_is_joined_leaves_no_hole_behind() {
    let mut s = Subdivision::lab_rectangle();
    let (new, made) = s.split_face(h(2), h(8)).unwrap();
    let both = [s.face(new), s.face(new.twin())];
    for joined in [new, new.twin()] {
        let mut s = s.clone();
        assert_eq!(both.map(|f| s.set_hole(f, true)), [Some(false); 2]);
        let gone = s.join_faces(joined).unwrap();
        assert_eq!(gone, if s.has_face(both[0]) { both[1] } else { both[0] });
        // The hole that is left becomes a part of the domain, and so does what is cut off from it.
        assert_eq!(s.set_hole(s.face(h(2)), false), Some(true));
        let (_, again) = s.split_face(h(2), h(8)).unwrap();
        assert_eq!(again, gone, "the slot is used again");
        assert!(!s.is_hole(again), "{again}, as new as {made} was");
    }
}
