//! What is wrong with faces that should be a navmesh.

use crate::{Random, data, soup};
use dcel_kit::io::{Format, Grid, PolygonSoup};
use dcel_kit::navmesh::{MeshFault, NavMesh, double_corners_of, mesh_faults};
use dcel_kit::plane::{Point, Subdivision};
use dcel_kit::topology::PolygonList;

fn faults(points: &[[f64; 2]], faces: &[&[u32]], blocked: &[u32]) -> Vec<MeshFault> {
    let points: Vec<Point> = points.iter().map(|&p| p.into()).collect();
    let mut list = PolygonList::new();
    faces.iter().for_each(|face| list.push_face(face));
    mesh_faults(&points, &list, blocked)
}

fn of_soup(soup: &PolygonSoup) -> Vec<MeshFault> {
    let points: Vec<Point> = soup.points.iter().map(|&[x, y, _]| Point::new(x, y)).collect();
    mesh_faults(&points, &soup.faces, &soup.blocked)
}

const SQUARE: [[f64; 2]; 4] = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]];

#[test]
fn a_face_by_itself() {
    assert_eq!(faults(&SQUARE, &[&[0, 1, 2], &[0, 2, 3]], &[]), []);
    assert_eq!(faults(&SQUARE, &[&[0, 2, 1]], &[]), [MeshFault::Clockwise { face: 0 }]);
    assert_eq!(faults(&SQUARE, &[&[0, 1]], &[]), [MeshFault::FewCorners { face: 0, corners: 2, distinct: 2 }]);
    assert_eq!(faults(&SQUARE, &[&[0, 1, 2, 1]], &[]), [MeshFault::FewCorners { face: 0, corners: 4, distinct: 3 }]);
    let named = MeshFault::NoSuchVertex { face: 0, corner: 4, vertices: 4 };
    assert_eq!(faults(&SQUARE, &[&[0, 1, 4]], &[]), [named]);
    let line = [[0.0, 0.0], [1.0, 1.0], [3.0, 3.0]];
    assert_eq!(faults(&line, &[&[0, 1, 2]], &[]), [MeshFault::Flat { face: 0 }]);
    let dented = [[0.0, 0.0], [4.0, 0.0], [2.0, 1.0], [2.0, 4.0]];
    assert_eq!(faults(&dented, &[&[0, 1, 2, 3]], &[]), [MeshFault::NotConvex { face: 0, vertex: 2 }]);
    assert_eq!(faults(&dented, &[&[0, 1, 2, 3]], &[0]), [], "a blocked face may have any shape");
    // All corners of a five-pointed star turn left, and go round twice.
    let star = [[0.0, 4.0], [-2.4, -3.2], [3.8, 1.2], [-3.8, 1.2], [2.4, -3.2]];
    assert_eq!(faults(&star, &[&[0, 1, 2, 3, 4]], &[]), [MeshFault::Winds { face: 0 }]);
    let straight = [[0.0, 0.0], [2.0, 0.0], [4.0, 0.0], [4.0, 4.0]];
    assert_eq!(faults(&straight, &[&[0, 1, 2, 3]], &[]), [], "a straight corner is fine");
    let back = MeshFault::NotConvex { face: 0, vertex: 2 };
    assert_eq!(faults(&straight, &[&[0, 2, 1, 3]], &[]), [back], "one that turns back is not");
    let huge = faults(&[[0.0, 1e99], [1.0, 0.0], [0.0, 0.0]], &[&[0, 1, 2]], &[]);
    assert!(matches!(huge.as_slice(), [MeshFault::Coordinate { vertex: 0, .. }]), "{huge:?}");
}

#[test]
fn faces_that_do_not_fit_together() {
    let six = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0], [2.0, 2.0], [6.0, 2.0]];
    // Two on the same side of 0 -> 1.
    let twice = MeshFault::SameSide { first: 0, second: 1, from: 0, to: 1 };
    assert_eq!(faults(&six, &[&[0, 1, 2], &[0, 1, 4]], &[]), [twice]);
    // Sides that cross.
    let crossed = faults(&six, &[&[0, 1, 2, 3], &[4, 5, 2]], &[]);
    assert_eq!(crossed.len(), 1, "{crossed:?}");
    assert!(
        matches!(crossed[0], MeshFault::Overlap { first: 0, second: 1, at, .. } if at == (4.0, 2.0).into()),
        "{crossed:?}"
    );
    // One inside another, without a common point.
    let inside = [[0.0, 0.0], [9.0, 0.0], [9.0, 9.0], [0.0, 9.0], [3.0, 3.0], [5.0, 3.0], [4.0, 5.0]];
    let covered = faults(&inside, &[&[0, 1, 2, 3], &[4, 5, 6]], &[]);
    assert!(matches!(covered.as_slice(), [MeshFault::Covers { face: 0, .. }]), "{covered:?}");
}

#[test]
fn a_corner_on_a_side_and_two_vertices_at_a_place() {
    let points = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0], [0.0, 1.0], [2.0, 2.0], [0.0, 2.0]];
    let faces: [&[u32]; 3] = [&[0, 1, 4, 5], &[1, 2, 3, 4], &[5, 3, 6, 7]];
    let junction = MeshFault::TJunction { vertex: 4, face: 2, side: [5, 3] };
    assert_eq!(faults(&points, &faces, &[]), std::slice::from_ref(&junction));
    assert!(junction.to_string().contains("T-junction: vertex 4 lies on the side 5 -> 3 of face 2"), "{junction}");
    // Sides that pass each other by have a corner too few each.
    let shifted = [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [0.0, 1.0], [1.0, 1.0], [3.0, 1.0], [3.0, 2.0], [1.0, 2.0]];
    let both = faults(&shifted, &[&[0, 1, 2, 3], &[4, 5, 6, 7]], &[]);
    let junction = |vertex, face, side| MeshFault::TJunction { vertex, face, side };
    assert_eq!(both, [junction(4, 0, [2, 3]), junction(2, 1, [4, 5])]);
    // On the same side of the line they overlap.
    let stacked = faults(&shifted, &[&[0, 1, 2, 3], &[4, 5, 6, 7], &[1, 5, 4]], &[]);
    assert!(stacked.iter().any(|fault| matches!(fault, MeshFault::Overlap { .. })), "{stacked:?}");
    // With the corner the faces are a mesh, whose three faces are neighbours of each other.
    assert_eq!(faults(&points, &[faces[0], faces[1], &[5, 4, 3, 6, 7]], &[]), []);
    // Vertices that are not shared.
    let apart = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [1.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0]];
    let places = faults(&apart, &[&[0, 1, 2, 3], &[4, 5, 6, 7]], &[]);
    let same = |first, second, y| MeshFault::SamePlace { first, second, at: Point::new(1.0, y) };
    assert_eq!(places, [same(1, 4, 0.0), same(2, 7, 1.0)]);
}

#[test]
fn double_corners_are_warnings() {
    let points = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [2.0, 1.0], [2.0, 2.0], [1.0, 2.0]];
    let found = faults(&points, &[&[0, 1, 2, 3], &[2, 4, 5, 6]], &[]);
    assert_eq!(found, [MeshFault::DoubleCorner { vertex: 2, holes: 2 }]);
    assert!(found[0].is_warning() && found[0].kind() == "double-corner");
    // A blocked face is a gap, too: here it leaves one gap, and there two.
    let more = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [2.0, 1.0], [2.0, 2.0], [1.0, 2.0], [2.0, 0.0]];
    let three: [&[u32]; 3] = [&[0, 1, 2, 3], &[2, 4, 5, 6], &[1, 7, 4, 2]];
    assert_eq!(faults(&more, &three, &[]), []);
    assert_eq!(faults(&more, &three, &[2]), [MeshFault::DoubleCorner { vertex: 2, holes: 2 }]);
}

#[test]
fn rectangles_of_random_maps_have_no_faults_and_the_double_corners_of_the_map() {
    for seed in 0..150 {
        let mut random = Random::new(seed);
        let (w, h) = (2 + random.below(8), 2 + random.below(8));
        let mut text = format!("type octile\nheight {h}\nwidth {w}\nmap\n");
        for i in 0..w * h {
            text.push(if random.below(5) < 2 { '@' } else { '.' });
            text.push_str(if (i + 1) % w == 0 { "\n" } else { "" });
        }
        let grid = Grid::parse(text.as_bytes(), "file").expect("a map");
        let soup = grid.rectangles().expect("rectangles");
        let found = of_soup(&soup);
        let corners: Vec<[f64; 2]> = found
            .iter()
            .map(|fault| match fault {
                MeshFault::DoubleCorner { vertex, holes: 2 } => {
                    soup.points[*vertex as usize][..2].try_into().expect("two")
                }
                other => panic!("seed {seed}: {other} in\n{text}"),
            })
            .collect();
        let mut stated: Vec<[f64; 2]> =
            grid.double_corners().map(|[x, y]| [f64::from(x), 0.0 - f64::from(y)]).collect();
        stated.sort_by(|a, b| b[1].total_cmp(&a[1]).then(a[0].total_cmp(&b[0])));
        assert_eq!(corners, stated, "seed {seed}:\n{text}");
        if grid.open_cells() > 0 {
            let map = crate::plane(text.as_bytes(), Format::Map);
            assert_eq!(double_corners_of(&map).len(), stated.len(), "seed {seed}");
            let mesh = NavMesh::new(&map).expect("convex faces");
            assert_eq!(mesh.face_count(), soup.faces.face_count());
        }
        // A face that loses a straight corner has a T-junction there.
        let mut broken = PolygonList::new();
        let mut lost = None;
        for (face, corners) in soup.faces.outer_cycles().enumerate() {
            let place = |k: usize| soup.points[corners[k % corners.len()] as usize];
            let n = corners.len();
            let straight = (0..n).find(|&k| place(k + n - 1)[1].to_bits() == place(k + 1)[1].to_bits());
            match (lost, straight) {
                (None, Some(k)) => {
                    lost = Some((face as u32, corners[k]));
                    broken.push_face(&[&corners[..k], &corners[k + 1..]].concat());
                }
                _ => broken.push_face(corners),
            }
        }
        if let Some((lost_by, lost)) = lost {
            let points: Vec<Point> = soup.points.iter().map(|&[x, y, _]| Point::new(x, y)).collect();
            let found = mesh_faults(&points, &broken, &[]);
            let named = found.iter().any(
                |fault| matches!(fault, MeshFault::TJunction { vertex, face, .. } if *vertex == lost && *face == lost_by),
            );
            assert!(named, "seed {seed}: {found:?}, lost {lost} of {lost_by}\n{text}");
        }
    }
}

#[test]
fn a_turned_face_of_a_good_mesh_is_named() {
    let points: Vec<Point> = (0..16).map(|i| Point::new(f64::from(i % 4), f64::from(i / 4))).collect();
    let squares: Vec<[u32; 4]> = (0..9).map(|i| i / 3 * 4 + i % 3).map(|v| [v, v + 1, v + 5, v + 4]).collect();
    for turned in 0..9 {
        let mut list = PolygonList::new();
        for (i, square) in squares.iter().enumerate() {
            let mut square = *square;
            if i == turned {
                square.reverse();
            }
            list.push_face(&square);
        }
        let found = mesh_faults(&points, &list, &[]);
        assert!(found.contains(&MeshFault::Clockwise { face: turned as u32 }), "{found:?}");
        assert!(found.iter().all(|fault| fault.is_warning() || fault.faces() == [turned as u32]), "{found:?}");
        assert!(Subdivision::from_polygons(points.clone(), &list).is_err());
    }
}

#[test]
#[cfg_attr(not(shared_data), ignore = "needs ../shared/data")]
fn the_shared_meshes_have_the_faults_their_page_says() {
    let warnings = |file: &str, format| {
        let found = of_soup(&soup(&std::fs::read(data(file)).expect("the file"), format));
        assert!(found.iter().all(MeshFault::is_warning), "{file}: {found:?}");
        found.len()
    };
    assert_eq!(warnings("O15-gppc-acrossthecape/AcrosstheCape.map", Format::Map), 11);
    assert_eq!(warnings("O09-polyanya-arena/arena.mesh", Format::Mesh), 0);
    assert_eq!(warnings("O09-polyanya-arena/arena-merged.mesh", Format::Mesh), 0);
    assert_eq!(warnings("O16-navmesh-tests/bad-ambig.mesh", Format::Mesh), 1);
    for name in ["bad-collinear", "bad-collinear2-rot0", "bad-collinear2-rot90", "square", "hard"] {
        warnings(&format!("O16-navmesh-tests/{name}.mesh"), Format::Mesh);
    }
    // Turned by 45 degrees, straight corners are rounded to the inside: by a last digit, and seen.
    let turned = std::fs::read(data("O16-navmesh-tests/bad-collinear2-rot45.mesh")).expect("the file");
    let found = of_soup(&soup(&turned, Format::Mesh));
    let not_convex = |face, vertex| MeshFault::NotConvex { face, vertex };
    assert_eq!(found, [not_convex(1, 8), not_convex(2, 10), not_convex(3, 11)]);
}
