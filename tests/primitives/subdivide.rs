//! Both subdivision schemes against their textbook rules on lists of corners, and what they must keep.

use crate::common::Random;
use dcel_kit::solid::grow::Shape;
use dcel_kit::solid::{Polyhedron, Selection, SubdivideError, Subdivided};
use dcel_kit::topology::{PolygonList, measure_with, violations};
use dcel_kit::{EdgeId, FaceId, VertexId};
use std::collections::{BTreeMap, BTreeSet};

type Point = [f64; 3];

#[derive(Clone, Copy, PartialEq, Debug)]
enum Scheme {
    CatmullClark,
    Loop,
}

impl Scheme {
    fn step(self, solid: &Polyhedron, creases: &Selection<EdgeId>) -> Subdivided {
        match self {
            Self::CatmullClark => solid.catmull_clark(creases),
            Self::Loop => solid.loop_subdivision(creases),
        }
        .unwrap()
    }
}

fn faces_of(solid: &Polyhedron) -> Vec<Vec<usize>> {
    let real = solid.faces().filter(|&f| !solid.is_boundary_face(f));
    real.map(|f| solid.incident_vertices(f).map(VertexId::index).collect()).collect()
}

fn solid(points: &[Point], faces: &[Vec<usize>]) -> Polyhedron {
    let mut list = PolygonList::new();
    for face in faces {
        list.push_face(&face.iter().map(|&v| v as u32).collect::<Vec<_>>());
    }
    Polyhedron::from_polygons(points.to_vec(), &list).unwrap()
}

fn mean(points: &[Point]) -> Point {
    std::array::from_fn(|i| points.iter().map(|p| p[i]).sum::<f64>() / points.len() as f64)
}

fn mix(parts: &[(f64, Point)]) -> Point {
    std::array::from_fn(|i| parts.iter().map(|(w, p)| w * p[i]).sum())
}

/// A face as its corners' positions, from the smallest on.
fn normal_face(points: &[Point], face: &[usize]) -> Vec<[i64; 3]> {
    let mut corners: Vec<[i64; 3]> = face.iter().map(|&v| points[v].map(|x| (x * 1e9).round() as i64)).collect();
    let least = (0..corners.len()).min_by_key(|&i| corners[i]).unwrap();
    corners.rotate_left(least);
    corners
}

/// The rules as the papers give them, on lists of corners and sets of edges; everything is found by searching.
struct Textbook {
    points: Vec<Point>,
    faces: Vec<Vec<usize>>,
    creases: BTreeSet<(usize, usize)>,
}

impl Textbook {
    fn of(solid: &Polyhedron, creases: &Selection<EdgeId>) -> Self {
        let ends = |e: EdgeId| {
            let a = e.half_edges()[0];
            let (u, v) = (solid.origin(a).index(), solid.destination(a).index());
            (u.min(v), u.max(v))
        };
        let points = (0..solid.vertex_bound() as u32).map(VertexId::new);
        let points = points.map(|v| if solid.has_vertex(v) { solid.point(v) } else { [0.0; 3] }).collect();
        Self { points, faces: faces_of(solid), creases: creases.ids(255).map(ends).collect() }
    }

    fn beside(&self, u: usize, v: usize) -> Vec<usize> {
        let has = |face: &Vec<usize>| {
            (0..face.len()).any(|i| {
                let pair = (face[i], face[(i + 1) % face.len()]);
                pair == (u, v) || pair == (v, u)
            })
        };
        (0..self.faces.len()).filter(|&f| has(&self.faces[f])).collect()
    }

    fn neighbours(&self, v: usize) -> BTreeSet<usize> {
        let mut all = BTreeSet::new();
        for face in &self.faces {
            for i in 0..face.len() {
                let (a, b) = (face[i], face[(i + 1) % face.len()]);
                if a == v {
                    all.insert(b);
                }
                if b == v {
                    all.insert(a);
                }
            }
        }
        all
    }

    fn is_sharp(&self, u: usize, v: usize) -> bool {
        self.creases.contains(&(u.min(v), u.max(v))) || self.beside(u, v).len() < 2
    }

    /// The finer faces, as positions.
    fn step(&self, scheme: Scheme) -> Vec<Vec<[i64; 3]>> {
        let at = |v: usize| self.points[v];
        let corners = |f: usize| self.faces[f].iter().map(|&v| at(v)).collect::<Vec<_>>();
        let centre: Vec<Point> = (0..self.faces.len()).map(|f| mean(&corners(f))).collect();
        let mut on_edge: BTreeMap<(usize, usize), Point> = BTreeMap::new();
        for v in 0..self.points.len() {
            for w in self.neighbours(v) {
                let beside = self.beside(v, w);
                let point = if self.is_sharp(v, w) {
                    mean(&[at(v), at(w)])
                } else if scheme == Scheme::CatmullClark {
                    mean(&[at(v), at(w), centre[beside[0]], centre[beside[1]]])
                } else {
                    let tip = |f: usize| *self.faces[f].iter().find(|&&x| x != v && x != w).unwrap();
                    let tips = mean(&[at(tip(beside[0])), at(tip(beside[1]))]);
                    mix(&[(0.75, mean(&[at(v), at(w)])), (0.25, tips)])
                };
                on_edge.insert((v, w), point);
            }
        }
        let moved: Vec<Point> = (0..self.points.len()).map(|v| self.vertex(v, scheme, &centre)).collect();
        let mut finer = Vec::new();
        for (f, face) in self.faces.iter().enumerate() {
            let n = face.len();
            let edge = |i: usize| on_edge[&(face[i % n], face[(i + 1) % n])];
            for i in 0..n {
                finer.push(match scheme {
                    Scheme::CatmullClark => vec![moved[face[i]], edge(i), centre[f], edge(i + n - 1)],
                    Scheme::Loop => vec![moved[face[i]], edge(i), edge(i + n - 1)],
                });
            }
            if scheme == Scheme::Loop {
                finer.push((0..n).map(edge).collect());
            }
        }
        normal_faces(&finer)
    }

    fn vertex(&self, v: usize, scheme: Scheme, centre: &[Point]) -> Point {
        let near = self.neighbours(v);
        let (n, here) = (near.len() as f64, self.points[v]);
        let sharp: Vec<Point> = near.iter().filter(|&&w| self.is_sharp(v, w)).map(|&w| self.points[w]).collect();
        if sharp.len() > 2 || near.is_empty() {
            return here;
        }
        if let [a, b] = sharp[..] {
            return mix(&[(1.0 / 8.0, a), (6.0 / 8.0, here), (1.0 / 8.0, b)]);
        }
        let ends: Vec<Point> = near.iter().map(|&w| self.points[w]).collect();
        if scheme == Scheme::CatmullClark {
            let round: Vec<Point> =
                (0..self.faces.len()).filter(|&f| self.faces[f].contains(&v)).map(|f| centre[f]).collect();
            let middles: Vec<Point> = ends.iter().map(|&w| mean(&[w, here])).collect();
            return mix(&[(1.0 / n, mean(&round)), (2.0 / n, mean(&middles)), ((n - 3.0) / n, here)]);
        }
        let beta = 1.0 / n * (5.0 / 8.0 - (3.0 / 8.0 + (std::f64::consts::TAU / n).cos() / 4.0).powi(2));
        mix(&[(1.0 - n * beta, here), (n * beta, mean(&ends))])
    }
}

fn normal_faces(faces: &[Vec<Point>]) -> Vec<Vec<[i64; 3]>> {
    let order: Vec<usize> = (0..faces.iter().map(Vec::len).max().unwrap_or(0)).collect();
    let mut all: Vec<_> = faces.iter().map(|face| normal_face(face, &order[..face.len()])).collect();
    all.sort();
    all
}

fn positions(solid: &Polyhedron) -> Vec<Vec<[i64; 3]>> {
    let place = |v: &usize| solid.point(VertexId::new(*v as u32));
    normal_faces(&faces_of(solid).iter().map(|f| f.iter().map(place).collect()).collect::<Vec<_>>())
}

/// Every face with more than three sides as triangles from its first corner.
fn triangulated(start: &Polyhedron) -> Polyhedron {
    let points: Vec<Point> = (0..start.vertex_bound() as u32).map(|v| start.point(VertexId::new(v))).collect();
    let fans = faces_of(start)
        .into_iter()
        .flat_map(|f| (1..f.len() - 1).map(move |i| vec![f[0], f[i], f[i + 1]]).collect::<Vec<_>>());
    solid(&points, &fans.collect::<Vec<_>>())
}

/// Closed and open surfaces, with random positions, so that no rounding below is a tie.
fn starts() -> Vec<(String, Polyhedron)> {
    let shapes = [
        Shape::CUBE,
        Shape::Cuboid { x: 2, y: 1, z: 2 },
        Shape::Torus { n: 4, m: 3 },
        Shape::Sphere { sides: 5, bands: 3 },
        Shape::Cylinder { sides: 6, layers: 2 },
    ];
    let mut random = Random(7);
    let mut all = Vec::new();
    for (i, shape) in shapes.into_iter().enumerate() {
        let whole = shape.build().unwrap().polyhedron;
        let points: Vec<Point> = whole
            .vertices()
            .map(|v| whole.point(v).map(|x| x + random.below(1 << 20) as f64 * 0.731_058_578e-7))
            .collect();
        let faces = faces_of(&whole);
        all.push((format!("{shape:?}"), solid(&points, &faces)));
        // Two holes: faces that do not touch, or one.
        let apart = |f: &Vec<usize>| f.iter().all(|v| !faces[i].contains(v));
        let second = faces.iter().position(apart);
        let open: Vec<_> = faces
            .iter()
            .enumerate()
            .filter(|&(f, _)| f != i && Some(f) != second)
            .map(|(_, face)| face.clone())
            .collect();
        all.push((format!("{shape:?} with holes"), solid(&points, &open)));
    }
    all.push((
        "one square".to_owned(),
        solid(&[[0.0; 3], [1.0, 0.0, 0.1], [1.0, 1.0, 0.0], [0.0, 1.0, 0.2]], &[vec![0, 1, 2, 3]]),
    ));
    all
}

#[test]
fn both_schemes_do_what_the_papers_say() {
    for (scheme, seed) in [(Scheme::CatmullClark, 1), (Scheme::Loop, 2)] {
        for (name, start) in starts() {
            let start = if scheme == Scheme::Loop { triangulated(&start) } else { start };
            for creased in [0, 5, 2] {
                let (mut random, mut creases) = (Random(seed), Selection::new());
                for e in start.edges().filter(|_| creased > 0) {
                    if random.below(creased) == 0 {
                        creases.add(e, 4);
                    }
                }
                let context = format!("{scheme:?}, {name}, one edge of {creased} is a crease");
                let fine = scheme.step(&start, &creases);
                let textbook = Textbook::of(&start, &creases);
                assert!(positions(&fine.polyhedron) == textbook.step(scheme), "{context}: other faces");
                assert_eq!(violations(fine.polyhedron.topology()), [], "{context}");

                // Counts, the surface's shape, and the creases.
                let count = |s: &Polyhedron| measure_with(s.topology(), |f| s.is_boundary_face(f));
                let (before, after) = (count(&start), count(&fine.polyhedron));
                let sides: usize = faces_of(&start).iter().map(Vec::len).sum();
                let expected = match scheme {
                    Scheme::CatmullClark => {
                        [before.vertices + before.edges + before.faces, 2 * before.edges + sides, sides]
                    }
                    Scheme::Loop => {
                        [before.vertices + before.edges, 2 * before.edges + 3 * before.faces, 4 * before.faces]
                    }
                };
                assert_eq!([after.vertices, after.edges, after.faces], expected, "{context}");
                assert_eq!(after.boundary_cycles, before.boundary_cycles, "{context}");
                assert_eq!(after.genus(), before.genus(), "{context}");
                let marked = |marks: &Selection<EdgeId>| [marks.ids(4).count(), marks.ids(!4).count()];
                assert_eq!(marked(&fine.creases), [2 * marked(&creases)[0], 0], "{context}");
                // The finer creases are marked again in the second step.
                let again = scheme.step(&fine.polyhedron, &fine.creases);
                let textbook = Textbook::of(&fine.polyhedron, &fine.creases);
                assert!(positions(&again.polyhedron) == textbook.step(scheme), "{context}, twice: other faces");
            }
        }
    }
}

fn octahedron() -> Polyhedron {
    let points: Vec<Point> =
        vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, -1.0]];
    let faces = (0..4).flat_map(|i| [vec![i, (i + 1) % 4, 4], vec![(i + 1) % 4, i, 5]]);
    solid(&points, &faces.collect::<Vec<_>>())
}

#[test]
fn cube_and_octahedron_keep_their_48_symmetries() {
    for (scheme, start) in
        [(Scheme::CatmullClark, Shape::CUBE.build().unwrap().polyhedron), (Scheme::Loop, octahedron())]
    {
        let mut fine = start;
        for _ in 0..3 {
            fine = scheme.step(&fine, &Selection::new()).polyhedron;
        }
        let key = |p: Point| p.map(|x| (x * 1e11).round() as i64);
        let all: BTreeSet<_> = fine.vertices().map(|v| key(fine.point(v))).collect();
        assert_eq!(all.len(), fine.vertex_count(), "{scheme:?}");
        let axes = [[0, 1, 2], [1, 2, 0], [2, 0, 1], [1, 0, 2], [0, 2, 1], [2, 1, 0]];
        for (axis, signs) in axes.into_iter().flat_map(|axis| (0..8).map(move |signs| (axis, signs))) {
            let turned = |v| {
                let p = fine.point(v);
                key(std::array::from_fn(|i| if signs >> i & 1 == 1 { -p[axis[i]] } else { p[axis[i]] }))
            };
            assert_eq!(fine.vertices().map(turned).collect::<BTreeSet<_>>(), all, "{scheme:?} {axis:?} {signs}");
        }
    }
}

#[test]
fn corners_go_to_their_known_limits() {
    // Catmull–Clark: (n^2 v + 4 ends + opposite corners) / (n (n + 5)); the cube's corners go to 1/2.
    // Loop: (1 - n x) v + x ends with x = 1 / (3 / (8 b) + n); the octahedron's go to 1 - 4x.
    let beta = (5.0_f64 / 8.0 - (3.0_f64 / 8.0).powi(2)) / 4.0;
    let limit = 1.0 - 4.0 / (3.0 / (8.0 * beta) + 4.0);
    let cube = Shape::CUBE.build().unwrap().polyhedron;
    for (scheme, start, goal) in [(Scheme::CatmullClark, cube, 0.5), (Scheme::Loop, octahedron(), limit)] {
        let (mut fine, mut last) = (start.clone(), f64::INFINITY);
        for step in 1..=5 {
            fine = scheme.step(&fine, &Selection::new()).polyhedron;
            let far = start.vertices().map(|v| {
                let old = start.point(v);
                (0..3).map(|i| (fine.point(v)[i] - goal * old[i]).abs()).fold(0.0, f64::max)
            });
            let far = far.fold(0.0, f64::max);
            assert!(far < 0.6 * last, "{scheme:?}, step {step}: {far} after {last}");
            last = far;
        }
        assert!(last < 2e-3, "{scheme:?}: {last}");
    }
}

#[test]
fn affine_maps_commute_with_both_schemes_and_planes_stay_planes() {
    let map = |[x, y, z]: Point| [2.0 * x - y + 3.0, 0.5 * y + z, x + y - 4.0 * z - 1.0];
    for scheme in [Scheme::CatmullClark, Scheme::Loop] {
        for (name, start) in starts() {
            let start = if scheme == Scheme::Loop { triangulated(&start) } else { start };
            let points: Vec<Point> = start.vertices().map(|v| map(start.point(v))).collect();
            let mapped = scheme.step(&solid(&points, &faces_of(&start)), &Selection::new()).polyhedron;
            let fine = scheme.step(&start, &Selection::new()).polyhedron;
            for v in fine.vertices() {
                let (a, b) = (mapped.point(v), map(fine.point(v)));
                assert!((0..3).all(|i| (a[i] - b[i]).abs() < 1e-12), "{scheme:?}, {name}, {v}: {a:?} {b:?}");
            }
            let flat: Vec<Point> = start.vertices().map(|v| [start.point(v)[0], 0.25, start.point(v)[2]]).collect();
            let flat = scheme.step(&solid(&flat, &faces_of(&start)), &Selection::new()).polyhedron;
            assert!(flat.vertices().all(|v| flat.point(v)[1] == 0.25), "{scheme:?}, {name}: left the plane");
        }
    }
}

#[test]
fn a_cube_of_creases_stays_a_cube_and_a_creased_cylinder_keeps_flat_caps() {
    let cube = Shape::CUBE.build().unwrap();
    let mut at = Subdivided { polyhedron: cube.polyhedron.clone(), creases: cube.creases };
    for _ in 0..3 {
        at = at.polyhedron.catmull_clark(&at.creases).unwrap();
    }
    for v in at.polyhedron.vertices() {
        let p = at.polyhedron.point(v);
        let size = p.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        assert!((size - 1.0).abs() < 1e-15, "{v} at {p:?}");
    }
    for v in cube.polyhedron.vertices() {
        assert_eq!(at.polyhedron.point(v), cube.polyhedron.point(v));
    }
    let can = Shape::Cylinder { sides: 8, layers: 2 }.build().unwrap();
    let fine = can.polyhedron.catmull_clark(&can.creases).unwrap().polyhedron;
    let heights = fine.vertices().filter(|&v| fine.point(v)[2].abs() == 1.0).count();
    assert_eq!(heights, 2 * (8 + 8 + 1), "the rims and the middles of the caps");
}

#[test]
fn removed_elements_are_passed_over_and_other_faces_than_triangles_refused() {
    let corners = vec![[0.0; 3], [9.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let faces = vec![vec![0, 3, 2], vec![0, 2, 4], vec![2, 3, 4], vec![3, 0, 4]];
    let gappy = solid(&corners, &faces);
    assert!(!gappy.has_vertex(VertexId::new(1)), "no polygon uses it");
    let mut creases = Selection::new();
    creases.add(EdgeId::new(1), 1);
    creases.add(EdgeId::new(2), 1);
    for scheme in [Scheme::CatmullClark, Scheme::Loop] {
        let fine = scheme.step(&gappy, &creases);
        assert_eq!(violations(fine.polyhedron.topology()), []);
        assert_eq!(positions(&fine.polyhedron), Textbook::of(&gappy, &creases).step(scheme), "{scheme:?}");
        assert_eq!(fine.creases.ids(1).count(), 4);
    }
    let cube = Shape::CUBE.build().unwrap().polyhedron;
    let refused = cube.loop_subdivision(&Selection::new()).unwrap_err();
    assert_eq!(refused, SubdivideError::NotATriangle { face: FaceId::new(0), sides: 4 });
    assert_eq!(
        refused.to_string(),
        "f0 has 4 sides, but Loop's scheme takes triangles only: triangulate it, or use Catmull–Clark"
    );
}
