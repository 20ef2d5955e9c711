//! A pointer led elsewhere by hand, and the invariants that break by it.

use super::reply::{Message, Tone, element};
use super::tables::{find, name, pointers};
use crate::ids::Element;
use crate::topology::{Table, Violation, violations};
use std::str::FromStr;

/// A table some of whose pointers were led elsewhere.
#[derive(Clone, Debug)]
pub(super) struct Broken {
    pub(super) table: Table,
    /// Each pointer that was led elsewhere, with what it led to before.
    changes: Vec<[String; 3]>,
}

impl Broken {
    pub(super) fn new(table: Table) -> Self {
        Self { table, changes: Vec::new() }
    }

    /// Leads a pointer elsewhere.
    pub(super) fn lead(&mut self, id: &str, pointer: &str, to: &str) -> Result<String, String> {
        let owner = find(&self.table, id)?;
        let before = set(&mut self.table, owner, pointer, to)?;
        let before = name(before);
        self.changes.push([owner.to_string(), pointer.to_owned(), before.clone()]);
        Ok(format!("{owner}.{pointer} = {} (it was {before})", to.trim()))
    }

    /// Takes the last change back; `None` if there is none.
    pub(super) fn undo(&mut self) -> Option<String> {
        let [id, pointer, before] = self.changes.pop()?;
        let owner = element(&id)?;
        set(&mut self.table, owner, &pointer, &before).ok()?;
        Some(format!("{id}.{pointer} = {before}"))
    }

    /// Each pointer that was led elsewhere, with what it leads to now.
    pub(super) fn kept(&self) -> Vec<String> {
        let mut out: Vec<String> = Vec::new();
        for [id, pointer, _] in &self.changes {
            let to = element(id).and_then(|owner| get(&self.table, owner, pointer));
            let line = format!("{id} {pointer} {}", name(to));
            if !out.contains(&line) {
                out.push(line);
            }
        }
        out
    }

    /// What is broken, each with the elements concerned.
    pub(super) fn faults(&self) -> Vec<Message> {
        faults(&self.table)
    }
}

/// What is broken in a table, each with the elements concerned.
pub(super) fn faults(table: &Table) -> Vec<Message> {
    violations(table).iter().map(message).collect()
}

/// A violation as a sentence with its elements.
fn message(violation: &Violation) -> Message {
    let mut elements: Vec<String> = violation.elements.iter().map(ToString::to_string).collect();
    elements.extend(violation.chain.iter().map(ToString::to_string));
    elements.extend([violation.found, violation.expected].iter().flatten().map(ToString::to_string));
    elements.sort();
    elements.dedup();
    Message { tone: Tone::Refused, text: violation.to_string(), elements }
}

/// The words of all pointers.
pub(super) const POINTERS: [&str; 7] = ["origin", "twin", "next", "prev", "face", "outgoing", "half_edge"];

/// What a pointer leads to.
pub(super) fn get(table: &Table, owner: Element, pointer: &str) -> Option<Element> {
    let known = pointers(table, owner).into_iter().find(|(name, _)| *name == pointer);
    known.and_then(|(_, to)| to)
}

/// Leads a pointer elsewhere, and gives back what it led to.
pub(super) fn set(table: &mut Table, owner: Element, pointer: &str, to: &str) -> Result<Option<Element>, String> {
    let before = get(table, owner, pointer);
    let word = to.trim();
    let wrong =
        |wanted: &str| format!("{owner}.{pointer} leads to {wanted}, and `{word}` is none; write {wanted} or none");
    let half_edge = || read(word, || wrong("a half-edge such as h0"));
    let gone = || format!("there is no {owner}");
    match (owner, pointer) {
        (Element::HalfEdge(h), "origin" | "twin" | "next" | "prev" | "face") => {
            let row = table.half_edges.get_mut(h.index()).and_then(Option::as_mut).ok_or_else(gone)?;
            match pointer {
                "origin" => row.origin = read(word, || wrong("a vertex such as v0"))?,
                "twin" => row.twin = half_edge()?,
                "next" => row.next = half_edge()?,
                "prev" => row.prev = half_edge()?,
                _ => row.face = read(word, || wrong("a face such as f0"))?,
            }
        }
        (Element::Vertex(v), "outgoing") => {
            table.vertices.get_mut(v.index()).and_then(Option::as_mut).ok_or_else(gone)?.outgoing = half_edge()?;
        }
        (Element::Face(f), "half_edge") => {
            table.faces.get_mut(f.index()).and_then(Option::as_mut).ok_or_else(gone)?.half_edge = half_edge()?;
        }
        _ => return Err(format!("{owner} has no pointer `{pointer}`")),
    }
    Ok(before)
}

/// An id, or none.
fn read<I: FromStr>(word: &str, wrong: impl FnOnce() -> String) -> Result<Option<I>, String> {
    if word.is_empty() || word == "none" { Ok(None) } else { word.parse().map(Some).map_err(|_| wrong()) }
}
