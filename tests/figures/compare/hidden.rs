//! What an eye does not see is told: below letters, discs and gaps of dashes, without a size, filled twice.

use super::judge;
use super::seen::{equal, plain, within};
use std::fmt::Write;

/// A rectangle of 476 x 276 px with a diagonal of 550 px between two faces.
const SQUARE: &str = r##"<svg xmlns="http://www.w3.org/2000/svg" width="600" height="400">
<polygon points="62,338 538,338 538,62" fill="pink"/>
<polygon points="62,338 538,62 62,62" fill="lightblue"/>
<line x1="62" y1="338" x2="538" y2="338" stroke="black"/>
<line x1="538" y1="338" x2="538" y2="62" stroke="black"/>
<line x1="538" y1="62" x2="62" y2="62" stroke="black"/>
<line x1="62" y1="62" x2="62" y2="338" stroke="black"/>
<line x1="62" y1="338" x2="538" y2="62" stroke="black"/>
<circle cx="62" cy="338" r="4"/>
<circle cx="538" cy="338" r="4"/>
<circle cx="538" cy="62" r="4"/>
<circle cx="62" cy="62" r="4"/>
</svg>"##;
/// The diagonal, and how it is told.
const DIAGONAL: &str = r#"x1="62" y1="338" x2="538" y2="62" stroke="black""#;
const UNSEEN: &str = "edge between (62, 338) and (538, 62) cannot be seen: ";
const FIRST: &str = r#"<circle cx="62" cy="338" r="4"/>"#;

/// The rectangle with one text in it changed.
fn square(old: &str, new: &str) -> String {
    assert!(SQUARE.contains(old));
    SQUARE.replacen(old, new, 1)
}

/// The rectangle with this over it.
fn under(shapes: &str) -> String {
    square("</svg>", &format!("{shapes}</svg>"))
}

/// The rectangle with attributes on its diagonal.
fn diagonal(attributes: &str) -> String {
    square(DIAGONAL, &format!("{DIAGONAL} {attributes}"))
}

#[track_caller]
fn same(svg: &str) {
    let answer = judge(SQUARE, svg);
    assert!(answer.is_equal(), "{}\n{svg}", answer.text());
}

#[track_caller]
fn tells(svg: &str, said: &str) {
    let answer = judge(SQUARE, svg);
    let texts: Vec<&str> = answer.differences().iter().map(|difference| difference.text.as_str()).collect();
    assert!(texts.len() == 1 && texts[0].starts_with(said), "`{said}` not said: {}\n{svg}", answer.text());
}

/// A text along the diagonal that begins at a part of its length.
fn along(from: f64, words: &str, style: &str) -> String {
    let (x, y) = (62.0 + from * 476.0, 338.0 - from * 276.0);
    format!("<text x=\"{x}\" y=\"{}\" {style} transform=\"rotate(-30.105 {x} {y})\">{words}</text>", y + 3.0)
}

#[test]
fn letters_that_nobody_can_read_hide_what_lies_below_them() {
    let faded = format!("{UNSEEN}letters that cannot be told from what lies round them are drawn over it");
    for colour in ["white", "pink", "lightblue", "#fefefe"] {
        let style = format!("font-size=\"8\" font-family=\"monospace\" fill=\"{colour}\"");
        tells(&under(&along(0.0, &"\u{2588}".repeat(115), &style)), &faded);
        // As many texts of one letter.
        let mut each = String::new();
        (0..114).for_each(|i| each += &along(f64::from(i) / 115.0, "\u{2588}", &style));
        tells(&under(&each), &faded);
    }
    tells(&under(&along(0.0, &"M".repeat(115), "font-size=\"8\" fill=\"none\" stroke=\"white\"")), &faded);
    // A rim that is wide enough to cover the letters, and one below small letters that is wider than they are.
    let rimmed = "font-size=\"8\" stroke=\"white\" stroke-width=\"6\"";
    tells(&under(&along(0.0, &"M".repeat(115), rimmed)), &faded);
    let haloed = "font-size=\"4\" stroke=\"white\" stroke-width=\"8\" paint-order=\"stroke\"";
    tells(&under(&along(0.0, &".".repeat(229), haloed)), &faded);
    tells(
        &under("<text x=\"100\" y=\"300\" font-size=\"60\" fill=\"white\">\u{2588}\u{2588}\u{2588}\u{2588}</text>"),
        &faded,
    );
}

#[test]
fn letters_that_can_be_read_hide_nothing() {
    let label = |style: &str| under(&along(0.45, "e12", style));
    for style in [
        "font-size=\"12\"",
        "font-size=\"12\" fill=\"white\"",
        "font-size=\"12\" stroke=\"white\" stroke-width=\"4\" paint-order=\"stroke\"",
        "font-size=\"12\" fill=\"white\" stroke=\"black\"",
    ] {
        same(&label(style));
    }
    same(&under(&along(0.0, &"caption ".repeat(14), "font-size=\"8\"")));
    same(&under(&along(0.0, &"caption ".repeat(14), "font-size=\"8\" fill=\"navy\"")));
    // Below the line, and not displayed, white letters hide nothing.
    let white = along(0.0, &"M".repeat(115), "font-size=\"8\" fill=\"white\"");
    let first = SQUARE.find("<line").unwrap();
    same(&format!("{}{white}{}", &SQUARE[..first], &SQUARE[first..]));
    same(&under(&white.replace("fill", "fill-opacity=\"0\" fill")));
    // Names in discs, a little wider than these.
    let mut named = SQUARE.replace("r=\"4\"", "r=\"8\"");
    let mut names = String::new();
    for [x, y] in [[62, 338], [538, 338], [538, 62], [62, 62]] {
        write!(
            names,
            "<text x=\"{x}\" y=\"{}\" font-size=\"12\" text-anchor=\"middle\" fill=\"white\">v10</text>",
            y + 4
        )
        .unwrap();
    }
    named = named.replace("</svg>", &format!("{names}</svg>"));
    same(&named);
    equal(&within(
        "",
        "<text x=\"20\" y=\"220\" fill=\"white\">a white caption across the drawing, from the left on</text>",
    ));
}

#[test]
fn dashes_that_leave_out_a_part_of_an_edge_are_told() {
    let said = format!("{UNSEEN}its dashes leave it out");
    for dashes in [
        "stroke-dasharray=\"200 9999\"",
        "stroke-dasharray=\"275 9999\"",
        "stroke-dasharray=\"400 9999\"",
        "stroke-dasharray=\"275\"",
        "stroke-dasharray=\"275 275\" stroke-dashoffset=\"275\"",
        "stroke-dasharray=\"9999 300\" stroke-dashoffset=\"9899\"",
        "stroke-dasharray=\"100 150\" stroke-dashoffset=\"100\"",
        "style=\"stroke-dasharray:3in 3in\"",
        "stroke-dasharray=\"5 5 5 400\"",
    ] {
        tells(&diagonal(dashes), &said);
    }
    // An edge of a path that goes on.
    let path = "<path fill=\"none\" stroke=\"black\" stroke-dasharray=\"600 9999\" d=\"M538 62V338L";
    let corner = "<line x1=\"538\" y1=\"338\" x2=\"538\" y2=\"62\" stroke=\"black\"/>";
    let base = "<line x1=\"62\" y1=\"338\" x2=\"538\" y2=\"338\" stroke=\"black\"/>\n";
    let whole = square(corner, &format!("{path}62 338\"/>")).replace(base, "");
    tells(&whole, "edge between (62, 338) and (538, 338) cannot be seen: its dashes leave it out");
}

#[test]
fn dashed_and_dotted_lines_are_lines() {
    for dashes in ["4", "8 4", "1 3", "20 10 5 10", "12 24", "24 12 3 12", "30 40", "300 30", "500 9999", "0.5 1.5"] {
        same(&diagonal(&format!("stroke-dasharray=\"{dashes}\"")));
        let all = SQUARE.replace("stroke=\"black\"", &format!("stroke=\"black\" stroke-dasharray=\"{dashes}\""));
        if dashes != "500 9999" {
            same(&all);
        }
    }
    for dashes in ["8 4", "5", "10 10", "1 3"] {
        equal(&plain().replace("stroke=\"black\"", &format!("stroke=\"black\" stroke-dasharray=\"{dashes}\"")));
    }
    // Dots are dashes of no length with round ends.
    for (dashes, width) in [("0 6", 3), ("0 4", 2), ("0.01 5", 3)] {
        let dotted = format!("stroke-dasharray=\"{dashes}\" stroke-linecap=\"round\" stroke-width=\"{width}\"");
        same(&diagonal(&dotted));
        let flat = dotted.replace("round", "butt");
        tells(&diagonal(&flat), &format!("{UNSEEN}its dashes leave it out"));
    }
}

#[test]
fn a_disc_too_large_for_a_label_hides_an_edge() {
    let said = format!("{UNSEEN}a circle is drawn over it: make the circles smaller");
    let disc = |r: u32, style: &str| under(&format!("<circle cx=\"300\" cy=\"200\" r=\"{r}\" {style}/>"));
    for r in [25, 30, 60, 100] {
        tells(&disc(r, "fill=\"white\""), &said);
    }
    tells(&under("<ellipse cx=\"220\" cy=\"250\" rx=\"32\" ry=\"28\" fill=\"white\"/>"), &said);
    tells(&under("<path d=\"M330 200a30 30 0 0 1 -60 0a30 30 0 0 1 60 0z\" fill=\"white\"/>"), &said);
    // As the background of a label, and below the ends of edges.
    for r in [5, 9, 10, 15] {
        same(&disc(r, "fill=\"white\""));
        same(&disc(r, "fill=\"white\"").replace("</svg>", "<text x=\"297\" y=\"203\" font-size=\"10\">1</text></svg>"));
    }
    for r in [4, 10, 25] {
        same(&SQUARE.replace("r=\"4\"", &format!("r=\"{r}\" fill=\"white\" stroke=\"black\"")));
    }
    // Beside the edges it hides none.
    same(&under("<circle cx=\"450\" cy=\"270\" r=\"30\" fill=\"white\"/>"));
}

#[test]
fn what_has_a_size_below_nothing_is_not_drawn() {
    let first = |shape: &str| square(FIRST, shape);
    let said = "vertex at (62, 338) cannot be seen: it has no size: its radius is 0 or less";
    for shape in [
        "<circle cx=\"62\" cy=\"338\" r=\"-4\"/>",
        "<circle cx=\"62\" cy=\"338\" r=\"0\"/>",
        "<circle cx=\"62\" cy=\"338\" r=\"-1%\"/>",
        "<circle cx=\"62\" cy=\"338\" r=\" -4px\" stroke=\"red\"/>",
        "<ellipse cx=\"62\" cy=\"338\" rx=\"-4\" ry=\"-4\"/>",
        "<ellipse cx=\"62\" cy=\"338\" rx=\"4\" ry=\"0\"/>",
    ] {
        tells(&first(shape), said);
    }
    for shape in [
        "<rect x=\"66\" y=\"342\" width=\"-8\" height=\"-8\" rx=\"4\"/>",
        "<rect x=\"58\" y=\"342\" width=\"8\" height=\"-8\"/>",
    ] {
        tells(&first(shape), "vertex at (62, 338) is missing: no circle is drawn there");
    }
    // A radius of no such value is as large as the other one; a width is 1.
    same(&first("<ellipse cx=\"62\" cy=\"338\" rx=\"-4\" ry=\"4\"/>"));
    same(&first("<ellipse cx=\"62\" cy=\"338\" rx=\"4\" ry=\"-90\"/>"));
    same(&first("<rect x=\"58\" y=\"334\" width=\"8\" height=\"8\" rx=\"-1\" ry=\"4\"/>"));
    same(&diagonal("stroke-width=\"-3\""));
    same(&diagonal("style=\"stroke-width:-2px\""));
    let cut = "<clipPath id=\"c\"><circle cx=\"300\" cy=\"200\" r=\"-900\"/></clipPath>";
    tells(
        &diagonal("clip-path=\"url(#c)\"").replace("</svg>", &format!("{cut}</svg>")),
        &format!("{UNSEEN}its clip-path"),
    );
}

#[test]
fn what_is_filled_twice_under_evenodd_is_not_filled() {
    let face = "<polygon points=\"62,338 538,338 538,62\" fill=\"pink\"/>";
    let path = |rule: &str, d: &str| square(face, &format!("<path fill-rule=\"{rule}\" d=\"{d}\" fill=\"pink\"/>"));
    let twice = "M62 338H538V62zM62 338H538V62z";
    let said = "face along (62, 338), (538, 338), (538, 62) is not filled";
    tells(&path("evenodd", twice), said);
    tells(&path("evenodd", "M62 338H538V62zM538 338V62L62 338z"), said);
    tells(&path("evenodd", "M62 338H538V62zM62 338L538 62V338z"), said);
    tells(&path("nonzero", "M62 338H538V62zM62 338L538 62V338z"), said);
    same(&path("nonzero", twice));
    same(&path("evenodd", &format!("{twice}M62 338H538V62z")));
    // Both faces in one path.
    let other = "<polygon points=\"62,338 538,62 62,62\" fill=\"lightblue\"/>\n";
    let both = "M62 338H538V62zM62 338L538 62H62z";
    same(&path("evenodd", both).replace(other, ""));
    same(&path("nonzero", both).replace(other, ""));
    // A drawing that hides it itself asks for no more.
    let own = path("evenodd", twice);
    let answer = judge(&own, &own.replace('\n', " "));
    assert!(answer.is_equal(), "{}", answer.text());
}

#[test]
fn a_face_in_the_hole_of_another_has_to_be_filled_itself() {
    let lines = "<path fill=\"none\" stroke=\"black\" d=\"M0 0H300V300H0zM100 100H200V200H100zM0 0L100 100\"/>";
    let dots: String = [[0, 0], [300, 0], [300, 300], [0, 300], [100, 100], [200, 100], [200, 200], [100, 200]]
        .iter()
        .map(|[x, y]| format!("<circle cx=\"{x}\" cy=\"{y}\" r=\"3\"/>"))
        .collect();
    let drawn = |areas: &str| {
        format!("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"-9 -9 320 320\">{areas}{lines}{dots}</svg>")
    };
    let ring = "<path fill-rule=\"evenodd\" fill=\"pink\" d=\"M0 300H300V0H0zM100 200H200V100H100z\"/>";
    let inner = "<path fill=\"gold\" d=\"M100 200H200V100H100z\"/>";
    let reference = drawn(&format!("{ring}{inner}"));
    let answer = judge(&reference, &drawn(&format!("{inner}\n{ring}")));
    assert!(answer.is_equal(), "{}", answer.text());
    let answer = judge(&reference, &drawn(ring));
    assert!(
        answer.text().contains("face along (100, 200), (200, 200), (200, 100), (100, 100) is not filled"),
        "{}",
        answer.text()
    );
}

#[test]
fn a_circle_that_its_lines_swallow_is_told_so() {
    let small = "vertex at (62, 338) cannot be seen: it cannot be told from the lines that end there: make it larger";
    tells(&square(FIRST, &FIRST.replace("r=\"4\"", "r=\".5\"")), small);
    tells(&square(FIRST, &FIRST.replace("r=\"4\"", "r=\".3\"")), small);
    let white = square(FIRST, &FIRST.replace("/>", " fill=\"white\"/>"));
    tells(&white, "vertex at (62, 338) cannot be seen: it has the colour of the paper");
}
