//! Style sheets as browsers read them: for which media they are, strings in them, sizes of letters by names.

use super::seen::{equal, plain, says, within};
use super::{judge, refused};
use dcel_kit::compare::Layer;

/// The drawing with a style sheet.
fn sheet(attributes: &str, rules: &str) -> String {
    within(&format!("<style {attributes}>{rules}</style>"), "")
}

/// What hides all edges.
const HIDES: &str = "line{stroke:none}";

#[test]
fn a_style_sheet_for_other_media_is_passed_over() {
    for media in ["print", "tv", "only print", "speech, braille", "projection and (min-width: 9px)", " PRINT "] {
        equal(&sheet(&format!("media=\"{media}\""), HIDES));
        equal(&sheet("", &format!("@media {media}{{{HIDES}}}")));
    }
    for media in ["screen", "all", "", "only screen", "print, screen", "tv,all", "Screen"] {
        says(&sheet(&format!("media=\"{media}\""), HIDES), "they have no stroke");
    }
    says(&sheet("media=\"screen\"", "line{stroke:white}"), "they have the colour of the paper");
    // The sheets of one file are read each for its own media.
    says(
        &within(&format!("<style media=\"print\">circle{{r:0}}</style><style>{HIDES}</style>"), ""),
        "they have no stroke",
    );
    equal(&within(&format!("<style media=\"print\">{HIDES}</style><style>line{{stroke-linecap:butt}}</style>"), ""));
    equal(&within(&format!("<style media=\"print\">{HIDES} /* </style><style media=\"tv\">*/ {HIDES}</style>"), ""));
    for media in ["(min-width: 9px)", "not print", "not tv", "screen and (color)"] {
        let error = refused(&sheet(&format!("media=\"{media}\""), HIDES));
        assert!(error.contains(&format!("the style rule `@media {media}` ")), "{media}: {error}");
        assert!(error.contains("whether it applies is not worked out here: write its rules outside of it"), "{error}");
    }
    equal(&sheet("media=\"(min-width: 9px)\"", "text{font-weight:bold}"));
}

#[test]
fn what_a_reader_supports_is_not_worked_out() {
    for condition in ["not (fill:red)", "(fill:red)", "not (x:y)", "(fill:red) or (x:y)"] {
        let error = refused(&sheet("", &format!("@supports {condition}{{line{{stroke:white}}}}")));
        assert!(error.contains(&format!("the style rule `@supports {condition}` changes")), "{error}");
        assert!(error.contains("whether it applies is not worked out here: write its rules outside of it"), "{error}");
        equal(&sheet("", &format!("@supports {condition}{{text{{font-weight:bold}}}}")));
    }
}

#[test]
fn marks_in_strings_part_nothing() {
    for rules in [
        ".x{font-family:\".d{stroke:none}\"}",
        ".x::after{content:\"}\"}",
        ".x::after{content:'{'}",
        ".x{content:\"line{stroke:none}\"}",
        ".x{content:'}line{stroke:none}'}",
        "line{font-family:\"a;stroke:none;b\"}",
        "line{font-family:'}'}circle{font-family:'{'}",
        ".x{cursor:url(a;b})}",
        ".x{cursor:url( 'a)}line{stroke:none}' )}",
        ".x[id='{']{stroke:none}",
        "@import \"a;b{c\";.x{content:\"/*\"}",
    ] {
        equal(&sheet("", rules));
    }
    for rules in [
        ".x{content:\"}\"}line{stroke:none}",
        ".x{content:\"{\"}line{stroke:none}",
        ".x{content:\"/*\"}line{stroke:none}.y{content:\"*/\"}",
        ".x{content:'\\'}line{fill:red}'}line{stroke:none}",
        ".x{content:\"it's\"}line{stroke:none}.y{content:\"it's\"}",
        ".x{cursor:url(a;b})}line{stroke:none}",
        ".x{cursor:url(/*)}line{stroke:none}.y{cursor:url(*/)}",
        // A string ends with its line, if nothing says otherwise.
        ".x{content:\"abc\n}line{stroke:none}",
        "/* it's */line{stroke:none}/* it's */",
        "line{font-family:\"a;b\";stroke:none}",
    ] {
        says(&sheet("", rules), "they have no stroke");
    }
    let styled = |style: &str| plain().replace("stroke=\"black\"", &format!("stroke=\"black\" style=\"{style}\""));
    says(&styled("font-family:'/*';stroke:none;quotes:'*/'"), "they have no stroke");
    says(&styled("font-family:'a;b';stroke:none"), "they have no stroke");
    equal(&styled("font-family:'a;stroke:none;b'"));
    equal(&styled("cursor:url(a;stroke:none;b)"));
}

#[test]
fn a_byte_order_mark_makes_other_bytes() {
    let (plain, marked) = (plain(), format!("\u{feff}{}", plain()));
    for (reference, student) in [(&plain, &marked), (&marked, &plain)] {
        let answer = judge(reference, student);
        assert!(answer.is_equal() && answer.layer() == Layer::Drawn, "{}", answer.text());
    }
    assert_eq!(judge(&marked, &marked).layer(), Layer::Bytes);
    assert_eq!(judge(&plain, &plain).layer(), Layer::Bytes);
}

#[test]
fn sizes_of_letters_by_names_are_looked_up() {
    let text = |style: &str| within("", &format!("<text x=\"20\" y=\"390\" style=\"{style}\">MM</text>"));
    says(&text("--a:500px;font-size:var(--a)"), "make the text smaller");
    says(&text("font-size:var(--a);--a:500px"), "make the text smaller");
    says(&text("font-size:var( --b , 500px )"), "make the text smaller");
    says(&text("--a:30em;font:bold var(--a) serif"), "make the text smaller");
    says(
        &within("<style>:root{--a:500px}text{font-size:var(--a)}</style>", "<text y=\"390\">MM</text>"),
        "make the text smaller",
    );
    says(&text("--a:500px;--b:var(--a);font-size:var(--b)"), "make the text smaller");
    for style in [
        "--a:12px;font-size:var(--a)",
        "font-size:var(--b)",
        "font-size:var(--b, 9pt)",
        "--a:1em;font-size:var(--a,500px)",
    ] {
        equal(&text(style));
    }
    equal(&within("<style>:root{--a:9px}text{font-size:var(--a)}</style>", "<text y=\"390\">MM</text>"));
    for (style, said) in [
        ("font-size:calc(9px * 50)", "`font-size: calc(9px * 50)` is not worked out here"),
        ("font-size:50vw", "`font-size: 50vw` is not worked out here"),
        ("--a:calc(9px * 50);font-size:var(--a)", "`font-size: calc(9px * 50)` is not worked out here"),
        ("--a:var(--b);--b:var(--a);font-size:var(--a)", "is not worked out here"),
        ("font:bold max(9px, 500px) serif", "`font: bold max(9px, 500px) serif` is not worked out here"),
    ] {
        let error = refused(&text(style));
        assert!(error.contains(said) && error.contains("such as 12px"), "{style}: {error}");
        // Where no letters stand, it is no matter.
        equal(&within(&format!("<g style=\"{style}\">"), "</g>"));
    }
    equal(&text("font-size:calc(9px * 50);font-size:12px"));
    equal(&text("font-size:larger"));
    equal(&text("font:12px 'Letters (wide)', serif"));
}
