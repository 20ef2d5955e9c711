//! Cases, line by line: starts, calls, dumps.
//!
//! All input is read before anything of yours is called. The structure stays as a panic left it.

use super::output::Output;
use super::reads::{self, Meter};
use super::structure::{Structure, changes, dump, read_record, records};
use super::value::{Argument, Take, Value, coordinate, places, points, whole};
use super::words::{Element, Line, Names, Unresolved, follow, lines};
use super::{Call, Lab};
use std::io::{IsTerminal, Read, Write};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::process::ExitCode;

/// The program of a lab.
pub fn main<L: Lab>() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let named = |word: &str| L::NAMED.iter().find(|(name, _)| *name == word).map(|(_, case)| Ok((*case).to_owned()));
    let (text, picture) = match arguments[..] {
        [] => (standard_input(), None),
        ["svg"] if L::PICTURE.is_some() => (standard_input(), Some(None)),
        ["svg", case] if L::PICTURE.is_some() => (from_file(case), Some(None)),
        ["svg", case, picture] if L::PICTURE.is_some() => (from_file(case), Some(Some(picture))),
        [word] if named(word).is_some() => (named(word).unwrap_or_else(|| usage::<L>()), Some(None)),
        [word, picture] if named(word).is_some() => (named(word).unwrap_or_else(|| usage::<L>()), Some(Some(picture))),
        [case] if !case.starts_with('-') => (from_file(case), None),
        _ => (usage::<L>(), None),
    };
    let text = match text {
        Ok(text) => text,
        Err(problem) => {
            eprintln!("{problem}");
            return ExitCode::from(2);
        }
    };
    let mut output = if picture.is_some() { Output::only_problems() } else { Output::new() };
    let end = run::<L>(&text, &mut output);
    let Some(file) = picture else {
        return if end.mistakes == 0 { ExitCode::SUCCESS } else { ExitCode::from(2) };
    };
    if end.structure.is_none() {
        output.problem(&format!("there is nothing to draw; begin with {}", starts::<L>()));
    }
    let drawn = end.structure.zip(L::PICTURE).and_then(|(structure, picture)| {
        output.announce("svg");
        output.call(for_a_picture(&structure), || picture(&structure))
    });
    output.flush();
    match drawn {
        Some(text) if end.mistakes == 0 && !output.failed => write_picture(&text, file),
        _ => ExitCode::from(2),
    }
}

/// What the program prints for a text of cases. For tests.
pub fn answers<L: Lab>(text: &str) -> String {
    let mut output = Output::kept();
    run::<L>(text, &mut output);
    output.into_text()
}

fn usage<L: Lab>() -> Result<String, String> {
    let mut forms = vec!["CASE.txt".to_owned()];
    forms.extend(L::PICTURE.map(|_| "svg [CASE.txt [OUT.svg]]".to_owned()));
    forms.extend(L::NAMED.iter().map(|(name, _)| format!("{name} [OUT.svg]")));
    Err(format!("usage: cargo run [-- {}]", forms.join(" | ")))
}

/// Writes a picture into a file, or else to standard output.
fn write_picture(text: &str, file: Option<&str>) -> ExitCode {
    let written = match file {
        Some(file) => std::fs::write(file, text).map_err(|error| format!("{file} cannot be written: {error}")),
        None => std::io::stdout().write_all(text.as_bytes()).map_err(|error| error.to_string()),
    };
    match written {
        Ok(()) => ExitCode::SUCCESS,
        Err(problem) => {
            eprintln!("{problem}");
            ExitCode::from(2)
        }
    }
}

fn standard_input() -> Result<String, String> {
    if std::io::stdin().is_terminal() {
        eprintln!(
            "Type a case: a start, then calls, a line each; end it with Ctrl-D (on Windows: Ctrl-Z, then Enter)."
        );
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

/// A picture shows everything, may look at each record many times, and may make some of its own.
fn for_a_picture<S: Structure>(structure: &S) -> usize {
    100 * records(structure).max(1_000)
}

/// "rectangle, polygon or table"
fn starts<L: Lab>() -> String {
    let words: Vec<&str> = L::STARTS.iter().map(|start| start.word).collect();
    if words.is_empty() { "table".to_owned() } else { format!("{} or table", words.join(", ")) }
}

/// What is left when all lines have been read.
struct End<S> {
    /// How many lines could not be understood.
    mistakes: usize,
    /// The structure of the last case.
    structure: Option<S>,
}

/// Runs all cases of a text.
fn run<L: Lab>(text: &str, output: &mut Output) -> End<L::Structure> {
    let mut case: Option<Case<L>> = None;
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
    End { mistakes, structure }
}

/// A case that is being carried out.
struct Case<'a, L: Lab> {
    name: &'a str,
    structure: Option<L::Structure>,
    saved: Option<L::Structure>,
    /// What was dumped last, or the start.
    shown: Option<L::Structure>,
    names: Names<'a>,
    /// Whether the lines are those of a table.
    in_table: bool,
    last_dump: Option<String>,
}

/// Why a line was not carried out; an unset link is reported and is no mistake of the line.
enum Failure {
    Mistake(String),
    Reported,
}

impl From<String> for Failure {
    fn from(problem: String) -> Self {
        Self::Mistake(problem)
    }
}

impl<'a, L: Lab> Case<'a, L> {
    fn begin(name: &'a str, output: &mut Output) -> Self {
        output.line(&format!("case {name}"));
        // A lab without starts has nothing to begin with.
        let structure = L::STARTS.is_empty().then(L::Structure::default);
        let names = Names::default();
        Self { name, structure, saved: None, shown: None, names, in_table: false, last_dump: None }
    }

    fn end(self, output: &mut Output) -> Option<L::Structure> {
        output.line(&format!("end_case {}", self.name));
        output.flush();
        self.structure
    }

    fn line(&mut self, first: &str, rest: &[&'a str], line: Line, output: &mut Output) -> Result<(), String> {
        let done = if self.in_table { self.table_line(first, rest) } else { self.statement(first, rest, line, output) };
        match done {
            Ok(()) | Err(Failure::Reported) => Ok(()),
            Err(Failure::Mistake(problem)) => Err(problem),
        }
    }

    fn table_line(&mut self, first: &str, rest: &[&str]) -> Result<(), Failure> {
        if first == "end_table" {
            self.in_table = false;
            self.shown.clone_from(&self.structure);
            return Ok(());
        }
        Ok(read_record(self.structure.get_or_insert_default(), first, rest)?)
    }

    fn statement(&mut self, first: &str, rest: &[&'a str], line: Line, output: &mut Output) -> Result<(), Failure> {
        if let Some(start) = L::STARTS.iter().find(|start| start.word == first) {
            let made = (start.make)(rest).map_err(|problem| format!("{problem}; {}", start.usage))?;
            self.shown = Some(Clone::clone(&made));
            self.structure = Some(made);
            return Ok(());
        }
        if let Some(call) = L::CALLS.iter().find(|call| call.word == first) {
            return self.call(call, rest, line, output);
        }
        match (first, rest) {
            ("table", []) => {
                self.structure = Some(L::Structure::default());
                self.in_table = true;
            }
            ("save", []) => self.saved = Some(Clone::clone(self.structure()?)),
            ("restore", []) => {
                let saved = self.saved.as_ref().ok_or_else(|| "nothing was saved in this case".to_owned())?;
                self.structure = Some(Clone::clone(saved));
            }
            ("let", [name, "=", word]) => {
                let element = self.resolve(word, output)?;
                self.names.name::<L::Structure>(name, element)?;
            }
            ("dump", []) => self.dump(output)?,
            ("dump", ["changes"]) => self.dump_changes(output)?,
            ("reads", []) => output.line(&format!("reads {}", output.reads)),
            ("svg", []) if L::PICTURE.is_some() => self.svg(output)?,
            ("many", [count, word, budget]) => self.many(count, word, budget, output)?,
            _ => return Err(Failure::Mistake(not_understood(first, line.text))),
        }
        Ok(())
    }

    fn call(
        &mut self,
        call: &Call<L::Structure>,
        words: &[&str],
        line: Line,
        output: &mut Output,
    ) -> Result<(), Failure> {
        let arguments = self.arguments(call, words, line, output)?;
        let structure = self.structure()?;
        let words = arguments.iter().map(Argument::words).filter(|words| !words.is_empty());
        let words: String = words.map(|words| format!(" {words}")).collect();
        output.announce(&format!("{}{words}", call.word));
        if let Some(value) = output.call(records(structure), || (call.run)(structure, &arguments, Meter::new())) {
            output.line(format!("returned {}", value.words()).trim_end());
            let mut structures = Vec::new();
            value.structures(&mut structures);
            structures.into_iter().for_each(|text| output.lines("dump", text, "end_dump"));
        }
        Ok(())
    }

    fn arguments(
        &mut self,
        call: &Call<L::Structure>,
        words: &[&str],
        line: Line,
        output: &mut Output,
    ) -> Result<Vec<Argument>, Failure> {
        let wrong = || Failure::Mistake(format!("`{}` is not understood; {}", line.text, call.usage));
        let mut left = words;
        let mut arguments = Vec::new();
        for take in call.takes {
            let count = match take {
                Take::Point => 2,
                Take::Place => 3,
                Take::Numbers | Take::Points | Take::Places | Take::Wholes => left.len(),
                _ => 1,
            };
            let Some((taken, rest)) = left.split_at_checked(count) else { return Err(wrong()) };
            left = rest;
            arguments.push(match *take {
                Take::Id(letter) => Argument::Id(self.id(taken[0], letter, None, call, output)?),
                Take::IdOr(letter, link) => Argument::Id(self.id(taken[0], letter, Some(link), call, output)?),
                Take::Number => Argument::Number(coordinate(taken[0])?),
                Take::Numbers => {
                    Argument::Numbers(taken.iter().map(|word| coordinate(word)).collect::<Result<_, _>>()?)
                }
                Take::Truth => Argument::Truth(taken[0].parse().map_err(|_| wrong())?),
                Take::Point => Argument::Point([coordinate(taken[0])?, coordinate(taken[1])?]),
                Take::Points => Argument::Points(points(taken)?),
                Take::Whole => Argument::Whole(whole(taken[0])?),
                Take::Wholes => Argument::Wholes(taken.iter().map(|word| whole(word)).collect::<Result<_, _>>()?),
                Take::Place => Argument::Place([coordinate(taken[0])?, coordinate(taken[1])?, coordinate(taken[2])?]),
                Take::Places => Argument::Places(places(taken)?),
            });
        }
        if left.is_empty() { Ok(arguments) } else { Err(wrong()) }
    }

    /// The number of a record of a kind; or of another record, from which the link leads to it.
    fn id(
        &mut self,
        word: &str,
        letter: char,
        link: Option<&str>,
        call: &Call<L::Structure>,
        output: &mut Output,
    ) -> Result<usize, Failure> {
        let table_of = |element: Element| &L::Structure::TABLES[element.table];
        let mut element = self.resolve(word, output)?;
        if let Some(link) = link.filter(|_| table_of(element).letter != letter)
            && table_of(element).columns.iter().filter_map(|c| c.link()).any(|l| l.name == link && l.letter == letter)
        {
            element = follow(self.structure()?, element, link).map_err(|_| {
                output.problem(&format!("unresolved {word}.{link}"));
                Failure::Reported
            })?;
        }
        if table_of(element).letter == letter {
            return Ok(element.number);
        }
        Err(Failure::Mistake(format!("`{word}` is a {}; {}", table_of(element).name, call.usage)))
    }

    /// Calls a function that takes one record for `count` records, evenly spread over all of them, until the budget of
    /// reads is used up. One line says how many were asked, how many values came back, how many records were looked at,
    /// and for which record the most.
    fn many(&mut self, count: &str, word: &str, budget: &str, output: &mut Output) -> Result<(), Failure> {
        let (count, budget) = (whole(count)?, whole(budget)? as u64);
        let call = L::CALLS.iter().find(|call| call.word == word);
        let letter = call.and_then(|call| match call.takes {
            [Take::Id(letter) | Take::IdOr(letter, _)] => Some(*letter),
            _ => None,
        });
        let table = L::Structure::TABLES.iter().position(|table| Some(table.letter) == letter);
        let (Some(call), Some(letter), Some(table)) = (call, letter, table) else {
            return Err(Failure::Mistake("write `many 100 FUNCTION READS`, with a function of one record".to_owned()));
        };
        let structure = self.structure()?;
        let (length, records) = (structure.len(table), records(structure));
        output.announce(&format!("many {count} {word}"));
        let (mut asked, mut answers, mut reads, mut most) = (0, 0, 0, (0, 0));
        while asked < count.min(length) && reads <= budget {
            let number = asked * length / count.min(length);
            let arguments = [Argument::Id(number)];
            let Some(value) = output.call(records, || (call.run)(structure, &arguments, Meter::new())) else {
                return Ok(());
            };
            asked += 1;
            answers += value.count();
            reads += output.reads;
            most = most.max((output.reads, number));
        }
        // The one with the most reads once more, to its middle: where does it spend them?
        reads::begin_within(most.0 / 2);
        let _ = catch_unwind(AssertUnwindSafe(|| (call.run)(structure, &[Argument::Id(most.1)], Meter::new())));
        let place = reads::end().1.map_or_else(|| "-".to_owned(), |stop| stop.place());
        let most = format!("{} {letter}{} {place}", most.0, most.1);
        output.line(&format!("asked {asked} answers {answers} reads {reads} most {most}"));
        Ok(())
    }

    fn structure(&mut self) -> Result<&mut L::Structure, String> {
        let missing = || format!("there is no structure yet; begin with {}", starts::<L>());
        self.structure.as_mut().ok_or_else(missing)
    }

    fn resolve(&mut self, word: &str, output: &mut Output) -> Result<Element, Failure> {
        self.structure()?;
        let structure = self.structure.get_or_insert_default();
        self.names.resolve(structure, word).map_err(|problem| match problem {
            Unresolved::Mistake(problem) => Failure::Mistake(problem),
            Unresolved::Unset => {
                output.problem(&format!("unresolved {word}"));
                Failure::Reported
            }
        })
    }

    fn dump(&mut self, output: &mut Output) -> Result<(), String> {
        let dump = dump(self.structure()?);
        if self.last_dump.as_ref() == Some(&dump) {
            output.line("dump same");
        } else {
            output.lines("dump", &dump, "end_dump");
            self.last_dump = Some(dump);
            self.shown.clone_from(&self.structure);
        }
        Ok(())
    }

    /// The records that are not as they were at the last dump, or at the start.
    fn dump_changes(&mut self, output: &mut Output) -> Result<(), String> {
        let missing = || "nothing was dumped yet; write `dump`".to_owned();
        let before = self.shown.take().ok_or_else(missing)?;
        let text = changes(self.structure()?, &before);
        output.lines("dump changes", &text, "end_dump");
        self.last_dump = None;
        self.shown.clone_from(&self.structure);
        Ok(())
    }

    fn svg(&mut self, output: &mut Output) -> Result<(), String> {
        let structure = self.structure()?;
        let Some(picture) = L::PICTURE else { return Ok(()) };
        output.announce("svg");
        if let Some(picture) = output.call(for_a_picture(structure), || picture(structure)) {
            output.lines("svg", &picture, "end_svg");
        }
        Ok(())
    }
}

fn not_understood(first: &str, line: &str) -> String {
    let usage = match first {
        "let" => "write `let wall = h8.prev`",
        "many" => "write `many 100 FUNCTION READS`",
        "table" | "save" | "restore" | "reads" | "svg" => "it stands alone in its line",
        "dump" => "write `dump` or `dump changes`",
        _ => "the language is explained in README.md, «Typing a case by hand»",
    };
    format!("`{line}` is not understood; {usage}")
}
