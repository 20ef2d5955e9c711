//! The specification of the two splits, written for tables, against the kit's own kernel.

use dcel_kit::topology::{Dcel, IsomorphismOptions, Table, isomorphic, isomorphic_with, violations};
use dcel_kit::{Element, FaceId, HalfEdgeId};
use dcel_lab::cases::random::Random;
use dcel_lab::checks::align::align;
use dcel_lab::checks::walks::{cycle, star};
use dcel_lab::courses::half_edge::classes::classes;
use dcel_lab::courses::half_edge::spec::{self, Legal, TwinSide, may_split_face};

fn table(dcel: &Dcel) -> Table {
    Table { outer_face: Some(FaceId::new(0)), ..Table::from_view(dcel) }
}

/// A random walk of splits; every step is made by both, from the kernel's structure.
#[test]
fn specification_and_kernel_agree_on_random_scripts() {
    for seed in 0..60 {
        let mut random = Random::new(seed, "kernel");
        let mut dcel = Dcel::polygon(3 + random.below(4)).unwrap();
        for _ in 0..12 {
            let before = table(&dcel);
            let half_edges = before.half_edges.len();
            let [h1, h2] = [0, 0].map(|_: usize| HalfEdgeId::new(random.below(half_edges) as u32));
            let is_old = |element: Element| match element {
                Element::Vertex(v) => v.index() < before.vertices.len(),
                Element::HalfEdge(h) => h.index() < half_edges,
                Element::Face(f) => f.index() < before.faces.len(),
                Element::Edge(_) => true,
            };
            let options = IsomorphismOptions::new().fixed(&is_old);
            if random.below(3) == 0 {
                let (expected, new) = spec::split_in_half(&before, h1, TwinSide::Moved).unwrap();
                dcel.split_edge(h1).unwrap();
                let after = table(&dcel);
                // The kernel's twin is h ^ 1, so the old twin stays with h1 and moves.
                assert!(isomorphic_with(&after, &expected, &options).is_ok(), "seed {seed}: split_in_half {h1}");
                let aligned = align(&expected, &new, &after);
                assert_eq!(aligned.differences, [], "seed {seed}: split_in_half {h1}");
                let (kept, _) = spec::split_in_half(&before, h1, TwinSide::Kept).unwrap();
                assert!(violations(&kept).is_empty() && isomorphic(&kept, &expected).is_ok(), "seed {seed}: {h1}");
            } else {
                let legal = may_split_face(&before, h1, h2);
                assert_eq!(
                    legal == Legal::Yes,
                    dcel.can_split_face(h1, h2).is_ok(),
                    "seed {seed}: {h1} {h2} {legal:?}"
                );
                let Some((expected, new)) = spec::split_face(&before, h1, h2) else { continue };
                dcel.split_face(h1, h2).unwrap();
                let after = table(&dcel);
                assert!(isomorphic_with(&after, &expected, &options).is_ok(), "seed {seed}: split_face {h1} {h2}");
                assert_eq!(align(&expected, &new, &after).differences, [], "seed {seed}: split_face {h1} {h2}");
            }
        }
    }
}

#[test]
fn new_elements_may_have_any_number() {
    let before = table(&Dcel::polygon(6).unwrap());
    let (expected, new) = spec::split_face(&before, HalfEdgeId::new(0), HalfEdgeId::new(6)).unwrap();
    let [a, b] = [new.half_edges[0], new.half_edges[1]];
    // The same structure with the two new half-edges the other way round.
    let other = |h: HalfEdgeId| {
        if h == a {
            b
        } else if h == b {
            a
        } else {
            h
        }
    };
    let mut swapped = expected.clone();
    swapped.half_edges.swap(a.index(), b.index());
    for row in swapped.half_edges.iter_mut().flatten() {
        for pointer in [&mut row.twin, &mut row.next, &mut row.prev] {
            *pointer = pointer.map(other);
        }
    }
    for row in swapped.faces.iter_mut().flatten() {
        row.half_edge = row.half_edge.map(other);
    }
    let aligned = align(&expected, &new, &swapped);
    assert_eq!((aligned.differences, aligned.new.half_edges), (Vec::new(), vec![b, a]));
    // One pointer wrong is one difference, not a bad match.
    swapped.half_edges[a.index()].as_mut().unwrap().prev = None;
    let aligned = align(&expected, &new, &swapped);
    assert_eq!(aligned.differences.len(), 1);
    assert_eq!(
        aligned.differences[0].to_string(),
        format!("{a}.prev is unset, expected {}", before.half_edges[6].unwrap().prev.unwrap())
    );
}

#[test]
fn a_broken_structure_is_compared_without_panic() {
    let (expected, new) =
        spec::split_face(&table(&Dcel::polygon(6).unwrap()), HalfEdgeId::new(0), HalfEdgeId::new(6)).unwrap();
    let mut random = Random::new(1, "broken");
    for _ in 0..300 {
        let mut yours = expected.clone();
        for _ in 0..4 {
            let at = random.below(yours.half_edges.len());
            let stray = [None, Some(HalfEdgeId::new(random.below(40) as u32)), Some(HalfEdgeId::new(u32::MAX - 1))];
            let row = yours.half_edges[at].as_mut().unwrap();
            let pointer = [&mut row.twin, &mut row.next, &mut row.prev].into_iter().nth(random.below(3)).unwrap();
            *pointer = stray[random.below(3)];
        }
        assert!(align(&expected, &new, &yours).differences.len() <= 8);
        for i in 0..40 {
            let h = HalfEdgeId::new(i);
            assert!(cycle(&yours, h).len() <= yours.half_edges.len());
            assert!(star(&yours, h).len() <= yours.half_edges.len() + 1);
            let _ = (spec::split_face(&yours, h, HalfEdgeId::new(3)), spec::split_in_half(&yours, h, TwinSide::Kept));
        }
    }
}

#[test]
fn there_is_one_structure_of_each_kind() {
    // Three splits of triangles, squares and pentagons: about as many as decisions B5 counts.
    assert_eq!([0, 1, 2, 3].map(|splits| classes(3..=5, splits).len()), [3, 6, 18, 46]);
    let all = classes(3..=5, 2);
    for (i, a) in all.iter().enumerate() {
        assert!(violations(a).is_empty());
        let anywhere = |table: &Table| Table { outer_face: None, ..table.clone() };
        assert!(all[..i].iter().all(|b| isomorphic(&anywhere(a), &anywhere(b)).is_err()), "{i}");
    }
}
