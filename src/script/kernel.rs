//! What scripts without coordinates start from.
//!
//! ```text
//!   torus                             # one vertex, one face, two loops
//!   let a = split_vertex h0 h1        # a: from the old vertex to the new one
//!   split_face a h2                   # loops and parallel edges are legal here
//! ```

use crate::topology::{BuildError, Dcel, PolygonError, PolygonList};
use std::fmt;

/// What a script of the kernel starts from. It prints as the first line of the script.
///
/// ```
/// use dcel_kit::script::KernelStart;
/// use dcel_kit::topology::PolygonList;
/// let faces = PolygonList::from_triangles(&[[0, 1, 2], [2, 1, 3]]);
/// assert_eq!(KernelStart::Surface { vertices: 4, faces }.to_string(), "surface 4 / 0 1 2 / 2 1 3");
/// ```
#[derive(Clone, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum KernelStart {
    /// `ring N`: [`Dcel::polygon`], a double-sided disc.
    Ring(usize),
    /// `torus`: [`Dcel::torus`].
    Torus,
    /// `surface N / i j k ... / ...`: [`Dcel::from_polygons`], N vertices and their faces.
    Surface {
        /// How many vertices; those that no face uses are isolated.
        vertices: usize,
        /// The faces, by numbers of vertices from 0.
        faces: PolygonList,
    },
}

/// Why there is no such start.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum KernelStartError {
    /// Of a ring.
    #[error(transparent)]
    Ring(#[from] PolygonError),
    /// Of a surface.
    #[error(transparent)]
    Surface(#[from] BuildError),
}

impl KernelStart {
    /// The structure. Cost: linear.
    ///
    /// # Errors
    /// [`KernelStartError`] if the faces make no surface.
    pub fn build(&self) -> Result<Dcel, KernelStartError> {
        Ok(match self {
            Self::Ring(corners) => Dcel::polygon(*corners)?,
            Self::Torus => Dcel::torus(),
            Self::Surface { vertices, faces } => Dcel::from_polygons(*vertices, faces)?.dcel,
        })
    }
}

/// The corners of each face after a `/`.
pub(super) fn write_faces(f: &mut fmt::Formatter<'_>, faces: &PolygonList) -> fmt::Result {
    (0..faces.cycle_count()).try_for_each(|cycle| {
        f.write_str(" /")?;
        faces.cycle(cycle).iter().try_for_each(|corner| write!(f, " {corner}"))
    })
}

impl fmt::Display for KernelStart {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Ring(corners) => write!(f, "ring {corners}"),
            Self::Torus => f.write_str("torus"),
            Self::Surface { vertices, faces } => {
                write!(f, "surface {vertices}")?;
                write_faces(f, faces)
            }
        }
    }
}
