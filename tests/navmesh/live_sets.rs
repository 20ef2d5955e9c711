//! Sets of walls and obstacles that touch, cross, overlap and contain each other, against what is true of them.

use crate::live_truth::{Shape, Truth, sides};
use crate::maps::Random;
use dcel_kit::navmesh::{LiveMesh, Location, NavMesh, ObstacleId};
use dcel_kit::plane::predicates::twice_area;
use dcel_kit::plane::{Point, Subdivision, TriangulationMethod};
use dcel_kit::{FaceId, HalfEdgeId};

/// A map as it was drawn.
struct Ground {
    rings: Vec<Shape>,
    map: Subdivision,
}

fn at(x: f64, y: f64) -> Point {
    Point::new(x, y)
}

fn rectangle(x: f64, y: f64, width: f64, height: f64) -> Shape {
    vec![at(x, y), at(x + width, y), at(x + width, y + height), at(x, y + height)]
}

impl Ground {
    /// One face.
    fn hall() -> Self {
        let rim = rectangle(0., 0., 20., 20.);
        Self { map: Subdivision::polygon(&rim).expect("a hall"), rings: vec![rim] }
    }

    /// A hall with pillars, in triangles.
    fn pillars() -> Self {
        let slanted = vec![at(11., 12.), at(16., 13.), at(13., 17.)];
        let rings = vec![rectangle(0., 0., 20., 20.), rectangle(4., 3., 3., 5.), slanted, rectangle(12., 4., 4., 1.)];
        let (mut points, mut edges, mut first) = (Vec::new(), Vec::new(), Vec::new());
        for ring in &rings {
            let [start, count] = [points.len(), ring.len()].map(|n| n as u32);
            first.push(edges.len() as u32);
            points.extend(ring);
            edges.extend((0..count).map(|i| [start + i, start + (i + 1) % count]));
        }
        let mut map = Subdivision::from_graph(&points, &edges).expect("disjoint");
        for &edge in &first[1..] {
            let inner = map.face(HalfEdgeId::new(2 * edge));
            map.set_hole(inner, true);
        }
        map.triangulate(TriangulationMethod::Ears).expect("a hall with pillars");
        Self { rings, map }
    }
}

/// Coordinates of one kind.
#[derive(Clone, Copy)]
enum Numbers {
    Whole,
    Tenths,
    Floats,
}

impl Numbers {
    fn point(self, random: &mut Random, [low, high]: [f64; 2]) -> Point {
        let [x, y] = [(); 2].map(|()| {
            let x = low + (high - low) * random.unit();
            match self {
                Self::Whole => x.round(),
                Self::Tenths => (10.0 * x).round() / 10.0,
                Self::Floats => x,
            }
        });
        at(x, y)
    }
}

/// A simple polygon with these corners, counter-clockwise, if there is one in this order.
fn polygon(mut corners: Shape) -> Option<Shape> {
    let doubled: f64 = (2..corners.len()).map(|i| twice_area(corners[0], corners[i - 1], corners[i])).sum();
    if doubled < 0.0 {
        corners.reverse();
    }
    Subdivision::polygon(&corners).is_ok().then_some(corners)
}

/// Walls, triangles and quadrilaterals; some close together, some that share corners, some that reach out of the map.
fn shapes(random: &mut Random, numbers: Numbers, count: usize) -> Vec<Shape> {
    let window = match random.below(4) {
        0 => [0.0, 5.0],
        1 => [-2.0, 22.0],
        2 => [5.0, 13.0],
        _ => [0.0, 20.0],
    };
    let mut found: Vec<Shape> = Vec::new();
    while found.len() < count {
        let corners = 2 + random.below(3);
        let mut shape: Shape = (0..corners).map(|_| numbers.point(random, window)).collect();
        if random.below(4) == 0
            && let Some(other) = found.last()
        {
            shape[0] = other[random.below(other.len())];
        }
        if random.below(4) == 0
            && let Some(other) = found.last()
        {
            // It is on a side of another one, or as close to it as doubles can tell.
            let [a, b] = [other[0], other[1]];
            let along = random.below(9) as f64 / 10.0 + 0.1;
            shape[1] = at(a.x + along * (b.x - a.x), a.y + along * (b.y - a.y));
        }
        if corners == 2 && random.below(3) == 0 {
            // It begins on the border.
            if random.below(2) == 0 { shape[0].x = 0.0 } else { shape[0].y = 20.0 }
        }
        match corners {
            2 if shape[0] != shape[1] => found.push(shape),
            2 => {}
            _ => found.extend(polygon(shape)),
        }
    }
    found
}

fn put(live: &mut LiveMesh, shape: &[Point], set: &str) -> ObstacleId {
    let put = match shape {
        &[p, q] => live.insert_wall(p, q),
        corners => live.insert_obstacle(corners),
    };
    put.unwrap_or_else(|error| panic!("{set}: {shape:?} is refused: {error}"))
}

fn area(mesh: &NavMesh, faces: impl Iterator<Item = FaceId>) -> f64 {
    let of = |f: FaceId| {
        let corners: Vec<Point> = mesh.corners(f).map(|v| mesh.point(v)).collect();
        (2..corners.len()).map(|i| twice_area(corners[0], corners[i - 1], corners[i])).sum::<f64>() / 2.0
    };
    faces.map(of).sum()
}

/// Areas and places are what they are in truth.
fn check(live: &LiveMesh, truth: &Truth, random: &mut Random, when: &str) {
    let mesh = live.mesh();
    let [all, free] = truth.areas();
    let found = [area(mesh, mesh.faces()), area(mesh, mesh.faces().filter(|&f| mesh.is_walkable(f)))];
    assert!((found[0] - all).abs() < 1e-9 * all, "{when}: the map has area {}, and not {all}", found[0]);
    assert!((found[1] - free).abs() < 1e-9 * all, "{when}: area {} is free, and not {free}", found[1]);
    for p in truth.probes(random, 8) {
        let Some([on_map, is_free]) = truth.is_free(p) else { continue };
        let location = mesh.locate(p);
        let is_out = matches!(location, Location::Hole(_) | Location::Outer);
        assert_eq!(!is_out, on_map, "{when}: {p} is at {location:?}");
        assert_eq!(mesh.places(p).is_ok(), is_free, "{when}: {p} is at {location:?}");
    }
}

/// All in, in two orders; all out again, in any order.
fn try_out(ground: &Ground, shapes: &[Shape], random: &mut Random, set: &str) {
    let rings = &ground.rings;
    for reversed in [false, true] {
        let when = |what: &str| format!("{set}, {what}{}", if reversed { " in reverse" } else { "" });
        let mut live = LiveMesh::new(ground.map.clone()).expect("convex");
        let mut order: Vec<&Shape> = shapes.iter().collect();
        if reversed {
            order.reverse();
        }
        let mut inside: Vec<(ObstacleId, &Shape)> =
            order.into_iter().map(|shape| (put(&mut live, shape, &when("put in")), shape)).collect();
        check(&live, &Truth { rings, shapes }, random, &when("put in"));
        assert_eq!(live.map().geometry_violations(), [], "{}", when("put in"));
        while !inside.is_empty() {
            let (gone, _) = inside.swap_remove(random.below(inside.len()));
            live.remove(gone).expect("in the map");
            if inside.len() == shapes.len() / 2 {
                let left: Vec<Shape> = inside.iter().map(|(_, shape)| (*shape).clone()).collect();
                check(&live, &Truth { rings, shapes: &left }, random, &when("half of it out, put in"));
            }
        }
        check(&live, &Truth { rings, shapes: &[] }, random, &when("all out, put in"));
        let counts = |s: &Subdivision| (s.vertex_count(), s.edge_count(), s.face_count());
        assert_eq!(counts(live.map()), counts(&ground.map), "{}: V, E, F", when("all out, put in"));
    }
}

/// Sets from seeds, told with their shapes if one fails.
fn try_sets(numbers: Numbers, seeds: std::ops::Range<u64>) {
    let grounds = [Ground::hall(), Ground::pillars()];
    for seed in seeds {
        let mut random = Random::new(seed + 41_000);
        let count = 2 + if seed % 50 == 0 { random.below(14) } else { random.below(3) };
        let shapes = shapes(&mut random, numbers, count);
        let ground = &grounds[seed as usize % 2];
        try_out(ground, &shapes, &mut random, &format!("seed {seed}, {shapes:?}"));
    }
}

#[test]
fn sets_on_whole_numbers_are_what_a_plain_program_says() {
    try_sets(Numbers::Whole, 0..1200);
}

#[test]
fn sets_on_tenths_are_what_a_plain_program_says() {
    try_sets(Numbers::Tenths, 10_000..11_200);
}

#[test]
fn sets_on_floats_are_what_a_plain_program_says() {
    try_sets(Numbers::Floats, 20_000..21_000);
}

/// Sides of areas that cost more are cut into the map in the same way: none is refused, and all faces are right.
#[test]
fn no_side_of_an_area_is_refused() {
    let grounds = [Ground::hall(), Ground::pillars()];
    let near = 22.0 * 2f64.powi(-47);
    for seed in 0..1000 {
        let mut random = Random::new(seed + 42_000);
        let numbers = [Numbers::Whole, Numbers::Tenths, Numbers::Floats][seed as usize % 3];
        let (shapes, mut map) = (shapes(&mut random, numbers, 3), grounds[seed as usize / 3 % 2].map.clone());
        for [p, q] in shapes.iter().flat_map(|shape| sides(shape)) {
            let cut = map.insert_segment_within(p, q, near);
            cut.unwrap_or_else(|error| panic!("seed {seed}, {shapes:?}: {p} {q}: {error}"));
        }
        assert_eq!(map.geometry_violations(), [], "seed {seed}, {shapes:?}");
    }
}
