//! A rectangle with a diagonal: what is drawn must be seen where it belongs, and good drawings are not refused.
//!
//! Files beside this one were written by matplotlib and CairoSVG.

use super::judge;
use dcel_kit::compare::{Options, compare};

const REFERENCE: &str = include_str!("reference.svg");
const FACES: &str = "<polygon points=\"62,380 538,380 538,23\" fill=\"#f2d7a0\"/><polygon points=\"62,380 538,23 62,23\" \
                     fill=\"#f2d7a0\"/>";
const CIRCLES: &str = "<circle cx=\"62\" cy=\"380\" r=\"4\"/><circle cx=\"538\" cy=\"380\" r=\"4\"/><circle cx=\"538\" \
                       cy=\"23\" r=\"4\"/><circle cx=\"62\" cy=\"23\" r=\"4\"/>";
const SIDES: &str = "<g stroke=\"black\"><path d=\"M62 380H538\"/><path d=\"M538 380V23\"/><path d=\"M538 23H62\"/>\
                     <path d=\"M62 23V380\"/></g>";
const DIAGONAL: &str = "x1=\"62\" y1=\"380\" x2=\"538\" y2=\"23\"";

fn document(inside: &str) -> String {
    format!("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 600 400\">{inside}</svg>")
}

/// The drawing with this in place of its diagonal.
fn with(diagonal: &str) -> String {
    document(&format!("{FACES}{SIDES}{diagonal}{CIRCLES}"))
}

/// The drawing with a diagonal of these attributes, and something before it.
fn drawn(before: &str, attributes: &str) -> String {
    with(&format!("{before}<line {DIAGONAL} {attributes}/>"))
}

#[track_caller]
fn equal(svg: &str) {
    let answer = judge(REFERENCE, svg);
    assert!(answer.is_equal(), "{}\n{svg}", answer.text());
}

#[track_caller]
fn says(svg: &str, said: &str) {
    let answer = judge(REFERENCE, svg);
    assert!(!answer.is_equal() && answer.text().contains(said), "`{said}` not said: {}\n{svg}", answer.text());
}

#[track_caller]
fn tells(reference: &str, svg: &str, said: &[&str]) {
    let answer = judge(reference, svg);
    let texts: Vec<&str> = answer.differences().iter().map(|difference| difference.text.as_str()).collect();
    assert_eq!(texts, said, "{svg}");
}

const LOST: &str = "edge between (62, 380) and (538, 23) cannot be seen";

#[test]
fn a_value_that_browsers_drop_leaves_what_stands_below_it() {
    for attributes in [
        "stroke=\"none\" style=\"stroke:blackish\"",
        "stroke=\"none\" style=\"stroke:\"",
        "stroke=\"none\" style=\"stroke:12\"",
        "stroke=\"none\" style=\"stroke:#12\"",
        "stroke=\"none\" style=\"stroke:rgb(1,2)\"",
        "stroke=\"none\" style=\"stroke:url(#a) blackish\"",
        "color=\"white\" stroke=\"currentColor\" style=\"color:none\"",
        "stroke=\"black\" stroke-width=\"0\" style=\"stroke-width:3furlong\"",
        "stroke=\"black\" stroke-width=\"0\" style=\"stroke-width:-3\"",
        "stroke=\"black\" stroke-opacity=\"0\" style=\"stroke-opacity:high\"",
        "stroke=\"black\" stroke-opacity=\"0\" style=\"stroke-opacity:1px\"",
        "stroke=\"black\" opacity=\"0\" style=\"opacity:foo\"",
        "stroke=\"black\" visibility=\"hidden\" style=\"visibility:visble\"",
        "stroke=\"black\" stroke-dasharray=\"0 9999\" style=\"stroke-dasharray:1 -1\"",
        "stroke=\"black\" stroke-dasharray=\"0 9999\" style=\"stroke-dasharray:dashed\"",
    ] {
        says(&drawn("", attributes), LOST);
    }
    says(&drawn("<style>.k{stroke:none} .j{stroke:blackish}</style>", "class=\"k j\""), LOST);
    says(&with(&format!("<g stroke=\"none\"><line {DIAGONAL} stroke=\"blackish\"/></g>")), LOST);
    let hidden = format!("<g display=\"none\" style=\"display:foo()\"><line {DIAGONAL} stroke=\"black\"/></g>");
    says(&with(&hidden), "edge between (62, 380) and (538, 23) is missing");
    says(
        &drawn("", "stroke=\"black\"").replacen("r=\"4\"", "r=\"0\" style=\"r:4\"", 1),
        "vertex at (62, 380) cannot be seen: it has no size",
    );
    says(
        &drawn("", "stroke=\"black\"").replacen("fill=\"#f2d7a0\"", "fill=\"none\" style=\"fill:sandy\"", 1),
        "is not filled",
    );
    for attributes in [
        "stroke=\"black\" style=\"stroke:blackish\"",
        "stroke=\"black\" style=\"visibility:visble\"",
        "stroke=\"black\" style=\"opacity:foo;display:foo\"",
        "stroke=\"black\" style=\"stroke-width:3PX;stroke-dasharray:9,3\"",
    ] {
        equal(&drawn("", attributes));
    }
}

#[test]
fn only_style_sheets_in_css_count() {
    let typed = |kind: &str| drawn(&format!("<style type=\"{kind}\">line{{stroke:black}}</style>"), "");
    says(&typed("text/x"), LOST);
    says(&typed("text/css2"), LOST);
    equal(&typed("text/css"));
    equal(&typed("Text/CSS"));
    equal(&typed(""));
    says(&drawn("<style xmlns=\"urn:x\">line{stroke:black}</style>", ""), LOST);
    equal(&drawn("<style xmlns=\"http://www.w3.org/1999/xhtml\">line{stroke:black}</style>", ""));
}

#[test]
fn rules_look_at_the_place_where_what_is_used_stands() {
    let used = |rule: &str, inside: &str, around: &str| {
        with(&format!(
            "<style>{rule}</style><defs><g class=\"home\">{inside}</g></defs><g class=\"box\" {around}><use href=\"#z\"/></g>"
        ))
    };
    let line = format!("<line id=\"z\" {DIAGONAL}/>");
    says(&used(".box line{stroke:black}", &line, ""), LOST);
    says(&used("use line{stroke:black}", &line, ""), LOST);
    equal(&used(".home line{stroke:black}", &line, ""));
    // It inherits from where it is used.
    equal(&used(".box{stroke:black}", &line, ""));
    equal(&used("", &line, "stroke=\"black\""));
    let symbol = format!("<symbol id=\"z\" overflow=\"visible\"><line {DIAGONAL}/></symbol>");
    says(&used(".box line{stroke:black}", &symbol, ""), LOST);
    equal(&used("symbol line{stroke:black}", &symbol, ""));
    equal(&used(".home > symbol > line{stroke:black}", &symbol, ""));
}

#[test]
fn lines_over_each_other_are_seen_where_one_of_them_shows() {
    let line = |attributes: &str| format!("<line {DIAGONAL} {attributes}/>");
    let both = |below: &str, above: &str| with(&format!("{}{}", line(below), line(above)));
    // Cased: a white line below; double: one above.
    equal(&both("stroke=\"white\" stroke-width=\"5\"", "stroke=\"black\""));
    equal(&both("stroke=\"black\" stroke-width=\"5\"", "stroke=\"white\" stroke-width=\"2\""));
    says(&both("stroke=\"black\"", "stroke=\"white\" stroke-width=\"5\""), LOST);
    says(&both("stroke=\"black\" stroke-width=\"2\"", "stroke=\"white\" stroke-width=\"1.98\""), LOST);
    let all = REFERENCE.replacen(
        "<g stroke=\"black\">",
        "<path stroke=\"white\" stroke-width=\"6\" fill=\"none\" d=\"M62 380H538V23H62V380L538 23\"/><g stroke=\"black\">",
        1,
    );
    equal(&all);
}

#[test]
fn a_rectangle_with_round_corners_has_them() {
    let rect = |corners: &str| {
        let rect =
            format!("<rect x=\"62\" y=\"23\" width=\"476\" height=\"357\" {corners} fill=\"none\" stroke=\"black\"/>");
        document(&format!("{FACES}{rect}<line {DIAGONAL} stroke=\"black\"/>{CIRCLES}"))
    };
    says(&rect("rx=\"170\""), "a line ends at (232, 23), where there is no vertex");
    says(&rect("rx=\"20\" ry=\"30\""), "a line ends at (82, 23), where there is no vertex");
    equal(&rect(""));
    equal(&rect("rx=\"0\" ry=\"9\""));
    equal(&rect("rx=\"0.001\""));
}

/// The rectangle without its left side, with one face, turned by so many degrees clockwise.
fn open_rectangle(degrees: f64) -> String {
    let inside = "<polygon points=\"62,380 538,380 538,23\" fill=\"#f2d7a0\"/><g stroke=\"black\"><path d=\"M62 380H538\"/>\
                  <path d=\"M538 380V23\"/><path d=\"M538 23H62\"/><path d=\"M62 380L538 23\"/></g>";
    document(&format!("<g transform=\"rotate({degrees} 300 200)\">{inside}{CIRCLES}</g>"))
}

#[test]
fn the_turn_that_leaves_the_fewest_differences_is_named_and_of_those_the_smallest() {
    tells(&open_rectangle(0.0), &open_rectangle(5.0), &["the drawing is turned by 5° to the right"]);
    tells(&open_rectangle(0.0), &open_rectangle(-3.0), &["the drawing is turned by 3° to the left"]);
    let turned = REFERENCE.replacen("400\">", "400\"><g transform=\"rotate(5 300 200)\">", 1);
    let turned = turned.replacen("</svg>", "</g></svg>", 1);
    tells(REFERENCE, &turned, &["the drawing is turned by 5° to the right"]);
    // Another diagonal is no mirror.
    let swapped = drawn("", "stroke=\"black\"").replace(DIAGONAL, "x1=\"538\" y1=\"380\" x2=\"62\" y2=\"23\"");
    tells(
        REFERENCE,
        &swapped,
        &[
            "edge between (62, 380) and (538, 23) is missing",
            "edge between (538, 380) and (62, 23) is not in the reference",
        ],
    );
}

#[test]
fn what_lies_off_the_page_is_told_so() {
    let moved = |page: &str| drawn("", "stroke=\"black\"").replacen("0 0 600 400", page, 1);
    let answer = judge(REFERENCE, &moved("70 0 600 400")).text();
    assert!(answer.contains("vertex at (62, 23) cannot be seen: it lies outside of the viewBox"), "{answer}");
    assert!(!answer.contains("clip-path"), "{answer}");
    let answer = judge(REFERENCE, &moved("600 0 600 400")).text();
    assert!(answer.contains("face along"), "{answer}");
    assert!(!answer.contains("clip-path") && !answer.contains("paper"), "{answer}");
    let clip = "<clipPath id=\"c\"><rect x=\"70\" width=\"600\" height=\"400\"/></clipPath><g clip-path=\"url(#c)\">";
    let clipped = with(&format!("<line {DIAGONAL} stroke=\"black\"/>{clip}")).replacen("</svg>", "</g></svg>", 1);
    says(&clipped, "vertex at (62, 23) cannot be seen: its clip-path cuts it off");
}

#[test]
fn a_filled_outline_beside_the_drawing_is_no_face() {
    let triangle = "<polygon points=\"5,25 45,25 25,200\" fill=\"red\"/>";
    let more = REFERENCE.replacen("400\">", &format!("400\">{triangle}"), 1);
    let said = "filled polygon along (5, 25), (45, 25), (25, 200) is no face of the reference";
    says(&more, said);
    let answer = judge(&more, REFERENCE);
    assert!(!answer.is_equal() && answer.text().contains("is not filled"), "{}", answer.text());
    // White on white paper, in a legend or on an axis, it is nothing.
    equal(&more.replace("red", "white"));
    for name in ["legend", "matplotlib.axis_1", "colorbar"] {
        equal(&more.replace(triangle, &format!("<g id=\"{name}\">{triangle}</g>")));
    }
}

#[test]
fn a_face_of_the_reference_may_run_either_way_if_it_runs_clockwise_there() {
    let clockwise = REFERENCE.replacen("62,380 538,380 538,23", "62,380 538,23 538,380", 1);
    assert!(judge(&clockwise, REFERENCE).is_equal());
    assert!(judge(&clockwise, &clockwise.replacen("#f2d7a0", "pink", 1)).is_equal());
    says(&clockwise, "runs clockwise: list its corners counter-clockwise");
}

#[test]
fn the_end_of_a_line_beyond_its_vertex_is_told_as_it_is() {
    let beyond = drawn("", "stroke=\"black\"").replace("x2=\"538\"", "x2=\"538.04\"");
    says(&beyond, "a line ends at (538.04, 23), where there is no vertex");
    assert!(!judge(REFERENCE, &beyond).text().contains("cannot be seen"));
    equal(&drawn("", "stroke=\"black\"").replace("x2=\"538\"", "x2=\"538.02\""));
}

#[test]
fn a_large_circle_without_a_fill_gets_a_note() {
    let circle = "<circle cx=\"300\" cy=\"200\" r=\"100\" fill=\"none\" stroke=\"black\"/>";
    let answer = judge(REFERENCE, &drawn(circle, "stroke=\"black\""));
    assert!(answer.notes().iter().any(|note| note == "not read: 1 circle that is no vertex"), "{}", answer.text());
}

#[test]
fn what_a_mask_or_a_filter_hides_is_refused() {
    let mask = "<mask id=\"m\"><rect width=\"600\" height=\"400\" fill=\"white\"/></mask>";
    for attribute in ["mask=\"url(#m)\"", "filter=\"url(#m)\"", "style=\"mix-blend-mode:multiply\""] {
        let error = compare(REFERENCE, &drawn(mask, &format!("stroke=\"black\" {attribute}")), &Options::new());
        let error = error.unwrap_err().to_string();
        let said = "student: the edge between (62, 380) and (538, 23) has a mask, a filter or a blend mode";
        assert!(error.starts_with(said), "{error}");
    }
    let circle = drawn(mask, "stroke=\"black\"").replacen("r=\"4\"", "r=\"4\" mask=\"url(#m)\"", 1);
    let error = compare(REFERENCE, &circle, &Options::new()).unwrap_err().to_string();
    assert!(error.starts_with("student: the vertex at (62, 380) has a mask"), "{error}");
}

#[test]
fn drawings_with_legends_axes_and_boxes_are_read_as_they_come() {
    for svg in [
        include_str!("matplotlib-legend-over-an-edge.svg"),
        include_str!("matplotlib-axis-at-the-border.svg"),
        include_str!("matplotlib-tight-limits.svg"),
        include_str!("matplotlib-text-box.svg"),
    ] {
        equal(svg);
    }
    // A box with corners is one if letters are in it.
    let rect = "<rect x=\"400\" y=\"270\" width=\"40\" height=\"24\" fill=\"white\" stroke=\"black\"/>";
    equal(&drawn(&format!("{rect}<text x=\"410\" y=\"287\">f1</text>"), "stroke=\"black\""));
    says(&drawn(rect, "stroke=\"black\""), "where there is no vertex");
    // A tick that goes inwards is an edge, whatever it is called.
    let inwards = "<g id=\"matplotlib.axis_1\"><path d=\"M200 380v-40\" stroke=\"black\"/></g>";
    says(&drawn(inwards, "stroke=\"black\""), "a line ends at (200, 340)");
}

#[test]
fn rims_of_letters_as_outlines_are_no_edges() {
    let (reference, student) = (include_str!("kit-edges.svg"), include_str!("cairosvg-kit-edges.svg"));
    let answer = judge(reference, student);
    assert!(answer.is_equal(), "{}", answer.text());
}

/// The drawing in axes as matplotlib writes them, with these limits on the canvas and something more in the axes.
fn plotted(sides: &str, [left, top, right, low]: [f64; 4], more: &str) -> String {
    let spine = |number: u32, data: String| {
        format!("<g id=\"patch_{number}\"><path d=\"{data}\" style=\"fill: none; stroke: #000000\"/></g>")
    };
    let spines = [
        spine(3, format!("M {left} {low} L {left} {top}")),
        spine(4, format!("M {right} {low} L {right} {top}")),
        spine(5, format!("M {left} {low} L {right} {low}")),
        spine(6, format!("M {left} {top} L {right} {top}")),
    ];
    let tick = |name: &str, data: String| {
        format!("<g id=\"{name}tick_1\"><g id=\"line2d_1\"><path d=\"{data}\" stroke=\"black\"/></g></g>")
    };
    let ticks = [
        format!("<g id=\"matplotlib.axis_1\">{}</g>", tick("x", format!("M200 {low}v-6"))),
        format!("<g id=\"matplotlib.axis_2\">{}</g>", tick("y", format!("M{left} 300L{right} 300"))),
    ];
    let [spines, ticks] = [spines.concat(), ticks.concat()];
    let behind = format!(
        "<g id=\"patch_2\"><path d=\"M{left} {low} L{right} {low} L{right} {top} L{left} {top} z\" style=\"fill: none\"/></g>"
    );
    let diagonal = format!("<line {DIAGONAL} stroke=\"black\"/>");
    document(&format!("<g id=\"axes_1\">{behind}{ticks}{FACES}{sides}{diagonal}{CIRCLES}{spines}{more}</g>"))
}

const LIMITS: [[f64; 4]; 4] =
    [[40.0, 10.0, 560.0, 390.0], [62.0, 23.0, 538.0, 380.0], [62.0, 10.0, 580.0, 390.0], [62.0, 100.0, 300.0, 380.0]];

#[test]
fn axes_of_matplotlib_are_no_edges_wherever_they_lie() {
    for limits in LIMITS {
        equal(&plotted(SIDES, limits, ""));
    }
    let tight = LIMITS[1];
    // A spine in place of an edge is no edge, nor is a line of the grid.
    let open = SIDES.replace("<path d=\"M538 23H62\"/>", "");
    says(&plotted(&open, tight, ""), "edge between (538, 23) and (62, 23) cannot be seen: it has no stroke");
    // What is drawn in the axes is no spine: it is clipped, or leans, or is shorter; ticks are level or upright, and short.
    for path in [
        "<path clip-path=\"url(#c)\" d=\"M 62 200 L 538 200\"",
        "<path d=\"M 62 200 L 538 210\"",
        "<path d=\"M 62 200 L 500 200\"",
    ] {
        let more = format!("<g id=\"patch_7\">{path} stroke=\"black\"/></g>");
        says(&plotted(SIDES, tight, &more), "a line ends at (62, 200), where there is no vertex");
    }
    for data in ["M100 100L200 150", "M100 100L200 100"] {
        let tick = format!("<g id=\"xtick_2\"><path d=\"{data}\" stroke=\"black\"/></g>");
        let more = format!("<g id=\"matplotlib.axis_1\">{tick}</g>");
        says(&plotted(SIDES, tight, &more), "a line ends at (100, 100), where there is no vertex");
    }
}

/// A key of two symbols over the diagonal, with this box.
fn keyed(area: &str) -> String {
    let symbols = "<path d=\"M290 190h30\" stroke=\"black\"/><circle cx=\"305\" cy=\"215\" r=\"4\"/>";
    with(&format!("<line {DIAGONAL} stroke=\"black\"/><g id=\"legend_1\">{area}{symbols}</g>"))
}

#[test]
fn symbols_of_a_legend_are_no_faults_where_it_hides_nothing() {
    let area = "<rect x=\"280\" y=\"175\" width=\"60\" height=\"60\" fill=\"white\"/>";
    equal(&keyed(""));
    equal(&keyed(&area.replace("/>", " fill-opacity=\"0.8\"/>")));
    let over = judge(REFERENCE, &keyed(area)).text();
    assert!(over.contains("the legend lies over the drawing and is not in the reference: move it"), "{over}");
    assert!(!over.contains("vertex at") && !over.contains("a line ends"), "{over}");
    // Over a vertex, a box hides it more or less.
    let corner = keyed(&area.replace("/>", " fill-opacity=\"0.8\"/>"));
    let corner = corner.replace("<g id=\"legend_1\"", "<g transform=\"translate(235 -160)\" id=\"legend_1\"");
    says(&corner, "the legend lies over the drawing");
    // A line from a vertex is no symbol.
    let joined = keyed("<path d=\"M62 380L290 190\" stroke=\"black\"/>");
    assert!(!judge(REFERENCE, &joined).is_equal());
}

#[test]
fn a_frame_may_have_round_corners() {
    for fill in ["#fafafa", "none"] {
        let frame = |x: f64, y: f64, round: f64| {
            let [width, height] = [600.0 - 2.0 * x, 400.0 - 2.0 * y];
            format!(
                "<rect x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\" rx=\"{round}\" fill=\"{fill}\" \
                 stroke=\"#999\"/>"
            )
        };
        for round in [3.0, 12.0, 60.0] {
            let before = frame(5.0, 5.0, round);
            equal(&document(&format!("{before}{FACES}{SIDES}<line {DIAGONAL} stroke=\"black\"/>{CIRCLES}")));
        }
        // It takes the place of no edge, and what does not hold the drawing is no frame.
        let instead = frame(62.0, 21.5, 8.0);
        let all = format!("{instead}{FACES}<line {DIAGONAL} stroke=\"black\"/>{CIRCLES}");
        says(&document(&all), "edge between (62, 380) and (538, 380) is missing");
        let within = frame(150.0, 100.0, 12.0);
        assert!(!judge(REFERENCE, &drawn(&within, "stroke=\"black\"")).is_equal(), "{fill}");
    }
}

#[test]
fn a_circle_hides_no_more_than_half_of_an_edge() {
    let reference = REFERENCE.replace("#f2d7a0", "#fde").replace("#cfe3d4", "#fde");
    let large = |radius: &str| {
        let circle = format!("cx=\"62\" cy=\"23\" r=\"{radius}\"");
        reference.replace("cx=\"62\" cy=\"23\" r=\"4\"", &circle)
    };
    tells(&reference, &large("100"), &[]);
    for radius in ["220", "300"] {
        let answer = judge(&reference, &large(radius)).text();
        let said = "edge between (62, 380) and (62, 23) cannot be seen: a circle is drawn over it";
        assert!(answer.contains(said), "{radius}: {answer}");
    }
    // The reference may hide as much itself.
    tells(&large("220"), &large("221"), &[]);
}

#[test]
fn a_small_face_about_a_vertex_is_no_symbol() {
    let spokes = "<path d=\"M300 180L300 200M280 210L300 200M320 210L300 200\" stroke=\"black\"/>";
    let closed = "<path d=\"M300 180L280 210L320 210z\" fill=\"none\" stroke=\"black\"/>";
    let sides = "<path d=\"M300 180L280 210M280 210L320 210M320 210L300 180\" stroke=\"black\"/>";
    let [one, other] = [closed, sides].map(|face| document(&format!("{SIDES}{spokes}{face}{CIRCLES}")));
    tells(&one, &other, &[]);
    tells(&other, &one, &[]);
    tells(&other, &one.replace("20 210z", "20 210"), &["edge between (300, 180) and (320, 210) is missing"]);
}
