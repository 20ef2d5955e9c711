//! Places and sizes that a style says are read where browsers read them.

use super::pen::{P, Pen, document};
use super::seen::{equal, plain, says, within};
use super::{judge, refused, ship};

/// The drawing with another element for each circle.
fn dotted(dot: impl Fn(P) -> String) -> String {
    let pen = Pen::new(&ship());
    let mut elements = pen.elements();
    elements.truncate(pen.areas.len() + pen.lines.len());
    elements.extend(pen.dots.iter().map(|&p| dot(Pen::canvas(p))));
    document(&elements)
}

/// The drawing with rules.
fn ruled(rules: &str) -> String {
    within(&format!("<style>{rules}</style>"), "")
}

#[test]
fn circles_lie_where_their_styles_say() {
    equal(&dotted(|[x, y]| format!("<circle style=\"cx:{x}px;cy:{y}px;r:4px\"/>")));
    equal(&dotted(|[x, y]| format!("<circle cx=\"1\" cy=\"2\" r=\"90\" style=\"cx:{x}px; cy:{y}px; r:.8%\"/>")));
    equal(&dotted(|[x, y]| format!("<ellipse cx=\"1\" cy=\"{y}\" rx=\"900\" style=\"cx:{x}px;rx:4px;ry:auto\"/>")));
    equal(&dotted(|[x, y]| format!("<rect rx=\"4\" style=\"x:{}px;y:{}px;width:8px;height:8px\"/>", x - 4.0, y - 4.0)));
    // A style wins over an attribute, and a rule does, too.
    says(&ruled("circle{r:0}"), "22 vertices cannot be seen");
    says(&ruled("circle{r:300px}"), "make the circles smaller");
    says(&ruled("circle{cx:9px}"), "22 vertices are missing");
    equal(&ruled("circle{r:-300px}"));
    // No such properties: browsers pass them over.
    equal(&ruled("line{x1:9px;x2:9px;y1:9px;x:9px;cx:9px;r:9px}polygon{points:none}circle{x:99px;rx:0}"));
    let error = refused(&ruled("circle{r:calc(1px + 1em)}"));
    assert!(error.contains("`calc(1px + 1em)` is no number"), "{error}");
}

#[test]
fn what_covers_or_cuts_off_is_as_large_as_its_style_says() {
    let white = "<rect id=\"w\" width=\"1\" height=\"1\" fill=\"white\" SAID/>";
    let said = |svg: &str, said: &str| within("", &svg.replace("SAID", said));
    equal(&said(white, ""));
    says(&said(white, "style=\"width:600px;height:400px\""), "filled shapes are drawn over them");
    says(
        &said(&white.replace("<rect id=\"w\"", "<image href=\"a.png\""), "style=\"width:600px;height:400px\""),
        "drawn over them",
    );
    let large = white.replace("\"1\"", "\"600\"");
    equal(&said(&large, "style=\"width:auto\""));
    equal(&said(&large, "style=\"height:0\""));
    equal(&said(&large, "style=\"x:700px\""));
    // Clip paths.
    let clipped = |shape: &str| {
        let before = format!("<clipPath id=\"c\">{shape}</clipPath><g clip-path=\"url(#c)\">");
        within(&before, "</g>")
    };
    equal(&clipped("<rect width=\"600\" height=\"400\"/>"));
    equal(&clipped("<rect style=\"width:600px;height:400px\"/>"));
    says(&clipped("<rect width=\"600\" height=\"400\" style=\"width:9px\"/>"), "clip-path");
    says(&clipped("<rect width=\"600\" height=\"400\" style=\"display:none\"/>"), "clip-path");
    says(&clipped("<rect width=\"600\" height=\"400\" style=\"transform:scale(.01)\"/>"), "clip-path");
    says(
        &clipped("<use href=\"#r\" x=\"700\"/>")
            .replace("<clipPath", "<defs><rect id=\"r\" width=\"600\" height=\"400\"/></defs><clipPath"),
        "clip-path",
    );
    // Patterns.
    let pattern = "<pattern id=\"p\" width=\"8\" height=\"8\" patternUnits=\"userSpaceOnUse\"><rect width=\"8\" height=\"8\" SAID fill=\"black\"/></pattern>";
    let filled = |said: &str| within(&pattern.replace("SAID", said), "").replace("#e8f0ff", "url(#p)");
    says(&filled(""), "33 edges cannot be seen");
    equal(&filled("style=\"width:1px;height:1px\""));
}

#[test]
fn paths_are_what_their_styles_say() {
    let first = |path: &str| {
        let svg = plain();
        let line = svg.lines().find(|line| line.starts_with("<line")).unwrap();
        let number = |name: &str| line.split(&format!("{name}=\"")).nth(1).unwrap().split('"').next().unwrap();
        let data = format!("M{} {}L{} {}", number("x1"), number("y1"), number("x2"), number("y2"));
        svg.replacen(line, &path.replace("DATA", &data), 1)
    };
    equal(&first("<path stroke=\"black\" d=\"DATA\"/>"));
    equal(&first("<path stroke=\"black\" d=\"M0 0h9\" style=\"d:path('DATA')\"/>"));
    says(&first("<path stroke=\"black\" d=\"DATA\" style=\"d:none\"/>"), "is missing");
    says(&first("<path stroke=\"black\" d=\"DATA\" style='d: path(\"M0 0h9\")'/>"), "is missing");
    let error = refused(&first("<path stroke=\"black\" d=\"DATA\" style=\"d:ray(9deg)\"/>"));
    assert!(error.contains("`ray(9deg)` is no path(\"...\") or none"), "{error}");
}

#[test]
fn inner_drawings_whose_style_browsers_read_differently_are_refused() {
    let inner = |style: &str| {
        let svg = plain().replacen("400\">", &format!("400\"><svg width=\"600\" height=\"400\" style=\"{style}\">"), 1);
        svg.replacen("</svg>", "</svg></svg>", 1)
    };
    equal(&inner(""));
    equal(&inner("width:600px;x:0"));
    let error = refused(&inner("height:9px"));
    assert!(error.contains("`height: 9px` is no style that all browsers read on an inner <svg>"), "{error}");
    // The root is read as browsers do.
    equal(&plain().replacen("<svg ", "<svg style=\"width:100%;height:auto\" ", 1));
    let moved = within("<g id=\"all\">", "</g>");
    let used = moved.replacen("<g id", "<defs><g id", 1).replacen(
        "</g></svg>",
        "</g></defs><use href=\"#all\" SAID/></svg>",
        1,
    );
    equal(&used.replace("SAID", "x=\"9\""));
    let two =
        |said: &str| used.replace("SAID", "").replacen("</svg>", &format!("<use href=\"#all\" {said}/></svg>"), 1);
    equal(&two(""));
    assert!(!judge(&plain(), &two("style=\"x:7px\"")).is_equal());
}
