//! Vectors in space: the arithmetic of measures, by which nothing is decided; and what is decided exactly of one place and
//! of three.

use super::point::{CoordinateError, Point, check_coordinate};
use super::predicates::orientation;
use std::cmp::Ordering;

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

/// The normal of a triangle, twice as long as its area.
#[inline]
pub(crate) fn normal([a, b, c]: [Vector; 3]) -> Vector {
    cross(minus(b, a), minus(c, a))
}

#[inline]
pub(crate) fn length(a: Vector) -> f64 {
    dot(a, a).sqrt()
}

/// How far two points are from each other.
#[cfg(feature = "navmesh")]
pub(crate) fn between(a: Vector, b: Vector) -> f64 {
    length(minus(b, a))
}

/// The point at the fraction `t` of the path from `a` to `b`.
#[cfg(feature = "navmesh")]
#[inline]
pub(crate) fn lerp(a: Vector, b: Vector, t: f64) -> Vector {
    [0, 1, 2].map(|i| a[i] + (b[i] - a[i]) * t)
}

/// Whether three points lie on one line, exactly: they do as seen along each axis.
pub(crate) fn are_collinear(a: Vector, b: Vector, c: Vector) -> bool {
    (0..3).all(|axis| {
        let shadow = |p: Vector| Point::new(p[(axis + 1) % 3], p[(axis + 2) % 3]);
        orientation(shadow(a), shadow(b), shadow(c)) == Ordering::Equal
    })
}
