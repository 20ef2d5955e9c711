//! A journal of a structure that holds more than its pointers: positions, inner components, borders.
//!
//! ```text
//!   pointers   new v5 | v5.outgoing: none -> h8 | ...            own   v5 stands at (1, 2)
//!              └─ 0      └─ 1                                          └─ after 1 change of the pointers
//! ```
//!
//! The own changes know how many changes of the pointers came before them, so that both are one sequence.

use super::Dcel;
use super::record::{Change, Journal, Recorder};

/// Keeps all changes of a structure: those of its pointers, and those of what it holds besides, of type `C`.
/// [`Subdivision::undo`](crate::plane::Subdivision::undo) and `Polyhedron::undo` take them back.
#[derive(Clone, PartialEq, Debug)]
pub struct Log<C> {
    kernel: Journal,
    /// Each with the number of changes of the kernel before it.
    own: Vec<(usize, C)>,
}

impl<C> Default for Log<C> {
    fn default() -> Self {
        Self { kernel: Journal::new(), own: Vec::new() }
    }
}

impl<C> Log<C> {
    /// An empty log.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// The changes of the pointers.
    #[must_use]
    pub fn kernel(&self) -> &Journal {
        &self.kernel
    }

    /// The changes of the pointers alone, for a film.
    #[must_use]
    pub fn into_kernel(self) -> Journal {
        self.kernel
    }

    /// The own changes, each with the number of changes of the pointers before it.
    #[must_use]
    pub fn own(&self) -> &[(usize, C)] {
        &self.own
    }

    /// How many changes there are of both kinds: a mark to undo back to.
    #[must_use]
    pub fn len(&self) -> usize {
        self.kernel.len() + self.own.len()
    }

    /// Whether nothing was recorded.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Appends an own change.
    pub(crate) fn push(&mut self, change: C) {
        self.own.push((self.kernel.len(), change));
    }

    /// Takes back the changes from the end until `mark` are left: the pointers in `dcel`, the rest by `put_back`,
    /// the latest first. O(changes taken back).
    pub(crate) fn take_back(&mut self, dcel: &mut Dcel, mark: usize, mut put_back: impl FnMut(C)) {
        while self.len() > mark {
            let pointers = mark.saturating_sub(self.own.len()).max(self.own.last().map_or(0, |&(at, _)| at));
            dcel.undo(&mut self.kernel, pointers);
            if self.len() > mark
                && let Some((_, change)) = self.own.pop()
            {
                put_back(change);
            }
        }
    }

    /// Tells another recorder all that is kept here, in order; `tell` passes on an own change.
    pub(crate) fn replay<R: Recorder>(self, rec: &mut R, mut tell: impl FnMut(&mut R, C)) {
        let mut own = self.own.into_iter().peekable();
        self.kernel.replay(rec, |rec, i| {
            while let Some((_, change)) = own.next_if(|&(at, _)| at <= i) {
                tell(rec, change);
            }
        });
        own.for_each(|(_, change)| tell(rec, change));
    }
}

impl<C> Recorder for Log<C> {
    fn step(&mut self, number: u32, what: &'static str) {
        self.kernel.step(number, what);
    }

    fn record(&mut self, change: Change) {
        self.kernel.record(change);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_log_with_an_own_change_alone_is_not_empty() {
        let mut log = Log::new();
        assert!(log.is_empty());
        log.push('a');
        assert!(!log.is_empty());
    }

    #[test]
    fn a_log_tells_steps_and_both_kinds_of_changes_in_the_order_in_which_they_came() {
        let (mut dcel, mut log, mut copy) = (Dcel::new(), Log::new(), Log::new());
        for (number, what, own) in [(1, "One.", 'a'), (2, "Two.", 'b')] {
            log.step(number, what);
            dcel.add_vertex_record(&mut log);
            log.push(own);
        }
        log.clone().replay(&mut copy, Log::push);
        assert_eq!(copy, log);
    }
}
