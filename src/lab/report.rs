//! What a grading run says of one submission: plain data, from which every report format is written.

use super::manifest::{Manifest, Test};
use super::verdict::Verdict;
use serde::{Deserialize, Serialize};

/// The outcome of one submission.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
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
    /// How long building and running took, in milliseconds; left out of comparisons.
    pub millis: u64,
}

impl Report {
    /// The report on a submission of which no test could run, and why.
    #[must_use]
    pub fn untested(lab: &Manifest, verdict: Verdict, message: impl Into<String>) -> Self {
        Self {
            kit: env!("CARGO_PKG_VERSION").to_owned(),
            lab: lab.name.clone(),
            lab_version: lab.version.clone(),
            submission: None,
            seed: 0,
            verdict,
            message: Some(message.into()),
            tests: lab.tests.iter().map(|test| TestResult::new(test, verdict)).collect(),
            sandbox: Vec::new(),
            printed: String::new(),
            attachments: Vec::new(),
            adjustments: Vec::new(),
            notes: Vec::new(),
            similar: Vec::new(),
            millis: 0,
        }
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

    /// The points that were earned, adjustments included; never below zero.
    #[must_use]
    pub fn points(&self) -> u32 {
        let earned: i64 = self.tests.iter().map(|t| i64::from(t.points)).sum();
        let adjusted: i64 = self.adjustments.iter().map(|a| i64::from(a.points)).sum();
        u32::try_from((earned + adjusted).max(0)).unwrap_or(u32::MAX)
    }

    /// The points that the tests can give.
    #[must_use]
    pub fn max_points(&self) -> u32 {
        self.tests.iter().map(|t| t.max_points).sum()
    }
}

/// Points given or taken by a person or a rule of the course.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
pub struct Adjustment {
    /// What for: `answers`, `two days late`.
    pub reason: String,
    /// How many; negative to take some.
    pub points: i32,
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
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
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
    pub points: u32,
    /// What it is worth.
    pub max_points: u32,
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
            points: if verdict.is_passed() { test.points } else { 0 },
            max_points: test.points,
            visibility: test.visibility,
            message: String::new(),
            place: None,
            pattern: None,
            findings: Vec::new(),
            bugs: Vec::new(),
            script: None,
            replay: None,
            picture: None,
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
    use super::{Adjustment, Report, Verdict};

    #[test]
    fn adjustments_count_and_no_score_is_negative() {
        let mut report = Report {
            kit: String::new(),
            lab: String::new(),
            lab_version: String::new(),
            submission: None,
            seed: 0,
            verdict: Verdict::Passed,
            message: None,
            tests: Vec::new(),
            sandbox: Vec::new(),
            printed: String::new(),
            attachments: Vec::new(),
            adjustments: vec![Adjustment { reason: "answers".to_owned(), points: 5 }],
            notes: Vec::new(),
            similar: Vec::new(),
            millis: 0,
        };
        assert_eq!(report.points(), 5);
        report.adjustments.push(Adjustment { reason: "late".to_owned(), points: -9 });
        assert_eq!(report.points(), 0);
    }
}
