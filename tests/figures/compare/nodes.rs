//! Nodes of graphs are drawn as boxes, and lines end at the rims of these.

use super::judge;
use super::shown::{CORNERS, EDGES, P, drawn, line, same, says, square, with};
use dcel_kit::compare::{Options, compare};

const STROKE: &str = "stroke=\"#333\" stroke-width=\"1.5\"";

/// Where the line from the middle of a box to another point leaves it, or so far behind that.
fn rim([a, b]: P, [c, d]: P, [width, height]: P, more: f64) -> P {
    let part = |half: f64, way: f64| if way == 0.0 { f64::INFINITY } else { (half + more) / way.abs() };
    let t = part(0.5 * width, c - a).min(part(0.5 * height, d - b));
    [a + t * (c - a), b + t * (d - b)]
}

fn between(ends: [P; 2], size: P, more: f64) -> String {
    line([rim(ends[0], ends[1], size, more), rim(ends[1], ends[0], size, more)], STROKE)
}

fn squares(side: f64, style: &str, more: f64, last: &str) -> String {
    drawn(|_, ends| between(ends, [side; 2], more), |p| square(p, side, style), last)
}

#[test]
fn a_line_that_ends_at_the_rim_of_a_square_ends_at_its_vertex() {
    for style in ["", "fill=\"none\" stroke=\"black\"", "fill=\"white\" stroke=\"black\"", "fill=\"orange\""] {
        for side in [8.0, 12.0, 20.0, 30.0] {
            same(&squares(side, style, 0.0, ""));
            let answer = judge(&squares(side, style, 0.0, ""), &with(""));
            assert!(answer.is_equal(), "{side} {style}: {}", answer.text());
            // Another edge, another vertex, one edge less.
            let extra = between([CORNERS[0], CORNERS[2]], [side; 2], 0.0);
            says(&squares(side, style, 0.0, &extra), "edge between (50, 350) and (550, 50) is not in the reference");
            let stray = squares(side, style, 0.0, &square([300.0, 200.0], side, style));
            if style.contains("white") {
                // What is white paints no vertex; its sides are lines.
                assert!(!judge(&with(""), &stray).is_equal(), "{side}");
            } else {
                says(&stray, "vertex at (300, 200) is not in the reference");
            }
            let less = between(EDGES[4].map(|v| CORNERS[v]), [side; 2], 0.0);
            says(
                &squares(side, style, 0.0, "").replace(&less, ""),
                "edge between (550, 350) and (450, 250) is missing",
            );
            // Short of the squares.
            assert!(!judge(&with(""), &squares(side, style, 6.0, "")).is_equal(), "{side} {style}");
        }
    }
    // Lines that point beside the middles.
    let aside = |_: usize, ends: [P; 2]| {
        let [a, b] = [rim(ends[0], ends[1], [20.0; 2], 0.0), rim(ends[1], ends[0], [20.0; 2], 0.0)];
        line([[a[0], a[1] + 3.0], b], STROKE)
    };
    assert!(!judge(&with(""), &drawn(aside, |p| square(p, 20.0, ""), "")).is_equal());
}

#[test]
fn boxes_round_labels_are_vertices_where_lines_end_at_them() {
    let node = |[width, height]: P| {
        move |[x, y]: P| {
            let (left, top) = (x - 0.5 * width, y - 0.5 * height);
            format!(
                "<rect x=\"{left}\" y=\"{top}\" width=\"{width}\" height=\"{height}\" fill=\"none\" stroke=\"black\"/>\
                 <text x=\"{x}\" y=\"{}\" text-anchor=\"middle\" font-size=\"12\">a</text>",
                y + 4.0
            )
        }
    };
    for size in [[54.0, 36.0], [30.0, 20.0], [14.0, 14.0]] {
        // Lines that stop at the outer side of the rim, too.
        for more in [0.0, 0.5] {
            same(&drawn(|_, ends| between(ends, size, more), node(size), ""));
        }
        let less = |i: usize, ends: [P; 2]| if i == 4 { String::new() } else { between(ends, size, 0.0) };
        says(&drawn(less, node(size), ""), "edge between (550, 350) and (450, 250) is missing");
    }
}

/// As programs do that leave the same room at nodes of every shape.
#[test]
fn a_line_that_stops_at_the_circle_through_the_corners_of_a_square_ends_at_its_vertex() {
    let short = |ends: [P; 2], room: f64| {
        let [[a, b], [c, d]] = ends;
        let part = room / f64::hypot(c - a, d - b);
        [[a + part * (c - a), b + part * (d - b)], [c - part * (c - a), d - part * (d - b)]]
    };
    for style in ["", "fill=\"none\" stroke=\"black\"", "fill=\"#1f78b4\" stroke=\"#1f78b4\""] {
        for side in [8.0, 17.3, 30.0] {
            let room = side * f64::sqrt(0.5);
            let lines = |room: f64, last: &str| {
                drawn(|_, ends| line(short(ends, room), STROKE), |p| square(p, side, style), last)
            };
            same(&lines(room, ""));
            let extra = line(short([CORNERS[0], CORNERS[2]], room), STROKE);
            says(&lines(room, &extra), "edge between (50, 350) and (550, 50) is not in the reference");
            // Between the rims and that circle, and beyond it, by all lines or by one end.
            for other in [room - 0.4, room + 3.0] {
                // A small square has no room between them.
                assert!(
                    side < 10.0 && other < room || !judge(&with(""), &lines(other, "")).is_equal(),
                    "{side} {style}"
                );
            }
            let whole = line(short([CORNERS[0], CORNERS[1]], room), STROKE);
            let less = whole.replacen(&format!("x2=\"{}\"", 550.0 - room), &format!("x2=\"{}\"", 547.0 - room), 1);
            assert_ne!(whole, less);
            assert!(!judge(&with(""), &lines(room, "").replacen(&whole, &less, 1)).is_equal(), "{side} {style}");
        }
    }
    // Boxes that are no squares have rims only.
    let wide = |[x, y]: P| {
        format!(
            "<rect x=\"{}\" y=\"{}\" width=\"40\" height=\"26\" fill=\"none\" stroke=\"black\"/>",
            x - 20.0,
            y - 13.0
        )
    };
    assert!(!judge(&with(""), &drawn(|_, ends| line(short(ends, 23.8), STROKE), wide, "")).is_equal());
}

/// How near lines end to boxes, and how well they point to their middles, follows the tolerance.
#[test]
fn boxes_follow_the_tolerance() {
    let size = [54.0, 36.0];
    let node = |[x, y]: P| {
        let [left, top] = [x - 0.5 * size[0], y - 0.5 * size[1]];
        format!("<rect x=\"{left}\" y=\"{top}\" width=\"54\" height=\"36\" fill=\"none\" stroke=\"black\"/>")
    };
    let equal = |svg: &str, px: f64| {
        compare(&with(""), svg, &Options::new().tolerance(px)).unwrap_or_else(|error| panic!("{error}")).is_equal()
    };
    let gap = |more: f64| drawn(|_, ends| between(ends, size, more), node, "");
    // The lines stop short of the rims.
    assert!(equal(&gap(0.5), 0.05) && !equal(&gap(2.5), 0.05) && equal(&gap(2.5), 1.0) && !equal(&gap(9.0), 1.0));
    // They point beside the middles.
    let aside = |by: f64| {
        let edge = |_: usize, ends: [P; 2]| {
            let [a, b] = [rim(ends[0], ends[1], size, 0.0), rim(ends[1], ends[0], size, 0.0)];
            line([[a[0], a[1] + by], [b[0], b[1] + by]], STROKE)
        };
        drawn(edge, node, "")
    };
    assert!(equal(&aside(0.1), 0.05) && !equal(&aside(0.1), 0.01));
    assert!(!equal(&aside(1.2), 0.05) && equal(&aside(1.2), 0.5) && !equal(&aside(6.0), 0.5));
}

/// As Graphviz draws them: edges as curves, nodes as closed polygons.
#[test]
fn nodes_of_graphviz_are_vertices() {
    let edge = |_: usize, ends: [P; 2]| {
        let [p, q] = [rim(ends[0], ends[1], [20.0; 2], 0.0), rim(ends[1], ends[0], [20.0; 2], 0.0)];
        let at = |t: f64| format!("{:.2},{:.2}", p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1]));
        format!("<path fill=\"none\" stroke=\"black\" d=\"M{}C{} {} {}\"/>", at(0.0), at(0.3), at(0.7), at(1.0))
    };
    let node = |[x, y]: P| {
        let corner = |i: f64, j: f64| format!("{},{}", x + 10.0 * i, y + 10.0 * j);
        let ring = [corner(1.0, -1.0), corner(-1.0, -1.0), corner(-1.0, 1.0), corner(1.0, 1.0), corner(1.0, -1.0)];
        format!("<polygon fill=\"none\" stroke=\"black\" points=\"{}\"/>", ring.join(" "))
    };
    same(&drawn(edge, node, ""));
}

/// A small square with lines at its corners is a face, whatever these point to.
#[test]
fn a_square_face_is_no_vertex() {
    let [low, high] = [180.0, 220.0];
    let corners = [[low, low], [high, low], [high, high], [low, high]];
    let spokes: String =
        corners.iter().map(|&[x, y]| line([[x, y], [x + 4.0 * (x - 200.0), y + 4.0 * (y - 200.0)]], STROKE)).collect();
    let face = square([200.0, 200.0], 40.0, "fill=\"none\" stroke=\"#333\"");
    let page =
        |inside: &str| format!("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 400 400\">{inside}</svg>");
    let whole = page(&format!("{face}{spokes}"));
    let answer = judge(&whole, &page(&spokes));
    assert!(answer.text().contains("4 differences") || answer.differences().len() > 3, "{}", answer.text());
    let sides: String = (0..4).map(|i| line([corners[i], corners[(i + 1) % 4]], STROKE)).collect();
    let answer = judge(&whole, &page(&format!("{sides}{spokes}")));
    assert!(answer.is_equal(), "{}", answer.text());
}

/// Boxes that are faces, too large for vertices: small squares at their corners are these.
#[test]
fn boxes_at_which_no_line_ends_are_faces() {
    let grid = |vertex: &dyn Fn(P) -> String| {
        let places = |count: u32| (0..count).flat_map(move |x| (0..count).map(move |y| [x, y].map(f64::from)));
        let faces =
            places(10).map(|[x, y]| square([60.0 * x + 30.0, 60.0 * y + 30.0], 60.0, "fill=\"#eee\" stroke=\"black\""));
        let faces: String = faces.collect();
        let vertices: String = places(11).map(|[x, y]| vertex([60.0 * x, 60.0 * y])).collect();
        format!("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"-10 -10 620 620\">{faces}{vertices}</svg>")
    };
    let reference = grid(&|[x, y]| format!("<circle cx=\"{x}\" cy=\"{y}\" r=\"3\"/>"));
    let answer = judge(&reference, &grid(&|p| square(p, 6.0, "")));
    assert!(answer.is_equal(), "{}", answer.text());
    let some = grid(&|p| if p == [300.0, 300.0] { String::new() } else { square(p, 6.0, "") });
    assert!(!judge(&reference, &some).is_equal());
}
