//! A drawing as data: groups and shapes in the order in which they are painted, with classes, not colours.
//!
//! ```text
//!   Scene ── Group "f"  ── Area "face t0", Text "fl"
//!         ── Group "edges" ── Line, Line, ...
//!         ── Group "he" ── Line "sh", Area "barb", Text "hl"
//!         ── Group "v"  ── Disc "vd", Text "vl"
//! ```
//!
//! Nothing here knows SVG (`svg_out.rs` does), and nothing here knows half-edges.

use super::Unit;
use super::vector::Xy;

/// A whole drawing.
#[derive(Clone, Debug, Default)]
pub(super) struct Scene {
    pub(super) size: Xy,
    /// In which the file states the size.
    pub(super) unit: Unit,
    /// Whether elements carry their style themselves.
    pub(super) plain: bool,
    /// What ids and style rules begin with.
    pub(super) prefix: String,
    pub(super) title: String,
    pub(super) description: String,
    /// Further attributes of the root.
    pub(super) attributes: Attributes,
    pub(super) css: String,
    pub(super) hatches: Vec<Hatch>,
    pub(super) nodes: Vec<Node>,
}

pub(super) type Attributes = Vec<(&'static str, String)>;

/// A pattern of parallel lines.
#[derive(Clone, Debug)]
pub(super) struct Hatch {
    pub(super) name: &'static str,
    pub(super) step: f64,
    /// The direction of the lines in degrees from the vertical.
    pub(super) degrees: i32,
}

#[derive(Clone, Debug)]
pub(super) enum Node {
    Group(Group),
    /// A straight line.
    Line {
        class: &'static str,
        from: Xy,
        to: Xy,
    },
    /// A line of straight and curved steps.
    Curve {
        class: &'static str,
        start: Xy,
        steps: Vec<Step>,
    },
    /// The inside of closed outlines by the even-odd rule, plain or hatched.
    Area {
        class: &'static str,
        hatch: Option<&'static str>,
        outlines: Vec<Vec<Xy>>,
    },
    Disc {
        class: &'static str,
        centre: Xy,
        radius: f64,
    },
    /// A line of text, centred at `at` unless the class says where it begins.
    Text {
        class: &'static str,
        at: Xy,
        size: f64,
        text: String,
    },
    /// Many lines, or the inside of many outlines, in tenths of a px.
    Fine {
        class: &'static str,
        hatch: Option<&'static str>,
        lines: Polylines,
    },
}

/// A step of a curve.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) enum Step {
    Line(Xy),
    /// By a control point.
    Quad(Xy, Xy),
    /// By two control points.
    Cubic(Xy, Xy, Xy),
    /// Clockwise on a circle.
    Round {
        radius: f64,
        /// Whether by more than half of the circle.
        large: bool,
        to: Xy,
    },
}

/// What belongs together, with an id and a tooltip.
#[derive(Clone, Debug, Default)]
pub(super) struct Group {
    pub(super) class: &'static str,
    /// A further class: how the group is marked. Empty: not at all.
    pub(super) mark: &'static str,
    /// The id that a click leads to, without the prefix of the scene.
    pub(super) link: Option<String>,
    /// How far everything inside is moved.
    pub(super) shift: Option<Xy>,
    /// Nothing outside of a box of this size is seen. Not together with a shift.
    pub(super) window: Option<Xy>,
    /// Without the prefix of the scene.
    pub(super) id: Option<String>,
    pub(super) attributes: Attributes,
    pub(super) title: Option<String>,
    pub(super) nodes: Vec<Node>,
}

/// Many polylines in one flat array of tenths of a px: 8 bytes a point.
#[derive(Clone, Debug, Default)]
pub(super) struct Polylines {
    points: Vec<[i32; 2]>,
    starts: Vec<u32>,
    /// Whether each ends where it began.
    pub(super) closed: bool,
}

impl Polylines {
    pub(super) fn new(closed: bool) -> Self {
        Self { closed, ..Self::default() }
    }

    pub(super) fn start(&mut self, p: [i32; 2]) {
        self.starts.push(self.points.len() as u32);
        self.points.push(p);
    }

    /// Goes on to `p`. A step that is shorter than the grid is left out.
    pub(super) fn line_to(&mut self, p: [i32; 2]) {
        if self.points.last() != Some(&p) {
            self.points.push(p);
        }
    }

    pub(super) fn point_count(&self) -> usize {
        self.points.len()
    }

    pub(super) fn is_empty(&self) -> bool {
        self.points.is_empty()
    }

    pub(super) fn iter(&self) -> impl Iterator<Item = &[[i32; 2]]> {
        let ends = self.starts.iter().skip(1).map(|&e| e as usize).chain([self.points.len()]);
        self.starts.iter().zip(ends).map(|(&start, end)| &self.points[start as usize..end])
    }
}

/// The nearest point of the grid of tenths. Points very far away come nearer, so that steps have no overflow.
pub(super) fn tenths(p: Xy) -> [i32; 2] {
    [p.x, p.y].map(|x| (x * 10.0).round().clamp(-1e9, 1e9) as i32)
}
