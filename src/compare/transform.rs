//! Transforms: six numbers that take a point of an element to the canvas.
//!
//! ```text
//!   translate(10 20) scale(2)     x ↦ 2x + 10, y ↦ 2y + 20: the last one is applied first
//! ```

use super::numbers::{Reader, length, list, measure};

/// `x ↦ a·x + c·y + e`, `y ↦ b·x + d·y + f`.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Transform([f64; 6]);

impl Default for Transform {
    fn default() -> Self {
        Self::IDENTITY
    }
}

impl Transform {
    pub(super) const IDENTITY: Self = Self([1.0, 0.0, 0.0, 1.0, 0.0, 0.0]);

    /// Its numbers, to be found again by.
    pub(super) fn bits(&self) -> [u64; 6] {
        self.0.map(f64::to_bits)
    }

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

    pub(super) fn scale(x: f64, y: f64) -> Self {
        Self([x, 0.0, 0.0, y, 0.0, 0.0])
    }

    /// A direction without the shift.
    pub(super) fn turn(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [a, b, c, d, ..] = self.0;
        [a * x + c * y, b * x + d * y]
    }

    /// How much lengths grow, taken over all directions.
    pub(super) fn growth(&self) -> f64 {
        let [a, b, c, d, ..] = self.0;
        (a * d - b * c).abs().sqrt()
    }

    /// The value of a `transform` attribute, or of the property `transform` in a style, with its units.
    pub(super) fn read(text: &str) -> Option<Self> {
        let mut reader = Reader::new(text);
        let mut out = Self::IDENTITY;
        while !reader.at_end() {
            let name = reader.word();
            reader.sign(b'(')?;
            let rest = reader.rest();
            let inside = rest.split(')').next()?;
            let numbers = list(inside).or_else(|| with_units(inside))?;
            out = out.after(&Self::function(name, &numbers)?);
            reader = Reader::new(rest.get(inside.len() + 1..)?);
        }
        Some(out)
    }

    fn function(name: &str, numbers: &[f64]) -> Option<Self> {
        Some(match (name, numbers) {
            ("matrix", &[a, b, c, d, e, f]) => Self([a, b, c, d, e, f]),
            ("translate" | "translateX", &[x]) => Self::translate(x, 0.0),
            ("translate", &[x, y]) => Self::translate(x, y),
            ("translateY", &[y]) => Self::translate(0.0, y),
            ("scale", &[s]) => Self::scale(s, s),
            ("scale", &[x, y]) => Self::scale(x, y),
            ("scaleX", &[x]) => Self::scale(x, 1.0),
            ("scaleY", &[y]) => Self::scale(1.0, y),
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

/// `10px, 2cm` or `90deg` as numbers: px and degrees.
fn with_units(text: &str) -> Option<Vec<f64>> {
    let words = text.split([',', ' ']).map(str::trim).filter(|word| !word.is_empty());
    words
        .map(|word| match (word.strip_suffix("deg"), word.strip_suffix("turn"), word.strip_suffix("rad")) {
            (Some(degrees), ..) => length(degrees),
            (_, Some(turns), _) => length(turns).map(|turns| 360.0 * turns),
            (.., Some(radians)) => length(radians).map(f64::to_degrees),
            _ => measure(word),
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_functions_of_styles_have_units() {
        let t = Transform::read("translate(1in, 4px) rotate(90deg) scaleX(2)").unwrap();
        assert_eq!(t.apply([1.0, 1.0]).map(|x| x as i32), [95, 6]);
        assert_eq!(Transform::read("rotate(.25turn)"), Transform::read("rotate(90)"));
        assert_eq!(Transform::read("translate(5%)"), None);
    }

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
