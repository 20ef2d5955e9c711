//! Half-edge structures to learn with: doubly-connected edge lists (DCEL) of the plane, with an explicit outer
//! face, exact geometry, formats and figures.
//!
#![doc = include_str!("../figures/cube.svg")]
//!
//! Five words, and the whole structure is said:
//!
//! - an edge is two **half-edges**; the other one is its `twin`;
//! - a half-edge starts at its `origin`;
//! - it bounds one `face`, which lies on its **left**;
//! - `next` is the half-edge after it along that face,
//! - and `prev` the one before it.
//!
//! y points up; bounded faces run counter-clockwise; `f0`, the outer face, is a face like any other. So no walk
//! needs a special case:
//!
//! ```
//! use dcel_kit::plane::Subdivision;
//! use dcel_kit::HalfEdgeId;
//!
//! let mut lab = Subdivision::lab_rectangle();
//! let (h, new_face) = lab.split_face(HalfEdgeId::new(2), HalfEdgeId::new(8))?;
//! let (middle, _) = lab.split_in_half(h)?;
//! let round_the_face: Vec<_> = lab.incident_vertices(new_face).map(|v| v.to_string()).collect();
//! assert_eq!(round_the_face, ["v1", "v6", "v4", "v5", "v0"]);
//! assert_eq!(lab.outgoing_half_edges(middle).count(), 2);
//! assert_eq!(lab.vertex_count() + lab.face_count(), lab.edge_count() + 2);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! | room | what is in it |
//! |---|---|
//! | [`ids`] | `v3`, `h7`, `e3`, `f0`, and arrays indexed by them |
//! | [`topology`] | [`Dcel`](topology::Dcel): the structure without any coordinate; walks, edits, invariants, builder |
//! | [`plane`] | [`Subdivision`](plane::Subdivision): positions, exact decisions, the converter from triangles |
//! | [`navmesh`] | [`NavMesh`](navmesh::NavMesh): neighbours, location, ways over a map, up to the exact shortest one |
//! | [`solid`] | [`Polyhedron`](solid::Polyhedron): positions in space |
//! | [`edits`] | the table of all edits: a word, arguments and results for each |
//! | [`script`] | edits as text: typed by a student, printed by a failing test |
//! | [`io`] | formats in and out |
//! | [`figure`] | drawings as SVG |
//! | [`compare`] | two drawings compared by what they mean |
//! | [`files`] | files that are there whole or not at all |
//! | [`old_words`] | words that have been replaced, and are still read |
//!
//! The first three are always there; each of the others is a feature of the same name, and on by default.
//! `default-features = false` leaves the structure and the plane, built with two crates of others (`robust` and
//! `thiserror`) in a few seconds; add `features = ["figure"]` for drawings or `["io"]` for files. The feature `png` is
//! off by default. Labs graded from outside are the package `dcel-lab`, the command line is the package `dcel`.
//!
//! Words used elsewhere: *dart* is a half-edge, *sym* or *opposite* is `twin`, *tail* is `origin`, *tip* or
//! *head* is `destination`, *dcel* and *half-edge structure* mean the same.

// Nothing may panic on data: an error, or expect() with the reason why it cannot happen.
#![warn(clippy::unwrap_used)]

#[cfg(feature = "compare")]
pub mod compare;
#[cfg(feature = "script")]
pub mod edits;
#[cfg(feature = "figure")]
pub mod figure;
#[cfg(feature = "files")]
pub mod files;
mod geometry;
pub mod ids;
#[cfg(feature = "io")]
pub mod io;
#[cfg(feature = "navmesh")]
pub mod navmesh;
pub mod old_words;
pub mod plane;
#[cfg(feature = "script")]
pub mod script;
#[cfg(feature = "solid")]
pub mod solid;
#[cfg(feature = "sources")]
#[doc(hidden)]
pub mod sources;
pub mod topology;

pub use ids::{
    EdgeId, EdgeMap, Element, FaceId, FaceMap, HalfEdgeId, HalfEdgeMap, Id, IdMap, ParseIdError, VertexId, VertexMap,
};
#[cfg(feature = "navmesh")]
pub use navmesh::NavMesh;
pub use plane::{Point, Subdivision};
#[cfg(feature = "solid")]
pub use solid::Polyhedron;
pub use topology::Dcel;

/// The examples of the README, run as tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
