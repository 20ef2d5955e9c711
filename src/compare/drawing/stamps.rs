//! Vertices drawn as small squares or crosses, as plotting programs do.
//!
//! ```text
//!   ■──────□      a square, filled or hollow, whose middle is the end of a line
//!   │      │
//!   ✕──────+      two short lines of one length that cross in their middles, there
//! ```
//!
//! Each becomes a dot where it stands, as large as a circle in it. Only stamps of the size of most others count, and
//! none where a circle is drawn.

use super::{Dot, Drawing, Line};
use crate::compare::painting::{Disc, Part, Shape};
use crate::compare::pairing::{Places, distance, span};
use crate::plane::Point;
use std::collections::BTreeMap;
use std::ops::Range;

/// A stamp is no larger than this part of the drawing.
const SMALL: f64 = 0.08;
/// How well its sides fit, as a part of its size.
const FIT: f64 = 0.03;
/// How near to the end of a line its middle lies, as a part of the drawing.
const NEAR: f64 = 1e-4;

/// A square or a cross.
struct Stamp {
    shape: u32,
    at: Point,
    /// The radius of the circle that stands for it.
    radius: f64,
    is_hollow: bool,
}

/// Turns the stamps at the ends of lines into dots. `coats` says what each shape painted. O(n log n).
pub(super) fn read(drawing: &mut Drawing, coats: &[Range<u32>]) {
    let size = span(&drawing.points().collect::<Vec<Point>>());
    let found = stamps(drawing, SMALL * size);
    let Some(usual) = usual(&found) else { return };
    let shapes: Vec<u32> = found.iter().map(|stamp| stamp.shape).collect();
    let others = drawing.lines.iter().filter(|line| shapes.binary_search(&line.shape).is_err());
    let ends: Vec<Point> = others.flat_map(|line| line.ends).collect();
    let reach = NEAR * size;
    let (ends, dots) =
        (Places::of(&ends, reach), Places::of(&drawing.dots.iter().map(|dot| dot.at).collect::<Vec<_>>(), reach));
    let is_vertex = |stamp: &&Stamp| {
        (stamp.radius - usual).abs() <= FIT * usual
            && ends.near(stamp.at, reach).is_some()
            && dots.near(stamp.at, reach).is_none()
    };
    let vertices: Vec<Stamp> = {
        let keep: Vec<bool> = found.iter().map(|stamp| is_vertex(&stamp)).collect();
        found.into_iter().zip(keep).filter(|(_, keep)| *keep).map(|(stamp, _)| stamp).collect()
    };
    let gone: Vec<u32> = vertices.iter().map(|stamp| stamp.shape).collect();
    let stays = |shape: u32| gone.binary_search(&shape).is_err();
    drawing.lines.retain(|line| stays(line.shape));
    drawing.outlines.retain(|outline| stays(outline.shape));
    for stamp in vertices {
        repaint(drawing, &stamp, coats[stamp.shape as usize].clone());
        drawing.dots.push(Dot {
            at: stamp.at,
            radius: stamp.radius,
            hidden: None,
            vertex: None,
            aside: false,
            legend: 0,
        });
    }
}

/// The size of most stamps.
fn usual(found: &[Stamp]) -> Option<f64> {
    let mut sizes: Vec<f64> = found.iter().map(|stamp| stamp.radius).collect();
    sizes.sort_by(f64::total_cmp);
    sizes.get(sizes.len() / 2).copied()
}

/// All squares and crosses up to a size, by their shapes.
fn stamps(drawing: &Drawing, largest: f64) -> Vec<Stamp> {
    let mut shapes: BTreeMap<u32, (Vec<&Line>, Vec<&[Point]>)> = BTreeMap::new();
    for line in drawing.lines.iter().filter(|line| !line.aside && line.hidden.is_none()) {
        let lines = &mut shapes.entry(line.shape).or_default().0;
        // More lines than a square has make nothing here.
        if lines.len() < 5 {
            lines.push(line);
        }
    }
    for outline in
        drawing.outlines.iter().filter(|outline| !outline.curved && outline.hidden.is_none() && outline.legend == 0)
    {
        shapes.entry(outline.shape).or_default().1.push(&outline.points);
    }
    let stamp = |(shape, (lines, outlines)): (u32, (Vec<&Line>, Vec<&[Point]>))| {
        let (at, radius, is_hollow) = match (&lines[..], &outlines[..]) {
            ([] | [_, _, _, _], [points]) => square(points).map(|(at, radius)| (at, radius, false)),
            ([a, b, c, d], []) => square(&[a, b, c, d].map(|line| line.ends[0])).map(|(at, radius)| (at, radius, true)),
            ([a, b], []) => cross(a.ends, b.ends).map(|(at, radius)| (at, radius, false)),
            _ => None,
        }?;
        (radius <= 0.5 * largest).then_some(Stamp { shape, at, radius, is_hollow })
    };
    shapes.into_iter().filter_map(stamp).collect()
}

fn middle(p: Point, q: Point) -> Point {
    Point::new(0.5 * (p.x + q.x), 0.5 * (p.y + q.y))
}

/// The middle of a square, and half its side.
fn square(points: &[Point]) -> Option<(Point, f64)> {
    let closed = points.len() == 5 && points[0] == points[4];
    let &[a, b, c, d] = points.get(..if closed { 4 } else { points.len() })? else { return None };
    let (side, diagonal) = (distance(a, b), distance(a, c));
    let slack = FIT * side;
    let even = [(b, c), (c, d), (d, a)].iter().all(|(p, q)| (distance(*p, *q) - side).abs() <= slack);
    let right = (distance(b, d) - diagonal).abs() <= slack && distance(middle(a, c), middle(b, d)) <= slack;
    (side > 0.0 && even && right).then_some((middle(a, c), 0.5 * side))
}

/// The middle of a cross, and the radius of its dot.
fn cross([a, b]: [Point; 2], [c, d]: [Point; 2]) -> Option<(Point, f64)> {
    let (long, other) = (distance(a, b), distance(c, d));
    let slack = FIT * long;
    let (x, y) = ([b.x - a.x, d.x - c.x], [b.y - a.y, d.y - c.y]);
    let is_right = (x[0] * x[1] + y[0] * y[1]).abs() <= slack * other;
    let fits = (long - other).abs() <= slack && distance(middle(a, b), middle(c, d)) <= slack;
    (long > 0.0 && is_right && fits).then_some((middle(a, b), 0.35 * long))
}

/// The coats of a stamp become one disc.
fn repaint(drawing: &mut Drawing, stamp: &Stamp, coats: Range<u32>) {
    let one = 1.0 / stamp.radius;
    let from = if stamp.is_hollow { 0.7 } else { 0.0 };
    let disc = Disc { centre: stamp.at, inverse: [one, 0.0, 0.0, one], from, to: 1.0, reach: stamp.radius };
    for (i, coat) in drawing.painting.coats[coats.start as usize..coats.end as usize].iter_mut().enumerate() {
        coat.shape = Shape::Disc(disc);
        coat.part = Part::Dot;
        if i > 0 {
            coat.alpha = 0.0;
        }
    }
}
