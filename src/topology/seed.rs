//! Structures to start from.

use super::Dcel;
use super::links::Columns;
use super::pool::TooMany;

/// Why there is no such polygon.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum PolygonError {
    /// A polygon without a corner.
    #[error("a polygon needs at least one corner, better three")]
    NoCorner,
    /// More corners than ids.
    #[error(transparent)]
    TooMany(#[from] TooMany),
}

impl Dcel {
    /// A polygon with `corners` corners and two faces, `f1` inside and `f0` outside: a double-sided disc.
    ///
    /// ```text
    ///        h5 ───────────>
    ///      v0 ●───────────● v2        inside (f1):  h0, h2, h4: h(2i) runs from v(i) to v(i+1)
    ///          \ <── h4  /            outside (f0): their twins h1, h3, h5
    ///        h0 \   f1  / h2
    ///            \     /      f0
    ///             ● v1
    /// ```
    ///
    /// With one corner the edge is a loop, with two the edges are parallel; the kernel takes both.
    ///
    /// Source: the half-edge lab's six-vertex start; the "ring" of the GenMesh article.
    ///
    /// # Errors
    /// [`PolygonError`] if `corners` is 0 or too large.
    pub fn polygon(corners: usize) -> Result<Self, PolygonError> {
        if corners == 0 {
            return Err(PolygonError::NoCorner);
        }
        TooMany::check(corners, corners, 2)?;
        let n = corners as u32;
        let both = |inside: fn(u32, u32) -> u32, outside: fn(u32, u32) -> u32| {
            (0..n).flat_map(|i| [inside(i, n), outside(i, n)]).collect()
        };
        Ok(Self::from_columns(Columns {
            origin: both(|i, _| i, |i, n| (i + 1) % n),
            next: both(|i, n| 2 * ((i + 1) % n), |i, n| 2 * ((i + n - 1) % n) + 1),
            prev: both(|i, n| 2 * ((i + n - 1) % n), |i, n| 2 * ((i + 1) % n) + 1),
            face: both(|_, _| 1, |_, _| 0),
            outgoing: (0..n).map(|i| 2 * i).collect(),
            boundary: vec![1, 0],
        }))
    }

    /// The torus with 1 vertex, 1 face and 2 edges, a horizontal and a vertical one; both are loops.
    ///
    /// ```text
    ///      v0 ●───────────────────● v0        the four sides are two edges, the four corners one vertex;
    ///         │   <───── h1       │           the face f0 runs h0 right, h2 up, h1 back, h3 down
    ///         │ │             ^   │
    ///         │ │ h3   f0  h2 │   │
    ///         │ v             │   │
    ///         │       h0 ─────>   │
    ///      v0 ●───────────────────● v0
    /// ```
    ///
    /// Splits of vertices and faces keep the genus, so no polygon grows into a torus; from this one all grow.
    ///
    /// Source: the last section of the GenMesh article.
    ///
    /// ```
    /// use dcel_kit::topology::{Dcel, measure};
    /// assert_eq!(measure(&Dcel::torus()).genus(), 1);
    /// ```
    #[must_use]
    pub fn torus() -> Self {
        Self::from_columns(Columns {
            origin: vec![0; 4],
            next: vec![2, 3, 1, 0],
            prev: vec![3, 2, 0, 1],
            face: vec![0; 4],
            outgoing: vec![0],
            boundary: vec![0],
        })
    }
}
