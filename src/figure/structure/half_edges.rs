//! Half-edges as shafts beside their edges, with a one-sided barb that points to the face.
//!
//! ```text
//!            face of h, on the left of travel
//!                                       \.
//!        tail ───────────── shaft ───────▸ tip       ↕ offset
//!   (A)───┼──────────── edge ────────────┼───(B)
//!         c0                             c1
//! ```
//!
//! The shaft lies at `offset` = min(7.5, 0.14 L) to the left of the edge of length L. It is shorter than the
//! edge by c0 and c1, so that a tip and the tail of the next shaft never touch. At a corner of angle θ < 180°
//!
//! `c = min(max(r + 4.5, offset / tan(θ/2) + leg), 0.40 L)`, `leg = min(clamp(6.5 / sin(θ/2), 11, 22), 0.16 L)`,
//!
//! else `c = min(r + 4.5, 0.40 L)`, where r is the radius of the vertex disc. In a narrow corner, and in a
//! narrow face, the offset shrinks so that the shaft stays inside its face.

use crate::figure::Style;
use crate::figure::canvas::vector::Xy;
use crate::figure::layout::crowd::{Crowd, Shape};
use crate::figure::structure::skeleton::{Skeleton, half_edges, mutual_twin};
use crate::ids::{HalfEdgeId, HalfEdgeMap, VertexMap};
use crate::plane::PlanarView;

/// No shaft comes closer to its edge than this, however narrow the face.
const CLOSEST: f64 = 1.6;
/// A shaft closer to its edge than this has half the width.
const THIN: f64 = 3.2;
/// Free space between a vertex disc and a shaft.
const GAP: f64 = 4.5;

/// The drawn form of a half-edge.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Shaft {
    pub(crate) tail: Xy,
    pub(crate) tip: Xy,
    /// Direction of travel; its left is the side of the face.
    pub(crate) along: Xy,
    /// Middle of the edge, moved to the shaft.
    pub(crate) middle: Xy,
    /// Length of the edge.
    pub(crate) edge_length: f64,
    /// Distance from the edge.
    pub(crate) offset: f64,
    barb: f64,
}

impl Shaft {
    /// Whether it is so close to its edge that the line must be thin.
    pub(crate) fn is_thin(&self) -> bool {
        self.offset < THIN
    }

    /// The point beside `t` of the edge, on the line of the shaft.
    pub(crate) fn at(&self, t: f64) -> Xy {
        self.middle + self.along * ((t - 0.5) * self.edge_length)
    }

    pub(crate) fn length(&self) -> f64 {
        (self.tip - self.tail).length()
    }

    /// The line, which ends half a barb before the tip so that the barb stays sharp.
    pub(crate) fn line(&self) -> (Xy, Xy) {
        (self.tail, self.tip - self.along * (0.5 * self.barb))
    }

    /// The triangle on the face side: the tip, the outer corner, the notch.
    pub(crate) fn barb(&self) -> [Xy; 3] {
        let corner = |back: f64, out: f64| self.tip - self.along * (back * self.barb) + self.along.left() * out;
        [corner(0.0, -1.0), corner(1.0, 0.5 * self.barb + 1.0), corner(0.72, -1.0)]
    }

    /// What it covers.
    pub(crate) fn shapes(&self, style: &Style) -> [Shape; 2] {
        let (from, _) = self.line();
        let [tip, corner, _] = self.barb();
        [Shape::Segment(from, self.tip, 0.5 * style.shaft_width), Shape::Segment(tip, corner, 0.5)]
    }
}

/// A corner of a face by the cosine of its angle and by tan(θ/2) and sin(θ/2), if the angle is below 180°.
struct Corner {
    half: Option<(f64, f64)>,
}

impl Corner {
    /// The corner between a half-edge that arrives with direction `inward` and one that leaves with `outward`.
    fn new(inward: Xy, outward: Xy) -> Self {
        let back = inward * -1.0;
        let (sine, cosine) = (outward.turn(back), outward.dot(back));
        let half = (sine > 1e-9).then(|| (sine / (1.0 + cosine), ((1.0 - cosine) / 2.0).max(0.0).sqrt()));
        Self { half }
    }

    /// How much shorter the shaft is here.
    fn cut(&self, offset: f64, radius: f64, length: f64) -> f64 {
        let disc = radius + GAP;
        let cut = self.half.map_or(disc, |(tangent, sine)| {
            let leg = (6.5 / sine).clamp(11.0, 22.0).min(0.16 * length);
            disc.max(offset / tangent + leg)
        });
        cut.min(0.40 * length)
    }

    /// The offset at which a shaft that begins 0.40 L from the corner is still inside the face.
    fn room(&self, length: f64) -> f64 {
        self.half.map_or(f64::INFINITY, |(tangent, _)| 0.75 * 0.40 * length * tangent)
    }
}

/// The shafts of all half-edges that can be drawn. `edges` holds the edges, tagged with the smaller
/// half-edge. O(half-edges), if edges do not crowd.
pub(crate) fn shafts<V: PlanarView + ?Sized>(
    view: &V,
    skeleton: &Skeleton,
    radii: &VertexMap<f64>,
    edges: &Crowd,
    style: &Style,
) -> HalfEdgeMap<Option<Shaft>> {
    let mut out = HalfEdgeMap::filled(view.half_edge_bound(), None);
    for h in half_edges(view) {
        out[h] = shaft(view, skeleton, radii, edges, style, h);
    }
    out
}

fn shaft<V: PlanarView + ?Sized>(
    view: &V,
    skeleton: &Skeleton,
    radii: &VertexMap<f64>,
    edges: &Crowd,
    style: &Style,
    h: HalfEdgeId,
) -> Option<Shaft> {
    let [origin, destination] = skeleton.ends(h)?;
    let (a, b) = skeleton.segment(h)?;
    let along = (b - a).unit()?;
    let length = (b - a).length();
    let direction = |g: HalfEdgeId| skeleton.segment(g).and_then(|(a, b)| (b - a).unit());
    let before = view.prev(h).filter(|&p| skeleton.ends(p).is_some_and(|ends| ends[1] == origin)).and_then(direction);
    let after =
        view.next(h).filter(|&n| skeleton.ends(n).is_some_and(|ends| ends[0] == destination)).and_then(direction);
    let corners = [
        before.map_or(Corner { half: None }, |inward| Corner::new(inward, along)),
        after.map_or(Corner { half: None }, |outward| Corner::new(along, outward)),
    ];

    let usual = style.offset.min(0.14 * length);
    let own = mutual_twin(view, h).map_or(h, |t| h.min(t)).number();
    let reach = along.left() * (2.5 * usual);
    let open = [0.4, 0.5, 0.6].into_iter().fold(1.0f64, |open, t| {
        let from = a + (b - a) * t;
        open.min(edges.free_part(from, from + reach, |tag| tag != own))
    });
    let room = corners[0].room(length).min(corners[1].room(length)).min(open * 2.5 * usual * 0.4);
    let offset = usual.min(room).max(CLOSEST.min(usual));

    let aside = along.left() * offset;
    let tail = a + along * corners[0].cut(offset, radii[origin], length) + aside;
    let tip = b - along * corners[1].cut(offset, radii[destination], length) + aside;
    let barb = style.barb.min(0.45 * (tip - tail).length()).min((1.47 * offset).max(4.0));
    Some(Shaft { tail, tip, along, middle: (a + b) * 0.5 + aside, edge_length: length, offset, barb })
}
