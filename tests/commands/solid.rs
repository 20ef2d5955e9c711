//! `dcel solid` from the shell.

use crate::shell::{CUBE, Folder};
use serde_json::json;
use std::process::Command;

#[test]
fn a_torus_is_made_written_and_measured() {
    let folder = Folder::new();
    let text = folder.dcel("solid make torus 7 5 -o t.off").fine();
    assert!(text.contains("torus 7 5: 35 vertices, 70 edges, 35 faces; V - E + F = 0, genus 1"), "{text}");
    let made = folder.dcel("solid make torus 7 5 --json").json();
    assert_eq!((&made["vertices"], &made["genus"], &made["euler"]), (&json!(35), &json!(1), &json!(0)));
    let info = folder.dcel("solid info t.off --json").json();
    assert_eq!((&info["closed"], &info["convex"]), (&json!(true), &json!(false)));
    assert_eq!(info["not_convex"], "the surface has handles (1): a convex solid has none");
    assert_eq!(info["pieces"][0]["genus"], 1);
    let told = folder.dcel("solid support t.off 0,0,1");
    told.fails(2, "t.off: the surface has handles (1)", "a convex solid has none");
}

/// Two edges with the same ends are one where edges are told by their ends.
#[test]
fn a_torus_too_narrow_for_a_list_of_corners_is_refused() {
    let folder = Folder::new();
    for (shape, ending) in [("3 2", "off"), ("2 2", "off"), ("2 3", "obj"), ("2 3", "ply")] {
        let call = format!("solid make torus {shape} -o t.{ending}");
        folder.dcel(&call).fails(2, "join the same two vertices", "make the shape of more parts");
        assert!(!folder.path(&format!("t.{ending}")).exists(), "{call}");
    }
    folder.dcel("solid make torus 3 3 -o t.off").fine();
    assert_eq!(folder.dcel("solid info t.off --json").json()["pieces"][0]["genus"], 1);
    let told = folder.dcel("solid info t.off").out;
    assert!(told.contains("= 2 - 2 x 1 handle - 0 borders"), "{told}");
}

#[test]
fn hulls_of_files_without_a_known_format_name_those_that_are() {
    let folder = Folder::new();
    folder.write("trees.xy", "0 0\n1 0\n0 1\n");
    folder.dcel("solid make hull trees.xy").fails(2, "the format is not known", "obj, off, ply and stl");
}

#[test]
fn every_shape_of_the_help_is_made_and_closed() {
    let folder = Folder::new();
    let help = folder.dcel("solid make --help").fine();
    for shape in [
        "tetrahedron",
        "cube",
        "octahedron",
        "dodecahedron",
        "icosahedron",
        "truncated-cube",
        "cuboctahedron",
        "icosidodecahedron",
        "rhombicuboctahedron",
        "rhombicosidodecahedron",
        "truncated-cuboctahedron",
        "truncated-icosidodecahedron",
        "snub-cube-left",
        "snub-cube-right",
        "snub-dodecahedron-left",
        "snub-dodecahedron-right",
        "ring 5",
        "grid 3 2",
        "box 1 2 3",
        "cylinder 6 2",
        "cone 5 3",
        "sphere 6 4",
        "flat-sphere 5 2",
        "torus 4 3",
    ] {
        assert!(help.contains(shape.split(' ').next().unwrap()), "{shape}");
        let made = folder.dcel(&format!("solid make {shape} --json")).json();
        let euler = if shape.starts_with("torus") { 0 } else { 2 };
        assert_eq!((&made["euler"], &made["borders"]), (&json!(euler), &json!(0)), "{shape}");
    }
    folder.dcel("solid make prism 5").fails(2, "`prism` is no shape", "truncated-octahedron");
    folder.dcel("solid make snub-cube").fails(
        2,
        "`snub-cube` is no shape",
        "did you mean snub-cube-left? choose one of",
    );
    folder.dcel("solid make torus 7").fails(2, "torus takes 2 whole numbers: N M", "make torus 7 5");
    folder.dcel("solid make cube 3").fails(2, "cube takes no numbers", "box 3 3 3");
    folder.dcel("solid make cone 2 2").fails(2, "2", "");
    folder.dcel("solid make cube -o cube.svg").fails(2, "cube.svg", "");
}

#[test]
fn hulls_duals_and_supports_go_from_file_to_file() {
    let folder = Folder::new();
    folder.write("cube.off", CUBE);
    let dual = folder.dcel("solid dual cube.off -o dual.off --json").json();
    assert_eq!((&dual["vertices"], &dual["faces"]), (&json!(6), &json!(8)));
    assert!(dual["note"].as_str().unwrap().starts_with("each vertex is the mean"), "the origin is a corner: {dual}");
    let found = folder.dcel("solid support cube.off 1,2,-3 --from v7 --json").json();
    assert_eq!((&found["vertex"], &found["path"]), (&json!("v2"), &json!(["v7", "v3", "v2"])));
    folder.dcel("solid support cube.off 1,2").fails(2, "", "three numbers");
    folder.dcel("solid support cube.off 0,0,0").fails(2, "0,0,0 is no direction", "for example: 0,0,1");
    folder.dcel("solid support cube.off 0,0,1 --from v9").fails(2, "--from: there is no v9: there are 8 vertices", "");

    folder.write("cloud.obj", "v 0 0 0\nv 2 0 0\nv 0 2 0\nv 0 0 2\nv 0.1 0.1 0.1\nv 1 1 0\nf 1 2 3\n");
    let hull = folder.dcel("solid make hull cloud.obj -o hull.stl --json").json();
    assert_eq!(
        (&hull["vertices"], &hull["faces"], &hull["note"]),
        (&json!(4), &json!(4), &json!("4 of 6 points are corners"))
    );
    assert_eq!(folder.dcel("solid info hull.stl --json").json()["convex"], true);
    folder.write("flat.obj", "v 0 0 0\nv 2 0 0\nv 0 2 0\nv 2 2 0\nf 1 2 4 3\n");
    folder.dcel("solid make hull flat.obj").fails(
        2,
        "all points lie in the plane through points 0, 3 and 1",
        "counted from 0",
    );
    folder.dcel("solid dual flat.obj").fails(2, "border", "");
    let finer = folder.dcel("solid subdivide cube.off --sharper 100 --steps 2 --json").json();
    assert_eq!((&finer["faces"], &finer["euler"]), (&json!(96), &json!(2)));
}

#[test]
fn the_report_has_angles_volume_and_tables() {
    let folder = Folder::new();
    folder.write("cube.off", CUBE);
    let text = folder.dcel("solid info cube.off").fine();
    for line in [
        "8 - 12 + 6 = 2",
        "dihedral         90.0000 degrees everywhere",
        "deficit          90.0000 degrees everywhere",
        "deficit sum      720.0000 degrees; 360 x (V - E + F)\n",
        "Gauss curvature  2.0944 everywhere",
        "mean curvature   1.5708 everywhere",
        "area             6.000000",
        "volume           1.000000",
        "convex           yes",
    ] {
        assert!(text.contains(line), "{line} in {text}");
    }
    // What is small has its digits, too.
    folder.write("tiny.off", "OFF\n4 4 0\n0 0 0\n1e-5 0 0\n0 1e-5 0\n0 0 1e-5\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n");
    let tiny = folder.dcel("solid info tiny.off").fine();
    assert!(
        tiny.contains("area             2.366025e-10\n") && tiny.contains("volume           1.666667e-16\n"),
        "{tiny}"
    );
    let json = folder.dcel("solid info cube.off --json").json();
    assert_eq!((&json["dihedral_angles"], &json["dihedral_angles_at"]), (&json!([90.0, 90.0]), &json!(["e0", "e0"])));
    // Three edges of length 1 at a corner, each half of it, each bent by a quarter turn; the area is 3 / 4.
    let bend = json["mean_curvature"][0].as_f64().unwrap();
    assert!((bend - 3.0 * std::f64::consts::FRAC_PI_2 / 4.0 / 0.75).abs() < 1e-12, "{bend}");
    let gauss = json["gauss_curvature"][1].as_f64().unwrap();
    assert!((gauss - std::f64::consts::FRAC_PI_2 / 0.75).abs() < 1e-12, "{gauss}");
    let tables = folder.dcel("solid info cube.off --winged").fine();
    let rows: Vec<&str> = tables.lines().collect();
    assert_eq!(rows.len(), 3 + 3 + 2 + 8 + 6 + 24);
    assert!(tables.contains("Half-edge list\nid   o    w_i  w_o  v   f\nh0   h1   h6   h2   v3  f0\n"), "{tables}");
    folder.write("plan.wkt", "LINESTRING (0 0, 1 0, 0 1, 0 0)\n");
    folder.dcel("solid info plan.wkt").fails(2, "holds a structure of the plane", "obj, off, ply and stl");
}

/// Flat places round to zero, and zero has no sign; border vertices have no curvature of their own.
#[test]
fn ranges_say_where_and_zeros_have_no_sign() {
    let folder = Folder::new();
    folder.dcel("solid make torus 9 6 -o t.off").fine();
    let text = folder.dcel("solid info t.off").fine();
    assert!(!text.contains("-0.0000"), "{text}");
    let at = |what: &str| text.lines().find(|line| line.trim_start().starts_with(what)).unwrap_or("").to_owned();
    assert!(at("dihedral").contains(" degrees at e") && at("Gauss curvature").contains(" at v"), "{text}");
    assert!(at("Gauss curvature").contains(" -") && at("deficit sum").contains(" 0.0000 degrees"), "{text}");
    folder.dcel("solid make grid 3 3 -o g.off").fine();
    let text = folder.dcel("solid info g.off").fine();
    assert!(!text.contains("-0.0000") && text.contains("volume           0.000000\n"), "{text}");
    folder.write("open.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n");
    let json = folder.dcel("solid info open.off --json").json();
    assert_eq!(
        (&json["gauss_curvature"], &json["mean_curvature_at"], &json["volume"]),
        (&json!(null), &json!(null), &json!(null))
    );
    assert_eq!(json["dihedral_angles"], json!([180.0, 180.0]));
    assert!((json["deficit_sum"].as_f64().unwrap() - 360.0).abs() < 1e-9, "{json}");
}

#[test]
fn what_is_too_much_is_refused_before_memory_goes() {
    let folder = Folder::new();
    for shape in [
        "torus 1000000000 1000000000",
        "ring 1000000000",
        "sphere 30000 30000",
        "box 99999 99999 99999",
        "grid 18446744073709551615 3",
    ] {
        let told = folder.dcel(&format!("solid make {shape}"));
        told.fails(2, "this command makes at most 20000000", "take smaller numbers");
    }
    folder.dcel("solid make torus 10000000000000000000000 3").fails(2, "torus takes 2 whole numbers", "make torus 7 5");
    folder.dcel("solid make torus -1 3").fails(2, "", "");
    folder.dcel("solid make sphere 0 0").fails(2, "sides: 0 is too few, take at least 3", "");
    folder.dcel("solid make box 20 20 20 -o b.off").fine();
    folder.dcel("solid subdivide b.off --steps 8").fails(2, "the finer surface would have", "take fewer steps");
}

#[test]
fn stl_goes_out_as_text_and_as_binary() {
    let folder = Folder::new();
    folder.dcel("solid make truncated-cube -o t.stl").fine();
    folder.dcel("solid make truncated-cube -o b.stl --to stl-binary").fine();
    let [text, binary] = ["t.stl", "b.stl"].map(|name| folder.dcel(&format!("solid info {name} --json")).json());
    for key in ["vertices", "edges", "faces", "euler"] {
        assert_eq!(text[key], binary[key], "{key}");
    }
    assert!(folder.dcel("convert t.stl again.stl --to stl-binary").code == Some(0));
    assert_eq!(std::fs::read(folder.path("again.stl")).unwrap(), std::fs::read(folder.path("b.stl")).unwrap());
    folder.dcel("solid make cube --to stl-binary").fails(2, "", "--output");
    folder.dcel("solid make cube -o c.solid").fails(2, "c.solid: the file name does not say", "--to");
}

/// A flag that is refused, or a way that leads back, is no help.
#[test]
fn what_helps_on_solids_is_what_they_take() {
    let folder = Folder::new();
    for command in ["info", "dual", "subdivide", "split", "figure", "schlegel", "support"] {
        let help = folder.dcel(&format!("solid {command} --help")).fine();
        for flag in ["--mend", "--trust", "--plane ", "--split-crossings", "--full-check"] {
            assert!(!help.contains(flag), "solid {command} offers {flag}");
        }
        assert!(help.contains("--orient"), "{command}: {help}");
    }
    folder.dcel("solid info cube.off --mend").fails(2, "--mend cannot be used", "leave --mend out");
    folder.write("line.json", r#"{"type": "Polygon", "coordinates": [[[0, 0], [1, 1], [0, 0]]]}"#);
    let told = folder.dcel("solid info line.json");
    told.fails(2, "encloses nothing", "--drop-degenerate-rings");
    assert!(!told.err.contains("--mend"), "{told:?}");
    folder.dcel("solid subdivide cube.off --loop").fails(2, "has 4 sides", "dcel solid split");
    folder.dcel("solid make torus 1 3 -o t.off").fails(2, "both bound f0", "make the shape of more parts");
}

/// Both triangles of a side of a cube lie in one plane: no eye sees through one of them alone.
#[test]
fn nothing_is_seen_through_a_part_of_a_side() {
    let folder = Folder::new();
    let sides = ["0 1 2 3", "4 7 6 5", "0 4 5 1", "1 5 6 2", "2 6 7 3", "3 7 4 0"];
    let halves = |side: &str| {
        let c: Vec<&str> = side.split(' ').collect();
        format!("3 {} {} {}\n3 {} {} {}\n", c[0], c[2], c[1], c[0], c[3], c[2])
    };
    let points = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n";
    folder.write("halves.off", &format!("OFF\n8 12 0\n{points}{}", sides.map(halves).concat()));
    assert_eq!(folder.dcel("solid info halves.off --json").json()["convex"], true);
    for (face, other) in [("f0", "f1"), ("f3", "f2"), ("f11", "f10")] {
        let told = folder.dcel(&format!("solid schlegel halves.off --through {face}"));
        told.fails(2, &format!("{face} and {other} lie in one plane"), "join the two");
    }
}

#[test]
fn all_faces_on_an_edge_are_named_with_their_lines() {
    let folder = Folder::new();
    let points = "OFF\n6 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 -1 0\n0 0 -1\n";
    folder.write("book.off", &format!("{points}3 0 1 2\n3 1 0 3\n3 0 1 4\n3 1 0 5\n"));
    for command in ["solid info", "info", "validate"] {
        let told = folder.dcel(&format!("{command} book.off --surface"));
        let text = format!("{}{}", told.out, told.err);
        assert!(text.contains("has 4 faces (0, 1, 2, 3)"), "{command}: {told:?}");
        assert!(text.contains("face 3"), "the line of each: {command}: {told:?}");
    }
}

#[test]
fn wound_wrong_and_one_sided_surfaces_are_told_apart() {
    let folder = Folder::new();
    let turned = CUBE.replace("4 4 5 6 7", "4 7 6 5 4");
    folder.write("turned.off", &turned);
    let told = folder.dcel("solid info turned.off");
    told.fails(2, "turned.off:12: faces 1 and", "--orient");
    assert!(told.err.contains("reverse face 1"), "{told:?}");
    let told = folder.dcel("solid info turned.off --orient --json");
    assert!(told.err.contains("1 of 6 faces was wound against the rest and turned round"), "{told:?}");
    assert_eq!(told.json()["volume"], 1.0);
    let strip = "OFF\n5 5 0\n0 0 0\n1 0 0\n1 1 0\n0 1 1\n0 0 1\n3 0 1 2\n3 2 1 3\n3 2 3 4\n3 4 3 0\n3 4 0 1\n";
    folder.write("strip.off", strip);
    let told = folder.dcel("solid info strip.off --orient");
    told.fails(2, "form a Moebius strip", "cut the strip open");
}

#[test]
fn figures_show_half_edges_of_faces_that_are_seen_and_dash_the_rest() {
    let folder = Folder::new();
    folder.write("cube.off", CUBE);
    let svg = folder.dcel("solid figure cube.off").fine();
    // Three faces with four half-edges each; three hidden edges.
    assert_eq!(svg.matches("data-origin").count(), 12, "{svg}");
    assert_eq!(svg.matches("hidden edge").count(), 3);
    let without = folder.dcel("solid figure cube.off --no-hidden --distance 3").fine();
    assert_eq!((without.matches("data-origin").count(), without.matches("hidden edge").count()), (12, 0));
    folder.dcel("solid make torus 12 8 -o t.off").fine();
    let torus = folder.dcel("solid figure t.off").fine();
    assert!(torus.matches("data-origin").count() > 4 * 30 && torus.contains("hidden edge"));
    folder.dcel("solid figure cube.off --distance 1").fails(2, "--distance 1", "1.1");
    let dcel = folder.dcel("solid schlegel cube.off --through f2").fine();
    folder.write("seen.dcel", &dcel);
    folder.dcel("validate seen.dcel").fine();
    let info = folder.dcel("info seen.dcel --json").json();
    assert_eq!(
        (&info["mode"], &info["vertices"], &info["faces"], &info["euler"]),
        (&json!("plane"), &json!(8), &json!(6), &json!(2))
    );
    folder.dcel("solid schlegel cube.off --through f6").fails(2, "there is no f6", "there are 6 faces");
}

/// The processor time of `dcel solid subdivide --sharper` for a cylinder whose two ends have `corners` corners each.
fn seconds_of_sharp_edges(folder: &Folder, corners: u32) -> f64 {
    folder.dcel(&format!("solid make cylinder {corners} 1 -o {corners}.off")).fine();
    let line =
        format!("TIMEFORMAT=%U; time '{}' solid subdivide {corners}.off --sharper 100", env!("CARGO_BIN_EXE_dcel"));
    let output = Command::new("bash").args(["-c", &line]).current_dir(folder.path(".")).output().expect("bash");
    assert!(output.status.success(), "{output:?}");
    let told = String::from_utf8(output.stderr).unwrap();
    told.trim().lines().last().unwrap().parse().unwrap_or_else(|_| panic!("no time in {told}"))
}

/// Four times as many corners may take eight times as long; all corners again for each edge would take sixteen times.
#[test]
fn sharp_edges_are_found_in_time_of_the_corners() {
    let folder = Folder::new();
    let [small, large] = [500, 2000].map(|corners| seconds_of_sharp_edges(&folder, corners));
    assert!(large < 8.0 * small.max(0.01), "{small} s, {large} s");
}

/// A prism over an L has two faces that are not convex: cut in two, they can be written as triangles.
#[test]
fn a_face_is_cut_along_a_diagonal_inside_it() {
    let folder = Folder::empty();
    let bottom = "0 0 0\n2 0 0\n2 1 0\n1 1 0\n1 2 0\n0 2 0\n";
    let top: String = bottom.lines().map(|line| line.trim_end_matches('0').to_owned() + "1\n").collect();
    let faces =
        "6 5 4 3 2 1 0\n6 6 7 8 9 10 11\n4 0 1 7 6\n4 1 2 8 7\n4 2 3 9 8\n4 3 4 10 9\n4 4 5 11 10\n4 5 0 6 11\n";
    folder.write("l.off", &format!("OFF\n12 8 0\n{bottom}{top}{faces}"));
    folder.dcel("convert l.off l.stl").fails(2, "f0 is not convex, and stl holds triangles only", "dcel solid split");
    folder.dcel("solid support l.off 1,0,0").fails(2, "f0 has a reflex corner at v3", "dcel solid split");
    // Outside the face, beside it, along its side.
    folder.dcel("solid split l.off f0 v2 v4 -o m.off").fails(
        2,
        "the line from v2 to v4 does not lie inside f0",
        "see each other",
    );
    folder.dcel("solid split l.off f0 v1 v5 -o m.off").fails(2, "does not lie inside f0", "see each other");
    folder.dcel("solid split l.off f0 v0 v7 -o m.off").fails(2, "v7 is no corner of f0", "its corners are v");
    folder.dcel("solid split l.off f9 v0 v3 -o m.off").fails(2, "there is no face f9", "the faces are f0 to f7");
    assert_eq!(folder.dcel("solid split l.off f0 v0 v1 -o m.off").code, Some(2));
    assert_eq!(folder.dcel("solid split l.off f0 v0 v0 -o m.off").code, Some(2));
    folder.dcel("solid split l.off f0 v3 v0 -o m.off").fine();
    let told = folder.dcel("solid split m.off f1 v9 v6 -o n.off --json").json();
    assert_eq!((&told["faces"], &told["edges"]), (&json!(10), &json!(20)));
    folder.dcel("convert n.off l.stl").fine();
    assert_eq!(
        folder.dcel("solid info n.off --json").json()["volume"],
        folder.dcel("solid info l.off --json").json()["volume"]
    );
}
