//! Reads cases, calls your functions, prints what they gave back and what they made of the structure.
//!
//! All input is read before anything of yours is called. A panic of yours ends the call, not the case: the structure
//! stays as the panic left it.

use crate::case::{Element, Line, Names, Unresolved, lines};
use crate::dcel::{Dcel, FaceId, HalfEdgeId, VertexId};
use crate::svg::Svg;
use crate::{lab, pen, print, start};
use std::io::{IsTerminal, Read, Write};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::process::ExitCode;
use std::sync::{Mutex, PoisonError};

/// Where the last panic came from.
static PLACE: Mutex<Option<String>> = Mutex::new(None);

/// The program.
pub fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let (text, mut output) = match arguments[..] {
        [] => (standard_input(), Output::new()),
        ["drawing"] => (Ok("rectangle\ndrawing\n".to_owned()), Output::only_problems()),
        ["svg"] => (standard_input(), Output::only_problems()),
        ["svg", file] => (from_file(file), Output::only_problems()),
        [file] if !file.starts_with('-') => (from_file(file), Output::new()),
        _ => (Err("usage: cargo run [-- [svg] [FILE] | drawing]".to_owned()), Output::new()),
    };
    let text = match text {
        Ok(text) => text,
        Err(problem) => {
            eprintln!("{problem}");
            return ExitCode::from(2);
        }
    };
    let picture_wanted = output.only_problems;
    let end = run(&text, &mut output);
    if !picture_wanted {
        return if end.mistakes == 0 { ExitCode::SUCCESS } else { ExitCode::from(2) };
    }
    let drawn = end.structure.and_then(|dcel| output.call("svg", || picture(&dcel)));
    output.flush();
    match drawn {
        Some(picture) if end.mistakes == 0 && !end.panicked => {
            print!("{picture}");
            ExitCode::SUCCESS
        }
        _ => ExitCode::from(2),
    }
}

fn standard_input() -> Result<String, String> {
    if std::io::stdin().is_terminal() {
        eprintln!("Type a case, such as `rectangle` and `walk_face h0` on two lines; end it with Ctrl-D");
        eprintln!("(on Windows: Ctrl-Z, then Enter).");
    }
    let mut text = String::new();
    match std::io::stdin().read_to_string(&mut text) {
        Ok(_) => Ok(text),
        Err(error) => Err(format!("standard input cannot be read: {error}")),
    }
}

fn from_file(file: &str) -> Result<String, String> {
    std::fs::read_to_string(file).map_err(|error| format!("{file} cannot be read: {error}"))
}

/// What is left when all lines have been read.
struct End {
    /// How many lines could not be understood.
    mistakes: usize,
    /// Whether a call panicked.
    panicked: bool,
    /// The structure of the last case.
    structure: Option<Dcel>,
}

/// Runs all cases of a text.
fn run(text: &str, output: &mut Output) -> End {
    let mut case: Option<Case> = None;
    let mut mistakes = 0;
    for line in lines(text) {
        let Some((first, rest)) = line.words() else { continue };
        if first == "token" && line.number == 1 && rest.len() == 1 {
            output.prefix = format!("@{} ", rest[0]);
            continue;
        }
        let done = if first == "case" {
            if let Some(case) = case.take() {
                case.end(output);
            }
            let name = rest.first().copied();
            case = Some(Case::begin(name.unwrap_or("unnamed"), output));
            if rest.len() == 1 { Ok(()) } else { Err("a case has one name, without blanks".to_owned()) }
        } else {
            case.get_or_insert_with(|| Case::begin("input", output)).line(first, &rest, line, output)
        };
        if let Err(problem) = done {
            mistakes += 1;
            output.problem(&format!("error line {}: {problem}", line.number));
        }
    }
    let structure = case.and_then(|case| case.end(output));
    output.line("done");
    output.flush();
    End { mistakes, panicked: output.panicked, structure }
}

/// A case that is being carried out.
struct Case<'a> {
    name: &'a str,
    dcel: Option<Dcel>,
    saved: Option<Dcel>,
    names: Names<'a>,
    /// Whether the lines are those of a table.
    in_table: bool,
    last_dump: Option<String>,
}

/// Why a line was not carried out; an unset link is reported and is no mistake of the line.
enum Stop {
    Mistake(String),
    Reported,
}

impl From<String> for Stop {
    fn from(problem: String) -> Self {
        Self::Mistake(problem)
    }
}

impl<'a> Case<'a> {
    fn begin(name: &'a str, output: &mut Output) -> Self {
        output.line(&format!("case {name}"));
        Self { name, dcel: None, saved: None, names: Names::default(), in_table: false, last_dump: None }
    }

    fn end(self, output: &mut Output) -> Option<Dcel> {
        output.line(&format!("end_case {}", self.name));
        output.flush();
        self.dcel
    }

    fn line(&mut self, first: &str, rest: &[&'a str], line: Line, output: &mut Output) -> Result<(), String> {
        let done = if self.in_table { self.table_line(first, rest) } else { self.statement(first, rest, line, output) };
        match done {
            Ok(()) | Err(Stop::Reported) => Ok(()),
            Err(Stop::Mistake(problem)) => Err(problem),
        }
    }

    fn table_line(&mut self, first: &str, rest: &[&str]) -> Result<(), Stop> {
        if first == "end_table" {
            self.in_table = false;
            return Ok(());
        }
        Ok(print::read_record(self.dcel.get_or_insert_default(), first, rest)?)
    }

    fn statement(&mut self, first: &str, rest: &[&'a str], line: Line, output: &mut Output) -> Result<(), Stop> {
        match (first, rest) {
            ("rectangle", []) => self.dcel = Some(start::rectangle()),
            ("polygon", corners) => self.dcel = Some(start::polygon(corners)?),
            ("triangles", words) => self.dcel = Some(start::triangles(words)?),
            ("table", []) => {
                self.dcel = Some(Dcel::default());
                self.in_table = true;
            }
            ("save", []) => self.saved = Some(Clone::clone(self.structure()?)),
            ("restore", []) => {
                let saved = self.saved.as_ref().ok_or_else(|| "nothing was saved in this case".to_owned())?;
                self.dcel = Some(Clone::clone(saved));
            }
            ("let", [name, "=", word]) => {
                let element = self.resolve(word, output)?;
                self.names.name(name, element)?;
            }
            ("dump", []) => self.dump(output)?,
            ("svg", []) => self.svg(output)?,
            ("drawing", []) => {
                let dcel = self.structure()?;
                output.answer("drawing", || pen::draw(dcel, lab::drawing), |()| String::new());
            }
            ("split_face", [a, b]) => {
                let (a, b) = (self.half_edge(a, output)?, self.half_edge(b, output)?);
                let dcel = self.structure()?;
                output.answer(&format!("split_face {a} {b}"), || dcel.split_face(a, b), |done| done.to_string());
            }
            ("split_in_half", [a]) => {
                let a = self.half_edge(a, output)?;
                let dcel = self.structure()?;
                output.answer(&format!("split_in_half {a}"), || dcel.split_in_half(a), |()| String::new());
            }
            ("walk_face", [word]) => {
                let f = self.face(word, output)?;
                let dcel = self.structure()?;
                output.answer(&format!("walk_face {f}"), || dcel.incident_half_edges(f), |list| numbers(&list));
            }
            ("walk_vertices", [word]) => {
                let f = self.face(word, output)?;
                let dcel = self.structure()?;
                output.answer(&format!("walk_vertices {f}"), || dcel.incident_vertices(f), |list| numbers(&list));
            }
            ("walk_vertex", [word]) => {
                let v = self.vertex(word, output)?;
                let dcel = self.structure()?;
                output.answer(&format!("walk_vertex {v}"), || dcel.outgoing_half_edges(v), |list| numbers(&list));
            }
            ("destination", [word]) => {
                let h = self.half_edge(word, output)?;
                let dcel = self.structure()?;
                output.answer(&format!("destination {h}"), || dcel.destination(h), |v| v.to_string());
            }
            ("destination_by_next", [word]) => {
                let h = self.half_edge(word, output)?;
                let dcel = self.structure()?;
                output.answer(&format!("destination_by_next {h}"), || dcel.destination_by_next(h), |v| v.to_string());
            }
            _ => return Err(Stop::Mistake(not_understood(first, line.text))),
        }
        Ok(())
    }

    fn structure(&mut self) -> Result<&mut Dcel, String> {
        let missing = "there is no structure yet; begin with rectangle, polygon, triangles or table";
        self.dcel.as_mut().ok_or_else(|| missing.to_owned())
    }

    fn resolve(&mut self, word: &str, output: &mut Output) -> Result<Element, Stop> {
        self.structure()?;
        let dcel = self.dcel.get_or_insert_default();
        self.names.resolve(dcel, word).map_err(|problem| match problem {
            Unresolved::Mistake(problem) => Stop::Mistake(problem),
            Unresolved::Unset => {
                output.problem(&format!("unresolved {word}"));
                Stop::Reported
            }
        })
    }

    fn half_edge(&mut self, word: &str, output: &mut Output) -> Result<HalfEdgeId, Stop> {
        match self.resolve(word, output)? {
            Element::HalfEdge(h) => Ok(h),
            _ => Err(Stop::Mistake(format!("`{word}` is not a half-edge"))),
        }
    }

    /// A face, or the face of a half-edge.
    fn face(&mut self, word: &str, output: &mut Output) -> Result<FaceId, Stop> {
        match self.resolve(word, output)? {
            Element::Face(f) => Ok(f),
            Element::HalfEdge(_) => match self.resolve(&format!("{word}.face"), output)? {
                Element::Face(f) => Ok(f),
                _ => Err(Stop::Mistake(format!("`{word}` has no face"))),
            },
            Element::Vertex(_) => Err(Stop::Mistake(format!("`{word}` is neither a face nor a half-edge"))),
        }
    }

    fn vertex(&mut self, word: &str, output: &mut Output) -> Result<VertexId, Stop> {
        match self.resolve(word, output)? {
            Element::Vertex(v) => Ok(v),
            _ => Err(Stop::Mistake(format!("`{word}` is not a vertex; write v0, or h0.origin"))),
        }
    }

    fn dump(&mut self, output: &mut Output) -> Result<(), String> {
        let dump = print::dump(self.structure()?);
        if self.last_dump.as_ref() == Some(&dump) {
            output.line("dump same");
        } else {
            output.line("dump");
            dump.lines().for_each(|line| output.line(line));
            output.line("end_dump");
            self.last_dump = Some(dump);
        }
        Ok(())
    }

    fn svg(&mut self, output: &mut Output) -> Result<(), String> {
        let dcel = self.structure()?;
        if let Some(picture) = output.call("svg", || picture(dcel)) {
            output.line("svg");
            picture.lines().for_each(|line| output.line(line));
            output.line("end_svg");
        }
        Ok(())
    }
}

/// Your picture of a structure, as SVG.
fn picture(dcel: &Dcel) -> String {
    let mut svg = Svg::default();
    lab::picture(dcel, &mut svg);
    svg.finish()
}

fn not_understood(first: &str, line: &str) -> String {
    let usage = match first {
        "split_face" => "write `split_face h2 h8`",
        "split_in_half" | "destination" | "destination_by_next" => "it takes one half-edge, such as h2",
        "walk_face" | "walk_vertices" => "it takes one face, such as f1, or a half-edge of it",
        "walk_vertex" => "it takes one vertex, such as v0 or h0.origin",
        "let" => "write `let wall = h8.prev`",
        "rectangle" | "table" | "save" | "restore" | "dump" | "svg" | "drawing" => "it stands alone in its line",
        _ => "the language is explained in README.md, «Typing a case by hand»",
    };
    format!("`{line}` is not understood; {usage}")
}

fn numbers(list: &[usize]) -> String {
    let words: Vec<String> = list.iter().map(ToString::to_string).collect();
    words.join(" ")
}

/// What is printed. It is collected, and written before each call of yours and at the end of each case.
struct Output {
    /// What every line begins with, so that lines of yours cannot be mistaken for them.
    prefix: String,
    text: String,
    /// Whether only problems are printed, on standard error; standard output is for a picture.
    only_problems: bool,
    panicked: bool,
}

impl Output {
    fn new() -> Self {
        Self { prefix: String::new(), text: String::new(), only_problems: false, panicked: false }
    }

    fn only_problems() -> Self {
        Self { only_problems: true, ..Self::new() }
    }

    fn line(&mut self, line: &str) {
        if !self.only_problems {
            self.problem(line);
        }
    }

    fn problem(&mut self, line: &str) {
        self.text.push_str(&self.prefix);
        self.text.push_str(line);
        self.text.push('\n');
    }

    fn flush(&mut self) {
        if self.text.is_empty() {
            return;
        }
        if !self.prefix.is_empty() {
            // Ends a line of yours that has no end.
            self.text.insert(0, '\n');
        }
        // If nobody reads any more, there is nobody to tell.
        let _ = if self.only_problems {
            std::io::stderr().write_all(self.text.as_bytes())
        } else {
            let mut out = std::io::stdout().lock();
            out.write_all(self.text.as_bytes()).and_then(|()| out.flush())
        };
        self.text.clear();
    }

    /// Makes a call of yours and prints what it gave back.
    fn answer<T>(&mut self, words: &str, call: impl FnOnce() -> T, show: impl FnOnce(T) -> String) {
        if let Some(value) = self.call(words, call) {
            self.line(format!("returned {}", show(value)).trim_end());
        }
    }

    /// Makes a call of yours; `None`, and a line about it, if it panics.
    fn call<T>(&mut self, words: &str, call: impl FnOnce() -> T) -> Option<T> {
        self.line(&format!("call {words}"));
        self.flush();
        remember_places();
        match catch_unwind(AssertUnwindSafe(call)) {
            Ok(value) => Some(value),
            Err(payload) => {
                self.panicked = true;
                let message = message(payload.as_ref());
                // Dropping what was thrown could run code of yours outside the guard.
                std::mem::forget(payload);
                let place = PLACE.lock().unwrap_or_else(PoisonError::into_inner).take();
                self.problem(format!("panicked {message:?} {}", place.unwrap_or_default()).trim_end());
                None
            }
        }
    }
}

/// The message of a panic: the first line of it, at most 500 characters.
fn message(payload: &(dyn std::any::Any + Send)) -> String {
    let words =
        payload.downcast_ref::<String>().map(String::as_str).or_else(|| payload.downcast_ref::<&str>().copied());
    words.unwrap_or("a panic without a message").chars().take(500).collect()
}

/// From now on the place of a panic is noted instead of printed.
fn remember_places() {
    *PLACE.lock().unwrap_or_else(PoisonError::into_inner) = None;
    let this = std::thread::current().id();
    std::panic::set_hook(Box::new(move |panic| {
        if let Some(place) = panic.location().filter(|_| std::thread::current().id() == this) {
            let file = place.file().replace('\\', "/");
            let file = file.rfind("src/").map_or(file.as_str(), |at| &file[at..]);
            let text = format!("{file}:{}:{}", place.line(), place.column());
            *PLACE.lock().unwrap_or_else(PoisonError::into_inner) = Some(text);
        }
    }));
}
