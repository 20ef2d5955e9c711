//! Lines that dashes leave out in part, or nearly whole: they are no edges, but their ink is seen.
//!
//! ```text
//!   ●▪▪                ●     an edge of the reference that is drawn so is hidden;
//!   ●      ▪      ▪    ●     one that the reference does not have is told if a dash of it shows beyond the circles at its
//!                            ends, unless the reference has such a line there, too
//! ```

use super::eye::{Eye, Way};
use super::painting::Shape;
use super::pairing::{Places, distance};
use crate::plane::Point;
use std::collections::BTreeSet;

/// Where a dash is looked at, as parts of it.
const ALONG: [f64; 5] = [0.1, 0.3, 0.5, 0.7, 0.9];

/// Such lines of a reference.
pub(super) struct Sparse {
    places: Places,
    pairs: BTreeSet<[u32; 2]>,
    reach: f64,
}

impl Sparse {
    /// Lines by their ends; `reach` is how far one may lie from its place.
    pub(super) fn new(lines: &[[Point; 2]], reach: f64) -> Self {
        let mut out = Self { places: Places::new(reach), pairs: BTreeSet::new(), reach };
        for ends in lines {
            let [a, b] = ends.map(|p| out.places.near_or_add(p, reach));
            out.pairs.insert([a.min(b), a.max(b)]);
        }
        out
    }

    /// Whether there is a line with these ends.
    pub(super) fn has(&self, ends: [Point; 2]) -> bool {
        let [a, b] = ends.map(|p| self.places.near(p, self.reach));
        a.zip(b).is_some_and(|(a, b)| self.pairs.contains(&[a.min(b), a.max(b)]))
    }
}

impl Eye<'_> {
    /// Whether one of some dashes of a line is seen between the circles at its ends. `dashes` are coats, from the first to
    /// before the last.
    pub(super) fn any_dash(&mut self, [a, b]: [Point; 2], discs: [f64; 2], dashes: [u32; 2]) -> bool {
        let way = Way::new([a, b], discs, 0.0);
        (dashes[0]..dashes[1]).any(|i| {
            let Shape::Stroke([p, q], _) = self.painting.coats[i as usize].shape else { return false };
            let at = ALONG.map(|t| Point::new(p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)));
            at.iter().any(|&at| way.is_open(distance(a, at)) && self.shows(i, &[at], &[]))
        })
    }
}
