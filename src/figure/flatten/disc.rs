//! A disc of faces, cut into triangles, with each point in the middle of those it is joined to.
//!
//! ```text
//!   w1 ─────── w0       a face with corners w: a helping point for each corner (c) and each side (s), in a ring, and
//!    │╲ c─s─c ╱│        one in the middle of the ring. No two points are joined twice, even where the face meets a
//!    │ s  ·  s │        vertex again; so no part can collapse.
//!    │╱ c─s─c ╲│
//!   w2 ─────── w3
//! ```
//!
//! A point with little room pulls its neighbours to itself: two points are joined with the weight 1 / (product of their
//! rooms), and the sides of the border share the circle by the rooms of their ends.
//!
//! Source: Tutte, How to draw a graph (1963); Floater, One-to-one piecewise linear mappings over triangulations (2003).

use std::f64::consts::PI;

/// The radius of the circle.
pub(super) const RADIUS: f64 = 100.0;
/// The radius of the circle of helping points round a border that is not round itself.
const OUTER: f64 = 1.7;
/// If rooms differ, this share of the circle is parted evenly among the sides of the border all the same.
const EVEN: f64 = 0.4;

/// What is to be drawn of a component: points, walks round its inner faces, and the walk along its border, all of them
/// counter-clockwise.
#[derive(Debug)]
pub(super) struct Web {
    /// How many points there are.
    pub(super) drawn: usize,
    pub(super) faces: Vec<Vec<usize>>,
    pub(super) border: Vec<usize>,
    /// The first of each two points that are bends.
    pub(super) bends: Vec<usize>,
    /// How much room each point is to have, above 0 and at most 1: 1 for all, unless some matter more than others.
    pub(super) room: Vec<f64>,
}

impl Web {
    /// Whether the border passes no point twice.
    fn is_round(&self) -> bool {
        let mut points = self.border.clone();
        points.sort_unstable();
        points.windows(2).all(|pair| pair[0] != pair[1]) && points.len() >= 3
    }
}

/// The triangles as joined points, and which of them stand on the circle.
pub(super) struct Disc {
    joined: Vec<Vec<usize>>,
    room: Vec<f64>,
    /// The points on the circle, counter-clockwise.
    circle: Vec<usize>,
    /// The points of the drawing that belong to those of the circle.
    border: Vec<usize>,
    /// Whether the border itself stands on the circle.
    is_round: bool,
}

impl Disc {
    pub(super) fn new(web: &Web) -> Self {
        let is_round = web.is_round();
        let mut disc = Self {
            joined: vec![Vec::new(); web.drawn],
            room: web.room.clone(),
            circle: Vec::new(),
            border: Vec::new(),
            is_round,
        };
        for face in &web.faces {
            disc.sides(face);
            if face.len() > 3 {
                let ring = disc.ring(face);
                let middle = disc.point(ring.iter().map(|&p| disc.room[p]).fold(0.0, f64::max));
                ring.iter().for_each(|&p| disc.join(p, middle));
            }
        }
        if is_round {
            (disc.circle, disc.border) = (web.border.clone(), web.border.clone());
        } else {
            disc.sides(&web.border);
            disc.circle = disc.ring(&web.border);
            disc.border = web.border.iter().flat_map(|&p| [p, p]).collect();
        }
        disc
    }

    fn point(&mut self, room: f64) -> usize {
        self.joined.push(Vec::new());
        self.room.push(room);
        self.joined.len() - 1
    }

    fn join(&mut self, a: usize, b: usize) {
        self.joined[a].push(b);
        self.joined[b].push(a);
    }

    fn sides(&mut self, walk: &[usize]) {
        (0..walk.len()).for_each(|i| self.join(walk[i], walk[(i + 1) % walk.len()]));
    }

    /// A ring of helping points along a walk: for its first corner, its first side, its second corner …
    fn ring(&mut self, walk: &[usize]) -> Vec<usize> {
        let room = |i: usize| self.room[walk[i % walk.len()]];
        let rooms: Vec<f64> = (0..walk.len()).flat_map(|i| [room(i), room(i).max(room(i + 1))]).collect();
        let ring: Vec<usize> = rooms.into_iter().map(|room| self.point(room)).collect();
        for (i, &corner) in walk.iter().enumerate() {
            let next = walk[(i + 1) % walk.len()];
            let (at, side) = (ring[2 * i], ring[2 * i + 1]);
            let after = ring[(2 * i + 2) % ring.len()];
            for (a, b) in [(at, corner), (side, corner), (side, next), (at, side), (side, after)] {
                self.join(a, b);
            }
        }
        ring
    }

    /// The places of the drawing with its border on the circle, turned so that known points are near to where they were.
    pub(super) fn places(&self, known: &[Option<[f64; 2]>]) -> Vec<[f64; 2]> {
        let mut fixed = vec![None; self.joined.len()];
        for (&p, place) in self.circle.iter().zip(self.on_circle(known)) {
            fixed[p] = Some(place);
        }
        let mut places = self.middles(&fixed);
        places.truncate(known.len());
        places
    }

    /// The places with the known points where they were, new ones in the middle of their neighbours, those of the border
    /// in the middle of theirs along the border.
    pub(super) fn places_near(&self, known: &[Option<[f64; 2]>]) -> Vec<[f64; 2]> {
        let mut fixed = known.to_vec();
        fixed.resize(self.joined.len(), None);
        let circle = self.on_circle(known);
        let count = self.circle.len();
        for (i, (&p, &place)) in self.circle.iter().zip(&circle).enumerate() {
            if !self.is_round {
                fixed[p] = Some(place);
            } else if known[p].is_none() {
                let find = |way: &dyn Fn(usize) -> usize| {
                    (1..=count).find_map(|steps| Some((known[self.circle[way(steps) % count]]?, steps as f64)))
                };
                let around = find(&|steps| i + count - steps).zip(find(&|steps| i + steps));
                fixed[p] = Some(around.map_or(place, |((a, before), (b, after))| {
                    let share = before / (before + after);
                    [0, 1].map(|k| a[k] + share * (b[k] - a[k]))
                }));
            }
        }
        let mut places = self.middles(&fixed);
        places.truncate(known.len());
        places
    }

    /// The places on the circle, from a side at the bottom on, or from where known points are nearest to their places.
    fn on_circle(&self, known: &[Option<[f64; 2]>]) -> Vec<[f64; 2]> {
        let count = self.circle.len();
        let radius = RADIUS * if self.is_round { 1.0 } else { OUTER };
        let shares = self.shares();
        let place = |i: usize, shift: usize| {
            let turn = match &shares {
                None => (2 * ((i + shift) % count)) as f64 / count as f64,
                Some(shares) => 2.0 * (shares[i] + shift as f64 / count as f64).fract(),
            };
            on_circle(turn, count).map(|x| x * radius)
        };
        let far = |shift: usize| -> f64 {
            let ways = self.border.iter().enumerate().filter_map(|(i, &p)| {
                let (place, new) = (known[p]?, place(i, shift));
                let [dx, dy] = [place[0] - new[0], place[1] - new[1]];
                Some(dx * dx + dy * dy)
            });
            ways.sum()
        };
        let mut best = 0;
        for shift in 1..count {
            if far(shift) < far(best) - 1e-6 {
                best = shift;
            }
        }
        (0..count).map(|i| place(i, best)).collect()
    }

    /// Where on the circle each of its points stands, from 0 to 1, if rooms differ.
    fn shares(&self) -> Option<Vec<f64>> {
        let room = |i: usize| self.room[self.circle[i % self.circle.len()]];
        let count = self.circle.len();
        let least = (0..count).map(room).fold(f64::INFINITY, f64::min);
        // What is left of the circle belongs to those with more room than the least.
        let sides: Vec<f64> = (0..count).map(|i| room(i) * room(i + 1) - least * least).collect();
        let sum: f64 = sides.iter().sum();
        if sum <= 0.0 {
            return None;
        }
        let even = EVEN / count as f64;
        let before = sides.iter().scan(0.0, |so_far, side| {
            let before = *so_far;
            *so_far += even + (1.0 - EVEN) * side / sum;
            Some(before)
        });
        Some(before.collect())
    }

    /// Every point that is not fixed in the middle of those it is joined to: conjugate gradients.
    fn middles(&self, fixed: &[Option<[f64; 2]>]) -> Vec<[f64; 2]> {
        let free: Vec<usize> = (0..fixed.len()).filter(|&p| fixed[p].is_none()).collect();
        let mut out: Vec<[f64; 2]> = fixed.iter().map(|place| place.unwrap_or_default()).collect();
        for axis in [0, 1] {
            // What is missing at a point: the sum over its neighbours of how much further they are.
            let weight = |p: usize, q: usize| 1.0 / (self.room[p] * self.room[q]);
            let pull = |x: &[f64], p: usize| self.joined[p].iter().map(|&q| weight(p, q) * (x[q] - x[p])).sum::<f64>();
            let mut x: Vec<f64> = out.iter().map(|place| place[axis]).collect();
            let mut rest: Vec<f64> = free.iter().map(|&p| pull(&x, p)).collect();
            let mut way = vec![0.0; x.len()];
            free.iter().zip(&rest).for_each(|(&p, &r)| way[p] = r);
            let square = |v: &[f64]| v.iter().map(|r| r * r).sum::<f64>();
            let mut size = square(&rest);
            for _ in 0..4 * free.len() {
                if size < 1e-18 * RADIUS * RADIUS {
                    break;
                }
                let pulled: Vec<f64> = free.iter().map(|&p| -pull(&way, p)).collect();
                let along: f64 = free.iter().zip(&pulled).map(|(&p, pulled)| way[p] * pulled).sum();
                let step = size / along;
                for (i, &p) in free.iter().enumerate() {
                    x[p] += step * way[p];
                    rest[i] -= step * pulled[i];
                }
                let next = square(&rest);
                free.iter().zip(&rest).for_each(|(&p, &r)| way[p] = r + next / size * way[p]);
                size = next;
            }
            free.iter().for_each(|&p| out[p][axis] = x[p]);
        }
        out
    }
}

/// A place on the unit circle, `turn` half turns after the left end of the side at the bottom of a polygon.
fn on_circle(turn: f64, corners: usize) -> [f64; 2] {
    // From the bottom, counter-clockwise: x is the sine, y the negative cosine.
    let angle = PI * (turn - 1.0 / corners as f64);
    let (sine, cosine) = wave(angle);
    [sine, -cosine]
}

/// Sine and cosine by their series: the same bits on every machine. For angles from -π to 2π.
fn wave(angle: f64) -> (f64, f64) {
    // Of a quarter of the angle, doubled twice.
    let quarter = angle / 4.0;
    let (mut sine, mut cosine, mut term) = (0.0, 0.0, 1.0);
    for i in 0..12 {
        let even = f64::from(2 * i);
        cosine += term;
        term *= quarter / (even + 1.0);
        sine += term;
        term *= -quarter / (even + 2.0);
    }
    for _ in 0..2 {
        (sine, cosine) = (2.0 * sine * cosine, cosine * cosine - sine * sine);
    }
    (sine, cosine)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_series_is_a_point_of_the_unit_circle_at_known_angles() {
        let root = 0.5_f64.sqrt();
        let known =
            [(0.0, [0.0, 1.0]), (0.25, [root, root]), (0.5, [1.0, 0.0]), (-0.5, [-1.0, 0.0]), (1.0, [0.0, -1.0])];
        for (turn, [sine, cosine]) in known.into_iter().chain([(2.0, [0.0, 1.0]), (1.25, [-root, -root])]) {
            let (s, c) = wave(turn * PI);
            assert!((s - sine).abs() < 1e-14 && (c - cosine).abs() < 1e-14, "{turn}: {s} {c}");
        }
    }

    #[test]
    fn every_free_point_is_in_the_middle_of_its_neighbours() {
        // A square with a dangling edge inside: the face meets corner 0 twice.
        let web = Web {
            drawn: 5,
            faces: vec![vec![0, 4, 0, 1, 2, 3]],
            border: vec![0, 1, 2, 3],
            bends: Vec::new(),
            room: vec![1.0; 5],
        };
        let disc = Disc::new(&web);
        let mut fixed = vec![None; disc.joined.len()];
        disc.circle.iter().zip(disc.on_circle(&[None; 5])).for_each(|(&p, place)| fixed[p] = Some(place));
        let places = disc.middles(&fixed);
        for (p, joined) in disc.joined.iter().enumerate().filter(|(p, _)| fixed[*p].is_none()) {
            for axis in [0, 1] {
                let mean = joined.iter().map(|&q| places[q][axis]).sum::<f64>() / joined.len() as f64;
                assert!((mean - places[p][axis]).abs() < 1e-6, "{p}: {mean} {places:?}");
            }
        }
        assert!((places[0][0] - places[4][0]).abs() > 1.0, "the dangling edge has a length");
    }
}
