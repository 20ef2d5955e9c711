//! Seven solids whose faces are regular, of two kinds: the regular solids with their corners cut off.
//!
//! ```text
//!   a regular p-gon cut at the ratio 1 / (2 + 2 cos(pi / p)) of its edges becomes a regular 2p-gon
//! ```
//!
//! Source: Pappus, *Collection*, book V, who gives them to Archimedes. The other six of his thirteen need faces that
//! are moved or twisted as well.

use super::{Platonic, Polyhedron};
use std::f64::consts::PI;
use std::fmt;

/// A solid with regular faces, made from a regular one.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Archimedean {
    /// The corners cut off, so that all edges are equal.
    Truncated(Platonic),
    /// 8 triangles and 6 squares: the cube or the octahedron with its edges halved.
    Cuboctahedron,
    /// 20 triangles and 12 pentagons: the icosahedron or the dodecahedron with its edges halved.
    Icosidodecahedron,
}

impl Archimedean {
    /// All seven.
    pub const ALL: [Self; 7] = [
        Self::Truncated(Platonic::Tetrahedron),
        Self::Truncated(Platonic::Cube),
        Self::Truncated(Platonic::Octahedron),
        Self::Truncated(Platonic::Dodecahedron),
        Self::Truncated(Platonic::Icosahedron),
        Self::Cuboctahedron,
        Self::Icosidodecahedron,
    ];
}

impl fmt::Display for Archimedean {
    /// `truncated-cube`, `cuboctahedron`
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Truncated(solid) => write!(f, "truncated-{solid}"),
            Self::Cuboctahedron => f.write_str("cuboctahedron"),
            Self::Icosidodecahedron => f.write_str("icosidodecahedron"),
        }
    }
}

impl Polyhedron {
    /// A solid with regular faces of two kinds round the origin.
    #[must_use]
    pub fn archimedean(solid: Archimedean) -> Self {
        let made = match solid {
            Archimedean::Truncated(solid) => {
                let ratio = 1.0 / (2.0 + 2.0 * (PI / f64::from(solid.corners())).cos());
                Self::platonic(solid).truncated(ratio)
            }
            Archimedean::Cuboctahedron => Self::platonic(Platonic::Cube).rectified(),
            Archimedean::Icosidodecahedron => Self::platonic(Platonic::Icosahedron).rectified(),
        };
        made.expect("a regular solid is closed and has three edges at each vertex")
    }
}
