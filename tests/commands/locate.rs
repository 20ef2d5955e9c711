//! Promise: `dcel locate` tells where points lie, and `dcel overlay` what two subdivisions make together; both draw it,
//! say it in JSON, and name what they refuse.

use crate::shell::Folder;
use serde_json::json;

const TILES: &str = "v 2 1\nv 6 1\nv 6 2\nv 2 2\nf 1 2 3 4\n";

#[test]
fn every_kind_of_place_is_told() {
    let folder = Folder::new();
    let text = folder.dcel("locate garden.json 1 1 3 3 -2.5 1e2 0 0 10 5").fine();
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(
        lines,
        [
            "(1, 1)  face f1 \"Garden\"",
            "(3, 3)  hole face f3",
            "(-2.5, 100)  outer face f0",
            "(0, 0)  vertex v0",
            "(10, 5)  edge h2 between f1 and f0"
        ]
    );
    let report = folder.dcel("locate garden.json 10 5 21 1 --json").json();
    assert_eq!(report["points"][0]["kind"], "edge");
    assert_eq!(report["points"][0]["between"], json!(["f1", "f0"]));
    assert_eq!((&report["points"][1]["element"], &report["points"][1]["name"]), (&json!("f2"), &json!("Shed")));
    let walk = folder.dcel("locate garden.json 21 1 --walk v0 --json").json();
    assert_eq!(walk["points"][0]["walk"]["faces"], json!(["f1", "f0", "f2"]));
}

#[test]
fn points_come_from_files_in_the_coordinates_of_the_structure() {
    let folder = Folder::new();
    let many: String = (0..40).map(|i| format!("{} 0.5\n", 0.1 * f64::from(i))).collect();
    folder.write("many.txt", &many);
    let text = folder.dcel("locate square.obj --points many.txt -o many.svg").fine();
    assert_eq!(text.lines().count(), 40);
    assert!(text.lines().nth(10).unwrap().starts_with("(1, 0.5)  face f1"), "{text}");
    assert!(folder.read("many.svg").contains("</svg>"));
    // With y downwards, f1 lies below the diagonal of the picture and above it in the plane.
    let down = folder.dcel("locate square.obj 3 1 --y-down --orient").fine();
    assert_eq!(down, "(3, 1)  face f1\n");
    folder.dcel("locate square.obj 3 1 1 2 --walk v1 -o walk.svg").fine();
    assert!(folder.read("walk.svg").contains("where the walks start"));
}

#[test]
fn wrong_points_are_refused() {
    let folder = Folder::new();
    folder.write("bad.txt", "1 2\n3 x\n");
    folder.write("far.txt", "1 2\n3 1e99\n");
    folder.dcel("locate square.obj 1 2 3").fails(2, "3 coordinates are no points", "x and y of each point");
    folder.dcel("locate square.obj 1 nan").fails(2, "y is NaN", "");
    folder.dcel("locate square.obj --points bad.txt").fails(2, "bad.txt:2:3", "");
    folder.dcel("locate square.obj --points far.txt").fails(2, "far.txt:2:3: y = 1e99 is outside the exact range", "");
    folder.dcel("locate cube.off 1 2").fails(2, "cube.off: this is a surface in space", "--plane");
    folder.dcel("locate square.obj 1 2 --walk v9").fails(2, "--walk: there is no v9: there are 4 vertices", "");
    folder.dcel("locate square.obj 1 2 -o square.obj").fails(2, "square.obj: this is the input itself", "");
    folder.dcel("locate nowhere.obj 1 2").fails(2, "nowhere.obj", "");
}

#[test]
fn an_overlay_tells_labels_regions_and_what_moved() {
    let folder = Folder::new();
    folder.write("tiles.obj", TILES);
    let report = folder.dcel("overlay square.obj tiles.obj --json").json();
    assert_eq!((&report["vertices"], &report["faces"]), (&json!(12), &json!(7)));
    assert_eq!(report["crossings"].as_array().unwrap().len(), 4);
    let moved = report["moved"].as_array().unwrap();
    assert!(moved.len() == 1 && moved[0]["by"].as_f64().unwrap() < 1e-15, "{moved:?}");
    let areas = ["union", "intersection", "difference", "xor"].map(|operation| {
        folder.dcel(&format!("overlay square.obj tiles.obj --join --operation {operation} --json")).json()["region"]
                ["area"]
                .as_f64()
                .unwrap()
    });
    assert_eq!(areas.map(|area| area.to_string()), ["14", "2", "10", "12"]);
    let text = folder.dcel("overlay square.obj tiles.obj --operation difference --join -o rest.dcel").fine();
    assert!(text.contains("difference      1 face, area 10"), "{text}");
    assert_eq!(folder.dcel("info rest.dcel --json").json()["valid"], json!(true));
    assert_eq!(
        folder.dcel("overlay square.obj tiles.obj --operation difference --join -o -").fine(),
        folder.read("rest.dcel")
    );
}

/// The crossing lies at (x + 1/3, y + 2/3): no doubles.
#[test]
fn the_area_of_a_region_is_not_that_of_rounded_corners() {
    let folder = Folder::new();
    let (x, y) = (4_000_000, 5_500_000);
    let triangle = |corners: [(f64, f64); 3]| {
        let lines = corners.map(|(dx, dy)| format!("v {} {} 0\n", f64::from(x) + dx, f64::from(y) + dy));
        format!("{}f 1 2 3\n", lines.concat())
    };
    folder.write("a.obj", &triangle([(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)]));
    folder.write("b.obj", &triangle([(0.0, 0.0), (0.5, 0.0), (0.5, 1.0)]));
    let call = "overlay a.obj b.obj --operation intersection --join";
    let area = |flags: &str| folder.dcel(&format!("{call} {flags} --json")).json()["region"]["area"].as_f64().unwrap();
    let off = |area: f64| (area - 5.0 / 24.0).abs();
    assert!(off(area("")) < 1e-16, "{}", area(""));
    // The answer on a grid is what somebody asked for.
    assert!((1e-12..1e-3).contains(&off(area("--grid 1e-6"))), "{}", area("--grid 1e-6"));
}

/// What lies on the grid has not moved, and what has is counted.
#[test]
fn crossings_on_the_grid_are_not_said_to_move() {
    let folder = Folder::new();
    let square = |low: f64| {
        let high = low + 1.0;
        format!("POLYGON (({low} {low}, {high} {low}, {high} {high}, {low} {high}, {low} {low}))\n")
    };
    folder.write("p.wkt", &square(0.0));
    folder.write("q.wkt", &square(0.5));
    let told = folder.dcel("overlay p.wkt q.wkt --grid 0.5 --json");
    assert!(!told.err.contains("crossing"), "{}", told.err);
    let report = told.json();
    assert_eq!((report["crossings"].as_array().unwrap().len(), &report["moved"]), (2, &json!([])));
    let told = folder.dcel("overlay p.wkt q.wkt --grid 1");
    assert!(told.err.contains("note: 1 crossing was rounded to the grid, by 0.5"), "{}", told.err);
    folder.write("x.segments", "0 0 1 1\n0 1 1 0\n");
    assert_eq!(folder.dcel("build x.segments --mend --grid 0.25 --json").json()["moved"], json!([]));
}

#[test]
fn numbers_below_zero_may_be_written_in_any_way() {
    let folder = Folder::new();
    for (written, told) in
        [("-1e-05", "-0.00001"), ("-.5", "-0.5"), ("-1.5E-3", "-0.0015"), ("-2e+1", "-20"), ("-3.", "-3")]
    {
        let answer = folder.dcel(&format!("locate square.obj {written} 1")).fine();
        assert!(answer.starts_with(&format!("({told}, 1)")), "{written}: {answer}");
    }
    folder.dcel("locate square.obj --grid -1e-3").fails(2, "--grid", "");
    // What is no number stays an option.
    for wrong in ["-1e-x", "-.x", "-e5"] {
        folder.dcel(&format!("locate square.obj {wrong} 1")).fails(2, "unexpected argument", "");
    }
    let told = folder.dcel("build --grid -1e-3 square.obj");
    assert!(told.code == Some(2) && !told.err.contains("unexpected argument"), "{told:?}");
}

#[test]
fn overlays_are_drawn_and_named() {
    let folder = Folder::new();
    folder.write("tiles.obj", "v 3 1\nv 8 1\nv 12.5 8\nv 3 6\nf 1 2 3 4\n");
    folder.dcel("overlay garden.json tiles.obj -o both.svg").fine();
    let svg = folder.read("both.svg");
    assert!(svg.contains("in a alone") && svg.contains("in both") && svg.contains("in b alone"));
    folder.dcel("overlay garden.json tiles.obj -o both.dcel").fine();
    assert!(folder.read("both.dcel").contains("Garden & f1"));
    // A format without names says so.
    folder.write("two.wkt", "POLYGON ((1 1, 2 1, 2 2, 1 1))");
    let told = folder.dcel("overlay square.obj two.wkt -o both.off");
    assert!(told.code == Some(0) && told.err.contains("names of faces are lost: off has none"), "{told:?}");
    folder.dcel("overlay garden.json tiles.obj --operation xor -o xor.svg").fine();
    assert!(folder.read("xor.svg").contains("edges of b"));
    let told = folder.dcel("overlay garden.json tiles.obj --operation and");
    assert!(told.code == Some(2) && told.err.contains("union, intersection, difference or xor"), "{told:?}");
    folder.dcel("overlay garden.json cube.off").fails(2, "cube.off: this is a surface", "--plane");
    folder.dcel("overlay garden.json tiles.obj -o tiles.obj").fails(2, "this is the input itself", "another name");
    folder.dcel("overlay garden.json tiles.obj -o both").fails(2, "the file name does not say", ".svg");
    folder.dcel("overlay garden.json tiles.obj -o both.bogus").fails(2, "the file name does not say", ".dcel");
}

/// `defects/h1.json`
#[test]
fn areas_far_from_the_origin_keep_their_digits() {
    let folder = Folder::new();
    let corners = "[4000000.0,5500000.0],[4000000.1,5500000.0],[4000000.1,5500000.1],[4000000.0,5500000.1]";
    let text = format!(r#"{{"type":"Polygon","coordinates":[[{corners},[4000000.0,5500000.0]]]}}"#);
    folder.write("h1.json", &text);
    let report = folder.dcel("overlay h1.json h1.json --operation union --json").json();
    let side = (4000000.1_f64 - 4000000.0) * (5500000.1_f64 - 5500000.0);
    assert_eq!(report["region"]["area"].as_f64(), Some(side));
    let coarse = folder.dcel("overlay h1.json h1.json --operation union --grid 0.25 --json").json();
    assert_eq!((&coarse["grid"], &coarse["region"]["area"]), (&json!(0.25), &json!(0.0)));
    let floor = folder.dcel("navmesh info h1.json --json").json();
    assert_eq!(
        [&floor["area"], &floor["walkable_area"], &floor["blocked_area"]],
        [&json!(side), &json!(side), &json!(0.0)]
    );
}
