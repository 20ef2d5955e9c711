//! The moments of an edit: what one frame shows of its steps.
//!
//! ```text
//!   step 3 of split_in_half: 3 origins, 4 nexts with their prevs, 2 faces, 1 outgoing
//!     (1 of 4: origin)     h8.origin = v4, …
//!     (2 of 4: next)       h0.next = h8, …       prev is next backwards
//!     (3 of 4: face)       h8.face = f1, …
//!     (4 of 4: outgoing)   v4.outgoing = h8
//! ```
//!
//! A step that has nothing to do is no moment: it is named in the next one. A step with few assignments is one moment. One with more is cut by the family of the pointers: what comes first, then
//! each family in the order in which the step takes it up, then what goes. No pointer is written in two moments of a
//! step, so that the order of the moments makes no difference to what they lead to.

use crate::topology::{Change, Journal, Slot};

/// A step with more assignments than this is cut.
const MOST: usize = 4;

/// What one frame shows.
pub(super) struct Moment {
    /// The step, and which part of it.
    pub(super) heading: String,
    /// The steps before it that had nothing to do; or after it, if it is the last one.
    pub(super) idle: Vec<u32>,
    pub(super) changes: Vec<Change>,
}

crate::named! {
    /// What belongs together in a step.
    #[derive(Clone, Copy, PartialEq, Eq)]
    enum Part {
        Added = "what is new",
        Origin = "origin",
        Next = "next",
        Face = "face",
        Outgoing = "outgoing",
        HalfEdge = "half-edge of a face",
        Removed = "what goes",
    }

    /// What it is called.
    fn name;
}

impl Part {
    /// The part of a change; what is cleared belongs to what goes, if something does.
    fn of(change: &Change, has_removed: bool) -> Self {
        match change {
            Change::Added { .. } => Self::Added,
            Change::Removed { .. } => Self::Removed,
            Change::Write { new: None, .. } if has_removed => Self::Removed,
            Change::Write { slot, .. } => match slot {
                Slot::Origin(_) => Self::Origin,
                Slot::Next(_) | Slot::Prev(_) => Self::Next,
                Slot::Face(_) => Self::Face,
                Slot::Outgoing(_) => Self::Outgoing,
                Slot::HalfEdge(_) => Self::HalfEdge,
            },
        }
    }
}

/// The moments of all steps, in order.
pub(super) fn moments(journal: &Journal) -> Vec<Moment> {
    let mut out: Vec<Moment> = Vec::new();
    let mut idle = Vec::new();
    for (i, step) in journal.steps().iter().enumerate() {
        let changes = journal.changes_of_step(i);
        if changes.is_empty() {
            idle.push(step.number);
            continue;
        }
        let heading = format!("{} {}", step.number, step.what);
        let is_long = changes.iter().filter(|change| is_assignment(change)).count() > MOST;
        let parts = if is_long { cut(changes) } else { Vec::new() };
        if parts.len() < 2 {
            out.push(Moment { heading, idle: std::mem::take(&mut idle), changes: changes.to_vec() });
            continue;
        }
        let count = parts.len();
        out.extend(parts.into_iter().enumerate().map(|(k, (part, changes))| Moment {
            heading: format!("{heading} ({} of {count}: {})", k + 1, part.name()),
            idle: std::mem::take(&mut idle),
            changes,
        }));
    }
    if let Some(last) = out.last_mut() {
        last.idle.extend(idle);
    }
    out
}

/// `prev` is written with `next`, and what is cleared is not set.
const fn is_assignment(change: &Change) -> bool {
    matches!(change, Change::Write { new: Some(_), slot, .. } if !matches!(slot, Slot::Prev(_)))
}

/// The changes by their parts.
fn cut(changes: &[Change]) -> Vec<(Part, Vec<Change>)> {
    let has_removed = changes.iter().any(|change| matches!(change, Change::Removed { .. }));
    let mut parts: Vec<(Part, Vec<Change>)> = Vec::new();
    for change in changes {
        let part = Part::of(change, has_removed);
        match parts.iter_mut().find(|(known, _)| *known == part) {
            Some((_, changes)) => changes.push(*change),
            None => parts.push((part, vec![*change])),
        }
    }
    parts.sort_by_key(|(part, _)| match part {
        Part::Added => 0,
        Part::Removed => 2,
        _ => 1,
    });
    parts
}

/// The index of the last moment that gives a half-edge a face; without such a moment, a next.
pub(super) fn turning(moments: &[Moment]) -> usize {
    let last = |wanted: fn(Slot) -> bool| {
        let writes = |change: &Change| matches!(*change, Change::Write { slot, new: Some(_), .. } if wanted(slot));
        moments.iter().rposition(|moment| moment.changes.iter().any(writes))
    };
    last(|slot| matches!(slot, Slot::Face(_))).or_else(|| last(|slot| matches!(slot, Slot::Next(_)))).unwrap_or(0)
}
