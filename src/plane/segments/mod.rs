//! From segments to a subdivision: any straight-line graph.
//!
//! ```text
//!   segments ──> equal ends become one vertex ──> one sweep: does anything meet? ──┬─ no ──> one-rings, cycles, inner components
//!                (graph.rs)                       what lies below each vertex?      │         (trace.rs)
//!                                                                                   └─ yes ─> name it (faults.rs)
//!                                                                                             or split (split.rs)
//! ```
//!
//! What is to be split is first looked for without a sweep: `crossed.rs`, and after the cuts `settled.rs`. Where all is far
//! apart beside the rounding, nothing has to be compared again (`gap.rs` of `meet`). Where faces have few sides on the average,
//! no sweep is needed either to see that nothing meets: `settled.rs` makes the subdivision, and `proof.rs` of the plane looks
//! at it.
//!
//! Before it is split, what overlaps is cut (`collinear.rs`); what does not settle in doubles goes to a grid (`snap.rs`).
//!
//! Dangling edges, single edges, isolated points, nested inner components and several components are all legal.
//!
//! ```text
//!   angles.rs    One-rings by the angles of their half-edges
//!   arrange.rs   The way from given segments to a subdivision, step by step
//!   chains.rs    What became of the edges of a graph that was split
//!   crossed.rs   The first cuts of all edges, from the pairs that meet
//!   cycles.rs    The cycles of linked half-edges, and which of them bound a face
//!   dangles.rs   Edges that bound nothing
//!   disk.rs      Edges that fill a disk
//!   error.rs     Why segments are no plane graph
//!   holes.rs     Marking hole faces
//!   one_rings.rs Half-edges linked one-ring by one-ring
//!   part.rs      The subdivision of some of the edges of another
//!   pixels.rs    The hot pixels that a segment passes
//!   settled.rs   A look at a graph without a sweep
//!   touching.rs  Points that lie inside the sides of polygons
//!   watched.rs   The sweep by itself, for who watches it
//! ```

mod angles;
mod arrange;
mod chains;
mod collinear;
mod crossed;
mod cycles;
mod dangles;
mod disk;
mod error;
mod faults;
mod graph;
mod holes;
mod one_rings;
mod part;
mod pixels;
mod settled;
mod snap;
mod split;
mod touching;
mod trace;
mod watched;

pub use dangles::DanglesAndCutEdges;
pub use error::{SegmentFault, SegmentsError};
pub use holes::MarkHolesError;
pub use touching::InsertedCorner;
pub(super) use touching::{insert_touching, sides_of};
pub use watched::sweep_segments_observed;

use super::{Point, Subdivision};
use crate::geometry::grouping::Groups;
use crate::ids::{EdgeId, HalfEdgeId, VertexId, must_be_below};
use arrange::{Chains, Input, arrange};

/// What to do with segments that are no plane graph.
///
/// # Why splitting always ends
/// Crossings that are rounded one by one can make edges cross that did not. They are looked at again, at most four times.
/// What has not settled then goes to a grid, by snap rounding, and that needs one pass:
///
/// ```text
///   ┆ ●╲┆   ┆ ╱●┆          ┆ ●╲┆   ┆ ╱●┆         Hot are the pixels with an end or a crossing of segments in them.
///   ┄┄┄╲┄┄┄┄╱┄┄┄    ──>    ┄┄┄┄╲┄┄╱┄┄┄┄          Every segment becomes the chain of the middles of the hot pixels
///   ┆   ┆╲╱ ┆   ┆          ┆   ┆ ●┆   ┆          that it passes, in its order.
///   ┄┄┄┄┄╱╲┄┄┄┄┄           ┄┄┄┄╱┄┄╲┄┄┄┄
/// ```
///
/// A segment passes each pixel of its chain at some point: the middle plus an offset, and offsets lie in one and the same
/// convex set, a pixel round 0. Let all offsets shrink to nothing at the same speed.
///
/// 1. *No chain runs over a middle that is not its own.* Say that the piece of a chain from the middle c to the next
///    one, d, has the middle m on it or comes over it while it shrinks: (1 - s)(c + t e) + s (d + t f) = m + t g with
///    offsets e, f, g and 0 <= t < 1. Then the segment itself had the point (1 - s)(c + e) + s (d + f) =
///    m + t g + (1 - t)((1 - s) e + s f), which is m plus an offset, since these are convex: it passes the pixel of m,
///    so m stands in the chain.
/// 2. *No two chains cross.* Outside of the hot pixels no two segments cross, since crossings make pixels hot. While
///    the pieces between them shrink, two can begin to cross only where an end of one comes over the other; that is
///    point 1. So in the end they share middles, or run along each other from middle to middle.
///
/// No chain is further from its segment than half the diagonal of a pixel.
///
/// Source: Hobby, *Practical segment intersection with finite precision output*, Computational Geometry 13, 1999; Guibas
/// and Marimont, *Rounding arrangements dynamically*, 1998.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ArrangeOptions {
    /// Leave out segments without length and segments that repeat an earlier one, and join points at the same place,
    /// instead of refusing them.
    pub merge: bool,
    /// Split segments where they cross, touch or overlap, instead of refusing them. Then repeated segments are
    /// merged, too.
    ///
    /// What meets is decided exactly. Points of the input stay where they are; a crossing becomes a vertex at the
    /// nearest doubles, and the edges through it bend by as little. The bent edges are looked at in the same way
    /// again, so that no crossing is made by rounding and left unsplit. Nearly always that ends in two rounds.
    ///
    /// Where it does not end in four (bundles of lines a few last places apart), the connected parts concerned are
    /// rounded to a grid of about 2^-52 of their greatest coordinate: every point goes to the grid point next to it,
    /// and every segment through the middles of the grid squares in which an end or a crossing lies and that it passes
    /// (snap rounding). That always ends, after one pass, with no crossing left. Points that lie on the grid stay, and so
    /// do the parts of the input that have settled; only where what was rounded meets them time and again is all of it
    /// rounded. [`Arranged`] says what moved, and how far.
    pub split: bool,
    /// When splitting, round everything to the multiples of this number, or rather of the largest power of two that is
    /// not above it; `None`: only what needs it, and as finely as possible.
    pub grid: Option<f64>,
    /// How many faults are named before the search ends.
    pub most_faults: usize,
}

impl Default for ArrangeOptions {
    fn default() -> Self {
        Self { merge: false, split: false, grid: None, most_faults: 100 }
    }
}

/// A subdivision made of segments, and what became of each of them.
#[derive(Clone, PartialEq, Debug)]
pub struct Arranged {
    /// The subdivision.
    pub subdivision: Subdivision,
    /// The vertex of each given point; empty if segments were given without points.
    pub vertices: Vec<VertexId>,
    /// The segments without length that were left out, by input number.
    pub zero_length: Vec<u32>,
    /// The segments that repeat an earlier one, each with that one.
    pub repeated: Vec<(u32, u32)>,
    /// The vertices made where segments cross and no point was, in increasing order.
    pub crossings: Vec<VertexId>,
    /// The crossings that could not be kept in place, each with a distance: none of the segments that cross there is
    /// further away. Where edges that were bent cross anew, the bends count.
    pub moved: Vec<(VertexId, f64)>,
    /// The vertices of the input that a grid moved, each with the greatest distance of a point of the input that it
    /// stands for. Empty unless there is a [`grid`](Self::grid).
    pub displaced: Vec<(VertexId, f64)>,
    /// How many points of the input a grid moved. Points at the same place count once; those that fell together on the
    /// grid do not.
    pub displaced_points: usize,
    /// The segments that have length, but on the grid none: both ends came to the same grid point.
    pub collapsed: Vec<u32>,
    /// The distance of neighbours of the grid, if points were rounded to one: a power of two.
    pub grid: Option<f64>,
    /// No point of a segment is further from its chain, and no point of a chain from its segment. 0 if nothing moved.
    pub farthest: f64,
    /// How often everything was split; more than 1 if rounded crossings made edges meet anew.
    pub rounds: u32,
    chains: Chains,
}

impl Arranged {
    /// The half-edges that segment `segment` has become, from its first end to its second; none if it has no length.
    /// A repeated segment, or one that overlaps another, shares edges with it, and memory. O(1).
    ///
    /// # Panics
    /// If there is no such segment.
    #[must_use]
    pub fn chain(&self, segment: usize) -> &[HalfEdgeId] {
        self.chains.of(segment)
    }

    /// The segments that have become several edges, by input number.
    pub fn split_segments(&self) -> impl Iterator<Item = u32> + '_ {
        (0..self.chains.count()).filter(|&i| self.chains.of(i).len() > 1).map(|i| i as u32)
    }

    /// The first two segments that share an edge without being the same, with the edge: `(e0, [0, 2])`. Segments that lie on
    /// each other in the input share edges, and so do those that a grid has brought together. O(edges).
    ///
    /// ```
    /// use dcel_kit::plane::{ArrangeOptions, Point, Subdivision};
    /// let near = [[Point::new(0., 0.), Point::new(4., 0.)], [Point::new(0., 0.25), Point::new(2., 0.)]];
    /// let on_grid = ArrangeOptions { split: true, grid: Some(1.0), ..ArrangeOptions::default() };
    /// let (edge, segments) = Subdivision::arrange_segments(&near, &on_grid)?.first_shared_edge().unwrap();
    /// assert_eq!((edge.to_string(), segments), ("e0".to_owned(), [0, 1]));
    /// # Ok::<(), dcel_kit::plane::SegmentsError>(())
    /// ```
    #[must_use]
    pub fn first_shared_edge(&self) -> Option<(EdgeId, [u32; 2])> {
        let mut first = vec![u32::MAX; self.subdivision.edge_bound()];
        let mut repeated = self.repeated.iter().map(|&(segment, _)| segment).peekable();
        for segment in 0..self.chains.count() as u32 {
            if repeated.next_if_eq(&segment).is_some() {
                continue;
            }
            for h in self.chains.of(segment as usize) {
                let seen = &mut first[h.edge().index()];
                if *seen != u32::MAX {
                    return Some((h.edge(), [*seen, segment]));
                }
                *seen = segment;
            }
        }
        None
    }

    /// The segments that run along each edge.
    ///
    /// The answer is as long as all chains together: for segments that all overlap each other the square of their
    /// number, which is why it is made only when it is asked for. O(edges + length of the answer).
    ///
    /// ```
    /// use dcel_kit::plane::{ArrangeOptions, Point, Subdivision};
    /// use dcel_kit::EdgeId;
    /// let segment = |x0, x1| [Point::new(x0, 0.), Point::new(x1, 0.)];
    /// let options = ArrangeOptions { split: true, ..ArrangeOptions::default() };
    /// let line = Subdivision::arrange_segments(&[segment(0., 2.), segment(3., 1.)], &options)?;
    /// let along = line.segments_along();
    /// assert_eq!([0, 1, 2].map(|e| along.of(EdgeId::new(e))), [&[0][..], &[0, 1], &[1]]);
    /// # Ok::<(), dcel_kit::plane::SegmentsError>(())
    /// ```
    #[must_use]
    pub fn segments_along(&self) -> SegmentsAlong {
        let along = |i: usize| self.chains.of(i).iter().map(move |h| (h.edge().index(), i as u32));
        SegmentsAlong(Groups::new(self.subdivision.edge_bound(), (0..self.chains.count()).flat_map(along)))
    }
}

/// Which segments run along each edge; made by [`Arranged::segments_along`].
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct SegmentsAlong(Groups<u32>);

impl SegmentsAlong {
    /// The numbers of the segments along an edge, in increasing order. At least one. O(1).
    ///
    /// # Panics
    /// If there is no such edge.
    #[must_use]
    #[track_caller]
    pub fn of(&self, e: EdgeId) -> &[u32] {
        must_be_below(e, e.index(), self.0.count());
        self.0.of(e.index())
    }
}

impl Subdivision {
    /// The subdivision that segments cut the plane into.
    ///
    /// ```text
    ///      ●─────────────●         Ends with equal coordinates are one vertex. The segments may form anything that
    ///      │  ●          │         meets at common ends only: faces, trees, dangling edges, several components, inner components in
    ///      ●──┴──●  ●──● │ ●       inner components.
    ///      └─────────────●
    /// ```
    ///
    /// Vertices are numbered in the order in which they first come in the segments. Segment i is e(i), and h(2i)
    /// runs as the segment does. `outgoing(v)` is the first half-edge counter-clockwise from straight down. `f0` is
    /// the outer face; bounded faces are numbered from 1 in the order of their smallest half-edge, which is their
    /// `half_edge`. The inner components of a face come in the order of their smallest half-edges.
    ///
    /// Cost: O(n log n). All decisions are exact.
    ///
    /// # Errors
    /// [`SegmentsError`] names every segment without length, every repeated one, and all pairs that cross, touch or
    /// overlap, with the place, up to 100. [`arrange_segments`](Self::arrange_segments) can merge and split them.
    ///
    /// ```
    /// use dcel_kit::plane::{Point, SegmentFault, SegmentsError, Subdivision};
    /// let segment = |x0, y0, x1, y1| [Point::new(x0, y0), Point::new(x1, y1)];
    /// let triangle = [segment(0., 0., 4., 0.), segment(4., 0., 0., 3.), segment(0., 3., 0., 0.)];
    /// let s = Subdivision::from_segments(&triangle)?;
    /// assert_eq!((s.vertex_count(), s.edge_count(), s.face_count()), (3, 3, 2));
    ///
    /// let cross = [segment(0., 0., 2., 2.), segment(0., 2., 2., 0.)];
    /// let SegmentsError::Faults { faults, .. } = Subdivision::from_segments(&cross).unwrap_err() else { panic!() };
    /// assert_eq!(faults, [SegmentFault::Crossing { first: 0, second: 1, at: Point::new(1., 1.) }]);
    /// # Ok::<(), SegmentsError>(())
    /// ```
    pub fn from_segments(segments: &[[Point; 2]]) -> Result<Self, SegmentsError> {
        Ok(Self::arrange_segments(segments, &ArrangeOptions::default())?.subdivision)
    }

    /// [`from_segments`](Self::from_segments) for segments given by the numbers of their ends: a planar
    /// straight-line graph. Point i is v(i), segment i is e(i). Points without segments become isolated vertices.
    ///
    /// Cost: O(n log n). All decisions are exact.
    ///
    /// # Errors
    /// [`SegmentsError`], as for segments; two points at the same place are a fault, too.
    ///
    /// ```
    /// use dcel_kit::plane::{Point, Subdivision};
    /// let points = [(0., 0.), (4., 0.), (0., 3.), (1., 1.)].map(Point::from);
    /// let s = Subdivision::from_graph(&points, &[[0, 1], [1, 2], [2, 0]])?;
    /// assert_eq!((s.face_count(), s.inner_components(dcel_kit::FaceId::new(1)).len()), (2, 1));
    /// # Ok::<(), dcel_kit::plane::SegmentsError>(())
    /// ```
    pub fn from_graph(points: &[Point], segments: &[[u32; 2]]) -> Result<Self, SegmentsError> {
        Ok(Self::arrange_graph(points, segments, &ArrangeOptions::default())?.subdivision)
    }

    /// [`from_segments`](Self::from_segments) with options and a report.
    ///
    /// Merged segments get no number of their own: the others follow each other. With splitting, the edges of
    /// segment 0 come first, then those of segment 1 that are new, and so on; vertices made for crossings follow
    /// those of the input, from left to right.
    ///
    /// Cost: O((n + k) log n) time for n segments with k intersections, a few times over if they are split; memory O(n + k).
    /// Segments that are about as long as they are apart, and are split, are compared in the cells of a grid, without a sweep.
    /// Where m segments overlap on one line, k counts their ends, not their pairs. A grid takes O(√n) for each long
    /// segment beside.
    ///
    /// # Errors
    /// [`SegmentsError`] names what the options do not allow. With `split` only what is no number, or out of range, or
    /// too much: no input is refused for being close.
    ///
    /// ```
    /// use dcel_kit::plane::{ArrangeOptions, Point, Subdivision};
    /// let segment = |x0, y0, x1, y1| [Point::new(x0, y0), Point::new(x1, y1)];
    /// let options = ArrangeOptions { split: true, ..ArrangeOptions::default() };
    /// let cross = Subdivision::arrange_segments(&[segment(0., 0., 3., 1.), segment(0., 1., 3., 0.)], &options)?;
    /// assert_eq!(cross.crossings.len(), 1);
    /// assert_eq!(cross.chain(0).len(), 2);
    /// assert_eq!(cross.subdivision.point(cross.crossings[0]), Point::new(1.5, 0.5));
    /// assert!(cross.moved.is_empty());
    /// # Ok::<(), dcel_kit::plane::SegmentsError>(())
    /// ```
    pub fn arrange_segments(segments: &[[Point; 2]], options: &ArrangeOptions) -> Result<Arranged, SegmentsError> {
        check_points(segments.as_flattened())?;
        arrange(Input::segments(segments), options)
    }

    /// [`from_graph`](Self::from_graph) with options and a report; otherwise as
    /// [`arrange_segments`](Self::arrange_segments). If points are merged, vertices are numbered in the order in
    /// which they first come.
    ///
    /// # Errors
    /// [`SegmentsError`] names what the options do not allow.
    pub fn arrange_graph(
        points: &[Point],
        segments: &[[u32; 2]],
        options: &ArrangeOptions,
    ) -> Result<Arranged, SegmentsError> {
        check_graph(points, segments)?;
        arrange(Input::graph(points, segments, options), options)
    }

    /// The same for the edges of two subdivisions, those of the first one first.
    pub(super) fn arrange_two(
        points: Vec<Point>,
        segments: Vec<[u32; 2]>,
        first: usize,
        options: &ArrangeOptions,
    ) -> Result<Arranged, SegmentsError> {
        check_graph(&points, &segments)?;
        arrange(Input::two_graphs(points, segments, first), options)
    }
}

fn check_graph(points: &[Point], segments: &[[u32; 2]]) -> Result<(), SegmentsError> {
    check_points(points)?;
    match segments.as_flattened().iter().position(|&end| end as usize >= points.len()) {
        Some(i) => {
            let point = segments.as_flattened()[i];
            Err(SegmentsError::NoSuchPoint { segment: i as u32 / 2, point, points: points.len() })
        }
        None => Ok(()),
    }
}

fn check_points(points: &[Point]) -> Result<(), SegmentsError> {
    if points.len() > crate::ids::MAX_IDS {
        return Err(crate::topology::TooMany.into());
    }
    for (i, point) in points.iter().enumerate() {
        point.check().map_err(|error| SegmentsError::Coordinate { point: i as u32, error })?;
    }
    Ok(())
}
