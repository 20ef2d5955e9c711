//! Attacks while the compiler runs: reading what is not the student's into the program, or into an error message.
//!
//! With the scan switched off. Behind a barrier the compiler does not find the file. Where no barrier stands before it, it
//! does, and says so in its list of what it read; then the submission is refused.

use super::class::{Class, NONE, USER, behind_each};
use crate::trials::trials;
use dcel_lab::{GradeOptions, Hidden, Report, SandboxChoice, Verdict};
use std::fs::{self, File};
use std::os::fd::AsRawFd;
use std::os::unix::fs::PermissionsExt;
use std::path::{Path, PathBuf};

/// What stands in what is not to be read.
const MARK: &str = "written by somebody else";

/// Another student's right answer, in a folder that everybody may read.
struct Other {
    folder: tempfile::TempDir,
}

impl Other {
    fn under(place: &Path, class: &Class) -> Self {
        let folder = tempfile::tempdir_in(place).unwrap();
        fs::set_permissions(folder.path(), fs::Permissions::from_mode(0o755)).unwrap();
        let other = Self { folder };
        fs::create_dir_all(other.file().parent().unwrap()).unwrap();
        let solution = class.lab.files.get("solution/lab.rs").unwrap();
        fs::write(other.file(), format!("// {MARK}\n{solution}")).unwrap();
        fs::write(other.words(), format!("\"{MARK}\"")).unwrap();
        other
    }

    fn file(&self) -> PathBuf {
        self.folder.path().join("alice/src/lab.rs")
    }

    fn words(&self) -> PathBuf {
        self.folder.path().join("words")
    }
}

/// A whole file to hand in, and what it would read.
struct Attack {
    name: String,
    text: String,
    reads: String,
}

/// `file`: somebody else's answer; `words`: a text that is Rust as well; `open`: a number of an open file.
fn attacks(class: &Class, other: &Other, open: i32) -> Vec<Attack> {
    let (file, words) = (other.file().display().to_string(), other.words().display().to_string());
    let starter = class.lab.files.get("src/lab.rs").unwrap();
    let whole = |name: &str, text: String| Attack { name: name.to_owned(), text, reads: file.clone() };
    let added = |name: &str, reads: &str, items: &str| Attack {
        name: name.to_owned(),
        text: format!("{starter}\n{}\n", items.replace("FILE", reads)),
        reads: reads.to_owned(),
    };
    let grader = std::process::id();
    vec![
        whole(
            "attribute made by a macro",
            format!(
                "macro_rules! m {{ ($a:ident $p:literal $n:ident $s:tt) => {{ #[$a = $p] pub mod $n $s }} }}\nm!(path {file:?} stolen ;);\n"
            ),
        ),
        whole("path", format!("#[path = {file:?}] pub mod stolen;\n")),
        whole("path behind a condition", format!("#[cfg_attr(all(), path = {file:?})] pub mod stolen;\n")),
        whole("include", format!("mod stolen {{ include!({file:?}); }}\n")),
        added(
            "alias from the prelude",
            &file,
            "use std::prelude::v1::include_str as p; pub const S: &str = p!(\"FILE\");",
        ),
        added("alias", &file, "use include_str as p; pub const S: &str = p!(\"FILE\");"),
        added(
            "name as an argument",
            &file,
            "macro_rules! r { ($m:ident) => { $m!(\"FILE\") } } pub const S: &str = r!(include_str);",
        ),
        added("words of an error", &words, "compile_error!(include!(\"FILE\"));"),
        added(
            "words of an error before the compiler gives up",
            &words,
            "compile_error!(include!(\"FILE\")); macro_rules! more { ($($t:tt)*) => { more!($($t)* a); } } more!();",
        ),
        added("picture of an error", &file, "include!(\"FILE\"); pub const N: u8 = \"\";"),
        added("what does not parse", "/etc/passwd", "include!(\"FILE\");"),
        added("own environment", "/proc/self/environ", "pub const S: &[u8] = include_bytes!(\"FILE\");"),
        added(
            "the grader's environment",
            &format!("/proc/{grader}/environ"),
            "pub const S: &[u8] = include_bytes!(\"FILE\");",
        ),
        added(
            "the grader's open files",
            &format!("/proc/{grader}/fd/{open}"),
            "pub const S: &[u8] = include_bytes!(\"FILE\");",
        ),
        added("a variable", "HOME", "pub const S: Option<&str> = option_env!(\"FILE\");"),
        added("another variable", "PATH", "pub const S: &str = env!(\"FILE\");"),
        added("debugger", &file, "#[debugger_visualizer(natvis_file = \"FILE\")] pub mod seen {}"),
    ]
}

fn assert_nothing_won(attack: &Attack, report: &Report) {
    assert_eq!(report.points(), 0, "{} won something: {report:?}", attack.name);
    let said = serde_json::to_string(report).unwrap();
    assert!(!said.contains(MARK) && !said.contains("root:x:0"), "{}: {said}", attack.name);
}

fn with_choice(choice: SandboxChoice, places: &[&str]) {
    let class = Class::new();
    for (i, place) in places.iter().enumerate() {
        let place = if place.is_empty() { std::env::temp_dir() } else { PathBuf::from(place) };
        let other = Other::under(&place, &class);
        let held = File::open(other.words()).unwrap();
        let mut attacks = attacks(&class, &other, held.as_raw_fd());
        // Each attack at one of the places, so that all of them together take no longer.
        let mut place_of = (0..places.len()).cycle();
        attacks.retain(|_| place_of.next() == Some(i));
        if choice == USER {
            // The file system alone: what is open to everybody can be read, and is told.
            attacks.retain(|attack| !attack.reads.starts_with("/proc"));
        }
        let files: Vec<_> = attacks.iter().map(|attack| class.file(&attack.name, &attack.text)).collect();
        let options = GradeOptions { scan: false, sandbox: choice, ..class.options() };
        for (attack, report) in attacks.iter().zip(class.grade(&files, &options)) {
            assert_nothing_won(attack, &report);
            let message = report.message.clone().unwrap_or_default();
            let sandboxed = choice.namespaces || choice.own_files;
            let gave_up = attack.name.contains("gives up");
            let own = attack.reads.starts_with("/proc/self") || !attack.reads.starts_with('/');
            // A compiler that sees its own files only does not see what the system says of itself either.
            let own = own && !(choice.own_files && attack.reads.starts_with('/'));
            if (sandboxed && !own) || gave_up {
                let stopped = matches!(report.verdict, Verdict::DoesNotCompile | Verdict::Refused);
                assert!(stopped, "{}: {:?} {message}", attack.name, report.verdict);
            } else {
                assert_eq!(report.verdict, Verdict::Refused, "{}: {message}", attack.name);
                assert!(message.contains(&format!("`{}`", attack.reads)), "{}: {message}", attack.name);
            }
            if sandboxed && attack.reads == other.file().display().to_string() {
                assert_eq!(report.verdict, Verdict::DoesNotCompile, "{}: it was found: {message}", attack.name);
            }
        }
    }
    class.assert_nothing_is_left();
}

fn the_list_of_what_was_read_is_enough() {
    with_choice(NONE, &[""]);
}

fn a_user_of_its_own_and_the_list_under_opt() {
    with_choice(USER, &["/opt"]);
}

fn in_namespaces_under_opt_and_home() {
    with_choice(super::class::SPACES, &["/opt", "/home"]);
}

fn with_its_own_files_only_under_opt_and_home() {
    with_choice(super::class::FILES, &["/opt", "/home"]);
}

fn behind_all_walls_under_home() {
    with_choice(super::class::ALL, &["/home"]);
}

fn as_an_ordinary_user_grades() {
    with_choice(super::class::ORDINARY, &[""]);
}

fn as_an_ordinary_user_grades_without_namespaces() {
    with_choice(super::class::FILES, &[""]);
}

fn the_scan_refuses_all_of_them_at_their_line() {
    let class = Class::new();
    let other = Other::under(&std::env::temp_dir(), &class);
    let attacks = attacks(&class, &other, 0);
    let files: Vec<_> = attacks.iter().map(|attack| class.file(&attack.name, &attack.text)).collect();
    for (attack, report) in attacks.iter().zip(class.grade(&files, &class.options())) {
        assert_eq!(report.verdict, Verdict::Refused, "{}: {:?}", attack.name, report.message);
        let message = report.message.clone().unwrap_or_default();
        assert!(message.starts_with("src/lab.rs:"), "{}: {message}", attack.name);
        assert_nothing_won(attack, &report);
    }
}

/// A barrier that is said to stand before a folder stands; one that does not is not said to.
fn lines_are_true(choice: SandboxChoice) {
    let class = Class::new();
    let right = class.file("right", class.lab.files.get("solution/lab.rs").unwrap());
    let other = Other::under(&std::env::temp_dir(), &class);
    let hidden = vec![Hidden::new("the others", vec![other.folder.path().to_path_buf()])];
    let options = GradeOptions { sandbox: choice, hidden, ..class.options() };
    let report = class.grade(std::slice::from_ref(&right), &options).remove(0);
    assert_eq!(report.points(), 100, "{report:?}");
    let barrier = report.sandbox.iter().find(|barrier| barrier.name == "the others out of reach").unwrap();
    let sandboxed = choice.namespaces || choice.own_files;
    assert_eq!(barrier.missing.is_none(), sandboxed, "{barrier:?}");
    let said = serde_json::to_string(&report).unwrap();
    assert!(!said.contains(&*other.folder.path().to_string_lossy()), "a path for students: {said}");
}

behind_each! {
    lines(lines_are_true);
}

trials! {
    the_list_of_what_was_read_is_enough;
    a_user_of_its_own_and_the_list_under_opt: Root;
    in_namespaces_under_opt_and_home: Root, Namespaces;
    with_its_own_files_only_under_opt_and_home: Root, Landlock;
    behind_all_walls_under_home: Root, Namespaces, Landlock;
    as_an_ordinary_user_grades: Namespaces, Landlock;
    as_an_ordinary_user_grades_without_namespaces: Landlock;
    the_scan_refuses_all_of_them_at_their_line;
}
