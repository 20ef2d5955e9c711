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
    dcel_lab::graded("03-convex-hulls", folder, work, test);
}

#[test]
fn gift_wrapping() {
    graded("gift_wrapping");
}

#[test]
fn gift_wrapping_odd() {
    graded("gift_wrapping_odd");
}

#[test]
fn graham_scan() {
    graded("graham_scan");
}

#[test]
fn graham_scan_odd() {
    graded("graham_scan_odd");
}

#[test]
fn graham_scan_large() {
    graded("graham_scan_large");
}

#[test]
fn tangents() {
    graded("tangents");
}

#[test]
fn tangents_odd() {
    graded("tangents_odd");
}

#[test]
fn common_tangents() {
    graded("common_tangents");
}

#[test]
fn merge() {
    graded("merge");
}

#[test]
fn hull_by_halves() {
    graded("hull_by_halves");
}

#[test]
fn picture() {
    graded("picture");
}
