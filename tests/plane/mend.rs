//! Promise: polygons that overlap, touch or cross become a subdivision whose faces know the polygons that cover them:
//! what their outer ring goes round an odd number of times, and no inner ring does; the inner rings by themselves, where
//! the outer ring goes round nothing.

use crate::numbers::Numbers;
use dcel_kit::FaceId;
use dcel_kit::plane::{ConvertError, ConvertOptions, Location, Mended, Point, Subdivision};
use dcel_kit::topology::{PolygonList, components, violations};

/// The points and polygons of rings of coordinates: equal points are one.
pub(crate) fn soup(polygons: &[Vec<Vec<(f64, f64)>>]) -> (Vec<Point>, PolygonList) {
    let (mut points, mut list): (Vec<Point>, _) = (Vec::new(), PolygonList::default());
    for rings in polygons {
        for (i, ring) in rings.iter().enumerate() {
            let mut number = |&p: &(f64, f64)| {
                let p = Point::from(p);
                points.iter().position(|&q| q == p).unwrap_or_else(|| {
                    points.push(p);
                    points.len() - 1
                }) as u32
            };
            let corners: Vec<u32> = ring.iter().map(&mut number).collect();
            if i == 0 { list.push_face(&corners) } else { list.push_hole(&corners) }
        }
    }
    (points, list)
}

fn mended(polygons: &[Vec<Vec<(f64, f64)>>]) -> Mended {
    let (points, list) = soup(polygons);
    let mended = Subdivision::mend_polygons(&points, &list).unwrap();
    let s = &mended.subdivision;
    assert_eq!((violations(s), s.geometry_violations()), (vec![], vec![]), "{polygons:?}");
    let (v, e, f) = (s.vertex_count() as i64, s.edge_count() as i64, s.face_count() as i64);
    assert_eq!(v - e + f, 1 + components(s).count() as i64, "{polygons:?}");
    mended
}

/// Whether the ring goes round the point an odd number of times, by a ray to the right.
fn odd(ring: &[(f64, f64)], p: Point) -> bool {
    let mut inside = false;
    for (i, &(ax, ay)) in ring.iter().enumerate() {
        let (bx, by) = ring[(i + 1) % ring.len()];
        if (ay > p.y) != (by > p.y) && p.x < (bx - ax) * (p.y - ay) / (by - ay) + ax {
            inside = !inside;
        }
    }
    inside
}

fn covers(rings: &[Vec<(f64, f64)>], outer_is_flat: bool, p: Point) -> bool {
    if outer_is_flat {
        return rings[1..].iter().filter(|ring| odd(ring, p)).count() % 2 == 1;
    }
    odd(&rings[0], p) && !rings[1..].iter().any(|ring| odd(ring, p))
}

/// Whether the ring goes round nothing, up to rounding.
fn is_flat(ring: &[(f64, f64)]) -> bool {
    area_by_strips(&[ring.to_vec()], |p| odd(ring, p)) < 1e-12
}

/// The area of what is covered, by strips between all upright lines through corners and crossings of the sides: in
/// a strip what a line cuts out grows evenly.
fn area_by_strips(rings: &[Vec<(f64, f64)>], covers: impl Fn(Point) -> bool) -> f64 {
    let sides: Vec<[(f64, f64); 2]> =
        rings.iter().flat_map(|ring| (0..ring.len()).map(move |i| [ring[i], ring[(i + 1) % ring.len()]])).collect();
    let mut cuts: Vec<f64> = sides.iter().map(|side| side[0].0).collect();
    for (i, &[a, b]) in sides.iter().enumerate() {
        for &[c, d] in &sides[..i] {
            let w = (b.0 - a.0) * (d.1 - c.1) - (b.1 - a.1) * (d.0 - c.0);
            let t = ((c.0 - a.0) * (d.1 - c.1) - (c.1 - a.1) * (d.0 - c.0)) / w;
            if w != 0.0 && (0.0..=1.0).contains(&t) {
                cuts.push(a.0 + t * (b.0 - a.0));
            }
        }
    }
    cuts.sort_by(f64::total_cmp);
    let mut area = 0.0;
    for strip in cuts.windows(2).filter(|strip| strip[1] - strip[0] > 1e-12) {
        let x = (strip[0] + strip[1]) / 2.0;
        let crossed = |&&[a, b]: &&[(f64, f64); 2]| (a.0 > x) != (b.0 > x);
        let mut heights: Vec<f64> =
            sides.iter().filter(crossed).map(|&[a, b]| a.1 + (b.1 - a.1) * (x - a.0) / (b.0 - a.0)).collect();
        heights.sort_by(f64::total_cmp);
        for pair in heights.windows(2).filter(|pair| pair[1] > pair[0]) {
            if covers(Point::new(x, (pair[0] + pair[1]) / 2.0)) {
                area += (pair[1] - pair[0]) * (strip[1] - strip[0]);
            }
        }
    }
    area
}

pub(crate) fn area(s: &Subdivision, f: FaceId) -> f64 {
    let cross = |h| {
        let (p, q) = (s.point(s.origin(h)), s.point(s.destination(h)));
        p.x * q.y - p.y * q.x
    };
    s.cycles(f).flat_map(|h| s.cycle(h)).map(cross).sum::<f64>() / 2.0
}

/// Labels and areas against those found without the kit.
pub(crate) fn check(polygons: &[Vec<Vec<(f64, f64)>>], next: &mut Numbers, context: &str) {
    let mended = mended(polygons);
    let s = &mended.subdivision;
    let mut areas = vec![0.0; polygons.len()];
    for f in s.faces().filter(|&f| f != s.outer_face()) {
        let over = mended.cover.polygons(f);
        assert_eq!(over.len(), mended.cover.count(f) as usize, "{context}: {f}");
        assert_eq!(over.is_empty(), s.is_hole(f), "{context}: {f}");
        over.iter().for_each(|&i| areas[i as usize] += area(s, f));
    }
    assert!(mended.cover.polygons(s.outer_face()).is_empty(), "{context}");
    // Of a ring no wider than the last places of its corners rounding says whether it goes round anything.
    let is_whole = |ring: &Vec<(f64, f64)>| ring.iter().all(|p| p.0.fract() == 0.0 && p.1.fract() == 0.0);
    let is_hollow = |i: usize| is_whole(&polygons[i][0]) || mended.hollow.contains(&(i as u32));
    let flat: Vec<bool> = (0..polygons.len()).map(|i| is_flat(&polygons[i][0]) && is_hollow(i)).collect();
    for (i, rings) in polygons.iter().enumerate() {
        let expected = area_by_strips(rings, |p| covers(rings, flat[i], p));
        assert!((areas[i] - expected).abs() <= 1e-11 * expected.max(1.0), "{context}: {i}: {} {expected}", areas[i]);
    }
    for e in s.edges() {
        let [left, right] = e.half_edges().map(|h| mended.cover.polygons(s.face(h)));
        let apart = |i: &u32| left.contains(i) != right.contains(i);
        let all: Vec<u32> = (0..polygons.len() as u32).filter(apart).collect();
        assert_eq!(mended.outlines(e), all, "{context}: {e}");
        assert!(!all.is_empty(), "{context}: {e} bounds nothing");
    }
    for _ in 0..20 {
        let p = Point::new(next.below(1 << 20) as f64 / 87381.0, next.below(1 << 20) as f64 / 87381.0);
        let Location::Face(f) = s.locate(p) else { continue };
        let is_over = |&i: &u32| covers(&polygons[i as usize], flat[i as usize], p);
        let expected: Vec<u32> = (0..polygons.len() as u32).filter(is_over).collect();
        assert_eq!(mended.cover.polygons(f), expected, "{context}: {p}");
    }
}

/// Up to four polygons with up to three rings of up to seven corners on a grid of this many lines: they overlap, run
/// along each other, cross themselves, and have spikes and rings without area.
fn random_soup(next: &mut Numbers, lines: u64) -> Vec<Vec<Vec<(f64, f64)>>> {
    let step = 12.0 / lines as f64;
    (0..1 + next.below(4))
        .map(|_| {
            let mut ring = || -> Vec<(f64, f64)> {
                let mut at = || next.below(lines) as f64 * step;
                (0..3 + (at() / step) as u64 % 5).map(|_| (at(), at())).collect()
            };
            let count = 1 + (ring()[0].0 / step) as usize % 3;
            (0..count).map(|_| ring()).collect()
        })
        .collect()
}

#[test]
fn random_soups_cover_what_their_polygons_cover() {
    for seed in 1..=600_u64 {
        let mut next = Numbers::new(seed);
        // Few lines make many corners on sides and common borders; many lines crossings that have to be rounded.
        let lines = [4, 6, 13, 1000][seed as usize % 4];
        let polygons = random_soup(&mut next, lines);
        check(&polygons, &mut next, &format!("seed {seed}: {polygons:?}"));
    }
}

#[test]
fn far_from_the_origin_nothing_is_mislabelled() {
    for seed in 1..=60_u64 {
        let mut next = Numbers::new(seed);
        let polygons = random_soup(&mut next, 7);
        let far = |rings: &Vec<Vec<(f64, f64)>>| -> Vec<Vec<(f64, f64)>> {
            rings.iter().map(|ring| ring.iter().map(|&(x, y)| (x + 4e9 + 0.1, y - 3e9 + 0.7)).collect()).collect()
        };
        let moved: Vec<_> = polygons.iter().map(far).collect();
        let (here, there) = (mended(&polygons), mended(&moved));
        // Rounded crossings may join or part faces, but each polygon still has its area.
        for i in 0..polygons.len() as u32 {
            let of = |m: &Mended, shift: (f64, f64)| -> f64 {
                let s = &m.subdivision;
                let cross = |h| {
                    let (p, q) = (s.point(s.origin(h)), s.point(s.destination(h)));
                    (p.x - shift.0) * (q.y - shift.1) - (p.y - shift.1) * (q.x - shift.0)
                };
                let covered = s.faces().filter(|&f| m.cover.polygons(f).contains(&i));
                covered.flat_map(|f| s.cycles(f)).flat_map(|h| s.cycle(h)).map(cross).sum::<f64>() / 2.0
            };
            let (a, b) = (of(&here, (0.0, 0.0)), of(&there, (4e9, -3e9)));
            assert!((a - b).abs() < 1e-3, "seed {seed}: polygon {i}: {a} here, {b} there");
        }
    }
}

#[test]
fn a_hole_that_sticks_out_cuts_off_and_adds_nothing() {
    let shell = vec![(10., 90.), (60., 90.), (60., 10.), (10., 10.)];
    let hole = vec![(30., 70.), (90., 70.), (90., 30.), (30., 30.)];
    let cut = mended(&[vec![shell.clone(), hole.clone()]]);
    let bounded: Vec<f64> = cut.subdivision.faces().skip(1).map(|f| area(&cut.subdivision, f)).collect();
    assert_eq!((bounded, cut.left_out), (vec![2800.0], 4), "the part of the hole outside is left out");
    // As two polygons the same rings cover three faces, one of them twice.
    let two = mended(&[vec![shell], vec![hole]]);
    assert_eq!((two.subdivision.face_count(), two.left_out), (4, 0));
}

#[test]
fn a_bow_tie_is_two_triangles_and_a_pentagram_has_a_hole() {
    let tie = mended(&[vec![vec![(0., 0.), (4., 4.), (4., 0.), (0., 4.)]]]);
    assert_eq!((tie.crossings.len(), tie.subdivision.face_count()), (1, 3));
    assert_eq!(tie.subdivision.point(tie.crossings[0]), Point::new(2., 2.));
    let star = [(0., 3.), (2., -3.), (-3., 1.), (3., 1.), (-2., -3.)];
    let star = mended(&[vec![star.to_vec()]]);
    let s = &star.subdivision;
    assert_eq!((s.face_count(), s.hole_faces().count()), (7, 1), "five tips, the middle, and f0");
}

#[test]
fn spikes_and_rings_without_area_vanish() {
    let spike = mended(&[vec![vec![(0., 0.), (9., 0.), (4., 0.), (4., 4.), (4., 7.), (4., 4.), (0., 4.)]]]);
    let s = &spike.subdivision;
    assert_eq!((s.vertex_count(), s.face_count(), spike.left_out), (4, 2, 2));
    let flat = mended(&[vec![vec![(0., 0.), (2., 2.), (5., 5.)]]]);
    assert_eq!((flat.subdivision.edge_count(), flat.cover.count(flat.subdivision.outer_face())), (0, 0));
}

#[test]
fn inner_rings_of_an_outer_ring_that_encloses_nothing_are_outlines() {
    // As the Antarctica of a well-known map: the line along the pole is the outer ring, the coast a hole of it.
    let pole = vec![(-180., -90.), (180., -90.), (0., -90.)];
    let coast = vec![(-180., -90.), (-180., -70.), (180., -70.), (180., -90.)];
    let lake = vec![(0., -80.), (9., -80.), (9., -75.)];
    let land = mended(&[vec![pole.clone(), coast, lake.clone()], vec![lake]]);
    let s = &land.subdivision;
    let covered: Vec<_> = s.faces().skip(1).map(|f| (area(s, f), land.cover.polygons(f))).collect();
    assert_eq!(land.hollow, [0]);
    assert_eq!(covered, [(7200. - 22.5, vec![0]), (22.5, vec![1])], "even-odd: the lake is not covered twice");
    let nothing = mended(&[vec![pole.clone(), pole]]);
    assert_eq!((nothing.subdivision.edge_count(), nothing.hollow), (0, vec![]));
}

#[test]
fn a_pile_of_polygons_takes_no_more_room_than_polygons_apart() {
    // Each inside the one before: the face in the middle is covered by all of them.
    let n = 1500;
    let square = |i: usize| {
        let (low, high) = (i as f64, (2 * n - i) as f64);
        vec![vec![(low, low), (high, low), (high, high), (low, high)]]
    };
    let (mut points, mut list) = (Vec::new(), PolygonList::default());
    for i in 0..n {
        list.push_face(&[0, 1, 2, 3].map(|k| 4 * i as u32 + k));
        points.extend(square(i)[0].iter().map(|&p| Point::from(p)));
    }
    let pile = Subdivision::mend_polygons(&points, &list).unwrap();
    let s = &pile.subdivision;
    assert_eq!(s.face_count(), n + 1);
    let Location::Face(middle) = s.locate(Point::new(n as f64, n as f64)) else { panic!("a face") };
    assert_eq!(pile.cover.polygons(middle), (0..n as u32).collect::<Vec<_>>());
    let mut met = 0;
    pile.cover.visit(|f, over| {
        met += 1;
        assert_eq!(over.len(), pile.cover.count(f) as usize);
    });
    assert_eq!(met, n + 1);
}

#[test]
fn corners_inside_sides_are_inserted_where_that_is_all() {
    let insert = ConvertOptions { orient: true, insert_touching: true, ..ConvertOptions::default() };
    let square = |x: f64, y: f64, side: f64| vec![(x, y), (x + side, y), (x + side, y + side), (x, y + side)];
    // A long side with two short ones along it, a tip on a side, a hole that touches.
    let hole = vec![(0., 1.), (2., 3.), (3., 1.)];
    let polygons = [
        vec![square(0., 0., 4.), hole],
        vec![square(4., 0., 2.)],
        vec![square(4., 2., 2.)],
        vec![vec![(3., 4.), (5., 6.), (1., 6.)]],
    ];
    let (points, list) = soup(&polygons);
    let converted = Subdivision::convert_polygons(points.clone(), &list, &insert).unwrap();
    let s = &converted.subdivision;
    assert_eq!((violations(s), s.geometry_violations()), (vec![], vec![]));
    let inserted: Vec<_> = converted.inserted.iter().map(|c| (c.face, c.cycle, points[c.vertex as usize])).collect();
    let expected = [(0, 0, (4., 2.)), (0, 0, (3., 4.)), (0, 0, (0., 1.))].map(|(f, c, p)| (f, c, Point::from(p)));
    assert_eq!(inserted, expected, "in the order of the sides");
    assert_eq!((s.vertex_count(), s.face_count()), (points.len(), 6), "f0, four polygons, the hole");
    // Without the option the same polygons are refused, and by what is wrong: nothing overlaps.
    let full = ConvertOptions { insert_touching: false, full_check: true, ..insert };
    let error = Subdivision::convert_polygons(points, &list, &full).unwrap_err();
    assert!(matches!(error, ConvertError::Geometry(_)), "{error}");
}

#[test]
fn what_overlaps_or_touches_itself_is_not_helped_by_corners() {
    let insert = ConvertOptions { orient: true, insert_touching: true, ..ConvertOptions::default() };
    let refused = |polygons: &[Vec<Vec<(f64, f64)>>]| {
        let (points, list) = soup(polygons);
        Subdivision::convert_polygons(points, &list, &insert).unwrap_err()
    };
    // A corner of the ring on one of its own sides; a square on the inner side of a square; one that crosses; a hole
    // from side to side.
    let own = vec![(0., 0.), (4., 0.), (4., 4.), (2., 0.), (0., 4.)];
    assert!(matches!(refused(&[vec![own]]), ConvertError::Build(_) | ConvertError::SelfTouching { .. }));
    let square = vec![(0., 0.), (4., 0.), (4., 4.), (0., 4.)];
    let inside = vec![(1., 0.), (2., 0.), (2., 2.), (1., 2.)];
    let error = refused(&[vec![square.clone()], vec![inside]]);
    assert!(matches!(error, ConvertError::OverlapAtEdge { .. }), "{error}");
    let across = vec![(2., 2.), (6., 2.), (6., 3.), (2., 3.)];
    assert!(matches!(refused(&[vec![square.clone()], vec![across]]), ConvertError::Geometry(_)));
    let through = vec![(1., 0.), (2., 4.), (3., 0.5)];
    assert!(matches!(refused(&[vec![square, through]]), ConvertError::InPieces { .. }));
}

#[test]
fn no_corner_is_inserted_where_sides_cross_as_well() {
    let insert = ConvertOptions { insert_touching: true, full_check: true, ..ConvertOptions::default() };
    // A tip on the long side, and further to the right two polygons that cross.
    let polygons = [
        vec![vec![(0., 0.), (20., 0.), (20., 4.), (0., 4.)]],
        vec![vec![(2., 4.), (3., 6.), (1., 6.)]],
        vec![vec![(10., 2.), (12., 2.), (12., 8.), (10., 8.)]],
    ];
    let convert = |polygons: &[Vec<Vec<(f64, f64)>>], options: &ConvertOptions| {
        let (points, list) = soup(polygons);
        Subdivision::convert_polygons(points, &list, options)
    };
    assert_eq!(convert(&polygons[..2], &insert).expect("the tip is all").inserted.len(), 1);
    let plain = ConvertOptions { insert_touching: false, ..insert };
    assert_eq!(convert(&polygons, &insert), convert(&polygons, &plain), "refused by the names of what was given");
}
