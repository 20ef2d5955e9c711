//! A declared structure with its vertices and edges by place.

use super::graph::{Graph, Matched};
use super::pairing::span;
use crate::figure::structure::skeleton::{destination, half_edges, vertices};
use crate::ids::{HalfEdgeId, VertexId};
use crate::plane::Point;
use crate::topology::{Table, View};

/// Coordinates agree up to this part of the whole.
const CLOSE: f64 = 1e-9;

/// A table with its vertices and edges by place.
pub(super) struct Placed<'a> {
    pub(super) table: &'a Table,
    pub(super) graph: Graph,
    /// The vertex of each point of the graph.
    pub(super) vertices: Vec<VertexId>,
    /// The point of each vertex.
    pub(super) numbers: Vec<Option<u32>>,
}

impl<'a> Placed<'a> {
    pub(super) fn new(table: &'a Table) -> Self {
        let mut out =
            Self { table, graph: Graph::default(), vertices: Vec::new(), numbers: vec![None; table.vertex_bound()] };
        for v in vertices(table) {
            let Some([x, y]) = table.vertices[v.index()].and_then(|row| row.position) else { continue };
            out.numbers[v.index()] = Some(out.vertices.len() as u32);
            out.vertices.push(v);
            out.graph.points.push(Point::new(x, y));
            out.graph.names.push(v.to_string());
        }
        out.graph.edges = half_edges(table).filter_map(|h| out.ends(h)).collect();
        out.graph.tidy();
        out
    }

    /// How far two places may be from each other that are the same.
    pub(super) fn tolerance(&self) -> f64 {
        let span = span(&self.graph.points);
        CLOSE * if span > 0.0 { span } else { 1.0 }
    }

    /// Which point of another structure is which of these.
    pub(super) fn matched(&self, found: &Self) -> Matched {
        Matched::new(&self.graph, &found.graph, self.tolerance())
    }

    fn number(&self, v: Option<VertexId>) -> Option<u32> {
        *self.numbers.get(v?.index())?
    }

    /// The points where a half-edge starts and ends.
    pub(super) fn ends(&self, h: HalfEdgeId) -> Option<[u32; 2]> {
        let end = destination(self.table, h);
        Some([self.number(self.table.origin(h))?, self.number(end)?])
    }
}
