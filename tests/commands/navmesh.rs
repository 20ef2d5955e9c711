//! Promise: `dcel navmesh` tells what a map is, where points lie, how to get from one to another, and checks files of
//! queries; what it draws shows all of that.

use crate::shell::Folder;
use serde_json::json;

/// A folder with the map of rooms, and a mesh of two squares that touch in a double corner.
fn folder() -> Folder {
    let folder = Folder::new();
    folder.write("rooms.map", include_str!("../../figures/data/rooms.map"));
    folder.write("rooms.scen", include_str!("../../figures/data/rooms.scen"));
    let corner = "mesh\n2\n7 2\n0 0 2 0 -1\n1 0 2 0 -1\n1 1 4 0 -1 1 -1\n0 1 2 0 -1\n2 1 2 1 -1\n2 2 2 1 -1\n1 2 2 1 -1\n\
        4 0 1 2 3  -1 -1 -1 -1\n4 2 4 5 6  -1 -1 -1 -1\n";
    folder.write("corner.mesh", corner);
    folder
}

#[test]
fn info_counts_and_warns() {
    let folder = folder();
    let info = folder.dcel("navmesh info rooms.map --json").json();
    assert_eq!((&info["valid"], &info["format"], &info["area"]), (&json!(true), &json!("map"), &json!(311.0)));
    assert_eq!((&info["double_corners"], info["components"].as_array().map(Vec::len)), (&json!(2), Some(3)));
    let triangles = folder.dcel("navmesh info rooms.map --triangles --json").json();
    assert_eq!((&triangles["faces"], &triangles["area"]), (&triangles["triangles"], &json!(311.0)));
    let sum = |info: &serde_json::Value| {
        info["components"].as_array().into_iter().flatten().filter_map(serde_json::Value::as_u64).sum::<u64>()
    };
    assert_eq!(json!(sum(&info)), info["faces"]);
    let text = folder.dcel("navmesh info corner.mesh").fine();
    assert!(text.contains("components      2, of 1, 1 faces"), "{text}");
    assert!(text.contains("corner.mesh:6: warning: double corner: at vertex 2 2 holes touch"), "{text}");
}

#[test]
fn info_names_every_fault_with_its_place() {
    let folder = folder();
    folder
        .write("bad.obj", "v 0 0\nv 1 0\nv 2 0\nv 2 1\nv 1 1\nv 0 1\nv 2 2\nv 0 2\nf 1 2 5 6\nf 2 3 4 5\nf 6 4 7 8\n");
    let told = folder.dcel("navmesh info bad.obj");
    assert_eq!(told.code, Some(1), "{told:?}");
    assert!(told.out.contains("bad.obj:11: T-junction: vertex 4 lies on the side 5 -> 3 of face 2"), "{told:?}");
    assert!(told.out.ends_with("bad.obj: not a navmesh, 1 fault\n"), "{told:?}");
    // Clockwise and concave faces can be mended, and are then.
    folder.write("turned.obj", "v 0 0\nv 4 0\nv 4 4\nv 2 1\nv 0 4\nf 5 4 3 2 1\n");
    let report: serde_json::Value =
        serde_json::from_str(&folder.dcel("navmesh info turned.obj --json").out).expect("JSON");
    assert_eq!((&report["valid"], &report["faults"][0]["kind"]), (&json!(false), &json!("winding")));
    let told = folder.dcel("navmesh info turned.obj --orient");
    assert!(
        told.code == Some(1) && told.out.contains("turned.obj:6: not-convex: face 0 is not convex at vertex 3"),
        "{told:?}"
    );
    let mended = folder.dcel("navmesh info turned.obj --orient --triangles --json").json();
    assert_eq!((&mended["valid"], &mended["faces"], &mended["area"]), (&json!(true), &json!(3), &json!(10.0)));
}

#[test]
fn points_are_located_where_the_file_has_them() {
    let folder = folder();
    let found = folder.dcel("navmesh locate rooms.map 0.5 0.5 0 0 4 2 10.5 13.5 2.5 2.5 99 3 --json").json();
    let on: Vec<_> = found.as_array().into_iter().flatten().map(|spot| spot["on"].clone()).collect();
    assert_eq!(json!(on), json!(["face", "vertex", "edge", "face", "hole", "outer"]));
    assert_eq!(
        (&found[5]["point"], &found[5]["nearest"], &found[5]["distance"]),
        (&json!([99.0, 3.0]), &json!([26.0, 3.0]), &json!(73.0))
    );
    assert_eq!(found[0]["nearest"], json!(null), "nothing is moved");
    folder.dcel("navmesh locate rooms.map 1 2 3").fails(2, "3 numbers are no points", "x and y of each point");
    folder.dcel("navmesh locate rooms.map 1").fails(2, "1 number is no point", "x and y of each point");
    for bad in ["nan", "inf", "1,5"] {
        folder.dcel(&format!("navmesh locate rooms.map {bad} 2")).fails(2, "this is no finite number", "1.5");
        folder.dcel(&format!("navmesh path rooms.map 1 1 {bad} 2")).fails(2, "this is no finite number", "1.5");
    }
    // Below the x-axis of a mesh, negative numbers are numbers and no options.
    let text = folder.dcel("navmesh locate corner.mesh 0.5 -1").fine();
    assert!(text.contains("outside; the nearest place is (0.5, 0) in f1"), "{text}");
}

/// Blocked polygons side by side are one hole for the mesh; the command still says in which of them a point is.
#[test]
fn blocked_polygons_of_a_file_are_told_apart() {
    let folder = folder();
    let text = "mesh\n3\n5 4\n0 0\n0 8\n8 8\n8 0\n5 5\n0 3  4 1 5  -4 0 -2\n0 3  1 2 5  -1 0 -3\n\
                1 3  2 3 5  -2 0 4\n1 3  3 4 5  3 0 -1\n";
    folder.write("two.mesh", text);
    let found = folder.dcel("navmesh locate two.mesh 4 1 1 4 6 7 --json").json();
    let elements: Vec<_> = found.as_array().into_iter().flatten().map(|spot| spot["element"].clone()).collect();
    assert_eq!(json!(elements), json!(["f1", "f2", "f3"]));
    let told = folder.dcel("navmesh locate two.mesh 1 4").fine();
    assert!(told.contains("in the hole f2"), "{told}");
    folder.dcel("navmesh path two.mesh 1 4 7 6").fails(2, "it is in the hole f2", "");
}

#[test]
fn neighbours_are_listed_side_by_side() {
    let folder = folder();
    let sides = folder.dcel("navmesh neighbours rooms.map f1 --json").json();
    assert_eq!((&sides["face"], &sides["dead_end"]), (&json!("f1"), &json!(false)));
    let list = sides["sides"].as_array().expect("sides");
    let open: Vec<_> = list.iter().filter(|side| side["open"] == json!(true)).collect();
    assert!(!open.is_empty() && open.iter().all(|side| side["kind"] == json!("face")), "{sides}");
    let round: f64 = list.iter().filter_map(|side| side["length"].as_f64()).sum();
    assert!((round - 56.0).abs() < 1e-12, "two rows of 26 cells: {round}");
    let back = format!("navmesh neighbours rooms.map {} --json", open[0]["across"].as_str().expect("a face"));
    let other = folder.dcel(&back).json();
    let returns = other["sides"].as_array().into_iter().flatten().any(|side| side["across"] == json!("f1"));
    assert!(returns, "{other}");
    folder.dcel("navmesh neighbours rooms.map f0").fails(2, "f0 is no face of the mesh", "f1 to f");
}

#[test]
fn a_way_is_told_in_the_coordinates_of_the_file() {
    let folder = folder();
    let answer = folder.dcel("navmesh path rooms.map 1 1 22 12 --json").json();
    let route = &answer["routes"][0];
    assert_eq!((&answer["found"], &route["algorithm"]), (&json!(true), &json!("exact")));
    let length = route["length"].as_f64().expect("a length");
    assert!((length - 34.257_796_844).abs() < 1e-9, "{length}");
    let points = route["points"].as_array().expect("points");
    assert_eq!((&points[0], &points[points.len() - 1]), (&json!([1.0, 1.0]), &json!([22.0, 12.0])));
    let count = |what: &str| route[what].as_array().map_or(0, Vec::len);
    assert_eq!((count("faces"), count("corners")), (count("portals") + 1, count("points") - 2));
    // The ladder: no algorithm is shorter than the exact one.
    let all = folder.dcel("navmesh path rooms.map 21.5 5.5 0.5 4.5 --triangles --algorithm all --json").json();
    let ratios: Vec<f64> = all["routes"].as_array().into_iter().flatten().filter_map(|r| r["ratio"].as_f64()).collect();
    assert_eq!(ratios.len(), 6);
    assert!(ratios.iter().all(|&ratio| ratio >= 1.0) && ratios[0] > 1.01, "{ratios:?}");
    let table = folder.dcel("navmesh path rooms.map 21.5 5.5 0.5 4.5 --triangles --algorithm all").fine();
    assert!(table.lines().count() == 7 && table.contains("  exact      23.236853  1.000000"), "{table}");
    let bfs = folder.dcel("navmesh path rooms.map 21.5 5.5 0.5 4.5 --triangles --algorithm bfs").fine();
    assert!(bfs.starts_with("breadth: 25."), "{bfs}");
}

#[test]
fn wide_agents_keep_off_the_border_or_find_no_way() {
    let folder = folder();
    let length = |more: &str| {
        let answer = folder.dcel(&format!("navmesh path rooms.map 1 1 22 12 --json {more}")).json();
        answer["routes"][0]["length"].as_f64().expect("a length")
    };
    let (point, thin, wide) = (length(""), length("--radius 0"), length("--radius 0.25"));
    assert!(point.to_bits() == thin.to_bits() && wide > thin, "{point} {thin} {wide}");
    // Every algorithm keeps the radius, and none is shorter than the exact one.
    let told = folder.dcel("navmesh path rooms.map 1 1 22 12 --radius 0.4 --algorithm all --json").json();
    let routes = told["routes"].as_array().expect("five ways");
    let lengths: Vec<f64> = routes.iter().map(|route| route["length"].as_f64().expect("a length")).collect();
    let exact = lengths[lengths.len() - 1];
    assert!(lengths.len() >= 5 && lengths.iter().all(|&length| length >= exact * (1.0 - 1e-9)), "{lengths:?}");
    assert_eq!(told["radius"], 0.4);
    let told = folder.dcel("navmesh path rooms.map 1 1 22 12 --radius 0.4 -o wide.svg");
    assert_eq!(told.code, Some(0), "{told:?}");
    assert!(folder.read("wide.svg").contains("nearer to a border than the radius, 0.4"));
    // The agent fits at both ends, and not through what lies between.
    let told = folder.dcel("navmesh path rooms.map 13 5 16 13.5 --radius 1");
    assert!(told.code == Some(1) && told.out.starts_with("no path for a radius of 1: (13, 5) is in"), "{told:?}");
    folder.dcel("navmesh path rooms.map 0.2 1 22 12 --radius 0.4").fails(
        2,
        "nearer to a border than the radius",
        "0.4",
    );
    folder.dcel("navmesh path rooms.map 1 1 22 12 --radius 50").fails(2, "radius 50 fits nowhere", "smaller");
    folder.dcel("navmesh path rooms.map 1 1 22 12 --radius 50").fails(2, "on the map", "help: try a smaller one");
    folder.dcel("navmesh path rooms.map 1 1 2 2 --radius -1").fails(2, "an agent of radius -1", "0.5");
}

#[test]
fn no_way_is_proven_and_bad_ends_are_refused() {
    let folder = folder();
    let told = folder.dcel("navmesh path rooms.map 10 14 1 1 -o apart.svg");
    assert_eq!(told.code, Some(1), "{told:?}");
    assert!(told.out.starts_with("no path: (10, 14) is in component"), "{told:?}");
    assert!(told.out.contains("nearest point that can be reached: (9, 13)"), "{told:?}");
    let svg = folder.read("apart.svg");
    assert!(svg.contains("can be reached from the start") && svg.contains("leads to the goal"));
    let told = folder.dcel("navmesh path rooms.map 10 14 1 1 --json");
    let answer: serde_json::Value = serde_json::from_str(&told.out).expect("JSON");
    assert_eq!((&answer["found"], &answer["apart"]["start_faces"]), (&json!(false), &json!(1)));
    // At a double corner, and with a face that is elsewhere.
    let shortest = folder.dcel("navmesh path rooms.map 18 14 1 1");
    assert!(shortest.err.contains("the start (18, 14) is on several sides of a border, in f25, f28"), "{shortest:?}");
    assert!(shortest.err.contains("--start-face chooses"), "{shortest:?}");
    let chosen = folder.dcel("navmesh path rooms.map 18 14 1 1 --start-face f25");
    assert_eq!((chosen.code, &chosen.out), (Some(0), &shortest.out), "f25 is the nearer side: {chosen:?}");
    let lengths = ["f25", "f28"].map(|face| {
        let way = folder.dcel(&format!("navmesh path rooms.map 18 14 1 1 --start-face {face} --json")).json();
        way["routes"][0]["length"].as_f64().expect("a length")
    });
    assert!(lengths[0] < lengths[1], "{lengths:?}");
    // Distances from there count from the nearer of the sides; a line runs into that side in which it gets furthest.
    let told = folder.dcel("navmesh distances rooms.map 18 14 --json");
    assert!(told.err.contains("in f25, f28: the nearest of them counts; --start-face chooses one"), "{told:?}");
    let distances = |face: &str| {
        let more = if face.is_empty() { String::new() } else { format!(" --start-face {face}") };
        let answer = folder.dcel(&format!("navmesh distances rooms.map 18 14 --json{more}")).json();
        let rows = answer["vertices"].as_array().expect("rows").iter();
        let row = |row: &serde_json::Value| Some((row["vertex"].to_string(), row["distance"].as_f64()?));
        rows.filter_map(row).collect::<std::collections::BTreeMap<_, _>>()
    };
    let [both, one, other] = ["", "f25", "f28"].map(distances);
    assert!(one != other && both != one && both.len() == one.len(), "{both:?}");
    for (vertex, least) in &both {
        assert_eq!(least.to_bits(), one[vertex].min(other[vertex]).to_bits(), "{vertex}");
    }
    for (to, face, hit) in [("18 1", "f25", Some(3.0)), ("16 15.5", "f28", None)] {
        let told = folder.dcel(&format!("navmesh raycast rooms.map 18 14 {to} --json"));
        assert!(told.err.contains(&format!("in f25, f28: the line gets furthest in {face}; --start-face")), "{told:?}");
        assert_eq!(told.json()["hit"]["distance"].as_f64(), hit, "{to}");
        for side in ["f25", "f28"] {
            let answer =
                folder.dcel(&format!("navmesh raycast rooms.map 18 14 {to} --start-face {side} --json")).json();
            let expected = if side == face { hit } else { Some(0.0) };
            assert_eq!(answer["hit"]["distance"].as_f64(), expected, "{to} in {side}");
        }
    }
    folder.dcel("navmesh path rooms.map 18 14 1 1 --start-face f1").fails(2, "f1 is no free face", "--start-face out");
    folder.dcel("navmesh path rooms.map 18 14 1 1 --radius 0.2").fails(2, "nearer to a border", "the nearest place is");
    let here = folder.dcel("navmesh path rooms.map 1 1 1 1 --algorithm all --json").json();
    assert!(here["routes"].as_array().is_some_and(|ways| ways.iter().all(|way| way["length"] == 0.0)), "{here}");
    folder.dcel("navmesh scenario rooms.map .").fails(2, "it is a directory", "give a file in it");
    folder.dcel("navmesh path rooms.map 2.5 2.5 1 1").fails(
        2,
        "rooms.map: the start (2.5, 2.5) is not on the mesh: it is in the hole",
        "the nearest place is (2.5, 2) in f1",
    );
    // At a double corner the shorter way decides, or who says on which side one stands.
    let told = folder.dcel("navmesh path corner.mesh 2 2 1 1");
    assert!(told.code == Some(0) && told.out.contains("faces   f2\n"), "{told:?}");
    assert!(
        told.err
            .contains("the goal (1, 1) is on several sides of a border, in f1, f2: the shortest path is that of f2")
    );
    let way = folder.dcel("navmesh path corner.mesh 0 0 1 1 --goal-face f1 --json").json();
    assert_eq!(way["routes"][0]["length"], json!(2f64.sqrt()));
    assert_eq!(folder.dcel("navmesh path corner.mesh 0 0 1 1 --goal-face f2").code, Some(1));
    folder.dcel("navmesh path corner.mesh 0 0 1 1 --goal-face f9").fails(2, "f9 is no free face there", "");
}

#[test]
fn ends_off_the_mesh_are_moved_on_request_and_drawn_all_the_same() {
    let folder = folder();
    let path = "navmesh path rooms.map 2.5 2.5 1 1";
    folder.dcel(path).fails(2, "the start (2.5, 2.5) is not on the mesh", "--snap 0.5 moves the start there");
    folder.dcel(&format!("{path} --snap 0.49")).fails(2, "is not on the mesh", "0.5 away: more than --snap 0.49");
    folder.dcel(&format!("{path} --snap -1")).fails(2, "a distance of -1", "--snap 0.5");
    let told = folder.dcel(&format!("{path} --snap 0.5 --json"));
    assert!(told.err.contains("it is in the hole f32; moved by 0.5 to (2.5, 2) in f1"), "{told:?}");
    let answer = told.json();
    assert_eq!((&answer["start_moved"], &answer["goal_moved"]), (&json!(0.5), &json!(null)));
    assert_eq!((&answer["start"]["point"], &answer["found"]), (&json!([2.5, 2.0]), &json!(true)));
    // The picture shows both ends, and where the nearest places are; however far away they are.
    for goal in ["27 3", "1e300 3"] {
        let told = folder.dcel(&format!("navmesh path rooms.map 2.5 2.5 {goal} -o lost.svg"));
        assert_eq!(told.code, Some(2), "{told:?}");
        let svg = folder.read("lost.svg");
        assert!(svg.contains("start, off the mesh") && svg.contains("the nearest place on the mesh"), "{goal}");
        assert_eq!(svg.contains("goal, off the mesh"), goal == "27 3", "{goal}");
    }
    // And where distances are told from, and rays start.
    for command in ["distances rooms.map 2.5 2.5", "raycast rooms.map 2.5 2.5 1 1"] {
        folder.dcel(&format!("navmesh {command}")).fails(
            2,
            "(2.5, 2.5) is not on the mesh",
            "--snap 0.5 moves the start",
        );
        let told = folder.dcel(&format!("navmesh {command} --snap 0.5 --json"));
        assert!(told.err.contains("moved by 0.5 to (2.5, 2) in f1"), "{told:?}");
        let answer = told.json();
        assert_eq!((&answer["start"], &answer["start_moved"]), (&json!([2.5, 2.0]), &json!(0.5)), "{command}");
        let there = folder.dcel(&format!("navmesh {} --json", command.replace("2.5 2.5", "2.5 2"))).json();
        assert_eq!(there["start_moved"], json!(null), "{command}");
    }
    let linked = folder.dcel("navmesh path rooms.map 2.5 2.5 1 1 --snap 1 --link 5,1,9,1,1 --json").json();
    assert_eq!((&linked["start_moved"], &linked["goal_moved"]), (&json!(0.5), &json!(null)), "{linked}");
    assert_eq!(linked["start"]["point"], json!([2.5, 2.0]), "{linked}");
    let told = folder.dcel("navmesh locate rooms.map 1e300 3").fine();
    assert!(told.contains("the nearest place is (26, 3)"), "{told}");
    // Every end of a file of queries.
    folder.write("off.scen", "0 rooms.map 26 16 2.5 2.5 2.5 1 1\n0 rooms.map 26 16 1 1 27 1 25\n");
    let told = folder.dcel("navmesh scenario rooms.map off.scen");
    assert!(
        told.code == Some(1)
            && told.out.contains(
                "off.scen:1: no path, and 1 is stated: the start (2.5, 2.5) is not on the mesh: it is in the hole"
            ),
        "{told:?}"
    );
    assert!(told.err.contains("help: 2 queries start or end off the mesh: --snap 0.5 moves"), "{told:?}");
    let told = folder.dcel("navmesh scenario rooms.map off.scen --snap 1").fine();
    assert!(told.contains("2 starts and goals were off the mesh and moved onto it, by 1 at most"), "{told}");
    assert!(told.ends_with("\n2 of 2 optimal\n"), "{told}");
}

/// Polygons of a format without numbers for vertices.
#[test]
fn info_names_polygons_by_what_the_file_calls_them() {
    let folder = folder();
    let feature = |name: &str, ring: &str| {
        format!(
            "{{\"type\":\"Feature\",\"properties\":{{\"name\":\"{name}\"}},\
             \"geometry\":{{\"type\":\"Polygon\",\"coordinates\":[[{ring}]]}}}}"
        )
    };
    let file =
        |features: &[String]| format!("{{\"type\":\"FeatureCollection\",\"features\":[\n{}\n]}}", features.join(",\n"));
    let hall = feature("hall", "[0,0],[4,0],[4,4],[0,4],[0,0]");
    let bent = feature("bent", "[4,0],[8,0],[8,4],[6,1],[4,0]");
    let over = feature("over", "[3,3],[3.5,3],[3.5,6],[3,6],[3,3]");
    folder.write("bad.geojson", &file(&[hall.clone(), bent, over]));
    let told = folder.dcel("navmesh info bad.geojson");
    assert_eq!(told.code, Some(1), "{told:?}");
    let lines: Vec<&str> = told.out.lines().collect();
    let bent = "bad.geojson:3:92: features[1] \"bent\" polygon 0 ring 0: not-convex: features[1] \"bent\" polygon 0 is not \
                convex at (6, 1): split it there, or triangulate it";
    assert_eq!(lines[0], bent);
    assert!(lines[1].starts_with("bad.geojson:2:92: features[0] \"hall\" polygon 0 ring 0: overlap: "), "{told:?}");
    assert!(lines[1].contains("features[0] \"hall\" polygon 0 and features[2] \"over\" polygon 0 overlap"), "{told:?}");
    assert!(lines[1].contains("their sides (4, 4) -> (0, 4) and "), "{told:?}");
    assert_eq!(told.err.matches("help: --triangles cuts faces up").count(), 1, "{told:?}");
    assert_eq!(told.err.matches("help: --mend cuts the polygons where they meet").count(), 1, "{told:?}");
    // Polygons that touch inside a side are valid ones: the corner is put in, with a note, as for a path.
    let room = feature("room", "[4,1],[6,1],[6,3],[4,3],[4,1]");
    folder.write("touch.geojson", &file(&[hall, room]));
    let told = folder.dcel("navmesh info touch.geojson");
    assert_eq!(told.code, Some(0), "{told:?}");
    assert!(told.out.contains("portals         1"), "{told:?}");
    assert!(told.err.contains("2 corners were inserted where vertices lie inside sides"), "{told:?}");
    assert!(folder.dcel("navmesh path touch.geojson 1 1 5 2").fine().contains("through 2 faces"));
    // A gap of a millimetre in a hall of eight metres is told by its places.
    let other = feature("other", "[4.001,0],[8,0],[8,4],[4.001,4],[4.001,0]");
    folder.write("gap.geojson", &file(&[feature("hall", "[0,0],[4,0],[4,4],[0,4],[0,0]"), other]));
    let told = folder.dcel("navmesh path gap.geojson 1 1 7 1");
    assert!(told.err.contains("(4, 0) and (4.001, 0) are 1.00e-3 apart"), "{told:?}");
    let told = folder.dcel("navmesh path gap.geojson 1 1 7 1 --weld 0.0011");
    assert_eq!(told.code, Some(0), "{told:?}");
}

#[test]
fn scenarios_are_counted_and_failures_named() {
    let folder = folder();
    for more in ["", " --triangles", " --face-by-face", " --triangles --face-by-face"] {
        let text = folder.dcel(&format!("navmesh scenario rooms.map rooms.scen{more}")).fine();
        assert!(text.ends_with("\n24 of 24 optimal\n"), "{text}");
    }
    let told = folder.dcel("navmesh scenario rooms.map rooms.scen --merged");
    assert!(told.code == Some(0) && told.err.contains("--merged is not needed any more"), "{told:?}");
    let entered = [" --face-by-face", ""].map(|more| {
        let told = folder.dcel(&format!("navmesh scenario rooms.map rooms.scen --triangles --json{more}")).fine();
        let report: serde_json::Value = serde_json::from_str(&told).expect("JSON");
        report["expansions"].as_u64().expect("a number")
    });
    assert!(entered[1] * 2 < entered[0], "merged faces save less than half: {entered:?}");
    let [plain, prepared] = [" --face-by-face", ""].map(|more| {
        folder
                .dcel(&format!("navmesh path rooms.map 1 1 22 12 --triangles --algorithm breadth --json{more}"))
                .json()["routes"][0]
                .clone()
    });
    let count = |route: &serde_json::Value| route["faces"].as_array().map(Vec::len);
    assert!(count(&plain).is_some() && count(&plain) == count(&prepared), "{plain} {prepared}");
    let work = |route: &serde_json::Value| route["expansions"].as_u64().expect("a number");
    assert!(work(&prepared) * 2 < work(&plain), "{plain} {prepared}");
    let wrong = include_str!("../../figures/data/rooms.scen").replacen("34.257796844", "34.257796944", 1);
    folder.write("wrong.scen", &wrong);
    let told = folder.dcel("navmesh scenario rooms.map wrong.scen");
    assert_eq!(told.code, Some(1), "{told:?}");
    let mut lines = told.out.lines();
    assert!(lines.next().is_some_and(|line| line.starts_with("stated lengths: Euclidean: ")), "{told:?}");
    assert!(lines.next().is_some_and(|line| line.starts_with("wrong.scen:2: 34.2577968")), "{told:?}");
    assert!(told.out.ends_with("\n23 of 24 optimal\n"), "{told:?}");
    assert_eq!(folder.dcel("navmesh scenario rooms.map wrong.scen --tolerance 1e-8").code, Some(0));
    let told = folder.dcel("navmesh scenario rooms.map rooms.scen --triangles --algorithm bfs --json");
    let report: serde_json::Value = serde_json::from_str(&told.out).expect("JSON");
    assert!(told.code == Some(1) && report["mean_ratio"].as_f64() > Some(1.01), "{report}");
    assert_eq!((&report["optimum"], &report["queries"]), (&json!("euclidean"), &json!(24)));
    // The lengths of shortest paths tell what numbers alone cannot: that most are of neither kind, and by how much.
    let times = |factor: f64| {
        let scale = |line: &str| match line.rsplit_once('\t') {
            Some((query, length)) => {
                let length: f64 = length.parse().expect("a length");
                format!("{query}\t{:.9}\n", length * if length > 0.0 { factor } else { 1.0 })
            }
            None => format!("{line}\n"),
        };
        let text: String = include_str!("../../figures/data/rooms.scen").lines().map(scale).collect();
        folder.write("times.scen", &text);
        folder.dcel("navmesh scenario rooms.map times.scen")
    };
    for (factor, said) in [(1.1, "1.1"), (1.0001, "1.0001"), (0.9999, "0.9999")] {
        let told = times(factor);
        assert_eq!(told.code, Some(1), "{told:?}");
        let first = told.out.lines().next().unwrap_or_default();
        let said = format!("22 of 22 lengths are wrong, {said} times the shortest");
        let nearly = "stated lengths: neither octile nor Euclidean on this map, but nearly Euclidean: ";
        assert_eq!(first, format!("{nearly}{said}"), "{told:?}");
        let told = folder.dcel("navmesh scenario rooms.map times.scen --json");
        let report: serde_json::Value = serde_json::from_str(&told.out).expect("JSON");
        let neither = &report["lengths"]["neither"];
        assert_eq!((&neither["wrong"], &neither["alike"]), (&json!(22), &json!(22)), "{report}");
        assert!(neither["factor"].as_f64().is_some_and(|found| (found - factor).abs() < 1e-8), "{report}");
    }
    // Nothing of the kind is said of the paths of another algorithm, and of what the call says the lengths are.
    for more in ["--triangles --algorithm bfs", "--optimum euclidean"] {
        let told = folder.dcel(&format!("navmesh scenario rooms.map times.scen {more}"));
        assert!(told.code == Some(1) && !told.out.contains("on this map"), "{told:?}");
    }
    assert_eq!(folder.dcel("navmesh scenario rooms.map rooms.scen --json").json()["lengths"]["neither"], json!(null));
    folder.write("manhattan.scen", "0 hall.map 9 9 0 0 9 5 14\n0 hall.map 9 9 1 2 8 3 8\n0 hall.map 9 9 3 3 5 9 8\n");
    folder.write("hall.map", &format!("type octile\nheight 9\nwidth 9\nmap\n{}", ".........\n".repeat(9)));
    let told = folder.dcel("navmesh scenario hall.map manhattan.scen").fine();
    assert!(told.lines().next().is_some_and(|line| line.ends_with("(Manhattan): as upper bounds only")), "{told}");
    let report = folder.dcel("navmesh scenario hall.map manhattan.scen --json").json();
    assert_eq!(report["lengths"]["straight_steps"], json!(true));
    // Costs from cell to cell are bounds, and -1 is a refusal.
    folder.write(
        "corner.scen",
        "0 corner.mesh 2 2 0 0 1 0 1\n0 corner.mesh 2 2 0 0 2 2 -1\n0 other.mesh 2 2 1 1 0 0 -1\n",
    );
    let told = folder.dcel("navmesh scenario corner.mesh corner.scen");
    assert!(told.err.contains("corner.scen:3: this query is about other.mesh, not corner.mesh"), "{told:?}");
    // Sizes are in cells, which a mesh does not have; a grid map has, and a scenario of another size is not scaled.
    assert!(!told.err.contains("cells"), "{told:?}");
    let rooms = include_str!("../../figures/data/rooms.scen");
    let size = rooms.lines().nth(1).map(|line| line.split_whitespace().skip(2).take(2).collect::<Vec<_>>().join("\t"));
    let size = size.expect("a query");
    folder.write("scaled.scen", &rooms.replacen(&size, "512\t512", 2).replacen("512\t512", &size, 1));
    let scaled = folder.dcel("navmesh scenario rooms.map scaled.scen");
    assert!(
        scaled.err.contains("warning: scaled.scen:3: this query is about a map of 512 x 512 cells, and"),
        "{scaled:?}"
    );
    assert!(scaled.code == Some(0) && !folder.dcel("navmesh scenario rooms.map rooms.scen").err.contains("cells"));
    // One step straight on is the same by both readings.
    assert!(told.fine().ends_with("3 of 3 optimal\n"));
    folder.dcel("navmesh scenario rooms.map rooms.map").fails(2, "rooms.map:1:1: expected bucket, map", "nine words");
    folder.dcel("navmesh scenario rooms.map none.scen").fails(2, "none.scen: cannot be read", "check the name");
    folder.dcel("navmesh scenario rooms.map rooms.scen --algorithm all").fails(
        2,
        "checked with one algorithm",
        "--algorithm closest",
    );
}

#[test]
fn figures_show_what_they_are_about() {
    let folder = folder();
    let draw = |arguments: &str, words: &[&str]| {
        let told = folder.dcel(&format!("navmesh {arguments} -o out.svg"));
        assert!(matches!(told.code, Some(0)), "{arguments}: {told:?}");
        let svg = folder.read("out.svg");
        roxmltree::Document::parse(&svg).unwrap_or_else(|error| panic!("{arguments}: {error}"));
        words.iter().for_each(|word| assert!(svg.contains(word), "{arguments}: {word}"));
        folder.dcel(&format!("navmesh {arguments} -o again.svg"));
        assert_eq!(svg, folder.read("again.svg"), "{arguments}: the same bytes");
    };
    draw("info rooms.map", &[">rooms</title>", "rooms-f1"]);
    draw("info rooms.map --draw dual", &["neighbours", "to a dead end"]);
    draw("info rooms.map --draw dead-ends", &["the core: searches look here", "the way out of a dead end"]);
    let ends = "rooms.map 21.5 5.5 0.5 4.5 --triangles";
    draw(&format!("path {ends}"), &["portal: its left endpoint a square", "a corner of the path", "the corridor"]);
    draw(&format!("path {ends} --draw funnel"), &["the apex", "left chain of the funnel", "the goal"]);
    draw(&format!("path {ends} --draw cones"), &["what is seen from the root of a cone"]);
    draw(&format!("path {ends} --algorithm all"), &["exact: 23.2369", "x the shortest", "how much longer"]);
    folder.dcel("navmesh path rooms.map 1 1 2 1 --draw cones --algorithm bfs -o x.svg").fails(
        2,
        "only the exact search has cones",
        "",
    );
    folder.dcel("navmesh path rooms.map 1 1 2 1 --draw funnel --algorithm all -o x.svg").fails(
        2,
        "a funnel is drawn of one path",
        "",
    );
    folder.dcel("navmesh path rooms.map 1 1 2 1 -o rooms.map").fails(2, "this is the input itself", "another name");
    folder.dcel("navmesh path rooms.map 1 1 2 1 --draw cones").fails(2, "required arguments", "--output");
}

#[test]
fn floors_in_space_say_which_axis_points_up() {
    let folder = folder();
    // Two triangles that are not level; z grows towards the reader, y upwards.
    folder.write("floor.obj", "v 0 1 0\nv 4 2 0\nv 4 1 -3\nv 0 1 -3\nf 1 2 3\nf 1 3 4\n");
    folder.dcel("navmesh path floor.obj 0 0 4 -3").fails(2, "floor.obj: this is a surface in space", "--up y");
    let answer = folder.dcel("navmesh path floor.obj --up y 0 0 4 -3 --json").json();
    // Along the edge that both triangles have, which is level.
    assert_eq!((&answer["routes"][0]["length"], &answer["goal"]["point"]), (&json!(5.0), &json!([4.0, 1.0, -3.0])));
    folder.dcel("navmesh path floor.obj --up y 0 0 4 3").fails(2, "the goal (4, 3) is not on the surface", "--snap 3");
    // A level floor is a map of the plane.
    folder.write("level.obj", "v 0 1 0\nv 4 1 0\nv 4 1 -3\nv 0 1 -3\nf 1 2 3\nf 1 3 4\n");
    let answer = folder.dcel("navmesh path level.obj --up y 0 0 4 -3 --json").json();
    assert_eq!((&answer["routes"][0]["length"], &answer["goal"]["point"]), (&json!(5.0), &json!([4.0, -3.0])));
}

#[test]
fn grid_maps_are_files_like_any_other() {
    let folder = folder();
    let info = folder.dcel("info rooms.map --json").json();
    assert_eq!((&info["format"], &info["valid"]), (&json!("map"), &json!(true)));
    folder.dcel("convert rooms.map rooms.mesh").fine();
    let mesh = folder.dcel("navmesh info rooms.mesh --json").json();
    let map = folder.dcel("navmesh info rooms.map --json").json();
    for what in [
        "faces",
        "vertices",
        "portals",
        "components",
        "dead_ends",
        "junctions",
        "reduced_corridors",
        "area",
        "double_corners",
    ] {
        assert_eq!(mesh[what], map[what], "{what}");
    }
    folder.dcel("navmesh info square.dcel").fails(2, "square.dcel: cannot be read", "");
    folder.dcel("convert square.obj square.map").fails(2, "map is read, not written", "");
}

#[test]
fn walls_obstacles_and_rays_come_from_the_command_line() {
    let folder = folder();
    // In a .map y points down, of the corners of an obstacle, too, and they may run either way.
    let length = |flags: &str| {
        let answer = folder.dcel(&format!("navmesh path rooms.map 1 1 9 1 --json {flags}")).json();
        answer["routes"][0]["length"].as_f64().expect("a length")
    };
    assert_eq!(length("").to_bits(), 8.0f64.to_bits());
    let around = length("--wall 5,0,5,1.5");
    assert!((around - 2.0 * 4.0f64.hypot(0.5)).abs() < 1e-12, "{around}");
    for corners in ["4,0,6,0,5,1.5", "4,0,5,1.5,6,0"] {
        let around = length(&format!("--obstacle {corners}"));
        assert!((around - 2.0 * 4.0f64.hypot(0.5)).abs() < 1e-12, "{corners}: {around}");
    }
    // Corners nearly on one line are put in the right order exactly.
    folder.write("hall.obj", "v 0 0\nv 20 0\nv 20 20\nv 0 20\nf 1 2 3 4\n");
    for thin in [
        "1.5,6.3,7.7,8.3,5.84,7.7",
        "5.84,7.7,7.7,8.3,1.5,6.3",
        "2.3,11.4,17.173878731147397,5.3,6.762163619344219,9.57",
    ] {
        folder.dcel(&format!("navmesh info hall.obj --obstacle {thin}")).fine();
    }
    folder.dcel("navmesh path rooms.map 1 1 9 1 --wall 5,0,5").fails(2, "3 numbers are no points", "");
    folder.dcel("navmesh path rooms.map 1 1 9 1 --wall 5,0,5,1,6,1").fails(2, "a wall has two ends", "");
    folder.dcel("navmesh path rooms.map 1 1 9 1 --obstacle 5,0,5,1").fails(2, "three corners or more", "");
    folder.dcel("navmesh path rooms.map 1 1 9 1 --wall 5,0,5,0").fails(2, "rooms.map: --wall 5,0,5,0: side 0", "");
    // In the coordinates of the file, where y points down.
    let what = "side 0 of the wall has no length: both its ends are (5, 1)";
    folder.dcel("navmesh path rooms.map 1 1 9 1 --wall 5,1,5,1").fails(2, what, "help: give two different ends");
    let what = "side 1 of the obstacle has no length: both its ends are (4, 1)";
    folder.dcel("navmesh path rooms.map 1 1 9 1 --obstacle 3,1,4,1,4,1,3,0").fails(2, what, "help: give the corners");
    let what = "the obstacle is no simple polygon: its corners lie on one line";
    folder.dcel("navmesh path rooms.map 1 1 9 1 --obstacle 3,1,4,1,5,1").fails(
        2,
        what,
        "help: give corners round an area",
    );
    let bow = folder.dcel("navmesh path rooms.map 1 1 9 1 --obstacle 13,1,15,1,13,2,15,2");
    bow.fails(2, "the obstacle is no simple polygon: its side (", "in order");
    assert!(bow.err.contains("(15, 1)") && bow.err.contains("(13, 2)") && !bow.err.contains("-2)"), "{bow:?}");
    let crossing = folder.dcel("navmesh info rooms.map --obstacle 3,0,4,1,4,0,3,1");
    crossing.fails(2, "--obstacle 3,0,4,1,4,0,3,1: the obstacle is no simple polygon", "in order");
    folder.dcel("navmesh path rooms.map 1 1 9 1 --tolerance 0.1").fails(2, "required arguments", "");
    folder.dcel("navmesh path rooms.map 1 1 9 1 --radius 0.4 --tolerance 7").fails(2, "a tolerance of 7", "");

    let clear = folder.dcel("navmesh raycast rooms.map 1 1 9 1 --json").json();
    assert_eq!((&clear["clear"], &clear["hit"]), (&json!(true), &json!(null)));
    let hit = folder.dcel("navmesh raycast rooms.map 1 1 9 1 --wall 5,0,5,1.5 --json -o ray.svg").json();
    assert_eq!((&hit["hit"]["point"], &hit["hit"]["distance"]), (&json!([5.0, 1.0]), &json!(4.0)));
    assert!(folder.read("ray.svg").contains("the side that is hit"));
    let told = folder.dcel("navmesh raycast rooms.map 1 1 9 1 --wall 5,0,5,1.5").fine();
    assert!(told.starts_with("hit: h") && told.contains("at (5, 1), 4 away"), "{told}");
    folder.dcel("navmesh raycast rooms.map 3 2.5 9 1").fails(2, "the start (3, 2.5) is not on the mesh", "nearest");
    folder.dcel("navmesh raycast rooms.map 1 1 9").fails(2, "", "");
}

#[test]
fn costs_links_distances_and_random_points_come_from_the_command_line() {
    let folder = folder();
    // Eight squares round a hole: below is nearer, unless it is dear. What is told is the length.
    let corners = (0..16).map(|i| format!("v {} {} 0\n", i % 4, i / 4));
    let squares = [0, 1, 2, 4, 6, 8, 9, 10].map(|i| {
        let corner = i + 1;
        format!("f {} {} {} {}\n", corner, corner + 1, corner + 5, corner + 4)
    });
    folder.write("ring.obj", &(corners.collect::<String>() + &squares.concat()));
    let through = |flags: &str| {
        let answer =
            folder.dcel(&format!("navmesh path ring.obj 0.5 1.4 2.5 1.4 --algorithm closest --json {flags}")).json();
        answer["routes"][0]["faces"]
            .as_array()
            .expect("faces")
            .iter()
            .map(|f| f.as_str().expect("a face").to_owned())
            .collect::<Vec<_>>()
    };
    assert_eq!(through(""), ["f4", "f1", "f2", "f3", "f5"]);
    assert_eq!(through("--cost f1-f3=9"), ["f4", "f6", "f7", "f8", "f5"]);
    assert_eq!(through("--cost f1,f3=9 --cost f6-f8=20"), ["f4", "f1", "f2", "f3", "f5"]);
    let path = "navmesh path rooms.map 1 1 22 12";
    folder.dcel(&format!("{path} --cost f1=3")).fails(
        2,
        "--cost cannot be used with --algorithm exact: exact finds the shortest path, whatever faces cost",
        "a quicker rule, for example --algorithm closest",
    );
    folder.dcel(&format!("{path} --algorithm bfs --cost f1=3")).fails(
        2,
        "--cost cannot be used with --algorithm bfs: bfs counts faces, whatever they cost",
        "a rule that counts lengths, for example --algorithm closest",
    );
    folder.dcel(&format!("{path} --algorithm closest --cost f9999=3")).fails(2, "f9999 is no face", "locate");
    folder.dcel(&format!("{path} --algorithm closest --cost f1")).fails(2, "write it like f3=2.5", "");
    folder.dcel(&format!("{path} --algorithm closest --cost f1=-1")).fails(2, "a cost is 0 or more", "");

    let linked = folder.dcel(&format!("{path} --link 2,1,22,11,0.5 --json -o link.svg")).json();
    assert_eq!((&linked["cost"], &linked["links"]), (&json!(2.5), &json!([0])));
    assert_eq!(linked["legs"][1]["points"], json!([[22.0, 11.0], [22.0, 12.0]]));
    assert!(folder.read("link.svg").contains("a link of the path"));
    let told = folder.dcel(&format!("{path} --link 2,1,22,11,0.5")).fine();
    assert!(told.starts_with("exact: 2.5, over 1 link\n") && told.contains("(2, 1) -> (22, 11), costs 0.5"), "{told}");
    folder.dcel(&format!("{path} --link 2,1,22,11,99")).fine();
    folder.dcel(&format!("{path} --link 3,2.5,22,11,1")).fails(2, "--link: its start (3, 2.5) is not on the mesh", "");
    folder.dcel(&format!("{path} --link 2,1,22,11")).fails(2, "give five numbers", "");
    folder.dcel(&format!("{path} --link 2,1,22,11,1 --algorithm all")).fails(2, "--algorithm all", "one algorithm");

    let near = folder.dcel("navmesh distances rooms.map 0 0 --limit 8 --json -o reach.svg").json();
    let far = folder.dcel("navmesh distances rooms.map 0 0 --json").json();
    let rows = |answer: &serde_json::Value| answer["vertices"].as_array().expect("rows").len();
    assert!(rows(&near) > 0 && rows(&near) < rows(&far), "{} and {}", rows(&near), rows(&far));
    // A face counts if all its corners are within the limit: that of the start need not be one.
    let none = folder.dcel("navmesh distances rooms.map 1 1 --limit 1 --json").json();
    assert_eq!((&none["vertices"], &none["faces"]), (&json!([]), &json!([])));
    let help = folder.dcel("navmesh distances --help").fine();
    assert!(
        help.split_whitespace().collect::<Vec<_>>().join(" ").contains("all of whose corners can be reached"),
        "{help}"
    );
    let first = &near["vertices"][0];
    assert_eq!((&first["point"], &first["distance"]), (&json!([0.0, 0.0]), &json!(0.0)));
    assert!(folder.read("reach.svg").contains("how far it is"));
    folder.dcel("navmesh distances rooms.map 3 2.5").fails(2, "the start (3, 2.5) is not on the mesh", "nearest");
    folder.dcel("navmesh distances rooms.map 1 1 --limit -1").fails(2, "", "");

    let points = folder.dcel("navmesh random rooms.map --count 4 --seed 9").fine();
    assert_eq!(
        (points.lines().count(), &points),
        (4, &folder.dcel("navmesh random rooms.map --count 4 --seed 9").fine())
    );
    let words = points.split_whitespace().collect::<Vec<_>>().join(" ");
    let located = folder.dcel(&format!("navmesh locate rooms.map {words}")).fine();
    assert!(!located.contains("outside") && !located.contains("hole"), "{located}");
}

/// The commands below `Examples:`, with lines joined at `\`.
fn examples(help: &str) -> Vec<String> {
    let text = help.split("\nExamples:\n").nth(1).expect("examples").replace("\\\n", " ");
    text.lines().map(str::trim).filter(|line| !line.is_empty()).map(str::to_owned).collect()
}

#[test]
fn the_examples_of_the_help_run_and_the_help_fits_60_columns() {
    let folder = folder();
    folder.dcel("sample house.obj").fine();
    std::fs::create_dir_all(folder.path("figures/data")).expect("a folder");
    folder.write("figures/data/rooms.map", include_str!("../../figures/data/rooms.map"));
    folder.write("figures/data/rooms.scen", include_str!("../../figures/data/rooms.scen"));
    for command in [
        "navmesh",
        "navmesh info",
        "navmesh locate",
        "navmesh neighbours",
        "navmesh path",
        "navmesh raycast",
        "navmesh distances",
        "navmesh random",
        "navmesh scenario",
    ] {
        let output =
            folder.command(&format!("{command} --help")).env("COLUMNS", "60").output().expect("the command starts");
        let help = String::from_utf8(output.stdout).expect("UTF-8");
        let long: Vec<&str> = help.lines().filter(|line| line.chars().count() > 60).collect();
        assert!(long.is_empty(), "{command}: {long:?}");
        let examples = examples(&help);
        assert!(examples.len() >= 2, "{command}: {examples:?}");
        for example in examples {
            let call = example.strip_prefix("dcel ").unwrap_or_else(|| panic!("not a call: {example}"));
            assert_eq!(folder.dcel(call).code, Some(0), "{example}");
        }
    }
}

#[test]
fn a_grid_map_stays_what_it_is_as_a_mesh_and_other_formats_say_that_y_is_negated() {
    let folder = folder();
    let told = folder.dcel("convert rooms.map rooms.mesh");
    assert!(
        told.code == Some(0) && told.err.contains("y points down in rooms.mesh as it does in rooms.map"),
        "{told:?}"
    );
    // The same queries, the same points, the same lengths.
    let told = folder.dcel("navmesh scenario rooms.mesh rooms.scen");
    assert!(told.code == Some(0) && told.out.ends_with("\n24 of 24 optimal\n"), "{told:?}");
    let told = folder.dcel("convert rooms.map rooms.obj");
    assert!(told.err.contains("the point (x, y) of rooms.map is (x, -y) in rooms.obj"), "{told:?}");
    let text = folder.read("rooms.obj");
    let lowest = text.lines().filter_map(|line| line.strip_prefix("v ")?.split(' ').nth(1)?.parse::<f64>().ok());
    assert_eq!(lowest.reduce(f64::min), Some(-16.0), "{text}");
}

#[test]
fn a_mesh_of_version_3_is_written_as_version_2_without_its_blocked_polygons() {
    let folder = folder();
    // Two blocked triangles beside each other, and two to walk on; clockwise, as version 3 may have them. v5 is a corner
    // of blocked ones only.
    folder.write(
        "old.mesh",
        "mesh\n3\n6 5\n0 0\n0 8\n8 8\n8 0\n5 5\n12 0\n0 3  4 1 5  -4 0 -2\n1 3  1 2 5  -1 0 3\n1 3  2 3 5  2 0 -4\n\
        0 3  3 4 5  -3 -5 -1\n0 3  3 6 4  0 0 -4\n",
    );
    let told = folder.dcel("convert old.mesh new.mesh");
    assert!(told.code == Some(0) && told.err.contains("3 hole faces are not written"), "{told:?}");
    assert!(told.err.contains("2 points are not written: no polygon to walk on has a corner there"), "{told:?}");
    let text = folder.read("new.mesh");
    assert!(text.starts_with("mesh\n2\n4 2\n") && text.ends_with('\n'), "{text}");
    let [old, new] = ["old.mesh", "new.mesh"]
        .map(|map| folder.dcel(&format!("navmesh path {map} 1 4 6 7.5 --json")).json()["routes"][0]["length"].clone());
    assert!(old.is_number() && old == new, "{old} {new}");
    let info = folder.dcel("navmesh info new.mesh --json").json();
    assert_eq!((&info["faces"], &info["vertices"], &info["area"]), (&json!(2), &json!(4), &json!(32.0)));
}

#[test]
fn messages_about_a_floor_with_y_up_tell_its_x_and_z() {
    let folder = folder();
    folder.write("floor.obj", "v 0 7 0\nv 4 7 0\nv 4 7 3\nv 0 7 3\nv 4 7 0\nv 4 7 3\nv 6 7 1\nf 4 3 2 1\nf 7 5 6\n");
    let told = folder.dcel("navmesh info floor.obj --up y");
    assert!(told.out.contains("vertices 2 and 5 lie at the same place (4, 3)"), "{told:?}");
    folder.dcel("navmesh locate floor.obj 1 1 --up y").fails(2, "lie at the same place, (4, 3)", "");
}

#[test]
fn hand_made_floors_are_welded_on_request_and_warned_about_else() {
    let folder = folder();
    // Two squares with a gap of 10^-7 between them.
    folder.write(
        "near.obj",
        "v 0 0\nv 1 0\nv 1 1\nv 0 1\nv 1.0000001 0\nv 2 0\nv 2 1\nv 1.0000001 1\nf 1 2 3 4\nf 5 6 7 8\n",
    );
    folder.write("one.scen", "0 near.obj 2 1 0.5 0.5 1.5 0.5 1\n");
    for command in ["path near.obj 0.5 0.5 1.5 0.5", "locate near.obj 0.5 0.5", "scenario near.obj one.scen"] {
        let told = folder.dcel(&format!("navmesh {command}"));
        assert!(told.err.contains("near.obj:5: vertices 1 and 4 are 1.00e-7 apart"), "{command}: {told:?}");
        assert!(told.err.contains("--weld 1.1e-7 joins them"), "{command}: {told:?}");
        let told = folder.dcel(&format!("navmesh {command} --weld 1.1e-7"));
        assert!(told.code == Some(0) && told.err.contains("welded: 2 vertices were joined with others"), "{told:?}");
    }
    let info = folder.dcel("navmesh info near.obj --json").json();
    assert_eq!((&info["valid"], &info["faults"][0]["kind"]), (&json!(true), &json!("nearly-welded")));
    assert_eq!(folder.dcel("navmesh info near.obj --weld 1e-6 --json").json()["components"], json!([2]));
    assert!(folder.dcel("navmesh info near.obj --weld 1e-9").err.contains("nothing to weld"));
    // A T-junction, exact; and a millionth beside the side, on both sides of it.
    for (name, y, faces) in [("exact", "1", 3), ("below", "0.999999", 3), ("above", "1.000001", 5)] {
        let file =
            format!("v 0 0\nv 1 0\nv 2 0\nv 2 1\nv 1 {y}\nv 0 1\nv 2 2\nv 0 2\nf 1 2 5 6\nf 2 3 4 5\nf 6 4 7 8\n");
        folder.write(&format!("{name}.obj"), &file);
        let told = folder.dcel(&format!("navmesh path {name}.obj 0.5 0.5 1 1.5 --weld 1e-5 --json"));
        assert!(told.err.contains("1 corner was put into a side"), "{name}: {told:?}");
        let answer = told.json();
        let length = answer["routes"][0]["length"].as_f64().expect("a length");
        assert!((length - 1.25f64.sqrt()).abs() < 1e-6, "{name}: {answer}");
        let info = folder.dcel(&format!("navmesh info {name}.obj --weld 1e-5 --json")).json();
        assert_eq!((&info["faces"], &info["components"]), (&json!(faces), &json!([faces])), "{name}");
    }
    folder.dcel("navmesh path exact.obj 0.5 0.5 1 1.5").fails(2, "exact.obj:", "--mend");
    // As dcel navmesh info advises; and nothing is moved by it.
    folder.dcel("navmesh path exact.obj 0.5 0.5 1 1.5").fails(2, "", "help: --weld 0 joins vertices at one place");
    let told = folder.dcel("navmesh path exact.obj 0.5 0.5 1 1.5 --weld 0");
    assert!(told.code == Some(0) && told.err.contains("1 corner was put into a side, all in place\n"), "{told:?}");
    assert!(
        folder.dcel("navmesh path below.obj 0.5 0.5 1 1.5").err.contains("vertex 4 is 1.00e-6 beside the side 5 -> 3")
    );
    folder.dcel("navmesh info near.obj --weld -1").fails(2, "a distance of -1", "--weld 0.001");
    folder.dcel("navmesh info rooms.map --weld 1").fails(2, "--weld cannot be used on a grid map", "leave --weld out");
}

/// What `--snap` is proposed has two digits, is no less than the distance, and is enough.
#[test]
fn the_snap_that_is_proposed_has_few_digits_and_is_enough() {
    let folder = folder();
    folder.write("hall.obj", "v 0 0\nv 8 0\nv 8 4\nv 0 4\nf 1 2 3 4\n");
    for distance in [0.5, 0.123, 73.0, 9.99, 1.0 / 3.0, 1e-9, 1e60] {
        let path = format!("navmesh path hall.obj {} 1 4 2", -distance);
        let told = folder.dcel(&path).err;
        let proposed = told.split("--snap ").nth(1).and_then(|rest| rest.split(' ').next()).unwrap_or_default();
        let snap: f64 = proposed.parse().unwrap_or_else(|_| panic!("{told}"));
        assert!(snap >= distance && snap <= 1.11 * distance, "{distance}: {told}");
        let digits = format!("{snap:e}").split('e').next().map_or(0, |digits| digits.replace('.', "").len());
        assert!(digits <= 2, "{distance}: {told}");
        folder.dcel(&format!("{path} --snap {proposed}")).fine();
    }
}

/// Areas are those of the file, whatever obstacles cut their faces into.
#[test]
fn areas_keep_their_costs_where_walls_cut_through_them() {
    let folder = folder();
    // Two squares, the right one of mud, and a wall that crosses both and reaches round to the left.
    folder
        .write("mud.obj", "v 0 0\nv 8 0\nv 8 4\nv 0 4\nv 4 0\nv 4 4\nusemtl grass\nf 1 5 6 4\nusemtl mud\nf 5 2 3 6\n");
    let cost = |more: &str| {
        let path = format!("navmesh path mud.obj 1 2 7 2 --algorithm closest --json {more}");
        folder.dcel(&path).json()["routes"][0]["cost"].as_f64().expect("a cost")
    };
    let is_close = |cost: f64, expected: f64| (cost - expected).abs() < 1e-9 * expected;
    assert!(is_close(cost("--cost mud=3"), 3.0 + 9.0));
    for area in ["mud=3", "f2=3", "4,0,8,0,8,4,4,4=3"] {
        let around = cost(&format!("--cost {area} --wall 3,1.7,5,2.5"));
        let least = 12.0f64;
        assert!(around > least && around < 1.1 * least, "{area}: {around}");
        // A wall beside the way changes nothing, though it cuts both faces.
        assert!(is_close(cost(&format!("--cost {area} --wall 3,0.5,5,0.7")), least), "{area}");
    }
}

#[test]
fn what_obstacles_block_is_told() {
    let folder = folder();
    folder.write("hall.obj", "v 0 0 0\nv 20 0 0\nv 20 20 0\nv 0 20 0\nf 1 2 3 4\n");
    let some = "--obstacle 4,4,6,4,5,7";
    let info = folder.dcel(&format!("navmesh info hall.obj {some} --json")).json();
    assert_eq!(
        (&info["area"], &info["blocked_area"], &info["walkable_area"]),
        (&json!(400.0), &json!(3.0), &json!(397.0))
    );
    assert_eq!(info["blocked_faces"], json!(1));
    let text = folder.dcel(&format!("navmesh info hall.obj {some}")).fine();
    assert!(text.contains("blocked         1 face, area 3\n  walkable area   397"), "{text}");
    let found = folder.dcel(&format!("navmesh locate hall.obj 5 5 1 1 {some} --json")).json();
    assert_eq!(
        (&found[0]["blocked"], &found[0]["on"], &found[1]["blocked"]),
        (&json!(true), &json!("face"), &json!(false))
    );
    let text = folder.dcel(&format!("navmesh locate hall.obj 5 5 {some}")).fine();
    assert!(text.contains(", blocked; the nearest place is"), "{text}");
    let all = "--obstacle 0,0,20,0,20,20,0,20";
    let text = folder.dcel(&format!("navmesh info hall.obj {all}")).fine();
    assert!(text.contains("components      0, nothing is walkable"), "{text}");
    for json in ["", " --json"] {
        folder.dcel(&format!("navmesh random hall.obj {all}{json}")).fails(2, "nothing is walkable", "what blocks it");
    }
    let path = "navmesh path hall.obj 15 15 0.5 0.2 --algorithm closest --cost 12,4,5,3,2,10=1 --cost 7,0,6,11,7,7=1";
    folder.dcel(path).fine();
}

/// A start, a goal and the ends of links count on all sides of a double corner, and which side is meant is decided by the
/// path with its links.
#[test]
fn links_lead_to_and_from_all_sides_of_a_double_corner() {
    let folder = folder();
    folder.write("two.obj", "v 0 0\nv 40 0\nv 40 4\nv 0 4\nv 44 4\nv 44 8\nv 40 8\nf 1 2 3 4\nf 3 5 6 7\n");
    let cost = |arguments: &str| {
        let told = folder.dcel(&format!("navmesh path two.obj --json {arguments}"));
        let note = told.err.clone();
        (told.json()["cost"].as_f64().expect("a cost"), note)
    };
    // The goal: by the link to its other side, and not on foot.
    let (there, told) = cost("--link 1,1,41,5,1 -- 1 1 40 4");
    assert!((there - (1.0 + 2f64.sqrt())).abs() < 1e-12 && told.contains("in f1, f2: the shortest path is that of f2"));
    assert_eq!(cost("--link 1,1,41,5,1 --goal-face f2 -- 1 1 40 4").0.to_bits(), there.to_bits());
    assert!(cost("--link 1,1,41,5,1 --goal-face f1 -- 1 1 40 4").0 > 39.0);
    // The start, and with costs of faces.
    let (back, told) = cost("--link 41,5,1,1,1 -- 40 4 1 1");
    assert!((back - there).abs() < 1e-12 && told.contains("the shortest path is that of f2"), "{told}");
    let (dear, _) = cost("--link 41,5,1,1,1 --algorithm closest --cost f2=3 -- 40 4 1 1");
    assert!((dear - (1.0 + 3.0 * 2f64.sqrt())).abs() < 1e-12, "{dear}");
    // No way on foot at all.
    let (only, _) = cost("--link 1,1,42,6,1 --goal-face f2 -- 1 1 40 4");
    assert!((only - (1.0 + 8f64.sqrt())).abs() < 1e-12, "{only}");
    // With a wall: the mesh is another one then.
    let (walled, _) = cost("--wall 20,0,20,4 --link 1,1,41,5,1 -- 1 1 40 4");
    assert!((walled - there).abs() < 1e-12, "{walled}");
    // A link that begins there: for who comes from either side. It is the first of two, and told as the first.
    for start in ["39 3", "41 5"] {
        let (from_corner, _) = cost(&format!("--link 40,4,1,1,1 --link 0,0,1,1,9 -- {start} 1 1"));
        assert!((from_corner - (1.0 + 2f64.sqrt())).abs() < 1e-12, "{start}: {from_corner}");
        let told = folder.dcel(&format!("navmesh path two.obj --link 0,0,1,1,9 --link 40,4,1,1,1 -- {start} 1 1"));
        assert!(told.fine().contains("(40, 4) -> (1, 1), costs 1\n"), "{start}");
        let line = format!("navmesh path two.obj --link 0,0,1,1,9 --link 40,4,1,1,1 --json -- {start} 1 1");
        assert_eq!(folder.dcel(&line).json()["links"], json!([1]), "{start}");
    }
    // One that ends there reaches both sides, and so do distances.
    for goal in ["39 3", "41 5"] {
        assert!((cost(&format!("--link 1,1,40,4,1 -- 1 1 {goal}")).0 - (1.0 + 2f64.sqrt())).abs() < 1e-12, "{goal}");
    }
    let far = folder.dcel("navmesh distances two.obj 1 1 --link 1,1,40,4,1 --json").json();
    assert_eq!(far["vertices"].as_array().map(Vec::len), Some(7), "{far}");
    // On a floor in space.
    folder.write(
        "tilted.obj",
        "v 0 0 0\nv 40 0 0\nv 40 4 0\nv 0 4 0\nv 44 4 3\nv 44 8 3\nv 40 8 0\nf 1 2 3 4\nf 3 5 6 7\n",
    );
    let tilted = |arguments: &str| {
        folder.dcel(&format!("navmesh path tilted.obj --up z --json {arguments}")).json()["cost"].as_f64()
    };
    let expected = 1.0 + (1.25f64 * 1.25 + 1.0).sqrt();
    for arguments in ["--link 1,1,41,5,1 -- 1 1 40 4", "--link 41,5,1,1,1 -- 40 4 1 1", "--link 40,4,1,1,1 -- 41 5 1 1"]
    {
        let cost = tilted(arguments).expect(arguments);
        assert!((cost - expected).abs() < 1e-9, "{arguments}: {cost} and not {expected}");
    }
    // Nothing leads there: no side is called that of the shortest path.
    let told = folder.dcel("navmesh path two.obj --link 1,1,2,2,1 --start-face f1 -- 1 1 42 6");
    assert!(told.code == Some(1) && told.out.starts_with("no path: neither the map nor the links"), "{told:?}");
    folder.write(
        "three.obj",
        "v 0 0\nv 2 0\nv 2 2\nv 0 2\nv 4 2\nv 4 4\nv 2 4\nv 9 0\nv 11 0\nv 11 2\nf 1 2 3 4\nf 3 5 6 7\nf 8 9 10\n",
    );
    for link in ["", "--link 10,0.5,10,0.25,1"] {
        let told = folder.dcel(&format!("navmesh path three.obj {link} -- 10 0.5 2 2"));
        assert!(
            told.code == Some(1) && told.err.contains("in f1, f2: no path begins or ends in any of them"),
            "{told:?}"
        );
    }
}

/// What overlaps is cut apart on request, in files with numbered corners, too.
#[test]
fn faces_that_overlap_are_told_what_mends_them() {
    let folder = Folder::new();
    let two = |x: f64, y: f64, w: f64, h: f64| {
        format!("v {x} {y} 0\nv {} {y} 0\nv {} {} 0\nv {x} {} 0\n", x + w, x + w, y + h, y + h)
    };
    folder.write("plus.obj", &format!("{}{}f 1 2 3 4\nf 5 6 7 8\n", two(0.0, 2.0, 6.0, 2.0), two(2.0, 0.0, 2.0, 6.0)));
    let told = folder.dcel("navmesh info plus.obj");
    assert_eq!(told.code, Some(1), "{told:?}");
    assert!(told.err.contains("help: --mend cuts the polygons where they meet"), "{told:?}");
    assert_eq!(folder.dcel("navmesh info plus.obj --mend --json").json()["area"], 20.0);
}

/// All commands name the same place of two vertices that nearly meet: the line of the later one.
#[test]
fn vertices_that_nearly_meet_have_one_place() {
    let folder = Folder::new();
    let left = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
    let right = "v 1.000001 0 0\nv 2 0 0\nv 2 1 0\nv 1.000001 1 0\n";
    folder.write("nw.obj", &format!("{left}{right}f 1 2 3 4\nf 5 6 7 8\n"));
    let place = "nw.obj:5:";
    assert!(folder.dcel("navmesh info nw.obj").out.contains(place));
    for call in ["navmesh locate nw.obj 0.5 0.5", "navmesh path nw.obj 0.1 0.1 0.9 0.9"] {
        let told = folder.dcel(call);
        assert!(told.err.contains(place), "{call}: {told:?}");
    }
}
