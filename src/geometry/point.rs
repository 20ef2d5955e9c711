//! Points of the plane and the check at the door.

use std::fmt;

/// A point of the plane; y points up.
#[derive(Clone, Copy, PartialEq, PartialOrd, Debug, Default)]
pub struct Point {
    /// To the right.
    pub x: f64,
    /// Upwards.
    pub y: f64,
}

/// Coordinates other than 0 must not be closer to 0 than this: 2^-142.
pub const SMALLEST: f64 = 1.793_662_034_335_766e-43;
/// Coordinates must not be further from 0 than this: 2^201.
pub const LARGEST: f64 = 3.213_876_088_517_980_6e60;

/// A coordinate with which the exact predicates would not be exact.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CoordinateError {
    /// Not a number, or infinite.
    #[error("{axis} is {value}: coordinates must be finite numbers")]
    NotFinite {
        /// `x` or `y` (or `z`).
        axis: char,
        /// The coordinate.
        value: f64,
    },
    /// Too far from 0 or too close to it.
    #[error(
        "{axis} = {value:e} is outside the exact range: 0, or between 2^-142 = 1.8e-43 and 2^201 = 3.2e60 in size; {}",
        if value.abs() < 1.0 { "make it 0, or scale the input" } else { "scale the input" }
    )]
    OutOfRange {
        /// `x` or `y` (or `z`).
        axis: char,
        /// The coordinate.
        value: f64,
    },
}

/// Checks one coordinate: finite, and 0 or of a size between 2^-142 and 2^201, where the predicates are exact.
///
/// Source: the range is measured for crate robust 1.2; `incircle` fails first, near 2^±300.
pub fn check_coordinate(axis: char, value: f64) -> Result<(), CoordinateError> {
    if !value.is_finite() {
        return Err(CoordinateError::NotFinite { axis, value });
    }
    if value != 0.0 && !(SMALLEST..=LARGEST).contains(&value.abs()) {
        return Err(CoordinateError::OutOfRange { axis, value });
    }
    Ok(())
}

/// The lower left and the upper right corner of the box round some points; of none, a box that holds nothing.
pub(crate) fn corners(points: impl IntoIterator<Item = Point>) -> [Point; 2] {
    let nothing = [f64::INFINITY, f64::NEG_INFINITY].map(|x| Point::new(x, x));
    points.into_iter().fold(nothing, around)
}

/// The corners of the box round another box and a point.
#[inline]
pub(crate) fn around([low, high]: [Point; 2], p: Point) -> [Point; 2] {
    [Point::new(low.x.min(p.x), low.y.min(p.y)), Point::new(high.x.max(p.x), high.y.max(p.y))]
}

impl Point {
    /// The point (x, y).
    #[must_use]
    pub const fn new(x: f64, y: f64) -> Self {
        Self { x, y }
    }

    /// Checks both coordinates, see [`check_coordinate`].
    pub fn check(self) -> Result<(), CoordinateError> {
        check_coordinate('x', self.x)?;
        check_coordinate('y', self.y)
    }
}

impl From<[f64; 2]> for Point {
    fn from([x, y]: [f64; 2]) -> Self {
        Self { x, y }
    }
}

impl From<Point> for [f64; 2] {
    fn from(Point { x, y }: Point) -> Self {
        [x, y]
    }
}

impl From<(f64, f64)> for Point {
    fn from((x, y): (f64, f64)) -> Self {
        Self { x, y }
    }
}

impl fmt::Display for Point {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "({}, {})", self.x, self.y)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_limits_are_the_powers_of_two_they_claim() {
        assert_eq!(SMALLEST.to_bits(), 2f64.powi(-142).to_bits());
        assert_eq!(LARGEST.to_bits(), 2f64.powi(201).to_bits());
        for good in [0.0, -0.0, SMALLEST, -LARGEST, 1.0] {
            assert_eq!(check_coordinate('x', good), Ok(()));
        }
        for bad in [f64::NAN, f64::INFINITY, SMALLEST / 2.0, -LARGEST * 2.0, 5e-324] {
            assert!(check_coordinate('x', bad).is_err(), "{bad} was accepted");
        }
    }
}
