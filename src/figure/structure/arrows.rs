//! Pointers as arrows: the geometry of each family.
//!
//! ```text
//!   next, corner < 190°     ──── h ───╮       a quadratic from the tip of h to the tail of next(h), its control
//!                                     ▾       point near the corner of the inset polygon, 4 px clear of the disc
//!                                     │ next
//!
//!   next, wider corner          ╭───────╮
//!                          ─ h ─╯ (v3)  ▾     swerve to the radius r + 4.5, clockwise round the vertex, swerve
//!                                       │     out; a dangling end (360°) is no special case
//!
//!   twin      ══════╪══════     straight across the edge, two heads
//!   outgoing  (v)⌒▸════════     from the disc onto the first third of the shaft
//! ```
//!
//! So a face reads as one closed loop of shafts and next arrows, and `prev` needs no arrow: it is the same
//! loop backwards. Angles are compared by sines and cosines of unit vectors; nothing here calls `sin` or `atan`.

use crate::figure::canvas::arc::arc;
use crate::figure::canvas::scene::{Node, Step};
use crate::figure::canvas::vector::{Xy, xy};
use crate::figure::layout::crowd::Shape;
use crate::figure::structure::half_edges::Shaft;

/// Length of a head; its width is 0.92 of that.
const HEAD: f64 = 6.5;
/// Distance of an arrow from a vertex disc it goes round.
const CLEAR: f64 = 4.5;
/// The cosine of 190°: up to there a corner is rounded off, beyond it the arrow goes round the vertex.
const STRAIGHT: f64 = -0.984_807_753;
/// Cosine and sine of 32°, the part of the way round a vertex that a swerve takes.
const SWERVE: (f64, f64) = (0.848_048_096, 0.529_919_264);

/// A line with one head or two.
#[derive(Clone, PartialEq, Debug)]
pub(crate) struct Arrow {
    pub(crate) start: Xy,
    pub(crate) steps: Vec<Step>,
    /// Tip, left corner, notch, right corner of each.
    pub(crate) heads: Vec<[Xy; 4]>,
}

/// The vertex between two half-edges.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Turn {
    pub(crate) at: Xy,
    pub(crate) radius: f64,
    /// Whether the second half-edge is the twin of the first.
    pub(crate) back: bool,
}

impl Arrow {
    /// The line and its heads.
    pub(crate) fn nodes(self, line: &'static str, head: &'static str) -> [Node; 2] {
        let outlines = self.heads.iter().map(|head| head.to_vec()).collect();
        [
            Node::Curve { class: line, start: self.start, steps: self.steps },
            Node::Area { class: head, hatch: None, outlines },
        ]
    }

    /// Half way between its two ends.
    pub(crate) fn middle(&self) -> Xy {
        self.heads.first().map_or(self.start, |head| (self.start + head[0]) * 0.5)
    }

    /// What it covers, curves as a few chords.
    pub(crate) fn shapes(&self) -> Vec<Shape> {
        let mut at = self.start;
        let mut way = vec![at];
        for step in &self.steps {
            match *step {
                Step::Line(_) => {}
                Step::Round { radius, large, to } => arc(at, to, radius, large, &mut |first, second, to| {
                    way.extend([cubic_middle(at, first, second, to), to]);
                    at = to;
                }),
                Step::Quad(control, to) => way.push(quad(at, control, to, 0.5)),
                Step::Cubic(first, second, to) => way.push(cubic_middle(at, first, second, to)),
            }
            at = step.end();
            way.push(at);
        }
        let chords = way.windows(2).map(|w| Shape::Segment(w[0], w[1], 1.0));
        let sides = |&[tip, left, _, right]: &[Xy; 4]| [left, right].map(|end| Shape::Segment(tip, end, 0.5));
        chords.chain(self.heads.iter().flat_map(sides)).collect()
    }

    /// A straight arrow with a head at its end, and at its start if wanted.
    pub(crate) fn straight(from: Xy, to: Xy, double: bool) -> Option<Self> {
        let along = (to - from).unit()?;
        let size = HEAD.min(if double { 0.42 } else { 0.6 } * (to - from).length());
        let mut heads = vec![head(to, along, size)];
        let mut start = from;
        if double {
            heads.push(head(from, along * -1.0, size));
            start = from + along * (0.6 * size);
        }
        Some(Self { start, steps: vec![Step::Line(to - along * (0.6 * size))], heads })
    }

    /// Along a polyline.
    pub(crate) fn through(points: &[Xy]) -> Option<Self> {
        let (&last, way) = points.split_last()?;
        let (&start, bends) = way.split_first()?;
        let along = (last - *way.last()?).unit()?;
        let end = Step::Line(last - along * (0.6 * HEAD));
        let steps = bends.iter().map(|&p| Step::Line(p)).chain([end]).collect();
        Some(Self { start, steps, heads: vec![head(last, along, HEAD)] })
    }
}

/// Tip, left corner, notch, right corner.
pub(crate) fn head(tip: Xy, along: Xy, size: f64) -> [Xy; 4] {
    let (back, aside) = (tip - along * size, along.left() * (0.46 * size));
    [tip, back + aside, tip - along * (0.7 * size), back - aside]
}

/// The middle of a curve by two control points.
fn cubic_middle(a: Xy, first: Xy, second: Xy, b: Xy) -> Xy {
    (a + (first + second) * 3.0 + b) * 0.125
}

fn quad(a: Xy, control: Xy, b: Xy, t: f64) -> Xy {
    let s = 1.0 - t;
    a * (s * s) + control * (2.0 * s * t) + b * (t * t)
}

/// A quadratic cut back so that it ends inside a head at `b`.
fn quad_to_head(a: Xy, control: Xy, b: Xy, size: f64) -> (Step, [Xy; 4]) {
    let far = |i: &i32| (quad(a, control, b, f64::from(*i) / 32.0) - b).length() >= 0.75 * size;
    let t = f64::from((0..32).rev().find(far).unwrap_or(0)) / 32.0;
    let end = quad(a, control, b, t);
    let along = (b - end).unit().unwrap_or(xy(1.0, 0.0));
    (Step::Quad(a + (control - a) * t, end), head(b, along, size))
}

/// A quadratic with a head of this size at its end.
fn curved(start: Xy, control: Xy, end: Xy, size: f64) -> Arrow {
    let (step, head) = quad_to_head(start, control, end, size);
    Arrow { start, steps: vec![step], heads: vec![head] }
}

/// From the tip of a half-edge to the tail of the next one. Without a vertex between them (a wrong pointer)
/// the arrow sweeps through the open.
pub(crate) fn next(from: &Shaft, to: &Shaft, turn: Option<Turn>) -> Arrow {
    let (tip, tail) = (from.tip, to.tail);
    let distance = (tail - tip).length();
    let size = HEAD.min(0.6 * distance);
    let Some(turn) = turn else { return sweep(from, to, size) };
    let back = from.along * -1.0;
    let (sine, cosine) = (to.along.turn(back), to.along.dot(back));
    let wide = sine <= 0.0 && (STRAIGHT..=0.999_999).contains(&cosine);
    if !turn.back && !wide {
        let control = corner_control(from, to, turn, sine, cosine);
        return curved(tip, control, tail, size);
    }
    round(from, to, turn, size)
}

/// The control point of a corner below 190°: the corner of the inset polygon, pushed away from the vertex until
/// the middle of the curve is 4 px clear of the disc.
fn corner_control(from: &Shaft, to: &Shaft, turn: Turn, sine: f64, cosine: f64) -> Xy {
    let bisector = (from.along.left() + to.along.left()).unit().unwrap_or_else(|| from.along.left());
    let middle = ((from.tip + to.tail) * 0.5 - turn.at).dot(bisector);
    let half = ((1.0 - cosine) / 2.0).max(0.0).sqrt();
    let offset = 0.5 * (from.offset + to.offset);
    let mut control = turn.at + bisector * (offset / half.max(1e-3)).min(middle.max(offset));
    if sine > 0.2 {
        // Where the two lines meet, if that is ahead of the tip and behind the tail.
        let between = to.tail - from.tip;
        let (ahead, behind) = (between.turn(to.along), from.along.turn(between));
        let scale = from.along.turn(to.along);
        if ahead / scale >= 0.0 && behind / scale >= 0.0 {
            control = from.tip + from.along * (ahead / scale);
        }
    }
    let missing = 2.0 * (turn.radius + 4.0) - middle - (control - turn.at).dot(bisector);
    control + bisector * missing.max(0.0)
}

/// Round the vertex, clockwise as seen.
fn round(from: &Shaft, to: &Shaft, turn: Turn, size: f64) -> Arrow {
    let (tip, tail) = (from.tip, to.tail);
    let shorter = from.edge_length.min(to.edge_length);
    let radius = (turn.radius + CLEAR).min((0.45 * shorter).max(turn.radius + 1.0));
    let direction = |p: Xy| (p - turn.at).unit().unwrap_or(xy(0.0, -1.0));
    let (cosine, sine) = SWERVE;
    let first = direction(tip) * cosine - direction(tip).left() * sine;
    let last = direction(tail) * cosine + direction(tail).left() * sine;
    let (enter, leave) = (turn.at + first * radius, turn.at + last * radius);
    let control = |on: Xy, radial: Xy, end: Xy, sign: f64| on - radial.left() * (sign * 0.5 * (end - on).length());
    let swerve = Step::Quad(control(enter, first, tip, -1.0), enter);
    let arc = Step::Round { radius, large: first.turn(last) > 0.0, to: leave };
    let (end, head) = quad_to_head(leave, control(leave, last, tail, 1.0), tail, size);
    Arrow { start: tip, steps: vec![swerve, arc, end], heads: vec![head] }
}

/// From anywhere to anywhere: on the side where both faces are, past the shafts and labels between; straight on where
/// the faces lie on opposite sides.
fn sweep(from: &Shaft, to: &Shaft, size: f64) -> Arrow {
    let reach = (0.35 * (to.tail - from.tip).length()).clamp(10.0, 80.0);
    let both = from.along.left() + to.along.left();
    let (aside, ahead) = (both * (0.6 * reach), (0.5 - 0.2 * both.length()) * reach);
    let first = from.tip + from.along * ahead + aside;
    let second = to.tail - to.along * ahead + aside;
    let along = (to.tail - second).unit().unwrap_or(to.along);
    let end = to.tail - along * (0.6 * size);
    Arrow { start: from.tip, steps: vec![Step::Cubic(first, second, end)], heads: vec![head(to.tail, along, size)] }
}

/// Across the edge at `t` of it, seen from `from`; with two heads if the twins agree.
pub(crate) fn twin(from: &Shaft, to: &Shaft, mutual: bool, t: f64) -> Option<Arrow> {
    let aside = from.along.left();
    if mutual {
        let p = from.at(t);
        return Arrow::straight(p - aside * 1.2, p - aside * (from.offset + to.offset - 1.2), true);
    }
    let (p, q) = (from.at(t), to.at(t));
    let bow = (q - p).left() * 0.2;
    Some(curved(p, (p + q) * 0.5 + bow, q, HEAD.min(0.6 * (q - p).length())))
}

/// From the disc of a vertex onto the first third of a shaft that should begin there.
pub(crate) fn outgoing(vertex: Xy, radius: f64, shaft: &Shaft) -> Option<Arrow> {
    let aside = shaft.along.left();
    let rise = (0.9 * shaft.offset).min(7.0);
    let end = shaft.tail + shaft.along * (shaft.length() / 3.0).min(34.0) + aside * 0.8;
    let control = end - shaft.along * (0.55 * (end - vertex).length()).min(20.0) + aside * rise;
    let start = vertex + (control - vertex).unit()? * (radius + 1.0);
    Some(curved(start, control, end, HEAD.min(0.5 * (end - start).length())))
}

/// From the edge side of a shaft, near its tail, to the disc of the vertex it begins at: the face side belongs
/// to the `next` that arrives.
pub(crate) fn origin(shaft: &Shaft, vertex: Xy, radius: f64) -> Option<Arrow> {
    let aside = shaft.along.left();
    let start = shaft.tail + shaft.along * (0.2 * shaft.length()).min(10.0) - aside * 1.4;
    let back = (start - vertex).dot(shaft.along);
    let control = start - shaft.along * (0.45 * back) - aside * (0.75 * shaft.offset);
    let end = vertex + (control - vertex).unit()? * (radius + 1.5);
    Some(curved(start, control, end, HEAD.min(0.6 * (end - start).length())))
}
