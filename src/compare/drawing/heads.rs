//! Heads of arrows that are drawn by lines and areas, as plotting programs do where others have markers.
//!
//! ```text
//!   ●──────>●      two strokes of one length that meet at the end of a line, one on each side
//!   ●──────▸●      a small filled triangle, notched or not, about the end of a line
//! ```
//!
//! Where the tip is at a vertex, and nothing else ends at the outer corners, the head is taken for a marker, which is no
//! part of the structure, and the line ends where the ink of the tip does.

use super::slack::Slack;
use super::{Drawing, Line};
use crate::compare::ends::Circles;
use crate::compare::painting::{Mark, Part, Shape};
use crate::compare::pairing::{NEXT, Places, distance, key, middle};
use crate::compare::rings::open;
use crate::geometry::point::corners;
use crate::plane::Point;
use std::cell::Cell;
use std::collections::BTreeMap;
use std::ops::Range;

/// A head is no longer than this part of the drawing, and than this part of its line.
const SMALL: f64 = 0.06;
const SHORT: f64 = 0.5;
/// How well its sides fit, as a part of their length.
const FIT: f64 = 0.06;
/// How far aside of a line the middle of its circle may lie, in tolerances, for circles.
const ASIDE: f64 = 0.96;
/// Ends of lines looked at for all heads; what takes more stays as it is.
const WORK: usize = 20_000_000;
/// Half the angle of the tip: its sine is between these.
const ANGLE: [f64; 2] = [0.12, 0.87];

/// A head at an end of a line.
struct Head {
    /// The number of its line, and which end of that.
    shaft: (usize, usize),
    /// Where its line ends as it is drawn, and whether that is at the tip.
    was: Point,
    is_at_tip: bool,
    /// The corner at the tip, and those beside it.
    corner: Point,
    sides: [Point; 2],
    /// How far its ink reaches.
    tip: Point,
    /// The lines that draw it.
    lines: Vec<usize>,
    /// The shape that it is, if that is all of it.
    shape: Option<u32>,
}

/// What may be heads in a drawing.
pub(super) struct Heads {
    all: Vec<Head>,
    /// Which lines belong to them.
    is_head: Vec<bool>,
    tips: BTreeMap<(usize, usize), Point>,
}

impl Heads {
    /// Finds what may be heads, wherever the vertices are. O(n log n).
    pub(super) fn of(drawing: &Drawing, slack: Slack) -> Self {
        let mut out = Self { all: Vec::new(), is_head: vec![false; drawing.lines.len()], tips: BTreeMap::new() };
        if slack.size > 0.0 {
            let around = Around::new(drawing, slack);
            around.areas().into_iter().for_each(|head| out.add(head));
            around.strokes().into_iter().for_each(|head| out.add(head));
        }
        out
    }

    fn add(&mut self, head: Head) {
        let is_new = !head.lines.iter().any(|&line| self.is_head[line]) && !self.is_head[head.shaft.0];
        if is_new && !self.tips.contains_key(&head.shaft) {
            head.lines.iter().for_each(|&line| self.is_head[line] = true);
            self.tips.insert(head.shaft, head.tip);
            self.all.push(head);
        }
    }

    /// Whether a line may be a part of a head.
    pub(super) fn has(&self, line: usize) -> bool {
        self.is_head[line]
    }

    /// The end of a line, or the tip of the head there.
    pub(super) fn end(&self, number: usize, line: &Line, end: usize) -> Point {
        self.tips.get(&(number, end)).copied().unwrap_or(line.ends[end])
    }

    /// Takes off the heads at vertices, and lets their lines end there. Returns which lines are gone. `coats` says what
    /// each shape painted; `stamps` are the shapes of vertices, sorted.
    pub(super) fn take_off(
        self,
        drawing: &mut Drawing,
        coats: &[Range<u32>],
        stamps: &[u32],
        inked: &Inked,
        slack: Slack,
    ) -> Vec<bool> {
        let mut gone = vec![false; drawing.lines.len()];
        if self.all.is_empty() {
            return gone;
        }
        let (reach, aside) = (slack.near(), ASIDE * slack.tolerance);
        let dots: Vec<(Point, f64)> =
            drawing.dots.iter().filter(|dot| dot.hidden.is_none()).map(|dot| (dot.at, dot.radius)).collect();
        let places = Places::thinned(dots.iter().map(|dot| dot.0), reach);
        let mut circles = Circles::new(dots, aside);
        for Head { shaft: (number, end), was, is_at_tip, corner, sides, tip, lines, shape } in self.all {
            if shape.is_some_and(|shape| stamps.binary_search(&shape).is_ok()) {
                continue;
            }
            let line = drawing.lines[number];
            let (own, other) = (line.ends[end], line.ends[1 - end]);
            let far = line.half + reach;
            let near = |p: Point| places.near(p, reach).map(|i| places.points()[i as usize]);
            // A line that ends at the base of its head has to reach its vertex by that, unless it was brought there.
            let is_near = is_at_tip || was != own;
            // Strokes that end at vertices on both sides are edges.
            let is_edge = |p: Point| near(p).is_some() || circles.aimed(p, corner, far, aside).is_some();
            if sides.map(is_edge) != [false; 2] {
                continue;
            }
            let mut aimed = |p: Point| circles.aimed(p, other, far, aside);
            let vertex = near(own).filter(|_| is_near).or_else(|| near(tip)).or_else(|| aimed(tip));
            let Some(at) = vertex.or_else(|| aimed(own).filter(|_| is_near)) else { continue };
            drawing.lines[number].ends[end] = at;
            let painting = &mut drawing.painting;
            if let Some(coat) = inked.coat(number)
                && distance(tip, other) > distance(own, other)
                && let Shape::Stroke(ends, _) = &mut painting.coats[coat as usize].shape
            {
                ends[end] = tip;
            }
            let of_lines = lines.iter().filter_map(|&i| inked.coat(i));
            let all = shape.map_or(0..0, |shape| coats[shape as usize].clone()).chain(of_lines);
            all.for_each(|i| painting.coats[i as usize].part = Part::Mark(Mark::Marker));
            lines.iter().for_each(|&i| gone[i] = true);
        }
        gone
    }
}

/// Lines as they are drawn, whatever is made of them.
pub(super) struct Inked {
    ends: Vec<[Point; 2]>,
    /// The coat of each line.
    coats: BTreeMap<[u64; 4], u32>,
}

impl Inked {
    pub(super) fn of(drawing: &Drawing) -> Self {
        let lines = (0..).zip(&drawing.painting.coats).filter(|(_, coat)| coat.part == Part::Line);
        let coats = lines.filter_map(|(i, coat)| Some((stroke(coat.stroke()?.ends), i))).collect();
        Self { ends: drawing.lines.iter().map(|line| line.ends).collect(), coats }
    }

    pub(super) fn ends(&self, line: usize) -> [Point; 2] {
        self.ends[line]
    }

    pub(super) fn coat(&self, line: usize) -> Option<u32> {
        self.coats.get(&stroke(self.ends[line])).copied()
    }
}

/// A line by the bits of its ends.
fn stroke([a, b]: [Point; 2]) -> [u64; 4] {
    [a.x, a.y, b.x, b.y].map(f64::to_bits)
}

/// What is drawn round a head.
struct Around<'a> {
    drawing: &'a Drawing,
    size: f64,
    /// How near to the end of its line it is.
    near: f64,
    /// Lines by their ends.
    ends: BTreeMap<[u64; 2], Vec<(usize, usize)>>,
    /// The ends of lines that may have heads.
    places: Places,
    lines: Vec<(usize, usize)>,
    dots: Places,
    /// How many ends of lines were looked at.
    looked: Cell<usize>,
}

impl<'a> Around<'a> {
    fn new(drawing: &'a Drawing, slack: Slack) -> Self {
        let (size, near) = (slack.size, slack.near());
        let mut ends: BTreeMap<[u64; 2], Vec<(usize, usize)>> = BTreeMap::new();
        let (mut places, mut lines) = (Places::new(near), Vec::new());
        for (i, line) in drawing.lines.iter().enumerate().filter(|(_, line)| is_plain(line)) {
            for (end, &p) in line.ends.iter().enumerate() {
                ends.entry(key(p)).or_default().push((i, end));
                // One of those that end next to each other is enough.
                if length(line) > SMALL * size && places.near(p, NEXT * near).is_none() {
                    places.add(p);
                    lines.push((i, end));
                }
            }
        }
        let dots = Places::thinned(drawing.dots.iter().map(|dot| dot.at), near);
        Self { drawing, size, near, ends, places, lines, dots, looked: Cell::new(0) }
    }

    /// Areas that may be heads.
    fn areas(&self) -> Vec<Head> {
        let mut lines: BTreeMap<u32, Vec<usize>> = BTreeMap::new();
        let mut counts: BTreeMap<u32, usize> = BTreeMap::new();
        self.drawing.lines.iter().enumerate().for_each(|(i, line)| lines.entry(line.shape).or_default().push(i));
        self.drawing.outlines.iter().for_each(|outline| *counts.entry(outline.shape).or_default() += 1);
        let mut out = Vec::new();
        for outline in &self.drawing.outlines {
            let points = open(&outline.points);
            let is_only = counts.get(&outline.shape) == Some(&1) && !outline.curved && outline.hidden.is_none();
            let own = lines.get(&outline.shape).map_or(&[][..], Vec::as_slice);
            let [low, high] = corners(points.iter().copied());
            if !is_only
                || !matches!(points.len(), 3 | 4)
                || own.len() > 4
                || distance(low, high) > 2.0 * SMALL * self.size
            {
                continue;
            }
            let half = own.iter().map(|&i| self.drawing.lines[i].half).fold(0.0, f64::max);
            let head = (0..points.len()).find_map(|i| self.area(points, i, own, half));
            out.extend(head.map(|head| Head { shape: Some(outline.shape), ..head }));
        }
        out
    }

    /// An area as a head with its tip at a corner.
    fn area(&self, points: &[Point], i: usize, own: &[usize], half: f64) -> Option<Head> {
        let count = points.len();
        let at = |k: usize| points[(i + k) % count];
        let (tip, sides) = (at(0), [at(1), at(count - 1)]);
        let sine = opening(tip, sides)?;
        let base = middle(sides);
        let notch = if count == 4 { at(2) } else { base };
        let (long, off) = (distance(tip, base), |p: Point| aside(p, [base, tip]));
        // A notch lies before the base: a square has none.
        let inside = (notch.x - base.x) * (tip.x - base.x) + (notch.y - base.y) * (tip.y - base.y);
        if off(notch) > FIT * long || inside < -FIT * long * long || !self.is_free(sides, own) {
            return None;
        }
        let shaft = [tip, base, notch].into_iter().find_map(|p| self.shaft(p, tip, base))?;
        Some(self.head(shaft, ([base, tip], sides), half / sine, own.to_vec()))
    }

    /// The head from base to tip of these lines, whose ink reaches farther by so much.
    fn head(
        &self,
        shaft: (usize, usize),
        ([base, tip], sides): ([Point; 2], [Point; 2]),
        more: f64,
        lines: Vec<usize>,
    ) -> Head {
        let was = self.drawing.lines[shaft.0].ends[shaft.1];
        let is_at_tip = distance(was, tip) <= self.near;
        Head { shaft, was, is_at_tip, corner: tip, sides, tip: ahead(base, tip, more), lines, shape: None }
    }

    /// The long line that ends at a place of a head from base to tip, and which end of it that is. None any more once very
    /// many have been looked at.
    fn shaft(&self, place: Point, tip: Point, base: Point) -> Option<(usize, usize)> {
        let short = || self.ends.get(&key(place)).into_iter().flatten().copied();
        let near = || self.places.near(place, self.near).map(|i| self.lines[i as usize]);
        let fits = |&(i, end): &(usize, usize)| {
            self.looked.set(self.looked.get() + 1);
            let line = &self.drawing.lines[i];
            let (own, other) = (line.ends[end], line.ends[1 - end]);
            let (long, head) = (distance(own, other), distance(tip, base));
            let is_long = SHORT * long >= head;
            let is_ahead = (own.x - other.x) * (tip.x - base.x) + (own.y - other.y) * (tip.y - base.y) > 0.0;
            let is_along = aside(base, [other, tip]) <= FIT * head && aside(own, [other, tip]) <= self.near;
            is_long && is_ahead && is_along
        };
        let is_tired = |_: &(usize, usize)| self.looked.get() > WORK;
        short().find(|end| is_tired(end) || fits(end)).or_else(|| near().filter(fits)).filter(|end| !is_tired(end))
    }

    /// Whether nothing but lines of the head itself ends at its outer corners.
    fn is_free(&self, sides: [Point; 2], own: &[usize]) -> bool {
        let is_own = |p: &Point| self.ends.get(&key(*p)).is_none_or(|all| all.iter().all(|(i, _)| own.contains(i)));
        let is_far = |p: &Point| {
            let line = self.places.near(*p, self.near).map(|i| self.lines[i as usize].0);
            line.is_none_or(|line| own.contains(&line)) && self.dots.near(*p, self.near).is_none()
        };
        sides.iter().all(|p| is_own(p) && is_far(p))
    }

    /// Pairs of strokes that may be heads.
    fn strokes(&self) -> Vec<Head> {
        let is_short = |(i, _): &(usize, usize)| length(&self.drawing.lines[*i]) <= SMALL * self.size;
        let pairs = self.ends.values().filter(|all| all.len() > 1).filter_map(|all| {
            let mut short = all.iter().copied().filter(is_short).take(4).collect::<Vec<_>>();
            // Of three, the longest is the line.
            if short.len() == 3 && all.len() == 3 {
                short.sort_by(|a, b| length(&self.drawing.lines[a.0]).total_cmp(&length(&self.drawing.lines[b.0])));
                short.pop();
            }
            <[(usize, usize); 2]>::try_from(short).ok()
        });
        let head = |pair: [(usize, usize); 2]| {
            let [(a, end), (b, _)] = pair;
            let tip = self.drawing.lines[a].ends[end];
            let sides = pair.map(|(i, end)| self.drawing.lines[i].ends[1 - end]);
            let sine = opening(tip, sides)?;
            let own = vec![a, b];
            let base = middle(sides);
            let shaft = self.shaft(tip, tip, base).filter(|(i, _)| !own.contains(i) && self.is_free(sides, &own))?;
            Some(self.head(shaft, ([base, tip], sides), self.drawing.lines[a].half / sine, own))
        };
        pairs.filter_map(head).collect()
    }
}

/// The sine of half the angle at a tip, if both sides are of one length and the angle is that of a head.
fn opening(tip: Point, sides: [Point; 2]) -> Option<f64> {
    let [a, b] = sides.map(|p| distance(p, tip));
    let sine = 0.5 * distance(sides[0], sides[1]) / a.max(b);
    ((a - b).abs() <= FIT * a && (ANGLE[0]..=ANGLE[1]).contains(&sine)).then_some(sine)
}

/// The point so far beyond the second of two.
fn ahead(from: Point, to: Point, by: f64) -> Point {
    let part = by / distance(from, to);
    Point::new(to.x + part * (to.x - from.x), to.y + part * (to.y - from.y))
}

/// How far a point lies from the line through two others.
fn aside(p: Point, [a, b]: [Point; 2]) -> f64 {
    ((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x)).abs() / distance(a, b)
}

fn length(line: &Line) -> f64 {
    distance(line.ends[0], line.ends[1])
}

fn is_plain(line: &Line) -> bool {
    !line.aside && line.hidden.is_none() && line.legend == 0
}
