//! Lengths of elements: what a style says comes before what the attribute says.
//!
//! ```text
//!   width="25%"   a part of the room around      r="4mm"   with its unit      r="-4"   as if nothing were said
//! ```

use super::{Around, FAR, word};
use crate::compare::error::Fault;
use crate::compare::geometry::is_never_negative;
use crate::compare::numbers;
use roxmltree::Node;

/// A length with its unit, or in percent of the room, of which `axis` 0 is the width, 1 the height and 2 both; 0 if
/// it is missing. A style says it before the attribute does: `around` has the element's own style.
pub(super) fn length(node: Node<'_, '_>, name: &str, axis: usize, around: &Around) -> Result<f64, Fault> {
    set_length(node, name, axis, around).map(Option::unwrap_or_default)
}

/// The same; `None` if it is missing, `auto`, or below 0 where no such value is one (SVG 2, section 7.1: it is passed
/// over, as if it were not written).
pub(super) fn set_length(node: Node<'_, '_>, name: &str, axis: usize, around: &Around) -> Result<Option<f64>, Fault> {
    let attribute = node.attribute_node(name).map(|attribute| (attribute.value(), attribute.range().start));
    let style = around.own.geometry.of(node.tag_name().name(), name).map(|text| (text, node.range().start));
    let Some((text, offset)) = style.or(attribute).filter(|(text, _)| *text != "auto") else { return Ok(None) };
    let length = measured(text, axis, around, offset)?;
    Ok(Some(length).filter(|length| *length >= 0.0 || !is_never_negative(name)))
}

/// The length that a text says, in the room.
fn measured(written: &str, axis: usize, around: &Around, offset: usize) -> Result<f64, Fault> {
    let text = written.trim();
    let part = |percent: &str| {
        let part = numbers::length(percent)? / 100.0;
        // Without a size, the canvas is as large as the window.
        let [.., width, height] = around.room.unwrap_or([0.0, 0.0, FAR / 10.0, FAR / 10.0]);
        Some(part * [width, height, ((width * width + height * height) / 2.0).sqrt()][axis])
    };
    let value = text.strip_suffix('%').map_or_else(|| numbers::measure(text), part);
    let wanted = "number: write px without a unit, such as 12.5";
    value.ok_or_else(|| word(offset, written, wanted))
}
