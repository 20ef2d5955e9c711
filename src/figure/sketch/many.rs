//! Very many things: drawn in bulk, without an id and a title for each.
//!
//! ```text
//!   at most 2000 things                    more: one group for each role and kind
//!   <g id="fig-s-point-1">                 <g id="fig-s-plain-points" data-count="100000">
//!     <title>site v0</title><circle/>        <title>100000 x site</title>
//!   </g>                                     <path d="m12.3 4h0m1.2.6h0..."/>    one for each tile of 64 px
//! ```
//!
//! The more ink there is, the thinner are lines and dots, so that the picture does not become one blot. Dashes would
//! not be seen any more: all lines are solid. Areas and circles keep their shapes. Labels may stand over all of it, for
//! there would hardly be room beside so much.

use super::draw::Drawn;
use super::item::{Dash, Heads, Item, Kind};
use super::{Glyph, Role, Sketch};
use crate::figure::canvas::number::drawn;
use crate::figure::canvas::scene::{Group, Node, Polylines, Step, tenths};
use crate::figure::canvas::vector::{Bounds, Xy, xy};
use crate::figure::layout::crowd::Shape;
use crate::figure::structure::tiles::{Tiling, line_width};

/// With more things than this, those without a label are drawn in bulk.
const MOST: usize = 2000;
/// The class of lines and dots in bulk.
const CLASS: &str = "many";
/// Lines and dots follow each other in rows of this height, in tenths of a px: so most steps between them are short.
const ROW: i32 = 40;

impl Sketch {
    /// Whether this thing of the sketch is drawn in bulk.
    pub(super) fn is_bulk(&self, item: &Item) -> bool {
        self.items.len() > MOST && item.label.is_none() && !matches!(item.kind, Kind::Text(_) | Kind::Badge(_))
    }
}

impl Item {
    /// Whether it becomes a line or a dot among others.
    fn is_fine(&self) -> bool {
        match self.kind {
            Kind::Path(_) => self.heads == Heads::None,
            Kind::Ray(_) | Kind::Line(_) | Kind::Point(..) => true,
            _ => false,
        }
    }

    /// What it looks like in bulk, for the legend.
    pub(super) fn in_bulk(&self) -> Self {
        let mut sample = self.clone();
        if self.is_fine() {
            sample.dash = Dash::Solid;
            sample.glyph(Glyph::Dot);
        }
        sample
    }
}

/// The things of one layer, by role and kind in the order in which they first come.
pub(super) struct Many {
    frame: Bounds,
    bulks: Vec<Bulk>,
}

/// The things of one role and one kind.
struct Bulk {
    role: Role,
    kind: usize,
    word: &'static str,
    /// What all of them are called, unless they differ.
    key: Option<String>,
    count: usize,
    lines: Polylines,
    dots: usize,
    /// The length of all lines in px.
    ink: f64,
    /// What is neither a line nor a dot.
    nodes: Vec<Node>,
}

impl Many {
    pub(super) fn new(frame: Bounds) -> Self {
        Self { frame, bulks: Vec::new() }
    }

    /// Takes a thing in. O(its points), and the roles and kinds that there are.
    pub(super) fn add(&mut self, item: &Item, drawn: Drawn) {
        let (role, kind) = (item.role, item.kind.number());
        let known = self.bulks.iter().position(|bulk| bulk.role == role && bulk.kind == kind);
        let at = known.unwrap_or_else(|| {
            self.bulks.push(Bulk {
                role,
                kind,
                word: item.kind.word(),
                key: item.key.clone(),
                count: 0,
                lines: Polylines::new(false),
                dots: 0,
                ink: 0.0,
                nodes: Vec::new(),
            });
            self.bulks.len() - 1
        });
        self.bulks[at].add(item, drawn);
    }

    /// One group for each role and kind. Before every id stands `instance`. O(n log n).
    pub(super) fn nodes(self, instance: &str) -> impl Iterator<Item = Node> {
        let (frame, instance) = (self.frame, instance.to_owned());
        let area = frame.size().x * frame.size().y;
        let width = line_width(self.bulks.iter().map(|bulk| bulk.ink).sum(), area);
        self.bulks.into_iter().map(move |bulk| Node::Group(bulk.group(frame.max, width, &instance)))
    }
}

impl Bulk {
    fn add(&mut self, item: &Item, drawn: Drawn) {
        self.count += 1;
        if self.key != item.key {
            self.key = None;
        }
        if !item.is_fine() {
            self.nodes.extend(drawn.nodes);
            return;
        }
        if let (Kind::Point(..), Some(&Shape::Disc(at, _))) = (&item.kind, drawn.ink.first()) {
            self.dots += 1;
            self.lines.start(tenths(at));
            return;
        }
        for node in drawn.nodes {
            match node {
                Node::Line { from, to, .. } => self.line(from, [to]),
                Node::Curve { start, steps, .. } => self.line(start, steps.iter().map(Step::end)),
                other => self.nodes.push(other),
            }
        }
    }

    fn line(&mut self, start: Xy, to: impl IntoIterator<Item = Xy>) {
        let mut from = start;
        self.lines.start(tenths(start));
        for p in to {
            self.ink += (p - from).length();
            self.lines.line_to(tenths(p));
            from = p;
        }
    }

    /// The group on a canvas of this size, with lines of this width at most.
    fn group(self, size: Xy, width: f64, instance: &str) -> Group {
        let tiling = Tiling::over(size);
        let home = |line: &[[i32; 2]]| tiling.tile(xy(f64::from(line[0][0]), f64::from(line[0][1])) * 0.1);
        let mut lines: Vec<&[[i32; 2]]> = self.lines.iter().collect();
        lines.sort_by_cached_key(|line| (home(line), line[0][1].div_euclid(ROW), line[0][0], line[0][1]));
        lines.dedup();
        let (mut nodes, mut tiles) = (self.nodes, 0);
        for tile in lines.chunk_by(|a, b| home(a) == home(b)) {
            let mut path = Polylines::new(false);
            for line in tile {
                path.start(line[0]);
                line[1..].iter().for_each(|&p| path.line_to(p));
            }
            nodes.push(Node::Fine { class: CLASS, hatch: None, lines: path });
            tiles += 1;
        }
        let width = if self.dots > 0 {
            // Less than half of the way to the next one, on average.
            let share = Tiling::AREA * f64::from(tiles) / self.dots as f64;
            (0.4 * share.sqrt()).clamp(0.3, 2.0 * Glyph::Dot.radius())
        } else {
            width.min(self.role.width())
        };
        let role = self.role.class().trim_start_matches("r-");
        let words = self.key.as_deref().unwrap_or(self.word);
        let mut attributes = vec![("data-count", self.count.to_string())];
        if !self.lines.is_empty() {
            attributes.push(("stroke-width", drawn(width)));
        }
        Group {
            class: "sk",
            mark: self.role.class(),
            id: Some(format!("{instance}s-{role}-{}s", self.word)),
            attributes,
            title: Some(format!("{} x {words}", self.count)),
            nodes,
            ..Group::default()
        }
    }
}
