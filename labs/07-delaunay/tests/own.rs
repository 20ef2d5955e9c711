//! Room for tests of your own. They are not graded, and nobody counts them.
//!
//! `cargo test --test own` runs them. The modules below are the files of `src/`, so all their functions are at hand.

#![allow(dead_code)]

#[path = "../src/circle.rs"]
mod circle;
#[path = "../../04-half-edge/src/dcel.rs"]
mod dcel;
#[path = "../../harness/mod.rs"]
mod harness;
#[path = "../src/lab.rs"]
mod lab;
#[path = "../src/mesh.rs"]
mod mesh;
#[path = "../../predicates/mod.rs"]
mod predicates;
#[path = "../src/refusal.rs"]
mod refusal;
#[path = "../../04-half-edge/src/start.rs"]
mod start;
#[path = "../src/svg.rs"]
mod svg;
#[path = "../../08-voronoi/src/walks.rs"]
mod walks;

/// An example: the sites of the handout have 14 triangles, and the outer face.
#[test]
fn twelve_sites_have_fourteen_triangles() {
    let sites = mesh::sites(&[]).unwrap();
    assert_eq!((sites.vertices.len(), sites.half_edges.len(), sites.faces.len()), (12, 50, 15));
}
