//! Vectors in space: the arithmetic of measures. Decisions are made by predicates, never here.

use super::point::{CoordinateError, check_coordinate};

pub(crate) type Vector = [f64; 3];

/// Whether all coordinates of a point are in the range in which signs are exact.
pub(crate) fn check_place(place: Vector) -> Result<(), CoordinateError> {
    ['x', 'y', 'z'].into_iter().zip(place).try_for_each(|(axis, x)| check_coordinate(axis, x))
}

#[inline]
pub(crate) fn minus(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

#[inline]
pub(crate) fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[inline]
pub(crate) fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

#[inline]
pub(crate) fn length(a: Vector) -> f64 {
    dot(a, a).sqrt()
}
