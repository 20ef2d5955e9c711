//! Room for tests of your own. They are not graded, and nobody counts them.
//!
//! `cargo test --test own` runs them. The modules below are the files of `src/`, so all their functions are at hand.

#![allow(dead_code)]

#[path = "../src/dcel.rs"]
mod dcel;
#[path = "../src/edge_map.rs"]
mod edge_map;
#[path = "../../harness/mod.rs"]
mod harness;
#[path = "../src/height.rs"]
mod height;
#[path = "../src/lab.rs"]
mod lab;
#[path = "../src/start.rs"]
mod start;
#[path = "../../04-half-edge/src/svg.rs"]
mod svg;

/// An example: the edge map of the gem knows each half-edge by its two ends.
#[test]
fn the_edge_map_leads_to_half_edges_that_start_and_end_there() {
    let gem = start::gem(&[]).unwrap();
    for (&(from, to), &h) in &gem.edges {
        assert_eq!((gem.origin(h), gem.origin(gem.twin(h))), (from, to));
    }
}
