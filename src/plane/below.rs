//! The edges directly below some points, without a sweep.
//!
//! ```text
//!        ●───────●            Few points asked for, from left to right: p q. Each edge knows by two counts which of them it
//!            p                passes above or below; of those below a point the highest is kept.
//!     ●───────────────●
//!          q ●                Counts of points asked for up to the left and up to the right end of an edge: 0 and 2
//!     ●──────────●            for the lowest.
//!
//!     ┌───┬───┬───┐
//!     │   │ p │   │           Many points: every edge is in the lists of the cells of a grid that it passes. From the cell of
//!     ├───┼─┆─┼──╱┤           a point the lists are gone through downwards, to the first cell that the highest edge
//!     │   │ ┆╱│   │           below the point passes below it.
//!     └───┴───┴───┘
//! ```

use super::Point;
use super::meet::{Cells, Frame, MARGIN};
use super::sweep::{NOTHING, is_above, rightwards, sweep, sweep_in_order};
use crate::geometry::both::of_both;
use crate::geometry::grouping::Groups;
use crate::geometry::point::corners;
use crate::geometry::predicates::{is_left_of, left_to_right, orientation};

/// So many edges above and below points are looked at for each edge; a sweep is quicker than more of them.
const MOST: usize = 4;

/// So many points are few.
pub(super) const FEW: usize = 64;

/// So many edges for each cell of the grid.
const SOME: usize = 3;

/// For each point asked for, each once, the edge directly below it, else [`NOTHING`]; for all other points some answer. The edges meet at
/// common ends only; `by_place` holds all points from left to right, if their order is known.
///
/// Cost: O(n) for n edges, where they are about as long as they are apart, or where few of them pass above or below points
/// asked for; else O(n log n).
pub(super) fn edges_below(
    points: &[Point],
    edges: &[[u32; 2]],
    by_place: Option<&[u32]>,
    asked: impl Iterator<Item = u32>,
) -> Vec<u32> {
    let mut asked: Vec<u32> = asked.collect();
    // Nothing lies below the first point of all. Whoever has one component asks for that point alone.
    if let &[p] = &asked[..]
        && points.iter().all(|&q| !is_left_of(q, points[p as usize]))
    {
        asked.clear();
    }
    if asked.is_empty() {
        return vec![NOTHING; points.len()];
    }
    // Where the order is known, or few points are asked for, they are counted up to each other point at little cost.
    let by_counts =
        if by_place.is_some() || asked.len() <= FEW { by_counts(points, edges, by_place, &mut asked) } else { None };
    by_counts.or_else(|| by_cells(points, edges, &asked)).unwrap_or_else(|| match by_place {
        Some(by_place) => sweep_in_order(points, edges, by_place, false, |_| ()).below,
        None => sweep(points, edges, &asked, false).below,
    })
}

/// The same, for which it puts the points asked for in order; nothing if edges pass above or below them too often.
fn by_counts(points: &[Point], edges: &[[u32; 2]], by_place: Option<&[u32]>, asked: &mut [u32]) -> Option<Vec<u32>> {
    asked.sort_unstable_by(|&p, &q| left_to_right(points[p as usize], points[q as usize]));
    // By point, how many of those asked for come up to it.
    let count = match by_place {
        Some(by_place) => {
            let mut count = vec![0; points.len()];
            let mut sum = 0;
            for p in by_place {
                sum += u32::from(asked.get(sum as usize) == Some(p));
                count[*p as usize] = sum;
            }
            count
        }
        None => {
            let up_to = |&p: &Point| asked.partition_point(|&q| left_to_right(points[q as usize], p).is_le());
            points.iter().map(|p| up_to(p) as u32).collect()
        }
    };
    let passed = |ends: &[u32; 2]| {
        let [a, b] = of_both(*ends, |p| count[p as usize]);
        a.min(b) as usize..a.max(b) as usize
    };
    let work: usize = edges.iter().map(|ends| passed(ends).len()).sum();
    if work > MOST * edges.len() {
        return None;
    }
    let mut below = Below::new(points, rightwards(points, edges));
    for (e, edge) in (0..).zip(edges) {
        asked[passed(edge)].iter().for_each(|&p| below.may_be(e, p));
    }
    Some(below.of)
}

/// The same for points in any order; nothing if edges pass too many cells.
fn by_cells(points: &[Point], edges: &[[u32; 2]], asked: &[u32]) -> Option<Vec<u32>> {
    let most = 16 * (edges.len() + asked.len());
    let mut below = Below::new(points, rightwards(points, edges));
    let [low, high] = corners(points.iter().copied());
    let offset = |p: u32| [points[p as usize].x - low.x, points[p as usize].y - low.y];
    let frame = Frame { low: [0.0; 2], size: [high.x - low.x, high.y - low.y] };
    let (mut wide, mut tall) = (0.0, 0.0);
    for ends in edges {
        let [[a, b], [c, d]] = of_both(*ends, offset);
        (wide, tall) = (wide + (a - c).abs(), tall + (b - d).abs());
    }
    let mean = of_both([wide, tall], |sum| sum / edges.len() as f64);
    let cells = Cells::new(&frame, frame.sides(edges.len() / SOME, mean, frame.finest()));
    let [columns, rows] = cells.count;
    // The cells of each edge, row by row: from one to another.
    let mut runs: Vec<[u32; 3]> = Vec::with_capacity(edges.len());
    let mut steps = columns * rows / 4;
    for (e, ends) in (0..).zip(edges) {
        cells.rows_of(of_both(*ends, offset), |row, first, last| {
            runs.push([(row * columns + first) as u32, (row * columns + last) as u32, e]);
            steps += 1 + last - first;
        });
        if steps > most {
            return None;
        }
    }
    let passed = runs.iter().flat_map(|&[first, last, e]| (first as usize..=last as usize).map(move |cell| (cell, e)));
    let lists = Groups::new(columns * rows, passed);
    drop(runs);
    // By cell, the next one below that edges pass.
    let mut next = vec![NOTHING; columns * rows];
    for cell in columns..next.len() {
        let below = cell - columns;
        next[cell] = if lists.of(below).is_empty() { next[below] } else { below as u32 };
    }
    for &p in asked {
        let place = cells.place(offset(p));
        let [column, row] = of_both([0, 1], |i: usize| (place[i] as usize).min(cells.count[i] - 1));
        let mut cell = row * columns + column;
        loop {
            let list = lists.of(cell);
            list.iter().for_each(|&e| below.may_be(e, p));
            steps += 1 + list.len();
            // Whatever passes between the edge and the point passes this cell, or one above it.
            let bottom = (cell / columns) as f64 + MARGIN;
            if next[cell] == NOTHING || below.height(p, low).is_some_and(|y| cells.place([0.0, y])[1] > bottom) {
                break;
            }
            cell = next[cell] as usize;
        }
        if steps > most {
            return None;
        }
    }
    Some(below.of)
}

/// The highest edges below points, of those that were looked at.
struct Below<'a> {
    points: &'a [Point],
    /// From left to right.
    edges: Vec<[u32; 2]>,
    of: Vec<u32>,
}

impl<'a> Below<'a> {
    fn new(points: &'a [Point], edges: Vec<[u32; 2]>) -> Self {
        Self { points, edges, of: vec![NOTHING; points.len()] }
    }

    #[inline]
    fn ends(&self, edge: u32) -> [Point; 2] {
        of_both(self.edges[edge as usize], |p| self.points[p as usize])
    }

    /// An edge that may be the one below a point.
    #[inline]
    fn may_be(&mut self, edge: u32, point: u32) {
        let ([a, b], p) = (self.ends(edge), self.points[point as usize]);
        let passes = left_to_right(a, p).is_lt() && left_to_right(p, b).is_le();
        if !passes || !orientation(a, b, p).is_gt() {
            return;
        }
        let best = self.of[point as usize];
        if best == NOTHING || is_above([a, b], self.ends(best)) {
            self.of[point as usize] = edge;
        }
    }

    /// How high the edge below a point is there, above the lowest point of all; rounded.
    fn height(&self, point: u32, low: Point) -> Option<f64> {
        let edge = Some(self.of[point as usize]).filter(|&edge| edge != NOTHING)?;
        let [a, b] = self.ends(edge);
        Some((a.y - low.y) + (b.y - a.y) * ((self.points[point as usize].x - a.x) / (b.x - a.x)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plane::sweep::tests::numbers;
    use crate::plane::{ArrangeOptions, Subdivision};

    #[test]
    fn some_points_have_the_same_edge_below_as_all_of_them() {
        let (mut found, mut swept, mut in_cells) = ([0; 2], [0; 2], [0; 2]);
        for seed in 1..400_u64 {
            let mut next = numbers(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15));
            let count = 2 + next(40);
            // Many points above each other, and upright edges.
            let mut place = || Point::new(next(9) as f64, next(9) as f64 / 2.0);
            let segments: Vec<[Point; 2]> = (0..count).map(|_| [place(), place()]).collect();
            let options = ArrangeOptions { merge: true, split: true, ..ArrangeOptions::default() };
            let s = Subdivision::arrange_segments(&segments, &options).unwrap().subdivision;
            let points: Vec<Point> = s.vertices().map(|v| s.point(v)).collect();
            let edges: Vec<[u32; 2]> = s.edges().map(|e| s.edge_ends(e).map(crate::ids::VertexId::number)).collect();
            let mut by_place: Vec<u32> = (0..points.len() as u32).collect();
            by_place.sort_by(|&a, &b| left_to_right(points[a as usize], points[b as usize]));
            let all = sweep_in_order(&points, &edges, &by_place, false, |_| ()).below;
            let share = 1 + next(12);
            let asked: Vec<u32> = by_place.iter().copied().filter(|_| next(share) == 0).collect();
            for (way, known) in [Some(&by_place[..]), None].into_iter().enumerate() {
                let some = edges_below(&points, &edges, known, asked.iter().copied());
                for &p in &asked {
                    assert_eq!(some[p as usize], all[p as usize], "seed {seed}, point {p}");
                    found[way] += u32::from(some[p as usize] != NOTHING);
                }
                swept[way] += u32::from(some == all);
            }
            let Some(some) = by_cells(&points, &edges, &asked) else { continue };
            for &p in &asked {
                assert_eq!(some[p as usize], all[p as usize], "seed {seed}, point {p} in its cells");
                in_cells[usize::from(all[p as usize] == NOTHING)] += 1;
            }
        }
        for (found, swept) in found.into_iter().zip(swept) {
            assert!(found > 1_000 && swept > 20 && swept < 380, "{found} {swept}");
        }
        assert!(in_cells[0] > 1_000 && in_cells[1] > 100, "{in_cells:?}");
    }

    /// Long edges side by side are all in the same few cells, and each of them passes all points: that is left to a sweep.
    #[test]
    fn points_between_long_edges_have_the_next_one_below() {
        for count in [40_u32, 90] {
            let mut points: Vec<Point> =
                (0..=count).flat_map(|i| [0.0, 100.0].map(|x| Point::new(x, x + f64::from(i)))).collect();
            let edges: Vec<[u32; 2]> = (0..=count).map(|i| [2 * i + i % 2, 2 * i + 1 - i % 2]).collect();
            let first = points.len() as u32;
            let xs = (0..count).map(|i| f64::from(1 + i * 37 % 99));
            points.extend((0..count).zip(xs).map(|(i, x)| Point::new(x, x + f64::from(i) + 0.5)));
            let asked: Vec<u32> = (first..points.len() as u32).collect();
            assert!(by_cells(&points, &edges, &asked).is_none() && asked.len() > 32);
            let mut by_place: Vec<u32> = (0..points.len() as u32).collect();
            by_place.sort_by(|&p, &q| left_to_right(points[p as usize], points[q as usize]));
            for known in [None, Some(&by_place[..])] {
                assert!(by_counts(&points, &edges, known, &mut asked.clone()).is_none());
                let below = edges_below(&points, &edges, known, asked.iter().copied());
                assert_eq!(below[first as usize..], (0..count).collect::<Vec<_>>()[..]);
            }
        }
    }
}
