//! `result.json` of Classroom 50, schema `classroom50/result/v1`: whole points, keys with hyphens.

use super::pretty;
use crate::{Report, TestResult};
use serde_json::{Value, json};

/// The file.
pub(super) fn write(report: &Report) -> String {
    let entry = |test: &TestResult| -> Value {
        json!({
            "test-name": test.name,
            "passed": test.verdict.is_passed(),
            "score": test.points,
            "max-score": test.max_points,
        })
    };
    pretty(&json!({
        "schema": "classroom50/result/v1",
        "score": report.points(),
        "max-score": report.max_points(),
        "tests": report.tests.iter().map(entry).collect::<Vec<_>>(),
    }))
}
