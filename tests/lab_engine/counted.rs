//! Counted reads: a loop that does not come back costs its own step and no other, and nobody can give it more reads.

use super::{build, folder, lab, try_build};
use dcel_lab::{Plan, Report, Verdict, grade_program};
use std::fs;

fn solution() -> String {
    fs::read_to_string(folder().join("solution/lab.rs")).unwrap()
}

/// The report on the solution with some text replaced.
fn graded(edits: &[(&str, &str)]) -> Report {
    let mut text = solution();
    for (find, replace) in edits {
        assert_eq!(text.matches(find).count(), 1, "{find}");
        text = text.replace(find, replace);
    }
    let dir = tempfile::tempdir().unwrap();
    grade_program(&lab(), &build(dir.path(), &text), &Plan::with_seed(3))
}

#[test]
fn a_slip_in_step_3_costs_no_earlier_step_although_the_loop_of_step_4_never_ends() {
    let report = graded(&[("self.make_next(before2, back);", "self.make_next(before1, back);")]);
    let verdict = |name: &str| report.tests.iter().find(|test| test.name == name).unwrap().verdict;
    for passed in ["split_face_0_legal", "split_face_1_new_face", "split_face_2_half_edges", "split_in_half_3_links"] {
        assert_eq!(verdict(passed), Verdict::Passed, "{passed}");
    }
    assert_eq!(verdict("split_face_4_faces"), Verdict::Skipped);
    assert_eq!(report.points(), 60);
    let step = report.tests.iter().find(|test| test.name == "split_face_3_links").unwrap();
    assert_eq!(step.verdict, Verdict::Wrong, "{step:#?}");
    assert!(step.findings.iter().any(|finding| finding.words.contains(".next is ")), "{step:#?}");
}

#[test]
fn a_drawing_that_never_ends_is_stopped_and_the_circle_is_named() {
    // Between two moves, and by moves without end.
    for (replace, words) in [
        (
            "let sky = pen.face(0);\n    let mut h = 0;\n    loop { h = pen.next(h); if h > 99 { break; } }",
            "h0, h2, h4",
        ),
        ("let sky = pen.face(0);\n    loop { pen.split_in_half(0); if sky > 99 { break; } }", "does not come back"),
    ] {
        let report = graded(&[("let sky = pen.face(0);", replace)]);
        let drawing = report.tests.iter().find(|test| test.name == "drawing").unwrap();
        assert_eq!(drawing.verdict, Verdict::DoesNotComeBack, "{drawing:#?}");
        assert!(drawing.message.contains(words), "{}", drawing.message);
        assert!(drawing.place.as_ref().unwrap().starts_with("lab.rs:"), "{:?}", drawing.place);
        assert_eq!(report.points(), 92);
    }
}

#[test]
fn who_catches_the_end_of_a_call_has_not_answered_it() {
    let report = graded(&[(
        "        let twin = self.twin(h);\n        self.origin(twin)\n",
        "        let _ = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| loop { self.twin(h); }));\n        \
         let hook = crate::harness::answers::<crate::calls::HalfEdgeLab>;\n        \
         let _ = std::panic::catch_unwind(|| hook(\"rectangle\\nwalk_face h0\\n\"));\n        \
         let twin = self.half_edges.get(h).unwrap().twin.unwrap();\n        self.half_edges.get(twin).unwrap().origin.unwrap()\n",
    )]);
    let test = report.tests.iter().find(|test| test.name == "destination_by_twin").unwrap();
    assert_eq!(test.verdict, Verdict::DoesNotComeBack, "{test:#?}");
}

#[test]
fn neither_the_counters_nor_the_token_can_be_reached_from_the_students_file() {
    let attempts = [
        "crate::harness::reads::begin(1_000_000);",
        "let _ = crate::harness::reads::end();",
        "crate::harness::Meter::new().next_move(1_000_000);",
        "crate::harness::output::Output::new();",
        "let _: fn(&Pen) = |pen| pen.meter.next_move(1_000_000);",
        "let _: fn(&Dcel) = |dcel| drop(&dcel.half_edges.items);",
    ];
    let dir = tempfile::tempdir().unwrap();
    let functions: Vec<String> =
        attempts.iter().enumerate().map(|(i, attempt)| format!("fn attempt_{i}() {{ {attempt} }}\n")).collect();
    let said = try_build(dir.path(), &(solution() + &functions.concat())).expect_err("it compiles");
    let first = solution().lines().count() + 1;
    for (i, attempt) in attempts.iter().enumerate() {
        let place = format!("lab.rs:{}:", first + i);
        let error =
            said.split("error[").find(|error| error.contains(&place)).unwrap_or_else(|| panic!("{attempt}: {said}"));
        assert!(error.contains("private"), "{attempt}: {error}");
    }
}
