//! Layer 2, reading: the half-edge structure that a file declares in `data-*` attributes.
//!
//! ```text
//!   <g id="FIG-v3" data-x="1" data-y="2" data-he="h5">                                     a vertex
//!   <g id="FIG-h5" data-origin="v3" data-twin="h4" data-next="h6" data-prev="h9" data-face="f1">
//!   <g id="FIG-f1" data-he="h5" data-rings="h8 v7" data-outer="true" data-hole="true" data-name="pond">
//! ```
//!
//! Any element can carry them. The name of an element is what stands behind the last hyphen of its id. Nothing is
//! judged here: a missing attribute is a missing pointer, which the invariants then tell.

use super::error::{Fault, Problem, place, quoted};
use super::numbers;
use crate::ids::{FaceId, HalfEdgeId, VertexId};
use crate::plane::Point;
use crate::topology::{FaceRow, HalfEdgeRow, InnerComponent, Table, VertexRow, set_row};
use roxmltree::{Document, Node};
use std::str::FromStr;

/// Numbers of elements are below this.
const NUMBERS: usize = 400_000;
/// The attributes of a half-edge. A file without any of them declares nothing.
const POINTERS: [&str; 5] = ["data-origin", "data-twin", "data-next", "data-prev", "data-face"];
/// The attributes of vertices and faces.
const OTHERS: [&str; 7] = ["data-x", "data-y", "data-he", "data-rings", "data-outer", "data-hole", "data-name"];

/// The table that a document declares, if it declares half-edges.
pub(super) fn read(document: &Document<'_>) -> Result<Option<Table>, Fault> {
    let has = |node: Node<'_, '_>, keys: &[&str]| keys.iter().any(|&key| node.has_attribute(key));
    if !document.descendants().any(is_half_edge) {
        return Ok(None);
    }
    let mut reader = Reader { text: document.input_text(), ..Reader::default() };
    // The root says data-y="up".
    let elements = document.root_element().descendants().skip(1);
    for node in elements.filter(|&node| is_half_edge(node) || has(node, &OTHERS)) {
        let id = node.attribute("id").unwrap_or("");
        let name = last(id);
        match name.as_bytes().first() {
            Some(b'v') => reader.vertex(node, name)?,
            Some(b'h') => reader.half_edge(node, name)?,
            Some(b'f') => reader.face(node, name)?,
            _ if is_half_edge(node) => return Err(word(node, "id", id, "name of a half-edge such as h5")),
            _ => {}
        }
    }
    Ok(Some(reader.table))
}

/// The name of the vertex, half-edge or face that an element declares.
pub(super) fn name<'n>(node: Node<'n, '_>) -> Option<&'n str> {
    let declares = is_half_edge(node) || OTHERS.iter().any(|&key| node.has_attribute(key));
    node.attribute("id").map(last).filter(|name| declares && name.starts_with(['v', 'h', 'f']))
}

/// The name of the face of which an element of the kit holds the label, which stands outside of it.
pub(super) fn labelled<'n>(node: Node<'n, '_>) -> Option<&'n str> {
    node.attribute("id")?.strip_suffix("-label").map(last).filter(|name| name.parse::<FaceId>().is_ok())
}

/// Whether an element declares a half-edge.
pub(super) fn is_half_edge(node: Node<'_, '_>) -> bool {
    POINTERS.iter().any(|&key| node.has_attribute(key))
}

/// The vertex that an element declares, with its place in the model.
pub(super) fn vertex(node: Node<'_, '_>) -> Option<(String, Point)> {
    let name = node.attribute("id").map(last).filter(|name| name.starts_with('v'))?;
    let [x, y] = ["data-x", "data-y"].map(|key| numbers::length(node.attribute(key)?));
    Some((name.to_owned(), Point::new(x?, y?)))
}

/// The name of the face that an element declares, or nothing.
pub(super) fn face_name(node: Node<'_, '_>) -> String {
    let name = node.attribute("id").map(last).filter(|name| name.parse::<FaceId>().is_ok());
    name.map_or_else(String::new, str::to_owned)
}

#[derive(Default)]
struct Reader<'a> {
    text: &'a str,
    table: Table,
    /// Where the elements were declared: vertices, half-edges, faces.
    offsets: [Vec<usize>; 3],
}

impl Reader<'_> {
    fn vertex(&mut self, node: Node<'_, '_>, name: &str) -> Result<(), Fault> {
        let v: VertexId = id(node, name)?;
        self.claim(node, 0, v.index(), name)?;
        let [x, y] = [coordinate(node, "data-x")?, coordinate(node, "data-y")?];
        let position = x.zip(y).map(|(x, y)| [x, y]);
        let row = VertexRow { position, outgoing: pointer(node, "data-he")? };
        set_row(&mut self.table.vertices, v.index(), Some(row));
        Ok(())
    }

    fn half_edge(&mut self, node: Node<'_, '_>, name: &str) -> Result<(), Fault> {
        let h: HalfEdgeId = id(node, name)?;
        self.claim(node, 1, h.index(), name)?;
        let row = HalfEdgeRow {
            origin: pointer(node, "data-origin")?,
            twin: pointer(node, "data-twin")?,
            next: pointer(node, "data-next")?,
            prev: pointer(node, "data-prev")?,
            face: pointer(node, "data-face")?,
        };
        set_row(&mut self.table.half_edges, h.index(), Some(row));
        Ok(())
    }

    fn face(&mut self, node: Node<'_, '_>, name: &str) -> Result<(), Fault> {
        let f: FaceId = id(node, name)?;
        self.claim(node, 2, f.index(), name)?;
        let ring = |word: &str| -> Option<InnerComponent> {
            let word = last(word);
            word.parse().map(InnerComponent::Cycle).or_else(|_| word.parse().map(InnerComponent::Isolated)).ok()
        };
        let mut rings = Vec::new();
        for text in node.attribute("data-rings").unwrap_or("").split_whitespace() {
            rings.push(ring(text).ok_or_else(|| word(node, "data-rings", text, "half-edge or vertex"))?);
        }
        let row = FaceRow {
            half_edge: pointer(node, "data-he")?,
            inner_components: rings,
            hole: node.attribute("data-hole") == Some("true"),
            name: node.attribute("data-name").map(str::to_owned),
        };
        if node.attribute("data-outer") == Some("true") {
            if self.table.outer_face.is_some() {
                return Err(word(node, "data-outer", "true", "value here: another face is the outer face already"));
            }
            self.table.outer_face = Some(f);
        }
        set_row(&mut self.table.faces, f.index(), Some(row));
        Ok(())
    }

    fn claim(&mut self, node: Node<'_, '_>, kind: usize, index: usize, name: &str) -> Result<(), Fault> {
        let offset = node.range().start;
        let offsets = &mut self.offsets[kind];
        if index >= NUMBERS {
            return Err(Fault::at(offset, Problem::Number { element: quoted(name) }));
        }
        if index >= offsets.len() {
            offsets.resize(index + 1, usize::MAX);
        }
        if offsets[index] != usize::MAX {
            let first = place(self.text, offsets[index]).0;
            return Err(Fault::at(offset, Problem::DeclaredTwice { element: quoted(name), first }));
        }
        offsets[index] = offset;
        Ok(())
    }
}

/// What stands behind the last hyphen.
fn last(id: &str) -> &str {
    id.trim().rsplit('-').next().unwrap_or(id)
}

fn id<I: FromStr>(node: Node<'_, '_>, name: &str) -> Result<I, Fault> {
    name.parse().map_err(|_| word(node, "id", name, "name of an element such as v3, h5 or f1"))
}

fn pointer<I: FromStr>(node: Node<'_, '_>, key: &str) -> Result<Option<I>, Fault> {
    let Some(text) = node.attribute(key) else { return Ok(None) };
    let wanted = match key {
        "data-origin" => "vertex: write its name, such as v3",
        "data-face" => "face: write its name, such as f1",
        _ => "half-edge: write its name, such as h5",
    };
    last(text).parse().map(Some).map_err(|_| word(node, key, text, wanted))
}

fn coordinate(node: Node<'_, '_>, key: &str) -> Result<Option<f64>, Fault> {
    let Some(text) = node.attribute(key) else { return Ok(None) };
    let value = numbers::length(text).filter(|x| x.abs() <= crate::plane::LARGEST);
    value.map(Some).ok_or_else(|| word(node, key, text, "finite number: write a coordinate such as 12.5"))
}

fn word(node: Node<'_, '_>, key: &str, text: &str, wanted: &'static str) -> Fault {
    let offset = node.attribute_node(key).map_or(node.range().start, |attribute| attribute.range().start);
    Fault::at(offset, Problem::Word { word: quoted(text), wanted })
}
