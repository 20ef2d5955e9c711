//! Points as vectors of `glam`.

use crate::plane::Point;
use ::glam::{DVec2, Vec2};

as_xy!(DVec2);

/// Exact: every `f32` is an `f64`. The way back would round, and is left to the caller: `DVec2::from(p).as_vec2()`.
impl From<Vec2> for Point {
    fn from(p: Vec2) -> Self {
        Self::new(f64::from(p.x), f64::from(p.y))
    }
}
