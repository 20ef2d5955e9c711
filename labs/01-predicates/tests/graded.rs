//! The graded tests, one for each line of the table of points in the handout.
//!
//! They take your file as it will be handed in, build it with the given ones, give the program cases and look at what
//! it answers; your code is not linked to them. The program is graded once, and each test says what came of it.
//! `LAB_SEED=17` gives the random cases the seed 17.

use std::path::Path;

/// Panics with the feedback, unless the test of that name has passed.
#[track_caller]
fn graded(test: &str) {
    let (folder, work) = (Path::new(env!("CARGO_MANIFEST_DIR")), Path::new(env!("CARGO_TARGET_TMPDIR")));
    dcel_lab::graded("01-predicates", folder, work, test);
}

#[test]
fn parallelogram_area() {
    graded("parallelogram_area");
}

#[test]
fn triangle_area() {
    graded("triangle_area");
}

#[test]
fn turn() {
    graded("turn");
}

#[test]
fn in_triangle() {
    graded("in_triangle");
}

#[test]
fn in_circle() {
    graded("in_circle");
}

#[test]
fn sign_of_sum() {
    graded("sign_of_sum");
}

#[test]
fn orient2d_exact() {
    graded("orient2d_exact");
}

#[test]
fn filter() {
    graded("filter");
}

#[test]
fn orient2d() {
    graded("orient2d");
}

#[test]
fn wrong_signs() {
    graded("wrong_signs");
}
