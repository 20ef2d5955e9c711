//! Half-edges that a figure of the kit declares and draws beside its edges: what is declared has to be seen.
//!
//! ```text
//!   ──▸──  h4     its line, with another colour than what lies below it, at some points along it at least
//!   ──◂──  h5
//! ```
//!
//! What the reference's own drawing hides nobody has to show: the same half-edge, by its place, whatever its number.

use super::beside::Beside;
use super::drawing::Drawing;
use super::eye::Eye;
use super::links::Links;
use super::pairing::span;
use super::placed::Placed;
use super::report::{Difference, Kind, Layer, Spot, counted, listed};
use crate::ids::HalfEdgeId;
use crate::plane::Point;
use std::collections::BTreeSet;

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

/// What a file declares and hides, unless the reference hides the same. `placed` are the two declared structures.
pub(super) fn compare([reference, student]: [&Drawing; 2], placed: Option<[&Placed<'_>; 2]>) -> Option<Difference> {
    let mut hidden = unseen(student);
    if hidden.is_empty() {
        return None;
    }
    let excused: BTreeSet<HalfEdgeId> = unseen(reference).iter().filter_map(|name| name.parse().ok()).collect();
    if let Some([expected, found]) = placed.filter(|_| !excused.is_empty()) {
        let links = Links::new(expected, found, &expected.matched(found));
        let partner = |name: &String| links.expected(name.parse().ok()?);
        hidden.retain(|name| partner(name).is_none_or(|h| !excused.contains(&h)));
    }
    if hidden.is_empty() {
        return None;
    }
    let what =
        counted(hidden.len(), "half-edge is declared and cannot be seen", "half-edges are declared and cannot be seen");
    let text = format!("{what}: {}", listed(&hidden));
    Some(Difference::new(Kind::HalfEdge, Layer::Drawn, text, Spot::Nowhere))
}
