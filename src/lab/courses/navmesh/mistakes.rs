//! Usual mistakes, carried out: does one of them show in a call?
//!
//! ```text
//!   start, goal, portals     only one corner of the other chain is passed     ──▶  another path: it would show here
//! ```
//!
//! Nothing here decides a verdict. A feature of a call says that such a mistake shows in it; if the calls in which it
//! shows are those that fail, the report says so.

use super::funnel::{Sleeve, shortest};
use super::mesh::{Spot, corridor, is_triangle, neighbours, place, sides, triangles_of, turn};
use dcel_kit::topology::{Table, View};
use dcel_kit::{FaceId, HalfEdgeId};
use std::cmp::Ordering;

/// The side on which a point lies, by a product of differences: rounding can turn it.
fn rounded(a: Spot, b: Spot, c: Spot) -> Ordering {
    let product = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    product.partial_cmp(&0.0).unwrap_or(Ordering::Equal)
}

/// How it is told whether a point is beyond a side.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Beyond {
    /// Rightly.
    Exactly,
    /// A point on the line of a side counts as beyond it.
    OnTheLine,
    /// The sign of a rounded product decides.
    Rounded,
}

/// The first side of a triangle that seems to have a point beyond it.
fn side_before(table: &Table, f: u32, p: Spot, how: Beyond) -> Option<HalfEdgeId> {
    let at = |h: HalfEdgeId| table.origin(h).map(|v| place(table, v));
    sides(table, f).into_iter().find(|&h| {
        let ends = at(h).zip(table.next(h).and_then(at));
        ends.is_some_and(|(a, b)| match how {
            Beyond::Exactly => turn(a, b, p).is_lt(),
            Beyond::OnTheLine => turn(a, b, p).is_le(),
            Beyond::Rounded => rounded(a, b, p).is_lt(),
        })
    })
}

/// Whether a scan over all triangles with this mistake answers wrongly.
pub(super) fn scan_goes_wrong(table: &Table, p: Spot, wrong: Beyond) -> bool {
    let mut all = (0..table.faces.len() as u32).filter(|&f| is_triangle(table, f));
    let found = all.find(|&f| side_before(table, f, p, wrong).is_none());
    let right = triangles_of(table, p);
    found.map_or(!right.is_empty(), |f| !right.contains(&f))
}

/// Whether a walk with this mistake, that scans behind a wall, answers wrongly or does not come back.
pub(super) fn walk_goes_wrong(table: &Table, from: u32, p: Spot, wrong: Beyond) -> bool {
    match walk(table, from, p, wrong) {
        Some((f, false)) => !triangles_of(table, p).contains(&f),
        Some((_, true)) => scan_goes_wrong(table, p, wrong),
        None => true,
    }
}

/// Where a walk ends that always crosses the first side with a point beyond it: in a triangle that has none, or behind a
/// wall, and whether it is that. `None` if it does not come back.
pub(super) fn walk(table: &Table, from: u32, p: Spot, how: Beyond) -> Option<(u32, bool)> {
    let mut at = from;
    // One that meets a triangle twice would go round for ever.
    for _ in 0..=table.faces.len() {
        let Some(side) = side_before(table, at, p, how) else { return Some((at, false)) };
        at = table.face(table.twin(side)?)?.number();
        if !is_triangle(table, at) {
            return Some((at, true));
        }
    }
    None
}

/// Whether a search that goes deep first finds a longer corridor.
pub(super) fn deep_is_longer(table: &Table, start: u32, goal: u32) -> bool {
    let Some(best) = corridor(table, start, goal) else { return false };
    let mut came_from: Vec<Option<u32>> = vec![None; table.faces.len()];
    came_from[start as usize] = Some(start);
    let mut open = vec![start];
    while let Some(f) = open.pop().filter(|&f| f != goal) {
        for g in neighbours(table, f) {
            if came_from[g as usize].is_none() {
                came_from[g as usize] = Some(f);
                open.push(g);
            }
        }
    }
    let back = |f: &u32| came_from[*f as usize].filter(|_| *f != start);
    std::iter::successors(Some(goal), back).count() > best.len()
}

/// Whether the triangle has `f0` across a side although that is not the outer face, or a wall although that is not `f0`.
pub(super) fn takes_0_for_outer(table: &Table, f: u32) -> bool {
    let outer = table.outer_face;
    let across = sides(table, f).into_iter().filter_map(|h| table.face(table.twin(h)?));
    outer != Some(FaceId::new(0)) && across.into_iter().any(|g| Some(g) == outer || g == FaceId::new(0))
}

/// How the funnel goes wrong.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Funnel {
    /// An end straight on is kept as a corner.
    KeepsStraight,
    /// A chain that has become empty never goes round the other one.
    NeverRound,
    /// It goes round one corner of the other chain at most.
    RoundOne,
    /// The goal is joined to the left chain as it is.
    GoalJoined,
    /// The sign of a rounded product decides what stays of a chain.
    Rounded,
}

/// Whether the funnel with this mistake finds another path.
pub(super) fn funnel_goes_wrong(sleeve: &Sleeve, wrong: Funnel) -> bool {
    let mut passed = vec![sleeve.start];
    let mut chains: [Vec<Spot>; 2] = [Vec::new(), Vec::new()];
    for portal in &sleeve.portals {
        for (i, &end) in portal.iter().enumerate() {
            lead(&mut passed, &mut chains, i, end, wrong);
        }
    }
    if wrong == Funnel::GoalJoined {
        chains[0].push(sleeve.goal);
    } else {
        lead(&mut passed, &mut chains, 0, sleeve.goal, wrong);
    }
    passed.append(&mut chains[0]);
    passed.dedup();
    passed != shortest(sleeve)
}

/// Leads the chain number `i` (0 is the left one) to a new end.
fn lead(passed: &mut Vec<Spot>, chains: &mut [Vec<Spot>; 2], i: usize, end: Spot, wrong: Funnel) {
    let bend = [Ordering::Greater, Ordering::Less][i];
    let mut apex = passed.last().copied().unwrap_or(end);
    while let Some(last) = chains[i].pop() {
        let from = chains[i].last().copied().unwrap_or(apex);
        let side = if wrong == Funnel::Rounded { rounded(from, last, end) } else { turn(from, last, end) };
        if side == bend || wrong == Funnel::KeepsStraight && side.is_eq() {
            chains[i].extend([last, end]);
            return;
        }
    }
    let around = &mut chains[1 - i];
    while wrong != Funnel::NeverRound && !around.is_empty() && turn(apex, around[0], end) == bend.reverse() {
        apex = around.remove(0);
        passed.push(apex);
        if wrong == Funnel::RoundOne {
            break;
        }
    }
    chains[i].push(end);
}

#[cfg(test)]
mod tests {
    use super::super::funnel::{fan, nearly_straight, random_sleeve, winding};
    use super::super::mesh::cells;
    use super::*;
    use crate::cases::random::Random;

    #[test]
    fn every_mistake_of_the_funnel_shows_in_some_sleeves_and_not_in_others() {
        let mut random = Random::new(3, "slips");
        let mut sleeves: Vec<Sleeve> = (0..600).map(|i| random_sleeve(&mut random, 1 + i % 9, 1.0)).collect();
        sleeves.extend([winding(6), fan(6)]);
        sleeves.extend(nearly_straight());
        let all = [Funnel::KeepsStraight, Funnel::NeverRound, Funnel::RoundOne, Funnel::GoalJoined, Funnel::Rounded];
        for (i, wrong) in all.into_iter().enumerate() {
            let shows = sleeves.iter().filter(|sleeve| funnel_goes_wrong(sleeve, wrong)).count();
            assert!(0 < shows && shows < sleeves.len(), "{i}: {shows}");
        }
    }

    #[test]
    fn points_on_a_side_and_deep_searches_go_wrong() {
        let table = cells(3, 3);
        assert!(scan_goes_wrong(&table, [1.0, 1.0], Beyond::OnTheLine));
        assert!(!scan_goes_wrong(&table, [0.5, 0.25], Beyond::OnTheLine));
        assert!(!scan_goes_wrong(&table, [1.0, 1.0], Beyond::Rounded));
        assert!(walk_goes_wrong(&table, 1, [1.0, 1.0], Beyond::OnTheLine));
        assert!(!walk_goes_wrong(&table, 1, [2.5, 2.25], Beyond::Rounded));
        assert!((1..18).any(|f| deep_is_longer(&table, f, 18)) && !deep_is_longer(&table, 1, 1));
    }
}
