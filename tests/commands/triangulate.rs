//! Promise: `dcel triangulate` cuts the faces of a file into triangles, counts them, writes and draws them; `dcel
//! figure --dual` draws the dual graph.

use crate::shell::{Folder, GARDEN};
use serde_json::json;

const HOUSE: &str = "0 0 4 0\n4 0 4 3\n4 3 2 5\n2 5 0 3\n0 3 0 0\n2 1\n1 2 3 2\n";

#[test]
fn the_report_counts_and_the_result_can_be_read() {
    let folder = Folder::new();
    folder.write("house.segments", HOUSE);
    let text = folder.dcel("triangulate house.segments").fine();
    for line in ["house.segments: plane, segments, by monotone", "cut             1 face into 9 triangles"] {
        assert!(text.contains(line), "{line} in {text}");
    }
    for method in ["ears", "monotone"] {
        let report = folder.dcel(&format!("triangulate house.segments --method {method} --json")).json();
        // 5 + 2 half-edges and two rings.
        assert_eq!((&report["pieces"], &report["method"]), (&json!(9), &json!(method)));
        assert_eq!((&report["vertices"], &report["diagonals"], &report["faces"]), (&json!(8), &json!(10), &json!(10)));
        folder.dcel(&format!("triangulate house.segments --method {method} -o {method}.dcel")).fine();
        folder.dcel(&format!("validate {method}.dcel")).fine();
        let info = folder.dcel(&format!("info {method}.dcel --json")).json();
        assert_eq!((&info["faces"], &info["edges"]), (&json!(10), &json!(16)));
    }
    let report = folder.dcel("triangulate house.segments --pieces --json").json();
    assert_eq!(report["method"], json!("monotone pieces"));
    let dcel = folder.dcel("triangulate house.segments -o -").fine();
    assert_eq!(dcel, folder.read("monotone.dcel"));
}

#[test]
fn hole_faces_names_and_single_faces() {
    let folder = Folder::new();
    let report = folder.dcel("triangulate garden.json --json").json();
    assert_eq!((&report["faces_cut"], &report["pieces"], &report["hole_faces"]), (&json!(2), &json!(9), &json!(1)));
    let report = folder.dcel("triangulate garden.json --holes --json").json();
    assert_eq!((&report["faces_cut"], &report["pieces"], &report["hole_faces"]), (&json!(3), &json!(11), &json!(2)));
    let report = folder.dcel("triangulate garden.json --face f1 --json").json();
    assert_eq!((&report["faces_cut"], &report["pieces"]), (&json!(1), &json!(8)));
    let dcel = folder.dcel("triangulate garden.json -o -").fine();
    assert_eq!((dcel.matches("name \"Garden\"").count(), dcel.matches("name \"Shed\"").count()), (8, 1));
    // What the file does not hold is told as by convert.
    folder.write("wide.json", &GARDEN.replace("\"name\"", "\"size\": 3, \"name\""));
    let told = folder.dcel("triangulate wide.json -o t.obj").err;
    for note in ["9 names of faces are lost: obj has none", "1 hole face is not written", "properties of 2 features"] {
        assert!(told.contains(note), "{note}: {told}");
    }
    assert_eq!(folder.dcel("triangulate wide.json").err, "", "nothing is written");
    // A table keeps its ids.
    let report = folder.dcel("triangulate triangle.dcel --json").json();
    assert_eq!((&report["pieces"], &report["edges"]), (&json!(3), &json!(6)));
}

#[test]
fn figures_show_the_diagonals_and_the_dual() {
    let folder = Folder::new();
    folder.dcel("triangulate garden.json --figure garden.svg").fine();
    let drawn = folder.read("garden.svg");
    assert_eq!(drawn.matches(">diagonal e").count(), 8, "{drawn}");
    folder.write("grid.obj", &crate::shell::grid(3));
    let dual = folder.dcel("figure grid.obj --dual").fine();
    assert!(dual.contains("across an edge: from face to face") && dual.contains(">e0: f0, f1<"), "{dual}");
    assert!(folder.dcel("figure triangle.dcel --dual").fine().contains("<svg"));
    folder.dcel("figure cube.off --dual").fails(2, "a surface in space has no drawing in the plane", "--plane");
}

#[test]
fn wrong_faces_inputs_and_targets_are_refused() {
    let folder = Folder::new();
    folder.dcel("triangulate square.obj --face f0").fails(2, "square.obj: f0, the outer face, is unbounded", "bounded");
    folder.dcel("triangulate square.obj --face f9").fails(2, "square.obj: there is no f9: there are 3 faces", "f9");
    folder.dcel("triangulate cube.off").fails(2, "a surface in space", "--plane");
    folder.dcel("triangulate square.obj -o square.obj").fails(2, "this is the input itself", "another name");
    folder.dcel("triangulate square.obj -o out").fails(2, "the file name does not say which format", ".dcel");
    folder.dcel("triangulate square.obj --figure no/where.svg").fails(3, "cannot be written", "directory first");
    let both = folder.dcel("triangulate square.obj --json -o x.dcel").json();
    assert_eq!(both, folder.dcel("triangulate square.obj --json").json());
    assert_eq!(folder.read("x.dcel"), folder.dcel("triangulate square.obj -o -").fine());
    folder.dcel("triangulate missing.obj").fails(2, "missing.obj: cannot be read", "check the name");
}
