//! A structure with everything that was done to it: edits, undo and redo, and the script that says the same.
//!
//! ```text
//!   start ── edit ── edit ── walk ──▶ now          undone: edit, edit
//!            └ log: taken back bit for bit          made again in order
//! ```

use crate::edits::{Call, EditError, Editable};
use crate::ids::{Element, FaceId};
use crate::script::{Outcome, Script, ScriptError, Step, Writer, parse_on};
use crate::topology::{Change, Journal};

/// A structure and its history.
#[derive(Clone, Debug)]
pub(super) struct Workshop<S: Editable> {
    /// The first line of the script, or a comment if no line says the start.
    start_line: String,
    start: S,
    now: S,
    entries: Vec<Entry<S>>,
    undone: Vec<Entry<S>>,
    writer: Writer<S>,
}

/// What was done.
#[derive(Clone, Debug)]
enum Entry<S: Editable> {
    Edit { call: Call<S>, name: Option<String>, log: S::Log, returned: String },
    Line { text: String, name: Option<String> },
}

/// A line of the script as the page shows it.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct Shown {
    pub(super) text: String,
    /// What it returned.
    pub(super) note: String,
}

/// What a line has done.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct Done {
    /// What to say.
    pub(super) text: String,
    /// What to show.
    pub(super) elements: Vec<Element>,
}

impl<S: Editable> Workshop<S> {
    pub(super) fn new(start_line: impl Into<String>, start: S) -> Self {
        let start_line = start_line.into();
        Self {
            writer: Writer::new(start_line.clone(), start.clone()),
            start_line,
            now: start.clone(),
            start,
            entries: Vec::new(),
            undone: Vec::new(),
        }
    }

    pub(super) fn now(&self) -> &S {
        &self.now
    }

    pub(super) fn start(&self) -> &S {
        &self.start
    }

    pub(super) fn start_line(&self) -> &str {
        &self.start_line
    }

    /// Whether the first line says the start, so that the script is whole.
    pub(super) fn is_script(&self) -> bool {
        !self.start_line.starts_with('#')
    }

    pub(super) fn can_undo(&self) -> bool {
        !self.entries.is_empty()
    }

    pub(super) fn can_redo(&self) -> bool {
        !self.undone.is_empty()
    }

    /// How many edits led here.
    pub(super) fn edit_count(&self) -> usize {
        self.calls().count()
    }

    fn calls(&self) -> impl Iterator<Item = &Call<S>> {
        self.entries.iter().filter_map(|entry| match entry {
            Entry::Edit { call, .. } => Some(call),
            Entry::Line { .. } => None,
        })
    }

    /// Makes an edit. What was undone cannot be made again after it.
    pub(super) fn edit(&mut self, call: Call<S>, name: Option<String>) -> Result<Done, EditError> {
        let mut log = S::Log::default();
        let returned = call.apply(&mut self.now, &mut log)?;
        self.writer.edit(&call, name.as_deref());
        let done = Done { text: format!("{call} returned {returned}"), elements: returned.elements().to_vec() };
        self.undone.clear();
        self.entries.push(Entry::Edit { call, name, log, returned: returned.to_string() });
        Ok(done)
    }

    /// Takes the last entry back, bit for bit. Says what it was.
    pub(super) fn undo(&mut self) -> Option<String> {
        let mut entry = self.entries.pop()?;
        let what = match &mut entry {
            Entry::Edit { call, log, .. } => {
                self.now.take_back(log);
                call.to_string()
            }
            Entry::Line { text, .. } => text.clone(),
        };
        self.undone.push(entry);
        self.rewrite();
        Some(what)
    }

    /// Makes the last entry that was taken back again.
    pub(super) fn redo(&mut self) -> Option<String> {
        let entry = self.undone.pop()?;
        let what = match entry {
            Entry::Edit { call, name, .. } => {
                let what = call.to_string();
                let undone = std::mem::take(&mut self.undone);
                let made = self.edit(call, name);
                self.undone = undone;
                made.ok()?;
                what
            }
            Entry::Line { text, name } => {
                self.writer.say(&text, name.as_deref());
                self.entries.push(Entry::Line { text: text.clone(), name });
                text
            }
        };
        Some(what)
    }

    fn rewrite(&mut self) {
        let mut writer = Writer::new(self.start_line.clone(), self.start.clone());
        for entry in &self.entries {
            match entry {
                Entry::Edit { call, name, .. } => writer.edit(call, name.as_deref()),
                Entry::Line { text, name } => writer.say(text, name.as_deref()),
            }
        }
        self.writer = writer;
    }

    /// Faces of the start that an edit has removed: a name of theirs is no longer right.
    pub(super) fn removed_faces(&self) -> Vec<FaceId> {
        let face = |change: &Change| match *change {
            Change::Removed { element: Element::Face(f) } => Some(f),
            _ => None,
        };
        let gone = |entry: &Entry<S>| match entry {
            Entry::Edit { log, .. } => S::pointers(log.clone()).changes().iter().filter_map(face).collect(),
            Entry::Line { .. } => Vec::new(),
        };
        self.entries.iter().flat_map(gone).collect()
    }

    /// The script, line by line.
    pub(super) fn lines(&self) -> Vec<Shown> {
        let notes = self.entries.iter().map(|entry| match entry {
            Entry::Edit { returned, .. } => returned.clone(),
            Entry::Line { .. } => String::new(),
        });
        let notes = std::iter::once(String::new()).chain(notes);
        self.writer.lines().iter().zip(notes).map(|(text, note)| Shown { text: text.clone(), note }).collect()
    }

    /// The script as a file, with what each edit has returned as a comment.
    pub(super) fn script(&self) -> String {
        let line = |Shown { text, note }: Shown| {
            let mut lines = text.lines();
            let first = lines.next().unwrap_or_default().to_owned();
            let first = if note.is_empty() { first } else { format!("{first}   # {note}") };
            std::iter::once(first).chain(lines.map(str::to_owned)).map(|line| line + "\n").collect::<String>()
        };
        self.lines().into_iter().map(line).collect()
    }

    /// Carries out one line of the script language. Ids mean what the picture shows: `split_in_half h12`.
    pub(super) fn line(&mut self, text: &str) -> Result<Done, String> {
        let text = text.split('#').next().unwrap_or("").trim();
        let (name, rest) = match text.strip_prefix("let ").and_then(|rest| rest.split_once('=')) {
            Some((name, rest)) => (Some(name.trim()), rest.trim()),
            None => (None, text),
        };
        // Only a name that the language takes: it is tried with an element that is always there, or left to the reader.
        if let Ok(call) = rest.parse::<Call<S>>()
            && name.is_none()
        {
            return self.edit(call, None).map_err(|error| error.to_string());
        }
        let before = self.writer.lines()[1..].join("\n");
        // The start has a line of its own, so that lines are numbered as the page shows them.
        let whole = format!("\n{before}\n{text}");
        let whole = if before.is_empty() { format!("\n{text}") } else { whole };
        let shown_as = rest.parse::<Call<S>>().ok().zip(name);
        let script = match parse_on(self.start.clone(), &whole, "line") {
            Ok(script) => script,
            Err(error) => {
                // `let door = split_face h12 h3`: the name is the language's business, the ids are the picture's.
                let Some((call, name)) = shown_as else { return Err(error.to_string()) };
                self.check_name(name).map_err(|error| error.to_string())?;
                let done = self.edit(call, Some(name.to_owned()));
                return done.map_err(|error| error.to_string());
            }
        };
        self.said(&script, text, name)
    }

    /// Whether the language takes this as a new name.
    fn check_name(&self, name: &str) -> Result<(), ScriptError> {
        let before = self.writer.lines()[1..].join("\n");
        let Some(v) = self.start.topology().vertices().next() else { return Ok(()) };
        parse_on(self.start.clone(), &format!("\n{before}\nlet {name} = {v}"), "line").map(|_| ())
    }

    /// Carries out the last statement of a script whose others have been carried out.
    fn said(&mut self, script: &Script<S>, text: &str, name: Option<&str>) -> Result<Done, String> {
        let last = script.run().steps.pop();
        let name = name.map(str::to_owned);
        let Some(Step { outcome, .. }) = last else { return Ok(Done { text: String::new(), elements: Vec::new() }) };
        let elements = match &outcome {
            Outcome::Edited { edit, .. } => {
                let edit = edit.clone();
                return self.edit(edit, name).map_err(|error| error.to_string());
            }
            Outcome::Refused { reason, .. } => return Err(reason.to_string()),
            Outcome::WalkedFace { cycle, .. } => cycle.iter().map(|&(h, _)| h.into()).collect(),
            Outcome::WalkedVertex { star, .. } => star.iter().map(|&(h, _)| h.into()).collect(),
            Outcome::Named(element) => vec![*element],
            Outcome::Highlighted(elements) => elements.clone(),
            Outcome::Caption(_) | Outcome::Dump => Vec::new(),
        };
        let told = match &name {
            Some(name) => format!("{name} {outcome}"),
            None => outcome.to_string(),
        };
        self.keep_line(text.to_owned(), name);
        Ok(Done { text: told, elements })
    }

    /// Appends a statement that is no edit.
    fn keep_line(&mut self, text: String, name: Option<String>) {
        self.writer.say(&text, name.as_deref());
        self.undone.clear();
        self.entries.push(Entry::Line { text, name });
    }

    /// Carries out the statements of a whole script on its start. Refused ones are told, and left out.
    pub(super) fn of_script(start_line: &str, script: &Script<S>) -> (Self, Vec<String>) {
        let mut workshop = Self::new(start_line, script.start().clone());
        let mut refused = Vec::new();
        for step in script.run().steps {
            let said = &script.statements()[step.statement];
            let name = said.text().strip_prefix("let ").and_then(|rest| rest.split_once('='));
            let name = name.map(|(name, _)| name.trim().to_owned());
            match step.outcome {
                Outcome::Edited { edit, .. } => {
                    // It was made on the same structure a moment ago.
                    if let Err(error) = workshop.edit(edit, name) {
                        refused.push(format!("line {}: {error}", said.line()));
                    }
                }
                Outcome::Refused { reason, .. } => refused.push(format!("line {}: {reason}", said.line())),
                _ => workshop.keep_line(said.text().to_owned(), name),
            }
        }
        (workshop, refused)
    }

    /// The edits as lines of ids, with names: what a link holds.
    pub(super) fn kept(&self) -> Vec<String> {
        let line = |entry: &Entry<S>| match entry {
            Entry::Edit { call, name: Some(name), .. } => format!("={name} {call}"),
            Entry::Edit { call, .. } => call.to_string(),
            Entry::Line { text, name: Some(name) } => format!(":{name} {text}"),
            Entry::Line { text, .. } => format!(": {text}"),
        };
        self.entries.iter().map(line).collect()
    }

    /// Does again what [`kept`](Self::kept) has written. `None` if a line cannot be carried out.
    pub(super) fn remade<'a>(mut self, lines: impl IntoIterator<Item = &'a str>) -> Option<Self> {
        for line in lines {
            if let Some(rest) = line.strip_prefix('=') {
                let (name, call) = rest.split_once(' ')?;
                self.edit(call.parse().ok()?, Some(name.to_owned())).ok()?;
            } else if let Some(rest) = line.strip_prefix(':') {
                let (name, text) = rest.split_once(' ')?;
                self.keep_line(text.to_owned(), (!name.is_empty()).then(|| name.to_owned()));
            } else {
                self.edit(line.parse().ok()?, None).ok()?;
            }
        }
        Some(self)
    }

    /// The edits from one on, each with the structure after it: for a film. First the structure before them.
    pub(super) fn replay(&self, last: usize) -> (S, Vec<(Call<S>, Journal, S)>) {
        let edits: Vec<&Call<S>> = self.calls().collect();
        let (first, shown) = edits.split_at(edits.len().saturating_sub(last));
        let mut before = self.start.clone();
        for call in first {
            let made = call.apply(&mut before, &mut S::Log::default());
            debug_assert!(made.is_ok(), "it was made before");
        }
        let mut state = before.clone();
        let shot = |&call: &&Call<S>| {
            let mut log = S::Log::default();
            let made = call.apply(&mut state, &mut log);
            debug_assert!(made.is_ok(), "it was made before");
            (call.clone(), S::pointers(log), state.clone())
        };
        let shots = shown.iter().map(shot).collect();
        (before, shots)
    }
}
