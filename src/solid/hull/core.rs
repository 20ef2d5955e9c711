//! Points that are inside for sure, found quickly: they need not be looked at one by one.
//!
//! ```text
//!            ○  ○                 Directions from a middle O are sorted into cells, as on the sides of a cube. The
//!         ○───────○               furthest point of each cell (○) is a corner of a small hull, made as any other.
//!        ╱  ╲ · ╱  ╲
//!       ○ ·  ╲ ╱ ·  ○             Along the corners of the cells that hull is measured from O. Between three of them
//!        ╲ ·  O  · ╱              and O lies a tetrahedron of points that are inside: · is below its plane.
//!         ○───────○
//! ```
//!
//! That a measured place lies inside the small hull is decided exactly. A point is called inside if it is so by a
//! margin that is far above all rounding; what is near the border is left to the hull itself. So this changes no result.

use super::order;
use super::triangles::Triangles;
use crate::solid::predicates::orient3d;
use crate::solid::vector::{dot, normal};
use crate::topology::NoObserver;
use std::cmp::Ordering;

const NONE: u32 = u32::MAX;

/// Below so many points the hull itself is as fast.
const FEW: usize = 5_000;
/// How many points a cell should hold.
const POINTS_A_CELL: usize = 800;
/// Relative to the distance from the middle: what measured places are moved in by, and what points must be inside by.
/// Rounding stays below 2^-40 where no distance is less than `FLAT` of the greatest.
const MARGIN: f64 = 1e-9;
const FLAT: f64 = 1e-2;

/// A part of the hull that is known.
pub(super) struct Core {
    cells: Cells,
    /// By half of a cell: the vector whose product with a place, seen from the middle, is 1 in the plane over it.
    planes: Vec<[f64; 3]>,
}

/// Directions from a middle, in cells.
struct Cells {
    middle: [f64; 3],
    scale: [f64; 3],
    /// Cells along one side of the cube.
    side: usize,
}

impl Core {
    /// The core of the hull of `points`, if there are many of them and their hull is not flat. O(n).
    pub(super) fn new(points: &[[f64; 3]]) -> Option<Self> {
        if points.len() < FEW {
            return None;
        }
        let side = (((points.len() / POINTS_A_CELL / 6) as f64).sqrt() as usize).clamp(2, 16);
        let cells = Cells::new(points, side)?;
        let furthest = cells.furthest(points);
        let corners = super::simplex::spanning_points(&furthest).ok()?;
        let mut hull = Triangles::simplex(&furthest, corners, |_| true);
        order::order(&furthest, |_| true, |p| hull.add(p, &mut NoObserver));
        let sides: Vec<[[f64; 3]; 3]> =
            hull.triangles().into_iter().map(|(corners, _)| corners.map(|i| furthest[i as usize])).collect();
        let planes = cells.planes(&sides)?;
        Some(Self { cells, planes })
    }

    /// Whether `p` is inside for sure.
    #[inline]
    pub(super) fn contains(&self, p: [f64; 3]) -> bool {
        let p = self.cells.seen(p);
        dot(self.planes[self.cells.half_cell(p)], p) < 1.0 - MARGIN
    }
}

impl Cells {
    fn new(points: &[[f64; 3]], side: usize) -> Option<Self> {
        let count = points.len() as f64;
        let mut sum = [0.0; 3];
        points.iter().for_each(|p| (0..3).for_each(|i| sum[i] += p[i] / count));
        let mut reach = [0.0_f64; 3];
        points.iter().for_each(|p| (0..3).for_each(|i| reach[i] = reach[i].max((p[i] - sum[i]).abs())));
        let usable = |x: f64| x > 1e-100 && x < 1e100;
        reach.into_iter().all(usable).then(|| Self { middle: sum, scale: reach.map(|x| 1.0 / x), side })
    }

    /// A place as it is seen from the middle, in a cube of side 2.
    #[inline]
    fn seen(&self, p: [f64; 3]) -> [f64; 3] {
        std::array::from_fn(|i| (p[i] - self.middle[i]) * self.scale[i])
    }

    /// In which half of which cell a direction lies.
    #[inline]
    fn half_cell(&self, p: [f64; 3]) -> usize {
        let size = p.map(f64::abs);
        let axis = if size[0] >= size[1] && size[0] >= size[2] { 0 } else { 2 - usize::from(size[1] >= size[2]) };
        let [u, v] = [p[(axis + 1) % 3], p[(axis + 2) % 3]].map(|x| x / size[axis]);
        let n = self.side as f64;
        // The middle itself has no direction; any cell is right for it.
        let [a, b] = [u, v].map(|x| (x + 1.0) * (0.5 * n));
        let [i, j] = [a, b].map(|x| (x as usize).min(self.side - 1));
        let cube_side = 2 * axis + usize::from(p[axis] < 0.0);
        let half = usize::from(b - j as f64 > a - i as f64);
        2 * ((cube_side * self.side + j) * self.side + i) + half
    }

    /// The furthest point of each cell that has one, along the middle of the cell. O(n).
    fn furthest(&self, points: &[[f64; 3]]) -> Vec<[f64; 3]> {
        let n = self.side;
        let middle = |cell: usize| {
            let place = [cell % n, cell / n % n].map(|at| at as f64 + 0.5);
            self.direction(cell / (n * n), place)
        };
        let middles: Vec<[f64; 3]> = (0..6 * n * n).map(middle).collect();
        let mut best = vec![(f64::NEG_INFINITY, NONE); middles.len()];
        for (p, &position) in (0..).zip(points) {
            let seen = self.seen(position);
            let cell = self.half_cell(seen) / 2;
            let far = dot(middles[cell], seen);
            if far > best[cell].0 {
                best[cell] = (far, p);
            }
        }
        best.into_iter().filter(|&(_, p)| p != NONE).map(|(_, p)| points[p as usize]).collect()
    }

    /// The direction to a place on a side of the cube, counted in cells.
    fn direction(&self, cube_side: usize, place: [f64; 2]) -> [f64; 3] {
        let axis = cube_side / 2;
        let [u, v] = place.map(|x| 2.0 * x / self.side as f64 - 1.0);
        let mut direction = [0.0; 3];
        direction[axis] = if cube_side % 2 == 1 { -1.0 } else { 1.0 };
        direction[(axis + 1) % 3] = u;
        direction[(axis + 2) % 3] = v;
        direction
    }

    /// The planes over all halves of cells; none if the hull with these sides, counter-clockwise seen from outside, is
    /// flat or does not hold the middle.
    fn planes(&self, sides: &[[[f64; 3]; 3]]) -> Option<Vec<[f64; 3]>> {
        let normal = |side: &[[f64; 3]; 3]| {
            let [a, b, c] = side.map(|p| self.seen(p));
            let normal = normal([a, b, c]);
            (normal, dot(normal, a))
        };
        let normals: Vec<([f64; 3], f64)> = sides.iter().map(normal).collect();
        // Exact; all numbers here are below 100, so that doubles decide what is not near.
        let is_inside = |p: [f64; 3]| {
            let seen = self.seen(p);
            let far = |&(normal, distance): &([f64; 3], f64)| distance - dot(normal, seen) > 1e-10;
            let below = |&[a, b, c]: &[[f64; 3]; 3]| orient3d(a, b, c, p) == Ordering::Less;
            sides.iter().zip(&normals).all(|(side, normal)| far(normal) || below(side))
        };
        if !is_inside(self.middle) {
            return None;
        }
        // The place where a ray from the middle leaves the hull, moved in, if it is inside for sure.
        let place = |direction: [f64; 3]| {
            let far = |&(normal, distance): &([f64; 3], f64)| {
                let slope = dot(normal, direction);
                if slope > 0.0 { distance / slope } else { f64::INFINITY }
            };
            let reach = normals.iter().map(far).fold(f64::INFINITY, f64::min) * (1.0 - MARGIN);
            let place = std::array::from_fn(|i| self.middle[i] + reach * direction[i] / self.scale[i]);
            (FLAT < reach && reach < 2.0 && is_inside(place)).then(|| self.seen(place))
        };
        let n = self.side;
        let mut planes = Vec::with_capacity(12 * n * n);
        for cube_side in 0..6 {
            let places = (0..(n + 1) * (n + 1)).map(|at| [at % (n + 1), at / (n + 1)].map(|x| x as f64));
            let places: Vec<[f64; 3]> = places.map(|at| place(self.direction(cube_side, at))).collect::<Option<_>>()?;
            for cell in 0..n * n {
                let at = |i: usize, j: usize| places[(cell / n + j) * (n + 1) + cell % n + i];
                planes.push(plane([at(0, 0), at(1, 0), at(1, 1)]));
                planes.push(plane([at(0, 0), at(1, 1), at(0, 1)]));
            }
        }
        Some(planes)
    }
}

/// The vector whose product with three places is 1.
fn plane([a, b, c]: [[f64; 3]; 3]) -> [f64; 3] {
    let normal = normal([a, b, c]);
    let distance = dot(normal, a);
    normal.map(|x| x / distance)
}
