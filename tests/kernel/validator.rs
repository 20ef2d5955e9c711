//! The validator finds every broken invariant, calls nothing broken that is not, and never panics, hangs or walks far.

use crate::common::{Random, brute, f, garbage, h, planar, row, triangle_grid, v};
use cpu_time::ThreadTime;
use dcel_kit::topology::{
    Dcel, HalfEdgeRow, InnerComponent, Rule, Table, VertexRow, View, first_violation, violations, visit_violations,
};
use dcel_kit::{Element, FaceId, HalfEdgeId, Id, VertexId};
use std::cell::Cell;
use std::collections::BTreeSet;
use std::ops::ControlFlow;
use std::time::Duration;

fn texts(table: &Table) -> Vec<String> {
    violations(table).iter().map(ToString::to_string).collect()
}

/// A triangle: h0 h2 h4 inside f1, h1 h3 h5 outside in f0, corners v0 v1 v2.
fn triangle() -> Table {
    Table::from_view(&Dcel::polygon(3).unwrap())
}

/// The same in the plane.
fn plane_triangle() -> Table {
    Table { outer_face: Some(f(0)), ..triangle() }
}

/// Two squares with a common side, an island in the outer face, an isolated vertex, and a hole face.
fn islands() -> Table {
    let faces = [vec![0, 1, 4, 3], vec![1, 2, 5, 4], vec![6, 7, 8]];
    let mut table = planar(10, &faces);
    table.faces[2].as_mut().unwrap().hole = true;
    table
}

/// A triangle with a triangle inside; f1 is between them and has one ring, f2 is inside.
fn nested() -> Table {
    let mut table = planar(6, &[vec![0, 1, 2], vec![3, 4, 5]]);
    let Some(InnerComponent::Cycle(inner)) = table.faces[0].as_mut().unwrap().inner_components.pop() else {
        panic!("no island")
    };
    let mut at = inner;
    for _ in 0..3 {
        row(&mut table, at).face = Some(f(1));
        at = row(&mut table, at).next.unwrap();
    }
    table.faces[1].as_mut().unwrap().inner_components.push(InnerComponent::Cycle(inner));
    table
}

#[test]
fn legal_structures_break_no_law() {
    for (name, dcel) in crate::common::zoo() {
        assert!(brute::legal(&Table::from_view(&dcel)), "{name}");
        assert_eq!(texts(&Table::from_view(&dcel)), [""; 0], "{name}");
    }
    assert_eq!(texts(&dual_of_polygon(5)), [""; 0]);
    let empty_plane = planar(0, &[]);
    let points = planar(3, &[]);
    for table in [Table::default(), empty_plane, points, islands(), nested(), triangle_grid(4, 3)] {
        assert!(brute::legal(&table));
        assert_eq!(texts(&table), [""; 0]);
    }
}

/// Each rule with the smallest structure that breaks it, and every line the validator has to say about it.
#[test]
fn every_rule_is_reached_and_says_what_it_found() {
    let mut reached = BTreeSet::new();
    let mut says = |table: &Table, lines: &[&str]| {
        assert_eq!(texts(table), lines);
        assert!(!brute::legal(table), "{lines:?}: the second opinion finds no fault");
        reached.extend(lines.iter().map(|line| line.split(':').next().unwrap().to_owned()));
    };
    let broken = |edit: fn(&mut Table)| {
        let mut table = triangle();
        edit(&mut table);
        table
    };
    let in_plane = |mut table: Table, edit: fn(&mut Table)| {
        edit(&mut table);
        table
    };

    says(&broken(|t| row(t, h(2)).next = None), &["R1: h2.next = none"]);
    says(&broken(|t| row(t, h(2)).next = Some(h(9))), &["R2: h2.next = h9, but h9 does not exist"]);
    says(&broken(|t| row(t, h(2)).origin = Some(v(7))), &["R2: h2.origin = v7, but v7 does not exist"]);
    says(&broken(|t| row(t, h(2)).face = Some(f(2))), &["R2: h2.face = f2, but f2 does not exist"]);
    says(
        &broken(|t| t.vertices[1].as_mut().unwrap().outgoing = Some(h(6))),
        &["R2: v1.outgoing = h6, but h6 does not exist"],
    );
    says(
        &broken(|t| t.faces[0].as_mut().unwrap().half_edge = Some(h(6))),
        &["R2: f0.half_edge = h6, but h6 does not exist"],
    );
    says(
        &broken(|t| {
            t.faces[0].as_mut().unwrap().inner_components =
                vec![InnerComponent::Cycle(h(6)), InnerComponent::Isolated(v(3))];
        }),
        &["R2: f0.inner_component = h6, but h6 does not exist", "R2: f0.inner_component = v3, but v3 does not exist"],
    );
    says(&broken(|t| t.outer_face = Some(f(2))), &["R2: outer_face = f2, but f2 does not exist"]);
    says(
        &broken(|t| t.faces[0] = None),
        &[
            "R2: h1.face = f0, but f0 does not exist",
            "R2: h3.face = f0, but f0 does not exist",
            "R2: h5.face = f0, but f0 does not exist",
        ],
    );
    says(
        &broken(|t| row(t, h(0)).twin = Some(h(0))),
        &["T1: h0.twin = h0 (expected another half-edge)", "T2: h1.twin = h0, but h0.twin = h0 (expected h1)"],
    );
    says(
        &broken(|t| row(t, h(0)).twin = Some(h(3))),
        &["T2: h0.twin = h3, but h3.twin = h2 (expected h0)", "T2: h1.twin = h0, but h0.twin = h3 (expected h1)"],
    );
    says(
        &broken(|t| row(t, h(2)).prev = Some(h(4))),
        &["N2: h0.next = h2, but h2.prev = h4 (expected h0)", "N1: h2.prev = h4, but h4.next = h0 (expected h2)"],
    );
    says(
        &broken(|t| row(t, h(2)).origin = Some(v(0))),
        &[
            "D1: h0.next = h2, but h2.origin = v0 (expected v1, the origin of h0.twin = h1)",
            "D1: h3.next = h1, but h1.origin = v1 (expected v0, the origin of h3.twin = h2)",
            "O1: v1.outgoing = h2, but h2.origin = v0 (expected v1)",
        ],
    );
    says(
        &broken(|t| row(t, h(2)).face = Some(f(0))),
        &[
            "F1: h0.next = h2, but h2.face = f0 (expected f1, the face of h0)",
            "F1: h2.next = h4, but h4.face = f1 (expected f0, the face of h2)",
        ],
    );
    says(
        &broken(|t| t.faces[1].as_mut().unwrap().half_edge = Some(h(5))),
        &["B1: f1.half_edge = h5, but h5.face = f0 (expected f1)"],
    );
    says(
        &broken(|t| t.faces[1].as_mut().unwrap().half_edge = None),
        &["B2: f1.half_edge = none (expected a half-edge of f1; only an outer face may have none)"],
    );
    says(
        &in_plane(plane_triangle(), |t| {
            let face = t.faces[0].as_mut().unwrap();
            face.inner_components.extend(face.half_edge.take().map(InnerComponent::Cycle));
        }),
        &[
            "B2: f0.half_edge = none, although f0 has a cycle among its inner components (expected the first of its cycles)",
        ],
    );
    says(
        &broken(|t| t.vertices[1].as_mut().unwrap().outgoing = Some(h(4))),
        &["O1: v1.outgoing = h4, but h4.origin = v2 (expected v1)"],
    );
    says(
        &broken(|t| t.vertices[1].as_mut().unwrap().outgoing = None),
        &["O2: v1.outgoing = none, but h1.origin = v1 (expected h1 or another one that starts there)"],
    );
    // Two vertices made one: v5 of the island becomes v0.
    let mut one_vertex = planar(6, &[vec![0, 1, 2], vec![3, 4, 5]]);
    one_vertex.vertices[5] = None;
    one_vertex.outer_face = None;
    for a in 0..12 {
        let row = row(&mut one_vertex, h(a));
        row.origin = row.origin.map(|x| if x == v(5) { v(0) } else { x });
    }
    says(
        &one_vertex,
        &["S1: the round of v0 through h8 misses h5, h10 (expected one round of all half-edges that start at v0)"],
    );
    let mut unlisted = triangle();
    unlisted.faces.push(unlisted.faces[1].clone());
    unlisted.faces[2].as_mut().unwrap().half_edge = Some(h(1));
    unlisted.faces[0].as_mut().unwrap().inner_components.clear();
    for a in [1, 3, 5] {
        row(&mut unlisted, h(a)).face = Some(f(1));
    }
    says(
        &unlisted,
        &[
            "B1: f0.half_edge = h1, but h1.face = f1 (expected f0)",
            "B1: f2.half_edge = h1, but h1.face = f1 (expected f2)",
            "C1: the cycle h1, h5, h3 has face f1, but neither f1.half_edge nor an inner component of f1 lies on it",
        ],
    );
    says(
        &in_plane(plane_triangle(), |t| {
            t.faces[1].as_mut().unwrap().inner_components.push(InnerComponent::Cycle(h(4)));
        }),
        &["C2: f1 lists the cycle of h4 twice: as h0 and as h4 (expected once)"],
    );
    says(
        &in_plane(plane_triangle(), |t| {
            t.faces[1].as_mut().unwrap().inner_components.push(InnerComponent::Cycle(h(5)));
        }),
        &["C3: f1.inner_component = h5, but h5.face = f0 (expected f1)"],
    );
    says(
        &in_plane(plane_triangle(), |t| {
            t.faces[1].as_mut().unwrap().inner_components.push(InnerComponent::Isolated(v(2)));
        }),
        &["I1: f1 lists v2 as isolated, but v2.outgoing = h4 (expected none)"],
    );
    let lonely = |t: &mut Table| t.vertices.push(Some(VertexRow::default()));
    says(
        &in_plane(plane_triangle(), |t| {
            t.vertices.push(Some(VertexRow::default()));
            t.faces[0].as_mut().unwrap().inner_components.push(InnerComponent::Isolated(v(3)));
            t.faces[1].as_mut().unwrap().inner_components.push(InnerComponent::Isolated(v(3)));
        }),
        &["I2: v3 lies isolated in f0 and again in f1 (expected one of them)"],
    );
    says(
        &in_plane(plane_triangle(), lonely),
        &["I3: v3 has no edge, and no face lists it (expected one inner component)"],
    );
    says(
        &in_plane(plane_triangle(), |t| t.faces[0].as_mut().unwrap().hole = true),
        &["H1: f0 is the outer face and flagged as a hole face"],
    );
    says(
        &torus(),
        &["E1: the component of v0 has V - E + cycles = 1 - 2 + 1 = 0 (expected 2: genus 1 does not fit in the plane)"],
    );
    // The island is a ring of the outer face and of the face inside it.
    let mut swapped = nested();
    let face = swapped.faces[1].as_mut().unwrap();
    let InnerComponent::Cycle(ring) = face.inner_components[0] else { panic!("no ring") };
    face.inner_components[0] = InnerComponent::Cycle(face.half_edge.replace(ring).unwrap());
    says(
        &swapped,
        &[
            "E2: the component of v3 is not reached from the outer face inwards (expected to be an inner component of the face around it)",
        ],
    );
    // Two faces on both sides of a diagonal, made one face with a ring.
    let mut merged = planar(4, &[vec![0, 1, 2], vec![0, 2, 3]]);
    let ring = merged.faces[2].take().unwrap().half_edge.unwrap();
    merged.half_edges.iter_mut().flatten().filter(|row| row.face == Some(f(2))).for_each(|row| row.face = Some(f(1)));
    merged.faces[1].as_mut().unwrap().inner_components.push(InnerComponent::Cycle(ring));
    says(
        &merged,
        &[
            "E2: the inner component h3 of f1 belongs to the component of v0, which is listed already (expected one inner component for each component)",
        ],
    );

    let all: BTreeSet<String> = Rule::all().iter().map(|rule| rule.id.to_owned()).collect();
    assert_eq!(reached, all, "rules that are reached, and those there are");
}

/// One vertex, two loops, one face, the boundary a b a^-1 b^-1, and an outer face that is this one.
fn torus() -> Table {
    let cycle = [0_u32, 2, 1, 3];
    let mut table = Table { outer_face: Some(f(0)), ..Table::from_view(&Dcel::polygon(1).unwrap()) };
    table.half_edges = vec![None; 4];
    for i in 0..4 {
        let at = |step: usize| Some(h(cycle[(i + step) % 4]));
        table.half_edges[cycle[i] as usize] = Some(HalfEdgeRow {
            origin: Some(v(0)),
            twin: Some(h(cycle[i]).twin()),
            next: at(1),
            prev: at(3),
            face: Some(f(0)),
        });
    }
    table.faces.truncate(1);
    table.faces[0].as_mut().unwrap().half_edge = Some(h(0));
    table
}

#[test]
fn a_violation_carries_its_elements_its_chain_and_the_two_values() {
    let mut table = triangle();
    row(&mut table, h(2)).prev = Some(h(4));
    let all = violations(&table);
    let n2 = &all[0];
    assert_eq!((n2.rule.id, n2.rule.invariant), ("N2", "h.next.prev = h"));
    assert_eq!(n2.elements, [h(0), h(2), h(4)].map(Element::HalfEdge));
    assert_eq!(n2.chain, [h(0), h(2)]);
    assert_eq!((n2.found, n2.expected), (Some(h(4).into()), Some(h(0).into())));
    assert_eq!(first_violation(&table).as_ref(), Some(n2));
    let mut seen = Vec::new();
    let flow = visit_violations(&table, &mut |violation| {
        seen.push(violation.rule.id);
        ControlFlow::Break(())
    });
    assert_eq!((flow, &seen[..]), (ControlFlow::Break(()), &["N2"][..]));
}

#[test]
fn a_round_over_links_that_are_reported_already_is_not_judged() {
    // next of h0 and h4 swapped: by next alone v1 has two rounds, by prev one. N2 says it all.
    let mut swapped = dual_of_polygon(4);
    let [a, b] = [0, 4].map(|i| swapped.half_edges[i].unwrap().next);
    (row(&mut swapped, h(0)).next, row(&mut swapped, h(4)).next) = (b, a);
    let rules: Vec<&str> = violations(&swapped).iter().map(|violation| violation.rule.id).collect();
    assert_eq!(rules, ["N2", "N1", "N2", "N1", "F1", "F1"]);
}

#[test]
fn the_table_of_rules_in_the_docs_is_the_table_of_rules() {
    let docs = include_str!("../../src/topology/validate/mod.rs");
    let rows: Vec<&str> = docs.lines().filter_map(|line| line.strip_prefix("//! | ")).skip(1).collect();
    let rules: Vec<String> = Rule::all().iter().map(|rule| format!("{} | {} |", rule.id, rule.invariant)).collect();
    assert_eq!(rows, rules);
    for rule in Rule::all() {
        assert_eq!(Rule::by_id(rule.id), Some(rule));
        assert!(rule.explanation.ends_with('.'), "{}", rule.id);
    }
    assert_eq!(Rule::by_id("X9"), None);
}

/// Every table that differs from `table` in one pointer, with the pointer's name.
fn each_corruption(table: &Table, mut check: impl FnMut(&str, &Table)) {
    fn values<I: Id>(bound: usize) -> Vec<Option<I>> {
        (0..=bound).map(|i| (i <= bound).then(|| I::from_index(i))).chain([None]).collect()
    }
    let (vs, hs, fs) = (
        values::<VertexId>(table.vertices.len()),
        values::<HalfEdgeId>(table.half_edges.len()),
        values::<FaceId>(table.faces.len()),
    );
    let mut with = |name: String, edit: &dyn Fn(&mut Table)| {
        let mut copy = table.clone();
        edit(&mut copy);
        check(&name, &copy);
    };
    for a in (0..table.half_edges.len() as u32).map(h) {
        for &to in &vs {
            with(format!("{a}.origin = {to:?}"), &|t| row(t, a).origin = to);
        }
        for &to in &hs {
            with(format!("{a}.twin = {to:?}"), &|t| row(t, a).twin = to);
            with(format!("{a}.next = {to:?}"), &|t| row(t, a).next = to);
            with(format!("{a}.prev = {to:?}"), &|t| row(t, a).prev = to);
        }
        for &to in &fs {
            with(format!("{a}.face = {to:?}"), &|t| row(t, a).face = to);
        }
        with(format!("no {a}"), &|t| t.half_edges[a.index()] = None);
    }
    for x in 0..table.vertices.len() {
        for &to in &hs {
            with(format!("v{x}.outgoing = {to:?}"), &|t| t.vertices[x].as_mut().unwrap().outgoing = to);
        }
        with(format!("no v{x}"), &|t| t.vertices[x] = None);
    }
    for x in 0..table.faces.len() {
        for &to in &hs {
            with(format!("f{x}.half_edge = {to:?}"), &|t| t.faces[x].as_mut().unwrap().half_edge = to);
            if let Some(a) = to {
                with(format!("f{x}.inner_component {a}"), &|t| {
                    t.faces[x].as_mut().unwrap().inner_components.push(InnerComponent::Cycle(a));
                });
                for i in 0..table.faces[x].as_ref().unwrap().inner_components.len() {
                    with(format!("f{x}.inner_components[{i}] = {a}"), &|t| {
                        t.faces[x].as_mut().unwrap().inner_components[i] = InnerComponent::Cycle(a);
                    });
                }
            }
        }
        for i in 0..table.faces[x].as_ref().unwrap().inner_components.len() {
            with(format!("f{x}.inner_components without {i}"), &|t| {
                t.faces[x].as_mut().unwrap().inner_components.remove(i);
            });
        }
        for a in vs.iter().copied().flatten() {
            with(format!("f{x}.inner_component {a}"), &|t| {
                t.faces[x].as_mut().unwrap().inner_components.push(InnerComponent::Isolated(a));
            });
        }
        with(format!("f{x}.hole"), &|t| t.faces[x].as_mut().unwrap().hole ^= true);
        with(format!("no f{x}"), &|t| t.faces[x] = None);
    }
    for &to in &fs {
        with(format!("outer_face = {to:?}"), &|t| t.outer_face = to);
    }
    with("one more vertex".to_owned(), &|t| t.vertices.push(Some(VertexRow::default())));
}

fn agrees_with_the_second_opinion(name: &str, table: &Table) -> bool {
    let (lines, legal) = (texts(table), brute::legal(table));
    assert_eq!(lines.is_empty(), legal, "{name}: the second opinion says legal = {legal}, the validator {lines:#?}");
    legal
}

#[test]
fn every_single_corruption_is_found_unless_it_gives_another_legal_structure() {
    let (mut corruptions, mut legal) = (0, 0);
    for (name, table) in samples() {
        each_corruption(&table, |what, corrupted| {
            corruptions += 1;
            legal += usize::from(agrees_with_the_second_opinion(&format!("{name}, {what}"), corrupted));
        });
    }
    // Other representatives, unused pointers set to what they were, hole flags: legal, and there are such.
    assert!(corruptions > 5_000 && legal > 100, "{corruptions} {legal}");
}

fn samples() -> Vec<(&'static str, Table)> {
    let live = |dcel: &Dcel| dcel.half_edge_count() == dcel.half_edge_bound() && dcel.face_count() == dcel.face_bound();
    let small = crate::common::zoo().into_iter().filter(|(_, d)| d.half_edge_count() <= 12 && live(d));
    let small = small.map(|(name, dcel)| (name, Table::from_view(&dcel)));
    small.chain([("islands", islands()), ("nested", nested()), ("a plane triangle", plane_triangle())]).collect()
}

#[test]
fn two_corruptions_at_once_are_found_too() {
    let mut random = Random(7);
    for (name, table) in samples() {
        let mut broken = Vec::new();
        each_corruption(&table, |what, corrupted| {
            if random.below(200) == 0 {
                broken.push((what.to_owned(), corrupted.clone()));
            }
        });
        for (first, table) in broken {
            let rows_live = table.half_edges.iter().all(Option::is_some)
                && table.vertices.iter().all(Option::is_some)
                && table.faces.iter().all(Option::is_some);
            if rows_live {
                each_corruption(&table, |second, corrupted| {
                    agrees_with_the_second_opinion(&format!("{name}, {first}, {second}"), corrupted);
                });
            }
        }
    }
}

#[test]
fn random_garbage_is_judged_as_the_second_opinion_judges_it() {
    let mut legal = 0;
    for seed in 0..60_000 {
        let table = garbage(&mut Random(seed));
        legal += usize::from(agrees_with_the_second_opinion(&format!("garbage, seed {seed}"), &table));
    }
    assert!(legal > 0, "not one small legal table by chance");
}

/// Counts how often a view is asked.
struct Counting<'a>(&'a Table, Cell<usize>);

impl Counting<'_> {
    fn table(&self) -> &Table {
        self.1.set(self.1.get() + 1);
        self.0
    }
}

impl View for Counting<'_> {
    fn vertex_bound(&self) -> usize {
        self.table().vertex_bound()
    }
    fn half_edge_bound(&self) -> usize {
        self.table().half_edge_bound()
    }
    fn face_bound(&self) -> usize {
        self.table().face_bound()
    }
    fn has_vertex(&self, x: VertexId) -> bool {
        self.table().has_vertex(x)
    }
    fn has_half_edge(&self, a: HalfEdgeId) -> bool {
        self.table().has_half_edge(a)
    }
    fn has_face(&self, x: FaceId) -> bool {
        self.table().has_face(x)
    }
    fn origin(&self, a: HalfEdgeId) -> Option<VertexId> {
        self.table().origin(a)
    }
    fn twin(&self, a: HalfEdgeId) -> Option<HalfEdgeId> {
        self.table().twin(a)
    }
    fn next(&self, a: HalfEdgeId) -> Option<HalfEdgeId> {
        self.table().next(a)
    }
    fn prev(&self, a: HalfEdgeId) -> Option<HalfEdgeId> {
        self.table().prev(a)
    }
    fn face(&self, a: HalfEdgeId) -> Option<FaceId> {
        self.table().face(a)
    }
    fn outgoing(&self, x: VertexId) -> Option<HalfEdgeId> {
        self.table().outgoing(x)
    }
    fn half_edge(&self, x: FaceId) -> Option<HalfEdgeId> {
        self.table().half_edge(x)
    }
    fn inner_components(&self, x: FaceId) -> &[InnerComponent] {
        self.table().inner_components(x)
    }
    fn outer_face(&self) -> Option<FaceId> {
        self.table().outer_face
    }
    fn is_hole(&self, x: FaceId) -> bool {
        self.table().is_hole(x)
    }
}

/// Structures that make careless walks long: many starts into one tail, many listings of one cycle, many loops.
fn hostile(n: u32) -> Vec<(&'static str, Table)> {
    let vertices = vec![Some(VertexRow { position: None, outgoing: Some(h(0)) }); n as usize];
    let face = |boundary| Some(dcel_kit::topology::FaceRow { half_edge: Some(boundary), ..Default::default() });
    let chain = |next: &dyn Fn(u32) -> u32, prev: &dyn Fn(u32) -> u32, origin: &dyn Fn(u32) -> u32| Table {
        vertices: vertices.clone(),
        half_edges: (0..n)
            .map(|i| {
                Some(HalfEdgeRow {
                    origin: Some(v(origin(i))),
                    twin: Some(h(i ^ 1)),
                    next: Some(h(next(i))),
                    prev: Some(h(prev(i))),
                    face: Some(f(i % 7)),
                })
            })
            .collect(),
        faces: (0..n).map(|i| face(h(i))).collect(),
        outer_face: Some(f(0)),
    };
    let last = n - 1;
    let mut cycle = chain(&|i| (i + 1) % n, &|i| (i + last) % n, &|_| 0);
    cycle.half_edges.iter_mut().flatten().for_each(|row| row.face = Some(f(0)));
    cycle.faces[0].as_mut().unwrap().inner_components = (0..n).map(|i| InnerComponent::Cycle(h(i))).collect();
    // Sound all round but for one place, so that the walks do run, and end nowhere.
    let mut cut_open = Table::from_view(&Dcel::polygon(n as usize).unwrap());
    row(&mut cut_open, h(2 * last)).next = None;
    row(&mut cut_open, h(1)).next = None;
    let mut fan_open = dual_of_polygon(n);
    row(&mut fan_open, h(2 * last)).twin = None;
    vec![
        ("a polygon cut open", cut_open),
        ("a star cut open", fan_open),
        ("a tail into its own end", chain(&|i| (i + 1).min(last), &|i| i.saturating_sub(1), &|i| i)),
        (
            "everything into the tail",
            chain(&|i| if i < n / 2 { n / 2 } else { (i + 1).min(last) }, &|i| i / 2, &|i| i / 2),
        ),
        ("one long cycle listed by every face and ring", cycle),
        ("n loops at one vertex", chain(&|i| i, &|i| i, &|_| 0)),
        ("n loops everywhere", chain(&|i| i, &|i| i, &|i| i)),
    ]
}

/// `n` edges between two vertices: n faces with two half-edges each, h(2i) from v0 to v1.
fn dual_of_polygon(n: u32) -> Table {
    let half = |i: u32| {
        // h(2i) is followed by h(2i + 3), the back of the next edge.
        let (edge, back) = (i / 2, i % 2);
        let other = if back == 0 { 2 * ((edge + 1) % n) + 1 } else { 2 * ((edge + n - 1) % n) };
        HalfEdgeRow {
            origin: Some(v(back)),
            twin: Some(h(i ^ 1)),
            next: Some(h(other)),
            prev: Some(h(other)),
            face: Some(f(if back == 0 { edge } else { (edge + n - 1) % n })),
        }
    };
    let face = |i: u32| dcel_kit::topology::FaceRow { half_edge: Some(h(2 * i)), ..Default::default() };
    Table {
        vertices: [0, 1].map(|a| Some(VertexRow { position: None, outgoing: Some(h(a)) })).to_vec(),
        half_edges: (0..2 * n).map(|i| Some(half(i))).collect(),
        faces: (0..n).map(|i| Some(face(i))).collect(),
        outer_face: None,
    }
}

#[test]
fn the_work_is_linear_on_hostile_views() {
    for i in 0..7 {
        let [small, large] = [1_000, 8_000].map(|n| {
            let (name, table) = hostile(n).swap_remove(i);
            let view = Counting(&table, Cell::new(0));
            let all = violations(&view);
            assert!(!all.is_empty() && !brute_is_legal_if_small(n, &table), "{name}");
            let walked: usize = all.iter().map(|violation| violation.chain.len() + violation.elements.len()).sum();
            assert!(walked <= 40 * n as usize, "{name}: the chains hold {walked} half-edges");
            view.1.get()
        });
        assert!(large <= 8 * small + 100, "{i}: {small} calls for 1,000 half-edges, {large} for 8,000");
    }
    // Calls of the view are not all the work: 200,000 half-edges would take minutes if anything were quadratic.
    let start = ThreadTime::now();
    for (name, table) in hostile(200_000) {
        assert!(first_violation(&table).is_some(), "{name}");
        let mut count = 0_usize;
        let _ = visit_violations(&table, &mut |_| {
            count += 1;
            ControlFlow::Continue(())
        });
        assert!(count > 0, "{name}");
    }
    assert!(start.elapsed() < Duration::from_secs(20), "{:?}", start.elapsed());
}

fn brute_is_legal_if_small(n: u32, table: &Table) -> bool {
    n <= 1_000 && brute::legal(table)
}
