//! Everything that a few splits make of a small polygon, one of each kind.
//!
//! ```text
//!   n = 3 .. 6 corners          every legal split_face, every split_in_half        two that differ only in the
//!       △  □  ⬠  ⬡       ──▶     again and again, k times                  ──▶     names of elements are one kind
//! ```
//!
//! A structure is put into one form for all of its kind: from each half-edge in turn, number what `next` and
//! `twin` reach in the order in which they reach it, and take the numbering that reads smallest. Which face is the
//! outer one does not count: a face like any other.
//!
//! Source: one root at a time, as in `topology::isomorphic`.

use super::spec::{self, TwinSide};
use dcel_kit::topology::{Dcel, Table, View};
use dcel_kit::{FaceId, HalfEdgeId};
use std::collections::BTreeSet;

/// One structure of each kind that at most `operations` splits make of polygons with `corners`, smallest first.
///
/// Cost: the number of structures times the square of their size; a few milliseconds for six corners and two
/// operations.
#[must_use]
pub fn classes(corners: std::ops::RangeInclusive<usize>, operations: usize) -> Vec<Table> {
    let mut seen = BTreeSet::new();
    let mut all = Vec::new();
    let mut last: Vec<Table> = Vec::new();
    for table in corners.filter_map(polygon) {
        if seen.insert(form(&table)) {
            last.push(table);
        }
    }
    for _ in 0..operations {
        let mut next = Vec::new();
        for table in &last {
            next.extend(children(table).into_iter().filter(|child| seen.insert(form(child))));
        }
        all.append(&mut last);
        last = next;
    }
    all.append(&mut last);
    all.sort_by_key(|table| table.half_edges.len());
    all
}

/// What one split makes of a structure.
fn children(table: &Table) -> Vec<Table> {
    let half_edges = || (0..table.half_edges.len() as u32).map(HalfEdgeId::new);
    let mut out = Vec::new();
    for h1 in half_edges() {
        if table.twin(h1).is_some_and(|twin| h1 < twin) {
            out.extend(spec::split_in_half(table, h1, TwinSide::Kept).map(|(table, _)| table));
        }
        for h2 in half_edges().filter(|&h2| h1 < h2) {
            out.extend(spec::split_face(table, h1, h2).map(|(table, _)| table));
        }
    }
    out
}

/// A polygon with corners on a lattice, no two of its edges equal: f0 outside, f1 inside.
#[must_use]
pub fn polygon(corners: usize) -> Option<Table> {
    let mut table = Table::from_view(&Dcel::polygon(corners).ok()?);
    table.outer_face = Some(FaceId::new(0));
    for (row, position) in table.vertices.iter_mut().flatten().zip(CORNERS[corners.min(6)]) {
        row.position = Some(*position);
    }
    Some(table)
}

/// Convex, counter-clockwise; the middles of the edges have halves, so that whole numbers do not do.
const CORNERS: [&[[f64; 2]]; 7] = [
    &[],
    &[],
    &[],
    &[[0.0, 0.0], [7.0, 1.0], [2.0, 6.0]],
    &[[0.0, 0.0], [7.0, 1.0], [8.0, 6.0], [1.0, 5.0]],
    &[[0.0, 0.0], [6.0, -1.0], [9.0, 4.0], [4.0, 8.0], [-1.0, 5.0]],
    &[[0.0, 0.0], [5.0, -2.0], [10.0, 1.0], [11.0, 6.0], [4.0, 9.0], [-1.0, 4.0]],
];

/// The same for two structures exactly if they are equal up to names: the smallest of the texts from each
/// half-edge. A connected structure only.
fn form(table: &Table) -> Vec<u8> {
    let roots = (0..table.half_edges.len() as u32).map(HalfEdgeId::new);
    roots.map(|root| text_from(table, root)).min().unwrap_or_default()
}

fn text_from(table: &Table, root: HalfEdgeId) -> Vec<u8> {
    let mut number = vec![u8::MAX; table.half_edges.len()];
    let mut order = vec![root];
    number[root.index()] = 0;
    let mut text = Vec::with_capacity(3 * number.len());
    let mut at = 0;
    while let Some(&h) = order.get(at) {
        for target in [table.next(h), table.twin(h)].into_iter().flatten() {
            let place = &mut number[target.index()];
            if *place == u8::MAX {
                *place = order.len() as u8;
                order.push(target);
            }
            text.push(*place);
        }
        at += 1;
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use dcel_kit::topology::{isomorphic, violations};

    #[test]
    fn no_two_classes_are_the_same() {
        let all = classes(3..=6, 2);
        for (i, a) in all.iter().enumerate() {
            assert!(violations(a).is_empty(), "{:?}", violations(a));
            for b in &all[..i] {
                assert!(isomorphic(a, b).is_err());
            }
        }
    }
}
