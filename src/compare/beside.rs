//! What is drawn beside a structure and is no part of it: paper, frames, axes, legends, letters; and lines drawn as
//! thin rectangles.
//!
//! ```text
//!   ┌───────────────────┐   an area round everything is paper; lines along its border, or along that of the canvas,
//!   │  ●──────●   ▭ key │   are a frame, and so are ticks beyond it; what is called legend or axis and lies clear of
//!   │  │ A    │         │   the structure is left out, and so are lines of an axis right across it: a grid; a small
//!   └───────────────────┘   area that touches nothing is a letter
//! ```

use super::drawing::{Drawing, Line, Outline};
use super::pairing::{distance, lies_on, middle};
use super::snap::Snap;
use crate::geometry::point::corners;
use crate::plane::Point;

/// An area is small up to this part of the whole, if it touches no vertex.
pub(super) const SMALL: f64 = 0.12;
/// A thin rectangle: width by the size of the whole, length by width.
const THIN: f64 = 0.02;
const LONG: f64 = 4.0;
/// How near to a border a line lies that runs along it, as a part of the border's size.
const ALONG: f64 = 0.008;
/// So many borders are looked at.
const BORDERS: usize = 8;

/// What was left out.
#[derive(Clone, Debug, Default)]
pub(super) struct Beside {
    /// Coats of areas round everything, sorted.
    pub(super) paper: Vec<u32>,
    /// Coats of areas that stand for lines, sorted.
    pub(super) bars: Vec<u32>,
    /// Lines of frames, things in legends and on axes, small areas.
    pub(super) border: usize,
    pub(super) aside: usize,
    pub(super) small: usize,
    /// Legends that lie over the drawing.
    pub(super) over: usize,
}

/// What is left out that is called so.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Called {
    Nothing,
    /// What stands in a legend.
    Legend,
    /// That, and what is called an axis.
    Any,
}

/// What may be left out of a drawing.
#[derive(Clone, Debug)]
pub(super) struct Trim {
    /// Lines of a frame.
    pub(super) border: Vec<bool>,
    /// Lines of a frame that touches what it holds: they are left out if they go beyond that.
    pub(super) tight: Vec<bool>,
    /// What is left out by its name.
    pub(super) called: Called,
    /// The edges of the reference, over which no legend may lie.
    pub(super) edges: Vec<[Point; 2]>,
}

impl Trim {
    pub(super) fn nothing(drawing: &Drawing) -> Self {
        let none = vec![false; drawing.lines.len()];
        Self { border: none.clone(), tight: none, called: Called::Nothing, edges: Vec::new() }
    }

    /// Legends alone.
    pub(super) fn legends(drawing: &Drawing, edges: Vec<[Point; 2]>) -> Self {
        Self { called: Called::Legend, edges, ..Self::nothing(drawing) }
    }

    /// Whether anything would be left out.
    pub(super) fn is_any(&self, drawing: &Drawing) -> bool {
        let axis = || drawing.lines.iter().any(|line| line.aside) || drawing.dots.iter().any(|dot| dot.aside);
        let called = match self.called {
            Called::Nothing => false,
            Called::Legend => drawing.has_legend(),
            Called::Any => drawing.has_legend() || axis(),
        };
        called || self.border.contains(&true) || self.tight.contains(&true)
    }

    /// Whether something with these marks may be left out.
    pub(super) fn may_leave_out(&self, aside: bool, legend: u32) -> bool {
        match self.called {
            Called::Nothing => false,
            Called::Legend => legend > 0,
            Called::Any => aside,
        }
    }

    /// Everything that may be left out.
    pub(super) fn all(drawing: &Drawing, edges: Vec<[Point; 2]>) -> Self {
        let mut border = vec![false; drawing.lines.len()];
        for frame in borders(drawing, true) {
            if !drawing.lines.iter().any(|line| line.hidden.is_none() && frame.has(line)) {
                continue;
            }
            // With a frame go its ticks.
            for (line, border) in drawing.lines.iter().zip(&mut border) {
                *border |= frame.has(line) || frame.extent.is_outside(&line.ends, frame.slack());
            }
        }
        let inner = borders(drawing, false);
        let tight = drawing.lines.iter().map(|line| inner.iter().any(|frame| frame.has(line))).collect();
        Self { border, tight, called: Called::Any, edges }
    }
}

/// Which lines of a reference are a frame: a rectangle round everything, clear of it, without a vertex of its own where the
/// others are drawn. Ticks beyond it go with it.
pub(super) fn frames(drawing: &Drawing) -> Vec<bool> {
    if drawing.dots.iter().any(|dot| !dot.aside) {
        Trim::all(drawing, Vec::new()).border
    } else {
        vec![false; drawing.lines.len()]
    }
}

/// A frame that may stand round a drawing.
struct Border {
    extent: Extent,
    /// The element whose lines it is, if it is known.
    drawn: Option<u32>,
}

impl Border {
    fn slack(&self) -> f64 {
        ALONG * self.extent.size()
    }

    /// Whether a line is one of its sides.
    fn has(&self, line: &Line) -> bool {
        self.drawn == Some(line.shape) || self.extent.runs_along(line.ends, self.slack())
    }
}

/// The canvas and the rectangles, filled or not, also with round corners, that hold all that is drawn, and something at
/// all, but what runs along their border or beyond it. Unless `clear`, what they hold may touch them.
fn borders(drawing: &Drawing, clear: bool) -> Vec<Border> {
    let rectangle = |outline: &Outline| {
        let around = Extent::around(outline.points.clone());
        let slack = 1e-6 * around.size();
        let at_corner = |p: &Point| around.corners().iter().any(|&corner| distance(*p, corner) <= slack);
        (!outline.curved && outline.points.iter().all(at_corner)).then_some(around)
    };
    let canvas = drawing.canvas.map(|[low, high]| Extent { low, high });
    let sharp = drawing.outlines.iter().filter_map(rectangle).chain(canvas);
    let sharp = sharp.map(|extent| Border { extent, drawn: None });
    let mut all: Vec<Border> = sharp.chain(drawn(drawing)).collect();
    all.sort_by(|a, b| b.extent.size().total_cmp(&a.extent.size()));
    all.truncate(BORDERS);
    all.retain(|frame| {
        let slack = frame.slack();
        let room = if clear { slack } else { -slack };
        let mut others = 0;
        let dots = drawing.dots.iter().filter(|dot| !dot.aside).all(|dot| {
            others += 1;
            frame.extent.holds(dot.at, room)
        });
        let lines = drawing.lines.iter().filter(|line| !line.aside && line.hidden.is_none()).all(|line| {
            let along = frame.has(line);
            let within = !along && line.ends.iter().all(|&p| frame.extent.holds(p, room));
            others += usize::from(within);
            along || within || frame.extent.is_outside(&line.ends, slack)
        });
        dots && lines && others > 0
    });
    all
}

/// The rectangles by their lines: elements of four straight lines, each more than half of a side of the box round them,
/// perhaps with curves between these. O(lines).
fn drawn(drawing: &Drawing) -> impl Iterator<Item = Border> + '_ {
    let of_one = drawing.lines.chunk_by(|a, b| a.shape == b.shape).filter(|lines| lines.len() == 4);
    of_one.filter_map(|lines| {
        let extent = Extent::around(lines.iter().flat_map(|line| line.ends).collect());
        let slack = 1e-6 * extent.size();
        let is_side = |side: [Point; 2]| {
            let is_part = |line: &&Line| {
                line.ends.iter().all(|&p| lies_on(p, side, slack))
                    && distance(line.ends[0], line.ends[1]) > 0.5 * distance(side[0], side[1])
            };
            lines.iter().any(|line| is_part(&line))
        };
        let corners = extent.corners();
        let all = (0..4).all(|i| is_side([corners[i], corners[(i + 1) % 4]]));
        all.then_some(Border { extent, drawn: Some(lines[0].shape) })
    })
}

/// An upright rectangle.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Extent {
    low: Point,
    high: Point,
}

impl Extent {
    pub(super) fn around(points: Vec<Point>) -> Self {
        let [low, high] = corners(points);
        Self { low, high }
    }

    pub(super) fn corners(&self) -> [Point; 4] {
        let (low, high) = (self.low, self.high);
        [low, Point::new(high.x, low.y), high, Point::new(low.x, high.y)]
    }

    pub(super) fn size(&self) -> f64 {
        (self.high.x - self.low.x).max(self.high.y - self.low.y).max(0.0)
    }

    /// Whether a point lies inside, and so far from the border.
    pub(super) fn holds(&self, p: Point, slack: f64) -> bool {
        let (x, y) = ((p.x - self.low.x).min(self.high.x - p.x), (p.y - self.low.y).min(self.high.y - p.y));
        x.min(y) > slack
    }

    /// Whether it reaches as far as another one, but for this part of its size.
    pub(super) fn reaches(&self, other: &Self, part: f64) -> bool {
        let slack = part * other.size();
        [other.low, other.high].iter().all(|&p| self.holds(p, -slack))
    }

    /// Whether it reaches as far as another one, or nearly.
    pub(super) fn covers(&self, [low, high]: [Point; 2]) -> bool {
        let slack = ALONG * (high.x - low.x).max(high.y - low.y);
        self.low.x <= low.x + slack
            && self.low.y <= low.y + slack
            && self.high.x >= high.x - slack
            && self.high.y >= high.y - slack
    }

    /// Whether all points lie beyond one side.
    fn is_outside(&self, points: &[Point], slack: f64) -> bool {
        let all = |beyond: &dyn Fn(Point) -> bool| points.iter().all(|&p| beyond(p));
        all(&|p| p.x < self.low.x + slack)
            || all(&|p| p.x > self.high.x - slack)
            || all(&|p| p.y < self.low.y + slack)
            || all(&|p| p.y > self.high.y - slack)
    }

    /// Whether a line runs along a whole side.
    fn runs_along(&self, ends: [Point; 2], slack: f64) -> bool {
        let corners = self.corners();
        let near = |p: Point, q: Point| distance(p, q) <= 2.0 * slack;
        (0..4).any(|i| {
            let side = [corners[i], corners[(i + 1) % 4]];
            near(ends[0], side[0]) && near(ends[1], side[1]) || near(ends[0], side[1]) && near(ends[1], side[0])
        })
    }

    /// Whether an upright or level line comes from beyond one side and goes beyond the other, as a line of a grid.
    pub(super) fn is_crossed_by(&self, [a, b]: [Point; 2]) -> bool {
        let slack = 1e-3 * self.size();
        let spans = |a: f64, b: f64, low: f64, high: f64| a.min(b) < low - slack && a.max(b) > high + slack;
        let is_level = (a.y - b.y).abs() <= slack && spans(a.x, b.x, self.low.x, self.high.x);
        is_level || (a.x - b.x).abs() <= slack && spans(a.y, b.y, self.low.y, self.high.y)
    }

    /// Whether a line has a point within, or on the border (Liang and Barsky 1984).
    pub(super) fn meets(&self, [a, b]: [Point; 2]) -> bool {
        let (mut from, mut to) = (0.0f64, 1.0f64);
        let sides = [(a.x, b.x - a.x, self.low.x, self.high.x), (a.y, b.y - a.y, self.low.y, self.high.y)];
        for (start, way, low, high) in sides {
            if way == 0.0 {
                if start < low || start > high {
                    return false;
                }
                continue;
            }
            let (s, t) = ((low - start) / way, (high - start) / way);
            (from, to) = (from.max(s.min(t)), to.min(s.max(t)));
        }
        from <= to
    }

    /// Whether a line begins on the border or beyond it and goes away from it, as a tick.
    pub(super) fn is_left_by(&self, ends: [Point; 2]) -> bool {
        let slack = 1e-3 * self.size();
        let far = ends.map(|p| [self.low.x - p.x, p.x - self.high.x, self.low.y - p.y, p.y - self.high.y]);
        (0..4).any(|side| far.iter().all(|far| far[side] >= -slack) && far.iter().any(|far| far[side] > slack))
    }

    /// Whether no point of a line or a dot lies within.
    pub(super) fn is_clear_of(&self, points: &[Point]) -> bool {
        self.is_outside(points, -1e-3 * self.size())
    }
}

/// What a filled area is.
pub(super) enum Area {
    /// One that has to be a face.
    Face,
    /// One round everything.
    Paper,
    /// A letter, an icon, the box of a label.
    Small,
    /// One that lies clear of the structure.
    Beside,
    /// A line, by its ends.
    Bar([Point; 2]),
    /// One with curved sides: no face, and no fault.
    Curved,
}

/// What the area of an outline is whose corners lie here.
pub(super) fn kind(outline: &Outline, corners: &[Point], snap: &Snap, around: &Extent, size: f64) -> Area {
    if let Some(ends) = bar(corners, snap, size).filter(|_| !outline.curved) {
        return Area::Bar(ends);
    }
    if !corners.iter().any(|&p| snap.is_known(p)) {
        let own = Extent::around(corners.to_vec());
        let slack = 1e-3 * size;
        if own.holds(around.low, -slack) && own.holds(around.high, -slack) && holds_all(corners, around, slack) {
            return Area::Paper;
        }
        let is_clear = around.is_clear_of(corners);
        if distance(own.low, own.high) <= SMALL * size || is_clear && (outline.aside || outline.curved) {
            return Area::Small;
        }
        if is_clear {
            return Area::Beside;
        }
    }
    if outline.curved { Area::Curved } else { Area::Face }
}

/// Whether the corners of a box lie inside a polygon, or so little outside.
fn holds_all(polygon: &[Point], inner: &Extent, slack: f64) -> bool {
    let area = super::painting::Area::new(&[polygon.to_vec()], true);
    let (low, high) = (inner.low, inner.high);
    let within =
        Extent { low: Point::new(low.x + slack, low.y + slack), high: Point::new(high.x - slack, high.y - slack) };
    within.corners().iter().all(|&p| area.covers(p).0)
}

/// The ends of the line that a thin rectangle stands for: the middles of its short sides, or as far within as a
/// square cap reaches, if both are known points.
fn bar(corners: &[Point], snap: &Snap, size: f64) -> Option<[Point; 2]> {
    let (ends, width) = thin(corners, size)?;
    let length = distance(ends[0], ends[1]);
    let within = |cap: f64| {
        let [a, b] = ends;
        let t = cap / length;
        let towards = |p: Point, q: Point| Point::new(p.x + t * (q.x - p.x), p.y + t * (q.y - p.y));
        [towards(a, b), towards(b, a)]
    };
    [within(0.0), within(0.5 * width)].into_iter().find(|ends| ends.iter().all(|&p| snap.is_known(p)))
}

/// The middles of the short sides of a thin rectangle, and its width.
pub(super) fn thin(corners: &[Point], size: f64) -> Option<([Point; 2], f64)> {
    let closed = corners.len() == 5 && corners[0] == corners[4];
    let &[a, b, c, d] = corners.get(..if closed { 4 } else { corners.len() })? else { return None };
    let of = |[a, b, c, d]: [Point; 4]| {
        let width = distance(a, b);
        // The long sides are parallel, the corners right angles.
        let (x, y) = (b.x - a.x, b.y - a.y);
        let square = (x * (d.x - a.x) + y * (d.y - a.y)).abs() <= 0.02 * width * distance(a, d);
        let even = distance(middle([a, c]), middle([b, d])) <= 0.05 * width;
        let ends = [middle([a, b]), middle([c, d])];
        let is_thin = width > 0.0 && width <= THIN * size && distance(ends[0], ends[1]) >= LONG * width;
        (is_thin && square && even).then_some((ends, width))
    };
    of([a, b, c, d]).or_else(|| of([b, c, d, a]))
}
