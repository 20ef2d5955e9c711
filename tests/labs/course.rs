//! What a course.toml does to the grades of a class.

use crate::shell::Folder;
use dcel_lab::{Lab, Report, Verdict};
use std::fs;

const COURSE: &str = r#"title = "Geometry"
utc_offset = "+02:00"

[late]
every = "day"
takes = "1/3"
grace_minutes = 10

[[lab]]
name = "04-half-edge"
due = 2026-10-12T23:59:00
most = 104
test.face_walk = { points = 7.5 }
test.face_vertices = { points = 4.5 }
"#;

/// A stored class of three, each of whom has all points of lab 04 but those of the last test.
fn stored(shell: &Folder) {
    let lab = Lab::bundled("04").unwrap();
    let report = |name: &str| {
        let mut report = Report::untested(&lab.manifest, Verdict::Wrong, "x");
        report.message = None;
        report.submission = Some(name.to_owned());
        let last = report.tests.len() - 1;
        for test in &mut report.tests[..last] {
            (test.verdict, test.points) = (Verdict::Passed, test.max_points);
        }
        report
    };
    shell.write("class.json", &serde_json::to_string(&["anna", "ben", "cara"].map(report)).unwrap());
}

fn points(shell: &Folder, file: &str) -> Vec<String> {
    let reports: Vec<Report> = serde_json::from_str(&shell.read(file)).unwrap();
    reports.iter().map(|report| report.points().to_string()).collect()
}

#[test]
fn a_changed_course_is_applied_to_what_was_graded_before() {
    let shell = Folder::new();
    stored(&shell);
    shell.write("course.toml", COURSE);
    shell.write(
        "times.csv",
        "submission,handed_in,due\nanna,2026-10-12T21:59:00Z,\nben,2026-10-13T00:20:00+02:00,\n\
         cara,2026-10-14T12:00:00+02:00,2026-10-14T23:59:00+02:00\n",
    );
    let again = "grade 04 --from-report class.json --course course.toml --times times.csv";
    shell.dcel(&format!("{again} --report json=out.json --report csv=out.csv")).fine();
    assert_eq!(points(&shell, "out.json"), ["98", "65.333", "98"]);
    let reports: Vec<Report> = serde_json::from_str(&shell.read("out.json")).unwrap();
    assert_eq!(reports[0].tests[0].points.to_string(), "7.5");
    assert!(shell.read("out.csv").contains("late: 1 day after 2026-10-12 23:59:00+02:00, 33.333 % each: -32.667"));
    assert_eq!(reports[2].terms.handed_in.as_ref().unwrap().due.as_deref(), Some("2026-10-14 23:59:00+02:00"));

    // Once more, from what was written, by a milder rule: nothing is taken twice, and the times are still known.
    shell.write("course.toml", &COURSE.replace("1/3", "1/4"));
    shell.write("adjust.csv", "submission,points,reason\nanna,7.5,answers\nben,-0.5,\"no name\"\n");
    let again = "grade 04 --from-report out.json --course course.toml --adjust adjust.csv --report json=again.json";
    shell.dcel(again).fine();
    assert_eq!(points(&shell, "again.json"), ["104", "73", "98"]);
}

#[test]
fn when_it_was_handed_in_is_said_with_where_that_is_known_from() {
    let shell = Folder::new();
    shell.write("course.toml", COURSE);
    let refused = |number: usize| format!("use std::fs; // {number}\n");
    fs::create_dir_all(shell.path("class/cara/src")).unwrap();
    shell.write("class/arndtanna_4711_90210_lab.rs", &refused(1));
    shell.write("class/bachben_LATE_4712_90212_lab.rs", &refused(2));
    shell.write("class/cara/src/lab.rs", &refused(3));
    let file = fs::File::options().write(true).open(shell.path("class/cara/src/lab.rs")).unwrap();
    let due = std::time::UNIX_EPOCH + std::time::Duration::from_secs(1_791_842_340);
    file.set_modified(due + std::time::Duration::from_secs(3600)).unwrap();
    let grade = "grade 04 --all-in class --course course.toml --seed 1 --report json=out.json --report text=out.txt";
    shell.dcel(grade).fine();
    let reports: Vec<Report> = serde_json::from_str(&shell.read("out.json")).unwrap();
    let words: Vec<String> = reports.iter().map(|report| report.terms.handed_in.as_ref().unwrap().words()).collect();
    assert_eq!(words[..2], ["in time, by the mark of the course system", "late, by the mark of the course system"]);
    assert!(words[2].starts_with("2026-10-13 00:59:00+02:00, by the time of the file, for want"), "{}", words[2]);
    let late = |i: usize| reports[i].terms.late.as_ref().map(|late| late.reason.as_str());
    assert_eq!(late(0), None);
    assert!(late(1).unwrap().contains("without a time") && late(2).unwrap().contains("late: 1 day"));

    // Gradescope: the date of this student, not that of all.
    let one = "grade 04 class/cara --course course.toml --seed 1";
    let metadata = |own: &str| {
        format!(
            r#"{{"created_at": "2026-10-13T12:00:00.5+02:00", "assignment": {{"due_date": "2026-10-12T23:59:00+02:00"}},
                "users": [{{"name": "Cara", "assignment": {{"due_date": "{own}"}}}}]}}"#
        )
    };
    for (own, late) in [("2026-10-12T23:59:00+02:00", true), ("2026-10-13T23:59:00+02:00", false)] {
        shell.write("m.json", &metadata(own));
        shell.dcel(&format!("{one} --metadata m.json --report gradescope=results.json --report json=one.json")).fine();
        let report: Report = serde_json::from_str(&shell.read("one.json")).unwrap();
        assert_eq!(report.terms.late.is_some(), late, "{own}");
        assert!(shell.read("results.json").contains("by the metadata of Gradescope"));
    }
}

#[test]
fn what_does_not_fit_the_course_is_named_before_anything_is_graded() {
    let shell = Folder::new();
    stored(&shell);
    shell.write("course.toml", COURSE);
    shell.write("wrong.toml", &COURSE.replace("7.5", "8.5"));
    shell.write("undue.toml", &COURSE.replace("due = ", "# "));
    shell.write("m.json", "{}");
    shell.write("times.csv", "submission,handed_in\nanna,yesterday\n");
    shell.write("nobody.csv", "submission,handed_in\nzoe,2026-10-12T21:59:00Z\n");
    for (more, error) in [
        ("--course missing.toml", "missing.toml"),
        ("--course wrong.toml", "wrong.toml:14:6: the points of the tests of 04-half-edge are 101 together, not 100"),
        ("--course undue.toml --times times.csv", "undue.toml: 04-half-edge has no due date"),
        ("--course course.toml --times times.csv", "times.csv: anna: \"yesterday\" is no time"),
        ("--course course.toml --times nobody.csv", "there is a time for `zoe`"),
        ("--course course.toml --metadata m.json", "m.json: it has no `created_at`"),
    ] {
        shell.dcel(&format!("grade 04 --from-report class.json {more}")).fails(2, error, "");
    }
    assert!(!shell.dcel("grade 04 --from-report class.json --times times.csv").err.is_empty());
}

#[test]
fn parts_of_a_class_put_together_are_the_class() {
    let shell = Folder::new();
    let refused = |number: usize| format!("use std::fs; // {number}\n");
    fs::create_dir(shell.path("class")).unwrap();
    for (i, name) in ["anna", "ben", "cara", "dora", "emil"].iter().enumerate() {
        // Dora has Anna's file: both are in one part, and each report names the other.
        shell.write(&format!("class/{name}.rs"), &refused(i % 3));
    }
    shell.write("names.csv", "submission,name\nanna,Anna\nzoe,Zoe\nben,Ben\ncara,Cara\ndora,Dora\nemil,Emil\n");
    let grade = "grade 04 --all-in class --names names.csv";
    shell.dcel(&format!("{grade} --seed 7 --results whole")).fine();
    shell.dcel(&format!("{grade} --shard 1/2 --results part")).fails(2, "need one seed", "--seed NUMBER");
    for part in 1..=3 {
        shell.dcel(&format!("{grade} --seed 7 --shard {part}/3 --results part{part}")).fine();
    }
    let graded = |part: &str| fs::read_dir(shell.path(&format!("{part}/reports"))).unwrap().count();
    assert_eq!([graded("part1"), graded("part2"), graded("part3")], [3, 2, 1], "Zoe, who is missing, is told once");
    shell.dcel("grade 04 --merge part3 part1 part2 --results together").fine();
    for file in ["class.html", "class.csv", "statistics.csv", "students/Anna.html", "students/Zoe.html"] {
        assert_eq!(shell.read(&format!("together/{file}")), shell.read(&format!("whole/{file}")), "{file}");
    }
    shell.dcel("grade 04 --merge part1 part3 --results t").fails(2, "part 2/3 is missing", "one for each part");
    shell.dcel("grade 04 --merge part1 part1 --results t").fails(2, "this is part 1, as part1 is", "");
    shell.dcel("grade 04 --merge whole --results t").fails(2, "whole/shard.json", "");
    fs::remove_file(shell.path("part2/reports/Ben.json")).unwrap();
    shell.dcel("grade 04 --merge part1 part2 part3").fails(2, "Ben: no part has a report", "goes on where it stopped");
    shell.dcel(&format!("{grade} --seed 8 --shard 2/3 --results part2")).fine();
    shell.dcel("grade 04 --merge part1 part2 part3").fails(2, "a part of another grading than part1", "");
    for wrong in ["0/3", "4/3", "x", "1"] {
        assert!(shell.dcel(&format!("{grade} --seed 7 --shard {wrong} --results p")).err.contains("write PART/PARTS"));
    }
}

/// The solution of lab 04 in the folder of a student.
fn solve(shell: &Folder, dir: &str) {
    let solution = concat!(env!("CARGO_MANIFEST_DIR"), "/../../labs/04-half-edge/solution/lab.rs");
    fs::copy(solution, shell.path(dir).join("src/lab.rs")).unwrap();
}

#[test]
fn progress_is_told_and_the_idea_comes_last() {
    let shell = Folder::empty();
    shell.write("course.toml", &COURSE.replace("most = 104", "secret = \"not/yours.toml\""));
    let told = shell.dcel("lab").fine();
    assert!(told.contains("Geometry, in ") && told.contains("- of 100  open"), "{told}");
    assert!(told.contains("due 2026-10-12 23:59:00+02:00"), "{told}");
    assert!(told.contains("Next: dcel lab start 04-half-edge 04-half-edge"), "{told}");
    shell.dcel("lab start 04 mine").fine();
    assert!(shell.dcel("lab").fine().contains("not checked yet"));
    let idea = shell.dcel("lab idea mine");
    assert!(idea.code == Some(1) && idea.out.starts_with("Not yet"), "{idea:?}");
    let told = shell.dcel("lab").fine();
    assert!(told.contains("0 of 100  begun") && told.contains("Next: 04-half-edge: task 1, "), "{told}");
    solve(&shell, "mine");
    let check = shell.dcel("lab check mine").fine();
    assert!(check.contains("100 of 100 points"), "{check}");
    let told = shell.dcel("lab").fine();
    assert!(told.contains("100 of 100  passed") && told.contains("100.0 %"), "{told}");
    assert!(shell.dcel("lab idea mine").fine().starts_with("# The idea of lab 04"));
    assert!(!shell.path("mine/idea.md").exists(), "nobody finds it in the folder");
    shell.write("course.toml", &COURSE.replace("most = 104", "idea = false"));
    shell.dcel("lab idea mine").fails(2, "course.toml: the course does not tell it", "ask your instructor");
    // The folder of another version.
    let toml = fs::read_to_string(shell.path("mine/lab.toml")).unwrap();
    shell.write("mine/lab.toml", &toml.replace("version = \"", "version = \"0.9-"));
    let err = shell.dcel("lab check mine --test face_walk").err;
    assert!(err.contains("lab.toml:4: this folder is of version 0.9-"), "{err}");
}

/// Cases that catch some mistakes, and one whose author is mistaken.
const OWN: &str = "case the outer face\nrectangle\nwalk_face f0\nexpect cycle h1 h11 h9 h7 h5 h3\n\
    case the inner face # in any order\nrectangle\nwalk_face f1\nexpect set h0 h2 h4 h6 h8 h10\n\
    case a split\nrectangle\nsplit_face h2 h8\nexpect true\nsplit_face h0 h0\nexpect false\n\
    case my mistake\nrectangle\ndestination h0\nexpect v0\n";

#[test]
fn own_tests_are_judged_by_the_solution_and_the_known_mistakes() {
    let shell = Folder::empty();
    let labs = concat!(env!("CARGO_MANIFEST_DIR"), "/../../labs");
    shell.dcel("lab start 04 mine").fine();
    shell.dcel("lab check mine --own").fails(2, "tests/own.txt", "expect ANSWER");
    shell.write("mine/tests/own.txt", OWN);
    let told = shell.dcel("lab check mine --own");
    assert!(told.code == Some(1) && told.out.contains("0 of 4 cases are answered as you expect"), "{told:?}");
    solve(&shell, "mine");
    let told = shell.dcel("lab check mine --own");
    assert!(told.out.contains("+ `the outer face`") && told.out.contains("3 of 4 cases"), "{told:?}");
    assert!(told.out.contains("- `my mistake`: line 18: expected v0, answered \"1\""), "{told:?}");

    // What the known mistakes are is never said; that the fourth case is wrong is.
    let course = COURSE.replace("most = 104", "own_tests = 6.9");
    shell.write("course.toml", &course);
    shell.dcel("grade 04 mine --course course.toml").fails(2, "6.9 points for own tests", "--own DIR");
    shell.dcel(&format!("grade 04 mine --course course.toml --own {labs} --report json=out.json")).fine();
    let report: Report = serde_json::from_str(&shell.read("out.json")).unwrap();
    let own = report.terms.own_tests.as_ref().unwrap();
    assert_eq!((own.cases, own.known, own.problems.len()), (3, Lab::bundled("04").unwrap().bugs.len(), 1));
    assert!((5..own.known / 2).contains(&own.caught), "{own:?}");
    assert!(own.problems[0].contains("`my mistake` does not count"), "{own:?}");
    assert_eq!(report.max_points().to_string(), "106.9");
    assert!(report.earned() > 100.into() && report.earned() < report.max_points(), "{:?}", report.earned());
}

#[test]
fn the_grades_of_all_labs_are_put_together() {
    let shell = Folder::new();
    stored(&shell);
    shell.write(
        "course.toml",
        &format!("{}\n[[lab]]\nname = \"02\"\n[[lab]]\nname = \"03\"\n", COURSE.replace("most = 104", "weight = 3")),
    );
    // A class of lab 02, as --results keeps it; cara handed nothing in.
    let lab = Lab::bundled("02").unwrap();
    fs::create_dir_all(shell.path("graded/reports")).unwrap();
    for (name, passed) in [("anna", lab.manifest.tests.len()), ("ben", 0)] {
        let mut report = Report::untested(&lab.manifest, Verdict::Wrong, "x");
        (report.message, report.submission) = (None, Some(name.to_owned()));
        for test in &mut report.tests[..passed] {
            (test.verdict, test.points) = (Verdict::Passed, test.max_points);
        }
        shell.write(&format!("graded/reports/{name}.json"), &serde_json::to_string(&report).unwrap());
    }
    let told = shell.dcel("gradebook --course course.toml class.json graded --csv grades.csv").fine();
    assert!(told.contains("Not graded yet, so it does not count: 03-convex-hulls"), "{told}");
    // All have 98 of 100 points in lab 04, which counts three times as much as lab 02.
    assert_eq!(
        shell.read("grades.csv"),
        "student,04-half-edge (of 100),02-triangulation (of 100),course (%)\nanna,98,100,98.50\nben,98,0,73.50\n\
         cara,98,0,73.50\n"
    );
    let help = "each student by one name in each";
    let twice = shell.dcel("gradebook --course course.toml class.json class.json --csv twice.csv");
    twice.fails(2, "two reports on anna of 04-half-edge: 98 and 98", help);
    assert!(!shell.path("twice.csv").exists());
    shell.write("other.toml", "title = \"x\"\n[[lab]]\nname = \"03\"\n");
    shell.dcel("gradebook --course other.toml graded").fails(2, "a report of 02-triangulation, which", help);
    shell.dcel("gradebook --course course.toml none").fails(2, "none: ", "--results DIR");
}

#[test]
fn a_lab_that_comes_after_another_says_so_until_that_has_passed() {
    let shell = Folder::empty();
    shell.write(
        "course.toml",
        "title = \"x\"\n[[lab]]\nname = \"02\"\n[[lab]]\nname = \"04\"\nneeds = [\"02-triangulation\"]\n",
    );
    const NOTE: &str = "note: in this course 04-half-edge comes after 02-triangulation, which has not passed here yet";
    let told = shell.dcel("lab start 04 four");
    assert!(told.code == Some(0) && told.err.contains(NOTE), "{told:?}");
    let told = shell.dcel("lab").fine();
    assert!(
        told.contains("opens after 02-triangulation") && told.contains("Next: dcel lab start 02-triangulation"),
        "{told}"
    );
    let two = shell.dcel("lab start 02 two");
    assert!(two.code == Some(0) && two.err.is_empty(), "{two:?}");
    let passed = r#"{"lab": "02-triangulation", "points": 100, "max_points": 100, "passed": true, "next": null}"#;
    fs::create_dir_all(shell.path("two/target/check")).unwrap();
    shell.write("two/target/check/progress.json", passed);
    let again = shell.dcel("lab start 04 again");
    assert!(again.code == Some(0) && !again.err.contains(NOTE), "{again:?}");
    assert!(!shell.dcel("lab").fine().contains("opens after"));
}
