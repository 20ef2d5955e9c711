//! The records as tables of HTML, and one record in words.

use super::reply::{Selected, element};
use crate::figure::escaped;
use crate::ids::{Element, FaceId, HalfEdgeId, VertexId};
use crate::plane::PlanarView;
use crate::script::{Link, follow};
use crate::topology::{Table, View, has};
use std::collections::BTreeSet;
use std::fmt::Write;

/// A table has no more rows than this.
const ROWS: usize = 1000;

/// The pointers of a record, each with its name and what it leads to. Those of a half-edge are the five of the lab.
pub(super) fn pointers(table: &Table, element: Element) -> Vec<(&'static str, Option<Element>)> {
    let of = |links: &[Link]| links.iter().map(|&link| (link.word(), follow(table, element, link))).collect();
    match element {
        Element::HalfEdge(_) => of(&[Link::Origin, Link::Twin, Link::Next, Link::Prev, Link::Face]),
        Element::Vertex(_) => of(&[Link::Outgoing]),
        Element::Face(_) => of(&[Link::HalfEdge]),
        Element::Edge(e) => {
            let [h, twin] = e.half_edges();
            vec![("half_edge", Some(h.into())), ("twin", Some(twin.into()))]
        }
    }
}

/// What a pointer leads to.
pub(super) fn name(target: Option<Element>) -> String {
    target.map_or_else(|| "none".to_owned(), |target| target.to_string())
}

/// An element in words.
pub(super) fn describe(table: &Table, chosen: Element) -> Selected {
    let mut pointers: Vec<[String; 2]> =
        pointers(table, chosen).into_iter().map(|(pointer, to)| [pointer.to_owned(), name(to)]).collect();
    let title = match chosen {
        Element::HalfEdge(h) => {
            let [from, to] = [Link::Origin, Link::Destination].map(|link| name(follow(table, chosen, link)));
            format!("half-edge {h}, {from} to {to}")
        }
        Element::Vertex(v) => match table.position(v) {
            Some(p) => format!("vertex {v} at ({}, {})", p.x, p.y),
            None => format!("vertex {v}"),
        },
        Element::Face(f) if table.outer_face() == Some(f) => format!("face {f}, the outer face"),
        Element::Face(f) if table.is_hole(f) => format!("face {f}, a hole"),
        Element::Face(f) => format!("face {f}"),
        Element::Edge(e) => format!("edge {e}"),
    };
    if let Element::Face(f) = chosen {
        pointers.extend(inner_names(table, f).map(|name| ["inner".to_owned(), name]));
    }
    Selected { ids: vec![chosen.to_string()], title, pointers, ..Selected::default() }
}

fn inner_names(table: &Table, f: FaceId) -> impl Iterator<Item = String> + '_ {
    table.inner_components(f).iter().map(|&inner| Element::from(inner).to_string())
}

/// The three tables. Elements of `bad` are marked.
pub(super) fn html(table: &Table, bad: &BTreeSet<String>) -> String {
    let mut out = String::new();
    let half_edges = (0..table.half_edge_bound() as u32).map(HalfEdgeId::new).filter(|&h| table.has_half_edge(h));
    write(&mut out, table, "Half-edges", &["origin", "twin", "next", "prev", "face"], half_edges, bad, |_| Vec::new());
    let vertices = (0..table.vertex_bound() as u32).map(VertexId::new).filter(|&v| table.has_vertex(v));
    let place = |v: VertexId| match table.position(v) {
        Some(p) => vec![p.x.to_string(), p.y.to_string()],
        None => vec!["none".to_owned(), "none".to_owned()],
    };
    write(&mut out, table, "Vertices", &["outgoing", "x", "y"], vertices, bad, place);
    let faces = (0..table.face_bound() as u32).map(FaceId::new).filter(|&f| table.has_face(f));
    let rest = |f: FaceId| {
        let inner: Vec<String> = inner_names(table, f).collect();
        let name = table.faces.get(f.index()).and_then(|row| row.as_ref()?.name.clone());
        let kind = if table.outer_face() == Some(f) {
            "outer"
        } else if table.is_hole(f) {
            "hole"
        } else {
            ""
        };
        vec![
            if inner.is_empty() { "none".to_owned() } else { inner.join(" ") },
            name.unwrap_or_else(|| kind.to_owned()),
        ]
    };
    write(&mut out, table, "Faces", &["half_edge", "inner", "kind"], faces, bad, rest);
    out
}

fn write<I: Into<Element> + Copy>(
    out: &mut String,
    table: &Table,
    title: &str,
    columns: &[&str],
    ids: impl Iterator<Item = I>,
    bad: &BTreeSet<String>,
    rest: impl Fn(I) -> Vec<String>,
) {
    let mut rows = String::new();
    let mut count = 0;
    for id in ids {
        count += 1;
        if count > ROWS {
            continue;
        }
        let element: Element = id.into();
        let class = if bad.contains(&element.to_string()) { " class=\"bad\"" } else { "" };
        // Writing to a String cannot fail.
        let _ = write!(rows, "<tr data-id=\"{element}\"{class}><th scope=\"row\">{element}</th>");
        for (pointer, to) in pointers(table, element) {
            match to {
                Some(to) => {
                    let _ = write!(rows, "<td data-pointer=\"{pointer}\" data-to=\"{to}\">{to}</td>");
                }
                None => {
                    let _ = write!(rows, "<td data-pointer=\"{pointer}\">none</td>");
                }
            }
        }
        for cell in rest(id) {
            let _ = write!(rows, "<td>{}</td>", escaped(&cell));
        }
        rows.push_str("</tr>");
    }
    let first = &title.to_lowercase();
    let heads: String = columns.iter().map(|column| format!("<th scope=\"col\">{column}</th>")).collect();
    let more = if count > ROWS { format!("<p>The first {ROWS} of {count} are shown.</p>") } else { String::new() };
    let _ = write!(
        out,
        "<section><h3>{title} <span>({count})</span></h3>{more}<div class=\"rows\" tabindex=\"0\" role=\"region\" aria-label=\"Table of {first}\"><table><thead><tr><th scope=\"col\">id</th>{heads}</tr></thead><tbody>{rows}</tbody></table></div></section>"
    );
}

/// The element with this name, if it is there.
pub(super) fn find(table: &Table, word: &str) -> Result<Element, String> {
    let word = word.trim();
    let found =
        element(word).ok_or_else(|| format!("`{word}` is not the name of an element; write h0, v0, e0 or f0"))?;
    if has(table, found) {
        return Ok(found);
    }
    let live = |rows: &[bool]| (rows.iter().filter(|&&row| row).count(), rows.len());
    let rows: Vec<bool> = match found {
        Element::Vertex(_) => table.vertices.iter().map(Option::is_some).collect(),
        Element::Face(_) => table.faces.iter().map(Option::is_some).collect(),
        Element::HalfEdge(_) => table.half_edges.iter().map(Option::is_some).collect(),
        Element::Edge(_) => table.half_edges.iter().step_by(2).map(Option::is_some).collect(),
    };
    let (count, bound) = live(&rows);
    Err(found.missing(count, bound))
}
