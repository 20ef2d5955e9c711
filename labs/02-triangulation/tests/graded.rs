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
    dcel_lab::graded("02-triangulation", folder, work, test);
}

#[test]
fn corners_of() {
    graded("corners_of");
}

#[test]
fn split_refuses() {
    graded("split_refuses");
}

#[test]
fn split() {
    graded("split");
}

#[test]
fn is_diagonal() {
    graded("is_diagonal");
}

#[test]
fn is_ear() {
    graded("is_ear");
}

#[test]
fn triangulate() {
    graded("triangulate");
}

#[test]
fn triangulation_svg() {
    graded("triangulation_svg");
}
