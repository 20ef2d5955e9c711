//! What a file draws: dots, lines and filled outlines on the canvas, whatever elements draw them.
//!
//! ```text
//!   <line> <polyline> <polygon> <path> <rect>  ──> lines          (those with a stroke, or that should have one)
//!   <circle> <ellipse>                         ──> dots
//!   filled <polygon> <path> <rect> <polyline>  ──> outlines
//! ```
//!
//! y is turned round at once: all points here have y up. In the kit's own figures (`data-figure` on the root) the
//! half-edges, pointers and hatches beside the edges are decoration and not read.

use super::error::{Fault, Problem, quoted};
use super::ink::{Hidden, Ink};
use super::markup::is_svg;
use super::transform::Transform;
use super::{numbers, path};
use crate::figure::selectors::{Rule, Tag, rules};
use crate::plane::Point;
use roxmltree::{Document, Node};
use std::collections::BTreeMap;

/// Elements inside elements, `use` counted.
const DEPTH: usize = 200;
/// Work: elements visited, those drawn again by `use` counted each time, and sixteenths of their attributes.
const WORK: usize = 1_500_000;
/// Lines, dots and corners of areas.
const LINES: usize = 400_000;
/// Rules of style sheets times elements.
const MATCHES: usize = 4_000_000;
/// Characters of style sheets.
const CSS: usize = 1 << 18;
/// Largest coordinate.
const FAR: f64 = 1e9;

/// A circle's middle.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Dot {
    pub(super) at: Point,
    /// Byte of its element.
    pub(super) offset: usize,
    pub(super) hidden: Option<Hidden>,
}

/// A straight line.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Line {
    pub(super) ends: [Point; 2],
    pub(super) offset: usize,
    pub(super) hidden: Option<Hidden>,
}

/// A filled outline.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Outline {
    pub(super) points: Vec<Point>,
}

/// All that is drawn.
#[derive(Clone, Debug)]
pub(super) struct Drawing {
    pub(super) dots: Vec<Dot>,
    pub(super) lines: Vec<Line>,
    pub(super) outlines: Vec<Outline>,
    /// What was not read.
    pub(super) notes: Vec<String>,
}

impl Drawing {
    /// Reads a document. O(size), up to the caps.
    pub(super) fn read(document: &Document<'_>) -> Result<Self, Fault> {
        let css = style_sheets(document)?;
        let rules = rules(&css);
        let elements = document.descendants().filter(Node::is_element).count();
        if rules.len().saturating_mul(elements) > MATCHES {
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
            // Tiles draw the faces roughly.
            fills: !(kit && root.attribute("data-detail") == Some("tiles")),
            canvas: canvas(root),
            paper: [255; 3],
            work: 0,
            points: 0,
            out: Self { dots: Vec::new(), lines: Vec::new(), outlines: Vec::new(), notes: Vec::new() },
            ignored: BTreeMap::new(),
        };
        if root.tag_name().namespace().is_none() {
            let note = "xmlns=\"http://www.w3.org/2000/svg\" is missing on <svg>: browsers show such a file as text";
            reader.out.notes.push(note.to_owned());
        }
        reader.element(root, &Transform::IDENTITY, &Ink::default(), 0)?;
        for (what, count) in reader.ignored {
            reader.out.notes.push(format!("not read: {count} {what}"));
        }
        Ok(reader.out)
    }
}

fn style_sheets(document: &Document<'_>) -> Result<String, Fault> {
    let mut css = String::new();
    for node in document.descendants().filter(|n| n.tag_name().name() == "style") {
        node.descendants().filter(Node::is_text).filter_map(|n| n.text()).for_each(|text| css.push_str(text));
        if css.len() > CSS {
            let problem = Problem::TooLarge { what: "bytes of style sheets", limit: CSS };
            return Err(Fault::at(node.range().start, problem));
        }
    }
    Ok(css)
}

/// The part of the plane that is shown: corner and opposite corner, y down.
fn canvas(root: Node<'_, '_>) -> Option<[[f64; 2]; 2]> {
    let from_box = || match numbers::list(root.attribute("viewBox")?)?[..] {
        [x, y, width, height] => Some([[x, y], [x + width, y + height]]),
        _ => None,
    };
    let side = |name: &str| numbers::length(root.attribute(name)?);
    from_box().or_else(|| Some([[0.0, 0.0], [side("width")?, side("height")?]]))
}

struct Reader<'a, 'i> {
    document: &'a Document<'i>,
    rules: Vec<Rule<'a>>,
    path: Vec<Tag>,
    /// Elements by id; filled when the first `use` comes.
    ids: BTreeMap<&'a str, Node<'a, 'i>>,
    kit: bool,
    fills: bool,
    canvas: Option<[[f64; 2]; 2]>,
    paper: [u8; 3],
    work: usize,
    points: usize,
    out: Drawing,
    ignored: BTreeMap<String, usize>,
}

impl<'a, 'i> Reader<'a, 'i> {
    fn element(&mut self, node: Node<'a, 'i>, around: &Transform, ink: &Ink, depth: usize) -> Result<(), Fault> {
        let offset = node.range().start;
        self.work += 1 + node.attributes().map(|a| a.value().len()).sum::<usize>() / 16;
        if self.work > WORK {
            return Err(Fault::at(offset, Problem::TooLarge { what: "elements to draw", limit: WORK }));
        }
        if depth > DEPTH {
            return Err(Fault::at(offset, Problem::TooDeep { limit: DEPTH }));
        }
        let name = node.tag_name().name();
        if !is_svg(node) || !self.is_drawn(node, name) {
            return Ok(());
        }
        if !self.rules.is_empty() {
            self.path.push(tag(node));
        }
        let inside = ink.inside(node, &self.rules, &self.path);
        if let Some(ink) = inside {
            let transform = match node.attribute("transform") {
                Some(text) => around.after(&Transform::read(text).ok_or_else(|| word(offset, text, "transform"))?),
                None => *around,
            };
            match name {
                "svg" | "g" | "a" => {
                    let moved = if depth > 0 && name == "svg" { self.inner_svg(node)? } else { Transform::IDENTITY };
                    let transform = transform.after(&moved);
                    for child in node.children().filter(Node::is_element) {
                        self.element(child, &transform, &ink, depth + 1)?;
                    }
                }
                "use" => self.reuse(node, &transform, &ink, depth)?,
                "circle" | "ellipse" => self.dot(node, &transform, &ink)?,
                _ => self.shape(node, name, &transform, &ink)?,
            }
        }
        if !self.rules.is_empty() {
            self.path.pop();
        }
        Ok(())
    }

    /// Whether the element can hold lines, dots or areas to be read. Counts those that draw something else.
    fn is_drawn(&mut self, node: Node<'a, 'i>, name: &str) -> bool {
        let decoration = ["he", "ptr", "hatched", "leader", "root"];
        let classes = || node.attribute("class").unwrap_or("").split_whitespace();
        match name {
            "svg" | "g" | "a" | "use" | "line" | "polyline" | "polygon" | "path" | "rect" | "circle" | "ellipse" => {
                !self.kit || !classes().any(|class| decoration.contains(&class))
            }
            "title" | "desc" | "metadata" | "defs" | "style" | "text" | "symbol" | "clipPath" | "mask" | "pattern"
            | "marker" | "linearGradient" | "radialGradient" | "filter" | "view" => false,
            other => {
                *self.ignored.entry(format!("<{}>", quoted(other))).or_default() += 1;
                false
            }
        }
    }

    /// An `svg` inside the drawing stands at its own x and y.
    fn inner_svg(&mut self, node: Node<'a, 'i>) -> Result<Transform, Fault> {
        if node.has_attribute("viewBox") {
            *self.ignored.entry("viewBox of an inner <svg>".to_owned()).or_default() += 1;
        }
        Ok(Transform::translate(number(node, "x", 0.0)?, number(node, "y", 0.0)?))
    }

    fn reuse(&mut self, node: Node<'a, 'i>, transform: &Transform, ink: &Ink, depth: usize) -> Result<(), Fault> {
        if self.ids.is_empty() {
            let named = self.document.descendants().filter_map(|n| Some((n.attribute("id")?, n)));
            for (id, node) in named {
                self.ids.entry(id).or_insert(node);
            }
        }
        let link = node.attributes().find(|a| a.name() == "href").map_or("", |a| a.value());
        let Some(&target) = link.strip_prefix('#').and_then(|id| self.ids.get(id)) else {
            *self.ignored.entry("<use> of something that is not in the file".to_owned()).or_default() += 1;
            return Ok(());
        };
        let moved = transform.after(&Transform::translate(number(node, "x", 0.0)?, number(node, "y", 0.0)?));
        if target.tag_name().name() != "symbol" {
            return self.element(target, &moved, ink, depth + 1);
        }
        for child in target.children().filter(Node::is_element) {
            self.element(child, &moved, ink, depth + 1)?;
        }
        Ok(())
    }

    fn dot(&mut self, node: Node<'a, 'i>, transform: &Transform, ink: &Ink) -> Result<(), Fault> {
        let centre = [number(node, "cx", 0.0)?, number(node, "cy", 0.0)?];
        let offset = node.range().start;
        let at = self.place(transform, centre, offset, "circle")?;
        let fill = ink.hidden_fill(self.paper);
        let hidden = ink.hidden_stroke(self.paper).and(fill);
        self.out.dots.push(Dot { at, offset, hidden });
        Ok(())
    }

    fn shape(&mut self, node: Node<'a, 'i>, name: &str, transform: &Transform, ink: &Ink) -> Result<(), Fault> {
        let offset = node.range().start;
        let (paths, what) = match name {
            "line" => (vec![line(node)?], "line"),
            "polyline" => (corners(node, false)?, "polyline"),
            "polygon" => (corners(node, true)?, "polygon"),
            "rect" => {
                let Some(rect) = self.rect(node, ink, transform)? else { return Ok(()) };
                (vec![rect], "rect")
            }
            _ => {
                let data = node.attribute("d").unwrap_or("");
                let read = path::read(data).map_err(|rest| word(offset, rest, "path data"))?;
                (read, "path")
            }
        };
        let fills = ink.fills() && name != "line";
        let hidden = ink.hidden_stroke(self.paper);
        let is_mark = self.kit && node.attribute("class") == Some("dots");
        self.points += paths.iter().map(|path| path.points.len()).sum::<usize>();
        if self.points > LINES {
            return Err(Fault::at(offset, Problem::TooLarge { what: "lines", limit: LINES }));
        }
        for path in &paths {
            let mut points = Vec::with_capacity(path.points.len() + 1);
            for &(p, curved) in &path.points {
                points.push((self.place(transform, p, offset, what)?, curved));
            }
            self.trace(&points, path.closed, offset, hidden, fills && hidden.is_some(), is_mark);
            if fills && self.fills && points.len() > 2 && !points.iter().any(|p| p.1) {
                let points = points.into_iter().map(|p| p.0).collect();
                self.out.outlines.push(Outline { points });
            }
        }
        Ok(())
    }

    /// The lines of a polyline; of an area without a stroke none.
    fn trace(
        &mut self,
        points: &[(Point, bool)],
        closed: bool,
        offset: usize,
        hidden: Option<Hidden>,
        is_area: bool,
        is_mark: bool,
    ) {
        let Some(&(first, _)) = points.first() else { return };
        if is_mark {
            self.out.dots.push(Dot { at: first, offset, hidden });
            return;
        }
        let back = closed.then_some((first, false));
        let mut from = first;
        for (to, curved) in points.iter().skip(1).copied().chain(back) {
            if curved && hidden.is_none() {
                *self.ignored.entry("curves (edges are straight)".to_owned()).or_default() += 1;
            } else if !curved && !is_area && from != to {
                self.out.lines.push(Line { ends: [from, to], offset, hidden });
            }
            from = to;
        }
    }

    /// A rectangle; `None` if it is the paper.
    fn rect(&mut self, node: Node<'a, 'i>, ink: &Ink, transform: &Transform) -> Result<Option<path::Subpath>, Fault> {
        let side = |name: &str| match node.attribute(name) {
            Some("100%") => Ok(f64::INFINITY),
            _ => number(node, name, 0.0),
        };
        let (x, y) = (number(node, "x", 0.0)?, number(node, "y", 0.0)?);
        let (width, height) = (side("width")?, side("height")?);
        let covers = |[[left, top], [right, bottom]]: [[f64; 2]; 2]| {
            let (near, far) = (transform.apply([x, y]), transform.apply([x + width, y + height]));
            let slack = 0.01 * (right - left).max(bottom - top);
            near[0] <= left + slack && near[1] <= top + slack && far[0] >= right - slack && far[1] >= bottom - slack
        };
        let is_paper = self.kit && node.attribute("class") == Some("bg")
            || width.is_infinite()
            || height.is_infinite()
            || ink.hidden_stroke(self.paper).is_some() && self.canvas.is_some_and(covers);
        if is_paper {
            if let Some(colour) = ink.covering() {
                self.paper = colour;
            }
            return Ok(None);
        }
        let corners = [[x, y], [x + width, y], [x + width, y + height], [x, y + height]];
        let points = corners.map(|p| (p, false)).to_vec();
        Ok((width > 0.0 && height > 0.0).then_some(path::Subpath { points, closed: true }))
    }

    fn place(&self, t: &Transform, p: [f64; 2], offset: usize, what: &'static str) -> Result<Point, Fault> {
        let [x, y] = t.apply(p);
        if x.abs() <= FAR && y.abs() <= FAR {
            return Ok(Point::new(x, -y));
        }
        Err(Fault::at(offset, Problem::Coordinate { what }))
    }
}

fn tag(node: Node<'_, '_>) -> Tag {
    Tag {
        name: node.tag_name().name().to_owned(),
        id: node.attribute("id").map(str::to_owned),
        classes: node.attribute("class").unwrap_or("").split_whitespace().map(str::to_owned).collect(),
    }
}

fn line(node: Node<'_, '_>) -> Result<path::Subpath, Fault> {
    let from = [number(node, "x1", 0.0)?, number(node, "y1", 0.0)?];
    let to = [number(node, "x2", 0.0)?, number(node, "y2", 0.0)?];
    Ok(path::Subpath { points: vec![(from, false), (to, false)], closed: false })
}

fn corners(node: Node<'_, '_>, closed: bool) -> Result<Vec<path::Subpath>, Fault> {
    let text = node.attribute("points").unwrap_or("");
    let wanted = "list of points: write x,y x,y ...";
    let numbers = numbers::list(text).filter(|list| list.len() % 2 == 0);
    let numbers = numbers.ok_or_else(|| word(node.range().start, text, wanted))?;
    let points = numbers.chunks_exact(2).map(|p| ([p[0], p[1]], false)).collect();
    Ok(vec![path::Subpath { points, closed }])
}

fn number(node: Node<'_, '_>, name: &str, missing: f64) -> Result<f64, Fault> {
    let Some(attribute) = node.attribute_node(name) else { return Ok(missing) };
    let wanted = "number: write px without a unit, such as 12.5";
    numbers::length(attribute.value()).ok_or_else(|| word(attribute.range().start, attribute.value(), wanted))
}

fn word(offset: usize, text: &str, wanted: &'static str) -> Fault {
    Fault::at(offset, Problem::Word { word: quoted(text), wanted })
}
