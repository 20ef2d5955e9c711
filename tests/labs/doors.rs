//! One verdict everywhere: the same folder, judged by each way in which a student or an instructor has it judged.
//!
//! `cargo test` in the folder calls `check_folder` and nothing else (`tests/graded.rs`); that it does so in an archive
//! unpacked elsewhere is a step of `.ci/run`.

use super::commands::{solution, with_bug};
use crate::shell::Folder;
use dcel_lab::{Lab, Plan, Report, Verdict, Workbench, check_folder, graded};
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

/// What is put into the folder: paths and texts.
type Change = Vec<(&'static str, String)>;

/// Solution, starter, known mistakes, and what honest people do besides.
fn submissions() -> Vec<(&'static str, Change, Verdict)> {
    let lab = super::commands::lab();
    let given = |path: &str| lab.get(path).unwrap().to_owned();
    let solution_and = |more: &str| vec![("src/lab.rs", format!("{}\n{more}", solution()))];
    let calling = |call: &str| {
        solution().replacen(
            "pub fn drawing(pen: &mut Pen) {",
            &format!("pub fn drawing(pen: &mut Pen) {{\n    {call};"),
            1,
        )
    };
    assert!(calling("x()").contains("x()"), "the solution has a drawing");
    let bug = |number: u32| vec![("src/lab.rs", with_bug(number).0)];
    vec![
        ("solution", solution_and(""), Verdict::Passed),
        ("starter", Vec::new(), Verdict::Unattempted),
        ("known mistake 7", bug(7), Verdict::Wrong),
        ("known mistake 28", bug(28), Verdict::Wrong),
        ("known mistake 39", bug(39), Verdict::Wrong),
        (
            "own module beside lab.rs",
            vec![
                ("src/lab.rs", format!("use crate::helper;\n{}", calling("helper::nothing()"))),
                ("src/helper.rs", "pub fn nothing() {}\n".to_owned()),
                ("src/main.rs", given("src/main.rs").replace("mod lab;", "mod helper;\nmod lab;")),
            ],
            Verdict::DoesNotCompile,
        ),
        (
            "module of another file",
            vec![("src/lab.rs", format!("mod helper;\n{}", solution())), ("src/helper.rs", String::new())],
            Verdict::Refused,
        ),
        (
            "helper in a given file",
            vec![
                ("src/lab.rs", calling("crate::dcel::helper()")),
                ("src/dcel.rs", given("src/dcel.rs") + "\npub fn helper() {}\n"),
            ],
            Verdict::DoesNotCompile,
        ),
        (
            "given file changed, not used",
            vec![("src/lab.rs", solution()), ("src/dcel.rs", given("src/dcel.rs") + "\n// mine\n")],
            Verdict::Passed,
        ),
        ("std::env::var", vec![("src/lab.rs", calling("let _ = std::env::var(\"DEBUG\")"))], Verdict::Refused),
        (
            "cfg(test) tests",
            solution_and("#[cfg(test)]\nmod tests {\n    #[test]\n    fn mine() {}\n}\n"),
            Verdict::Passed,
        ),
        (
            "unused use",
            solution_and("#[allow(clippy::all)]\nmod unused {\n    use std::collections::BTreeMap;\n}\n"),
            Verdict::Passed,
        ),
    ]
}

/// Points of each test, by name: what a door says, but for words and times.
fn judged(report: &Report) -> (Verdict, Vec<(String, Verdict)>) {
    (report.verdict, report.tests.iter().map(|test| (test.name.clone(), test.verdict)).collect())
}

#[test]
fn every_door_gives_the_same_verdict() {
    let lab = Lab::bundled("04").unwrap();
    let shell = Folder::new();
    shell.dcel("lab start 04 given").fine();
    println!("{:30} {:17} {:17} {:17}", "submission", "cargo test", "dcel lab check", "dcel grade");
    let mut graded = Vec::new();
    let submissions = submissions();
    for (i, (_, change, _)) in submissions.iter().enumerate() {
        let folder = shell.path(&format!("class/{i:02}"));
        copy(&shell.path("given"), &folder);
        change.iter().for_each(|(path, text)| fs::write(folder.join(path), text).unwrap());
    }
    shell.dcel("grade 04 --all-in class --seed 4 --report json=class.json").fine();
    let reports: Vec<Report> = serde_json::from_str(&shell.read("class.json")).unwrap();
    assert_eq!(reports.len(), submissions.len());
    // As `dcel lab watch` does it: one after the other in the same place, where nothing of the one before may count.
    let mut bench = Workbench::new(&shell.path("bench"));
    for (i, ((name, change, expected), by_grade)) in submissions.iter().zip(&reports).enumerate() {
        let folder = shell.path(&format!("class/{i:02}"));
        let tested = check_folder(&lab, &folder, &shell.path("work"), &Plan::with_seed(4));
        let watched = bench.check(&lab, &folder, &Plan::with_seed(4));
        assert_eq!((judged(&watched.report), &watched.notes), (judged(&tested.report), &tested.notes), "{name}");
        let checked = shell.dcel(&format!("lab check class/{i:02} --seed 4 --all"));
        let by_check = if checked.out.contains("Everything passes. Hand it in.") {
            Verdict::Passed
        } else {
            *Verdict::ALL
                .iter()
                .filter(|verdict| match tested.report.message {
                    Some(_) => checked.out.contains(&format!("\n{verdict}: ")),
                    None => checked.out.lines().any(|line| line.starts_with("  ") && line.ends_with(verdict.word())),
                })
                .max()
                .unwrap_or_else(|| panic!("{name}: {checked:?}"))
        };
        println!("{name:30} {:17} {:17} {:17}", tested.report.verdict.word(), by_check.word(), by_grade.verdict.word());
        assert_eq!(checked.code, Some(i32::from(by_check != Verdict::Passed)), "{name}: {checked:?}");
        assert_eq!(judged(&tested.report), judged(by_grade), "{name}");
        assert_eq!((by_check, by_grade.verdict), (*expected, *expected), "{name}: {:?}", by_grade.message);
        // What is not handed in is said at the first check, each file of it, and nothing is said of honest folders.
        let others: Vec<&str> = change.iter().map(|(path, _)| *path).filter(|path| *path != "src/lab.rs").collect();
        assert_eq!(tested.notes.len(), others.len(), "{name}: {:?}", tested.notes);
        for path in others {
            let told = checked.err.lines().any(|line| line.starts_with("note: ") && line.contains(path));
            assert!(told && checked.err.contains("only src/lab.rs is handed in"), "{name}: {path}: {checked:?}");
        }
        graded.push(by_grade.points());
    }
    assert_eq!((graded[0], graded[1]), (100.into(), 0.into()));
    assert_eq!(fs::read_dir(shell.path("bench")).unwrap().count(), 1, "one place for all checks");
    drop(bench);
    assert_eq!(fs::read_dir(shell.path("bench")).unwrap().count(), 0, "and none afterwards");
}

/// What each test of `tests/graded.rs` calls. One check serves all of them.
#[test]
fn a_test_in_the_folder_fails_unless_it_is_passed() {
    let shell = Folder::new();
    shell.dcel("lab start 04 lab").fine();
    fs::write(shell.path("lab/src/lab.rs"), with_bug(28).0).unwrap();
    let (folder, work) = (shell.path("lab"), shell.path("work"));
    let by_check = check_folder(&Lab::bundled("04").unwrap(), &folder, &work, &Plan::with_seed(4)).report;
    let said = |test: &str| {
        let failure = std::panic::catch_unwind(|| graded("04-half-edge", &folder, &work, test)).err()?;
        Some(*failure.downcast::<String>().expect("words"))
    };
    let mut seen = BTreeSet::new();
    for test in &by_check.tests {
        let words = said(&test.name);
        assert_eq!(words.is_none(), test.verdict == Verdict::Passed, "{}: {words:?}", test.name);
        if let Some(words) = words {
            assert!(words.starts_with(&format!("\n\n{}: {}\n", test.name, test.verdict)), "{words}");
        }
        seen.insert(test.verdict);
    }
    assert!(seen.contains(&Verdict::Passed) && seen.contains(&Verdict::Wrong), "{seen:?}");
    assert!(said("no_test").is_some_and(|words| words.contains("no_test is no graded test of 04-half-edge")));
}

fn copy(from: &Path, to: &Path) {
    fs::create_dir_all(to).unwrap();
    for entry in fs::read_dir(from).unwrap().map(Result::unwrap) {
        let target = to.join(entry.file_name());
        // The sources of the kit are not looked at here.
        if entry.file_name() == "kit" {
            continue;
        }
        if entry.file_type().unwrap().is_dir() {
            copy(&entry.path(), &target);
        } else {
            fs::copy(entry.path(), &target).unwrap();
        }
    }
}

/// Whoever made the program may have gone, with the checkout and the crates: a check needs the compiler alone. And
/// what the machine lacks is no fault of the student's.
#[test]
fn a_fault_of_the_machine_is_not_the_students() {
    let shell = Folder::new();
    shell.dcel("lab start 04 lab").fine();
    fs::write(shell.path("lab/src/lab.rs"), solution()).unwrap();
    fs::remove_dir_all(shell.path("lab/kit")).unwrap();
    assert!(shell.dcel("lab check lab").fine().contains("100 of 100 points"));
    let without = |path: &str| {
        let out = shell.command("lab check lab").env("PATH", path).env_remove("RUSTC").output().unwrap();
        let (told, complaint) = (String::from_utf8(out.stdout).unwrap(), String::from_utf8(out.stderr).unwrap());
        assert_eq!((out.status.code(), told.as_str()), (Some(3), ""), "{complaint}");
        assert!(complaint.contains("your file is not to blame"), "{complaint}");
        assert!(!complaint.contains("src/lab.rs") && !complaint.contains("does not compile"), "{complaint}");
        complaint
    };
    // No compiler at all.
    assert!(without("").contains("rustc"));
    // A compiler without a linker.
    #[cfg(unix)]
    {
        let asked = std::process::Command::new("rustc").args(["--print", "sysroot"]).output().unwrap();
        let root = String::from_utf8(asked.stdout).unwrap();
        fs::create_dir(shell.path("bin")).unwrap();
        std::os::unix::fs::symlink(Path::new(root.trim()).join("bin/rustc"), shell.path("bin/rustc")).unwrap();
        assert!(without(shell.path("bin").to_str().unwrap()).contains("linker"));
    }
}
