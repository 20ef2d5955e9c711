//! Room for tests of your own. They are not graded, and nobody counts them.
//!
//! `cargo test --test own` runs them. The modules below are the files of `src/`, so all their functions are at hand.

#![allow(dead_code)]

#[path = "../../harness/mod.rs"]
mod harness;
#[path = "../src/lab.rs"]
mod lab;
#[path = "../src/polyhedron.rs"]
mod polyhedron;
#[path = "../src/start.rs"]
mod start;
#[path = "../src/svg.rs"]
mod svg;

/// An example: the half-edges of a cube.
#[test]
fn a_cube_has_twelve_edges() {
    let cube = start::platonic(&["cube"]).unwrap();
    assert_eq!(cube.half_edge_ids().len(), 2 * 12);
}
