//! The root of a file: its style sheets, and the part of the plane that it shows.
//!
//! ```text
//!   viewBox="0 0 600 400" width="600" height="800" preserveAspectRatio="none"      y is drawn twice as large as x
//!   style="background:black"                                                       white lines are seen on it
//!   width="0"                                                                      nothing is shown: refused
//! ```

use crate::compare::colour::Paint;
use crate::compare::declarations::bare;
use crate::compare::error::{Fault, Problem};
use crate::compare::ink::Ink;
use crate::compare::markup::is_svg;
use crate::compare::numbers;
use crate::compare::tags::tag;
use crate::compare::transform::Transform;
use crate::compare::viewport::{self, Room};
use crate::figure::canvas::blocks::{is_met, outside};
use crate::figure::canvas::selectors::Rule;
use roxmltree::{Document, Node};

/// Characters of style sheets.
const CSS: usize = 1 << 18;
const XHTML: &str = "http://www.w3.org/1999/xhtml";
/// Px of a window.
const WINDOW: f64 = 1200.0;

/// The rules of all style sheets that a screen may show, one behind the other, each within its `media` if it cannot be
/// told whether a screen meets it.
///
/// # Errors
/// [`Problem::StyleSheet`] if one is not in the file; [`Problem::TooLarge`].
pub(super) fn style_sheets(document: &Document<'_>) -> Result<String, Fault> {
    if let Some(node) = document.root().descendants().find(is_from_outside) {
        let what = if node.is_pi() { "<?xml-stylesheet?>" } else { "<link>" };
        return Err(Fault::at(node.range().start, Problem::StyleSheet { what }));
    }
    let (mut css, mut size) = (String::new(), 0);
    for node in document.descendants().filter(is_style_sheet) {
        let mut sheet = String::new();
        node.descendants().filter(Node::is_text).filter_map(|n| n.text()).for_each(|text| sheet.push_str(text));
        size += sheet.len();
        Fault::if_more(size, CSS, "bytes of style sheets", node.range().start)?;
        let media = node.attribute("media").unwrap_or("");
        match is_met(media) {
            Some(false) => continue,
            Some(true) => sheet = closed(&bare(&sheet)),
            None => sheet = format!("@media {}{{{}}}", bare(media.trim()), closed(&bare(&sheet))),
        }
        if imports_data(&sheet) {
            return Err(Fault::at(node.range().start, Problem::StyleSheet { what: "@import of data" }));
        }
        css.push_str(&sheet);
    }
    Ok(css)
}

/// Whether an element is a style sheet that browsers apply: one of SVG or of XHTML, in CSS.
fn is_style_sheet(node: &Node<'_, '_>) -> bool {
    let is_known = is_svg(*node) || node.tag_name().namespace() == Some(XHTML);
    let is_css = node.attribute("type").is_none_or(|kind| kind.is_empty() || kind.eq_ignore_ascii_case("text/css"));
    is_known && node.tag_name().name() == "style" && is_css
}

/// Whether a style sheet brings in one that stands in the address itself; others are not there.
fn imports_data(sheet: &str) -> bool {
    let sheet = sheet.to_ascii_lowercase();
    let ends = |text: &str| outside(text).find(|(_, c)| matches!(c, ';' | '{')).map_or(text.len(), |(i, _)| i);
    sheet.match_indices("@import").any(|(i, _)| sheet[i..i + ends(&sheet[i..])].contains("data:"))
}

/// A style sheet that ends whatever is open at its end.
fn closed(sheet: &str) -> String {
    let count = |mark: char| outside(sheet).filter(|(_, c)| *c == mark).count();
    let open = count('{').saturating_sub(count('}'));
    format!("{sheet}\n{}", "}".repeat(open))
}

/// Whether a node brings in a style sheet from outside: an instruction, or a link of XHTML.
fn is_from_outside(node: &Node<'_, '_>) -> bool {
    let is_sheet = |word: &str| word.eq_ignore_ascii_case("stylesheet");
    node.pi().is_some_and(|instruction| instruction.target == "xml-stylesheet")
        || node.has_tag_name((XHTML, "link"))
            && node.attribute("rel").is_some_and(|words| words.split_whitespace().any(is_sheet))
}

/// How the root is shown.
pub(super) struct Sheet {
    /// The part of the plane that is shown, y down, before it is stretched.
    pub(super) room: Option<Room>,
    /// How the two sides are scaled against each other.
    pub(super) stretch: Transform,
    /// How many px a unit is shown as.
    pub(super) unit: f64,
    pub(super) note: Option<&'static str>,
    /// The colour behind it all, if its style says one.
    pub(super) ground: Option<Paint>,
}

/// The sheet of the root: its `viewBox`, and its width and height if they are known.
pub(super) fn sheet(root: Node<'_, '_>, rules: &[Rule<'_>]) -> Result<Sheet, Fault> {
    let own = Ink::default().inside(root, rules, &[tag(root)]).map(|(_, own)| own).unwrap_or_default();
    let side = |name| own.geometry.said(name).or_else(|| root.attribute(name)).and_then(side_of_root);
    let [width, height] = ["width", "height"].map(side);
    let ground = own.ground.filter(|paint| matches!(paint, Paint::Colour(..)));
    let view_box = root.attribute("viewBox");
    if [width, height].contains(&Some(0.0)) || view_box.is_some_and(viewport::is_empty) {
        return Err(Fault::at(root.range().start, Problem::NotShown));
    }
    let size = width.zip(height).map(|(width, height)| [width, height]);
    let ratio = root.attribute("preserveAspectRatio").unwrap_or("");
    let Some(inside) = view_box.and_then(viewport::view_box) else {
        let room = size.map(|[width, height]| [0.0, 0.0, width, height]);
        return Ok(Sheet { room, stretch: Transform::IDENTITY, unit: unit(room, size), note: None, ground });
    };
    let stretch = size.map_or(Transform::IDENTITY, |size| viewport::stretch(inside, size, ratio));
    let is_open = viewport::stretches(ratio) && size.is_none() && own_size_is_open(root);
    let note = is_open.then_some(
        "preserveAspectRatio=\"none\" without width and height in px: the drawing is as wide and high as its window",
    );
    Ok(Sheet {
        room: Some(viewport::shown(inside, size, ratio)),
        stretch,
        unit: unit(Some(inside), size),
        note,
        ground,
    })
}

/// How many px a unit of the canvas is shown as: a small drawing is looked at enlarged, one without a size in a window.
fn unit(room: Option<Room>, size: Option<[f64; 2]>) -> f64 {
    let Some([.., width, height]) = room else { return 1.0 };
    let side = width.max(height);
    let shown = size.map_or(WINDOW, |[width, height]| width.max(height).max(0.5 * WINDOW));
    if side > 0.0 { shown / side } else { 1.0 }
}

/// Whether the window says how wide and high the root is.
fn own_size_is_open(root: Node<'_, '_>) -> bool {
    root.has_attribute("width") || root.has_attribute("height") || root.has_attribute("style")
}

/// Width or height of the root in px; none if its window says it.
fn side_of_root(text: &str) -> Option<f64> {
    let is_nothing = text.strip_suffix('%').and_then(numbers::length).is_some_and(|part| part == 0.0);
    let side = if is_nothing { Some(0.0) } else { numbers::measure(text) };
    side.filter(|side| *side >= 0.0)
}
