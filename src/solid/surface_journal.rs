//! Watching the edits of a surface: the pointers, as everywhere, and what a surface has besides.
//!
//! ```text
//!   changes of the kernel     new f7 | f7.half_edge: none -> h3 | new v5 | ...
//!   of the surface                   └ f7 is a boundary face            └ v5 stands at (1, 0, 2), its slot at (0, 0, 0)
//! ```
//!
//! A change of the surface is told after the change of the kernel it belongs to.

use super::Polyhedron;
use crate::ids::{FaceId, VertexId};
use crate::topology::{Followed, Follows, Journal, Log, NoRecorder, Recorder};

/// What a surface holds besides its structure, changed.
#[derive(Clone, Copy, PartialEq, Debug)]
#[non_exhaustive]
pub enum SurfaceChange {
    /// A face became a boundary face, or is none any more.
    Border {
        /// The face.
        face: FaceId,
        /// Whether it is one now.
        is_border: bool,
    },
    /// A vertex got its position.
    Placed {
        /// The vertex.
        vertex: VertexId,
        /// What its slot held, if there was one.
        old: Option<[f64; 3]>,
        /// Where it is.
        new: [f64; 3],
    },
}

/// Gets every change of an edit of a surface while it is being made. Monomorphised, as [`Recorder`] is.
pub trait SurfaceRecorder: Recorder {
    /// One change, already made. Those who do not ask get the pointers alone.
    #[inline(always)]
    fn surface(&mut self, change: SurfaceChange) {
        let _ = change;
    }
}

impl SurfaceRecorder for NoRecorder {}

/// The pointers alone, for film strips.
impl SurfaceRecorder for Journal {}

impl<R: SurfaceRecorder> SurfaceRecorder for &mut R {
    fn surface(&mut self, change: SurfaceChange) {
        (**self).surface(change);
    }
}

impl<A: SurfaceRecorder, B: SurfaceRecorder> SurfaceRecorder for (A, B) {
    fn surface(&mut self, change: SurfaceChange) {
        self.0.surface(change);
        self.1.surface(change);
    }
}

/// Follows the elements; positions are not its business.
impl<I: Follows, T: Clone> SurfaceRecorder for Followed<I, T> {}

/// Keeps all changes; [`Polyhedron::undo`] takes them back.
///
/// ```
/// use dcel_kit::{FaceId, solid::{Platonic, Polyhedron, SurfaceJournal}};
/// let mut cube = Polyhedron::platonic(Platonic::Cube);
/// let (before, mut journal) = (cube.clone(), SurfaceJournal::new());
/// cube.remove_face_with(FaceId::new(2), &mut journal)?;
/// assert_eq!(cube.boundary_faces().len(), 1);
/// cube.undo(&mut journal, 0);
/// assert_eq!(cube, before);
/// # Ok::<(), dcel_kit::solid::RemoveFaceError>(())
/// ```
pub type SurfaceJournal = Log<SurfaceChange>;

impl SurfaceRecorder for SurfaceJournal {
    fn surface(&mut self, change: SurfaceChange) {
        self.push(change);
    }
}

impl Polyhedron {
    /// Takes back the changes of `journal` from its end until `mark` are left. Afterwards the surface is bit for bit
    /// what it was, free slots included, provided that all edits since then were recorded in it.
    ///
    /// Cost: O(changes taken back), and the logarithm of the number of boundary faces for each that came or went.
    pub fn undo(&mut self, journal: &mut SurfaceJournal, mark: usize) {
        let Self { dcel, points, boundary_faces } = self;
        journal.take_back(dcel, mark, |change| match change {
            SurfaceChange::Border { face, is_border: true } => drop(boundary_faces.remove(&face)),
            SurfaceChange::Border { face, is_border: false } => drop(boundary_faces.insert(face)),
            SurfaceChange::Placed { vertex, old: Some(old), .. } => points[vertex] = old,
            SurfaceChange::Placed { vertex, old: None, .. } => points.truncate(vertex.index()),
        });
    }
}
