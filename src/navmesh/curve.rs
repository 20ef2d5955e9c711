//! An order of places in which what is near is mostly near in the row, too.
//!
//! ```text
//!   2 3 │ 6 7      The bits of both coordinates, in turns. What is stored in this order and read from neighbour to
//!   0 1 │ 4 5      neighbour stays in the nearest memory.
//! ```
//!
//! Source: Morton, *A computer oriented geodetic data base and a new technique in file sequencing*, 1966.

use super::NavMesh;
use crate::plane::Point;

/// The curve over a mesh.
#[derive(Clone, Debug)]
pub(super) struct Curve {
    low: Point,
    scale: f64,
}

impl Curve {
    /// The curve over all corners. O(n).
    pub(super) fn over(mesh: &NavMesh) -> Self {
        let corners = || mesh.faces().flat_map(|f| mesh.corners(f)).map(|v| mesh.point(v));
        let low = corners().fold([f64::INFINITY; 2], |low, p| [low[0].min(p.x), low[1].min(p.y)]);
        let size = corners().map(|p| (p.x - low[0]).max(p.y - low[1])).fold(0.0, f64::max);
        Self { low: low.into(), scale: f64::from(1 << 15) / size }
    }

    /// Where a point is on it.
    pub(super) fn key(&self, p: Point) -> u64 {
        let spread = |x: f64| (0..16).fold(0, |key, bit| key | ((x as u64 >> bit & 1) << (2 * bit)));
        spread((p.x - self.low.x) * self.scale) | spread((p.y - self.low.y) * self.scale) << 1
    }
}
