//! All pairs of edges that meet, found in the cells of a grid: without any order, and without a sweep line.
//!
//! ```text
//!   ┌───┬───┬───┐      An edge is in the list of each cell that it passes, so that two edges meet in the cell where
//!   │  ╱│   │ ╲ │      both are listed. A cell with many edges is divided by a grid of its own. Pairs are decided by
//!   ├─╱─┼───┼──╲┤      exact orientations; cells only say which pairs are worth it.
//!   │╱  │━━━━━━━│╲
//!   └───┴───┴───┘
//! ```
//!
//! Edges of one set are known not to cross each other. Their pairs are looked at only to see whether all that crosses is
//! farther than the gap (`gap.rs`) from what it does not meet.
//!
//! Cost: expected O(n + k) for n edges with k meeting pairs, if edges are about as long as they are apart. Where that is
//! not so, the work breaks off after O(n + k) steps, and the sweep has to do it.
//!
//! Source: Franklin, Narayanaswami, Kankanhalli, Sun, Zhou and Wu, *Uniform grids: a technique for intersection detection
//! on serial and parallel machines*, Auto-Carto 9, 1989.

use super::gap::Gap;
use super::raster::{Cells, Frame};
use crate::geometry::both::of_both;
use crate::geometry::grouping::Groups;
use crate::geometry::point::corners;
use crate::geometry::predicates::{left_to_right, orientation};
use crate::plane::Point;
use crate::progress::Stage;
use std::cmp::Ordering;

/// What meets.
#[derive(Default)]
pub(in crate::plane) struct Meetings {
    /// The edges that cross in a point interior to both, each pair once, the smaller number first.
    pub(in crate::plane) crossings: Vec<[u32; 2]>,
    /// Edges with points in their interiors, each pair once.
    pub(in crate::plane) touches: Vec<[u32; 2]>,
    /// What crosses something is farther than this from all that it has no point in common with, if that is known.
    pub(in crate::plane) gap: Option<Gap>,
}

/// Why there is no answer.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(in crate::plane) enum NoMeetings {
    /// Two edges share more than a point.
    Overlap,
    /// A sweep is needed: pair by pair the work is more, or pairs do not tell all.
    LeftToSweep,
}

/// So many edges of a cell are compared pair by pair.
const FEW: usize = 10;
/// So many edges for each cell of a grid, and where large cells come first.
const SOME: usize = 3;
const MANY: usize = 64;
/// So many items at once, at least.
const AT_ONCE: usize = 128;
/// Steps for each edge and each meeting pair, after which the work breaks off.
const STEPS: usize = 32;
/// So often a cell that has nearly all edges of a grid is divided again.
const PATIENCE: u32 = 3;

/// Finds what meets among edges that run from left to right, and points that are loose. Edges have two different ends, no two
/// the same ones; points are distinct.
///
/// `sets[e]` has a bit for each set that edge e belongs to. Edges of one set are known to meet at common ends only: they are
/// not compared with each other.
///
/// # Errors
/// [`NoMeetings`].
pub(in crate::plane) fn meetings(
    points: &[Point],
    edges: &[[u32; 2]],
    loose: &[u32],
    sets: &[u8],
) -> Result<Meetings, NoMeetings> {
    let [low, high] = corners(points.iter().copied());
    let whole = Frame { low: [0.0; 2], size: [high.x - low.x, high.y - low.y] };
    let gap = Gap::new([low.x, low.y, high.x, high.y].into_iter().fold(0.0, |reach, x| x.abs().max(reach)));
    let finest = whole.finest();
    let found = Meetings::default();
    let (is_apart, alone) = (true, Vec::new());
    let mut search = Search { points, edges, loose, sets, low, finest, gap, is_apart, alone, found, steps: 0 };
    let items: Vec<u32> = (0..(edges.len() + loose.len()) as u32).collect();
    // Where sets are known, large cells come first: most of them have the edges of one set only, and are done.
    let sides = search.sides(&items, &whole, if sets.is_empty() { SOME } else { MANY });
    let stage = Stage::new("looking for crossings", sides[0] * sides[1]);
    search.compare(&items, &whole, sides, PATIENCE, |cell| stage.at(cell))?;
    let is_apart = search.is_apart && search.is_seen_where_it_crosses(&Cells::new(&whole, sides));
    let mut found = search.found;
    found.gap = is_apart.then_some(gap);
    for list in [&mut found.crossings, &mut found.touches] {
        each_once(list, edges.len());
    }
    Ok(found)
}

/// Puts pairs in order, each once. Their first numbers are below a bound.
fn each_once(list: &mut Vec<[u32; 2]>, bound: usize) {
    if list.len() < bound / 8 {
        list.sort_unstable();
        list.dedup();
        return;
    }
    let mut seconds = Groups::new(bound, list.iter().map(|&[first, second]| (first as usize, second)));
    list.clear();
    for first in 0..bound {
        let seconds = seconds.of_mut(first);
        seconds.sort_unstable();
        list.extend(seconds.chunk_by(|a, b| a == b).map(|same| [first as u32, same[0]]));
    }
}

/// An item of a cell, with its ends from left to right, and its box.
struct Near {
    item: u32,
    ends: [u32; 2],
    set: u8,
    at: [Point; 2],
    bounds: [[f64; 2]; 2],
}

/// Edges, and behind them loose points, which are edges from themselves to themselves: the items.
struct Search<'a> {
    points: &'a [Point],
    edges: &'a [[u32; 2]],
    loose: &'a [u32],
    sets: &'a [u8],
    low: Point,
    /// No cell is narrower, nor lower.
    finest: [f64; 2],
    gap: Gap,
    /// Whether all that was compared and has no point in common was farther apart than the gap.
    is_apart: bool,
    /// By cell of the whole grid the bits of a set, if all edges in it are of that set: then they were not compared.
    alone: Vec<u8>,
    found: Meetings,
    steps: usize,
}

impl Search<'_> {
    /// The ends of an item by their numbers.
    #[inline]
    fn ends(&self, item: u32) -> [u32; 2] {
        match self.edges.get(item as usize) {
            Some(&ends) => ends,
            None => [self.loose[item as usize - self.edges.len()]; 2],
        }
    }

    #[inline]
    fn set(&self, item: u32) -> u8 {
        self.sets.get(item as usize).copied().unwrap_or(0)
    }

    /// An end from the lower left corner of everything.
    #[inline]
    fn offset(&self, point: u32) -> [f64; 2] {
        let p = self.points[point as usize];
        [p.x - self.low.x, p.y - self.low.y]
    }

    fn spend(&mut self, steps: usize) -> Result<(), NoMeetings> {
        self.steps += steps;
        let found = self.found.crossings.len() + self.found.touches.len();
        let most = STEPS * (self.edges.len() + self.loose.len() + found);
        if self.steps > most { Err(NoMeetings::LeftToSweep) } else { Ok(()) }
    }

    /// Compares the items of a frame: in the cells of a grid with so many columns and rows, each of which is told, or pair by
    /// pair.
    fn compare(
        &mut self,
        items: &[u32],
        frame: &Frame,
        sides: [usize; 2],
        patience: u32,
        tell: impl Fn(usize),
    ) -> Result<(), NoMeetings> {
        if sides[0] * sides[1] < 2 {
            self.pairs(&items.iter().map(|&item| self.near(item)).collect::<Vec<_>>())
        } else {
            self.divide(items, &Cells::new(frame, sides), patience, &tell)
        }
    }

    /// How many columns and rows divide a frame best: a cell for so many items, but none narrower than items are wide there, nor
    /// lower than they are high. So an item is in few cells on the average.
    fn sides(&self, items: &[u32], frame: &Frame, each: usize) -> [usize; 2] {
        let within = |item: u32, i: usize| {
            let [a, b] = of_both(self.ends(item), |p| self.offset(p)[i]);
            (a.max(b).min(frame.low[i] + frame.size[i]) - a.min(b).max(frame.low[i])).max(0.0)
        };
        let mean = [0, 1].map(|i| items.iter().map(|&item| within(item, i)).sum::<f64>() / items.len() as f64);
        frame.sides(items.len() / each, mean, self.finest)
    }

    /// Looks at the items cell by cell.
    fn divide(&mut self, items: &[u32], cells: &Cells, patience: u32, tell: &dyn Fn(usize)) -> Result<(), NoMeetings> {
        self.is_apart &= cells.hold(self.gap.width());
        let is_whole = self.alone.is_empty();
        let number = |column: usize, row: usize| row * cells.count[0] + column;
        let mut starts = vec![0_u32; cells.count[0] * cells.count[1] + 1];
        // Where all items of a cell are of one set, nothing meets: such cells of the whole grid are skipped. In a cell that has
        // both sets smaller ones are still asked whether all is farther apart than the gap.
        let mut sets = vec![u8::MAX; starts.len()];
        // The cells of each item, row by row: from one to another.
        let mut runs: Vec<[u32; 3]> = Vec::with_capacity(items.len());
        let mut sum = 0_usize;
        for &item in items {
            let set = self.set(item);
            cells.rows_of(of_both(self.ends(item), |p| self.offset(p)), |row, first, last| {
                let run = number(first, row)..=number(last, row);
                runs.push([*run.start() as u32, *run.end() as u32, item]);
                sum += last - first + 1;
                for cell in run {
                    starts[cell] += 1;
                    sets[cell] &= set;
                }
            });
        }
        self.spend(starts.len() / 4 + sum)?;
        let is_skipped = |set: u8| set != 0 && is_whole;
        let mut all = 0;
        for (start, set) in starts.iter_mut().zip(&sets) {
            all += if is_skipped(*set) { 0 } else { *start as usize };
            *start = u32::try_from(all).map_err(|_| NoMeetings::LeftToSweep)?;
        }
        let mut lists = vec![0_u32; all];
        for &[first, last, item] in runs.iter().rev() {
            for cell in (first as usize..=last as usize).filter(|&cell| !is_skipped(sets[cell])) {
                starts[cell] -= 1;
                lists[starts[cell] as usize] = item;
            }
        }
        drop(runs);
        if is_whole {
            self.alone.clone_from(&sets);
        }
        // The items of some cells are looked up at once, before anything is decided: memory answers many questions in the
        // time of one.
        let mut near: Vec<Near> = Vec::new();
        let mut known = 0;
        for cell in 0..starts.len() - 1 {
            tell(cell);
            let [start, end] = [starts[cell] as usize, starts[cell + 1] as usize];
            let list = &lists[start..end];
            if sets[cell] != 0 && (list.len() > FEW || !self.is_apart) {
                self.is_apart &= list.is_empty();
                continue;
            }
            let is_nearly_all = 4 * list.len() > 3 * items.len();
            let patience = if is_nearly_all { patience - 1 } else { PATIENCE };
            if list.len() <= FEW || patience == 0 {
                if end > known {
                    known = end.max((start + AT_ONCE).min(lists.len()));
                    near.clear();
                    near.extend(lists[start..known].iter().map(|&item| self.near(item)));
                }
                let from = near.len() - (known - start);
                self.pairs(&near[from..from + list.len()])?;
                continue;
            }
            let inner = cells.frame(cell % cells.count[0], cell / cells.count[0]);
            let sides = self.sides(list, &inner, SOME);
            self.compare(list, &inner, sides, patience, |_| ())?;
        }
        Ok(())
    }

    /// Compares items pair by pair.
    fn pairs(&mut self, near: &[Near]) -> Result<(), NoMeetings> {
        let width = self.gap.width();
        for (i, one) in near.iter().enumerate() {
            self.spend(near.len() - i)?;
            let line = self.gap.line(one.at);
            let [low, high] = one.bounds;
            let [low, high] = [[low[0] - width, low[1] - width], [high[0] + width, high[1] + width]];
            for other in &near[i + 1..] {
                let [other_low, other_high] = other.bounds;
                let is_beside = (other_high[0] < low[0])
                    | (high[0] < other_low[0])
                    | (other_high[1] < low[1])
                    | (high[1] < other_low[1]);
                if is_beside {
                    continue;
                }
                if one.set & other.set != 0 {
                    self.is_apart = self.is_apart && self.is_apart_in_set([one, other]);
                    continue;
                }
                let side = line.has_on_one_side(other.at);
                if side == Some(true) {
                    continue;
                }
                match (side, self.gap.line(other.at).has_on_one_side(one.at)) {
                    (_, Some(true)) => {}
                    (Some(_), Some(_)) => {
                        self.found.crossings.push([one.item.min(other.item), one.item.max(other.item)]);
                    }
                    _ => self.pair([one.item, other.item], [one.ends, other.ends], [one.at, other.at])?,
                }
            }
        }
        Ok(())
    }

    /// Whether two edges of one set have an end in common, or are clearly farther apart than the gap.
    fn is_apart_in_set(&self, [one, other]: [&Near; 2]) -> bool {
        let beside = |near: &Near, at| self.gap.line(near.at).has_on_one_side(at) == Some(true);
        one.ends.iter().any(|end| other.ends.contains(end)) || beside(one, other.at) || beside(other, one.at)
    }

    /// Whether what crosses something lies in cells in which everything was compared.
    fn is_seen_where_it_crosses(&self, cells: &Cells) -> bool {
        if self.alone.iter().all(|&set| set == 0 || set == u8::MAX) {
            return true;
        }
        let mut is_seen = true;
        let mut crosses = vec![false; self.edges.len()];
        for &e in self.found.crossings.as_flattened() {
            if !std::mem::replace(&mut crosses[e as usize], true) {
                cells.rows_of(of_both(self.ends(e), |p| self.offset(p)), |row, first, last| {
                    let row = &self.alone[row * cells.count[0]..][first..=last];
                    is_seen &= row.iter().all(|&set| set == 0);
                });
            }
        }
        is_seen
    }

    /// An item with all that is asked of it.
    #[inline]
    fn near(&self, item: u32) -> Near {
        let ends = self.ends(item);
        let at @ [a, b] = of_both(ends, |p| self.points[p as usize]);
        let bounds = [[a.x, a.y.min(b.y)], [b.x, a.y.max(b.y)]];
        Near { item, ends, set: self.set(item), at, bounds }
    }

    /// Two items whose boxes are near each other. Exact.
    fn pair(
        &mut self,
        items: [u32; 2],
        [[p, q], [r, s]]: [[u32; 2]; 2],
        [[a, b], [c, d]]: [[Point; 2]; 2],
    ) -> Result<(), NoMeetings> {
        // With a common end they share more only if they leave it in the same direction. Ends are left and right ones.
        if p == r || q == s {
            let (here, far, other) = if p == r { (a, b, d) } else { (b, a, c) };
            return if orientation(here, far, other).is_eq() { Err(NoMeetings::Overlap) } else { Ok(()) };
        }
        if q == r || p == s {
            return Ok(());
        }
        let is_beside = d.x < a.x || b.x < c.x || c.y.max(d.y) < a.y.min(b.y) || a.y.max(b.y) < c.y.min(d.y);
        let is_one_side = |sides: [Ordering; 2]| sides[0] == sides[1] && sides[0].is_ne();
        let sides = [orientation(a, b, c), orientation(a, b, d)];
        let others = [orientation(c, d, a), orientation(c, d, b)];
        if is_beside || (p != q && is_one_side(sides)) || (r != s && is_one_side(others)) {
            self.is_apart = false;
            return Ok(());
        }
        if p == q || r == s {
            // A loose point, and an edge or another loose point, which lies elsewhere.
            let (edge, point, is_on) = if p == q {
                (items[1], p, others[0].is_eq() && r != s && is_between(c, d, a))
            } else {
                (items[0], r, sides[0].is_eq() && is_between(a, b, c))
            };
            if is_on {
                self.found.touches.push([edge, point]);
            } else {
                self.is_apart = false;
            }
            return Ok(());
        }
        match (sides, others) {
            // All four on one line, and their boxes meet.
            ([Ordering::Equal, Ordering::Equal], _) => return Err(NoMeetings::Overlap),
            ([Ordering::Equal, _], _) => self.found.touches.push([items[0], r]),
            ([_, Ordering::Equal], _) => self.found.touches.push([items[0], s]),
            (_, [Ordering::Equal, _]) => self.found.touches.push([items[1], p]),
            (_, [_, Ordering::Equal]) => self.found.touches.push([items[1], q]),
            _ => self.found.crossings.push([items[0].min(items[1]), items[0].max(items[1])]),
        }
        Ok(())
    }
}

/// Whether a point of the line through two others lies between them.
fn is_between(a: Point, b: Point, p: Point) -> bool {
    left_to_right(a, p).is_lt() && left_to_right(p, b).is_lt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plane::sweep::rightwards;
    use crate::plane::sweep::tests::numbers;

    /// All pairs.
    fn one_by_one(
        points: &[Point],
        edges: &[[u32; 2]],
        loose: &[u32],
        sets: &[u8],
    ) -> Result<[Vec<[u32; 2]>; 2], NoMeetings> {
        let at = |p: u32| points[p as usize];
        let on = |[a, b]: [u32; 2], p: u32| {
            ![a, b].contains(&p) && orientation(at(a), at(b), at(p)).is_eq() && is_between(at(a), at(b), at(p))
        };
        let set = |e: usize| sets.get(e).copied().unwrap_or(0);
        let (mut crossings, mut touches) = (Vec::new(), Vec::new());
        for (e, &edge) in edges.iter().enumerate() {
            touches.extend(loose.iter().filter(|&&p| on(edge, p)).map(|&p| [e as u32, p]));
            for (g, &other) in edges.iter().enumerate().skip(e + 1).filter(|&(g, _)| set(e) & set(g) == 0) {
                let [a, b, c, d] = [edge, other].concat().try_into().unwrap();
                let turns =
                    [[a, b, c], [a, b, d], [c, d, a], [c, d, b]].map(|p| orientation(at(p[0]), at(p[1]), at(p[2])));
                let inside: Vec<[u32; 2]> = [(e, edge, other), (g, other, edge)]
                    .iter()
                    .flat_map(|&(e, edge, ends)| {
                        ends.into_iter().filter(move |&p| on(edge, p)).map(move |p| [e as u32, p])
                    })
                    .collect();
                if turns == [Ordering::Equal; 4] {
                    if !inside.is_empty() {
                        return Err(NoMeetings::Overlap);
                    }
                } else if turns[0] == turns[1].reverse()
                    && turns[2] == turns[3].reverse()
                    && !turns.contains(&Ordering::Equal)
                {
                    crossings.push([e as u32, g as u32]);
                }
                touches.extend(inside);
            }
        }
        for list in [&mut crossings, &mut touches] {
            list.sort_unstable();
            list.dedup();
        }
        Ok([crossings, touches])
    }

    #[test]
    fn what_meets_in_cells_is_what_meets_pair_by_pair() {
        let (mut met, mut overlaps, mut left) = ([0; 2], 0, 0);
        for seed in 1..1_200_u64 {
            let mut next = numbers(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15));
            // On a small grid, far from the origin, flat, crowded into corners of corners, and along one line.
            let kind = seed % 6;
            let count = 2 + next(if seed % 4 == 0 { 150 } else { 24 });
            let size = if seed % 5 == 0 { 4 } else { 40 };
            let mut place = || {
                let [x, y] = [next(size), next(size)].map(|x| x as f64);
                match kind {
                    0 | 1 => Point::new(x, y),
                    2 => Point::new(x.mul_add(0.37, 1e9), y.mul_add(0.11, -1e9)),
                    3 => Point::new(x * 1e12, y * 1e-12),
                    4 => {
                        let corner = 2f64.powi(-(next(30) as i32));
                        Point::new(corner * (1.0 + x / 64.0), corner * (1.0 + y / 64.0))
                    }
                    _ => Point::new(x, x + y * 1e-9),
                }
            };
            let mut points: Vec<Point> = Vec::new();
            for _ in 0..2 * count {
                let p = place();
                if !points.contains(&p) {
                    points.push(p);
                }
            }
            let n = points.len() as u64;
            let mut edges: Vec<[u32; 2]> = (0..count).map(|_| [next(n), next(n)].map(|p| p as u32)).collect();
            // Short ones as well, so that a grid pays.
            edges.extend((1..n as u32).filter(|_| next(2) == 0).map(|p| [p - 1, p]));
            edges.retain(|[a, b]| a != b);
            edges = rightwards(&points, &edges);
            edges.sort_unstable();
            edges.dedup();
            let loose: Vec<u32> = (0..n as u32).filter(|p| !edges.as_flattened().contains(p)).collect();
            let sets: Vec<u8> = if seed % 3 == 0 { edges.iter().map(|_| next(4) as u8).collect() } else { Vec::new() };
            match (meetings(&points, &edges, &loose, &sets), one_by_one(&points, &edges, &loose, &sets)) {
                (Ok(found), expected) => {
                    let expected = expected.unwrap_or_else(|_| panic!("seed {seed}: edges overlap"));
                    met = [met[0] + found.crossings.len(), met[1] + found.touches.len()];
                    assert_eq!([found.crossings, found.touches], expected, "seed {seed}");
                }
                (Err(NoMeetings::Overlap), expected) => {
                    assert_eq!(expected, Err(NoMeetings::Overlap), "seed {seed}");
                    overlaps += 1;
                }
                (Err(NoMeetings::LeftToSweep), _) => left += 1,
            }
        }
        assert!(met[0] > 10_000 && met[1] > 900 && overlaps > 100 && left < 200, "{met:?} {overlaps} {left}");
    }

    #[test]
    fn bundles_are_left_to_the_sweep_and_rows_are_not() {
        let n = 4_000;
        let lines = |gap: f64| -> Vec<Point> {
            (0..n)
                .flat_map(|i| [Point::new(0.0, f64::from(i) * gap), Point::new(1e3, f64::from(i) * gap + 1.0)])
                .collect()
        };
        let edges: Vec<[u32; 2]> = (0..n as u32).map(|i| [2 * i, 2 * i + 1]).collect();
        let found = |points: &[Point]| meetings(points, &edges, &[], &[]).map(|found| found.crossings.len());
        assert_eq!(found(&lines(1.0)), Ok(0));
        assert_eq!(found(&lines(1e-12)), Err(NoMeetings::LeftToSweep));
        // A square net: every pair meets.
        let half = n / 2;
        let net: Vec<Point> = (0..n)
            .flat_map(|i| {
                let at = f64::from(i % half);
                let ends = if i < half { [(at, -1.0), (at, 1e6)] } else { [(-1.0, at), (1e6, at)] };
                ends.map(Point::from)
            })
            .collect();
        assert_eq!(found(&net), Ok((half * half) as usize));
    }
}
