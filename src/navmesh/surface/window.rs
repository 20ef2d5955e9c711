//! Windows: which part of a side a root sees, in the plane into which the triangles before it are unfolded.
//!
//! ```text
//!                 c (apex)            The side lies on the x-axis, from its left endpoint a = 0 to its right endpoint b; the
//!                ╱ ╲                  triangle behind it is above, and the root below. What is seen of it lies between
//!               ╱   ╲                 the two ends. Behind the triangle it falls on the side a c, on the left of the
//!          a ──┼─────┼── b            ray through c, and on the side c b, on its right.
//!              ends ╱
//!               ╲  ╱
//!               root
//! ```

use super::{NONE, NavSurface, cross, dot, minus, next, norm, prev};

/// What a root sees of a side.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Window {
    /// The side of the triangle that is entered.
    pub(super) side: u32,
    /// The window that it comes from, or `NONE`.
    pub(super) parent: u32,
    /// The node that it is seen from, or `NONE` for the start.
    pub(super) root: u32,
    /// Where there is no parent and a root: the side that leaves the root in the triangle that is left.
    pub(super) corner: u32,
    /// From where to where, along the side.
    pub(super) ends: [f64; 2],
    /// Where the root is: `[x, depth]`, the depth below the axis.
    pub(super) at: [f64; 2],
    /// The length of the path to the root.
    pub(super) length: f64,
}

/// Windows narrower than this part of their side are nothing.
const NARROW: f64 = 1e-14;

impl Window {
    /// The distance from the root to a point of the frame, above the axis or on it.
    #[inline]
    pub(super) fn to(&self, [x, y]: [f64; 2]) -> f64 {
        let [dx, dy] = [x - self.at[0], y + self.at[1]];
        (dx * dx + dy * dy).sqrt()
    }

    /// Where the ray to a point above the axis goes through the side.
    #[inline]
    pub(super) fn pierce(&self, [x, y]: [f64; 2]) -> f64 {
        let whole = y + self.at[1];
        if whole > 0.0 { self.at[0] + (x - self.at[0]) * (self.at[1] / whole) } else { x }
    }

    /// The length of the straight path to a point above the axis; `None` if the window does not see it.
    #[inline]
    pub(super) fn length_to(&self, p: [f64; 2]) -> Option<f64> {
        let x = self.pierce(p);
        (self.ends[0] <= x && x <= self.ends[1]).then(|| self.length + self.to(p))
    }

    /// The least length that a path through the window to the goal may have, as the crow flies behind it. `goal` is where
    /// the goal would be if it were turned round the side into the plane.
    #[inline]
    pub(super) fn guess(&self, goal: [f64; 2]) -> f64 {
        let x = self.pierce(goal).clamp(self.ends[0], self.ends[1]);
        let [dx, dy] = [goal[0] - x, goal[1]];
        self.length + self.to([x, 0.0]) + (dx * dx + dy * dy).sqrt()
    }

    /// The length to the nearest point of the window.
    pub(super) fn nearest(&self) -> f64 {
        self.length + self.to([self.at[0].clamp(self.ends[0], self.ends[1]), 0.0])
    }

    /// What is seen of the left side of the triangle behind, `a c`, and of the right one, `c b`: where the window falls on
    /// them, if it does. `number` is its own.
    pub(super) fn children(&self, surface: &NavSurface, number: u32) -> [Option<Self>; 2] {
        let side = &surface.sides[self.side as usize];
        let c = side.apex;
        let through = self.pierce(c);
        let [low, high] = self.ends;
        let (to_left, to_right) = (prev(self.side as usize), next(self.side as usize));
        let child = |exit: usize, from: [f64; 2], to: [f64; 2], seen: [f64; 2], sees: bool| {
            let twin = surface.sides[exit].twin;
            if !sees || twin == NONE {
                return None;
            }
            let length = surface.sides[exit].length;
            // The x-axis of the side behind, with the triangle beyond above it.
            let axis = [(to[0] - from[0]) / length, (to[1] - from[1]) / length];
            let into = |[x, y]: [f64; 2]| {
                let [x, y] = [x - from[0], y - from[1]];
                [x * axis[0] + y * axis[1], x * axis[1] - y * axis[0]]
            };
            let at = into([self.at[0], -self.at[1]]);
            let meet = |x: f64| {
                let [px, depth] = into([x, 0.0]);
                let fall = at[1] - depth;
                if fall > 0.0 {
                    (at[0] + (px - at[0]) * (at[1] / fall)).clamp(0.0, length)
                } else {
                    px.clamp(0.0, length)
                }
            };
            let ends = [
                if seen[0] == f64::NEG_INFINITY { 0.0 } else { meet(seen[0]) },
                if seen[1] == f64::INFINITY { length } else { meet(seen[1]) },
            ];
            let found = Self {
                side: twin,
                parent: number,
                root: self.root,
                corner: NONE,
                ends,
                at: [at[0], at[1].max(0.0)],
                length: self.length,
            };
            (ends[1] - ends[0] > NARROW * length).then_some(found)
        };
        let b = [side.length, 0.0];
        let left_end = if low <= 0.0 { f64::NEG_INFINITY } else { low };
        let right_end = if high >= side.length { f64::INFINITY } else { high };
        [
            child(
                to_left,
                [0.0, 0.0],
                c,
                [left_end, if high >= through { f64::INFINITY } else { high }],
                low < through,
            ),
            child(to_right, c, b, [if low <= through { f64::NEG_INFINITY } else { low }, right_end], high > through),
        ]
    }
}

impl NavSurface {
    /// Where a point of space is in the frame of a side, if it is turned round the side into the plane above it. Measured from
    /// the nearer end of the side, so that beside an end as few digits are lost as the point has; never by differences of
    /// squared lengths, which lose half of them.
    pub(super) fn turned(&self, side: usize, p: [f64; 3]) -> [f64; 2] {
        let [a, b] = self.ends(side);
        let (along, length) = (minus(b, a), self.sides[side].length);
        let mut off = minus(p, a);
        let mut x = dot(along, off) / length;
        if x + x > length {
            off = minus(p, b);
            x = length + dot(along, off) / length;
        }
        [x, norm(cross(along, off)) / length]
    }
}
