//! The pointers of a structure that differ from those expected, up to the numbers of the new elements.
//!
//! ```text
//!   expected           yours                 every way to pair the new ones is tried, and the one that leaves
//!   h12, h13 new       h12, h13 new          the fewest differences speaks: h5.next = h4, expected h13
//! ```
//!
//! Cost: O(n) for each pairing; there are at most two ways for a split of a face, and four for one of an edge.

use crate::cases::numbers::renumbered;
use dcel_kit::topology::{HalfEdgeRow, Table, VertexRow, View};
use dcel_kit::{Element, FaceId, HalfEdgeId, VertexId};
use std::fmt;

/// The new elements that a call should make, by the numbers that they have in the structure that is expected.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct New {
    /// The new half-edges, in an order that the judge knows.
    pub half_edges: Vec<HalfEdgeId>,
    /// The new vertices.
    pub vertices: Vec<VertexId>,
    /// The new faces.
    pub faces: Vec<FaceId>,
}

dcel_kit::named! {
    /// A pointer of a record, or another of its fields.
    #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
    pub enum Field {
        /// Where a half-edge starts.
        Origin = "origin",
        /// The other half.
        Twin = "twin",
        /// The half-edge after it.
        Next = "next",
        /// The half-edge before it.
        Prev = "prev",
        /// The face on its left.
        Face = "face",
        /// A half-edge that starts at a vertex.
        Outgoing = "outgoing",
        /// Where a vertex is.
        Position = "position",
        /// A half-edge of a face.
        Boundary = "half_edge",
        /// Which face is the outer one.
        OuterFace = "outer_face",
    }

    /// Its name in the protocol.
    fn word;
}

/// A field that is not as it should be. Elements are named as in the student's structure.
#[derive(Clone, PartialEq, Debug)]
pub struct Difference {
    /// Whose field; `None` for the outer face of the whole.
    pub owner: Option<Element>,
    /// Which one.
    pub field: Field,
    /// What stands there.
    pub found: Content,
    /// What should stand there; for representatives one of those that would do.
    pub expected: Content,
}

/// What stands in a field.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Content {
    /// Nothing.
    Unset,
    /// An element.
    To(Element),
    /// A place.
    At([f64; 2]),
}

impl Content {
    fn to<I: Into<Element>>(id: Option<I>) -> Self {
        id.map_or(Self::Unset, |id| Self::To(id.into()))
    }

    /// What stands in a field of a structure; nothing if there is no such element.
    #[must_use]
    pub fn of(table: &Table, owner: Option<Element>, field: Field) -> Self {
        match (owner, field) {
            (Some(Element::HalfEdge(h)), _) => {
                let row = half_edge_row(table, h);
                match field {
                    Field::Origin => Self::to(row.origin),
                    Field::Twin => Self::to(row.twin),
                    Field::Next => Self::to(row.next),
                    Field::Prev => Self::to(row.prev),
                    Field::Face => Self::to(row.face),
                    _ => Self::Unset,
                }
            }
            (Some(Element::Vertex(v)), Field::Outgoing) => Self::to(vertex_row(table, v).outgoing),
            (Some(Element::Vertex(v)), Field::Position) => vertex_row(table, v).position.map_or(Self::Unset, Self::At),
            (Some(Element::Face(f)), Field::Boundary) => Self::to(table.half_edge(f)),
            (None, Field::OuterFace) => Self::to(table.outer_face),
            _ => Self::Unset,
        }
    }
}

impl fmt::Display for Content {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unset => f.write_str("unset"),
            Self::To(element) => element.fmt(f),
            Self::At([x, y]) => write!(f, "({x}, {y})"),
        }
    }
}

impl Difference {
    /// The name of the field with that of its owner: `h7.prev`.
    #[must_use]
    pub fn name(&self) -> String {
        let owner = self.owner.map_or_else(String::new, |owner| format!("{owner}."));
        format!("{owner}{}", self.field.word())
    }
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} is {}, expected {}", self.name(), self.found, self.expected)
    }
}

/// An expected structure in the numbers of the student's.
#[derive(Clone, PartialEq, Debug)]
pub struct Aligned {
    /// What the structure should be.
    pub expected: Table,
    /// The new elements, in the order of the specification.
    pub new: New,
    /// The fields that differ; empty if all is right.
    pub differences: Vec<Difference>,
}

/// Compares a structure with what is expected, in the numbering of the new elements that fits best.
///
/// `yours` must have as many elements of each kind as `expected`. Representatives are right if they name any
/// half-edge that may stand for the vertex or face.
#[must_use]
pub fn align(expected: &Table, new: &New, yours: &Table) -> Aligned {
    let mut best: Option<Aligned> = None;
    let mut orders = vec![new.half_edges.clone()];
    if let [a, b] = new.half_edges[..] {
        orders.push(vec![b, a]);
    }
    for order in orders {
        let name = |h| new.half_edges.iter().position(|&f| f == h).map_or(h, |i| order[i]);
        let renamed = renumbered(expected, |v| v, name, |f| f);
        let differences = differences(&renamed, yours);
        if differences.is_empty() {
            return Aligned { expected: renamed, new: New { half_edges: order, ..new.clone() }, differences };
        }
        if best.as_ref().is_none_or(|best| differences.len() < best.differences.len()) {
            let new = New { half_edges: order, ..new.clone() };
            best = Some(Aligned { expected: renamed, new, differences });
        }
    }
    best.unwrap_or_else(|| Aligned { expected: expected.clone(), new: new.clone(), differences: Vec::new() })
}

/// The fields that differ between two tables with the same elements, half-edges first.
#[must_use]
pub fn differences(expected: &Table, yours: &Table) -> Vec<Difference> {
    let mut out = Vec::new();
    let mut add = |owner: Option<Element>, field| {
        let [found, expected] = [yours, expected].map(|table| Content::of(table, owner, field));
        if found != expected {
            out.push(Difference { owner, field, found, expected });
        }
    };
    for i in 0..expected.half_edges.len().max(yours.half_edges.len()) {
        let h = HalfEdgeId::new(i as u32);
        for field in [Field::Origin, Field::Twin, Field::Next, Field::Prev, Field::Face] {
            add(Some(h.into()), field);
        }
    }
    for i in 0..expected.vertices.len().max(yours.vertices.len()) {
        let v = VertexId::new(i as u32);
        add(Some(v.into()), Field::Position);
        let [e, y] = [expected, yours].map(|table| vertex_row(table, v).outgoing);
        if !y.map_or(e.is_none(), |h| expected.origin(h) == Some(v)) {
            add(Some(v.into()), Field::Outgoing);
        }
    }
    for i in 0..expected.faces.len().max(yours.faces.len()) {
        let f = FaceId::new(i as u32);
        let [e, y] = [expected, yours].map(|table| table.half_edge(f));
        if !y.map_or(e.is_none(), |h| expected.face(h) == Some(f)) {
            add(Some(f.into()), Field::Boundary);
        }
    }
    add(None, Field::OuterFace);
    out
}

/// The row of a half-edge; an empty one if there is none.
#[must_use]
pub fn half_edge_row(table: &Table, h: HalfEdgeId) -> HalfEdgeRow {
    table.half_edges.get(h.index()).copied().flatten().unwrap_or_default()
}

fn vertex_row(table: &Table, v: VertexId) -> VertexRow {
    table.vertices.get(v.index()).copied().flatten().unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;
    use dcel_kit::topology::Dcel;

    /// Each field of a half-edge is looked up as itself: the five of a half-edge in a triangle all differ.
    #[test]
    fn a_field_has_the_content_of_its_own_column() {
        let table = Table::from_view(&Dcel::polygon(3).unwrap());
        let h = HalfEdgeId::new(2);
        let shown = |field: Field| Content::of(&table, Some(h.into()), field).to_string();
        let row = table.half_edges[2].unwrap();
        assert_eq!(shown(Field::Origin), row.origin.unwrap().to_string());
        assert_eq!(shown(Field::Twin), table.twin(h).unwrap().to_string());
        assert_eq!(shown(Field::Next), row.next.unwrap().to_string());
        assert_eq!(shown(Field::Prev), row.prev.unwrap().to_string());
        assert_eq!(shown(Field::Face), row.face.unwrap().to_string());
        let all = [Field::Origin, Field::Twin, Field::Next, Field::Prev, Field::Face].map(shown);
        assert!((0..5).all(|i| all[i + 1..].iter().all(|other| *other != all[i])), "{all:?}");
    }
}
