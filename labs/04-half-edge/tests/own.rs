//! Room for tests of your own. They are not graded, and nobody counts them.
//!
//! `cargo test --test own` runs them. The modules below are the files of `src/`, so all their functions are at hand.

#![allow(dead_code)]

#[path = "../src/dcel.rs"]
mod dcel;
#[path = "../../harness/mod.rs"]
mod harness;
#[path = "../src/lab.rs"]
mod lab;
#[path = "../src/pen.rs"]
mod pen;
#[path = "../src/start.rs"]
mod start;
#[path = "../src/svg.rs"]
mod svg;

/// An example: the rectangle that the lab starts from.
#[test]
fn every_twin_of_the_rectangle_has_the_other_one_as_its_twin() {
    let rectangle = start::rectangle(&[]).unwrap();
    for h in 0..rectangle.half_edges.len() {
        assert_eq!(rectangle.twin(rectangle.twin(h)), h);
        assert_ne!(rectangle.face(h), rectangle.face(rectangle.twin(h)));
    }
}
