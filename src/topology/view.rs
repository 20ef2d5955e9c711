//! Reading any half-edge structure: ours, or a table dumped from somebody else's program.
//!
//! A [`View`] may be broken in every way: pointers may be missing, out of range or contradictory. Code that
//! reads views (the validator, `same`, the figures) must bound its walks.

use super::Dcel;
use crate::ids::{Element, FaceId, HalfEdgeId, VertexId};

/// A boundary cycle of a face beside its first one, or a vertex without edges that lies in the face.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum InnerComponent {
    /// A cycle, by one of its half-edges.
    Cycle(HalfEdgeId),
    /// A vertex without edges.
    Isolated(VertexId),
}

impl InnerComponent {
    /// The half-edge of a cycle.
    #[inline]
    pub(crate) fn cycle(self) -> Option<HalfEdgeId> {
        if let Self::Cycle(h) = self { Some(h) } else { None }
    }

    /// The vertex without edges.
    #[inline]
    pub(crate) fn isolated(self) -> Option<VertexId> {
        if let Self::Isolated(v) = self { Some(v) } else { None }
    }
}

/// The half-edge or the vertex.
impl From<InnerComponent> for Element {
    fn from(ring: InnerComponent) -> Self {
        match ring {
            InnerComponent::Cycle(h) => h.into(),
            InnerComponent::Isolated(v) => v.into(),
        }
    }
}

/// Read access to a half-edge structure that need not obey any invariant.
///
/// Ids run from 0 to the bounds; `has_*` says which of them exist. A pointer that is missing reads as `None`.
/// Getters must accept every id, existing or not, and return `None` for those that do not exist.
pub trait View {
    /// One more than the greatest vertex number.
    fn vertex_bound(&self) -> usize;
    /// One more than the greatest half-edge number.
    fn half_edge_bound(&self) -> usize;
    /// One more than the greatest face number.
    fn face_bound(&self) -> usize;
    /// Whether the vertex exists.
    fn has_vertex(&self, v: VertexId) -> bool;
    /// Whether the half-edge exists.
    fn has_half_edge(&self, h: HalfEdgeId) -> bool;
    /// Whether the face exists.
    fn has_face(&self, f: FaceId) -> bool;
    /// The vertex `h` starts at.
    fn origin(&self, h: HalfEdgeId) -> Option<VertexId>;
    /// The other half of the edge of `h`.
    fn twin(&self, h: HalfEdgeId) -> Option<HalfEdgeId>;
    /// The half-edge after `h`.
    fn next(&self, h: HalfEdgeId) -> Option<HalfEdgeId>;
    /// The half-edge before `h`.
    fn prev(&self, h: HalfEdgeId) -> Option<HalfEdgeId>;
    /// The face on the left of `h`.
    fn face(&self, h: HalfEdgeId) -> Option<FaceId>;
    /// A half-edge that starts at `v`.
    fn outgoing(&self, v: VertexId) -> Option<HalfEdgeId>;
    /// A half-edge of the first boundary cycle of `f`.
    fn half_edge(&self, f: FaceId) -> Option<HalfEdgeId>;

    /// The other cycles of `f`, and the isolated vertices in it. All cycles of the outer face but the first
    /// are here, too.
    fn inner_components(&self, f: FaceId) -> &[InnerComponent] {
        let _ = f;
        &[]
    }

    /// The unbounded face, if the structure lies in the plane.
    fn outer_face(&self) -> Option<FaceId> {
        None
    }

    /// Whether `f` is a bounded face that is not part of the domain.
    fn is_hole(&self, f: FaceId) -> bool {
        let _ = f;
        false
    }

    /// All pointers at once, of a structure that keeps them in the columns of a [`Dcel`]: they say the same as the getters.
    #[doc(hidden)]
    fn words(&self) -> Option<Words<'_>> {
        None
    }
}

/// The columns of a [`Dcel`]: where a record was removed, and where there is no target, stands no number of an element.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct Words<'a> {
    pub(super) origin: &'a [u32],
    pub(super) next: &'a [u32],
    pub(super) prev: &'a [u32],
    pub(super) face: &'a [u32],
    pub(super) outgoing: &'a [u32],
    pub(super) boundary: &'a [u32],
}

/// The pointers of a view whose structure is the [`Dcel`] at `self.$dcel`; for use inside `impl View for`.
macro_rules! pointers_of_dcel {
    ($($dcel:ident)?) => {
        fn vertex_bound(&self) -> usize {
            self$(.$dcel)?.vertex_bound()
        }
        fn half_edge_bound(&self) -> usize {
            self$(.$dcel)?.half_edge_bound()
        }
        fn face_bound(&self) -> usize {
            self$(.$dcel)?.face_bound()
        }
        fn has_vertex(&self, v: $crate::VertexId) -> bool {
            self$(.$dcel)?.has_vertex(v)
        }
        fn has_half_edge(&self, h: $crate::HalfEdgeId) -> bool {
            self$(.$dcel)?.has_half_edge(h)
        }
        fn has_face(&self, f: $crate::FaceId) -> bool {
            self$(.$dcel)?.has_face(f)
        }
        fn origin(&self, h: $crate::HalfEdgeId) -> Option<$crate::VertexId> {
            self$(.$dcel)?.linked_origin(h)
        }
        fn twin(&self, h: $crate::HalfEdgeId) -> Option<$crate::HalfEdgeId> {
            self$(.$dcel)?.has_half_edge(h).then(|| h.twin())
        }
        fn next(&self, h: $crate::HalfEdgeId) -> Option<$crate::HalfEdgeId> {
            self$(.$dcel)?.linked_next(h)
        }
        fn prev(&self, h: $crate::HalfEdgeId) -> Option<$crate::HalfEdgeId> {
            self$(.$dcel)?.linked_prev(h)
        }
        fn face(&self, h: $crate::HalfEdgeId) -> Option<$crate::FaceId> {
            self$(.$dcel)?.linked_face(h)
        }
        fn outgoing(&self, v: $crate::VertexId) -> Option<$crate::HalfEdgeId> {
            self$(.$dcel)?.linked_outgoing(v)
        }
        fn half_edge(&self, f: $crate::FaceId) -> Option<$crate::HalfEdgeId> {
            self$(.$dcel)?.linked_half_edge(f)
        }
        fn words(&self) -> Option<$crate::topology::Words<'_>> {
            Some(self$(.$dcel)?.all_words())
        }
    };
}
pub(crate) use pointers_of_dcel;

impl View for Dcel {
    pointers_of_dcel!();
}

/// Whether the element exists.
#[cfg(feature = "figure")]
pub(crate) fn has<V: View + ?Sized>(view: &V, element: Element) -> bool {
    match element {
        Element::Vertex(v) => view.has_vertex(v),
        Element::HalfEdge(h) => view.has_half_edge(h),
        Element::Edge(e) => view.has_half_edge(e.half_edges()[0]),
        Element::Face(f) => view.has_face(f),
    }
}

/// At most `half_edge_bound` half-edges along `next` from `start`, ending before `start` comes again or where
/// the chain breaks: a cycle walk that cannot hang.
pub fn bounded_cycle<V: View + ?Sized>(view: &V, start: HalfEdgeId) -> impl Iterator<Item = HalfEdgeId> + '_ {
    let mut at = view.has_half_edge(start).then_some(start);
    (0..view.half_edge_bound()).map_while(move |_| {
        let h = at?;
        at = view.next(h).filter(|&n| n != start && view.has_half_edge(n));
        Some(h)
    })
}
