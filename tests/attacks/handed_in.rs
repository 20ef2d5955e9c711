//! Folders and files that are not what they should be.

use super::class::{Class, running};
use crate::trials::trials;
use dcel_lab::{GradeOptions, Grader, Limits, Outcome, Plan, Report, Submission, Verdict};
use std::os::unix::fs::symlink;
use std::path::PathBuf;

fn solution(class: &Class) -> String {
    class.lab.files.get("solution/lab.rs").unwrap().to_owned()
}

fn starter(class: &Class) -> String {
    class.lab.files.get("src/lab.rs").unwrap().to_owned()
}

fn message(report: &Report) -> &str {
    report.message.as_deref().unwrap_or_default()
}

fn only_the_students_file_is_taken() {
    let class = Class::new();
    let (right, todo) = (solution(&class), starter(&class));
    let forged = "fn main() { println!(\"done\"); }";
    let folders = [
        ("build script", vec![("src/lab.rs", &*todo), ("build.rs", "fn main() { panic!() }")]),
        (
            "settings of cargo",
            vec![
                ("src/lab.rs", &*todo),
                (".cargo/config.toml", "[build]\nrustc-wrapper = \"/bin/true\"\nrustflags = [\"--cap-lints=allow\"]\n"),
                ("rust-toolchain.toml", "[toolchain]\nchannel = \"nightly\"\n"),
            ],
        ),
        (
            "manifest",
            vec![
                ("src/lab.rs", &*todo),
                ("src/other.rs", forged),
                (
                    "Cargo.toml",
                    "[package]\nname = \"lab-04-half-edge\"\nversion = \"1.0.0\"\nautotests = false\n[[bin]]\nname = \"lab-04-half-edge\"\npath = \"src/other.rs\"\n",
                ),
            ],
        ),
        ("driver and tests", vec![("src/lab.rs", &*todo), ("src/main.rs", forged), ("tests/graded.rs", forged)]),
        ("the right one", vec![("src/lab.rs", &*right), ("src/main.rs", forged), ("answers.md", "Because.")]),
        ("file at the top", vec![("lab.rs", &*right)]),
        ("folder in a folder", vec![("my-lab/src/lab.rs", &*right), ("my-lab/target/x/src/lab.rs", &*todo)]),
        ("two of them", vec![("one/src/lab.rs", &*right), ("two/src/lab.rs", &*right)]),
        ("empty folder", vec![]),
    ];
    let places: Vec<PathBuf> = folders.iter().map(|(name, files)| class.folder(name, files)).collect();
    for ((name, _), report) in folders.iter().zip(class.grade(&places, &class.options())) {
        assert_eq!(report.submission.as_deref(), Some(*name));
        let expected = match *name {
            "the right one" | "file at the top" | "folder in a folder" => (Verdict::Passed, 100),
            "two of them" | "empty folder" => (Verdict::Refused, 0),
            _ => (Verdict::Unattempted, 0),
        };
        let verdicts: Vec<_> = report.tests.iter().map(|test| (&test.name, test.verdict, &test.message)).collect();
        assert_eq!((report.verdict, report.points().rounded()), expected, "{name}: {} {verdicts:?}", message(&report));
        if *name == "the right one" {
            assert_eq!(report.attachments, [("answers.md".to_owned(), "Because.".to_owned())]);
        }
    }
    class.assert_nothing_is_left();
}

fn files_of_every_kind_get_a_report() {
    let class = Class::new();
    let (right, todo) = (solution(&class), starter(&class));
    let link = class.folder("link", &[("src/main.rs", "")]);
    symlink(class.secret(), link.join("src/lab.rs")).unwrap();
    let linked_folder = class.folder("linked folder", &[]);
    symlink(class.secret().parent().unwrap(), linked_folder.join("src")).unwrap();
    let large = class.place("large.rs");
    std::fs::File::create(&large).unwrap().set_len(100 << 20).unwrap();
    let pipe = class.folder("pipe", &[("src/main.rs", "")]);
    assert!(std::process::Command::new("mkfifo").arg(pipe.join("src/lab.rs")).status().unwrap().success());
    let utf16: Vec<u8> = right.encode_utf16().flat_map(u16::to_le_bytes).collect();
    let deep = format!("{todo}\nfn deep() {{ {}{} }}\n", "(".repeat(100_000), ")".repeat(100_000));
    let cases = [
        (class.file("carriage returns", right.replace('\n', "\r\n")), Verdict::Passed, ""),
        (class.file("byte order mark", format!("\u{feff}{right}")), Verdict::Passed, ""),
        (class.file("right", &right), Verdict::Passed, ""),
        // Built at the same time, in another worker: its binary must not be taken for the other's.
        (class.file("starter", &todo), Verdict::Unattempted, ""),
        (class.file("right again", &right), Verdict::Passed, ""),
        (class.file("nothing", ""), Verdict::DoesNotCompile, "src/"),
        (class.file("binary", [0x7f, b'E', b'L', b'F', 0, 1, 2, 255]), Verdict::Refused, "not UTF-8"),
        (class.file("utf-16", utf16), Verdict::Refused, "not UTF-8"),
        (class.file("syntax", format!("{todo}\nfn f( {{")), Verdict::DoesNotCompile, "src/lab.rs:"),
        (class.file("types", todo.replace("todo!(\"destination\")", "\"no\"")), Verdict::DoesNotCompile, "src/lab.rs:"),
        (class.file("deep", deep), Verdict::Refused, "nested"),
        (large, Verdict::Refused, "104857600 bytes"),
        (link, Verdict::Refused, "a link"),
        (linked_folder, Verdict::Refused, "no src/lab.rs"),
        (pipe, Verdict::Refused, "a device"),
        (class.place("nobody"), Verdict::GraderFault, "nobody"),
    ];
    let places: Vec<PathBuf> = cases.iter().map(|(place, ..)| place.clone()).collect();
    for ((place, verdict, words), report) in cases.iter().zip(class.grade(&places, &class.options())) {
        let name = place.file_name().unwrap().to_string_lossy();
        let verdicts: Vec<_> = report.tests.iter().map(|test| (&test.name, test.verdict, &test.message)).collect();
        assert_eq!(report.verdict, *verdict, "{name}: {} {verdicts:?}", message(&report));
        assert!(message(&report).contains(words), "{name}: {}", message(&report));
        let points = if *verdict == Verdict::Passed { 100 } else { 0 };
        assert_eq!(report.points(), points, "{name}");
    }
    class.assert_nothing_is_left();
}

fn settings_above_the_rooms_are_a_fault_of_the_grader() {
    let class = Class::new();
    let right = class.file("right", solution(&class));
    let rooms = class.options().work_folders.unwrap();
    let settings = rooms.parent().unwrap().join(".cargo");
    std::fs::create_dir(&settings).unwrap();
    std::fs::write(settings.join("config.toml"), "").unwrap();
    // It strikes whatever is graded, so it is told once, and nobody gets a report.
    let grader = Grader::new(class.lab.clone(), &class.options()).unwrap();
    let submissions: Vec<Submission> = [&right, &right].map(|path| Submission::at(path)).into();
    let outcome = grader.grade_all(&submissions, &Plan::with_seed(4), |_, report| panic!("{report:?}"));
    let Outcome::Fault(why) = outcome else { panic!("{outcome:?}") };
    assert!(why.contains(".cargo"), "{why}");
    drop(grader);
    assert!(running(&rooms.to_string_lossy()).is_none());
}

fn a_build_has_a_deadline() {
    let class = Class::new();
    let right = class.file("right", solution(&class));
    let options = class.options();
    let options = GradeOptions { build: Limits { seconds: 0.02, ..options.build }, ..options };
    let report = class.grade(&[right], &options).remove(0);
    assert_eq!((report.verdict, report.points().rounded()), (Verdict::TimedOut, 0));
    assert!(message(&report).contains("did not finish"), "{}", message(&report));
    class.assert_nothing_is_left();
}

trials! {
    only_the_students_file_is_taken;
    files_of_every_kind_get_a_report;
    settings_above_the_rooms_are_a_fault_of_the_grader;
    a_build_has_a_deadline;
}
