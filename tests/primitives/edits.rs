//! Vertex splits and joins against cyclic lists that are cut and glued, and against each other.

use crate::common::{Random, h, v, zoo};
use dcel_kit::topology::{
    Dcel, IsomorphismOptions, Journal, NoRecorder, Table, isomorphic, isomorphic_with, measure, violations,
};
use dcel_kit::{Element, HalfEdgeId};
use std::collections::BTreeMap;

type Half = HalfEdgeId;

/// The zoo, the torus seed, and what random edits make of both.
fn starts() -> Vec<(String, Dcel)> {
    let mut all: Vec<(String, Dcel)> = zoo().into_iter().map(|(name, d)| (name.to_owned(), d)).collect();
    all.push(("the torus seed".to_owned(), Dcel::torus()));
    for seed in 0..24 {
        let (name, mut d) = all[seed as usize % 13].clone();
        let mut script = Script::new(seed);
        for _ in 0..6 {
            script.edit(&mut d, &mut NoRecorder).ok();
        }
        all.push((format!("{name}, seed {seed}: {}", script.log), d));
    }
    all
}

/// Random edits of all kinds. The log can be typed in again.
struct Script {
    random: Random,
    log: String,
}

impl Script {
    fn new(seed: u64) -> Self {
        Self { random: Random(seed), log: String::new() }
    }

    fn half_edge(&mut self, d: &Dcel) -> Half {
        h(self.random.below(d.half_edge_bound() + 1) as u32)
    }

    /// One edit; whether it was accepted, and what its `can_...` had said.
    fn edit(&mut self, d: &mut Dcel, rec: &mut impl dcel_kit::topology::Recorder) -> Result<(), String> {
        fn text<T, E: ToString>(result: Result<T, E>) -> Result<(), String> {
            result.map(drop).map_err(|e| e.to_string())
        }
        let kind = self.random.below(12);
        let a = self.half_edge(d);
        let mut b = self.half_edge(d);
        if d.has_half_edge(a) && self.random.below(4) > 0 {
            let steps = self.random.below(8);
            b = match kind {
                0..=4 => (0..steps).fold(a, |x, _| d.ccw(x)),
                _ => (0..steps).fold(a, |x, _| d.next(x)),
            };
        }
        let (name, can, done) = match kind {
            0..=4 => ("split_vertex", text(d.can_split_vertex(a, b)), text(d.split_vertex_with(a, b, rec))),
            5..=7 => ("split_face", text(d.can_split_face(a, b)), text(d.split_face_with(a, b, rec))),
            8 => ("join_vertices", text(d.can_join_vertices(a)), text(d.join_vertices_with(a, rec))),
            9 => ("join_faces", text(d.can_join_faces(a)), text(d.join_faces_with(a, rec))),
            10 => ("collapse_edge", text(d.can_collapse_edge(a)), text(d.collapse_edge_with(a, rec))),
            _ => ("split_edge", text(d.can_split_edge(a)), text(d.split_edge_with(a, rec))),
        };
        self.log.push_str(&format!("{name} {a} {b}\n"));
        assert_eq!(can, done, "can_{name} says otherwise in\n{}", self.log);
        done
    }
}

/// Every face as a list of its half-edges, and where each half-edge starts: no next, no prev.
#[derive(Clone, PartialEq, Eq, Debug)]
struct Lists {
    faces: BTreeMap<u32, Vec<Half>>,
    origin: BTreeMap<Half, u32>,
}

impl Lists {
    fn of(d: &Dcel) -> Self {
        let faces = d.faces().map(|f| (f.number(), d.incident_half_edges(f).collect()));
        Self { faces: faces.collect(), origin: d.half_edges().map(|a| (a, d.origin(a).number())).collect() }.normal()
    }

    /// A cycle has no first half-edge: let it begin with the smallest.
    fn normal(mut self) -> Self {
        for list in self.faces.values_mut() {
            let at = (0..list.len()).min_by_key(|&i| list[i]).unwrap_or(0);
            list.rotate_left(at);
        }
        self
    }

    fn before(&self, a: Half) -> Half {
        let list = self.faces.values().find(|list| list.contains(&a)).unwrap();
        let at = list.iter().position(|&b| b == a).unwrap();
        list[(at + list.len() - 1) % list.len()]
    }

    fn insert_after(&mut self, at: Half, new: Half) {
        let list = self.faces.values_mut().find(|list| list.contains(&at)).unwrap();
        let place = list.iter().position(|&b| b == at).unwrap();
        list.insert(place + 1, new);
    }

    fn split_vertex(&mut self, first: Half, last: Half, a: Half, m: u32) {
        self.origin.extend([(a, self.origin[&first]), (a.twin(), m)]);
        let mut moving = first;
        while moving != last {
            let following = self.before(moving).twin();
            self.origin.insert(moving, m);
            moving = following;
        }
        self.insert_after(first.twin(), a.twin());
        self.insert_after(last.twin(), a);
    }

    fn join_vertices(&mut self, a: Half) {
        let (u, m) = (self.origin[&a], self.origin[&a.twin()]);
        self.faces.values_mut().for_each(|list| list.retain(|b| b.edge() != a.edge()));
        self.faces.retain(|_, list| !list.is_empty());
        self.origin.retain(|b, _| b.edge() != a.edge());
        self.origin.values_mut().filter(|x| **x == m).for_each(|x| *x = u);
    }
}

fn pairs(d: &Dcel) -> Vec<(Half, Half)> {
    d.half_edges().flat_map(|a| d.half_edges().map(move |b| (a, b))).collect()
}

#[test]
fn a_vertex_split_is_the_cutting_and_gluing_of_lists() {
    let mut accepted = [0; 3];
    for (name, before) in starts() {
        for (first, last) in pairs(&before) {
            let context = format!("{name}, split_vertex {first} {last}");
            let mut after = before.clone();
            let Ok((a, m)) = after.split_vertex(first, last) else {
                assert_ne!(before.origin(first), before.origin(last), "{context}");
                continue;
            };
            assert!(!before.has_half_edge(a) && !before.has_vertex(m), "{context}: not new");
            assert_eq!((after.origin(a), after.destination(a)), (before.origin(first), m), "{context}");
            let mut lists = Lists::of(&before);
            lists.split_vertex(first, last, a, m.number());
            let moved = lists.origin.values().filter(|&&x| x == m.number()).count() - 1;
            assert_eq!(Lists::of(&after), lists.normal(), "{context}");
            assert_eq!(violations(&after), [], "{context}");
            assert_eq!(measure(&after).closed_euler(), measure(&before).closed_euler(), "{context}");
            accepted[moved.min(2)] += 1;
        }
    }
    assert!(accepted.iter().all(|&n| n > 100), "{accepted:?}: none, one, more moved");
}

#[test]
fn a_vertex_join_is_the_cutting_and_gluing_of_lists() {
    let mut accepted = 0;
    for (name, before) in starts() {
        for a in before.half_edges() {
            let context = format!("{name}, join_vertices {a}");
            let mut after = before.clone();
            let Ok(gone) = after.join_vertices(a) else {
                assert_eq!(before.origin(a), before.destination(a), "{context}");
                continue;
            };
            accepted += 1;
            assert_eq!(gone, before.destination(a), "{context}");
            assert!(!after.has_vertex(gone) && !after.has_edge(a.edge()), "{context}");
            let mut lists = Lists::of(&before);
            lists.join_vertices(a);
            assert_eq!(Lists::of(&after), lists.normal(), "{context}");
            assert_eq!(violations(&after), [], "{context}");
            assert_eq!(measure(&after).closed_euler(), measure(&before).closed_euler(), "{context}");
        }
    }
    assert!(accepted > 200, "{accepted}");
}

/// The same elements and pointers under the same numbers, apart from the stored half-edges.
fn assert_restored(after: &Dcel, before: &Dcel, context: &str) {
    assert_eq!(Lists::of(after), Lists::of(before), "{context}");
    let everything = |_: Element| true;
    let same = isomorphic_with(after, before, &IsomorphismOptions::new().fixed(&everything));
    assert!(same.is_ok(), "{context}: {}", same.unwrap_err());
    assert_eq!(violations(after), [], "{context}");
}

#[test]
fn join_vertices_undoes_split_vertex() {
    for (name, before) in starts() {
        for (first, last) in pairs(&before) {
            let mut after = before.clone();
            let Ok((a, m)) = after.split_vertex(first, last) else { continue };
            let context = format!("{name}, split_vertex {first} {last}, join_vertices {a}");
            assert!(isomorphic(&after, &before).is_err(), "{context}: a split must show");
            assert_eq!(after.join_vertices(a), Ok(m), "{context}");
            assert_restored(&after, &before, &context);
        }
    }
}

#[test]
fn split_vertex_undoes_join_vertices() {
    for (name, before) in starts() {
        for a in before.half_edges() {
            let (t, context) = (a.twin(), format!("{name}, join_vertices {a}, split"));
            // The range to move back, and the first one to stay; one of them is missing at the tip of a spur.
            let (first, last) = (before.ccw(t), before.ccw(a));
            let mut after = before.clone();
            if after.join_vertices(a).is_err() {
                continue;
            }
            let corner = if first == t { last } else { first };
            let undone = match (first == t, last == a) {
                (true, true) => after.split_isolated_vertex(before.origin(a)).map(|(b, _)| b),
                (false, false) => after.split_vertex(first, last).map(|(b, _)| b),
                _ => after.split_vertex(corner, corner).map(|(b, _)| b),
            };
            assert_eq!(undone.expect(&context).edge(), a.edge(), "the freed slot comes back first, {context}");
            assert_eq!(isomorphic(&after, &before).map(drop), Ok(()), "{context}");
        }
    }
}

#[test]
fn one_half_edge_moved_is_a_split_edge() {
    for (name, before) in starts() {
        for a in before.half_edges().filter(|&a| before.degree(before.origin(a)) > 1) {
            let (mut by_vertex, mut by_edge) = (before.clone(), before.clone());
            let (new, m) = by_vertex.split_vertex(a, before.ccw(a)).unwrap();
            by_edge.split_edge(a).unwrap();
            assert_eq!(isomorphic(&by_vertex, &by_edge).map(drop), Ok(()), "{name}, {a}");
            assert_eq!((by_vertex.next(new), by_vertex.origin(a)), (a, m), "{name}, {a}: the new half comes first");
        }
    }
}

#[test]
fn a_spur_stands_in_the_corner_clockwise_beside_its_argument() {
    let mut square = Dcel::polygon(4).unwrap();
    let (a, _) = square.split_vertex(h(0), h(0)).unwrap();
    // h0 runs from v0 along f1; its twin h1 bounds f0.
    assert_eq!((square.origin(a), square.prev(a), square.next(a)), (v(0), h(1), a.twin()));
    assert_eq!(square.face(a), square.face(h(1)));
}

#[test]
fn a_point_gets_a_spur_and_is_a_point_again() {
    let before = Dcel::from_triangles(2, &[]).unwrap().dcel;
    let mut after = before.clone();
    let (a, face) = after.split_isolated_vertex(v(1)).unwrap();
    assert_eq!((after.origin(a), after.destination(a), after.half_edge(face)), (v(1), v(2), Some(a)));
    assert_eq!(violations(&after), []);
    assert_eq!(measure(&after).closed_euler(), 4);
    assert_eq!(after.join_vertices(a), Ok(v(2)));
    assert_eq!((after.outgoing(v(1)), after.has_face(face), after.edge_count()), (None, false, 0));
    assert_eq!(violations(&after), []);
}

/// Undo gives every bit back, a refused call changes none, and the changes written into a table one by one give
/// the structure.
#[test]
fn journals_of_random_scripts_replay_and_undo() {
    let mut accepted = 0;
    for seed in 0..150 {
        let (name, start) = starts().swap_remove(seed as usize % 13);
        let (mut d, mut journal, mut script) = (start.clone(), Journal::new(), Script::new(1000 + seed));
        let mut table = Table::from_view(&d);
        for _ in 0..30 {
            let (before, mark) = (d.clone(), journal.len());
            let steps = journal.steps().len();
            let done = script.edit(&mut d, &mut journal);
            let context = format!("{name}, seed {seed}:\n{}", script.log);
            if done.is_err() {
                assert_eq!(d, before, "{context}");
                assert_eq!((journal.len(), journal.steps().len()), (mark, steps), "{context}");
                continue;
            }
            accepted += 1;
            let numbers: Vec<u32> = journal.steps()[steps..].iter().map(|step| step.number).collect();
            assert_eq!(numbers, (1..=numbers.len() as u32).collect::<Vec<_>>(), "{context}");
            assert_eq!(violations(&d), [], "{context}");
            journal.changes()[mark..].iter().for_each(|change| table.apply(change));
            let rows = |t: &Table| {
                let live = |x: &Table| x.faces.iter().flatten().cloned().collect::<Vec<_>>();
                (t.half_edges.iter().flatten().copied().collect::<Vec<_>>(), live(t))
            };
            assert_eq!(rows(&table), rows(&Table::from_view(&d)), "{context}");
            let mut back = d.clone();
            back.undo(&mut journal.clone(), mark);
            assert_eq!(back, before, "{context}");
        }
        d.undo(&mut journal, 0);
        assert_eq!(d, start, "{name}, seed {seed}:\n{}", script.log);
    }
    assert!(accepted > 1500, "{accepted}");
}
