//! Vertex discs, and the corners round a vertex.
//!
//! ```text
//!      \   /          r = min(9.5, max(2.2, 0.24 · shortest edge here)), 11.2 for names from three characters on;
//!       (v7)───       smaller where a stranger is near: no disc hides another vertex or a foreign edge.
//! ```

use crate::figure::Style;
use crate::figure::canvas::text::{self, LEGIBLE};
use crate::figure::canvas::vector::{Xy, xy};
use crate::figure::layout::crowd::{Crowd, Shape};
use crate::figure::structure::skeleton::{Skeleton, vertices};
use crate::geometry::grouping::Groups;
use crate::ids::{HalfEdgeId, VertexId, VertexMap};
use crate::plane::PlanarView;

/// The smallest disc.
pub(crate) const SMALLEST: f64 = 2.2;
/// Below this radius a name stands outside.
pub(crate) const NAMED: f64 = 8.0;

/// The radius of every vertex disc. `edges` holds the edges tagged with half-edges of `skeleton`.
pub(crate) fn radii<V: PlanarView + ?Sized>(
    view: &V,
    skeleton: &Skeleton,
    edges: &Crowd,
    size: Xy,
    style: &Style,
) -> VertexMap<f64> {
    let longest = vertices(view).map(|v| v.to_string().len()).max().unwrap_or(0);
    let largest = style.vertex_radius + if longest > 2 { 1.7 } else { 0.0 };
    let mut out = VertexMap::filled(view.vertex_bound(), largest);
    for &h in &skeleton.edges {
        if let (Some([a, b]), Some((p, q))) = (skeleton.ends(h), skeleton.segment(h)) {
            let reach = 0.24 * (q - p).length();
            out[a] = out[a].min(reach);
            out[b] = out[b].min(reach);
        }
    }
    let mut points = Crowd::new(size);
    for (v, &at) in skeleton.at.iter() {
        if let Some(at) = at {
            points.add(Shape::Disc(at, 0.0), v.number());
        }
    }
    let touches = |tag: u32, v: VertexId| skeleton.ends(HalfEdgeId::new(tag)).is_some_and(|ends| ends.contains(&v));
    for (v, &at) in skeleton.at.iter() {
        let Some(at) = at else { continue };
        let reach = 2.5 * largest;
        let vertex = points.nearest(at, reach, |tag| tag != v.number());
        let edge = edges.nearest(at, reach, |tag| !touches(tag, v));
        out[v] = out[v].min(0.42 * vertex).min(0.6 * edge).max(SMALLEST);
    }
    out
}

/// The size at which a name fits into its disc, if it does.
pub(crate) fn name_size(name: &str, radius: f64, style: &Style) -> Option<f64> {
    if radius < NAMED {
        return None;
    }
    let room = 2.0 * radius - 3.4;
    let size = style.vertex_text.min(room / text::width(name, 1.0, true));
    (size >= style.vertex_text.min(LEGIBLE)).then_some(size)
}

/// The directions of the edges at every vertex, in flat arrays.
pub(crate) struct Spokes(Groups<Xy>);

impl Spokes {
    pub(crate) fn new(vertex_bound: usize, skeleton: &Skeleton) -> Self {
        let both = skeleton.edges.iter().filter_map(|&h| {
            let (p, q) = skeleton.segment(h)?;
            let ([a, b], along) = (skeleton.ends(h)?, (q - p).unit()?);
            Some([(a.index(), along), (b.index(), along * -1.0)])
        });
        Self(Groups::new(vertex_bound, both.flatten()))
    }

    /// The bisectors of the corners round `v`, the widest corner first.
    pub(crate) fn bisectors(&self, v: VertexId) -> Vec<Xy> {
        let mut round = self.0.of(v.index()).to_vec();
        round.sort_by(|a, b| a.pseudo_angle().total_cmp(&b.pseudo_angle()));
        let Some(&first) = round.first() else {
            return vec![xy(0.0, 1.0), xy(0.0, -1.0), xy(1.0, 0.0), xy(-1.0, 0.0)];
        };
        let mut corners: Vec<(f64, Xy)> = Vec::with_capacity(round.len());
        for (i, &from) in round.iter().enumerate() {
            let to = round.get(i + 1).copied().unwrap_or(first);
            corners.push(corner(from, to, round.len() == 1));
        }
        corners.sort_by(|a, b| b.0.total_cmp(&a.0));
        corners.into_iter().map(|(_, bisector)| bisector).collect()
    }
}

/// A number that grows with the counter-clockwise angle from `from` to `to`, 0 to 4, and the bisector.
fn corner(from: Xy, to: Xy, whole: bool) -> (f64, Xy) {
    let (sine, cosine) = (from.turn(to), from.dot(to));
    if whole {
        return (4.0, from * -1.0);
    }
    let width = if sine >= 0.0 { 1.0 - cosine } else { 3.0 + cosine };
    let between = (from + to) * if sine >= 0.0 { 1.0 } else { -1.0 };
    (width, between.unit().unwrap_or(from.left()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn corners_are_ordered_by_their_angle_and_bisected() {
        let east = xy(1.0, 0.0);
        let round = [xy(0.8, -0.6), xy(0.0, -1.0), xy(-1.0, 0.0), xy(0.0, 1.0), xy(0.8, 0.6)];
        let widths: Vec<f64> = round.iter().map(|&to| corner(east, to, false).0).collect();
        assert!(widths.windows(2).all(|w| w[0] < w[1]), "{widths:?}");
        assert_eq!(corner(east, xy(-1.0, 0.0), false).1, xy(0.0, -1.0), "a straight corner is bisected upwards");
        let (_, wide) = corner(east, xy(0.0, 1.0), false);
        assert!(wide.x < 0.0 && wide.y < 0.0, "270 degrees from east to south (on paper): {wide:?}");
    }

    #[test]
    fn long_names_shrink_or_leave_the_disc() {
        let style = Style::default();
        assert_eq!(name_size("v3", 9.5, &style), Some(9.5));
        assert!(name_size("v12", 11.2, &style).unwrap() >= LEGIBLE);
        assert_eq!(name_size("v123", 11.2, &style), None, "smaller than can be read");
        assert_eq!(name_size("v3", 7.9, &style), None);
        assert_eq!(name_size("v123456", 9.5, &style), None);
    }
}
