//! Reports hold what each format promises, for good and for hostile submissions.

use dcel_lab::reports::Format;
use dcel_lab::{
    Adjustment, Barrier, Finding, Picture, Points, Report, Similar, Terms, TestResult, Verdict, Visibility,
};
use serde_json::Value;

/// A name that tries to break out of every format.
const HOSTILE: &str = "=cmd()</script><b>]]>\"'&|`` \u{1}\u{1b}[31m\u{202e}";

fn test(name: &str, task: u32, verdict: Verdict, points: impl Into<Points>) -> TestResult {
    let points = points.into();
    TestResult {
        name: name.to_owned(),
        title: format!("what {name} asks"),
        task,
        verdict,
        points: if verdict.is_passed() { points } else { Points::ZERO },
        max_points: points,
        visibility: Visibility::Visible,
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

fn report() -> Report {
    let mut wrong = test("split_face_4_faces", 5, Verdict::Wrong, 6);
    wrong.message = "split_face h2 h8 left half-edges in the old face.".to_owned();
    wrong.findings.push(Finding {
        rule: "F1".to_owned(),
        words: "h8.face = f1, expected f2".to_owned(),
        section: "5".to_owned(),
    });
    wrong.bugs = vec!["the loop of the new face was not relabelled (step 4)".to_owned()];
    wrong.script = Some("rectangle\nsplit_face h2 h8\ndump".to_owned());
    wrong.replay = Some("cargo run < case.txt".to_owned());
    wrong.picture = Some(Picture {
        before: "<svg xmlns=\"http://www.w3.org/2000/svg\"><title>before</title></svg>".to_owned(),
        expected: "<svg xmlns=\"http://www.w3.org/2000/svg\"/>".to_owned(),
        yours: "<svg xmlns=\"http://www.w3.org/2000/svg\"/>".to_owned(),
        ascii: "h8  face f2 → f1\n".to_owned(),
    });
    let mut crashed = test("split_in_half_1_vertex", 6, Verdict::Crashed, 4);
    crashed.message = "index out of bounds".to_owned();
    crashed.place = Some("src/lab.rs:41:9".to_owned());
    Report {
        kit: "0.1.0".to_owned(),
        lab: "04-half-edge".to_owned(),
        lab_version: "1".to_owned(),
        submission: Some("anna".to_owned()),
        seed: 12345,
        verdict: Verdict::Crashed,
        message: None,
        tests: vec![
            test("face_walk", 1, Verdict::Passed, 8),
            test("vertex_star", 4, Verdict::Unattempted, 10),
            wrong,
            test("split_face_5_representatives", 5, Verdict::Skipped, 6),
            crashed,
        ],
        sandbox: vec![
            Barrier { name: "memory 512 MB".to_owned(), missing: None },
            Barrier { name: "no network".to_owned(), missing: Some("user namespaces are not allowed".to_owned()) },
        ],
        printed: "debugging\n".to_owned(),
        attachments: vec![("answers.md".to_owned(), "By next.origin.\n".to_owned())],
        adjustments: vec![Adjustment { reason: "answers".to_owned(), points: 2.into() }],
        notes: Vec::new(),
        similar: Vec::new(),
        terms: Terms::default(),
        millis: 700,
    }
}

/// One in which every text that a student can choose is hostile, and a hidden test failed.
fn hostile() -> Report {
    let mut report = report();
    report.submission = Some(HOSTILE.to_owned());
    report.printed = HOSTILE.repeat(3);
    report.attachments = vec![(HOSTILE.to_owned(), HOSTILE.to_owned())];
    for test in &mut report.tests {
        test.message = HOSTILE.to_owned();
    }
    report.tests[2].findings[0].words = HOSTILE.to_owned();
    report.tests[2].visibility = Visibility::Hidden;
    report.tests[2].message = "the secret is 77".to_owned();
    report
}

fn broken() -> Report {
    let mut report = report();
    report.verdict = Verdict::DoesNotCompile;
    report.message = Some("error[E0308]: mismatched types\n --> src/lab.rs:3:5".to_owned());
    for test in &mut report.tests {
        *test = TestResult { verdict: Verdict::DoesNotCompile, points: Points::ZERO, ..super_plain(test) };
    }
    report
}

fn super_plain(t: &TestResult) -> TestResult {
    test(&t.name, t.task, Verdict::DoesNotCompile, t.max_points)
}

fn json(format: Format, report: &Report) -> Value {
    serde_json::from_str(&format.one(report)).unwrap()
}

#[test]
fn every_format_is_written_for_every_kind_of_report_and_always_the_same() {
    for report in [report(), hostile(), broken(), Report { tests: Vec::new(), ..report() }] {
        for format in Format::ALL {
            assert_eq!(Format::by_name(format.name()), Some(format));
            let text = format.one(&report);
            assert!(text.ends_with('\n') || format == Format::Junit, "{format} ends its last line");
            assert_eq!(text, format.one(&report.clone()), "{format} depends on the report alone");
            assert_eq!(format.class(&[report.clone(), report.clone()]).is_ok(), format.holds_a_class(), "{format}");
            assert!(!text.contains('\u{1b}'), "{format} lets an escape sequence through: {text}");
            let mut later = report.clone();
            later.millis += 1;
            let timed = matches!(format, Format::Gradescope | Format::Json);
            assert_eq!(format.one(&later) != text, timed, "{format} and the time");
        }
    }
}

#[test]
fn gradescope_gets_the_types_it_asks_for() {
    for report in [report(), hostile(), broken()] {
        let file = json(Format::Gradescope, &report);
        assert_eq!(file["score"], report.points().whole().unwrap());
        assert!(file["execution_time"].is_f64());
        assert!(file["output"].is_string());
        for key in ["output_format", "visibility", "stdout_visibility"] {
            assert!(file[key].is_string(), "{key}");
        }
        let tests = file["tests"].as_array().unwrap();
        assert_eq!(tests.len(), report.tests.len() + report.adjustments.len());
        let mut numbers = Vec::new();
        for (entry, test) in tests.iter().zip(&report.tests) {
            assert_eq!(entry["score"], test.points.whole().unwrap());
            assert_eq!(entry["max_score"], test.max_points.whole().unwrap());
            assert_eq!(entry["status"], if test.verdict.is_passed() { "passed" } else { "failed" });
            assert!(entry["tags"].as_array().unwrap().iter().all(Value::is_string));
            numbers.push(entry["number"].as_str().unwrap().to_owned());
        }
        let mut sorted = numbers.clone();
        sorted.sort();
        assert_eq!(numbers, sorted, "the numbers sort as texts");
    }
    let file = json(Format::Gradescope, &hostile());
    assert_eq!(file["tests"][2]["visibility"], "hidden");
    assert!(json(Format::Gradescope, &broken())["output"].as_str().unwrap().contains("mismatched types"));
}

#[test]
fn classroom_50_gets_whole_points_under_hyphenated_keys() {
    let file = json(Format::Classroom50, &report());
    assert_eq!(file["schema"], "classroom50/result/v1");
    assert_eq!(file["score"], 10);
    assert_eq!(file["max-score"], 34);
    assert_eq!(file["tests"][0]["test-name"], "face_walk");
    assert_eq!(file["tests"][0]["passed"], true);
    assert_eq!(file["tests"][2]["score"], 0);
    assert_eq!(file["tests"][2]["max-score"], 6);
}

#[test]
fn exercism_gets_version_3_and_short_outputs() {
    let mut long = report();
    long.tests[2].picture.as_mut().unwrap().ascii = "ö".repeat(2000);
    let file = json(Format::Exercism, &long);
    assert_eq!(file["version"], 3);
    assert_eq!(file["status"], "fail");
    assert!(file.get("message").is_none());
    assert_eq!(file["tests"][2]["task_id"], 5);
    assert_eq!(file["tests"][2]["output"].as_str().unwrap().chars().count(), 500);
    assert_eq!(file["tests"][0]["message"], Value::Null);
    let file = json(Format::Exercism, &broken());
    assert_eq!(file["status"], "error");
    assert!(file["message"].as_str().unwrap().starts_with("does not compile: error[E0308]"));
}

#[test]
fn students_read_nothing_of_a_hidden_test() {
    let report = hostile();
    for format in [Format::Classroom50, Format::Exercism, Format::Markdown] {
        let text = format.one(&report);
        assert!(!text.contains("secret"), "{format}: {text}");
        assert!(!text.contains("not relabelled"), "{format}: {text}");
    }
    assert!(Format::Gradescope.one(&report).contains("secret"), "Gradescope hides it itself");
}

#[test]
fn junit_is_xml_whatever_a_program_printed() {
    let reports = [report(), hostile(), broken()];
    let text = Format::Junit.class(&reports).unwrap();
    let document = roxmltree::Document::parse(&text).unwrap();
    let suites: Vec<_> = document.descendants().filter(|n| n.has_tag_name("testsuite")).collect();
    assert_eq!(suites.len(), 3);
    assert_eq!(suites[0].attribute("name"), Some("anna"));
    let kinds =
        |suite: &roxmltree::Node<'_, '_>, kind: &str| suite.descendants().filter(|n| n.has_tag_name(kind)).count();
    assert_eq!(kinds(&suites[0], "testcase"), 5);
    assert_eq!(kinds(&suites[0], "failure"), 3);
    assert_eq!(kinds(&suites[0], "skipped"), 1);
    assert_eq!(kinds(&suites[2], "error"), 5);
    let failure = suites[0].descendants().find(|n| n.has_tag_name("failure") && n.attribute("type") == Some("wrong"));
    assert!(failure.unwrap().text().unwrap().contains("h8.face = f1, expected f2"));
}

#[test]
fn junit_has_what_was_printed_if_anything_was() {
    let [mut quiet, mut loud] = [report(), report()];
    quiet.printed = String::new();
    loud.printed = "at h3".to_owned();
    assert!(!Format::Junit.one(&quiet).contains("system-out"));
    assert!(Format::Junit.one(&loud).contains("<system-out>at h3</system-out>"));
}

#[test]
fn spreadsheets_see_no_formula_and_one_row_each() {
    let text = Format::Csv.class(&[report(), hostile()]).unwrap();
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let head = reader.headers().unwrap().clone();
    let rows: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
    assert_eq!(rows.len(), 2);
    let column = |name: &str| head.iter().position(|h| h == name).unwrap();
    assert_eq!(&rows[0][column("submission")], "anna");
    assert_eq!(&rows[0][column("points")], "10");
    assert_eq!(&rows[0][column("face_walk")], "8");
    assert_eq!(&rows[0][column("adjustments")], "answers: +2");
    for row in &rows {
        assert!(row.iter().all(|cell| !cell.starts_with(['=', '+', '-', '@'])), "{row:?}");
    }
    assert!(rows[1][0].starts_with("'=cmd()"));

    let text = Format::Bugs.class(&[report(), report(), broken()]).unwrap();
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let rows: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
    assert_eq!(rows.len(), 1);
    assert_eq!(&rows[0][0], "the loop of the new face was not relabelled (step 4)");
    assert_eq!(&rows[0][1], "2");
}

#[test]
fn pages_hold_what_they_say_and_nothing_runs() {
    let page = Format::Html.class(&[report(), hostile(), broken()]).unwrap();
    assert!(!page.contains("<script") && !page.contains("</script>"), "no script, no end of one");
    assert!(!page.contains("<b>"), "markup of a submission stays text");
    let body = page.strip_prefix("<!DOCTYPE html>").unwrap().replace("<br>", "<br/>");
    let tags = body.matches("<section").count();
    assert_eq!(tags, 3);
    assert_eq!(page.matches("<figure ").count(), 6, "three pictures for each failing call");
    // What failed comes first, what passed is folded.
    let one = Format::Html.one(&report());
    let place = |text: &str| one.find(text).unwrap_or_else(|| panic!("the page has no {text}"));
    assert!(place("<article") < place("Still to do") && place("Still to do") < place("1 test passed"));
    assert!(place("left half-edges in the old face") < place("<img") && place("<img") < place("The shortest case"));
    assert!(!one.contains("F1"), "codes of rules are not for students");
    assert!(page.contains("src=\"data:image/svg+xml,%3csvg%20xmlns=%22http://www.w3.org/2000/svg%22%3e%3ctitle"));
    let ids: Vec<&str> = page.split(" id=\"").skip(1).map(|rest| &rest[..rest.find('"').unwrap()]).collect();
    for link in page.split("href=\"#").skip(1).map(|rest| &rest[..rest.find('"').unwrap()]) {
        assert_eq!(ids.iter().filter(|id| **id == link).count(), 1, "{link}");
    }
}

#[test]
fn a_page_has_the_pictures_as_text_where_there_is_one() {
    let mut one = report();
    let page = Format::Html.one(&one);
    assert_eq!(page.matches("The pictures as text").count(), 1);
    assert!(page.contains("<pre>h8  face f2 → f1\n</pre>"), "{page}");
    one.tests.iter_mut().filter_map(|test| test.picture.as_mut()).for_each(|picture| picture.ascii.clear());
    let page = Format::Html.one(&one);
    assert!(page.contains("<figure ") && !page.contains("The pictures as text"), "{page}");
}

#[test]
fn what_is_still_to_do_is_open_in_a_page_and_what_is_wrong_is_not() {
    for (verdict, class, sign) in [
        (Verdict::Passed, "yes", '✓'),
        (Verdict::Unattempted, "open", '○'),
        (Verdict::Skipped, "open", '○'),
        (Verdict::Wrong, "no", '✗'),
        (Verdict::Crashed, "no", '✗'),
    ] {
        let mut one = report();
        one.tests = vec![test("split_face", 5, verdict, 6)];
        one.verdict = verdict;
        let page = Format::Html.one(&one);
        let signs: Vec<&str> =
            ["✓", "○", "✗", "!"].into_iter().filter(|s| page.contains(&format!("\">{s} "))).collect();
        assert_eq!(signs, [sign.to_string()], "{verdict}");
        assert!(page.contains(&format!("<span class=\"{class}\">{sign} ")), "{verdict}: {page}");
    }
}

#[test]
fn drawings_in_a_page_are_as_wide_as_they_say() {
    let mut one = report();
    for picture in one.tests.iter_mut().filter_map(|test| test.picture.as_mut()) {
        picture.before = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"431px\"/>".to_owned();
    }
    let page = Format::Html.one(&one);
    let widths: Vec<&str> = page.split(" width=\"").skip(1).map(|rest| rest.split('"').next().unwrap()).collect();
    assert_eq!(widths[0], "431", "{widths:?}");
    assert_eq!(widths[1], widths[2], "drawings without a width are equally wide: {widths:?}");
    assert!(widths[1].parse::<f64>().unwrap() > 200.0, "{widths:?}");
}

#[test]
fn markdown_fits_a_step_summary_and_no_text_breaks_a_table() {
    let mut report = report();
    report.tests[2].message = "`````\n".repeat(300_000);
    let text = Format::Markdown.one(&report);
    assert!(text.len() < 1 << 20);
    assert!(text.contains("left out"));
    assert!(!text.contains("<svg"));
    let text = Format::Markdown.class(&[hostile(), hostile()]).unwrap();
    assert!(text.contains("| =cmd()&lt;/script>&lt;b>\\]\\]>\"'&amp;\\|\\`\\` "), "{text}");
}

#[test]
fn a_half_done_lab_is_summed_up_by_its_points_and_what_is_next() {
    let mut report = report();
    report.verdict = Verdict::Unattempted;
    report.tests.retain(|test| !test.verdict.is_failure());
    for format in [Format::Text, Format::Html, Format::Markdown] {
        let text = format.one(&report);
        assert!(text.contains("10 of 24 points") && text.contains("not finished"), "{format}: {text}");
        assert!(text.contains("task 4, what vertex"), "{format}: {text}");
    }
}

#[test]
fn a_stored_report_is_read_back_whole() {
    let stored = Format::Json.one(&hostile());
    let read: Report = serde_json::from_str(&stored).unwrap();
    assert_eq!(read, hostile());
}

#[test]
fn the_text_for_a_terminal_says_what_to_do() {
    let text = Format::Text.one(&report());
    let expected = "04-half-edge: anna, 10 of 34 points, crashed
Next: task 5, what split_face_4_faces asks: wrong.
Lab 04-half-edge version 1, kit 0.1.0.
Seed 12345: LAB_SEED=12345 gives the same random cases.
Sandbox: memory 512 MB.
Not in the sandbox: no network: user namespaces are not allowed.

task 1
  passed             8/8  face_walk

task 4
  unattempted       0/10  vertex_star

task 5
  wrong              0/6  split_face_4_faces
  skipped            0/6  split_face_5_representatives

task 6
  crashed            0/4  split_in_half_1_vertex
  +2 points: answers

vertex_star: unattempted, what vertex_star asks
  Next: Replace the todo!() by your code.

split_face_4_faces: wrong, what split_face_4_faces asks
  split_face h2 h8 left half-edges in the old face.
  Same failures as: the loop of the new face was not relabelled (step 4)
  - h8.face = f1, expected f2 (handout: 5)
  Shortest failing script:
      rectangle
      split_face h2 h8
      dump
  Replay it: cargo run < case.txt
  Next: Read the first finding, look at the picture if there is one, then replay the case.
  h8  face f2 → f1

split_face_5_representatives: skipped, what split_face_5_representatives asks
  Next: Make the test that it builds on pass first.

split_in_half_1_vertex: crashed, what split_in_half_1_vertex asks
  index out of bounds
  at src/lab.rs:41:9
  Next: Go to the line of the panic; replay the script to get there.

Your program printed:
  debugging

answers.md:
  By next.origin.
";
    assert_eq!(text, expected);
}

#[test]
fn a_name_with_a_line_break_cannot_break_a_table() {
    for name in ["anna\nben  100/100  passed", "anna\r| x | y |", "a\u{2028}b\tc"] {
        let named = Report { submission: Some(name.to_owned()), ..report() };
        let class = [named, report()];
        for format in [Format::Text, Format::Markdown, Format::Html, Format::Csv, Format::Junit] {
            let (hostile, plain) = (format.class(&class).unwrap(), format.class(&[report(), report()]).unwrap());
            let lines = |text: &str| text.lines().count();
            assert_eq!(lines(&hostile), lines(&plain), "{format}: {hostile}");
        }
        let sheet = Format::Csv.class(&class).unwrap();
        assert_eq!(csv::Reader::from_reader(sheet.as_bytes()).records().map(Result::unwrap).count(), 2);
    }
}

#[test]
fn blanks_before_a_formula_do_not_bring_it_into_a_spreadsheet() {
    for name in [" =1+1", "\u{a0}=1+1", "  +1+1", " -1+1", " @x", "\t=1+1", "＝1+1", " \t=1+1"] {
        let text = Format::Csv.one(&Report { submission: Some(name.to_owned()), ..report() });
        let mut reader = csv::Reader::from_reader(text.as_bytes());
        let cell = reader.records().next().unwrap().unwrap()[0].to_owned();
        assert!(cell.starts_with('\''), "{name:?} gives {cell:?}");
    }
    let number = Report {
        adjustments: vec![Adjustment { reason: "late".to_owned(), points: (-4).into() }],
        submission: Some("-4".to_owned()),
        ..report()
    };
    assert!(Format::Csv.one(&number).contains("\n-4,crashed,"), "numbers stay numbers");
}

#[test]
fn a_failure_of_the_grader_is_no_grade() {
    let text = Format::Csv.one(&Report { verdict: Verdict::GraderFault, ..report() });
    assert!(text.contains("\nanna,grader fault,,34,"), "{text}");
}

#[test]
fn those_that_look_alike_are_named_to_the_instructor_and_not_to_each_other() {
    let similar =
        |submission: &str, percent, identical| Similar { submission: submission.to_owned(), percent, identical };
    let alike = Report { similar: vec![similar("dora", 100, true), similar("carl", 93, false)], ..report() };
    let class = [alike.clone(), Report { submission: Some("ben".to_owned()), ..report() }];
    for format in Format::ALL
        .into_iter()
        .filter(|format| format.holds_a_class() && ![Format::Bugs, Format::Statistics].contains(format))
    {
        let text = format.class(&class).unwrap();
        assert!(text.contains("dora") && text.contains("carl") && text.contains("93"), "{format}: {text}");
        let plain = format.class(&[class[1].clone(), class[1].clone()]).unwrap();
        assert!(!plain.contains("look alike") && !plain.contains("dora"), "{format}: {plain}");
    }
    for format in [Format::Text, Format::Html, Format::Markdown, Format::Classroom50, Format::Exercism] {
        let text = format.one(&alike);
        assert!(!text.contains("dora"), "{format} tells a student of another: {text}");
    }
}

#[test]
fn what_was_odd_is_noted_in_what_the_student_reads() {
    let noted = Report { notes: vec!["took src/Lab.rs for src/lab.rs".to_owned()], ..report() };
    for format in [Format::Text, Format::Html, Format::Markdown, Format::Gradescope, Format::Json, Format::Csv] {
        assert!(format.one(&noted).contains("took src/Lab.rs for src/lab.rs"), "{format}");
    }
}

#[test]
fn a_page_that_is_handed_back_tells_nothing_hidden_and_nothing_of_others() {
    let similar = vec![Similar { submission: "dora".to_owned(), percent: 90, identical: false }];
    let open = Report { similar, ..hostile() }.for_its_author();
    let page = Format::Html.one(&open);
    assert!(!page.contains("secret") && !page.contains("not relabelled") && !page.contains("dora"), "{page}");
    assert_eq!((open.points(), open.tests.len()), (hostile().points(), hostile().tests.len()));
    let plain = report();
    assert_eq!(plain.for_its_author(), plain, "nothing hidden, nothing gone");
}

#[test]
fn an_index_links_to_the_pages_and_says_when_some_are_missing() {
    let class = [report(), Report { submission: Some("b/c & <d>".to_owned()), ..report() }];
    let pages = ["students/anna.html".to_owned(), "students/b c#%.html".to_owned()];
    let page = dcel_lab::reports::index(&class, &pages, 3);
    assert!(
        page.contains("href=\"students/anna.html\"") && page.contains("href=\"students/b%20c%23%25.html\""),
        "{page}"
    );
    assert!(page.contains("2 of 3 submissions") && page.contains("Not all are graded yet"), "{page}");
    assert!(!dcel_lab::reports::index(&class, &pages, 2).contains("Not all"));
    // The details are on the other pages.
    let bare: Vec<Report> = class.iter().map(Report::without_details).collect();
    assert_eq!(dcel_lab::reports::index(&bare, &pages, 3), page);
}

#[test]
fn statistics_are_of_those_who_were_graded() {
    let class = |verdicts: &[Verdict]| -> Vec<Report> {
        let one = |&verdict: &Verdict| {
            let mut result = test("face_walk", 1, verdict, 8);
            if verdict == Verdict::Wrong {
                result.bugs = vec!["it turns <left>".to_owned()];
            }
            Report { verdict, message: None, tests: vec![result], ..report() }
        };
        verdicts.iter().map(one).collect()
    };
    let mut reports = class(&[Verdict::Passed, Verdict::Wrong, Verdict::Wrong, Verdict::Crashed, Verdict::GraderFault]);
    let mut missing = class(&[Verdict::Unattempted]).remove(0);
    missing.message = Some("Nothing was handed in.".to_owned());
    reports.push(missing);
    let csv = Format::Statistics.class(&reports).unwrap();
    let row: Vec<&str> = csv.lines().nth(1).unwrap().split(',').collect();
    assert_eq!(row[2..9], ["1", "4", "1", "0.250", "2.000", "8.000", "0.750"], "{csv}");
    assert_eq!(row[9..], ["passed 1; wrong 2; crashed 1", "2 x it turns <left>"], "{csv}");
    let page = Format::Html.class(&reports).unwrap();
    assert!(
        page.contains("<td>1 of 4 (25 %)</td><td>2.00 of 8</td><td>0.75</td><td>2 × it turns &lt;left&gt;</td>"),
        "{page}"
    );
}
