//! A sketch on its canvas: alone, or over a half-edge structure.
//!
//! ```text
//!   extent of all points ──> one layout ──> structure, if any     its labels keep clear of the sketch
//!                                      └──> sketch                its labels keep clear of both
//!                                      └──> legend                beside the picture, or below one that fills the page
//! ```

use super::draw::{Canvas, Drawn, layer};
use super::item::{Item, Kind};
use super::legend::{self, Entry};
use super::many::Many;
use super::{Role, Sketch, SketchError, places, role};
use crate::figure::canvas::crop::{self, window};
use crate::figure::canvas::number;
use crate::figure::canvas::scene::{Group, Node, Scene};
use crate::figure::canvas::vector::{Bounds, Xy, xy};
use crate::figure::layout::crowd::{Crowd, INK, Shape};
use crate::figure::layout::fit::{Extent, Fit, Load, choose};
use crate::figure::layout::grid::SHEET;
use crate::figure::structure::look::{Look, Mark};
use crate::figure::structure::notes::Notes;
use crate::figure::structure::part::Part;
use crate::figure::structure::picture::{MARGIN, Picture, check_point};
use crate::figure::structure::plate::Plate;
use crate::figure::{Detail, Figure, FigureOptions};
use crate::plane::{PlanarView, Point};
use std::collections::BTreeSet;

/// Width of a legend beside the picture.
const BESIDE: f64 = 300.0;
/// Space round a legend.
const AIR: f64 = 14.0;
/// The layers of a sketch, words apart.
const LAYERS: usize = 4;

/// How the structure under a sketch looks.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default)]
#[non_exhaustive]
pub enum Backdrop {
    /// As in the structure figure.
    Plain,
    /// Its lines and words in grey, so that the sketch stands out.
    #[default]
    Dimmed,
    /// As in the structure figure, and in front of the sketch, which is its ground.
    InFront,
}

impl Backdrop {
    /// A structure, in a group that dims it if need be, and the sketch over it, but below the names of half-edges and faces.
    pub(in crate::figure) fn layers(self, mut structure: Vec<Node>, sketch: Vec<Node>) -> Vec<Node> {
        let group = |class: &'static str, nodes: Vec<Node>| Node::Group(Group { class, nodes, ..Group::default() });
        let some = |class: &'static str, nodes: Vec<Node>| {
            if nodes.is_empty() { Vec::new() } else { vec![group(class, nodes)] }
        };
        let names = if self == Self::InFront || sketch.is_empty() { Vec::new() } else { names(&mut structure) };
        let sketch = some("over", sketch);
        match self {
            Self::Plain => [structure, sketch, names].concat(),
            Self::Dimmed => [vec![group("under", structure)], sketch, some("under", names)].concat(),
            Self::InFront => [sketch, structure].concat(),
        }
    }

    /// The look of a structure, as one drawing of several if it has an instance.
    pub(in crate::figure) fn look(self, instance: &str) -> Look {
        let look = if instance.is_empty() { Look::default() } else { Look::instance(instance) };
        if self == Self::Dimmed { look.rest(Mark::Dim) } else { look }
    }
}

/// Takes the names of half-edges and faces out of a structure, each in a group with the mark of its element.
fn names(structure: &mut [Node]) -> Vec<Node> {
    let mut out = Vec::new();
    for node in structure {
        let Node::Group(element) = node else { continue };
        if !["he", "f", "f outer"].contains(&element.class) {
            out.extend(names(&mut element.nodes));
            continue;
        }
        let is_name = |node: &Node| matches!(node, Node::Text { class: "hl" | "fl", .. });
        let (words, rest) = std::mem::take(&mut element.nodes).into_iter().partition(is_name);
        element.nodes = rest;
        if !Vec::is_empty(&words) {
            out.push(Node::Group(Group { class: "name", mark: element.mark, nodes: words, ..Group::default() }));
        }
    }
    out
}

/// Whether every coordinate can be computed with.
pub(in crate::figure) fn check(sketch: &Sketch) -> Result<(), SketchError> {
    for item in &sketch.items {
        for p in item.kind.points() {
            check_point(p).map_err(|error| SketchError::Coordinate { item: item.name.clone(), error })?;
        }
    }
    Ok(())
}

/// The roles that occur, in their order.
pub(in crate::figure) fn roles<'a>(sketches: impl IntoIterator<Item = &'a Sketch>) -> Vec<Role> {
    let all: BTreeSet<Role> = sketches.into_iter().flat_map(|sketch| sketch.items.iter().map(Item::role)).collect();
    all.into_iter().collect()
}

/// The points that the picture must hold.
pub(in crate::figure) fn extent(sketch: &Sketch) -> Vec<Point> {
    sketch.items.iter().flat_map(|item| item.kind.extent()).collect()
}

impl Canvas {
    pub(in crate::figure) fn new(fit: Fit, options: &FigureOptions) -> Self {
        let margin = if options.crop.is_some() { 0.0 } else { MARGIN };
        Self { fit, frame: window(fit.size).grown(-margin) }
    }
}

/// The shapes of a sketch, before its words find their places.
pub(in crate::figure) struct Drawing<'a> {
    sketch: &'a Sketch,
    frame: Bounds,
    drawn: Vec<Option<Drawn>>,
    /// What is drawn in bulk, layer by layer.
    bulk: Vec<Many>,
    pub(in crate::figure) notes: Notes,
}

impl<'a> Drawing<'a> {
    pub(in crate::figure) fn new(sketch: &'a Sketch, canvas: &Canvas) -> Self {
        let mut missing: Vec<(&'static str, String)> = Vec::new();
        let mut bulk: Vec<Many> = (0..LAYERS).map(|_| Many::new(canvas.frame)).collect();
        let draw = |item: &Item| match item.draw(canvas) {
            Ok(drawn) if sketch.is_bulk(item) => {
                bulk[layer(&item.kind)].add(item, drawn);
                None
            }
            Ok(drawn) => Some(drawn),
            Err(reason) => {
                missing.push((reason, item.name.clone()));
                None
            }
        };
        let drawn = sketch.items.iter().map(draw).collect();
        let mut notes = Notes::default();
        missing.sort_by_key(|&(reason, _)| reason);
        for same in missing.chunk_by(|a, b| a.0 == b.0) {
            notes.add_words(same[0].0, &mut same.iter().map(|(_, name)| name.clone()));
        }
        Self { sketch, frame: canvas.frame, drawn, bulk, notes }
    }

    /// What labels must not cover: all that is drawn one by one.
    pub(in crate::figure) fn ink(&self) -> Vec<Shape> {
        self.drawn.iter().flatten().flat_map(|drawn| drawn.ink.iter().copied()).collect()
    }

    /// Everything in the order in which it is painted. `crowd` knows the ink already. Badges begin with the number
    /// `first`; before every id stands `instance`.
    pub(in crate::figure) fn nodes(&mut self, crowd: &mut Crowd, size: f64, first: usize, instance: &str) -> Vec<Node> {
        let mut out = Vec::new();
        let group = |item: &Item, ending: &str, nodes: Vec<Node>| Group {
            class: "sk",
            mark: item.role.class(),
            id: Some(format!("{instance}s-{}{ending}", item.name)),
            nodes,
            ..Group::default()
        };
        let titled = |item: &Item| Some(item.words().to_owned());
        for (wanted, bulk) in std::mem::take(&mut self.bulk).into_iter().enumerate() {
            out.extend(bulk.nodes(instance));
            for (item, drawn) in self.sketch.items.iter().zip(&mut self.drawn) {
                if let Some(drawn) = drawn.as_mut().filter(|_| layer(&item.kind) == wanted) {
                    let nodes = std::mem::take(&mut drawn.nodes);
                    out.push(Node::Group(Group { title: titled(item), ..group(item, "", nodes) }));
                }
            }
        }
        let mut homeless = Vec::new();
        let badges = self.sketch.items.iter().zip(&self.drawn).filter(|(item, _)| matches!(item.kind, Kind::Badge(_)));
        for ((item, drawn), number) in badges.zip(first..) {
            let Some(drawn) = drawn else { continue };
            let Some(nodes) = places::badge(number, &drawn.anchors, &self.frame, crowd) else {
                homeless.push(item.name.clone());
                continue;
            };
            let attributes = vec![("data-badge", number.to_string())];
            out.push(Node::Group(Group { attributes, title: titled(item), ..group(item, "", nodes) }));
        }
        for words in self.words() {
            let (item, drawn, label) = words;
            match places::label(label, size, &drawn.anchors, &self.frame, crowd) {
                None => homeless.push(item.name.clone()),
                Some(nodes) => {
                    let ending = if matches!(item.kind, Kind::Text(_)) { "" } else { "-label" };
                    out.push(Node::Group(group(item, ending, nodes)));
                }
            }
        }
        self.notes.add_words("no room for the words of", &mut homeless.into_iter());
        out
    }

    /// The labels: those of points first, for they have the least choice.
    fn words(&self) -> impl Iterator<Item = (&'a Item, &Drawn, &'a str)> {
        let all = || {
            let drawn = self.sketch.items.iter().zip(&self.drawn);
            drawn.filter_map(|(item, drawn)| Some((item, drawn.as_ref()?, item.label.as_deref()?)))
        };
        let is_point = |item: &Item| matches!(item.kind, Kind::Point(..) | Kind::Text(_));
        all().filter(move |words| is_point(words.0)).chain(all().filter(move |words| !is_point(words.0)))
    }
}

/// The document round the nodes; the legend enlarges it.
pub(in crate::figure) fn scene(
    options: &FigureOptions,
    kind: &str,
    canvas: (Xy, f64),
    roles: &[Role],
    nodes: Vec<Node>,
    legend: &[Entry],
) -> Scene {
    let (size, scale) = canvas;
    let words: Vec<&str> = legend.iter().map(Entry::words).collect();
    let about = if words.is_empty() { options.title.clone() } else { format!("{}.", words.join("; ")) };
    let mut scene = Scene { css: role::css(options, roles), nodes, ..options.scene(kind, size, about) };
    scene.attributes.extend([("data-y", "up".to_owned()), ("data-scale", number::model(scale))]);
    add_legend(&mut scene, legend, options.page().min(SHEET));
    scene
}

/// Below a wide picture, and where a page of this width has no room beside it; else beside it.
fn add_legend(scene: &mut Scene, legend: &[Entry], page: f64) {
    if legend.is_empty() {
        return;
    }
    let size = scene.size;
    let is_wide = size.x > 1.15 * size.y && size.x >= 2.0 * BESIDE;
    let below = is_wide || size.x + AIR + BESIDE > page;
    let (corner, width) =
        if below { (xy(AIR, size.y + AIR), size.x - 2.0 * AIR) } else { (xy(size.x + AIR, 2.0 * AIR), BESIDE - AIR) };
    let (nodes, height) = legend::nodes(legend, corner, width, "");
    scene.nodes.push(Node::Group(Group { class: "legend", nodes, ..Group::default() }));
    scene.size = if below {
        xy(size.x, corner.y + height + AIR)
    } else {
        xy(size.x + AIR + BESIDE, size.y.max(corner.y + height + AIR))
    };
}

impl Sketch {
    /// Draws the sketch alone. Of the options, those of structures (labels, faces, names, detail) have no say.
    ///
    /// Cost: O(points), and for every label a look at what lies near it.
    ///
    /// # Errors
    /// [`SketchError::Coordinate`].
    pub fn figure(&self, options: &FigureOptions) -> Result<Figure, SketchError> {
        check(self)?;
        let options = &options.checked();
        let (fit, detail) = lone_fit(extent(self), options);
        let canvas = Canvas::new(fit, options);
        let mut drawing = Drawing::new(self, &canvas);
        let mut crowd = Crowd::new(fit.size);
        crowd.add_all(drawing.ink(), INK);
        let nodes = drawing.nodes(&mut crowd, options.style.map_text, 1, "");
        let scene = scene(options, "dcel-sketch", (fit.size, fit.scale), &roles([self]), nodes, &self.legend(1));
        Ok(Figure { scene, detail, notes: drawing.notes.0 })
    }

    /// Draws the sketch over a structure. Both count for the size of the picture and have one layout. The labels of
    /// the structure keep clear of the sketch.
    ///
    /// ```
    /// use dcel_kit::figure::FigureOptions;
    /// use dcel_kit::figure::sketch::{Backdrop, Role, Sketch};
    /// use dcel_kit::plane::Subdivision;
    ///
    /// let mut sketch = Sketch::new();
    /// sketch.path(Role::Main, [[-200.0, -100.0], [200.0, 100.0]]).arrow();
    /// let svg = sketch.over(&Subdivision::lab_rectangle(), Backdrop::Dimmed, &FigureOptions::new("Lab"))?.to_svg();
    /// assert!(svg.contains("id=\"lab-s-path-1\"") && svg.contains("id=\"lab-h0\""));
    /// # Ok::<(), dcel_kit::figure::sketch::SketchError>(())
    /// ```
    ///
    /// # Errors
    /// [`SketchError`]: a coordinate of the sketch, or what [`structure`](crate::figure::structure()) refuses.
    pub fn over(
        &self,
        view: &dyn PlanarView,
        backdrop: Backdrop,
        options: &FigureOptions,
    ) -> Result<Figure, SketchError> {
        let view: &dyn PlanarView = &Part::of(view, options)?;
        check(self)?;
        let options = &options.checked();
        let survey = Picture::survey(view, options, extent(self))?;
        let (fit, detail) = survey.choose(options);
        let (picture, notes) = survey.place(view, options, fit, detail);
        let canvas = Canvas::new(fit, options);
        let mut drawing = Drawing::new(self, &canvas);
        let mut scene = picture.scene(Vec::new());
        let below = Below::new(picture, notes, &backdrop.look(""), &drawing.ink());
        let mut crowd = below.crowd;
        let nodes = drawing.nodes(&mut crowd, options.style.map_text, 1, "");
        scene.nodes = backdrop.layers(below.nodes, nodes);
        scene.css = role::css(options, &roles([self]));
        scene.attributes[0].1 = "dcel-over".to_owned();
        let legend = self.legend(1);
        if options.description.is_none() && !legend.is_empty() {
            let words: Vec<&str> = legend.iter().map(Entry::words).collect();
            scene.description = format!("{} Over it: {}.", scene.description, words.join("; "));
        }
        add_legend(&mut scene, &legend, options.page().min(SHEET));
        let mut notes = below.notes.0;
        notes.extend(drawing.notes.0);
        Ok(Figure { scene, detail, notes })
    }
}

/// The layout of sketches without a structure.
pub(in crate::figure) fn lone_fit(points: Vec<Point>, options: &FigureOptions) -> (Fit, Detail) {
    let load = Load { edges: 0, vertices: 0, median: None };
    let extent = Extent::of(options.crop.map_or(points, |corners| corners.to_vec()));
    choose(&extent, &load, &options.clone().detail(Detail::Edges))
}

/// A structure drawn under a sketch.
pub(in crate::figure) struct Below {
    pub(in crate::figure) nodes: Vec<Node>,
    /// Its ink and that of the sketch.
    pub(in crate::figure) crowd: Crowd,
    pub(in crate::figure) notes: Notes,
}

impl Below {
    pub(in crate::figure) fn new<V: PlanarView + ?Sized>(
        picture: Picture<'_, V>,
        mut notes: Notes,
        look: &Look,
        ink: &[Shape],
    ) -> Self {
        let (view, size) = (picture.view, picture.fit.size);
        let options = picture.options;
        let seen = |nodes: Vec<Node>| crop::framed(nodes, size, options);
        if picture.detail < Detail::Edges {
            let mut crowd = Crowd::new(size);
            crowd.add_all(ink.iter().copied(), INK);
            let nodes = seen(picture.by_tiles(&mut notes, look));
            return Self { nodes, crowd, notes };
        }
        let plate = Plate::place(picture, notes, ink);
        let nodes = seen(plate.nodes(view, look, Vec::new()));
        Self { nodes, crowd: plate.crowd, notes: plate.notes }
    }
}
