//! What a lab brings along: its cases and its judge.
//!
//! ```text
//!   suite = some cases, run one after the other in one process, and the graded tests that they decide
//! ```
//!
//! The engine runs suites and counts faults; only the course knows what the functions of its lab should do. A new
//! lab is a new implementation of [`Course`], registered in [`course`].

use super::fault::{Exchange, Fault};
use super::plan::Plan;
use super::protocol::{Case, CaseAnswer, Step};
use dcel_kit::Element;
use dcel_kit::topology::Table;

/// Where a case comes from, and so who may see it.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Source {
    /// Always the same.
    Fixed,
    /// From the seed of the report.
    Random,
    /// From the instructor's seed: never shown.
    Hidden,
}

/// A case that is asked.
#[derive(Clone, PartialEq, Debug)]
pub struct Asked {
    /// The case.
    pub case: Case,
    /// Where it comes from.
    pub source: Source,
}

/// Cases that are run together.
#[derive(Clone, PartialEq, Debug)]
pub struct Suite {
    /// Its name.
    pub name: &'static str,
    /// The graded tests that it decides.
    pub tests: &'static [&'static str],
    /// Its cases, the simplest first.
    pub asked: Vec<Asked>,
}

/// Something that holds of some calls and not of others, seen before the call is made.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Feature {
    /// A word for files: letters, digits and `_`.
    pub id: &'static str,
    /// The end of a sentence: "It fails where …".
    pub clause: &'static str,
}

/// The cases of a lab and what is right in them.
pub trait Course: Sync {
    /// All suites, in the order of the tasks.
    fn suites(&self, plan: &Plan) -> Vec<Suite>;

    /// What is wrong with the answer to a case, as far as it goes. That an answer is not complete is seen to by the
    /// engine.
    fn judge(&self, suite: &Suite, case: &Case, answer: &CaseAnswer) -> Vec<Fault>;

    /// The tests that a step is about, of those that its suite decides: a call or a picture that was answered. A call
    /// that should be refused says nothing about the steps of carrying it out. A fault counts in any case.
    fn concerns(&self, suite: &Suite, step: &Step, exchange: Option<&Exchange>) -> Vec<&'static str> {
        let _ = (step, exchange);
        suite.tests.to_vec()
    }

    /// The test whose promise a fault breaks, where a suite of many calls found it: it is charged there, and not once
    /// more to what builds on it. `None` if that cannot be told.
    fn blames(&self, fault: &Fault) -> Option<&'static str> {
        let _ = fault;
        None
    }

    /// What can be said of calls, each by its own bit: see [`features`](Self::features). The order is that in which
    /// a reader would rather hear them.
    fn vocabulary(&self) -> &'static [Feature] {
        &[]
    }

    /// What holds of a call: bit i stands for feature i of the [`vocabulary`](Self::vocabulary). `earlier` are the
    /// calls before it on which its structure depends. `None` if too little is known of the call to say for each
    /// feature whether it holds; a feature that has no meaning for the call does not hold.
    fn features(&self, earlier: &[&Exchange], exchange: &Exchange) -> Option<u128> {
        let _ = (earlier, exchange);
        None
    }

    /// The promise that a fault of a hidden case breaks, without anything of the case.
    fn promise(&self, fault: &Fault) -> &'static str;

    /// The structure that a call should have left behind, in the numbers of the student's, for a picture.
    fn expected(&self, exchange: &Exchange) -> Option<Table>;

    /// What a call that only reads should have returned; nothing for other calls.
    fn answer(&self, exchange: &Exchange) -> Vec<Element> {
        let _ = exchange;
        Vec::new()
    }

    /// Shorter cases than a failing one that may fail in the same way, each of which a student can type.
    fn shorter(&self, case: &Case) -> Vec<Case>;
}

/// The course of a lab by its name.
#[must_use]
pub fn course(lab: &str) -> Option<&'static dyn Course> {
    match lab {
        "04-half-edge" => Some(&super::half_edge::HALF_EDGE),
        _ => None,
    }
}
