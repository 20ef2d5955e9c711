//! `dcel navmesh path --cost`: what is told of a way is what it costs, also along edges between areas.

use crate::shell::Folder;
use serde_json::json;

/// An end on an edge between two areas is in both, and along the edge the cheaper one counts.
#[test]
fn along_an_edge_between_areas_the_cheaper_one_counts() {
    let folder = Folder::new();
    folder.write("fields.obj", "v 0 0\nv 2 0\nv 2 1\nv 0 1\nv 2 2\nv 0 2\nf 1 2 3 4\nf 4 3 5 6\n");
    folder.write("slope.obj", "v 0 0 0\nv 2 0 0\nv 2 1 1\nv 0 1 1\nv 2 2 0\nv 0 2 0\nf 1 2 3 4\nf 4 3 5 6\n");
    for map in ["fields.obj", "slope.obj --up z"] {
        for algorithm in ["closest", "midpoint", "aimed", "centroid"] {
            for dear in ["f1=5", "f2=5"] {
                let path = format!("navmesh path {map} --algorithm {algorithm} --cost {dear}");
                for ends in ["0.5 1 1.5 1", "0 1 2 1", "0 1 0.25 1", "2 1 1.5 1"] {
                    let told = folder.dcel(&format!("{path} {ends} --json")).json();
                    let route = &told["routes"][0];
                    assert_eq!(route["cost"], route["length"], "{path} {ends}");
                    let cheap = if dear == "f1=5" { "f2" } else { "f1" };
                    assert_eq!(route["faces"][0], json!(cheap), "{path} {ends}");
                }
            }
        }
    }
}
