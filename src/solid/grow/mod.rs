//! Whole surfaces from two primitives: vertex split and face split.
//!
//! ```text
//!   ring, a double-sided disc            torus seed
//!     │                                      │
//!     ├── extrude ──> cylinder ── move ──>   ├── divide, cut across, divide, cut across ──> n x m torus
//!     │                  │      sphere with  │
//!     │                  │      flat poles   └ the same steps on both sides of a ring ────> n x m grid
//!     │                  ├── pole ─> cone, sphere with poles
//!     │                  └── extrude sideways ─> tessellated box
//!     └── pole, quads in steps of two
//! ```
//!
//! Both primitives keep the genus, so a ring gives spheres only and a torus needs a seed of its own. All procedures
//! here see a structure through [`Primitives`], which has no other way to change it.
//!
//! Source: the GenMesh article (*Half-edge based mesh representations: practice*), whose recipes these are; how
//! faces are extruded it leaves open.
//!
//! ```text
//!   cuboid.rs  The tessellated cube
//!   error.rs   Why a surface cannot be grown
//!   fan.rs     A vertex in the middle of a face, and spokes to its corners
//!   placed.rs  Positions and masks that a shape gets while it grows
//!   shape.rs   The shapes that grow from a ring or from the torus seed, with their counts and positions
//!   spun.rs    Surfaces of revolution
//! ```

mod cuboid;
mod error;
mod extrude;
mod fan;
mod grid;
mod placed;
mod shape;
mod spun;

use crate::ids::{FaceId, HalfEdgeId, VertexId};
use crate::topology::{Dcel, SplitFaceError, SplitVertexError};

pub use error::GrowError;
pub use extrude::{Extruded, Wall, extrude};
pub use fan::{Fan, pole, quads};
pub use placed::{Placed, part};
pub use shape::{Grown, Shape};

/// A structure that can be read, and changed by the two primitives alone.
///
/// A caller who wants to see every single step gives the procedures an implementation that looks.
pub trait Primitives {
    /// The structure as it is.
    fn dcel(&self) -> &Dcel;

    /// [`Dcel::split_vertex`].
    ///
    /// # Errors
    /// Those of the primitive.
    fn split_vertex(&mut self, first: HalfEdgeId, last: HalfEdgeId)
    -> Result<(HalfEdgeId, VertexId), SplitVertexError>;

    /// [`Dcel::split_face`].
    ///
    /// # Errors
    /// Those of the primitive.
    fn split_face(&mut self, h1: HalfEdgeId, h2: HalfEdgeId) -> Result<(HalfEdgeId, FaceId), SplitFaceError>;
}

impl Primitives for Dcel {
    fn dcel(&self) -> &Dcel {
        self
    }

    fn split_vertex(
        &mut self,
        first: HalfEdgeId,
        last: HalfEdgeId,
    ) -> Result<(HalfEdgeId, VertexId), SplitVertexError> {
        Dcel::split_vertex(self, first, last)
    }

    fn split_face(&mut self, h1: HalfEdgeId, h2: HalfEdgeId) -> Result<(HalfEdgeId, FaceId), SplitFaceError> {
        Dcel::split_face(self, h1, h2)
    }
}
