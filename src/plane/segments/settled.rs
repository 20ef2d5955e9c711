//! A look at a graph without a sweep: where only some edges are new, or none, and where faces have few sides.
//!
//! ```text
//!      ╲   ╱        edges that end at a crossing have moved by its rounding: they are compared with all that
//!   ────╲_╱────     is near them. The others meet as they did before. Then what is left of a sweep is to put
//!       ╱ ╲         the half-edges round each vertex in their order.
//! ```

use super::angles::one_rings_by_angle;
use super::crossed::Cuts;
use super::graph::Graph;
use super::trace::{Seen, trace};
use crate::plane::Subdivision;
use crate::topology::TooMany;

/// Faces with more sides than this on the average are left to a sweep.
const FEW_SIDES: usize = 12;

/// A look at a graph in which some edges are known to meet at common ends only: `is_straight[e]` is 1 for them, 0 for the
/// others. None if something meets, or if so many pairs may meet that a sweep is needed.
///
/// Cost: that of [`Cuts::without_sweep`], and O(d log d) for a vertex with d edges.
pub(super) fn look_at_bent(graph: &Graph, is_straight: &[u8]) -> Result<Option<Seen>, TooMany> {
    if !Cuts::without_sweep(graph, is_straight).is_ok_and(|cuts| cuts.is_empty()) {
        return Ok(None);
    }
    where_nothing_meets(graph).map(Some)
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
    graph.points = subdivision.points.into_vec();
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
}
