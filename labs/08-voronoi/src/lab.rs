//! Your part of the lab: the dual of a half-edge structure, and the Voronoi diagram that it becomes.
//!
//! The tasks are numbered as in the handout, README.md. Replace each `todo!(…)` by code; the functions that help
//! are in `dcel.rs` and `walks.rs`. `cargo test` says how far you are.

#[allow(unused_imports)]
use crate::dcel::{Dcel, FaceId, HalfEdgeId, Point, VertexId};
#[allow(unused_imports)]
use crate::frame;
use crate::svg::Svg;
#[allow(unused_imports)]
use crate::walks::{Turn, turn};

/// Task 1. The centre of the circle through three points; `None` if they are on one line.
pub fn circle_centre(a: Point, b: Point, c: Point) -> Option<Point> {
    let _ = (a, b, c);
    todo!("circle_centre")
}

/// The dual, and what becomes of it.
impl Dcel {
    /// Task 2. The dual: the face f becomes the vertex f, the vertex v becomes the face v, the half-edge h becomes the
    /// half-edge h, which crosses it from right to left. All vertices are at (0, 0), the outer face may be any.
    pub fn dual(&self) -> Dcel {
        // 1. Make the vertices, faces and half-edges, with origins and twins.

        // 2. Set next and prev.

        // 3. Set the faces, and what faces and vertices refer to.
        todo!("dual")
    }

    // Functions of your own can stand here.

    /// Task 3. The dual of a Delaunay triangulation, with each vertex at the centre of the circle of its triangle. The
    /// vertex of the outer face stays at (0, 0).
    pub fn voronoi(&self) -> Dcel {
        todo!("voronoi")
    }

    /// Task 4. The Voronoi edge that crosses the edge of `h`, a half-edge of the outer face: where it starts, and in
    /// which direction it runs on for ever. `None` for other half-edges.
    pub fn ray(&self, h: HalfEdgeId) -> Option<(Point, Point)> {
        let _ = h;
        todo!("ray")
    }

    /// Task 5. The corners of the Voronoi cell of the vertex `v`, counter-clockwise: one for each triangle at `v`. If
    /// the cell is unbounded, the first corner is that of the triangle which comes after the outer face.
    pub fn cell(&self, v: VertexId) -> Vec<Point> {
        let _ = v;
        todo!("cell")
    }
}

/// Task 6. Draws the Voronoi diagram: a line for each edge between two triangles, a line for each ray, up to the frame,
/// a dot for each site.
pub fn picture(dcel: &Dcel, svg: &mut Svg) {
    let _ = (dcel, svg);
    todo!("picture")
}
