//! Vectors in space: the arithmetic of measures. Decisions are made by `predicates.rs`, never here.

pub(super) type Vector = [f64; 3];

pub(super) fn minus(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub(super) fn plus(a: Vector, b: Vector) -> Vector {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

pub(super) fn times(a: Vector, factor: f64) -> Vector {
    a.map(|x| x * factor)
}

pub(super) fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(super) fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub(super) fn length(a: Vector) -> f64 {
    dot(a, a).sqrt()
}

/// The mean of some points; the origin if there are none.
pub(super) fn mean(points: impl Iterator<Item = Vector>) -> Vector {
    let (sum, count) = points.fold(([0.0; 3], 0.0), |(sum, count), p| (plus(sum, p), count + 1.0));
    times(sum, 1.0 / f64::max(count, 1.0))
}

/// The vector of length 1 in the same direction; none of a vector without length.
pub(super) fn unit(vector: Vector) -> Option<Vector> {
    let size = length(vector);
    (size > 0.0).then(|| times(vector, 1.0 / size))
}
