//! Whether letters can be read.
//!
//! ```text
//!   h0     letters of another colour than their halo, and than what lies below them
//!   ██     letters of the colour of their halo: a blot; so is a wide rim of their colour above them
//!   ▫      letters of less than 4 px: no reader tells h0 from h8
//! ```
//!
//! The smallest letters of the kit are 7.2 px high. On a page of 400 px, a figure that is 640 px wide shows them at 4.5
//! px. Below 4 px, a digit is less than 3 px high, and no screen draws ten digits apart so.

use super::eye::{Eye, FAINT, contrast};
use super::painting::{Coat, Lettering, Shade, Shape};
use super::pairing::distance;

/// Letters of fewer px than this are not read.
const SMALLEST: f64 = 4.0;
/// A rim of at least this part of the size of its letters fills what is open in them.
const WIDE: f64 = 0.2;

impl Lettering {
    /// Whether they have the colour of their own wide rim on this ground: nothing but a blot is seen.
    fn is_blot(&self, ground: [f64; 3]) -> bool {
        let Some(rim) = self.rim.as_ref().filter(|rim| rim.width >= WIDE && self.fill.1 > 0.0) else { return false };
        let round = mixed(ground, rim.shade);
        let inside = mixed(if rim.is_below { round } else { ground }, self.fill);
        contrast(inside, round) < FAINT
    }

    /// Whether they stand out from this ground: by themselves, or by a rim.
    fn stands_out(&self, ground: [f64; 3]) -> bool {
        let differs = |from: [f64; 3], shade: Shade| contrast(mixed(from, shade), from) >= FAINT;
        let rim = self.rim.as_ref();
        differs(ground, self.fill) || rim.is_some_and(|rim| differs(ground, rim.shade))
    }
}

/// What is seen of a colour over another one.
fn mixed(below: [f64; 3], (colour, alpha): Shade) -> [f64; 3] {
    [0, 1, 2].map(|c| below[c] + alpha * (colour[c] - below[c]))
}

/// Whether two texts stand at the same place: a text and a copy of it that is its halo.
pub(super) fn is_copy([a, b]: [&Coat; 2]) -> bool {
    distance(a.middle(), b.middle()) <= 0.5 * a.thickness().min(b.thickness())
}

impl Eye<'_> {
    /// Whether letters can be read in the middle of their box: they are large enough, have another colour than what lies
    /// below them and than their halo, and no area covers the box.
    pub(super) fn is_read(&mut self, i: u32) -> bool {
        let painting = self.painting;
        let coat = &painting.coats[i as usize];
        let [low, high] = coat.corners();
        self.look(coat.middle());
        if self.is_tired() {
            return true;
        }
        let covers = |&j: &u32| {
            let above = &painting.coats[j as usize];
            let is_opaque = j > i && above.alpha > 0.5 && !matches!(above.shape, Shape::Stroke(..));
            is_opaque && above.covers(low).0 && above.covers(high).0
        };
        let is_there = self.letters.contains(&i) || self.stack.contains(&i);
        let mut ground = self.colour(|j, _| j < i);
        // A copy of the text below it is its halo, if it is a blot.
        for &j in self.letters.iter().filter(|&&j| j < i) {
            let below = &painting.coats[j as usize];
            if is_copy([coat, below]) && painting.lettering.get(&j).is_some_and(|letters| letters.is_blot(ground)) {
                ground = mixed(ground, (below.colour, below.alpha));
            }
        }
        let is_legible = match painting.lettering.get(&i) {
            Some(letters) => letters.size >= SMALLEST && !letters.is_blot(ground) && letters.stands_out(ground),
            None => contrast(mixed(ground, (coat.colour, coat.alpha)), ground) >= FAINT,
        };
        is_there && is_legible && !self.stack.iter().any(covers)
    }
}
