//! Surfaces that grow and shrink face by face.
//!
//! ```text
//!   add_face ──> ●─────●         a border half-edge is never left loose: it has next, prev and a boundary face
//!              ╱ │ new │
//!             ●  │     │         one fan at v                     two fans at v: the gaps are linked so that
//!    border    ╲ ●─────●                                          the round about v stays one round
//!               ╲│ f0  │           gap ╲   ╱                         f1 ╲ │ ╱ gap
//!                ●─────●                ╲ ╱ f1                    ──────── v ────────
//!                                   ──── v                          gap ╱ │ ╲ f2
//! ```
//!
//! After every edit all invariants hold ([`violations`](crate::topology::violations) is empty), and no edge map is kept:
//! a walk round a vertex meets all its edges, so [`find_half_edge`](crate::topology::Dcel::find_half_edge) is
//! O(degree).
//!
//! **Which borders join.** While a surface grows, several fans of faces may touch in a vertex; without coordinates
//! nobody knows in which order they stand round it. The invariant: the round about the vertex goes through the fans one
//! after the other, and each gap leads from the end of a fan to the start of the next. A new face whose two edges at
//! the vertex are both new opens its fan in the gap that `outgoing` stands in, else in the first gap
//! counter-clockwise from there. A new face that joins the ends of two fans makes them neighbours: what stood
//! between them moves into the first other gap counter-clockwise. The boundary faces are the border cycles this
//! gives. Once each vertex has one fan, the order has left no trace but the numbers.
//!
//! **Watched.** Each edit has a form `..._with` that takes a recorder, as those of the kernel:
//! [`SurfaceJournal`](super::SurfaceJournal) can take everything back. Without one it costs nothing.
//!
//! **Boundary faces keep their numbers** as long as their cycle stays one cycle. When an edit cuts or joins border
//! cycles, the longest stretch keeps its face; so an edit costs no more than the second longest stretch.
//!
//! ```text
//!   collapse_edge.rs  Collapsing an edge of a surface, so that its holes stay open and apart
//!   remove_face.rs    Taking a face away
//! ```

mod add_face;
mod border;
mod collapse_edge;
mod remove_face;
mod vertex;

pub use add_face::AddFaceError;
pub use collapse_edge::CollapseError;
pub use remove_face::RemoveFaceError;
pub use vertex::{AddVertexError, RemoveVertexError};
