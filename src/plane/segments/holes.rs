//! Marking hole faces: by points inside them, or what lies inside other things.

use crate::geometry::predicates::left_to_right;
use crate::ids::{EdgeId, Element, FaceId, HalfEdgeId, VertexId};
use crate::plane::sweep::{Intersection, NOTHING, sweep};
use crate::plane::{CoordinateError, Point, Subdivision};
use crate::topology::{InnerComponent, components};

/// Why points cannot mark hole faces.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MarkHolesError {
    /// A point whose coordinates cannot be used.
    #[error("hole point {index}: {error}")]
    Coordinate {
        /// Which of the points.
        index: u32,
        /// What is wrong with it.
        error: CoordinateError,
    },
    /// A point on an edge or a vertex.
    #[error("hole point {index}, {point}, lies on {element}, not inside a face")]
    NotInside {
        /// Which of the points.
        index: u32,
        /// The point.
        point: Point,
        /// The edge or vertex.
        element: Element,
    },
    /// A point in the outer face, which is no hole.
    #[error("hole point {index}, {point}, lies in the outer face")]
    Outside {
        /// Which of the points.
        index: u32,
        /// The point.
        point: Point,
    },
}

impl Subdivision {
    /// Makes the bounded faces around the points hole faces, as hole points of Triangle's `.poly` files do. Returns
    /// the face of each point.
    ///
    /// Cost: O((n + k) log (n + k)) for n edges and k points.
    ///
    /// # Errors
    /// [`MarkHolesError`]; then no face is marked.
    pub fn mark_holes(&mut self, points: &[Point]) -> Result<Vec<FaceId>, MarkHolesError> {
        for (index, point) in points.iter().enumerate() {
            point.check().map_err(|error| MarkHolesError::Coordinate { index: index as u32, error })?;
        }
        let own = self.points.len() as u32;
        let mut all = self.points.as_slice().to_vec();
        all.extend_from_slice(points);
        // Two points at one place are asked for once.
        let mut order: Vec<u32> = (own..all.len() as u32).collect();
        order.sort_by(|&p, &q| left_to_right(all[p as usize], all[q as usize]).then(p.cmp(&q)));
        let mut stands_for = vec![0; points.len()];
        for same in order.chunk_by(|&p, &q| all[p as usize] == all[q as usize]) {
            same.iter().for_each(|&p| stands_for[(p - own) as usize] = same[0]);
        }
        order.dedup_by(|q, p| all[*q as usize] == all[*p as usize]);
        order.extend(self.dcel.vertices().map(VertexId::number));
        let edges: Vec<EdgeId> = self.dcel.edges().collect();
        let ends: Vec<[u32; 2]> = edges.iter().map(|&e| self.edge_ends(e).map(VertexId::number)).collect();
        let swept = sweep(&all, &ends, &order, true);
        let on = |p: u32, element: Element| {
            let index = stands_for.iter().position(|&q| q == p).unwrap_or_default() as u32;
            MarkHolesError::NotInside { index, point: all[p as usize], element }
        };
        match swept.intersection {
            Some(Intersection::SamePlace(v, p)) => return Err(on(p.max(v), VertexId::new(v.min(p)).into())),
            Some(Intersection::PointOnEdge { point, edge }) => return Err(on(point, edges[edge as usize].into())),
            _ => {}
        }
        let mut faces = Vec::with_capacity(points.len());
        for (index, &p) in stands_for.iter().enumerate() {
            let face = match swept.below[p as usize] {
                NOTHING => self.outer_face(),
                edge => self.dcel.face(self.upper_half(edges[edge as usize])),
            };
            if face == self.outer_face() {
                return Err(MarkHolesError::Outside { index: index as u32, point: points[index] });
            }
            faces.push(face);
        }
        self.holes.extend(&faces);
        Ok(faces)
    }

    /// Makes hole faces of what lies directly inside something else: of the bounded faces of every component that lies
    /// in a bounded face, but not of what lies in those again, and so on. Returns the faces.
    ///
    /// ```text
    ///   ┌───────────────┐
    ///   │ f1  ┌───────┐ │      f1 is part of the domain,
    ///   │     │ f2 △f3│ │      f2 is a hole face,
    ///   │     └───────┘ │      f3 is part of the domain
    ///   └───────────────┘
    /// ```
    ///
    /// Cost: O(n) for n edges.
    pub fn mark_nested_holes(&mut self) -> Vec<FaceId> {
        let components = components(&self.dcel);
        let of = |h: HalfEdgeId| components.of(self.dcel.origin(h)).unwrap_or_default() as usize;
        let bounded = || self.dcel.faces().filter(|&f| f != self.outer_face());
        let mut inside: Vec<Vec<usize>> = vec![Vec::new(); components.count()];
        let mut is_inside = vec![false; components.count()];
        for f in bounded() {
            let Some(around) = self.dcel.half_edge(f) else { continue };
            for ring in self.inner_components(f) {
                if let &InnerComponent::Cycle(h) = ring {
                    inside[of(around)].push(of(h));
                    is_inside[of(h)] = true;
                }
            }
        }
        let mut is_odd = vec![false; components.count()];
        let mut open: Vec<usize> = (0..components.count()).filter(|&c| !is_inside[c]).collect();
        while let Some(around) = open.pop() {
            for &c in &inside[around] {
                is_odd[c] = !is_odd[around];
                open.push(c);
            }
        }
        let faces: Vec<FaceId> = bounded().filter(|&f| self.dcel.half_edge(f).is_some_and(|h| is_odd[of(h)])).collect();
        self.holes.extend(&faces);
        faces
    }
}
