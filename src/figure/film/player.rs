//! A page that plays a film.
//!
//! ```text
//!   ┌───────────────────────────────┐
//!   │ frame, as large as the window │     without a script: the stepper, with its links
//!   ├───────────────────────────────┤
//!   │ [‹ back] [next ›] [play] ──●──│     with one: buttons, keys, a slider; the address names the frame
//!   └───────────────────────────────┘
//! ```

use crate::figure::canvas::number::drawn;
use crate::figure::canvas::vector::Xy;
use crate::figure::{Figure, escaped};

const CSS: &str = include_str!("player.css");
const SCRIPT: &str = include_str!("player.js");

/// A frame is never shown at less than this part of its width, so that its letters can be read.
const LEAST: f64 = 0.95;

/// The page round a stepper whose frames have the size `frame`.
pub(super) fn page(stepper: &Figure, headings: &[String], frame: Xy) -> String {
    let (prefix, title) = (&stepper.scene.prefix, escaped(&stepper.scene.title));
    let css = CSS
        .replace("#FIG", &format!("#{prefix}"))
        .replace("RATIO", &drawn(frame.x / frame.y))
        .replace("LEAST", &drawn(LEAST * frame.x))
        .replace("WIDTH", &drawn(2.0 * frame.x));
    let svg = stepper.to_svg();
    let last = headings.len().saturating_sub(1);
    let entry =
        |(i, heading): (usize, &String)| format!("<li><a href=\"#{prefix}-step-{i}\">{}</a></li>\n", escaped(heading));
    let list: String = headings.iter().enumerate().map(entry).collect();
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta name=\"color-scheme\" content=\"light dark\">\n<title>{title}</title>\n<style>\n{css}</style>\n</head>\n\
         <body data-film=\"{prefix}\">\n<h1>{title}</h1>\n<main>\n{svg}\
         <div class=\"controls\" hidden>\n\
         <button type=\"button\" id=\"back\">‹ back</button>\n<button type=\"button\" id=\"next\">next ›</button>\n\
         <button type=\"button\" id=\"play\" aria-pressed=\"false\">play</button>\n\
         <input type=\"range\" id=\"at\" min=\"0\" max=\"{last}\" value=\"0\" aria-label=\"Frame\">\n\
         <output id=\"count\" for=\"at\"></output>\n</div>\n\
         <p class=\"keys\" hidden>Keys: ← → one frame, Home End the first and the last, space plays.</p>\n\
         <details>\n<summary>All frames</summary>\n<ol>\n{list}</ol>\n</details>\n</main>\n\
         <script>\n{SCRIPT}</script>\n</body>\n</html>\n"
    )
}
