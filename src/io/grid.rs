//! Grid maps of the Moving AI benchmarks, `.map`.
//!
//! ```text
//!   type octile        0   1   2   3   4  x       the corners of the cells are the points of the plane: cell (3, 1)
//!   height 3         0 ┌───┬───┬───┬───┐          reaches from (3, 1) to (4, 2).
//!   width 4            │ . │ . │ @ │ . │
//!   map              1 ├───┼───┼───┼───┤          In the file y points DOWN. In the kit y points up: the point
//!   ..@.               │ . │ @ │ . │ . │          (x, y) of the file is (x, -y), here and in the rectangles.
//!   .@..             2 ├───┼───┼───┼───┤
//!   ....               │ . │ . │ . │ . │          (2, 1) is a *double corner*: two blocked cells touch there, and
//!                    3 └───┴───┴───┴───┘          nobody squeezes through between them.
//!                    y
//! ```
//!
//! `.`, `G` and `S` are open, `@`, `O`, `T` and `W` are blocked. (Water and swamp have rules of their own in the
//! benchmarks; the kit takes water as blocked and swamp as open.) Outside of the grid everything is blocked.
//!
//! **Rectangles.** A run of open cells in a row, grown downwards as long as the next row has the same run, is a
//! face. Where the runs of two rows meet, both faces get all corners, so that each edge has one face on each side.
//! A face is convex, with straight corners.
//!
//! **Regions.** The lines between open and blocked cells cut the plane into regions of open and of blocked cells;
//! bounded blocked regions are hole faces. This is the polygon form of a map: with rings, and not convex.
//!
//! Source: N. Sturtevant, *Benchmarks for grid-based pathfinding*, 2012.

use super::document::{Document, Read};
use super::format::Format;
use super::problem::{ReadError, ReadProblem};
use super::soup::{PolygonSoup, SoupBuilder};
use super::text::{Scanner, Syntax, Word};
use crate::ids::{HalfEdgeId, MAX_IDS};
use crate::plane::{Point, SegmentsError, Subdivision};

/// A map of open and blocked cells. Rows are numbered from the top, as in the file.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Grid {
    width: u32,
    height: u32,
    /// Row by row.
    open: Vec<bool>,
    source: String,
    /// The line of the first row.
    first_line: u32,
}

/// Reads a `.map` file as rectangles; y is that of the file. O(length).
pub(super) fn read(bytes: &[u8], source: &str) -> Result<Read, ReadError> {
    let soup = Grid::parse(bytes, source)?.soup()?;
    Ok(Read { document: Document::Polygons(soup), notes: Vec::new(), format: Format::Map })
}

impl Grid {
    /// Reads a `.map` file. `source` is what errors call it. O(length).
    ///
    /// ```
    /// use dcel_kit::io::Grid;
    /// let map = Grid::parse(b"type octile\nheight 2\nwidth 3\nmap\n..@\n.T.\n", "small.map")?;
    /// assert_eq!((map.width(), map.height(), map.open_cells()), (3, 2, 4));
    /// assert!(map.is_open(1, 0) && !map.is_open(1, 1) && !map.is_open(3, 0));
    /// assert_eq!(map.double_corners().collect::<Vec<_>>(), [[2, 1]]);
    /// # Ok::<(), dcel_kit::io::ReadError>(())
    /// ```
    ///
    /// # Errors
    /// [`ReadError`] with line and column: a bad header, a cell of an unknown kind, a row that is too short, too
    /// long, missing or too much. No count is trusted: memory grows with the rows that are there.
    pub fn parse(bytes: &[u8], source: &str) -> Result<Self, ReadError> {
        let mut scanner = Scanner::new(bytes, source, Syntax::default())?;
        let [width, height] = header(&mut scanner)?;
        let mut open =
            Vec::with_capacity((u64::from(width) * u64::from(height)).min(scanner.remaining() as u64) as usize);
        let mut first_line = scanner.line();
        for row in 0..height {
            let word = scanner.need_anywhere(|| format!("row {row} of {height}"))?;
            if row == 0 {
                first_line = scanner.line();
            }
            cells(&scanner, word, row, width, &mut open)?;
            scanner.end_of_line("a row of the map has no blanks")?;
        }
        scanner.no_more("rows", height.into(), "correct the line `height`")?;
        Ok(Self { width, height, open, source: source.to_owned(), first_line })
    }

    /// The number of cells in a row.
    #[must_use]
    pub fn width(&self) -> u32 {
        self.width
    }

    /// The number of rows.
    #[must_use]
    pub fn height(&self) -> u32 {
        self.height
    }

    /// Whether cell x of row y is there and open. O(1).
    #[must_use]
    pub fn is_open(&self, x: u32, y: u32) -> bool {
        x < self.width && y < self.height && self.open[y as usize * self.width as usize + x as usize]
    }

    /// The number of open cells. O(cells).
    #[must_use]
    pub fn open_cells(&self) -> usize {
        self.open.iter().filter(|&&open| open).count()
    }

    /// Whether the four cells round the corner (x, y) are open: upper left, upper right, lower left, lower right.
    fn around(&self, x: u32, y: u32) -> [bool; 4] {
        // One before 0 is outside, and so blocked.
        let (left, above) = (x.wrapping_sub(1), y.wrapping_sub(1));
        [self.is_open(left, above), self.is_open(x, above), self.is_open(left, y), self.is_open(x, y)]
    }

    /// The corners, as the file counts them, at which two blocked cells touch and the other two are open. O(cells).
    pub fn double_corners(&self) -> impl Iterator<Item = [u32; 2]> + '_ {
        let corners = (1..self.height).flat_map(|y| (1..self.width).map(move |x| [x, y]));
        corners.filter(|&[x, y]| {
            let [a, b, c, d] = self.around(x, y);
            a == d && b == c && a != b
        })
    }

    /// The open cells as rectangles that touch along whole edges, counter-clockwise, with y pointing up.
    ///
    /// Cost: O(cells).
    ///
    /// # Errors
    /// More corners than there are ids.
    pub fn rectangles(&self) -> Result<PolygonSoup, ReadError> {
        let mut soup = self.soup()?;
        soup.points.iter_mut().for_each(|p| p[1] = 0.0 - p[1]);
        Ok(soup)
    }

    /// The rectangles. They run counter-clockwise once y has been negated.
    fn soup(&self) -> Result<PolygonSoup, ReadError> {
        let mut soup = SoupBuilder::default();
        let mut corners = Vec::new();
        let mut open: Vec<Strip> = Vec::new();
        let mut above: Vec<Run> = Vec::new();
        for y in 0..=self.height {
            let here = self.runs(y);
            let line = self.first_line + y.min(self.height - 1);
            // Runs that both rows have go on; the ends of all others are corners.
            let ended: Vec<Run> = above.iter().copied().filter(|run| here.binary_search(run).is_err()).collect();
            let begun: Vec<Run> = here.iter().copied().filter(|run| above.binary_search(run).is_err()).collect();
            let mut stops: Vec<u32> = ended.iter().chain(&begun).flatten().copied().collect();
            stops.sort_unstable();
            stops.dedup();
            let first = soup.points.len() as u32;
            for &x in &stops {
                soup.point([f64::from(x), f64::from(y), 0.0], line);
            }
            let along = |[x0, x1]: Run| {
                let from = stops.partition_point(|&x| x < x0) as u32;
                let to = stops.partition_point(|&x| x <= x1) as u32;
                first + from..first + to
            };
            let (done, kept): (Vec<Strip>, Vec<Strip>) =
                open.into_iter().partition(|strip| ended.binary_search(&strip.run).is_ok());
            for strip in done {
                corners.clear();
                corners.extend(along(strip.run));
                corners.extend(strip.top.rev());
                soup.face(&corners, strip.line);
            }
            open = kept;
            let line = self.first_line + y;
            open.extend(begun.into_iter().map(|run| Strip { run, top: along(run), line }));
            above = here;
            if soup.points.len() > MAX_IDS {
                break;
            }
        }
        soup.finish(&self.source, false)
    }

    /// The runs of open cells of row y, from left to right; none below the last row.
    fn runs(&self, y: u32) -> Vec<Run> {
        let mut runs: Vec<Run> = Vec::new();
        for x in (0..self.width).filter(|&x| self.is_open(x, y)) {
            match runs.last_mut() {
                Some([_, end]) if *end == x => *end += 1,
                _ => runs.push([x, x + 1]),
            }
        }
        runs
    }

    /// The lines between open and blocked cells, as long as they are straight, each with the open cells on its left;
    /// y points up. O(cells).
    #[must_use]
    pub fn borders(&self) -> Vec<[Point; 2]> {
        let mut lines = Vec::new();
        let point = |x: u32, y: u32| Point::new(f64::from(x), 0.0 - f64::from(y));
        // `side`: which of the two cells beside a unit of the line is open, if just one is.
        let mut scan = |length: u32, side: &dyn Fn(u32) -> Option<bool>, at: &dyn Fn(u32) -> Point| {
            let mut from = 0;
            for i in 0..=length {
                let before = i.checked_sub(1).and_then(side);
                let here = if i < length { side(i) } else { None };
                if before != here {
                    match before {
                        Some(true) => lines.push([at(from), at(i)]),
                        Some(false) => lines.push([at(i), at(from)]),
                        None => {}
                    }
                    from = i;
                }
            }
        };
        let differ = |left: bool, right: bool| (left != right).then_some(left);
        for y in 0..=self.height {
            // Going right, the cell above is on the left.
            let side = |x| differ(self.is_open(x, y.wrapping_sub(1)), self.is_open(x, y));
            scan(self.width, &side, &|x| point(x, y));
        }
        for x in 0..=self.width {
            // Going down, the cell to the right is on the left.
            let side = |y| differ(self.is_open(x, y), self.is_open(x.wrapping_sub(1), y));
            scan(self.height, &side, &|y| point(x, y));
        }
        lines
    }

    /// The regions of open cells as faces; the bounded regions of blocked cells are hole faces. y points up.
    ///
    /// Cost: O(cells + n log n) for n lines between open and blocked cells.
    ///
    /// # Errors
    /// [`SegmentsError`]: more lines than there are ids.
    pub fn regions(&self) -> Result<Subdivision, SegmentsError> {
        let borders = self.borders();
        let mut subdivision = Subdivision::from_segments(&borders)?;
        // h(2i) runs as line i does, with the open cells on its left: blocked ones lie behind its twin.
        for i in 0..borders.len() as u32 {
            let behind = subdivision.face(HalfEdgeId::new(2 * i + 1));
            if behind != subdivision.outer_face() {
                subdivision.set_hole(behind, true);
            }
        }
        Ok(subdivision)
    }
}

/// Open cells from the first number up to the second.
type Run = [u32; 2];

/// A rectangle whose last row has not come yet.
struct Strip {
    run: Run,
    /// Its points along the top.
    top: std::ops::Range<u32>,
    /// The line of its first row.
    line: u32,
}

/// Width and height.
fn header(scanner: &mut Scanner<'_>) -> Result<[u32; 2], ReadError> {
    let mut sizes: [Option<(u32, u32)>; 2] = [None; 2];
    loop {
        let word = scanner.need_anywhere(|| "`height`, `width` or `map`".to_owned())?;
        let which = match word.text {
            b"type" => {
                let kind = scanner.need(|| "the type of the map, octile".to_owned())?;
                if kind.text != b"octile" {
                    let problem = ReadProblem::Refused { what: format!("a map of type {}", kind.show()).into() };
                    return Err(scanner.error(kind.at, problem, "the kit reads maps of type octile"));
                }
                scanner.end_of_line("the line is `type octile`")?;
                continue;
            }
            b"width" => 0,
            b"height" => 1,
            b"map" => {
                scanner.end_of_line("the rows begin in the line after `map`")?;
                let [Some((width, _)), Some((height, _))] = sizes else {
                    return Err(scanner.expected(word, "`height` and `width` before the rows", ""));
                };
                return Ok([width, height]);
            }
            _ => return Err(scanner.expected(word, "`type`, `height`, `width` or `map`", "")),
        };
        if let Some((_, first_line)) = sizes[which] {
            let problem = ReadProblem::Duplicate { what: format!("`{}`", word.show()), first_line };
            return Err(scanner.error(word.at, problem, "leave one of them out"));
        }
        let number = scanner.need(|| format!("the number behind `{}`", word.show()))?;
        let size = scanner.count(number)?;
        let fits = u32::try_from(size).ok().filter(|&size| size > 0 && (size as usize) < MAX_IDS);
        let size = fits.ok_or_else(|| scanner.expected(number, format!("a number from 1 to {}", MAX_IDS - 1), ""))?;
        sizes[which] = Some((size, scanner.line()));
        scanner.end_of_line("one number stands here")?;
    }
}

/// The cells of a row.
fn cells(scanner: &Scanner<'_>, word: Word<'_>, row: u32, width: u32, open: &mut Vec<bool>) -> Result<(), ReadError> {
    for (i, &b) in word.text.iter().enumerate() {
        open.push(match b {
            b'.' | b'G' | b'S' => true,
            b'@' | b'O' | b'T' | b'W' => false,
            _ => {
                let rest = Word { text: &word.text[i..], at: word.at + i };
                let help = "open cells are . G S, blocked ones @ O T W";
                return Err(scanner.expected(rest, format!("a cell, {i} of row {row}"), help));
            }
        });
    }
    if word.text.len() != width as usize {
        let wanted = format!("{width} cells in row {row}").into();
        let problem = ReadProblem::Expected { wanted, found: word.text.len().to_string() };
        return Err(scanner.error(word.at, problem, "correct the line `width`, or the row"));
    }
    Ok(())
}
