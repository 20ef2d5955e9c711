//! Reading an answer, line by line, against the cases that were asked.
//!
//! Only lines with the token are the driver's; every other line was printed by the student's code, and is kept
//! aside. A line of the driver's that is not due breaks its case; reading goes on with the next case.

use super::answer::{Answers, Broken, CallEnd, Called, CaseAnswer, Many, Pattern, Reply, Stopped};
use super::case::{Case, Step};
use super::dump::Dump;
use super::structure::{Schema, Structure};
use super::text::{cut, id, quoted};
use super::value::{self, Unreadable, Value};
use std::borrow::Cow;
use std::iter::Peekable;

/// How many bytes of a line are read.
const LINE: usize = 64 * 1024;
/// How much of the student's printing is kept.
const PRINTED: usize = 4 * 1024;
/// How many lines a drawing may have.
const SVG_LINES: usize = 20_000;
/// How many elements are named of a call that was stopped.
const ELEMENTS: usize = 24;
/// How many structures a call may return.
const STRUCTURES: usize = 16;

/// Reads what a driver printed in answer to `cases`, whose structures look like `schema`.
///
/// Never fails: whatever is missing or wrong is said in the answer of its case. Cost: O(length of the text).
#[must_use]
pub fn read_answers(stdout: &[u8], token: &str, cases: &[&Case], schema: Schema) -> Answers {
    let mut answers = Answers::default();
    let prefix = format!("@{token} ");
    let mut printed = Vec::new();
    let mut driver = Vec::new();
    for line in stdout.split(|&byte| byte == b'\n') {
        let line = line.strip_suffix(b"\r").unwrap_or(line);
        if let Some(said) = line.strip_prefix(prefix.as_bytes()) {
            driver.push(said);
        } else if !line.is_empty() && printed.len() < PRINTED {
            printed.extend_from_slice(line);
            printed.push(b'\n');
        }
    }
    printed.truncate(PRINTED);
    answers.printed = String::from_utf8_lossy(&printed).into_owned();
    let mut lines = Lines { lines: driver.into_iter().enumerate().peekable(), schema, in_pieces: false };
    for case in cases {
        let Some(answer) = lines.case(case) else { break };
        answers.cases.push(answer);
    }
    while let Some((_, line)) = lines.next() {
        if line.starts_with("error ") && answers.complaint.is_none() {
            answers.complaint = Some(cut(&line));
        }
        answers.done = line == "done" && lines.lines.peek().is_none();
    }
    answers
}

/// The lines of the driver, with their numbers among them.
struct Lines<'a, I: Iterator<Item = (usize, &'a [u8])>> {
    lines: Peekable<I>,
    schema: Schema,
    /// Whether the last case was broken, so that the rest of it may stand before the next one.
    in_pieces: bool,
}

impl<'a, I: Iterator<Item = (usize, &'a [u8])>> Lines<'a, I> {
    fn next(&mut self) -> Option<(usize, Cow<'a, str>)> {
        let (number, line) = self.lines.next()?;
        Some((number + 1, text(line)))
    }

    fn peek_is(&mut self, wanted: &str) -> bool {
        self.lines.peek().is_some_and(|(_, line)| *line == wanted.as_bytes())
    }

    /// The answer to a case; `None` if it was not begun.
    fn case(&mut self, case: &Case) -> Option<CaseAnswer> {
        let begin = format!("case {}", case.name);
        let mut answer = CaseAnswer::default();
        while !self.peek_is(&begin) {
            let &(number, line) = self.lines.peek()?;
            if line == b"done" || line.starts_with(b"error ") {
                return None;
            }
            if !self.in_pieces {
                answer.broken.get_or_insert_with(|| expected(number + 1, format!("`{begin}`"), &text(line)));
            }
            self.lines.next();
        }
        self.lines.next();
        match self.replies(case, &mut answer.replies) {
            Ok(complete) => answer.complete = complete && answer.broken.is_none(),
            Err(broken) => {
                answer.broken.get_or_insert(broken);
            }
        }
        self.in_pieces = answer.broken.is_some();
        Some(answer)
    }

    /// Whether the answer came to its end; not if the lines ran out.
    fn replies(&mut self, case: &Case, replies: &mut Vec<Reply>) -> Result<bool, Broken> {
        let mut last: Option<Structure> = None;
        for step in case.steps.iter().filter(|step| step.is_answered()) {
            let Some((number, line)) = self.next() else { return Ok(false) };
            if line.len() >= LINE {
                return Err(Broken::TooMuch { line: number, what: "bytes in a line", cap: LINE });
            }
            let reply = match step {
                Step::Call { function, arguments } => self.call(number, &line, function, arguments.len())?,
                Step::Svg => self.svg(number, &line)?,
                Step::Reads => Some(Reply::Reads(reads(number, &line)?)),
                Step::Many { function, .. } => self.many(number, &line, function)?,
                Step::Changes => {
                    let base = last.take().or_else(|| case.start.structure().cloned());
                    let base = base.ok_or(Broken::NothingBefore { line: number })?;
                    let structure = self.dump(number, &line, "dump changes", Dump::on(base))?;
                    last.clone_from(&structure);
                    structure.map(Reply::Dump)
                }
                _ if line == "dump same" => {
                    let same = last.clone().ok_or(Broken::NothingBefore { line: number })?;
                    Some(Reply::Dump(same))
                }
                _ => {
                    let structure = self.dump(number, &line, "dump", Dump::new(self.schema))?;
                    last.clone_from(&structure);
                    structure.map(Reply::Dump)
                }
            };
            let Some(reply) = reply else { return Ok(false) };
            replies.push(reply);
        }
        let Some((number, line)) = self.next() else { return Ok(false) };
        let end = format!("end_case {}", case.name);
        if line == end { Ok(true) } else { Err(expected(number, format!("`{end}`"), &line)) }
    }

    fn call(&mut self, number: usize, line: &str, function: &str, arguments: usize) -> Result<Option<Reply>, Broken> {
        if let Some(word) = line.strip_prefix("unresolved ") {
            return Ok(Some(Reply::Unresolved(cut(word))));
        }
        let mut words = line.split(' ');
        if words.next() != Some("call") || words.next() != Some(function) {
            return Err(expected(number, format!("`call {function}`"), line));
        }
        let words: Vec<&str> = words.collect();
        let is_argument = |word: &&str| id(word).is_some() || matches!(*word, "true" | "false") || is_number(word);
        if words.len() != arguments || !words.iter().all(is_argument) {
            return Err(expected(number, format!("`call {function}` and {arguments} numbers"), line));
        }
        let numbers: Vec<u32> = words.into_iter().map(id).collect::<Option<_>>().unwrap_or_default();
        let Some((number, line)) = self.next() else { return Ok(None) };
        let end = if let Some(rest) = line.strip_prefix("returned") {
            match self.returned(number, rest)? {
                Some(values) => CallEnd::Returned(values),
                None => return Ok(None),
            }
        } else if let Some(end) = not_returned(number, &line)? {
            end
        } else {
            return Err(expected(number, "`returned`, `panicked` or `stopped`".to_owned(), &line));
        };
        Ok(Some(Reply::Called(Called { arguments: numbers, end })))
    }

    /// The values of a line, and the structures among them, whose lines follow.
    fn returned(&mut self, line: usize, rest: &str) -> Result<Option<Vec<Value>>, Broken> {
        let text = match rest.strip_prefix(' ') {
            Some("") => return Err(expected(line, "a value".to_owned(), rest)),
            Some(text) => text,
            None if rest.is_empty() => "",
            None => return Err(expected(line, "`returned`".to_owned(), rest)),
        };
        let mut values = value::read(text).map_err(|error| match error {
            Unreadable::From(word) => Broken::Number { line, word: cut(word), wanted: "a value" },
            Unreadable::TooMany => Broken::TooMuch { line, what: "values", cap: value::MOST },
        })?;
        let mut structures = Vec::new();
        of_structures(&mut values, &mut structures);
        if structures.len() > STRUCTURES {
            return Err(Broken::TooMuch { line, what: "structures", cap: STRUCTURES });
        }
        for place in structures {
            let Some((number, line)) = self.next() else { return Ok(None) };
            let Some(structure) = self.dump(number, &line, "dump", Dump::new(self.schema))? else { return Ok(None) };
            *place = structure;
        }
        Ok(Some(values))
    }

    fn svg(&mut self, number: usize, line: &str) -> Result<Option<Reply>, Broken> {
        if line != "call svg" {
            return Err(expected(number, "`call svg`".to_owned(), line));
        }
        let Some((number, line)) = self.next() else { return Ok(None) };
        if let Some(end) = not_returned(number, &line)? {
            return Ok(Some(Reply::Called(Called { arguments: Vec::new(), end })));
        }
        if line != "svg" {
            return Err(expected(number, "`svg` or `panicked`".to_owned(), &line));
        }
        let mut drawing = String::new();
        for _ in 0..SVG_LINES {
            let Some((_, line)) = self.next() else { return Ok(None) };
            if line == "end_svg" {
                return Ok(Some(Reply::Svg(drawing)));
            }
            drawing.push_str(&line);
            drawing.push('\n');
        }
        Err(Broken::TooMuch { line: number + SVG_LINES, what: "lines in a drawing", cap: SVG_LINES })
    }

    fn many(&mut self, number: usize, line: &str, function: &str) -> Result<Option<Reply>, Broken> {
        if !line.starts_with("call many ") || !line.ends_with(function) {
            return Err(expected(number, format!("`call many` and {function}"), line));
        }
        let Some((number, line)) = self.next() else { return Ok(None) };
        if let Some(end) = not_returned(number, &line)? {
            return Ok(Some(Reply::Called(Called { arguments: Vec::new(), end })));
        }
        many(&line).map(|many| Some(Reply::Many(many))).ok_or_else(|| expected(number, "`asked`".to_owned(), &line))
    }

    fn dump(&mut self, number: usize, line: &str, due: &str, mut dump: Dump) -> Result<Option<Structure>, Broken> {
        if line != due {
            return Err(expected(number, format!("`{due}`"), line));
        }
        loop {
            let Some((number, line)) = self.next() else { return Ok(None) };
            if line == "end_dump" {
                return dump.end(number).map(Some);
            }
            dump.line(number, &line)?;
        }
    }
}

fn text(line: &[u8]) -> Cow<'_, str> {
    String::from_utf8_lossy(&line[..line.len().min(LINE)])
}

fn expected(line: usize, expected: String, found: &str) -> Broken {
    Broken::Expected { line, expected, found: cut(found) }
}

/// The places of the structures among some values, in their order.
fn of_structures<'a>(values: &'a mut [Value], out: &mut Vec<&'a mut Structure>) {
    for value in values {
        match value {
            Value::Structure(structure) => out.push(structure),
            Value::List(values) => of_structures(values, out),
            _ => {}
        }
    }
}

fn is_number(word: &str) -> bool {
    word.parse::<f64>().is_ok()
}

/// How a call ended that did not return; `None` if the line says something else.
fn not_returned(line: usize, said: &str) -> Result<Option<CallEnd>, Broken> {
    let (end, due) = if let Some(rest) = said.strip_prefix("panicked ") {
        (panicked(rest), "a message in quotes")
    } else if let Some(rest) = said.strip_prefix("stopped ") {
        (stopped(rest), "a number of reads and what they were")
    } else {
        return Ok(None);
    };
    end.map(Some).ok_or_else(|| expected(line, due.to_owned(), said))
}

/// `reads 32`
fn reads(line: usize, said: &str) -> Result<u64, Broken> {
    let number = said.strip_prefix("reads ").and_then(|word| word.parse().ok());
    number.ok_or_else(|| expected(line, "`reads` and a number".to_owned(), said))
}

/// `asked 10000 answers 39734 reads 89468 most 9 v22648 src/lab.rs:41:9`
fn many(said: &str) -> Option<Many> {
    let words: Vec<&str> = said.split(' ').collect();
    let &["asked", asked, "answers", answers, "reads", reads, "most", most, element, place] = &words[..] else {
        return None;
    };
    Some(Many {
        asked: asked.parse().ok()?,
        answers: answers.parse().ok()?,
        reads: reads.parse().ok()?,
        most: most.parse().ok()?,
        element: id(element.get(1..)?)?,
        place: (place != "-").then(|| cut(place)),
    })
}

/// `1401 circle src/lab.rs:41:9 h3 h7`: reads, how they follow each other, where the last came from, what was read.
fn stopped(rest: &str) -> Option<CallEnd> {
    let mut words = rest.split(' ');
    let reads = words.next()?.parse().ok()?;
    let pattern = match words.next()? {
        "circle" => Pattern::Circle,
        "scan" => Pattern::Scan,
        "open" => Pattern::Open,
        _ => return None,
    };
    let place = words.next().filter(|place| !matches!(*place, "-" | "")).map(cut);
    let is_element = |word: &&str| {
        let digits = word.trim_start_matches(|c: char| c.is_ascii_lowercase());
        digits.len() < word.len() && word.len() <= 16 && id(digits).is_some()
    };
    let elements = words.filter(is_element).take(ELEMENTS).map(str::to_owned).collect();
    Some(CallEnd::Stopped(Stopped { reads, pattern, place, elements }))
}

/// `"message" place`
fn panicked(rest: &str) -> Option<CallEnd> {
    let (message, place) = quoted(rest)?;
    let place = place.trim();
    Some(CallEnd::Panicked { message, place: (!place.is_empty()).then(|| cut(place)) })
}
