//! Ways over a map: from the neighbours of a face in O(1) to the exact shortest path round all corners.
//!
//! ```text
//!   ┌───────┬───────────┐      A navmesh is a subdivision whose bounded faces are convex: whoever stands in one can go
//!   │ s ╲   │     ╱     │      straight to any other point of it. An edge between two faces is a door; what is no
//!   │    ╲  │   ╱   ┌───┤      face of the domain (f0, hole faces) is a gap.
//!   │      ╲│ ╱     │gap│
//!   └───────●───────┴───┘      Every rung of the ladder gives a Route: faces, the doors between them, points, length.
//! ```
//!
//! | rung | question | file |
//! |---|---|---|
//! | 0 | is it a navmesh at all, and what is wrong? | `validate.rs` |
//! | 1 | which faces lie across the sides, round a vertex, in one piece? | `mesh.rs`, `around.rs`, `components.rs`, `dead_ends.rs` |
//! | 2 | in which face is a point? | `grid.rs`, `coarse.rs`, `slivers.rs`, `location.rs`, `nearest.rs` |
//! | 3 | which faces lead from here to there? | `waves.rs`, `corridor.rs`, by whole passages `crossings.rs`, `jumps.rs`, `strides.rs` |
//! | 4 | what is the shortest way through these faces? | `funnel.rs` |
//! | 5 | what is the shortest way of all? | `exact/`, over larger faces `merged.rs` |
//! | 6 | which of them are wide enough? how far is everything? | `inset.rs`, `doors.rs`, `field.rs` |
//! | 7 | and when walls come and go? | `change.rs`, `upkeep.rs`, `live/` |
//!
//! Every decision is a sign of [`orientation`](crate::plane::predicates::orientation) on points that were given, so
//! it is exact; lengths are plain doubles. Ids are those of the subdivision.

mod around;
mod change;
mod coarse;
mod components;
mod corridor;
mod crossings;
mod curve;
mod dead_ends;
mod doors;
mod error;
mod exact;
mod field;
mod funnel;
mod grid;
mod inset;
mod jumps;
mod live;
mod location;
mod merged;
mod mesh;
mod nearest;
mod planner;
mod rooms;
mod route;
mod slivers;
mod strides;
mod upkeep;
mod validate;
mod waves;

pub use crossings::Passage;
pub use error::NavMeshError;
pub use exact::Cone;
pub use field::DistanceField;
pub use funnel::FunnelStep;
pub use inset::{Inset, InsetError};
pub use live::{LiveMesh, ObstacleError, ObstacleId};
pub use location::{Location, Place, PlaceError};
pub use merged::MergedFace;
pub use mesh::{ComponentId, NavMesh, Side};
pub use nearest::Nearest;
pub use planner::Planner;
pub use route::{Portal, Route, RouteError, Rung, Work};
pub use validate::{MeshFault, double_corners_of, mesh_faults};
