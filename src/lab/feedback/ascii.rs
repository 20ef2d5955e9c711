//! A failing call for a terminal: the fields that are not as they should be, and the cycles along `next`.
//!
//! ```text
//!                 before    expected  yours
//!   h7.prev       h5        h12       h5        <-
//!
//!   f1 before     h0 h2 h4 h6 h8 h10
//!      expected   h2 h4 h6 h13
//!      yours      h2 h4 h6 h8 h10 h0 ...
//! ```

use crate::checks::align::{Content, Difference, differences};
use crate::checks::walks::cycle;
use dcel_kit::FaceId;
use dcel_kit::topology::{Table, View};
use std::fmt::Write;

/// How many fields are listed.
const FIELDS: usize = 12;
/// How many half-edges of a cycle are listed.
const CYCLE: usize = 14;

/// The text; empty if nothing differs.
pub(super) fn of(before: &Table, expected: &Table, yours: &Table) -> String {
    let all = differences(expected, yours);
    let mut out = String::new();
    if all.is_empty() {
        return out;
    }
    let old = differences(expected, before);
    let _ = writeln!(out, "{:16}{:12}{:12}yours", "", "before", "expected");
    for difference in all.iter().take(FIELDS) {
        let name = difference.name();
        let was = was(&old, difference, before);
        let _ = writeln!(out, "{name:16}{was:12}{:12}{}", difference.expected.to_string(), difference.found);
    }
    if all.len() > FIELDS {
        let _ = writeln!(out, "… and {} more", all.len() - FIELDS);
    }
    let faces = expected.faces.len().max(yours.faces.len()) as u32;
    for f in (0..faces).map(FaceId::new) {
        let cycles = [before, expected, yours].map(|table| walk(table, f));
        if cycles[1] == cycles[2] {
            continue;
        }
        out.push('\n');
        for (i, (when, walk)) in ["before", "expected", "yours"].iter().zip(&cycles).enumerate() {
            let face = if i == 0 { f.to_string() } else { String::new() };
            let _ = writeln!(out, "{face:4}{when:12}{walk}");
        }
    }
    out
}

/// What stood in a field before the call: what the expected structure has, unless it differs from that.
fn was(old: &[Difference], wanted: &Difference, before: &Table) -> String {
    let exists = wanted.owner.is_none_or(|owner| match owner {
        dcel_kit::Element::Vertex(v) => before.has_vertex(v),
        dcel_kit::Element::HalfEdge(h) => before.has_half_edge(h),
        dcel_kit::Element::Face(f) => before.has_face(f),
        dcel_kit::Element::Edge(_) => false,
    });
    if !exists {
        return "-".to_owned();
    }
    let same = |d: &&Difference| d.owner == wanted.owner && d.field == wanted.field;
    let content: Content = old.iter().find(same).map_or(wanted.expected, |d| d.found);
    content.to_string()
}

fn walk(table: &Table, f: FaceId) -> String {
    if !table.has_face(f) {
        return "-".to_owned();
    }
    let Some(first) = table.half_edge(f) else { return "no half-edge is stored".to_owned() };
    let all = cycle(table, first);
    let names: Vec<String> = all.iter().take(CYCLE).map(ToString::to_string).collect();
    let closed = all.last().and_then(|&last| table.next(last)) == Some(first);
    let end = match (all.len() > CYCLE, closed) {
        (true, _) => " …",
        (false, true) => "",
        (false, false) => " and does not come back",
    };
    format!("{}{end}", names.join(" "))
}
