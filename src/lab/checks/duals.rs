//! What is wrong with the dual of a structure, places aside: it has a vertex for each face, a face for each vertex, and
//! crosses each half-edge.

use super::faults::named;
use crate::answers::Wrong;
use dcel_kit::topology::{Table, View};
use dcel_kit::{FaceId, HalfEdgeId, VertexId};
use std::fmt::Display;

/// What is wrong with a field of a half-edge.
#[must_use]
pub fn field<T: Display + PartialEq>(name: &str, h: HalfEdgeId, own: Option<T>, expected: Option<T>) -> Option<Wrong> {
    let because = |own, expected| format!("the {name} of its {h} is {}, expected {}", named(own), named(expected));
    (own != expected).then(|| Wrong::because(name, because(own, expected)))
}

/// What is wrong with the numbers of elements.
#[must_use]
pub fn counts(table: &Table, dual: &Table) -> Option<Wrong> {
    let counts = [
        ("vertices", dual.vertices.len(), table.faces.len(), "one for each face"),
        ("half-edges", dual.half_edges.len(), table.half_edges.len(), "one for each half-edge"),
        ("faces", dual.faces.len(), table.vertices.len(), "one for each vertex"),
    ];
    let (name, own, expected, why) = counts.into_iter().find(|(_, own, expected, _)| own != expected)?;
    Some(Wrong::because(name, format!("it has {own} {name}, expected {expected}: {why}")))
}

/// What is wrong with a half-edge, next and prev aside: it runs from the face on the right of that which it crosses to the
/// one on its left, with the origin of that on its left.
#[must_use]
pub fn crossing(table: &Table, dual: &Table, h: HalfEdgeId) -> Option<Wrong> {
    let twin = table.twin(h);
    let right = twin.and_then(|twin| table.face(twin)).map(|f| VertexId::new(f.number()));
    let left = table.origin(h).map(|v| FaceId::new(v.number()));
    let origin = field("origin", h, dual.origin(h), right);
    origin.or_else(|| field("twin", h, dual.twin(h), twin)).or_else(|| field("face", h, dual.face(h), left))
}

/// What is wrong with the half-edges that vertices and faces know: each vertex has one that starts there, each face one
/// that has it on its left. `of` begins the name of an element.
#[must_use]
pub fn representatives(of: &str, table: &Table) -> Option<Wrong> {
    let is_gone = |h: Option<HalfEdgeId>| h.is_some_and(|h| table.half_edges.get(h.index()) == Some(&None));
    for (v, row) in (0..).map(VertexId::new).zip(&table.vertices) {
        let own = row.as_ref().and_then(|row| row.outgoing);
        if own.and_then(|h| table.origin(h)) != Some(v) {
            let why = if is_gone(own) { "was removed" } else { "does not start there" };
            let because = format!("the outgoing half-edge of {of}{v} is {}, which {why}", named(own));
            return Some(Wrong::because("outgoing", because));
        }
    }
    for (f, row) in (0..).map(FaceId::new).zip(&table.faces) {
        let Some(row) = row else { continue };
        if row.half_edge.and_then(|h| table.face(h)) != Some(f) {
            let why = if is_gone(row.half_edge) { "was removed" } else { "has another face" };
            let because = format!("the incident half-edge of {of}{f} is {}, which {why}", named(row.half_edge));
            return Some(Wrong::because("boundary", because));
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;
    use dcel_kit::topology::Dcel;

    /// A half-edge that is gone is called so, and one that belongs elsewhere is not.
    #[test]
    fn a_representative_is_told_to_be_gone_or_to_be_elsewhere() {
        let mut dcel = Dcel::polygon(4).unwrap();
        let (cut, _) = dcel.split_face(HalfEdgeId::new(0), HalfEdgeId::new(4)).unwrap();
        dcel.join_faces(cut).unwrap();
        let right = Table::from_view(&dcel);
        assert_eq!(representatives("", &right), None);
        assert_eq!(right.half_edges.get(cut.index()), Some(&None), "the cut is a gap in the numbers");
        let elsewhere = (0..8)
            .map(HalfEdgeId::new)
            .find(|&h| right.origin(h) != Some(VertexId::new(0)) && right.face(h) != Some(FaceId::new(1)));
        for (own, why) in [(Some(cut), "which was removed"), (elsewhere, "which does not start there")] {
            let mut wrong = right.clone();
            wrong.vertices[0].as_mut().unwrap().outgoing = own;
            let said = representatives("", &wrong).unwrap();
            assert!(said.because.ends_with(why), "{}", said.because);
        }
        for (own, why) in [(Some(cut), "which was removed"), (elsewhere, "which has another face")] {
            let mut wrong = right.clone();
            wrong.faces[1].as_mut().unwrap().half_edge = own;
            let said = representatives("", &wrong).unwrap();
            assert!(said.because.ends_with(why), "{}", said.because);
        }
    }
}
