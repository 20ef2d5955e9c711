//! Vertices that move, one or all: allowed exactly where the full check of the moved drawing finds nothing.

use dcel_kit::plane::{Affine, PlanarView, PlaneJournal, Point, SetPointError, Subdivision, TransformError};
use dcel_kit::topology::{Table, violations};
use dcel_kit::{FaceId, HalfEdgeId, VertexId};
use std::collections::BTreeMap;

/// The subdivision with one vertex elsewhere, and nothing else changed, if it obeys all invariants.
fn moved(s: &Subdivision, v: VertexId, to: Point) -> Result<Subdivision, String> {
    let mut table = Table::from_view(s);
    for u in s.vertices() {
        let p = if u == v { to } else { s.position(u).unwrap() };
        table.vertices[u.index()].as_mut().unwrap().position = Some([p.x, p.y]);
    }
    Subdivision::from_table(&table).map_err(|error| error.to_string())
}

/// Random drawings on a small grid, with components in each other, dangling edges and vertices alone.
fn drawing(seed: u64, size: u64, offset: f64) -> Subdivision {
    let mut state = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1;
    let mut below = move |n: u64| {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) % n
    };
    let mut s = Subdivision::new();
    let at = |x: u64, y: u64| Point::new(x as f64 + offset, y as f64 - offset);
    for _ in 0..3 + below(5) {
        let [p, q] = [(), ()].map(|()| at(below(size), below(size)));
        let _ = s.insert_segment(p, q);
    }
    for _ in 0..below(4) {
        let _ = s.insert_vertex(at(below(size), below(size)));
    }
    if below(2) == 0 {
        // A box round everything, so that bounded faces have inner components.
        let far = size;
        let corners = [(0, 0), (far, 0), (far, far), (0, far)].map(|(x, y)| at(x, y));
        for i in 0..4 {
            let _ = s.insert_segment(corners[i], corners[(i + 1) % 4]);
        }
    }
    s
}

fn name(error: &SetPointError) -> &'static str {
    match error {
        SetPointError::Occupied { .. } => "occupied",
        SetPointError::OnEdge { .. } => "on edge",
        SetPointError::Crosses { .. } => "crosses",
        SetPointError::ThroughVertex { .. } => "through",
        SetPointError::TurnsOver { .. } => "turns over",
        SetPointError::LeavesFace { .. } => "leaves",
        _ => "other",
    }
}

/// Every vertex of many small drawings to every place of a grid, near the origin and far from it.
#[test]
fn a_vertex_moves_exactly_where_the_full_check_allows_it() {
    let mut met: BTreeMap<&str, usize> = BTreeMap::new();
    for seed in 0..60 {
        let offset = if seed % 3 == 0 { 1e9 } else { 0.0 };
        let s = drawing(seed, 5, offset);
        for v in s.vertices() {
            for (x, y) in (-1..7).flat_map(|x| (-1..7).map(move |y| (x, y))) {
                let to = Point::new(f64::from(x) + offset, f64::from(y) - offset);
                let (answer, oracle) = (s.can_set_point(v, to), moved(&s, v, to));
                let words =
                    format!("drawing {seed}: {v} from {} to {to}: {answer:?}, full check {oracle:?}", s.point(v));
                assert_eq!(answer.is_ok(), oracle.is_ok(), "{words}");
                *met.entry(answer.as_ref().map_or_else(name, |()| "moved")).or_default() += 1;
                let (mut after, mut log) = (s.clone(), PlaneJournal::new());
                assert_eq!(after.set_point_with(v, to, &mut log), answer, "{words}");
                if let Ok(expected) = oracle {
                    assert_eq!(after, expected, "{words}");
                    after.undo(&mut log, 0);
                }
                assert_eq!(after, s, "{words}");
                assert!(log.is_empty(), "{words}");
            }
        }
    }
    for kind in ["moved", "occupied", "on edge", "crosses", "through", "turns over", "leaves"] {
        assert!(met.get(kind).is_some_and(|&n| n > 5), "{kind}: {met:?}");
    }
}

#[test]
fn the_edge_that_would_be_crossed_is_named() {
    // A triangle with a vertex inside that is joined to all corners.
    let points = [(0.0, 0.0), (8.0, 0.0), (4.0, 8.0), (4.0, 2.0)].map(Point::from).to_vec();
    let mut s = Subdivision::from_triangles(points, &[[0, 1, 3], [1, 2, 3], [2, 0, 3]]).unwrap();
    let (v3, out) = (VertexId::new(3), Point::new(4.0, -1.0));
    let before = s.clone();
    let error = s.set_point(v3, out).unwrap_err();
    let SetPointError::Crosses { vertex, crossed, .. } = error else { panic!("{error}") };
    assert_eq!(vertex, v3);
    let mut ends = [s.origin(crossed), s.destination(crossed)].map(VertexId::number);
    ends.sort_unstable();
    assert_eq!(ends, [0, 1], "{error}");
    assert_eq!(s, before);
    assert!(matches!(s.set_point(v3, Point::new(4.0, 0.0)), Err(SetPointError::OnEdge { .. })));
    assert!(matches!(s.set_point(v3, Point::new(8.0, 0.0)), Err(SetPointError::Occupied { .. })));
    assert!(matches!(s.set_point(v3, Point::new(f64::NAN, 0.0)), Err(SetPointError::Coordinate(_))));
    assert!(matches!(s.set_point(VertexId::new(4), out), Err(SetPointError::Id(_))));
    assert_eq!(s, before);
    s.set_point(v3, Point::new(4.0, 1e-40)).unwrap();
    assert!(s.geometry_violations().is_empty());
}

fn maps() -> Vec<(Affine<2>, i8)> {
    let matrix = |a: f64, b: f64, c: f64, d: f64| Affine { matrix: [[a, b], [c, d]], shift: [3.0, -7.0] };
    let mut maps = vec![(Affine::quarter_turn(), 1), (Affine::reflection(0), -1), (Affine::reflection(1), -1)];
    for [a, b, c, d] in [[2, 1, 1, 1], [1, 2, 3, 4], [3, -4, 4, 3], [0, 1, 1, 0], [-1, 0, 0, -1], [1, 2, 2, 4]] {
        let det: i32 = a * d - b * c;
        maps.push((matrix(f64::from(a), f64::from(b), f64::from(c), f64::from(d)), det.signum() as i8));
    }
    maps
}

#[test]
fn maps_keep_the_faces_and_reflections_turn_the_half_edges_round() {
    for seed in 0..40 {
        let s = drawing(seed, 6, if seed % 2 == 0 { 0.0 } else { 4096.0 });
        for (map, sign) in maps() {
            let (mut after, mut log) = (s.clone(), PlaneJournal::new());
            let answer = after.transform_with(&map, &mut log);
            if sign == 0 {
                assert_eq!(answer, Err(TransformError::Flat));
                assert_eq!(after, s);
                continue;
            }
            // Crossings are rounded already, so a map may have to round again, and may then be refused.
            if let Err(error) = answer {
                assert!(matches!(error, TransformError::Rounding(_)), "{error}");
                assert_eq!(after, s);
                continue;
            }
            let words = format!("drawing {seed}, {map:?}");
            assert_eq!(violations(&after), [], "{words}");
            assert_eq!(after.geometry_violations(), [], "{words}");
            let sides = |s: &Subdivision, f: FaceId| -> Vec<HalfEdgeId> {
                let mut all: Vec<_> =
                    s.cycles(f).flat_map(|h| s.incident_half_edges(s.face(h)).chain(s.cycle(h))).collect();
                all.sort_unstable();
                all.dedup();
                all
            };
            for f in s.faces() {
                assert_eq!(sides(&after, f), sides(&s, f), "{words}: {f}");
            }
            if map == Affine::reflection(0) || map == Affine::reflection(1) {
                let mut back = after.clone();
                back.transform(&map).unwrap();
                assert_eq!(back, s, "{words}");
            }
            after.undo(&mut log, 0);
            assert_eq!(after, s, "{words}");
        }
    }
}

#[test]
fn a_map_that_rounds_vertices_together_is_refused() {
    let mut s = Subdivision::polygon(&[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(Point::from)).unwrap();
    let before = s.clone();
    let error = s.transform(&Affine::translation([1e20, 0.0])).unwrap_err();
    assert!(matches!(error, TransformError::Rounding(_)), "{error}");
    assert!(matches!(s.transform(&Affine::scaling(1e-150)), Err(TransformError::Map(_))));
    assert!(matches!(s.transform(&Affine::scaling(f64::INFINITY)), Err(TransformError::Map(_))));
    assert!(matches!(s.transform(&Affine::scaling(0.0)), Err(TransformError::Flat)));
    s.transform(&Affine::scaling(1e-40)).unwrap();
    assert!(matches!(s.transform(&Affine::scaling(1e-40)), Err(TransformError::Coordinate { .. })));
    s.transform(&Affine::scaling(1e40)).unwrap();
    assert_eq!(s.point(VertexId::new(2)), before.point(VertexId::new(2)));
}

/// Marks in the middle, all kinds of edits, components that merge and fall apart: back to each state in turn.
#[test]
fn a_log_takes_a_subdivision_back_to_any_mark() {
    let mut done = 0;
    for seed in 0..40 {
        let mut s = drawing(seed, 6, 0.0);
        let (mut log, mut pages) = (PlaneJournal::new(), Vec::new());
        for step in 0..12_u32 {
            pages.push((log.len(), s.clone()));
            let v = s.vertices().nth(step as usize % s.vertex_count().max(1));
            let e = s.edges().nth((7 * step as usize) % s.edge_count().max(1));
            let f = s.faces().last().unwrap();
            match (step % 6, v, e) {
                (0, Some(v), _) => done += usize::from(s.remove_vertex_with(v, &mut log).is_ok()),
                (1, _, Some(e)) => done += usize::from(s.remove_edge_with(e, &mut log).is_ok()),
                (2, ..) => {
                    let [p, q] = [(-1.0, f64::from(step) / 3.0), (7.0, 2.5)].map(Point::from);
                    done += usize::from(s.insert_segment_with(p, q, &mut log).is_ok());
                }
                (3, ..) => done += usize::from(s.set_hole_with(f, true, &mut log).is_some()),
                (4, ..) => done += usize::from(s.transform_with(&Affine::reflection(0), &mut log).is_ok()),
                (_, Some(v), _) => {
                    done += usize::from(s.set_point_with(v, Point::new(9.0, 9.0 + f64::from(step)), &mut log).is_ok());
                }
                _ => {}
            }
            assert_eq!(s.geometry_violations(), [], "drawing {seed}, step {step}");
        }
        for (mark, before) in pages.into_iter().rev() {
            s.undo(&mut log, mark);
            assert_eq!(s, before, "drawing {seed}, mark {mark}");
        }
    }
    assert!(done > 200, "{done} edits were made");
}

#[test]
fn a_vertex_moves_by_what_it_is_told() {
    let mut s = drawing(1, 5, 0.0);
    for v in s.vertices().collect::<Vec<_>>() {
        let (before, mut log) = (s.clone(), PlaneJournal::new());
        let Point { x, y } = s.point(v);
        assert_eq!(s.move_vertex_with(v, [0.125, -0.25], &mut log), Ok(()), "{v}");
        assert_eq!(s.point(v), Point::new(x + 0.125, y - 0.25), "{v}");
        s.undo(&mut log, 0);
        assert_eq!(s, before, "{v}");
    }
    let missing = VertexId::new(s.vertex_bound() as u32);
    assert!(matches!(s.move_vertex(missing, [0.0, 0.0]), Err(SetPointError::Id(_))));
}

#[test]
fn a_vertex_alone_is_told_what_is_in_its_place() {
    let at = |x: f64, y: f64| Point::new(x, y);
    let points = [at(0., 0.), at(4., 0.), at(0., 4.), at(1., 1.), at(1., 2.), at(9., 9.)];
    let s = Subdivision::from_graph(&points, &[[0, 1], [1, 2], [2, 0]]).unwrap();
    let v = VertexId::new;
    let moved = |from: u32, point: Point| s.can_set_point(v(from), point);
    let occupied = |vertex: u32, point: Point, other: u32| {
        Err(SetPointError::Occupied { vertex: v(vertex), point, other: v(other) })
    };
    assert_eq!(moved(3, at(1., 2.)), occupied(3, at(1., 2.), 4));
    assert_eq!(moved(3, at(0., 4.)), occupied(3, at(0., 4.), 2));
    assert!(matches!(moved(3, at(2., 0.)), Err(SetPointError::OnEdge { edge, .. }) if edge.edge().number() == 0));
    assert!(matches!(moved(3, at(9., 8.)), Err(SetPointError::LeavesFace { face, .. }) if face.number() == 1));
    assert!(matches!(moved(5, at(1., 1.5)), Err(SetPointError::LeavesFace { face, .. }) if face == s.outer_face()));
    assert_eq!((moved(3, at(0.5, 2.5)), moved(5, at(-1., -1.))), (Ok(()), Ok(())));
}

/// The edges at the tip of a low triangle pass over a small one without touching it, so that it would lie inside.
#[test]
fn a_component_is_not_taken_into_a_face_that_grows() {
    let at = |x: f64, y: f64| Point::new(x, y);
    let (low, small) = ([at(0., 0.), at(10., 0.), at(5., 1.)], [at(5., 3.), at(5.5, 3.), at(5., 3.5)]);
    for (points, tip, inner) in [([low, small].concat(), 2, 3), ([small, low].concat(), 5, 0)] {
        let s = Subdivision::from_graph(&points, &[[0, 1], [1, 2], [2, 0], [3, 4], [4, 5], [5, 3]]).unwrap();
        assert_eq!(s.can_set_point(VertexId::new(tip), at(5., 2.)), Ok(()));
        match s.can_set_point(VertexId::new(tip), at(5., 20.)) {
            Err(SetPointError::LeavesFace { inner: found, .. }) => {
                assert!((inner..inner + 3).contains(&found.number()), "{found}");
            }
            other => panic!("{other:?}"),
        }
    }
}

/// Of three edges round a middle one turns over its neighbour: counter-clockwise over v2, clockwise over v3.
#[test]
fn the_neighbour_that_an_edge_would_turn_over_is_named() {
    let at = |x: f64, y: f64| Point::new(x, y);
    let points = [at(0., 0.), at(4., 0.), at(0., 4.), at(1., -4.)];
    let s = Subdivision::from_graph(&points, &[[0, 1], [0, 2], [0, 3]]).unwrap();
    for (to, over) in [(at(-1., 3.), 2), (at(-1., -4.), 3)] {
        match s.can_set_point(VertexId::new(1), to) {
            Err(SetPointError::Crosses { crossed, .. }) => assert_eq!(s.destination(crossed), VertexId::new(over)),
            other => panic!("{to}: {other:?}"),
        }
    }
}
