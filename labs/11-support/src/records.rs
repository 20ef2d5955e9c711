//! The records of a mesh, as the lines of a dump have them.

use crate::dcel::{Face, HalfEdge, Mesh, Vertex};
use crate::harness::{Cell, Column, Link, Structure, Table};

const fn link(name: &'static str, letter: char) -> Column {
    Column::Link(Link { name, letter })
}

fn live(live: bool) -> Cell {
    Cell::Number(if live { 1.0 } else { 0.0 })
}

impl Structure for Mesh {
    const TABLES: &'static [Table] = &[
        Table {
            letter: 'v',
            word: "vertex",
            name: "vertex",
            plural: "vertices",
            columns: &[Column::Number, Column::Number, Column::Number, link("outgoing", 'h'), Column::Number],
            shortcuts: &[],
        },
        Table {
            letter: 'h',
            word: "half_edge",
            name: "half-edge",
            plural: "half-edges",
            columns: &[
                link("origin", 'v'),
                link("twin", 'h'),
                link("next", 'h'),
                link("prev", 'h'),
                link("face", 'f'),
                Column::Number,
            ],
            shortcuts: &[],
        },
        Table {
            letter: 'f',
            word: "face",
            name: "face",
            plural: "faces",
            columns: &[link("boundary", 'h'), Column::Number],
            shortcuts: &[],
        },
    ];
    const SINGLES: &'static [&'static str] = &[];

    fn len(&self, table: usize) -> usize {
        [self.vertices.len(), self.half_edges.len(), self.faces.len()][table]
    }

    fn row(&self, table: usize, number: usize) -> Vec<Cell> {
        match table {
            0 => {
                let vertex = self.vertices[number];
                let mut row: Vec<Cell> = vertex.pos.map(Cell::Number).into();
                row.extend([Cell::Link(vertex.outgoing_half_edge), live(vertex.live)]);
                row
            }
            1 => {
                let h = self.half_edges[number];
                let mut row: Vec<Cell> = [h.origin, h.twin, h.next, h.prev, h.face].map(Cell::Link).into();
                row.push(live(h.live));
                row
            }
            _ => vec![Cell::Link(self.faces[number].incident_half_edge), live(self.faces[number].live)],
        }
    }

    fn add(&mut self, table: usize, row: &[Cell]) {
        let live = row.last().is_some_and(|cell| cell.number() != 0.0);
        match (table, row) {
            (0, [x, y, z, outgoing, _]) => {
                let pos = [x, y, z].map(|cell| cell.number());
                self.vertices.push(Vertex { outgoing_half_edge: outgoing.to(), pos, live });
                if !live {
                    self.free_vertices.push(self.vertices.len() - 1);
                }
            }
            (1, [origin, twin, next, prev, face, _]) => {
                let [origin, twin, next, prev, face] = [origin, twin, next, prev, face].map(|cell| cell.to());
                let number = self.half_edges.len();
                self.half_edges.push(HalfEdge { origin, face, prev, next, twin, live });
                if !live {
                    self.free_half_edges.push(number);
                }
                // The second of two twins knows both ends.
                if let Some(twin) = twin.filter(|&twin| twin < number)
                    && let (Some(a), Some(b)) = (origin, self.half_edges[twin].origin)
                {
                    self.edges.insert((a, b), number);
                    self.edges.insert((b, a), twin);
                }
            }
            (_, row) => {
                self.faces.push(Face { incident_half_edge: row[0].to(), live });
                if !live {
                    self.free_faces.push(self.faces.len() - 1);
                }
            }
        }
    }

    fn differs(&self, other: &Self, table: usize, number: usize) -> bool {
        match table {
            0 => self.vertices[number] != other.vertices[number],
            1 => self.half_edges[number] != other.half_edges[number],
            _ => self.faces[number] != other.faces[number],
        }
    }

    fn single(&self, _: usize) -> Option<usize> {
        None
    }

    fn set_single(&mut self, _: usize, _: Option<usize>) {}
}
