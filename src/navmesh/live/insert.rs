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
use super::cut::{changed_faces, make_convex, meets_inside, splits, take_out, written_faces};
use crate::ids::{EdgeId, Element, FaceId, HalfEdgeId, VertexId};
use crate::navmesh::marks::ID;
use crate::navmesh::nearest::{closest_on, distance};
use crate::navmesh::{Location, NavMesh};
use crate::plane::predicates::orientation;
use crate::plane::{InsertVertexError, Location as Located, PlaneJournal, Point, Subdivision, rounding_room};
use crate::topology::Change;
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
    let near = near(mesh, sides);
    let mut crossed: BTreeSet<EdgeId> = sides.iter().flat_map(|&side| cuts_across(mesh, book, side, near)).collect();
    let (mark, first_change) = (rec.len(), rec.kernel().len());
    loop {
        let inserted = cut_in_without(map, mesh, book, sides, (&crossed, near), rec);
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

/// Cuts the sides into the map without these cuts; what is `near` is led through one point.
fn cut_in_without(
    map: &mut Subdivision,
    mesh: &NavMesh,
    book: &Book,
    sides: &[[Point; 2]],
    (crossed, near): (&BTreeSet<EdgeId>, f64),
    rec: &mut PlaneJournal,
) -> Result<Inserted, ObstacleError> {
    let mut faces = BTreeSet::new();
    take_out(map, book, crossed.iter().copied(), &mut faces, rec)?;
    let whole_from = rec.kernel().len();
    let mut inserted = Inserted { sides: Vec::with_capacity(sides.len()) };
    let mut corners: Vec<VertexId> = Vec::with_capacity(sides.len() + 1);
    for (side, &[p, q]) in sides.iter().enumerate() {
        let refused = |error| ObstacleError::Side { side, error };
        for corner in [p, q].iter().skip(usize::from(side > 0)) {
            // An obstacle ends where it begins.
            let known = corners.first().filter(|_| *corner == sides[0][0]).copied();
            let v = known.map_or_else(|| vertex_at(map, mesh, book, *corner, near, rec), Ok);
            corners.push(v.map_err(|error| refused(error.into()))?);
        }
        // A vertex next to a side is one of it: it may be where others cross, rounded, and a second vertex beside it would
        // leave no room between.
        let way = map.insert_way(corners[side], corners[side + 1], near, rec).map_err(refused)?;
        inserted.sides.push((way.half_edges, rec.kernel().len()));
    }
    let mut changed = changed_faces(map, whole_from, rec);
    changed.extend(faces.into_iter().filter(|&f| map.has_face(f)));
    make_convex(map, changed, rec)?;
    Ok(inserted)
}

/// The cuts that the changes have split, and that were there before.
fn split_cuts(book: &Book, changes: &[Change]) -> Vec<EdgeId> {
    let added: BTreeSet<Element> = changes.iter().filter_map(added).collect();
    let split = splits(changes).into_iter().map(|(h, _)| h.edge());
    split.filter(|&e| !added.contains(&e.into()) && book.is_cut(e)).collect()
}

fn added(change: &Change) -> Option<Element> {
    if let Change::Added { element, .. } = *change { Some(element) } else { None }
}

/// The cuts that a segment crosses, or that have an end of it on them or `near`: a line that this end is to be put on may lie
/// behind them. And those of the first map along which it runs. O(cells of the index along the segment).
fn cuts_across(mesh: &NavMesh, book: &Book, [p, q]: [Point; 2], near: f64) -> Vec<EdgeId> {
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
            let passes = |end: Point| distance(end, closest_on(ends, end)) <= near;
            let ends_beside = |end: Point| passes(end) && ends.iter().all(|&v| distance(end, v) > near);
            if (meets || ends_beside(p) || ends_beside(q)) && book.is_cut(e) {
                found.push(e);
            }
        }
    });
    found
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
    rounding_room(corners)
}

/// The vertex at a point: one that is there, or a new one. What passes next to it and is no cut is led through it.
///
/// The mesh knows near which faces that is in most cases. What is there is asked of the map: the edit has changed it, and
/// a number that was given up may be that of something else by now.
fn vertex_at(
    map: &mut Subdivision,
    mesh: &NavMesh,
    book: &Book,
    p: Point,
    near: f64,
    rec: &mut PlaneJournal,
) -> Result<VertexId, InsertVertexError> {
    let likely = match mesh.locate(p) {
        Location::Vertex(v) if map.has_vertex(v) && map.point(v) == p => return Ok(v),
        Location::Vertex(_) => vec![],
        Location::Edge(h) if map.has_half_edge(h) => vec![map.face(h), map.face(h.twin())],
        Location::Edge(_) => vec![],
        Location::Face(f) | Location::Hole(f) => vec![f],
        Location::Outer => vec![map.outer_face()],
    };
    let likely: BTreeSet<FaceId> = likely.into_iter().filter(|&f| map.has_face(f)).collect();
    if let Some(v) = vertex_in(map, book, &likely, p, near, rec)? {
        return Ok(v);
    }
    // Then it is in a face that the edit has written to, or in a piece of a hole.
    let written = written_faces(map, rec.kernel().changes());
    if let Some(v) = vertex_in(map, book, &written, p, near, rec)? {
        return Ok(v);
    }
    let there = match map.locate(p) {
        Located::Face(f) => vertex_in(map, book, &BTreeSet::from([f]), p, near, rec)?,
        Located::Vertex(v) => Some(v),
        Located::Edge(_) => None,
    };
    there.map_or_else(|| map.insert_vertex_with(p, rec), Ok)
}

/// The same, if the point is in one of these faces or on its boundary.
fn vertex_in(
    map: &mut Subdivision,
    book: &Book,
    faces: &BTreeSet<FaceId>,
    p: Point,
    near: f64,
    rec: &mut PlaneJournal,
) -> Result<Option<VertexId>, InsertVertexError> {
    for &f in faces {
        let on = match map.find_in_face(f, p) {
            Err(Some(Element::Vertex(v))) => return Ok(Some(v)),
            Err(Some(Element::HalfEdge(h))) => Some(h),
            Err(_) => continue,
            Ok(()) => None,
        };
        if let Some(v) = map.nearest_vertex(f, p, near) {
            return Ok(Some(v));
        }
        let beside = on.or_else(|| line_beside(map, book, f, p, near, rec.kernel().changes()));
        if let Some(Ok((v, _))) = beside.map(|h| map.split_edge_with(h, p, rec)) {
            return Ok(Some(v));
        }
        return map.insert_vertex_in_with(f, p, rec).map(Some);
    }
    Ok(None)
}

/// The line nearest to a point inside a face, if it is next to it: a half-edge of the face that is no cut. The book does
/// not know yet what the edit has made; but that is no cut either, before faces are made convex.
fn line_beside(
    map: &Subdivision,
    book: &Book,
    f: FaceId,
    p: Point,
    near: f64,
    changes: &[Change],
) -> Option<HalfEdgeId> {
    let new: BTreeSet<Element> = changes.iter().filter_map(added).collect();
    map.nearest_half_edge(f, p, near, |h| !book.is_cut(h.edge()) || new.contains(&h.edge().into()))
}
