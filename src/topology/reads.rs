//! All that can be read from a [`Dcel`](super::Dcel), as methods of a structure that holds one.
//!
//! ```text
//!   Subdivision { dcel, points, ... }     s.next(h) = s.dcel.next(h)      walks, counts, ids
//!   Polyhedron  { dcel, points, ... }     s.split_vertex(..)              is no method: only a bare Dcel has that edit
//! ```
//!
//! Dereferencing would offer the edits of the kernel, too, and whether one is possible there; but what the kernel takes
//! need not be possible with coordinates.

/// The reading methods of the structure at `self.$dcel`; for use inside `impl`.
macro_rules! reads_of_dcel {
    ($dcel:ident) => {
        $crate::topology::reads_of_dcel! { $dcel:
            fn vertex_bound() -> usize;
            fn half_edge_bound() -> usize;
            fn edge_bound() -> usize;
            fn face_bound() -> usize;
            fn vertex_count() -> usize;
            fn half_edge_count() -> usize;
            fn edge_count() -> usize;
            fn face_count() -> usize;
            fn memory_bytes() -> usize;
            fn has_vertex(v: $crate::VertexId) -> bool;
            fn has_half_edge(h: $crate::HalfEdgeId) -> bool;
            fn has_edge(e: $crate::EdgeId) -> bool;
            fn has_face(f: $crate::FaceId) -> bool;
            fn check(element: impl Into<$crate::Element>) -> Result<(), $crate::topology::IdError>;
            fn origin(h: $crate::HalfEdgeId) -> $crate::VertexId;
            fn destination(h: $crate::HalfEdgeId) -> $crate::VertexId;
            fn twin(h: $crate::HalfEdgeId) -> $crate::HalfEdgeId;
            fn edge(h: $crate::HalfEdgeId) -> $crate::EdgeId;
            fn next(h: $crate::HalfEdgeId) -> $crate::HalfEdgeId;
            fn prev(h: $crate::HalfEdgeId) -> $crate::HalfEdgeId;
            fn face(h: $crate::HalfEdgeId) -> $crate::FaceId;
            fn outgoing(v: $crate::VertexId) -> Option<$crate::HalfEdgeId>;
            fn half_edge(f: $crate::FaceId) -> Option<$crate::HalfEdgeId>;
            fn ccw(h: $crate::HalfEdgeId) -> $crate::HalfEdgeId;
            fn cw(h: $crate::HalfEdgeId) -> $crate::HalfEdgeId;
            fn cycle(h: $crate::HalfEdgeId) -> $crate::topology::Cycle<'_>;
            fn star(h: $crate::HalfEdgeId) -> $crate::topology::OutgoingHalfEdges<'_>;
            fn incident_half_edges(f: $crate::FaceId) -> $crate::topology::Cycle<'_>;
            fn incident_vertices(f: $crate::FaceId)
                -> impl DoubleEndedIterator<Item = $crate::VertexId> + Clone + '_;
            fn incident_edges(f: $crate::FaceId) -> impl DoubleEndedIterator<Item = $crate::EdgeId> + Clone + '_;
            fn adjacent_faces(f: $crate::FaceId) -> impl DoubleEndedIterator<Item = $crate::FaceId> + Clone + '_;
            fn outgoing_half_edges(v: $crate::VertexId) -> $crate::topology::OutgoingHalfEdges<'_>;
            fn incoming_half_edges(v: $crate::VertexId)
                -> impl DoubleEndedIterator<Item = $crate::HalfEdgeId> + Clone + '_;
            fn adjacent_vertices(v: $crate::VertexId)
                -> impl DoubleEndedIterator<Item = $crate::VertexId> + Clone + '_;
            fn incident_faces(v: $crate::VertexId) -> impl DoubleEndedIterator<Item = $crate::FaceId> + Clone + '_;
            fn degree(v: $crate::VertexId) -> usize;
            fn find_half_edge(u: $crate::VertexId, v: $crate::VertexId) -> Option<$crate::HalfEdgeId>;
            fn vertices() -> impl DoubleEndedIterator<Item = $crate::VertexId> + Clone + '_;
            fn half_edges() -> impl DoubleEndedIterator<Item = $crate::HalfEdgeId> + Clone + '_;
            fn edges() -> impl DoubleEndedIterator<Item = $crate::EdgeId> + Clone + '_;
            fn faces() -> impl DoubleEndedIterator<Item = $crate::FaceId> + Clone + '_;
        }
    };
    ($dcel:ident: $(fn $name:ident($($argument:ident: $type:ty),*) -> $out:ty;)*) => {
        $(
            #[doc = concat!("As [`Dcel::", stringify!($name), "`](crate::topology::Dcel::", stringify!($name), ").")]
            #[inline]
            #[track_caller]
            pub fn $name(&self, $($argument: $type),*) -> $out {
                self.$dcel.$name($($argument),*)
            }
        )*
    };
}
pub(crate) use reads_of_dcel;
