//! What a grading run says of one submission: plain data, from which every report format is written.

use super::manifest::{Manifest, Test};
use super::points::Points;
use super::verdict::Verdict;
use serde::{Deserialize, Serialize};

/// The outcome of one submission.
#[derive(Clone, PartialEq, Debug, Default, Serialize, Deserialize)]
pub struct Report {
    /// The version of the kit that graded.
    pub kit: String,
    /// The lab, as its folder is called: `04-half-edge`.
    pub lab: String,
    /// The version of the lab, from its manifest.
    pub lab_version: String,
    /// Who handed it in: the name of the file or folder, or a name from the class list.
    pub submission: Option<String>,
    /// The seed of the random cases.
    pub seed: u64,
    /// Passed if every test passed; else the worst verdict of a test, or what stopped the run before any test. A test
    /// that waits for others says nothing by itself.
    pub verdict: Verdict,
    /// Why no test could run, for a verdict on the whole: the compiler's first error, the forbidden construct.
    pub message: Option<String>,
    /// One for each graded test, in the order of the manifest.
    pub tests: Vec<TestResult>,
    /// The barriers that stood between the submission and the machine, and those that could not be had.
    #[serde(alias = "walls")]
    pub sandbox: Vec<Barrier>,
    /// What the student's program printed besides its answers, cut to a few kilobytes.
    pub printed: String,
    /// The optional files that were handed in, for a person to read: name and text.
    #[serde(default)]
    pub attachments: Vec<(String, String)>,
    /// Points that no test gives or takes: for answers that a person read, for lateness.
    #[serde(default)]
    pub adjustments: Vec<Adjustment>,
    /// What was odd about what was handed in, but did not keep it from being graded: `took src/Lab.rs for
    /// src/lab.rs`.
    #[serde(default)]
    pub notes: Vec<String>,
    /// Other submissions of the class that look like this one, the most alike first. For the instructor: no report
    /// on one submission for its author shows it.
    #[serde(default)]
    pub similar: Vec<Similar>,
    /// What the course adds to the tests: lateness, own tests, bounds.
    #[serde(default)]
    pub terms: Terms,
    /// How long building and running took, in milliseconds; left out of comparisons.
    pub millis: u64,
}

impl Report {
    /// The report on a submission of which no test could run, and why.
    #[must_use]
    pub fn untested(lab: &Manifest, verdict: Verdict, message: impl Into<String>) -> Self {
        let tests = lab.tests.iter().map(|test| TestResult::new(test, verdict)).collect();
        Self { verdict, message: Some(message.into()), tests, ..Self::of(lab) }
    }

    /// A report on a lab that says nothing yet.
    pub(super) fn of(lab: &Manifest) -> Self {
        let (lab, lab_version) = (lab.name.clone(), lab.version.clone());
        Self { kit: env!("CARGO_PKG_VERSION").to_owned(), lab, lab_version, ..Self::default() }
    }

    /// The same without what needs room: pictures, scripts, findings and what was printed. All that the tables of a
    /// class tell is still there.
    #[must_use]
    pub fn without_details(&self) -> Self {
        let bare = |test: &TestResult| TestResult {
            message: String::new(),
            place: None,
            findings: Vec::new(),
            script: None,
            replay: None,
            picture: None,
            pattern: None,
            ..test.clone()
        };
        let (tests, printed) = (self.tests.iter().map(bare).collect(), String::new());
        Self { tests, printed, attachments: Vec::new(), ..self.clone() }
    }

    /// What its author may read once it is handed back: nothing of hidden tests but what they gave, and nothing of
    /// other submissions.
    #[must_use]
    pub fn for_its_author(&self) -> Self {
        let bare = self.without_details();
        let pick = |(test, bare): (&TestResult, TestResult)| match test.visibility {
            Visibility::Hidden => TestResult { bugs: Vec::new(), message: "a hidden test".to_owned(), ..bare },
            _ => test.clone(),
        };
        let tests = self.tests.iter().zip(bare.tests).map(pick).collect();
        Self { tests, similar: Vec::new(), ..self.clone() }
    }

    /// The test to work on next: the first that fails; if none does, the first that is still to be written. Tests that
    /// were skipped come after what they wait for.
    #[must_use]
    pub fn next_test(&self) -> Option<&TestResult> {
        let first = |wanted: &dyn Fn(Verdict) -> bool| self.tests.iter().find(|test| wanted(test.verdict));
        first(&Verdict::is_failure)
            .or_else(|| first(&|verdict| verdict == Verdict::Unattempted))
            .or_else(|| first(&|verdict| !verdict.is_passed()))
    }

    /// The points that were earned: by the tests and by own tests, less what lateness costs, with all adjustments;
    /// then between the bounds of the course. Never below zero.
    #[must_use]
    pub fn points(&self) -> Points {
        let given = self.terms.late.iter().chain(&self.adjustments).map(|adjustment| adjustment.points);
        let points = self.earned() + given.sum();
        let most = self.terms.most.map_or(points, |most| points.min(most));
        most.max(self.terms.least.unwrap_or_default()).max(Points::ZERO)
    }

    /// What the tests and own tests have given.
    #[must_use]
    pub fn earned(&self) -> Points {
        let own = self.terms.own_tests.as_ref().map_or(Points::ZERO, |own| own.points);
        self.tests.iter().map(|test| test.points).sum::<Points>() + own
    }

    /// Everything that changes the points which the graded tests give: own tests, lateness, what a person gave or took.
    #[must_use]
    pub fn all_adjustments(&self) -> Vec<Adjustment> {
        let own = self.terms.own_tests.as_ref().filter(|own| own.points != Points::ZERO);
        let own = own.map(|own| Adjustment { reason: own.words(), points: own.points });
        own.into_iter().chain(self.terms.late.clone()).chain(self.adjustments.iter().cloned()).collect()
    }

    /// The points that the tests can give, own tests among them.
    #[must_use]
    pub fn max_points(&self) -> Points {
        let own = self.terms.own_tests.as_ref().map_or(Points::ZERO, |own| own.max_points);
        self.tests.iter().map(|test| test.max_points).sum::<Points>() + own
    }
}

/// What a course adds to the verdicts of the tests.
#[derive(Clone, PartialEq, Debug, Default, Serialize, Deserialize)]
pub struct Terms {
    /// When it was handed in, as far as that is known.
    pub handed_in: Option<HandedIn>,
    /// What lateness costs.
    pub late: Option<Adjustment>,
    /// What the student's own tests gave.
    pub own_tests: Option<OwnTests>,
    /// Nobody who handed something in gets less.
    pub least: Option<Points>,
    /// Nobody gets more.
    pub most: Option<Points>,
}

/// When something was handed in, and how that is known.
#[derive(Clone, PartialEq, Eq, Debug, Default, Serialize, Deserialize)]
pub struct HandedIn {
    /// When: `2026-10-12 23:59:00+02:00`.
    pub at: Option<String>,
    /// Whether the course system marks it as late, without a time.
    #[serde(default)]
    pub marked_late: bool,
    /// The due date of this student, if it is another one than that of the course.
    #[serde(default)]
    pub due: Option<String>,
    /// Where this is known from: `the metadata of Gradescope`, `the time of the file, ...`.
    pub known_from: String,
}

impl HandedIn {
    /// "2026-10-12 23:59:00+02:00, by the metadata of Gradescope".
    #[must_use]
    pub fn words(&self) -> String {
        let when = match (&self.at, self.marked_late) {
            (Some(at), _) => at.as_str(),
            (None, true) => "late",
            (None, false) => "in time",
        };
        let due = self.due.iter().map(|due| format!("; an own due date, {due}"));
        format!("{when}, by {}{}", self.known_from, due.collect::<String>())
    }
}

/// What came of a student's own tests.
#[derive(Clone, PartialEq, Eq, Debug, Default, Serialize, Deserialize)]
pub struct OwnTests {
    /// How many cases expect what the solution answers, too.
    pub cases: usize,
    /// How many known mistakes these catch; of how many.
    pub caught: usize,
    /// How many known mistakes there are.
    pub known: usize,
    /// What is wrong with the other cases, a sentence each.
    pub problems: Vec<String>,
    /// What they are worth.
    pub points: Points,
    /// What they can be worth.
    pub max_points: Points,
}

impl OwnTests {
    /// Says what catching all known mistakes is worth; catching some is worth their share.
    pub fn be_worth(&mut self, all: Points) {
        self.max_points = all;
        self.points = all.part(self.caught, self.known);
    }

    /// "own tests: 3 cases catch 17 of 69 known mistakes".
    #[must_use]
    pub fn words(&self) -> String {
        let cases = if self.cases == 1 { "case catches" } else { "cases catch" };
        format!("own tests: {} {cases} {} of {} known mistakes", self.cases, self.caught, self.known)
    }
}

/// Points given or taken by a person or a rule of the course.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
pub struct Adjustment {
    /// What for: `answers`, `two days late`.
    pub reason: String,
    /// How many; negative to take some.
    pub points: Points,
}

/// Another submission whose graded files look like this one's.
#[derive(Clone, PartialEq, Eq, Hash, Debug, Serialize, Deserialize)]
pub struct Similar {
    /// What the other one is called in the reports.
    pub submission: String,
    /// How much of what both wrote is in both, names and comments aside, in percent.
    pub percent: u8,
    /// Whether the files are the same, byte by byte.
    pub identical: bool,
}

/// The outcome of one graded test.
#[derive(Clone, PartialEq, Debug, Default, Serialize, Deserialize)]
pub struct TestResult {
    /// Its name: the function in `tests/graded.rs`.
    pub name: String,
    /// A line for people.
    pub title: String,
    /// The number of its task in the handout.
    pub task: u32,
    /// What came of it.
    pub verdict: Verdict,
    /// What is earned: all of `max_points`, or nothing.
    pub points: Points,
    /// What it is worth.
    pub max_points: Points,
    /// Who may see it when.
    pub visibility: Visibility,
    /// What happened, in one or two sentences; the panic message of a crash.
    pub message: String,
    /// `src/lab.rs:41:9`, where a panic came from.
    pub place: Option<String>,
    /// What the failing calls have in common and no passing one has, as a sentence.
    #[serde(default)]
    pub pattern: Option<String>,
    /// The broken promises, the most telling first; at most ten, then a count in the message.
    pub findings: Vec<Finding>,
    /// The known mistakes that fail in exactly this way; several if they cannot be told apart.
    pub bugs: Vec<String>,
    /// The shortest failing case that was found, as text for the driver. Never a hidden one.
    pub script: Option<String>,
    /// The command that replays it.
    pub replay: Option<String>,
    /// Before, expected, and the student's.
    pub picture: Option<Picture>,
}

impl TestResult {
    /// A test with this verdict, and nothing else known of it.
    #[must_use]
    pub fn new(test: &Test, verdict: Verdict) -> Self {
        Self {
            name: test.name.clone(),
            title: test.title.clone(),
            task: test.task,
            verdict,
            points: if verdict.is_passed() { test.points } else { Points::ZERO },
            max_points: test.points,
            visibility: test.visibility,
            ..Self::default()
        }
    }
}

/// A broken promise.
#[derive(Clone, PartialEq, Eq, Hash, Debug, Serialize, Deserialize)]
pub struct Finding {
    /// The check or law that found it: `N2`, `split_face.4`.
    pub rule: String,
    /// What is wrong, with the elements, the value found and the value expected.
    pub words: String,
    /// The section of the handout that explains it.
    pub section: String,
}

/// Three drawings of one failing call.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
pub struct Picture {
    /// The structure before the call, as SVG.
    pub before: String,
    /// What the call should have made of it.
    pub expected: String,
    /// What it made of it, with what differs marked.
    pub yours: String,
    /// The same for a terminal.
    pub ascii: String,
}

/// Who may see a test's result.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Visibility {
    /// Everybody, at once.
    #[default]
    Visible,
    /// The student, after the deadline.
    AfterDueDate,
    /// The student, when the grades are published.
    AfterPublished,
    /// The instructor only.
    Hidden,
}

/// A barrier between a submission and the machine.
#[derive(Clone, PartialEq, Eq, Hash, Debug, Serialize, Deserialize)]
pub struct Barrier {
    /// What it keeps in: `memory 512 MB`, `no network`, `own user 61234`.
    pub name: String,
    /// Whether it stood; if not, why.
    pub missing: Option<String>,
}

#[cfg(test)]
mod tests {
    use super::{Adjustment, OwnTests, Points, Report};

    #[test]
    fn adjustments_count_and_no_score_is_negative() {
        let mut report = Report::default();
        report.adjustments.push(Adjustment { reason: "answers".to_owned(), points: 5.into() });
        assert_eq!(report.points(), Points::from(5));
        report.adjustments.push(Adjustment { reason: "late".to_owned(), points: (-9).into() });
        assert_eq!(report.points(), Points::ZERO);
        report.terms.least = Some(2.into());
        assert_eq!(report.points(), Points::from(2));
    }

    #[test]
    fn own_tests_and_lateness_count_and_bounds_come_last() {
        let mut report = Report::default();
        let own = OwnTests { points: 4.into(), max_points: 5.into(), ..OwnTests::default() };
        report.terms.own_tests = Some(own);
        assert_eq!((report.earned(), report.points(), report.max_points()), (4.into(), 4.into(), 5.into()));
        report.terms.late = Some(Adjustment { reason: "late".to_owned(), points: (-1).into() });
        report.adjustments.push(Adjustment { reason: "answers".to_owned(), points: "7.5".parse().unwrap() });
        assert_eq!((report.points(), report.all_adjustments().len()), ("10.5".parse().unwrap(), 3));
        report.terms.most = Some(10.into());
        assert_eq!(report.points(), 10);
    }
}
