//! Which calls decide a test: those in which all that it needs held.
//!
//! ```text
//!                     call 1   call 2   call 3   call 4        step 1 is wrong in call 2 only. What steps 2 and 3
//!   step 1            ✓        ✗        ✓        ✓             have made of that call says nothing about them, so
//!   step 2 needs 1    ✓        –        ✓        ✓             they are judged by the other calls and may pass.
//!   step 3 needs 2    ✓        –        ✗        ✓
//! ```
//!
//! - A call decides a test if it concerns the test (see [`Judge::concerns`]), nothing that the test needs has failed
//!   in this call, and nothing has failed before it in the same *part* of its case. A part begins where the structure
//!   is known to be right: at the start, after `restore`, and at each call that only reads.
//! - A fault in a sequence is charged to the test whose promise it breaks ([`Judge::blames`]), if the sequence needs
//!   that test and it fails by itself, too. The calls before it still count. What is still `todo!()` is never to blame:
//!   a call that came back has not been there.
//! - If calls are charged to others, the right ones must be more, and not all have the same answer: a function that does
//!   nothing, or always says no, is right wherever there is nothing to do.
//! - A test passes if no call that decides it fails, every case was asked, and at least a quarter of the calls that
//!   concern it decide it (three calls, or all if there are fewer), of each function that is called. With less evidence
//!   it is skipped. So a slip in one step costs that step, but code that is reached in a few odd calls earns nothing.
//!   Only the fixed cases count for that, if a test has any: points must not hang on a seed.
//! - A program that ends in the middle of a call has not said how far it came: that call speaks against all steps.

use super::conditions::Calls;
use super::fault::{Exchange, Fault, FaultKind, exchanges};
use super::judge::{Judge, Source, Suite};
use super::manifest::{Manifest, Test};
use super::protocol::{CallEnd, Case, CaseAnswer, Step};
use super::run::{NO_ANSWER, SuiteRun};
use super::verdict::Verdict;
use std::collections::{BTreeMap, BTreeSet};

/// One call in this many must decide a test.
const SHARE: usize = 4;
/// And so many calls, if so many concern it.
const LEAST: usize = 3;

/// A call that was answered, or a picture.
#[derive(Debug)]
pub(super) struct Unit<'a> {
    /// The number of its case in the suite.
    pub(super) case: usize,
    /// Its step in the case.
    pub(super) step: usize,
    /// Its case is the same for everybody.
    fixed: bool,
    /// The part of the case that it stands in.
    part: usize,
    /// The unit before it in the same part.
    before: Option<usize>,
    /// The call; `None` for a picture, and for a step that was not answered.
    pub(super) exchange: Option<Exchange<'a>>,
    /// The tests that it concerns.
    tests: Vec<&'static str>,
}

/// All calls of a suite that was run.
pub(super) struct Units<'a> {
    pub(super) all: Vec<Unit<'a>>,
    faults: &'a [Vec<Fault>],
}

impl<'a> Units<'a> {
    /// Cost: linear in the calls, and what [`Judge::concerns`] takes for each.
    pub(super) fn new(judge: &dyn Judge, suite: &'a Suite, run: &'a SuiteRun) -> Self {
        let mut all = Vec::new();
        for (number, ((asked, answer), faults)) in suite.asked.iter().zip(&run.answers).zip(&run.faults).enumerate() {
            let first = all.len();
            all.extend(units(judge, suite, number, &asked.case, answer, faults));
            all[first..].iter_mut().for_each(|unit: &mut Unit| unit.fixed = asked.source == Source::Fixed);
        }
        let mut last: BTreeMap<(usize, usize), usize> = BTreeMap::new();
        for (i, unit) in all.iter_mut().enumerate() {
            unit.before = last.insert((unit.case, unit.part), i);
        }
        Self { all, faults: &run.faults }
    }

    /// The faults of a test at a call.
    pub(super) fn faults_of<'b>(&'b self, unit: &Unit, test: &'b str) -> impl Iterator<Item = &'a Fault> + use<'a, 'b> {
        at(&self.faults[unit.case], unit.step).iter().filter(move |fault| fault.test == test)
    }

    /// What can be said of a call before it is made; `None` if that is not known.
    pub(super) fn features(&self, judge: &dyn Judge, unit: usize) -> Option<u128> {
        let Unit { before, exchange, .. } = &self.all[unit];
        let before = std::iter::successors(*before, |&before| self.all[before].before);
        let mut earlier: Vec<&Exchange> = before.filter_map(|before| self.all[before].exchange.as_ref()).collect();
        earlier.reverse();
        judge.features(&earlier, exchange.as_ref()?)
    }

    /// What calls of this suite say of a test that another suite decides: those which do what that suite asks for.
    pub(super) fn lent(
        &self,
        judge: &dyn Judge,
        suite: &Suite,
        test: &str,
        needs: &Needs,
        of: &dyn Fn(&Unit) -> bool,
        calls: &mut Calls,
    ) {
        let mut stopped: BTreeSet<(usize, usize)> = BTreeSet::new();
        for (i, unit) in self.all.iter().enumerate() {
            let place = (unit.case, unit.part);
            let already = stopped.contains(&place);
            let faults = at(&self.faults[unit.case], unit.step);
            if !faults.is_empty() {
                stopped.insert(place);
            }
            let Some(exchange) = unit.exchange.filter(|_| !already && of(unit)) else { continue };
            // A fault that no test is to blame for says nothing; one in an earlier step hides this one.
            let blamed: Option<Vec<&str>> = faults.iter().map(|fault| judge.blames(fault)).collect();
            let Some(blamed) = blamed.filter(|blamed| !blamed.iter().any(|name| needs.has_here(name))) else {
                continue;
            };
            let step = Step::Call { function: exchange.function.to_owned(), arguments: exchange.words.to_vec() };
            if !judge.concerns(suite, &step, Some(&exchange)).contains(&test) {
                continue;
            }
            let to = if blamed.contains(&test) { &mut calls.failing } else { &mut calls.passing };
            to.extend(self.features(judge, i));
        }
    }

    /// What the calls say of a test.
    pub(super) fn ruling(&self, judge: &dyn Judge, test: &str, needs: &Needs) -> Ruling {
        let mut ruling = Ruling::default();
        let mut stopped: BTreeSet<(usize, usize)> = BTreeSet::new();
        let any_fixed = self.all.iter().any(|unit| unit.fixed && unit.tests.contains(&test));
        for (i, unit) in self.all.iter().enumerate() {
            let faults = at(&self.faults[unit.case], unit.step);
            let counts = unit.fixed || !any_fixed;
            let own = faults.iter().find(|fault| fault.test == test);
            let need = faults.iter().find(|fault| needs.here.contains(fault.test));
            let place = (unit.case, unit.part);
            let already = stopped.contains(&place);
            if own.is_some() || need.is_some() {
                stopped.insert(place);
            }
            // What is wrong counts wherever it shows.
            if own.is_none() && !unit.tests.contains(&test) {
                continue;
            }
            ruling.asked += 1;
            let function = unit.exchange.map_or("", |exchange| exchange.function);
            let of_function = ruling.functions.entry(function.to_owned()).or_default();
            of_function.asked += usize::from(counts);
            if already {
                continue;
            }
            match (need, own) {
                (Some(need), own) => {
                    ruling.because.insert(need.test.to_owned());
                    // Nobody knows in which step a program ended that has not answered.
                    ruling.died |= own.is_some_and(|own| own.rule == NO_ANSWER);
                    continue;
                }
                (None, None) => ruling.passing.push(i),
                (None, Some(own)) => match needs.to_blame(judge.blames(own), own) {
                    Some(other) => {
                        ruling.because.insert(other);
                        ruling.charged += usize::from(counts);
                        ruling.died |= own.rule == NO_ANSWER;
                        continue;
                    }
                    None => ruling.failing.push(i),
                },
            }
            of_function.judged += usize::from(counts);
        }
        ruling.says_one_thing = self.all_say_the_same(&ruling.passing);
        ruling
    }

    /// Whether these calls only returned a value, and all of them the same.
    fn all_say_the_same(&self, calls: &[usize]) -> bool {
        let mut values = calls.iter().map(|&i| match self.all[i].exchange {
            Some(Exchange { called: Some((_, CallEnd::Returned(values))), structure_after: None, .. }) => &values[..],
            _ => &[],
        });
        values.next().is_some_and(|first| !first.is_empty() && values.all(|value| value == first))
    }
}

/// The faults at a step. They are in the order of the steps.
fn at(faults: &[Fault], step: usize) -> &[Fault] {
    let begin = faults.partition_point(|fault| fault.step < step);
    let len = faults[begin..].partition_point(|fault| fault.step == step);
    &faults[begin..begin + len]
}

/// The calls and pictures of a case, in order.
fn units<'a>(
    judge: &dyn Judge,
    suite: &Suite,
    number: usize,
    case: &'a Case,
    answer: &'a CaseAnswer,
    faults: &[Fault],
) -> Vec<Unit<'a>> {
    let parts = parts(case);
    let mut calls = exchanges(case, answer).into_iter().peekable();
    let mut replies = answer.replies.len();
    let mut out = Vec::new();
    for (step, asked) in case.steps.iter().enumerate() {
        let is_answered = asked.is_answered() && replies > 0;
        replies -= usize::from(is_answered);
        let exchange = calls.next_if(|exchange| exchange.step == step);
        let tests = match asked {
            Step::Call { .. } | Step::Svg if is_answered => judge.concerns(suite, asked, exchange.as_ref()),
            // Where the program stopped: all that is said of it concerns the tests that it is said of.
            _ => at(faults, step).iter().map(|fault| fault.test).collect(),
        };
        if !tests.is_empty() || exchange.is_some() {
            out.push(Unit { case: number, step, fixed: true, part: parts[step], before: None, exchange, tests });
        }
    }
    out
}

/// The part that each step of a case stands in.
fn parts(case: &Case) -> Vec<usize> {
    let (mut last, mut now) = (0, 0);
    let mut parts = Vec::with_capacity(case.steps.len());
    for (i, step) in case.steps.iter().enumerate() {
        if *step == Step::Restore {
            last += 1;
            now = last;
        }
        let after = case.steps[i + 1..].iter().find(|step| **step != Step::Reads);
        let only_reads = matches!(step, Step::Call { .. }) && !after.is_some_and(Step::shows);
        if only_reads {
            last += 1;
        }
        parts.push(if only_reads { last } else { now });
    }
    parts
}

/// What a test needs, at once or through others.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub(super) struct Needs {
    /// The tests that the same suite decides.
    here: BTreeSet<String>,
    /// The tests of other suites that are not passed, and whether they are still to be written.
    open: BTreeMap<String, bool>,
}

impl Needs {
    /// `suite` are the tests of the suite of `test`; `verdict` says what is known of earlier tests.
    pub(super) fn of(
        manifest: &Manifest,
        test: &Test,
        suite: &[&str],
        verdict: impl Fn(&str) -> Option<Verdict>,
    ) -> Self {
        let all = manifest.with_needs(test.needs.iter().map(String::as_str).collect());
        let (here, elsewhere): (BTreeSet<&str>, BTreeSet<&str>) =
            all.into_iter().partition(|name| suite.contains(name));
        let here = here.into_iter().map(str::to_owned).collect();
        let open = elsewhere.into_iter().map(|name| (name, verdict(name)));
        let open = open.filter(|(_, verdict)| !verdict.is_some_and(Verdict::is_passed));
        let open = open.map(|(name, verdict)| (name.to_owned(), verdict == Some(Verdict::Unattempted)));
        Self { here, open: open.collect() }
    }

    /// The open test that a fault is charged to: the one whose promise it breaks; any, if that is not known.
    fn to_blame(&self, blamed: Option<&str>, fault: &Fault) -> Option<String> {
        let is_written = |name: &str| !self.open[name] || fault.kind == FaultKind::Unattempted;
        match blamed {
            Some(name) => self.open.contains_key(name).then(|| name.to_owned()).filter(|name| is_written(name)),
            None => self.open.keys().find(|name| is_written(name)).cloned(),
        }
    }

    /// Whether anything is needed that may have failed.
    pub(super) fn any(&self) -> bool {
        !self.here.is_empty() || !self.open.is_empty()
    }

    /// Whether a test of the same suite is needed.
    pub(super) fn has_here(&self, test: &str) -> bool {
        self.here.contains(test)
    }
}

/// What the calls of a suite say of a test.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub(super) struct Ruling {
    /// How many calls concern it.
    pub(super) asked: usize,
    /// The calls that decide it and are right, by their numbers in [`Units::all`].
    pub(super) passing: Vec<usize>,
    /// The calls that decide it and are wrong.
    pub(super) failing: Vec<usize>,
    /// How many calls that count are wrong, and charged to tests of other suites.
    charged: usize,
    /// All right calls returned one and the same value.
    says_one_thing: bool,
    /// The tests that failed where it was not judged.
    pub(super) because: BTreeSet<String>,
    /// The calls of each function that count as evidence.
    functions: BTreeMap<String, Count>,
    /// The program ended in a call, and nobody knows in which step.
    died: bool,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
struct Count {
    asked: usize,
    judged: usize,
}

impl Ruling {
    /// How many calls decide it.
    pub(super) fn judged(&self) -> usize {
        self.passing.len() + self.failing.len()
    }

    /// Whether enough calls decide it for a pass: of each function that is called.
    pub(super) fn is_enough(&self) -> bool {
        let right: usize = self.functions.values().map(|count| count.judged).sum();
        let enough = |count: &Count| count.judged * SHARE >= count.asked && count.judged >= LEAST.min(count.asked);
        let enough_right = self.charged == 0 || (right > self.charged && !self.says_one_thing);
        !self.died && self.asked > 0 && enough_right && self.functions.values().all(enough)
    }
}
