//! Transforms: six numbers that take a point of an element to the canvas.
//!
//! ```text
//!   translate(10 20) scale(2)     x ↦ 2x + 10, y ↦ 2y + 20: the last one is applied first
//! ```

use super::numbers::{Reader, list};

/// `x ↦ a·x + c·y + e`, `y ↦ b·x + d·y + f`.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Transform([f64; 6]);

impl Transform {
    pub(super) const IDENTITY: Self = Self([1.0, 0.0, 0.0, 1.0, 0.0, 0.0]);

    pub(super) fn translate(x: f64, y: f64) -> Self {
        Self([1.0, 0.0, 0.0, 1.0, x, y])
    }

    pub(super) fn apply(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [a, b, c, d, e, f] = self.0;
        [a * x + c * y + e, b * x + d * y + f]
    }

    /// `inner` first, then this one.
    pub(super) fn after(&self, inner: &Self) -> Self {
        let [a, b, c, d, e, f] = self.0;
        let [p, q, r, s, t, u] = inner.0;
        Self([a * p + c * q, b * p + d * q, a * r + c * s, b * r + d * s, a * t + c * u + e, b * t + d * u + f])
    }

    /// The value of a `transform` attribute.
    pub(super) fn read(text: &str) -> Option<Self> {
        let mut reader = Reader::new(text);
        let mut out = Self::IDENTITY;
        while !reader.at_end() {
            let name = reader.word();
            reader.sign(b'(')?;
            let rest = reader.rest();
            let inside = rest.split(')').next()?;
            out = out.after(&Self::function(name, &list(inside)?)?);
            reader = Reader::new(rest.get(inside.len() + 1..)?);
        }
        Some(out)
    }

    fn function(name: &str, numbers: &[f64]) -> Option<Self> {
        Some(match (name, numbers) {
            ("matrix", &[a, b, c, d, e, f]) => Self([a, b, c, d, e, f]),
            ("translate", &[x]) => Self::translate(x, 0.0),
            ("translate", &[x, y]) => Self::translate(x, y),
            ("scale", &[s]) => Self([s, 0.0, 0.0, s, 0.0, 0.0]),
            ("scale", &[x, y]) => Self([x, 0.0, 0.0, y, 0.0, 0.0]),
            ("rotate", &[degrees]) => Self::rotate(degrees),
            ("rotate", &[degrees, x, y]) => {
                Self::translate(x, y).after(&Self::rotate(degrees)).after(&Self::translate(-x, -y))
            }
            ("skewX", &[degrees]) => Self([1.0, 0.0, degrees.to_radians().tan(), 1.0, 0.0, 0.0]),
            ("skewY", &[degrees]) => Self([1.0, degrees.to_radians().tan(), 0.0, 1.0, 0.0, 0.0]),
            _ => return None,
        })
    }

    /// Quarter turns are exact.
    fn rotate(degrees: f64) -> Self {
        let (sine, cosine) = match degrees.rem_euclid(360.0) {
            0.0 => (0.0, 1.0),
            90.0 => (1.0, 0.0),
            180.0 => (0.0, -1.0),
            270.0 => (-1.0, 0.0),
            other => other.to_radians().sin_cos(),
        };
        Self([cosine, sine, -sine, cosine, 0.0, 0.0])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_function_is_applied_first() {
        let t = Transform::read("translate(10,20) scale(2)").unwrap();
        assert_eq!(t.apply([1.0, 1.0]).map(|x| x as i32), [12, 22]);
        let t = Transform::read("scale(1 -1),rotate(90 1 1) matrix(1 0 0 1 5 0)").unwrap();
        assert_eq!(t.apply([0.0, 0.0]).map(|x| x as i32), [2, -5]);
        assert_eq!(Transform::read(""), Some(Transform::IDENTITY));
        for wrong in ["scale", "scale(1", "turn(3)", "scale(1,2,3)", "scale(1)x"] {
            assert_eq!(Transform::read(wrong), None, "{wrong}");
        }
    }
}
