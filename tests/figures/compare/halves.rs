//! Half-edges that are too short, bent, in the place of others, or with their barbs on the wrong side.

use super::declared::{BARB, LINE, changed, direction, moved, reference, says, within};
use super::{judge, ship};
use dcel_kit::figure::{Detail, FigureOptions, structure};

pub(super) fn names() -> impl Iterator<Item = String> {
    (0..66).map(|h| format!("h{h}"))
}

/// The ends of the line of a half-edge.
pub(super) fn ends(lines: &[String], name: &str) -> [[f64; 2]; 2] {
    let line = &lines[within(lines, name, LINE)];
    [[" x1=\"", " y1=\""], [" x2=\"", " y2=\""]].map(|keys| {
        keys.map(|key| {
            let rest = &line[line.find(key).unwrap() + key.len()..];
            rest[..rest.find('"').unwrap()].parse().unwrap()
        })
    })
}

/// The line of a half-edge with other ends.
fn line([[x, y], [u, v]]: [[f64; 2]; 2]) -> String {
    format!("{LINE} x1=\"{x}\" y1=\"{y}\" x2=\"{u}\" y2=\"{v}\"/>")
}

/// The reference with the line of a half-edge from this part of it on.
fn shortened(name: &str, from: f64) -> String {
    changed(|lines| {
        let [[x, y], end] = ends(lines, name);
        let start = [x + from * (end[0] - x), y + from * (end[1] - y)];
        let at = within(lines, name, LINE);
        lines[at] = line([start, end]);
    })
}

#[test]
fn half_edges_run_nearly_from_vertex_to_vertex() {
    let reference = reference();
    let mut seen = 0;
    for name in names() {
        let short = judge(&reference, &shortened(&name, 0.4));
        seen += usize::from(
            short
                .text()
                .contains(&format!("1 half-edge is drawn much too short: it runs from vertex to vertex: {name}")),
        );
        // A little less is as good.
        let answer = judge(&reference, &shortened(&name, 0.2));
        assert!(answer.is_equal(), "{name}: {}", answer.text());
    }
    // Of short ones the kit itself leaves out half.
    assert!(seen > 10, "{seen}");
    for width in [320.0, 1000.0, 3000.0] {
        let options = FigureOptions::new("ship").detail(Detail::Full).width(width);
        let svg = structure(&ship(), &options).unwrap().to_svg();
        for [mine, theirs] in [[&reference, &svg], [&svg, &reference]] {
            let answer = judge(mine, theirs);
            assert!(!answer.text().contains("too short"), "{width}: {}", answer.text());
        }
    }
    // What the reference leaves out nobody has to draw.
    assert!(judge(&shortened("h0", 0.4), &shortened("h0", 0.42)).is_equal());
}

#[test]
fn half_edges_drawn_as_curves_are_called_so() {
    let bent = |name: &str| {
        changed(|lines| {
            let [[x, y], [u, v]] = ends(lines, name);
            let by = 0.2 * (u - x).hypot(v - y);
            let [sine, cosine] = direction(&reference(), name);
            let middle = [0.5 * (x + u) + by * sine, 0.5 * (y + v) - by * cosine];
            let at = within(lines, name, LINE);
            lines[at] = format!("<path class=\"sh\" d=\"M{x} {y}Q{} {} {u} {v}\"/>", middle[0], middle[1]);
        })
    };
    for name in ["h0", "h9", "h20"] {
        let said = format!("1 half-edge is drawn as a curve, which is not read: draw a straight line: {name}");
        says(&bent(name), &said);
        assert!(!judge(&reference(), &bent(name)).text().contains("barb"));
    }
}

#[test]
fn a_line_on_that_of_another_half_edge_is_told_once() {
    for [name, other] in [["h0", "h1"], ["h1", "h0"], ["h20", "h21"]] {
        let svg = changed(|lines| {
            let ends = ends(lines, other);
            let at = within(lines, name, LINE);
            lines[at] = line(ends);
        });
        let said = format!("1 half-edge is not drawn on the left of its edge, from vertex to vertex: {name}");
        says(&svg, &said);
        let answer = judge(&reference(), &svg);
        assert_eq!(answer.differences().len(), 1, "{}", answer.text());
    }
    // In another colour it hides the other one.
    let hiding = changed(|lines| {
        let ends = ends(lines, "h0");
        let at = within(lines, "h1", LINE);
        lines[at] = line(ends).replacen("/>", " style=\"stroke:#fff;stroke-width:4\"/>", 1);
    });
    says(&hiding, "1 half-edge is declared and cannot be seen: h0");
}

#[test]
fn barbs_lie_on_the_side_of_the_face_or_on_both_sides() {
    let mut seen = 0;
    for name in names() {
        let [s, c] = direction(&reference(), &name);
        let turned = changed(|lines| {
            let [[x, y], _] = ends(lines, &name);
            let mirror = format!("matrix({} {} {} {} 0 0)", c * c - s * s, 2.0 * c * s, 2.0 * c * s, s * s - c * c);
            moved(lines, &name, BARB, &format!("translate({x} {y}) {mirror} translate({} {})", -x, -y));
        });
        let answer = judge(&reference(), &turned);
        let said = format!("1 half-edge has its barb on the side of its edge, not on that of its face: {name}");
        assert!(!answer.is_equal(), "{name}");
        seen += usize::from(answer.text().contains(&said));
        // An arrow head with two sides is no fault.
        let arrow = changed(|lines| {
            let [_, [x, y]] = ends(lines, &name);
            let at = within(lines, &name, BARB);
            let place = |ahead: f64, aside: f64| [x + ahead * c + aside * s, y + ahead * s - aside * c];
            let [tip, left, right] = [place(3.0, 0.0), place(-4.0, 4.5), place(-4.0, -4.5)];
            let data = [tip, left, right].map(|[x, y]| format!("{x} {y}")).join("L");
            lines[at] = format!("<path class=\"barb\" d=\"M{data}z\"/>");
        });
        let answer = judge(&reference(), &arrow);
        assert!(answer.is_equal(), "{name}: {}", answer.text());
    }
    assert!(seen > 55, "{seen}");
}
