//! Values that browsers drop because they are none of their property: as if they were not written, so that what stands
//! below them holds.
//!
//! ```text
//!   stroke="none" style="stroke:blackish"      no stroke: there is no such colour
//!   .a{opacity:0} .b{opacity:high}             an opacity of 0
//!   <circle r="4" style="r:9"/>                a radius of 4: in a style a length has a unit
//! ```

use super::colour::{Paint, paint};
use super::geometry::is_geometry;
use super::numbers::{Reader, fraction, measure};
use super::values::is_unread;

/// Where a value is written: places and sizes need a unit in a style, and none in an attribute.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Written {
    Attribute,
    Style,
}

/// Words that every property knows.
const WORDS: [&str; 5] = ["inherit", "initial", "unset", "revert", "revert-layer"];
const DISPLAYS: [&str; 22] = [
    "block",
    "inline",
    "inline-block",
    "contents",
    "list-item",
    "flow",
    "flow-root",
    "flex",
    "inline-flex",
    "grid",
    "inline-grid",
    "ruby",
    "math",
    "table",
    "inline-table",
    "table-row",
    "table-cell",
    "table-column",
    "table-caption",
    "table-row-group",
    "table-header-group",
    "table-footer-group",
];
const BLENDS: [&str; 18] = [
    "normal",
    "multiply",
    "screen",
    "overlay",
    "darken",
    "lighten",
    "color-dodge",
    "color-burn",
    "hard-light",
    "soft-light",
    "difference",
    "exclusion",
    "hue",
    "saturation",
    "color",
    "luminosity",
    "plus-lighter",
    "plus-darker",
];
const FILTERS: [&str; 11] = [
    "url(",
    "blur(",
    "brightness(",
    "contrast(",
    "drop-shadow(",
    "grayscale(",
    "hue-rotate(",
    "invert(",
    "opacity(",
    "saturate(",
    "sepia(",
];

/// Whether browsers keep this value of a property, written in small letters. Of properties that are not read, and of
/// those whose values are checked where they are read, nothing is said.
pub(super) fn is_valid(key: &str, value: &str, written: Written) -> bool {
    let key = key.strip_prefix("-webkit-").unwrap_or(key);
    if WORDS.contains(&value) || is_unread(key, value) {
        return true;
    }
    let is = |words: &[&str]| words.contains(&value);
    let are = |words: &[&str]| value.split_whitespace().all(|word| words.contains(&word));
    match key {
        "display" => is(&["none"]) || is_display(value),
        "visibility" => is(&["visible", "hidden", "collapse"]),
        "fill" | "stroke" => is_paint(value),
        "color" | "stop-color" | "background-color" => is_colour(value),
        // Of several words, some say something else than the colour.
        "background" => value.contains([' ', '(', ',']) || value == "none" || is_colour(value),
        "fill-rule" | "clip-rule" => is(&["nonzero", "evenodd"]),
        "stroke-linecap" => is(&["butt", "round", "square"]),
        "stroke-width" => measure(value).is_some_and(|width| width >= 0.0),
        "stroke-dashoffset" => measure(value).is_some(),
        "stroke-dasharray" => is(&["none"]) || are_dashes(value),
        "opacity" | "fill-opacity" | "stroke-opacity" | "stop-opacity" => fraction(value).is_some(),
        "mix-blend-mode" => is(&BLENDS),
        "filter" => is(&["none"]) || FILTERS.iter().any(|start| value.starts_with(start)),
        "clip-path" | "mask-image" => is(&["none"]) || value.contains('(') || value.ends_with("-box"),
        "marker" | "marker-start" | "marker-mid" | "marker-end" => is(&["none"]) || value.starts_with("url("),
        "vector-effect" => is(&["none", "non-scaling-stroke", "non-scaling-size", "non-rotation", "fixed-position"]),
        "overflow" => !value.is_empty() && are(&["visible", "hidden", "clip", "scroll", "auto"]),
        "paint-order" => are(&["normal", "fill", "stroke", "markers"]),
        "text-anchor" => is(&["start", "middle", "end"]),
        _ if written == Written::Style && is_geometry(key) => is_place(key, value),
        _ => true,
    }
}

fn is_display(value: &str) -> bool {
    let mut words = value.split_whitespace();
    value.starts_with("-webkit-") || words.all(|word| DISPLAYS.contains(&word) || word.starts_with("table-column"))
}

/// Whether a value is a colour; `none` is none.
fn is_colour(value: &str) -> bool {
    value != "none" && !matches!(paint(value), Paint::Some | Paint::Pattern)
}

/// Whether a value is a paint: a colour, none, or a link with one of these behind it.
fn is_paint(value: &str) -> bool {
    match value.strip_prefix("url(") {
        Some(link) => {
            // Brackets within quotes are part of the name.
            let rest = match link.chars().next().filter(|quote| matches!(quote, '"' | '\'')) {
                Some(quote) => link[1..].split_once(quote).map_or("", |(_, rest)| rest),
                None => link,
            };
            let behind = rest.split_once(')').map_or("", |(_, behind)| behind.trim());
            behind.is_empty() || is_unread("fill", behind) || paint(behind) != Paint::Some
        }
        None => paint(value) != Paint::Some,
    }
}

fn are_dashes(value: &str) -> bool {
    let mut words = value.split(|c: char| c == ',' || c.is_whitespace()).filter(|word| !word.is_empty());
    words.all(|word| measure(word).is_some_and(|length| length >= 0.0))
}

/// Whether a value of a style says where something lies or how large it is: a length with a unit, or a word.
fn is_place(key: &str, value: &str) -> bool {
    if key == "d" {
        return value == "none" || value.contains('(');
    }
    let mut reader = Reader::new(value);
    match reader.number() {
        Some(number) => number == 0.0 || !reader.rest().is_empty(),
        None => value == "auto" || value.ends_with("-content") || value == "stretch" || value.contains('('),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_that_browsers_drop_are_told_from_those_that_they_keep() {
        for (key, value) in [
            ("stroke", "blackish"),
            ("stroke", ""),
            ("stroke", "12"),
            ("stroke", "#12"),
            ("stroke", "rgb(1,2)"),
            ("fill", "url(#a) blackish"),
            ("color", "none"),
            ("stop-color", "url(#a)"),
            ("stroke-opacity", "high"),
            ("opacity", "0.5px"),
            ("opacity", "foo"),
            ("display", "foo()"),
            ("display", "block none"),
            ("visibility", "shown"),
            ("stroke-width", "3furlong"),
            ("stroke-width", "-1"),
            ("stroke-width", "thin"),
            ("stroke-dasharray", "1 -1"),
            ("stroke-dasharray", "dashed"),
            ("stroke-dashoffset", "far"),
            ("stroke-linecap", "flat"),
            ("fill-rule", "odd"),
            ("filter", "blurry"),
            ("mix-blend-mode", "mix"),
            ("marker-end", "arrow"),
            ("overflow", "shown"),
            ("r", "9"),
            ("width", "wide"),
        ] {
            assert!(!is_valid(key, value, Written::Style), "{key}: {value}");
        }
        for (key, value) in [
            ("stroke", "inherit"),
            ("stroke", "var(--c)"),
            ("stroke", "url(#a) red"),
            ("stroke", "url('#a)') red"),
            ("fill", "currentcolor"),
            ("fill", "none"),
            ("color", "transparent"),
            ("opacity", "50%"),
            ("opacity", "calc(1)"),
            ("display", "inline flow-root"),
            ("display", "none"),
            ("stroke-width", "3"),
            ("stroke-width", "3em"),
            ("stroke-dasharray", "1, 2px"),
            ("stroke-dashoffset", "-3"),
            ("filter", "url(#f) blur(2px)"),
            ("mask", "anything"),
            ("r", "9px"),
            ("r", "0"),
            ("width", "50%"),
            ("width", "auto"),
            ("font-weight", "foo"),
        ] {
            assert!(is_valid(key, value, Written::Style), "{key}: {value}");
        }
        assert!(is_valid("r", "9", Written::Attribute));
    }
}
