//! Grading a program: all suites, a verdict for each test, the report.
//!
//! ```text
//!   the first call that decides a test and fails gives its verdict     crashed, timed out, out of memory, wrong ...
//!   too few calls decide it, because what it needs fails in them       skipped      (see judged.rs)
//!   nothing of its task is there but todo!()                           unattempted
//!   enough calls decide it, and none of them fails                     passed
//! ```

use super::conditions::{Calls, necessary, necessary_sentence, sentence, shortest};
use super::fault::{Fault, FaultKind, Instead};
use super::feedback;
use super::findings::findings;
use super::judge::{Judge, Source, Suite, ToldBy};
use super::judged::{Needs, Ruling, Unit, Units};
use super::lanes::in_lanes;
use super::manifest::Test;
use super::mutants::{self, Evidence};
use super::plan::Plan;
use super::program::Program;
use super::report::{Report, TestResult};
use super::run::{Graded, PATIENCE, SuiteRun, function, run_suite};
use super::signatures::Signature;
use super::the_lab::Lab;
use super::told;
use super::verdict::Verdict;
use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet};
use std::time::Instant;

/// What is said of a test that was not asked any more.
const GIVEN_UP: &str = "It was not run: the program had to be ended three times before, because of time or memory. \
                        Mend the tests above first.";
/// How much of the student's printing is in the report.
const PRINTED: usize = 4 * 1024;

/// What is known of a test before it becomes a result.
struct State<'a> {
    test: &'a Test,
    verdict: Verdict,
    /// The number of its suite.
    suite: Option<usize>,
    ruling: Ruling,
    needs: Needs,
    hash: Option<String>,
}

/// All that came of a run.
struct Run<'a> {
    lab: &'a Lab,
    judge: &'static dyn Judge,
    graded: &'a [Graded<'a>],
    units: Vec<Units<'a>>,
    states: Vec<State<'a>>,
}

/// Runs all cases of a lab with a program, and says what came of it.
///
/// Never panics, whatever the program prints. The same program, seed and lab give the same report, times aside.
/// Cost: a few processes and some thousand small structures; below half a second for a right solution.
#[must_use]
pub fn grade_program(lab: &Lab, program: &dyn Program, plan: &Plan) -> Report {
    grade_and_sign(lab, program, plan).0
}

/// [`grade_program`], and how the program fails in the fixed cases: what the lab keeps of each known mistake. The
/// signature is empty for a right program, and for one that cannot be run, and does not depend on the seed.
#[must_use]
pub fn grade_and_sign(lab: &Lab, program: &dyn Program, plan: &Plan) -> (Report, Signature) {
    let (report, signature, _) = grade(lab, program, plan, &suites(lab, plan), false);
    (report, signature)
}

/// The suites of a plan. For a lab of large structures they take longer to make than to judge: whoever asks several
/// programs makes them once.
pub(super) fn suites(lab: &Lab, plan: &Plan) -> Vec<Suite> {
    lab.judge().map_or_else(Vec::new, |judge| wanted(judge.suites(plan), lab, plan))
}

/// [`grade_and_sign`] by the suites of the plan; with `all`, also in which calls of all cases each test fails and in
/// which it does not, but without what a student is shown: the search for the shortest failing case takes longer than
/// all else.
pub(super) fn grade(
    lab: &Lab,
    program: &dyn Program,
    plan: &Plan,
    suites: &[Suite],
    all: bool,
) -> (Report, Signature, Evidence) {
    let begin = Instant::now();
    let mut report =
        Report { lab: lab.name.clone(), seed: plan.seed, sandbox: program.sandbox(), ..Report::of(&lab.manifest) };
    let Some(judge) = lab.judge() else {
        report.message = Some(format!("this version of the kit has no cases for {}", lab.name));
        return (report, Signature::new(), Evidence::new());
    };
    let graded = run_all(lab, judge, program, &suites.iter().collect::<Vec<_>>());
    for part in &graded {
        report.printed.push_str(&part.run.printed);
    }
    if report.printed.len() > PRINTED {
        let cut = (0..=PRINTED).rev().find(|&cut| report.printed.is_char_boundary(cut)).unwrap_or(0);
        report.printed.truncate(cut);
        report.printed.push_str(" … and more\n");
    }
    let run = Run::new(lab, judge, &graded, plan.only.is_some());
    let signature = run.signature();
    let skipped: BTreeSet<&str> = run
        .states
        .iter()
        .filter(|state| matches!(state.verdict, Verdict::Skipped | Verdict::Unattempted))
        .map(|state| state.test.name.as_str())
        .collect();
    let fails = run.states.iter().any(|state| state.verdict.is_failure());
    let evidence = if fails { run.evidence(&|source| source != Source::Fixed) } else { Evidence::new() };
    let context = feedback::Context { lab, program, judge };
    for state in &run.states {
        let mut result = TestResult::new(state.test, state.verdict);
        run.describe(&mut result, state);
        if state.verdict.is_failure() {
            let found = mutants::Found { signature: &signature, skipped: &skipped, evidence: &evidence };
            result.bugs = mutants::names(lab, judge.vocabulary(), state.test.task, &found);
            if !all && let (Some(suite), Some(unit)) = (state.suite, run.first_failing(state)) {
                context.illustrate(&mut result, &graded[suite], unit.case, unit.step, &state.needs);
            }
        }
        report.tests.push(result);
    }
    report.verdict = summary(report.tests.iter().map(|test| test.verdict));
    report.millis = begin.elapsed().as_millis() as u64;
    let evidence = if all && fails { run.evidence(&|_| true) } else { Evidence::new() };
    (report, signature, evidence)
}

/// The verdict on all tests together: the worst. A test that was skipped waits for another one, which has more to say.
fn summary(verdicts: impl Iterator<Item = Verdict> + Clone) -> Verdict {
    let telling = verdicts.clone().filter(|verdict| !matches!(verdict, Verdict::Skipped | Verdict::Passed)).max();
    telling.or_else(|| verdicts.max()).unwrap_or(Verdict::GraderFault)
}

/// The random cases of a plan, suite by suite.
#[cfg(feature = "grade")]
pub(super) struct RandomCases {
    suites: Vec<Suite>,
    /// The functions that each suite calls, in its other cases too.
    called: Vec<BTreeSet<String>>,
}

#[cfg(feature = "grade")]
impl RandomCases {
    pub(super) fn of(lab: &Lab, plan: &Plan) -> Self {
        let mut suites = suites(lab, plan);
        let called = |suite: &Suite| -> BTreeSet<String> {
            let steps = suite.asked.iter().flat_map(|asked| &asked.case.steps);
            steps.filter_map(|step| function(step).map(str::to_owned)).collect()
        };
        let called = suites.iter().map(called).collect();
        suites.iter_mut().for_each(|suite| suite.asked.retain(|asked| asked.source == Source::Random));
        Self { suites, called }
    }

    /// In which calls these tests fail and in which they do not. Only suites are run that decide one of them, or what
    /// they need, or that call the same functions.
    pub(super) fn evidence(&self, lab: &Lab, program: &dyn Program, tests: &BTreeSet<&str>) -> Evidence {
        let Some(judge) = lab.judge() else { return Evidence::new() };
        let decides = |suite: &Suite, tests: &BTreeSet<&str>| suite.tests.iter().any(|test| tests.contains(test));
        let with_called = || self.suites.iter().zip(&self.called);
        let functions: BTreeSet<&String> =
            with_called().filter(|(suite, _)| decides(suite, tests)).flat_map(|(_, called)| called).collect();
        let needed = lab.manifest.with_needs(tests.clone());
        let is_wanted = |suite: &Suite, called: &BTreeSet<String>| {
            decides(suite, &needed) || called.iter().any(|name| functions.contains(name))
        };
        let suites = with_called().filter(|(suite, called)| is_wanted(suite, called)).map(|(suite, _)| suite);
        let graded = run_all(lab, judge, program, &suites.collect::<Vec<_>>());
        Run::new(lab, judge, &graded, true).evidence(&|_| true)
    }
}

/// Runs the suites, several at a time where the program allows that.
///
/// What comes of them is the same as one after the other: a suite that would not have been asked, or not so far, is
/// not taken as it was run ahead.
fn run_all<'a>(lab: &Lab, judge: &dyn Judge, program: &dyn Program, suites: &[&'a Suite]) -> Vec<Graded<'a>> {
    let mut graded: Vec<Graded> = Vec::new();
    let mut exhausted = 0;
    let mut hanging: BTreeSet<String> = BTreeSet::new();
    let mut ahead = run_ahead(judge, program, suites);
    for (&suite, ahead) in suites.iter().zip(&mut ahead) {
        let blocked = is_blocked(lab, suite, &graded);
        let mut steps = suite.asked.iter().flat_map(|asked| &asked.case.steps);
        let hangs = steps.find_map(|step| function(step).filter(|&function| hanging.contains(function)));
        let run = match hangs {
            _ if blocked => SuiteRun::default(),
            Some(function) => SuiteRun::given_up(format!("It was not run: {function} did not come back before.")),
            None if exhausted >= PATIENCE => SuiteRun::given_up(GIVEN_UP.to_owned()),
            None => ahead.take().unwrap_or_else(|| run_suite(program, judge, suite)),
        };
        exhausted += usize::from(run.exhausted > 0);
        hanging.extend(run.exhausted_in(suite).map(str::to_owned));
        graded.push(Graded { suite, run, blocked });
    }
    graded
}

/// Suites run at the same time, until one comes to an end by time or memory; `None` for those that were not begun.
fn run_ahead(judge: &dyn Judge, program: &dyn Program, suites: &[&Suite]) -> Vec<Option<SuiteRun>> {
    let length = |&number: &usize| suites[number].asked.iter().map(|asked| asked.case.steps.len()).sum::<usize>();
    // The longest first: what comes last decides when all is done.
    let mut order: Vec<usize> = (0..suites.len()).collect();
    order.sort_by_key(|number| Reverse(length(number)));
    // With one lane there is nothing to gain: then each suite is run where it is due.
    let lanes = Some(program.at_once()).filter(|&lanes| lanes > 1 && suites.len() > 1).unwrap_or_default();
    let made = in_lanes(lanes, order.len(), |_, place| {
        let run = run_suite(program, judge, suites[order[place]]);
        let goes_on = run.exhausted == 0;
        (run, goes_on)
    });
    let mut runs: Vec<(usize, Option<SuiteRun>)> = order.into_iter().zip(made).collect();
    runs.sort_by_key(|(number, _)| *number);
    runs.into_iter().map(|(_, run)| run).collect()
}

/// Whether every test of a suite needs, at once or through others, a suite that was broken off: what did not come
/// back there would cost the whole deadline here once more.
fn is_blocked(lab: &Lab, suite: &Suite, graded: &[Graded]) -> bool {
    let broken_off = |name: &str| {
        let of = graded.iter().find(|part| part.suite.tests.contains(&name));
        of.is_some_and(|part| part.run.grader_fault.is_none() && !part.is_whole())
    };
    let needs = |test: &&str| lab.manifest.test(test).map_or(&[][..], |test| &test.needs);
    suite.tests.iter().all(|test| needs(test).iter().any(|need| broken_off(need)))
}

impl<'a> Run<'a> {
    fn new(lab: &'a Lab, judge: &'static dyn Judge, graded: &'a [Graded<'a>], in_part: bool) -> Self {
        let units = graded.iter().map(|part| Units::new(judge, part.suite, &part.run)).collect();
        let mut run = Self { lab, judge, graded, units, states: Vec::new() };
        for test in &lab.manifest.tests {
            if let Some(state) = run.state(test, in_part) {
                run.states.push(state);
            }
        }
        run.keep_unattempted();
        run
    }

    /// What is known of a test, once all earlier ones are; `None` if its suite was not asked for.
    fn state(&self, test: &'a Test, in_part: bool) -> Option<State<'a>> {
        let number = self.graded.iter().position(|part| part.suite.tests.contains(&test.name.as_str()));
        let mut state = State {
            test,
            verdict: Verdict::GraderFault,
            suite: number,
            ruling: Ruling::default(),
            needs: Needs::default(),
            hash: None,
        };
        // A test without cases can never be passed.
        let Some(number) = number else { return (!in_part).then_some(state) };
        let part = &self.graded[number];
        // What is skipped because there is only a `todo!()` is not written either, whatever it builds on.
        let verdict = |name: &str| {
            let state = self.states.iter().find(|state| state.test.name == name)?;
            let is_open = state.verdict == Verdict::Skipped && self.says_nothing(state);
            Some(if is_open { Verdict::Unattempted } else { state.verdict })
        };
        state.needs = Needs::of(&self.lab.manifest, test, part.suite.tests, verdict);
        if part.run.grader_fault.is_some() || part.suite.asked.is_empty() {
            return Some(state);
        }
        if part.run.given_up.is_some() {
            state.verdict = Verdict::Skipped;
            return Some(state);
        }
        state.ruling = self.units[number].ruling(self.judge, &test.name, &state.needs);
        state.verdict = match state.ruling.failing.first() {
            Some(&first) => {
                let unit = &self.units[number].all[first];
                let fault = self.units[number].faults_of(unit, &test.name).next();
                fault.map_or(Verdict::GraderFault, |fault| fault.kind.verdict())
            }
            None if part.is_whole() && state.ruling.is_enough() => Verdict::Passed,
            None if state.ruling.asked == 0 && !part.blocked && !state.needs.any() => Verdict::GraderFault,
            None => Verdict::Skipped,
        };
        state.hash = self.hash_of(&state, number);
        Some(state)
    }

    /// Whether the first that is known of a test is a `todo!()`.
    fn says_nothing(&self, state: &State) -> bool {
        let first = state.suite.and_then(|number| {
            let faults = &self.graded[number].run.faults;
            faults.iter().flatten().find(|fault| fault.test == state.test.name)
        });
        first.is_some_and(|fault| fault.kind == FaultKind::Unattempted)
    }

    /// Tests of a task of which nothing is written yet are unattempted, whatever they build on.
    fn keep_unattempted(&mut self) {
        let mut of_task: BTreeMap<u32, bool> = BTreeMap::new();
        for state in &self.states {
            *of_task.entry(state.test.task).or_insert(true) &= self.says_nothing(state);
        }
        for state in &mut self.states {
            if state.verdict == Verdict::Skipped && of_task[&state.test.task] {
                state.verdict = Verdict::Unattempted;
            }
        }
    }

    fn first_failing(&self, state: &State) -> Option<&Unit<'a>> {
        self.units[state.suite?].all.get(*state.ruling.failing.first()?)
    }

    fn signature(&self) -> Signature {
        self.states.iter().filter_map(|state| Some((state.test.name.clone(), state.hash.clone()?))).collect()
    }

    /// The hash of what fails in the fixed cases; `None` if nothing does.
    fn hash_of(&self, state: &State, number: usize) -> Option<String> {
        let (units, asked) = (&self.units[number], &self.graded[number].suite.asked);
        let told_by = self.judge.told_by(&state.test.name);
        let line = |case: &str, fault: &Fault, answer: &str| {
            let kind = match &fault.kind {
                FaultKind::Crashed { .. } => "crashed".to_owned(),
                FaultKind::DoesNotComeBack { .. } => "DoesNotComeBack".to_owned(),
                FaultKind::TooSlow { .. } => "TooSlow".to_owned(),
                kind => format!("{kind:?}"),
            };
            let has_words = told_by != ToldBy::Law && fault.kind == FaultKind::Wrong;
            let said = if has_words { told::as_told(&fault.words) } else { String::new() };
            format!("{case} {} {} {} {kind} {said}{answer}", fault.step, fault.rule, fault.tag)
        };
        if matches!(state.verdict, Verdict::Unattempted | Verdict::GraderFault) {
            return None;
        }
        let failing = state.ruling.failing.iter().map(|&i| &units.all[i]);
        let fixed = failing.filter(|unit| asked[unit.case].source == Source::Fixed);
        let lines: BTreeSet<String> = fixed
            .flat_map(|unit| {
                let case = &asked[unit.case].case;
                let answers = &self.graded[number].run.answers[unit.case];
                let by_answer = told_by == ToldBy::Answer;
                let answer = by_answer.then(|| told::answer(unit.exchange.as_ref(), unit.step, case, answers));
                let answer = answer.unwrap_or_default();
                units.faults_of(unit, &state.test.name).map(move |fault| line(&case.name, fault, &answer))
            })
            .collect();
        (!lines.is_empty()).then(|| mutants::hash(&lines))
    }

    /// In which calls each test fails and in which it does not, as far as their features are known: the calls that
    /// decide it, and those of sequences which do the same.
    fn evidence(&self, wanted: &dyn Fn(Source) -> bool) -> Evidence {
        let mut evidence = Evidence::new();
        for state in &self.states {
            let Some(own) = state.suite else { continue };
            let calls = evidence.entry(state.test.name.clone()).or_default();
            let functions: BTreeSet<&str> =
                self.units[own].all.iter().filter_map(|unit| Some(unit.exchange?.function)).collect();
            for (number, units) in self.units.iter().enumerate() {
                let asked = &self.graded[number].suite.asked;
                if number == own {
                    let add = |unit: usize, to: &mut Vec<u128>| {
                        if wanted(asked[units.all[unit].case].source) {
                            to.extend(units.features(self.judge, unit));
                        }
                    };
                    state.ruling.failing.iter().for_each(|&unit| add(unit, &mut calls.failing));
                    state.ruling.passing.iter().for_each(|&unit| add(unit, &mut calls.passing));
                } else {
                    let suite = self.graded[own].suite;
                    let of = |unit: &Unit| {
                        wanted(asked[unit.case].source)
                            && unit.exchange.is_some_and(|exchange| functions.contains(exchange.function))
                    };
                    units.lent(self.judge, suite, &state.test.name, &state.needs, &of, calls);
                }
            }
        }
        evidence
    }
}

/// The suites that decide the test that is wanted, and those that it needs; all if none is wanted.
fn wanted(suites: Vec<Suite>, lab: &Lab, plan: &Plan) -> Vec<Suite> {
    let Some(only) = &plan.only else { return suites };
    let names = lab.manifest.with_needs([only.as_str()].into());
    suites.into_iter().filter(|suite| suite.tests.iter().any(|test| names.contains(test))).collect()
}

impl Run<'_> {
    /// The message, the place, the findings and what the failing calls have in common.
    fn describe(&self, result: &mut TestResult, state: &State) {
        let ruling = &state.ruling;
        match state.verdict {
            Verdict::Passed => {
                if ruling.judged() < ruling.asked {
                    let (judged, asked) = (ruling.judged(), ruling.asked);
                    let because = ruling.because.iter().map(String::as_str).collect::<Vec<_>>().join(" or ");
                    result.message = format!("Judged by {judged} of {asked} calls: in the others, {because} fails.");
                }
                return;
            }
            Verdict::Skipped => {
                result.message = self.why_skipped(state);
                return;
            }
            Verdict::GraderFault => {
                let why = state.suite.and_then(|number| self.graded[number].run.grader_fault.clone());
                result.message = why.unwrap_or_else(|| "the cases of this test could not be asked".to_owned());
                return;
            }
            _ => {}
        }
        if state.verdict == Verdict::Unattempted {
            result.message = "It is still to be written.".to_owned();
        }
        let (Some(number), Some(unit)) = (state.suite, self.first_failing(state)) else { return };
        let name = state.test.name.as_str();
        let faults: Vec<&Fault> = self.units[number].faults_of(unit, name).collect();
        if let Some(place) = faults.first().and_then(|fault| fault.kind.place()) {
            result.place = Some(place.to_owned());
        }
        if state.verdict == Verdict::Unattempted {
            return;
        }
        let section = self.lab.manifest.task(state.test.task).map_or("", |task| task.section.as_str());
        let hidden = self.graded[number].suite.asked[unit.case].source == Source::Hidden;
        let what = faults.first().map_or_else(String::new, |fault| fault.what_happened(unit.exchange.as_ref()));
        result.message = if hidden {
            "A hidden case fails; the cases that you can see do not.".to_owned()
        } else {
            format!("{what} ({})", count(ruling))
        };
        result.findings = findings(self.judge, &faults, section, hidden);
        if !hidden {
            let told = [self.pattern(state, number), self.instead(state, number)];
            let told: Vec<String> = told.into_iter().flatten().collect();
            result.pattern = (!told.is_empty()).then(|| told.join(" "));
        }
    }

    /// Why a test was not judged, or not by enough calls.
    fn why_skipped(&self, state: &State) -> String {
        let told = |name: &str| {
            let verdict = self.states.iter().find(|other| other.test.name == name).map(|other| other.verdict);
            verdict.map_or_else(|| name.to_owned(), |verdict| format!("{name} ({verdict})"))
        };
        let ruling = &state.ruling;
        if let Some(why) = state.suite.and_then(|number| self.graded[number].run.given_up.clone()) {
            return why;
        }
        let because: Vec<String> = ruling.because.iter().map(|name| told(name)).collect();
        match (ruling.judged(), &because[..]) {
            (0, [_, ..]) => format!("It builds on {}.", because.join(" and ")),
            (judged, [_, ..]) => {
                let (asked, because) = (ruling.asked, because.join(" or "));
                format!(
                    "Only {judged} of {asked} calls can be judged, and they are right: in the others, {because} fails."
                )
            }
            (_, []) => {
                let open = state.test.needs.iter().filter(|need| {
                    self.states.iter().any(|other| other.test.name == **need && !other.verdict.is_passed())
                });
                let open: Vec<String> = open.map(|name| told(name)).collect();
                match &open[..] {
                    [] => "Not all of its cases could be asked.".to_owned(),
                    open => format!("It builds on {}.", open.join(" and ")),
                }
            }
        }
    }

    /// What the wrong value is in every call that fails as the first one does, of those that the student may see.
    fn instead(&self, state: &State, number: usize) -> Option<String> {
        let (units, asked) = (&self.units[number], &self.graded[number].suite.asked);
        let failing = state.ruling.failing.iter().map(|&unit| &units.all[unit]);
        let visible = failing.filter(|unit| asked[unit.case].source != Source::Hidden);
        let faults = |unit: &Unit| units.faults_of(unit, &state.test.name).collect::<Vec<_>>();
        instead(visible.map(faults))
    }

    /// What the failing calls have in common, of those that the student may see.
    fn pattern(&self, state: &State, number: usize) -> Option<String> {
        let (units, asked) = (&self.units[number], &self.graded[number].suite.asked);
        let is_hidden = |unit: &usize| asked[units.all[*unit].case].source == Source::Hidden;
        let visible = |all: &[usize]| all.iter().copied().filter(|unit| !is_hidden(unit)).collect::<Vec<_>>();
        let (failing, passing) = (visible(&state.ruling.failing), visible(&state.ruling.passing));
        let failing: Option<Vec<u128>> = failing.into_iter().map(|unit| units.features(self.judge, unit)).collect();
        let all_passing = passing.len();
        let passing: Vec<u128> = passing.into_iter().filter_map(|unit| units.features(self.judge, unit)).collect();
        let unknown = all_passing - passing.len();
        let calls = Calls { failing: failing?, passing };
        let vocabulary = self.judge.vocabulary();
        let exact = shortest(&calls).map(|condition| sentence(condition, &calls, vocabulary));
        let mut told = exact.or_else(|| Some(necessary_sentence(necessary(&calls)?, &calls, vocabulary)))?;
        if unknown > 0 {
            told.push_str(&format!(" ({unknown} calls on large structures, which are right, are not compared.)"));
        }
        if state.ruling.judged() > calls.failing.len() + all_passing {
            told.insert_str(0, "Of the cases that you can see: ");
        }
        Some(told)
    }
}

/// What the first wrong value is in all calls in which the same is wrong, from the faults of each failing call. Two
/// calls at least must agree, and they must be at least half of those that fail.
fn instead<'a>(calls: impl Iterator<Item = Vec<&'a Fault>>) -> Option<String> {
    let calls: Vec<Vec<&Fault>> = calls.collect();
    let first = calls.first()?.iter().find(|fault| fault.instead.is_some())?;
    let subject = &first.instead.as_ref()?.subject;
    let same =
        |fault: &&&Fault| fault.rule == first.rule && fault.instead.as_ref().is_some_and(|i| i.subject == *subject);
    let like: Vec<&Instead> = calls.iter().filter_map(|faults| faults.iter().find(same)?.instead.as_ref()).collect();
    if like.len() < 2 || like.len() * 2 < calls.len() {
        return None;
    }
    let holds = |words: &&&str| like.iter().all(|instead| instead.is.contains(words));
    let is = like[0].is.iter().find(holds)?;
    Some(if like.len() == calls.len() {
        format!("In all {} failing calls, {subject} is {is}.", like.len())
    } else {
        format!("In all {} failing calls in which {subject} is wrong, it is {is}.", like.len())
    })
}

/// How many calls fail, of how many.
fn count(ruling: &Ruling) -> String {
    let (failing, judged, asked) = (ruling.failing.len(), ruling.judged(), ruling.asked);
    let calls = if judged == 1 { "call fails" } else { "calls fail" };
    let rest = match asked - judged {
        0 => String::new(),
        _ if ruling.because.is_empty() => format!("; {} after them are not judged", asked - judged),
        rest => {
            let because: Vec<&str> = ruling.because.iter().map(String::as_str).collect();
            format!("; {rest} are not judged: there, {} fails first", because.join(" or "))
        }
    };
    format!("{failing} of {judged} {calls}{rest}.")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_is_said_how_many_calls_fail_and_why_others_are_not_judged() {
        let said = |[failing, passing, asked]: [usize; 3], because: &[&str]| {
            let mut ruling = Ruling::default();
            ruling.asked = asked;
            ruling.failing = (0..failing).collect();
            ruling.passing = (failing..failing + passing).collect();
            ruling.because = because.iter().map(|&test| test.to_owned()).collect();
            count(&ruling)
        };
        assert_eq!(said([1, 0, 1], &[]), "1 of 1 call fails.");
        assert_eq!(said([2, 3, 5], &[]), "2 of 5 calls fail.");
        assert_eq!(said([1, 3, 9], &[]), "1 of 4 calls fail; 5 after them are not judged.");
        assert_eq!(
            said([1, 3, 9], &["split_face_1", "split_face_2"]),
            "1 of 4 calls fail; 5 are not judged: there, split_face_1 or split_face_2 fails first."
        );
    }
}
