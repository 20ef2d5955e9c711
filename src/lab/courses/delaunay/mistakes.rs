//! Usual mistakes, carried out: does one of them show in a call?
//!
//! Nothing here decides a verdict. A feature of a call says that such a mistake shows in it; if the calls in which it
//! shows are those that fail, the report says so.

use super::edges::{due, is_legal, place};
use super::flip::{corners, flip};
use crate::checks::walks::half_edges;
use dcel_kit::plane::predicates::in_circle;
use dcel_kit::topology::{Table, View};
use dcel_kit::{FaceId, HalfEdgeId, VertexId};

/// Whether doubles say that d is not inside of the circle through a, b, c.
pub(super) fn rounded_is_legal([a, b, c, d]: [[f64; 2]; 4]) -> bool {
    let [p, q, r] = [a, b, c].map(|corner| [corner[0] - d[0], corner[1] - d[1]]);
    let square = |v: [f64; 2]| v[0] * v[0] + v[1] * v[1];
    let det = |v: [f64; 2], w: [f64; 2]| v[0] * w[1] - v[1] * w[0];
    square(p) * det(q, r) + square(q) * det(r, p) + square(r) * det(p, q) <= 0.0
}

/// Whether doubles are wrong about an edge.
pub(super) fn rounded_goes_wrong(table: &Table, h: HalfEdgeId) -> bool {
    let Some(all) = corners(table, h) else { return false };
    let places = all.map(|v| place(table, v).map_or([0.0; 2], |p| [p.x, p.y]));
    rounded_is_legal(places) != is_legal(table, h)
}

/// Whether an edge seems legal if nobody asks what its faces are.
fn seems_legal(table: &Table, h: HalfEdgeId) -> Option<bool> {
    let twin = table.twin(h)?;
    let at = |h| place(table, table.origin(h)?);
    let [a, b, c, d] = [at(h)?, at(twin)?, at(table.prev(h)?)?, at(table.prev(twin)?)?];
    Some(in_circle(a, b, c, d).is_le())
}

/// Whether it goes wrong that the outer face counts as a triangle.
pub(super) fn outer_goes_wrong(table: &Table, h: HalfEdgeId) -> bool {
    seems_legal(table, h) != Some(is_legal(table, h))
}

/// Whether it goes wrong that f0 counts as the outer face.
pub(super) fn zero_goes_wrong(table: &Table, h: HalfEdgeId) -> bool {
    let at_zero = [Some(h), table.twin(h)].into_iter().flatten().any(|h| table.face(h) == Some(FaceId::new(0)));
    let said = if at_zero { Some(true) } else { seems_legal(table, h) };
    said != Some(is_legal(table, h))
}

/// Whether it goes wrong that no vertex at all may lie inside of the circle on the left of an edge.
pub(super) fn everywhere_goes_wrong(table: &Table, h: HalfEdgeId) -> bool {
    let Some([a, b, c, _]) = corners(table, h).map(|all| all.map(|v| place(table, v).unwrap_or_default())) else {
        return false;
    };
    let mut all = (0..table.vertices.len() as u32).filter_map(|v| place(table, VertexId::new(v)));
    is_legal(table, h) && all.any(|p| in_circle(a, b, c, p).is_gt())
}

/// Which edges are looked at again after a flip.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Again {
    /// None.
    Nothing,
    /// The two others of the triangle on the left.
    Left,
}

/// Whether edges stay that are not legal, if all are looked at once, `up` or down by their numbers.
pub(super) fn some_stay(table: &Table, again: Again, up: bool) -> bool {
    let mut table = table.clone();
    let mut open: Vec<HalfEdgeId> = half_edges(&table).collect();
    if up {
        open.reverse();
    }
    while let Some(h) = open.pop() {
        if is_legal(&table, h) || flip(&mut table, h).is_none() {
            continue;
        }
        if again == Again::Left {
            open.extend([table.next(h), table.prev(h)].into_iter().flatten());
        }
    }
    due(&table).is_some()
}

#[cfg(test)]
mod tests {
    use super::super::meshes::fixed;
    use super::*;

    #[test]
    fn every_mistake_shows_in_some_triangulations_and_not_in_others() {
        let tables: Vec<Table> = fixed().iter().map(super::super::meshes::Mesh::table).collect();
        let shows = |holds: &dyn Fn(&Table) -> bool, name: &str| {
            let count = tables.iter().filter(|table| holds(table)).count();
            assert!(0 < count && count < tables.len(), "{name}: {count} of {}", tables.len());
        };
        let of_edges =
            |wrong: fn(&Table, HalfEdgeId) -> bool| move |table: &Table| half_edges(table).any(|h| wrong(table, h));
        shows(&of_edges(rounded_goes_wrong), "rounded");
        shows(&of_edges(outer_goes_wrong), "outer");
        shows(&of_edges(everywhere_goes_wrong), "everywhere");
        for (again, up) in [(Again::Nothing, true), (Again::Nothing, false), (Again::Left, false)] {
            shows(&|table| some_stay(table, again, up), "some stay");
        }
    }
}
