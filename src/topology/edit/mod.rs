//! The edits, one a file, in inverse pairs.
//!
//! One promise for all: **a refused edit leaves everything bit for bit as it was**, the free lists and the next
//! ids included. Each edit gathers what it needs, checks (`can_…` is exactly that phase), makes room, and then
//! writes; the write phase cannot fail.
//!
//! ```text
//!   collapse_edge.rs  Collapsing an edge of a simplicial surface, so that it stays one
//!   flip_edge.rs      Turning an edge inside the two faces beside it
//!   join_edges.rs     Joining two edges by taking away the vertex between them
//!   join_faces.rs     Joining two faces by taking away an edge between them
//!   join_vertices.rs  Joining two vertices by taking away the edge between them
//!   split_edge.rs     Splitting an edge by a new vertex
//!   split_face.rs     Splitting a face along a new edge
//!   split_vertex.rs   Splitting a vertex in two, with a new edge between the halves
//!   turn_over.rs      Turning everything over, as in a mirror
//! ```

mod collapse_edge;
mod flip_edge;
mod join_edges;
mod join_faces;
mod join_vertices;
mod split_edge;
mod split_face;
mod split_vertex;
mod turn_over;

pub use collapse_edge::CollapseEdgeError;
pub use flip_edge::FlipEdgeError;
pub use join_edges::JoinEdgesError;
pub use join_faces::JoinFacesError;
pub use join_vertices::JoinVerticesError;
pub use split_edge::SplitEdgeError;
pub use split_face::SplitFaceError;
pub use split_vertex::SplitVertexError;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ids::{FaceId, HalfEdgeId, MAX_IDS};
    use crate::topology::links::Columns;
    use crate::topology::pool::TooMany;
    use crate::topology::{Dcel, violations};

    /// Two triangles side by side that share the face `f0`: h0 h2 h4 round `f1`, h6 h8 h10 round `f2`.
    fn two_triangles() -> Dcel {
        let turn = |h: u32, by: u32| h / 6 * 6 + (h % 6 + by) % 6;
        let step = |h: u32, inside: u32, outside: u32| turn(h, if h.is_multiple_of(2) { inside } else { outside });
        Dcel::from_columns(Columns {
            origin: (0..12).map(|h| turn(h, h % 2) / 2).collect(),
            next: (0..12).map(|h| step(h, 2, 4)).collect(),
            prev: (0..12).map(|h| step(h, 4, 2)).collect(),
            face: (0..12_u32).map(|h| if h.is_multiple_of(2) { 1 + h / 6 } else { 0 }).collect(),
            outgoing: (0..6).map(|v| 2 * v).collect(),
            boundary: vec![1, 0, 6],
        })
    }

    #[test]
    fn corners_on_different_cycles_of_a_face_are_refused() {
        let mut dcel = two_triangles();
        let before = dcel.clone();
        let (h1, h2) = (HalfEdgeId(1), HalfEdgeId(9));
        let error = dcel.split_face(h1, h2).unwrap_err();
        assert_eq!(error, SplitFaceError::DifferentCycles { h1, h2, face: FaceId(0) });
        assert_eq!(dcel, before);
    }

    #[test]
    fn the_last_id_of_each_kind_can_be_given_out_and_none_beyond() {
        let dcel = two_triangles();
        assert_eq!(dcel.room_for(MAX_IDS - 6, (MAX_IDS - 12) / 2, MAX_IDS - 3), Ok(()));
        assert_eq!(dcel.room_for(MAX_IDS - 5, 0, 0), Err(TooMany));
        assert_eq!(dcel.room_for(0, (MAX_IDS - 12) / 2 + 1, 0), Err(TooMany));
        assert_eq!(dcel.room_for(0, 0, MAX_IDS - 2), Err(TooMany));
        let texts = [
            SplitFaceError::from(TooMany).to_string(),
            SplitEdgeError::from(TooMany).to_string(),
            SplitVertexError::from(TooMany).to_string(),
        ];
        assert_eq!(texts, ["the structure is full: at most 2147483646 elements of one kind"; 3]);
    }

    /// Every choice of the stored half-edges is legal, and no edit may rely on one: all edits with all arguments,
    /// under each choice for one vertex and one face.
    #[test]
    fn no_edit_leaves_a_representative_behind_whichever_was_stored() {
        let mut looped = Dcel::polygon(3).unwrap();
        looped.join_faces(HalfEdgeId(1)).unwrap();
        let corners: Vec<_> = looped.half_edges().filter(|&a| looped.degree(looped.origin(a)) == 2).collect();
        looped.split_face(corners[0], corners[1]).unwrap();
        let mut halved = Dcel::polygon(4).unwrap();
        halved.split_face(HalfEdgeId(0), HalfEdgeId(4)).unwrap();
        // A loop alone in its face, with a tail outside.
        let mut tailed = halved.clone();
        tailed.join_faces(HalfEdgeId(6)).unwrap();
        tailed.join_edges(HalfEdgeId(9)).unwrap();
        tailed.join_edges(HalfEdgeId(9)).unwrap();
        assert_eq!(tailed.next(HalfEdgeId(9)), HalfEdgeId(9));
        let rec = &mut crate::topology::NoRecorder;
        for start in [looped, halved, tailed, Dcel::polygon(1).unwrap(), Dcel::polygon(2).unwrap(), Dcel::torus()] {
            for (one, other) in start.half_edges().flat_map(|a| start.half_edges().map(move |b| (a, b))) {
                let mut chosen = start.clone();
                chosen.set_outgoing(start.origin(one), Some(one), rec);
                chosen.set_half_edge(start.face(other), Some(other), rec);
                for a in start.half_edges() {
                    let edits: [fn(&mut Dcel, HalfEdgeId) -> bool; 6] = [
                        |d, a| d.flip_edge(a).is_ok(),
                        |d, a| d.join_vertices(a).is_ok(),
                        |d, a| d.collapse_edge(a).is_ok(),
                        |d, a| d.join_faces(a).is_ok(),
                        |d, a| d.join_edges(a).is_ok(),
                        |d, a| d.split_edge(a).is_ok(),
                    ];
                    for edit in edits {
                        let mut after = chosen.clone();
                        edit(&mut after, a);
                        assert_eq!(violations(&after), [], "{a}, with {one} and {other} stored in {start:?}");
                    }
                    for b in start.half_edges() {
                        let mut after = chosen.clone();
                        let _ = after.split_face(a, b);
                        assert_eq!(violations(&after), [], "{a} {b}, with {one} and {other} stored in {start:?}");
                        let mut after = chosen.clone();
                        let _ = after.split_vertex(a, b);
                        assert_eq!(violations(&after), [], "{a} {b}, with {one} and {other} stored in {start:?}");
                    }
                }
            }
        }
    }
}
