//! A path of links, followed on any table: `h2.next.twin.prev`.

use super::tables::find;
use crate::edits::Kind;
use crate::ids::{Element, HalfEdgeId, VertexId};
use crate::old_words::{Language, OldWord};
use crate::script::Link;
use crate::topology::{Table, View, has};

/// No path is longer.
const LONGEST: usize = 1000;

/// All links.
pub(super) fn link(word: &str) -> Option<Link> {
    Link::ALL.into_iter().find(|link| link.word() == word)
}

/// One link; `None` if it is not set.
pub(super) fn step(table: &Table, from: Element, link: Link) -> Option<Element> {
    let half_edge = |h: HalfEdgeId| -> Option<Element> {
        Some(match link {
            Link::Next => table.next(h)?.into(),
            Link::Prev => table.prev(h)?.into(),
            Link::Twin => table.twin(h)?.into(),
            Link::Origin => table.origin(h)?.into(),
            Link::Destination => destination(table, h)?.into(),
            Link::Face => table.face(h)?.into(),
            Link::Edge => h.edge().into(),
            Link::Outgoing | Link::HalfEdge => return None,
        })
    };
    match from {
        Element::HalfEdge(h) => half_edge(h),
        Element::Edge(e) => half_edge(e.half_edges()[0]),
        Element::Vertex(v) => (link == Link::Outgoing).then(|| table.outgoing(v))?.map(Element::from),
        Element::Face(f) => (link == Link::HalfEdge).then(|| table.half_edge(f))?.map(Element::from),
    }
}

fn destination(table: &Table, h: HalfEdgeId) -> Option<VertexId> {
    table.origin(table.twin(h)?)
}

/// All elements along a path, the first one too.
pub(super) fn walk(table: &Table, path: &str) -> Result<Vec<Element>, String> {
    let path = path.trim();
    let mut words = path.split('.');
    let mut at = find(table, words.next().unwrap_or(""))?;
    let mut out = vec![at];
    for word in words {
        if out.len() > LONGEST {
            return Err(format!("this path is longer than {LONGEST} links; walk it in parts"));
        }
        let (kind, word) = (Kind::of(at), OldWord::current(Language::Script, word));
        let known: Vec<Link> = Link::ALL.into_iter().filter(|link| link.from() == kind).collect();
        let Some(&link) = known.iter().find(|link| link.word() == word) else {
            let known: Vec<&str> = known.iter().map(|link| link.word()).collect();
            let known = if known.is_empty() { String::new() } else { format!("; known: {}", known.join(" ")) };
            return Err(format!("`{word}` is not a link of {}{known}", kind.a()));
        };
        let Some(to) = step(table, at, link) else {
            return Err(format!("{at}.{word} is not set, so `{path}` leads nowhere"));
        };
        if !has(table, to) {
            return Err(format!("{at}.{word} is {to}, which does not exist, so `{path}` leads nowhere"));
        }
        out.push(to);
        at = to;
    }
    Ok(out)
}
