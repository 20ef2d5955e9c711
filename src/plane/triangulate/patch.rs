//! A copy of the links of some faces, to cut them up before anything is written.
//!
//! ```text
//!   half-edges of the patch   0 ........ n-1 | n  n+1 | n+2  n+3 | ...     next, prev, origin, face
//!                             those given,     a diagonal is two half-edges
//!                             face by face
//!
//!   places                    0 1 2 3 ....     the vertices from left to right, so that "further left" is a
//!                                              comparison of two numbers
//! ```
//!
//! A *corner* of a face is named by the half-edge that leaves it. A diagonal joins two corners.

use super::TriangulateError;
use crate::geometry::places::from_left_to_right;
use crate::geometry::predicates::{left_to_right, orientation};
use crate::ids::{FaceId, HalfEdgeId, MAX_IDS, VertexId};
use crate::plane::{Point, Subdivision};
use crate::topology::{InnerComponent, TooMany};
use std::cmp::Ordering;

/// The links of the faces being cut. They hold no borrow, so that the subdivision can be written from them.
pub(super) struct Links {
    /// The half-edges given.
    pub(super) given: Vec<HalfEdgeId>,
    pub(super) next: Vec<u32>,
    pub(super) prev: Vec<u32>,
    /// The face each half-edge bounds in the subdivision; a single entry where that is one face for all.
    face: Vec<FaceId>,
    /// The place that each half-edge leaves.
    pub(super) origin: Vec<u32>,
    /// The vertex at each place.
    pub(super) vertex: Vec<VertexId>,
}

/// One face of a patch.
pub(super) struct Part {
    /// Its half-edges given, from this one ...
    pub(super) first: u32,
    /// ... to before this one.
    pub(super) end: u32,
    /// The inner components of the patch before its own, and after them.
    pub(super) rings: [u32; 2],
}

/// An inner component of a face of the patch.
#[derive(Clone, Copy)]
pub(super) enum PatchComponent {
    /// A cycle, by the first and the last of its half-edges given.
    Cycle(u32, u32),
    /// An isolated vertex, by its place, in a face.
    Isolated(u32, FaceId),
}

/// Faces being cut.
pub(super) struct Patch {
    links: Links,
    pub(super) parts: Vec<Part>,
    pub(super) rings: Vec<PatchComponent>,
    /// Where each place is.
    pub(super) points: Vec<Point>,
    /// The corners given from left to right, those of one vertex together; an isolated vertex is the number of
    /// corners given plus the number of its inner component.
    pub(super) events: Vec<u32>,
    /// Whether the patch is one face whose boundary runs to the right and back just once: there are no gaps to follow.
    pub(super) is_monotone: bool,
}

impl Patch {
    /// Copies the links of different bounded faces. Triangles without inner components are left out. O(n log n).
    pub(super) fn new(s: &Subdivision, faces: &[FaceId]) -> Result<Self, TooMany> {
        let mut patch = Self::collect(s, faces);
        // A diagonal for each corner and two for each inner component are enough.
        if 6 * (patch.links.given.len() + patch.rings.len()) > MAX_IDS {
            return Err(TooMany);
        }
        match patch.order_of_two_rows(s) {
            Some(order) => {
                patch.is_monotone = true;
                let origin = std::mem::take(&mut patch.links.origin);
                patch.number(s, order.iter().map(|&corner| (origin[corner as usize], corner)));
                patch.events = order;
            }
            None => patch.put_in_order(s),
        }
        Ok(patch)
    }

    /// The half-edges, face by face and cycle by cycle; origins are vertices for the time being.
    fn collect(s: &Subdivision, faces: &[FaceId]) -> Self {
        let (mut given, mut origin) = (Vec::new(), Vec::new());
        let (mut parts, mut rings) = (Vec::with_capacity(faces.len()), Vec::new());
        let mut cycles: Vec<(u32, u32, FaceId)> = Vec::new();
        for &f in faces {
            let Some(boundary) = s.dcel.half_edge(f) else { continue };
            let own_rings = s.inner_components(f);
            if own_rings.is_empty() && s.dcel.next(s.dcel.next(s.dcel.next(boundary))) == boundary {
                continue;
            }
            let mut part = Part { first: given.len() as u32, end: 0, rings: [rings.len() as u32; 2] };
            for ring in std::iter::once(InnerComponent::Cycle(boundary)).chain(own_rings.iter().copied()) {
                let first = given.len() as u32;
                match ring {
                    InnerComponent::Isolated(v) => rings.push(PatchComponent::Isolated(v.number(), f)),
                    InnerComponent::Cycle(start) => {
                        for h in s.dcel.cycle(start) {
                            given.push(h);
                            origin.push(s.dcel.origin(h).number());
                        }
                        let last = given.len() as u32 - 1;
                        cycles.push((first, last, f));
                        if first != part.first {
                            rings.push(PatchComponent::Cycle(first, last));
                        }
                    }
                }
            }
            part.end = given.len() as u32;
            part.rings[1] = rings.len() as u32;
            parts.push(part);
        }
        // What the diagonals will need, at most, has room from the beginning.
        let corners = given.len() as u32;
        let room = 3 * given.len() + 4 * rings.len();
        let column = || Vec::with_capacity(room);
        let (mut next, mut prev, mut face) = (column(), column(), Vec::new());
        next.extend(1..=corners);
        prev.extend((0..corners).map(|i| i.wrapping_sub(1)));
        if let [part] = &parts[..] {
            face.extend(cycles.iter().map(|&(.., f)| f).take(1));
            debug_assert!(part.end > 1);
        } else {
            face.reserve(room);
            cycles.iter().for_each(|&(_, last, f)| face.resize(last as usize + 1, f));
        }
        for (first, last, _) in cycles {
            next[last as usize] = first;
            prev[first as usize] = last;
        }
        let links = Links { given, next, prev, face, origin, vertex: Vec::new() };
        Self { links, parts, rings, points: Vec::new(), events: Vec::new(), is_monotone: false }
    }

    /// The corners from left to right if the patch is one face without inner components whose
    /// boundary runs to the right and back just once: two rows, which are merged. Most others show that they are not
    /// at their first corners. O(n).
    ///
    /// ```text
    ///        ●──●───●
    ///       ╱        ╲         Each row is in order, so that nothing has to be sorted.
    ///      ●──●────●──●
    /// ```
    fn order_of_two_rows(&self, s: &Subdivision) -> Option<Vec<u32>> {
        let origin = &self.links.origin;
        if self.parts.len() != 1 || !self.rings.is_empty() {
            return None;
        }
        let at = |corner: u32| s.points[VertexId::new(origin[corner as usize])];
        let n = origin.len() as u32;
        let (mut leftmost, mut rightmost) = (None, None);
        let mut here = at(0);
        let mut came = left_to_right(at(n - 1), here);
        for corner in 0..n {
            let there = at(if corner + 1 == n { 0 } else { corner + 1 });
            let goes = left_to_right(here, there);
            let turns = match (came, goes) {
                (Ordering::Less, Ordering::Less) | (Ordering::Greater, Ordering::Greater) => None,
                (Ordering::Greater, Ordering::Less) => Some(&mut leftmost),
                (Ordering::Less, Ordering::Greater) => Some(&mut rightmost),
                _ => return None,
            };
            if turns.is_some_and(|end| end.replace(corner).is_some()) {
                return None;
            }
            (came, here) = (goes, there);
        }
        let (leftmost, rightmost) = leftmost.zip(rightmost)?;
        let mut order = Vec::with_capacity(origin.len());
        order.push(leftmost);
        let (mut lower, mut upper) = (self.next(leftmost), self.prev(leftmost));
        while lower != rightmost || upper != rightmost {
            match left_to_right(at(lower), at(upper)) {
                Ordering::Less => {
                    order.push(lower);
                    lower = self.next(lower);
                }
                Ordering::Greater => {
                    order.push(upper);
                    upper = self.prev(upper);
                }
                // The boundary touches itself.
                Ordering::Equal => return None,
            }
        }
        order.push(rightmost);
        Some(order)
    }

    /// Finds the places: the corners and isolated vertices from left to right.
    fn put_in_order(&mut self, s: &Subdivision) {
        let corners = self.links.given.len();
        let isolated = self.rings.iter().enumerate().filter_map(|(i, ring)| match *ring {
            PatchComponent::Isolated(v, _) => Some((v, (corners + i) as u32)),
            PatchComponent::Cycle(..) => None,
        });
        let all = self.links.origin.iter().zip(0..).map(|(&v, i)| (v, i)).chain(isolated);
        let order = from_left_to_right(all, |v| s.points[VertexId::new(v)]);
        self.number(s, order.iter().copied());
        self.events = order.into_iter().map(|(_, event)| event).collect();
    }

    /// Gives places to vertices, which come from left to right, each with what happens there.
    fn number(&mut self, s: &Subdivision, order: impl ExactSizeIterator<Item = (u32, u32)>) {
        let corners = self.links.given.len();
        let mut origin = Vec::with_capacity(self.links.next.capacity());
        origin.resize(corners, 0);
        self.links.vertex.reserve(order.len());
        self.points.reserve(order.len());
        for (v, event) in order {
            if self.links.vertex.last() != Some(&VertexId::new(v)) {
                self.links.vertex.push(VertexId::new(v));
                self.points.push(s.points[VertexId::new(v)]);
            }
            let place = self.links.vertex.len() as u32 - 1;
            match event as usize {
                corner if corner < corners => origin[corner] = place,
                ring => {
                    if let PatchComponent::Isolated(v, _) = &mut self.rings[ring - corners] {
                        *v = place;
                    }
                }
            }
        }
        self.links.origin = origin;
    }

    /// The half-edges given.
    pub(super) fn given_half_edges(&self) -> &[HalfEdgeId] {
        &self.links.given
    }

    /// The vertex at each place.
    pub(super) fn vertices(&self) -> &[VertexId] {
        &self.links.vertex
    }

    /// The number of half-edges given: those of diagonals come after them.
    pub(super) fn given(&self) -> u32 {
        self.links.given.len() as u32
    }

    /// The number of half-edges, those of diagonals included.
    pub(super) fn len(&self) -> u32 {
        self.links.next.len() as u32
    }

    #[inline]
    pub(super) fn next(&self, h: u32) -> u32 {
        self.links.next[h as usize]
    }

    #[inline]
    pub(super) fn prev(&self, h: u32) -> u32 {
        self.links.prev[h as usize]
    }

    /// The vertex at a place.
    pub(super) fn vertex(&self, place: u32) -> VertexId {
        self.links.vertex[place as usize]
    }

    /// The place that `h` leaves.
    #[inline]
    pub(super) fn origin(&self, h: u32) -> u32 {
        self.links.origin[h as usize]
    }

    /// The face of the subdivision that `h` bounds.
    #[inline]
    pub(super) fn face(&self, h: u32) -> FaceId {
        self.links.face_of(h)
    }

    /// Where `h` starts.
    #[inline]
    pub(super) fn point(&self, h: u32) -> Point {
        self.points[self.origin(h) as usize]
    }

    /// Which way the corner of `h` turns: `Greater` = left, it is convex.
    #[inline]
    pub(super) fn turn(&self, h: u32) -> Ordering {
        orientation(self.point(self.prev(h)), self.point(h), self.point(self.next(h)))
    }

    /// Joins the corners of `g` and `h` by a diagonal. Returns its half-edge that leaves the corner of `g`.
    ///
    /// ```text
    ///        ╲      ^ g               Seen from the corner of g, the directions from g counter-clockwise to the
    ///         v    ╱                  diagonal stay the corner of g; those from the diagonal on become the corner
    ///          ● ─ ─ diagonal ─ ─>    of the half-edge returned.
    /// ```
    pub(super) fn join(&mut self, g: u32, h: u32) -> u32 {
        let (before_g, before_h) = (self.prev(g), self.prev(h));
        let a = self.add(self.origin(g), self.origin(h), self.face(g));
        self.follow(before_g, a);
        self.follow(a, h);
        self.follow(before_h, a + 1);
        self.follow(a + 1, g);
        a
    }

    /// Joins an isolated vertex to the corner of `h`. Returns the half-edge that leaves the vertex.
    pub(super) fn join_isolated(&mut self, place: u32, h: u32) -> u32 {
        let before_h = self.prev(h);
        let a = self.add(place, self.origin(h), self.face(h));
        self.follow(before_h, a + 1);
        self.follow(a + 1, a);
        self.follow(a, h);
        a
    }

    /// Cuts off the corner of `b`, which must be convex and free of others. Returns the half-edge that takes its
    /// place: from the corner before to the one after.
    ///
    /// ```text
    ///           b              prev(b), b and the first half-edge of the diagonal are a triangle; the second
    ///          ╱ ╲             joins what is left.
    ///     ──> ●──>● ──>
    /// ```
    #[inline]
    pub(super) fn cut(&mut self, b: u32) -> u32 {
        let (a, c) = (self.prev(b), self.next(b));
        let before = self.prev(a);
        let x = self.add(self.origin(c), self.origin(a), self.face(b));
        self.follow(b, x);
        self.follow(x, a);
        self.follow(before, x + 1);
        self.follow(x + 1, c);
        x + 1
    }

    /// Adds a diagonal of a face between two places that hangs on nothing yet. Returns its half-edge that leaves `from`;
    /// the other one is the next number.
    #[inline]
    pub(super) fn add(&mut self, from: u32, to: u32, face: FaceId) -> u32 {
        let a = self.len();
        // Less work than `extend` of an array, which asks for each item whether there is room.
        self.links.origin.extend_from_slice(&[from, to]);
        if self.links.face.len() > 1 {
            self.links.face.extend_from_slice(&[face; 2]);
        }
        self.links.next.extend_from_slice(&[a; 2]);
        self.links.prev.extend_from_slice(&[a; 2]);
        a
    }

    /// Makes `h` the next half-edge after `g`.
    #[inline]
    pub(super) fn follow(&mut self, g: u32, h: u32) {
        self.links.next[g as usize] = h;
        self.links.prev[h as usize] = g;
    }

    /// The place of the leftmost vertex of an inner component. O(length).
    pub(super) fn place_of(&self, ring: u32) -> u32 {
        match self.rings[ring as usize] {
            PatchComponent::Isolated(place, _) => place,
            PatchComponent::Cycle(first, last) => (first..=last).map(|h| self.origin(h)).min().unwrap_or_default(),
        }
    }

    /// The error that names the face and the vertex of `h`.
    pub(super) fn fault(&self, h: u32) -> TriangulateError {
        self.fault_at(self.origin(h), self.face(h))
    }

    /// The error that names the face and the vertex at the place.
    pub(super) fn fault_at(&self, place: u32, face: FaceId) -> TriangulateError {
        TriangulateError::NotPlanar { face, vertex: self.links.vertex[place as usize] }
    }

    /// The cycles, each by its first half-edge, in increasing order, after a look that all are triangles of positive
    /// area and as many as there must be. O(n).
    pub(super) fn triangles(&self) -> Result<Vec<u32>, TriangulateError> {
        let mut triangles = Vec::with_capacity(self.len() as usize / 3);
        for a in 0..self.len() {
            let b = self.next(a);
            let c = self.next(b);
            if self.next(c) != a || a == b {
                return Err(self.fault(a));
            }
            if a < b && a < c {
                if !self.turn(a).is_gt() {
                    return Err(self.fault(a));
                }
                triangles.push(a);
            }
        }
        self.counted(triangles)
    }

    /// The cycles, each by its first half-edge, in increasing order, after a look that they are as many as there must
    /// be. O(n).
    pub(super) fn pieces(&self) -> Result<Vec<u32>, TriangulateError> {
        let mut seen = vec![false; self.len() as usize];
        let mut pieces = Vec::new();
        for start in 0..self.len() {
            if seen[start as usize] {
                continue;
            }
            pieces.push(start);
            let mut h = start;
            while !std::mem::replace(&mut seen[h as usize], true) {
                h = self.next(h);
            }
        }
        self.counted(pieces)
    }

    /// A diagonal that joins no inner component adds one piece.
    fn counted(&self, pieces: Vec<u32>) -> Result<Vec<u32>, TriangulateError> {
        let expected = self.parts.len() + self.links.diagonals();
        match self.parts.first() {
            Some(part) if pieces.len() + self.rings.len() != expected => Err(self.fault(part.first)),
            _ => Ok(pieces),
        }
    }

    pub(super) fn into_links(self) -> Links {
        self.links
    }
}

impl Links {
    /// The face that `h` bounds in the subdivision.
    #[inline]
    pub(super) fn face_of(&self, h: u32) -> FaceId {
        match self.face[..] {
            [only] => only,
            _ => self.face[h as usize],
        }
    }

    /// The number of diagonals.
    pub(super) fn diagonals(&self) -> usize {
        (self.next.len() - self.given.len()) / 2
    }
}
