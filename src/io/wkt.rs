//! Well-known text: points, lines and polygons, read as points and segments.
//!
//! ```text
//!   POINT (2 1)                                        a point by itself
//!   LINESTRING (0 0, 4 0, 4 3)                         two segments
//!   POLYGON ((0 0, 9 0, 9 9, 0 0), (2 1, 3 1, 3 2, 2 1))   the segments of its rings
//!   MULTIPOINT ((0 0), (1 1))   MULTILINESTRING ((0 0, 1 1), (2 2, 3 3))   MULTIPOLYGON (((...)), ...)
//!   GEOMETRYCOLLECTION (POINT (0 0), LINESTRING EMPTY)
//! ```
//!
//! A file holds any number of geometries, separated by white space or `;`; a number before one is its label and is
//! stepped over, as is `SRID=4326;`. `#` starts a comment. Words may be written in capitals or not. Z and M are
//! dropped with a note.
//!
//! Own reader on the kit's errors: crates for it name neither line nor column.
//!
//! Source: OGC 06-103r4, *Simple feature access*, part 1, section 7.

use super::document::{Document, Read};
use super::format::Format;
use super::problem::{ReadError, ReadProblem};
use super::soup::SegmentSoup;
use super::text::{check_text, line_and_column};
use super::words::counted;
use crate::plane::check_coordinate;

/// Collections may lie in each other so deep.
const DEEPEST: usize = 64;

#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    Point,
    Line,
    Polygon,
    Points,
    Lines,
    Polygons,
    Collection,
}

const KINDS: [(&str, Kind); 8] = [
    ("POINT", Kind::Point),
    ("LINESTRING", Kind::Line),
    ("LINEARRING", Kind::Line),
    ("POLYGON", Kind::Polygon),
    ("MULTIPOINT", Kind::Points),
    ("MULTILINESTRING", Kind::Lines),
    ("MULTIPOLYGON", Kind::Polygons),
    ("GEOMETRYCOLLECTION", Kind::Collection),
];

fn kind_of(word: &str) -> Option<Kind> {
    KINDS.iter().find(|(name, _)| name.eq_ignore_ascii_case(word)).map(|&(_, kind)| kind)
}

/// Whether the first word of a file begins a geometry.
pub(super) fn starts_geometry(word: &str) -> bool {
    let name: String = word.chars().take_while(char::is_ascii_alphabetic).collect();
    kind_of(&name).is_some() || word.to_ascii_uppercase().starts_with("SRID=")
}

/// Reads a file. O(length).
pub(super) fn read(bytes: &[u8], source: &str) -> Result<Read, ReadError> {
    check_text(bytes, source)?;
    let start = if bytes.starts_with(b"\xef\xbb\xbf") { 3 } else { 0 };
    let mut reader = Reader { bytes, source, at: start, line: 1, soup: SegmentSoup::new(source), dropped: 0, extra: 0 };
    while let Some(token) = reader.peek()? {
        match token {
            Token::Sign(b';') => drop(reader.next()?),
            Token::Number(_) => {
                reader.next()?;
                reader.geometry(0)?;
            }
            Token::Word(word) if word.eq_ignore_ascii_case("SRID") => {
                reader.next()?;
                reader.sign(b'=')?;
                reader.number("the number of the reference system")?;
            }
            _ => reader.geometry(0)?,
        }
    }
    let mut notes = Vec::new();
    if reader.dropped > 0 {
        notes.push(format!("the third coordinate of {} was dropped", counted(reader.dropped, "point", "points")));
    }
    Ok(Read { document: Document::Segments(reader.soup.checked()?), notes, format: Format::Wkt })
}

struct Reader<'a> {
    bytes: &'a [u8],
    source: &'a str,
    at: usize,
    line: u32,
    soup: SegmentSoup,
    /// How many points had more than two coordinates.
    dropped: usize,
    /// How many coordinates beyond two the geometry at hand says it has; 0 if it does not say.
    extra: usize,
}

#[derive(Clone, Copy, PartialEq)]
enum Token<'a> {
    Word(&'a str),
    Number(f64),
    Sign(u8),
}

impl<'a> Reader<'a> {
    fn skip_blanks(&mut self) {
        while let Some(&b) = self.bytes.get(self.at) {
            match b {
                b'\r' if self.bytes.get(self.at + 1) == Some(&b'\n') => {}
                b'\n' | b'\r' => self.line += 1,
                b'#' => {
                    let rest = &self.bytes[self.at..];
                    self.at += rest.iter().position(|b| matches!(b, b'\n' | b'\r')).unwrap_or(rest.len());
                    continue;
                }
                _ if b.is_ascii_whitespace() => {}
                _ => return,
            }
            self.at += 1;
        }
    }

    /// The token at hand and where it ends; none at the end of the file.
    fn look(&mut self) -> Result<Option<(Token<'a>, usize)>, ReadError> {
        self.skip_blanks();
        let rest = &self.bytes[self.at..];
        let Some(&first) = rest.first() else { return Ok(None) };
        let length = |part: fn(&u8) -> bool| rest.iter().position(|b| !part(b)).unwrap_or(rest.len());
        let text = |length: usize| std::str::from_utf8(&rest[..length]).ok();
        let (token, length) = match first {
            b'a'..=b'z' | b'A'..=b'Z' => {
                let length = length(u8::is_ascii_alphabetic);
                (text(length).map(Token::Word), length)
            }
            b'0'..=b'9' | b'-' | b'+' | b'.' => {
                let length = length(|b| matches!(b, b'0'..=b'9' | b'-' | b'+' | b'.' | b'e' | b'E'));
                (text(length).and_then(|text| text.parse().ok()).map(Token::Number), length)
            }
            b'(' | b')' | b',' | b';' | b'=' => (Some(Token::Sign(first)), 1),
            _ => (None, 1),
        };
        match token {
            Some(token) => Ok(Some((token, self.at + length))),
            None if std::str::from_utf8(self.bytes).is_err() => Err(self.error(ReadProblem::NotText, "")),
            None => {
                let word: String = String::from_utf8_lossy(&rest[..rest.len().min(40)])
                    .chars()
                    .take_while(|c| !c.is_whitespace() && !matches!(c, ',' | '(' | ')'))
                    .collect();
                Err(self.error(ReadProblem::NotANumber { word, wanted: "a geometry or a number" }, ""))
            }
        }
    }

    fn peek(&mut self) -> Result<Option<Token<'a>>, ReadError> {
        Ok(self.look()?.map(|(token, _)| token))
    }

    fn next(&mut self) -> Result<Option<Token<'a>>, ReadError> {
        let found = self.look()?;
        Ok(found.map(|(token, end)| {
            self.at = end;
            token
        }))
    }

    fn error(&self, what: ReadProblem, help: &'static str) -> ReadError {
        let (line, column) = line_and_column(self.bytes, self.at);
        ReadError { line: Some(line), column: Some(column), ..ReadError::whole(self.source, what, help) }
    }

    /// The error that something else stands here.
    fn expected(&mut self, wanted: &'static str) -> ReadError {
        let found = match self.look() {
            Err(error) => return error,
            Ok(None) => "the end of the file".to_owned(),
            Ok(Some((_, end))) => format!("`{}`", String::from_utf8_lossy(&self.bytes[self.at..end])),
        };
        self.error(ReadProblem::Expected { wanted: wanted.into(), found }, "")
    }

    fn sign(&mut self, sign: u8) -> Result<(), ReadError> {
        if self.peek()? == Some(Token::Sign(sign)) {
            self.next()?;
            return Ok(());
        }
        Err(self.expected(match sign {
            b'(' => "`(`",
            b')' => "`,` or `)`",
            _ => "`=`",
        }))
    }

    fn number(&mut self, wanted: &'static str) -> Result<f64, ReadError> {
        match self.peek()? {
            Some(Token::Number(value)) => {
                self.next()?;
                Ok(value)
            }
            _ => Err(self.expected(wanted)),
        }
    }

    fn coordinate(&mut self, axis: char, wanted: &'static str) -> Result<f64, ReadError> {
        self.skip_blanks();
        let before = self.at;
        let value = self.number(wanted)?;
        check_coordinate(axis, value).map_err(|error| {
            self.at = before;
            self.error(error.into(), "")
        })?;
        Ok(value)
    }

    fn geometry(&mut self, depth: usize) -> Result<(), ReadError> {
        let wanted = "POINT, LINESTRING, POLYGON, a MULTI of these or GEOMETRYCOLLECTION";
        let Some(Token::Word(word)) = self.peek()? else { return Err(self.expected(wanted)) };
        // Z and M may be written onto the word.
        let bare = word.trim_end_matches(['Z', 'z', 'M', 'm']);
        let (kind, suffix) = match (kind_of(word), kind_of(bare)) {
            (Some(kind), _) => (kind, 0),
            (None, Some(kind)) => (kind, word.len() - bare.len()),
            (None, None) => return Err(self.error(ReadProblem::UnknownWord { word: word.to_owned() }, wanted)),
        };
        self.next()?;
        self.extra = suffix;
        if let Some(Token::Word(word)) = self.peek()?
            && ["Z", "M", "ZM"].iter().any(|known| known.eq_ignore_ascii_case(word))
        {
            self.extra = word.len();
            self.next()?;
        }
        match kind {
            Kind::Point => self.list(|reader| reader.point().map(drop)),
            Kind::Line => self.line_string(false),
            Kind::Polygon => self.list(|reader| reader.line_string(true)),
            Kind::Points => self.list(|reader| match reader.peek()? {
                Some(Token::Sign(b'(') | Token::Word(_)) => reader.list(|reader| reader.point().map(drop)),
                _ => reader.point().map(drop),
            }),
            Kind::Lines => self.list(|reader| reader.line_string(false)),
            Kind::Polygons => self.list(|reader| reader.list(|reader| reader.line_string(true))),
            Kind::Collection if depth == DEEPEST => {
                let what = "a collection in so many others".into();
                Err(self.error(ReadProblem::Refused { what }, "write the geometries one after another"))
            }
            Kind::Collection => self.list(|reader| reader.geometry(depth + 1)),
        }
    }

    /// `EMPTY`, or items in brackets.
    fn list(&mut self, mut item: impl FnMut(&mut Self) -> Result<(), ReadError>) -> Result<(), ReadError> {
        if matches!(self.peek()?, Some(Token::Word(word)) if word.eq_ignore_ascii_case("EMPTY")) {
            self.next()?;
            return Ok(());
        }
        self.sign(b'(')?;
        loop {
            item(self)?;
            if self.peek()? != Some(Token::Sign(b',')) {
                return self.sign(b')');
            }
            self.next()?;
        }
    }

    fn point(&mut self) -> Result<u32, ReadError> {
        let x = self.coordinate('x', "the x of a point")?;
        let line = self.line;
        let y = self.coordinate('y', "the y of a point")?;
        let mut more = 0;
        while more < 2 && matches!(self.peek()?, Some(Token::Number(_))) {
            self.next()?;
            more += 1;
        }
        if more < self.extra {
            return Err(self.expected("as many coordinates as the geometry says"));
        }
        self.dropped += usize::from(more > 0);
        Ok(self.soup.point([x, y], line))
    }

    /// A chain of points; that of a ring must end where it starts.
    fn line_string(&mut self, ring: bool) -> Result<(), ReadError> {
        let first = self.soup.points.len();
        self.skip_blanks();
        let start = self.at;
        self.list(|reader| reader.point().map(drop))?;
        let points = &self.soup.points[first..];
        if points.len() == 1 {
            self.at = start;
            let problem = ReadProblem::Expected { wanted: "two points or more".into(), found: "one".to_owned() };
            return Err(self.error(problem, "points are separated by commas"));
        }
        if let (true, Some(&a), Some(&b)) = (ring, points.first(), points.last()) {
            if a != b {
                self.at = start;
                let problem = ReadProblem::UnclosedRing {
                    place: "polygon".to_owned(),
                    first: a.to_string(),
                    last: b.to_string(),
                };
                return Err(self.error(problem, "repeat the first point of the ring at its end"));
            }
            // The last point is the first one.
            self.soup.points.pop();
            self.soup.point_lines.pop();
        }
        self.soup.chain(first as u32, ring);
        Ok(())
    }
}
