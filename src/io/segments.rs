//! Segments: what line formats hold, and the plainest of these formats.
//!
//! ```text
//!   3                  the number of segments: may be left out
//!   0 0  4 0           x and y of one end, then of the other
//!   4 0  0 3
//!   0 3  0 0           # starts a comment
//!   1 1                a point by itself
//! ```

use super::format::Format;
use super::problem::{ReadError, ReadProblem};
use super::read::{Document, Read};
use super::text::{Scanner, Syntax};
use crate::ids::MAX_IDS;
use crate::plane::Point;

/// Points and segments as a file gives them: nothing is joined, split or checked against anything else.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct SegmentSoup {
    /// The points in the order of the file. Those that no segment uses are points by themselves.
    pub points: Vec<Point>,
    /// The segments by the numbers of their ends.
    pub segments: Vec<[u32; 2]>,
    /// Points that mark the faces around them as holes.
    pub hole_points: Vec<Point>,
    /// The file.
    pub source: String,
    /// The line of each point, from 1.
    pub point_lines: Vec<u32>,
    /// The line of each segment, from 1.
    pub segment_lines: Vec<u32>,
    /// The line of each hole point, from 1.
    pub hole_lines: Vec<u32>,
}

impl SegmentSoup {
    /// Nothing yet, for the file `source`.
    pub(super) fn new(source: &str) -> Self {
        Self { source: source.to_owned(), ..Self::default() }
    }

    /// Appends a point and returns its number.
    pub(super) fn point(&mut self, [x, y]: [f64; 2], line: u32) -> u32 {
        self.points.push(Point::new(x, y));
        self.point_lines.push(line);
        self.points.len() as u32 - 1
    }

    /// Appends a segment.
    pub(super) fn segment(&mut self, ends: [u32; 2], line: u32) {
        self.segments.push(ends);
        self.segment_lines.push(line);
    }

    /// Appends the segments of a chain of points, of which some came before; `closed` adds the way back.
    pub(super) fn chain(&mut self, first: u32, closed: bool) {
        let end = self.points.len() as u32;
        for p in first + 1..end {
            self.segment([p - 1, p], self.point_lines[p as usize]);
        }
        if closed && first + 1 < end {
            self.segment([end - 1, first], self.point_lines[end as usize - 1]);
        }
    }

    /// Refuses more points or segments than there are ids.
    pub(super) fn checked(self) -> Result<Self, ReadError> {
        let counts = [(self.points.len(), "points"), (2 * self.segments.len(), "half-edges")];
        match counts.into_iter().find(|&(count, _)| count > MAX_IDS) {
            Some((_, what)) => {
                let problem = ReadProblem::TooLarge { what, limit: MAX_IDS as u64 };
                Err(ReadError::whole(&self.source, problem, ""))
            }
            None => Ok(self),
        }
    }

    /// Where a segment stands: `roads.wkt:12`.
    #[must_use]
    pub fn place(&self, segment: usize) -> String {
        self.at_line(self.segment_lines.get(segment))
    }

    /// Where a point stands.
    #[must_use]
    pub fn point_place(&self, point: usize) -> String {
        self.at_line(self.point_lines.get(point))
    }

    pub(super) fn at_line(&self, line: Option<&u32>) -> String {
        line.map_or_else(|| self.source.clone(), |line| format!("{}:{line}", self.source))
    }
}

/// Whether a line holds four numbers.
pub(super) fn is_segment(line: &str) -> bool {
    let line = line.split('#').next().unwrap_or("");
    let words = || line.split_ascii_whitespace();
    words().count() == 4 && words().all(|word| word.parse::<f64>().is_ok())
}

/// Reads plain segments. O(length).
pub(super) fn read(bytes: &[u8], source: &str) -> Result<Read, ReadError> {
    const SYNTAX: Syntax = Syntax { comments: true, continuation: false, quotes: false };
    let mut scanner = Scanner::new(bytes, source, SYNTAX)?;
    let mut soup = SegmentSoup::new(source);
    let mut announced = None;
    while let Some(first) = scanner.word_anywhere() {
        let line = scanner.line();
        let Some(second) = scanner.word() else {
            if announced.is_some() || !soup.points.is_empty() {
                return Err(scanner.missing("the y of the point".to_owned()));
            }
            announced = Some((scanner.count(first)?, first));
            continue;
        };
        let start = [scanner.coordinate('x', first)?, scanner.coordinate('y', second)?];
        let start = soup.point(start, line);
        let Some(third) = scanner.word() else { continue };
        let y = scanner.need(|| "the y of the second end".to_owned())?;
        let end = [scanner.coordinate('x', third)?, scanner.coordinate('y', y)?];
        let end = soup.point(end, line);
        soup.segment([start, end], line);
        scanner.end_of_line("a segment is x y x y, a point is x y; one of them a line")?;
    }
    if let Some((count, word)) = announced
        && count != soup.segments.len() as u64
    {
        let wanted = format!("the number of segments, {}", soup.segments.len());
        return Err(scanner.expected(word, wanted, "correct it or leave the line out"));
    }
    Ok(Read { document: Document::Segments(soup.checked()?), notes: Vec::new(), format: Format::Segments })
}
