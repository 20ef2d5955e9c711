//! What is printed, and the guard around every call of yours.
//!
//! Lines are collected, and written before each call and at the end of each case. A panic of yours ends the call, not
//! the case.

use super::reads::{self, Stop};
use std::io::Write;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::{Mutex, PoisonError};

/// Where the last panic came from.
static PLACE: Mutex<Option<String>> = Mutex::new(None);

/// How a call ended that did not return.
enum Failed {
    /// A panic: its message and its place.
    Panicked(String),
    /// It looked at too many records.
    Stopped(Stop),
}

/// What is printed.
pub(super) struct Output {
    /// What every line begins with, so that lines of yours cannot be mistaken for them.
    pub(super) prefix: String,
    text: String,
    /// Whether only problems are printed, on standard error; standard output is for a picture.
    only_problems: bool,
    /// Whether nothing is written: the text is asked for in the end.
    kept: bool,
    /// Whether a call did not return.
    pub(super) failed: bool,
    /// How many records the last call looked at.
    pub(super) reads: u64,
}

impl Output {
    pub(super) fn new() -> Self {
        Self { prefix: String::new(), text: String::new(), only_problems: false, kept: false, failed: false, reads: 0 }
    }

    pub(super) fn only_problems() -> Self {
        Self { only_problems: true, ..Self::new() }
    }

    pub(super) fn kept() -> Self {
        Self { kept: true, ..Self::new() }
    }

    /// What was printed into a text that is kept.
    pub(super) fn into_text(self) -> String {
        self.text
    }

    pub(super) fn line(&mut self, line: &str) {
        if !self.only_problems {
            self.problem(line);
        }
    }

    pub(super) fn lines(&mut self, begin: &str, text: &str, end: &str) {
        self.line(begin);
        text.lines().for_each(|line| self.line(line));
        self.line(end);
    }

    pub(super) fn problem(&mut self, line: &str) {
        self.text.push_str(&self.prefix);
        self.text.push_str(line);
        self.text.push('\n');
    }

    pub(super) fn flush(&mut self) {
        if self.kept || self.text.is_empty() {
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

    /// Says that a call comes now. It is written before the call is made: the call may end the program.
    pub(super) fn announce(&mut self, words: &str) {
        self.line(&format!("call {words}"));
        self.flush();
    }

    /// Makes a call of yours in a structure of so many records; `None`, and a line about it, if it does not return.
    pub(super) fn call<T>(&mut self, records: usize, call: impl FnOnce() -> T) -> Option<T> {
        remember_places();
        reads::begin(records);
        let outcome = catch_unwind(AssertUnwindSafe(call));
        let (reads, stop) = reads::end();
        self.reads = reads;
        let failed = match (outcome, stop) {
            // One that was to be ended and has caught that does not count as answered.
            (outcome, Some(stop)) => {
                std::mem::forget(outcome);
                Failed::Stopped(stop)
            }
            (Ok(value), None) => return Some(value),
            (Err(payload), None) => {
                let message = message(payload.as_ref());
                // Dropping what was thrown could run code of yours outside the guard.
                std::mem::forget(payload);
                let place = PLACE.lock().unwrap_or_else(PoisonError::into_inner).take();
                Failed::Panicked(format!("{message:?} {}", place.unwrap_or_default()))
            }
        };
        self.failed = true;
        match failed {
            Failed::Panicked(words) => self.problem(format!("panicked {words}").trim_end()),
            Failed::Stopped(stop) => self.problem(&format!("stopped {}", stop.words())),
        }
        None
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
            *PLACE.lock().unwrap_or_else(PoisonError::into_inner) = Some(reads::place(place));
        }
    }));
}
