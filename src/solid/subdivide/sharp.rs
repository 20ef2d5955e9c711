//! Sums of positions, and what sharp edges do to a vertex.
//!
//! ```text
//!   sharp edges at v     where v goes
//!   none, or one         where the smooth rule sends it
//!   two                  (e1 + 6 v + e2) / 8, with e1 and e2 their other ends: its place on the curve
//!   three and more       nowhere
//! ```

use super::refine::Coarse;
use crate::ids::VertexId;

pub(super) type Point = [f64; 3];

#[inline]
pub(super) fn add(sum: &mut Point, p: Point) {
    for (s, x) in sum.iter_mut().zip(p) {
        *s += x;
    }
}

/// The sum of weighted points.
#[inline]
pub(super) fn weighted<const N: usize>(parts: [(f64, Point); N]) -> Point {
    std::array::from_fn(|i| parts.iter().map(|(weight, p)| weight * p[i]).sum())
}

/// Where a vertex with two and more sharp edges goes; `None` if the smooth rule holds.
#[inline]
pub(super) fn held(coarse: &Coarse<'_>, v: VertexId) -> Option<Point> {
    let (d, here) = (coarse.dcel(), coarse.solid.point(v));
    let (mut ends, mut sharp, mut on_border) = ([0.0; 3], 0, false);
    for h in d.outgoing_half_edges(v).filter(|&h| coarse.is_sharp(h)) {
        sharp += 1;
        on_border |= !coarse.has_corner(h);
        add(&mut ends, coarse.solid.point(d.destination(h)));
    }
    match sharp {
        0 | 1 if !on_border => None,
        2 => Some(weighted([(0.75, here), (0.125, ends)])),
        _ => Some(here),
    }
}
