//! Your part of the lab: two primitives on a half-edge structure, and the surfaces that grow from them.
//!
//! The tasks are numbered as in the handout, README.md. Replace each `todo!(…)` by code; the functions that help
//! are in `dcel.rs` and `walks.rs`. `cargo test` says how far you are.

use crate::dcel::{Dcel, HalfEdgeId, VertexId};
use crate::svg::{Place, Svg};

/// Task 1. The double-sided disc: a polygon of `sides` corners with two faces.
pub fn ring(sides: usize) -> Dcel {
    let _ = sides;
    todo!("ring")
}

/// Task 1. The torus with one vertex, one face and two edges.
pub fn torus_seed() -> Dcel {
    todo!("torus_seed")
}

/// The two primitives.
impl Dcel {
    /// Task 2. Splits the vertex where `first` and `last` start: the half-edges from `first` on, counter-clockwise, up
    /// to but without `last`, start at a new vertex afterwards. Returns the new half-edge, from the old vertex to
    /// the new one. `None` if the two do not start at one vertex.
    pub fn split_vertex(&mut self, first: HalfEdgeId, last: HalfEdgeId) -> Option<HalfEdgeId> {
        let _ = (first, last);
        todo!("split_vertex")
    }

    /// Task 3. Splits the face of `h1` and `h2` by an edge between their origins. Returns the new half-edge from the
    /// origin of `h1` to the origin of `h2`; on its left lies the new face. `None` if the two have different faces.
    pub fn split_face(&mut self, h1: HalfEdgeId, h2: HalfEdgeId) -> Option<HalfEdgeId> {
        let _ = (h1, h2);
        todo!("split_face")
    }

    /// Task 4. V - E + F.
    pub fn euler(&self) -> i64 {
        todo!("euler")
    }

    /// Task 4. How many handles the surface has. It is closed and connected.
    pub fn genus(&self) -> i64 {
        todo!("genus")
    }
}

/// What the primitives make together.
impl Dcel {
    /// Task 5. Puts a vertex into the face of `h`, and a spoke to each of its corners. Returns the new vertex.
    pub fn pole(&mut self, h: HalfEdgeId) -> VertexId {
        let _ = h;
        todo!("pole")
    }

    /// Task 6. Cuts the edge of `h` into `pieces`. Returns the piece that starts where `h` started; those of the face
    /// of `h` follow each other.
    pub fn divide(&mut self, h: HalfEdgeId, pieces: usize) -> HalfEdgeId {
        let _ = (h, pieces);
        todo!("divide")
    }

    /// Task 6. The face of `h` has four sides, of `n`, `m`, `n` and `m` half-edges; `h` is the first of the first
    /// side. Cuts the face in n times m quads.
    pub fn fill(&mut self, h: HalfEdgeId, n: usize, m: usize) {
        let _ = (h, n, m);
        todo!("fill")
    }

    /// Task 7. Extrudes the face of `h`: the face moves up, and a wall of four sides stands under each of its sides.
    /// Returns the half-edge of the face above `h`.
    pub fn extrude(&mut self, h: HalfEdgeId) -> HalfEdgeId {
        let _ = h;
        todo!("extrude")
    }
}

/// Task 6. The grid: a square cut in n times m, its front and its back.
pub fn grid(n: usize, m: usize) -> Dcel {
    let _ = (n, m);
    todo!("grid")
}

/// Task 6. The torus of n times m quads.
pub fn torus(n: usize, m: usize) -> Dcel {
    let _ = (n, m);
    todo!("torus")
}

/// Task 7. The cylinder: a ring, extruded `layers` times.
pub fn cylinder(sides: usize, layers: usize) -> Dcel {
    let _ = (sides, layers);
    todo!("cylinder")
}

/// Task 7. The cube whose faces are cut in `steps` times `steps` squares.
pub fn cube(steps: usize) -> Dcel {
    let _ = steps;
    todo!("cube")
}

/// Task 7. The cone: a cylinder of one layer less, with a pole on top. `layers` is 1 or more.
pub fn cone(sides: usize, layers: usize) -> Dcel {
    let _ = (sides, layers);
    todo!("cone")
}

/// Task 7. The sphere: `bands` from pole to pole, the first and the last of triangles. `bands` is 2 or more.
pub fn sphere(sides: usize, bands: usize) -> Dcel {
    let _ = (sides, bands);
    todo!("sphere")
}

/// Where the vertices are in space.
impl Dcel {
    /// Task 8. The place of each vertex of a surface of revolution, by the number of the vertex. `rows` are the radius
    /// and the height of its rings, from below; one of radius 0 is a pole. `h` goes round the lowest ring, from the
    /// angle 0 on, with a wall on its left.
    pub fn revolve(&self, h: HalfEdgeId, rows: &[[f64; 2]]) -> Vec<Place> {
        let _ = (h, rows);
        todo!("revolve")
    }
}

/// Task 9. The picture: six surfaces in space, each in its panel, as the handout lists them.
pub fn picture(svg: &mut Svg) {
    let _ = svg;
    todo!("picture")
}
