//! Promise: `dcel build` makes a structure of segments, tells what became of them, and names what it refuses.

use crate::shell::Folder;
use serde_json::json;

const CROSS: &str = "LINESTRING (0 0, 4 4)\nLINESTRING (0 4, 4 0)\nLINESTRING (9 0, 9 4)\nLINESTRING (8 2, 10 2)\n";
const HOUSE: &str = "0 0 4 0\n4 0 4 3\n4 3 0 3\n0 3 0 0\n4 3 6 5\n2 1\n0 0 4 0\n";

#[test]
fn the_report_counts_and_names() {
    let folder = Folder::new();
    folder.write("house.segments", HOUSE);
    let told = folder.dcel("build house.segments");
    assert!(told.err.contains("note: 1 segment repeats an earlier one and was left out"), "{told:?}");
    let text = told.fine();
    for line in ["plane, segments, 6 segments", "V - E + F = 3", "isolated        1: v5", "dangles         1: e4"] {
        assert!(text.contains(line), "{line} in {text}");
    }
    let report = folder.dcel("build house.segments --json").json();
    assert_eq!((&report["vertices"], &report["edges"], &report["faces"]), (&json!(6), &json!(5), &json!(2)));
    assert_eq!(report["repeated"], json!([{"segment": 5, "repeats": 0}]));
    assert_eq!((&report["dangles"], &report["cut_edges"]), (&json!(["e4"]), &json!([])));
    // The commands that read structures open such files, too, and with the same counts.
    let info = folder.dcel("info house.segments --json").json();
    assert_eq!((&info["vertices"], &info["format"], &info["valid"]), (&json!(6), &json!("segments"), &json!(true)));
    folder.dcel("validate house.segments").fine();
    assert!(folder.dcel("figure house.segments").fine().contains("<svg"));
}

#[test]
fn crossings_are_all_named_or_split() {
    let folder = Folder::new();
    folder.write("cross.wkt", CROSS);
    let told = folder.dcel("build cross.wkt");
    told.fails(2, "cross.wkt:1: segments 0 and 1 cross at (2, 2)", "--mend");
    assert!(told.err.contains("note: cross.wkt:3: segments 2 and 3 cross at (9, 2)"), "{told:?}");
    assert!(told.err.contains("segment 1: line 2"), "{told:?}");
    let report = folder.dcel("build cross.wkt --mend --json").json();
    assert_eq!((&report["crossings"], &report["edges"]), (&json!(["v8", "v9"]), &json!(8)));
    folder.dcel("build cross.wkt --split-crossings -o cross.dcel --figure cross.svg").fine();
    let info = folder.dcel("info cross.dcel --json").json();
    assert_eq!((&info["edges"], &info["components"]), (&json!(8), &json!(2)));
    assert!(std::fs::read_to_string(folder.path("cross.svg")).expect("a figure").contains("</svg>"));
    let same = folder.dcel("info cross.wkt --split-crossings --json").json();
    assert_eq!(same["edges"], json!(8));
    let dcel = folder.dcel("build cross.wkt --split-crossings -o -").fine();
    assert_eq!(dcel, std::fs::read_to_string(folder.path("cross.dcel")).expect("a file"));
}

#[test]
fn wrong_inputs_and_targets_are_refused() {
    let folder = Folder::new();
    folder.write("house.segments", HOUSE);
    folder.dcel("build square.obj").fails(2, "square.obj: obj holds no segments", "dcel convert");
    folder.dcel("build house.segments -o house.segments").fails(2, "this is the input itself", "another name");
    folder.dcel("build house.segments -o house").fails(2, "the file name does not say which format", ".dcel");
    folder.dcel("build house.segments -o house.wkt").fails(2, "wkt", "");
    folder.dcel("build house.segments --figure no/where.svg").fails(3, "cannot be written", "directory first");
    folder.dcel("build house.segments --from wkt").fails(2, "house.segments:1:", "");
    let both = "build house.segments --json -o";
    folder.dcel(&format!("{both} -")).fails(
        2,
        "-o - and --json would both be written to standard output",
        "name a file",
    );
    assert_eq!(folder.dcel(&format!("{both} x.dcel")).json(), folder.dcel("build house.segments --json").json());
    assert_eq!(folder.read("x.dcel"), folder.dcel("build house.segments -o -").fine());
    folder.dcel("build missing.wkt").fails(2, "missing.wkt: cannot be read", "check the name");
    // Polygons of GeoJSON count by their outlines.
    let report = folder.dcel("build garden.json --json").json();
    assert_eq!((&report["format"], &report["faces"]), (&json!("geojson"), &json!(4)));
}

const UNSETTLED: &str = "0.018737023238535655 0.5045266461286917 0.15153261659397965 0.152083823546187
0.0 0.4 0.30000000000000004 0.1
0.1 0.30000000000000004 0.0 0.4
";

/// `defects/unsettled.segments`, `defects/touch_not_named.segments`
#[test]
fn close_lines_settle_and_all_touching_pairs_are_named() {
    let folder = Folder::new();
    folder.write("unsettled.segments", UNSETTLED);
    let report = folder.dcel("build unsettled.segments --split-crossings --json").json();
    assert!(report["farthest"].as_f64().unwrap() < 1e-15, "{report}");
    folder.write("touch.segments", "3 3 3 0\n3 2 2 3\n0 0 3 2\n");
    let told = folder.dcel("build touch.segments");
    told.fails(2, "segment 1 ends at (3, 2) in the interior of segment 0", "segment 2 ends at (3, 2)");
}

#[test]
fn a_grid_is_told_with_what_it_moved_and_refused_where_doubles_do_not_reach() {
    let folder = Folder::new();
    folder.write("cross.segments", "0.1 0 4 4\n0 4 4 0.2\n9 9 9.1 9.2\n");
    let report = folder.dcel("build cross.segments --split-crossings --grid 1 --json").json();
    assert_eq!((&report["grid"], &report["collapsed"], &report["vertices"]), (&json!(1.0), &json!([2]), &json!(6)));
    assert_eq!(report["displaced"].as_array().unwrap().len(), 3);
    folder.dcel("build cross.segments --split-crossings --grid 1e-20").fails(2, "the grid", "");
    folder.dcel("build cross.segments --split-crossings --grid 0").fails(2, "the grid 0 cannot be used", "");
    folder.dcel("build cross.segments --grid 1").fails(2, "", "--mend");
}

#[test]
fn rings_are_marked_as_holes() {
    let folder = Folder::empty();
    folder.dcel("sample rings.segments plan.poly").fine();
    let report = folder.dcel("build rings.segments --json").json();
    assert_eq!((&report["faces"], &report["hole_faces"]), (&json!(4), &json!([])));
    // Square, square in it, triangle in that: the middle one is the hole.
    let report = folder.dcel("build rings.segments --nested-holes --json").json();
    assert_eq!((report["faces"].clone(), report["hole_faces"].as_array().map(Vec::len)), (json!(4), Some(1)));
    folder.dcel("build rings.segments --nested-holes -o rings.dcel").fine();
    let report = folder.dcel("locate rings.dcel 1 1 3 3 6 5 --json").json();
    let kinds: Vec<&str> =
        report["points"].as_array().expect("points").iter().filter_map(|p| p["kind"].as_str()).collect();
    assert_eq!(kinds, ["face", "hole", "face"]);
    // The same by points.
    folder.dcel("build rings.segments --hole 3,3 -o by-point.dcel").fine();
    assert_eq!(folder.read("by-point.dcel"), folder.read("rings.dcel"));
    folder.dcel("build rings.segments --hole 3,-3 --y-down -o down.dcel").fails(2, "lies in the outer face", "");
    folder.dcel("build rings.segments --hole 3,3 --y-down -o down.dcel").fine();
    folder.dcel("build rings.segments --hole 30,3").fails(2, "hole point 0, (30, 3), lies in the outer face", "");
    folder.dcel("build rings.segments --hole 3").fails(2, "invalid value '3'", "for example 5,3");
    folder.write("flat.segments", "0 0 4 0\n4 0 0 3\n0 3 0 0\n");
    let told = folder.dcel("build flat.segments --nested-holes");
    assert!(told.err.contains("note: no ring lies inside another"), "{told:?}");
    // Many rings in each other, and two beside each other in one.
    let ring = |x: i32, y: i32, s: i32| {
        format!("{x} {y} {0} {y}\n{0} {y} {0} {1}\n{0} {1} {x} {1}\n{x} {1} {x} {y}\n", x + s, y + s)
    };
    let deep: String = (0..60).map(|i| ring(i, i, 200 - 2 * i)).collect();
    folder.write("deep.segments", &(deep + &ring(70, 70, 5) + &ring(80, 80, 5)));
    let report = folder.dcel("build deep.segments --nested-holes --json").json();
    assert_eq!(report["hole_faces"].as_array().map(Vec::len), Some(30), "{report}");
}

/// What is counted are points of the input: those that fall together on the grid are as many as they were.
#[test]
fn all_points_that_a_grid_moves_are_counted() {
    let folder = Folder::empty();
    folder.write("roads.wkt", "LINESTRING (0 0, 8 6)\nLINESTRING (0 6, 8 0)\nLINESTRING (2 0, 2 6, 6 6)\n");
    for (grid, moved) in [("8", 5), ("4", 5), ("64", 6)] {
        let told = folder.dcel(&format!("build roads.wkt --mend --grid {grid}"));
        let note = format!("{moved} points of the input moved");
        assert!(told.code == Some(0) && told.err.contains(&note), "{told:?}");
        let report = folder.dcel(&format!("build roads.wkt --mend --grid {grid} --json"));
        assert_eq!(report.json()["displaced_points"], json!(moved), "{grid}");
    }
}

/// Where nothing moved, nothing is further than 0.
#[test]
fn a_crossing_that_stays_in_place_is_at_distance_zero() {
    let folder = Folder::empty();
    folder.write("x.segments", "0 0 4 4\n0 4 4 0\n");
    for grid in ["", " --grid 2", " --grid 1"] {
        let report = folder.dcel(&format!("build x.segments --mend{grid} --json")).json();
        assert_eq!((&report["moved"], &report["farthest"]), (&json!([]), &json!(0.0)), "{grid}");
    }
    assert!(folder.dcel("build x.segments --mend --grid 2").err.contains("a grid of 2: nothing moved\n"));
    // The crossing moves, and with it both lines; then a line that is bent by the corner of another one.
    folder.write("y.segments", "0 0 4 2\n0 2 4 0\n");
    folder.write("z.segments", "0 0 4 2\n2 0 2 4\n8 4 12 4\n");
    for file in ["y", "z"] {
        let farthest = folder.dcel(&format!("build {file}.segments --mend --grid 2 --json")).json()["farthest"].clone();
        assert!(farthest.as_f64().is_some_and(|farthest| (1.0..1.5).contains(&farthest)), "{file}: {farthest}");
    }
}

#[test]
fn segments_that_become_points_are_named() {
    let folder = Folder::empty();
    let short = |n: usize| (0..n).map(|i| format!("{0} 0 {0} 0.25\n", 10 * i)).collect::<String>();
    let told = ["segment 0 is", "0 and 1", "0, 1 and 2", "0, 1, 2 and 3", "0, 1, 2 and 2 more"];
    for (n, told) in (1..).zip(told) {
        folder.write("short.segments", &short(n));
        let err = folder.dcel("build short.segments --mend --grid 2").err;
        let line = err.lines().find(|line| line.contains("shorter than a step")).unwrap_or_default();
        assert!(line.contains(told) && (n == 1 || line.ends_with(told)), "{n}: {err}");
    }
}

#[test]
fn segments_that_a_grid_brings_together_are_told() {
    let folder = Folder::empty();
    let told = |text: &str| {
        folder.write("near.segments", text);
        let err = folder.dcel("build near.segments --mend --grid 1").err;
        err.lines().find(|line| line.contains("lie on each other")).unwrap_or_default().to_owned()
    };
    // Apart, crossing, touching, and the same line twice, which is told as such.
    for apart in ["0 0 9 0\n0 1 9 1\n", "0 0 8 8\n0 8 8 0\n", "0 0 8 0\n4 0 4 8\n", "0 0 8 0\n8 0 0 0\n"] {
        assert_eq!(told(apart), "", "{apart}");
    }
    let note = |rest: &str| format!("note: segments lie on each other on the grid, the first of them {rest}");
    assert_eq!(told("0 5 9 5\n0 0 9 0.25\n0.25 0 9 0\n"), note("1 and 2 along e1"));
    assert_eq!(told("0 0 8 0\n0 0 8 0\n2 0.25 5 0.25\n"), note("0 and 2 along e1"));
    assert_eq!(told("0 0 8 0.5\n5 1 5 0.25\n4 8 4 -8\n0 0 8 -0.25\n"), note("0 and 3 along e0"));
}

/// A comma may be meant as a decimal point, so it parts no numbers.
#[test]
fn commas_in_segments_are_told_as_such() {
    let folder = Folder::empty();
    for (text, place, word) in [
        ("0,0,1,1\n", "1:1", "`0,0,1,1`"),
        ("0, 0, 1, 1\n", "1:1", "`0,`"),
        ("2\n0 0 1 1\n0 0 1;1\n", "3:5", "`1;1`"),
        ("0 0 1 0,5\n", "1:7", "`0,5`"),
    ] {
        folder.write("cs.segments", text);
        let what = format!("cs.segments:{place}: {word} is not a number");
        folder.dcel("build cs.segments").fails(2, &what, "four numbers with blanks between");
    }
}

/// Segments that are sides of polygons are told by feature, polygon and ring.
#[test]
fn sides_of_polygons_are_told_by_name() {
    let folder = Folder::empty();
    let feature = |name: &str, ring: &str| {
        format!(
            r#"{{"type":"Feature","properties":{{"name":"{name}"}},"geometry":{{"type":"Polygon","coordinates":[{ring}]}}}}"#
        )
    };
    let all = [
        feature("A", "[[0,0],[9,0],[9,9],[0,9],[0,0]],[[2,2],[4,2],[4,4],[2,2]]"),
        feature("B", "[[3,1],[3.5,1],[3.5,3.25],[3,1]]"),
    ];
    folder.write("two.json", &format!(r#"{{"type":"FeatureCollection","features":[{}]}}"#, all.join(",\n")));
    let told = folder.dcel("build two.json");
    told.fails(2, r#"two.json:1: features[0] "A" polygon 0 ring 1: segments 4 and"#, "--mend");
    assert!(told.err.contains(r#"segment 9: line 2: features[1] "B" polygon 0 ring 0"#), "{told:?}");
    let file = folder.dcel("build two.json --json");
    let error: serde_json::Value = serde_json::from_str(&file.out).expect("JSON");
    assert_eq!(error["error"]["place"]["file"], json!("two.json"));
    folder.write("two.wkt", "POLYGON((0 0,4 0,4 4,0 4,0 0))\nPOLYGON((2 2,6 2,6 6,2 6,2 2))\n");
    let told = folder.dcel("build two.wkt");
    told.fails(2, "two.wkt:1: polygon 0 ring 0: segments 2 and 7 cross at (2, 4)", "--mend");
    assert!(told.err.contains("(segment 4 of polygon 1 ring 0)"), "{told:?}");
    // Rings of TopoJSON are told in the same way.
    folder.write(
        "t.topojson",
        r#"{"type":"Topology","arcs":[[[0,0],[4,0],[4,4],[0,0]],[[2,1],[6,1],[6,5],[2,1]]],"objects":{"states":{"type":"GeometryCollection","geometries":[{"type":"Polygon","arcs":[[0]]},{"type":"Polygon","id":"x","arcs":[[1]]}]}}}"#,
    );
    let told = folder.dcel("build t.topojson");
    assert!(told.err.contains("states[0] polygon 0 ring 0: segments"), "{told:?}");
    assert!(told.err.contains(r#"states[1] "x" polygon 0 ring 0"#), "{told:?}");
}
