//! Half-edges that a figure of the kit declares and draws beside its edges: what is declared has to be seen.
//!
//! ```text
//!   ──▸──  h4     its line, with another colour than what lies below it, at some points along it at least
//!   ──◂──  h5
//! ```

use super::beside::Beside;
use super::drawing::Drawing;
use super::eye::Eye;
use super::pairing::span;
use super::report::{Difference, Kind, Layer, Spot, counted, listed};
use crate::plane::Point;

/// The names of half-edges that nobody sees.
fn unseen(drawing: &Drawing) -> Vec<String> {
    if drawing.halves.is_empty() {
        return Vec::new();
    }
    let span = span(&drawing.points().collect::<Vec<Point>>());
    let mut eye = Eye::new(&drawing.painting, &Beside::default(), drawing.lines.len(), span);
    let hidden = drawing.halves.iter().filter(|half| !eye.any_line(half.coats.clone(), !half.lacks));
    hidden.map(|half| half.name.clone()).collect()
}

/// What a file declares and hides, unless the reference hides as many.
pub(super) fn compare(reference: &Drawing, student: &Drawing) -> Option<Difference> {
    let hidden = unseen(student);
    if hidden.is_empty() || hidden.len() <= unseen(reference).len() {
        return None;
    }
    let what =
        counted(hidden.len(), "half-edge is declared and cannot be seen", "half-edges are declared and cannot be seen");
    let text = format!("{what}: {}", listed(&hidden));
    Some(Difference::new(Kind::HalfEdge, Layer::Drawn, text, Spot::Nowhere))
}
