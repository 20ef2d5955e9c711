//! A class as it comes out of a course system: names, archives, lists, and what is done when it is interrupted.

use crate::shell::Folder;
use dcel_lab::{LabFiles, Report, Verdict};
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

fn given() -> String {
    LabFiles::bundled("04").unwrap().get("src/lab.rs").unwrap().to_owned()
}

/// A file of its own that is refused at once: quick to grade, and told by its number.
fn refused(number: usize) -> String {
    format!("use std::fs; // {number}\n")
}

fn write(path: impl AsRef<Path>, text: impl AsRef<[u8]>) {
    fs::create_dir_all(path.as_ref().parent().unwrap()).unwrap();
    fs::write(path, text).unwrap();
}

fn zipped(files: &[(&str, &[u8])]) -> Vec<u8> {
    let mut zip = zip::ZipWriter::new(std::io::Cursor::new(Vec::new()));
    for (name, bytes) in files {
        zip.start_file(*name, zip::write::SimpleFileOptions::default()).unwrap();
        zip.write_all(bytes).unwrap();
    }
    zip.finish().unwrap().into_inner()
}

/// A `.tar.gz` of a folder, made as students make it.
fn tarred(folder: &Path) -> Vec<u8> {
    let out = std::process::Command::new("tar").arg("czf").arg("-").arg("-C").arg(folder).arg(".").output().unwrap();
    assert!(out.status.success());
    out.stdout
}

fn reports(path: &Path) -> Vec<Report> {
    serde_json::from_str(&fs::read_to_string(path).unwrap()).unwrap()
}

/// Name, verdict, and what is said of the whole and noted, of every row.
fn rows(shell: &Folder, arguments: &str) -> Vec<(String, Verdict, String)> {
    shell.dcel(&format!("grade 04 {arguments} --seed 4 --report json=class.json")).fine();
    let row = |report: Report| {
        let words = format!("{} {}", report.message.unwrap_or_default(), report.notes.join("; "));
        (report.submission.unwrap(), report.verdict, words)
    };
    reports(&shell.path("class.json")).into_iter().map(row).collect()
}

fn names(rows: &[(String, Verdict, String)]) -> Vec<&str> {
    rows.iter().map(|(name, ..)| name.as_str()).collect()
}

#[test]
fn rows_have_names_that_differ() {
    let shell = Folder::new();
    for (i, path) in ["fall/anna/src/lab.rs", "spring/anna/lab.rs", "ben/lab.rs", "cara.rs", "x/cara.rs", "cara/lab.rs"]
        .iter()
        .enumerate()
    {
        write(shell.path(path), refused(i));
    }
    let paths = "fall/anna/src/lab.rs spring/anna ben/lab.rs cara.rs x/cara.rs cara ben/lab.rs";
    let rows = rows(&shell, paths);
    let names = names(&rows);
    assert_eq!(
        names[..3],
        ["fall/anna", "spring/anna", "ben/lab.rs"].map(|name| if name == "ben/lab.rs" { names[2] } else { name })
    );
    let mut different = names.clone();
    different.sort_unstable();
    different.dedup();
    assert_eq!(different.len(), 7, "{names:?}");
    assert!(names[2].contains("ben") && names[6].contains("ben") && names[4].contains("x/cara"), "{names:?}");
}

#[test]
fn names_of_course_systems_are_read() {
    let shell = Folder::new();
    for (i, path) in [
        "arndtanna_4711_90210_lab-1.rs",
        "arndtanna_4711_90211_answers.md",
        "bachben_LATE_4712_90212_lab.rs",
        "cohncara_4713_90213_lab.rs",
        "cohncara_4714_90214_lab.rs",
        "Dora Dietz_4715_assignsubmission_file_/lab.rs",
        "Emil Ernst_4716_assignsubmission_file_lab.rs",
        "Emil Ernst_4716_assignsubmission_onlinetext_x.html",
        "final_2024_01_lab.rs",
    ]
    .iter()
    .enumerate()
    {
        write(shell.path("class").join(path), refused(i));
    }
    let rows = rows(&shell, "--all-in class");
    let expected =
        ["Dora Dietz", "Emil Ernst", "arndtanna", "bachben", "cohncara 4713", "cohncara 4714", "final_2024_01_lab"];
    assert_eq!(names(&rows), expected);
    assert!(rows[2].2.contains("`lab-1.rs` was taken"), "{rows:?}");
    assert!(rows[3].2.contains("late"), "{rows:?}");
    assert!(rows.iter().all(|(_, verdict, _)| *verdict == Verdict::Refused), "{rows:?}");
    let first = &reports(&shell.path("class.json"))[2];
    assert_eq!(
        first.message.as_deref().map(|m| m.contains("std::fs")),
        Some(true),
        "the lab's file was read: {first:?}"
    );

    // A list may name people by the number that the course system gave.
    fs::write(shell.path("names.csv"), "submission,name\n4711,Anna Arndt\n4712,Ben Bach\n").unwrap();
    let told = shell.dcel("grade 04 --all-in class --seed 4 --names names.csv");
    assert!(
        told.out.contains("Anna Arndt") && told.out.contains("Ben Bach") && !told.out.contains("bachben"),
        "{told:?}"
    );
}

#[test]
fn a_folder_of_another_lab_or_version_is_noted_with_its_place() {
    let shell = Folder::new();
    let own = LabFiles::bundled("04").unwrap().get("lab.toml").unwrap().to_owned();
    for (i, (name, manifest)) in [
        ("own", own.clone()),
        ("old", own.replace("version = \"", "version = \"0.")),
        ("other", LabFiles::bundled("09").unwrap().get("lab.toml").unwrap().to_owned()),
    ]
    .into_iter()
    .enumerate()
    {
        write(shell.path(name).join("src/lab.rs"), refused(i));
        write(shell.path(name).join("lab.toml"), manifest);
    }
    let rows = rows(&shell, "own old other");
    assert!(!rows[0].2.contains("this folder"), "{rows:?}");
    assert!(rows[1].2.contains("lab.toml:4: this folder is of version 0."), "{rows:?}");
    assert!(rows[2].2.contains("lab.toml:2: this folder is of 09-two-primitives, not of 04-half-edge"), "{rows:?}");
}

#[test]
fn archives_are_looked_into_and_nothing_else() {
    let shell = Folder::new();
    let todo = given();
    let lab = todo.as_bytes();
    let class = shell.path("class");
    write(
        class.join("anna.zip"),
        zipped(&[("my-lab/src/lab.rs", lab), ("my-lab/answers.md", b"x"), ("my-lab/target/a/src/lab.rs", b"no")]),
    );
    write(shell.path("tree/lab04/src/lab.rs"), lab);
    write(class.join("ben.tar.gz"), tarred(&shell.path("tree")));
    write(class.join("cara/hand-in.zip"), zipped(&[("lab.rs", lab)]));
    write(class.join("dora.zip"), zipped(&[("../../lab.rs", lab)]));
    let inner = zipped(&[("lab.rs", lab)]);
    write(class.join("emil.zip"), zipped(&[("inner.zip", &inner)]));
    write(class.join("finn.rar"), b"Rar!");
    write(class.join("gina.zip"), b"PK no zip at all");
    write(class.join("hans.zip"), zipped(&[("lab.rs", &vec![b' '; 3 << 20])]));
    write(class.join("ida.zip"), zipped(&[("a/src/lab.rs", lab), ("b/src/lab.rs", lab)]));
    write(class.join("jan.tar.gz"), &tarred(&shell.path("tree"))[..100]);
    write(class.join("kim.zip"), zipped(&[("src/Lab.rs", lab)]));
    write(class.join("lea.zip"), zipped(&[("C:\\lab.rs", lab)]));
    let many: Vec<(String, &[u8])> = (0..400).map(|i| (format!("{i}/lab.rs"), &[b' '; 60_000][..])).collect();
    write(class.join("max.zip"), zipped(&many.iter().map(|(name, bytes)| (name.as_str(), *bytes)).collect::<Vec<_>>()));
    std::os::unix::fs::symlink("/etc/passwd", shell.path("tree/lab04/src/lab.rs.x")).unwrap();
    fs::remove_file(shell.path("tree/lab04/src/lab.rs")).unwrap();
    std::os::unix::fs::symlink("/etc/passwd", shell.path("tree/lab04/src/lab.rs")).unwrap();
    write(class.join("nils.tgz"), tarred(&shell.path("tree")));
    let rows = rows(&shell, "--all-in class");
    let expected = [
        ("anna", Verdict::Unattempted, ""),
        ("ben", Verdict::Unattempted, ""),
        ("cara", Verdict::Unattempted, ""),
        ("dora", Verdict::Refused, "`../../lab.rs` lies outside"),
        ("emil", Verdict::Refused, "`inner.zip` is not opened"),
        ("finn", Verdict::Refused, "a .zip or a .tar.gz"),
        ("gina", Verdict::Refused, "no whole zip"),
        ("hans", Verdict::Refused, "3145728 bytes"),
        ("ida", Verdict::Refused, "several src/lab.rs: a/src/lab.rs and b/src/lab.rs"),
        ("jan", Verdict::Refused, "no whole tar"),
        ("kim", Verdict::Unattempted, "`src/Lab.rs` was taken"),
        ("lea", Verdict::Refused, "lies outside"),
        ("max", Verdict::Refused, "more of such files"),
        ("nils", Verdict::Refused, "a link"),
    ];
    assert_eq!(names(&rows), expected.map(|(name, ..)| name));
    for ((name, verdict, words), (_, expected, said)) in rows.iter().zip(expected) {
        assert_eq!(*verdict, expected, "{name}: {words}");
        assert!(words.contains(said), "{name}: {words}");
    }
    assert!(!shell.path("lab.rs").exists() && !class.join("lab.rs").exists(), "nothing is unpacked");
    assert_eq!(reports(&shell.path("class.json"))[0].attachments, [("answers.md".to_owned(), "x".to_owned())]);
}

#[test]
fn the_archive_of_a_class_is_a_class() {
    let shell = Folder::new();
    let todo = given();
    let inner = zipped(&[("my-lab/src/lab.rs", todo.as_bytes())]);
    let files: [(&str, &[u8]); 6] = [
        ("Lab 4/Anna Arndt_4711_assignsubmission_file_/lab.rs", todo.as_bytes()),
        ("Lab 4/Ben Bach_4712_assignsubmission_file_/hand in.zip", &inner),
        ("Lab 4/Cara Cohn_4713_assignsubmission_file_/notes.txt", b"I could not"),
        ("Lab 4/dietzdora_4714_90210_lab-2.rs", b"use std::fs;"),
        ("Lab 4/Emil Ernst_4715_assignsubmission_file_/my solution.rs", b"use std::net;"),
        ("Lab 4/dietzdora_4714_90211_answers.md", b"because"),
    ];
    write(shell.path("class.zip"), zipped(&files));
    let rows = rows(&shell, "--all-in class.zip");
    assert_eq!(names(&rows), ["Anna Arndt", "Ben Bach", "Cara Cohn", "Emil Ernst", "dietzdora"]);
    let verdicts: Vec<Verdict> = rows.iter().map(|(_, verdict, _)| *verdict).collect();
    use Verdict::{Refused, Unattempted};
    assert_eq!(verdicts, [Unattempted, Unattempted, Refused, Refused, Refused], "{rows:?}");
    assert!(rows[2].2.contains("no src/lab.rs") && rows[4].2.contains("std::fs"), "{rows:?}");
    assert!(rows[3].2.contains("std::net") && rows[3].2.contains("`my solution.rs` was taken"), "{rows:?}");
    write(shell.path("empty.zip"), zipped(&[]));
    shell.dcel("grade 04 --all-in empty.zip").fails(2, "is empty", "");
    shell.dcel("grade 04 --all-in square.obj").fails(2, "square.obj", ".zip");
}

#[cfg(unix)]
#[test]
fn a_link_to_anothers_folder_is_said_and_not_followed() {
    let shell = Folder::new();
    write(shell.path("class/anna/src/lab.rs"), given());
    std::os::unix::fs::symlink("anna", shell.path("class/ben")).unwrap();
    std::os::unix::fs::symlink("/etc/hostname", shell.path("class/cara.rs")).unwrap();
    let of_class = rows(&shell, "--all-in class");
    assert_eq!(names(&of_class), ["anna", "ben", "cara"]);
    assert!(of_class[1].1 == Verdict::Refused && of_class[1].2.contains("a link to anna"), "{of_class:?}");
    assert!(of_class[2].1 == Verdict::Refused && of_class[2].2.contains("a link to /etc/hostname"), "{of_class:?}");
    let named = rows(&shell, "class/anna class/ben");
    assert_eq!(names(&named), ["anna", "ben"]);
    assert!(named[1].1 == Verdict::Unattempted && named[1].2.contains("a link to anna"), "{named:?}");
}

#[test]
fn everything_is_checked_before_the_first_one_is_graded() {
    let shell = Folder::new();
    write(shell.path("class/anna.rs"), given());
    write(shell.path("class/ben.rs"), refused(1));
    for (name, text) in [
        ("twice.csv", "submission,name\nanna,A\nanna,B\n"),
        ("nobody.csv", "submission,points,reason\nzoe,-1,late\n"),
        ("words.csv", "submission,points,reason\nanna,many,late\n"),
    ] {
        shell.write(name, text);
    }
    for (arguments, code, error) in [
        ("--names twice.csv", 2, "`anna` twice"),
        ("--adjust nobody.csv", 2, "`zoe`"),
        ("--adjust words.csv", 2, "words.csv"),
        ("--adjust missing.csv", 2, "missing.csv"),
        ("--report gradescope=all.json", 2, "holds one submission"),
        ("--report csv=a.csv --report html=a.csv", 2, "two reports"),
        ("--report csv=class", 2, "is a directory"),
        ("--report csv=nobody.csv --adjust nobody.csv", 2, ""),
        ("--report csv=class/table.csv", 2, "among the submissions"),
        ("--results class/out", 2, "among the submissions"),
        ("--report csv=square.obj/x.csv", 3, "square.obj"),
        ("--results square.obj", 3, "square.obj"),
        ("--secret missing.toml", 2, "missing.toml"),
    ] {
        let begin = std::time::Instant::now();
        shell.dcel(&format!("grade 04 --all-in class {arguments}")).fails(code, error, "");
        // Nothing was written, so nothing was graded.
        for file in ["all.json", "a.csv", "class/table.csv", "class/out"] {
            assert!(!shell.path(file).exists(), "{arguments}: {file} after {:?}", begin.elapsed());
        }
    }
    assert_eq!(shell.read("nobody.csv"), "submission,points,reason\nzoe,-1,late\n");
}

#[test]
fn a_fault_that_strikes_everybody_is_an_error_and_no_class_of_zeros() {
    let shell = Folder::new();
    for name in ["anna", "ben", "cara"] {
        write(shell.path(&format!("class/{name}.rs")), format!("{}// {name}\n", given()));
    }
    shell.write("class.csv", "as it was");
    for more in ["", "--results out"] {
        let mut command = shell.command(&format!("grade 04 --all-in class --report csv=class.csv {more}"));
        let told = command.env("RUSTC", "no-such-compiler").output().unwrap();
        let err = String::from_utf8_lossy(&told.stderr);
        assert_eq!(told.status.code(), Some(3), "{err}");
        assert!(err.contains("error: the grader fails whatever it is given: no-such-compiler"), "{err}");
        assert!(told.stdout.is_empty(), "no points: {}", String::from_utf8_lossy(&told.stdout));
        assert_eq!(shell.read("class.csv"), "as it was");
    }
    assert_eq!(fs::read_dir(shell.path("out/reports")).unwrap().count(), 0);
    // One who is refused before anything is built has a verdict all the same.
    write(shell.path("class/a.rs"), refused(1));
    let mut command = shell.command("grade 04 --all-in class --report csv=class.csv --workers 1");
    let told = command.env("RUSTC", "no-such-compiler").output().unwrap();
    assert_eq!(told.status.code(), Some(3));
    let table = shell.read("class.csv");
    assert!(table.contains("\na,refused,0,") && !table.contains("anna"), "{table}");
}

#[test]
fn results_are_kept_and_only_what_has_changed_is_graded_again() {
    let shell = Folder::new();
    write(shell.path("class/anna.rs"), given());
    write(shell.path("class/ben.rs"), format!("{}\nconst X: u8 = \"\";\n", given()));
    let run = |more: &str| shell.dcel(&format!("grade 04 --all-in class --results out {more}"));
    let report =
        |name: &str| -> Report { serde_json::from_str(&shell.read(&format!("out/reports/{name}.json"))).unwrap() };
    run("").fine();
    let (anna, ben) = (report("anna"), report("ben"));
    assert_eq!((anna.verdict, ben.verdict), (Verdict::Unattempted, Verdict::DoesNotCompile));
    for file in ["class.html", "class.csv", "students/anna.html", "students/ben.html"] {
        assert!(shell.path("out").join(file).is_file(), "{file}");
    }
    assert!(shell.read("out/class.html").contains("href=\"students/anna.html\""));
    let kept = || fs::read_dir(shell.path("out/.kept")).unwrap().count();
    assert_eq!(kept(), 3, "two reports and the seed");

    // The second call has the seed of the first, and finds both.
    run("").fine();
    assert_eq!((report("anna").seed, kept()), (anna.seed, 3));
    assert_eq!(Report { millis: 0, ..report("anna") }, Report { millis: 0, ..anna.clone() });
    // A new one is graded, a changed one too; another seed asks all again.
    write(shell.path("class/ben.rs"), refused(1));
    write(shell.path("class/cara.rs"), refused(2));
    run("").fine();
    assert_eq!((report("ben").verdict, report("cara").verdict, kept()), (Verdict::Refused, Verdict::Refused, 5));
    run("--seed 5").fine();
    assert_eq!((report("anna").seed, kept()), (5, 8));
    // Half a report is passed over, with a note.
    for entry in fs::read_dir(shell.path("out/.kept")).unwrap().flatten() {
        if entry.file_name() != "seed" {
            fs::write(entry.path(), "{\"key\":").unwrap();
        }
    }
    let told = run("");
    assert!(told.err.contains("note: ") && told.err.contains("graded anew"), "{told:?}");
    assert_eq!(report("ben").verdict, Verdict::Refused);

    // From the folder, without running anything; points once given are not given again.
    shell.write("late.csv", "submission,points,reason\nanna,7,answers\n");
    run("--adjust late.csv").fine();
    assert_eq!(report("anna").points(), 7);
    let told = shell.dcel("grade 04 --from-report out --adjust late.csv --report csv=again.csv");
    assert!(told.code == Some(0) && told.err.contains("not counted twice"), "{told:?}");
    assert!(shell.read("again.csv").contains("\nanna,unattempted,7,"), "{}", shell.read("again.csv"));
    fs::remove_file(shell.path("class/cara.rs")).unwrap();
    assert!(run("").err.contains("cara.json: of a submission that is not there any more"));
}

#[cfg(unix)]
mod interrupted {
    use super::*;
    use std::process::{Child, Command, Stdio};
    use std::time::{Duration, Instant};

    /// A call that grades with its temporary files in `tmp`, in a group of its own.
    fn start(shell: &Folder, arguments: &str) -> Child {
        let tmp = shell.path("tmp");
        fs::create_dir_all(&tmp).unwrap();
        let mut command = Command::new(env!("CARGO_BIN_EXE_dcel"));
        command.args(arguments.split_whitespace()).current_dir(shell.path("")).env("TMPDIR", &tmp);
        command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap()
    }

    fn wait_for(what: impl Fn() -> bool) {
        let begin = Instant::now();
        while !what() {
            assert!(begin.elapsed() < Duration::from_secs(120), "it did not come");
            std::thread::sleep(Duration::from_millis(5));
        }
    }

    fn rooms(shell: &Folder) -> Vec<PathBuf> {
        // Where the place for temporary files is closed to other users, the rooms are elsewhere.
        fs::read_dir(shell.path("tmp")).unwrap().flatten().map(|entry| entry.path()).collect()
    }

    #[test]
    fn a_class_that_is_interrupted_goes_on_where_it_stopped() {
        for (signal, code) in [("INT", 130), ("TERM", 143)] {
            let shell = Folder::new();
            // The first ones are quick; the last one never ends by itself within the deadline of a test.
            for i in 0..6 {
                write(shell.path(&format!("class/a{i}.rs")), refused(i));
            }
            let sleeper = given()
                .replace("todo!(\"destination\")", "std::thread::sleep(std::time::Duration::from_secs(100)); todo!()");
            write(
                shell.path("class/b.rs"),
                sleeper.replace(
                    "todo!(\"incident_half_edges\")",
                    "loop { std::thread::sleep(std::time::Duration::from_secs(1)) }",
                ),
            );
            write(shell.path("class/c.rs"), refused(9));
            let call = "grade 04 --all-in class --results out --workers 1 --report csv=table.csv";
            let child = start(&shell, call);
            wait_for(|| shell.path("out/reports/a5.json").exists());
            // It is at the one that does not end.
            std::thread::sleep(Duration::from_millis(700));
            let begin = Instant::now();
            let pid = child.id().to_string();
            assert!(Command::new("kill").args(["-s", signal, &pid]).status().unwrap().success());
            let told = child.wait_with_output().unwrap();
            let err = String::from_utf8_lossy(&told.stderr);
            assert_eq!(told.status.code(), Some(code), "{err}");
            assert!(begin.elapsed() < Duration::from_secs(4), "{:?}", begin.elapsed());
            assert!(err.contains("6 of 8 graded") && err.contains("goes on where it stopped"), "{err}");
            assert!(rooms(&shell).is_empty(), "{signal}: {:?}", rooms(&shell));
            // What is done is whole, and nothing says that there is more.
            for i in 0..6 {
                let report: Report = serde_json::from_str(&shell.read(&format!("out/reports/a{i}.json"))).unwrap();
                assert_eq!(report.verdict, Verdict::Refused);
            }
            for table in ["out/class.csv", "table.csv"] {
                let text = shell.read(table);
                assert_eq!(
                    csv::Reader::from_reader(text.as_bytes()).records().map(Result::unwrap).count(),
                    6,
                    "{text}"
                );
            }
            assert!(shell.read("out/class.html").contains("6 of 8 submissions"));
            for name in ["b", "c"] {
                assert!(!shell.path(&format!("out/reports/{name}.json")).exists(), "{name}");
            }
            let hidden = |folder: &str| {
                let names = fs::read_dir(shell.path(folder)).unwrap().flatten().map(|entry| entry.file_name());
                names.filter(|name| name.to_string_lossy().starts_with('.') && name != ".kept").count()
            };
            assert_eq!(
                [hidden("out"), hidden("out/reports"), hidden("out/students"), hidden("out/.kept"), hidden(".")],
                [0; 5]
            );

            // The one that stood in the way is replaced; the six are not graded again: their entries stay as they are.
            let kept = || {
                let entries = fs::read_dir(shell.path("out/.kept")).unwrap().flatten();
                let mut times: Vec<_> =
                    entries.map(|entry| (entry.file_name(), entry.metadata().unwrap().modified().unwrap())).collect();
                times.sort();
                times
            };
            let before = kept();
            assert_eq!(before.len(), 7, "six reports and the seed");
            write(shell.path("class/b.rs"), refused(8));
            shell.dcel(call).fine();
            assert!(before.iter().all(|entry| kept().contains(entry)), "graded again");
            assert_eq!(kept().len(), 9);
            assert!(shell.read("out/class.html").contains("8 of 8 submissions"));
        }
    }
}
