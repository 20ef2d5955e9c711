//! The area of a region of an overlay, as if nothing had been rounded.
//!
//! ```text
//!        ╲   ╱              The corners of a region that are crossings lie at the nearest doubles. Where they were is
//!    a ──╲─╱── X            known: edges of the overlay know the edges that they are part of, and their lines cross in X.
//!         ╲╱                So every corner has an offset d = X - W, and
//!         ╱╲ W
//!                           2 area = Σ Wi x Wi+1  +  Σ di x (Wi+1 - Wi-1)  +  Σ di x di+1
//!                                    exact           small sums: nothing cancels
//! ```
//!
//! Far from the origin W is off by a part of the size of the whole map. The first sum is that of the rounded corners; the
//! offsets give back what they lost.

use super::{Operation, Overlay};
use crate::geometry::expansion::Expansion;
use crate::ids::{FaceId, HalfEdgeId};
use crate::plane::meet::{crossing_from, foot_from};
use crate::plane::{Point, Subdivision};

/// A corner of the overlay, and how far off it the corner before rounding was.
type Corner = (Point, [f64; 2]);

impl Overlay {
    /// The area of the union, intersection, difference or symmetric difference of the regions of a and b, which must be the
    /// subdivisions that were laid over each other, in this order.
    ///
    /// It is that of the region before its corners were rounded, to a few last places; what the areas of the faces of
    /// [`region`](Self::region) sum up to is that of the rounded corners. The two differ where the shapes are small and far
    /// from the origin. Of faces that rounding has closed, that part counts whose place others have taken. Infinite if
    /// the outer face is in it, which no operation makes. O(edges).
    ///
    /// # Panics
    /// If `[a, b]` are others, with fewer elements.
    ///
    /// ```
    /// use dcel_kit::plane::{Operation, Point, Subdivision};
    /// let triangle = |corners: [(f64, f64); 3]| {
    ///     Subdivision::from_graph(&corners.map(Point::from), &[[0, 1], [1, 2], [2, 0]])
    /// };
    /// // Two sides cross at a third of 1, far away.
    /// let x = 2_f64.powi(40);
    /// let a = triangle([(x, 0.), (x + 1., 0.), (x, 1.)])?;
    /// let b = triangle([(x, 0.), (x + 0.5, 0.), (x + 0.5, 1.)])?;
    /// let both = a.overlay(&b)?;
    /// let area = both.area([&a, &b], Operation::Intersection);
    /// assert!((area - 5. / 24.).abs() < 1e-15, "{area}");
    /// # Ok::<(), dcel_kit::plane::SegmentsError>(())
    /// ```
    #[must_use]
    pub fn area(&self, [a, b]: [&Subdivision; 2], operation: Operation) -> f64 {
        self.area_where([a, b], |labels| {
            let [in_a, in_b] = self.regions_at(labels);
            operation.holds(in_a, in_b)
        })
    }

    /// The area of all that lies in a face of a and a face of b for which `inside` holds, as [`area`](Self::area) has it.
    ///
    /// # Panics
    /// As [`area`](Self::area).
    ///
    /// ```
    /// # use dcel_kit::plane::{Point, Subdivision};
    /// # use dcel_kit::FaceId;
    /// # let c = [(0., 0.), (2., 0.), (2., 2.), (0., 2.)].map(Point::from);
    /// # let s = Subdivision::from_graph(&c, &[[0, 1], [1, 2], [2, 3], [3, 0]])?;
    /// let both = s.overlay(&s)?;
    /// // How much f1 of a and f1 of b have in common.
    /// assert_eq!(both.area_where([&s, &s], |labels| labels == [FaceId::new(1); 2]), 4.0);
    /// # Ok::<(), dcel_kit::plane::SegmentsError>(())
    /// ```
    #[must_use]
    pub fn area_where(&self, of: [&Subdivision; 2], inside: impl Fn([FaceId; 2]) -> bool) -> f64 {
        let s = &self.subdivision;
        let labels = |f: FaceId| [self.face_of_a[f], self.face_of_b[f]];
        let mut chosen = vec![false; s.dcel.face_bound()];
        s.dcel.faces().for_each(|f| chosen[f.index()] = inside(labels(f)));
        if chosen[s.outer_face().index()] {
            return f64::INFINITY;
        }
        let is_in = |h: HalfEdgeId| chosen[s.dcel.face(h).index()];
        let mut visited = vec![false; s.dcel.half_edge_bound()];
        let (mut twice, mut corners) = (Expansion::default(), Vec::new());
        for start in s.dcel.half_edges().filter(|&h| is_in(h) && !is_in(h.twin())) {
            if visited[start.index()] {
                continue;
            }
            let mut h = start;
            let mut before = self.border(of, h, &inside);
            while !std::mem::replace(&mut visited[h.index()], true) {
                let corner = s.point(s.dcel.destination(h));
                // Behind edges with the region on both sides.
                h = s.dcel.next(h);
                while is_in(h.twin()) {
                    h = s.dcel.next(h.twin());
                }
                let after = self.border(of, h, &inside);
                push_corner(&mut corners, corner, [before, after], self.farthest);
                before = after;
            }
            add_ring(&mut twice, &corners);
            corners.clear();
        }
        0.5 * twice.rounded()
    }

    /// The edge of a or b that bounds the region to the left of a half-edge, in its direction.
    ///
    /// Several edges may run along it that lay beside each other before rounding. They are passed from left to right, up
    /// to the one behind which the region ends.
    fn border(&self, of: [&Subdivision; 2], h: HalfEdgeId, inside: &impl Fn([FaceId; 2]) -> bool) -> [Point; 2] {
        let s = &self.subdivision;
        let is_even = h == h.edge().half_edges()[0];
        let along = [self.edges_of_a(h.edge()), self.edges_of_b(h.edge())];
        let directed = |g: HalfEdgeId| if is_even { g } else { g.twin() };
        let line =
            |(i, g): (usize, HalfEdgeId)| [of[i].dcel.origin(g), of[i].dcel.destination(g)].map(|v| of[i].points[v]);
        let all = || (0..2).flat_map(|i| along[i].iter().map(move |&g| (i, directed(g))));
        if along[0].len() + along[1].len() == 1 {
            return all().map(line).next().expect("an edge of the overlay comes from a or b");
        }
        let [p, q] = [s.dcel.origin(h), s.dcel.destination(h)].map(|v| s.points[v]);
        let middle = Point::new(0.5 * p.x + 0.5 * q.x, 0.5 * p.y + 0.5 * q.y);
        let left = [-(q.y - p.y), q.x - p.x];
        // How far to the left of the middle each of them runs.
        let off = |which| {
            let [x, y] = foot_from(middle, line(which));
            x * left[0] + y * left[1]
        };
        let mut passed: Vec<(f64, (usize, HalfEdgeId))> = all().map(|which| (off(which), which)).collect();
        passed.sort_by(|one, other| other.0.total_cmp(&one.0));
        let f = s.dcel.face(h);
        let mut labels = [self.face_of_a[f], self.face_of_b[f]];
        let ends = |&&(_, (i, g)): &&(f64, (usize, HalfEdgeId))| {
            labels[i] = of[i].dcel.face(g.twin());
            !inside(labels)
        };
        let last = passed.iter().find(ends).or(passed.last()).expect("an edge of the overlay comes from a or b");
        line(last.1)
    }
}

/// The corner where the border turns from one line to another: where they cross, or, if that is not here, the nearest
/// points of both.
fn push_corner(corners: &mut Vec<Corner>, at: Point, lines: [[Point; 2]; 2], farthest: f64) {
    let given = lines[0].into_iter().find(|end| lines[1].contains(end));
    let crossing = match given {
        Some(end) => Some([end.x - at.x, end.y - at.y]),
        None => crossing_from(at, lines),
    };
    match crossing.filter(|[x, y]| x.hypot(*y) <= NEAR * farthest) {
        Some(off) => corners.push((at, off)),
        None => corners.extend(lines.map(|line| (at, foot_from(at, line)))),
    }
}

/// So many times as far as anything moved may a crossing of two lines lie off the vertex that it has become: sharp ones do.
const NEAR: f64 = 64.0;

/// Adds twice the area within a ring.
fn add_ring(twice: &mut Expansion, corners: &[Corner]) {
    let count = corners.len();
    for i in 0..count {
        let ((before, _), (p, d), (q, e)) = (corners[(i + count - 1) % count], corners[i], corners[(i + 1) % count]);
        twice.add_product(p.x, q.y);
        twice.add_product(-p.y, q.x);
        if d.iter().any(|part| part.abs() > 0.0) {
            let across = [q.x - before.x + e[0], q.y - before.y + e[1]];
            twice.add_product(d[0], across[1]);
            twice.add_product(-d[1], across[0]);
        }
    }
}
