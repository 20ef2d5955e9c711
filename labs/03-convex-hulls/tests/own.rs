//! Room for tests of your own. They are not graded, and nobody counts them.
//!
//! `cargo test --test own` runs them. The modules below are the files of `src/`, so all their functions are at hand.

#![allow(dead_code)]

#[path = "../../harness/mod.rs"]
mod harness;
#[path = "../src/lab.rs"]
mod lab;
#[path = "../src/polygons.rs"]
mod polygons;
#[path = "../../predicates/mod.rs"]
mod predicates;
#[path = "../src/start.rs"]
mod start;
#[path = "../../04-half-edge/src/svg.rs"]
mod svg;

use polygons as dcel;

/// An example: a polygon that the lab starts from.
#[test]
fn next_and_prev_of_a_triangle_undo_each_other() {
    let triangle = start::polygons(&["0", "0", "4", "0", "3", "3"]).unwrap();
    for c in 0..triangle.corners.len() {
        assert_eq!(triangle.prev(triangle.next(c)), c);
        assert_eq!(triangle.next(triangle.prev(c)), c);
    }
}
