//! Rings that share a side, rings that enclose nothing: what is said of them, and what the options do.

use crate::shell::Folder;
use serde_json::json;

/// A feature with the name A, of one polygon with these rings.
fn feature(rings: &[&str]) -> String {
    let rings: Vec<String> = rings.iter().map(|ring| format!("[{ring}]")).collect();
    format!(
        "{{\"type\":\"FeatureCollection\",\"features\":[\n{{\"type\":\"Feature\",\"properties\":{{\"name\":\"A\"}},\
         \"geometry\":{{\"type\":\"Polygon\",\"coordinates\":[{}]}}}}]}}\n",
        rings.join(",")
    )
}

const SHELL: &str = "[0,0],[4,0],[4,4],[0,4],[0,0]";
const POLYGON: &str = "features[0] \"A\" polygon 0";

#[test]
fn a_hole_along_a_part_of_a_side_of_the_shell_is_named_with_it() {
    let folder = Folder::new();
    folder.write("w.geojson", &feature(&[SHELL, "[4,1],[4,3],[2,2],[4,1]"]));
    let words = format!(
        "rings 0 and 1 of {POLYGON} have in common the side (4, 3) -> (4, 1), so that none of the polygon lies between them"
    );
    for call in ["info", "triangulate"] {
        folder.dcel(&format!("{call} w.geojson")).fails(2, &words, "--mend");
    }
    assert!(folder.dcel("validate w.geojson").out.contains(&words));
}

#[test]
fn two_holes_along_each_other_are_both_named() {
    let folder = Folder::new();
    folder.write("two.geojson", &feature(&[SHELL, "[1,1],[2,1],[2,2],[1,1]", "[1,1],[3,1],[3,3],[1,3],[1,1]"]));
    let words = format!("rings 1 and 2 of {POLYGON} overlap: both lie on the same side of the edge (");
    folder.dcel("info two.geojson").fails(2, &words, "--mend");
    // Holes beside each other do not overlap.
    folder
        .write("beside.geojson", &feature(&[SHELL, "[1,1],[2,1],[2,2],[1,2],[1,1]", "[2,1],[3,1],[3,2],[2,2],[2,1]"]));
    let words = format!("rings 1 and 2 of {POLYGON} have in common the side (2, ");
    folder.dcel("info beside.geojson").fails(2, &words, "--mend");
    // A ring that was left out does not change the numbers of those behind it.
    let rings = [SHELL, "[3,3],[3,3]", "[1,1],[2,1],[2,2],[1,2],[1,1]", "[2,1],[3,1],[3,2],[2,2],[2,1]"];
    folder.write("behind.geojson", &feature(&rings));
    let words = format!("rings 2 and 3 of {POLYGON} have in common the side (2, ");
    folder.dcel("info behind.geojson --drop-degenerate-rings").fails(2, &words, "--mend");
}

#[test]
fn a_ring_on_one_line_is_left_out_as_one_without_three_points() {
    let folder = Folder::new();
    let hole = "[1,1],[3,1],[2,2],[1,1]";
    for (ring, words) in [
        ("[0,0],[4,0],[2,0],[0,0]", "has all its points on one line, from (0, 0) to (4, 0)"),
        ("[0.1,0.1],[0.3,0.3],[0.7,0.7],[0.1,0.1]", "has all its points on one line, from (0.1, 0.1) to (0.7, 0.7)"),
        ("[1,1],[1,1],[1,1],[1,1]", "has only 1 distinct point"),
    ] {
        folder.write("hole.json", &feature(&[SHELL, ring]));
        for flag in ["--drop-degenerate-rings", "--mend", "--mend --drop-degenerate-rings"] {
            let told = folder.dcel(&format!("info hole.json {flag} --json"));
            let note = format!("note: dropped a degenerate ring: {POLYGON} ring 1 {words}\n");
            assert!(told.code == Some(0) && told.err.contains(&note), "{flag}: {told:?}");
            assert!(!told.err.contains("nothing to mend"), "{flag}: {told:?}");
            assert_eq!(told.json()["edges"], json!(4), "{flag}");
        }
        folder.write("alone.json", &feature(&[ring]));
        for flag in ["--drop-degenerate-rings", "--mend"] {
            let told = folder.dcel(&format!("info alone.json {flag} --json"));
            let note = format!("note: dropped a degenerate ring: {POLYGON} ring 0 {words}\n");
            assert!(told.code == Some(0) && told.err.contains(&note), "{flag}: {told:?}");
            assert_eq!(told.json()["edges"], json!(0), "{flag}");
        }
        // Alone, the flag drops the polygon with its outer ring; --mend drops the ring and takes the others as outlines.
        folder.write("outer.json", &feature(&[ring, hole]));
        for (flag, rest, edges) in [
            ("--drop-degenerate-rings", "; its polygon went with it, with 1 more ring", 0),
            ("--mend", "", 3),
            ("--mend --drop-degenerate-rings", "", 3),
        ] {
            let told = folder.dcel(&format!("info outer.json {flag} --json"));
            let note = format!("note: dropped a degenerate ring: {POLYGON} ring 0 {words}{rest}\n");
            assert!(told.code == Some(0) && told.err.contains(&note), "{flag}: {told:?}");
            let outlines = format!(
                "1 polygon has an outer ring that encloses nothing, so that the other rings were taken as outlines: {POLYGON}\n"
            );
            assert_eq!(told.err.contains(&outlines), rest.is_empty(), "{flag}: {told:?}");
            assert_eq!(told.json()["edges"], json!(edges), "{flag}");
        }
        folder.dcel("navmesh info outer.json --mend").fine();
        folder.dcel("triangulate outer.json --mend").fine();
        folder.dcel("figure outer.json --mend -o outer.svg").fine();
    }
    let told = folder.dcel("info outer.json");
    told.fails(2, "ring 0: the ring has only 1 distinct point", "--mend");
    // A ring that is thin by a hair encloses something.
    folder.write("thin.json", &feature(&["[0.1,0.1],[0.3,0.30000000000000004],[0.7,0.7],[0.1,0.1]"]));
    let told = folder.dcel("info thin.json --drop-degenerate-rings --json");
    assert_eq!((told.err.clone(), &told.json()["edges"]), (String::new(), &json!(3)));
}

#[test]
fn a_face_that_sticks_out_is_not_said_to_lie_inside_and_has_its_line() {
    let folder = Folder::new();
    let file = "v 0 0\nv 2 0\nv 2 2\nv 0 2\nv 1 1\nv 3 1\nv 3 3\nf 1 2 3 4\nf 5 6 7\n";
    folder.write("o.obj", file);
    folder.dcel("info o.obj").fails(2, "cross", "--mend");
    for call in ["info o.obj --trust", "figure o.obj --trust"] {
        let told = folder.dcel(call);
        told.fails(2, "o.obj:9: a corner of face 1, (1, 1), lies inside face 0: they overlap", "--mend");
        assert!(told.err.contains("overlap\nnote: counted from 0; face 0: line 8\n"), "{told:?}");
        assert!(!told.err.contains("no hole") && !told.err.contains("vertex"), "{told:?}");
    }
    // One that does lie inside is still told so, of the face it lies in: of the two triangles not that at the border below.
    folder.write("i.obj", "v 0 0\nv 9 0\nv 9 9\nv 0 9\nv 2 6\nv 3 6\nv 2 7\nf 1 2 3\nf 1 3 4\nf 5 6 7\n");
    let told = folder.dcel("info i.obj");
    told.fails(
        2,
        "i.obj:10: face 2 lies inside face 1, which has no hole there: they overlap, for example at (2, 6)",
        "",
    );
    assert!(told.err.contains("note: counted from 0; face 1: line 9\n"), "{told:?}");
    folder.dcel("info i.obj --trust").fails(
        2,
        "i.obj:10: a corner of face 2, (2, 6), lies inside face 1: they overlap",
        "",
    );
}

#[test]
fn whatever_takes_mend_says_that_there_was_nothing_to_mend() {
    let folder = Folder::new();
    let (left, right) = ("[0,0],[4,0],[4,4],[0,4],[0,0]", "[4,0],[8,0],[8,4],[4,4],[4,0]");
    let polygons = format!("{{\"type\":\"MultiPolygon\",\"coordinates\":[[[{left}]],[[{right}]]]}}");
    folder.write("two.json", &polygons);
    folder.write("two.obj", "v 0 0\nv 4 0\nv 4 4\nv 0 4\nv 8 0\nv 8 4\nf 1 2 3 4\nf 2 5 6 3\n");
    // Segments that are given twice, or have no length, are left out with --mend and without.
    folder.write("twice.segments", "0 0 4 0\n4 0 4 4\n4 4 0 0\n4 0 0 0\n3 1 3 1\n");
    folder.write("two.wkt", "LINESTRING (0 0, 4 0, 4 4)\nLINESTRING (4 4, 0 0)\n");
    let mut calls: Vec<String> = Vec::new();
    for file in ["two.json", "two.obj", "twice.segments", "two.wkt"] {
        for call in [
            "info FILE",
            "validate FILE",
            "convert FILE out.dcel",
            "figure FILE -o out.svg",
            "locate FILE 3 1",
            "walk FILE --face f1",
            "triangulate FILE",
            "play FILE --no-open -o out.html",
            "navmesh info FILE",
            "navmesh path FILE 3 1 3 2",
            "navmesh random FILE",
        ] {
            calls.push(call.replace("FILE", file));
        }
        if !file.ends_with(".obj") {
            calls.push(format!("build {file}"));
            calls.push(format!("build {file} --y-down --json"));
        }
    }
    calls.push("delaunay two.json --constrained".to_owned());
    calls.push("overlay two.json two.obj".to_owned());
    calls.push("film ears two.json -o out.svg".to_owned());
    for call in calls {
        let told = folder.dcel(&format!("{call} --mend"));
        if told.code == Some(2) && told.err.contains("unexpected argument '--mend'") {
            continue;
        }
        let said = told.err.matches("nothing to mend\n").count();
        assert_eq!(said, 1 + usize::from(call.starts_with("overlay")), "{call}: {told:?}");
    }
}

/// Holes that cut a polygon into pieces are told by ring and place, however they touch.
#[test]
fn holes_that_cut_a_polygon_into_pieces_are_told_by_place() {
    let folder = Folder::new();
    let shell = "[[0,0],[10,0],[10,10],[0,10],[0,0]]";
    let polygon = |rings: &str| format!("{{\"type\":\"Polygon\",\"coordinates\":[{shell},\n{rings}]}}");
    folder.write("two.geojson", &polygon("[[0,5],[5,2],[10,5],[5,8],[0,5]]"));
    let told = folder.dcel("info two.geojson");
    told.fails(2, "is cut into pieces by its holes: ring 0 and ring 1 touch at (", "--mend");
    assert!(
        told.err.contains("(0, 5)") && told.err.contains("(10, 5)") && told.err.contains("two.geojson:1:"),
        "{told:?}"
    );
    assert!(told.err.contains("ring 1: line 2"), "{told:?}");
    assert!(folder.dcel("info two.geojson --y-down").err.contains("(10, 5)"));
    // Three holes in turn; a fourth one that touches once has no part in it.
    folder.write(
        "turn.geojson",
        &polygon("[[4,0],[6,2],[2,2],[4,0]],\n[[2,2],[3,6],[1,6],[2,2]],\n[[3,6],[5,7],[0,8],[3,6]],\n[[9,3],[10,4],[9,5],[9,3]]"),
    );
    let told = folder.dcel("info turn.geojson");
    told.fails(2, "ring 0, ring 1, ring 2 and ring 3 touch one after another at (", "--mend");
    for place in ["(4, 0)", "(2, 2)", "(3, 6)", "(0, 8)"] {
        assert!(told.err.contains(place), "{place}: {told:?}");
    }
    assert!(!told.err.contains("(10, 4)"), "{told:?}");
    folder.dcel("info turn.geojson --mend").fine();
}
