//! Many points in upright strips: what lies inside for sure, and the order from left to right.
//!
//! ```text
//!    │    │ ○──│────│    │      The highest and the lowest point of each strip (○) make two chains, convex as sides of
//!    │  ○─┼─  ·│ ·╲ │    │      a hull. Points below the upper and above the lower one lie inside of both chains: they
//!    │╱ · │ ·  │ · ╲│○   │      are no corners.
//!    ○────│○───│────┼────│
//! ```
//!
//! Chains are measured at both sides of a strip; between them a lower one is below the higher of the two places. What is
//! nearer to a chain than any rounding is left to the scan, which is exact.

use super::scan;
use crate::geometry::grouping::Groups;
use crate::geometry::interval::range;
use crate::geometry::predicates::{left_to_right, orientation};
use crate::plane::Point;
use crate::topology::NoObserver;
use std::cmp::Ordering;

/// Below so many points the scan itself is as fast.
const FEW: usize = 2_000;
/// Strips that chains are made of.
const MOST_STRIPS: usize = 4_096;
/// At most so many points are asked first whether a look at all of them pays.
const SAMPLE: usize = 1 << 16;
/// So many points are filled into strips of a few each; of more, strips of a crowd are made first.
const NEAR: usize = 1 << 15;
const CROWD: usize = 1 << 12;
/// How often a strip is cut into strips before its points are sorted by comparisons.
const LEVELS: usize = 3;
const NONE: u32 = u32::MAX;

/// Points with their numbers.
type Named = Vec<(Point, u32)>;

/// Strips of one width between the first and the last of some points.
struct Strips {
    left: f64,
    scale: f64,
    count: usize,
}

impl Strips {
    /// So many of them; none if points lie too near each other for that.
    fn new(points: impl Iterator<Item = Point>, count: usize) -> Option<Self> {
        let [left, right] = range(points.map(|p| p.x));
        let scale = count as f64 / (right - left);
        scale.is_finite().then_some(Self { left, scale, count })
    }

    /// How far right a place is, counted in strips.
    #[inline]
    fn along(&self, p: Point) -> f64 {
        (p.x - self.left) * self.scale
    }

    /// The strip of a place. Every step is monotone, so that a place further right never lies in an earlier strip.
    #[inline]
    fn of(&self, p: Point) -> usize {
        (self.along(p) as usize).min(self.count - 1)
    }
}

/// Those of some points that may be corners of their hull. O(n).
pub(super) fn outer(points: &[Point], which: Vec<u32>) -> Vec<u32> {
    if which.len() < FEW {
        return which;
    }
    // A sample makes chains that are nearly as far out, and tells whether they are worth a look at all points.
    let sample: Vec<Point> = which.iter().step_by(which.len().div_ceil(SAMPLE)).map(|&i| points[i as usize]).collect();
    let all = which.iter().map(|&i| points[i as usize]);
    let Some(strips) = Strips::new(all, MOST_STRIPS.min(sample.len() / 32)) else { return which };
    let inside = between_chains(&sample, &strips);
    let is_inside = |p: Point| {
        let [low, high] = inside[strips.of(p)];
        low < p.y && p.y < high
    };
    if sample.iter().filter(|&&p| is_inside(p)).count() < sample.len() / 8 {
        return which;
    }
    which.into_iter().filter(|&i| !is_inside(points[i as usize])).collect()
}

/// By strip, between which heights all of it lies between the two chains of these points.
fn between_chains(points: &[Point], strips: &Strips) -> Vec<[f64; 2]> {
    let mut extreme = vec![[NONE; 2]; strips.count];
    for (i, p) in (0..).zip(points) {
        let [low, high] = &mut extreme[strips.of(*p)];
        if *low == NONE || p.y < points[*low as usize].y {
            *low = i;
        }
        if *high == NONE || p.y > points[*high as usize].y {
            *high = i;
        }
    }
    let used = || extreme.iter().filter(|pair| pair[0] != NONE).map(|pair| pair.map(|i| (points[i as usize], i)));
    let mut lower: Named = used().map(|[low, _]| low).collect();
    let mut upper: Named = used().rev().map(|[_, high]| high).collect();
    scan(&mut lower, &mut NoObserver);
    scan(&mut upper, &mut NoObserver);
    upper.reverse();
    let margin = points.iter().fold(0.0_f64, |most, p| most.max(p.y.abs())) * 2f64.powi(-49);
    let heights = |strip: usize| {
        // A little beside the strip: by more than rounding moves any place along it.
        let (left, right) = (strip as f64 - 1e-6, strip as f64 + 1.0 + 1e-6);
        let [a, b] = [height(&lower, strips, left)?, height(&lower, strips, right)?];
        let [c, d] = [height(&upper, strips, left)?, height(&upper, strips, right)?];
        Some([a.max(b) + margin, c.min(d) - margin])
    };
    (0..strips.count).map(heights).map(|heights| heights.unwrap_or([f64::INFINITY, f64::NEG_INFINITY])).collect()
}

/// The height of a chain of points at a place along the strips, rounded; none beside its ends.
fn height(chain: &[(Point, u32)], strips: &Strips, along: f64) -> Option<f64> {
    let behind = chain.partition_point(|&(p, _)| strips.along(p) < along);
    let (&(a, _), &(b, _)) = (chain.get(behind.checked_sub(1)?)?, chain.get(behind)?);
    let (from, to) = (strips.along(a), strips.along(b));
    Some(a.y + (b.y - a.y) * ((along - from) / (to - from)))
}

/// Some points in the order in which the scan takes them: for its lower side and, if they are many, those that it needs
/// for the upper side. Then each side has the points on its own side of the line from the first to the last, and these.
pub(super) fn sides(points: &[Point], which: &[u32]) -> (Named, Option<Named>) {
    let at = |i: u32| points[i as usize];
    let named = which.iter().map(|&i| (at(i), i));
    let mut ends = which.first().map(|&i| [(at(i), i); 2]);
    if let Some([first, last]) = &mut ends {
        for (p, i) in named.clone() {
            if left_to_right(p, first.0).is_lt() {
                *first = (p, i);
            } else if left_to_right(p, last.0).is_gt() {
                *last = (p, i);
            }
        }
    }
    if which.len() >= FEW
        && let Some(ends @ [(first, _), (last, _)]) = ends
        && first != last
    {
        // The ends are on both sides.
        let (mut lower, mut upper) = (ends.to_vec(), ends.to_vec());
        for (p, i) in named {
            match orientation(first, last, p) {
                Ordering::Less => lower.push((p, i)),
                Ordering::Greater => upper.push((p, i)),
                // Between the two, a point on the line is no corner; beside them there is none.
                Ordering::Equal => {}
            }
        }
        return (sorted(lower), Some(sorted(upper)));
    }
    (sorted(named.collect()), None)
}

/// Points from left to right, those above each other from bottom to top, of equal ones the first. They stand beside each
/// other, so that a scan over them goes straight through memory. Expected O(n) when they are spread evenly,
/// O(n log n) always.
fn sorted(mut points: Named) -> Named {
    match by_strips(&points, if points.len() < FEW { 0 } else { LEVELS }) {
        None => {
            points.sort_unstable_by(in_order);
            points.dedup_by(|later, earlier| later.0 == earlier.0);
        }
        Some(mut groups) => {
            points.clear();
            (0..groups.count()).for_each(|strip| sort_into(groups.of_mut(strip), LEVELS - 1, &mut points));
        }
    }
    points
}

/// Appends points in order: strip by strip, the points of each in the same way, down to so many levels of strips.
fn sort_into(points: &mut [(Point, u32)], levels: usize, sorted: &mut Named) {
    match by_strips(points, levels) {
        None => {
            points.sort_unstable_by(in_order);
            sorted.extend(points.chunk_by(|a, b| a.0 == b.0).map(|equal| equal[0]));
        }
        Some(mut groups) => {
            (0..groups.count()).for_each(|strip| sort_into(groups.of_mut(strip), levels - 1, sorted));
        }
    }
}

/// Points by strips, unless they are few, too near each other, or no level of strips is left. A strip of many points has
/// room in a near cache, where its own strips can be filled out of order.
fn by_strips(points: &[(Point, u32)], levels: usize) -> Option<Groups<(Point, u32)>> {
    let count = if points.len() > NEAR { points.len() / CROWD } else { points.len() / 4 };
    if levels == 0 || count < 4 {
        return None;
    }
    let strips = Strips::new(points.iter().map(|&(p, _)| p), count)?;
    Some(Groups::new(count, points.iter().map(|&(p, i)| (strips.of(p), (p, i)))))
}

#[inline]
fn in_order(a: &(Point, u32), b: &(Point, u32)) -> Ordering {
    left_to_right(a.0, b.0).then(a.1.cmp(&b.1))
}
