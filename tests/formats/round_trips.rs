//! What is written comes back.

use crate::support::{Random, grid, island, soup, table};
use dcel_kit::io::{
    Document, Format, Model, ReadOptions, read_bytes, read_path, read_triangle, write, write_path, write_triangle,
};
use dcel_kit::topology::{FaceRow, HalfEdgeRow, InnerComponent, Table, VertexRow, View, bounded_cycle};
use dcel_kit::{FaceId, HalfEdgeId, VertexId};

pub(crate) fn written(model: &Model<'_>, format: Format) -> Vec<u8> {
    let mut bytes = Vec::new();
    write(&mut bytes, model, format).unwrap_or_else(|error| panic!("{format}: {error}"));
    bytes
}

/// The cycles of the faces of a table that are polygons, as numbers of vertices.
fn polygons(table: &Table) -> Vec<Vec<Vec<u32>>> {
    let cycle = |h| bounded_cycle(table, h).map(|h| table.origin(h).unwrap().number()).collect::<Vec<_>>();
    let faces = (1..table.faces.len() as u32).map(FaceId::new).filter(|&f| !table.is_hole(f));
    faces
        .map(|f| {
            let rings = table.inner_components(f).iter().map(|ring| match ring {
                InnerComponent::Cycle(h) => *h,
                InnerComponent::Isolated(v) => panic!("{v}"),
            });
            table.half_edge(f).into_iter().chain(rings).map(cycle).collect()
        })
        .collect()
}

fn check_soup(soup: &dcel_kit::io::PolygonSoup, table: &Table, format: Format) {
    assert_eq!(soup.points.len(), table.vertices.len(), "{format}");
    for (i, (point, row)) in soup.points.iter().zip(&table.vertices).enumerate() {
        let [x, y] = row.unwrap().position.unwrap();
        assert_eq!(point.map(f64::to_bits), [x, y, 0.0].map(f64::to_bits), "{format}: vertex {i}");
    }
    let read: Vec<Vec<Vec<u32>>> =
        (0..soup.faces.face_count()).map(|f| soup.faces.cycles(f).map(<[u32]>::to_vec).collect()).collect();
    assert_eq!(read, polygons(table), "{format}");
    assert!(!soup.has_z, "{format}");
}

#[test]
fn polygons_of_the_plane_come_back_bit_for_bit() {
    let grid = grid(4, false);
    for format in [Format::Obj, Format::Off, Format::Ply, Format::PlyBinary] {
        let bytes = written(&Model::table(&grid), format);
        check_soup(&soup(&bytes, format), &grid, format);
    }
}

#[test]
fn triangles_come_back_from_two_files() {
    let grid = grid(3, true);
    let (mut node, mut ele) = (Vec::new(), Vec::new());
    write_triangle(&mut node, &mut ele, &Model::table(&grid)).unwrap();
    let read = read_triangle(&node, &ele, "a.node", "a.ele", &ReadOptions::default()).unwrap();
    let Document::Polygons(soup) = read.document else { panic!() };
    check_soup(&soup, &grid, Format::Triangle);
    assert_eq!((soup.places.vertex(0), soup.places.face(1)), ("a.node:2".to_owned(), "a.ele:3".to_owned()));

    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("grid.1.ele");
    write_path(&path, &Model::table(&grid), Format::Triangle).unwrap();
    for name in ["grid.1.ele", "grid.1.node"] {
        let read = read_path(&folder.path().join(name), &ReadOptions::default()).unwrap();
        let Document::Polygons(soup) = read.document else { panic!() };
        check_soup(&soup, &grid, Format::Triangle);
    }
    std::fs::remove_file(folder.path().join("grid.1.node")).unwrap();
    let error = read_path(&path, &ReadOptions::default()).unwrap_err().to_string();
    assert!(error.contains("partner file") && error.contains("grid.1.node is missing"), "{error}");
}

#[test]
fn both_countings_of_triangle_are_read() {
    let read = |node: &str, ele: &str| {
        let read = read_triangle(node.as_bytes(), ele.as_bytes(), "n", "e", &ReadOptions::default());
        match read.unwrap().document {
            Document::Polygons(soup) => (soup.points, soup.faces.corners().to_vec()),
            _ => panic!(),
        }
    };
    let from_0 = read("3 2 1 1\n0 0 0 7.5 1\n1 1 0 7.5 1\n2 0 1 7.5 1\n", "# c\n1 3 1\n0 0 1 2 -4\n");
    let from_1 = read("3 2 0 0\n1 0 0\n2 1 0 # peak\n3 0 1", "1 3 0\r\n1 1 2 3");
    assert_eq!(from_0, from_1);
    assert_eq!(from_1.1, [0, 1, 2]);
}

#[test]
fn geojson_keeps_holes_names_and_common_points() {
    let mut island = island();
    island.faces[2].as_mut().unwrap().name = Some("a \"quoted\" \\ ü\n name".to_owned());
    let text = written(&Model::table(&island), Format::GeoJson);
    let soup = soup(&text, Format::GeoJson);
    assert_eq!(soup.names, [Some("f1"), Some("a \"quoted\" \\ ü\n name")].map(|n| n.map(str::to_owned)));
    // Points are numbered as they come: the outer square, the island clockwise, the hole clockwise.
    let order = [0, 1, 2, 3, 4, 7, 6, 5, 8, 11, 10, 9];
    let expected: Vec<Vec<Vec<u32>>> = polygons(&island);
    let read: Vec<Vec<Vec<u32>>> = (0..soup.faces.face_count())
        .map(|f| soup.faces.cycles(f).map(|c| c.iter().map(|&v| order[v as usize]).collect()).collect())
        .collect();
    assert_eq!(read, expected);
    for (point, &v) in soup.points.iter().zip(&order) {
        assert_eq!([point[0], point[1]], island.vertices[v as usize].unwrap().position.unwrap());
    }
}

#[test]
fn surfaces_keep_their_z() {
    let grid = grid(2, false);
    let height = |v: VertexId| Some([f64::from(v.number()), 0.1, 1.0 / f64::from(v.number() + 1)]);
    let model = Model::surface(&grid, height, |f| f.number() == 0);
    for format in [Format::Obj, Format::Off, Format::Ply, Format::PlyBinary] {
        let soup = soup(&written(&model, format), format);
        assert!(soup.has_z, "{format}");
        assert_eq!(soup.points, grid_heights(&grid, height), "{format}");
        assert_eq!(soup.faces.face_count(), polygons(&grid).len(), "{format}");
    }
}

fn grid_heights(grid: &Table, height: impl Fn(VertexId) -> Option<[f64; 3]>) -> Vec<[f64; 3]> {
    (0..grid.vertices.len() as u32).map(|v| height(VertexId::new(v)).unwrap()).collect()
}

#[test]
fn removed_ids_leave_no_gap_in_polygon_formats() {
    let grid = grid(1, false);
    let mut text = String::from_utf8(written(&Model::table(&grid), Format::Dcel)).unwrap();
    // Vertex 1 becomes vertex 9, which leaves a gap at 1.
    text = text.replace("v1 ", "v9 ");
    let moved = table(text.as_bytes());
    assert_eq!((moved.vertices.len(), moved.vertices[1]), (10, None));
    let soup = soup(&written(&Model::table(&moved), Format::Obj), Format::Obj);
    assert_eq!(soup.points.len(), 4);
    assert_eq!(soup.faces.cycle(0), [0, 3, 2], "v0 v9 v3 are the points 0, 3 and 2 of the file");
}

/// Every pointer, position and name at random: dangling, missing, contradictory.
pub(crate) fn random_table(random: &mut Random) -> Table {
    fn id<T>(random: &mut Random, new: impl Fn(u32) -> T) -> Option<T> {
        (random.below(5) > 0).then(|| new(random.below(40) as u32))
    }
    let name = |random: &mut Random| {
        let letters = ['a', '"', '\\', '\n', '\r', '\t', '#', ' ', 'ü', '\u{0}', '\u{2028}', '😀'];
        (0..random.below(6)).map(|_| letters[random.below(letters.len())]).collect::<String>()
    };
    let mut table = Table::default();
    for _ in 0..random.below(12) {
        let position = (random.below(4) > 0).then(|| [random.coordinate(), random.coordinate()]);
        let row = VertexRow { position, outgoing: id(random, HalfEdgeId::new) };
        table.vertices.push((random.below(4) > 0).then_some(row));
    }
    for _ in 0..random.below(20) {
        let row = HalfEdgeRow {
            origin: id(random, VertexId::new),
            twin: id(random, HalfEdgeId::new),
            next: id(random, HalfEdgeId::new),
            prev: id(random, HalfEdgeId::new),
            face: id(random, FaceId::new),
        };
        table.half_edges.push((random.below(4) > 0).then_some(row));
    }
    for _ in 0..random.below(6) {
        let ring = |random: &mut Random| match random.below(2) {
            0 => InnerComponent::Cycle(HalfEdgeId::new(random.below(40) as u32)),
            _ => InnerComponent::Isolated(VertexId::new(random.below(40) as u32)),
        };
        let row = FaceRow {
            half_edge: id(random, HalfEdgeId::new),
            inner_components: (0..random.below(4)).map(|_| ring(random)).collect(),
            hole: random.below(3) == 0,
            name: (random.below(2) == 0).then(|| name(random)),
        };
        table.faces.push((random.below(4) > 0).then_some(row));
    }
    let faces = table.faces.iter().filter(|f| f.is_some()).count();
    if faces > 0 && random.below(3) > 0 {
        let present: Vec<usize> = (0..table.faces.len()).filter(|&f| table.faces[f].is_some()).collect();
        table.outer_face = Some(FaceId::new(present[random.below(faces)] as u32));
    }
    // The text knows nothing of ids after the last existing one.
    fn trim<T>(rows: &mut Vec<Option<T>>) {
        rows.truncate(rows.iter().rposition(Option::is_some).map_or(0, |last| last + 1));
    }
    trim(&mut table.vertices);
    trim(&mut table.half_edges);
    trim(&mut table.faces);
    table
}

#[test]
fn any_table_round_trips_through_the_text_however_broken() {
    for seed in 0..2000 {
        let original = random_table(&mut Random::new(seed));
        let text = written(&Model::table(&original), Format::Dcel);
        let read = table(&text);
        assert!(same_table(&read, &original), "seed {seed}:\n{}", String::from_utf8_lossy(&text));
        let again = written(&Model::table(&read), Format::Dcel);
        assert_eq!(text, again, "seed {seed}");
    }
}

#[test]
fn what_a_writer_accepts_of_a_random_table_can_be_read_and_nothing_panics() {
    let mut accepted = 0;
    for seed in 0..2000 {
        let table = random_table(&mut Random::new(seed));
        for format in Format::ALL {
            let mut bytes = Vec::new();
            if write(&mut bytes, &Model::table(&table), format).is_ok() && format.can_read() {
                let read = read_bytes(&bytes, format, "file", &ReadOptions::default());
                let empty_or_tiny = |e: &dcel_kit::io::ReadError| e.to_string().contains("encloses nothing");
                assert!(read.as_ref().map_or_else(empty_or_tiny, |_| true), "seed {seed}, {format}: {read:?}");
                accepted += 1;
            }
        }
        let (mut node, mut ele) = (Vec::new(), Vec::new());
        if write_triangle(&mut node, &mut ele, &Model::table(&table)).is_ok() {
            assert!(read_triangle(&node, &ele, "n", "e", &ReadOptions::default()).is_ok(), "seed {seed}");
        }
    }
    assert!(accepted > 2000, "the text and more: {accepted}");
}

#[test]
fn a_face_with_300_corners_comes_back_from_ply() {
    let circle: Vec<[f64; 2]> = (0..300).map(|i| f64::from(i) / 300.0).map(|t| [t, t * (1.0 - t)]).collect();
    let all: Vec<usize> = (0..300).collect();
    let table = crate::support::structure(&circle, &[crate::support::Face::new(&[&all])]);
    for format in [Format::Ply, Format::PlyBinary] {
        check_soup(&soup(&written(&Model::table(&table), format), format), &table, format);
    }
}

/// Equality that tells 0 from -0.
pub(crate) fn same_table(a: &Table, b: &Table) -> bool {
    let bits = |t: &Table| -> Vec<Option<[u64; 2]>> {
        t.vertices.iter().map(|row| row.and_then(|r| r.position).map(|p| p.map(f64::to_bits))).collect()
    };
    a == b && bits(a) == bits(b)
}

#[test]
fn the_text_can_be_typed_in_any_order() {
    let typed = b"\xef\xbb\xbf# by hand\r\ndcel 1\r\n\r\nf0 outer inner h1\r\nh0 next h1\tface f1 origin v0 # half\r\nv7 out h4\r\nv2\r\n\
        f1 name \"a # b\" half_edge h0 hole inner h9 v12\r\nv3 1e-3 -150\r\nh1 twin none prev h0";
    let table = table(typed);
    let mut expected = Table {
        vertices: vec![None; 8],
        half_edges: vec![Some(HalfEdgeRow::default()); 2],
        faces: vec![Some(FaceRow::default()); 2],
        outer_face: Some(FaceId::new(0)),
    };
    let h = |n| Some(HalfEdgeId::new(n));
    expected.vertices[2] = Some(VertexRow::default());
    expected.vertices[3] = Some(VertexRow { position: Some([0.001, -150.0]), outgoing: None });
    expected.vertices[7] = Some(VertexRow { position: None, outgoing: h(4) });
    expected.half_edges[0] = Some(HalfEdgeRow {
        origin: Some(VertexId::new(0)),
        next: h(1),
        face: Some(FaceId::new(1)),
        ..HalfEdgeRow::default()
    });
    expected.half_edges[1] = Some(HalfEdgeRow { prev: h(0), ..HalfEdgeRow::default() });
    expected.faces[0].as_mut().unwrap().inner_components = vec![InnerComponent::Cycle(HalfEdgeId::new(1))];
    expected.faces[1] = Some(FaceRow {
        half_edge: h(0),
        inner_components: vec![InnerComponent::Cycle(HalfEdgeId::new(9)), InnerComponent::Isolated(VertexId::new(12))],
        hole: true,
        name: Some("a # b".to_owned()),
    });
    assert_eq!(table, expected);
}

#[test]
fn y_down_turns_points_and_tables_and_keeps_zero() {
    let options = ReadOptions { y_down: true, ..ReadOptions::default() };
    let read = |text: &[u8], format| read_bytes(text, format, "file", &options).unwrap().document;
    let Document::Polygons(soup) = read(b"v 1 2 3\nv 1 0\n", Format::Obj) else { panic!() };
    assert_eq!(
        soup.points.as_flattened().iter().map(|x| x.to_bits()).collect::<Vec<_>>(),
        [1.0, -2.0, 3.0, 1.0, 0.0, 0.0].map(f64::to_bits)
    );
    let Document::Table(table) = read(b"dcel 1\nv0 1 2\n", Format::Dcel) else { panic!() };
    assert_eq!(table.vertices[0].unwrap().position, Some([1.0, -2.0]));
}

#[test]
fn variants_of_the_line_formats_give_the_same_triangle() {
    let cases: [(&[u8], Format); 16] = [
        (b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3", Format::Obj),
        (b"f 1 2 3\nv 0 0\nv 1 0\nv 0 1\n", Format::Obj),
        (b"v 0 0 0 1\r\nv 1 0 0 0.5 0.5 0.5\r\nv 0 1 0 1\r\nvt 0 0\r\nf 1/1 2/1/ \\\r\n 3//4 # c\r\n", Format::Obj),
        (b"o a\\\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nl 1 2 \\\n 3\n", Format::Obj),
        (b"OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", Format::Off),
        (b"OFF3 1\n0 0 0\n1 0 0\n\n0 1 0 # c\n3 0 1 2 255 0 0", Format::Off),
        (b"STCNOFF\n# c\n3 1 3\n0 0 0 0 0 1 9 9 9 1\n1 0 0\n0 1 0\n3 0 1 2\n", Format::Off),
        (b"3 1 0\r0 0 0\r1 0 0\r0 1 0\r3 0 1 2\r", Format::Off),
        (b"mesh 2 3 1  0 0 2 0 -1  1 0 2 0 -1  0 1 2 0 -1  3 0 1 2 -1 -1 -1", Format::Mesh),
        (b"ply\nformat ascii 1.0\nelement vertex 3\nproperty int y\nproperty list char float w\nproperty float x\n\
           element edge 1\nproperty int a\nelement none 7\nelement face 1\nproperty list uchar uint vertex_index\n\
           end_header\n0 0 0\n0 2 5 5 1\n\n1 0 0\n9\n3 0 1 2\n", Format::Ply),
        (b"ply\r\nformat ascii 1.0\r\nelement face 1\r\nproperty list int short vertex_indices\r\nelement vertex 3\r\n\
           property double x\r\nproperty double y\r\nend_header\r\n3 0 1 2\r\n0 0\r\n1 0\r\n0 1", Format::Ply),
        (b"ply\nformat binary_big_endian 1.0\nelement vertex 3\nproperty short x\nproperty char q\nproperty uchar y\n\
           element face 1\nproperty list uchar ushort vertex_indices\nend_header\n\
           \0\0\x07\0\0\x01\x07\0\0\0\x07\x01\x03\0\0\0\x01\0\x02\n", Format::Ply),
        (
            b"ply\r\nformat binary_little_endian 1.0\r\nelement vertex 3\r\nproperty char x\r\nproperty char y\r\n\
              element face 1\r\nproperty list char char vertex_indices\r\nend_header\r\n\
              \0\0\x01\0\0\x01\x03\0\x01\x02",
            Format::Ply,
        ),
        (b"{\"type\":\"Polygon\",\"coordinates\":[[[0,-0.0],[1,0],[1,0],[0,1],[0,0]]]}", Format::GeoJson),
        (b"{\"type\":\"Topology\",\"transform\":{\"scale\":[0.5,1],\"translate\":[0,-1]},\"objects\":{\"a\":\
           {\"type\":\"Polygon\",\"arcs\":[[2,0,2,-2]]}},\"arcs\":[[[0,1],[2,0]],[[0,1],[0,1],[2,-1]],[]]}", Format::TopoJson),
        (b"\xef\xbb\xbf{\"type\":\"GeometryCollection\",\"geometries\":[{\"type\":\"Point\",\"coordinates\":[5,5]},\
           {\"type\":\"MultiPolygon\",\"coordinates\":[[[[0,0,9],[1,0],[0,1],[0,0]]]]}]}", Format::TopoJson),
    ];
    for (bytes, format) in cases {
        let soup = soup(bytes, format);
        let show = String::from_utf8_lossy(bytes);
        assert_eq!(soup.faces.face_count(), 1, "{show}");
        let mut face: Vec<[f64; 3]> = soup.faces.cycle(0).iter().map(|&v| soup.points[v as usize]).collect();
        let first = face.iter().position(|&p| p == [0.0; 3]).unwrap();
        face.rotate_left(first);
        assert_eq!(face, [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], "{show}");
        assert_eq!(soup.points.len(), 3, "{show}");
    }
}

#[test]
fn places_name_the_line_or_the_path() {
    let obj = soup(b"# c\nv 0 0\nv 1 0\n\nv 0 1\nf 1 2 \\\n 3\nf 3 2 1\n", Format::Obj);
    assert_eq!(
        (obj.places.vertex(2), obj.places.face(0), obj.places.face(1)),
        ("file:5".into(), "file:6".into(), "file:8".into())
    );
    let square = "[[[0,0],[1,0],[0,1],[0,0]]]";
    let json = soup(format!("{{\"type\":\"FeatureCollection\",\"features\":[{{\"type\":\"Feature\",\"id\":7,\"geometry\":\
        {{\"type\":\"Polygon\",\"coordinates\":{square}}}}},{{\"type\":\"Feature\",\"properties\":{{\"NAME\":\"Ohio\"}},\
        \"geometry\":{{\"type\":\"MultiPolygon\",\"coordinates\":[{square},{square}]}}}}]}}").as_bytes(), Format::GeoJson);
    assert_eq!(json.places.face_path(0), Some("features[0] \"7\" polygon 0"));
    assert_eq!(json.places.face(2), "file: features[1] \"Ohio\" polygon 1");
    assert_eq!(json.places.ring(2, 1), "file: features[1] \"Ohio\" polygon 1 ring 1");
    assert_eq!(json.names, ["7", "Ohio", "Ohio"].map(|n| Some(n.to_owned())));
    assert_eq!((json.points.len(), json.faces.corners()), (3, &[0, 1, 2, 0, 1, 2, 0, 1, 2][..]));
}

#[test]
fn notes_say_what_was_left_out() {
    let notes = |text: &[u8], format, drop| {
        let options = ReadOptions { drop_degenerate_rings: drop, ..ReadOptions::default() };
        read_bytes(text, format, "file", &options).unwrap_or_else(|error| panic!("{error}")).notes
    };
    let fragments = |found: Vec<String>, wanted: &[&str]| {
        assert_eq!(found.len(), wanted.len(), "{found:?}");
        for (note, part) in found.iter().zip(wanted) {
            assert!(note.contains(part), "`{note}` lacks `{part}`");
        }
    };
    fragments(
        notes(b"v 0 0\nfoo 1\nbar 2\n", Format::Obj, false),
        &["2 lines with unknown statements were skipped, the first starts with `foo`"],
    );
    fragments(notes(b"ply\nformat binary_little_endian 1.0\nelement vertex 0\nproperty float x\nproperty float y\nend_header\nabc", Format::Ply, false), &["3 bytes after"]);
    fragments(
        notes(br#"{"type":"GeometryCollection","geometries":[{"type":"LineString"},{"type":"Point"},{"type":"Point"},
            {"type":"Polygon","coordinates":[[[0,0,1],[0,0,1],[1,0],[0,1],[0,0]]]},{"type":"Polygon","coordinates":[]}]}"#, Format::GeoJson, false),
        &["1 line geometry was", "2 point geometries were", "1 polygon without any ring was", "third coordinate of 2 points", "1 point that repeats the one before was removed, the first in geometry geometries[3] polygon 0 ring 0"],
    );
    // A degenerate hole goes alone; a degenerate outer ring takes its polygon with it.
    let rings = br#"{"type":"Feature","id":"x","geometry":{"type":"MultiPolygon","coordinates":[
        [[[0,0],[4,0],[0,4],[0,0]],[[1,1],[2,1],[1,1]]],[[[9,9],[8,8],[9,9]],[[0,0],[1,0],[0,1],[0,0]]],
        [[[0,0],[0,4],[-4,0],[0,0]]]]}}"#;
    fragments(
        notes(rings, Format::GeoJson, true),
        &["feature \"x\" polygon 0 ring 1 has only 2 distinct points", "polygon 1 ring 0 has only 2"],
    );
    let options = ReadOptions { drop_degenerate_rings: true, ..ReadOptions::default() };
    let Document::Polygons(soup) = read_bytes(rings, Format::GeoJson, "file", &options).unwrap().document else {
        panic!()
    };
    assert_eq!((soup.points.len(), soup.faces.face_count(), soup.faces.cycle_count()), (4, 2, 2));
    assert_eq!(soup.faces.corners(), [0, 1, 2, 0, 2, 3], "numbered as they come, the dropped ones left out");
    assert_eq!(soup.places.face_path(1), Some("feature \"x\" polygon 2"));
    assert_eq!(soup.names.len(), 2);
}

#[test]
fn polygons_without_rings_leave_no_trace_in_names_and_paths() {
    let text = br#"{"type":"FeatureCollection","features":[
        {"type":"Feature","id":"gone","geometry":{"type":"Polygon","coordinates":[]}},
        {"type":"Feature","properties":{"NAME":"b","name":"a"},"geometry":{"type":"Polygon","coordinates":[[[0,0],[1,0],[0,1],[0,0]]]}},
        {"type":"Feature","properties":{"name":null,"NAME":"b\u00e4"},"geometry":{"type":"Polygon","coordinates":[[[0,0],[1,0],[0,1],[0,0]]]}}]}"#;
    let soup = soup(text, Format::GeoJson);
    assert_eq!(soup.names, [Some("a".to_owned()), Some("bä".to_owned())]);
    assert_eq!(soup.places.face_path(0), Some("features[1] \"a\" polygon 0"));
    assert_eq!(soup.places.face_path(1), Some("features[2] \"bä\" polygon 0"));
}

#[test]
fn points_are_joined_where_they_are_equal_and_nowhere_else() {
    // Two squares side by side; the right one writes the common border with -0 and repeats points. The third
    // is off by the smallest step there is.
    let text = br#"{"type":"MultiPolygon","coordinates":[
        [[[-1,0],[0,0],[0,3],[0,5],[0,7],[-1,7],[-1,0]]],
        [[[1,7],[1,7],[-0.0,7],[-0.0,5],[-0.0,5],[-0.0,3],[-0.0,-0.0],[1,0],[1,7],[1,7]]],
        [[[1,0],[2,0],[1.0000000000000002,7],[1,0]]]]}"#;
    let soup = soup(text, Format::GeoJson);
    let faces: Vec<&[u32]> = soup.faces.outer_cycles().collect();
    assert_eq!(faces, [&[0, 1, 2, 3, 4, 5][..], &[6, 4, 3, 2, 1, 7], &[7, 8, 9]]);
    assert!(soup.points.iter().all(|p| p[0].to_bits() != (-0.0f64).to_bits()), "{:?}", soup.points);
}

#[test]
fn objects_of_a_topology_can_be_chosen() {
    let text = br#"{"type":"Topology","arcs":[[[0,0],[1,0],[0,1],[0,0]]],"objects":{
        "land":{"type":"Polygon","arcs":[[0]]},
        "states":{"type":"GeometryCollection","geometries":[{"type":null},{"type":"MultiPolygon","arcs":[[[0]],[[-1]]],"id":"OH"}]}}}"#;
    let choose = |object: Option<&str>| {
        let options = ReadOptions { object: object.map(str::to_owned), ..ReadOptions::default() };
        read_bytes(text, Format::TopoJson, "file", &options)
    };
    let faces = |read: dcel_kit::io::Read| match read.document {
        Document::Polygons(soup) => soup.faces.outer_cycles().map(<[u32]>::to_vec).collect::<Vec<_>>(),
        _ => panic!(),
    };
    let default = choose(None).unwrap();
    assert!(default.notes[0].contains("land (1 polygon), states (2 polygons); states was read"), "{:?}", default.notes);
    assert_eq!(faces(default), [[0, 1, 2], [0, 2, 1]], "the second uses the arc backwards");
    assert_eq!(faces(choose(Some("land")).unwrap()), [[0, 1, 2]]);
    let error = choose(Some("sea")).unwrap_err().to_string();
    assert!(error.contains("object \"sea\"") && error.contains("the file has land (1 polygon), states"), "{error}");
}
