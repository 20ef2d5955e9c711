//! Stretches of an edge that something covers.
//!
//! ```text
//!   ●────┃─┃┃──────●      letters and lines that cross an edge leave short gaps, and it is seen on both sides of each
//!   ●────┌────┐────●      a longer gap may be the box of a label, if letters are in it
//!        └────┘
//! ```

use super::super::ink::Hidden;
use super::super::painting::{Mark, Part, Shape};
use super::super::pairing::distance;
use super::{Eye, FAINT, contrast};
use crate::plane::Point;

/// A gap is short up to this part of the drawing: as letters are.
const SHORT: f64 = 0.05;
/// A short gap is measured in so many steps.
const STEPS: f64 = 16.0;
/// Shapes larger than this part of a box are no letters in it.
const INSIDE: f64 = 0.9;

/// An edge on the canvas.
pub(in crate::compare) struct Way {
    from: Point,
    /// Its direction, of length 1.
    pub(super) along: Point,
    pub(super) length: f64,
    /// How far from its ends the circles there reach.
    pub(super) discs: [f64; 2],
    pub(super) tolerance: f64,
}

impl Way {
    /// The way from end to end.
    pub(in crate::compare) fn new([a, b]: [Point; 2], discs: [f64; 2], tolerance: f64) -> Self {
        let length = distance(a, b);
        let along = Point::new((b.x - a.x) / length, (b.y - a.y) / length);
        Self { from: a, along, length, discs, tolerance }
    }

    /// The point so far from the start.
    pub(super) fn at(&self, far: f64) -> Point {
        Point::new(self.from.x + far * self.along.x, self.from.y + far * self.along.y)
    }

    /// Whether a point so far from the start lies between the circles.
    pub(in crate::compare) fn is_open(&self, far: f64) -> bool {
        far >= self.discs[0] && self.length - far >= self.discs[1]
    }
}

/// A gap that has been measured: from where to where, and whether that is all of it.
pub(super) type Gap = (f64, f64, bool);

impl Eye<'_> {
    /// Whether an edge that is not seen so far from its start is seen again a short way before and behind, or a circle
    /// lies there. `last` is the gap that was measured last.
    pub(super) fn is_short_gap(&mut self, way: &Way, far: f64, why: Hidden, last: &mut Option<Gap>) -> bool {
        let covers = matches!(
            why,
            Hidden::Area | Hidden::Ground | Hidden::Letters | Hidden::Faded | Hidden::Marker | Hidden::Line
        );
        if !covers {
            return false;
        }
        if let Some((from, to, is_short)) = *last
            && (from..=to).contains(&far)
        {
            return is_short;
        }
        let most = SHORT * self.span;
        let mut ends = [far; 2];
        for (end, step) in [(1, most / STEPS), (0, -most / STEPS)] {
            loop {
                let next = ends[end] + step;
                if !way.is_open(next) || self.is_tired() || self.glance(way, next).seen {
                    break;
                }
                ends[end] = next;
                if ends[1] - ends[0] > most {
                    *last = Some((ends[0], ends[1], false));
                    return false;
                }
            }
        }
        *last = Some((ends[0], ends[1], true));
        true
    }

    /// Whether letters of another colour are drawn in a box over it: texts, or shapes smaller than the box.
    pub(super) fn holds_letters(&mut self, number: u32) -> bool {
        let painting = self.painting;
        let place = &painting.coats[number as usize];
        let ([low, high], widest) = (place.corners(), INSIDE * place.diameter());
        let inside = self.inside.get_or_insert_with(|| {
            let coats = (0..).zip(&painting.coats).filter(|(_, coat)| match (coat.part, &coat.shape) {
                (Part::Mark(Mark::Letters), _) | (Part::Area | Part::Other, Shape::Area(_)) => coat.alpha > 0.2,
                _ => false,
            });
            let mut places: Vec<(Point, u32)> = coats.map(|(i, coat)| (coat.middle(), i)).collect();
            places.sort_by(|a, b| a.0.x.total_cmp(&b.0.x));
            places
        });
        let first = inside.partition_point(|(at, _)| at.x < low.x);
        let (mut looked, mut found) = (0, false);
        for (at, i) in inside[first..].iter().take_while(|(at, _)| at.x <= high.x) {
            looked += 1;
            let coat = &painting.coats[*i as usize];
            let is_text = coat.part == Part::Mark(Mark::Letters);
            if *i > number
                && (low.y..=high.y).contains(&at.y)
                && (is_text || coat.diameter() <= widest)
                && contrast(coat.colour, place.colour) >= FAINT
            {
                found = true;
                break;
            }
        }
        self.work += looked;
        found
    }
}
