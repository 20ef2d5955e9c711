//! The combinatorial structure: how vertices, half-edges and faces hang together, without any coordinate.
//!
//! | task | types |
//! |---|---|
//! | the structure, to walk and to ask | [`Dcel`]; any structure, also a broken one, is a [`View`] |
//! | make one | [`Dcel::polygon`], [`Dcel::from_polygons`], [`PolygonList`] |
//! | edit it, watch the edit, take it back | [`Dcel::split_face`] and its like; [`Recorder`], [`Journal`] |
//! | watch an algorithm | [`Observer`] |
//! | write an edit of your own | [`Editing`] |
//! | keep data on elements while they come and go | [`Followed`], [`Renumbering`] |
//! | check the invariants | [`violations`], [`Violation`], [`Rule`] |
//! | count | [`measure()`], [`Counts`], [`components`] |
//! | compare | [`isomorphic()`], [`IsomorphismOptions`], [`Matching`], [`Difference`] |
//! | tables, as on slides or from other programs | [`Table`], [`TableColumns`] |

// The files of this folder:
//
//   links.rs     the memory layout, and nothing else knows it
//   pen.rs       the columns while an edit writes to them
//   pool.rs      records come and go: counts, free lists, undo, compact
//   walk.rs      round a face, round a vertex
//   edit/        split_face, join_faces, split_edge, join_edges, split_vertex, join_vertices, collapse_edge, flip_edge
//   seed.rs      polygons to start from        build.rs     from lists of polygons
//   orient.rs    which faces to turn round
//   observe.rs   watching an algorithm
//   record.rs    watching an edit              view.rs, table.rs   reading any structure   replay.rs  an edit on a table
//   table_columns.rs  a table as it comes out of a large file
//   reads.rs     the reading methods, for structures that hold one
//   log.rs       a journal of more than pointers           follow.rs   data that follow edits
//   own.rs       edits that are not in the kit
//   validate/    the invariants                isomorphism/ equality up to names      measure.rs  counts
//   flat.rs      a view as flat arrays, for these three
//   dual.rs      faces become vertices

mod build;
mod dual;
mod edit;
mod flat;
mod follow;
mod isomorphism;
mod links;
mod log;
mod measure;
mod observe;
mod orient;
mod own;
mod pen;
mod polygons;
mod pool;
mod reads;
mod record;
mod replay;
mod seed;
mod table;
mod table_columns;
mod validate;
mod view;
mod walk;

pub use build::{BuildError, Built};
pub(crate) use build::{Faces, match_faces};
pub use dual::DualError;
pub use edit::{
    CollapseEdgeError, FlipEdgeError, JoinEdgesError, JoinFacesError, JoinVerticesError, SplitEdgeError,
    SplitFaceError, SplitVertexError,
};
pub use follow::{Followed, Follows};
pub use isomorphism::{
    Difference, IsomorphismOptions, Matching, VertexKey, Which, isomorphic, isomorphic_with, position_key,
};
pub(crate) use links::Columns;
pub use links::Dcel;
pub use log::Log;
pub use measure::{ComponentCounts, Components, Counts, Mode, components, measure, measure_with};
pub use observe::{NoObserver, Observer};
pub use orient::{OneSided, faces_to_turn};
pub use own::{Editing, OwnEditError};
pub use polygons::PolygonList;
pub use pool::{IdError, Renumbering, TooMany};
pub(crate) use reads::reads_of_dcel;
#[cfg(feature = "solid")]
pub(crate) use record::Quiet;
pub use record::{Change, Journal, NoRecorder, Recorder, Slot, Step};
#[cfg(feature = "compare")]
pub(crate) use replay::set_row;
pub use seed::PolygonError;
pub use table::{FaceRow, HalfEdgeRow, Table, VertexRow};
pub use table_columns::TableColumns;
pub use validate::{Rule, Violation, first_violation, violations, visit_violations};
#[doc(hidden)]
pub use view::Words;
#[cfg(feature = "figure")]
pub(crate) use view::has;
pub(crate) use view::pointers_of_dcel;
pub use view::{InnerComponent, View, bounded_cycle};
pub use walk::{Cycle, OutgoingHalfEdges};
