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
use super::protocol::{Case, CaseAnswer};
use crate::topology::Table;

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

/// The cases of a lab and what is right in them.
pub trait Course: Sync {
    /// All suites, in the order of the tasks.
    fn suites(&self, plan: &Plan) -> Vec<Suite>;

    /// What is wrong with the answer to a case, as far as it goes. That an answer is not complete is seen to by the
    /// engine.
    fn judge(&self, suite: &Suite, case: &Case, answer: &CaseAnswer) -> Vec<Fault>;

    /// The structure that a call should have left behind, in the numbers of the student's, for a picture.
    fn expected(&self, exchange: &Exchange) -> Option<Table>;

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
