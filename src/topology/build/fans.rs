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
    /// Links the border where it is clear, and finds the pinched vertices.
    pub(super) fn new(columns: Columns, first_face: u32) -> Self {
        let border = border(&columns.face);
        let isolated = columns.outgoing.iter().filter(|&&h| h == NONE).count();
        let mut this = Self { columns, border, pinched: Vec::new(), isolated, first_face };
        let one_gap_each = this.link_border();
        if !one_gap_each || stars_length(&this.columns.prev, &this.columns.outgoing) != this.columns.prev.len() {
            this.find_pinched();
        }
        this
    }

    /// Makes the border half-edge that ends at a vertex and the one that starts there follow each other, where
    /// there is only one. Vertices with several are tagged; returns whether there are none.
    fn link_border(&mut self) -> bool {
        let Columns { origin, next, prev, face, outgoing, .. } = &mut self.columns;
        let mut one_gap_each = true;
        for &h in &self.border {
            let word = &mut outgoing[origin[h as usize] as usize];
            if *word & TAG == 0 && face[*word as usize] != NONE {
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

    /// Compares each one-ring with the degree of its vertex, lists the vertices where they differ or where there
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

/// The half-edges without a face. Most stretches of the column have none, which is quickly seen.
fn border(face: &[u32]) -> Vec<u32> {
    const STRETCH: usize = 256;
    let mut border = Vec::new();
    for (start, stretch) in (0..).step_by(STRETCH).zip(face.chunks(STRETCH)) {
        if stretch.iter().fold(false, |any, &face| any | (face == NONE)) {
            border.extend((start..).zip(stretch).filter(|&(_, &face)| face == NONE).map(|(h, _)| h));
        }
    }
    border
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

/// How many half-edges walks round the origins of all `firsts` meet, those that are `NONE` left out.
///
/// Many walks are under way at a time: each step waits for memory, but none waits for the steps of the others.
fn stars_length(prev: &[u32], mut firsts: &[u32]) -> usize {
    const WALKS: usize = 512;
    // First half-edge, and how far the walk has come.
    let mut walks = [[0; 2]; WALKS];
    let mut going = 0;
    let mut length = 0;
    loop {
        let (fresh, waiting) = firsts.split_at(firsts.len().min(WALKS - going));
        let mut under_way = going;
        for &h in fresh {
            walks[under_way] = [h, h];
            under_way += usize::from(h != NONE);
        }
        firsts = waiting;
        if under_way == 0 && firsts.is_empty() {
            return length;
        }
        length += under_way;
        going = 0;
        for i in 0..under_way {
            let [first, at] = walks[i];
            let at = prev[at as usize] ^ 1;
            walks[going] = [first, at];
            going += usize::from(at != first);
        }
    }
}
