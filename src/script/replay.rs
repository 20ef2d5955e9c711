//! Edits back to text: what a failing test prints, and anybody can run again.
//!
//! ```text
//!   split_face h2 h8       let a1 = split_face h2 h8
//!   split_in_half h12      let a2 = split_in_half a1
//!   join_edges h13         join_edges a2.twin.next
//! ```

use super::edit::{Edit, EditKind};
use super::ground::{Call, Ground};
use super::kernel::{KernelEdit, KernelStart};
use crate::ids::{EdgeId, Element, HalfEdgeId, VertexId};
use crate::plane::{Point, Subdivision};
use crate::topology::{Change, Journal};
use std::collections::BTreeMap;

/// The script that starts with the polygon of these corners and makes these calls, refused ones too.
///
/// Half-edges that edits make are written by names (`a1` for what the first edit made, `a1.twin`). A call of a
/// half-edge that does not exist at its turn cannot be said in words; it becomes a comment.
///
/// Cost: that of the edits.
#[must_use]
pub fn of_edits(corners: &[Point], edits: &[Edit]) -> String {
    let start: Vec<String> = corners.iter().map(|p| format!(" {} {}", p.x, p.y)).collect();
    let start = format!("polygon{}", start.concat());
    match Subdivision::polygon(corners) {
        Ok(subdivision) => Writer::write(start, subdivision, edits),
        Err(_) => start + "\n",
    }
}

/// The script without coordinates that makes these calls; otherwise as [`of_edits`].
///
/// ```
/// use dcel_kit::HalfEdgeId;
/// use dcel_kit::script::{KernelEdit, KernelStart, of_kernel_edits};
/// let [h0, h4] = [0, 4].map(HalfEdgeId::new);
/// let edits = [KernelEdit::SplitVertex(h0, h0), KernelEdit::JoinVertices(h4)];
/// assert_eq!(of_kernel_edits(&KernelStart::Torus, &edits), "torus\nlet a1 = split_vertex h0 h0\njoin_vertices a1\n");
/// ```
#[must_use]
pub fn of_kernel_edits(start: &KernelStart, edits: &[KernelEdit]) -> String {
    match start.build() {
        Ok(dcel) => Writer::write(start.to_string(), dcel, edits),
        Err(_) => format!("{start}\n"),
    }
}

/// A script while it is being written.
struct Writer<G> {
    ground: G,
    lines: Vec<String>,
    /// By edge: the edit that made it; none for those of the start.
    edges: BTreeMap<EdgeId, Option<usize>>,
    /// By edit: the half-edge that its name means.
    named: BTreeMap<usize, HalfEdgeId>,
    vertices: BTreeMap<VertexId, Maker>,
}

/// Where a vertex comes from.
#[derive(Clone, Copy)]
enum Maker {
    Start,
    /// The edit with this number made it; its line is `line`, and `link` leads from the named half-edge there.
    Edit {
        number: usize,
        line: usize,
        link: &'static str,
    },
    /// The same, and the line after it gives the vertex a name.
    Named(usize),
}

impl<G: Ground> Writer<G> {
    fn write(start: String, ground: G, edits: &[G::Edit]) -> String {
        let edges = ground.topology().edges().map(|e| (e, None)).collect();
        let vertices = ground.topology().vertices().map(|v| (v, Maker::Start)).collect();
        let mut writer = Self { ground, lines: vec![start], edges, named: BTreeMap::new(), vertices };
        for (number, &edit) in (1..).zip(edits) {
            writer.edit(number, edit);
        }
        writer.lines.join("\n") + "\n"
    }

    fn edit(&mut self, number: usize, edit: G::Edit) {
        let words = edit.elements().iter().map(|&element| self.word(element)).collect::<Option<Vec<_>>>();
        let Some(words) = words else {
            let element = if edit.kind() == EditKind::SplitIsolatedVertex { "vertex" } else { "half-edge" };
            self.lines.push(format!("# {edit}: no such {element}"));
            return;
        };
        let mut call = format!("{} {}", edit.kind().word(), words.join(" "));
        if let Some(p) = edit.point() {
            call.push_str(&format!(" {} {}", p.x, p.y));
        }
        let mut journal = Journal::new();
        let Ok(returned) = self.ground.make(edit, &mut journal) else {
            self.lines.push(format!("{call}   # refused"));
            return;
        };
        let link = match edit.kind() {
            EditKind::SplitVertex | EditKind::SplitIsolatedVertex => "destination",
            _ => "origin",
        };
        let made = Maker::Edit { number, line: self.lines.len(), link };
        for change in journal.changes() {
            match *change {
                Change::Removed { element: Element::Edge(e) } => drop(self.edges.remove(&e)),
                Change::Added { element: Element::Edge(e), .. } => drop(self.edges.insert(e, Some(number))),
                Change::Removed { element: Element::Vertex(v) } => drop(self.vertices.remove(&v)),
                Change::Added { element: Element::Vertex(v), .. } => drop(self.vertices.insert(v, made)),
                _ => {}
            }
        }
        match returned.half_edge() {
            Some(h) => {
                self.named.insert(number, h);
                self.lines.push(format!("let a{number} = {call}"));
            }
            None => self.lines.push(call),
        }
    }

    /// How the script can name an element; `None` if it does not exist.
    fn word(&mut self, element: Element) -> Option<String> {
        match element {
            Element::HalfEdge(h) => Some(match *self.edges.get(&h.edge())? {
                None => h.to_string(),
                Some(number) if self.named.get(&number) == Some(&h) => format!("a{number}"),
                Some(number) => format!("a{number}.twin"),
            }),
            Element::Vertex(v) => {
                let maker = self.vertices.get_mut(&v)?;
                if let Maker::Edit { number, line, link } = *maker {
                    // By now the vertex may have lost the half-edge that leads there: it is named where it was made.
                    self.lines[line].push_str(&format!("\nlet p{number} = a{number}.{link}"));
                    *maker = Maker::Named(number);
                }
                Some(match *maker {
                    Maker::Named(number) | Maker::Edit { number, .. } => format!("p{number}"),
                    Maker::Start => v.to_string(),
                })
            }
            Element::Edge(_) | Element::Face(_) => None,
        }
    }
}
