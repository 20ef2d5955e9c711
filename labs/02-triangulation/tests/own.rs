//! Room for tests of your own. They are not graded, and nobody counts them.
//!
//! `cargo test --test own` runs them. The modules below are the files of `src/`, so all their functions are at hand.

#![allow(dead_code)]

#[path = "../../harness/mod.rs"]
mod harness;
#[path = "../src/lab.rs"]
mod lab;
#[path = "../../01-predicates/src/point.rs"]
mod point;
#[path = "../src/polygon.rs"]
mod polygon;
#[path = "../src/predicates.rs"]
mod predicates;
#[path = "../src/start.rs"]
mod start;
#[path = "../src/svg.rs"]
mod svg;

/// An example: the corners of a square follow each other.
#[test]
fn who_goes_on_and_comes_back_has_not_moved() {
    let square = start::polygon(&["0", "0", "4", "0", "4", "4", "0", "4"]).unwrap();
    for corner in 0..4 {
        assert_eq!(square.prev(square.next(corner)), corner);
    }
}
