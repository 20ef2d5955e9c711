//! Triangulations with edges that stay.

use crate::common::{Random, f};
use crate::families::{FAMILIES, check, corners, edges, points};
use dcel_kit::plane::predicates::{in_circle, orientation};
use dcel_kit::plane::{ConstrainedDelaunay, Point, Subdivision};
use dcel_kit::{EdgeId, FaceId};

/// Whether two segments have a point in common that is an end of neither, or one end inside the other.
fn meet(a: Point, b: Point, c: Point, d: Point) -> bool {
    let inside = |p: Point| {
        let (low, high) = (a.x.min(b.x), a.x.max(b.x));
        let (bottom, top) = (a.y.min(b.y), a.y.max(b.y));
        p != a && p != b && p.x >= low && p.x <= high && p.y >= bottom && p.y <= top && orientation(a, b, p).is_eq()
    };
    let other = |p: Point, q: Point, r: Point, s: Point| {
        let (one, two) = (orientation(p, q, r), orientation(p, q, s));
        one.is_ne() && one == two.reverse()
    };
    let again = inside(c) || inside(d);
    again || (other(a, b, c, d) && other(c, d, a, b))
}

/// Distinct points and segments between them that meet at common ends only, as many as come out of `tries`.
fn graph(family: &str, n: usize, tries: usize, random: &mut Random) -> Subdivision {
    let mut places: Vec<Point> = Vec::new();
    for p in points(family, n, random) {
        if !places.contains(&p) {
            places.push(p);
        }
    }
    let mut segments: Vec<[u32; 2]> = Vec::new();
    for _ in 0..tries {
        let [i, j] = [0; 2].map(|_| random.below(places.len()));
        let (a, b) = (places[i], places[j]);
        let free = |&[k, l]: &[u32; 2]| {
            let (c, d) = (places[k as usize], places[l as usize]);
            !meet(a, b, c, d) && !meet(c, d, a, b) && ![[a, b], [b, a]].contains(&[c, d])
        };
        let passes = places.iter().any(|&p| meet(a, b, p, p));
        if i != j && !passes && segments.iter().all(free) {
            segments.push([i as u32, j as u32]);
        }
    }
    Subdivision::from_graph(&places, &segments).unwrap()
}

/// The definition: whatever lies in the circle of a triangle is hidden from it by an edge that stays.
#[track_caller]
fn check_constrained(graph: &Subdivision, made: &ConstrainedDelaunay, context: &str) {
    let s = &made.subdivision;
    assert_eq!(dcel_kit::topology::violations(s), [], "{context}");
    assert_eq!(s.geometry_violations(), [], "{context}");
    assert_eq!(s.vertices().collect::<Vec<_>>(), graph.vertices().collect::<Vec<_>>(), "{context}");
    assert_eq!(s.non_delaunay_edges(|e| made.constrained[e]).count(), 0, "{context}");
    let walls: Vec<[Point; 2]> = graph.edges().map(|e| e.half_edges().map(|h| graph.point(graph.origin(h)))).collect();
    for e in graph.edges() {
        let [u, w] = e.half_edges().map(|h| graph.origin(h));
        let h = s.find_half_edge(u, w).unwrap_or_else(|| panic!("{context}: {e} is missing"));
        assert!(made.constrained[h.edge()], "{context}: {e}");
    }
    let count = made.constrained.iter().filter(|(_, constrained)| **constrained).count();
    assert_eq!(count, graph.edge_count(), "{context}");
    for face in s.faces().skip(1) {
        let [a, b, c] = corners(s, face)[..] else { panic!("{context}: {face} is no triangle") };
        for p in s.vertices().map(|v| s.point(v)).filter(|p| ![a, b, c].contains(p)) {
            let centre = Point::new((a.x + b.x + c.x) / 3.0, (a.y + b.y + c.y) / 3.0);
            let inside = |[k, l]: [Point; 2]| orientation(k, l, centre).is_gt();
            // Of needles the rounded centre may lie outside.
            if in_circle(a, b, c, p).is_gt() && [[a, b], [b, c], [c, a]].into_iter().all(inside) {
                let hidden = |q: Point| walls.iter().any(|&[k, l]| meet(p, q, k, l) || meet(k, l, p, q));
                assert!(hidden(centre), "{context}: {p} sees {face}");
            }
        }
    }
}

#[test]
fn all_edges_stay_and_everything_else_is_delaunay() {
    let (mut forced, mut all) = (0, 0);
    for family in FAMILIES {
        for seed in 0..15 {
            let mut random = Random(seed);
            let graph = graph(family, 24, 40, &mut random);
            let context = format!("{family}, seed {seed}");
            let made = graph.constrained_delaunay().unwrap();
            check_constrained(&graph, &made, &context);
            let free = Subdivision::delaunay(&graph.vertices().map(|v| graph.point(v)).collect::<Vec<_>>()).unwrap();
            forced += edges(&graph).difference(&edges(&free.subdivision)).count();
            all += graph.edge_count();
        }
    }
    assert!(forced > 200 && all > 1000, "{forced} of {all} edges were not Delaunay themselves");
}

#[test]
fn without_edges_it_is_the_delaunay_triangulation() {
    let points = points("random", 40, &mut Random(3));
    let alone = Subdivision::from_graph(&points, &[]).unwrap();
    let made = alone.constrained_delaunay().unwrap();
    check(&made.subdivision, "no edges");
    assert_eq!(made.subdivision.hole_faces().count(), made.subdivision.face_count() - 1, "all of it lies outside");
    assert_eq!(edges(&made.subdivision), edges(&Subdivision::delaunay(&points).unwrap().subdivision));
}

/// Twice the area of the bounded face of integer points: the outer cycle counts, rings are taken off.
fn area(s: &Subdivision, face: FaceId) -> f64 {
    let cycle = |start| {
        let ends = s.cycle(start).map(|h| (s.point(s.origin(h)), s.point(s.destination(h))));
        ends.map(|(p, q)| p.x * q.y - p.y * q.x).sum::<f64>()
    };
    s.cycles(face).map(cycle).sum()
}

#[test]
fn triangles_know_the_face_they_lie_in() {
    // A square with a square hole that has an island, a hole face, a lone point, a dangling edge, and a second component.
    let points = [
        (0., 0.),
        (12., 0.),
        (12., 12.),
        (0., 12.), // outline
        (2., 2.),
        (9., 2.),
        (9., 9.),
        (2., 9.), // inner square
        (4., 4.),
        (6., 4.),
        (5., 7.), // island in it
        (1., 11.),
        (11., 11.), // dangling edge from a corner
        (20., 1.),
        (25., 3.),
        (20., 7.),
        (11., 5.), // second component, lone point
    ]; // in rows that show what they are
    let segments = [
        [0, 1],
        [1, 2],
        [2, 3],
        [3, 0],
        [4, 5],
        [5, 6],
        [6, 7],
        [7, 4],
        [8, 9],
        [9, 10],
        [10, 8],
        [2, 12],
        [13, 14],
        [14, 15],
        [15, 13],
        [3, 11],
    ];
    let mut graph = Subdivision::from_graph(&points.map(Point::from), &segments).unwrap();
    let inner = graph.mark_holes(&[Point::new(3.0, 3.0)]).unwrap()[0];
    let made = graph.constrained_delaunay().unwrap();
    let s = &made.subdivision;
    check_constrained(&graph, &made, "rooms");
    for face in graph.faces().skip(1) {
        let triangles = s.faces().filter(|&t| made.faces[t] == face);
        let sum: f64 = triangles.map(|t| area(s, t)).sum();
        assert!(sum.total_cmp(&area(&graph, face)).is_eq(), "{face}: {sum}");
    }
    for t in s.faces().skip(1) {
        assert_eq!(s.is_hole(t), made.faces[t] == f(0) || made.faces[t] == inner, "{t}");
    }
    assert_eq!(made.faces[f(0)], f(0));
}

/// Numbers of removed vertices stay free, and a long edge across everything is made.
#[test]
fn gaps_in_the_numbers_stay_and_long_edges_are_made() {
    let mut points: Vec<Point> = (0..400).map(|i| Point::new((i % 20) as f64, (i / 20) as f64 + 0.25)).collect();
    points.extend([Point::new(-1.0, 9.0), Point::new(20.5, 12.0), Point::new(50.0, 50.0)]);
    let mut graph = Subdivision::from_graph(&points, &[[400, 401]]).unwrap();
    for gone in [17, 402] {
        graph.remove_vertex(dcel_kit::VertexId::new(gone)).unwrap();
    }
    let made = graph.constrained_delaunay().unwrap();
    check_constrained(&graph, &made, "a long edge");
    let next = made.subdivision.clone().insert_vertex(Point::new(40.0, 40.0));
    assert!(next.is_ok(), "{next:?}");
    let long: Vec<EdgeId> = made.constrained.iter().filter(|(_, c)| **c).map(|(e, _)| e).collect();
    assert_eq!(long.len(), 1);
}
