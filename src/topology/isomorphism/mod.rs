//! Equality up to the names of the elements.
//!
//! ```text
//!        v0                  v2            h0 -> h4    the map keeps origin, twin, next, prev and face,
//!       ╱  ╲  f0            ╱  ╲  f1       v0 -> v2    the cycles of every face, the outer face, hole
//!      ╱ f1 ╲       =      ╱ f0 ╲          f1 -> f0    faces, and the face of every isolated vertex
//!    v1──────v2          v1──────v0        ...
//! ```
//!
//! In a connected structure the image of one half-edge fixes all others: follow `next` and `twin` on both sides
//! at once. So two components are compared by trying, for one half-edge of a rare kind, each half-edge of that
//! kind on the other side. A hash of the surroundings ("colour") tells the kinds apart and only ever rules
//! candidates out; the walk that follows is exact, and the finished map is checked once more, pointer by pointer.
//!
//! Components that lie in a common face hang together as a tree of components and faces. Trees are compared from
//! the leaves inwards to the centre, with a number for each kind of subtree met so far (two of a kind are equal
//! by an exact walk), so that any number of equal islands costs no more than comparing each with one of them.
//!
//! Source: one root at a time, followed on both sides: Weinberg, *A simple and efficient algorithm for determining
//! isomorphism of planar triply connected graphs*, 1966; trees from the leaves inwards: Aho, Hopcroft and Ullman,
//! *The Design and Analysis of Computer Algorithms*, 1974, section 3.2.
//!
//! ```text
//!   difference.rs  What differs, in one sentence
//!   explain.rs     Why two views that are not equal differ
//!   forest.rs      Components and the faces that join them, compared from the leaves to the centre, then matched
//!                  from the centre to the leaves
//!   matcher.rs     The map from one side to the other while it grows
//!   world.rs       Both views side by side in one set of numbers
//! ```

mod colour;
mod difference;
mod explain;
mod forest;
mod matcher;
mod world;

use super::validate::first_violation;
use super::view::View;
use crate::ids::{Element, FaceId, FaceMap, HalfEdgeId, HalfEdgeMap, VertexId, VertexMap};
pub use difference::{Difference, Which};
use world::World;

/// The partner in the second view of every element of the first; `None` for numbers that name no element.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Matching {
    /// Vertex to vertex.
    pub vertices: VertexMap<Option<VertexId>>,
    /// Half-edge to half-edge.
    pub half_edges: HalfEdgeMap<Option<HalfEdgeId>>,
    /// Face to face.
    pub faces: FaceMap<Option<FaceId>>,
}

/// A value that a vertex and its partner must share, for example the bits of a position: see [`position_key`].
pub type VertexKey = [u64; 2];

/// What [`isomorphic_with`] compares beside the structure itself.
#[derive(Clone, Copy, Default)]
pub struct IsomorphismOptions<'a> {
    keys: Option<[&'a dyn Fn(VertexId) -> VertexKey; 2]>,
    fixed: Option<&'a dyn Fn(Element) -> bool>,
    representatives: bool,
}

impl<'a> IsomorphismOptions<'a> {
    /// Compares the structure only.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Partners must have equal keys: the first function gives those of the first view, the second those of the
    /// second.
    #[must_use]
    pub fn keys(self, first: &'a dyn Fn(VertexId) -> VertexKey, second: &'a dyn Fn(VertexId) -> VertexKey) -> Self {
        Self { keys: Some([first, second]), ..self }
    }

    /// Vertices, half-edges and faces for which this is true must be their own partners: "the old ids stay, the
    /// new elements may be numbered at will".
    #[must_use]
    pub fn fixed(self, is_fixed: &'a dyn Fn(Element) -> bool) -> Self {
        Self { fixed: Some(is_fixed), ..self }
    }

    /// The stored representatives `f.half_edge` and `v.outgoing` must be partners, too.
    #[must_use]
    pub fn representatives(self) -> Self {
        Self { representatives: true, ..self }
    }
}

/// The key of a position: equal exactly for equal coordinates (0 and -0 are equal).
#[must_use]
pub fn position_key([x, y]: [f64; 2]) -> VertexKey {
    // Adding 0 turns -0 into 0 and leaves every other number alone.
    [(x + 0.0).to_bits(), (y + 0.0).to_bits()]
}

/// Whether two structures are equal up to the numbers of their elements, and which element is which; if not, what
/// differs first, with `a` as what was found and `b` as what was expected.
///
/// The arbitrary representatives `half_edge` and `outgoing` are not compared, nor which cycle of a face is its
/// boundary and which are its inner components; [`isomorphic_with`] can do the first.
///
/// Cost: O(n log n) where few half-edges look alike, as in most drawings, and where all do, as in polygons and
/// grids on equal sides. In the worst case, k times as long for k half-edges of the rarest kind of a component:
/// O(n²) for structures that are made to look alike everywhere and still differ.
///
/// # Errors
/// The first [`Difference`]. A view that breaks an invariant is [`Difference::Broken`]: validate first.
///
/// ```
/// use dcel_kit::{HalfEdgeId, topology::{Dcel, isomorphic}};
/// let h = HalfEdgeId::new;
/// let (mut a, mut b) = (Dcel::polygon(6)?, Dcel::polygon(6)?);
/// a.split_face(h(0), h(4))?;
/// b.split_face(h(0), h(6))?;
/// assert_eq!(isomorphic(&a, &b).unwrap_err().to_string(), "1 face with 3 half-edges, expected 0");
/// b.join_faces(h(12))?;
/// b.split_face(h(10), h(2))?;
/// assert!(isomorphic(&a, &b)?.half_edges[h(0)].is_some());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn isomorphic<A: View + ?Sized, B: View + ?Sized>(a: &A, b: &B) -> Result<Matching, Difference> {
    isomorphic_with(a, b, &IsomorphismOptions::new())
}

/// [`isomorphic`], with more to compare.
///
/// # Errors
/// The first [`Difference`].
pub fn isomorphic_with<A: View + ?Sized, B: View + ?Sized>(
    a: &A,
    b: &B,
    options: &IsomorphismOptions,
) -> Result<Matching, Difference> {
    if let Some(violation) = first_violation(a) {
        return Err(Difference::Broken { which: Which::First, violation: Box::new(violation) });
    }
    if let Some(violation) = first_violation(b) {
        return Err(Difference::Broken { which: Which::Second, violation: Box::new(violation) });
    }
    let world = World::new(a, b, options)?;
    explain::histograms(&world)?;
    forest::compare(&world)
}
