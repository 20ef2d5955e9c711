//! Equality up to numbers: found wherever it holds, refused wherever it does not, with the first difference named.

use crate::common::script::{Call, Log, all_calls, config, scripts};
use crate::common::{Random, brute, f, garbage, h, planar, renumbered, row, triangle_grid, v, zoo};
use cpu_time::ThreadTime;
use dcel_kit::topology::{
    Dcel, Difference, FaceRow, HalfEdgeRow, InnerComponent, IsomorphismOptions, Matching, NoRecorder, Table, VertexRow,
    View, Which, isomorphic, isomorphic_with, position_key,
};
use dcel_kit::{Element, VertexId};
use proptest::prelude::*;
use std::collections::{BTreeMap, BTreeSet};
use std::time::Duration;

/// Checks a matching pointer by pointer, against the two tables and nothing else.
fn assert_matching(a: &Table, b: &Table, to: &Matching, context: &str) {
    let mut taken = BTreeSet::new();
    for i in 0..a.vertices.len() as u32 {
        assert_eq!(to.vertices[v(i)].is_some(), a.has_vertex(v(i)), "{context}");
        assert!(to.vertices[v(i)].is_none_or(|x| b.has_vertex(x) && taken.insert(Element::Vertex(x))), "{context}");
    }
    for i in 0..a.half_edges.len() as u32 {
        let Some(there) = to.half_edges[h(i)] else {
            assert!(!a.has_half_edge(h(i)), "{context}: h{i} has no partner");
            continue;
        };
        assert!(taken.insert(there.into()), "{context}");
        let at = |x: Option<dcel_kit::HalfEdgeId>| to.half_edges[x.unwrap()];
        assert_eq!(at(a.next(h(i))), b.next(there), "{context}: h{i}.next");
        assert_eq!(at(a.prev(h(i))), b.prev(there), "{context}: h{i}.prev");
        assert_eq!(at(a.twin(h(i))), b.twin(there), "{context}: h{i}.twin");
        assert_eq!(to.vertices[a.origin(h(i)).unwrap()], b.origin(there), "{context}: h{i}.origin");
        assert_eq!(to.faces[a.face(h(i)).unwrap()], b.face(there), "{context}: h{i}.face");
    }
    for i in 0..a.faces.len() as u32 {
        let Some(there) = to.faces[f(i)] else {
            assert!(!a.has_face(f(i)), "{context}: f{i} has no partner");
            continue;
        };
        assert!(taken.insert(there.into()), "{context}");
        assert_eq!(a.is_hole(f(i)), b.is_hole(there), "{context}: f{i} hole");
        assert_eq!(a.outer_face == Some(f(i)), b.outer_face == Some(there), "{context}: f{i} outer");
        let isolated = |table: &Table, x| -> BTreeSet<VertexId> {
            let rings = table.inner_components(x).iter();
            rings.filter_map(|ring| if let InnerComponent::Isolated(y) = ring { Some(*y) } else { None }).collect()
        };
        let mapped: BTreeSet<VertexId> = isolated(a, f(i)).into_iter().map(|x| to.vertices[x].unwrap()).collect();
        assert_eq!(mapped, isolated(b, there), "{context}: isolated vertices of f{i}");
    }
    let counts = |t: &Table| {
        t.vertices.iter().flatten().count() + t.half_edges.iter().flatten().count() + t.faces.iter().flatten().count()
    };
    assert_eq!(taken.len(), counts(b), "{context}: not onto");
}

fn assert_same_after_renumbering(table: &Table, seed: u64, context: &str) {
    let other = renumbered(table, &mut Random(seed));
    match isomorphic(table, &other) {
        Ok(to) => assert_matching(table, &other, &to, context),
        Err(difference) => panic!("{context}, seed {seed}: {difference}"),
    }
}

proptest! {
    #![proptest_config(config(200))]

    #[test]
    fn every_structure_is_the_same_under_other_numbers((corners, ops) in scripts(40), seed in any::<u64>()) {
        let mut dcel = Dcel::polygon(corners as usize).unwrap();
        let mut log = Log::new(corners);
        for op in ops {
            let call = op.resolve(&dcel);
            log.add(call);
            let _ = call.apply(&mut dcel, &mut NoRecorder);
        }
        assert_same_after_renumbering(&Table::from_view(&dcel), seed, log.text());
    }

    /// Islands in faces in islands, some with isolated vertices, hole faces anywhere.
    #[test]
    fn nested_structures_are_the_same_under_other_numbers(seed in any::<u64>()) {
        let mut random = Random(seed);
        let table = random_islands(&mut random, 12);
        prop_assert!(brute::legal(&table), "seed {}", seed);
        assert_same_after_renumbering(&table, seed ^ 1, &format!("islands, seed {seed}"));
    }

    /// One island moved to another face, or one flag turned: equal exactly when the trees are.
    #[test]
    fn nested_structures_differ_as_their_trees_do(seed in any::<u64>()) {
        let mut random = Random(seed);
        let one = random_islands(&mut random, 5);
        let other = renumbered(&random_islands(&mut random, 5), &mut random);
        prop_assert_eq!(isomorphic(&one, &other).is_ok(), tree_code(&one) == tree_code(&other), "seed {}", seed);
    }
}

/// Polygons with 1 to 3 corners and isolated vertices, each put into a random face of what is there already.
fn random_islands(random: &mut Random, most: usize) -> Table {
    let mut table = planar(0, &[]);
    for _ in 0..random.below(most + 1) {
        let into = random.below(table.faces.len());
        if random.below(4) == 0 {
            table.vertices.push(Some(VertexRow::default()));
            let x = v(table.vertices.len() as u32 - 1);
            table.faces[into].as_mut().unwrap().inner_components.push(InnerComponent::Isolated(x));
        } else {
            put_polygon(&mut table, 1 + random.below(3), into);
            table.faces.last_mut().unwrap().as_mut().unwrap().hole = random.below(4) == 0;
        }
    }
    table
}

/// Adds a polygon as an island in face `into`; its inside is the new last face.
fn put_polygon(table: &mut Table, corners: usize, into: usize) {
    let polygon = Table::from_view(&Dcel::polygon(corners).unwrap());
    let (vs, hs) = (table.vertices.len() as u32, table.half_edges.len() as u32);
    let inside = f(table.faces.len() as u32);
    let shift = |a: dcel_kit::HalfEdgeId| h(a.number() + hs);
    table.vertices.extend(
        polygon.vertices.iter().map(|row| row.map(|row| VertexRow { outgoing: row.outgoing.map(shift), ..row })),
    );
    table.half_edges.extend(polygon.half_edges.iter().map(|row| {
        row.map(|row| HalfEdgeRow {
            origin: row.origin.map(|x| v(x.number() + vs)),
            twin: row.twin.map(shift),
            next: row.next.map(shift),
            prev: row.prev.map(shift),
            face: row.face.map(|x| if x == f(1) { inside } else { f(into as u32) }),
        })
    }));
    table.faces.push(Some(FaceRow { half_edge: Some(h(hs)), ..FaceRow::default() }));
    let face = table.faces[into].as_mut().unwrap();
    if table.outer_face == Some(f(into as u32)) && face.half_edge.is_none() {
        face.half_edge = Some(h(hs + 1));
    } else {
        face.inner_components.push(InnerComponent::Cycle(h(hs + 1)));
    }
}

/// A code of the nested islands that [`random_islands`] makes: for polygons their tree says everything.
fn tree_code(table: &Table) -> String {
    fn face(table: &Table, x: dcel_kit::FaceId) -> String {
        let outer = table.outer_face == Some(x);
        let first = table.half_edge(x).filter(|_| outer).map(InnerComponent::Cycle);
        let mut parts: Vec<String> = first
            .iter()
            .chain(table.inner_components(x))
            .map(|ring| match *ring {
                InnerComponent::Isolated(_) => "point".to_owned(),
                InnerComponent::Cycle(a) => {
                    let corners = dcel_kit::topology::bounded_cycle(table, a).count();
                    let inside = table.face(table.twin(a).unwrap()).unwrap();
                    format!("{corners}{}", face(table, inside))
                }
            })
            .collect();
        parts.sort();
        format!("{}[{}]", if table.is_hole(x) { "hole" } else { "" }, parts.join(" "))
    }
    face(table, table.outer_face.unwrap())
}

#[test]
fn small_structures_are_the_same_exactly_when_all_roots_tried_say_so() {
    let mut by_code: BTreeMap<Vec<[usize; 3]>, Vec<Dcel>> = BTreeMap::new();
    for corners in 1..=5 {
        let mut layer = vec![Dcel::polygon(corners).unwrap()];
        for depth in 0..=2 {
            let mut fresh = Vec::new();
            for dcel in layer {
                if depth < 2 {
                    for call in all_calls(&dcel) {
                        let mut after = dcel.clone();
                        if call.apply(&mut after, &mut NoRecorder).is_ok() {
                            fresh.push(after);
                        }
                    }
                }
                let kind = by_code.entry(brute::code(&dcel)).or_default();
                if kind.len() < 3 {
                    kind.push(dcel);
                }
            }
            layer = fresh;
        }
    }
    let kinds: Vec<&Vec<Dcel>> = by_code.values().collect();
    assert!(kinds.len() > 30, "{} kinds", kinds.len());
    for (i, one) in kinds.iter().enumerate() {
        for (j, other) in kinds.iter().enumerate() {
            for (a, b) in one.iter().flat_map(|a| other.iter().map(move |b| (a, b))) {
                let answer = isomorphic(a, b);
                assert_eq!(answer.is_ok(), i == j, "{a:?}\n{b:?}\n{answer:?}");
                if let Ok(to) = answer {
                    assert_matching(&Table::from_view(a), &Table::from_view(b), &to, "small structures");
                }
            }
        }
    }
}

#[test]
fn mirror_images_are_not_the_same() {
    // A square with a split corner, and its mirror image: three different corners in the other order.
    let faces = [vec![0, 1, 2, 3], vec![0, 3, 4], vec![3, 2, 5, 6]];
    let mirrored: Vec<Vec<u32>> = faces.iter().map(|corners| corners.iter().rev().copied().collect()).collect();
    let (one, other) = (planar(7, &faces), planar(7, &mirrored));
    assert!(brute::legal(&one) && brute::legal(&other));
    assert!(matches!(isomorphic(&one, &other), Err(Difference::Component { half_edges: 18, .. })));
}

#[test]
fn keys_fix_the_turn_that_symmetry_leaves_open() {
    let square = Dcel::polygon(4).unwrap();
    let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let key = |x: VertexId| position_key(corners[x.index()]);
    let turned = |x: VertexId| position_key(corners[(x.index() + 1) % 4]);
    let to = isomorphic_with(&square, &square, &IsomorphismOptions::new().keys(&key, &turned)).unwrap();
    for i in 0..4 {
        assert_eq!(to.vertices[v(i)], Some(v((i + 3) % 4)));
    }
    let moved = |x: VertexId| if x == v(2) { position_key([1.0, 1.5]) } else { key(x) };
    assert_eq!(
        isomorphic_with(&square, &square, &IsomorphismOptions::new().keys(&moved, &key)),
        Err(Difference::Unpaired { element: v(2).into(), which: Which::First, fixed: false })
    );
    // The same positions in another order round the square.
    let crossed = |x: VertexId| position_key(corners[[0, 2, 1, 3][x.index()]]);
    let error = isomorphic_with(&square, &square, &IsomorphismOptions::new().keys(&crossed, &key)).unwrap_err();
    assert!(matches!(error, Difference::Unpaired { .. } | Difference::Component { .. } | Difference::Pointer { .. }));
    assert_eq!(position_key([0.0, -0.0]), position_key([-0.0, 0.0]));
}

#[test]
fn fixed_elements_are_their_own_partners_and_new_ones_may_have_any_number() {
    // The oracle and the student make the same split, the student's new half-edges the other way round.
    let start = Dcel::polygon(6).unwrap();
    let (mut oracle, mut student) = (start.clone(), start.clone());
    oracle.split_face(h(0), h(6)).unwrap();
    student.split_face(h(6), h(0)).unwrap();
    let old = |element: Element| start.check(element).is_ok();
    let options = IsomorphismOptions::new().fixed(&old);
    // Which side keeps the old face differs, and f1 is fixed.
    let error = isomorphic_with(&student, &oracle, &options).unwrap_err();
    assert_eq!(error.to_string(), "h0.face = f2, which corresponds to nothing there (expected f1)");
    let mut swapped = Table::from_view(&student);
    for row in swapped.half_edges.iter_mut().flatten() {
        row.face = row.face.map(|x| if x == f(0) { x } else { f(3 - x.number()) });
    }
    swapped.faces.swap(1, 2);
    let to = isomorphic_with(&swapped, &oracle, &options).unwrap();
    assert!((0..12).all(|i| to.half_edges[h(i)] == Some(h(i))));
    assert_eq!((to.half_edges[h(12)], to.half_edges[h(13)]), (Some(h(13)), Some(h(12))));
    // A split at other corners looks alike, but not with the old elements fixed.
    let mut elsewhere = start.clone();
    elsewhere.split_face(h(2), h(8)).unwrap();
    assert_eq!(isomorphic(&elsewhere, &oracle).map(drop), Ok(()));
    let error = isomorphic_with(&elsewhere, &oracle, &options).unwrap_err();
    assert_eq!(error.to_string(), "h0.next = h12, which corresponds to nothing there (expected h2)");
}

#[test]
fn representatives_are_compared_on_request_only() {
    let square = Table::from_view(&Dcel::polygon(4).unwrap());
    let mut other = square.clone();
    other.faces[1].as_mut().unwrap().half_edge = Some(h(4));
    assert_eq!(isomorphic(&square, &other).map(drop), Ok(()));
    let options = IsomorphismOptions::new().representatives();
    // outgoing(v) = h0 h2 h4 h6: all turns keep it. half_edge(f1) moved by two, half_edge(f0) did not.
    assert!(isomorphic_with(&square, &other, &options).is_err());
    other.faces[0].as_mut().unwrap().half_edge = Some(h(5));
    let to = isomorphic_with(&square, &other, &options).unwrap();
    assert_eq!(to.half_edges[h(0)], Some(h(4)));
    other.vertices[3].as_mut().unwrap().outgoing = Some(h(5));
    assert!(isomorphic_with(&square, &other, &options).is_err());
}

#[test]
fn isolated_vertices_are_matched_by_their_keys_in_any_order() {
    let one = planar(6, &[vec![0, 1, 2]]);
    let mut other = one.clone();
    other.faces[0].as_mut().unwrap().inner_components.reverse();
    let key = |x: VertexId| [u64::from(x.number().max(2)), 0];
    let turned = |x: VertexId| [u64::from(if x.number() > 2 { 8 - x.number() } else { 2 }), 0];
    for (table, there) in [(&one, &key as &dyn Fn(VertexId) -> [u64; 2]), (&other, &key), (&one, &turned)] {
        let to = isomorphic_with(&one, table, &IsomorphismOptions::new().keys(&key, there)).unwrap();
        assert!((3..6).all(|i| there(to.vertices[v(i)].unwrap()) == key(v(i))));
    }
}

/// Vertices that no half-edge starts at and no face lists are matched by their keys alone.
#[test]
fn vertices_that_hang_on_nothing_are_told_apart_by_their_keys() {
    let mut one = planar(6, &[vec![0, 1, 2]]);
    one.outer_face = None;
    one.faces[0].as_mut().unwrap().inner_components.clear();
    let keys = |of: [u64; 3]| move |x: VertexId| [of.get(x.index().wrapping_sub(3)).copied().unwrap_or(9), 0];
    let here = keys([1, 2, 3]);
    for (there, alike) in [([3, 1, 2], true), ([1, 2, 4], false), ([1, 1, 2], false), ([1, 2, 3], true)] {
        let found = isomorphic_with(&one, &one, &IsomorphismOptions::new().keys(&here, &keys(there)));
        assert_eq!(found.is_ok(), alike, "{there:?}: {found:?}");
        let Ok(to) = found else { continue };
        assert!((3..6).all(|i| keys(there)(to.vertices[v(i)].unwrap()) == here(v(i))));
    }
}

/// `count` polygons with `corners` corners, each cut by diagonals from its first corner to the corners in `cut`.
fn many_islands(count: u32, corners: u32, cut: impl Fn(u32) -> Vec<u32>) -> Table {
    let mut faces = Vec::new();
    for island in 0..count {
        let at = |i: u32| island * corners + i;
        let mut from = 0;
        for to in cut(island).into_iter().chain([corners]) {
            let last = to.min(corners - 1);
            let middle = (from.max(1)..=last).map(at);
            faces.push([at(0)].into_iter().chain(middle).collect());
            from = to;
        }
    }
    planar((count * corners) as usize, &faces)
}

/// Guards against what is far worse than linear. Processor time: other work on the machine does not count.
fn within<T>(limit: Duration, what: &str, run: impl FnOnce() -> T) -> T {
    let start = ThreadTime::now();
    let result = run();
    let took = start.elapsed();
    println!("{what}: {took:?}");
    assert!(took < limit, "{what} took {took:?}");
    result
}

#[test]
fn many_alike_islands_are_interchangeable() {
    let limit = Duration::from_secs(5);
    let alike = many_islands(143, 30, |_| vec![5, 11]);
    within(limit, "143 equal islands", || assert_same_after_renumbering(&alike, 3, "equal islands"));
    let mixed = many_islands(143, 30, |i| vec![4 + i % 7, 15]);
    within(limit, "143 islands of seven kinds", || assert_same_after_renumbering(&mixed, 4, "mixed islands"));
    // One island of another kind among equal ones, with the same degrees and face lengths everywhere.
    let one = many_islands(143, 30, |i| if i == 77 { vec![5, 16] } else { vec![5, 11] });
    let other = many_islands(143, 30, |i| if i == 12 { vec![5, 16] } else { vec![5, 11] });
    let difference = many_islands(143, 30, |i| if i == 12 { vec![16, 22] } else { vec![5, 11] });
    let to = within(limit, "one odd island", || isomorphic(&one, &other)).unwrap();
    assert_matching(&one, &other, &to, "one odd island");
    assert!(within(limit, "one island differs", || isomorphic(&one, &difference)).is_err());
    let many = many_islands(20_000, 3, |_| vec![]);
    within(limit, "20,000 triangles", || assert_same_after_renumbering(&many, 5, "triangles"));
}

#[test]
fn deep_nesting_costs_no_more_than_its_size() {
    let chain = |depth: usize, last: usize| {
        let mut table = planar(0, &[]);
        for level in 0..depth {
            put_polygon(&mut table, if level + 1 == depth { last } else { 3 }, level);
        }
        table
    };
    let limit = Duration::from_secs(5);
    let deep = chain(20_000, 3);
    within(limit, "20,000 nested triangles", || assert_same_after_renumbering(&deep, 6, "nested"));
    // The same pieces, nested in another order: only the middle differs.
    let order = |swap: usize| {
        let mut table = planar(0, &[]);
        for level in 0..2_000 {
            put_polygon(&mut table, if level == swap { 4 } else { 3 }, level);
        }
        table
    };
    let error = within(limit, "2,000 nested in two orders", || isomorphic(&order(1_000), &order(1_001))).unwrap_err();
    assert!(matches!(error, Difference::Component { .. } | Difference::Content { .. }), "{error}");
    assert_eq!(isomorphic(&order(999), &renumbered(&order(999), &mut Random(8))).map(drop), Ok(()));
}

#[test]
fn large_grids_are_matched_without_positions() {
    let grid = triangle_grid(182, 182);
    assert!(grid.half_edges.len() / 2 > 99_000);
    let other = renumbered(&grid, &mut Random(9));
    let to = within(Duration::from_secs(10), "grid of 10^5 edges", || isomorphic(&grid, &other)).unwrap();
    assert_matching(&grid, &other, &to, "grid");
    let polygon = Dcel::polygon(100_000).unwrap();
    let turned = renumbered(&Table::from_view(&polygon), &mut Random(10));
    within(Duration::from_secs(10), "polygon of 10^5 edges", || isomorphic(&polygon, &turned)).unwrap();
}

#[test]
fn every_difference_says_what_differs_first() {
    let polygon = |n| Dcel::polygon(n).unwrap();
    let mut reached = BTreeSet::new();
    let mut says = |found: Result<Matching, Difference>, text: &str| {
        let difference = found.unwrap_err();
        assert_eq!(difference.to_string(), text);
        reached.insert(format!("{difference:?}").split(|c: char| !c.is_alphanumeric()).next().unwrap().to_owned());
    };
    says(isomorphic(&polygon(3), &polygon(4)), "3 vertices, expected 4");
    let mut split = polygon(4);
    split.split_face(h(0), h(4)).unwrap();
    says(isomorphic(&split, &polygon(4)), "5 edges, expected 4");
    let plane = Table { outer_face: Some(f(0)), ..Table::from_view(&polygon(3)) };
    says(isomorphic(&plane, &polygon(3)), "1 outer face, expected 0");
    let mut broken = plane.clone();
    row(&mut broken, h(2)).prev = None;
    says(isomorphic(&broken, &plane), "the first structure is broken: R1: h2.prev = none");
    says(isomorphic(&plane, &broken), "the second structure is broken: R1: h2.prev = none");

    let (mut one, mut other) = (polygon(6), polygon(6));
    one.split_face(h(0), h(4)).unwrap();
    other.split_face(h(0), h(6)).unwrap();
    says(isomorphic(&one, &other), "1 face with 3 half-edges, expected 0");
    let fan = planar(6, &[vec![0, 1, 2], vec![0, 2, 3], vec![0, 3, 4, 5]]);
    let parallel = planar(6, &[vec![0, 1, 2], vec![3, 4, 5], vec![0, 2, 3, 5]]);
    says(isomorphic(&fan, &parallel), "3 vertices of degree 2, expected 2");

    let keyed = |x: VertexId| [u64::from(x.number()), 0];
    let others = |x: VertexId| [u64::from(x.number()) + 1, 0];
    let options = IsomorphismOptions::new().keys(&keyed, &others);
    says(
        isomorphic_with(&polygon(3), &polygon(3), &options),
        "v0 of the first structure has no vertex like it in the second: key, position or state differ",
    );
    let removed = |_: Element| true;
    let mut gone = polygon(4);
    gone.split_edge(h(0)).unwrap();
    gone.join_edges(h(2)).unwrap();
    says(
        isomorphic_with(&gone, &polygon(4), &IsomorphismOptions::new().fixed(&removed)),
        "v4 is to stay what it is, but is not the same vertex in both structures",
    );
    let faces = [vec![0, 1, 2, 3], vec![0, 3, 4], vec![3, 2, 5, 6]];
    let mirrored: Vec<Vec<u32>> = faces.iter().map(|corners| corners.iter().rev().copied().collect()).collect();
    let difference = isomorphic(&planar(7, &faces), &planar(7, &mirrored));
    says(difference, "the component of h0 (18 half-edges) and what lies in its faces has no counterpart");
    let mut points = [planar(5, &[vec![0, 1, 2]]), planar(5, &[vec![0, 1, 2]])];
    let ring = points[0].faces[0].as_mut().unwrap().inner_components.pop().unwrap();
    points[0].faces[1].as_mut().unwrap().inner_components.push(ring);
    says(
        isomorphic(&points[0], &points[1]),
        "the component of h0 (6 half-edges) and what lies in its faces has no counterpart",
    );
    // Of three islands in f0 the first is there too, so the second one, which begins with h10, is named.
    let islands = |odd: usize| {
        let mut table = planar(0, &[]);
        for island in 0..3 {
            put_polygon(&mut table, 3, 0);
            put_polygon(&mut table, if island == odd { 1 } else { 2 }, 2 * island + 1);
        }
        table.vertices.push(Some(VertexRow::default()));
        let into = if odd == 2 { 3 } else { 1 };
        table.faces[into]
            .as_mut()
            .unwrap()
            .inner_components
            .push(InnerComponent::Isolated(v(table.vertices.len() as u32 - 1)));
        table
    };
    says(
        isomorphic(&islands(2), &islands(0)),
        "the component of h10 (6 half-edges) and what lies in its faces has no counterpart",
    );
    let keyed = [two_pairs(), two_pairs()];
    let keys = [0, 1].map(|i| move |x: VertexId| [u64::from(x.number() >= 6) * (i + u64::from(x.number())) % 2, 0]);
    let options = IsomorphismOptions::new().keys(&keys[0], &keys[1]);
    assert_eq!(isomorphic(&keyed[0], &keyed[1]).map(drop), Ok(()));
    says(isomorphic_with(&keyed[0], &keyed[1], &options), "what lies in f0 has no counterpart");
    let circle = two_loops_in_a_circle();
    assert!(brute::legal(&circle));
    says(
        isomorphic(&circle, &circle),
        "f0 joins components in a circle, which cannot be so in the plane: such structures are not compared",
    );
    let source = include_str!("../../src/topology/isomorphism/difference.rs");
    let body = source.split("pub enum Difference {").nth(1).unwrap().split("\n}").next().unwrap();
    let names = body.lines().filter_map(|line| line.strip_prefix("    "));
    let names = names.filter(|line| line.starts_with(|c: char| c.is_ascii_uppercase()));
    let all: BTreeSet<String> = names.map(|line| line.trim_end_matches(" {").to_owned()).collect();
    reached.insert("Pointer".to_owned()); // in fixed_elements_are_their_own_partners_and_new_ones_may_have_any_number
    assert_eq!(reached, all);
}

/// A sphere with two loops and a point in f0, and one with two digons and a point in f3. The loops have the
/// vertices v0 and v1, the digons v2 to v5, the points v6 and v7.
fn two_pairs() -> Table {
    let mut table = planar(0, &[]);
    table.outer_face = None;
    put_polygon(&mut table, 1, 0);
    put_polygon(&mut table, 1, 0);
    table.faces.push(Some(FaceRow::default()));
    put_polygon(&mut table, 2, 3);
    put_polygon(&mut table, 2, 3);
    for (face, point) in [(0, 6), (3, 7)] {
        table.vertices.push(Some(VertexRow::default()));
        let face = table.faces[face].as_mut().unwrap();
        let InnerComponent::Cycle(first) = face.inner_components.remove(0) else { panic!("no cycle") };
        face.half_edge = Some(first);
        face.inner_components.push(InnerComponent::Isolated(v(point)));
    }
    table
}

/// Two loops that both border f0 on one side and f1 on the other, as two rings of a torus do.
fn two_loops_in_a_circle() -> Table {
    let mut table = Table::from_view(&Dcel::polygon(1).unwrap());
    put_polygon(&mut table, 1, 0);
    table.faces.pop();
    row(&mut table, h(2)).face = Some(f(1));
    table.faces[1].as_mut().unwrap().inner_components.push(InnerComponent::Cycle(h(2)));
    table
}

/// In the second structure alone, loops join both faces: in the first each loop has the same face on both sides.
#[test]
fn a_face_of_a_circle_in_the_second_structure_is_named_by_its_number_there() {
    let circle = two_loops_in_a_circle();
    let mut apart = circle.clone();
    row(&mut apart, h(1)).face = Some(f(1));
    row(&mut apart, h(2)).face = Some(f(0));
    apart.faces[0].as_mut().unwrap().half_edge = Some(h(2));
    apart.faces[1].as_mut().unwrap().inner_components = vec![InnerComponent::Cycle(h(1))];
    assert_eq!(isomorphic(&apart, &circle), Err(Difference::Undecided { face: f(0) }));
}

#[test]
fn broken_views_are_refused_and_never_hang() {
    for seed in 0..3_000 {
        let (one, other) = (garbage(&mut Random(seed)), garbage(&mut Random(seed + 1)));
        let legal = [&one, &other].map(brute::legal);
        match isomorphic(&one, &other) {
            Err(Difference::Broken { which, .. }) => {
                assert!(!legal[usize::from(which == Which::Second)], "seed {seed}");
            }
            _ => assert_eq!(legal, [true, true], "seed {seed}"),
        }
    }
}

#[test]
fn a_matching_of_zoo_animals_with_themselves_exists_and_with_others_does_not() {
    let zoo = zoo();
    for (i, (name, one)) in zoo.iter().enumerate() {
        for (j, (other_name, other)) in zoo.iter().enumerate() {
            let expected = brute::code(one) == brute::code(other);
            assert_eq!(isomorphic(one, other).is_ok(), expected, "{name} and {other_name}");
            assert!(expected || i != j);
        }
    }
    let mut dcel = Dcel::polygon(4).unwrap();
    Call::SplitEdge(h(0)).apply(&mut dcel, &mut NoRecorder).unwrap();
    assert_eq!(isomorphic(&dcel, &Dcel::polygon(5).unwrap()).map(drop), Ok(()));
}
