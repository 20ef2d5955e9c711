//! Cutting an obstacle into the map.
//!
//! ```text
//!   ┌─────────●─┐        ┌─────────●─┐        ┌─────────●─┐      The cuts that a side crosses go first, so that no
//!   │ p ··╱··╱·q│  ==>   │ p ······╱·q│  ==>  │ ●━━━━━━●━●│      crossing is ever rounded onto a cut; then the side goes
//!   │   ╱   ╱   │        │        ╱  │        │  ╲    ╱ ╲ │      in; then what is not convex is cut anew.
//!   └──╱───●────┘        └───────●───┘        └───╲──●───╲┘
//! ```

use super::ObstacleError;
use super::book::Book;
use super::clear::take_out;
use super::cut::{changed_faces, make_convex};
use crate::ids::{EdgeId, Element, FaceId, HalfEdgeId, VertexId};
use crate::navmesh::location::is_between;
use crate::navmesh::mesh::ID;
use crate::navmesh::nearest::{closest_on, distance};
use crate::navmesh::{Location, NavMesh};
use crate::plane::predicates::orientation;
use crate::plane::{InsertSegmentError, InsertVertexError, PlaneJournal, Point, Subdivision};
use crate::topology::{Change, Slot};
use std::collections::BTreeSet;

/// The sides of an obstacle in the map.
pub(super) struct Inserted {
    /// For each side its half-edges in order, as they were when it was put in, and how long the journal was then.
    pub(super) sides: Vec<(Vec<HalfEdgeId>, usize)>,
}

/// Cuts the sides into the map, which the mesh still shows as it was before, and makes its faces convex again.
///
/// # Errors
/// [`ObstacleError`]; the caller goes back.
pub(super) fn cut_in(
    map: &mut Subdivision,
    mesh: &NavMesh,
    book: &Book,
    sides: &[[Point; 2]],
    rec: &mut PlaneJournal,
) -> Result<Inserted, ObstacleError> {
    let crossed: BTreeSet<EdgeId> = sides.iter().flat_map(|&side| cuts_across(mesh, book, side)).collect();
    let mut faces = BTreeSet::new();
    for e in crossed {
        take_out(map, book, e, &mut faces, rec)?;
    }
    let (whole_from, near) = (rec.kernel().len(), near(mesh, sides));
    let mut inserted = Inserted { sides: Vec::with_capacity(sides.len()) };
    let mut corners: Vec<VertexId> = Vec::with_capacity(sides.len() + 1);
    for (side, &[p, q]) in sides.iter().enumerate() {
        let refused = |error| ObstacleError::Side { side, error };
        for corner in [p, q].iter().skip(usize::from(side > 0)) {
            // An obstacle ends where it begins.
            let known = corners.first().filter(|_| side > 1 && *corner == sides[0][0]).copied();
            let v = known.map_or_else(|| vertex_at(map, mesh, book, *corner, near, rec), Ok);
            corners.push(v.map_err(|error| refused(error.into()))?);
        }
        let half_edges = put_in(map, mesh, [p, q], [corners[side], corners[side + 1]], near, rec).map_err(refused)?;
        inserted.sides.push((half_edges, rec.kernel().len()));
    }
    let mut changed = changed_faces(map, whole_from, rec);
    changed.extend(faces.into_iter().filter(|&f| map.has_face(f)));
    make_convex(map, changed, rec)?;
    Ok(inserted)
}

/// The cuts that a segment crosses, or on which an end of it lies. O(cells of the index along the segment).
fn cuts_across(mesh: &NavMesh, book: &Book, [p, q]: [Point; 2]) -> Vec<EdgeId> {
    let mut found = Vec::new();
    mesh.visit_faces_along([p, q], |f| {
        for s in mesh.range(f) {
            let half_edge = mesh.half_edges[s];
            // Each cut has a face on both sides: once is enough.
            if half_edge.number() % 2 == 1 || !mesh.has_face(FaceId::new(mesh.sides[s].across & ID)) {
                continue;
            }
            let [a, b] = mesh.ends(f, s).map(|v| mesh.point(v));
            if meets_inside([p, q], [a, b]) && book.is_cut(half_edge.edge()) {
                found.push(half_edge.edge());
            }
        }
    });
    found
}

/// Whether the segment has a point inside an edge, its ends left out; not if it runs along the edge.
fn meets_inside([p, q]: [Point; 2], [a, b]: [Point; 2]) -> bool {
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

/// What is nearer than this may be there by rounding only: some last places of the greatest coordinate.
fn near(mesh: &NavMesh, sides: &[[Point; 2]]) -> f64 {
    let corners = sides.iter().flatten().copied().chain(mesh.box_corners());
    corners.map(|p| p.x.abs().max(p.y.abs())).fold(0.0, f64::max) * 2f64.powi(-47)
}

/// Puts in one side between its two corners. Returns its half-edges in order.
///
/// A vertex that is next to the side is one of it: it may be where others cross, rounded, and a second vertex beside
/// it would leave no room between.
fn put_in(
    map: &mut Subdivision,
    mesh: &NavMesh,
    ends: [Point; 2],
    [from, to]: [VertexId; 2],
    near: f64,
    rec: &mut PlaneJournal,
) -> Result<Vec<HalfEdgeId>, InsertSegmentError> {
    let mut at = from;
    let mut half_edges: Vec<HalfEdgeId> = Vec::new();
    let mut stops = vertices_beside(map, mesh, ends, near);
    stops.retain(|&v| v != to);
    for stop in stops.into_iter().chain([to]) {
        if stop != at && map.has_vertex(stop) {
            half_edges.extend(map.insert_way(at, stop, rec)?.half_edges);
            at = stop;
        }
    }
    // A later piece may have split an earlier one.
    let chain: Vec<VertexId> = half_edges.iter().map(|&h| map.origin(h)).chain([to]).collect();
    let whole = chain.windows(2).all(|pair| map.find_half_edge(pair[0], pair[1]).is_some());
    if whole { Ok(half_edges) } else { Err(InsertSegmentError::Unsettled { pieces: half_edges.len() }) }
}

/// The vertices next to a segment that are no ends of it, in their order along it.
fn vertices_beside(map: &Subdivision, mesh: &NavMesh, [p, q]: [Point; 2], near: f64) -> Vec<VertexId> {
    let [x, y] = [q.x - p.x, q.y - p.y];
    let length = x.hypot(y);
    let mut found: Vec<(f64, VertexId)> = Vec::new();
    mesh.visit_faces_along([p, q], |f| {
        for v in mesh.corners(f) {
            let at = mesh.point(v);
            let [dx, dy] = [at.x - p.x, at.y - p.y];
            let (along, off) = ((dx * x + dy * y) / length, (dx * y - dy * x) / length);
            if off.abs() <= near && along > 0.0 && along < length && at != p && at != q && map.has_vertex(v) {
                found.push((along, v));
            }
        }
    });
    found.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    found.dedup();
    found.into_iter().map(|(_, v)| v).collect()
}

/// The vertex at a point: one that is there, or a new one. The mesh knows where that is in most cases. What passes next
/// to it and is no cut is led through it.
fn vertex_at(
    map: &mut Subdivision,
    mesh: &NavMesh,
    book: &Book,
    p: Point,
    near: f64,
    rec: &mut PlaneJournal,
) -> Result<VertexId, InsertVertexError> {
    let inside = match mesh.locate(p) {
        Location::Vertex(v) if map.has_vertex(v) && map.point(v) == p => return Ok(v),
        Location::Edge(h) if map.has_half_edge(h) => match map.split_edge_with(h, p, rec) {
            Ok((v, _)) => return Ok(v),
            Err(_) => None,
        },
        Location::Face(f) => {
            let passes = |&s: &usize| {
                let at = closest_on(mesh.ends(f, s).map(|v| mesh.point(v)), p);
                distance(at, p) <= near && !book.is_cut(mesh.half_edges[s].edge())
            };
            let beside = mesh.range(f).find(passes).map(|s| mesh.half_edges[s]);
            let split = beside.filter(|&h| map.has_half_edge(h)).map(|h| map.split_edge_with(h, p, rec));
            if let Some(Ok((v, _))) = split {
                return Ok(v);
            }
            Some(f)
        }
        Location::Hole(f) => Some(f),
        Location::Outer => Some(map.outer_face()),
        Location::Vertex(_) | Location::Edge(_) => None,
    };
    // If it is in none that was there before, it is in one that the edit has written to.
    let mut faces: BTreeSet<FaceId> = inside.into_iter().filter(|&f| map.has_face(f)).collect();
    for _ in 0..2 {
        for &f in &faces {
            match map.insert_vertex_in_with(f, p, rec) {
                Err(InsertVertexError::NotInFace { at: Some(Element::Vertex(v)), .. }) => return Ok(v),
                Err(InsertVertexError::NotInFace { at: Some(Element::HalfEdge(h)), .. }) => {
                    if let Ok((v, _)) = map.split_edge_with(h, p, rec) {
                        return Ok(v);
                    }
                }
                Err(InsertVertexError::NotInFace { .. }) => {}
                other => return other,
            }
        }
        faces = written_faces(map, rec.kernel().changes());
    }
    match map.insert_vertex_with(p, rec) {
        Err(InsertVertexError::Occupied { vertex, .. }) => Ok(vertex),
        other => other,
    }
}

/// The faces beside the half-edges that the changes have written to.
fn written_faces(map: &Subdivision, changes: &[Change]) -> BTreeSet<FaceId> {
    let half_edge = |change: &Change| match *change {
        Change::Write { slot: Slot::Next(h) | Slot::Face(h), .. } if map.has_half_edge(h) => Some(h),
        _ => None,
    };
    changes.iter().filter_map(half_edge).flat_map(|h| [map.face(h), map.face(h.twin())]).collect()
}
