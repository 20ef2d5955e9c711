//! Polygons that do not fit together: refused with names and places, mended on request, never silently.

use crate::shell::Folder;
use serde_json::{Value, json};

/// Two bars that cross: A lies, B stands.
const PLUS: &str = r#"{"type":"FeatureCollection","features":[
{"type":"Feature","properties":{"name":"A"},"geometry":{"type":"Polygon","coordinates":[[[0,2],[6,2],[6,4],[0,4],[0,2]]]}},
{"type":"Feature","properties":{"name":"B"},"geometry":{"type":"Polygon","coordinates":[[[2,0],[4,0],[4,6],[2,6],[2,0]]]}}]}
"#;

/// A hole that crosses its shell.
const INV: &str = r#"{"type": "Polygon", "coordinates": [[[10, 90], [60, 90], [60, 10], [10, 10], [10, 90]],
 [[30, 70], [90, 70], [90, 30], [30, 30], [30, 70]]]}"#;

/// A square of area 100, far from that.
const FAR: &str = r#"{"type": "Polygon", "coordinates": [[[200, 0], [210, 0], [210, 10], [200, 10], [200, 0]]]}"#;

/// The tip of a triangle on the side of a bar, and a square by itself.
const T2: &str = r#"{"type": "FeatureCollection", "features": [
{"type": "Feature", "properties": {}, "geometry": {"type": "Polygon", "coordinates": [[[100, 200], [300, 200], [300, 220], [100, 220], [100, 200]]]}},
{"type": "Feature", "properties": {}, "geometry": {"type": "Polygon", "coordinates": [[[280, 160], [300, 160], [300, 180], [280, 180], [280, 160]]]}},
{"type": "Feature", "properties": {}, "geometry": {"type": "Polygon", "coordinates": [[[180, 220], [200, 240], [160, 240], [180, 220]]]}}]}"#;

/// A hole that touches a side of its shell from inside.
const M1: &str =
    r#"{"type": "Polygon", "coordinates": [[[0, 0], [8, 0], [4, 4], [0, 0]], [[4, 0], [5, 1], [4, 2], [4, 0]]]}"#;

/// The same with a line beside it whose member is misspelt.
const HOLE_TOUCHES_SIDE: &str = r#"{"type":"FeatureCollection","features":[
{"type":"Feature","properties":{"name":"A"},"geometry":{"type":"MultiPolygon","coordinates":[[[[0,0],[4,0],[4,4],[0,4],[0,0]],[[1,1],[1,4],[2,2],[1,1]]]]}},
{"type":"Feature","geometry":{"type":"LineString","coortinates":[[0,0],[1e5,1]]}}]}"#;

/// A hole that touches a slanted side.
const POL: &str = r#"{"type":"Polygon","coordinates":[[[5,5],[9,5],[9,0],[0,0],[5,5]],[[3,3],[6,1],[5,3],[3,3]]]}"#;

fn folder() -> Folder {
    let folder = Folder::new();
    let files = [
        ("plus.json", PLUS),
        ("inv.json", INV),
        ("far.json", FAR),
        ("t2.json", T2),
        ("m1.json", M1),
        ("hole_touches_side.json", HOLE_TOUCHES_SIDE),
        ("pol.geojson", POL),
    ];
    files.into_iter().for_each(|(name, text)| folder.write(name, text));
    folder
}

/// The area that an overlay prints.
fn area(answer: &Value) -> f64 {
    answer["region"]["area"].as_f64().unwrap_or_else(|| panic!("{answer}"))
}

#[test]
fn plus_is_not_valid_for_any_command() {
    let folder = folder();
    let calls = [
        "info plus.json",
        "info plus.json --json",
        "figure plus.json -o plus.svg",
        "convert plus.json plus.dcel",
        "locate plus.json 3 3",
        "triangulate plus.json",
        "overlay plus.json far.json --operation union",
        "overlay far.json plus.json",
        "walk plus.json --face f1",
        "delaunay plus.json --constrained",
        "navmesh path plus.json 1 3 5 3",
    ];
    for call in calls {
        let told = folder.dcel(call);
        let what = "plus.json:2:89: G3: features[0] \"A\" polygon 0 ring 0 and features[1] \"B\" polygon 0 ring 0 \
                    cross at (2, 2): the side (0, 2) -> (6, 2) and the side (2, 6) -> (2, 0)";
        told.fails(2, what, "note: counted from 0; features[1] \"B\" polygon 0 ring 0: line 3:89");
        assert!(told.err.contains("help: ") && told.err.contains("--mend"), "{call}: {told:?}");
    }
    assert!(!folder.path("plus.dcel").exists() && !folder.path("plus.svg").exists());
    let told = folder.dcel("validate plus.json");
    assert!(told.code == Some(1) && told.out.starts_with("G3: plus.json:2:89: features[0] \"A\""), "{told:?}");
    let told = folder.dcel("validate plus.json --json");
    let report: Value = serde_json::from_str(&told.out).expect("JSON");
    assert_eq!((&report["valid"], &report["violations"][0]["rule"]), (&json!(false), &json!("G3")));
}

#[test]
fn trust_is_told() {
    let folder = folder();
    let text = folder.dcel("info plus.json --trust").fine();
    assert!(text.starts_with("plus.json: plane, geojson, not checked\n"), "{text}");
    assert_eq!(folder.dcel("info plus.json --trust --json").json()["valid"], Value::Null);
    assert_eq!(folder.dcel("info garden.json --json").json()["valid"], json!(true));
    folder.dcel("info plus.json --trust --mend").fails(2, "cannot be used with", "");
    folder.dcel("validate plus.json --trust").fails(2, "--trust leaves out the check", "leave --trust out");
    // What shares a corner is looked at all the same.
    let twice = r#"{"type":"MultiPolygon","coordinates":[[[[0,0],[4,0],[0,4],[0,0]]],[[[0,0],[3,1],[1,3],[0,0]]]]}"#;
    folder.write("corner.json", twice);
    folder.dcel("info corner.json --trust").fails(2, "overlap at their common corner (0, 0)", "--mend");
}

#[test]
fn plus_is_mended_with_a_report() {
    let folder = folder();
    let told = folder.dcel("info plus.json --mend --json");
    for words in [
        "4 vertices were made where sides cross: features[0] \"A\" polygon 0 and features[1] \"B\" polygon 0 cross at \
         (2, 2);",
        "1 face is covered more than once, area 4 in all: features[0] \"A\" polygon 0 and features[1] \"B\" polygon 0 \
         overlap in area 4",
    ] {
        assert!(told.err.contains(words), "{words}: {told:?}");
    }
    let info = told.json();
    let mended = json!({"polygons": 2, "covered_once": 4, "covered_several_times": 1, "overlapping_area": 4.0});
    assert_eq!((&info["valid"], &info["faces"], &info["mended"]), (&json!(true), &json!(6), &mended));
    let text = folder.dcel("info plus.json --split-crossings").fine();
    assert!(
        text.contains("  mended            2 polygons; 4 faces covered once\n  overlaps          1 face, area 4\n"),
        "{text}"
    );

    let found = folder.dcel("locate plus.json 3 3 1 3 3 1 1 1 --mend --json").json();
    let names: Vec<&Value> = (0..4).map(|i| &found["points"][i]["name"]).collect();
    assert_eq!(names, [&json!("A & B"), &json!("A"), &json!("B"), &Value::Null]);
    assert_eq!(found["points"][0]["polygons"], json!(["A", "B"]));
    // All faces of A, the common one among them.
    let walk = folder.dcel("walk plus.json --face-name a --mend --json").json();
    let faces: Vec<&Value> = walk["faces"].as_array().expect("faces").iter().map(|face| &face["name"]).collect();
    assert_eq!(faces.iter().filter(|name| **name == &json!("A")).count(), 2);
    assert!(faces.len() == 3 && faces.contains(&&json!("A & B")), "{walk}");
    folder.dcel("walk plus.json --face-name C --mend").fails(2, "no face is named `C`", "");

    let union = folder.dcel("overlay plus.json far.json --operation union --mend --json");
    assert!(union.err.starts_with("note: plus.json: mended: 2 polygons became 5 faces\n"), "{union:?}");
    assert!(union.err.contains("note: far.json: nothing to mend\n"), "the second file is sound: {union:?}");
    assert!((area(&union.json()) - 120.0).abs() < 1e-12);
    folder.dcel("convert plus.json plus.dcel --mend").fine();
    assert_eq!(folder.dcel("validate plus.dcel").fine(), "plus.dcel: valid\n");
    let svg = folder.dcel("figure plus.json --mend").fine();
    assert!(svg.contains("A &amp; B"), "the common face has both names");
    let cut = folder.dcel("triangulate plus.json --mend --json").json();
    assert_eq!(cut["pieces"], json!(10));
    let path = folder.dcel("navmesh path plus.json 1 3 5 3 --mend --json").json();
    assert_eq!(path["routes"][0]["length"], json!(4.0));
}

#[test]
fn inv_is_refused_by_ring_and_mended_to_shell_without_hole() {
    let folder = folder();
    let told = folder.dcel("overlay inv.json far.json --operation union");
    told.fails(2, "inv.json:1:37: G3: rings 0 and 1 of geometry polygon 0 cross at (60, 30)", "line 2:2");
    let union = folder.dcel("overlay inv.json far.json --operation union --mend --json");
    assert!(union.err.contains("geometry polygon 0 crosses itself at (60, 30)"), "{union:?}");
    assert!(union.err.contains("4 pieces of sides were left out"), "{union:?}");
    assert!((area(&union.json()) - 2900.0).abs() < 1e-9);
    let found = folder.dcel("locate inv.json 45 50 70 50 20 50 --mend --json").json();
    let kinds: Vec<&Value> = (0..3).map(|i| &found["points"][i]["kind"]).collect();
    assert_eq!(kinds, [&json!("outer"), &json!("outer"), &json!("face")]);
}

#[test]
fn outer_rings_that_enclose_nothing_are_told_with_their_other_rings() {
    let folder = folder();
    let polygon = |outer: &str| format!(r#"{{"type":"Polygon","coordinates":[{outer},[[0,0],[4,0],[4,3],[0,0]]]}}"#);
    folder.write("flat.json", &polygon("[[0,0],[8,0],[4,0],[0,0]]"));
    let told = folder.dcel("info flat.json --mend --json");
    let note = "1 polygon has an outer ring that encloses nothing, so that the other rings were taken as outlines: \
                geometry polygon 0";
    assert!(told.err.contains(note), "{told:?}");
    assert_eq!(told.json()["mended"]["covered_once"], json!(1));
    // Left out without --mend, it takes its polygon with it: not without a word.
    folder.write("dot.json", &polygon("[[0,0],[0,0],[0,0],[0,0]]"));
    let told = folder.dcel("info dot.json --drop-degenerate-rings");
    let note = "geometry polygon 0 ring 0 has only 1 distinct point; its polygon went with it, with 1 more ring";
    assert!(told.err.contains(note), "{told:?}");
}

#[test]
fn corners_inside_sides_are_inserted_and_told() {
    let folder = folder();
    let cases = [
        ("t2.json", "(180, 220) into features[0] polygon 0 ring 0", [11, 12, 4]),
        ("m1.json", "(4, 0) into geometry polygon 0 ring 0", [6, 7, 3]),
        ("hole_touches_side.json", "(1, 4) into features[0] \"A\" polygon 0 ring 0", [7, 8, 3]),
        ("pol.geojson", "(3, 3) into geometry polygon 0 ring 0", [7, 8, 3]),
    ];
    for (file, words, [v, e, f]) in cases {
        let told = folder.dcel(&format!("info {file} --json"));
        let note = format!("1 corner was inserted where vertices lie inside sides, the first at {words}");
        assert!(told.err.contains(&note), "{told:?}");
        let info = told.json();
        assert_eq!([&info["vertices"], &info["edges"], &info["faces"]], [&json!(v), &json!(e), &json!(f)], "{file}");
        assert_eq!(folder.dcel(&format!("validate {file}")).fine(), format!("{file}: valid\n"));
        folder.dcel(&format!("triangulate {file} -o cut.dcel")).fine();
        assert_eq!(folder.dcel("validate cut.dcel").fine(), "cut.dcel: valid\n", "{file}");
        folder.dcel(&format!("convert {file} whole.dcel")).fine();
        assert_eq!(folder.dcel("validate whole.dcel").fine(), "whole.dcel: valid\n", "{file}");
    }
    // Meshes name their corners: a vertex inside a side is a fault, which --mend mends.
    folder.write("mesh.obj", "v 0 0\nv 4 0\nv 4 4\nv 0 4\nv 4 2\nv 8 2\nf 1 2 3 4\nf 5 2 6\n");
    folder.dcel("info mesh.obj").fails(
        2,
        "mesh.obj:7: G3: face 0 and face 1 run along each other from (4, 0) to (4, 2): the side (4, 0) -> (4, 4)",
        "--mend",
    );
    let told = folder.dcel("info mesh.obj --mend --json");
    assert!(told.err.contains("inserted where vertices lie inside sides, the first at (4, 2) into face 0"), "{told:?}");
    assert_eq!(told.json()["faces"], json!(3));
}

#[test]
fn each_kind_of_misfit_is_named_with_its_rings() {
    let folder = folder();
    let square = |x: f64, y: f64, side: f64| {
        let (a, b) = (x + side, y + side);
        format!("[[{x},{y}],[{a},{y}],[{a},{b}],[{x},{b}],[{x},{y}]]")
    };
    let cases = [
        (
            format!("[{}],[{}]", square(0., 0., 4.), square(1., 1., 2.)),
            "geometry polygon 1 ring 0 lies inside geometry \
          polygon 0, which has no hole there: they overlap, for example at (1, 1)",
        ),
        (
            format!("[{},{}]", square(0., 0., 4.), square(9., 1., 2.)),
            "geometry polygon 0 ring 1 is to be a hole, but does not lie inside ring 0 and outside of the other rings: its leftmost corner is (9, 1)",
        ),
        (
            "[[[0,0],[4,4],[4,0],[0,4],[0,0]]]".to_owned(),
            "geometry polygon 0 ring 0 crosses itself at (2, 2): the side",
        ),
        (
            "[[[0,0],[4,0],[4,4],[2,0],[0,4],[0,0]]]".to_owned(),
            "geometry polygon 0 ring 0 touches itself at (2, 0): inside the side (0, 0) -> (4, 0)",
        ),
        (
            "[[[0,0],[2,2],[5,5],[0,0]]]".to_owned(),
            "geometry polygon 0 ring 0 has no area: its corners lie on one line, from (0, 0) to (5, 5)",
        ),
        (
            format!("[{},[[0,0],[2,1],[4,4],[1,2],[0,0]]]", square(0., 0., 4.)),
            "the inside of geometry polygon 0 is cut into pieces by its holes",
        ),
        (format!("[{}],[{}]", square(0., 0., 4.), square(0., 0., 4.)), "geometry polygon 1 repeats geometry polygon 0"),
        (
            format!("[{0}],[[[0,0],[4,0],[4,9],[0,0]]]", square(0., 0., 4.)),
            "overlap: both lie on the same side of the edge (0, 0) -> (4, 0)",
        ),
        ("[[[0,0],[4,0],[0,4],[0,0]]],[[[0,0],[2,1],[1,2],[0,0]]]".to_owned(), "overlap at their common corner (0, 0)"),
        (
            "[[[0,0],[2,0],[1,1],[3,3],[1,1],[0,0]]]".to_owned(),
            "geometry polygon 0 ring 0 touches itself: it passes (1, 1) twice",
        ),
    ];
    for (polygons, words) in cases {
        folder.write("bad.json", &format!("{{\"type\": \"MultiPolygon\",\n \"coordinates\": [{polygons}]}}"));
        let told = folder.dcel("info bad.json");
        told.fails(2, words, "--mend");
        assert!(told.err.contains("error: bad.json:2:"), "the line and column of the ring: {told:?}");
        let mended = folder.dcel("convert bad.json good.dcel --mend");
        assert!(mended.code == Some(0) && mended.err.contains("note: "), "{polygons}: {mended:?}");
        assert_eq!(folder.dcel("validate good.dcel").fine(), "good.dcel: valid\n", "{polygons}");
        assert!(!folder.dcel("info bad.json --mend").err.contains("nothing to mend"), "{polygons}");
    }
    // Coordinates in messages are those of the file, whichever way y points.
    folder.write("bad.json", "{\"type\": \"Polygon\", \"coordinates\": [[[0,0],[4,4],[4,0],[0,4],[0,0]]]}");
    folder.dcel("info bad.json --y-down").fails(2, "crosses itself at (2, 2): the side (0, 0) -> (4, 4)", "--mend");
}

#[test]
fn flags_that_cannot_apply_are_errors() {
    let folder = folder();
    folder.write("cross.segments", "0 0 4 4\n0 4 4 0\n");
    let cases = [
        ("info triangle.dcel --mend", "--mend cannot be used on dcel", "dcel validate"),
        ("info cube.off --mend", "--mend cannot be used on off", "--plane"),
        ("info triangle.dcel --trust", "--trust cannot be used on dcel", ""),
        ("info cube.off --trust", "--trust cannot be used on off", ""),
        ("info triangle.dcel --orient", "--orient cannot be used on dcel", ""),
        ("info triangle.dcel --surface", "--surface cannot be used on dcel", ""),
        ("info cross.segments --mend --plane", "--plane cannot be used on segments", ""),
        ("info square.obj --object states", "--object cannot be used on obj", "TopoJSON"),
        ("info square.obj --drop-degenerate-rings", "--drop-degenerate-rings cannot be used on obj", ""),
        ("solid info cube.off --mend", "--mend cannot be used on off", ""),
        ("voronoi garden.json --mend", "--mend cannot be used here", "only the points"),
        ("delaunay garden.json --trust", "--trust cannot be used here", "only the points"),
        ("build cross.segments --mend --object x", "--object cannot be used on segments", "TopoJSON"),
        ("navmesh info triangle.dcel --mend", "--mend cannot be used on dcel", ""),
    ];
    for (call, words, help) in cases {
        folder.dcel(call).fails(2, words, help);
    }
    folder.dcel("solid info cube.off").fine();
}

#[test]
fn sound_input_has_nothing_to_mend() {
    let folder = folder();
    // What was told of the text is told of what cannot be used, too: it may be the reason.
    folder.write("cut.obj", "v 0 0\nv 1 0\nv 0 1\nf 1 2 3\nf 2 3");
    let told = folder.dcel("info cut.obj");
    assert!(told.code == Some(2) && told.err.contains("note: line 5, the last one, has no end: was the file cut off"));
    folder.write("path.segments", "0 0 4 0\n4 0 4 4\n");
    let calls = [
        "info garden.json --mend",
        "info square.obj --mend",
        "convert garden.json g.dcel --mend",
        "info path.segments --mend",
        "build path.segments --mend",
        "build garden.json --mend",
        "navmesh info square.obj --mend",
    ];
    for call in calls {
        let told = folder.dcel(call);
        assert!(told.code == Some(0) && told.err.contains("note: nothing to mend\n"), "{call}: {told:?}");
    }
    // Segments that overlap are split, though no crossing is made.
    folder.write("over.segments", "0 0 2 0\n1 0 2 0\n");
    for call in ["info over.segments --mend", "build over.segments --mend"] {
        let told = folder.dcel(call);
        assert!(told.err.contains("1 segment was split where it meets others"), "{call}: {told:?}");
        assert!(!told.err.contains("nothing to mend"), "{call}: {told:?}");
    }
    // A ring that was closed is something.
    folder.write("open.json", "{\"type\":\"Polygon\",\"coordinates\":[[[0,0],[4,0],[4,4],[0,4]]]}");
    folder.dcel("build open.json").fails(2, "the ring starts at (0, 0) and ends at (0, 4)", "--mend");
    for call in ["info open.json --mend", "build open.json --mend"] {
        let told = folder.dcel(call);
        assert!(told.code == Some(0) && told.err.contains("note: 1 ring that did not end where it starts was closed"));
        assert!(!told.err.contains("nothing to mend") && told.out.contains("faces"), "{call}: {told:?}");
        assert!(told.out.contains("2 (with the outer face)"), "{call}: {told:?}");
    }
    // And nothing is changed: numbers and names stay.
    assert_eq!(folder.dcel("convert garden.json - --to dcel").fine(), folder.read("g.dcel"));
}

/// A square with two neighbours in one arc each, a line, and points; quantised.
const TOPOLOGY: &str = r#"{"type":"Topology","transform":{"scale":[0.5,0.5],"translate":[10,0]},"objects":{
 "rooms":{"type":"GeometryCollection","geometries":[
  {"type":"Polygon","arcs":[[0,1]],"properties":{"name":"Left"}},
  {"type":"Polygon","arcs":[[-1,2]],"properties":{"name":"Right"}}]},
 "wires":{"type":"GeometryCollection","geometries":[
  {"type":"LineString","arcs":[0]},
  {"type":"MultiLineString","arcs":[[3],[0]]},
  {"type":"Point","coordinates":[1,1]},{"type":"MultiPoint","coordinates":[[8,8]]}]}},
"arcs":[[[4,0],[0,4]],[[4,4],[-4,0],[0,-4],[4,0]],[[4,0],[4,0],[0,4],[-4,0]],[[0,2],[8,0]]]}"#;

#[test]
fn build_and_convert_read_topojson() {
    let folder = folder();
    folder.write("map.topojson", TOPOLOGY);
    let report = folder.dcel("build map.topojson --object rooms --json").json();
    let counts = ["segments", "vertices", "edges", "faces"].map(|key| report[key].as_i64().expect("a number"));
    assert_eq!(counts, [8, 6, 7, 3], "the common arc comes twice");
    let wires = folder.dcel("build map.topojson --object wires --mend -o wires.dcel");
    assert!(wires.code == Some(0) && wires.err.contains("1 vertex was made where segments cross"), "{wires:?}");
    let info = folder.dcel("info wires.dcel --json").json();
    assert_eq!([&info["vertices"], &info["edges"], &info["isolated_vertices"]], [&json!(7), &json!(4), &json!(2)]);
    assert_eq!(info["bounding_box"], json!({"min": [10.0, 0.0], "max": [14.0, 4.0]}));
    // Lines alone are segments for all commands; the faults have their lines.
    let told = folder.dcel("info map.topojson --object wires");
    told.fails(2, "map.topojson:6: segments", "--mend");
    assert_eq!(folder.dcel("info map.topojson --object wires --mend --json").json()["edges"], json!(4));
    assert_eq!(folder.dcel("convert map.topojson map.dcel --object rooms").code, Some(0));
    assert_eq!(folder.dcel("walk map.dcel --face-name Left --json").json()["adjacent_names"], json!(["Right"]));
    // An arc that runs across the common one makes the rooms overlap.
    folder.write("wide.topojson", &TOPOLOGY.replace("[[4,0],[4,0],[0,4],[-4,0]]", "[[4,0],[-2,2],[6,2],[-4,0]]"));
    let told = folder.dcel("info wide.topojson --object rooms");
    told.fails(
        2,
        "wide.topojson:4:29: rooms[1] \"Right\" polygon 0 ring 0 crosses itself at (12, 1.3333333333333333)",
        "--mend",
    );
    assert_eq!(folder.dcel("convert wide.topojson wide.dcel --object rooms --mend").code, Some(0));
    assert_eq!(folder.dcel("validate wide.dcel").fine(), "wide.dcel: valid\n");
}

#[test]
fn files_as_they_come_are_read_or_refused_by_place() {
    let folder = folder();
    let feature =
        |geometry: &str| format!("{{\"type\":\"Feature\",\"properties\":{{\"name\":\"X\"}},\"geometry\":{geometry}}}");
    let polygon = |rings: &str| format!("{{\"type\":\"Polygon\",\"coordinates\":[{rings}]}}");
    let collection = |features: &[String]| {
        format!("\u{feff}{{\"type\":\"FeatureCollection\",\r\n\"features\":[\r\n{}]}}\r\n", features.join(",\r\n"))
    };
    // A byte order mark, Windows line ends, heights, repeated points, a clockwise ring, a geometry that is null, a
    // collection, and a second part that shares a border.
    let good = collection(&[
        feature("null"),
        feature(&polygon("[[0,0,7],[0,4,7],[0,4,7],[4,4,7],[4,0,7],[0,0,7]]")),
        feature(&format!(
            "{{\"type\":\"GeometryCollection\",\"geometries\":[{}]}}",
            polygon("[[4,0],[8,0],[8,4],[4,4],[4,0]]")
        )),
    ]);
    folder.write("good.json", &good);
    let told = folder.dcel("info good.json --json");
    assert!(told.err.contains("note: 1 point that repeats the one before was removed"), "{told:?}");
    assert!(told.err.contains("note: the third coordinate of 6 points was dropped"), "{told:?}");
    let info = told.json();
    assert_eq!([&info["vertices"], &info["edges"], &info["faces"]], [&json!(6), &json!(7), &json!(3)]);
    // The third feature crosses the second; both places are told in lines and columns as an editor counts them.
    folder.write("bad.json", &good.replace("[4,0],[8,0],[8,4],[4,4],[4,0]", "[3,1],[8,1],[8,3],[3,3],[3,1]"));
    let told = folder.dcel("info bad.json");
    told.fails(
        2,
        "bad.json:4:89: G3: features[1] \"X\" polygon 0 ring 0 and features[2] \"X\" geometries[0] polygon 0",
        "line 5:",
    );
    // A ring that is not closed, and one without area: refused with the way out, which works.
    for (ring, words, note) in [
        (
            "[[0,0],[4,0],[4,4]]",
            "the ring starts at (0, 0) and ends at (4, 4)",
            "1 ring that did not end where it starts was closed",
        ),
        (
            "[[0,0],[4,0],[4,4],[0,0]],[[1,1],[1,1],[1,1]]",
            "the ring has only 1 distinct point",
            "dropped a degenerate ring",
        ),
    ] {
        folder.write("open.json", &collection(&[feature(&polygon(ring))]));
        let told = folder.dcel("info open.json");
        told.fails(2, words, "--mend");
        let told = folder.dcel("info open.json --mend --json");
        assert!(told.err.contains(note), "{told:?}");
        assert_eq!(told.json()["edges"], json!(3), "{ring}");
    }
}
