//! Sums of positions, and what sharp edges do to a vertex.
//!
//! ```text
//!   sharp edges at v     where v goes
//!   none, or one         where the smooth rule sends it
//!   two                  (e1 + 6 v + e2) / 8, with e1 and e2 their other ends: its place on the curve
//!   three and more       nowhere
//! ```

use super::refine::{Coarse, PIECE};
use crate::geometry::threads::pieces;
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

/// Where the old vertices go: by the rule of `smooth` for a vertex and its place, but for those that are held, and those
/// without edges, which stay.
pub(super) fn move_vertices(
    coarse: &Coarse<'_>,
    places: &mut [Point],
    smooth: impl Fn(VertexId, Point) -> Point + Sync,
) {
    pieces(places, PIECE, |first, piece| {
        for (v, place) in (first as u32..).map(VertexId::new).zip(piece) {
            let here = coarse.solid.point(v);
            *place = match coarse.dcel().outgoing(v) {
                None => here,
                Some(_) => held(coarse, v).unwrap_or_else(|| smooth(v, here)),
            };
        }
    });
}

/// Where a vertex with two and more sharp edges goes; `None` if the smooth rule holds.
#[inline]
fn held(coarse: &Coarse<'_>, v: VertexId) -> Option<Point> {
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
