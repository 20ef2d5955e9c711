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

use crate::figure::Unit;
use crate::figure::canvas::vector::Xy;

/// A whole drawing.
#[derive(Clone, Debug, Default)]
pub(crate) struct Scene {
    pub(crate) size: Xy,
    /// In which the file states the size.
    pub(crate) unit: Unit,
    /// Whether elements carry their style themselves.
    pub(crate) plain: bool,
    /// What ids and style rules begin with.
    pub(crate) prefix: String,
    pub(crate) title: String,
    pub(crate) description: String,
    /// Further attributes of the root.
    pub(crate) attributes: Attributes,
    pub(crate) css: String,
    pub(crate) hatches: Vec<Hatch>,
    pub(crate) nodes: Vec<Node>,
}

pub(crate) type Attributes = Vec<(&'static str, String)>;

/// A pattern of parallel lines.
#[derive(Clone, Debug)]
pub(crate) struct Hatch {
    pub(crate) name: &'static str,
    pub(crate) step: f64,
    /// The direction of the lines in degrees from the vertical.
    pub(crate) degrees: i32,
}

#[derive(Clone, Debug)]
pub(crate) enum Node {
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
pub(crate) enum Step {
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

impl Step {
    /// Where it ends.
    pub(crate) const fn end(&self) -> Xy {
        match *self {
            Self::Line(to) | Self::Quad(_, to) | Self::Cubic(_, _, to) | Self::Round { to, .. } => to,
        }
    }
}

/// What belongs together, with an id and a tooltip.
#[derive(Clone, Debug, Default)]
pub(crate) struct Group {
    pub(crate) class: &'static str,
    /// A further class: how the group is marked. Empty: not at all.
    pub(crate) mark: &'static str,
    /// The id that a click leads to, without the prefix of the scene.
    pub(crate) link: Option<String>,
    /// How far everything inside is moved.
    pub(crate) shift: Option<Xy>,
    /// Nothing outside of a box of this size is seen. Not together with a shift.
    pub(crate) window: Option<Xy>,
    /// Without the prefix of the scene.
    pub(crate) id: Option<String>,
    pub(crate) attributes: Attributes,
    pub(crate) title: Option<String>,
    pub(crate) nodes: Vec<Node>,
}

/// Many polylines in one flat array of tenths of a px: 8 bytes a point.
#[derive(Clone, Debug, Default)]
pub(crate) struct Polylines {
    points: Vec<[i32; 2]>,
    starts: Vec<u32>,
    /// Whether each ends where it began.
    pub(crate) closed: bool,
}

impl Polylines {
    pub(crate) fn new(closed: bool) -> Self {
        Self { closed, ..Self::default() }
    }

    pub(crate) fn start(&mut self, p: [i32; 2]) {
        self.starts.push(self.points.len() as u32);
        self.points.push(p);
    }

    /// Goes on to `p`. A step that is shorter than the grid is left out.
    pub(crate) fn line_to(&mut self, p: [i32; 2]) {
        if self.points.last() != Some(&p) {
            self.points.push(p);
        }
    }

    pub(crate) fn point_count(&self) -> usize {
        self.points.len()
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.points.is_empty()
    }

    pub(crate) fn iter(&self) -> impl Iterator<Item = &[[i32; 2]]> {
        let ends = self.starts.iter().skip(1).map(|&e| e as usize).chain([self.points.len()]);
        self.starts.iter().zip(ends).map(|(&start, end)| &self.points[start as usize..end])
    }
}

/// The nearest point of the grid of tenths. Points very far away come nearer, so that steps have no overflow.
pub(crate) fn tenths(p: Xy) -> [i32; 2] {
    [p.x, p.y].map(|x| (x * 10.0).round().clamp(-1e9, 1e9) as i32)
}
