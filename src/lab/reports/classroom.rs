//! `result.json` of Classroom 50, schema `classroom50/result/v1`: whole points, keys with hyphens.
//!
//! Fractions of points are rounded to whole ones, a half upwards, each number by itself: the sum of the tests may differ
//! from the score by as much.

use super::pretty;
use crate::{Report, TestResult};
use serde_json::{Value, json};

/// The file.
pub(super) fn write(report: &Report) -> String {
    let entry = |test: &TestResult| -> Value {
        json!({
            "test-name": test.name,
            "passed": test.verdict.is_passed(),
            "score": test.points.rounded(),
            "max-score": test.max_points.rounded(),
        })
    };
    pretty(&json!({
        "schema": "classroom50/result/v1",
        "score": report.points().rounded(),
        "max-score": report.max_points().rounded(),
        "tests": report.tests.iter().map(entry).collect::<Vec<_>>(),
    }))
}
