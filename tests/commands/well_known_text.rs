//! Polygons of well-known text are polygons with holes, as those of GeoJSON are; lines and points stay what they are.

use crate::shell::Folder;
use serde_json::json;

const HOLE: &str = "POLYGON((0 0,10 0,10 10,0 10,0 0),(2 2,4 2,4 4,2 4,2 2))\n";
const HOLE_JSON: &str = r#"{"type":"Polygon","coordinates":
[[[0,0],[10,0],[10,10],[0,10],[0,0]],[[2,2],[4,2],[4,4],[2,4],[2,2]]]}"#;
/// One polygon inside the other, and two that cross.
const NEST: &str = "MULTIPOLYGON(((0 0,9 0,9 9,0 9,0 0)),\n ((2 2,4 2,4 4,2 4,2 2)))\n";
const CROSS: &str = "POLYGON((0 0,4 0,4 4,0 4,0 0))\nPOLYGON((2 2,6 2,6 6,2 6,2 2))\n";

fn folder() -> Folder {
    let folder = Folder::new();
    let files = [("hole.wkt", HOLE), ("hole.geojson", HOLE_JSON), ("nest.wkt", NEST), ("cross.wkt", CROSS)];
    files.into_iter().for_each(|(name, text)| folder.write(name, text));
    folder.write("sq.wkt", "POLYGON((0 0,10 0,10 10,0 10,0 0))\n");
    folder
}

#[test]
fn a_hole_is_a_hole_in_every_command_that_reads_faces() {
    let folder = folder();
    let region = folder.dcel("overlay hole.wkt sq.wkt --operation intersection --json").json();
    assert_eq!(region["region"]["area"], json!(96.0));
    assert!(folder.dcel("locate hole.wkt 3 3").fine().contains("hole face"));
    folder.dcel("convert hole.wkt back.geojson").fine();
    assert_eq!(folder.read("back.geojson").matches("Polygon").count(), 1);
    // The same answers as of the same polygon in GeoJSON, but for the names of the file and the format.
    for call in ["info FILE --json", "triangulate FILE --json", "locate FILE 3 3 1 1 --json", "walk FILE --face f1"] {
        let [wkt, json] = ["wkt", "geojson"].map(|format| {
            let told = folder.dcel(&call.replace("FILE", &format!("hole.{format}"))).fine();
            told.replace(&format!("hole.{format}"), "FILE").replace(&format!("\"{format}\""), "FORMAT")
        });
        assert_eq!(wkt, json, "{call}");
    }
    // Upside down, a ring is still what it is.
    assert!(folder.dcel("locate hole.wkt 3 3 --y-down").fine().contains("hole face"));
    assert_eq!(folder.dcel("info hole.wkt --trust").code, Some(0));
    let build = folder.dcel("build hole.wkt --json").json();
    assert_eq!((&build["segments"], &build["faces"], &build["hole_faces"]), (&json!(8), &json!(3), &json!([])));
}

#[test]
fn misfits_name_polygon_ring_and_place() {
    let folder = folder();
    folder.dcel("info nest.wkt").fails(2, "nest.wkt:2:3: polygon 1 ring 0 lies inside polygon 0", "--mend");
    let told = folder.dcel("info cross.wkt");
    told.fails(2, "cross.wkt:1:9: G3: polygon 0 ring 0 and polygon 1 ring 0 cross at (2, 4)", "--mend");
    let told = folder.dcel("validate nest.wkt");
    assert!(told.code == Some(1) && told.out.contains("polygon 1 ring 0"), "{told:?}");
    folder.dcel("validate hole.wkt").fine();
    let told = folder.dcel("info cross.wkt --mend");
    assert!(told.err.contains("polygon 0 and polygon 1 overlap in area 4"), "{told:?}");
    assert!(folder.dcel("info hole.wkt --mend").err.contains("note: nothing to mend\n"));
    // Rings that are open, flat, or of too few points.
    folder.write("open.wkt", "POLYGON((0 0,1 0,1 1,0 0))\nPOLYGON((5 5,6 5,6 6))\n");
    folder.dcel("info open.wkt").fails(
        2,
        "open.wkt:2:9: polygon 1 ring 0: the ring starts at (5, 5) and ends",
        "--mend",
    );
    for call in ["info open.wkt --mend", "build open.wkt --mend"] {
        let told = folder.dcel(call);
        assert!(
            told.code == Some(0) && told.err.contains("1 ring that did not end where it starts was closed"),
            "{told:?}"
        );
    }
    folder.write("flat.wkt", "POLYGON((0 0,1 0,1 1,0 0))\nPOLYGON((5 5,6 5,5 5))\n");
    folder.dcel("info flat.wkt").fails(2, "flat.wkt:2:9: polygon 1 ring 0: the ring has only 2 distinct points", "");
    let told = folder.dcel("info flat.wkt --drop-degenerate-rings");
    assert!(told.code == Some(0) && told.err.contains("dropped a degenerate ring: polygon 1 ring 0"), "{told:?}");
    folder.write("line.wkt", "LINESTRING(0 0,1 0)\n");
    folder.dcel("info line.wkt --drop-degenerate-rings").fails(2, "cannot be used on wkt", "leave");
}

#[test]
fn lines_and_points_beside_polygons_are_skipped_with_a_note() {
    let folder = folder();
    folder.write(
        "mixed.wkt",
        "GEOMETRYCOLLECTION(POINT(9 9),LINESTRING(0 0,9 0),POLYGON Z((0 0 7,4 0 7,0 4 7,0 0 7)),POLYGON EMPTY)\n",
    );
    let told = folder.dcel("info mixed.wkt --json");
    for note in [
        "1 line geometry was skipped: only polygons are read",
        "1 point geometry was skipped: only polygons are read",
        "1 polygon without any ring was skipped",
        "the third coordinate of 4 points was dropped",
    ] {
        assert!(told.err.contains(note), "{note}: {told:?}");
    }
    assert_eq!(told.json()["faces"], json!(2));
    // All of them are read as lines, and as points.
    assert_eq!(folder.dcel("build mixed.wkt --mend --json").json()["segments"], json!(4));
    assert_eq!(folder.dcel("delaunay mixed.wkt --json").json()["points"], json!(5));
    // Without a polygon nothing is one.
    folder.write("roads.wkt", "LINESTRING(0 0,4 0,4 4)\nPOINT(1 1)\nPOLYGON EMPTY\n");
    assert_eq!(folder.dcel("info roads.wkt --json").json()["edges"], json!(2));
}

/// Point features are the usual file of sites.
#[test]
fn points_of_maps_are_points() {
    let folder = Folder::new();
    let feature = |at: &str| {
        format!(r#"{{"type":"Feature","properties":{{}},"geometry":{{"type":"Point","coordinates":{at}}}}}"#)
    };
    let features = ["[0,0]", "[1,0]", "[0,1]"].map(feature).join(",");
    folder.write("pp.geojson", &format!(r#"{{"type":"FeatureCollection","features":[{features}]}}"#));
    folder.write("mp.geojson", r#"{"type":"MultiPoint","coordinates":[[0,0],[1,0],[0,1]]}"#);
    let topology =
        r#"{"type":"Topology","arcs":[],"objects":{"sites":{"type":"MultiPoint","coordinates":[[0,0],[1,0],[0,1]]}}}"#;
    folder.write("mp.topojson", topology);
    folder.write("mp.wkt", "MULTIPOINT(0 0,1 0,0 1)\n");
    for file in ["pp.geojson", "mp.geojson", "mp.topojson", "mp.wkt"] {
        let delaunay = folder.dcel(&format!("delaunay {file} --json"));
        assert!(!delaunay.err.contains("skipped"), "{delaunay:?}");
        let delaunay = delaunay.json();
        assert_eq!((&delaunay["points"], &delaunay["triangles"]), (&json!(3), &json!(1)), "{file}");
        assert_eq!(folder.dcel(&format!("voronoi {file} --json")).json()["sites"], json!(3), "{file}");
        assert_eq!(folder.dcel(&format!("locate square.obj --points {file}")).fine().lines().count(), 3, "{file}");
        folder.dcel(&format!("film hull {file} -o hull.svg")).fine();
    }
    // Corners that polygons share count once, points that are given twice do not.
    folder.write("two.wkt", "POLYGON((0 0,4 0,4 4,0 0))\nPOLYGON((0 0,4 4,0 4,0 0))\nPOINT(1 1)\nPOINT(1 1)\n");
    let told = folder.dcel("delaunay two.wkt --json");
    assert!(told.err.contains("points that repeat earlier ones, 1: "), "{told:?}");
    assert_eq!(told.json()["points"], json!(6));
    assert_eq!(folder.dcel("delaunay garden.json --json").json()["points"], json!(11));
    // Corners are corners, wherever their ring ends.
    folder.write("open.wkt", "POLYGON((0 0,1 0,1 1))\n");
    folder.write("open.geojson", r#"{"type":"Polygon","coordinates":[[[0,0],[1,0],[1,1]]]}"#);
    for file in ["open.wkt", "open.geojson"] {
        assert_eq!(folder.dcel(&format!("delaunay {file} --json")).json()["points"], json!(3), "{file}");
        folder.dcel(&format!("info {file}")).fails(2, "the ring starts at (0, 0) and ends at (1, 1)", "--mend");
    }
}

/// Of several objects one is read, and that is said whatever they hold.
#[test]
fn objects_of_lines_and_points_are_chosen_with_a_note() {
    let folder = Folder::new();
    let file = |objects: &str| {
        format!(r#"{{"type":"Topology","arcs":[[[0,0],[1,0]],[[5,5],[6,5],[6,6]]],"objects":{{{objects}}}}}"#)
    };
    let (roads, rails) = (r#"{"type":"LineString","arcs":[0]}"#, r#"{"type":"MultiLineString","arcs":[[0],[1]]}"#);
    folder.write("rr.topojson", &file(&format!(r#""roads":{roads},"rails":{rails}"#)));
    for command in ["build", "info"] {
        let told = folder.dcel(&format!("{command} rr.topojson"));
        let note =
            "note: the file has the objects rails (2 lines), roads (1 line); rails was read (choose with --object)";
        assert!(told.code == Some(0) && told.err.contains(note), "{told:?}");
    }
    assert_eq!(folder.dcel("build rr.topojson --json").json()["segments"], json!(3));
    assert_eq!(folder.dcel("build rr.topojson --object roads --json").json()["segments"], json!(1));
    folder.write("nr.topojson", &file(&format!(r#""nodes":{{"type":"Point","coordinates":[0,0]}},"roads":{roads}"#)));
    let told = folder.dcel("build nr.topojson --json");
    assert!(told.err.contains("nodes (1 point), roads (1 line); roads was read"), "{told:?}");
    assert_eq!(told.json()["segments"], json!(1));
}
