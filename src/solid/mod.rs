//! Half-edge structures in space: a surface of polygons with positions.
//!
//! ```text
//!        ●───────●        every polygon is a face, counter-clockwise as seen from outside;
//!       ╱ f1    ╱│        where the surface ends, each border cycle has a *boundary face*, which is
//!      ●───────● │        no part of the surface but lets every half-edge have a face
//!      │  f0   │f2
//!      │       │ ●
//!      ●───────●╱
//! ```
//!
//! A surface may pass through itself, and its faces need not be flat. Where coordinates decide (is it convex? what is
//! the hull? which vertex is furthest?), the decision is exact.
//!
//! | task | types |
//! |---|---|
//! | a surface, to walk and to ask | [`Polyhedron`] |
//! | make one | [`Polyhedron::from_polygons`], [`Platonic`], [`Archimedean`], [`Hull`], [`grow`] |
//! | edit it, watch the edit, take it back | [`Polyhedron::bevel_vertex`] and its like; [`SurfaceRecorder`], [`SurfaceJournal`] |
//! | make it finer, or its dual | [`Subdivided`], [`Dual`], [`Selection`] |
//! | measure | [`Polyhedron::area`], [`Polyhedron::signed_volume`], [`Measures`] |
//! | ask about its shape | [`Convex`], [`FaceFault`] |
//! | find the furthest vertex | [`Convex`], [`SupportMap`] |
//! | lay it flat, write its tables | [`Schlegel`], [`WingedEdges`] |
//!
//! With the feature `parallel`, threads share the steps of [subdivision](Polyhedron::catmull_clark); the surface is the same with
//! any number of them.

// The files of this folder:
//
//   dynamic/    add_face, remove_face, add_vertex,            surface_journal.rs  watching them, undo
//               remove_vertex, collapse_edge
//   parts.rs    what a surface is made of
//   local/      split, flip, bevel, inset, extrude; points move
//   predicates.rs  exact signs in space                   vector.rs           arithmetic of measures
//   selection.rs  marks on elements
//   measure.rs  counts, area, volume                          flat.rs convex.rs wings.rs  exact questions about shape
//   angles.rs   angles and curvatures
//   hull/       the convex hull of points                     support.rs          the furthest vertex, by climbing
//                                                             support_map.rs      the same, prepared
//   grow/       shapes out of rings and the torus seed        subdivide/          finer surfaces
//   platonic.rs archimedean.rs  solids to start from          dual.rs derived.rs wythoff.rs  solids from solids
//   handles.rs  a curve that does not cut the surface         winged.rs           tables of the slides
//   schlegel.rs seen through a face, in the plane

mod angles;
mod archimedean;
mod convex;
mod derived;
mod dual;
mod dynamic;
mod flat;
pub mod grow;
mod handles;
mod hull;
mod local;
mod measure;
mod parts;
mod platonic;
pub mod predicates;
mod schlegel;
mod selection;
mod subdivide;
mod support;
mod support_map;
mod surface_journal;
pub(crate) mod vector;
mod winged;
mod wings;
mod wythoff;

use crate::geometry::space::check_place;
use crate::ids::{FaceId, VertexId, VertexMap};
use crate::plane::CoordinateError;
use crate::topology::{BuildError, Dcel, NoRecorder, OneSided, PolygonList, View, faces_to_turn};
use std::collections::BTreeSet;

pub use angles::Measures;
pub use archimedean::Archimedean;
pub use convex::{Convex, NotConvex};
pub use derived::TruncateError;
pub use dual::{Dual, DualError, DualPositions};
pub use dynamic::{AddFaceError, AddVertexError, CollapseError, RemoveFaceError, RemoveVertexError};
pub use flat::FaceFault;
pub use hull::{Hull, HullError, HullEvent, HullFaces};
pub use local::{BevelEdgeError, BevelVertexError, PlaceError, RimError, SpaceTransformError, SurfaceEditError};
pub use measure::PartCounts;
pub use parts::PartsError;
pub use platonic::Platonic;
pub use schlegel::{Schlegel, SchlegelError};
pub use selection::Selection;
pub use subdivide::{SubdivideError, SubdivideEvent, Subdivided};
pub use support::{ClimbEvent, Direction};
pub use support_map::SupportMap;
pub use surface_journal::{SurfaceChange, SurfaceJournal, SurfaceRecorder};
pub use winged::WingedEdges;
pub use wythoff::{FlagWeights, Hand};

/// Why points and polygons are no surface. Faces and vertices are numbered from 0 in the order of the input.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SolidError {
    /// The polygons do not fit together.
    #[error(transparent)]
    Build(BuildError),
    /// Two faces, and no third, run along an edge in the same direction, and turning faces round helps.
    #[error("faces {first} and {second} both run from vertex {u} to vertex {v}: reverse {}", to_reverse(*turn, *turns))]
    Winding {
        /// Where both run from.
        u: u32,
        /// Where both run to.
        v: u32,
        /// The earlier face.
        first: u32,
        /// The later one.
        second: u32,
        /// The one of them to turn, so that as few as possible are turned.
        turn: u32,
        /// How many faces of the whole surface are to be turned.
        turns: usize,
    },
    /// No turning helps.
    #[error(transparent)]
    OneSided(#[from] OneSided),
    /// A vertex whose coordinates cannot be used.
    #[error("vertex {vertex}: {error}")]
    Coordinate {
        /// The vertex.
        vertex: u32,
        /// What is wrong with it.
        error: CoordinateError,
    },
}

fn to_reverse(turn: u32, turns: usize) -> String {
    match turns {
        1 => format!("face {turn}"),
        _ => format!("face {turn} ({turns} faces in all)"),
    }
}

impl SolidError {
    /// The builder's error, with more to say about faces that are wound the wrong way round.
    fn of_building(error: BuildError, polygons: &PolygonList) -> Self {
        let BuildError::MixedWinding { u, v, first, second } = error else { return Self::Build(error) };
        match faces_to_turn(polygons) {
            Ok(faces) => {
                let turn = if faces.binary_search(&second).is_ok() { second } else { first };
                Self::Winding { u, v, first, second, turn, turns: faces.len() }
            }
            Err(one_sided) => one_sided.into(),
        }
    }

    /// The faces the message speaks of, for callers who know where in a file they stand.
    #[must_use]
    pub fn faces(&self) -> Vec<u32> {
        match self {
            Self::Build(error) => error.faces(),
            Self::Winding { first, second, .. } => vec![*first, *second],
            Self::OneSided(error) => error.band.clone(),
            Self::Coordinate { .. } => Vec::new(),
        }
    }

    /// The vertices the message speaks of.
    #[must_use]
    pub fn vertices(&self) -> Vec<u32> {
        match self {
            Self::Build(error) => error.vertices(),
            Self::Winding { u, v, .. } => vec![*u, *v],
            Self::OneSided(_) => Vec::new(),
            Self::Coordinate { vertex, .. } => vec![*vertex],
        }
    }
}

/// A surface in space, closed or with borders.
///
/// It has the walks and counts of a [`Dcel`], and edits of its own. Edits that only the kernel has are no methods of it;
/// [`topology`](Self::topology) gives the structure to all that reads one.
///
/// ```compile_fail,E0599
/// use dcel_kit::{HalfEdgeId, solid::{Platonic, Polyhedron}};
/// let mut cube = Polyhedron::platonic(Platonic::Cube);
/// let _ = cube.split_vertex(HalfEdgeId::new(0), HalfEdgeId::new(0)); // where would the new vertex be?
/// ```
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Polyhedron {
    dcel: Dcel,
    points: VertexMap<[f64; 3]>,
    boundary_faces: BTreeSet<FaceId>,
}

impl Polyhedron {
    crate::topology::reads_of_dcel!(dcel);

    /// A surface without any element, to be grown with [`add_vertex`](Self::add_vertex) and
    /// [`add_face`](Self::add_face).
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// The surface of a list of polygons.
    ///
    /// Vertex i is v(i), polygon i is f(i), boundary faces follow; see [`Dcel::from_polygons`]. Points that no
    /// polygon uses get no vertex: their ids are left free.
    ///
    /// Cost: O(points + corners).
    ///
    /// # Errors
    /// [`SolidError`] names the faces and vertices that do not fit.
    ///
    /// ```
    /// use dcel_kit::{solid::Polyhedron, topology::{PolygonList, measure}};
    /// let corners = vec![[0., 0., 0.], [1., 0., 0.], [0., 1., 0.], [0., 0., 1.]];
    /// let faces = PolygonList::from_triangles(&[[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    /// let tetrahedron = Polyhedron::from_polygons(corners, &faces)?;
    /// assert_eq!((tetrahedron.edge_count(), measure(&tetrahedron).closed_euler()), (6, 2));
    /// # Ok::<(), dcel_kit::solid::SolidError>(())
    /// ```
    pub fn from_polygons(points: Vec<[f64; 3]>, polygons: &PolygonList) -> Result<Self, SolidError> {
        for (vertex, &point) in (0..).zip(&points) {
            check_place(point).map_err(|error| SolidError::Coordinate { vertex, error })?;
        }
        let built =
            Dcel::from_polygons(points.len(), polygons).map_err(|error| SolidError::of_building(error, polygons))?;
        let mut dcel = built.dcel;
        // From the last one on, so that the lowest free id is given out first.
        let unused: Vec<VertexId> = dcel.vertices().rev().filter(|&v| dcel.outgoing(v).is_none()).collect();
        for v in unused {
            dcel.remove_vertex_record(v, &mut NoRecorder);
        }
        Ok(Self { dcel, points: points.into(), boundary_faces: built.boundary_faces.into_iter().collect() })
    }

    /// A surface from its parts, which must fit together: a position for each vertex up to the bound.
    fn assembled(dcel: Dcel, points: VertexMap<[f64; 3]>, boundary_faces: BTreeSet<FaceId>) -> Self {
        Self { dcel, points, boundary_faces }
    }

    /// The same as [`from_polygons`](Self::from_polygons) after turning round the faces that are wound against the
    /// rest, as few as possible in each connected piece. Returns the numbers of those faces, too. Whether a closed
    /// surface is inside out is not looked at; see [`signed_volume`](Self::signed_volume).
    ///
    /// Cost: O(n log n) for n corners.
    ///
    /// # Errors
    /// [`SolidError`]; a surface with one side is refused with a Moebius strip in it.
    pub fn from_polygons_oriented(
        points: Vec<[f64; 3]>,
        mut polygons: PolygonList,
    ) -> Result<(Self, Vec<u32>), SolidError> {
        let turned = faces_to_turn(&polygons)?;
        for &face in &turned {
            for cycle in polygons.cycle_range(face as usize) {
                polygons.cycle_mut(cycle).reverse();
            }
        }
        Ok((Self::from_polygons(points, &polygons)?, turned))
    }

    /// The structure without its positions.
    #[must_use]
    pub fn topology(&self) -> &Dcel {
        &self.dcel
    }

    /// Where `v` is. O(1).
    ///
    /// # Panics
    /// If `v` was never allocated: `there is no v99: there are 8 vertices`.
    #[must_use]
    #[inline]
    #[track_caller]
    pub fn point(&self, v: VertexId) -> [f64; 3] {
        match self.points.get(v) {
            Some(&point) => {
                self.dcel.debug_assert_not_removed(v);
                point
            }
            None => self.dcel.no_such(v),
        }
    }

    /// Whether `f` stands for a border of the surface and is no polygon of it.
    #[must_use]
    #[track_caller]
    pub fn is_boundary_face(&self, f: FaceId) -> bool {
        self.dcel.debug_assert_not_removed(f);
        self.boundary_faces.contains(&f)
    }

    /// The boundary faces in the order of their numbers.
    pub fn boundary_faces(&self) -> impl ExactSizeIterator<Item = FaceId> + '_ {
        self.boundary_faces.iter().copied()
    }
}

impl View for Polyhedron {
    crate::topology::pointers_of_dcel!(dcel);
}
