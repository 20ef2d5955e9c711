//! What is written exactly, and what is refused.

use crate::support::{Face, grid, island, structure, table};
use dcel_kit::io::{
    Format, LoadOptions, Model, ReadOptions, Structure, WriteError, assemble, read_bytes, write, write_path,
    write_triangle,
};
use dcel_kit::plane::{Point, Subdivision};
use dcel_kit::topology::{InnerComponent, Table, isomorphic};
use dcel_kit::{FaceId, VertexId};

fn text(model: &Model<'_>, format: Format) -> String {
    let mut bytes = Vec::new();
    write(&mut bytes, model, format).unwrap_or_else(|error| panic!("{format}: {error}"));
    String::from_utf8(bytes).unwrap()
}

fn refused(table: &Table, format: Format) -> WriteError {
    let mut bytes = Vec::new();
    let error = write(&mut bytes, &Model::table(table), format).expect_err("it was written");
    assert!(bytes.is_empty(), "a refused structure left bytes behind");
    error
}

/// A triangle with an isolated vertex, a name and numbers of all sizes.
fn triangle() -> Table {
    let mut table =
        structure(&[[0.0, -0.0], [0.1, 1e-7], [1e21, 123456789.125], [2.5, 1.0]], &[Face::new(&[&[0, 1, 2]])]);
    let face = table.faces[1].as_mut().unwrap();
    face.name = Some("Ohio \"1\"\t".to_owned());
    face.inner_components.push(InnerComponent::Isolated(VertexId::new(3)));
    table
}

#[test]
fn the_text_is_as_documented() {
    let expected = "dcel 1\n\
        v0 0 -0 out h0\nv1 0.1 1e-7 out h2\nv2 1e21 123456789.125 out h4\nv3 2.5 1 out none\n\
        h0 origin v0 twin h1 next h2 prev h4 face f1\nh1 origin v1 twin h0 next h5 prev h3 face f0\n\
        h2 origin v1 twin h3 next h4 prev h0 face f1\nh3 origin v2 twin h2 next h1 prev h5 face f0\n\
        h4 origin v2 twin h5 next h0 prev h2 face f1\nh5 origin v0 twin h4 next h3 prev h1 face f0\n\
        f0 outer half_edge h1 inner none\nf1 half_edge h0 inner v3 name \"Ohio \\\"1\\\"\\t\"\n";
    assert_eq!(text(&Model::table(&triangle()), Format::Dcel), expected);
}

#[test]
fn the_tables_are_those_of_the_slides() {
    let mut island = island();
    island.faces[3].as_mut().unwrap().name = Some("lake".to_owned());
    let tables = text(&Model::table(&island), Format::Tables);
    let lines: Vec<&str> = tables.lines().collect();
    assert_eq!(
        lines[..3],
        ["Vertex | Coordinates | IncidentEdge", "-------+-------------+-------------", "v0     | (-3, -3)    | h0"]
    );
    let half_edges = lines.iter().position(|line| line.starts_with("Half-edge")).unwrap();
    assert_eq!(lines[half_edges], "Half-edge | Origin | Twin | IncidentFace | Next | Prev");
    assert_eq!(lines[half_edges + 2], "h0        | v0     | h1   | f1           | h2   | h6");
    let faces = lines.iter().position(|line| line.starts_with("Face")).unwrap();
    let expected = [
        "Face | OuterComponent | InnerComponents | Name | Hole",
        "-----+----------------+-----------------+------+-----",
        "f0   | none           | h1              |      |",
        "f1   | h0             | h8              |      |",
        "f2   | h15            | h16             |      |",
        "f3   | h23            | none            | lake | hole",
    ];
    assert_eq!(lines[faces..], expected);
    let plain = text(&Model::table(&triangle()), Format::Tables);
    assert!(plain.contains("\nv3     | (2.5, 1)              | none\n"), "{plain}");
}

/// A face with very many holes has a cell as wide as that, too.
#[test]
fn a_cell_of_a_table_may_be_wider_than_a_format_string_can_say() {
    let mut wide = triangle();
    wide.faces[1].as_mut().unwrap().name = Some("x".repeat(70_000));
    let tables = text(&Model::table(&wide), Format::Tables);
    let last = tables.lines().last().unwrap();
    assert!(last.starts_with("f1 ") && last.ends_with('x') && last.len() > 70_000, "{} bytes", last.len());
    assert!(tables.lines().any(|line| line.len() == last.len() && line.starts_with("-----+")));
}

#[test]
fn what_a_format_cannot_hold_is_refused_by_name() {
    let f1 = FaceId::new(1);
    let island = island();
    for format in [Format::Obj, Format::Off, Format::Ply, Format::PlyBinary] {
        let error = refused(&island, format);
        assert!(matches!(error, WriteError::FaceHasRings { face, .. } if face == f1), "{error}");
        assert!(error.to_string().contains(format.name()), "{error}");
    }
    assert!(
        matches!(refused(&triangle(), Format::GeoJson), WriteError::Lost { element, .. } if element == VertexId::new(3).into())
    );
    assert!(matches!(refused(&triangle(), Format::Obj), WriteError::FaceHasRings { face, .. } if face == f1));
    assert!(matches!(refused(&island, Format::TopoJson), WriteError::ReadOnly { format: "topojson" }));
    assert!(matches!(refused(&island, Format::Map), WriteError::ReadOnly { format: "map" }));
    assert!(matches!(refused(&island, Format::Mesh), WriteError::FaceHasRings { face, .. } if face == f1));
    assert!(matches!(refused(&island, Format::Triangle), WriteError::TwoFiles));
    let squares = grid(2, false);
    let error = write_triangle(&mut Vec::new(), &mut Vec::new(), &Model::table(&squares)).unwrap_err();
    assert!(matches!(error, WriteError::NotTriangle { face, corners: 4 } if face == FaceId::new(3)), "{error}");
    let surface = Model::surface(&squares, |_| Some([0.0; 3]), |f| f.number() == 0);
    for format in [Format::GeoJson, Format::Dcel] {
        let error = write(&mut Vec::new(), &surface, format).unwrap_err();
        assert!(matches!(error, WriteError::InSpace { .. }), "{error}");
    }
}

#[test]
fn broken_structures_are_refused_except_by_the_text() {
    let edit = |from: &str, to: &str| {
        let good = text(&Model::table(&grid(1, true)), Format::Dcel);
        assert!(good.contains(from), "{from} is not in\n{good}");
        table(good.replacen(from, to, 1).as_bytes())
    };
    type Check = fn(&WriteError) -> bool;
    let cases: [(Table, Check); 6] = [
        (edit("v0 0 0", "v0"), |e| matches!(e, WriteError::NoPosition { vertex } if vertex.number() == 0)),
        (
            edit("next h2", "next none"),
            |e| matches!(e, WriteError::BrokenCycle { half_edge, .. } if half_edge.number() == 0),
        ),
        (edit("next h4", "next h2"), |e| matches!(e, WriteError::BrokenCycle { face, .. } if face.number() == 1)),
        (
            edit("h2 origin v1", "h2 origin v7"),
            |e| matches!(e, WriteError::BrokenCycle { half_edge, .. } if half_edge.number() == 2),
        ),
        (
            edit("f1 half_edge h0", "f1 half_edge none"),
            |e| matches!(e, WriteError::NoBoundary { face } if face.number() == 1),
        ),
        (edit("face f2", "face f1"), |e| matches!(e, WriteError::SameFaceTwice { face, .. } if face.number() == 1)),
    ];
    for (i, (table, check)) in cases.iter().enumerate() {
        let error = refused(table, Format::Off);
        assert!(check(&error), "case {i}: {error}");
        assert!(!text(&Model::table(table), Format::Dcel).is_empty());
    }
}

#[test]
fn edges_that_no_polygon_shows_are_not_lost_in_silence() {
    let antenna = table(
        b"dcel 1\nv0 0 0 out h0\nv1 1 0 out h1\nh0 origin v0 twin h1 next h1 prev h1 face f0\n\
        h1 origin v1 twin h0 next h0 prev h0 face f0\nf0 outer half_edge h0\n",
    );
    let error = refused(&antenna, Format::Obj).to_string();
    assert_eq!(error, "h0 belongs to no polygon and would be lost in obj; dcel holds everything");
}

/// A hole that touches the outer cycle at a corner is one cycle with it: a list of corners would pass that corner twice,
/// and no reader takes it. GeoJSON says it with a hole, as it was read.
#[test]
fn a_face_that_touches_itself_is_written_with_holes_or_refused() {
    let square = "[[0,0],[4,0],[4,4],[0,4],[0,0]]";
    let holes = [
        "[[0,0],[1,2],[2,1],[0,0]]",
        "[[4,0],[3,1],[3,2],[4,0]]",
        "[[1,3],[2,3],[2,2],[1,3]],[[2,3],[3,3],[3,2],[2,3]]",
    ];
    for count in 1..=holes.len() {
        let rings = [&[square], &holes[..count]].concat().join(",");
        let read = |text: &str| {
            let read = read_bytes(text.as_bytes(), Format::GeoJson, "touch", &ReadOptions::default()).unwrap();
            match assemble(read, "touch", &LoadOptions::default()).unwrap().structure {
                Structure::Plane(map) => map,
                other => panic!("{other:?} is no map"),
            }
        };
        let map = read(&format!("{{\"type\":\"Polygon\",\"coordinates\":[{rings}]}}"));
        let again = read(&text(&Model::planar(&map), Format::GeoJson));
        assert!(isomorphic(&map, &again).is_ok(), "{count} holes");
        for format in [Format::Obj, Format::Off, Format::Ply, Format::Stl] {
            let error = write(&mut Vec::new(), &Model::planar(&map), format).unwrap_err();
            assert!(matches!(error, WriteError::VertexTwice { face, .. } if face.number() == 1), "{error}");
            assert!(error.to_string().contains("twice, which"), "{error}");
        }
    }
}

/// The full check finds it at a corner; without it, which trusts, the shared side gives it away. Both say the same.
#[test]
fn a_hole_that_begins_at_a_side_is_named_with_and_without_the_check() {
    let text = r#"{"type":"Polygon","coordinates":[[[0,0],[8,0],[8,8],[0,8],[0,0]],[[0,8],[8,8],[2,4],[0,8]]]}"#;
    for trust in [false, true] {
        let read = read_bytes(text.as_bytes(), Format::GeoJson, "x", &ReadOptions::default()).unwrap();
        let error = assemble(read, "x", &LoadOptions { trust, ..LoadOptions::default() }).unwrap_err();
        let rings = "x:1:34: rings 0 and 1 of geometry polygon 0 have in common the side ";
        assert!(error.to_string().starts_with(rings), "{error}");
        let rest = ", so that none of the polygon lies between them (geometry polygon 0 ring 1: line 1:66)";
        assert!(error.to_string().ends_with(rest), "{error}");
    }
}

/// A corner that lies inside of the line between its neighbours by less than a product of doubles can tell.
#[test]
fn triangles_from_a_corner_are_judged_exactly() {
    let corners = [[30.0, 3.0], [3.0, 0.0], [4.0, 0.0], [6.363636363636363, 0.2727272727272727]].map(Point::from);
    let bent = Subdivision::polygon(&corners).unwrap();
    assert_eq!(bent.geometry_violations(), []);
    let error = write(&mut Vec::new(), &Model::planar(&bent), Format::Stl).unwrap_err();
    assert!(matches!(error, WriteError::NoFan { face, .. } if face.number() == 1), "{error}");
    // From another corner on, the triangles are right.
    let mut turned = corners;
    turned.rotate_left(3);
    let whole = Subdivision::polygon(&turned).unwrap();
    let read =
        read_bytes(text(&Model::planar(&whole), Format::Stl).as_bytes(), Format::Stl, "x", &ReadOptions::default());
    assert!(assemble(read.unwrap(), "x", &LoadOptions::default()).is_ok());
}

#[test]
fn a_refused_structure_leaves_the_file_alone() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.obj");
    std::fs::write(&path, "precious").unwrap();
    assert!(write_path(&path, &Model::table(&island()), Format::Obj).is_err());
    assert_eq!(std::fs::read_to_string(&path).unwrap(), "precious");
    write_path(&path, &Model::table(&grid(1, false)), Format::Obj).unwrap();
    assert_eq!(std::fs::read_to_string(&path).unwrap().lines().count(), 7);
}

#[test]
fn polygon_files_are_plain() {
    let grid = grid(1, true);
    assert_eq!(
        text(&Model::table(&grid), Format::Obj),
        "# 4 points, 2 polygons\nv 0 0 0\nv 0.3333333333333333 0 0\nv 0 1.4285714285714284e-8 0\nv 0.3333333333333333 1.4285714285714284e-8 0\nf 1 2 4\nf 1 4 3\n"
    );
    let square = structure(&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0]], &[Face::new(&[&[0, 1, 2]])]);
    assert_eq!(
        text(&Model::planar(&square), Format::GeoJson),
        "{\"type\":\"FeatureCollection\",\"features\":[\n{\"type\":\"Feature\",\"id\":\"f1\",\"properties\":{},\
         \"geometry\":{\"type\":\"Polygon\",\"coordinates\":[[[0,0],[4,0],[4,4],[0,0]]]}}\n]}\n"
    );
}
