//! Paths over a map: from the neighbours of a face in O(1) to the exact shortest path round all corners.
//!
//! ```text
//!   ┌───────┬───────────┐      A navmesh is a subdivision whose bounded faces are convex: whoever stands in one can go
//!   │ s ╲   │     ╱     │      straight to any other point of it. An edge between two faces is a portal; what is no
//!   │    ╲  │   ╱   ┌───┤      face of the domain (f0, hole faces) is a hole.
//!   │      ╲│ ╱     │ ▒ │
//!   └───────●───────┴───┘      Every path algorithm gives a Route: faces, the portals between them, points, length.
//! ```
//!
//! From a file to a picture of the shortest path:
//!
//! ```
//! # #[cfg(feature = "io")] {
//! use dcel_kit::figure::{FigureOptions, navmesh::Floor};
//! use dcel_kit::io::{LoadOptions, Structure, load};
//! use dcel_kit::navmesh::{NavMesh, Planner, PathAlgorithm};
//! use dcel_kit::plane::Point;
//!
//! let file = std::path::Path::new("figures/data/rooms.map");
//! let Structure::Plane(map) = load(file, &LoadOptions::default())?.structure else { panic!("no map of the plane") };
//! let mesh = NavMesh::new(&map)?;
//! // Here y points up; in the file it points down.
//! let [start, goal] = [Point::new(1.0, -1.0), Point::new(22.0, -12.0)];
//! let route = Planner::new().route_between(&mesh, PathAlgorithm::Exact, start, goal)?;
//! println!("{} long, round {:?}", route.length, route.corners);
//! let figure = Floor::new(&map, &mesh).route(&route, &FigureOptions::new("A path"))?;
//! std::fs::write(std::env::temp_dir().join("path.svg"), figure.to_svg())?;
//! # assert_eq!(route.points.len(), route.corners.len() + 2);
//! # }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! | algorithm | question | file |
//! |---|---|---|
//! | 0 | is it a navmesh at all, and what is wrong? | `validate.rs`, `fault.rs`, `fault_sentence.rs`, `weld.rs` |
//! | 1 | which faces lie across the sides, round a vertex, in one piece? | `mesh.rs`, `marks.rs`, `records.rs`, `many_corners.rs`, `around.rs`, `components.rs`, `dead_ends.rs` |
//! | 2 | in which face is a point? | `grid.rs`, `grid_cells.rs`, `hole_edges.rs`, `coarse.rs`, `slivers.rs`, `holes.rs`, `location.rs`, `nearest.rs` |
//! | 3 | which faces lead from here to there? | `bidirectional_bfs.rs`, `corridor.rs`, by whole reduced corridors `junctions.rs`, `reduced_bfs.rs`, `reduced_astar.rs` |
//! | 4 | what is the shortest path through these faces? | `funnel.rs` |
//! | 5 | what is the shortest path of all? | `exact/`, over larger faces `merged.rs` |
//! | 6 | which of them are wide enough? how far is everything? | `inset.rs`, `portals.rs`, `field.rs`, where faces cost more `price.rs`, `weighted.rs`, `steiner.rs`, `weighted_field.rs` |
//! | | what does a straight line meet? where is somebody at random? how do teleports and storeys help? | `raycast.rs`, `random.rs`, `links.rs`, `steps.rs` |
//! | 7 | and when walls come and go? | `change.rs`, `upkeep.rs`, `live/` |
//! | 8 | and in space, up and down, over and under each other? | `surface/` |
//!
//! Every decision is a sign of [`orientation`](crate::plane::predicates::orientation) on points that were given, so
//! it is exact; lengths are plain doubles. Ids are those of the subdivision.
//!
//! ```text
//!   curve.rs    An order of places in which what is near is mostly near in the row, too
//!   planner.rs  The planner
//!   scratch.rs  What all searches share
//! ```

mod around;
mod bidirectional_bfs;
mod change;
mod coarse;
mod components;
mod corridor;
mod curve;
mod dead_ends;
mod error;
mod exact;
mod fault;
mod fault_sentence;
mod field;
mod funnel;
mod grid;
mod grid_cells;
mod hole_edges;
mod holes;
mod inset;
mod junctions;
mod links;
mod live;
mod location;
mod many_corners;
mod marks;
mod merged;
mod mesh;
mod nearest;
mod planner;
mod portals;
mod price;
mod random;
mod raycast;
mod records;
mod reduced_astar;
mod reduced_bfs;
mod rooms;
mod route;
mod scratch;
mod slivers;
mod steiner;
mod steps;
mod surface;
mod upkeep;
mod validate;
mod weighted;
mod weighted_field;
mod weld;

pub use error::NavMeshError;
pub use exact::Cone;
pub use fault::MeshFault;
pub use fault_sentence::FaultNames;
pub use field::DistanceField;
pub use funnel::FunnelStep;
pub use inset::{Inset, InsetError};
pub use junctions::ReducedCorridor;
pub use links::{Leg, Link, LinkError, LinkedRoute, Stop};
pub use live::{EditWork, LiveMesh, ObstacleError, ObstacleId};
pub use location::{Location, QueryPoint, QueryPointError};
pub use merged::MergedFace;
pub use mesh::{ComponentId, NavMesh, Side};
pub use nearest::Nearest;
pub use planner::Planner;
pub use random::RandomPoints;
pub use raycast::{RayHit, Raycast, RaycastError};
pub use route::{PathAlgorithm, Portal, Route, RouteError, Work};
pub use surface::{
    Floor, LinkedSurfaceRoute, NavSurface, RandomSurfacePlaces, SurfaceError, SurfaceField, SurfaceLink,
    SurfacePlanner, SurfacePoint, SurfacePointError, SurfaceRayHit, SurfaceRaycast, SurfaceRoute, SurfaceRouteError,
};
pub use validate::{double_corners_of, mesh_faults};
pub use weld::{Welded, weld, weld_in_space};
