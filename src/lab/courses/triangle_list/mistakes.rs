//! Usual mistakes of linking, carried out: does one of them show in a call?
//!
//! Nothing here decides a verdict. A feature of a call says that such a mistake shows in it; if the calls in which it
//! shows are those that fail, the report says so.

use super::soup::{Ends, Soup};
use crate::checks::walks::half_edges;
use dcel_kit::HalfEdgeId;
use dcel_kit::topology::{Table, View};
use std::collections::BTreeMap;

fn origin(table: &Table, h: HalfEdgeId) -> Option<u32> {
    Some(table.origin(h)?.number())
}

/// The twins of half-edges with these ends, or the ends that come twice.
fn twins(ends: &[Ends]) -> Result<Vec<Option<usize>>, Ends> {
    let mut met: BTreeMap<Ends, usize> = BTreeMap::new();
    let mut found = vec![None; ends.len()];
    for (h, &[a, b]) in ends.iter().enumerate() {
        if met.insert([a, b], h).is_some() {
            return Err([a, b]);
        }
        if let Some(&g) = met.get(&[b, a]) {
            (found[h], found[g]) = (Some(g), Some(h));
        }
    }
    Ok(found)
}

/// The ends of each half-edge, if after each comes the one that is given.
fn ends(table: &Table, after: &dyn Fn(HalfEdgeId) -> Option<HalfEdgeId>) -> Option<Vec<Ends>> {
    half_edges(table).map(|h| Some([origin(table, h)?, origin(table, after(h)?)?])).collect()
}

fn is_true([from, to]: Ends, soup: &Soup) -> bool {
    soup.edges_twice().contains(&format!("the edge from vertex {from} to vertex {to} comes twice"))
}

/// Whether `match_twins` gives another result if it matches any two half-edges that have the same ends, in whatever
/// order, and refuses only a third one.
pub(super) fn any_way_differs(table: &Table, soup: &Soup) -> bool {
    let Some(ends) = ends(table, &|h| table.next(h)) else { return false };
    let mut met: BTreeMap<Ends, u32> = BTreeMap::new();
    for &[a, b] in &ends {
        let count = met.entry([a.min(b), a.max(b)]).or_default();
        *count += 1;
        if *count > 2 {
            return !is_true([a, b], soup);
        }
    }
    !soup.edges_twice().is_empty()
}

/// Whether `match_twins` gives another result if each half-edge ends where the one with the number after it starts.
pub(super) fn numbered_differs(table: &Table, soup: &Soup) -> bool {
    let count = table.half_edges.len() as u32;
    let by_number = |h: HalfEdgeId| Some(HalfEdgeId::new((h.number() + 1) % count));
    let (Some(right), Some(wrong)) = (ends(table, &|h| table.next(h)), ends(table, &by_number)) else { return false };
    match twins(&wrong) {
        Err(twice) => !is_true(twice, soup),
        found => found != twins(&right),
    }
}

/// Whether the border is wrong if its half-edges are linked in the order of the numbers of their twins.
pub(super) fn in_order_differs(table: &Table) -> bool {
    let inside: Vec<HalfEdgeId> = half_edges(table).filter(|&h| table.twin(h).is_none()).collect();
    let follows = |i: usize| {
        let (h, after) = (inside[i], inside[(i + 1) % inside.len()]);
        // The half-edge of the border that comes after the twin of h starts where h starts; its twin ends there.
        table.origin(h) == table.next(after).and_then(|next| table.origin(next))
    };
    !(0..inside.len()).all(follows)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_mislead_only_where_the_faces_are_not_numbered_so_that_they_fit() {
        let triangle = Soup::new(3, &[[0, 1, 2]]);
        let [in_order, turned] = [[0, 1, 2], [2, 1, 0]].map(|order| triangle.table(&order, true));
        assert!(!numbered_differs(&in_order, &triangle));
        // Each half-edge by itself is wrong there, but none has a twin: nothing shows.
        assert!(!numbered_differs(&turned, &triangle));
        let two = Soup::new(4, &[[0, 1, 2], [0, 2, 3]]);
        assert!(!numbered_differs(&two.table(&[0, 1, 2, 3, 4, 5], false), &two));
        assert!(numbered_differs(&two.table(&[5, 4, 3, 2, 1, 0], false), &two));
    }

    #[test]
    fn a_third_half_edge_is_noticed_whatever_its_direction_but_not_a_second_one() {
        let differs = |soup: &Soup| {
            any_way_differs(&soup.table(&[0, 1, 2, 3, 4, 5, 6, 7, 8][..soup.faces.len() * 3], false), soup)
        };
        assert!(differs(&Soup::new(4, &[[0, 1, 2], [0, 1, 3]])));
        assert!(!differs(&Soup::new(4, &[[0, 1, 2], [1, 0, 3]])));
        assert!(!differs(&Soup::new(5, &[[0, 1, 2], [1, 0, 3], [0, 1, 4]])));
        // The third one is refused, but it is not the direction that comes twice.
        assert!(differs(&Soup::new(5, &[[0, 1, 2], [0, 1, 3], [1, 0, 4]])));
    }

    #[test]
    fn the_border_of_a_triangle_runs_against_the_numbers() {
        let triangle = Soup::new(3, &[[0, 1, 2]]);
        assert!(in_order_differs(&triangle.table(&[0, 1, 2], true)));
        assert!(!in_order_differs(&triangle.table(&[2, 1, 0], true)));
    }
}
