//! All small polygons, and many random plane graphs on small grids.

use crate::common::Random;
use crate::judge::{METHODS, judge_whole};
use dcel_kit::FaceId;
use dcel_kit::plane::predicates::orientation;
use dcel_kit::plane::{Point, Subdivision};

/// Whether the segments a-b and c-d have a point in common.
fn meet([a, b]: [Point; 2], [c, d]: [Point; 2]) -> bool {
    let on = |p: Point, q: Point, r: Point| {
        orientation(p, q, r).is_eq() && (r.x - p.x) * (r.x - q.x) <= 0.0 && (r.y - p.y) * (r.y - q.y) <= 0.0
    };
    let apart = |p: Point, q: Point, r: Point, s: Point| {
        let (one, other) = (orientation(p, q, r), orientation(p, q, s));
        one != other && !one.is_eq() && !other.is_eq()
    };
    (apart(a, b, c, d) && apart(c, d, a, b)) || on(a, b, c) || on(a, b, d) || on(c, d, a) || on(c, d, b)
}

/// Calls `visit` with every simple polygon with `n` corners on the grid, once: from its smallest corner on, in one
/// of the two directions.
fn simple_polygons(grid: &[Point], n: usize, visit: &mut impl FnMut(&[Point])) {
    fn grow(grid: &[Point], n: usize, path: &mut Vec<usize>, visit: &mut impl FnMut(&[Point])) {
        let at = |i: usize| grid[i];
        let last = path[path.len() - 1];
        if path.len() == n {
            let closing = [at(last), at(path[0])];
            let free = (1..n - 2).all(|i| !meet(closing, [at(path[i]), at(path[i + 1])]))
                && !meet([at(path[0]); 2], [at(path[n - 2]), at(last)])
                && !meet([at(last); 2], [at(path[0]), at(path[1])])
                && !meet([at(path[1]); 2], closing)
                && !meet([at(path[n - 2]); 2], closing);
            if path[1] < last && free {
                visit(&path.iter().map(|&i| at(i)).collect::<Vec<_>>());
            }
            return;
        }
        for next in path[0] + 1..grid.len() {
            let side = [at(last), at(next)];
            let earlier = path.windows(2).rev().skip(1);
            if path.contains(&next)
                || earlier.clone().any(|pair| meet(side, [at(pair[0]), at(pair[1])]))
                || path.len() > 1
                    && (meet([at(path[path.len() - 2]); 2], side)
                        || meet([at(next); 2], [at(path[path.len() - 2]), at(last)]))
            {
                continue;
            }
            path.push(next);
            grow(grid, n, path, visit);
            path.pop();
        }
    }
    (0..grid.len()).for_each(|first| grow(grid, n, &mut vec![first], visit));
}

#[test]
fn all_simple_polygons_on_small_grids() {
    let grid = |columns: i32, rows: i32| -> Vec<Point> {
        (0..columns * rows).map(|i| Point::new(f64::from(i % columns), f64::from(i / columns))).collect()
    };
    for (grid, sizes) in [(grid(3, 3), 3..=9), (grid(4, 3), 3..=8)] {
        let mut count = 0;
        for n in sizes {
            simple_polygons(&grid, n, &mut |points| {
                count += 1;
                let edges: Vec<[u32; 2]> = (0..n as u32).map(|i| [i, (i + 1) % n as u32]).collect();
                let s = Subdivision::from_graph(points, &edges).unwrap_or_else(|error| panic!("{points:?}: {error}"));
                for method in METHODS {
                    let mut after = s.clone();
                    let added = after.triangulate_face(FaceId::new(1), method).unwrap();
                    assert_eq!((added.diagonals.len(), added.new_faces.len()), (n - 3, n - 3));
                    let mut total = 0.0;
                    for f in after.faces().skip(1) {
                        let corners: Vec<Point> = after.incident_vertices(f).map(|v| after.point(v)).collect();
                        let [a, b, c] = corners[..] else { panic!("{points:?}") };
                        let area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
                        assert!(area > 0.0, "{method:?} {points:?}");
                        total += area;
                    }
                    let walk = |i: usize| points[i].x * points[(i + 1) % n].y - points[(i + 1) % n].x * points[i].y;
                    let whole: f64 = (0..n).map(walk).sum();
                    assert!(total == whole.abs(), "{method:?} {points:?}: triangles overlap");
                }
            });
        }
        assert!(count > 900, "only {count} polygons");
    }
}

/// A box with random points and every edge of a random order that crosses nothing, up to so many.
fn random_graph(random: &mut Random, points: usize, edges: usize, size: usize) -> Subdivision {
    let side = size as f64 + 1.0;
    let mut all = [(-1.0, -1.0), (side, -1.0), (side, side), (-1.0, side)].map(Point::from).to_vec();
    while all.len() < points {
        let p = Point::new(random.below(size) as f64, random.below(size) as f64);
        if !all.contains(&p) {
            all.push(p);
        }
    }
    let mut graph: Vec<[u32; 2]> = vec![[0, 1], [1, 2], [2, 3], [3, 0]];
    let at = |e: [u32; 2]| e.map(|v| all[v as usize]);
    for _ in 0..edges {
        let e = [0; 2].map(|_: u32| random.below(points) as u32);
        let clear = |&g: &[u32; 2]| {
            let shared = e.iter().filter(|v| g.contains(v)).count();
            let [a, b] = at(e);
            let [c, d] = at(g);
            match shared {
                0 => !meet([a, b], [c, d]),
                1 => [(a, b, g, e), (c, d, e, g)].iter().all(|&(p, q, other, own)| {
                    other.iter().filter(|v| !own.contains(v)).all(|&v| !meet([p, q], [all[v as usize]; 2]))
                }),
                _ => false,
            }
        };
        let free = |v: u32| e.contains(&v) || !meet(at(e), [all[v as usize]; 2]);
        if e[0] != e[1] && graph.iter().all(clear) && (0..points as u32).all(free) {
            graph.push(e);
        }
    }
    Subdivision::from_graph(&all, &graph).unwrap_or_else(|error| panic!("{all:?} {graph:?}: {error}"))
}

#[test]
fn random_plane_graphs_with_antennas_rings_and_points() {
    let root = 0x5eed_0000_u64 + u64::from(std::process::id());
    for round in 0..2000 {
        let seed = if round < 1000 { round } else { root + round };
        let mut random = Random(seed);
        let (points, size) = (6 + random.below(20), 5 + random.below(8));
        let edges = random.below(3 * points);
        let s = random_graph(&mut random, points, edges, size);
        let judged = std::panic::catch_unwind(|| judge_whole(&s));
        assert!(judged.is_ok(), "seed {seed}: random_graph(&mut Random({seed}), ..)");
    }
}

/// A random simple polygon on n distinct points of a grid: crossings are undone until there are none.
fn random_polygon(random: &mut Random, n: usize, size: usize) -> Option<Vec<Point>> {
    let mut points: Vec<Point> = Vec::new();
    while points.len() < n {
        let p = Point::new(random.below(size) as f64, random.below(size) as f64);
        if !points.contains(&p) {
            points.push(p);
        }
    }
    for _ in 0..2000 {
        let bad = (0..n)
            .flat_map(|i| (i + 2..n).map(move |j| (i, j)))
            .find(|&(i, j)| (i, j) != (0, n - 1) && meet([points[i], points[i + 1]], [points[j], points[(j + 1) % n]]));
        let Some((i, j)) = bad else { return Some(points) };
        points[i + 1..=j].reverse();
    }
    None
}

#[test]
fn random_simple_polygons_with_random_holes() {
    let mut done = 0;
    for seed in 0..400_u64 {
        let mut random = Random(seed);
        let n = 8 + random.below(30);
        let Some(outline) = random_polygon(&mut random, n, 200) else { continue };
        let mut points = outline;
        let n = points.len() as u32;
        let mut edges: Vec<[u32; 2]> = (0..n).map(|i| [i, (i + 1) % n]).collect();
        // Small triangles wherever they are free of everything else.
        for _ in 0..60 {
            let at = [random.below(200) as f64, random.below(200) as f64];
            let corner = |dx: f64, dy: f64| Point::new(at[0] + dx, at[1] + dy);
            let hole = [corner(0., 0.), corner(3. + random.below(5) as f64, 1.), corner(1., 4.)];
            let sides = [[hole[0], hole[1]], [hole[1], hole[2]], [hole[2], hole[0]]];
            let old = |e: &[u32; 2]| e.map(|v| points[v as usize]);
            if edges.iter().any(|e| sides.iter().any(|&side| meet(side, old(e)))) {
                continue;
            }
            let first = points.len() as u32;
            points.extend(hole);
            edges.extend([[first, first + 1], [first + 1, first + 2], [first + 2, first]]);
        }
        let Ok(s) = Subdivision::from_graph(&points, &edges) else { continue };
        let judged = std::panic::catch_unwind(|| judge_whole(&s));
        assert!(judged.is_ok(), "seed {seed}");
        done += 1;
    }
    assert!(done > 200, "only {done} polygons were simple");
}
