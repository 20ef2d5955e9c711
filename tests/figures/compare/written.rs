//! What a style says counts, however it is written, and what it says of the whole drawing, too.

use super::refused;
use super::seen::{equal, plain, says, within};

/// The drawing with a style on all lines.
fn styled(style: &str) -> String {
    plain().replace("stroke=\"black\"", &format!("stroke=\"black\" style=\"{style}\""))
}

#[test]
fn properties_are_read_in_capitals_behind_comments_and_with_marks() {
    for (style, said) in [
        ("STROKE:none", "they have no stroke"),
        ("stroke:NONE", "they have no stroke"),
        ("/* thin */stroke:none", "they have no stroke"),
        ("stroke:none ! important;stroke:red", "they have no stroke"),
        ("stroke:none!IMPORTANT", "they have no stroke"),
        ("Visibility: Hidden", "their visibility is hidden"),
    ] {
        says(&styled(style), said);
    }
    for style in ["mask-image:url(#m)", "mix-blend-mode:screen", "mask:url(#m);filter:none"] {
        assert!(refused(&styled(style)).contains("has a mask, a filter or a blend mode"), "{style}");
    }
    says(&styled("DISPLAY:None"), "33 differences, 0 of 33 edges agree");
    says(&within("<style>line{STROKE:None}</style>", ""), "they have no stroke");
    for style in ["/*stroke:none*/", "filter:url(#a);filter:none", "mix-blend-mode:normal", "-x-stroke:none"] {
        equal(&styled(style));
    }
    for rule in
        ["line:nth-child(n){STROKE:white}", "line:nth-child(n){Stroke:None}", "@media (min-width:1px){line{R:9px}}"]
    {
        let error = refused(&within(&format!("<style>{rule}</style>"), ""));
        assert!(error.contains("the style rule `"), "{rule}: {error}");
    }
    // Attributes are as they are written.
    equal(&plain().replace("stroke=\"black\"", "stroke=\"black\" STROKE=\"none\""));
    let cut = "<clipPath id=\"Cut\"><rect width=\"9\" height=\"9\"/></clipPath>";
    says(
        &within(cut, "").replace("stroke=\"black\"", "stroke=\"black\" style=\"clip-path:URL(#Cut)\""),
        "cuts them off",
    );
}

#[test]
fn escaped_letters_are_letters() {
    for style in [r"str\6f ke:none", r"\73troke:n\00006Fne", r"s\troke:\none", r"stroke:\6eone/**/"] {
        says(&styled(style), "they have no stroke");
    }
    says(&within(r"<style>l\69ne{str\6fke:none}</style>", ""), "they have no stroke");
    for harmless in [r"font-family:'\3b stroke:none'", r"-x-\73troke:none", r"font-family:\"] {
        equal(&styled(harmless));
    }
    // A class whose name holds a mark: whom the rule fits is not told.
    let error = refused(&within(r"<style>.thin\:line{stroke:none}</style>", ""));
    assert!(error.contains(r"the style rule `.thin\"), "{error}");
    equal(&within(r"<style>.thin\:line{font-size:9px}</style>", ""));
}

#[test]
fn properties_that_move_or_cut_and_are_not_read_are_refused() {
    for (style, said) in [
        ("translate:40px 0", "`translate: 40px 0` is no property that is read here: write a transform"),
        ("rotate:9deg", "`rotate: 9deg` is no property"),
        ("scale:0", "`scale: 0` is no property"),
        ("offset-path:path('M0 0h9')", "`offset-path: path('m0 0h9')` is no property"),
        ("transform:rotate(9deg);transform-origin:300px 200px", "`transform-origin: 300px 200px` is no property"),
        ("clip-path:inset(50%)", "`inset(50%)` is no clip path here: write url(#...)"),
        ("-webkit-clip-path:circle(0)", "`circle(0)` is no clip path"),
    ] {
        let error = refused(&styled(style));
        assert!(error.to_lowercase().contains(&said.to_lowercase()), "{style}: {error}");
    }
    for style in ["translate:none", "scale:1", "transform-origin:center", "transform:none;transform-origin:0 0"] {
        equal(&styled(style));
    }
    equal(&within("", "<text rotate=\"45\" x=\"9\" y=\"390\">caption</text>"));
}

#[test]
fn the_colour_behind_it_all_is_the_paper() {
    let on = |ground: &str, stroke: &str| {
        let svg = plain().replacen("<svg ", &format!("<svg style=\"background:{ground}\" "), 1);
        svg.replace("stroke=\"black\"", &format!("stroke=\"{stroke}\"")).replace("r=\"4\"/>", "r=\"4\" fill=\"gold\"/>")
    };
    says(&on("black", "black"), "33 edges cannot be seen, they have the colour of the paper");
    says(&on("gold", "black"), "22 vertices have the colour of the paper");
    equal(&on("black", "white"));
    equal(&on("#123", "navy"));
    equal(&on("transparent", "black"));
    says(&on("none", "white"), "they have the colour of the paper");
    let by_rule = within("<style>svg{background-color:#000}</style>", "");
    says(&by_rule, "33 edges cannot be seen, they have the colour of the paper");
    says(&by_rule.replacen(" viewBox=\"0 0 600 400\"", "", 1), "they have the colour of the paper");
}

#[test]
fn a_picture_without_a_size_is_refused() {
    let error = refused(&within("", "<image href=\"a.png\" x=\"9\" height=\"4\"/>"));
    assert!(error.contains("`auto` is no width or height of a picture here: write both as numbers"), "{error}");
    equal(&within("", "<image x=\"9\"/>"));
}
