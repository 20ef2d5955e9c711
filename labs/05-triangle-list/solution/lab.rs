//! Your part of the lab: a half-edge structure from a list of faces, or the reason why there is none.
//!
//! The tasks are numbered as in the handout, README.md. Replace each `todo!(…)` by code; the functions that help
//! are in `dcel.rs`, what can be wrong with a list is in `refusal.rs`. `cargo test` says how far you are.

use crate::dcel::{Dcel, FaceId, Point, VertexId};
use crate::refusal::Refusal;
use crate::svg::Svg;

/// Task 1. Looks at a list of faces over vertices 0, 1, … `vertices` - 1, each face by its corners. If a face names a
/// vertex that there is not, has fewer than three corners, or has a vertex twice, the refusal says so.
pub fn check_faces(vertices: usize, faces: &[Vec<VertexId>]) -> Result<(), Refusal> {
    // BEGIN SOLUTION
    // STARTER: let _ = (vertices, faces);
    // STARTER: todo!("check_faces")
    for (face, corners) in faces.iter().enumerate() {
        if corners.len() < 3 {
            return Err(Refusal::TooFewCorners { face });
        }
        for (i, &vertex) in corners.iter().enumerate() {
            if vertex >= vertices {
                return Err(Refusal::NoSuchVertex { face, vertex });
            }
            if corners[..i].contains(&vertex) {
                return Err(Refusal::VertexTwice { face, vertex });
            }
        }
    }
    Ok(())
    // END SOLUTION
}

/// The steps.
impl Dcel {
    /// Task 2. Makes a face and a half-edge for each of its corners, in their order: origin, face, next and prev are
    /// set, twin is not. The face knows a half-edge of its own, and so does each corner that knew none. Returns the
    /// number of the face.
    pub fn add_face(&mut self, corners: &[VertexId]) -> FaceId {
        // BEGIN SOLUTION
        // STARTER: let _ = corners;
        // STARTER: todo!("add_face")
        let face = self.new_face();
        let head = self.new_half_edge(corners[0]);
        let mut tail = head;
        for &corner in &corners[1..] {
            let h = self.new_half_edge(corner);
            self.make_next(tail, h);
            tail = h;
        }
        self.make_next(tail, head);
        for (i, &corner) in corners.iter().enumerate() {
            let h = head + i;
            self.half_edges[h].face = Some(face);
            if self.vertices[corner].outgoing_half_edge.is_none() {
                self.vertices[corner].outgoing_half_edge = Some(h);
            }
        }
        self.faces[face].incident_half_edge = Some(head);
        face
        // END SOLUTION
    }

    /// Task 3. Makes twins of each two half-edges that run between the same vertices in opposite directions. If two
    /// run in the same direction, the refusal names where they begin and end.
    pub fn match_twins(&mut self) -> Result<(), Refusal> {
        // BEGIN SOLUTION
        // STARTER: todo!("match_twins")
        let mut by_ends = std::collections::HashMap::new();
        for h in 0..self.half_edges.len() {
            let from = self.origin(h);
            let to = self.origin(self.next(h));
            if by_ends.insert((from, to), h).is_some() {
                return Err(Refusal::EdgeTwice { from, to });
            }
            if let Some(&other) = by_ends.get(&(to, from)) {
                self.make_twin(h, other);
            }
        }
        Ok(())
        // END SOLUTION
    }

    /// Task 4. Gives each half-edge without a twin one in the outer face, and links the new ones to cycles. If two of
    /// the new ones start at one vertex, the refusal names it.
    pub fn close_border(&mut self) -> Result<(), Refusal> {
        // BEGIN SOLUTION
        // STARTER: todo!("close_border")
        let outside = self.outer_face;
        let first = self.half_edges.len();
        let mut from = std::collections::HashMap::new();
        for h in 0..first {
            if self.half_edges[h].twin.is_some() {
                continue;
            }
            let vertex = self.origin(self.next(h));
            let border = self.new_half_edge(vertex);
            self.make_twin(h, border);
            self.half_edges[border].face = Some(outside);
            if from.insert(vertex, border).is_some() {
                return Err(Refusal::Pinched { vertex });
            }
        }
        for border in first..self.half_edges.len() {
            let end = self.origin(self.twin(border));
            if let Some(&next) = from.get(&end) {
                self.make_next(border, next);
            }
            self.faces[outside].incident_half_edge = Some(border);
        }
        Ok(())
        // END SOLUTION
    }
}

/// Task 5. The structure of a list of faces: vertex i stands at `points[i]`, f0 is the outer face, and face i of the
/// list becomes f(i+1).
pub fn from_faces(points: &[Point], faces: &[Vec<VertexId>]) -> Result<Dcel, Refusal> {
    // BEGIN SOLUTION
    // STARTER: let _ = (points, faces);
    // STARTER: todo!("from_faces")
    check_faces(points.len(), faces)?;
    let mut dcel = Dcel::default();
    dcel.outer_face = dcel.new_face();
    for point in points {
        dcel.new_vertex(point.x, point.y);
    }
    for corners in faces {
        dcel.add_face(corners);
    }
    dcel.match_twins()?;
    dcel.close_border()?;
    Ok(dcel)
    // END SOLUTION
}

/// Task 6. Draws a structure: a filled polygon for each face but the outer one, a line for each edge, a dot for each
/// vertex.
pub fn picture(dcel: &Dcel, svg: &mut Svg) {
    // BEGIN SOLUTION
    // STARTER: let _ = (dcel, svg);
    // STARTER: todo!("picture")
    for (f, face) in dcel.faces.iter().enumerate() {
        let Some(first) = face.incident_half_edge else { continue };
        if f == dcel.outer_face {
            continue;
        }
        let mut corners = vec![dcel.position(dcel.origin(first))];
        let mut h = dcel.next(first);
        while h != first {
            corners.push(dcel.position(dcel.origin(h)));
            h = dcel.next(h);
        }
        svg.polygon(&corners);
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
