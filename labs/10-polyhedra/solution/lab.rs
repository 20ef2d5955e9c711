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
        // BEGIN SOLUTION
        // STARTER: todo!("euler")
        let vertices = self.vertex_ids().len() as i64;
        let edges = self.half_edge_ids().len() as i64 / 2;
        let faces = self.face_ids().len() as i64;
        vertices - edges + faces
        // END SOLUTION
    }

    /// Task 1. How many edges have to be added until all faces are triangles: 0 if they are.
    pub fn missing_edges(&self) -> i64 {
        // BEGIN SOLUTION
        // STARTER: todo!("missing_edges")
        let half_edges = self.half_edge_ids().len() as i64;
        half_edges - 3 * self.face_ids().len() as i64
        // END SOLUTION
    }
}

/// Walking.
impl Polyhedron {
    /// Task 2. The vertices that an edge joins with `v`, in counter-clockwise order seen from outside, each once. It
    /// does not matter which of them comes first.
    pub fn vertices_around(&self, v: VertexId) -> Vec<VertexId> {
        // BEGIN SOLUTION
        // STARTER: let _ = v;
        // STARTER: todo!("vertices_around")
        let first = self.outgoing_half_edge(v);
        let mut around = Vec::new();
        let mut spoke = first;
        loop {
            around.push(self.destination(spoke));
            let incoming = self.prev(spoke);
            spoke = self.twin(incoming);
            if spoke == first {
                return around;
            }
        }
        // END SOLUTION
    }

    /// Task 3. `Some((p, q))` if every face has p corners and every vertex q edges, else `None`.
    pub fn regular(&self) -> Option<(usize, usize)> {
        // BEGIN SOLUTION
        // STARTER: todo!("regular")
        let mut corners = vec![0; self.faces.len()];
        let mut edges = vec![0; self.vertices.len()];
        for h in self.half_edge_ids() {
            corners[self.face(h)] += 1;
            edges[self.origin(h)] += 1;
        }
        let faces = self.face_ids();
        let (p, q) = (corners[faces[0]], edges[0]);
        let alike = faces.iter().all(|&f| corners[f] == p) && edges.iter().all(|&count| count == q);
        alike.then_some((p, q))
        // END SOLUTION
    }

    /// Task 4. The winged-edge table: a row for each edge, in the order of their numbers.
    pub fn winged_edges(&self) -> Vec<WingedEdge> {
        // BEGIN SOLUTION
        // STARTER: todo!("winged_edges")
        let number = |h: HalfEdgeId| h.min(self.twin(h));
        let mut table = Vec::new();
        for h in self.half_edge_ids() {
            let t = self.twin(h);
            if number(h) == h {
                table.push(WingedEdge {
                    edge: h,
                    start: self.origin(h),
                    end: self.origin(t),
                    left: self.face(h),
                    right: self.face(t),
                    left_before: number(self.prev(h)),
                    left_after: number(self.next(h)),
                    right_before: number(self.prev(t)),
                    right_after: number(self.next(t)),
                });
            }
        }
        table
        // END SOLUTION
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
        // BEGIN SOLUTION
        // STARTER: todo!("dual")
        use crate::polyhedron::Point;
        let mut dual = Polyhedron::default();
        for f in self.face_ids() {
            let first = self.incident_half_edge(f);
            let (mut sum, mut count, mut h) = ([0.0; 3], 0.0, first);
            loop {
                let p = self.position(self.origin(h));
                sum = [sum[0] + p.x, sum[1] + p.y, sum[2] + p.z];
                count += 1.0;
                h = self.next(h);
                if h == first {
                    break;
                }
            }
            let [x, y, z] = sum.map(|sum| sum / count);
            let middle = dual.new_vertex(Point { x, y, z });
            dual.vertices[middle].outgoing_half_edge = Some(self.twin(first));
        }
        for v in self.vertex_ids() {
            let face = dual.new_face();
            dual.faces[face].incident_half_edge = Some(self.outgoing_half_edge(v));
        }
        for h in self.half_edge_ids() {
            let (new, t) = (dual.new_half_edge(), self.twin(h));
            dual.half_edges[new].origin = Some(self.face(t));
            dual.half_edges[new].face = Some(self.origin(h));
            dual.half_edges[new].twin = Some(t);
            dual.half_edges[new].next = Some(self.twin(self.prev(h)));
            dual.half_edges[new].prev = Some(self.next(t));
        }
        dual
        // END SOLUTION
    }
}

/// Angles.
impl Polyhedron {
    /// Task 6. 2 pi minus the angles of all faces at `v`, in radians.
    pub fn deficit_angle(&self, v: VertexId) -> f64 {
        // BEGIN SOLUTION
        // STARTER: let _ = v;
        // STARTER: todo!("deficit_angle")
        let first = self.outgoing_half_edge(v);
        let here = self.position(v);
        let mut deficit = std::f64::consts::TAU;
        let mut spoke = first;
        loop {
            let last = self.twin(self.prev(spoke));
            let a = self.position(self.destination(spoke)).minus(here);
            let b = self.position(self.destination(last)).minus(here);
            deficit -= a.cross(b).length().atan2(a.dot(b));
            spoke = last;
            if spoke == first {
                return deficit;
            }
        }
        // END SOLUTION
    }

    /// Task 6. The angle inside the solid between the two faces of the edge of `h`, in radians: less than pi at a convex
    /// edge, more than pi at a reflex edge.
    pub fn dihedral_angle(&self, h: HalfEdgeId) -> f64 {
        // BEGIN SOLUTION
        // STARTER: let _ = h;
        // STARTER: todo!("dihedral_angle")
        let along = |h: HalfEdgeId| self.position(self.destination(h)).minus(self.position(self.origin(h)));
        let normal = |h: HalfEdgeId| along(h).cross(along(self.next(h)));
        let left = normal(h);
        let right = normal(self.twin(h));
        let bend = along(h).dot(left.cross(right)) / along(h).length();
        std::f64::consts::PI - bend.atan2(left.dot(right))
        // END SOLUTION
    }
}

/// Handles.
impl Polyhedron {
    /// Task 7. The genus: the number of handles of the surface. If the surface is not connected: `Err` with a vertex that
    /// no path of edges joins with vertex 0.
    pub fn genus(&self) -> Result<usize, VertexId> {
        // BEGIN SOLUTION
        // STARTER: todo!("genus")
        let mut reached = vec![false; self.half_edges.len()];
        let mut open = vec![self.outgoing_half_edge(0)];
        while let Some(h) = open.pop() {
            if !reached[h] {
                reached[h] = true;
                open.push(self.next(h));
                open.push(self.twin(h));
            }
        }
        for v in self.vertex_ids() {
            if !reached[self.outgoing_half_edge(v)] {
                return Err(v);
            }
        }
        Ok(((2 - self.euler()) / 2) as usize)
        // END SOLUTION
    }

    /// Task 8. Removes the edge of `h` and makes one face of the two beside it. The face on the left of `h` stays, the
    /// face on its right is removed. If both are the same face f: `Err(f)`, and nothing has changed.
    pub fn merge_faces(&mut self, h: HalfEdgeId) -> Result<(), FaceId> {
        // BEGIN SOLUTION
        // STARTER: let _ = h;
        // STARTER: todo!("merge_faces")
        let t = self.twin(h);
        let (stays, goes) = (self.face(h), self.face(t));
        if stays == goes {
            return Err(stays);
        }
        let mut g = self.next(t);
        while g != t {
            self.half_edges[g].face = Some(stays);
            g = self.next(g);
        }
        let (after_h, after_t) = (self.next(h), self.next(t));
        self.make_next(self.prev(h), after_t);
        self.make_next(self.prev(t), after_h);
        self.faces[stays].incident_half_edge = Some(after_h);
        let (from, to) = (self.origin(h), self.origin(t));
        self.vertices[from].outgoing_half_edge = Some(after_t);
        self.vertices[to].outgoing_half_edge = Some(after_h);
        self.remove_edge(h);
        self.remove_face(goes);
        Ok(())
        // END SOLUTION
    }

    /// Task 8. Merges faces until only one is left, and says whether the surface has no handle.
    pub fn is_genus_0(&mut self) -> bool {
        // BEGIN SOLUTION
        // STARTER: todo!("is_genus_0")
        for h in self.half_edge_ids() {
            // It may have gone as the twin of another one.
            if self.half_edges[h].twin.is_some() {
                let _ = self.merge_faces(h);
            }
        }
        let edges_left = self.half_edge_ids().len() / 2;
        edges_left + 1 == self.vertex_ids().len()
        // END SOLUTION
    }
}

/// Task 9. Draws the polyhedron and its dual: a line for each edge of both, a dot for each vertex of both.
pub fn picture(solid: &Polyhedron, svg: &mut Svg) {
    // BEGIN SOLUTION
    // STARTER: let _ = (solid, svg);
    // STARTER: todo!("picture")
    let dual = solid.dual();
    for drawn in [solid, &dual] {
        for h in drawn.half_edge_ids() {
            if h < drawn.twin(h) {
                svg.line(drawn.position(drawn.origin(h)), drawn.position(drawn.destination(h)));
            }
        }
        for v in drawn.vertex_ids() {
            svg.dot(drawn.position(v));
        }
    }
    // END SOLUTION
}
