//! What formats hold: points with faces or segments, and where each stood in the file.

use super::labels::Labels;
use super::left_out::LeftOut;
use super::line_numbers::LineNumbers;
use super::problem::{ReadError, ReadProblem};
use super::repaired::Repaired;
use super::room::{reserved, too_little};
use crate::ids::MAX_IDS;
use crate::plane::Point;
use crate::plane::cycle::encloses;
use crate::topology::PolygonList;

/// Polygons as a file gives them: nothing is joined, turned round or checked against anything else.
///
/// Every corner is the number of a point; beyond that a face may be anything (two corners, a corner twice,
/// clockwise). The converter into a half-edge structure names what it cannot use by [`Places`].
#[derive(Clone, PartialEq, Debug, Default)]
pub struct PolygonSoup {
    /// The points in the order of the file; z is 0 where the file gives none.
    pub points: Vec<[f64; 3]>,
    /// Whether the file gives a z, and not the same for all points: a surface in space.
    pub has_z: bool,
    /// The faces in the order of the file.
    pub faces: PolygonList,
    /// The name of each face, or nothing at all if the format has no names.
    pub names: Vec<Option<String>>,
    /// The groups, objects and materials that faces belong to, of formats that have them.
    pub labels: Labels,
    /// Where the points and faces stand in the file.
    pub places: Places,
    /// The faces that are no part of the domain, in increasing order: they become hole faces.
    pub blocked: Vec<u32>,
    /// Whether the faces of the format may run either way, so that clockwise ones are turned round as a matter of
    /// course.
    pub any_direction: bool,
    /// How many rings were closed, or dropped, when the file was read.
    pub mended_rings: usize,
    /// What the file says of the polygons and is not here.
    pub left_out: LeftOut,
}

/// An axis of space.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Axis {
    /// To the right.
    X,
    /// Upwards in many drawing programs.
    Y,
    /// Upwards on maps.
    Z,
}

impl PolygonSoup {
    /// The same points with other faces, each of which was one of these before: so their names and places stay.
    ///
    /// # Panics
    /// If an origin is no face.
    #[must_use]
    pub fn with_faces(&self, faces: PolygonList, origins: &[u32]) -> Self {
        fn of<T: Clone>(all: &[T], origins: &[u32]) -> Vec<T> {
            if all.is_empty() { Vec::new() } else { origins.iter().map(|&f| all[f as usize].clone()).collect() }
        }
        let face_lines = origins.iter().filter_map(|&f| self.places.face_lines.get(f as usize)).collect();
        let mut places = Places { face_lines, ..self.places.clone() };
        if !self.places.path_ends.is_empty() {
            (places.paths, places.path_ends) = (String::new(), Vec::new());
            for path in origins.iter().filter_map(|&f| self.places.face_path(f as usize)) {
                places.paths += path;
                places.path_ends.push(places.paths.len() as u32);
            }
        }
        // Cycles may have gone with their faces.
        if faces.cycle_count() != self.faces.cycle_count() {
            places.ring_places.clear();
            places.ring_numbers.clear();
        }
        let is_blocked = |f: &u32| self.blocked.binary_search(f).is_ok();
        let blocked = (0..).zip(origins).filter(|(_, f)| is_blocked(f)).map(|(i, _)| i).collect();
        let (names, labels) = (of(&self.names, origins), self.labels.with_origins(origins));
        Self { faces, names, labels, places, blocked, points: self.points.clone(), ..*self }
    }

    /// Lays a floor in space flat, as it is seen from above: drops the axis that points up. Faces that run
    /// counter-clockwise as seen from above still do. Floors above each other then overlap. Messages go on telling
    /// coordinates as the file has them: of a floor with y up, x and z.
    ///
    /// ```text
    ///   up      the point (x, y, z) becomes
    ///   z       (x, y)
    ///   y       (x, -z)
    ///   x       (y, z)
    /// ```
    pub fn lay_flat(&mut self, up: Axis) {
        self.stand_up(up);
        self.points.iter_mut().for_each(|p| p[2] = 0.0);
        self.has_z = false;
    }

    /// Turns a floor in space so that its third coordinate is the height. The first two are those of
    /// [`lay_flat`](Self::lay_flat).
    pub fn stand_up(&mut self, up: Axis) {
        self.points.iter_mut().for_each(|p| *p = up.standing(*p));
        let heights = |p: &[f64; 3]| p[2].to_bits() != self.points[0][2].to_bits();
        self.has_z = self.points.iter().any(heights);
        self.places.y_down = up == Axis::Y;
    }

    /// Turns over the faces that run clockwise as seen from above, where z points to the eye, so that all face up. Decided
    /// exactly. A face that stands upright is left alone; of one that crosses itself the leftmost corner decides. O(corners).
    pub fn turn_up(&mut self) {
        for face in 0..self.faces.face_count() {
            let outline = self.faces.cycle_range(face).start;
            let corner =
                |&v: &u32| self.points.get(v as usize).map_or_else(Point::default, |&[x, y, _]| Point::new(x, y));
            let ring = self.faces.cycle_mut(outline);
            if encloses(ring.iter().rev().map(corner)) {
                ring.reverse();
            }
        }
    }
}

impl Axis {
    /// A point of a file where this axis points up, turned so that its third coordinate is the height.
    #[must_use]
    pub fn standing(self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        // 0 - z, so that 0 stays 0 and does not become -0.
        match self {
            Self::X => [y, z, x],
            Self::Y => [x, 0.0 - z, y],
            Self::Z => [x, y, z],
        }
    }

    /// The point of the file that [`standing`](Self::standing) makes this one of.
    #[must_use]
    pub fn lying(self, [x, y, height]: [f64; 3]) -> [f64; 3] {
        match self {
            Self::X => [height, x, y],
            Self::Y => [x, height, 0.0 - y],
            Self::Z => [x, y, height],
        }
    }
}

/// Where the points and faces of a [`PolygonSoup`] stand in their file, for messages.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Places {
    /// The file of the faces.
    pub source: String,
    /// The file of the points, if it is another one (Triangle's `.node`).
    pub vertex_source: Option<String>,
    /// The line of each point, from 1; empty if the format has no useful lines.
    pub vertex_lines: LineNumbers,
    /// The line of each face, from 1; empty if the format has no useful lines.
    pub face_lines: LineNumbers,
    /// The line and the column at which each cycle starts, from 1; empty if the format has lines for its faces.
    pub(super) ring_places: Vec<[u32; 2]>,
    /// Whether the y of the points was negated: coordinates in messages are those of the file.
    pub(super) y_down: bool,
    /// The number of each cycle among the rings of its polygon in the file; empty if none was left out.
    pub(super) ring_numbers: Vec<u32>,
    /// The paths of the faces of a JSON file, one after the other.
    pub(super) paths: String,
    /// Where each path ends; empty if the format has lines.
    pub(super) path_ends: Vec<u32>,
}

impl Places {
    /// Says that the y of the points was negated: coordinates in messages are those of the file.
    pub fn set_y_down(&mut self, down: bool) {
        self.y_down = down;
    }

    /// Where point `vertex` stands: `cube.obj:12`, or just the file.
    #[must_use]
    pub fn vertex(&self, vertex: usize) -> String {
        let source = self.vertex_source.as_ref().unwrap_or(&self.source);
        self.vertex_lines.get(vertex).map_or_else(|| source.clone(), |line| format!("{source}:{line}"))
    }

    /// Where face `face` stands: `cube.obj:12`, `map.json: states[12] polygon 3`, or just the file.
    #[must_use]
    pub fn face(&self, face: usize) -> String {
        match (self.face_lines.get(face), self.face_path(face)) {
            (Some(line), _) => format!("{}:{line}", self.source),
            (None, Some(path)) => format!("{}: {path}", self.source),
            (None, None) => self.source.clone(),
        }
    }

    /// Where cycle `ring` of face `face` stands: as [`face`](Self::face), and ` ring 1` for its first hole.
    #[must_use]
    pub fn ring(&self, face: usize, ring: usize) -> String {
        format!("{} ring {ring}", self.face(face))
    }

    /// Where a cycle starts, by its number among all cycles: `map.json:12:7`, or just the file.
    pub(super) fn ring_place(&self, cycle: usize) -> String {
        let place = self.ring_places.get(cycle);
        place.map_or_else(|| self.source.clone(), |[line, column]| format!("{}:{line}:{column}", self.source))
    }

    /// Where the outline of a face starts, and which it is: `map.json:3:7: states[12] polygon 3 ring 0`; as
    /// [`face`](Self::face), where the format has a line for each face. `cycle` is the number of the outline among all
    /// cycles.
    #[must_use]
    pub fn outline(&self, face: usize, cycle: usize) -> String {
        match self.face_path(face) {
            Some(path) if self.face_lines.is_empty() => format!("{}: {path} ring 0", self.ring_place(cycle)),
            _ => self.face(face),
        }
    }

    /// The path of a face inside a JSON file: `states[12] "Ohio" polygon 3`.
    #[must_use]
    pub fn face_path(&self, face: usize) -> Option<&str> {
        let end = *self.path_ends.get(face)? as usize;
        let start = face.checked_sub(1).map_or(0, |before| self.path_ends[before] as usize);
        self.paths.get(start..end)
    }
}

/// Points and segments as a file gives them: nothing is joined, split or checked against anything else.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct SegmentSoup {
    /// The points in the order of the file. Those that no segment uses are points by themselves.
    pub points: Vec<Point>,
    /// The segments by the numbers of their ends.
    pub segments: Vec<[u32; 2]>,
    /// Points that mark the faces around them as holes.
    pub hole_points: Vec<Point>,
    /// The file.
    pub source: String,
    /// The line of each point, from 1.
    pub point_lines: Vec<u32>,
    /// The line of each segment, from 1.
    pub segment_lines: Vec<u32>,
    /// The line of each hole point, from 1.
    pub hole_lines: Vec<u32>,
    /// What the segments are sides of, of formats that have polygons: from this segment on, a path such as
    /// `features[3] "Ohio" polygon 0 ring 1`, or nothing. In the order of the segments.
    pub paths: Vec<(u32, String)>,
    /// How many rings were closed when the file was read.
    pub mended_rings: usize,
}

impl SegmentSoup {
    /// Nothing yet, for the file `source`.
    pub(super) fn new(source: &str) -> Self {
        Self { source: source.to_owned(), ..Self::default() }
    }

    /// Appends a point and returns its number.
    pub(super) fn point(&mut self, [x, y]: [f64; 2], line: u32) -> u32 {
        self.points.push(Point::new(x, y));
        self.point_lines.push(line);
        self.points.len() as u32 - 1
    }

    /// Room for what so many bytes of text can hold, beside what there is: a point takes four at least, `0 0`, a segment
    /// eight.
    ///
    /// # Errors
    /// If there is not so much memory.
    pub(super) fn make_room(&mut self, bytes: usize) -> Result<(), ReadError> {
        let (points, segments) = (bytes / 4 + 1, bytes / 8 + 1);
        let made = self.points.try_reserve(points).and_then(|()| self.point_lines.try_reserve(points));
        let made = made.and_then(|()| self.segments.try_reserve(segments));
        made.and_then(|()| self.segment_lines.try_reserve(segments)).map_err(|_| {
            let there = 20 * self.points.len() + 12 * self.segments.len();
            too_little(2 * there + 20 * points + 12 * segments, &self.source)
        })
    }

    /// Appends a segment.
    pub(super) fn segment(&mut self, ends: [u32; 2], line: u32) {
        self.segments.push(ends);
        self.segment_lines.push(line);
    }

    /// Forgets all points and segments.
    pub(super) fn clear(&mut self) {
        self.points.clear();
        self.point_lines.clear();
        self.segments.clear();
        self.segment_lines.clear();
        self.paths.clear();
    }

    /// The segments that come next are sides of what is at this path, or of nothing that has one.
    pub(super) fn begin_path(&mut self, path: &str) {
        let first = self.segments.len() as u32;
        self.paths.pop_if(|last| last.0 == first);
        if self.paths.last().map_or("", |(_, last)| last) != path {
            self.paths.push((first, path.to_owned()));
        }
    }

    /// Ends a ring that begins with point `first`: the last point must be the first one again, and goes. If `closed` takes
    /// rings that do not end so, they stay as they are.
    pub(super) fn end_ring(
        &mut self,
        first: usize,
        place: &str,
        closed: Option<&mut Repaired>,
    ) -> Result<(), ReadProblem> {
        if let [a, .., b] = self.points[first..] {
            if a == b {
                self.points.pop();
                self.point_lines.pop();
            } else {
                let (first, last) = (a.to_string(), b.to_string());
                let problem = ReadProblem::UnclosedRing { place: place.to_owned(), first, last };
                closed.ok_or(problem)?.add(1, || place.to_owned());
            }
        }
        Ok(())
    }

    /// Appends the segments of a chain of points, of which some came before; `closed` adds the way back.
    pub(super) fn chain(&mut self, first: u32, closed: bool) {
        let end = self.points.len() as u32;
        for p in first + 1..end {
            self.segment([p - 1, p], self.point_lines[p as usize]);
        }
        if closed && first + 1 < end {
            self.segment([end - 1, first], self.point_lines[end as usize - 1]);
        }
    }

    /// Refuses more points or segments than there are ids.
    pub(super) fn checked(self) -> Result<Self, ReadError> {
        let counts = [(self.points.len(), "points"), (2 * self.segments.len(), "half-edges")];
        check_counts(&counts).map_err(|problem| ReadError::whole(&self.source, problem, ""))?;
        Ok(self)
    }

    /// Where a segment stands: `roads.wkt:12`, and of what it is a side, if the format tells:
    /// `map.json:3: features[3] "Ohio" polygon 0 ring 1`.
    #[must_use]
    pub fn place(&self, segment: usize) -> String {
        let line = self.at_line(self.segment_lines.get(segment));
        match self.path(segment) {
            "" => line,
            path => format!("{line}: {path}"),
        }
    }

    /// The path of what a segment is a side of; empty if the format tells nothing.
    pub(super) fn path(&self, segment: usize) -> &str {
        let after = self.paths.partition_point(|&(first, _)| first as usize <= segment);
        after.checked_sub(1).map_or("", |run| &self.paths[run].1)
    }

    /// Where a point stands.
    #[must_use]
    pub fn point_place(&self, point: usize) -> String {
        self.at_line(self.point_lines.get(point))
    }

    pub(super) fn at_line(&self, line: Option<&u32>) -> String {
        line.map_or_else(|| self.source.clone(), |line| format!("{}:{line}", self.source))
    }
}

/// A soup while a line-based or binary file is being read.
#[derive(Debug, Default)]
pub(super) struct SoupBuilder {
    pub(super) points: Vec<[f64; 3]>,
    pub(super) faces: PolygonList,
    pub(super) vertex_lines: LineNumbers,
    pub(super) face_lines: LineNumbers,
}

impl SoupBuilder {
    /// Room for the elements a header counts, but for no more than `bytes` bytes of file can hold.
    ///
    /// # Errors
    /// If there is not so much memory.
    pub(super) fn with_room(
        points: u64,
        bytes: usize,
        bytes_per_point: usize,
        source: &str,
    ) -> Result<Self, ReadError> {
        let room = points.min((bytes / bytes_per_point) as u64) as usize;
        Ok(Self { points: reserved(room, source)?, ..Self::default() })
    }

    /// Room for what so many bytes of text can hold, beside what there is: a point takes five at least, `v 0 0`, a face
    /// three, a corner two.
    ///
    /// # Errors
    /// If there is not so much memory.
    pub(super) fn make_room(&mut self, bytes: usize, source: &str) -> Result<(), ReadError> {
        let (points, faces, corners) = (bytes / 5 + 1, bytes / 3 + 1, bytes / 2 + 1);
        let made = self.points.try_reserve(points).and_then(|()| self.vertex_lines.try_reserve(points));
        let made = made.and_then(|()| self.face_lines.try_reserve(faces));
        made.and_then(|()| self.faces.try_reserve(corners, faces)).map_err(|_| {
            let lists = [self.points.len() * 24, self.vertex_lines.len() * 6, self.faces.corner_count() * 10];
            too_little(2 * lists.iter().sum::<usize>() + 30 * points + 10 * faces + 4 * corners, source)
        })
    }

    /// Appends a point that stands in line `line`.
    #[inline]
    pub(super) fn point(&mut self, point: [f64; 3], line: u32) {
        self.points.push(point);
        self.vertex_lines.push(line);
    }

    /// Appends a face that stands in line `line`.
    #[inline]
    pub(super) fn face(&mut self, corners: &[u32], line: u32) {
        self.faces.push_face(corners);
        self.face_lines.push(line);
    }

    /// The soup of the file `source`. Counts elements against the range of the ids.
    pub(super) fn finish(self, source: &str, gives_z: bool) -> Result<PolygonSoup, ReadError> {
        let Self { points, faces, vertex_lines, face_lines } = self;
        check_sizes(points.len(), &faces).map_err(|problem| ReadError::whole(source, problem, ""))?;
        let has_z =
            gives_z && points.iter().any(|p| p[2].partial_cmp(&points[0][2]) != Some(std::cmp::Ordering::Equal));
        let places = Places { source: source.to_owned(), vertex_lines, face_lines, ..Places::default() };
        Ok(PolygonSoup { points, has_z, faces, places, ..PolygonSoup::default() })
    }
}

/// Refuses more points, faces or corners than there are ids.
pub(super) fn check_sizes(points: usize, faces: &PolygonList) -> Result<(), ReadProblem> {
    let counts = [(points, "points"), (faces.face_count(), "faces"), (faces.corner_count(), "corners of faces")];
    check_counts(&counts)
}

/// Refuses more of one kind than there are ids.
pub(super) fn check_counts(counts: &[(usize, &'static str)]) -> Result<(), ReadProblem> {
    match counts.iter().find(|&&(count, _)| count > MAX_IDS) {
        Some(&(_, what)) => Err(ReadProblem::TooLarge { what, limit: MAX_IDS as u64 }),
        None => Ok(()),
    }
}
