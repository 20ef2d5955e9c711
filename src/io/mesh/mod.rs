//! Navigation meshes of polyanya, versions 2 and 3; written as version 2.
//!
//! ```text
//!   mesh                    mesh              the header and the version
//!   2                       3
//!   4 2                     4 2               points, polygons
//!   0 0  2 0 -1             0 0               x y; in version 2 the number of polygons round the point, and those
//!   1 0  3 0 1 -1           1 0               polygons, counter-clockwise (-1 = none, several at a time once)
//!   ...                     ...
//!   3 0 1 3  -1 -1 1        1 3  1 2 4  0 0 2 the number of corners, the corners counter-clockwise, and the neighbour
//!   3 1 2 3  0 -1 -1        0 3  2 3 4  -1 0 0  behind each edge: the first is behind the edge that ends at the first
//!                                             corner
//! ```
//!
//! | | version 2 | version 3 |
//! |---|---|---|
//! | numbers from | 0 | 1 |
//! | no neighbour | -1 | 0 |
//! | first number of a polygon | | 1 can be walked on, 0 blocked: it becomes a hole face |
//! | a neighbour that cannot be reached | | its number with a minus |
//! | direction | counter-clockwise, checked | either: the format's text says counter-clockwise, its example is not |
//!
//! Line ends mean no more than blanks. The neighbours are checked for their range and left out: the builder
//! finds them again from the corners. A wall between two polygons that can both be walked on has no width; such a
//! file is refused, for a path would go through it.
//!
//! Source: the two descriptions of the format beside polyanya (M. Cui, D. Harabor, A. Grastien, 2017; version 3: R.
//! Hechenberger and others for the Iron Harvest benchmarks, 2022).
//!
//! ```text
//!   write.rs  The writer of navigation meshes, version 2
//! ```

mod write;

use super::document::{Document, Read};
use super::format::Format;
use super::problem::{ReadError, ReadProblem};
use super::soup::SoupBuilder;
use super::text::{Scanner, Syntax};

pub(super) use write::write;

const SYNTAX: Syntax = Syntax { comments: true, continuation: false, quotes: false, separators: false };

/// Reads a `.mesh` file. O(length).
pub(super) fn read(bytes: &[u8], source: &str) -> Result<Read, ReadError> {
    let mut scanner = Scanner::new(bytes, source, SYNTAX)?;
    let version = header(&mut scanner)?;
    let points = scanner.need_count("the number of points")?;
    let polygons = scanner.need_count("the number of polygons")?;
    let mut soup = SoupBuilder::with_room(points, scanner.remaining(), 4, source)?;
    for i in 0..points {
        let word = scanner.need_anywhere(|| format!("vertex {i} of {points}"))?;
        let line = scanner.line();
        let x = scanner.coordinate('x', word)?;
        let word = scanner.need_anywhere(|| format!("the y of vertex {i}"))?;
        let y = scanner.coordinate('y', word)?;
        if version == Version::Two {
            let word = scanner.need_anywhere(|| format!("the number of polygons round vertex {i}"))?;
            let count = scanner.count(word)?;
            neighbours(&mut scanner, count, polygons, || format!("the polygons round vertex {i}"))?;
        }
        soup.point([x, y, 0.0], line);
    }
    let mut walls = Walls::default();
    let mut corners = Vec::new();
    for i in 0..polygons {
        corners.clear();
        let mut word = scanner.need_anywhere(|| format!("polygon {i} of {polygons}"))?;
        let line = scanner.line();
        if version == Version::Three {
            walls.next_face(&scanner, word, i)?;
            word = scanner.need_anywhere(|| format!("the number of corners of polygon {i}"))?;
        }
        let count = scanner.count(word)?;
        if count == 0 {
            return Err(scanner.expected(word, "the number of corners, at least 1", ""));
        }
        for k in 0..count {
            let word = scanner.need_anywhere(|| format!("corner {k} of {count} of polygon {i}"))?;
            corners.push(scanner.index(word, "vertex", points, version.first())?);
        }
        let inside = || format!("the neighbours of polygon {i}");
        match version {
            Version::Two => neighbours(&mut scanner, count, polygons, inside)?,
            Version::Three => walls.neighbours(&mut scanner, count, polygons, inside)?,
        }
        soup.face(&corners, line);
    }
    scanner.no_more("polygons", polygons, "correct the counts in the third line")?;
    walls.refuse_thin(&scanner)?;
    let mut soup = soup.finish(source, false)?;
    soup.any_direction = version == Version::Three;
    soup.blocked = walls.blocked;
    Ok(Read { document: Document::Polygons(soup), notes: Vec::new(), format: Format::Mesh })
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Version {
    Two,
    Three,
}

impl Version {
    /// The number of the first thing.
    const fn first(self) -> i64 {
        match self {
            Self::Two => 0,
            Self::Three => 1,
        }
    }
}

fn header(scanner: &mut Scanner<'_>) -> Result<Version, ReadError> {
    let word = scanner.need_anywhere(|| "the word `mesh`".to_owned())?;
    if word.text.starts_with(b"MeshVersion") {
        let what = "a .mesh file of Medit";
        return Err(scanner.error(word.at, ReadProblem::Refused { what: what.into() }, "convert it to OFF or PLY"));
    }
    if word.text != b"mesh" {
        return Err(scanner.expected(word, "the word `mesh`", "the kit reads polyanya's .mesh, versions 2 and 3"));
    }
    let word = scanner.need_anywhere(|| "the version, 2 or 3".to_owned())?;
    match scanner.integer(word)? {
        2 => Ok(Version::Two),
        3 => Ok(Version::Three),
        _ => Err(scanner.expected(word, "version 2 or 3", "in version 1 the neighbours stand one place further on")),
    }
}

/// Steps over `count` polygon numbers of version 2, -1 among them.
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

/// What version 3 says about which polygon can be reached from which.
#[derive(Default)]
struct Walls {
    /// The polygons that cannot be walked on, in increasing order.
    blocked: Vec<u32>,
    /// The polygon being read, and whether it can be walked on.
    face: (u32, bool),
    /// Neighbours with a minus of polygons that can be walked on: place, polygon, neighbour.
    closed: Vec<(usize, u32, u32)>,
}

impl Walls {
    /// Begins polygon `i`, whose first word is this.
    fn next_face(&mut self, scanner: &Scanner<'_>, word: super::text::Word<'_>, i: u64) -> Result<(), ReadError> {
        let open = match word.text {
            b"1" => true,
            b"0" => false,
            _ => return Err(scanner.expected(word, "1 for a polygon to walk on, 0 for a blocked one", "")),
        };
        self.face = (i as u32, open);
        if !open {
            self.blocked.push(i as u32);
        }
        Ok(())
    }

    /// Steps over the `count` neighbours of the polygon, and keeps those that are said to be closed.
    fn neighbours(
        &mut self,
        scanner: &mut Scanner<'_>,
        count: u64,
        polygons: u64,
        inside: impl Fn() -> String,
    ) -> Result<(), ReadError> {
        for _ in 0..count {
            let word = scanner.need_anywhere(&inside)?;
            let number = scanner.integer(word)?;
            if number.unsigned_abs() > polygons {
                return Err(scanner.out_of_range(word, "polygon", number, polygons, 1));
            }
            if number < 0 && self.face.1 {
                self.closed.push((word.at, self.face.0, (number.unsigned_abs() - 1) as u32));
            }
        }
        Ok(())
    }

    /// Refuses walls between two polygons that can both be walked on.
    fn refuse_thin(&self, scanner: &Scanner<'_>) -> Result<(), ReadError> {
        let is_open = |face: u32| self.blocked.binary_search(&face).is_err();
        let Some(&(at, face, other)) = self.closed.iter().find(|&&(_, _, other)| is_open(other)) else {
            return Ok(());
        };
        let what = format!("a wall without width, between polygons {} and {}, both to walk on,", face + 1, other + 1);
        let help = "open it (no minus), or put a blocked polygon there";
        Err(scanner.error(at, ReadProblem::Refused { what: what.into() }, help))
    }
}
