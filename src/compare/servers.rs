//! Gradients and patterns, read: what they paint.
//!
//! ```text
//!   all stops invisible      nothing         all stops alike          that colour
//!   a pattern of nothing     nothing         anything else            some paint, which can be seen
//! ```

use super::colour::{Paint, paint};
use super::declarations::declarations;
use super::error::Fault;
use super::ink::Ink;
use super::markup::is_svg;
use super::numbers::{self, fraction};
use super::served::{Server, Servers};
use super::tags::{by_id, size, tag};
use super::tiles;
use super::values::{is_unread, unworked};
use crate::figure::canvas::selectors::{Rule, Tag};
use roxmltree::{Document, Node};
use std::collections::BTreeMap;

/// Gradients that take their stops from others, one after the other.
const CHAIN: usize = 16;
/// Stops of colours that differ by no more than this, in steps of 255, are alike.
const ALIKE: u8 = 8;
/// A hatch covers at least this part of what lies below it.
const SPARSE: f64 = 0.1;
/// Patterns are read so deep.
const DEPTH: usize = 100;
/// Work: stops and shapes of patterns, with what stands around them.
const WORK: usize = 400_000;

impl Servers {
    /// Reads the gradients and patterns of a file. O(size), up to the caps.
    pub(super) fn read(document: &Document<'_>, rules: &[Rule<'_>]) -> Result<Self, Fault> {
        let is_server =
            |n: &Node<'_, '_>| matches!(n.tag_name().name(), "linearGradient" | "radialGradient" | "pattern");
        let all = document.descendants().filter(|n| n.is_element() && is_svg(*n) && is_server(n));
        let named = by_id(all);
        let mut work = Work { rules, done: 0 };
        let all = named.iter().map(|(id, node)| Ok(((*id).to_owned(), work.server(*node, &named)?)));
        all.collect::<Result<_, _>>().map(Self)
    }
}

/// A server, and those from which it takes what it does not say itself.
fn chain<'a, 'i>(node: Node<'a, 'i>, named: &BTreeMap<&str, Node<'a, 'i>>) -> Vec<Node<'a, 'i>> {
    let mut out = vec![node];
    while out.len() < CHAIN {
        let link = out[out.len() - 1].attributes().find(|a| a.name() == "href").map_or("", |a| a.value());
        match link.trim().strip_prefix('#').and_then(|id| named.get(id)) {
            Some(next) => out.push(*next),
            None => break,
        }
    }
    out
}

/// What is looked at, and how much was.
struct Work<'a, 'r> {
    rules: &'a [Rule<'r>],
    done: usize,
}

impl Work<'_, '_> {
    fn server<'a, 'i>(&mut self, node: Node<'a, 'i>, named: &BTreeMap<&str, Node<'a, 'i>>) -> Result<Server, Fault> {
        let chain = chain(node, named);
        let said = |name: &str| chain.iter().find_map(|n| n.attribute(name));
        let has =
            |n: &&Node<'_, '_>| n.children().any(|child| child.is_element() && child.tag_name().name() != "title");
        let holder = chain.iter().find(has);
        let by_box = |key: &str| said(key) != Some("userSpaceOnUse");
        if node.tag_name().name() != "pattern" {
            let paint = holder.map_or(Ok(Paint::None), |holder| self.gradient(*holder))?;
            return Ok(Server { paint, by_box: by_box("gradientUnits") });
        }
        let by_box = by_box("patternUnits");
        let flat = ["width", "height"].iter().any(|side| said(side).is_none_or(is_nothing));
        let tile = said("width").zip(said("height")).filter(|_| !by_box && said("viewBox").is_none());
        let tile = tile.and_then(|(width, height)| tiles::area(width, height));
        let holder = holder.filter(|_| !flat);
        let paint = holder.map_or(Ok(Paint::None), |holder| self.pattern(*holder, tile))?;
        Ok(Server { paint, by_box })
    }

    /// The tags from the root to an element, if there are rules that look at them.
    fn path(&mut self, node: Node<'_, '_>) -> Result<Vec<Tag>, Fault> {
        let around = node.ancestors().filter(Node::is_element);
        self.done += if self.rules.is_empty() { size(node) } else { around.clone().map(size).sum() };
        Fault::if_more(self.done, WORK, "parts of gradients and patterns", node.range().start)?;
        let mut out: Vec<Tag> = if self.rules.is_empty() { Vec::new() } else { around.map(tag).collect() };
        out.reverse();
        Ok(out)
    }

    /// What the stops of a gradient paint.
    fn gradient(&mut self, node: Node<'_, '_>) -> Result<Paint, Fault> {
        let mut stops: Vec<([u8; 3], f64)> = Vec::new();
        for stop in node.children().filter(|n| n.tag_name().name() == "stop") {
            let tags = self.path(stop)?;
            let (mut colour, mut opacity) = (Paint::Colour([0; 3], 1.0), 1.0);
            for (key, value) in declarations(stop, self.rules, &tags) {
                if is_unread(&key, &value) && matches!(&*key, "all" | "stop-color" | "stop-opacity") {
                    return Err(unworked(stop.range().start, &key, &value));
                }
                match &*key {
                    "stop-color" => colour = paint(&value),
                    "stop-opacity" => opacity = fraction(&value).unwrap_or(1.0),
                    _ => {}
                }
            }
            stops.push(match colour {
                Paint::Colour(rgb, alpha) => (rgb, alpha * opacity),
                Paint::None => ([0; 3], 0.0),
                _ if opacity <= 0.0 => ([0; 3], 0.0),
                _ => return Ok(Paint::Pattern),
            });
        }
        Ok(mixed(&stops))
    }

    /// What the shapes of a pattern paint on a tile of this area: one colour covers as much as its shapes.
    fn pattern(&mut self, node: Node<'_, '_>, tile: Option<f64>) -> Result<Paint, Fault> {
        let mut content = Content { found: Vec::new(), known: true, painted: 0.0 };
        self.collect(node, &Ink::default(), &mut content, 0)?;
        Ok(match mixed(&content.found) {
            _ if !content.known => Paint::Pattern,
            Paint::Colour(rgb, alpha) => {
                let part = tile.map_or(1.0, |tile| (content.painted / tile).clamp(SPARSE, 1.0));
                Paint::Colour(rgb, alpha * part)
            }
            paint => paint,
        })
    }

    /// All shapes below an element.
    fn collect(&mut self, node: Node<'_, '_>, around: &Ink, out: &mut Content, depth: usize) -> Result<(), Fault> {
        Fault::if_deeper(depth, DEPTH, node.range().start)?;
        for child in node.children().filter(Node::is_element) {
            let tags = self.path(child)?;
            let Some((ink, own)) = around.inside(child, self.rules, &tags) else { continue };
            match child.tag_name().name() {
                "g" | "a" | "svg" => self.collect(child, &ink, out, depth + 1)?,
                "line" | "polyline" | "polygon" | "path" | "rect" | "circle" | "ellipse" => {
                    // A gradient within a pattern is some paint.
                    out.known &= !child.attributes().any(|a| a.value().contains("url("));
                    let [filled, lined] = tiles::painted(child, &ink, &own);
                    (filled > 0.0).then(|| out.add(ink.fill()));
                    (lined > 0.0).then(|| out.add(ink.stroke()));
                    out.painted += filled + lined;
                }
                "use" | "image" | "text" => out.known = false,
                _ => {}
            }
        }
        Ok(())
    }
}

/// What a pattern holds.
struct Content {
    found: Vec<([u8; 3], f64)>,
    /// Whether all of it could be told.
    known: bool,
    /// The area that is painted.
    painted: f64,
}

impl Content {
    fn add(&mut self, (paint, opacity): (Paint, f64)) {
        match paint {
            Paint::Colour(rgb, alpha) => self.found.push((rgb, alpha * opacity)),
            Paint::None => {}
            _ => self.known = false,
        }
    }
}

/// Whether a length is no length at all.
fn is_nothing(text: &str) -> bool {
    let text = text.trim();
    let number = text.strip_suffix('%').map_or_else(|| numbers::measure(text), numbers::length);
    number.is_some_and(|number| number <= 0.0)
}

/// Colours that are nearly one are that one, as much of it as they have together; none at all is none.
fn mixed(stops: &[([u8; 3], f64)]) -> Paint {
    let alpha = stops.iter().map(|stop| stop.1).sum::<f64>() / stops.len().max(1) as f64;
    let mut seen = stops.iter().filter(|stop| stop.1 > 0.0);
    let Some(&(first, _)) = seen.next() else { return Paint::None };
    let alike = seen.all(|(rgb, _)| rgb.iter().zip(first).all(|(a, b)| a.abs_diff(b) < ALIKE));
    if alike { Paint::Colour(first, alpha) } else { Paint::Pattern }
}
