//! The `.node` and `.ele` files of Triangle.
//!
//! ```text
//!   square.node                      square.ele
//!   4 2 0 1                          2 3 0
//!   # points dimension               # triangles, corners each, attributes each
//!   #   attributes markers           1  1 2 3
//!   1  0 0  1                        2  1 3 4
//!   2  1 0  1
//!   3  1 1  1                        Records are numbered from 0 or from 1;
//!   4  0 1  1                        the first point decides for both files.
//! ```
//!
//! Attributes and boundary markers are ignored. Not read, by name: triangles with six corners (second order)
//! and the files of TetGen (three dimensions).
//!
//! Source: J. R. Shewchuk, *Triangle*, the pages on `.node` and `.ele` files (1996).

use super::document::{Document, Read};
use super::format::Format;
use super::problem::{ReadError, ReadProblem};
use super::soup::SoupBuilder;
use super::text::{Scanner, Syntax};

/// What to do when a file holds more than it announces.
pub(super) const COUNT: &str = "correct the count in the first line of the file";

pub(super) const SYNTAX: Syntax = Syntax { comments: true, continuation: false, quotes: false, separators: false };

/// One file with its name.
#[derive(Clone, Copy, Debug)]
pub(super) struct File<'a> {
    pub(super) bytes: &'a [u8],
    pub(super) source: &'a str,
}

/// Reads a pair of files. O(length).
pub(super) fn read(node: File<'_>, ele: File<'_>) -> Result<Read, ReadError> {
    let mut soup = SoupBuilder::default();
    let first = nodes(&mut Scanner::new(node.bytes, node.source, SYNTAX)?, &mut soup)?;
    triangles(&mut Scanner::new(ele.bytes, ele.source, SYNTAX)?, &mut soup, first)?;
    let mut soup = soup.finish(ele.source, false)?;
    soup.places.vertex_source = Some(node.source.to_owned());
    Ok(Read { document: Document::Polygons(soup), notes: Vec::new(), format: Format::Triangle })
}

/// Reads the points, to the end of the file; returns the number of the first one.
pub(super) fn nodes(scanner: &mut Scanner<'_>, soup: &mut SoupBuilder) -> Result<i64, ReadError> {
    let first = points(scanner, soup)?;
    scanner.no_more("points", soup.points.len() as u64, COUNT)?;
    Ok(first)
}

/// Reads the points; returns the number of the first one.
pub(super) fn points(scanner: &mut Scanner<'_>, soup: &mut SoupBuilder) -> Result<i64, ReadError> {
    let count = scanner.need_count("the number of points")?;
    let word = scanner.need(|| "the dimension, 2".to_owned())?;
    if scanner.integer(word)? != 2 {
        let what = "a .node file whose dimension is not 2 (TetGen)";
        return Err(scanner.error(word.at, ReadProblem::Refused { what: what.into() }, ""));
    }
    let extra = optional_count(scanner)?.saturating_add(optional_count(scanner)?);
    scanner.end_of_line("the first line holds points, dimension, attributes and markers")?;
    *soup = SoupBuilder::with_room(count, scanner.remaining(), 6, scanner.source())?;
    let mut first = 0;
    for i in 0..count {
        let line = record(scanner, i, count, &mut first, "point")?;
        let [x, y] = position(scanner, i, "point")?;
        attributes(scanner, extra)?;
        soup.point([x, y, 0.0], line);
    }
    Ok(first)
}

fn triangles(scanner: &mut Scanner<'_>, soup: &mut SoupBuilder, first_point: i64) -> Result<(), ReadError> {
    let count = scanner.need_count("the number of triangles")?;
    let word = scanner.need(|| "the number of corners of a triangle, 3".to_owned())?;
    let refused = match scanner.integer(word)? {
        3 => None,
        6 => Some("an .ele file with six corners a triangle (second order)"),
        4 | 10 => Some("an .ele file of tetrahedra (TetGen)"),
        _ => return Err(scanner.expected(word, "3 corners a triangle", "")),
    };
    if let Some(what) = refused {
        let help = "run triangle without the switch -o2";
        return Err(scanner.error(word.at, ReadProblem::Refused { what: what.into() }, help));
    }
    let extra = optional_count(scanner)?;
    scanner.end_of_line("the first line holds triangles, corners and attributes")?;
    let points = soup.points.len() as u64;
    let mut first = first_point;
    for i in 0..count {
        let line = record(scanner, i, count, &mut first, "triangle")?;
        let mut corners = [0; 3];
        for corner in &mut corners {
            let word = scanner.need(|| format!("a corner of triangle {i}"))?;
            *corner = scanner.index(word, "point", points, first_point)?;
        }
        attributes(scanner, extra)?;
        soup.face(&corners, line);
    }
    scanner.no_more("triangles", count, COUNT)
}

pub(super) fn optional_count(scanner: &mut Scanner<'_>) -> Result<u64, ReadError> {
    scanner.word().map_or(Ok(0), |word| scanner.count(word))
}

/// Reads the number of record `i` (from 0); the first one must be 0 or 1 and sets where the numbers begin.
pub(super) fn record(
    scanner: &mut Scanner<'_>,
    i: u64,
    count: u64,
    first: &mut i64,
    what: &'static str,
) -> Result<u32, ReadError> {
    let word = scanner.need_anywhere(|| format!("{what} {i} of {count}"))?;
    let number = scanner.integer(word)?;
    if i == 0 && (number == 0 || number == 1) {
        *first = number;
    }
    if number != *first + i as i64 {
        let help = "records are numbered one by one from 0 or from 1";
        return Err(scanner.expected(word, format!("the number {} of the next {what}", *first + i as i64), help));
    }
    Ok(scanner.line())
}

/// The x and the y of a record.
pub(super) fn position(scanner: &mut Scanner<'_>, i: u64, what: &str) -> Result<[f64; 2], ReadError> {
    let x = scanner.need_coordinate('x', || format!("{what} {i}"))?;
    Ok([x, scanner.need_coordinate('y', || format!("{what} {i}"))?])
}

pub(super) fn attributes(scanner: &mut Scanner<'_>, count: u64) -> Result<(), ReadError> {
    for _ in 0..count {
        let word = scanner.need(|| "an attribute or marker".to_owned())?;
        scanner.number(word)?;
    }
    scanner.end_of_line("this is more than the first line of the file announces")
}
