//! Vectors in space, sums and means of them: the arithmetic of measures. Decisions are made by `predicates.rs`, never here.

pub(crate) use crate::geometry::space::{Vector, cross, dot, length, minus, normal};

pub(crate) fn plus(a: Vector, b: Vector) -> Vector {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

pub(super) fn times(a: Vector, factor: f64) -> Vector {
    a.map(|x| x * factor)
}

/// A sum of many numbers that loses no more than a few last places of the sum of their sizes, however many they are.
///
/// Source: A. Neumaier, *Rundungsfehleranalyse einiger Verfahren zur Summation endlicher Summen*, 1974.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Sum {
    sum: f64,
    lost: f64,
}

impl Sum {
    pub(super) fn add(&mut self, x: f64) {
        let sum = self.sum + x;
        self.lost += if self.sum.abs() >= x.abs() { (self.sum - sum) + x } else { (x - sum) + self.sum };
        self.sum = sum;
    }

    pub(super) fn value(self) -> f64 {
        self.sum + self.lost
    }

    pub(super) fn of(numbers: impl Iterator<Item = f64>) -> f64 {
        let mut sum = Self::default();
        numbers.for_each(|x| sum.add(x));
        sum.value()
    }
}

/// The mean of some points; the origin if there are none.
pub(super) fn mean(points: impl Iterator<Item = Vector>) -> Vector {
    let (mut sums, mut count) = ([Sum::default(); 3], 0.0_f64);
    for p in points {
        (0..3).for_each(|i| sums[i].add(p[i]));
        count += 1.0;
    }
    sums.map(|sum| sum.value() / count.max(1.0))
}

/// The vector of length 1 in the same direction; none of a vector without length.
pub(super) fn unit(vector: Vector) -> Option<Vector> {
    let size = length(vector);
    (size > 0.0).then(|| times(vector, 1.0 / size))
}
