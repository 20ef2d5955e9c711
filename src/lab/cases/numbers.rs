//! The same structure with other numbers of its elements, and with other stored half-edges.

use super::random::Random;
use dcel_kit::topology::{FaceRow, HalfEdgeRow, Table, VertexRow, View};
use dcel_kit::{FaceId, HalfEdgeId, VertexId};

/// The table in which every element is called as these functions say: each of them has to be one to one.
#[must_use]
pub fn renumbered(
    table: &Table,
    vertex: impl Fn(VertexId) -> VertexId,
    half_edge: impl Fn(HalfEdgeId) -> HalfEdgeId,
    face: impl Fn(FaceId) -> FaceId,
) -> Table {
    let link = |h: Option<HalfEdgeId>| h.map(&half_edge);
    let mut out = Table { outer_face: table.outer_face.map(&face), ..table.clone() };
    for (v, row) in (0..).map(VertexId::new).zip(&table.vertices) {
        out.vertices[vertex(v).index()] = row.map(|row| VertexRow { outgoing: link(row.outgoing), ..row });
    }
    for (h, row) in (0..).map(HalfEdgeId::new).zip(&table.half_edges) {
        out.half_edges[half_edge(h).index()] = row.map(|row| HalfEdgeRow {
            origin: row.origin.map(&vertex),
            twin: link(row.twin),
            next: link(row.next),
            prev: link(row.prev),
            face: row.face.map(&face),
        });
    }
    for (f, row) in (0..).map(FaceId::new).zip(&table.faces) {
        let row = row.as_ref().map(|row| FaceRow { half_edge: link(row.half_edge), ..row.clone() });
        out.faces[face(f).index()] = row;
    }
    out
}

/// Has each vertex and face store the last of its half-edges, in the order in which these come.
pub fn store_last(table: &mut Table, half_edges: impl Iterator<Item = HalfEdgeId>) {
    for h in half_edges {
        let (origin, face) = (table.origin(h), table.face(h));
        if let Some(Some(vertex)) = origin.and_then(|v| table.vertices.get_mut(v.index())) {
            vertex.outgoing = Some(h);
        }
        if let Some(Some(face)) = face.and_then(|f| table.faces.get_mut(f.index())) {
            face.half_edge = Some(h);
        }
    }
}

/// Has each vertex and face store any of its half-edges, which come in some order.
pub fn store_any(table: &mut Table, half_edges: impl Iterator<Item = HalfEdgeId>, random: &mut Random) {
    let (mut starting, mut sides) = (vec![Vec::new(); table.vertices.len()], vec![Vec::new(); table.faces.len()]);
    for h in half_edges {
        if let (Some(v), Some(f)) = (table.origin(h), table.face(h)) {
            starting[v.index()].push(h);
            sides[f.index()].push(h);
        }
    }
    for (row, starting) in table.vertices.iter_mut().zip(starting) {
        *row = row.map(|row| VertexRow { outgoing: random.pick(&starting).copied(), ..row });
    }
    for (row, sides) in table.faces.iter_mut().zip(sides) {
        *row = Some(FaceRow { half_edge: random.pick(&sides).copied(), ..FaceRow::default() });
    }
}
