//! What the segment formats hold, and what becomes of it.

use crate::support::read;
use dcel_kit::io::{
    Document, Format, LoadError, LoadOptions, Read, ReadOptions, SegmentSoup, Structure, load, read_bytes,
};
use dcel_kit::plane::{Point, Subdivision};
use dcel_kit::{FaceId, VertexId};

fn soup(read: Read) -> SegmentSoup {
    match read.document {
        Document::Segments(soup) => soup,
        other => panic!("not segments: {other:?}"),
    }
}

/// Points as whole numbers, segments, and notes.
type Held = (Vec<(i32, i32)>, Vec<[u32; 2]>, Vec<String>);

fn held(text: &str, format: Format) -> Held {
    let read = read(text.as_bytes(), format).unwrap_or_else(|error| panic!("{error}"));
    let notes = read.notes.clone();
    let soup = soup(read);
    (soup.points.iter().map(|p| (p.x as i32, p.y as i32)).collect(), soup.segments, notes)
}

#[test]
fn every_geometry_of_well_known_text_is_read() {
    let line = (vec![(0, 0), (4, 0), (4, 3)], vec![[0, 1], [1, 2]], vec![]);
    for text in [
        "LINESTRING (0 0, 4 0, 4 3)",
        "linestring(0 0,4 0,4 3)\r\n",
        "700 LineString(+0.0 0e0, 4. .0,\n4 3.0)# a road",
        "SRID=4326;LINEARRING (0 0, 4 0, 4 3);",
        "MULTILINESTRING ((0 0, 4 0, 4 3))",
        "GEOMETRYCOLLECTION (LINESTRING (0 0, 4 0, 4 3), POINT EMPTY, POLYGON EMPTY)",
        "GEOMETRYCOLLECTION(GEOMETRYCOLLECTION(LINESTRING(0 0,4 0,4 3)),GEOMETRYCOLLECTION EMPTY)",
        "\u{feff}LINESTRING (0 0, 4 0, 4 3)",
    ] {
        assert_eq!(held(text, Format::Wkt), line, "{text}");
    }
    let dropped = "the third coordinate of 3 points was dropped".to_owned();
    for text in [
        "LINESTRING Z (0 0 9, 4 0 9, 4 3 9)",
        "LINESTRINGZM(0 0 9 9, 4 0 9 9, 4 3 9 9)",
        "LINESTRING (0 0 1, 4 0 1, 4 3 1)",
    ] {
        assert_eq!(held(text, Format::Wkt), (line.0.clone(), line.1.clone(), vec![dropped.clone()]), "{text}");
    }
    // A ring comes back to its first point, which is there once: as a polygon, and on request as its outline.
    let outlines = ReadOptions { outlines: true, ..ReadOptions::default() };
    for text in ["POLYGON ((0 0, 4 0, 0 3, 0 0))", "MULTIPOLYGON (((0 0, 4 0, 0 3, 0 0)))"] {
        let Document::Polygons(polygon) = read(text.as_bytes(), Format::Wkt).unwrap().document else {
            panic!("{text}")
        };
        assert_eq!((polygon.points.len(), polygon.faces.cycle(0)), (3, &[0, 1, 2][..]), "{text}");
        let outline = soup(read_bytes(text.as_bytes(), Format::Wkt, "file", &outlines).unwrap());
        assert_eq!(outline.points, [(0., 0.), (4., 0.), (0., 3.)].map(Point::from), "{text}");
        assert_eq!(outline.segments, [[0, 1], [1, 2], [2, 0]], "{text}");
    }
    for text in ["POINT(1 2) POINT(3 4)", "MULTIPOINT (1 2, 3 4)", "MULTIPOINT ((1 2), EMPTY, (3 4))"] {
        assert_eq!(held(text, Format::Wkt), (vec![(1, 2), (3, 4)], vec![], vec![]), "{text}");
    }
}

#[test]
fn collections_may_be_deep_but_not_without_end() {
    let nested = |depth: usize| format!("{}POINT(0 0){}", "GEOMETRYCOLLECTION(".repeat(depth), ")".repeat(depth));
    assert!(read(nested(60).as_bytes(), Format::Wkt).is_ok());
    let error = read(nested(100_000).as_bytes(), Format::Wkt).unwrap_err().to_string();
    assert!(error.contains("a collection in so many others cannot be read"), "{error}");
}

#[test]
fn lines_of_geojson_are_segments_unless_there_are_polygons() {
    let line = r#"{"type":"LineString","coordinates":[[0,0],[4,0],[4,3,9]]}"#;
    let polygon = r#"{"type":"Polygon","coordinates":[[[10,0],[14,0],[14,3],[10,0]]]}"#;
    let both = format!(
        r#"{{"type":"GeometryCollection","geometries":[{line},{polygon},{{"type":"Point","coordinates":[7,7]}}]}}"#
    );
    let dropped = vec!["the third coordinate of 1 point was dropped".to_owned()];
    assert_eq!(held(line, Format::GeoJson), (vec![(0, 0), (4, 0), (4, 3)], vec![[0, 1], [1, 2]], dropped));
    assert!(matches!(read(both.as_bytes(), Format::GeoJson).unwrap().document, Document::Polygons(_)));
    let outlines = ReadOptions { outlines: true, ..ReadOptions::default() };
    let all = soup(read_bytes(both.as_bytes(), Format::GeoJson, "file", &outlines).unwrap());
    assert_eq!(all.segments, [[0, 1], [1, 2], [3, 4], [4, 5], [5, 3]]);
    assert_eq!((all.points.len(), all.points[6]), (7, Point::new(7.0, 7.0)));
    let upside_down = ReadOptions { y_down: true, ..ReadOptions::default() };
    let soup = soup(read_bytes(line.as_bytes(), Format::GeoJson, "file", &upside_down).unwrap());
    assert_eq!(soup.points[2], Point::new(4.0, -3.0));
}

const PLAN: &str = "8 2 0 0\n1 0 0\n2 9 0\n3 9 9\n4 0 9\n5 3 3\n6 6 3\n7 6 6\n8 3 6\n8 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n5 5 6\n6 6 7\n7 7 8\n8 8 5\n";

fn load_text(name: &str, text: &str, split: bool) -> Result<(Subdivision, Vec<String>), LoadError> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(name);
    std::fs::write(&path, text).unwrap();
    let options = LoadOptions { mend: split, ..LoadOptions::default() };
    let loaded = load(&path, &options)?;
    match loaded.structure {
        Structure::Plane(subdivision) => Ok((subdivision, loaded.notes)),
        other => panic!("not a plane: {other:?}"),
    }
}

#[test]
fn hole_points_of_a_poly_file_mark_the_faces_around_them() {
    let (s, _) = load_text("plan.poly", &format!("{PLAN}1\n1 4 4\n"), false).unwrap();
    assert_eq!((s.vertex_count(), s.edge_count(), s.face_count()), (8, 8, 3));
    assert_eq!(s.hole_faces().collect::<Vec<_>>(), [FaceId::new(2)]);
    assert_eq!(s.point(VertexId::new(6)), Point::new(6.0, 6.0));
    // From 0, with the points in a .node file beside it, and the ring as the hole.
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("plan.poly");
    std::fs::write(folder.path().join("plan.node"), "3 2 0 0\n0 0 0\n1 4 0\n2 0 4\n").unwrap();
    std::fs::write(&path, "0 2 0 0\n3 0\n0 0 1\n1 1 2\n2 2 0\n1\n0 1 1\n1\n0 1 1 7.5 0.1\n").unwrap();
    let loaded = load(&path, &LoadOptions::default()).unwrap();
    let Structure::Plane(s) = loaded.structure else { panic!() };
    assert!(s.is_hole(FaceId::new(1)));
    assert_eq!(loaded.notes, ["1 regional attribute was left out"]);
    std::fs::remove_file(folder.path().join("plan.node")).unwrap();
    let error = load(&path, &LoadOptions::default()).unwrap_err().to_string();
    assert!(error.contains("a .node file, is missing"), "{error}");
    for (hole, what) in [("4 9", "lies on e2"), ("9 9", "lies on v2"), ("10 4", "lies in the outer face")] {
        let error = load_text("plan.poly", &format!("{PLAN}2\n1 4 4\n2 {hole}\n"), false).unwrap_err().to_string();
        assert!(error.contains("plan.poly:21: hole point 1") && error.contains(what), "{error}");
    }
}

#[test]
fn what_meets_is_told_with_its_lines_and_split_on_request() {
    let text = "# x y x y\n0 0 4 4\n\n0 4 4 0\n0 0 4 4\n5 5 5 5\n";
    let error = load_text("a.segments", text, false).unwrap_err();
    let told = error.to_string();
    assert!(told.ends_with("a.segments:2: segments 0 and 1 cross at (2, 2) (segment 1: line 4)"), "{told}");
    let (s, notes) = load_text("a.segments", text, true).unwrap();
    assert_eq!((s.vertex_count(), s.edge_count()), (6, 4));
    assert_eq!(
        notes,
        [
            "1 segment without length was left out",
            "1 segment repeats an earlier one and was left out",
            "1 vertex was made where segments cross",
            "3 segments were split where they meet others",
        ]
    );
    let (_, notes) = load_text("b.wkt", "LINESTRING(0 0, 3 1)\nLINESTRING(0 1, 2 0)", true).unwrap();
    assert!(notes[2].starts_with("1 crossing was moved by rounding, none further than"), "{notes:?}");
    let point_on = "LINESTRING (0 0, 4 0)\n\nPOINT (2 0)";
    let told = load_text("c.wkt", point_on, false).unwrap_err().to_string();
    assert!(
        told.ends_with("c.wkt:3: point 2, (2, 0), lies in the interior of segment 0 (segment 0: line 1)"),
        "{told}"
    );
}
