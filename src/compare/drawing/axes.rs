//! Axes as matplotlib draws them, told by the names of their groups.
//!
//! ```text
//!   <g id="axes_1">
//!     <g id="patch_2"> a rectangle             what lies behind the drawing; it may be missing
//!     <g id="matplotlib.axis_1"> ...           ticks, their texts, lines of a grid
//!     <g id="line2d_5"> a line, clipped        the drawing
//!     <g id="patch_3"> a line, not clipped     a spine: as long as a side of the rectangle
//! ```
//!
//! What lies behind is paper. Spines are no part of a structure wherever they lie, nor are level and upright lines of a tick that are short or begin
//! at the border. So an edge on which one of these lies is there only if it is drawn itself. What is called so outside of
//! such a group is read as anything else.

use super::{Transform, flipped};
use crate::compare::pairing::{distance, sides};
use crate::compare::path;
use crate::geometry::point::corners;
use crate::plane::Point;
use roxmltree::Node;

/// How well a spine fits a side, and the end of a line the border, as a part of it.
const FIT: f64 = 1e-3;
/// A tick is no longer than this part of the axes.
const SHORT: f64 = 0.05;

/// Where in axes something stands.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(in crate::compare) enum Axes {
    /// In a spine: a line of the frame, or one in its place.
    Spine,
    /// In what lies behind the drawing.
    Behind,
    /// In a tick, which may have a line of the grid, of axes with these corners.
    Tick([Point; 2]),
}

impl Axes {
    /// Whether a line on the canvas is a part of the axes and of nothing else.
    pub(super) fn has(&self, [a, b]: [Point; 2]) -> bool {
        let Self::Tick([low, high]) = *self else { return *self == Self::Spine };
        let size = (high.x - low.x).max(high.y - low.y);
        let near = |x: f64, y: f64| (x - y).abs() <= FIT * size;
        let begins = |p: Point| near(p.x, low.x) || near(p.x, high.x) || near(p.y, low.y) || near(p.y, high.y);
        let is_straight = near(a.x, b.x) || near(a.y, b.y);
        is_straight && (distance(a, b) <= SHORT * size || begins(a) || begins(b))
    }

    /// The number of its kind.
    pub(super) fn number(&self) -> usize {
        usize::from(matches!(self, Self::Tick(_)))
    }
}

/// What of axes a group is, if anything, under its transform.
pub(super) fn part(node: Node<'_, '_>, transform: &Transform) -> Option<Axes> {
    let id = node.attribute("id").filter(|_| node.tag_name().name() == "g")?;
    if is_numbered(id, "xtick_") || is_numbered(id, "ytick_") {
        let axis = node.parent_element().filter(|axis| is_called(*axis, "matplotlib.axis_"))?;
        let whole = whole(axis.parent_element()?)?;
        return Some(Axes::Tick(corners(whole.into_iter().map(|p| flipped(transform.apply(p))))));
    }
    let axes = node.parent_element().filter(|axes| is_numbered(id, "patch_") && is_called(*axes, "axes_"))?;
    if axes.first_element_child() == Some(node) && behind(axes).is_some() {
        return Some(Axes::Behind);
    }
    let (spine, whole) = (sides(&line(node)?), sides(&whole(axes)?));
    let is_side = |i: usize| (spine[i] - whole[i]).abs() <= FIT * whole[i] && spine[1 - i] <= FIT * whole[1 - i];
    (is_side(0) || is_side(1)).then_some(Axes::Spine)
}

/// The corners of the rectangle behind axes, which comes first in their group, and is not clipped as the drawing is.
fn behind(axes: Node<'_, '_>) -> Option<Vec<[f64; 2]>> {
    let first = axes.first_element_child().filter(|first| is_called(axes, "axes_") && is_called(*first, "patch_"))?;
    points(unclipped(first)?, 4)
}

/// The corners of axes: of what lies behind, or if that is missing, of the four spines.
fn whole(axes: Node<'_, '_>) -> Option<Vec<[f64; 2]>> {
    if let Some(corners) = behind(axes) {
        return Some(corners);
    }
    let groups = axes.children().filter(|group| is_called(axes, "axes_") && is_called(*group, "patch_"));
    let lines: Vec<Vec<[f64; 2]>> = groups.filter_map(line).take(5).collect();
    let [low, high] = corners(lines.iter().flatten().copied().map(Point::from));
    (lines.len() == 4).then(|| vec![[low.x, low.y], [high.x, low.y], [high.x, high.y], [low.x, high.y]])
}

/// The ends of a group that is one line, and not clipped.
fn line(group: Node<'_, '_>) -> Option<Vec<[f64; 2]>> {
    points(unclipped(group)?, 2)
}

fn unclipped<'a, 'i>(group: Node<'a, 'i>) -> Option<Node<'a, 'i>> {
    only_path(group).filter(|path| !path.has_attribute("clip-path"))
}

fn is_called(node: Node<'_, '_>, word: &str) -> bool {
    node.attribute("id").is_some_and(|id| is_numbered(id, word))
}

/// Whether a name is this word and a number.
fn is_numbered(id: &str, word: &str) -> bool {
    id.strip_prefix(word).is_some_and(|number| !number.is_empty() && number.bytes().all(|b| b.is_ascii_digit()))
}

/// The path that is all that a group holds.
fn only_path<'a, 'i>(group: Node<'a, 'i>) -> Option<Node<'a, 'i>> {
    let first = group.first_element_child().filter(|child| child.tag_name().name() == "path")?;
    first.next_sibling_element().is_none().then_some(first)
}

/// The corners of a path of one stretch with so many of them, all its sides straight.
fn points(path: Node<'_, '_>, count: usize) -> Option<Vec<[f64; 2]>> {
    let data = path.attribute("d").filter(|data| data.len() < 400)?;
    let read = path::read(data).ok()?;
    let [only] = &read[..] else { return None };
    let mut points: Vec<[f64; 2]> = only.points.iter().map(|p| p.0).collect();
    if points.len() > 1 && points.first() == points.last() {
        points.pop();
    }
    (only.points.iter().all(|p| !p.1) && points.len() == count).then_some(points)
}
