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
    dcel_lab::graded("11-support", folder, work, test);
}

#[test]
fn add_vertex() {
    graded("add_vertex");
}

#[test]
fn add_face() {
    graded("add_face");
}

#[test]
fn remove_face() {
    graded("remove_face");
}

#[test]
fn remove_vertex() {
    graded("remove_vertex");
}

#[test]
fn many_edits() {
    graded("many_edits");
}

#[test]
fn support_by_scan() {
    graded("support_by_scan");
}

#[test]
fn climb() {
    graded("climb");
}

#[test]
fn support() {
    graded("support");
}

#[test]
fn climb_svg() {
    graded("climb_svg");
}
