//! Plain segments, the simplest of the line formats.
//!
//! ```text
//!   3                  the number of segments: may be left out
//!   0 0  4 0           x and y of one end, then of the other
//!   4 0  0 3
//!   0 3  0 0           # starts a comment
//!   1 1                a point by itself
//! ```

use super::announced::Announced;
use super::blocks::Blocks;
use super::document::{Document, Read};
use super::format::Format;
use super::problem::{ReadError, ReadProblem};
use super::soup::SegmentSoup;
use super::text::{Scanner, Syntax, Word};

/// Whether a line holds four numbers.
pub(super) fn is_segment(line: &str) -> bool {
    let line = line.split('#').next().unwrap_or("");
    let words = || line.split_ascii_whitespace();
    words().count() == 4 && words().all(|word| word.parse::<f64>().is_ok())
}

/// Refuses numbers that commas or semicolons part: a comma may as well be meant as a decimal point.
fn check_blanks(scanner: &Scanner<'_>, word: Word<'_>) -> Result<(), ReadError> {
    if !word.text.iter().any(|b| matches!(b, b',' | b';')) {
        return Ok(());
    }
    let problem = ReadProblem::NotANumber { word: word.show(), wanted: "a number" };
    let help = "write a segment as x y x y: four numbers with blanks between, and a point for decimals";
    Err(scanner.error(word.at, problem, help))
}

/// Reads plain segments. O(length).
pub(super) fn read(blocks: &mut Blocks<'_>) -> Result<Read, ReadError> {
    const SYNTAX: Syntax = Syntax { comments: true, continuation: false, quotes: false, separators: false };
    let source = blocks.source();
    let mut soup = SegmentSoup::new(source);
    let mut announced = None;
    while let Some(block) = blocks.next()? {
        if block.is_part {
            soup.make_room(block.bytes.len())?;
        }
        let mut scanner = Scanner::of_block(block, SYNTAX);
        while let Some(first) = scanner.word_anywhere() {
            let line = scanner.line();
            check_blanks(&scanner, first)?;
            let Some(second) = scanner.word() else {
                if announced.is_some() || !soup.points.is_empty() {
                    return Err(scanner.missing("the y of the point".to_owned()));
                }
                announced = Some(Announced::new(&scanner, first)?);
                continue;
            };
            check_blanks(&scanner, second)?;
            let start = [scanner.coordinate('x', first)?, scanner.coordinate('y', second)?];
            let start = soup.point(start, line);
            let Some(third) = scanner.word() else { continue };
            check_blanks(&scanner, third)?;
            let y = scanner.need(|| "the y of the second end".to_owned())?;
            check_blanks(&scanner, y)?;
            let end = [scanner.coordinate('x', third)?, scanner.coordinate('y', y)?];
            let end = soup.point(end, line);
            soup.segment([start, end], line);
            scanner.end_of_line("a segment is x y x y, a point is x y; one of them a line")?;
        }
    }
    if let Some(announced) = announced {
        announced.check(soup.segments.len(), "segments", source)?;
    }
    Ok(Read { document: Document::Segments(soup.checked()?), notes: Vec::new(), format: Format::Segments })
}
