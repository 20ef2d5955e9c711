//! The convex hull of points in space, exactly.
//!
//! ```text
//!                p                     p is new. The faces it sees go; what is left of the hull has a rim, the
//!              ╱ · ╲                   horizon, and each edge of it makes a new face with p.
//!            ╱  ·   ╲
//!      ────●   seen  ●────             Each point that is still outside knows one face that sees it. When that
//!     not    ╲ ──── ╱                  face goes, it looks for a new one among the faces at p; if none sees it,
//!     seen     ●──●    horizon         it is inside and forgotten.
//! ```
//!
//! Points come in random order, but in an order that keeps neighbours together within each half of the rest, so
//! that memory is near. Every decision is an exact sign; a point in the plane of a face does not see it. Degenerate
//! inputs therefore need no care: points in a face, on an edge, or given twice see nothing and drop out, and
//! triangles in one plane are found to be one face at the end.
//!
//! Source: Clarkson and Shor, *Applications of random sampling in computational geometry II*, 1989; one face for
//! each point as in Barber, Dobkin and Huhdanpaa, *The Quickhull algorithm*, 1996; the order from Amenta, Choi and
//! Rote, *Incremental constructions con BRIO*, 2003.
//!
//! ```text
//!   core.rs       Points that are inside for sure, found quickly
//!   facets.rs     The sides of a hull
//!   order.rs      The order in which points come
//!   simplex.rs    Four points to start from that do not lie in one plane
//!   triangles.rs  The hull while it grows
//! ```

mod core;
mod facets;
mod order;
mod simplex;
mod triangles;

use super::Polyhedron;
use crate::geometry::space::check_place;
use crate::ids::{MAX_IDS, VertexMap};
use crate::plane::CoordinateError;
use crate::topology::{NoObserver, Observer, TooMany};
use facets::Facets;
pub(super) use order::places;
use triangles::Triangles;

/// Why points have no convex hull that is a solid. Points are numbered from 0 in the order given.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum HullError {
    /// A coordinate that cannot be used.
    #[error("point {point}: {error}")]
    Coordinate {
        /// The point.
        point: u32,
        /// What is wrong with it.
        error: CoordinateError,
    },
    /// No point at all.
    #[error("there is no point: four are needed that do not lie in one plane")]
    NoPoint,
    /// All points are one.
    #[error("all {points} points are equal: four are needed that do not lie in one plane")]
    AllEqual {
        /// How many there are.
        points: usize,
    },
    /// All points lie on a line.
    #[error("all points lie on the line through points {} and {}: their hull is a segment, not a solid", through[0], through[1])]
    Collinear {
        /// Two different ones.
        through: [u32; 2],
    },
    /// All points lie in a plane.
    #[error("all points lie in the plane through points {}, {} and {}: their hull is a polygon; drop one coordinate and build it in the plane", through[0], through[1], through[2])]
    Coplanar {
        /// Three that do not lie on a line.
        through: [u32; 3],
    },
    /// More points than ids.
    #[error(transparent)]
    TooMany(#[from] TooMany),
}

/// What the faces of a hull are.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default)]
#[non_exhaustive]
pub enum HullFaces {
    /// Each face is a whole side of the hull: triangles in one plane are one polygon.
    #[default]
    Whole,
    /// Sides with more corners are cut into triangles, from their first corner.
    Triangles,
}

/// What the construction of a hull in space does. Points are numbered as they are given; triangles run counter-clockwise,
/// seen from outside.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum HullEvent {
    /// It begins with the tetrahedron of four points: its triangles.
    Tetrahedron([[u32; 3]; 4]),
    /// The next point sees no triangle: it is inside of the hull so far, or on it, or a corner already.
    Inside(u32),
    /// The next point sees triangles; they go, and each edge of the horizon makes a triangle with the point.
    Added {
        /// The point.
        point: u32,
        /// The triangles that it sees.
        seen: Vec<[u32; 3]>,
        /// The edges round them, as they run in the triangles that go.
        horizon: Vec<[u32; 2]>,
    },
}

/// The convex hull of points.
#[derive(Clone, PartialEq, Debug)]
pub struct Hull {
    /// The hull. Its vertices are the extreme points and no others: points on edges and in faces are left out.
    pub solid: Polyhedron,
    /// By vertex the number of its point; of equal points the one that was met first. Increasing.
    pub points: VertexMap<u32>,
}

impl Polyhedron {
    /// The convex hull of `points`, with all sides whole or cut into triangles. Vertices are numbered in the order
    /// of the points.
    ///
    /// Cost: expected O(n log n) time, whatever the points, and O(n) for points that fill a volume evenly; O(n) memory.
    ///
    /// # Errors
    /// [`HullError`] if the points do not span a solid.
    ///
    /// ```
    /// use dcel_kit::solid::{HullError, HullFaces, Polyhedron};
    /// // The corners of a cube, its middle, and the middle of one side.
    /// let mut points: Vec<_> = (0..8).map(|i| [i & 1, i >> 1 & 1, i >> 2].map(|x| 2.0 * f64::from(x))).collect();
    /// points.extend([[1.0, 1.0, 1.0], [1.0, 1.0, 2.0]]);
    /// let cube = Polyhedron::convex_hull(&points, HullFaces::Whole)?.solid;
    /// assert_eq!((cube.vertex_count(), cube.edge_count(), cube.face_count()), (8, 12, 6));
    /// let cut = Polyhedron::convex_hull(&points, HullFaces::Triangles)?.solid;
    /// assert_eq!((cut.vertex_count(), cut.edge_count(), cut.face_count()), (8, 18, 12));
    /// let flat = Polyhedron::convex_hull(&points[..4], HullFaces::Whole).unwrap_err();
    /// assert_eq!(flat, HullError::Coplanar { through: [0, 3, 1] });
    /// # Ok::<(), HullError>(())
    /// ```
    pub fn convex_hull(points: &[[f64; 3]], faces: HullFaces) -> Result<Hull, HullError> {
        Self::convex_hull_observed(points, faces, &mut NoObserver)
    }

    /// [`convex_hull`](Self::convex_hull), watched: the tetrahedron at the beginning, and each further point. The corners of
    /// the tetrahedron come once more, as points inside.
    ///
    /// # Errors
    /// [`HullError`] if the points do not span a solid.
    pub fn convex_hull_observed(
        points: &[[f64; 3]],
        faces: HullFaces,
        observer: &mut impl Observer<HullEvent>,
    ) -> Result<Hull, HullError> {
        if points.len() > MAX_IDS / 6 {
            return Err(TooMany.into());
        }
        for (point, &position) in (0..).zip(points) {
            check_place(position).map_err(|error| HullError::Coordinate { point, error })?;
        }
        let corners = simplex::spanning_points(points)?;
        let core = core::Core::new(points);
        let inside: Vec<bool> = core.map(|core| points.iter().map(|&p| core.contains(p)).collect()).unwrap_or_default();
        let is_left = |p: u32| !inside.get(p as usize).copied().unwrap_or(false);
        let mut hull = Triangles::simplex(points, corners, is_left);
        let [a, b, c, d] = corners;
        observer.observe(|| HullEvent::Tetrahedron([[a, b, c], [b, a, d], [c, b, d], [a, c, d]]));
        for p in (0..points.len() as u32).filter(|&p| !is_left(p)) {
            observer.observe(|| HullEvent::Inside(p));
        }
        order::order(points, is_left, |p| hull.add(p, observer));
        let facets = Facets::new(points, hull.triangles());
        let (sources, polygons) = facets.polygons(faces);
        let positions = sources.iter().map(|&p| points[p as usize]).collect();
        let solid = Self::from_polygons(positions, &polygons).expect("the sides of a hull fit together");
        Ok(Hull { solid, points: sources.into() })
    }
}
