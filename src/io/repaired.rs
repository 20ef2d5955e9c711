//! How much was repaired when a file was read.

use super::words::counted;

/// Things that were repaired, and where the first of them was.
#[derive(Debug, Default)]
pub(super) struct Repaired {
    count: usize,
    first: String,
}

impl Repaired {
    pub(super) fn add(&mut self, count: usize, place: impl Fn() -> String) {
        if self.count == 0 && count > 0 {
            self.first = place();
        }
        self.count += count;
    }

    /// How many there are.
    pub(super) fn count(&self) -> usize {
        self.count
    }

    /// Says which rings were closed.
    pub(super) fn note_closed(&self, notes: &mut Vec<String>) {
        let (one, many) = ("ring that did not end where it starts was", "rings that did not end where they start were");
        self.note(one, many, "closed", notes);
    }

    /// `2 rings that ... were closed, the first in features[3] polygon 0 ring 0`.
    pub(super) fn note(&self, one: &str, many: &str, done: &str, notes: &mut Vec<String>) {
        if self.count > 0 {
            notes.push(format!("{} {done}, the first in {}", counted(self.count, one, many), self.first));
        }
    }
}
