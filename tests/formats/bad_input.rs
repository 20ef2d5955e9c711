//! Bad input: the message, the place, and no panic whatever the bytes are.

use crate::support::{Random, grid, island, read};
use cpu_time::ThreadTime;
use dcel_kit::io::{
    Document, Format, LoadOptions, Model, ReadOptions, ReadProblem, assemble, read_bytes, read_path, read_triangle,
    write,
};
use std::time::Duration;

const PLY: &str = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nelement face 1\n\
                   property list uchar int vertex_index\nend_header\n";

/// (format, input, start of the message, part of the rest)
fn cases() -> Vec<(Format, Vec<u8>, &'static str, &'static str)> {
    use Format::{Dcel, GeoJson, Mesh, Obj, Off, Ply, Poly, Segments, TopoJson, Wkt};
    let mut cases: Vec<(Format, Vec<u8>, &str, &str)> = Vec::new();
    let mut add = |format, text: &str, place, part| cases.push((format, text.as_bytes().to_vec(), place, part));
    add(
        GeoJson,
        r#"{"type":"LineString","coordinates":[[0,0]]}"#,
        "file:1:36: ",
        "geometry: expected two positions or more",
    );
    add(Wkt, "POINT (1\n 1e99)\n", "file:2:2: ", "y = 1e99 is outside the exact range");
    add(Wkt, "LINESTRING (0 0, 1 1", "file:1:21: ", "expected `,` or `)`, found the end of the file");
    add(
        Wkt,
        "LINESTRING (0 0 1 1)",
        "file:1:12: ",
        "expected two points or more, found one; points are separated by commas",
    );
    add(Wkt, "# ü\nLINESTRING 0 0, 1 1", "file:2:12: ", "expected `(`, found `0`");
    add(Wkt, "CIRCLE (0 0)", "file:1:1: ", "unknown word `CIRCLE`; POINT, LINESTRING");
    add(Wkt, "POINT (1 x)", "file:1:10: ", "expected the y of a point, found `x`");
    add(Wkt, "POINT (1 1.2.3)", "file:1:10: ", "`1.2.3` is not a geometry or a number");
    add(
        Wkt,
        "POLYGON ((0 0, 1 0, 1 1))",
        "file:1:10: ",
        "the ring starts at (0, 0) and ends at (1, 1); repeat the first point",
    );
    add(Wkt, "POINT Z (1 1)", "file:1:13: ", "expected as many coordinates as the geometry says, found `)`");
    add(Wkt, "POINT (1 1)\n7\n", "file:3:1: ", "expected POINT, LINESTRING, POLYGON");
    add(Wkt, "SRID 4", "file:1:6: ", "expected `=`");
    add(Segments, "0 0 1\n", "file:1:6: ", "expected the y of the second end, found the end of the line");
    add(Segments, "0 0 1 1\n5\n", "file:2:2: ", "expected the y of the point");
    add(Segments, "0 0 1 1 2\n", "file:1:9: ", "a segment is x y x y, a point is x y; one of them a line");
    add(
        Segments,
        "3\n0 0 1 1\n",
        "file:1:1: ",
        "expected the number of segments, 1, found `3`; correct it or leave the line out",
    );
    add(Segments, "0 0 1 nan\n", "file:1:7: ", "y is NaN");
    add(Segments, "0,0 1 1\n", "file:1:1: ", "`0,0` is not a number");
    add(Poly, "2 3 0 0\n1 0 0 0\n", "file:1:3: ", "whose dimension is not 2");
    add(
        Poly,
        "2 2 0 0\n1 0 0\n2 1 0\n1 0\n1 1 3\n0\n",
        "file:5:5: ",
        "point 3 does not exist: there are 2; they are numbered 1 to 2",
    );
    add(Poly, "2 2 0 0\n1 0 0\n2 1 0\n1 0\n3 1 2\n0\n", "file:5:1: ", "expected the number 1 of the next segment");
    add(Poly, "2 2 0 0\n1 0 0\n2 1 0\n1 0\n1 1 2\n", "file:6:1: ", "expected the number of holes");
    add(Poly, "2 2 0 0\n1 0 0\n2 1 0\n0 0\n1\n1 5\n", "file:6:4: ", "expected the y of hole 0");
    add(Poly, "1 2 0 0\n1 0 0\n0 0\n0\n0\n7", "file:6:1: ", "more than the 0 regions");
    add(
        GeoJson,
        "{\"type\":\"LineString\",\n\"coordinates\":[[0,0],[1]]}",
        "file:2:22: ",
        "geometry position 1: expected a position",
    );
    add(
        GeoJson,
        "{\"type\":\"LineString\",\"coordinates\":[[0,0],[1,1e99]]}",
        "file:1:43: ",
        "geometry position 1: y = 1e99 is outside",
    );
    add(
        GeoJson,
        "{\"type\":\"MultiLineString\",\"coordinates\":[0]}",
        "file:1:42: ",
        "geometry part 0: expected an array of positions",
    );
    add(Obj, "v 0 0\nv 1 NaN\n", "file:2:5: ", "y is NaN");
    add(Obj, "v 0 0\r\n\tv 1 -inf\r\n", "file:2:6: ", "y is -inf");
    add(Obj, "v 0 0 1e-50\n", "file:1:7: ", "z = 1e-50 is outside the exact range");
    add(Obj, "v 1e99 0\n", "file:1:3: ", "x = 1e99 is outside");
    add(Obj, "v 1,5 0\n", "file:1:3: ", "`1,5` is not a number; write a number such as 1.5, with a decimal point");
    add(Obj, "# ü\nv 0 # ü 0\n", "file:2:5: ", "expected the y of vertex 1, found the end of the line");
    add(Obj, "v 0", "file:1:4: ", "expected the y of vertex 1, found the end of the file");
    add(Obj, "v 0 0 0 1 1 1 1 1\n", "file:1:17: ", "expected the end of the line, found `1`");
    add(Obj, "v 0 0\nf 1 0 1\n", "file:2:5: ", "vertex 0 does not exist: there are 1; OBJ counts from 1");
    add(Obj, "v 0 0\nf 1 2 1\nv 1 1\nf 1 4/1 2\n", "file:4:5: ", "vertex 4 does not exist: there are 2");
    add(Obj, "v 0 0\nf -1 -2\nv 1 1\n", "file:2:6: ", "only 1 vertices come before this line");
    add(Obj, "v 0 0\nf 1 9999999999\n", "file:2:5: ", "vertex 9999999999 does not exist");
    add(Obj, "v 0 0\nf 1 99999999999999999999\n", "file:2:5: ", "expected a corner such as 3");
    add(Obj, "v 0 0\nf 1/2/3/4\n", "file:2:3: ", "expected a corner such as 3, 3/1, 3//2 or 3/1/2, found `1/2/3/4`");
    add(Obj, "v 0 0\nf 1/a\n", "file:2:3: ", "expected a corner");
    add(Obj, "v 0 0\nf \n", "file:2:3: ", "expected the corners of a face");
    add(Obj, "hello world\n", "file:1:1: ", "unknown word `hello`; an OBJ file has lines such as");
    add(Obj, "v 0 0\nf 1 3000000000\n", "file:2:5: ", "vertex 3000000000 does not exist: there are 1");
    add(Obj, "\u{feff}v x 0\n", "file:1:3: ", "`x` is not a number");
    add(Off, "\n# only a comment\n", "file:3:1: ", "expected the word OFF, found the end of the file");
    add(Off, "OFT\n", "file:1:1: ", "expected the word OFF, found `OFT`");
    add(Off, "OFF BINARY\n", "file:1:1: ", "a binary OFF file cannot be read");
    add(Off, "4OFF\n", "file:1:1: ", "points of other dimensions");
    add(Off, "OFF\n3 -1 0\n", "file:2:3: ", "`-1` is not a count");
    add(Off, "OFF\n3 1 0 0\n", "file:2:7: ", "expected the end of the line");
    add(Off, "OFF\n4000000000 4000000000 0\n0 0 0\n", "file:4:1: ", "expected vertex 1 of 4000000000");
    add(Off, "OFF\n1 1 0\n0 0\n", "file:3:4: ", "expected the z of vertex 0");
    add(Off, "OFF\n1 1 0\n0 0 0 red\n", "file:3:7: ", "`red` is not a number");
    add(
        Off,
        "OFF\n1 1 0\n0 0 0\n3 0 0 1\n",
        "file:4:7: ",
        "vertex 1 does not exist: there are 1; they are numbered 0 to 0",
    );
    add(Off, "OFF\n1 1 0\n0 0 0\n3 0 0\n", "file:4:6: ", "expected corner 2 of 3 of face 0");
    add(Off, "OFF\n1 2 0\n0 0 0\n1 0\n", "file:5:1: ", "expected face 1 of 2, found the end of the file");
    add(Off, "OFF\n1 1 0\n0 0 0\n0\n", "file:4:1: ", "expected the number of corners, at least 1");
    add(Off, "OFF\n1 1 0\n0 0 0\n1 0\n\n1 0\n", "file:6:1: ", "more than the 1 faces that the header counts");
    add(Mesh, "MeshVersionFormatted 1\n", "file:1:1: ", "a .mesh file of Medit cannot be read");
    add(Mesh, "mesh\n1\n", "file:2:1: ", "expected version 2");
    add(Mesh, "mesh\n2\n1 1\n0 0 1 1\n", "file:4:7: ", "polygon 1 does not exist: there are 1");
    add(Mesh, "mesh\n2\n1 1\n0 0 1 -1\n1 0 -2\n", "file:5:5: ", "polygon -2 does not exist");
    add(Mesh, "mesh\n2\n9999999999 1\n0 0 1 0\n", "file:5:1: ", "expected vertex 1 of 9999999999");
    add(Mesh, "mesh\n2\n1 0\n0 0 0 7", "file:4:7: ", "more than the 0 polygons");
    add(Ply, "plx\n", "file:1:1: ", "expected the word `ply`");
    add(Ply, "ply\nformat ascii 2.0\n", "file:2:14: ", "expected version 1.0");
    add(Ply, "ply\nelement vertex 1\nend_header\n", "file:3:11: ", "expected a line such as `format ascii 1.0`");
    add(
        Ply,
        "ply\nformat ascii 1.0\nelement vertex 1\nproperty list char int x\nproperty float y\nend_header\n",
        "file:6:11: ",
        "expected properties x and y of the element vertex",
    );
    add(
        Ply,
        "ply\nformat ascii 1.0\nelement face 1\nproperty list char int x\nend_header\n",
        "file:5:11: ",
        "the property list vertex_indices",
    );
    add(
        Ply,
        "ply\nformat ascii 1.0\nelement face 1\nproperty list float int vertex_index\nend_header\n",
        "file:4:15: ",
        "a type of whole numbers",
    );
    add(
        Ply,
        "ply\nformat ascii 1.0\nelement face 1\nproperty list char float vertex_index\nend_header\n",
        "file:4:20: ",
        "a type of whole numbers",
    );
    add(Ply, "ply\nformat ascii 1.0\nelement tristrips 1\n", "file:3:9: ", "triangle strips cannot be read");
    add(Ply, "ply\nproperty float x\n", "file:2:1: ", "an element before the first property");
    add(Ply, "ply\nelement a 1\nproperty float x\nproperty int x\n", "file:4:14: ", "each property once");
    add(Ply, "ply\nelement a 1\nelement a 1\n", "file:3:9: ", "each element once");
    add(Ply, "ply\nelement a 1\nproperty half x\n", "file:3:10: ", "expected a type");
    add(Ply, "ply\nformat ascii 1.0\nelements a 1\n", "file:3:1: ", "unknown word `elements`");
    add(Ply, &format!("{PLY}0 0\n1 nan\n"), "file:10:3: ", "y is NaN");
    add(Ply, &format!("{PLY}0 0\n1 0 2\n"), "file:10:5: ", "expected the end of the line, found `2`");
    add(Ply, &format!("{PLY}0 0\n1 0\n0 1\n3 0 1 3\n"), "file:12:7: ", "vertex 3 does not exist: there are 3");
    add(Ply, &format!("{PLY}0 0\n1 0\n0 1\n3 0 1\n"), "file:12:6: ", "expected a corner of a face");
    add(Ply, &format!("{PLY}0 0\n1 0\n0 1\n0\n"), "file:13:1: ", "face 0 without any");
    add(Ply, &format!("{PLY}0 0\n1 0\n0 1\n1 0\n7\n"), "file:13:1: ", "expected the end of the file");
    add(Ply, &PLY.replace("vertex 3", "vertex 4000000000"), "file:9:1: ", "expected vertex 0 of 4000000000");
    add(GeoJson, "{\"type\":\n \"ü\",, }", "file:2:6: ", "not JSON: ");
    // CR alone ends a line here as in all formats.
    add(GeoJson, "{\"type\":\r \"ü\",\r\n, }", "file:3:1: ", "not JSON: ");
    add(
        GeoJson,
        "{\"type\":\"Polygon\",\"coordinates\":[[[1e999,0]]]}",
        "file:1:35: geometry polygon 0 ring 0 position 0: ",
        "x is inf",
    );
    add(GeoJson, "[1]", "file: the file: ", "expected a GeoJSON or TopoJSON object");
    add(GeoJson, r#"{"type":"Feature","geometry":{"type":"Circle"}}"#, "file: feature: ", "not the type \"Circle\"");
    add(
        GeoJson,
        r#"{"type":"FeatureCollection","features":[{"type":"Feature","id":"a","geometry":{"type":"Polygon"}}]}"#,
        "file: features[0] \"a\": ",
        "expected an array \"coordinates\"",
    );
    add(
        GeoJson,
        r#"{"type":"Polygon","coordinates":[[[0,0],[1]]]}"#,
        "file:1:41: geometry polygon 0 ring 0 position 1: ",
        "a position [x, y]",
    );
    add(
        GeoJson,
        r#"{"type":"Polygon","coordinates":[[[0,0],[1e99,1]]]}"#,
        "file:1:41: geometry polygon 0 ring 0 position 1: ",
        "x = 1e99 is outside",
    );
    add(
        GeoJson,
        r#"{"type":"Polygon","coordinates":[[[0,0],[1,0],[0,1]]]}"#,
        "file:1:34: geometry polygon 0 ring 0: ",
        "the ring starts at (0, 0) and ends at (0, 1); repeat the first point",
    );
    add(
        GeoJson,
        r#"{"type":"Polygon","coordinates":[[[0,0],[1,0],[0,1],[0,0]],[]]}"#,
        "file:1:60: geometry polygon 0 ring 1: ",
        "only 0 distinct points and encloses nothing; correct the data, or drop such rings with --drop-degenerate-rings",
    );
    add(
        GeoJson,
        r#"{"type":"Polygon","coordinates":[[[0,0],[1,0],[0,0],[1,0],[0,0]]]}"#,
        "file:1:34: geometry polygon 0 ring 0: ",
        "only 2 distinct",
    );
    add(
        GeoJson,
        r#"{"type":"Polygon","coordinates":[[[0,0,["]\"",{"a":[1]}]],[0 , 1,5],["1",0]]]}"#,
        "file:1:69: ",
        "position 2: expected a position",
    );
    add(TopoJson, r#"{"type":"Topology","arcs":[]}"#, "file: the file: ", "an object \"objects\"");
    add(
        TopoJson,
        r#"{"type":"Topology","arcs":[[[0,0],[1,0],[0,1]],[[1,1],[0,0]]],"objects":{"a":{"type":"Polygon","arcs":[[0,1]]}}}"#,
        "file:1:107: a polygon 0 ring 0: ",
        "arc 1 does not start where the arc before it ends",
    );
    add(
        TopoJson,
        r#"{"type":"Topology","arcs":[],"objects":{"a":{"type":"Polygon","arcs":[[-1]]}}}"#,
        "file:1:72: a polygon 0 ring 0: ",
        "arcs that exist, not -1 (there are 0)",
    );
    add(
        TopoJson,
        r#"{"type":"Topology","transform":{"scale":[1]},"arcs":[],"objects":{}}"#,
        "file: transform: ",
        "two numbers each",
    );
    add(Dcel, "dcl 1\n", "file:1:1: ", "expected the line `dcel 1`, found `dcl`");
    add(Dcel, "dcel 2\n", "file:1:6: ", "expected version 1");
    add(Dcel, "dcel 1 v0\n", "file:1:8: ", "the records start on the next line");
    add(Dcel, "dcel 1\ne0\n", "file:2:1: ", "unknown word `e0`; a line starts with the name of an element");
    add(Dcel, "dcel 1\nv-1\n", "file:2:1: ", "unknown word `v-1`; `v-1` is not the name of a vertex");
    add(Dcel, "dcel 1\nv0 0 nan\n", "file:2:6: ", "y is NaN");
    add(Dcel, "dcel 1\nv0 1e300 0\n", "file:2:4: ", "x = 1e300 is outside");
    add(Dcel, "dcel 1\nv0 0\n", "file:2:5: ", "expected the y of v0");
    add(Dcel, "dcel 1\nv0 0 0 otu h1\n", "file:2:8: ", "unknown word `otu`; the words here are out");
    add(Dcel, "dcel 1\nv0 0 0 out v1\n", "file:2:12: ", "`v1` is not the name of a half-edge");
    add(Dcel, "dcel 1\nv0 0 0 out h1 h2\n", "file:2:15: ", "one record a line");
    add(Dcel, "dcel 1\nh0 nxet h1\n", "file:2:4: ", "unknown word `nxet`; did you mean `next`?");
    add(Dcel, "dcel 1\nh0 orign v1\n", "file:2:4: ", "did you mean `origin`?");
    add(Dcel, "dcel 1\nh0 next h1 next h1\n", "file:2:12: ", "`next` was given before, in line 2");
    add(Dcel, "dcel 1\nh0 next\n", "file:2:8: ", "expected an id, or none");
    add(Dcel, "dcel 1\nh0\n# c\nh1\nh0 next h1\n", "file:5:1: ", "h0 was given before, in line 2");
    add(Dcel, "dcel 1\nf0 outer\nf1 outer\n", "file:3:4: ", "the outer face (f0) was given before, in line 2");
    add(Dcel, "dcel 1\nf0 rings f1\n", "file:2:10: ", "expected a half-edge or a vertex");
    add(Dcel, "dcel 1\nf0 inner h1 f1\n", "file:2:13: ", "unknown word `f1`");
    add(Dcel, "dcel 1\nf0 name Ohio\n", "file:2:9: ", "expected a text in quotes, found `Ohio`");
    add(Dcel, "dcel 1\nf0 name \"Ohio\n", "file:2:9: ", "close the text with a quote");
    add(Dcel, "dcel 1\nf0 name \"a\\x\"\n", "file:2:9: ", "expected a text in quotes");
    add(
        Dcel,
        "dcel 1\nh2147483645 next h1\n",
        "file:2:1: ",
        "h2147483645 is too large a number: this file may number its half-edges up to 1000002",
    );
    for format in [Obj, Off, Ply, Mesh, GeoJson, TopoJson, Dcel] {
        cases.push((format, Vec::new(), "file: the file is empty", ""));
        cases.push((
            format,
            b"\xff\xfeO\0F\0F\0".to_vec(),
            "file: text in UTF-16 cannot be read; save the file as UTF-8",
            "",
        ));
    }
    for format in [Off, Ply, Mesh, Dcel] {
        cases.push((format, b"\xe9t\xe9 1\n".to_vec(), "file:1:1: this is not text in UTF-8", ""));
    }
    cases.push((GeoJson, b"{\"type\":\n\"\xff\"}".to_vec(), "file:2:2: this is not text in UTF-8", ""));
    cases.push((Obj, b"v 0 0\nv \xff 0\n".to_vec(), "file:2:3: this is not text in UTF-8", ""));
    cases.push((Obj, b"v 0 0\n\xff 0\n".to_vec(), "file:2:1: this is not text in UTF-8", ""));
    cases.push((Dcel, b"dcel 1\nf0 name \"\xff\"\n".to_vec(), "file:2:9: this is not text in UTF-8", ""));
    cases.push((
        Format::Triangle,
        b"3 2 0 0\n".to_vec(),
        "file: the partner file of this .node or .ele file is missing",
        "",
    ));
    cases.push((Format::Tables, b"x".to_vec(), "file: tables is written, not read", ""));
    cases
}

#[test]
fn bad_input_is_refused_at_its_place() {
    let mut wrong = Vec::new();
    for (format, bytes, place, part) in cases() {
        let show = String::from_utf8_lossy(&bytes).into_owned();
        let found = read(&bytes, format).map_or_else(|error| error.to_string(), |read| format!("{read:?}"));
        if !found.starts_with(place) || !found.contains(part) {
            wrong.push(format!("{format} {show:?}\n  wanted {place}… {part}\n  found  {found}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn the_two_files_of_triangle_name_their_own_lines() {
    let good = ("3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n", "1 3 0\n1 1 2 3\n");
    let cases = [
        ("3 3 0 0\n", good.1, "node:1:3: ", "dimension is not 2"),
        ("3 2 0 0\n2 0 0\n", good.1, "node:2:1: ", "expected the number 0 of the next point, found `2`"),
        ("3 2 0 0\n1 0 0\n3 0 0\n", good.1, "node:3:1: ", "expected the number 2 of the next point"),
        ("3 2 0 0\n1 0 0\n2 1 0\n", good.1, "node:4:1: ", "expected point 2 of 3"),
        ("4000000000 2 0 0\n1 0 0\n", good.1, "node:3:1: ", "expected point 1 of 4000000000"),
        ("1 2 1 0\n1 0 0\n", good.1, "node:2:6: ", "expected an attribute or marker"),
        ("1 2 0 0\n1 0 0 5\n", good.1, "node:2:7: ", "more than the first line of the file announces"),
        ("1 2 0 0\n1 0 0\n2 0 0\n", good.1, "node:3:1: ", "more than the 1 points"),
        (good.0, "1 6 0\n", "ele:1:3: ", "six corners a triangle (second order) cannot be read"),
        (good.0, "1 4 0\n", "ele:1:3: ", "tetrahedra (TetGen) cannot be read"),
        (good.0, "1 3 0\n1 1 2 4\n", "ele:2:7: ", "point 4 does not exist: there are 3; they are numbered 1 to 3"),
        (good.0, "1 3 0\n1 0 1 2\n", "ele:2:3: ", "point 0 does not exist"),
        (good.0, "", "ele: ", "the file is empty"),
    ];
    for (node, ele, place, part) in cases {
        let read = read_triangle(node.as_bytes(), ele.as_bytes(), "node", "ele", &ReadOptions::default());
        let error = read.expect_err(node).to_string();
        assert!(error.starts_with(place) && error.contains(part), "wanted {place}… {part}\nfound  {error}");
    }
}

#[test]
fn paths_that_are_no_files_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let error = read_path(folder.path(), &ReadOptions::default()).unwrap_err();
    assert!(matches!(&*error.what, ReadProblem::Io { reason } if reason == "it is a directory"), "{error}");
    let missing = folder.path().join("no.obj");
    let error = read_path(&missing, &ReadOptions::default()).unwrap_err().to_string();
    assert!(error.starts_with(&format!("{}: cannot be read: ", missing.display())), "{error}");
    let unknown = folder.path().join("a.xyz");
    std::fs::write(&unknown, "hello\n").unwrap();
    let error = read_path(&unknown, &ReadOptions::default()).unwrap_err().to_string();
    assert!(error.contains("the format is not known; say it: obj, off"), "{error}");
    std::fs::write(&unknown, "v 0 0\n").unwrap();
    assert!(read_path(&unknown, &ReadOptions::default()).is_ok(), "the contents say that it is OBJ");
    let dump = folder.path().join("dump.txt");
    std::fs::write(&dump, "dcel 1\nv0 0 0\n").unwrap();
    assert!(read_path(&dump, &ReadOptions::default()).is_ok(), "a name for written tables does not hide the text");
    let said = ReadOptions { format: Some(Format::Off), ..ReadOptions::default() };
    assert!(read_path(&unknown, &said).is_err(), "the option wins over the contents");
}

#[test]
fn a_small_topology_cannot_ask_for_any_amount_of_memory() {
    let reuse = vec!["0,-1"; 100_000].join(",");
    let text = format!(
        r#"{{"type":"Topology","arcs":[[[0,0],[1,0],[0,1]]],"objects":{{"a":{{"type":"Polygon","arcs":[[{reuse}]]}}}}}}"#
    );
    let error = read(text.as_bytes(), Format::TopoJson).unwrap_err();
    assert!(matches!(*error.what, ReadProblem::TooLarge { .. }), "{error}");
}

/// One good file of each format.
fn good_files() -> Vec<(Format, Vec<u8>)> {
    let (grid, island) = (grid(2, false), island());
    let written = |table, format| {
        let mut bytes = Vec::new();
        write(&mut bytes, &Model::table(table), format).unwrap();
        (format, bytes)
    };
    vec![
        written(&grid, Format::Obj),
        written(&grid, Format::Off),
        written(&grid, Format::Ply),
        written(&grid, Format::PlyBinary),
        written(&island, Format::GeoJson),
        written(&island, Format::Dcel),
        (Format::Mesh, b"mesh\n2\n4 2\n0 0 2 0 -1\n1 0 3 0 1 -1\n1 1 2 1 -1\n0 1 3 -1 1 0\n3 0 1 3 -1 -1 1\n3 1 2 3 0 -1 -1\n".to_vec()),
        (Format::Mesh, b"mesh\n3\n5 4\n0 0\n0 9\n9 9\n9 0\n5 5\n0 3 4 1 5 -4 0 -2\n1 3 1 2 5 -1 0 3\n1 3 2 3 5 2 0 4\n1 3 3 4 5 3 0 -1\n".to_vec()),
        (Format::Map, b"type octile\nheight 3\nwidth 5\nmap\n..@GS\n.@.OT\n....W\n".to_vec()),
        (Format::TopoJson, br#"{"type":"Topology","transform":{"scale":[2,2],"translate":[0,1]},"objects":{"a":{"type":"GeometryCollection",
            "geometries":[{"type":"Polygon","arcs":[[0,1]]},{"type":"MultiPolygon","arcs":[[[-2,2]]],"id":3}]}},
            "arcs":[[[0,0],[4,0],[0,4]],[[4,4],[-4,-4]],[[4,4],[-4,0],[0,-4]]]}"#.to_vec()),
        (Format::GeoJson, br#"{"type":"GeometryCollection","geometries":[{"type":"LineString","coordinates":[[0,0],[1,0,7],[1,1]]},
            {"type":"MultiLineString","coordinates":[[[5,5],[6,6]],[]]},{"type":"MultiPoint","coordinates":[[2,2]]}]}"#.to_vec()),
        (Format::Wkt, b"# c\nPOINT(1 2);7 LINESTRING Z (0 0 1, 4 0 2)\nSRID=1;MULTIPOLYGON(((0 0,1 0,0 1,0 0)),EMPTY)\n\
            GeometryCollection(MULTIPOINT((3 3),4 4), LINESTRING EMPTY)".to_vec()),
        (Format::Poly, b"3 2 1 1\n1 0 0 5 1\n2 4 0 5 1\n3 0 4 5 1\n3 1\n1 1 2 7\n2 2 3 7\n3 3 1 7\n1\n1 1 1\n1\n1 1 1 7 -1\n".to_vec()),
        (Format::Segments, b"2\n0 0 4 0\n# c\n4 0 0 3\n1 1\n".to_vec()),
    ]
}

/// What every successful reading promises, whatever the file was.
fn check_promises(document: &Document, context: &dyn Fn() -> String) {
    if let Document::Segments(soup) = document {
        let points = soup.points.len();
        assert!(
            soup.segments.as_flattened().iter().all(|&v| (v as usize) < points),
            "an end without point: {}",
            context()
        );
        assert!(
            soup.points.iter().chain(&soup.hole_points).all(|p| p.check().is_ok()),
            "a bad coordinate: {}",
            context()
        );
        let lines = [soup.point_lines.len(), soup.segment_lines.len(), soup.hole_lines.len()];
        assert_eq!(lines, [points, soup.segments.len(), soup.hole_points.len()], "{}", context());
    }
    if let Document::Polygons(soup) = document {
        let points = soup.points.len();
        assert!(soup.faces.corners().iter().all(|&v| (v as usize) < points), "a corner without point: {}", context());
        let fine = |x: &f64| dcel_kit::plane::check_coordinate('x', *x).is_ok();
        assert!(soup.points.as_flattened().iter().all(fine), "a bad coordinate: {}", context());
        assert!(soup.faces.outer_cycles().all(|cycle| !cycle.is_empty()), "an empty face: {}", context());
    }
}

#[test]
fn binary_data_cut_at_every_byte_name_the_byte() {
    for encoding in ["binary_little_endian", "binary_big_endian"] {
        let mut file = format!(
            "ply\nformat {encoding} 1.0\nelement vertex 2\nproperty double x\nproperty float y\nproperty list uchar short q\n\
             element other 1\nproperty list int double d\nelement face 2\nproperty list ushort uint vertex_indices\nend_header\n"
        )
        .into_bytes();
        let header = file.len();
        let little = encoding == "binary_little_endian";
        let mut put = |bytes: &[u8]| {
            let mut bytes = bytes.to_vec();
            if !little {
                bytes.reverse();
            }
            file.extend(bytes);
        };
        for vertex in 0..2u8 {
            put(&f64::from(vertex).to_le_bytes());
            put(&1.5f32.to_le_bytes());
            put(&[2]);
            put(&7i16.to_le_bytes());
            put(&7i16.to_le_bytes());
        }
        put(&1i32.to_le_bytes());
        put(&0f64.to_le_bytes());
        for _ in 0..2 {
            put(&2u16.to_le_bytes());
            put(&1u32.to_le_bytes());
            put(&0u32.to_le_bytes());
        }
        let whole = crate::support::soup(&file, Format::Ply);
        assert_eq!((whole.points, whole.faces.corners()), (vec![[0.0, 1.5, 0.0], [1.0, 1.5, 0.0]], &[1, 0, 1, 0][..]));
        for cut in 0..file.len() {
            let error = read(&file[..cut], Format::Ply).expect_err("a cut file was read");
            if cut + 1 >= header {
                assert_eq!(error.offset, Some(cut as u64), "{error}");
                assert!(matches!(*error.what, ReadProblem::Truncated { .. }), "{error}");
            } else {
                assert!(error.line.is_some() || cut == 0, "{error}");
            }
        }
        file[header + 5] ^= 0xff;
        file[header..header + 8].copy_from_slice(&f64::NAN.to_le_bytes());
        if little {
            let error = read(&file, Format::Ply).unwrap_err().to_string();
            assert_eq!(error, format!("file: byte {header}: x is NaN: coordinates must be finite numbers"));
        }
        let corner = file.len() - 4;
        file[header..header + 8].fill(0);
        file[corner..].copy_from_slice(&[9; 4]);
        let error = read(&file, Format::Ply).unwrap_err().to_string();
        assert_eq!(error, format!("file: byte {corner}: vertex 151587081 does not exist: there are 2"));
    }
}

/// Bytes that mean something to some format.
const LETTERS: &[u8] = b"0123456789-+.eE#\\\"\n\r\t []{},/\xff\0";

#[test]
fn files_cut_or_damaged_anywhere_never_panic_or_hang() {
    let start = ThreadTime::now();
    let options = ReadOptions { drop_degenerate_rings: true, y_down: true, ..ReadOptions::default() };
    for (format, good) in good_files() {
        assert!(read(&good, format).is_ok(), "{format}");
        for cut in 0..good.len() {
            if let Ok(read) = read(&good[..cut], format) {
                check_promises(&read.document, &|| format!("{format} cut at {cut}"));
            }
        }
        for seed in 0..3000 {
            let mut random = Random::new(seed);
            let mut bytes = good.clone();
            for _ in 0..=random.below(4) {
                let at = random.below(bytes.len());
                match random.below(4) {
                    0 => bytes[at] ^= 1 << random.below(8),
                    1 => bytes[at] = LETTERS[random.below(LETTERS.len())],
                    2 => drop(bytes.remove(at)),
                    _ => bytes.insert(at, bytes[random.below(bytes.len())]),
                }
            }
            // The same bytes are given to the right reader and to a wrong one.
            let other = Format::ALL[random.below(Format::ALL.len())];
            for format in [format, other] {
                if let Ok(read) = read_bytes(&bytes, format, "file", &options) {
                    check_promises(&read.document, &|| format!("{format} seed {seed}"));
                }
            }
        }
    }
    assert!(start.elapsed() < Duration::from_secs(60), "{:?}", start.elapsed());
}

/// A header that counts wrongly, with lines that leave no doubt.
#[test]
fn wrong_counts_of_an_off_header_are_told_with_a_note() {
    let points = "0 0 0\n4 0 0\n4 3 0\n0 3 0\n";
    let faces = "3 0 1 2\n3 0 2 3\n";
    let right = read(format!("OFF\n4 2 0\n{points}{faces}").as_bytes(), Format::Off).expect("a square");
    assert_eq!(right.notes, [""; 0]);
    for counts in ["3 2 0", "5 2 0", "4 1 0", "4 3", "4 0 9", "0 2 0", "0 0 0"] {
        let found = read(format!("OFF\n{counts}\n{points}\n# faces\n{faces}").as_bytes(), Format::Off);
        let found = found.unwrap_or_else(|error| panic!("{counts}: {error}"));
        let [header_points, header_faces] = [0, 1].map(|i| counts.split(' ').nth(i).unwrap());
        let note = &found.notes[0];
        assert!(note.starts_with(&format!("the header counts {header_points} point")), "{note}");
        assert!(
            note.contains(&format!("{header_faces} face")) && note.contains("the file has 4 points and 2 faces"),
            "{note}"
        );
        let [Document::Polygons(a), Document::Polygons(b)] = [&right.document, &found.document] else {
            panic!("polygons")
        };
        assert_eq!((&a.points, &a.faces), (&b.points, &b.faces), "{counts}");
    }
    // Both numbers wrong, a corner that is nowhere, a line that is cut: no guess.
    for text in [
        format!("OFF\n3 1 0\n{points}{faces}"),
        format!("OFF\n3 2 0\n{points}3 0 1 2\n3 0 2 4\n"),
        format!("OFF\n4 3 0\n{points}{faces}3 0 1"),
        format!("OFF\n4 2 0\n{points}3 0 1 2\n3 0 2"),
    ] {
        assert!(read(text.as_bytes(), Format::Off).is_err(), "{text}");
    }
}

/// A file of lines that was cut off looks whole but for the end of its last line.
#[test]
fn a_last_line_without_its_end_is_told() {
    let whole: [(Format, &str); 6] = [
        (Format::Obj, "v 0 0\nv 4 0\nv 0 3\nf 1 2 3\n"),
        (Format::Off, "OFF\n3 1 0\n0 0 0\n4 0 0\n0 3 0\n3 0 1 2\n"),
        (
            Format::Ply,
            "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nend_header\n0 15\n",
        ),
        (Format::Segments, "0 0 4 0\n4 0 4 31\n"),
        (Format::Poly, "2 2 0 0\n1 0 0\n2 4 0\n1 0\n1 1 2\n0\n"),
        (Format::Dcel, "dcel 1\nv0 0 10 out none\nf0 outer half_edge none inner v0\n"),
    ];
    for (format, text) in whole {
        let notes =
            |text: &str| read(text.as_bytes(), format).unwrap_or_else(|error| panic!("{format}: {error}")).notes;
        let cut = text.trim_end();
        let line = cut.lines().count();
        assert_eq!(notes(text), [""; 0], "{format}");
        assert_eq!(notes(&text.replace('\n', "\r\n")), [""; 0], "{format}");
        assert_eq!(
            notes(cut),
            [format!("line {line}, the last one, has no end: was the file cut off there?")],
            "{format}"
        );
        // What says nothing may end anywhere.
        assert_eq!(notes(&format!("{text}   ")), [""; 0], "{format}");
    }
    assert_eq!(read(b"v 0 0\n# done", Format::Obj).expect("a point").notes, [""; 0]);
    let list = dcel_kit::io::points_from_text(b"0 0\n4 15", "sites.xy").expect("points");
    assert_eq!(list.notes, ["line 2, the last one, has no end: was the file cut off there?"]);
}

#[test]
fn a_pile_of_polygons_is_mended_in_time_that_grows_with_their_number() {
    let time = |count: usize| {
        let squares = (1..=count).map(|i| {
            format!(
                r#"{{"type":"Feature","properties":{{"name":"n{i}"}},"geometry":{{"type":"Polygon","coordinates":
                [[[-{i},-{i}],[{i},-{i}],[{i},{i}],[-{i},{i}],[-{i},-{i}]]]}}}}"#
            )
        });
        let text = squares.collect::<Vec<_>>().join(",");
        let text = format!(r#"{{"type":"FeatureCollection","features":[{text}]}}"#);
        let read = read_bytes(text.as_bytes(), Format::GeoJson, "pile", &ReadOptions::default()).unwrap();
        let options = LoadOptions { mend: true, ..LoadOptions::default() };
        let start = ThreadTime::now();
        let loaded = assemble(read, "pile", &options).unwrap();
        let covering = loaded.covering.unwrap();
        assert_eq!((covering.cover.uncovered().count(), covering.faces_named(|name| name == "n9").len()), (1, 9));
        start.elapsed().as_secs_f64()
    };
    // Every square covers all that lie in it: the middle is covered by all of them. Squares would give 16.
    let ratio = time(12_000) / time(3_000);
    assert!(ratio < 8.0, "{ratio}");
}
