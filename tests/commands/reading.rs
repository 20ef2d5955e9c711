//! The answers of the commands on small files.

use crate::shell::{CUBE, Folder, GARDEN, SQUARE, TRIANGLE, grid};
use serde_json::{Value, json};
use std::collections::BTreeSet;

/// Vertices, edges, faces, components, boundary cycles, V - E + F.
fn counts(info: &Value) -> [i64; 6] {
    ["vertices", "edges", "faces", "components", "boundary_cycles", "euler"]
        .map(|key| info[key].as_i64().unwrap_or_else(|| panic!("{key} in {info}")))
}

#[test]
fn info_counts_in_the_plane() {
    let folder = Folder::new();
    // An independent count of a grid: every pair of corners that follow each other, once.
    let text = grid(7);
    let edges: BTreeSet<[&str; 2]> = text
        .lines()
        .filter_map(|line| line.strip_prefix("f "))
        .flat_map(|face| {
            let c: Vec<&str> = face.split(' ').collect();
            [[c[0], c[1]], [c[1], c[2]], [c[2], c[0]]].map(|[a, b]| if a < b { [a, b] } else { [b, a] })
        })
        .collect();
    folder.write("grid.obj", &text);
    let info = folder.dcel("info grid.obj --json").json();
    assert_eq!(counts(&info), [64, edges.len() as i64, 98 + 1, 1, 1, 2]);
    assert_eq!((&info["mode"], &info["valid"], &info["half_edges"]), (&json!("plane"), &json!(true), &json!(322)));
    assert_eq!((&info["format"], &info["faces_by_sides"]), (&json!("obj"), &json!({"3": 98})));
    assert_eq!(info["degrees"], json!({"min": 2, "mean": 322.0 / 64.0, "max": 6}));
    assert_eq!(info["bounding_box"], json!({"min": [0.0, 0.0], "max": [7.0, 7.0]}));
    assert_eq!((&info["inner_components"], &info["hole_faces"], &info["genus"]), (&json!(1), &json!(0), &json!(0)));

    // f0, Garden, Shed, and the hole as a face; cycles: f0 has two, Garden two, the hole and Shed one each.
    let info = folder.dcel("info garden.json --json").json();
    assert_eq!(counts(&info), [4 + 4 + 3, 4 + 4 + 3, 4, 3, 3, 4]);
    assert_eq!(
        (&info["hole_faces"], &info["inner_components"], &info["inner_components_of_outer_face"]),
        (&json!(1), &json!(3), &json!(2))
    );
    assert_eq!((&info["names"], &info["named_faces"], &info["cycles"]), (&json!(2), &json!(2), &json!(6)));
    assert_eq!(info["faces_by_sides"], json!({"3": 1, "8": 1}), "the domain only");

    let info = folder.dcel("info triangle.dcel --json").json();
    assert_eq!(counts(&info), [4, 3, 2, 2, 1, 3]);
    assert_eq!(
        (&info["isolated_vertices"], &info["inner_components"], &info["valid"]),
        (&json!(1), &json!(2), &json!(true))
    );
}

#[test]
fn info_counts_on_surfaces() {
    let folder = Folder::new();
    let info = folder.dcel("info cube.off --json").json();
    assert_eq!((counts(&info), &info["mode"], &info["genus"]), ([8, 12, 6, 1, 0, 2], &json!("surface"), &json!(0)));
    assert_eq!(info["bounding_box"], json!({"min": [0.0, 0.0, 0.0], "max": [1.0, 1.0, 1.0]}));
    // Without its top: the border is a cycle and no face.
    folder.write("box.off", &CUBE.replace("8 6 12", "8 5 12").replace("4 4 5 6 7\n", ""));
    let info = folder.dcel("info box.off --json").json();
    assert_eq!((counts(&info), &info["faces_by_sides"]), ([8, 12, 5, 1, 1, 1], &json!({"4": 5})));
    // A flat file is a plane unless told otherwise; z is dropped on request.
    let info = folder.dcel("info square.obj --surface --json").json();
    assert_eq!((counts(&info), &info["mode"]), ([4, 5, 2, 1, 1, 1], &json!("surface")));
    folder.write("roof.obj", "v 0 0 0\nv 4 0 1\nv 4 3 0\nv 0 3 5\nf 1 2 3 4\n");
    assert_eq!(counts(&folder.dcel("info roof.obj --json").json())[2], 1);
    let dropped = folder.dcel("info roof.obj --plane --json");
    assert!(dropped.err.contains("the z of the points was dropped"), "{}", dropped.err);
    assert_eq!(counts(&dropped.json()), [4, 4, 2, 1, 1, 2]);
}

#[test]
fn info_on_a_broken_table_says_so() {
    let folder = Folder::new();
    folder.write("broken.dcel", &TRIANGLE.replace("next h2", "next h4"));
    let told = folder.dcel("info broken.dcel --json");
    assert!(told.err.contains("dcel validate"), "{}", told.err);
    assert_eq!(told.json()["valid"], json!(false));
    // The structure is right and the geometry is wrong: v3 lies outside.
    folder.write("outside.dcel", &TRIANGLE.replace("v3 2 1", "v3 9 9"));
    assert_eq!(folder.dcel("info outside.dcel --json").json()["valid"], json!(false));
    // No positions: the invariants of the structure are all there is.
    folder.write("bare.dcel", &TRIANGLE.replace("v3 2 1", "v3"));
    assert_eq!(folder.dcel("info bare.dcel --json").json()["valid"], json!(true));
    assert_eq!(folder.dcel("info triangle.dcel --json").json()["valid"], json!(true));
}

#[test]
fn info_as_text() {
    let folder = Folder::new();
    let text = folder.dcel("info garden.json").fine();
    let (counts, memory) = text.rsplit_once("  memory            ").expect("a line about memory");
    assert!(memory.ends_with(" a half-edge\n") && memory.contains(" bytes, "), "{memory}");
    assert_eq!(
        counts,
        "garden.json: plane, geojson, valid\n  vertices          11\n  edges             11 (22 half-edges)\n  \
         faces             4 (with the outer face, 1 of them a hole)\n  components        3\n  \
         euler             V - E + F = 4\n  boundary cycles   3\n  inner components  2 of the outer face, 1 other\n  \
         isolated          0 vertices\n  sides of faces    3 to 8, mean 5.50 (1 x 3, 1 x 8)\n  \
         degrees           2 to 2, mean 2.00\n  bounding box      (0, 0) to (22, 10)\n  names             2 on 2 faces\n"
    );
}

#[test]
fn validate_names_every_violation() {
    let folder = Folder::new();
    assert_eq!(folder.dcel("validate triangle.dcel").fine(), "triangle.dcel: valid\n");
    assert_eq!(folder.dcel("validate square.obj").fine(), "square.obj: valid\n");
    assert_eq!(folder.dcel("validate cube.off").fine(), "cube.off: valid\n");
    folder.write("broken.dcel", &TRIANGLE.replace("h1 origin v1", "h1 origin v0").replace("inner v3 ", ""));
    let told = folder.dcel("validate broken.dcel");
    let rules: Vec<&str> = told.out.lines().map(|line| line.split(':').next().unwrap_or("")).collect();
    assert_eq!((told.code, rules), (Some(1), vec!["D1", "D1", "I3"]), "{}", told.out);
    assert!(told.out.starts_with("D1: h0.next = h2, but h2.origin = v1 (expected v0,"), "{}", told.out);

    let told = folder.dcel("validate broken.dcel --json");
    let report: Value = serde_json::from_str(&told.out).expect("JSON");
    assert_eq!((told.code, &report["valid"], &report["mode"]), (Some(1), &json!(false), &json!("plane")));
    assert_eq!(report["violations"][0]["found"], json!("v1"));
    assert_eq!(report["violations"][0]["expected"], json!("v0"));
    assert_eq!(report["violations"].as_array().map(Vec::len), Some(3));
}

#[test]
fn validate_checks_the_whole_plane() {
    let folder = Folder::new();
    // Two triangles that share nothing and overlap: only the full check sees it.
    folder.write("overlap.obj", "v 0 0\nv 4 0\nv 0 4\nv -1 1\nv 1 1\nv -1 2\nf 1 2 3\nf 4 5 6\n");
    assert_eq!(counts(&folder.dcel("info overlap.obj --trust --json").json())[3], 2);
    folder.dcel("info overlap.obj").fails(2, "overlap.obj:7: G3: face 0 and face 1 cross at (0, ", "face 1: line 8");
    let old = folder.dcel("info square.obj --full-check");
    assert!(old.err.contains("note: --full-check is not needed") && old.code == Some(0), "{old:?}");
    let told = folder.dcel("validate overlap.obj");
    assert_eq!(told.code, Some(1), "{told:?}");
    assert!(told.out.starts_with("G3: overlap.obj:7: face 0 and face 1 cross at (0, "), "{}", told.out);
    // In a table, with its own numbers: f7 is the outer face, and the boundary of f1 runs clockwise.
    let turned = TRIANGLE.replace("f0", "f7").replace("v2 2 3", "v2 2 -3").replace("v3 2 1", "v3 2 -1");
    folder.write("turned.dcel", &turned);
    let told = folder.dcel("validate turned.dcel");
    assert_eq!(told.code, Some(1), "{told:?}");
    assert!(told.out.contains("G5: the boundary of f1, from h0 on"), "{}", told.out);
    assert!(
        told.out.contains("G6: the cycle of h1 surrounds a bounded region, so it cannot be an inner component of f7")
    );
}

#[test]
fn validate_tells_misfits_from_unreadable_files() {
    let folder = Folder::new();
    folder.write("twice.obj", &format!("{SQUARE}f 1 2 3\n"));
    let told = folder.dcel("validate twice.obj");
    assert_eq!(
        (told.code, told.out.as_str()),
        (Some(1), "INPUT: twice.obj:5: face 2 repeats face 0: leave one of them out (face 2: line 7)\n")
    );
    folder.dcel("info twice.obj").fails(2, "twice.obj:5: face 2 repeats face 0", "face 2: line 7");
    folder.write("syntax.obj", "v 0 0\nv 1 x\n");
    folder.dcel("validate syntax.obj").fails(2, "syntax.obj:2:5: `x` is not a number", "");
    // What cannot be checked is told.
    folder.write("bare.dcel", &TRIANGLE.replace("v3 2 1", "v3"));
    let told = folder.dcel("validate bare.dcel");
    assert_eq!((told.code, told.out.as_str()), (Some(0), "bare.dcel: valid\n"));
    assert!(told.err.contains("not checked: the invariants of the plane: v3 has no position"), "{}", told.err);
}

#[test]
fn the_table_of_laws_is_complete() {
    let folder = Folder::new();
    let text = folder.dcel("validate --rules").fine();
    let invariants = dcel_kit::topology::Rule::all().iter().chain(dcel_kit::plane::GEOMETRY_RULES);
    let ids: Vec<&str> = invariants.map(|rule| rule.id).collect();
    let printed: Vec<&str> =
        text.lines().filter(|l| !l.starts_with(' ')).filter_map(|l| l.split_whitespace().next()).collect();
    assert_eq!(printed, ids);
    assert_eq!(ids.len(), 29);
    let table = folder.dcel("validate --rules --json").json();
    assert_eq!((&table[5]["rule"], &table[5]["invariant"]), (&json!("N2"), &json!("h.next.prev = h")));
}

#[test]
fn walks_round_faces() {
    let folder = Folder::new();
    assert_eq!(
        folder.dcel("walk square.obj --face f1").fine(),
        "f1: 3 half-edges, 1 cycle\nadjacent faces (2): f0, f2\n\nboundary of f1\n  \
         h0  v0 (0, 0)  -> v1  twin h1  across f0\n  h2  v1 (4, 0)  -> v2  twin h3  across f0\n  \
         h4  v2 (4, 3)  -> v0  twin h5  across f2\n"
    );
    // All cycles, rings marked; the hole is a face; names across.
    let walk = folder.dcel("walk garden.json --face-name garden --json").json();
    assert_eq!((&walk["faces"][0]["face"], &walk["faces"][0]["name"]), (&json!("f1"), &json!("Garden")));
    let cycles = walk["faces"][0]["cycles"].as_array().expect("cycles");
    let shape: Vec<_> = cycles.iter().map(|c| (&c["inner"], c["half_edges"].as_array().map_or(0, Vec::len))).collect();
    assert_eq!(shape, [(&json!(false), 4), (&json!(true), 4)]);
    let corners: Vec<_> = cycles[1]["half_edges"].as_array().unwrap().iter().map(|h| h["position"].clone()).collect();
    let from = corners.iter().position(|p| *p == json!([2.0, 2.0])).expect("a corner of the hole");
    let clockwise = [[2.0, 2.0], [2.0, 4.0], [4.0, 4.0], [4.0, 2.0]];
    assert!((0..4).all(|i| corners[(from + i) % 4] == json!(clockwise[i])), "{corners:?}");
    assert_eq!(walk["adjacent_faces"], json!([{"face": "f0", "name": null}, {"face": "f3", "name": null}]));
    let hole = folder.dcel("walk garden.json --face f3").fine();
    assert!(hole.starts_with("f3, a hole: 4 half-edges, 1 cycle\nadjacent faces (1): f1 \"Garden\"\n"), "{hole}");
    let outer = folder.dcel("walk garden.json --face f0").fine();
    assert!(outer.starts_with("f0, the outer face: 7 half-edges, 2 cycles\n"), "{outer}");
    assert!(
        outer.contains("adjacent names (2): Garden, Shed\n") && outer.matches("\ninner component of f0\n").count() == 2
    );
    assert!(folder.dcel("walk triangle.dcel --face f1").fine().ends_with("\nisolated in f1\n  v3 (2, 1)\n"));
}

#[test]
fn parts_of_one_name_are_walked_together() {
    let folder = Folder::new();
    // From left to right: A, A, B.
    let square = |x: i32, name: &str| {
        let ring = format!("[[{x},0],[{},0],[{},1],[{x},1],[{x},0]]", x + 1, x + 1);
        format!(r#"{{"type":"Feature","id":"{name}","geometry":{{"type":"Polygon","coordinates":[{ring}]}}}}"#)
    };
    let features = [square(0, "A"), square(1, "A"), square(2, "B")].join(",");
    folder.write("row.json", &format!(r#"{{"type":"FeatureCollection","features":[{features}]}}"#));
    let whole = folder.dcel("walk row.json --face-name a --json").json();
    assert_eq!(whole["faces"].as_array().map(Vec::len), Some(2));
    assert_eq!(whole["adjacent_faces"], json!([{"face": "f0", "name": null}, {"face": "f3", "name": "B"}]));
    assert_eq!(whole["adjacent_names"], json!(["B"]));
    // The left part alone borders the other part, which is no other name.
    let left = folder.dcel("walk row.json --face f1 --json").json();
    assert_eq!(left["adjacent_faces"], json!([{"face": "f0", "name": null}, {"face": "f2", "name": "A"}]));
    assert_eq!(left["adjacent_names"], json!([]));
}

#[test]
fn walks_round_vertices_and_along_links() {
    let folder = Folder::new();
    assert_eq!(
        folder.dcel("walk square.obj --vertex v2").fine(),
        "v2 (4, 3): 3 outgoing half-edges\n  h3  -> v1 (4, 0)  twin h2  face f0\n  \
         h6  -> v3 (0, 3)  twin h7  face f2\n  h4  -> v0 (0, 0)  twin h5  face f1\n"
    );
    assert!(folder.dcel("walk triangle.dcel --vertex v3").fine().contains("isolated in f1 \"Ohio\"\n"));
    assert_eq!(
        folder.dcel("walk square.obj --half-edge h5 --json").json(),
        json!({
            "half_edge": "h5", "origin": "v0", "origin_position": [0.0, 0.0],
            "destination": "v2", "destination_position": [4.0, 3.0],
            "twin": "h4", "next": "h6", "prev": "h8", "face": "f2", "face_name": null, "edge": "e2",
        })
    );
    assert!(folder.dcel("walk cube.off --vertex v6").fine().starts_with("v6 (1, 1, 1): 3 outgoing half-edges\n"));
    // Broken pointers are followed as far as they lead.
    folder.write("open.dcel", &TRIANGLE.replace("next h4 prev h0", "next none prev h0"));
    assert!(folder.dcel("walk open.dcel --face f1").fine().contains("  the cycle does not close here\n"));
    folder.write("round.dcel", &TRIANGLE.replace("next h4 prev h0", "next h2 prev h0"));
    assert!(folder.dcel("walk round.dcel --face f1").fine().contains("  the cycle does not close here\n"));
    folder.write("star.dcel", &TRIANGLE.replace("next h2 prev h4", "next h2 prev none"));
    assert!(folder.dcel("walk star.dcel --vertex v0").fine().contains("the walk round v0 does not close here\n"));
    assert!(folder.dcel("walk open.dcel --half-edge h2").fine().contains("  next        none\n"));
}

#[test]
fn unknown_elements_are_refused_with_a_suggestion() {
    let folder = Folder::new();
    folder.dcel("walk square.obj --face f9").fails(
        2,
        "square.obj: there is no f9: there are 3 faces",
        "did you mean f2?",
    );
    folder.dcel("walk square.obj --vertex v4").fails(2, "there is no v4: there are 4 vertices", "did you mean v3?");
    folder.dcel("walk square.obj --half-edge h99").fails(
        2,
        "there is no h99: there are 10 half-edges",
        "did you mean h9?",
    );
    folder.dcel("walk garden.json --face-name Gardn").fails(2, "no face is named `Gardn`", "did you mean `Garden`?");
    folder.dcel("walk square.obj --face-name x").fails(2, "no face is named `x`", "the file names no face");
    folder.dcel("walk square.obj --face 3").fails(2, "`3` is not the name of a face", "for example f3");
    folder.dcel("walk square.obj --face f1 --vertex v1").fails(2, "cannot be used with", "");
    folder.dcel("walk square.obj").fails(2, "required", "");
}

#[test]
fn convert_goes_there_and_back() {
    let folder = Folder::new();
    for name in ["two.obj", "two.off", "two.ply", "two.geojson", "two.ele", "two.dcel"] {
        assert_eq!(folder.dcel(&format!("convert square.obj {name}")).fine(), "");
        let info = folder.dcel(&format!("info {name} --json")).json();
        assert_eq!(counts(&info), [4, 5, 3, 1, 1, 2], "{name}");
        assert_eq!(info["bounding_box"], json!({"min": [0.0, 0.0], "max": [4.0, 3.0]}), "{name}");
    }
    assert_eq!(folder.dcel("convert triangle.dcel - --to dcel").fine(), TRIANGLE);
    assert_eq!(folder.dcel("convert cube.off - --to off").fine(), CUBE.replace("8 6 12", "8 6 0"));
    assert_eq!(folder.dcel_with(SQUARE, "convert - - --to off").fine().lines().nth(1), Some("4 2 0"));
    assert!(folder.dcel("convert square.obj - --to tables").fine().contains("f1   | h0             | none"));
    assert_eq!(folder.dcel("convert garden.json g.dcel").code, Some(0));
    let again = folder.dcel("walk g.dcel --face-name Shed --json").json();
    assert_eq!(again["adjacent_faces"], json!([{"face": "f0", "name": null}]));
    // A broken structure goes through the kit's own text unchanged.
    let broken = TRIANGLE.replace("next h2", "next h4");
    assert_eq!(folder.dcel_with(&broken, "convert - - --to dcel").fine(), broken);
}

#[test]
fn convert_tells_losses_and_refuses_what_cannot_be_held() {
    let folder = Folder::new();
    folder.dcel("convert garden.json x.off").fails(
        2,
        "x.off: f1 has inner components, which off cannot hold",
        "dcel holds",
    );
    assert!(!folder.path("x.off").exists(), "a refused file was made");
    folder.write("shed.json", &GARDEN.replace(", [[2,2],[4,2],[4,4],[2,4],[2,2]]", ""));
    let told = folder.dcel("convert shed.json shed.off");
    assert!(told.err.contains("2 names of faces are lost: off has none"), "{told:?}");
    assert!(folder.dcel("convert garden.json g.geojson").err.contains("1 hole face is not written"));
    assert_eq!(folder.dcel("convert garden.json g.dcel").err, "");
    folder.write("tenth.obj", "v 0 0\nv 0.1 0\nv 0 1\nf 1 2 3\n");
    for target in ["t.stl", "-"] {
        let told = folder.command(&format!("convert tenth.obj {target} --to stl-binary")).output().expect("it starts");
        let err = String::from_utf8_lossy(&told.stderr).into_owned();
        assert!(told.status.success() && err.contains("1 point was rounded to single precision"), "{target}: {err}");
    }
    folder.dcel("convert cube.off cube.geojson").fails(2, "a surface in space", "try obj, off or ply");
    folder.dcel("convert square.obj x.svg").fails(2, "x.svg: the file name does not say", "--to: obj, off");
    folder.dcel("convert square.obj x.topojson").fails(2, "topojson is read, not written", "geojson");
    folder.dcel("convert square.obj -").fails(2, "<stdout>: the format to write is not known", "--to");
    folder.dcel("convert square.obj - --to triangle").fails(2, "two files", "path");
    folder.dcel("convert square.obj ./square.obj").fails(2, "this is the input itself", "another name");
    folder.dcel("convert square.obj t.ele").fine();
    folder.dcel("convert t.node t.ele").fails(2, "this is the input itself", "another name");
    assert_eq!(folder.read("square.obj"), SQUARE);
    folder.dcel("convert square.obj nowhere/x.off").fails(3, "nowhere/x.off: cannot be written", "directory first");
}

#[test]
fn compact_closes_the_gaps() {
    let folder = Folder::new();
    // Faces f0 and f3, half-edges from h4 on, vertices from v2 on.
    let mut spread = TRIANGLE.replace("f1", "f3").replace("v3 2 1 out none\n", "").replace(" inner v3", " inner none");
    for i in (0..6).rev() {
        spread = spread.replace(&format!("h{i} "), &format!("h{} ", i + 4));
        spread = spread.replace(&format!("h{i}\n"), &format!("h{}\n", i + 4));
    }
    folder.write("gaps.dcel", &spread);
    assert_eq!(folder.dcel("validate gaps.dcel").fine(), "gaps.dcel: valid\n", "{spread}");
    let text = folder.dcel("convert gaps.dcel - --to dcel --compact").fine();
    let ids: Vec<&str> = text.lines().skip(1).filter_map(|line| line.split(' ').next()).collect();
    assert_eq!(ids, ["v0", "v1", "v2", "h0", "h1", "h2", "h3", "h4", "h5", "f0", "f1"]);
    assert!(text.contains("name \"Ohio\""), "the name goes along: {text}");
    // A structure that is no subdivision cannot be renumbered.
    folder.write("broken.dcel", &TRIANGLE.replace("next h2", "next h4"));
    folder.dcel("convert broken.dcel - --to dcel --compact").fails(2, "broken.dcel: N", "");
}

#[test]
fn figures_are_drawn() {
    let folder = Folder::new();
    let svg = folder.dcel("figure garden.json").fine();
    let document = roxmltree::Document::parse(&svg).expect("SVG");
    let texts: Vec<_> = document.descendants().filter(|n| n.has_tag_name("text")).filter_map(|n| n.text()).collect();
    assert!(texts.contains(&"Garden") && texts.contains(&"Shed"), "{texts:?}");
    let title = |svg: &str| {
        let document = roxmltree::Document::parse(svg).expect("SVG");
        let title = document.descendants().find(|n| n.has_tag_name("title")).and_then(|n| n.text());
        (title.map(str::to_owned), document.root_element().attribute("width").map(str::to_owned))
    };
    assert_eq!(title(&svg).0.as_deref(), Some("garden"));
    assert_eq!(folder.dcel("figure square.obj -o two.svg --title Two --width 300 --id-prefix p").fine(), "");
    let svg = folder.read("two.svg");
    assert_eq!(title(&svg), (Some("Two".to_owned()), Some("300".to_owned())));
    assert!(svg.contains("id=\"p-h0\"") && svg.contains(">h0<") && svg.contains(">v0<") && svg.contains(">f1<"));
    let none = folder.dcel("figure square.obj --no-labels").fine();
    assert!(![">h0<", ">v0<", ">f1<"].iter().any(|label| none.contains(label)));
    let some = folder.dcel("figure square.obj --no-half-edge-labels --no-vertex-labels").fine();
    assert!(!some.contains(">h0<") && !some.contains(">v0<") && some.contains(">f1<"));
    assert!(folder.dcel("figure garden.json --face-labels ids").fine().contains(">f1<"));
    assert!(!folder.dcel("figure square.obj --detail edges").fine().contains("square-h0"));
    // A broken structure is drawn, and what is missing is told.
    folder.write("open.dcel", &TRIANGLE.replace("v2 2 3", "v2"));
    let told = folder.dcel("figure open.dcel");
    assert!(told.err.contains("v2") && told.out.contains("id=\"open-v1\""), "{told:?}");
}

#[test]
fn figures_that_cannot_be_drawn() {
    let folder = Folder::new();
    folder.dcel("figure square.obj -o two.gif").fails(2, "two.gif: a figure cannot be written", ".svg");
    folder.dcel("figure square.obj --html two.svg").fails(2, "two.svg: this would be HTML", ".html");
    folder.dcel("figure square.obj --scale 2").fails(2, "--scale is for pixels", ".png");
    if cfg!(not(feature = "png")) {
        let figure = folder.dcel("figure square.obj -o two.png");
        figure.fails(2, "two.png: this dcel was built without PNG", "cargo install --path . --features png");
        folder.write("one.dcels", "rectangle\n");
        let film = folder.dcel("script one.dcels --film two.png");
        assert!(film.code == Some(2) && film.err.contains("two.png: this dcel was built without PNG"), "{film:?}");
        let pdf = folder.dcel("figure square.obj -o two.pdf");
        pdf.fails(2, "two.pdf: this dcel was built without PDF", "rsvg-convert -f pdf");
        assert!(!folder.path("two.png").exists() && !folder.path("two.pdf").exists());
    }
    folder.dcel("figure cube.off").fails(2, "a surface in space", "--plane");
    folder.dcel("figure square.obj --width 20").fails(2, "100 to 20000", "");
    folder.dcel("figure square.obj -o nowhere/two.svg").fails(3, "nowhere/two.svg: cannot be written", "directory");
    folder.write("bare.dcel", "dcel 1\nv0 out none\nf0 outer half_edge none inner v0\n");
    folder.dcel("figure bare.dcel").fails(2, "the only vertex has no position", "");
}

/// Commands on solids ask for surfaces themselves; nothing is said of flags that nobody typed.
#[test]
fn solids_are_read_without_talk_and_useless_flags_are_named() {
    let folder = Folder::new();
    folder.dcel("convert cube.off cube.stl").fine();
    folder.dcel("convert cube.off cube.ply").fine();
    for call in [
        "info cube.off",
        "info cube.off --json",
        "info cube.stl",
        "info cube.ply",
        "info square.obj",
        "info cube.off --surface",
    ] {
        let told = folder.dcel(&format!("solid {call}"));
        assert_eq!((told.code, told.err.as_str()), (Some(0), ""), "{call}");
    }
    for (flag, why) in [
        ("--plane", "takes surfaces in space"),
        ("--mend", "for polygons in the plane"),
        ("--split-crossings", "for polygons in the plane"),
        ("--trust", "for polygons in the plane"),
        ("--object x", "only TopoJSON files have objects"),
    ] {
        let told = folder.dcel(&format!("solid info cube.off {flag}"));
        let name = flag.split(' ').next().unwrap();
        told.fails(2, &format!("cube.off: {name} cannot be used on off: "), &format!("leave {name} out"));
        assert!(told.err.contains(why), "{told:?}");
    }
}
