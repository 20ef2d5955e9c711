//! Equal points, without any order.
//!
//! ```text
//!   (2, 1)  (0, 0)  (2, 1)        a number mixed from the digits of a point says in which bucket it lies; equal
//!     │       │       │           points share theirs, and with it few others
//!   ┌─▼───────┼───────▼─┬─────────┐
//!   │ p0 p2   │   ▼     │         │
//!   └─────────┴───p1────┴─────────┘
//! ```
//!
//! Nothing depends on the mixed numbers but the time. A bucket that many points crowd into is sorted.

use super::grouping::grouped;
use super::predicates::sort_key;
use std::cmp::Ordering;

/// So many points are compared pair by pair; more are sorted.
pub(crate) const FEW: usize = 12;

/// Says that there is no such point.
pub(crate) const NONE: u32 = u32::MAX;

/// Points in buckets.
struct Buckets {
    starts: Vec<u32>,
    list: Vec<u32>,
    /// The bucket is what the mixed number has above so many bits.
    shift: u32,
}

impl Buckets {
    /// About a bucket for each point; those of one bucket in increasing order.
    fn new<P: Copy + Into<[f64; N]>, const N: usize>(points: &[P]) -> Self {
        let bits = points.len().max(2).next_power_of_two().trailing_zeros();
        let shift = u64::BITS - bits;
        let (starts, list) = grouped(1 << bits, points.len(), |i| (mixed(points[i].into()) >> shift) as usize);
        Self { starts, list, shift }
    }

    /// All buckets.
    fn all(&mut self) -> impl Iterator<Item = &mut [u32]> {
        let mut rest = &mut self.list[..];
        self.starts.windows(2).map(move |ends| {
            let (bucket, behind) = std::mem::take(&mut rest).split_at_mut((ends[1] - ends[0]) as usize);
            rest = behind;
            bucket
        })
    }

    /// The bucket of a point.
    #[inline]
    fn of<const N: usize>(&self, p: [f64; N]) -> &[u32] {
        let bucket = (mixed(p) >> self.shift) as usize;
        &self.list[self.starts[bucket] as usize..self.starts[bucket + 1] as usize]
    }
}

/// A number that is the same for equal points, and looks random.
#[inline]
fn mixed<const N: usize>(p: [f64; N]) -> u64 {
    p.iter().fold(0x9e37_79b9_7f4a_7c15, |mixed: u64, x| {
        // -0 + 0 = 0. Of a product the middle digits depend on all digits of both.
        let product = u128::from(mixed ^ (x + 0.0).to_bits()) * 0xd6e8_feb8_6659_fd93;
        (product ^ (product >> 64)) as u64
    })
}

#[inline]
fn are_equal<const N: usize>(p: [f64; N], q: [f64; N]) -> bool {
    p.partial_cmp(&q) == Some(Ordering::Equal)
}

/// For each point the number of the first one with the same coordinates, where -0 = 0.
///
/// Cost: expected O(n); O(n log n) at worst.
pub(crate) fn first_of_equals<P: Copy + Into<[f64; N]>, const N: usize>(points: &[P]) -> Vec<u32> {
    let mut first_of: Vec<u32> = vec![0; points.len()];
    let at = |i: u32| -> [f64; N] { points[i as usize].into() };
    for bucket in Buckets::new(points).all() {
        if bucket.len() > FEW {
            of_crowd(bucket, |i| at(i).map(sort_key), &mut first_of, |_| {});
            continue;
        }
        for (place, &i) in bucket.iter().enumerate() {
            let same = bucket[..place].iter().find(|&&other| are_equal(at(other), at(i)));
            first_of[i as usize] = same.map_or(i, |&other| first_of[other as usize]);
        }
    }
    first_of
}

/// Finds equal points among many: by a sort. Gives the first one of each place to `found`.
pub(crate) fn of_crowd<K: Ord>(
    crowd: &mut [u32],
    key: impl Fn(u32) -> K,
    first_of: &mut [u32],
    mut found: impl FnMut(u32),
) {
    crowd.sort_unstable_by_key(|&i| (key(i), i));
    for same in crowd.chunk_by(|&i, &j| key(i) == key(j)) {
        same.iter().for_each(|&i| first_of[i as usize] = same[0]);
        found(same[0]);
    }
}

/// For each of some distinct points the number of the one with the same coordinates among other distinct points, else
/// [`NONE`].
///
/// Cost: expected O(n + k) for k points among n; O((n + k) log k) at worst.
pub(crate) fn equals_among<P: Copy + Into<[f64; N]>, const N: usize>(some: &[P], others: &[P]) -> Vec<u32> {
    let mut equal = vec![NONE; some.len()];
    if some.is_empty() {
        return equal;
    }
    let mut buckets = Buckets::new(some);
    let at = |i: u32| -> [f64; N] { some[i as usize].into() };
    let key = |p: [f64; N]| p.map(sort_key);
    buckets.all().filter(|bucket| bucket.len() > FEW).for_each(|bucket| bucket.sort_unstable_by_key(|&i| key(at(i))));
    for (other, &p) in (0..).zip(others) {
        let p: [f64; N] = p.into();
        let bucket = buckets.of(p);
        let found = if bucket.len() > FEW {
            bucket.binary_search_by_key(&key(p), |&i| key(at(i))).ok()
        } else {
            bucket.iter().position(|&i| are_equal(at(i), p))
        };
        if let Some(place) = found {
            equal[bucket[place] as usize] = other;
        }
    }
    equal
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::point::Point;
    use crate::geometry::random::xorshift;

    #[test]
    fn equal_points_are_those_of_all_pairs() {
        let mut found = 0;
        for seed in 1..120_u64 {
            let mut random = xorshift(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15));
            let mut next = |below: u64| (random() >> 20) % below;
            let values = [-0.0, 0.0, 1.0, -1.0, 0.1, 1e-300, 1e300, 2.0];
            let points: Vec<[f64; 3]> =
                (0..next(90)).map(|_| [0; 3].map(|_| values[next(values.len() as u64) as usize])).collect();
            let first = |i: usize| points.iter().position(|&p| are_equal(p, points[i])).unwrap_or(i) as u32;
            let expected: Vec<u32> = (0..points.len()).map(first).collect();
            assert_eq!(first_of_equals(&points), expected, "seed {seed}");

            let flat: Vec<Point> = points.iter().map(|&[x, y, _]| Point::new(x, y)).collect();
            let first = first_of_equals(&flat);
            let distinct: Vec<Point> = (0..flat.len()).filter(|&i| first[i] as usize == i).map(|i| flat[i]).collect();
            let (some, others) = distinct.split_at(next(distinct.len() as u64 + 1) as usize);
            let some: Vec<Point> = some.iter().chain(others.iter().filter(|_| next(3) == 0)).copied().collect();
            let among = |p: &Point| others.iter().position(|q| q == p).map_or(NONE, |i| i as u32);
            let expected: Vec<u32> = some.iter().map(among).collect();
            assert_eq!(equals_among(&some, others), expected, "seed {seed}");
            found += expected.iter().filter(|&&i| i != NONE).count();
        }
        assert!(found > 500, "{found}");
    }

    #[test]
    fn points_that_crowd_into_one_bucket_are_found_as_well() {
        let all: Vec<[f64; 2]> = (0..40_000).map(|i| [f64::from(i), 0.5]).collect();
        // So many buckets as for 100 points, and the points of one of them.
        let buckets = Buckets::new(&all[..100]);
        let shift = buckets.shift;
        let mut crowd: Vec<[f64; 2]> = all.iter().copied().filter(|&p| mixed(p) >> shift == 3).take(100).collect();
        assert_eq!(crowd.len(), 100);
        assert_eq!(Buckets::new(&crowd).of(crowd[0]).len(), 100);
        let order: Vec<u32> = (0..100).collect();
        assert_eq!(equals_among(&crowd, &crowd), order);
        assert_eq!(first_of_equals(&crowd), order);
        assert_eq!(equals_among(&crowd[..50], &crowd[20..]), [vec![NONE; 20], (0..30).collect()].concat());
        crowd[70] = crowd[7];
        assert_eq!(first_of_equals(&crowd)[70], 7);
    }
}
