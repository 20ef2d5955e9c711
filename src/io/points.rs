//! Points: plain text with one point a line, or the points of any other format.
//!
//! ```text
//!   x,y                a heading of words: may be left out
//!   3                  the number of points: may be left out
//!   0 0                x and y, parted by blanks, commas or semicolons
//!   4, 0
//!   0;3                # starts a comment
//! ```

use super::announced::Announced;
use super::blocks::Blocks;
use super::document::{Document, Read, ReadOptions};
use super::format::Format;
use super::problem::ReadError;
use super::read::{format_of, open, read_opened, source_name};
use super::room::{reserved, too_little};
use super::soup::{SegmentSoup, SoupBuilder, check_counts};
use super::text::{Scanner, Syntax, note_of_the_end};
use super::triangle;
use crate::geometry::equal::first_of_equals;
use crate::ids::VertexId;
use crate::plane::Point;
use crate::topology::View;
use std::path::Path;

/// Points as a file gives them, in its order.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct PointList {
    /// The points.
    pub points: Vec<Point>,
    /// The line of each point, from 1; empty where lines mean nothing.
    pub lines: Vec<u32>,
    /// The file.
    pub source: String,
    /// The format it was; none for plain text.
    pub format: Option<Format>,
    /// What was left out or looks wrong, one sentence each: for the user.
    pub notes: Vec<String>,
}

impl PointList {
    /// Where a point stands: `sites.xy:12`.
    #[must_use]
    pub fn place(&self, point: usize) -> String {
        self.lines.get(point).map_or_else(|| self.source.clone(), |line| format!("{}:{line}", self.source))
    }

    /// Room for as many points more as so many bytes can hold: `0 0` takes four.
    fn make_room(&mut self, bytes: usize) -> Result<(), ReadError> {
        let points = bytes / 4 + 1;
        self.points
            .try_reserve(points)
            .and_then(|()| self.lines.try_reserve(points))
            .map_err(|_| too_little(20 * (2 * self.points.len() + points), &self.source))
    }

    /// Whether there is memory for what is made of the points, so many bytes for each of them. It is asked for and given
    /// back.
    ///
    /// # Errors
    /// [`ReadProblem::OutOfMemory`](super::ReadProblem::OutOfMemory).
    pub fn check_room(&self, bytes_per_point: usize) -> Result<(), ReadError> {
        reserved::<u8>(self.points.len().saturating_mul(bytes_per_point), &self.source).map(drop)
    }
}

/// Reads the points of a file; `-` is standard input.
///
/// The format, or the end of the name, or the first bytes tell how: of formats with polygons, segments or tables the
/// points are taken, and z is dropped; a `.node` file may stand alone. GeoJSON, TopoJSON and well-known text give their
/// points and the corners of their lines and polygons; corners that are written several times are taken once, and a ring
/// need not end where it starts. All other files are plain text, as above. y points up in the result, see
/// [`ReadOptions::y_down`].
///
/// # Errors
/// [`ReadError`] with the place of the first problem.
pub fn read_points(path: &Path, options: &ReadOptions) -> Result<PointList, ReadError> {
    let source = source_name(path);
    let mut blocks = open(path, &source)?;
    // Where a ring ends is nothing to its corners.
    let options = &ReadOptions { outlines: true, close_rings: true, ..options.clone() };
    let format = format_of(path, &mut blocks, options)?;
    let is_node = path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("node"));
    let mut list = match format {
        None => plain(&mut blocks)?,
        Some(Format::Triangle) if is_node => {
            let bytes = blocks.into_whole()?;
            let mut soup = SoupBuilder::default();
            triangle::nodes(&mut Scanner::new(&bytes, &source, triangle::SYNTAX)?, &mut soup)?;
            let read = Read {
                document: Document::Polygons(soup.finish(&source, false)?),
                notes: note_of_the_end(&bytes).into_iter().collect(),
                format: Format::Triangle,
            };
            points_of(read, source)
        }
        // These turn y themselves.
        Some(_) => return Ok(points_of(read_opened(path, blocks, format, options)?, source)),
    };
    if options.y_down {
        list.points.iter_mut().for_each(|p| p.y = 0.0 - p.y);
    }
    Ok(list)
}

/// The points of what was read.
fn points_of(read: Read, source: String) -> PointList {
    let (notes, format) = (read.notes, Some(read.format));
    match read.document {
        Document::Polygons(soup) => {
            let points = soup.points.iter().map(|&[x, y, _]| Point::new(x, y)).collect();
            let same_file = soup.places.vertex_source.as_ref().is_none_or(|name| *name == source);
            let lines = if same_file { soup.places.vertex_lines.iter().collect() } else { Vec::new() };
            PointList { points, lines, source, format, notes }
        }
        Document::Segments(soup) => {
            let kept = match read.format {
                Format::GeoJson | Format::TopoJson | Format::Wkt => each_corner_once(&soup),
                _ => (0..soup.points.len()).collect(),
            };
            let points = kept.iter().map(|&p| soup.points[p]).collect();
            let lines = kept.iter().map(|&p| soup.point_lines[p]).collect();
            PointList { points, lines, source, format, notes }
        }
        Document::Columns(table) => {
            let positions = (0..table.vertex_bound() as u32).filter_map(|v| table.position(VertexId::new(v)));
            PointList { points: positions.map(Point::from).collect(), lines: Vec::new(), source, format, notes }
        }
        Document::Table(table) => {
            let positions = table.vertices.iter().filter_map(|row| row.as_ref()?.position);
            PointList { points: positions.map(Point::from).collect(), lines: Vec::new(), source, format, notes }
        }
    }
}

/// The numbers of the points that no segment uses, and of the ends of segments without those at the place of an earlier end.
fn each_corner_once(soup: &SegmentSoup) -> Vec<usize> {
    let mut keeps = vec![true; soup.points.len()];
    soup.segments.as_flattened().iter().for_each(|&end| keeps[end as usize] = false);
    let corners: Vec<usize> = (0..keeps.len()).filter(|&p| !keeps[p]).collect();
    // -0 + 0 = 0: the two zeros are one coordinate.
    let places: Vec<[f64; 2]> = corners.iter().map(|&p| [soup.points[p].x + 0.0, soup.points[p].y + 0.0]).collect();
    for (i, first) in first_of_equals(&places).into_iter().enumerate() {
        keeps[corners[i]] = i == first as usize;
    }
    (0..keeps.len()).filter(|&p| keeps[p]).collect()
}

/// Reads plain points that are in memory. `source_name` is what errors call them. O(length).
///
/// # Errors
/// [`ReadError`] with the place of the first problem.
///
/// ```
/// let list = dcel_kit::io::points_from_text(b"x,y\n0,0\n4,0\n0,3\n", "sites.csv")?;
/// assert_eq!((list.points.len(), list.place(2)), (3, "sites.csv:4".to_owned()));
/// let error = dcel_kit::io::points_from_text(b"0 0\n4\n", "sites.xy").unwrap_err();
/// assert_eq!(error.to_string(), "sites.xy:2:2: expected the y of the point, found the end of the line");
/// # Ok::<(), dcel_kit::io::ReadError>(())
/// ```
pub fn points_from_text(bytes: &[u8], source_name: &str) -> Result<PointList, ReadError> {
    plain(&mut Blocks::whole(bytes, source_name)?)
}

pub(super) fn plain(blocks: &mut Blocks<'_>) -> Result<PointList, ReadError> {
    const SYNTAX: Syntax = Syntax { comments: true, continuation: false, quotes: false, separators: true };
    let source = blocks.source();
    let mut list = PointList { source: source.to_owned(), ..PointList::default() };
    let (mut heading, mut announced) = (false, None);
    while let Some(block) = blocks.with_separators().next()? {
        if block.is_part {
            list.make_room(block.bytes.len())?;
        }
        let mut scanner = Scanner::of_block(block, SYNTAX);
        while let Some(first) = scanner.word_anywhere() {
            let line = scanner.line();
            let at_start = list.points.is_empty() && announced.is_none();
            if at_start && !heading && starts_with_letter(first.text) {
                heading = true;
                scanner.next_line();
                continue;
            }
            let Some(second) = scanner.word() else {
                if !at_start {
                    return Err(scanner.missing("the y of the point".to_owned()));
                }
                announced = Some(Announced::new(&scanner, first)?);
                continue;
            };
            list.points.push(Point::new(scanner.coordinate('x', first)?, scanner.coordinate('y', second)?));
            list.lines.push(line);
            scanner.end_of_line("a point is x y, one a line")?;
        }
    }
    if let Some(announced) = announced {
        announced.check(list.points.len(), "points", source)?;
    }
    list.notes.extend(blocks.note());
    check_counts(&[(list.points.len(), "points")]).map_err(|problem| ReadError::whole(source, problem, ""))?;
    Ok(list)
}

/// Whether a word is no number, but not a number that has gone wrong either: `nan` and `inf` are.
fn starts_with_letter(word: &[u8]) -> bool {
    let number = std::str::from_utf8(word).is_ok_and(|text| text.parse::<f64>().is_ok());
    !number && word.first().is_some_and(|b| b.is_ascii_alphabetic() || *b == b'"')
}
