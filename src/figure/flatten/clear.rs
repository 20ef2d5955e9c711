//! Whether straight lines between places are a drawing of the faces, and how far apart its parts are.
//!
//! ```text
//!   sound:  no two lines cross; the corners at each point make one full turn, in their order; inner faces have an inside
//!   clear:  the least distance of a point from a line that does not end there, or from half way to a neighbour
//! ```

use super::disc::Web;
use crate::figure::canvas::vector::{Xy, doubled_area, segment_distance, xy};
use std::collections::BTreeSet;

/// The lines, each once.
fn lines(web: &Web) -> Vec<[usize; 2]> {
    let walks = web.faces.iter().chain([&web.border]);
    let sides = walks.flat_map(|walk| (0..walk.len()).map(move |i| [walk[i], walk[(i + 1) % walk.len()]]));
    let lines: BTreeSet<[usize; 2]> = sides.map(|[a, b]| [a.min(b), a.max(b)]).collect();
    lines.into_iter().collect()
}

/// On the canvas y points down.
fn on_canvas(places: &[[f64; 2]]) -> Vec<Xy> {
    places.iter().map(|&[x, y]| xy(x, -y)).collect()
}

/// Whether the places draw the faces as they are. O(lines²).
pub(super) fn is_sound(web: &Web, places: &[[f64; 2]]) -> bool {
    let at = on_canvas(places);
    let lines = lines(web);
    let is_left = |a: usize, b: usize, c: usize| (at[b] - at[a]).turn(at[c] - at[a]) > 0.0;
    let cross = |[a, b]: [usize; 2], [c, d]: [usize; 2]| {
        ![c, d].contains(&a)
            && ![c, d].contains(&b)
            && is_left(a, b, c) != is_left(a, b, d)
            && is_left(c, d, a) != is_left(c, d, b)
    };
    let crossed = (0..lines.len()).any(|i| lines[..i].iter().any(|&other| cross(lines[i], other)));
    let has_inside = |walk: &Vec<usize>| {
        let mut outline: Vec<Xy> = walk.iter().map(|&p| at[p]).collect();
        outline.push(outline[0]);
        doubled_area(&outline) > 1e-6
    };
    !crossed && web.faces.iter().all(has_inside) && turns_once(web, &at)
}

/// Whether the corners round each point follow each other in the order of the faces: then they make one full turn.
fn turns_once(web: &Web, at: &[Xy]) -> bool {
    let mut turned = vec![0.0; at.len()];
    let outside: Vec<usize> = web.border.iter().rev().copied().collect();
    for walk in web.faces.iter().chain([&outside]) {
        for i in 0..walk.len() {
            let [before, p, after] = [i + walk.len() - 1, i, i + 1].map(|i| walk[i % walk.len()]);
            let [from, to] = [after, before].map(|q| (at[q] - at[p]).pseudo_angle());
            let angle = to - from;
            turned[p] += if angle > 0.0 { angle } else { angle + 4.0 };
        }
    }
    turned.iter().all(|turn| (turn - 4.0).abs() < 1e-6)
}

/// How far apart the parts of a drawing are. O(points × lines).
pub(super) fn clearance(web: &Web, places: &[[f64; 2]]) -> f64 {
    let at = on_canvas(places);
    let mut least = f64::INFINITY;
    for [a, b] in lines(web) {
        least = least.min(0.5 * (at[a] - at[b]).length());
        for (_, &place) in at.iter().enumerate().filter(|(p, _)| ![a, b].contains(p)) {
            least = least.min(segment_distance(place, at[a], at[b]));
        }
    }
    least
}
