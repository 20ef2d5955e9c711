//! Wavefront OBJ.
//!
//! ```text
//!   v 0 0 0            v 1 0 0            a point: x y z, then perhaps w, then perhaps a colour
//!   v 1 1 0            v 0 1 0            (up to four numbers behind z are ignored)
//!   f 1 2 3 4                             a face: corners counted from 1
//!   f 1/1 2/2 3/3      f 1//5 2//6 3//7   corner / texture / normal; only the corner counts
//!   f -4 -3 -2                            counted backwards from the last point so far
//!   g floor ramp       usemtl stone       o house: names of the faces that follow
//! ```
//!
//! A face may use a point that comes later in the file; counting backwards it cannot. All other statements
//! are skipped: the usual ones in silence, unknown ones with a note. `z` may be missing.
//!
//! Own reader: crate tobj gives no line numbers, splits the points by texture and drops faces' line numbers.
//!
//! Source: the OBJ chapter of the Advanced Visualizer manual, appendix B1 (Wavefront, 1993).

use super::blocks::Blocks;
use super::document::{Document, Read};
use super::format::Format;
use super::labels::Labels;
use super::problem::{ReadError, ReadProblem};
use super::soup::{PolygonSoup, SoupBuilder};
use super::text::{Scanner, Syntax, Word, no_such, parse_integer};
use super::words::counted;

const SYNTAX: Syntax = Syntax { comments: true, continuation: true, quotes: false, separators: false };

/// Statements of the format that say nothing about points and faces.
const SKIPPED: [&[u8]; 36] = [
    b"vn",
    b"vt",
    b"vp",
    b"o",
    b"g",
    b"s",
    b"mg",
    b"l",
    b"p",
    b"mtllib",
    b"usemtl",
    b"maplib",
    b"usemap",
    b"bevel",
    b"c_interp",
    b"d_interp",
    b"lod",
    b"shadow_obj",
    b"trace_obj",
    b"ctech",
    b"stech",
    b"cstype",
    b"deg",
    b"bmat",
    b"step",
    b"curv",
    b"curv2",
    b"surf",
    b"parm",
    b"trim",
    b"hole",
    b"scrv",
    b"sp",
    b"end",
    b"con",
    b"call",
];
/// Those of them that end with a name, in which a final `\` does not join lines.
const NAMED: [&[u8]; 6] = [b"o", b"g", b"mtllib", b"usemtl", b"maplib", b"usemap"];

/// The greatest corner that is larger than the number of points so far.
struct Forward<'a> {
    index: i64,
    word: Option<Word<'a>>,
}

/// The first line with an unknown statement.
struct Unknown {
    /// What is said of it if the file has no points.
    error: ReadError,
    /// How many such lines there are.
    count: usize,
}

/// Reads an OBJ file. O(length).
pub(super) fn read(blocks: &mut Blocks<'_>) -> Result<Read, ReadError> {
    let source = blocks.source();
    let mut soup = SoupBuilder::default();
    let mut corners = Vec::new();
    let (mut greatest, mut greatest_at) = (0, None);
    let mut unknown: Option<Unknown> = None;
    let mut gives_z = false;
    let (mut named, mut labels) = (Named::default(), Labels::default());
    while let Some(block) = blocks.joining().next()? {
        if block.is_part {
            soup.make_room(block.bytes.len(), source)?;
            labels.make_room(block.bytes.len() / 2, source)?;
        }
        let mut scanner = Scanner::of_block(block, SYNTAX);
        let mut forward = Forward { index: greatest, word: None };
        loop {
            if let Some(statement) = scanner.word() {
                match statement.text {
                    b"v" => point(&mut scanner, &mut soup, &mut gives_z)?,
                    b"f" | b"fo" => face(&mut scanner, &mut soup, &mut corners, &mut forward)?,
                    text if NAMED.contains(&text) => {
                        let rest = String::from_utf8_lossy(scanner.rest_of_line());
                        if named.take(text, &rest) {
                            labels.begin(soup.faces.face_count() as u32, named.all());
                        }
                    }
                    text if SKIPPED.contains(&text) => {}
                    text if std::str::from_utf8(text).is_err() => {
                        return Err(scanner.error(statement.at, ReadProblem::NotText, "save the file as UTF-8 text"));
                    }
                    _ => match &mut unknown {
                        Some(unknown) => unknown.count += 1,
                        None => unknown = Some(Unknown { error: unknown_statement(&scanner, statement), count: 1 }),
                    },
                }
            }
            if !scanner.next_line() {
                break;
            }
        }
        if let Some(word) = forward.word {
            (greatest, greatest_at) = (forward.index, Some(scanner.place(word.at)));
        }
    }
    if let Some(place) = greatest_at.filter(|_| greatest > soup.points.len() as i64) {
        let (problem, help) = no_such("vertex", greatest, soup.points.len() as u64, 1);
        return Err(ReadError::at(source, place, problem, help));
    }
    let mut notes = Vec::new();
    if let Some(Unknown { error, count }) = unknown {
        let ReadProblem::UnknownWord { word } = &*error.what else { return Err(error) };
        if soup.points.is_empty() {
            return Err(error);
        }
        let (one, many) = ("line with an unknown statement was", "lines with unknown statements were");
        notes.push(format!("{} skipped, the first starts with `{word}`", counted(count, one, many)));
    }
    let soup = PolygonSoup { labels, ..soup.finish(source, gives_z)? };
    Ok(Read { document: Document::Polygons(soup), notes, format: Format::Obj })
}

fn unknown_statement(scanner: &Scanner<'_>, word: Word<'_>) -> ReadError {
    let help = "an OBJ file has lines such as `v 0 0 0` and `f 1 2 3`; say the format if it is another one";
    scanner.error(word.at, ReadProblem::UnknownWord { word: word.show() }, help)
}

/// The names that hold for the next face.
#[derive(Default)]
struct Named {
    groups: Vec<String>,
    object: Option<String>,
    material: Option<String>,
}

impl Named {
    /// Takes the names of a statement. Returns whether it is one that names faces.
    fn take(&mut self, statement: &[u8], rest: &str) -> bool {
        let whole = || Some(rest.to_owned()).filter(|name| !name.is_empty());
        match statement {
            b"g" => self.groups = rest.split_whitespace().map(str::to_owned).collect(),
            b"o" => self.object = whole(),
            b"usemtl" => self.material = whole(),
            _ => return false,
        }
        true
    }

    fn all(&self) -> Vec<String> {
        let mut all: Vec<String> = Vec::new();
        for name in self.groups.iter().chain(&self.object).chain(&self.material) {
            if !all.contains(name) {
                all.push(name.clone());
            }
        }
        all
    }
}

fn point(scanner: &mut Scanner<'_>, soup: &mut SoupBuilder, gives_z: &mut bool) -> Result<(), ReadError> {
    let line = scanner.line();
    let number = soup.points.len() + 1;
    let mut point = [0.0; 3];
    for (value, axis) in point.iter_mut().zip(['x', 'y']) {
        *value = scanner.need_coordinate(axis, || format!("vertex {number}"))?;
    }
    if let Some(word) = scanner.word() {
        point[2] = scanner.coordinate('z', word)?;
        *gives_z = true;
        for _ in 0..4 {
            let Some(word) = scanner.word() else { break };
            scanner.number(word)?;
        }
        scanner.end_of_line("a vertex has x y z and at most four numbers more")?;
    }
    soup.point(point, line);
    Ok(())
}

fn face<'a>(
    scanner: &mut Scanner<'a>,
    soup: &mut SoupBuilder,
    corners: &mut Vec<u32>,
    forward: &mut Forward<'a>,
) -> Result<(), ReadError> {
    let line = scanner.line();
    corners.clear();
    while let Some(word) = scanner.word() {
        corners.push(corner(scanner, word, soup.points.len() as i64, forward)?);
    }
    if corners.is_empty() {
        return Err(scanner.missing("the corners of a face".to_owned()));
    }
    soup.face(corners, line);
    Ok(())
}

/// The point of a corner `v`, `v/t`, `v//n` or `v/t/n`, from 0.
#[inline]
fn corner<'a>(scanner: &Scanner<'a>, word: Word<'a>, points: i64, forward: &mut Forward<'a>) -> Result<u32, ReadError> {
    let length = word.text.iter().position(|&b| b == b'/').unwrap_or(word.text.len());
    let (number, rest) = word.text.split_at(length);
    let Some(index) = parse_integer(number).filter(|_| good_rest(rest)) else {
        return Err(scanner.expected(word, "a corner such as 3, 3/1, 3//2 or 3/1/2", ""));
    };
    if index > points.max(forward.index) {
        *forward = Forward { index, word: Some(word) };
    }
    let from_zero = if index < 0 { points + index } else { index - 1 };
    u32::try_from(from_zero).map_err(|_| {
        let help = match index {
            0 => "OBJ counts from 1; -1 is the last vertex so far".to_owned(),
            1.. => "no file has that many".to_owned(),
            _ => format!("only {points} vertices come before this line"),
        };
        let problem = ReadProblem::IndexOutOfRange { what: "vertex", index, count: points as u64 };
        scanner.error(word.at, problem, help)
    })
}

/// Whether the texture and normal of a corner are numbers or empty: ``, `/`, `/1`, `//2`, `/1/2`.
#[inline]
fn good_rest(rest: &[u8]) -> bool {
    rest.is_empty() || {
        let mut parts = rest[1..].split(|&b| b == b'/');
        let good = |part: &[u8]| part.is_empty() || parse_integer(part).is_some();
        parts.next().is_some_and(good) && parts.next().is_none_or(good) && parts.next().is_none()
    }
}
