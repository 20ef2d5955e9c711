//! The `.poly` files of Triangle: points, segments between them, points that mark holes.
//!
//! ```text
//!   4 2 0 0        points, dimension, attributes, markers; 0 points: they are in the .node file beside it
//!   1  0 0
//!   2  4 0
//!   3  4 4
//!   4  0 4
//!   4 1            segments, markers
//!   1  1 2  7
//!   ...
//!   1              holes
//!   1  2 2         the face around (2, 2) is a hole
//!   0              regions: may be left out; ignored
//! ```
//!
//! Attributes and boundary markers are ignored, as in the [`.node` and `.ele` files](super::triangle).
//!
//! Source: J. R. Shewchuk, *Triangle*, the page on `.poly` files (1996).

use super::document::{Document, Read};
use super::format::Format;
use super::problem::{ReadError, ReadProblem};
use super::soup::{SegmentSoup, SoupBuilder};
use super::text::Scanner;
use super::triangle::{COUNT, File, SYNTAX, attributes, nodes, optional_count, points, position, record};
use super::words::note;

/// Reads a file, with the `.node` file beside it if there is one. O(length).
pub(super) fn read(poly: File<'_>, node: Option<File<'_>>) -> Result<Read, ReadError> {
    let mut scanner = Scanner::new(poly.bytes, poly.source, SYNTAX)?;
    let mut own = SoupBuilder::default();
    let mut first = points(&mut scanner, &mut own)?;
    if own.points.is_empty() {
        let Some(node) = node else {
            let problem = ReadProblem::PartnerMissing { partner: "with the points, a .node file,".to_owned() };
            return Err(ReadError::whole(poly.source, problem, "a .poly file without points needs one beside it"));
        };
        first = nodes(&mut Scanner::new(node.bytes, node.source, SYNTAX)?, &mut own)?;
    }
    let mut soup = SegmentSoup::new(poly.source);
    for (&[x, y, _], line) in own.points.iter().zip(own.vertex_lines.iter()) {
        soup.point([x, y], line);
    }
    segments(&mut scanner, &mut soup, first)?;
    holes(&mut scanner, &mut soup, first)?;
    let mut notes = Vec::new();
    if let Some(word) = scanner.word_anywhere() {
        let count = scanner.count(word)?;
        scanner.end_of_line("this line holds the number of regions")?;
        for _ in 0..count {
            let missing = || "a region: its number, x, y, attribute and area".to_owned();
            let word = scanner.need_anywhere(missing)?;
            scanner.integer(word)?;
            while let Some(word) = scanner.word() {
                scanner.number(word)?;
            }
        }
        scanner.no_more("regions", count, COUNT)?;
        let left_out = usize::try_from(count).unwrap_or(usize::MAX);
        note(&mut notes, left_out, "regional attribute was", "regional attributes were", " left out");
    }
    Ok(Read { document: Document::Segments(soup.checked()?), notes, format: Format::Poly })
}

fn segments(scanner: &mut Scanner<'_>, soup: &mut SegmentSoup, first_point: i64) -> Result<(), ReadError> {
    let count = scanner.need_count("the number of segments")?;
    let extra = optional_count(scanner)?;
    scanner.end_of_line("this line holds the numbers of segments and of markers")?;
    let points = soup.points.len() as u64;
    let mut first = first_point;
    for i in 0..count {
        let line = record(scanner, i, count, &mut first, "segment")?;
        let mut ends = [0; 2];
        for end in &mut ends {
            let word = scanner.need(|| format!("an end of segment {i}"))?;
            *end = scanner.index(word, "point", points, first_point)?;
        }
        attributes(scanner, extra)?;
        soup.segment(ends, line);
    }
    Ok(())
}

fn holes(scanner: &mut Scanner<'_>, soup: &mut SegmentSoup, first_point: i64) -> Result<(), ReadError> {
    let count = scanner.need_count("the number of holes")?;
    scanner.end_of_line("this line holds the number of holes")?;
    let mut first = first_point;
    for i in 0..count {
        let line = record(scanner, i, count, &mut first, "hole")?;
        let place = position(scanner, i, "hole")?;
        scanner.end_of_line("a hole is its number, x and y")?;
        soup.hole_points.push(place.into());
        soup.hole_lines.push(line);
    }
    Ok(())
}
