//! Vertices drawn as small squares, other small figures or crosses, as plotting programs do.
//!
//! ```text
//!   ■──────□      a square, filled or hollow, whose middle is the end of a line
//!   │      ▲      a triangle, a star, a polygon about such an end, at whose corners nothing else ends
//!   ✕──────+      two short lines of one length that cross in their middles, there
//! ```
//!
//! A line may also end at the rim of a square or a box, as rims.rs finds out.
//!
//! Each becomes a dot where it stands, as large as a circle in it, or of its area if it is no square. Only stamps of the
//! size of most others at ends of lines count, those elsewhere that look like them, and none where a circle is drawn.

use super::arrows;
use super::heads::{Heads, Inked};
use super::rims::{self, Frame};
use super::slack::Slack;
use super::{Dot, Drawing, Line};
use crate::compare::eye::{FAINT, contrast};
use crate::compare::painting::{Area, Coat, Disc, Part, Shape};
use crate::compare::pairing::{Places, distance, distance_to, middle, ring_sides, span};
use crate::compare::rings::{self, open};
use crate::geometry::point;
use crate::plane::Point;
use std::collections::BTreeMap;
use std::ops::Range;

/// A stamp is no larger than this part of the drawing.
const SMALL: f64 = 0.08;
/// How well its sides fit, as a part of its size.
const FIT: f64 = 0.03;

/// Corners of a figure that is no square: at least, and at most.
const CORNERS: [usize; 2] = [3, 12];
/// The nearest point of a figure is at least so far from its middle, as a part of the farthest.
const STOUT: f64 = 0.3;
/// The corners of a figure are no farther from its middle than this part of the largest size.
const WIDE: f64 = 0.75;

/// A square of the colour of circles that are vertices is one if it is about as large: of at least and at most so many
/// radii.
const ABOUT: [f64; 2] = [0.6, 1.5];

/// A box at whose rim lines end is no more than so many times as long as wide, and its corners are no farther from its
/// middle than this part of the drawing.
const SLENDER: f64 = 3.0;
const BOX: f64 = 0.08;

/// A square, another figure or a cross.
struct Stamp {
    shape: u32,
    /// Its sides, if lines may end at them.
    frame: Option<Frame>,
    is_square: bool,
    /// Where it stands, or may stand.
    middles: [Point; 2],
    /// The radius of the circle that stands for it about each.
    radii: [f64; 2],
    is_hollow: bool,
    /// Its corners, if something else may end there.
    corners: Vec<Point>,
}

impl Stamp {
    /// A stamp that can stand in one place only.
    fn one(shape: u32, (at, radius): (Point, f64), is_hollow: bool, is_square: bool) -> Self {
        Self { shape, frame: None, is_square, middles: [at; 2], radii: [radius; 2], is_hollow, corners: Vec::new() }
    }

    /// Whether it is no larger than this.
    fn is_small(&self, largest: f64) -> bool {
        self.radii.iter().all(|radius| *radius <= 0.5 * largest)
    }
}

/// A stamp at a vertex.
struct Placed {
    shape: u32,
    /// At which of its middles it stands.
    which: usize,
    at: Point,
    radius: f64,
    is_hollow: bool,
}

/// Turns the stamps at the ends of lines into dots, and takes off heads of arrows. `coats` says what each shape painted,
/// `tolerance` how far points may be from their places, as a part of the drawing. Returns how many curves
/// were read as lines. O(n log n).
pub(super) fn read(drawing: &mut Drawing, coats: &[Range<u32>], tolerance: f64) -> usize {
    let slack = |drawing: &Drawing| Slack::new(span(&drawing.points().collect::<Vec<Point>>()), tolerance);
    let curved = arrows::read(drawing, coats, tolerance);
    let before = slack(drawing);
    let (heads, inked) = (Heads::of(drawing, before), Inked::of(drawing));
    let stamps = dots(drawing, coats, &heads, &inked, before);
    let after = slack(drawing);
    let mut gone = heads.take_off(drawing, coats, &stamps, &inked, after).into_iter();
    let stays = |shape: u32| stamps.binary_search(&shape).is_err();
    drawing.lines.retain(|line| gone.next() != Some(true) && stays(line.shape));
    drawing.outlines.retain(|outline| stays(outline.shape));
    curved
}

/// Turns the stamps at the ends of lines into dots, and returns their shapes, sorted.
fn dots(drawing: &mut Drawing, coats: &[Range<u32>], heads: &Heads, inked: &Inked, slack: Slack) -> Vec<u32> {
    let size = slack.size;
    let found = stamps(drawing, size);
    if found.is_empty() {
        return Vec::new();
    }
    let reach = slack.at();
    let dots = Places::thinned(drawing.dots.iter().map(|dot| dot.at), reach);
    let boxes: BTreeMap<u32, Frame> = found.iter().filter_map(|stamp| Some((stamp.shape, stamp.frame?))).collect();
    let aimed = rims::aimed(drawing, &boxes, heads, slack, |p| dots.near(p, reach).is_some());
    // A line that ends at a corner may be an edge of a face there.
    let is_held = |frame: &Frame, (line, end): (usize, usize)| {
        frame.corners().iter().all(|&corner| distance(corner, drawing.lines[line].ends[end]) > reach)
    };
    let is_box = |stamp: &Stamp| {
        let Some((frame, ends)) = stamp.frame.zip(aimed.ends.get(&stamp.shape)) else { return false };
        let is_clear = frame.corners().iter().chain([&frame.middle]).all(|&p| dots.near(p, reach).is_none());
        aimed.are_most && is_clear && ends.iter().any(|&end| is_held(&frame, end))
    };
    // A box too large for a stamp, at which no line ends, is a face: its corners are ends.
    let may_stand = |stamp: &Stamp| stamp.is_small(SMALL * size) || is_box(stamp);
    let ends = |is_stamp: &dyn Fn(&Stamp) -> bool| {
        let shapes = found.iter().filter(|stamp| may_stand(stamp) && is_stamp(stamp)).map(|stamp| stamp.shape);
        let shapes: Vec<u32> = shapes.collect();
        let is_other = |(i, line): &(usize, &Line)| shapes.binary_search(&line.shape).is_err() && !heads.has(*i);
        let others = drawing.lines.iter().enumerate().filter(is_other);
        Places::thinned(others.flat_map(|(_, line)| line.ends), reach)
    };
    // Small faces may look like figures, and their corners are ends as well.
    let (ends, firm) = (ends(&|stamp| stamp.corners.is_empty()), ends(&|_| true));
    let place = |stamp: &Stamp| {
        let Stamp { shape, is_hollow, .. } = *stamp;
        let is_vertex = |p: Point| ends.near(p, reach).is_some() && dots.near(p, reach).is_none();
        let is_free = stamp.corners.iter().all(|&p| firm.near(p, reach).is_none() && dots.near(p, reach).is_none());
        let is_small = stamp.is_small(SMALL * size);
        let at_end = (0..2).find(|&i| is_small && is_free && is_vertex(stamp.middles[i]));
        if let (None, Some(frame)) = (at_end, stamp.frame.filter(|_| is_box(stamp))) {
            return Some(Placed { shape, which: 0, at: frame.middle, radius: frame.radius(), is_hollow });
        }
        at_end.map(|i| Placed { shape, which: i, at: stamp.middles[i], radius: stamp.radii[i], is_hollow })
    };
    let mut vertices: Vec<Placed> = found.iter().filter_map(place).collect();
    let radii = |vertices: &[Placed]| vertices.iter().map(|stamp| stamp.radius).collect();
    let at_ends = usual(radii(&vertices));
    vertices.retain(|stamp| at_ends.is_some_and(|usual| (stamp.radius - usual).abs() <= FIT * usual));
    let is_free = |p| firm.near(p, reach).or(dots.near(p, reach)).is_none();
    let small: Vec<&Stamp> = found.iter().filter(|stamp| stamp.is_small(SMALL * size)).collect();
    vertices.extend(strays(drawing, &small, &vertices, coats, is_free));
    vertices.sort_by_key(|stamp| stamp.shape);
    let gone: Vec<u32> = vertices.iter().map(|stamp| stamp.shape).collect();
    let of_box = |shape: &u32| {
        let frame = boxes.get(shape)?;
        Some(aimed.ends.get(shape)?.iter().map(|&end| (end, *frame)))
    };
    rims::join(drawing, &gone.iter().filter_map(of_box).flatten().collect::<Vec<_>>(), inked, coats);
    for stamp in vertices {
        repaint(drawing, &stamp, coats[stamp.shape as usize].clone());
        let Placed { at, radius, .. } = stamp;
        drawing.dots.push(Dot { at, radius, hidden: None, vertex: None, aside: false, legend: 0 });
    }
    gone
}

/// The size of most.
fn usual(mut sizes: Vec<f64>) -> Option<f64> {
    sizes.sort_by(f64::total_cmp);
    sizes.get(sizes.len() / 2).copied()
}

/// Stamps elsewhere that look like vertices: like one of those at ends of lines, or as squares of the colour of the
/// circles, and about as large. What is white paints no vertex on paper. `is_free` says where nothing ends or stands.
fn strays(
    drawing: &Drawing,
    found: &[&Stamp],
    vertices: &[Placed],
    coats: &[Range<u32>],
    is_free: impl Fn(Point) -> bool,
) -> Vec<Placed> {
    let painting = &drawing.painting;
    let coat = |shape: u32| {
        let range = coats[shape as usize].clone();
        painting.coats[range.start as usize..range.end as usize].first().filter(|coat| coat.alpha > 0.5)
    };
    let alike = |a: &Coat, b: &Coat| contrast(a.colour, b.colour) < FAINT;
    let first = vertices.first();
    // One that looks like another stands as that does.
    let which = first.map_or(0, |other| other.which);
    let circles: Vec<f64> = drawing.dots.iter().filter(|dot| !dot.aside).map(|dot| dot.radius).collect();
    let circle = painting.coats.iter().find(|coat| coat.part == Part::Dot && coat.alpha > 0.5);
    let circle = circle.zip(usual(circles)).filter(|_| first.is_none());
    let is_vertex = |stamp: &&&Stamp| {
        let Some(own) = coat(stamp.shape) else { return false };
        let radius = stamp.radii[which];
        let is_like = first.is_some_and(|other| {
            stamp.is_hollow == other.is_hollow
                && (radius - other.radius).abs() <= FIT * other.radius
                && coat(other.shape).is_some_and(|other| alike(own, other))
        });
        let is_about = circle.is_some_and(|(other, usual)| {
            let about = ABOUT[0] * usual..=ABOUT[1] * usual;
            stamp.is_square && !stamp.is_hollow && about.contains(&radius) && alike(own, other)
        });
        let is_alone = stamp.corners.iter().chain(&stamp.middles[which..=which]).all(|&p| is_free(p));
        let is_blank = painting.is_blank(coats[stamp.shape as usize].start);
        (is_like || is_about) && is_alone && !is_blank
    };
    let is_new = |stamp: &&&Stamp| vertices.binary_search_by_key(&stamp.shape, |known| known.shape).is_err();
    let place = |stamp: &&Stamp| {
        let Stamp { shape, is_hollow, .. } = **stamp;
        Placed { shape, which, at: stamp.middles[which], radius: stamp.radii[which], is_hollow }
    };
    found.iter().filter(is_vertex).filter(is_new).map(place).collect()
}

/// All squares, boxes, figures and crosses that are small in a drawing of this size, by their shapes.
fn stamps(drawing: &Drawing, size: f64) -> Vec<Stamp> {
    let largest = SMALL * size;
    let mut shapes: BTreeMap<u32, (Vec<&Line>, Vec<&[Point]>)> = BTreeMap::new();
    for line in drawing.lines.iter().filter(|line| !line.aside && line.hidden.is_none()) {
        let lines = &mut shapes.entry(line.shape).or_default().0;
        // With more lines there is no figure here.
        if lines.len() <= CORNERS[1] {
            lines.push(line);
        }
    }
    for outline in
        drawing.outlines.iter().filter(|outline| !outline.curved && outline.hidden.is_none() && outline.legend == 0)
    {
        shapes.entry(outline.shape).or_default().1.push(&outline.points);
    }
    let stamp = |(shape, (lines, outlines)): (u32, (Vec<&Line>, Vec<&[Point]>))| {
        if let [a, b] = &lines[..] {
            let cross = cross(a.ends, b.ends).filter(|_| outlines.is_empty())?;
            return Some(Stamp::one(shape, cross, false, false));
        }
        let is_closed = lines.iter().zip(lines.iter().cycle().skip(1)).all(|(a, b)| a.ends[1] == b.ends[0]);
        let corners: Vec<Point> = match &outlines[..] {
            [points] if lines.is_empty() || lines.len() == open(points).len() => open(points).to_vec(),
            [] if is_closed => lines.iter().map(|line| line.ends[0]).collect(),
            _ => return None,
        };
        let is_hollow = outlines.is_empty();
        let frame = Frame::of(&corners, SLENDER, FIT).filter(|frame| frame.reach() <= BOX * size);
        let frame = frame.map(|frame| Frame { rim: lines.iter().map(|line| line.half).fold(0.0, f64::max), ..frame });
        let square = square(&corners).map(|square| Stamp::one(shape, square, is_hollow, true));
        let stamp = square.or_else(|| figure(shape, corners, is_hollow, WIDE * largest));
        let stamp = stamp.or_else(|| frame.map(|f| Stamp::one(shape, (f.middle, f64::INFINITY), is_hollow, false)));
        stamp.map(|stamp| Stamp { frame, ..stamp })
    };
    let may_be = |stamp: &Stamp| stamp.frame.is_some() || stamp.is_small(largest);
    shapes.into_iter().filter_map(stamp).filter(may_be).collect()
}

/// A figure of few corners about the middle of these, or about the middle of their box, if that lies well inside; which
/// of both it is shows the end of a line there. No corner is farther away than this.
fn figure(shape: u32, corners: Vec<Point>, is_hollow: bool, farthest: f64) -> Option<Stamp> {
    let count = corners.len();
    if !(CORNERS[0]..=CORNERS[1]).contains(&count) {
        return None;
    }
    let part = 1.0 / count as f64;
    let mean = corners.iter().fold(Point::new(0.0, 0.0), |at, p| Point::new(at.x + part * p.x, at.y + part * p.y));
    let [low, high] = point::corners(corners.iter().copied());
    let area = Area::new(std::slice::from_ref(&corners), true);
    let inner = |p: Point| {
        let near = ring_sides(&corners).map(|side| distance_to(p, side)).fold(f64::INFINITY, f64::min);
        let far = corners.iter().map(|&q| distance(p, q)).fold(0.0, f64::max);
        (near >= STOUT * far && far > 0.0 && far <= farthest && area.covers(p).0).then_some(p)
    };
    // Of the circle that covers as much.
    let radius = (0.5 * rings::area(corners.iter().copied()).abs() / std::f64::consts::PI).sqrt();
    // A triangle of a plotting program stands about the middle of its box.
    let mut found = [mean, middle([low, high])].into_iter().filter_map(inner);
    let first = found.next()?;
    let middles = [first, found.next().unwrap_or(first)];
    Some(Stamp { shape, frame: None, is_square: false, middles, radii: [radius; 2], is_hollow, corners })
}

/// The middle of a square, and half its side.
fn square(points: &[Point]) -> Option<(Point, f64)> {
    let &[a, b, c, d] = points else { return None };
    let (side, diagonal) = (distance(a, b), distance(a, c));
    let slack = FIT * side;
    let even = [(b, c), (c, d), (d, a)].iter().all(|(p, q)| (distance(*p, *q) - side).abs() <= slack);
    let right = (distance(b, d) - diagonal).abs() <= slack && distance(middle([a, c]), middle([b, d])) <= slack;
    (side > 0.0 && even && right).then_some((middle([a, c]), 0.5 * side))
}

/// The middle of a cross, and the radius of its dot.
fn cross([a, b]: [Point; 2], [c, d]: [Point; 2]) -> Option<(Point, f64)> {
    let (long, other) = (distance(a, b), distance(c, d));
    let slack = FIT * long;
    let (x, y) = ([b.x - a.x, d.x - c.x], [b.y - a.y, d.y - c.y]);
    let is_right = (x[0] * x[1] + y[0] * y[1]).abs() <= slack * other;
    let fits = (long - other).abs() <= slack && distance(middle([a, b]), middle([c, d])) <= slack;
    (long > 0.0 && is_right && fits).then_some((middle([a, b]), 0.35 * long))
}

/// The coats of a stamp become a disc, and a rim if it has one of its own.
fn repaint(drawing: &mut Drawing, stamp: &Placed, coats: Range<u32>) {
    let one = 1.0 / stamp.radius;
    let coats = &mut drawing.painting.coats[coats.start as usize..coats.end as usize];
    let is_area = |coat: &Coat| matches!(coat.shape, Shape::Area(_));
    let rim = coats.iter().position(|coat| !is_area(coat)).filter(|&i| i > 0 && !stamp.is_hollow);
    for (i, coat) in coats.iter_mut().enumerate() {
        let from = if stamp.is_hollow || rim == Some(i) { 0.7 } else { 0.0 };
        let disc = Disc { centre: stamp.at, inverse: [one, 0.0, 0.0, one], from, to: 1.0, reach: stamp.radius };
        coat.shape = Shape::Disc(disc);
        coat.part = Part::Dot;
        if i > 0 && rim != Some(i) {
            coat.alpha = 0.0;
        }
    }
}
