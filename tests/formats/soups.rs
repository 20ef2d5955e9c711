//! Polygons as a file gives them: faces turned up, rings counted that were mended.

use crate::support::{Random, soup};
use dcel_kit::io::{Document, Format, ReadOptions, read_bytes};
use dcel_kit::plane::Point;
use dcel_kit::plane::predicates::orientation;
use std::fmt::Write as _;

/// Triangles a few last places high, a million from the origin: the sum of cross products loses their sign.
#[test]
fn thin_faces_far_away_are_turned_up_exactly() {
    const TRIANGLES: usize = 2000;
    let mut random = Random::new(20);
    let mut text = String::new();
    for i in 0..TRIANGLES {
        let place = 1e6 + i as f64;
        let mut bump = || random.below(4) as f64 * place * f64::EPSILON;
        let [a, b, c] = [place + bump(), place + bump(), place + bump()];
        let n = 3 * i;
        write!(text, "v {a} {a}\nv {b} {}\nv {c} {}\n", b + 0.5, c + 1.5).expect("in memory");
        writeln!(text, "f {} {} {}", n + 1, n + 2, n + 3).expect("in memory");
    }
    let given = soup(text.as_bytes(), Format::Obj);
    let mut turned = given.clone();
    turned.turn_up();
    let at = |v: u32| Point::new(given.points[v as usize][0], given.points[v as usize][1]);
    let (mut changed, mut misled) = (0, 0);
    for f in 0..TRIANGLES {
        let [before, after] = [&given, &turned].map(|soup| soup.faces.cycle(soup.faces.cycle_range(f).start));
        let corners = |ring: &[u32]| [at(ring[0]), at(ring[1]), at(ring[2])];
        let [a, b, c] = corners(after);
        assert!(orientation(a, b, c).is_ge(), "face {f} still faces down");
        let [a, b, c] = corners(before);
        let down = orientation(a, b, c).is_lt();
        let reversed: Vec<u32> = before.iter().rev().copied().collect();
        assert_eq!(after, if down { reversed.as_slice() } else { before }, "face {f}");
        let sum: f64 = [(a, b), (b, c), (c, a)].map(|(p, q)| p.x * q.y - p.y * q.x).iter().sum();
        changed += usize::from(down);
        misled += usize::from((sum < 0.0) != down);
    }
    assert!(changed > 100 && misled > 100, "the triangles are too easy: {changed} face down, {misled} mislead a sum");
}

#[test]
fn rings_that_were_closed_or_dropped_are_counted() {
    let text = br#"{"type": "MultiPolygon", "coordinates": [
        [[[0, 0], [4, 0], [0, 4]]],
        [[[9, 9], [9, 9], [9, 9]]],
        [[[5, 0], [9, 0], [5, 4], [5, 0]]]]}"#;
    let options = |mend| ReadOptions { close_rings: mend, drop_degenerate_rings: mend, ..ReadOptions::default() };
    let read = read_bytes(text, Format::GeoJson, "map", &options(true)).expect("mended");
    assert_eq!(read.mended_rings(), 2, "{:?}", read.notes);
    let outlines = ReadOptions { outlines: true, ..options(true) };
    let read = read_bytes(text, Format::GeoJson, "map", &outlines).expect("mended");
    assert!(matches!(read.document, Document::Segments(_)));
    assert_eq!(read.mended_rings(), 1, "{:?}", read.notes);
    let whole = br#"{"type": "Polygon", "coordinates": [[[0, 0], [4, 0], [0, 4], [0, 0]]]}"#;
    let read = read_bytes(whole, Format::GeoJson, "map", &options(true)).expect("whole");
    assert_eq!(read.mended_rings(), 0);
}
