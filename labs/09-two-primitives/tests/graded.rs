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
    dcel_lab::graded("09-two-primitives", folder, work, test);
}

#[test]
fn seeds() {
    graded("seeds");
}

#[test]
fn split_vertex() {
    graded("split_vertex");
}

#[test]
fn split_face() {
    graded("split_face");
}

#[test]
fn large() {
    graded("large");
}

#[test]
fn euler() {
    graded("euler");
}

#[test]
fn genus() {
    graded("genus");
}

#[test]
fn pole() {
    graded("pole");
}

#[test]
fn divide() {
    graded("divide");
}

#[test]
fn fill() {
    graded("fill");
}

#[test]
fn grid() {
    graded("grid");
}

#[test]
fn torus() {
    graded("torus");
}

#[test]
fn extrude() {
    graded("extrude");
}

#[test]
fn cylinder() {
    graded("cylinder");
}

#[test]
fn cube() {
    graded("cube");
}

#[test]
fn cone() {
    graded("cone");
}

#[test]
fn sphere() {
    graded("sphere");
}

#[test]
fn revolve() {
    graded("revolve");
}

#[test]
fn picture() {
    graded("picture");
}
