//! Cutting a face into convex ones by diagonals.
//!
//! ```text
//!   ●─────●─────●─────●      The corner c turns the wrong way: it is joined to the first corner after it that it sees.
//!   │     │ ╲     ╲   │      What lies before that corner keeps the face; the rest is new, and c is asked again there.
//!   │     c━━━━━━━━━━━●      So the rest may lose one corner at a time: nothing here may cost as much as its size.
//!   └─────────────────┘
//! ```
//!
//! All is decided on a copy of the links, which is written back once. The corners that turn the wrong way are kept in a
//! list for each piece, in their order round it, and a cut falls into two lists where it falls into two faces. Whether two
//! corners see each other is asked of a tree of boxes round the sides of the face as it was given: a segment that leaves
//! both of its corners towards the inside of their piece, and meets no side of the whole face, stays inside the piece.
//!
//! A face where that takes too long, as in a maze where few corners see each other, is cut into triangles by the sweep.

use crate::ids::{FaceId, HalfEdgeId, VertexId};
use crate::plane::cycle::{in_corner, on_segment, same_direction, turns_left_or_runs_straight};
use crate::plane::sweep::cross;
use crate::plane::triangulate::{TriangulateError, TriangulationMethod};
use crate::plane::{PlaneRecorder, Point, Subdivision};

/// No corner.
const NONE: u32 = u32::MAX;

/// How much is looked at in a face of this size before it is left to the sweep: O(k log k).
pub(crate) fn most_looked_at(size: usize) -> usize {
    (1 << 16) + 32 * size * (size + 4).ilog2() as usize
}

impl Subdivision {
    /// Cuts a bounded face that is no hole into convex faces, whose corners may be straight. Returns those that are new.
    ///
    /// Cost: O(k log k) for k half-edges and isolated vertices of the face.
    ///
    /// # Errors
    /// [`TriangulateError`]; the caller goes back.
    pub(crate) fn cut_into_convex_with(
        &mut self,
        f: FaceId,
        rec: &mut impl PlaneRecorder,
    ) -> Result<Vec<FaceId>, TriangulateError> {
        let size = self.all_half_edges(f).count();
        self.cut_looking_at(most_looked_at(size), f, rec)
    }

    fn cut_looking_at(
        &mut self,
        most: usize,
        f: FaceId,
        rec: &mut impl PlaneRecorder,
    ) -> Result<Vec<FaceId>, TriangulateError> {
        let mut added = Vec::new();
        let mut rest = vec![f];
        if self.inner_components(f).is_empty() {
            let room = Room::cut(self, f, most);
            self.dcel.room_for(0, room.faces.len() - 1, room.faces.len() - 1)?;
            let faces = self.write_room(&room, f, rec);
            rest = room.undone.iter().map(|&piece| faces[piece as usize]).collect();
            added.extend_from_slice(&faces[1..]);
        }
        for f in rest {
            let cut = self.triangulate_face_with(f, TriangulationMethod::Monotone, rec)?;
            added.extend(cut.new_faces.into_iter().map(|(new, _)| new));
        }
        Ok(added)
    }

    /// Writes the diagonals and the pieces of a room. Returns the faces of the pieces.
    fn write_room(&mut self, room: &Room, f: FaceId, rec: &mut impl PlaneRecorder) -> Vec<FaceId> {
        let mut faces = vec![f];
        let mut ids = room.given.clone();
        if room.faces.len() == 1 {
            return faces;
        }
        rec.step(1, "Create two new half-edges for each diagonal.");
        for i in (room.given.len()..room.next.len()).step_by(2) {
            faces.push(self.dcel.add_face_record(rec));
            let halves = self.dcel.add_edge_record(rec).half_edges();
            for (h, &v) in halves.into_iter().zip(&room.origin[i..]) {
                self.dcel.set_origin(h, v, rec);
            }
            ids.extend(halves);
        }
        rec.step(2, "Insert them into the cyclic lists.");
        for (i, &next) in room.next.iter().enumerate() {
            let (h, next) = (ids[i], ids[next as usize]);
            if i >= room.given.len() || self.dcel.next(h) != next {
                self.dcel.set_next(h, next, rec);
            }
        }
        rec.step(3, "Give each piece a face.");
        // All come from the face: who follows the changes is to see that of each piece.
        for &h in &ids[room.given.len()..] {
            self.dcel.set_face(h, f, rec);
        }
        for (&start, &face) in room.faces.iter().zip(&faces) {
            self.dcel.set_half_edge(face, Some(ids[start as usize]), rec);
            let mut i = start;
            loop {
                if self.dcel.face(ids[i as usize]) != face {
                    self.dcel.set_face(ids[i as usize], face, rec);
                }
                i = room.next[i as usize];
                if i == start {
                    break;
                }
            }
        }
        faces
    }
}

/// A face with one cycle, and how it falls into pieces. Half-edges have numbers here: those of the face along its cycle,
/// then those of the diagonals in pairs. Of a pair the first runs from the corner that turned the wrong way.
struct Room {
    given: Vec<HalfEdgeId>,
    origin: Vec<VertexId>,
    next: Vec<u32>,
    prev: Vec<u32>,
    /// A half-edge of each piece, that of the face first.
    faces: Vec<u32>,
    /// Pieces that were not cut any more, because it took too long.
    undone: Vec<u32>,
    /// The next corner of the same piece that turns the wrong way, for each that does.
    next_wrong: Vec<u32>,
    /// How much may still be looked at.
    left: usize,
}

impl Room {
    fn cut(s: &Subdivision, f: FaceId, most: usize) -> Self {
        let given: Vec<HalfEdgeId> = s.dcel.half_edge(f).into_iter().flat_map(|h| s.dcel.cycle(h)).collect();
        let n = given.len() as u32;
        let mut room = Self {
            origin: given.iter().map(|&h| s.dcel.origin(h)).collect(),
            next: (1..n).chain([0]).collect(),
            prev: [n - 1].into_iter().chain(0..n - 1).collect(),
            faces: vec![0],
            undone: Vec::new(),
            next_wrong: vec![NONE; given.len()],
            left: most,
            given,
        };
        let wrong: Vec<u32> = (0..n).filter(|&h| room.is_wrong(s, h)).collect();
        let Some(&first) = wrong.first() else { return room };
        for pair in wrong.windows(2) {
            room.next_wrong[pair[0] as usize] = pair[1];
        }
        let boxes = Boxes::new(room.origin.iter().map(|&v| s.points[v]).collect());
        let mut stack = vec![(0, first)];
        while let Some((piece, corner)) = stack.pop() {
            match room.first_seen(s, &boxes, corner) {
                Some((to, passed)) => stack.extend(room.split([corner, to], passed, piece, s)),
                None => room.undone.push(piece),
            }
        }
        room
    }

    fn point(&self, s: &Subdivision, h: u32) -> Point {
        s.points[self.origin[h as usize]]
    }

    /// The corner before, at, and after the origin of a half-edge.
    fn corner(&self, s: &Subdivision, h: u32) -> [Point; 3] {
        [self.prev[h as usize], h, self.next[h as usize]].map(|h| self.point(s, h))
    }

    /// Whether the corner neither turns left nor runs straight on.
    fn is_wrong(&self, s: &Subdivision, h: u32) -> bool {
        !turns_left_or_runs_straight(self.corner(s, h))
    }

    /// The first corner after this one, round its piece, to which a diagonal fits, and the last corner on the way there
    /// that turns the wrong way. None if nothing may be looked at any more.
    fn first_seen(&mut self, s: &Subdivision, boxes: &Boxes, corner: u32) -> Option<(u32, u32)> {
        let (mut passed, mut at) = (corner, self.next[corner as usize]);
        // What is in the way to one corner is often in the way to the next one.
        let mut in_way = None;
        loop {
            if self.next_wrong[passed as usize] == at {
                passed = at;
            }
            at = self.next[at as usize];
            self.left = self.left.checked_sub(1)?;
            if at == self.prev[corner as usize] || at == corner {
                return None;
            }
            if self.faces_inside(s, [corner, at]) {
                let ends = [corner, at].map(|h| self.point(s, h));
                if in_way.is_none_or(|side| !boxes.meets(side, ends)) {
                    in_way = boxes.find_met(ends, &mut self.left)?;
                    if in_way.is_none() {
                        return Some((at, passed));
                    }
                }
            }
        }
    }

    /// Whether a segment between two corners begins and ends inside their piece.
    fn faces_inside(&self, s: &Subdivision, [g, h]: [u32; 2]) -> bool {
        let [a, b] = [g, h].map(|h| self.point(s, h));
        a != b
            && [(g, b), (h, a)].into_iter().all(|(h, to)| {
                let [before, at, after] = self.corner(s, h);
                let along = same_direction(at, after, to) || same_direction(at, before, to);
                !along && in_corner([before, at, after], to)
            })
    }

    /// Joins two corners of a piece. Of its corners that turn the wrong way `from` is the first, and `passed` the last before
    /// `to`. Returns which of the two pieces still have such corners, each with the first of them.
    fn split(
        &mut self,
        [from, to]: [u32; 2],
        passed: u32,
        piece: u32,
        s: &Subdivision,
    ) -> impl Iterator<Item = (u32, u32)> + use<> {
        let (a, b, new) = (self.next.len() as u32, self.next.len() as u32 + 1, self.faces.len() as u32);
        let [before_from, before_to] = [from, to].map(|h| self.prev[h as usize]);
        self.origin.extend([self.origin[from as usize], self.origin[to as usize]]);
        self.next.extend([to, from]);
        self.prev.extend([before_from, before_to]);
        for (h, next) in [(before_from, a), (before_to, b)] {
            self.next[h as usize] = next;
        }
        (self.prev[to as usize], self.prev[from as usize]) = (a, b);
        self.faces[piece as usize] = b;
        self.faces.push(a);
        // Those behind `passed` go on in the new piece, those before them stay.
        let after = self.next_wrong[passed as usize];
        let behind = if after == to { self.next_wrong[to as usize] } else { after };
        let between = if passed == from { NONE } else { self.next_wrong[from as usize] };
        self.next_wrong[passed as usize] = NONE;
        self.next_wrong.extend([NONE, NONE]);
        let mut list = |corners: [u32; 2], rest: u32| {
            corners.into_iter().rev().fold(rest, |rest, h| {
                let wrong = self.is_wrong(s, h);
                if wrong {
                    self.next_wrong[h as usize] = rest;
                }
                if wrong { h } else { rest }
            })
        };
        let pieces = [(piece, list([b, from], between)), (new, list([a, to], behind))];
        pieces.into_iter().filter(|&(_, first)| first != NONE)
    }
}

/// A box round some sides in a row, along the line from their first point to their last.
#[derive(Clone, Copy)]
struct Slab {
    middle: Point,
    /// A vector of length 1.
    along: [f64; 2],
    /// Half of its size, along and across.
    half: [f64; 2],
}

impl Slab {
    fn new(points: &(impl Iterator<Item = Point> + Clone), first: Point, last: Point) -> Self {
        let along = direction(first, last);
        let least =
            |[x, y]: [f64; 2]| points.clone().map(|p| (p.x - first.x) * x + (p.y - first.y) * y).fold(0.0, f64::min);
        let [x, y] = along;
        let [[low, high], [right, left]] = [along, [-y, x]].map(|[x, y]| [least([x, y]), -least([-x, -y])]);
        let [u, v] = [(low + high) / 2.0, (right + left) / 2.0];
        let middle = Point::new(first.x + u * x - v * y, first.y + u * y + v * x);
        Self { middle, along, half: [(high - low) / 2.0, (left - right) / 2.0] }
    }

    /// Whether a segment, which runs this way, passes the box by at a greater distance than rounding can make of none.
    fn is_off(&self, ends: [Point; 2], way: [f64; 2], slack: f64) -> bool {
        let dot = |[a, b]: [f64; 2], [c, d]: [f64; 2]| a * c + b * d;
        let across = |[x, y]: [f64; 2]| [-y, x];
        let [a, b] = ends.map(|p| [p.x - self.middle.x, p.y - self.middle.y]);
        let beside = |axis: [f64; 2], half: f64| {
            let [a, b] = [dot(a, axis), dot(b, axis)];
            a.min(b) > half + slack || a.max(b) < -half - slack
        };
        let [along, normal] = [self.along, across(way)];
        let reach = self.half[0] * dot(along, normal).abs() + self.half[1] * dot(across(along), normal).abs();
        beside(along, self.half[0]) || beside(across(along), self.half[1]) || beside(normal, reach)
    }
}

/// The direction from one point to another; any if they are one.
fn direction(a: Point, b: Point) -> [f64; 2] {
    let [x, y] = [b.x - a.x, b.y - a.y];
    let length = x.hypot(y);
    if length > 0.0 { [x / length, y / length] } else { [1.0, 0.0] }
}

/// Boxes round the sides of a face, round each two in a row, each four, and so on.
struct Boxes {
    points: Vec<Point>,
    /// Those of box i hold boxes 2i and 2i + 1. Sides come last.
    boxes: Vec<Option<Slab>>,
    /// More than rounding moves anything.
    slack: f64,
}

impl Boxes {
    /// O(k log k) for k points.
    fn new(points: Vec<Point>) -> Self {
        let (n, leaves) = (points.len(), points.len().next_power_of_two());
        let largest = points.iter().flat_map(|p| [p.x.abs(), p.y.abs()]).fold(0.0, f64::max);
        let mut boxes = vec![None; 2 * leaves];
        let (mut level, mut size) = (leaves, 1);
        while level > 0 {
            for (i, first) in (0..n).step_by(size).enumerate() {
                let last = (first + size).min(n);
                let sides = (first..=last).map(|p| points[p % n]);
                boxes[level + i] = Some(Slab::new(&sides, points[first], points[last % n]));
            }
            (level, size) = (level / 2, 2 * size);
        }
        Self { points, boxes, slack: largest * 2f64.powi(-44) }
    }

    /// Whether a side meets a segment between its ends: with its first corner, or across it.
    fn meets(&self, side: usize, [a, b]: [Point; 2]) -> bool {
        let [v, w] = [side, (side + 1) % self.points.len()].map(|i| self.points[i]);
        v != a && v != b && on_segment(a, b, v) || cross(a, b, v, w)
    }

    /// A side that meets a segment. None if that would take more than what is left.
    fn find_met(&self, [a, b]: [Point; 2], left: &mut usize) -> Option<Option<usize>> {
        let (leaves, way) = (self.boxes.len() / 2, direction(a, b));
        let mut stack = vec![1];
        while let Some(i) = stack.pop() {
            *left = left.checked_sub(1)?;
            if self.boxes[i].is_none_or(|here| here.is_off([a, b], way, self.slack)) {
                continue;
            }
            if i < leaves {
                stack.extend([2 * i + 1, 2 * i]);
            } else if self.meets(i - leaves, [a, b]) {
                return Some(Some(i - leaves));
            }
        }
        Some(None)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::predicates::{left_to_right, orientation};
    use crate::ids::EdgeId;
    use crate::plane::PlaneJournal;

    /// A comb of three teeth, and a slit into its back.
    fn comb() -> Subdivision {
        let corners = [(0, 0), (13, 0), (13, 2), (9, 9), (9, 2), (7, 2), (5, 9), (5, 2), (3, 2), (0, 9)];
        let mut comb =
            Subdivision::polygon(&corners.map(|(x, y)| Point::new(f64::from(x), f64::from(y)))).expect("simple");
        comb.insert_dangling_edge(VertexId::new(1), Point::new(4.0, 1.0)).expect("inside");
        comb
    }

    fn is_convex(s: &Subdivision, f: FaceId) -> bool {
        s.inner_components(f).is_empty()
            && s.incident_half_edges(f).all(|h| {
                let [u, v, w] = [s.origin(s.prev(h)), s.origin(h), s.destination(h)].map(|v| s.point(v));
                orientation(u, v, w).is_gt()
                    || orientation(u, v, w).is_eq() && left_to_right(u, v) == left_to_right(v, w)
            })
    }

    #[test]
    fn pieces_are_convex_however_much_is_looked_at() {
        let before = comb();
        for most in 0..200 {
            let (mut s, mut journal) = (before.clone(), PlaneJournal::new());
            let added = s.cut_looking_at(most, FaceId::new(1), &mut journal).expect("it can be cut");
            assert_eq!(s.geometry_violations(), [], "{most}");
            assert!(added.iter().chain([&FaceId::new(1)]).all(|&f| is_convex(&s, f)), "{most}");
            assert_eq!(s.face_count(), 2 + added.len());
            s.undo(&mut journal, 0);
            assert_eq!(s, before, "{most}");
        }
    }

    /// The diagonals by the rule at the head of the file, all pairs asked: the ends of each.
    fn by_rule(s: &Subdivision, f: FaceId) -> Vec<[VertexId; 2]> {
        let mut diagonals = Vec::new();
        let mut pieces: Vec<Vec<VertexId>> = vec![s.incident_half_edges(f).map(|h| s.origin(h)).collect()];
        while let Some(piece) = pieces.pop() {
            let n = piece.len();
            let at = |i: usize| s.point(piece[i % n]);
            let corner = |i: usize| [at(i + n - 1), at(i), at(i + 1)];
            let is_wrong = |i: usize| {
                let [u, v, w] = corner(i);
                let turn = orientation(u, v, w);
                turn.is_lt() || turn.is_eq() && left_to_right(u, v) != left_to_right(v, w)
            };
            let looks_inside = |i: usize, j: usize| {
                let [u, v, w] = corner(i);
                let between = |p, q| orientation(v, p, q).is_gt();
                let to = at(j);
                match orientation(v, w, u) {
                    turn if turn.is_gt() => between(w, to) && between(to, u),
                    turn if turn.is_lt() => between(w, to) || between(to, u),
                    // The corner at the end of a slit, or on a straight side.
                    _ if left_to_right(v, u) == left_to_right(v, w) => {
                        orientation(v, w, to).is_ne() || left_to_right(v, to) != left_to_right(v, w)
                    }
                    _ => between(w, to),
                }
            };
            let is_free = |i: usize, j: usize| {
                let (a, b) = (at(i), at(j));
                let is_inside = |p: Point| {
                    orientation(a, b, p).is_eq() && left_to_right(a, p) == left_to_right(p, b) && p != a && p != b
                };
                (0..n).all(|k| !is_inside(at(k)) && !cross(a, b, at(k), at(k + 1)))
            };
            let Some(from) = (0..n).find(|&i| is_wrong(i)) else { continue };
            let sees = |&to: &usize| {
                at(from) != at(to) && looks_inside(from, to) && looks_inside(to, from) && is_free(from, to)
            };
            let to = (from + 2..from + n - 1).find(sees).expect("such a corner sees another one");
            let part = |first: usize, last: usize| (first..=last).map(|i| piece[i % n]);
            diagonals.push([piece[from], piece[to % n]]);
            pieces.push(std::iter::once(piece[to % n]).chain(part(from, to - 1)).collect());
            pieces.push(std::iter::once(piece[from]).chain(part(to, from + n - 1)).collect());
        }
        diagonals.sort_unstable();
        diagonals
    }

    /// The ends of the edges behind so many.
    fn ends_behind(s: &Subdivision, edges: usize) -> Vec<[VertexId; 2]> {
        let new = s.edges().skip(edges);
        let mut ends: Vec<[VertexId; 2]> = new.map(|e| e.half_edges().map(|h| s.origin(h))).collect();
        ends.sort_unstable();
        ends
    }

    /// Faces of triangulations from which edges were taken: dents, slits, straight corners.
    fn random(seed: u64) -> Subdivision {
        let mut next = crate::plane::sweep::tests::numbers(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15));
        let (size, far) = (3 + next(9), [0.0, 1e6, -1e12][next(3) as usize]);
        let places = (0..4 + next(40)).map(|_| [next(size), next(size)].map(|x| x as f64 * 0.37 + far));
        let places: Vec<Point> = places.map(Point::from).collect();
        let Ok(built) = Subdivision::delaunay(&places) else { return comb() };
        let mut s = built.subdivision;
        for e in s.edges().collect::<Vec<_>>() {
            let [f, g] = e.half_edges().map(|h| s.face(h));
            if next(2) == 0 && ![f, g].contains(&s.outer_face()) && (f != g || next(4) == 0) {
                let mut joined = s.clone();
                joined.remove_edge(e).expect("it is there");
                if joined.faces().all(|f| f == joined.outer_face() || joined.inner_components(f).is_empty()) {
                    s = joined;
                }
            }
        }
        let _ = s.compact();
        s
    }

    #[test]
    fn diagonals_are_those_of_the_rule() {
        let (mut cuts, mut slits) = (0, 0);
        for seed in 1..900 {
            let given = random(seed);
            for f in given.faces().filter(|&f| f != given.outer_face()) {
                let mut s = given.clone();
                let added = s.cut_into_convex_with(f, &mut PlaneJournal::new()).expect("it can be cut");
                let expected = by_rule(&given, f);
                assert_eq!(ends_behind(&s, given.edge_count()), expected, "seed {seed}, {f:?}");
                assert_eq!(added.len(), expected.len(), "seed {seed}, {f:?}");
                cuts += expected.len();
                slits += given.incident_half_edges(f).filter(|h| given.face(h.twin()) == f).count();
            }
        }
        assert!(cuts > 3_000 && slits > 1_000, "{cuts} {slits}");
    }

    #[test]
    fn the_work_in_a_long_comb_is_within_its_bound() {
        let comb = |teeth: u32| {
            let tooth = |i: u32| {
                let x = f64::from(4 * i);
                [(x, 2.0), (x + 1.0, 9.0 + f64::from(i % 3)), (x + 2.0, 2.0)].map(Point::from)
            };
            let width = f64::from(4 * teeth);
            let mut corners: Vec<Point> = vec![Point::new(width, 0.0)];
            corners.extend((0..teeth).rev().flat_map(|i| tooth(i).into_iter().rev()));
            corners.push(Point::new(-1.0, 0.0));
            let mut s = Subdivision::polygon(&corners).expect("simple");
            let expected = if teeth < 40 { Some(by_rule(&s, FaceId::new(1)).len()) } else { None };
            let added = s.cut_into_convex_with(FaceId::new(1), &mut PlaneJournal::new()).expect("it can be cut").len();
            assert_eq!(expected.unwrap_or(added), added);
            added
        };
        // A face that is left to the sweep becomes triangles, which are more.
        let (few, more) = (comb(10), comb(20));
        for teeth in [200, 2_000, 20_000] {
            assert_eq!(comb(teeth), few + (teeth as usize - 10) / 10 * (more - few), "{teeth} teeth");
        }
    }

    #[test]
    fn edges_that_go_at_once_leave_what_they_leave_one_by_one() {
        let mut cut = comb();
        cut.cut_into_convex_with(FaceId::new(1), &mut PlaneJournal::new()).expect("it can be cut");
        let edges: Vec<EdgeId> =
            cut.edges().filter(|e| e.half_edges().iter().all(|&h| cut.face(h) != cut.outer_face())).collect();
        for (first, stays_from) in (0..edges.len()).flat_map(|i| (0..5).map(move |from| (i, from))) {
            let stays = |f: FaceId| f.number() >= stays_from;
            let (mut one_by_one, mut at_once) = (cut.clone(), cut.clone());
            for &e in &edges[first..] {
                let [h, t] = e.half_edges();
                let [f, g] = [h, t].map(|h| one_by_one.face(h));
                if f == g {
                    one_by_one.remove_edge(e).expect("it can go");
                } else {
                    one_by_one.join_faces(if stays(f) { t } else { h }).expect("they can be joined");
                }
            }
            let mut journal = PlaneJournal::new();
            at_once.remove_edges_with(edges[first..].iter().copied(), stays, &mut journal).expect("they can go");
            assert_eq!(at_once, one_by_one);
            at_once.undo(&mut journal, 0);
            assert_eq!(at_once, cut);
        }
    }
}
