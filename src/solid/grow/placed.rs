//! Positions and masks that a shape gets while it grows.

use crate::ids::{EdgeId, FaceId, VertexMap};
use crate::solid::Selection;

/// The masks of the sides of a grown surface.
pub mod part {
    /// Faces that look down, to -z.
    pub const BOTTOM: u8 = 1;
    /// Faces that look up, to +z.
    pub const TOP: u8 = 2;
    /// The side of a box to -y.
    pub const FRONT: u8 = 4;
    /// The side of a box to +x.
    pub const RIGHT: u8 = 8;
    /// The side of a box to +y.
    pub const BACK: u8 = 16;
    /// The side of a box to -x.
    pub const LEFT: u8 = 32;
    /// The mantle of round shapes.
    pub const SIDE: u8 = 64;
}

/// Where the elements of a grown structure belong.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Placed {
    /// The position of each vertex.
    pub points: VertexMap<[f64; 3]>,
    /// What each face is part of; see [`part`].
    pub parts: Selection<FaceId>,
    /// Bit 0: a hard edge, between two parts.
    pub creases: Selection<EdgeId>,
}

/// Where k of m steps from -1 to 1 lead; exactly symmetric about 0.
pub(super) fn stride(k: usize, m: usize) -> f64 {
    (2.0 * k as f64 - m as f64) / m as f64
}
