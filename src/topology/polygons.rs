//! Faces as lists of corners: what readers produce and builders take.

#[cfg(feature = "io")]
use std::collections::TryReserveError;

/// Faces given by the numbers of their corners, all in one flat array.
///
/// A face is one outer cycle and any number of inner cycles (holes in the polygon). Faces and vertices are
/// numbered from 0 in the order in which they are given; messages of the builders use these numbers.
///
/// ```
/// # use dcel_kit::topology::PolygonList;
/// let mut faces = PolygonList::new();
/// faces.push_face(&[0, 1, 2, 3]);
/// faces.push_hole(&[4, 5, 6]);
/// faces.push_face(&[0, 3, 7]);
/// assert_eq!((faces.face_count(), faces.cycle_count()), (2, 3));
/// assert_eq!(faces.cycles(0).collect::<Vec<_>>(), [&[0, 1, 2, 3][..], &[4, 5, 6]]);
/// ```
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct PolygonList {
    corners: Vec<u32>,
    /// `cycle_starts[c] .. cycle_starts[c + 1]` are the corners of cycle `c`.
    cycle_starts: Vec<u32>,
    /// `face_starts[f] .. face_starts[f + 1]` are the cycles of face `f`; empty while every face has exactly one.
    face_starts: Vec<u32>,
}

impl Default for PolygonList {
    fn default() -> Self {
        Self::new()
    }
}

impl PolygonList {
    /// No face.
    #[must_use]
    pub fn new() -> Self {
        Self { corners: Vec::new(), cycle_starts: vec![0], face_starts: Vec::new() }
    }

    /// One face for each triangle.
    #[must_use]
    pub fn from_triangles(triangles: &[[u32; 3]]) -> Self {
        let n = triangles.len() as u32;
        Self {
            corners: triangles.as_flattened().to_vec(),
            cycle_starts: (0..=n).map(|i| 3 * i).collect(),
            face_starts: Vec::new(),
        }
    }

    /// Makes room for so many corners and faces more, if there is memory for them.
    #[cfg(feature = "io")]
    pub(crate) fn try_reserve(&mut self, corners: usize, faces: usize) -> Result<(), TryReserveError> {
        self.corners.try_reserve(corners)?;
        self.cycle_starts.try_reserve(faces)?;
        if self.has_no_holes() { Ok(()) } else { self.face_starts.try_reserve(faces) }
    }

    /// Appends a face with this outer cycle.
    pub fn push_face(&mut self, corners: &[u32]) {
        self.push_cycle(corners);
        if !self.has_no_holes() {
            self.face_starts.push(self.cycle_count() as u32);
        }
    }

    /// Gives the last face one more inner cycle. Without a face before, this appends a face.
    pub fn push_hole(&mut self, corners: &[u32]) {
        if self.cycle_count() == 0 {
            return self.push_face(corners);
        }
        if self.has_no_holes() {
            self.face_starts = (0..=self.cycle_count() as u32).collect();
        }
        self.push_cycle(corners);
        let end = self.cycle_count() as u32;
        self.face_starts.last_mut().into_iter().for_each(|last| *last = end);
    }

    fn push_cycle(&mut self, corners: &[u32]) {
        self.corners.extend_from_slice(corners);
        self.cycle_starts.push(self.corners.len() as u32);
    }

    /// The number of faces.
    #[must_use]
    pub fn face_count(&self) -> usize {
        if self.has_no_holes() { self.cycle_count() } else { self.face_starts.len() - 1 }
    }

    /// The number of cycles of all faces together.
    #[must_use]
    pub fn cycle_count(&self) -> usize {
        self.cycle_starts.len() - 1
    }

    /// The number of corners of all faces together: the number of half-edges that bound them.
    #[must_use]
    pub fn corner_count(&self) -> usize {
        self.corners.len()
    }

    /// The numbers of the cycles of face `face`, the outer one first.
    #[must_use]
    pub fn cycle_range(&self, face: usize) -> std::ops::Range<usize> {
        if self.has_no_holes() {
            return face..face + 1;
        }
        self.face_starts[face] as usize..self.face_starts[face + 1] as usize
    }

    /// The corners of cycle `cycle`.
    #[must_use]
    pub fn cycle(&self, cycle: usize) -> &[u32] {
        &self.corners[self.cycle_starts[cycle] as usize..self.cycle_starts[cycle + 1] as usize]
    }

    /// The corners of cycle `cycle`, to be reordered in place.
    pub fn cycle_mut(&mut self, cycle: usize) -> &mut [u32] {
        &mut self.corners[self.cycle_starts[cycle] as usize..self.cycle_starts[cycle + 1] as usize]
    }

    /// The cycles of face `face`, the outer one first.
    pub fn cycles(&self, face: usize) -> impl ExactSizeIterator<Item = &[u32]> {
        self.cycle_range(face).map(|c| self.cycle(c))
    }

    /// The outer cycle of each face.
    pub fn outer_cycles(&self) -> impl ExactSizeIterator<Item = &[u32]> {
        (0..self.face_count()).map(|f| self.cycle(self.cycle_range(f).start))
    }

    /// All corners of all cycles in order.
    #[must_use]
    pub fn corners(&self) -> &[u32] {
        &self.corners
    }

    /// The starts of the cycles in [`corners`](Self::corners), and its length at the end.
    #[must_use]
    pub fn cycle_starts(&self) -> &[u32] {
        &self.cycle_starts
    }

    /// The faces as triangles, if they all are: there is less to look at then.
    #[cfg(feature = "io")]
    pub(crate) fn as_triangles(&self) -> Option<&[[u32; 3]]> {
        let all = self.has_no_holes() && self.cycle_starts.windows(2).all(|ends| ends[1] - ends[0] == 3);
        all.then(|| self.corners.as_chunks().0)
    }

    /// Whether every face has exactly one cycle.
    #[must_use]
    pub fn has_no_holes(&self) -> bool {
        self.face_starts.is_empty()
    }
}
