//! Promise: what an arrangement tells of its points and segments is what one finds by looking at all of them.

use crate::numbers::Numbers;
use dcel_kit::VertexId;
use dcel_kit::plane::{ArrangeOptions, Point, Subdivision};
use std::collections::BTreeMap;

const SPLIT: ArrangeOptions = ArrangeOptions { merge: true, split: true, grid: None, most_faults: 100 };

/// By all points of the input and all vertices: which points a grid moves, how far, and where to.
#[test]
fn a_grid_tells_of_each_point_that_it_moves_and_of_no_other() {
    let (mut moved, mut stay, mut together) = (0, 0, 0);
    for seed in 0..300 {
        let mut next = Numbers::new(seed + 90_000);
        let size = 2f64.powi(next.below(3) as i32 - 1);
        let quarter = |next: &mut Numbers| next.below(48) as f64 / 8.0 - 3.0;
        let mut points: Vec<Point> = (0..24).map(|_| Point::new(quarter(&mut next), quarter(&mut next))).collect();
        points.push(points[0]);
        let ends = |next: &mut Numbers| next.below(20) as u32;
        let segments: Vec<[u32; 2]> = (0..12).map(|_| [ends(&mut next), ends(&mut next)]).collect();
        let options = ArrangeOptions { grid: Some(size), ..SPLIT };
        let arranged = Subdivision::arrange_graph(&points, &segments, &options).unwrap();
        let s = &arranged.subdivision;
        let mut farthest = vec![0.0_f64; s.vertex_bound()];
        let mut places: Vec<Point> = Vec::new();
        for (&p, &v) in points.iter().zip(&arranged.vertices) {
            let q = s.point(v);
            // The square round a grid point has its left and its lower side.
            for (from, to) in [(p.x, q.x), (p.y, q.y)] {
                assert!(
                    (to / size).fract() == 0.0 && from - to >= -0.5 * size && from - to < 0.5 * size,
                    "seed {seed}"
                );
            }
            farthest[v.index()] = farthest[v.index()].max((q.x - p.x).hypot(q.y - p.y));
            together += usize::from(p != q && arranged.vertices.iter().filter(|&&w| w == v).count() > 1);
            if p != q && !places.contains(&p) {
                places.push(p);
            }
        }
        let told: Vec<(VertexId, f64)> =
            s.vertices().map(|v| (v, farthest[v.index()])).filter(|told| told.1 > 0.0).collect();
        assert_eq!(arranged.displaced, told, "seed {seed}");
        assert_eq!(arranged.displaced_points, places.len(), "seed {seed}");
        let collapsed = |i: &u32| {
            let [a, b] = segments[*i as usize].map(|p| p as usize);
            points[a] != points[b] && arranged.vertices[a] == arranged.vertices[b]
        };
        let expected: Vec<u32> = (0..segments.len() as u32).filter(collapsed).collect();
        assert_eq!(arranged.collapsed, expected, "seed {seed}");
        moved += places.len();
        stay += points.len() - places.len();
    }
    assert!(moved > 1_000 && stay > 100 && together > 300, "{moved} {stay} {together}");
}

/// All pairs of segments and all edges of their chains.
#[test]
fn the_first_shared_edge_is_the_first_in_the_order_of_the_segments() {
    let (mut shared, mut repeated, mut apart) = (0, 0, 0);
    for seed in 0..600 {
        let mut next = Numbers::new(seed + 120_000);
        let size = 3 + seed % 9;
        let mut place = || Point::new(next.below(size) as f64, next.below(3) as f64);
        let mut segments: Vec<[Point; 2]> = (0..3 + seed % 3).map(|_| [place(), place()]).collect();
        if seed % 2 == 0 {
            segments.insert(1, [segments[0][1], segments[0][0]]);
            segments.push(segments[2]);
        }
        let arranged = Subdivision::arrange_segments(&segments, &SPLIT).unwrap();
        // Of equal segments only the first one counts; in it and those before, the edges that come first.
        let same = |i: usize, j: usize| segments[i] == segments[j] || segments[i] == [segments[j][1], segments[j][0]];
        let counts = |i: &usize| segments[*i][0] != segments[*i][1] && (0..*i).all(|j| !same(*i, j));
        let list: Vec<usize> = (0..segments.len()).filter(counts).collect();
        let edges = |i: usize| arranged.chain(i).iter().map(|h| h.edge());
        let mut expected = None;
        for (place, &i) in list.iter().enumerate() {
            for e in edges(i) {
                let earlier = list[..place].iter().find(|&&j| edges(j).any(|other| other == e));
                expected = expected.or(earlier.map(|&j| (e, [j as u32, i as u32])));
            }
        }
        assert_eq!(arranged.first_shared_edge(), expected, "seed {seed}: {segments:?}");
        shared += u32::from(expected.is_some());
        apart += u32::from(expected.is_none());
        repeated += arranged.repeated.len();
    }
    assert!(shared > 50 && apart > 50 && repeated > 300, "{shared} {apart} {repeated}");
}

/// Ends on the grid stay where they are: something moves if a chain leaves its segment, and not otherwise.
#[test]
fn a_grid_moves_nothing_where_all_crossings_lie_on_it() {
    let mut counts = [0; 2];
    for seed in 0..600 {
        let mut next = Numbers::new(seed + 150_000);
        let mut place = || Point::new(2.0 * next.below(4) as f64, 2.0 * next.below(4) as f64);
        let segments: Vec<[Point; 2]> = (0..2 + seed % 2).map(|_| [place(), place()]).collect();
        let options = ArrangeOptions { grid: Some(1.0), ..SPLIT };
        let arranged = Subdivision::arrange_segments(&segments, &options).unwrap();
        let s = &arranged.subdivision;
        let leaves = segments.iter().enumerate().any(|(i, [a, b])| {
            let mut corners = arranged.chain(i).iter().map(|&h| s.point(s.origin(h)));
            corners.any(|p| (b.x - a.x) * (p.y - a.y) != (b.y - a.y) * (p.x - a.x))
        });
        assert_eq!(arranged.farthest > 0.0, leaves, "seed {seed}: {segments:?}");
        assert_eq!((arranged.displaced.len(), arranged.displaced_points), (0, 0), "seed {seed}");
        assert!(arranged.moved.iter().all(|moved| moved.1 <= arranged.farthest), "seed {seed}");
        assert!(leaves || arranged.moved.is_empty(), "seed {seed}");
        counts[usize::from(leaves)] += usize::from(!arranged.crossings.is_empty());
    }
    assert!(counts[0] > 20 && counts[1] > 50, "{counts:?}");
}

/// By all pairs of segments: which vertices stand for crossings, and how far the farthest of these is.
#[test]
fn a_grid_tells_how_far_each_vertex_is_from_its_farthest_crossing() {
    let size = 0.5;
    let (mut alone, mut shared) = (0, 0);
    for seed in 0..200 {
        let mut next = Numbers::new(seed + 70_000);
        let mut place = || Point::new(8.0 * next.unit(), 8.0 * next.unit());
        let segments: Vec<[Point; 2]> = (0..24).map(|_| [place(), place()]).collect();
        let mut expected: BTreeMap<[i64; 2], (f64, u32)> = BTreeMap::new();
        for (i, [a, b]) in segments.iter().enumerate() {
            for [c, d] in &segments[..i] {
                let cross = |p: [f64; 2], q: [f64; 2]| p[0] * q[1] - p[1] * q[0];
                let (along, across) = ([b.x - a.x, b.y - a.y], [d.x - c.x, d.y - c.y]);
                let between = [c.x - a.x, c.y - a.y];
                let shares = [across, along].map(|v| cross(between, v) / cross(along, across));
                if shares.iter().all(|share| (0.0..1.0).contains(share)) {
                    let crossing = [a.x + shares[0] * along[0], a.y + shares[0] * along[1]];
                    let pixel = crossing.map(|x| (x / size + 0.5).floor());
                    let off = (pixel[0] * size - crossing[0]).hypot(pixel[1] * size - crossing[1]);
                    let entry = expected.entry(pixel.map(|x| x as i64)).or_default();
                    *entry = (entry.0.max(off), entry.1 + 1);
                }
            }
        }
        let arranged = Subdivision::arrange_segments(&segments, &ArrangeOptions { grid: Some(size), ..SPLIT }).unwrap();
        let told: BTreeMap<[i64; 2], f64> = arranged
            .moved
            .iter()
            .map(|&(v, off)| (arranged.subdivision.point(v), off))
            .map(|(p, off)| ([p.x, p.y].map(|x| (x / size) as i64), off))
            .collect();
        assert!(told.keys().eq(expected.keys()), "seed {seed}: {told:?}, expected {expected:?}");
        for (off, &(farthest, crossings)) in told.values().zip(expected.values()) {
            assert!((off - farthest).abs() < 1e-9, "seed {seed}: {off}, expected {farthest}");
            *if crossings == 1 { &mut alone } else { &mut shared } += 1;
        }
    }
    assert!(alone > 2_000 && shared > 2_000, "{alone}, {shared}");
}
