//! From a plane graph to a subdivision: one-rings, links, cycles, inner components.
//!
//! ```text
//!        h4 ╲   ╱ h2        1. the sweep gives the half-edges round each vertex in their order, h0 h2 h4
//!            ╲ ╱            2. each corner is a link: next(twin(h2)) = h0, next(twin(h4)) = h2, ...
//!             ●── h0        3. the links close to cycles; one that turns clockwise runs round something: an inner
//!                              component (cycles.rs). All others bound a face.
//!   ──●    ● inner component           4. an inner component or an isolated vertex lies in the face above the next edge below its
//!  ───────────── below         leftmost vertex.
//! ```
//!
//! Source: de Berg et al., *Computational Geometry*, 3rd ed., section 2.3.

use super::cycles::cycles;
use super::graph::Graph;
use super::one_rings::OneRings;
use crate::geometry::point::{around, corners};
use crate::ids::{EdgeId, FaceId, VertexId};
use crate::plane::below::{FEW, edges_below};
use crate::plane::marks::Marks;
use crate::plane::rings::Loose;
use crate::plane::sweep::{Intersection, NOTHING, Swept, sweep_in_order};
use crate::plane::{Point, Subdivision};
use crate::topology::{Columns, Dcel, InnerComponent, TooMany};

/// What a look at a graph has found.
pub(super) enum Seen {
    /// By a sweep.
    Swept {
        /// All of them, if nothing meets.
        one_rings: OneRings,
        /// The edge directly below each point, `NOTHING` if there is none.
        below: Vec<u32>,
        /// The first one.
        intersection: Option<Intersection>,
    },
    /// Nothing meets; all one-rings.
    OneRings(OneRings),
    /// Nothing meets; the subdivision was made in order to see that.
    Made(Box<Subdivision>),
}

/// Sweeps over the graph: the first intersection, what lies below each vertex, and, if nothing meets, all one-rings.
pub(super) fn look(graph: &Graph) -> Result<Seen, TooMany> {
    let mut one_rings = OneRings::new(graph)?;
    let Swept { below, intersection } =
        sweep_in_order(&graph.points, &graph.edges, graph.by_place(), true, |one_ring| one_rings.link(&one_ring));
    Ok(Seen::Swept { one_rings, below, intersection })
}

impl Seen {
    /// The first intersection.
    pub(super) fn intersection(&self) -> Option<Intersection> {
        match *self {
            Self::Swept { intersection, .. } => intersection,
            Self::OneRings(_) | Self::Made(_) => None,
        }
    }
}

/// The subdivision that the edges of a graph cut the plane into. The look at it has found no intersections.
///
/// Vertex i of the graph is v(i), edge i is e(i), its even half runs as given. `outgoing(v)` is the first half-edge
/// counter-clockwise from straight down. Bounded faces are numbered from 1 in the order of their smallest
/// half-edge, which is their `half_edge`.
///
/// Points and edges are taken out of the graph.
///
/// Cost: O(n log n).
pub(super) fn trace(graph: &mut Graph, seen: Seen) -> Result<Subdivision, TooMany> {
    let (one_rings, below) = match seen {
        Seen::Swept { one_rings, below, .. } => (one_rings, Some(below)),
        Seen::OneRings(one_rings) => (one_rings, None),
        Seen::Made(subdivision) => return Ok(*subdivision),
    };
    let Graph { points, edges, order } = graph;
    let (columns, loose) = cycles(one_rings, std::mem::take(edges), points)?;
    let below = below.unwrap_or_else(|| below_of(&loose, &columns, points, order.if_known()));
    let mut subdivision = Subdivision::from_parts(Dcel::from_columns(columns), std::mem::take(points).into());
    let edge_below = |v: VertexId| (below[v.index()] != NOTHING).then(|| EdgeId::new(below[v.index()]));
    let fits = |_: &Subdivision, _, _, _| Ok::<(), std::convert::Infallible>(());
    let Ok(()) = subdivision.place_inner_components(&loose, edge_below, fits);
    Ok(subdivision)
}

/// The edges below inner components as far as they tell in which face these lie: for what is in no bounded face there may be
/// none, and of the others those that no bounded face has beside it are left out.
fn below_of(loose: &[Loose], columns: &Columns, points: &[Point], by_place: Option<&[u32]>) -> Vec<u32> {
    let (edges, _) = columns.origin.as_chunks::<2>();
    let leftmost = loose.iter().map(|loose| loose.leftmost.number());
    if loose.len() <= FEW {
        return edges_below(points, edges, by_place, leftmost);
    }
    let side = 2 * (loose.len() as f64).sqrt() as usize + 1;
    // Half-edge by half-edge, not cycle by cycle: no step waits for the one before.
    let mut boxes = vec![corners([]); columns.boundary.len()];
    for (&face, &v) in columns.face.iter().zip(&columns.origin).filter(|&(&face, _)| face != 0) {
        let bounds = &mut boxes[face as usize];
        *bounds = around(*bounds, points[v as usize]);
    }
    let mut bounded = Marks::new(corners(boxes[1..].as_flattened().iter().copied()), side);
    boxes[1..].iter().for_each(|&bounds| bounded.mark(bounds));
    let asked = leftmost.filter(|&v| bounded.may_meet([points[v as usize]; 2]));
    // Where no face is bounded on either side, the edge below lies in the same face as the point.
    let has_bounded = |e: &u32| [0, 1].iter().any(|side| columns.face[(2 * e + side) as usize] != 0);
    let names: Vec<u32> = (0..edges.len() as u32).filter(has_bounded).collect();
    let ends: Vec<[u32; 2]> = names.iter().map(|&e| edges[e as usize]).collect();
    let mut below = edges_below(points, &ends, by_place, asked);
    below.iter_mut().filter(|e| **e != NOTHING).for_each(|e| *e = names[*e as usize]);
    below
}

/// The same without a sweep, for who knows in which face a cycle lies that runs round something: `face_of` is asked for
/// one of its half-edges, and told the boundary of every face. No vertex is isolated.
///
/// Cost: O(n), apart from the order of the inner components.
pub(super) fn trace_known(
    graph: Graph,
    one_rings: OneRings,
    mut face_of: impl FnMut(&[u32], u32) -> FaceId,
) -> Result<Subdivision, TooMany> {
    let Graph { points, edges, .. } = graph;
    let (columns, loose) = cycles(one_rings, edges, &points)?;
    let known = |Loose { ring, .. }: Loose| match ring {
        InnerComponent::Cycle(h) => (ring, face_of(&columns.boundary, h.number())),
        InnerComponent::Isolated(_) => (ring, FaceId::new(0)),
    };
    let placed: Vec<(InnerComponent, FaceId)> = loose.into_iter().map(known).collect();
    let mut subdivision = Subdivision::from_parts(Dcel::from_columns(columns), points.into());
    let mut outer = Vec::new();
    for (ring, face) in placed {
        if face == subdivision.outer_face() {
            outer.push(ring);
        } else {
            subdivision.hang_inner_component(ring, face);
        }
    }
    subdivision.order_inner_components(outer);
    Ok(subdivision)
}

#[cfg(test)]
mod tests {
    use super::super::settled::where_nothing_meets;
    use super::*;
    use crate::plane::sweep::tests::numbers;

    /// Frames in frames, triangles with tails, single edges and points in the cells of a grid; a wide frame round some of them.
    fn islands(next: &mut impl FnMut(u64) -> u64) -> Graph {
        let mut graph = Graph::default();
        let mut add = |corners: &[(f64, f64)], edges: &[[u32; 2]]| {
            let first = graph.points.len() as u32;
            graph.points.extend(corners.iter().map(|&(x, y)| Point::new(x, y)));
            graph.edges.extend(edges.iter().map(|&[a, b]| [first + a, first + b]));
        };
        const RING: [[u32; 2]; 4] = [[0, 1], [1, 2], [2, 3], [3, 0]];
        let side = 12 + next(6);
        for (x, y) in (0..side * side).map(|i| ((i % side) as f64, (i / side) as f64)) {
            match next(6) {
                0 => (0..1 + next(3)).for_each(|i| {
                    let (low, high) = (0.1 + 0.1 * i as f64, 0.9 - 0.1 * i as f64);
                    let corners = [(low, low), (high, low + 0.01), (high, high), (low, high)];
                    add(&corners.map(|(u, v)| (x + u, y + v)), &RING);
                }),
                1 => add(&[(x + 0.2, y + 0.3), (x + 0.7, y + 0.2)], &[[0, 1]]),
                2 => {
                    let corners = [(0.5, 0.4), (0.6, 0.4), (0.55, 0.6), (0.2, 0.1), (0.45, 0.9)];
                    add(&corners.map(|(u, v)| (x + u, y + v)), &[[0, 1], [1, 2], [2, 0], [3, 0], [2, 4]]);
                }
                3 => add(&[(x + 0.5, y + 0.5)], &[]),
                _ => {}
            }
        }
        let frame = [0, 1].map(|_| next(side) as f64);
        for [low, high] in [frame, [-1.0, side as f64 + 1.0]].into_iter().filter(|[low, high]| low < high) {
            add(&[(low, low), (high, low), (high, high), (low, high)], &RING);
        }
        graph.edges.iter_mut().filter(|_| next(2) == 0).for_each(|ends| ends.reverse());
        graph
    }

    #[test]
    fn many_islands_lie_where_a_sweep_says() {
        let (mut inside, mut outside) = (0, 0);
        for seed in 1..300_u64 {
            let mut graph = islands(&mut numbers(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15)));
            if seed % 3 > 0 {
                // Without the wide frame.
                graph.edges.truncate(graph.edges.len() - 4);
            }
            let (seen, by_angle) = (look(&graph).unwrap(), where_nothing_meets(&graph).unwrap());
            assert!(seen.intersection().is_none());
            let swept = trace(&mut graph.clone(), seen).unwrap();
            assert_eq!(trace(&mut graph, by_angle).unwrap(), swept, "seed {seed}");
            let outer = swept.outer_face();
            inside += swept.faces().filter(|&f| f != outer).map(|f| swept.inner_components(f).len()).sum::<usize>();
            outside += swept.inner_components(outer).len();
        }
        assert!(inside > 10_000 && outside > 10_000, "{inside} inside, {outside} outside");
    }
}
