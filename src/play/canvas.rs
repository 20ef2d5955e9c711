//! The picture: how places of it and points of the plane belong together, and what lies at a place.
//!
//! ```text
//!   px of the picture ──point──▶ plane        click: the nearest vertex, else the nearest edge (its half on this side),
//!                     ◀──place──                     else the face
//! ```
//!
//! What is clicked is decided by distances of floating-point numbers, for it is a matter of a hand; every edit after it
//! is decided exactly.

use crate::figure::canvas::vector::{Xy, xy};
use crate::figure::layout::fit::Fit;
use crate::figure::structure::picture::Picture;
use crate::figure::{Detail, Figure, FigureError, FigureOptions, structure};
use crate::ids::{Element, HalfEdgeId, VertexId};
use crate::plane::{PlanarView, Point, Subdivision};
use crate::topology::{Table, View};

/// Free band round the structure, as a share of its size.
const BAND: f64 = 0.12;
/// The prefix of all ids of the picture.
pub(super) const PREFIX: &str = "play";

/// Room for a picture, and what is seen in it.
#[derive(Clone, Debug)]
pub(super) struct Canvas {
    size: [f64; 2],
    /// Two corners of what is seen; it only grows, so that nothing jumps while one draws.
    frame: Option<[Point; 2]>,
    fit: Option<Fit>,
    detail: Detail,
}

impl Default for Canvas {
    fn default() -> Self {
        Self { size: [830.0, 620.0], frame: None, fit: None, detail: Detail::Full }
    }
}

impl Canvas {
    /// Whether that asks for another picture than the one there is.
    pub(super) fn resize(&mut self, width: f64, height: f64) -> bool {
        let clamp = |x: f64| if x.is_finite() { x.clamp(240.0, 4000.0) } else { 830.0 };
        let before = std::mem::replace(&mut self.size, [clamp(width), clamp(height)]);
        self.fit.is_none() || self.size.map(f64::to_bits) != before.map(f64::to_bits)
    }

    /// Another scene: it is seen whole.
    pub(super) fn forget(&mut self) {
        self.frame = None;
        self.fit = None;
    }

    /// Whether single half-edges are drawn.
    pub(super) fn shows_half_edges(&self) -> bool {
        self.detail >= Detail::Arrows
    }

    /// How all pictures of the playground look.
    pub(super) fn options(&self, title: &str) -> FigureOptions {
        let [width, height] = self.size;
        FigureOptions::new(title).id_prefix(PREFIX).width(width).max_height(height)
    }

    /// Draws a structure with positions; `half_edges` says whether single ones are wanted.
    pub(super) fn draw(
        &mut self,
        view: &Table,
        options: FigureOptions,
        half_edges: bool,
    ) -> Result<Figure, FigureError> {
        self.look_at((0..view.vertex_bound() as u32).filter_map(|v| view.position(VertexId::new(v))));
        let corners = self.frame.into_iter().flatten().map(|p| [p.x, p.y]);
        let mut options = options.interactive(true).reach(corners);
        if !half_edges {
            options = options.detail(Detail::Edges);
        }
        let figure = structure(view, &options)?;
        let checked = options.checked();
        let (fit, _) = Picture::survey(view, &checked, Vec::new())?.choose(&checked);
        self.fit = Some(fit);
        self.detail = figure.detail();
        Ok(figure)
    }

    /// Makes the frame large enough.
    fn look_at(&mut self, points: impl Iterator<Item = Point> + Clone) {
        let [low, high] = crate::geometry::point::corners(points);
        if low.x > high.x || !(high.x - low.x).is_finite() || !(high.y - low.y).is_finite() {
            return;
        }
        let inside = |[a, b]: &[Point; 2]| a.x <= low.x && a.y <= low.y && b.x >= high.x && b.y >= high.y;
        if self.frame.as_ref().is_some_and(inside) {
            return;
        }
        let old = self.frame.map_or([low, high], |[a, b]| [a, b]);
        let (x, y) = ((low.x.min(old[0].x), high.x.max(old[1].x)), (low.y.min(old[0].y), high.y.max(old[1].y)));
        let band = BAND * (x.1 - x.0).max(y.1 - y.0);
        self.frame = Some([Point::new(x.0 - band, y.0 - band), Point::new(x.1 + band, y.1 + band)]);
    }

    /// The window that is seen.
    pub(super) fn frame(&self) -> Option<[Point; 2]> {
        self.frame
    }

    /// Where a point is drawn.
    pub(super) fn place(&self, p: Point) -> Option<Xy> {
        Some(self.fit.as_ref()?.place(p))
    }

    /// The point that is drawn at a place, with as few digits as half a pixel needs.
    pub(super) fn point(&self, x: f64, y: f64) -> Option<Point> {
        let fit = self.fit.as_ref()?;
        let p = fit.point(xy(x, y));
        let places = (2.0 * fit.scale).log10().ceil();
        let short = |x: f64| {
            if (0.0..=15.0).contains(&places) {
                format!("{x:.*}", places as usize).parse().unwrap_or(x)
            } else if (-15.0..0.0).contains(&places) {
                let step = 10_f64.powi(-places as i32);
                (x / step).round() * step
            } else {
                x
            }
        };
        (p.x.is_finite() && p.y.is_finite()).then(|| Point::new(short(p.x) + 0.0, short(p.y) + 0.0))
    }

    /// One step of the keyboard in units of the plane.
    pub(super) fn step(&self) -> f64 {
        self.fit.as_ref().map_or(1.0, |fit| {
            let step = 10.0 / fit.scale;
            10_f64.powi(step.log10().round() as i32)
        })
    }

    /// What lies at a place of a subdivision.
    pub(super) fn pick(&self, s: &Subdivision, x: f64, y: f64, reach: f64) -> Option<Element> {
        let face = || Some(s.locate(self.fit.as_ref()?.point(xy(x, y))).element());
        self.near(s, x, y, reach).or_else(face)
    }

    /// What lies at a place of a structure, which may be broken: the nearest vertex, else the nearest edge, its half on this
    /// side.
    pub(super) fn near(&self, view: &impl PlanarView, x: f64, y: f64, reach: f64) -> Option<Element> {
        let fit = self.fit.as_ref()?;
        let reach = if reach.is_finite() { reach.clamp(1.0, 60.0) } else { 10.0 };
        let at = xy(x, y);
        let place = |v: VertexId| Some(fit.place(view.position(v)?));
        let vertices = (0..view.vertex_bound() as u32).map(VertexId::new);
        let mut vertices = vertices.filter_map(|v| Some(((place(v)? - at).length(), Element::from(v))));
        let mut edges = (0..view.half_edge_bound() as u32).map(HalfEdgeId::new).filter_map(|h| {
            let twin = view.twin(h).filter(|&twin| h < twin)?;
            let (d, side) = from_segment(at, place(view.origin(h)?)?, place(view.origin(twin)?)?);
            // y of the picture points down: what is left in the plane has a negative sign here.
            Some((d, Element::from(if side <= 0.0 { h } else { twin })))
        });
        let nearest = |all: &mut dyn Iterator<Item = (f64, Element)>| {
            all.min_by(|a, b| a.0.total_cmp(&b.0)).filter(|&(d, _)| d <= reach).map(|(_, element)| element)
        };
        nearest(&mut vertices).or_else(|| nearest(&mut edges))
    }
}

/// The distance of a place from a segment, and on which side of it the place lies.
fn from_segment(at: Xy, a: Xy, b: Xy) -> (f64, f64) {
    let (along, to) = (b - a, at - a);
    let square = along.x * along.x + along.y * along.y;
    let share = if square > 0.0 { ((to.x * along.x + to.y * along.y) / square).clamp(0.0, 1.0) } else { 0.0 };
    ((to - along * share).length(), along.x * to.y - along.y * to.x)
}

/// Lines and rings over the picture.
#[derive(Clone, Debug, Default)]
pub(super) struct Over(pub(super) String);

impl Over {
    pub(super) fn line(&mut self, class: &str, a: Xy, b: Xy) {
        let [x, y, u, v] = [a.x, a.y, b.x, b.y].map(short);
        self.0.push_str(&format!("<line class=\"{class}\" x1=\"{x}\" y1=\"{y}\" x2=\"{u}\" y2=\"{v}\"/>"));
    }

    pub(super) fn circle(&mut self, class: &str, at: Xy, radius: f64) {
        let [x, y, r] = [at.x, at.y, radius].map(short);
        self.0.push_str(&format!("<circle class=\"{class}\" cx=\"{x}\" cy=\"{y}\" r=\"{r}\"/>"));
    }

    /// Marks an element where single half-edges and vertices are not drawn.
    pub(super) fn mark(&mut self, class: &str, canvas: &Canvas, view: &Table, element: Element) {
        let at = |v: Option<VertexId>| canvas.place(view.position(v?)?);
        let ends = |h: HalfEdgeId| Some([at(view.origin(h))?, at(view.origin(view.twin(h)?))?]);
        match element {
            Element::Vertex(v) => at(Some(v)).into_iter().for_each(|p| self.circle(class, p, 9.0)),
            Element::HalfEdge(h) => ends(h).into_iter().for_each(|[a, b]| self.line(class, a, b)),
            Element::Edge(e) => ends(e.half_edges()[0]).into_iter().for_each(|[a, b]| self.line(class, a, b)),
            Element::Face(f) => {
                let sides = view.half_edge(f).into_iter().flat_map(|h| crate::topology::bounded_cycle(view, h));
                for [a, b] in sides.take(500).filter_map(ends) {
                    self.line(class, a, b);
                }
            }
        }
    }
}

fn short(x: f64) -> f64 {
    (x * 10.0).round() / 10.0
}
