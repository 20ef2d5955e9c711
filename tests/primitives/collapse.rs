//! The link condition against doing it and looking.

use crate::common::{Random, v};
use dcel_kit::topology::{CollapseEdgeError, Dcel, PolygonList, violations};
use dcel_kit::{FaceId, HalfEdgeId, VertexId};
use std::collections::BTreeSet;

/// No loop, no parallel edges, no face with less than three sides or twice at a vertex.
fn is_clean(d: &Dcel) -> bool {
    let ends = |e: dcel_kit::EdgeId| {
        let a = e.half_edges()[0];
        let (u, w) = (d.origin(a), d.destination(a));
        (u.min(w), u.max(w))
    };
    let edges: BTreeSet<_> = d.edges().map(ends).collect();
    let simple = edges.len() == d.edge_count() && edges.iter().all(|(u, w)| u != w);
    simple
        && d.faces().all(|f| {
            let corners: BTreeSet<VertexId> = d.incident_vertices(f).collect();
            corners.len() >= 3 && corners.len() == d.incident_half_edges(f).count()
        })
}

/// Contracts the edge and takes two-sided faces away, whatever comes of it. `None` if even that cannot be done.
fn plainly(d: &Dcel, a: HalfEdgeId) -> Option<Dcel> {
    let mut after = d.clone();
    after.join_vertices(a).ok()?;
    loop {
        let two_sided = after.faces().find(|&f| after.incident_half_edges(f).count() == 2);
        let Some(f) = two_sided else { return Some(after) };
        after.join_faces(after.half_edge(f)?).ok()?;
    }
}

/// Polyhedra and random triangulations of sphere and torus, without loops and parallel edges.
fn solids() -> Vec<(String, Dcel)> {
    let polygons = |n, faces: &[&[u32]]| {
        let mut list = PolygonList::new();
        faces.iter().for_each(|face| list.push_face(face));
        Dcel::from_polygons(n, &list).unwrap().dcel
    };
    let mut all = vec![
        ("tetrahedron".to_owned(), polygons(4, &[&[0, 2, 1], &[0, 1, 3], &[1, 2, 3], &[2, 0, 3]])),
        ("pyramid".to_owned(), polygons(5, &[&[3, 2, 1, 0], &[0, 1, 4], &[1, 2, 4], &[2, 3, 4], &[3, 0, 4]])),
        ("prism".to_owned(), polygons(6, &[&[2, 1, 0], &[3, 4, 5], &[0, 1, 4, 3], &[1, 2, 5, 4], &[2, 0, 3, 5]])),
        ("an open strip".to_owned(), polygons(6, &[&[0, 1, 2], &[2, 1, 3], &[2, 3, 4], &[4, 3, 5]])),
        ("an open ring of triangles".to_owned(), {
            let ring: Vec<[u32; 3]> =
                (0..4).flat_map(|i| [[i, (i + 1) % 4, i + 4], [i + 4, (i + 1) % 4, (i + 1) % 4 + 4]]).collect();
            Dcel::from_triangles(8, &ring).unwrap().dcel
        }),
        ("two triangles, one vertex apart".to_owned(), Dcel::polygon(3).unwrap()),
        ("a double-sided square".to_owned(), Dcel::polygon(4).unwrap()),
    ];
    // Two triangles beside an edge of degrees 3 and 3, yet no tetrahedron.
    let (_, mut dented) = all[0].clone();
    let opposite = dented.find_half_edge(v(2), v(3)).unwrap();
    dented.split_edge(opposite).unwrap();
    all.push(("a tetrahedron with a vertex on one edge".to_owned(), dented));
    // The 7-vertex torus: the smallest there is, no edge of it can go.
    let torus: Vec<[u32; 3]> =
        (0..7).flat_map(|i| [[i, (i + 1) % 7, (i + 3) % 7], [i, (i + 3) % 7, (i + 2) % 7]]).collect();
    all.push(("the torus of 7 vertices".to_owned(), Dcel::from_triangles(7, &torus).unwrap().dcel));
    for seed in 0..30 {
        let name = all[if seed % 3 == 0 { 8 } else { 0 }].clone();
        let (mut random, mut d, mut log) = (Random(seed), name.1, format!("{}, seed {seed}:", name.0));
        for _ in 0..seed % 9 {
            // A vertex split over at least one triangle on each side, then the two corners closed by diagonals.
            let first = HalfEdgeId::new(random.below(d.half_edge_bound()) as u32);
            let last = (0..1 + random.below(d.degree(d.origin(first)) - 1)).fold(first, |x, _| d.ccw(x));
            log.push_str(&format!(" {first} {last}"));
            let (a, _) = d.split_vertex(first, last).unwrap();
            for side in [a, a.twin()] {
                let far = d.prev(d.prev(side));
                if d.cycle(side).count() == 4 {
                    d.split_face(side, far).unwrap();
                }
            }
        }
        all.push((log, d));
    }
    all
}

#[test]
fn the_link_condition_is_what_doing_it_shows() {
    let (mut accepted, mut refused) = (0, 0);
    for (name, before) in solids() {
        if !is_clean(&before) {
            continue;
        }
        for a in before.half_edges() {
            let context = format!("{name}, collapse_edge {a}");
            let expected = plainly(&before, a).filter(is_clean);
            let mut after = before.clone();
            match after.collapse_edge(a) {
                Ok(gone) => {
                    accepted += 1;
                    assert_eq!(gone, before.destination(a), "{context}");
                    let expected = expected.unwrap_or_else(|| panic!("{context}: must be refused"));
                    assert_eq!(dcel_kit::topology::isomorphic(&after, &expected).map(drop), Ok(()), "{context}");
                    assert_eq!(violations(&after), [], "{context}");
                    // What survives: all edges of the origin.
                    for b in before.outgoing_half_edges(before.origin(a)).filter(|&b| b != a) {
                        assert!(after.has_half_edge(b) && after.origin(b) == before.origin(a), "{context}: {b}");
                    }
                }
                Err(CollapseEdgeError::TooSmall { vertices, .. }) => {
                    assert_eq!((before.vertex_count(), before.face_count() < 5), (vertices, true), "{context}");
                }
                Err(error) => {
                    refused += 1;
                    assert!(expected.is_none(), "{context}: {error}");
                }
            }
        }
    }
    assert!(accepted > 300 && refused > 300, "{accepted} {refused}");
}

#[test]
fn no_edge_of_the_torus_of_7_vertices_collapses_and_all_of_the_octahedron_do() {
    let (_, torus) = solids().swap_remove(8);
    assert!(
        torus
            .half_edges()
            .all(|a| matches!(torus.can_collapse_edge(a), Err(CollapseEdgeError::CommonNeighbour { .. })))
    );
    let octahedron: Vec<[u32; 3]> = (0..4).flat_map(|i| [[i, (i + 1) % 4, 4], [(i + 1) % 4, i, 5]]).collect();
    let octahedron = Dcel::from_triangles(6, &octahedron).unwrap().dcel;
    for a in octahedron.half_edges() {
        let mut d = octahedron.clone();
        d.collapse_edge(a).unwrap();
        assert_eq!((d.vertex_count(), d.edge_count(), d.face_count()), (5, 9, 6));
    }
}

#[test]
fn a_face_with_more_than_three_sides_loses_one_and_stays() {
    let mut square = Dcel::polygon(5).unwrap();
    square.collapse_edge(HalfEdgeId::new(0)).unwrap();
    let sides = [0, 1].map(|f| square.incident_half_edges(FaceId::new(f)).count());
    assert_eq!((sides, square.vertex_count()), ([4, 4], 4));
    assert_eq!(square.vertices().next(), Some(v(0)));
}

/// A sphere of many triangles goes down to a tetrahedron, every edge that may go taken at random.
#[test]
fn random_collapses_end_at_the_tetrahedron() {
    for seed in 0..8 {
        let mut random = Random(seed);
        let mut d = Dcel::from_triangles(4, &[[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]).unwrap().dcel;
        for _ in 0..40 {
            // A point in a face: a spur and two spokes.
            let f = FaceId::new(random.below(d.face_count()) as u32);
            let first = d.half_edge(f).unwrap();
            let (corner, second, third) = (d.ccw(first), d.next(first), d.prev(first));
            let (a, _) = d.split_vertex(corner, corner).unwrap();
            let (b, _) = d.split_face(second, a.twin()).unwrap();
            d.split_face(third, b.twin()).unwrap();
        }
        assert_eq!((d.vertex_count(), d.face_count()), (44, 84));
        while d.vertex_count() > 4 {
            let edges: Vec<HalfEdgeId> = d.half_edges().filter(|&a| d.can_collapse_edge(a).is_ok()).collect();
            assert!(!edges.is_empty(), "seed {seed}: stuck at {} vertices", d.vertex_count());
            d.collapse_edge(edges[random.below(edges.len())]).unwrap();
            assert!(is_clean(&d) && violations(&d).is_empty(), "seed {seed}");
            assert_eq!(d.edge_count(), 3 * d.vertex_count() - 6, "seed {seed}");
        }
    }
}
