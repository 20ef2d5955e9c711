//! Writing the changes of an edit into a table, one by one: half-linked structures as the edit sees them.
//!
//! ```text
//!   new e6 = (h12, h13)      two rows, twins of each other, nothing else set
//!   h12.next: none -> h8     one field of one row
//!   removed e6               two rows less
//! ```

use super::record::{Change, Slot};
use super::table::{FaceRow, HalfEdgeRow, Table, VertexRow};
use crate::ids::{Element, FaceId, HalfEdgeId, VertexId};

impl Table {
    /// Writes one change into the table. New rows grow the table; a new vertex has no position yet. A pointer of
    /// a row that does not exist is not written. O(1), but for the growing.
    pub fn apply(&mut self, change: &Change) {
        match *change {
            Change::Write { slot, new, .. } => self.write(slot, new),
            Change::Added { element, .. } => self.set_rows(element, true),
            Change::Removed { element } => self.set_rows(element, false),
        }
    }

    fn set_rows(&mut self, element: Element, live: bool) {
        match element {
            Element::Vertex(v) => set_row(&mut self.vertices, v.index(), live.then(VertexRow::default)),
            Element::Face(f) => set_row(&mut self.faces, f.index(), live.then(FaceRow::default)),
            Element::Edge(e) => {
                for h in e.half_edges() {
                    let row = HalfEdgeRow { twin: Some(h.twin()), ..HalfEdgeRow::default() };
                    set_row(&mut self.half_edges, h.index(), live.then_some(row));
                }
            }
            Element::HalfEdge(_) => {}
        }
    }

    fn write(&mut self, slot: Slot, new: Option<Element>) {
        let half_edge = new.and_then(HalfEdgeId::from_element);
        match slot {
            Slot::Outgoing(v) => {
                if let Some(Some(row)) = self.vertices.get_mut(v.index()) {
                    row.outgoing = half_edge;
                }
            }
            Slot::HalfEdge(f) => {
                if let Some(Some(row)) = self.faces.get_mut(f.index()) {
                    row.half_edge = half_edge;
                }
            }
            Slot::Origin(h) | Slot::Next(h) | Slot::Prev(h) | Slot::Face(h) => {
                let Some(Some(row)) = self.half_edges.get_mut(h.index()) else { return };
                match slot {
                    Slot::Origin(_) => row.origin = new.and_then(VertexId::from_element),
                    Slot::Face(_) => row.face = new.and_then(FaceId::from_element),
                    Slot::Next(_) => row.next = half_edge,
                    _ => row.prev = half_edge,
                }
            }
        }
    }
}

/// Sets or takes out a row; the ones before it are there, if only empty.
pub(crate) fn set_row<T>(rows: &mut Vec<Option<T>>, index: usize, row: Option<T>) {
    if index >= rows.len() {
        rows.resize_with(index + 1, || None);
    }
    rows[index] = row;
}
