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
//! A [`Look`] (`look.rs`) says for every element whether it is plain, dimmed, highlighted, new, gone or hidden, and what
//! stands before its name in the ids, so that several drawings of one plate can stand in one document. The view
//! that is drawn need not be the view that was placed: a frame of a film is placed by the union of all frames,
//! and drawn with the pointers it has. Elements without a place are left out; a face label stays where the
//! plate put it as long as it stands inside its face.

use crate::figure::canvas::number;
use crate::figure::canvas::scene::{Attributes, Group, Node, Polylines, tenths};
use crate::figure::layout::crowd::{Crowd, Shape};
use crate::figure::structure::captions::Label;
use crate::figure::structure::faces::{Region, regions};
use crate::figure::structure::half_edges::{Shaft, shafts};
use crate::figure::structure::labels::{Labels, Stage};
use crate::figure::structure::look::{Look, Mark};
use crate::figure::structure::notes::Notes;
use crate::figure::structure::picture::Picture;
use crate::figure::structure::skeleton::{Cycles, Skeleton, destination, half_edges, mutual_twin, vertices};
use crate::figure::structure::vertices::radii;
use crate::figure::{Detail, FigureError, FigureOptions};
use crate::ids::{FaceId, HalfEdgeId, HalfEdgeMap, Id, VertexId, VertexMap};
use crate::plane::PlanarView;

/// A structure whose every line, disc and label has its place.
pub(crate) struct Plate<'a, V: ?Sized> {
    pub(crate) picture: Picture<'a, V>,
    pub(crate) radii: VertexMap<f64>,
    pub(crate) shafts: HalfEdgeMap<Option<Shaft>>,
    pub(crate) labels: Labels,
    /// Edges, shafts, discs, labels and the ink the labels had to avoid.
    pub(crate) crowd: Crowd,
    pub(crate) notes: Notes,
    regions: Vec<Region>,
    open: Vec<FaceId>,
}

/// The plate of any planar view.
pub(crate) type DynPlate<'a> = Plate<'a, dyn PlanarView + 'a>;

impl<'a, V: PlanarView + ?Sized> Plate<'a, V> {
    /// Places a view. `options` are checked ones; their detail should be `Edges` at least. With `arrows`,
    /// labels keep clear of all pointer arrows. O(n log n).
    ///
    /// # Errors
    /// Those of [`structure`](crate::figure::structure()).
    pub(crate) fn new(view: &'a V, options: &'a FigureOptions, arrows: bool) -> Result<Self, FigureError> {
        let (picture, notes) = Picture::new(view, options)?;
        let first = Self::place(picture, notes, &[]);
        if !arrows {
            return Ok(first);
        }
        let ink = first.local_ink();
        Ok(Self::place(first.picture, first.notes, &ink))
    }

    /// Places a picture; labels keep clear of `ink`.
    pub(crate) fn place(picture: Picture<'a, V>, mut notes: Notes, ink: &[Shape]) -> Self {
        let Picture { view, options, ref skeleton, fit, detail } = picture;
        let cycles = Cycles::of(view, crate::figure::structure::skeleton::faces(view));
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
            let radii = VertexMap::filled(view.vertex_bound(), crate::figure::structure::vertices::SMALLEST);
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
    pub(crate) fn nodes<W: PlanarView + ?Sized>(&self, view: &W, look: &Look, pointers: Vec<Node>) -> Vec<Node> {
        let mut nodes = self.areas(view, look);
        nodes.extend(self.lines(view, look, pointers));
        nodes
    }

    /// The faces alone.
    pub(crate) fn areas<W: PlanarView + ?Sized>(&self, view: &W, look: &Look) -> Vec<Node> {
        let Picture { options, ref skeleton, fit, detail, .. } = self.picture;
        if std::ptr::addr_eq(view, self.picture.view) {
            let labels = &self.labels;
            self.picture.face_nodes(&self.regions, &labels.faces, labels.outer.as_ref(), &self.open, look)
        } else {
            let frame = Picture { view, options, skeleton: skeleton.clone(), fit, detail };
            let cycles = Cycles::of(view, crate::figure::structure::skeleton::faces(view));
            let regions = regions(view, skeleton, &cycles);
            let labels: Vec<Option<Label>> = regions.iter().map(|region| self.face_label(region)).collect();
            frame.face_nodes(&regions, &labels, self.labels.outer.as_ref(), &cycles.open, look)
        }
    }

    /// Everything but the faces.
    pub(crate) fn lines<W: PlanarView + ?Sized>(&self, view: &W, look: &Look, pointers: Vec<Node>) -> Vec<Node> {
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
    pub(crate) fn label_of_face(&self, face: FaceId) -> Option<&Label> {
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
        let nodes = if look.is_alone() {
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
        let known = |name: &Option<String>| name.clone().unwrap_or_else(|| "none".to_owned());
        let [origin, twin, next, prev, face] = pointers.each_ref().map(|(_, name)| known(name));
        let to = known(&name(destination(view, h)));
        let title = format!("{h}: {origin} to {to}, face {face}, twin {twin}, next {next}, prev {prev}");
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

    pub(crate) fn skeleton(&self) -> &Skeleton {
        &self.picture.skeleton
    }
}

fn name<I: Id>(id: Option<I>) -> Option<String> {
    id.map(|id| id.to_string())
}
