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
#[path = "../src/svg.rs"]
mod svg;
#[path = "../src/walks.rs"]
mod walks;

/// An example: the walk round a vertex that is given.
#[test]
fn a_loop_turns_to_itself() {
    let mut one = dcel::Dcel::default();
    let v = one.new_vertex(0.0, 0.0);
    let [a, b] = [0; 2].map(|_| one.new_half_edge(v));
    one.make_twin(a, b);
    one.make_next(a, b);
    one.make_next(b, a);
    assert_eq!(one.ccw(a), a);
}
