//! Collecting what is wrong with a call.

use crate::fault::{Exchange, Fault, FaultKind};
use dcel_kit::Element;

/// What is wrong with one call. Of each rule of a test only the first fault is kept: the others are like it.
pub struct Faults<'a> {
    exchange: &'a Exchange<'a>,
    out: Vec<Fault>,
}

impl<'a> Faults<'a> {
    /// Nothing yet.
    pub fn of(exchange: &'a Exchange<'a>) -> Self {
        Self { exchange, out: Vec::new() }
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
        let words = format!("{}: {words}", shown(&self.exchange.line()));
        let fault = Fault::new(test, kind, self.exchange.step, [rule, ""], words);
        self.out.push(Fault { elements: elements.to_vec(), ..fault });
    }

    /// All of it.
    pub fn all(self) -> Vec<Fault> {
        self.out
    }
}

/// How many characters of a call stand in a sentence.
const SHOWN: usize = 80;

fn shown(line: &str) -> String {
    let cut: String = line.chars().take(SHOWN).collect();
    if cut.len() < line.len() { cut + " …" } else { cut }
}
