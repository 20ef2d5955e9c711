//! Faces into triangles, beside the crates earcut and i_triangle; convex hulls.
//!
//! `cargo bench --bench triangulate` measures friendly polygons of 10^5 corners and bad ones of 10^3 to 3 · 10^4; `-- linear` ours
//! alone, from 10^3 to 10^6 corners, and the growth of ears; `-- hull` hulls of 10^6 points.
//!
//! We start from a subdivision and end with one, links, faces and all; the peers read lists of points and write lists
//! of corners. i_triangle rounds the coordinates to whole numbers first; it is told that its input is valid.

use dcel_kit::plane::{Point, Subdivision, TriangulationMethod, convex_hull};
use dcel_kit_benches::{Program, Random, compare, growth, print, program};
use i_triangle::float::unchecked::UncheckedTriangulatable;

/// A closed line, counter-clockwise, and holes in it, clockwise.
struct Shape {
    name: &'static str,
    rings: Vec<Vec<[f64; 2]>>,
}

fn round(corners: usize, centre: [f64; 2], radius: impl Fn(f64) -> f64) -> Vec<[f64; 2]> {
    let angle = |i: usize| i as f64 / corners as f64 * std::f64::consts::TAU;
    let at = |a: f64| [centre[0] + radius(a) * a.cos(), centre[1] + radius(a) * a.sin()];
    (0..corners).map(|i| at(angle(i))).collect()
}

/// A coast: a circle with waves on waves, and 1 % of the corners each in round lakes of 20.
fn coast(corners: usize) -> Shape {
    let waves = |a: f64| 1.0 + 0.1 * (9.0 * a).sin() + 0.03 * (57.0 * a).cos() + 0.01 * (331.0 * a).sin();
    let lakes = corners / 200;
    let side = (lakes as f64).sqrt().floor().max(1.0) as usize;
    let mut rings = vec![round(corners - 20 * side * side, [0.0, 0.0], waves)];
    for i in 0..side * side {
        let at = |k: usize| (k as f64 + 0.5) / side as f64 - 0.5;
        let mut lake = round(20, [at(i % side), at(i / side)], |_| 0.3 / side as f64);
        lake.reverse();
        rings.push(lake);
    }
    Shape { name: "coast with lakes", rings }
}

/// The friendliest of all.
fn circle(corners: usize) -> Shape {
    Shape { name: "circle", rings: vec![round(corners, [0.0, 0.0], |_| 1.0)] }
}

/// A star whose radius changes at random within a fifth.
fn ragged(corners: usize) -> Shape {
    let mut random = Random::new(5);
    let radii: Vec<f64> = (0..corners).map(|_| 1.0 - 0.2 * random.unit()).collect();
    let index = |a: f64| ((a / std::f64::consts::TAU * corners as f64).round() as usize).min(corners - 1);
    Shape { name: "ragged circle", rings: vec![round(corners, [0.0, 0.0], |a| radii[index(a)])] }
}

/// A corridor that winds inwards.
fn spiral(corners: usize) -> Shape {
    let half = corners / 2;
    let turns = (half as f64 / 60.0).max(2.0);
    let at = |t: f64, gap: f64| {
        let a = t * turns * std::f64::consts::TAU;
        let r = 1.0 - 0.9 * t - gap * 0.4 / turns;
        [r * a.cos(), r * a.sin()]
    };
    let mut ring: Vec<[f64; 2]> = (0..half).map(|i| at(i as f64 / half as f64, 0.0)).collect();
    ring.extend((0..half).rev().map(|i| at(i as f64 / half as f64, 1.0)));
    Shape { name: "spiral", rings: vec![ring] }
}

/// A comb with long teeth.
fn comb(corners: usize) -> Shape {
    let teeth = corners / 2;
    let mut ring = vec![[0.0, -1.0], [teeth as f64, -1.0]];
    let mut random = Random::new(6);
    ring.extend(
        (0..teeth).rev().flat_map(|i| [[i as f64 + 0.9, 0.0], [i as f64 + 0.4, 900.0 + 100.0 * random.unit()]]),
    );
    Shape { name: "comb", rings: vec![ring] }
}

fn subdivision(shape: &Shape) -> Subdivision {
    let mut points = Vec::new();
    let mut edges = Vec::new();
    for ring in &shape.rings {
        let (first, n) = (points.len() as u32, ring.len() as u32);
        points.extend(ring.iter().map(|&p| Point::from(p)));
        edges.extend((0..n).map(|i| [first + i, first + (i + 1) % n]));
    }
    let mut s = Subdivision::from_graph(&points, &edges).expect("a simple polygon");
    let holes: Vec<Point> = shape.rings[1..].iter().map(|ring| middle(ring)).collect();
    s.mark_holes(&holes).expect("the lakes are round");
    s
}

fn middle(ring: &[[f64; 2]]) -> Point {
    let sum = ring.iter().fold([0.0; 2], |sum, p| [sum[0] + p[0], sum[1] + p[1]]);
    Point::new(sum[0] / ring.len() as f64, sum[1] / ring.len() as f64)
}

fn ours<'a>(name: &'a str, s: &'a Subdivision, method: TriangulationMethod) -> Program<'a> {
    let prepare = move || -> dcel_kit_benches::Run<'a> {
        let mut copy = s.clone();
        Box::new(move || {
            copy.triangulate(method).expect("a simple polygon");
            Box::new(copy)
        })
    };
    (name, Box::new(prepare))
}

fn main() {
    match std::env::args().find(|arg| ["linear", "hull"].contains(&arg.as_str())).as_deref() {
        Some("linear") => linear(),
        Some(_) => hulls(),
        None => peers(),
    }
}

fn peers() {
    // On the bad ones the work of ears grows like the square: at 10^5 corners it took more than minutes.
    let bad = [spiral, comb].into_iter().flat_map(|shape| [shape(1_000), shape(10_000), shape(30_000)]);
    for shape in [circle, coast, ragged].map(|shape| shape(100_000)).into_iter().chain(bad) {
        let s = subdivision(&shape);
        let corners: usize = shape.rings.iter().map(Vec::len).sum();
        let flat: Vec<[f64; 2]> = shape.rings.concat();
        let mut starts: Vec<u32> = Vec::new();
        let mut at = 0;
        for ring in &shape.rings[..shape.rings.len() - 1] {
            at += ring.len() as u32;
            starts.push(at);
        }
        let rings = &shape.rings[..];
        let (flat, starts) = (&flat, &starts);
        let earcut = move || {
            let mut triangles: Vec<u32> = Vec::new();
            earcut::Earcut::new().earcut(flat.iter().copied(), starts, &mut triangles);
            triangles
        };
        let due = corners + 2 * (shape.rings.len() - 1) - 2;
        println!("{}: earcut gives {} triangles of {due}", shape.name, earcut().len() / 3);
        let mut programs = [
            ours("monotone pieces", &s, TriangulationMethod::Monotone),
            program("earcut", earcut),
            program("i_triangle", move || rings.unchecked_triangulate().to_triangulation::<u32>().indices),
        ];
        // What takes a minute is not run eight times.
        let rounds = if ["spiral", "comb"].contains(&shape.name) { 1 } else { 7 };
        let ns = compare(&mut programs, rounds, corners);
        print(&format!("{}, {corners} corners, ns per corner", shape.name), &programs, &ns);
    }
}

fn linear() {
    for corners in [1_000, 10_000, 100_000, 1_000_000] {
        for shape in [coast(corners), ragged(corners), spiral(corners), comb(corners)] {
            let s = subdivision(&shape);
            let mut programs = vec![ours("monotone pieces", &s, TriangulationMethod::Monotone)];
            if corners <= 1_000 {
                programs.push(ours("ears", &s, TriangulationMethod::Ears));
            }
            let corners: usize = shape.rings.iter().map(Vec::len).sum();
            let ns = compare(&mut programs, 5, corners);
            print(&format!("{}, {corners} corners, ns per corner", shape.name), &programs, &ns);
        }
    }
    for (name, shape) in [("spiral", spiral as fn(usize) -> Shape), ("comb", comb), ("ragged circle", ragged)] {
        growth(&format!("ears, {name}"), &[2_000, 4_000, 8_000, 16_000], |corners| {
            let s = subdivision(&shape(corners));
            move || {
                let mut copy = s.clone();
                copy.triangulate(TriangulationMethod::Ears).expect("a simple polygon");
                copy.face_count()
            }
        });
    }
}

fn hulls() {
    let mut random = Random::new(7);
    let square: Vec<Point> = (0..1_000_000).map(|_| Point::new(random.unit(), random.unit())).collect();
    let circle: Vec<Point> = round(1_000_000, [0.0, 0.0], |_| 1.0).into_iter().map(Point::from).collect();
    for (name, points) in [("in a square", &square), ("on a circle", &circle)] {
        let sorted = || {
            let mut keys: Vec<(u64, u64, u32)> =
                points.iter().enumerate().map(|(i, p)| (p.x.to_bits(), p.y.to_bits(), i as u32)).collect();
            keys.sort_unstable();
            keys
        };
        let mut programs = [
            program("convex hull", || convex_hull(points).expect("good points")),
            program("sort of the points alone", sorted),
        ];
        let ns = compare(&mut programs, 5, points.len());
        print(&format!("10^6 points {name}, ns per point"), &programs, &ns);
    }
}
