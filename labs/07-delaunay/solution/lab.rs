//! Your part of the lab: edges that are legal, edges that can be flipped, and flips until every edge is legal.
//!
//! The tasks are numbered as in the handout, README.md. Replace each `todo!(…)` by code; the functions that help
//! are in `dcel.rs`, `walks.rs` and `circle.rs`. `cargo test` says how far you are.

#[allow(unused_imports)]
use crate::circle::{InCircle, in_circle};
#[allow(unused_imports)]
use crate::dcel::{Dcel, FaceId, HalfEdgeId, Point, VertexId};
use crate::refusal::Refusal;
use crate::svg::Svg;
#[allow(unused_imports)]
use crate::walks::{Turn, turn};

/// The edges of a triangulation.
impl Dcel {
    /// Task 1. Whether the edge of `h` is legal: on the border, or no corner across it lies inside of a circle.
    pub fn is_legal(&self, h: HalfEdgeId) -> bool {
        // BEGIN SOLUTION
        // STARTER: let _ = h;
        // STARTER: todo!("is_legal")
        let twin = self.twin(h);
        if self.face(h) == self.outer_face || self.face(twin) == self.outer_face {
            return true;
        }
        let corners = [h, twin, self.prev(h), self.prev(twin)];
        let [a, b, c, d] = corners.map(|corner| self.position(self.origin(corner)));
        in_circle(a, b, c, d) != InCircle::Inside
        // END SOLUTION
    }

    /// Task 2. Whether the edge of `h` can be flipped; if not, why.
    pub fn can_flip(&self, h: HalfEdgeId) -> Result<(), Refusal> {
        // BEGIN SOLUTION
        // STARTER: let _ = h;
        // STARTER: todo!("can_flip")
        let twin = self.twin(h);
        for half_edge in [h, twin] {
            if self.face(half_edge) == self.outer_face {
                return Err(Refusal::OnBorder { half_edge });
            }
        }
        let [a, b, c, d] = [h, twin, self.prev(h), self.prev(twin)].map(|corner| self.origin(corner));
        for (before, vertex, after) in [(c, a, d), (d, b, c)] {
            let [p, q, r] = [before, vertex, after].map(|v| self.position(v));
            if turn(p, q, r) != Turn::Left {
                return Err(Refusal::NotConvex { vertex });
            }
        }
        Ok(())
        // END SOLUTION
    }

    /// Task 3. Flips the edge of `h`, which has a triangle on each side: it turns counter-clockwise. No record is made.
    pub fn flip(&mut self, h: HalfEdgeId) {
        // BEGIN SOLUTION
        // STARTER: // Read all that you need before you change anything.
        // STARTER: let _ = h;
        // STARTER:
        // STARTER: // 1. Set the origins of both halves, and what the vertices refer to.
        // STARTER:
        // STARTER: // 2. Set next and prev in both triangles.
        // STARTER:
        // STARTER: // 3. Set the faces, and what these refer to.
        // STARTER: todo!("flip")
        let twin = self.twin(h);
        let (bc, ca) = (self.next(h), self.prev(h));
        let (ad, db) = (self.next(twin), self.prev(twin));
        let (a, b) = (self.origin(h), self.origin(twin));
        let (c, d) = (self.origin(ca), self.origin(db));
        let (f, g) = (self.face(h), self.face(twin));

        // 1. Set the origins of both halves, and what the vertices refer to.
        self.half_edges[h].origin = Some(d);
        self.half_edges[twin].origin = Some(c);
        self.vertices[a].outgoing_half_edge = Some(ad);
        self.vertices[b].outgoing_half_edge = Some(bc);

        // 2. Set next and prev in both triangles.
        self.make_next(h, ca);
        self.make_next(ca, ad);
        self.make_next(ad, h);
        self.make_next(twin, db);
        self.make_next(db, bc);
        self.make_next(bc, twin);

        // 3. Set the faces, and what these refer to.
        self.half_edges[ad].face = Some(f);
        self.half_edges[bc].face = Some(g);
        self.faces[f].incident_half_edge = Some(h);
        self.faces[g].incident_half_edge = Some(twin);
        // END SOLUTION
    }

    // Functions of your own can stand here.

    /// Task 4. Flips edges that are not legal until all are. Returns the flipped edges in their order, each by one of
    /// its halves.
    pub fn delaunify(&mut self) -> Vec<HalfEdgeId> {
        // BEGIN SOLUTION
        // STARTER: todo!("delaunify")
        let mut suspects: Vec<HalfEdgeId> = (0..self.half_edges.len()).collect();
        let mut flipped = Vec::new();
        while let Some(h) = suspects.pop() {
            if self.is_legal(h) {
                continue;
            }
            self.flip(h);
            flipped.push(h);
            let twin = self.twin(h);
            suspects.extend([self.next(h), self.prev(h), self.next(twin), self.prev(twin)]);
        }
        flipped
        // END SOLUTION
    }

    /// Task 5. The smallest angle of all triangles, in radians.
    pub fn smallest_angle(&self) -> f64 {
        // BEGIN SOLUTION
        // STARTER: todo!("smallest_angle")
        let mut smallest = f64::INFINITY;
        for h in 0..self.half_edges.len() {
            if self.face(h) == self.outer_face {
                continue;
            }
            let [p, q, r] = [h, self.next(h), self.prev(h)].map(|corner| self.position(self.origin(corner)));
            let (ux, uy, vx, vy) = (q.x - p.x, q.y - p.y, r.x - p.x, r.y - p.y);
            let angle = (ux * vy - uy * vx).atan2(ux * vx + uy * vy);
            smallest = smallest.min(angle);
        }
        smallest
        // END SOLUTION
    }
}

/// Task 6. Draws a triangulation: a circle round each triangle, a line for each edge, a dot for each vertex.
pub fn picture(dcel: &Dcel, svg: &mut Svg) {
    // BEGIN SOLUTION
    // STARTER: let _ = (dcel, svg);
    // STARTER: todo!("picture")
    for f in (0..dcel.faces.len()).filter(|&f| f != dcel.outer_face) {
        let first = dcel.incident_half_edge(f);
        let [a, b, c] = [first, dcel.next(first), dcel.prev(first)].map(|h| dcel.position(dcel.origin(h)));
        svg.circle(a, b, c);
    }
    for h in 0..dcel.half_edges.len() {
        let twin = dcel.twin(h);
        if h < twin {
            svg.line(dcel.position(dcel.origin(h)), dcel.position(dcel.origin(twin)));
        }
    }
    for vertex in &dcel.vertices {
        svg.dot(vertex.pos);
    }
    // END SOLUTION
}
