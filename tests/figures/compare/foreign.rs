//! Labels that other programs write in another language than SVG hide nothing; boxes among them do.

use super::seen::{equal, plain, says, within};
use super::{judge, refused};

const XHTML: &str = "xmlns=\"http://www.w3.org/1999/xhtml\"";

/// A box over much of the drawing, and what it holds.
fn boxed(attributes: &str, inside: &str) -> String {
    let room = "x=\"40\" y=\"40\" width=\"500\" height=\"320\"";
    within("", &format!("<foreignObject {room} {attributes}>{inside}</foreignObject>"))
}

#[test]
fn labels_hide_nothing() {
    let label = "style=\"display: table-cell; white-space: nowrap; line-height: 1.5; text-align: center;\"";
    for inside in [
        format!("<div {XHTML} {label}><span class=\"nodeLabel\"><p>v3</p></span></div>"),
        format!(
            "<div {XHTML} style=\"display: flex; width: 1px; height: 1px; padding-top: 7px; margin-left: 60px;\">\
             <div data-drawio-colors=\"color: rgb(0, 0, 0); \" style=\"box-sizing: border-box; font-size: 0px;\">\
             <div style=\"display: inline-block; font-size: 12px; font-family: Helvetica; color: rgb(0, 0, 0);\">f1\
             </div></div></div>"
        ),
        format!("<p {XHTML} style=\"background:none;border:1px solid red;position:absolute;left:9px\">e</p>"),
        format!("<div {XHTML} style=\"display:none\"><img src=\"a.png\"/></div>"),
    ] {
        for attributes in ["", "style=\"overflow:visible\""] {
            let svg = boxed(attributes, &inside);
            equal(&svg);
            let answer = judge(&plain(), &svg);
            assert!(answer.notes().contains(&"not read: 1 <foreignObject>".to_owned()), "{:?}", answer.notes());
        }
    }
}

#[test]
fn boxes_cover_what_lies_below_them() {
    let style = |style: &str| format!("<div {XHTML} style=\"{style}\">x</div>");
    for inside in [
        style("position:absolute;inset:0;background:white"),
        style("background-color:#fff"),
        style("color:red;box-shadow:0 0 0 900px white"),
        style("border:300px solid white"),
        style("outline:300px solid white"),
        style("border-image:url(a.png) 30"),
        style("font-size:700px"),
        format!("<div {XHTML}><p><img src=\"a.png\"/></p></div>"),
        format!("<iframe {XHTML} src=\"a.html\"/>"),
        format!("<canvas {XHTML}/>"),
        "<svg><rect width=\"999\" height=\"999\" fill=\"white\"/></svg>".to_owned(),
        format!("<style>.a{{background:white}}</style><div {XHTML} class=\"a\">x</div>"),
        format!("<table {XHTML} bgcolor=\"white\"/>"),
    ] {
        says(&boxed("", &inside), "edges cannot be seen, filled shapes are drawn over them");
        let error = refused(&boxed("overflow=\"visible\"", &inside));
        assert!(error.contains("<foreignObject> holds ") && error.contains("write the label as <text>"), "{error}");
    }
    let error = refused(&boxed("style=\"overflow: visible\"", &style("background: white")));
    assert!(error.contains("<foreignObject> holds `background` of <div>, which may cover lines"), "{error}");
    let error = refused(&boxed("", &format!("<style>div::after{{background:white}}</style><div {XHTML}/>")));
    assert!(error.contains("the style rule `div::after` changes what is seen"), "{error}");
    // What is not displayed covers nothing, nor does a box below all, or beside the drawing.
    equal(&boxed("display=\"none\"", &style("background:white")));
    let below = format!("<foreignObject width=\"600\" height=\"400\">{}</foreignObject>", style("background:white"));
    equal(&within(&below, ""));
    equal(&within("", &below.replace("<foreignObject ", "<foreignObject y=\"390\" ")));
    // The box of a label on the middle of an edge is no fault.
    let label = "<foreignObject x=\"290\" y=\"212\" width=\"20\" height=\"14\">";
    equal(&within("", &format!("{label}{}</foreignObject>", style("background:white"))));
}
