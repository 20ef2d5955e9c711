//! Plain areas that lie over an edge: they leave a gap in it, and nothing says why.
//!
//! ```text
//!   ●────███────●      a square, a triangle or another convex polygon, too large for a letter, with no letters in it,
//!                      clear of both ends and of another colour than the edge: a stretch of that is hidden
//! ```

use super::super::painting::{Area, Coat, Part, Shape};
use super::super::pairing::distance;
use super::gaps::Way;
use super::{Eye, FAINT, contrast};

/// A polygon is too large for a letter if its longest side is longer than this part of the drawing; with more sides it is
/// none that is looked at.
const LARGE: f64 = 0.034;
const SIDES: usize = 8;
/// It is a background, and no block, if it is larger than this part of the drawing.
const WHOLE: f64 = 0.5;
/// A gap is long from this part of the drawing on, and is measured in so many steps.
const LONG: f64 = 0.02;
const STEPS: u32 = 8;

impl Eye<'_> {
    /// Whether a block leaves a long gap in an edge.
    pub(super) fn is_blocked(&mut self, way: &Way) -> bool {
        let span = self.span;
        let blocks = self.blocks.take().unwrap_or_else(|| blocks(self));
        let (step, mut far, mut found) = (0.5 * LARGE * span, way.discs[0] + 0.5 * LONG * span, false);
        while !blocks.is_empty() && !found && way.is_open(far) && !self.is_tired() {
            found = self.is_blocked_at(way, far, &blocks);
            far += step;
        }
        self.blocks = Some(blocks);
        found
    }

    /// Whether a block lies over an edge so far from its start.
    fn is_blocked_at(&mut self, way: &Way, far: f64, blocks: &[u32]) -> bool {
        self.work += 1;
        self.look(way.at(far));
        let here: Vec<u32> = self.stack.iter().rev().copied().filter(|i| blocks.binary_search(i).is_ok()).collect();
        here.into_iter().take(SIDES).any(|block| self.hides(block, way, far))
    }

    /// Whether a block hides an edge so far from its start.
    fn hides(&mut self, block: u32, way: &Way, far: f64) -> bool {
        let painting = self.painting;
        let coat = &painting.coats[block as usize];
        if [0.0, way.length].iter().any(|&end| coat.covers(way.at(end)).0) {
            return false;
        }
        let glance = self.glance(way, far);
        let is_below = |&i: &u32| i < block && contrast(painting.coats[i as usize].colour, coat.colour) >= FAINT;
        let is_hidden = !glance.seen && !glance.own.coats.is_empty() && glance.own.coats.iter().all(is_below);
        is_hidden && self.is_long_gap(way, far) && !self.holds_letters(block)
    }

    /// Whether an edge that is not seen so far from its start is not seen for long.
    fn is_long_gap(&mut self, way: &Way, far: f64) -> bool {
        let step = LONG * self.span / f64::from(STEPS);
        let mut count = 0;
        for way_out in [step, -step] {
            let mut at = far + way_out;
            while count < STEPS && way.is_open(at) && !self.glance(way, at).seen {
                (at, count) = (at + way_out, count + 1);
            }
        }
        count >= STEPS
    }
}

/// The numbers of all blocks that lie over lines, sorted. O(coats).
fn blocks(eye: &Eye<'_>) -> Vec<u32> {
    let coats = &eye.painting.coats;
    let Some(first) = coats.iter().position(|coat| coat.part == Part::Line) else { return Vec::new() };
    let is_block = |(i, coat): &(u32, &Coat)| {
        coat.part == Part::Area
            && coat.alpha > 0.5
            && eye.bars.binary_search(i).is_err()
            && eye.paper.binary_search(i).is_err()
            && coat.diameter() <= WHOLE * eye.span
            && matches!(&coat.shape, Shape::Area(area) if is_plain(area, LARGE * eye.span))
    };
    (0..).zip(coats).skip(first).filter(is_block).map(|(i, _)| i).collect()
}

/// Whether an area is a convex polygon with a side longer than this.
fn is_plain(area: &Area, long: f64) -> bool {
    let sides: Vec<_> = area.sides().take(SIDES + 2).filter(|[a, b]| a != b).collect();
    if sides.len() < 3 || sides.len() > SIDES {
        return false;
    }
    let next = |i: usize| sides[(i + 1) % sides.len()];
    let turn = |i: usize| {
        let ([a, b], [_, c]) = (sides[i], next(i));
        (b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x)
    };
    let is_one = (0..sides.len()).all(|i| sides[i][1] == next(i)[0]);
    let turns = |sign: f64| (0..sides.len()).all(|i| sign * turn(i) >= 0.0);
    is_one && (turns(1.0) || turns(-1.0)) && sides.iter().any(|[a, b]| distance(*a, *b) > long)
}
