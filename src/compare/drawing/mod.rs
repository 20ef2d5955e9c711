//! What a file draws: dots, lines and filled outlines on the canvas, whatever elements draw them, and what they paint.
//!
//! ```text
//!   <line> <polyline> <polygon> <path> <rect>  ──> lines          (those with a stroke, or that should have one)
//!   <circle> <ellipse>, small round <path>     ──> dots
//!   filled <polygon> <path> <rect> <polyline>  ──> outlines
//!   all of them, in their order                ──> painting.rs
//! ```
//!
//! y is turned round at once: all points here have y up. In the kit's own figures (`data-figure` on the root) the
//! half-edges, pointers and hatches beside the edges, tables and insets are decoration: they can hide, and nothing else.
//!
//! ```text
//!   arrows.rs  Arrows that are one filled outline
//!   axes.rs    Axes of matplotlib
//!   clips.rs   Clip paths
//!   foreign.rs What stands in a foreignObject
//!   heads.rs   Heads of arrows
//!   lengths.rs Lengths of elements, by style and by attribute
//!   marks.rs   Markers and letters
//!   ovals.rs   Closed paths that are ellipses
//!   parts.rs   What is drawn, one thing each
//!   reuse.rs   What stands somewhere else than where it is drawn
//!   rims.rs    Lines that end at the rims of boxes
//!   root.rs    Style sheets, and how the root is shown
//!   shapes.rs  Elements with a shape, as lines, dots, outlines and coats
//!   slack.rs   How near to each other things are drawn that belong together
//!   stamps.rs  Vertices drawn as squares or crosses
//! ```

mod arrows;
mod axes;
mod clips;
mod foreign;
mod heads;
mod lengths;
mod marks;
mod ovals;
mod parts;
mod reuse;
mod rims;
mod root;
mod shapes;
mod slack;
mod stamps;

use super::error::{Fault, Problem, quoted};
use super::ink::{Ink, Own};
use super::markup::is_svg;
use super::painting::{Area, Clip, Mark, Painting, Part, Shape};
use super::pairing::distance;
use super::served::Servers;
use super::tags::{by_id, size, tag};
use super::transform::Transform;
use super::values::unworked;
use super::viewport::Room;
use super::{animations, declared};
use crate::figure::canvas::selectors::{Rule, Tag, rules_on_screen};
use crate::figure::canvas::untold::{Untold, untold, untold_with};
use crate::plane::Point;
use lengths::{length, set_length};
pub(in crate::compare) use parts::{Dot, Half, Line, Name, Outline};
use roxmltree::{Document, Node};
use std::borrow::Cow;
use std::cell::OnceCell;
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

/// Elements inside elements, `use` counted.
const DEPTH: usize = 200;
/// Work: elements visited, those drawn again by `use` counted each time, and sixteenths of their attributes.
const WORK: usize = 1_500_000;
/// Lines, dots and corners of areas.
pub(in crate::compare) const LINES: usize = 400_000;
/// Rules of style sheets times elements.
const MATCHES: usize = 4_000_000;
/// Largest coordinate.
const FAR: f64 = 1e9;
/// How far from where its marker stands a circle may lie that is a vertex, as a part of its radius.
const OFF: f64 = 0.25;
/// How far a curve that is straight may bend, as a part of the canvas: as far as a point may be from its place.
const STRAIGHT: f64 = 0.05 / 600.0;
/// How far what is behind it all reaches.
const GROUND: f64 = 1e5;
/// Words in ids and classes of what stands beside a drawing, and of what holds texts that name nothing.
const ASIDE: [&str; 6] = ["legend", "axis", "colorbar", "tick", "ticks", "rows"];
const NOTES: [&str; 7] = ["table", "inset", "rows", "title", "caption", "note", "notes"];

/// What is no part of the structure in the kit's own figures: how its ids end, and its classes. Labels outside of their
/// faces have lines and dots of their own; tables have rules; an inset shows a part of the structure again, and leaders
/// lead to it.
const DECORATION: [&[&str]; 2] = [
    &["-label", "-table-vertices", "-table-half-edges", "-table-faces"],
    &["he", "ptr", "hatched", "table", "inset", "leader"],
];

/// All that is drawn.
#[derive(Clone, Debug, Default)]
pub(in crate::compare) struct Drawing {
    pub(in crate::compare) dots: Vec<Dot>,
    pub(in crate::compare) lines: Vec<Line>,
    pub(in crate::compare) outlines: Vec<Outline>,
    /// The half-edges that a figure of the kit draws beside its edges.
    pub(in crate::compare) halves: Vec<Half>,
    /// What curves of decoration paint.
    pub(in crate::compare) bends: Vec<u32>,
    pub(in crate::compare) names: Vec<Name>,
    pub(in crate::compare) painting: Painting,
    /// Coats of areas that are drawn in place of lines, which are among the lines.
    pub(in crate::compare) bars: Vec<u32>,
    /// Coats that are paper: what lies behind it all by the style of the root, and what lies behind axes.
    pub(in crate::compare) paper: Vec<u32>,
    /// The part of the plane that is shown: lowest and highest corner.
    pub(in crate::compare) canvas: Option<[Point; 2]>,
    /// What is passed over as a part of axes: lines of frames, and ticks and lines of grids.
    pub(in crate::compare) axes: [usize; 2],
    /// What was not read.
    pub(in crate::compare) notes: Vec<String>,
}

impl Drawing {
    /// Whether anything stands in a legend.
    pub(in crate::compare) fn has_legend(&self) -> bool {
        self.lines.iter().any(|line| line.legend > 0)
            || self.dots.iter().any(|dot| dot.legend > 0)
            || self.outlines.iter().any(|outline| outline.legend > 0)
    }

    /// Takes out what stands in some legends, by their numbers; 0 is none.
    pub(in crate::compare) fn take_out(&mut self, is_out: impl Fn(u32) -> bool) {
        self.lines.retain(|line| !is_out(line.legend));
        self.dots.retain(|dot| !is_out(dot.legend));
        self.outlines.retain(|outline| !is_out(outline.legend));
    }

    /// Reads a document; `tolerance` is how far points may be from their places, as a part of the drawing. O(size), up to
    /// the caps.
    pub(in crate::compare) fn read(document: &Document<'_>, tolerance: f64) -> Result<Self, Fault> {
        let css = root::style_sheets(document)?;
        let short = |selector: &str| selector.chars().take(60).collect::<String>();
        match untold(&css) {
            Some(Untold::Hides(selector)) => return Err(Problem::StyleRule { selector: short(selector) }.into()),
            Some(Untold::Changes(selector)) => return Err(Problem::StyleChange { selector: short(selector) }.into()),
            None => {}
        }
        let animations = animations::harmless(document)?;
        let rules = rules_on_screen(&css);
        let elements = document.descendants().filter(Node::is_element).count();
        if rules.iter().map(Rule::weight).sum::<usize>().saturating_mul(elements) > MATCHES {
            return Err(Problem::TooLarge { what: "style rules times elements", limit: MATCHES }.into());
        }
        let root = document.root_element();
        let kit = root.has_attribute("data-figure");
        let mut reader = Reader {
            document,
            rules,
            path: Vec::new(),
            ids: BTreeMap::new(),
            kit,
            asked: OnceCell::new(),
            unit: 1.0,
            // Tiles draw the faces roughly.
            fills: !(kit && root.attribute("data-detail") == Some("tiles")),
            clips: BTreeMap::new(),
            work: 0,
            points: 0,
            dashes: 0,
            markers: 0,
            legends: 0,
            shapes: Vec::new(),
            blank: 0,
            out: Self::default(),
            ignored: BTreeMap::new(),
            coloured: animations.coloured,
            keyframes: css.to_ascii_lowercase().contains("keyframes"),
            boxes_untold: untold_with(&css, &foreign::COVERS).map(|what| short(what.selector())),
        };
        if root.tag_name().namespace().is_none() {
            let note = "xmlns=\"http://www.w3.org/2000/svg\" is missing on <svg>: browsers show such a file as text";
            reader.out.notes.push(note.to_owned());
        }
        let servers = Servers::read(document, &reader.rules)?;
        let sheet = root::sheet(root, &reader.rules)?;
        let room = sheet.room;
        reader.unit = sheet.unit;
        reader.out.notes.extend(sheet.note.map(str::to_owned));
        let slack = room.map_or(0.0, |[_, _, width, height]| STRAIGHT * width.max(height) * sheet.stretch.growth());
        let mut around = Around { room, slack, transform: sheet.stretch, ink: Ink::with(servers), ..Around::default() };
        if let Some(paint) = sheet.ground {
            let wide = [[-GROUND, -GROUND], [GROUND, -GROUND], [GROUND, GROUND], [-GROUND, GROUND]];
            let area = Shape::Area(Area::new(&[wide.map(flipped).to_vec()], false));
            reader.out.paper.push(reader.out.painting.add(area, (paint, 1.0), None, Part::Area));
        }
        if let Some(room) = room {
            let corners = corners(room).map(|p| flipped(sheet.stretch.apply(p)));
            reader.out.canvas = Some([Point::new(corners[0].x, corners[2].y), Point::new(corners[2].x, corners[0].y)]);
            let overflow = root.attribute("overflow").or_else(|| root.attribute("style")).unwrap_or("");
            if !overflow.contains("visible") {
                let areas = vec![Area::new(&[corners.to_vec()], false)];
                reader.out.painting.clips.push(Clip { areas, around: None, canvas: true });
                around.clip = Some(0);
            }
        }
        reader.element(root, &around, 0)?;
        if !kit {
            let curved = stamps::read(&mut reader.out, &reader.shapes, tolerance);
            if let Some(count) = reader.ignored.get_mut(shapes::CURVES) {
                *count = count.saturating_sub(curved);
            }
            reader.ignored.retain(|_, count| *count > 0);
        }
        reader.ignored.extend(animations.notes.into_iter().map(|(name, count)| (format!("<{name}>"), count)));
        for (what, count) in reader.ignored {
            let what = if count == 1 { what.replacen("curves (edges", "curve (edges", 1) } else { what };
            reader.out.notes.push(format!("not read: {count} {what}"));
        }
        Ok(reader.out)
    }

    /// The ends of all lines and the middles of all dots.
    pub(in crate::compare) fn points(&self) -> impl Iterator<Item = Point> + '_ {
        self.dots.iter().map(|dot| dot.at).chain(self.lines.iter().flat_map(|line| line.ends))
    }
}

/// The corners of a rectangle.
pub(in crate::compare) fn corners([x, y, width, height]: Room) -> [[f64; 2]; 4] {
    [[x, y], [x + width, y], [x + width, y + height], [x, y + height]]
}

/// What an element stands in.
#[derive(Clone, Debug, Default)]
pub(in crate::compare) struct Around {
    pub(in crate::compare) transform: Transform,
    pub(in crate::compare) ink: Ink,
    pub(in crate::compare) own: Own,
    pub(in crate::compare) clip: Option<u32>,
    /// The room that percentages are parts of.
    pub(in crate::compare) room: Option<Room>,
    /// How far on the canvas a point may be from its place, by the size of that; 0 if it has none.
    pub(in crate::compare) slack: f64,
    pub(in crate::compare) aside: bool,
    /// Where it stands in axes as matplotlib draws them.
    pub(in crate::compare) axes: Option<axes::Axes>,
    /// The number of the legend around, from 1.
    pub(in crate::compare) legend: u32,
    /// Whether texts here name nothing: they stand in a table, a legend, a note or the like.
    pub(in crate::compare) noted: bool,
    /// Whether it is decoration of the kit, which can only hide.
    pub(in crate::compare) decorates: bool,
    /// Where on the canvas the marker stands in which it is.
    pub(in crate::compare) stand: Option<Point>,
    /// Whether it is a text that gets another colour after a moment.
    pub(in crate::compare) coloured: bool,
    /// What it is, if it is a marker or a text.
    pub(in crate::compare) mark: Option<Mark>,
}

impl Around {
    /// The same for a circle in a marker if that is drawn right where the marker stands: such a circle can be a
    /// vertex, as any other one there.
    pub(in crate::compare) fn of_circle(&self, at: Point, radius: f64) -> Cow<'_, Self> {
        match self.stand.is_some_and(|stand| distance(stand, at) <= OFF * radius) {
            true => Cow::Owned(Self { mark: None, decorates: false, ..self.clone() }),
            false => Cow::Borrowed(self),
        }
    }

    /// What a coat is that would be this part elsewhere.
    pub(in crate::compare) fn part(&self, part: Part) -> Part {
        match self.mark {
            Some(mark) => Part::Mark(mark),
            None if self.decorates => Part::Other,
            None => part,
        }
    }
}

pub(in crate::compare) struct Reader<'a, 'i> {
    document: &'a Document<'i>,
    rules: Vec<Rule<'a>>,
    path: Vec<Tag>,
    /// Elements by id; filled when the first one is needed.
    ids: BTreeMap<&'a str, Node<'a, 'i>>,
    pub(in crate::compare) kit: bool,
    /// Whether something asks for the colour around, or whether it is dark around; looked for when it first matters.
    asked: OnceCell<[bool; 2]>,
    /// How many px a unit of the canvas is shown as.
    pub(in crate::compare) unit: f64,
    pub(in crate::compare) fills: bool,
    /// Clips that were met, by the place of their element, the clip around and the transform.
    clips: BTreeMap<(usize, Option<u32>, [u64; 6]), u32>,
    work: usize,
    points: usize,
    dashes: usize,
    markers: usize,
    legends: u32,
    /// The coats of each shape that was read.
    shapes: Vec<Range<u32>>,
    /// Shapes of decoration that paint nothing, up to here.
    pub(in crate::compare) blank: usize,
    pub(in crate::compare) out: Drawing,
    ignored: BTreeMap<String, usize>,
    /// The places of texts that get another colour after a moment.
    coloured: BTreeSet<usize>,
    /// Whether there are rules that say how something changes.
    keyframes: bool,
    /// A rule that may let boxes of a `foreignObject` cover something.
    boxes_untold: Option<String>,
}

impl<'a, 'i> Reader<'a, 'i> {
    /// Whether something asks for the colour around, and whether for what is dark.
    fn asked(&self) -> [bool; 2] {
        *self.asked.get_or_init(|| {
            let text = self.document.input_text().to_ascii_lowercase();
            ["currentcolor", "light-dark("].map(|word| text.contains(word))
        })
    }

    fn element(&mut self, node: Node<'a, 'i>, outer: &Around, depth: usize) -> Result<(), Fault> {
        self.visit(node)?;
        Fault::if_deeper(depth, DEPTH, node.range().start)?;
        let name = node.tag_name().name();
        if !is_svg(node) || !has_its_conditions(node) || !self.is_drawn(name) {
            return Ok(());
        }
        self.enter(node);
        let before = (self.blank, self.out.painting.coats.len() as u32);
        let inside = self.inside(node, outer)?;
        self.blank += usize::from(inside.is_none() && outer.decorates && name != "text");
        let is_displayed = inside.is_some();
        let noted = (name == "text").then(|| inside.as_ref().is_some_and(|around| around.noted));
        if let Some(around) = inside {
            match name {
                "svg" | "g" | "a" => {
                    let around = if depth > 0 && name == "svg" {
                        let corner = [length(node, "x", 0, &around)?, length(node, "y", 1, &around)?];
                        self.inner(node, node, corner, around)?
                    } else {
                        around
                    };
                    self.children(node, &around, depth)?;
                }
                "use" => self.reuse(node, around, depth)?,
                "switch" => self.switch(node, &around, depth)?,
                "foreignObject" => self.foreign(node, &around, depth)?,
                "text" => self.text(node, &around, [0.0; 2], 1.0, depth)?,
                _ => {
                    let number = self.shapes.len();
                    self.shapes.push(before.1..before.1);
                    self.shape(node, name, &around, depth)?;
                    self.shapes[number].end = self.out.painting.coats.len() as u32;
                }
            }
        }
        let coats = before.1..self.out.painting.coats.len() as u32;
        if let Some(noted) = noted {
            self.name(node, coats.clone(), noted);
        }
        if self.kit && declared::is_half_edge(node) {
            let name = node.attribute("id").and_then(|id| id.rsplit('-').next()).unwrap_or("").to_owned();
            self.out.halves.push(Half { name, coats, lacks: !is_displayed || self.blank > before.0 });
        }
        self.path.pop();
        Ok(())
    }

    /// A text that may be the name of something.
    fn name(&mut self, node: Node<'a, 'i>, coats: Range<u32>, noted: bool) {
        let label = |node| declared::labelled(node).filter(|_| self.kit);
        let element = node.parent().and_then(|node| declared::name(node).or_else(|| label(node)));
        let element = element.unwrap_or("").to_owned();
        if element.is_empty() && (noted || coats.is_empty()) {
            return;
        }
        let text = node.descendants().filter(Node::is_text).filter_map(|n| n.text()).collect::<String>();
        self.out.names.push(Name { element, text: text.trim().to_owned(), coats, noted });
    }

    /// Notes an element for the rules of style sheets, if there are any; [`pop`](Vec::pop) from the path leaves it.
    fn enter(&mut self, node: Node<'_, '_>) {
        if !self.rules.is_empty() {
            self.path.push(tag(node));
        }
    }

    /// Counts an element, up to the cap.
    fn visit(&mut self, node: Node<'a, 'i>) -> Result<(), Fault> {
        self.work += size(node);
        Fault::if_more(self.work, WORK, "elements to draw", node.range().start)
    }

    fn children(&mut self, node: Node<'a, 'i>, around: &Around, depth: usize) -> Result<(), Fault> {
        node.children().filter(Node::is_element).try_for_each(|child| self.element(child, around, depth + 1))
    }

    /// The first child whose conditions hold, and no other.
    fn switch(&mut self, node: Node<'a, 'i>, around: &Around, depth: usize) -> Result<(), Fault> {
        let mut children = node.children().filter(|n| n.is_element() && is_svg(*n));
        let first = children.find(|child| has_its_conditions(*child));
        first.map_or(Ok(()), |child| self.element(child, around, depth + 1))
    }

    /// The style and place of what is inside an element; `None` if that is not displayed.
    fn inside(&mut self, node: Node<'a, 'i>, outer: &Around) -> Result<Option<Around>, Fault> {
        let offset = node.range().start;
        let Some((ink, own)) = outer.ink.inside(node, &self.rules, &self.path) else { return Ok(None) };
        // A style wins over an attribute.
        let written = own.transform.as_deref().or_else(|| node.attribute("transform"));
        let transform = clips::moved(&outer.transform, node, written)?;
        // What moves an element or turns it about a point of its own is not worked out.
        let has_transform = own.transform.is_some() || node.has_attribute("transform");
        let origin = own.origin.as_deref().filter(|origin| has_transform && !is_corner(origin));
        if let Some(text) = own.unread.clone().or_else(|| origin.map(|text| format!("transform-origin: {text}"))) {
            return Err(word(offset, &text, "property that is read here: write a transform in its place"));
        }
        let name = node.tag_name().name();
        // Colours and rims of letters, and what asks for no colour, change nothing; only the root has a ground.
        let matters = |key: &str| match key {
            "fill" | "stroke-width" => !animations::is_text(name),
            "color" => self.asked()[0],
            "color-scheme" => self.asked()[1],
            "background" | "background-color" => node == self.document.root_element(),
            _ => true,
        };
        if let Some((key, value)) = own.unworked.iter().find(|(key, _)| matters(key)) {
            return Err(unworked(offset, key, value));
        }
        if let Some(text) = own.animation.as_deref().filter(|_| self.keyframes && !animations::is_text(name)) {
            let what = format!("how <{}> looks, by `{}`,", quoted(name), quoted(text));
            return Err(Fault::at(offset, Problem::Animation { element: "style".to_owned(), what }));
        }
        let mut out = Around { transform, ink, ..outer.clone() };
        if let Some(link) = &own.clip {
            out.clip = self.clip(node, link, &out)?;
        }
        out.own = own;
        let classes = || node.attribute("class").unwrap_or("").split_whitespace();
        let id = node.attribute("id").unwrap_or("");
        let names = [id].into_iter().chain(classes()).collect::<Vec<_>>().join(" ").to_ascii_lowercase();
        let has_word = |is: fn(&str) -> bool| names.split(|c: char| !c.is_ascii_alphabetic()).any(is);
        out.aside |= has_word(|word| ASIDE.contains(&word));
        out.axes = outer.axes.or_else(|| axes::part(node, &out.transform));
        if out.legend == 0 && has_word(|word| word == "legend") {
            self.legends += 1;
            out.legend = self.legends;
        }
        let decorates =
            DECORATION[0].iter().any(|end| id.ends_with(end)) || classes().any(|class| DECORATION[1].contains(&class));
        out.decorates |= self.kit && (decorates || declared::is_half_edge(node));
        let notes = |word: &str| NOTES.contains(&word) || self.kit && DECORATION[1].contains(&word) && word != "he";
        let is_label = self.kit && DECORATION[0].iter().any(|end| id.ends_with(end));
        let is_root = node == self.document.root_element();
        out.noted |= out.aside || out.legend > 0 || is_label || !is_root && (classes().any(notes) || notes(id));
        Ok(Some(out))
    }

    /// Whether the element can hold or be something that is painted. Counts those that draw something else.
    fn is_drawn(&mut self, name: &str) -> bool {
        match name {
            "svg" | "g" | "a" | "use" | "line" | "polyline" | "polygon" | "path" | "rect" | "circle" | "ellipse"
            | "image" | "switch" | "text" | "foreignObject" => true,
            "title" | "desc" | "metadata" | "defs" | "style" | "symbol" | "clipPath" | "mask" | "pattern"
            | "marker" | "linearGradient" | "radialGradient" | "filter" | "view" => false,
            // Counted before.
            other if animations::is_animation(other) => false,
            other => {
                *self.ignored.entry(format!("<{}>", quoted(other))).or_default() += 1;
                false
            }
        }
    }

    pub(in crate::compare) fn ignore(&mut self, what: &str) {
        *self.ignored.entry(what.to_owned()).or_default() += 1;
    }

    fn by_id(&mut self, id: &str) -> Option<Node<'a, 'i>> {
        if self.ids.is_empty() {
            self.ids = by_id(self.document.descendants());
        }
        self.ids.get(id).copied()
    }

    /// The number of the shape that is read.
    pub(in crate::compare) fn current(&self) -> u32 {
        self.shapes.len().saturating_sub(1) as u32
    }

    /// Counts points, up to the cap.
    pub(in crate::compare) fn count(&mut self, points: usize, offset: usize) -> Result<(), Fault> {
        self.points += points;
        Fault::if_more(self.points, LINES, "lines", offset)
    }
}

/// Whether a `transform-origin` is where all transforms start from.
fn is_corner(origin: &str) -> bool {
    origin.split_whitespace().all(|side| ["0", "0px", "0%", "left", "top"].contains(&side))
}

/// A point of the canvas, y up.
pub(in crate::compare) fn flipped([x, y]: [f64; 2]) -> Point {
    Point::new(x, -y)
}

/// A point of an element on the canvas, y up.
pub(in crate::compare) fn place(t: &Transform, p: [f64; 2], offset: usize, what: &'static str) -> Result<Point, Fault> {
    let [x, y] = t.apply(p);
    if x.abs() <= FAR && y.abs() <= FAR {
        return Ok(Point::new(x, -y));
    }
    Err(Fault::at(offset, Problem::Coordinate { what }))
}

/// Whether a reader draws an element that asks for a language or for more than SVG: one of English, who knows no more.
fn has_its_conditions(node: Node<'_, '_>) -> bool {
    let is_english = |language: &str| language.trim().get(..2).is_some_and(|start| start.eq_ignore_ascii_case("en"));
    let language = node.attribute("systemLanguage").is_none_or(|list| list.split(',').any(is_english));
    language && node.attribute("requiredExtensions").is_none_or(|list| list.trim().is_empty())
}

pub(in crate::compare) fn word(offset: usize, text: &str, wanted: &'static str) -> Fault {
    Fault::at(offset, Problem::Word { word: quoted(text), wanted })
}
