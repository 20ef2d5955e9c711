//! Promise: edges that bound nothing are those that a look at each by itself finds, and hole points mark the faces they are
//! located in, or are refused by what they lie on.

use crate::numbers::Numbers;
use dcel_kit::plane::{ArrangeOptions, Location, MarkHolesError, Point, Subdivision};
use dcel_kit::{EdgeId, FaceId};

/// Few segments of a small grid, split: faces, trees, islands.
fn random(next: &mut Numbers, count: usize, size: u64) -> Subdivision {
    let mut place = || Point::new(next.below(size) as f64, next.below(size) as f64);
    let segments: Vec<[Point; 2]> = (0..count).map(|_| [place(), place()]).collect();
    let options = ArrangeOptions { merge: true, split: true, ..ArrangeOptions::default() };
    Subdivision::arrange_segments(&segments, &options).unwrap().subdivision
}

/// Whether what is connected to one end of an edge without the edge comes to its other end, and whether it has a cycle.
fn without(s: &Subdivision, e: EdgeId, side: usize) -> (bool, bool) {
    let ends = e.half_edges().map(|h| s.origin(h));
    let mut seen = vec![false; s.vertex_bound()];
    let mut open = vec![ends[side]];
    seen[ends[side].index()] = true;
    let (mut vertices, mut half_edges) = (0, 0);
    while let Some(v) = open.pop() {
        vertices += 1;
        for g in s.edges().filter(|&g| g != e) {
            let [a, b] = g.half_edges().map(|h| s.origin(h));
            for (from, to) in [(a, b), (b, a)] {
                half_edges += usize::from(from == v);
                if from == v && !std::mem::replace(&mut seen[to.index()], true) {
                    open.push(to);
                }
            }
        }
    }
    (seen[ends[1 - side].index()], half_edges / 2 >= vertices)
}

#[test]
fn an_edge_without_which_something_falls_apart_is_a_dangle_if_a_part_is_a_tree_and_a_cut_edge_if_none_is() {
    let mut counts = [0; 3];
    for seed in 0..700 {
        let mut next = Numbers::new(seed + 10_000);
        let size = 4 + next.below(8) as u64;
        let count = 2 + next.below(12) as usize;
        let s = random(&mut next, count, size);
        let residues = s.dangles_and_cut_edges();
        let (mut dangles, mut cut_edges) = (Vec::new(), Vec::new());
        for e in s.edges() {
            let [(joined, one), (_, other)] = [without(&s, e, 0), without(&s, e, 1)];
            let [f, g] = e.half_edges().map(|h| s.face(h));
            assert_eq!(f == g, !joined, "seed {seed}: {e}");
            match (joined, one && other) {
                (true, _) => counts[0] += 1,
                (false, true) => cut_edges.push(e),
                (false, false) => dangles.push(e),
            }
        }
        assert_eq!((&residues.dangles, &residues.cut_edges), (&dangles, &cut_edges), "seed {seed}");
        counts = [counts[0], counts[1] + dangles.len(), counts[2] + cut_edges.len()];
    }
    assert!(counts[0] > 1_000 && counts[1] > 1_000 && counts[2] > 30, "{counts:?}");
}

#[test]
fn hole_points_mark_the_faces_they_are_located_in_or_none_at_all() {
    let mut counts = [0; 4];
    for seed in 0..2_000 {
        let mut next = Numbers::new(seed + 20_000);
        let mut s = random(&mut next, 24, 9);
        let mut points: Vec<Point> = Vec::new();
        for _ in 0..1 + next.below(4) {
            // A third of them on the grid, and some twice.
            let off = [2.0, 2.25 + 1.0 / 64.0][next.below(3).min(1) as usize];
            points.push(Point::new(next.below(5) as f64 + off, next.below(5) as f64 + off));
            let again = points[next.below(points.len() as u64) as usize];
            points.extend((next.below(3) == 0).then_some(again));
        }
        if seed % 50 == 0 {
            points.push(Point::new(f64::NAN, 0.0));
        }
        let before = s.clone();
        let at: Vec<Location> = points.iter().filter(|p| !p.x.is_nan()).map(|&p| before.locate(p)).collect();
        match s.mark_holes(&points) {
            Ok(faces) => {
                assert_eq!(faces.iter().map(|&f| Location::Face(f)).collect::<Vec<_>>(), at, "seed {seed}");
                assert!(!faces.contains(&s.outer_face()), "seed {seed}");
                let marked: Vec<FaceId> = s.faces().filter(|&f| s.is_hole(f)).collect();
                let expected: Vec<FaceId> = before.faces().filter(|f| faces.contains(f)).collect();
                assert_eq!(marked, expected, "seed {seed}");
                counts[0] += 1;
                continue;
            }
            Err(MarkHolesError::NotInside { index, point, element }) => {
                let first = points.iter().position(|&p| p == point);
                assert_eq!(first, Some(index as usize), "seed {seed}");
                let on = match at[index as usize] {
                    Location::Vertex(v) => Some(v.into()),
                    Location::Edge(h) => Some(h.edge().into()),
                    Location::Face(_) => None,
                };
                assert_eq!(on, Some(element), "seed {seed}");
                counts[1] += 1;
            }
            Err(MarkHolesError::Outside { index, point }) => {
                let first = at.iter().position(|&at| at == Location::Face(before.outer_face()));
                assert_eq!(first, Some(index as usize), "seed {seed}");
                assert_eq!(point, points[index as usize], "seed {seed}");
                assert!(at.iter().all(|at| matches!(at, Location::Face(_))), "seed {seed}: more than outside");
                counts[2] += 1;
            }
            Err(error) => {
                assert!(matches!(error, MarkHolesError::Coordinate { index, .. } if points[index as usize].x.is_nan()));
                counts[3] += 1;
            }
        }
        assert_eq!(s, before, "seed {seed}: marked, and refused");
    }
    assert!(counts[..3].iter().all(|&count| count > 100) && counts[3] == 40, "{counts:?}");
}
