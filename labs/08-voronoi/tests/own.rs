//! Room for tests of your own. They are not graded, and nobody counts them.
//!
//! `cargo test --test own` runs them. The modules below are the files of `src/`, so all their functions are at hand.

#![allow(dead_code)]

#[path = "../../04-half-edge/src/dcel.rs"]
mod dcel;
#[path = "../src/frame.rs"]
mod frame;
#[path = "../../harness/mod.rs"]
mod harness;
#[path = "../src/lab.rs"]
mod lab;
#[path = "../../predicates/mod.rs"]
mod predicates;
#[path = "../../04-half-edge/src/start.rs"]
mod start;
#[path = "../../04-half-edge/src/svg.rs"]
mod svg;
#[path = "../src/walks.rs"]
mod walks;

/// An example: a triangle with its outer face.
#[test]
fn a_triangle_has_three_half_edges_on_each_side() {
    let triangle = start::triangles(&["0", "0", "4", "0", "3", "3", "/", "0", "1", "2"]).unwrap();
    for f in 0..triangle.faces.len() {
        assert_eq!(triangle.round_face(f).len(), 3);
    }
}
