//! A path of links, followed on any table: `h2.next.twin.prev`.

use super::tables::find;
use crate::edits::Kind;
use crate::ids::Element;
use crate::old_words::{Language, OldWord};
use crate::script::{Link, follow};
use crate::topology::{Table, has};

/// No path is longer.
const LONGEST: usize = 1000;

/// All links.
pub(super) fn link(word: &str) -> Option<Link> {
    Link::ALL.into_iter().find(|link| link.word() == word)
}

/// One link; `None` if it is not set.
pub(super) fn step(table: &Table, from: Element, link: Link) -> Option<Element> {
    let from = if let Element::Edge(e) = from { e.half_edges()[0].into() } else { from };
    follow(table, from, link)
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
