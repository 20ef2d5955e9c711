//! Animations: elements that change something after a moment. A comparison looks at one moment only.
//!
//! ```text
//!   <line ...><set attributeName="opacity" to="0"/></line>      may hide the line later: refused
//!   <text ...><animate attributeName="fill" .../></text>        a label changes its colour: passed over, with a note
//!   <animate href="#a" attributeName="data-step" .../>          nothing that is read: passed over, with a note
//! ```

use super::error::{Fault, Problem, quoted};
use super::markup::is_svg;
use super::tags::by_id;
use crate::figure::canvas::untold::changes_looks;
use roxmltree::{Document, Node};
use std::collections::{BTreeMap, BTreeSet};

/// Elements that animate.
const ELEMENTS: [&str; 6] = ["set", "animate", "animateColor", "animateTransform", "animateMotion", "discard"];
/// Attributes that a comparison reads, beside the properties that change how something looks.
#[rustfmt::skip]
const READ: [&str; 38] = [
    "class", "clip-rule", "clipPathUnits", "dx", "dy", "font", "font-size", "fx", "fy", "gradientTransform",
    "gradientUnits", "href", "id", "markerHeight", "markerUnits", "markerWidth", "offset", "orient", "patternContentUnits",
    "patternTransform", "patternUnits", "points", "preserveAspectRatio", "refX", "refY", "requiredExtensions",
    "spreadMethod", "stroke-dashoffset", "stroke-linecap", "style", "systemLanguage", "text-anchor", "vector-effect", "viewBox", "x1", "x2", "y1", "y2",
];
const COLOURS: [&str; 3] = ["fill", "stroke", "color"];

/// The animations of a file that change nothing that is read.
#[derive(Debug, Default)]
pub(super) struct Harmless<'a> {
    /// How many of each element.
    pub(super) notes: BTreeMap<&'a str, usize>,
    /// The places of texts that get another colour.
    pub(super) coloured: BTreeSet<usize>,
}

/// Whether an element of this name animates.
pub(super) fn is_animation(name: &str) -> bool {
    ELEMENTS.contains(&name)
}

/// Whether an element of this name is a text or a part of one.
pub(super) fn is_text(name: &str) -> bool {
    matches!(name, "text" | "tspan" | "textPath")
}

/// All animations of a file, if none of them changes what is compared. O(size).
///
/// # Errors
/// [`Problem::Animation`] at the first one that does.
pub(super) fn harmless<'a>(document: &'a Document<'_>) -> Result<Harmless<'a>, Fault> {
    let mut out = Harmless::default();
    let mut named: Option<BTreeMap<&str, Node<'_, '_>>> = None;
    for node in document.descendants().filter(|n| is_animation(n.tag_name().name()) && is_svg(*n)) {
        let link = node.attributes().find(|a| a.name() == "href").map(|a| a.value().trim());
        let target = match link {
            Some(link) => {
                let named = named.get_or_insert_with(|| by_id(document.descendants()));
                link.strip_prefix('#').and_then(|id| named.get(id)).copied()
            }
            None => node.parent_element(),
        };
        *out.notes.entry(node.tag_name().name()).or_default() += 1;
        let Some((target, attribute)) = target.zip(changed(node)) else { continue };
        if is_text(target.tag_name().name()) && COLOURS.contains(&attribute) {
            out.coloured.insert(target.range().start);
            continue;
        }
        let what = match attribute {
            MOTION => "the place",
            WHOLE => "the presence",
            attribute => &format!("`{}`", quoted(attribute)),
        };
        let what = format!("{what} of <{}>", quoted(target.tag_name().name()));
        let element = quoted(node.tag_name().name());
        return Err(Fault::at(node.range().start, Problem::Animation { element, what }));
    }
    Ok(out)
}

/// What `animateMotion` and `discard` change; no attribute has such a name.
const MOTION: &str = "(place)";
const WHOLE: &str = "(presence)";

/// What an animation changes, if that is read; without a prefix.
fn changed<'a>(node: Node<'a, '_>) -> Option<&'a str> {
    match node.tag_name().name() {
        "animateMotion" => return Some(MOTION),
        "discard" => return Some(WHOLE),
        _ => {}
    }
    let otherwise = if node.tag_name().name() == "animateTransform" { "transform" } else { "" };
    let written = node.attribute("attributeName").map_or(otherwise, str::trim);
    let name = written.rsplit(':').next().unwrap_or(written);
    (READ.contains(&name) || changes_looks(name)).then_some(name)
}
