//! A part of a view: some faces, the half-edges round them and the vertices of those.
//!
//! ```text
//!   ┌────┬────┬────┐            ┌────┐
//!   │ f1 │ f2 │ f3 │   f2 only  │ f2 │     Pointers are as in the whole: those that leave the part name
//!   └────┴────┴────┘            └────┘     elements that are not drawn.
//! ```

use crate::figure::structure::skeleton::half_edges;
use crate::figure::{FigureError, FigureOptions};
use crate::ids::{FaceId, FaceMap, HalfEdgeId, VertexId, VertexMap};
use crate::plane::{PlanarView, Point};
use crate::topology::{InnerComponent, View};

/// What is drawn of a view: some faces, or all of it.
pub(crate) struct Part<'a> {
    whole: &'a dyn PlanarView,
    chosen: Option<Chosen>,
}

/// Some faces, and the vertices of those.
struct Chosen {
    faces: FaceMap<bool>,
    vertices: VertexMap<bool>,
}

impl<'a> Part<'a> {
    /// What the options choose of the view.
    ///
    /// # Errors
    /// [`FigureError::UnknownFace`].
    pub(crate) fn of(whole: &'a dyn PlanarView, options: &FigureOptions) -> Result<Self, FigureError> {
        options.faces.as_ref().map_or(Ok(Self { whole, chosen: None }), |chosen| Self::new(whole, chosen))
    }

    /// These faces. O(half-edges).
    ///
    /// # Errors
    /// [`FigureError::UnknownFace`].
    pub(crate) fn new(whole: &'a dyn PlanarView, chosen: &[FaceId]) -> Result<Self, FigureError> {
        let mut faces = FaceMap::filled(whole.face_bound(), false);
        let mut kept = VertexMap::filled(whole.vertex_bound(), false);
        for &face in chosen {
            if !whole.has_face(face) {
                let faces = crate::figure::structure::skeleton::faces(whole).count();
                return Err(FigureError::UnknownFace { face, faces });
            }
            faces[face] = true;
            let isolated = whole.inner_components(face).iter().filter_map(|ring| ring.isolated());
            isolated.filter(|&v| whole.has_vertex(v)).for_each(|v| kept[v] = true);
        }
        let edges = Self { whole, chosen: Some(Chosen { faces: faces.clone(), vertices: VertexMap::default() }) };
        for h in half_edges(&edges) {
            let ends = [whole.origin(h), crate::figure::structure::skeleton::destination(whole, h)];
            ends.into_iter().flatten().filter(|&v| whole.has_vertex(v)).for_each(|v| kept[v] = true);
        }
        Ok(Self { whole, chosen: Some(Chosen { faces, vertices: kept }) })
    }
}

impl View for Part<'_> {
    fn vertex_bound(&self) -> usize {
        self.whole.vertex_bound()
    }
    fn half_edge_bound(&self) -> usize {
        self.whole.half_edge_bound()
    }
    fn face_bound(&self) -> usize {
        self.whole.face_bound()
    }
    fn has_vertex(&self, v: VertexId) -> bool {
        let is_kept = |part: &Chosen| part.vertices.get(v).copied().unwrap_or(false);
        self.whole.has_vertex(v) && self.chosen.as_ref().is_none_or(is_kept)
    }
    fn has_half_edge(&self, h: HalfEdgeId) -> bool {
        let is_round = |_: &Chosen| self.whole.face(h).is_some_and(|f| self.has_face(f));
        self.whole.has_half_edge(h) && self.chosen.as_ref().is_none_or(is_round)
    }
    fn has_face(&self, f: FaceId) -> bool {
        let is_kept = |part: &Chosen| part.faces.get(f).copied().unwrap_or(false);
        self.chosen.as_ref().map_or_else(|| self.whole.has_face(f), is_kept)
    }
    fn origin(&self, h: HalfEdgeId) -> Option<VertexId> {
        self.whole.origin(h)
    }
    fn twin(&self, h: HalfEdgeId) -> Option<HalfEdgeId> {
        self.whole.twin(h)
    }
    fn next(&self, h: HalfEdgeId) -> Option<HalfEdgeId> {
        self.whole.next(h)
    }
    fn prev(&self, h: HalfEdgeId) -> Option<HalfEdgeId> {
        self.whole.prev(h)
    }
    fn face(&self, h: HalfEdgeId) -> Option<FaceId> {
        self.whole.face(h)
    }
    fn outgoing(&self, v: VertexId) -> Option<HalfEdgeId> {
        self.whole.outgoing(v)
    }
    fn half_edge(&self, f: FaceId) -> Option<HalfEdgeId> {
        self.whole.half_edge(f)
    }
    fn inner_components(&self, f: FaceId) -> &[InnerComponent] {
        self.whole.inner_components(f)
    }
    fn outer_face(&self) -> Option<FaceId> {
        self.whole.outer_face()
    }
    fn is_hole(&self, f: FaceId) -> bool {
        self.whole.is_hole(f)
    }
}

impl PlanarView for Part<'_> {
    fn position(&self, v: VertexId) -> Option<Point> {
        self.whole.position(v).filter(|_| self.chosen.is_none() || self.has_vertex(v))
    }
}
