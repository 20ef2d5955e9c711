//! Which half-edge is which, and where pointers lead once the edges that differ are taken out.
//!
//! ```text
//!        │ a                  a.next is b; b is missing in the other file, and is taken out:
//!        v    b               a.next becomes b.twin.next = c on this side, and is c on the other
//!        ● ────────>
//!        │ c
//!        v
//! ```

use super::graph::Matched;
use super::placed::Placed;
use crate::figure::structure::skeleton::{half_edges, mutual_twin};
use crate::ids::HalfEdgeId;
use crate::topology::{IsomorphismOptions, Table, View, isomorphic_with};

/// Structures with at most so many half-edges are compared as a whole where half-edges are parallel.
const SMALL: usize = 10_000;
/// Edges that can be passed at one vertex; a walk that is longer goes round in a circle.
const STEPS: usize = 1000;

/// The half-edges of two tables in pairs.
pub(super) struct Links {
    to_found: Vec<Option<HalfEdgeId>>,
    to_expected: Vec<Option<HalfEdgeId>>,
    vertices: Vec<Option<u32>>,
    extra: Vec<[u32; 2]>,
}

impl Links {
    /// Pairs half-edges with the same ends; where several have the same, by their neighbours. O(n log n).
    pub(super) fn new(expected: &Placed<'_>, found: &Placed<'_>, matched: &Matched) -> Self {
        let mut out = Self {
            to_found: vec![None; expected.table.half_edge_bound()],
            to_expected: vec![None; found.table.half_edge_bound()],
            vertices: matched.to_found.clone(),
            extra: matched.extra.clone(),
        };
        out.extra.sort_unstable();
        let mut mine: Vec<([u32; 2], HalfEdgeId)> =
            half_edges(expected.table).filter_map(|h| Some((expected.ends(h)?, h))).collect();
        let translated = |g: HalfEdgeId| {
            let [a, b] = found.ends(g)?.map(|v| matched.to_expected[v as usize]);
            Some(([a?, b?], g))
        };
        let mut theirs: Vec<([u32; 2], HalfEdgeId)> = half_edges(found.table).filter_map(translated).collect();
        mine.sort_unstable();
        theirs.sort_unstable();
        let mut groups = Vec::new();
        let (mut i, mut j) = (0, 0);
        while i < mine.len() && j < theirs.len() {
            let key = mine[i].0.min(theirs[j].0);
            let length = |list: &[([u32; 2], HalfEdgeId)]| list.iter().take_while(|(ends, _)| *ends == key).count();
            let (m, n) = (length(&mine[i..]), length(&theirs[j..]));
            if m == 1 && n == 1 {
                out.pair(mine[i].1, theirs[j].1);
            } else if m > 0 && n > 0 {
                groups.push((i..i + m, j..j + n));
            }
            (i, j) = (i + m, j + n);
        }
        if !groups.is_empty() {
            let seeds = half_edges(expected.table).filter_map(|h| Some((h, out.found(h)?))).collect();
            out.spread(expected.table, found.table, seeds, &mine, &theirs);
            let is_open = |h: &HalfEdgeId| out.found(*h).is_none();
            if groups.iter().any(|(m, _)| mine[m.clone()].iter().any(|(_, h)| is_open(h))) {
                out.guess(expected, found, matched, &groups, &mine, &theirs);
            }
        }
        out
    }

    fn pair(&mut self, h: HalfEdgeId, g: HalfEdgeId) {
        self.to_found[h.index()] = Some(g);
        self.to_expected[g.index()] = Some(h);
    }

    /// Follows twin, next and prev from pairs to further pairs with the same ends.
    fn spread(
        &mut self,
        expected: &Table,
        found: &Table,
        mut queue: Vec<(HalfEdgeId, HalfEdgeId)>,
        mine: &[([u32; 2], HalfEdgeId)],
        theirs: &[([u32; 2], HalfEdgeId)],
    ) {
        let ends = |list: &[([u32; 2], HalfEdgeId)], bound: usize| {
            let mut out = vec![None; bound];
            list.iter().for_each(|&(ends, h)| out[h.index()] = Some(ends));
            out
        };
        let (mine, theirs) = (ends(mine, self.to_found.len()), ends(theirs, self.to_expected.len()));
        while let Some((h, g)) = queue.pop() {
            let steps = [
                (expected.twin(h), found.twin(g)),
                (expected.next(h), found.next(g)),
                (expected.prev(h), found.prev(g)),
            ];
            for (to, does) in steps.into_iter().filter_map(|(a, b)| a.zip(b)) {
                let ends = [mine.get(to.index()), theirs.get(does.index())].map(|e| e.copied().flatten());
                let free = self.found(to).is_none() && self.expected(does).is_none();
                if free && ends[0].is_some() && ends[0] == ends[1] {
                    self.pair(to, does);
                    queue.push((to, does));
                }
            }
        }
    }

    /// Nothing but parallel half-edges: as the structure has them if it is the same, else in the order of their
    /// numbers.
    fn guess(
        &mut self,
        expected: &Placed<'_>,
        found: &Placed<'_>,
        matched: &Matched,
        groups: &[(std::ops::Range<usize>, std::ops::Range<usize>)],
        mine: &[([u32; 2], HalfEdgeId)],
        theirs: &[([u32; 2], HalfEdgeId)],
    ) {
        let number = |placed: &Placed<'_>, v: crate::ids::VertexId| placed.numbers.get(v.index()).copied().flatten();
        let first = |v| [number(expected, v).map_or(u64::MAX, u64::from), 0];
        let partner = |v| number(found, v).and_then(|m| matched.to_expected[m as usize]);
        let second = |v| [partner(v).map_or(u64::MAX - 1, u64::from), 0];
        let options = IsomorphismOptions::new().keys(&first, &second);
        let small = expected.table.half_edge_bound().max(found.table.half_edge_bound()) <= SMALL;
        if let Some(matching) =
            small.then(|| isomorphic_with(expected.table, found.table, &options)).and_then(Result::ok)
        {
            let pairs = matching.half_edges.iter().filter_map(|(h, g)| g.map(|g| (h, g)));
            return pairs.for_each(|(h, g)| self.pair(h, g));
        }
        for (m, n) in groups {
            for &(_, h) in &mine[m.clone()] {
                let free = theirs[n.clone()].iter().find(|(_, g)| self.expected(*g).is_none());
                if let (None, Some(&(_, g))) = (self.found(h), free) {
                    self.pair(h, g);
                    self.spread(expected.table, found.table, vec![(h, g)], mine, theirs);
                }
            }
        }
    }

    /// The student's half-edge.
    pub(super) fn found(&self, h: HalfEdgeId) -> Option<HalfEdgeId> {
        self.to_found.get(h.index()).copied().flatten()
    }

    /// The half-edge of the reference.
    pub(super) fn expected(&self, g: HalfEdgeId) -> Option<HalfEdgeId> {
        self.to_expected.get(g.index()).copied().flatten()
    }

    /// The student's point for a point of the reference.
    pub(super) fn vertex(&self, v: u32) -> Option<u32> {
        self.vertices[v as usize]
    }

    pub(super) fn count(&self) -> usize {
        self.to_found.iter().flatten().count()
    }

    /// Whether no half-edge at all should run between these points of the student.
    pub(super) fn is_extra_edge(&self, edge: [u32; 2]) -> bool {
        self.extra.binary_search(&edge).is_ok()
    }
}

/// A table without the edges that the other file does not have.
pub(super) struct Reduced<'a> {
    table: &'a Table,
    partners: &'a [Option<HalfEdgeId>],
}

impl<'a> Reduced<'a> {
    pub(super) fn expected(table: &'a Table, links: &'a Links) -> Self {
        Self { table, partners: &links.to_found }
    }

    pub(super) fn found(table: &'a Table, links: &'a Links) -> Self {
        Self { table, partners: &links.to_expected }
    }

    /// Whether the edge of this half-edge stays.
    pub(super) fn stays(&self, h: HalfEdgeId) -> bool {
        let is_paired = |h: HalfEdgeId| self.partners.get(h.index()).is_some_and(Option::is_some);
        is_paired(h) || mutual_twin(self.table, h).is_some_and(is_paired)
    }

    /// The next half-edge that stays.
    pub(super) fn next(&self, h: HalfEdgeId) -> Option<HalfEdgeId> {
        self.walk(h, Table::next)
    }

    /// The previous half-edge that stays.
    pub(super) fn prev(&self, h: HalfEdgeId) -> Option<HalfEdgeId> {
        self.walk(h, Table::prev)
    }

    fn walk(&self, h: HalfEdgeId, step: impl Fn(&Table, HalfEdgeId) -> Option<HalfEdgeId>) -> Option<HalfEdgeId> {
        let mut at = step(self.table, h)?;
        for _ in 0..STEPS {
            if self.stays(at) || !self.table.has_half_edge(at) {
                return Some(at);
            }
            at = step(self.table, self.table.twin(at)?)?;
        }
        Some(at)
    }
}
