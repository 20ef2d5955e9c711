//! Names that a figure draws in the group of what they name: each has to say its own name, and to stand where it belongs.
//!
//! ```text
//!   (v0)───h0──▸───(v1)      a vertex: near its disc; a half-edge: on its own side of its edge
//!      f1                    a face: within its outline
//! ```
//!
//! Names that the reference draws have to be drawn, so that they can be read, in the group of what they name or loose at
//! its place, and none of them elsewhere, too (`surplus.rs`). What is wrong in the reference's own drawing nobody has to
//! do better.

use super::beside::Beside;
use super::drawing::Drawing;
use super::error::quoted;
use super::eye::Eye;
use super::legible::Texts;
use super::pairing::span;
use super::placed::Placed;
use super::report::{Difference, Kind, Layer, Spot, counted, listed};
use super::spelling::Spelling;
use super::spots::Spots;
use super::standing::Around;
use super::surplus::{Surplus, surplus};
use crate::plane::Point;
use crate::topology::Table;
use std::collections::{BTreeMap, BTreeSet};

/// What is drawn as the name of something.
#[derive(Clone, PartialEq, Eq, Debug)]
enum Drawn {
    Right,
    /// It says another name.
    Says(String),
    /// It stands elsewhere.
    Elsewhere,
    Hidden,
    /// It is no name.
    Text(String),
}

impl Drawn {
    /// How much it says: of several texts, the first of those that say most counts.
    fn weight(&self) -> u8 {
        match self {
            Self::Text(_) => 0,
            Self::Hidden => 1,
            Self::Says(_) | Self::Elsewhere => 2,
            Self::Right => 3,
        }
    }
}

/// The names in a drawing.
struct Names {
    /// By what they name.
    drawn: BTreeMap<String, Drawn>,
    surplus: BTreeSet<(Surplus, String)>,
}

/// Reads the names in a drawing.
fn names(drawing: &Drawing, table: &Table) -> Names {
    let span = span(&drawing.points().collect::<Vec<Point>>());
    let mut eye = Eye::new(&drawing.painting, &Beside::default(), drawing.lines.len(), span);
    let around = Around::new(drawing, table, span);
    let texts = Texts::of(drawing);
    let mut out: BTreeMap<String, Drawn> = BTreeMap::new();
    let mut right: BTreeMap<String, u32> = BTreeMap::new();
    for name in drawing.names.iter().filter(|name| !name.element.is_empty()) {
        let is_read = !name.coats.is_empty() && name.coats.clone().all(|coat| eye.is_read(coat));
        let drawn = match (around.spelling(&name.element, &name.text), name.coats.start) {
            (Spelling::Other, _) => Drawn::Says(name.text.clone()),
            (Spelling::Nothing, _) if !is_read => continue,
            (Spelling::Nothing, _) => Drawn::Text(name.text.clone()),
            _ if !is_read => Drawn::Hidden,
            (_, coat) if !around.is_at_place(&name.element, coat) => Drawn::Elsewhere,
            (_, coat) if eye.is_written_over(coat, &texts) => Drawn::Hidden,
            (_, coat) => {
                right.entry(name.element.clone()).or_insert(coat);
                Drawn::Right
            }
        };
        if out.get(&name.element).is_none_or(|other| drawn.weight() > other.weight()) {
            out.insert(name.element.clone(), drawn);
        }
    }
    // Loose names count where no text in a group says more.
    for name in drawing.names.iter().filter(|name| name.element.is_empty() && !name.noted && !name.coats.is_empty()) {
        for element in around.named(&name.text) {
            let says_more = out.get(&element).is_some_and(|other| other.weight() > Drawn::Hidden.weight());
            let coat = name.coats.start;
            if says_more || !around.is_at_place(&element, coat) {
                continue;
            }
            if name.coats.clone().all(|coat| eye.is_read(coat)) && !eye.is_written_over(coat, &texts) {
                right.entry(element.clone()).or_insert(coat);
                out.insert(element, Drawn::Right);
            }
        }
    }
    let surplus = surplus(drawing, &around, &mut eye, &right);
    Names { drawn: out, surplus }
}

/// The names of a student's drawing against those of the reference, each with the structure that its file declares.
pub(super) fn compare([reference, student]: [(&Drawing, &Placed<'_>); 2]) -> Vec<Difference> {
    let [mine, theirs] = [reference, student].map(|(drawing, placed)| names(drawing, placed.table));
    let (expected, found) = (mine.drawn, theirs.drawn);
    let mut out = Vec::new();
    let mut spots = [reference.1, student.1].map(Spots::new);
    let mut say = |element: &str, text: String| {
        let kind = match element.as_bytes().first() {
            Some(b'v') => Kind::Vertex,
            Some(b'h') => Kind::HalfEdge,
            _ => Kind::Face,
        };
        let spot = spots.iter_mut().map(|spots| spots.named(element)).find(|spot| *spot != Spot::Nowhere);
        let spot = spot.unwrap_or(Spot::Nowhere);
        out.push(Difference::new(kind, Layer::Drawn, text, spot));
    };
    for (element, drawn) in found.iter().filter(|(element, drawn)| expected.get(*element) != Some(*drawn)) {
        match drawn {
            Drawn::Right | Drawn::Hidden | Drawn::Text(_) => {}
            Drawn::Says(text) => say(element, format!("the name drawn at {element} is {text}")),
            Drawn::Elsewhere => say(element, format!("the name of {element} does not stand where {element} is drawn")),
        }
    }
    for (element, _) in expected.iter().filter(|(_, drawn)| **drawn == Drawn::Right) {
        match found.get(element) {
            None => say(element, format!("the name of {element} is not drawn")),
            Some(Drawn::Hidden) => say(element, format!("the name of {element} cannot be seen")),
            Some(Drawn::Text(text)) => {
                say(element, format!("the name of {element} is not drawn: `{}` stands in its place", quoted(text)));
            }
            Some(_) => {}
        }
    }
    for kind in Surplus::ALL {
        let more = theirs.surplus.difference(&mine.surplus).filter(|(other, _)| *other == kind);
        let told: Vec<String> = more.map(|(_, text)| text.clone()).collect();
        if let Some(first) = told.first() {
            let [one, many] = kind.words();
            say(first, format!("{}: {}", counted(told.len(), one, many), listed(&told)));
        }
    }
    out
}
