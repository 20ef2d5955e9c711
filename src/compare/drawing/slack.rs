//! How near to each other things are drawn that belong together.
//!
//! ```text
//!   ───┤■├───      ends of lines and rims of boxes, tips of arrows and vertices: at least 0.6 px of a drawing of 600 px
//!   ───▸ ● ← ─ ─   how far aside of a middle a line points: as far as points may be from their places, or a few times
//! ```
//!
//! All of it follows the tolerance of the comparison. Programs leave gaps of their own at rims, however exact the places
//! are: there a smaller tolerance changes nothing.

/// How near to a rim or to a vertex something ends, as a part of the drawing, and in tolerances.
const NEAR: [f64; 2] = [1e-3, 2.0];
/// How near to a middle, the same.
const AT: [f64; 2] = [1e-4, 1.2];
/// The largest tolerance that counts here, as a part of the drawing: beyond it all would be near.
const MOST: f64 = 5e-3;

/// How near is near in a drawing of some size.
#[derive(Clone, Copy)]
pub(super) struct Slack {
    /// The size of the drawing.
    pub(super) size: f64,
    /// How far a point may be from its place.
    pub(super) tolerance: f64,
}

impl Slack {
    /// For a drawing of this size; `tolerance` is a part of it.
    pub(super) fn new(size: f64, tolerance: f64) -> Self {
        Self { size, tolerance: tolerance.min(MOST) * size }
    }

    /// How far from a rim or a vertex a line or the tip of an arrow may end.
    pub(super) fn near(&self) -> f64 {
        self.at_least(NEAR)
    }

    /// How far from the middle of a mark the end of its line may lie.
    pub(super) fn at(&self) -> f64 {
        self.at_least(AT)
    }

    fn at_least(&self, [part, tolerances]: [f64; 2]) -> f64 {
        (part * self.size).max(tolerances * self.tolerance)
    }
}
