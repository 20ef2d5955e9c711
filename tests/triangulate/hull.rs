//! Convex hulls: against a plain look at all pairs, and against those that others state (O03, O04, O14).

use crate::common::Random;
use dcel_kit::plane::predicates::orientation;
use dcel_kit::plane::{HullError, Point, Subdivision, convex_hull};
use serde_json::Value;
use std::path::{Path, PathBuf};

fn of(list: &[(i32, i32)]) -> Vec<Point> {
    list.iter().map(|&(x, y)| Point::new(f64::from(x), f64::from(y))).collect()
}

fn order(p: Point) -> (f64, f64) {
    (p.x, p.y)
}

/// The corners by all pairs: a side has all points on its left, or on the line between its ends.
fn by_all_pairs(points: &[Point]) -> Vec<Point> {
    let holds = |a: Point, b: Point| {
        points.iter().all(|&p| match orientation(a, b, p) {
            std::cmp::Ordering::Equal => {
                (a.x.min(b.x)..=a.x.max(b.x)).contains(&p.x) && (a.y.min(b.y)..=a.y.max(b.y)).contains(&p.y)
            }
            side => side.is_gt(),
        })
    };
    let Some(&start) = points.iter().min_by(|p, q| order(**p).partial_cmp(&order(**q)).unwrap()) else { return vec![] };
    let mut corners = vec![start];
    loop {
        let last = corners[corners.len() - 1];
        let next = points.iter().find(|&&p| p != last && holds(last, p));
        match next {
            Some(&next) if next != start => corners.push(next),
            _ => return corners,
        }
    }
}

#[test]
fn small_hulls_agree_with_all_pairs() {
    for seed in 0..3000_u64 {
        let mut random = Random(seed);
        let (n, size) = (random.below(14), 1 + random.below(9));
        let points: Vec<Point> =
            (0..n).map(|_| Point::new(random.below(size) as f64, random.below(size) as f64)).collect();
        let corners = convex_hull(&points).unwrap();
        let places: Vec<Point> = corners.iter().map(|&i| points[i as usize]).collect();
        assert_eq!(places, by_all_pairs(&points), "seed {seed}");
        let firsts = corners.iter().all(|&i| points.iter().position(|&p| p == points[i as usize]) == Some(i as usize));
        assert!(firsts, "seed {seed}: of equal points the first counts");
        let s = Subdivision::convex_hull(&points).unwrap();
        assert_eq!((dcel_kit::topology::violations(&s), s.geometry_violations()), (vec![], vec![]), "seed {seed}");
        assert_eq!(s.vertices().map(|v| s.point(v)).collect::<Vec<_>>(), places);
        let due = match corners.len() {
            0 | 1 => 0,
            2 => 1,
            n => n,
        };
        assert_eq!((s.edge_count(), s.face_count()), (due, 1 + usize::from(due > 2)), "seed {seed}");
    }
}

/// Andrew's scan as the books have it, over all points: nothing is put aside.
fn by_the_book(points: &[Point]) -> Vec<u32> {
    let at = |i: &u32| points[*i as usize];
    let mut order: Vec<u32> = (0..points.len() as u32).collect();
    order.sort_by(|a, b| order_of(at(a), at(b)));
    order.dedup_by(|b, a| at(a) == at(b));
    let side = |order: &mut dyn Iterator<Item = u32>| {
        let mut side: Vec<u32> = Vec::new();
        for i in order {
            while let [.., a, b] = side[..]
                && !orientation(at(&a), at(&b), at(&i)).is_gt()
            {
                side.pop();
            }
            side.push(i);
        }
        side.pop();
        side
    };
    let lower = side(&mut order.iter().copied());
    lower.into_iter().chain(side(&mut order.iter().rev().copied())).collect()
}

fn order_of(a: Point, b: Point) -> std::cmp::Ordering {
    order(a).partial_cmp(&order(b)).unwrap()
}

/// Clouds that are large enough for strips, in every shape that strips may be wrong about.
#[test]
fn large_hulls_agree_with_a_scan_over_all_points() {
    type Place = fn(&mut Random) -> (f64, f64);
    let shapes: [(&str, Place); 11] = [
        ("a square", |r| (r.below(1 << 20) as f64, r.below(1 << 20) as f64)),
        ("a lattice", |r| (r.below(90) as f64, r.below(90) as f64)),
        ("a circle", |r| (r.below(1 << 20) as f64).sin_cos()),
        ("clusters", |r| {
            let (x, y) = [(0.0, 0.0), (9.0, 1.0), (5.0, 7.0), (4.0, 4.0)][r.below(4)];
            (x + r.below(1000) as f64 * 1e-6, y + r.below(1000) as f64 * 1e-6)
        }),
        ("a triangle", |r| {
            let (a, b) = (r.below(1 << 16), r.below(1 << 16));
            (a.max(b) as f64, a.min(b) as f64)
        }),
        ("a parabola and what is above", |r| {
            let x = r.below(4001) as f64 - 2000.0;
            (x, x * x + [0.0, 1e-9, 5.0, 1e6][r.below(4)])
        }),
        ("upright columns", |r| ([0.0, 1e-40, 1.0][r.below(3)], r.below(5000) as f64)),
        ("a line, tenths", |r| {
            let i = r.below(7000) as f64;
            (i * 0.1, i * 0.3)
        }),
        ("far away", |r| (1e15 + r.below(64) as f64 * 0.125, 1e15 + r.below(4000) as f64 * 0.125)),
        ("a needle to the left", |r| match r.below(2000) {
            0 => (-1e9, 0.0),
            _ => (r.below(100) as f64, r.below(100) as f64),
        }),
        ("two heights", |r| (r.below(6000) as f64, [-0.0, 0.0, 1.0][r.below(3)])),
    ];
    for (name, place) in shapes {
        for (seed, count) in [(1, 2_500), (2, 9_000), (3, 30_000)] {
            let mut random = Random(seed);
            let points: Vec<Point> = (0..count).map(|_| place(&mut random).into()).collect();
            assert_eq!(convex_hull(&points).unwrap(), by_the_book(&points), "{name}, {count} points");
        }
    }
}

#[test]
fn nearly_straight_sides_are_told_apart() {
    // The middle point is one last place inside, on, or outside of the lower side.
    let up = f64::from_bits(1.0_f64.to_bits() + 1);
    let down = f64::from_bits(1.0_f64.to_bits() - 1);
    for (y, corners) in [(1.0, 3), (up, 3), (down, 4)] {
        let points = [(0., 0.), (1., y), (3., 3.), (0., 9.)].map(Point::from);
        assert_eq!(convex_hull(&points).unwrap().len(), corners, "{y}");
    }
}

#[test]
fn points_that_cannot_be_used_are_named() {
    let points = [Point::new(0.0, 1.0), Point::new(f64::NAN, 0.0)];
    let Err(error @ HullError::Coordinate { point: 1, .. }) = convex_hull(&points) else { panic!() };
    assert!(error.to_string().starts_with("point 1: "), "{error}");
    assert_eq!(Subdivision::convex_hull(&points).unwrap_err().to_string(), error.to_string());
    assert_eq!(Subdivision::convex_hull(&[]).unwrap(), Subdivision::new());
    assert_eq!(convex_hull(&of(&[(3, 1), (3, 1)])).unwrap(), [0]);
}

fn data(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared/data").join(path)
}

fn json(path: &Path) -> Value {
    serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap()
}

/// All pairs of numbers in a text.
fn numbers(text: &str) -> Vec<Point> {
    let words = text.split(|c: char| !(c.is_ascii_digit() || "+-.eE".contains(c)));
    let numbers: Vec<f64> = words.filter_map(|word| word.parse().ok()).collect();
    numbers.chunks_exact(2).map(|p| Point::new(p[0], p[1])).collect()
}

/// All pairs of numbers in the coordinates of a GeoJSON value, or in nested lists.
fn pairs(value: &Value, points: &mut Vec<Point>) {
    match value {
        Value::Array(list) => match list[..] {
            [Value::Number(ref x), Value::Number(ref y), ..] => {
                points.push(Point::new(x.as_f64().unwrap(), y.as_f64().unwrap()));
            }
            _ => list.iter().for_each(|value| pairs(value, points)),
        },
        Value::Object(map) => map.iter().filter(|(key, _)| *key != "bbox").for_each(|(_, value)| pairs(value, points)),
        _ => {}
    }
}

/// A stated ring, closed or not, from its leftmost corner on counter-clockwise.
fn stated(mut ring: Vec<Point>) -> Vec<Point> {
    if ring.len() > 1 && ring.first() == ring.last() {
        ring.pop();
    }
    let Some(start) = (0..ring.len()).min_by(|&i, &j| order(ring[i]).partial_cmp(&order(ring[j])).unwrap()) else {
        return ring;
    };
    ring.rotate_left(start);
    if ring.len() > 2 && orientation(ring[ring.len() - 1], ring[0], ring[1]).is_lt() {
        ring[1..].reverse();
    }
    ring
}

fn hull(points: &[Point]) -> Vec<Point> {
    convex_hull(points).unwrap().into_iter().map(|i| points[i as usize]).collect()
}

#[test]
#[cfg_attr(not(shared_data), ignore = "needs ../shared/data")]
fn hulls_that_others_state() {
    let files = json(&data("O03-delaunator/expected.json"));
    for (name, due) in files.as_object().unwrap() {
        // Read by the standard library, which rounds correctly: one of these is straight to the last place.
        let points = numbers(&std::fs::read_to_string(data("O03-delaunator/fixtures").join(name)).unwrap());
        assert_eq!(due["points"].as_u64(), Some(points.len() as u64));
        assert_eq!(due["hull_corners"].as_u64(), Some(hull(&points).len() as u64), "{name}");
    }
    for i in 1..=5 {
        let file = |side: &str| json(&data(&format!("O04-turf/turf-convex/test/{side}/elevation{i}.geojson")));
        let mut given = Vec::new();
        pairs(&file("in"), &mut given);
        // The answer holds what was given once more, beside the hull.
        let answer = file("out");
        let polygons = answer["features"].as_array().unwrap().iter().filter(|f| f["geometry"]["type"] == "Polygon");
        let mut stated_hulls = polygons.map(|f| {
            let mut corners = Vec::new();
            pairs(&f["geometry"], &mut corners);
            stated(corners)
        });
        assert!(stated_hulls.any(|due| due == hull(&given)), "elevation{i}");
    }
    let mut cases = 0;
    for file in ["TestConvexHull.xml", "TestConvexHull-big.xml"] {
        let text = std::fs::read_to_string(data("O14-jts-xml").join(file)).unwrap();
        let document = roxmltree::Document::parse(&text).unwrap();
        for case in document.descendants().filter(|node| node.has_tag_name("case")) {
            let child = |name: &str| case.descendants().find(|node| node.has_tag_name(name)).unwrap();
            let text = |name: &str| numbers(child(name).text().unwrap_or(""));
            assert_eq!(hull(&text("a")), stated(text("op")), "{file}, case {cases}");
            cases += 1;
        }
    }
    assert_eq!(cases, 14);
}
