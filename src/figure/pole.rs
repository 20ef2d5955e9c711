//! The best place for a label inside a face: far from everything, yet near the middle.
//!
//! ```text
//!   ┌───────────┬───────────┐
//!   │           │  ┌──┬──┐  │      maximise  min(clearance, enough) - 0.03 · distance to the centroid
//!   │     ·     │  ├──┼──┤  │
//!   │           │  └──┴──┘  │      A square cell of half-side s cannot beat the value at its centre by
//!   ├───────────┼───────────┤      more than 1.03 · s√2: split the most promising cell, drop the hopeless.
//!   │     ·     │     ·     │
//!   └───────────┴───────────┘
//! ```
//!
//! The cap and the pull to the centroid make the place unique where the pure pole of inaccessibility is not
//! (in a trapezoid, for example). Wide labels are handled by squeezing x before the search.
//!
//! Source: the quadtree search of Agafonkin's *polylabel*, 2016, with another objective.

use super::crowd::Shape;
use super::vector::{Bounds, Xy, doubled_area, segment_distance, xy};
use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// Loss for each px between the label and the centroid.
const PULL: f64 = 0.03;
/// A cell that promises less than this over the best is dropped.
const PRECISION: f64 = 0.25;
/// The search ends after so many cells, whatever it has, and earlier in a region with very many points.
const CELLS: usize = 1500;
/// Cells times points and obstacles of one search.
const EFFORT: usize = 20_000_000;

/// A place for a label.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Pole {
    pub(super) at: Xy,
    /// Distance to the nearest ring or obstacle, measured after squeezing x.
    pub(super) clearance: f64,
}

/// The region and what stands in it; `squeeze` >= 1 divides all x.
struct Field {
    rings: Vec<Vec<Xy>>,
    obstacles: Vec<Shape>,
    centroid: Xy,
    enough: f64,
}

struct Cell {
    centre: Xy,
    half: f64,
    bound: f64,
}

impl PartialEq for Cell {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Cell {}

impl PartialOrd for Cell {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Cell {
    fn cmp(&self, other: &Self) -> Ordering {
        let position = |a: &Self, b: &Self| a.centre.x.total_cmp(&b.centre.x).then(a.centre.y.total_cmp(&b.centre.y));
        self.bound.total_cmp(&other.bound).then_with(|| position(other, self))
    }
}

impl Field {
    /// Positive inside the rings (even-odd) and outside all obstacles.
    fn clearance(&self, p: Xy) -> f64 {
        let (mut inside, mut nearest) = (false, f64::INFINITY);
        for ring in &self.rings {
            let Some(&last) = ring.last() else { continue };
            let mut a = last;
            for &b in ring {
                if (a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x {
                    inside = !inside;
                }
                nearest = nearest.min(segment_distance(p, a, b));
                a = b;
            }
        }
        if !inside {
            return -nearest;
        }
        self.obstacles.iter().map(|shape| shape.distance(p)).fold(nearest, f64::min)
    }

    fn value(&self, p: Xy, clearance: f64) -> f64 {
        clearance.min(self.enough) - PULL * (p - self.centroid).length()
    }

    fn cell(&self, centre: Xy, half: f64) -> (Cell, Pole, f64) {
        let clearance = self.clearance(centre);
        let radius = half * std::f64::consts::SQRT_2;
        let nearest = ((centre - self.centroid).length() - radius).max(0.0);
        let bound = (clearance + radius).min(self.enough) - PULL * nearest;
        (Cell { centre, half, bound }, Pole { at: centre, clearance }, self.value(centre, clearance))
    }
}

/// The best place in the region, or `None` if no place inside was found. `enough` is the clearance beyond
/// which only the distance to the centroid counts. O(points + obstacles) for each of at most 1500 cells.
pub(super) fn pole(rings: &[Vec<Xy>], obstacles: &[Shape], squeeze: f64, enough: f64) -> Option<Pole> {
    let squeezed = |p: Xy| xy(p.x / squeeze, p.y);
    let rings: Vec<Vec<Xy>> = rings.iter().map(|ring| ring.iter().copied().map(squeezed).collect()).collect();
    let bounds = Bounds::of(rings.iter().flatten().copied())?;
    let obstacles = obstacles.iter().map(|&shape| match shape {
        Shape::Segment(a, b, half) => Shape::Segment(squeezed(a), squeezed(b), half),
        Shape::Box(b) => Shape::Box(Bounds { min: squeezed(b.min), max: squeezed(b.max) }),
        Shape::Disc(centre, radius) => Shape::Disc(squeezed(centre), radius),
    });
    let obstacles = obstacles.collect();
    let centroid = centroid(&rings).unwrap_or_else(|| bounds.centre());
    let field = Field { rings, obstacles, centroid, enough };

    let size = bounds.size();
    let side = size.x.min(size.y).max(size.x.max(size.y) / 32.0);
    if side <= 0.0 {
        return None;
    }
    let (_, best, most) = field.cell(centroid, 0.0);
    let mut search = Search { field, best, most, open: BinaryHeap::new() };
    let count = |length: f64| ((length / side).ceil() as usize).max(1);
    for row in 0..count(size.y) {
        for column in 0..count(size.x) {
            let step = xy((column as f64 + 0.5) * side, (row as f64 + 0.5) * side);
            search.visit(bounds.min + step, 0.5 * side);
        }
    }
    let weight = search.field.rings.iter().map(Vec::len).sum::<usize>() + search.field.obstacles.len();
    for _ in 0..CELLS.min(EFFORT / weight.max(1)) / 4 {
        let Some(cell) = search.open.pop() else { break };
        if cell.bound <= search.most + PRECISION {
            break;
        }
        let half = 0.5 * cell.half;
        for (dx, dy) in [(-half, -half), (half, -half), (-half, half), (half, half)] {
            search.visit(cell.centre + xy(dx, dy), half);
        }
    }
    let best = search.best;
    (best.clearance > 0.0).then(|| Pole { at: xy(best.at.x * squeeze, best.at.y), ..best })
}

/// The best place so far and the cells that may hold a better one.
struct Search {
    field: Field,
    best: Pole,
    most: f64,
    open: BinaryHeap<Cell>,
}

impl Search {
    fn visit(&mut self, centre: Xy, half: f64) {
        let (cell, pole, value) = self.field.cell(centre, half);
        if value > self.most {
            (self.best, self.most) = (pole, value);
        }
        if cell.bound > self.most + PRECISION {
            self.open.push(cell);
        }
    }
}

/// The centre of mass of the region, if it has an area. Rings of holes run the other way round and so count
/// as negative.
fn centroid(rings: &[Vec<Xy>]) -> Option<Xy> {
    let (mut area, mut moment) = (0.0, Xy::default());
    let base = *rings.first()?.first()?;
    for ring in rings {
        let mut a = *ring.last()?;
        for &b in ring {
            let turn = (a - base).turn(b - base);
            area += turn;
            moment = moment + (a + b + base) * turn;
            a = b;
        }
    }
    (area.abs() > 1e-6).then(|| moment * (1.0 / (3.0 * area)))
}

/// The area of the region in px², rings of holes taken off.
pub(super) fn area(rings: &[Vec<Xy>]) -> f64 {
    0.5 * rings.iter().map(|ring| doubled_area(ring)).sum::<f64>().abs()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ring(points: &[(f64, f64)]) -> Vec<Xy> {
        points.iter().map(|&(x, y)| xy(x, y)).collect()
    }

    #[test]
    fn in_a_symmetric_trapezoid_the_label_is_on_the_axis() {
        let trapezoid = ring(&[(0.0, 100.0), (300.0, 100.0), (200.0, 0.0), (100.0, 0.0)]);
        let pole = pole(&[trapezoid], &[], 1.0, 22.0).unwrap();
        assert!((pole.at.x - 150.0).abs() < 0.5, "{pole:?}");
        assert!(pole.clearance >= 22.0);
    }

    #[test]
    fn a_hole_in_the_middle_is_avoided() {
        let outer = ring(&[(0.0, 100.0), (100.0, 100.0), (100.0, 0.0), (0.0, 0.0)]);
        let hole = ring(&[(30.0, 30.0), (70.0, 30.0), (70.0, 70.0), (30.0, 70.0)]);
        let pole = pole(&[outer, hole], &[], 1.0, 22.0).unwrap();
        let aside = |v: f64| !(30.0..=70.0).contains(&v);
        assert!((aside(pole.at.x) || aside(pole.at.y)) && pole.clearance > 14.0, "{pole:?}");
    }

    #[test]
    fn a_wide_label_prefers_the_wide_room() {
        // A tall tower of width 60 on a base of 300 x 40: the tower has more clearance, the base more width.
        let tower = ring(&[(0.0, 200.0), (300.0, 200.0), (300.0, 160.0), (60.0, 160.0), (60.0, 0.0), (0.0, 0.0)]);
        let narrow = pole(std::slice::from_ref(&tower), &[], 1.0, 30.0).unwrap();
        let wide = pole(&[tower], &[], 5.0, 30.0).unwrap();
        assert!(narrow.at.x < 60.0 && wide.at.y > 160.0, "{narrow:?} {wide:?}");
    }

    #[test]
    fn regions_without_area_have_no_place() {
        assert_eq!(pole(&[], &[], 1.0, 22.0), None);
        assert_eq!(pole(&[ring(&[(5.0, 5.0)])], &[], 1.0, 22.0), None);
        assert_eq!(pole(&[ring(&[(5.0, 5.0), (9.0, 9.0)])], &[], 1.0, 22.0), None);
    }
}
