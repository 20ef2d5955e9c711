//! The style rules of pointers, marks, captions and tables: what a structure figure does not need.
//!
//! ```text
//!   .dim    grey: not what the drawing is about      .next .twin .outgoing .boundary .face-of
//!   .hot    bold: what it is about                   a colour each; face pointers are dashed, too
//! ```

use crate::figure::Style;
use crate::figure::canvas::number::drawn;
use crate::figure::canvas::style::{Palette, rule};

/// The rules, to be appended to those of the style. Scoped like those.
pub(crate) fn css(style: &Style, scope: &str) -> String {
    let mut out = String::new();
    let mut fixed = |selector: &str, properties: &str| rule(&mut out, scope, selector, properties);
    fixed(".pl", "stroke-width:1.7;fill:none");
    fixed(".boundary .pl", "stroke-dasharray:5 2.5");
    fixed(".face-of .pl", "stroke-dasharray:5 2.5");
    fixed(".tag", "font-style:italic;font-weight:700;paint-order:stroke;stroke-width:.24em;stroke-linejoin:round");
    fixed(".hot .sh", &format!("stroke-width:{}", drawn(1.9 * style.shaft_width)));
    fixed(".hot .hl", "font-weight:700");
    fixed(".ct", "font-weight:700;text-anchor:start");
    fixed(".cs", "text-anchor:start");
    fixed(".rec", "stroke-width:1.5");
    fixed(".rn", "font-weight:700");
    fixed(".key", "font-weight:700");
    fixed(".row.hot text", "font-weight:700");
    fixed(".f.hot .face", "fill-opacity:.35");
    fixed(".f.hot .fl", "text-decoration:underline");
    fixed(".rows text", "text-anchor:start");
    fixed(".hot .vd", "stroke-width:3");
    let halo = "font-weight:700;paint-order:stroke;stroke-width:.3em;stroke-linejoin:round";
    ["next", "twin", "origin", "face"].iter().for_each(|key| fixed(&format!(".k-{key}"), halo));
    fixed(".pn", "font-weight:700;paint-order:stroke;stroke-width:.3em;stroke-linejoin:round");
    style.in_both(&mut out, |out, palette| colours(out, scope, palette));
    out
}

fn colours(out: &mut String, scope: &str, palette: &Palette) {
    let mut rule = |selector: &str, properties: String| rule(out, scope, selector, &properties);
    let Palette { background, ink, half_edge, face, next, twin, origin, dim, grey, hit, .. } = palette;
    // Darker than elsewhere: an edge has to stand out against the strong tint of a face that is marked, too.
    rule(".edge", format!("stroke:{grey}"));
    rule(".dim .sh", format!("stroke:{dim}"));
    rule(".dim .barb", format!("fill:{dim}"));
    rule(".dim .hl", format!("fill:{grey}"));
    rule(".ct", format!("fill:{ink}"));
    rule(".cs", format!("fill:{ink}"));
    for class in [".cm", ".rn", ".key", ".val", ".owns .ph", ".mark"] {
        rule(class, format!("fill:{ink}"));
    }
    rule(".owns .pl", format!("stroke:{ink}"));
    rule(".rec", format!("fill:{background};stroke:{ink}"));
    rule(".head", format!("fill:{hit}"));
    rule(".hit", format!("fill:{hit}"));
    rule(".tag", format!("fill:{face};stroke:{background}"));
    rule(".pn", format!("fill:{half_edge};stroke:{background}"));
    for (class, colour) in [("next", next), ("twin", twin), ("origin", origin), ("face", face)] {
        rule(&format!(".k-{class}"), format!("fill:{colour};stroke:{background}"));
    }
    let outgoing = [("outgoing", origin), ("origin", origin)];
    for (class, colour) in
        [("next", next), ("twin", twin), ("boundary", face), ("face-of", face)].into_iter().chain(outgoing)
    {
        rule(&format!(".{class} .pl"), format!("stroke:{colour}"));
        rule(&format!(".{class} .ph"), format!("fill:{colour}"));
    }
}
