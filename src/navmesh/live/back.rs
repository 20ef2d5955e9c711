//! Cuts and faces of the first map that come back.
//!
//! ```text
//!   a───────┐       a───────┐       a───────┐      A cut of the first map that was crossed is out. When nothing is in
//!   │┄┄┄┄┄┄┄│  ==>  │       │  ==>  │╲  f3  │      its way any more, the other cuts across it go, and it comes back
//!   │       │       │       │       │ f2 ╲  │      under its id. A face whose sides are all of one face of the first
//!   └───────b       └───────b       └───────b      map is that face, and gets its id.
//! ```

use super::ObstacleError;
use super::book::{Book, Return};
use super::cut::take_out;
use crate::ids::{EdgeId, FaceId, HalfEdgeId, VertexId};
use crate::navmesh::NavMeshError;
use crate::plane::{InsertEdgeError, PlaneJournal, Subdivision};
use std::collections::BTreeSet;

/// Puts a cut of the first map back between its ends if no obstacle is in its way.
///
/// Cost: O(size of the faces between the ends), for each cut across it.
pub(super) fn bring_back(
    map: &mut Subdivision,
    book: &Book,
    e: EdgeId,
    ends: [VertexId; 2],
    faces: &mut BTreeSet<FaceId>,
    rec: &mut PlaneJournal,
) -> Result<Return, ObstacleError> {
    loop {
        let in_way = match map.insert_edge_as(e, ends, rec) {
            Ok(()) => {
                faces.extend(e.half_edges().map(|h| map.face(h)));
                return Ok(Return::Done);
            }
            Err(InsertEdgeError::EdgeExists { existing: h, .. } | InsertEdgeError::Crosses { crossed: h, .. }) => h,
            Err(InsertEdgeError::ThroughVertex { vertex, .. }) => return Ok(blocked_at(map, book, [vertex])),
            Err(_) => return Ok(Return::Later),
        };
        let other = in_way.edge();
        if book.is_cut(other) && !book.is_first(other) {
            take_out(map, book, [other], faces, rec)?;
        } else if let Some(owner) = book.owner(other) {
            return Ok(Return::Blocked(owner));
        } else {
            return Ok(blocked_at(map, book, [map.origin(in_way), map.destination(in_way)]));
        }
    }
}

/// Blocked by an obstacle that closes an edge at one of the vertices.
fn blocked_at<const N: usize>(map: &Subdivision, book: &Book, vertices: [VertexId; N]) -> Return {
    let edges = vertices.into_iter().flat_map(|v| map.outgoing_half_edges(v)).map(HalfEdgeId::edge);
    edges.filter_map(|e| book.owner(e)).min().map_or(Return::Later, Return::Blocked)
}

/// Gives faces that are whole faces of the first map their ids. O(size of these faces).
pub(super) fn name_faces(
    map: &mut Subdivision,
    book: &Book,
    faces: &BTreeSet<FaceId>,
    rec: &mut PlaneJournal,
) -> Result<(), ObstacleError> {
    let named = faces.iter().filter_map(|&f| Some((map.half_edge(f)?, first_face(map, book, f)?)));
    let named: Vec<(HalfEdgeId, FaceId)> = named.filter(|&(h, first)| map.face(h) != first).collect();
    for (h, first) in named {
        let full = |_| ObstacleError::Mesh(NavMeshError::TooMany);
        if map.has_face(first) {
            map.rename_face(first, None, rec).map_err(full)?;
        }
        map.rename_face(map.face(h), Some(first), rec).map_err(full)?;
    }
    Ok(())
}

/// The face of the first map that has all sides of the face.
fn first_face(map: &Subdivision, book: &Book, f: FaceId) -> Option<FaceId> {
    let mut firsts = map.incident_half_edges(f).map(|h| book.first_face(h));
    let first = firsts.next()??;
    (map.inner_components(f).is_empty() && firsts.all(|other| other == Some(first))).then_some(first)
}
