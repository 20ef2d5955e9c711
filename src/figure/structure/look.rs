//! How the elements of one drawing look: plain, dimmed, highlighted, new, gone or hidden.

use crate::figure::canvas::scene::Attributes;
use crate::ids::{Element, FaceId, FaceMap, HalfEdgeId, HalfEdgeMap, Id, VertexId, VertexMap};

/// How an element is shown.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub(crate) enum Mark {
    /// As in the structure figure.
    #[default]
    Plain,
    /// Grey: not what the drawing is about.
    Dim,
    /// Bold: what the drawing is about.
    Hot,
    /// It has just come.
    New,
    /// It has just gone.
    Gone,
    /// Not at all.
    Hidden,
}

impl Mark {
    /// The class beside that of the element.
    pub(crate) fn class(self) -> &'static str {
        match self {
            Self::Plain | Self::Hidden => "",
            Self::Dim => "dim",
            Self::Hot => "hot",
            Self::New => "made",
            Self::Gone => "gone",
        }
    }
}

/// How one drawing of a plate looks.
#[derive(Clone, Debug, Default)]
pub(crate) struct Look {
    instance: String,
    rest: Mark,
    vertices: VertexMap<Option<Mark>>,
    half_edges: HalfEdgeMap<Option<Mark>>,
    faces: FaceMap<Option<Mark>>,
}

impl Look {
    /// A drawing among others: ids read `FIG-instance-h5`; elements have neither `data-*` pointers nor tooltips.
    pub(crate) fn instance(name: &str) -> Self {
        Self { instance: format!("{name}-"), ..Self::default() }
    }

    /// The mark of half-edges that have none of their own. Faces are never dimmed with the rest, their tints
    /// are pale anyway; nor are vertices, the landmarks.
    pub(crate) fn rest(self, rest: Mark) -> Self {
        Self { rest, ..self }
    }

    /// Marks an element; an edge by both of its half-edges.
    pub(crate) fn mark(&mut self, element: Element, mark: Mark) {
        match element {
            Element::Vertex(v) => self.mark_vertex(v, mark),
            Element::HalfEdge(h) => self.mark_half_edge(h, mark),
            Element::Edge(e) => e.half_edges().into_iter().for_each(|h| self.mark_half_edge(h, mark)),
            Element::Face(f) => self.mark_face(f, mark),
        }
    }

    pub(crate) fn mark_vertex(&mut self, v: VertexId, mark: Mark) {
        self.vertices.set(v, Some(mark), None);
    }

    pub(crate) fn mark_half_edge(&mut self, h: HalfEdgeId, mark: Mark) {
        self.half_edges.set(h, Some(mark), None);
    }

    pub(crate) fn mark_face(&mut self, f: FaceId, mark: Mark) {
        self.faces.set(f, Some(mark), None);
    }

    pub(crate) fn vertex(&self, v: VertexId) -> Mark {
        self.vertices.get(v).copied().flatten().unwrap_or_default()
    }

    pub(crate) fn half_edge(&self, h: HalfEdgeId) -> Mark {
        self.half_edges.get(h).copied().flatten().unwrap_or(self.rest)
    }

    pub(crate) fn face(&self, f: FaceId) -> Mark {
        self.faces.get(f).copied().flatten().unwrap_or_default()
    }

    /// What stands in an id after the prefix of the figure.
    pub(crate) fn id<I: Id>(&self, element: I) -> String {
        self.name(&element.to_string())
    }

    /// The same for any name.
    pub(crate) fn name(&self, name: &str) -> String {
        format!("{}{name}", self.instance)
    }

    /// Whether the drawing stands alone: elements have pointers and tooltips.
    pub(crate) fn is_alone(&self) -> bool {
        self.instance.is_empty()
    }

    /// The tooltip of an element.
    pub(crate) fn title(&self, title: String) -> Option<String> {
        self.is_alone().then_some(title)
    }

    pub(crate) fn attributes(&self, attributes: Attributes) -> Attributes {
        if self.is_alone() { attributes } else { Vec::new() }
    }
}
