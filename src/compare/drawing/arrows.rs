//! Arrows that are one filled outline, shaft and head together, as plotting programs draw them.
//!
//! ```text
//!   ●▬▬▬▬▬▬▬▬▶●      slender, the same on both sides of a straight way from one vertex to another, and with its point
//!   ●◥◣_____ __●      there: a line from the middle of its tail to its tip
//! ```
//!
//! Nothing else ends at its other corners: a slender triangle between vertices is a face. Where no vertices are drawn at
//! both ends nothing tells such an arrow from a face, and it stays what it is.

use super::rims::Frame;
use super::slack::Slack;
use super::{Drawing, Line, Outline};
use crate::compare::ends::Circles;
use crate::compare::painting::{Part, Shape};
use crate::compare::pairing::{Places, distance, span};
use crate::compare::rings::open;
use crate::plane::Point;
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

/// An arrow is at least and at most so wide, as parts of the drawing, and at least so many times as long.
const WIDE: [f64; 2] = [1e-3, 0.075];
const LONG: f64 = 2.0;
/// How well its sides fit, as a part of its width.
const FIT: f64 = 0.04;
/// Its corners, pieces of curves counted: at least, and at most.
const CORNERS: [usize; 2] = [3, 48];
/// How far from its ends its vertices may be, as a part of the drawing: whether they are near enough is told of its line.
const GAP: f64 = 0.04;
/// The squares that may be vertices: how slender, how exact, and how large as a part of the drawing.
const BOX: [f64; 3] = [1.1, 0.03, 0.08];

/// An outline that may be an arrow.
struct Arrow {
    shape: u32,
    ends: [Point; 2],
    /// Its corners that are not its ends.
    corners: Vec<Point>,
}

/// Reads arrows as lines. `coats` says what each shape painted, `tolerance` is a part of the drawing. Returns how many of
/// them have curves. O(n log n).
pub(super) fn read(drawing: &mut Drawing, coats: &[Range<u32>], tolerance: f64) -> usize {
    let mut points: Vec<Point> = drawing.points().collect();
    if points.is_empty() {
        points.extend(drawing.outlines.iter().flat_map(|outline| &outline.points));
    }
    let slack = Slack::new(span(&points), tolerance);
    let mut counts: BTreeMap<u32, usize> = BTreeMap::new();
    drawing.outlines.iter().for_each(|outline| *counts.entry(outline.shape).or_default() += 1);
    let may_be = |outline: &&Outline| {
        let is_plain = outline.hidden.is_none() && !outline.empty && !outline.aside && outline.legend == 0;
        is_plain && counts.get(&outline.shape) == Some(&1)
    };
    let arrow = |outline: &Outline| {
        let (ends, corners) = ends(&outline.points, slack.size)?;
        Some(Arrow { shape: outline.shape, ends, corners })
    };
    let mut arrows: Vec<Arrow> = drawing.outlines.iter().filter(may_be).filter_map(arrow).collect();
    if arrows.is_empty() {
        return 0;
    }
    keep(&mut arrows, drawing, slack);
    let gone: BTreeSet<u32> = arrows.iter().map(|arrow| arrow.shape).collect();
    drawing.lines.retain(|line| !gone.contains(&line.shape));
    let curved = drawing.outlines.iter().filter(|outline| outline.curved && gone.contains(&outline.shape)).count();
    drawing.outlines.retain(|outline| !gone.contains(&outline.shape));
    for Arrow { shape, ends, .. } in arrows {
        let range = coats[shape as usize].clone();
        let mut half: f64 = 0.0;
        for i in range.clone() {
            let coat = &mut drawing.painting.coats[i as usize];
            coat.part = Part::Area;
            if let Shape::Stroke(_, rim) = coat.shape {
                half = half.max(rim);
            }
        }
        drawing.bars.extend(range);
        drawing.lines.push(Line::plain(ends, half, shape));
    }
    curved
}

/// Keeps those that lead from one vertex to another, and at whose other corners nothing is. They are longer than the room
/// in which vertices are looked for: heads of lines are shorter.
fn keep(arrows: &mut Vec<Arrow>, drawing: &Drawing, slack: Slack) {
    let shapes: BTreeSet<u32> = arrows.iter().map(|arrow| arrow.shape).collect();
    let is_other = |shape: u32| !shapes.contains(&shape);
    let lines = drawing.lines.iter().filter(|line| is_other(line.shape)).flat_map(|line| line.ends);
    let outlines = drawing.outlines.iter().filter(|outline| is_other(outline.shape));
    let dots: Vec<(Point, f64)> =
        drawing.dots.iter().filter(|dot| dot.hidden.is_none()).map(|dot| (dot.at, dot.radius)).collect();
    let squares = outlines.clone().filter_map(|outline| {
        let frame = Frame::of(open(&outline.points), BOX[0], BOX[1])?;
        (frame.reach() <= BOX[2] * slack.size).then_some((frame.middle, frame.reach()))
    });
    let vertices: Vec<(Point, f64)> = dots.iter().copied().chain(squares).collect();
    let taken = lines.chain(outlines.flat_map(|outline| outline.points.iter().copied()));
    let taken = Places::thinned(taken.chain(dots.iter().map(|dot| dot.0)), slack.at());
    let middles = Places::thinned(vertices.iter().map(|vertex| vertex.0), slack.near());
    let around = vertices.into_iter().map(|(at, radius)| (at, radius + GAP * slack.size));
    let mut circles = Circles::new(around.collect(), slack.tolerance);
    let mut vertex = |end: Point, other: Point| {
        let here = middles.near(end, slack.near()).map(|i| middles.points()[i as usize]);
        here.or_else(|| circles.aimed(end, other, 0.0, slack.tolerance))
    };
    arrows.retain(|Arrow { ends: [tail, tip], corners, .. }| {
        let is_free = corners.iter().all(|&p| taken.near(p, slack.at()).is_none());
        let at = is_free.then(|| [vertex(*tail, *tip), vertex(*tip, *tail)]);
        matches!(at, Some([Some(a), Some(b)]) if distance(a, b) > slack.near())
    });
}

/// The ends of an outline that is one arrow, in a drawing of this size, and its corners elsewhere. O(corners²) of
/// a few corners.
fn ends(points: &[Point], size: f64) -> Option<([Point; 2], Vec<Point>)> {
    let mut points = open(points).to_vec();
    points.dedup();
    let count = points.len();
    if !(CORNERS[0]..=CORNERS[1]).contains(&count) {
        return None;
    }
    // Corners and middles of sides, in turn.
    let at = |i: usize| {
        let (p, q) = (points[i / 2 % count], points[i.div_ceil(2) % count]);
        Point::new(0.5 * (p.x + q.x), 0.5 * (p.y + q.y))
    };
    (0..count).find_map(|i| {
        let (a, b) = (at(i), at(i + count));
        let long = distance(a, b);
        let way = Point::new((b.x - a.x) / long, (b.y - a.y) / long);
        let place = |p: Point| {
            let (x, y) = (p.x - a.x, p.y - a.y);
            [x * way.x + y * way.y, y * way.x - x * way.y]
        };
        let places = || points.iter().map(|&p| place(p));
        let half = places().map(|p| p[1].abs()).fold(0.0, f64::max);
        let low = places().map(|p| p[0]).fold(0.0, f64::min);
        let high = places().map(|p| p[0]).fold(long, f64::max);
        let is_slender = (WIDE[0] * size..=WIDE[1] * size).contains(&(2.0 * half)) && high - low >= LONG * 2.0 * half;
        let slack = FIT * 2.0 * half;
        let is_even = || {
            (0..count).all(|j| {
                let ([s, u], [t, v]) = (place(points[j]), place(points[(i + count - j) % count]));
                (s - t).abs() <= slack && (u + v).abs() <= slack
            })
        };
        // A corner at one end, and at both ends nothing beyond it on the sides.
        let is_tip = |j: usize, end: f64| j.is_multiple_of(2) && (place(at(j))[0] - end).abs() <= 1e-9 * long;
        if !is_slender || !(is_tip(i, low) || is_tip(i + count, high)) || !is_even() {
            return None;
        }
        let on_way = |t: f64| Point::new(a.x + t * way.x, a.y + t * way.y);
        let is_aside = |p: &Point| place(*p)[1].abs() > slack;
        Some(([on_way(low), on_way(high)], points.iter().copied().filter(is_aside).collect()))
    })
}
