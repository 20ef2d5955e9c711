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

use super::take_in;
use crate::geometry::grouping::Groups;
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
    fn new(points: &[Point], which: &[u32], count: usize) -> Option<Self> {
        let ends = |(low, high): (f64, f64), &i: &u32| (low.min(points[i as usize].x), high.max(points[i as usize].x));
        let (left, right) = which.iter().fold((f64::INFINITY, f64::NEG_INFINITY), ends);
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
    let Some(strips) = Strips::new(points, &which, MOST_STRIPS.min(sample.len() / 32)) else { return which };
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
    let (mut lower, mut upper) = (Vec::new(), Vec::new());
    take_in(used().map(|[low, _]| low), &mut lower, &mut NoObserver);
    take_in(used().rev().map(|[_, high]| high), &mut upper, &mut NoObserver);
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
    let by_place = |a: &u32, b: &u32| left_to_right(at(*a), at(*b));
    if which.len() >= FEW
        && let Some(&first) = which.iter().min_by(|a, b| by_place(a, b))
        && let Some(&last) = which.iter().rev().max_by(|a, b| by_place(a, b))
        && by_place(&first, &last).is_lt()
    {
        let (mut lower, mut upper) = (Vec::new(), Vec::new());
        for &i in which {
            match orientation(at(first), at(last), at(i)) {
                Ordering::Less => lower.push(i),
                Ordering::Greater => upper.push(i),
                // Between the two, a point on the line is no corner; beside them there is none.
                Ordering::Equal => {}
            }
        }
        let ends = |side: Vec<u32>| {
            let ends = [first, last].map(|i| (at(i), i));
            let between = sorted(points, &side);
            ends[..1].iter().copied().chain(between).chain(ends[1..].iter().copied()).collect()
        };
        return (ends(lower), Some(ends(upper)));
    }
    (sorted(points, which), None)
}

/// Some points with their numbers, from left to right, those above each other from bottom to top, of equal ones the first.
/// They stand beside each other, so that a scan over them goes straight through memory. Expected O(n) when they are
/// spread evenly, O(n log n) always.
fn sorted(points: &[Point], which: &[u32]) -> Named {
    let strips = if which.len() < FEW { None } else { Strips::new(points, which, which.len() / 4) };
    let named = which.iter().map(|&i| (points[i as usize], i));
    let mut sorted = Vec::with_capacity(which.len());
    let mut take = |together: &mut [(Point, u32)]| {
        together.sort_unstable_by(|a, b| left_to_right(a.0, b.0).then(a.1.cmp(&b.1)));
        sorted.extend(together.chunk_by(|a, b| a.0 == b.0).map(|equal| equal[0]));
    };
    match strips {
        None => take(&mut named.collect::<Vec<_>>()),
        Some(strips) => {
            let mut groups = Groups::new(strips.count, named.map(|(p, i)| (strips.of(p), (p, i))));
            (0..strips.count).for_each(|strip| take(groups.of_mut(strip)));
        }
    }
    sorted
}
