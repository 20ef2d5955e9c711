//! Films of solids: the hull in space, subdivision, hill climbing.

use super::{assert_every_frame_differs, numbers};
use dcel_kit::figure::algorithms;
use dcel_kit::solid::{Direction, HullEvent, HullFaces, Platonic, Polyhedron, Selection, SubdivideEvent, grow::Shape};
use std::collections::{BTreeMap, BTreeSet};

type Place = [f64; 3];

/// Whole numbers, so that volumes are exact.
fn cloud(seed: u64, count: usize) -> Vec<Place> {
    let mut number = numbers(seed);
    (0..count).map(|_| [0; 3].map(|_: i32| number(40) as f64)).collect()
}

/// Six times the volume of a tetrahedron: positive if d lies below the plane of a, b, c, seen from where they run
/// counter-clockwise.
fn volume([a, b, c]: [Place; 3], d: Place) -> f64 {
    let minus = |p: Place| [p[0] - d[0], p[1] - d[1], p[2] - d[2]];
    let [a, b, c] = [minus(a), minus(b), minus(c)];
    a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0])
}

fn turned([a, b, c]: [u32; 3]) -> [u32; 3] {
    [[a, b, c], [b, c, a], [c, a, b]].into_iter().min().unwrap()
}

#[test]
fn at_each_step_the_triangles_are_the_hull_of_the_points_so_far() {
    for seed in 0..40 {
        let points = cloud(seed, 6 + seed as usize % 15);
        let mut events = Vec::new();
        let hull = Polyhedron::convex_hull_observed(&points, HullFaces::Triangles, &mut events);
        if hull.is_err() {
            continue;
        }
        let at = |t: [u32; 3]| t.map(|i| points[i as usize]);
        let mut now: BTreeSet<[u32; 3]> = BTreeSet::new();
        let mut so_far: BTreeSet<u32> = BTreeSet::new();
        let mut added = 0;
        for event in &events {
            match event {
                HullEvent::Tetrahedron(four) => {
                    now.extend(four.map(turned));
                    so_far.extend(four.as_flattened());
                }
                HullEvent::Inside(p) => {
                    so_far.insert(*p);
                }
                HullEvent::Added { point, seen, horizon } => {
                    let sees = |t: &&[u32; 3]| volume(at(**t), points[*point as usize]) < 0.0;
                    let expected: BTreeSet<[u32; 3]> = now.iter().filter(sees).copied().collect();
                    let seen: BTreeSet<[u32; 3]> = seen.iter().map(|&t| turned(t)).collect();
                    assert_eq!(seen, expected, "point {point}, seed {seed}");
                    // The rim: sides of triangles that go whose other side stays.
                    let sides = |t: &[u32; 3]| [[t[0], t[1]], [t[1], t[2]], [t[2], t[0]]];
                    let going: BTreeSet<[u32; 2]> = seen.iter().flat_map(sides).collect();
                    let rim: BTreeSet<[u32; 2]> =
                        going.iter().copied().filter(|&[a, b]| !going.contains(&[b, a])).collect();
                    assert_eq!(horizon.iter().copied().collect::<BTreeSet<_>>(), rim, "point {point}, seed {seed}");
                    now.retain(|t| !seen.contains(t));
                    now.extend(rim.iter().map(|&[a, b]| turned([a, b, *point])));
                    so_far.insert(*point);
                    added += 1;
                }
            }
            for &t in &now {
                let above = so_far.iter().find(|&&p| volume(at(t), points[p as usize]) < 0.0);
                assert_eq!(above, None, "{t:?} after {event:?}, seed {seed}");
            }
        }
        assert_eq!(so_far.len(), points.len(), "every point comes, seed {seed}");
        let film = algorithms::convex_hull_in_space(&points, 1000).unwrap();
        assert_eq!(film.len(), 2 + 2 * added, "seed {seed}");
        assert_every_frame_differs(&film);
    }
    let flat = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]];
    assert!(algorithms::convex_hull_in_space(&flat, 10).is_err());
}

#[test]
fn a_step_of_subdivision_finds_a_place_for_each_face_edge_and_vertex() {
    let torus = Shape::Torus { n: 3, m: 4 }.build().unwrap().polyhedron;
    for solid in [Polyhedron::platonic(Platonic::Cube), Polyhedron::platonic(Platonic::Dodecahedron), torus] {
        let mut events = Vec::new();
        let fine = solid.catmull_clark_observed(&Selection::new(), &mut events).unwrap().polyhedron;
        let mut vertices: BTreeMap<_, SubdivideEvent> = BTreeMap::new();
        for &event in &events {
            let v = match event {
                SubdivideEvent::Face { vertex, face } => {
                    let corners: Vec<Place> =
                        solid.topology().incident_vertices(face).map(|v| solid.point(v)).collect();
                    let mean = [0, 1, 2].map(|i| corners.iter().map(|p| p[i]).sum::<f64>() / corners.len() as f64);
                    assert!((0..3).all(|i| (mean[i] - fine.point(vertex)[i]).abs() < 1e-9), "{face}");
                    vertex
                }
                SubdivideEvent::Edge { vertex, edge } => {
                    // It is joined to both ends of the edge.
                    let neighbours: BTreeSet<_> = fine.topology().adjacent_vertices(vertex).collect();
                    let ends = edge.half_edges().map(|h| solid.topology().origin(h));
                    assert!(ends.iter().all(|v| neighbours.contains(v)), "{edge}");
                    vertex
                }
                SubdivideEvent::Vertex(vertex) => vertex,
            };
            assert_eq!(vertices.insert(v, event), None, "{v} finds its place once");
        }
        let count = |wanted: fn(&SubdivideEvent) -> bool| events.iter().filter(|event| wanted(event)).count();
        assert_eq!(count(|event| matches!(event, SubdivideEvent::Face { .. })), solid.face_count());
        assert_eq!(count(|event| matches!(event, SubdivideEvent::Edge { .. })), solid.edge_count());
        assert_eq!(vertices.len(), fine.vertex_count());
        let film = algorithms::catmull_clark(&solid, &Selection::new(), 1).unwrap();
        assert_eq!(film.len(), 1 + 4);
        assert_every_frame_differs(&film);
    }
}

#[test]
fn a_climb_goes_to_the_highest_neighbour_and_ends_at_the_top() {
    // A ball of whole numbers, and one whose faces are not exactly flat.
    let ball = Polyhedron::convex_hull(&cloud(7, 60), HullFaces::Triangles).unwrap().solid;
    let solids = [ball, Polyhedron::platonic(Platonic::Icosahedron), Polyhedron::platonic(Platonic::Dodecahedron)];
    for (seed, solid) in (0..20).flat_map(|seed| solids.iter().map(move |solid| (seed, solid))) {
        let convex = solid.check_convex().unwrap();
        let mut number = numbers(seed);
        let d: Place = [0; 3].map(|_: i32| number(200) as f64 - 100.5);
        let direction = Direction::try_from(d).unwrap();
        let start = solid.vertices().nth(number(12) as usize).unwrap();
        let film = algorithms::hill_climbing(solid, &convex, direction, start, 1000);
        let height = |v| {
            let p = solid.point(v);
            d[0] * p[0] + d[1] * p[1] + d[2] * p[2]
        };
        // The climb again, from the names in the headings.
        let way: Vec<String> = film
            .captions()
            .filter(|(heading, _)| heading.starts_with("Vertex"))
            .map(|(heading, _)| heading.rsplit(' ').next().unwrap().to_owned())
            .collect();
        let vertex = |name: &str| solid.vertices().find(|v| v.to_string() == name).unwrap();
        assert_eq!((vertex(&way[0]), film.len()), (start, way.len() + 1), "seed {seed}");
        for pair in way.windows(2) {
            // All corners of the faces round it: those of faces that are not exactly flat count as neighbours. Is the
            // best of all no neighbour, the faces there are flat.
            let at = vertex(&pair[0]);
            let next = vertex(&pair[1]);
            let is_beside = solid.topology().adjacent_vertices(at).any(|v| v == next);
            let faces = solid.topology().outgoing_half_edges(at).map(|h| solid.topology().face(h));
            let corners = faces.flat_map(|f| solid.topology().incident_vertices(f));
            let around: Vec<_> = match is_beside {
                true => solid.topology().adjacent_vertices(at).collect(),
                false => corners.collect(),
            };
            let best = around.into_iter().map(height).fold(f64::NEG_INFINITY, f64::max);
            assert!((height(vertex(&pair[1])) - best).abs() < 1e-9, "{pair:?}, seed {seed}");
            assert!(height(vertex(&pair[1])) > height(vertex(&pair[0])) - 1e-9, "{pair:?}, seed {seed}");
        }
        let top = solid.vertices().map(height).fold(f64::NEG_INFINITY, f64::max);
        assert!((height(vertex(way.last().unwrap())) - top).abs() < 1e-9, "seed {seed}");
        assert_every_frame_differs(&film);
    }
}
