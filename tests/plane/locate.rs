//! Promise: scan, walk and index find where a point lies, exactly, in every subdivision; they agree with crossing
//! numbers in whole numbers; and the index keeps its bound on the edges a query looks at, however edges crowd.

use crate::numbers::Numbers;
use dcel_kit::plane::{Location, Point, PointIndex, Subdivision};
use dcel_kit::topology::InnerComponent;
use dcel_kit::{HalfEdgeId, VertexId};
use std::collections::BTreeSet;

type Whole = (i64, i64);

fn turn(a: Whole, b: Whole, c: Whole) -> i64 {
    ((b.0 - a.0) * (c.1 - a.1) - (b.1 - a.1) * (c.0 - a.0)).signum()
}

fn on(a: Whole, b: Whole, q: Whole) -> bool {
    turn(a, b, q) == 0 && (q.0 - a.0) * (q.0 - b.0) <= 0 && (q.1 - a.1) * (q.1 - b.1) <= 0
}

fn point((x, y): Whole) -> Point {
    Point::new(x as f64, y as f64)
}

/// A random plane graph on even whole numbers: segments that meet at ends only, isolated points, and often a frame or
/// two so that there are rings in rings.
fn random_graph(seed: u64) -> (Vec<Whole>, Vec<[u32; 2]>) {
    let mut next = Numbers::new(seed);
    let size = 4 + next.below(22) as u64;
    let mut points: Vec<Whole> = Vec::new();
    let mut edges: Vec<[u32; 2]> = Vec::new();
    let add = |ends: [Whole; 2], points: &mut Vec<Whole>, edges: &mut Vec<[u32; 2]>| {
        let [a, b] = ends;
        let meets = edges.iter().any(|e| {
            let [c, d] = e.map(|v| points[v as usize]);
            let touch = [(a, b, c), (a, b, d), (c, d, a), (c, d, b)];
            let common = [a, b].iter().filter(|p| [c, d].contains(p)).count();
            let touches = touch.iter().filter(|&&(p, q, r)| on(p, q, r)).count();
            let crosses = turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0;
            crosses || common == 2 || touches > 2 * common
        });
        let blocked = points.iter().any(|&p| p != a && p != b && on(a, b, p));
        if a == b || meets || blocked {
            return;
        }
        let mut number = |p: Whole| {
            points.iter().position(|&q| q == p).unwrap_or_else(|| {
                points.push(p);
                points.len() - 1
            }) as u32
        };
        let ends = [number(a), number(b)];
        edges.push(ends);
    };
    for _ in 0..next.below(3) {
        let (r, m) = (2 + 2 * next.below(size / 2), size as i64);
        let corners = [(m - r, m - r), (m + r, m - r), (m + r, m + r), (m - r, m + r)];
        for i in 0..4 {
            add([corners[i], corners[(i + 1) % 4]], &mut points, &mut edges);
        }
    }
    for _ in 0..next.below(60) {
        let mut place = || (2 * next.below(size), 2 * next.below(size));
        let ends = [place(), place()];
        add(ends, &mut points, &mut edges);
    }
    for _ in 0..next.below(6) {
        let p = (2 * next.below(size), 2 * next.below(size));
        let free = !points.contains(&p) && !edges.iter().any(|e| on(points[e[0] as usize], points[e[1] as usize], p));
        if free {
            points.push(p);
        }
    }
    (points, edges)
}

fn built(points: &[Whole], edges: &[[u32; 2]]) -> Subdivision {
    let points: Vec<Point> = points.iter().map(|&p| point(p)).collect();
    Subdivision::from_graph(&points, edges).unwrap()
}

/// Where the point lies, by crossing numbers of the cycles, in whole numbers.
fn by_crossings(s: &Subdivision, q: Whole) -> Location {
    let whole = |v: VertexId| (s.point(v).x as i64, s.point(v).y as i64);
    if let Some(v) = s.vertices().find(|&v| whole(v) == q) {
        return Location::Vertex(v);
    }
    for h in s.half_edges() {
        let (a, b) = (whole(s.origin(h)), whole(s.destination(h)));
        if a < b && on(a, b, q) {
            return Location::Edge(h);
        }
    }
    let crossed = |h: HalfEdgeId| {
        let (a, b) = (whole(s.origin(h)), whole(s.destination(h)));
        (a.1 > q.1) != (b.1 > q.1) && turn(a, b, q) == if b.1 > a.1 { 1 } else { -1 }
    };
    // In a bounded face the point is inside the boundary and outside the rings: an odd number of times.
    let inside = |f| s.cycles(f).flat_map(|h| s.cycle(h)).filter(|&h| crossed(h)).count() % 2 == 1;
    let surrounded = |h| s.cycle(h).filter(|&h| crossed(h)).count() % 2 == 1;
    let faces: Vec<_> =
        s.faces().filter(|&f| f != s.outer_face() && inside(f) && surrounded(s.half_edge(f).unwrap())).collect();
    assert!(faces.len() <= 1, "{q:?} lies in {faces:?}");
    Location::Face(faces.first().copied().unwrap_or(s.outer_face()))
}

/// Every way to locate gives the same; returns it.
fn agreed(s: &Subdivision, indices: &[PointIndex<&Subdivision>], p: Point, context: &str) -> Location {
    let scan = s.locate_by_scan(p);
    assert_eq!(s.locate(p), scan, "{context}: jump and walk to {p}");
    for index in indices {
        assert_eq!(index.locate(p), scan, "{context}: index with {} cells, {p}", index.cell_count());
    }
    scan
}

fn indices(s: &Subdivision) -> Vec<PointIndex<&Subdivision>> {
    [0.0, 0.3, 1.0, 7.0].map(|density| PointIndex::with_density(s, density)).into()
}

/// Points where it is hard: on vertices and edges, and the nearest doubles beside them.
fn hard_points(s: &Subdivision) -> Vec<Point> {
    let mut hard = Vec::new();
    let mut around = |p: Point| {
        for x in [p.x.next_down(), p.x, p.x.next_up()] {
            for y in [p.y.next_down(), p.y, p.y.next_up()] {
                let p = Point::new(x, y);
                hard.extend(p.check().is_ok().then_some(p));
            }
        }
    };
    s.vertices().for_each(|v| around(s.point(v)));
    for e in s.edges() {
        let [a, b] = e.half_edges().map(|h| s.point(s.origin(h)));
        for t in [0.5, 0.25, 1.0 / 3.0] {
            around(Point::new(a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)));
        }
    }
    hard
}

#[test]
fn all_ways_agree_with_crossing_numbers_on_random_graphs() {
    let (mut on_edges, mut in_rings) = (0, 0);
    for seed in 0..150 {
        let context = format!("seed {seed}");
        let (points, edges) = random_graph(seed);
        let s = built(&points, &edges);
        let indices = indices(&s);
        let size = points.iter().map(|p| p.0.max(p.1)).max().unwrap_or(0);
        for x in -1..=size + 1 {
            for y in -1..=size + 1 {
                let found = agreed(&s, &indices, point((x, y)), &context);
                assert_eq!(found, by_crossings(&s, (x, y)), "{context}: ({x}, {y})");
                on_edges += usize::from(matches!(found, Location::Edge(_)));
                in_rings += usize::from(
                    matches!(found, Location::Face(f) if f != s.outer_face() && !s.inner_components(f).is_empty()),
                );
            }
        }
    }
    assert!(on_edges > 1000 && in_rings > 1000, "{on_edges} on edges, {in_rings} in faces with rings");
}

#[test]
fn all_ways_agree_on_vertices_edges_and_one_ulp_beside_them() {
    let mut beside = 0;
    for seed in 1000..1060 {
        let (points, edges) = random_graph(seed);
        let s = built(&points, &edges);
        let indices = indices(&s);
        for p in hard_points(&s) {
            let found = agreed(&s, &indices, p, &format!("seed {seed}"));
            beside += usize::from(matches!(found, Location::Face(_)));
        }
        for far in [1e9, -1e9, 3e60] {
            for p in [Point::new(far, 3.0), Point::new(3.0, far), Point::new(far, far)] {
                assert_eq!(agreed(&s, &indices, p, "far away"), Location::Face(s.outer_face()));
            }
        }
    }
    assert!(beside > 5000, "{beside}");
}

#[test]
fn walks_from_every_vertex_see_no_face_twice() {
    let mut from_isolated = 0;
    for seed in 2000..2080 {
        let (points, edges) = random_graph(seed);
        let s = built(&points, &edges);
        let size = points.iter().map(|p| p.0.max(p.1)).max().unwrap_or(0);
        let mut next = Numbers::new(seed);
        for start in s.vertices() {
            from_isolated += usize::from(s.outgoing(start).is_none());
            for _ in 0..30 {
                let q = (next.below(size as u64 + 3) - 1, next.below(size as u64 + 3) - 1);
                let walk = s.walk_from(start, point(q)).unwrap();
                assert_eq!(walk.location, by_crossings(&s, q), "seed {seed}, {start} to {q:?}");
                assert_eq!(s.locate_from(start, point(q)), Ok(walk.location));
                let distinct: BTreeSet<_> = walk.faces.iter().collect();
                assert_eq!(distinct.len(), walk.faces.len(), "seed {seed}, {start} to {q:?}: {:?}", walk.faces);
                assert!(walk.half_edges <= s.half_edge_count());
                if let Location::Face(f) = walk.location {
                    assert_eq!(walk.faces.last(), Some(&f));
                }
            }
        }
    }
    assert!(from_isolated > 20, "{from_isolated}");
}

#[test]
fn crossing_segments_that_are_split_at_rounded_points() {
    for seed in 3000..3012 {
        let mut next = Numbers::new(seed);
        let mut place = || Point::new(next.unit(), next.unit());
        let segments: Vec<[Point; 2]> = (0..40).map(|_| [place(), place()]).collect();
        let options = dcel_kit::plane::ArrangeOptions { split: true, ..Default::default() };
        let s = Subdivision::arrange_segments(&segments, &options).unwrap().subdivision;
        let indices = indices(&s);
        for p in hard_points(&s).into_iter().step_by(7).chain((0..200).map(|_| place())) {
            agreed(&s, &indices, p, &format!("seed {seed}"));
        }
    }
}

#[test]
fn full_cells_and_cells_with_lists_agree() {
    for seed in 3100..3104 {
        let mut next = Numbers::new(seed);
        let mut place = || Point::new(next.unit(), next.unit());
        let segments: Vec<[Point; 2]> = (0..60).map(|_| [place(), place()]).collect();
        let options = dcel_kit::plane::ArrangeOptions { split: true, ..Default::default() };
        let s = Subdivision::arrange_segments(&segments, &options).unwrap().subdivision;
        let (full, lists) = (PointIndex::with_density(&s, 0.0), PointIndex::with_density(&s, 16.0));
        for _ in 0..8000 {
            let p = place();
            assert_eq!(full.locate(p), lists.locate(p), "seed {seed}: {p}");
        }
    }
}

/// Rows are filled band by band, and the numbering in stretches: an edge may pass several bands, each of which may have
/// crowds.
#[test]
fn cells_filled_in_several_bands_agree_with_walks() {
    let mut next = Numbers::new(3200);
    let mut points: Vec<Point> = (0..30_000).map(|_| Point::new(next.unit(), next.unit())).collect();
    points.extend([Point::new(-0.3, 0.5), Point::new(1.3, 0.5)]);
    for height in [0.05, 0.3, 0.55, 0.8, 0.97] {
        points.extend((0..300).map(|_| Point::new(0.5 + 1e-5 * next.unit(), height + 1e-5 * next.unit())));
    }
    let s = Subdivision::delaunay(&points).unwrap().subdivision;
    let index = PointIndex::with_density(&s, 2.0);
    assert!(index.cell_count() > 150_000, "several bands: {} cells", index.cell_count());
    let near = |p: Point, next: &mut Numbers| Point::new(p.x + 1e-7 * next.unit(), p.y - 1e-7 * next.unit());
    let beside: Vec<Point> = points.iter().map(|&p| near(p, &mut next)).collect();
    let anywhere = (0..30_000).map(|_| Point::new(1.7 * next.unit() - 0.35, 1.1 * next.unit() - 0.05));
    let asked: Vec<Point> = points.iter().copied().chain(beside).chain(anywhere).collect();
    for p in asked {
        assert_eq!(index.locate(p), s.locate(p), "{p}");
    }
}

#[test]
fn turning_moving_and_scaling_changes_nothing() {
    let maps: [fn(Point) -> Point; 4] = [
        |p| Point::new(-p.y, p.x),
        |p| Point::new(p.x + 1e15, p.y - 1e15),
        |p| Point::new(p.x * 2f64.powi(-140), p.y * 2f64.powi(-140)),
        |p| Point::new(p.x * 2f64.powi(190), -p.y * 2f64.powi(-130)),
    ];
    for seed in 4000..4040 {
        let (points, edges) = random_graph(seed);
        let s = built(&points, &edges);
        let size = points.iter().map(|p| p.0.max(p.1)).max().unwrap_or(0);
        for (which, map) in maps.iter().enumerate() {
            let moved: Vec<Point> = points.iter().map(|&p| map(point(p))).collect();
            let t = Subdivision::from_graph(&moved, &edges).unwrap();
            let indices = indices(&t);
            for x in 0..=size {
                let q = (x, (x * 7 + seed as i64) % (size + 1));
                let (was, is) =
                    (by_crossings(&s, q), agreed(&t, &indices, map(point(q)), &format!("seed {seed}, map {which}")));
                match (was, is) {
                    (Location::Edge(h), Location::Edge(g)) => assert_eq!(h.edge(), g.edge()),
                    // The mirrored map has other faces: their cycles run the other way.
                    (Location::Face(f), Location::Face(g)) if which == 3 => {
                        assert_eq!(s.cycles(f).count(), t.cycles(g).count());
                    }
                    _ => assert_eq!(was, is, "seed {seed}, map {which}, {q:?}"),
                }
            }
        }
    }
}

#[test]
fn a_batch_gives_single_answers_in_the_order_of_the_points() {
    let (points, edges) = random_graph(17);
    let s = built(&points, &edges);
    let mut next = Numbers::new(5);
    let asked: Vec<Point> = (0..3000).map(|_| Point::new(60.0 * next.unit() - 5.0, 60.0 * next.unit() - 5.0)).collect();
    let single: Vec<Location> = asked.iter().map(|&p| s.locate_by_scan(p)).collect();
    assert_eq!(s.locate_all(&asked), single);
    assert_eq!(s.locate_all(&[]), []);
}

#[test]
fn a_batch_of_several_blocks_gives_single_answers() {
    // Blocks hold 8192 points here: two whole ones and a rest; points outside and on the corners among them.
    let mut next = Numbers::new(41);
    let s = Subdivision::lab_rectangle();
    let index = PointIndex::new(&s);
    let corners: Vec<Point> = s.vertices().map(|v| s.point(v)).collect();
    let asked: Vec<Point> = (0..20_000)
        .map(|i| match i % 50 {
            0 => corners[i / 50 % corners.len()],
            _ => point((next.below(1000) - 500, next.below(1000) - 500)),
        })
        .collect();
    let single: Vec<Location> = asked.iter().map(|&p| index.locate(p)).collect();
    assert!(index.locate_all(&asked) == single, "the answers of blocks, in the order of the points");
    assert!(single.iter().collect::<BTreeSet<_>>().len() > 8, "different answers");
}

#[test]
fn the_empty_plane_lonely_points_and_no_numbers() {
    let empty = Subdivision::new();
    let lonely =
        Subdivision::from_graph(&[Point::new(1.0, 2.0), Point::new(0.0, 0.0), Point::new(1.0, 3.0)], &[]).unwrap();
    let one = Subdivision::from_graph(&[Point::new(0.0, 0.0)], &[]).unwrap();
    let (f0, v) = (Location::Face(empty.outer_face()), |i| Location::Vertex(VertexId::new(i)));
    assert_eq!(agreed(&empty, &indices(&empty), Point::new(0.0, 0.0), "empty"), f0);
    assert_eq!(agreed(&one, &indices(&one), Point::new(-0.0, 0.0), "one"), v(0));
    assert_eq!(agreed(&one, &indices(&one), Point::new(0.0, 1e-40), "one"), f0);
    assert_eq!(agreed(&lonely, &indices(&lonely), Point::new(1.0, 3.0), "lonely"), v(2));
    assert_eq!(agreed(&lonely, &indices(&lonely), Point::new(1.0, 2.5), "lonely"), f0);
    let lab = Subdivision::lab_rectangle();
    let far = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e308].map(|bad| (bad, true));
    for (bad, is_far) in far.into_iter().chain([(5e-324, false)]) {
        for p in [Point::new(bad, 0.5), Point::new(0.5, bad), Point::new(bad, bad)] {
            let found = agreed(&lab, &indices(&lab), p, "no place for a vertex");
            assert_eq!(found == f0, is_far, "{p}");
        }
    }
    assert!(lab.locate_from(VertexId::new(99), Point::default()).is_err());
}

// ---- crowds ------------------------------------------------------------------------------------------------

/// Checks the bound on the edges looked at, the memory for each edge, and answers.
fn crowd(name: &str, segments: &[[Point; 2]], asked: impl Iterator<Item = Point>) {
    let s = Subdivision::from_segments(segments).unwrap();
    let index = PointIndex::new(&s);
    let (n, log) = (s.edge_count(), (s.edge_count() as f64).log2());
    let (worst, bytes) = (index.worst_case() as f64, index.memory_bytes() as f64 / n as f64);
    assert!(worst <= 24.0_f64.max(5.0 * log), "{name}: {worst} edges looked at, of {n}");
    assert!(bytes <= 40.0 + 16.0 * log, "{name}: {bytes} bytes for each edge");
    for p in asked {
        assert_eq!(index.locate(p), s.locate_by_scan(p), "{name}: {p}");
    }
}

#[test]
fn crowded_edges_cost_a_logarithm() {
    let mut next = Numbers::new(11);
    let mut places: Vec<Point> =
        (0..40).map(|_| Point::new(2.0 * next.unit() - 1.0, 2.0 * next.unit() - 1.0)).collect();
    places.extend([Point::new(0.0, 0.0), Point::new(0.0, 0.5), Point::new(1e-7, 1e-9), Point::new(-1.0, 0.0)]);
    let n = 4000;
    let star: Vec<[Point; 2]> = (0..n)
        .map(|i| {
            let (sin, cos) = (f64::from(i) * std::f64::consts::TAU / f64::from(n)).sin_cos();
            [Point::new(0.0, 0.0), Point::new(cos, sin)]
        })
        .collect();
    crowd("star", &star, places.iter().copied());

    // Long edges side by side: a grid of small cells would list each of them everywhere.
    let slanted = |i: i32| {
        let at = |x: f64| Point::new(x, f64::from(i) / f64::from(n) + 0.1 * x);
        [at(-1.0 - next.unit()), at(1.0 + next.unit())]
    };
    let bundle: Vec<[Point; 2]> = (0..n).map(slanted).collect();
    crowd("bundle", &bundle, places.iter().copied());

    // Everything in one cell, but for one edge far away.
    let mut cluster: Vec<[Point; 2]> = Vec::new();
    for i in 0..60 {
        for j in 0..60 {
            let (x, y) = (1e-9 * f64::from(i), 1e-9 * f64::from(j));
            cluster
                .push([Point::new(x, y), Point::new(x + 1e-9 * next.unit().min(0.9), y + 1e-9 * next.unit().min(0.9))]);
        }
    }
    cluster.push([Point::new(0.9, 0.9), Point::new(1.0, 1.0)]);
    let close = places.iter().map(|p| Point::new(6e-8 * p.x.abs(), 6e-8 * p.y.abs()));
    let ends = cluster.iter().flatten().copied().step_by(97);
    crowd("cluster", &cluster, places.iter().copied().chain(close).chain(ends.collect::<Vec<_>>()));

    // Squares in squares, each half as large: every grid has one cell with almost all of them. With rings, and
    // vertical edges.
    let nest: Vec<[Point; 2]> = (0..100)
        .flat_map(|i| {
            let r = 2f64.powi(-i);
            let c = [(-r, -r), (r, -r), (r, r), (-r, r)].map(Point::from);
            [[c[0], c[1]], [c[1], c[2]], [c[2], c[3]], [c[3], c[0]]]
        })
        .collect();
    let scaled = (0..100).flat_map(|i| {
        let r = 2f64.powi(-i);
        [(0.8 * r, 0.1 * r), (r, 0.5 * r), (-r, r), (0.3 * r, -r), (-0.9 * r, -0.2 * r)].map(Point::from)
    });
    crowd("nest", &nest, scaled.chain(places));
}

#[test]
fn faces_with_a_thousand_rings() {
    let mut segments: Vec<[Point; 2]> = Vec::new();
    let mut square = |x: f64, y: f64, r: f64| {
        let c = [(x - r, y - r), (x + r, y - r), (x + r, y + r), (x - r, y + r)].map(Point::from);
        segments.extend([[c[0], c[1]], [c[1], c[2]], [c[2], c[3]], [c[3], c[0]]]);
    };
    square(16.0, 16.0, 20.0);
    for i in 0..1024 {
        square(f64::from(i % 32), f64::from(i / 32), 0.25);
    }
    let s = Subdivision::from_segments(&segments).unwrap();
    let index = PointIndex::new(&s);
    let mut next = Numbers::new(3);
    let (mut between, mut inside) = (0, 0);
    for _ in 0..300 {
        let p = Point::new(32.0 * next.unit(), 32.0 * next.unit());
        let found = index.locate(p);
        assert_eq!((s.locate(p), s.locate_by_scan(p)), (found, found));
        let (dx, dy) = ((p.x - p.x.round()).abs(), (p.y - p.y.round()).abs());
        let in_square = dx < 0.25 && dy < 0.25 && p.x < 31.5 && p.y < 31.5;
        let Location::Face(f) = found else { panic!("{p} lies on {found}") };
        assert_eq!(
            s.inner_components(f).iter().filter(|ring| matches!(ring, InnerComponent::Cycle(_))).count() > 0,
            !in_square,
            "{p}"
        );
        *(if in_square { &mut inside } else { &mut between }) += 1;
    }
    assert!(inside > 30 && between > 30, "{inside} inside, {between} between");
    assert!(index.worst_case() <= 24, "{}", index.worst_case());
}

// ---- work --------------------------------------------------------------------------------------------------

#[test]
fn a_triangulation_is_walked_by_its_cube_root_and_asked_in_constant_work() {
    let side = 60;
    let at = |i: u32, j: u32| i * (side + 1) + j;
    let mut next = Numbers::new(9);
    let points: Vec<Point> = (0..=side)
        .flat_map(|i| (0..=side).map(move |j| (i, j)))
        .map(|(i, j)| Point::new(f64::from(i) + 0.3 * next.unit(), f64::from(j) + 0.3 * next.unit()))
        .collect();
    let triangles: Vec<[u32; 3]> = (0..side)
        .flat_map(|i| (0..side).map(move |j| (i, j)))
        .flat_map(|(i, j)| {
            let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            [[a, b, c], [a, c, d]]
        })
        .collect();
    let s = Subdivision::from_triangles(points, &triangles).unwrap();
    let index = PointIndex::new(&s);
    assert!(index.worst_case() <= 16, "{} edges in one cell", index.worst_case());
    let bytes = index.memory_bytes() as f64 / s.edge_count() as f64;
    assert!(bytes <= 26.0, "{bytes} bytes for each edge");
    let (mut looked_at, asked) = (0, 400);
    for _ in 0..asked {
        let p = Point::new(60.0 * next.unit(), 60.0 * next.unit());
        let corner = s.walk_from(VertexId::new(0), p).unwrap();
        assert_eq!((corner.location, s.locate(p)), (index.locate(p), index.locate(p)));
        // Straight from the corner: not more triangles than the lines of the grid that are crossed.
        assert!(corner.faces.len() as f64 <= 3.0 + 2.0 * (p.x + p.y), "{p}: {} faces", corner.faces.len());
        looked_at += corner.half_edges;
    }
    assert!(looked_at / asked < 3 * 140, "{looked_at}");
}

// ---- stated answers ----------------------------------------------------------------------------------------

fn data(path: &str) -> String {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared/data").join(path);
    std::fs::read_to_string(path).unwrap()
}

/// The innermost brackets of a WKT text: lists of points.
fn lists(wkt: &str) -> Vec<Vec<Point>> {
    let list = |text: &str| -> Vec<Point> {
        let numbers = |pair: &str| pair.split_whitespace().map(|word| word.parse().unwrap()).collect::<Vec<f64>>();
        text.split(',').map(numbers).filter(|pair| pair.len() == 2).map(|p| Point::new(p[0], p[1])).collect()
    };
    let pieces = wkt.split(['(', ')']).filter(|piece| piece.contains(|c: char| c.is_ascii_digit()));
    pieces.map(list).collect()
}

/// Points against polygons in TestRelatePA.xml: whether some of the points lie inside, on the rim, and outside.
#[test]
#[cfg_attr(not(shared_data), ignore = "needs ../shared/data")]
fn points_and_polygons_of_jts_as_stated() {
    let text = data("O14-jts-xml/TestRelatePA.xml");
    let document = roxmltree::Document::parse(&text).unwrap();
    let mut cases = 0;
    for case in document.descendants().filter(|n| n.has_tag_name("case")) {
        let part = |name: &str| case.descendants().find(|n| n.has_tag_name(name)).and_then(|n| n.text()).unwrap();
        if !part("a").contains("POINT") {
            continue;
        }
        cases += 1;
        let relate = case.descendants().find(|n| n.attribute("name") == Some("relate")).unwrap();
        let stated = relate.attribute("arg3").unwrap()[..3].replace(|c| c != 'F', "0");
        let segments: Vec<[Point; 2]> = lists(part("b"))
            .iter()
            .flat_map(|ring| ring.windows(2).map(|w| [w[0], w[1]]).collect::<Vec<_>>())
            .collect();
        let s = Subdivision::from_segments(&segments).unwrap();
        let mut seen = [false; 3];
        for p in lists(part("a")).concat() {
            let which = match agreed(&s, &indices(&s), p, part("desc")) {
                Location::Face(f) if f == s.outer_face() => 2,
                Location::Face(_) => 0,
                _ => 1,
            };
            seen[which] = true;
        }
        let found: String = seen.map(|seen| if seen { '0' } else { 'F' }).iter().collect();
        assert_eq!(found, stated, "{}", part("desc"));
    }
    assert_eq!(cases, 9);
}

/// The signs of nearly collinear points that come with robust-predicates; and the point beside the edge accordingly.
#[test]
#[cfg_attr(not(shared_data), ignore = "needs ../shared/data")]
fn signs_of_nearly_collinear_points_as_stated() {
    let mut on_or_beside = [0; 3];
    for line in data("O10-robust-predicates/orient2d.txt").lines().filter(|line| !line.trim().is_empty()) {
        let n: Vec<f64> = line.split_whitespace().map(|word| word.parse().unwrap()).collect();
        let [a, b, c] = [(n[1], n[2]), (n[3], n[4]), (n[5], n[6])].map(Point::from);
        let turn = dcel_kit::plane::predicates::orientation(a, b, c);
        assert_eq!(turn as i8, n[7] as i8, "{line}");
        on_or_beside[(turn as i8 + 1) as usize] += 1;
        // A triangle as thin as this one: its corners and its middle.
        let Ok(s) = Subdivision::from_segments(&[[a, b], [b, c], [c, a]]) else { continue };
        let centre = Point::new(a.x / 3.0 + b.x / 3.0 + c.x / 3.0, a.y / 3.0 + b.y / 3.0 + c.y / 3.0);
        for p in [a, b, c, centre] {
            agreed(&s, &indices(&s), p, line);
        }
    }
    assert!(
        on_or_beside.iter().sum::<i32>() == 1000 && on_or_beside[0] > 300 && on_or_beside[2] > 300,
        "{on_or_beside:?}"
    );
}
