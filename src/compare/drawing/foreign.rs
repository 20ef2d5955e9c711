//! What stands in a `foreignObject`: letters of ordinary size hide nothing, anything else may.
//!
//! ```text
//!   <div>label</div>                                passed over, with a note
//!   <div style="background:white">label</div>       the whole box is taken for covered
//!   the same, and overflow: visible                 where it ends cannot be told: refused
//! ```

use super::{Around, DEPTH, Reader, shapes};
use crate::compare::colour::{Paint, paint};
use crate::compare::declarations::declarations;
use crate::compare::error::{Fault, Problem, quoted};
use crate::compare::numbers;
use crate::compare::painting::{Area, Part, Shape};
use roxmltree::Node;
use std::collections::BTreeMap;

/// Elements that paint by themselves, or bring what is not in the file.
#[rustfmt::skip]
const PAINTERS: [&str; 20] = [
    "audio", "button", "canvas", "dialog", "embed", "frame", "iframe", "img", "input", "link", "mark", "meter",
    "object", "picture", "portal", "progress", "select", "svg", "textarea", "video",
];
/// Properties that cover what lies below, or of which that cannot be told.
#[rustfmt::skip]
pub(super) const COVERS: [&str; 17] = [
    "backdrop-filter", "background", "background-color", "background-image", "bgcolor", "border-image",
    "border-image-source", "box-shadow", "content", "filter", "list-style", "list-style-image", "rotate", "scale",
    "transform", "translate", "zoom",
];
/// Properties that cover as much as their lengths say: how the names begin, and up to which length they hide nothing.
const BY_LENGTH: [(&str, f64); 6] = [
    ("border", 4.0),
    ("font", 40.0),
    ("outline", 4.0),
    ("text-decoration", 4.0),
    ("text-shadow", 8.0),
    ("-webkit-text-stroke", 4.0),
];
/// The size of letters where nothing is said of it.
const LETTERS: f64 = 16.0;

impl<'a, 'i> Reader<'a, 'i> {
    /// A `foreignObject`: nothing, or a box that covers.
    pub(super) fn foreign(&mut self, node: Node<'a, 'i>, around: &Around, depth: usize) -> Result<(), Fault> {
        self.ignore("<foreignObject>");
        let mut found = None;
        for child in node.children().filter(Node::is_element) {
            found = self.cover(child, depth + 1)?.or(found);
        }
        let Some(what) = found else { return Ok(()) };
        if around.own.overflows {
            return Err(Fault::at(node.range().start, Problem::Foreign { what }));
        }
        let rings = shapes::rings(node, &around.transform, around)?;
        let box_of_it = Shape::Area(Area::new(&rings, false));
        self.out.painting.add(box_of_it, (Paint::Some, 1.0), around.clip, around.part(Part::Other));
        Ok(())
    }

    /// What covers in an element, and in those within it.
    fn cover(&mut self, node: Node<'a, 'i>, depth: usize) -> Result<Option<String>, Fault> {
        self.visit(node)?;
        Fault::if_deeper(depth, DEPTH, node.range().start)?;
        if let Some(selector) = &self.boxes_untold {
            return Err(Problem::StyleChange { selector: selector.clone() }.into());
        }
        let name = node.tag_name().name().to_ascii_lowercase();
        if PAINTERS.contains(&name.as_str()) {
            return Ok(Some(format!("<{}>", quoted(&name))));
        }
        self.enter(node);
        // Of the same property, the last word counts.
        let said: BTreeMap<_, _> = declarations(node, &self.rules, &self.path).into_iter().collect();
        let mut found = said.iter().find(|(key, value)| covers(key, value));
        let is_displayed = said.get("display").is_none_or(|value| value != "none");
        found = found.filter(|_| is_displayed);
        let mut out = found.map(|(key, _)| format!("`{}` of <{}>", quoted(key), quoted(&name)));
        for child in node.children().filter(|n| n.is_element() && is_displayed) {
            out = self.cover(child, depth + 1)?.or(out);
        }
        self.path.pop();
        Ok(out)
    }
}

/// Whether a declaration covers what lies below.
fn covers(key: &str, value: &str) -> bool {
    let value = value.trim();
    if COVERS.contains(&key) {
        let is_nothing = ["none", "inherit", "initial", "normal", "unset", "auto", ""].contains(&value);
        let is_clear = match paint(value) {
            Paint::None => true,
            Paint::Colour(_, alpha) => alpha <= 0.0,
            _ => false,
        };
        return !is_nothing && !is_clear;
    }
    let most = BY_LENGTH.iter().find(|(start, _)| key.starts_with(start)).map(|(_, most)| *most);
    most.is_some_and(|most| lengths(value).any(|length| length > most)) && !key.ends_with("-radius")
}

/// The lengths among the words of a value, in px; one that cannot be told is endless. Numbers within brackets are those
/// of colours.
fn lengths(value: &str) -> impl Iterator<Item = f64> + '_ {
    let computed = ["calc(", "var(", "min(", "max(", "clamp("].iter().any(|start| value.contains(start));
    let mut depth = 0usize;
    let words = value.split(move |c: char| {
        depth = if c == '(' { depth + 1 } else { depth.saturating_sub(usize::from(c == ')')) };
        depth > 0 || c == ')' || c.is_whitespace() || c == '/' || c == ','
    });
    let length = |word: &str| {
        if !word.starts_with(|c: char| c.is_ascii_digit() || c == '.') {
            return None;
        }
        let part = |unit: &str, whole: f64| numbers::length(word.strip_suffix(unit)?).map(|x| x * whole);
        let part = part("rem", LETTERS).or_else(|| part("em", LETTERS)).or_else(|| part("%", LETTERS / 100.0));
        Some(part.or_else(|| numbers::measure(word)).unwrap_or(f64::INFINITY))
    };
    computed.then_some(f64::INFINITY).into_iter().chain(words.filter_map(length))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_covers_and_what_does_not() {
        for (key, value) in [
            ("background", "white"),
            ("background-color", "rgb(255, 255, 255)"),
            ("background-image", "url(a.png)"),
            ("box-shadow", "0 0 0 900px white"),
            ("border", "300px solid white"),
            ("border-left-width", "calc(9px + 50%)"),
            ("outline", "solid white 20em"),
            ("font-size", "500px"),
            ("font", "bold 30em/1.2 serif"),
            ("transform", "scale(9)"),
            ("text-shadow", "0 0 90px white"),
        ] {
            assert!(covers(key, value), "{key}: {value}");
        }
        for (key, value) in [
            ("background", "none"),
            ("background-color", "transparent"),
            ("background-color", "rgba(0, 0, 0, 0)"),
            ("border", "1px solid rgb(200, 200, 200)"),
            ("border-radius", "90px"),
            ("font-size", "12px"),
            ("font", "italic 1.5em/120% serif"),
            ("color", "white"),
            ("width", "900px"),
            ("text-shadow", "0 0 3px white"),
        ] {
            assert!(!covers(key, value), "{key}: {value}");
        }
    }
}
