//! Floors in space: hills, ramps, bridges, storeys over each other, and the shortest paths along them.
//!
//! ```text
//!            ┌─────────────────┐  layer 1        A surface of triangles that are joined by their edges in space. Seen
//!            │        ┌────────┘                 from above it may lie over itself: then it is split into layers,
//!        ramp│       ╱                           each of which does not.
//!   ┌────────│──────╱────┐
//!   └────────┴─────╱─────┘       layer 0         A point is found by x and y, and by a height or a layer where there
//!                                                are several.
//! ```
//!
//! Lengths are measured along the surface, up and down its slopes, and the exact path is the shortest of all paths on
//! the surface, not the shortest in the plan. The search never looks at layers: it goes from triangle to triangle by
//! shared edges, so a path may lead up a ramp, over a bridge and under it.
//!
//! ```text
//!                 ╱╲                             Triangle after triangle is unfolded into the plane of the one before:
//!     root ·─────╱──╲───────                     a straight line there is a straightest line on the surface. A window is
//!           ╲───╱─ · ╲──────                     the part of a side that a root sees so; where the surface has more
//!               window                           than a full turn round a vertex, or a border, a path may bend round it.
//! ```
//!
//! | file | what it does |
//! |---|---|
//! | `build.rs` | joins triangles by their edges; cuts polygons up; refuses what is no surface |
//! | `boxes.rs`, `layers.rs` | a tree of boxes; what lies over each other |
//! | `place.rs` | from x and y to places on the surface |
//! | `window.rs`, `search.rs` | windows, and the exact search over them |
//! | `corridor.rs`, `weighted_field.rs` | the quicker path algorithm; costs |
//! | `raycast.rs`, `random.rs` | the first border on a line that is straight in the plan; random places |
//! | `linked.rs` | teleports and lifts from place to place |
//! | `unfold.rs` | the shortest path through a row of triangles, back in space |
//!
//! What is a layer and where a point lies is decided by exact signs on the plan. Unfolding rounds: lengths are right to
//! about 1e-12 of their size, and every length that is told is that of a path on the surface. From and to points that are very
//! close to a vertex, but not on it, too: what is near is measured from there, so that it keeps its digits.
//!
//! Sources: Mitchell, Mount and Papadimitriou, *The discrete geodesic problem*, 1987; Chen and Han, *Shortest paths on a
//! polyhedron*, 1990, for "one angle, one split"; Xin and Wang, *Improving Chen and Han's algorithm on the discrete
//! geodesic problem*, 2009, for what is filtered out.
//!
//! ```text
//!   route.rs  What is found
//! ```

mod boxes;
mod build;
mod corridor;
mod layers;
mod linked;
mod place;
mod random;
mod raycast;
mod route;
mod search;
mod unfold;
mod weighted_field;
mod window;

pub use build::SurfaceError;
pub use linked::{LinkedSurfaceRoute, SurfaceLink};
pub use place::{Floor, SurfacePoint, SurfacePointError};
pub use random::RandomSurfacePlaces;
pub use raycast::{SurfaceRayHit, SurfaceRaycast};
pub use route::{SurfaceField, SurfaceRoute, SurfaceRouteError};
pub use search::SurfacePlanner;

use super::marks::NONE;
use crate::geometry::interval::range;
use crate::geometry::space::{between, cross, dot, length as norm, lerp, minus, normal};
use crate::ids::{FaceId, VertexId};
use boxes::Boxes;
use std::ops::Range;

/// A point in space; the third coordinate is the height.
pub(super) type Space = [f64; 3];

/// A surface of triangles in space to find paths on. The faces that it is made from may be any polygons; they keep their
/// numbers: polygon i is face i + 1, as in the plane.
#[derive(Clone, Debug)]
pub struct NavSurface {
    /// Where each node is: a vertex, or one of its fans where several touch in it.
    points: Vec<Space>,
    /// The vertex of each node.
    vertices: Vec<u32>,
    /// For each node a side that starts there: the first of its fan in clockwise order.
    first: Vec<u32>,
    /// For each node the angles round it, in sum.
    around: Vec<f64>,
    /// Whether each node is on a border.
    border: Vec<bool>,
    /// Three sides a triangle.
    sides: Vec<SideRecord>,
    /// For each triangle the number of its polygon.
    polygon: Vec<u32>,
    /// For each polygon its first triangle, and one more for the end; equal if it was left out.
    starts: Vec<u32>,
    /// For each polygon its layer and its component; `NONE` if it was left out.
    layer: Vec<u32>,
    component: Vec<u32>,
    layer_count: usize,
    component_count: usize,
    /// How much heights of one storey may differ.
    slack: f64,
    boxes: Boxes,
}

/// Side 3f + k of triangle f.
#[derive(Clone, Copy, Debug)]
struct SideRecord {
    /// The node it starts from.
    origin: u32,
    /// The same side of the triangle beyond, or `NONE`.
    twin: u32,
    length: f64,
    /// The angle of the triangle where the side starts.
    angle: f64,
    /// Where the third corner is, if the side lies on the x-axis from 0 on.
    apex: [f64; 2],
}

impl NavSurface {
    /// How many layers there are: 1 if the surface does not lie over itself.
    #[must_use]
    pub fn layer_count(&self) -> usize {
        self.layer_count
    }

    /// The layer of a face, from 0 for the lowest; `None` if it was left out or does not exist.
    #[must_use]
    pub fn layer(&self, f: FaceId) -> Option<usize> {
        Self::of_polygon(&self.layer, f).map(|layer| layer as usize)
    }

    /// The component of a face: faces with different ones cannot be reached from each other.
    #[must_use]
    pub fn component(&self, f: FaceId) -> Option<u32> {
        Self::of_polygon(&self.component, f)
    }

    fn of_polygon(values: &[u32], f: FaceId) -> Option<u32> {
        values.get(f.index().checked_sub(1)?).copied().filter(|&value| value != NONE)
    }

    /// How many components there are.
    #[must_use]
    pub fn component_count(&self) -> usize {
        self.component_count
    }

    /// The faces, in the order of their numbers; those that were left out are not among them.
    pub fn faces(&self) -> impl Iterator<Item = FaceId> + '_ {
        (1..=self.layer.len() as u32).map(FaceId::new).filter(|&f| self.layer(f).is_some())
    }

    /// One more than the greatest number of a face.
    #[must_use]
    pub fn face_bound(&self) -> usize {
        self.layer.len() + 1
    }

    /// How many triangles there are.
    #[must_use]
    pub fn triangle_count(&self) -> usize {
        self.polygon.len()
    }

    /// The sides of the triangles that a face was cut into, three for each.
    fn sides_of(&self, f: FaceId) -> Range<usize> {
        let polygon = f.index().checked_sub(1).filter(|&p| p < self.layer.len());
        polygon.map_or(0..0, |p| 3 * self.starts[p] as usize..3 * self.starts[p + 1] as usize)
    }

    /// The triangles that a face was cut into, by their corners.
    pub fn triangles(&self, f: FaceId) -> impl Iterator<Item = [Space; 3]> + '_ {
        self.sides_of(f).step_by(3).map(|s| self.corners(s / 3))
    }

    /// The vertices of a face and where they are; those of its cuts more than once.
    pub fn vertices(&self, f: FaceId) -> impl Iterator<Item = (VertexId, Space)> + '_ {
        let nodes = self.sides_of(f).map(|s| self.sides[s].origin as usize);
        nodes.map(|node| (VertexId::new(self.vertices[node]), self.points[node]))
    }

    /// The sides of a face that are no cuts, from point to point, and the face beyond each; none if it is a border.
    pub fn outline(&self, f: FaceId) -> impl Iterator<Item = ([Space; 2], Option<FaceId>)> + '_ {
        self.sides_of(f).filter_map(move |s| {
            let twin = Some(self.sides[s].twin).filter(|&twin| twin != NONE);
            let beyond = twin.map(|twin| self.face_of(twin as usize / 3));
            (beyond != Some(f)).then(|| (self.ends(s), beyond))
        })
    }

    /// The lowest and the greatest height.
    #[must_use]
    pub fn heights(&self) -> [f64; 2] {
        range(self.sides.iter().map(|side| self.points[side.origin as usize][2]))
    }

    /// The steepest slope, in degrees, and a face that has it.
    #[must_use]
    pub fn steepest(&self) -> Option<(f64, FaceId)> {
        let slopes = (0..self.triangle_count()).map(|t| (build::slope(self.corners(t)), self.face_of(t)));
        slopes.reduce(|most, next| if next.0 > most.0 { next } else { most })
    }

    /// The area, along the surface.
    #[must_use]
    pub fn area(&self) -> f64 {
        (0..self.triangle_count()).map(|t| norm(normal(self.corners(t))) / 2.0).sum()
    }

    /// Where vertex `v` is; `None` if no face has it. O(n).
    #[must_use]
    pub fn point(&self, v: VertexId) -> Option<Space> {
        self.vertices.iter().position(|&w| w == v.number()).map(|node| self.points[node])
    }

    fn corners(&self, t: usize) -> [Space; 3] {
        [0, 1, 2].map(|k| self.points[self.sides[3 * t + k].origin as usize])
    }

    fn face_of(&self, t: usize) -> FaceId {
        FaceId::new(self.polygon[t] + 1)
    }

    /// The ends of a side.
    fn ends(&self, s: usize) -> [Space; 2] {
        [s, next(s)].map(|s| self.points[self.sides[s].origin as usize])
    }

    /// The side that starts where side `s` does and is the next one counter-clockwise; `None` at a border.
    fn turn_left(&self, s: usize) -> Option<usize> {
        Some(self.sides[prev(s)].twin).filter(|&twin| twin != NONE).map(|twin| twin as usize)
    }

    /// The same clockwise.
    fn turn_right(&self, s: usize) -> Option<usize> {
        Some(self.sides[s].twin).filter(|&twin| twin != NONE).map(|twin| next(twin as usize))
    }

    /// The sides by which the triangles round a node are left, on the way from the one with side `from`, which leaves the
    /// node, to the one with side `to`.
    fn round(&self, from: usize, to: usize) -> Vec<usize> {
        let mut portals = Vec::new();
        let mut at = Some(from);
        while let Some(s) = at {
            if s == to {
                return portals;
            }
            portals.push(prev(s));
            at = self.turn_left(s).filter(|&s| s != from);
        }
        portals.clear();
        let mut at = from;
        while at != to {
            portals.push(at);
            match self.turn_right(at).filter(|&s| s != from) {
                Some(after) => at = after,
                None => return Vec::new(),
            }
        }
        portals
    }
}

/// The side that follows in the same triangle.
#[inline]
fn next(s: usize) -> usize {
    if s % 3 == 2 { s - 2 } else { s + 1 }
}

/// The side before in the same triangle.
#[inline]
fn prev(s: usize) -> usize {
    if s.is_multiple_of(3) { s + 2 } else { s - 1 }
}
