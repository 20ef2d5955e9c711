//! A student's program: it draws a structure as lines, circles and polygons, with the standard library only.

use dcel_kit::plane::{PlanarView, Subdivision};
use dcel_kit::topology::{Table, View};
use dcel_kit::{HalfEdgeId, VertexId};
use std::fmt::Write;

pub(crate) type P = [f64; 2];

/// Lines, dots and areas in the coordinates of the model.
#[derive(Clone, Debug)]
pub(crate) struct Pen {
    pub(crate) lines: Vec<[P; 2]>,
    pub(crate) dots: Vec<P>,
    pub(crate) areas: Vec<Vec<P>>,
}

impl Pen {
    pub(crate) fn new(plane: &Subdivision) -> Self {
        let at = |v: VertexId| {
            let p = plane.position(v).unwrap();
            [p.x, p.y]
        };
        let bounded = plane.faces().filter(|&f| f != plane.outer_face());
        Self {
            lines: plane.edges().map(|e| e.half_edges().map(|h| at(plane.topology().origin(h)))).collect(),
            dots: plane.vertices().map(at).collect(),
            areas: bounded.map(|f| plane.incident_vertices(f).map(at).collect()).collect(),
        }
    }

    /// The point of the canvas: y points down there.
    pub(crate) fn canvas([x, y]: P) -> P {
        [300.0 + x, 200.0 - y]
    }

    /// Every point moved by the same rule.
    pub(crate) fn moved(&self, map: impl Fn(P) -> P) -> Self {
        Self {
            lines: self.lines.iter().map(|line| line.map(&map)).collect(),
            dots: self.dots.iter().map(|&p| map(p)).collect(),
            areas: self.areas.iter().map(|area| area.iter().map(|&p| map(p)).collect()).collect(),
        }
    }

    /// The elements, one a line: areas, lines, circles.
    pub(crate) fn elements(&self) -> Vec<String> {
        let mut out = Vec::new();
        for area in &self.areas {
            let mut points = String::new();
            for [x, y] in area.iter().map(|&p| Self::canvas(p)) {
                write!(points, "{x},{y} ").unwrap();
            }
            out.push(format!("<polygon points=\"{}\" fill=\"#e8f0ff\"/>", points.trim_end()));
        }
        for line in &self.lines {
            let [[a, b], [c, d]] = line.map(Self::canvas);
            out.push(format!("<line x1=\"{a}\" y1=\"{b}\" x2=\"{c}\" y2=\"{d}\" stroke=\"black\"/>"));
        }
        for [x, y] in self.dots.iter().map(|&p| Self::canvas(p)) {
            out.push(format!("<circle cx=\"{x}\" cy=\"{y}\" r=\"4\"/>"));
        }
        out
    }

    pub(crate) fn svg(&self) -> String {
        document(&self.elements())
    }
}

pub(crate) fn document(elements: &[String]) -> String {
    let body = elements.join("\n");
    format!("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 600 400\">\n{body}\n</svg>\n")
}

/// The structure as a table with positions.
pub(crate) fn table(plane: &Subdivision) -> Table {
    let mut table = Table::from_view(plane);
    for v in plane.vertices() {
        table.vertices[v.index()].as_mut().unwrap().position = plane.position(v).map(|p| [p.x, p.y]);
    }
    table
}

/// The same structure with other numbers: `order` says which old element becomes number i.
pub(crate) fn renumbered(table: &Table, mut order: impl FnMut(usize) -> Vec<usize>) -> Table {
    let (v, h, f) = (order(table.vertices.len()), order(table.half_edges.len()), order(table.faces.len()));
    let new = |order: &[usize], old: usize| order.iter().position(|&o| o == old).unwrap() as u32;
    let half_edge = |old: Option<HalfEdgeId>| old.map(|old| HalfEdgeId::new(new(&h, old.index())));
    let mut out = Table {
        vertices: v.iter().map(|&i| table.vertices[i]).collect(),
        half_edges: h.iter().map(|&i| table.half_edges[i]).collect(),
        faces: f.iter().map(|&i| table.faces[i].clone()).collect(),
        outer_face: table.outer_face.map(|x| dcel_kit::FaceId::new(new(&f, x.index()))),
    };
    for row in out.vertices.iter_mut().flatten() {
        row.outgoing = half_edge(row.outgoing);
    }
    for row in out.half_edges.iter_mut().flatten() {
        row.origin = row.origin.map(|x| VertexId::new(new(&v, x.index())));
        row.face = row.face.map(|x| dcel_kit::FaceId::new(new(&f, x.index())));
        (row.twin, row.next, row.prev) = (half_edge(row.twin), half_edge(row.next), half_edge(row.prev));
    }
    for row in out.faces.iter_mut().flatten() {
        row.half_edge = half_edge(row.half_edge);
        assert!(row.inner_components.is_empty(), "not needed here");
    }
    assert_eq!(out.vertex_bound(), table.vertex_bound());
    out
}
