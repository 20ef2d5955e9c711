//! The graded tests, one for each line of the table of points in the handout.
//!
//! They take your file as it will be handed in, build it with the given ones, give the program cases and look at what
//! it answers; your code is not linked to them.

use std::path::Path;

/// Panics with the feedback, unless the test of that name has passed.
#[track_caller]
fn graded(test: &str) {
    judge::graded(Path::new(env!("CARGO_MANIFEST_DIR")), Path::new(env!("CARGO_TARGET_TMPDIR")), test);
}

#[test]
fn small() {
    graded("small");
}

#[test]
fn large() {
    graded("large");
}
