//! Where paths with costs may pass a side: its *Steiner points*.
//!
//! ```text
//!   ●──·──·──·──·──·──·──●   six on every side, evenly spaced
//!
//!   ●──·──·─······─·──·──●   near a place where paths begin or end more of them, the closer the nearer: a side that is
//!           ○                passed close by is passed straight across
//!
//!   ●──·──:──·──:──·──:──●   between sides closer together than their points are, the feet of those of the other side,
//!   ●─:──·──:──·──:──·───●   and of corners: a thin face, too, is crossed straight
//! ```
//!
//! They depend on the shape of the map alone, so that dearer faces never make a path cheaper.
//!
//! Source: Lanthier, Maheshwari and Sack, *Approximating shortest paths on weighted polyhedral surfaces*, 2001; the spacing
//! that grows with the distance is that of Aleksandrov, Maheshwari and Sack, *Approximation algorithms for geometric shortest
//! path problems*, 2000.

use super::surface::Space;
use crate::geometry::grouping::Groups;
use crate::geometry::space::{dot, lerp, minus};

/// How many points every side has, its ends left out.
const EVEN: u32 = 6;
/// How many feet a side gets at most.
const FEET: u32 = 12;
/// Points whose foot on another side of the face is no further away than this share of its length have one there: then the
/// evenly spaced points may lie too far beside it.
const CLOSE: f64 = 0.5 / (EVEN as f64 + 1.0);
/// The same for corners: crossing a face at its height is often best.
const HEIGHT: f64 = 0.3;
/// No foot is nearer to an end of its side than this share of its length: there the corner will do.
const END: f64 = 0.15;
/// A foot of a foot, and so on: so many times.
const GENERATIONS: u8 = 8;
/// Each point near a place is so many times as far from its foot as the one before.
const GROWTH: f64 = 1.25;
/// No place is taken to be nearer to a side than this share of its length.
const NEAREST: f64 = 1e-6;

/// A side, and the faces beside it.
pub(super) struct Side {
    pub(super) ends: [Space; 2],
    /// The second is missing at a border.
    pub(super) cells: [Option<u32>; 2],
}

impl Side {
    pub(super) fn at(&self, share: f64) -> Space {
        let [a, b] = self.ends;
        lerp(a, b, share)
    }

    fn length(&self) -> f64 {
        distance(self.ends[0], self.ends[1])
    }

    fn beside(&self) -> impl Iterator<Item = u32> + Clone + use<> {
        self.cells.into_iter().flatten()
    }

    /// Where on the side it is nearest to a point, as a share of its length, and how near.
    fn foot(&self, p: Space) -> (f64, f64) {
        let [a, b] = self.ends;
        let [along, to] = [b, p].map(|q| minus(q, a));
        let square = dot(along, along);
        let share = if square > 0.0 { (dot(along, to) / square).clamp(0.0, 1.0) } else { 0.0 };
        (share, distance(p, self.at(share)))
    }
}

pub(super) fn distance(a: Space, b: Space) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1]).hypot(a[2] - b[2])
}

/// A point on a side.
struct OnSide {
    side: u32,
    share: f64,
    /// 0 = evenly spaced, 1 = a foot of one of these or of a corner, ...; feet of those near a place are not asked for.
    generation: u8,
    /// The point of the same side that came before it.
    before: Option<u32>,
}

/// The points of all sides.
struct OnSides<'a> {
    sides: &'a [Side],
    points: Vec<OnSide>,
    last: Vec<Option<u32>>,
    feet: Vec<u32>,
}

impl OnSides<'_> {
    /// Adds a point unless it is an end of the side or `apart` or less from another one. Says whether it did.
    fn add(&mut self, side: u32, share: f64, apart: f64, generation: u8) -> bool {
        let s = side as usize;
        let apart = apart / self.sides[s].length();
        if !(share > apart && 1.0 - share > apart) {
            return false;
        }
        let mut at = self.last[s];
        while let Some(other) = at.map(|i| &self.points[i as usize]) {
            if (other.share - share).abs() <= apart {
                return false;
            }
            at = other.before;
        }
        let before = self.last[s].replace(self.points.len() as u32);
        self.points.push(OnSide { side, share, generation, before });
        true
    }

    /// More points round the foot of a place, if the evenly spaced ones are too far from each other there. Distances from
    /// feet are powers of [`GROWTH`], so that points of sides that lie behind each other face each other.
    fn near(&mut self, side: u32, p: Space) {
        let of = &self.sides[side as usize];
        let (length, (foot, far)) = (of.length(), of.foot(p));
        if far >= length / 2.0 {
            return;
        }
        self.add(side, foot, 0.0, u8::MAX);
        let nearest = (far.max(NEAREST * length) / 8.0).log(GROWTH).ceil();
        let spacing = length / f64::from(EVEN + 1);
        let mut offset = GROWTH.powf(nearest);
        while (GROWTH - 1.0) * offset < spacing {
            for share in [foot - offset / length, foot + offset / length] {
                self.add(side, share, 0.0, u8::MAX);
            }
            offset *= GROWTH;
        }
    }

    /// The foot of a point of a cell on one of its sides, if it is less than `within` sides' lengths away.
    fn foot(&mut self, p: Space, side: u32, within: f64, generation: u8) {
        let of = &self.sides[side as usize];
        let (share, far) = of.foot(p);
        if far > 0.0
            && (END..=1.0 - END).contains(&share)
            && far < within * of.length()
            && self.feet[side as usize] < FEET
            && self.add(side, share, far / 2.0, generation)
        {
            self.feet[side as usize] += 1;
        }
    }
}

/// Side and share of the length, side by side.
///
/// Cost: O(sides) for each place near which more is wanted, and O(k²) for each cell of k sides.
pub(super) fn steiner_points(sides: &[Side], cells: usize, near: &[Space]) -> Vec<(u32, f64)> {
    let numbers = || 0..sides.len() as u32;
    let none = vec![None; sides.len()];
    let mut on = OnSides { sides, points: Vec::with_capacity(8 * sides.len()), last: none, feet: vec![0; sides.len()] };
    for side in numbers() {
        for i in 1..=EVEN {
            on.add(side, f64::from(i) / f64::from(EVEN + 1), 0.0, 0);
        }
    }
    let of_cell =
        Groups::new(cells, (0..).zip(sides).flat_map(|(i, side)| side.beside().map(move |cell| (cell as usize, i))));
    for cell in 0..cells {
        let round = of_cell.of(cell);
        for (&side, &other) in round.iter().flat_map(|side| round.iter().map(move |other| (side, other))) {
            sides[other as usize].ends.into_iter().for_each(|corner| on.foot(corner, side, HEIGHT, 1));
        }
    }
    let mut done = 0;
    while let Some(&OnSide { side, share, generation, .. }) = on.points.get(done) {
        done += 1;
        if generation >= GENERATIONS {
            continue;
        }
        let p = sides[side as usize].at(share);
        for cell in sides[side as usize].beside() {
            for &other in of_cell.of(cell as usize).iter().filter(|&&other| other != side) {
                on.foot(p, other, CLOSE, generation + 1);
            }
        }
    }
    near.iter().for_each(|&p| numbers().for_each(|side| on.near(side, p)));
    on.points.iter().map(|point| (point.side, point.share)).collect()
}

#[cfg(test)]
mod tests {
    use super::{EVEN, FEET, GENERATIONS, Side, Space, steiner_points};

    /// The points of sides by their shares, side by side.
    fn shares(sides: &[([Space; 2], [Option<u32>; 2])], cells: usize, near: &[Space]) -> Vec<Vec<f64>> {
        let sides: Vec<Side> = sides.iter().map(|&(ends, cells)| Side { ends, cells }).collect();
        let mut shares = vec![Vec::new(); sides.len()];
        steiner_points(&sides, cells, near).into_iter().for_each(|(side, share)| shares[side as usize].push(share));
        shares
    }

    #[test]
    fn near_a_place_no_point_is_as_far_from_the_next_as_even_ones() {
        let spacing = 1.0 / f64::from(EVEN + 1);
        for i in 0..40 {
            let length = 1.0 + 0.05 * f64::from(i);
            let side = ([[0.0; 3], [length, 0.0, 0.0]], [None; 2]);
            let mut added = shares(&[side], 0, &[[0.05 * length, 0.01 * length, 0.0]]).concat();
            added.retain(|share| (share / spacing - (share / spacing).round()).abs() > 1e-9);
            added.sort_by(f64::total_cmp);
            assert!(added.len() > 10 && added.iter().any(|share| (share - 0.05).abs() < 1e-9), "{length}: {added:?}");
            let farthest = added.windows(2).map(|pair| pair[1] - pair[0]).fold(0.0, f64::max);
            assert!(farthest < spacing, "{length}: {added:?}");
        }
    }

    #[test]
    fn feet_are_few_and_their_feet_end_after_some_generations() {
        // A saw of many teeth close above a side.
        let tooth = |i: u32| [0.16 + 0.021 * f64::from(i), 0.002, 0.0];
        let mut sides = vec![([[0.0; 3], [1.0, 0.0, 0.0]], [Some(0), None])];
        sides.extend((0..30).map(|i| ([tooth(i), tooth(i + 1)], [Some(0), None])));
        assert_eq!(shares(&sides, 1, &[])[0].len() as u32, EVEN + FEET);
        // A stack of thin cells; the foot of a corner below goes on to the sides above.
        let level = |y: u32| [[0.0, 0.01 * f64::from(y), 0.0], [1.0, 0.01 * f64::from(y), 0.0]];
        let mut sides: Vec<_> = (0..20).map(|y| (level(y), [Some(y), Some(y + 1)])).collect();
        sides.push(([[0.35, -0.01, 0.0], [0.36, -0.02, 0.0]], [Some(0), None]));
        let has_foot = |shares: &Vec<f64>| shares.iter().any(|share| (share - 0.35).abs() < 1e-9);
        let with_foot: Vec<bool> = shares(&sides, 21, &[])[..20].iter().map(has_foot).collect();
        let expected: Vec<bool> = (0..20).map(|y| y < usize::from(GENERATIONS)).collect();
        assert_eq!(with_foot, expected);
    }
}
