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
    dcel_lab::graded("07-delaunay", folder, work, test);
}

#[test]
fn is_legal() {
    graded("is_legal");
}

#[test]
fn can_flip() {
    graded("can_flip");
}

#[test]
fn flip_1_origins() {
    graded("flip_1_origins");
}

#[test]
fn flip_2_links() {
    graded("flip_2_links");
}

#[test]
fn flip_3_faces() {
    graded("flip_3_faces");
}

#[test]
fn delaunify() {
    graded("delaunify");
}

#[test]
fn delaunify_large() {
    graded("delaunify_large");
}

#[test]
fn smallest_angle() {
    graded("smallest_angle");
}

#[test]
fn picture() {
    graded("picture");
}
