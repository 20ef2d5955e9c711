//! What a wrong answer of a reading function is: the answers that usual mistakes give, compared with it.
//!
//! ```text
//!   walk_face f1 should be   h0 h2 h4 h6      h6 h4 h2 h0   the opposite way round
//!                                             h2 h4 h6      all but the stored half-edge
//!   destination h0           v1               v2            where the next half-edge ends
//! ```
//!
//! Nothing here decides a verdict. What is said holds of this call; the report says what holds of every failing one.

use crate::checks::cyclic::is_rotation;
use crate::checks::walks::{cycle, star};
use dcel_kit::topology::{Table, View};
use dcel_kit::{FaceId, HalfEdgeId, VertexId};
use std::collections::BTreeSet;

/// All that can be said of a wrong answer; what says most comes first. Cost: O(n log n) for n elements.
pub(super) fn of(table: &Table, function: &str, argument: u32, found: &[u32]) -> Vec<&'static str> {
    match function {
        "destination" | "destination_by_next" => of_end(table, HalfEdgeId::new(argument), found),
        "walk_face" | "walk_vertices" => match table.half_edge(FaceId::new(argument)) {
            Some(stored) if function == "walk_face" => of_face(table, &cycle(table, stored), found),
            Some(stored) => of_corners(table, &cycle(table, stored), found),
            None => Vec::new(),
        },
        "walk_vertex" => match table.outgoing(VertexId::new(argument)) {
            Some(stored) => of_star(table, &star(table, stored), found),
            None => Vec::new(),
        },
        _ => Vec::new(),
    }
}

fn of_end(table: &Table, h: HalfEdgeId, found: &[u32]) -> Vec<&'static str> {
    let &[found] = found else { return Vec::new() };
    let end = |h: HalfEdgeId| table.twin(h).and_then(|twin| table.origin(twin));
    let beside = HalfEdgeId::new(h.number() ^ 1);
    let after = h.number().checked_add(1).map(HalfEdgeId::new);
    let of_next = table.next(h).and_then(|next| end(next).or_else(|| table.origin(table.next(next)?)));
    let candidates = [
        (table.origin(h), "where the half-edge starts"),
        (of_next, "where the next half-edge ends"),
        (table.prev(h).and_then(|prev| table.origin(prev)), "where the half-edge before it starts"),
        (
            table.origin(beside),
            "where the half-edge with the number beside it starts (0 and 1, 2 and 3, …): it need not be the twin",
        ),
        (
            after.and_then(|after| table.origin(after)),
            "where the half-edge with the next number starts: it need not be the next one",
        ),
    ];
    candidates.into_iter().filter(|(v, _)| v.map(VertexId::number) == Some(found)).map(|(_, words)| words).collect()
}

fn of_face(table: &Table, walk: &[HalfEdgeId], found: &[u32]) -> Vec<&'static str> {
    let origins: Vec<_> = walk.iter().map(|&h| table.origin(h)).collect();
    let again = 1 + origins.iter().skip(1).position(|v| *v == origins[0]).unwrap_or(walk.len());
    let mut met = BTreeSet::new();
    let any_again = origins.iter().take_while(|v| met.insert(**v)).count();
    let right = numbers(walk);
    let mut out = of_list(&right, found);
    let cut = |at: usize| at < right.len() && found == &right[..at];
    out.extend(cut(again).then_some("cut off where the walk comes to its first vertex again"));
    out.extend(cut(any_again).then_some("cut off where the walk comes to a vertex for the second time"));
    out.extend(are_twins(table, walk, found).then_some("the twins of the right ones"));
    out
}

fn of_corners(table: &Table, walk: &[HalfEdgeId], found: &[u32]) -> Vec<&'static str> {
    let right: Vec<u32> = walk.iter().filter_map(|&h| table.origin(h)).map(VertexId::number).collect();
    let mut out = of_list(&right, found);
    let mut met = BTreeSet::new();
    let once: Vec<u32> = right.iter().copied().filter(|&v| met.insert(v)).collect();
    if once.len() < right.len() {
        out.extend((found == once).then_some("each vertex once, although the face comes to one more than once"));
        let again = 1 + right.iter().skip(1).position(|&v| v == right[0]).unwrap_or(right.len());
        out.extend(
            (found.len() == again && found == &right[..again.min(right.len())])
                .then_some("cut off where the walk comes to its first vertex again"),
        );
    }
    let hop = "what comes of going from vertex to vertex along the half-edges that the vertices store";
    out.extend((found.len() > 1 && hops(table, found)).then_some(hop));
    out
}

fn of_star(table: &Table, spokes: &[HalfEdgeId], found: &[u32]) -> Vec<&'static str> {
    let right = numbers(spokes);
    let mut out = of_list(&right, found);
    let is_outer = |h: &HalfEdgeId| table.face(*h).is_some() && table.face(*h) == table.outer_face;
    let before = spokes.iter().take_while(|h| !is_outer(h)).count();
    let cut = before < right.len() && (found == &right[..before] || found == &right[..=before]);
    out.extend((cut && found.len() < right.len()).then_some("cut off at the outer face"));
    out.extend(are_twins(table, spokes, found).then_some("the twins of the right ones, which end at the vertex"));
    out
}

/// What can be said of any list: `right` begins with what is stored.
fn of_list(right: &[u32], found: &[u32]) -> Vec<&'static str> {
    let (n, m) = (right.len(), found.len());
    let reversed: Vec<u32> = right.iter().rev().copied().collect();
    let mut sorted = right.to_vec();
    sorted.sort_unstable();
    let candidates = [
        (is_rotation(found, &reversed), "the right list the opposite way round"),
        (n > 1 && m + 1 == n && found == &right[1..], "the right list without the one that is stored, the first"),
        (n > 1 && m + 1 == n && found == &right[..n - 1], "the right list without its last one"),
        (
            m == n + 1 && found[..n] == *right && found[n] == right[0],
            "the right list with the first one again at its end",
        ),
        (m == 1 && n > 1 && found[0] == right[0], "only the one that is stored"),
        (m > 2 && found == sorted, "the right ones in the order of their numbers"),
    ];
    candidates.into_iter().filter(|(holds, _)| *holds).map(|(_, words)| words).collect()
}

/// Whether each vertex of the list is the end of the half-edge that the one before it stores.
fn hops(table: &Table, found: &[u32]) -> bool {
    let end = |v: u32| {
        let stored = table.outgoing(VertexId::new(v))?;
        table.twin(stored).and_then(|twin| table.origin(twin)).map(VertexId::number)
    };
    found.windows(2).all(|pair| end(pair[0]) == Some(pair[1]))
}

fn are_twins(table: &Table, walk: &[HalfEdgeId], found: &[u32]) -> bool {
    let twins: Option<Vec<u32>> = walk.iter().map(|&h| table.twin(h).map(HalfEdgeId::number)).collect();
    twins.is_some_and(|mut twins| {
        is_rotation(found, &twins) || {
            twins.reverse();
            is_rotation(found, &twins)
        }
    })
}

fn numbers(walk: &[HalfEdgeId]) -> Vec<u32> {
    walk.iter().map(|h| h.number()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use dcel_kit::topology::{FaceRow, HalfEdgeRow, VertexRow};

    /// A triangle: h0, h2, h4 round f1, their twins h1, h5, h3 round the outer face f0.
    fn triangle() -> Table {
        let row = |origin, twin, next, prev, face| {
            let id = |n| Some(HalfEdgeId::new(n));
            Some(HalfEdgeRow {
                origin: Some(VertexId::new(origin)),
                twin: id(twin),
                next: id(next),
                prev: id(prev),
                face: Some(FaceId::new(face)),
            })
        };
        let stored = |n| Some(HalfEdgeId::new(n));
        Table {
            half_edges: vec![
                row(0, 1, 2, 4, 1),
                row(1, 0, 5, 3, 0),
                row(1, 3, 4, 0, 1),
                row(2, 2, 1, 5, 0),
                row(2, 5, 0, 2, 1),
                row(0, 4, 3, 1, 0),
            ],
            vertices: [0, 2, 4].map(|n| Some(VertexRow { outgoing: stored(n), position: None })).into(),
            faces: [1, 0].map(|n| Some(FaceRow { half_edge: stored(n), ..FaceRow::default() })).into(),
            outer_face: Some(FaceId::new(0)),
        }
    }

    #[test]
    fn usual_mistakes_are_recognised_and_nothing_else() {
        let table = triangle();
        let said = |function: &str, argument, found: &[u32]| of(&table, function, argument, found);
        assert_eq!(said("walk_face", 1, &[0, 4, 2]), ["the right list the opposite way round"]);
        assert_eq!(said("walk_face", 1, &[2, 4]), ["the right list without the one that is stored, the first"]);
        assert_eq!(said("walk_face", 1, &[0, 2]), ["the right list without its last one"]);
        assert_eq!(said("walk_face", 1, &[0, 2, 4, 0]), ["the right list with the first one again at its end"]);
        assert_eq!(said("walk_face", 1, &[3, 1, 5]), ["the twins of the right ones"]);
        assert_eq!(said("walk_face", 1, &[0]), ["only the one that is stored"]);
        assert_eq!(said("walk_face", 0, &[1, 3, 5])[1..], ["the right ones in the order of their numbers"]);
        assert_eq!(said("walk_face", 1, &[0, 1]), [""; 0]);
        let hop = "what comes of going from vertex to vertex along the half-edges that the vertices store";
        assert!(said("walk_vertices", 0, &[1, 2, 0]).contains(&hop));
        assert!(!said("walk_vertices", 0, &[2, 1, 0]).contains(&hop));
        assert!(said("walk_vertex", 0, &[0]).contains(&"cut off at the outer face"));
        assert_eq!(said("destination", 0, &[0]), ["where the half-edge starts"]);
        assert_eq!(said("destination_by_next", 0, &[2])[0], "where the next half-edge ends");
        assert!(said("destination", 0, &[1])[0].starts_with("where the half-edge with the number beside it starts"));
        assert_eq!(said("destination", 0, &[7]), [""; 0]);
    }

    #[test]
    fn a_face_that_meets_a_vertex_twice_tells_more_mistakes_apart() {
        // A path of two edges, v0 - v1 - v2: one face, h0 h2 h3 h1, which comes to v1 twice.
        let mut table = triangle();
        let ids = |list: [u32; 4]| list.map(HalfEdgeId::new);
        let walk = ids([0, 2, 3, 1]);
        for (i, (h, origin)) in walk.into_iter().zip([0, 1, 2, 1]).enumerate() {
            table.half_edges[h.index()] = Some(HalfEdgeRow {
                origin: Some(VertexId::new(origin)),
                twin: Some(HalfEdgeId::new(h.number() ^ 1)),
                next: Some(walk[(i + 1) % 4]),
                prev: Some(walk[(i + 3) % 4]),
                face: Some(FaceId::new(0)),
            });
        }
        table.faces[0] = Some(FaceRow { half_edge: Some(walk[1]), ..FaceRow::default() });
        let said = |function: &str, found: &[u32]| of(&table, function, 0, found);
        assert_eq!(said("walk_face", &[2, 3])[0], "cut off where the walk comes to its first vertex again");
        assert!(
            said("walk_vertices", &[1, 2, 0])
                .contains(&"each vertex once, although the face comes to one more than once")
        );
        assert!(said("walk_vertices", &[1, 2]).contains(&"cut off where the walk comes to its first vertex again"));
    }
}
