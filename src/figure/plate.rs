//! A placed structure: laid out once, drawn as often as need be.
//!
//! ```text
//!   Plate::new(view, options, labels clear of arrows?)     scale, discs, shafts, labels: placed once
//!        │
//!        ├─ nodes(view, look, pointers)     faces, edges, half-edges, POINTERS, vertices in this order
//!        ├─ nodes(view, other look, ...)    the same places, other marks, other ids
//!        └─ arrow(view, pointer)            one pointer as an arrow (`arrows.rs`)
//! ```
//!
//! A [`Look`] says for every element whether it is plain, dimmed, highlighted, new, gone or hidden, and what
//! stands before its name in the ids, so that several drawings of one plate can stand in one document. The view
//! that is drawn need not be the view that was placed: a frame of a film is placed by the union of all frames,
//! and drawn with the pointers it has. Elements without a place are left out; a face label stays where the
//! plate put it as long as it stands inside its face.

use super::captions::Label;
use super::crowd::{Crowd, Shape};
use super::faces::{Region, regions};
use super::half_edges::{Shaft, shafts};
use super::labels::{Labels, Stage};
use super::scene::{Attributes, Group, Node, Polylines, tenths};
use super::skeleton::{Cycles, Skeleton, half_edges, mutual_twin, vertices};
use super::structure::{Notes, Picture};
use super::vertices::radii;
use super::{Detail, FigureError, FigureOptions, number};
use crate::ids::{FaceId, FaceMap, HalfEdgeId, HalfEdgeMap, Id, VertexId, VertexMap};
use crate::plane::PlanarView;

/// How an element is shown.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub(super) enum Mark {
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
    pub(super) fn class(self) -> &'static str {
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
#[derive(Clone, Debug)]
pub(super) struct Look {
    instance: String,
    data: bool,
    rest: Mark,
    vertices: VertexMap<Option<Mark>>,
    half_edges: HalfEdgeMap<Option<Mark>>,
    faces: FaceMap<Option<Mark>>,
}

impl Default for Look {
    fn default() -> Self {
        Self {
            instance: String::new(),
            data: true,
            rest: Mark::Plain,
            vertices: VertexMap::default(),
            half_edges: HalfEdgeMap::default(),
            faces: FaceMap::default(),
        }
    }
}

impl Look {
    /// A drawing among others: ids read `FIG-instance-h5`; elements have neither `data-*` pointers nor tooltips.
    pub(super) fn instance(name: &str) -> Self {
        Self { instance: format!("{name}-"), data: false, ..Self::default() }
    }

    /// The mark of half-edges that have none of their own. Faces are never dimmed with the rest, their tints
    /// are pale anyway; nor are vertices, the landmarks.
    pub(super) fn rest(self, rest: Mark) -> Self {
        Self { rest, ..self }
    }

    pub(super) fn mark_vertex(&mut self, v: VertexId, mark: Mark) {
        self.vertices.set(v, Some(mark), None);
    }

    pub(super) fn mark_half_edge(&mut self, h: HalfEdgeId, mark: Mark) {
        self.half_edges.set(h, Some(mark), None);
    }

    pub(super) fn mark_face(&mut self, f: FaceId, mark: Mark) {
        self.faces.set(f, Some(mark), None);
    }

    pub(super) fn vertex(&self, v: VertexId) -> Mark {
        self.vertices.get(v).copied().flatten().unwrap_or_default()
    }

    pub(super) fn half_edge(&self, h: HalfEdgeId) -> Mark {
        self.half_edges.get(h).copied().flatten().unwrap_or(self.rest)
    }

    pub(super) fn face(&self, f: FaceId) -> Mark {
        self.faces.get(f).copied().flatten().unwrap_or_default()
    }

    /// What stands in an id after the prefix of the figure.
    pub(super) fn id<I: Id>(&self, element: I) -> String {
        self.name(&element.to_string())
    }

    /// The same for any name.
    pub(super) fn name(&self, name: &str) -> String {
        format!("{}{name}", self.instance)
    }

    /// The tooltip of an element.
    pub(super) fn title(&self, title: String) -> Option<String> {
        self.data.then_some(title)
    }

    pub(super) fn attributes(&self, attributes: Attributes) -> Attributes {
        if self.data { attributes } else { Vec::new() }
    }
}

/// A structure whose every line, disc and label has its place.
pub(super) struct Plate<'a, V: ?Sized> {
    pub(super) picture: Picture<'a, V>,
    pub(super) radii: VertexMap<f64>,
    pub(super) shafts: HalfEdgeMap<Option<Shaft>>,
    pub(super) labels: Labels,
    /// Edges, shafts, discs, labels and the ink the labels had to avoid.
    pub(super) crowd: Crowd,
    pub(super) notes: Notes,
    regions: Vec<Region>,
    open: Vec<FaceId>,
}

impl<'a, V: PlanarView + ?Sized> Plate<'a, V> {
    /// Places a view. `options` are checked ones; their detail should be `Edges` at least. With `arrows`,
    /// labels keep clear of all pointer arrows. O(n log n).
    ///
    /// # Errors
    /// Those of [`structure`](super::structure()).
    pub(super) fn new(view: &'a V, options: &'a FigureOptions, arrows: bool) -> Result<Self, FigureError> {
        let (picture, notes) = Picture::new(view, options)?;
        let first = Self::place(picture, notes, &[]);
        if !arrows {
            return Ok(first);
        }
        let ink = first.local_ink();
        Ok(Self::place(first.picture, first.notes, &ink))
    }

    /// Places a picture; labels keep clear of `ink`.
    pub(super) fn place(picture: Picture<'a, V>, mut notes: Notes, ink: &[Shape]) -> Self {
        let Picture { view, options, ref skeleton, fit, detail } = picture;
        let cycles = Cycles::of(view, super::skeleton::faces(view));
        notes.add("with a boundary that does not close or is taken already", cycles.open.iter().copied());
        // A picture that is placed for the second time has said so before.
        notes.0.dedup();
        let regions = regions(view, skeleton, &cycles);
        let mut edges = Crowd::new(fit.size);
        for &h in &skeleton.edges {
            if let Some((a, b)) = skeleton.segment(h) {
                edges.add(Shape::Segment(a, b, 0.0), h.number());
            }
        }
        let (radii, shafts) = if detail >= Detail::Arrows {
            let radii = radii(view, skeleton, &edges, fit.size, &options.style);
            let shafts = shafts(view, skeleton, &radii, &edges, &options.style);
            (radii, shafts)
        } else {
            let radii = VertexMap::filled(view.vertex_bound(), super::vertices::SMALLEST);
            (radii, HalfEdgeMap::filled(view.half_edge_bound(), None))
        };
        let (size, regions_of, open) = (fit.size, &regions, cycles.open);
        let stage =
            Stage { view, options, detail, size, skeleton, radii: &radii, shafts: &shafts, regions: regions_of, ink };
        let (labels, crowd) = stage.labels();
        Self { picture, radii, shafts, labels, crowd, notes, regions, open }
    }

    /// Faces, edges, half-edges, `pointers` and vertices of the placed view itself, or of another one whose
    /// elements have places here.
    pub(super) fn nodes<W: PlanarView + ?Sized>(&self, view: &W, look: &Look, pointers: Vec<Node>) -> Vec<Node> {
        let mut nodes = self.areas(view, look);
        nodes.extend(self.lines(view, look, pointers));
        nodes
    }

    /// The faces alone.
    pub(super) fn areas<W: PlanarView + ?Sized>(&self, view: &W, look: &Look) -> Vec<Node> {
        let Picture { options, ref skeleton, fit, detail, .. } = self.picture;
        if std::ptr::addr_eq(view, self.picture.view) {
            let labels = &self.labels;
            self.picture.face_nodes(&self.regions, &labels.faces, labels.outer.as_ref(), &self.open, look)
        } else {
            let frame = Picture { view, options, skeleton: skeleton.clone(), fit, detail };
            let cycles = Cycles::of(view, super::skeleton::faces(view));
            let regions = regions(view, skeleton, &cycles);
            let labels: Vec<Option<Label>> = regions.iter().map(|region| self.face_label(region)).collect();
            frame.face_nodes(&regions, &labels, self.labels.outer.as_ref(), &cycles.open, look)
        }
    }

    /// Everything but the faces.
    pub(super) fn lines<W: PlanarView + ?Sized>(&self, view: &W, look: &Look, pointers: Vec<Node>) -> Vec<Node> {
        let detail = self.picture.detail;
        let mut nodes = vec![Node::Group(self.edge_group(look))];
        if detail >= Detail::Arrows {
            let shown = half_edges(view).filter(|&h| look.half_edge(h) != Mark::Hidden);
            nodes.extend(shown.map(|h| Node::Group(self.half_edge_group(view, h, look))));
        }
        nodes.extend(pointers);
        let shown = vertices(view).filter(|&v| look.vertex(v) != Mark::Hidden);
        nodes.extend(shown.map(|v| Node::Group(self.vertex_group(view, v, look))));
        if std::ptr::addr_eq(view, self.picture.view) {
            let leaders = self.labels.leaders.iter().map(|(i, leader)| (self.regions[*i].face, leader));
            let shown = leaders.filter(|(face, _)| look.face(*face) != Mark::Hidden);
            nodes.extend(shown.map(|(face, leader)| leader.group(look.name(&format!("{face}-label")))));
        }
        nodes
    }

    /// The label of a face.
    pub(super) fn label_of_face(&self, face: FaceId) -> Option<&Label> {
        if self.picture.view.outer_face() == Some(face) {
            return self.labels.outer.as_ref();
        }
        let i = self.regions.binary_search_by_key(&face, |region| region.face).ok()?;
        self.labels.faces[i].as_ref()
    }

    /// The label of the face if it stands in this region.
    fn face_label(&self, region: &Region) -> Option<Label> {
        let label = self.label_of_face(region.face)?;
        (region.contains(label.at) && region.is_clear(&label.bounds())).then(|| label.clone())
    }

    /// The half-edge or its twin, whichever is shown, decides about the edge. Among other drawings the edges are one
    /// path, which is much shorter.
    fn edge_group(&self, look: &Look) -> Group {
        let Picture { view, ref skeleton, .. } = self.picture;
        let segment = |&h: &HalfEdgeId| {
            let halves = [Some(h), mutual_twin(view, h)];
            halves.iter().flatten().find(|&&half| look.half_edge(half) != Mark::Hidden)?;
            skeleton.segment(h)
        };
        let shown = skeleton.edges.iter().filter_map(segment);
        let nodes = if look.data {
            shown.map(|(from, to)| Node::Line { class: "edge", from, to }).collect()
        } else {
            let mut lines = Polylines::new(false);
            for (from, to) in shown {
                lines.start(tenths(from));
                lines.line_to(tenths(to));
            }
            vec![Node::Fine { class: "edge", hatch: None, lines }]
        };
        Group { class: "edges", nodes, ..Group::default() }
    }

    fn half_edge_group<W: PlanarView + ?Sized>(&self, view: &W, h: HalfEdgeId, look: &Look) -> Group {
        let pointers = [
            ("data-origin", name(view.origin(h))),
            ("data-twin", name(view.twin(h))),
            ("data-next", name(view.next(h))),
            ("data-prev", name(view.prev(h))),
            ("data-face", name(view.face(h))),
        ];
        let known = |i: usize| pointers[i].1.as_deref().unwrap_or("none");
        let to = name(super::skeleton::destination(view, h));
        let title = format!(
            "{h}: {} to {}, face {}, twin {}, next {}, prev {}",
            known(0),
            to.as_deref().unwrap_or("none"),
            known(4),
            known(1),
            known(2),
            known(3)
        );
        let mut nodes = Vec::new();
        if let Some(shaft) = self.shafts.get(h).and_then(Option::as_ref) {
            let (from, to) = shaft.line();
            nodes.push(Node::Line { class: if shaft.is_thin() { "sh thin" } else { "sh" }, from, to });
            nodes.push(Node::Area { class: "barb", hatch: None, outlines: vec![shaft.barb().to_vec()] });
        }
        let label = self.labels.half_edges.get(h).and_then(Option::as_ref);
        nodes.extend(label.iter().flat_map(|label| label.nodes("hl")));
        let attributes = pointers.into_iter().filter_map(|(key, value)| Some((key, value?))).collect();
        Group {
            class: "he",
            mark: look.half_edge(h).class(),
            id: Some(look.id(h)),
            attributes: look.attributes(attributes),
            title: look.title(title),
            nodes,
            ..Group::default()
        }
    }

    fn vertex_group<W: PlanarView + ?Sized>(&self, view: &W, v: VertexId, look: &Look) -> Group {
        let mut attributes: Attributes = Vec::new();
        let mut nodes = Vec::new();
        let mut place = "no position".to_owned();
        if let (Some(p), Some(centre)) = (view.position(v), self.picture.skeleton.place(v)) {
            let (x, y) = (number::model(p.x), number::model(p.y));
            place = format!("({x}, {y})");
            attributes.extend([("data-x", x), ("data-y", y)]);
            let class = if self.picture.detail >= Detail::Arrows { "vd" } else { "dot" };
            nodes.push(Node::Disc { class, centre, radius: self.radii[v] });
        }
        let outgoing = name(view.outgoing(v));
        let title = format!("{v}: {place}, outgoing {}", outgoing.as_deref().unwrap_or("none"));
        attributes.extend(outgoing.map(|h| ("data-he", h)));
        let label = self.labels.vertices.get(v).and_then(Option::as_ref);
        nodes.extend(label.iter().flat_map(|label| label.nodes("vl")));
        Group {
            class: "v",
            mark: look.vertex(v).class(),
            id: Some(look.id(v)),
            attributes: look.attributes(attributes),
            title: look.title(title),
            nodes,
            ..Group::default()
        }
    }

    pub(super) fn skeleton(&self) -> &Skeleton {
        &self.picture.skeleton
    }
}

fn name<I: Id>(id: Option<I>) -> Option<String> {
    id.map(|id| id.to_string())
}
