//! Clearing up where an obstacle has been.
//!
//! ```text
//!   ┌──────●───┐       ┌──────●───┐       ┌──────────┐     Its sides go, then every vertex that is in the middle of
//!   │ ╲   ╱║ ╲ │  ==>  │      │   │  ==>  │          │     one line, or of none: first the cuts there, then the vertex
//!   │  ╲ ╱ ║  ╲│       │      │   │       │          │     itself. What is left is made convex again, and cuts that
//!   └───●══●───┘       └──────●───┘       └──────────┘     need not be are taken out.
//! ```
//!
//! A line that is joined again runs straight between two points that were there before it was crossed: rounding leaves
//! no trace. Cuts of the first map that were crossed come back under their ids, unless another obstacle is in their way,
//! and so do the faces of the first map whose sides are all there (`back.rs`). These are convex, so with the last
//! obstacle the last cut of ours goes.

use super::ObstacleError;
use super::back::{bring_back, name_faces};
use super::book::{Book, Return};
use super::cut::{make_convex, take_out, written_faces};
use crate::ids::{EdgeId, Element, FaceId, HalfEdgeId, VertexId};
use crate::navmesh::mesh::is_floor;
use crate::plane::cycle::turns_left_or_runs_straight;
use crate::plane::{JoinEdgesError, PlaneJournal, Subdivision};
use std::collections::BTreeSet;

/// Takes out what nobody needs near the edges, which an obstacle has given up, and brings back what can come back.
/// Returns what has become of the cuts of the first map that were out and waited.
///
/// Cost: O(size of the faces at the ends of the edges, and of the holes the obstacle reached into).
///
/// # Errors
/// [`ObstacleError::Concave`]: what is left cannot be made convex. The caller goes back.
pub(super) fn clear(
    map: &mut Subdivision,
    book: &mut Book,
    edges: &[EdgeId],
    rec: &mut PlaneJournal,
) -> Result<Vec<(EdgeId, Return)>, ObstacleError> {
    let begin = rec.kernel().len();
    let mut faces = BTreeSet::new();
    let vertices = vertices_near(map, edges);
    take_out(map, book, edges.iter().copied().filter(|&e| book.is_cut(e)), &mut faces, rec)?;
    let mut bends = Vec::new();
    for v in vertices.into_iter().filter(|&v| !book.is_first(v)) {
        if give_up(map, book, v, &mut faces, rec)? {
            bends.push(v);
        }
    }
    // One that is straight may leave room for another.
    let mut bent = usize::MAX;
    while bends.len() < bent {
        bent = bends.len();
        let mut left = Vec::new();
        for v in bends {
            if !straighten(map, book, v, &mut faces, rec)? {
                left.push(v);
            }
        }
        bends = left;
    }
    book.follow(&rec.kernel().changes()[begin..]);
    let back_from = rec.kernel().len();
    let mut returned = Vec::new();
    for (e, ends) in book.waiting() {
        returned.push((e, bring_back(map, book, e, ends, &mut faces, rec)?));
    }
    book.follow(&rec.kernel().changes()[back_from..]);
    let convex_from = rec.kernel().len();
    faces.retain(|&f| map.has_face(f));
    let faces = make_convex(map, faces, rec)?;
    book.follow(&rec.kernel().changes()[convex_from..]);
    let joined_from = rec.kernel().len();
    let cuts: BTreeSet<EdgeId> =
        faces.iter().flat_map(|&f| map.incident_edges(f)).filter(|&e| book.is_cut(e) && !book.is_first(e)).collect();
    for e in cuts {
        if is_needless(map, e) {
            take_out(map, book, [e], &mut BTreeSet::new(), rec)?;
        }
    }
    let mut faces = written_faces(map, &rec.kernel().changes()[begin..]);
    faces.retain(|&f| is_floor(map, f));
    name_faces(map, book, &faces, rec)?;
    book.follow(&rec.kernel().changes()[joined_from..]);
    Ok(returned)
}

/// The ends of the edges, and the corners of the faces there; of holes the ends only.
fn vertices_near(map: &Subdivision, edges: &[EdgeId]) -> BTreeSet<VertexId> {
    let ends = edges.iter().flat_map(|e| e.half_edges()).map(|h| map.origin(h));
    let mut near: BTreeSet<VertexId> = ends.collect();
    let faces: BTreeSet<FaceId> =
        near.iter().flat_map(|&v| map.incident_faces(v)).filter(|&f| is_floor(map, f)).collect();
    near.extend(faces.into_iter().flat_map(|f| map.incident_vertices(f)));
    near
}

/// Takes out the cuts at a vertex that is in the middle of one line or of none, and then, if it is of none, the vertex.
/// Returns whether there is a line.
fn give_up(
    map: &mut Subdivision,
    book: &Book,
    v: VertexId,
    faces: &mut BTreeSet<FaceId>,
    rec: &mut PlaneJournal,
) -> Result<bool, ObstacleError> {
    let (cuts, lines): (Vec<HalfEdgeId>, Vec<HalfEdgeId>) =
        map.outgoing_half_edges(v).partition(|h| book.is_cut(h.edge()));
    let is_needed = match lines[..] {
        [] => false,
        [a, b] => !book.is_one_line(a.edge(), b.edge()),
        _ => true,
    };
    if is_needed {
        return Ok(false);
    }
    take_out(map, book, cuts.into_iter().map(HalfEdgeId::edge), faces, rec)?;
    if lines.is_empty() {
        map.remove_vertex_with(v, rec).expect("it exists, and has no edge any more");
    }
    Ok(!lines.is_empty())
}

/// Makes one edge of two at a vertex that has no other, and says whether it did. Cuts in the way of the straight line are
/// taken out. Anything else there belongs to another obstacle; then the vertex stays, and goes with that one.
fn straighten(
    map: &mut Subdivision,
    book: &Book,
    v: VertexId,
    faces: &mut BTreeSet<FaceId>,
    rec: &mut PlaneJournal,
) -> Result<bool, ObstacleError> {
    loop {
        let mut at = map.outgoing_half_edges(v);
        let (Some(a), Some(b)) = (at.next(), at.next()) else { return Ok(true) };
        // The edge that was there first keeps its name.
        let stays = if book.is_first(b.edge()) { b } else { a };
        faces.extend([map.face(stays), map.face(stays.twin())]);
        let in_way = match map.join_edges_with(stays.twin(), rec) {
            Ok(_) => return Ok(true),
            Err(JoinEdgesError::EdgeExists { existing: h, .. })
            | Err(JoinEdgesError::WouldCross { obstacle: Element::HalfEdge(h), .. }) => h.edge(),
            Err(_) => return Ok(false),
        };
        if !book.is_cut(in_way) {
            return Ok(false);
        }
        take_out(map, book, [in_way], faces, rec)?;
    }
}

/// Whether the faces on both sides of a cut are convex in one piece.
fn is_needless(map: &Subdivision, e: EdgeId) -> bool {
    let [h, t] = e.half_edges();
    let is_convex = |h: HalfEdgeId| {
        let corner = [map.origin(map.prev(h)), map.origin(h), map.destination(map.next(h.twin()))];
        turns_left_or_runs_straight(corner.map(|v| map.point(v)))
    };
    map.face(h) != map.face(t) && is_convex(h) && is_convex(t)
}
