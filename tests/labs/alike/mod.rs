//! Which submissions are said to look alike: copies in disguise are, honest solutions of one task are not.

use crate::shell::Folder;
use dcel_lab::{LabFiles, Report, Similar};
use std::fmt::Write;
use std::fs;

/// Five answers to lab 04 that were written apart from each other, by task.
const HONEST: [(&str, &str); 5] = [
    ("one", include_str!("one.txt")),
    ("two", include_str!("two.txt")),
    ("three", include_str!("three.txt")),
    ("four", include_str!("four.txt")),
    ("five", include_str!("five.txt")),
];

fn given() -> String {
    LabFiles::bundled("04").unwrap().get("src/lab.rs").unwrap().to_owned()
}

fn solution() -> String {
    let text = crate::commands::lab().get("solution/lab.rs").unwrap().to_owned();
    // As a student's file looks: nothing of how the lab is made.
    text.lines().filter(|line| !line.contains("// STARTER:") && !line.contains("SOLUTION")).fold(
        String::new(),
        |mut text, line| {
            let _ = writeln!(text, "{line}");
            text
        },
    )
}

/// The given file with answers in the place of `todo!(…)`.
fn filled(answers: &str) -> String {
    let mut text = given();
    for answer in format!("\n{answers}").split("\n== ").skip(1) {
        let (task, code) = answer.split_once('\n').unwrap();
        let todo = format!("todo!(\"{task}\")");
        let end = text.find(&todo).unwrap() + todo.len();
        let begin = text[..end].rfind("let _ = ").unwrap();
        text.replace_range(begin..end, code);
    }
    text
}

/// The same program to the eye of a thief: other names, no comments, functions in another order, other layout.
fn disguised(text: &str) -> String {
    let plain: Vec<&str> = text.lines().filter(|line| !line.trim_start().starts_with("//")).map(str::trim).collect();
    let mut text = plain.join("\n");
    let names = [
        ("first", "s0"),
        ("half_edges", "half_edges"),
        ("spoke", "cur"),
        ("star", "res"),
        ("before1", "q1"),
        ("before2", "q2"),
        ("new_face", "new_face"),
        ("there", "aa"),
        ("back", "bb"),
        ("middle", "mm"),
        ("corner", "pick"),
        ("line", "line"),
        ("halve", "cut"),
        ("sky", "r1"),
        ("sea", "r2"),
        ("west", "r3"),
        ("sail", "r4"),
        ("hull", "r5"),
        ("incoming", "inc"),
        ("corners", "ps"),
        ("after", "nn"),
        ("before", "pp"),
        ("end", "zz"),
    ];
    for (from, to) in names {
        text = renamed(&text, from, to);
    }
    // The second block of functions first.
    let (head, rest) = text.split_once("impl Dcel {").unwrap();
    let (walks, rest) = rest.split_once("impl Dcel {").unwrap();
    let (splits, tail) = rest.split_once("pub fn drawing").unwrap();
    format!("{head}impl Dcel {{{splits}impl Dcel {{{walks}pub fn drawing{tail}")
}

/// The text with a name replaced where it stands alone and is no part of what is given.
fn renamed(text: &str, from: &str, to: &str) -> String {
    let is_name = |c: char| c.is_alphanumeric() || c == '_';
    let mut out = String::new();
    let mut rest = text;
    while let Some(at) = rest.find(from) {
        let before = rest[..at].chars().next_back().or(out.chars().next_back());
        let after = rest[at + from.len()..].chars().next();
        let alone = !before.is_some_and(|c| is_name(c) || c == '.') && !after.is_some_and(is_name);
        out.push_str(&rest[..at]);
        out.push_str(if alone { to } else { from });
        rest = &rest[at + from.len()..];
    }
    out + rest
}

/// The reports of a class of these files; what the files do does not matter here.
fn graded(files: &[(&str, String)], options: &str) -> Vec<Report> {
    let shell = Folder::new();
    fs::create_dir(shell.path("class")).unwrap();
    for (name, text) in files {
        fs::write(shell.path(&format!("class/{name}.rs")), text).unwrap();
    }
    shell.dcel(&format!("grade 04 --all-in class --seed 4 --report json=class.json {options}")).fine();
    serde_json::from_str(&shell.read("class.json")).unwrap()
}

fn told(reports: &[Report]) -> Vec<String> {
    let one = |report: &Report, s: &Similar| {
        format!("{} {} {} {}", report.submission.as_deref().unwrap(), s.submission, s.percent, s.identical)
    };
    reports.iter().flat_map(|report| report.similar.iter().map(move |s| one(report, s))).collect()
}

#[test]
fn honest_answers_are_not_said_to_look_alike() {
    // That no code compiles keeps this quick, and changes nothing in what is compared.
    let broken = |text: String| format!("{text}\nconst NO: u8 = \"\";\n");
    let mut class: Vec<(&str, String)> = HONEST.iter().map(|(name, text)| (*name, broken(filled(text)))).collect();
    class.push(("solution", broken(solution())));
    // Nobody who has written nothing copies from anybody.
    class.extend([("given", given()), ("given too", given())]);
    // The usual threshold is 80: there is room between.
    let reports = graded(&class, "--similar 55");
    assert_eq!(reports.len(), 8);
    assert!(told(&reports).is_empty(), "{:?}", told(&reports));
}

#[test]
fn copies_are_found_whatever_they_are_called() {
    let broken = |text: String| format!("{text}\nconst NO: u8 = \"\";\n");
    let own = filled(HONEST[3].1);
    let changed = broken(solution()).replace("if he1 == he2 {\n            return false;\n        }\n", "");
    let class = [
        ("anna", broken(solution())),
        ("ben", disguised(&broken(solution()))),
        ("cara", broken(own.clone())),
        ("dora", broken(solution())),
        ("emil", changed),
        ("finn", broken(renamed(&own, "edges", "list_of_them"))),
    ];
    let reports = graded(&class, "");
    let of = |name: &str| {
        let report = reports.iter().find(|report| report.submission.as_deref() == Some(name)).unwrap();
        report.similar.iter().map(|s| (s.submission.as_str(), s.identical)).collect::<Vec<_>>()
    };
    assert_eq!(of("anna")[0], ("dora", true));
    for (one, other) in [("anna", "ben"), ("ben", "dora"), ("emil", "anna"), ("emil", "ben"), ("finn", "cara")] {
        assert!(
            of(one).contains(&(other, false)) && of(other).contains(&(one, false)),
            "{one} {other}: {:?}",
            told(&reports)
        );
    }
    assert!(of("cara").iter().all(|(name, _)| *name == "finn"), "{:?}", told(&reports));
}
