//! One call of an edit of the plane, with its arguments resolved to ids.

use crate::ids::{Element, FaceId, HalfEdgeId, VertexId};
use crate::plane::{JoinEdgesError, JoinFacesError, Point, SplitEdgeError, SplitFaceError, Subdivision};
use crate::topology::Recorder;
use std::fmt;

/// A call.
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
}

/// What a call gave back.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Returned {
    /// `split_face`: the new half-edge from the first origin to the second, and the new face.
    Face(HalfEdgeId, FaceId),
    /// `split_in_half`, `split_edge`: the new vertex, and the half-edge that now follows the split one.
    Vertex(VertexId, HalfEdgeId),
    /// `join_faces`: the face that is gone.
    FaceGone(FaceId),
    /// `join_edges`: the vertex that is gone.
    VertexGone(VertexId),
}

impl Returned {
    /// The new half-edge, if there is one.
    #[must_use]
    pub fn half_edge(self) -> Option<HalfEdgeId> {
        match self {
            Self::Face(h, _) | Self::Vertex(_, h) => Some(h),
            Self::FaceGone(_) | Self::VertexGone(_) => None,
        }
    }

    /// All that was returned, in order.
    #[must_use]
    pub fn elements(self) -> Vec<Element> {
        match self {
            Self::Face(h, f) => vec![h.into(), f.into()],
            Self::Vertex(v, h) => vec![v.into(), h.into()],
            Self::FaceGone(f) => vec![f.into()],
            Self::VertexGone(v) => vec![v.into()],
        }
    }
}

impl fmt::Display for Returned {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
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
}

/// Which edit: what the parser knows before ids are known.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum EditKind {
    SplitFace,
    SplitInHalf,
    SplitEdge,
    JoinFaces,
    JoinEdges,
}

impl EditKind {
    pub(super) const ALL: [Self; 5] =
        [Self::SplitFace, Self::SplitInHalf, Self::SplitEdge, Self::JoinFaces, Self::JoinEdges];

    pub(super) fn word(self) -> &'static str {
        match self {
            Self::SplitFace => "split_face",
            Self::SplitInHalf => "split_in_half",
            Self::SplitEdge => "split_edge",
            Self::JoinFaces => "join_faces",
            Self::JoinEdges => "join_edges",
        }
    }

    /// Whether it makes an edge that can be named.
    pub(super) fn makes_an_edge(self) -> bool {
        !matches!(self, Self::JoinFaces | Self::JoinEdges)
    }

    /// The call with these arguments; `None` if they are too few.
    pub(super) fn call(self, half_edges: &[HalfEdgeId], point: Option<Point>) -> Option<Edit> {
        let &first = half_edges.first()?;
        Some(match self {
            Self::SplitFace => Edit::SplitFace(first, *half_edges.get(1)?),
            Self::SplitInHalf => Edit::SplitInHalf(first),
            Self::SplitEdge => Edit::SplitEdge(first, point?),
            Self::JoinFaces => Edit::JoinFaces(first),
            Self::JoinEdges => Edit::JoinEdges(first),
        })
    }
}

impl Edit {
    pub(super) fn kind(self) -> EditKind {
        match self {
            Self::SplitFace(..) => EditKind::SplitFace,
            Self::SplitInHalf(_) => EditKind::SplitInHalf,
            Self::SplitEdge(..) => EditKind::SplitEdge,
            Self::JoinFaces(_) => EditKind::JoinFaces,
            Self::JoinEdges(_) => EditKind::JoinEdges,
        }
    }

    /// The half-edges among its arguments.
    #[must_use]
    pub fn half_edges(self) -> Vec<HalfEdgeId> {
        match self {
            Self::SplitFace(a, b) => vec![a, b],
            Self::SplitInHalf(h) | Self::SplitEdge(h, _) | Self::JoinFaces(h) | Self::JoinEdges(h) => vec![h],
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
        })
    }
}

impl fmt::Display for Edit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.kind().word())?;
        for h in self.half_edges() {
            write!(f, " {h}")?;
        }
        if let Self::SplitEdge(_, p) = self {
            write!(f, " {} {}", p.x, p.y)?;
        }
        Ok(())
    }
}
