//! Faces come and go one by one, against a model that is a list of faces and nothing else.

use super::common::{Random, f, v};
use dcel_kit::solid::{AddFaceError, AddVertexError, Polyhedron, RemoveFaceError, RemoveVertexError, SurfaceJournal};
use dcel_kit::topology::{IdError, PolygonList, Table, isomorphic, measure_with, violations};
use dcel_kit::{FaceId, VertexId};
use std::collections::BTreeMap;

/// The faces, by id, as lists of vertices.
type Model = BTreeMap<FaceId, Vec<VertexId>>;

/// Whether the faces leave no edge with two faces on one side, and at each vertex only open fans or one closed one.
fn is_surface(faces: &Model) -> bool {
    let mut sides = BTreeMap::new();
    for (&face, corners) in faces {
        for i in 0..corners.len() {
            if sides.insert((corners[i], corners[(i + 1) % corners.len()]), face).is_some() {
                return false;
            }
        }
    }
    // At each vertex a face leads from the edge that leaves to the edge that comes in: links of a fan.
    let mut links: BTreeMap<VertexId, BTreeMap<VertexId, VertexId>> = BTreeMap::new();
    for corners in faces.values() {
        let n = corners.len();
        for i in 0..n {
            links.entry(corners[i]).or_default().insert(corners[(i + 1) % n], corners[(i + n - 1) % n]);
        }
    }
    links.values().all(|links| {
        let closed = links.keys().filter(|&&start| {
            let mut at = links[&start];
            while let Some(&next) = links.get(&at).filter(|_| at != start) {
                at = next;
            }
            at == start
        });
        let closed = closed.count();
        closed == 0 || {
            // All links must lie on the one closed fan.
            let start = *links.keys().next().unwrap();
            let mut at = links[&start];
            let mut length = 1;
            while at != start && length < links.len() {
                let Some(&next) = links.get(&at) else { return false };
                at = next;
                length += 1;
            }
            at == start && length == links.len()
        }
    })
}

/// The surface obeys all invariants and holds the faces of the model and no others.
fn check(surface: &Polyhedron, model: &Model, script: &str) {
    assert_eq!(violations(surface), [], "{script}");
    let mut edges: Vec<_> = Vec::new();
    for face in surface.faces().filter(|&f| !surface.is_boundary_face(f)) {
        let mut corners: Vec<_> = surface.incident_vertices(face).collect();
        let mut expected = model.get(&face).unwrap_or_else(|| panic!("{face} is not in the model: {script}")).clone();
        let least = |list: &[VertexId]| (0..list.len()).min_by_key(|&i| list[i]).unwrap();
        let (a, b) = (least(&corners), least(&expected));
        corners.rotate_left(a);
        expected.rotate_left(b);
        assert_eq!(corners, expected, "{face}: {script}");
        for i in 0..corners.len() {
            let (p, q) = (corners[i], corners[(i + 1) % corners.len()]);
            edges.push((p.min(q), p.max(q)));
            let found = surface.find_half_edge(p, q).unwrap_or_else(|| panic!("no {p} -> {q}: {script}"));
            assert_eq!(surface.face(found), face, "{script}");
        }
    }
    edges.sort_unstable();
    edges.dedup();
    assert_eq!(surface.edge_count(), edges.len(), "{script}");
    assert_eq!(surface.face_count(), model.len() + surface.boundary_faces().len(), "{script}");
    for face in surface.boundary_faces() {
        assert!(surface.has_face(face), "{face}: {script}");
    }
    let counts = measure_with(surface, |f| surface.is_boundary_face(f));
    for part in &counts.components {
        assert!(part.euler() % 2 == 0 && part.genus() >= 0, "{part:?}: {script}");
    }
}

/// Random faces on few vertices come and go. What is refused, and why, is what the model says.
#[test]
fn random_scripts_keep_all_laws_and_agree_with_a_list_of_faces() {
    let (mut pinched, mut refused, mut largest) = (0, 0, 0);
    for seed in 0..120 {
        let mut random = Random(seed);
        let mut surface = Polyhedron::new();
        let mut model = Model::new();
        let n = 4 + random.below(9);
        let mut script = format!("seed {seed}:");
        let mut vertices: Vec<VertexId> = (0..n).map(|i| surface.add_vertex([i as f64, 0.0, 0.0]).unwrap()).collect();
        let (mut journal, mut pages) = (SurfaceJournal::new(), Vec::new());
        let mut table = Table::from_view(&surface);
        for _ in 0..60 {
            let before = surface.clone();
            let (mark, pointers) = (journal.len(), journal.kernel().len());
            match random.below(12) {
                0..3 if !model.is_empty() => {
                    let face = *model.keys().nth(random.below(model.len())).unwrap();
                    script.push_str(&format!(" remove_face {face}"));
                    surface.remove_face_with(face, &mut journal).unwrap();
                    model.remove(&face);
                }
                3 if random.below(3) == 0 => {
                    let gone = vertices.swap_remove(random.below(vertices.len()));
                    script.push_str(&format!(" remove_vertex {gone}"));
                    let mut faces = surface.remove_vertex_with(gone, &mut journal).unwrap();
                    faces.sort_unstable();
                    let expected: Vec<_> = model.iter().filter(|(_, c)| c.contains(&gone)).map(|(&f, _)| f).collect();
                    assert_eq!(faces, expected, "{script}");
                    model.retain(|_, corners| !corners.contains(&gone));
                    let again = surface.add_vertex_with([0.0; 3], &mut journal).unwrap();
                    assert_eq!(again, gone, "the free slot is used again: {script}");
                    vertices.push(again);
                }
                _ => {
                    let mut corners: Vec<_> = random.shuffled(n).into_iter().map(|i| vertices[i]).collect();
                    corners.truncate([3, 3, 3, 4, 5][random.below(5)].min(n));
                    script.push_str(&format!(" add_face {corners:?}"));
                    let mut after = model.clone();
                    after.insert(f(u32::MAX), corners.clone());
                    let answer = surface.add_face_with(&corners, &mut journal);
                    assert_eq!(answer.is_ok(), is_surface(&after), "{answer:?}: {script}");
                    match answer {
                        Ok(face) => drop(model.insert(face, corners)),
                        Err(error) => {
                            assert_eq!(surface, before, "{error}: a refusal left a trace: {script}");
                            assert_eq!((before.can_add_face(&corners), journal.len()), (Err(error), mark));
                            refused += 1;
                        }
                    }
                }
            }
            check(&surface, &model, &script);
            largest = largest.max(model.len());
            let gaps = |&v: &VertexId| surface.incident_faces(v).filter(|&f| surface.is_boundary_face(f)).count();
            pinched += usize::from(vertices.iter().any(|v| gaps(v) > 1));
            compare_with_the_builder(&surface, &model, &script);
            journal.kernel().changes()[pointers..].iter().for_each(|change| table.apply(change));
            assert_eq!(rows(&table), rows(&Table::from_view(&surface)), "{script}");
            pages.push((mark, before));
        }
        for (mark, before) in pages.into_iter().rev() {
            surface.undo(&mut journal, mark);
            assert_eq!(surface, before, "undo to {mark}: {script}");
        }
        assert!(journal.is_empty(), "{script}");
    }
    assert!(pinched > 500 && refused > 500 && largest > 8, "{pinched} {refused} {largest}");
}

/// What the rows of a table say, positions apart.
fn rows(table: &Table) -> impl PartialEq + std::fmt::Debug + use<> {
    let outgoing: Vec<_> = table.vertices.iter().flatten().map(|row| row.outgoing).collect();
    let halves: Vec<_> = table.half_edges.iter().flatten().copied().collect();
    (outgoing, halves, table.faces.iter().flatten().cloned().collect::<Vec<_>>())
}

/// Where no vertex has two fans, the builder makes the same structure of the same faces.
fn compare_with_the_builder(surface: &Polyhedron, model: &Model, script: &str) {
    let mut list = PolygonList::new();
    for corners in model.values() {
        list.push_face(&corners.iter().map(|v| v.number()).collect::<Vec<_>>());
    }
    let points = vec![[0.0; 3]; surface.vertex_bound()];
    if let Ok(built) = Polyhedron::from_polygons(points, &list) {
        let mut bare = surface.clone();
        for v in surface.vertices().filter(|&v| surface.outgoing(v).is_none()) {
            bare.remove_vertex(v).unwrap();
        }
        assert!(isomorphic(&bare, &built).is_ok(), "{script}");
        assert_eq!(surface.boundary_faces().len(), built.boundary_faces().len(), "{script}");
    }
}

#[test]
fn a_grid_grown_face_by_face_has_one_boundary_face_all_the_time() {
    let side = 12;
    let mut surface = Polyhedron::new();
    let at = |x: u32, y: u32| v(y * (side + 1) + x);
    for i in 0..(side + 1) * (side + 1) {
        surface.add_vertex([f64::from(i % (side + 1)), f64::from(i / (side + 1)), 0.0]).unwrap();
    }
    let mut first = None;
    for y in 0..side {
        for x in 0..side {
            surface.add_face(&[at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)]).unwrap();
            let borders: Vec<_> = surface.boundary_faces().collect();
            assert_eq!(borders.len(), 1, "after {x} {y}");
            assert_eq!(*first.get_or_insert(borders[0]), borders[0], "the boundary face keeps its number");
        }
    }
    // Every other face of the inside goes: a boundary face for each.
    let inner: Vec<_> = (1..side - 1)
        .flat_map(|y| (1..side - 1).map(move |x| (x, y)))
        .filter(|(x, y)| x % 2 == 1 && y % 2 == 1)
        .collect();
    for &(x, y) in &inner {
        let between = surface.find_half_edge(at(x, y), at(x + 1, y)).unwrap();
        surface.remove_face(surface.face(between)).unwrap();
    }
    assert_eq!(surface.boundary_faces().len(), 1 + inner.len());
    assert_eq!(violations(&surface), []);
}

/// The page's code walks on from an edge of a face that it has just removed: `prev` was cleared.
#[test]
fn removing_a_vertex_does_not_read_links_it_has_cleared() {
    let octahedron = PolygonList::from_triangles(&[
        [0, 2, 4],
        [2, 1, 4],
        [1, 3, 4],
        [3, 0, 4],
        [2, 0, 5],
        [1, 2, 5],
        [3, 1, 5],
        [0, 3, 5],
    ]);
    let mut surface = Polyhedron::from_polygons(vec![[0.0; 3]; 6], &octahedron).unwrap();
    assert_eq!(surface.remove_vertex(v(4)).unwrap().len(), 4);
    assert_eq!((surface.vertex_count(), surface.edge_count(), surface.face_count()), (5, 8, 5));
    assert_eq!(violations(&surface), []);
    // And back again, in another order.
    let top = surface.add_vertex([0.0; 3]).unwrap();
    for [a, b] in [[1, 3], [0, 2], [3, 0], [2, 1]] {
        surface.add_face(&[v(a), v(b), top]).unwrap();
    }
    assert!(isomorphic(&surface, &Polyhedron::from_polygons(vec![[0.0; 3]; 6], &octahedron).unwrap()).is_ok());
}

/// On the page the border half of an edge has no `next`, so that a walk round a border vertex falls off.
#[test]
fn a_border_half_edge_has_a_next_and_a_face() {
    let mut surface = Polyhedron::new();
    let v: Vec<_> = (0..4).map(|i| surface.add_vertex([f64::from(i), 0.0, 0.0]).unwrap()).collect();
    surface.add_face(&[v[0], v[1], v[2]]).unwrap();
    let border = surface.find_half_edge(v[1], v[0]).unwrap();
    assert_eq!(surface.cycle(border).count(), 3);
    assert_eq!(surface.boundary_faces().collect::<Vec<_>>(), [surface.face(border)]);
    assert_eq!(surface.degree(v[1]), 2);
}

/// On the page the twin of a removed face's edge keeps pointing to it as if it were there.
#[test]
fn no_vertex_points_to_an_edge_that_went() {
    let mut surface = Polyhedron::new();
    let v: Vec<_> = (0..4).map(|i| surface.add_vertex([f64::from(i), 0.0, 0.0]).unwrap()).collect();
    let one = surface.add_face(&[v[0], v[1], v[2]]).unwrap();
    let other = surface.add_face(&[v[2], v[1], v[3]]).unwrap();
    surface.remove_face(one).unwrap();
    assert_eq!(surface.outgoing(v[0]), None);
    assert_eq!((surface.edge_count(), surface.degree(v[1])), (3, 2));
    surface.remove_face(other).unwrap();
    assert_eq!((surface.edge_count(), surface.face_count(), surface.boundary_faces().len()), (0, 0, 0));
}

#[test]
fn every_refusal_names_what_is_in_the_way() {
    let mut surface = Polyhedron::new();
    let v: Vec<_> = (0..9).map(|i| surface.add_vertex([f64::from(i), 0.0, 0.0]).unwrap()).collect();
    // A closed tetrahedron on v0 v1 v2 v3, two triangles that touch in v4 on the side.
    for [a, b, c] in [[0, 2, 1], [0, 1, 3], [1, 2, 3]] {
        surface.add_face(&[v[a], v[b], v[c]]).unwrap();
    }
    let (border, before) = (surface.boundary_faces().next().unwrap(), surface.clone());
    let refuse = |surface: &mut Polyhedron, corners: &[VertexId]| surface.add_face(corners).unwrap_err();
    let h = surface.find_half_edge(v[1], v[3]).unwrap();
    assert_eq!(refuse(&mut surface, &[v[0], v[1]]), AddFaceError::TooFewCorners { corners: 2 });
    assert_eq!(refuse(&mut surface, &[v[0], v[3], v[0]]), AddFaceError::RepeatedVertex { vertex: v[0] });
    let many: Vec<_> = v.iter().chain(&v).copied().collect();
    assert_eq!(refuse(&mut surface, &many), AddFaceError::RepeatedVertex { vertex: v[0] });
    let missing = VertexId::new(9);
    assert_eq!(
        refuse(&mut surface, &[v[0], v[1], missing]),
        AddFaceError::Id(IdError::OutOfRange { element: missing.into(), count: 9, bound: 9 })
    );
    let edge = AddFaceError::EdgeFull {
        edge: h.edge(),
        from: v[1],
        to: v[3],
        faces: [surface.face(h), surface.face(h.twin())],
    };
    assert_eq!(refuse(&mut surface, &[v[1], v[3], v[5]]), edge);
    let taken = surface.find_half_edge(v[0], v[2]).unwrap();
    let turned = AddFaceError::AgainstWinding { half_edge: taken, from: v[0], to: v[2], face: f(0) };
    assert_eq!(refuse(&mut surface, &[v[0], v[2], v[5]]), turned);
    assert_eq!(refuse(&mut surface, &[v[1], v[5], v[6]]), AddFaceError::ClosedVertex { vertex: v[1] });
    assert_eq!(surface.remove_face(border), Err(RemoveFaceError::BoundaryFace { face: border }));
    assert!(matches!(surface.remove_face(f(77)), Err(RemoveFaceError::Id(_))));
    assert!(matches!(surface.remove_vertex(missing), Err(RemoveVertexError::Id(_))));
    assert!(matches!(surface.add_vertex([0.0, f64::NAN, 0.0]), Err(AddVertexError::Coordinate(_))));
    assert_eq!(surface, before);
    // A second fan at v0, then the face that would close the first one.
    surface.add_face(&[v[0], v[5], v[6]]).unwrap();
    let before = surface.clone();
    let error = refuse(&mut surface, &[v[2], v[0], v[3]]);
    assert!(matches!(error, AddFaceError::ClosesFan { vertex, .. } if vertex == v[0]), "{error}");
    assert_eq!(surface, before);
}

/// An edge or a vertex that came back from the journal is used again in the same order as if nothing had been.
#[test]
fn undo_gives_back_positions_and_boundary_faces() {
    let mut surface = Polyhedron::new();
    let v: Vec<_> = (0..4).map(|i| surface.add_vertex([f64::from(i), 1.0, 2.0]).unwrap()).collect();
    let face = surface.add_face(&[v[0], v[1], v[2]]).unwrap();
    let (start, mut journal) = (surface.clone(), SurfaceJournal::new());
    surface.remove_vertex_with(v[3], &mut journal).unwrap();
    let again = surface.add_vertex_with([9.0; 3], &mut journal).unwrap();
    surface.add_vertex_with([8.0; 3], &mut journal).unwrap();
    surface.remove_face_with(face, &mut journal).unwrap();
    assert_eq!((surface.point(again), surface.boundary_faces().len()), ([9.0; 3], 0));
    surface.undo(&mut journal, 0);
    assert_eq!((surface.point(v[3]), surface.boundary_faces().len()), ([3.0, 1.0, 2.0], 1));
    assert_eq!(surface, start);
}
