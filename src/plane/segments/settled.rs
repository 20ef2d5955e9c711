//! A look at a graph without a sweep: where only some edges are new, or none, where all is far apart beside the rounding, and
//! where faces have few sides.
//!
//! ```text
//!      ╲   ╱        edges that end at a crossing have moved by its rounding: they are compared with all that
//!   ────╲_╱────     is near them. The others meet as they did before. Then what is left of a sweep is to put
//!       ╱ ╲         the half-edges round each vertex in their order.
//! ```

use super::angles::{one_rings_by_angle, one_rings_where};
use super::crossed::without_edge;
use super::graph::Graph;
use super::trace::{Seen, trace};
use crate::geometry::both::of_both;
use crate::geometry::point::corners;
use crate::plane::Subdivision;
use crate::plane::marks::Marks;
use crate::plane::meet::{Gap, meetings};
use crate::plane::sweep::rightwards;
use crate::topology::TooMany;

/// Columns and rows of the grid by which edges near others are found.
const SIDE: usize = 256;

/// Faces with more sides than this on the average are left to a sweep.
const FEW_SIDES: usize = 12;

/// A look at a graph in which some edges are known to meet at common ends only: `is_straight[e]` is 1 for them, 0 for the
/// others. None if something meets, or if so many pairs may meet that a sweep is needed.
///
/// Cost: that of [`meetings`] for the edges near those that are not straight; O(n), and O(d log d) for a vertex with d edges.
pub(super) fn look_at_bent(graph: &Graph, is_straight: &[u8]) -> Result<Option<Seen>, TooMany> {
    let near = near_bent(graph, is_straight);
    let sets: Vec<u8> = near.iter().map(|&e| is_straight[e as usize]).collect();
    let near: Vec<[u32; 2]> = near.into_iter().map(|e| graph.edges[e as usize]).collect();
    if_nothing_meets(graph, &near, &sets)
}

/// A look at a graph, pair by pair. None if something meets, or if so many pairs may meet that a sweep is needed.
///
/// Cost: that of [`meetings`]; O(n), and O(d log d) for a vertex with d edges.
pub(super) fn look_by_pairs(graph: &Graph) -> Result<Option<Seen>, TooMany> {
    if_nothing_meets(graph, &graph.edges, &[])
}

/// A look at a graph, if none of some edges of it meets another of them, or a point without an edge; for their sets see
/// [`meetings`]. None also if so many pairs may meet that a sweep is needed.
fn if_nothing_meets(graph: &Graph, some: &[[u32; 2]], sets: &[u8]) -> Result<Option<Seen>, TooMany> {
    let Graph { points, edges, .. } = graph;
    let loose = without_edge(points.len(), 0..points.len() as u32, edges);
    let found = meetings(points, &rightwards(points, some), &loose, sets);
    let is_settled = found.is_ok_and(|found| found.crossings.is_empty() && found.touches.is_empty());
    is_settled.then(|| where_nothing_meets(graph)).transpose()
}

/// A look at a graph whose vertices were rounded by much less than the gap, and in which edges that were cut were farther than
/// that from all that they had no point in common with. None if half-edges round a vertex are too near each other to tell that nothing meets; see [`Gap`].
///
/// Cost: O(n), and O(d log d) for a vertex with d edges.
pub(super) fn look_within(graph: &Graph, gap: Gap) -> Result<Option<Seen>, TooMany> {
    let (one_rings, are_apart) = one_rings_where(graph, |from, ends| gap.is_between(from, ends))?;
    Ok(are_apart.then_some(Seen::OneRings(one_rings)))
}

/// The edges that are not straight, and those that may be near enough to meet one of them: both have a cell of a coarse grid
/// in common.
fn near_bent(graph: &Graph, is_straight: &[u8]) -> Vec<u32> {
    let Graph { points, edges, .. } = graph;
    let bounds = |ends: [u32; 2]| corners(of_both(ends, |p| points[p as usize]));
    let mut bent = Marks::new(corners(points.iter().copied()), SIDE);
    let marked = edges.iter().zip(is_straight).filter(|&(_, &is_straight)| is_straight == 0);
    marked.for_each(|(&ends, _)| bent.mark(bounds(ends)));
    (0..edges.len() as u32).filter(|&e| bent.may_meet(bounds(edges[e as usize]))).collect()
}

/// A look at a graph in which nothing meets but at common ends.
///
/// Cost: O(n), and O(d log d) for a vertex with d edges.
pub(super) fn where_nothing_meets(graph: &Graph) -> Result<Seen, TooMany> {
    one_rings_by_angle(graph).map(Seen::OneRings)
}

/// The subdivision of a graph whose faces have few sides, if they show that nothing meets but at common ends; else nothing
/// has happened.
///
/// Cost: O(n), and O(d log d) for a vertex with d edges; besides the sweep over faces with many sides.
pub(super) fn proved_by_faces(graph: &mut Graph) -> Result<Option<Subdivision>, TooMany> {
    // Euler's formula, for one component.
    let bounded = (graph.edges.len() + 1).saturating_sub(graph.points.len());
    if 2 * graph.edges.len() > FEW_SIDES * bounded {
        return Ok(None);
    }
    let seen = where_nothing_meets(graph)?;
    let subdivision = trace(graph, seen)?;
    if subdivision.is_proved_by_faces() {
        return Ok(Some(subdivision));
    }
    let Subdivision { dcel, points, .. } = subdivision;
    graph.points = points.into_vec();
    graph.edges = dcel.into_columns().origin.as_chunks().0.to_vec();
    Ok(None)
}

#[cfg(test)]
mod tests {
    use super::super::graph::{Distinct, Graph, Single};
    use super::super::trace::look;
    use super::*;
    use crate::plane::Point;
    use crate::plane::sweep::tests::numbers;

    /// Triangulations without some of their edges, islands in them, a few points moved.
    fn random(next: &mut impl FnMut(u64) -> u64) -> Graph {
        let (mut points, mut edges): (Vec<Point>, Vec<[u32; 2]>) = Default::default();
        for island in 0..1 + next(3) {
            let size = 3 + next(9);
            let shift = if island == 0 { 0.0 } else { next(9) as f64 + 0.25 };
            let places: Vec<Point> =
                (0..4 + next(60)).map(|_| Point::new(next(size) as f64 + shift, next(size) as f64 + shift)).collect();
            let Ok(built) = Subdivision::delaunay(&places) else { continue };
            let s = built.subdivision;
            let first = points.len() as u32;
            points.extend(s.vertices().map(|v| s.point(v)));
            let share = 3 + next(30);
            edges.extend(s.edges().map(|e| s.edge_ends(e).map(|v| first + v.number())).filter(|_| next(share) > 0));
        }
        for _ in 0..next(5).saturating_sub(2) {
            let size = points.len() as u64;
            if size > 0 {
                points[next(size) as usize] = Point::new(next(9) as f64, next(9) as f64);
            }
        }
        let Distinct { points, order, number } = Distinct::without_order(&points);
        let ends = edges.iter().map(|edge| edge.map(|p| number[p as usize]));
        let ends: Vec<[u32; 2]> = ends.filter(|[a, b]| a != b).collect();
        Graph { edges: Single::new(points.len(), &ends, |_, _| {}).edges, points, order }
    }

    #[test]
    fn faces_prove_what_a_sweep_sees_and_make_the_same() {
        let (mut proved, mut islands, mut wrong, mut left) = (0, 0, 0, 0);
        for seed in 1..=12_000_u64 {
            let graph = random(&mut numbers(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15)));
            let (mut one, mut other) = (graph.clone(), graph.clone());
            let seen = look(&graph).unwrap();
            let meets = seen.intersection().is_some();
            match proved_by_faces(&mut one).unwrap() {
                Some(made) => {
                    assert!(!meets, "seed {seed}: {:?}", seen.intersection());
                    assert_eq!(made, trace(&mut other, seen).unwrap(), "seed {seed}");
                    proved += 1;
                    islands += made.faces().map(|f| made.inner_components(f).len()).sum::<usize>();
                }
                None => {
                    assert_eq!(one.points, graph.points, "seed {seed}");
                    wrong += u32::from(meets);
                    left += u32::from(!meets);
                }
            }
        }
        assert!(proved > 3_000 && islands > 1_000 && wrong > 3_000, "{proved}, {islands}, {wrong}, {left} left");
    }

    #[test]
    fn a_look_by_pairs_says_what_a_sweep_says_and_the_same_is_made() {
        let (mut settled, mut meeting) = (0, 0);
        for seed in 1..=3_000_u64 {
            let mut graph = random(&mut numbers(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15)));
            let mut other = graph.clone();
            let swept = look(&graph).unwrap();
            match look_by_pairs(&graph).unwrap() {
                Some(seen) => {
                    assert!(swept.intersection().is_none(), "seed {seed}: {:?}", swept.intersection());
                    assert_eq!(trace(&mut graph, seen).unwrap(), trace(&mut other, swept).unwrap(), "seed {seed}");
                    settled += 1;
                }
                None => meeting += u32::from(swept.intersection().is_some()),
            }
        }
        assert!(settled > 800 && meeting > 1_900, "{settled}, {meeting}");
    }

    #[test]
    fn whatever_may_meet_a_bent_edge_is_near_it() {
        let (mut near, mut far) = (0, 0);
        for seed in 1..60_u64 {
            let mut next = numbers(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15));
            let (reach, far_off) = ([1, 40, 2_000][seed as usize % 3], [0.0, 1e7][seed as usize / 3 % 2]);
            let points: Vec<Point> = (0..200)
                .flat_map(|_| {
                    let [x, y] = [next(2_000), next(if seed % 5 == 0 { 1 } else { 2_000 })];
                    let to = [x + next(reach + 1), y + next(reach + 1)];
                    [[x, y], to].map(|[x, y]| Point::new(x as f64 * 0.1 - far_off, y as f64 * 0.1))
                })
                .collect();
            let edges: Vec<[u32; 2]> = (0..200).map(|e| [2 * e + e % 2, 2 * e + 1 - e % 2]).collect();
            let is_straight: Vec<u8> = edges.iter().map(|_| u8::from(next(40) > 0)).collect();
            let graph = Graph { points, edges, ..Graph::default() };
            let found = near_bent(&graph, &is_straight);
            let bounds = |e: usize| corners(graph.edges[e].map(|p| graph.points[p as usize]));
            for e in 0..graph.edges.len() {
                let meets = |g: usize| {
                    let ([a, b], [c, d]) = (bounds(e), bounds(g));
                    a.x <= d.x && c.x <= b.x && a.y <= d.y && c.y <= b.y
                };
                let may_meet = (0..graph.edges.len()).any(|g| is_straight[g] == 0 && meets(g));
                assert!(!may_meet || found.contains(&(e as u32)), "seed {seed}, edge {e}");
                near += u32::from(may_meet);
                far += u32::from(!found.contains(&(e as u32)));
            }
        }
        assert!(near > 1_000 && far > 4_000, "{near} near, {far} far");
    }
}
