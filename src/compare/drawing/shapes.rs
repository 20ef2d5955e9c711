//! Elements with a shape, as lines, dots, outlines and coats.
//!
//! ```text
//!   M4 0C4 2.2 2.2 4 0 4 ... z      a round path is a dot, whoever drew it
//!   ▭▭▭▭▭▭▭                         a thin filled rectangle may be a line: sketch.rs decides that by its ends
//! ```

use super::axes::Axes;
use super::ovals::{Oval, PIECES, ROUND, STEP};
use super::{Around, Dot, FAR, LINES, Line, Outline, Reader, corners, flipped, length, place, set_length, word};
use crate::compare::colour::Paint;
use crate::compare::error::{Fault, Problem};
use crate::compare::geometry::path_data;
use crate::compare::ink::Hidden;
use crate::compare::painting::{Area, Disc, Part, Shape};
use crate::compare::pairing::distance;
use crate::compare::path::{self, Subpath};
use crate::compare::rings::parts;
use crate::compare::transform::Transform;
use crate::compare::{declared, numbers};
use crate::plane::Point;
use roxmltree::Node;

/// Of a line of fewer px than this, a screen shows less than a tenth of the ink; of a circle of such a radius, less than a
/// twentieth.
const THIN: f64 = 0.099;
/// Gaps of dashes up to so many px are usual.
const GAP: f64 = 24.0;
/// A line is one of no length if it is no longer than this part of half its width.
const TINY: f64 = 0.1;
/// Corners of a rectangle that are round by no more than this part of its longer side are sharp.
const SHARP: f64 = 1e-4;
/// A pattern that covers less than this leaves most of its area open.
const SPARSE: f64 = 0.5;

/// What is said of curves.
pub(super) const CURVES: &str = "curves (edges are straight)";

/// The corners of a path, each with whether it lies on a curve, and whether the path is closed.
type Placed = (Vec<(Point, bool)>, bool);

impl<'a, 'i> Reader<'a, 'i> {
    /// Reads any element that paints.
    pub(super) fn shape(&mut self, node: Node<'_, '_>, name: &str, around: &Around, depth: usize) -> Result<(), Fault> {
        let offset = node.range().start;
        match name {
            "circle" | "ellipse" => return self.circle(node, around),
            "image" => return self.image(node, around),
            _ => {}
        }
        let (paths, what) = subpaths(node, around)?;
        let flat = if is_flat(&paths) { around.ink.flat() } else { None };
        let flat = flat.map(|ink| Around { ink, ..around.clone() });
        let around = flat.as_ref().unwrap_or(around);
        let dashed = stated(node, &paths).and_then(|by| around.ink.with_longer_dashes(by));
        let dashed = dashed.map(|ink| Around { ink, ..around.clone() });
        let around = dashed.as_ref().unwrap_or(around);
        self.count(paths.iter().map(|path| path.points.len()).sum(), offset)?;
        let mut placed = Vec::with_capacity(paths.len());
        for path in &paths {
            let corner = |&(p, curved): &([f64; 2], bool)| Ok((place(&around.transform, p, offset, what)?, curved));
            placed.push((path.points.iter().map(corner).collect::<Result<Vec<_>, Fault>>()?, path.closed));
        }
        let (outer, only) = (around, placed.first().filter(|_| placed.len() == 1));
        let is_only = is_only(&placed);
        let circle = only.filter(|_| around.stand.is_some()).and_then(|(points, closed)| oval(points, *closed, true));
        let circle = circle.map(|oval| around.of_circle(oval.centre, oval.radius));
        let around = circle.as_deref().unwrap_or(around);
        self.area(node, what, &placed, around);
        let has_curves = placed.iter().any(|(points, _)| points.iter().any(|p| p.1));
        for (points, closed) in &placed {
            if let Some(oval) = oval(points, *closed, is_only).filter(|_| !around.decorates) {
                self.round_path(node, &oval, around);
            } else {
                self.trace(node, points, *closed, what, has_curves, around);
            }
        }
        if outer.ink.markers.is_any() && what != "rect" {
            self.markers(&paths, outer, depth, offset)?;
        }
        Ok(())
    }

    /// The filled part of a shape.
    fn area(&mut self, node: Node<'_, '_>, what: &str, placed: &[Placed], around: &Around) {
        let is_only = is_only(placed);
        // The coats of dots are discs.
        let is_dot = |(points, closed): &Placed| !around.decorates && oval(points, *closed, is_only).is_some();
        let has_inside = |path: &Placed| path.0.len() > 2 && !is_dot(path);
        let rings = placed.iter().filter(|path| what != "line" && around.ink.fills() && has_inside(path));
        let rings: Vec<Vec<Point>> = rings.map(|(points, _)| points.iter().map(|p| p.0).collect()).collect();
        if rings.is_empty() {
            return;
        }
        let part = around.part(Part::Area);
        let area = Area::new(&rings, around.ink.even_odd);
        let is_empty = |points: &[(Point, bool)]| {
            rings.len() > 1 && area.leaves_empty(&points.iter().map(|p| p.0).collect::<Vec<_>>())
        };
        let empty: Vec<bool> = placed.iter().map(|(points, _)| is_empty(points)).collect();
        let coat = self.out.painting.add(Shape::Area(area), around.ink.fill(), around.clip, part);
        if around.ink.hatched && self.out.painting.coats[coat as usize].alpha < SPARSE {
            self.out.painting.sparse.push(coat);
        }
        if around.axes == Some(Axes::Behind) {
            self.out.paper.push(coat);
            return;
        }
        // Hatches of the kit are decoration.
        if around.decorates || !self.fills || self.kit && around.ink.hatched {
            return;
        }
        let name = node.parent().map_or_else(String::new, declared::face_name);
        let hole = node.parent().is_some_and(|group| group.attribute("data-hole") == Some("true"));
        for ((points, _), empty) in placed.iter().zip(empty).filter(|(path, _)| has_inside(path)) {
            let outlines = keyholes(points);
            let is_one = outlines.len() == 1;
            for ring in outlines {
                let empty = if is_one { empty } else { self.leaves_empty(coat, &ring) };
                self.out.outlines.push(Outline {
                    points: ring,
                    name: name.clone(),
                    hole,
                    empty,
                    coat,
                    curved: points.iter().any(|p| p.1),
                    hidden: around.ink.hidden_fill(),
                    aside: around.aside,
                    legend: around.legend,
                    shape: self.current(),
                });
            }
        }
    }

    /// Whether an area leaves one of its outlines empty.
    fn leaves_empty(&self, coat: u32, ring: &[Point]) -> bool {
        matches!(&self.out.painting.coats[coat as usize].shape, Shape::Area(area) if area.leaves_empty(ring))
    }

    /// The width of lines on the canvas.
    fn half_width(around: &Around) -> f64 {
        0.5 * around.ink.width() * if around.own.fixed_width { 1.0 } else { around.transform.growth() }
    }

    /// Why a line of this style cannot be seen, wherever it lies.
    fn hidden_line(&self, around: &Around) -> Option<Hidden> {
        let is_thin = 2.0 * Self::half_width(around) * self.shown(around) < THIN;
        around.ink.hidden_stroke().or(is_thin.then_some(Hidden::Thin))
    }

    /// How many px a unit of the width of a line is shown as.
    fn shown(&self, around: &Around) -> f64 {
        if around.own.fixed_width { 1.0 } else { self.unit }
    }

    /// The lines of a polyline, which is the whole element or one part of it.
    fn trace(
        &mut self,
        node: Node<'_, '_>,
        points: &[(Point, bool)],
        closed: bool,
        what: &str,
        has_curves: bool,
        around: &Around,
    ) {
        let Some(&(first, _)) = points.first() else { return };
        let ink = &around.ink;
        let hidden = self.hidden_line(around);
        let (half, stroke) = (Self::half_width(around), ink.stroke());
        let cover = (2.0 * half * self.shown(around)).min(1.0);
        self.blank += usize::from(around.decorates && hidden.is_some() && (what == "line" || !ink.fills()));
        let is_mark = self.kit && node.attribute("class") == Some("dots");
        // A line much shorter than wide shows no more than its ends.
        let reach = if ink.round && hidden.is_none() { TINY * half } else { 0.0 };
        if is_mark || points.iter().all(|p| distance(p.0, first) <= reach) {
            let last = points.last().map_or(first, |p| p.0);
            let first = Point::new(0.5 * (first.x + last.x), 0.5 * (first.y + last.y));
            // A line of no length with round ends is a dot; a move alone is nothing.
            let is_line = is_mark || closed || points.len() > 1;
            if hidden.is_none() && ink.round && is_line && !around.decorates {
                self.dot(first, half, None, around, None);
                let disc = Oval::circle((first, half)).disc();
                self.out.painting.add(Shape::Disc(disc), stroke, around.clip, Part::Dot);
            }
            return;
        }
        let back = closed.then_some((first, false));
        let growth = around.transform.growth().max(f64::MIN_POSITIVE);
        let usual = GAP / (self.unit * growth);
        let (mut from, mut far, mut curves) = (first, 0.0, false);
        for (to, curved) in points.iter().skip(1).copied().chain(back) {
            let long = distance(from, to) / growth;
            let dashed = hidden.is_none() && (ink.dashed_away(far, long) || ink.has_gap(far, long, usual));
            let why = hidden.or_else(|| dashed.then_some(Hidden::Dashes));
            if from != to && why.is_none() {
                let part = around.part(if curved { Part::Other } else { Part::Line });
                let coat = self.out.painting.add(Shape::Stroke([from, to], half), stroke, around.clip, part);
                self.out.painting.coats[coat as usize].cover = cover;
                if curved && around.decorates {
                    self.out.bends.push(coat);
                }
            }
            if from != to && !around.decorates {
                curves |= curved && hidden.is_none();
                let is_line = !curved && (what == "line" || !ink.fills() || hidden.is_none());
                if let Some(axes) = around.axes.filter(|axes| is_line && axes.has([from, to])) {
                    self.out.axes[axes.number()] += 1;
                } else if is_line {
                    let dashes = if dashed { self.dashes([from, to], (far, long), half, around) } else { [0; 2] };
                    self.out.lines.push(Line {
                        ends: [from, to],
                        half,
                        hidden: why,
                        aside: around.aside,
                        legend: around.legend,
                        shape: self.current(),
                        curved: has_curves,
                        dashes,
                    });
                }
            }
            far += long;
            from = to;
        }
        if curves {
            self.ignore(CURVES);
        }
    }

    /// Paints the dashes of a line that they leave out in part, or nearly whole, as far as a screen shows them. It begins so far from the
    /// start of its path and is so long, before any transform.
    fn dashes(&mut self, [p, q]: [Point; 2], (far, long): (f64, f64), half: f64, around: &Around) -> [u32; 2] {
        let least = THIN * long / (distance(p, q) * self.unit);
        let start = self.out.painting.coats.len() as u32;
        for dash in around.ink.dashes(far, long, least) {
            if self.dashes >= LINES {
                break;
            }
            self.dashes += 1;
            let ends = dash.map(|at| Point::new(p.x + at / long * (q.x - p.x), p.y + at / long * (q.y - p.y)));
            self.out.painting.add(Shape::Stroke(ends, half), around.ink.stroke(), around.clip, Part::Line);
        }
        [start, self.out.painting.coats.len() as u32]
    }

    fn dot(
        &mut self,
        at: Point,
        radius: f64,
        hidden: Option<Hidden>,
        around: &Around,
        vertex: Option<(String, Point)>,
    ) {
        self.out.dots.push(Dot { at, radius, hidden, vertex, aside: around.aside, legend: around.legend });
    }

    /// Why a circle of this style that reaches so far cannot be seen, wherever it lies.
    fn hidden_circle(&self, around: &Around, reach: f64) -> Option<Hidden> {
        let hidden = self.hidden_line(around).and(around.ink.hidden_fill());
        let is_tiny = reach > 0.0 && (reach + Self::rim(around)) * self.unit < THIN;
        hidden.or(is_tiny.then_some(Hidden::Tiny))
    }

    /// A circle or an ellipse drawn by a path.
    fn round_path(&mut self, node: Node<'_, '_>, oval: &Oval, around: &Around) {
        let hidden = self.hidden_circle(around, oval.reach);
        self.discs(oval, around);
        let vertex = node.parent().and_then(declared::vertex);
        self.dot(oval.centre, oval.reach + Self::rim(around), hidden, around, vertex);
    }

    /// How far a stroke reaches beyond its circle.
    fn rim(around: &Around) -> f64 {
        if around.ink.hidden_stroke().is_none() { Self::half_width(around) } else { 0.0 }
    }

    /// The coats of a circle: its inside, and its rim.
    fn discs(&mut self, oval: &Oval, around: &Around) {
        let (disc, part) = (oval.disc(), around.part(Part::Dot));
        if around.ink.fills() {
            self.out.painting.add(Shape::Disc(disc), around.ink.fill(), around.clip, part);
        }
        let rim = Self::rim(around);
        if rim > 0.0 {
            let wide = rim / oval.radius.max(f64::MIN_POSITIVE);
            let ring = Disc { from: 1.0 - wide, to: 1.0 + wide, reach: disc.reach + rim, ..disc };
            self.out.painting.add(Shape::Disc(ring), around.ink.stroke(), around.clip, part);
        }
    }

    fn circle(&mut self, node: Node<'_, '_>, around: &Around) -> Result<(), Fault> {
        let offset = node.range().start;
        let centre = [length(node, "cx", 0, around)?, length(node, "cy", 1, around)?];
        let radii = if node.tag_name().name() == "circle" {
            [length(node, "r", 2, around)?; 2]
        } else {
            let (x, y) = (set_length(node, "rx", 0, around)?, set_length(node, "ry", 1, around)?);
            [x.or(y).unwrap_or(0.0), y.or(x).unwrap_or(0.0)]
        };
        let at = place(&around.transform, centre, offset, "circle")?;
        self.count(1, offset)?;
        let axes = [around.transform.turn([radii[0], 0.0]), around.transform.turn([0.0, radii[1]])].map(flipped);
        let determinant = axes[0].x * axes[1].y - axes[1].x * axes[0].y;
        let reach = axes[0].x.hypot(axes[0].y).max(axes[1].x.hypot(axes[1].y));
        if reach > FAR {
            return Err(Fault::at(offset, Problem::Coordinate { what: "circle" }));
        }
        let mut hidden = self.hidden_circle(around, reach);
        let radius = determinant.abs().sqrt();
        let around = &*around.of_circle(at, radius);
        if radius > 0.0 && determinant.is_finite() {
            let inverse =
                [axes[1].y / determinant, -axes[1].x / determinant, -axes[0].y / determinant, axes[0].x / determinant];
            self.discs(&Oval { centre: at, inverse, radius, reach }, around);
        } else {
            hidden = hidden.or(Some(Hidden::NoSize));
        }
        if !around.decorates {
            let vertex = node.parent().and_then(declared::vertex);
            self.dot(at, reach + Self::rim(around), hidden, around, vertex);
        }
        Ok(())
    }

    /// A picture: nothing is known of it but that it covers.
    fn image(&mut self, node: Node<'_, '_>, around: &Around) -> Result<(), Fault> {
        self.ignore("<image>");
        let link = node.attributes().find(|a| a.name() == "href").map_or("", |a| a.value().trim());
        let sides = [set_length(node, "width", 0, around)?, set_length(node, "height", 1, around)?];
        if !link.is_empty() && sides.contains(&None) {
            let wanted = "width or height of a picture here: write both as numbers";
            return Err(word(node.range().start, "auto", wanted));
        }
        let rings = rings(node, &around.transform, around)?;
        let area = Shape::Area(Area::new(&rings, false));
        self.out.painting.add(area, (Paint::Some, 1.0), around.clip, around.part(Part::Other));
        Ok(())
    }
}

/// How many times as long some stretches are as their element says, which is what its dashes are measured by.
fn stated(node: Node<'_, '_>, paths: &[Subpath]) -> Option<f64> {
    let stated = node.attribute("pathLength").and_then(numbers::measure).filter(|length| *length > 0.0)?;
    let mut length = 0.0;
    for Subpath { points, closed } in paths {
        let back = points.first().filter(|_| *closed);
        let ends = points.iter().zip(points.iter().skip(1).chain(back));
        length += ends.map(|((p, _), (q, _))| (q[0] - p[0]).hypot(q[1] - p[1])).sum::<f64>();
    }
    Some(length / stated)
}

/// Whether something has no width or no height.
fn is_flat(paths: &[Subpath]) -> bool {
    let mut points = paths.iter().flat_map(|path| &path.points).map(|point| point.0);
    let Some(first) = points.next() else { return false };
    let (mut level, mut upright) = (true, true);
    for [x, y] in points {
        level &= y.to_bits() == first[1].to_bits();
        upright &= x.to_bits() == first[0].to_bits();
    }
    level || upright
}

/// The rings that an element would fill, on the canvas. `around` has the element's own style.
pub(super) fn rings(node: Node<'_, '_>, transform: &Transform, around: &Around) -> Result<Vec<Vec<Point>>, Fault> {
    let offset = node.range().start;
    let name = node.tag_name().name();
    if matches!(name, "circle" | "ellipse") {
        let [x, y] = [length(node, "cx", 0, around)?, length(node, "cy", 1, around)?];
        let [rx, ry] = if name == "circle" { ["r", "r"] } else { ["rx", "ry"] };
        let (rx, ry) = (length(node, rx, 2, around)?, length(node, ry, 2, around)?);
        let data = format!("M{} {y}A{rx} {ry} 0 0 1 {} {y}A{rx} {ry} 0 0 1 {} {y}Z", x + rx, x - rx, x + rx);
        let ring = |path: &Subpath| path.points.iter().map(|p| flipped(transform.apply(p.0))).collect();
        return Ok(path::read(&data).unwrap_or_default().iter().map(ring).collect());
    }
    let (paths, what) = subpaths(node, around)?;
    let ring = |path: &Subpath| path.points.iter().map(|p| place(transform, p.0, offset, what)).collect();
    paths.iter().filter(|path| path.points.len() > 2).map(ring).collect()
}

/// The stretches that an element draws, and what it is called.
fn subpaths(node: Node<'_, '_>, around: &Around) -> Result<(Vec<Subpath>, &'static str), Fault> {
    Ok(match node.tag_name().name() {
        "line" => (vec![line(node, around)?], "line"),
        "polyline" => (polyline(node, false)?, "polyline"),
        "polygon" => (polyline(node, true)?, "polygon"),
        "rect" | "image" | "foreignObject" => (rect(node, around)?, "rect"),
        "path" => {
            let data = match around.own.geometry.of("path", "d") {
                Some(text) => path_data(text).ok_or_else(|| word(node.range().start, text, "path(\"...\") or none"))?,
                None => node.attribute("d").unwrap_or(""),
            };
            let slack = around.slack / around.transform.growth().max(f64::MIN_POSITIVE);
            (path::read_within(data, slack).map_err(|rest| word(node.range().start, rest, "path data"))?, "path")
        }
        _ => (Vec::new(), "shape"),
    })
}

fn line(node: Node<'_, '_>, around: &Around) -> Result<Subpath, Fault> {
    let from = [length(node, "x1", 0, around)?, length(node, "y1", 1, around)?];
    let to = [length(node, "x2", 0, around)?, length(node, "y2", 1, around)?];
    Ok(Subpath { points: vec![(from, false), (to, false)], closed: false })
}

fn polyline(node: Node<'_, '_>, closed: bool) -> Result<Vec<Subpath>, Fault> {
    let text = node.attribute("points").unwrap_or("");
    let wanted = "list of points: write x,y x,y ...";
    let numbers = numbers::list(text).filter(|list| list.len() % 2 == 0);
    let numbers = numbers.ok_or_else(|| word(node.range().start, text, wanted))?;
    let points = numbers.chunks_exact(2).map(|p| ([p[0], p[1]], false)).collect();
    Ok(vec![Subpath { points, closed }])
}

/// A rectangle; with round corners that are nearly all of it, a circle; with others, straight sides and arcs.
fn rect(node: Node<'_, '_>, around: &Around) -> Result<Vec<Subpath>, Fault> {
    let (x, y) = (length(node, "x", 0, around)?, length(node, "y", 1, around)?);
    let (width, height) = (length(node, "width", 0, around)?, length(node, "height", 1, around)?);
    if !(width > 0.0 && height > 0.0) {
        return Ok(Vec::new());
    }
    let (rx, ry) = (set_length(node, "rx", 0, around)?, set_length(node, "ry", 1, around)?);
    let [rx, ry] = [rx.or(ry).unwrap_or(0.0).min(width / 2.0), ry.or(rx).unwrap_or(0.0).min(height / 2.0)];
    if rx >= 0.49 * width && ry >= 0.49 * height {
        let (right, middle) = (x + width, y + height / 2.0);
        let (rx, ry) = (width / 2.0, height / 2.0);
        let data = format!("M{right} {middle}A{rx} {ry} 0 0 1 {x} {middle}A{rx} {ry} 0 0 1 {right} {middle}Z");
        return Ok(path::read(&data).unwrap_or_default());
    }
    if rx.min(ry) > SHARP * width.max(height) {
        let (left, right, top, bottom) = (x + rx, x + width - rx, y + ry, y + height - ry);
        let arc = |x: f64, y: f64| format!("A{rx} {ry} 0 0 1 {x} {y}");
        let arcs = [arc(x + width, top), arc(right, y + height), arc(x, bottom), arc(left, y)];
        let [a, b, c, d] = arcs;
        let data = format!("M{left} {y}H{right}{a}V{bottom}{b}H{left}{c}V{top}{d}Z");
        return Ok(path::read(&data).unwrap_or_default());
    }
    let points = corners([x, y, width, height]).map(|p| (p, false)).to_vec();
    Ok(vec![Subpath { points, closed: true }])
}

/// The outlines of which a keyhole is made, or the one of another shape.
fn keyholes(points: &[(Point, bool)]) -> Vec<Vec<Point>> {
    // 0 is written in two ways.
    let keys: Vec<[u64; 2]> = points.iter().map(|(p, _)| [p.x + 0.0, p.y + 0.0].map(f64::to_bits)).collect();
    let point = |key: [u64; 2]| Point::new(f64::from_bits(key[0]), f64::from_bits(key[1]));
    parts(&keys).into_iter().map(|part| part.into_iter().map(point).collect()).collect()
}

/// Whether an element draws one stretch only; a move alone is none.
fn is_only(placed: &[Placed]) -> bool {
    placed.iter().filter(|(points, _)| points.len() > 1).count() == 1
}

/// The circle that a closed stretch of curves is, or, if it is all of its element, the ellipse.
fn oval(points: &[(Point, bool)], closed: bool, is_only: bool) -> Option<Oval> {
    let circle = round(points, closed).map(Oval::circle);
    circle.or_else(|| if is_only { Oval::of(points, closed) } else { None })
}

/// The middle and the radius of a closed stretch of curves that is a circle. Straight sides are those of a polygon.
fn round(points: &[(Point, bool)], closed: bool) -> Option<(Point, f64)> {
    let (first, last) = (points.first()?.0, points.last()?.0);
    let curved = points.iter().filter(|p| p.1).count();
    let corners = &points[..points.len() - usize::from(first == last)];
    if curved < PIECES || curved + 2 < corners.len() {
        return None;
    }
    let (centre, radius) = circle_through(corners)?;
    let fits = |p: Point| (distance(p, centre) - radius).abs() <= ROUND * radius;
    // All round, and not an arc with its chord.
    let step = |p: Point, q: Point| distance(p, q) <= STEP * radius;
    let ends = step(last, first) && (closed || distance(first, last) <= ROUND * radius);
    let all = points.iter().all(|p| fits(p.0)) && points.windows(2).all(|w| step(w[0].0, w[1].0));
    (ends && all).then_some((centre, radius))
}

/// The circle nearest to some points (Kasa 1976).
fn circle_through(points: &[(Point, bool)]) -> Option<(Point, f64)> {
    let count = points.len() as f64;
    let sum = |of: &dyn Fn(Point) -> f64| points.iter().map(|p| of(p.0)).sum::<f64>();
    let (x, y) = (sum(&|p| p.x) / count, sum(&|p| p.y) / count);
    let moment = |i: i32, j: i32| sum(&|p| (p.x - x).powi(i) * (p.y - y).powi(j));
    let [xx, xy, yy] = [moment(2, 0), moment(1, 1), moment(0, 2)];
    let right = [0.5 * (moment(3, 0) + moment(1, 2)), 0.5 * (moment(0, 3) + moment(2, 1))];
    let determinant = xx * yy - xy * xy;
    let centre = Point::new(
        x + (right[0] * yy - right[1] * xy) / determinant,
        y + (right[1] * xx - right[0] * xy) / determinant,
    );
    let radius = sum(&|p| distance(p, centre)) / count;
    (radius.is_finite() && radius > 0.0).then_some((centre, radius))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(data: &str) -> Option<(Point, f64)> {
        let read = path::read(data).unwrap();
        let points: Vec<(Point, bool)> =
            read[0].points.iter().map(|&(p, curved)| (Point::new(p[0], p[1]), curved)).collect();
        round(&points, read[0].closed)
    }

    #[test]
    fn circles_are_found_and_nothing_else_is() {
        let (centre, radius) = found("M 14 5 A 4 4 0 1 1 6 5 A 4 4 0 1 1 14 5 Z").unwrap();
        assert!((centre.x - 10.0).abs() < 1e-9 && (centre.y - 5.0).abs() < 1e-9 && (radius - 4.0).abs() < 1e-9);
        let bezier = "M 0 -3 C .795609 -3 1.55874 -2.683901 2.12132 -2.12132 C 2.683901 -1.55874 3 -.795609 3 0 \
                      C 3 .795609 2.683901 1.55874 2.12132 2.12132 C 1.55874 2.683901 .795609 3 0 3 \
                      C -.795609 3 -1.55874 2.683901 -2.12132 2.12132 C -2.683901 1.55874 -3 .795609 -3 0 \
                      C -3 -.795609 -2.683901 -1.55874 -2.12132 -2.12132 C -1.55874 -2.683901 -.795609 -3 0 -3 z";
        let (centre, radius) = found(bezier).unwrap();
        assert!(centre.x.abs() < 1e-6 && centre.y.abs() < 1e-6 && (radius - 3.0).abs() < 1e-3);
        for other in [
            "M0 0H9V9H0Z",
            "M0 0C9 0 9 9 0 9Z",
            "M-4 0A4 4 0 0 1 4 0Z",
            "M-4 0A4 4 0 0 1 4 0A4 2 0 0 1 -4 0Z",
            "M0 0L1 0L2 1L2 2L1 3L0 3L-1 2L-1 1Z",
        ] {
            assert_eq!(found(other), None, "{other}");
        }
    }
}
