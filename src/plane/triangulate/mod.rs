//! Triangulation: faces are cut into triangles by diagonals between their own vertices.
//!
//! ```text
//!   faces ──> patch.rs ──> ears.rs                       ──> write.rs ──> subdivision
//!             a copy of    bridges.rs  inner components are joined      all diagonals
//!             their links                                    at once, or
//!                     ──> monotone.rs  pieces from left  ──>  none
//!                                      to right
//!                         chains.rs    each in one pass
//!                     ──> delaunay.rs  the constrained Delaunay triangulation
//! ```
//!
//! Every bounded face can be triangulated: with dangling edges, with vertices that it passes more than once, with inner components
//! and isolated vertices. With n half-edges and r inner components (isolated vertices are inner components, too) it falls into
//! n + 2r - 2 triangles, **each of positive area**: a vertex in the middle of a straight side is a corner of some
//! triangle, never a point on a side of one.
//!
//! Why that is always possible: add edges to a plane graph for as long as two vertices see each other along one. When
//! none is left, no bounded face has a corner that is not convex, nor one that is straight.
//!
//! Source: de Berg et al., *Computational Geometry*, 3rd ed., chapter 3.
//!
//! ```text
//!   candidates.rs  A set of numbers below n that tells the next one after a given one, round and round
//!   error.rs       Why faces cannot be triangulated
//!   reflex.rs      The corners of a face that are not convex, so that "does one of them lie in this triangle?" is
//!                  asked of few
//! ```

mod bridges;
mod candidates;
mod chains;
mod delaunay;
mod ears;
mod error;
mod monotone;
mod patch;
mod reflex;
mod write;

pub use error::TriangulateError;

use super::{PlaneRecorder, Subdivision};
use crate::ids::{EdgeId, FaceId, VertexId};
use crate::topology::{NoObserver, NoRecorder, Observer};
use patch::Patch;

/// How faces are triangulated. The number of triangles is the same, their shapes are not.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum TriangulationMethod {
    /// Ear clipping. A corner is an *ear* if it turns left and no vertex lies in its triangle: cut it off, go on.
    ///
    /// ```text
    ///        b              Inner components are joined to the rest first, each by a bridge from its leftmost vertex to the last
    ///       ╱ ╲  ear        vertex before it that it sees.
    ///      a - c
    /// ```
    ///
    /// Cost: O(n (√k + log n)) for a face of n corners, k of them not convex, if few of them share a vertex; its r
    /// inner components cost O(n r) besides. So O(n²) at worst.
    ///
    /// Source: Meisters, *Polygons have ears*, American Mathematical Monthly 82, 1975.
    Ears,
    /// Monotone pieces: a sweep from left to right cuts the faces into pieces whose intersection with every vertical line is
    /// connected, and each of these is triangulated in one pass.
    ///
    /// Cost: O(n log n), whatever the shape.
    ///
    /// Source: de Berg et al., *Computational Geometry*, 3rd ed., sections 3.2 and 3.3.
    #[default]
    Monotone,
    /// Constrained Delaunay triangles: every diagonal is locally Delaunay, so that no triangle is a needless sliver.
    ///
    /// Cost: that of [`Subdivision::constrained_delaunay`] for the whole subdivision, O(n log n) for n vertices besides
    /// edges that are not Delaunay themselves, however few of its faces are cut.
    Delaunay,
}

/// What ear clipping does with a corner that it asks. Corners are told by their vertices: the one before, the corner, the
/// one after.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum EarEvent {
    /// It is no ear: it does not turn left, or a vertex lies in its triangle.
    Refused {
        /// The corner.
        corners: [VertexId; 3],
        /// Whether it turns left, so that a vertex lies in its triangle.
        is_convex: bool,
    },
    /// It is an ear, and is cut off.
    Cut([VertexId; 3]),
}

/// What a corner is for the sweep that cuts faces into monotone pieces: where its two sides run, and where the face is.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Corner {
    /// Both sides run to the right, with the face between them.
    Start,
    /// Both sides run to the left, with the face between them.
    End,
    /// Both sides run to the right, with the face on all other sides of them: it has to be joined to the left.
    Split,
    /// Both sides run to the left, with the face on all other sides of them: it has to be joined to the right.
    Merge,
    /// The face lies above, between a side from the left and a side to the right.
    Lower,
    /// The face lies below.
    Upper,
    /// No side: a vertex by itself, which is joined to the left and to the right.
    Isolated,
}

/// What the triangulation by [monotone pieces](TriangulationMethod::Monotone) does: first the sweep over all faces, then
/// the pieces one by one.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum MonotoneEvent {
    /// The sweep line comes to a corner.
    Corner {
        /// Its vertex.
        at: VertexId,
        /// What it is.
        corner: Corner,
    },
    /// The sweep joins the vertex where it is to the helper of a gap.
    Diagonal {
        /// Where the sweep is.
        from: VertexId,
        /// The helper, which lies further left.
        to: VertexId,
    },
    /// A corner of a piece is cut off: its vertex stands in the middle. The last triangle of a piece is left over, not
    /// cut off.
    Cut([VertexId; 3]),
}

/// What a triangulation added.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Triangulated {
    /// The diagonals, in the order in which they were found.
    pub diagonals: Vec<EdgeId>,
    /// The new faces, each with the face that it was a part of, in increasing order.
    pub new_faces: Vec<(FaceId, FaceId)>,
}

/// Into what faces are cut.
#[derive(Clone, Copy)]
enum Goal {
    Triangles(TriangulationMethod),
    MonotonePieces,
}

impl Subdivision {
    /// Cuts every bounded face that is no hole face into triangles. Vertices stay as they are; none is added.
    ///
    #[doc = include_str!("../../../figures/triangulation.svg")]
    ///
    /// Each of the triangles has positive area. The triangle at `half_edge(f)` keeps the number of the face `f`, and
    /// `half_edge(f)` stays. A face with n half-edges and r inner components falls into n + 2r - 2 triangles; what was a
    /// inner component is part of the boundary of triangles afterwards. Hole faces stay whole.
    ///
    /// Cost: that of the [method](TriangulationMethod); all decisions are exact.
    ///
    /// # Errors
    /// [`TriangulateError`]; then everything is bit for bit as it was.
    ///
    /// ```
    /// use dcel_kit::plane::{Subdivision, TriangulationMethod};
    /// let mut lab = Subdivision::lab_rectangle();
    /// let added = lab.triangulate(TriangulationMethod::Monotone)?;
    /// assert_eq!((added.diagonals.len(), lab.face_count()), (3, 5));
    /// assert!(lab.faces().skip(1).all(|f| lab.incident_half_edges(f).count() == 3));
    /// # Ok::<(), dcel_kit::plane::TriangulateError>(())
    /// ```
    pub fn triangulate(&mut self, method: TriangulationMethod) -> Result<Triangulated, TriangulateError> {
        let faces: Vec<FaceId> = self.bounded_faces().filter(|&f| !self.is_hole(f)).collect();
        self.cut(&faces, Goal::Triangles(method), &mut NoRecorder, (&mut NoObserver, &mut NoObserver))
    }

    /// [`triangulate`](Self::triangulate) by [ear clipping](TriangulationMethod::Ears), watched: each corner that it asks.
    ///
    /// # Errors
    /// As [`triangulate`](Self::triangulate).
    ///
    /// ```
    /// use dcel_kit::plane::{EarEvent, Subdivision};
    /// let mut events = Vec::new();
    /// let added = Subdivision::lab_rectangle().triangulate_ears_observed(&mut events)?;
    /// let cut = events.iter().filter(|event| matches!(event, EarEvent::Cut(_))).count();
    /// assert_eq!(cut, added.diagonals.len());
    /// # Ok::<(), dcel_kit::plane::TriangulateError>(())
    /// ```
    pub fn triangulate_ears_observed(
        &mut self,
        observer: &mut impl Observer<EarEvent>,
    ) -> Result<Triangulated, TriangulateError> {
        let faces: Vec<FaceId> = self.bounded_faces().filter(|&f| !self.is_hole(f)).collect();
        self.cut(&faces, Goal::Triangles(TriangulationMethod::Ears), &mut NoRecorder, (observer, &mut NoObserver))
    }

    /// [`triangulate`](Self::triangulate) by [monotone pieces](TriangulationMethod::Monotone), watched: the corners as the
    /// sweep meets them, the diagonals that make the pieces monotone, and the triangles that are cut off these.
    ///
    /// # Errors
    /// As [`triangulate`](Self::triangulate).
    ///
    /// ```
    /// use dcel_kit::plane::{MonotoneEvent, Subdivision};
    /// let mut events = Vec::new();
    /// let added = Subdivision::lab_rectangle().triangulate_monotone_observed(&mut events)?;
    /// let is_diagonal = |event: &&MonotoneEvent| !matches!(event, MonotoneEvent::Corner { .. });
    /// assert_eq!(events.iter().filter(is_diagonal).count(), added.diagonals.len());
    /// # Ok::<(), dcel_kit::plane::TriangulateError>(())
    /// ```
    pub fn triangulate_monotone_observed(
        &mut self,
        observer: &mut impl Observer<MonotoneEvent>,
    ) -> Result<Triangulated, TriangulateError> {
        let faces: Vec<FaceId> = self.bounded_faces().filter(|&f| !self.is_hole(f)).collect();
        self.cut(&faces, Goal::Triangles(TriangulationMethod::Monotone), &mut NoRecorder, (&mut NoObserver, observer))
    }

    /// [`triangulate`](Self::triangulate) for all bounded faces: hole faces, too, are cut, and all their triangles
    /// are hole faces. Every bounded face is a triangle then.
    ///
    /// # Errors
    /// [`TriangulateError`]; then everything is bit for bit as it was.
    pub fn triangulate_all(&mut self, method: TriangulationMethod) -> Result<Triangulated, TriangulateError> {
        let faces: Vec<FaceId> = self.bounded_faces().collect();
        self.cut(&faces, Goal::Triangles(method), &mut NoRecorder, (&mut NoObserver, &mut NoObserver))
    }

    /// Cuts one bounded face into triangles, as [`triangulate`](Self::triangulate) does. If it is a hole face, so are
    /// they.
    ///
    /// # Errors
    /// [`TriangulateError`]; then everything is bit for bit as it was.
    ///
    /// ```
    /// use dcel_kit::{FaceId, plane::{Subdivision, TriangulationMethod}};
    /// // A square with a vertex in the middle: 4 + 2 - 2 triangles.
    /// let points = [(0., 0.), (4., 0.), (4., 4.), (0., 4.), (1., 2.)].map(Into::into);
    /// let mut s = Subdivision::from_graph(&points, &[[0, 1], [1, 2], [2, 3], [3, 0]])?;
    /// let added = s.triangulate_face(FaceId::new(1), TriangulationMethod::Ears)?;
    /// assert_eq!((added.diagonals.len(), added.new_faces.len()), (4, 3));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn triangulate_face(
        &mut self,
        f: FaceId,
        method: TriangulationMethod,
    ) -> Result<Triangulated, TriangulateError> {
        self.triangulate_face_with(f, method, &mut NoRecorder)
    }

    /// [`triangulate_face`](Self::triangulate_face), watched by a recorder.
    ///
    /// # Errors
    /// [`TriangulateError`]; then everything is bit for bit as it was.
    pub fn triangulate_face_with(
        &mut self,
        f: FaceId,
        method: TriangulationMethod,
        rec: &mut impl PlaneRecorder,
    ) -> Result<Triangulated, TriangulateError> {
        self.check_bounded(f)?;
        self.cut(&[f], Goal::Triangles(method), rec, (&mut NoObserver, &mut NoObserver))
    }

    /// Cuts one bounded face into monotone pieces: faces without inner components whose boundary runs from its leftmost vertex
    /// to the right and back just once. Points above each other count from bottom to top.
    ///
    /// ```text
    ///      ╱╲   ╱╲             Each corner that opens to the left only (split) is joined to the last vertex before it
    ///     ╱  ╲ ╱  ╲            in its gap, each that opens to the right only (merge) to the next one after it.
    ///    ╱    v----╲           All others need nothing.
    ///    ╲_________╱
    /// ```
    ///
    /// Numbers are kept as by [`triangulate`](Self::triangulate).
    ///
    /// Cost: O(n log n).
    ///
    /// Source: de Berg et al., *Computational Geometry*, 3rd ed., section 3.2.
    ///
    /// # Errors
    /// [`TriangulateError`]; then everything is bit for bit as it was.
    pub fn split_into_monotone(&mut self, f: FaceId) -> Result<Triangulated, TriangulateError> {
        self.check_bounded(f)?;
        self.cut(&[f], Goal::MonotonePieces, &mut NoRecorder, (&mut NoObserver, &mut NoObserver))
    }

    fn bounded_faces(&self) -> impl Iterator<Item = FaceId> + '_ {
        self.dcel.faces().filter(|&f| f != self.outer_face())
    }

    fn check_bounded(&self, f: FaceId) -> Result<(), TriangulateError> {
        self.dcel.check(f)?;
        if f == self.outer_face() { Err(TriangulateError::OuterFace) } else { Ok(()) }
    }

    /// Cuts different bounded faces; the observer of the method is told.
    fn cut(
        &mut self,
        faces: &[FaceId],
        goal: Goal,
        rec: &mut impl PlaneRecorder,
        (ears, monotone): (&mut impl Observer<EarEvent>, &mut impl Observer<MonotoneEvent>),
    ) -> Result<Triangulated, TriangulateError> {
        let mut patch = Patch::new(self, faces)?;
        match goal {
            Goal::Triangles(TriangulationMethod::Ears) => {
                bridges::join_inner_components(&mut patch)?;
                ears::clip(&mut patch, ears)?;
            }
            Goal::Triangles(TriangulationMethod::Monotone) => {
                monotone::split(&mut patch, monotone)?;
                chains::triangulate(&mut patch, monotone);
            }
            Goal::Triangles(TriangulationMethod::Delaunay) => delaunay::triangulate(&mut patch, self)?,
            Goal::MonotonePieces => monotone::split(&mut patch, monotone)?,
        }
        let pieces = match goal {
            Goal::Triangles(_) => patch.triangles()?,
            Goal::MonotonePieces => patch.pieces()?,
        };
        let new_faces = pieces.len().saturating_sub(patch.parts.len());
        let links = patch.into_links();
        self.dcel.room_for(0, links.diagonals(), new_faces)?;
        Ok(self.write_pieces(faces, links, &pieces, rec))
    }
}
