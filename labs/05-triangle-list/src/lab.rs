//! Your part of the lab: a half-edge structure from a list of faces, or the reason why there is none.
//!
//! The tasks are numbered as in the handout, README.md. Replace each `todo!(…)` by code; the functions that help
//! are in `dcel.rs`, what can be wrong with a list is in `refusal.rs`. `cargo test` says how far you are.

use crate::dcel::{Dcel, FaceId, Point, VertexId};
use crate::refusal::Refusal;
use crate::svg::Svg;

/// Task 1. Looks at a list of faces over vertices 0, 1, … `vertices` - 1, each face by its corners. If a face names a
/// vertex that there is not, has fewer than three corners, or has a vertex twice, the refusal says so.
pub fn check_faces(vertices: usize, faces: &[Vec<VertexId>]) -> Result<(), Refusal> {
    let _ = (vertices, faces);
    todo!("check_faces")
}

/// The steps.
impl Dcel {
    /// Task 2. Makes a face and a half-edge for each of its corners, in their order: origin, face, next and prev are
    /// set, twin is not. The face knows a half-edge of its own, and so does each corner that knew none. Returns the
    /// number of the face.
    pub fn add_face(&mut self, corners: &[VertexId]) -> FaceId {
        let _ = corners;
        todo!("add_face")
    }

    /// Task 3. Makes twins of each two half-edges that run between the same vertices in opposite directions. If two
    /// run in the same direction, the refusal names where they begin and end.
    pub fn match_twins(&mut self) -> Result<(), Refusal> {
        todo!("match_twins")
    }

    /// Task 4. Gives each half-edge without a twin one in the outer face, and links the new ones to cycles. If two of
    /// the new ones start at one vertex, the refusal names it.
    pub fn close_border(&mut self) -> Result<(), Refusal> {
        todo!("close_border")
    }
}

/// Task 5. The structure of a list of faces: vertex i stands at `points[i]`, f0 is the outer face, and face i of the
/// list becomes f(i+1).
pub fn from_faces(points: &[Point], faces: &[Vec<VertexId>]) -> Result<Dcel, Refusal> {
    let _ = (points, faces);
    todo!("from_faces")
}

/// Task 6. Draws a structure: a filled polygon for each face but the outer one, a line for each edge, a dot for each
/// vertex.
pub fn picture(dcel: &Dcel, svg: &mut Svg) {
    let _ = (dcel, svg);
    todo!("picture")
}
