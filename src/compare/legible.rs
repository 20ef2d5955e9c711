//! Whether letters can be read.
//!
//! ```text
//!   h0     letters of another colour than their halo, and than what lies below them
//!   ██     letters of the colour of their halo: a blot; so is a wide rim of their colour above them
//!   ▫      letters of less than 4 px: no reader tells h0 from h8
//!   h▉     letters of which more than half is covered, or at whose place others are written
//! ```
//!
//! The smallest letters of the kit are 7.2 px high. On a page of 400 px, a figure that is 640 px wide shows them at 4.5
//! px. Below 4 px, a digit is less than 3 px high, and no screen draws ten digits apart so.

use super::drawing::Drawing;
use super::eye::{Eye, FAINT, contrast};
use super::painting::{Coat, Lettering, Shade, Shape};
use super::pairing::distance;
use crate::plane::Point;
use std::collections::BTreeMap;

/// Letters of fewer px than this are not read.
const SMALLEST: f64 = 4.0;
/// Less contrast than this, in steps of 255, makes no letters that can be read.
const PALE: f64 = 32.0;
/// Where letters are looked at, as parts of their box along them and upwards.
const ALONG: [f64; 3] = [0.2, 0.5, 0.8];
const UP: [f64; 3] = [0.3, 0.5, 0.7];
/// Letters are covered if no more than so many of these places are seen, and written over if others stand at so many.
const SEEN: usize = 4;
const WRITTEN: usize = 7;
/// A rim of at least this part of the size of its letters fills what is open in them.
const WIDE: f64 = 0.2;

impl Lettering {
    /// Whether they have a rim that fills what is open in them.
    fn has_wide_rim(&self) -> bool {
        self.rim.as_ref().is_some_and(|rim| rim.width >= WIDE)
    }

    /// By how much they stand out on this ground: the letters from their wide rim, or they and their thin rim from the
    /// ground.
    fn contrast(&self, ground: [f64; 3]) -> f64 {
        let filled = |below: [f64; 3]| mixed(below, self.fill);
        match self.rim.as_ref() {
            Some(rim) if rim.width >= WIDE => {
                let round = mixed(ground, rim.shade);
                let inside = if rim.is_below { filled(round) } else { mixed(filled(ground), rim.shade) };
                contrast(inside, round)
            }
            rim => {
                let round = rim.map_or(0.0, |rim| contrast(mixed(ground, rim.shade), ground));
                contrast(filled(ground), ground).max(round)
            }
        }
    }

    /// What is seen of letters of the colour of their own wide rim on this ground: nothing but a blot.
    fn blot(&self, ground: [f64; 3]) -> Option<Shade> {
        self.rim.as_ref().filter(|rim| rim.width >= WIDE && self.contrast(ground) < FAINT).map(|rim| rim.shade)
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

/// What letters say, by their coats.
pub(super) struct Texts<'a>(BTreeMap<u32, &'a str>);

impl<'a> Texts<'a> {
    pub(super) fn of(drawing: &'a Drawing) -> Self {
        let all = drawing.names.iter().flat_map(|name| name.coats.clone().map(|coat| (coat, name.text.as_str())));
        Self(all.collect())
    }

    /// Whether two texts say the same.
    fn are_same(&self, a: u32, b: u32) -> bool {
        self.0.get(&a).is_some_and(|text| self.0.get(&b) == Some(text))
    }
}

impl Eye<'_> {
    /// Whether letters can be read: they are large enough, have another colour than what lies below them and than their
    /// halo, and no more than half of them is covered.
    pub(super) fn is_read(&mut self, i: u32) -> bool {
        let painting = self.painting;
        let coat = &painting.coats[i as usize];
        self.look(coat.middle());
        if self.is_tired() {
            return true;
        }
        let is_there = self.letters.contains(&i) || self.stack.contains(&i);
        let mut ground = self.colour(|j, _| j < i);
        // A copy of the text below it is its halo, if it is a blot.
        for &j in self.letters.iter().filter(|&&j| j < i && is_copy([coat, &painting.coats[j as usize]])) {
            if let Some(halo) = painting.lettering.get(&j).and_then(|letters| letters.blot(ground)) {
                ground = mixed(ground, halo);
            }
        }
        let lettering = painting.lettering.get(&i);
        let strength = match lettering {
            Some(letters) if letters.size < SMALLEST => return false,
            Some(letters) => letters.contrast(ground),
            None => contrast(mixed(ground, (coat.colour, coat.alpha)), ground),
        };
        let mut seen = 0;
        for p in places(coat) {
            self.look(p);
            let above = self.stack.iter().filter(|&&j| j > i).map(|&j| 1.0 - painting.coats[j as usize].alpha);
            let shows = painting.cut_off(coat, p).is_none() && strength * above.product::<f64>() >= PALE;
            seen += usize::from(shows);
        }
        is_there && seen > SEEN
    }

    /// Whether another text is written at the place of letters: over them, or below them if they have no halo.
    pub(super) fn is_written_over(&mut self, i: u32, texts: &Texts<'_>) -> bool {
        let painting = self.painting;
        let coat = &painting.coats[i as usize];
        let has_halo = painting.lettering.get(&i).is_some_and(Lettering::has_wide_rim);
        let mut written = 0;
        for p in places(coat) {
            if self.is_tired() {
                return false;
            }
            self.look(p);
            let ground = self.colour(|j, _| j < i);
            let hides = |&j: &u32| {
                let other = &painting.coats[j as usize];
                let is_seen =
                    j > i || !has_halo && contrast(mixed(ground, (other.colour, other.alpha)), ground) >= PALE;
                j != i && is_seen && other.alpha > 0.5 && is_copy([coat, other]) && !texts.are_same(i, j)
            };
            written += usize::from(self.letters.iter().any(hides));
        }
        written >= WRITTEN
    }
}

/// Where letters are looked at: places in their box, which may be turned.
fn places(coat: &Coat) -> Vec<Point> {
    let Shape::Area(area) = &coat.shape else { return vec![coat.middle()] };
    let mut corners = area.points();
    let (Some(a), Some(b), Some(_), Some(d)) = (corners.next(), corners.next(), corners.next(), corners.next()) else {
        return vec![coat.middle()];
    };
    let at =
        |s: f64, t: f64| Point::new(a.x + s * (b.x - a.x) + t * (d.x - a.x), a.y + s * (b.y - a.y) + t * (d.y - a.y));
    UP.iter().flat_map(|&t| ALONG.map(|s| at(s, t))).collect()
}
