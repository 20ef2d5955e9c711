//! The fixtures of earcut (O01) and poly2tri (O02), with what they state.

use crate::judge::{METHODS, judge};
use dcel_kit::FaceId;
use dcel_kit::plane::{ArrangeOptions, Point, Subdivision, TriangulationMethod};
use serde_json::Value;
use std::path::{Path, PathBuf};

fn data(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared/data").join(path)
}

fn json(path: &Path) -> Value {
    serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap()
}

/// Twice the area of a closed line.
fn doubled_area(points: &[Point]) -> f64 {
    let base = points.first().copied().unwrap_or_default();
    let turn = |i: usize| {
        let (p, q) = (points[i], points[(i + 1) % points.len()]);
        (p.x - base.x) * (q.y - base.y) - (q.x - base.x) * (p.y - base.y)
    };
    (0..points.len()).map(turn).sum()
}

fn arrange(rings: &[Vec<Point>], split: bool) -> Option<Subdivision> {
    let side = |ring: &Vec<Point>| (0..ring.len()).map(|i| [ring[i], ring[(i + 1) % ring.len()]]).collect::<Vec<_>>();
    let segments: Vec<[Point; 2]> = rings.iter().flat_map(side).collect();
    let options = ArrangeOptions { merge: true, split, ..ArrangeOptions::default() };
    Some(Subdivision::arrange_segments(&segments, &options).ok()?.subdivision)
}

/// The sides of closed lines, each in all the strips of equal height that it touches.
struct Strips {
    low: f64,
    height: f64,
    sides: Vec<Vec<[Point; 2]>>,
}

impl Strips {
    fn new(rings: &[Vec<Point>]) -> Self {
        let ys = || rings.iter().flatten().map(|p| p.y);
        let (low, high) = (ys().fold(f64::INFINITY, f64::min), ys().fold(f64::NEG_INFINITY, f64::max));
        let count = ys().count().max(1);
        let mut out = Self { low, height: (high - low) / count as f64, sides: vec![Vec::new(); count] };
        for ring in rings {
            for (i, &a) in ring.iter().enumerate() {
                let b = ring[(i + 1) % ring.len()];
                for strip in out.strip(a.y.min(b.y))..=out.strip(a.y.max(b.y)) {
                    out.sides[strip].push([a, b]);
                }
            }
        }
        out
    }

    fn strip(&self, y: f64) -> usize {
        (((y - self.low) / self.height) as usize).min(self.sides.len() - 1)
    }

    /// Whether the place is inside by the even-odd rule.
    fn holds(&self, p: Point) -> bool {
        let mut inside = false;
        for &[a, b] in &self.sides[self.strip(p.y)] {
            inside ^= (a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x;
        }
        inside
    }
}

/// The area of the triangles inside the rings.
fn area_inside(s: &Subdivision, rings: &[Vec<Point>]) -> f64 {
    let strips = Strips::new(rings);
    let mut area = 0.0;
    for f in s.faces().skip(1) {
        let corners: Vec<Point> = s.incident_vertices(f).map(|v| s.point(v)).collect();
        let [a, b, c] = corners[..] else { panic!("{f}") };
        if strips.holds(Point::new((a.x + b.x + c.x) / 3.0, (a.y + b.y + c.y) / 3.0)) {
            area += doubled_area(&corners);
        }
    }
    area
}

#[test]
#[cfg_attr(not(shared_data), ignore = "needs ../shared/data")]
fn polygons_of_earcut_keep_their_area_when_ears_are_cut() {
    polygons_of_earcut_keep_their_area(TriangulationMethod::Ears);
}

#[test]
#[cfg_attr(not(shared_data), ignore = "needs ../shared/data")]
fn polygons_of_earcut_keep_their_area_in_monotone_pieces() {
    polygons_of_earcut_keep_their_area(TriangulationMethod::Monotone);
}

fn polygons_of_earcut_keep_their_area(method: TriangulationMethod) {
    let stated = json(&data("O01-earcut/expected_plus.json"));
    let (mut valid, mut all) = (0, 0);
    for (name, stated) in stated.as_object().unwrap() {
        let file = json(&data("O01-earcut/fixtures").join(format!("{name}.json")));
        let point = |p: &Value| Point::new(p[0].as_f64().unwrap(), p[1].as_f64().unwrap());
        let ring = |ring: &Value| ring.as_array().unwrap().iter().map(point).collect::<Vec<_>>();
        let rings: Vec<Vec<Point>> = file.as_array().unwrap().iter().map(ring).collect();
        let is_valid = stated["valid_simple_polygon_geos"].as_bool().unwrap();
        // A ring may be valid and touch another one in the middle of a side.
        let s = arrange(&rings, false).or_else(|| arrange(&rings, true)).unwrap_or_else(|| panic!("{name}"));
        all += 1;
        let mut after = s.clone();
        let added = after.triangulate(method).unwrap_or_else(|error| panic!("{name}: {error}"));
        judge(&s, &s.faces().skip(1).collect::<Vec<_>>(), &after, &added);
        if !is_valid {
            continue;
        }
        valid += 1;
        let area = area_inside(&after, &rings);
        let due = doubled_area(&rings[0]).abs() - rings[1..].iter().map(|r| doubled_area(r).abs()).sum::<f64>();
        let allowed = stated["allowed_area_error"].as_f64().unwrap();
        // What is left is the rounding of these two sums.
        assert!((area - due).abs() <= allowed.max(1e-13) * due, "{name}, {method:?}: {area} for {due}");
    }
    assert_eq!((all, valid), (59, 31));
}

#[test]
#[cfg_attr(not(shared_data), ignore = "needs ../shared/data")]
fn polygons_of_poly2tri() {
    let stated = json(&data("O02-poly2tri/expected.json"));
    let mut simple = 0;
    for (name, stated) in stated.as_object().unwrap() {
        if !stated["valid_simple"].as_bool().unwrap() || stated["duplicates"].as_u64() != Some(0) {
            continue;
        }
        let text = std::fs::read_to_string(data("O02-poly2tri").join(name)).unwrap();
        // What is stated of polygon_test_01 leaves out the corners written with a plus sign, and takes the hole of
        // stalactite for a part of its outline.
        let words = text.lines().filter(|line| !line.starts_with('+')).flat_map(str::split_whitespace);
        let numbers: Vec<f64> = words.filter_map(|word| word.parse().ok()).collect();
        let outline: Vec<Point> = numbers.chunks_exact(2).map(|p| Point::new(p[0], p[1])).collect();
        let n = outline.len();
        let s = arrange(std::slice::from_ref(&outline), false).unwrap_or_else(|| panic!("{name} is refused"));
        assert_eq!(Some(n as u64), stated["n"].as_u64());
        simple += 1;
        for method in METHODS {
            if n > 5000 && method == METHODS[0] {
                continue; // 10,000 corners take the ears too long here
            }
            let mut after = s.clone();
            let added = after.triangulate_face(FaceId::new(1), method).unwrap();
            judge(&s, &[FaceId::new(1)], &after, &added);
            assert_eq!(added.new_faces.len() as u64 + 1, stated["triangles_if_simple"].as_u64().unwrap(), "{name}");
            let (area, due) =
                (area_inside(&after, std::slice::from_ref(&outline)), 2.0 * stated["area"].as_f64().unwrap());
            assert!((area - due).abs() <= 1e-9 * due, "{name}: {area} for {due}");
        }
    }
    assert_eq!(simple, 18);
}
