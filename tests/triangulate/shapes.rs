//! Shapes with names: combs, spirals, stars, straight runs, rings in rings, islands, dangling edges.

use crate::common::Random;
use crate::judge::{METHODS, judge, judge_whole, polygon, rings, triangles_due};
use dcel_kit::plane::{MonotoneEvent, Point, Subdivision, TriangulationMethod};
use dcel_kit::topology::Journal;
use dcel_kit::{FaceId, VertexId};

const F1: FaceId = FaceId::new(1);

fn comb(teeth: i32, height: i32) -> Vec<(i32, i32)> {
    let mut points = vec![(4 * teeth, -height), (4 * teeth, 0)];
    points.extend((0..teeth).rev().flat_map(|i| [(4 * i + 3, height), (4 * i + 1, height + i % 3), (4 * i, 0)]));
    points.push((0, -height));
    points
}

fn spiral(turns: i32) -> Vec<(i32, i32)> {
    // A corridor one wide that winds inwards; its outer side, then its inner side back.
    let corner = |i: i32, gap: i32| {
        let r = 4 * turns - 2 * (i / 4) * 2 - gap;
        match i % 4 {
            0 => (-r, -r),
            1 => (r, -r),
            2 => (r, r),
            _ => (-r, r - 4),
        }
    };
    let n = 4 * turns - 4;
    let mut points: Vec<_> = (0..n).map(|i| corner(i, 0)).collect();
    points.extend((0..n).rev().map(|i| corner(i, 1)));
    points
}

fn star(points: i32) -> Vec<(i32, i32)> {
    let at = |i: i32| {
        let angle = f64::from(i) * std::f64::consts::PI / f64::from(points);
        let r = if i % 2 == 0 { 1e6 } else { 3e5 };
        ((r * angle.cos()).round() as i32, (r * angle.sin()).round() as i32)
    };
    (0..2 * points).map(at).collect()
}

fn turned(points: &[(i32, i32)], quarter: i32) -> Vec<(i32, i32)> {
    let turn = |&(x, y): &(i32, i32)| match quarter {
        0 => (x, y),
        1 => (-y, x),
        2 => (-x, -y),
        3 => (y, -x),
        _ => (3 * x - 2 * y, 2 * x + 3 * y),
    };
    points.iter().map(turn).collect()
}

#[test]
fn shapes_in_every_position_and_order() {
    let straight_runs: Vec<(i32, i32)> = (0..9)
        .map(|x| (x, 0))
        .chain((1..9).map(|y| (8, y)))
        .chain((0..8).rev().map(|x| (x, 8 - (8 - x) / 3)))
        .collect();
    let zigzag: Vec<(i32, i32)> =
        (0..12).map(|i| (i, 5 * (i % 2))).chain((0..12).rev().map(|i| (i, 5 * (i % 2) + 2))).collect();
    for shape in [comb(6, 9), spiral(4), star(7), straight_runs, zigzag, comb(3, 1), star(3)] {
        for quarter in 0..5 {
            let mut points = turned(&shape, quarter);
            for _ in 0..3 {
                let s = polygon(&points);
                assert_eq!(triangles_due(&s, F1), points.len() - 2);
                judge_whole(&s);
                let by = 1 + points.len() / 3;
                points.rotate_left(by);
                points.reverse();
            }
        }
    }
}

#[test]
fn rings_in_rings_and_islands_and_points() {
    let square = |at: i32, size: i32| [(at, at), (at + size, at), (at + size, at + size), (at, at + size)];
    let (a, b, c, d) = (square(0, 40), square(4, 30), square(8, 20), square(10, 4));
    judge_whole(&rings(&[&a, &b, &c, &d]));
    judge_whole(&rings(&[&a, &[(1, 1), (2, 1), (1, 2)], &[(38, 37), (39, 39), (36, 39)], &b]));
    // Rings that open at one upright line, in one row, and one right of another.
    let triangle = |x: i32, y: i32| [(x, y), (x + 2, y + 1), (x, y + 2)];
    let row: Vec<[(i32, i32); 3]> = (0..6).map(|i| triangle(2 + 4 * (i % 3), 2 + 5 * (i / 3))).collect();
    let mut lists: Vec<&[(i32, i32)]> = vec![&a];
    lists.extend(row.iter().map(|list| &list[..]));
    judge_whole(&rings(&lists));

    let points = [(0, 0), (9, 0), (9, 9), (0, 9), (3, 3), (3, 6), (6, 3), (6, 6), (3, 4), (1, 8), (8, 3), (0, 4)];
    let points = points.map(|(x, y)| Point::new(f64::from(x), f64::from(y)));
    let outline = [[0, 1], [1, 2], [2, 3], [3, 11], [11, 0]];
    judge_whole(&Subdivision::from_graph(&points, &outline).unwrap());
    // Dangling edges from the boundary, a tree and a single edge inside, isolated points.
    let mut edges = outline.to_vec();
    edges.extend([[0, 4], [4, 8], [6, 7], [5, 9]]);
    judge_whole(&Subdivision::from_graph(&points, &edges).unwrap());
    edges.extend([[4, 6], [7, 2]]);
    judge_whole(&Subdivision::from_graph(&points, &edges).unwrap());
}

#[test]
fn faces_that_touch_themselves() {
    // A ring that touches the boundary at a vertex, two rings that touch each other, a bow tie, a vertex passed thrice.
    judge_whole(&graph(&[(0, 0), (8, 0), (8, 8), (0, 8), (4, 2), (2, 4)], &[&[0, 1, 2, 3], &[0, 4, 5]]));
    judge_whole(&graph(
        &[(0, 0), (9, 0), (9, 9), (0, 9), (4, 4), (2, 3), (2, 5), (6, 3), (6, 5)],
        &[&[0, 1, 2, 3], &[4, 5, 6], &[4, 7, 8]],
    ));
    judge_whole(&graph(&[(0, 0), (4, 2), (4, -2), (-4, 2), (-4, -2)], &[&[0, 1, 2], &[0, 3, 4]]));
    judge_whole(&graph(
        &[(-9, -9), (9, -9), (9, 9), (-9, 9), (0, 0), (2, 5), (-2, 5), (5, -2), (5, 2), (-5, -4), (-4, -5)],
        &[&[0, 1, 2, 3], &[4, 5, 6], &[4, 7, 8], &[4, 9, 10]],
    ));
    // Many ends and many beginnings at one vertex.
    let rays = 40;
    let mut points = vec![(0, 0)];
    let mut lists: Vec<Vec<u32>> = vec![vec![1, 2, 3, 4]];
    points.extend([(-900, -900), (900, -900), (900, 900), (-900, 900)]);
    for i in 0..rays {
        let n = points.len() as u32;
        let (x, y) = if i % 2 == 0 { (300, 20 * (i - rays / 2)) } else { (-300, 20 * (i - rays / 2)) };
        points.extend([(x, y), (x, y + 9)]);
        lists.push(if i % 2 == 0 { vec![0, n, n + 1] } else { vec![0, n + 1, n] });
    }
    judge_whole(&graph(&points, &lists.iter().map(|list| &list[..]).collect::<Vec<_>>()));
}

/// Closed lines over common points.
fn graph(points: &[(i32, i32)], lists: &[&[u32]]) -> Subdivision {
    let points: Vec<Point> = points.iter().map(|&(x, y)| Point::new(f64::from(x), f64::from(y))).collect();
    let closed = |list: &&[u32]| (0..list.len()).map(|i| [list[i], list[(i + 1) % list.len()]]).collect::<Vec<_>>();
    let edges: Vec<[u32; 2]> = lists.iter().flat_map(closed).collect();
    Subdivision::from_graph(&points, &edges).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn hole_faces_stay_whole_unless_asked_for() {
    let mut s = rings(&[&[(0, 0), (9, 0), (9, 9), (0, 9)], &[(3, 3), (6, 3), (6, 6), (5, 5), (3, 6)]]);
    s.mark_holes(&[Point::new(4.0, 4.0)]).unwrap();
    let hole = s.hole_faces().next().unwrap();
    judge_whole(&s);
    for method in METHODS {
        let mut only = s.clone();
        only.triangulate(method).unwrap();
        assert_eq!(only.hole_faces().collect::<Vec<_>>(), [hole]);
        let mut all = s.clone();
        let added = all.triangulate_all(method).unwrap();
        judge(&s, &s.faces().skip(1).collect::<Vec<_>>(), &all, &added);
        assert_eq!(all.hole_faces().count(), 3);
        let mut one = s.clone();
        let added = one.triangulate_face(hole, method).unwrap();
        judge(&s, &[hole], &one, &added);
        assert_eq!(one.triangulate_face(hole, method).unwrap().diagonals, [], "a triangle stays as it is");
    }
}

#[test]
fn a_triangulation_is_recorded_and_can_be_taken_back() {
    let points = [(0., 0.), (9., 0.), (9., 9.), (0., 9.), (3., 3.), (5., 4.), (4., 6.), (7., 7.)].map(Point::from);
    let edges = [[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 4]];
    let s = Subdivision::from_graph(&points, &edges).unwrap();
    for method in METHODS {
        let mut journal = Journal::new();
        let mut after = s.clone();
        after.triangulate_face_with(F1, method, &mut journal).unwrap();
        assert_eq!(journal.steps().len(), 3);
        let mut structure = after.topology().clone();
        structure.undo(&mut journal, 0);
        assert_eq!(&structure, s.topology());
    }
}

#[test]
fn removed_records_are_used_again() {
    let mut s = polygon(&[(0, 0), (9, 0), (9, 5), (5, 2), (0, 5)]);
    let first = s.triangulate_face(F1, TriangulationMethod::Ears).unwrap();
    for edge in first.diagonals {
        s.remove_edge(edge).unwrap();
    }
    assert_eq!((s.edge_count(), s.face_count()), (5, 2));
    let face = s.faces().nth(1).unwrap();
    let again = s.triangulate_face(face, TriangulationMethod::Monotone).unwrap();
    assert_eq!((s.edge_bound(), s.face_bound(), again.diagonals.len()), (7, 4, 2));
    assert_eq!(dcel_kit::topology::violations(&s), []);
}

#[test]
fn monotone_pieces_run_to_the_right_and_back_once() {
    for shape in [comb(6, 9), spiral(4), star(7), turned(&comb(5, 4), 1), turned(&spiral(3), 4)] {
        let before = polygon(&shape);
        let mut s = before.clone();
        let added = s.split_into_monotone(F1).unwrap();
        assert_eq!((dcel_kit::topology::violations(&s), s.geometry_violations()), (vec![], vec![]));
        assert_eq!(added.new_faces.len(), added.diagonals.len());
        let splits_and_merges = (0..shape.len()).filter(|&i| {
            let at = |i: usize| before.point(VertexId::new((i % shape.len()) as u32));
            let [u, v, w] = [at(i + shape.len() - 1), at(i), at(i + 1)];
            let order = |p: Point| (p.x, p.y);
            let turns = dcel_kit::plane::predicates::orientation(u, v, w);
            let left = before.face(before.half_edges().next().unwrap()) == F1;
            (order(u) < order(v)) == (order(w) < order(v)) && if left { turns.is_lt() } else { turns.is_gt() }
        });
        let needed = splits_and_merges.count();
        assert!(added.diagonals.len() <= needed && 2 * added.diagonals.len() >= needed, "{needed}");
        for f in s.faces().skip(1) {
            let x: Vec<(f64, f64)> = s.incident_vertices(f).map(|v| (s.point(v).x, s.point(v).y)).collect();
            let turns = (0..x.len()).filter(|&i| {
                let (a, b, c) = (x[i], x[(i + 1) % x.len()], x[(i + 2) % x.len()]);
                (a < b) != (b < c)
            });
            assert_eq!(turns.count(), 2, "{f}");
        }
    }
}

/// A face that runs to the right and back just once needs no sorting and no sweep; with another face beside it, it gets both.
#[test]
fn a_monotone_face_is_cut_the_same_with_and_without_the_sweep() {
    let mut random = Random(19);
    let mut stood_above = 0;
    for round in 0..300 {
        // Rows in order from left to right and upwards, on a lattice far enough apart.
        let mut row = |least: usize| {
            let mut row: Vec<(i32, i32)> =
                (0..random.below(12)).map(|_| (1 + random.below(8) as i32, (least + random.below(6)) as i32)).collect();
            row.sort_unstable();
            row.dedup();
            row
        };
        let (lower, mut upper) = (row(0), row(10));
        let same_x = |row: &[(i32, i32)]| row.windows(2).filter(|pair| pair[0].0 == pair[1].0).count();
        stood_above += same_x(&lower) + same_x(&upper);
        upper.reverse();
        let mut corners = [vec![(0, 8)], lower, vec![(9, 8)], upper].concat();
        if corners.len() < 4 {
            continue;
        }
        let turn = random.below(corners.len());
        corners.rotate_left(turn);
        let points = |offset: i32| corners.iter().map(move |&(x, y)| Point::new(f64::from(x + offset), f64::from(y)));
        let n = corners.len() as u32;
        let ring = |first: u32| (0..n).map(move |i| [first + i, first + (i + 1) % n]);
        let alone: Vec<Point> = points(0).collect();
        let both: Vec<Point> = points(0).chain(points(100)).collect();
        let mut alone = Subdivision::from_graph(&alone, &ring(0).collect::<Vec<_>>()).unwrap();
        let mut both = Subdivision::from_graph(&both, &ring(0).chain(ring(n)).collect::<Vec<_>>()).unwrap();
        let (mut seen, mut seen_with) = (Vec::new(), Vec::new());
        alone.triangulate_monotone_observed(&mut seen).unwrap();
        both.triangulate_monotone_observed(&mut seen_with).unwrap();
        let is_own = |event: &MonotoneEvent| match event {
            MonotoneEvent::Corner { at, .. } | MonotoneEvent::Diagonal { from: at, .. } => at.number() < n,
            MonotoneEvent::Cut(corners) => corners[0].number() < n,
        };
        seen_with.retain(is_own);
        assert_eq!(seen, seen_with, "round {round}: {corners:?}");
        assert_eq!(alone.face_count(), n as usize - 1, "round {round}: {corners:?}");
    }
    assert!(stood_above > 300, "{stood_above}");
}
