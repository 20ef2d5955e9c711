//! Paths over a map, drawn: one figure for each idea.
//!
//! ```text
//!   dual       which faces hang together          route    the corridor, its portals, the way
//!   dead_ends  what is peeled, and its way out     funnel   how the string is pulled, portal by portal
//!   apart      why there is no path                 cones    what the exact search looked at
//!   off_mesh   a start where nobody can stand
//!   clearance  the margin a wide agent keeps       ladder   every path algorithm beside the shortest path
//!   ray        what a straight line runs against    reach    how far everything is
//!   linked     a path over teleports and the like
//!   Storeys    a surface in space, a panel for each layer
//! ```
//!
//! Under each figure lies the map in grey, with its holes hatched. Roles are the same everywhere: blue is the path,
//! orange a portal, green the start, purple the goal.
//!
//! ```text
//!   links.rs    A path over links
//!   mesh.rs     What a navmesh knows before anybody asks for a way
//!   storeys.rs  Surfaces in space, drawn from above
//! ```

mod apart;
mod clearance;
mod cones;
mod funnel;
mod ladder;
mod links;
mod mesh;
mod off_mesh;
mod ray;
mod reach;
mod route;
mod storeys;

pub use storeys::Storeys;

use crate::figure::sketch::{Backdrop, Role, Sketch, SketchError};
use crate::figure::{Detail, FaceLabels, Figure, FigureOptions};
use crate::ids::FaceId;
use crate::navmesh::NavMesh;
use crate::plane::{Point, Subdivision};

/// With more edges than this, the map chooses its own level of detail.
const EDGES: usize = 2000;

/// With more portals than this, those of a corridor are left out: they would hide the path.
const DOORS: usize = 60;

/// A map and its navmesh, ready to be drawn.
///
/// ```
/// use dcel_kit::figure::{FigureOptions, navmesh::Floor};
/// use dcel_kit::{navmesh::NavMesh, plane::{Point, Subdivision}};
/// let points = [(0., 0.), (2., 0.), (2., 2.), (0., 2.)].map(Point::from).to_vec();
/// let map = Subdivision::from_triangles(points, &[[0, 1, 2], [0, 2, 3]])?;
/// let mesh = NavMesh::new(&map)?;
/// let svg = Floor::new(&map, &mesh).dual(&FigureOptions::new("Two triangles"))?.to_svg();
/// assert!(svg.contains("id=\"two-triangles-s-path-1\""));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Floor<'a> {
    map: &'a Subdivision,
    mesh: &'a NavMesh,
}

/// The heading of a panel, the words below it, and what it shows.
type Panel = (String, String, Sketch);

impl<'a> Floor<'a> {
    /// The mesh must be one of the map.
    #[must_use]
    pub fn new(map: &'a Subdivision, mesh: &'a NavMesh) -> Self {
        Self { map, mesh }
    }

    /// The corners of a face.
    fn ring(&self, f: FaceId) -> Vec<Point> {
        self.mesh.corners(f).map(|v| self.mesh.point(v)).collect()
    }

    /// A point inside a face: the mean of its corners, as faces are convex.
    fn middle(&self, f: FaceId) -> Point {
        let ring = self.ring(f);
        let share = 1.0 / ring.len() as f64;
        ring.iter().fold(Point::default(), |sum, p| Point::new(sum.x + share * p.x, sum.y + share * p.y))
    }

    /// Adds one region made of many faces; nothing if there are none.
    fn paint(&self, sketch: &mut Sketch, role: Role, faces: impl Iterator<Item = FaceId>, key: &str) {
        let rings: Vec<Vec<Point>> = faces.map(|f| self.ring(f)).collect();
        if !rings.is_empty() {
            sketch.region(role, rings).plain().key(key);
        }
    }

    /// The sketch, with the faces that were blocked, over the map in grey.
    fn over(&self, mut sketch: Sketch, options: &FigureOptions) -> Result<Figure, SketchError> {
        self.blocked(&mut sketch);
        sketch.over(self.map, Backdrop::Dimmed, &self.quiet(options))
    }

    /// Options with which the map stays in the background: all faces in one grey, so that what is painted over them is
    /// seen.
    fn quiet(&self, options: &FigureOptions) -> FigureOptions {
        let quiet = options.clone().quiet();
        if self.map.edge_count() <= EDGES { quiet.detail(Detail::Edges) } else { quiet }
    }

    /// The same without the names of the faces.
    fn nameless(&self, options: &FigureOptions) -> FigureOptions {
        self.quiet(options).face_labels(FaceLabels::Off)
    }
}
