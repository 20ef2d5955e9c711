//! A curve on a surface that does not cut it in two: the witness of a handle.
//!
//! ```text
//!        ______
//!      ╱   __   ╲          a tree of edges joins all vertices, a tree of other edges crossed joins all faces. An edge
//!     │   ╱  ╲   │         in neither closes a curve with the first tree, and the second tree joins the faces on
//!     │   ╲__╱   │ <─ a    both of its sides without crossing it. A piece of genus g has 2g such edges; without
//!      ╲____│___╱          handles there is none.
//!           curve
//! ```
//!
//! Source: the dual graph in Kazhdan's slides, where a curve C takes edges C* out of the dual graph; the two trees are
//! from D. Eppstein, *Dynamic generators of topologically embedded graphs*, 2003.

use super::Polyhedron;
use crate::ids::{EdgeMap, FaceMap, HalfEdgeId, VertexId, VertexMap};
use std::collections::VecDeque;

impl Polyhedron {
    /// A closed curve of edges that does not cut its piece in two, half-edge by half-edge; none if no piece has
    /// handles. Borders count as faces here, so that a piece with borders is looked at as if they were filled.
    ///
    /// Cost: linear.
    ///
    /// ```
    /// use dcel_kit::solid::{Platonic, Polyhedron, grow::Shape};
    /// assert_eq!(Polyhedron::platonic(Platonic::Cube).curve_without_sides(), None);
    /// let torus = Shape::Torus { n: 7, m: 5 }.build()?.polyhedron;
    /// assert!(torus.curve_without_sides().is_some_and(|curve| curve.len() >= 5));
    /// # Ok::<(), dcel_kit::solid::grow::GrowError>(())
    /// ```
    #[must_use]
    pub fn curve_without_sides(&self) -> Option<Vec<HalfEdgeId>> {
        let dcel = self.topology();
        let mut in_tree = EdgeMap::filled(self.edge_bound(), false);
        let mut to: VertexMap<Option<HalfEdgeId>> = VertexMap::filled(self.vertex_bound(), None);
        let mut met = VertexMap::filled(self.vertex_bound(), false);
        let mut queue = VecDeque::new();
        for root in self.vertices() {
            if std::mem::replace(&mut met[root], true) {
                continue;
            }
            queue.push_back(root);
            while let Some(v) = queue.pop_front() {
                for h in self.outgoing_half_edges(v) {
                    let w = dcel.destination(h);
                    if !std::mem::replace(&mut met[w], true) {
                        (in_tree[h.edge()], to[w]) = (true, Some(h));
                        queue.push_back(w);
                    }
                }
            }
        }
        let mut met = FaceMap::filled(self.face_bound(), false);
        let mut stack = Vec::new();
        for root in self.faces() {
            if std::mem::replace(&mut met[root], true) {
                continue;
            }
            stack.push(root);
            while let Some(f) = stack.pop() {
                for h in self.incident_half_edges(f).filter(|h| !in_tree[h.edge()]).collect::<Vec<_>>() {
                    let behind = dcel.face(h.twin());
                    if !std::mem::replace(&mut met[behind], true) {
                        in_tree[h.edge()] = true;
                        stack.push(behind);
                    }
                }
            }
        }
        let closing = self.edges().find(|&e| !in_tree[e])?.half_edges()[0];
        Some(curve(closing, [dcel.origin(closing), dcel.destination(closing)], |v| to[v].map(|h| (h, dcel.origin(h)))))
    }
}

/// The cycle of `closing`, which runs from `u` to `v`, with the ways of both in the tree; `up` gives the half-edge of
/// the tree that leads down to a vertex, and the vertex above.
fn curve(
    closing: HalfEdgeId,
    [u, v]: [VertexId; 2],
    up: impl Fn(VertexId) -> Option<(HalfEdgeId, VertexId)>,
) -> Vec<HalfEdgeId> {
    let way =
        |from: VertexId| std::iter::successors(up(from), |&(_, above)| up(above)).map(|(h, _)| h).collect::<Vec<_>>();
    let (mut of_u, mut of_v) = (way(u), way(v));
    while of_u.last().is_some_and(|h| of_v.last() == Some(h)) {
        of_u.pop();
        of_v.pop();
    }
    // Up from v to the meeting point, then down to u.
    let up_from_v = of_v.into_iter().map(HalfEdgeId::twin);
    [closing].into_iter().chain(up_from_v).chain(of_u.into_iter().rev()).collect()
}
