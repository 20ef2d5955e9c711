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

use super::faces::Faces;
use super::matching::{DEEPEST, END, Numbers, Stop, read_ahead};
use crate::topology::links::{NONE, TAG};

/// A half-edge on its way to its block: from, to, corner.
type Card = [u32; 3];

/// Deals the half-edges into blocks, matches each block, and then gives out the numbers.
pub(super) fn dealt<F: Faces + ?Sized>(faces: &F, vertices: usize) -> Result<Numbers, Stop> {
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
    Ok(table.numbers(cards))
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
        let matched = match self.search(cards) {
            Err(Stop::LongList) => self.sort(cards)?,
            done => done?,
        };
        for &[first, second] in &self.pairs[..matched] {
            self.mates[first as usize] = second;
        }
        self.matched += matched;
        Ok(())
    }

    /// Finds the pairs with lists, and returns how many there are.
    ///
    /// Whether an edge is met for the first or the second time is as good as random, so the usual cases, an
    /// empty list and a twin in front, are handled without a branch between them.
    fn search(&mut self, cards: &[Card]) -> Result<usize, Stop> {
        self.heads.fill(END);
        self.links.clear();
        self.links.resize(cards.len(), END);
        self.pairs.clear();
        self.pairs.resize(cards.len() + 1, [NONE; 2]);
        let mask = self.heads.len() - 1;
        let mut matched = 0;
        for (place, &[u, v, corner]) in (0..).zip(cards) {
            let list = (u + v).wrapping_mul(Self::SPREAD) + (u.abs_diff(v) >> 1) % Self::SPREAD;
            let head = &mut self.heads[list as usize & mask];
            let empty = *head == END;
            let at = if empty { place } else { *head };
            let link = self.links[at as usize];
            let [start, _, first] = cards[at as usize];
            let twin = (start == v) & (link & TAG == 0);
            if empty | twin {
                *head = at;
                self.links[at as usize] = link | u32::from(twin) << 31;
                self.pairs[matched] = [first, corner];
                matched += usize::from(twin);
            } else if let Some(first) = deep_search(cards, &mut self.links, at, u, v)? {
                self.pairs[matched] = [first, corner];
                matched += 1;
            } else {
                self.links[place as usize] = *head;
                *head = place;
            }
        }
        Ok(matched)
    }

    /// Finds the pairs by sorting, and returns how many there are.
    fn sort(&mut self, cards: &[Card]) -> Result<usize, Stop> {
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
        Ok(self.pairs.len())
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

/// Searches a whole list for the twin of the half-edge from `u` to `v`, and returns its corner.
fn deep_search(cards: &[Card], links: &mut [u32], mut at: u32, u: u32, v: u32) -> Result<Option<u32>, Stop> {
    for _ in 0..DEEPEST {
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
        if at == END {
            return Ok(None);
        }
    }
    Err(Stop::LongList)
}

#[cfg(test)]
mod tests {
    use super::super::matching::{Numbers, Stop, streamed};
    use super::dealt;

    /// The grid of the seed: some faces missing, names and order mixed up, sometimes one face reversed.
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
        if below(4) == 0 {
            let i = below(faces.len());
            faces[i].swap(0, 1);
        }
        faces
    }

    #[test]
    fn both_ways_of_matching_give_the_same_numbers() {
        let (mut good, mut bad) = (0, 0);
        for seed in 1..200 {
            let faces = grid(seed);
            match (streamed(&faces[..], 41 * 41), dealt(&faces[..], 41 * 41)) {
                (Ok(a), Ok(b)) => {
                    let parts = |n: Numbers| (n.half_edge, n.corners);
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
