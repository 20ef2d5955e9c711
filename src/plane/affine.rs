//! Maps that keep straight lines straight.
//!
//! ```text
//!   x' = matrix · x + shift        every coordinate of x' is the exact value, rounded once
//! ```

use super::meet::Expansion;
use super::{CoordinateError, check_coordinate};
use std::cmp::Ordering;

/// An affine map of the plane (`N` = 2) or of space (`N` = 3): a matrix, then a shift. The rows of the matrix come one
/// after the other.
///
/// ```
/// use dcel_kit::plane::Affine;
/// let turn = Affine { matrix: [[0.0, -1.0], [1.0, 0.0]], shift: [10.0, 0.0] };
/// assert_eq!(turn, Affine::quarter_turn().then_by([10.0, 0.0]));
/// ```
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Affine<const N: usize> {
    /// The matrix by its rows.
    pub matrix: [[f64; N]; N],
    /// What is added after that.
    pub shift: [f64; N],
}

impl<const N: usize> Affine<N> {
    /// The map that moves everything by the same way.
    #[must_use]
    pub fn translation(shift: [f64; N]) -> Self {
        Self { shift, ..Self::scaling(1.0) }
    }

    /// The map that makes everything larger by a factor, seen from the origin.
    #[must_use]
    pub fn scaling(factor: f64) -> Self {
        let row = |i| std::array::from_fn(|j| if i == j { factor } else { 0.0 });
        Self { matrix: std::array::from_fn(row), shift: [0.0; N] }
    }

    /// The map that turns round the sign of one coordinate.
    ///
    /// # Panics
    /// If there is no such coordinate.
    #[must_use]
    pub fn reflection(axis: usize) -> Self {
        let mut map = Self::scaling(1.0);
        map.matrix[axis][axis] = -1.0;
        map
    }

    /// The turn by a right angle, counter-clockwise; in space about the z axis, as seen from above.
    ///
    /// # Panics
    /// If there is but one coordinate.
    #[must_use]
    pub fn quarter_turn() -> Self {
        let mut map = Self::scaling(1.0);
        (map.matrix[0][0], map.matrix[0][1]) = (0.0, -1.0);
        (map.matrix[1][0], map.matrix[1][1]) = (1.0, 0.0);
        map
    }

    /// The same map with a further shift after it.
    #[must_use]
    pub fn then_by(mut self, shift: [f64; N]) -> Self {
        (0..N).for_each(|i| self.shift[i] += shift[i]);
        self
    }

    /// Fails unless all numbers are in the range in which products of them with coordinates are exact.
    pub(crate) fn check(&self) -> Result<(), CoordinateError> {
        let numbers = self.matrix.as_flattened().iter().chain(&self.shift);
        numbers.zip(std::iter::repeat('m')).try_for_each(|(&x, axis)| check_coordinate(axis, x))
    }

    /// Where a point goes, and whether that is the exact value.
    pub(crate) fn apply(&self, point: [f64; N]) -> ([f64; N], bool) {
        let mut exact = true;
        let image = std::array::from_fn(|i| {
            let mut sum = Expansion::of(self.shift[i]);
            (0..N).for_each(|j| sum.add_product(self.matrix[i][j], point[j]));
            // Without a sign: no coordinate is -0.
            let rounded = sum.clone().rounded() + 0.0;
            exact &= sum.minus(&Expansion::of(rounded)).sign().is_eq();
            rounded
        });
        (image, exact)
    }

    /// The sign of the determinant: `Greater` keeps the orientation, `Less` reverses it, `Equal` flattens. Exact.
    pub(crate) fn orientation(&self) -> Ordering {
        let entry = |i: usize, j: usize| Expansion::of(self.matrix[i][j]);
        // By the first row; N is 2 or 3.
        let minor = |j: usize| match N {
            2 => entry(1, 1 - j),
            _ => {
                let [a, b] = [(j + 1) % 3, (j + 2) % 3];
                entry(1, a).times(&entry(2, b)).minus(&entry(1, b).times(&entry(2, a)))
            }
        };
        let terms = (0..N).map(|j| entry(0, j).times(&minor(j)));
        let sum = terms.enumerate().fold(Expansion::default(), |sum, (j, term)| {
            if N == 2 && j == 1 { sum.minus(&term) } else { sum.plus(&term) }
        });
        sum.sign()
    }
}
