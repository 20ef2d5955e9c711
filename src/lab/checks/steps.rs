//! An edit in several steps, each graded by its own test: what differs from the right structure becomes faults of steps.

use super::align::{Aligned, Content, Difference, Field, differences};
use crate::fault::{Exchange, Fault, FaultKind, Instead};
use crate::protocol::CallEnd;
use dcel_kit::topology::{Table, violations};
use dcel_kit::{Element, HalfEdgeId};

/// The part that an element plays which plays none.
pub const ELSEWHERE: &str = "elsewhere";
/// How many violations of the laws are added as an explanation.
const LAWS: usize = 4;

/// A call of an edit that is being judged, step by step.
pub struct Steps<'a> {
    /// `split_face`, the beginning of every rule.
    pub function: &'a str,
    /// The call as it was made, in ids.
    pub call: String,
    /// The step of the case.
    pub step: usize,
    /// The step that has a loop, if any.
    pub loops: Option<usize>,
    /// The graded test of each step of the operation.
    pub tests: &'a [&'static str],
    /// How the call ended.
    pub end: &'a CallEnd,
    /// Before the call.
    pub before: &'a Table,
    /// After it.
    pub after: &'a Table,
    /// What was found wrong so far.
    pub faults: Vec<Fault>,
}

impl<'a> Steps<'a> {
    /// The steps of a call of half-edges, without a loop, and these half-edges; nothing if it could not be made, or if
    /// nobody looked at what came of it.
    #[must_use]
    pub fn of<const N: usize>(exchange: &Exchange<'a>, tests: &'a [&'static str]) -> Option<(Self, [HalfEdgeId; N])> {
        let (arguments, end) = exchange.called?;
        let (before, after) = (exchange.before()?, exchange.after()?);
        let half_edges = <[u32; N]>::try_from(arguments).ok()?.map(HalfEdgeId::new);
        let Exchange { function, step, .. } = *exchange;
        let call = half_edges.iter().fold(function.to_owned(), |call, h| format!("{call} {h}"));
        Some((Self { function, call, step, loops: None, tests, end, before, after, faults: Vec::new() }, half_edges))
    }

    /// A fault of a step of the operation.
    pub fn add(&mut self, step: usize, kind: FaultKind, tag: &str, words: &str, elements: &[Element]) {
        let Some(&test) = self.tests.get(step) else { return };
        // That it was stopped is said once for each test.
        let says_the_end =
            kind.is_endless() && !self.faults.iter().any(|fault| fault.test == test && fault.kind == kind);
        let words = if says_the_end && !words.contains(&self.end.words()) {
            format!("{}. Until then: {words}", self.end.words())
        } else {
            words.to_owned()
        };
        let (rule, words) = (format!("{}.{step}", self.function), format!("{}: {words}", self.call));
        let fault = Fault::new(test, kind, self.step, [&rule, tag], words);
        self.faults.push(Fault { elements: elements.to_vec(), ..fault });
    }

    /// The kind of a fault of a step: if the call panicked, whether anything of the step was done decides.
    pub fn kind(&self, step: usize, touched: bool) -> FaultKind {
        match FaultKind::of_end(self.end) {
            None => FaultKind::Wrong,
            Some(FaultKind::Unattempted) if touched => FaultKind::Wrong,
            // What is done wrongly before the loop is wrong, whatever becomes of the loop.
            Some(kind) if touched && kind.is_endless() && self.loops != Some(step) => FaultKind::Wrong,
            Some(kind) => kind,
        }
    }

    /// The number of elements of a kind, which should have grown by `more`. Returns whether it has.
    pub fn count(&mut self, step: usize, what: &str, [before, after]: [usize; 2], more: usize) -> bool {
        if after == before + more {
            return true;
        }
        let kind = self.kind(step, after != before);
        let expected = match more {
            0 => "expected no more than before".to_owned(),
            more => format!("expected {more} more than the {before} before"),
        };
        self.add(
            step,
            kind,
            &format!("{what} {:+}", after as i64 - before as i64),
            &format!("there are {after} {what}, {expected}"),
            &[],
        );
        false
    }

    /// Steps that cannot be judged, because an earlier one is missing.
    pub fn unjudged(&mut self, steps: std::ops::Range<usize>) {
        for step in steps {
            let kind = self.kind(step, false);
            self.add(step, kind, "unjudged", "cannot be judged before the step before it is right", &[]);
        }
    }

    /// One fault for each difference, in the order of the steps, then the laws that are broken.
    pub fn differences(
        &mut self,
        aligned: &Aligned,
        step_of: impl Fn(&Difference) -> usize,
        role: impl Fn(Element) -> &'static str,
    ) {
        let mut in_order: Vec<(usize, &Difference)> = aligned.differences.iter().map(|d| (step_of(d), d)).collect();
        if in_order.is_empty() {
            return self.laws();
        }
        in_order.sort_by_key(|&(step, _)| step);
        // Fields that the call has set or changed; those of new elements count once they are set.
        let mut changed = differences(self.before, self.after);
        changed.retain(|difference| difference.found != Content::Unset);
        for (step, difference) in in_order {
            let kind = self.kind(step, changed.iter().any(|difference| step_of(difference) == step));
            let part = difference.owner.map_or("", &role);
            let tag = format!("{} {part}", difference.field.word());
            let mut elements: Vec<Element> = difference.owner.into_iter().collect();
            elements.extend([difference.found, difference.expected].iter().filter_map(|content| match content {
                Content::To(element @ Element::HalfEdge(_)) => Some(*element),
                _ => None,
            }));
            let part = if part.is_empty() { String::new() } else { format!(" ({part})") };
            let owner = difference.owner.map_or_else(|| "outer_face".to_owned(), |owner| format!("{owner}{part}"));
            let field =
                if difference.owner.is_some() { format!(".{}", difference.field.word()) } else { String::new() };
            // Any half-edge that fits is a right representative.
            let any = if matches!(difference.field, Field::Outgoing | Field::Boundary) {
                ", or another of its own"
            } else {
                ""
            };
            let words = format!("{owner}{field} is {}, expected {}{any}", difference.found, difference.expected);
            self.add(step, kind, &tag, &words, &elements);
            let of = match difference.owner.map(&role) {
                None => "the structure",
                Some(ELSEWHERE) => "an element elsewhere",
                Some("on the loop of the new face") => "a half-edge on the loop of the new face",
                Some("on the loop of the old face") => "a half-edge on the loop of the old face",
                Some(part) => part,
            };
            let subject = format!("{} of {of}", difference.field.word());
            let instead = Instead { subject, is: self.reads_as(difference, &role) };
            if let Some(fault) = self.faults.last_mut() {
                fault.instead = Some(instead);
            }
        }
        self.laws();
    }

    /// What can be said of the wrong value of a field.
    fn reads_as(&self, difference: &Difference, role: impl Fn(Element) -> &'static str) -> Vec<&'static str> {
        let Difference { owner, field, found, .. } = *difference;
        let mut out = Vec::new();
        if found == Content::Unset {
            out.push("unset still");
        } else if found == Content::of(self.before, owner, field) {
            out.push("what it was before the call: nothing sets it, or something sets it back");
        }
        if let Content::To(element) = found {
            let part = role(element);
            if owner == Some(element) {
                out.push("that half-edge itself");
            } else if !part.starts_with("on the ") && part != ELSEWHERE {
                out.push(part);
            }
        }
        out
    }

    /// The laws of the structure that are broken, as an explanation of the first fault.
    fn laws(&mut self) {
        let Some(test) = self.faults.first().map(|fault| fault.test) else { return };
        let kind = self.faults[0].kind.clone();
        if kind != FaultKind::Wrong {
            return;
        }
        let mut said: Vec<&str> = Vec::new();
        for violation in violations(self.after) {
            if said.len() == LAWS || said.contains(&violation.rule.id) {
                continue;
            }
            said.push(violation.rule.id);
            let words = format!("{}: {}", self.call, violation.text());
            let fault = Fault::new(test, kind.clone(), self.step, [violation.rule.id, ""], words);
            self.faults.push(Fault { elements: violation.elements.clone(), ..fault });
        }
    }

    /// A call that panicked although all of its steps are done: the last step is not finished.
    pub fn must_have_returned(&mut self) {
        if let (true, Some(kind)) = (self.faults.is_empty(), FaultKind::of_end(self.end)) {
            let last = self.tests.len() - 1;
            self.add(last, kind, "panic", &format!("all is done, but the call {}", self.end.words()), &[]);
        }
    }
}
