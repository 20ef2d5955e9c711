//! Shapes grow by the two primitives only; every single step keeps the invariants and the genus.

use crate::common::h;
use crate::refusals::covers;
use dcel_kit::solid::grow::{GrowError, Grown, Primitives, Shape, part, pole, quads};
use dcel_kit::topology::{Dcel, PolygonList, SplitFaceError, SplitVertexError, isomorphic, measure, violations};
use dcel_kit::{FaceId, HalfEdgeId, VertexId};
use std::collections::BTreeSet;

/// A structure behind the two primitives, which looks at it after each.
pub(crate) struct Looked {
    dcel: Dcel,
    genus: i64,
    pub(crate) splits: usize,
}

impl Looked {
    pub(crate) fn new(dcel: Dcel) -> Self {
        let genus = measure(&dcel).genus();
        Self { dcel, genus, splits: 0 }
    }

    fn look(&mut self) {
        self.splits += 1;
        assert_eq!(violations(&self.dcel), [], "after split {}", self.splits);
        let counts = measure(&self.dcel);
        assert_eq!((counts.components.len(), counts.genus()), (1, self.genus), "after split {}", self.splits);
        assert_eq!(counts.closed_euler(), 2 - 2 * self.genus, "after split {}", self.splits);
    }
}

impl Primitives for Looked {
    fn dcel(&self) -> &Dcel {
        &self.dcel
    }

    fn split_vertex(
        &mut self,
        first: HalfEdgeId,
        last: HalfEdgeId,
    ) -> Result<(HalfEdgeId, VertexId), SplitVertexError> {
        let made = self.dcel.split_vertex(first, last)?;
        self.look();
        Ok(made)
    }

    fn split_face(&mut self, h1: HalfEdgeId, h2: HalfEdgeId) -> Result<(HalfEdgeId, FaceId), SplitFaceError> {
        let made = self.dcel.split_face(h1, h2)?;
        self.look();
        Ok(made)
    }
}

pub(crate) fn counts(d: &Dcel) -> [usize; 3] {
    [d.vertex_count(), d.edge_count(), d.face_count()]
}

/// All shapes with two numbers.
fn shapes(n: usize, m: usize) -> [Shape; 7] {
    [
        Shape::Grid { n, m },
        Shape::Torus { n, m },
        Shape::Cuboid { x: n, y: m, z: (n + m) / 2 },
        Shape::Cylinder { sides: n + 2, layers: m },
        Shape::Cone { sides: n + 2, layers: m },
        Shape::FlatSphere { sides: n + 2, bands: m },
        Shape::Sphere { sides: n + 2, bands: m + 1 },
    ]
}

/// The formulas once more, written out.
fn formula(shape: Shape) -> [usize; 3] {
    match shape {
        Shape::Ring { sides: n } => [n, n, 2],
        Shape::Grid { n, m } => {
            [2 * (n + 1) * (m + 1) - 2 * (n + m), 2 * (n + m) + 2 * (n * (m - 1) + m * (n - 1)), 2 * n * m]
        }
        Shape::Torus { n, m } => [n * m, 2 * n * m, n * m],
        Shape::Cylinder { sides: n, layers: m } | Shape::FlatSphere { sides: n, bands: m } => {
            [n * (m + 1), n * (m + 1) + n * m, n * m + 2]
        }
        Shape::Cone { sides: n, layers: m } => [n * m + 1, n * m + n * m, n * (m - 1) + n + 1],
        Shape::Sphere { sides: n, bands: m } => [n * (m - 1) + 2, n * (m - 1) + n * m, n * (m - 2) + 2 * n],
        Shape::Cuboid { x, y, z } => {
            let faces = 2 * (x * y + y * z + z * x);
            [(x + 1) * (y + 1) * (z + 1) - (x - 1) * (y - 1) * (z - 1), 2 * faces, faces]
        }
        _ => unreachable!(),
    }
}

#[test]
fn every_step_of_every_shape_is_one_of_the_two_and_keeps_the_genus() {
    for (n, m) in [(1, 1), (1, 3), (2, 1), (2, 2), (3, 2), (4, 3)] {
        for shape in shapes(n, m).into_iter().chain([Shape::Ring { sides: n + 2 }]) {
            let seed = shape.seed().unwrap();
            let genus = i64::from(matches!(shape, Shape::Torus { .. }));
            assert_eq!(measure(&seed).genus(), genus, "{shape:?}");
            let before = seed.edge_count();
            let mut looked = Looked::new(seed);
            let placed = shape.grow(&mut looked).unwrap();
            assert_eq!(counts(&looked.dcel), formula(shape), "{shape:?}");
            assert_eq!(looked.splits, looked.dcel.edge_count() - before, "{shape:?}: each split adds one edge");
            assert_eq!(placed.points.len(), looked.dcel.vertex_count(), "{shape:?}");
            assert_eq!(looked.dcel, *shape.build().unwrap().polyhedron.topology(), "{shape:?}");
        }
    }
}

#[test]
fn the_counts_are_those_of_the_formulas() {
    for (n, m) in (1..9).flat_map(|n| (1..9).map(move |m| (n, m))) {
        for shape in shapes(n, m) {
            let mut d = shape.seed().unwrap();
            shape.grow(&mut d).unwrap();
            assert_eq!(counts(&d), formula(shape), "{shape:?}");
            assert_eq!(shape.counts(), formula(shape), "{shape:?}");
        }
    }
}

/// A structure from lists of corners.
pub(crate) fn from_lists(vertices: usize, faces: &[Vec<u32>]) -> Dcel {
    let mut list = PolygonList::new();
    faces.iter().for_each(|face| list.push_face(face));
    let built = Dcel::from_polygons(vertices, &list).unwrap();
    assert!(built.boundary_faces.is_empty());
    built.dcel
}

/// Quads of `layers` layers between `layers + 1` rings of `n`.
fn mantle(n: u32, layers: u32) -> Vec<Vec<u32>> {
    let at = |i, j| j * n + i % n;
    (0..layers)
        .flat_map(|j| (0..n).map(move |i| vec![at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]))
        .collect()
}

fn triangles_to(n: u32, ring: u32, apex: u32, up: bool) -> Vec<Vec<u32>> {
    let at = |i| ring * n + i % n;
    (0..n).map(|i| if up { vec![at(i), at(i + 1), apex] } else { vec![at(i + 1), at(i), apex] }).collect()
}

#[test]
fn the_shapes_are_those_that_lists_of_corners_give() {
    for (n, m) in [(3, 3), (4, 3), (5, 4), (7, 5)] {
        let size = |n: u32, m: u32| (n as usize, m as usize);
        let check = |shape: Shape, vertices: u32, faces: &[Vec<u32>]| {
            let grown = shape.build().unwrap().polyhedron;
            let listed = from_lists(vertices as usize, faces);
            assert_eq!(isomorphic(grown.topology(), &listed).map(drop), Ok(()), "{shape:?}");
        };
        let (sides, layers) = size(n, m);
        let torus = (0..m).flat_map(|j| {
            let at = move |i, j| (j % m) * n + i % n;
            (0..n).map(move |i| vec![at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)])
        });
        check(Shape::Torus { n: sides, m: layers }, n * m, &torus.collect::<Vec<_>>());
        let caps = [(0..n).rev().collect(), (m * n..(m + 1) * n).collect::<Vec<_>>()];
        check(Shape::Cylinder { sides, layers }, n * (m + 1), &[mantle(n, m), caps.to_vec()].concat());
        let base = vec![(0..n).rev().collect::<Vec<_>>()];
        let cone = [mantle(n, m - 1), triangles_to(n, m - 1, n * m, true), base].concat();
        check(Shape::Cone { sides, layers }, n * m + 1, &cone);
        let (south, north) = (n * (m - 1), n * (m - 1) + 1);
        let sphere = [mantle(n, m - 2), triangles_to(n, 0, south, false), triangles_to(n, m - 2, north, true)].concat();
        check(Shape::Sphere { sides, bands: layers }, n * (m - 1) + 2, &sphere);
        // Two sheets with a common rim: the inner vertices of the back are numbered after the front.
        let front = |i: u32, j: u32| j * (n + 1) + i;
        let back = |i: u32, j: u32| {
            if i == 0 || j == 0 || i == n || j == m {
                front(i, j)
            } else {
                (n + 1) * (m + 1) + (j - 1) * (n - 1) + i - 1
            }
        };
        let squares = || (0..m).flat_map(|j| (0..n).map(move |i| [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)]));
        let sheets = squares()
            .map(|c| c.map(|(i, j)| front(i, j)).to_vec())
            .chain(squares().map(|c| c.into_iter().rev().map(|(i, j)| back(i, j)).collect()));
        check(Shape::Grid { n: sides, m: layers }, 2 * n * m + 2, &sheets.collect::<Vec<_>>());
    }
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|i| a[i] * b[i]).sum()
}

/// Twice the vector area of a face.
fn normal(grown: &Grown, f: FaceId) -> [f64; 3] {
    let solid = &grown.polyhedron;
    let points: Vec<_> = solid.incident_vertices(f).map(|v| solid.point(v)).collect();
    let turns = (0..points.len()).map(|i| cross(points[i], points[(i + 1) % points.len()]));
    turns.fold([0.0; 3], |sum, c| std::array::from_fn(|i| sum[i] + c[i]))
}

fn volume(grown: &Grown) -> f64 {
    let solid = &grown.polyhedron;
    let part = |f| dot(solid.point(solid.incident_vertices(f).next().unwrap()), normal(grown, f));
    solid.faces().map(part).sum::<f64>() / 6.0
}

#[test]
fn solids_are_where_they_should_be_and_face_outwards() {
    let near = |a: f64, b: f64, what: &str| assert!((a - b).abs() < 1e-12 * (1.0 + b.abs()), "{what}: {a} is not {b}");
    for n in 3..9_usize {
        let build = |shape: Shape| shape.build().unwrap();
        let disc = n as f64 / 2.0 * (std::f64::consts::TAU / n as f64).sin();
        near(volume(&build(Shape::Cylinder { sides: n, layers: n })), 2.0 * disc, "cylinder");
        near(volume(&build(Shape::Cone { sides: n, layers: n })), 2.0 * disc / 3.0, "cone");
        near(volume(&build(Shape::Cuboid { x: n, y: 2, z: 3 })), 8.0, "box");
        near(volume(&build(Shape::Grid { n, m: 4 })), 0.0, "grid");
        near(normal(&build(Shape::Ring { sides: n }), FaceId::new(1))[2] / 2.0, disc, "ring, up");
        near(normal(&build(Shape::Ring { sides: n }), FaceId::new(0))[2] / 2.0, -disc, "ring, down");
        for shape in [Shape::Sphere { sides: n, bands: n }, Shape::FlatSphere { sides: n, bands: n }] {
            let sphere = build(shape);
            for v in sphere.polyhedron.vertices() {
                near(dot(sphere.polyhedron.point(v), sphere.polyhedron.point(v)), 1.0, "sphere");
            }
            for f in sphere.polyhedron.faces() {
                let corner = sphere.polyhedron.incident_vertices(f).next().unwrap();
                assert!(dot(normal(&sphere, f), sphere.polyhedron.point(corner)) > 0.0, "{shape:?}, {f} faces inwards");
            }
        }
        let torus = build(Shape::Torus { n, m: n + 1 });
        assert!(volume(&torus) > 0.5, "the torus faces inwards");
        for v in torus.polyhedron.vertices() {
            let [x, y, z] = torus.polyhedron.point(v);
            near((x.hypot(y) - 1.0).hypot(z), 0.4, "tube");
        }
    }
}

#[test]
fn no_two_vertices_of_a_solid_meet_and_the_sides_of_a_box_are_marked() {
    for shape in shapes(4, 3).into_iter().filter(|shape| !matches!(shape, Shape::Grid { .. })) {
        let solid = shape.build().unwrap().polyhedron;
        let points: BTreeSet<_> = solid.vertices().map(|v| solid.point(v).map(|x| (x * 1e9).round() as i64)).collect();
        assert_eq!(points.len(), solid.vertex_count(), "{shape:?}");
    }
    let (x, y, z) = (4, 2, 3);
    let cuboid = Shape::Cuboid { x, y, z }.build().unwrap();
    let outward = [
        (part::BOTTOM, [0, 0, -1], x * y),
        (part::TOP, [0, 0, 1], x * y),
        (part::FRONT, [0, -1, 0], x * z),
        (part::BACK, [0, 1, 0], x * z),
        (part::LEFT, [-1, 0, 0], y * z),
        (part::RIGHT, [1, 0, 0], y * z),
    ];
    for (bits, direction, faces) in outward {
        let side: Vec<FaceId> = cuboid.parts.ids(bits).collect();
        assert_eq!(side.len(), faces, "{direction:?}");
        for f in side {
            assert_eq!(
                normal(&cuboid, f).map(|x| if x.abs() < 1e-12 { 0 } else { x.signum() as i32 }),
                direction,
                "{f}"
            );
        }
    }
    let grid = Shape::Grid { n: 4, m: 3 }.build().unwrap();
    for (bits, up) in [(part::TOP, 1.0), (part::BOTTOM, -1.0)] {
        assert_eq!(grid.parts.ids(bits).count(), 12);
        for f in grid.parts.ids(bits) {
            let [x, y, z] = normal(&grid, f);
            assert!(x == 0.0 && y == 0.0 && (z - up / 1.5).abs() < 1e-12, "{f}: twice a cell of 1/2 by 2/3, {z}");
        }
    }
    assert_eq!(cuboid.creases.ids(1).count(), 4 * (x + y + z));
    assert_eq!(Shape::Torus { n: 4, m: 4 }.build().unwrap().creases.ids(1).count(), 0);
    assert_eq!(Shape::Cone { sides: 6, layers: 3 }.build().unwrap().creases.ids(1).count(), 6);
    assert_eq!(Shape::Cylinder { sides: 6, layers: 3 }.build().unwrap().creases.ids(1).count(), 12);
}

#[test]
fn a_pole_makes_triangles_and_quads_take_two_sides_each() {
    for n in 2..12 {
        for start in [0, 1, 2 * n as u32 - 2] {
            let mut disc = Looked::new(Dcel::polygon(n).unwrap());
            let face = disc.dcel.face(h(start));
            let fan = pole(&mut disc, h(start)).unwrap();
            assert_eq!(counts(&disc.dcel), [n + 1, 2 * n, n + 1]);
            assert_eq!((fan.faces.len(), fan.faces[n - 1]), (n, face));
            assert_eq!(fan.faces[0], disc.dcel.face(h(start)));
            assert!(fan.faces.iter().all(|&f| disc.dcel.incident_half_edges(f).count() == 3));
            if n < 4 || n % 2 == 1 {
                continue;
            }
            let mut disc = Looked::new(Dcel::polygon(n).unwrap());
            let corner = disc.dcel.origin(h(start));
            let fan = quads(&mut disc, h(start)).unwrap();
            assert_eq!(counts(&disc.dcel), [n + 1, n + n / 2, n / 2 + 1]);
            assert!(fan.faces.iter().all(|&f| disc.dcel.incident_half_edges(f).count() == 4));
            assert!(disc.dcel.find_half_edge(corner, fan.middle).is_some(), "the first spoke starts at the origin");
            assert_eq!(disc.dcel.degree(fan.middle), n / 2);
        }
    }
}

#[test]
fn what_cannot_be_grown_is_refused_by_name() {
    let mut ring = Dcel::polygon(5).unwrap();
    let mut looped = Dcel::polygon(1).unwrap();
    let before = (ring.clone(), looped.clone());
    let full = Shape::Torus { n: 1 << 20, m: 1 << 20 };
    let nothing = dcel_kit::solid::Selection::new();
    let errors = [
        pole(&mut ring, h(77)).unwrap_err(),
        pole(&mut looped, h(0)).unwrap_err(),
        quads(&mut ring, h(1)).unwrap_err(),
        Shape::Ring { sides: 2 }.build().unwrap_err(),
        Shape::Sphere { sides: 5, bands: 1 }.build().unwrap_err(),
        Shape::Ring { sides: 4 }.grow(&mut ring).unwrap_err(),
        full.build().unwrap_err(),
        dcel_kit::solid::grow::extrude(&mut ring, &nothing, 1).unwrap_err(),
    ];
    assert_eq!((ring, looped), before);
    let face = FaceId::new(1);
    assert_eq!(errors[1], GrowError::FewSides { h: h(0), face, sides: 1, least: 2 });
    assert_eq!(errors[2], GrowError::OddSides { h: h(1), face: FaceId::new(0), sides: 5 });
    assert_eq!(errors[3], GrowError::TooFew { what: "sides", given: 2, least: 3 });
    assert_eq!(errors[3].to_string(), "sides: 2 is too few, take at least 3");
    assert_eq!(errors[5], GrowError::NotTheSeed);
    assert_eq!(errors[7], GrowError::NoBorder { selected: 0, faces: 2 });
    // The primitives refuse nothing that the checks before them let through.
    covers(include_str!("../../src/solid/grow/error.rs"), "GrowError", &errors, &["Ring", "SplitVertex", "SplitFace"]);
    assert_eq!(Shape::Torus { n: usize::MAX, m: 3 }.build(), Err(GrowError::TooMany(dcel_kit::topology::TooMany)));
}
