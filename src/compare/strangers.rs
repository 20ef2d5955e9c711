//! Faces that a drawing has and its reference has not, counted: where it is placed best, they are fewest.

use super::graph::Matched;
use super::rings;
use super::sketch::{Outline, Sketch};
use std::collections::BTreeSet;

/// How many faces and filled outlines have no partner, whichever way they run. None if the reference fills nothing.
pub(super) fn strangers(expected: &Sketch, found: &Sketch, matched: &Matched) -> usize {
    let free = |ring: Vec<u32>| rings::canonical(&ring).min(rings::reversed(&ring));
    let mine: BTreeSet<Vec<u32>> = expected.outlines.iter().map(|outline| free(outline.ring.clone())).collect();
    if mine.is_empty() {
        return 0;
    }
    let welcome: BTreeSet<Vec<u32>> = expected.welcome.iter().map(|ring| free(ring.clone())).collect();
    let count = expected.graph.points.len() as u32;
    let theirs: BTreeSet<Vec<u32>> =
        found.outlines.iter().map(|outline| free(translated(outline, matched, count))).collect();
    let strange = theirs.difference(&mine).filter(|ring| !welcome.contains(*ring)).count();
    mine.difference(&theirs).count() + strange
}

/// An outline by the points of the reference; further ones have greater numbers than those, of which there are `count`.
pub(super) fn translated(outline: &Outline, matched: &Matched, count: u32) -> Vec<u32> {
    outline.ring.iter().map(|&m| matched.to_expected[m as usize].unwrap_or(count + m)).collect()
}
