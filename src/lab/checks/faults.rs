//! Collecting what is wrong with a call.

use crate::fault::{Exchange, Fault, FaultKind};
use crate::protocol::{CallEnd, Value};
use dcel_kit::{Element, HalfEdgeId};
use std::fmt::Display;

/// What is wrong with one call. Of each rule of a test only the first fault is kept: the others are like it.
pub struct Faults<'a> {
    exchange: &'a Exchange<'a>,
    out: Vec<Fault>,
}

impl<'a> Faults<'a> {
    /// All that a judge finds; it gives up where nothing more can be said.
    pub fn found(exchange: &'a Exchange<'a>, judge: impl FnOnce(&mut Self) -> Option<()>) -> Vec<Fault> {
        let mut faults = Self { exchange, out: Vec::new() };
        judge(&mut faults);
        faults.out
    }

    /// What a call returned. That it did not is charged to these tests.
    pub fn returned<'e>(&mut self, end: &'e CallEnd, tests: &[&'static str]) -> Option<&'e [Value]> {
        if let CallEnd::Returned(values) = end {
            return Some(values);
        }
        let kind = FaultKind::of_end(end)?;
        tests.iter().for_each(|test| self.add(test, kind.clone(), "end", &end.words(), &[]));
        None
    }

    /// Something is wrong; the words follow the call.
    pub fn wrong(&mut self, test: &'static str, rule: &str, words: &str, elements: &[Element]) {
        if self.out.iter().any(|fault| fault.test == test && fault.rule == rule) {
            return;
        }
        self.add(test, FaultKind::Wrong, rule, words, elements);
    }

    /// As [`wrong`](Self::wrong), of any kind.
    pub fn add(&mut self, test: &'static str, kind: FaultKind, rule: &str, words: &str, elements: &[Element]) {
        let tag = without_new_numbers(words, self.exchange);
        let words = format!("{}: {words}", shown(&self.exchange.line()));
        let fault = Fault::new(test, kind, self.exchange.step, [rule, &tag], words);
        self.out.push(Fault { elements: elements.to_vec(), ..fault });
    }

    /// A field of a half-edge that is not what it should be, if it is not.
    pub fn field<T: Display + PartialEq>(
        &mut self,
        test: &'static str,
        rule: &str,
        (h, name): (HalfEdgeId, &str),
        [found, expected]: [Option<T>; 2],
    ) {
        if found != expected {
            let words = format!("{h}.{name} is {}, expected {}", named(found), named(expected));
            self.wrong(test, rule, &words, &[h.into()]);
        }
    }
}

/// A law that is broken: a word for it, and a sentence.
pub type Broken = (&'static str, String);

/// A law that holds, or is broken.
///
/// # Errors
/// It is broken.
pub fn law(holds: bool, tag: &'static str, words: impl FnOnce() -> String) -> Result<(), Broken> {
    told(holds.then_some(()), tag, words)
}

/// What is there by a law.
///
/// # Errors
/// It is not there.
pub fn told<T>(there: Option<T>, tag: &'static str, words: impl FnOnce() -> String) -> Result<T, Broken> {
    there.ok_or_else(|| (tag, words()))
}

/// An element in a sentence.
#[must_use]
pub fn named<T: Display>(element: Option<T>) -> String {
    element.map_or_else(|| "not set".to_owned(), |element| element.to_string())
}

/// Words in which new elements have no numbers: `h4.next = h*` for `h4.next = h17`. So they tell a mistake from others,
/// however a right or wrong program numbers what it makes.
fn without_new_numbers(words: &str, exchange: &Exchange) -> String {
    let given = |kind: char| {
        exchange.before().map_or(0, |before| match kind {
            'v' => before.vertices.len(),
            'h' => before.half_edges.len(),
            _ => before.faces.len(),
        })
    };
    let mut out = String::new();
    let mut rest = words;
    while let Some(end) = rest.find(|c: char| !c.is_alphanumeric()) {
        out.push_str(&of_element(&rest[..end], given));
        let next = rest[end..].chars().next().map_or(rest.len(), |c| end + c.len_utf8());
        out.push_str(&rest[end..next]);
        rest = &rest[next..];
    }
    out + &of_element(rest, given)
}

/// A word; a star in place of its number if it is the name of an element that was not there before.
fn of_element(word: &str, given: impl Fn(char) -> usize) -> String {
    let is_new = |kind: &char| {
        matches!(kind, 'v' | 'h' | 'f') && word[1..].parse::<usize>().is_ok_and(|number| number >= given(*kind))
    };
    word.chars().next().filter(is_new).map_or_else(|| word.to_owned(), |kind| format!("{kind}*"))
}

/// How many characters of a call stand in a sentence.
const SHOWN: usize = 80;

fn shown(line: &str) -> String {
    let cut: String = line.chars().take(SHOWN).collect();
    if cut.len() < line.len() { cut + " …" } else { cut }
}

#[cfg(test)]
mod tests {
    use super::of_element;

    #[test]
    fn new_elements_have_no_numbers() {
        let given = |kind| if kind == 'h' { 6 } else { 3 };
        let names = ["h5", "h6", "v2", "v17", "f3", "h", "hull", "12", "", "é6"];
        let told: Vec<String> = names.iter().map(|name| of_element(name, given)).collect();
        assert_eq!(told, ["h5", "h*", "v2", "v*", "f*", "h", "hull", "12", "", "é6"]);
    }
}
