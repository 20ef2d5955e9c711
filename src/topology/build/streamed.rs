//! Matching and writing in one go, for faces that come in a local order.
//!
//! ```text
//!   smaller end   edges met so far
//!       ...
//!       3         -> e9 (3, 4) -> e2 (3, 8)      A half-edge (4, 3) looks in list 3 and finds its twin in e9.
//!       4         -> e5 (4, 7)                   A second (3, 4) finds e9, too: a clash.
//!       ...
//! ```

use super::faces::Faces;
use super::{BORDERS, Stop};
use crate::topology::links::Columns;

const NONE: u32 = Columns::NONE;

/// Writes the half-edges of all faces as they come, looking up in the lists whether the edge is there already.
pub(super) fn streamed<F: Faces + ?Sized>(faces: &F, vertices: usize, first_face: u32) -> Result<Columns, Stop> {
    let mut edges = Edges::new(vertices, faces.corners().len());
    let face_count = first_face as usize + faces.face_count();
    let mut boundary = Vec::with_capacity(face_count + BORDERS);
    boundary.resize(face_count, NONE);
    faces.try_for_each_cycle(|face, cycle, corners| {
        let face = face + first_face;
        // Nearly all faces are triangles: without a loop they take a tenth less.
        if let &[a, b, c] = corners {
            let [h, i, j] = [edges.half_edge(a, b)?, edges.half_edge(b, c)?, edges.half_edge(c, a)?];
            for (before, h, after) in [(j, h, i), (h, i, j), (i, j, h)] {
                edges.face[h as usize] = face;
                edges.prev[h as usize] = before;
                edges.next[h as usize] = after;
            }
            if cycle == 0 {
                boundary[face as usize] = h;
            }
            return Ok(());
        }
        let mut first = NONE;
        let mut before = NONE;
        for (k, &from) in corners.iter().enumerate() {
            let to = if k + 1 < corners.len() { corners[k + 1] } else { corners[0] };
            let h = edges.half_edge(from, to)?;
            edges.face[h as usize] = face;
            if k == 0 {
                first = h;
            } else {
                edges.next[before as usize] = h;
                edges.prev[h as usize] = before;
            }
            before = h;
        }
        edges.next[before as usize] = first;
        edges.prev[first as usize] = before;
        if cycle == 0 {
            boundary[face as usize] = first;
        }
        Ok(())
    })?;
    Ok(edges.finish(boundary))
}

/// The columns of half-edges and of vertices while they are filled, and the lists.
struct Edges {
    origin: Vec<u32>,
    next: Vec<u32>,
    prev: Vec<u32>,
    face: Vec<u32>,
    /// By vertex: the first half-edge met that starts there. That is in the first face that uses the vertex, and even: where
    /// a vertex is new, so are its edges.
    outgoing: Vec<u32>,
    /// By vertex: the edge met last whose smaller end it is.
    heads: Vec<u32>,
    /// By edge: the edge met before it with the same smaller end.
    links: Vec<u32>,
}

impl Edges {
    /// Room is made for so many edges at a time.
    const STEP: usize = 512;
    /// Searching a list gives up after so many edges.
    const DEEPEST: usize = 64;

    fn new(vertices: usize, corners: usize) -> Self {
        let edges = corners / 2 + corners / 16 + Self::STEP;
        let column = || Vec::with_capacity(2 * edges);
        Self {
            origin: column(),
            next: column(),
            prev: column(),
            face: column(),
            outgoing: vec![NONE; vertices],
            heads: vec![NONE; vertices],
            links: Vec::with_capacity(edges),
        }
    }

    /// The half-edge `from -> to`: the odd half of an edge that is there, or the even half of a new one.
    #[inline(always)]
    fn half_edge(&mut self, from: u32, to: u32) -> Result<u32, Stop> {
        let Some(head) = self.heads.get_mut(from.min(to) as usize) else { return Err(Stop::Ends) };
        let mut edge = *head;
        let mut depth = 0;
        while edge != NONE {
            let h = 2 * edge as usize;
            let ends = [self.origin[h], self.origin[h + 1]];
            if ends == [to, from] && self.face[h + 1] == NONE {
                return Ok(2 * edge + 1);
            }
            if ends == [to, from] || ends == [from, to] {
                return Err(Stop::Clash);
            }
            depth += 1;
            if depth > Self::DEEPEST {
                return Err(Stop::LongList);
            }
            edge = self.links[edge as usize];
        }
        // Ends that are wrong are those of no edge met before.
        if from == to || from.max(to) as usize >= self.outgoing.len() {
            return Err(Stop::Ends);
        }
        let edge = self.links.len();
        let first = &mut self.outgoing[from as usize];
        *first = (2 * edge as u32).min(*first);
        if 2 * edge == self.origin.len() {
            for column in [&mut self.origin, &mut self.next, &mut self.prev, &mut self.face] {
                column.resize(column.len() + 2 * Self::STEP, NONE);
            }
        }
        self.links.push(*head);
        *head = edge as u32;
        self.origin[2 * edge] = from;
        self.origin[2 * edge + 1] = to;
        Ok(2 * edge as u32)
    }

    fn finish(mut self, boundary: Vec<u32>) -> Columns {
        for column in [&mut self.origin, &mut self.next, &mut self.prev, &mut self.face] {
            column.truncate(2 * self.links.len());
            column.shrink_to_fit();
        }
        let Self { origin, next, prev, face, outgoing, .. } = self;
        Columns { origin, next, prev, face, outgoing, boundary }
    }
}
