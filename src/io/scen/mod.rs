//! Scenarios of the Moving AI benchmarks, `.scen`: questions for a map, with their answers.
//!
//! ```text
//!   version 1
//!   1  AcrosstheCape.map  768 768  283 492  286 497  5.830951895
//!   │  └ map               │    │   start    goal    └ length of the shortest path; -1: there is none
//!   └ bucket               └────┴ size of the map
//! ```
//!
//! Some files state 0 where there is no path: between two places that are not the same it cannot be a length.
//!
//! Points are those of the map's file: for a grid map corners of cells, y pointing down; for a mesh its own
//! coordinates.
//!
//! **What the last column means differs**, and the format does not say it:
//!
//! - *Euclidean*: the length of the shortest path in any direction. That is what a navigation mesh answers.
//! - *Octile*: the cost from cell to cell, straight steps at 1 and diagonal ones at √2. For the mesh this is an upper
//!   bound, and nothing to be equal to.
//!
//! [`Scenario::verdict`] tells which of them a whole file must be, and how well it fits: see `scen/verdict.rs`.
//!
//! **How exactly a length is stated** differs, too: most files print six significant digits, some two decimals, some
//! nine. A length says no more than half a unit of its last digit. As zeros at the end may be left out, that digit is
//! found by the whole file: it has as many decimals as any number of the file, unless it would then have more
//! significant digits than any number of the file (six at least, if there are no decimals at all).
//!
//! Source: N. Sturtevant, *Benchmarks for grid-based pathfinding*, 2012; the any-angle track of the GPPC 2023.

mod verdict;

use super::problem::ReadError;
use super::text::{Scanner, Syntax};
use crate::plane::Point;
pub use verdict::{Misfits, Verdict};

/// What the last column of a scenario means.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default)]
pub enum Optimum {
    /// The length of the shortest path.
    #[default]
    Euclidean,
    /// The cost of the cheapest path from cell to cell; for a mesh an upper bound.
    Octile,
}

/// A question and its answer.
#[derive(Clone, PartialEq, Debug)]
pub struct Query {
    /// The group of queries of similar length.
    pub bucket: u32,
    /// The map it is about, as the file names it.
    pub map: String,
    /// The width and height that the map has, as the file states them: in cells of a grid map. The points of the query are
    /// those of a map of this size.
    pub size: [u64; 2],
    /// Where the path begins; y as in the file.
    pub start: Point,
    /// Where it ends; y as in the file.
    pub goal: Point,
    /// The stated length; none if there is no path: -1 is stated, or 0 between two places.
    pub length: Option<f64>,
    /// How far the stated length may be from the one that was meant: half a unit of its last printed digit. 0 if none
    /// is stated.
    pub precision: f64,
    /// The line in the file, from 1.
    pub line: u32,
}

/// The queries of a file.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Scenario {
    /// What messages call the file.
    pub source: String,
    /// The queries in the order of the file.
    pub queries: Vec<Query>,
}

impl Query {
    /// Whether an answer is what the file states: no way where it states none; if the lengths are Euclidean, the stated
    /// one within its [`precision`](Self::precision); if they are octile, no more than the stated one, within its
    /// precision and that of √2 in single precision, and no less than the straight line. `tolerance` is a part of the
    /// length that is allowed on top.
    #[must_use]
    pub fn agrees(&self, found: Option<f64>, optimum: Optimum, tolerance: f64) -> bool {
        match (self.length, found, optimum) {
            (None, None, _) => true,
            (Some(stated), Some(found), Optimum::Euclidean) => {
                (found - stated).abs() <= self.precision + tolerance * stated
            }
            (Some(stated), Some(found), Optimum::Octile) => {
                let longest = stated * (verdict::SINGLE + tolerance) + self.precision;
                found <= longest && found >= self.straight() * (1.0 - tolerance)
            }
            _ => false,
        }
    }

    /// How far the goal is from the start along each axis.
    fn along_axes(&self) -> (f64, f64) {
        ((self.goal.x - self.start.x).abs(), (self.goal.y - self.start.y).abs())
    }

    /// The length of the straight line from start to goal.
    fn straight(&self) -> f64 {
        let (x, y) = self.along_axes();
        (x * x + y * y).sqrt()
    }
}

impl Scenario {
    /// Reads a `.scen` file. `source` is what errors call it. O(length).
    ///
    /// ```
    /// use dcel_kit::io::{Optimum, Scenario};
    /// let text = b"version 1\n0\tarena.map\t49\t49\t1\t13\t4\t12\t3.41421\n";
    /// let scenario = Scenario::parse(text, "arena.scen")?;
    /// assert_eq!(scenario.queries[0].size, [49, 49]);
    /// assert_eq!(scenario.queries[0].goal, (4.0, 12.0).into());
    /// assert_eq!(scenario.queries[0].precision, 5e-6);
    /// assert_eq!(scenario.optimum(), Optimum::Octile);
    /// # Ok::<(), dcel_kit::io::ReadError>(())
    /// ```
    ///
    /// # Errors
    /// [`ReadError`] with line and column.
    pub fn parse(bytes: &[u8], source: &str) -> Result<Self, ReadError> {
        let mut scanner = Scanner::new(bytes, source, Syntax::default())?;
        let mut queries = Vec::new();
        let mut digits = Vec::new();
        let mut words = Vec::new();
        let mut is_first = true;
        loop {
            words.clear();
            words.extend(std::iter::from_fn(|| scanner.word()));
            match words.as_slice() {
                [] => {}
                [word, version] if is_first && word.text == b"version" => {
                    if scanner.number(*version)?.partial_cmp(&1.0) != Some(std::cmp::Ordering::Equal) {
                        return Err(scanner.expected(*version, "version 1", "the kit reads no other version"));
                    }
                    is_first = false;
                }
                // The map's name may hold blanks.
                [bucket, name @ .., width, height, x0, y0, x1, y1, length] if !name.is_empty() => {
                    is_first = false;
                    let size = [scanner.count(*width)?, scanner.count(*height)?];
                    let map: Vec<_> = name.iter().map(|word| String::from_utf8_lossy(word.text)).collect();
                    let bucket = scanner.index(*bucket, "bucket", u64::from(u32::MAX), 0)?;
                    let point = |x, y| Ok(Point::new(scanner.coordinate('x', x)?, scanner.coordinate('y', y)?));
                    let stated = scanner.number(*length)?;
                    if !stated.is_finite() || (stated < 0.0 && stated > -1.0) || stated < -1.0 {
                        return Err(scanner.expected(*length, "a length, or -1 for no path", ""));
                    }
                    digits.push(Digits::of(length.text));
                    let (start, goal) = (point(*x0, *y0)?, point(*x1, *y1)?);
                    let is_length = stated > 0.0 || (stated >= 0.0 && start == goal);
                    queries.push(Query {
                        bucket,
                        map: map.join(" "),
                        size,
                        start,
                        goal,
                        length: is_length.then_some(stated),
                        precision: 0.0,
                        line: scanner.line(),
                    });
                }
                [first, ..] => {
                    let wanted = "bucket, map, width, height, start x y, goal x y, length";
                    return Err(scanner.expected(*first, wanted, "a query has nine words, one query a line"));
                }
            }
            if !scanner.next_line() {
                break;
            }
        }
        set_precisions(&mut queries, &digits);
        Ok(Self { source: source.to_owned(), queries })
    }

    /// What the lengths must be, as far as the numbers can tell: see [`verdict`](Self::verdict).
    #[must_use]
    pub fn optimum(&self) -> Optimum {
        self.verdict().optimum
    }
}

/// How a number is printed.
#[derive(Clone, Copy)]
struct Digits {
    /// Digits behind the point; fewer than none if an exponent moves the point to the right.
    decimals: i32,
    /// Digits from the first that is not 0.
    significant: i32,
}

impl Digits {
    fn of(text: &[u8]) -> Self {
        let end = text.iter().position(|b| matches!(b, b'e' | b'E'));
        let (mantissa, exponent) = text.split_at(end.unwrap_or(text.len()));
        let exponent = std::str::from_utf8(exponent).ok().and_then(|e| e.get(1..)?.parse().ok()).unwrap_or(0);
        let point = mantissa.iter().position(|&b| b == b'.').unwrap_or(mantissa.len());
        let decimals = mantissa.len() - (point + 1).min(mantissa.len());
        let digits = mantissa.iter().filter(|b| b.is_ascii_digit());
        let significant = digits.skip_while(|&&b| b == b'0').count();
        // No number that is read has more than some thousands of digits that matter.
        let small = |n: usize| n.min(5000) as i32;
        Self { decimals: small(decimals).saturating_sub(exponent), significant: small(significant) }
    }
}

/// Half a unit of the last digit of each length, by the decimals and the significant digits of the whole file.
fn set_precisions(queries: &mut [Query], digits: &[Digits]) {
    let stated = || queries.iter().zip(digits).filter(|(query, _)| query.length.is_some()).map(|(_, digits)| digits);
    let decimals = stated().map(|digits| digits.decimals).max().unwrap_or(0);
    let significant = stated().map(|digits| digits.significant).max().unwrap_or(0);
    let (decimals, significant) = if decimals <= 0 { (i32::MAX, significant.max(6)) } else { (decimals, significant) };
    for query in queries {
        let Some(length) = query.length else { continue };
        // The place of the last significant digit: 0 for units, -1 for tenths.
        let first = if length > 0.0 { length.log10().floor() as i32 } else { i32::MIN / 2 };
        let last = (first.saturating_add(1).saturating_sub(significant)).max(decimals.saturating_neg());
        query.precision = 0.5 * 10f64.powi(last);
    }
}
