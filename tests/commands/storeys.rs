//! Promise: `dcel navmesh` measures floors in space along their surface, knows storeys over each other, and takes areas by
//! name and by corners.

use crate::shell::Folder;
use serde_json::{Value, json};

fn folder() -> Folder {
    let folder = Folder::new();
    folder.dcel("sample house.obj").fine();
    folder
}

fn is_close(value: &Value, expected: f64) -> bool {
    value.as_f64().is_some_and(|value| (value - expected).abs() < 1e-9 * expected)
}

/// From (1, 1) in the hall to the same place in the gallery above: to the door post (9, 3), round the foot of the ramp
/// (9, 5.5), up its lower side to (4, 5.5), and back over the gallery.
fn up_the_ramp() -> [f64; 4] {
    [68f64.sqrt(), 2.5, 34f64.sqrt(), 29.25f64.sqrt()]
}

#[test]
fn a_path_leads_from_storey_to_storey_along_the_surface() {
    let folder = folder();
    let answer = folder.dcel("navmesh path house.obj --up z 1 1 0 1 1 3 --json -o path.svg").json();
    let route = &answer["routes"][0];
    assert!(is_close(&route["length"], up_the_ramp().iter().sum()), "{route}");
    assert_eq!(route["corners"], json!(["v7", "v12", "v13"]));
    let points = route["points"].as_array().expect("points");
    assert_eq!((&points[0], &points[points.len() - 1]), (&json!([1.0, 1.0, 0.0]), &json!([1.0, 1.0, 3.0])));
    assert!(points.contains(&json!([4.0, 5.5, 3.0])), "{route}");
    assert_eq!(route["layers"].as_array().map(Vec::len), Some(points.len() - 1));
    assert_eq!((&answer["start"]["layer"], &answer["goal"]["layer"]), (&json!(0), &json!(1)));
    let svg = folder.read("path.svg");
    for words in ["layer 0", "layer 1", "heights 0 to 3", "the path, 21.9855 along the surface", "on another layer"] {
        assert!(svg.contains(words), "{words}");
    }
    // By layers it is the same, and every algorithm of the ladder leads there.
    let text = folder.dcel("navmesh path house.obj --up z 1 1 1 1 --start-layer 0 --goal-layer 1").fine();
    assert!(text.starts_with("exact: 21.98549") && text.contains("along the surface"), "{text}");
    assert!(text.contains("layers  0 1\n") && text.contains("faces   f1 f2 f3 f4 f5\n"), "{text}");
    let table = folder.dcel("navmesh path house.obj --up z 1 1 0 1 1 3 --algorithm all").fine();
    assert!(table.lines().count() == 7 && table.contains("  exact      21.985490  1.000000"), "{table}");
    // Without the ramp there is no path.
    let told = folder.dcel("navmesh path house.obj --up z --max-slope 20 1 1 0 1 1 3");
    assert!(
        told.code == Some(1) && told.out.starts_with("no path: (1, 1, 0) is in component 0 of 3 faces"),
        "{told:?}"
    );
}

#[test]
fn a_point_says_which_storey_it_means() {
    let folder = folder();
    folder.dcel("navmesh path house.obj --up z 1 1 10 3").fails(
        2,
        "the start (1, 1) is on 2 storeys: layer 0 at (1, 1, 0), layer 1 at (1, 1, 3)",
        "--start-layer 0",
    );
    let both = folder.dcel("navmesh locate house.obj --up z 1 1 --json").json();
    let layers: Vec<&Value> = both[0]["places"].as_array().into_iter().flatten().map(|place| &place["layer"]).collect();
    assert_eq!(layers, [&json!(0), &json!(1)]);
    let one = folder.dcel("navmesh locate house.obj --up z --xyz 1 1 2.9 1 1 7 50 1 1 --json").json();
    assert_eq!(
        (&one[0]["places"][0]["point"], &one[1]["places"][0]["point"]),
        (&json!([1.0, 1.0, 0.0]), &json!([1.0, 1.0, 3.0]))
    );
    assert_eq!((&one[2]["places"], &one[2]["nearest"]), (&json!([]), &json!([12.0, 1.0, 0.0])));
    folder.dcel("navmesh locate house.obj --up z --xyz 1 1").fails(2, "2 numbers are no points", "three coordinates");
    folder.dcel("navmesh path house.obj --up z 1 1 -1 1 1 3").fails(2, "is below the surface", "");
    folder.dcel("navmesh path house.obj --up z 1 1 1 1 --start-layer 2").fails(2, "there is no layer 2", "there are 2");
    folder.dcel("navmesh path house.obj --up z 10 1 1 1 --start-layer 1").fails(
        2,
        "is not on layer 1, but on",
        "nearest",
    );
    folder.dcel("navmesh path house.obj --up z 1 1 0 1 1").fails(2, "5 numbers are not 2 points", "all three");
    // Off the surface: told, and moved on request.
    folder.dcel("navmesh path house.obj --up z 8.5 1 10 1").fails(2, "(8.5, 1) is not on the surface", "--snap 0.5");
    let told = folder.dcel("navmesh path house.obj --up z 8.5 1 10 1 --snap 0.5");
    assert!(told.code == Some(0) && told.err.contains("moved by 0.5 to"), "{told:?}");
    // The same house with y up: points are given and told as that file has them.
    let house = folder.read("house.obj");
    let turned: Vec<String> = house
        .lines()
        .map(|line| match line.strip_prefix("v ").map(|rest| rest.split(' ').collect::<Vec<_>>()).as_deref() {
            Some([x, y, z]) => format!("v {x} {z} -{y}"),
            _ => line.to_owned(),
        })
        .collect();
    folder.write("turned.obj", &turned.join("\n"));
    let answer = folder.dcel("navmesh path turned.obj --up y 1 0 -1 1 3 -1 --json").json();
    assert!(is_close(&answer["routes"][0]["length"], up_the_ramp().iter().sum()), "{answer}");
    assert_eq!(answer["goal"]["point"], json!([1.0, 3.0, -1.0]));
}

#[test]
fn info_tells_heights_slopes_and_layers() {
    let folder = folder();
    let info = folder.dcel("navmesh info house.obj --up z --json -o house.svg").json();
    assert_eq!((&info["heights"], &info["components"]), (&json!([0.0, 3.0]), &json!([5])));
    assert!(is_close(&info["steepest"], (3f64 / 5.0).atan().to_degrees()) && info["steepest_face"] == "f4", "{info}");
    let layers: Vec<&Value> = info["layers"].as_array().into_iter().flatten().map(|layer| &layer["faces"]).collect();
    assert_eq!(layers, [&json!(4), &json!(1)]);
    let text = folder.dcel("navmesh info house.obj --up z --max-slope 20").fine();
    assert!(text.contains("4, cut into 14 triangles; 1 is left out: too steep, or facing down"), "{text}");
    // Faults are named with their lines.
    folder.write("down.obj", "v 0 0 0\nv 1 0 0\nv 1 1 1\nv 0 1 1\nf 4 3 2 1\n");
    folder.dcel("navmesh info down.obj --up z").fails(2, "down.obj:5: face 0 faces down", "--orient");
    folder.dcel("navmesh info down.obj --up z --orient").fine();
    folder.write("fan.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 1 2\nv 0 1 4\nf 1 2 3\nf 1 2 4\nf 1 2 5\n");
    folder.dcel("navmesh info fan.obj --up z").fails(2, "fan.obj:6: faces 0, 1 and 2 all have the edge", "--max-slope");
}

#[test]
fn what_looks_at_the_plan_says_so() {
    let folder = folder();
    for command in [
        "raycast house.obj 1 1 2 2 --wall 0,0,1,1",
        "random house.obj --wall 0,0,1,1",
        "neighbours house.obj f1",
        "path house.obj 1 1 2 2 --radius 0.2",
    ] {
        folder.dcel(&format!("navmesh {command} --up z")).fails(
            2,
            "2 storeys lie over each other",
            "--layer 0 to --layer 1",
        );
    }
    folder.dcel("sample floor.obj").fine();
    // One of the storeys. From the hall through the door and round its post (9, 3), a quarter off it.
    let told = folder.dcel("navmesh path house.obj --up z --layer 0 1 1 11 6 --radius 0.25 --json");
    assert!(told.err.contains("1 face is left out of 5"), "{told:?}");
    let (length, straight) = (told.json()["routes"][0]["length"].as_f64().unwrap_or(0.0), 68f64.sqrt() + 13f64.sqrt());
    assert!(length > straight && length < straight + 0.25, "{length} {straight}");
    let gallery = folder.dcel("navmesh neighbours house.obj f1 --up z --layer 1 --json");
    assert!(gallery.err.contains("4 faces are left out of 5"), "{gallery:?}");
    folder.dcel("navmesh locate house.obj 1 1 --up z --layer 1 --wall 1,3,2,3").fine();
    folder.dcel("navmesh path house.obj 1 1 2 2 --up z --layer 2").fails(2, "no layer 2: there are 2 layers", "info");
    folder.dcel("navmesh path floor.obj 1 1 2 2 --up y --layer 1").fails(2, "no layer 1: there is 1 layer", "info");
    folder.dcel("navmesh path house.obj 1 1 2 2 --layer 1").fails(2, "required arguments", "--up");
    // Walls and undersides of a whole house have no place in the plan.
    let room = "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 1\nv 0 0 3\nv 4 0 3\nf 1 2 3 4\nf 1 5 6 2\nf 4 3 2 1\n";
    folder.write("room.obj", room);
    let told = folder.dcel("navmesh path room.obj --up z --max-slope 60 1 1 3 3 --radius 0.3 --json");
    assert!(told.err.contains("2 faces are left out of 3"), "{told:?}");
    assert!(is_close(&told.json()["routes"][0]["length"], 8_f64.sqrt()));
    // One storey whose heights differ: the plan is looked at, and the length is that of the plan.
    folder.write("ramp.obj", "v 0 0 0\nv 4 0 3\nv 4 2 3\nv 0 2 0\nf 1 2 3 4\n");
    let told = folder.dcel("navmesh path ramp.obj --up z 0.5 1 3.5 1 --radius 0.25 --json");
    assert!(told.err.contains("measured in the plan, and not along the surface"), "{told:?}");
    let length = |more: &str| {
        folder.dcel(&format!("navmesh path ramp.obj --up z 0.5 1 3.5 1 --json {more}")).json()["routes"][0]["length"]
            .clone()
    };
    assert_eq!((length("--radius 0.25"), length("")), (json!(3.0), json!(3.75)));
    folder.dcel("navmesh path ramp.obj --up z 0 0 1 1 --mend").fails(2, "--mend cannot be used", "--weld 0.001 joins");
    folder.dcel("navmesh path ramp.obj 0 0 1 1 --max-slope 9").fails(2, "required arguments", "--up");
}

/// Two slopes of two faces, one after the other; those of the upper one meet in the middle of the lower one's side, `off`
/// above it. A storey of the same plan lies so much above.
fn slopes(off: f64, storey: f64) -> String {
    let corners = [(0, 0, 0), (4, 0, 0), (4, 4, 1), (0, 4, 1), (2, 8, 2), (0, 8, 2), (4, 8, 2)];
    let mut text: String = corners.iter().map(|(x, y, z)| format!("v {x} {y} {z}\n")).collect();
    text += &format!("v 2 4 {}\n", 1.0 + off);
    text += &corners.iter().map(|(x, y, z)| format!("v {x} {y} {}\n", f64::from(*z) + storey)).collect::<String>();
    text + "f 1 2 3 4\nf 4 8 5 6\nf 8 3 7 5\nf 9 10 11 12\nf 12 11 15 14\n"
}

#[test]
fn what_nearly_meets_on_a_slope_is_told_and_joined_and_storeys_stay_apart() {
    let folder = folder();
    for (off, said, weld) in [
        (0.0, "vertex 7 is on the side 2 -> 3 of face 0", "0"),
        (1e-5, "vertex 7 is 1.00e-5 beside the side 2 -> 3 of face 0", "0.00001"),
    ] {
        folder.write("slopes.obj", &slopes(off, 0.5));
        let path = "navmesh path slopes.obj --up z 1 1 0.3 1 7 1.8";
        let told = folder.dcel(path);
        assert!(told.out.contains("no path") && told.err.contains(&format!("slopes.obj:8: {said}")), "{told:?}");
        // The help is taken at its word.
        let help = told.err.lines().find_map(|line| line.strip_prefix("help: ")).expect("a help").to_owned();
        assert!(help.starts_with(&format!("--weld {weld}")) && help.ends_with(" joins them"), "{help}");
        let info = folder.dcel("navmesh info slopes.obj --up z");
        assert!(info.out.contains("components      3") && info.out.contains(&format!("warning: {said}")), "{info:?}");
        let flags = help.strip_suffix(" joins them").expect("its end");
        let told = folder.dcel(&format!("{path} {flags}"));
        assert!(
            told.out.contains("exact: 6.18465843") && told.err.contains("1 corner was put into a side"),
            "{told:?}"
        );
        let info = folder.dcel(&format!("navmesh info slopes.obj --up z {flags} --json")).json();
        assert_eq!((&info["components"], info["layers"].as_array().map(Vec::len)), (&json!([3, 2]), Some(2)), "{info}");
        assert_eq!(info["faults"], json!([]));
    }
    // More than the storeys are apart: they are joined, and then that is no surface.
    let told = folder.dcel("navmesh info slopes.obj --up z --weld 0.6");
    assert_eq!((told.code, told.out.as_str()), (Some(2), ""), "{told:?}");
}

#[test]
fn distances_are_along_the_surface_and_over_links() {
    let folder = folder();
    let field = folder.dcel("navmesh distances house.obj --up z 1 1 0 --json -o reach.svg").json();
    let far = |field: &Value, v: &str| {
        let rows = field["vertices"].as_array().expect("rows");
        rows.iter().find(|row| row["vertex"] == v).map(|row| row["distance"].clone()).expect("the vertex")
    };
    assert!(is_close(&far(&field, "v13"), up_the_ramp()[..3].iter().sum()), "{field}");
    assert!(folder.read("reach.svg").contains("a vertex and how far it is"));
    let lift = folder.dcel("navmesh distances house.obj --up z 1 1 0 --link 1,1,0,1,1,3,2 --json").json();
    assert!(is_close(&far(&lift, "v13"), 2.0 + up_the_ramp()[3]), "{lift}");
    assert!(is_close(&far(&lift, "v7"), 68f64.sqrt()), "what is near stays near: {lift}");
    let dear = folder.dcel("navmesh distances house.obj --up z 1 1 0 --cost f1=2 --json").json();
    let [plain, costly] = [&field, &dear].map(|field| far(field, "v13").as_f64().expect("a number"));
    assert!(costly > plain && costly < 2.1 * plain, "{plain}, and {costly} with a dear hall");
    let near = folder.dcel("navmesh distances house.obj --up z 1 1 0 --limit 6 --json").json();
    assert_eq!(near["vertices"].as_array().map(Vec::len), Some(2));
    // A map of the plane, too: a teleport of 0.5 from (2, 1) to (22, 11).
    folder.write("hall.obj", "v 0 0\nv 8 0\nv 8 4\nv 0 4\nf 1 2 3 4\n");
    let hall = folder.dcel("navmesh distances hall.obj 1 2 --link 1,3,8,1,0.5 --json").json();
    assert!(is_close(&far(&hall, "v1"), 2.5) && is_close(&far(&hall, "v0"), 5f64.sqrt()), "{hall}");
    let mud = folder.dcel("navmesh distances hall.obj 1 2 --cost 0,0,8,0,8,4,0,4=3 --json").json();
    assert!(is_close(&far(&mud, "v0"), 3.0 * 5f64.sqrt()), "one cost is exact: {mud}");
    let cost = folder.dcel("navmesh path house.obj --up z 1 1 0 1 1 3 --link 1,1,0,1,1,3,2 --json -o lift.svg").json();
    assert_eq!((&cost["cost"], &cost["links"]), (&json!(2.0), &json!([0])));
    assert!(folder.read("lift.svg").contains("a link of the path"));
    folder.dcel("navmesh path hall.obj 1 1 2 2 --link 1,1,0,1,1,3,2").fails(2, "have three coordinates", "x0,y0");
}

#[test]
fn areas_are_faces_names_or_corners() {
    let folder = folder();
    // On a surface by material: only the ramp is of wood.
    let path = "navmesh path house.obj --up z 1 1 0 1 1 3 --algorithm closest";
    let wood = folder.dcel(&format!("{path} --cost wood=5 --json")).json();
    let [hall, yard, ramp, gallery] = up_the_ramp();
    assert!(is_close(&wood["routes"][0]["cost"], hall + yard + 5.0 * ramp + gallery), "{wood}");
    let both = folder.dcel(&format!("{path} --cost ramp=5 --cost f5=0 --json")).json();
    assert!(is_close(&both["routes"][0]["cost"], hall + yard + 5.0 * ramp), "{both}");
    folder.dcel(&format!("{path} --cost wod=5")).fails(2, "no face has the name `wod`", "did you mean wood?");
    folder.dcel(&format!("{path} --cost 0,0,1,0,1,1=5")).fails(2, "an area with corners cannot be used", "group");
    // Links and costs together: the lift is worth while where the ramp is dear.
    let lift = |cost: &str| {
        folder.dcel(&format!("{path} --link 1,1,0,1,1,3,30 --cost wood={cost} --json")).json()["links"].clone()
    };
    assert_eq!((lift("1"), lift("3")), (json!([]), json!([0])));
    // On a map of the plane: a strip of mud across a hall, by group, by corners, and after cutting.
    folder.write(
        "hall.obj",
        "v 0 0\nv 4 0\nv 6 0\nv 10 0\nv 10 4\nv 6 4\nv 4 4\nv 0 4\nf 1 2 7 8\ng mud wet\nf 2 3 6 7\ng\nf 3 4 5 6\n",
    );
    folder.write("bare.obj", "v 0 0\nv 10 0\nv 10 4\nv 0 4\nf 1 2 3 4\n");
    let cost = |arguments: &str| {
        folder.dcel(&format!("navmesh path {arguments} 1 2 9 2 --algorithm closest --json")).json()["routes"][0]["cost"]
            .clone()
    };
    for arguments in
        ["hall.obj --cost mud=3", "hall.obj --cost wet=3", "hall.obj --cost f2=3", "hall.obj --triangles --cost mud=3"]
    {
        assert!(is_close(&cost(arguments), 6.0 + 3.0 * 2.0), "{arguments}: {}", cost(arguments));
    }
    // Corners cut faces exactly where they are, and beyond the map there is nothing.
    assert!(is_close(&cost("bare.obj --cost 4,-1,6,-1,6,9,4,9=3"), 6.0 + 3.0 * 2.0));
    // Of areas over each other the last counts.
    let twice = "bare.obj --cost 4,0,6,0,6,4,4,4=9 --cost 4,0,6,0,6,4,4,4=3";
    assert!(is_close(&cost(twice), 6.0 + 3.0 * 2.0), "{}", cost(twice));
    let outside = folder.dcel("navmesh path bare.obj 1 2 5 -0.5 --algorithm closest --cost 4,-1,6,-1,6,9,4,9=3");
    assert!(outside.code == Some(2) && outside.err.contains("is not on the mesh"), "{outside:?}");
    folder.dcel("navmesh path bare.obj 1 2 9 2 --cost mud=2 --algorithm closest").fails(
        2,
        "no face has the name `mud`",
        "names no faces",
    );
    folder.dcel("navmesh path bare.obj 1 2 9 2 --cost 1,2,3,4=2").fails(2, "three corners or more", "");
}

#[test]
fn lines_and_random_places_are_on_the_surface() {
    let folder = folder();
    // On the upper storey and on the lower one the same line of the plan.
    for (height, layer) in [("0", 0), ("3", 1)] {
        let answer =
            folder.dcel(&format!("navmesh raycast house.obj --up z 1 1 {height} 99 1 0 --json -o ray.svg")).json();
        assert_eq!((&answer["clear"], &answer["start"][2]), (&json!(false), &json!(f64::from(layer) * 3.0)));
        assert!(folder.read("ray.svg").contains("<svg"));
        let told = folder.dcel(&format!("navmesh raycast house.obj --up z 1 1 99 1 --start-layer {layer}")).fine();
        assert!(told.starts_with("hit: the side v") && told.contains("away along the surface"), "{told}");
    }
    let told = folder.dcel("navmesh raycast house.obj --up z 1 1 0 2 1 0").fine();
    assert!(told.starts_with("clear: (2, 1, 0) is in sight of (1, 1, 0) in the plan, 1 away"), "{told}");
    folder.dcel("navmesh raycast house.obj --up z 1 1 2 2").fails(2, "(1, 1) is on 2 storeys", "--start-layer");
    folder.dcel("navmesh raycast house.obj --up z 1 1 0 2 2").fails(2, "5 numbers are not 2 points", "");

    let points = folder.dcel("navmesh random house.obj --up z --count 40 --seed 3").fine();
    assert_eq!(points, folder.dcel("navmesh random house.obj --up z --count 40 --seed 3").fine());
    let rows: Vec<Vec<f64>> =
        points.lines().map(|line| line.split(' ').map(|word| word.parse().expect("a number")).collect()).collect();
    assert!(rows.len() == 40 && rows.iter().all(|row| row.len() == 3), "{points}");
    // Both storeys have some.
    let has = |height: f64| rows.iter().any(|row| row[2].total_cmp(&height).is_eq());
    assert!(has(0.0) && has(3.0), "{points}");
    let words = points.split_whitespace().collect::<Vec<_>>().join(" ");
    let located = folder.dcel(&format!("navmesh locate house.obj --up z --xyz {words} --json")).json();
    for (row, found) in rows.iter().zip(located.as_array().expect("rows")) {
        assert_eq!(found["places"][0]["point"][2], json!(row[2]), "{row:?}: {found}");
    }
}

/// A floor in space whose heights happen to be equal takes the same points as any other.
#[test]
fn a_level_floor_takes_points_of_three_coordinates() {
    let folder = folder();
    folder.write("level.obj", "v 0 5 0\nv 8 5 0\nv 8 5 -4\nv 0 5 -4\nf 1 2 3 4\n");
    let ask = |arguments: &str| folder.dcel(&format!("navmesh {arguments}"));
    for (flat, space) in [
        ("path level.obj --up y 1 -1 5 -4", "path level.obj --up y 1 5 -1 5 5 -4"),
        ("path level.obj --up y --radius 0.5 1 -1 5 -3", "path level.obj --up y --radius 0.5 1 9 -1 5 5 -3"),
        ("distances level.obj --up y 1 -1", "distances level.obj --up y 1 5 -1"),
        ("raycast level.obj --up y 1 -1 9 -1", "raycast level.obj --up y 1 5 -1 9 5 -1"),
        ("locate level.obj --up y 1 -1 0 0", "locate level.obj --up y --xyz 1 5 -1 0 5 0"),
        (
            "path level.obj --up y --link 1,-2,5,-3,1 1 -1 5 -4",
            "path level.obj --up y --link 1,5,-2,5,5,-3,1 1 -1 5 -4",
        ),
    ] {
        assert_eq!(ask(space).fine(), ask(flat).fine(), "{space}");
    }
    ask("path level.obj --up y 1 4 -1 5 5 -4").fails(2, "(1, 4, -1) is below the floor, whose height is 5", "greater");
    ask("distances level.obj --up y 1 4.9 -1").fails(2, "is below the floor, whose height is 5", "greater height");
    // The heights of a floor that is looked at from above do not count, and a map has none.
    folder.dcel("sample rooms.map").fine();
    for arguments in ["path rooms.map 1 1 0 2 2 0", "path house.obj --up z --layer 0 --radius 0.1 1 1 0 2 2 0"] {
        ask(arguments).fails(2, "three coordinates are for floors in space (--up)", "give x y of the start");
    }
    ask("distances rooms.map 1 1 0").fails(2, "three coordinates are for floors in space (--up)", "give x and y");
    ask("path rooms.map 1 1 0 2 2").fails(2, "a path has two ends", "give x y of the start");
}
