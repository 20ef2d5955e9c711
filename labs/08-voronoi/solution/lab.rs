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
    // BEGIN SOLUTION
    // STARTER: let _ = (a, b, c);
    // STARTER: todo!("circle_centre")
    if turn(a, b, c) == Turn::Straight {
        return None;
    }
    // All relative to a: so nothing is lost if the triangle is far from 0.
    let (px, py) = (b.x - a.x, b.y - a.y);
    let (qx, qy) = (c.x - a.x, c.y - a.y);
    let (pp, qq) = (px * px + py * py, qx * qx + qy * qy);
    let twice = 2.0 * (px * qy - py * qx);
    let x = (qy * pp - py * qq) / twice;
    let y = (px * qq - qx * pp) / twice;
    Some(Point { x: a.x + x, y: a.y + y })
    // END SOLUTION
}

/// The dual, and what becomes of it.
impl Dcel {
    /// Task 2. The dual: the face f becomes the vertex f, the vertex v becomes the face v, the half-edge h becomes the
    /// half-edge h, which crosses it from right to left. All vertices are at (0, 0), the outer face may be any.
    pub fn dual(&self) -> Dcel {
        // BEGIN SOLUTION
        // STARTER: // 1. Make the vertices, faces and half-edges, with origins and twins.
        // STARTER:
        // STARTER: // 2. Set next and prev.
        // STARTER:
        // STARTER: // 3. Set the faces, and what faces and vertices refer to.
        // STARTER: todo!("dual")
        let mut dual = Dcel::default();

        // 1. Make the vertices, faces and half-edges, with origins and twins.
        for _ in 0..self.faces.len() {
            dual.new_vertex(0.0, 0.0);
        }
        for _ in 0..self.vertices.len() {
            dual.new_face();
        }
        for h in 0..self.half_edges.len() {
            let right = self.face(self.twin(h));
            dual.new_half_edge(right);
        }
        for h in 0..self.half_edges.len() {
            dual.half_edges[h].twin = Some(self.twin(h));
        }

        // 2. Set next and prev.
        for h in 0..self.half_edges.len() {
            let after = self.twin(self.prev(h));
            dual.make_next(h, after);
        }

        // 3. Set the faces, and what faces and vertices refer to.
        for h in 0..self.half_edges.len() {
            dual.half_edges[h].face = Some(self.origin(h));
        }
        for f in 0..self.faces.len() {
            let inside = self.incident_half_edge(f);
            dual.vertices[f].outgoing_half_edge = Some(self.twin(inside));
        }
        for v in 0..self.vertices.len() {
            dual.faces[v].incident_half_edge = Some(self.outgoing_half_edge(v));
        }
        dual
        // END SOLUTION
    }

    // BEGIN SOLUTION
    // STARTER: // Functions of your own can stand here.
    /// The centre of the circle of a triangle.
    fn centre(&self, f: FaceId) -> Point {
        let h = self.incident_half_edge(f);
        let [a, b, c] = [h, self.next(h), self.prev(h)].map(|h| self.position(self.origin(h)));
        circle_centre(a, b, c).unwrap_or(a)
    }
    // END SOLUTION

    /// Task 3. The dual of a Delaunay triangulation, with each vertex at the centre of the circle of its triangle. The
    /// vertex of the outer face stays at (0, 0).
    pub fn voronoi(&self) -> Dcel {
        // BEGIN SOLUTION
        // STARTER: todo!("voronoi")
        let mut voronoi = self.dual();
        for f in 0..self.faces.len() {
            if f != self.outer_face {
                voronoi.vertices[f].pos = self.centre(f);
            }
        }
        voronoi
        // END SOLUTION
    }

    /// Task 4. The Voronoi edge that crosses the edge of `h`, a half-edge of the outer face: where it starts, and in
    /// which direction it runs on for ever. `None` for other half-edges.
    pub fn ray(&self, h: HalfEdgeId) -> Option<(Point, Point)> {
        // BEGIN SOLUTION
        // STARTER: let _ = h;
        // STARTER: todo!("ray")
        if self.face(h) != self.outer_face {
            return None;
        }
        let start = self.centre(self.face(self.twin(h)));
        let (p, q) = (self.position(self.origin(h)), self.position(self.end(h)));
        // From p to q, turned to the left: there is the outer face.
        Some((start, Point { x: p.y - q.y, y: q.x - p.x }))
        // END SOLUTION
    }

    /// Task 5. The corners of the Voronoi cell of the vertex `v`, counter-clockwise: one for each triangle at `v`. If
    /// the cell is unbounded, the first corner is that of the triangle which comes after the outer face.
    pub fn cell(&self, v: VertexId) -> Vec<Point> {
        // BEGIN SOLUTION
        // STARTER: let _ = v;
        // STARTER: todo!("cell")
        let mut cell = Vec::new();
        let mut gap = 0;
        for h in self.round_vertex(v) {
            let f = self.face(h);
            if f == self.outer_face {
                gap = cell.len();
            } else {
                cell.push(self.centre(f));
            }
        }
        cell.rotate_left(gap);
        cell
        // END SOLUTION
    }
}

/// Task 6. Draws the Voronoi diagram: a line for each edge between two triangles, a line for each ray, up to the frame,
/// a dot for each site.
pub fn picture(dcel: &Dcel, svg: &mut Svg) {
    // BEGIN SOLUTION
    // STARTER: let _ = (dcel, svg);
    // STARTER: todo!("picture")
    let voronoi = dcel.voronoi();
    for h in 0..dcel.half_edges.len() {
        let there = dcel.twin(h);
        if let Some((start, direction)) = dcel.ray(h) {
            svg.line(start, frame::leave(start, direction));
        } else if h < there && dcel.ray(there).is_none() {
            svg.line(voronoi.position(voronoi.origin(h)), voronoi.position(voronoi.origin(there)));
        }
    }
    for vertex in &dcel.vertices {
        svg.dot(vertex.pos);
    }
    // END SOLUTION
}
