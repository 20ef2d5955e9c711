//! Where elements of a structure lie, for the picture of differences.
//!
//! ```text
//!   ●───❶───●      a half-edge: on its side of the middle of its edge; a vertex: at its place; a face: inside of it
//! ```
//!
//! The place of a face is found by a walk along its cycle. In a broken structure thousands of faces may name half-edges
//! of one cycle: no half-edge is walked twice.
//!
//! ```text
//!   f1: h4 ─▸ h8 ─▸ h2 ─▸ h4     the first walk comes back, and gives all on its way a place
//!   f2: h6 ─▸ h8                 the second one ends where a place is known
//! ```

use super::painting::Area;
use super::placed::Placed;
use super::report::Spot;
use crate::ids::{Element, FaceId, HalfEdgeId, VertexId};
use crate::plane::Point;
use crate::topology::View;
use std::collections::BTreeMap;

/// Where the elements of a structure lie.
pub(super) struct Spots<'a> {
    placed: &'a Placed<'a>,
    /// Which walk along `next` passed a half-edge.
    walked: BTreeMap<HalfEdgeId, usize>,
    /// A point well inside of what each walk went round, if there is one.
    inside: Vec<Option<Point>>,
}

impl<'a> Spots<'a> {
    pub(super) fn new(placed: &'a Placed<'a>) -> Self {
        Self { placed, walked: BTreeMap::new(), inside: Vec::new() }
    }

    /// The place of an element; nowhere if it has none. All questions together take O(n log n).
    pub(super) fn of(&mut self, element: Element) -> Spot {
        let spot = match element {
            Element::Vertex(v) => self.vertex(v).map(Spot::At),
            Element::Edge(e) => self.half_edge(e.half_edges()[0]).map(Spot::Beside),
            Element::HalfEdge(h) => self.half_edge(h).map(Spot::Beside),
            Element::Face(f) => self.face(f).map(Spot::At),
        };
        spot.unwrap_or(Spot::Nowhere)
    }

    /// The place of what has this name.
    pub(super) fn named(&mut self, name: &str) -> Spot {
        let vertex = name.parse().ok().map(Element::Vertex);
        let half_edge = || name.parse().ok().map(Element::HalfEdge);
        let face = || name.parse().ok().map(Element::Face);
        vertex.or_else(half_edge).or_else(face).map_or(Spot::Nowhere, |element| self.of(element))
    }

    fn vertex(&self, v: VertexId) -> Option<Point> {
        self.placed.numbers.get(v.index()).copied().flatten().map(|number| self.placed.graph.point(number))
    }

    fn half_edge(&self, h: HalfEdgeId) -> Option<[Point; 2]> {
        let placed = self.placed;
        placed.table.has_half_edge(h).then(|| placed.ends(h)).flatten().map(|ends| ends.map(|v| placed.graph.point(v)))
    }

    /// A point well inside of a bounded face.
    fn face(&mut self, f: FaceId) -> Option<Point> {
        let table = self.placed.table;
        let start = table.has_face(f).then(|| table.half_edge(f)).flatten().filter(|_| table.outer_face != Some(f))?;
        let (walk, mut at, mut corners) = (self.inside.len(), Some(start), Vec::new());
        let mut met = None;
        while let Some(h) = at.filter(|&h| table.has_half_edge(h)) {
            met = self.walked.get(&h).copied();
            if met.is_some() {
                break;
            }
            let before = self.walked.insert(h, walk);
            debug_assert_eq!(before, None, "{h} is walked twice");
            corners.extend(self.placed.ends(h).map(|ends| self.placed.graph.point(ends[0])));
            at = table.next(h);
        }
        let known = met.filter(|&other| other != walk).map(|other| self.inside[other]);
        let inside = known.unwrap_or_else(|| {
            let area = Area::new(&[corners], false);
            area.inner_points(&area).first().copied()
        });
        self.inside.push(inside);
        inside
    }
}

/// Several places; those that are nowhere are left out.
pub(super) fn all(spots: impl Iterator<Item = Spot>) -> Spot {
    let spots: Vec<Spot> = spots.filter(|spot| *spot != Spot::Nowhere).collect();
    if spots.is_empty() { Spot::Nowhere } else { Spot::all(spots) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plane::Subdivision;
    use crate::topology::{FaceRow, Table};

    #[test]
    fn faces_on_one_cycle_lie_at_one_place_and_it_is_walked_once() {
        let at = |i: u32| (std::f64::consts::TAU * f64::from(i) / 100.0).sin_cos();
        let points: Vec<Point> = (0..100).map(at).map(|(y, x)| Point::new(x, y)).collect();
        let polygon = Subdivision::polygon(&points).unwrap();
        let mut table = Table::from_view(&polygon);
        for (row, p) in table.vertices.iter_mut().flatten().zip(&points) {
            row.position = Some([p.x, p.y]);
        }
        let f1 = FaceId::new(1);
        for h in polygon.cycle(polygon.half_edge(f1).unwrap()) {
            table.faces.push(Some(FaceRow { half_edge: Some(h), ..FaceRow::default() }));
        }
        let placed = Placed::new(&table);
        let mut spots = Spots::new(&placed);
        let spot = spots.of(Element::Face(f1));
        let Spot::At(inside) = spot else { panic!("{spot:?}") };
        assert!(inside.x.hypot(inside.y) < 0.99, "{inside}");
        for f in 2..102 {
            assert_eq!(spots.of(Element::Face(FaceId::new(f))), spot, "f{f}");
        }
        assert_eq!((spots.walked.len(), spots.inside.len()), (100, 101));
        assert_eq!(spots.of(Element::Face(FaceId::new(0))), Spot::Nowhere);
    }
}
