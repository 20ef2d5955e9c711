//! The same structure with other numbers of its elements.

use dcel_kit::topology::{FaceRow, HalfEdgeRow, Table, VertexRow};
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
