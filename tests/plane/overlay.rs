//! Promise: an overlay has the edges of both subdivisions, every face knows the faces of both that it lies in, and
//! regions are what set theory says; exactly where crossings need no rounding, and without contradiction elsewhere.

use crate::numbers::Numbers;
use dcel_kit::plane::{ArrangeOptions, Location, Operation, Overlay, Parts, Point, Subdivision};
use dcel_kit::topology::{components, isomorphic, violations};
use dcel_kit::{EdgeId, FaceId};
use std::collections::BTreeSet;

fn split(segments: &[[Point; 2]]) -> Subdivision {
    let options = ArrangeOptions { merge: true, split: true, ..ArrangeOptions::default() };
    Subdivision::arrange_segments(segments, &options).unwrap().subdivision
}

/// A point inside a bounded face, very near to the middle of an edge of it.
fn point_inside(s: &Subdivision, f: FaceId) -> Point {
    let h = s.half_edge(f).unwrap();
    let (a, b) = (s.point(s.origin(h)), s.point(s.destination(h)));
    let (dx, dy) = ((b.x - a.x) * 1e-7, (b.y - a.y) * 1e-7);
    Point::new((a.x + b.x) / 2.0 - dy, (a.y + b.y) / 2.0 + dx)
}

fn bounded(s: &Subdivision) -> impl Iterator<Item = FaceId> + '_ {
    s.faces().filter(|&f| f != s.outer_face())
}

/// Random segments in eight directions between even whole points: all their crossings are whole points. Some faces
/// are hole faces.
fn random_exact(seed: u64) -> Subdivision {
    let mut next = Numbers::new(seed);
    let mut segments: Vec<[Point; 2]> = Vec::new();
    for _ in 0..2 + next.below(14) {
        let (dx, dy) = [(1, 0), (0, 1), (1, 1), (1, -1)][next.below(4) as usize];
        let (x, y, l) = (2 * next.below(12), 2 * next.below(12), 2 + 2 * next.below(10));
        segments.push([Point::new(x as f64, y as f64), Point::new((x + l * dx) as f64, (y + l * dy) as f64)]);
    }
    // A frame round everything makes rings of what does not touch it.
    if next.below(2) == 0 {
        let c = [(-10., -14.), (46., -14.), (46., 46.), (-10., 46.)].map(Point::from);
        segments.extend([[c[0], c[1]], [c[1], c[2]], [c[2], c[3]], [c[3], c[0]]]);
    }
    for _ in 0..next.below(4) {
        let (x, y, r) = ((2 * next.below(12)) as f64, (2 * next.below(12)) as f64, (2 + 2 * next.below(5)) as f64);
        let c = [(x, y), (x + r, y), (x + r, y + r), (x, y + r)].map(Point::from);
        segments.extend([[c[0], c[1]], [c[1], c[2]], [c[2], c[3]], [c[3], c[0]]]);
    }
    let mut s = split(&segments);
    let holes: Vec<Point> = bounded(&s).filter(|_| next.below(4) == 0).map(|f| point_inside(&s, f)).collect();
    s.mark_holes(&holes).unwrap();
    s
}

fn assert_legal(s: &Subdivision, context: &str) {
    assert_eq!(violations(s), [], "{context}");
    assert_eq!(s.geometry_violations(), [], "{context}");
    let (v, e, f) = (s.vertex_count() as i64, s.edge_count() as i64, s.face_count() as i64);
    assert_eq!(v - e + f, 1 + components(s).count() as i64, "{context}: Euler");
}

/// Labels must be where the point of each face lies; what stays and what changes over edges; where vertices and edges
/// have come from.
fn assert_carried(a: &Subdivision, b: &Subdivision, both: &Overlay, context: &str) {
    let s = &both.subdivision;
    assert_legal(s, context);
    assert_eq!(both.unsettled, [], "{context}");
    for f in s.faces() {
        let labels = [both.face_of_a[f], both.face_of_b[f]];
        if f == s.outer_face() {
            assert_eq!(labels, [f, f], "{context}");
            continue;
        }
        let p = point_inside(s, f);
        assert_eq!(s.locate(p), Location::Face(f), "{context}: {p}");
        assert_eq!([a.locate(p), b.locate(p)], labels.map(Location::Face), "{context}: {f} at {p}");
    }
    let mut seen = [BTreeSet::new(), BTreeSet::new()];
    for e in s.edges() {
        for (which, (source, list, faces)) in
            [(a, both.edges_of_a(e), &both.face_of_a), (b, both.edges_of_b(e), &both.face_of_b)].into_iter().enumerate()
        {
            let sides = e.half_edges().map(|h| faces[s.face(h)]);
            match list {
                [] => assert_eq!(sides[0], sides[1], "{context}: {e}"),
                [g] => {
                    assert_eq!(sides, [*g, g.twin()].map(|g| source.face(g)), "{context}: {e}");
                    seen[which].insert(g.edge());
                }
                more => assert!(!both.moved.is_empty(), "{context}: {e} comes from {more:?}"),
            }
        }
    }
    if both.moved.is_empty() {
        assert_eq!(seen, [a, b].map(|s| s.edges().collect::<BTreeSet<EdgeId>>()), "{context}: edges are lost");
    }
    for (source, places) in [(a, &both.vertices_of_a), (b, &both.vertices_of_b)] {
        for v in source.vertices() {
            assert_eq!(s.point(places[v].unwrap()), source.point(v), "{context}: {v}");
        }
    }
}

#[test]
fn labels_are_where_points_are_located() {
    let (mut crossings, mut in_rings) = (0, 0);
    for seed in 0..120 {
        let (a, b) = (random_exact(2 * seed), random_exact(2 * seed + 1));
        let both = a.overlay(&b).unwrap();
        assert_eq!(both.moved, [], "seed {seed}");
        assert_carried(&a, &b, &both, &format!("seed {seed}"));
        crossings += both.crossings.len();
        in_rings += bounded(&both.subdivision).filter(|&f| !both.subdivision.inner_components(f).is_empty()).count();
    }
    assert!(crossings > 300 && in_rings > 20, "{crossings} crossings, {in_rings} faces with rings");
}

#[test]
fn labels_hold_where_crossings_are_rounded() {
    let mut moved = 0;
    for seed in 0..25 {
        let mut next = Numbers::new(seed + 500);
        let mut some = || {
            let segments: Vec<[Point; 2]> =
                (0..12).map(|_| [Point::new(next.unit(), next.unit()), Point::new(next.unit(), next.unit())]).collect();
            split(&segments)
        };
        let (a, b) = (some(), some());
        let both = a.overlay(&b).unwrap();
        moved += both.moved.len();
        assert_carried(&a, &b, &both, &format!("seed {seed}"));
    }
    assert!(moved > 100, "{moved} crossings were rounded");
}

#[test]
fn bundles_a_last_place_apart_give_something_legal() {
    let mut laid = 0;
    for seed in 0..30 {
        let mut next = Numbers::new(seed + 900);
        let mut some = || {
            let mut jitter = |x: f64| x + next.below(40) as f64 * (x.next_up() - x);
            let segments: Vec<[Point; 2]> = (0..6)
                .map(|i| {
                    [
                        Point::new(jitter(0.1), jitter(0.1)),
                        Point::new(jitter(0.9), jitter(0.7 + 0.01 * f64::from(i % 2))),
                    ]
                })
                .collect();
            let options = ArrangeOptions { split: true, ..ArrangeOptions::default() };
            Subdivision::arrange_segments(&segments, &options)
        };
        let (a, b) = (some().unwrap(), some().unwrap());
        let both = a.subdivision.overlay(&b.subdivision).unwrap();
        assert_eq!(both.unsettled, [], "seed {seed}");
        laid += usize::from(both.grid.is_some());
        assert_legal(&both.subdivision, &format!("seed {seed}"));
        for operation in Operation::ALL {
            assert_legal(&both.region(operation, Parts::Joined).unwrap(), &format!("seed {seed}, {operation}"));
        }
    }
    assert!(laid > 3, "{laid} on a grid");
}

#[test]
fn a_subdivision_on_itself_on_nothing_and_in_the_other_order() {
    for seed in 200..240 {
        let (a, b) = (random_exact(seed), random_exact(seed + 1000));
        let context = format!("seed {seed}");
        let itself = a.overlay(&a).unwrap();
        assert_carried(&a, &a, &itself, &context);
        assert_eq!((&itself.face_of_a, &itself.crossings.len()), (&itself.face_of_b, &0), "{context}");
        let mut plain = itself.subdivision.clone();
        let holes: Vec<Point> = a.hole_faces().map(|f| point_inside(&a, f)).collect();
        plain.mark_holes(&holes).unwrap();
        assert!(isomorphic(&a, &plain).is_ok(), "{context}: the overlay with itself differs");

        let alone = a.overlay(&Subdivision::new()).unwrap();
        assert_carried(&a, &Subdivision::new(), &alone, &context);

        let (there, back) = (a.overlay(&b).unwrap(), b.overlay(&a).unwrap());
        assert!(isomorphic(&there.subdivision, &back.subdivision).is_ok(), "{context}: the order counts");
        for f in bounded(&there.subdivision) {
            let Location::Face(g) = back.subdivision.locate(point_inside(&there.subdivision, f)) else { panic!("{f}") };
            assert_eq!([there.face_of_a[f], there.face_of_b[f]], [back.face_of_b[g], back.face_of_a[g]], "{context}");
        }
    }
}

/// Twice the area of the bounded faces that are no hole faces; exact for whole coordinates.
fn area(s: &Subdivision) -> i64 {
    let cross = |h| {
        let (p, q) = (s.point(s.origin(h)), s.point(s.destination(h)));
        (p.x * q.y - p.y * q.x) as i64
    };
    bounded(s).filter(|&f| !s.is_hole(f)).flat_map(|f| s.cycles(f)).flat_map(|h| s.cycle(h)).map(cross).sum()
}

#[test]
fn regions_obey_the_laws_of_sets() {
    let mut with_holes = 0;
    for seed in 300..380 {
        let (a, b) = (random_exact(seed), random_exact(seed + 1000));
        let both = a.overlay(&b).unwrap();
        for parts in [Parts::Kept, Parts::Joined] {
            let made = Operation::ALL.map(|operation| both.region(operation, parts).unwrap());
            let [union, common, rest, either] = [0, 1, 2, 3].map(|i| area(&made[i]));
            let context = format!("seed {seed}, {parts:?}");
            assert_eq!(union + common, area(&a) + area(&b), "{context}");
            assert_eq!(rest + common, area(&a), "{context}");
            assert_eq!(either + common, union, "{context}");
            for (operation, region) in Operation::ALL.into_iter().zip(&made) {
                assert_legal(region, &format!("{context}, {operation}"));
                with_holes += region.hole_faces().count();
                let is_in = |f: FaceId| f != region.outer_face() && !region.is_hole(f);
                for f in bounded(&both.subdivision) {
                    let p = point_inside(&both.subdivision, f);
                    let [in_a, in_b] = [&a, &b].map(|s| match s.locate(p) {
                        Location::Face(f) => f != s.outer_face() && !s.is_hole(f),
                        other => panic!("{p} lies on {other}"),
                    });
                    let Location::Face(g) = region.locate(p) else { panic!("{context}: {p} lies on the outline") };
                    assert_eq!(is_in(g), operation.holds(in_a, in_b), "{context}, {operation}: {p}");
                }
                for e in region.edges() {
                    let [left, right] = e.half_edges().map(|h| is_in(region.face(h)));
                    assert!(left != right || (left && parts == Parts::Kept), "{context}, {operation}: {e}");
                }
            }
        }
    }
    assert!(with_holes > 50, "{with_holes}");
}

#[test]
fn operations_have_names() {
    for operation in Operation::ALL {
        assert_eq!(operation.to_string().parse(), Ok(operation));
    }
    assert!("and".parse::<Operation>().is_err());
}

#[test]
fn overlays_of_nearly_equal_maps_settle_with_labels_that_agree() {
    let (mut on_grid, mut several) = (0, 0);
    for seed in 0..60 {
        let mut next = Numbers::new(seed + 4000);
        // A fan of thin triangles through nearly one point, and the same a few last places off.
        let base: Vec<[f64; 4]> = (0..5)
            .map(|i| {
                let t = 0.1 * f64::from(i);
                [0.1 + t * 0.3, 0.05 + 0.2 * t, 0.9 - t * 0.3, 0.7 + 0.01 * t]
            })
            .collect();
        let mut some = || {
            let mut jitter = |x: f64| (0..next.below(6)).fold(x, |x, _| x.next_up());
            let segments: Vec<[Point; 2]> = base
                .iter()
                .flat_map(|&[x0, y0, x1, y1]| {
                    let p = [(x0, y0), (x1, y1), (x1, y1 + 1e-15)].map(|(x, y)| Point::new(jitter(x), jitter(y)));
                    [[p[0], p[1]], [p[1], p[2]], [p[2], p[0]]]
                })
                .filter(|[a, b]| a != b)
                .collect();
            split(&segments)
        };
        let (a, b) = (some(), some());
        let context = format!("seed {seed}");
        let both = a.overlay(&b).unwrap_or_else(|error| panic!("{context}: {error}"));
        assert_legal(&both.subdivision, &context);
        assert_eq!(both.unsettled, [], "{context}");
        assert!(both.farthest < 2e-15, "{context}: {}", both.farthest);
        on_grid += usize::from(both.grid.is_some());
        let given = a.vertices().map(|v| (a.point(v), both.vertices_of_a[v]));
        let given = given.chain(b.vertices().map(|v| (b.point(v), both.vertices_of_b[v])));
        for (p, v) in given {
            let v = v.expect("every vertex is somewhere");
            let (q, told) = (both.subdivision.point(v), both.displaced.iter().find(|moved| moved.0 == v));
            let by = (q.x - p.x).hypot(q.y - p.y);
            let told = told.map_or(0.0, |moved| moved.1);
            assert!(by <= told && told <= both.farthest, "{context}: {v} moved by {by:e}, not {told:e}");
        }
        several += both.subdivision.edges().filter(|&e| both.edges_of_a(e).len() > 1).count();
        let coarse = a.overlay_on_grid(&b, Some(0.01)).unwrap();
        assert_legal(&coarse.subdivision, &context);
        assert_eq!((coarse.unsettled.len(), coarse.grid), (0, Some(0.0078125)), "{context}");
        several += coarse.subdivision.edges().filter(|&e| coarse.edges_of_a(e).len() > 2).count();
        for operation in Operation::ALL {
            assert_legal(&both.region(operation, Parts::Joined).unwrap(), &format!("{context}, {operation}"));
        }
    }
    assert!(on_grid > 5 && several > 20, "{on_grid} on a grid, {several} edges of several");
}
