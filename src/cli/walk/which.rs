//! The element that is meant, or a helpful refusal.

use super::{Failure, Subject};
use dcel_kit::io::closest;
use dcel_kit::{Element, FaceId, Id};

/// The face with this id, or all faces with this name.
pub(super) fn faces(subject: &Subject, id: Option<FaceId>, name: Option<&str>) -> Result<Vec<FaceId>, Failure> {
    let view = subject.view();
    if let Some(f) = id {
        check(subject, f, view.face_bound(), |f| view.has_face(f))?;
        return Ok(vec![f]);
    }
    let name = name.unwrap_or_default();
    let named = || subject.faces().filter_map(|f| Some((f, subject.name(f)?)));
    let wanted = name.to_lowercase();
    // Of polygons that were mended all faces that one of this name covers, whatever else does.
    if let Some(covering) = &subject.covering {
        let exact = covering.faces_named(|known| known == name);
        let found = if exact.is_empty() { covering.faces_named(|known| known.to_lowercase() == wanted) } else { exact };
        if !found.is_empty() {
            return Ok(found);
        }
    }
    let exact: Vec<FaceId> = named().filter(|(_, known)| *known == name).map(|(f, _)| f).collect();
    let found = if exact.is_empty() {
        named().filter(|(_, known)| known.to_lowercase() == wanted).map(|(f, _)| f).collect()
    } else {
        exact
    };
    if !found.is_empty() {
        return Ok(found);
    }
    let what = format!("{}: no face is named `{name}`", subject.source);
    let help = match closest(name, named().map(|(_, known)| known)) {
        Some(close) => format!("did you mean `{close}`?"),
        None if named().next().is_some() => "`dcel convert FILE - --to tables` lists all names".to_owned(),
        None => "the file names no face; use an id, such as --face f1".to_owned(),
    };
    Err(Failure::input(what, help))
}

pub(super) fn check<I: Id + Into<Element>>(
    subject: &Subject,
    id: I,
    bound: usize,
    exists: impl Fn(I) -> bool,
) -> Result<(), Failure> {
    if exists(id) {
        return Ok(());
    }
    let live = |i: &usize| exists(I::from_index(*i));
    let before = (0..id.index().min(bound)).rev().find(live);
    let after = (id.index().saturating_add(1)..bound).find(live);
    let near: Vec<String> = before.into_iter().chain(after).map(|i| I::from_index(i).to_string()).collect();
    let help = if near.is_empty() { String::new() } else { format!("did you mean {}?", near.join(" or ")) };
    let all: Vec<usize> = (0..bound).filter(live).collect();
    let missing = id.into().missing(all.len(), all.last().map_or(0, |last| last + 1));
    Err(Failure::input(format!("{}: {missing}", subject.source), help))
}
