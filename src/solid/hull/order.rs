//! The order in which points come: random from half to half, near each other within each half.
//!
//! ```text
//!   shuffled:   | 1 | 1 | 2  | 4      | 8                | n/2                                |
//!                                      each stretch sorted along a curve that fills space
//! ```

use crate::geometry::interval::range;
use crate::geometry::random;

/// Calls `add` once for every point that is wanted. Expected O(n log n). The same points come in the same order every
/// time, whichever others are wanted.
pub(super) fn order(points: &[[f64; 3]], wanted: impl Fn(u32) -> bool, mut add: impl FnMut(u32)) {
    let mut shuffled: Vec<u32> = (0..points.len() as u32).collect();
    let mut seed = 0;
    for i in (1..shuffled.len()).rev() {
        shuffled.swap(i, (random::next(&mut seed) % (i as u64 + 1)) as usize);
    }
    let place = places(points);
    let mut start = 0;
    let mut keyed = Vec::new();
    while start < shuffled.len() {
        let end = (2 * start).clamp(start + 1, shuffled.len());
        keyed.clear();
        let wanted = shuffled[start..end].iter().filter(|&&p| wanted(p));
        keyed.extend(wanted.map(|&p| (place(points[p as usize]), p)));
        keyed.sort_unstable();
        keyed.iter().for_each(|&(_, p)| add(p));
        start = end;
    }
}

/// The place of a point along a curve through 1024³ cells (Morton, 1966).
pub(in crate::solid) fn places(points: &[[f64; 3]]) -> impl Fn([f64; 3]) -> u32 + use<> {
    let axes = [0, 1, 2].map(|i| range(points.iter().map(|p| p[i])));
    let scale = axes.map(|[low, high]| if high > low { 1023.0 / (high - low) } else { 0.0 });
    let spread = |cell: u32| (0..10).fold(0, |sum, bit| sum | (cell >> bit & 1) << (3 * bit));
    move |p| (0..3).fold(0, |sum, i| sum | spread(((p[i] - axes[i][0]) * scale[i]) as u32 & 1023) << i)
}
