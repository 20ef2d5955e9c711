//! What the functions that only read should return, and what is wrong with a list that is another.

use crate::checks::cyclic::{self, WalkFault};
use crate::checks::walks::{cycle, star};
use dcel_kit::topology::{Table, View};
use dcel_kit::{Element, FaceId, HalfEdgeId, VertexId};

/// What a call should return.
pub(super) struct Walk {
    /// The numbers, in order, from any start.
    pub(super) elements: Vec<u32>,
    /// What a number names.
    pub(super) element: fn(u32) -> Element,
    kind: Kind,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    Face,
    Corners,
    Star,
    Destination(HalfEdgeId),
}

/// The right answer to a reading call; `None` for other functions and for elements without pointers.
pub(super) fn expected(table: &Table, function: &str, argument: u32) -> Option<Walk> {
    let half_edge = |n| Element::HalfEdge(HalfEdgeId::new(n));
    let vertex = |n| Element::Vertex(VertexId::new(n));
    let numbers = |walk: Vec<HalfEdgeId>| walk.into_iter().map(HalfEdgeId::number).collect::<Vec<_>>();
    Some(match function {
        "walk_face" => {
            let elements = numbers(cycle(table, table.half_edge(FaceId::new(argument))?));
            Walk { elements, element: half_edge, kind: Kind::Face }
        }
        "walk_vertices" => {
            let walk = cycle(table, table.half_edge(FaceId::new(argument))?);
            let elements = walk.into_iter().filter_map(|h| table.origin(h)).map(VertexId::number).collect();
            Walk { elements, element: vertex, kind: Kind::Corners }
        }
        "walk_vertex" => {
            let elements = numbers(star(table, table.outgoing(VertexId::new(argument))?));
            Walk { elements, element: half_edge, kind: Kind::Star }
        }
        "destination" | "destination_by_next" => {
            let h = HalfEdgeId::new(argument);
            let end = if function == "destination" { table.twin(h)? } else { table.next(h)? };
            let elements = vec![table.origin(end)?.number()];
            Walk { elements, element: vertex, kind: Kind::Destination(h) }
        }
        _ => return None,
    })
}

impl Walk {
    pub(super) fn list(&self, numbers: &[u32]) -> String {
        let names: Vec<String> = numbers.iter().take(12).map(|&n| (self.element)(n).to_string()).collect();
        match numbers.len() {
            0 => "nothing".to_owned(),
            13.. => format!("{} … ({} in all)", names.join(" "), numbers.len()),
            _ => names.join(" "),
        }
    }

    pub(super) fn any_start(&self) -> &'static str {
        if self.elements.len() > 1 { " (from any start)" } else { "" }
    }

    /// What went wrong, more closely than a comparison of lists can say.
    pub(super) fn explain(&self, table: &Table, found: &[u32], wrong: WalkFault) -> (String, String) {
        let twin = |n: u32| table.twin(HalfEdgeId::new(n)).map_or(u32::MAX, HalfEdgeId::number);
        let twins = || self.elements.iter().map(|&n| twin(n)).collect::<Vec<_>>();
        let reversed = |list: &[u32]| list.iter().rev().copied().collect::<Vec<_>>();
        let said = |tag: &str, words: &str| (tag.to_owned(), words.to_owned());
        match self.kind {
            Kind::Face if cyclic::is_rotation(found, &twins()) || cyclic::is_rotation(found, &reversed(&twins())) => {
                said("Twins", "these are the twins, on the other side of the boundary")
            }
            Kind::Star if cyclic::is_rotation(found, &twins()) || cyclic::is_rotation(found, &reversed(&twins())) => {
                said("Incoming", "these end at the vertex; take the ones that start there")
            }
            Kind::Star if matches!(wrong, WalkFault::StopsEarly | WalkFault::OneMissing) => {
                (format!("{wrong:?}"), "the walk round the vertex does not come all the way round".to_owned())
            }
            Kind::Destination(h) if found.len() == 1 && table.origin(h).map(VertexId::number) == Some(found[0]) => {
                said("Origin", "that is the origin")
            }
            Kind::Destination(_) => said("Elsewhere", "the half-edge does not end there"),
            _ => (format!("{wrong:?}"), wrong.to_string()),
        }
    }
}
