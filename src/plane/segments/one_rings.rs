//! Half-edges linked one-ring by one-ring, and what the corners between them say of the cycles that pass there.
//!
//! ```text
//!      h1 ━━━●         Each corner is a link: next(twin(h0)) = h1. From left to right what lies in a corner between two
//!           ╱          half-edges to the left ends there.
//!       h0 ╱
//!             ╱ h1     Where no half-edge runs to the left, what lies on that side comes to a fork there: a tip.
//!            ●━━━ h0
//! ```

use super::graph::Graph;
use crate::ids::MAX_IDS;
use crate::plane::sweep::OneRing;
use crate::topology::{Columns, TooMany};

/// The half-edges of a graph with their origins; the links come one-ring by one-ring. In the place of its face, each half-edge
/// says what becomes of the corner behind it; see [`turn`].
pub(super) struct OneRings {
    columns: Columns,
    /// The vertices with no half-edge to the left.
    tips: Vec<u32>,
}

/// In the place of a face: what lies in the corner behind the half-edge ends there from left to right, or comes to a fork. At
/// all other corners there is `NONE`.
const ENDS: u32 = Columns::NONE - 1;
const FORKS: u32 = Columns::NONE - 2;

/// Whether a word of the column of faces stands for no face yet.
#[inline]
pub(super) fn has_no_face(word: u32) -> bool {
    word >= FORKS
}

/// How much a corner adds to the turns of its cycle, counter-clockwise: one where the cycle turns to the left from right to
/// left, one less where it turns to the right from left to right.
#[inline]
pub(super) fn turn(word: u32) -> i32 {
    i32::from(word == ENDS) - i32::from(word == FORKS)
}

impl OneRings {
    /// No link yet.
    ///
    /// # Errors
    /// [`TooMany`] if the vertices or half-edges have no ids.
    pub(super) fn new(graph: &Graph) -> Result<Self, TooMany> {
        let Graph { points, edges, .. } = graph;
        if points.len() > MAX_IDS || 2 * edges.len() > MAX_IDS {
            return Err(TooMany);
        }
        const NONE: u32 = Columns::NONE;
        let origin: Vec<u32> = edges.as_flattened().to_vec();
        let columns = Columns {
            next: vec![NONE; origin.len()],
            prev: vec![NONE; origin.len()],
            face: vec![NONE; origin.len()],
            outgoing: vec![NONE; points.len()],
            boundary: vec![NONE],
            origin,
        };
        Ok(Self { columns, tips: Vec::new() })
    }

    /// Links a one-ring. Counter-clockwise from straight down it begins with the half-edges to the right, upwards; then
    /// come those to the left, downwards.
    #[inline]
    pub(super) fn link(&mut self, one_ring: &OneRing<'_>) {
        let half_edges = one_ring.right.iter().chain(one_ring.left.iter().rev()).copied();
        self.link_all(one_ring.point, half_edges, one_ring.right.len());
    }

    /// Links the half-edges that leave a point, counter-clockwise from straight down; so many of them run to the right.
    #[inline]
    pub(super) fn link_all(&mut self, point: u32, half_edges: impl Iterator<Item = u32>, to_the_right: usize) {
        let mut last = None;
        let mut count = 0;
        for h in half_edges {
            match last.replace(h) {
                None => self.columns.outgoing[point as usize] = h,
                Some(before) => {
                    self.meet(before, h);
                    if count > to_the_right {
                        self.columns.face[(h ^ 1) as usize] = ENDS;
                    }
                }
            }
            count += 1;
        }
        if let Some(last) = last {
            let first = self.columns.outgoing[point as usize];
            self.meet(last, first);
            if count == to_the_right {
                self.columns.face[(first ^ 1) as usize] = FORKS;
                self.tips.push(point);
            }
        }
    }

    /// The half-edges with their links, but for their faces, and the vertices with no half-edge to the left.
    pub(super) fn into_parts(self) -> (Columns, Vec<u32>) {
        (self.columns, self.tips)
    }

    /// Of two half-edges of a one-ring the second follows the first, counter-clockwise.
    #[inline]
    fn meet(&mut self, g: u32, h: u32) {
        self.columns.next[(h ^ 1) as usize] = g;
        self.columns.prev[g as usize] = h ^ 1;
    }
}
