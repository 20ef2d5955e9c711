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
    dcel_lab::graded("05-triangle-list", folder, work, test);
}

#[test]
fn check_faces_index() {
    graded("check_faces_index");
}

#[test]
fn check_faces_corners() {
    graded("check_faces_corners");
}

#[test]
fn add_face_records() {
    graded("add_face_records");
}

#[test]
fn add_face_links() {
    graded("add_face_links");
}

#[test]
fn match_twins() {
    graded("match_twins");
}

#[test]
fn match_twins_refused() {
    graded("match_twins_refused");
}

#[test]
fn close_border_half_edges() {
    graded("close_border_half_edges");
}

#[test]
fn close_border_links() {
    graded("close_border_links");
}

#[test]
fn close_border_refused() {
    graded("close_border_refused");
}

#[test]
fn from_faces() {
    graded("from_faces");
}

#[test]
fn from_faces_large() {
    graded("from_faces_large");
}

#[test]
fn structure_svg() {
    graded("structure_svg");
}
