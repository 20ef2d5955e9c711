//! From rings of coordinates to faces with common points.
//!
//! ```text
//!   (0 0) (1 0) (1 1) (0 1) (0 0)         v3 ●────● v2────● v5
//!   (1 0) (2 0) (2 1) (1 1) (1 0)   ==>      │ 0  │  1    │      faces 0 1 2 3 and 1 4 5 2
//!                                         v0 ●────● v1────● v4
//! ```
//!
//! Geographic formats write each polygon by itself. Two polygons share a border where their coordinates are
//! equal: exactly, with -0 = 0, and nothing else is joined. Equal points are found in the cells of a grid.
//! Points are numbered in the order in which they first come in a ring that is kept.

use super::document::ReadOptions;
use super::left_out::LeftOut;
use super::nodes::Fault;
use super::problem::ReadProblem;
use super::repaired::Repaired;
use super::soup::{Places, PolygonSoup, SegmentSoup, check_sizes};
use super::text::{LineCounter, lines_and_columns};
use super::words::counted;
use crate::geometry::equal::first_of_equals;
use crate::geometry::number::Number;
use crate::ids::MAX_IDS;
use crate::plane::predicates::{left_to_right, orientation};
use crate::plane::{Point, check_coordinate};
use crate::progress::Stage;
use crate::topology::PolygonList;
use std::fmt::{self, Write as _};

/// Rings as they are read; [`finish`](Self::finish) makes faces of them.
#[derive(Debug, Default)]
pub(super) struct Rings {
    points: Vec<[f64; 2]>,
    /// Where each ring ends in `points`; the closing point is not stored.
    ring_ends: Vec<u32>,
    /// The byte of the file at which each ring starts.
    ring_offsets: Vec<u32>,
    /// Where each polygon ends in `ring_ends`.
    polygon_ends: Vec<u32>,
    paths: String,
    path_ends: Vec<u32>,
    names: Vec<Option<String>>,
    any_name: bool,
    /// Whether rings are closed that do not end where they start, and which were.
    closes: bool,
    closed: Repaired,
    /// What readers of features leave out.
    pub(super) left_out: LeftOut,
    stage: Stage,
}

impl Rings {
    /// Nothing yet, of a file of so many bytes.
    pub(super) fn of_file(bytes: usize) -> Self {
        Self { stage: Stage::new("reading", bytes), ..Self::default() }
    }

    /// Starts a polygon.
    pub(super) fn begin_polygon(&mut self, path: fmt::Arguments<'_>, name: Option<&str>) {
        // Writing to a string cannot fail.
        let _ = self.paths.write_fmt(path);
        self.path_ends.push(self.paths.len() as u32);
        self.names.push(name.map(str::to_owned));
        self.any_name |= name.is_some();
    }

    /// How many polygons there are.
    pub(super) fn polygon_count(&self) -> usize {
        self.polygon_ends.len()
    }

    /// Ends a polygon. One without rings is dropped; the answer says whether that happened.
    pub(super) fn end_polygon(&mut self) -> bool {
        let before = self.polygon_ends.last().copied().unwrap_or(0);
        let rings = self.ring_ends.len() as u32;
        if rings == before {
            self.path_ends.pop();
            self.paths.truncate(self.path_ends.last().map_or(0, |&end| end as usize));
            self.names.pop();
            return true;
        }
        self.polygon_ends.push(rings);
        false
    }

    /// Appends a point to the ring being read.
    pub(super) fn point(&mut self, [x, y]: [f64; 2], place: impl Fn() -> String) -> Result<(), ReadProblem> {
        let checked = check_coordinate('x', x).and_then(|()| check_coordinate('y', y));
        checked.map_err(|error| ReadProblem::CoordinateAt { place: place(), error })?;
        if self.points.len() >= MAX_IDS {
            return Err(ReadProblem::TooLarge { what: "points", limit: MAX_IDS as u64 });
        }
        // -0 + 0 = 0: the two zeros are one coordinate.
        self.points.push([x + 0.0, y + 0.0]);
        Ok(())
    }

    /// How many points all rings together have so far.
    pub(super) fn point_count(&self) -> usize {
        self.points.len()
    }

    /// The last point of the ring being read.
    pub(super) fn last_point(&self) -> Option<[f64; 2]> {
        let start = self.ring_ends.last().map_or(0, |&end| end as usize);
        self.points[start..].last().copied()
    }

    /// Ends a chain, which need not end where it started. Chains belong to no polygon.
    pub(super) fn end_chain(&mut self, offset: usize) {
        self.ring_ends.push(self.points.len() as u32);
        self.ring_offsets.push(offset as u32);
        self.stage.set(offset);
    }

    /// Appends the rings, or the chains if they are not `closed`, to a list of segments.
    pub(super) fn outlines(&self, closed: bool, lines: &mut LineCounter<'_>, soup: &mut SegmentSoup) {
        let (mut start, mut polygon, mut first_ring) = (0, 0, 0);
        for (ring, (&end, &offset)) in self.ring_ends.iter().zip(&self.ring_offsets).enumerate() {
            while let Some(&end) = self.polygon_ends.get(polygon).filter(|&&end| end as usize <= ring) {
                (polygon, first_ring) = (polygon + 1, end as usize);
            }
            let (first, line) = (soup.points.len() as u32, lines.line(offset as usize));
            for &point in &self.points[start..end as usize] {
                soup.point(point, line);
            }
            // Chains belong to no polygon.
            let path = || format!("{} ring {}", self.path(polygon), ring - first_ring);
            soup.begin_path(&if polygon < self.polygon_ends.len() { path() } else { String::new() });
            soup.chain(first, closed);
            start = end as usize;
        }
    }

    /// Closes rings that do not end where they start, instead of refusing them.
    pub(super) fn close_rings(&mut self) {
        self.closes = true;
    }

    /// The rings that were closed.
    pub(super) fn closed(&self) -> &Repaired {
        &self.closed
    }

    /// Ends a ring, which must end where it started; `offset` is the byte at which it starts in the file.
    pub(super) fn end_ring(&mut self, offset: usize, place: impl Fn() -> String) -> Result<(), ReadProblem> {
        let start = self.ring_ends.last().map_or(0, |&end| end as usize);
        if let [first, .., last] = self.points[start..] {
            if !same(first, last) {
                if self.closes {
                    self.closed.add(1, place);
                    self.end_chain(offset);
                    return Ok(());
                }
                let show = |[x, y]: [f64; 2]| format!("({x}, {y})");
                return Err(ReadProblem::UnclosedRing { place: place(), first: show(first), last: show(last) });
            }
            self.points.pop();
        }
        self.end_chain(offset);
        Ok(())
    }

    /// Joins equal points and makes the faces. If the options say so, rings that enclose nothing are dropped and noted: an
    /// outer ring with its polygon, or by itself. Else those with fewer than three distinct points are an error, and those
    /// on a line are left to the builder. `bytes` are those of the file.
    pub(super) fn finish(
        self,
        source: &str,
        options: &ReadOptions,
        bytes: &[u8],
        notes: &mut Vec<String>,
    ) -> Result<PolygonSoup, Fault> {
        let mut faces = Faces { same_as: first_of_equals(&self.points), ..Faces::default() };
        faces.numbers = vec![u32::MAX; self.points.len()];
        let own = Places { source: source.to_owned(), ..Places::default() };
        let left_out = self.left_out;
        let mut soup = PolygonSoup { places: own, any_direction: true, left_out, ..PolygonSoup::default() };
        let mut offsets = Vec::with_capacity(self.ring_offsets.len());
        let (mut dropped, mut repeated) = (Vec::new(), Repaired::default());
        let (mut ring, mut point) = (0, 0);
        let mut numbers = Vec::new();
        for (polygon, &end) in self.polygon_ends.iter().enumerate() {
            let path = self.path(polygon);
            let first_ring = ring;
            // Whether the outer ring is there, or not yet but may be without corners, or gone with its polygon.
            let (mut begun, mut may_begin) = (false, true);
            while ring < end as usize {
                let points = point..self.ring_ends[ring] as usize;
                point = points.end;
                let place = || format!("{path} ring {}", ring - first_ring);
                let removed = faces.read_ring(points);
                repeated.add(removed, place);
                let distinct = faces.distinct();
                if distinct < 3 && !options.drop_degenerate_rings {
                    let problem = ReadProblem::DegenerateRing { place: place(), distinct };
                    return Err(Fault::at(self.ring_offsets[ring] as usize, problem));
                }
                let nothing = if options.drop_degenerate_rings { faces.without_area(&self.points) } else { None };
                let is_outer = ring == first_ring;
                let mut keep = |offset: usize, faces: &mut Faces, is_outer: bool| {
                    faces.keep_ring(&self.points, &mut soup.points, &mut soup.faces, is_outer);
                    offsets.push(self.ring_offsets[offset]);
                    numbers.push((offset - first_ring) as u32);
                };
                if let Some(why) = nothing {
                    let others = end as usize - first_ring - 1;
                    let with_it = match others {
                        _ if !is_outer || others == 0 || options.keep_inner_rings => String::new(),
                        1 => "; its polygon went with it, with 1 more ring".to_owned(),
                        _ => format!("; its polygon went with it, with {others} more rings"),
                    };
                    dropped.push(format!("{} {why}{with_it}", place()));
                    may_begin &= !is_outer || options.keep_inner_rings;
                } else if begun || is_outer {
                    keep(ring, &mut faces, is_outer);
                    begun = true;
                } else if may_begin {
                    let inner = std::mem::take(&mut faces.ring);
                    keep(first_ring, &mut faces, true);
                    faces.ring = inner;
                    keep(ring, &mut faces, false);
                    begun = true;
                }
                ring += 1;
            }
            if begun {
                soup.places.paths.push_str(path);
                soup.places.path_ends.push(soup.places.paths.len() as u32);
                if self.any_name {
                    soup.names.push(self.names[polygon].clone());
                }
            }
        }
        check_sizes(soup.points.len(), &soup.faces)?;
        soup.places.ring_places = lines_and_columns(bytes, &offsets);
        if !dropped.is_empty() {
            soup.places.ring_numbers = numbers;
        }
        note_dropped(&dropped, notes);
        let (one, many) = ("point that repeats the one before was", "points that repeat the one before were");
        repeated.note(one, many, "removed", notes);
        self.closed.note_closed(notes);
        soup.mended_rings = dropped.len() + self.closed.count();
        if soup.faces.face_count() == 0 {
            notes.push("the file holds no polygon".to_owned());
        }
        Ok(soup)
    }

    fn path(&self, polygon: usize) -> &str {
        let start = polygon.checked_sub(1).map_or(0, |before| self.path_ends[before] as usize);
        &self.paths[start..self.path_ends[polygon] as usize]
    }
}

/// Whether two points are equal, exactly and with -0 = 0.
#[allow(clippy::float_cmp)] // exact equality is meant
pub(super) fn same<const N: usize>(a: [f64; N], b: [f64; N]) -> bool {
    a == b
}

/// The faces while they are made.
#[derive(Default)]
struct Faces {
    same_as: Vec<u32>,
    /// The final number of each point that stands for its equals.
    numbers: Vec<u32>,
    /// The ring at hand, without repeated points.
    ring: Vec<u32>,
}

impl Faces {
    /// Takes a ring and removes points that repeat the one before; returns how many.
    fn read_ring(&mut self, points: std::ops::Range<usize>) -> usize {
        self.ring.clear();
        self.ring.extend_from_slice(&self.same_as[points]);
        let before = self.ring.len();
        self.ring.dedup();
        while self.ring.len() > 1 && self.ring.first() == self.ring.last() {
            self.ring.pop();
        }
        before - self.ring.len()
    }

    /// How many distinct points the ring has; 3 stands for three or more.
    fn distinct(&self) -> usize {
        match self.ring[..] {
            [] => 0,
            [_] => 1,
            [a, b, ..] => 2 + usize::from(self.ring.iter().any(|&c| c != a && c != b)),
        }
    }

    /// Why the ring encloses nothing, if so: it has too few points, or they lie on one line. Decided exactly.
    fn without_area(&self, from: &[[f64; 2]]) -> Option<String> {
        let distinct = self.distinct();
        if distinct < 3 {
            return Some(format!("has only {}", counted(distinct, "distinct point", "distinct points")));
        }
        let point = |&corner: &u32| Point::from(from[corner as usize]);
        let corners = || self.ring.iter().map(point);
        let (a, b) = (point(&self.ring[0]), point(&self.ring[1]));
        if corners().any(|c| !orientation(a, b, c).is_eq()) {
            return None;
        }
        let first = corners().min_by(|&p, &q| left_to_right(p, q)).unwrap_or(a);
        let last = corners().max_by(|&p, &q| left_to_right(p, q)).unwrap_or(b);
        Some(format!("has all its points on one line, from {} to {}", shown(first), shown(last)))
    }

    /// Numbers the points of the ring and appends it to the faces.
    fn keep_ring(&mut self, from: &[[f64; 2]], points: &mut Vec<[f64; 3]>, faces: &mut PolygonList, outer: bool) {
        for corner in &mut self.ring {
            let number = &mut self.numbers[*corner as usize];
            if *number == u32::MAX {
                let [x, y] = from[*corner as usize];
                *number = points.len() as u32;
                points.push([x, y, 0.0]);
            }
            *corner = *number;
        }
        if outer { faces.push_face(&self.ring) } else { faces.push_hole(&self.ring) }
    }
}

/// A point as the file has it: y is turned later.
fn shown(p: Point) -> String {
    format!("({}, {})", Number(p.x), Number(p.y))
}

fn note_dropped(dropped: &[String], notes: &mut Vec<String>) {
    const SHOWN: usize = 5;
    notes.extend(dropped.iter().take(SHOWN).map(|ring| format!("dropped a degenerate ring: {ring}")));
    if dropped.len() > SHOWN {
        let more = counted(dropped.len() - SHOWN, "more degenerate ring", "more degenerate rings");
        notes.push(format!("dropped {more}"));
    }
}
