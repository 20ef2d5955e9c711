//! Lines that end at the rims of squares and boxes, as programs draw nodes of graphs.
//!
//! ```text
//!   ┌───┐        ┌───┐      the line stops where it meets the box, and points to its middle: there its vertex is
//!   │ a ├────────┤ b │
//!   └───┘        └───┘
//! ```
//!
//! At a square it may stop at the circle through the corners, exactly there: so much room some programs leave round a node,
//! whatever its shape.

use super::heads::{Heads, Inked};
use super::slack::Slack;
use super::{Drawing, Line};
use crate::compare::ends::Loose;
use crate::compare::painting::Shape;
use crate::compare::pairing::{distance, middle};
use crate::plane::Point;
use std::collections::BTreeMap;
use std::ops::Range;

/// How far aside of its middle a line may point, in tolerances.
const ASIDE: f64 = 4.8;
/// How far from the circle through the corners of a square a line may stop, in tolerances.
const ROUND: f64 = 2.0;
/// A box is a square if it is no more than so many times as long as wide.
const SQUARE: f64 = 1.03;
/// What an arrow that is an area gets at a box is as wide as this part of that.
const HAIR: f64 = 0.02;
/// Boxes looked at for all ends; what takes more stays as it is.
const WORK: usize = 20_000_000;

/// A box: its middle, half of two sides that meet, and half the width of its rim.
#[derive(Clone, Copy)]
pub(super) struct Frame {
    pub(super) middle: Point,
    pub(super) halves: [Point; 2],
    pub(super) rim: f64,
}

impl Frame {
    /// The box with these corners, if it is one no more than so many times as long as wide.
    pub(super) fn of(points: &[Point], slender: f64, fit: f64) -> Option<Self> {
        let &[a, b, c, d] = points else { return None };
        let half = |p: Point, q: Point| Point::new(0.5 * (q.x - p.x), 0.5 * (q.y - p.y));
        let [at, other] = [[a, c], [b, d]].map(middle);
        let halves = [half(a, b), half(b, c)];
        let [long, wide] = halves.map(|h| h.x.hypot(h.y));
        let slack = fit * long.min(wide);
        let is_right = (halves[0].x * halves[1].x + halves[0].y * halves[1].y).abs() <= fit * long * wide;
        let is_even = distance(at, other) <= slack && (distance(a, c) - distance(b, d)).abs() <= slack;
        let is_stout = long.min(wide) > 0.0 && long.max(wide) <= slender * long.min(wide);
        (is_right && is_even && is_stout).then_some(Self { middle: at, halves, rim: 0.0 })
    }

    /// How far a point lies beyond the sides; less than 0 within.
    fn beyond(&self, p: Point) -> f64 {
        let way = Point::new(p.x - self.middle.x, p.y - self.middle.y);
        let off = self.halves.map(|half| {
            let long = half.x.hypot(half.y);
            (way.x * half.x + way.y * half.y).abs() / long - long
        });
        off[0].max(off[1])
    }

    /// Whether something ends here that may be so far beyond the rim, or, at a square, so far from the circle through its
    /// corners.
    fn stops(&self, p: Point, more: f64, slack: f64) -> bool {
        self.beyond(p) <= more || self.is_square() && (distance(p, self.middle) - self.reach()).abs() <= slack
    }

    fn is_square(&self) -> bool {
        let [long, wide] = self.halves.map(|half| half.x.hypot(half.y));
        long.max(wide) <= SQUARE * long.min(wide)
    }

    /// How far the corners are from the middle.
    pub(super) fn reach(&self) -> f64 {
        let [a, b] = self.halves;
        (a.x + b.x).hypot(a.y + b.y)
    }

    /// The radius of the circle that touches the longer sides.
    pub(super) fn radius(&self) -> f64 {
        let [long, wide] = self.halves.map(|half| half.x.hypot(half.y));
        long.min(wide)
    }

    pub(super) fn corners(&self) -> [Point; 4] {
        let [a, b] = self.halves;
        [[1.0, 1.0], [1.0, -1.0], [-1.0, -1.0], [-1.0, 1.0]]
            .map(|[s, t]| Point::new(self.middle.x + s * a.x + t * b.x, self.middle.y + s * a.y + t * b.y))
    }
}

/// Ends of lines at the rims of boxes.
pub(super) struct Aimed {
    /// By the shapes of the boxes: the number of each line, and which end of it.
    pub(super) ends: BTreeMap<u32, Vec<(usize, usize)>>,
    /// Whether most ends of lines that reach no other vertex are such ends.
    pub(super) are_most: bool,
}

/// Finds the ends of lines at the rims of boxes, which are given with their shapes, up to this slack. `is_reached`
/// says which points are at other vertices. O(n log n), up to a cap.
pub(super) fn aimed(
    drawing: &Drawing,
    boxes: &BTreeMap<u32, Frame>,
    heads: &Heads,
    slack: Slack,
    is_reached: impl Fn(Point) -> bool,
) -> Aimed {
    let mut out = Aimed { ends: BTreeMap::new(), are_most: false };
    if boxes.is_empty() {
        return out;
    }
    let is_line = |(i, line): &(usize, &Line)| {
        let is_plain = !line.aside && line.hidden.is_none() && line.legend == 0;
        is_plain && !boxes.contains_key(&line.shape) && !heads.has(*i)
    };
    let lines: Vec<(usize, &Line)> = drawing.lines.iter().enumerate().filter(is_line).collect();
    let mut loose = Loose::default();
    lines.iter().for_each(|(_, line)| loose.add(line.ends));
    let cell = boxes.values().map(Frame::reach).fold(slack.near(), f64::max);
    let place = |p: Point| ((p.x / cell).floor() as i64, (p.y / cell).floor() as i64);
    let mut cells: BTreeMap<(i64, i64), Vec<(u32, Frame)>> = BTreeMap::new();
    boxes.iter().for_each(|(shape, frame)| cells.entry(place(frame.middle)).or_default().push((*shape, *frame)));
    let (mut found, mut all, mut looked) = (0, 0, 0);
    for (number, line) in lines {
        for end in 0..2 {
            let (own, other) = (line.ends[end], line.ends[1 - end]);
            all += usize::from(!is_reached(own));
            if !loose.is(own) {
                continue;
            }
            let tip = heads.end(number, line, end);
            let (x, y) = place(own);
            let near = (x - 2..=x + 2).flat_map(|x| (y - 2..=y + 2).map(move |y| (x, y)));
            let near = near.flat_map(|at| cells.get(&at).map_or(&[][..], Vec::as_slice));
            let (mut at, mut count) = (None, 0);
            for (shape, frame) in near {
                looked += 1;
                if looked > WORK {
                    return Aimed { ends: BTreeMap::new(), are_most: false };
                }
                let reach = frame.rim + line.half + slack.near();
                if frame.stops(tip, reach, ROUND * slack.tolerance)
                    && frame.beyond(other) > reach
                    && points_at([other, own], frame, ASIDE * slack.tolerance)
                {
                    (at, count) = (Some(*shape), count + usize::from(at != Some(*shape)));
                }
            }
            // At the rims of two boxes it ends at neither.
            if let Some(shape) = at.filter(|_| count == 1) {
                found += 1;
                out.ends.entry(shape).or_default().push((number, end));
            }
        }
    }
    out.are_most = 2 * found > all;
    out
}

/// Whether a line from one point to another goes on to the middle of a box, or no farther aside of it than this.
fn points_at([from, to]: [Point; 2], frame: &Frame, aside: f64) -> bool {
    let long = distance(from, to);
    let way = Point::new((to.x - from.x) / long, (to.y - from.y) / long);
    let rest = Point::new(frame.middle.x - to.x, frame.middle.y - to.y);
    rest.x * way.x + rest.y * way.y > 0.0 && (rest.x * way.y - rest.y * way.x).abs() <= aside
}

/// Lets lines end in the middles of boxes, and their ink at the circles that stand for these. `coats` says what each shape
/// painted.
pub(super) fn join(drawing: &mut Drawing, ends: &[((usize, usize), Frame)], inked: &Inked, coats: &[Range<u32>]) {
    for ((number, end), frame) in ends {
        drawing.lines[*number].ends[*end] = frame.middle;
        let before = inked.ends(*number);
        let other = before[1 - end];
        let part = frame.radius() / distance(other, frame.middle);
        let towards = |p: f64, q: f64| q + part * (p - q);
        let rim = Point::new(towards(other.x, frame.middle.x), towards(other.y, frame.middle.y));
        let first = coats[drawing.lines[*number].shape as usize].start;
        let bar = drawing.bars.binary_search(&first).is_ok().then_some(first);
        let Some(coat) = inked.coat(*number).or(bar) else { continue };
        if distance(other, rim) <= distance(other, before[*end]) {
            continue;
        }
        match &mut drawing.painting.coats[coat as usize].shape {
            Shape::Stroke(ends, _) => ends[*end] = rim,
            Shape::Area(area) => *area = area.with(&strip([before[*end], rim], HAIR * frame.radius())),
            Shape::Disc(_) => {}
        }
    }
}

/// The corners of a strip along a way, of this half width.
fn strip([a, b]: [Point; 2], half: f64) -> Vec<Point> {
    let part = half / distance(a, b);
    let off = Point::new(-part * (b.y - a.y), part * (b.x - a.x));
    [(a, 1.0), (b, 1.0), (b, -1.0), (a, -1.0)].map(|(p, s)| Point::new(p.x + s * off.x, p.y + s * off.y)).to_vec()
}
