//! What is hidden or stretched in ways that lie outside of the shapes themselves is told.

use super::pen::{Pen, renumbered, table};
use super::{judge, kit, refused, ship};
use crate::common::Random;

/// The plain drawing of the ship.
pub(super) fn plain() -> String {
    Pen::new(&ship()).svg()
}

/// The drawing with other attributes on its root.
fn rooted(attributes: &str) -> String {
    plain().replacen("viewBox=\"0 0 600 400\"", attributes, 1)
}

/// The drawing with something before all shapes and something behind them.
pub(super) fn within(before: &str, after: &str) -> String {
    plain().replacen("400\">", &format!("400\">{before}"), 1).replacen("</svg>", &format!("{after}</svg>"), 1)
}

/// The drawing with this in place of the stroke of all lines, and something before all shapes.
fn stroked(before: &str, stroke: &str) -> String {
    within(before, "").replace("stroke=\"black\"", stroke)
}

#[track_caller]
pub(super) fn says(svg: &str, said: &str) {
    let answer = judge(&plain(), svg);
    assert!(!answer.is_equal() && answer.text().contains(said), "`{said}` not said: {}", answer.text());
}

#[track_caller]
pub(super) fn equal(svg: &str) {
    let answer = judge(&plain(), svg);
    assert!(answer.is_equal(), "{}\n{svg}", answer.text());
}

#[test]
fn a_root_that_is_stretched_is_judged_as_it_is_seen() {
    let none = "preserveAspectRatio=\"none\" viewBox=\"0 0 600 400\"";
    says(
        &rooted(&format!("{none} width=\"600\" height=\"800\"")),
        "the drawing is stretched: x is drawn 0.5 times as large",
    );
    says(&rooted(&format!("{none} style=\"width:1200px;height:400px\"")), "x is drawn 2 times as large as y");
    let by_sheet = rooted(&format!("{none} id=\"a\"")).replacen(
        "400\" id=\"a\">",
        "400\" id=\"a\"><style>svg{width:9in;height:3in}</style>",
        1,
    );
    says(&by_sheet, "x is drawn 2 times as large as y");
    for same in [
        format!("{none} width=\"900\" height=\"600\""),
        format!("{none} width=\"9cm\" height=\"6cm\""),
        format!("{none} width=\"600\" height=\"401\""),
        "viewBox=\"0 0 600 400\" width=\"600\" height=\"800\"".to_owned(),
    ] {
        equal(&rooted(&same));
    }
    // Stretched twice, once each way, is not stretched.
    let back = rooted(&format!("{none} width=\"600\" height=\"800\"")).replacen(
        "800\">",
        "800\"><g transform=\"scale(1 .5)\">",
        1,
    );
    equal(&back.replacen("</svg>", "</g></svg>", 1));
}

#[test]
fn a_root_without_width_or_height_shows_nothing() {
    for root in [
        "viewBox=\"0 0 600 400\" width=\"0\"",
        "viewBox=\"0 0 600 400\" height=\"0px\" width=\"600\"",
        "viewBox=\"0 0 600 400\" width=\"0%\"",
        "viewBox=\"0 0 600 400\" style=\"height:0\"",
        "viewBox=\"0 0 600 0\"",
        "width=\"0\" height=\"400\"",
    ] {
        let error = refused(&rooted(root));
        assert!(
            error.contains("student:1:1: width, height or viewBox of <svg> has a side of 0: nothing"),
            "{root}: {error}"
        );
    }
    equal(&rooted("viewBox=\"0 0 600 400\" width=\"100%\" height=\"100%\""));
}

#[test]
fn a_paint_that_is_not_in_the_file_is_no_paint() {
    for missing in ["url(#missing)", "url('#missing') none", "url(other.svg#a)", "URL(#missing) transparent"] {
        says(&stroked("", &format!("stroke=\"{missing}\"")), "33 edges cannot be seen, they have no stroke");
    }
    says(&stroked("", "stroke=\"url(#missing) white\""), "they have the colour of the paper");
    equal(&stroked("", "stroke=\"url(#missing) navy\""));
    says(&plain().replace("#e8f0ff", "url(#missing)"), "no face is filled");
    equal(&plain().replace("#e8f0ff", "url(#missing) gold"));
    // A circle is no paint.
    says(&stroked("<defs><circle id=\"c\" r=\"1\"/></defs>", "stroke=\"url(#c)\""), "they have no stroke");
}

/// A gradient across the whole drawing with these stops.
fn gradient(stops: &str) -> String {
    format!("<linearGradient id=\"g\" gradientUnits=\"userSpaceOnUse\" x2=\"600\">{stops}</linearGradient>")
}

#[test]
fn a_gradient_paints_what_its_stops_paint() {
    let by = |stops: &str| stroked(&gradient(stops), "stroke=\"url(#g)\"");
    for nothing in [
        "",
        "<stop stop-color=\"red\" stop-opacity=\"0\"/><stop offset=\"1\" stop-opacity=\"0\"/>",
        "<stop style=\"stop-color:red;stop-opacity:0%\"/>",
        "<stop stop-color=\"transparent\"/><stop offset=\"1\" stop-color=\"#f000\"/>",
    ] {
        says(&by(nothing), "33 edges cannot be seen, they have no stroke");
    }
    let white = "<stop stop-color=\"white\"/><stop offset=\"1\" stop-color=\"#fefefe\"/>";
    says(&by(white), "33 edges cannot be seen, they have the colour of the paper");
    let classed = "<style>.s{stop-opacity:0}</style><stop class=\"s\"/>";
    says(&by(classed), "they have no stroke");
    let linked = format!("{}<radialGradient id=\"r\" href=\"#g\" gradientUnits=\"userSpaceOnUse\"/>", gradient(white));
    says(&stroked(&linked, "stroke=\"url(#r)\""), "they have the colour of the paper");
    equal(&by("<stop stop-color=\"red\"/><stop offset=\"1\" stop-color=\"red\"/>"));
    equal(&by("<stop stop-color=\"red\"/><stop offset=\"1\" stop-color=\"navy\"/>"));
    // In parts of the box round a level line, which has no height, nothing is painted.
    let box_of_line = gradient("<stop stop-color=\"red\"/>").replace("userSpaceOnUse", "objectBoundingBox");
    says(&stroked(&box_of_line, "stroke=\"url(#g)\""), "they have no stroke");
    equal(&stroked(&box_of_line, "stroke=\"url(#g) red\""));
}

#[test]
fn half_edges_that_are_declared_are_seen() {
    let reference = kit(&table(&ship()));
    for rule in [
        ".sh{stroke:none}",
        ".sh{stroke:none!important}",
        ".he .sh{display:none}",
        ".he{visibility:hidden}",
        ".sh{stroke:url(#x)}",
    ] {
        // As the kit writes its rules, so that this one wins.
        let end = reference.find("</style>").unwrap();
        let prefixed = rule.replacen('.', "#ship .", 1);
        let svg = format!("{}{prefixed}\n{}", &reference[..end], &reference[end..]);
        let answer = judge(&reference, &svg);
        assert!(!answer.is_equal(), "{rule} passes");
        assert!(
            answer.text().contains("66 half-edges are declared and cannot be seen: h0, h1"),
            "{rule}: {}",
            answer.text()
        );
    }
    let one = reference.replacen("<line class=\"sh\"", "<line class=\"sh\" style=\"stroke:none\"", 1);
    let answer = judge(&reference, &one);
    assert!(answer.text().contains("1 half-edge is declared and cannot be seen: h"), "{}", answer.text());
    let white = reference.replacen("</style>", ".bg,.face{fill:#fff!important}.sh{stroke:#fff!important}</style>", 1);
    let answer = judge(&reference, &white);
    assert!(answer.text().contains("half-edges are declared and cannot be seen"), "{}", answer.text());
}

#[test]
fn half_edges_are_excused_one_by_one() {
    let table = table(&ship());
    let full = kit(&table);
    // One half-edge hidden, by its place in the file.
    let hidden = |svg: &str, i: usize| {
        let at = svg.match_indices("<line class=\"sh\"").nth(i).unwrap().0 + 5;
        format!("{} style=\"stroke:none\"{}", &svg[..at], &svg[at..])
    };
    let reference = hidden(&full, 3);
    let answer = judge(&reference, &hidden(&full, 3).replace('\n', " "));
    assert!(answer.is_equal(), "{}", answer.text());
    let answer = judge(&reference, &full);
    assert!(answer.is_equal(), "{}", answer.text());
    // As many, but another one.
    let answer = judge(&reference, &hidden(&full, 40));
    assert!(answer.text().contains("1 half-edge is declared and cannot be seen: h"), "{}", answer.text());
    // The same one, and one more.
    let answer = judge(&reference, &hidden(&hidden(&full, 40), 3));
    assert!(answer.text().contains("1 half-edge is declared and cannot be seen: h"), "{}", answer.text());
    // By place, whatever the numbers are.
    let mut random = Random(5);
    let other = kit(&renumbered(&table, |n| random.shuffled(n)));
    let hides = |svg: &str| judge(&reference, svg).text().contains("cannot be seen");
    let count = other.matches("<line class=\"sh\"").count();
    let excused: Vec<usize> = (0..count).filter(|&i| !hides(&hidden(&other, i))).collect();
    assert_eq!(excused.len(), 1, "{excused:?} of {count}");
}

/// All lines with a square marker so large at their starts.
fn marked(side: f64, style: &str) -> String {
    let marker = format!(
        "<marker id=\"m\" markerUnits=\"userSpaceOnUse\" markerWidth=\"{side}\" markerHeight=\"{side}\" refX=\"{r}\" refY=\"{r}\">\
         <rect width=\"{side}\" height=\"{side}\" {style}/></marker>",
        r = 0.5 * side
    );
    stroked(&marker, "stroke=\"black\" marker-start=\"url(#m)\"")
}

#[test]
fn markers_hide_when_they_are_large_and_only_then() {
    says(&marked(300.0, "fill=\"pink\""), "markers are drawn over them: make the markers smaller");
    equal(&marked(9.0, "fill=\"pink\""));
    equal(&marked(300.0, "fill=\"none\""));
    equal(&marked(300.0, "fill=\"pink\" opacity=\".1\""));
    // Cut off at its own room, unless it says otherwise.
    let small = marked(9.0, "fill=\"pink\"").replace("<rect width=\"9\"", "<rect x=\"-300\" width=\"900\"");
    equal(&small.replace("height=\"9\" fill", "y=\"-300\" height=\"900\" fill"));
    let wide = small.replace("height=\"9\" fill", "y=\"-300\" height=\"900\" fill");
    says(&wide.replace("<marker ", "<marker overflow=\"visible\" "), "markers are drawn over them");
    // In widths of the line, by a style, at the end of one line.
    let big = "<style>.m{marker-end:url(#b)}</style><marker id=\"b\" markerWidth=\"200\" markerHeight=\"200\" refX=\"100\" refY=\"100\" \
               orient=\"auto\"><path d=\"M0 0H200V200H0z\" fill=\"white\"/></marker>";
    let one = within(big, "").replacen("stroke=\"black\"", "stroke=\"black\" class=\"m\"", 1);
    equal(&one.replace("M0 0H200V200H0z", "M99 99h2v2h-2z"));
    let last = "<path class=\"m\" stroke=\"black\" fill=\"none\" d=\"M550 350L550 350.5\"/>";
    let over = within(big, &last.replace("550", "300").replace("350", "200"));
    assert!(!judge(&plain(), &over).is_equal());
}

#[test]
fn letters_hide_when_they_are_large_and_only_then() {
    let text = |style: &str, words: &str| within("", &format!("<text x=\"20\" y=\"390\" {style}>{words}</text>"));
    says(&text("font-size=\"500\"", "MM"), "large letters are drawn over them: make the text smaller");
    says(&text("style=\"font:bold 400px/1.2 serif;fill:white\"", "MM"), "make the text smaller");
    says(
        &text("fill=\"white\" font-size=\"20\" transform=\"translate(-300 -3200) scale(9)\"", "███████"),
        "make the text smaller",
    );
    says(&text("", "<tspan x=\"0\" y=\"400\" font-size=\"40em\" fill=\"white\">██</tspan>"), "make the text smaller");
    says(
        &text("fill=\"none\" stroke=\"white\" stroke-width=\"700\"", "a long caption below it all"),
        "make the text smaller",
    );
    equal(&text("", "a caption of ordinary size that is as long as the whole drawing is wide"));
    equal(&text("font-size=\"30\" transform=\"rotate(-30 20 390)\"", "across the drawing, turned"));
    equal(&text("font-size=\"500\" opacity=\".1\"", "MM"));
    equal(&text("font-size=\"500\" fill=\"none\"", "MM"));
    equal(&within("<text y=\"390\" font-size=\"500\" fill=\"#eee\">MM</text>", ""));
}

#[test]
fn hostile_gradients_markers_and_rules_end_quickly() {
    use cpu_time::ThreadTime;
    use dcel_kit::compare::{Options, compare};
    let many = |part: &str, n: usize| part.repeat(n);
    let deep = format!("{}{}", many("<g>", 150), many("</g>", 150));
    let pattern = |inside: &str| format!("<pattern id=\"p\" width=\"9\" height=\"9\">{inside}</pattern>");
    for (name, inside, said) in [
        ("a deep pattern", pattern(&format!("{}{}", many("<g>", 20_000), many("</g>", 20_000))), "nested too deeply"),
        ("many stops", format!("<style>a{{b:c}}</style><g id=\"{}\"><linearGradient id=\"g\">{}</linearGradient></g>", many("x", 500_000), many("<stop/>", 50_000)), "too large: more than 400000 parts of gradients"),
        ("many markers", format!("<marker id=\"m\">{deep}</marker><path marker-mid=\"url(#m)\" d=\"M0 0{}\"/>", many("h1v1", 90_000)), "too large"),
        ("a marker of itself", "<marker id=\"m\"><path marker-start=\"url(#m)\" d=\"M0 0h9\"/></marker><path marker-start=\"url(#m)\" d=\"M0 0h9\" stroke=\"red\"/>".to_owned(), ""),
        ("a clip path of many shapes", format!("<style>a{{b:c}}</style><g id=\"{}\"><clipPath id=\"c\">{}</clipPath></g><path d=\"M0 0h9\" stroke=\"red\" clip-path=\"url(#c)\"/>", many("x", 500_000), many("<rect/>", 50_000)), "too large: more than 1500000 elements to draw"),
        ("rules of children", format!("<style>x {}{{a:b}}</style>{}{}", many("g>g ", 90), many("<g>", 190), many("</g>", 190)), "nothing is drawn"),
        ("many colours that nothing asks for", format!("<g id=\"{}\"/>{}", many("x", 2_000_000), many("<g color=\"var(--a)\"/>", 50_000)), "nothing is drawn"),
        ("rules of attributes", format!("<style>{}{{a:b}}</style>{}", many(":not([q])", 20_000), many("<g/>", 20_000)), "style rules"),
    ] {
        let svg = format!("<svg xmlns=\"http://www.w3.org/2000/svg\">{inside}</svg>");
        let started = ThreadTime::now();
        match compare(&plain(), &svg, &Options::new()) {
            Ok(answer) => assert!(said.is_empty() && !answer.is_equal(), "{name}: {}", answer.text()),
            Err(error) => assert!(!said.is_empty() && error.to_string().contains(said), "{name}: {error}"),
        }
        assert!(started.elapsed() < std::time::Duration::from_secs(10), "{name}: {:?}", started.elapsed());
    }
}
