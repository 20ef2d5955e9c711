//! A half-edge table with every pointer written out, as on a lecture slide or dumped from a program.

use super::view::{InnerComponent, View};
use crate::ids::{FaceId, HalfEdgeId, VertexId};

/// A row of the half-edge table. A missing pointer is `None`.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default)]
pub struct HalfEdgeRow {
    /// The vertex it starts at.
    pub origin: Option<VertexId>,
    /// The other half.
    pub twin: Option<HalfEdgeId>,
    /// The one after it.
    pub next: Option<HalfEdgeId>,
    /// The one before it.
    pub prev: Option<HalfEdgeId>,
    /// The face on its left.
    pub face: Option<FaceId>,
}

/// A row of the vertex table.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct VertexRow {
    /// x and y, if the table has positions.
    pub position: Option<[f64; 2]>,
    /// A half-edge that starts here.
    pub outgoing: Option<HalfEdgeId>,
}

/// A row of the face table.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct FaceRow {
    /// A half-edge of the first boundary cycle.
    pub half_edge: Option<HalfEdgeId>,
    /// The other cycles and the isolated vertices inside.
    pub inner_components: Vec<InnerComponent>,
    /// Whether it is a bounded face outside the domain.
    pub hole: bool,
    /// A name for people.
    pub name: Option<String>,
}

/// A whole half-edge structure as three tables. It holds anything, right or wrong; rows that do not exist
/// are `None`.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Table {
    /// The vertices by number.
    pub vertices: Vec<Option<VertexRow>>,
    /// The half-edges by number.
    pub half_edges: Vec<Option<HalfEdgeRow>>,
    /// The faces by number.
    pub faces: Vec<Option<FaceRow>>,
    /// The unbounded face, if there is one.
    pub outer_face: Option<FaceId>,
}

impl HalfEdgeRow {
    /// What a view says of a half-edge, if it has this one.
    pub(super) fn of<V: View + ?Sized>(view: &V, h: HalfEdgeId) -> Option<Self> {
        view.has_half_edge(h).then(|| Self {
            origin: view.origin(h),
            twin: view.twin(h),
            next: view.next(h),
            prev: view.prev(h),
            face: view.face(h),
        })
    }
}

impl Table {
    /// Copies the pointers of a view; positions and names are left empty.
    pub fn from_view<V: View + ?Sized>(view: &V) -> Self {
        let vertex = |v| view.has_vertex(v).then(|| VertexRow { position: None, outgoing: view.outgoing(v) });
        let face = |f| {
            view.has_face(f).then(|| FaceRow {
                half_edge: view.half_edge(f),
                inner_components: view.inner_components(f).to_vec(),
                hole: view.is_hole(f),
                name: None,
            })
        };
        Self {
            vertices: (0..view.vertex_bound() as u32).map(|i| vertex(VertexId(i))).collect(),
            half_edges: (0..view.half_edge_bound() as u32).map(|i| HalfEdgeRow::of(view, HalfEdgeId(i))).collect(),
            faces: (0..view.face_bound() as u32).map(|i| face(FaceId(i))).collect(),
            outer_face: view.outer_face(),
        }
    }

    fn row(&self, h: HalfEdgeId) -> Option<&HalfEdgeRow> {
        self.half_edges.get(h.index())?.as_ref()
    }

    fn face_row(&self, f: FaceId) -> Option<&FaceRow> {
        self.faces.get(f.index())?.as_ref()
    }
}

impl View for Table {
    fn vertex_bound(&self) -> usize {
        self.vertices.len()
    }
    fn half_edge_bound(&self) -> usize {
        self.half_edges.len()
    }
    fn face_bound(&self) -> usize {
        self.faces.len()
    }
    fn has_vertex(&self, v: VertexId) -> bool {
        self.vertices.get(v.index()).is_some_and(Option::is_some)
    }
    fn has_half_edge(&self, h: HalfEdgeId) -> bool {
        self.row(h).is_some()
    }
    fn has_face(&self, f: FaceId) -> bool {
        self.face_row(f).is_some()
    }
    fn origin(&self, h: HalfEdgeId) -> Option<VertexId> {
        self.row(h)?.origin
    }
    fn twin(&self, h: HalfEdgeId) -> Option<HalfEdgeId> {
        self.row(h)?.twin
    }
    fn next(&self, h: HalfEdgeId) -> Option<HalfEdgeId> {
        self.row(h)?.next
    }
    fn prev(&self, h: HalfEdgeId) -> Option<HalfEdgeId> {
        self.row(h)?.prev
    }
    fn face(&self, h: HalfEdgeId) -> Option<FaceId> {
        self.row(h)?.face
    }
    fn outgoing(&self, v: VertexId) -> Option<HalfEdgeId> {
        self.vertices.get(v.index())?.as_ref()?.outgoing
    }
    fn half_edge(&self, f: FaceId) -> Option<HalfEdgeId> {
        self.face_row(f)?.half_edge
    }
    fn inner_components(&self, f: FaceId) -> &[InnerComponent] {
        self.face_row(f).map_or(&[], |row| &row.inner_components)
    }
    fn outer_face(&self) -> Option<FaceId> {
        self.outer_face
    }
    fn is_hole(&self, f: FaceId) -> bool {
        self.face_row(f).is_some_and(|row| row.hole)
    }
}
