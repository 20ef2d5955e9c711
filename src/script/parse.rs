//! From text to a script: every word is looked up, so that only edits can fail later.

use super::cursor::{Complaint, Cursor, show};
use super::error::{Problem, ScriptError};
use super::starts::{OF_THE_KERNEL, OF_THE_PLANE, kernel_start, plane_start, start_word};
use super::syntax::{Action, Base, Link, Name, Path, Script, Statement, Value};
use super::words::{Line, Word, lines};
use crate::edits::{Argument, Editable, Kind, Row, Takes, element, find, rows_of, switch};
use crate::ids::Element;
use crate::old_words::{Language, OldWord};
use crate::topology::Dcel;
use std::collections::BTreeMap;

/// The statements that are no edits.
const OTHERS: [&str; 5] = ["walk_face", "walk_vertex", "highlight", "caption", "dump"];
const LET: &str = "let";

impl Script {
    /// Reads a script of the plane. `source` is what messages call the text.
    ///
    /// Cost: O(length of the text), and that of building the start.
    ///
    /// # Errors
    /// [`ScriptError`] names the first word that does not fit, its place, and what is known there.
    pub fn parse(text: &str, source: &str) -> Result<Self, ScriptError> {
        read(text, source, plane_start, OF_THE_PLANE, &[])
    }

    /// [`parse`](Self::parse) with further edits: rows of your own, as in `examples/own_edit.rs`.
    ///
    /// # Errors
    /// [`ScriptError`] names the first word that does not fit, its place, and what is known there.
    pub fn parse_with(text: &str, source: &str, own: &[&'static Row]) -> Result<Self, ScriptError> {
        read(text, source, plane_start, OF_THE_PLANE, own)
    }
}

impl Script<Dcel> {
    /// Reads a script of the kernel: no coordinates, and the edits of the [`Dcel`].
    ///
    /// Cost: O(length of the text), and that of building the start.
    ///
    /// # Errors
    /// [`ScriptError`] names the first word that does not fit, its place, and what is known there.
    ///
    /// ```
    /// use dcel_kit::script::Script;
    /// let run = Script::parse_kernel("torus\nlet a = split_vertex h0 h1\njoin_vertices a\n", "example")?.run();
    /// assert_eq!(run.steps[0].outcome.to_string(), "split_vertex h0 h1 returned h4, v1");
    /// assert_eq!(run.end.vertex_count(), 1);
    /// # Ok::<(), dcel_kit::script::ScriptError>(())
    /// ```
    pub fn parse_kernel(text: &str, source: &str) -> Result<Self, ScriptError> {
        read(text, source, kernel_start, OF_THE_KERNEL, &[])
    }

    /// [`parse_kernel`](Self::parse_kernel) with further edits: rows of your own.
    ///
    /// # Errors
    /// [`ScriptError`] names the first word that does not fit, its place, and what is known there.
    pub fn parse_kernel_with(text: &str, source: &str, own: &[&'static Row]) -> Result<Self, ScriptError> {
        read(text, source, kernel_start, OF_THE_KERNEL, own)
    }
}

#[cfg(feature = "solid")]
impl Script<crate::solid::Polyhedron> {
    /// Reads a script in space: the edits of a surface with positions.
    ///
    /// Cost: O(length of the text), and that of building the start.
    ///
    /// # Errors
    /// [`ScriptError`] names the first word that does not fit, its place, and what is known there.
    ///
    /// ```
    /// use dcel_kit::script::Script;
    /// let run = Script::parse_solid("solid cube\nremove_face f0\n", "example")?.run();
    /// assert_eq!(run.end.boundary_faces().len(), 1);
    /// # Ok::<(), dcel_kit::script::ScriptError>(())
    /// ```
    pub fn parse_solid(text: &str, source: &str) -> Result<Self, ScriptError> {
        read(text, source, super::starts::solid_start, super::starts::OF_SPACE, &[])
    }

    /// [`parse_solid`](Self::parse_solid) with further edits: rows of your own.
    ///
    /// # Errors
    /// [`ScriptError`] names the first word that does not fit, its place, and what is known there.
    pub fn parse_solid_with(text: &str, source: &str, own: &[&'static Row]) -> Result<Self, ScriptError> {
        read(text, source, super::starts::solid_start, super::starts::OF_SPACE, own)
    }
}

/// Reads statements alone, to be carried out on this structure; see [`Script::parse`].
#[cfg(feature = "play")]
pub(crate) fn parse_on<G: Editable>(start: G, text: &str, source: &str) -> Result<Script<G>, ScriptError> {
    Parser::new(start, &[]).read(lines(text)).map_err(|complaint| named(complaint, source))
}

fn named(Complaint { line, column, what, help }: Complaint, source: &str) -> ScriptError {
    ScriptError { source: source.to_owned(), line, column, what: Box::new(what), help }
}

fn read<G: Editable>(
    text: &str,
    source: &str,
    start: impl FnOnce(&mut Cursor<'_>) -> Result<G, Complaint>,
    starts: &str,
    own: &[&'static Row],
) -> Result<Script<G>, ScriptError> {
    let read = || {
        let mut lines = lines(text);
        let Some(first) = lines.next() else {
            return Err(Complaint { line: 1, column: 1, what: Problem::Empty, help: starts.to_owned() });
        };
        let start = start(&mut Cursor::new(&first))?;
        Parser::new(start, own).read(lines)
    };
    read().map_err(|complaint| named(complaint, source))
}

struct Parser<'a, G> {
    script: Script<G>,
    /// Rows beside those of the table.
    own: &'a [&'static Row],
    /// The index of each name.
    by_text: BTreeMap<String, usize>,
}

impl<'a, G: Editable> Parser<'a, G> {
    fn new(start: G, own: &'a [&'static Row]) -> Self {
        let script = Script { start, statements: Vec::new(), names: Vec::new(), old_words: Vec::new() };
        Self { script, own, by_text: BTreeMap::new() }
    }

    /// The script of these statements.
    fn read<'t>(mut self, lines: impl Iterator<Item = Line<'t>>) -> Result<Script<G>, Complaint> {
        for line in lines {
            let action = self.action(&mut Cursor::new(&line))?;
            self.script.statements.push(Statement { line: line.number, text: line.text.to_owned(), action });
        }
        Ok(self.script)
    }

    /// The edit with this word.
    fn find(&self, word: &str) -> Option<&'static Row> {
        let own = self.own.iter().copied().find(|row| row.word == word && G::column(row).is_some());
        own.or_else(|| find::<G>(word))
    }

    /// Notes an old word, once.
    fn note_old_word(&mut self, word: &str) {
        let old = OldWord::find(Language::Script, word);
        self.script.old_words.extend(old.filter(|old| !self.script.old_words.contains(old)));
    }

    fn action(&mut self, cursor: &mut Cursor<'_>) -> Result<Action, Complaint> {
        let Some(first) = cursor.next() else { return Ok(Action::Dump) };
        if first.text != LET {
            return self.statement(cursor, first, None);
        }
        cursor.statement = LET;
        let help = "write `let a = split_face h0 h3`, or `let a = h0.next`";
        let name = cursor.need("a name", help)?;
        self.check_name(cursor, name)?;
        let sign = cursor.need("`=`", help)?;
        if sign.text != "=" {
            let what = Problem::Extra { word: show(sign.text), statement: "the name after let".to_owned() };
            return Err(cursor.at(sign, what, help));
        }
        let word = cursor.need("an edit or a half-edge after `=`", help)?;
        let is_statement = OTHERS.contains(&word.text) || self.find(word.text).is_some();
        if is_statement || !(word.text.contains('.') || self.base(word.text).is_some()) {
            return self.statement(cursor, word, Some(name));
        }
        let (path, kind) = self.path(cursor, word)?;
        cursor.done()?;
        Ok(Action::Name { path, name: self.give(cursor, name, kind) })
    }

    /// A statement whose first word is `word`, with the name that its result is to get.
    fn statement(
        &mut self,
        cursor: &mut Cursor<'_>,
        word: Word<'_>,
        name: Option<Word<'_>>,
    ) -> Result<Action, Complaint> {
        let statement = word.text.to_owned();
        let mut rest = Cursor { line: cursor.line, at: cursor.at, statement: &statement };
        let cursor = &mut rest;
        let nothing_to_name = |cursor: &Cursor<'_>| {
            let help = "names go to what splits make, and to elements: let a = split_face h0 h3, let b = h0.next";
            let complain = |_| cursor.at(word, Problem::NothingToName { statement: statement.clone() }, help);
            name.map_or(Ok(()), |name| Err(complain(name)))
        };
        if let Some(row) = self.find(word.text) {
            self.note_old_word(word.text);
            if row.names().is_none() {
                nothing_to_name(cursor)?;
            }
            return self.edit(cursor, row, name);
        }
        if OTHERS.contains(&word.text) {
            nothing_to_name(cursor)?;
        }
        let action = match word.text {
            "walk_face" => Action::WalkFace(self.element(cursor, &[Kind::HalfEdge, Kind::Face])?),
            "walk_vertex" => Action::WalkVertex(self.element(cursor, &[Kind::HalfEdge, Kind::Vertex])?),
            "highlight" => {
                let mut paths = vec![self.element(cursor, &[])?];
                while cursor.peek().is_some() {
                    paths.push(self.element(cursor, &[])?);
                }
                Action::Highlight(paths)
            }
            "caption" => {
                cursor.need("a sentence", "write the sentence on the same line")?;
                cursor.at = cursor.line.words.len();
                Action::Caption(cursor.line.text["caption".len()..].trim().to_owned())
            }
            "dump" => Action::Dump,
            other if start_word(other).is_some() => {
                let what = Problem::Start { word: show(other), first: false };
                return Err(cursor.at(word, what, "only the first statement is a start"));
            }
            other => {
                let own = self.own.iter().copied().filter(|row| G::column(row).is_some());
                let mut known: Vec<&str> = rows_of::<G>().chain(own).map(|row| row.word).collect();
                known.extend(OTHERS);
                let help = format!("known: {} {LET}", known.join(" "));
                return Err(cursor.at(word, Problem::Statement { word: show(other) }, help));
            }
        };
        cursor.done()?;
        Ok(action)
    }

    fn edit(
        &mut self,
        cursor: &mut Cursor<'_>,
        row: &'static Row,
        name: Option<Word<'_>>,
    ) -> Result<Action, Complaint> {
        let help = format!("write {}", row.usage::<G>());
        let mut arguments = Vec::new();
        for takes in row.takes_on::<G>() {
            arguments.push(match takes {
                Takes::Element(kind) => Value::Element(self.element(cursor, &[kind])?),
                Takes::Place => {
                    let mut place = [0.0; 3];
                    for (x, axis) in place[..G::DIMENSION].iter_mut().zip(["x", "y", "z"]) {
                        *x = cursor.number(axis, &help)?;
                    }
                    Value::Plain(Argument::Place(place))
                }
                Takes::Number => Value::Plain(Argument::Number(cursor.plain_number("a number", &help)?)),
                Takes::Map => Value::Plain(Argument::Number(cursor.plain_number("the numbers of a map", &help)?)),
                Takes::Switch => {
                    let word = cursor.need("yes or no", &help)?;
                    let not =
                        || cursor.at(word, Problem::Number { word: show(word.text), wanted: "yes or no" }, &*help);
                    Value::Plain(Argument::Switch(switch(word.text).ok_or_else(not)?))
                }
                Takes::Vertices => {
                    while arguments.is_empty() || cursor.peek().is_some() {
                        arguments.push(Value::Element(self.element(cursor, &[Kind::Vertex])?));
                    }
                    continue;
                }
            });
        }
        cursor.done()?;
        let name = name.zip(row.names()).map(|(name, kind)| self.give(cursor, name, kind));
        Ok(Action::Edit { row, arguments, name })
    }

    /// The next word as an element of one of the kinds; any kind if none is said.
    fn element(&mut self, cursor: &mut Cursor<'_>, kinds: &[Kind]) -> Result<Path, Complaint> {
        let wanted = match kinds {
            [kind] => kind.a(),
            [Kind::HalfEdge, Kind::Face] => "a half-edge or a face",
            [Kind::HalfEdge, Kind::Vertex] => "a half-edge or a vertex",
            _ => "an element",
        };
        let word = cursor.need(wanted, "name it by a word such as h0, or h0.next.twin")?;
        let (path, kind) = self.path(cursor, word)?;
        if kinds.is_empty() || kinds.contains(&kind) {
            return Ok(path);
        }
        let statement = cursor.statement.to_owned();
        let what = Problem::Kind { word: show(word.text), kind: kind.a(), statement, wanted };
        let way = Link::ALL.into_iter().find(|link| link.from() == kind && kinds.contains(&link.to()));
        let help = way.map_or_else(String::new, |link| format!("try {}.{}", show(word.text), link.word()));
        Err(cursor.at(word, what, help))
    }

    fn path(&mut self, cursor: &Cursor<'_>, word: Word<'_>) -> Result<(Path, Kind), Complaint> {
        let text = word.text.to_owned();
        let mut parts = word.text.split('.');
        let base = parts.next().unwrap_or("");
        let Some((base, mut kind)) = self.base(base) else {
            return Err(self.unknown(cursor, Word { text: base, ..word }));
        };
        let mut links = Vec::new();
        let mut column = word.column + word.text.split('.').next().map_or(0, |b| b.chars().count() as u32) + 1;
        for part in parts {
            let word = OldWord::current(Language::Script, part);
            let Some(link) = Link::ALL.into_iter().find(|link| link.from() == kind && link.word() == word) else {
                let known = Link::ALL.into_iter().filter(|link| link.from() == kind).map(Link::word);
                let known: Vec<&str> = known.collect();
                let help = if known.is_empty() {
                    format!("{} has no links", kind.a())
                } else {
                    format!("known: {}", known.join(" "))
                };
                let what = Problem::Link { word: show(part), kind: kind.a() };
                return Err(cursor.at(Word { text: part, column }, what, help));
            };
            self.note_old_word(part);
            links.push(link);
            kind = link.to();
            column += part.chars().count() as u32 + 1;
        }
        Ok((Path { base, links, text }, kind))
    }

    /// What the first part of a path names.
    fn base(&self, word: &str) -> Option<(Base, Kind)> {
        if let Some(&index) = self.by_text.get(word) {
            return Some((Base::Named(index), self.script.names[index].kind));
        }
        let element = element(word).filter(|element| self.script.start.topology().check(*element).is_ok())?;
        Some((Base::Given(element), Kind::of(element)))
    }

    fn unknown(&self, cursor: &Cursor<'_>, word: Word<'_>) -> Complaint {
        let start = self.script.start.topology();
        let Some(element) = element(word.text) else {
            let mut known = format!("given are h0 .. h{}", start.half_edge_bound().saturating_sub(1));
            for name in self.script.names.iter().rev().take(10) {
                known.push_str(", ");
                known.push_str(&name.text);
            }
            return cursor.at(word, Problem::Name { word: show(word.text) }, known);
        };
        let (letter, bound) = match element {
            Element::Vertex(_) => ('v', start.vertex_bound()),
            Element::HalfEdge(_) => ('h', start.half_edge_bound()),
            Element::Edge(_) => ('e', start.edge_bound()),
            Element::Face(_) => ('f', start.face_bound()),
        };
        let (first, last) = (format!("{letter}0"), format!("{letter}{}", bound.saturating_sub(1)));
        let what = Problem::NotGiven { word: show(word.text), first, last };
        cursor.at(word, what, "name what an edit makes with `let a = …`, or by links such as h0.next.twin")
    }

    fn check_name(&self, cursor: &Cursor<'_>, word: Word<'_>) -> Result<(), Complaint> {
        let letters = word.text.chars().all(|c| c.is_alphanumeric() || c == '_');
        let begins = word.text.chars().next().is_some_and(char::is_alphabetic);
        let reserved = word.text == LET || OTHERS.contains(&word.text) || self.find(word.text).is_some();
        if element(word.text).is_some() || !letters || !begins || reserved {
            let help = "a name begins with a letter, holds letters, digits and `_`, and is neither a statement nor \
                        an id such as h12";
            return Err(cursor.at(word, Problem::BadName { word: show(word.text) }, help));
        }
        match self.by_text.get(word.text) {
            None => Ok(()),
            Some(&name) => {
                let what = Problem::Taken { word: show(word.text), line: self.script.names[name].line };
                Err(cursor.at(word, what, "choose another name"))
            }
        }
    }

    fn give(&mut self, cursor: &Cursor<'_>, word: Word<'_>, kind: Kind) -> usize {
        self.by_text.insert(word.text.to_owned(), self.script.names.len());
        self.script.names.push(Name { text: word.text.to_owned(), line: cursor.line.number, kind });
        self.script.names.len() - 1
    }
}
