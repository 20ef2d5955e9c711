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
        // BEGIN SOLUTION
        // STARTER: let _ = f;
        // STARTER: todo!("incident_half_edges")
        let first = self.incident_half_edge(f);
        let mut half_edges = Vec::new();
        let mut h = first;
        loop {
            half_edges.push(h);
            h = self.next(h);
            if h == first {
                return half_edges;
            }
        }
        // END SOLUTION
    }

    /// Task 2. The vertices round the face `f` in counter-clockwise order. A vertex that the face meets twice is
    /// listed twice.
    pub fn incident_vertices(&self, f: FaceId) -> Vec<VertexId> {
        // BEGIN SOLUTION
        // STARTER: let _ = f;
        // STARTER: todo!("incident_vertices")
        let mut vertices = Vec::new();
        for h in self.incident_half_edges(f) {
            vertices.push(self.origin(h));
        }
        vertices
        // END SOLUTION
    }

    /// Task 3. The vertex that `h` ends at, found through its twin.
    pub fn destination(&self, h: HalfEdgeId) -> VertexId {
        // BEGIN SOLUTION
        // STARTER: let _ = h;
        // STARTER: todo!("destination")
        let twin = self.twin(h);
        self.origin(twin)
        // END SOLUTION
    }

    /// Task 3. The vertex that `h` ends at, found without its twin.
    pub fn destination_by_next(&self, h: HalfEdgeId) -> VertexId {
        // BEGIN SOLUTION
        // STARTER: let _ = h;
        // STARTER: todo!("destination_by_next")
        let next = self.next(h);
        self.origin(next)
        // END SOLUTION
    }

    /// Task 4. The half-edges that start at the vertex `v`, in counter-clockwise order round it, each once. It does
    /// not matter which of them comes first.
    pub fn outgoing_half_edges(&self, v: VertexId) -> Vec<HalfEdgeId> {
        // BEGIN SOLUTION
        // STARTER: let _ = v;
        // STARTER: todo!("outgoing_half_edges")
        let first = self.outgoing_half_edge(v);
        let mut star = Vec::new();
        let mut spoke = first;
        loop {
            star.push(spoke);
            // The half-edge before it ends here; turned round, it starts here.
            let incoming = self.prev(spoke);
            spoke = self.twin(incoming);
            if spoke == first {
                return star;
            }
        }
        // END SOLUTION
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
        // BEGIN SOLUTION
        // STARTER: let _ = (he1, he2);
        // STARTER:
        // STARTER: // 0. Is the call legal? If not, return false before anything is changed.
        // STARTER:
        // STARTER: // 1. Make the new face.
        // STARTER:
        // STARTER: // 2. Make the two new half-edges, twins of each other.
        // STARTER:
        // STARTER: // 3. Link them into the two cycles: next and prev, in four places.
        // STARTER:
        // STARTER: // 4. Let every half-edge know its face.
        // STARTER:
        // STARTER: // 5. Let each of the two faces know a half-edge of its own.
        // STARTER:
        // STARTER: // What you have written is graded step by step, also while this line still stands below it.
        // STARTER: todo!("split_face")
        // 0. Is the call legal? If not, return false before anything is changed.
        let face = self.face(he1);
        if self.face(he2) != face {
            return false;
        }
        if he1 == he2 {
            return false;
        }
        if self.next(he1) == he2 || self.next(he2) == he1 {
            return false;
        }

        // 1. Make the new face.
        let new_face = self.new_face();

        // 2. Make the two new half-edges, twins of each other.
        let there = self.new_half_edge(self.origin(he1));
        let back = self.new_half_edge(self.origin(he2));
        self.make_twin(there, back);

        // 3. Link them into the two cycles. Both prevs are read before either is written over.
        let before1 = self.prev(he1);
        let before2 = self.prev(he2);
        self.make_next(before1, there);
        self.make_next(there, he2);
        self.make_next(before2, back);
        self.make_next(back, he1);

        // 4. Let every half-edge know its face: `back` joins the old one, the cycle of `there` is the new one.
        self.half_edges[back].face = Some(face);
        let mut h = there;
        loop {
            self.half_edges[h].face = Some(new_face);
            h = self.next(h);
            if h == there {
                break;
            }
        }

        // 5. Let each of the two faces know a half-edge of its own.
        self.faces[face].incident_half_edge = Some(back);
        self.faces[new_face].incident_half_edge = Some(there);
        true
        // END SOLUTION
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
        // BEGIN SOLUTION
        // STARTER: let _ = he;
        // STARTER:
        // STARTER: // 1. Make the vertex at the midpoint.
        // STARTER:
        // STARTER: // 2. Make two new half-edges; let all four have the right origins and twins.
        // STARTER:
        // STARTER: // 3. Set next, prev and face, and what the vertices refer to.
        // STARTER:
        // STARTER: // What you have written is graded step by step, also while this line still stands below it.
        // STARTER: todo!("split_in_half")
        let twin = self.twin(he);
        let end = self.origin(twin);

        // 1. Make the vertex at the midpoint.
        let p = self.position(self.origin(he));
        let q = self.position(end);
        let middle = self.new_vertex((p.x + q.x) / 2.0, (p.y + q.y) / 2.0);

        // 2. Make two new half-edges, the second half of the way there and the first half of the way back; let all
        // four have the right origins and twins: `twin` now starts in the middle.
        let there = self.new_half_edge(middle);
        let back = self.new_half_edge(end);
        self.make_twin(there, back);
        self.half_edges[twin].origin = Some(middle);

        // 3. Set next, prev and face, and what the vertices refer to. `there` is put in after `he`, then `back` before
        // `twin`. At a dangling edge `twin` is the next of `he`, so what precedes it is known only now: `there`.
        let after = self.next(he);
        self.make_next(he, there);
        self.make_next(there, after);
        let before = self.prev(twin);
        self.make_next(before, back);
        self.make_next(back, twin);
        self.half_edges[there].face = Some(self.face(he));
        self.half_edges[back].face = Some(self.face(twin));
        self.vertices[middle].outgoing_half_edge = Some(there);
        self.vertices[end].outgoing_half_edge = Some(back);
        // END SOLUTION
    }
}

/// Task 7. Draws the drawing of the handout, starting from the rectangle, with the two splits of the pen.
pub fn drawing(pen: &mut Pen) {
    // BEGIN SOLUTION
    // STARTER: let _ = pen;
    // STARTER: todo!("drawing")
    // The half-edge of a face that starts at a point: from the one that the face knows along next until it comes.
    fn corner(pen: &Pen, face: FaceId, x: f64, y: f64) -> HalfEdgeId {
        let mut h = pen.incident_half_edge(face);
        while pen.position(pen.origin(h)) != (crate::dcel::Point { x, y }) {
            h = pen.next(h);
        }
        h
    }

    // Draws a line through a face from a to b; on its left is the new face, which is returned.
    fn line(pen: &mut Pen, face: FaceId, a: (f64, f64), b: (f64, f64)) -> FaceId {
        let he1 = corner(pen, face, a.0, a.1);
        let he2 = corner(pen, face, b.0, b.1);
        pen.split_face(he1, he2);
        pen.face(pen.prev(he2))
    }

    // Halves the edge of a face that starts at a point.
    fn halve(pen: &mut Pen, face: FaceId, x: f64, y: f64) {
        let h = corner(pen, face, x, y);
        pen.split_in_half(h);
    }

    // The horizon, at a quarter of the height of the short sides.
    let sky = pen.face(0);
    halve(pen, sky, 250.0, -150.0);
    halve(pen, sky, 250.0, -150.0);
    halve(pen, sky, -250.0, 150.0);
    halve(pen, sky, -250.0, 0.0);
    let sea = line(pen, sky, (250.0, -75.0), (-250.0, -75.0));

    // The hull, with its keel at the middle of the lower side.
    halve(pen, sea, 250.0, -75.0);
    halve(pen, sea, 250.0, -75.0);
    halve(pen, sea, 0.0, -75.0);
    line(pen, sea, (0.0, -150.0), (-125.0, -75.0));
    line(pen, sea, (125.0, -75.0), (0.0, -150.0));
    let hull = sea;
    halve(pen, hull, 0.0, -150.0);
    halve(pen, hull, -125.0, -75.0);
    line(pen, hull, (62.5, -112.5), (-62.5, -112.5));

    // The mast, the jib and the pennant on its right.
    let west = line(pen, sky, (0.0, -75.0), (0.0, 150.0));
    halve(pen, sky, 0.0, 150.0);
    line(pen, sky, (125.0, -75.0), (0.0, 37.5));
    halve(pen, sky, 0.0, 150.0);
    halve(pen, sky, 250.0, 150.0);
    line(pen, sky, (0.0, 93.75), (125.0, 150.0));

    // The shore.
    halve(pen, sky, 250.0, -75.0);
    line(pen, sky, (250.0, -37.5), (125.0, -75.0));

    // The main sail on the left of the mast, and its topsail.
    let sail = line(pen, west, (0.0, 150.0), (-125.0, -75.0));
    halve(pen, sail, 0.0, 150.0);
    line(pen, sail, (-62.5, 37.5), (0.0, 37.5));

    // The sun.
    halve(pen, west, 0.0, 150.0);
    halve(pen, west, -250.0, 150.0);
    line(pen, west, (-250.0, 75.0), (-125.0, 150.0));
    // END SOLUTION
}

/// Task 8. Draws a structure: a filled polygon for each face but the outer one, a line for each edge, a dot for each
/// vertex.
pub fn picture(dcel: &Dcel, svg: &mut Svg) {
    // BEGIN SOLUTION
    // STARTER: let _ = (dcel, svg);
    // STARTER: todo!("picture")
    for f in 0..dcel.faces.len() {
        if f != dcel.outer_face {
            let mut corners = Vec::new();
            for v in dcel.incident_vertices(f) {
                corners.push(dcel.position(v));
            }
            svg.polygon(&corners);
        }
    }
    for h in 0..dcel.half_edges.len() {
        // Both sides are one edge: it is drawn once, from the side with the smaller number.
        if h < dcel.twin(h) {
            let from = dcel.position(dcel.origin(h));
            let to = dcel.position(dcel.destination(h));
            svg.line(from, to);
        }
    }
    for vertex in &dcel.vertices {
        svg.dot(vertex.pos);
    }
    // END SOLUTION
}
