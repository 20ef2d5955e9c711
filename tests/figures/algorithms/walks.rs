//! Walks round faces and vertices, and walks to points.

use super::{assert_every_frame_differs, numbers, points, star};
use dcel_kit::figure::algorithms;
use dcel_kit::plane::predicates::orientation;
use dcel_kit::plane::{Location, Point, Subdivision, TriangulationMethod, WalkEvent};
use dcel_kit::{FaceId, HalfEdgeId, VertexId};
use std::collections::BTreeSet;

/// The names in "Half-edge 2 of 7: h3", frame by frame.
fn met(film: &dcel_kit::figure::SketchFilm) -> Vec<String> {
    let names = film.captions().filter(|(heading, _)| heading.starts_with("Half-edge"));
    names.map(|(heading, _)| heading.rsplit(' ').next().unwrap().to_owned()).collect()
}

#[test]
fn a_walk_round_a_face_meets_just_its_half_edges_and_one_round_a_vertex_just_those_that_start_there() {
    for seed in 0..10 {
        let mut s = star(seed, 9);
        s.triangulate(TriangulationMethod::Ears).unwrap();
        // One more face has an inner component.
        let corners = [(-1.0, -1.0), (1.0, -1.0), (0.0, 1.0)].map(|(x, y)| Point::new(x / 64.0, y / 64.0));
        let segments: Vec<[Point; 2]> = s
            .edges()
            .map(|e| e.half_edges().map(|h| s.point(s.origin(h))))
            .chain((0..3).map(|i| [corners[i], corners[(i + 1) % 3]]))
            .collect();
        let s = Subdivision::from_segments(&segments).unwrap_or(s);
        let all: Vec<HalfEdgeId> = s.half_edges().collect();
        for f in s.faces() {
            let film = algorithms::face_walk(&s, f, 1000).unwrap();
            let expected: BTreeSet<String> = all.iter().filter(|&&h| s.face(h) == f).map(ToString::to_string).collect();
            let met = met(&film);
            assert_eq!((met.len(), film.len()), (expected.len(), expected.len() + 2), "{f}, seed {seed}");
            assert_eq!(met.into_iter().collect::<BTreeSet<_>>(), expected, "{f}, seed {seed}");
            assert_every_frame_differs(&film);
        }
        for v in s.vertices() {
            let film = algorithms::vertex_walk(&s, v, 1000).unwrap();
            let met = met(&film);
            let leaving: Vec<HalfEdgeId> = all.iter().copied().filter(|&h| s.origin(h) == v).collect();
            assert_eq!(met.iter().cloned().collect::<BTreeSet<_>>(), leaving.iter().map(ToString::to_string).collect());
            // Counter-clockwise: each lies to the left of the one before, or the turn is at least half a circle, which
            // happens once at most.
            let end = |name: &str| {
                let h = leaving.iter().find(|h| h.to_string() == name).unwrap();
                s.point(s.destination(*h))
            };
            let round = (0..met.len()).map(|i| (end(&met[i]), end(&met[(i + 1) % met.len()])));
            let back = round.filter(|&(a, b)| !orientation(s.point(v), a, b).is_gt()).count();
            assert!(met.len() < 3 || back <= 1, "{v}, seed {seed}: {met:?}");
            assert_eq!(film.len(), met.len() + 2);
        }
    }
    let s = Subdivision::lab_rectangle();
    let gone = algorithms::face_walk(&s, FaceId::new(9), 10).unwrap_err();
    assert!(gone.to_string().contains("f9"), "{gone}");
    assert!(algorithms::vertex_walk(&s, VertexId::new(9), 10).unwrap_err().to_string().contains("v9"));
}

#[test]
fn a_walk_to_a_point_crosses_just_the_edges_between() {
    let mut crossed_in_all = 0;
    for seed in 0..60 {
        let s = Subdivision::delaunay(&points(seed, 25)).unwrap().subdivision;
        let mut number = numbers(seed + 1000);
        let first = s.vertices().next().unwrap();
        // Between the lines of the grid, so that nothing lies on the way.
        let p = Point::new(number(20) as f64 + 0.317, number(20) as f64 + 0.123);
        let mut events = Vec::new();
        let location = s.walk_from_observed(first, p, &mut events).unwrap();
        let from = s.point(first);
        let opposite = |a: std::cmp::Ordering, b: std::cmp::Ordering| a.is_ne() && a == b.reverse();
        let crossed: BTreeSet<_> = s
            .edges()
            .filter(|e| {
                let [a, b] = e.half_edges().map(|h| s.point(s.origin(h)));
                opposite(orientation(from, p, a), orientation(from, p, b))
                    && opposite(orientation(a, b, from), orientation(a, b, p))
            })
            .collect();
        let over: Vec<_> = events
            .iter()
            .filter_map(|event| match event {
                WalkEvent::Face { over, .. } => over.map(HalfEdgeId::edge),
                WalkEvent::Along(_) => None,
            })
            .collect();
        // The last look at the outer face may find that the point lies outside.
        assert_eq!(over.len(), over.iter().collect::<BTreeSet<_>>().len(), "no edge is crossed twice, seed {seed}");
        assert_eq!(over.iter().copied().collect::<BTreeSet<_>>(), crossed, "seed {seed}");
        crossed_in_all += crossed.len();
        let last = events.iter().rev().find_map(|event| match event {
            WalkEvent::Face { face, .. } => Some(*face),
            WalkEvent::Along(_) => None,
        });
        assert_eq!(Some(location), last.map(Location::Face), "seed {seed}");
        let film = algorithms::location_walk(&s, first, p, 1000).unwrap();
        assert_eq!(film.len(), events.len() + 2, "seed {seed}");
        assert_every_frame_differs(&film);
    }
    assert!(crossed_in_all > 100, "{crossed_in_all}");
}
