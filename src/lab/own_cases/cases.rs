//! The file of own cases, and what the answers of a program say of it.

use crate::cases::random::fresh_seed;
use crate::{End, Program};
use std::fmt::Write;

/// More cases, or longer ones, would take longer than they are worth.
const MOST_LINES: usize = 2000;

/// Cases with expected answers.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct OwnCases(Vec<OwnCase>);

#[derive(Clone, PartialEq, Eq, Debug)]
struct OwnCase {
    name: String,
    /// What the program is asked: `reads` in the place of each expectation, which is answered by one line.
    lines: Vec<String>,
    expected: Vec<Expected>,
}

#[derive(Clone, PartialEq, Eq, Debug)]
struct Expected {
    line: usize,
    how: How,
    words: Vec<String>,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum How {
    Exactly,
    Cycle,
    Set,
    Refused,
    Nothing,
}

/// Why a file holds no own cases: its line, and what to write.
#[derive(Clone, PartialEq, Eq, Debug, thiserror::Error)]
#[error("{file}:{line}: {what}")]
pub struct OwnCaseError {
    /// The file.
    pub file: String,
    /// The line, from 1.
    pub line: usize,
    /// What is wrong, and what to write.
    pub what: String,
}

impl OwnCases {
    /// Reads cases; `file` is the name of the text in messages.
    ///
    /// # Errors
    /// [`OwnCaseError`] with the line.
    pub fn parse(text: &str, file: &str) -> Result<Self, OwnCaseError> {
        let mut cases: Vec<OwnCase> = Vec::new();
        for (i, line) in text.trim_start_matches('\u{feff}').lines().enumerate() {
            let line_number = i + 1;
            let wrong = |what: &str| OwnCaseError { file: file.to_owned(), line: line_number, what: what.to_owned() };
            let mut words = line.split('#').next().unwrap_or_default().split_whitespace();
            let Some(first) = words.next() else { continue };
            if i >= MOST_LINES {
                return Err(wrong("a file of own cases has at most 2000 lines; keep those that catch the most"));
            }
            let rest: Vec<String> = words.map(str::to_owned).collect();
            match first {
                "case" => {
                    let name = if rest.is_empty() { format!("line {line_number}") } else { rest.join(" ") };
                    cases.push(OwnCase { name, lines: Vec::new(), expected: Vec::new() });
                }
                "token" | "reads" | "many" | "svg" => {
                    return Err(wrong(&format!(
                        "`{first}` cannot stand in an own case; write a start, calls, and `expect`"
                    )));
                }
                _ if cases.is_empty() => return Err(wrong("a case begins with its name; write `case the outer face`")),
                "expect" => {
                    let Some(case) = cases.last_mut().filter(|case| !case.lines.is_empty()) else {
                        return Err(wrong("`expect` stands below a call; write the call above it"));
                    };
                    let (how, words) = expectation(rest).map_err(|what| wrong(&what))?;
                    case.expected.push(Expected { line: line_number, how, words });
                    case.lines.push("reads".to_owned());
                }
                _ => {
                    if let Some(case) = cases.last_mut() {
                        case.lines.push(std::iter::once(first.to_owned()).chain(rest).collect::<Vec<_>>().join(" "));
                    }
                }
            }
        }
        cases.retain(|case| !case.expected.is_empty());
        Ok(Self(cases))
    }

    /// Whether nothing is expected.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// What the cases are called, in their order.
    #[must_use]
    pub fn names(&self) -> Vec<String> {
        self.0.iter().map(|case| format!("`{}`", case.name)).collect()
    }

    /// Those that are chosen.
    pub(super) fn only(&self, chosen: &[bool]) -> Self {
        Self(self.0.iter().zip(chosen).filter(|(_, chosen)| **chosen).map(|(case, _)| case.clone()).collect())
    }

    /// Runs all cases in one program; for each what is not as expected, if something is.
    #[must_use]
    pub fn run(&self, program: &dyn Program) -> Vec<Option<String>> {
        let token = format!("{:016x}", fresh_seed());
        let mut input = format!("token {token}\n");
        for (i, case) in self.0.iter().enumerate() {
            let _ = writeln!(input, "case own{i}\n{}", case.lines.join("\n"));
        }
        let ran = program.run(&input);
        let prefix = format!("@{token} ");
        let answers = String::from_utf8_lossy(&ran.stdout).into_owned();
        let answers: Vec<&str> = answers.lines().filter_map(|line| line.strip_prefix(&prefix)).collect();
        let of_case = |i: usize| {
            let begin = answers.iter().position(|line| *line == format!("case own{i}"));
            let rest = begin.map_or(&[][..], |begin| &answers[begin + 1..]);
            &rest[..rest.iter().position(|line| *line == format!("end_case own{i}")).unwrap_or(rest.len())]
        };
        let ended = if ran.end == End::Exited(0) {
            "the program gives no answer"
        } else {
            "the program ends before it answers"
        };
        self.0.iter().enumerate().map(|(i, case)| case.judged(of_case(i), ended)).collect()
    }
}

impl OwnCase {
    /// What is not as expected in the answers to this case.
    fn judged(&self, answers: &[&str], ended: &str) -> Option<String> {
        let mut last: Result<&str, String> = Err("nothing was called".to_owned());
        let mut expected = self.expected.iter();
        for answer in answers {
            let (first, rest) = answer.split_once(' ').unwrap_or((answer, ""));
            match first {
                "call" => last = Err("the call gives no answer".to_owned()),
                "returned" => last = Ok(rest),
                "panicked" | "stopped" | "unresolved" | "error" => last = Err((*answer).to_owned()),
                "reads" => {
                    let Some(expected) = expected.next() else { continue };
                    let place = format!("line {}", expected.line);
                    match &last {
                        Err(why) => return Some(format!("{place}: {why}")),
                        Ok(said) if !expected.holds(said) => {
                            return Some(format!("{place}: expected {}, answered {said:?}", expected.told()));
                        }
                        Ok(_) => {}
                    }
                }
                _ => {}
            }
        }
        expected.next().map(|expected| format!("line {}: {ended}", expected.line))
    }
}

impl Expected {
    fn holds(&self, said: &str) -> bool {
        let words: Vec<&str> = said.split_whitespace().collect();
        let equal = |words: &mut dyn Iterator<Item = &&str>| {
            self.words.iter().zip(words).all(|(expected, said)| is_same(expected, said))
        };
        match self.how {
            How::Refused => words.first() == Some(&"refused"),
            How::Nothing => words.is_empty(),
            _ if words.len() != self.words.len() => false,
            How::Exactly => equal(&mut words.iter()),
            How::Cycle => (0..words.len().max(1)).any(|start| equal(&mut words.iter().cycle().skip(start))),
            How::Set => {
                let mut left = words.clone();
                let mut take = |expected: &String| {
                    let found = left.iter().position(|said| is_same(expected, said));
                    found.map(|found| left.remove(found)).is_some()
                };
                self.words.iter().all(&mut take)
            }
        }
    }

    fn told(&self) -> String {
        let how = match self.how {
            How::Exactly => "",
            How::Cycle => "cycle ",
            How::Set => "set ",
            How::Refused => return "a refusal".to_owned(),
            How::Nothing => return "nothing".to_owned(),
        };
        format!("{how}{}", self.words.join(" "))
    }
}

/// How an answer is compared, and its words.
fn expectation(words: Vec<String>) -> Result<(How, Vec<String>), String> {
    if let Some(word) = words.iter().find(|word| word.contains('.') && word.parse::<f64>().is_err()) {
        return Err(format!("`{word}` is no answer: expect elements that are given, such as h2, or numbers"));
    }
    let how = match words.first().map(String::as_str) {
        None => return Err("`expect` says what is answered; write `expect true` or `expect cycle h0 h2 h4`".to_owned()),
        Some("cycle") => How::Cycle,
        Some("set") => How::Set,
        Some("refused") => How::Refused,
        Some("nothing") => How::Nothing,
        Some(_) => return Ok((How::Exactly, words)),
    };
    Ok((how, words.into_iter().skip(1).collect()))
}

/// Whether an answer is the expected word: `h2` stands for 2, and numbers are compared as numbers.
fn is_same(expected: &str, said: &str) -> bool {
    let without_letter = expected.strip_prefix(|c: char| c.is_ascii_lowercase());
    let id = without_letter.filter(|rest| !rest.is_empty() && rest.bytes().all(|b| b.is_ascii_digit()));
    let (expected, said) = (id.unwrap_or(expected), said.trim_start_matches('#'));
    let numbers = expected.parse::<f64>().ok().zip(said.parse::<f64>().ok());
    expected == said || numbers.is_some_and(|(a, b)| a.partial_cmp(&b).is_some_and(std::cmp::Ordering::is_eq))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Ran;

    fn expected(text: &str) -> Expected {
        let (how, words) = expectation(text.split_whitespace().map(str::to_owned).collect()).unwrap();
        Expected { line: 1, how, words }
    }

    #[test]
    fn answers_are_compared_as_it_is_asked() {
        for (wanted, said, holds) in [
            ("true", "true", true),
            ("h2", "2", true),
            ("h2", "3", false),
            ("0.5", "#0.5", true),
            ("1 2 3", "1 2 3", true),
            ("1 2 3", "2 3 1", false),
            ("cycle h1 h2 h3", "2 3 1", true),
            ("cycle 1 2 3", "3 2 1", false),
            ("cycle 1 2 3", "1 2 3 1 2 3", false),
            ("set 1 2 2", "2 1 2", true),
            ("set 1 2 2", "2 1 1", false),
            ("refused", "refused \"no\"", true),
            ("nothing", "", true),
            ("nothing", "0", false),
        ] {
            assert_eq!(expected(wanted).holds(said), holds, "{wanted}: {said}");
        }
    }

    /// Answers each call with 7, and dies at `die`.
    struct Seven;

    impl Program for Seven {
        fn run(&self, input: &str) -> Ran {
            let token = input.lines().next().unwrap().split_once(' ').unwrap().1;
            let (mut out, mut case) = (String::new(), "");
            for line in input.lines().skip(1).chain(["case end"]) {
                let said = match line.split_once(' ') {
                    Some(("case", name)) => {
                        let end = format!("end_case {case}\n@{token} case {name}");
                        case = name;
                        end
                    }
                    _ if line == "die" => break,
                    _ if line == "lost" => "unresolved h0.next".to_owned(),
                    _ if line == "reads" => "reads 3".to_owned(),
                    _ => format!("call x\n@{token} returned 7"),
                };
                let _ = writeln!(out, "@{token} {said}\nreads 9\nreturned 8");
            }
            Ran { stdout: out.into_bytes(), stderr: Vec::new(), end: End::Exited(0), millis: 0 }
        }
    }

    #[test]
    fn each_case_is_judged_by_its_own_answers() {
        let text = "case a\nx\nexpect 7\ncase b # comment\nx\n\nexpect 7\nx\nexpect 8\ncase c\nx\nlost\nexpect 7\n\
                    case nothing\nx\ncase d\ndie\nexpect 7\ncase e\nx\nexpect 7\n";
        let cases = OwnCases::parse(text, "own.txt").unwrap();
        assert_eq!(cases.names(), ["`a`", "`b`", "`c`", "`d`", "`e`"]);
        let said = cases.run(&Seven);
        let said: Vec<&str> = said.iter().map(|why| why.as_deref().unwrap_or("right")).collect();
        assert_eq!(
            said,
            [
                "right",
                "line 9: expected 8, answered \"7\"",
                "line 13: unresolved h0.next",
                "line 18: the program gives no answer",
                "line 21: the program gives no answer",
            ]
        );
    }

    #[test]
    fn what_is_no_case_is_named_with_its_line() {
        for (text, line, what) in [
            ("rectangle\n", 1, "write `case the outer face`"),
            ("case a\nexpect 7\n", 2, "below a call"),
            ("case a\nx\nexpect\n", 3, "write `expect true`"),
            ("case a\nx\nexpect h0.next\n", 3, "`h0.next` is no answer"),
            ("case a\ntoken x\n", 2, "`token` cannot stand"),
        ] {
            let error = OwnCases::parse(text, "own.txt").unwrap_err();
            assert!(error.line == line && error.to_string().contains(what), "{error}");
        }
        assert!(OwnCases::parse("# nothing yet\n", "own.txt").unwrap().is_empty());
    }
}
