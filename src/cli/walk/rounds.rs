//! The walks, as the JSON form of the answer has them.

use super::Subject;
use dcel_kit::topology::{InnerComponent, bounded_cycle};
use dcel_kit::{FaceId, HalfEdgeId, VertexId};
use serde::Serialize;
use std::collections::BTreeSet;

/// An id or nothing.
type Name = Option<String>;

fn name<T: ToString>(id: Option<T>) -> Name {
    id.map(|id| id.to_string())
}

/// A face as seen from somewhere else.
#[derive(Serialize, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct FaceName {
    pub(super) face: String,
    pub(super) name: Name,
}

impl FaceName {
    fn of(subject: &Subject, f: FaceId) -> Self {
        Self { face: f.to_string(), name: subject.name(f).map(str::to_owned) }
    }
}

/// Some faces, mostly one, and what is adjacent to them.
#[derive(Serialize)]
pub(super) struct FaceWalk {
    pub(super) faces: Vec<Face>,
    /// Faces across the edges of the given ones, without these.
    pub(super) adjacent_faces: Vec<FaceName>,
    /// The names of the adjacent faces, without the names of the given ones.
    pub(super) adjacent_names: Vec<String>,
}

#[derive(Serialize)]
pub(super) struct Face {
    pub(super) face: String,
    pub(super) name: Name,
    pub(super) outer: bool,
    pub(super) hole: bool,
    pub(super) cycles: Vec<Cycle>,
    pub(super) isolated_vertices: Vec<Corner>,
}

#[derive(Serialize)]
pub(super) struct Corner {
    pub(super) vertex: String,
    pub(super) position: Option<Vec<f64>>,
}

#[derive(Serialize)]
pub(super) struct Cycle {
    /// Whether it is an inner component: a further cycle of its face, or any cycle of the outer face.
    pub(super) inner: bool,
    /// Whether the walk comes back to its start.
    pub(super) closed: bool,
    pub(super) half_edges: Vec<Step>,
}

/// A half-edge on a walk.
#[derive(Serialize)]
pub(super) struct Step {
    pub(super) half_edge: String,
    pub(super) origin: Name,
    pub(super) position: Option<Vec<f64>>,
    pub(super) destination: Name,
    pub(super) twin: Name,
    /// The face of the twin.
    pub(super) across: Name,
    pub(super) across_name: Name,
}

impl FaceWalk {
    /// O(half-edges of the faces), times a logarithm for the sorting of the neighbours.
    pub(super) fn of(subject: &Subject, faces: &[FaceId]) -> Self {
        let own: BTreeSet<FaceId> = faces.iter().copied().collect();
        let mut adjacent = BTreeSet::new();
        let faces: Vec<Face> = faces.iter().map(|&f| Face::of(subject, f, &mut adjacent)).collect();
        let own_names: BTreeSet<Option<&str>> = own.iter().map(|&f| subject.name(f)).collect();
        let foreign = || adjacent.difference(&own).copied();
        let names: BTreeSet<Option<&str>> = foreign().map(|f| subject.name(f)).collect();
        Self {
            faces,
            adjacent_faces: foreign().map(|f| FaceName::of(subject, f)).collect(),
            adjacent_names: names.difference(&own_names).copied().flatten().map(str::to_owned).collect(),
        }
    }
}

impl Face {
    fn of(subject: &Subject, f: FaceId, adjacent: &mut BTreeSet<FaceId>) -> Self {
        let view = subject.view();
        let outer = view.outer_face() == Some(f);
        let first = view.half_edge(f).map(|h| (h, outer));
        let others = view.inner_components(f).iter().filter_map(|ring| match ring {
            InnerComponent::Cycle(h) => Some((*h, true)),
            InnerComponent::Isolated(_) => None,
        });
        let isolated = view.inner_components(f).iter().filter_map(|ring| match ring {
            InnerComponent::Isolated(v) => Some(*v),
            InnerComponent::Cycle(_) => None,
        });
        Self {
            face: f.to_string(),
            name: subject.name(f).map(str::to_owned),
            outer,
            hole: view.is_hole(f),
            cycles: first.into_iter().chain(others).map(|(h, inner)| Cycle::of(subject, h, inner, adjacent)).collect(),
            isolated_vertices: isolated
                .map(|v| Corner { vertex: v.to_string(), position: subject.position(v) })
                .collect(),
        }
    }
}

impl Cycle {
    fn of(subject: &Subject, start: HalfEdgeId, inner: bool, adjacent: &mut BTreeSet<FaceId>) -> Self {
        let view = subject.view();
        let mut last = None;
        let half_edges = bounded_cycle(view, start)
            .map(|h| {
                last = Some(h);
                let twin = view.twin(h);
                let across = twin.and_then(|t| view.face(t));
                adjacent.extend(across.filter(|&f| view.has_face(f)));
                Step::of(subject, h, across)
            })
            .collect();
        Self { inner, closed: last.and_then(|h| view.next(h)) == Some(start), half_edges }
    }
}

impl Step {
    fn of(subject: &Subject, h: HalfEdgeId, across: Option<FaceId>) -> Self {
        let view = subject.view();
        let twin = view.twin(h);
        let origin = view.origin(h);
        Self {
            half_edge: h.to_string(),
            origin: name(origin),
            position: origin.and_then(|v| subject.position(v)),
            destination: name(twin.and_then(|t| view.origin(t))),
            twin: name(twin),
            across: name(across),
            across_name: across.and_then(|f| subject.name(f)).map(str::to_owned),
        }
    }
}

/// The half-edges that start at a vertex, counter-clockwise.
#[derive(Serialize)]
pub(super) struct Star {
    pub(super) vertex: String,
    pub(super) position: Option<Vec<f64>>,
    pub(super) degree: usize,
    /// Whether the walk round the vertex comes back to its start.
    pub(super) closed: bool,
    /// The face that an isolated vertex lies in.
    pub(super) lies_in: Option<FaceName>,
    pub(super) outgoing: Vec<Spoke>,
}

#[derive(Serialize)]
pub(super) struct Spoke {
    pub(super) half_edge: String,
    pub(super) destination: Name,
    pub(super) position: Option<Vec<f64>>,
    pub(super) twin: Name,
    /// The face on the left, between this half-edge and the next one.
    pub(super) face: Name,
    pub(super) face_name: Name,
}

impl Star {
    /// O(degree), for isolated vertices O(inner components).
    pub(super) fn of(subject: &Subject, v: VertexId) -> Self {
        let view = subject.view();
        let start = view.outgoing(v).filter(|&h| view.has_half_edge(h));
        let ccw = |h: HalfEdgeId| view.prev(h).and_then(|p| view.twin(p)).filter(|&g| view.has_half_edge(g));
        let mut outgoing = Vec::new();
        let mut closed = start.is_none();
        let mut at = start;
        while let Some(h) = at.filter(|_| outgoing.len() < view.half_edge_bound()) {
            outgoing.push(Spoke::of(subject, h));
            at = ccw(h);
            if at == start {
                closed = true;
                break;
            }
        }
        let isolated = InnerComponent::Isolated(v);
        let lies_in = subject.faces().find(|&f| start.is_none() && view.inner_components(f).contains(&isolated));
        Self {
            vertex: v.to_string(),
            position: subject.position(v),
            degree: outgoing.len(),
            closed,
            lies_in: lies_in.map(|f| FaceName::of(subject, f)),
            outgoing,
        }
    }
}

impl Spoke {
    fn of(subject: &Subject, h: HalfEdgeId) -> Self {
        let view = subject.view();
        let twin = view.twin(h);
        let destination = twin.and_then(|t| view.origin(t));
        let face = view.face(h);
        Self {
            half_edge: h.to_string(),
            destination: name(destination),
            position: destination.and_then(|v| subject.position(v)),
            twin: name(twin),
            face: name(face),
            face_name: face.and_then(|f| subject.name(f)).map(str::to_owned),
        }
    }
}

/// The links of a half-edge.
#[derive(Serialize)]
pub(super) struct Links {
    pub(super) half_edge: String,
    pub(super) origin: Name,
    pub(super) origin_position: Option<Vec<f64>>,
    pub(super) destination: Name,
    pub(super) destination_position: Option<Vec<f64>>,
    pub(super) twin: Name,
    pub(super) next: Name,
    pub(super) prev: Name,
    pub(super) face: Name,
    pub(super) face_name: Name,
    /// The pair; nothing if the table pairs its half-edges in another way than h6 with h7.
    pub(super) edge: Name,
}

impl Links {
    pub(super) fn of(subject: &Subject, h: HalfEdgeId) -> Self {
        let view = subject.view();
        let (origin, twin, face) = (view.origin(h), view.twin(h), view.face(h));
        let destination = twin.and_then(|t| view.origin(t));
        Self {
            half_edge: h.to_string(),
            origin: name(origin),
            origin_position: origin.and_then(|v| subject.position(v)),
            destination: name(destination),
            destination_position: destination.and_then(|v| subject.position(v)),
            twin: name(twin),
            next: name(view.next(h)),
            prev: name(view.prev(h)),
            face: name(face),
            face_name: face.and_then(|f| subject.name(f)).map(str::to_owned),
            edge: name(Some(h.edge()).filter(|_| twin == Some(h.twin()))),
        }
    }
}
