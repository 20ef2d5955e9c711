//! Walks in structures that may be broken in every way: none of them goes on without a bound.

use dcel_kit::HalfEdgeId;
use dcel_kit::topology::{Table, View};

/// The cycle of half-edges from `start` along `next`; cut where it is broken or longer than the table.
#[must_use]
pub fn cycle(table: &Table, start: HalfEdgeId) -> Vec<HalfEdgeId> {
    dcel_kit::topology::bounded_cycle(table, start).collect()
}

/// The half-edges that start at `origin(start)`, counter-clockwise: `prev.twin` again and again.
#[must_use]
pub fn star(table: &Table, start: HalfEdgeId) -> Vec<HalfEdgeId> {
    let mut star = vec![start];
    let mut at = start;
    for _ in 0..table.half_edges.len() {
        match table.prev(at).and_then(|prev| table.twin(prev)) {
            Some(next) if next != start => {
                star.push(next);
                at = next;
            }
            _ => break,
        }
    }
    star
}
