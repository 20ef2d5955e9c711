//! Which corners are the two halves of one edge.
//!
//! ```text
//!   u + w     edges met so far, by the sum of their ends
//!    ...
//!     7    -> e9 (3, 4) -> e2 (2, 5)      A half-edge (4, 3) looks in list 7, passes e2 and finds its twin e9.
//!     8    -> e5 (1, 7)                   A second (3, 4) finds e9, too: a clash.
//!    ...
//! ```
//!
//! Both halves of an edge have the same sum of ends, so they meet in the same list. Lists are short (three
//! half-edges of a triangulation to a sum, on average), and faces that are near each other in the input
//! have near sums when their vertices have near numbers: then the lists in use stay in the cache. Nothing is
//! hashed. There are two ways to use the lists, with the same answer:
//!
//! - [`Streamed`]: one set of lists for everything, looked up while the half-edges are being written.
//! - [`Dealt`]: when the numbers jump about, half-edges are first dealt into blocks of neighbouring sums,
//!   block after block is matched in the cache, and the answers wait in a table.
//!
//! No list is searched deeper than [`DEEPEST`]. When one grows longer (many edges with one sum: possible, if
//! only by intent), the block is sorted instead.

use super::faces::Faces;
use crate::topology::links::{NONE, TAG};

/// Searching a list gives up after so many edges.
const DEEPEST: usize = 64;
/// At most so many blocks: the deal writes to all of them in turn, a cache line each.
const BLOCKS: usize = 512;
/// Blocks do not get smaller than so many sums.
const SMALLEST_BLOCK: usize = 2048;

/// Why matching stopped.
pub(super) enum Stop {
    /// Two half-edges run in the same direction between the same vertices, or three share an edge.
    Clash,
    /// A list is too long to be searched.
    LongList,
}

/// Gives half-edges their numbers, in the order of the corners.
pub(super) trait Twins {
    /// How many half-edges there may be at least: a hint for the memory to reserve.
    fn half_edges(&self) -> usize;

    /// The half-edge of corner `corner`, which runs `from` one vertex `to` another; `new` is the next even
    /// number, to be taken if the edge has not been met before. `origin` are the origins so far.
    fn half_edge(&mut self, corner: usize, from: u32, to: u32, new: u32, origin: &[u32]) -> Result<u32, Stop>;
}

/// Looks twins up in the lists, as the half-edges come.
pub(super) struct Streamed {
    /// The edge met last for each sum of ends.
    heads: Vec<u32>,
    /// By edge: the edge met before it with the same sum; tagged once both halves are there.
    links: Vec<u32>,
    corners: usize,
}

impl Streamed {
    pub(super) fn new(vertices: usize, corners: usize) -> Self {
        Self {
            heads: vec![NONE & !TAG; 2 * vertices],
            links: Vec::with_capacity(corners / 2 + corners / 16 + 16),
            corners,
        }
    }
}

impl Twins for Streamed {
    fn half_edges(&self) -> usize {
        self.corners + self.corners / 8
    }

    #[inline(always)]
    fn half_edge(&mut self, _: usize, from: u32, to: u32, new: u32, origin: &[u32]) -> Result<u32, Stop> {
        const END: u32 = NONE & !TAG;
        let head = &mut self.heads[(from + to) as usize];
        let mut edge = *head;
        let mut depth = 0;
        while edge != END {
            let link = self.links[edge as usize];
            let start = origin[2 * edge as usize];
            if start == to && link & TAG == 0 {
                self.links[edge as usize] = link | TAG;
                return Ok(2 * edge + 1);
            }
            if start == to || start == from {
                return Err(Stop::Clash);
            }
            depth += 1;
            if depth > DEEPEST {
                return Err(Stop::LongList);
            }
            edge = link & !TAG;
        }
        self.links.push(*head);
        *head = new / 2;
        Ok(new)
    }
}

/// Knows the twins beforehand.
pub(super) struct Dealt {
    /// By corner: the corner of the twin, at the first of the two; later, tagged, the number of the half-edge.
    mates: Vec<u32>,
    half_edges: usize,
}

impl Twins for Dealt {
    fn half_edges(&self) -> usize {
        self.half_edges
    }

    #[inline(always)]
    fn half_edge(&mut self, corner: usize, _: u32, _: u32, new: u32, _: &[u32]) -> Result<u32, Stop> {
        let word = self.mates[corner];
        if word & TAG == 0 {
            self.mates[word as usize] = TAG | (new + 1);
            return Ok(new);
        }
        Ok(if word == NONE { new } else { word & !TAG })
    }
}

/// A half-edge on its way to its block.
#[derive(Clone, Copy, Default)]
struct Card {
    from: u32,
    to: u32,
    corner: u32,
}

impl Dealt {
    /// Matches all half-edges, block by block. The time is linear; blocks with too long lists are sorted.
    pub(super) fn new<F: Faces + ?Sized>(faces: &F, vertices: usize) -> Result<Self, Stop> {
        let corners = faces.corners().len();
        let sums = 2 * vertices;
        let size = sums.div_ceil(BLOCKS).max(SMALLEST_BLOCK).next_power_of_two();
        let shift = size.trailing_zeros();

        let mut ends = vec![0_u32; sums.div_ceil(size) + 1];
        each_card(faces, |card| ends[((card.from + card.to) >> shift) as usize + 1] += 1);
        for block in 1..ends.len() {
            ends[block] += ends[block - 1];
        }
        let mut cards = vec![Card::default(); corners];
        each_card(faces, |card| {
            let place = &mut ends[((card.from + card.to) >> shift) as usize];
            cards[*place as usize] = card;
            *place += 1;
        });

        let mut block = Block { mates: vec![NONE; corners], heads: vec![NONE; size], links: Vec::new(), pairs: 0 };
        let mut start = 0;
        for &end in &ends[..ends.len() - 1] {
            let cards = &mut cards[start..end as usize];
            match block.search(cards, size as u32 - 1) {
                Ok(()) => {}
                Err(Stop::LongList) => block.sort(cards)?,
                Err(Stop::Clash) => return Err(Stop::Clash),
            }
            start = end as usize;
        }
        Ok(Self { mates: block.mates, half_edges: 2 * (corners - block.pairs) })
    }
}

#[inline(always)]
fn each_card<F: Faces + ?Sized>(faces: &F, mut visit: impl FnMut(Card)) {
    let mut corner = 0;
    let _ = faces.try_for_each_cycle::<()>(|_, _, corners| {
        for (k, &from) in corners.iter().enumerate() {
            let to = if k + 1 < corners.len() { corners[k + 1] } else { corners[0] };
            visit(Card { from, to, corner });
            corner += 1;
        }
        Ok(())
    });
}

/// The memory to match one block after another.
struct Block {
    mates: Vec<u32>,
    heads: Vec<u32>,
    links: Vec<u32>,
    pairs: usize,
}

impl Block {
    fn search(&mut self, cards: &[Card], mask: u32) -> Result<(), Stop> {
        const END: u32 = NONE & !TAG;
        self.heads.fill(END);
        self.links.clear();
        self.links.resize(cards.len(), END);
        let pairs = self.pairs;
        'cards: for (place, card) in cards.iter().enumerate() {
            let head = &mut self.heads[((card.from + card.to) & mask) as usize];
            let mut at = *head;
            let mut depth = 0;
            while at != END {
                let other = cards[at as usize];
                let link = self.links[at as usize];
                if other.from == card.to && link & TAG == 0 {
                    self.links[at as usize] = link | TAG;
                    self.mates[other.corner as usize] = card.corner;
                    self.pairs += 1;
                    continue 'cards;
                }
                if other.from == card.to || other.from == card.from {
                    return Err(Stop::Clash);
                }
                depth += 1;
                if depth > DEEPEST {
                    self.pairs = pairs;
                    return Err(Stop::LongList);
                }
                at = link & !TAG;
            }
            self.links[place] = *head;
            *head = place as u32;
        }
        Ok(())
    }

    fn sort(&mut self, cards: &mut [Card]) -> Result<(), Stop> {
        cards.sort_unstable_by_key(|c| (c.from.min(c.to), c.from.max(c.to), c.corner));
        for run in cards.chunk_by(|a, b| a.from.min(a.to) == b.from.min(b.to) && a.from.max(a.to) == b.from.max(b.to)) {
            match run {
                [_] => {}
                [first, second] if first.from == second.to => {
                    self.mates[first.corner as usize] = second.corner;
                    self.pairs += 1;
                }
                _ => return Err(Stop::Clash),
            }
        }
        Ok(())
    }
}

/// Whether faces that follow each other use vertices with near numbers, judged by a thousand places of the
/// input. O(1).
pub(super) fn is_local<F: Faces + ?Sized>(faces: &F) -> bool {
    const SAMPLES: usize = 1024;
    const NEAR: u32 = 8192;
    let corners = faces.corners();
    let step = (corners.len() / SAMPLES).max(1);
    let pairs = || corners.windows(2).step_by(step);
    let near = pairs().filter(|pair| pair[0].abs_diff(pair[1]) < NEAR).count();
    4 * near >= 3 * pairs().count()
}
