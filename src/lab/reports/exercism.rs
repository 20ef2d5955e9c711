//! `results.json` of an exercism test runner, version 3: tests in the order of the file, at most 500 characters of
//! output each, the number of the task.

use super::{open_to_the_student, pretty, words};
use crate::{Report, TestResult, Verdict};
use serde_json::{Value, json};

const OUTPUT: usize = 500;

/// The file.
pub(super) fn write(report: &Report) -> String {
    let status = match report.verdict {
        Verdict::Passed => "pass",
        _ if report.message.is_some() => "error",
        _ => "fail",
    };
    let tests: Vec<Value> = report.tests.iter().map(entry).collect();
    let mut file = json!({ "version": 3, "status": status, "tests": tests });
    if let (Some(message), Some(file)) = (&report.message, file.as_object_mut()) {
        file.insert("message".to_owned(), format!("{}: {message}", report.verdict).into());
    }
    pretty(&file)
}

fn entry(test: &TestResult) -> Value {
    let status = match test.verdict {
        Verdict::Passed => "pass",
        Verdict::GraderFault | Verdict::DoesNotCompile | Verdict::Refused => "error",
        _ => "fail",
    };
    let message = match (test.verdict.is_passed(), open_to_the_student(test)) {
        (true, _) => Value::Null,
        (false, false) => format!("{}: a hidden test", test.verdict).into(),
        (false, true) => format!("{}: {}", test.verdict, words::of_test(test)).into(),
    };
    let ascii = test.picture.as_ref().filter(|_| open_to_the_student(test)).map(|p| cut(&p.ascii));
    json!({
        "name": test.title,
        "test_code": test.script.as_deref().filter(|_| open_to_the_student(test)).unwrap_or(&test.name),
        "status": status,
        "message": message,
        "output": ascii,
        "task_id": test.task,
    })
}

/// At most [`OUTPUT`] characters, the last of them an ellipsis where some are missing.
fn cut(text: &str) -> String {
    if text.chars().count() <= OUTPUT {
        return text.to_owned();
    }
    text.chars().take(OUTPUT - 1).chain(['…']).collect()
}
