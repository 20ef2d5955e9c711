//! Your part of the lab: walks along the structure, two splits, and a drawing made with them.
//!
//! The tasks are numbered as in the handout, README.md. Replace each `todo!(…)` by code; the functions that help
//! are in `dcel.rs`. `cargo test` says how far you are.

use crate::dcel::{Dcel, FaceId, HalfEdgeId, VertexId};
use crate::pen::Pen;
use crate::svg::Svg;

/// Walks.
impl Dcel {
    /// Task 1. The half-edges that have the face `f` on their left, in counter-clockwise order along it, each once.
    /// It does not matter which of them comes first.
    pub fn incident_half_edges(&self, f: FaceId) -> Vec<HalfEdgeId> {
        let _ = f;
        todo!("incident_half_edges")
    }

    /// Task 2. The vertices round the face `f` in counter-clockwise order. A vertex that the face meets twice is
    /// listed twice.
    pub fn incident_vertices(&self, f: FaceId) -> Vec<VertexId> {
        let _ = f;
        todo!("incident_vertices")
    }

    /// Task 3. The vertex that `h` ends at, found through its twin.
    pub fn destination(&self, h: HalfEdgeId) -> VertexId {
        let _ = h;
        todo!("destination")
    }

    /// Task 3. The vertex that `h` ends at, found without its twin.
    pub fn destination_by_next(&self, h: HalfEdgeId) -> VertexId {
        let _ = h;
        todo!("destination_by_next")
    }

    /// Task 4. The half-edges that start at the vertex `v`, in counter-clockwise order round it, each once. It does
    /// not matter which of them comes first.
    pub fn outgoing_half_edges(&self, v: VertexId) -> Vec<HalfEdgeId> {
        let _ = v;
        todo!("outgoing_half_edges")
    }
}

/// Splits.
impl Dcel {
    /// Task 5. Splits a face by a new edge between the origins of `he1` and `he2`.
    ///
    /// ```text
    ///       │                  ▲ he2           │     new face     ▲ he2
    ///       │                  │               │                  │
    ///       ●       face       ●       =>      ● ── there ──────▶ ●
    ///       │                  │               │ ◀────── back ─── │
    ///   he1 ▼                  │           he1 ▼       face       │
    /// ```
    ///
    /// The cycle through `he1` keeps the old face. The new face is on the left of `there`, the new half-edge that
    /// starts at the origin of `he1` and is followed by `he2`.
    ///
    /// Returns true. But if `he1` and `he2` have different faces, or are the same, or one of them is the next of the
    /// other, the call is illegal: then it returns false and nothing has changed.
    pub fn split_face(&mut self, he1: HalfEdgeId, he2: HalfEdgeId) -> bool {
        let _ = (he1, he2);

        // 0. Is the call legal? If not, return false before anything is changed.

        // 1. Make the new face.

        // 2. Make the two new half-edges, twins of each other.

        // 3. Link them into the two cycles: next and prev, in four places.

        // 4. Let every half-edge know its face.

        // 5. Let each of the two faces know a half-edge of its own.

        // What you have written is graded step by step, also while this line still stands below it.
        todo!("split_face")
    }

    /// Task 6. Splits the edge of `he` in two by a new vertex at its midpoint.
    ///
    /// ```text
    ///        ── he ──────────────▶              ── he ──▶     ──────▶
    ///      ●                       ●    =>    ●           ●           ●
    ///        ◀──────────── twin ──              ◀──────     ◀──────
    /// ```
    ///
    /// `he` keeps its origin. Whether its old twin keeps its origin, too, or starts at the new vertex is up to you.
    pub fn split_in_half(&mut self, he: HalfEdgeId) {
        let _ = he;

        // 1. Make the vertex at the midpoint.

        // 2. Make two new half-edges; let all four have the right origins and twins.

        // 3. Set next, prev and face, and what the vertices refer to.

        // What you have written is graded step by step, also while this line still stands below it.
        todo!("split_in_half")
    }
}

/// Task 7. Draws the drawing of the handout, starting from the rectangle, with the two splits of the pen.
pub fn drawing(pen: &mut Pen) {
    let _ = pen;
    todo!("drawing")
}

/// Task 8. Draws a structure: a filled polygon for each face but the outer one, a line for each edge, a dot for each
/// vertex.
pub fn picture(dcel: &Dcel, svg: &mut Svg) {
    let _ = (dcel, svg);
    todo!("picture")
}
