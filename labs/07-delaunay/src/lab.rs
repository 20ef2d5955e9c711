//! Your part of the lab: edges that are legal, edges that can be flipped, and flips until every edge is legal.
//!
//! The tasks are numbered as in the handout, README.md. Replace each `todo!(…)` by code; the functions that help
//! are in `dcel.rs`, `walks.rs` and `circle.rs`. `cargo test` says how far you are.

#[allow(unused_imports)]
use crate::circle::{InCircle, in_circle};
#[allow(unused_imports)]
use crate::dcel::{Dcel, FaceId, HalfEdgeId, Point, VertexId};
use crate::refusal::Refusal;
use crate::svg::Svg;
#[allow(unused_imports)]
use crate::walks::{Turn, turn};

/// The edges of a triangulation.
impl Dcel {
    /// Task 1. Whether the edge of `h` is legal: on the border, or no corner across it lies inside of a circle.
    pub fn is_legal(&self, h: HalfEdgeId) -> bool {
        let _ = h;
        todo!("is_legal")
    }

    /// Task 2. Whether the edge of `h` can be flipped; if not, why.
    pub fn can_flip(&self, h: HalfEdgeId) -> Result<(), Refusal> {
        let _ = h;
        todo!("can_flip")
    }

    /// Task 3. Flips the edge of `h`, which has a triangle on each side: it turns counter-clockwise. No record is made.
    pub fn flip(&mut self, h: HalfEdgeId) {
        // Read all that you need before you change anything.
        let _ = h;

        // 1. Set the origins of both halves, and what the vertices refer to.

        // 2. Set next and prev in both triangles.

        // 3. Set the faces, and what these refer to.
        todo!("flip")
    }

    // Functions of your own can stand here.

    /// Task 4. Flips edges that are not legal until all are. Returns the flipped edges in their order, each by one of
    /// its halves.
    pub fn delaunify(&mut self) -> Vec<HalfEdgeId> {
        todo!("delaunify")
    }

    /// Task 5. The smallest angle of all triangles, in radians.
    pub fn smallest_angle(&self) -> f64 {
        todo!("smallest_angle")
    }
}

/// Task 6. Draws a triangulation: a circle round each triangle, a line for each edge, a dot for each vertex.
pub fn picture(dcel: &Dcel, svg: &mut Svg) {
    let _ = (dcel, svg);
    todo!("picture")
}
