//! The subdivision of some of the edges of another: nothing is sorted by angle or searched for again.
//!
//! ```text
//!        h4 ╲   ╱ h2  ✗     the one-ring is that of before without what goes     the faces at an edge that goes are one
//!            ╲ ╱            h0 h2 h4  ->  h0 h4                                  face now: so each cycle knows its face
//!             ●── h0
//! ```

use super::graph::{Graph, Order};
use super::one_rings::OneRings;
use super::trace::trace_known;
use crate::geometry::both::of_both;
use crate::geometry::grouping::Joined;
use crate::ids::{EdgeId, FaceId, HalfEdgeId, VertexId};
use crate::plane::{Point, Subdivision};
use crate::topology::TooMany;

/// Says that an edge goes.
const GONE: u32 = u32::MAX;

impl Subdivision {
    /// The subdivision of the given edges, which are in increasing order, and of the vertices at them. Edge i runs as
    /// `edges[i]`; all numbers are as those of [`from_graph`](Self::from_graph).
    ///
    /// Cost: O(n), apart from the order of inner components from left to right.
    pub(in crate::plane) fn part(&self, edges: &[EdgeId]) -> Result<Self, TooMany> {
        let mut new_edge = vec![GONE; self.dcel.edge_bound()];
        edges.iter().enumerate().for_each(|(i, e)| new_edge[e.index()] = i as u32);
        let new_half = |h: HalfEdgeId| match new_edge[h.edge().index()] {
            GONE => None,
            e => Some(2 * e + (h.number() & 1)),
        };
        let mut number = vec![GONE; self.dcel.vertex_bound()];
        edges.iter().flat_map(|&e| self.edge_ends(e)).for_each(|v| number[v.index()] = 0);
        let mut points: Vec<Point> = Vec::new();
        let mut stored: Vec<HalfEdgeId> = Vec::new();
        for (v, number) in (0..).map(VertexId::new).zip(&mut number).filter(|(_, number)| **number != GONE) {
            *number = points.len() as u32;
            points.push(self.points[v]);
            // There is one: an edge ends here.
            stored.extend(self.dcel.outgoing(v));
        }
        let ends = edges.iter().map(|&e| of_both(self.edge_ends(e), |v| number[v.index()])).collect();
        let graph = Graph { points, edges: ends, order: Order::default() };

        // Half-edge by half-edge, not vertex by vertex: no step waits for the one before.
        let mut one_rings = OneRings::new(&graph)?;
        let stays_from = |mut h: HalfEdgeId, on: fn(&Self, HalfEdgeId) -> HalfEdgeId| loop {
            match new_half(h) {
                Some(new) => break new,
                None => h = on(self, h),
            }
        };
        let clockwise = |s: &Self, h: HalfEdgeId| s.dcel.next(h.twin());
        let counter_clockwise = |s: &Self, h: HalfEdgeId| s.dcel.prev(h).twin();
        for (new, h) in (0..).zip(edges.iter().flat_map(|e| e.half_edges())) {
            one_rings.meet(stays_from(clockwise(self, h), clockwise), new);
        }
        for (v, &stored) in (0..).zip(&stored) {
            one_rings.begin(v, stays_from(stored, counter_clockwise));
        }
        one_rings.begin_straight_down(&graph);

        let mut joined = Joined::none(self.dcel.face_bound());
        for e in self.dcel.edges().filter(|e| new_edge[e.index()] == GONE) {
            let [f, g] = of_both(e.half_edges(), |h| self.dcel.face(h).number());
            joined.join(f, g);
        }
        let old_face = |h: u32| self.dcel.face(edges[h as usize >> 1].half_edges()[h as usize & 1]);
        // The new face of each set of old ones, once it is asked for.
        let mut new_face: Vec<FaceId> = Vec::new();
        trace_known(graph, one_rings, |boundary, h| {
            if new_face.is_empty() {
                new_face = vec![FaceId::new(0); self.dcel.face_bound()];
                for (f, &first) in (0..).map(FaceId::new).zip(boundary).skip(1) {
                    new_face[joined.root(old_face(first).number()) as usize] = f;
                }
            }
            new_face[joined.root(old_face(h).number()) as usize]
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plane::ArrangeOptions;

    fn random() -> impl FnMut(u64) -> u64 {
        let mut state = 3_u64;
        move |n| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 33) % n
        }
    }

    /// Segments of a small grid, many of them through one point, and squares within squares.
    fn arranged(below: &mut impl FnMut(u64) -> u64, count: u64) -> Subdivision {
        let mut place = || Point::new(below(12) as f64, below(12) as f64 * 1.1);
        let mut segments: Vec<[Point; 2]> = (0..count).map(|_| [place(), place()]).collect();
        for ring in 0..4 {
            let (low, high) = (f64::from(ring) + 0.25, 11.5 - f64::from(ring));
            let corners = [(low, low), (high, low), (high, high), (low, high)].map(Point::from);
            segments.extend((0..4).map(|i| [corners[i], corners[(i + 1) % 4]]));
        }
        let options = ArrangeOptions { merge: true, split: true, ..ArrangeOptions::default() };
        Subdivision::arrange_segments(&segments, &options).unwrap().subdivision
    }

    /// The same by sorting and sweeping anew.
    fn anew(s: &Subdivision, edges: &[EdgeId]) -> Subdivision {
        let stays = |v: &VertexId| edges.iter().any(|&e| s.edge_ends(e).contains(v));
        let vertices: Vec<VertexId> = s.dcel.vertices().filter(stays).collect();
        let points: Vec<Point> = vertices.iter().map(|&v| s.points[v]).collect();
        let number = |v| vertices.binary_search(&v).unwrap() as u32;
        let ends: Vec<[u32; 2]> = edges.iter().map(|&e| s.edge_ends(e).map(number)).collect();
        Subdivision::from_graph(&points, &ends).unwrap()
    }

    #[test]
    fn a_part_is_what_its_edges_give_by_themselves() {
        let mut below = random();
        let (mut nested, mut turned) = (0, 0);
        for round in 0..400 {
            let count = below(24);
            let mut s = arranged(&mut below, count);
            if round % 3 == 0 {
                // Other stored half-edges.
                for v in s.dcel.vertices().collect::<Vec<_>>() {
                    let all: Vec<HalfEdgeId> = s.dcel.outgoing_half_edges(v).collect();
                    let stored = all[below(all.len() as u64) as usize];
                    s.dcel.set_outgoing(v, Some(stored), &mut crate::topology::NoRecorder);
                    turned += usize::from(stored != all[0]);
                }
            }
            let share = 1 + below(9);
            // Edges by themselves, or those at which a face that was chosen meets one that was not.
            let chosen: Vec<bool> = (0..s.dcel.face_bound()).map(|f| f > 0 && below(10) < share).collect();
            let sides = |e: EdgeId| e.half_edges().map(|h| chosen[s.dcel.face(h).index()]);
            let mut stays = |&e: &EdgeId| if round % 2 == 0 { below(10) < share } else { sides(e)[0] != sides(e)[1] };
            let edges: Vec<EdgeId> = s.dcel.edges().filter(&mut stays).collect();
            let part = s.part(&edges).unwrap();
            assert_eq!(part, anew(&s, &edges), "round {round}");
            assert_eq!(part.geometry_violations(), [], "round {round}");
            nested += part.dcel.faces().skip(1).map(|f| part.inner_components(f).len()).sum::<usize>();
        }
        assert!(nested > 200 && turned > 400, "{nested} {turned}");
    }
}
