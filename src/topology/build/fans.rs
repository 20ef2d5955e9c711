//! What happens at the vertices: border half-edges are linked, and the faces round a vertex must be one fan.
//!
//! ```text
//!        \  f  /                  \  f  /                       \  f  /
//!      f  \   /  f              f  \   /  f                      \   /   gap
//!     ──── v ●  ────           ──── v ●  ────               gap    ●
//!      f  /   \  f              f  /   \   gap                   /   \
//!        /  f  \                  /  f  \                       /  f  \
//!
//!     one closed fan         one open fan: the two border      two fans: pinched. Without coordinates
//!                            half-edges at v follow each       nobody knows which border half-edge
//!                            other                             follows which
//! ```

use super::{BuildError, Matched};
use crate::ids::{FaceId, HalfEdgeId, MAX_IDS, VertexId};
use crate::topology::TooMany;
use crate::topology::links::{Columns, TAG};

const NONE: u32 = Columns::NONE;

impl Matched {
    /// Fills the column of vertices, links the border where it is clear, and finds the pinched vertices.
    pub(super) fn new(vertices: usize, columns: Columns, first_face: u32) -> Self {
        let border = (0..).zip(&columns.face).filter(|&(_, &face)| face == NONE).map(|(h, _)| h).collect();
        let mut this = Self { columns, border, pinched: Vec::new(), isolated: 0, first_isolated: None, first_face };
        this.columns.outgoing = vec![NONE; vertices];
        let one_gap_each = this.link_border();
        let firsts = first_half_edges(&this.columns.origin, vertices);
        this.isolated = vertices - firsts.len();
        for &h in &firsts {
            let word = &mut this.columns.outgoing[this.columns.origin[h as usize] as usize];
            // A vertex on the border has its half-edge already.
            if *word == NONE {
                *word = h;
            }
        }
        if this.isolated > 0 {
            let first = this.columns.outgoing.iter().position(|&word| word == NONE);
            this.first_isolated = first.map(|v| VertexId(v as u32));
        }
        if !one_gap_each || stars_length(&this.columns.prev, &firsts) != this.columns.prev.len() {
            this.find_pinched();
        }
        this
    }

    /// Makes the border half-edge that ends at a vertex and the one that starts there follow each other, where
    /// there is only one. Vertices with several are tagged; returns whether there are none.
    fn link_border(&mut self) -> bool {
        let Columns { origin, next, prev, outgoing, .. } = &mut self.columns;
        let mut one_gap_each = true;
        for &h in &self.border {
            let word = &mut outgoing[origin[h as usize] as usize];
            if *word == NONE {
                *word = h;
            } else {
                *word |= TAG;
                one_gap_each = false;
            }
        }
        for &h in &self.border {
            let after = outgoing[origin[h as usize ^ 1] as usize];
            if after & TAG == 0 {
                next[h as usize] = after;
                prev[after as usize] = h;
            }
        }
        one_gap_each
    }

    /// Compares each star with the degree of its vertex, lists the vertices where they differ or where there
    /// are several gaps, and takes back the border links there. O(vertices + half-edges).
    fn find_pinched(&mut self) {
        let Columns { origin, next, prev, outgoing, .. } = &mut self.columns;
        let mut degree = vec![0_usize; outgoing.len()];
        for &v in origin.iter() {
            degree[v as usize] += 1;
        }
        for (v, word) in outgoing.iter_mut().enumerate() {
            let gaps = *word != NONE && *word & TAG != 0;
            if gaps {
                *word &= !TAG;
            }
            if gaps || *word != NONE && star_length(prev, *word) != degree[v] {
                self.pinched.push(VertexId(v as u32));
            }
        }
        let pinched = |v: u32| self.pinched.binary_search(&VertexId(v)).is_ok();
        for &h in &self.border {
            if pinched(origin[h as usize]) {
                prev[h as usize] = NONE;
            }
            if pinched(origin[h as usize ^ 1]) {
                next[h as usize] = NONE;
            }
        }
    }

    /// The error for a pinched vertex: one face of each of its fans. O(half-edges).
    pub(super) fn fans_at(&self, v: VertexId) -> BuildError {
        let Columns { origin, prev, face, .. } = &self.columns;
        let mut fan_of = std::collections::BTreeMap::new();
        let mut fans = Vec::new();
        for (h, _) in (0..).zip(origin).filter(|&(_, &at)| at == v.0) {
            // Counter-clockwise from h: to the end of an open fan, round a closed one, or to a known place.
            let mut path = Vec::new();
            let mut at = h;
            let fan = loop {
                if let Some(&fan) = fan_of.get(&at) {
                    break fan;
                }
                path.push(at);
                let before = prev[at as usize];
                at = before ^ 1;
                if before == NONE || at == h {
                    fans.push(NONE);
                    break fans.len() - 1;
                }
            };
            for h in path {
                fan_of.insert(h, fan);
                fans[fan] = face[h as usize].min(fans[fan]);
            }
        }
        let mut fans: Vec<u32> = fans.into_iter().map(|f| f - self.first_face).collect();
        fans.sort_unstable();
        BuildError::NonManifoldVertex { vertex: v.0, fans }
    }

    /// One half-edge of each border cycle, the smallest, in increasing order. There must be no pinched vertex
    /// left. O(border), but for one bit for each edge.
    pub(crate) fn border_cycles(&self) -> Vec<HalfEdgeId> {
        let mut seen = vec![false; self.columns.next.len() / 2];
        let mut cycles = Vec::new();
        for &start in &self.border {
            if seen[start as usize / 2] {
                continue;
            }
            cycles.push(HalfEdgeId(start));
            let mut h = start;
            while !std::mem::replace(&mut seen[h as usize / 2], true) {
                h = self.columns.next[h as usize];
            }
        }
        cycles
    }

    /// Gives the border cycle of `h` the face `face`. O(length of the cycle).
    pub(crate) fn set_border_face(&mut self, h: HalfEdgeId, face: FaceId) {
        let mut at = h.0;
        loop {
            self.columns.face[at as usize] = face.0;
            at = self.columns.next[at as usize];
            if at == h.0 {
                break;
            }
        }
    }

    /// Gives the border cycle of `h` a new face.
    pub(crate) fn add_border_face(&mut self, h: HalfEdgeId) -> Result<FaceId, TooMany> {
        let face = FaceId(self.columns.boundary.len() as u32);
        if face.index() >= MAX_IDS {
            return Err(TooMany);
        }
        self.columns.boundary.push(h.0);
        self.set_border_face(h, face);
        Ok(face)
    }
}

/// For each vertex that occurs, its half-edge in the first face that uses it, in increasing order. That is its
/// smallest even half-edge: when a vertex is new, so are its edges.
fn first_half_edges(origin: &[u32], vertices: usize) -> Vec<u32> {
    let mut seen = vec![false; vertices];
    let mut firsts = vec![0; vertices + 1];
    let mut count = 0;
    for (h, &v) in (0..).zip(origin).step_by(2) {
        firsts[count] = h;
        count += usize::from(!std::mem::replace(&mut seen[v as usize], true));
    }
    firsts.truncate(count);
    firsts
}

/// How many half-edges a walk round the origin of `h` meets.
fn star_length(prev: &[u32], h: u32) -> usize {
    let mut at = h;
    let mut length = 0;
    loop {
        length += 1;
        at = prev[at as usize] ^ 1;
        if at == h {
            return length;
        }
    }
}

/// How many half-edges walks round the origins of all `firsts` meet.
///
/// Several walks are under way at a time: each waits for memory at each step, and together they wait less.
fn stars_length(prev: &[u32], firsts: &[u32]) -> usize {
    const WALKS: usize = 16;
    let Some((&starts, rest)) = firsts.split_first_chunk::<WALKS>() else {
        return firsts.iter().map(|&h| star_length(prev, h)).sum();
    };
    let (mut first, mut at) = (starts, starts);
    let mut waiting = 0;
    let mut length = 0;
    while waiting + WALKS <= rest.len() {
        for walk in 0..WALKS {
            let h = prev[at[walk] as usize] ^ 1;
            let round = h == first[walk];
            let fresh = rest[waiting];
            at[walk] = if round { fresh } else { h };
            first[walk] = if round { fresh } else { first[walk] };
            waiting += usize::from(round);
        }
        length += WALKS;
    }
    for walk in 0..WALKS {
        // What is left of this walk: `at` has not been counted yet.
        loop {
            length += 1;
            at[walk] = prev[at[walk] as usize] ^ 1;
            if at[walk] == first[walk] {
                break;
            }
        }
    }
    length + rest[waiting..].iter().map(|&h| star_length(prev, h)).sum::<usize>()
}
