//! The dual: faces become vertices, vertices become faces, and every edge crosses its own dual.
//!
//! ```text
//!        ●───────●───────●              dual(h) runs from the left of h to its right:
//!        │   f   │   g   │
//!        │   ◦ ─ h*─>◦   │              origin(h*) = face(h)              next(h*) = prev(twin(h))*
//!        │       h       │              face(h*)   = destination(h)       prev(h*) = twin(next(h))*
//!        ●───────●───────●              twin(h*)   = twin(h)*
//! ```
//!
//! All numbers are kept: h* is called h, the vertex of a face f3 is v3, the face round a vertex v5 is f5. The dual of
//! the dual is the structure again, with each half-edge turned round: h** runs as twin(h).
//!
//! Source: Guibas and Stolfi, *Primitives for the manipulation of general subdivisions and the computation of Voronoi
//! diagrams*, ACM Transactions on Graphics 4, 1985.

use super::Dcel;
use super::links::Columns;
use super::record::NoRecorder;
use crate::ids::{EdgeId, FaceId, HalfEdgeId, VertexId};

/// Why a structure has no dual.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum DualError {
    /// A face has more than one boundary cycle, so the edges round its dual vertex have no order.
    #[error("{face} has a second boundary cycle, through {half_edge}: join the two by an edge first")]
    SecondCycle {
        /// The face.
        face: FaceId,
        /// A half-edge of a cycle beside its first one.
        half_edge: HalfEdgeId,
    },
    /// A vertex has no edges, so its dual face would have no boundary.
    #[error("{vertex} has no edge: join it to another vertex, or remove it, first")]
    IsolatedVertex {
        /// The vertex.
        vertex: VertexId,
    },
    /// A face has no boundary, so its dual vertex would have no edges.
    #[error("{face} has no boundary: there is nothing that its dual could be joined to")]
    NoBoundary {
        /// The face.
        face: FaceId,
    },
}

impl Dcel {
    /// The dual structure: a vertex for every face, the outer face of a subdivision included, a face for every vertex,
    /// and for every half-edge h one of the same name that runs from the vertex of its left face to that of its right
    /// one.
    ///
    #[doc = include_str!("../../figures/dual.svg")]
    ///
    /// Loops and parallel edges are usual: the dual of a dangling edge is a loop. The dual of the dual is the same
    /// structure with every half-edge turned round, so that `h` is what `twin(h)` was.
    ///
    /// Cost: O(V + E + F).
    ///
    /// # Errors
    /// [`DualError`]: every face must have exactly one boundary cycle, every vertex an edge.
    ///
    /// ```
    /// use dcel_kit::topology::{Dcel, isomorphic};
    /// let triangle = Dcel::polygon(3)?;
    /// let dual = triangle.dual()?; // two vertices joined by three edges
    /// assert_eq!((dual.vertex_count(), dual.edge_count(), dual.face_count()), (2, 3, 3));
    /// assert!(isomorphic(&dual.dual()?, &triangle).is_ok());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn dual(&self) -> Result<Self, DualError> {
        self.check_dual()?;
        let edges = self.edge_bound() as u32;
        let column = |value: &dyn Fn(HalfEdgeId) -> u32| -> Vec<u32> {
            let half_edges = (0..2 * edges).map(HalfEdgeId::new);
            half_edges.map(|h| if self.has_half_edge(h) { value(h) } else { Columns::NONE }).collect()
        };
        let number = |h: Option<HalfEdgeId>| h.map_or(Columns::NONE, HalfEdgeId::number);
        let (vertices, faces) = (self.vertex_bound() as u32, self.face_bound() as u32);
        let boundary = |f| if self.has_face(f) { self.half_edge(f) } else { None };
        let outgoing = |v| if self.has_vertex(v) { self.outgoing(v) } else { None };
        let mut dual = Self::from_columns(Columns {
            origin: column(&|h| self.face(h).number()),
            next: column(&|h| self.prev(h.twin()).number()),
            prev: column(&|h| self.next(h).twin().number()),
            face: column(&|h| self.destination(h).number()),
            outgoing: (0..faces).map(FaceId::new).map(|f| number(boundary(f))).collect(),
            boundary: (0..vertices).map(VertexId::new).map(|v| number(outgoing(v).map(HalfEdgeId::twin))).collect(),
        });
        // What is free here is free there; from the last one on, so that the lowest is given out first.
        let rec = &mut NoRecorder;
        (0..faces).rev().map(VertexId::new).filter(|v| !self.has_face(FaceId::new(v.number()))).for_each(|v| {
            dual.remove_vertex_record(v, rec);
        });
        (0..vertices).rev().map(FaceId::new).filter(|f| !self.has_vertex(VertexId::new(f.number()))).for_each(|f| {
            dual.remove_face_record(f, rec);
        });
        (0..edges).rev().map(EdgeId::new).filter(|&e| !self.has_edge(e)).for_each(|e| {
            dual.remove_edge_record(e, rec);
        });
        Ok(dual)
    }

    fn check_dual(&self) -> Result<(), DualError> {
        if let Some(vertex) = self.vertices().find(|&v| self.outgoing(v).is_none()) {
            return Err(DualError::IsolatedVertex { vertex });
        }
        let mut seen = vec![false; self.half_edge_bound()];
        for face in self.faces() {
            let start = self.half_edge(face).ok_or(DualError::NoBoundary { face })?;
            self.cycle(start).for_each(|h| seen[h.index()] = true);
        }
        match self.half_edges().find(|h| !seen[h.index()]) {
            Some(half_edge) => Err(DualError::SecondCycle { face: self.face(half_edge), half_edge }),
            None => Ok(()),
        }
    }
}
