//! Promise: `flip_edge` moves both ends of an edge one corner on and touches nothing else; refused, it changes
//! nothing; enough flips come back to the start.

use crate::common::{Random, f, h, triangle_grid, zoo};
use dcel_kit::topology::{Dcel, FlipEdgeError, IdError, Journal, Table, isomorphic, violations};
use dcel_kit::{Element, HalfEdgeId};

/// The cycle of `a` as a list.
fn cycle(dcel: &Dcel, a: HalfEdgeId) -> Vec<HalfEdgeId> {
    dcel.cycle(a).collect()
}

/// Where both cycles of `a` must run after the flip: `next(a)` goes to the end of the other list.
fn expected(dcel: &Dcel, a: HalfEdgeId) -> [Vec<HalfEdgeId>; 2] {
    let [mut left, mut right] = [cycle(dcel, a), cycle(dcel, a.twin())];
    let (n1, n2) = (left.remove(1), right.remove(1));
    left.push(n2);
    right.push(n1);
    [left, right]
}

#[test]
fn a_flip_moves_both_ends_one_corner_on_and_nothing_else() {
    let mut flipped = 0;
    for (name, dcel) in zoo() {
        for a in dcel.half_edges() {
            let one_sided = [a, a.twin()].iter().any(|&b| dcel.next(b) == b);
            let mut after = dcel.clone();
            let mut journal = Journal::new();
            let done = after.flip_edge_with(a, &mut journal);
            assert_eq!(done, dcel.can_flip_edge(a), "{name}, {a}");
            if dcel.face(a) == dcel.face(a.twin()) || one_sided {
                assert!(done.is_err() && after == dcel, "{name}, {a}");
                continue;
            }
            flipped += 1;
            assert_eq!(violations(&after), [], "{name}, {a}");
            assert_eq!([cycle(&after, a), cycle(&after, a.twin())], expected(&dcel, a), "{name}, {a}");
            let [n1, n2] = [a, a.twin()].map(|b| dcel.next(b));
            for b in dcel.half_edges() {
                let moved = b == a || b == a.twin();
                let origin = if moved { dcel.destination(if b == a { n2 } else { n1 }) } else { dcel.origin(b) };
                assert_eq!(after.origin(b), origin, "{name}, {a}: origin of {b}");
                let face = match b {
                    _ if b == n1 => dcel.face(a.twin()),
                    _ if b == n2 => dcel.face(a),
                    _ => dcel.face(b),
                };
                assert_eq!(after.face(b), face, "{name}, {a}: face of {b}");
            }
            after.undo(&mut journal, 0);
            assert_eq!(after, dcel, "{name}, {a}: undone");
        }
    }
    assert!(flipped > 60, "{flipped} flips");
}

#[test]
fn as_many_flips_as_the_outline_has_corners_change_nothing() {
    for (name, dcel) in zoo() {
        for a in dcel.half_edges().filter(|&a| dcel.can_flip_edge(a).is_ok()) {
            let corners = dcel.cycle(a).count() + dcel.cycle(a.twin()).count() - 2;
            let mut after = dcel.clone();
            (0..corners).for_each(|_| after.flip_edge(a).unwrap());
            for b in dcel.half_edges() {
                let links = |d: &Dcel| (d.origin(b), d.next(b), d.prev(b), d.face(b));
                assert_eq!(links(&after), links(&dcel), "{name}, {corners} flips of {a}: {b}");
            }
        }
    }
}

#[test]
fn two_flips_between_triangles_exchange_the_halves() {
    let mut square = Dcel::polygon(4).unwrap();
    let (a, _) = square.split_face(h(0), h(4)).unwrap();
    let start = square.clone();
    square.flip_edge(a).unwrap();
    square.flip_edge(a).unwrap();
    assert_eq!((square.origin(a), square.destination(a)), (start.destination(a), start.origin(a)));
    assert_eq!((square.next(a), square.face(a)), (start.next(a.twin()), start.face(a)));
    assert!(isomorphic(&square, &start).is_ok());
    // The stored half-edges: none of a vertex or face may be one that left it.
    square.flip_edge(a.twin()).unwrap();
    assert_eq!(violations(&square), []);
}

/// Random flips in a grid of triangles: a structure of the same size, all invariants kept, all taken back by undo.
#[test]
fn long_random_sequences_keep_the_laws_and_can_be_undone() {
    let grid = dcel_kit::plane::Subdivision::from_table(&placed(triangle_grid(5, 4))).unwrap();
    let start = grid.topology().clone();
    for seed in 0..20 {
        let (mut random, mut dcel, mut journal) = (Random(seed), start.clone(), Journal::new());
        for i in 0..200 {
            let a = h(random.below(dcel.half_edge_bound()) as u32);
            let before = dcel.clone();
            if dcel.flip_edge_with(a, &mut journal).is_err() {
                assert_eq!(dcel, before, "seed {seed}, flip {i} of {a}: refused");
            }
        }
        assert_eq!(violations(&dcel), [], "seed {seed}");
        assert!(dcel != start, "seed {seed}");
        dcel.undo(&mut journal, 0);
        assert_eq!(dcel, start, "seed {seed}");
    }
}

/// The grid of 5 columns with its points, from left to right and from below.
fn placed(mut table: Table) -> Table {
    for (i, row) in table.vertices.iter_mut().enumerate() {
        row.as_mut().unwrap().position = Some([(i % 6) as f64, (i / 6) as f64]);
    }
    table
}

#[test]
fn every_refusal_has_its_name_and_changes_nothing() {
    let zoo = zoo();
    let named = |name: &str| zoo.iter().find(|(n, _)| *n == name).unwrap().1.clone();
    let refused = |dcel: &Dcel, a: HalfEdgeId| {
        let mut after = dcel.clone();
        let error = after.flip_edge(a).unwrap_err();
        assert_eq!(&after, dcel);
        error
    };
    let (path, one_loop) = (named("a path of two edges"), named("a loop"));
    let (removed, tail) =
        (named("removed elements between live ones"), named("a loop alone in its face, with a tail outside"));
    let a = path.half_edges().next().unwrap();
    let error = refused(&path, a);
    assert_eq!(error, FlipEdgeError::SameFace { h: a, face: path.face(a) });
    assert!(error.to_string().ends_with("only an edge between two faces can be flipped"), "{error}");
    assert_eq!(refused(&one_loop, h(0)), FlipEdgeError::OneSidedFace { loop_edge: h(0), face: f(1) });
    let loop_edge = tail.half_edges().find(|&a| tail.next(a) == a).unwrap();
    let error = FlipEdgeError::OneSidedFace { loop_edge, face: tail.face(loop_edge) };
    assert_eq!([refused(&tail, loop_edge), refused(&tail, loop_edge.twin())], [error; 2]);
    let dead = (0..removed.half_edge_bound() as u32).map(h).find(|&a| !removed.has_half_edge(a)).unwrap();
    assert_eq!(refused(&removed, dead), FlipEdgeError::Id(IdError::Removed(Element::HalfEdge(dead))));
    assert!(matches!(refused(&removed, h(99)), FlipEdgeError::Id(IdError::OutOfRange { .. })));
}
