//! The lines of a case: words, links and names.
//!
//! ```text
//!   let a = h8.prev           h8: given     .prev: a link from it     a: the name of what it leads to
//!   split_face a.twin h2
//! ```

use crate::dcel::{Dcel, FaceId, HalfEdgeId, VertexId};

/// A line of the input, for messages.
#[derive(Clone, Copy)]
pub struct Line<'a> {
    /// Its number, from 1.
    pub number: usize,
    /// What it says, without its comment.
    pub text: &'a str,
}

impl<'a> Line<'a> {
    /// The first word and the others; `None` if the line says nothing.
    pub fn words(self) -> Option<(&'a str, Vec<&'a str>)> {
        let mut words = self.text.split_whitespace();
        Some((words.next()?, words.collect()))
    }
}

/// The lines of a text, their comments cut off.
pub fn lines(text: &str) -> impl Iterator<Item = Line<'_>> {
    text.trim_start_matches('\u{feff}')
        .lines()
        .enumerate()
        .map(|(i, line)| Line { number: i + 1, text: line.split('#').next().unwrap_or("").trim() })
}

/// What a word names.
#[derive(Clone, Copy, PartialEq)]
pub enum Element {
    /// `v3`
    Vertex(VertexId),
    /// `h7`
    HalfEdge(HalfEdgeId),
    /// `f0`
    Face(FaceId),
}

/// Why a word names nothing.
pub enum Unresolved {
    /// A link on the way is not set, or leads to a record that does not exist.
    Unset,
    /// The word is not of the language.
    Mistake(String),
}

/// The names that `let` has given in a case.
#[derive(Default)]
pub struct Names<'a> {
    names: Vec<(&'a str, Element)>,
}

impl<'a> Names<'a> {
    /// Gives `element` a name. A name can be given again; the last one counts.
    pub fn name(&mut self, name: &'a str, element: Element) -> Result<(), String> {
        let mut letters = name.chars();
        let begins_well = letters.next().is_some_and(|c| c.is_alphabetic() || c == '_');
        if !begins_well || !letters.all(|c| c.is_alphanumeric() || c == '_') || given(name).is_some() {
            return Err(format!("`{name}` cannot be a name; write a word such as `wall`"));
        }
        self.names.push((name, element));
        Ok(())
    }

    /// Follows a word with its links, `h0.next.twin`, through the structure.
    pub fn resolve(&self, dcel: &Dcel, word: &str) -> Result<Element, Unresolved> {
        let mut parts = word.split('.');
        let first = parts.next().unwrap_or("");
        let named = self.names.iter().rev().find(|(name, _)| *name == first).map(|&(_, element)| element);
        let Some(mut element) = named.or_else(|| given(first)) else {
            return Err(Unresolved::Mistake(format!(
                "unknown word `{first}`; half-edges are h0, h1, …, vertices v0, v1, …, faces f0, f1, …, or names given by let"
            )));
        };
        exists(dcel, element)?;
        for link in parts {
            element = follow(dcel, element, link)?;
            exists(dcel, element)?;
        }
        Ok(element)
    }
}

/// `h12`, `v0`, `f1`: a letter and a number.
fn given(word: &str) -> Option<Element> {
    let digits = word.get(1..)?;
    if digits.is_empty() || !digits.bytes().all(|b| b.is_ascii_digit()) {
        return None;
    }
    let number = digits.parse().ok()?;
    match word.as_bytes()[0] {
        b'v' => Some(Element::Vertex(number)),
        b'h' => Some(Element::HalfEdge(number)),
        b'f' => Some(Element::Face(number)),
        _ => None,
    }
}

fn exists(dcel: &Dcel, element: Element) -> Result<(), Unresolved> {
    let found = match element {
        Element::Vertex(v) => v < dcel.vertices.len(),
        Element::HalfEdge(h) => h < dcel.half_edges.len(),
        Element::Face(f) => f < dcel.faces.len(),
    };
    if found { Ok(()) } else { Err(Unresolved::Unset) }
}

/// One link. The element exists.
fn follow(dcel: &Dcel, from: Element, link: &str) -> Result<Element, Unresolved> {
    let half_edge = |h: Option<HalfEdgeId>| h.map(Element::HalfEdge).ok_or(Unresolved::Unset);
    let vertex = |v: Option<VertexId>| v.map(Element::Vertex).ok_or(Unresolved::Unset);
    match from {
        Element::HalfEdge(h) => {
            let record = &dcel.half_edges[h];
            match link {
                "next" => half_edge(record.next),
                "prev" => half_edge(record.prev),
                "twin" => half_edge(record.twin),
                "origin" => vertex(record.origin),
                "destination" => vertex(record.twin.and_then(|t| dcel.half_edges.get(t)?.origin)),
                "face" => record.face.map(Element::Face).ok_or(Unresolved::Unset),
                _ => Err(Unresolved::Mistake(format!(
                    "a half-edge has no `{link}`; it has next, prev, twin, origin, destination and face"
                ))),
            }
        }
        Element::Vertex(v) if link == "outgoing" => half_edge(dcel.vertices[v].outgoing_half_edge),
        Element::Face(f) if link == "boundary" => half_edge(dcel.faces[f].incident_half_edge),
        Element::Vertex(_) => Err(Unresolved::Mistake(format!("a vertex has no `{link}`; it has outgoing"))),
        Element::Face(_) => Err(Unresolved::Mistake(format!("a face has no `{link}`; it has boundary"))),
    }
}
