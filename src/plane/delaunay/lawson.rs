//! Delaunay by flips, as lab 07 does it.
//!
//! ```text
//!        c                   c          While an edge is not locally Delaunay, it is flipped. Then the four edges
//!      ╱   ╲               ╱ │ ╲        around it are looked at again. Every flip lifts the surface over the
//!    a ───── b     ==>   a   │   b      paraboloid z = x² + y² down, so that no edge comes back: it ends, after
//!      ╲   ╱               ╲ │ ╱        at most n² flips. Points on one circle are never flipped.
//!        d                   d
//! ```
//!
//! Source: Lawson, *Software for C1 surface interpolation*, 1977; de Berg et al., section 9.3.

use crate::geometry::predicates::in_circle;
use crate::ids::{EdgeId, HalfEdgeId};
use crate::plane::{Point, Subdivision};
use crate::topology::{NoObserver, NoRecorder, Observer, Recorder};

/// What Lawson's algorithm does with an edge that it looks at.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum FlipEvent {
    /// It is locally Delaunay, or not between two triangles: it stays for now.
    Kept(EdgeId),
    /// A corner of one of its triangles lies inside the circle round the other: it is about to be flipped.
    Flipped(EdgeId),
}

impl Subdivision {
    /// The corners a, b, c, d of the two triangles at `h`, which runs from a to b, with c on its left and d on its
    /// right; none unless a triangle of the domain without inner components lies on both sides, or a hole face on both.
    fn two_triangles(&self, h: HalfEdgeId) -> Option<[Point; 4]> {
        let t = h.twin();
        let [f, g] = [h, t].map(|h| self.dcel.face(h));
        let bounded = f != g && f != self.outer_face() && g != self.outer_face();
        let alone = |f| self.inner_components.is_empty() || self.inner_components(f).is_empty();
        let alike = self.holes.is_empty() || self.is_hole(f) == self.is_hole(g);
        let [c, d] = [h, t].map(|h| self.dcel.prev(h));
        let three = |h, last| self.dcel.next(self.dcel.next(h)) == last;
        if !(bounded && three(h, c) && three(t, d) && alone(f) && alone(g) && alike) {
            return None;
        }
        Some([h, t, c, d].map(|h| self.points[self.dcel.origin(h)]))
    }

    /// Whether the edge of `h` is locally Delaunay: no corner of the triangle on one side lies inside the circle
    /// round the triangle on the other. So are all edges that do not lie between two triangles of the domain, or of
    /// a hole. Exact, O(1) beside inner components and holes.
    #[must_use]
    pub fn is_locally_delaunay(&self, h: HalfEdgeId) -> bool {
        self.two_triangles(h).is_none_or(|[a, b, c, d]| in_circle(a, b, c, d).is_le())
    }

    /// The edges that are not locally Delaunay and not fixed, in the order of their numbers. Without any, a
    /// triangulation is Delaunay, or constrained Delaunay if edges are fixed.
    pub fn non_delaunay_edges(&self, is_fixed: impl Fn(EdgeId) -> bool) -> impl Iterator<Item = EdgeId> {
        self.dcel.edges().filter(move |&e| !is_fixed(e) && !self.is_locally_delaunay(e.half_edges()[0]))
    }

    /// Flips edges until all are locally Delaunay, except those that are fixed. Returns the number of flips.
    ///
    /// Only edges between two triangles of the domain, or of a hole, are flipped; other faces stay as they are. All
    /// ids stay. Of several Delaunay triangulations of points on one circle, which one it becomes depends on the
    /// triangulation it was.
    ///
    /// Cost: O(edges + flips); mostly few flips for each edge, about √n where the given triangles run from side to side
    /// (those of the monotone sweep between many holes), at worst O(n²) for n vertices. Exact.
    ///
    /// ```
    /// use dcel_kit::plane::{Point, Subdivision};
    /// let points = [(0., 0.), (3., -1.), (6., 0.), (3., 1.)].map(Point::from).to_vec();
    /// let mut kite = Subdivision::from_triangles(points, &[[0, 1, 2], [0, 2, 3]])?;
    /// assert_eq!(kite.make_delaunay(|_| false), 1);
    /// assert!(kite.find_half_edge(dcel_kit::VertexId::new(1), dcel_kit::VertexId::new(3)).is_some());
    /// # Ok::<(), dcel_kit::plane::ConvertError>(())
    /// ```
    pub fn make_delaunay(&mut self, is_fixed: impl Fn(EdgeId) -> bool) -> usize {
        self.flip_all(is_fixed, self.all_edges(), &mut NoRecorder, &mut NoObserver)
    }

    /// [`make_delaunay`](Self::make_delaunay), watched: each edge that it looks at, and what becomes of it.
    ///
    /// ```
    /// use dcel_kit::plane::{FlipEvent, Point, Subdivision};
    /// let points = [(0., 0.), (3., -1.), (6., 0.), (3., 1.)].map(Point::from).to_vec();
    /// let mut kite = Subdivision::from_triangles(points, &[[0, 1, 2], [0, 2, 3]])?;
    /// let mut events = Vec::new();
    /// let flips = kite.make_delaunay_observed(|_| false, &mut events);
    /// assert_eq!(events.iter().filter(|event| matches!(event, FlipEvent::Flipped(_))).count(), flips);
    /// # Ok::<(), dcel_kit::plane::ConvertError>(())
    /// ```
    pub fn make_delaunay_observed(
        &mut self,
        is_fixed: impl Fn(EdgeId) -> bool,
        observer: &mut impl Observer<FlipEvent>,
    ) -> usize {
        self.flip_all(is_fixed, self.all_edges(), &mut NoRecorder, observer)
    }

    /// [`make_delaunay`](Self::make_delaunay), watched by a recorder: four steps for each flip.
    pub fn make_delaunay_with(&mut self, is_fixed: impl Fn(EdgeId) -> bool, rec: &mut impl Recorder) -> usize {
        self.flip_all(is_fixed, self.all_edges(), rec, &mut NoObserver)
    }

    /// By edge, whether there is one.
    fn all_edges(&self) -> Vec<bool> {
        let mut all = vec![false; self.dcel.edge_bound()];
        self.dcel.edges().for_each(|e| all[e.index()] = true);
        all
    }

    /// [`make_delaunay`](Self::make_delaunay) where only the edges of `waits` may not be locally Delaunay. It makes the
    /// flips that it would make if all of them were looked at, in the same order.
    pub(super) fn flip_all(
        &mut self,
        is_fixed: impl Fn(EdgeId) -> bool,
        mut waits: Vec<bool>,
        rec: &mut impl Recorder,
        observer: &mut impl Observer<FlipEvent>,
    ) -> usize {
        // Edges come in their order. Before the next one come those that flips have put in doubt again, the last first.
        let (mut next, mut again) = (0, Vec::new());
        let mut flips = 0;
        loop {
            let e = match again.pop() {
                Some(e) => e,
                None => {
                    let Some(step) = waits[next..].iter().position(|&waits| waits) else { return flips };
                    next += step + 1;
                    EdgeId::new(next as u32 - 1)
                }
            };
            waits[e.index()] = false;
            if is_fixed(e) {
                continue;
            }
            let [h, t] = e.half_edges();
            if self.is_locally_delaunay(h) {
                observer.observe(|| FlipEvent::Kept(e));
                continue;
            }
            observer.observe(|| FlipEvent::Flipped(e));
            self.dcel.flip_edge_unchecked(h, rec);
            flips += 1;
            for h in [h, t].into_iter().flat_map(|h| [self.dcel.next(h), self.dcel.prev(h)]) {
                let e = h.edge();
                if !std::mem::replace(&mut waits[e.index()], true) && e.index() < next {
                    again.push(e);
                }
            }
        }
    }
}
