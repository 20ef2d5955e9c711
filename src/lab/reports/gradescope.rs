//! `results.json` of a Gradescope autograder.
//!
//! Scores are numbers, `number` is a text that is sorted, `visibility` is one of four words. What a hidden test
//! found is in the file, because the instructor reads it there and Gradescope keeps it from the student.

use super::{pretty, words};
use crate::{Points, Report, TestResult, Visibility};
use serde_json::{Value, json};

/// The file.
pub(super) fn write(report: &Report) -> String {
    let mut output = words::circumstances(report).join("\n");
    if let Some(message) = &report.message {
        output = format!("{}: {message}\nNext: {}\n\n{output}", report.verdict, report.verdict.next_action());
    }
    if !report.printed.is_empty() {
        output.push_str("\n\nYour program printed:\n");
        output.push_str(&report.printed);
    }
    let mut tests: Vec<Value> = report.tests.iter().enumerate().map(|(i, test)| entry(i, test)).collect();
    tests.extend(report.all_adjustments().iter().enumerate().map(|(i, adjustment)| {
        json!({
            "name": adjustment.reason,
            "number": format!("99.{:02}", i + 1),
            "score": number(adjustment.points),
            "max_score": 0,
            "status": "passed",
            "visibility": "visible",
        })
    }));
    pretty(&json!({
        "score": number(report.points()),
        "execution_time": report.millis as f64 / 1000.0,
        "output": output,
        "output_format": "text",
        "visibility": "visible",
        "stdout_visibility": "hidden",
        "extra_data": {
            "kit": report.kit,
            "lab": report.lab,
            "lab_version": report.lab_version,
            "seed": report.seed.to_string(),
            "verdict": report.verdict.word(),
            "similar": words::similar(report),
        },
        "tests": tests,
    }))
}

/// Points as a number: whole ones without a point.
fn number(points: Points) -> Value {
    points.whole().map_or_else(|| points.as_f64().into(), Value::from)
}

fn entry(i: usize, test: &TestResult) -> Value {
    let visibility = match test.visibility {
        Visibility::Visible => "visible",
        Visibility::AfterDueDate => "after_due_date",
        Visibility::AfterPublished => "after_published",
        Visibility::Hidden => "hidden",
    };
    let rules: Vec<&str> = test.findings.iter().map(|f| f.rule.as_str()).collect();
    json!({
        "name": format!("{}: {}", test.name, test.title),
        "number": format!("{}.{:02}", test.task, i + 1),
        "score": number(test.points),
        "max_score": number(test.max_points),
        "status": if test.verdict.is_passed() { "passed" } else { "failed" },
        "output": format!("{}\n{}", test.verdict, words::of_test(test)),
        "output_format": "text",
        "tags": [format!("task {}", test.task)],
        "visibility": visibility,
        "extra_data": { "verdict": test.verdict.word(), "rules": rules, "bugs": test.bugs },
    })
}
