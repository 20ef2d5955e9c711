//! Values that browsers work out and a comparison does not are refused, and lines too thin to be seen are told.

use super::refused;
use super::seen::{equal, plain, says, within};

/// The drawing with a style on all lines.
fn styled(style: &str) -> String {
    plain().replace("stroke=\"black\"", &format!("stroke=\"black\" style=\"{style}\""))
}

#[test]
fn values_that_are_not_worked_out_are_refused() {
    for style in [
        "stroke: var(--c)",
        "stroke: env(x, none)",
        "stroke: color(srgb 0 0 0 / 0)",
        "stroke: color-mix(in srgb, black 0%, red)",
        "stroke: oklch(0 0 0 / 0%)",
        "stroke: rgb(0 0 0 / calc(0))",
        "stroke: rgb(0 0 0 / none)",
        "stroke: context-stroke",
        "stroke: canvas",
        "stroke-width: calc(1px - 1px)",
        "stroke-width: min(0px, 1px)",
        "stroke-width: 0%",
        "stroke-dasharray: 0em 999em",
        "stroke-dasharray: calc(0px) 9999px",
        "stroke-dasharray: 0% 300%",
        "opacity: calc(0)",
        "display: contents",
        "visibility: var(--v)",
        "all: unset",
    ] {
        let error = refused(&styled(style));
        assert!(error.contains("is not worked out here"), "{style}: {error}");
        assert!(error.contains(&format!("`{}", style.split(' ').next().unwrap())), "{style}: {error}");
    }
    let faces = within("<style>polygon{fill:var(--none,none)}</style>", "<polygon points=\"0,0 9,0 9,9\"/>");
    assert!(refused(&faces).contains("`fill: var(--none,none)` is not worked out here"));
    // A later word wins, and what is no value is passed over.
    for style in ["stroke:var(--c);stroke:red", "stroke:blurple", "fill:rgb(1,2)", "stroke-width:thin"] {
        equal(&styled(style));
    }
    equal(&styled("font-family:var(--f);color:var(--c);stroke:light-dark(navy, white);stroke-width:inherit"));
    equal(&within("", "<text style=\"fill:var(--ink)\" x=\"9\" y=\"390\">caption</text>"));
}

#[test]
fn words_for_values_that_nobody_has_set_are_read() {
    for style in ["stroke:initial", "stroke:unset", "stroke:revert", "stroke:light-dark(transparent, black)"] {
        says(&styled(style), "they have no stroke");
    }
    says(&styled("stroke:hwb(0 0% 0% / 0)"), "they have no stroke");
    says(&styled("stroke:hwb(0 100% 0%)"), "they have the colour of the paper");
    equal(&styled("stroke-width:initial;opacity:unset;stroke-dasharray:revert;visibility:initial;display:unset"));
    let around = |style: &str, own: &str| {
        within(&format!("<g style=\"{style}\">"), "</g>")
            .replace("stroke=\"black\"", &format!("stroke=\"black\" {own}"))
    };
    says(&around("stroke-dasharray:0 9999", "style=\"stroke-dasharray:inherit\""), "their dashes leave them out");
    says(&around("visibility:hidden", "style=\"visibility:unset\""), "their visibility is hidden");
}

#[test]
fn style_sheets_outside_of_the_file_are_refused() {
    let plain = plain();
    for sheet in
        ["<?xml-stylesheet href=\"a.css\"?>", "<?xml-stylesheet type=\"text/css\" href=\"data:text/css,*{}\"?>"]
    {
        let error = refused(&plain.replacen("<svg", &format!("{sheet}<svg"), 1));
        assert!(error.contains("<?xml-stylesheet?> brings in a style sheet from outside"), "{error}");
    }
    let link =
        |rel: &str| within(&format!("<link xmlns=\"http://www.w3.org/1999/xhtml\" rel=\"{rel}\" href=\"a.css\"/>"), "");
    assert!(refused(&link("StyleSheet")).contains("<link> brings in a style sheet from outside"));
    equal(&link("author"));
    equal(&plain.replacen("<svg", "<?page size=\"a4\"?><svg", 1));
}

#[test]
fn lines_too_thin_to_be_seen_are_told() {
    for width in ["0.0001", "0.01", "0.04", "0.001mm"] {
        says(&styled(&format!("stroke-width:{width}")), "33 edges cannot be seen, their lines are thinner than 0.1 px");
    }
    for width in ["0.06", "0.3", "1"] {
        equal(&styled(&format!("stroke-width:{width}")));
    }
    // Where widths are not scaled, they are px of the screen.
    says(&styled("stroke-width:.05;vector-effect:non-scaling-stroke"), "their lines are thinner than 0.1 px");
    let sized = |size: &str| plain().replacen("viewBox", &format!("{size} viewBox"), 1);
    let thin = |svg: String| svg.replace("stroke=\"black\"", "stroke=\"black\" stroke-width=\".06\"");
    says(&thin(sized("width=\"600\" height=\"400\"")), "their lines are thinner than 0.1 px");
    equal(&thin(sized("width=\"6000\" height=\"4000\"")));
}
