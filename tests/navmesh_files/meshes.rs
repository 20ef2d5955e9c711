//! `.mesh`, versions 2 and 3.

use crate::{data, plane, soup};
use dcel_kit::io::{Format, Model, ReadOptions, WriteError, read_bytes, write};
use dcel_kit::plane::{Point, Subdivision};
use dcel_kit::topology::PolygonList;
use dcel_kit::{FaceId, VertexId};

/// A square of two blocked and two open triangles round (5, 5), clockwise as in the description of version 3.
const DIAMOND: &str = "mesh\n3\n5 4\n0 0\n0 8\n8 8\n8 0\n5 5\n\
    0 3  4 1 5  -4 0 -2\n1 3  1 2 5  -1 0 3\n1 3  2 3 5  2 0 4\n1 3  3 4 5  3 0 -1\n";

fn written(s: &Subdivision) -> String {
    let mut bytes = Vec::new();
    write(&mut bytes, &Model::planar(s), Format::Mesh).expect("convex faces");
    String::from_utf8(bytes).expect("text")
}

#[test]
fn two_triangles_are_written_as_the_description_of_version_2_has_them() {
    let points = [[0.0, 0.0], [1.5, 0.0], [1.5, 1.5], [0.0, 1.5]].map(Point::from).to_vec();
    let square = Subdivision::from_triangles(points, &[[0, 1, 3], [1, 2, 3]]).expect("two triangles");
    let text = written(&square);
    let (vertices, faces) = text.split_at(text.find("3 0 1 3").expect("the first polygon"));
    assert_eq!(faces, "3 0 1 3  -1 -1 1\n3 1 2 3  0 -1 -1\n");
    assert!(vertices.starts_with("mesh\n2\n4 2\n0 0  2 "), "{vertices}");
    // Counter-clockwise, as the text of the description has it and its example has not.
    let lists: Vec<Vec<i64>> = vertices.lines().skip(3).map(around).collect();
    assert_eq!(lists, [vec![-1, 0], vec![-1, 1, 0], vec![-1, 1], vec![-1, 0, 1]]);
}

/// The polygons round the vertex of a line, turned so that the least comes first.
fn around(line: &str) -> Vec<i64> {
    let words: Vec<&str> = line.split_whitespace().collect();
    let mut list: Vec<i64> = words[3..].iter().map(|word| word.parse().expect("a number")).collect();
    assert_eq!(words[2], list.len().to_string(), "{line}");
    let least = (0..list.len()).min_by_key(|&i| list[i]).expect("a polygon or a gap");
    list.rotate_left(least);
    list
}

#[test]
fn a_written_mesh_comes_back_bit_for_bit() {
    let map = b"type octile\nheight 4\nwidth 5\nmap\n..@..\n.@.@.\n.....\n@.@.@\n";
    let s = plane(map, Format::Map);
    let text = written(&s);
    let again = plane(text.as_bytes(), Format::Mesh);
    assert_eq!(written(&again), text);
    assert_eq!(
        (again.vertex_count(), again.edge_count(), again.face_count()),
        (s.vertex_count(), s.edge_count(), s.face_count())
    );
    for v in s.vertices() {
        assert_eq!(again.point(v), s.point(v), "{v}");
    }
    // Gaps beside each other count as one: the double corner (2, -1) has two, apart from each other.
    let corner = text.lines().find(|line| line.starts_with("2 -1 ")).expect("the double corner");
    assert_eq!(around(corner).iter().filter(|&&n| n == -1).count(), 2, "{corner}");
    let tip = text.lines().find(|line| line.starts_with("0 -3 ")).expect("a corner with one gap");
    assert_eq!(around(tip).iter().filter(|&&n| n == -1).count(), 1, "{tip}");
}

#[test]
fn concave_faces_are_refused_and_straight_corners_are_not() {
    let polygon = |points: &[[f64; 2]]| {
        let mut list = PolygonList::new();
        list.push_face(&(0..points.len() as u32).collect::<Vec<_>>());
        Subdivision::from_polygons(points.iter().map(|&p| p.into()).collect(), &list).expect("a polygon")
    };
    let dented = polygon(&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [2.0, 3.0], [0.0, 4.0]]);
    let error = write(&mut Vec::new(), &Model::planar(&dented), Format::Mesh).expect_err("a dent");
    let (f1, v3) = (FaceId::new(1), VertexId::new(3));
    assert!(matches!(error, WriteError::NotConvex { face, vertex, .. } if face == f1 && vertex == v3), "{error}");
    assert!(error.to_string().contains("f1 is not convex at v3"), "{error}");
    let straight = polygon(&[[0.0, 0.0], [2.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]]);
    assert!(written(&straight).contains("5 0 1 2 3 4  -1 -1 -1 -1 -1"));
}

#[test]
fn blocked_polygons_of_version_3_become_hole_faces() {
    let s = plane(DIAMOND.as_bytes(), Format::Mesh);
    assert_eq!((s.vertex_count(), s.edge_count(), s.face_count()), (5, 8, 5));
    assert_eq!(s.hole_faces().collect::<Vec<_>>(), [FaceId::new(1)]);
    // They were clockwise and are not any more.
    let corners: Vec<_> = s.incident_vertices(FaceId::new(2)).map(VertexId::number).collect();
    assert!([[0, 4, 1], [4, 1, 0], [1, 0, 4]].contains(&[corners[0], corners[1], corners[2]]), "{corners:?}");
    // The blocked one is still there, with its neighbours: a walk can pass through it.
    let across: Vec<_> = s.adjacent_faces(FaceId::new(1)).map(FaceId::number).collect();
    assert_eq!(across.iter().filter(|&&f| f == 0).count(), 1, "{across:?}");
    assert!(across.contains(&2) && across.contains(&4), "{across:?}");
    let soup = soup(DIAMOND.as_bytes(), Format::Mesh);
    assert_eq!((soup.blocked.as_slice(), soup.any_direction), (&[0][..], true));
}

#[test]
fn a_wall_without_width_is_refused_where_it_stands() {
    let thin = DIAMOND.replace("1 3  2 3 5  2 0 4", "1 3  2 3 5  -2 0 4");
    let error = read_bytes(thin.as_bytes(), Format::Mesh, "thin.mesh", &ReadOptions::default()).expect_err("a wall");
    let text = error.to_string();
    assert!(text.starts_with("thin.mesh:11:13: a wall without width, between polygons 3 and 2"), "{text}");
    // Towards a blocked polygon the minus says what is known already.
    plane(DIAMOND.as_bytes(), Format::Mesh);
}

#[test]
#[cfg_attr(not(shared_data), ignore = "needs ../shared/data")]
fn the_arena_is_written_with_the_neighbours_of_its_file() {
    for (file, entries) in [("arena.mesh", 360), ("arena-merged.mesh", 230)] {
        let bytes = std::fs::read(data("O09-polyanya-arena").join(file)).expect("the file");
        let original = String::from_utf8(bytes.clone()).expect("text");
        let text = written(&plane(&bytes, Format::Mesh));
        let numbers = |text: &str| -> Vec<Vec<i64>> {
            let lines = text.lines().skip(2).filter(|line| !line.trim().is_empty());
            lines.map(|line| line.split_whitespace().map(|w| w.parse().expect("a whole number")).collect()).collect()
        };
        let (theirs, ours) = (numbers(&original), numbers(&text));
        assert_eq!(theirs[0], ours[0], "{file}: counts");
        let vertices = theirs[0][0] as usize;
        for (a, b) in original.lines().skip(3).zip(text.lines().skip(3)).take(vertices) {
            assert_eq!(around(a), around(b), "{file}");
        }
        // Each corner with what is behind the edge that ends at it; where the list starts is free.
        let pairs = |line: &Vec<i64>| {
            let n = line[0] as usize;
            let mut pairs: Vec<_> = (0..n).map(|k| (line[1 + k], line[1 + n + k])).collect();
            let least = (0..n).min_by_key(|&k| pairs[k].0).expect("a corner");
            pairs.rotate_left(least);
            pairs
        };
        let mut agreed = 0;
        for (a, b) in theirs[1 + vertices..].iter().zip(&ours[1 + vertices..]) {
            assert_eq!(pairs(a), pairs(b), "{file}");
            agreed += pairs(a).len();
        }
        assert_eq!(agreed, entries, "{file}");
    }
}
