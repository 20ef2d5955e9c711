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
fn state(live: bool, listed: usize, map_fits: bool) -> usize {
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
    /// The states of all records of a table: of the records, and of what the free lists and the edge map say of them.
    fn states(&self, table: usize) -> Vec<usize> {
        let (live, free): (Vec<bool>, &[usize]) = match table {
            0 => (self.vertices.iter().map(|v| v.live).collect(), &self.free_vertices),
            1 => (self.half_edges.iter().map(|h| h.live).collect(), &self.free_half_edges),
            _ => (self.faces.iter().map(|f| f.live).collect(), &self.free_faces),
        };
        let mut listed = vec![0; live.len()];
        for &number in free {
            if let Some(times) = listed.get_mut(number) {
                *times += 1;
            }
        }
        let map_fits = match table {
            0 => self.fits_from(),
            1 => self.is_known(),
            _ => vec![true; live.len()],
        };
        (0..live.len()).map(|number| state(live[number], listed[number], map_fits[number])).collect()
    }

    /// Both ends of a half-edge; `None` if it has not both.
    fn ends(&self, h: &HalfEdge) -> Option<(usize, usize)> {
        Some((h.origin?, self.half_edges.get(h.twin?)?.origin?))
    }

    /// For each vertex, whether all entries of the edge map that begin there lead to the live half-edge with these ends.
    fn fits_from(&self) -> Vec<bool> {
        let mut fits = vec![true; self.vertices.len()];
        for (ends, &h) in self.edges.iter().filter(|(ends, _)| ends.0 < self.vertices.len()) {
            let leads = self.half_edges.get(h).is_some_and(|h| h.live && self.ends(h) == Some(*ends));
            fits[ends.0] &= leads;
        }
        fits
    }

    /// For each half-edge, whether the edge map leads there from its ends. Free ones, and those without ends, need not be
    /// in the map.
    fn is_known(&self) -> Vec<bool> {
        let mut known: Vec<bool> = self.half_edges.iter().map(|h| !h.live || self.ends(h).is_none()).collect();
        for (ends, &h) in self.edges.iter() {
            if self.half_edges.get(h).is_some_and(|h| self.ends(h) == Some(*ends)) {
                known[h] = true;
            }
        }
        known
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

    fn rows(&self, table: usize) -> impl Fn(usize) -> Vec<Cell> {
        let states = self.states(table);
        move |number| {
            let mut row: Vec<Cell> = match table {
                0 => {
                    let vertex = self.vertices[number];
                    let [x, y, z] = vertex.pos.map(Cell::Number);
                    vec![x, y, z, Cell::Link(vertex.outgoing_half_edge)]
                }
                1 => {
                    let h = self.half_edges[number];
                    [h.origin, h.twin, h.next, h.prev, h.face].map(Cell::Link).into()
                }
                _ => vec![Cell::Link(self.faces[number].incident_half_edge)],
            };
            row.push(Cell::Number(states[number] as f64));
            row
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

    fn differs(&self, before: &Self, table: usize) -> impl Fn(usize) -> bool {
        let states = [self.states(table), before.states(table)];
        move |number| {
            let is_other = match table {
                0 => self.vertices[number] != before.vertices[number],
                1 => self.half_edges[number] != before.half_edges[number],
                _ => self.faces[number] != before.faces[number],
            };
            is_other || states[0][number] != states[1][number]
        }
    }

    fn single(&self, _: usize) -> Option<usize> {
        None
    }

    fn set_single(&mut self, _: usize, _: Option<usize>) {}
}
