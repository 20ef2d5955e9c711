//! The frame of the picture: rays end at it.
//!
//! ```text
//!   (-320, 220) ┌──────────────┐
//!               │   ●──────────● leave     y points up
//!               └──────────────┘ (320, -220)
//! ```

// You need not use every function that is given here.
#![allow(dead_code)]

use crate::dcel::Point;

/// Half of its width and of its height.
const HALF: Point = Point { x: 320.0, y: 220.0 };

/// Where the ray from `start` in a direction leaves the frame; `start` itself if the ray never
/// comes to a side of the frame.
pub fn leave(start: Point, direction: Point) -> Point {
    let until = |at: f64, by: f64, half: f64| {
        if by > 0.0 {
            (half - at) / by
        } else if by < 0.0 {
            (-half - at) / by
        } else {
            f64::INFINITY
        }
    };
    let (x, y) = (until(start.x, direction.x, HALF.x), until(start.y, direction.y, HALF.y));
    let times = x.min(y);
    if !times.is_finite() || times <= 0.0 {
        return start;
    }
    Point { x: start.x + times * direction.x, y: start.y + times * direction.y }
}
