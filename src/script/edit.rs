//! One call of an edit of the plane, with its arguments resolved to ids; and what it shares with one of the kernel.

use super::ground::Call;
use super::kernel::KernelEditError;
use super::syntax::Kind;
use crate::ids::{Element, FaceId, HalfEdgeId, VertexId};
use crate::plane::{FlipEdgeError, JoinEdgesError, JoinFacesError, Point, SplitEdgeError, SplitFaceError, Subdivision};
use crate::topology::Recorder;
use std::fmt;

/// A call on a [`Subdivision`].
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Edit {
    /// [`Subdivision::split_face`].
    SplitFace(HalfEdgeId, HalfEdgeId),
    /// [`Subdivision::split_in_half`].
    SplitInHalf(HalfEdgeId),
    /// [`Subdivision::split_edge`].
    SplitEdge(HalfEdgeId, Point),
    /// [`Subdivision::join_faces`].
    JoinFaces(HalfEdgeId),
    /// [`Subdivision::join_edges`].
    JoinEdges(HalfEdgeId),
    /// [`Subdivision::flip_edge`].
    FlipEdge(HalfEdgeId),
}

/// What a call gave back.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Returned {
    /// `split_face`: the new half-edge from the first origin to the second, and the new face;
    /// `split_isolated_vertex`: the new half-edge to the new vertex, and the new face.
    Face(HalfEdgeId, FaceId),
    /// `split_in_half`, `split_edge`: the new vertex, and the half-edge that now follows the split one.
    Vertex(VertexId, HalfEdgeId),
    /// `split_vertex`: the new half-edge from the old vertex to the new one, and the new vertex.
    HalfEdge(HalfEdgeId, VertexId),
    /// `join_faces`: the face that is gone.
    FaceGone(FaceId),
    /// `join_edges`, `join_vertices`, `collapse_edge`: the vertex that is gone.
    VertexGone(VertexId),
    /// `flip_edge`: all ids stay.
    Nothing,
}

impl Returned {
    /// The new half-edge, if there is one.
    #[must_use]
    pub fn half_edge(self) -> Option<HalfEdgeId> {
        match self {
            Self::Face(h, _) | Self::Vertex(_, h) | Self::HalfEdge(h, _) => Some(h),
            Self::FaceGone(_) | Self::VertexGone(_) | Self::Nothing => None,
        }
    }

    /// All that was returned, in order.
    #[must_use]
    pub fn elements(self) -> Vec<Element> {
        match self {
            Self::Face(h, f) => vec![h.into(), f.into()],
            Self::Vertex(v, h) => vec![v.into(), h.into()],
            Self::HalfEdge(h, v) => vec![h.into(), v.into()],
            Self::FaceGone(f) => vec![f.into()],
            Self::VertexGone(v) => vec![v.into()],
            Self::Nothing => Vec::new(),
        }
    }
}

impl fmt::Display for Returned {
    /// `h12, f2`, or `nothing`
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if *self == Self::Nothing {
            return f.write_str("nothing");
        }
        let names: Vec<String> = self.elements().iter().map(ToString::to_string).collect();
        f.write_str(&names.join(", "))
    }
}

/// Why a call was refused: the reason of the operation.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum EditError {
    /// Of `split_face`.
    #[error(transparent)]
    SplitFace(#[from] SplitFaceError),
    /// Of `split_in_half` and `split_edge`.
    #[error(transparent)]
    SplitEdge(#[from] SplitEdgeError),
    /// Of `join_faces`.
    #[error(transparent)]
    JoinFaces(#[from] JoinFacesError),
    /// Of `join_edges`.
    #[error(transparent)]
    JoinEdges(#[from] JoinEdgesError),
    /// Of `flip_edge`.
    #[error(transparent)]
    FlipEdge(#[from] FlipEdgeError),
    /// Of an edit of the kernel.
    #[error(transparent)]
    Kernel(#[from] KernelEditError),
}

/// Which edit: what the parser knows before ids are known.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum EditKind {
    /// `split_face A B`
    SplitFace,
    /// `split_in_half A`, of the plane.
    SplitInHalf,
    /// `split_edge A X Y`, of the plane.
    SplitEdgeAt,
    /// `split_edge A`, of the kernel.
    SplitEdge,
    /// `split_vertex A B`, of the kernel.
    SplitVertex,
    /// `split_isolated_vertex V`, of the kernel.
    SplitIsolatedVertex,
    /// `join_faces A`
    JoinFaces,
    /// `join_edges A`
    JoinEdges,
    /// `join_vertices A`, of the kernel.
    JoinVertices,
    /// `collapse_edge A`, of the kernel.
    CollapseEdge,
    /// `flip_edge A`
    FlipEdge,
}

impl EditKind {
    /// The word for it in a script.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::SplitFace => "split_face",
            Self::SplitInHalf => "split_in_half",
            Self::SplitEdgeAt | Self::SplitEdge => "split_edge",
            Self::SplitVertex => "split_vertex",
            Self::SplitIsolatedVertex => "split_isolated_vertex",
            Self::JoinFaces => "join_faces",
            Self::JoinEdges => "join_edges",
            Self::JoinVertices => "join_vertices",
            Self::CollapseEdge => "collapse_edge",
            Self::FlipEdge => "flip_edge",
        }
    }

    /// The kinds of the elements it takes; a place may follow.
    pub(super) fn takes(self) -> &'static [Kind] {
        match self {
            Self::SplitFace | Self::SplitVertex => &[Kind::HalfEdge, Kind::HalfEdge],
            Self::SplitIsolatedVertex => &[Kind::Vertex],
            _ => &[Kind::HalfEdge],
        }
    }

    /// Whether it makes an edge that can be named.
    pub(super) fn makes_an_edge(self) -> bool {
        match self {
            Self::SplitFace | Self::SplitInHalf | Self::SplitEdgeAt | Self::SplitEdge => true,
            Self::SplitVertex | Self::SplitIsolatedVertex => true,
            Self::JoinFaces | Self::JoinEdges | Self::JoinVertices | Self::CollapseEdge | Self::FlipEdge => false,
        }
    }
}

impl Call for Edit {
    const KINDS: &'static [EditKind] = &[
        EditKind::SplitFace,
        EditKind::SplitInHalf,
        EditKind::SplitEdgeAt,
        EditKind::JoinFaces,
        EditKind::JoinEdges,
        EditKind::FlipEdge,
    ];

    fn of(kind: EditKind, elements: &[Element], point: Option<Point>) -> Option<Self> {
        let &Element::HalfEdge(first) = elements.first()? else { return None };
        Some(match (kind, elements.get(1)) {
            (EditKind::SplitFace, Some(&Element::HalfEdge(second))) => Self::SplitFace(first, second),
            (EditKind::SplitInHalf, _) => Self::SplitInHalf(first),
            (EditKind::SplitEdgeAt, _) => Self::SplitEdge(first, point?),
            (EditKind::JoinFaces, _) => Self::JoinFaces(first),
            (EditKind::JoinEdges, _) => Self::JoinEdges(first),
            (EditKind::FlipEdge, _) => Self::FlipEdge(first),
            _ => return None,
        })
    }

    fn kind(self) -> EditKind {
        match self {
            Self::SplitFace(..) => EditKind::SplitFace,
            Self::SplitInHalf(_) => EditKind::SplitInHalf,
            Self::SplitEdge(..) => EditKind::SplitEdgeAt,
            Self::JoinFaces(_) => EditKind::JoinFaces,
            Self::JoinEdges(_) => EditKind::JoinEdges,
            Self::FlipEdge(_) => EditKind::FlipEdge,
        }
    }

    fn elements(self) -> Vec<Element> {
        self.half_edges().into_iter().map(Element::from).collect()
    }

    fn point(self) -> Option<Point> {
        match self {
            Self::SplitEdge(_, point) => Some(point),
            _ => None,
        }
    }
}

impl Edit {
    /// The half-edges among its arguments.
    #[must_use]
    pub fn half_edges(self) -> Vec<HalfEdgeId> {
        match self {
            Self::SplitFace(a, b) => vec![a, b],
            Self::SplitInHalf(h) | Self::SplitEdge(h, _) => vec![h],
            Self::JoinFaces(h) | Self::JoinEdges(h) | Self::FlipEdge(h) => vec![h],
        }
    }

    /// Makes the call, watched by a recorder. Cost: that of the operation.
    ///
    /// # Errors
    /// Those of the operation; a refused call leaves everything bit for bit as it was.
    pub fn apply(self, subdivision: &mut Subdivision, rec: &mut impl Recorder) -> Result<Returned, EditError> {
        let vertex = |(v, h)| Returned::Vertex(v, h);
        Ok(match self {
            Self::SplitFace(a, b) => {
                let (h, f) = subdivision.split_face_with(a, b, rec)?;
                Returned::Face(h, f)
            }
            Self::SplitInHalf(h) => vertex(subdivision.split_in_half_with(h, rec)?),
            Self::SplitEdge(h, point) => vertex(subdivision.split_edge_with(h, point, rec)?),
            Self::JoinFaces(h) => Returned::FaceGone(subdivision.join_faces_with(h, rec)?),
            Self::JoinEdges(h) => Returned::VertexGone(subdivision.join_edges_with(h, rec)?),
            Self::FlipEdge(h) => {
                subdivision.flip_edge_with(h, rec)?;
                Returned::Nothing
            }
        })
    }
}

impl fmt::Display for Edit {
    /// `split_face h2 h8`
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.write_call(f)
    }
}
