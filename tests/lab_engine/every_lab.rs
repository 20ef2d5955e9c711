//! Every lab as it stands in `labs/`: manifest, handout, starter, graded tests, hints and known mistakes fit the one
//! marked solution.

use dcel_lab::{Bug, Manifest, starter};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

fn labs() -> Vec<(String, PathBuf)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../labs");
    let mut labs: Vec<(String, PathBuf)> = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap())
        .filter(|entry| entry.path().join("lab.toml").is_file())
        .map(|entry| (entry.file_name().into_string().unwrap(), entry.path()))
        .collect();
    labs.sort();
    assert!(!labs.is_empty());
    labs
}

fn read(folder: &Path, path: &str) -> String {
    fs::read_to_string(folder.join(path)).unwrap_or_else(|error| panic!("{}: {path}: {error}", folder.display()))
}

fn manifest(folder: &Path) -> Manifest {
    Manifest::parse(&read(folder, "lab.toml"), "lab.toml").unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn the_starter_is_the_solution_with_its_blocks_replaced() {
    for (lab, folder) in labs() {
        let made = starter(&read(&folder, "solution/lab.rs")).unwrap();
        assert_eq!(
            read(&folder, "src/lab.rs"),
            made,
            "{lab}: `dcel lab verify --from labs/{lab} --write` writes it anew"
        );
        assert!(!made.contains("SOLUTION") && !made.contains("STARTER"), "{lab}");
        assert!(made.lines().any(|line| line.trim().starts_with("todo!(")), "{lab}: nothing is left to do");
    }
}

/// The questions are numbered as they come; each has room where the student answers, and an answer for the instructor.
#[test]
fn every_question_has_room_for_an_answer_and_an_answer() {
    for (lab, folder) in labs() {
        let numbers = |text: &str, before: &str| -> Vec<usize> {
            let number = |line: &str| line.strip_prefix(before)?.split(['.', ':']).next()?.parse().ok();
            text.lines().filter_map(number).collect()
        };
        let asked = numbers(&read(&folder, "README.md"), "> **Question ");
        assert!(asked.len() >= 4, "{lab}: {asked:?}");
        assert_eq!(asked, (1..=asked.len()).collect::<Vec<_>>(), "{lab}: in order");
        assert_eq!(numbers(&read(&folder, "answers.md"), "## Question "), asked, "{lab}: answers.md");
        let answers = read(&folder, "solution/answers.md");
        assert_eq!(numbers(&answers, "**Question "), asked, "{lab}: solution/answers.md");
        let shortest = answers.split("\n**Question ").skip(1).map(str::len).min();
        assert!(shortest > Some(40), "{lab}: an answer is missing");
    }
}

#[test]
fn the_manifest_is_the_one_that_the_handout_tells_of() {
    for (lab, folder) in labs() {
        let manifest = manifest(&folder);
        assert_eq!((manifest.name.as_str(), manifest.package), (lab.as_str(), format!("lab-{lab}")));
        assert_eq!(manifest.graded, ["src/lab.rs"], "{lab}");
        assert_eq!(manifest.tests.iter().map(|test| test.points).sum::<dcel_lab::Points>(), 100, "{lab}: points");
        let handout = read(&folder, "README.md");
        for test in &manifest.tests {
            let row = format!("| `{}` | {} |", test.name, test.points);
            assert!(handout.contains(&row), "{lab}: the handout's table of points has no {row}");
        }
        let headings: BTreeSet<&str> = handout.lines().filter_map(|line| line.strip_prefix("## ")).collect();
        for task in &manifest.tasks {
            assert!(headings.contains(task.section.as_str()), "{lab}: the handout has no section {:?}", task.section);
            let number = task.number;
            assert!(handout.contains(&format!("**Task {number}.**")), "{lab}: the handout has no task {number}");
            let hints = read(&folder, &format!("hints/task-{number}.md"));
            for level in ["## A nudge", "## A pointer", "## Nearly the code"] {
                assert_eq!(hints.lines().filter(|line| *line == level).count(), 1, "{lab}: task {number}: {level}");
            }
        }
        if let Some(reference) = manifest.drawing {
            assert!(folder.join("../../figures").join(&reference).is_file(), "{lab}: no figure {reference}");
        }
        let links = handout.split("](").skip(1).filter_map(|rest| rest.split([')', '#']).next());
        for link in links.filter(|link| !link.is_empty() && !link.contains("://")) {
            assert!(folder.join(link).exists(), "{lab}: the handout links to {link}, which is not there");
        }
    }
}

#[test]
fn every_graded_test_is_a_test_of_its_name() {
    for (lab, folder) in labs() {
        let source = read(&folder, "tests/graded.rs");
        assert!(source.contains(&format!("dcel_lab::graded(\"{lab}\", ")), "{lab}: tests/graded.rs names another lab");
        let test = |name: &str| format!("#[test]\nfn {name}() {{\n    graded(\"{name}\");\n}}\n");
        let made: Vec<String> = manifest(&folder).tests.iter().map(|graded| test(&graded.name)).collect();
        let (_, found) = source.split_once("\n}\n\n").unwrap();
        assert_eq!(found, made.join("\n"), "{lab}: tests/graded.rs and lab.toml disagree");
    }
}

#[test]
fn every_known_mistake_is_made_of_the_solution_and_is_told_apart_by_its_name() {
    for (lab, folder) in labs() {
        let (solution, manifest) = (read(&folder, "solution/lab.rs"), manifest(&folder));
        let bugs = bugs(&folder);
        assert!(bugs.len() >= 8, "{lab}: {} known mistakes", bugs.len());
        let (mut titles, mut sources) = (BTreeSet::new(), BTreeMap::new());
        for (i, (file, bug)) in bugs.iter().enumerate() {
            let of = format!("{lab}: {file}");
            assert_eq!(bug.number as usize, i + 1, "{of}: numbers are those of the files, without a gap");
            assert!(file.starts_with(&format!("{:02}-", bug.number)), "{of} has the number {}", bug.number);
            assert!(titles.insert(bug.title.clone()), "{of}: {:?} names another mistake, too", bug.title);
            assert!(manifest.task(bug.task).is_some(), "{of}: no task {}", bug.task);
            assert!(
                manifest.tasks.iter().any(|task| task.section == bug.section),
                "{of}: no section {:?}",
                bug.section
            );
            let source = bug.apply(&solution).unwrap_or_else(|error| panic!("{of}: {error}"));
            let changed = changed_lines(&solution, &source);
            assert!(changed <= 10, "{of}: {changed} lines differ from the solution");
            if let Some(other) = sources.insert(source, file) {
                panic!("{of} and {other} are the same");
            }
            for &other in &bug.same_as {
                let pair = bugs.iter().any(|(_, bug_2)| bug_2.number == other && bug_2.same_as.contains(&bug.number));
                assert!(pair, "{of} names {other} as its pair, not the other way");
            }
        }
    }
}

fn bugs(folder: &Path) -> Vec<(String, Bug)> {
    let mut files: Vec<String> = fs::read_dir(folder.join("bugs"))
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .filter(|file| file.starts_with(|first: char| first.is_ascii_digit()))
        .collect();
    files.sort();
    let parse = |file: String| {
        let bug = Bug::parse(&read(folder, &format!("bugs/{file}")), &file).unwrap_or_else(|error| panic!("{error}"));
        (file, bug)
    };
    files.into_iter().map(parse).collect()
}

/// The lines of the longer of the two parts that differ between a common beginning and a common end, without those that
/// both parts have.
fn changed_lines(right: &str, wrong: &str) -> usize {
    let [right, wrong]: [Vec<&str>; 2] = [right, wrong].map(|text| text.lines().collect());
    let only = |of: &[&str], not: &[&str]| of.iter().filter(|line| !not.contains(*line)).count();
    only(&right, &wrong).max(only(&wrong, &right))
}
