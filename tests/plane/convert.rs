//! Promise: any list of triangles or polygons becomes the subdivision that its edges cut out, or is refused with
//! an error that names the elements.

use crate::tracer::{Face, Numbers, assert_traced, canonical, faces_of};
use dcel_kit::plane::{ConvertError, ConvertOptions, GeometryViolation, Point, Subdivision};
use dcel_kit::topology::{BuildError, PolygonList};
use dcel_kit::{FaceId, VertexId};
use std::collections::BTreeSet;

fn points(list: &[(i32, i32)]) -> Vec<Point> {
    list.iter().map(|&(x, y)| Point::new(f64::from(x), f64::from(y))).collect()
}

/// Some triangles of a grid of cells, each cut by one of its diagonals, in random order.
fn holey_grid(numbers: &mut Numbers, width: usize, height: usize, percent: usize) -> (Vec<Point>, Vec<[u32; 3]>) {
    let at = |x: usize, y: usize| (y * (width + 1) + x) as u32;
    let grid: Vec<Point> =
        (0..=height).flat_map(|y| (0..=width).map(move |x| Point::new(x as f64, y as f64))).collect();
    let mut triangles = Vec::new();
    for y in 0..height {
        for x in 0..width {
            let [a, b, c, d] = [at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)];
            let pair = if numbers.below(2) == 0 { [[a, b, c], [a, c, d]] } else { [[a, b, d], [b, c, d]] };
            for mut triangle in pair {
                if numbers.below(100) < percent {
                    triangle.rotate_left(numbers.below(3));
                    let place = numbers.below(triangles.len() + 1);
                    triangles.insert(place, triangle);
                }
            }
        }
    }
    (grid, triangles)
}

#[test]
fn random_holey_grids_become_what_their_edges_cut_out() {
    for seed in 1..500 {
        let mut numbers = Numbers::new(seed);
        let (w, h, percent) = (1 + numbers.below(7), 1 + numbers.below(7), 20 + numbers.below(80));
        let (grid, triangles) = holey_grid(&mut numbers, w, h, percent);
        let s = Subdivision::from_triangles(grid, &triangles).unwrap();
        assert_traced(&s, &format!("seed {seed}"));
        let (_, faces) = faces_of(&s);
        let given: BTreeSet<Face> = triangles.iter().map(|t| Face::from([canonical(t)])).collect();
        for (face, number) in faces {
            let id = FaceId::new(number);
            assert_eq!(s.is_hole(id), !given.contains(&face), "seed {seed}: {id}");
            if !s.is_hole(id) {
                assert_eq!(face, Face::from([canonical(&triangles[number as usize - 1])]), "seed {seed}: {id}");
            }
        }
    }
}

/// Random regions of cells as polygons with holes, and the number of cells of each. Cells with label 0 are left
/// out. `None` if a cycle passes a corner twice.
fn regions(numbers: &mut Numbers, width: usize, height: usize) -> Option<(PolygonList, Vec<usize>)> {
    let labels: Vec<usize> = (0..width * height).map(|_| [0, 0, 2, 1, 1, 1, 1, 1][numbers.below(8)]).collect();
    let corner = |x: usize, y: usize| (y * (width + 1) + x) as u32;
    let mut region = vec![usize::MAX; width * height];
    let (mut list, mut sizes) = (PolygonList::new(), Vec::new());
    for start in 0..labels.len() {
        if labels[start] == 0 || region[start] != usize::MAX {
            continue;
        }
        let (number, mut cells) = (sizes.len(), vec![start]);
        region[start] = number;
        let mut sides: Vec<[u32; 2]> = Vec::new();
        let mut i = 0;
        while i < cells.len() {
            let (x, y) = (cells[i] % width, cells[i] / width);
            let around = [(0, -1), (1, 0), (0, 1), (-1, 0)];
            let corners = [corner(x, y), corner(x + 1, y), corner(x + 1, y + 1), corner(x, y + 1)];
            for (k, (dx, dy)) in around.into_iter().enumerate() {
                let other = x.checked_add_signed(dx).zip(y.checked_add_signed(dy));
                match other.filter(|&(x, y)| x < width && y < height).map(|(x, y)| y * width + x) {
                    Some(cell) if labels[cell] == labels[start] => {
                        if region[cell] == usize::MAX {
                            region[cell] = number;
                            cells.push(cell);
                        }
                    }
                    _ => sides.push([corners[k], corners[(k + 1) % 4]]),
                }
            }
            i += 1;
        }
        sizes.push(cells.len());
        let mut cycles: Vec<Vec<u32>> = Vec::new();
        while let Some([from, mut at]) = sides.pop() {
            let mut cycle = vec![from];
            while at != from {
                if cycle.contains(&at) || sides.iter().filter(|s| s[0] == at).count() != 1 {
                    return None;
                }
                cycle.push(at);
                let next = sides.iter().position(|s| s[0] == at)?;
                at = sides.swap_remove(next)[1];
            }
            cycles.push(cycle);
        }
        // The outer cycle has the lowest, leftmost corner.
        let outer = (0..cycles.len()).min_by_key(|&i| cycles[i].iter().min())?;
        list.push_face(&cycles.swap_remove(outer));
        cycles.iter().for_each(|c| list.push_hole(c));
    }
    Some((list, sizes))
}

#[test]
fn random_regions_with_holes_and_islands_become_what_their_edges_cut_out() {
    let (mut cases, mut with_holes) = (0, 0);
    for seed in 1..6_000 {
        let mut numbers = Numbers::new(seed);
        let (w, h) = (2 + numbers.below(5), 2 + numbers.below(5));
        let Some((list, sizes)) = regions(&mut numbers, w, h) else { continue };
        cases += 1;
        with_holes += usize::from(!list.has_no_holes());
        let grid: Vec<Point> = (0..=h).flat_map(|y| (0..=w).map(move |x| Point::new(x as f64, y as f64))).collect();
        let s = Subdivision::from_polygons(grid, &list).unwrap_or_else(|error| panic!("seed {seed}: {error}"));
        assert_traced(&s, &format!("seed {seed}"));
        for (i, &size) in sizes.iter().enumerate() {
            let area = |h| -> f64 {
                let corners: Vec<Point> = s.cycle(h).map(|h| s.point(s.origin(h))).collect();
                corners.iter().zip(corners.iter().cycle().skip(1)).map(|(p, q)| (p.x * q.y - p.y * q.x) / 2.0).sum()
            };
            let total: f64 = s.cycles(FaceId::new(i as u32 + 1)).map(area).sum();
            assert!((total - size as f64).abs() < 1e-9, "seed {seed}: face {i} has area {total}, not {size}");
        }
        assert_eq!(s.face_count() - 1 - s.hole_faces().count(), sizes.len(), "seed {seed}");
    }
    assert!(cases > 1000 && with_holes > 100, "{cases} cases, {with_holes} with holes");
}

#[test]
fn a_hole_that_touches_the_outer_cycle_makes_one_cycle() {
    let p = points(&[(0, 0), (6, 0), (6, 6), (0, 6), (2, 1), (2, 2)]);
    let mut list = PolygonList::new();
    list.push_face(&[0, 1, 2, 3]);
    list.push_hole(&[0, 5, 4]);
    let s = Subdivision::from_polygons(p, &list).unwrap();
    assert_traced(&s, "touching hole");
    assert_eq!((s.face_count(), s.cycles(FaceId::new(1)).count()), (3, 1));
    assert_eq!(s.incident_half_edges(FaceId::new(1)).count(), 7);
    assert!(s.is_hole(FaceId::new(2)));
}

#[test]
fn two_triangles_that_touch_at_a_corner_have_one_border() {
    let p = points(&[(0, 0), (2, -1), (2, 1), (-2, 1), (-2, -1)]);
    let s = Subdivision::from_triangles(p, &[[0, 1, 2], [0, 3, 4]]).unwrap();
    assert_traced(&s, "bow of two");
    assert_eq!(s.cycles(s.outer_face()).count(), 1);
    assert_eq!(s.degree(VertexId::new(0)), 4);
}

#[test]
fn a_list_without_faces_is_the_empty_plane() {
    let converted = Subdivision::convert_triangles(points(&[(0, 0), (1, 1)]), &[], &ConvertOptions::default()).unwrap();
    assert_eq!(converted.unused_vertices, [VertexId::new(0), VertexId::new(1)]);
    let s = converted.subdivision;
    assert_eq!((s.vertex_count(), s.edge_count(), s.face_count()), (0, 0, 1));
    assert_eq!(s.half_edge(s.outer_face()), None);
    assert_eq!(s.domain_area().to_bits(), 0.0_f64.to_bits(), "not -0");
    assert_eq!(s.geometry_violations(), []);
}

#[test]
fn orientation_is_refused_or_repaired() {
    let p = points(&[(0, 0), (2, 0), (2, 2), (0, 2), (5, 5), (6, 5), (6, 6)]);
    let mixed = [[0, 1, 2], [0, 3, 2]];
    assert_eq!(
        Subdivision::from_triangles(p.clone(), &mixed),
        Err(BuildError::MixedWinding { u: 2, v: 0, first: 0, second: 1 }.into())
    );
    let apart = [[0, 1, 2], [4, 6, 5]];
    assert_eq!(Subdivision::from_triangles(p.clone(), &apart), Err(ConvertError::Clockwise { face: 1, all: false }));
    assert_eq!(
        Subdivision::from_triangles(p.clone(), &[[0, 2, 1], [4, 6, 5]]),
        Err(ConvertError::Clockwise { face: 0, all: true })
    );
    let orient = ConvertOptions { orient: true, ..Default::default() };
    for (list, turned) in [(mixed, [1]), (apart, [1])] {
        let converted = Subdivision::convert_triangles(p.clone(), &list, &orient).unwrap();
        assert_eq!(converted.turned, turned);
        assert_traced(&converted.subdivision, "repaired");
    }
    // An inner cycle may run either way; a clockwise outer one is turned with its face.
    let q = points(&[(0, 0), (6, 0), (6, 6), (0, 6), (2, 2), (4, 2), (3, 4)]);
    for hole in [[4, 5, 6], [4, 6, 5]] {
        let mut list = PolygonList::new();
        list.push_face(&[0, 1, 2, 3]);
        list.push_hole(&hole);
        assert_traced(&Subdivision::from_polygons(q.clone(), &list).unwrap(), "hole either way");
        let mut list = PolygonList::new();
        list.push_face(&[3, 2, 1, 0]);
        list.push_hole(&hole);
        let converted = Subdivision::convert_polygons(q.clone(), &list, &orient).unwrap();
        assert_eq!(converted.turned, [0]);
        assert_traced(&converted.subdivision, "turned with a hole");
    }
}

/// What must be refused, and the exact error.
/// Two bands that have a square in common and cross once more over each other: a torus with one disc cut out, flat at
/// every corner. No edge and no corner betrays it, Euler's relation does.
#[test]
fn bands_that_cross_are_refused_without_the_full_check() {
    let square = [(0, 0), (2, 0), (2, 2), (0, 2)];
    let first = [[(6, 0), (4, 2)], [(6, 8), (4, 6)], [(-4, 8), (-2, 6)], [(-4, 0), (-2, 2)]];
    let second = [[(2, 10), (0, 12)], [(8, 10), (10, 12)], [(8, -4), (10, -6)], [(2, -4), (0, -6)]];
    let mut places = square.to_vec();
    places.extend(first.iter().chain(&second).flatten());
    let mut list = PolygonList::new();
    list.push_face(&[0, 1, 2, 3]);
    for [start, sides, end] in [[[1, 2], [4, 6], [0, 3]], [[2, 3], [12, 14], [1, 0]]] {
        let mut rungs = vec![start];
        rungs.extend((0..4).map(|k| [sides[0] + 2 * k, sides[0] + 2 * k + 1]));
        rungs.push(end);
        rungs.windows(2).for_each(|w| list.push_face(&[w[0][0], w[1][0], w[1][1], w[0][1]]));
    }
    places.extend([(100, 0), (101, 0), (100, 1)]);
    let mut two_components = list.clone();
    two_components.push_face(&[20, 21, 22]);
    for list in [list, two_components] {
        let open = ConvertOptions::default();
        let error = Subdivision::convert_polygons(points(&places), &list, &open).unwrap_err();
        let ConvertError::Geometry(GeometryViolation::EdgesMeet { .. }) = error else { panic!("{error}") };
    }
}

#[test]
fn every_refusal_names_its_elements() {
    let p = |list: &[(i32, i32)]| points(list);
    let polygon = |cycles: &[&[u32]]| {
        let mut list = PolygonList::new();
        list.push_face(cycles[0]);
        cycles[1..].iter().for_each(|c| list.push_hole(c));
        list
    };
    let square = [(0, 0), (4, 0), (4, 4), (0, 4)];
    let refused = |points: Vec<Point>, list: &PolygonList| Subdivision::from_polygons(points, list).unwrap_err();

    assert_eq!(refused(p(&square), &polygon(&[&[0, 1]])), BuildError::TooFewCorners { face: 0, corners: 2 }.into());
    assert_eq!(
        refused(p(&square), &polygon(&[&[0, 1, 7]])),
        BuildError::IndexOutOfRange { face: 0, vertex: 7, vertices: 4 }.into()
    );
    assert_eq!(
        refused(p(&square), &polygon(&[&[0, 1, 2, 1]])),
        BuildError::RepeatedVertex { face: 0, vertex: 1 }.into()
    );
    let nan = vec![Point::new(0.0, f64::NAN), Point::new(1.0, 0.0), Point::new(0.0, 1.0)];
    assert!(matches!(refused(nan, &polygon(&[&[0, 1, 2]])), ConvertError::Coordinate { vertex: 0, .. }));
    let far = vec![Point::new(0.0, 0.0), Point::new(1e300, 0.0), Point::new(0.0, 1.0)];
    assert!(matches!(refused(far, &polygon(&[&[0, 1, 2]])), ConvertError::Coordinate { vertex: 1, .. }));

    assert_eq!(refused(p(&[(0, 0), (1, 1), (2, 2)]), &polygon(&[&[0, 1, 2]])), ConvertError::ZeroArea { face: 0 });
    assert_eq!(
        refused(p(&[(0, 0), (1, 0), (3, 0), (2, 0)]), &polygon(&[&[0, 1, 2, 3]])),
        ConvertError::ZeroArea { face: 0 }
    );
    assert_eq!(
        refused(p(&square), &polygon(&[&[0, 1, 3, 2]])),
        ConvertError::SelfCrossing { face: 0, first: (1, 3), second: (2, 0) }
    );
    assert_eq!(
        refused(p(&[(0, 0), (4, 0), (4, 4), (2, 0), (0, 4)]), &polygon(&[&[0, 1, 2, 3, 4]])),
        ConvertError::SelfTouching { face: 0, vertex: 3, side: (0, 1) }
    );
    // A spike: out and back along the same line.
    assert_eq!(
        refused(p(&[(0, 0), (4, 0), (8, 0), (4, 4)]), &polygon(&[&[0, 2, 1, 3]])),
        ConvertError::SelfTouching { face: 0, vertex: 1, side: (0, 2) }
    );
    // A pentagram turns one way only, but twice round.
    let star = p(&[(0, 10), (-6, -8), (10, 3), (-10, 3), (6, -8)]);
    assert!(matches!(refused(star, &polygon(&[&[0, 1, 2, 3, 4]])), ConvertError::SelfCrossing { face: 0, .. }));

    let side = p(&[(0, 0), (4, 0), (0, 4), (4, 4)]);
    assert_eq!(
        Subdivision::from_triangles(side, &[[0, 1, 2], [0, 1, 3]]),
        Err(ConvertError::OverlapAtEdge { u: 0, v: 1, first: 0, second: 1 })
    );
    // Holes that begin at a side of the outer cycle, and at each other's: without the full check, too.
    let ground = p(&[(0, 0), (8, 0), (8, 8), (0, 8), (2, 4)]);
    for holes in [&[&[0, 1, 2, 3][..], &[3, 2, 4]][..], &[&[0, 1, 2, 3], &[3, 2, 4], &[2, 4, 0]]] {
        let unchecked = ConvertOptions::default();
        let error = Subdivision::convert_polygons(ground.clone(), &polygon(holes), &unchecked).unwrap_err();
        assert!(matches!(error, ConvertError::CommonEdge { face: 0, .. }), "{error}");
        assert!(error.vertices().iter().all(|v| [2, 3, 4].contains(v)) && error.faces() == [0], "{error}");
    }
    let fan = p(&[(0, 0), (4, 0), (0, 4), (6, 1), (1, 6)]);
    assert_eq!(
        Subdivision::from_triangles(fan, &[[0, 1, 2], [0, 3, 4]]),
        Err(ConvertError::OverlapAtVertex { vertex: 0, first: 0, second: 1 })
    );

    let frame = [(0, 0), (9, 0), (9, 9), (0, 9), (12, 2), (14, 2), (12, 4)];
    assert_eq!(
        refused(p(&frame), &polygon(&[&[0, 1, 2, 3], &[4, 6, 5]])),
        ConvertError::HoleOutside { face: 0, vertex: 4 }
    );
    let cut = [(0, 0), (9, 0), (9, 9), (0, 9), (3, 5)];
    assert_eq!(refused(p(&cut), &polygon(&[&[0, 1, 2, 3], &[0, 4, 2]])), ConvertError::InPieces { face: 0 });
    let inner = p(&[(0, 0), (9, 0), (0, 9), (1, 1), (3, 1), (1, 3), (20, 20), (21, 20), (20, 21)]);
    assert_eq!(
        Subdivision::from_triangles(inner, &[[0, 1, 2], [3, 4, 5], [6, 7, 8]]),
        Err(ConvertError::InsideFace { face: 0, vertex: 3 })
    );
}

#[test]
fn the_full_check_finds_what_local_checks_cannot() {
    let full = ConvertOptions { full_check: true, ..Default::default() };
    let check = |list: &[(i32, i32)], triangles: &[[u32; 3]]| {
        assert!(Subdivision::from_triangles(points(list), triangles).is_ok(), "only the full check may see it");
        Subdivision::convert_triangles(points(list), triangles, &full).unwrap_err()
    };
    assert_eq!(
        check(&[(0, 0), (4, 0), (0, 4), (1, -1), (5, 3), (-2, 9)], &[[0, 1, 2], [3, 4, 5]]),
        GeometryViolation::EdgesMeet { first: [2, 0].map(VertexId::new), second: [5, 3].map(VertexId::new) }.into()
    );
    assert_eq!(
        check(&[(0, 0), (4, 0), (0, 4), (2, 0), (3, -2), (4, -1)], &[[0, 1, 2], [3, 4, 5]]),
        GeometryViolation::VertexOnEdge { vertex: VertexId::new(3), ends: [0, 1].map(VertexId::new) }.into()
    );
    assert_eq!(
        check(&[(0, 0), (4, 0), (0, 4), (4, 0), (8, 0), (8, 4)], &[[0, 1, 2], [3, 4, 5]]),
        GeometryViolation::SamePlace { first: VertexId::new(1), second: VertexId::new(3) }.into()
    );
}

#[test]
fn errors_list_the_faces_and_vertices_they_speak_of() {
    let error = ConvertError::InsideFace { face: 2, vertex: 9 };
    assert_eq!((error.faces(), error.vertices()), (vec![2], vec![9]));
    let error = ConvertError::OverlapAtEdge { u: 4, v: 5, first: 1, second: 3 };
    assert_eq!((error.faces(), error.vertices()), (vec![1, 3], vec![4, 5]));
    let error = ConvertError::from(BuildError::MixedWinding { u: 4, v: 5, first: 1, second: 3 });
    assert_eq!((error.faces(), error.vertices()), (vec![1, 3], vec![4, 5]));
    let [first, second] = [7, 8].map(VertexId::new);
    assert_eq!(ConvertError::from(GeometryViolation::SamePlace { first, second }).vertices(), [7, 8]);
}

#[test]
fn a_thousand_islands_in_a_thousand_holes() {
    // Rings of squares, each with a smaller square in its hole, in one row.
    let n = 1000;
    let mut p = Vec::new();
    let mut list = PolygonList::new();
    for i in 0..n {
        let (x, base) = (10 * i, 12 * i as u32);
        for (r, _) in [(4, ()), (3, ()), (1, ())] {
            p.extend(points(&[(x - r, -r), (x + r, -r), (x + r, r), (x - r, r)]));
        }
        list.push_face(&[base, base + 1, base + 2, base + 3]);
        list.push_hole(&[base + 4, base + 5, base + 6, base + 7]);
        list.push_face(&[base + 8, base + 9, base + 10, base + 11]);
    }
    let s = Subdivision::from_polygons(p, &list).unwrap();
    assert_eq!((s.face_count(), s.hole_faces().count()), (1 + 3 * n as usize, n as usize));
    assert_eq!(s.cycles(s.outer_face()).count(), n as usize);
    assert!(s.hole_faces().all(|f| s.inner_components(f).len() == 1));
    assert_eq!(s.geometry_violations(), []);
}
