//! A square grid whose points, and whose lines between pixels, are doubles.
//!
//! ```text
//!     ┆       ┆       ┆          The pixel of a grid point is the square round it, with its left and its lower side
//!   ┄┄╂━━━━━━━╂───────╂┄┄        and without the other two: each point of the plane lies in just one pixel.
//!     ┃   ●   ┃   ●   │
//!   ┄┄╂━━━━━━━╂━━━━━━━╂┄┄
//! ```

use crate::plane::{LARGEST, Point, SMALLEST};

/// A grid: the multiples of a power of two.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::plane) struct Grid {
    size: f64,
}

/// The greatest number of grid steps from 0 to a coordinate. Half a step more is a double, too.
const MOST_STEPS: f64 = ((1_u64 << 52) - 1) as f64;

impl Grid {
    /// The finest grid for coordinates up to `reach` in size: between 2^-52 and 2^-51 of it, seldom up to 2^-50.
    pub(in crate::plane) fn finest(reach: f64) -> Self {
        let size = power_below(reach / MOST_STEPS);
        let size = if size * MOST_STEPS < reach { 2.0 * size } else { size };
        Self { size: size.max(SMALLEST) }
    }

    /// The grid of the largest power of two that is not above `size`; none if that is no number from 2^-142 to 2^201.
    pub(in crate::plane) fn of(size: f64) -> Option<Self> {
        (SMALLEST..=LARGEST).contains(&size).then(|| Self { size: power_below(size) })
    }

    /// The distance of neighbours.
    pub(in crate::plane) const fn size(self) -> f64 {
        self.size
    }

    /// Half of it: from a grid point to the sides of its pixel.
    pub(in crate::plane) fn half(self) -> f64 {
        self.size / 2.0
    }

    /// No point of a pixel is further from the middle.
    pub(in crate::plane) fn half_diagonal(self) -> f64 {
        (self.size * std::f64::consts::FRAC_1_SQRT_2).next_up()
    }

    /// The multiple of the size next to `x`; of two the upper one. Exact.
    pub(in crate::plane) fn round(self, x: f64) -> f64 {
        let steps = x / self.size;
        let whole = steps.floor();
        (if steps - whole >= 0.5 { whole + 1.0 } else { whole }) * self.size + 0.0
    }

    /// The grid point in whose pixel `p` lies.
    pub(in crate::plane) fn place(self, p: Point) -> Point {
        Point::new(self.round(p.x), self.round(p.y))
    }
}

/// The largest power of two not above a positive number, or the smallest normal number.
fn power_below(x: f64) -> f64 {
    f64::from_bits(x.to_bits() & (0x7ff << 52)).max(f64::MIN_POSITIVE)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounding_goes_to_the_pixel_and_pixels_have_their_lower_sides() {
        let grid = Grid::of(0.3).unwrap();
        assert_eq!(grid, Grid { size: 0.25 });
        for (x, to) in [(0.125, 0.25), (0.125_f64.next_down(), 0.0), (-0.125, 0.0), ((-0.125_f64).next_down(), -0.25)] {
            assert_eq!(grid.place(Point::new(x, 0.0)), Point::new(to, 0.0), "{x}");
        }
        assert_eq!(grid.round(-1e-30).to_bits(), 0.0_f64.to_bits());
        let unit = Grid::of(1.0).unwrap();
        assert_eq!(
            (unit.round(0.5_f64.next_down()), unit.round(-0.5), unit.round((-0.5_f64).next_down())),
            (0., 0., -1.)
        );
        for bad in [0.0, -1.0, f64::NAN, f64::INFINITY, SMALLEST / 2.0, LARGEST * 2.0] {
            assert_eq!(Grid::of(bad), None, "{bad}");
        }
    }

    #[test]
    fn the_finest_grid_has_half_steps_in_doubles() {
        for reach in [1.0, 1.5, 4e6, 5.5e6_f64.next_up(), LARGEST, 1e-20, 1.0_f64.next_up(), 1.0_f64.next_down()] {
            let grid = Grid::finest(reach);
            let last = grid.round(reach);
            let half = grid.half();
            assert_eq!(((last + half) - last, last - (last - half)), (half, half), "{reach}");
            assert!(grid.size() <= reach * 2f64.powi(-50) && grid.size() > reach * 2f64.powi(-52), "{reach}");
        }
        assert_eq!([SMALLEST, 0.0].map(Grid::finest), [Grid { size: SMALLEST }; 2]);
    }
}
