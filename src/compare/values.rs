//! Values that browsers work out and a comparison does not.
//!
//! ```text
//!   stroke: blurple            no value at all: browsers pass it over
//!   stroke: var(--line)        a value, and who knows which: refused
//!   stroke: initial            `none`, as if nobody had said anything
//! ```

use super::colour::{Paint, paint};
use super::error::{Fault, Problem, quoted};
use super::numbers::{Reader, measure};
use crate::figure::canvas::untold::changes_looks;

/// Values of properties that nobody has set, and whether they are handed down to children.
const INITIAL: [(&str, &str, bool); 13] = [
    ("color", "black", true),
    ("display", "inline", false),
    ("fill", "black", true),
    ("fill-opacity", "1", true),
    ("fill-rule", "nonzero", true),
    ("opacity", "1", false),
    ("stroke", "none", true),
    ("stroke-dasharray", "none", true),
    ("stroke-dashoffset", "0", true),
    ("stroke-linecap", "butt", true),
    ("stroke-opacity", "1", true),
    ("stroke-width", "1", true),
    ("visibility", "visible", true),
];

/// What stands in a value and may be anything.
const ANYTHING: [&str; 4] = ["var(", "env(", "attr(", "if("];
/// Functions of numbers.
const OF_NUMBERS: [&str; 8] = ["calc(", "min(", "max(", "clamp(", "abs(", "sign(", "round(", "mod("];
/// Units that depend on letters, windows or sides.
const UNITS: [&str; 14] = ["%", "em", "rem", "ex", "ch", "cap", "ic", "lh", "rlh", "vw", "vh", "vmin", "vmax", "vi"];
/// Functions of colours.
#[rustfmt::skip]
const OF_COLOURS: [&str; 15] = [
    "rgb", "rgba", "hsl", "hsla", "hwb", "lab", "lch", "oklab", "oklch", "color", "color-mix", "device-cmyk",
    "contrast-color", "light-dark", "alpha",
];
/// Colours that the reader's system or the place in the file says.
#[rustfmt::skip]
const OF_SYSTEMS: [&str; 26] = [
    "accentcolor", "accentcolortext", "activetext", "background", "buttonborder", "buttonface", "buttontext", "canvas",
    "canvastext", "context-fill", "context-stroke", "field", "fieldtext", "graytext", "highlight", "highlighttext",
    "linktext", "mark", "marktext", "menu", "menutext", "selecteditem", "selecteditemtext", "visitedtext", "window",
    "windowtext",
];

/// `initial`, `unset` and `revert` as the plain value they stand for, or as `inherit`.
pub(super) fn plainly<'v>(key: &str, value: &'v str) -> &'v str {
    let Some(&(_, initial, is_handed_down)) = INITIAL.iter().find(|(name, ..)| *name == key) else { return value };
    match value {
        "initial" => initial,
        "unset" | "revert" if is_handed_down => "inherit",
        "unset" | "revert" => initial,
        _ => value,
    }
}

/// Whether browsers may know this value of a property, and it is not worked out here.
pub(super) fn is_unread(key: &str, value: &str) -> bool {
    let value = value.to_ascii_lowercase();
    let has = |words: &[&str]| words.iter().any(|word| value.contains(word));
    if key == "all" || value == "revert-layer" && changes_looks(key) {
        return true;
    }
    match key {
        "fill" | "stroke" | "color" | "stop-color" => has(&ANYTHING) || is_unread_colour(&value),
        "background" | "background-color" => {
            has(&ANYTHING) || paint(&value) == Paint::Pattern || is_unread_colour(&value) || value.contains("gradient(")
        }
        "color-scheme" => value.contains("dark") && !value.contains("light"),
        "display" => has(&ANYTHING) || value == "contents",
        "opacity" | "fill-opacity" | "stroke-opacity" | "stop-opacity" => has(&ANYTHING) || has(&OF_NUMBERS),
        "stroke-width" | "stroke-dasharray" | "stroke-dashoffset" => {
            has(&ANYTHING) || has(&OF_NUMBERS) || value.split([',', ' ']).any(depends)
        }
        _ => changes_looks(key) && has(&ANYTHING),
    }
}

/// The fault of a value that is not worked out, at this place.
pub(super) fn unworked(offset: usize, key: &str, value: &str) -> Fault {
    let such = match key {
        "display" => "none or inline",
        "stroke-width" | "stroke-dasharray" | "stroke-dashoffset" => "a number of px",
        "opacity" | "fill-opacity" | "stroke-opacity" | "stop-opacity" => "0.5",
        "fill" | "stroke" | "color" | "stop-color" | "background" | "background-color" => "black or #aabbcc",
        _ => "none",
    };
    Fault::at(offset, Problem::StyleValue { declaration: quoted(&format!("{key}: {value}")), such })
}

fn is_unread_colour(value: &str) -> bool {
    if paint(value) != Paint::Some {
        return false;
    }
    if let Some((name, inside)) = value.split_once('(') {
        // Three numbers too few are no colour, but a word may be one that browsers work out.
        let is_plain = ["rgb", "rgba", "hsl", "hsla", "hwb"].contains(&name);
        return OF_COLOURS.contains(&name) && (!is_plain || inside.contains(|c: char| c.is_ascii_alphabetic()));
    }
    OF_SYSTEMS.contains(&value)
}

/// Whether a length depends on letters, windows or sides.
fn depends(text: &str) -> bool {
    let mut reader = Reader::new(text);
    measure(text).is_none() && reader.number().is_some() && UNITS.contains(&reader.rest())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_browsers_work_out_is_told_from_what_they_pass_over() {
        for (key, value) in [
            ("stroke", "VAR(--a)"),
            ("stroke", "rgb(0 0 0 / none)"),
            ("fill", "canvas"),
            ("stroke-width", "1em"),
            ("stroke-dasharray", "0% 300%"),
            ("opacity", "calc(0)"),
            ("all", "unset"),
            ("marker", "var(--m)"),
            ("display", "contents"),
        ] {
            assert!(is_unread(key, value), "{key}: {value}");
        }
        for (key, value) in [
            ("stroke", "blurple"),
            ("stroke", "rgb(1,2)"),
            ("stroke", "hwb(0 0% 0% / 0)"),
            ("fill", "light-dark(red, blue)"),
            ("stroke-width", "thin"),
            ("stroke-dasharray", "none"),
            ("font-family", "var(--f)"),
            ("color-scheme", "light dark"),
        ] {
            assert!(!is_unread(key, value), "{key}: {value}");
        }
        assert_eq!((plainly("stroke", "initial"), plainly("stroke", "unset")), ("none", "inherit"));
        assert_eq!((plainly("opacity", "revert"), plainly("x", "initial")), ("1", "initial"));
    }
}
