//! Room for tests of your own. They are not graded, and nobody counts them.
//!
//! `cargo test --test own` runs them. The modules below are the files of `src/`, so all their functions are at hand.

#![allow(dead_code)]

#[path = "../../04-half-edge/src/dcel.rs"]
mod dcel;
#[path = "../../harness/mod.rs"]
mod harness;
#[path = "../src/lab.rs"]
mod lab;
#[path = "../src/refusal.rs"]
mod refusal;
#[path = "../src/start.rs"]
mod start;
#[path = "../../04-half-edge/src/svg.rs"]
mod svg;

/// An example: what a refusal says.
#[test]
fn a_refusal_names_the_edge() {
    let refusal = refusal::Refusal::EdgeTwice { from: 0, to: 3 };
    assert_eq!(refusal.to_string(), "the edge from vertex 0 to vertex 3 comes twice");
}
