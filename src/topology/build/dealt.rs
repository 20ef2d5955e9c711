//! Matching when the numbers of the input jump about.
//!
//! ```text
//!   u + w:        0 .. 2047          2048 .. 4095        ...      Both halves of an edge have the same sum of
//!   cards:    [(3, 4) (9, 2) ...]  [(7, 2050) ...]                ends, so they are dealt into the same block.
//! ```
//!
//! Each block fits into the cache and is matched there with lists, a few for each sum. Blocks by the sum, not
//! by one end, are equally large even if a vertex has a million edges. A list may still grow long (edges with
//! one sum and the same difference modulo eight: possible, if only by intent); then the block is sorted.

use super::Stop;
use super::faces::Faces;
use crate::topology::links::{Columns, NONE, TAG};
use std::ops::Range;

/// Searching a list gives up after so many edges.
const DEEPEST: usize = 64;
/// Ends a list. Links are tagged once both halves of their edge have been met, so the end must bear a tag.
const END: u32 = NONE & !TAG;

/// A half-edge on its way to its block: from, to, corner.
type Card = [u32; 3];

/// The numbers of the half-edges: edges in the order in which the corners first meet them, the half met first
/// even.
struct Numbers {
    /// By corner: its half-edge.
    half_edge: Vec<u32>,
    /// By edge: the corners of its even and its odd half; `NONE` if no face has the odd one.
    corners: Vec<[u32; 2]>,
    /// Memory that was needed on the way, to be used again.
    spare: [Vec<u32>; 3],
}

/// Deals the half-edges into blocks, matches each block, gives out the numbers, and writes the half-edges. The
/// column of vertices stays empty.
pub(super) fn dealt<F: Faces + ?Sized>(faces: &F, vertices: usize, first_face: u32) -> Result<Columns, Stop> {
    /// At most so many blocks: the deal writes to all of them in turn, a cache line each.
    const BLOCKS: usize = 512;
    /// Blocks do not get smaller than so many sums.
    const SMALLEST: usize = 1024;
    let count = faces.corners().len();
    let sums = 2 * vertices;
    let size = sums.div_ceil(BLOCKS).max(SMALLEST).next_power_of_two();
    let block_of = |from: u32, to: u32| ((from + to) >> size.trailing_zeros()) as usize;

    let mut ends = vec![0_u32; sums.div_ceil(size) + 1];
    faces.for_each_half_edge(|_, from, to| ends[block_of(from, to) + 1] += 1);
    for block in 1..ends.len() {
        ends[block] += ends[block - 1];
    }
    let mut cards = vec![[0; 3]; count];
    faces.for_each_half_edge(|corner, from, to| {
        let end = &mut ends[block_of(from, to)];
        cards[*end as usize] = [from, to, corner];
        *end += 1;
    });

    let mut table = Table::new(size, count);
    let mut start = 0;
    for &end in &ends[..ends.len() - 1] {
        let cards = &cards[start..end as usize];
        table.block(cards)?;
        start = end as usize;
    }
    Ok(link(faces, first_face, table.numbers(cards)))
}

/// Matches one block after another.
struct Table {
    /// By corner: the corner of the twin, at the first of the two.
    mates: Vec<u32>,
    /// How many edges have both halves.
    matched: usize,
    /// By sum and difference of the ends: the card met last.
    heads: Vec<u32>,
    /// By card of this block: the card before it in its list; tagged once its twin is there.
    links: Vec<u32>,
    /// The pairs of corners found in this block.
    pairs: Vec<[u32; 2]>,
}

impl Table {
    /// Each sum has so many lists, for differences of the ends: nearly all lists have one edge then.
    const SPREAD: u32 = 4;

    fn new(size: usize, corners: usize) -> Self {
        let mut mates = Vec::with_capacity(corners + corners / 16);
        mates.resize(corners, NONE);
        let heads = vec![END; size * Self::SPREAD as usize];
        Self { mates, matched: 0, heads, links: Vec::new(), pairs: Vec::new() }
    }

    /// Matches the half-edges of one block, given in the order of their corners.
    fn block(&mut self, cards: &[Card]) -> Result<(), Stop> {
        match self.search(cards) {
            Err(Stop::LongList) => self.sort(cards)?,
            done => done?,
        }
        for &[first, second] in &self.pairs {
            self.mates[first as usize] = second;
        }
        self.matched += self.pairs.len();
        Ok(())
    }

    /// Finds the pairs with lists.
    fn search(&mut self, cards: &[Card]) -> Result<(), Stop> {
        self.heads.fill(END);
        self.links.clear();
        self.links.resize(cards.len(), END);
        self.pairs.clear();
        let mask = self.heads.len() - 1;
        for (place, card) in (0..).zip(cards) {
            let &[u, v, corner] = card;
            let list = (u + v).wrapping_mul(Self::SPREAD) + (u.abs_diff(v) >> 1) % Self::SPREAD;
            let head = &mut self.heads[list as usize & mask];
            if let Some(first) = take_twin(cards, &mut self.links, *head, card)? {
                self.pairs.push([first, corner]);
            } else {
                self.links[place as usize] = *head;
                *head = place;
            }
        }
        Ok(())
    }

    /// Finds the pairs by sorting.
    fn sort(&mut self, cards: &[Card]) -> Result<(), Stop> {
        let ends = |&[u, v, _]: &Card| (u.min(v), u.max(v));
        let mut cards = cards.to_vec();
        cards.sort_unstable_by_key(|card| (ends(card), card[2]));
        self.pairs.clear();
        for edge in cards.chunk_by(|a, b| ends(a) == ends(b)) {
            match *edge {
                [_] => {}
                [[from, _, first], [_, to, second]] if from == to => self.pairs.push([first, second]),
                _ => return Err(Stop::Clash),
            }
        }
        Ok(())
    }

    /// Gives out the numbers in the order of the corners, again without a branch on first or second time.
    fn numbers(self, cards: Vec<Card>) -> Numbers {
        const BATCH: usize = 64;
        const AHEAD: usize = 1 << 14;
        let count = self.mates.len();
        let mut half_edge = cards.into_flattened();
        half_edge.truncate(count);
        half_edge.fill(NONE);
        let mut corners = vec![[NONE; 2]; count - self.matched + 1];
        let mut edge = 0;
        for (corner, &mate) in self.mates.iter().enumerate() {
            let new = half_edge[corner] == NONE;
            let h = if new { 2 * edge as u32 } else { half_edge[corner] };
            corners[edge] = [corner as u32, mate];
            edge += usize::from(new);
            let paired = new & (mate != NONE);
            half_edge[if paired { mate as usize } else { corner }] = h + 1;
            half_edge[corner] = h;
            if corner % BATCH == 0 {
                read_ahead(&half_edge, corner + AHEAD..corner + AHEAD + BATCH);
            }
        }
        corners.truncate(edge);
        Numbers { half_edge, corners, spare: [self.mates, Vec::new(), Vec::new()] }
    }
}

/// Looks for the twin of `card` in the list from `at` on, marks it as taken and returns its corner.
#[inline(always)]
fn take_twin(cards: &[Card], links: &mut [u32], mut at: u32, &[u, v, _]: &Card) -> Result<Option<u32>, Stop> {
    for _ in 0..DEEPEST {
        if at == END {
            return Ok(None);
        }
        let [start, _, corner] = cards[at as usize];
        let link = &mut links[at as usize];
        if start == v && *link & TAG == 0 {
            *link |= TAG;
            return Ok(Some(corner));
        }
        if start == v || start == u {
            return Err(Stop::Clash);
        }
        at = *link & !TAG;
    }
    Err(Stop::LongList)
}

/// Writes the columns of half-edges, edge by edge: what it needs of a half-edge stands together at its corner,
/// so that an edge touches two places, wherever its faces are.
fn link<F: Faces + ?Sized>(faces: &F, first_face: u32, numbers: Numbers) -> Columns {
    /// Edges written at a time, so that the columns grow by slices.
    const BATCH: usize = 64;
    const AHEAD: usize = 1 << 14;
    let Numbers { half_edge, corners: pairs, spare } = numbers;
    let around = faces.around();
    let corners = faces.corners();
    let [mut next, mut prev, mut face] = spare.map(|mut column| {
        column.clear();
        column.reserve_exact(2 * pairs.len());
        column
    });
    // The corners of an edge stand where the origins of its halves will stand.
    let mut origin = pairs.into_flattened();
    let mut read = 0;
    for batch in origin.chunks_mut(2 * BATCH) {
        let ahead = batch[0] as usize + AHEAD;
        read_ahead(&half_edge, read..ahead);
        read = ahead;
        // The same for the other triangles of the batch, all at once.
        std::hint::black_box(
            batch.iter().fold(0, |sum, &corner| sum ^ half_edge.get(corner as usize).map_or(0, |h| *h)),
        );
        let [mut nexts, mut prevs, mut faces] = [[NONE; 2 * BATCH]; 3];
        for (i, pair) in batch.chunks_exact_mut(2).enumerate() {
            let (even, odd) = (pair[0] as usize, pair[1]);
            let here = around(even);
            pair[0] = corners[even];
            pair[1] = corners[here.after];
            faces[2 * i] = first_face + here.face;
            prevs[2 * i] = half_edge[here.before];
            nexts[2 * i] = half_edge[here.after];
            if odd != NONE {
                let there = around(odd as usize);
                faces[2 * i + 1] = first_face + there.face;
                prevs[2 * i + 1] = half_edge[there.before];
                nexts[2 * i + 1] = half_edge[there.after];
            }
        }
        next.extend_from_slice(&nexts[..batch.len()]);
        prev.extend_from_slice(&prevs[..batch.len()]);
        face.extend_from_slice(&faces[..batch.len()]);
    }
    for column in [&mut origin, &mut next, &mut prev, &mut face] {
        column.shrink_to_fit();
    }
    let boundary = boundaries(faces, first_face, &half_edge);
    Columns { origin, next, prev, face, outgoing: Vec::new(), boundary }
}

/// The first half-edge of the first cycle of each face.
fn boundaries<F: Faces + ?Sized>(faces: &F, first_face: u32, half_edge: &[u32]) -> Vec<u32> {
    let mut boundary = vec![NONE; first_face as usize + faces.face_count()];
    let mut corner = 0;
    let _ = faces.try_for_each_cycle::<()>(|face, cycle, corners| {
        if cycle == 0 {
            boundary[(first_face + face) as usize] = half_edge[corner];
        }
        corner += corners.len();
        Ok(())
    });
    boundary
}

/// Reads one word of each cache line of a range, so that they are at hand when they are wanted out of order:
/// the hardware fetches ahead along straight lines only.
#[inline(always)]
fn read_ahead(words: &[u32], range: Range<usize>) {
    const LINE: usize = 16;
    for at in range.step_by(LINE) {
        std::hint::black_box(words.get(at).copied());
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Stop, streamed};
    use super::{Columns, dealt};

    /// The grid of the seed: some faces missing, names and order mixed up, sometimes a face reversed or one too many.
    fn grid(mut seed: u64) -> Vec<[u32; 3]> {
        let mut below = move |bound: usize| {
            seed ^= seed << 13;
            seed ^= seed >> 7;
            seed ^= seed << 17;
            (seed >> 33) as usize % bound
        };
        let mut names: Vec<u32> = (0..41 * 41).collect();
        (1..names.len()).for_each(|i| names.swap(i, below(i + 1)));
        let mut faces = Vec::new();
        for (x, y) in (0..1600).map(|i| (i % 40, i / 40)) {
            let [a, b, c, d] = [(x, y), (x + 1, y), (x + 1, y + 1), (x, y + 1)].map(|(x, y)| names[x + 41 * y]);
            faces.extend([[a, b, c], [a, c, d]].into_iter().filter(|_| below(8) > 0));
        }
        (1..faces.len()).for_each(|i| faces.swap(i, below(i + 1)));
        let i = below(faces.len());
        let [a, b, _] = faces[i];
        match below(6) {
            0 => faces[i].swap(0, 1),
            1 => faces.push([b, a, names[0]]),
            _ => {}
        }
        faces
    }

    #[test]
    fn both_ways_of_matching_give_the_same_numbers() {
        let (mut good, mut bad) = (0, 0);
        for seed in 1..200 {
            let faces = grid(seed);
            match (streamed(&faces[..], 41 * 41, 1), dealt(&faces[..], 41 * 41, 1)) {
                (Ok(a), Ok(b)) => {
                    let parts = |c: Columns| (c.origin, c.next, c.prev, c.face, c.boundary);
                    assert!(parts(a) == parts(b), "seed {seed}");
                    good += 1;
                }
                (Err(Stop::Clash), Err(Stop::Clash)) => bad += 1,
                (a, b) => panic!("seed {seed}: streamed {}, dealt {}", a.is_ok(), b.is_ok()),
            }
        }
        assert!(good > 50 && bad > 20, "{good} good, {bad} bad");
    }
}
