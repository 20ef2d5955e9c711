//! A short proof that nothing is broken in the plane: simple faces that fit together lie beside each other, so that only
//! what bounds them all needs a sweep.
//!
//! ```text
//!    ●━━━●━━━●━━━●       A face is simple if its border can be seen at once to be a simple polygon: it is convex, or its
//!    ┃  ╱│  ╱│  ╱┃       sides are few. Edges between two of them are inner ones; all others (━) bound regions of them.
//!    ●─╱─●━━━●╱──●         1. each simple face: a simple polygon, counter-clockwise, one cycle
//!    ┃╱  ┃   ┃  ╱┃         2. each vertex: directions once round
//!    ●───●━━━●╱──●         3. the other edges: no two meet; the cycles of all other faces lie where they should (G5 to G7)
//!    ┃  ╱│  ╱│  ╱┃
//!    ●━━━●━━━●━━━●
//! ```
//!
//! Why that is enough: lay a region down in the plane, face by face. By 1 and 2 this is one-to-one near each of its inner
//! points, so how often it covers a place changes only at the edges that bound it. These edges, the edges of 3, cut the
//! plane into parts; within one part a region covers all places equally often, and those far outside never.
//!
//! - The unbounded part is `f0`: no region covers it, so that the cycles round it have other faces, and those are `f0` by 3.
//! - Every other part is covered: the edges of the cycle round it have a face on that side. If it is one that is not
//!   simple, it is that part by 3; if it belongs to a region, the region covers the part.
//! - The areas of all bounded faces add up to that of all bounded parts: each edge adds to the area on its left what it takes
//!   from that on its right, and what is left over are the cycles of `f0`.
//!
//! So every place is covered once, but for the edges: no two faces overlap, and no vertex or edge of the inside of a region
//! lies anywhere else.

use super::cycle::{convex_direction, encloses};
use super::sweep::sweep;
use super::{Point, Subdivision};
use crate::geometry::predicates::orientation;
use crate::ids::{EdgeId, FaceMap, HalfEdgeId, VertexId};
use std::cmp::Ordering;

impl Subdivision {
    /// Whether it is shown that no invariant of the plane is broken. If not, they may hold all the same.
    ///
    /// Cost: O(n) with n edges, and O(k log k) for the k of them that are no inner ones. Where those are more than half, it
    /// ends after a look at the faces.
    pub(super) fn is_proved_plane(&self) -> bool {
        let turn_once = || self.dcel.vertices().all(|v| self.turns_once(v));
        Simple::of(self).is_some_and(|simple| simple.are_most() && turn_once() && simple.is_plane())
    }

    /// The same where the half-edges round each vertex are known to be in the order of their angles.
    pub(super) fn is_proved_by_faces(&self) -> bool {
        Simple::of(self).is_some_and(|simple| simple.are_most() && simple.is_plane())
    }
}

/// Faces that are not convex are looked at one by one if they have not more sides than this.
const FEW: usize = 24;

/// The simple faces, and the edges that are not between two of them.
struct Simple<'a> {
    s: &'a Subdivision,
    faces: FaceMap<bool>,
    others: Vec<EdgeId>,
}

impl<'a> Simple<'a> {
    /// `None` if there is no inner edge.
    fn of(s: &'a Subdivision) -> Option<Self> {
        let mut faces = FaceMap::filled(s.dcel.face_bound(), false);
        for f in s.dcel.faces().filter(|&f| f != s.outer_face() && s.inner_components(f).is_empty()) {
            faces[f] = s.dcel.half_edge(f).is_some_and(|h| is_simple_cycle(s, h));
        }
        let mut simple = Self { s, faces, others: Vec::new() };
        simple.others = s.dcel.edges().filter(|&e| !simple.is_inner(e)).collect();
        (simple.others.len() < s.dcel.edge_count()).then_some(simple)
    }

    fn is_of_simple(&self, h: HalfEdgeId) -> bool {
        self.faces[self.s.dcel.face(h)]
    }

    fn is_inner(&self, e: EdgeId) -> bool {
        e.half_edges().into_iter().all(|h| self.is_of_simple(h))
    }

    /// Whether at least half of the edges are inner ones.
    fn are_most(&self) -> bool {
        2 * self.others.len() <= self.s.dcel.edge_count()
    }

    /// Point 3; 1 was seen to, and 2 has to be.
    fn is_plane(&self) -> bool {
        let s = self.s;
        let ends: Vec<[u32; 2]> = self.others.iter().map(|&e| s.edge_ends(e).map(VertexId::number)).collect();
        let isolated = s.dcel.vertices().filter(|&v| s.dcel.outgoing(v).is_none()).map(VertexId::number);
        let swept = sweep(s.points.as_slice(), &ends, &isolated.collect::<Vec<_>>(), true);
        if swept.intersection.is_some() {
            return false;
        }
        let mut found = Vec::new();
        for f in s.dcel.faces().filter(|&f| !self.faces[f]) {
            s.check_cycles(f, &self.others, &swept.below, &mut found);
        }
        found.is_empty()
    }
}

/// Whether the cycle of `h` is seen at once to run round a simple polygon, counter-clockwise.
///
/// Cost: O(sides), and O(k²) for k sides, at most [`FEW`], of a polygon that is not convex.
fn is_simple_cycle(s: &Subdivision, h: HalfEdgeId) -> bool {
    let mut corners = [Point::new(0.0, 0.0); FEW];
    let mut count = 0;
    for corner in s.corner_points(h) {
        if count == FEW {
            return convex_direction(s.corner_points(h)) == Some(Ordering::Greater);
        }
        corners[count] = corner;
        count += 1;
    }
    match &corners[..count] {
        &[a, b, c] => orientation(a, b, c).is_gt(),
        corners => match convex_direction(corners.iter().copied()) {
            Some(direction) => direction.is_gt(),
            None => encloses(corners.iter().copied()) && have_sides_apart(corners),
        },
    }
}

/// Whether no two sides of a polygon have a point in common but the corner between them. It has four sides at least, and
/// [`FEW`] at most: where a side runs back over its neighbour, the side behind one of them touches the other. Exact.
fn have_sides_apart(corners: &[Point]) -> bool {
    let count = corners.len();
    let side = |i: usize| [corners[i], corners[if i + 1 == count { 0 } else { i + 1 }]];
    let mut boxes = [[Point::new(0.0, 0.0); 2]; FEW];
    for (i, bounds) in boxes[..count].iter_mut().enumerate() {
        let [a, b] = side(i);
        *bounds = [Point::new(a.x.min(b.x), a.y.min(b.y)), Point::new(a.x.max(b.x), a.y.max(b.y))];
    }
    let is_on_one_side = |[a, b]: [Point; 2], [c, d]: [Point; 2]| {
        let side = orientation(a, b, c);
        side.is_ne() && side == orientation(a, b, d)
    };
    (0..count).all(|i| {
        let [a, b] = side(i);
        // The last side is a neighbour of the first one.
        let last = if i == 0 { count - 1 } else { count };
        let [low, high] = boxes[i];
        (i + 2..last).all(|j| {
            let [other_low, other_high] = boxes[j];
            let is_beside =
                (high.x < other_low.x) | (other_high.x < low.x) | (high.y < other_low.y) | (other_high.y < low.y);
            is_beside || is_on_one_side([a, b], side(j)) || is_on_one_side(side(j), [a, b])
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plane::sweep::tests::numbers;
    use crate::topology::PolygonList;

    fn at(x: u64, y: u64) -> Point {
        Point::new(x as f64, y as f64)
    }

    /// Triangulations of points of a small grid, some triangles taken away and some joined to polygons, islands in the gaps.
    fn random(next: &mut impl FnMut(u64) -> u64) -> Subdivision {
        let size = 3 + next(5);
        let points: Vec<Point> = (0..4 + next(14)).map(|_| at(next(size), next(size))).collect();
        let Ok(built) = Subdivision::delaunay(&points) else { return Subdivision::lab_rectangle() };
        let mut s = built.subdivision;
        for _ in 0..next(6) {
            let edges: Vec<EdgeId> = s.edges().collect();
            if edges.is_empty() {
                break;
            }
            let [h, t] = edges[next(edges.len() as u64) as usize].half_edges();
            // Joined with the outer face, holes, dents and dangling edges come about.
            if s.face(h) != s.face(t) || next(3) == 0 {
                let _ = s.remove_edge(h.edge());
            }
        }
        s
    }

    fn is_shown(s: &Subdivision) -> bool {
        s.dcel.vertices().all(|v| s.turns_once(v)) && Simple::of(s).unwrap().is_plane()
    }

    /// Both ways give the same, and what is shown is shown at least for all that is right and has an inner edge.
    fn agree(s: &Subdivision, context: &str) -> bool {
        let swept = s.swept_violations();
        let shown = Simple::of(s).map(|_| is_shown(s));
        assert!(shown.is_none_or(|shown| shown == swept.is_empty()), "{context}: {shown:?}, {swept:?}\n{s:?}");
        shown.is_some()
    }

    #[test]
    fn the_proof_holds_where_the_sweep_finds_nothing_and_only_there() {
        let (mut right, mut wrong) = (0, 0);
        for seed in 1..=60_000 {
            let mut next = numbers(0x9e37_79b9_7f4a_7c15_u64.wrapping_mul(seed));
            let mut s = random(&mut next);
            right += u32::from(agree(&s, &format!("seed {seed}")));
            let vertices: Vec<VertexId> = s.vertices().collect();
            for _ in 0..1 + next(3) {
                s.points[vertices[next(vertices.len() as u64) as usize]] = at(next(8), next(8));
            }
            let shown = agree(&s, &format!("seed {seed}, moved"));
            wrong += u32::from(shown && !s.swept_violations().is_empty());
        }
        assert!(right > 20_000 && wrong > 20_000, "{right} right, {wrong} wrong");
    }

    /// Two sheets one over the other share no edge, or go round a point twice.
    #[test]
    fn sheets_that_lie_over_each_other_are_no_plane() {
        let grid = |x: u64| [at(x, x), at(x + 2, x), at(x + 2, x + 2), at(x, x + 2)];
        let points: Vec<Point> = grid(0).into_iter().chain(grid(1)).collect();
        let apart = (0..).zip(&points).map(|(i, p)| if i < 4 { *p } else { Point::new(p.x + 20.0, p.y) }).collect();
        let s = Subdivision::from_triangles(apart, &[[0, 1, 2], [0, 2, 3], [4, 5, 6], [4, 6, 7]]);
        let mut s = s.unwrap_or_else(|error| panic!("{error}"));
        assert!(is_shown(&s));
        for (v, &p) in points.iter().enumerate() {
            s.points[VertexId::new(v as u32)] = p;
        }
        assert!(!is_shown(&s) && !s.swept_violations().is_empty());
        // The smaller one inside the larger one: no two edges meet.
        for (v, p) in points.iter().enumerate().skip(4) {
            s.points[VertexId::new(v as u32)] = Point::new(0.5 + p.x / 8.0, 0.25 + p.y / 8.0);
        }
        assert!(!is_shown(&s) && !s.swept_violations().is_empty());
    }

    /// An island in the hole of a ring of convex faces, put where a face of the ring is.
    #[test]
    fn a_hole_lies_where_its_region_says() {
        let mut points: Vec<Point> =
            [(0, 0), (9, 0), (9, 9), (0, 9), (3, 3), (6, 3), (6, 6), (3, 6)].map(|(x, y)| at(x, y)).into();
        let mut faces = PolygonList::new();
        for i in 0..4 {
            let j = (i + 1) % 4;
            faces.push_face(&[i, j, j + 4]);
            faces.push_face(&[i, j + 4, i + 4]);
        }
        points.extend([at(4, 4), at(5, 4), at(4, 5)]);
        faces.push_face(&[8, 9, 10]);
        let mut s = Subdivision::from_polygons(points, &faces).unwrap_or_else(|error| panic!("{error}"));
        assert!(is_shown(&s) && s.swept_violations().is_empty());
        for (v, p) in
            (8..11).map(VertexId::new).zip([Point::new(1.0, 0.25), Point::new(1.5, 0.25), Point::new(1.0, 0.5)])
        {
            s.points[v] = p;
        }
        assert!(!is_shown(&s) && !s.swept_violations().is_empty());
    }
}
