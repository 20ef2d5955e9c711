//! The lines of a case: words, links and names.
//!
//! ```text
//!   let a = h8.prev           h8: given     .prev: a link from it     a: the name of what it leads to
//!   split_face a.twin h2
//! ```

use super::structure::{Column, Structure, Table};

/// A line of the input, for messages.
#[derive(Clone, Copy)]
pub(super) struct Line<'a> {
    /// Its number, from 1.
    pub(super) number: usize,
    /// What it says, without its comment.
    pub(super) text: &'a str,
}

impl<'a> Line<'a> {
    /// The first word and the others; `None` if the line says nothing.
    pub(super) fn words(self) -> Option<(&'a str, Vec<&'a str>)> {
        let mut words = self.text.split_whitespace();
        Some((words.next()?, words.collect()))
    }
}

/// The lines of a text, their comments cut off.
pub(super) fn lines(text: &str) -> impl Iterator<Item = Line<'_>> {
    text.trim_start_matches('\u{feff}')
        .lines()
        .enumerate()
        .map(|(i, line)| Line { number: i + 1, text: line.split('#').next().unwrap_or("").trim() })
}

/// A record: the place of its table in [`Structure::TABLES`], and its number.
#[derive(Clone, Copy, PartialEq)]
pub(super) struct Element {
    pub(super) table: usize,
    pub(super) number: usize,
}

/// Why a word names nothing.
pub(super) enum Unresolved {
    /// A link on the way is not set, or leads to a record that does not exist.
    Unset,
    /// The word is not of the language.
    Mistake(String),
}

/// The names that `let` has given in a case.
#[derive(Default)]
pub(super) struct Names<'a> {
    names: Vec<(&'a str, Element)>,
}

impl<'a> Names<'a> {
    /// Gives `element` a name. A name can be given again; the last one counts.
    pub(super) fn name<S: Structure>(&mut self, name: &'a str, element: Element) -> Result<(), String> {
        let mut letters = name.chars();
        let begins_well = letters.next().is_some_and(|c| c.is_alphabetic() || c == '_');
        if !begins_well || !letters.all(|c| c.is_alphanumeric() || c == '_') || given::<S>(name).is_some() {
            return Err(format!("`{name}` cannot be a name; write a word such as `wall`"));
        }
        self.names.push((name, element));
        Ok(())
    }

    /// Follows a word with its links, `h0.next.twin`, through the structure.
    pub(super) fn resolve<S: Structure>(&self, structure: &S, word: &str) -> Result<Element, Unresolved> {
        let mut parts = word.split('.');
        let first = parts.next().unwrap_or("");
        let named = self.names.iter().rev().find(|(name, _)| *name == first).map(|&(_, element)| element);
        let Some(mut element) = named.or_else(|| given::<S>(first)) else {
            return Err(Unresolved::Mistake(format!("unknown word `{first}`; {}or names given by let", kinds::<S>())));
        };
        exists(structure, element)?;
        for link in parts {
            element = follow(structure, element, link)?;
        }
        Ok(element)
    }
}

/// "half-edges are h0, h1, …, vertices …, "
fn kinds<S: Structure>() -> String {
    S::TABLES.iter().map(|table| format!("{} are {1}0, {1}1, …, ", table.plural, table.letter)).collect()
}

/// `h12`, `v0`, `f1`: a letter and a number.
fn given<S: Structure>(word: &str) -> Option<Element> {
    let letter = word.chars().next()?;
    let digits = word.get(letter.len_utf8()..)?;
    if digits.is_empty() || !digits.bytes().all(|b| b.is_ascii_digit()) {
        return None;
    }
    let table = S::TABLES.iter().position(|table| table.letter == letter)?;
    Some(Element { table, number: digits.parse().ok()? })
}

fn exists<S: Structure>(structure: &S, element: Element) -> Result<(), Unresolved> {
    if element.number < structure.len(element.table) { Ok(()) } else { Err(Unresolved::Unset) }
}

/// One link, or a shortcut of several. The element exists; so does what is returned.
pub(super) fn follow<S: Structure>(structure: &S, from: Element, link: &str) -> Result<Element, Unresolved> {
    let table = &S::TABLES[from.table];
    if let Some(shortcut) = table.shortcuts.iter().find(|shortcut| shortcut.name == link) {
        return shortcut.path.iter().try_fold(from, |at, link| follow(structure, at, link));
    }
    let column = table.columns.iter().position(|column| column.link().is_some_and(|to| to.name == link));
    let Some(column) = column else { return Err(Unresolved::Mistake(has_no(table, link))) };
    let letter = table.columns[column].link().map(|to| to.letter);
    let to = S::TABLES.iter().position(|table| Some(table.letter) == letter);
    let number = structure.rows(from.table)(from.number).get(column).and_then(|cell| cell.to());
    let (Some(table), Some(number)) = (to, number) else { return Err(Unresolved::Unset) };
    let element = Element { table, number };
    exists(structure, element)?;
    Ok(element)
}

/// "a half-edge has no `foo`; it has next, prev, …"
fn has_no(table: &Table, link: &str) -> String {
    let mut has: Vec<&str> = table.columns.iter().filter_map(Column::link).map(|link| link.name).collect();
    has.extend(table.shortcuts.iter().map(|shortcut| shortcut.name));
    match has.split_last() {
        None => format!("a {} has no `{link}`, and no other link", table.name),
        Some((only, [])) => format!("a {} has no `{link}`; it has {only}", table.name),
        Some((last, others)) => format!("a {} has no `{link}`; it has {} and {last}", table.name, others.join(", ")),
    }
}
