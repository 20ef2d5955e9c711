//! Markers and letters: they are no part of a structure, but large ones hide it. Of a marker, a circle round the place
//! where it stands is read as any other circle there: so vertices may be drawn.
//!
//! ```text
//!   ────▸        a marker is drawn as it is, at each place of the path where it stands
//!   ┌──────┐     a text is taken for a box: 0.6 em for each letter, in the colour of the letters, or of their rim if
//!   │ text │     that covers them; labels and arrow heads of ordinary size hide nothing, but letters that nobody can
//!   └──────┘     read: eye.rs; a textLength makes the box wider or narrower, and the letters with it
//! ```

use super::{Around, Reader, corners, place};
use crate::compare::colour::Paint;
use crate::compare::error::Fault;
use crate::compare::markers::Stand;
use crate::compare::markup::is_svg;
use crate::compare::numbers;
use crate::compare::painting::{Area, Lettering, Mark, Part, Rim, Shape, shade};
use crate::compare::path::Subpath;
use crate::compare::transform::Transform;
use crate::compare::values::unworked;
use crate::compare::viewport;
use roxmltree::Node;

/// Width of a letter, and how far it reaches above and below its line, in parts of its size.
const LETTER: f64 = 0.6;
const ABOVE: f64 = 0.8;
const BELOW: f64 = 0.15;
/// A rim covers its letters if it is as wide as this part of them: one over them, and one below them.
const WIDE: [f64; 2] = [0.25, 1.0];
/// Markers that are drawn, at most.
const MARKERS: usize = 50_000;

impl<'a, 'i> Reader<'a, 'i> {
    /// The markers along the stretches of a path.
    pub(super) fn markers(&mut self, paths: &[Subpath], around: &Around, depth: usize, at: usize) -> Result<(), Fault> {
        if around.mark.is_some() || around.ink.is_switched_off() {
            return Ok(());
        }
        let last = paths.len().saturating_sub(1);
        for (i, path) in paths.iter().enumerate() {
            let corners = corners_of(path);
            for (j, &(point, way_in, way_out)) in corners.iter().enumerate() {
                let (first, end) = (i == 0 && j == 0, i == last && j + 1 == corners.len());
                let (own, both) = (way_in.or(way_out), between(way_in, way_out));
                let stands =
                    [(Stand::Start, own, first), (Stand::Middle, both, !first && !end), (Stand::End, own, end)];
                for (stand, angle, _) in stands.into_iter().filter(|stand| stand.2) {
                    self.marker(stand, point, angle, around, depth, at)?;
                }
            }
        }
        Ok(())
    }

    /// One marker, if there is one for this place.
    fn marker(
        &mut self,
        end: Stand,
        at: [f64; 2],
        angle: Option<f64>,
        around: &Around,
        depth: usize,
        offset: usize,
    ) -> Result<(), Fault> {
        let Some(id) = around.ink.markers.at(end) else { return Ok(()) };
        let Some(node) = self.by_id(&id).filter(|n| n.tag_name().name() == "marker" && is_svg(*n)) else {
            return Ok(());
        };
        self.markers += 1;
        Fault::if_more(self.markers, MARKERS, "markers", offset)?;
        let number = |name: &str, otherwise: f64| node.attribute(name).and_then(numbers::measure).unwrap_or(otherwise);
        let size = [number("markerWidth", 3.0), number("markerHeight", 3.0)];
        if size.iter().any(|side| *side <= 0.0) {
            return Ok(());
        }
        let fixed = node.attribute("markerUnits") == Some("userSpaceOnUse");
        let unit = if fixed { 1.0 } else { around.ink.width() };
        let turned = turn(node.attribute("orient").unwrap_or("0"), end, angle.unwrap_or(0.0));
        let inside = node.attribute("viewBox").and_then(viewport::view_box);
        let ratio = node.attribute("preserveAspectRatio").unwrap_or("");
        let fit =
            inside.map_or(Transform::IDENTITY, |inside| viewport::fitted(inside, [0.0, 0.0, size[0], size[1]], ratio));
        let anchor = fit.apply([number("refX", 0.0), number("refY", 0.0)]);
        let room = around
            .transform
            .after(&Transform::translate(at[0], at[1]))
            .after(&turned)
            .after(&Transform::scale(unit, unit))
            .after(&Transform::translate(-anchor[0], -anchor[1]));
        let stand = (!around.decorates).then(|| place(&around.transform, at, offset, "marker")).transpose()?;
        // A marker inherits from where it stands in the file, not from the line.
        let inner = Around {
            ink: around.ink.fresh(),
            mark: Some(Mark::Marker),
            clip: around.clip,
            stand,
            aside: around.aside,
            legend: around.legend,
            ..Around::default()
        };
        self.inside_marker(node, size, &room, &fit, inner, depth)
    }

    /// What a marker holds, in its room, which has this size.
    fn inside_marker(
        &mut self,
        node: Node<'a, 'i>,
        size: [f64; 2],
        room: &Transform,
        fit: &Transform,
        mut inner: Around,
        depth: usize,
    ) -> Result<(), Fault> {
        let outside = std::mem::take(&mut self.path);
        let mut chain: Vec<Node<'a, 'i>> = node.ancestors().filter(Node::is_element).collect();
        chain.reverse();
        let mut shown = true;
        for element in chain {
            self.visit(element)?;
            self.enter(element);
            if let Some((ink, own)) = inner.ink.inside(element, &self.rules, &self.path) {
                (inner.ink, inner.own) = (ink, own);
            } else {
                shown = false;
            }
        }
        if shown {
            inner.transform = room.after(fit);
            inner.room = node.attribute("viewBox").and_then(viewport::view_box).or(Some([0.0, 0.0, size[0], size[1]]));
            if !inner.own.overflows {
                let corners = corners([0.0, 0.0, size[0], size[1]]).into_iter();
                let ring = corners.map(|corner| place(room, corner, node.range().start, "marker"));
                let area = Area::new(&[ring.collect::<Result<_, _>>()?], false);
                inner.clip = Some(self.add_clip(vec![area], inner.clip));
            }
            inner.decorates = true;
            self.children(node, &inner, depth + 1)?;
        }
        self.path = outside;
        Ok(())
    }

    /// A text, as boxes: one for what stands at its own place, and one for each part with a place of its own.
    pub(super) fn text(
        &mut self,
        node: Node<'a, 'i>,
        around: &Around,
        start: [f64; 2],
        stretch: f64,
        depth: usize,
    ) -> Result<(), Fault> {
        let offset = node.range().start;
        let stretch = stretched(node, around.ink.letters.size).unwrap_or(stretch);
        let axis = |name: &str, otherwise: f64| {
            let first = node.attribute(name).and_then(|list| list.split([' ', ',']).find(|word| !word.is_empty()));
            first.and_then(numbers::measure).unwrap_or(otherwise)
        };
        let recoloured = self.coloured.contains(&offset).then(|| Around { coloured: true, ..around.clone() });
        let around = recoloured.as_ref().unwrap_or(around);
        let start = [axis("x", start[0]) + axis("dx", 0.0), axis("y", start[1]) + axis("dy", 0.0)];
        let letters = count(node.children());
        if letters > 0 {
            self.letters(letters, start, stretch, around, offset)?;
        }
        Fault::if_deeper(depth, super::DEPTH, offset)?;
        for child in node.children().filter(|n| matches!(n.tag_name().name(), "tspan" | "a" | "textPath")) {
            self.enter(child);
            if let Some(inner) = self.inside(child, around)? {
                self.text(child, &inner, start, stretch, depth + 1)?;
            }
            self.path.pop();
        }
        Ok(())
    }

    /// The box of so many letters.
    fn letters(
        &mut self,
        count: usize,
        [x, y]: [f64; 2],
        stretch: f64,
        around: &Around,
        offset: usize,
    ) -> Result<(), Fault> {
        let ink = &around.ink;
        // What gets another colour is painted at some time.
        let has_rim = around.coloured || ink.hidden_stroke().is_none();
        if !ink.fills() && !has_rim {
            return Ok(());
        }
        if let Some((key, value)) = ink.letters.unread.as_deref() {
            return Err(unworked(offset, key, value));
        }
        let rim = if has_rim { 0.5 * ink.width() } else { 0.0 };
        let size = ink.letters.size;
        let width = LETTER * size * count as f64 * stretch;
        let left = x - ink.anchor * width;
        let room = [left - rim, y - ABOVE * size - rim, width + 2.0 * rim, (ABOVE + BELOW) * size + 2.0 * rim];
        let ring = corners(room).into_iter().map(|corner| place(&around.transform, corner, offset, "text"));
        // Letters far away hide nothing.
        let Ok(ring) = ring.collect::<Result<Vec<_>, _>>() else { return Ok(()) };
        let paint = if around.coloured {
            (Paint::Some, 1.0)
        } else if ink.fills() && !(has_rim && ink.width() >= WIDE[usize::from(ink.rim_below)] * size) {
            ink.fill()
        } else {
            ink.stroke()
        };
        self.count(1, offset)?;
        let area = Shape::Area(Area::new(&[ring], false));
        let coat = self.out.painting.add(area, paint, around.clip, Part::Mark(Mark::Letters));
        if !around.coloured {
            let rim = has_rim.then(|| Rim {
                shade: shade(ink.stroke()),
                width: ink.rim_width() / size.max(f64::MIN_POSITIVE),
                is_below: ink.rim_below,
            });
            let fill = if ink.fills() { shade(ink.fill()) } else { ([0.0; 3], 0.0) };
            let shown = size * self.unit * height(&around.transform) * stretch.min(1.0);
            let lettering = Lettering { size: shown, fill, rim };
            self.out.painting.lettering.insert(coat, lettering);
        }
        Ok(())
    }
}

/// How much wider a text is than it would be by itself, if it says how long it is.
fn stretched(node: Node<'_, '_>, size: f64) -> Option<f64> {
    let length = node.attribute("textLength").and_then(numbers::measure).filter(|length| *length > 0.0)?;
    let usual = LETTER * size * count(node.descendants()) as f64;
    (usual > 0.0).then_some(length / usual)
}

/// How many letters some texts have.
fn count<'a, 'i: 'a>(nodes: impl Iterator<Item = Node<'a, 'i>>) -> usize {
    nodes.filter(Node::is_text).filter_map(|n| n.text()).map(|text| text.trim().chars().count()).sum()
}

/// How high a square of height 1 is after a transform that may stretch or slant it.
fn height(transform: &Transform) -> f64 {
    let [[a, b], [c, d]] = [[1.0, 0.0], [0.0, 1.0]].map(|side| transform.turn(side));
    let long = a.hypot(b);
    let upright = if long > 0.0 { (a * d - b * c).abs() / long } else { 0.0 };
    long.min(upright)
}

/// A corner of a path, with the angles at which the path comes and goes.
type Corner = ([f64; 2], Option<f64>, Option<f64>);

/// The corners of a stretch; pieces of a curve are none.
fn corners_of(path: &Subpath) -> Vec<Corner> {
    let mut points: Vec<([f64; 2], bool)> = path.points.clone();
    if path.closed {
        points.extend(path.points.first().map(|first| (first.0, false)));
    }
    let angle = |p: [f64; 2], q: [f64; 2]| {
        let (x, y) = (q[0] - p[0], q[1] - p[1]);
        (x.hypot(y) > 0.0).then(|| y.atan2(x))
    };
    let count = points.len();
    let is_corner = |&i: &usize| i + 1 == count || i == 0 || !(points[i].1 && points[i + 1].1);
    let corner = |i: usize| {
        let before = i.checked_sub(1).and_then(|j| angle(points[j].0, points[i].0));
        let after = points.get(i + 1).and_then(|next| angle(points[i].0, next.0));
        (points[i].0, before, after)
    };
    (0..count).filter(is_corner).map(corner).collect()
}

/// The angle half way between two.
fn between(way_in: Option<f64>, way_out: Option<f64>) -> Option<f64> {
    match (way_in, way_out) {
        (Some(a), Some(b)) => Some((a.sin() + b.sin()).atan2(a.cos() + b.cos())),
        (a, b) => a.or(b),
    }
}

/// How a marker is turned; `angle` is the direction of the path.
fn turn(orient: &str, end: Stand, angle: f64) -> Transform {
    let degrees = match orient.trim() {
        "auto" => angle.to_degrees(),
        "auto-start-reverse" if end == Stand::Start => angle.to_degrees() + 180.0,
        "auto-start-reverse" => angle.to_degrees(),
        other => other.trim_end_matches(|c: char| c.is_ascii_alphabetic()).parse().unwrap_or(0.0),
    };
    Transform::read(&format!("rotate({degrees})")).unwrap_or(Transform::IDENTITY)
}
