//! Names that a figure draws in the group of what they name: each has to say its own name, and to stand where it belongs.
//!
//! ```text
//!   (v0)───h0──▸───(v1)      a vertex: no other vertex is nearer; a half-edge: on its own side of its edge
//!      f1                    a face: within its outline
//! ```
//!
//! Names that the reference draws have to be drawn. What is wrong in the reference's own drawing nobody has to do better.

use super::beside::Beside;
use super::drawing::Drawing;
use super::eye::Eye;
use super::pairing::{Places, distance, lies_on, span};
use super::report::{Difference, Kind, Layer, Spot};
use crate::figure::structure::skeleton::destination;
use crate::ids::{FaceId, HalfEdgeId, VertexId};
use crate::plane::Point;
use crate::topology::{Table, View};
use std::collections::{BTreeMap, BTreeSet};

/// A name stands at its half-edge if its box is no further from the edge than so many heights of its letters, or its
/// middle than this part of the edge.
const HEIGHTS: f64 = 4.0;
const PART: f64 = 0.1;

/// What is drawn as the name of something.
#[derive(Clone, PartialEq, Eq, Debug)]
enum Drawn {
    Right,
    /// It says another name.
    Says(String),
    /// It stands elsewhere.
    Elsewhere,
    Hidden,
}

/// The names in a drawing, by what they name.
fn names(drawing: &Drawing, table: &Table) -> BTreeMap<String, Drawn> {
    let span = span(&drawing.points().collect::<Vec<Point>>());
    let mut eye = Eye::new(&drawing.painting, &Beside::default(), drawing.lines.len(), span);
    let around = Around::new(drawing, table, span);
    let mut out: BTreeMap<String, Drawn> = BTreeMap::new();
    for name in &drawing.names {
        let drawn = match name.coat {
            _ if around.is_other(&name.element, &name.text) => Drawn::Says(name.text.clone()),
            Some(coat) if eye.is_read(coat) => match around.is_at_place(&name.element, coat) {
                true => Drawn::Right,
                false => Drawn::Elsewhere,
            },
            _ => Drawn::Hidden,
        };
        // One right name is enough.
        if drawn == Drawn::Right || !out.contains_key(&name.element) {
            out.insert(name.element.clone(), drawn);
        }
    }
    out
}

/// What names stand beside.
struct Around<'a> {
    drawing: &'a Drawing,
    table: &'a Table,
    vertices: BTreeMap<&'a str, Point>,
    places: Places,
    /// How near to a name a vertex is looked for.
    reach: f64,
    /// What fills each face, and what faces are called.
    fillings: BTreeMap<&'a str, Vec<u32>>,
    faces: BTreeSet<&'a str>,
}

impl<'a> Around<'a> {
    fn new(drawing: &'a Drawing, table: &'a Table, span: f64) -> Self {
        let vertices: BTreeMap<&str, Point> =
            drawing.dots.iter().filter_map(|dot| Some((dot.vertex.as_ref()?.0.as_str(), dot.at))).collect();
        let reach = span / (vertices.len().max(1) as f64).sqrt();
        let mut fillings: BTreeMap<&str, Vec<u32>> = BTreeMap::new();
        for outline in &drawing.outlines {
            fillings.entry(outline.name.as_str()).or_default().push(outline.coat);
        }
        let faces = table.faces.iter().flatten().filter_map(|row| row.name.as_deref()).collect();
        let places = Places::of(&vertices.values().copied().collect::<Vec<_>>(), reach);
        Self { drawing, table, vertices, places, reach, fillings, faces }
    }

    /// Whether a text is the name of something else of the same kind.
    fn is_other(&self, element: &str, text: &str) -> bool {
        let is_number = |text: &str| !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit());
        if text == element {
            return false;
        }
        let Ok(f) = element.parse::<FaceId>() else {
            return text.get(..1) == element.get(..1) && text.get(1..).is_some_and(is_number);
        };
        let own = self.table.faces.get(f.index()).and_then(|row| row.as_ref()?.name.as_deref());
        let is_name = |name: Option<&str>| name == Some(text);
        !is_name(own) && (self.faces.contains(text) || text.parse::<FaceId>().is_ok())
    }

    /// Whether letters stand where something is that a group declares.
    fn is_at_place(&self, element: &str, letters: u32) -> bool {
        let coat = &self.drawing.painting.coats[letters as usize];
        let [low, high] = coat.corners();
        let middle = Point::new(0.5 * (low.x + high.x), 0.5 * (low.y + high.y));
        if element.parse::<VertexId>().is_ok() {
            let Some(&at) = self.vertices.get(element) else { return true };
            // Only a vertex that is much nearer is named instead.
            let nearer = self.places.near(middle, (0.5 * distance(at, middle)).min(self.reach));
            return nearer.is_none_or(|i| self.places.points()[i as usize] == at);
        }
        if let Ok(h) = element.parse::<HalfEdgeId>() {
            let place = |v: Option<VertexId>| self.vertices.get(v?.to_string().as_str()).copied();
            let ends = place(self.table.origin(h)).zip(place(destination(self.table, h)));
            let Some((from, to)) = ends.filter(|(from, to)| from != to) else { return true };
            let left = (to.x - from.x) * (middle.y - from.y) - (to.y - from.y) * (middle.x - from.x);
            let reach = (0.5 * coat.diameter() + HEIGHTS * coat.thickness()).max(PART * distance(from, to));
            return left > 0.0 && lies_on(middle, [from, to], reach);
        }
        let covers = |&coat: &u32| self.drawing.painting.coats[coat as usize].covers(middle).0;
        self.fillings.get(element).is_none_or(|coats| coats.iter().any(covers))
    }
}

/// The names of a student's drawing against those of the reference, each with the structure that its file declares.
pub(super) fn compare([reference, student]: [(&Drawing, &Table); 2]) -> Vec<Difference> {
    let [expected, found] = [reference, student].map(|(drawing, table)| names(drawing, table));
    let mut out = Vec::new();
    let mut say = |element: &str, text: String| {
        let kind = match element.as_bytes().first() {
            Some(b'v') => Kind::Vertex,
            Some(b'h') => Kind::HalfEdge,
            _ => Kind::Face,
        };
        out.push(Difference::new(kind, Layer::Drawn, text, Spot::Nowhere));
    };
    for (element, drawn) in found.iter().filter(|(element, drawn)| expected.get(*element) != Some(*drawn)) {
        match drawn {
            Drawn::Right | Drawn::Hidden => {}
            Drawn::Says(text) => say(element, format!("the name drawn at {element} is {text}")),
            Drawn::Elsewhere => say(element, format!("the name of {element} does not stand where {element} is drawn")),
        }
    }
    for (element, _) in expected.iter().filter(|(_, drawn)| **drawn == Drawn::Right) {
        match found.get(element) {
            None => say(element, format!("the name of {element} is not drawn")),
            Some(Drawn::Hidden) => say(element, format!("the name of {element} cannot be seen")),
            Some(_) => {}
        }
    }
    out
}
