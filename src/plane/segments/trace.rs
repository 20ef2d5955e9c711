//! From a plane graph to a subdivision: one-rings, links, cycles, inner components.
//!
//! ```text
//!        h4 ╲   ╱ h2        1. the sweep gives the half-edges round each vertex in their order, h0 h2 h4
//!            ╲ ╱            2. each corner is a link: next(twin(h2)) = h0, next(twin(h4)) = h2, ...
//!             ●── h0        3. the links close to cycles; a cycle whose corner at its leftmost vertex looks
//!                              to the left runs round something: an inner component. All others bound a face.
//!   ──●    ● inner component           4. an inner component or an isolated vertex lies in the face above the next edge below its
//!  ───────────── below         leftmost vertex.
//! ```
//!
//! Source: de Berg et al., *Computational Geometry*, 3rd ed., section 2.3.

use super::graph::Graph;
use crate::geometry::point::corners;
use crate::geometry::predicates::left_to_right;
use crate::ids::{EdgeId, FaceId, HalfEdgeId, MAX_IDS, VertexId};
use crate::plane::below::{FEW, edges_below};
use crate::plane::marks::Marks;
use crate::plane::rings::Loose;
use crate::plane::sweep::{Intersection, NOTHING, OneRing, Swept, sweep_in_order};
use crate::plane::{Point, Subdivision};
use crate::topology::{Columns, Dcel, InnerComponent, TooMany};

const NONE: u32 = Columns::NONE;

/// The half-edges of a graph with their origins; the links come one-ring by one-ring.
pub(super) struct OneRings {
    columns: Columns,
}

impl OneRings {
    /// No link yet.
    ///
    /// # Errors
    /// [`TooMany`] if the vertices or half-edges have no ids.
    pub(super) fn new(graph: &Graph) -> Result<Self, TooMany> {
        let Graph { points, edges, .. } = graph;
        if points.len() > MAX_IDS || 2 * edges.len() > MAX_IDS {
            return Err(TooMany);
        }
        let origin: Vec<u32> = edges.as_flattened().to_vec();
        let columns = Columns {
            next: vec![NONE; origin.len()],
            prev: vec![NONE; origin.len()],
            face: vec![NONE; origin.len()],
            outgoing: vec![NONE; points.len()],
            boundary: vec![NONE],
            origin,
        };
        Ok(Self { columns })
    }

    /// Links a one-ring. Counter-clockwise from straight down it begins with the half-edges to the right, upwards; then
    /// come those to the left, downwards.
    #[inline]
    pub(super) fn link(&mut self, one_ring: &OneRing<'_>) {
        self.link_all(one_ring.point, one_ring.right.iter().chain(one_ring.left.iter().rev()).copied());
    }

    /// Links the half-edges that leave a point, counter-clockwise from straight down.
    #[inline]
    pub(super) fn link_all(&mut self, point: u32, half_edges: impl Iterator<Item = u32>) {
        let mut last = None;
        for h in half_edges {
            match last.replace(h) {
                None => self.columns.outgoing[point as usize] = h,
                Some(before) => self.meet(before, h),
            }
        }
        if let Some(last) = last {
            self.meet(last, self.columns.outgoing[point as usize]);
        }
    }

    /// The half-edges with their links, but for their faces.
    pub(super) fn into_columns(self) -> Columns {
        self.columns
    }

    /// Of two half-edges of a one-ring the second follows the first, counter-clockwise.
    #[inline]
    fn meet(&mut self, g: u32, h: u32) {
        self.columns.next[(h ^ 1) as usize] = g;
        self.columns.prev[g as usize] = h ^ 1;
    }
}

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
/// The points are taken out of the graph.
///
/// Cost: O(n log n).
pub(super) fn trace(graph: &mut Graph, seen: Seen) -> Result<Subdivision, TooMany> {
    let (one_rings, below) = match seen {
        Seen::Swept { one_rings, below, .. } => (one_rings, Some(below)),
        Seen::OneRings(one_rings) => (one_rings, None),
        Seen::Made(subdivision) => return Ok(*subdivision),
    };
    let Graph { points, edges, order } = graph;
    let mut columns = one_rings.columns;
    let loose = cycles(&mut columns, points)?;
    let below = below.unwrap_or_else(|| below_of(&loose, &columns, points, edges, order.if_known()));
    let mut subdivision = Subdivision::from_parts(Dcel::from_columns(columns), std::mem::take(points).into());
    let edge_below = |v: VertexId| (below[v.index()] != NOTHING).then(|| EdgeId::new(below[v.index()]));
    let fits = |_: &Subdivision, _, _, _| Ok::<(), std::convert::Infallible>(());
    let Ok(()) = subdivision.place_inner_components(&loose, edge_below, fits);
    Ok(subdivision)
}

/// The edges below inner components as far as they tell in which face these lie: for what is in no bounded face there may be
/// none, and of the others those that no bounded face has beside it are left out.
fn below_of(
    loose: &[Loose],
    columns: &Columns,
    points: &[Point],
    edges: &[[u32; 2]],
    by_place: Option<&[u32]>,
) -> Vec<u32> {
    let leftmost = loose.iter().map(|loose| loose.leftmost.number());
    if loose.len() <= FEW {
        return edges_below(points, edges, by_place, leftmost);
    }
    let side = 2 * (loose.len() as f64).sqrt() as usize + 1;
    let mut bounded = Marks::new(corners(points.iter().copied()), side);
    for &start in &columns.boundary[1..] {
        let after = |h: &u32| Some(columns.next[*h as usize]).filter(|&h| h != start);
        let cycle = std::iter::successors(Some(start), after);
        bounded.mark(corners(cycle.map(|h| points[columns.origin[h as usize] as usize])));
    }
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
    let points = graph.points;
    let mut columns = one_rings.columns;
    let loose = cycles(&mut columns, &points)?;
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

/// Gives every half-edge its face, inner components for the time being `f0`. Returns the inner components and the isolated vertices.
fn cycles(columns: &mut Columns, points: &[Point]) -> Result<Vec<Loose>, TooMany> {
    let mut loose = Vec::new();
    for start in 0..columns.face.len() as u32 {
        if columns.face[start as usize] != NONE {
            continue;
        }
        let face = columns.boundary.len() as u32;
        // A corner behind the last half-edge of a one-ring looks down, and at a leftmost vertex therefore to the left.
        let (mut leftmost, mut looks_left) = (columns.origin[start as usize], false);
        let mut place = points[leftmost as usize];
        let (mut h, mut before) = (start, columns.prev[start as usize]);
        loop {
            columns.face[h as usize] = face;
            let v = columns.origin[h as usize];
            let here = points[v as usize];
            let order = left_to_right(here, place);
            if order.is_le() {
                let last = before ^ 1 == columns.outgoing[v as usize];
                looks_left = last || (order.is_eq() && looks_left);
                (leftmost, place) = (v, here);
            }
            (h, before) = (columns.next[h as usize], h);
            if h == start {
                break;
            }
        }
        if !looks_left {
            if columns.boundary.len() >= MAX_IDS {
                return Err(TooMany);
            }
            columns.boundary.push(start);
            continue;
        }
        let leftmost = VertexId::new(leftmost);
        loose.push(Loose { ring: InnerComponent::Cycle(HalfEdgeId::new(start)), leftmost, owner: None });
        loop {
            columns.face[h as usize] = 0;
            h = columns.next[h as usize];
            if h == start {
                break;
            }
        }
    }
    let isolated = columns.outgoing.iter().enumerate().filter(|&(_, &h)| h == NONE);
    loose.extend(isolated.map(|(v, _)| {
        let v = VertexId::new(v as u32);
        Loose { ring: InnerComponent::Isolated(v), leftmost: v, owner: None }
    }));
    Ok(loose)
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
