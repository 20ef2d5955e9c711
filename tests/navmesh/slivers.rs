//! Maps of long thin faces: the index stays small, and says what a scan says.
//!
//! ```text
//!   ┌──────────────────────────────┐      The defect navmesh_row_of_pillars: triangles from the tips of the pillars to
//!   │  ▴   ▴   ▴   ▴   ▴   ▴   ▴   │      one far corner run through all cells of a row.
//!   └──────────────────────────────┘
//! ```

use crate::maps::Random;
use dcel_kit::navmesh::{LiveMesh, Location, NavMesh};
use dcel_kit::plane::{Point, Subdivision, TriangulationMethod};
use dcel_kit::{EdgeId, HalfEdgeId};

/// A corridor with triangular pillars in a row, turned by `turn` and cut into triangles, Delaunay where that is not
/// forbidden.
fn pillars(count: usize, [cos, sin]: [f64; 2]) -> Subdivision {
    let width = 3.0 * count as f64 + 1.0;
    let mut corners: Vec<[f64; 2]> = vec![[-1., -1.], [width, -1.], [width, 3.], [-1., 3.]];
    let mut edges = vec![[0, 1], [1, 2], [2, 3], [3, 0]];
    for i in 0..count {
        let (x, first) = (3.0 * i as f64, corners.len() as u32);
        corners.extend([[x, 0.], [x + 1., 0.], [x, 1.]]);
        edges.extend((0..3).map(|k| [first + k, first + (k + 1) % 3]));
    }
    let points: Vec<Point> = corners.iter().map(|&[x, y]| Point::new(x * cos - y * sin, x * sin + y * cos)).collect();
    let mut map = Subdivision::from_graph(&points, &edges).expect("pillars stand apart");
    for i in 0..count as u32 {
        let inside = map.face(HalfEdgeId::new(2 * (4 + 3 * i)));
        map.set_hole(inside, true);
    }
    let borders = map.edge_bound();
    map.triangulate(TriangulationMethod::Monotone).expect("the corridor is simple");
    map.make_delaunay(|edge| edge.index() < borders);
    map
}

/// A star of triangles from one far point to a zigzag: every one of them runs through the whole map.
fn rays(count: usize) -> Subdivision {
    let zigzag = (0..=count).map(|i| Point::new(i as f64, -((i % 2) as f64)));
    let points = std::iter::once(Point::new(0.3 * count as f64, 5.0 * count as f64)).chain(zigzag).collect();
    let triangles: Vec<[u32; 3]> = (1..=count as u32).map(|i| [0, i, i + 1]).collect();
    Subdivision::from_triangles(points, &triangles).expect("the zigzag is seen from the far point")
}

/// `first` is the map without obstacles: what they cut off a hole is that hole still.
fn check(map: &Subdivision, first: &Subdivision, mesh: &NavMesh, random: &mut Random, context: &str) {
    let all = |of: fn(Point) -> f64| map.vertices().map(|v| of(map.point(v))).fold(f64::INFINITY, f64::min);
    let [left, right, low, high] = [all(|p| p.x), -all(|p| -p.x), all(|p| p.y), -all(|p| -p.y)];
    let anywhere =
        |random: &mut Random| Point::new(left + (right - left) * random.unit(), low + (high - low) * random.unit());
    let mut asked: Vec<Point> = (0..150).map(|_| anywhere(random)).collect();
    for e in map.edges().step_by(7) {
        let [a, b] = e.half_edges().map(|h| map.point(map.origin(h)));
        let middle = Point::new(0.5 * (a.x + b.x), 0.5 * (a.y + b.y));
        asked.extend([a, middle, Point::new(middle.x, middle.y.next_up()), Point::new(a.x.next_down(), a.y)]);
    }
    for p in asked {
        let found = mesh.locate(p);
        assert_eq!(found, mesh.locate_by_scan(p), "{context}: {p}");
        if let Location::Hole(hole) = found {
            let exact = first.locate_by_scan(p);
            assert!(!matches!(exact, dcel_kit::plane::Location::Face(f) if f != hole), "{context}: {p} is in {exact}");
        }
    }
}

#[test]
fn points_among_slivers_are_where_a_scan_finds_them() {
    let mut random = Random::new(21);
    // (3, 4)/5 turns exactly enough for straight sides to stay almost straight.
    for turn in [[1.0, 0.0], [0.0, 1.0], [0.6, 0.8]] {
        let map = pillars(120, turn);
        let mesh = NavMesh::new(&map).expect("triangles");
        check(&map, &map, &mesh, &mut random, &format!("pillars turned by {turn:?}"));
    }
    let map = rays(300);
    check(&map, &map, &NavMesh::new(&map).expect("triangles"), &mut random, "rays");
}

#[test]
fn navmesh_row_of_pillars_takes_memory_in_the_size_of_the_map() {
    for (name, map) in
        [("pillars", [500, 1000].map(|count| pillars(count, [1.0, 0.0]))), ("rays", [1500, 3000].map(rays))]
    {
        let each = map.map(|map| {
            let mesh = NavMesh::new(&map).expect("triangles");
            mesh.memory() as f64 / mesh.face_count() as f64
        });
        assert!(each[1] < 1.3 * each[0] && each[1] < 1500.0, "{name}: {each:?} bytes a face");
    }
}

#[test]
fn obstacles_come_and_go_among_slivers() {
    let mut random = Random::new(22);
    // Of the longer row the faces are so long that their cells would be crowded.
    for count in [60, 150] {
        let first = pillars(count, [1.0, 0.0]);
        let mut live = LiveMesh::new(first.clone()).expect("triangles");
        let mut placed = Vec::new();
        for step in 0..12 {
            let x = 3.0 * random.below(count - 2) as f64 + 1.2;
            let block = [[x, 1.4], [x + 1.1, 1.3], [x + 0.7, 2.2]].map(Point::from);
            if let Ok(obstacle) = live.insert_obstacle(&block) {
                placed.push(obstacle);
            }
            if step % 3 == 2 {
                let gone = placed.swap_remove(random.below(placed.len()));
                live.remove(gone).expect("it was placed");
            }
            check(live.map(), &first, live.mesh(), &mut random, &format!("{count} pillars, step {step}"));
        }
        assert!(placed.len() > 3, "{} obstacles could be placed", placed.len());
    }
}

/// Where obstacles cross borders these are split, at the crossing as it is rounded: what was in a face a hair beside the
/// border is in the hole by now, or the other way round.
#[test]
fn beside_borders_that_obstacles_cross_among_slivers_points_are_where_a_scan_finds_them() {
    let mut random = Random::new(23);
    let mut changed = 0;
    for turn in [0.0f64, 1e-3, -2e-3] {
        let (sin, cos) = turn.sin_cos();
        let first = pillars(150, [cos, sin]);
        let fresh = LiveMesh::new(first.clone()).expect("triangles");
        for _ in 0..6 {
            let mut live = fresh.clone();
            for _ in 0..2 {
                // Across the upper border, the lower one, or a pillar.
                let (x, y) = (3.0 * random.below(149) as f64 + 0.8 * random.unit(), [2.7, -1.2, 0.3][random.below(3)]);
                let wide = 0.3 + 0.5 * random.unit();
                let block = [[x, y], [x + wide, y + 0.1 * random.unit()], [x + 0.2 * random.unit(), y + 0.6]];
                // One that would lie over another one's corner may be refused.
                let _ = live.insert_obstacle(&block.map(|[x, y]| Point::new(x * cos - y * sin, x * sin + y * cos)));
            }
            let (map, mesh) = (live.map(), live.mesh());
            let borders = map.edges().map(EdgeId::half_edges).filter(|halves| {
                let is_new = halves.iter().any(|&h| map.origin(h).index() >= first.vertex_bound());
                let [left, right] = halves.map(|h| mesh.has_face(map.face(h)));
                is_new && left != right
            });
            for halves in borders {
                let [a, b] = halves.map(|h| map.point(map.origin(h)));
                for _ in 0..100 {
                    let t = random.unit();
                    let p = Point::new(a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t);
                    for p in [p, Point::new(p.x, p.y.next_up()), Point::new(p.x, p.y.next_down())] {
                        let found = mesh.locate(p);
                        assert_eq!(found, mesh.locate_by_scan(p), "turned by {turn}: {p}");
                        let is_off = matches!(found, Location::Hole(_) | Location::Outer);
                        let was_on = matches!(fresh.mesh().locate(p), Location::Face(_));
                        changed += usize::from(is_off && was_on);
                    }
                }
            }
        }
    }
    assert!(changed > 20, "{changed} points of faces are in holes");
}
