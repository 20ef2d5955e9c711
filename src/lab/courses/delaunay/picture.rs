//! The picture of the handout: the Delaunay triangulation of its sites, with the circles.

use crate::cases::handouts::{SITES, circle};
use crate::pictures::Plain;
use dcel_kit::plane::{Point, Subdivision};

/// The picture, with the coordinates that the student's program writes: y points down in a file.
pub(super) fn plain() -> String {
    let mut out = Plain::new("-260 -260 520 490");
    let Ok(built) = Subdivision::delaunay(&SITES.map(Point::from)) else { return out.svg() };
    let built = built.subdivision;
    for f in built.faces().skip(1) {
        let corners: Vec<Point> = built.incident_vertices(f).map(|v| built.point(v)).collect();
        let Ok(corners) = <[Point; 3]>::try_from(corners) else { continue };
        out.ring(circle(corners));
    }
    for edge in built.edges() {
        let [p, q] = edge.half_edges().map(|h| built.point(built.origin(h)));
        out.wide_edge(p, q);
    }
    SITES.into_iter().for_each(|site| out.vertex(site));
    out.svg()
}
