//! Triangles on a fine lattice over the map: whether a point is inside one is mostly plain to see there.
//!
//! ```text
//!   · · · ·c· ·    A corner is moved to the nearest of 65,536 times 65,536 lattice points, by half a step at most in x
//!   · · ·╱·│· ·    and in y. So cross(a - p, b - p), twice the area of p, a, b, is off by no more than
//!   · ·╱· ·│· ·
//!   ·a─────b· ·        (|a - p| + |b - p|) / 2 + 1/2,    | | = the sizes of both coordinates, added
//! ```
//!
//! If all three areas are larger than that, p is inside; if one is below its negative, p is outside. Both answers are
//! those of the exact signs. In between nothing is said, and the exact signs have to be asked.
//!
//! Memory: 12 bytes a face, read in one go: no corners have to be looked up.

use crate::plane::Point;

/// Lattice steps from one side of the map to the other.
const STEPS: f64 = 65_535.0;
/// Half a step, and more than the rounding of what is computed here.
const HALF: f64 = 0.5 + 1e-6;
/// Nothing can be said of these corners: all areas are 0.
const UNKNOWN: [u16; 6] = [0; 6];

/// The triangles of a mesh on the lattice.
#[derive(Clone, PartialEq, Debug, Default)]
pub(super) struct Coarse {
    min: Point,
    /// Steps per unit.
    scale: [f64; 2],
    /// Per face its corners, x and y in turn.
    corners: Vec<[u16; 6]>,
}

impl Coarse {
    /// A lattice over a box, without any face.
    pub(super) fn new(min: Point, max: Point) -> Self {
        Self { min, scale: [STEPS / (max.x - min.x), STEPS / (max.y - min.y)], corners: Vec::new() }
    }

    /// Bytes of the array.
    pub(super) fn memory(&self) -> usize {
        size_of_val(&*self.corners)
    }

    /// Where a point is, in steps.
    #[inline]
    pub(super) fn place(&self, p: Point) -> [f64; 2] {
        [(p.x - self.min.x) * self.scale[0], (p.y - self.min.y) * self.scale[1]]
    }

    /// Takes in a face, or its new shape. What is no triangle, or not in the box, is left to the exact signs.
    pub(super) fn put(&mut self, f: u32, corners: &[Point]) {
        if self.corners.len() <= f as usize {
            self.corners.resize(f as usize + 1, UNKNOWN);
        }
        self.corners[f as usize] = self.on_lattice(corners).unwrap_or(UNKNOWN);
    }

    fn on_lattice(&self, corners: &[Point]) -> Option<[u16; 6]> {
        let &[a, b, c] = corners else { return None };
        let mut result = UNKNOWN;
        let steps = [a, b, c].into_iter().flat_map(|p| self.place(p)).map(f64::round);
        for (to, steps) in result.iter_mut().zip(steps) {
            if !(0.0..=STEPS).contains(&steps) {
                return None;
            }
            *to = steps as u16;
        }
        Some(result)
    }

    /// Whether the point with this place is strictly inside face `f`, if that is plain to see.
    #[inline]
    pub(super) fn is_inside(&self, f: u32, [x, y]: [f64; 2]) -> Option<bool> {
        let [ax, ay, bx, by, cx, cy] = self.corners[f as usize].map(f64::from);
        let (ax, bx, cx) = (ax - x, bx - x, cx - x);
        let (ay, by, cy) = (ay - y, by - y, cy - y);
        let least = (ax * by - ay * bx).min(bx * cy - by * cx).min(cx * ay - cy * ax);
        // The bound of the largest of the three errors, and a little more.
        let bound = HALF * (ax.abs() + ay.abs() + bx.abs() + by.abs() + cx.abs() + cy.abs() + 1.0);
        if least > bound {
            Some(true)
        } else if least < -bound {
            Some(false)
        } else {
            None
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Coarse;
    use crate::plane::Point;
    use crate::plane::predicates::orientation;

    #[test]
    fn what_is_plain_to_see_is_so() {
        // Corners and points at random places, a third of them within a step or two of a side.
        let mut state = 7u64;
        let mut unit = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1u64 << 53) as f64
        };
        let (mut inside, mut outside, mut unknown) = (0, 0, 0);
        for _ in 0..4000 {
            let size = [1.0, 1e-2, 1e-3][(unit() * 3.0) as usize];
            let [x, y] = [unit() * 0.9, unit() * 0.9];
            let mut at = || Point::new(x + unit() * size * 0.1, y + unit() * size * 0.1);
            let [a, b, c] = [at(), at(), at()];
            let [a, b, c] = if orientation(a, b, c).is_gt() { [a, b, c] } else { [a, c, b] };
            let mut coarse = Coarse::new(Point::new(0., 0.), Point::new(1., 1.));
            coarse.put(0, &[a, b, c]);
            for i in 0..12 {
                let p = if i % 3 == 0 {
                    let t = unit();
                    let near = Point::new(a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t);
                    Point::new(near.x + (unit() - 0.5) * 4e-5, near.y + (unit() - 0.5) * 4e-5)
                } else {
                    Point::new(x + unit() * size * 0.1, y + unit() * size * 0.1)
                };
                let truth = [(a, b), (b, c), (c, a)].into_iter().all(|(a, b)| orientation(a, b, p).is_gt());
                match coarse.is_inside(0, coarse.place(p)) {
                    Some(said) => {
                        assert_eq!(said, truth, "{a} {b} {c}: {p}");
                        *if said { &mut inside } else { &mut outside } += 1;
                    }
                    None => unknown += 1,
                }
            }
        }
        assert!(inside > 1000 && outside > 1000 && unknown > 1000, "{inside} {outside} {unknown}");
    }

    #[test]
    fn nothing_is_said_of_other_shapes_nor_outside_the_box() {
        let at = |x, y| Point::new(x, y);
        let mut coarse = Coarse::new(at(0., 0.), at(1., 1.));
        coarse.put(2, &[at(0., 0.), at(1., 0.), at(1., 1.), at(0., 1.)]);
        coarse.put(1, &[at(0., 0.), at(1.1, 0.), at(0., 1.)]);
        coarse.put(3, &[at(0., 0.), at(1., 0.), at(0., 1.)]);
        for p in [at(0.25, 0.25), at(0.75, 0.5), at(f64::NAN, 0.5)] {
            let said = [0, 1, 2].map(|f| coarse.is_inside(f, coarse.place(p)));
            assert_eq!(said, [None; 3], "{p}");
        }
        assert_eq!(coarse.is_inside(3, coarse.place(at(0.25, 0.25))), Some(true));
        assert_eq!(coarse.is_inside(3, coarse.place(at(0.75, 0.5))), Some(false));
    }
}
