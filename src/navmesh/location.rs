//! Where a point lies, by name; and from where a way may start.
//!
//! ```text
//!   ┌───────●────┐     ●  Vertex(v)           Nothing is snapped: a point a hair beside the map is outside, and
//!   │  ·   ╱     │     │  Edge(h)             nearest_point is another question.
//!   │     ╱ ┌────┘     ·  Face(f), Hole(f), Outer
//!   └────┴──┘
//! ```

use crate::ids::{FaceId, HalfEdgeId, VertexId};
use crate::plane::Point;
use std::fmt;

/// Where a point lies: exactly, on the smallest element that has it.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Location {
    /// On a vertex of the mesh.
    Vertex(VertexId),
    /// Inside an edge of the mesh; the half-edge is one whose face is a face of the mesh.
    Edge(HalfEdgeId),
    /// Inside a face of the mesh, blocked or not.
    Face(FaceId),
    /// Inside a hole face, or on something in it.
    Hole(FaceId),
    /// In the outer face.
    Outer,
}

impl fmt::Display for Location {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Vertex(v) => write!(f, "on vertex {v}"),
            Self::Edge(h) => write!(f, "on edge {} ({h})", h.edge()),
            Self::Face(x) => write!(f, "in face {x}"),
            Self::Hole(x) => write!(f, "in the hole {x}"),
            Self::Outer => f.write_str("outside"),
        }
    }
}

/// A point from or to which a way may lead, and the face in which one stands there. On an edge or vertex the face
/// says on which side of a wall, or in which wedge of a double corner.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Place {
    /// The point.
    pub point: Point,
    /// Where it lies.
    pub location: Location,
    /// A face of the mesh that has it, not blocked.
    pub face: FaceId,
}

/// Why one cannot stand at a point.
#[derive(Clone, PartialEq, Debug, thiserror::Error)]
#[non_exhaustive]
pub enum PlaceError {
    /// The point is in no face of the mesh.
    #[error("{point} is {location}, not on the mesh; nearest_point gives the nearest place that is")]
    OffMesh {
        /// The point.
        point: Point,
        /// Where it lies.
        location: Location,
    },
    /// Every face that has the point is blocked.
    #[error("{point} is {location}, and blocked; nearest_point gives the nearest place that is free")]
    Blocked {
        /// The point.
        point: Point,
        /// Where it lies.
        location: Location,
    },
    /// The point is at a double corner, or on a wall: one has to say on which side.
    #[error(
        "{point} is {location}, where {} sides meet that nobody can pass between: choose one of the faces {} with place_in",
        faces.len(),
        faces.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ")
    )]
    Ambiguous {
        /// The point.
        point: Point,
        /// Where it lies.
        location: Location,
        /// One face on each side.
        faces: Vec<FaceId>,
    },
    /// The face does not have the point, or is blocked, or is no face of the mesh.
    #[error("{point} is {location}, and {face} is no free face there")]
    NotInFace {
        /// The point.
        point: Point,
        /// Where it lies.
        location: Location,
        /// The face.
        face: FaceId,
    },
}
