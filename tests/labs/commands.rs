//! The commands of a lab, typed as a student and an instructor type them.

use crate::shell::Folder;
use crate::shell::watched::Watched;
use dcel_lab::{Bug, LabFiles, Report, Verdict};
use std::fs;
use std::path::Path;

/// A shell with the folder of a student of lab 04 in it, `lab`.
fn student() -> Folder {
    let shell = Folder::new();
    shell.dcel("lab start 04 lab").fine();
    shell
}

/// The lab with all that only a checkout has.
pub(crate) fn lab() -> LabFiles {
    LabFiles::read(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../../labs/04-half-edge")).unwrap()
}

pub(crate) fn solution() -> String {
    lab().get("solution/lab.rs").unwrap().to_owned()
}

/// The solution with the bug of this number.
pub(crate) fn with_bug(number: u32) -> (String, String) {
    let files = lab();
    let prefix = format!("bugs/{number:02}-");
    let (path, text) = files.iter().find(|(path, _)| path.starts_with(&prefix)).unwrap();
    let bug = Bug::parse(text, path).unwrap();
    (bug.apply(&solution()).unwrap(), bug.title)
}

#[test]
fn a_lab_is_found_by_number_and_a_wrong_name_says_which_there_are() {
    let shell = Folder::new();
    let list = shell.dcel("lab list").fine();
    let line = list.lines().find(|line| line.trim_start().starts_with("04-half-edge "));
    assert!(line.is_some_and(|line| line.contains("  100 points")), "{list}");
    let tasks = shell.dcel("lab list half-edge").fine();
    assert_eq!(tasks.matches("\ntask ").count(), 8, "{tasks}");
    shell.dcel("lab list 99").fails(2, "there is no lab `99`", "04-half-edge");
    shell.dcel("lab start x dir").fails(2, "there is no lab `x`", "04-half-edge");
}

#[test]
fn a_folder_is_made_once_and_holds_no_solution() {
    let shell = student();
    let lab = shell.path("lab");
    for file in ["README.md", "src/lab.rs", "src/main.rs", "tests/graded.rs", "Cargo.lock", "lab.toml", "answers.md"] {
        assert!(lab.join(file).is_file(), "{file}");
    }
    assert!(!lab.join("solution").exists() && !lab.join("bugs").exists());
    // Every figure that the handout shows is there.
    let handout = fs::read_to_string(lab.join("README.md")).unwrap();
    let figures: Vec<&str> = handout.split("](figures/").skip(1).map(|rest| &rest[..rest.find(')').unwrap()]).collect();
    assert!(figures.len() >= 5, "{figures:?}");
    for figure in figures {
        assert!(lab.join("figures").join(figure).is_file(), "{figure}");
    }
    shell.dcel("lab start 04 lab").fails(2, "is not empty", "does not exist yet");
    // The folders on the way are made, and go again where the lab cannot be put.
    shell.dcel("lab start 04 labs/of/mine").fine();
    assert!(shell.path("labs/of/mine/README.md").exists());
    shell.dcel("lab start 04 lab/README.md/of/mine").fails(3, "cannot be written", "");
    shell.dcel("lab start 04 lab/README.md").fails(2, "README.md", "does not exist yet");
    shell.dcel("lab check .").fails(2, "no lab is there", "dcel lab start");
}

#[test]
fn a_check_says_the_next_thing_to_do() {
    let shell = student();
    let told = shell.dcel("lab check lab --seed 4");
    assert_eq!(told.code, Some(1), "{told:?}");
    assert!(told.out.starts_with("04-half-edge: 0 of 100 points\n"), "{told:?}");
    assert!(told.out.contains("\nface_walk: unattempted\n"), "{told:?}");

    let file = shell.path("lab/src/lab.rs");
    let (text, title) = with_bug(30);
    fs::write(&file, text).unwrap();
    let told = shell.dcel("lab check lab --seed 4");
    assert_eq!(told.code, Some(1), "{told:?}");
    assert!(told.out.contains("\nsplit_face_4_faces: wrong\n"), "{told:?}");
    assert!(told.out.contains(&title), "{told:?}");
    assert!(told.out.contains("split_face_5_representatives   skipped"), "{told:?}");
    assert!(fs::read_to_string(shell.path("lab/target/check/report.html")).unwrap().contains("data:image/svg+xml,"));

    // Tasks may be left out: what is told is what was done, not what was not.
    let given = LabFiles::bundled("04").unwrap().get("src/lab.rs").unwrap().to_owned();
    fs::write(&file, given.replace("todo!(\"split_in_half\")", "")).unwrap();
    let told = shell.dcel("lab check lab --seed 4");
    assert!(told.out.contains("face_walk                      unattempted"), "{told:?}");
    assert!(told.out.contains("\nsplit_in_half_1_vertex: wrong\n"), "{told:?}");
    assert!(!told.out.contains("\nface_walk: unattempted\n"), "{told:?}");

    fs::write(&file, "fn broken( {}").unwrap();
    let told = shell.dcel("lab check lab");
    assert_eq!(told.code, Some(1), "{told:?}");
    assert!(told.out.contains("does not compile: src/lab.rs:1"), "{told:?}");

    fs::write(&file, solution()).unwrap();
    let out = shell.dcel("lab check lab").fine();
    assert!(out.contains("100 of 100 points") && out.contains("Hand it in."), "{out}");
    shell.dcel("lab check lab --test x").fails(2, "has no test `x`", "face_walk");
}

#[test]
fn a_watched_lab_is_checked_when_its_file_is_saved_and_only_then() {
    let shell = student();
    let watched = Watched::start(&shell, "lab watch lab --seed 4");
    assert!(watched.says("0 of 100 points", 120));
    assert!(watched.says("Ctrl-C ends it", 120));
    assert!(watched.is_silent("points", 2), "nothing was saved, yet it was checked again");
    // As many editors do it: a new file takes the place of the old one.
    fs::write(shell.path("lab/src/lab.rs.new"), solution()).unwrap();
    fs::rename(shell.path("lab/src/lab.rs.new"), shell.path("lab/src/lab.rs")).unwrap();
    assert!(watched.says("100 of 100 points", 120));
    assert!(watched.says("Ctrl-C ends it", 120));
    fs::write(shell.path("lab/src/lab.rs"), "fn broken( {}").unwrap();
    assert!(watched.says("does not compile", 120));
}

#[test]
fn hints_come_one_level_at_a_time() {
    let shell = student();
    let run = |arguments: &str| shell.dcel(&format!("lab hint --dir lab {arguments}"));
    let levels: Vec<String> = ["1", "2", "3"].map(|level| run(&format!("5 --level {level}")).fine()).into();
    assert!(levels.iter().all(|text| text.starts_with("Task 5: ")), "{levels:?}");
    assert!(levels[0].contains("--level 2") && levels[1].contains("--level 3") && !levels[2].contains("--level 4"));
    assert!(levels[0] != levels[1] && levels[1] != levels[2]);
    run("77").fails(2, "there is no task 77", "1 to 8");
}

#[test]
fn without_a_number_the_next_hint_of_the_task_at_hand_is_given() {
    let shell = student();
    let hint = || shell.dcel("lab hint --dir lab").fine();
    assert!(hint().contains("Nothing was checked yet") && hint().contains("A pointer"));
    // Tasks 1 and 2 are done, so the third is at hand.
    let text = solution().replacen("let twin = self.twin(h);\n        self.origin(twin)", "todo!()", 1);
    fs::write(shell.path("lab/src/lab.rs"), text).unwrap();
    assert_eq!(shell.dcel("lab check lab").code, Some(1));
    for heading in ["A nudge", "A pointer", "Nearly the code"] {
        let text = hint();
        assert!(text.starts_with("Task 3: ") && text.contains(heading), "{text}");
        assert!(text.contains("--level") && text.contains("--dir lab"), "{text}");
    }
    let text = hint();
    assert!(text.contains("no further hint") && text.contains("dcel lab hint 3 --level 3"), "{text}");
}

#[test]
fn a_reset_keeps_what_was_written() {
    let shell = student();
    let file = shell.path("lab/src/lab.rs");
    let given = fs::read_to_string(&file).unwrap();
    for i in [1, 2] {
        fs::write(&file, format!("// mine {i}\n")).unwrap();
        shell.dcel("lab reset lab").fine();
        assert_eq!(fs::read_to_string(&file).unwrap(), given);
        let kept = fs::read_to_string(shell.path(&format!("lab/src/lab.rs.{i}.bak"))).unwrap();
        assert_eq!(kept, format!("// mine {i}\n"));
    }
    assert!(shell.dcel("lab reset lab").fine().contains("Nothing to put back"));
}

#[test]
fn packed_labs_hold_what_they_should() {
    let shell = Folder::new();
    shell.dcel("lab export 04 --student lab.zip --kit version=9").fine();
    shell.dcel("lab export 04 --gradescope auto.zip --kit version=9").fine();
    let names = |file: &str| -> Vec<String> {
        let archive = zip::ZipArchive::new(fs::File::open(shell.path(file)).unwrap()).unwrap();
        archive.file_names().map(|name| name.unwrap().into_owned()).collect()
    };
    let files = names("lab.zip");
    assert!(files.contains(&"04-half-edge/src/lab.rs".to_owned()), "{files:?}");
    assert!(files.iter().all(|file| !file.contains("solution") && !file.contains("bugs")), "{files:?}");
    assert_eq!(names("auto.zip"), ["run_autograder", "setup.sh"]);
    shell.dcel("lab export 04 --gradescope auto").fails(2, "is a zip archive", ".zip");
    assert_eq!(shell.dcel("lab export 04").code, Some(2));
}

/// Three submissions: a right one, one with a bug, one that is no Rust; and one equal to the first.
fn class(shell: &Folder) {
    let dir = shell.path("class");
    fs::create_dir(&dir).unwrap();
    fs::write(dir.join("anna.rs"), solution()).unwrap();
    fs::write(dir.join("ben.rs"), with_bug(28).0).unwrap();
    fs::write(dir.join("cara.rs"), "this is no Rust\n").unwrap();
    fs::write(dir.join("dora.rs"), solution()).unwrap();
}

fn reports(path: &Path) -> Vec<Report> {
    serde_json::from_str(&fs::read_to_string(path).unwrap()).unwrap()
}

#[test]
fn a_class_is_graded_and_written_in_every_format() {
    let shell = Folder::new();
    class(&shell);
    let targets = ["json=class.json", "html=class.html", "csv=class.csv", "gradescope=gs/{submission}.json"];
    let targets = targets.map(|target| format!(" --report {target}")).concat();
    let out = shell.dcel(&format!("grade 04 --all-in class --seed 4{targets}")).fine();
    assert!(out.contains("anna") && out.contains("100/100"), "{out}");
    let graded = reports(&shell.path("class.json"));
    let verdicts: Vec<Verdict> = graded.iter().map(|report| report.verdict).collect();
    assert_eq!(verdicts, [Verdict::Passed, Verdict::Wrong, Verdict::DoesNotCompile, Verdict::Passed]);
    assert_eq!(graded.iter().map(Report::points).collect::<Vec<_>>()[0], 100);
    assert_eq!(graded[2].points(), 0);
    assert!(graded.iter().all(|report| report.seed == 4 && !report.sandbox.is_empty()));
    assert!(graded[1].tests.iter().any(|test| test.bugs.contains(&with_bug(28).1)));
    for name in ["anna", "ben", "cara", "dora"] {
        let text = fs::read_to_string(shell.path(&format!("gs/{name}.json"))).unwrap();
        serde_json::from_str::<serde_json::Value>(&text).unwrap();
    }

    // Grades without running anything again: names, lateness, somebody who is missing.
    fs::write(shell.path("names.csv"), "submission,name\nanna,Anna A.\nben,Ben B.\nemil,Emil E.\n").unwrap();
    fs::write(shell.path("late.csv"), "submission,points,reason\nben,-10,late\n").unwrap();
    let again = |arguments: &str| shell.dcel(&format!("grade 04 --from-report class.json {arguments}"));
    again("--names names.csv --adjust late.csv --report json=final.json").fine();
    let last = reports(&shell.path("final.json"));
    assert_eq!(last[0].submission.as_deref(), Some("Anna A."));
    assert_eq!(last[1].points(), graded[1].points() - 10.into());
    assert_eq!((last[4].submission.as_deref(), last[4].verdict), (Some("Emil E."), Verdict::Unattempted));

    assert_eq!(again("--fail-under 50").code, Some(1));
    again("--report gradescope=x.json").fails(2, "one submission", "");
    again("--adjust names.csv").fails(2, "names.csv", "submission,points,reason");
    shell.dcel("grade 04 nobody").fails(2, "nobody", "name a folder or a file");
}
