//! The picture of the handout: the Voronoi diagram of its sites, as the program of the lab draws it.

use super::centres::centre;
use super::starts::delaunay;
use crate::cases::handouts::SITES;
use crate::pictures::Plain;

/// Half of the width and of the height of the frame at which rays end.
const FRAME: [f64; 2] = [320.0, 220.0];

/// The lines of the diagram.
fn lines() -> Vec<[[f64; 2]; 2]> {
    let Some(built) = delaunay(&SITES) else { return Vec::new() };
    let outer = |h| built.face(h).number() == 0;
    let place = |h| [built.point(built.origin(h)).x, built.point(built.origin(h)).y];
    let middle = |h| {
        let round = [h, built.next(h), built.prev(h)].map(place);
        centre(round[0], round[1], round[2]).map(|(place, _)| place)
    };
    let mut all = Vec::new();
    for edge in built.edges() {
        let [h, twin] = edge.half_edges();
        let ends = match (outer(h), outer(twin)) {
            (false, false) => middle(h).zip(middle(twin)),
            (true, _) => middle(twin).map(|begin| (begin, leave(begin, place(h), place(twin)))),
            _ => middle(h).map(|begin| (begin, leave(begin, place(twin), place(h)))),
        };
        all.extend(ends.map(|(p, q)| [p, q]));
    }
    all
}

/// Where the ray on the left of the line from p to q meets the frame.
fn leave(begin: [f64; 2], p: [f64; 2], q: [f64; 2]) -> [f64; 2] {
    let direction = [p[1] - q[1], q[0] - p[0]];
    let until = |i: usize| (FRAME[i].copysign(direction[i]) - begin[i]) / direction[i];
    let times = [0, 1].map(until).into_iter().filter(|t| t.is_finite()).fold(f64::INFINITY, f64::min);
    if times.is_finite() && times > 0.0 { [0, 1].map(|i| begin[i] + times * direction[i]) } else { begin }
}

/// The picture, with the coordinates that the student's program writes: y points down in a file.
pub(super) fn plain() -> String {
    let mut out = Plain::new("-340 -240 680 480");
    lines().into_iter().for_each(|[p, q]| out.edge(p, q));
    SITES.into_iter().for_each(|site| out.vertex(site));
    out.svg()
}
