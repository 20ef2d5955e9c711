//! Cutting an obstacle into the map.
//!
//! ```text
//!   ┌─────────●─┐        ┌─────────●─┐        ┌─────────●─┐      The cuts that a side crosses go first, so that no
//!   │ p ··╱··╱·q│  ==>   │ p ······╱·q│  ==>  │ ●━━━━━━●━●│      crossing is ever rounded onto a cut; then the side goes
//!   │   ╱   ╱   │        │        ╱  │        │  ╲    ╱ ╲ │      in; then what is not convex is cut anew.
//!   └──╱───●────┘        └───────●───┘        └───╲──●───╲┘
//! ```
//!
//! A side that is led through a vertex beside it may meet cuts that the straight one does not, or run along one of the
//! first map. Then all is taken back and done again without these.

use super::ObstacleError;
use super::book::Book;
use super::cut::{changed_faces, make_convex, take_out, written_faces};
use crate::ids::{EdgeId, Element, FaceId, HalfEdgeId, VertexId};
use crate::navmesh::location::is_between;
use crate::navmesh::marks::ID;
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
    let mut crossed: BTreeSet<EdgeId> = sides.iter().flat_map(|&side| cuts_across(mesh, book, side)).collect();
    let (mark, first_change) = (rec.len(), rec.kernel().len());
    loop {
        let inserted = cut_in_without(map, mesh, book, sides, &crossed, rec);
        let mut met = split_cuts(book, &rec.kernel().changes()[first_change..]);
        let sides = inserted.iter().flat_map(|inserted| &inserted.sides);
        let along = sides.flat_map(|(half_edges, _)| half_edges.iter().map(|h| h.edge()));
        met.extend(along.filter(|&e| book.is_first_cut(e)));
        if met.is_empty() {
            return inserted;
        }
        map.undo(rec, mark);
        crossed.extend(met);
    }
}

/// Cuts the sides into the map without these cuts.
fn cut_in_without(
    map: &mut Subdivision,
    mesh: &NavMesh,
    book: &Book,
    sides: &[[Point; 2]],
    crossed: &BTreeSet<EdgeId>,
    rec: &mut PlaneJournal,
) -> Result<Inserted, ObstacleError> {
    let mut faces = BTreeSet::new();
    for &e in crossed {
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

/// The cuts that the changes have split, and that were there before.
fn split_cuts(book: &Book, changes: &[Change]) -> Vec<EdgeId> {
    let mut added = BTreeSet::new();
    let mut new_edge = false;
    let mut found = Vec::new();
    for change in changes {
        match *change {
            Change::Added { element: Element::Edge(e), .. } => new_edge = added.insert(e),
            Change::Write { slot: Slot::Origin(_), old: None, .. } => {}
            // The twin of the half-edge that is split starts at the new vertex from now on.
            Change::Write { slot: Slot::Origin(h), old: Some(_), new: Some(_) } => {
                if std::mem::take(&mut new_edge) && !added.contains(&h.edge()) && book.is_cut(h.edge()) {
                    found.push(h.edge());
                }
            }
            _ => new_edge = false,
        }
    }
    found
}

/// The cuts that a segment crosses, or on which an end of it lies, and those of the first map along which it runs.
/// O(cells of the index along the segment).
fn cuts_across(mesh: &NavMesh, book: &Book, [p, q]: [Point; 2]) -> Vec<EdgeId> {
    let mut found = Vec::new();
    mesh.visit_faces_along([p, q], |f| {
        for s in mesh.range(f) {
            let half_edge = mesh.half_edges[s];
            // Each cut has a face on both sides: once is enough.
            if half_edge.number() % 2 == 1 || !mesh.has_face(FaceId::new(mesh.sides[s].across & ID)) {
                continue;
            }
            let (ends, e) = (mesh.ends(f, s).map(|v| mesh.point(v)), half_edge.edge());
            let meets = meets_inside([p, q], ends) || (book.is_first_cut(e) && runs_along([p, q], ends));
            if meets && book.is_cut(e) {
                found.push(e);
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

/// Whether two segments have more than a point in common.
fn runs_along(segment: [Point; 2], [a, b]: [Point; 2]) -> bool {
    if segment.into_iter().any(|p| orientation(a, b, p).is_ne()) {
        return false;
    }
    // On one line the order by coordinates is the order along it.
    let ordered = |[p, q]: [Point; 2]| if (p.x, p.y) <= (q.x, q.y) { [p, q] } else { [q, p] };
    let [[p, q], [a, b]] = [ordered(segment), ordered([a, b])];
    (p.x, p.y) < (b.x, b.y) && (a.x, a.y) < (q.x, q.y)
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
