//! Watching the edits of a subdivision: the pointers, as everywhere, and what the plane has besides.
//!
//! ```text
//!   pointers        new v5 | h8.origin: none -> v5 | ...
//!   of the plane    v5 stands at (1, 2) | the inner components of f3 are taken | f3 is given inner components | f4 is a hole
//! ```

use super::{Point, Subdivision};
use crate::ids::{FaceId, VertexId};
use crate::topology::{Followed, Follows, InnerComponent, Journal, Log, NoRecorder, Recorder};

/// What a subdivision holds besides its structure, changed.
#[derive(Clone, PartialEq, Debug)]
#[non_exhaustive]
pub enum PlaneChange {
    /// A vertex got its position.
    Placed {
        /// The vertex.
        vertex: VertexId,
        /// What its slot held, if there was one.
        old: Option<Point>,
        /// Where it is.
        new: Point,
    },
    /// The list of inner components of a face was replaced by another.
    InnerComponents {
        /// The face.
        face: FaceId,
        /// The list before.
        old: Vec<InnerComponent>,
    },
    /// A face became a hole of the domain, or is none any more.
    Hole {
        /// The face.
        face: FaceId,
        /// Whether it is one now.
        is_hole: bool,
    },
}

/// Gets every change of an edit of a subdivision while it is being made. Monomorphised, as [`Recorder`] is.
pub trait PlaneRecorder: Recorder {
    /// One change, already made. Those who do not ask get the pointers alone, and the change is never put together.
    #[inline(always)]
    fn plane(&mut self, change: impl FnOnce() -> PlaneChange) {
        let _ = change;
    }
}

impl PlaneRecorder for NoRecorder {}

/// The pointers alone, for film strips.
impl PlaneRecorder for Journal {}

impl<R: PlaneRecorder> PlaneRecorder for &mut R {
    fn plane(&mut self, change: impl FnOnce() -> PlaneChange) {
        (**self).plane(change);
    }
}

impl<A: PlaneRecorder, B: PlaneRecorder> PlaneRecorder for (A, B) {
    fn plane(&mut self, change: impl FnOnce() -> PlaneChange) {
        let change = change();
        self.0.plane(|| change.clone());
        self.1.plane(|| change);
    }
}

/// Follows the elements; positions are not its business.
impl<I: Follows, T: Clone> PlaneRecorder for Followed<I, T> {}

/// Keeps all changes; [`Subdivision::undo`] takes them back.
///
/// ```
/// use dcel_kit::{HalfEdgeId, plane::{PlaneJournal, Subdivision}};
/// let mut lab = Subdivision::lab_rectangle();
/// let (before, mut journal) = (lab.clone(), PlaneJournal::new());
/// lab.split_in_half_with(HalfEdgeId::new(0), &mut journal)?;
/// lab.undo(&mut journal, 0);
/// assert_eq!(lab, before);
/// # Ok::<(), dcel_kit::plane::SplitEdgeError>(())
/// ```
pub type PlaneJournal = Log<PlaneChange>;

impl PlaneRecorder for PlaneJournal {
    fn plane(&mut self, change: impl FnOnce() -> PlaneChange) {
        self.push(change());
    }
}

impl Subdivision {
    /// Takes back the changes of `journal` from its end until `mark` are left. Afterwards the subdivision is bit for bit
    /// what it was, free slots included, provided that all edits since then were recorded in it.
    ///
    /// Cost: O(changes taken back), and the logarithm of the number of faces with inner components for each such list.
    pub fn undo(&mut self, journal: &mut PlaneJournal, mark: usize) {
        let Self { dcel, points, inner_components, holes } = self;
        journal.take_back(dcel, mark, |change| match change {
            PlaneChange::Placed { vertex, old: Some(old), .. } => points[vertex] = old,
            PlaneChange::Placed { vertex, old: None, .. } => points.truncate(vertex.index()),
            PlaneChange::InnerComponents { face, old } if old.is_empty() => drop(inner_components.remove(&face)),
            PlaneChange::InnerComponents { face, old } => drop(inner_components.insert(face, old)),
            PlaneChange::Hole { face, is_hole: true } => drop(holes.remove(&face)),
            PlaneChange::Hole { face, is_hole: false } => drop(holes.insert(face)),
        });
    }

    /// Puts a vertex to a place; a new one gets its slot.
    #[inline]
    pub(super) fn place(&mut self, vertex: VertexId, new: Point, rec: &mut impl PlaneRecorder) {
        let old = self.points.get(vertex).copied();
        self.points.set(vertex, new, Point::default());
        rec.plane(|| PlaneChange::Placed { vertex, old, new });
    }

    /// Makes a bounded face a hole of the domain, or no hole. Returns whether it was one.
    pub(super) fn mark_hole(&mut self, face: FaceId, is_hole: bool, rec: &mut impl PlaneRecorder) -> bool {
        let changed = if is_hole { self.holes.insert(face) } else { self.holes.remove(&face) };
        if changed {
            rec.plane(|| PlaneChange::Hole { face, is_hole });
        }
        changed != is_hole
    }
}
