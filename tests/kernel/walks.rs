//! Walks give each half-edge once, from either end, step by step or all at once.

use dcel_kit::topology::Dcel;
use dcel_kit::{HalfEdgeId, VertexId};

/// A pentagon with both diagonals of vertex 0, one side split: a star of four, faces of three, three and four.
fn pentagon() -> Dcel {
    let mut d = Dcel::polygon(5).unwrap();
    let leaving = |d: &Dcel, v: u32, other: u32| {
        let has_other = |&h: &HalfEdgeId| d.incident_vertices(d.face(h)).any(|w| w.number() == other);
        let inside = |h: &HalfEdgeId| d.face(*h).number() != 0;
        d.outgoing_half_edges(VertexId::new(v)).filter(inside).find(has_other).unwrap()
    };
    for other in [2, 3] {
        d.split_face(leaving(&d, 0, other), leaving(&d, other, 0)).unwrap();
    }
    d.split_edge(HalfEdgeId::new(0)).unwrap();
    d
}

fn all_ways<I: DoubleEndedIterator<Item = HalfEdgeId> + Clone>(walk: &I, name: &str) {
    let mut steps = Vec::new();
    let by_steps = walk.clone();
    for h in by_steps {
        steps.push(h);
    }
    for front in 0..=steps.len() {
        for back in 0..=steps.len() - front {
            let mut rest = walk.clone();
            (0..front).for_each(|i| assert_eq!(rest.next(), Some(steps[i]), "{name}"));
            (0..back).for_each(|i| assert_eq!(rest.next_back(), Some(steps[steps.len() - 1 - i]), "{name}"));
            let folded = rest.fold(Vec::new(), |mut list, h| {
                list.push(h);
                list
            });
            assert_eq!(
                folded,
                steps[front..steps.len() - back],
                "{name}: {front} from the front, {back} from the back"
            );
        }
    }
}

#[test]
fn a_walk_from_both_ends_leaves_the_middle_to_be_folded() {
    let d = pentagon();
    assert_eq!((d.vertex_count(), d.edge_count(), d.face_count()), (6, 8, 4));
    for f in d.faces() {
        all_ways(&d.incident_half_edges(f), &f.to_string());
    }
    for v in d.vertices() {
        all_ways(&d.outgoing_half_edges(v), &v.to_string());
    }
}
