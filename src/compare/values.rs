//! Values that browsers work out and a comparison does not.
//!
//! ```text
//!   stroke: blurple            no value at all: browsers pass it over (valid.rs)
//!   stroke: var(--line)        a value, and who knows which: refused
//!   stroke: initial            `none`, as if nobody had said anything
//! ```

use super::colour::{Paint, paint};
use super::error::{Fault, Problem, quoted};
use super::numbers::Reader;
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
/// Units that depend on letters, windows or sides. Some have a letter before them: `rem`, `svh`, `dvw`.
const UNITS: [&str; 15] =
    ["%", "em", "ex", "ch", "cap", "ic", "lh", "vw", "vh", "vmin", "vmax", "vi", "vb", "cqw", "cqh"];
/// More dashes than this are not read: each line would be measured against all of them.
const DASHES: usize = 256;
/// Functions of colours.
#[rustfmt::skip]
const OF_COLOURS: [&str; 15] = [
    "rgb", "rgba", "hsl", "hsla", "hwb", "lab", "lch", "oklab", "oklch", "color", "color-mix", "device-cmyk",
    "contrast-color", "light-dark", "alpha",
];
/// Colours that the reader's system or the place in the file says.
#[rustfmt::skip]
const OF_SYSTEMS: [&str; 45] = [
    "accentcolor", "accentcolortext", "activeborder", "activecaption", "activetext", "appworkspace", "background",
    "buttonborder", "buttonface", "buttonhighlight", "buttonshadow", "buttontext", "canvas", "canvastext",
    "captiontext", "context-fill", "context-stroke", "field", "fieldtext", "graytext", "highlight", "highlighttext",
    "inactiveborder", "inactivecaption", "inactivecaptiontext", "infobackground", "infotext", "linktext", "mark",
    "marktext", "menu", "menutext", "scrollbar", "selecteditem", "selecteditemtext", "threeddarkshadow", "threedface",
    "threedhighlight", "threedlightshadow", "threedshadow", "visitedtext", "window", "windowframe", "windowtext",
    "-webkit-link",
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
        "opacity" | "fill-opacity" | "stroke-opacity" | "stop-opacity" => value.contains('('),
        "stroke-width" | "stroke-dasharray" | "stroke-dashoffset" => {
            let parts = || value.split([',', ' ']);
            value.contains('(') || parts().any(depends) || parts().count() > DASHES
        }
        // A part of the size around is worked out.
        "font-size" => value.contains('(') || !has(&["em", "%"]) && depends(&value),
        // Names of families may hold brackets in quotes.
        "font" => value.split(['"', '\'']).next().is_some_and(|size| size.contains('(')),
        _ => changes_looks(key) && has(&ANYTHING),
    }
}

/// The fault of a value that is not worked out, at this place.
pub(super) fn unworked(offset: usize, key: &str, value: &str) -> Fault {
    let such = match key {
        "display" => "none or inline",
        "font-size" | "font" => "12px",
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
    let is_number = reader.number().is_some();
    let unit = reader.rest();
    is_number
        && (UNITS.contains(&unit) || unit.strip_prefix(['r', 's', 'l', 'd']).is_some_and(|unit| UNITS.contains(&unit)))
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
