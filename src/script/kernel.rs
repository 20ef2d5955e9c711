//! Scripts without coordinates: the edits of the kernel, and what they start from.
//!
//! ```text
//!   torus                             # one vertex, one face, two loops
//!   let a = split_vertex h0 h1        # a: from the old vertex to the new one
//!   split_face a h2                   # loops and parallel edges are legal here
//! ```

use super::edit::{EditKind, Returned};
use super::ground::Call;
use crate::ids::{Element, HalfEdgeId, VertexId};
use crate::plane::Point;
use crate::topology::{
    BuildError, CollapseEdgeError, Dcel, FlipEdgeError, JoinEdgesError, JoinFacesError, JoinVerticesError,
    PolygonError, PolygonList, Recorder, SplitEdgeError, SplitFaceError, SplitVertexError,
};
use std::fmt;

/// A call on a [`Dcel`].
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum KernelEdit {
    /// [`Dcel::split_face`].
    SplitFace(HalfEdgeId, HalfEdgeId),
    /// [`Dcel::split_edge`].
    SplitEdge(HalfEdgeId),
    /// [`Dcel::split_vertex`].
    SplitVertex(HalfEdgeId, HalfEdgeId),
    /// [`Dcel::split_isolated_vertex`].
    SplitIsolatedVertex(VertexId),
    /// [`Dcel::join_faces`].
    JoinFaces(HalfEdgeId),
    /// [`Dcel::join_edges`].
    JoinEdges(HalfEdgeId),
    /// [`Dcel::join_vertices`].
    JoinVertices(HalfEdgeId),
    /// [`Dcel::collapse_edge`].
    CollapseEdge(HalfEdgeId),
    /// [`Dcel::flip_edge`].
    FlipEdge(HalfEdgeId),
}

/// Why a call was refused: the reason of the operation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum KernelEditError {
    /// Of `split_face`.
    #[error(transparent)]
    SplitFace(#[from] SplitFaceError),
    /// Of `split_edge`.
    #[error(transparent)]
    SplitEdge(#[from] SplitEdgeError),
    /// Of `split_vertex` and `split_isolated_vertex`.
    #[error(transparent)]
    SplitVertex(#[from] SplitVertexError),
    /// Of `join_faces`.
    #[error(transparent)]
    JoinFaces(#[from] JoinFacesError),
    /// Of `join_edges`.
    #[error(transparent)]
    JoinEdges(#[from] JoinEdgesError),
    /// Of `join_vertices`.
    #[error(transparent)]
    JoinVertices(#[from] JoinVerticesError),
    /// Of `collapse_edge`.
    #[error(transparent)]
    CollapseEdge(#[from] CollapseEdgeError),
    /// Of `flip_edge`.
    #[error(transparent)]
    FlipEdge(#[from] FlipEdgeError),
}

impl KernelEdit {
    /// Makes the call, watched by a recorder. Cost: that of the operation.
    ///
    /// # Errors
    /// Those of the operation; a refused call leaves everything bit for bit as it was.
    pub fn apply(self, dcel: &mut Dcel, rec: &mut impl Recorder) -> Result<Returned, KernelEditError> {
        Ok(match self {
            Self::SplitFace(a, b) => {
                let (h, f) = dcel.split_face_with(a, b, rec)?;
                Returned::Face(h, f)
            }
            Self::SplitEdge(h) => {
                let (v, h) = dcel.split_edge_with(h, rec)?;
                Returned::Vertex(v, h)
            }
            Self::SplitVertex(a, b) => {
                let (h, v) = dcel.split_vertex_with(a, b, rec)?;
                Returned::HalfEdge(h, v)
            }
            Self::SplitIsolatedVertex(v) => {
                let (h, f) = dcel.split_isolated_vertex_with(v, rec)?;
                Returned::Face(h, f)
            }
            Self::JoinFaces(h) => Returned::FaceGone(dcel.join_faces_with(h, rec)?),
            Self::JoinEdges(h) => Returned::VertexGone(dcel.join_edges_with(h, rec)?),
            Self::JoinVertices(h) => Returned::VertexGone(dcel.join_vertices_with(h, rec)?),
            Self::CollapseEdge(h) => Returned::VertexGone(dcel.collapse_edge_with(h, rec)?),
            Self::FlipEdge(h) => {
                dcel.flip_edge_with(h, rec)?;
                Returned::Nothing
            }
        })
    }
}

impl Call for KernelEdit {
    const KINDS: &'static [EditKind] = &[
        EditKind::SplitFace,
        EditKind::SplitEdge,
        EditKind::SplitVertex,
        EditKind::SplitIsolatedVertex,
        EditKind::JoinFaces,
        EditKind::JoinEdges,
        EditKind::JoinVertices,
        EditKind::CollapseEdge,
        EditKind::FlipEdge,
    ];

    fn of(kind: EditKind, elements: &[Element], _: Option<Point>) -> Option<Self> {
        Some(match (kind, elements) {
            (EditKind::SplitFace, &[Element::HalfEdge(a), Element::HalfEdge(b)]) => Self::SplitFace(a, b),
            (EditKind::SplitVertex, &[Element::HalfEdge(a), Element::HalfEdge(b)]) => Self::SplitVertex(a, b),
            (EditKind::SplitIsolatedVertex, &[Element::Vertex(v)]) => Self::SplitIsolatedVertex(v),
            (EditKind::SplitEdge, &[Element::HalfEdge(h)]) => Self::SplitEdge(h),
            (EditKind::JoinFaces, &[Element::HalfEdge(h)]) => Self::JoinFaces(h),
            (EditKind::JoinEdges, &[Element::HalfEdge(h)]) => Self::JoinEdges(h),
            (EditKind::JoinVertices, &[Element::HalfEdge(h)]) => Self::JoinVertices(h),
            (EditKind::CollapseEdge, &[Element::HalfEdge(h)]) => Self::CollapseEdge(h),
            (EditKind::FlipEdge, &[Element::HalfEdge(h)]) => Self::FlipEdge(h),
            _ => return None,
        })
    }

    fn kind(self) -> EditKind {
        match self {
            Self::SplitFace(..) => EditKind::SplitFace,
            Self::SplitEdge(_) => EditKind::SplitEdge,
            Self::SplitVertex(..) => EditKind::SplitVertex,
            Self::SplitIsolatedVertex(_) => EditKind::SplitIsolatedVertex,
            Self::JoinFaces(_) => EditKind::JoinFaces,
            Self::JoinEdges(_) => EditKind::JoinEdges,
            Self::JoinVertices(_) => EditKind::JoinVertices,
            Self::CollapseEdge(_) => EditKind::CollapseEdge,
            Self::FlipEdge(_) => EditKind::FlipEdge,
        }
    }

    fn elements(self) -> Vec<Element> {
        match self {
            Self::SplitFace(a, b) | Self::SplitVertex(a, b) => vec![a.into(), b.into()],
            Self::SplitIsolatedVertex(v) => vec![v.into()],
            Self::SplitEdge(h) | Self::JoinFaces(h) | Self::JoinEdges(h) => vec![h.into()],
            Self::JoinVertices(h) | Self::CollapseEdge(h) | Self::FlipEdge(h) => vec![h.into()],
        }
    }

    fn point(self) -> Option<Point> {
        None
    }
}

impl fmt::Display for KernelEdit {
    /// `split_vertex h2 h8`
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.write_call(f)
    }
}

/// What a script of the kernel starts from. It prints as the first line of the script.
///
/// ```
/// use dcel_kit::script::KernelStart;
/// use dcel_kit::topology::PolygonList;
/// let faces = PolygonList::from_triangles(&[[0, 1, 2], [2, 1, 3]]);
/// assert_eq!(KernelStart::Surface { vertices: 4, faces }.to_string(), "surface 4 / 0 1 2 / 2 1 3");
/// ```
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum KernelStart {
    /// `ring N`: [`Dcel::polygon`], a double-sided disc.
    Ring(usize),
    /// `torus`: [`Dcel::torus`].
    Torus,
    /// `surface N / i j k ... / ...`: [`Dcel::from_polygons`], N vertices and their faces.
    Surface {
        /// How many vertices; those that no face uses are isolated.
        vertices: usize,
        /// The faces, by numbers of vertices from 0.
        faces: PolygonList,
    },
}

/// Why there is no such start.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum KernelStartError {
    /// Of a ring.
    #[error(transparent)]
    Ring(#[from] PolygonError),
    /// Of a surface.
    #[error(transparent)]
    Surface(#[from] BuildError),
}

impl KernelStart {
    /// The structure. Cost: linear.
    ///
    /// # Errors
    /// [`KernelStartError`] if the faces make no surface.
    pub fn build(&self) -> Result<Dcel, KernelStartError> {
        Ok(match self {
            Self::Ring(corners) => Dcel::polygon(*corners)?,
            Self::Torus => Dcel::torus(),
            Self::Surface { vertices, faces } => Dcel::from_polygons(*vertices, faces)?.dcel,
        })
    }
}

impl fmt::Display for KernelStart {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Ring(corners) => write!(f, "ring {corners}"),
            Self::Torus => f.write_str("torus"),
            Self::Surface { vertices, faces } => {
                write!(f, "surface {vertices}")?;
                (0..faces.cycle_count()).try_for_each(|cycle| {
                    f.write_str(" /")?;
                    faces.cycle(cycle).iter().try_for_each(|corner| write!(f, " {corner}"))
                })
            }
        }
    }
}
