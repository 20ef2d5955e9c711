//! Your part of the lab: from the neighbours of a triangle to a shortest path in a corridor.
//!
//! The tasks are numbered as in the handout, README.md. Replace each `todo!(…)` by code; the functions that help
//! are in `dcel.rs`, `turn.rs` and `map.rs`. `cargo test` says how far you are.

use crate::dcel::{Dcel, FaceId, Point};
use crate::map::Portal;
use crate::svg::Svg;
use crate::turn::{Turn, turn};
// What else you use can be named here.

/// Triangles and where they lead.
impl Dcel {
    /// Task 1. The triangles on the other side of the sides of the triangle `f`, counter-clockwise round it. It does
    /// not matter which comes first. Behind a wall there is none.
    pub fn neighbours(&self, f: FaceId) -> Vec<FaceId> {
        let _ = f;
        todo!("neighbours")
    }

    /// Task 2. A triangle with the point `p` in it, or on its border, found by looking at one after the other; `None`
    /// if `p` lies outside.
    pub fn locate_by_scan(&self, p: Point) -> Option<FaceId> {
        let _ = p;
        let _ = turn(p, p, p) == Turn::Straight;
        todo!("locate_by_scan")
    }

    /// Task 3. The same, found by walking from triangle to triangle, beginning at `from`.
    pub fn locate(&self, from: FaceId, p: Point) -> Option<FaceId> {
        let _ = (from, p);
        todo!("locate")
    }

    /// Task 4. Triangles from `start` to `goal`, both of them included, each the neighbour of the one before, as few as
    /// possible; `None` if no such sequence exists, or if one of the two is the outer face.
    pub fn corridor(&self, start: FaceId, goal: FaceId) -> Option<Vec<FaceId>> {
        let _ = (start, goal);
        todo!("corridor")
    }

    /// Task 5. The sides that one passes on the way through a corridor, in this order, each with its end on the left
    /// and its end on the right, as seen by one who goes through.
    pub fn portals(&self, corridor: &[FaceId]) -> Vec<Portal> {
        let _ = corridor;
        todo!("portals")
    }

    /// Task 7. A path from `start` to `goal`: the corners of the shortest one in a corridor; `None` if one of the two
    /// points is in no triangle, or if there is no corridor.
    pub fn path(&self, start: Point, goal: Point) -> Option<Vec<Point>> {
        let _ = (start, goal);
        todo!("path")
    }
    // Methods of your own can stand here.
}

/// Task 6. The shortest path from `start` to `goal` through portals, each given by its left and its right end: `start`,
/// then each point at which the path turns, then `goal`. Only `start` if the two are the same point.
pub fn funnel(start: Point, goal: Point, portals: &[(Point, Point)]) -> Vec<Point> {
    let _ = (start, goal, portals);
    todo!("funnel")
}
// Functions of your own can stand here.

/// Task 8. Draws a mesh with a path: a filled polygon for each triangle of the corridor, a line for each edge of the
/// mesh, a line for each piece of the path, a dot at each point of the path.
pub fn picture(mesh: &Dcel, start: Point, goal: Point, svg: &mut Svg) {
    let _ = (mesh, start, goal, svg);
    todo!("picture")
}
