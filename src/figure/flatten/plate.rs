//! A spread-out structure as a table that can be drawn.
//!
//! ```text
//!   a cut edge      its half-edges have no twins there, so each is drawn where its face is
//!   a copy          a vertex of its own, after all vertices of the structure, that shows the name of the true one
//!   a bent edge     p ──d── h ──d── q: the half-edges are on the middle piece, the others are pieces without a name
//! ```

use super::cut::Spread;
use crate::ids::{EdgeId, HalfEdgeId, VertexId};
use crate::topology::{HalfEdgeRow, InnerComponent, Table, VertexRow};
use std::collections::BTreeMap;

/// The ids of copies, bends and pieces: those of all states of a film, beyond all ids of the structure.
#[derive(Debug, Default)]
pub(in crate::figure) struct Names {
    first_vertex: usize,
    first_half_edge: usize,
    copies: BTreeMap<(VertexId, u32), VertexId>,
    bends: BTreeMap<EdgeId, u32>,
    /// By the numbers of the bent edges.
    bend_vertices: Vec<[VertexId; 2]>,
    letters: BTreeMap<EdgeId, usize>,
    vertices: u32,
}

impl Names {
    /// For these states of a structure.
    pub(in crate::figure) fn beyond<'a>(states: impl IntoIterator<Item = &'a Table>) -> Self {
        let bounds = states.into_iter().map(|table| (table.vertices.len(), table.half_edges.len()));
        let (first_vertex, first_half_edge) = bounds.fold((0, 0), |most, b| (most.0.max(b.0), most.1.max(b.1)));
        Self { first_vertex, first_half_edge, ..Self::default() }
    }

    fn vertex(&mut self) -> VertexId {
        self.vertices += 1;
        VertexId::new(self.first_vertex as u32 + self.vertices - 1)
    }

    /// The copies with the vertices whose names they show; bends show none.
    pub(in crate::figure) fn shown(&self) -> impl Iterator<Item = (VertexId, Option<VertexId>)> {
        let copies: BTreeMap<VertexId, VertexId> = self.copies.iter().map(|(&(v, _), &copy)| (copy, v)).collect();
        (0..self.vertices).map(move |i| {
            let id = VertexId::new(self.first_vertex as u32 + i);
            (id, copies.get(&id).copied())
        })
    }
}

/// A state that can be drawn.
#[derive(Clone, Debug)]
pub(in crate::figure) struct Placed {
    pub(in crate::figure) table: Table,
    /// Whether the places were found by a layout.
    pub(in crate::figure) is_laid_out: bool,
    /// Copies, each with its number and the vertex that it is.
    pub(in crate::figure) copies: Vec<(VertexId, u32, VertexId)>,
    /// The pieces of bent edges, each with the half-edge whose edge it belongs to.
    pub(in crate::figure) pieces: Vec<(HalfEdgeId, HalfEdgeId)>,
    /// The cut half-edges with the numbers of their letters.
    pub(in crate::figure) sides: Vec<(HalfEdgeId, usize)>,
}

impl Placed {
    /// A state with positions of its own.
    pub(in crate::figure) fn plain(table: Table) -> Self {
        Self { table, is_laid_out: false, copies: Vec::new(), pieces: Vec::new(), sides: Vec::new() }
    }

    /// A state spread out. `table` has the pointers.
    pub(in crate::figure) fn new(table: &Table, spread: &Spread, names: &mut Names) -> Self {
        let mut out = Self { is_laid_out: true, ..Self::plain(table.clone()) };
        let ids = out.add_vertices(spread, names);
        for &h in &spread.sides {
            let count = names.letters.len();
            out.sides.push((h, *names.letters.entry(h.edge()).or_insert(count)));
            out.row(h).twin = None;
        }
        let all: Vec<HalfEdgeId> = (0..table.half_edges.len() as u32)
            .map(HalfEdgeId::new)
            .filter(|h| table.half_edges[h.index()].is_some())
            .collect();
        for &h in &all {
            out.row(h).origin = Some(ids[spread.node[h] as usize]);
        }
        let mut chains: BTreeMap<HalfEdgeId, [HalfEdgeId; 3]> = BTreeMap::new();
        for (&e, bends) in &spread.bends {
            let ends = e.half_edges().map(|h| ids[spread.node[h] as usize]);
            out.add_bends(e, *bends, ends, names, &mut chains);
        }
        let chain = |h: HalfEdgeId| chains.get(&h).map_or_else(|| vec![h], |chain| chain.to_vec());
        for &h in &all {
            let Some(next) = table.half_edges[h.index()].and_then(|row| row.next) else { continue };
            let mut links = chain(h);
            links.push(chain(next)[0]);
            for pair in links.windows(2) {
                out.row(pair[0]).next = Some(pair[1]);
                out.row(pair[1]).prev = Some(pair[0]);
            }
        }
        out.open(table, spread);
        out
    }

    fn row(&mut self, h: HalfEdgeId) -> &mut HalfEdgeRow {
        if self.table.half_edges.len() <= h.index() {
            self.table.half_edges.resize(h.index() + 1, None);
        }
        self.table.half_edges[h.index()].get_or_insert_default()
    }

    fn put(&mut self, v: VertexId, at: [f64; 2]) {
        if self.table.vertices.len() <= v.index() {
            self.table.vertices.resize(v.index() + 1, None);
        }
        self.table.vertices[v.index()].get_or_insert_default().position = Some(at);
    }

    /// The vertex of each node.
    fn add_vertices(&mut self, spread: &Spread, names: &mut Names) -> Vec<VertexId> {
        let mut counts: BTreeMap<VertexId, u32> = BTreeMap::new();
        let mut ids = Vec::with_capacity(spread.vertex.len());
        for (&v, &at) in spread.vertex.iter().zip(&spread.at) {
            let count = counts.entry(v).and_modify(|count| *count += 1).or_insert(0);
            let mut id = v;
            if *count > 0 {
                id = match names.copies.get(&(v, *count)) {
                    Some(&id) => id,
                    None => {
                        let id = names.vertex();
                        names.copies.insert((v, *count), id);
                        id
                    }
                };
                self.copies.push((id, *count + 1, v));
            }
            self.put(id, at);
            ids.push(id);
        }
        ids
    }

    /// The bends of an edge and the pieces before and after them, for both half-edges.
    fn add_bends(
        &mut self,
        e: EdgeId,
        bends: [[f64; 2]; 2],
        ends: [VertexId; 2],
        names: &mut Names,
        chains: &mut BTreeMap<HalfEdgeId, [HalfEdgeId; 3]>,
    ) {
        let count = names.bends.len() as u32;
        let is_new = !names.bends.contains_key(&e);
        let number = *names.bends.entry(e).or_insert(count);
        if is_new {
            let both = [names.vertex(), names.vertex()];
            names.bend_vertices.push(both);
        }
        let [first, second] = names.bend_vertices[number as usize];
        self.put(first, bends[0]);
        self.put(second, bends[1]);
        let [h, t] = e.half_edges();
        let piece = |i: u32| HalfEdgeId::new(names.first_half_edge as u32 + 4 * number + i);
        // Towards h: 0 before it, 2 after it; 1 and 3 are their twins, beside t.
        for (i, origin, beside) in [(0, ends[0], h), (1, first, t), (2, second, h), (3, ends[1], t)] {
            let face = self.row(beside).face;
            let twin = Some(piece(i ^ 1));
            *self.row(piece(i)) = HalfEdgeRow { origin: Some(origin), twin, next: None, prev: None, face };
            self.pieces.push((piece(i), beside));
        }
        self.row(h).origin = Some(first);
        self.row(t).origin = Some(second);
        chains.insert(h, [piece(0), h, piece(2)]);
        chains.insert(t, [piece(3), t, piece(1)]);
    }

    /// The outside of the first component of genus 0 is the outer face; those of others are not drawn.
    fn open(&mut self, table: &Table, spread: &Spread) {
        let face = |h: HalfEdgeId| table.half_edges[h.index()].and_then(|row| row.face);
        let Some((&first, others)) = spread.outside.split_first() else { return };
        let Some(outer) = face(first) else { return };
        self.table.outer_face = Some(outer);
        for &h in others {
            if let Some(f) = face(h) {
                self.table.faces[f.index()] = None;
            }
        }
        let lone = spread.vertex.iter().filter(|v| table.vertices[v.index()].is_some_and(|row| row.outgoing.is_none()));
        let rings = others.iter().map(|&h| InnerComponent::Cycle(h)).chain(lone.map(|&v| InnerComponent::Isolated(v)));
        if let Some(row) = &mut self.table.faces[outer.index()] {
            row.inner_components = rings.collect();
        }
    }
}

/// The place of each vertex: that of its first node.
pub(in crate::figure) fn set_positions(table: &mut Table, spread: &Spread) {
    for (&v, &at) in spread.vertex.iter().zip(&spread.at).rev() {
        if let Some(Some(row)) = table.vertices.get_mut(v.index()) {
            *row = VertexRow { position: Some(at), ..*row };
        }
    }
    let outer = spread.outside.first().and_then(|h| table.half_edges[h.index()]).and_then(|row| row.face);
    table.outer_face = outer;
}
