//! Octile or Euclidean: what the lengths of a whole scenario must be.
//!
//! ```text
//!   goal  ┌─────────●        octile     8.65685 = 3 + 4 √2, a sum of whole numbers of straight and diagonal steps
//!         │      ╱  ╱        Euclidean  8.06226, shorter than any row of steps
//!         │   ╱  ╱
//!   start ●╱─────            Each length votes; lengths that may be both (8 = 8 + 0 √2, straight on) do not.
//! ```
//!
//! An octile length is a + b √2 with whole a and b from 0 on, within its precision; if the ends are corners of cells, a
//! is even or odd as the number of steps from start to goal along the axes is. Programs that add in single precision
//! take 1.41421354 for √2, and 48 steps of that are printed as 67.8822 in place of 67.8823: both are octile. Other
//! programs take a decimal fraction, such as 1.414213562, which shows in the tenth digit of long ways: one fraction for
//! the whole file. And an octile length is no less than the octile distance from start to goal. A Euclidean length is no
//! less than the straight line; that is all that can be said without the map.
//!
//! Any number is such a sum sooner or later if it is long and has few digits, so a length that fits counts by how
//! unlikely that would be by chance, and one that does not counts as a slip that one octile length in a hundred may be.
//! The sum of the logarithms decides: the *likelihood ratio* of both readings. A fraction in place of √2 is rare, so it
//! has to be more likely by far.

use super::{Optimum, Query, Scenario};
use std::f64::consts::SQRT_2;
use std::fmt;

/// One in so many octile lengths may be written down wrongly.
const SLIP: f64 = 0.01;
/// Longer ways than any grid of the benchmarks has are no octile ones: a bound for the search for a sum.
const LONGEST: f64 = 1e5;
/// Room for the rounding of doubles, as a part of the length.
const ROUNDING: f64 = 1e-13;
/// One file of octile lengths in so many takes a certain one of them: a single length is no reason to.
const RARE: f64 = 1e-4;
/// √2 in single precision.
const SINGLE_SQRT_2: f64 = std::f32::consts::SQRT_2 as f64;
/// How many times as long diagonal steps are as in single precision.
pub(super) const SINGLE: f64 = SQRT_2 / SINGLE_SQRT_2;

/// Lengths that do not fit a reading.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Misfits {
    /// How many.
    pub count: usize,
    /// The line of the first of them in the file.
    pub first_line: Option<u32>,
}

impl Misfits {
    fn add(&mut self, line: u32) {
        self.count += 1;
        self.first_line.get_or_insert(line);
    }
}

/// What the lengths of a file are, and how well they fit. `Display` says it in a line.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Verdict {
    /// What they are, or are nearly.
    pub optimum: Optimum,
    /// How many lengths the file states.
    pub stated: usize,
    /// Those that are no octile cost: no sum of straight and diagonal steps, or less than the octile distance.
    pub not_octile: Misfits,
    /// Those that are less than the straight line: no length of a path at all.
    pub too_short: Misfits,
    /// Those that are one reading only, or an unlikely chance for the other.
    pub telling: usize,
    /// Whether all ways that are not along an axis are stated in whole numbers that are the lengths of straight steps
    /// alone, and there are two or more: Manhattan distances, or such round obstacles.
    pub straight_steps: bool,
    /// The decimal fraction that stands for √2 in octile lengths; none if it is √2 as exactly as a float has it.
    pub diagonal: Option<f64>,
}

impl Verdict {
    /// Whether every stated length fits the reading.
    #[must_use]
    pub fn fits(&self) -> bool {
        self.misfits().count == 0
    }

    /// The lengths that do not fit the reading.
    #[must_use]
    pub fn misfits(&self) -> Misfits {
        match self.optimum {
            Optimum::Octile => self.not_octile,
            Optimum::Euclidean => self.too_short,
        }
    }

    /// By which part octile costs may be greater than stated, because a diagonal step was taken to be shorter than √2.
    #[must_use]
    pub fn shortfall(&self) -> f64 {
        self.diagonal.map_or(0.0, |diagonal| (SQRT_2 / diagonal - 1.0).max(0.0))
    }
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { optimum, stated, not_octile, telling, diagonal, .. } = *self;
        let lengths = if stated == 1 { "length" } else { "lengths" };
        let (is, all) = (|count| if count == 1 { "is" } else { "are" }, counted_all(stated));
        let Misfits { count, first_line } = self.misfits();
        if let Some(line) = first_line {
            let (name, why) = match optimum {
                Optimum::Octile => ("octile", "no sum a + b√2 of steps"),
                Optimum::Euclidean => ("Euclidean", "less than the straight line"),
            };
            return write!(
                f,
                "neither octile nor Euclidean, but nearly {name}: {count} of {stated} {lengths} {} {why}, the first in line {line}",
                is(count)
            );
        }
        match (optimum, not_octile.first_line) {
            (Optimum::Octile, _) => {
                let sums = if stated == 1 { "is a sum" } else { "are sums" };
                write!(f, "octile: {all} {sums} a + b√2 of steps")?;
                if self.straight_steps {
                    f.write_str(", none of them diagonal (Manhattan): as upper bounds only")?;
                }
                diagonal.map_or(Ok(()), |diagonal| write!(f, ", with √2 = {diagonal}"))
            }
            (Optimum::Euclidean, Some(line)) => {
                let (count, is) = (not_octile.count, is(not_octile.count));
                write!(
                    f,
                    "Euclidean: {count} of {stated} {lengths} {is} no sum a + b√2 of steps, the first in line {line}"
                )
            }
            (Optimum::Euclidean, None) if stated == 0 => f.write_str("no length is stated"),
            (Optimum::Euclidean, None) if telling == 0 => {
                let ways = if stated == 1 { "is a straight way" } else { "are straight ways" };
                write!(f, "Euclidean or octile, which is the same here: {all} {ways}")
            }
            (Optimum::Euclidean, None) => write!(f, "Euclidean: {stated} {lengths}"),
        }
    }
}

/// `the 1 length`, `all of 7 lengths`.
fn counted_all(stated: usize) -> String {
    if stated == 1 { "the 1 length".to_owned() } else { format!("all of {stated} lengths") }
}

impl Scenario {
    /// What the lengths of the whole file are: sums a + b√2 of steps, or not. Of a file that fits neither reading it
    /// tells which one it nearly fits.
    ///
    /// Cost: O(queries · length), where lengths beyond 100,000 are never octile.
    ///
    /// ```
    /// use dcel_kit::io::{Optimum, Scenario};
    /// let lines = ["0 a.map 9 9 0 0 7 4 8.65685", "0 a.map 9 9 0 0 8 5 10.0711", "0 a.map 9 9 0 0 8 8 11.3137"];
    /// let scenario = Scenario::parse(lines.join("\n").as_bytes(), "a.scen")?;
    /// assert_eq!(scenario.verdict().optimum, Optimum::Octile);
    /// assert_eq!(scenario.verdict().to_string(), "octile: all of 3 lengths are sums a + b√2 of steps");
    /// # Ok::<(), dcel_kit::io::ReadError>(())
    /// ```
    #[must_use]
    pub fn verdict(&self) -> Verdict {
        let (mut best, mut best_for_octile) = self.reading(&[SQRT_2, SINGLE_SQRT_2]);
        if best.not_octile.count == 0 {
            return best;
        }
        for diagonal in fractions() {
            let (verdict, for_octile) = self.reading(&[diagonal]);
            let for_octile = for_octile + RARE.ln();
            if for_octile > best_for_octile.max(0.0) {
                best = Verdict { diagonal: Some(diagonal), ..verdict };
                best_for_octile = for_octile;
            }
        }
        best
    }

    /// The verdict with these numbers for √2, and by how much it speaks for octile lengths.
    fn reading(&self, diagonals: &[f64]) -> (Verdict, f64) {
        let mut verdict = Verdict::default();
        let mut for_octile = 0.0;
        let (mut aslant, mut without_diagonal) = (0, 0);
        for query in &self.queries {
            let Some(length) = query.length else { continue };
            verdict.stated += 1;
            let slack = query.precision + ROUNDING * length;
            if length + slack < query.straight() {
                verdict.too_short.add(query.line);
            }
            let (dx, dy) = query.along_axes();
            if dx > 0.0 && dy > 0.0 {
                aslant += 1;
                let is_whole = (length - length.round()).abs() <= ROUNDING * length;
                let is_even = ((length.round() - (dx + dy)) / 2.0).fract().abs() <= 0.0;
                without_diagonal += usize::from(is_whole && is_even && length + slack >= dx + dy);
            }
            let steps = Steps::of(query, length, slack, diagonals);
            if !steps.fit {
                verdict.not_octile.add(query.line);
            }
            // A straight way along the steps is the same by both readings.
            if steps.fit && (length - query.straight()).abs() <= slack {
                continue;
            }
            verdict.telling += 1;
            for_octile += if steps.fit {
                ((1.0 - SLIP) / steps.chance.max(f64::MIN_POSITIVE)).ln()
            } else {
                (SLIP / (1.0 - steps.chance)).ln()
            };
        }
        verdict.straight_steps = aslant > 1 && without_diagonal == aslant;
        if verdict.telling > 0 && for_octile > 0.0 {
            verdict.optimum = Optimum::Octile;
        }
        (verdict, for_octile)
    }
}

/// √2 as a decimal fraction of two to ten digits behind the point.
fn fractions() -> impl Iterator<Item = f64> {
    (2..=10).map(|digits| 10_f64.powi(digits)).map(|parts| (SQRT_2 * parts).round() / parts)
}

/// Whether a length is an octile cost.
struct Steps {
    fit: bool,
    /// How likely any length of this size and precision would be one.
    chance: f64,
}

impl Steps {
    /// `diagonals` are numbers that may stand for √2.
    fn of(query: &Query, length: f64, slack: f64, diagonals: &[f64]) -> Self {
        let (dx, dy) = query.along_axes();
        if length > LONGEST {
            return Self { fit: false, chance: 0.0 };
        }
        let bounds = |(least, greatest): (f64, f64), &d: &f64| (least.min(d), greatest.max(d));
        let (least, greatest) = diagonals.iter().fold((f64::INFINITY, 0.0), bounds);
        if length + slack < dx.max(dy) + (least - 1.0) * dx.min(dy) {
            // Beyond doubt: no precision would make it one.
            return Self { fit: false, chance: 0.0 };
        }
        // A diagonal step changes the sum of both coordinates by an even number, a straight one by one.
        let whole = dx.fract() <= 0.0 && dy.fract() <= 0.0;
        let (every, first) = if whole { (2.0, (dx + dy) % 2.0) } else { (1.0, 0.0) };
        let most = (length / least + slack) as u32;
        let range = 2.0 * slack + 0.5 * f64::from(most) * (greatest - least);
        let chance = f64::from(most + 1) * range.min(2.0 * diagonals.len() as f64 * slack) / every;
        if chance >= 0.99 {
            return Self { fit: true, chance: 0.99 };
        }
        let is_sum = |b: u32| {
            diagonals.iter().any(|diagonal| {
                let a = length - f64::from(b) * diagonal;
                let nearest = (first + ((a - first) / every).round() * every).max(first);
                (a - nearest).abs() <= slack
            })
        };
        Self { fit: (0..=most).any(is_sum), chance }
    }
}
