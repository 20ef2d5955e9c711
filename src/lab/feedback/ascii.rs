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

#[cfg(test)]
mod tests {
    use super::*;
    use dcel_kit::HalfEdgeId;
    use dcel_kit::topology::Dcel;

    /// A square that is cut in two, as it should be and with one wrong link.
    #[test]
    fn fields_stand_beside_what_they_were_and_cycles_say_whether_they_come_back() {
        let mut dcel = Dcel::polygon(4).unwrap();
        let before = Table::from_view(&dcel);
        let [a, b] = [0, 4].map(HalfEdgeId::new);
        dcel.split_face(a, b).unwrap();
        let expected = Table::from_view(&dcel);
        let mut yours = expected.clone();
        // Into the other cycle, which does not lead back.
        let other = (0..10).map(HalfEdgeId::new).find(|&h| expected.face(h) != expected.face(HalfEdgeId::new(8)));
        let at = yours.half_edges[8].as_mut().unwrap();
        (at.next, at.prev) = (other, other);
        let text = of(&before, &expected, &yours);
        let words = |line: &str| line.split_whitespace().map(str::to_owned).collect::<Vec<_>>();
        let lines: Vec<Vec<String>> = text.lines().map(words).collect();
        let shown = |h: Option<HalfEdgeId>| h.unwrap().to_string();
        let both = |field: fn(&Table, HalfEdgeId) -> Option<HalfEdgeId>| {
            [&expected, &yours].map(|table| shown(field(table, HalfEdgeId::new(8))))
        };
        for (line, field, [right, wrong]) in [(1, "h8.next", both(Table::next)), (2, "h8.prev", both(Table::prev))] {
            assert_eq!(lines[line], [field, "-", &right, &wrong], "{text}");
        }
        // The cycle that the wrong link cuts short, as it was, should be, and is.
        let cycle = |table: &Table, f: u32| {
            let first = table.half_edge(FaceId::new(f)).unwrap();
            cycle(table, first).iter().map(ToString::to_string).collect::<Vec<_>>()
        };
        let face = expected.face(HalfEdgeId::new(8)).unwrap();
        let at = lines.iter().position(|line| line.first() == Some(&face.to_string())).unwrap();
        assert_eq!(lines[at + 1][1..], cycle(&expected, face.number()), "{text}");
        assert_eq!(lines[at + 1][0], "expected");
        assert!(lines[at + 2].join(" ").starts_with("yours h") && text.contains("and does not come back"), "{text}");
        assert_eq!(of(&expected, &expected, &expected), "");
    }

    #[test]
    fn a_cycle_that_is_too_long_for_a_line_is_cut_and_says_so() {
        let shown = |corners: usize| {
            let table = Table::from_view(&Dcel::polygon(corners).unwrap());
            walk(&table, FaceId::new(0))
        };
        for corners in [CYCLE - 1, CYCLE] {
            let line = shown(corners);
            assert!(line.split(' ').count() == corners && !line.contains('…'), "{line}");
        }
        for corners in [CYCLE + 1, CYCLE + 5] {
            let line = shown(corners);
            assert!(line.split(' ').count() == CYCLE + 1 && line.ends_with(" …"), "{line}");
        }
    }

    #[test]
    fn what_stood_there_before_is_that_of_the_same_field() {
        let before = Table::from_view(&Dcel::polygon(3).unwrap());
        let (mut expected, mut yours) = (before.clone(), before.clone());
        for (h, [should, is]) in [(0, [4, 2]), (2, [1, 3])] {
            expected.half_edges[h].as_mut().unwrap().next = Some(HalfEdgeId::new(should));
            yours.half_edges[h].as_mut().unwrap().next = Some(HalfEdgeId::new(is));
        }
        let text = of(&before, &expected, &yours);
        for h in [0, 2].map(HalfEdgeId::new) {
            let was = before.next(h).unwrap().to_string();
            let line = text.lines().find(|line| line.starts_with(&format!("{h}.next"))).unwrap();
            assert_eq!(line.split_whitespace().nth(1), Some(was.as_str()), "{text}");
        }
    }
}
