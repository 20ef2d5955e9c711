//! A view with its place on the canvas: how large it is drawn, how much of it, its faces, and the document round it.
//!
//! ```text
//!   survey(view) ──▶ choose: scale, level of detail ──▶ place ──▶ Picture
//!                                                                  ├─ face_nodes   one group a face
//!                                                                  ├─ by_tiles     many short edges
//!                                                                  └─ scene        the document
//! ```

use crate::figure::canvas::scene::{Group, Node, Polylines, Scene, tenths};
use crate::figure::canvas::text::LEGIBLE;
use crate::figure::canvas::vector::{Bounds, Xy, xy};
use crate::figure::canvas::{crop, number};
use crate::figure::layout::crowd::{Crowd, Shape};
use crate::figure::layout::fit::{Extent, Fit, Load, choose};
use crate::figure::structure::captions::{Caption, Label, Sizes, captions};
use crate::figure::structure::faces::{Region, attributes, regions, title};
use crate::figure::structure::labels::{lead_out, outer_label};
use crate::figure::structure::look::{Look, Mark};
use crate::figure::structure::notes::Notes;
use crate::figure::structure::skeleton::{Cycles, Skeleton, faces, half_edges, ids, vertices};
use crate::figure::structure::{tiles, tints};
use crate::figure::{Detail, FigureError, FigureOptions};
use crate::ids::{FaceId, HalfEdgeId, VertexId, VertexMap};
use crate::plane::{CoordinateError, LARGEST, PlanarView, Point};

/// With more faces than this, tiles show the domain as one area.
const FACES: usize = 2000;
/// The hatch of the outer face leaves out the mesh, unless its outline has more points than this.
const OUTLINE: usize = 20_000;
/// Width of the free line round the frame.
pub(crate) const MARGIN: f64 = 4.0;
/// The classes of the tinted faces.
const TINTED: [&str; tints::HUES] = ["face t0", "face t1", "face t2", "face t3", "face t4", "face t5", "face t6"];

fn check<V: PlanarView + ?Sized>(view: &V) -> Result<(), FigureError> {
    let mut placed = false;
    for vertex in vertices(view) {
        let Some(p) = view.position(vertex) else { continue };
        placed = true;
        check_point(p).map_err(|error| FigureError::Coordinate { vertex, error })?;
    }
    match vertices(view).next() {
        Some(example) if !placed => Err(FigureError::NoPosition { vertices: vertices(view).count(), example }),
        _ => Ok(()),
    }
}

/// Whether a point can be drawn: one with tiny coordinates can, other than those that exact predicates refuse.
pub(crate) fn check_point(p: Point) -> Result<(), CoordinateError> {
    for (axis, value) in [('x', p.x), ('y', p.y)] {
        if !value.is_finite() {
            return Err(CoordinateError::NotFinite { axis, value });
        } else if value.abs() > LARGEST {
            return Err(CoordinateError::OutOfRange { axis, value });
        }
    }
    Ok(())
}

/// The median length of the edges in units of the plane. `span` is the size of the whole, so that squares
/// neither overflow nor vanish.
fn median<V: PlanarView + ?Sized>(view: &V, skeleton: &Skeleton, span: f64) -> Option<f64> {
    let length = |&h: &HalfEdgeId| {
        let [a, b] = skeleton.ends(h)?;
        let (a, b) = (view.position(a)?, view.position(b)?);
        Some(xy((b.x - a.x) / span, (b.y - a.y) / span).length() * span)
    };
    let mut lengths: Vec<f64> = skeleton.edges.iter().filter_map(length).filter(|l| l.is_finite()).collect();
    if lengths.is_empty() {
        return None;
    }
    let middle = lengths.len() / 2;
    Some(*lengths.select_nth_unstable_by(middle, f64::total_cmp).1)
}

/// A view with its place on the canvas.
pub(crate) struct Picture<'a, V: ?Sized> {
    pub(crate) view: &'a V,
    pub(crate) options: &'a FigureOptions,
    pub(crate) skeleton: Skeleton,
    pub(crate) fit: Fit,
    pub(crate) detail: Detail,
}

/// What is known of a view before its place on the canvas is chosen.
pub(crate) struct Survey {
    skeleton: Skeleton,
    extent: Extent,
    load: Load,
}

impl Survey {
    pub(crate) fn choose(&self, options: &FigureOptions) -> (Fit, Detail) {
        choose(&self.extent, &self.load, options)
    }

    /// Places the view that was surveyed.
    pub(crate) fn place<'a, V: PlanarView + ?Sized>(
        self,
        view: &'a V,
        options: &'a FigureOptions,
        fit: Fit,
        detail: Detail,
    ) -> (Picture<'a, V>, Notes) {
        let mut skeleton = self.skeleton;
        let at = ids::<VertexId>(view.vertex_bound(), |_| true).map(|v| view.position(v).map(|p| fit.place(p)));
        skeleton.at = at.collect::<Vec<_>>().into();
        skeleton.window = options.crop.map(|_| crop::window(fit.size));

        let mut notes = Notes::default();
        notes.add("without a position, not drawn", vertices(view).filter(|&v| view.position(v).is_none()));
        let without_length = half_edges(view).filter(|&h| skeleton.segment(h).is_none_or(|(a, b)| a == b));
        notes.add("with an unknown end or without length, not drawn", without_length);
        (Picture { view, options, skeleton, fit, detail }, notes)
    }
}

impl<'a, V: PlanarView + ?Sized> Picture<'a, V> {
    /// Chooses scale and detail. `options` are checked ones.
    pub(crate) fn new(view: &'a V, options: &'a FigureOptions) -> Result<(Self, Notes), FigureError> {
        let survey = Self::survey(view, options, Vec::new())?;
        let (fit, detail) = survey.choose(options);
        Ok(survey.place(view, options, fit, detail))
    }

    /// Looks at a view that is to be drawn in one picture with some points.
    pub(crate) fn survey(view: &V, options: &FigureOptions, points: Vec<Point>) -> Result<Survey, FigureError> {
        check(view)?;
        let skeleton = Skeleton::new(view);
        let placed = vertices(view).filter_map(|v| view.position(v));
        let extent = match options.crop {
            Some(corners) => Extent::of(corners),
            None => Extent::of(placed.chain(points).chain(options.reach.iter().copied())),
        };
        let (edges, median) = (skeleton.edges.len(), median(view, &skeleton, extent.span()));
        let load = Load { edges, vertices: vertices(view).count(), median };
        Ok(Survey { skeleton, extent, load })
    }

    /// Many short edges: faces one by one only if they are few, edges in tiles.
    pub(crate) fn by_tiles(&self, notes: &mut Notes, look: &Look) -> Vec<Node> {
        let outer = outer_label(self.view, self.options, self.fit.size, self.detail);
        let mut leaders = Vec::new();
        let mut nodes = if faces(self.view).count() <= FACES {
            let cycles = Cycles::of(self.view, faces(self.view));
            notes.add("with a boundary that does not close or is taken already", cycles.open.iter().copied());
            let regions = regions(self.view, &self.skeleton, &cycles);
            let (labels, above) = self.map_labels(&regions, outer.as_ref(), look);
            leaders.extend(above);
            self.face_nodes(&regions, &labels, outer.as_ref(), &cycles.open, look)
        } else {
            self.domain(outer.as_ref(), look)
        };
        nodes.push(Node::Group(tiles::edges(self.view, &self.skeleton, self.fit.size)));
        nodes.extend(self.lone_vertices());
        nodes.extend(leaders);
        nodes
    }

    /// The labels of the regions, and the leaders of those that have none.
    fn map_labels(&self, regions: &[Region], outer: Option<&Label>, look: &Look) -> (Vec<Option<Label>>, Vec<Node>) {
        let largest = self.options.style.map_text;
        let sizes = Sizes { largest, smallest: largest.min(LEGIBLE) };
        let bounded = |region: &Region| self.view.outer_face() != Some(region.face);
        let captions = captions(regions, self.options);
        let label = |(region, caption): (&Region, &Option<Caption>)| {
            caption.as_ref().filter(|_| bounded(region))?.place(&region.coarse(1.0), sizes, &[], &|_| None)
        };
        let labels: Vec<Option<Label>> = regions.iter().zip(&captions).map(label).collect();
        let mut crowd = Crowd::new(self.fit.size);
        let segments = self.skeleton.edges.iter().filter_map(|&h| self.skeleton.segment(h));
        crowd.add_all(segments.map(|(a, b)| Shape::Segment(a, b, 0.5)), 0);
        crowd.add_all(labels.iter().flatten().chain(outer).map(|label| Shape::Box(label.bounds())), 0);
        let size = (0.8 * largest).max(sizes.smallest);
        let leaders = lead_out(self.view, regions, &captions, &labels, size, self.fit.size, &mut crowd);
        let name = |face: FaceId| look.name(&format!("{face}-label"));
        let groups = leaders.iter().map(|(i, leader)| leader.group(name(regions[*i].face))).collect();
        (labels, groups)
    }

    /// One group for each face that exists, in the order of their numbers.
    pub(crate) fn face_nodes(
        &self,
        regions: &[Region],
        labels: &[Option<Label>],
        outer: Option<&Label>,
        open: &[FaceId],
        look: &Look,
    ) -> Vec<Node> {
        let hues = tints::hues(self.view, regions, self.options);
        let mut regions = regions.iter().zip(labels).zip(hues).peekable();
        let mut nodes = Vec::new();
        for face in faces(self.view) {
            let mine = regions.next_if(|((region, _), _)| region.face == face);
            if look.face(face) == Mark::Hidden {
                continue;
            }
            let region = mine.map(|((region, _), _)| region);
            let is_outer = self.view.outer_face() == Some(face);
            let mut group = Group {
                class: if is_outer { "f outer" } else { "f" },
                mark: look.face(face).class(),
                id: Some(look.id(face)),
                attributes: look.attributes(attributes(self.view, face, self.options)),
                title: look.title(title(self.view, face, region.map_or(0, |r| r.half_edges), self.options)),
                ..Group::default()
            };
            if is_outer {
                let unknown = open.contains(&face);
                group.nodes.push(self.outer_area(region.map_or(&[], |r| &r.rings), unknown));
                group.nodes.extend(outer.into_iter().flat_map(|label| label.nodes("fl")));
            } else if let Some(((region, label), hue)) = mine {
                if self.view.is_hole(face) {
                    group.nodes.push(self.area("bg", None, &region.rings));
                    group.nodes.push(self.area("hatched", Some("hole-hatch"), &region.rings));
                } else {
                    group.nodes.push(self.area(TINTED[usize::from(hue)], None, &region.rings));
                }
                group.nodes.extend(label.iter().flat_map(|label| label.nodes("fl")));
            }
            nodes.push(Node::Group(group));
        }
        nodes
    }

    fn area(&self, class: &'static str, hatch: Option<&'static str>, rings: &[Vec<Xy>]) -> Node {
        if self.detail >= Detail::Edges {
            Node::Area { class, hatch, outlines: rings.to_vec() }
        } else {
            Node::Fine { class, hatch, lines: tiles::outline(rings, 0.3) }
        }
    }

    /// The frame minus the mesh; where the outline is not known, the frame minus the box round the mesh.
    fn outer_area(&self, rings: &[Vec<Xy>], unknown: bool) -> Node {
        let frame = self.skeleton.window.unwrap_or_else(|| crop::window(self.fit.size).grown(-MARGIN));
        let mut outlines = vec![frame.corners().to_vec()];
        if unknown {
            let mesh = Bounds::of(self.skeleton.at.as_slice().iter().copied().flatten());
            outlines.extend(mesh.map(|mesh| mesh.corners().to_vec()));
        } else {
            outlines.extend(rings.iter().cloned());
        }
        if self.detail >= Detail::Edges {
            return Node::Area { class: "hatched", hatch: Some("hatch"), outlines };
        }
        let mut lines = tiles::outline(&outlines, 1.0);
        if lines.point_count() > OUTLINE {
            lines = tiles::outline(&outlines[..1], 1.0);
        }
        Node::Fine { class: "hatched", hatch: Some("hatch"), lines }
    }

    /// The whole domain in one tint, the hole faces cut out of it.
    fn domain(&self, label: Option<&Label>, look: &Look) -> Vec<Node> {
        let Some(outer) = self.view.outer_face().filter(|&f| self.view.has_face(f)) else { return Vec::new() };
        let holes = faces(self.view).filter(|&f| f != outer && self.view.is_hole(f));
        let cycles = Cycles::of(self.view, std::iter::once(outer).chain(holes));
        let regions = regions(self.view, &self.skeleton, &cycles);
        let rings_of = |wanted: bool| {
            let chosen = regions.iter().filter(move |region| (region.face == outer) == wanted);
            chosen.flat_map(|region| region.rings.iter().cloned()).collect::<Vec<_>>()
        };
        let (outline, holes) = (rings_of(true), rings_of(false));
        let mut group = Group {
            class: "f outer",
            id: Some(look.id(outer)),
            attributes: look.attributes(attributes(self.view, outer, self.options)),
            title: look.title(title(self.view, outer, outline.iter().map(Vec::len).sum(), self.options)),
            nodes: vec![self.outer_area(&outline, cycles.open.contains(&outer))],
            ..Group::default()
        };
        // One name for each component: too long for an attribute here.
        group.attributes.retain(|(name, _)| *name != "data-rings");
        group.nodes.extend(label.into_iter().flat_map(|label| label.nodes("fl")));
        let domain = tiles::outline(&outline, 1.0);
        let mut nodes = vec![Node::Group(group)];
        if !domain.is_empty() && domain.point_count() <= OUTLINE {
            nodes.push(Node::Fine { class: TINTED[4], hatch: None, lines: domain });
        }
        let holes = tiles::outline(&holes, 0.3);
        if !holes.is_empty() {
            nodes.push(Node::Fine { class: "bg", hatch: None, lines: holes.clone() });
            nodes.push(Node::Fine { class: "hatched", hatch: Some("hole-hatch"), lines: holes });
        }
        nodes
    }

    /// Vertices without edges, as dots.
    fn lone_vertices(&self) -> Option<Node> {
        let mut lone = VertexMap::filled(self.view.vertex_bound(), true);
        for v in self.skeleton.edges.iter().filter_map(|&h| self.skeleton.ends(h)).flatten() {
            lone[v] = false;
        }
        let mut lines = Polylines::new(false);
        for v in vertices(self.view).filter(|&v| lone[v]) {
            if let Some(at) = self.skeleton.place(v) {
                lines.start(tenths(at));
            }
        }
        (!lines.is_empty()).then_some(Node::Fine { class: "dots", hatch: None, lines })
    }

    /// The document round the nodes.
    pub(crate) fn scene(&self, nodes: Vec<Node>) -> Scene {
        let options = self.options;
        let [half_edges, faces] = [half_edges(self.view).count(), faces(self.view).count()];
        let [vertices, edges] = [vertices(self.view).count(), self.skeleton.edges.len()];
        let detail = match self.detail {
            Detail::Full => "full",
            Detail::Arrows => "arrows",
            Detail::Edges => "edges",
            Detail::Tiles => "tiles",
        };
        let reading = if self.detail >= Detail::Arrows {
            "Each half-edge runs on the left of its edge; its one-sided barb points to its face."
        } else {
            "The edges are drawn without their half-edges."
        };
        let counts = format!("{vertices} vertices, {edges} edges, {half_edges} half-edges, {faces} faces. {reading}");
        let mut scene = options.scene("dcel", self.fit.size, counts);
        scene.attributes.extend([
            ("data-y", "up".to_owned()),
            ("data-scale", number::model(self.fit.scale)),
            ("data-detail", detail.to_owned()),
        ]);
        scene.nodes = if options.crop.is_some() { crop::seen(nodes, self.fit.size) } else { nodes };
        scene
    }
}
