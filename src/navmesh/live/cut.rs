//! Cutting faces until they are convex, after something was cut into them.
//!
//! ```text
//!   ┌─────────┐      a corner that turns the wrong way, or the free end of a wall, is cut off by the first diagonal
//!   │    ●────┤      that fits; something inside a face is first tied to its boundary by an edge
//!   │  ╱      │
//!   └─────────┘
//! ```

use super::ObstacleError;
use super::book::Book;
use crate::ids::{EdgeId, Element, FaceId, HalfEdgeId};
use crate::navmesh::location::is_between;
use crate::navmesh::mesh::is_floor;
use crate::plane::predicates::orientation;
use crate::plane::{InsertEdgeError, PlaneJournal, Point, Subdivision, most_looked_at};
use crate::topology::{Change, InnerComponent, Slot};
use std::collections::BTreeSet;

/// The faces whose shape the changes from `from` on have changed. Bounded pieces of the outer face become hole faces, and pieces of these.
pub(super) fn changed_faces(map: &mut Subdivision, from: usize, rec: &mut PlaneJournal) -> BTreeSet<FaceId> {
    let mut faces = BTreeSet::new();
    for i in from..rec.kernel().len() {
        match rec.kernel().changes()[i] {
            Change::Write { slot: Slot::Face(_), old: Some(Element::Face(old)), new: Some(Element::Face(new)) }
                if (old == map.outer_face() || map.is_hole(old)) && map.has_face(new) =>
            {
                map.set_hole_with(new, true, rec);
            }
            Change::Write { slot: Slot::Next(h), .. } if map.has_half_edge(h) => {
                faces.extend([map.face(h), map.face(h.twin())]);
            }
            _ => {}
        }
    }
    faces
}

/// Makes the faces convex, holes left out. Returns those that are no holes, and the new ones.
pub(super) fn make_convex(
    map: &mut Subdivision,
    faces: BTreeSet<FaceId>,
    rec: &mut PlaneJournal,
) -> Result<BTreeSet<FaceId>, ObstacleError> {
    let mut done: BTreeSet<FaceId> = faces.into_iter().filter(|&f| is_floor(map, f)).collect();
    let mut faces: Vec<FaceId> = done.iter().copied().collect();
    while let Some(face) = faces.pop() {
        tie(map, face, rec)?;
        let new = map.cut_into_convex_with(face, rec).map_err(|_| ObstacleError::Concave { face })?;
        done.extend(new);
    }
    Ok(done)
}

/// Joins what is inside a face to its boundary, each by an edge; not all of it, if that takes too long.
fn tie(map: &mut Subdivision, face: FaceId, rec: &mut PlaneJournal) -> Result<(), ObstacleError> {
    if map.inner_components(face).is_empty() {
        return Ok(());
    }
    let size = map.inner_components(face).len() + map.cycles(face).flat_map(|h| map.cycle(h)).count();
    let mut left = most_looked_at(size);
    while let Some(&ring) = map.inner_components(face).first() {
        let inner: Vec<_> = match ring {
            InnerComponent::Cycle(h) => map.cycle(h).map(|h| map.origin(h)).collect(),
            InnerComponent::Isolated(v) => vec![v],
        };
        let outer: Vec<_> = map.incident_vertices(face).collect();
        let pairs = inner.iter().flat_map(|&v| outer.iter().map(move |&w| [v, w]));
        // A look at the whole face costs its size, and so does the edge. What is in the way to one vertex is often in the
        // way to the next one.
        let (mut in_way, mut fit) = (None, None);
        for [v, w] in pairs {
            let way = [v, w].map(|v| map.point(v));
            let is_hidden = in_way.is_some_and(|edge| meets_inside(way, edge));
            let Some(rest) = left.checked_sub(if is_hidden { 1 } else { size }) else { break };
            left = rest;
            if is_hidden {
                continue;
            }
            match map.can_insert_edge(v, w) {
                Ok(()) => {
                    fit = Some([v, w]);
                    break;
                }
                Err(InsertEdgeError::Crosses { crossed: h, .. }) => {
                    in_way = Some([map.origin(h), map.destination(h)].map(|v| map.point(v)));
                }
                Err(_) => {}
            }
        }
        let Some([v, w]) = fit else { return Ok(()) };
        map.insert_edge_with(v, w, rec).map_err(|_| ObstacleError::Concave { face })?;
    }
    Ok(())
}

/// Takes out edges. Of two faces the one stays that was there first, so that it has its name again in the end.
pub(super) fn take_out(
    map: &mut Subdivision,
    book: &Book,
    edges: impl IntoIterator<Item = EdgeId>,
    faces: &mut BTreeSet<FaceId>,
    rec: &mut PlaneJournal,
) -> Result<(), ObstacleError> {
    let kept = map.remove_edges_with(edges, |f| book.is_first(f), rec);
    faces.extend(kept.map_err(|face| ObstacleError::Concave { face })?);
    Ok(())
}

/// The edges that the changes have split: of each the half that starts at the new vertex now, and the edge that is new.
pub(super) fn splits(changes: &[Change]) -> Vec<(HalfEdgeId, EdgeId)> {
    let mut found = Vec::new();
    let mut new_edge = None;
    for change in changes {
        match *change {
            Change::Added { element, .. } => new_edge = EdgeId::from_element(element),
            // The origins of the new halves.
            Change::Write { slot: Slot::Origin(_), old: None, .. } => {}
            Change::Write { slot: Slot::Origin(h), old: Some(_), new: Some(_) } => {
                found.extend(new_edge.take().map(|e| (h, e)));
            }
            _ => new_edge = None,
        }
    }
    found
}

/// The faces beside the half-edges that the changes have written to.
pub(super) fn written_faces(map: &Subdivision, changes: &[Change]) -> BTreeSet<FaceId> {
    let half_edge = |change: &Change| match *change {
        Change::Write { slot: Slot::Next(h) | Slot::Face(h), .. } if map.has_half_edge(h) => Some(h),
        _ => None,
    };
    changes.iter().filter_map(half_edge).flat_map(|h| [map.face(h), map.face(h.twin())]).collect()
}

/// Whether the segment has a point inside an edge, its ends left out; not if it runs along the edge.
pub(super) fn meets_inside([p, q]: [Point; 2], [a, b]: [Point; 2]) -> bool {
    let of_edge = [p, q].map(|p| orientation(a, b, p));
    if of_edge[0] == of_edge[1] {
        return false;
    }
    let of_segment = [a, b].map(|v| orientation(p, q, v));
    if of_segment.iter().any(|o| o.is_eq()) || of_segment[0] == of_segment[1] {
        return false;
    }
    let on = |end: Point, side: std::cmp::Ordering| side.is_ne() || is_between(a, b, end);
    on(p, of_edge[0]) && on(q, of_edge[1])
}
