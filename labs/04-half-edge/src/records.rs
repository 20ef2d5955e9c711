//! The records of a half-edge structure, as the lines of a dump have them.

use crate::dcel::{Dcel, Face, HalfEdge, Point, Vertex};
use crate::harness::{Cell, Column, Link, Shortcut, Structure, Table};

const fn link(name: &'static str, letter: char) -> Column {
    Column::Link(Link { name, letter })
}

impl Structure for Dcel {
    const TABLES: &'static [Table] = &[
        Table {
            letter: 'v',
            word: "vertex",
            name: "vertex",
            plural: "vertices",
            columns: &[Column::Number, Column::Number, link("outgoing", 'h')],
            shortcuts: &[],
        },
        Table {
            letter: 'h',
            word: "half_edge",
            name: "half-edge",
            plural: "half-edges",
            columns: &[link("origin", 'v'), link("twin", 'h'), link("next", 'h'), link("prev", 'h'), link("face", 'f')],
            shortcuts: &[Shortcut { name: "destination", path: &["twin", "origin"] }],
        },
        Table {
            letter: 'f',
            word: "face",
            name: "face",
            plural: "faces",
            columns: &[link("half_edge", 'h')],
            shortcuts: &[],
        },
    ];
    const SINGLES: &'static [&'static str] = &["outer"];

    fn len(&self, table: usize) -> usize {
        [self.vertices.len(), self.half_edges.len(), self.faces.len()][table]
    }

    fn rows(&self, table: usize) -> impl Fn(usize) -> Vec<Cell> {
        move |number| match table {
            0 => {
                let Vertex { outgoing_half_edge, pos } = self.vertices[number];
                vec![Cell::Number(pos.x), Cell::Number(pos.y), Cell::Link(outgoing_half_edge)]
            }
            1 => {
                let HalfEdge { origin, face, prev, next, twin } = self.half_edges[number];
                [origin, twin, next, prev, face].map(Cell::Link).into()
            }
            _ => vec![Cell::Link(self.faces[number].incident_half_edge)],
        }
    }

    fn add(&mut self, table: usize, row: &[Cell]) {
        match (table, row) {
            (0, [x, y, outgoing]) => {
                let pos = Point { x: x.number(), y: y.number() };
                self.vertices.push(Vertex { outgoing_half_edge: outgoing.to(), pos });
            }
            (1, [origin, twin, next, prev, face]) => {
                let [origin, twin, next, prev, face] = [origin, twin, next, prev, face].map(|cell| cell.to());
                self.half_edges.push(HalfEdge { origin, face, prev, next, twin });
            }
            (_, row) => self.faces.push(Face { incident_half_edge: row[0].to() }),
        }
    }

    fn differs(&self, before: &Self, table: usize) -> impl Fn(usize) -> bool {
        move |number| match table {
            0 => self.vertices[number] != before.vertices[number],
            1 => self.half_edges[number] != before.half_edges[number],
            _ => self.faces[number] != before.faces[number],
        }
    }

    fn single(&self, _: usize) -> Option<usize> {
        Some(self.outer_face)
    }

    fn set_single(&mut self, _: usize, to: Option<usize>) {
        self.outer_face = to.unwrap_or_default();
    }
}
