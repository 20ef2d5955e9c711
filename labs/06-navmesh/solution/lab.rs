//! Your part of the lab: from the neighbours of a triangle to a shortest path in a corridor.
//!
//! The tasks are numbered as in the handout, README.md. Replace each `todo!(…)` by code; the functions that help
//! are in `dcel.rs`, `turn.rs` and `map.rs`. `cargo test` says how far you are.

use crate::dcel::{Dcel, FaceId, Point};
use crate::map::Portal;
use crate::svg::Svg;
use crate::turn::{Turn, turn};
// BEGIN SOLUTION
// STARTER: // What else you use can be named here.
use crate::dcel::HalfEdgeId;
use std::collections::VecDeque;
// END SOLUTION

/// Triangles and where they lead.
impl Dcel {
    /// Task 1. The triangles on the other side of the sides of the triangle `f`, counter-clockwise round it. It does
    /// not matter which comes first. Behind a wall there is none.
    pub fn neighbours(&self, f: FaceId) -> Vec<FaceId> {
        // BEGIN SOLUTION
        // STARTER: let _ = f;
        // STARTER: todo!("neighbours")
        let first = self.incident_half_edge(f);
        let mut neighbours = Vec::new();
        let mut side = first;
        loop {
            let across = self.face(self.twin(side));
            if across != self.outer_face {
                neighbours.push(across);
            }
            side = self.next(side);
            if side == first {
                return neighbours;
            }
        }
        // END SOLUTION
    }

    /// Task 2. A triangle with the point `p` in it, or on its border, found by looking at one after the other; `None`
    /// if `p` lies outside.
    pub fn locate_by_scan(&self, p: Point) -> Option<FaceId> {
        // BEGIN SOLUTION
        // STARTER: let _ = p;
        // STARTER: let _ = turn(p, p, p) == Turn::Straight;
        // STARTER: todo!("locate_by_scan")
        for f in 0..self.faces.len() {
            if f != self.outer_face && self.side_before(f, p).is_none() {
                return Some(f);
            }
        }
        None
        // END SOLUTION
    }

    /// Task 3. The same, found by walking from triangle to triangle, beginning at `from`.
    pub fn locate(&self, from: FaceId, p: Point) -> Option<FaceId> {
        // BEGIN SOLUTION
        // STARTER: let _ = (from, p);
        // STARTER: todo!("locate")
        let mut f = from;
        loop {
            let Some(side) = self.side_before(f, p) else { return Some(f) };
            f = self.face(self.twin(side));
            if f == self.outer_face {
                // A wall bars the way. The point may still be in a triangle beyond.
                return self.locate_by_scan(p);
            }
        }
        // END SOLUTION
    }

    /// Task 4. Triangles from `start` to `goal`, both of them included, each the neighbour of the one before, as few as
    /// possible; `None` if no such sequence exists, or if one of the two is the outer face.
    pub fn corridor(&self, start: FaceId, goal: FaceId) -> Option<Vec<FaceId>> {
        // BEGIN SOLUTION
        // STARTER: let _ = (start, goal);
        // STARTER: todo!("corridor")
        if start == self.outer_face || goal == self.outer_face {
            return None;
        }
        let mut before = vec![None; self.faces.len()];
        let mut queue = VecDeque::from([start]);
        before[start] = Some(start);
        while let Some(f) = queue.pop_front() {
            if f == goal {
                break;
            }
            for g in self.neighbours(f) {
                if before[g].is_none() {
                    before[g] = Some(f);
                    queue.push_back(g);
                }
            }
        }
        let mut corridor = vec![goal];
        let mut f = goal;
        while f != start {
            f = before[f]?;
            corridor.push(f);
        }
        corridor.reverse();
        Some(corridor)
        // END SOLUTION
    }

    /// Task 5. The sides that one passes on the way through a corridor, in this order, each with its end on the left
    /// and its end on the right, as seen by one who goes through.
    pub fn portals(&self, corridor: &[FaceId]) -> Vec<Portal> {
        // BEGIN SOLUTION
        // STARTER: let _ = corridor;
        // STARTER: todo!("portals")
        let mut portals = Vec::new();
        for pair in corridor.windows(2) {
            let mut side = self.incident_half_edge(pair[0]);
            while self.face(self.twin(side)) != pair[1] {
                side = self.next(side);
            }
            let left = self.origin(self.twin(side));
            let right = self.origin(side);
            portals.push(Portal { left, right });
        }
        portals
        // END SOLUTION
    }

    /// Task 7. A path from `start` to `goal`: the corners of the shortest one in a corridor; `None` if one of the two
    /// points is in no triangle, or if there is no corridor.
    pub fn path(&self, start: Point, goal: Point) -> Option<Vec<Point>> {
        // BEGIN SOLUTION
        // STARTER: let _ = (start, goal);
        // STARTER: todo!("path")
        let from = self.locate_by_scan(start)?;
        let to = self.locate_by_scan(goal)?;
        let corridor = self.corridor(from, to)?;
        let mut portals = Vec::new();
        for portal in self.portals(&corridor) {
            portals.push((self.position(portal.left), self.position(portal.right)));
        }
        Some(funnel(start, goal, &portals))
        // END SOLUTION
    }
    // BEGIN SOLUTION
    // STARTER: // Methods of your own can stand here.

    /// A side of the triangle `f` that has `p` strictly on its right; `None` if `p` is in the triangle.
    fn side_before(&self, f: FaceId, p: Point) -> Option<HalfEdgeId> {
        let mut side = self.incident_half_edge(f);
        for _ in 0..3 {
            let next = self.next(side);
            let [a, b] = [side, next].map(|h| self.position(self.origin(h)));
            if turn(a, b, p) == Turn::Right {
                return Some(side);
            }
            side = next;
        }
        None
    }
    // END SOLUTION
}

/// Task 6. The shortest path from `start` to `goal` through portals, each given by its left and its right end: `start`,
/// then each point at which the path turns, then `goal`. Only `start` if the two are the same point.
pub fn funnel(start: Point, goal: Point, portals: &[(Point, Point)]) -> Vec<Point> {
    // BEGIN SOLUTION
    // STARTER: let _ = (start, goal, portals);
    // STARTER: todo!("funnel")
    // The path so far; its last point is the apex. From there, the chains to the ends of the last portal.
    let mut path = vec![start];
    let (mut left, mut right) = (VecDeque::new(), VecDeque::new());
    for &(l, r) in portals {
        extend(&mut path, &mut left, &mut right, l, Turn::Left);
        extend(&mut path, &mut right, &mut left, r, Turn::Right);
    }
    extend(&mut path, &mut left, &mut right, goal, Turn::Left);
    path.extend(left);
    path.dedup();
    path
    // END SOLUTION
}
// BEGIN SOLUTION
// STARTER: // Functions of your own can stand here.

/// Leads the chain `mine`, which bends to the side `bend`, to the new end `p` of the portal; `other` bends the other way.
fn extend(path: &mut Vec<Point>, mine: &mut VecDeque<Point>, other: &mut VecDeque<Point>, p: Point, bend: Turn) {
    let mut apex = path[path.len() - 1];
    while let Some(&last) = mine.back() {
        let before = if mine.len() > 1 { mine[mine.len() - 2] } else { apex };
        if turn(before, last, p) == bend {
            mine.push_back(p);
            return;
        }
        mine.pop_back();
    }
    // The chain is straight now. Does it have to go round the other one?
    let across = if bend == Turn::Left { Turn::Right } else { Turn::Left };
    while let Some(&first) = other.front() {
        if turn(apex, first, p) != across {
            break;
        }
        path.push(first);
        apex = first;
        other.pop_front();
    }
    mine.push_back(p);
}
// END SOLUTION

/// Task 8. Draws a mesh with a path: a filled polygon for each triangle of the corridor, a line for each edge of the
/// mesh, a line for each piece of the path, a dot at each point of the path.
pub fn picture(mesh: &Dcel, start: Point, goal: Point, svg: &mut Svg) {
    // BEGIN SOLUTION
    // STARTER: let _ = (mesh, start, goal, svg);
    // STARTER: todo!("picture")
    let [from, to] = [start, goal].map(|p| mesh.locate_by_scan(p).unwrap());
    for f in mesh.corridor(from, to).unwrap() {
        let first = mesh.incident_half_edge(f);
        let sides = [first, mesh.next(first), mesh.prev(first)];
        svg.polygon(&sides.map(|h| mesh.position(mesh.origin(h))));
    }
    for h in 0..mesh.half_edges.len() {
        let twin = mesh.twin(h);
        if h < twin {
            svg.line(mesh.position(mesh.origin(h)), mesh.position(mesh.origin(twin)));
        }
    }
    let path = mesh.path(start, goal).unwrap();
    for pair in path.windows(2) {
        svg.line(pair[0], pair[1]);
    }
    for &p in &path {
        svg.dot(p);
    }
    // END SOLUTION
}
