//! What a lab brings along: its cases and what is right in them.
//!
//! ```text
//!   suite = some cases, run one after the other in one process, and the graded tests that they decide
//! ```
//!
//! The engine runs suites and counts faults; only the judge knows what the functions of its lab should do. A new lab is
//! a new implementation of [`Judge`]: in [`courses`](crate::courses), or in a crate of its own (see `dcel lab new`).
//! Where functions give values back and change nothing, [`answers`](crate::answers) is most of the work.

use super::fault::{Exchange, Fault};
use super::plan::Plan;
use super::protocol::{Case, CaseAnswer, Schema, Step};
use super::report::Picture;
use dcel_kit::Element;
use dcel_kit::topology::Table;

/// By what known mistakes are told apart, beside the calls in which they show. More tells more, and leaves more variants of
/// a mistake without a name.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ToldBy {
    /// By the rule and the tag of each fault: enough where these say what stands where something else should.
    Law,
    /// By what is said of each fault, too, whatever the numbering.
    Words,
    /// By the whole answer, too: what was returned, the structure after the call, the picture as it is written.
    Answer,
}

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

impl Asked {
    /// Cases that are always the same.
    pub fn fixed(cases: impl IntoIterator<Item = Case>) -> Vec<Self> {
        Self::all(cases, Source::Fixed)
    }

    /// Cases from the seed of the report.
    pub fn random(cases: impl IntoIterator<Item = Case>) -> Vec<Self> {
        Self::all(cases, Source::Random)
    }

    /// Cases from the instructor's seed.
    pub fn hidden(cases: impl IntoIterator<Item = Case>) -> Vec<Self> {
        Self::all(cases, Source::Hidden)
    }

    /// Cases from the seed of the plan, so many of them, and hidden ones from that of the instructor.
    pub fn from_seeds(plan: &Plan, count: usize, mut cases: impl FnMut(u64, usize) -> Vec<Case>) -> Vec<Self> {
        let mut all = Self::random(cases(plan.seed, count));
        let hidden = plan.secret.as_ref().map(|secret| cases(secret.seed, secret.sequences));
        all.extend(Self::hidden(hidden.into_iter().flatten()));
        all
    }

    /// Cases that are always the same, then some [from seeds](Self::from_seeds).
    pub fn fixed_and_seeded(
        fixed: impl IntoIterator<Item = Case>,
        plan: &Plan,
        count: usize,
        cases: impl FnMut(u64, usize) -> Vec<Case>,
    ) -> Vec<Self> {
        Self::fixed(fixed).into_iter().chain(Self::from_seeds(plan, count, cases)).collect()
    }

    fn all(cases: impl IntoIterator<Item = Case>, source: Source) -> Vec<Self> {
        cases.into_iter().map(|case| Self { case, source }).collect()
    }
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

impl Suite {
    /// A suite with the name of the first of its tests.
    #[must_use]
    pub fn of(tests: &'static [&'static str], asked: Vec<Asked>) -> Self {
        Self { name: tests[0], tests, asked }
    }
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
#[allow(unused_variables)] // what is left to the engine looks at nothing
pub trait Judge: Sync {
    /// What the records of the lab look like.
    fn schema(&self) -> Schema {
        Schema::HalfEdges
    }

    /// All suites, in the order of the tasks.
    fn suites(&self, plan: &Plan) -> Vec<Suite>;

    /// What is wrong with the answer to a case, as far as it goes. That an answer is not complete is seen to by the
    /// engine.
    fn judge(&self, suite: &Suite, case: &Case, answer: &CaseAnswer) -> Vec<Fault>;

    /// The tests that a step is about, of those that its suite decides: a call or a picture that was answered. A call
    /// that should be refused says nothing about the steps of carrying it out. A fault counts in any case.
    fn concerns(&self, suite: &Suite, step: &Step, exchange: Option<&Exchange>) -> Vec<&'static str> {
        suite.tests.to_vec()
    }

    /// The test whose promise a fault breaks, where a suite of many calls found it: it is charged there, and not once
    /// more to what builds on it. `None` if that cannot be told.
    fn blames(&self, fault: &Fault) -> Option<&'static str> {
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
        None
    }

    /// By what the known mistakes of a test are told apart.
    fn told_by(&self, test: &str) -> ToldBy {
        ToldBy::Words
    }

    /// The functions that an instructor's file can give weights in hidden sequences: `split_face = 2`.
    fn weighted(&self) -> &'static [&'static str] {
        &[]
    }

    /// The promise that a fault of a hidden case breaks, without anything of the case.
    fn promise(&self, fault: &Fault) -> &'static str;

    /// The half-edges that a call should have left behind, in the numbers of the student's, for a picture.
    fn expected(&self, exchange: &Exchange) -> Option<Table> {
        None
    }

    /// A picture of a failing call: before, expected, yours. Without one, half-edges are drawn as they are, with those
    /// of [`expected`](Self::expected).
    fn picture(&self, exchange: &Exchange, faults: &[&Fault]) -> Option<Picture> {
        None
    }

    /// What a call that only reads should have returned; nothing for other calls.
    fn answer(&self, exchange: &Exchange) -> Vec<Element> {
        Vec::new()
    }

    /// Shorter cases than a failing one that may fail in the same way, each of which a student can type.
    fn shorter(&self, case: &Case) -> Vec<Case> {
        Vec::new()
    }
}
