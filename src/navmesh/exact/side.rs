//! The sides of a room, as a cone meets them.
//!
//! ```text
//!        room
//!   left ●─────● right       root ·   ●═════●   ●═════●      Seen edge-on: on one line with the root, which sees nothing
//!           ·                         nearest   the next     behind them but round their nearer ends.
//!          root
//! ```

use super::super::rooms::Corner;
use crate::plane::Point;

/// A side of the room.
#[derive(Clone, Copy, Debug)]
pub(super) struct Side {
    /// Its number, and that of the next one, which starts at its left end.
    pub(super) number: usize,
    pub(super) next: usize,
    /// Its ends, as seen from within the room.
    pub(super) right: Corner,
    pub(super) left: Corner,
}

impl Side {
    /// The places of its ends, the right one first.
    #[inline]
    pub(super) fn endpoints(&self) -> [Point; 2] {
        [self.right.at, self.left.at]
    }
}

/// A side seen edge-on, the nearest so far of those on its line.
#[derive(Clone, Copy, Debug)]
pub(super) struct EdgeOn {
    /// The root that sees it, and the length of the path to the nearer end.
    pub(super) from: u32,
    pub(super) length: f64,
    pub(super) side: Side,
    /// Whether the nearer end is the right one: one line at most is seen that way, and one the other.
    pub(super) forwards: bool,
}
