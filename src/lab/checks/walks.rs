//! Walks in structures that may be broken in every way: none of them goes on without a bound.

use dcel_kit::topology::{Table, View};
use dcel_kit::{HalfEdgeId, VertexId};

/// The half-edges that a table has room for.
pub fn half_edges(table: &Table) -> impl Iterator<Item = HalfEdgeId> + Clone + use<> {
    (0..table.half_edges.len() as u32).map(HalfEdgeId::new)
}

/// Where a vertex is.
#[must_use]
pub fn place(table: &Table, v: VertexId) -> Option<[f64; 2]> {
    table.vertices.get(v.index())?.as_ref()?.position
}

/// What the names of cases say in which all vertices are at one place.
pub const BLIND: &str = ".blind";
/// What is added to every fault of such a case.
pub const IN_THE_BLIND: &str =
    " (Here all vertices are at one place: the answer must come from the references, not from positions.)";

/// The same structure with all vertices at one place.
#[must_use]
pub fn blind(table: &Table) -> Table {
    let mut out = table.clone();
    out.vertices.iter_mut().flatten().for_each(|row| row.position = Some([1.0, 1.0]));
    out
}

/// The cycle of half-edges from `start` along `next`; cut where it is broken or longer than the table.
#[must_use]
pub fn cycle(table: &Table, start: HalfEdgeId) -> Vec<HalfEdgeId> {
    dcel_kit::topology::bounded_cycle(table, start).collect()
}

/// The half-edges that start at `origin(start)`, counter-clockwise: `prev.twin` again and again.
#[must_use]
pub fn star(table: &Table, start: HalfEdgeId) -> Vec<HalfEdgeId> {
    let next = |&h: &HalfEdgeId| table.prev(h).and_then(|prev| table.twin(prev)).filter(|&next| next != start);
    std::iter::successors(Some(start), next).take(table.half_edges.len() + 1).collect()
}
