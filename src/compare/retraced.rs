//! Lines and circles of a drawing that are no edges and no vertices, because decoration lies there: half-edges, leader
//! lines with their roots, and rules.
//!
//! ```text
//!   <g id="a-h3" ...><line .../></g>  <line .../>       a half-edge that is drawn once more outside of its group
//!   reference: h3 ──────▸    student: ──────▸           its line, from a program that keeps no groups and no data-*
//! ```
//!
//! The reference's decoration is looked for where its circles lie in the student's drawing. A line from circle to circle
//! stays an edge.

use super::beside::Extent;
use super::drawing::{Dot, Drawing};
use super::painting::{Coat, Part};
use super::pairing::{Places, distance, middle};
use crate::plane::Point;
use std::borrow::Cow;

/// Ends lie at each other within so many widths of their lines.
const NEAR: f64 = 1.0;
/// So many of the reference's circles have to be found, and how near, as a part of the drawing.
const FOUND: f64 = 0.9;
const PLACE: f64 = 2e-3;

/// The student's drawing without lines that lie where a line of decoration is drawn, of its own, or of the reference's, and
/// without circles that lie where the reference's decoration has some. O(n log n).
pub(super) fn without_decoration<'a>(reference: &Drawing, student: &'a Drawing) -> Cow<'a, Drawing> {
    let mut lines = decoration(student, &|p| p, 1.0);
    let mut roots: Vec<Point> = Vec::new();
    if student.halves.is_empty()
        && let Some((scale, shift)) = placed(reference, student)
    {
        let place = move |p: Point| Point::new(scale * p.x + shift[0], scale * p.y + shift[1]);
        lines.extend(decoration(reference, &place, scale));
        roots.extend(circles(reference).map(place));
    }
    let reach = lines.iter().map(|(_, width)| NEAR * width).fold(0.0, f64::max);
    let middles = Places::of(&lines.iter().map(|(ends, _)| middle(*ends)).collect::<Vec<_>>(), reach);
    let dots: Vec<Point> = student.dots.iter().map(|dot| dot.at).collect();
    let near = PLACE * Extent::around(dots.clone()).size();
    let dots = Places::of(&dots, near);
    let is_decoration = |ends: [Point; 2]| {
        if ends.iter().all(|&p| dots.near(p, near).is_some()) {
            return false;
        }
        let Some(i) = middles.near(middle(ends), reach) else { return false };
        let ([a, b], width) = lines[i as usize];
        let slack = NEAR * width;
        let fits = |p: Point, q: Point| distance(a, p) <= slack && distance(b, q) <= slack;
        fits(ends[0], ends[1]) || fits(ends[1], ends[0])
    };
    let roots = Places::of(&roots, near);
    let is_root = |dot: &Dot| roots.near(dot.at, near).is_some();
    if !student.lines.iter().any(|line| is_decoration(line.ends)) && !student.dots.iter().any(is_root) {
        return Cow::Borrowed(student);
    }
    let mut out = student.clone();
    out.lines.retain(|line| !is_decoration(line.ends));
    out.dots.retain(|dot| !is_root(dot));
    Cow::Owned(out)
}

/// The straight lines of decoration, where they are placed, and their widths.
fn decoration(drawing: &Drawing, place: &dyn Fn(Point) -> Point, scale: f64) -> Vec<([Point; 2], f64)> {
    let others = drawing.painting.coats.iter().filter(|coat| coat.part == Part::Other);
    others.filter_map(Coat::stroke).map(|line| (line.ends.map(place), 2.0 * scale * line.half)).collect()
}

/// The middles of the circles of decoration.
fn circles(drawing: &Drawing) -> impl Iterator<Item = Point> + '_ {
    let others = drawing.painting.coats.iter().filter(|coat| coat.part == Part::Other);
    others.filter_map(Coat::disc).map(|disc| disc.centre)
}

/// The scale and the shift from the reference's canvas to the student's, by the boxes round their circles.
fn placed(reference: &Drawing, student: &Drawing) -> Option<(f64, [f64; 2])> {
    let dots =
        |drawing: &Drawing| -> Vec<Point> { drawing.dots.iter().filter(|dot| !dot.aside).map(|dot| dot.at).collect() };
    let (expected, found) = (dots(reference), dots(student));
    if expected.len() < 2 || found.len() < 2 {
        return None;
    }
    let [mine, theirs] = [&expected, &found].map(|points| Extent::around(points.clone()));
    let scale = theirs.size() / mine.size();
    let [from, to] = [mine, theirs].map(|extent| extent.corners()[0]);
    let shift = [to.x - scale * from.x, to.y - scale * from.y];
    let reach = PLACE * theirs.size();
    let places = Places::of(&found, reach);
    let is_there =
        |p: &&Point| places.near(Point::new(scale * p.x + shift[0], scale * p.y + shift[1]), reach).is_some();
    let count = expected.iter().filter(is_there).count();
    (scale.is_finite() && count as f64 >= FOUND * expected.len() as f64).then_some((scale, shift))
}
