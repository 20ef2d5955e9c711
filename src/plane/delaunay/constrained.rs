//! The constrained Delaunay triangulation: the edges of a subdivision stay, everything between them is Delaunay.
//!
//! ```text
//!          ●───●                    First all vertices are triangulated. Then every edge u-w that is missing is
//!        ╱ │ ╲ │ ╲                  made: of the edges across it, one between two triangles that form a convex
//!    u ●┄┄┄│┄┄┄│┄┄┄● w              quadrilateral is flipped, again and again, until none is left. At the end flips
//!        ╲ │ ╱ │ ╱                  make all the others locally Delaunay.
//!          ●───●
//! ```
//!
//! Source: Sloan, *A fast algorithm for generating constrained Delaunay triangulations*, 1993.

use super::{Subdivision, assembled, divide_and_conquer, ordered, stage};
use crate::geometry::predicates::orientation;
use crate::ids::{EdgeId, EdgeMap, FaceId, FaceMap, HalfEdgeId, VertexId};
use crate::plane::Point;
use crate::topology::{NoObserver, NoRecorder, TooMany};
use std::cmp::Ordering;
use std::collections::BTreeSet;

/// A constrained Delaunay triangulation of a subdivision.
#[derive(Clone, PartialEq, Debug)]
pub struct ConstrainedDelaunay {
    /// The triangulation of the convex hull. Vertices keep their numbers; a triangle is a hole face if it lies in a
    /// hole face or in the outer face of the subdivision.
    pub subdivision: Subdivision,
    /// Whether the edge is one of the subdivision.
    pub constrained: EdgeMap<bool>,
    /// The face of the subdivision in which each triangle lies; `f0` for `f0`.
    pub faces: FaceMap<FaceId>,
}

/// What came of looking for an edge.
enum Found {
    Edge(HalfEdgeId),
    /// There is none; this end has the fewer edges.
    NoneAt(VertexId),
}

impl Subdivision {
    /// The constrained Delaunay triangulation of all vertices of a subdivision, in which all its edges stay.
    ///
    /// Every other edge is locally Delaunay. Dangling edges, inner components and isolated vertices are all taken in. If all vertices
    /// lie on one line the result is a path.
    ///
    /// Cost: O(n log n); for each edge that is not Delaunay itself, besides, O(log k) for each flip of the k edges
    /// across it, mostly about k flips and never more than O(k²), and the smaller degree of its two ends. Where n long
    /// edges stand side by side with points between them, each can have O(n) edges across: O(n² log n) then in all. All
    /// decisions are exact.
    ///
    /// # Errors
    /// [`TooMany`]: more triangles than there are ids.
    ///
    /// ```
    /// use dcel_kit::plane::{Point, Subdivision};
    /// let points = [(0., 0.), (3., -1.), (6., 0.), (3., 1.)].map(Point::from);
    /// let graph = Subdivision::from_graph(&points, &[[0, 2]])?;
    /// let kite = graph.constrained_delaunay()?;
    /// assert_eq!(kite.constrained.iter().filter(|(_, constrained)| **constrained).count(), 1);
    /// assert_eq!(kite.subdivision.non_delaunay_edges(|_| false).count(), 1);
    /// assert_eq!(kite.subdivision.non_delaunay_edges(|e| kite.constrained[e]).count(), 0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn constrained_delaunay(&self) -> Result<ConstrainedDelaunay, TooMany> {
        self.constrained_halves().map(|(made, _)| made)
    }

    /// The constrained Delaunay triangulation, and for each edge of this subdivision a half in the triangulation and
    /// the half here that runs the same way.
    pub(in crate::plane) fn constrained_halves(
        &self,
    ) -> Result<(ConstrainedDelaunay, Vec<(HalfEdgeId, HalfEdgeId)>), TooMany> {
        if self.dcel.vertex_bound() > crate::ids::MAX_IDS / 6 {
            return Err(TooMany);
        }
        let live: Vec<VertexId> = self.dcel.vertices().collect();
        let points: Vec<Point> = live.iter().map(|&v| self.points[v]).collect();
        let order = ordered(&points);
        let names: Vec<u32> = order.sites.iter().map(|site| live[site.index as usize].number()).collect();
        let mut made = assembled(divide_and_conquer(&order, &stage(&order)), &names, self.points.clone());
        // From the last one on, so that the lowest free number is given out first.
        let dead: Vec<VertexId> = made.dcel.vertices().rev().filter(|&v| !self.dcel.has_vertex(v)).collect();
        dead.into_iter().for_each(|v| made.dcel.remove_vertex_record(v, &mut NoRecorder));

        let mut constrained = EdgeMap::filled(made.dcel.edge_bound(), false);
        let mut faces = vec![None; made.dcel.face_bound()];
        let mut marked = Vec::new();
        // All is Delaunay but what flips change.
        let mut changed = vec![false; made.dcel.edge_bound()];
        for e in self.dcel.edges() {
            let [u, w] = e.half_edges().map(|h| self.dcel.origin(h));
            let Some(h) = made.force_edge(u, w, &mut changed) else { continue };
            constrained[h.edge()] = true;
            marked.push((h, e.half_edges()[0]));
        }
        made.flip_all(|e| constrained[e], changed, &mut NoRecorder, &mut NoObserver);
        for &(h, g) in &marked {
            faces[made.dcel.face(h).index()] = Some(self.dcel.face(g));
            faces[made.dcel.face(h.twin()).index()] = Some(self.dcel.face(g.twin()));
        }
        let faces = made.spread_faces(faces);
        made.holes = made.dcel.faces().filter(|&f| faces[f] == self.outer_face() || self.is_hole(faces[f])).collect();
        made.holes.remove(&self.outer_face());
        Ok((ConstrainedDelaunay { subdivision: made, constrained, faces }, marked))
    }

    /// Makes the edge from `u` to `w` by flips, in a triangulation of the convex hull with no vertex between the two
    /// and no fixed edge across. Returns its half from `u` to `w`; marks the edges of triangles that flips change.
    fn force_edge(&mut self, u: VertexId, w: VertexId, changed: &mut [bool]) -> Option<HalfEdgeId> {
        let across = match self.find_edge(u, w) {
            Found::Edge(h) => return Some(h),
            Found::NoneAt(end) if end == u => self.edges_across(u, w),
            Found::NoneAt(_) => self.edges_across(w, u).into_iter().rev().collect(),
        };
        self.flip_across(u, w, &across, changed).0
    }

    /// Flips the edges `across` the segment from `u` to `w`, which are all of them in its order, until none is left.
    /// Returns the half from `u` to `w`, and how many times it looked at a quadrilateral: at most once for each of
    /// these edges and three times for each flip.
    ///
    /// It goes round and round through the edges that are left, as Sloan does, but passes over those whose
    /// quadrilateral was not convex and is still the same: a flip changes that of the edge, and those of the edges
    /// before and after it.
    fn flip_across(
        &mut self,
        u: VertexId,
        w: VertexId,
        across: &[EdgeId],
        changed: &mut [bool],
    ) -> (Option<HalfEdgeId>, usize) {
        let ends = [u, w].map(|v| self.points[v]);
        let side = |s: &Self, v: VertexId| orientation(ends[0], ends[1], s.points[v]);
        // By their places in `across`: what is left, and what is to be looked at.
        let mut left: BTreeSet<usize> = (0..across.len()).collect();
        let mut due = left.clone();
        let (mut made, mut looks, mut at) = (None, 0, 0);
        while let Some(i) = due.range(at..).next().or_else(|| due.first()).copied() {
            due.remove(&i);
            at = i + 1;
            looks += 1;
            let h = across[i].half_edges()[0];
            let ([a, b], [c, d]) = (self.ends(h), self.opposite(h));
            let turns = |v: VertexId| orientation(self.points[c], self.points[d], self.points[v]);
            // Convex if the other diagonal parts the ends strictly.
            if turns(a).is_eq() || turns(b).is_eq() || turns(a) == turns(b) {
                continue;
            }
            self.dcel.flip_edge_unchecked(h, &mut NoRecorder);
            let beside = |h: HalfEdgeId| [h, self.dcel.next(h), self.dcel.prev(h)];
            [h, h.twin()].into_iter().flat_map(beside).for_each(|h| changed[h.edge().index()] = true);
            if side(self, c).reverse() == side(self, d) && side(self, c).is_ne() {
                due.insert(i);
            } else {
                left.remove(&i);
                if [c, d] == [u, w] || [d, c] == [u, w] {
                    made = Some(h);
                }
            }
            due.extend(left.range(..i).next_back());
            due.extend(left.range(at..).next());
        }
        (made.map(|h| if self.dcel.origin(h) == u { h } else { h.twin() }), looks)
    }

    /// The half-edge from `u` to `w`, sought round both at once, so that a hub with many edges costs no more than the
    /// vertex at the other end. O(the smaller degree): over all edges of a plane graph that is O(n).
    ///
    /// Source: Chiba and Nishizeki, *Arboricity and subgraph listing algorithms*, SIAM J. Comput. 14, 1985.
    fn find_edge(&self, u: VertexId, w: VertexId) -> Found {
        let (mut at_u, mut at_w) = (self.dcel.outgoing_half_edges(u), self.dcel.outgoing_half_edges(w));
        loop {
            match at_u.next() {
                None => return Found::NoneAt(u),
                Some(h) if self.dcel.destination(h) == w => return Found::Edge(h),
                Some(_) => {}
            }
            match at_w.next() {
                None => return Found::NoneAt(w),
                Some(g) if self.dcel.destination(g) == u => return Found::Edge(g.twin()),
                Some(_) => {}
            }
        }
    }

    fn ends(&self, h: HalfEdgeId) -> [VertexId; 2] {
        [self.dcel.origin(h), self.dcel.destination(h)]
    }

    /// The third corners of the triangles at `h`: on its left and on its right.
    fn opposite(&self, h: HalfEdgeId) -> [VertexId; 2] {
        [h, h.twin()].map(|h| self.dcel.origin(self.dcel.prev(h)))
    }

    /// The edges that the segment from `u` to `w` crosses, in its order. O(degree of u + number of edges).
    fn edges_across(&self, u: VertexId, w: VertexId) -> Vec<EdgeId> {
        let (from, to) = (self.points[u], self.points[w]);
        let side = |v: VertexId| orientation(from, to, self.points[v]);
        // The triangle at u that the segment enters: its second corner lies on the right, its third on the left.
        let enters = |&h: &HalfEdgeId| {
            let (right, left) = (self.dcel.destination(h), self.dcel.origin(self.dcel.prev(h)));
            self.dcel.face(h) != self.outer_face()
                && side(right).is_lt()
                && side(left).is_gt()
                && orientation(self.points[right], self.points[left], from).is_gt()
        };
        let mut across = Vec::new();
        let start = self.dcel.outgoing_half_edges(u).find(enters);
        let mut at = start.map(|h| self.dcel.next(h).twin());
        while let Some(h) = at {
            across.push(h.edge());
            let beyond = self.dcel.destination(self.dcel.next(h));
            at = match side(beyond) {
                Ordering::Greater => Some(self.dcel.next(h).twin()),
                Ordering::Less => Some(self.dcel.prev(h).twin()),
                Ordering::Equal => None,
            };
        }
        across
    }

    /// Gives every triangle without one the face of its neighbours: those beside constrained edges have theirs already,
    /// so that no face spreads across one. Without any constrained edge all lie in the outer face. O(n).
    fn spread_faces(&self, mut faces: Vec<Option<FaceId>>) -> FaceMap<FaceId> {
        faces[0] = Some(self.outer_face());
        let mut waiting: Vec<FaceId> = self.dcel.faces().skip(1).filter(|f| faces[f.index()].is_some()).collect();
        while let Some(f) = waiting.pop() {
            for h in self.dcel.incident_half_edges(f) {
                let beside = self.dcel.face(h.twin());
                if faces[beside.index()].is_none() {
                    faces[beside.index()] = faces[f.index()];
                    waiting.push(beside);
                }
            }
        }
        faces.into_iter().map(|f| f.unwrap_or(self.outer_face())).collect::<Vec<_>>().into()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Walls from far below to far above, and between them short edges that climb from left to right.
    #[test]
    fn edges_across_a_wall_are_looked_at_a_few_times_each() {
        const WALLS: u32 = 150;
        let walls = (0..WALLS).map(f64::from);
        let points: Vec<Point> =
            walls.flat_map(|x| [(x, 0.0), (x, 1e6), (x + 0.3, x), (x + 0.6, x)]).map(Point::from).collect();
        let mut made = Subdivision::delaunay(&points).unwrap().subdivision;
        let mut changed = vec![false; made.dcel.edge_bound()];
        let (mut all_across, mut all_looks) = (0, 0);
        for wall in 0..WALLS {
            let [u, w] = [4 * wall, 4 * wall + 1].map(VertexId::new);
            if let Found::NoneAt(_) = made.find_edge(u, w) {
                let across = made.edges_across(u, w);
                let (half, looks) = made.flip_across(u, w, &across, &mut changed);
                assert_eq!(made.ends(half.unwrap()), [u, w]);
                all_across += across.len();
                all_looks += looks;
            }
        }
        assert!(all_across > 20 * WALLS as usize, "{all_across} edges across {WALLS} walls are too few to tell");
        assert!(all_looks < 8 * all_across, "{all_looks} looks at {all_across} edges");
    }
}
