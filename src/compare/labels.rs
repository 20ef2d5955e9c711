//! Shapes that are letters, or boxes round letters: their strokes are no edges.
//!
//! ```text
//!   ●────────●      a small shape with curves that touches no vertex: the outline of letters, or a round box
//!   │ (f1)   │      a small filled rectangle that touches no vertex, with letters drawn in it next: a box
//!   ●────────●      small areas that touch no vertex, with a rim of the colour of white paper: letters; so are lines of
//!                   that colour along the sides of such areas, before or behind these: a halo that is drawn by itself
//! ```

use super::beside::{Extent, SMALL};
use super::drawing::{Drawing, Line, Outline};
use super::frame::Frame;
use super::painting::{Mark, Part};
use super::pairing::{Places, distance};
use super::snap::Snap;
use crate::plane::Point;
use std::collections::{BTreeMap, BTreeSet};

/// A box of letters is no larger than this part of the drawing.
const BOX: f64 = 0.3;
/// Letters are at least so large, as a part of the box that stands for them.
const LETTERS: f64 = 0.6;
/// Lines are a halo if this part of their ends lies at corners of letters, and so near, as a part of the drawing.
const MOST: f64 = 0.75;
const NEAR: f64 = 1e-3;
/// So many coats behind that of a box are looked at for its letters.
const NEXT: usize = 6;

/// The numbers of these shapes in a drawing that is so large in the coordinates of the frame. `snap` knows the points of
/// the reference and the circles. O(n log n).
pub(super) fn labels(drawing: &Drawing, frame: &Frame, snap: &Snap, size: f64) -> BTreeSet<u32> {
    let mut held: BTreeMap<u32, Vec<Point>> = BTreeMap::new();
    for line in drawing.lines.iter().filter(|line| line.curved) {
        held.entry(line.shape).or_default().extend(line.ends.map(|p| frame.apply(p)));
    }
    let is_apart = |points: &[Point], most: f64| {
        let [low, _, high, _] = Extent::around(points.to_vec()).corners();
        distance(low, high) <= most * size && !points.iter().any(|&p| snap.is_known(p))
    };
    let mut out: BTreeSet<u32> = BTreeSet::new();
    let filled: BTreeSet<u32> = drawing.outlines.iter().filter(|o| o.curved).map(|outline| outline.shape).collect();
    let most = |shape: &u32| if filled.contains(shape) { BOX } else { SMALL };
    out.extend(held.iter().filter(|(shape, points)| is_apart(points, most(shape))).map(|(shape, _)| *shape));
    for outline in drawing.outlines.iter().filter(|outline| !outline.curved && matches!(outline.points.len(), 4 | 5)) {
        let corners: Vec<Point> = outline.points.iter().map(|&p| frame.apply(p)).collect();
        if is_apart(&corners, BOX) && holds_letters(drawing, outline) {
            out.insert(outline.shape);
        }
    }
    out.extend(rimmed(drawing, is_apart, frame));
    out.extend(halos(drawing, is_apart, frame, NEAR * size));
    out
}

/// Shapes of white lines that lie along the sides of small areas of another colour, together no larger than a box.
fn halos(drawing: &Drawing, is_apart: impl Fn(&[Point], f64) -> bool, frame: &Frame, reach: f64) -> Vec<u32> {
    let painting = &drawing.painting;
    let ends = |[a, b]: [Point; 2]| [a.x, a.y, b.x, b.y].map(f64::to_bits);
    let white = (0..).zip(&painting.coats).filter(|&(i, coat)| coat.part == Part::Line && painting.is_blank(i));
    let white: BTreeSet<[u64; 4]> = white.filter_map(|(_, coat)| Some(ends(coat.stroke()?.ends))).collect();
    if white.is_empty() {
        return Vec::new();
    }
    let place = |p: &Point| frame.apply(*p);
    let mut corners = Places::new(reach);
    let areas = drawing.outlines.iter().filter(|o| o.hidden.is_none() && o.legend == 0 && !painting.is_blank(o.coat));
    for points in areas.map(|outline| outline.points.iter().map(place).collect::<Vec<Point>>()) {
        if is_apart(&points, SMALL) {
            for p in points {
                corners.near_or_add(p, reach);
            }
        }
    }
    let is_white = |line: &Line| line.hidden.is_none() && line.legend == 0 && white.contains(&ends(line.ends));
    let shapes = drawing.lines.chunk_by(|a, b| a.shape == b.shape).filter(|lines| lines.iter().all(is_white));
    let is_halo = |lines: &&[Line]| {
        let points: Vec<Point> = lines.iter().flat_map(|line| line.ends).map(|p| frame.apply(p)).collect();
        let along = points.iter().filter(|&&p| corners.near(p, reach).is_some()).count();
        along as f64 >= MOST * points.len() as f64 && is_apart(&points, BOX)
    };
    shapes.filter(is_halo).map(|lines| lines[0].shape).collect()
}

/// Shapes of small areas, together no larger than a box, with a rim of the colour of white paper, which parts them from
/// what lies below.
fn rimmed(drawing: &Drawing, is_apart: impl Fn(&[Point], f64) -> bool, frame: &Frame) -> Vec<u32> {
    let is_open = |outline: &Outline| outline.curved || outline.hidden.is_some() || outline.legend > 0;
    let shapes = drawing.outlines.chunk_by(|a, b| a.shape == b.shape);
    let shapes = shapes.filter(|shape| !shape.iter().any(is_open) && has_plain_rim(drawing, &shape[0]));
    let is_text = |shape: &&[Outline]| {
        let place = |outline: &Outline| outline.points.iter().map(|&p| frame.apply(p)).collect::<Vec<Point>>();
        let letters: Vec<Vec<Point>> = shape.iter().map(place).collect();
        letters.iter().all(|letter| is_apart(letter, SMALL)) && is_apart(&letters.concat(), BOX)
    };
    shapes.filter(is_text).map(|shape| shape[0].shape).collect()
}

/// Whether the stroke of an area, which is painted next, has the colour of white paper.
fn has_plain_rim(drawing: &Drawing, outline: &Outline) -> bool {
    let (coats, next) = (&drawing.painting.coats, outline.coat + 1);
    coats.get(next as usize).is_some_and(|rim| rim.part == Part::Line) && drawing.painting.is_blank(next)
}

/// Whether letters are drawn in an upright rectangle right after it: a text, or areas that it holds.
fn holds_letters(drawing: &Drawing, outline: &Outline) -> bool {
    let around = Extent::around(outline.points.clone());
    let slack = 1e-6 * around.size();
    let is_upright = outline.points.iter().all(|&p| around.corners().iter().any(|&q| distance(p, q) <= slack));
    let coats = drawing.painting.coats.iter().skip(outline.coat as usize + 1).take(NEXT);
    let mut inside = coats.filter(|coat| matches!(coat.part, Part::Area | Part::Mark(Mark::Letters)));
    is_upright
        && inside.next().is_some_and(|coat| {
            let (middle, part) = (coat.middle(), if coat.part == Part::Area { 1.0 } else { LETTERS });
            let near = |p: Point| Point::new(middle.x + part * (p.x - middle.x), middle.y + part * (p.y - middle.y));
            coat.corners().iter().all(|&p| around.holds(near(p), 0.0))
        })
}
