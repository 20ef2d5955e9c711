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

use super::blocks::Blocks;
use super::document::{Document, Read};
use super::format::Format;
use super::problem::{ReadError, ReadProblem};
use super::room::too_little;
use super::soup::SoupBuilder;
use super::text::{Scanner, Syntax, Word, parse_integer};
use super::words::counted;

const SYNTAX: Syntax = Syntax { comments: true, continuation: false, quotes: false, separators: false };

/// Reads an OFF file. O(length). If the blocks cannot be had again, a header that counts wrongly is an error.
pub(super) fn read(blocks: &mut Blocks<'_>) -> Result<Read, ReadError> {
    let mut head = Head::default();
    let (soup, notes) = match elements(blocks, &mut head, None) {
        Ok(soup) => (soup, Vec::new()),
        Err(error) => {
            let Some(header) = head.counts.filter(|_| !matches!(*error.what, ReadProblem::OutOfMemory { .. })) else {
                return Err(error);
            };
            let lines = if blocks.restart()? { Counts::of_lines(blocks)? } else { None };
            let Some(found) = lines.filter(|found| found.is_likely(header)) else { return Err(error) };
            blocks.restart()?;
            (elements(blocks, &mut Head::default(), Some(found))?, vec![found.differ_from(header)])
        }
    };
    let soup = soup.finish(blocks.source(), true)?;
    Ok(Read { document: Document::Polygons(soup), notes, format: Format::Off })
}

/// The points and faces of the file, if it has as many as `counts` says, or else its header.
fn elements(blocks: &mut Blocks<'_>, head: &mut Head, counts: Option<Counts>) -> Result<SoupBuilder, ReadError> {
    let source = blocks.source();
    let mut started: Option<(SoupBuilder, Counts)> = None;
    let mut corners = Vec::new();
    while let Some(block) = blocks.next()? {
        let (left, is_last, room) = (block.left, block.is_last, block.is_part.then_some(block.bytes.len()));
        let mut scanner = Scanner::of_block(block, SYNTAX);
        let (soup, Counts { points, faces }) = match &mut started {
            Some((soup, counts)) => (soup, *counts),
            None => {
                let Some(header) = head.read(&mut scanner)? else {
                    if is_last {
                        return Err(scanner.missing(head.wanted().to_owned()));
                    }
                    continue;
                };
                let counts = counts.unwrap_or(header);
                let soup = SoupBuilder::with_room(counts.points, left - scanner.at(), 6, source)?;
                let (soup, counts) = started.insert((soup, counts));
                (soup, *counts)
            }
        };
        if let Some(bytes) = room {
            soup.make_room(bytes, source)?;
        }
        let mut word = scanner.word_anywhere();
        while let Some(first) = word {
            let (i, f) = (soup.points.len() as u64, soup.faces.face_count() as u64);
            if i < points {
                point(&mut scanner, soup, first, i)?;
            } else if f < faces {
                face(&mut scanner, soup, first, f, points, &mut corners)?;
                scanner.next_line();
            } else {
                let problem = ReadProblem::MoreThanCounted { what: "faces", count: faces };
                return Err(scanner.error(first.at, problem, "correct the counts below the word OFF"));
            }
            word = scanner.word_anywhere();
        }
        if is_last {
            let (i, f) = (soup.points.len() as u64, soup.faces.face_count() as u64);
            if i < points {
                return Err(scanner.missing(format!("vertex {i} of {points}")));
            }
            if f < faces {
                return Err(scanner.missing(format!("face {f} of {faces}")));
            }
        }
    }
    Ok(started.map(|(soup, _)| soup).unwrap_or_default())
}

/// What stands before the points.
#[derive(Default)]
struct Head {
    has_word: bool,
    counts: Option<Counts>,
}

impl Head {
    /// Reads on. Nothing if the block ends before the counts.
    fn read(&mut self, scanner: &mut Scanner<'_>) -> Result<Option<Counts>, ReadError> {
        if !self.has_word {
            let Some(word) = scanner.word_anywhere() else { return Ok(None) };
            header(scanner, word)?;
            self.has_word = true;
        }
        let Some(word) = scanner.word_anywhere() else { return Ok(None) };
        let points = scanner.count(word)?;
        let word = scanner.need(|| "the number of faces".to_owned())?;
        let faces = scanner.count(word)?;
        if let Some(word) = scanner.word() {
            scanner.count(word)?;
            scanner.end_of_line("the counts are points, faces and edges")?;
        }
        self.counts = Some(Counts { points, faces });
        Ok(self.counts)
    }

    /// What is missing where it ends.
    fn wanted(&self) -> &'static str {
        if self.has_word { "the number of points" } else { "the word OFF" }
    }
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
    fn of_lines(blocks: &mut Blocks<'_>) -> Result<Option<Self>, ReadError> {
        // Of each line the number of words, and the greatest corner if it can be a face.
        let mut lines: Vec<(usize, Option<i64>)> = Vec::new();
        let (source, mut head) = (blocks.source(), Head::default());
        while let Some(block) = blocks.next()? {
            let length = block.bytes.len();
            if lines.try_reserve(length / 2 + 1).is_err() {
                return Err(too_little((lines.len() + length / 2) * size_of::<(usize, Option<i64>)>(), source));
            }
            let mut scanner = Scanner::of_block(block, SYNTAX);
            if head.counts.is_some() || head.read(&mut scanner)?.is_some() {
                lines_of(&mut scanner, &mut lines);
            }
        }
        let faces = lines.iter().rev().take_while(|(_, greatest)| greatest.is_some()).count();
        let (points, faces) = lines.split_at(lines.len() - faces);
        let Some(&(width, _)) = points.first() else { return Ok(None) };
        let fits = width >= 3
            && points.iter().all(|&(words, _)| words == width)
            && faces.iter().all(|&(_, greatest)| greatest.is_some_and(|corner| corner < points.len() as i64));
        Ok(fits.then_some(Self { points: points.len() as u64, faces: faces.len() as u64 }))
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

/// Of each line that is left the number of words, and the greatest corner if it can be a face.
fn lines_of(scanner: &mut Scanner<'_>, lines: &mut Vec<(usize, Option<i64>)>) {
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
}

/// Steps over the header word, if there is one; the counts may follow it directly.
fn header(scanner: &mut Scanner<'_>, word: Word<'_>) -> Result<(), ReadError> {
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

fn point<'a>(scanner: &mut Scanner<'a>, soup: &mut SoupBuilder, word: Word<'a>, i: u64) -> Result<(), ReadError> {
    let line = scanner.line();
    let mut point = [0.0; 3];
    point[0] = scanner.coordinate('x', word)?;
    for (value, axis) in point[1..].iter_mut().zip(['y', 'z']) {
        *value = scanner.need_coordinate(axis, || format!("vertex {i}"))?;
    }
    while let Some(word) = scanner.word() {
        scanner.number(word)?;
    }
    soup.point(point, line);
    Ok(())
}

fn face(
    scanner: &mut Scanner<'_>,
    soup: &mut SoupBuilder,
    word: Word<'_>,
    i: u64,
    points: u64,
    corners: &mut Vec<u32>,
) -> Result<(), ReadError> {
    corners.clear();
    let line = scanner.line();
    let count = scanner.count(word)?;
    if count == 0 {
        return Err(scanner.expected(word, "the number of corners, at least 1", ""));
    }
    for k in 0..count {
        let word = scanner.need(|| format!("corner {k} of {count} of face {i}"))?;
        corners.push(scanner.index(word, "vertex", points, 0)?);
    }
    soup.face(corners, line);
    Ok(())
}
