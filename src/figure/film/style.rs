//! The style rules of films: what is new, what has gone, and one frame at a time.
//!
//! ```text
//!   .made  blue, bold      .gone  red, dashed 3 2.5      .dim  grey
//!
//!   screen with :has       one frame: the target of the link, else the first
//!   no style, print        all frames, in rows
//! ```

use crate::figure::canvas::number::drawn;
use crate::figure::canvas::style::{Palette, Style, rule};
use crate::figure::canvas::vector::Xy;
use std::fmt::Write;

/// The rules of new and gone things, scoped like those of the style.
pub(super) fn marks(style: &Style, scope: &str) -> String {
    let mut out = String::new();
    let width = drawn(1.5 * style.shaft_width);
    for (selector, properties) in [
        (".made .sh", format!("stroke-width:{width}")),
        (".made .hl", "font-weight:700".to_owned()),
        (".made .pl", "stroke-width:2.4".to_owned()),
        (".gone .sh", "stroke-dasharray:3 2.5".to_owned()),
        (".gone .pl", "stroke-dasharray:3 2.5".to_owned()),
        (".gone .vd", "stroke-dasharray:3 2.5".to_owned()),
        (".chips .cb", "stroke-width:1.5;stroke-dasharray:3 2".to_owned()),
        (".chips .cl", "font-weight:700".to_owned()),
        (".nav", "text-decoration:underline".to_owned()),
    ] {
        rule(&mut out, scope, selector, &properties);
    }
    style.in_both(&mut out, |out, palette| colours(out, scope, palette));
    out
}

fn colours(out: &mut String, scope: &str, palette: &Palette) {
    for (class, colour) in [("made", palette.next), ("gone", palette.wrong), ("dim", palette.dim)] {
        for (part, property) in [("pl", "stroke"), ("ph", "fill")] {
            let _ = writeln!(out, "#{scope} .{class} .{part}{{{property}:{colour}}}");
        }
    }
    for (class, colour) in [("made", palette.next), ("gone", palette.wrong)] {
        for (part, property) in [("sh", "stroke"), ("barb", "fill"), ("hl", "fill"), ("vd", "stroke")] {
            let _ = writeln!(out, "#{scope} .{class} .{part}{{{property}:{colour}}}");
        }
    }
    let _ = writeln!(out, "#{scope} .chips .cb{{fill:{};stroke:{}}}", palette.background, palette.next);
    let _ = writeln!(out, "#{scope} .chips .cl{{fill:{}}}", palette.next);
    let _ = writeln!(out, "#{scope} .nav{{fill:{}}}", palette.next);
}

/// The rules that show one frame of the size `frame` out of a sheet of the size `sheet`.
///
/// The root keeps the view box of the whole sheet, so that the sheet is right where these rules are not known. On
/// a small root, `slice` shrinks that box; the frame is enlarged by as much.
pub(super) fn stepper(scope: &str, sheet: Xy, frame: Xy) -> String {
    let enlarged = 1.0 / (frame.x / sheet.x).max(frame.y / sheet.y);
    format!(
        "@supports selector(:has(a)){{@media screen{{\n\
         #{scope}{{width:{}px;height:{}px}}\n\
         #{scope} .fr{{display:none;transform:scale({enlarged})}}\n\
         #{scope} .fr:target{{display:inline}}\n\
         #{scope}:not(:has(.fr:target)) .first{{display:inline}}\n\
         }}}}\n@media print{{#{scope} .nav{{display:none}}}}\n",
        drawn(frame.x),
        drawn(frame.y)
    )
}
