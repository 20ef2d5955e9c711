//! Edits back to text: what a failing test prints, and anybody can run again.
//!
//! ```text
//!   split_face h2 h8       let a1 = split_face h2 h8
//!   split_in_half h12      let a2 = split_in_half a1
//!   join_edges h13         join_edges a2.twin.next
//! ```

use super::edit::Edit;
use crate::ids::{EdgeId, Element, HalfEdgeId};
use crate::plane::{Point, Subdivision};
use crate::topology::{Change, Journal};
use std::collections::BTreeMap;
use std::fmt::Write;

/// The script that starts with the polygon of these corners and makes these calls, refused ones too.
///
/// Half-edges that edits make are written by names (`a1` for what the first edit made, `a1.twin`). A call of a
/// half-edge that does not exist at its turn cannot be said in words; it becomes a comment.
///
/// Cost: that of the edits.
#[must_use]
pub fn of_edits(corners: &[Point], edits: &[Edit]) -> String {
    let mut out = "polygon".to_owned();
    for p in corners {
        let _ = write!(out, " {} {}", p.x, p.y);
    }
    out.push('\n');
    let Ok(mut subdivision) = Subdivision::polygon(corners) else { return out };
    let mut words: BTreeMap<EdgeId, Option<usize>> = subdivision.edges().map(|e| (e, None)).collect();
    let mut first: BTreeMap<usize, HalfEdgeId> = BTreeMap::new();
    for (i, &edit) in edits.iter().enumerate() {
        let word = |h: &HalfEdgeId| match *words.get(&h.edge())? {
            None => Some(h.to_string()),
            Some(name) if first.get(&name) == Some(h) => Some(format!("a{name}")),
            Some(name) => Some(format!("a{name}.twin")),
        };
        let Some(arguments) = edit.half_edges().iter().map(word).collect::<Option<Vec<_>>>() else {
            let _ = writeln!(out, "# {edit}: no such half-edge");
            continue;
        };
        let mut call = format!("{} {}", edit.kind().word(), arguments.join(" "));
        if let Edit::SplitEdge(_, p) = edit {
            let _ = write!(call, " {} {}", p.x, p.y);
        }
        let mut journal = Journal::new();
        let Ok(returned) = edit.apply(&mut subdivision, &mut journal) else {
            let _ = writeln!(out, "{call}   # refused");
            continue;
        };
        for change in journal.changes() {
            match *change {
                Change::Removed { element: Element::Edge(e) } => drop(words.remove(&e)),
                Change::Added { element: Element::Edge(e), .. } => drop(words.insert(e, Some(i + 1))),
                _ => {}
            }
        }
        if let Some(h) = returned.half_edge() {
            first.insert(i + 1, h);
            let _ = write!(out, "let a{} = ", i + 1);
        }
        let _ = writeln!(out, "{call}");
    }
    out
}
