//! Promise: `dcel delaunay` and `dcel voronoi` tell what they made, write it, draw it, and name what they refuse.

use crate::shell::Folder;
use serde_json::json;

/// Six sites, one of them twice.
const SITES: &str = "# x y\n0 0\n4 0\n4 3\n0 3\n2 1\n4 0\n";
/// A kite with its long diagonal.
const KITE: &str = "v 0 0\nv 3 -1\nv 6 0\nv 3 1\nf 1 2 3\nf 1 3 4\n";

#[test]
fn points_become_triangles_that_other_commands_read() {
    let folder = Folder::new();
    folder.write("sites.xy", SITES);
    let told = folder.dcel("delaunay sites.xy");
    assert!(told.err.contains("note: points that repeat earlier ones, 1: 5 = 1"), "{told:?}");
    let text = told.fine();
    assert!(text.contains("triangles       4") && text.contains("outline         4 half-edges of f0"), "{text}");
    let report = folder.dcel("delaunay sites.xy --json").json();
    assert_eq!((&report["points"], &report["vertices"], &report["edges"]), (&json!(6), &json!(5), &json!(8)));
    assert_eq!(report["repeated"], json!([{"point": 5, "repeats": 1}]));
    folder.dcel("delaunay sites.xy -o out.dcel --figure out.svg --circles").fine();
    let info = folder.dcel("info out.dcel --json").json();
    assert_eq!((&info["faces"], &info["valid"]), (&json!(5), &json!(true)));
    assert_eq!(folder.read("out.svg").matches("circle of f").count(), 4);
    assert_eq!(folder.dcel("delaunay sites.xy -o -").fine(), folder.read("out.dcel"));
    // The points of a structure, and points from standard input.
    let report = folder.dcel("delaunay square.obj --json").json();
    assert_eq!((&report["triangles"], &report["constrained"]), (&json!(2), &json!(0)));
    let told = folder.dcel_with("0,0\n1,1\n2,2\n", "delaunay - --json");
    assert!(told.err.contains("note: all points lie on one line: this is a path"), "{told:?}");
    assert_eq!(told.json()["edges"], json!(2));
}

#[test]
fn edges_stay_or_are_flipped() {
    let folder = Folder::new();
    folder.write("kite.obj", KITE);
    let free = folder.dcel("delaunay kite.obj --json").json();
    assert_eq!((&free["not_delaunay"], &free["flips"]), (&json!(0), &json!(null)));
    let fixed = folder.dcel("delaunay kite.obj --constrained --json").json();
    assert_eq!((&fixed["not_delaunay"], &fixed["constrained"]), (&json!(1), &json!(5)));
    let flipped = folder.dcel("delaunay kite.obj --flips --json").json();
    assert_eq!((&flipped["not_delaunay"], &flipped["flips"]), (&json!(0), &json!(1)));
    // A garden with a hole: the triangles outside of it are hole faces.
    let garden = folder.dcel("delaunay garden.json --constrained --figure garden.svg --json").json();
    assert_eq!((&garden["vertices"], &garden["constrained"]), (&json!(11), &json!(11)));
    assert!(garden["hole_faces"].as_u64().expect("a number") >= 2, "{garden}");
    assert_eq!(folder.read("garden.svg").matches("stays</title>").count(), 11);
}

#[test]
fn cells_of_nearest_sites() {
    let folder = Folder::new();
    folder.write("sites.xy", SITES);
    let report = folder.dcel("voronoi sites.xy --json").json();
    assert_eq!((&report["sites"], &report["corners"], &report["unbounded_edges"]), (&json!(5), &json!(4), &json!(4)));
    assert_eq!(report["box"], json!([-1.0, -1.0, 5.0, 4.0]));
    assert_eq!(report["cells"].as_array().expect("a list").len(), 5);
    folder.dcel("voronoi sites.xy --box -10 -10 10 10 -o cells.dcel --figure cells.svg --delaunay").fine();
    let info = folder.dcel("info cells.dcel --json").json();
    assert_eq!((&info["faces"], &info["valid"]), (&json!(6), &json!(true)));
    let svg = folder.read("cells.svg");
    assert_eq!((svg.matches("of the triangulation</title>").count(), svg.matches(">site v").count()), (8, 5));
    folder.dcel("voronoi sites.xy --rays --figure rays.svg").fine();
    assert_eq!(folder.read("rays.svg").matches("between v").count(), 7, "one of the 8 edges lies outside");
}

/// A flag that can do nothing with points is refused, so that nobody believes it did.
#[test]
fn flags_that_mean_nothing_to_points_are_refused() {
    let folder = Folder::new();
    folder.write("sites.xy", "0 0\n4 0\n0 3\n");
    folder.write("cross.segments", "0 0 4 2\n0 2 4 0\n");
    for command in ["delaunay sites.xy", "voronoi sites.xy", "film hull sites.xy -o f.svg"] {
        for flag in ["--plane", "--drop-degenerate-rings", "--full-check", "--mend", "--orient"] {
            let told = folder.dcel(&format!("{command} {flag}"));
            told.fails(2, &format!("{flag} cannot be used here: only the points"), &format!("leave {flag} out"));
        }
        let told = folder.dcel(&format!("{command} --object roads"));
        told.fails(2, "sites.xy: --object cannot be used on plain points", "leave --object out");
    }
    let told = folder.dcel("delaunay garden.json --object Garden");
    told.fails(2, "garden.json: --object cannot be used on geojson: only TopoJSON", "leave --object out");
    let told = folder.dcel("film sweep cross.segments --object roads -o f.svg");
    told.fails(2, "--object cannot be used on segments", "leave --object out");
    folder.dcel("figure --records --mend -o r.svg").fails(
        2,
        "--mend cannot be used with --records",
        "leave --mend out",
    );
}

#[test]
fn what_cannot_be_done_is_named() {
    let folder = Folder::new();
    folder.write("sites.xy", SITES);
    folder.write("bad.xy", "0 0\n1 two\n");
    folder.write("close.xy", "# close\n1 0\n1.0000000000000002 0\n");
    folder.dcel("delaunay bad.xy").fails(2, "bad.xy:2:3: `two` is not a number", "");
    folder.dcel("delaunay sites.xy -o sites.xy").fails(2, "this is the input itself", "another name");
    folder.dcel("delaunay sites.xy -o out").fails(2, "the file name does not say which format", ".dcel");
    folder.dcel("delaunay sites.xy --circles").fails(2, "", "--figure");
    folder.dcel("delaunay cube.off --flips").fails(2, "cube.off: a surface in space", "--plane");
    folder.dcel("delaunay sites.xy --constrained --flips").fails(2, "", "");
    folder.dcel("voronoi sites.xy --box 0 0 4 3").fails(2, "sites.xy:2: v0 at (0, 0) does not lie inside", "");
    folder.dcel("voronoi sites.xy --box 9 9 1 1").fails(2, "has no inside", "");
    folder.dcel("voronoi close.xy --box 0 -1 3 1").fails(2, "close.xy:2: v0 and v1 are so close that doubles", "");
    folder.write("empty.xy", "# nothing\n");
    folder.dcel("voronoi empty.xy").fails(2, "there is no site", "");
}
