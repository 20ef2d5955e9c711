//! Joining two edges of a subdivision by taking away the vertex between them.
//!
//! ```text
//!             m
//!   u ●──h──>●── c ──> ● w     ==>     u ● ─────────── h ────────> ● w
//!
//!   If m is a real corner, the edge moves over the triangle u, m, w, in which nothing may lie.
//! ```

use super::Obstacle;
use crate::ids::{Element, HalfEdgeId, VertexId};
use crate::plane::cycle::on_segment;
use crate::plane::{PlaneRecorder, Subdivision};
use crate::topology::{self, NoRecorder};

/// Why the vertex at the end of a half-edge cannot be taken away.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum JoinEdgesError {
    /// The vertex does not join exactly two edges.
    #[error(transparent)]
    Topology(#[from] topology::JoinEdgesError),
    /// The two outer ends are joined by another edge already.
    #[error("without {vertex}, {h} would fall on {existing}")]
    EdgeExists {
        /// The half-edge.
        h: HalfEdgeId,
        /// The vertex that was to go.
        vertex: VertexId,
        /// A half-edge of the edge between the outer ends.
        existing: HalfEdgeId,
    },
    /// Stretched straight, the edge would meet another element.
    #[error("without {vertex}, {h} would run into {obstacle}")]
    WouldCross {
        /// The half-edge.
        h: HalfEdgeId,
        /// The vertex that was to go.
        vertex: VertexId,
        /// The vertex or half-edge in the way.
        obstacle: Element,
    },
}

impl Subdivision {
    /// Whether [`join_edges`](Self::join_edges) would succeed, and if not, why. Changes nothing.
    ///
    /// Cost: O(degree of the ends) if the vertex lies exactly between them, else O(size of the two faces).
    pub fn can_join_edges(&self, h: HalfEdgeId) -> Result<(), JoinEdgesError> {
        self.dcel.can_join_edges(h)?;
        let vertex = self.dcel.destination(h);
        let ends = [self.dcel.origin(h), self.dcel.destination(self.dcel.next(h))];
        if let Some(existing) = self.dcel.find_half_edge(ends[0], ends[1]) {
            return Err(JoinEdgesError::EdgeExists { h, vertex, existing });
        }
        let [from, to] = ends.map(|v| self.points[v]);
        if on_segment(from, to, self.points[vertex]) {
            return Ok(());
        }
        match self.obstacle_in_triangle(h, [from, self.points[vertex], to]) {
            None => Ok(()),
            Some(Obstacle::Vertex(v)) => Err(JoinEdgesError::WouldCross { h, vertex, obstacle: v.into() }),
            Some(Obstacle::Edge(g)) => Err(JoinEdgesError::WouldCross { h, vertex, obstacle: g.into() }),
        }
    }

    /// Takes away the destination of `h`, which must have degree 2: `h` then runs straight on to where
    /// `next(h)` led. Returns the removed vertex.
    ///
    /// Cost: as [`can_join_edges`](Self::can_join_edges), and O(number of inner components) of the two faces.
    ///
    /// # Errors
    /// See [`JoinEdgesError`]; a refused call leaves everything bit for bit as it was.
    pub fn join_edges(&mut self, h: HalfEdgeId) -> Result<VertexId, JoinEdgesError> {
        self.join_edges_with(h, &mut NoRecorder)
    }

    /// [`join_edges`](Self::join_edges), watched by a recorder.
    pub fn join_edges_with(&mut self, h: HalfEdgeId, rec: &mut impl PlaneRecorder) -> Result<VertexId, JoinEdgesError> {
        self.can_join_edges(h)?;
        let goes = self.dcel.next(h);
        for (gone, stays) in [(goes, h), (goes.twin(), h.twin())] {
            self.rename_inner_component(self.dcel.face(gone), [gone, stays], rec);
        }
        Ok(self.dcel.join_edges_unchecked(h, rec))
    }
}
