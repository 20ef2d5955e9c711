//! Why a list of faces is not a surface.

use crate::topology::TooMany;

/// Why a list of faces is not a half-edge structure. Faces and vertices are numbered from 0 in the order of
/// the input.
///
/// Which one is reported when several apply: first whatever is wrong with a face by itself, the smallest face
/// number first and its corners in order; then clashes along edges, at the first face that does not fit the
/// faces before it; then vertices, the smallest number first.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum BuildError {
    /// A corner names a vertex that does not exist.
    #[error(
        "face {face}: vertex {vertex} does not exist, there are {vertices} (numbered from 0); \
             check whether the numbers of the input start at 1"
    )]
    IndexOutOfRange {
        /// The face.
        face: u32,
        /// The vertex it names.
        vertex: u32,
        /// How many vertices there are.
        vertices: usize,
    },
    /// A cycle with fewer than three corners.
    #[error("face {face} has a cycle with {corners} corner{}: three are needed; leave the face out", if *.corners == 1 { "" } else { "s" })]
    TooFewCorners {
        /// The face.
        face: u32,
        /// How many corners its cycle has.
        corners: usize,
    },
    /// A cycle passes the same vertex twice.
    #[error("face {face} passes vertex {vertex} twice on one cycle: split it there into two faces")]
    RepeatedVertex {
        /// The face.
        face: u32,
        /// The vertex.
        vertex: u32,
    },
    /// Two faces have the same corners in the same cyclic order.
    #[error("face {second} repeats face {first}: leave one of them out")]
    SameFaceTwice {
        /// The earlier face.
        first: u32,
        /// The later one.
        second: u32,
    },
    /// Three or more faces use the same edge.
    #[error(
        "the edge between vertices {u} and {v} has {} faces ({}): \
         an edge has two sides; leave faces out or give them vertices of their own",
        faces.len(), list(faces)
    )]
    ThreeFaces {
        /// The smaller end of the edge.
        u: u32,
        /// The greater end.
        v: u32,
        /// All faces that use it, in increasing order; a face that runs along it twice stands here twice.
        faces: Vec<u32>,
    },
    /// Two faces, and no third, run along an edge in the same direction, so one of them is wound the wrong
    /// way round. A one-sided surface always ends here, whichever faces are turned.
    #[error("faces {first} and {second} both run from vertex {u} to vertex {v}: reverse one of them")]
    MixedWinding {
        /// Where both run from.
        u: u32,
        /// Where both run to.
        v: u32,
        /// The earlier face.
        first: u32,
        /// The later one.
        second: u32,
    },
    /// The faces round a vertex are not one fan: several fans touch in it.
    #[error("at vertex {vertex} {} separate fans of faces touch (one face of each: {}): give each fan a vertex of its own", fans.len(), list(fans))]
    NonManifoldVertex {
        /// The vertex.
        vertex: u32,
        /// One face of each fan, in increasing order: the smallest of the fan.
        fans: Vec<u32>,
    },
    /// A face has an inner cycle; a face of the kernel has exactly one cycle.
    #[error(
        "face {face} has a hole, but without coordinates a face is one cycle: build it as a planar subdivision, or cut the face open"
    )]
    HoleInFace {
        /// The face.
        face: u32,
    },
    /// More elements than ids.
    #[error(transparent)]
    TooMany(#[from] TooMany),
}

/// All of them, unless they would fill pages.
fn list(numbers: &[u32]) -> String {
    const SHOWN: usize = 100;
    let shown: Vec<String> = numbers.iter().take(SHOWN).map(u32::to_string).collect();
    let rest = if numbers.len() > SHOWN { format!(" and {} more", numbers.len() - SHOWN) } else { String::new() };
    shown.join(", ") + &rest
}

impl BuildError {
    /// The faces the error speaks of, by their numbers in the input, so that a reader can name their lines.
    #[must_use]
    pub fn faces(&self) -> Vec<u32> {
        match self {
            Self::IndexOutOfRange { face, .. }
            | Self::TooFewCorners { face, .. }
            | Self::RepeatedVertex { face, .. }
            | Self::HoleInFace { face } => vec![*face],
            Self::SameFaceTwice { first, second } | Self::MixedWinding { first, second, .. } => vec![*first, *second],
            Self::ThreeFaces { faces: all, .. } | Self::NonManifoldVertex { fans: all, .. } => all.clone(),
            Self::TooMany(_) => Vec::new(),
        }
    }

    /// The vertices the error speaks of, by their numbers in the input.
    #[must_use]
    pub fn vertices(&self) -> Vec<u32> {
        match self {
            Self::IndexOutOfRange { vertex, .. }
            | Self::RepeatedVertex { vertex, .. }
            | Self::NonManifoldVertex { vertex, .. } => vec![*vertex],
            Self::ThreeFaces { u, v, .. } | Self::MixedWinding { u, v, .. } => vec![*u, *v],
            Self::TooFewCorners { .. } | Self::SameFaceTwice { .. } | Self::HoleInFace { .. } | Self::TooMany(_) => {
                Vec::new()
            }
        }
    }
}
