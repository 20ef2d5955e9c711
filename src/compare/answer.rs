//! The answer of a comparison: the verdict, the layer that decided, what differs, in words and for a picture.

use super::graph::Graph;
use super::report::{Difference, Layer, counted};
use super::sketch::Sketch;
use crate::topology::Table;
use std::fmt::Write;

/// So many notes are written out.
const NOTED: usize = 8;
/// So many differences are written out.
const LISTED: usize = 10;

/// What the differences are drawn upon.
#[derive(Clone, Debug)]
pub(super) enum Scenery {
    /// A declared structure.
    Table(Table),
    /// Drawn points and lines.
    Graph(Graph),
}

/// The answer of a comparison.
#[derive(Clone, Debug)]
pub struct Comparison {
    pub(super) layer: Layer,
    pub(super) differences: Vec<Difference>,
    pub(super) notes: Vec<String>,
    pub(super) agreed: String,
    pub(super) scenery: Scenery,
    /// What the student's file shows, and whether in the coordinates of the reference.
    pub(super) student: Option<(Sketch, bool)>,
}

impl Comparison {
    /// Whether nothing differs.
    #[must_use]
    pub fn is_equal(&self) -> bool {
        self.differences.is_empty()
    }

    /// The layer that decided.
    #[must_use]
    pub const fn layer(&self) -> Layer {
        self.layer
    }

    /// What differs: the drawing as a whole first, then vertices, edges, half-edges, faces.
    #[must_use]
    pub fn differences(&self) -> &[Difference] {
        &self.differences
    }

    /// What was seen on the way and decides nothing: what was not read, what is drawn twice.
    #[must_use]
    pub fn notes(&self) -> &[String] {
        &self.notes
    }

    /// What agrees, such as `21 of 24 half-edges agree`; empty if that was not counted.
    #[must_use]
    pub fn agreed(&self) -> &str {
        &self.agreed
    }

    /// The verdict in one line: `equal (same drawn geometry)`.
    #[must_use]
    pub fn verdict(&self) -> String {
        let name = self.layer.name();
        match self.differences.len() {
            0 => format!("equal (same {name})"),
            n => format!("differs in its {name}: {}", counted(n, "difference", "differences")),
        }
    }

    /// The whole answer for people, a line a difference: at most ten, then `and k more`.
    #[must_use]
    pub fn text(&self) -> String {
        let mut out = self.verdict();
        if !self.agreed.is_empty() && !self.is_equal() {
            let _ = write!(out, ", {}", self.agreed);
        }
        out.push('\n');
        for (i, difference) in self.differences.iter().take(LISTED).enumerate() {
            let _ = writeln!(out, "{:>4}. {}", i + 1, difference.text);
        }
        if self.differences.len() > LISTED {
            let _ = writeln!(out, "      and {} more", self.differences.len() - LISTED);
        }
        for note in self.notes.iter().take(NOTED) {
            let _ = writeln!(out, "note: {note}");
        }
        if self.notes.len() > NOTED {
            let _ = writeln!(out, "note: and {} more notes", self.notes.len() - NOTED);
        }
        out
    }
}
