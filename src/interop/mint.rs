//! Points as those of `mint`.

use ::mint::{Point2, Vector2};

as_xy!(Point2<f64>, Vector2<f64>);
