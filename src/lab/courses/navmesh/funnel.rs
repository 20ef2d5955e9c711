//! The shortest path through portals, exactly.
//!
//! ```text
//!        L1 ●────● L2                  kept: the shortest paths from the start to both ends of the last portal;
//!   start ●                            they part at the apex. A new end is reached from its own path, or by following
//!        R1 ●────────● R2              the other one as far as one has to go round it.
//! ```

use super::mesh::{Spot, apart, contains, same, turn};
use crate::cases::random::Random;
use std::cmp::Ordering;

/// Portals with the points between which they lie.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Sleeve {
    pub(super) start: Spot,
    pub(super) goal: Spot,
    /// Left and right end of each.
    pub(super) portals: Vec<[Spot; 2]>,
}

/// The start, the points at which the shortest path turns, the goal; each once.
pub(super) fn shortest(sleeve: &Sleeve) -> Vec<Spot> {
    let mut paths = [vec![sleeve.start], vec![sleeve.start]];
    for &[left, right] in &sleeve.portals {
        paths[0] = reach(&paths[0], &paths[1], left, Ordering::Greater);
        paths[1] = reach(&paths[1], &paths[0], right, Ordering::Less);
    }
    reach(&paths[0], &paths[1], sleeve.goal, Ordering::Greater)
}

/// The shortest path to `p`, from those to the ends of the portal before it: `own` bends to the side `bend`.
fn reach(own: &[Spot], other: &[Spot], p: Spot, bend: Ordering) -> Vec<Spot> {
    let common = own.iter().zip(other).take_while(|(a, b)| same(**a, **b)).count();
    let mut path = own.to_vec();
    while path.len() > common && turn(path[path.len() - 2], path[path.len() - 1], p) != bend {
        path.pop();
    }
    if path.len() == common {
        let rest = &other[common - 1..];
        let round = rest.windows(2).take_while(|pair| turn(pair[0], pair[1], p) == bend.reverse()).count();
        path.extend(&rest[1..=round]);
    }
    if path.last() != Some(&p) {
        path.push(p);
    }
    path
}

/// A random sequence of at most so many triangles, each at a side of the one before, with a start in the first and a goal
/// in the last: inside, on a side or at a corner. They meet in the portals only. Coordinates are whole numbers times
/// `unit`.
pub(super) fn random_sleeve(random: &mut Random, count: usize, unit: f64) -> Sleeve {
    let spot = |[x, y]: [i64; 2]| [x as f64 * unit, y as f64 * unit];
    let first = [-3, random.below(9) as i64 - 4];
    let mut portals: Vec<[[i64; 2]; 2]> = vec![[[0, 4], [0, -3]]];
    let start_in = [[0, -3], [0, 4], first].map(spot);
    let mut triangles = vec![start_in];
    let mut goal_in = [[0, 4], [0, -3], [6, 1]].map(spot);
    for _ in 0..60 * count {
        let [left, right] = portals[portals.len() - 1];
        let p = [0, 1].map(|axis| (left[axis] + right[axis]) / 2 + random.below(13) as i64 - 6);
        let corners = [left, right, p].map(spot);
        // Beyond the portal, in the coordinates that are really used, and clear of all before.
        let is_free = turn(corners[0], corners[1], corners[2]).is_gt()
            && triangles.iter().all(|&other| apart(corners, other) && !contains(other, corners[2]))
            && triangles.iter().flatten().all(|&q| corners[..2].contains(&q) || !contains(corners, q));
        if is_free {
            goal_in = corners;
            if portals.len() == count {
                break;
            }
            triangles.push(corners);
            portals.push(if random.below(2) == 0 { [p, right] } else { [left, p] });
        }
    }
    if goal_in == triangles[triangles.len() - 1] {
        // No room was left beyond the last portal.
        portals.pop();
    }
    let (start, goal) = (inside(random, start_in), inside(random, goal_in));
    Sleeve { start, goal, portals: portals.iter().map(|portal| portal.map(spot)).collect() }
}

/// A point of a triangle. The middle of a side, rounded, may lie outside; then it is a corner.
fn inside(random: &mut Random, corners: [Spot; 3]) -> Spot {
    let p = among(random, corners);
    if contains(corners, p) { p } else { corners[2] }
}

/// A corner of a triangle, a point of a side, or one inside: exact for whole numbers.
pub(super) fn among(random: &mut Random, [a, b, c]: [Spot; 3]) -> Spot {
    let half = |a: Spot, b: Spot| [0, 1].map(|axis| a[axis] / 2.0 + b[axis] / 2.0);
    match random.below(8) {
        0 => a,
        1 => b,
        2 => c,
        3 => half(a, b),
        4 => half(b, c),
        _ => half(a, half(b, c)),
    }
}

/// A corridor that winds: `turns` portals, whose corners one has to go round on one side after the other.
pub(super) fn winding(turns: usize) -> Sleeve {
    let portals = (0..turns).map(|i| {
        let x = 10.0 * (i + 1) as f64;
        if i % 2 == 0 { [[x, 9.0], [x, 5.0]] } else { [[x, -5.0], [x, -9.0]] }
    });
    let ends: Vec<[Spot; 2]> = portals.collect();
    // Between two of them, one end after the other.
    let mut all = vec![ends[0]];
    for pair in ends.windows(2) {
        all.extend([[pair[0][0], pair[1][1]], pair[1]]);
    }
    Sleeve { start: [0.0, 0.0], goal: [10.0 * (turns + 1) as f64, 0.0], portals: all }
}

/// Start, left end of a portal and goal on one line, as one writes it in tenths; as they are stored, they turn one way or
/// the other, by less than a product of differences can tell.
pub(super) fn nearly_straight() -> Vec<Sleeve> {
    let steps = (1..=6_i32).flat_map(|dx| (-5..=5_i32).map(move |dy| [dx, dy]));
    let sleeve = |[dx, dy]: [i32; 2]| {
        let at = |x: i32, y: i32| [f64::from(x) / 10.0, f64::from(y) / 10.0];
        let (x, y) = (3 * dy - dx, 7 - 2 * dx);
        let portal = [at(x + dx, y + dy), at(x + dx + dy, y + dy - dx)];
        Sleeve { start: at(x, y), goal: at(x + 2 * dx, y + 2 * dy), portals: vec![portal] }
    };
    steps.map(sleeve).collect()
}

/// A walk through a fan: all portals have one end in common.
pub(super) fn fan(spokes: usize) -> Sleeve {
    // Points on a parabola, which turn right as one walks on.
    let rim: Vec<Spot> = (0..=spokes).map(|k| [k as f64, (k * (spokes - k)) as f64 + 5.0]).collect();
    let hub = [spokes as f64 / 2.0, 6.0];
    let portals = rim[1..spokes].iter().map(|&left| [left, hub]).collect();
    Sleeve { start: rim[0], goal: rim[spokes], portals }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn length(path: &[Spot]) -> f64 {
        path.windows(2).map(|pair| (pair[0][0] - pair[1][0]).hypot(pair[0][1] - pair[1][1])).sum()
    }

    /// Whether the line from a point of portal `from` (0 is the start) to one of portal `to` passes all between them.
    fn sees(sleeve: &Sleeve, (from, a): (usize, Spot), (to, b): (usize, Spot)) -> bool {
        let between = sleeve.portals.iter().enumerate().filter(|(i, _)| from < i + 1 && i + 1 < to);
        between.into_iter().all(|(_, &[left, right])| {
            (turn(a, b, left).is_ge() && turn(a, b, right).is_le()) && (!same(a, b) || turn(left, right, a).is_eq())
        })
    }

    /// The length of the shortest path by brute force: the best way from end to end of the portals that see each other.
    fn brute(sleeve: &Sleeve) -> f64 {
        let mut nodes = vec![(0, sleeve.start)];
        for (i, portal) in sleeve.portals.iter().enumerate() {
            nodes.extend(portal.map(|p| (i + 1, p)));
        }
        nodes.push((sleeve.portals.len() + 1, sleeve.goal));
        let mut best = vec![f64::INFINITY; nodes.len()];
        best[0] = 0.0;
        for j in 1..nodes.len() {
            for i in 0..j {
                if sees(sleeve, nodes[i], nodes[j]) {
                    best[j] = best[j].min(best[i] + length(&[nodes[i].1, nodes[j].1]));
                }
            }
        }
        best[nodes.len() - 1]
    }

    #[test]
    fn no_path_is_shorter_and_every_corner_is_a_turn() {
        let mut random = Random::new(1, "sleeves");
        let mut turns = 0;
        for i in 0..3000 {
            let sleeve = random_sleeve(&mut random, 1 + i % 11, [1.0, 0.1][i % 2]);
            let path = shortest(&sleeve);
            let (found, best) = (length(&path), brute(&sleeve));
            assert!((found - best).abs() <= 1e-9 * (1.0 + best), "{sleeve:?}: {path:?} is {found}, the best is {best}");
            for corner in path.windows(3) {
                assert!(turn(corner[0], corner[1], corner[2]).is_ne(), "{sleeve:?}: {path:?}");
                turns += 1;
            }
            assert!(path.windows(2).all(|pair| !same(pair[0], pair[1])), "{sleeve:?}");
            assert_eq!((path[0], path[path.len() - 1]), (sleeve.start, sleeve.goal));
        }
        assert!(turns > 1000, "{turns}");
        for sleeve in [winding(40), fan(40)] {
            assert!((length(&shortest(&sleeve)) - brute(&sleeve)).abs() < 1e-6);
        }
        let naive = |[a, b, c]: [Spot; 3]| (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        let differs = |sleeve: &&Sleeve| {
            let points = [sleeve.start, sleeve.portals[0][0], sleeve.goal];
            turn(points[0], points[1], points[2]) != naive(points).total_cmp(&0.0)
        };
        assert!(nearly_straight().iter().filter(differs).count() > 5);
        assert_eq!(shortest(&fan(40)).len(), 3);
        assert_eq!(shortest(&winding(40)).len(), 42);
    }
}
