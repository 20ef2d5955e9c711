//! The records of a mesh, as the lines of a dump have them.

use crate::dcel::{Face, HalfEdge, Mesh, Vertex};
use crate::harness::{Cell, Column, Link, Structure, Table};

const fn link(name: &'static str, letter: char) -> Column {
    Column::Link(Link { name, letter })
}

/// The last field of a record: 1 if it is live, 0 if it is free. Other numbers tell what is wrong beside the records; the
/// odd ones are those of live records.
///
/// ```text
///   2  free, but not on its free list, or more than once      3  live, but on the free list
///   4  free, but in the edge map                              5  live, but the edge map does not fit
/// ```
fn state(live: bool, free: &[usize], number: usize, map_fits: bool) -> usize {
    let listed = free.iter().filter(|&&other| other == number).count();
    match (live, listed, map_fits) {
        (true, 0, true) => 1,
        (false, 1, true) => 0,
        (true, 0, false) => 5,
        (false, 1, false) => 4,
        (true, ..) => 3,
        (false, ..) => 2,
    }
}

impl Mesh {
    /// The state of a record, and of what the free lists and the edge map say of it.
    fn state(&self, table: usize, number: usize) -> usize {
        match table {
            0 => state(self.vertices[number].live, &self.free_vertices, number, self.fits_from(number)),
            1 => state(self.half_edges[number].live, &self.free_half_edges, number, self.is_known(number)),
            _ => state(self.faces[number].live, &self.free_faces, number, true),
        }
    }

    /// Whether all entries of the edge map that begin at `v` lead to the live half-edge with these ends.
    fn fits_from(&self, v: usize) -> bool {
        self.edges.from(v).all(|(to, h)| {
            let end = |h: &HalfEdge| h.twin.and_then(|twin| self.half_edges.get(twin)?.origin);
            self.half_edges.get(h).is_some_and(|h| h.live && h.origin == Some(v) && end(h) == Some(to))
        })
    }

    /// Whether the edge map leads to `h` from its ends. Free half-edges, and those without ends, need not be in the map.
    fn is_known(&self, h: usize) -> bool {
        let half_edge = self.half_edges[h];
        let end = half_edge.twin.and_then(|twin| self.half_edges.get(twin)?.origin);
        match (half_edge.live, half_edge.origin, end) {
            (true, Some(from), Some(to)) => self.half_edge_between(from, to) == Some(h),
            _ => true,
        }
    }
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
            columns: &[link("half_edge", 'h'), Column::Number],
            shortcuts: &[],
        },
    ];
    const SINGLES: &'static [&'static str] = &[];

    fn len(&self, table: usize) -> usize {
        [self.vertices.len(), self.half_edges.len(), self.faces.len()][table]
    }

    fn row(&self, table: usize, number: usize) -> Vec<Cell> {
        let state = Cell::Number(self.state(table, number) as f64);
        match table {
            0 => {
                let vertex = self.vertices[number];
                let mut row: Vec<Cell> = vertex.pos.map(Cell::Number).into();
                row.push(Cell::Link(vertex.outgoing_half_edge));
                row.push(state);
                row
            }
            1 => {
                let h = self.half_edges[number];
                let mut row: Vec<Cell> = [h.origin, h.twin, h.next, h.prev, h.face].map(Cell::Link).into();
                row.push(state);
                row
            }
            _ => vec![Cell::Link(self.faces[number].incident_half_edge), state],
        }
    }

    fn add(&mut self, table: usize, row: &[Cell]) {
        let live = row.last().is_some_and(|cell| cell.number() as u32 % 2 == 1);
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
        let is_other = match table {
            0 => self.vertices[number] != other.vertices[number],
            1 => self.half_edges[number] != other.half_edges[number],
            _ => self.faces[number] != other.faces[number],
        };
        is_other || self.state(table, number) != other.state(table, number)
    }

    fn single(&self, _: usize) -> Option<usize> {
        None
    }

    fn set_single(&mut self, _: usize, _: Option<usize>) {}
}
