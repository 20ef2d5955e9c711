//! The picture of the handout: the Delaunay triangulation of its sites, with the circles.

use crate::cases::handouts::SITES;
use crate::pictures::Plain;
use dcel_kit::plane::{Point, Subdivision};

/// A circle is drawn as a polygon of so many corners.
const CORNERS: u32 = 56;

/// The centre of the circle through three points, by the lines that halve two sides, and its radius.
fn centre([a, b, c]: [Point; 3]) -> ([f64; 2], f64) {
    let [p, q] = [b, c].map(|to| [to.x - a.x, to.y - a.y]);
    let [pp, qq] = [p, q].map(|v| (v[0] * v[0] + v[1] * v[1]) / 2.0);
    let det = p[0] * q[1] - p[1] * q[0];
    let from_a = [(pp * q[1] - qq * p[1]) / det, (p[0] * qq - q[0] * pp) / det];
    ([a.x + from_a[0], a.y + from_a[1]], from_a[0].hypot(from_a[1]))
}

/// The picture, with the coordinates that the student's program writes: y points down in a file.
pub(super) fn plain() -> String {
    let mut out = Plain::new("-260 -260 520 490");
    let Ok(built) = Subdivision::delaunay(&SITES.map(Point::from)) else { return out.svg() };
    let built = built.subdivision;
    for f in built.faces().skip(1) {
        let corners: Vec<Point> = built.incident_vertices(f).map(|v| built.point(v)).collect();
        let Ok(corners) = <[Point; 3]>::try_from(corners) else { continue };
        let ([x, y], radius) = centre(corners);
        out.ring((0..CORNERS).map(|i| {
            let (sin, cos) = (std::f64::consts::TAU * f64::from(i) / f64::from(CORNERS)).sin_cos();
            [x + radius * cos, y + radius * sin]
        }));
    }
    for edge in built.edges() {
        let [p, q] = edge.half_edges().map(|h| built.point(built.origin(h)));
        out.wide_edge(p, q);
    }
    SITES.into_iter().for_each(|site| out.vertex(site));
    out.svg()
}
