//! Promise: splitting always settles. No input of segments is refused for being close, nothing crosses afterwards, and
//! no point is further from where it was than the report says. Judged by whole numbers of any size.
//!
//! `SETTLED_BUNDLES=100000 cargo test --release --test plane settled` tries as many bundles as it is told.

use crate::exact::{Whole, meet, unit, whole, within};
use crate::numbers::Numbers;
use dcel_kit::plane::{ArrangeOptions, Arranged, Point, SMALLEST, SegmentFault, SegmentsError, Subdivision};
use dcel_kit::{EdgeId, VertexId};

type Segment = [Point; 2];

const SPLIT: ArrangeOptions = ArrangeOptions { merge: true, split: true, grid: None, most_faults: 100 };

fn arrange(segments: &[Segment], options: &ArrangeOptions, context: &str) -> Arranged {
    Subdivision::arrange_segments(segments, options).unwrap_or_else(|error| panic!("{context}: {error}\n{segments:?}"))
}

/// All pairs of edges; where each vertex and each chain lies. Returns how many vertices of the input moved.
fn assert_settled(arranged: &Arranged, segments: &[Segment], context: &str) -> usize {
    let s = &arranged.subdivision;
    let given = segments.as_flattened().iter();
    let all = given.copied().chain(s.vertices().map(|v| s.point(v))).flat_map(|p| [p.x, p.y]);
    let unit = unit(all.chain([arranged.farthest]).chain(arranged.moved.iter().map(|moved| moved.1)));
    let at: Vec<Whole> = s.vertices().map(|v| Whole::new(s.point(v), unit)).collect();
    let ends: Vec<[&Whole; 2]> = s.edges().map(|e| e.half_edges().map(|h| &at[s.origin(h).index()])).collect();
    for (i, &e) in ends.iter().enumerate() {
        for (j, &g) in ends[..i].iter().enumerate() {
            assert!(!meet(e, g), "{context}: e{j} and e{i} meet\n{segments:?}");
        }
    }
    let mut sorted: Vec<&Whole> = at.iter().collect();
    sorted.sort();
    assert!(sorted.windows(2).all(|pair| pair[0] != pair[1]), "{context}: two vertices at one place");

    let far = whole(arranged.farthest, unit);
    if let Some(grid) = arranged.grid {
        assert!(arranged.farthest <= 0.708 * grid || arranged.rounds > 1, "{context}: {arranged:?}");
    }
    let mut used = vec![false; s.edge_bound()];
    let mut is_near = vec![false; s.vertex_bound()];
    let told_of = |v: VertexId| arranged.moved.iter().find(|moved| moved.0 == v).map_or(0.0, |moved| moved.1);
    for (i, segment) in segments.iter().enumerate() {
        let chain = arranged.chain(i);
        let original = segment.map(|p| Whole::new(p, unit));
        let original = [&original[0], &original[1]];
        if chain.is_empty() {
            let known = arranged.zero_length.contains(&(i as u32)) || arranged.collapsed.contains(&(i as u32));
            assert!(known, "{context}: segment {i} is lost");
            continue;
        }
        let ends = [s.origin(chain[0]), s.destination(chain[chain.len() - 1])];
        for (v, p) in ends.into_iter().zip(*segment) {
            let q = s.point(v);
            let by = (q.x - p.x).hypot(q.y - p.y);
            let told = arranged.displaced.iter().find(|moved| moved.0 == v).map_or(0.0, |moved| moved.1);
            assert!(by <= told && told <= arranged.farthest, "{context}: {v} moved by {by:e}, not {told:e}");
        }
        for pair in chain.windows(2) {
            assert_eq!(s.destination(pair[0]), s.origin(pair[1]), "{context}: chain {i} is torn");
        }
        for &h in chain {
            used[h.edge().index()] = true;
            for v in [s.origin(h), s.destination(h)] {
                assert!(
                    within(original, &at[v.index()], &far),
                    "{context}: {v} is too far from segment {i}: {arranged:?}"
                );
                is_near[v.index()] |= within(original, &at[v.index()], &whole(told_of(v), unit));
            }
        }
    }
    assert!(used.iter().all(|&used| used), "{context}: an edge of no segment");
    for &v in &arranged.crossings {
        assert!(is_near[v.index()], "{context}: {v} moved further than {:e}: {segments:?}", told_of(v));
    }
    arranged.displaced.len()
}

/// So many last places further; from 0 to the smallest coordinates there are.
fn steps(x: f64, count: i64) -> f64 {
    (0..count).fold(x, |x, _| if x == 0.0 { SMALLEST } else { x.next_up() })
}

/// Three to five segments that nearly lie on each other, or run nearly through one point.
fn bundle(next: &mut Numbers) -> Vec<Segment> {
    let tenth = |i: i64| i as f64 * 0.1;
    let count = 3 + next.below(3);
    let offset = [0.0, 0.0, 1e-15, 1e15, -1e15, 1.0][next.below(6) as usize];
    let scale = [1.0, 1.0, 1e-15, 1e15][next.below(4) as usize];
    let kind = next.below(4);
    let mut corner = |size| Point::new(tenth(next.below(size)), tenth(next.below(size)));
    let (a, b, p) = (corner(11), corner(11), corner(5));
    (0..count)
        .map(|_| {
            let mut places = || next.below(6);
            match kind {
                // Lines of the grid.
                0 => [tenth(places()), tenth(places()), tenth(places()), tenth(places())],
                // The same line, its ends a few last places apart.
                1 => [steps(a.x, places()), steps(a.y, places()), steps(b.x, places()), steps(b.y, places())],
                // Through one point, as far as doubles can tell.
                2 => {
                    let (dx, dy) = (tenth(places()) - 0.2, tenth(places()) - 0.3);
                    [p.x - dx, p.y - dy, p.x + 3.0 * dx, p.y + 3.0 * dy]
                }
                // The same line through other points of it.
                _ => {
                    let (s, t) = (tenth(places()), tenth(5 + places()));
                    let at = |t: f64| [a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)];
                    let ([x0, y0], [x1, y1]) = (at(s), at(t));
                    [steps(x0, places() / 3), y0, x1, steps(y1, places() / 3)]
                }
            }
        })
        .map(|[x0, y0, x1, y1]| {
            let door = |x: f64| if x.abs() < SMALLEST { 0.0 } else { x };
            let put = |x: f64, y: f64| Point::new(door(x * scale + offset), door(y * scale + offset));
            [put(x0, y0), put(x1, y1)]
        })
        .collect()
}

#[test]
fn near_collinear_bundles_always_settle() {
    let tries = std::env::var("SETTLED_BUNDLES").map_or(3000, |count| count.parse().expect("a number"));
    let (mut on_grid, mut moved, mut crossings, mut most_rounds) = (0, 0, 0, 0);
    for seed in 0..tries {
        let segments = bundle(&mut Numbers::new(seed));
        let context = format!("seed {seed}");
        let arranged = arrange(&segments, &SPLIT, &context);
        moved += assert_settled(&arranged, &segments, &context);
        on_grid += u64::from(arranged.grid.is_some());
        crossings += arranged.crossings.len();
        most_rounds = most_rounds.max(arranged.rounds);
        // And on the grid from the beginning.
        if seed % 4 == 0 {
            let reach = segments.as_flattened().iter().map(|p| p.x.abs().max(p.y.abs())).fold(0.0, f64::max);
            let size = (reach * 2f64.powi(-50)).max(2f64.powi(-142)) * 4_f64.powi((seed % 5) as i32);
            let options = ArrangeOptions { grid: Some(size), ..SPLIT };
            let snapped = arrange(&segments, &options, &context);
            assert_settled(&snapped, &segments, &format!("{context} on a grid"));
            let grid = snapped.grid.expect("a grid was asked for");
            assert!(grid <= size && 2.0 * grid > size, "{context}");
            for v in snapped.subdivision.vertices() {
                let p = snapped.subdivision.point(v);
                assert!([p.x, p.y].iter().all(|x| (x / grid).fract() == 0.0), "{context}: {p} is off the grid");
            }
        }
    }
    println!("{tries} bundles: {on_grid} on a grid, {moved} ends moved, {crossings} crossings, {most_rounds} rounds");
    assert!(on_grid * 100 > tries && crossings > 500, "{on_grid} on a grid: an easy test");
}

#[test]
fn larger_bundles_settle_on_coarse_and_fine_grids() {
    let mut collapsed = 0;
    for seed in 0..40 {
        let mut next = Numbers::new(seed + 7000);
        let mut segments: Vec<Segment> = (0..4).flat_map(|_| bundle(&mut next)).collect();
        segments.retain(|s| s.iter().all(|p| p.x.abs().max(p.y.abs()) < 100.0));
        let context = format!("seed {seed}");
        for size in [0.5, 0.05, 1e-3, 2f64.powi(-44)] {
            let arranged = arrange(&segments, &ArrangeOptions { grid: Some(size), ..SPLIT }, &context);
            assert_settled(&arranged, &segments, &format!("{context}, grid {size}"));
            collapsed += arranged.collapsed.len();
        }
    }
    assert!(collapsed > 100, "{collapsed}");
}

/// Random pieces of one line whose ends are rounded to doubles: bent pieces cross more often in every round, so that the
/// rounds are given up before they grow out of hand.
#[test]
fn overlapping_pieces_of_one_line_settle_before_they_grow() {
    let mut next = Numbers::new(77);
    let mut end = || {
        let x = 200.0 * next.unit();
        Point::new(x, 3.0 * x / 7.0)
    };
    let segments: Vec<Segment> = (0..100).map(|_| [end(), end()]).collect();
    let arranged = arrange(&segments, &SPLIT, "pieces of a line");
    assert_settled(&arranged, &segments, "pieces of a line");
    assert!(arranged.grid.is_some() && arranged.rounds < 5, "{} rounds", arranged.rounds);
    assert!(arranged.farthest < 2e-13, "{}", arranged.farthest);
}

/// `defects/unsettled.segments`
#[test]
fn unsettled_segments_settle() {
    let numbers = [
        [0.018737023238535655, 0.5045266461286917, 0.15153261659397965, 0.152083823546187],
        [0.0, 0.4, 0.30000000000000004, 0.1],
        [0.1, 0.30000000000000004, 0.0, 0.4],
    ];
    let segments = numbers.map(|[x0, y0, x1, y1]| [Point::new(x0, y0), Point::new(x1, y1)]);
    let arranged = arrange(&segments, &SPLIT, "unsettled");
    assert_settled(&arranged, &segments, "unsettled");
    assert!(arranged.farthest < 1e-15, "{}", arranged.farthest);
}

/// `defects/touch_not_named.segments`
/// Edges that were bent cross anew: what is made there is as far from the segments as the bends and the rounding together.
#[test]
fn later_rounds_count_the_bends_of_those_before() {
    let far = |arranged: &Arranged| arranged.moved.iter().map(|moved| moved.1).fold(0.0, f64::max);
    let ends: [[f64; 4]; 3] = [
        [2.0000000000000005e-05, 0.0, 9.999999999999999e-06, 3.9999999999999996e-05],
        [1.9999999999999998e-05, 0.0, 1e-05, 4.0000000000000024e-05],
        [2e-05, 0.0, 1e-05, 4e-05],
    ];
    let segments = ends.map(|[a, b, c, d]| [Point::new(a, b), Point::new(c, d)]);
    let arranged = arrange(&segments, &SPLIT, "bends");
    assert_settled(&arranged, &segments, "bends");
    let told = (arranged.rounds, far(&arranged), arranged.farthest);
    assert!(told.0 > 1 && told.1 >= 2.465e-21 && told.1 <= told.2, "{told:?}");
}

#[test]
fn all_touching_pairs_are_named() {
    let numbers = [[3., 3., 3., 0.], [3., 2., 2., 3.], [0., 0., 3., 2.]];
    let segments = numbers.map(|[x0, y0, x1, y1]| [Point::new(x0, y0), Point::new(x1, y1)]);
    let SegmentsError::Faults { faults, more } = Subdivision::from_segments(&segments).unwrap_err() else { panic!() };
    let touch = |segment| SegmentFault::Touching { segment, at: Point::new(3., 2.), on: 0 };
    assert_eq!((faults, more), (vec![touch(1), touch(2)], false));
}

#[test]
fn parts_that_have_settled_do_not_move() {
    // The bundle of the defect, and a triangle far from any grid of it that touches nothing.
    let bundle = [
        [0.018737023238535655, 0.5045266461286917, 0.15153261659397965, 0.152083823546187],
        [0.0, 0.4, 0.30000000000000004, 0.1],
        [0.1, 0.30000000000000004, 0.0, 0.4],
    ];
    let mut segments: Vec<Segment> = bundle.map(|[x0, y0, x1, y1]| [Point::new(x0, y0), Point::new(x1, y1)]).to_vec();
    for i in 0..40 {
        // Near-copies that make it hard to settle.
        let [a, b] = segments[1 + i % 2];
        segments.push([Point::new(steps(a.x, i as i64 % 5), a.y), Point::new(b.x, steps(b.y, i as i64 % 7))]);
    }
    let tiny = 1e-18;
    let corners = [(7.0 * tiny, 0.9), (3.0 * tiny, 0.8), (0.7, 0.9 + tiny)].map(Point::from);
    let first = segments.len();
    (0..3).for_each(|i| segments.push([corners[i], corners[(i + 1) % 3]]));
    let arranged = arrange(&segments, &SPLIT, "parts");
    assert_settled(&arranged, &segments, "parts");
    assert!(arranged.grid.is_some(), "the bundle settles without a grid: an easy test");
    let s = &arranged.subdivision;
    for (i, &corner) in corners.iter().enumerate() {
        assert_eq!(s.point(s.origin(arranged.chain(first + i)[0])), corner);
    }
    // On a grid of its own it moves.
    let all = arrange(&segments, &ArrangeOptions { grid: arranged.grid, ..SPLIT }, "all");
    assert_eq!(all.subdivision.point(all.subdivision.origin(all.chain(first)[0])).x, 0.0);
}

#[test]
fn grids_that_doubles_do_not_reach_are_refused() {
    let segments = [[Point::new(4e6, 0.0), Point::new(4e6, 1.0)]];
    for size in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e-12, 1e61] {
        let error =
            Subdivision::arrange_segments(&segments, &ArrangeOptions { grid: Some(size), ..SPLIT }).unwrap_err();
        let SegmentsError::Grid { finest, .. } = error else { panic!("{size}: {error}") };
        let options = ArrangeOptions { grid: Some(finest), ..SPLIT };
        assert_eq!(Subdivision::arrange_segments(&segments, &options).unwrap().grid, Some(finest));
    }
    // Nothing meets: a grid is used all the same, since it was asked for.
    let arranged = arrange(&segments, &ArrangeOptions { grid: Some(0.3), ..SPLIT }, "apart");
    assert_eq!((arranged.grid, arranged.displaced.len(), arranged.rounds), (Some(0.25), 0, 1));
}

#[test]
fn overlapping_segments_share_chains_and_memory() {
    // n segments from one point along one line, and n nested ones; both directions.
    let n = 3000;
    let p = |i: u32| Point::new(f64::from(i), f64::from(2 * i));
    let from_one = (1..=n).map(|i| if i % 2 == 0 { [p(0), p(i)] } else { [p(i), p(0)] });
    let nested = (0..n).map(|i| [Point::new(f64::from(i), -1.0), Point::new(f64::from(3 * n - i), -1.0)]);
    let segments: Vec<Segment> = from_one.chain(nested).collect();
    let arranged = arrange(&segments, &SPLIT, "overlaps");
    let s = &arranged.subdivision;
    assert_eq!((s.edge_count(), s.vertex_count()), (3 * n as usize - 1, 3 * n as usize + 1));
    assert_eq!(s.geometry_violations(), []);
    for i in [0, 1, 2, 1499, 2998, 2999] {
        let chain = arranged.chain(i);
        assert_eq!(chain.len(), i + 1);
        let ends = [s.origin(chain[0]), s.destination(chain[i])].map(|v| s.point(v));
        assert_eq!(ends, segments[i]);
        assert!(chain.windows(2).all(|pair| s.destination(pair[0]) == s.origin(pair[1])));
    }
    assert_eq!((arranged.rounds, arranged.farthest, arranged.crossings.len()), (0, 0.0, 0));
    // A small one with the segments along each edge.
    let few: Vec<Segment> = segments[..4].to_vec();
    let along = arrange(&few, &SPLIT, "few").segments_along();
    let expected: [&[u32]; 4] = [&[0, 1, 2, 3], &[1, 2, 3], &[2, 3], &[3]];
    for (e, expected) in expected.into_iter().enumerate() {
        assert_eq!(along.of(EdgeId::new(e as u32)), expected, "e{e}");
    }
}

#[test]
fn points_that_come_together_on_a_grid_are_one_vertex_and_segments_between_them_are_named() {
    let points = [(0.1, 0.1), (0.2, -0.1), (5.0, 0.2), (5.1, 4.9), (0.05, 5.05)].map(Point::from);
    let segments = [[0, 1], [1, 2], [2, 3], [3, 4], [4, 0]];
    let options = ArrangeOptions { grid: Some(1.0), ..SPLIT };
    let arranged = Subdivision::arrange_graph(&points, &segments, &options).unwrap();
    let s = &arranged.subdivision;
    assert_eq!(arranged.vertices, [0, 0, 1, 2, 3].map(VertexId::new));
    assert_eq!((s.vertex_count(), s.edge_count(), s.face_count()), (4, 4, 2));
    assert_eq!((arranged.collapsed.clone(), arranged.displaced.len()), (vec![0], 4));
    assert!(arranged.displaced[0].1 > 0.2236 && arranged.displaced[0].1 < 0.2237, "the further of both");
}

/// Rays from about one point to all sides, some of them on beyond it: rounding brings their crossings together, and pieces of
/// segments that run towards each other become one edge that is cut again.
fn star(next: &mut Numbers) -> Vec<Segment> {
    let [x, y, reach] = [next.unit(), next.unit(), next.unit()];
    (0..4 + next.below(6))
        .map(|_| {
            let [dx, dy] = [reach * (next.unit() - 0.5), reach * (next.unit() - 0.5)];
            let beyond = if next.below(3) == 0 { 0.0 } else { 1.0 };
            [Point::new(x + dx, y + dy), Point::new(x - beyond * dx, y - beyond * dy)]
        })
        .collect()
}

#[test]
fn chains_hold_together_where_edges_that_are_shared_are_cut_again() {
    let (mut in_rounds, mut against) = (0, 0);
    for seed in 0..250 {
        let mut next = Numbers::new(seed + 40_000);
        let segments: Vec<Segment> = (0..1 + next.below(3)).flat_map(|_| star(&mut next)).collect();
        let context = format!("seed {seed}");
        let arranged = arrange(&segments, &SPLIT, &context);
        assert_settled(&arranged, &segments, &context);
        if arranged.rounds > 1 && arranged.grid.is_none() {
            in_rounds += 1;
            against += (0..segments.len()).flat_map(|i| arranged.chain(i)).filter(|h| h.number() % 2 == 1).count();
        }
    }
    assert!(in_rounds > 50 && against > 100, "{in_rounds} {against}");
}

/// Near the smallest coordinates there are, a crossing moves as far as ends are apart.
#[test]
fn crossings_among_the_smallest_coordinates_settle() {
    let (mut moved, mut in_place) = (0, 0);
    for seed in 0..3_000 {
        let mut next = Numbers::new(seed + 50_000);
        let size = 3 + seed % 9;
        let mut place = || Point::new(next.below(size) as f64 * SMALLEST, next.below(size) as f64 * SMALLEST);
        let segments: Vec<Segment> = (0..2 + seed % 5).map(|_| [place(), place()]).collect();
        let context = format!("seed {seed}");
        let arranged = arrange(&segments, &SPLIT, &context);
        assert_settled(&arranged, &segments, &context);
        moved += arranged.moved.iter().filter(|moved| moved.1 > 0.25 * SMALLEST).count();
        in_place += usize::from(arranged.grid.is_none() && arranged.rounds > 0);
    }
    assert!(moved > 200 && in_place > 1_000, "{moved} {in_place}");
}

/// Bundles that need a grid, a triangle on no grid of theirs, and far away a cross, whose crossing is rounded in place by more
/// than the whole grid.
#[test]
fn what_has_settled_stays_and_counts_where_other_parts_go_to_a_grid() {
    let (mut on_grid, mut wider) = (0, 0);
    let tiny = 2f64.powi(-60);
    let corners = [(7.0 * tiny, 3.5), (3.0 * tiny, 3.4), (0.5, 3.5 + 2.0 * f64::EPSILON)].map(Point::from);
    let far = |x: f64, y: f64| Point::new(1e7 + x, 1e7 + y);
    for seed in 0..700 {
        let mut next = Numbers::new(seed + 60_000);
        let mut segments: Vec<Segment> = (0..2 + next.below(2)).flat_map(|_| bundle(&mut next)).collect();
        segments.retain(|ends| ends.iter().all(|p| p.x.abs().max(p.y.abs()) < 3.0));
        let first = segments.len();
        segments.extend((0..3).map(|i| [corners[i], corners[(i + 1) % 3]]));
        let [u, v] = [next.unit(), next.unit()];
        segments.extend([[far(0.0, u), far(3.0, 1.0 + v)], [far(u, 2.0), far(1.0 + v, 0.0)]]);
        let context = format!("seed {seed}");
        let arranged = arrange(&segments, &SPLIT, &context);
        assert_settled(&arranged, &segments, &context);
        let Some(grid) = arranged.grid else { continue };
        let s = &arranged.subdivision;
        let stays = (0..3).all(|i| s.point(s.origin(arranged.chain(first + i)[0])) == corners[i]);
        assert!(stays && grid < 1e-14, "{context}: a part that has settled goes to a grid of {grid:e}");
        on_grid += 1;
        wider += u32::from(arranged.moved.iter().any(|moved| moved.1 > grid));
    }
    assert!(on_grid > 20 && wider > 20, "{on_grid} {wider}");
}
