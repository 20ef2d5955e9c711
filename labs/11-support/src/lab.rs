//! Your part of the lab: a mesh that changes, and the support function of a convex polyhedron.
//!
//! The tasks are numbered as in the handout, README.md. Replace each `todo!(…)` by code; the functions that help
//! are in `dcel.rs` and `height.rs`. `cargo test` says how far you are.

use crate::dcel::{FaceId, Mesh, Place, VertexId};
use crate::svg::Svg;

/// A mesh that changes.
impl Mesh {
    /// Task 1. Adds a vertex that has no face yet; returns its number. The vertex that became free last is used again; only
    /// if none is free, the list grows.
    pub fn add_vertex(&mut self, pos: Place) -> VertexId {
        let _ = pos;
        todo!("add_vertex")
    }

    /// Task 2. Adds the triangle a, b, c, counter-clockwise; returns its number. `None`, and nothing has changed, if two of
    /// the corners are the same, if one of them is no vertex, or if one of the half-edges a-b, b-c, c-a has a face
    /// already.
    pub fn add_face(&mut self, a: VertexId, b: VertexId, c: VertexId) -> Option<FaceId> {
        let _ = (a, b, c);
        todo!("add_face")
    }

    /// Task 3. Removes a triangle. An edge that has no face on its other side either goes with it; the vertices stay.
    pub fn remove_face(&mut self, f: FaceId) {
        let _ = f;
        todo!("remove_face")
    }

    /// Task 4. Removes a vertex, and first all triangles that have it as a corner.
    pub fn remove_vertex(&mut self, v: VertexId) {
        let _ = v;
        todo!("remove_vertex")
    }
}

/// The support function.
impl Mesh {
    /// Task 5. A vertex that no other one is higher than in the direction `d`, found by looking at all; `None` if there is
    /// no vertex.
    pub fn support_by_scan(&self, d: Place) -> Option<VertexId> {
        let _ = d;
        todo!("support_by_scan")
    }

    /// Task 6. The vertices of a climb that begins at `from`: from each to its highest neighbour in the direction `d`, as
    /// long as that one is higher.
    pub fn climb(&self, from: VertexId, d: Place) -> Vec<VertexId> {
        let _ = (from, d);
        todo!("climb")
    }

    /// Task 7. A highest vertex of a convex polyhedron in the direction `d`, found by climbing from `from`, across
    /// plateaus, too.
    pub fn support(&self, from: VertexId, d: Place) -> VertexId {
        let _ = (from, d);
        todo!("support")
    }
}

/// Task 8. Draws a polyhedron with a climb: a line for each edge, a dot at each vertex of the climb from `from` in the
/// direction `d`, where `projected` says that they are.
pub fn picture(mesh: &Mesh, from: VertexId, d: Place, svg: &mut Svg) {
    let _ = (mesh, from, d, svg);
    todo!("picture")
}
