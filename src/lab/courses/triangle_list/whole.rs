//! Judging `from_faces`: any list, whatever the numbers of the half-edges are, and one of 100,352 triangles.

use super::refused::built;
use super::soup::{Ends, Soup};
use crate::checks::faults::{Faults, named};
use crate::checks::walks::half_edges;
use crate::fault::{Exchange, Fault, FaultKind, exchanges};
use crate::protocol::{CallEnd, Case, CaseAnswer, Pattern, Reply, Step, Value, grouped};
use dcel_kit::topology::{Table, View};
use dcel_kit::{Element, FaceId, HalfEdgeId, VertexId};
use std::collections::{BTreeMap, BTreeSet};

/// How many cells the large list has in a row: 224 times 224, each of two triangles.
pub(super) const CELLS: u32 = 224;
/// How many reads each half-edge of the large list may take. The solution needs about 14.
const READS: u64 = 60;

/// What is wrong with a call of `from_faces`.
pub(super) fn from_faces(exchange: &Exchange, test: &'static str, faults: &mut Faults) -> Option<()> {
    let before = exchange.before()?;
    let soup = Soup::of_words(before.vertices.len(), exchange.words)?;
    built(exchange, &[test], &soup.refusals(), faults)?;
    compare(test, before, &soup, exchange.after()?, faults);
    Some(())
}

fn compare(test: &'static str, before: &Table, soup: &Soup, after: &Table, faults: &mut Faults) {
    let place = |table: &Table, v: usize| table.vertices[v].and_then(|row| row.position);
    if after.vertices.len() != before.vertices.len() {
        let words = format!("there are {} vertices, expected {}", after.vertices.len(), before.vertices.len());
        return faults.wrong(test, "from_faces.vertices", &words, &[]);
    }
    if let Some(v) = (0..after.vertices.len()).find(|&v| place(after, v) != place(before, v)) {
        let element = VertexId::new(v as u32);
        faults.wrong(test, "from_faces.position", &format!("{element} is not where its point is"), &[element.into()]);
    }
    let right = soup.half_edges();
    let counts = [after.faces.len(), after.half_edges.len()];
    if counts != [soup.faces.len() + 1, right.len()] || after.outer_face != Some(FaceId::new(0)) {
        let words = format!(
            "there are {} faces and {} half-edges, and the outer face is {}; expected {}, {} and f0",
            counts[0],
            counts[1],
            named(after.outer_face),
            soup.faces.len() + 1,
            right.len()
        );
        return faults.wrong(test, "from_faces.count", &words, &[]);
    }
    let ends_of = |h: HalfEdgeId| -> Option<Ends> {
        let twin = after.twin(h).filter(|&twin| after.twin(twin) == Some(h))?;
        Some([after.origin(h)?.number(), after.origin(twin)?.number()])
    };
    let mut of: BTreeMap<Ends, HalfEdgeId> = BTreeMap::new();
    for h in half_edges(after) {
        if !ends_of(h).is_some_and(|ends| right.contains_key(&ends) && of.insert(ends, h).is_none()) {
            let words = format!(
                "{h}, from {} with the twin {}, is none of the list",
                named(after.origin(h)),
                named(after.twin(h))
            );
            return faults.wrong(test, "from_faces.half_edge", &words, &[h.into()]);
        }
    }
    for (ends, &h) in &of {
        let right = right[ends];
        faults.field(test, "from_faces.next", (h, "next"), [after.next(h), Some(of[&right.next])]);
        faults.field(test, "from_faces.prev", (h, "prev"), [after.prev(h), Some(of[&right.prev])]);
        faults.field(test, "from_faces.face", (h, "face"), [after.face(h), Some(FaceId::new(right.face))]);
    }
    let mut knows = |element: Element, rule: &str, known: Option<HalfEdgeId>, right: bool, what: &str| {
        if !right {
            faults.wrong(test, rule, &format!("{element} knows {}, {what}", named(known)), &[element]);
        }
    };
    for f in (0..after.faces.len() as u32).map(FaceId::new) {
        let known = after.half_edge(f);
        let has = of.iter().any(|(ends, _)| right[ends].face == f.number());
        let is_right = known.and_then(|h| after.face(h)) == has.then_some(f);
        knows(f.into(), "from_faces.boundary", known, is_right, "no half-edge of its own");
    }
    for v in (0..after.vertices.len() as u32).map(VertexId::new) {
        let known = after.outgoing(v);
        let has = of.keys().any(|ends| ends[0] == v.number());
        let is_right = known.and_then(|h| after.origin(h)) == has.then_some(v);
        knows(v.into(), "from_faces.outgoing", known, is_right, "which does not start there");
    }
}

/// The large list: it is built, the reads are counted, and what came of it is counted.
pub(super) fn large_steps() -> [Step; 3] {
    [Step::call("from_cells", [CELLS]), Step::Reads, Step::of_line("summary")]
}

/// What is wrong with what was made of the large list.
pub(super) fn large(test: &'static str, case: &Case, answer: &CaseAnswer) -> Vec<Fault> {
    let n = u64::from(CELLS);
    let half_edges = 2 * (2 * n * (n + 1) + n * n);
    let all = exchanges(case, answer);
    let Some(first) = all.first() else { return Vec::new() };
    Faults::found(first, |faults| {
        let too_many = |reads: u64, so_far: &str| {
            let [reads, half_edges] = [reads, half_edges].map(grouped);
            format!(
                "looks at everything: {reads} reads{so_far} for {half_edges} half-edges, where a dozen for each would do"
            )
        };
        if let Some((_, CallEnd::Stopped(stopped))) = first.called
            && stopped.pattern != Pattern::Circle
        {
            let words = too_many(stopped.reads, " and not done,");
            faults.add(test, FaultKind::TooSlow { place: stopped.place.clone() }, "reads", &words, &[]);
            return None;
        }
        built(first, &[test], &BTreeSet::new(), faults)?;
        if let Some(Reply::Reads(reads)) = answer.replies.get(1)
            && *reads > READS * half_edges
        {
            let words = too_many(*reads, "");
            faults.add(test, FaultKind::TooSlow { place: None }, "reads", &words, &[]);
        }
        let values = faults.returned(all.get(1)?.called?.1, &[test])?;
        // Vertices, half-edges, faces, half-edges of the outer face, half-edges that break a rule.
        let expected = [(n + 1) * (n + 1), half_edges, 2 * n * n + 1, 4 * n, 0];
        let names = ["vertices", "half-edges", "faces", "half-edges of the outer face", "half-edges that break a rule"];
        for ((value, expected), name) in values.iter().zip(expected).zip(names) {
            if *value != Value::Id(expected as u32) {
                let words = format!("there are {} {name}, expected {}", value.words(), grouped(expected));
                faults.wrong(test, "from_cells.count", &words, &[]);
            }
        }
        Some(())
    })
}
