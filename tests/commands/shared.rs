//! The command on files made by others, against counts made by others.

use crate::shell::Folder;
use serde_json::Value;
use std::path::{Path, PathBuf};

fn shared(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../shared/data").join(name)
}

fn json(path: &Path) -> Value {
    serde_json::from_str(&std::fs::read_to_string(path).expect("the file of answers")).expect("JSON")
}

const STATES: &str = "--y-down --drop-degenerate-rings";

fn states() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("figures/data/states-albers-10m.json")
}

#[test]
fn the_states_have_the_counts_of_the_map() {
    let folder = Folder::new();
    let told = folder.dcel_on(&states(), &format!("info --json {STATES}"));
    assert!(told.err.contains("\"Delaware\" polygon 0 ring 0 has only 2 distinct points"), "{}", told.err);
    let info = told.json();
    for (key, value) in [("vertices", 6818), ("edges", 6872), ("faces", 198), ("components", 143), ("euler", 144)] {
        assert_eq!(info[key], value, "{key}");
    }
    assert_eq!((&info["mode"], &info["valid"], &info["format"]), (&"plane".into(), &true.into(), &"topojson".into()));
    assert_eq!((&info["names"], &info["rings"]), (&51.into(), &143.into()));
    folder.dcel_on(&states(), "info").fails(2, "\"Delaware\"", "--drop-degenerate-rings");
    assert_eq!(folder.dcel_on(&states(), &format!("validate {STATES}")).code, Some(0));
}

#[test]
fn tennessee_has_eight_neighbours() {
    let folder = Folder::new();
    let call = format!("walk --json {STATES} --face-name");
    let names = |state: &str| -> Vec<String> {
        let walk = folder.dcel_on(&states(), &format!("{call} {state}")).json();
        walk["adjacent_names"].as_array().expect("names").iter().map(|n| n.as_str().unwrap_or("").to_owned()).collect()
    };
    assert_eq!(
        names("Tennessee"),
        ["Alabama", "Arkansas", "Georgia", "Kentucky", "Mississippi", "Missouri", "North Carolina", "Virginia"]
    );
    assert_eq!(names("mAine"), ["New Hampshire"]);
    assert_eq!(names("Alaska"), [""; 0]);
    let told = folder.dcel_on(&states(), &format!("{call} Tenessee"));
    told.fails(2, "no face is named `Tenessee`", "did you mean `Tennessee`?");
}

#[test]
#[cfg_attr(not(shared_data), ignore = "needs ../shared/data")]
fn maps_have_the_counts_of_others() {
    let folder = Folder::new();
    let expected = json(&shared("O08-us-atlas/expected.json"));
    for map in ["nation-10m", "nation-albers-10m", "states-albers-10m"] {
        let expected = &expected[format!("{map}.json")];
        let path = shared(&format!("O08-us-atlas/{map}.json"));
        let info = folder.dcel_on(&path, "info --json --full-check --drop-degenerate-rings").json();
        for (key, theirs) in [("vertices", "V"), ("edges", "E"), ("components", "C"), ("faces", "F_euler")] {
            assert_eq!(info[key], expected[theirs], "{map}: {key}");
        }
    }
    // The ring of Oregon touches itself at a vertex, which a polygon may not.
    let told = folder.dcel_on(&shared("O08-us-atlas/states-10m.json"), "info --drop-degenerate-rings");
    told.fails(2, "states-10m.json: states[38] \"Oregon\" polygon 0: face 237 passes vertex 7792 twice", "split it");
    // The two maps of counties are not planar, and no option makes them so; they are refused by name.
    for map in ["counties-10m", "counties-albers-10m"] {
        let path = shared(&format!("O08-us-atlas/{map}.json"));
        folder.dcel_on(&path, "info --full-check --drop-degenerate-rings").fails(2, &format!("{map}.json"), "");
    }
}

#[test]
#[cfg_attr(not(shared_data), ignore = "needs ../shared/data")]
fn surfaces_have_the_counts_of_others() {
    let folder = Folder::new();
    let mut refused = Vec::new();
    let mut counted = 0;
    for place in ["O11-pmp-small", "O13-trimesh-small"] {
        let expected = json(&shared(&format!("{place}/expected.json")));
        for (name, theirs) in expected.as_object().expect("files") {
            let path = shared(&format!("{place}/{name}"));
            let told = folder.dcel_on(&path, "info --json --surface");
            if theirs["oriented_manifold"] == false {
                assert_eq!(told.code, Some(2), "{name}: {told:?}");
                assert!(told.err.contains("face ") || told.err.contains("faces "), "{name}: {}", told.err);
                refused.push(name.clone());
                continue;
            }
            let info = told.json();
            // Theirs counts the one square of this file as two triangles.
            let cut = i64::from(name == "plane.ply");
            for (key, other, cut) in
                [("vertices", "V", 0), ("edges", "E", cut), ("faces", "F", cut), ("components", "components", 0)]
            {
                assert_eq!(info[key].as_i64(), theirs[other].as_i64().map(|n| n - cut), "{name}: {key}");
            }
            if !theirs["chi"].is_null() {
                assert_eq!(info["boundary_cycles"], theirs["boundary_loops"], "{name}");
                assert_eq!(info["euler"], theirs["chi"], "{name}");
                assert_eq!(info["genus"].as_f64(), theirs["genus_total"].as_f64(), "{name}");
            }
            assert_eq!((&info["mode"], &info["valid"]), (&"surface".into(), &true.into()), "{name}");
            counted += 1;
        }
    }
    assert_eq!(refused, ["joined_tetrahedra.obj", "notenoughindices.obj", "octagonal_pocket.ply"]);
    assert!(counted >= 20, "only {counted} files were counted");
}

#[test]
#[cfg_attr(not(shared_data), ignore = "needs ../shared/data")]
fn flat_files_are_planes_with_one_face_more() {
    let folder = Folder::new();
    let expected = json(&shared("O11-pmp-small/expected.json"));
    for name in ["L.off", "edge_onering.off", "vertex_onering.off"] {
        let info = folder.dcel_on(&shared(&format!("O11-pmp-small/{name}")), "info --json").json();
        let theirs = |key: &str| expected[name][key].as_i64().expect("a number");
        let ours = |key: &str| info[key].as_i64().expect("a number");
        assert_eq!(info["mode"], "plane", "{name}");
        assert_eq!(
            [ours("vertices"), ours("edges"), ours("faces"), ours("euler"), ours("boundary_cycles")],
            [theirs("V"), theirs("E"), theirs("F") + 1, theirs("chi") + 1, theirs("boundary_loops")],
            "{name}"
        );
    }
}
