//! Solids: support points by climbing and by looking at all vertices, convex hulls against another crate, faces that
//! come and go.
//!
//! `cargo bench --bench solid` measures all; `-- support`, `-- hull`, `-- edits` one of them, `-- linear` the growth with
//! the corners of one face.

use chull::ConvexHull;
use dcel_kit::VertexId;
use dcel_kit::figure::{self, Camera, FigureOptions, HiddenLines};
use dcel_kit::solid::grow::Shape;
use dcel_kit::solid::{Convex, Direction, HullFaces, Polyhedron, SurfaceJournal};
use dcel_kit_benches::{DOUBLED, Random, compare, growth, print, program};
use std::cell::Cell;

type Point = [f64; 3];

/// Points on the unit sphere.
fn sphere(count: usize) -> Vec<Point> {
    let mut random = Random::new(7);
    (0..count).map(|_| unit(&mut random)).collect()
}

/// Points in the unit ball.
fn ball(count: usize) -> Vec<Point> {
    let mut random = Random::new(8);
    let mut one = || {
        let far = random.unit().cbrt();
        unit(&mut random).map(|x| x * far)
    };
    (0..count).map(|_| one()).collect()
}

fn unit(random: &mut Random) -> Point {
    loop {
        let p = [(); 3].map(|()| 2.0 * random.unit() - 1.0);
        let size = p.iter().map(|x| x * x).sum::<f64>();
        if (0.01..1.0).contains(&size) {
            return p.map(|x| x / size.sqrt());
        }
    }
}

fn solid(points: &[Point]) -> Polyhedron {
    Polyhedron::convex_hull(points, HullFaces::Triangles).expect("points of a sphere span a solid").solid
}

/// What everybody writes first: the greatest product, in doubles.
fn loop_over_all(points: &[Point], d: Point) -> usize {
    let far = |p: &Point| p[0] * d[0] + p[1] * d[1] + p[2] * d[2];
    let mut best = (0, f64::NEG_INFINITY);
    for (i, p) in points.iter().enumerate() {
        if far(p) > best.1 {
            best = (i, far(p));
        }
    }
    best.0
}

/// Sizes of the spheres, from which growth is told.
const SIZES: [usize; 5] = [100, 1_000, 10_000, 100_000, 1_000_000];

fn support() {
    let mut table: Vec<(String, Vec<f64>)> = Vec::new();
    for count in SIZES {
        let solid = solid(&sphere(count));
        let convex: Convex<'_> = solid.check_convex().expect("a hull is convex");
        let points: Vec<Point> = solid.vertices().map(|v| solid.point(v)).collect();
        let mut random = Random::new(9);
        let queries = (20_000_000 / count).clamp(20, 2_000);
        let far: Vec<Point> = (0..queries).map(|_| unit(&mut random)).collect();
        // Turning by half a degree from query to query.
        let near: Vec<Point> = (0..queries)
            .map(|i| {
                let (sin, cos) = (i as f64 * 0.0087).sin_cos();
                [cos, sin, 0.2]
            })
            .collect();
        let directions = |list: &[Point]| -> Vec<Direction> {
            list.iter().map(|&d| Direction::try_from(d).expect("finite")).collect()
        };
        let (any, turning) = (directions(&far), directions(&near));
        let (last, last_prepared) = (Cell::new(VertexId::new(0)), Cell::new(VertexId::new(0)));
        let map = convex.support_map();
        let mut programs = [
            program("climbing", || any.iter().map(|&d| convex.support(d).index()).sum::<usize>()),
            program("climbing, with hint", || {
                for &d in &turning {
                    last.set(convex.support_from(d, last.get()));
                }
                last.get()
            }),
            program("prepared", || any.iter().map(|&d| map.support(d).index()).sum::<usize>()),
            program("prepared, with hint", || {
                for &d in &turning {
                    last_prepared.set(map.support_from(d, last_prepared.get()));
                }
                last_prepared.get()
            }),
            program("all vertices, exactly", || {
                any.iter().map(|&d| convex.support_by_search(d).index()).sum::<usize>()
            }),
            program("all vertices, in doubles", || far.iter().map(|&d| loop_over_all(&points, d)).sum::<usize>()),
        ];
        let ns = compare(&mut programs, 5, queries);
        print(&format!("support point on a sphere of {count} vertices, ns per query"), &programs, &ns);
        let bytes = map.memory() as f64 / count as f64;
        println!("  the prepared solid takes {bytes:.0} bytes for each vertex\n");
        table.resize_with(ns.len(), Default::default);
        for (((name, _), time), row) in programs.iter().zip(ns).zip(&mut table) {
            row.0 = (*name).to_owned();
            row.1.push(time);
        }
    }
    println!("growth of the time with the number of vertices: how many times as long for ten times as many");
    for (name, times) in &table {
        let factors: Vec<String> = times.windows(2).map(|pair| format!("{:6.2}", pair[1] / pair[0])).collect();
        let power = (times[times.len() - 1] / times[0]).log10() / 4.0;
        println!("  {name:30} {}   about n^{power:.2}", factors.join(" "));
    }
    println!();
}

fn hulls() {
    for (name, make) in [("on a sphere", sphere as fn(usize) -> Vec<Point>), ("in a ball", ball)] {
        for count in [10_000, 100_000, 1_000_000] {
            let points = make(count);
            let lists: Vec<Vec<f64>> = points.iter().map(|p| p.to_vec()).collect();
            let mut programs = vec![
                program("dcel-kit, exact, half-edges", || solid(&points)),
                program("chull, in doubles, triangles", || {
                    ConvexHull::try_new(&lists, f64::EPSILON, None).map(drop).is_ok()
                }),
            ];
            // The other crate takes minutes for more.
            if count > 10_000 && !std::env::args().any(|arg| arg == "patient") {
                programs.truncate(1);
            }
            let rounds = if count > 100_000 { 1 } else { 3 };
            let ns = compare(&mut programs, rounds, count);
            print(&format!("convex hull of {count} points {name}, ns per point"), &programs, &ns);
        }
    }
}

fn edits() {
    let start = solid(&sphere(100_000));
    let mut random = Random::new(10);
    let faces: Vec<_> = start.faces().collect();
    // Faces that lie apart from each other: each leaves a hole, and fills it again.
    let chosen: Vec<_> = (0..50_000).map(|_| faces[random.below(faces.len())]).collect();
    let apart = || {
        let mut surface = start.clone();
        for &f in &chosen {
            let corners: Vec<_> = surface.incident_vertices(f).collect();
            surface.remove_face(f).expect("it is there");
            surface.add_face(&corners).expect("its place is free");
        }
        surface
    };
    let mut unique = chosen.clone();
    unique.sort_unstable();
    unique.dedup();
    // All of them go, in random order, so that holes meet; then all come back, backwards.
    let together = || {
        let mut surface = start.clone();
        let mut gone = Vec::with_capacity(chosen.len());
        for &f in &chosen {
            if surface.has_face(f) && !surface.is_boundary_face(f) && unique.binary_search(&f).is_ok() {
                gone.push(surface.incident_vertices(f).collect::<Vec<_>>());
                surface.remove_face(f).expect("it is there");
            }
        }
        for corners in gone.iter().rev() {
            surface.add_face(corners).expect("its place is free");
        }
        surface
    };
    let recorded = || {
        let (mut surface, mut journal) = (start.clone(), SurfaceJournal::new());
        for &f in &chosen {
            let corners: Vec<_> = surface.incident_vertices(f).collect();
            surface.remove_face_with(f, &mut journal).expect("it is there");
            surface.add_face_with(&corners, &mut journal).expect("its place is free");
        }
        surface
    };
    let mut programs = [
        program("one by one", apart),
        program("one by one, recorded", recorded),
        program("all, then back", together),
        program("copy", || start.clone()),
    ];
    let ns = compare(&mut programs, 3, 100_000);
    print("10^5 edits of a surface of 2 x 10^5 triangles, ns per edit with the copy", &programs, &ns);
}

/// A cylinder, whose bottom and top are faces of `sides` corners.
fn linear() {
    let cylinder = |sides| Shape::Cylinder { sides, layers: 1 }.build().expect("not too many").polyhedron;
    growth("cylinder: is it convex", &DOUBLED, |sides| {
        let solid = cylinder(sides);
        move || solid.check_convex().is_ok()
    });
    growth("making a cylinder of three sides, by layers", &DOUBLED, |layers| {
        move || Shape::Cylinder { sides: 3, layers }.build().expect("not too many").polyhedron
    });
    growth("figure of a torus with hidden lines, by vertices", &DOUBLED, |vertices| {
        let n = (vertices as f64).sqrt() as usize;
        let torus = Shape::Torus { n, m: n }.build().expect("not too many").polyhedron;
        move || {
            let options = FigureOptions::new("Torus");
            figure::solid(&torus, &Camera::default(), HiddenLines::Dashed, &options).expect("a solid").to_svg().len()
        }
    });
    growth("cylinder: deficit angles of all vertices", &DOUBLED, |sides| {
        let solid = cylinder(sides);
        move || {
            let measures = solid.measures();
            solid.vertices().map(|v| measures.deficit_angle(v)).sum::<f64>()
        }
    });
}

fn main() {
    let asked: Vec<String> = std::env::args().collect();
    let parts: [(&str, fn()); 4] = [("support", support), ("hull", hulls), ("edits", edits), ("linear", linear)];
    let any = parts.iter().any(|(name, _)| asked.iter().any(|arg| arg == name));
    for (name, run) in parts {
        if !any || asked.iter().any(|arg| arg == name) {
            run();
        }
    }
}
