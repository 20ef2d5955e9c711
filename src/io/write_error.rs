//! Why a structure cannot be written in a format.

use crate::geometry::number::Number;
use crate::ids::{EdgeId, Element, FaceId, HalfEdgeId, VertexId};
use std::{fmt, io};

/// Why a structure cannot be written in a format.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum WriteError {
    /// The machine refused.
    #[error(transparent)]
    Io(#[from] io::Error),
    /// The kit reads this format and does not write it.
    #[error("{format} is read, not written; try geojson or dcel")]
    ReadOnly {
        /// The format.
        format: &'static str,
    },
    /// Triangle's format needs two files.
    #[error("triangle needs two files, .node and .ele; give the path of one of them instead of one output")]
    TwoFiles,
    /// A surface in space, and a format of the plane.
    #[error("{format} holds points of the plane, and this is a surface in space; try obj, off or ply")]
    InSpace {
        /// The format.
        format: &'static str,
    },
    /// A vertex has no position.
    #[error("{vertex} has no position; dcel and tables can be written without")]
    NoPosition {
        /// The vertex.
        vertex: VertexId,
    },
    /// A face has no boundary to be written.
    #[error("{face} has no boundary; try dcel, and validate the structure")]
    NoBoundary {
        /// The face.
        face: FaceId,
    },
    /// A boundary cycle does not close, or a vertex of it is missing.
    #[error("the cycle of {face} breaks at {half_edge}; try dcel, and validate the structure")]
    BrokenCycle {
        /// The face.
        face: FaceId,
        /// The half-edge at which the walk ends.
        half_edge: HalfEdgeId,
    },
    /// A face with inner components, and a format without.
    #[error("{face} has inner components, which {format} cannot hold; geojson holds cycles, dcel holds everything")]
    FaceHasRings {
        /// The face.
        face: FaceId,
        /// The format.
        format: &'static str,
    },
    /// A face that is not a triangle, and a format that holds triangles only.
    #[error("{face} has {corners} corners and triangle holds triangles only; try obj, off, ply or geojson")]
    NotTriangle {
        /// The face.
        face: FaceId,
        /// How many corners it has.
        corners: usize,
    },
    /// A face that does not fall into triangles from its first corner, and a format that holds triangles only.
    #[error(
        "{face} is not convex, and {format} holds triangles only; try obj, off or ply, or cut the face first with dcel solid split"
    )]
    NoFan {
        /// The face.
        face: FaceId,
        /// The format.
        format: &'static str,
    },
    /// A coordinate that is too large for single precision, in which the format holds numbers.
    #[error("{coordinate:e} at a corner of {face} is too large for single precision; write stl, which is text")]
    TooLarge {
        /// A face with that corner.
        face: FaceId,
        /// The coordinate.
        coordinate: f64,
    },
    /// Two corners that are the same in single precision, in which the format holds numbers.
    #[error("{} and {} are the same in single precision, and so is what hangs on them; write stl, which is text", Place(points[0]), Place(points[1]))]
    TooClose {
        /// The two corners.
        points: [[f64; 3]; 2],
    },
    /// A triangle that has no area in single precision, or is turned over there, in which the format holds numbers.
    #[error("a triangle of {face} is flat or turned over in single precision; write stl, which is text")]
    Folded {
        /// The face.
        face: FaceId,
    },
    /// Two edges with the same ends, and a format that tells edges by their ends.
    #[error("{} and {} join the same two vertices, which {format} cannot hold; make the shape of more parts, or split one of them first", edges[0], edges[1])]
    EdgeTwice {
        /// The edges.
        edges: [EdgeId; 2],
        /// The format.
        format: &'static str,
    },
    /// An edge with the same face on both sides: a dangling edge, or a bridge.
    #[error(
        "{half_edge} and its twin both bound {face}, which {format} cannot hold; {}", by_ends(*in_space)
    )]
    SameFaceTwice {
        /// One half of the edge.
        half_edge: HalfEdgeId,
        /// The face.
        face: FaceId,
        /// Whether it is a surface in space.
        in_space: bool,
        /// The format.
        format: &'static str,
    },
    /// A cycle that passes a vertex twice: the face touches itself there, which a list of corners cannot say.
    #[error("a cycle of {face} passes {vertex} twice, which {format} cannot hold; {}", by_holes(format))]
    VertexTwice {
        /// The face.
        face: FaceId,
        /// The vertex.
        vertex: VertexId,
        /// The format.
        format: &'static str,
    },
    /// A face with a corner that points inwards, and a format of convex faces.
    #[error(
        "{face} is not convex at {vertex}, and {format} holds convex faces; cut it up first, for example into triangles"
    )]
    NotConvex {
        /// The face.
        face: FaceId,
        /// The corner.
        vertex: VertexId,
        /// The format.
        format: &'static str,
    },
    /// An edge or vertex that belongs to no polygon.
    #[error("{element} belongs to no polygon and would be lost in {format}; dcel holds everything")]
    Lost {
        /// The edge, by a half of it, or the vertex.
        element: Element,
        /// The format.
        format: &'static str,
    },
}

/// What holds an edge with the same face on both sides.
fn by_ends(in_space: bool) -> &'static str {
    if in_space {
        "no format of surfaces can; make the shape of more parts, or cut the face in two first"
    } else {
        "dcel holds everything of the plane"
    }
}

/// What holds a face that touches itself at a corner.
fn by_holes(format: &str) -> &'static str {
    if format == "geojson" {
        "dcel holds everything"
    } else {
        "of the plane, geojson writes a hole that touches, and dcel holds everything"
    }
}

/// `(1, 2, 3)`
struct Place([f64; 3]);

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [x, y, z] = self.0.map(Number);
        write!(f, "({x}, {y}, {z})")
    }
}
