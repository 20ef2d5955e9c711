//! Promise: the area of a region of an overlay is that of the given shapes, as if no crossing had been rounded, wherever
//! they lie. Judged by polygons clipped in fractions of whole numbers of any size.

use crate::exact::{Whole, unit, whole};
use crate::numbers::Numbers;
use dcel_kit::FaceId;
use dcel_kit::plane::{Location, Operation, Overlay, Parts, Point, Subdivision};
use num_bigint::BigInt;

type Triangle = [Point; 3];

/// A point (x / w, y / w) in units, w > 0.
#[derive(Clone)]
struct Fraction {
    x: BigInt,
    y: BigInt,
    w: BigInt,
}

/// The side of the line a -> b on which the point lies, times w.
fn side([a, b]: [&Whole; 2], p: &Fraction) -> BigInt {
    (&b.x - &a.x) * (&p.y - &a.y * &p.w) - (&b.y - &a.y) * (&p.x - &a.x * &p.w)
}

/// What is left of the line (Sutherland and Hodgman).
fn clip(polygon: &[Fraction], line: [&Whole; 2]) -> Vec<Fraction> {
    let sides: Vec<BigInt> = polygon.iter().map(|p| side(line, p)).collect();
    let mut kept = Vec::new();
    for i in 0..polygon.len() {
        let j = (i + 1) % polygon.len();
        let (p, q, s, t) = (&polygon[i], &polygon[j], &sides[i], &sides[j]);
        if *s >= BigInt::ZERO {
            kept.push(p.clone());
        }
        if (*s > BigInt::ZERO && *t < BigInt::ZERO) || (*s < BigInt::ZERO && *t > BigInt::ZERO) {
            let at = |p: &BigInt, q: &BigInt| if *s > BigInt::ZERO { p * -t + q * s } else { p * t - q * s };
            kept.push(Fraction { x: at(&p.x, &q.x), y: at(&p.y, &q.y), w: at(&p.w, &q.w) });
        }
    }
    kept
}

/// So many bits below the unit are kept of areas.
const ROOM: usize = 300;

/// Twice the area of what two triangles have in common, in squared units with room below.
fn twice_common(a: &Triangle, b: &Triangle, unit: i32) -> BigInt {
    let whole = |p: &Point| Whole::new(*p, unit);
    let (a, b) = (a.each_ref().map(whole), b.each_ref().map(whole));
    let mut polygon: Vec<Fraction> =
        a.into_iter().map(|Whole { x, y }| Fraction { x, y, w: BigInt::from(1) }).collect();
    for i in 0..3 {
        polygon = clip(&polygon, [&b[i], &b[(i + 1) % 3]]);
    }
    let pairs = (0..polygon.len()).map(|i| (&polygon[i], &polygon[(i + 1) % polygon.len()]));
    pairs.map(|(p, q)| ((&p.x * &q.y - &p.y * &q.x) << ROOM) / (&p.w * &q.w)).sum()
}

/// Triangles with a hole in the middle of some of them.
struct Map {
    triangles: Vec<(Triangle, Option<Triangle>)>,
    plane: Subdivision,
}

impl Map {
    fn new(triangles: Vec<(Triangle, Option<Triangle>)>) -> Self {
        let mut points: Vec<Point> = Vec::new();
        let mut segments = Vec::new();
        for corners in triangles.iter().flat_map(|(outline, hole)| [Some(outline), hole.as_ref()]).flatten() {
            let first = points.len() as u32;
            points.extend(corners);
            segments.extend([0, 1, 2].map(|i| [first + i, first + (i + 1) % 3]));
        }
        let mut plane = Subdivision::from_graph(&points, &segments).unwrap();
        let holes = triangles.iter().filter_map(|(_, hole)| *hole).map(centre);
        plane.mark_holes(&holes.collect::<Vec<_>>()).unwrap();
        Self { triangles, plane }
    }

    /// The parts with their signs.
    fn parts(&self) -> impl Iterator<Item = (i32, &Triangle)> {
        self.triangles.iter().flat_map(|(outline, hole)| [Some((1, outline)), hole.as_ref().map(|h| (-1, h))]).flatten()
    }

    fn twice_area(&self, unit: i32) -> BigInt {
        self.parts().map(|(sign, t)| twice_common(t, t, unit) * sign).sum()
    }
}

fn centre([a, b, c]: Triangle) -> Point {
    Point::new(a.x + ((b.x - a.x) + (c.x - a.x)) / 3.0, a.y + ((b.y - a.y) + (c.y - a.y)) / 3.0)
}

/// A triangle in each field of a board, counter-clockwise and not too thin; the middle of some is taken out.
fn board(next: &mut Numbers, [x, y]: [f64; 2], size: f64) -> Map {
    let mut triangles = Vec::new();
    for field in 0..9 {
        let (left, low) = (x + size * f64::from(field % 3), y + size * f64::from(field / 3));
        let outline = loop {
            let t = [0; 3].map(|_| Point::new(left + size * next.unit(), low + size * next.unit()));
            if (t[1].x - t[0].x) * (t[2].y - t[0].y) - (t[1].y - t[0].y) * (t[2].x - t[0].x) > 0.1 * size * size {
                break t;
            }
        };
        let m = centre(outline);
        let inner = outline.map(|p| Point::new(m.x + (p.x - m.x) / 3.0, m.y + (p.y - m.y) / 3.0));
        triangles.push((outline, (next.below(3) == 0).then_some(inner)));
    }
    Map::new(triangles)
}

/// How far a number is from half of an exact one, as a part of it.
fn off(said: f64, twice: &BigInt, unit: i32) -> f64 {
    let said = whole(2.0 * said, 2 * unit - ROOM as i32);
    let off = said - twice;
    // The first digits of both are enough.
    let shift = twice.bits().saturating_sub(1000);
    let [off, twice] = [&off, twice].map(|n| (n >> shift).to_string().parse::<f64>().unwrap());
    if off == 0.0 { 0.0 } else { (off / twice).abs() }
}

fn face_at(map: &Map, p: Point) -> FaceId {
    let Location::Face(f) = map.plane.locate(p) else { panic!("{p} lies on an edge") };
    f
}

fn unit_of(maps: [&Map; 2]) -> i32 {
    let corners = maps.into_iter().flat_map(Map::parts).flat_map(|(_, t)| *t);
    unit(corners.flat_map(|p| [p.x, p.y]))
}

/// The exact double areas of all operations.
fn exact(a: &Map, b: &Map, unit: i32) -> [(Operation, BigInt); 4] {
    let pairs = a.parts().flat_map(|(s, p)| b.parts().map(move |(t, q)| (s * t, p, q)));
    let common: BigInt = pairs.map(|(sign, p, q)| twice_common(p, q, unit) * sign).sum();
    let [all_of_a, all_of_b] = [a, b].map(|map| map.twice_area(unit));
    [
        (Operation::Union, &all_of_a + &all_of_b - &common),
        (Operation::Difference, &all_of_a - &common),
        (Operation::SymmetricDifference, all_of_a + all_of_b - 2 * &common),
        (Operation::Intersection, common),
    ]
}

fn rounded(both: &Overlay, operation: Operation) -> f64 {
    both.region(operation, Parts::Kept).unwrap().domain_area()
}

#[test]
fn areas_of_regions_are_those_before_rounding() {
    let (mut worse, mut all) = (0, 0);
    for seed in 0..60 {
        let mut next = Numbers::new(seed + 900);
        let places =
            [([0.0, 0.0], 1.0), ([4e6, 5.5e6], 0.1), ([4e6, 5.5e6], 0.01), ([-1e9, 3.0], 1.0), ([1e12, 1e12], 1e3)];
        let (origin, size) = places[next.below(5) as usize];
        let a = board(&mut next, origin, size);
        let b = board(&mut next, origin.map(|x| x + 0.4 * size), size);
        let unit = unit_of([&a, &b]);
        let both = a.plane.overlay(&b.plane).unwrap();
        for (operation, twice) in exact(&a, &b, unit) {
            let area = both.area([&a.plane, &b.plane], operation);
            let off_by = off(area, &twice, unit);
            assert!(off_by <= 1e-14, "seed {seed}, at {origin:?}, size {size}: {operation} is off by {off_by:e}");
            worse += usize::from(off(rounded(&both, operation), &twice, unit) > 1e-12);
            all += 1;
        }
        // What one face of each has in common.
        for (outline, _) in a.triangles.iter().filter(|(_, hole)| hole.is_none()) {
            for (other, _) in b.triangles.iter().filter(|(_, hole)| hole.is_none()) {
                let labels = [(&a, outline), (&b, other)].map(|(map, t)| face_at(map, centre(*t)));
                let area = both.area_where([&a.plane, &b.plane], |at: [FaceId; 2]| at == labels);
                let twice = twice_common(outline, other, unit);
                let off_by = off(area, &twice, unit);
                assert!(off_by <= 1e-12, "seed {seed}: {labels:?} have {area:e} in common, off by {off_by:e}");
            }
        }
    }
    assert!(worse > all / 3, "only {worse} of {all} rounded areas are worse: an easy test");
}

/// What falls together counts as far as another line has taken its place: far less than rounded corners lose.
#[test]
fn areas_of_nearly_equal_maps_are_those_before_rounding() {
    let mut joined = 0;
    for seed in 0..60 {
        let mut next = Numbers::new(seed + 1700);
        let origin = [[0.5, 0.25], [4e6, 5.5e6], [-1e9, 3.0]][next.below(3) as usize];
        let a = board(&mut next, origin, 0.1);
        let mut jitter = |x: f64| (0..next.below(4)).fold(x, |x, _| x.next_up());
        let mut near = |t: &Triangle| t.map(|p| Point::new(jitter(p.x), jitter(p.y)));
        let b = Map::new(a.triangles.iter().map(|(t, hole)| (near(t), hole.as_ref().map(&mut near))).collect());
        let unit = unit_of([&a, &b]);
        let both = a.plane.overlay(&b.plane).unwrap();
        let edges = |h| [both.edges_of_a(h), both.edges_of_b(h)].iter().map(|list| list.len()).sum::<usize>();
        joined += both.subdivision.edges().filter(|&e| edges(e) > 1).count();
        for (operation, twice) in exact(&a, &b, unit) {
            if operation == Operation::Union || operation == Operation::Intersection {
                let area = both.area([&a.plane, &b.plane], operation);
                let off_by = off(area, &twice, unit);
                assert!(off_by <= 1e-12, "seed {seed}, at {origin:?}: {operation} is off by {off_by:e}");
            }
        }
    }
    assert!(joined > 20, "{joined} edges that fall together");
}
