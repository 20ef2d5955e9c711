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
    dcel_lab::graded("10-polyhedra", folder, work, test);
}

#[test]
fn euler() {
    graded("euler");
}

#[test]
fn missing_edges() {
    graded("missing_edges");
}

#[test]
fn vertices_around() {
    graded("vertices_around");
}

#[test]
fn vertices_around_large() {
    graded("vertices_around_large");
}

#[test]
fn regular() {
    graded("regular");
}

#[test]
fn winged_edges() {
    graded("winged_edges");
}

#[test]
fn dual() {
    graded("dual");
}

#[test]
fn deficit_angle() {
    graded("deficit_angle");
}

#[test]
fn dihedral_angle() {
    graded("dihedral_angle");
}

#[test]
fn genus() {
    graded("genus");
}

#[test]
fn merge_faces() {
    graded("merge_faces");
}

#[test]
fn is_genus_0() {
    graded("is_genus_0");
}

#[test]
fn picture() {
    graded("picture");
}
