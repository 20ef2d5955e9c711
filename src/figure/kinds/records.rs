//! The type diagram: the records of a half-edge structure and what their fields refer to.
//!
//! ```text
//!                 ┌── Dcel ──┐
//!        ┌────────┤          ├───────┐          a diamond: is made of;   an arrow: refers to
//!   ┌ Vertex ┐  ┌ HalfEdge ┐   ┌ Face ┐
//!   │outgoing├─▸│ origin   │◂──┤      │         (and twin, next, prev from HalfEdge to HalfEdge)
//!   └────────┘  └──────────┘   └──────┘
//! ```
//!
//! The records are those of the textbook, with an explicit twin: de Berg, Cheong, van Kreveld, Overmars,
//! *Computational Geometry*, 3rd edition, section 2.2. (Inside the kit the twin costs no memory: it is h ^ 1.)

use crate::figure::canvas::scene::{Group, Node, Scene};
use crate::figure::canvas::vector::{Bounds, Xy, xy};
use crate::figure::structure::arrows::Arrow;
use crate::figure::structure::pointer_style;
use crate::figure::{Detail, Figure, FigureOptions};

const HEADER: f64 = 30.0;
const ROW: f64 = 24.0;
const SIZE: Xy = xy(860.0, 462.0);

/// A record with its fields and their types.
struct Record {
    name: &'static str,
    at: Xy,
    width: f64,
    fields: &'static [(&'static str, &'static str)],
}

const RECORDS: [Record; 4] = [
    Record {
        name: "Dcel",
        at: xy(310.0, 20.0),
        width: 240.0,
        fields: &[("vertices", "list of Vertex"), ("half_edges", "list of HalfEdge"), ("faces", "list of Face")],
    },
    Record {
        name: "Vertex",
        at: xy(30.0, 131.0),
        width: 210.0,
        fields: &[("position", "Point"), ("outgoing", "HalfEdge")],
    },
    Record {
        name: "HalfEdge",
        at: xy(320.0, 190.0),
        width: 220.0,
        fields: &[
            ("origin", "Vertex"),
            ("twin", "HalfEdge"),
            ("next", "HalfEdge"),
            ("prev", "HalfEdge"),
            ("face", "Face"),
        ],
    },
    Record { name: "Face", at: xy(620.0, 155.0), width: 210.0, fields: &[("half_edge", "HalfEdge")] },
];

/// A reference: the classes of its arrow, the way, how many of the target there are.
type Reference = (&'static str, &'static [Xy], &'static str);

/// From the row of the field to the record it refers to; no two ways cross.
const REFERENCES: [Reference; 10] = [
    ("ptr owns", &[xy(310.0, 62.0), xy(135.0, 62.0), xy(135.0, 131.0)], "*"),
    ("ptr owns", &[xy(430.0, 122.0), xy(430.0, 190.0)], "*"),
    ("ptr owns", &[xy(550.0, 110.0), xy(725.0, 110.0), xy(725.0, 155.0)], "*"),
    ("ptr outgoing", &[xy(240.0, 197.0), xy(320.0, 197.0)], "0..1"),
    ("ptr boundary", &[xy(620.0, 197.0), xy(540.0, 197.0)], "0..1"),
    ("ptr origin", &[xy(320.0, 232.0), xy(135.0, 232.0), xy(135.0, 209.0)], "1"),
    ("ptr twin", &[xy(320.0, 256.0), xy(268.0, 256.0), xy(268.0, 394.0), xy(450.0, 394.0), xy(450.0, 340.0)], "1"),
    ("ptr next", &[xy(320.0, 280.0), xy(284.0, 280.0), xy(284.0, 378.0), xy(405.0, 378.0), xy(405.0, 340.0)], "1"),
    ("ptr next", &[xy(320.0, 304.0), xy(300.0, 304.0), xy(300.0, 362.0), xy(360.0, 362.0), xy(360.0, 340.0)], "1"),
    ("ptr face-of", &[xy(540.0, 328.0), xy(725.0, 328.0), xy(725.0, 209.0)], "1"),
];

/// What holds in a sound structure, in columns.
const INVARIANTS: [[&str; 2]; 3] = [
    ["twin(twin(h)) = h", "origin(next(h)) = origin(twin(h))"],
    ["next(prev(h)) = prev(next(h)) = h", "origin(outgoing(v)) = v"],
    ["face(next(h)) = face(h)", "face(half_edge(f)) = f"],
];

/// Draws the type diagram of the records: `Dcel`, `Vertex`, `HalfEdge` with an explicit twin, `Face`.
///
/// Of the options, title, description, prefix of ids and style count.
///
/// ```
/// use dcel_kit::figure::{self, FigureOptions};
/// assert!(figure::records(&FigureOptions::new("Records")).to_svg().contains("outgoing"));
/// ```
#[must_use]
pub fn records(options: &FigureOptions) -> Figure {
    let options = options.checked();
    let prefix = options.prefix();
    let mut nodes: Vec<Node> = RECORDS.iter().map(record).collect();
    nodes.extend(REFERENCES.iter().flat_map(reference));
    for (column, invariants) in INVARIANTS.iter().enumerate() {
        let invariant = |(i, invariant): (usize, &&str)| {
            let at = xy(40.0 + 285.0 * column as f64, 422.0 + 22.0 * i as f64);
            text("cs", at, 12.0, invariant)
        };
        nodes.extend(invariants.iter().enumerate().map(invariant));
    }
    let reading = "A half-edge refers to its origin, its twin, the next and the previous half-edge and its face; a \
                   vertex to one half-edge that leaves it; a face to one half-edge of its boundary; the structure \
                   owns the lists of all three.";
    let css = options.style.css(&prefix) + &pointer_style::css(&options.style, &prefix);
    let scene = Scene { css, nodes, ..options.scene("dcel-records", SIZE, reading.to_owned()) };
    Figure { scene, detail: Detail::Full, notes: Vec::new() }
}

fn text(class: &'static str, at: Xy, size: f64, text: &str) -> Node {
    Node::Text { class, at, size, text: text.to_owned() }
}

fn outline(at: Xy, size: Xy) -> Vec<Vec<Xy>> {
    vec![Bounds { min: at, max: at + size }.corners().to_vec()]
}

fn record(record: &Record) -> Node {
    let Record { name, at, width, fields } = *record;
    let size = xy(width, HEADER + ROW * fields.len() as f64);
    let mut nodes = vec![
        Node::Area { class: "rec", hatch: None, outlines: outline(at, size) },
        Node::Area { class: "rec head", hatch: None, outlines: outline(at, xy(width, HEADER)) },
        text("rn", at + xy(0.5 * width, 0.5 * HEADER), 14.0, name),
    ];
    for (i, (field, kind)) in fields.iter().enumerate() {
        let middle = at + xy(0.0, HEADER + ROW * (i as f64 + 0.5));
        nodes.push(text("ct", middle + xy(12.0, 0.0), 12.0, field));
        nodes.push(text("cs", middle + xy(106.0, 0.0), 12.0, kind));
    }
    Node::Group(Group { class: "record", id: Some(name.to_lowercase()), nodes, ..Group::default() })
}

fn reference(&(class, way, count): &Reference) -> Option<Node> {
    let (&from, &to, &before) = (way.first()?, way.last()?, way.get(way.len() - 2)?);
    let along = (to - before).unit()?;
    let mut nodes = Arrow::through(way)?.nodes("pl", "ph").to_vec();
    if class == "ptr owns" {
        let start = (*way.get(1)? - from).unit()?;
        let (middle, aside) = (from + start * 7.0, start.left() * 4.5);
        let diamond = vec![from, middle + aside, from + start * 14.0, middle - aside];
        nodes.push(Node::Area { class: "ph", hatch: None, outlines: vec![diamond] });
    }
    let beside = to - along * 13.0 + along.left() * if count.len() > 1 { 11.0 } else { 9.0 };
    nodes.push(text("cm", beside, 11.0, count));
    Some(Node::Group(Group { class, nodes, ..Group::default() }))
}
