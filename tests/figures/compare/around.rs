//! What lies round a structure or in its faces and is no part of it: frames, axes that touch it, holes.

use super::{judge, texts};
use std::fmt::Write as _;

const WHOLE: &str = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"600\" height=\"400\" viewBox=\"0 0 600 400\">";

fn document(inside: &str) -> String {
    format!("{WHOLE}{inside}</svg>")
}

/// Circles at some places.
fn dots(places: &[[u32; 2]]) -> String {
    places.iter().fold(String::new(), |mut all, [x, y]| {
        let _ = write!(all, "<circle cx=\"{x}\" cy=\"{y}\" r=\"4\"/>");
        all
    })
}

/// Both ways; the notes of the first.
#[track_caller]
fn equal(reference: &str, student: &str) -> Vec<String> {
    let [there, back] = [[reference, student], [student, reference]].map(|[a, b]| judge(a, b));
    assert!(there.is_equal(), "{}", there.text());
    assert!(back.is_equal(), "the other way round: {}", back.text());
    there.notes().to_vec()
}

#[track_caller]
fn different(reference: &str, student: &str, why: &str) {
    let answer = judge(reference, student);
    assert!(texts(&answer).iter().any(|text| text.contains(why)), "{}", answer.text());
}

const TRIANGLE: &str = "<polygon points=\"62,338 538,338 538,62\" fill=\"#e8f0ff\" stroke=\"black\"/>";

fn triangle() -> String {
    format!("{TRIANGLE}{}", dots(&[[62, 338], [538, 338], [538, 62]]))
}

#[test]
fn a_frame_is_none_of_the_structure_in_either_drawing() {
    let frames = [
        "<rect x=\"5\" y=\"5\" width=\"590\" height=\"390\" fill=\"white\" stroke=\"gray\"/>",
        "<rect x=\"5\" y=\"5\" width=\"590\" height=\"390\" rx=\"18\" fill=\"white\" stroke=\"gray\"/>",
        "<rect x=\"7\" y=\"7\" width=\"586\" height=\"386\" fill=\"none\" stroke=\"gray\"/>",
        "<rect x=\"20\" y=\"20\" width=\"560\" height=\"360\" fill=\"none\" stroke=\"gray\"/>",
        "<rect x=\"20\" y=\"20\" width=\"560\" height=\"360\" rx=\"9\" fill=\"none\" stroke=\"gray\"/>",
        "<path d=\"M10 10H590V390H10Z\" fill=\"none\" stroke=\"gray\"/>",
        "",
    ];
    for reference in frames {
        for student in frames {
            equal(&document(&format!("{reference}{}", triangle())), &document(&format!("{student}{}", triangle())));
        }
    }
    // With vertices of its own it is a face round another one.
    let corners = dots(&[[20, 20], [580, 20], [580, 380], [20, 380]]);
    let [framed, bare] = [format!("{}{}{corners}", frames[3], triangle()), triangle()].map(|inside| document(&inside));
    different(&framed, &bare, "vertices");
    different(&bare, &framed, "vert");
    // A frame excuses nothing else.
    let lacking =
        document(&format!("{}{}", frames[0], triangle().replacen(TRIANGLE, &TRIANGLE.replace("black", "none"), 1)));
    different(&document(&format!("{}{}", frames[0], triangle())), &lacking, "missing");
}

/// A triangle in axes of matplotlib without margins: the corners of its box are corners of the axes.
fn in_axes(behind: bool, spines: bool, edges: &str) -> String {
    let mut axes = String::from("<g id=\"axes_1\">");
    if behind {
        axes += "<g id=\"patch_2\"><path d=\"M54 307L388 307L388 56L54 56z\" style=\"fill: #ffffff\"/></g>";
    }
    axes += "<clipPath id=\"c\"><rect x=\"54\" y=\"56\" width=\"334\" height=\"251\"/></clipPath>";
    axes += "<g id=\"patch_3\"><path d=\"M54 307L388 307L137 56z\" clip-path=\"url(#c)\" style=\"fill: #f2d7a0\"/></g>";
    if behind || spines {
        axes += "<g id=\"matplotlib.axis_1\"><g id=\"xtick_1\"><g id=\"line2d_1\">";
        axes += "<path d=\"M54 307L54 310\" style=\"stroke: #000000\"/></g></g></g>";
    }
    let _ = write!(
        axes,
        "<g id=\"line2d_7\"><path d=\"{edges}\" clip-path=\"url(#c)\" style=\"fill: none; stroke: #000000\"/></g>"
    );
    if spines {
        for (i, d) in ["M54 307L54 56", "M388 307L388 56", "M54 307L388 307", "M54 56L388 56"].iter().enumerate() {
            let _ =
                write!(axes, "<g id=\"patch_{}\"><path d=\"{d}\" style=\"fill: none; stroke: #000000\"/></g>", i + 4);
        }
    }
    let ground = "<g id=\"patch_1\"><path d=\"M0 360L432 360L432 0L0 0z\" style=\"fill: #ffffff\"/></g>";
    document(&format!("<g id=\"figure_1\">{ground}{axes}</g>{}</g>", dots(&[[54, 307], [388, 307], [137, 56]])))
}

#[test]
fn axes_may_touch_what_they_hold() {
    const ALL: &str = "M54 307L388 307L137 56L54 307";
    let reference = document(&format!(
        "<polygon points=\"54,307 388,307 137,56\" fill=\"#f2d7a0\" stroke=\"black\"/>{}",
        dots(&[[54, 307], [388, 307], [137, 56]])
    ));
    for (behind, spines) in [(true, true), (false, true), (true, false), (false, false)] {
        let drawn = in_axes(behind, spines, ALL);
        equal(&reference, &drawn);
        // A spine stands for no edge.
        different(&reference, &in_axes(behind, spines, "M388 307L137 56L54 307"), "missing");
        different(&reference, &in_axes(behind, spines, "M54 307L388 307L137 56"), "missing");
    }
    // What is clipped as the drawing is lies not behind it.
    let covering = in_axes(false, true, ALL).replacen(
        "patch_3\"><path d=\"M54 307L388 307L137 56z",
        "patch_3\"><path d=\"M54 307L388 307L388 56L54 56z",
        1,
    );
    assert!(!judge(&reference, &covering).is_equal());
}

/// A square with a square hole; the hole runs the same way as the outline, or the other way.
fn ring(same: bool, fill: &str) -> String {
    let inner = if same { "M200 250H400V150H200z" } else { "M200 250V150H400V250z" };
    let corners = dots(&[[50, 350], [550, 350], [550, 50], [50, 50], [200, 250], [400, 250], [400, 150], [200, 150]]);
    document(&format!("<path {fill} stroke=\"black\" d=\"M50 350H550V50H50z{inner}\"/>{corners}"))
}

#[test]
fn a_hole_is_what_the_fill_rule_leaves_empty() {
    const FILLED: &str = "the outer face, or a hole, is filled, too";
    let even = "fill=\"#cde\" fill-rule=\"evenodd\"";
    let hollow = [ring(true, even), ring(false, even), ring(false, "fill=\"#cde\"")];
    for reference in &hollow {
        for student in &hollow {
            assert!(!equal(reference, &format!("{student} ")).contains(&FILLED.to_owned()));
        }
        // A hole may be filled; that is told, whoever fills it.
        let outline = "<path fill=\"#cde\" stroke=\"black\" d=\"M50 350H550V50H50z\"/>";
        let lines = "<path fill=\"none\" stroke=\"black\" d=\"M200 250H400V150H200z\"/>";
        let plain = ring(true, even).replacen("<path", &format!("{outline}{lines}<path visibility=\"hidden\""), 1);
        for filled in [ring(true, "fill=\"#cde\""), plain] {
            let answer = judge(reference, &filled);
            assert!(answer.is_equal() && answer.notes().contains(&FILLED.to_owned()), "{}", answer.text());
        }
    }
    // A face that lies in the hole of another one has to be filled, and is no hole.
    let island = "<path fill=\"#edc\" d=\"M200 250H400V150H200z\"/>";
    let with_island = |s: &str| s.replacen("<circle", &format!("{island}<circle"), 1);
    for reference in &hollow {
        for student in &hollow {
            assert!(!equal(&with_island(reference), &with_island(&format!("{student} "))).contains(&FILLED.to_owned()));
            different(&with_island(reference), student, "is not filled");
        }
    }
}
