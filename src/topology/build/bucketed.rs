//! Matching when the numbers of the input jump about.
//!
//! ```text
//!   u + w:        0 .. 2047          2048 .. 4095        ...      Both halves of an edge have the same sum of
//!   cards:    [(3, 4) (9, 2) ...]  [(7, 2050) ...]                ends, so they come into the same bucket.
//!
//!   cells of a block, four for each sum: every card writes its name into its cell, then looks who stands there.
//!     itself        it came last, and nobody but its twin may have been before it
//!     its twin      a pair
//!     a stranger    both edges wanted this cell: it tries again in the next round, where cells are chosen anew
//! ```
//!
//! Each block fits into the cache. Blocks by the sum, not by one end, are equally large even if a vertex has
//! a million edges. No step depends on a guess of the processor, which in random order is wrong half of the time.
//! Edges that still meet strangers after a few rounds (equal sums and unlucky differences: possible in large
//! numbers, if only by intent) are sorted.
//!
//! Fresh memory costs as much as the work in it, so all large arrays are used again: the cards lie in three
//! pieces, which become columns of the result.

use super::faces::Faces;
use super::{BORDERS, Stop};
use crate::topology::links::{Columns, NONE};
use std::hint::select_unpredictable;
use std::ops::Range;

/// A half-edge on its way to its block: from, to, corner.
type Card = [u32; 3];
/// The memory of the cards. Each piece is as large as a column of half-edges.
type Pieces = [Vec<Card>; 3];

/// Deals the half-edges into blocks, matches each block, gives out the numbers, and writes the columns.
pub(super) fn bucketed<F: Faces + ?Sized>(faces: &F, vertices: usize, first_face: u32) -> Result<Columns, Stop> {
    /// At most so many blocks: the deal writes to all of them in turn, a cache line each.
    const BLOCKS: usize = 512;
    /// Blocks do not get smaller than so many sums.
    const SMALLEST: usize = 1024;
    let sums = 2 * vertices;
    let size = sums.div_ceil(BLOCKS).max(SMALLEST).next_power_of_two();
    let (mut pieces, blocks) = deal(faces, vertices, sums.div_ceil(size), size.trailing_zeros())?;

    let mut matching = Matching::new(size, faces.corners().len());
    for Block { piece, start, end } in blocks {
        matching.block(&mut pieces[piece as usize][start as usize..end as usize])?;
    }
    let [piece, next, prev] = pieces.map(Vec::into_flattened);
    let (half_edge, pairs) = matching.numbers(piece);
    let mut columns = link(faces, first_face, half_edge, pairs, [next, prev]);
    columns.outgoing = outgoing(&columns.origin, vertices);
    Ok(columns)
}

/// Where the cards of a block are.
struct Block {
    piece: u32,
    start: u32,
    end: u32,
}

/// Deals the half-edges, those with the same sum of ends shifted by `shift` into the same block.
fn deal<F: Faces + ?Sized>(
    faces: &F,
    vertices: usize,
    blocks: usize,
    shift: u32,
) -> Result<(Pieces, Vec<Block>), Stop> {
    let block_of = |from: u32, to: u32| ((from + to) >> shift) as usize;
    let count = faces.corners().len();
    let mut sizes = vec![0_u32; blocks];
    faces.try_for_each_half_edge(|_, from, to| {
        // There is a block for the sum of two vertices only.
        if from == to || from.max(to) as usize >= vertices {
            return Err(Stop::Ends);
        }
        sizes[block_of(from, to)] += 1;
        Ok(())
    })?;

    let mut lengths = [0; 3];
    let mut placed = 0;
    let mut blocks: Vec<Block> = Vec::with_capacity(sizes.len());
    for size in sizes {
        let piece = (3 * placed / count.max(1)).min(2);
        let start = lengths[piece];
        blocks.push(Block { piece: piece as u32, start, end: start });
        lengths[piece] += size;
        placed += size as usize;
    }
    // Room for the border, too, when a piece has become a column.
    let column = (count + count / 8) / 3;
    let mut pieces = lengths.map(|length| vec![[0; 3]; column.max(length as usize)]);
    let [a, b, c] = &mut pieces;
    let mut targets = [&mut a[..], b, c, &mut []];
    faces.for_each_half_edge(|corner, from, to| {
        let Block { piece, end, .. } = &mut blocks[block_of(from, to)];
        targets[(*piece & 3) as usize][*end as usize] = [from, to, corner];
        *end += 1;
    });
    Ok((pieces, blocks))
}

/// Matches one block after another.
struct Matching {
    /// By corner: the corner of the twin.
    mates: Vec<u32>,
    /// How many edges have both halves.
    matched: usize,
    /// By sum and a part of the difference of the ends: corner and `from` of the card that came last.
    cells: Vec<[u32; 2]>,
    /// The pairs of corners found in this block.
    pairs: Vec<[u32; 2]>,
    /// The places of the cards that met strangers.
    strangers: Vec<u32>,
}

impl Matching {
    /// The number of cells of a sum is two to this power.
    const SPREAD: u32 = 2;

    fn new(size: usize, corners: usize) -> Self {
        let cells = vec![[0; 2]; size << Self::SPREAD];
        Self { mates: vec![NONE; corners], matched: 0, cells, pairs: Vec::new(), strangers: Vec::new() }
    }

    /// Matches the half-edges of one block, given in the order of their corners.
    fn block(&mut self, cards: &mut [Card]) -> Result<(), Stop> {
        /// So few are sorted at once.
        const FEW: usize = 16;
        const ROUNDS: u32 = 6;
        if self.strangers.len() <= cards.len() {
            self.strangers.resize(cards.len() + 1, 0);
            self.pairs.resize(cards.len() + 1, [0; 2]);
        }
        let mut found = 0;
        let mut left = cards.len();
        for round in 0..ROUNDS {
            if left > FEW {
                (left, found) = self.round(round, &mut cards[..left], found)?;
            }
        }
        found = self.sort(&mut cards[..left], found)?;
        let mut clash = false;
        for &[first, second] in &self.pairs[..found] {
            self.mates[first as usize] = second;
            // Two half-edges that fit the same third one have both been paired with it.
            clash |= std::mem::replace(&mut self.mates[second as usize], first) != NONE;
        }
        self.matched += found;
        if clash { Err(Stop::Clash) } else { Ok(()) }
    }

    /// Sends all cards to their cells and compares each with the one that came last. Adds the pairs to the `found`
    /// that are there, and brings those that met strangers to the front. Returns how many there are of both.
    fn round(&mut self, round: u32, cards: &mut [Card], found: usize) -> Result<(usize, usize), Stop> {
        let cells = &mut self.cells[..];
        let mask = cells.len() - 1;
        let shift = 32 - Self::SPREAD * (round + 1);
        let cell = |from: u32, to: u32| {
            let bits = from.abs_diff(to).wrapping_mul(0x9e37_79b9) >> shift & ((1 << Self::SPREAD) - 1);
            (((from + to) << Self::SPREAD) | bits) as usize & mask
        };
        for &[from, to, corner] in cards.iter() {
            cells[cell(from, to)] = [corner, from];
        }
        let pairs = &mut self.pairs[found..];
        let strangers = &mut self.strangers[..];
        let (mut new, mut left, mut clash) = (0, 0, 0);
        for (place, &[from, to, corner]) in (0..).zip(cards.iter()) {
            let [last, start] = cells[cell(from, to)];
            // All cards of a cell have the same sum of ends: one end says which edge it is.
            let (twin, same) = (start == to, start == from);
            clash |= u32::from(same).wrapping_neg() & (last ^ corner);
            pairs[new] = [corner, last];
            new += usize::from(twin);
            strangers[left] = place;
            left += usize::from(!twin & !same);
        }
        for (to, &from) in strangers[..left].iter().enumerate() {
            cards[to] = cards[from as usize];
        }
        if clash == 0 { Ok((left, found + new)) } else { Err(Stop::Clash) }
    }

    /// Finds the pairs by sorting, adds them to the `found` that are there, and returns how many there are.
    fn sort(&mut self, cards: &mut [Card], mut found: usize) -> Result<usize, Stop> {
        let ends = |&[u, v, _]: &Card| (u.min(v), u.max(v));
        cards.sort_unstable_by_key(|card| (ends(card), card[2]));
        for edge in cards.chunk_by(|a, b| ends(a) == ends(b)) {
            match *edge {
                [_] => {}
                [[from, _, first], [_, to, second]] if from == to => {
                    self.pairs[found] = [first, second];
                    found += 1;
                }
                _ => return Err(Stop::Clash),
            }
        }
        Ok(found)
    }

    /// Gives out the numbers: edges in the order in which the corners first meet them, the half met first even.
    ///
    /// Returns by corner its half-edge, and by edge the corners of its even and its odd half, one after the other
    /// in the given memory; `NONE` if no face has the odd one.
    fn numbers(self, mut pairs: Vec<u32>) -> (Vec<u32>, Vec<u32>) {
        let mut half_edge = self.mates;
        let edges = half_edge.len() - self.matched;
        if pairs.len() < 2 * edges + 2 {
            pairs.resize(2 * edges + 2, NONE);
        }
        let mut edge = 0;
        for corner in 0..half_edge.len() {
            let mate = half_edge[corner];
            let new = mate as usize > corner;
            // The first half has its number already.
            let known = half_edge[select_unpredictable(new, corner, mate as usize)];
            half_edge[corner] = select_unpredictable(new, 2 * edge as u32, known.wrapping_add(1));
            pairs[2 * edge] = corner as u32;
            pairs[2 * edge + 1] = mate;
            edge += usize::from(new);
        }
        pairs.truncate(2 * edges);
        (half_edge, pairs)
    }
}

/// Writes the columns of half-edges, edge by edge: what it needs of a half-edge stands together at its corner,
/// so that an edge touches two places, wherever its faces are.
fn link<F: Faces + ?Sized>(
    faces: &F,
    first_face: u32,
    half_edge: Vec<u32>,
    pairs: Vec<u32>,
    memory: [Vec<u32>; 2],
) -> Columns {
    /// Edges written at a time, so that the columns grow by slices.
    const BATCH: usize = 64;
    const AHEAD: usize = 1 << 14;
    let around = faces.around();
    let corners = faces.corners();
    let [next, prev] = memory;
    let [mut next, mut prev, mut face] = [next, prev, Vec::new()].map(|mut column| {
        column.clear();
        column.reserve_exact(pairs.len());
        column
    });
    // The corners of an edge stand where the origins of its halves will stand.
    let mut origin = pairs;
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
    let boundary = boundaries(faces, first_face, half_edge);
    Columns { origin, next, prev, face, outgoing: Vec::new(), boundary }
}

/// By vertex: the smallest even half-edge that starts there. That is the one in the first face that uses the vertex: where a
/// vertex is new, so are its edges.
fn outgoing(origin: &[u32], vertices: usize) -> Vec<u32> {
    let mut outgoing = vec![NONE; vertices];
    for (h, &v) in (0..).zip(origin).step_by(2) {
        let word = &mut outgoing[v as usize];
        *word = h.min(*word);
    }
    outgoing
}

/// The first half-edge of the first cycle of each face, in the memory of the half-edges by corner.
fn boundaries<F: Faces + ?Sized>(faces: &F, first_face: u32, half_edge: Vec<u32>) -> Vec<u32> {
    let mut boundary = half_edge;
    let mut corner = 0;
    let _ = faces.try_for_each_cycle::<()>(|face, cycle, corners| {
        if cycle == 0 {
            // A face has at least three corners, so what is overwritten has been read.
            boundary[face as usize] = boundary[corner];
        }
        corner += corners.len();
        Ok(())
    });
    boundary.truncate(faces.face_count());
    boundary.splice(0..0, std::iter::repeat_n(NONE, first_face as usize));
    boundary.shrink_to(boundary.len() + BORDERS);
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
    use super::{Columns, bucketed};
    use crate::geometry::random::xorshift;

    /// The grid of the seed: some faces missing, names and order mixed up, sometimes a face reversed or one too many.
    fn grid(seed: u64) -> Vec<[u32; 3]> {
        let mut random = xorshift(seed);
        let mut below = move |bound: usize| (random() >> 33) as usize % bound;
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
        match below(8) {
            0 => faces[i].swap(0, 1),
            1 => faces.push([b, a, names[0]]),
            2 => faces[i][below(3)] = 41 * 41,
            3 => faces[i][1] = a,
            _ => {}
        }
        faces
    }

    #[test]
    fn both_ways_of_matching_give_the_same_numbers() {
        let (mut good, mut bad, mut unfit) = (0, 0, 0);
        for seed in 1..200 {
            let faces = grid(seed);
            match (streamed(&faces[..], 41 * 41, 1), bucketed(&faces[..], 41 * 41, 1)) {
                (Ok(a), Ok(b)) => {
                    let parts = |c: Columns| (c.origin, c.next, c.prev, c.face, c.outgoing, c.boundary);
                    assert!(parts(a) == parts(b), "seed {seed}");
                    good += 1;
                }
                (Err(Stop::Clash), Err(Stop::Clash)) => bad += 1,
                (Err(Stop::Ends), Err(Stop::Ends)) => unfit += 1,
                (a, b) => panic!("seed {seed}: streamed {}, bucketed {}", a.is_ok(), b.is_ok()),
            }
        }
        assert!(good > 50 && bad > 20 && unfit > 20, "{good} good, {bad} bad, {unfit} with bad ends");
    }
}
