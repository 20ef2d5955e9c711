//! Closed outlines as cyclic sequences of points, in a form in which equal ones are equal.
//!
//! ```text
//!   c a b        the smallest rotation: a b c       there and back again is nothing: a b x b c = a b c
//!   ┌───────┐
//!   │  ┌─┐  │    a keyhole: round the outside, over a bridge, round the hole and back over the bridge;
//!   │ ╱└─┘  │    without the bridge these are two outlines
//!   └───────┘
//! ```

use super::pairing::distance;
use crate::plane::Point;
use std::collections::BTreeMap;

/// The sequence without steps on the spot and without spurs. O(n).
pub(super) fn tidy(ring: &[u32]) -> Vec<u32> {
    let mut out: Vec<u32> = Vec::with_capacity(ring.len());
    for &v in ring {
        push(&mut out, v);
    }
    // The seam: what the end does to the start.
    let mut start = 0;
    while out.len() - start > 1 {
        let last = out.len() - 1;
        if out[last] == out[start] {
            out.pop();
        } else if out.len() - start > 2 && out[last - 1] == out[start] {
            out.truncate(last - 1);
        } else if out.len() - start > 2 && out[last] == out[start + 1] {
            // A spur at the start itself.
            start += 1;
            out.pop();
        } else {
            break;
        }
    }
    out.split_off(start)
}

fn push(out: &mut Vec<u32>, v: u32) {
    match out[..] {
        [.., last] if last == v => {}
        [.., before, _] if before == v => drop(out.pop()),
        _ => out.push(v),
    }
}

/// The outlines of which a keyhole is made: what is left without the bridges, over which it goes once there and once back.
/// Where bridges cross each other it is one outline. O(n log n).
pub(super) fn parts<T: Copy + Ord>(ring: &[T]) -> Vec<Vec<T>> {
    let step = |i: usize| (ring[i], ring[(i + 1) % ring.len()]);
    let mut counts: BTreeMap<(T, T), u32> = BTreeMap::new();
    (0..ring.len()).for_each(|i| *counts.entry(step(i)).or_default() += 1);
    let is_bridge = |(a, b): (T, T)| a != b && [(a, b), (b, a)].iter().all(|way| counts.get(way) == Some(&1));
    if !(0..ring.len()).any(|i| is_bridge(step(i))) {
        return vec![ring.to_vec()];
    }
    let mut out = Vec::new();
    // The outlines begun: the first, and one behind each bridge that leads there.
    let (mut open, mut bridges) = (vec![Vec::new()], Vec::new());
    for (a, b) in (0..ring.len()).map(step) {
        if !is_bridge((a, b)) {
            open.last_mut().into_iter().for_each(|part| part.push(a));
        } else if bridges.last() == Some(&(b, a)) {
            bridges.pop();
            out.extend(open.pop());
        } else {
            bridges.push((a, b));
            open.push(Vec::new());
        }
    }
    if !bridges.is_empty() {
        return vec![ring.to_vec()];
    }
    out.extend(open.pop());
    out.retain(|part| part.len() > 2);
    out
}

/// The smallest rotation. O(n) (Booth 1980, with two candidates).
pub(super) fn canonical(ring: &[u32]) -> Vec<u32> {
    let n = ring.len();
    let (mut i, mut j, mut length) = (0, 1, 0);
    while i < n && j < n && length < n {
        let (a, b) = (ring[(i + length) % n], ring[(j + length) % n]);
        if a == b {
            length += 1;
            continue;
        }
        if a > b {
            i += length + 1;
        } else {
            j += length + 1;
        }
        if i == j {
            j += 1;
        }
        length = 0;
    }
    let start = i.min(j);
    ring[start..].iter().chain(&ring[..start]).copied().collect()
}

/// The same outline the other way round.
pub(super) fn reversed(ring: &[u32]) -> Vec<u32> {
    canonical(&ring.iter().rev().copied().collect::<Vec<_>>())
}

/// The corners of an outline, each once.
pub(super) fn open(points: &[Point]) -> &[Point] {
    let closed = points.len() > 1 && points.first() == points.last();
    &points[..points.len() - usize::from(closed)]
}

/// Twice the signed area, positive if the outline runs counter-clockwise with y up.
pub(super) fn area(points: impl Iterator<Item = Point> + Clone) -> f64 {
    let Some(base) = points.clone().next() else { return 0.0 };
    let ahead = points.clone().skip(1);
    let cross = |(p, q): (Point, Point)| (p.x - base.x) * (q.y - base.y) - (p.y - base.y) * (q.x - base.x);
    points.zip(ahead).map(cross).sum()
}

/// The points beside the middles of the sides of a ring, to the left of them if it runs counter-clockwise: by this part of
/// how wide the ring is.
pub(super) fn beside_sides(ring: &[Point], part: f64) -> impl Iterator<Item = Point> + '_ {
    let twice = area(ring.iter().copied());
    let sides = || (0..ring.len()).map(|i| (ring[i], ring[(i + 1) % ring.len()]));
    let around: f64 = sides().map(|(a, b)| distance(a, b)).sum();
    sides().filter(|(a, b)| a != b).map(move |(a, b)| {
        let way = part * twice / (around * distance(a, b));
        Point::new(0.5 * (a.x + b.x) - way * (b.y - a.y), 0.5 * (a.y + b.y) + way * (b.x - a.x))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spurs_and_steps_on_the_spot_go_wherever_the_outline_starts() {
        let with_spur = [1, 2, 2, 9, 8, 9, 2, 3];
        for turn in 0..with_spur.len() {
            let mut ring = with_spur.to_vec();
            ring.rotate_left(turn);
            assert_eq!(canonical(&tidy(&ring)), [1, 2, 3], "{ring:?}");
        }
        assert!(tidy(&[1, 2, 1, 2]).len() < 3);
        assert!(tidy(&[1, 1, 1]).len() < 3);
        assert!(tidy(&[]).is_empty());
    }

    #[test]
    fn keyholes_come_apart_wherever_they_start() {
        // Two holes, one of them over a bridge of two steps, and a spur.
        let keyhole = [1, 2, 3, 9, 5, 6, 7, 5, 9, 3, 8, 3, 4, 1, 11, 12, 13, 11];
        for turn in 0..keyhole.len() {
            let mut ring = keyhole.to_vec();
            ring.rotate_left(turn);
            let mut found: Vec<Vec<u32>> = parts(&ring).iter().map(|part| canonical(part)).collect();
            found.sort();
            assert_eq!(found, [vec![1, 2, 3, 4], vec![5, 6, 7], vec![11, 12, 13]], "{ring:?}");
        }
        for whole in [&[1, 2, 3][..], &[1, 2, 3, 4, 2, 1, 4, 3], &[1, 2, 3, 1, 2, 3], &[]] {
            assert_eq!(parts(whole), [whole], "{whole:?}");
        }
    }

    #[test]
    fn the_smallest_rotation_is_that_of_brute_force() {
        let rings = [vec![2, 1, 2, 1, 1], vec![1, 1, 1], vec![3, 1, 2], vec![1, 2, 1, 2, 1, 3], vec![5]];
        for ring in rings {
            let all = (0..ring.len()).map(|i| {
                let mut turned = ring.clone();
                turned.rotate_left(i);
                turned
            });
            assert_eq!(canonical(&ring), all.min().unwrap(), "{ring:?}");
        }
        assert!(canonical(&[]).is_empty());
    }
}
