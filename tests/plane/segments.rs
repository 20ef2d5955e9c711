//! Promise: segments give exactly the subdivision they cut the plane into, whatever their order and direction; what
//! meets elsewhere than at common ends is named completely, or split so that nothing meets any more.

use crate::tracer::{Numbers, assert_traced};
use dcel_kit::plane::{ArrangeOptions, Arranged, CoordinateError, Point, SegmentFault, SegmentsError, Subdivision};
use dcel_kit::topology::{InnerComponent, violations};
use dcel_kit::{EdgeId, FaceId, HalfEdgeId, VertexId};
use std::collections::BTreeSet;

type Segment = [Point; 2];

fn segment(x0: f64, y0: f64, x1: f64, y1: f64) -> Segment {
    [Point::new(x0, y0), Point::new(x1, y1)]
}

fn polygon(corners: &[(f64, f64)]) -> Vec<Segment> {
    let next = corners.iter().cycle().skip(1);
    corners.iter().zip(next).map(|(&a, &b)| [a.into(), b.into()]).collect()
}

fn square(x: f64, y: f64, r: f64) -> Vec<Segment> {
    polygon(&[(x - r, y - r), (x + r, y - r), (x + r, y + r), (x - r, y + r)])
}

const SPLIT: ArrangeOptions = ArrangeOptions { merge: true, split: true, grid: None, most_faults: 100 };

fn faults(segments: &[Segment], most_faults: usize) -> (Vec<SegmentFault>, bool) {
    let options = ArrangeOptions { most_faults, ..ArrangeOptions::default() };
    match Subdivision::arrange_segments(segments, &options) {
        Err(SegmentsError::Faults { faults, more }) => (faults, more),
        other => panic!("faults expected: {other:?}"),
    }
}

fn components(s: &Subdivision) -> usize {
    dcel_kit::topology::components(s).count()
}

fn euler_holds(s: &Subdivision, context: &str) {
    let (v, e, f) = (s.vertex_count() as i64, s.edge_count() as i64, s.face_count() as i64);
    assert_eq!(v - e + f, 1 + components(s) as i64, "{context}: Euler");
    assert_eq!(violations(s), [], "{context}");
}

/// All invariants, the faces of the independent tracer, and Euler.
fn assert_right(s: &Subdivision, context: &str) {
    euler_holds(s, context);
    assert_traced(s, context);
}

// ---- whole numbers, an own opinion on meetings -------------------------------------------------------------

type Whole = (i64, i64);

fn turn(a: Whole, b: Whole, c: Whole) -> i64 {
    ((b.0 - a.0) * (c.1 - a.1) - (b.1 - a.1) * (c.0 - a.0)).signum()
}

fn on(a: Whole, b: Whole, q: Whole) -> bool {
    turn(a, b, q) == 0 && (q.0 - a.0) * (q.0 - b.0) <= 0 && (q.1 - a.1) * (q.1 - b.1) <= 0
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Kind {
    Cross,
    Touch,
    Overlap,
}

/// What is wrong with two segments with different ends.
fn meeting(s: [Whole; 2], t: [Whole; 2]) -> Option<Kind> {
    let ([a, b], [c, d]) = (s, t);
    let turns = [turn(a, b, c), turn(a, b, d), turn(c, d, a), turn(c, d, b)];
    if turns == [0; 4] {
        let ends = |s: [Whole; 2]| [s[0].min(s[1]), s[0].max(s[1])];
        let ([a, b], [c, d]) = (ends(s), ends(t));
        return (a.max(c) < b.min(d)).then_some(Kind::Overlap);
    }
    if turns[0] * turns[1] < 0 && turns[2] * turns[3] < 0 {
        return Some(Kind::Cross);
    }
    let inside = |a, b, q| on(a, b, q) && q != a && q != b;
    (inside(a, b, c) || inside(a, b, d) || inside(c, d, a) || inside(c, d, b)).then_some(Kind::Touch)
}

fn to_segment(s: [Whole; 2], shift: i64) -> Segment {
    s.map(|(x, y)| Point::new((x + shift) as f64, (y + shift) as f64))
}

fn random_segments(numbers: &mut Numbers, count: usize, size: usize) -> Vec<[Whole; 2]> {
    let mut segments: Vec<[Whole; 2]> = Vec::new();
    while segments.len() < count {
        let [a, b] = [(); 2].map(|()| (numbers.below(size) as i64, numbers.below(size) as i64));
        if a != b && !segments.iter().any(|s| *s == [a, b] || *s == [b, a]) {
            segments.push([a, b]);
        }
    }
    segments
}

/// Segments of which no two meet but at common ends: outlines of squares, then single segments, long and short.
fn random_plane_graph(numbers: &mut Numbers, tries: usize, size: usize) -> Vec<[Whole; 2]> {
    let mut kept: Vec<[Whole; 2]> = Vec::new();
    let fits = |kept: &[[Whole; 2]], s: [Whole; 2]| {
        kept.iter().all(|&t| meeting(s, t).is_none() && t != s && t != [s[1], s[0]])
    };
    for _ in 0..tries {
        let (x, y) = (numbers.below(size) as i64, numbers.below(size) as i64);
        let r = 1 + numbers.below(size / 2 + 1) as i64;
        let corners = [(x - r, y - r), (x + r, y - r), (x + r, y + r), (x - r, y + r)];
        let sides: Vec<[Whole; 2]> = (0..4).map(|i| [corners[i], corners[(i + 1) % 4]]).collect();
        let other = match numbers.below(3) {
            0 => (x + numbers.below(3) as i64 - 1, y + numbers.below(3) as i64 - 1),
            _ => (numbers.below(size) as i64, numbers.below(size) as i64),
        };
        if numbers.below(2) == 0 && sides.iter().all(|&s| fits(&kept, s)) {
            kept.extend(sides);
        } else if other != (x, y) && fits(&kept, [(x, y), other]) {
            kept.push([(x, y), other]);
        }
    }
    kept
}

#[test]
fn random_plane_graphs_are_what_the_tracer_finds() {
    let mut with_rings = 0;
    for seed in 1..400 {
        let mut numbers = Numbers::new(seed);
        let size = 4 + numbers.below(20);
        let tries = 5 + numbers.below(50);
        let graph = random_plane_graph(&mut numbers, tries, size);
        let segments: Vec<Segment> = graph.iter().map(|&s| to_segment(s, 0)).collect();
        let s = Subdivision::from_segments(&segments).unwrap_or_else(|e| panic!("seed {seed}: {e}"));
        assert_right(&s, &format!("seed {seed}"));
        for (i, &[a, b]) in segments.iter().enumerate() {
            let h = HalfEdgeId::new(2 * i as u32);
            assert_eq!([s.point(s.origin(h)), s.point(s.destination(h))], [a, b], "seed {seed}: segment {i}");
        }
        with_rings += usize::from(s.faces().any(|f| f != s.outer_face() && !s.inner_components(f).is_empty()));
    }
    assert!(with_rings > 40, "only {with_rings} with rings in bounded faces");
}

#[test]
fn order_direction_and_rotation_of_the_list_change_names_only() {
    for seed in 1..120 {
        let mut numbers = Numbers::new(seed);
        let graph = random_plane_graph(&mut numbers, 30, 9);
        let segments: Vec<Segment> = graph.iter().map(|&s| to_segment(s, 0)).collect();
        let first = Subdivision::from_segments(&segments).unwrap();
        let mut variants = [segments.clone(), segments.clone(), segments.clone()];
        variants[0].rotate_left(1 + numbers.below(segments.len()));
        variants[1].iter_mut().for_each(|s| s.swap(0, 1));
        for i in (1..segments.len()).rev() {
            variants[2].swap(i, numbers.below(i + 1));
        }
        for (i, variant) in variants.iter().enumerate() {
            let s = Subdivision::from_segments(variant).unwrap();
            let key = |s: &Subdivision| crate::tracer::faces_of(s);
            let by_place = |s: &Subdivision| -> BTreeSet<String> {
                let name = |v: u32| s.point(VertexId::new(v)).to_string();
                let (outer, faces) = key(s);
                let show = |f: &crate::tracer::Face| {
                    let cycles: BTreeSet<Vec<String>> = f
                        .iter()
                        .map(|c| {
                            let names: Vec<String> = c.iter().map(|&v| name(v)).collect();
                            (0..names.len()).map(|i| [&names[i..], &names[..i]].concat()).min().unwrap()
                        })
                        .collect();
                    format!("{cycles:?}")
                };
                faces.keys().map(show).chain([format!("outer {}", show(&outer))]).collect()
            };
            assert_eq!(by_place(&s), by_place(&first), "seed {seed}, variant {i}");
        }
    }
}

#[test]
fn numbers_are_as_documented() {
    // A square with a dangling edge inside and a triangle in it, a lone edge outside.
    let mut segments = square(0., 0., 8.);
    segments.push(segment(-8., -8., -6., -6.));
    segments.extend(polygon(&[(0., 0.), (2., 0.), (0., 2.)]));
    segments.push(segment(20., 0., 20., 5.));
    let s = Subdivision::from_segments(&segments).unwrap();
    assert_right(&s, "numbers");
    let h = HalfEdgeId::new;
    assert_eq!((s.vertex_count(), s.edge_count(), s.face_count()), (10, 9, 3));
    assert_eq!((s.half_edge(FaceId::new(1)), s.half_edge(FaceId::new(2))), (Some(h(0)), Some(h(10))));
    assert_eq!(s.inner_components(FaceId::new(1)), [InnerComponent::Cycle(h(11))]);
    assert_eq!(
        (s.half_edge(FaceId::new(0)), s.inner_components(FaceId::new(0))),
        (Some(h(1)), &[InnerComponent::Cycle(h(16))][..])
    );
    // v0 = (-8, -8): to the right, along the dangling edge, upwards.
    let star: Vec<_> = s.outgoing_half_edges(VertexId::new(0)).collect();
    assert_eq!(star, [h(0), h(8), h(7)]);
    let residues = s.dangles_and_cut_edges();
    assert_eq!((residues.dangles, residues.cut_edges), (vec![EdgeId::new(4), EdgeId::new(8)], vec![]));
    let empty = Subdivision::from_segments(&[]).unwrap();
    assert_eq!(empty, Subdivision::new());
}

#[test]
fn a_graph_keeps_its_numbers_and_its_isolated_points() {
    let points: Vec<Point> = [(0., 0.), (9., 9.), (6., 0.), (2., 1.), (0., 6.), (-1., 3.)].map(Point::from).to_vec();
    let s = Subdivision::from_graph(&points, &[[0, 2], [2, 4], [4, 0]]).unwrap();
    assert_right(&s, "graph");
    assert_eq!(s.vertices().map(|v| s.point(v)).collect::<Vec<_>>(), points);
    assert_eq!(s.inner_components(FaceId::new(1)), [InnerComponent::Isolated(VertexId::new(3))]);
    let outer = [1, 5].map(|v| InnerComponent::Isolated(VertexId::new(v)));
    assert_eq!(s.inner_components(FaceId::new(0)), outer);
    let only_points = Subdivision::from_graph(&points, &[]).unwrap();
    assert_right(&only_points, "points");
    assert_eq!((only_points.face_count(), only_points.inner_components(FaceId::new(0)).len()), (1, 6));
}

#[test]
fn each_fault_has_its_name() {
    let p = Point::new;
    let one = |list: &[Segment]| {
        let (found, more) = faults(list, 100);
        assert!(!more);
        found
    };
    assert_eq!(
        one(&[segment(0., 0., 1., 0.), segment(3., 4., 3., 4.), segment(-0.0, 9., 0.0, 9.)]),
        [
            SegmentFault::ZeroLength { segment: 1, at: p(3., 4.) },
            SegmentFault::ZeroLength { segment: 2, at: p(0., 9.) }
        ]
    );
    assert_eq!(
        one(&[segment(0., 0., 1., 0.), segment(5., 5., 6., 6.), segment(1., 0., 0., 0.)]),
        [SegmentFault::Repeated { first: 0, second: 2 }]
    );
    assert_eq!(
        one(&[segment(9., 9., 9., 9.), segment(0., 0., 4., 0.), segment(2., 0., 2., 5.)]),
        [
            SegmentFault::ZeroLength { segment: 0, at: p(9., 9.) },
            SegmentFault::Touching { segment: 2, at: p(2., 0.), on: 1 }
        ]
    );
    assert_eq!(
        one(&[segment(0., 0., 3., 3.), segment(4., 4., 1., 1.)]),
        [SegmentFault::Overlapping { first: 0, second: 1, from: p(1., 1.), to: p(3., 3.) }]
    );
    assert_eq!(
        one(&[segment(0., 0., 3., 0.), segment(0., 0., 5., 0.)]),
        [SegmentFault::Overlapping { first: 0, second: 1, from: p(0., 0.), to: p(3., 0.) }]
    );
    assert_eq!(
        one(&[segment(0., 0., 9., 0.), segment(6., 0., 2., 0.)]),
        [SegmentFault::Overlapping { first: 0, second: 1, from: p(2., 0.), to: p(6., 0.) }]
    );
    // Three through one point that is no vertex: three pairs.
    let star = [segment(-3., -3., 3., 3.), segment(-3., 3., 3., -3.), segment(0., 5., 0., -5.)];
    let pair = |first, second| SegmentFault::Crossing { first, second, at: p(0., 0.) };
    assert_eq!(one(&star), [pair(0, 1), pair(0, 2), pair(1, 2)]);
    // ... and where a fourth ends: it touches each of them.
    let with_end = [&star[..], &[segment(0., 0., 9., 1.)]].concat();
    let found: BTreeSet<String> = one(&with_end).iter().map(ToString::to_string).collect();
    assert_eq!(found.len(), 6, "{found:?}");
    assert!(found.contains("segment 3 ends at (0, 0) in the interior of segment 2"), "{found:?}");

    let graph = |points: &[(f64, f64)], segments: &[[u32; 2]]| {
        let points: Vec<Point> = points.iter().map(|&p| p.into()).collect();
        Subdivision::from_graph(&points, segments).unwrap_err()
    };
    let SegmentsError::Faults { faults, .. } = graph(&[(0., 0.), (4., 0.), (1., 0.)], &[[0, 1]]) else { panic!() };
    assert_eq!(faults, [SegmentFault::PointOnSegment { point: 2, at: p(1., 0.), on: 0 }]);
    let SegmentsError::Faults { faults, .. } = graph(&[(0., 0.), (4., 0.), (4., 0.)], &[[0, 1]]) else { panic!() };
    assert_eq!(faults, [SegmentFault::SamePlace { first: 1, second: 2, at: p(4., 0.) }]);
    let missing = SegmentsError::NoSuchPoint { segment: 1, point: 2, points: 2 };
    assert_eq!(graph(&[(0., 0.), (1., 0.)], &[[0, 1], [1, 2]]), missing);
    let error = Subdivision::from_segments(&[segment(0., 0., f64::NAN, 1.)]).unwrap_err();
    assert!(
        matches!(error, SegmentsError::Coordinate { point: 1, error: CoordinateError::NotFinite { axis: 'x', .. } }),
        "{error:?}"
    );
}

#[test]
fn all_meetings_are_named_and_no_other() {
    let mut kinds = [0; 3];
    for seed in 1..600 {
        let mut numbers = Numbers::new(seed);
        let size = 3 + numbers.below(14);
        let count = (2 + numbers.below(12)).min(size * (size - 1) / 2);
        let list = random_segments(&mut numbers, count, size);
        let mut expected: BTreeSet<(Kind, usize, usize)> = BTreeSet::new();
        for j in 0..list.len() {
            for i in 0..j {
                if let Some(kind) = meeting(list[i], list[j]) {
                    expected.insert((kind, i, j));
                    kinds[kind as usize] += 1;
                }
            }
        }
        let segments: Vec<Segment> = list.iter().map(|&s| to_segment(s, 0)).collect();
        let result = Subdivision::arrange_segments(
            &segments,
            &ArrangeOptions { most_faults: 9999, ..ArrangeOptions::default() },
        );
        let found = match result {
            Ok(_) => Vec::new(),
            Err(SegmentsError::Faults { faults, more: false }) => faults,
            Err(other) => panic!("seed {seed}: {other}"),
        };
        let mut named: BTreeSet<(Kind, usize, usize)> = BTreeSet::new();
        for fault in &found {
            let (kind, i, j) = match *fault {
                SegmentFault::Crossing { first, second, at } => {
                    let ends = |i: u32| segments[i as usize].contains(&at);
                    assert!(!ends(first) && !ends(second), "seed {seed}: {fault}");
                    (Kind::Cross, first, second)
                }
                SegmentFault::Overlapping { first, second, .. } => (Kind::Overlap, first, second),
                SegmentFault::Touching { segment, at, on } => {
                    assert!(segments[segment as usize].contains(&at), "seed {seed}: {fault}");
                    assert!(!segments[on as usize].contains(&at), "seed {seed}: {fault}");
                    (Kind::Touch, segment, on)
                }
                other => panic!("seed {seed}: {other}"),
            };
            assert!(named.insert((kind, i.min(j) as usize, i.max(j) as usize)), "seed {seed}: twice {fault}");
        }
        assert_eq!(named, expected, "seed {seed}: {segments:?}");
    }
    assert!(kinds[0] > 3000 && kinds[1] > 500 && kinds[2] > 50, "{kinds:?}");
}

#[test]
fn the_number_of_faults_named_is_limited() {
    let comb: Vec<Segment> = (0..40)
        .map(|i| segment(f64::from(i), 0., f64::from(i), 9.))
        .chain((0..40).map(|i| segment(-1., 0.1 * f64::from(i) + 1., 50., 0.1 * f64::from(i) + 1.)))
        .collect();
    assert_eq!(faults(&comb, 1600).0.len(), 1600);
    assert!(!faults(&comb, 1600).1);
    let (found, more) = faults(&comb, 7);
    assert_eq!((found.len(), more), (7, true));
    assert_eq!(faults(&comb, 0).0.len(), 1);
    let text = Subdivision::from_segments(&comb).unwrap_err().to_string();
    assert_eq!(text, "segments 0 and 40 cross at (0, 1) (the first of more than 100 faults)");
    // 10^5 segments through one point: not all pairs are made.
    let n = 100_000;
    let fan: Vec<Segment> = (0..n)
        .map(|i| {
            let (x, y) = (1e6, f64::from(i));
            segment(-x, -y, x, y)
        })
        .collect();
    assert_eq!(faults(&fan, 10).0.len(), 10);
}

fn check_split(arranged: &Arranged, given: &[Segment], context: &str) {
    let s = &arranged.subdivision;
    euler_holds(s, context);
    assert_eq!(s.geometry_violations(), [], "{context}");
    let mut used = vec![false; s.edge_bound()];
    for (i, &[a, b]) in given.iter().enumerate() {
        let chain = arranged.chain(i);
        if a == b {
            assert!(chain.is_empty(), "{context}");
            continue;
        }
        let (first, last) = (chain[0], chain[chain.len() - 1]);
        let ends = [s.origin(first), s.destination(last)];
        for (v, p) in ends.into_iter().zip([a, b]) {
            let off = (s.point(v).x - p.x).hypot(s.point(v).y - p.y);
            let told = arranged.displaced.iter().find(|moved| moved.0 == v).map_or(0.0, |moved| moved.1);
            assert!(off <= told, "{context}: {v}, an end of {i}, moved by {off:e}, not {told:e}");
        }
        for pair in chain.windows(2) {
            assert_eq!(s.destination(pair[0]), s.origin(pair[1]), "{context}: chain {i}");
        }
        chain.iter().for_each(|h| used[h.edge().index()] = true);
    }
    assert!(used.iter().all(|&used| used), "{context}: an edge that comes from no segment");
}

#[test]
fn splitting_gives_the_subdivision_of_all_the_pieces() {
    // From 4096 on all crossings are rounded to multiples of 2^-40, which the tracer takes as whole numbers.
    let mut made = 0;
    for seed in 1..250 {
        let mut numbers = Numbers::new(seed);
        let size = 3 + numbers.below(30);
        let count = (2 + numbers.below(14)).min(size * (size - 1) / 2);
        let list = random_segments(&mut numbers, count, size);
        let segments: Vec<Segment> = list.iter().map(|&s| to_segment(s, 4096)).collect();
        let context = format!("seed {seed}");
        let arranged = Subdivision::arrange_segments(&segments, &SPLIT).unwrap_or_else(|e| panic!("{context}: {e}"));
        check_split(&arranged, &segments, &context);
        assert_traced(&arranged.subdivision, &context);
        // The crossings, in quotients.
        let mut expected: BTreeSet<(i128, i128, i128)> = BTreeSet::new();
        for (i, &s) in list.iter().enumerate() {
            for &t in &list[..i] {
                if meeting(s, t) == Some(Kind::Cross) {
                    expected.insert(quotient(s, t));
                }
            }
        }
        let ends: BTreeSet<Whole> = list.iter().flatten().copied().collect();
        let at_ends = |q: &(i128, i128, i128)| {
            ends.contains(&((q.0 / q.2) as i64, (q.1 / q.2) as i64)) && q.0 % q.2 == 0 && q.1 % q.2 == 0
        };
        expected.retain(|q| !at_ends(q));
        assert_eq!(arranged.crossings.len(), expected.len(), "{context}");
        for &(v, off) in &arranged.moved {
            assert!(off > 0.0 && off < 2f64.powi(-40), "{context}: {v} moved by {off}");
        }
        let exact = expected.iter().filter(|q| q.0 % q.2 == 0 && q.1 % q.2 == 0).count();
        assert!(arranged.crossings.len() - arranged.moved.len() >= exact, "{context}");
        made += expected.len();
    }
    assert!(made > 1500, "{made}");
}

/// The crossing as x / w and y / w in lowest terms, w positive.
fn quotient([a, b]: [Whole; 2], [c, d]: [Whole; 2]) -> (i128, i128, i128) {
    let wide = |p: Whole, q: Whole| (i128::from(q.0 - p.0), i128::from(q.1 - p.1));
    let (u, v, r) = (wide(a, b), wide(c, d), wide(a, c));
    let (w, t) = (u.0 * v.1 - u.1 * v.0, r.0 * v.1 - r.1 * v.0);
    let (x, y) = (i128::from(a.0) * w + t * u.0, i128::from(a.1) * w + t * u.1);
    fn gcd(a: i128, b: i128) -> i128 {
        if b == 0 { a.abs() } else { gcd(b, a % b) }
    }
    let g = gcd(gcd(x, y), w) * w.signum();
    (x / g, y / g, w / g)
}

#[test]
fn merging_leaves_out_what_is_there_already_and_says_so() {
    let mut list = square(0., 0., 4.);
    list.push(segment(9., 9., 9., 9.));
    list.push(segment(4., -4., -4., -4.));
    list.push(segment(0., 0., 1., 1.));
    list.push(segment(0., 0., 1., 1.));
    let options = ArrangeOptions { merge: true, ..ArrangeOptions::default() };
    let arranged = Subdivision::arrange_segments(&list, &options).unwrap();
    assert_eq!((arranged.zero_length.clone(), arranged.repeated.clone()), (vec![4], vec![(5, 0), (7, 6)]));
    assert_eq!((arranged.subdivision.edge_count(), arranged.subdivision.vertex_count()), (5, 6));
    let h = HalfEdgeId::new;
    assert_eq!((arranged.chain(0), arranged.chain(5), arranged.chain(7)), (&[h(0)][..], &[h(1)][..], &[h(8)][..]));
    check_split(&arranged, &list, "merged");
    // Merging does not split.
    list.push(segment(-9., 0., 9., 0.));
    assert!(Subdivision::arrange_segments(&list, &options).is_err());
    // Points of a graph that are joined.
    let points = [(0., 0.), (1., 0.), (-0., 0.), (1., 1.)].map(Point::from);
    let graph = Subdivision::arrange_graph(&points, &[[0, 1], [2, 3], [0, 2]], &options).unwrap();
    assert_eq!(graph.vertices, [0, 1, 0, 2].map(VertexId::new));
    assert_eq!((graph.zero_length.clone(), graph.subdivision.edge_count()), (vec![2], 2));
}

#[test]
fn no_coordinate_is_minus_zero() {
    let minus = [segment(-0.0, -0.0, 4., -0.0), segment(4., -0.0, 4., 3.), segment(4., 3., 0., 0.)];
    for options in [ArrangeOptions::default(), ArrangeOptions { merge: true, ..ArrangeOptions::default() }, SPLIT] {
        let arranged = Subdivision::arrange_segments(&minus, &options).unwrap();
        let s = arranged.subdivision;
        assert_eq!(s.vertex_count(), 3, "{options:?}");
        for v in s.vertices() {
            let point = s.point(v);
            assert!([point.x, point.y].iter().all(|x| x.to_bits() != (-0.0_f64).to_bits()), "{v}: {options:?}");
        }
    }
}

/// Cuts come from left to right; a segment that runs the other way meets them in the other order, and in one round.
#[test]
fn segments_in_either_direction_are_cut_in_their_order() {
    let across = [3., 6., 7.].map(|x| segment(x, -1., x, 1.));
    for (from, to) in [(9., 0.), (0., 9.)] {
        let list = [&[segment(from, 0., to, 0.)][..], &across].concat();
        let arranged = Subdivision::arrange_segments(&list, &SPLIT).unwrap();
        check_split(&arranged, &list, "either way");
        let s = &arranged.subdivision;
        let mut xs: Vec<f64> = arranged.chain(0).iter().map(|&h| s.point(s.origin(h)).x).collect();
        xs.push(to);
        let wanted = if from < to { [0., 3., 6., 7., 9.] } else { [9., 7., 6., 3., 0.] };
        assert_eq!((&xs[..], arranged.rounds), (&wanted[..], 1));
    }
}

#[test]
fn overlaps_share_their_edges() {
    let list = [segment(0., 0., 6., 0.), segment(8., 0., 2., 0.), segment(4., 0., 4., 3.), segment(0., 0., 8., 0.)];
    let arranged = Subdivision::arrange_segments(&list, &SPLIT).unwrap();
    check_split(&arranged, &list, "overlaps");
    let s = &arranged.subdivision;
    assert_eq!((s.vertex_count(), s.edge_count(), s.face_count()), (6, 5, 1));
    assert_eq!((arranged.chain(0).len(), arranged.chain(1).len(), arranged.chain(3).len()), (3, 3, 4));
    assert_eq!(arranged.chain(1)[0], arranged.chain(3)[3].twin());
    assert!(arranged.crossings.is_empty() && arranged.moved.is_empty());
}

#[test]
fn residues_are_dangles_and_cut_edges() {
    let mut list = square(0., 0., 2.);
    list.extend(square(10., 0., 2.));
    list.push(segment(2., -2., 5., 0.)); // 8: a bridge in two parts, with a tree on it
    list.push(segment(5., 0., 8., -2.)); // 9
    list.push(segment(5., 0., 5., 3.)); // 10
    list.push(segment(5., 3., 4., 4.)); // 11
    list.push(segment(5., 3., 6., 4.)); // 12
    list.push(segment(20., 0., 21., 0.)); // 13
    let residues = Subdivision::from_segments(&list).unwrap().dangles_and_cut_edges();
    let e = |list: &[u32]| list.iter().map(|&i| EdgeId::new(i)).collect::<Vec<_>>();
    assert_eq!((residues.dangles, residues.cut_edges), (e(&[10, 11, 12, 13]), e(&[8, 9])));
}

/// The corner of the unit grid at which orientation in doubles goes wrong: points of distance 2^-53 near 0.5, seen
/// from a line through (12, 12) and (24, 24).
#[test]
fn segments_between_neighbouring_doubles_are_kept_apart() {
    let step = f64::EPSILON / 2.0;
    let at = |i: i32| 0.5 + f64::from(i) * step;
    let mut list = Vec::new();
    for i in 0..12 {
        for j in 0..12 {
            // Right and up to the next points: a grid as fine as doubles are.
            list.push(segment(at(i), at(j), at(i + 1), at(j)));
            list.push(segment(at(i), at(j), at(i), at(j + 1)));
        }
    }
    let s = Subdivision::from_segments(&list).unwrap();
    euler_holds(&s, "grid of neighbours");
    assert_eq!(s.geometry_violations(), []);
    assert_eq!((s.edge_count(), s.face_count()), (2 * 144, 1 + 121));
    // The diagonal runs through twelve of its points exactly; a hair lower it crosses 23 sides between the doubles.
    list.push(segment(0.25, 0.25, 12., 12.));
    let arranged = Subdivision::arrange_segments(&list, &SPLIT).unwrap();
    check_split(&arranged, &list, "diagonal");
    assert_eq!((arranged.crossings.len(), arranged.moved.len(), arranged.chain(288).len()), (0, 0, 13));
    list[288] = segment(0.25, 0.25, 12., 12.0_f64.next_down());
    let SegmentsError::Faults { faults, .. } = Subdivision::from_segments(&list).unwrap_err() else { panic!() };
    assert!(faults.iter().all(|fault| matches!(fault, SegmentFault::Crossing { .. })), "{faults:?}");
    let arranged = Subdivision::arrange_segments(&list, &SPLIT).unwrap();
    check_split(&arranged, &list, "a hair lower");
    assert!(arranged.moved.len() > 9 && arranged.moved.iter().all(|m| m.1 <= step), "{:?}", arranged.moved);
    // Long lines a last bit apart do not cross, or cross by so little that the crossing is an end.
    let sliver = [segment(0., 0., 1e9, 1.0), segment(0., f64::EPSILON, 1e9, 1.0 + f64::EPSILON)];
    assert_eq!(Subdivision::from_segments(&sliver).unwrap().face_count(), 1);
    let thin = [segment(0., 0., 1e9, 1.0), segment(0., 5e-17, 1e9, 1.0 - f64::EPSILON)];
    let arranged = Subdivision::arrange_segments(&thin, &SPLIT).unwrap();
    check_split(&arranged, &thin, "thin");
    assert_eq!(arranged.crossings.len(), 1);
}

#[test]
fn rings_that_touch_are_one_boundary() {
    // A square whose corner touches a side's vertex of a larger one from inside, and two that share a corner.
    let mut list = polygon(&[(0., 0.), (8., 0.), (8., 8.), (0., 8.), (0., 4.)]);
    list.extend(polygon(&[(0., 4.), (2., 2.), (4., 4.), (2., 6.)]));
    list.extend(polygon(&[(4., 4.), (6., 3.), (6., 5.)]));
    list.extend(square(2., 4., 0.5));
    let s = Subdivision::from_segments(&list).unwrap();
    assert_right(&s, "touching");
    assert_eq!(s.face_count(), 5);
    assert_eq!(s.incident_half_edges(FaceId::new(1)).count(), 5 + 4 + 3);
}

#[test]
fn a_star_of_a_hundred_thousand_and_a_spiral() {
    let n = 100_000;
    let star: Vec<Segment> = (0..n)
        .map(|i| {
            let (side, t) = (i % 4, f64::from(i / 4) - 12_500.0);
            let (x, y) = [(12_500.0, t), (-t, 12_500.0), (-12_500.0, -t), (t, -12_500.0)][side as usize];
            if i % 2 == 0 { segment(0., 0., x, y) } else { segment(x, y, 0., 0.) }
        })
        .collect();
    let s = Subdivision::from_segments(&star).unwrap();
    assert_eq!((s.vertex_count(), s.face_count(), s.degree(VertexId::new(0))), (n as usize + 1, 1, n as usize));
    assert_eq!(s.cycle(HalfEdgeId::new(0)).count(), 2 * n as usize);
    assert_eq!(s.dangles_and_cut_edges().dangles.len(), n as usize);
    // Ten thousand squares in each other.
    let nested: Vec<Segment> = (1..=10_000).flat_map(|i| square(0., 0., f64::from(i))).collect();
    let s = Subdivision::from_segments(&nested).unwrap();
    euler_holds(&s, "nested");
    assert_eq!(s.face_count(), 10_001);
    let with_ring = s.faces().filter(|&f| f != s.outer_face() && s.inner_components(f).len() == 1).count();
    assert_eq!(with_ring, 9_999);
}

#[test]
fn splitting_random_doubles_ends_without_any_meeting() {
    for seed in 1..60 {
        let mut numbers = Numbers::new(seed);
        let unit = |numbers: &mut Numbers| numbers.below(1 << 53) as f64 / (1_u64 << 53) as f64;
        let count = 20 + numbers.below(60);
        // Some bundles of nearly equal lines, whose crossings fall on one another.
        let segments: Vec<Segment> = (0..count)
            .map(|_| {
                let mut end = |spread: f64| 0.5 + (unit(&mut numbers) - 0.5) * spread;
                match seed % 3 {
                    0 => segment(end(1.), end(1.), end(1.), end(1.)),
                    1 => segment(0., end(1e-12), 1., end(1e-12)),
                    _ => segment(0., end(1e-15), 1., end(1e-15)),
                }
            })
            .collect();
        let arranged = Subdivision::arrange_segments(&segments, &SPLIT).unwrap_or_else(|e| panic!("seed {seed}: {e}"));
        check_split(&arranged, &segments, &format!("seed {seed}"));
        // Four rounds in place, then one on a grid of 2^-52; of 2^-51 where 1 is a coordinate.
        let worst = arranged.moved.iter().chain(&arranged.displaced).map(|m| m.1).fold(0.0, f64::max);
        let bound = if arranged.grid.is_some() { 0.7072 * f64::EPSILON * 2.0 } else { f64::EPSILON };
        assert!(worst <= bound && arranged.rounds <= 5, "seed {seed}: {worst:e} in {} rounds", arranged.rounds);
        // Splitting again changes nothing.
        let s = &arranged.subdivision;
        let edges: Vec<Segment> = s.edges().map(|e| e.half_edges().map(|h| s.point(s.origin(h)))).collect();
        assert_eq!(Subdivision::from_segments(&edges).unwrap().face_count(), s.face_count());
    }
}

#[test]
fn numbers_at_the_ends_of_the_range_are_taken() {
    use dcel_kit::plane::{LARGEST, SMALLEST};
    let big = square(0., 0., LARGEST);
    let tiny = square(0., 0., SMALLEST);
    let cross = [segment(-LARGEST, -SMALLEST, LARGEST, SMALLEST), segment(-SMALLEST, LARGEST, SMALLEST, -LARGEST)];
    let list = [&big[..], &tiny, &cross].concat();
    let arranged = Subdivision::arrange_segments(&list, &SPLIT).unwrap();
    check_split(&arranged, &list, "ends of the range");
    assert!(arranged.subdivision.vertices().all(|v| arranged.subdivision.point(v).check().is_ok()));
}

#[test]
fn what_lies_in_something_else_is_a_hole_in_turn() {
    // Squares in each other, the largest one first, beside two others.
    let squares = [(0., 5.), (0., 4.), (0., 3.), (0., 2.), (0., 1.), (20., 2.), (20., 1.)];
    let sides: Vec<Segment> = squares.iter().flat_map(|&(x, r)| square(x, 0., r)).collect();
    let mut s = Subdivision::from_segments(&sides).unwrap();
    let marked = s.mark_nested_holes();
    let mut holes = Vec::new();
    for f in s.faces().filter(|&f| f != s.outer_face()) {
        let first = s.half_edge(f).expect("it is bounded");
        let corners: Vec<Point> = s.cycle(first).map(|h| s.point(s.origin(h))).collect();
        let (low, high) = corners.iter().fold((f64::MAX, f64::MIN), |(low, high), p| (p.x.min(low), p.x.max(high)));
        let (middle, r) = ((low + high) / 2., (high - low) / 2.);
        let depth = squares.iter().filter(|&&(x, other)| x == middle && other > r).count();
        assert_eq!(s.is_hole(f), depth % 2 == 1, "{f} of half side {r} about {middle}");
        holes.extend(s.is_hole(f).then_some(f));
    }
    assert_eq!(marked, holes);
    assert_eq!(holes.len(), 3);
}

#[test]
fn as_many_faults_are_told_as_are_asked_for() {
    let o = Point::new(0., 0.);
    let to = |x: i32, y: i32| [o, Point::new(f64::from(x), f64::from(y))];
    let through = |x: i32, y: i32| [Point::new(f64::from(-x), f64::from(-y)), Point::new(f64::from(x), f64::from(y))];
    let cases: [(&str, Vec<Segment>); 7] = [
        ("no length and repeated, nothing else", [vec![to(0, 0); 3], vec![to(1, 2); 4], vec![to(3, 2)]].concat()),
        (
            "no length, repeated, crossing",
            vec![to(0, 0), to(0, 0), through(1, 2), through(1, 2), through(2, 2), through(3, 2), through(4, 2)],
        ),
        ("overlaps from one point", (1..=6).map(|x| to(x, 0)).collect()),
        ("ends on a line", (-4..=4).map(|x| to(x, 5)).chain([through(9, 0)]).collect()),
        ("ends on lines", (-4..=4).map(|x| to(x, 5)).chain((1..4).map(|y| through(9, -y))).collect()),
        ("crossings in one point", (-3..=3).map(|x| through(x, 5)).collect()),
        ("parts of a line", (1..=5).map(|x| to(x, 0)).chain([through(9, 0), through(8, 0)]).collect()),
    ];
    for (name, segments) in cases {
        let (all, more) = faults(&segments, 9999);
        assert!(!more && all.len() > 5, "{name}: {}", all.len());
        for most in 1..=all.len() + 1 {
            let (told, more) = faults(&segments, most);
            assert_eq!((told.len(), more), (most.min(all.len()), most < all.len()), "{name}: {most} of {}", all.len());
            assert!(told.iter().all(|fault| all.contains(fault)), "{name}: {most}");
        }
    }
}

/// Triangles that meet at their ends only, as they are.
#[test]
fn small_faces_go_to_a_grid_as_all_others() {
    let points: Vec<Point> = (0..36).map(|i| Point::new(f64::from(i % 6) * 1.25, f64::from(i / 6))).collect();
    let s = Subdivision::delaunay(&points).unwrap().subdivision;
    let segments: Vec<Segment> = s.edges().map(|e| e.half_edges().map(|h| s.point(s.origin(h)))).collect();
    for (size, displaced) in [(0.25, 0), (1.0, 24)] {
        let rounded = Subdivision::arrange_segments(&segments, &ArrangeOptions { grid: Some(size), ..SPLIT }).unwrap();
        assert_right(&rounded.subdivision, &format!("grid {size}"));
        assert_eq!((rounded.grid, rounded.displaced_points), (Some(size), displaced));
    }
}

#[test]
fn what_stays_in_place_is_not_said_to_have_moved() {
    let at = |x: f64, y: f64| Point::new(x, y);
    let cross = [[at(0., 0.), at(4., 4.)], [at(0., 4.), at(4., 0.)]];
    let whole = Subdivision::arrange_segments(&cross, &SPLIT).unwrap();
    assert_eq!((whole.crossings.len(), whole.moved.len(), whole.farthest), (1, 0, 0.0));
    // Of the ends one does not lie on the grid.
    let grid = ArrangeOptions { grid: Some(1.0), ..SPLIT };
    let segments = [[at(0., 0.), at(4., 4.)], [at(0., 4.), at(4.25, 0.)], [at(9., 9.), at(9., 12.)]];
    let rounded = Subdivision::arrange_segments(&segments, &grid).unwrap();
    assert_eq!((rounded.displaced.len(), rounded.displaced_points), (1, 1));
    assert_eq!(rounded.displaced[0].1, 0.25);
}
