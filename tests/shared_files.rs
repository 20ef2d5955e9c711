//! The command on files made by others, against counts made by others.

#[path = "shell/mod.rs"]
mod shell;
#[path = "support/trials.rs"]
mod trials;

use serde_json::Value;
use shell::Folder;
use std::path::{Path, PathBuf};
use trials::trials;

fn shared(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/data").join(name)
}

fn json(path: &Path) -> Value {
    serde_json::from_str(&std::fs::read_to_string(path).expect("the file of answers")).expect("JSON")
}

const STATES: &str = "--y-down --drop-degenerate-rings";

fn states() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../figures/data/states-albers-10m.json")
}

fn the_states_have_the_counts_of_the_map() {
    let folder = Folder::new();
    let told = folder.dcel_on(&states(), &format!("info --json {STATES}"));
    assert!(told.err.contains("\"Delaware\" polygon 0 ring 0 has only 2 distinct points"), "{}", told.err);
    let info = told.json();
    for (key, value) in [("vertices", 6818), ("edges", 6872), ("faces", 198), ("components", 143), ("euler", 144)] {
        assert_eq!(info[key], value, "{key}");
    }
    assert_eq!((&info["mode"], &info["valid"], &info["format"]), (&"plane".into(), &true.into(), &"topojson".into()));
    assert_eq!((&info["names"], &info["inner_components"]), (&51.into(), &143.into()));
    folder.dcel_on(&states(), "info").fails(2, "\"Delaware\"", "--drop-degenerate-rings");
    assert_eq!(folder.dcel_on(&states(), &format!("validate {STATES}")).code, Some(0));
}

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

fn maps_have_the_counts_of_others() {
    let folder = Folder::new();
    let expected = json(&shared("O08-us-atlas/expected.json"));
    for map in ["nation-10m", "nation-albers-10m", "states-albers-10m"] {
        let expected = &expected[format!("{map}.json")];
        let path = shared(&format!("O08-us-atlas/{map}.json"));
        let info = folder.dcel_on(&path, "info --json --drop-degenerate-rings").json();
        for (key, theirs) in [("vertices", "V"), ("edges", "E"), ("components", "C"), ("faces", "F_euler")] {
            assert_eq!(info[key], expected[theirs], "{map}: {key}");
        }
    }
    // The ring of Oregon touches itself at a vertex, which a polygon may not.
    let told = folder.dcel_on(&shared("O08-us-atlas/states-10m.json"), "info --drop-degenerate-rings");
    told.fails(
        2,
        "states[38] \"Oregon\" polygon 0 ring 0 touches itself: it passes (-119.9993642903429, 41.9",
        "--mend",
    );
    // That map and the two of counties, which are not planar, are mended.
    for map in ["states-10m", "counties-10m", "counties-albers-10m"] {
        let path = shared(&format!("O08-us-atlas/{map}.json"));
        folder.dcel_on(&path, "info --drop-degenerate-rings").fails(2, &format!("{map}.json"), "--mend");
        let told = folder.dcel_on(&path, "info --json --mend");
        assert!(!told.err.contains("nothing to mend"), "{map}: {}", told.err);
        let info = told.json();
        assert_eq!(info["valid"].as_bool(), Some(true), "{map}");
        // All names are still there.
        let names = if map == "states-10m" { 56 } else { 1900 };
        assert!(info["named_faces"].as_u64() >= Some(names), "{map}: {info}");
    }
}

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

/// The closed rings of an area of O07: (outer or not, corners). A ring whose ways do not close is left open.
fn osm_rings(folder: &Path, area: &Value) -> Vec<(bool, Vec<[f64; 2]>)> {
    let text = std::fs::read_to_string(folder.join("data.osm")).expect("the data");
    let document = roxmltree::Document::parse(&text).expect("XML");
    let all = |name: &'static str| document.descendants().filter(move |node| node.has_tag_name(name));
    let number = |node: &roxmltree::Node<'_, '_>, key: &str| -> f64 { node.attribute(key).unwrap().parse().unwrap() };
    let id = area["from_id"].to_string();
    let nodes = |way: &str| -> Vec<String> {
        let way = all("way").find(|node| node.attribute("id") == Some(way));
        let list = way.iter().flat_map(|way| way.children().filter(|node| node.has_tag_name("nd")));
        list.map(|node| node.attribute("ref").unwrap().to_owned()).collect()
    };
    let ways: Vec<(bool, Vec<String>)> = if area["from_type"] == "way" {
        vec![(true, nodes(&id))]
    } else {
        let relation = all("relation").find(|node| node.attribute("id") == Some(&*id)).expect("the relation");
        let members = relation.children().filter(|node| node.attribute("type") == Some("way"));
        let way = |node: roxmltree::Node<'_, '_>| {
            (node.attribute("role") != Some("inner"), nodes(node.attribute("ref").unwrap()))
        };
        members.map(way).collect()
    };
    let mut rings = Vec::new();
    for outer in [true, false] {
        let mut pool: Vec<Vec<String>> = ways.iter().filter(|way| way.0 == outer).map(|way| way.1.clone()).collect();
        while !pool.is_empty() {
            let mut ring = pool.remove(0);
            while ring.first() != ring.last() {
                let fits = |way: &Vec<String>| way.first() == ring.last() || way.last() == ring.last();
                let Some(next) = pool.iter().position(fits) else { break };
                let mut way = pool.remove(next);
                if way.first() != ring.last() {
                    way.reverse();
                }
                ring.extend(way.drain(1..));
            }
            let at = |id: &String| {
                let node = all("node").find(|node| node.attribute("id") == Some(id)).expect("the node");
                [number(&node, "lon"), number(&node, "lat")]
            };
            rings.push((outer, ring.iter().map(at).collect()));
        }
    }
    rings
}

/// The area of a multipolygon of well-known text: every polygon is its first ring without the others.
fn wkt_area(text: &str) -> f64 {
    let twice = |ring: &str| -> f64 {
        let numbers: Vec<f64> = ring.split([',', ' ']).filter_map(|word| word.parse().ok()).collect();
        let point = |i: usize| [numbers[2 * i] - 7.0, numbers[2 * i + 1] - 1.0];
        (1..numbers.len() / 2).map(|i| point(i - 1)[0] * point(i)[1] - point(i - 1)[1] * point(i)[0]).sum::<f64>().abs()
    };
    let polygons = text.trim_start_matches("MULTIPOLYGON").split(")),((");
    let rings =
        |polygon: &str| polygon.split("),(").map(|ring| twice(ring.trim_matches(['(', ')']))).collect::<Vec<_>>();
    polygons.map(rings).map(|rings| (rings[0] - rings[1..].iter().sum::<f64>()) / 2.0).sum()
}

fn osm_areas_are_refused_or_mended_as_stated() {
    let folder = Folder::new();
    // Wrong by their tags, or because nodes are not shared; by their coordinates they are areas once corners inside
    // sides are inserted.
    let sound = ["747", "748", "754", "768", "771", "773", "780", "781", "782"];
    let (mut refused, mut compared) = (0, 0);
    let cases = std::fs::read_dir(shared("O07-osm-grid/7")).expect("the cases");
    for case in cases.map(|entry| entry.expect("an entry").path()) {
        let name = case.file_name().unwrap().to_string_lossy().into_owned();
        for area in json(&case.join("test.json"))["areas"]["default"].as_array().expect("areas") {
            let rings = osm_rings(&case, area);
            let outer = rings.iter().filter(|ring| ring.0).count();
            let lists: Vec<_> = rings.iter().map(|ring| &ring.1).collect();
            let (kind, coordinates) = match outer {
                1 => ("Polygon", serde_json::json!(lists)),
                _ => ("MultiPolygon", lists.iter().map(|ring| serde_json::json!([ring])).collect()),
            };
            let file = serde_json::json!({"type": kind, "coordinates": coordinates}).to_string();
            folder.write("area.json", &file);
            let told = folder.dcel("info area.json");
            let stated = area["wkt"].as_str().expect("WKT");
            if stated == "INVALID" {
                assert_eq!(told.code == Some(0), sound.contains(&&*name), "{name}: {told:?}");
                assert!(told.code == Some(0) || told.err.contains("--mend"), "{name}: {told:?}");
                refused += usize::from(told.code == Some(2));
            }
            let mended = folder.dcel("convert area.json area.dcel --mend");
            assert!(mended.code == Some(0) && mended.err.contains("note: "), "{name}: {mended:?}");
            assert_eq!(folder.dcel("validate area.dcel").fine(), "area.dcel: valid\n", "{name}");
            if stated != "INVALID" && outer == 1 {
                folder.write("far.obj", "v 90 90\nv 91 90\nv 91 91\nf 1 2 3\n");
                let union = folder.dcel("overlay area.dcel far.obj --operation difference --json").json();
                let (found, expected) = (union["region"]["area"].as_f64().expect("an area"), wkt_area(stated));
                assert!((found - expected).abs() < 1e-12, "{name}: {found}, stated {expected}");
                compared += 1;
            }
        }
    }
    assert_eq!((refused, compared >= 25), (21, true), "{compared} areas were compared");
}

trials! {
    the_states_have_the_counts_of_the_map;
    tennessee_has_eight_neighbours;
    maps_have_the_counts_of_others: SharedData;
    surfaces_have_the_counts_of_others: SharedData;
    flat_files_are_planes_with_one_face_more: SharedData;
    osm_areas_are_refused_or_mended_as_stated: SharedData;
}

fn main() {
    trials::run(trials())
}
