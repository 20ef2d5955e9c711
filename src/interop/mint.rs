//! Points as those of `mint`.

use crate::plane::Point;
use ::mint::{Point2, Vector2};

macro_rules! as_xy {
    ($($theirs:ident),*) => {$(
        impl From<$theirs<f64>> for Point {
            fn from(p: $theirs<f64>) -> Self {
                Self::new(p.x, p.y)
            }
        }

        impl From<Point> for $theirs<f64> {
            fn from(p: Point) -> Self {
                Self { x: p.x, y: p.y }
            }
        }
    )*};
}

as_xy!(Point2, Vector2);
