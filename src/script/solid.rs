//! What scripts in space start from.
//!
//! ```text
//!   solid cube                        # one of Plato's five
//!   remove_face f0                    # a box without a lid
//! ```

use crate::solid::{Platonic, Polyhedron, SolidError};
use crate::topology::PolygonList;
use std::fmt;

/// What a script in space starts from. It prints as the first line of the script.
#[derive(Clone, PartialEq, Debug)]
#[non_exhaustive]
pub enum SolidStart {
    /// `solid NAME`: one of the regular solids.
    Platonic(Platonic),
    /// `mesh x y z ... / i j k ... / ...`: [`Polyhedron::from_polygons`].
    Mesh {
        /// The points.
        points: Vec<[f64; 3]>,
        /// The faces, by numbers of points from 0.
        faces: PolygonList,
    },
}

impl SolidStart {
    /// The surface. Cost: linear.
    ///
    /// # Errors
    /// [`SolidError`] if the faces make no surface.
    pub fn build(&self) -> Result<Polyhedron, SolidError> {
        match self {
            Self::Platonic(solid) => Ok(Polyhedron::platonic(*solid)),
            Self::Mesh { points, faces } => Polyhedron::from_polygons(points.clone(), faces),
        }
    }
}

impl fmt::Display for SolidStart {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Platonic(solid) => write!(f, "solid {}", solid.name()),
            Self::Mesh { points, faces } => {
                f.write_str("mesh")?;
                points.iter().flatten().try_for_each(|x| write!(f, " {x}"))?;
                super::kernel::write_faces(f, faces)
            }
        }
    }
}
