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

/// What is said of a style on all lines.
#[track_caller]
fn refuses(svg: &str, declaration: &str, such: &str) {
    let error = refused(svg);
    let said = format!("`{declaration}` is not worked out here, and it may change what is seen: write a plain value");
    assert!(error.contains(&said) && error.ends_with(&format!(", such as {such}")), "{declaration}: {error}");
}

#[test]
fn functions_of_anything_are_refused_in_all_that_is_read() {
    for (key, such) in [
        ("fill", "black or #aabbcc"),
        ("stroke", "black or #aabbcc"),
        ("opacity", "0.5"),
        ("fill-opacity", "0.5"),
        ("stroke-opacity", "0.5"),
        ("stroke-width", "a number of px"),
        ("stroke-dasharray", "a number of px"),
        ("stroke-dashoffset", "a number of px"),
        ("display", "none or inline"),
        ("visibility", "none"),
        ("marker-start", "none"),
    ] {
        for function in ["var(--a)", "env(a)", "attr(a)", "if(a)"] {
            let declaration = format!("{key}: {function}");
            refuses(&styled(&declaration), &declaration, such);
        }
    }
    for key in ["opacity", "fill-opacity", "stroke-opacity", "stroke-width", "stroke-dasharray", "stroke-dashoffset"] {
        for function in
            ["calc", "min", "max", "clamp", "abs", "sign", "round", "mod", "rem", "sin", "pow", "hypot", "log"]
        {
            let declaration = format!("{key}: {function}(0)");
            assert!(
                refused(&styled(&declaration)).contains(&format!("`{declaration}` is not worked out")),
                "{declaration}"
            );
        }
    }
    refuses(&styled("color:var(--c);stroke:currentColor"), "color: var(--c)", "black or #aabbcc");
    // In capitals, behind what is in brackets.
    assert!(refused(&styled("stroke:url(#none) VAR(--c)")).contains("is not worked out here"));
    let stops = |style: &str| {
        let stop = format!("<linearGradient id=\"g\"><stop style=\"{style}\"/></linearGradient>");
        within(&stop, "").replace("stroke=\"black\"", "stroke=\"url(#g) red\"")
    };
    for style in ["stop-color:var(--c)", "stop-color:oklch(0 0 0)", "stop-opacity:calc(0)"] {
        assert!(refused(&stops(style)).contains("is not worked out here"), "{style}");
    }
}

#[test]
fn lengths_in_letters_windows_and_sides_are_refused() {
    #[rustfmt::skip]
    let units = [
        "%", "em", "ex", "ch", "cap", "ic", "lh", "vw", "vh", "vmin", "vmax", "vi", "vb", "cqw", "cqh",
        "rem", "rlh", "svh", "lvw", "dvb",
    ];
    for unit in units {
        for declaration in [format!("stroke-width: 0{unit}"), format!("stroke-dashoffset: -7.5{unit}")] {
            refuses(&styled(&declaration), &declaration, "a number of px");
        }
        for dashes in [format!("0,999{unit}"), format!("0 999{unit}"), format!("0{unit},999")] {
            assert!(refused(&styled(&format!("stroke-dasharray: {dashes}"))).contains("is not worked out"), "{dashes}");
        }
    }
    for width in [".2px", ".1mm", ".01cm", ".01in", ".1pt", ".02pc", ".5q", ".2"] {
        equal(&styled(&format!("stroke-width:{width}")));
    }
    // No such units: browsers pass over what is written.
    equal(&styled("stroke-width:5blah"));
    equal(&styled("stroke-width:0xem"));
    // So many dashes as anybody writes.
    let dashes = |count: usize| styled(&format!("stroke-dasharray:{}", vec!["9"; count].join(" ")));
    equal(&dashes(256));
    assert!(refused(&dashes(257)).contains("is not worked out here"));
}

#[test]
fn colours_of_systems_and_of_other_spaces_are_refused() {
    #[rustfmt::skip]
    let systems = [
        "accentcolor", "accentcolortext", "activetext", "background", "buttonborder", "buttonface", "buttontext", "canvas",
        "canvastext", "context-fill", "context-stroke", "field", "fieldtext", "graytext", "highlight", "highlighttext",
        "linktext", "mark", "marktext", "menu", "menutext", "selecteditem", "selecteditemtext", "visitedtext", "window",
        "windowtext",
    ];
    #[rustfmt::skip]
    let functions = [
        "lab(0 0 0)", "lch(0 0 0)", "oklab(0 0 0)", "oklch(0 0 0)", "color(srgb 0 0 0)", "color-mix(in lab, red, red)",
        "device-cmyk(0 0 0 0)", "contrast-color(red)", "light-dark(lab(0 0 0), red)", "alpha(from red / 0)",
        "rgb(0 0 0 / none)", "rgba(from red r g b)", "hsl(0 0% 0% / none)", "hsla(none 0 0)", "hwb(from red h w b)",
    ];
    for colour in systems.iter().chain(&functions) {
        for key in ["stroke", "fill"] {
            let error = refused(&styled(&format!("{key}:{colour}")));
            assert!(error.contains(&format!("`{key}: {}", &colour[..3])), "{colour}: {error}");
        }
        let error = refused(&plain().replacen("<svg ", &format!("<svg style=\"background:{colour}\" "), 1));
        assert!(error.contains("`background: "), "{colour}: {error}");
    }
    // Too few numbers, or no colour at all, are passed over.
    for colour in ["rgb(1, 2)", "rgba(1, 2)", "hsl(1, 2)", "hsla(1, 2)", "hwb(1)", "windows", "unlab(0 0 0)"] {
        equal(&styled(&format!("stroke:{colour}")));
    }
    refuses(&styled("color:lab(0 0 0);stroke:currentColor"), "color: lab(0 0 0)", "black or #aabbcc");
}

#[test]
fn what_is_behind_it_all_is_a_plain_colour() {
    let on = |style: &str| plain().replacen("<svg ", &format!("<svg style=\"{style}\" "), 1);
    for key in ["background", "background-color"] {
        for value in ["var(--c)", "url(a.png)", "conic-gradient(red)", "canvastext"] {
            let declaration = format!("{key}: {value}");
            refuses(&on(&declaration), &declaration, "black or #aabbcc");
        }
        equal(&on(&format!("{key}:ivory")));
    }
    let dark = |scheme: &str| {
        on(&format!("color-scheme:{scheme}")).replace("stroke=\"black\"", "style=\"stroke:light-dark(black, white)\"")
    };
    refuses(&dark("dark"), "color-scheme: dark", "none");
    refuses(&dark("only dark"), "color-scheme: only dark", "none");
    for scheme in ["light dark", "dark light", "light", "normal"] {
        equal(&dark(scheme));
    }
    equal(&on("color-scheme:dark"));
}

#[test]
fn a_property_that_nobody_has_set_has_its_first_value_or_that_around() {
    // Around all lines: a style; on each: the property, and what that needs. Of `initial`, then of `unset` and `revert`:
    // what is said, if anything.
    for (around, key, own, initial, unset) in [
        ("color:white", "color", "stroke:currentColor", "", "they have the colour of the paper"),
        ("stroke:none", "stroke", "", "they have no stroke", "they have no stroke"),
        ("stroke:red", "stroke", "", "they have no stroke", ""),
        ("stroke-dasharray:0 9999", "stroke-dasharray", "", "", "their dashes leave them out"),
        ("stroke-dashoffset:9999", "stroke-dashoffset", "stroke-dasharray:9999", "", "their dashes leave them out"),
        (
            "stroke-linecap:round",
            "stroke-linecap",
            "stroke-width:2;stroke-dasharray:0 4",
            "their dashes leave them out",
            "",
        ),
        ("stroke-opacity:0", "stroke-opacity", "", "", "their opacity is 0"),
        ("stroke-width:0", "stroke-width", "", "", "their stroke-width is 0"),
        ("visibility:hidden", "visibility", "", "", "their visibility is hidden"),
        // These are not handed down.
        ("opacity:.15", "opacity", "", "", ""),
        ("display:inline", "display", "display:none", "", ""),
    ] {
        for (word, said) in [("initial", initial), ("unset", unset), ("revert", unset)] {
            let lines = format!("stroke=\"black\" style=\"{own};{key}:{word}\"");
            let svg = within("", "").replace("stroke=\"black\"", &lines);
            let first = svg.find("<line").unwrap();
            let last = svg.find("<circle").unwrap();
            let svg = format!("{}<g style=\"{around}\">{}</g>{}", &svg[..first], &svg[first..last], &svg[last..]);
            if said.is_empty() { equal(&svg) } else { says(&svg, said) }
        }
    }
    // The same of faces, which are drawn twice each.
    for (around, key, initial, unset) in [
        ("fill:none", "fill", "33 edges cannot be seen", "no face is filled"),
        ("fill:gold", "fill", "33 edges cannot be seen", ""),
        ("fill-opacity:0", "fill-opacity", "", "no face is filled"),
        ("fill-rule:evenodd", "fill-rule", "", "12 faces are not filled"),
    ] {
        for (word, said) in [("initial", initial), ("unset", unset), ("revert", unset)] {
            let mut svg = String::new();
            for line in plain().lines() {
                let Some(rest) = line.strip_prefix("<polygon points=\"") else {
                    svg += line;
                    continue;
                };
                let (points, rest) = rest.split_once('"').unwrap();
                let own = rest.replace("/>", &format!(" style=\"{key}:{word}\"/>"));
                svg += &format!("<g style=\"{around}\"><path d=\"M{points}zM{points}z\"{own}</g>");
            }
            if said.is_empty() { equal(&svg) } else { says(&svg, said) }
        }
    }
    // What is set layer by layer is not worked out, where it matters.
    for key in ["stroke", "fill", "display", "opacity"] {
        assert!(
            refused(&styled(&format!("{key}:revert-layer"))).contains(": revert-layer` is not worked out"),
            "{key}"
        );
    }
    equal(&styled("letter-spacing:revert-layer"));
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
    for sheet in ["@import \"data:text/css,line{stroke:none}\";", "@IMPORT url(DATA:text/css,line{stroke:none})"] {
        let error = refused(&within(&format!("<style>{sheet}</style>"), ""));
        assert!(error.contains("@import of data brings in a style sheet from outside"), "{error}");
    }
    equal(&within("<style>@import url(https://example.org/letters.css);text{font-family:x}</style>", ""));
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
