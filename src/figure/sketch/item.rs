//! One thing of a sketch, and what can be said about it.

use super::round::{Piece, Round};
use super::{Glyph, Role};
use crate::figure::canvas::text;
use crate::figure::canvas::vector::xy;
use crate::plane::Point;
use crate::plane::predicates::orientation;
use std::cmp::Ordering;

/// What is drawn.
#[derive(Clone, PartialEq, Debug)]
pub(super) enum Kind {
    Region(Vec<Vec<Point>>),
    Path(Vec<Point>),
    Ray([Point; 2]),
    Line([Point; 2]),
    Circle {
        centre: Point,
        radius: f64,
        /// Whether it counts for the size of the picture.
        fits: bool,
    },
    /// Centre, first point, direction of the last.
    Arc([Point; 3]),
    Cone {
        /// Apex, a point of the right ray, one of the left.
        corners: [Point; 3],
        end: Option<[Point; 2]>,
    },
    Point(Point, Glyph),
    /// Left and right.
    Portal([Point; 2]),
    Text(Point),
    Badge(Point),
}

/// What ids call the kinds, by their numbers.
const WORDS: [&str; Kind::COUNT] =
    ["region", "path", "ray", "line", "circle", "arc", "cone", "point", "portal", "text", "badge"];

impl Kind {
    /// How many kinds there are.
    pub(super) const COUNT: usize = 11;

    /// The number of the kind.
    pub(super) const fn number(&self) -> usize {
        match self {
            Self::Region(_) => 0,
            Self::Path(_) => 1,
            Self::Ray(_) => 2,
            Self::Line(_) => 3,
            Self::Circle { .. } => 4,
            Self::Arc(_) => 5,
            Self::Cone { .. } => 6,
            Self::Point(..) => 7,
            Self::Portal(_) => 8,
            Self::Text(_) => 9,
            Self::Badge(_) => 10,
        }
    }

    /// What ids call it.
    pub(super) const fn word(&self) -> &'static str {
        WORDS[self.number()]
    }

    /// The circle through three points; a radius of 0 where there is none.
    pub(super) fn round_through([a, b, c]: [Point; 3]) -> Self {
        let (p, q) = ([b.x - a.x, b.y - a.y], [c.x - a.x, c.y - a.y]);
        let size = p.iter().chain(&q).fold(0.0f64, |size, x| size.max(x.abs()));
        let (p, q) = (p.map(|x| x / size), q.map(|x| x / size));
        let doubled = 2.0 * (p[0] * q[1] - p[1] * q[0]);
        let (pp, qq) = (p[0] * p[0] + p[1] * p[1], q[0] * q[0] + q[1] * q[1]);
        let centre = [(q[1] * pp - p[1] * qq) / doubled, (p[0] * qq - q[0] * pp) / doubled];
        let radius = (centre[0] * centre[0] + centre[1] * centre[1]).sqrt() * size;
        let is_flat = orientation(a, b, c) == Ordering::Equal || !radius.is_finite();
        if is_flat && [a, b, c].iter().all(|p| p.x.is_finite() && p.y.is_finite()) {
            return Self::Circle { centre: a, radius: 0.0, fits: false };
        }
        Self::Circle { centre: Point::new(a.x + centre[0] * size, a.y + centre[1] * size), radius, fits: false }
    }

    /// Every point that must be a number.
    pub(super) fn points(&self) -> Vec<Point> {
        match self {
            Self::Region(rings) => rings.iter().flatten().copied().collect(),
            Self::Path(points) => points.clone(),
            Self::Ray(ends) | Self::Line(ends) | Self::Portal(ends) => ends.to_vec(),
            Self::Circle { centre, radius, .. } => vec![*centre, Point::new(*radius, 0.0)],
            Self::Arc(points) => points.to_vec(),
            Self::Cone { corners, end } => corners.iter().chain(end.iter().flatten()).copied().collect(),
            Self::Point(at, _) | Self::Text(at) | Self::Badge(at) => vec![*at],
        }
    }

    /// The points that the picture must hold.
    pub(super) fn extent(&self) -> Vec<Point> {
        let around = |c: Point, r: f64| vec![Point::new(c.x - r, c.y - r), Point::new(c.x + r, c.y + r)];
        match self {
            Self::Circle { centre, radius, fits: true } => around(*centre, radius.abs()),
            Self::Circle { .. } => Vec::new(),
            Self::Arc([centre, from, to]) => {
                // On the canvas y points down.
                let way = |p: &Point| xy(p.x - centre.x, centre.y - p.y);
                let radius = way(from).length();
                let Some((from, to)) = way(from).unit().zip(way(to).unit()) else { return self.points() };
                let points = Round { centre: xy(0.0, 0.0), radius }.points(Piece { from, to });
                points.into_iter().map(|p| Point::new(centre.x + p.x, centre.y - p.y)).collect()
            }
            other => other.points(),
        }
    }
}

/// How a line is broken.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Dash {
    /// As the role says.
    Role,
    Solid,
    Dashed,
    /// As the edges of structures are.
    #[cfg(feature = "solid")]
    Edge,
}

/// Which ends of a path have arrow heads.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Heads {
    None,
    Last,
    Both,
}

/// One thing of a sketch. What a method says about things of another kind changes nothing.
#[derive(Clone, PartialEq, Debug)]
pub struct Item {
    pub(super) kind: Kind,
    pub(super) role: Role,
    pub(super) name: String,
    pub(super) title: Option<String>,
    pub(super) label: Option<String>,
    pub(super) key: Option<String>,
    pub(super) dash: Dash,
    pub(super) heads: Heads,
    pub(super) filled: bool,
    pub(super) outlined: bool,
    pub(super) hatched: bool,
}

impl Item {
    pub(super) fn new(role: Role, kind: Kind, number: usize) -> Self {
        let name = format!("{}-{number}", kind.word());
        Self {
            kind,
            role,
            name,
            title: None,
            label: None,
            key: None,
            dash: Dash::Role,
            heads: Heads::None,
            filled: false,
            outlined: true,
            hatched: false,
        }
    }

    /// What it is for.
    #[must_use]
    pub fn role(&self) -> Role {
        self.role
    }

    /// What stands in its id after the prefix of the figure and `s-`: `path-1`, `badge-2`.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// What screen readers and tooltips say. Default: the label, what the legend says, or the kind of thing.
    pub fn title(&mut self, words: impl AsRef<str>) -> &mut Self {
        self.title = Some(text::clean(words.as_ref()));
        self
    }

    /// Words beside it, or inside a region.
    pub fn label(&mut self, words: impl AsRef<str>) -> &mut Self {
        self.label = Some(text::clean(words.as_ref()));
        self
    }

    /// A line of the legend with a sample of it. Equal lines of one role stand there once.
    pub fn key(&mut self, words: impl AsRef<str>) -> &mut Self {
        self.key = Some(text::clean(words.as_ref()));
        self
    }

    /// An unbroken line, whatever the role.
    pub fn solid(&mut self) -> &mut Self {
        self.dash = Dash::Solid;
        self
    }

    /// A dashed line, whatever the role.
    pub fn dashed(&mut self) -> &mut Self {
        self.dash = Dash::Dashed;
        self
    }

    /// An arrow head at the end of a path.
    pub fn arrow(&mut self) -> &mut Self {
        self.heads = Heads::Last;
        self
    }

    /// Arrow heads at both ends of a path.
    pub fn double_arrow(&mut self) -> &mut Self {
        self.heads = Heads::Both;
        self
    }

    /// A circle with a tint inside.
    pub fn filled(&mut self) -> &mut Self {
        self.filled = true;
        self
    }

    /// A line that looks like an edge of a structure.
    #[cfg(feature = "solid")]
    pub(in crate::figure) fn as_edge(&mut self) -> &mut Self {
        self.dash = Dash::Edge;
        self
    }

    /// A region or a cone without a line round it.
    pub fn plain(&mut self) -> &mut Self {
        self.outlined = false;
        self
    }

    /// A region with the hatch of hole faces instead of a tint: blocked, not part of the domain.
    pub fn hatched(&mut self) -> &mut Self {
        self.hatched = true;
        self
    }

    /// Another mark of a point than that of its role.
    pub fn glyph(&mut self, glyph: Glyph) -> &mut Self {
        if let Kind::Point(_, mark) = &mut self.kind {
            *mark = glyph;
        }
        self
    }

    /// Where a cone ends: at the line through two points. Only cones of less than 180° have an end.
    pub fn until(&mut self, p: impl Into<Point>, q: impl Into<Point>) -> &mut Self {
        if let Kind::Cone { end, .. } = &mut self.kind {
            *end = Some([p.into(), q.into()]);
        }
        self
    }

    /// What is said about it.
    pub(super) fn words(&self) -> &str {
        [&self.title, &self.label, &self.key].into_iter().flatten().next().map_or(self.kind.word(), String::as_str)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_circle_through_three_points() {
        let through = |points: [[f64; 2]; 3]| match Kind::round_through(points.map(Into::into)) {
            Kind::Circle { centre, radius, .. } => (centre, radius),
            other => panic!("{other:?}"),
        };
        let (centre, radius) = through([[8.0, 1.0], [4.0, 5.0], [0.0, 1.0]]);
        assert!((centre.x - 4.0).abs() < 1e-12 && (centre.y - 1.0).abs() < 1e-12 && (radius - 4.0).abs() < 1e-12);
        let (centre, radius) = through([[1e9, 1e9], [1e9 + 2.0, 1e9], [1e9, 1e9 + 2.0]]);
        assert!((centre.x - 1e9 - 1.0).abs() < 1e-6 && (radius - 2f64.sqrt()).abs() < 1e-6);
        for flat in [[[0.0, 0.0], [1.0, 1.0], [3.0, 3.0]], [[2.0, 2.0]; 3]] {
            assert_eq!(through(flat).1.to_bits(), 0, "{flat:?}");
        }
    }
}
