//! Where elements of a structure lie, for the picture of differences.
//!
//! ```text
//!   ●───❶───●      a half-edge: on its side of the middle of its edge; a vertex: at its place; a face: inside of it
//! ```

use super::painting::Area;
use super::placed::Placed;
use super::report::Spot;
use crate::ids::{Element, FaceId, HalfEdgeId, VertexId};
use crate::plane::Point;
use crate::topology::{View, bounded_cycle};

/// The place of an element; nowhere if it has none.
pub(super) fn of(placed: &Placed<'_>, element: Element) -> Spot {
    let spot = match element {
        Element::Vertex(v) => vertex(placed, v).map(Spot::At),
        Element::Edge(e) => half_edge(placed, e.half_edges()[0]).map(Spot::Beside),
        Element::HalfEdge(h) => half_edge(placed, h).map(Spot::Beside),
        Element::Face(f) => face(placed, f).map(Spot::At),
    };
    spot.unwrap_or(Spot::Nowhere)
}

/// The place of what has this name.
pub(super) fn named(placed: &Placed<'_>, name: &str) -> Spot {
    let vertex = name.parse().ok().map(Element::Vertex);
    let half_edge = || name.parse().ok().map(Element::HalfEdge);
    let face = || name.parse().ok().map(Element::Face);
    vertex.or_else(half_edge).or_else(face).map_or(Spot::Nowhere, |element| of(placed, element))
}

/// Several places; those that are nowhere are left out.
pub(super) fn all(spots: impl Iterator<Item = Spot>) -> Spot {
    let spots: Vec<Spot> = spots.filter(|spot| *spot != Spot::Nowhere).collect();
    if spots.is_empty() { Spot::Nowhere } else { Spot::all(spots) }
}

fn vertex(placed: &Placed<'_>, v: VertexId) -> Option<Point> {
    placed.numbers.get(v.index()).copied().flatten().map(|number| placed.graph.point(number))
}

fn half_edge(placed: &Placed<'_>, h: HalfEdgeId) -> Option<[Point; 2]> {
    placed.table.has_half_edge(h).then(|| placed.ends(h)).flatten().map(|ends| ends.map(|v| placed.graph.point(v)))
}

/// A point well inside of a bounded face.
fn face(placed: &Placed<'_>, f: FaceId) -> Option<Point> {
    let table = placed.table;
    let start = table.has_face(f).then(|| table.half_edge(f)).flatten().filter(|_| table.outer_face != Some(f))?;
    let corner = |h| Some(placed.graph.point(placed.ends(h)?[0]));
    let area = Area::new(&[bounded_cycle(table, start).filter_map(corner).collect()], false);
    area.inner_points(&area).first().copied()
}
