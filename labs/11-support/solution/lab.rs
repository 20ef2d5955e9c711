//! Your part of the lab: a mesh that changes, and the support function of a convex polyhedron.
//!
//! The tasks are numbered as in the handout, README.md. Replace each `todo!(…)` by code; the functions that help
//! are in `dcel.rs` and `height.rs`. `cargo test` says how far you are.

use crate::dcel::{FaceId, Mesh, Place, VertexId};
use crate::svg::Svg;
// BEGIN SOLUTION
// STARTER:
use crate::dcel::{Face, HalfEdge, HalfEdgeId, NO_HALF_EDGE, Vertex};
use crate::height::{higher, projected};
use std::cmp::Ordering;
// END SOLUTION
/// A mesh that changes.
impl Mesh {
    /// Task 1. Adds a vertex that has no face yet; returns its number. The vertex that became free last is used again; only
    /// if none is free, the list grows.
    pub fn add_vertex(&mut self, pos: Place) -> VertexId {
        // BEGIN SOLUTION
        // STARTER: let _ = pos;
        // STARTER: todo!("add_vertex")
        let vertex = Vertex { outgoing_half_edge: None, pos, live: true };
        match self.free_vertices.pop() {
            Some(v) => {
                self.vertices[v] = vertex;
                v
            }
            None => {
                self.vertices.push(vertex);
                self.vertices.len() - 1
            }
        }
        // END SOLUTION
    }
    // BEGIN SOLUTION
    // STARTER:

    /// A face that has no half-edge yet.
    fn new_face(&mut self) -> FaceId {
        let face = Face { incident_half_edge: None, live: true };
        if let Some(f) = self.free_faces.pop() {
            self.faces[f] = face;
            return f;
        }
        self.faces.push(face);
        self.faces.len() - 1
    }

    /// Both sides of a new edge without faces; returns the side from `a` to `b`.
    fn new_edge(&mut self, a: VertexId, b: VertexId) -> HalfEdgeId {
        let there = self.new_half_edge(a);
        let back = self.new_half_edge(b);
        self.half_edges[there].twin = Some(back);
        self.half_edges[back].twin = Some(there);
        self.edges.insert((a, b), there);
        self.edges.insert((b, a), back);
        there
    }

    fn new_half_edge(&mut self, origin: VertexId) -> HalfEdgeId {
        let half_edge = HalfEdge { origin: Some(origin), live: true, ..NO_HALF_EDGE };
        if let Some(h) = self.free_half_edges.pop() {
            self.half_edges[h] = half_edge;
            return h;
        }
        self.half_edges.push(half_edge);
        self.half_edges.len() - 1
    }
    // END SOLUTION
    /// Task 2. Adds the triangle a, b, c, counter-clockwise; returns its number. `None`, and nothing has changed, if two of
    /// the corners are the same, if one of them is no vertex, or if one of the half-edges a-b, b-c, c-a has a face
    /// already.
    pub fn add_face(&mut self, a: VertexId, b: VertexId, c: VertexId) -> Option<FaceId> {
        // BEGIN SOLUTION
        // STARTER: let _ = (a, b, c);
        // STARTER: todo!("add_face")
        let corners = [(a, b), (b, c), (c, a)];
        for (from, to) in corners {
            let is_vertex = from < self.vertices.len() && self.vertices[from].live;
            let side = self.half_edge_between(from, to);
            if from == to || !is_vertex || side.is_some_and(|h| self.face(h).is_some()) {
                return None;
            }
        }
        let f = self.new_face();
        let mut sides = [0; 3];
        for (side, (from, to)) in sides.iter_mut().zip(corners) {
            *side = match self.half_edge_between(from, to) {
                Some(h) => h,
                None => self.new_edge(from, to),
            };
            self.half_edges[*side].face = Some(f);
            self.vertices[from].outgoing_half_edge = Some(*side);
        }
        for i in 0..3 {
            self.half_edges[sides[i]].next = Some(sides[(i + 1) % 3]);
            self.half_edges[sides[i]].prev = Some(sides[(i + 2) % 3]);
        }
        self.faces[f].incident_half_edge = Some(sides[0]);
        Some(f)
        // END SOLUTION
    }

    /// Task 3. Removes a triangle. An edge that has no face on its other side either goes with it; the vertices stay.
    pub fn remove_face(&mut self, f: FaceId) {
        // BEGIN SOLUTION
        // STARTER: let _ = f;
        // STARTER: todo!("remove_face")
        // All that is read is read before anything is written.
        let first = self.incident_half_edge(f);
        let sides = [first, self.next(first), self.prev(first)];
        let corners = sides.map(|side| self.origin(side));
        for side in sides {
            let half_edge = &mut self.half_edges[side];
            (half_edge.face, half_edge.next, half_edge.prev) = (None, None, None);
        }
        for side in sides {
            let twin = self.twin(side);
            if self.face(twin).is_none() {
                let (from, to) = (self.origin(side), self.origin(twin));
                self.edges.remove(&(from, to));
                self.edges.remove(&(to, from));
                for h in [side, twin] {
                    self.half_edges[h] = NO_HALF_EDGE;
                    self.free_half_edges.push(h);
                }
            }
        }
        for v in corners {
            let mut with_face = None;
            for (_, h) in self.half_edges_from(v) {
                if self.face(h).is_some() {
                    with_face = Some(h);
                }
            }
            self.vertices[v].outgoing_half_edge = with_face;
        }
        self.faces[f] = Face { incident_half_edge: None, live: false };
        self.free_faces.push(f);
        // END SOLUTION
    }

    /// Task 4. Removes a vertex, and first all triangles that have it as a corner.
    pub fn remove_vertex(&mut self, v: VertexId) {
        // BEGIN SOLUTION
        // STARTER: let _ = v;
        // STARTER: todo!("remove_vertex")
        let mut faces = Vec::new();
        for (_, h) in self.half_edges_from(v) {
            faces.extend(self.face(h));
        }
        for f in faces {
            self.remove_face(f);
        }
        self.vertices[v].live = false;
        self.free_vertices.push(v);
        // END SOLUTION
    }
}

/// The support function.
impl Mesh {
    /// Task 5. A vertex that no other one is higher than in the direction `d`, found by looking at all; `None` if there is
    /// no vertex.
    pub fn support_by_scan(&self, d: Place) -> Option<VertexId> {
        // BEGIN SOLUTION
        // STARTER: let _ = d;
        // STARTER: todo!("support_by_scan")
        let mut best: Option<VertexId> = None;
        for v in 0..self.vertices.len() {
            let vertex = self.vertices[v];
            if vertex.live && best.is_none_or(|b| higher(d, vertex.pos, self.position(b)) == Ordering::Greater) {
                best = Some(v);
            }
        }
        best
        // END SOLUTION
    }

    /// Task 6. The vertices of a climb that begins at `from`: from each to its highest neighbour in the direction `d`, as
    /// long as that one is higher.
    pub fn climb(&self, from: VertexId, d: Place) -> Vec<VertexId> {
        // BEGIN SOLUTION
        // STARTER: let _ = (from, d);
        // STARTER: todo!("climb")
        let mut climb = vec![from];
        let mut at = from;
        loop {
            let mut best = at;
            for (neighbour, _) in self.half_edges_from(at) {
                if higher(d, self.position(neighbour), self.position(best)) == Ordering::Greater {
                    best = neighbour;
                }
            }
            if best == at {
                return climb;
            }
            climb.push(best);
            at = best;
        }
        // END SOLUTION
    }

    /// Task 7. A highest vertex of a convex polyhedron in the direction `d`, found by climbing from `from`, across
    /// plateaus, too.
    pub fn support(&self, from: VertexId, d: Place) -> VertexId {
        // BEGIN SOLUTION
        // STARTER: let _ = (from, d);
        // STARTER: todo!("support")
        let mut at = from;
        'climb: loop {
            for v in self.climb(at, d) {
                at = v;
            }
            // All vertices of the plateau, neighbour by neighbour; is one of them beside a higher vertex?
            let mut plateau = vec![at];
            let mut met = std::collections::BTreeSet::from([at]);
            while let Some(v) = plateau.pop() {
                for (neighbour, _) in self.half_edges_from(v) {
                    match higher(d, self.position(neighbour), self.position(at)) {
                        Ordering::Greater => {
                            at = neighbour;
                            continue 'climb;
                        }
                        Ordering::Equal if met.insert(neighbour) => plateau.push(neighbour),
                        _ => {}
                    }
                }
            }
            return at;
        }
        // END SOLUTION
    }
}

/// Task 8. Draws a polyhedron with a climb: a line for each edge, a dot at each vertex of the climb from `from` in the
/// direction `d`, where `projected` says that they are.
pub fn picture(mesh: &Mesh, from: VertexId, d: Place, svg: &mut Svg) {
    // BEGIN SOLUTION
    // STARTER: let _ = (mesh, from, d, svg);
    // STARTER: todo!("picture")
    for &(a, b) in mesh.edges.keys() {
        if a < b {
            svg.line(projected(mesh.position(a)), projected(mesh.position(b)));
        }
    }
    for v in mesh.climb(from, d) {
        svg.dot(projected(mesh.position(v)));
    }
    // END SOLUTION
}
