//! Collapsing an edge of a surface, so that its holes stay open and apart.
//!
//! ```text
//!      ●───────●                a hole of three edges: without a ╲ b the kernel would close it,
//!       ╲     ╱  surface        for there it is a triangle like any other
//!        ╲   ╱ hole
//!         ╲ ╱                   hole ● a ──── b ● hole    two holes would touch in one vertex
//!          ●
//! ```
//!
//! The link condition of a surface with borders: let an apex stand over each border, joined to all of it, and all
//! apexes be one. Then a border edge has the apex in its link, and ends that both lie on borders have it in common.
//!
//! Source: Dey, Edelsbrunner, Guha and Nekhayev, *Topology preserving edge contraction*, 1999, section on boundaries.

use crate::ids::{FaceId, HalfEdgeId, VertexId};
use crate::solid::Polyhedron;
use crate::solid::surface_journal::SurfaceRecorder;
use crate::topology::{CollapseEdgeError, NoRecorder};

/// Why an edge of a surface cannot be collapsed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum CollapseError {
    /// The structure forbids it.
    #[error(transparent)]
    Topology(#[from] CollapseEdgeError),
    /// The edge is one of three round a hole.
    #[error(
        "{h} is one of the three edges round the hole {boundary_face}, which would close: fill it by add_face first"
    )]
    ClosesHole {
        /// The half-edge.
        h: HalfEdgeId,
        /// The face that stands for the hole.
        boundary_face: FaceId,
    },
    /// Both ends lie on borders, and the edge does not.
    #[error("both ends of {h} lie on borders, {} and {}, which would touch in one vertex; collapse another edge", borders[0], borders[1])]
    JoinsBorders {
        /// The half-edge.
        h: HalfEdgeId,
        /// A boundary face at its origin, and one at its destination.
        borders: [FaceId; 2],
    },
}

impl Polyhedron {
    /// Whether [`collapse_edge`](Self::collapse_edge) would succeed, and if not, why. Changes nothing.
    pub fn can_collapse_edge(&self, h: HalfEdgeId) -> Result<(), CollapseError> {
        self.dcel.check(h).map_err(CollapseEdgeError::from)?;
        let sides = [h, h.twin()];
        let three = |h| self.dcel.cycle(h).take(4).count() == 3;
        if let Some(hole) = sides.into_iter().find(|&side| self.is_border(side) && three(side)) {
            return Err(CollapseError::ClosesHole { h, boundary_face: self.dcel.face(hole) });
        }
        let border_at = |side: HalfEdgeId| self.dcel.star(side).find(|&g| self.is_border(g)).map(|g| self.dcel.face(g));
        if let ([Some(from), Some(to)], false) = (sides.map(border_at), sides.iter().any(|&side| self.is_border(side)))
        {
            return Err(CollapseError::JoinsBorders { h, borders: [from, to] });
        }
        Ok(self.dcel.can_collapse_edge(h)?)
    }

    /// Takes away the edge of `h`, its destination, and the triangles beside it, if the link condition holds, borders
    /// included. Returns the removed vertex; the origin of `h` stays, and stays where it is. See
    /// [`Dcel::collapse_edge`](crate::topology::Dcel::collapse_edge).
    ///
    /// Cost: O((d + e) log d) for the degrees d <= e of the two ends.
    ///
    /// # Errors
    /// [`CollapseError`]; a refused call leaves everything bit for bit as it was.
    pub fn collapse_edge(&mut self, h: HalfEdgeId) -> Result<VertexId, CollapseError> {
        self.collapse_edge_with(h, &mut NoRecorder)
    }

    /// [`collapse_edge`](Self::collapse_edge), watched by a recorder.
    pub fn collapse_edge_with(
        &mut self,
        h: HalfEdgeId,
        rec: &mut impl SurfaceRecorder,
    ) -> Result<VertexId, CollapseError> {
        self.can_collapse_edge(h)?;
        Ok(self.dcel.collapse_edge_with(h, rec)?)
    }
}
