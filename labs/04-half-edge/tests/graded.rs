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
    dcel_lab::graded("04-half-edge", folder, work, test);
}

#[test]
fn face_walk() {
    graded("face_walk");
}

#[test]
fn face_vertices() {
    graded("face_vertices");
}

#[test]
fn destination_by_twin() {
    graded("destination_by_twin");
}

#[test]
fn destination_by_next() {
    graded("destination_by_next");
}

#[test]
fn vertex_star() {
    graded("vertex_star");
}

#[test]
fn split_face_0_legal() {
    graded("split_face_0_legal");
}

#[test]
fn split_face_1_new_face() {
    graded("split_face_1_new_face");
}

#[test]
fn split_face_2_half_edges() {
    graded("split_face_2_half_edges");
}

#[test]
fn split_face_3_links() {
    graded("split_face_3_links");
}

#[test]
fn split_face_4_faces() {
    graded("split_face_4_faces");
}

#[test]
fn split_face_5_representatives() {
    graded("split_face_5_representatives");
}

#[test]
fn split_face_sequences() {
    graded("split_face_sequences");
}

#[test]
fn split_in_half_1_vertex() {
    graded("split_in_half_1_vertex");
}

#[test]
fn split_in_half_2_half_edges() {
    graded("split_in_half_2_half_edges");
}

#[test]
fn split_in_half_3_links() {
    graded("split_in_half_3_links");
}

#[test]
fn split_in_half_sequences() {
    graded("split_in_half_sequences");
}

#[test]
fn drawing() {
    graded("drawing");
}

#[test]
fn drawing_svg() {
    graded("drawing_svg");
}
