//! Promise: areas are those of the exact corners, rounded once, wherever the shape lies. Judged by whole numbers of any
//! size.

use crate::exact::{Whole, unit, whole};
use crate::numbers::Numbers;
use dcel_kit::FaceId;
use dcel_kit::plane::{ArrangeOptions, Operation, Parts, Point, Subdivision};
use num_bigint::BigInt;

const SPLIT: ArrangeOptions = ArrangeOptions { merge: true, split: true, grid: None, most_faults: 100 };

fn split(segments: &[[Point; 2]]) -> Subdivision {
    Subdivision::arrange_segments(segments, &SPLIT).unwrap().subdivision
}

/// Whether `area` is the sum over the faces to 2^-50 of it, which is far more than promised.
fn is_right(s: &Subdivision, faces: &[FaceId], area: f64) -> bool {
    let unit = unit(s.vertices().flat_map(|v| [s.point(v).x, s.point(v).y]));
    let mut twice = BigInt::ZERO;
    for h in faces.iter().flat_map(|&f| s.cycles(f)).flat_map(|h| s.cycle(h)) {
        let [p, q] = [s.origin(h), s.destination(h)].map(|v| Whole::new(s.point(v), unit));
        twice += p.x * q.y - p.y * q.x;
    }
    // The area in units of 2^(2 unit), with room below.
    let room = 80;
    let said = whole(2.0 * area, 2 * unit - room);
    let off = (twice.clone() << room as usize) - said;
    let off = if off < BigInt::ZERO { -off } else { off };
    (off << 50_usize) <= (twice << room as usize)
}

#[test]
fn areas_are_right_wherever_the_shape_lies() {
    let mut thin = 0;
    for seed in 0..400 {
        let mut next = Numbers::new(seed + 40);
        let offset = [0.0, 1.0, 5.5e6, -1e9, 1e15, 1e-15][next.below(6) as usize];
        let size = [1.0, 0.1, 1e-6, 1e3][next.below(4) as usize];
        let flat = [1.0, 1.0, 1e-9][next.below(3) as usize];
        let mut at = || Point::new(offset + size * next.unit(), 0.3 * offset + size * flat * next.unit());
        let segments: Vec<[Point; 2]> = (0..8).map(|_| [at(), at()]).filter(|[a, b]| a != b).collect();
        let s = split(&segments);
        let bounded: Vec<FaceId> = s.faces().filter(|&f| f != s.outer_face()).collect();
        for &f in &bounded {
            let area = s.area(f);
            assert!(area > 0.0 && is_right(&s, &[f], area), "seed {seed}: {f} has {area:e}");
            thin += usize::from(area < 1e-12 * offset * offset);
        }
        assert!(is_right(&s, &bounded, s.domain_area()), "seed {seed}");
        assert_eq!(s.area(s.outer_face()), f64::INFINITY);
    }
    assert!(thin > 100, "{thin} faces that plain sums get wrong: an easy test");
}

/// `defects/h1.json`
#[test]
fn a_square_of_ten_centimetres_far_from_the_origin_keeps_its_area() {
    let corners = [(4000000.0, 5500000.0), (4000000.1, 5500000.0), (4000000.1, 5500000.1), (4000000.0, 5500000.1)];
    let corners = corners.map(Point::from);
    let square = Subdivision::from_graph(&corners, &[[0, 1], [1, 2], [2, 3], [3, 0]]).unwrap();
    // What the doubles next to these numbers span.
    let side = [4000000.1_f64 - 4000000.0, 5500000.1_f64 - 5500000.0];
    let both = square.overlay(&square).unwrap();
    let union = both.region(Operation::Union, Parts::Joined).unwrap();
    assert_eq!(Some(union.domain_area()), Some(side[0] * side[1]));
    assert!((union.domain_area() - 0.01).abs() < 1e-9);
}

#[test]
fn hole_faces_and_rings_do_not_count() {
    let square = |x: f64, y: f64, r: f64| {
        let c = [(x - r, y - r), (x + r, y - r), (x + r, y + r), (x - r, y + r)].map(Point::from);
        [[c[0], c[1]], [c[1], c[2]], [c[2], c[3]], [c[3], c[0]]]
    };
    let mut segments = [square(1e7, 0.0, 4.0), square(1e7, 0.0, 2.0), square(1e7, 0.0, 1.0)].concat();
    // An edge in a face, and one that hangs on a corner: no area.
    segments.push([Point::new(1e7, 0.1), Point::new(1e7 + 0.5, 0.2)]);
    segments.push([Point::new(1e7 + 4.0, 4.0), Point::new(1e7 + 9.0, 5.0)]);
    let mut s = Subdivision::from_segments(&segments).unwrap();
    let areas: Vec<f64> = s.faces().skip(1).map(|f| s.area(f)).collect();
    assert_eq!(areas, vec![48.0, 12.0, 4.0]);
    s.mark_holes(&[Point::new(1e7 + 1.5, 0.0)]).unwrap();
    assert_eq!(Some(s.domain_area()), Some(52.0));
    assert_eq!(Subdivision::new().domain_area(), 0.0);
}
