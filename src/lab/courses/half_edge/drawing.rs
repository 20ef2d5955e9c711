//! The drawing of the handout, made with the two splits: compared with the reference as a structure with positions,
//! and as a picture.

use crate::checks::walks::{self, cycle, half_edges};
use crate::fault::{Exchange, Fault, FaultKind, exchanges};
use crate::pictures::{self, Plain};
use crate::protocol::{Case, CaseAnswer};
use dcel_kit::plane::PlanarView;
use dcel_kit::script::Script;
use dcel_kit::topology::{IsomorphismOptions, Table, View, isomorphic_with, position_key, violations};
use dcel_kit::{Element, FaceId, HalfEdgeId, VertexId};
use std::collections::BTreeMap;

/// The graded tests: of the structure, and of the picture that the student's program makes of it.
pub(super) const TESTS: [&str; 2] = ["drawing", "drawing_svg"];
/// How many vertices or edges are named in a sentence.
const NAMED: usize = 4;

/// The calls that make the drawing, in the kit's own numbers.
const SCRIPT: &str = include_str!("drawing.dcels");

/// The structure of the drawing; `None` only if its script were broken.
pub(super) fn reference() -> Option<Table> {
    let drawing = Script::parse(SCRIPT, "lab-04-drawing.dcels").ok()?.run().end;
    let mut table = Table::from_view(&drawing);
    for (v, row) in table.vertices.iter_mut().enumerate() {
        let place = drawing.position(VertexId::new(v as u32))?;
        row.as_mut()?.position = Some([place.x, place.y]);
    }
    Some(table)
}

/// Judges the structure that was drawn, and the picture of it.
pub(super) fn judge(case: &Case, answer: &CaseAnswer) -> Vec<Fault> {
    let mut all: Vec<Fault> = exchanges(case, answer).iter().flat_map(faults).collect();
    if let Some(reference) = reference() {
        all.extend(pictures::judge_case(TESTS[1], case, answer, || plain_picture(&reference)));
    }
    all
}

/// The drawing as the student's program should draw it, with the coordinates that it writes: y points down in a file.
/// (The reference figure shows the same in px of its canvas, which would be strange numbers in a message.)
fn plain_picture(table: &Table) -> String {
    let mut out = Plain::new("-270 -170 540 340");
    let at = |h: HalfEdgeId| table.origin(h).map(|v| place(table, v)).unwrap_or_default();
    for (f, row) in table.faces.iter().enumerate() {
        let boundary =
            row.as_ref().and_then(|row| row.half_edge).filter(|_| table.outer_face != Some(FaceId::new(f as u32)));
        if let Some(h) = boundary {
            out.face(cycle(table, h).into_iter().map(at));
        }
    }
    for h in half_edges(table) {
        if let Some(twin) = table.twin(h).filter(|&twin| h < twin) {
            out.edge(at(h), at(twin));
        }
    }
    (0..table.vertices.len() as u32).for_each(|v| out.vertex(place(table, VertexId::new(v))));
    out.svg()
}

fn faults(exchange: &Exchange) -> Vec<Fault> {
    let fault = |kind: FaultKind, rule: &str, words: String, elements: Vec<Element>| Fault {
        elements,
        ..Fault::new(TESTS[0], kind, exchange.step, [rule, ""], words)
    };
    let (Some((_, end)), Some(after)) = (exchange.called, exchange.after()) else { return Vec::new() };
    if let Some(kind) = FaultKind::of_end(end) {
        return vec![fault(kind, "drawing", format!("drawing {}", end.words()), Vec::new())];
    }
    let Some(reference) = &reference() else {
        let words = "the reference of the drawing is missing from the lab".to_owned();
        return vec![fault(FaultKind::GraderFault, "drawing", words, Vec::new())];
    };
    let wrong = |rule: &str, words, elements| fault(FaultKind::Wrong, rule, words, elements);
    let broken = violations(after.as_ref());
    if let Some(first) = broken.first() {
        return vec![wrong(first.rule.id, first.text().to_owned(), first.elements.clone())];
    }
    let keys = [after.as_ref(), reference].map(|table| move |v: VertexId| position_key(place(table, v)));
    let options = IsomorphismOptions::new().keys(&keys[0], &keys[1]);
    let Err(difference) = isomorphic_with(after.as_ref(), reference, &options) else { return Vec::new() };
    let mut out = Vec::new();
    for (one, several) in [("vertex", "vertices"), ("edge", "edges")] {
        let places = if one == "vertex" { vertices } else { edges };
        let [yours, theirs] = [after.as_ref(), reference].map(places);
        let rule = format!("drawing.{several}");
        out.extend(missing(&theirs, &yours).map(|(n, list, _)| {
            wrong(&rule, format!("{n} of the drawing's {several} {} missing: {list}", are(n)), Vec::new())
        }));
        out.extend(missing(&yours, &theirs).map(|(n, list, elements)| {
            let what = if n == 1 { one } else { several };
            wrong(&rule, format!("{n} {what} {} not in the drawing: {list}", are(n)), elements)
        }));
    }
    if out.is_empty() {
        out.push(wrong("drawing.structure", difference.to_string(), Vec::new()));
    }
    out
}

fn are(count: usize) -> &'static str {
    if count == 1 { "is" } else { "are" }
}

fn place(table: &Table, v: VertexId) -> [f64; 2] {
    walks::place(table, v).unwrap_or_default()
}

/// Places with the element that is there, in the order of the places.
type Places = BTreeMap<Vec<[u64; 2]>, (String, Element)>;

fn vertices(table: &Table) -> Places {
    let ids = (0..table.vertices.len() as u32).map(VertexId::new);
    ids.map(|v| {
        let [x, y] = place(table, v);
        (vec![position_key([x, y])], (format!("({x}, {y})"), v.into()))
    })
    .collect()
}

fn edges(table: &Table) -> Places {
    let all = half_edges(table);
    all.filter_map(|h| {
        let [p, q] = [table.origin(h)?, table.origin(table.twin(h)?)?].map(|v| place(table, v));
        // Each edge once, by its half that begins further left, or lower.
        let key = [p, q].map(position_key).to_vec();
        let words = format!("({}, {})–({}, {})", p[0], p[1], q[0], q[1]);
        (p < q).then(|| (key, (words, h.into())))
    })
    .collect()
}

/// What of `all` is not in `there`: how many, the first few in words, the elements.
fn missing(all: &Places, there: &Places) -> Option<(usize, String, Vec<Element>)> {
    let gone: Vec<&(String, Element)> =
        all.iter().filter(|(key, _)| !there.contains_key(*key)).map(|(_, v)| v).collect();
    let words: Vec<&str> = gone.iter().take(NAMED).map(|(words, _)| words.as_str()).collect();
    let more = if gone.len() > NAMED { ", …" } else { "" };
    let elements = gone.iter().map(|(_, element)| *element).collect();
    (!gone.is_empty()).then(|| (gone.len(), format!("{}{more}", words.join(", ")), elements))
}
