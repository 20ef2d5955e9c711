//! How half-edges are drawn: shafts beside their edges, and heads.
//!
//! ```text
//!   ──────────▸   ──────────>   ─────────◂──   a line with a filled head, or with one of a marker, also in its middle;
//!   ──────────⇀   ▬▬▬▬▬▬▬▬▬▶                   with two strokes or one; all of it as one filled outline
//! ```
//!
//! Straight strokes that continue each other are one shaft. Strokes that are no shaft and meet are a head, be they straight
//! or bent.

use super::along::{Along, Stroke};
use super::drawing::{Drawing, Half};
use super::eye::Eye;
use super::painting::{Area, Coat, Mark, Part, Shape};
use super::pairing::{distance, sides};
use crate::plane::Point;
use std::ops::Range;

/// A shaft is at least so many times as long as wide, if it is drawn as an area.
const SLENDER: f64 = 1.6;
/// The tail of such an outline: this part of its length. A half with a head is so many times as wide as the other one.
const END: f64 = 0.25;
const WIDER: f64 = 1.3;
/// So many shafts, strokes beside them and heads of a half-edge are looked at, each.
const MOST: usize = 300;
/// Strokes of one shaft turn by less than this, as a part of their lengths.
const TURN: f64 = 0.01;

/// A line beside an edge, and the coats that draw it.
pub(super) struct Shaft {
    pub(super) line: Stroke,
    coats: Vec<u32>,
}

/// What may be the head of an arrow.
pub(super) struct Head {
    pub(super) corners: Vec<Point>,
    coats: Vec<u32>,
    /// Whether it is drawn by a marker, which may stand in the middle of a line.
    is_marker: bool,
}

/// All that is drawn of a half-edge.
#[derive(Default)]
pub(super) struct Arrow {
    /// Whether it has straight lines, and whether it has more of curves.
    pub(super) is_drawn: bool,
    pub(super) bends: bool,
    /// The shafts that run beside its edge.
    pub(super) shafts: Vec<Shaft>,
    pub(super) heads: Vec<Head>,
}

impl Arrow {
    /// Reads what a half-edge paints.
    pub(super) fn read(drawing: &Drawing, half: &Half, along: Option<&Along>) -> Self {
        let coats = &drawing.painting.coats;
        let is_bent = |i: &u32| drawing.bends.binary_search(i).is_ok();
        let strokes = joined(coats, half.coats.clone().filter(|i| !is_bent(i)));
        let curves = joined(coats, half.coats.clone().filter(is_bent));
        let length = |strokes: &[Shaft]| strokes.iter().map(|s| distance(s.line.ends[0], s.line.ends[1])).sum::<f64>();
        let bends = length(&curves) > length(&strokes);
        let mut out = Self { is_drawn: !strokes.is_empty(), bends, ..Self::default() };
        let Some(along) = along else { return out };
        let mut others = Vec::new();
        for shaft in strokes {
            if along.has_beside(shaft.line.ends) { out.add(shaft) } else { others.push(shaft) }
        }
        let has_lines = !out.shafts.is_empty();
        for i in half.coats.clone() {
            let coat = &coats[i as usize];
            let Shape::Area(area) = &coat.shape else { continue };
            if coat.part == Part::Mark(Mark::Letters) {
                continue;
            }
            if let Some((line, corners)) = outline(along, area).filter(|_| !has_lines) {
                out.is_drawn = true;
                out.shafts.push(Shaft { line, coats: vec![i] });
                out.heads.extend(corners.map(|corners| Head { corners, coats: vec![i], is_marker: false }));
            } else {
                let is_marker = coat.part == Part::Mark(Mark::Marker);
                out.heads.push(Head { corners: area.points().collect(), coats: vec![i], is_marker });
            }
        }
        others.extend(curves);
        others.truncate(MOST);
        out.heads.extend(meeting(coats, others));
        out.heads.truncate(MOST);
        out
    }

    /// Takes in a shaft; one that is drawn once more counts together with the first.
    fn add(&mut self, shaft: Shaft) {
        match self.shafts.iter().position(|known| known.line.ends == shaft.line.ends) {
            Some(i) => {
                let Shaft { line, coats } = &mut self.shafts[i];
                line.half = line.half.max(shaft.line.half);
                coats.extend(shaft.coats.into_iter().take(MOST.saturating_sub(coats.len())));
            }
            None if self.shafts.len() < MOST => self.shafts.push(shaft),
            None => {}
        }
    }

    /// Whether half of a shaft is seen, its heads with it.
    pub(super) fn is_seen(&self, eye: &mut Eye<'_>, strays: &[Range<u32>]) -> bool {
        let mut heads: Vec<u32> = self.heads.iter().flat_map(|head| head.coats.iter().copied()).collect();
        heads.sort_unstable();
        self.shafts.iter().any(|shaft| eye.shows_along(&shaft.coats, &heads, shaft.line, strays))
    }

    /// Whether a head is seen, on what lies below its own shafts.
    pub(super) fn has_seen(&self, head: &Head, eye: &mut Eye<'_>) -> bool {
        let coats = &eye.painting.coats;
        let shafts: Vec<u32> = self.shafts.iter().flat_map(|shaft| shaft.coats.iter().copied()).collect();
        head.coats.iter().any(|&i| match &coats[i as usize].shape {
            Shape::Stroke([a, b], _) => eye.shows(i, &[0.3, 0.6, 0.9].map(|t| between(*a, *b, t)), &shafts),
            _ => eye.shows(i, &inner_corners(&head.corners), &shafts),
        })
    }

    /// Whether a head points along one of the shafts: at its end, or in its middle.
    pub(super) fn points_ahead(&self, head: &Head, along: &Along) -> bool {
        let mut lines = self.shafts.iter().map(|shaft| shaft.line);
        lines.any(|line| {
            along.has_barb(line, &head.corners) || head.is_marker && along.has_middle_barb(line, &head.corners)
        })
    }

    /// Whether a head points to the start of one of the shafts.
    pub(super) fn points_back(&self, head: &Head, along: &Along) -> bool {
        self.shafts.iter().any(|shaft| along.has_barb_back(shaft.line, &head.corners))
    }

    /// Whether a head lies on the wrong side of one of the shafts.
    pub(super) fn is_turned(&self, head: &Head, along: &Along) -> bool {
        self.shafts.iter().any(|shaft| along.has_turned_barb(shaft.line, &head.corners))
    }
}

/// The strokes among some coats; those that continue each other straight on are one.
fn joined(all: &[Coat], coats: impl Iterator<Item = u32>) -> Vec<Shaft> {
    let mut out: Vec<Shaft> = Vec::new();
    for i in coats {
        let Shape::Stroke([a, b], half) = all[i as usize].shape else { continue };
        if let Some(last) = out.last_mut() {
            let [p, q] = last.line.ends;
            let (x, y, u, v) = (q.x - p.x, q.y - p.y, b.x - a.x, b.y - a.y);
            let lengths = distance(p, q) * distance(a, b);
            if q == a && (x * v - y * u).abs() <= TURN * lengths && x * u + y * v > 0.0 {
                last.line.ends[1] = b;
                last.coats.push(i);
                continue;
            }
        }
        out.push(Shaft { line: Stroke { ends: [a, b], half }, coats: vec![i] });
    }
    out
}

/// Strokes that meet, together: each may be a head.
fn meeting(all: &[Coat], strokes: Vec<Shaft>) -> Vec<Head> {
    let mut groups: Vec<(Vec<Shaft>, bool)> = Vec::new();
    for stroke in strokes {
        let is_marker = stroke.coats.iter().all(|&i| all[i as usize].part == Part::Mark(Mark::Marker));
        let meets = |other: &Shaft| {
            let slack = stroke.line.half + other.line.half;
            stroke.line.ends.iter().any(|&p| other.line.ends.iter().any(|&q| distance(p, q) <= slack))
        };
        let (mut near, far): (Vec<_>, Vec<_>) =
            groups.into_iter().partition(|(group, marked)| *marked == is_marker && group.iter().any(meets));
        let mut group: Vec<Shaft> = near.drain(..).flat_map(|(group, _)| group).collect();
        group.push(stroke);
        groups = far;
        groups.push((group, is_marker));
    }
    let head = |(group, is_marker): (Vec<Shaft>, bool)| Head {
        corners: group.iter().flat_map(|stroke| stroke.line.ends).collect(),
        coats: group.into_iter().flat_map(|stroke| stroke.coats).collect(),
        is_marker,
    };
    groups.into_iter().map(head).collect()
}

/// The shaft of an arrow that is drawn as one area, and the corners of its head, if it has one.
fn outline(along: &Along, area: &Area) -> Option<(Stroke, Option<Vec<Point>>)> {
    let corners: Vec<Point> = area.points().collect();
    let places: Vec<[f64; 2]> = corners.iter().map(|&p| along.place(p)).collect();
    let [long, wide] = sides(&places);
    let (low, high) = places.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), p| (l.min(p[0]), h.max(p[0])));
    if long < SLENDER * wide {
        return None;
    }
    let part = |is_in: &dyn Fn(f64) -> bool| {
        let inside = |(_, place): &(&Point, &[f64; 2])| is_in((place[0] - low) / long);
        let (points, places): (Vec<Point>, Vec<[f64; 2]>) = corners.iter().zip(&places).filter(inside).unzip();
        let width = sides(&places)[1];
        (points, places, width)
    };
    let (_, tail, _) = part(&|t| t <= END);
    let (front, _, broad) = part(&|t| t >= 0.5);
    let (back, _, narrow) = part(&|t| t <= 0.5);
    let across = tail.iter().map(|place| place[1]).sum::<f64>() / tail.len() as f64;
    let ends = [low, high].map(|t| along.point([t, across]));
    let head = if broad > WIDER * narrow { Some(front) } else { Some(back).filter(|_| narrow > WIDER * broad) };
    let line = Stroke { ends, half: 0.5 * narrow.min(broad) * along.length };
    along.has_beside(ends).then_some((line, head))
}

fn between(a: Point, b: Point, t: f64) -> Point {
    Point::new(a.x + t * (b.x - a.x), a.y + t * (b.y - a.y))
}

/// Points near the corners of an area, inside of it.
fn inner_corners(corners: &[Point]) -> Vec<Point> {
    let part = 1.0 / corners.len().max(1) as f64;
    let middle = corners.iter().fold(Point::new(0.0, 0.0), |at, p| Point::new(at.x + part * p.x, at.y + part * p.y));
    corners.iter().map(|&p| between(p, middle, 0.3)).collect()
}
