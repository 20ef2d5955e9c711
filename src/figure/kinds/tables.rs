//! The tables of the slides beside the picture: one element, marked in both.
//!
//! ```text
//!   ┌─────────────────┐    h    origin twin next prev face
//!   │    picture      │    h0   v0     h1   h6   h8   f1
//!   │                 │  ▸ h2   v1     h3   h4   h0   f1
//!   └─────────────────┘    ...
//!    v   x  y  outgoing      f    boundary  rings               beside these of the half-edges, if a page holds that
//! ```

use crate::figure::canvas::scene::{Group, Node};
use crate::figure::canvas::vector::{Xy, xy};
use crate::figure::canvas::{crop, number, text};
use crate::figure::structure::look::{Look, Mark};
use crate::figure::structure::notes::Notes;
use crate::figure::structure::part::Part;
use crate::figure::structure::plate::Plate;
use crate::figure::structure::pointer_style;
use crate::figure::structure::skeleton::{faces, half_edges, vertices};
use crate::figure::{Figure, FigureError, FigureOptions};
use crate::ids::{Element, FaceId, Id};
use crate::plane::PlanarView;
use std::collections::BTreeMap;

/// Height of a row, and the size of its text.
const ROW: f64 = 17.0;
const TEXT: f64 = 10.5;
/// Space round the tables.
const GAP: f64 = 22.0;
/// A table shows at most so many rows.
const ROWS: usize = 120;
/// Longer names are cut.
const NAME: usize = 24;

/// Draws the structure with its vertex, half-edge and face tables beside it, one element marked in both.
///
/// Everything but the marked element is grey in the picture; without one nothing is. Of each table at most 120
/// rows are shown, the others are counted in the notes. Of some [faces](FigureOptions::faces) only, the tables hold
/// what the picture shows. Elements with names have these in a column of their table; faces show id and name in the picture,
/// too.
///
/// # Errors
/// Those of [`structure`](crate::figure::structure()), and [`FigureError::NotDrawn`] if the marked element is not there.
///
/// ```
/// use dcel_kit::figure::{self, FigureOptions};
/// use dcel_kit::{HalfEdgeId, plane::Subdivision};
/// let lab = Subdivision::lab_rectangle();
/// let svg = figure::tables(&lab, Some(HalfEdgeId::new(2).into()), &FigureOptions::new("Lab"))?.to_svg();
/// assert!(svg.contains("id=\"lab-row-h2\""));
/// # Ok::<(), figure::FigureError>(())
/// ```
pub fn tables(
    view: &dyn PlanarView,
    highlight: Option<Element>,
    options: &FigureOptions,
) -> Result<Figure, FigureError> {
    let view: &dyn PlanarView = &Part::of(view, options)?;
    let mut options = options.checked();
    options.usual_width = 520.0;
    options.style.face_text = options.style.face_text.min(14.0);
    let names = Names::of(view, &options);
    options.names.extend(faces(view).filter_map(|f| Some((f, format!("{f} {}", names.face(f)?)))));
    let options = &options;
    let plate = Plate::new(view, options, false)?;
    let mut notes = Notes(plate.notes.0.clone());
    let look = look(view, highlight)?;
    let mut scene = plate.picture.scene(Vec::new());
    scene.nodes = crop::framed(plate.nodes(view, &look, Vec::new()), scene.size, options);
    let marked = highlight.map(|element| element.to_string());
    let picture = scene.size;
    let tables = [half_edge_table(view, &names), vertex_table(view, &names), face_table(view, &names)];
    let sizes = tables.each_ref().map(Words::size);
    for (table, corner) in tables.iter().zip(corners(picture, sizes, options.page())) {
        scene.nodes.push(table.group(corner, &table.widths(), marked.as_deref()));
        let end = corner + table.size() + xy(GAP, 0.0);
        scene.size = xy(scene.size.x.max(end.x), scene.size.y.max(end.y));
        if table.rows.len() > ROWS {
            notes.0.push(format!("{} more rows of {} are not shown", table.rows.len() - ROWS, table.name));
        }
    }
    scene.css.push_str(&pointer_style::css(&options.style, &scene.prefix));
    Ok(Figure { scene, detail: plate.picture.detail, notes: notes.0 })
}

/// Where the tables stand on a page of this width. The half-edges are beside the picture if there is room for that; the
/// vertices and the faces, one below the other, beside these, or below the picture: side by side where they have room, too.
fn corners(picture: Xy, [half_edges, vertices, faces]: [Xy; 3], page: f64) -> [Xy; 3] {
    let first = xy(picture.x + GAP, GAP);
    let second = xy(first.x + half_edges.x + GAP, GAP);
    if second.x + vertices.x.max(faces.x) + GAP <= page {
        return [first, second, second + xy(0.0, vertices.y)];
    }
    let below = xy(GAP, picture.y + GAP);
    let beside = below + xy(vertices.x + 2.0 * GAP, 0.0);
    if page < second.x {
        let width = picture.x.max(half_edges.x + GAP);
        let under = below + xy(0.0, half_edges.y);
        let beside = xy(beside.x, under.y);
        return [below, under, if beside.x + faces.x <= width { beside } else { under + xy(0.0, vertices.y) }];
    }
    let fits = beside.x + faces.x + GAP <= first.x || picture.y >= half_edges.y;
    [first, below, if fits { beside } else { below + xy(0.0, vertices.y) }]
}

/// The marked element bold, the half-edges grey beside it.
fn look(view: &dyn PlanarView, highlight: Option<Element>) -> Result<Look, FigureError> {
    let Some(element) = highlight else { return Ok(Look::default()) };
    let mut look = Look::default().rest(Mark::Dim);
    match element {
        Element::Vertex(v) if view.has_vertex(v) => look.mark_vertex(v, Mark::Hot),
        Element::HalfEdge(h) if view.has_half_edge(h) => look.mark_half_edge(h, Mark::Hot),
        Element::Edge(e) if e.half_edges().into_iter().all(|h| view.has_half_edge(h)) => {
            e.half_edges().into_iter().for_each(|h| look.mark_half_edge(h, Mark::Hot));
        }
        Element::Face(f) if view.has_face(f) => look.mark_face(f, Mark::Hot),
        _ => return Err(FigureError::NotDrawn { element }),
    }
    Ok(look)
}

/// The names that the caller gave: a column more in the table of the elements that have any.
#[derive(Default)]
struct Names(BTreeMap<Element, String>);

impl Names {
    fn of(view: &dyn PlanarView, options: &FigureOptions) -> Self {
        let labelled =
            |id: Element, label: Option<&str>| Some((id, label.filter(|l| !l.trim().is_empty())?.to_owned()));
        let vertices = vertices(view).filter_map(|v| labelled(v.into(), options.overrides.label_of(v)));
        let half_edges = half_edges(view).filter_map(|h| labelled(h.into(), options.overrides.label_of(h)));
        let faces = faces(view).filter_map(|f| labelled(f.into(), options.name(f)));
        Self(vertices.chain(half_edges).chain(faces).collect())
    }

    fn face(&self, f: FaceId) -> Option<&str> {
        self.0.get(&f.into()).map(String::as_str)
    }

    /// The names at the end of the rows of elements of one kind, if one of these has a name.
    fn append<I: Id + Into<Element>>(&self, table: &mut Words, ids: impl Iterator<Item = I>) {
        let names: Vec<Option<&String>> = ids.map(|id| self.0.get(&id.into())).collect();
        if names.iter().any(Option::is_some) {
            table.head.push("name");
            for (row, name) in table.rows.iter_mut().zip(names) {
                row.push(name.map_or_else(|| "–".to_owned(), |name| text::shortened(name, NAME)));
            }
        }
    }
}

/// A table as words; the first word of a row names its element.
struct Words {
    name: &'static str,
    head: Vec<&'static str>,
    rows: Vec<Vec<String>>,
}

fn word<I: std::fmt::Display>(id: Option<I>) -> String {
    id.map_or_else(|| "–".to_owned(), |id| id.to_string())
}

fn half_edge_table(view: &dyn PlanarView, names: &Names) -> Words {
    let row = |h| {
        let pointers = [word(view.twin(h)), word(view.next(h)), word(view.prev(h)), word(view.face(h))];
        [h.to_string(), word(view.origin(h))].into_iter().chain(pointers).collect()
    };
    let head = ["", "origin", "twin", "next", "prev", "face"].to_vec();
    let mut table = Words { name: "half-edges", head, rows: half_edges(view).map(row).collect() };
    names.append(&mut table, half_edges(view));
    table
}

fn vertex_table(view: &dyn PlanarView, names: &Names) -> Words {
    let row = |v| {
        let at = view.position(v);
        let coordinate = |axis: Option<f64>| axis.map_or_else(|| "–".to_owned(), number::model);
        vec![v.to_string(), coordinate(at.map(|p| p.x)), coordinate(at.map(|p| p.y)), word(view.outgoing(v))]
    };
    let head = ["", "x", "y", "outgoing"].to_vec();
    let mut table = Words { name: "vertices", head, rows: vertices(view).map(row).collect() };
    names.append(&mut table, vertices(view));
    table
}

fn face_table(view: &dyn PlanarView, names: &Names) -> Words {
    let row = |f| {
        let rings: Vec<String> = view.inner_components(f).iter().map(|&ring| Element::from(ring).to_string()).collect();
        vec![f.to_string(), word(view.half_edge(f)), if rings.is_empty() { "–".to_owned() } else { rings.join(" ") }]
    };
    let head = ["", "half-edge", "inner components"].to_vec();
    let mut table = Words { name: "faces", head, rows: faces(view).map(row).collect() };
    names.append(&mut table, faces(view));
    table
}

impl Words {
    fn widths(&self) -> Vec<f64> {
        let column = |i: usize| {
            let words = self.rows.iter().take(ROWS).filter_map(|row| row.get(i)).map(String::as_str);
            let wide = words.chain([self.head[i]]).map(|word| text::width(word, TEXT, true));
            wide.fold(20.0, f64::max) + 14.0
        };
        (0..self.head.len()).map(column).collect()
    }

    /// With the space below it.
    fn size(&self) -> Xy {
        xy(self.widths().iter().sum(), ROW * (self.rows.len().min(ROWS) as f64 + 2.2))
    }

    fn group(&self, corner: Xy, widths: &[f64], marked: Option<&str>) -> Node {
        let total: f64 = widths.iter().sum();
        let middle = |left: &mut f64, width: &f64| {
            *left += width;
            Some(*left - 0.5 * width)
        };
        let middles: Vec<f64> = widths.iter().scan(0.0, middle).collect();
        let cell = |class: &'static str, column: usize, y: f64, word: &str| Node::Text {
            class,
            at: corner + xy(middles[column], y),
            size: TEXT,
            text: word.to_owned(),
        };
        let mut nodes = Vec::new();
        for (i, head) in self.head.iter().enumerate().filter(|(_, head)| !head.is_empty()) {
            nodes.push(cell("cm", i, 0.5 * ROW, head));
        }
        let under = corner + xy(0.0, ROW);
        nodes.push(Node::Line { class: "edge", from: under, to: under + xy(total, 0.0) });
        for (i, row) in self.rows.iter().take(ROWS).enumerate() {
            let top = ROW * (i as f64 + 1.0);
            let hit = marked == row.first().map(String::as_str);
            let mut cells = Vec::new();
            if hit {
                let at = corner + xy(0.0, top);
                let strip = vec![at, at + xy(total, 0.0), at + xy(total, ROW), at + xy(0.0, ROW)];
                cells.push(Node::Area { class: "hit", hatch: None, outlines: vec![strip] });
                let tip = at + xy(-3.0, 0.5 * ROW);
                let pointer = vec![tip, tip + xy(-8.0, 4.5), tip + xy(-8.0, -4.5)];
                cells.push(Node::Area { class: "mark", hatch: None, outlines: vec![pointer] });
            }
            for (column, word) in row.iter().enumerate() {
                cells.push(cell(if column == 0 { "key" } else { "val" }, column, top + 0.5 * ROW, word));
            }
            let id = row.first().map(|name| format!("row-{name}"));
            let mark = if hit { "hot" } else { "" };
            nodes.push(Node::Group(Group { class: "row", mark, id, nodes: cells, ..Group::default() }));
        }
        Node::Group(Group { class: "table", id: Some(format!("table-{}", self.name)), nodes, ..Group::default() })
    }
}
