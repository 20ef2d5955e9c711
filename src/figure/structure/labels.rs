//! Where the names stand: no label covers a line, a disc or another label.
//!
//! ```text
//!        h4                  vertex names   inside their discs; beside small discs, in the widest corner
//!   (v3)─────▸ v9            half-edges     on the face side, in the middle of the shaft or near it
//!          f2   ∘            faces          at the pole of the room that is left
//! ```
//!
//! Small faces choose first: a half-edge without a label still has a neighbour's number to count from, a face
//! without one has nothing. What finds no place is left out; its tooltip remains.

use crate::figure::canvas::crop::window;
use crate::figure::canvas::text::{self, LEGIBLE};
use crate::figure::canvas::vector::{Bounds, Xy, xy};
use crate::figure::layout::crowd::{Crowd, INK, Shape};
use crate::figure::structure::captions::{Caption, Label, Sizes, captions};
use crate::figure::structure::faces::Region;
use crate::figure::structure::half_edges::Shaft;
use crate::figure::structure::leaders::{Leader, Search};
use crate::figure::structure::skeleton::{Skeleton, half_edges, vertices};
use crate::figure::structure::vertices::{Spokes, name_size};
use crate::figure::{Detail, FigureOptions};
use crate::ids::{FaceId, HalfEdgeId, HalfEdgeMap, VertexId, VertexMap};
use crate::plane::PlanarView;
use std::borrow::Cow;

/// A shaft shorter than this has no label.
const SHORTEST: f64 = 24.0;
/// Distance between a shaft and its label.
const BESIDE: f64 = 3.2;
/// Free space between two half-edge labels.
const AIR: f64 = 1.5;
/// Names of vertices and half-edges longer than this are cut short.
const NAME: usize = 20;
/// With more faces than this, those without room for a label are told first by a look at their outlines, so that the
/// search is for few: where many meet in a vertex, each would look at all the others.
const MANY: usize = 1000;
/// Where along the edge a label may stand, in the order of preference: the middle, then further and further
/// from it.
const PLACES: [f64; 5] = [0.0, -0.1, 0.1, -0.2, 0.2];

/// All placed labels.
pub(crate) struct Labels {
    pub(crate) vertices: VertexMap<Option<Label>>,
    pub(crate) half_edges: HalfEdgeMap<Option<Label>>,
    /// In the order of the regions.
    pub(crate) faces: Vec<Option<Label>>,
    /// Labels of faces that have no room for them, with the indices of their regions.
    pub(crate) leaders: Vec<(usize, Leader)>,
    pub(crate) outer: Option<Label>,
}

/// What stands on the canvas before the labels come.
pub(crate) struct Stage<'a, V: ?Sized> {
    pub(crate) view: &'a V,
    pub(crate) options: &'a FigureOptions,
    pub(crate) detail: Detail,
    pub(crate) size: Xy,
    pub(crate) skeleton: &'a Skeleton,
    pub(crate) radii: &'a VertexMap<f64>,
    pub(crate) shafts: &'a HalfEdgeMap<Option<Shaft>>,
    pub(crate) regions: &'a [Region],
    /// What else labels must not cover.
    pub(crate) ink: &'a [Shape],
}

impl<V: PlanarView + ?Sized> Stage<'_, V> {
    /// Places all labels; the crowd then holds everything drawn. O(elements), if they do not crowd.
    pub(crate) fn labels(&self) -> (Labels, Crowd) {
        let mut crowd = self.crowd();
        let outer = outer_label(self.view, self.options, self.size, self.detail);
        crowd.add_all(outer.iter().map(|label| Shape::Box(label.bounds())), u32::MAX);
        let vertices = self.vertex_names(&mut crowd);
        let captions = captions(self.regions, self.options);
        let mut faces = vec![None; captions.len()];
        self.face_labels(&captions, &mut faces, &mut crowd, true);
        let half_edges = self.half_edge_labels(&mut crowd);
        self.face_labels(&captions, &mut faces, &mut crowd, false);
        // The bounded faces that have none get theirs outside.
        let size = (0.65 * self.options.style.face_text).max(LEGIBLE);
        let leaders = lead_out(self.view, self.regions, &captions, &faces, size, self.size, &mut crowd);
        (Labels { vertices, half_edges, faces, leaders, outer }, crowd)
    }

    /// Edges, shafts, discs and further ink.
    fn crowd(&self) -> Crowd {
        let style = &self.options.style;
        let mut crowd = Crowd::new(self.size);
        for &h in &self.skeleton.edges {
            if let Some((a, b)) = self.skeleton.segment(h) {
                crowd.add(Shape::Segment(a, b, 0.5 * style.edge_width), h.number());
            }
        }
        for (h, shaft) in self.shafts.iter() {
            crowd.add_all(shaft.iter().flat_map(|shaft| shaft.shapes(style)), h.number());
        }
        for v in vertices(self.view) {
            crowd.add_all(self.disc(v), v.number());
        }
        crowd.add_all(self.ink.iter().copied(), INK);
        crowd
    }

    fn disc(&self, v: VertexId) -> Option<Shape> {
        Some(Shape::Disc(self.skeleton.place(v)?, self.radii[v] + 1.5))
    }

    fn canvas(&self) -> Bounds {
        window(self.size).grown(-4.0)
    }

    fn vertex_names(&self, crowd: &mut Crowd) -> VertexMap<Option<Label>> {
        let mut out = VertexMap::filled(self.view.vertex_bound(), None);
        if !self.options.vertex_labels || self.detail < Detail::Arrows {
            return out;
        }
        let style = &self.options.style;
        let spokes = Spokes::new(self.view.vertex_bound(), self.skeleton);
        for v in vertices(self.view) {
            let Some(at) = self.skeleton.place(v) else { continue };
            let text = text::shortened(&self.options.caption(v), NAME);
            if let Some(size) = name_size(&text, self.radii[v], style) {
                out[v] = Some(Label { at, size, lines: vec![text] });
                continue;
            }
            let size = (0.85 * style.vertex_text).max(style.vertex_text.min(LEGIBLE));
            let half = xy(0.5 * text::width(&text, size, true), text::half_height(size));
            let corners = spokes.bisectors(v);
            let compass =
                [(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0), (0.7, 0.7), (-0.7, 0.7), (0.7, -0.7), (-0.7, -0.7)];
            let directions: Vec<Xy> = corners.into_iter().take(6).chain(compass.map(|(x, y)| xy(x, y))).collect();
            let places = [4.0, 10.0, 16.0].into_iter().flat_map(|gap| {
                let reach = |d: &Xy| self.radii[v] + gap + half.x * d.x.abs() + half.y * d.y.abs();
                directions.iter().map(move |d| at + *d * reach(d)).collect::<Vec<_>>()
            });
            if let Some(at) = places.into_iter().find(|&at| crowd.has_room(at, half, &self.canvas(), 1.0)) {
                let label = Label { at, size, lines: vec![text] };
                crowd.add(Shape::Box(label.bounds()), v.number());
                out[v] = Some(label);
            }
        }
        out
    }

    fn half_edge_labels(&self, crowd: &mut Crowd) -> HalfEdgeMap<Option<Label>> {
        let mut out = HalfEdgeMap::filled(self.view.half_edge_bound(), None);
        if !self.options.half_edge_labels || self.detail < Detail::Full {
            return out;
        }
        for h in half_edges(self.view) {
            out[h] = self.shafts[h].as_ref().and_then(|shaft| self.half_edge_label(h, shaft, crowd));
            if let Some(label) = &out[h] {
                crowd.add(Shape::Box(label.bounds().grown(AIR)), h.number());
            }
        }
        out
    }

    /// Upright, beside the shaft by the support function of its box.
    fn half_edge_label(&self, h: HalfEdgeId, shaft: &Shaft, crowd: &Crowd) -> Option<Label> {
        if shaft.length() < SHORTEST {
            return None;
        }
        let (size, text) = (self.options.style.half_edge_text, text::shortened(&self.options.caption(h), NAME));
        let half = xy(0.5 * text::width(&text, size, false), text::half_height(size));
        let aside = shaft.along.left();
        let distance = BESIDE + half.x * aside.x.abs() + half.y * aside.y.abs();
        let middle = shaft.middle + aside * distance;
        let mut places = PLACES.into_iter().map(|t| middle + shaft.along * (t * shaft.edge_length));
        let place = places.find(|&at| crowd.has_room(at, half, &self.canvas(), 0.0));
        place.map(|at| Label { at, size, lines: vec![text] })
    }

    /// Labels of bounded faces. The first time only those that do not reach their full size; then the others.
    fn face_labels(&self, captions: &[Option<Caption>], out: &mut [Option<Label>], crowd: &mut Crowd, small: bool) {
        let style = &self.options.style;
        let largest = if self.detail < Detail::Arrows { style.map_text } else { style.face_text };
        let sizes = Sizes { largest, smallest: largest.min(LEGIBLE) };
        let many = self.regions.len() > MANY;
        for ((region, caption), out) in self.regions.iter().zip(captions).zip(out) {
            let Some(caption) = caption.as_ref().filter(|_| out.is_none()) else { continue };
            if self.view.outer_face() == Some(region.face) || (many && !Caption::may_have_room(region, sizes)) {
                continue;
            }
            let obstacles = self.obstacles(region, caption, crowd);
            let is_full = |label: &Label| label.size >= largest;
            if small && caption.place(region, sizes, &obstacles, &|_| None).as_ref().is_none_or(is_full) {
                continue;
            }
            *out = caption.place(region, sizes, &obstacles, &|bounds| crowd.blocker(bounds));
            if let Some(label) = out {
                crowd.add(Shape::Box(label.bounds()), region.face.number());
            }
        }
    }

    /// Shafts, discs and further ink in a face: what can push its caption aside.
    fn obstacles(&self, region: &Region, caption: &Caption, crowd: &Crowd) -> Vec<Shape> {
        let style = &self.options.style;
        let mut out = Vec::new();
        let shafts = region.walk(self.view).filter_map(|h| self.shafts.get(h)?.as_ref());
        out.extend(shafts.flat_map(|shaft| shaft.shapes(style)));
        let corners = region.walk(self.view).filter_map(|h| self.view.origin(h));
        let isolated = self.view.inner_components(region.face).iter().filter_map(|ring| ring.isolated());
        out.extend(corners.chain(isolated).filter_map(|v| self.disc(v)));
        let bounds = Bounds::of(region.rings.iter().flatten().copied());
        out.extend(bounds.into_iter().flat_map(|bounds| crowd.tagged(&bounds.grown(caption.reach()), INK)));
        out
    }
}

/// Leaders for the captions of bounded regions that have no label, at this size of the text.
pub(crate) fn lead_out<V: PlanarView + ?Sized>(
    view: &V,
    regions: &[Region],
    captions: &[Option<Caption>],
    labels: &[Option<Label>],
    size: f64,
    canvas: Xy,
    crowd: &mut Crowd,
) -> Vec<(usize, Leader)> {
    let is_outer = |region: &Region| view.outer_face() == Some(region.face);
    let lacking = |i: &usize| labels[*i].is_none() && !is_outer(&regions[*i]);
    let wanted: Vec<(usize, &Caption)> =
        (0..regions.len()).filter(lacking).filter_map(|i| Some((i, captions[i].as_ref()?))).collect();
    let search = Search {
        regions,
        is_taken: &|region| !is_outer(region) && !view.is_hole(region.face),
        size,
        canvas: window(canvas).grown(-6.0),
    };
    search.place(&wanted, crowd)
}

/// The label of the outer face: in the top right corner of the frame, in the free band. A cropped figure has none.
pub(crate) fn outer_label<V: PlanarView + ?Sized>(
    view: &V,
    options: &FigureOptions,
    size: Xy,
    detail: Detail,
) -> Option<Label> {
    let face: FaceId = view.outer_face().filter(|&f| view.has_face(f) && options.crop.is_none())?;
    let text = match options.face_labels {
        crate::figure::FaceLabels::Off => return None,
        crate::figure::FaceLabels::Ids => face.to_string(),
        crate::figure::FaceLabels::Names => options.drawn_name(face).map_or_else(|| face.to_string(), Cow::into_owned),
    };
    let padding = if detail < Detail::Arrows { options.style.small_padding } else { options.style.padding };
    let widest = size.x - 28.0;
    let largest = options.style.face_text.min(padding - 12.0);
    let least = largest.min(LEGIBLE);
    let fits = |text: &String| text::width(text, least, true) <= widest;
    let cuts = [usize::MAX, 40, 28, 16].map(|longest| text::shortened(&text, longest));
    let text = cuts.into_iter().find(fits)?;
    let width = text::width(&text, 1.0, true);
    let fitting = largest.min(widest / width);
    (fitting >= least && !text.trim().is_empty()).then(|| {
        let at = xy(size.x - 14.0 - 0.5 * fitting * width, (0.5 * padding + 1.0).min(24.0));
        Label { at, size: fitting, lines: vec![text] }
    })
}
