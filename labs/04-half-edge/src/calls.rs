//! What a case of this lab can say: its records, its starts, and a line for each function of yours.

use crate::dcel::{Dcel, Face, HalfEdge, Point, Vertex};
use crate::harness::{Argument, Call, Cell, Column, Lab, Link, Shortcut, Start, Structure, Table, Take, Value};
use crate::svg::Svg;
use crate::{lab, pen, start};

/// Lab 04.
pub struct HalfEdgeLab;

const HALF_EDGE: Take = Take::Id('h');
/// A face, or a half-edge of it.
const FACE: Take = Take::IdOr('f', "face");

impl Lab for HalfEdgeLab {
    type Structure = Dcel;

    const STARTS: &'static [Start<Dcel>] = &[
        Start { word: "rectangle", usage: "write `rectangle`", make: start::rectangle },
        Start { word: "polygon", usage: "write `polygon 0 0 4 0 3 3`", make: start::polygon },
        Start { word: "triangles", usage: "write `triangles 0 0 1 0 1 1 / 0 1 2`", make: start::triangles },
        Start { word: "convex", usage: "write `convex 300`", make: start::convex },
        Start { word: "wheel", usage: "write `wheel 40`", make: start::wheel },
        Start { word: "grid", usage: "write `grid 20 15`", make: start::grid },
    ];

    const CALLS: &'static [Call<Dcel>] = &[
        Call {
            word: "walk_face",
            takes: &[FACE],
            usage: "it takes one face, such as f1, or a half-edge of it",
            run: |dcel, of, _| Value::ids(dcel.incident_half_edges(of[0].id())),
        },
        Call {
            word: "walk_vertices",
            takes: &[FACE],
            usage: "it takes one face, such as f1, or a half-edge of it",
            run: |dcel, of, _| Value::ids(dcel.incident_vertices(of[0].id())),
        },
        Call {
            word: "walk_vertex",
            takes: &[Take::Id('v')],
            usage: "it takes one vertex, such as v0 or h0.origin",
            run: |dcel, of, _| Value::ids(dcel.outgoing_half_edges(of[0].id())),
        },
        Call {
            word: "destination",
            takes: &[HALF_EDGE],
            usage: "it takes one half-edge, such as h2",
            run: |dcel, of, _| Value::Id(dcel.destination(of[0].id())),
        },
        Call {
            word: "destination_by_next",
            takes: &[HALF_EDGE],
            usage: "it takes one half-edge, such as h2",
            run: |dcel, of, _| Value::Id(dcel.destination_by_next(of[0].id())),
        },
        Call {
            word: "split_face",
            takes: &[HALF_EDGE, HALF_EDGE],
            usage: "write `split_face h2 h8`",
            run: |dcel, of, _| Value::Truth(dcel.split_face(of[0].id(), of[1].id())),
        },
        Call {
            word: "split_in_half",
            takes: &[HALF_EDGE],
            usage: "it takes one half-edge, such as h2",
            run: |dcel, of, _| {
                dcel.split_in_half(of[0].id());
                Value::Nothing
            },
        },
        Call {
            word: "drawing",
            takes: &[],
            usage: "it stands alone in its line",
            run: |dcel, _: &[Argument], meter| {
                pen::draw(dcel, meter, lab::drawing);
                Value::Nothing
            },
        },
    ];

    const PICTURE: Option<fn(&Dcel) -> String> = Some(|dcel| {
        let mut svg = Svg::default();
        lab::picture(dcel, &mut svg);
        svg.finish()
    });

    const NAMED: &'static [(&'static str, &'static str)] = &[("drawing", "rectangle\ndrawing\n")];
}

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
            columns: &[link("boundary", 'h')],
            shortcuts: &[],
        },
    ];
    const SINGLES: &'static [&'static str] = &["outer"];

    fn len(&self, table: usize) -> usize {
        [self.vertices.len(), self.half_edges.len(), self.faces.len()][table]
    }

    fn row(&self, table: usize, number: usize) -> Vec<Cell> {
        match table {
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

    fn differs(&self, other: &Self, table: usize, number: usize) -> bool {
        match table {
            0 => self.vertices[number] != other.vertices[number],
            1 => self.half_edges[number] != other.half_edges[number],
            _ => self.faces[number] != other.faces[number],
        }
    }

    fn single(&self, _: usize) -> Option<usize> {
        Some(self.outer_face)
    }

    fn set_single(&mut self, _: usize, to: Option<usize>) {
        self.outer_face = to.unwrap_or_default();
    }
}
