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

use crate::figure::canvas::vector::{Bounds, Xy, doubled_area, segment_distance, xy};
use crate::figure::layout::crowd::Shape;
use std::cmp::Ordering;
use std::collections::BinaryHeap;
use std::ops::Range;

/// Loss for each px between the label and the centroid.
const PULL: f64 = 0.03;
/// A cell that promises less than this over the best is dropped.
const PRECISION: f64 = 0.25;
/// The search ends after so many cells, whatever it has, and earlier in a region with very many points.
const CELLS: usize = 1500;
/// Cells times points and obstacles of one search.
const EFFORT: usize = 20_000_000;

/// More than distances on a canvas are wrong by.
const ROUNDING: f64 = 1e-6;

/// A place for a label.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Pole {
    pub(crate) at: Xy,
    /// Distance to the nearest ring or obstacle, measured after squeezing x.
    pub(crate) clearance: f64,
}

/// The region and what stands in it, all x divided by the squeeze.
struct Field {
    /// Of all rings.
    sides: Vec<(Xy, Xy)>,
    obstacles: Vec<Shape>,
    centroid: Xy,
    enough: f64,
}

struct Cell {
    centre: Xy,
    half: f64,
    bound: f64,
    /// Which of the lists of the search names all that can be nearest to a point of the cell.
    near: Range<usize>,
}

impl Cell {
    /// From the centre to a corner.
    fn radius(&self) -> f64 {
        self.half * std::f64::consts::SQRT_2
    }
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
    /// Of side `i`, or of the obstacle that many numbers after the last side.
    fn distance(&self, i: u32, p: Xy) -> f64 {
        let i = i as usize;
        match self.sides.get(i) {
            Some(&(a, b)) => segment_distance(p, a, b),
            None => self.obstacles[i - self.sides.len()].distance(p),
        }
    }

    fn is_inside(&self, p: Xy) -> bool {
        let is_right =
            |(a, b): &&(Xy, Xy)| (a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x;
        self.sides.iter().filter(is_right).count() % 2 == 1
    }

    /// Positive inside the rings (even-odd) and outside all obstacles. `near` names, in ascending order, the sides
    /// and obstacles that can be nearest.
    fn clearance(&self, p: Xy, near: &[u32]) -> f64 {
        let (sides, obstacles) = near.split_at(near.partition_point(|&i| (i as usize) < self.sides.len()));
        let nearest = |start: f64, list: &[u32]| list.iter().map(|&i| self.distance(i, p)).fold(start, f64::min);
        let nearest_side = nearest(f64::INFINITY, sides);
        if self.is_inside(p) { nearest(nearest_side, obstacles) } else { -nearest_side }
    }

    fn value(&self, p: Xy, clearance: f64) -> f64 {
        clearance.min(self.enough) - PULL * (p - self.centroid).length()
    }
}

/// The best place in the region, or `None` if no place inside was found. `enough` is the clearance beyond
/// which only the distance to the centroid counts. At most 1500 cells, each O(points + those obstacles that can be
/// nearest in the cell it is a quarter of).
pub(crate) fn pole(rings: &[Vec<Xy>], obstacles: &[Shape], squeeze: f64, enough: f64) -> Option<Pole> {
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
    let before = |ring: &Vec<Xy>| ring.last().copied().into_iter().chain(ring.iter().copied()).collect::<Vec<Xy>>();
    let sides = rings.iter().flat_map(|ring| before(ring).into_iter().zip(ring.iter().copied())).collect();
    let field = Field { sides, obstacles, centroid, enough };

    let size = bounds.size();
    let side = size.x.min(size.y).max(size.x.max(size.y) / 32.0);
    if side <= 0.0 {
        return None;
    }
    let mut search = Search::new(field);
    let all = 0..search.near.len();
    let count = |length: f64| ((length / side).ceil() as usize).max(1);
    for row in 0..count(size.y) {
        for column in 0..count(size.x) {
            let step = xy((column as f64 + 0.5) * side, (row as f64 + 0.5) * side);
            search.visit(bounds.min + step, 0.5 * side, all.clone());
        }
    }
    for _ in 0..CELLS.min(EFFORT / all.len().max(1)) / 4 {
        let Some(cell) = search.open.pop() else { break };
        if cell.bound <= search.most + PRECISION {
            break;
        }
        let near = search.narrow(&cell);
        let half = 0.5 * cell.half;
        for (dx, dy) in [(-half, -half), (half, -half), (-half, half), (half, half)] {
            search.visit(cell.centre + xy(dx, dy), half, near.clone());
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
    /// Lists of sides and obstacles, the first with all of them.
    near: Vec<u32>,
}

impl Search {
    fn new(field: Field) -> Self {
        let near: Vec<u32> = (0..(field.sides.len() + field.obstacles.len()) as u32).collect();
        let best = Pole { at: field.centroid, clearance: field.clearance(field.centroid, &near) };
        Self { most: field.value(best.at, best.clearance), field, best, open: BinaryHeap::new(), near }
    }

    fn visit(&mut self, centre: Xy, half: f64, near: Range<usize>) {
        let clearance = self.field.clearance(centre, &self.near[near.clone()]);
        let value = self.field.value(centre, clearance);
        if value > self.most {
            (self.best, self.most) = (Pole { at: centre, clearance }, value);
        }
        let mut cell = Cell { centre, half, bound: 0.0, near };
        let nearest = ((centre - self.field.centroid).length() - cell.radius()).max(0.0);
        cell.bound = (clearance + cell.radius()).min(self.field.enough) - PULL * nearest;
        if cell.bound > self.most + PRECISION {
            self.open.push(cell);
        }
    }

    /// A list for the quarters of a cell. What is nearest to the centre at d is at most d + r away from any other
    /// point of the cell, and what is more than d + 2r away from the centre is further from it than that.
    fn narrow(&mut self, cell: &Cell) -> Range<usize> {
        let nearest = self.field.clearance(cell.centre, &self.near[cell.near.clone()]).abs();
        let reach = nearest + 2.0 * cell.radius() + ROUNDING;
        let start = self.near.len();
        for at in cell.near.clone() {
            let i = self.near[at];
            if self.field.distance(i, cell.centre) <= reach {
                self.near.push(i);
            }
        }
        start..self.near.len()
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
pub(crate) fn area(rings: &[Vec<Xy>]) -> f64 {
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
    fn nothing_near_is_forgotten_on_the_way_to_a_place() {
        let square = ring(&[(0.0, 200.0), (200.0, 200.0), (200.0, 0.0), (0.0, 0.0)]);
        // Short strokes at every slope, the slope and the start by multiples of two numbers without a common factor.
        let stroke = |i: usize| {
            let from = xy((i * 71 % 197) as f64, (i * 113 % 199) as f64);
            Shape::Segment(from, from + xy((i * 7 % 23) as f64 - 11.0, (i * 5 % 19) as f64 - 9.0), 1.0)
        };
        for count in [3, 30, 120, 500] {
            let strokes: Vec<Shape> = (0..count).map(stroke).collect();
            let found = pole(std::slice::from_ref(&square), &strokes, 1.0, 60.0).unwrap();
            let border = [found.at.x, 200.0 - found.at.x, found.at.y, 200.0 - found.at.y];
            let walls = border.into_iter().chain(strokes.iter().map(|shape| shape.distance(found.at)));
            let nearest = walls.fold(f64::INFINITY, f64::min);
            assert!((found.clearance - nearest).abs() < 1e-9, "{count} strokes: {found:?}, {nearest}");
        }
    }

    #[test]
    fn regions_without_area_have_no_place() {
        assert_eq!(pole(&[], &[], 1.0, 22.0), None);
        assert_eq!(pole(&[ring(&[(5.0, 5.0)])], &[], 1.0, 22.0), None);
        assert_eq!(pole(&[ring(&[(5.0, 5.0), (9.0, 9.0)])], &[], 1.0, 22.0), None);
    }
}
