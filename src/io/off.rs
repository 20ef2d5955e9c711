//! Object File Format.
//!
//! ```text
//!   OFF                 the header; counts may follow on the same line, COFF NOFF STOFF ... are read, too
//!   4 2 5               points, faces, edges (the last is ignored and may be missing)
//!   0 0 0               one point a line; normals, colours and texture that follow are ignored
//!   1 0 0
//!   1 1 0   # peak
//!   0 1 0
//!   3 0 1 2             one face a line: the number of corners, the corners from 0, then perhaps a colour
//!   3 0 2 3  255 0 0
//! ```
//!
//! A header that counts wrongly is noted, if the lines leave no doubt which of them are points.
//!
//! Not read, by name: binary files, `4OFF` and `nOFF` (points of other dimensions).
//!
//! Source: the Geomview manual, section "OFF".

use super::document::{Document, Read};
use super::format::Format;
use super::problem::{ReadError, ReadProblem};
use super::soup::SoupBuilder;
use super::text::{Scanner, Syntax, parse_integer};
use super::words::counted;

const SYNTAX: Syntax = Syntax { comments: true, continuation: false, quotes: false };

/// Reads an OFF file. O(length).
pub(super) fn read(bytes: &[u8], source: &str) -> Result<Read, ReadError> {
    let mut scanner = Scanner::new(bytes, source, SYNTAX)?;
    header(&mut scanner)?;
    let word = scanner.need_anywhere(|| "the number of points".to_owned())?;
    let points = scanner.count(word)?;
    let word = scanner.need(|| "the number of faces".to_owned())?;
    let faces = scanner.count(word)?;
    if let Some(word) = scanner.word() {
        scanner.count(word)?;
        scanner.end_of_line("the counts are points, faces and edges")?;
    }
    let header = Counts { points, faces };
    let (soup, notes) = match elements(scanner.clone(), header) {
        Ok(soup) => (soup, Vec::new()),
        Err(error) => match Counts::of_lines(scanner.clone()).filter(|found| found.is_likely(header)) {
            Some(found) => (elements(scanner, found)?, vec![found.differ_from(header)]),
            None => return Err(error),
        },
    };
    Ok(Read { document: Document::Polygons(soup.finish(source, true)?), notes, format: Format::Off })
}

/// The points and faces of the file, if it has as many as that.
fn elements(mut scanner: Scanner<'_>, Counts { points, faces }: Counts) -> Result<SoupBuilder, ReadError> {
    let mut soup = SoupBuilder::with_room(points, scanner.remaining(), 6, scanner.source())?;
    for i in 0..points {
        point(&mut scanner, &mut soup, i, points)?;
    }
    let mut corners = Vec::new();
    for i in 0..faces {
        corners.clear();
        let word = scanner.need_anywhere(|| format!("face {i} of {faces}"))?;
        let line = scanner.line();
        let count = scanner.count(word)?;
        if count == 0 {
            return Err(scanner.expected(word, "the number of corners, at least 1", ""));
        }
        for k in 0..count {
            let word = scanner.need(|| format!("corner {k} of {count} of face {i}"))?;
            corners.push(scanner.index(word, "vertex", points, 0)?);
        }
        soup.face(&corners, line);
        if !scanner.next_line() && i + 1 < faces {
            return Err(scanner.missing(format!("face {} of {faces}", i + 1)));
        }
    }
    if let Some(word) = scanner.word_anywhere() {
        let problem = ReadProblem::MoreThanCounted { what: "faces", count: faces };
        return Err(scanner.error(word.at, problem, "correct the counts below the word OFF"));
    }
    Ok(soup)
}

/// How many elements there are.
#[derive(Clone, Copy, PartialEq, Eq)]
struct Counts {
    points: u64,
    faces: u64,
}

impl Counts {
    /// What the lines look like: first points of equally many numbers, then faces, as many of them as can be. Nothing
    /// if they look like anything else.
    fn of_lines(mut scanner: Scanner<'_>) -> Option<Self> {
        // Of each line the number of words, and the greatest corner if it can be a face.
        let mut lines: Vec<(usize, Option<i64>)> = Vec::new();
        let mut words = Vec::new();
        loop {
            words.clear();
            words.extend(std::iter::from_fn(|| scanner.word()));
            if !words.is_empty() {
                let numbers = || words.iter().map(|word| parse_integer(word.text));
                let corners = numbers().next().flatten().filter(|&n| n >= 3 && n < words.len() as i64);
                let greatest = corners.and_then(|n| {
                    let corners = numbers().skip(1).take(n as usize);
                    corners.collect::<Option<Vec<i64>>>()?.into_iter().max()
                });
                lines.push((words.len(), greatest));
            }
            if !scanner.next_line() {
                break;
            }
        }
        let faces = lines.iter().rev().take_while(|(_, greatest)| greatest.is_some()).count();
        let (points, faces) = lines.split_at(lines.len() - faces);
        let (width, _) = *points.first()?;
        let fits = width >= 3
            && points.iter().all(|&(words, _)| words == width)
            && faces.iter().all(|&(_, greatest)| greatest.is_some_and(|corner| corner < points.len() as i64));
        fits.then_some(Self { points: points.len() as u64, faces: faces.len() as u64 })
    }

    /// Whether a header that says something else may be wrong in one number only, or counts nothing at all: who writes a
    /// file from the front does not know yet.
    fn is_likely(self, header: Self) -> bool {
        let is_blank = header.points == 0 && header.faces == 0;
        self.faces > 0 && (is_blank || self.points == header.points || self.faces == header.faces)
    }

    fn differ_from(self, header: Self) -> String {
        let count = |counts: Self| {
            let points = counted(counts.points as usize, "point", "points");
            format!("{points} and {}", counted(counts.faces as usize, "face", "faces"))
        };
        format!("the header counts {}, the file has {}: is it whole?", count(header), count(self))
    }
}

/// Steps over the header word, if there is one; the counts may follow it directly.
fn header(scanner: &mut Scanner<'_>) -> Result<(), ReadError> {
    let word = scanner.need_anywhere(|| "the word OFF".to_owned())?;
    let Some(at) = word.text.windows(3).position(|part| part == b"OFF") else {
        if word.text.iter().all(u8::is_ascii_digit) {
            scanner.go_back_to(word.at);
            return Ok(());
        }
        return Err(scanner.expected(word, "the word OFF", ""));
    };
    let prefix = &word.text[..at];
    let rest = &word.text[at + 3..];
    let refused = |scanner: &Scanner<'_>, what: &'static str| {
        Err(scanner.error(word.at, ReadProblem::Refused { what: what.into() }, "save it as plain OFF text"))
    };
    if prefix.iter().any(|&b| b == b'4' || b == b'n') {
        return refused(scanner, "an OFF file with points of other dimensions (4OFF, nOFF)");
    }
    if !matches!(prefix, b"" | b"C" | b"N" | b"CN" | b"ST" | b"STC" | b"STN" | b"STCN" | b"NC") {
        return Err(scanner.expected(word, "the word OFF", "OFF, COFF, NOFF, CNOFF, STOFF and the like are read"));
    }
    if rest == b"BINARY" {
        return refused(scanner, "a binary OFF file");
    }
    if !rest.iter().all(u8::is_ascii_digit) {
        return Err(scanner.expected(word, "the word OFF", ""));
    }
    scanner.go_back_to(word.at + at + 3);
    let mut ahead = scanner.clone();
    match ahead.word() {
        Some(next) if next.text == b"BINARY" => refused(scanner, "a binary OFF file"),
        _ => Ok(()),
    }
}

fn point(scanner: &mut Scanner<'_>, soup: &mut SoupBuilder, i: u64, points: u64) -> Result<(), ReadError> {
    let mut word = scanner.need_anywhere(|| format!("vertex {i} of {points}"))?;
    let line = scanner.line();
    let mut point = [0.0; 3];
    point[0] = scanner.coordinate('x', word)?;
    for (value, axis) in point[1..].iter_mut().zip(['y', 'z']) {
        word = scanner.need(|| format!("the {axis} of vertex {i}"))?;
        *value = scanner.coordinate(axis, word)?;
    }
    while let Some(word) = scanner.word() {
        scanner.number(word)?;
    }
    soup.point(point, line);
    Ok(())
}
