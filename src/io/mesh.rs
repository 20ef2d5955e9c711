//! Navigation meshes of polyanya, version 2.
//!
//! ```text
//!   mesh                    the header and the version
//!   2
//!   4 2                     points, polygons
//!   0 0  2 0 -1             x y, the number of polygons round the point, those polygons (-1 = none)
//!   1 0  3 0 1 -1
//!   ...
//!   3 0 1 3  -1 -1 1        the number of corners, the corners from 0 counter-clockwise, and the
//!   3 1 2 3  0 -1 -1        neighbour behind each edge (-1 = none)
//! ```
//!
//! Line ends mean no more than blanks. The neighbours are checked for their range and left out: the builder
//! finds them again from the corners.
//!
//! Source: the description of the format beside polyanya (M. Cui, D. Harabor, A. Grastien, 2017).

use super::format::Format;
use super::problem::{ReadError, ReadProblem};
use super::read::{Document, Read};
use super::soup::SoupBuilder;
use super::text::{Scanner, Syntax};

const SYNTAX: Syntax = Syntax { comments: true, continuation: false, quotes: false };

/// Reads a `.mesh` file. O(length).
pub(super) fn read(bytes: &[u8], source: &str) -> Result<Read, ReadError> {
    let mut scanner = Scanner::new(bytes, source, SYNTAX)?;
    header(&mut scanner)?;
    let word = scanner.need_anywhere(|| "the number of points".to_owned())?;
    let points = scanner.count(word)?;
    let word = scanner.need_anywhere(|| "the number of polygons".to_owned())?;
    let polygons = scanner.count(word)?;
    let mut soup = SoupBuilder::with_room(points, scanner.remaining(), 6);
    for i in 0..points {
        let word = scanner.need_anywhere(|| format!("vertex {i} of {points}"))?;
        let line = scanner.line();
        let x = scanner.coordinate('x', word)?;
        let word = scanner.need_anywhere(|| format!("the y of vertex {i}"))?;
        let y = scanner.coordinate('y', word)?;
        let word = scanner.need_anywhere(|| format!("the number of polygons round vertex {i}"))?;
        let count = scanner.count(word)?;
        neighbours(&mut scanner, count, polygons, || format!("the polygons round vertex {i}"))?;
        soup.point([x, y, 0.0], line);
    }
    let mut corners = Vec::new();
    for i in 0..polygons {
        corners.clear();
        let word = scanner.need_anywhere(|| format!("polygon {i} of {polygons}"))?;
        let line = scanner.line();
        let count = scanner.count(word)?;
        if count == 0 {
            return Err(scanner.expected(word, "the number of corners, at least 1", ""));
        }
        for k in 0..count {
            let word = scanner.need_anywhere(|| format!("corner {k} of {count} of polygon {i}"))?;
            corners.push(scanner.index(word, "vertex", points, 0)?);
        }
        neighbours(&mut scanner, count, polygons, || format!("the neighbours of polygon {i}"))?;
        soup.face(&corners, line);
    }
    if let Some(word) = scanner.word_anywhere() {
        let problem = ReadProblem::MoreThanCounted { what: "polygons", count: polygons };
        return Err(scanner.error(word.at, problem, "correct the counts in the third line"));
    }
    Ok(Read { document: Document::Polygons(soup.finish(source, false)?), notes: Vec::new(), format: Format::Mesh })
}

fn header(scanner: &mut Scanner<'_>) -> Result<(), ReadError> {
    let word = scanner.need_anywhere(|| "the word `mesh`".to_owned())?;
    if word.text.starts_with(b"MeshVersion") {
        let what = "a .mesh file of Medit";
        return Err(scanner.error(word.at, ReadProblem::Refused { what: what.into() }, "convert it to OFF or PLY"));
    }
    if word.text != b"mesh" {
        return Err(scanner.expected(word, "the word `mesh`", "the kit reads polyanya's .mesh, version 2"));
    }
    let word = scanner.need_anywhere(|| "the version, 2".to_owned())?;
    match scanner.integer(word)? {
        2 => Ok(()),
        _ => Err(scanner.expected(word, "version 2", "in version 1 the neighbours stand one place further on")),
    }
}

/// Steps over `count` polygon numbers, -1 among them.
fn neighbours(
    scanner: &mut Scanner<'_>,
    count: u64,
    polygons: u64,
    inside: impl Fn() -> String,
) -> Result<(), ReadError> {
    for _ in 0..count {
        let word = scanner.need_anywhere(&inside)?;
        if word.text != b"-1" {
            scanner.index(word, "polygon", polygons, 0)?;
        }
    }
    Ok(())
}
