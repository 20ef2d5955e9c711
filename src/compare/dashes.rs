//! How much of a line its dashes draw.
//!
//! ```text
//!   ── ── ── ── ──        dashes and dots as usual are a line
//!   ────────              a gap that leaves out a third of an edge, or a quarter at its end, is none
//!   ▪          ▪          nor is a line of which less than a fifth is drawn
//! ```

use super::numbers;
use std::rc::Rc;

/// Less of a line than this drawn by its dashes cannot be seen.
const DRAWN: f64 = 0.2;
/// So much of a line a long gap may leave out: within it, and at an end.
const WITHIN: f64 = 1.0 / 3.0;
const AT_END: f64 = 0.25;
/// A dash shorter than this part of the gap behind it parts no gaps.
const SPECK: f64 = 0.1;
/// So many dashes and gaps of one line are looked at for its ink, beyond one turn of the pattern, and so many of its longest
/// dashes are kept.
const LOOKED: usize = 2048;
const KEPT: usize = 32;

/// Dashes and gaps by turns, an even number of lengths; none for a line without gaps.
pub(super) fn read(text: &str) -> Rc<[f64]> {
    let words = text.split([',', ' ']).filter(|word| !word.is_empty());
    let lengths: Option<Vec<f64>> = words.map(|word| numbers::measure(word).filter(|x| *x >= 0.0)).collect();
    let mut lengths = lengths.unwrap_or_default();
    if lengths.len() % 2 == 1 {
        lengths.extend_from_within(..);
    }
    lengths.into()
}

/// A pattern, and where in it a line begins. Lengths are as they are before any transform.
#[derive(Clone, Copy)]
pub(super) struct Dashes<'a> {
    pub(super) lengths: &'a [f64],
    pub(super) start: f64,
    /// How much longer the ends make each dash.
    pub(super) ends: f64,
}

impl Dashes<'_> {
    /// The length of the dash or gap of this number, counted on and on.
    fn length(&self, i: usize) -> f64 {
        let own = self.lengths[i % self.lengths.len()];
        let gap = if i % 2 == 1 { own } else { self.lengths[(i + 1) % self.lengths.len()] };
        let more = self.ends.min(gap);
        if i % 2 == 1 { own - more } else { own + more }
    }

    fn period(&self) -> f64 {
        self.lengths.iter().sum()
    }

    /// How far into the pattern a line lies that begins so far from the start of its path.
    fn phase(&self, from: f64) -> f64 {
        (from + self.start + 0.5 * self.ends).rem_euclid(self.period())
    }

    fn draws_all(&self, length: f64) -> bool {
        self.lengths.is_empty() || self.period() <= 0.0 || length <= 0.0
    }

    /// Whether hardly anything is drawn of a line that begins so far from the start of its path. O(dashes).
    pub(super) fn leave_out(&self, from: f64, length: f64) -> bool {
        if self.draws_all(length) {
            return false;
        }
        let (period, count) = (self.period(), self.lengths.len());
        let whole = (length / period).floor();
        let ink: f64 = (0..count).step_by(2).map(|i| self.length(i)).sum();
        let start = self.phase(from + whole * period);
        let end = start + (length - whole * period);
        let (mut at, mut drawn) = (0.0, whole * ink);
        for i in 0..2 * count {
            let next = at + self.length(i);
            drawn += if i % 2 == 0 { (end.min(next) - start.max(at)).max(0.0) } else { 0.0 };
            at = next;
        }
        drawn < DRAWN * length
    }

    /// Whether one gap, longer than `usual`, leaves out a large part of such a line. O(dashes).
    pub(super) fn leave_a_gap(&self, from: f64, length: f64, usual: f64) -> bool {
        if self.draws_all(length) {
            return false;
        }
        let count = self.lengths.len();
        let mut at = -self.phase(from);
        // Where the gap began that is open. What comes behind so many periods leaves out too little.
        let mut open = None;
        for i in 0..12 * count {
            let (next, gap) = (at + self.length(i), self.length(i | 1));
            let is_dash = i % 2 == 0 && self.length(i) > 0.0 && self.length(i) >= SPECK * gap;
            if is_dash && at > 0.0 && is_wide(open.take(), at, length, usual) {
                return true;
            }
            if is_dash {
                open = None;
            } else if i % 2 == 1 {
                open = open.or(Some(at));
            }
            at = next;
            if at >= length {
                return is_wide(open, at, length, usual);
            }
        }
        false
    }

    /// The longest dashes on such a line, if they are no shorter than `least`: from where to where. O(dashes).
    pub(super) fn drawn(&self, from: f64, length: f64, least: f64) -> Vec<[f64; 2]> {
        let mut out = Vec::new();
        if self.draws_all(length) {
            return out;
        }
        let mut at = -self.phase(from);
        for i in 0..self.lengths.len() + LOOKED {
            let next = at + self.length(i);
            let dash = [at.max(0.0), next.min(length)];
            out.extend((i % 2 == 0 && dash[1] - dash[0] >= least.max(f64::MIN_POSITIVE)).then_some(dash));
            at = next;
            if at >= length {
                break;
            }
        }
        out.sort_by(|a, b| (b[1] - b[0]).total_cmp(&(a[1] - a[0])));
        out.truncate(KEPT);
        out
    }
}

/// Whether the gap between two places leaves out too much of a line that reaches from 0 to its length.
fn is_wide(open: Option<f64>, end: f64, length: f64, usual: f64) -> bool {
    let Some(start) = open.filter(|start| end - start > usual) else { return false };
    let part = if start <= 0.0 || end >= length { AT_END } else { WITHIN };
    end.min(length) - start.max(0.0) > part * length
}
