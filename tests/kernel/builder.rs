//! Promise: a list of faces becomes exactly the structure that a slow, plain builder makes of it, with the
//! documented numbers; and a list that is not a surface is refused with exactly the error the rules name.
//!
//! The slow builder below shares no code with the kit: directed edges in a `BTreeMap`, fans by repeated merging.

use dcel_kit::topology::{BuildError, Built, Dcel, PolygonList, faces_to_turn};
use dcel_kit::{FaceId, HalfEdgeId, VertexId};
use std::collections::{BTreeMap, BTreeSet};

// ---- the slow builder -----------------------------------------------------------------------------------

/// Every pointer of a structure, by number.
#[derive(Debug, PartialEq, Eq, Default)]
struct Pointers {
    /// origin, next, prev, face
    half_edges: Vec<[u32; 4]>,
    outgoing: Vec<Option<u32>>,
    boundary: Vec<Option<u32>>,
    boundary_faces: Vec<u32>,
}

impl From<Built> for Pointers {
    fn from(built: Built) -> Self {
        let d = &built.dcel;
        let half_edge = |h| [d.origin(h).number(), d.next(h).number(), d.prev(h).number(), d.face(h).number()];
        Self {
            half_edges: d.half_edges().map(half_edge).collect(),
            outgoing: d.vertices().map(|v| d.outgoing(v).map(HalfEdgeId::number)).collect(),
            boundary: d.faces().map(|f| d.half_edge(f).map(HalfEdgeId::number)).collect(),
            boundary_faces: built.boundary_faces.into_iter().map(FaceId::number).collect(),
        }
    }
}

fn sides(face: &[u32]) -> impl Iterator<Item = (u32, u32)> + '_ {
    (0..face.len()).map(|k| (face[k], face[(k + 1) % face.len()]))
}

fn slow_check_faces(vertices: usize, faces: &[Vec<u32>]) -> Result<(), BuildError> {
    for (face, corners) in (0..).zip(faces) {
        if corners.len() < 3 {
            return Err(BuildError::TooFewCorners { face, corners: corners.len() });
        }
        let mut seen = BTreeSet::new();
        for &vertex in corners {
            if vertex as usize >= vertices {
                return Err(BuildError::IndexOutOfRange { face, vertex, vertices });
            }
            if !seen.insert(vertex) {
                return Err(BuildError::RepeatedVertex { face, vertex });
            }
        }
    }
    Ok(())
}

fn slow_check_edges(faces: &[Vec<u32>]) -> Result<(), BuildError> {
    let mut uses = BTreeMap::<(u32, u32), Vec<(u32, bool)>>::new();
    for (face, corners) in (0..).zip(faces) {
        for (u, v) in sides(corners) {
            uses.entry((u.min(v), u.max(v))).or_default().push((face, u < v));
        }
    }
    let rotation_of = |a: &[u32], b: &[u32]| (0..a.len()).any(|k| [&a[k..], &a[..k]].concat() == b);
    let mut taken = BTreeMap::<(u32, u32), Vec<(u32, bool)>>::new();
    for (face, corners) in (0..).zip(faces) {
        for (u, v) in sides(corners) {
            let edge = (u.min(v), u.max(v));
            let earlier = taken.entry(edge).or_default();
            if earlier.len() == 2 || earlier.iter().any(|&(_, up)| up == (u < v)) {
                if let Some(&(first, _)) = earlier.iter().find(|(f, _)| rotation_of(&faces[*f as usize], corners)) {
                    return Err(BuildError::SameFaceTwice { first, second: face });
                }
                return Err(match uses[&edge][..] {
                    [(first, _), (second, _)] => BuildError::MixedWinding { u, v, first, second },
                    _ => {
                        let all = uses[&edge].iter().map(|&(face, _)| face).collect();
                        BuildError::ThreeFaces { u: edge.0, v: edge.1, faces: all }
                    }
                });
            }
            earlier.push((face, u < v));
        }
    }
    Ok(())
}

/// The faces round each vertex, grouped: two belong together if they share an edge at the vertex.
fn slow_check_vertices(vertices: usize, faces: &[Vec<u32>]) -> Result<(), BuildError> {
    for vertex in 0..vertices as u32 {
        let mut fans = Vec::<(BTreeSet<u32>, BTreeSet<u32>)>::new();
        for (face, corners) in (0..).zip(faces) {
            if corners.contains(&vertex) {
                let ends = sides(corners).filter(|&(u, v)| u == vertex || v == vertex).map(|(u, v)| u + v - vertex);
                let mut fan = (BTreeSet::from([face]), ends.collect::<BTreeSet<_>>());
                fans.retain(|other| {
                    let apart = other.1.is_disjoint(&fan.1);
                    if !apart {
                        fan.0.extend(&other.0);
                        fan.1.extend(&other.1);
                    }
                    apart
                });
                fans.push(fan);
            }
        }
        if fans.len() > 1 {
            let mut fans: Vec<u32> = fans.iter().filter_map(|fan| fan.0.first().copied()).collect();
            fans.sort_unstable();
            return Err(BuildError::NonManifoldVertex { vertex, fans });
        }
    }
    Ok(())
}

fn slow_build(vertices: usize, faces: &[Vec<u32>]) -> Result<Pointers, BuildError> {
    slow_check_faces(vertices, faces)?;
    slow_check_edges(faces)?;
    slow_check_vertices(vertices, faces)?;

    let mut number = BTreeMap::new();
    for (u, v) in faces.iter().flat_map(|face| sides(face)) {
        if !number.contains_key(&(u, v)) {
            let h = number.len() as u32;
            number.insert((u, v), h);
            number.insert((v, u), h + 1);
        }
    }
    const NOWHERE: u32 = u32::MAX;
    let mut made = Pointers {
        half_edges: vec![[NOWHERE; 4]; number.len()],
        outgoing: vec![None; vertices],
        boundary: vec![],
        boundary_faces: vec![],
    };
    for (&(u, _), &h) in &number {
        made.half_edges[h as usize][0] = u;
    }
    let add_cycle = |made: &mut Pointers, cycle: &[u32]| {
        let face = made.boundary.len() as u32;
        made.boundary.push(Some(cycle[0]));
        for (h, next) in sides(cycle) {
            made.half_edges[h as usize][1] = next;
            made.half_edges[next as usize][2] = h;
            made.half_edges[h as usize][3] = face;
        }
    };
    for face in faces {
        let cycle: Vec<u32> = sides(face).map(|side| number[&side]).collect();
        for (&v, &h) in face.iter().zip(&cycle) {
            made.outgoing[v as usize].get_or_insert(h);
        }
        add_cycle(&mut made, &cycle);
    }
    let inside: BTreeSet<_> = faces.iter().flat_map(|face| sides(face)).collect();
    let border: BTreeMap<u32, u32> = number.keys().filter(|side| !inside.contains(side)).copied().collect();
    for (&u, v) in &border {
        made.outgoing[u as usize] = Some(number[&(u, *v)]);
    }
    let mut starts: Vec<(u32, u32)> = border.iter().map(|(&u, &v)| (number[&(u, v)], u)).collect();
    starts.sort_unstable();
    for (first, start) in starts {
        if made.half_edges[first as usize][3] == NOWHERE {
            let mut cycle = vec![first];
            let mut at = border[&start];
            while at != start {
                cycle.push(number[&(at, border[&at])]);
                at = border[&at];
            }
            made.boundary_faces.push(made.boundary.len() as u32);
            add_cycle(&mut made, &cycle);
        }
    }
    Ok(made)
}

// ---- comparing ------------------------------------------------------------------------------------------

fn polygons(faces: &[Vec<u32>]) -> PolygonList {
    let mut list = PolygonList::new();
    faces.iter().for_each(|face| list.push_face(face));
    list
}

/// Builds in every way there is, compares with the slow builder, and says whether the faces were accepted.
#[track_caller]
fn compare(vertices: usize, faces: &[Vec<u32>]) -> bool {
    let expected = slow_build(vertices, faces);
    let replay = || format!("compare({vertices}, &{faces:?})");
    let built = Dcel::from_polygons(vertices, &polygons(faces)).map(Pointers::from);
    assert_eq!(built, expected, "{}", replay());
    let triangles: Option<Vec<[u32; 3]>> = faces.iter().map(|face| face[..].try_into().ok()).collect();
    if let Some(triangles) = triangles {
        let built = Dcel::from_triangles(vertices, &triangles).map(Pointers::from);
        assert_eq!(built, expected, "as triangles: {}", replay());
    }
    expected.is_ok()
}

fn refused(vertices: usize, faces: &[&[u32]]) -> BuildError {
    let faces: Vec<_> = faces.iter().map(|face| face.to_vec()).collect();
    assert!(!compare(vertices, &faces));
    Dcel::from_polygons(vertices, &polygons(&faces)).expect_err("the slow builder refused it")
}

struct Random(u64);

impl Random {
    fn below(&mut self, bound: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0.wrapping_mul(0x2545_f491_4f6c_dd1d) >> 33) as usize % bound
    }

    fn shuffle<T>(&mut self, items: &mut [T]) {
        (1..items.len()).for_each(|i| items.swap(i, self.below(i + 1)));
    }
}

// ---- the tests ------------------------------------------------------------------------------------------

#[test]
fn each_error_names_its_elements() {
    use BuildError::*;
    let tri: &[u32] = &[0, 1, 2];
    assert_eq!(refused(4, &[tri, &[1, 3]]), TooFewCorners { face: 1, corners: 2 });
    assert_eq!(refused(4, &[tri, &[]]), TooFewCorners { face: 1, corners: 0 });
    assert_eq!(refused(4, &[tri, &[2, 1, 4]]), IndexOutOfRange { face: 1, vertex: 4, vertices: 4 });
    assert_eq!(refused(4, &[tri, &[2, 1, 3, 1]]), RepeatedVertex { face: 1, vertex: 1 });
    assert_eq!(refused(4, &[tri, &[2, 1, 3], &[1, 2, 0]]), SameFaceTwice { first: 0, second: 2 });
    assert_eq!(refused(5, &[tri, &[2, 1, 3], &[2, 1, 4]]), ThreeFaces { u: 1, v: 2, faces: vec![0, 1, 2] });
    assert_eq!(refused(4, &[tri, &[3, 1, 2]]), MixedWinding { u: 1, v: 2, first: 0, second: 1 });
    assert_eq!(refused(4, &[&[2, 1, 0], &[2, 1, 3]]), MixedWinding { u: 2, v: 1, first: 0, second: 1 });
    assert_eq!(refused(6, &[&[5, 1, 2], &[5, 3, 4]]), NonManifoldVertex { vertex: 5, fans: vec![0, 1] });

    let mut holed = polygons(&[vec![0, 1, 2, 3]]);
    holed.push_hole(&[4, 5, 6]);
    assert_eq!(Dcel::from_polygons(7, &holed), Err(HoleInFace { face: 0 }));
    let full = Dcel::from_triangles(usize::MAX, &[]).unwrap_err();
    assert!(matches!(full, TooMany(_)), "{full}");
}

#[test]
fn errors_say_their_numbers_and_give_them_out() {
    let error = refused(6, &[&[5, 1, 2], &[5, 3, 4]]);
    assert_eq!((error.faces(), error.vertices()), (vec![0, 1], vec![5]));
    let text = error.to_string();
    assert!(text.contains("vertex 5") && text.contains("0, 1"), "{text}");
    let error = refused(5, &[&[0, 1, 2], &[2, 1, 3], &[2, 1, 4]]);
    assert_eq!((error.faces(), error.vertices()), (vec![0, 1, 2], vec![1, 2]));
    let error = refused(4, &[&[0, 1, 2], &[3, 1, 2]]);
    assert_eq!((error.faces(), error.vertices()), (vec![0, 1], vec![1, 2]));
    assert!(error.to_string().contains("faces 0 and 1 both run from vertex 1 to vertex 2"), "{error}");
}

#[test]
fn the_first_face_that_does_not_fit_is_reported() {
    // Face 3 clashes with face 0, and face 2 with face 1: face 2 comes first, though its partner comes later.
    let error = refused(9, &[&[0, 1, 2], &[3, 4, 5], &[3, 4, 6], &[0, 1, 7]]);
    assert_eq!(error, BuildError::MixedWinding { u: 3, v: 4, first: 1, second: 2 });
    // A fault of a later face by itself goes before a clash of earlier ones.
    let error = refused(4, &[&[0, 1, 2], &[0, 1, 2], &[0, 1, 9]]);
    assert_eq!(error, BuildError::IndexOutOfRange { face: 2, vertex: 9, vertices: 4 });
}

#[test]
fn numbers_are_as_documented() {
    let built = Dcel::from_triangles(5, &[[0, 1, 2], [2, 1, 3]]).unwrap();
    let d = &built.dcel;
    let ends: Vec<_> = d.half_edges().map(|h| (d.origin(h).number(), d.destination(h).number())).collect();
    let even: Vec<_> = ends.iter().step_by(2).copied().collect();
    assert_eq!(even, [(0, 1), (1, 2), (2, 0), (1, 3), (3, 2)]);
    let faces: Vec<_> = d.half_edges().map(|h| d.face(h).number()).collect();
    assert_eq!(faces, [0, 2, 0, 1, 0, 2, 1, 2, 1, 2]);
    assert_eq!(d.half_edge(FaceId::new(1)), Some(HalfEdgeId::new(3)), "from the first to the second corner");
    assert_eq!(built.boundary_faces, [FaceId::new(2)]);
    assert_eq!(d.outgoing(VertexId::new(4)), None, "isolated");
    assert!(d.vertices().take(4).all(|v| d.face(d.outgoing(v).unwrap()) == FaceId::new(2)), "on the border");
}

#[test]
fn all_short_lists_of_triangles_agree_with_the_slow_builder() {
    let triples = |n: u32| {
        (0..n * n * n)
            .map(move |i| vec![i / n / n, i / n % n, i % n])
            .filter(|t| t[0] != t[1] && t[1] != t[2] && t[2] != t[0])
    };
    let mut accepted = 0;
    // Up to renaming the first triangle is 0 1 2.
    for a in triples(5) {
        accepted += usize::from(compare(5, &[vec![0, 1, 2], a.clone()]));
        for b in triples(5) {
            accepted += usize::from(compare(5, &[vec![0, 1, 2], a.clone(), b]));
        }
    }
    for (a, b, c) in triples(4).flat_map(|a| {
        triples(4).flat_map(move |b| {
            let a = a.clone();
            triples(4).map(move |c| (a.clone(), b.clone(), c))
        })
    }) {
        accepted += usize::from(compare(4, &[vec![0, 1, 2], a, b, c]));
    }
    assert!(accepted > 100, "only {accepted} lists were accepted: the test says nothing about good ones");
}

/// An octahedron, a torus of 9 quadrilaterals, a disc of mixed polygons, two tetrahedra that touch, a cube.
fn stock() -> Vec<Vec<Vec<u32>>> {
    let octahedron = [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 1], [5, 2, 1], [5, 3, 2], [5, 4, 3], [5, 1, 4]];
    let torus = (0..9).map(|i| {
        let at = |x: u32, y: u32| x % 3 + 3 * (y % 3);
        let (x, y) = (i % 3, i / 3);
        vec![at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)]
    });
    let disc = vec![vec![0, 1, 2, 3, 4], vec![1, 0, 5], vec![2, 1, 5, 6], vec![6, 7, 3, 2], vec![7, 8, 9, 4, 3]];
    let touching = [[0, 1, 2], [0, 2, 3], [0, 3, 1], [3, 2, 1], [0, 4, 5], [0, 5, 6], [0, 6, 4], [6, 5, 4]];
    let cube = [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]];
    vec![
        octahedron.map(|t| t.to_vec()).to_vec(),
        torus.collect(),
        disc,
        touching.map(|t| t.to_vec()).to_vec(),
        cube.map(|t| t.to_vec()).to_vec(),
    ]
}

#[test]
fn random_soups_agree_with_the_slow_builder() {
    let stock = stock();
    let (mut good, mut bad) = (0, 0);
    for seed in 1..=20_000_u64 {
        let mut random = Random(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15));
        let mut faces = stock[random.below(stock.len())].clone();
        random.shuffle(&mut faces);
        faces.truncate(1 + random.below(faces.len()));
        for _ in 0..random.below(3) {
            let i = random.below(faces.len());
            match random.below(5) {
                0 => faces[i].reverse(),
                1 => faces.push(faces[i].clone()),
                2 => {
                    let n = faces[i].len();
                    faces[i][random.below(n)] = random.below(11) as u32;
                }
                3 => drop(faces[i].pop()),
                _ => faces[i].rotate_left(1),
            }
        }
        *if compare(10, &faces) { &mut good } else { &mut bad } += 1;
    }
    assert!(good > 3000 && bad > 3000, "{good} good, {bad} bad: not a fair mixture");
}

#[test]
fn a_double_sided_triangle_is_a_sphere() {
    let built = Dcel::from_triangles(3, &[[0, 1, 2], [0, 2, 1]]).unwrap();
    assert_eq!((built.dcel.vertex_count(), built.dcel.edge_count(), built.dcel.face_count()), (3, 3, 2));
    assert!(built.boundary_faces.is_empty());
    assert!(compare(3, &[vec![0, 1, 2], vec![0, 2, 1]]));
}

#[test]
fn a_torus_is_closed() {
    for (w, h) in [(3, 3), (7, 5)] {
        let at = |x: u32, y: u32| x % w + w * (y % h);
        let faces: Vec<_> = (0..w * h)
            .map(|i| (i % w, i / w))
            .map(|(x, y)| vec![at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)])
            .collect();
        assert!(compare((w * h) as usize, &faces));
        let built = Dcel::from_polygons((w * h) as usize, &polygons(&faces)).unwrap();
        let d = &built.dcel;
        assert_eq!(d.vertex_count() + d.face_count(), d.edge_count(), "Euler's relation for genus 1");
        assert!(built.boundary_faces.is_empty());
        assert!(d.vertices().all(|v| d.degree(v) == 4));
    }
}

#[test]
fn a_one_sided_band_cannot_be_wound() {
    // Five triangles in a ring with a half turn: whichever way they are wound, two neighbours disagree.
    let band = [[0, 1, 2], [2, 1, 3], [2, 3, 4], [4, 3, 0], [4, 0, 1]];
    for turned in 0..32 {
        let faces: Vec<_> = (0..5)
            .map(|i| if turned >> i & 1 == 0 { band[i].to_vec() } else { band[i].iter().rev().copied().collect() })
            .collect();
        assert!(!compare(5, &faces));
        let error = Dcel::from_polygons(5, &polygons(&faces)).unwrap_err();
        assert!(matches!(error, BuildError::MixedWinding { .. }), "{error}");
    }
}

#[test]
fn long_polygons_are_checked_like_short_ones() {
    let ring: Vec<u32> = (0..100).collect();
    let back: Vec<u32> = (0..100).rev().collect();
    assert!(compare(100, std::slice::from_ref(&ring)));
    assert!(compare(100, &[ring.clone(), back]));
    let mut twice = ring.clone();
    twice[99] = 40;
    assert_eq!(refused(100, &[&ring[..40], &twice]), BuildError::RepeatedVertex { face: 1, vertex: 40 });
    // The second polygon may use the vertices of the first.
    let mut fits: Vec<u32> = (50..100).rev().collect();
    fits.extend(100..150);
    assert!(compare(150, &[ring, fits]));
}

#[test]
fn a_hub_of_two_hundred_thousand_triangles() {
    let n = 200_000_u32;
    for (hub, rim) in [(0, 1), (n, 0)] {
        let mut fan: Vec<[u32; 3]> = (0..n).map(|i| [hub, rim + i, rim + (i + 1) % n]).collect();
        for shuffle in [false, true] {
            if shuffle {
                Random(7).shuffle(&mut fan);
            }
            let built = Dcel::from_triangles(n as usize + 1, &fan).unwrap();
            assert_eq!(built.dcel.degree(VertexId::new(hub)), n as usize);
            assert_eq!((built.dcel.edge_count(), built.boundary_faces.len()), (2 * n as usize, 1));
        }
        // A second fan at the same hub is found, and named.
        let last = fan.len() as u32;
        fan.push([hub, n + 1, n + 2]);
        let expected = BuildError::NonManifoldVertex { vertex: hub, fans: vec![0, last] };
        assert_eq!(Dcel::from_triangles(n as usize + 3, &fan), Err(expected));
    }
}

#[test]
fn edges_with_one_sum_of_ends() {
    // Every triangle has an edge (i, s - i), and all differences are equal modulo 8: the longest lists possible.
    let (n, s) = (40_000_u32, 8 * 40_000);
    let mut triangles: Vec<[u32; 3]> = (0..n).map(|i| [4 * i, s - 4 * i, s + 1 + i]).take(n as usize - 1).collect();
    Random(3).shuffle(&mut triangles);
    let vertices = (s + n + 1) as usize;
    let built = Dcel::from_triangles(vertices, &triangles).unwrap();
    assert_eq!(built.dcel.edge_count(), 3 * triangles.len());
    let two = triangles.len() as u32;
    triangles.push([triangles[77][0], triangles[77][1], 1]);
    let [u, v, _] = triangles[77];
    let expected = BuildError::MixedWinding { u, v, first: 77, second: two };
    assert_eq!(Dcel::from_triangles(vertices, &triangles), Err(expected));
}

#[test]
fn large_lists_in_any_order_agree_with_the_slow_builder() {
    let side = 200;
    let at = |x: u32, y: u32| x + (side + 1) * y;
    let mut faces: Vec<Vec<u32>> = (0..side * side)
        .map(|i| (i % side, i / side))
        .filter(|&(x, y)| !(50..60).contains(&x) || !(70..75).contains(&y))
        .flat_map(|(x, y)| {
            let [a, b, c, d] = [at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)];
            [vec![a, b, c], vec![a, c, d]]
        })
        .collect();
    let vertices = ((side + 1) * (side + 1)) as usize;
    let ordered = Dcel::from_polygons(vertices, &polygons(&faces)).unwrap();

    let mut random = Random(11);
    let mut name: Vec<u32> = (0..vertices as u32).collect();
    random.shuffle(&mut name);
    random.shuffle(&mut faces);
    faces.iter_mut().flatten().for_each(|v| *v = name[*v as usize]);
    let shuffled = Dcel::from_polygons(vertices, &polygons(&faces)).unwrap();
    let count = |b: &Built| (b.dcel.vertex_count(), b.dcel.edge_count(), b.dcel.face_count(), b.boundary_faces.len());
    assert_eq!(count(&shuffled), count(&ordered));
    assert_eq!(ordered.boundary_faces.len(), 2, "outside and the window");
    for (f, face) in (0..).map(FaceId::new).zip(&faces) {
        assert!(shuffled.dcel.incident_vertices(f).map(VertexId::number).eq(face.iter().copied()), "{f}");
    }

    // The slow search for fans is quadratic, so only clashes along edges are compared.
    faces[60_000].swap(0, 1);
    let expected = slow_check_edges(&faces).unwrap_err();
    assert_eq!(Dcel::from_polygons(vertices, &polygons(&faces)), Err(expected));
}

#[test]
fn a_face_that_is_wrong_by_itself_is_told_before_faces_that_do_not_fit() {
    // More than 65,536 corners: lists that jump about are matched in another way.
    let side = 150;
    let at = |x: u32, y: u32| x + (side + 1) * y;
    let vertices = ((side + 1) * (side + 1)) as usize;
    let ordered: Vec<[u32; 3]> = (0..side * side)
        .map(|i| (i % side, i / side))
        .flat_map(|(x, y)| [[at(x, y), at(x + 1, y), at(x + 1, y + 1)], [at(x, y), at(x + 1, y + 1), at(x, y + 1)]])
        .collect();
    let mut shuffled = ordered.clone();
    let mut name: Vec<u32> = (0..vertices as u32).collect();
    let mut random = Random(13);
    random.shuffle(&mut name);
    random.shuffle(&mut shuffled);
    shuffled.as_flattened_mut().iter_mut().for_each(|v| *v = name[*v as usize]);
    for faces in [ordered, shuffled] {
        let built = Dcel::from_triangles(vertices, &faces).expect("a grid");
        assert_eq!((built.dcel.face_count(), built.dcel.vertex_count()), (faces.len() + 1, vertices));
        let [a, b, c] = faces[30_000];
        for wrong in [[a, b, vertices as u32], [u32::MAX, b, c], [a, a, c], [a, b, a], [a, b, b]] {
            let mut faces = faces.clone();
            faces[20_000].swap(0, 1);
            faces[30_000] = wrong;
            faces[40_000] = [u32::MAX; 3];
            let lists: Vec<Vec<u32>> = faces.iter().map(|face| face.to_vec()).collect();
            let expected = slow_check_faces(vertices, &lists).unwrap_err();
            assert_eq!(Dcel::from_triangles(vertices, &faces), Err(expected));
        }
    }
}

#[test]
fn a_list_of_polygons_knows_how_many_corners_it_has() {
    let mut list = PolygonList::new();
    assert_eq!(list.corner_count(), 0);
    list.push_face(&[0, 1, 2, 3]);
    list.push_hole(&[4, 5, 6]);
    assert_eq!((list.face_count(), list.cycle_count(), list.corner_count()), (1, 2, 7));
}

#[test]
fn what_is_reserved_is_there_before_it_is_needed() {
    let mut dcel = Dcel::polygon(3).unwrap();
    // 16 bytes a half-edge, 4 a vertex and a face.
    assert!(dcel.memory_bytes() >= 16 * 6 + 4 * 3 + 4 * 2);
    dcel.reserve(1000, 1000, 0);
    let reserved = dcel.memory_bytes();
    assert!(reserved >= 16 * 2000 + 4 * 1000, "{reserved}");
    for _ in 0..900 {
        dcel.split_edge(HalfEdgeId::new(0)).unwrap();
    }
    assert_eq!(dcel.memory_bytes(), reserved, "no column was moved");
}

/// Grids of triangles, and rings of them, some turned over: what is told to be turned makes all agree, and is never more
/// than half of a piece. An odd ring has one side.
#[test]
fn faces_that_are_turned_over_are_found_whoever_they_are() {
    let mut random = Random(16);
    for round in 0..200 {
        // Two pieces side by side, each a strip of triangles that may be closed to a ring.
        let (n, is_ring) = (3 + random.below(9) as u32, round % 2 == 0);
        let mut faces: Vec<[u32; 3]> = Vec::new();
        for piece in 0..2 {
            let v = |i: u32, side: u32| piece * 2 * (n + 1) + 2 * (if is_ring { i % n } else { i }) + side;
            for i in 0..n {
                faces.push([v(i, 0), v(i + 1, 0), v(i, 1)]);
                faces.push([v(i + 1, 0), v(i + 1, 1), v(i, 1)]);
            }
        }
        let mut wrong = vec![false; faces.len()];
        for (face, wrong) in faces.iter_mut().zip(&mut wrong) {
            if random.below(4) == 0 {
                face.swap(1, 2);
                *wrong = true;
            }
        }
        let turned = faces_to_turn(&PolygonList::from_triangles(&faces)).unwrap();
        for piece in 0..2 {
            let range = 2 * n as usize * piece..2 * n as usize * (piece + 1);
            let bad = wrong[range.clone()].iter().filter(|&&wrong| wrong).count();
            let told = range.clone().filter(|&i| turned.contains(&(i as u32)));
            let agree = told.clone().filter(|&i| wrong[i]).count();
            let told = told.count();
            let is_half = 2 * bad == range.len();
            assert_eq!(told, bad.min(range.len() - bad), "{faces:?}: {turned:?}");
            assert!(agree == told && 2 * bad <= range.len() || agree == 0 && (is_half || 2 * bad > range.len()));
        }
    }
    // Five triangles round a band whose ends are glued the wrong way round.
    let band = faces_to_turn(&PolygonList::from_triangles(&[[0, 1, 2], [1, 3, 2], [2, 3, 4], [3, 0, 4], [4, 0, 1]]));
    assert_eq!(band.unwrap_err().band.len(), 5);
}
