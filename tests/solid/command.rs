//! `dcel solid` from the shell.

use super::shell::{CUBE, Folder};
use serde_json::json;

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
    folder.dcel("solid support cube.off 0,0,1 --from v9").fails(2, "--from: v9 does not exist", "");

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
        "90.0000 to 90.0000 degrees",
        "720.0000 in all",
        "area            6.0",
        "volume          1.0",
        "convex          yes",
    ] {
        assert!(text.contains(line), "{line} in {text}");
    }
    let tables = folder.dcel("solid info cube.off --winged").fine();
    let rows: Vec<&str> = tables.lines().collect();
    assert_eq!(rows.len(), 3 + 3 + 2 + 8 + 6 + 24);
    assert!(tables.contains("Half-edge list\nid   o    w_i  w_o  v   f\nh0   h1   h6   h2   v3  f0\n"), "{tables}");
    folder.write("plan.wkt", "POLYGON ((0 0, 1 0, 0 1, 0 0))\n");
    folder.dcel("solid info plan.wkt").fails(2, "holds a structure of the plane", "obj, off, ply and stl");
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
    assert!(told.err.contains("1 of 6 faces were wound against the rest and were turned round"), "{told:?}");
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
    folder.dcel("solid schlegel cube.off --through f6").fails(2, "f6 does not exist", "");
}
