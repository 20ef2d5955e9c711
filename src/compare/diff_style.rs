//! The style of the picture of differences.
//!
//! ```text
//!   .agree grey      .miss red, dashed 7 5      .extra blue, solid     so that it reads without colours, too
//! ```

use crate::figure::Style;
use crate::figure::canvas::number::drawn;
use crate::figure::canvas::style::{Colour, Palette, rule};
use std::fmt::Write;

/// Missing, too much, and the number on a badge: on white 5.9 : 1 and 5.9 : 1, on dark paper 6.6 : 1 and 7.7 : 1.
const LIGHT: [Colour; 3] = [Colour(0x00c8_102e), Colour(0x000b_5fc4), Colour(0x00ff_ffff)];
const DARK: [Colour; 3] = [Colour(0x00ff_7b72), Colour(0x006c_b4ff), Colour(0x0015_181d)];

/// Faces in the background.
pub(super) fn pale(style: &mut Style) {
    style.light.tint_opacity *= 0.06 / 0.13;
    if let Some(dark) = &mut style.dark {
        dark.tint_opacity *= 0.06 / 0.13;
    }
}

/// The rules, scoped like those of the style.
pub(super) fn css(style: &Style, scope: &str) -> String {
    let mut out = String::new();
    for (selector, properties) in [
        (".dl", "stroke-width:3;fill:none"),
        (".agree .dl", "stroke-width:2"),
        (".miss .dl", "stroke-dasharray:7 5"),
        (".outline", "stroke-width:2;fill:none;stroke-dasharray:7 5"),
        (".thread", "stroke-width:1;fill:none"),
        (".ring", "stroke-width:2.4;fill:none"),
        (".miss .pl", "stroke-width:2.2;stroke-dasharray:4 3"),
        (".extra .pl", "stroke-width:2.4"),
        (".bn", "font-weight:700"),
        (".hn", "font-weight:700;paint-order:stroke;stroke-width:.3em;stroke-linejoin:round"),
        (".ya", "fill-opacity:.16"),
        (".yl", "stroke-width:1.4;fill:none"),
        (".yh", "stroke-width:1;fill:none;stroke-dasharray:1 4"),
    ] {
        rule(&mut out, scope, selector, properties);
    }
    // The light palette comes first.
    let mut accents = LIGHT;
    style.in_both(&mut out, |out, palette| colours(out, scope, palette, std::mem::replace(&mut accents, DARK)));
    let _ = writeln!(out, "#{scope} .hot .sh{{stroke-width:{}}}", drawn(1.3 * style.shaft_width));
    out
}

fn colours(out: &mut String, scope: &str, palette: &Palette, [miss, extra, number]: [Colour; 3]) {
    let mut rule = |selector: &str, properties: String| rule(out, scope, selector, &properties);
    rule(".vd", format!("stroke:{}", palette.edge));
    rule(".vl", format!("fill:{}", palette.grey));
    rule(".fl", format!("fill:{}", palette.grey));
    rule(".agree .dl", format!("stroke:{}", palette.edge));
    rule(".bn", format!("fill:{number}"));
    rule(".hn", format!("fill:{};stroke:{}", palette.half_edge, palette.background));
    rule(".ya", format!("fill:{extra}"));
    rule(".yl", format!("stroke:{}", palette.ink));
    rule(".yh", format!("stroke:{}", palette.ink));
    rule(".yd", format!("fill:{}", palette.ink));
    for (mark, colour) in [("miss", miss), ("extra", extra)] {
        for part in ["dl", "outline", "thread", "ring", "pl"] {
            rule(&format!(".{mark} .{part}"), format!("stroke:{colour}"));
        }
        for part in ["disc", "badge", "ph"] {
            rule(&format!(".{mark} .{part}"), format!("fill:{colour}"));
        }
    }
}
