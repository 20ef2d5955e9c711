//! Well-known text: polygons with holes, or points and segments.
//!
//! ```text
//!   POLYGON ((0 0, 9 0, 9 9, 0 0), (2 1, 3 1, 3 2, 2 1))   the outer ring, then its holes
//!   POINT (2 1)                                        a point by itself
//!   LINESTRING (0 0, 4 0, 4 3)                         two segments
//!   MULTIPOINT ((0 0), (1 1))   MULTILINESTRING ((0 0, 1 1), (2 2, 3 3))   MULTIPOLYGON (((...)), ...)
//!   GEOMETRYCOLLECTION (POINT (0 0), LINESTRING EMPTY)
//! ```
//!
//! A file holds any number of geometries, separated by white space or `;`; a number before one is its label and is
//! stepped over, as is `SRID=4326;`. `#` starts a comment. Words may be written in capitals or not. Z and M are
//! dropped with a note.
//!
//! It is the same as in GeoJSON: each polygon becomes one face, and lines and points beside polygons are skipped with a
//! note. A file without any polygon is read as segments and points; on request every file is, polygons by their outlines.
//! Polygons are numbered through the whole file, from 0, and rings in their polygon: `polygon 3 ring 1`.
//!
//! Own reader on the kit's errors: crates for it name neither line nor column.
//!
//! Source: OGC 06-103r4, *Simple feature access*, part 1, section 7.

use super::document::{Document, Read, ReadOptions};
use super::format::Format;
use super::geometries::Skipped;
use super::nodes::Fault;
use super::problem::{ReadError, ReadProblem};
use super::repaired::Repaired;
use super::rings::Rings;
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

/// The same, and how many letters for Z and M are written onto the word.
fn kind_with_suffix(word: &str) -> Option<(Kind, usize)> {
    let bare = word.trim_end_matches(['Z', 'z', 'M', 'm']);
    let with_suffix = || Some((kind_of(bare)?, word.len() - bare.len()));
    kind_of(word).map(|kind| (kind, 0)).or_else(with_suffix)
}

/// Whether the first word of a file begins a geometry.
pub(super) fn starts_geometry(word: &str) -> bool {
    let name: String = word.chars().take_while(char::is_ascii_alphabetic).collect();
    kind_with_suffix(&name).is_some() || word.to_ascii_uppercase().starts_with("SRID=")
}

/// Reads a file. O(length), and O(n log n) to join n equal points of polygons.
pub(super) fn read(bytes: &[u8], source: &str, options: &ReadOptions) -> Result<Read, ReadError> {
    check_text(bytes, source)?;
    let mut reader = Reader::new(bytes, source);
    if !options.outlines && reader.holds_polygons() {
        let mut rings = Rings::of_file(bytes.len());
        if options.close_rings {
            rings.close_rings();
        }
        reader.rings = Some(rings);
    }
    (reader.at, reader.line, reader.closes) = (reader.start(), 1, options.close_rings);
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
    reader.finish(options)
}

#[derive(Default)]
struct Reader<'a> {
    bytes: &'a [u8],
    source: &'a str,
    at: usize,
    line: u32,
    /// Takes the points and segments; of a file with polygons the geometry at hand, for a moment.
    soup: SegmentSoup,
    /// Takes the polygons, if the file is read as such.
    rings: Option<Rings>,
    /// How many polygons there are so far.
    polygons: usize,
    skipped: Skipped,
    /// Of a file that is read as segments: whether rings are closed that do not end where they start, and which were.
    closes: bool,
    closed: Repaired,
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
    fn new(bytes: &'a [u8], source: &'a str) -> Self {
        let reader = Self { bytes, source, line: 1, soup: SegmentSoup::new(source), ..Self::default() };
        Self { at: reader.start(), ..reader }
    }

    /// Where the text starts, behind a byte order mark.
    fn start(&self) -> usize {
        if self.bytes.starts_with(b"\xef\xbb\xbf") { 3 } else { 0 }
    }

    /// Whether there is a polygon that is not empty. What is wrong before the first one is told when it is read.
    fn holds_polygons(&mut self) -> bool {
        let mut begun = false;
        while let Ok(Some(token)) = self.next() {
            begun = match token {
                Token::Sign(b'(') if begun => return true,
                // Between the kind and its bracket there may be a suffix.
                Token::Word(word) if !word.eq_ignore_ascii_case("EMPTY") => {
                    let kind = kind_with_suffix(word).map(|(kind, _)| kind);
                    matches!(kind, Some(Kind::Polygon | Kind::Polygons)) || (begun && kind.is_none())
                }
                _ => false,
            };
        }
        false
    }

    /// What was read, when all is.
    fn finish(self, options: &ReadOptions) -> Result<Read, ReadError> {
        let (bytes, source, format) = (self.bytes, self.source, Format::Wkt);
        let mut notes = Vec::new();
        self.skipped.note(&mut notes);
        self.closed.note_closed(&mut notes);
        if self.dropped > 0 {
            notes.push(format!("the third coordinate of {} was dropped", counted(self.dropped, "point", "points")));
        }
        let Some(rings) = self.rings else {
            let soup = SegmentSoup { mended_rings: self.closed.count(), ..self.soup };
            return Ok(Read { document: Document::Segments(soup.checked()?), notes, format });
        };
        let soup = rings.finish(source, options, bytes, &mut notes).map_err(|fault| named(fault, bytes, source))?;
        Ok(Read { document: Document::Polygons(soup), notes, format })
    }

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
        let Some((token, end)) = self.look()? else { return Ok(None) };
        self.at = end;
        Ok(Some(token))
    }

    fn error(&self, what: ReadProblem, help: &'static str) -> ReadError {
        ReadError::at(self.source, line_and_column(self.bytes, self.at), what, help)
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
        let Some(Token::Number(value)) = self.peek()? else { return Err(self.expected(wanted)) };
        self.next()?;
        Ok(value)
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
        let Some((kind, suffix)) = kind_with_suffix(word) else {
            return Err(self.error(ReadProblem::UnknownWord { word: word.to_owned() }, wanted));
        };
        self.next()?;
        self.extra = suffix;
        if let Some(Token::Word(word)) = self.peek()?
            && ["Z", "M", "ZM"].iter().any(|known| known.eq_ignore_ascii_case(word))
        {
            self.extra = word.len();
            self.next()?;
        }
        let first = self.soup.points.len();
        match kind {
            Kind::Point => self.list(|reader| reader.point().map(drop)),
            Kind::Line => self.line_string(),
            Kind::Polygon => self.polygon(),
            Kind::Points => self.list(|reader| match reader.peek()? {
                Some(Token::Sign(b'(') | Token::Word(_)) => reader.list(|reader| reader.point().map(drop)),
                _ => reader.point().map(drop),
            }),
            Kind::Lines => self.list(Self::line_string),
            Kind::Polygons => self.list(Self::polygon),
            Kind::Collection if depth == DEEPEST => {
                let what = "a collection in so many others".into();
                Err(self.error(ReadProblem::Refused { what }, "write the geometries one after another"))
            }
            Kind::Collection => self.list(|reader| reader.geometry(depth + 1)),
        }?;
        if self.rings.is_some() && self.soup.points.len() > first {
            self.skipped.add(if matches!(kind, Kind::Point | Kind::Points) { "Point" } else { "LineString" });
            self.soup.clear();
        }
        Ok(())
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

    /// A chain of points.
    fn line_string(&mut self) -> Result<(), ReadError> {
        let (first, _) = self.chain()?;
        self.soup.begin_path("");
        self.soup.chain(first as u32, false);
        Ok(())
    }

    /// The points in brackets: the number of the first one, and where the brackets begin.
    fn chain(&mut self) -> Result<(usize, usize), ReadError> {
        let first = self.soup.points.len();
        self.skip_blanks();
        let start = self.at;
        self.list(|reader| reader.point().map(drop))?;
        if self.soup.points.len() == first + 1 {
            self.at = start;
            let problem = ReadProblem::Expected { wanted: "two points or more".into(), found: "one".to_owned() };
            return Err(self.error(problem, "points are separated by commas"));
        }
        Ok((first, start))
    }

    fn polygon(&mut self) -> Result<(), ReadError> {
        let polygon = self.polygons;
        self.polygons += 1;
        if let Some(rings) = &mut self.rings {
            rings.begin_polygon(format_args!("polygon {polygon}"), None);
        }
        let mut ring = 0;
        self.list(|reader| {
            let place = format!("polygon {polygon} ring {ring}");
            ring += 1;
            reader.ring(&place)
        })?;
        let is_empty = self.rings.as_mut().is_some_and(Rings::end_polygon);
        self.skipped.empty += usize::from(is_empty);
        Ok(())
    }

    /// A chain of points that must end where it starts.
    fn ring(&mut self, place: &str) -> Result<(), ReadError> {
        let (first, start) = self.chain()?;
        let at = |problem| named(Fault::at(start, problem), self.bytes, self.source);
        if let Some(rings) = &mut self.rings {
            for p in &self.soup.points[first..] {
                rings.point([p.x, p.y], || place.to_owned()).map_err(at)?;
            }
            rings.end_ring(start, || place.to_owned()).map_err(at)?;
            self.soup.clear();
            return Ok(());
        }
        self.soup.end_ring(first, place, self.closes.then_some(&mut self.closed)).map_err(at)?;
        self.soup.begin_path(place);
        self.soup.chain(first as u32, true);
        Ok(())
    }
}

/// A fault with its line and column.
fn named(fault: Fault, bytes: &[u8], source: &str) -> ReadError {
    let place = line_and_column(bytes, fault.at.unwrap_or(0));
    ReadError::at(source, place, fault.what, fault.help)
}
