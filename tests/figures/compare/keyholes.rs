//! A face with a hole is drawn as two outlines in one path, or as one polygon that goes over a bridge: the pictures are equal.

use super::judge;
use dcel_kit::compare::Options;
use dcel_kit::compare::compare;

type P = [i32; 2];

const OUTER: [P; 4] = [[50, 350], [550, 350], [550, 50], [50, 50]];
const INNER: [P; 4] = [[200, 250], [400, 250], [400, 150], [200, 150]];

fn listed(ring: &[P]) -> String {
    ring.iter().map(|[x, y]| format!("{x},{y}")).collect::<Vec<_>>().join(" ")
}

/// The lines, the circles, and these areas below.
fn page(areas: &str) -> String {
    let rings =
        [OUTER, INNER].map(|ring| format!("<polygon points=\"{}\" fill=\"none\" stroke=\"black\"/>", listed(&ring)));
    let dots: String =
        OUTER.iter().chain(&INNER).map(|[x, y]| format!("<circle cx=\"{x}\" cy=\"{y}\" r=\"4\"/>")).collect();
    let lines = rings.concat();
    format!("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 600 400\">{areas}{lines}{dots}</svg>")
}

/// Two outlines in one path.
fn ring(hole: &[P]) -> String {
    format!("<path fill=\"pink\" fill-rule=\"evenodd\" d=\"M{}zM{}z\"/>", listed(&OUTER), listed(hole))
}

/// One polygon: round the outside from a corner, over a bridge and round the hole the other way, and back.
fn keyhole(hole: &[P], i: usize, j: usize) -> String {
    let count = hole.len();
    let mut points: Vec<P> = (0..=4).map(|k| OUTER[(i + k) % 4]).collect();
    points.extend((0..=count).map(|k| hole[(j + count - k) % count]));
    format!("<polygon fill=\"pink\" points=\"{}\"/>", listed(&points))
}

#[test]
fn a_keyhole_is_a_face_with_a_hole() {
    let inner = format!("<polygon fill=\"gold\" points=\"{}\"/>", listed(&INNER));
    for filling in ["", &inner] {
        let reference = page(&format!("{}{filling}", ring(&INNER)));
        for (i, j) in [(0, 0), (1, 3), (2, 2)] {
            let other = page(&format!("{}{filling}", keyhole(&INNER, i, j)));
            for [mine, theirs] in [[&reference, &other], [&other, &reference]] {
                let answer = judge(mine, theirs);
                assert!(answer.is_equal(), "{i} {j}: {}", answer.text());
            }
        }
    }
    let answer = judge(&page(&format!("{}{inner}", ring(&INNER))), &page(&keyhole(&INNER, 0, 0)));
    assert!(
        answer.text().contains("(200, 250), (400, 250), (400, 150), (200, 150) is not filled"),
        "{}",
        answer.text()
    );
}

#[test]
fn a_hole_where_the_reference_fills_a_face_is_told() {
    let larger = [[150, 280], [450, 280], [450, 120], [150, 120]];
    let elsewhere = [[100, 330], [140, 330], [140, 300], [100, 300]];
    let beyond = [[200, 250], [400, 250], [540, 60], [200, 150]];
    let solid = page(&format!("<polygon fill=\"pink\" points=\"{}\"/>", listed(&OUTER)));
    for draw in [ring as fn(&[P]) -> String, |hole| keyhole(hole, 0, 0)] {
        for hole in [larger, elsewhere, beyond] {
            for reference in [&page(&ring(&INNER)), &solid] {
                let svg = page(&draw(&hole));
                let answer = judge(reference, &svg);
                assert!(answer.text().contains("a hole along ("), "{hole:?}: {}", answer.text());
                assert!(answer.text().contains("is left where the reference fills a face"), "{}", answer.text());
                assert!(compare(reference, &svg, &Options::new().faces(false)).unwrap().is_equal());
            }
        }
        assert!(!judge(&solid, &page(&draw(&INNER))).is_equal());
        // Where another area lies, the hole is not missed.
        let filled = page(&format!("{}<polygon fill=\"pink\" points=\"{}\"/>", draw(&INNER), listed(&INNER)));
        let whole = page(&format!(
            "<polygon fill=\"pink\" points=\"{}\"/><polygon fill=\"gold\" points=\"{}\"/>",
            listed(&OUTER),
            listed(&INNER)
        ));
        let answer = judge(&whole, &filled);
        assert!(answer.is_equal(), "{}", answer.text());
    }
}
