//! Small structures by the corners of their faces, and changes of single links.

use dcel_kit::topology::{FaceRow, HalfEdgeRow, Table, VertexRow, View};
use dcel_kit::{FaceId, HalfEdgeId, VertexId};
use std::collections::BTreeMap;

/// A structure from the corners of its faces, the outer one first and clockwise. No two edges may join the same
/// vertices. Where the outer face has no corners, the half-edges at the border have no twins.
#[must_use]
pub fn from_cycles(points: &[[f64; 2]], faces: &[&[u32]]) -> Table {
    let mut table = Table { outer_face: Some(FaceId::new(0)), ..Table::default() };
    let vertex = |position: &[f64; 2]| Some(VertexRow { position: Some(*position), outgoing: None });
    table.vertices = points.iter().map(vertex).collect();
    let mut by_ends: BTreeMap<[u32; 2], HalfEdgeId> = BTreeMap::new();
    for (f, cycle) in faces.iter().enumerate() {
        let first = table.half_edges.len();
        let half_edge = |i: usize| HalfEdgeId::new((first + i % cycle.len()) as u32);
        for (i, &from) in cycle.iter().enumerate() {
            let ends = [from, cycle[(i + 1) % cycle.len()]];
            let h = half_edge(i);
            by_ends.insert(ends, h);
            table.half_edges.push(Some(HalfEdgeRow {
                origin: Some(VertexId::new(from)),
                twin: None,
                next: Some(half_edge(i + 1)),
                prev: Some(half_edge(i + cycle.len() - 1)),
                face: Some(FaceId::new(f as u32)),
            }));
            if let Some(vertex) = &mut table.vertices[from as usize] {
                vertex.outgoing = Some(h);
            }
        }
        let stored = (!cycle.is_empty()).then(|| half_edge(0));
        table.faces.push(Some(FaceRow { half_edge: stored, ..FaceRow::default() }));
    }
    // An edge meets its twin only once both are there.
    for i in 0..table.half_edges.len() {
        let h = HalfEdgeId::new(i as u32);
        let ends = table.origin(h).zip(table.next(h).and_then(|next| table.origin(next)));
        let twin = ends.and_then(|(from, to)| by_ends.get(&[to.number(), from.number()]).copied());
        if let Some(row) = &mut table.half_edges[i] {
            row.twin = twin;
        }
    }
    table
}

/// The corners of n times m quads on a torus, row by row.
#[must_use]
pub fn torus(n: u32, m: u32) -> Vec<[u32; 4]> {
    let at = |i: u32, j: u32| i % n * m + j % m;
    let cells = (0..n).flat_map(|i| (0..m).map(move |j| (i, j)));
    cells.map(|(i, j)| [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]).collect()
}

/// The half-edges of triangles: the ends of each, and the sides of each triangle. The k-th edge that is stated has h(2k),
/// on the side that states it first, and h(2k + 1).
#[must_use]
pub fn sides_of(triangles: &[[usize; 3]]) -> (Vec<[usize; 2]>, Vec<[usize; 3]>) {
    let mut ends: Vec<[usize; 2]> = Vec::new();
    let mut known: BTreeMap<[usize; 2], usize> = BTreeMap::new();
    let mut side = |[from, to]: [usize; 2]| {
        let h = *known.entry([from, to]).or_insert(ends.len());
        if h == ends.len() {
            known.insert([to, from], h + 1);
            ends.extend([[from, to], [to, from]]);
        }
        h
    };
    let sides = triangles.iter().map(|&[a, b, c]| [[a, b], [b, c], [c, a]].map(&mut side)).collect();
    (ends, sides)
}

/// The row of a half-edge, to be changed.
pub fn row_mut(table: &mut Table, h: HalfEdgeId) -> Option<&mut HalfEdgeRow> {
    table.half_edges.get_mut(h.index())?.as_mut()
}

/// Puts a half-edge after another.
pub fn link(table: &mut Table, h: HalfEdgeId, next: HalfEdgeId) -> Option<()> {
    row_mut(table, h)?.next = Some(next);
    row_mut(table, next)?.prev = Some(h);
    Some(())
}
