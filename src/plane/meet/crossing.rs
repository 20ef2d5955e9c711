//! The point where two segments cross, without rounding.
//!
//! ```text
//!        c ╲   ╱ b         P = (X / W, Y / W)    W = (b - a) x (d - c)
//!           ╲ ╱                                  X = a.x W + T (b.x - a.x)    T = (c - a) x (d - c)
//!            ● P                                 Y = a.y W + T (b.y - a.y)
//!           ╱ ╲
//!        a ╱   ╲ d         Questions are answered from a box that P is known to lie in, or from X, Y, W exactly.
//! ```

use super::grid::Grid;
use crate::geometry::double_double::DoubleDouble;
use crate::geometry::expansion::{Expansion, cross};
use crate::geometry::interval::Interval;
use crate::geometry::predicates::left_to_right;
use crate::geometry::two::Two;
use crate::plane::{Point, SMALLEST};
use std::cell::OnceCell;
use std::cmp::Ordering;

/// Where two segments cross in a point interior to both.
#[derive(Clone, Debug)]
pub(super) struct Crossing {
    pub(super) edges: [u32; 2],
    ends: [[Point; 2]; 2],
    x: Interval,
    y: Interval,
    finer: OnceCell<Box<[Option<DoubleDouble>; 2]>>,
    exact: OnceCell<Box<Exact>>,
}

/// The point as quotients; `w` is positive.
#[derive(Clone, Debug)]
struct Exact {
    x: Expansion,
    y: Expansion,
    w: Expansion,
}

impl Crossing {
    /// The crossing of two edges, which must cross.
    pub(super) fn new(edges: [u32; 2], ends: [[Point; 2]; 2]) -> Self {
        let [x, y] = bounds(ends);
        Self { edges, ends, x, y, finer: OnceCell::new(), exact: OnceCell::new() }
    }

    fn exact(&self) -> &Exact {
        self.exact.get_or_init(|| {
            let [[a, b], [c, d]] = self.ends;
            let vector = |p: Point, q: Point| [Expansion::difference(q.x, p.x), Expansion::difference(q.y, p.y)];
            let (along, across) = (vector(a, b), vector(c, d));
            let (w, t) = (cross(&along, &across), cross(&vector(a, c), &across));
            let part = |start: f64, along: &Expansion| Expansion::of(start).times(&w).plus(&t.times(along));
            let (x, y) = (part(a.x, &along[0]), part(a.y, &along[1]));
            Box::new(match w.sign() {
                Ordering::Less => Exact { x: x.negated(), y: y.negated(), w: w.negated() },
                _ => Exact { x, y, w },
            })
        })
    }

    /// Where it lies from a point in the order from left to right.
    pub(super) fn order_to_point(&self, p: Point) -> Ordering {
        let exactly =
            |part: &Expansion, value: f64| part.clone().minus(&Expansion::of(value).times(&self.exact().w)).sign();
        let finer = |i: usize, value: f64| self.finer()[i]?.order(DoubleDouble::of(value));
        let by_x = self.x.order(Interval::of(p.x)).or_else(|| finer(0, p.x));
        let by_x = by_x.unwrap_or_else(|| exactly(&self.exact().x, p.x));
        by_x.then_with(|| {
            let by_y = self.y.order(Interval::of(p.y)).or_else(|| finer(1, p.y));
            by_y.unwrap_or_else(|| exactly(&self.exact().y, p.y))
        })
    }

    /// Where it lies from another crossing in the order from left to right.
    pub(super) fn order_to(&self, other: &Self) -> Ordering {
        let exactly = |a: &Expansion, b: &Expansion| {
            let [w, v] = [self, other].map(|crossing| &crossing.exact().w);
            a.times(v).minus(&b.times(w)).sign()
        };
        if self.ends == other.ends {
            return Ordering::Equal;
        }
        let finer = |i: usize| self.finer()[i]?.order(other.finer()[i]?);
        let by_x = self.x.order(other.x);
        if by_x.is_none() && is_moved(self.ends, other.ends) {
            return left_to_right(self.ends[0][0], other.ends[0][0]);
        }
        let by_x = by_x.or_else(|| finer(0));
        let by_x = by_x.unwrap_or_else(|| exactly(&self.exact().x, &other.exact().x));
        by_x.then_with(|| {
            let by_y = self.y.order(other.y).or_else(|| finer(1));
            by_y.unwrap_or_else(|| exactly(&self.exact().y, &other.exact().y))
        })
    }

    /// On which side of the line a -> b it lies: `Greater` = left.
    pub(super) fn side(&self, a: Point, b: Point) -> Ordering {
        let interval = Interval::of;
        let quick = (interval(b.x) - interval(a.x)) * (self.y - interval(a.y))
            - (interval(b.y) - interval(a.y)) * (self.x - interval(a.x));
        let finer = || {
            let [x, y] = *self.finer();
            let along = [(b.x, a.x), (b.y, a.y)].map(|(b, a)| DoubleDouble::difference(b, a));
            let from_a = [x?.minus(DoubleDouble::of(a.x)), y?.minus(DoubleDouble::of(a.y))];
            along[0].times(from_a[1]).minus(along[1].times(from_a[0])).sign()
        };
        quick.sign().or_else(finer).unwrap_or_else(|| {
            let Exact { x, y, w } = self.exact();
            let from_a = |part: &Expansion, start: f64| part.clone().minus(&Expansion::of(start).times(w));
            let along = [Expansion::difference(b.x, a.x), Expansion::difference(b.y, a.y)];
            cross(&along, &[from_a(x, a.x), from_a(y, a.y)]).sign()
        })
    }

    /// The point of the grid in whose pixel it lies, exactly, and an upper bound of the distance.
    pub(super) fn on_grid(&self, grid: Grid) -> (Point, f64) {
        let exact = |part: fn(&Exact) -> &Expansion, line: f64| {
            let Exact { w, .. } = self.exact();
            part(self.exact()).clone().minus(&Expansion::of(line).times(w)).sign()
        };
        let round = |bounds: Interval, part: fn(&Exact) -> &Expansion| {
            let [mut centre, last] = [bounds.low, bounds.high].map(|x| grid.round(x));
            if centre < last {
                let Exact { w, .. } = self.exact();
                // Near enough to begin; lines between pixels are doubles, so the steps from there are exact.
                centre = grid.round(part(self.exact()).estimate() / w.estimate()).clamp(centre, last);
                while exact(part, centre - grid.half()).is_lt() {
                    centre -= grid.size();
                }
                while exact(part, centre + grid.half()).is_ge() {
                    centre += grid.size();
                }
            }
            // Only what may lie on the grid is looked at exactly.
            let may_be = bounds.low <= centre && centre <= bounds.high;
            let off = if may_be && (bounds.only().is_some() || exact(part, centre).is_eq()) {
                0.0
            } else {
                (centre - bounds.low).abs().max((bounds.high - centre).abs()).next_up()
            };
            (centre + 0.0, off.min(grid.half()))
        };
        let ((x, off_x), (y, off_y)) = (round(self.x, |e| &e.x), round(self.y, |e| &e.y));
        let off = off_x.hypot(off_y);
        (Point::new(x, y), if off > 0.0 { off.next_up() } else { 0.0 })
    }

    /// The nearest point with doubles as coordinates, within the range of the door, and how far it is from the
    /// crossing at most. Rounding keeps the order of the x and of the y of different crossings.
    pub(super) fn rounded(&self) -> (Point, f64) {
        let (p, off, _) = placed(self.ends);
        (p, off)
    }

    /// The nearest allowed double of a coordinate, and how far off it is.
    fn divide(&self, i: usize) -> (f64, f64) {
        let Exact { x, y, w } = self.exact();
        let part = [x, y][i];
        let rest = |q: f64| part.clone().minus(&Expansion::of(q).times(w)).estimate() / w.estimate();
        let first = part.estimate() / w.estimate();
        let nearest = at_door(nearest_of(first + rest(first), rest));
        (nearest, rest(nearest))
    }

    /// Both coordinates as well as two doubles for each number tell them, computed once.
    fn finer(&self) -> &[Option<DoubleDouble>; 2] {
        self.finer.get_or_init(|| Box::new(quotients(self.ends)))
    }
}

/// The crossing of two segments: the nearest point with doubles as coordinates, within the range of the door, how far it is
/// from the crossing at most, and between which bounds the crossing lies to its right.
pub(in crate::plane) fn placed(ends: [[Point; 2]; 2]) -> (Point, f64, [f64; 2]) {
    let quick = quotients(ends);
    let allowed = |&(x, _): &(f64, f64)| x == 0.0 || x.abs() >= SMALLEST;
    let exactly = |i: usize| Crossing::new([0, 1], ends).divide(i);
    // Along an upright or a level segment one coordinate is known.
    let known =
        |part: fn(Point) -> f64| ends.iter().find(|[a, b]| part(*a) - part(*b) == 0.0).map(|[a, _]| (part(*a), 0.0));
    let divide = |part: fn(Point) -> f64, i: usize| {
        let quick = || quick[i].and_then(DoubleDouble::nearest).filter(allowed);
        known(part).or_else(quick).unwrap_or_else(|| exactly(i))
    };
    let ((px, off_x), (py, off_y)) = (divide(|p| p.x, 0), divide(|p| p.y, 1));
    let right = quick[0].map_or([f64::NEG_INFINITY, f64::INFINITY], |x| x.above(px));
    // Both rests are good to a few last places.
    (Point::new(px, py), off_x.hypot(off_y) * (1.0 + 8.0 * f64::EPSILON), right)
}

/// How far off a point two lines cross, each given by two points; `None` if they do not. Good to ten digits of each number.
pub(in crate::plane) fn crossing_from(p: Point, ends: [[Point; 2]; 2]) -> Option<[f64; 2]> {
    let quick = quotients(ends);
    let crossing = OnceCell::new();
    let from = |i: usize, start: f64| {
        let known =
            quick[i].map(|quotient| quotient.above(start)).filter(|[least, most]| most - least <= 1e-10 * least.abs());
        known.map(|[least, most]| 0.5 * (least + most)).or_else(|| {
            let Exact { x, y, w } = crossing.get_or_init(|| Crossing::new([0, 1], ends)).exact();
            let rest = [x, y][i].clone().minus(&Expansion::of(start).times(w)).estimate();
            w.sign().is_ne().then(|| rest / w.estimate())
        })
    };
    Some([from(0, p.x)?, from(1, p.y)?])
}

/// How far off a point the point of a line next to it is.
pub(in crate::plane) fn foot_from(p: Point, [a, b]: [Point; 2]) -> [f64; 2] {
    let [along, to] =
        [(a, b), (p, a)].map(|(p, q)| [(p.x, q.x), (p.y, q.y)].map(|(p, q)| DoubleDouble::difference(q, p)));
    let across = along[0].times(to[1]).minus(along[1].times(to[0])).estimate();
    let [x, y] = [b.x - a.x, b.y - a.y];
    let share = across / x.hypot(y);
    [-y, x].map(|side| share * (side / x.hypot(y)))
}

/// Both coordinates of a crossing as well as two doubles for each number tell them.
fn quotients(ends: [[Point; 2]; 2]) -> [Option<DoubleDouble>; 2] {
    let [along, across, between] = vectors(ends);
    // W and T at once, then both coordinates.
    let of_both = |i: usize| along.of_places(between, i);
    let products = of_both(0).times(across.only(1)).minus(of_both(1).times(across.only(0)));
    let (w, t) = (products.only(0), products.only(1));
    DoubleDouble::of(coordinates(ends[0][0])).times(w).plus(t.times(along)).over(w)
}

/// Whether one pair of segments is the other one, moved. Then their crossings lie from each other as their first ends do.
#[inline]
pub(in crate::plane) fn is_moved(one: [[Point; 2]; 2], other: [[Point; 2]; 2]) -> bool {
    vectors(one) == vectors(other)
}

/// Along both segments, and from the first to the second, exactly.
#[inline]
fn vectors([[a, b], [c, d]]: [[Point; 2]; 2]) -> [DoubleDouble<Two>; 3] {
    let vector = |p: Point, q: Point| DoubleDouble::difference(coordinates(q), coordinates(p));
    [vector(a, b), vector(c, d), vector(a, c)]
}

#[inline(always)]
fn coordinates(p: Point) -> Two {
    Two([p.x, p.y])
}

/// Of the doubles round `q` the one with the smallest rest; of two the lower one.
fn nearest_of(q: f64, rest: impl Fn(f64) -> f64) -> f64 {
    let closer = |a: &f64, b: &f64| rest(*a).abs().total_cmp(&rest(*b).abs());
    [q.next_down(), q, q.next_up()].into_iter().min_by(closer).unwrap_or(q)
}

/// Numbers too close to 0 become 0 or the smallest number allowed.
fn at_door(x: f64) -> f64 {
    if x.abs() >= SMALLEST {
        x
    } else if x.abs() * 2.0 < SMALLEST {
        0.0
    } else {
        SMALLEST.copysign(x)
    }
}

/// A box round the crossing: from the formula in intervals, and no larger than the boxes of the segments.
fn bounds([[a, b], [c, d]]: [[Point; 2]; 2]) -> [Interval; 2] {
    let v = |p: Point, q: Point| [(p.x, q.x), (p.y, q.y)].map(|(p, q)| Interval::of(q) - Interval::of(p));
    let times = |p: [Interval; 2], q: [Interval; 2]| p[0] * q[1] - p[1] * q[0];
    let (along, across) = (v(a, b), v(c, d));
    let share = times(v(a, c), across).over(times(along, across));
    let everything = Interval { low: f64::NEG_INFINITY, high: f64::INFINITY };
    let at = |start: f64, along: Interval| share.map_or(everything, |t| Interval::of(start) + t * along);
    let x = at(a.x, along[0]).within(a.x, b.x).within(c.x, d.x);
    let y = at(a.y, along[1]).within(a.y, b.y).within(c.y, d.y);
    [x, y]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn crossing(list: [(f64, f64); 4]) -> Crossing {
        let [a, b, c, d] = list.map(Point::from);
        Crossing::new([0, 1], [[a, b], [c, d]])
    }

    #[test]
    fn crossings_are_compared_exactly() {
        // Three lines through (1/3, 1/3), and one that misses it by less than any double can tell.
        let third = crossing([(0., 0.), (1., 1.), (0., 0.5), (1., 0.)]);
        let same = Crossing { edges: [2, 3], ..crossing([(-1., -1.), (3., 3.), (0., 1.), (0.5, 0.)]) };
        assert_eq!(third.order_to(&same), Ordering::Equal);
        assert_eq!(third.side(Point::new(0., 1.), Point::new(0.5, 0.)), Ordering::Equal);
        let tiny = 2f64.powi(-100);
        assert_eq!(third.side(Point::new(0., 1.), Point::new(0.5, -tiny)), Ordering::Greater);
        assert_eq!(third.side(Point::new(0., 1.), Point::new(0.5, tiny)), Ordering::Less);
        let later = Crossing { edges: [2, 3], ..crossing([(0., 0.), (1., 1.), (0., 1.), (0.5, tiny)]) };
        assert_eq!(third.order_to(&later), Ordering::Less);
        assert_eq!(third.order_to_point(Point::new(1.0 / 3.0, 0.0)), Ordering::Greater);
        assert_eq!(third.order_to_point(Point::new((1.0_f64 / 3.0).next_up(), 0.0)), Ordering::Less);
        let (p, off) = third.rounded();
        assert_eq!((p, off < 1e-16, off > 1e-18), (Point::new(1.0 / 3.0, 1.0 / 3.0), true, true));
    }

    #[test]
    fn rounding_stays_at_the_door_and_knows_exact_points() {
        let exact = crossing([(0., 0.), (4., 4.), (0., 4.), (4., 0.)]);
        assert_eq!(exact.rounded(), (Point::new(2.0, 2.0), 0.0));
        let near_zero = crossing([(-1., 0.), (1., SMALLEST), (-1., SMALLEST), (1., 0.)]);
        let (p, off) = near_zero.rounded();
        assert_eq!(p.check(), Ok(()));
        assert!(off <= SMALLEST, "{off}");
        let far = crossing([(-3e60, -3e60), (3e60, 3e60), (-3e60, 1.8e-43), (3e60, 1.7e60)]);
        assert!(far.rounded().0.check().is_ok() && far.rounded().1 < 1e45, "{:?}", far.rounded());
    }

    #[test]
    fn two_doubles_for_each_number_round_as_exact_ones() {
        let mut state = 5_u64;
        let mut below = |n: u64| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 33) % n
        };
        let mut quick = 0;
        for round in 0..40_000 {
            let scale = 2f64.powi(below(80) as i32 - 40);
            // Some with few bits, some far from the origin, some nearly on one line.
            let (far, flat) = ([0.0, 1e6, 1e12][round % 3], [1.0, 1.0, 1e-9][round / 3 % 3]);
            let size = [9, 1 << 30][round / 9 % 2];
            let mut part = |sign: f64| sign * (1 + below(size)) as f64;
            let mut place = |u: f64, v: f64| Point::new(scale * (far + part(u)), scale * (far + flat * part(v)));
            let [a, b, c, d] = [place(-1., -1.), place(1., 1.), place(-1., 1.), place(1., -1.)];
            let side = |p, q, r| crate::geometry::predicates::orientation(p, q, r);
            if side(a, b, c).is_le() || side(a, b, d).is_ge() || side(c, d, a).is_ge() || side(c, d, b).is_le() {
                continue;
            }
            let crossing = Crossing::new([0, 1], [[a, b], [c, d]]);
            for (i, found) in quotients(crossing.ends).into_iter().enumerate() {
                let Some((nearest, off)) = found.and_then(DoubleDouble::nearest) else { continue };
                let (expected, rest) = crossing.divide(i);
                assert_eq!(nearest.to_bits(), expected.to_bits(), "{:?}", crossing.ends);
                assert!(off >= rest.abs() * (1.0 - 1e-15) && off <= rest.abs() * (1.0 + 1e-9), "{:?}", crossing.ends);
                quick += 1;
            }
        }
        assert!(quick > 50_000, "{quick}");
    }
}
