//! The invariants of the plane: what must hold of the positions, beside the invariants of the structure.
//!
//! G1 to G3 are found by one sweep, which stops at the first fault; the others are only asked when they hold. Where most
//! faces are convex or have few sides, `proof.rs` shows with less that nothing is broken.

use super::cycle::by_direction;
use super::cycle::encloses;
use super::sweep::{Intersection, NOTHING, sweep};
use super::{Point, Subdivision};
use crate::geometry::both::of_both;
use crate::geometry::predicates::left_to_right;
use crate::ids::{EdgeId, Element, FaceId, HalfEdgeId, VertexId};
use crate::topology::{InnerComponent, Rule};

/// The invariants of the plane as data, in the order in which they are checked.
pub const GEOMETRY_RULES: &[Rule] = &[
    Rule {
        id: "G1",
        invariant: "no two vertices lie at the same place",
        explanation: "Two vertices with equal coordinates should be one vertex.",
    },
    Rule {
        id: "G2",
        invariant: "no vertex lies in the interior of an edge",
        explanation: "An edge that passes through a vertex must be split there.",
    },
    Rule {
        id: "G3",
        invariant: "no two edges cross or overlap",
        explanation: "Edges meet at common ends only. The sweep stops at the first fault, so one of G1 to G3 stands alone.",
    },
    Rule {
        id: "G4",
        invariant: "the half-edges at v follow each other counter-clockwise, once round",
        explanation: "Turning by h.prev.twin goes from direction to direction. Otherwise faces fold over each other.",
    },
    Rule {
        id: "G5",
        invariant: "the boundary of a bounded face runs counter-clockwise",
        explanation: "The face lies on the left of its half-edges.",
    },
    Rule {
        id: "G6",
        invariant: "an inner component, and every cycle of the outer face, runs clockwise",
        explanation: "An inner component goes round something that is cut out of the face.",
    },
    Rule {
        id: "G7",
        invariant: "every inner component lies in its face",
        explanation: "An island or an isolated vertex is listed by the face that surrounds it.",
    },
];

/// Positions that do not fit the structure, or each other.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum GeometryViolation {
    /// Two vertices with the same position.
    #[error("G1: {first} and {second} lie at the same place: use one vertex for both")]
    SamePlace {
        /// One vertex.
        first: VertexId,
        /// The other vertex.
        second: VertexId,
    },
    /// A vertex in the interior of an edge.
    #[error("G2: {vertex} lies on the edge {} -> {} but is not one of its ends: split the edge there", ends[0], ends[1])]
    VertexOnEdge {
        /// The vertex.
        vertex: VertexId,
        /// The ends of the edge.
        ends: [VertexId; 2],
    },
    /// Two edges that cross or overlap.
    #[error(
        "G3: the edges {} -> {} and {} -> {} cross or overlap",
        first[0], first[1], second[0], second[1]
    )]
    EdgesMeet {
        /// The ends of one edge.
        first: [VertexId; 2],
        /// The ends of the other edge.
        second: [VertexId; 2],
    },
    /// The half-edges at a vertex are linked in another order than that of their directions.
    #[error(
        "G4: the half-edges at {vertex} do not follow each other counter-clockwise: faces fold over each other there"
    )]
    Folded {
        /// The vertex.
        vertex: VertexId,
    },
    /// The boundary of a bounded face runs clockwise.
    #[error("G5: the boundary of {face}, from {start} on, does not run counter-clockwise")]
    BoundaryClockwise {
        /// The face.
        face: FaceId,
        /// Its boundary half-edge.
        start: HalfEdgeId,
    },
    /// An inner component, or a cycle of the outer face, runs counter-clockwise.
    #[error("G6: the cycle of {start} surrounds a bounded region, so it cannot be an inner component of {face}")]
    RingCounterClockwise {
        /// The face.
        face: FaceId,
        /// A half-edge of the cycle.
        start: HalfEdgeId,
    },
    /// An inner component lies in another face than the one that lists it.
    #[error("G7: the inner component at {vertex} is listed by {listed} but lies in {face}")]
    RingElsewhere {
        /// The leftmost vertex of the inner component.
        vertex: VertexId,
        /// The face that lists it.
        listed: FaceId,
        /// The face it lies in.
        face: FaceId,
    },
}

impl GeometryViolation {
    /// The invariant that is broken.
    #[must_use]
    pub const fn rule(&self) -> &'static Rule {
        match self {
            Self::SamePlace { .. } => &GEOMETRY_RULES[0],
            Self::VertexOnEdge { .. } => &GEOMETRY_RULES[1],
            Self::EdgesMeet { .. } => &GEOMETRY_RULES[2],
            Self::Folded { .. } => &GEOMETRY_RULES[3],
            Self::BoundaryClockwise { .. } => &GEOMETRY_RULES[4],
            Self::RingCounterClockwise { .. } => &GEOMETRY_RULES[5],
            Self::RingElsewhere { .. } => &GEOMETRY_RULES[6],
        }
    }

    /// The faces and half-edges the message speaks of.
    #[must_use]
    pub fn other_elements(&self) -> Vec<Element> {
        match *self {
            Self::BoundaryClockwise { face, start } | Self::RingCounterClockwise { face, start } => {
                vec![face.into(), start.into()]
            }
            Self::RingElsewhere { listed, face, .. } => vec![listed.into(), face.into()],
            Self::SamePlace { .. } | Self::VertexOnEdge { .. } | Self::EdgesMeet { .. } | Self::Folded { .. } => {
                Vec::new()
            }
        }
    }

    /// The vertices the message speaks of.
    #[must_use]
    pub fn vertices(&self) -> Vec<VertexId> {
        match *self {
            Self::SamePlace { first, second } => vec![first, second],
            Self::VertexOnEdge { vertex, ends } => vec![vertex, ends[0], ends[1]],
            Self::EdgesMeet { first, second } => vec![first[0], first[1], second[0], second[1]],
            Self::Folded { vertex } | Self::RingElsewhere { vertex, .. } => vec![vertex],
            Self::BoundaryClockwise { .. } | Self::RingCounterClockwise { .. } => Vec::new(),
        }
    }
}

impl Subdivision {
    /// Checks the invariants of the plane, all positions and edges against each other:
    ///
    /// | invariant | says |
    /// |---|---|
    /// | G1 | no two vertices lie at the same place |
    /// | G2 | no vertex lies in the interior of an edge |
    /// | G3 | no two edges cross or overlap |
    /// | G4 | round each vertex the half-edges follow each other counter-clockwise, once round |
    /// | G5 | the boundary of a bounded face runs counter-clockwise round it |
    /// | G6 | every other cycle of a face, and every cycle of `f0`, runs clockwise round what it cuts out |
    /// | G7 | every inner component lies in its face |
    ///
    /// The first intersection of elements (G1 to G3) is reported alone; otherwise all other faults.
    ///
    /// Cost: O(n) with n edges, and O(k log k) for the k of them that do not lie between two convex faces; O(n log n) where
    /// those are most of all, or something is broken. All decisions exact.
    #[must_use]
    pub fn geometry_violations(&self) -> Vec<GeometryViolation> {
        if self.is_proved_plane() { Vec::new() } else { self.swept_violations() }
    }

    /// What one sweep over all edges finds.
    pub(super) fn swept_violations(&self) -> Vec<GeometryViolation> {
        let edges: Vec<EdgeId> = self.dcel.edges().collect();
        let ends: Vec<[u32; 2]> = edges.iter().map(|&e| self.edge_ends(e).map(VertexId::number)).collect();
        let extra: Vec<u32> =
            self.dcel.vertices().filter(|&v| self.dcel.outgoing(v).is_none()).map(VertexId::number).collect();
        let swept = sweep(self.points.as_slice(), &ends, &extra, true);
        if let Some(intersection) = swept.intersection {
            return vec![name_intersection(intersection, &ends)];
        }
        let mut found: Vec<_> = self
            .dcel
            .vertices()
            .filter(|&v| !self.turns_once(v))
            .map(|vertex| GeometryViolation::Folded { vertex })
            .collect();
        for face in self.dcel.faces() {
            self.check_cycles(face, &edges, &swept.below, &mut found);
        }
        found
    }

    /// The first intersection of the edges with each other and with vertices that have edges (G1 to G3).
    pub(super) fn intersection(&self) -> Option<GeometryViolation> {
        let ends: Vec<[u32; 2]> = self.dcel.edges().map(|e| self.edge_ends(e).map(VertexId::number)).collect();
        sweep(self.points.as_slice(), &ends, &[], true)
            .intersection
            .map(|intersection| name_intersection(intersection, &ends))
    }

    pub(super) fn edge_ends(&self, e: EdgeId) -> [VertexId; 2] {
        of_both(e.half_edges(), |h| self.dcel.origin(h))
    }

    /// The half of `e` that runs from left to right, with the upper side on its left.
    pub(super) fn upper_half(&self, e: EdgeId) -> HalfEdgeId {
        let [h, t] = e.half_edges();
        let [p, q] = self.edge_ends(e).map(|v| self.points[v]);
        if left_to_right(p, q).is_lt() { h } else { t }
    }

    /// The leftmost vertex of the cycle of `h`.
    pub(super) fn leftmost(&self, h: HalfEdgeId) -> VertexId {
        let by_place = |&u: &VertexId, &v: &VertexId| left_to_right(self.points[u], self.points[v]);
        self.dcel.cycle(h).map(|h| self.dcel.origin(h)).min_by(by_place).unwrap_or_else(|| self.dcel.origin(h))
    }

    /// Whether the directions round `v` increase, with just one step back to the start.
    pub(super) fn turns_once(&self, v: VertexId) -> bool {
        let place = |h: HalfEdgeId| -> Point { self.points[self.dcel.destination(h)] };
        let mut steps_back = 0;
        for h in self.dcel.outgoing_half_edges(v) {
            if by_direction(self.points[v], place(h), place(self.dcel.ccw(h))).is_ge() {
                steps_back += 1;
            }
        }
        steps_back <= 1
    }

    /// The faults of the cycles of a face; `below` tells which of the edges lies directly below each vertex.
    pub(super) fn check_cycles(
        &self,
        face: FaceId,
        edges: &[EdgeId],
        below: &[u32],
        found: &mut Vec<GeometryViolation>,
    ) {
        let outer = face == self.outer_face();
        let boundary = self.dcel.half_edge(face);
        if let Some(start) = boundary.filter(|&start| !outer && !encloses(self.corner_points(start))) {
            found.push(GeometryViolation::BoundaryClockwise { face, start });
        }
        let first = boundary.filter(|_| outer).map(InnerComponent::Cycle);
        for ring in first.into_iter().chain(self.inner_components(face).iter().copied()) {
            let vertex = match ring {
                InnerComponent::Isolated(v) => v,
                InnerComponent::Cycle(start) if encloses(self.corner_points(start)) => {
                    found.push(GeometryViolation::RingCounterClockwise { face, start });
                    continue;
                }
                InnerComponent::Cycle(start) => self.leftmost(start),
            };
            let lies_in = match below[vertex.index()] {
                NOTHING => self.outer_face(),
                edge => self.dcel.face(self.upper_half(edges[edge as usize])),
            };
            if lies_in != face {
                found.push(GeometryViolation::RingElsewhere { vertex, listed: face, face: lies_in });
            }
        }
    }
}

fn name_intersection(intersection: Intersection, ends: &[[u32; 2]]) -> GeometryViolation {
    let edge = |e: u32| ends[e as usize].map(VertexId::new);
    match intersection {
        Intersection::SamePlace(a, b) => {
            GeometryViolation::SamePlace { first: VertexId::new(a), second: VertexId::new(b) }
        }
        Intersection::PointOnEdge { point, edge: e } => {
            GeometryViolation::VertexOnEdge { vertex: VertexId::new(point), ends: edge(e) }
        }
        Intersection::Crossing(a, b) | Intersection::Overlap(a, b) => {
            GeometryViolation::EdgesMeet { first: edge(a), second: edge(b) }
        }
    }
}
