//! Your part of the lab: counting, walking and measuring on the surface of a polyhedron.
//!
//! The tasks are numbered as in the handout, README.md. Replace each `todo!(…)` by code; the functions that help
//! are in `polyhedron.rs`. `cargo test` says how far you are.

use crate::polyhedron::{FaceId, HalfEdgeId, Polyhedron, VertexId, WingedEdge};
use crate::svg::Svg;

/// Counting.
impl Polyhedron {
    /// Task 1. The number of vertices, minus that of edges, plus that of faces. What was removed does not count.
    pub fn euler(&self) -> i64 {
        todo!("euler")
    }

    /// Task 1. How many edges have to be added until all faces are triangles: 0 if they are.
    pub fn missing_edges(&self) -> i64 {
        todo!("missing_edges")
    }
}

/// Walking.
impl Polyhedron {
    /// Task 2. The vertices that an edge joins with `v`, in counter-clockwise order seen from outside, each once. It
    /// does not matter which of them comes first.
    pub fn vertices_around(&self, v: VertexId) -> Vec<VertexId> {
        let _ = v;
        todo!("vertices_around")
    }

    /// Task 3. `Some((p, q))` if every face has p corners and every vertex q edges, else `None`.
    pub fn regular(&self) -> Option<(usize, usize)> {
        todo!("regular")
    }

    /// Task 4. The winged-edge table: a row for each edge, in the order of their numbers.
    pub fn winged_edges(&self) -> Vec<WingedEdge> {
        todo!("winged_edges")
    }
}

/// The dual.
impl Polyhedron {
    /// Task 5. The dual: its vertex f stands in the middle of the face f of this one, its face v lies round the vertex v
    /// of this one, and its half-edge h crosses the half-edge h of this one from right to left.
    ///
    /// ```text
    ///              ●
    ///              │ h
    ///    face ◀────┼───── face of the twin        h runs upwards, the dual's h to the left
    ///              │
    ///              ● origin of h: on the left of the dual's h
    /// ```
    pub fn dual(&self) -> Polyhedron {
        todo!("dual")
    }
}

/// Angles.
impl Polyhedron {
    /// Task 6. 2 pi minus the angles of all faces at `v`, in radians.
    pub fn deficit_angle(&self, v: VertexId) -> f64 {
        let _ = v;
        todo!("deficit_angle")
    }

    /// Task 6. The angle inside the solid between the two faces of the edge of `h`, in radians: less than pi at a convex
    /// edge, more than pi at a reflex edge.
    pub fn dihedral_angle(&self, h: HalfEdgeId) -> f64 {
        let _ = h;
        todo!("dihedral_angle")
    }
}

/// Handles.
impl Polyhedron {
    /// Task 7. The genus: the number of handles of the surface. If the surface is not connected: `Err` with a vertex that
    /// no path of edges joins with vertex 0.
    pub fn genus(&self) -> Result<usize, VertexId> {
        todo!("genus")
    }

    /// Task 8. Removes the edge of `h` and makes one face of the two beside it. The face on the left of `h` stays, the
    /// face on its right is removed. If both are the same face f: `Err(f)`, and nothing has changed.
    pub fn merge_faces(&mut self, h: HalfEdgeId) -> Result<(), FaceId> {
        let _ = h;
        todo!("merge_faces")
    }

    /// Task 8. Merges faces until only one is left, and says whether the surface has no handle.
    pub fn is_genus_0(&mut self) -> bool {
        todo!("is_genus_0")
    }
}

/// Task 9. Draws the polyhedron and its dual: a line for each edge of both, a dot for each vertex of both.
pub fn picture(solid: &Polyhedron, svg: &mut Svg) {
    let _ = (solid, svg);
    todo!("picture")
}
