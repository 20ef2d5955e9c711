//! The faults that faces may have that should be a navmesh.

use crate::plane::{ConvertError, CoordinateError, Point};

/// A fault of faces that should be a navmesh.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum MeshFault {
    /// A vertex with coordinates that cannot be computed with.
    Coordinate {
        /// The vertex.
        vertex: u32,
        /// What is wrong with it.
        error: CoordinateError,
    },
    /// A corner that is no vertex.
    NoSuchVertex {
        /// The face.
        face: u32,
        /// The number it gives.
        corner: u32,
        /// How many vertices there are.
        vertices: usize,
    },
    /// A face with fewer than three corners, or with a corner twice.
    FewCorners {
        /// The face.
        face: u32,
        /// How many corners it lists.
        corners: usize,
        /// How many of them are different.
        distinct: usize,
    },
    /// A face with something inside.
    Rings {
        /// The face.
        face: u32,
        /// How many.
        rings: usize,
    },
    /// A face without area.
    Flat {
        /// The face.
        face: u32,
    },
    /// A face that runs clockwise.
    Clockwise {
        /// The face.
        face: u32,
    },
    /// A corner that points inwards, or a side that runs back on the one before it.
    NotConvex {
        /// The face.
        face: u32,
        /// The first such corner.
        vertex: u32,
    },
    /// All corners turn the same way, but more than once round.
    Winds {
        /// The face.
        face: u32,
    },
    /// Two faces on the same side of an edge.
    SameSide {
        /// The earlier face.
        first: u32,
        /// The later face.
        second: u32,
        /// Where the edge starts.
        from: u32,
        /// Where it ends.
        to: u32,
    },
    /// Sides of two faces that cross, or lie on each other for a part.
    Overlap {
        /// One face.
        first: u32,
        /// The other.
        second: u32,
        /// A side of each.
        sides: [[u32; 2]; 2],
        /// Where they meet.
        at: Point,
    },
    /// A face inside another one.
    Covers {
        /// The face.
        face: u32,
        /// A vertex inside it.
        vertex: u32,
    },
    /// A vertex in the interior of a side: the faces beside it are no neighbours.
    TJunction {
        /// The vertex.
        vertex: u32,
        /// The face whose side it is.
        face: u32,
        /// The ends of the side.
        side: [u32; 2],
    },
    /// Two vertices at the same place: the faces beside them are no neighbours.
    SamePlace {
        /// The earlier vertex.
        first: u32,
        /// The later vertex.
        second: u32,
        /// Where.
        at: Point,
    },
    /// Holes touch at a vertex: it can be walked past on each side, and not through.
    DoubleCorner {
        /// The vertex.
        vertex: u32,
        /// How many holes.
        holes: usize,
    },
    /// Two vertices that nearly meet: the faces beside them are no neighbours.
    NearVertices {
        /// The earlier vertex.
        first: u32,
        /// The later vertex.
        second: u32,
        /// How far they are apart.
        distance: f64,
    },
    /// A vertex that nearly lies on a side: the faces beside them are no neighbours.
    NearSide {
        /// The vertex.
        vertex: u32,
        /// The face whose side it is.
        face: u32,
        /// The ends of the side.
        side: [u32; 2],
        /// How far it is away.
        distance: f64,
    },
    /// What the converter refuses beyond that.
    Convert(ConvertError),
    /// There are more than can be named.
    More {
        /// How many were named.
        named: usize,
    },
}

impl MeshFault {
    /// Whether one can live with it: the mesh can be used, but should be looked at.
    #[must_use]
    pub const fn is_warning(&self) -> bool {
        matches!(self, Self::DoubleCorner { .. } | Self::NearVertices { .. } | Self::NearSide { .. })
    }

    /// The same with other coordinates in its message: those of a file whose y points down, for example.
    #[must_use]
    pub fn with_points(mut self, change: impl Fn(Point) -> Point) -> Self {
        if let Self::SamePlace { at, .. } | Self::Overlap { at, .. } = &mut self {
            *at = change(*at);
        }
        self
    }

    /// One word for the kind of fault.
    #[must_use]
    pub const fn kind(&self) -> &'static str {
        match self {
            Self::Coordinate { .. } => "coordinate",
            Self::NoSuchVertex { .. } => "corner",
            Self::FewCorners { .. } | Self::Flat { .. } => "degenerate",
            Self::Clockwise { .. } | Self::Winds { .. } => "winding",
            Self::NotConvex { .. } | Self::Rings { .. } => "not-convex",
            Self::SameSide { .. } | Self::Overlap { .. } | Self::Covers { .. } => "overlap",
            Self::TJunction { .. } => "t-junction",
            Self::SamePlace { .. } => "same-place",
            Self::DoubleCorner { .. } => "double-corner",
            Self::NearVertices { .. } | Self::NearSide { .. } => "nearly-welded",
            Self::Convert(_) => "other",
            Self::More { .. } => "more",
        }
    }

    /// The faces the message speaks of, for callers who know where in a file they stand.
    #[must_use]
    pub fn faces(&self) -> Vec<u32> {
        match self {
            Self::NoSuchVertex { face, .. }
            | Self::FewCorners { face, .. }
            | Self::Rings { face, .. }
            | Self::Flat { face }
            | Self::Clockwise { face }
            | Self::NotConvex { face, .. }
            | Self::Winds { face }
            | Self::Covers { face, .. }
            | Self::TJunction { face, .. }
            | Self::NearSide { face, .. } => vec![*face],
            Self::SameSide { first, second, .. } | Self::Overlap { first, second, .. } => vec![*first, *second],
            Self::Convert(error) => error.faces(),
            Self::Coordinate { .. }
            | Self::SamePlace { .. }
            | Self::NearVertices { .. }
            | Self::DoubleCorner { .. }
            | Self::More { .. } => vec![],
        }
    }

    /// The vertices the message speaks of.
    #[must_use]
    pub fn vertices(&self) -> Vec<u32> {
        match self {
            Self::Coordinate { vertex, .. }
            | Self::NotConvex { vertex, .. }
            | Self::Covers { vertex, .. }
            | Self::TJunction { vertex, .. }
            | Self::DoubleCorner { vertex, .. }
            | Self::NearSide { vertex, .. } => vec![*vertex],
            Self::SamePlace { first, second, .. } | Self::NearVertices { first, second, .. } => vec![*first, *second],
            Self::SameSide { from, to, .. } => vec![*from, *to],
            Self::Convert(error) => error.vertices(),
            _ => vec![],
        }
    }
}
