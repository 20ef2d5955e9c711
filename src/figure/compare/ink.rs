//! What can be seen: paints, widths and opacities, by attributes, style sheet and `style`, handed down to children.
//!
//! ```text
//!   stroke="white"          on white paper       ┐
//!   stroke="none"           or none at all       ├── drawn, but nobody sees it
//!   stroke-width="0"  opacity="0"  visibility    ┘
//! ```

use super::numbers;
use crate::figure::selectors::{Rule, Tag};
use roxmltree::Node;

/// Less contrast than this, in steps of 255, cannot be seen.
const FAINT: f64 = 6.0;

/// What an area or a line is painted with.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) enum Paint {
    None,
    /// `url(#...)`: a hatch or a gradient.
    Pattern,
    Colour([u8; 3]),
    /// A colour that is not worked out, and so can be seen.
    Some,
}

/// Why a line or a dot cannot be seen.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Hidden {
    NoStroke,
    NoWidth,
    Transparent,
    Paper,
    Switched,
}

impl Hidden {
    /// The reason as the end of a sentence.
    pub(super) fn reason(self) -> &'static str {
        match self {
            Self::NoStroke => "it has no stroke",
            Self::NoWidth => "its stroke-width is 0",
            Self::Transparent => "its opacity is 0",
            Self::Paper => "it has the colour of the paper",
            Self::Switched => "its visibility is hidden",
        }
    }
}

/// The style of an element.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Ink {
    fill: Paint,
    fill_opacity: f64,
    stroke: Paint,
    stroke_opacity: f64,
    width: f64,
    opacity: f64,
    visible: bool,
}

impl Default for Ink {
    fn default() -> Self {
        Self {
            fill: Paint::Colour([0; 3]),
            fill_opacity: 1.0,
            stroke: Paint::None,
            stroke_opacity: 1.0,
            width: 1.0,
            opacity: 1.0,
            visible: true,
        }
    }
}

impl Ink {
    /// The style of `node` inside an element with this style; `None` if it is not displayed. `path` is what the
    /// rules look at: the tags from the root to the node.
    pub(super) fn inside(&self, node: Node<'_, '_>, rules: &[Rule<'_>], path: &[Tag]) -> Option<Self> {
        let mut out = *self;
        let mut displayed = true;
        let mut set = |key: &str, value: &str| out.set(key, value, self, &mut displayed);
        node.attributes().filter(|a| a.namespace().is_none()).for_each(|a| set(a.name(), a.value()));
        for rule in rules.iter().filter(|rule| rule.fits(path)) {
            rule.properties.iter().for_each(|(key, value)| set(key, value));
        }
        let style = node.attribute("style").unwrap_or("");
        style.split(';').filter_map(|part| part.split_once(':')).for_each(|(key, value)| set(key.trim(), value));
        displayed.then_some(out)
    }

    fn set(&mut self, key: &str, value: &str, around: &Self, displayed: &mut bool) {
        let value = value.trim().trim_end_matches("!important").trim_end();
        let inherits = value == "inherit";
        match key {
            "display" => *displayed = value != "none",
            "visibility" if inherits => self.visible = around.visible,
            "visibility" => self.visible = value == "visible",
            "fill" if inherits => self.fill = around.fill,
            "fill" => self.fill = paint(value),
            "stroke" if inherits => self.stroke = around.stroke,
            "stroke" => self.stroke = paint(value),
            "stroke-width" => self.width = numbers::length(value).unwrap_or(around.width),
            "fill-opacity" => self.fill_opacity = fraction(value).unwrap_or(around.fill_opacity),
            "stroke-opacity" => self.stroke_opacity = fraction(value).unwrap_or(around.stroke_opacity),
            // The one property that adds up instead of being handed down.
            "opacity" => self.opacity = around.opacity * fraction(value).unwrap_or(1.0),
            _ => {}
        }
    }

    /// Why a line of this style cannot be seen.
    pub(super) fn hidden_stroke(&self, paper: [u8; 3]) -> Option<Hidden> {
        match self.stroke {
            _ if !self.visible => Some(Hidden::Switched),
            Paint::None => Some(Hidden::NoStroke),
            _ if self.width <= 0.0 => Some(Hidden::NoWidth),
            stroke => faint(stroke, self.stroke_opacity * self.opacity, paper),
        }
    }

    /// Why an area of this style cannot be seen.
    pub(super) fn hidden_fill(&self, paper: [u8; 3]) -> Option<Hidden> {
        match self.fill {
            _ if !self.visible => Some(Hidden::Switched),
            Paint::None => Some(Hidden::NoStroke),
            fill => faint(fill, self.fill_opacity * self.opacity, paper),
        }
    }

    /// Whether an area of this style is filled, if only with the colour of the paper. Hatches are decoration.
    pub(super) fn fills(&self) -> bool {
        let paints = matches!(self.fill, Paint::Colour(_) | Paint::Some);
        paints && self.visible && self.fill_opacity * self.opacity > 0.0
    }

    /// The colour of an area, if it is known and covers what is below.
    pub(super) fn covering(&self) -> Option<[u8; 3]> {
        match self.fill {
            Paint::Colour(colour) if self.visible && self.fill_opacity * self.opacity > 0.99 => Some(colour),
            _ => None,
        }
    }
}

fn faint(paint: Paint, opacity: f64, paper: [u8; 3]) -> Option<Hidden> {
    if opacity <= 0.0 {
        return Some(Hidden::Transparent);
    }
    let Paint::Colour(colour) = paint else { return None };
    let contrast = colour.iter().zip(paper).map(|(&a, b)| a.abs_diff(b)).max().unwrap_or(0);
    (f64::from(contrast) * opacity.min(1.0) < FAINT).then_some(Hidden::Paper)
}

fn fraction(text: &str) -> Option<f64> {
    match text.strip_suffix('%') {
        Some(percent) => numbers::length(percent).map(|p| p / 100.0),
        None => numbers::length(text),
    }
}

fn paint(text: &str) -> Paint {
    let text = text.trim().to_ascii_lowercase();
    if let Some(digits) = text.strip_prefix('#') {
        return hexadecimal(digits).unwrap_or(Paint::Some);
    }
    if text.starts_with("url(") {
        return Paint::Pattern;
    }
    if let Some(inside) = text.strip_prefix("rgb(").and_then(|rest| rest.strip_suffix(')')) {
        return match numbers::list(inside).as_deref() {
            Some(&[r, g, b]) => Paint::Colour([r, g, b].map(|c| c.clamp(0.0, 255.0) as u8)),
            _ => Paint::Some,
        };
    }
    match text.as_str() {
        "none" | "transparent" => Paint::None,
        "white" => Paint::Colour([255; 3]),
        "snow" => Paint::Colour([255, 250, 250]),
        "ivory" => Paint::Colour([255, 255, 240]),
        "whitesmoke" => Paint::Colour([245; 3]),
        "black" => Paint::Colour([0; 3]),
        _ => Paint::Some,
    }
}

/// `abc`, `abcd`, `aabbcc` or `aabbccdd`.
fn hexadecimal(digits: &str) -> Option<Paint> {
    let short = matches!(digits.len(), 3 | 4);
    if !(short || matches!(digits.len(), 6 | 8)) || !digits.is_ascii() {
        return None;
    }
    let width = if short { 1 } else { 2 };
    let parts = (0..digits.len() / width).map(|i| u8::from_str_radix(&digits[i * width..(i + 1) * width], 16));
    let parts: Vec<u8> = parts.collect::<Result<_, _>>().ok()?;
    let part = |i: usize| if short { parts[i] * 17 } else { parts[i] };
    if parts.get(3) == Some(&0) {
        return Some(Paint::None);
    }
    Some(Paint::Colour([part(0), part(1), part(2)]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paints_that_matter_are_understood() {
        for white in ["#fff", "#FFFFFF", " white ", "rgb(255, 255 255)", "#ffffffff"] {
            assert_eq!(paint(white), Paint::Colour([255; 3]), "{white}");
        }
        for none in ["none", "transparent", "#0000", "#12345600"] {
            assert_eq!(paint(none), Paint::None, "{none}");
        }
        assert_eq!(paint("url(#hatch)"), Paint::Pattern);
        for other in ["teal", "#12", "#ggg", "rgb(1,2)", "#é1", "currentColor"] {
            assert_eq!(paint(other), Paint::Some, "{other}");
        }
    }

    #[test]
    fn pale_lines_are_seen_until_they_are_as_pale_as_the_paper() {
        let line = |stroke: &str, opacity: f64| Ink { stroke: paint(stroke), opacity, ..Ink::default() };
        let white = [255; 3];
        assert_eq!(line("#fff", 1.0).hidden_stroke(white), Some(Hidden::Paper));
        assert_eq!(line("#fff", 1.0).hidden_stroke([20; 3]), None);
        assert_eq!(line("#eee", 1.0).hidden_stroke(white), None);
        assert_eq!(line("#eee", 0.2).hidden_stroke(white), Some(Hidden::Paper));
        assert_eq!(line("black", 0.0).hidden_stroke(white), Some(Hidden::Transparent));
        assert_eq!(Ink::default().hidden_stroke(white), Some(Hidden::NoStroke));
    }
}
