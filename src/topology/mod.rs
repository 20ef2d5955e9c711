//! The combinatorial structure: how vertices, half-edges and faces hang together, without any coordinate.
//!
//! ```text
//!   links.rs     the memory layout, and nothing else knows it
//!   pool.rs      records come and go: counts, free lists, undo, compact
//!   walk.rs      round a face, round a vertex
//!   edit/        split_face, join_faces, split_edge, join_edges
//!   seed.rs      polygons to start from        build.rs     from lists of polygons
//!   record.rs    watching an edit              view.rs, table.rs   reading any structure
//!   validate.rs  the laws                      same.rs      equality up to names      measure.rs  counts
//! ```

mod build;
mod edit;
mod links;
mod polygons;
mod pool;
mod record;
mod seed;
mod table;
mod view;
mod walk;

pub use build::{BuildError, Built};
pub(crate) use build::{Faces, match_faces};
pub use edit::{JoinEdgesError, JoinFacesError, SplitEdgeError, SplitFaceError};
pub use links::Dcel;
pub use polygons::PolygonList;
pub use pool::{IdError, Renumbering, TooMany};
pub use record::{Change, Journal, NoRecorder, Recorder, Slot, Step};
pub use seed::PolygonError;
pub use table::{FaceRow, HalfEdgeRow, Table, VertexRow};
pub use view::{Ring, View, bounded_cycle};
pub use walk::{Cycle, Star};
