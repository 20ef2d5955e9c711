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

use crate::geometry::predicates::{left_to_right, orientation};
use crate::ids::{FaceId, HalfEdgeId, VertexId};
use crate::plane::cycle::{in_corner, on_segment, same_direction};
use crate::plane::sweep::cross;
use crate::plane::triangulate::{TriangulateError, TriangulationMethod};
use crate::plane::{PlaneRecorder, Point, Subdivision};

/// No corner.
const NONE: u32 = u32::MAX;

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
        let mut added = Vec::new();
        let mut rest = vec![f];
        if self.inner_components(f).is_empty() {
            let room = Room::cut(self, f);
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
    fn cut(s: &Subdivision, f: FaceId) -> Self {
        let given: Vec<HalfEdgeId> = s.dcel.half_edge(f).into_iter().flat_map(|h| s.dcel.cycle(h)).collect();
        let n = given.len() as u32;
        let mut room = Self {
            origin: given.iter().map(|&h| s.dcel.origin(h)).collect(),
            next: (1..n).chain([0]).collect(),
            prev: [n - 1].into_iter().chain(0..n - 1).collect(),
            faces: vec![0],
            undone: Vec::new(),
            next_wrong: vec![NONE; given.len()],
            left: (1 << 16) + 32 * given.len() * (2 + given.len().ilog2() as usize),
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
        let [u, v, w] = self.corner(s, h);
        let turn = orientation(u, v, w);
        turn.is_lt() || turn.is_eq() && left_to_right(u, v) != left_to_right(v, w)
    }

    /// The first corner after this one, round its piece, to which a diagonal fits, and the last corner on the way there
    /// that turns the wrong way. None if nothing may be looked at any more.
    fn first_seen(&mut self, s: &Subdivision, boxes: &Boxes, corner: u32) -> Option<(u32, u32)> {
        let (mut passed, mut at) = (corner, self.next[corner as usize]);
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
                if !boxes.meet(ends, &mut self.left)? {
                    return Some((at, passed));
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

/// Boxes round the sides of a face, round each two in a row, each four, and so on.
struct Boxes {
    points: Vec<Point>,
    /// The least and the greatest corner of each; those of box i hold boxes 2i and 2i + 1. Sides come last.
    boxes: Vec<[Point; 2]>,
}

impl Boxes {
    fn new(points: Vec<Point>) -> Self {
        let (n, leaves) = (points.len(), points.len().next_power_of_two());
        let round = |[a, b]: [Point; 2], [c, d]: [Point; 2]| {
            [Point::new(a.x.min(c.x), a.y.min(c.y)), Point::new(b.x.max(d.x), b.y.max(d.y))]
        };
        // Behind the last side there are points again.
        let mut boxes = vec![[points[0]; 2]; leaves];
        boxes.extend((0..leaves).map(|i| round([points[i.min(n - 1)]; 2], [points[(i.min(n - 1) + 1) % n]; 2])));
        for i in (1..leaves).rev() {
            boxes[i] = round(boxes[2 * i], boxes[2 * i + 1]);
        }
        Self { points, boxes }
    }

    /// Whether a side meets the segment between its ends: with its first corner, or across it. None if that would take more
    /// than what is left.
    fn meet(&self, [a, b]: [Point; 2], left: &mut usize) -> Option<bool> {
        let (n, leaves) = (self.points.len(), self.boxes.len() / 2);
        let [min, max] = [Point::new(a.x.min(b.x), a.y.min(b.y)), Point::new(a.x.max(b.x), a.y.max(b.y))];
        let mut stack = vec![1];
        while let Some(i) = stack.pop() {
            *left = left.checked_sub(1)?;
            let [low, high] = self.boxes[i];
            if low.x > max.x || low.y > max.y || high.x < min.x || high.y < min.y {
                continue;
            }
            if i >= leaves {
                let side = i - leaves;
                if side >= n {
                    continue;
                }
                let [v, w] = [self.points[side], self.points[(side + 1) % n]];
                if v != a && v != b && on_segment(a, b, v) || cross(a, b, v, w) {
                    return Some(true);
                }
                continue;
            }
            let turn = |x, y| orientation(a, b, Point::new(x, y));
            let first = turn(low.x, low.y);
            let beside = [turn(high.x, low.y), turn(high.x, high.y), turn(low.x, high.y)];
            if first.is_eq() || beside.iter().any(|&turn| turn != first) {
                stack.extend([2 * i + 1, 2 * i]);
            }
        }
        Some(false)
    }
}
