//! Marks of points, told apart by their shape.
//!
//! ```text
//!   •  Dot    ●  Disc   ○  Ring   ■  Square   ▲  Triangle   ◆  Diamond   ★  Star   ✕  Cross   ✓  Tick
//! ```

use crate::figure::canvas::scene::{Node, Step};
use crate::figure::canvas::vector::{Xy, xy};

/// The shape of a mark.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
#[non_exhaustive]
pub enum Glyph {
    /// A small disc.
    Dot,
    /// A disc.
    Disc,
    /// A circle.
    Ring,
    /// A square.
    Square,
    /// A triangle that points up.
    Triangle,
    /// A square on its corner.
    Diamond,
    /// A star with five points.
    Star,
    /// A cross.
    Cross,
    /// A tick on a disc.
    Tick,
}

/// Sine and cosine of 36° and of 72°, for the star.
const FIFTH: [(f64, f64); 2] = [(0.587_785_252, 0.809_016_994), (0.951_056_516, 0.309_016_994)];

impl Glyph {
    /// How far it reaches from its middle, in px.
    pub(in crate::figure) const fn radius(self) -> f64 {
        match self {
            Self::Dot => 3.2,
            Self::Ring => 3.6,
            Self::Disc | Self::Square | Self::Cross => 5.0,
            Self::Triangle | Self::Diamond => 6.2,
            Self::Tick => 6.5,
            Self::Star => 7.5,
        }
    }

    /// Its shapes, painted in the colour of the role of their group.
    pub(in crate::figure) fn nodes(self, at: Xy) -> Vec<Node> {
        let r = self.radius();
        let disc = |class: &'static str, radius: f64| Node::Disc { class, centre: at, radius };
        let area = |corners: &[(f64, f64)]| {
            let outline = corners.iter().map(|&(x, y)| at + xy(x, y) * r).collect();
            Node::Area { class: "gl", hatch: None, outlines: vec![outline] }
        };
        match self {
            Self::Dot | Self::Disc => vec![disc("gl", r)],
            Self::Ring => vec![disc("go", r)],
            Self::Square => vec![area(&[(-0.9, -0.9), (0.9, -0.9), (0.9, 0.9), (-0.9, 0.9)])],
            Self::Triangle => vec![area(&[(0.0, -1.0), (0.9, 0.65), (-0.9, 0.65)])],
            Self::Diamond => vec![area(&[(0.0, -1.0), (1.0, 0.0), (0.0, 1.0), (-1.0, 0.0)])],
            Self::Star => vec![area(&star())],
            Self::Cross => [(1.0, 1.0), (1.0, -1.0)]
                .into_iter()
                .map(|(x, y)| xy(0.75 * x * r, 0.75 * y * r))
                .map(|reach| Node::Line { class: "gs", from: at - reach, to: at + reach })
                .collect(),
            Self::Tick => {
                let [a, b, c] = [(-0.5, 0.0), (-0.12, 0.4), (0.5, -0.4)].map(|(x, y)| at + xy(x, y) * r);
                vec![disc("gl", r), Node::Curve { class: "gt", start: a, steps: vec![Step::Line(b), Step::Line(c)] }]
            }
        }
    }
}

/// Five points outside, five inside, from the top on.
fn star() -> [(f64, f64); 10] {
    let [(s1, c1), (s2, c2)] = FIFTH;
    let inner = 0.42;
    [
        (0.0, -1.0),
        (inner * s1, -inner * c1),
        (s2, -c2),
        (inner * s2, inner * c2),
        (s1, c1),
        (0.0, inner),
        (-s1, c1),
        (-inner * s2, inner * c2),
        (-s2, -c2),
        (-inner * s1, -inner * c1),
    ]
}
