//! The five regular solids.
//!
//! ```text
//!                 corners of a face   faces at a vertex    V   E   F
//!   tetrahedron          3                   3             4   6   4     its own dual
//!   cube                 4                   3             8  12   6  ─┐ duals
//!   octahedron           3                   4             6  12   8  ─┘
//!   dodecahedron         5                   3            20  30  12  ─┐ duals
//!   icosahedron          3                   5            12  30  20  ─┘
//! ```
//!
//! Source: Euclid, *Elements*, book XIII.

use super::vector::{Vector, dot};
use super::{HullFaces, Polyhedron};
use std::cmp::Ordering;

crate::named! {
    /// A regular solid.
    #[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
    pub enum Platonic {
        /// Four triangles.
        Tetrahedron = "tetrahedron",
        /// Six squares.
        Cube = "cube",
        /// Eight triangles.
        Octahedron = "octahedron",
        /// Twelve pentagons.
        Dodecahedron = "dodecahedron",
        /// Twenty triangles.
        Icosahedron = "icosahedron",
    }

    /// Its name in small letters.
    fn name as Display;
    /// All five, by their number of faces.
    const ALL;
}

impl Platonic {
    /// The solid with faces and vertices exchanged.
    #[must_use]
    pub const fn dual(self) -> Self {
        match self {
            Self::Tetrahedron => Self::Tetrahedron,
            Self::Cube => Self::Octahedron,
            Self::Octahedron => Self::Cube,
            Self::Dodecahedron => Self::Icosahedron,
            Self::Icosahedron => Self::Dodecahedron,
        }
    }

    /// The edges at a vertex.
    #[must_use]
    pub const fn edges_at_a_vertex(self) -> u32 {
        self.dual().corners()
    }

    /// The corners of a face.
    #[must_use]
    pub const fn corners(self) -> u32 {
        match self {
            Self::Tetrahedron | Self::Octahedron | Self::Icosahedron => 3,
            Self::Cube => 4,
            Self::Dodecahedron => 5,
        }
    }
}

impl Polyhedron {
    /// A regular solid round the origin. Coordinates are 0, 1, the golden ratio and its inverse, each with either
    /// sign; so the faces of the dodecahedron are flat only up to rounding.
    #[must_use]
    pub fn platonic(solid: Platonic) -> Self {
        let phi = f64::midpoint(1.0, 5f64.sqrt());
        let hull = |points: &[Vector]| {
            let hull = Self::convex_hull(points, HullFaces::Whole);
            hull.expect("the corners of a regular solid do not lie in one plane").solid
        };
        match solid {
            Platonic::Tetrahedron => {
                let even = |p: &Vector| p.iter().filter(|&&x| x < 0.0).count() % 2 == 0;
                hull(&signs([1.0; 3]).into_iter().filter(even).collect::<Vec<_>>())
            }
            Platonic::Cube => hull(&signs([1.0; 3])),
            Platonic::Octahedron => hull(&turns(&signs([1.0, 0.0, 0.0]))),
            Platonic::Icosahedron => hull(&turns(&signs([0.0, 1.0, phi]))),
            Platonic::Dodecahedron => {
                let mut corners = signs([1.0; 3]);
                corners.extend(turns(&signs([0.0, phi, phi - 1.0])));
                let furthest = |direction: Vector| {
                    let by = |p: &Vector, q: &Vector| dot(*p, direction).partial_cmp(&dot(*q, direction));
                    corners.iter().copied().max_by(|p, q| by(p, q).unwrap_or(Ordering::Equal))
                };
                let dual = Self::platonic(Platonic::Icosahedron).dual().expect("the icosahedron is closed").solid;
                dual.moved(|_, p| furthest(p).unwrap_or(p))
            }
        }
    }
}

/// The point with all signs of its coordinates, those of zeros left alone.
fn signs(p: Vector) -> Vec<Vector> {
    let mut all = vec![p];
    for axis in (0..3).filter(|&axis| p[axis] != 0.0) {
        let mirrored = |mut q: Vector| {
            q[axis] = -q[axis];
            q
        };
        all = all.into_iter().flat_map(|q| [q, mirrored(q)]).collect();
    }
    all
}

/// The points with their coordinates moved on in turn: (x, y, z), (z, x, y), (y, z, x).
fn turns(points: &[Vector]) -> Vec<Vector> {
    (0..3).flat_map(|by| points.iter().map(move |p| [p[(3 - by) % 3], p[(4 - by) % 3], p[(5 - by) % 3]])).collect()
}
