//! JUnit XML as test runners write it: a suite for each submission, a case for each graded test.
//!
//! A wrong answer is a failure; what kept the test from running is an error; what was not tried because an earlier
//! test failed is skipped. Times are left out, so that equal runs give equal bytes.

use super::words;
use crate::{Report, TestResult, Verdict};
use quick_junit::{NonSuccessKind, Report as Suites, TestCase, TestCaseStatus, TestSuite};

/// The file.
pub(super) fn write(reports: &[Report]) -> String {
    let mut suites = Suites::new(reports.first().map_or("labs", |r| r.lab.as_str()));
    for report in reports {
        let mut suite = TestSuite::new(words::author(report));
        suite.add_property(("kit", report.kit.as_str()));
        suite.add_property(("seed", report.seed.to_string().as_str()));
        suite.add_property(("points", words::points(report).as_str()));
        if !report.similar.is_empty() {
            suite.add_property(("similar", words::similar(report).join("; ").as_str()));
        }
        suite.add_test_cases(report.tests.iter().map(|test| case(report, test)));
        if !report.printed.is_empty() {
            suite.set_system_out(words::clean(&report.printed));
        }
        suites.add_test_suite(suite);
    }
    // Only writing can fail, and this writes into memory.
    suites.to_string().unwrap_or_default()
}

fn case(report: &Report, test: &TestResult) -> TestCase {
    let status = match test.verdict {
        Verdict::Passed => TestCaseStatus::success(),
        Verdict::Skipped => {
            let mut status = TestCaseStatus::skipped();
            status.set_message(words::clean(&test.message));
            status
        }
        verdict => {
            let broken = matches!(verdict, Verdict::GraderFault | Verdict::DoesNotCompile | Verdict::Refused);
            let kind = if broken { NonSuccessKind::Error } else { NonSuccessKind::Failure };
            let mut status = TestCaseStatus::non_success(kind);
            status.set_type(verdict.word());
            status.set_message(words::clean(report.message.as_deref().unwrap_or(&test.message)));
            status.set_description(words::of_test(test));
            status
        }
    };
    let mut case = TestCase::new(test.name.as_str(), status);
    case.set_classname(report.lab.as_str());
    case
}
