//! What was found: the verdict, the layer that decided, and the differences in a stable order.
//!
//! ```text
//!   differs in its drawn geometry: 2 differences
//!     1. edge v5-v6 between (0, 150) and (250, -150) is missing
//!     2. vertex v7 at (3, 4) is 3 units away: yours lies at (6, 4)
//!   note: 6 lines are drawn twice
//! ```

use super::pairing::distance;
use crate::figure::canvas::number::model;
use crate::ids::{Element, HalfEdgeId};
use crate::plane::Point;

/// So many of a kind are told in one sentence.
pub(super) const GROUP: usize = 4;

crate::named! {
    /// What a layer of the comparison looks at.
    #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
    #[non_exhaustive]
    pub enum Layer {
        /// Both files hold the same bytes.
        Bytes = "bytes",
        /// The tables that the files declare in `data-*` attributes.
        Declared = "declared",
        /// The lines, dots and filled polygons that the files draw.
        Drawn = "drawn",
        /// How the lines hang together, where no point lies where it should.
        Shape = "shape",
    }

    /// Its name as one word.
    fn word;
}

impl Layer {
    /// Its name in a sentence.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Bytes => "bytes",
            Self::Declared => "declared structure",
            Self::Drawn => "drawn geometry",
            Self::Shape => "shape",
        }
    }
}

crate::named! {
    /// What a difference is about; the order of the kinds is the order of the list.
    #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
    #[non_exhaustive]
    pub enum Kind {
        /// The drawing as a whole.
        Drawing = "drawing",
        /// A vertex.
        Vertex = "vertex",
        /// An edge.
        Edge = "edge",
        /// A half-edge.
        HalfEdge = "half-edge",
        /// A face.
        Face = "face",
    }

    /// Its name.
    fn word;
}

/// One difference.
#[derive(Clone, PartialEq, Debug)]
pub struct Difference {
    /// What it is about.
    pub kind: Kind,
    /// The layer that found it.
    pub layer: Layer,
    /// The sentence, with names, places, and what was expected.
    pub text: String,
    /// What to draw of it.
    pub(super) spot: Spot,
}

impl Difference {
    pub(super) fn new(kind: Kind, layer: Layer, text: String, spot: Spot) -> Self {
        Self { kind, layer, text, spot }
    }

    /// Whether `other` tells the same thing, perhaps in other words.
    pub(super) fn says(&self, other: &Self) -> bool {
        let apart = [(self.spot == Spot::Nowhere), (other.spot == Spot::Nowhere)];
        self.text == other.text || (self.kind == other.kind && apart == [false; 2] && self.spot.is_near(&other.spot))
    }
}

/// Where a difference is, in the coordinates of the reference.
#[derive(Clone, PartialEq, Debug)]
pub(super) enum Spot {
    Nowhere,
    /// A place at which nothing is marked but the number.
    At(Point),
    /// The same, on the left of the middle of this way.
    Beside([Point; 2]),
    MissingVertex(Point),
    ExtraVertex(Point),
    Moved(Point, Point),
    MissingEdge([Point; 2]),
    ExtraEdge([Point; 2]),
    /// A pointer of a half-edge of the reference, and where it should and does lead, in its ids.
    Pointer {
        half_edge: HalfEdgeId,
        pointer: Slot,
        found: Option<Element>,
    },
    /// A face by its outline.
    Face(Vec<Point>),
    /// A filled polygon that is no face.
    ExtraFace(Vec<Point>),
    /// Several at once.
    Many(Vec<Spot>),
}

impl Spot {
    /// One or several.
    pub(super) fn all(mut spots: Vec<Self>) -> Self {
        if spots.len() == 1 { spots.remove(0) } else { Self::Many(spots) }
    }

    /// The spots of which this one is made.
    pub(super) fn each(&self) -> &[Self] {
        match self {
            Self::Many(spots) => spots,
            one => std::slice::from_ref(one),
        }
    }

    /// Whether both mark the same place; what the student has lies where a map has brought it, only nearly the same.
    fn is_near(&self, other: &Self) -> bool {
        let near = |a: Point, b: Point| distance(a, b) <= 1e-3 * (1.0 + a.x.abs() + a.y.abs());
        match (self, other) {
            (Self::ExtraVertex(a), Self::ExtraVertex(b)) => near(*a, *b),
            (Self::Moved(a, b), Self::Moved(c, d)) => a == c && near(*b, *d),
            (Self::ExtraEdge([a, b]), Self::ExtraEdge([c, d])) => {
                near(*a, *c) && near(*b, *d) || near(*a, *d) && near(*b, *c)
            }
            // Several things may be told of one place.
            (Self::At(_) | Self::Beside(_), _) => false,
            _ => self == other,
        }
    }
}

/// A pointer of a half-edge.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Slot {
    Twin,
    Next,
    Prev,
    Face,
    Whole,
}

/// How places and lengths are written: rounded to what the tolerance can tell apart.
#[derive(Clone, Copy, Debug)]
pub(super) struct Writing {
    /// Powers of ten that a coordinate is multiplied by before it is rounded.
    grain: f64,
    /// Whether y is written as it stands in a file with y down.
    pub(super) down: bool,
}

impl Writing {
    pub(super) fn new(tolerance: f64, down: bool) -> Self {
        let mut grain = 1.0;
        while grain < 1e12 && grain * tolerance < 1.0 {
            grain *= 10.0;
        }
        Self { grain, down }
    }

    pub(super) fn number(self, x: f64) -> String {
        let rounded = (x * self.grain).round() / self.grain;
        model(if rounded.is_finite() { rounded } else { x })
    }

    /// `(3, -4.5)`.
    pub(super) fn point(self, p: Point) -> String {
        format!("({}, {})", self.number(p.x), self.number(if self.down { -p.y } else { p.y }))
    }

    /// `(0, 0) and (3, 0)`.
    pub(super) fn between(self, ends: [Point; 2]) -> String {
        format!("{} and {}", self.point(ends[0]), self.point(ends[1]))
    }

    /// `(0, 0), (3, 0), (3, 2), ...`, at most six points.
    pub(super) fn along(self, points: &[Point]) -> String {
        let words: Vec<String> = points.iter().take(6).map(|&p| self.point(p)).collect();
        let rest = if points.len() > 6 { format!(", … ({} points)", points.len()) } else { String::new() };
        format!("{}{rest}", words.join(", "))
    }

    /// A distance with two significant digits or so: `3 units`.
    pub(super) fn distance(self, length: f64) -> String {
        let mut grain = self.grain;
        while grain > 10.0 && length * grain > 1000.0 {
            grain /= 10.0;
        }
        let unit = if self.down { "px" } else { "units" };
        format!("{} {unit}", model((length * grain).round() / grain))
    }
}

/// So many are named in one sentence.
const NAMED: usize = 4;

/// `a, b, c, d, …`: the first few.
pub(super) fn listed(words: &[String]) -> String {
    let rest = if words.len() > NAMED { ", …" } else { "" };
    format!("{}{rest}", words[..words.len().min(NAMED)].join(", "))
}

/// `1 line is`, `3 lines are`.
pub(super) fn counted(count: usize, one: &str, many: &str) -> String {
    if count == 1 { format!("1 {one}") } else { format!("{count} {many}") }
}
