//! Where a vertex stands among the corners of a face that has many.
//!
//! ```text
//!   f3, 9 sides      v4 v8 v1 v6 v2 v9 v5 v7 v3        in a face of few sides one looks at all of them;
//!   sorted           v1 v2 v3 v4 v5 v6 v7 v8 v9        a face of many is kept in the order of the vertices, too
//!   k                 2  4  8  0  6  3  7  1  5
//! ```
//!
//! Otherwise a walk round every corner of a face of n sides would take n² steps.
//!
//! Memory: 8 bytes a corner of a face with more than [`FEW`] sides; nothing for others.

use std::collections::BTreeMap;

/// Up to so many sides, looking at all of them is as quick.
pub(super) const FEW: usize = 24;

/// The corners of the faces with more than [`FEW`] sides.
#[derive(Clone, Debug, Default)]
pub(super) struct ManyCorners {
    /// For each such face its vertices in increasing order, each with its place among the sides.
    faces: BTreeMap<u32, Box<[(u32, u32)]>>,
}

impl ManyCorners {
    /// Takes in face `f`, if it has many corners. O(k log k) for k corners.
    pub(super) fn insert(&mut self, f: u32, corners: impl ExactSizeIterator<Item = u32>) {
        if corners.len() > FEW {
            let mut places: Box<[(u32, u32)]> = corners.zip(0..).collect();
            places.sort_unstable();
            self.faces.insert(f, places);
        }
    }

    /// Face `f` is gone.
    pub(super) fn remove(&mut self, f: u32) {
        self.faces.remove(&f);
    }

    /// Which corner of face `f` the vertex `v` is, counted from 0. O(log n).
    pub(super) fn place(&self, f: u32, v: u32) -> Option<usize> {
        let places = self.faces.get(&f)?;
        let i = places.binary_search_by_key(&v, |&(vertex, _)| vertex).ok()?;
        Some(places[i].1 as usize)
    }

    pub(super) fn memory(&self) -> usize {
        self.faces.values().map(|places| size_of_val(&**places)).sum()
    }
}
