//! Surfaces, as a program of this lab prints them: half-edges, and points in space.

use crate::cases::cycles::from_cycles;
use crate::checks::walks::{cycle, star};
use crate::protocol::{Cell, ColumnSchema, RecordSchema, Records, TableSchema};
use dcel_kit::topology::{FaceRow, HalfEdgeRow, Table, VertexRow, View};
use dcel_kit::{FaceId, HalfEdgeId, VertexId};

use ColumnSchema::{Link, Number};

/// Vertices, half-edges, faces. Of a record that was removed nothing is set.
pub(super) static SCHEMA: RecordSchema = RecordSchema {
    singles: &[],
    tables: &[
        TableSchema {
            word: "vertex",
            letter: 'v',
            columns: &[Number("x"), Number("y"), Number("z"), Link("outgoing", 'h')],
        },
        TableSchema {
            word: "half_edge",
            letter: 'h',
            columns: &[Link("origin", 'v'), Link("twin", 'h'), Link("next", 'h'), Link("prev", 'h'), Link("face", 'f')],
        },
        TableSchema { word: "face", letter: 'f', columns: &[Link("half_edge", 'h')] },
    ],
};

/// A surface. The rows of removed half-edges and faces are missing.
#[derive(Clone, PartialEq, Debug, Default)]
pub(super) struct Surface {
    pub(super) table: Table,
    pub(super) points: Vec<[f64; 3]>,
}

impl Surface {
    /// From the corners of its faces, which are numbered in their order: the i-th corner is the origin of half-edge i,
    /// and an element has the first half-edge that is written for it.
    pub(super) fn of_faces(points: Vec<[f64; 3]>, faces: &[Vec<u32>]) -> Self {
        let corners: Vec<&[u32]> = faces.iter().map(Vec::as_slice).collect();
        let mut table = from_cycles(&vec![[0.0; 2]; points.len()], &corners);
        table.outer_face = None;
        let written: Vec<u32> = corners.concat();
        for (h, &v) in written.iter().enumerate().rev() {
            let outgoing = Some(HalfEdgeId::new(h as u32));
            table.vertices[v as usize] = Some(VertexRow { position: None, outgoing });
        }
        Self { table, points }
    }

    /// As it was printed.
    pub(super) fn of(records: &Records) -> Self {
        let link = |row: &[Cell], i: usize| row.get(i).and_then(|cell| cell.to());
        let number = |row: &[Cell], i: usize| row.get(i).and_then(|cell| cell.number()).unwrap_or_default();
        let half_edge = |row: &[Cell], i: usize| link(row, i).map(HalfEdgeId::new);
        let vertex = |row: &[Cell]| Some(VertexRow { position: None, outgoing: half_edge(row, 3) });
        let edge = |row: &[Cell]| HalfEdgeRow {
            origin: link(row, 0).map(VertexId::new),
            twin: half_edge(row, 1),
            next: half_edge(row, 2),
            prev: half_edge(row, 3),
            face: link(row, 4).map(FaceId::new),
        };
        let face = |row: &[Cell]| {
            let half_edge = half_edge(row, 0);
            half_edge.map(|half_edge| FaceRow { half_edge: Some(half_edge), ..FaceRow::default() })
        };
        let there = |row: HalfEdgeRow| (row != HalfEdgeRow::default()).then_some(row);
        let table = Table {
            outer_face: None,
            vertices: records.rows(0).map(vertex).collect(),
            half_edges: records.rows(1).map(|row| there(edge(row))).collect(),
            faces: records.rows(2).map(face).collect(),
        };
        Self { table, points: records.rows(0).map(|row| [0, 1, 2].map(|i| number(row, i))).collect() }
    }

    /// As it is printed.
    pub(super) fn records(&self) -> Records {
        let mut records = Records::new(&SCHEMA);
        let half_edge = |h: Option<HalfEdgeId>| Cell::Link(h.map(HalfEdgeId::number));
        for (row, &[x, y, z]) in self.table.vertices.iter().zip(&self.points) {
            let outgoing = half_edge(row.as_ref().and_then(|row| row.outgoing));
            records.push(0, &[Cell::Number(x), Cell::Number(y), Cell::Number(z), outgoing]);
        }
        for row in &self.table.half_edges {
            let row = row.unwrap_or_default();
            let origin = Cell::Link(row.origin.map(VertexId::number));
            let face = Cell::Link(row.face.map(FaceId::number));
            records.push(1, &[origin, half_edge(row.twin), half_edge(row.next), half_edge(row.prev), face]);
        }
        for row in &self.table.faces {
            records.push(2, &[half_edge(row.as_ref().and_then(|row| row.half_edge))]);
        }
        records
    }

    /// The half-edges that are there.
    pub(super) fn half_edges(&self) -> impl Iterator<Item = HalfEdgeId> + '_ {
        (0..).zip(&self.table.half_edges).filter(|(_, row)| row.is_some()).map(|(h, _)| HalfEdgeId::new(h))
    }

    /// The faces that are there.
    pub(super) fn faces(&self) -> impl Iterator<Item = FaceId> + '_ {
        (0..).zip(&self.table.faces).filter(|(_, row)| row.is_some()).map(|(f, _)| FaceId::new(f))
    }

    /// The half-edges of a face, in their order.
    pub(super) fn of_face(&self, f: FaceId) -> Vec<HalfEdgeId> {
        let stored = self.table.faces.get(f.index()).and_then(|row| row.as_ref()?.half_edge);
        stored.map_or_else(Vec::new, |h| cycle(&self.table, h))
    }

    /// The half-edges that start at a vertex, counter-clockwise.
    pub(super) fn spokes(&self, v: u32) -> Vec<HalfEdgeId> {
        let stored = self.table.vertices.get(v as usize).and_then(|row| row.as_ref()?.outgoing);
        stored.map_or_else(Vec::new, |h| star(&self.table, h))
    }

    /// The number of the vertex where a half-edge starts.
    pub(super) fn start(&self, h: HalfEdgeId) -> Option<u32> {
        self.table.origin(h).map(VertexId::number)
    }

    /// The number of the vertex where a half-edge ends.
    pub(super) fn end(&self, h: HalfEdgeId) -> Option<u32> {
        self.table.twin(h).and_then(|twin| self.start(twin))
    }

    /// Where a half-edge starts.
    pub(super) fn place(&self, h: HalfEdgeId) -> Option<[f64; 3]> {
        self.points.get(self.start(h)? as usize).copied()
    }

    /// The corners of all faces.
    pub(super) fn corners(&self) -> Vec<Vec<u32>> {
        let corners = |f| self.of_face(f).into_iter().filter_map(|h| self.start(h)).collect();
        self.faces().map(corners).collect()
    }

    /// Whether something was removed.
    pub(super) fn has_removed(&self) -> bool {
        self.table.half_edges.contains(&None) || self.table.faces.contains(&None)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::courses::polyhedra::shapes;

    #[test]
    fn a_surface_is_read_as_it_is_printed() {
        for (name, faces) in shapes::all() {
            let surface = shapes::blind(&faces);
            assert_eq!(Surface::of(&surface.records()), surface, "{name}");
            assert_eq!(surface.corners(), faces, "{name}");
        }
    }
}
