//! Scenarios of the Moving AI benchmarks, `.scen`: questions for a map, with their answers.
//!
//! ```text
//!   version 1
//!   1  AcrosstheCape.map  768 768  283 492  286 497  5.830951895
//!   │  └ map               │    │   start    goal    └ length of the shortest path; -1: there is none
//!   └ bucket               └────┴ size of the map
//! ```
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
//! [`Scenario::optimum`] tells which of them a file must be: octile if every stated length is a sum a + b√2 with whole
//! a and b and none is less than the octile distance from start to goal; else Euclidean.
//!
//! Source: N. Sturtevant, *Benchmarks for grid-based pathfinding*, 2012; the any-angle track of the GPPC 2023.

use super::problem::ReadError;
use super::text::{Scanner, Syntax};
use crate::plane::Point;
use std::f64::consts::SQRT_2;

/// What the last column of a scenario means.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Optimum {
    /// The length of the shortest path.
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
    /// Where the path begins; y as in the file.
    pub start: Point,
    /// Where it ends; y as in the file.
    pub goal: Point,
    /// The stated length; none if there is no path.
    pub length: Option<f64>,
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

/// How far a printed length may be from the number that was meant: half of the fifth decimal, as files have at
/// least so many.
const PRINTED: f64 = 5e-5;

impl Query {
    /// Whether an answer is what the file states: no way where it states none, the length up to `tolerance` of it if
    /// that is Euclidean, and if it is octile no more than that (but for the digits it is printed with) and no less than
    /// the straight line.
    #[must_use]
    pub fn agrees(&self, found: Option<f64>, optimum: Optimum, tolerance: f64) -> bool {
        match (self.length, found, optimum) {
            (None, None, _) => true,
            (Some(stated), Some(found), Optimum::Euclidean) => (found - stated).abs() <= tolerance * stated,
            (Some(stated), Some(found), Optimum::Octile) => {
                let [x, y] = [self.goal.x - self.start.x, self.goal.y - self.start.y];
                let straight = (x * x + y * y).sqrt();
                found <= stated * (1.0 + tolerance) + PRINTED && found >= straight * (1.0 - tolerance)
            }
            _ => false,
        }
    }
}

impl Scenario {
    /// Reads a `.scen` file. `source` is what errors call it. O(length).
    ///
    /// ```
    /// use dcel_kit::io::{Optimum, Scenario};
    /// let text = b"version 1\n0\tarena.map\t49\t49\t1\t13\t4\t12\t3.41421\n";
    /// let scenario = Scenario::parse(text, "arena.scen")?;
    /// assert_eq!(scenario.queries[0].goal, (4.0, 12.0).into());
    /// assert_eq!(scenario.optimum(), Optimum::Octile);
    /// # Ok::<(), dcel_kit::io::ReadError>(())
    /// ```
    ///
    /// # Errors
    /// [`ReadError`] with line and column.
    pub fn parse(bytes: &[u8], source: &str) -> Result<Self, ReadError> {
        let mut scanner = Scanner::new(bytes, source, Syntax::default())?;
        let mut queries = Vec::new();
        let mut words = Vec::new();
        let mut is_first = true;
        loop {
            words.clear();
            while let Some(word) = scanner.word() {
                words.push(word);
            }
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
                    scanner.count(*width)?;
                    scanner.count(*height)?;
                    let map: Vec<_> = name.iter().map(|word| String::from_utf8_lossy(word.text)).collect();
                    let bucket = scanner.index(*bucket, "bucket", u64::from(u32::MAX), 0)?;
                    let point = |x, y| Ok(Point::new(scanner.coordinate('x', x)?, scanner.coordinate('y', y)?));
                    let stated = scanner.number(*length)?;
                    if !stated.is_finite() || (stated < 0.0 && stated > -1.0) || stated < -1.0 {
                        return Err(scanner.expected(*length, "a length, or -1 for no path", ""));
                    }
                    queries.push(Query {
                        bucket,
                        map: map.join(" "),
                        start: point(*x0, *y0)?,
                        goal: point(*x1, *y1)?,
                        length: (stated >= 0.0).then_some(stated),
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
        Ok(Self { source: source.to_owned(), queries })
    }

    /// What the lengths must be, as far as the numbers can tell: see [the page](self). A file without a path is
    /// taken as Euclidean. O(queries · length).
    #[must_use]
    pub fn optimum(&self) -> Optimum {
        let mut stated = self.queries.iter().filter_map(|q| Some((q, q.length?))).peekable();
        let is_octile = stated.peek().is_some()
            && stated.all(|(q, length)| length > octile_distance(q.start, q.goal) - PRINTED && is_octile_sum(length));
        if is_octile { Optimum::Octile } else { Optimum::Euclidean }
    }
}

/// The cost from `p` to `q` in a grid without obstacles.
fn octile_distance(p: Point, q: Point) -> f64 {
    let (dx, dy) = ((q.x - p.x).abs(), (q.y - p.y).abs());
    dx.max(dy) + (SQRT_2 - 1.0) * dx.min(dy)
}

/// Whether a number is printed from a + b√2 with whole a and b from 0 on. Larger numbers than any map has are not.
fn is_octile_sum(length: f64) -> bool {
    const LONGEST: f64 = 1e7;
    let diagonals = (length / SQRT_2 + PRINTED) as u64;
    let rest = |b: u64| length - b as f64 * SQRT_2;
    length <= LONGEST && (0..=diagonals).any(|b| (rest(b) - rest(b).round()).abs() < PRINTED)
}
