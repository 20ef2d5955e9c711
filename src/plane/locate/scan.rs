//! The plain look at everything.
//!
//! ```text
//!      ●────────● e1          Of the edges below p the highest tells the face: it lies above that edge.
//!          · p
//!    ●────────────● e0        Edges end just before their right ends, so that one of two that meet is below.
//! ```

use super::order::{Ends, is_above};
use super::{Location, is_beyond};
use crate::geometry::predicates::{left_to_right, orientation};
use crate::plane::{Point, Subdivision};
use std::cmp::Ordering;

impl Subdivision {
    /// [`locate`](Self::locate) by a look at all vertices and edges: the simplest way to be right.
    ///
    /// Cost: O(V + E); exact.
    #[must_use]
    pub fn locate_by_scan(&self, p: Point) -> Location {
        if is_beyond(p) {
            return Location::Face(self.outer_face());
        }
        if let Some(v) = self.dcel.vertices().find(|&v| self.points[v] == p) {
            return Location::Vertex(v);
        }
        let mut highest: Option<Ends> = None;
        let mut below = None;
        for e in self.dcel.edges() {
            let h = self.upper_half(e);
            let [a, b] = [self.dcel.origin(h), self.dcel.destination(h)].map(|v| self.points[v]);
            if left_to_right(a, p).is_ge() || left_to_right(p, b).is_ge() {
                continue;
            }
            match orientation(a, b, p) {
                Ordering::Equal => return Location::Edge(h),
                Ordering::Less => {}
                Ordering::Greater => {
                    if highest.is_none_or(|edge| is_above([a, b], edge)) {
                        (highest, below) = (Some([a, b]), Some(h));
                    }
                }
            }
        }
        Location::Face(below.map_or(self.outer_face(), |h| self.dcel.face(h)))
    }
}
