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
//! needs a special case. Every decision about positions is exact; every edit that is refused leaves everything as it
//! was; every error says which element, where, and what to try.
//!
//! # A first program
//!
//! ```
//! use dcel_kit::{HalfEdgeId, Subdivision};
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
//! The folder `examples/` of the repository holds ten programs of this kind, each with what it prints.
//!
//! # What do you want to do?
//!
//! | task | begin with |
//! |---|---|
//! | learn, or teach: the bare structure, its walks, edits and laws | [`Dcel`], [`topology`] |
//! | draw in the plane: build, edit, locate, triangulate, overlay | [`Subdivision`], [`plane`] |
//! | find paths on a map | [`NavMesh`], [`navmesh`] |
//! | model surfaces in space | [`Polyhedron`], [`solid`] |
//! | read and write files | [`io::load`], [`io::write_path`] |
//! | make pictures | [`figure::structure()`], [`figure`] |
//! | type edits, replay them, film them | [`script::Script`], [`figure::Film`] |
//! | write an edit of your own | [`edits::Row`], [`topology::Editing`] |
//! | keep data of your own on elements | [`ids::IdMap`], [`topology::Followed`] |
//! | show how far long work has come | [`progress::Progress`] |
//! | ask whether two structures or drawings are the same | [`topology::isomorphic()`], [`compare::compare()`] |
//!
//! # Which features?
//!
//! `solid`, `navmesh`, `script`, `io`, `figure` and `compare` are on by default. [`ids`], [`topology`] and [`plane`] are always there: with `default-features =
//! false` they are the whole library.
//!
//! | feature | what it brings | crates, the library itself among them |
//! |---|---|---|
//! | (none) | ids, the structure, the plane: build, edit, locate, triangulate, overlay | 8 |
//! | `solid` | surfaces and solids in space | 8 |
//! | `navmesh` | neighbours, location and paths on maps and floors | 8 |
//! | `script` | the table of edits, edits as text | 8 |
//! | `files` | files that are there whole or not at all | 8 |
//! | `io` | formats in and out; `solid` and `files` with it | 15 |
//! | `figure` | drawings as SVG | 16 |
//! | `play` | a session of the playground, the page that `dcel play` writes | 18 |
//! | `compare` | drawings compared by what they mean; `figure` with it | 17 |
//! | `serde` | structures, ids and points written and read, checked | 11 |
//! | `geo-types` | polygons and lines of geographic crates in and out | 11 |
//! | `glam`, `mint` | points as vectors | 9 each |
//! | `parallel` | two threads and more for large work, with the same answers: [`plane`] and [`solid`] say for which | 14 |
//! | `png` | figures as PNG and PDF, with a font of their own; `figure` with it | 97 |
//!
//! A page on `serde`, `geo-types`, `glam` and `mint` is the module `interop`, which is there with any of them.
//!
//! Labs graded from outside are the package `dcel-lab`, the command line is the package `dcel`.
//!
//! # Words used elsewhere
//!
//! *dart* is a half-edge, *sym* or *opposite* is `twin`, *tail* is `origin`, *tip* or *head* is `destination`, *dcel* and
//! *half-edge structure* mean the same.

#![cfg_attr(docsrs, feature(doc_cfg))]
// Nothing may panic on data: an error, or expect() with the reason why it cannot happen.
#![warn(clippy::unwrap_used)]

/// An enumeration whose values have a name each.
///
/// ```text
///   named! {
///       enum Kind { Vertex = "a vertex", … }     the type
///       fn a;                                    Kind::Vertex.a() is "a vertex"
///       fn a as Display;                         the same, and it is shown so
///       const ALL;                               Kind::ALL, all values in their order
///   }
/// ```
#[doc(hidden)]
#[macro_export]
macro_rules! named {
    (
        $(#[$meta:meta])* $vis:vis enum $type:ident { $($(#[$about:meta])* $value:ident = $name:literal,)+ }
        $(#[$about_name:meta])* fn $of:ident $(as $shown:ident)?;
        $(#[$about_all:meta])* const ALL;
    ) => {
        $crate::named! {
            $(#[$meta])* $vis enum $type { $($(#[$about])* $value = $name,)+ }
            $(#[$about_name])* fn $of $(as $shown)?;
        }

        impl $type {
            $(#[$about_all])*
            $vis const ALL: [Self; [$($name),+].len()] = [$(Self::$value),+];
        }
    };
    (
        $(#[$meta:meta])* $vis:vis enum $type:ident { $($(#[$about:meta])* $value:ident = $name:literal,)+ }
        $(#[$about_name:meta])* fn $of:ident $(as $shown:ident)?;
    ) => {
        $(#[$meta])*
        $vis enum $type {
            $($(#[$about])* $value,)+
        }

        impl $type {
            $(#[$about_name])*
            #[must_use]
            $vis const fn $of(self) -> &'static str {
                match self {
                    $(Self::$value => $name,)+
                }
            }
        }

        $(impl ::std::fmt::$shown for $type {
            fn fmt(&self, f: &mut ::std::fmt::Formatter<'_>) -> ::std::fmt::Result {
                f.write_str(self.$of())
            }
        })?
    };
}

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
#[cfg(any(feature = "serde", feature = "geo-types", feature = "mint", feature = "glam"))]
pub mod interop;
#[cfg(feature = "io")]
pub mod io;
#[cfg(feature = "navmesh")]
pub mod navmesh;
pub mod old_words;
pub mod plane;
#[cfg(feature = "play")]
pub mod play;
pub mod progress;
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
