//! Every lab grades rightly, and what is compiled into the kit is what stands in `labs/`.

use crate::shell::Folder;
use aho_corasick::AhoCorasick;
use dcel_lab::courses::FOLDERS;
use dcel_lab::{COPIES, KitBuild, Lab, LabFiles, Package, Verdict, verify, verify_some};
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

fn folder(name: &str) -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../labs").join(name)
}

#[test]
fn the_labs_of_the_program_are_those_of_the_repository() {
    let mut folders: Vec<String> = std::fs::read_dir(folder(""))
        .unwrap()
        .map(Result::unwrap)
        .filter(|entry| entry.file_type().unwrap().is_dir())
        .map(|entry| entry.file_name().into_string().unwrap())
        // What labs share is part of each of them.
        .filter(|name| folder(name).join("lab.toml").is_file())
        .collect();
    folders.sort();
    assert_eq!(folders, LabFiles::bundled_names());
    for name in folders {
        let bundled = LabFiles::bundled(&name).unwrap();
        let there = LabFiles::read(&folder(&name)).unwrap().handed_out();
        let differing: Vec<&str> =
            there.iter().filter(|&(path, text)| bundled.get(path) != Some(text)).map(|f| f.0).collect();
        assert_eq!(differing, [""; 0], "{name}: write the bundle anew with `dcel lab bundle`");
        assert_eq!(bundled, there, "{name}: write the bundle anew with `dcel lab bundle`");
    }
}

/// Files are compiled in as they stand; what can be wrong is that a folder or a file is not among them.
#[test]
fn the_program_carries_the_sources_that_its_builds_read() {
    let checkout = &Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let read = |path: String| std::fs::read_to_string(checkout.join(&path)).unwrap_or_else(|e| panic!("{path}: {e}"));
    let packages = |lock: &str| -> BTreeSet<String> {
        lock.split("[[package]]").skip(1).filter(|entry| entry.contains("source = ")).map(pinned).collect()
    };
    let versions = packages(&read("Cargo.lock".to_owned()));
    let anew = "write it anew with `dcel lab bundle`";
    for build in KitBuild::ALL {
        let generated = |file: &str| read(format!("{}/{file}", build.folder()));
        for (package, manifest) in build.manifests(checkout).unwrap() {
            let file = format!("{}.toml.txt", package.name());
            assert_eq!(generated(&file), manifest, "{build:?}: {file}: {anew}");
        }
        let own = packages(&generated("Cargo.lock.txt"));
        assert!(own.len() > 10 && own.is_subset(&versions), "{build:?}: {:?}: {anew}", own.difference(&versions));
    }
    let carried = dcel_cli::program_sources();
    for package in Package::ALL {
        for path in package.files(KitBuild::Program, &|path| std::fs::read_to_string(checkout.join(path))).unwrap() {
            assert_eq!(carried.get(&path), Some(&read(path.clone()).as_str()), "{path}: {}: `TEXTS`", package.name());
        }
    }
    for (copy, of) in COPIES {
        assert_eq!(read(copy.to_owned()), read(of.to_owned()), "{copy}: {anew}");
    }
}

/// In a copy of the checkout: what the command writes is what stands there.
#[test]
fn what_the_program_carries_is_written_anew_by_a_command() {
    const SOURCES: [&str; 5] = ["src", "labs", "figures", "Cargo.toml", "Cargo.lock"];
    let checkout = &Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let shell = Folder::new();
    SOURCES.iter().for_each(|part| copy(&checkout.join(part), &shell.path("kit").join(part)));
    let bundles = LabFiles::bundled_names().into_iter().map(|name| format!("src/lab/bundle/{name}.txt"));
    let copies = COPIES.iter().map(|(copy, _)| (*copy).to_owned());
    let mut written: Vec<String> = bundles.chain(copies).collect();
    for build in KitBuild::ALL {
        written.push(format!("{}/Cargo.lock.txt", build.folder()));
        let packages = build.manifests(checkout).unwrap().into_keys();
        written.extend(packages.map(|package| format!("{}/{}.toml.txt", build.folder(), package.name())));
    }
    written.iter().for_each(|path| std::fs::remove_file(shell.path("kit").join(path)).unwrap());
    shell.dcel("lab bundle kit").fine();
    for path in written {
        let [new, old] = [&shell.path("kit"), checkout].map(|root| std::fs::read_to_string(root.join(&path)).unwrap());
        assert_eq!(new, old, "{path}");
    }
}

fn copy(from: &Path, to: &Path) {
    if from.is_dir() {
        std::fs::create_dir_all(to).unwrap();
        let inside = std::fs::read_dir(from).unwrap().map(|entry| entry.unwrap().file_name());
        // What was built there is not looked at.
        inside.filter(|name| name != "target").for_each(|name| copy(&from.join(&name), &to.join(&name)));
    } else {
        std::fs::copy(from, to).unwrap();
    }
}

/// A published package reads nothing outside of its own folder.
#[test]
fn no_package_reads_outside_of_its_folder() {
    let checkout = &Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    for package in Package::ALL {
        let files = package.files(KitBuild::Program, &|path| std::fs::read_to_string(checkout.join(path))).unwrap();
        // What the root holds but packages of their own do not publish with it.
        let others = Package::ALL.into_iter().filter(|other| *other != package && !other.folder().is_empty());
        let others: Vec<&str> = others.map(Package::folder).chain(["tests/", "labs/", "benches/"]).collect();
        let outside: Vec<&String> = files
            .iter()
            .filter(|file| !file.starts_with(package.folder()) || others.iter().any(|other| file.starts_with(other)))
            .collect();
        assert_eq!(outside, [""; 0], "{}", package.name());
        assert!(files.len() > 100, "{}: {}", package.name(), files.len());
    }
}

/// Name, version and checksum of an entry of a lock file.
fn pinned(entry: &str) -> String {
    let keys = ["name", "version", "checksum"];
    entry.lines().filter(|line| keys.iter().any(|key| line.starts_with(key))).collect::<Vec<_>>().join(" ")
}

/// The binary that students get: neither a line of what they are to write, nor of what they might write wrongly.
#[test]
fn the_program_holds_no_solution_and_no_text_of_a_known_mistake() {
    const SHORTEST: usize = 20;
    let checkout = &Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let program = strings(&std::fs::read(env!("CARGO_BIN_EXE_dcel")).unwrap(), SHORTEST);
    let sources: BTreeMap<String, String> = Package::ALL
        .iter()
        .flat_map(|package| {
            package.files(KitBuild::Program, &|path| std::fs::read_to_string(checkout.join(path))).unwrap()
        })
        .filter(|path| path.starts_with("src/"))
        .map(|path| (path.clone(), std::fs::read_to_string(checkout.join(path)).unwrap()))
        .collect();
    for name in LabFiles::bundled_names() {
        let lab = Lab::read(&folder(&name)).unwrap();
        // Given to everybody: the lab's own files, and the code of the kit that is not about this lab.
        let handed_out = lab.files.handed_out();
        let own = FOLDERS.iter().find(|(lab, _)| *lab == name).map(|(_, folder)| format!("src/lab/courses/{folder}/"));
        let own = own.unwrap();
        let kernel = sources.iter().filter(|(path, _)| !path.starts_with(&own)).map(|(_, text)| text.as_str());
        let given: String = handed_out.iter().map(|(_, text)| text).chain(kernel).flat_map(|t| [t, "\n"]).collect();
        let solution = lab.files.get("solution/lab.rs").unwrap();
        let edits = lab.bugs.iter().flat_map(|bug| &bug.edits).map(|edit| edit.replace.as_str());
        let blocks =
            solution.split("// BEGIN SOLUTION").skip(1).map(|rest| rest.split("// END SOLUTION").next().unwrap());
        let texts: Vec<&str> = blocks.chain(edits).collect();
        let lines: BTreeSet<&str> = texts
            .iter()
            .flat_map(|text| text.lines().map(str::trim))
            .filter(|line| line.len() >= SHORTEST && line.is_ascii() && !line.starts_with("//"))
            .collect();
        let distinctive: BTreeSet<&str> = &lines - &found(&lines, &given);
        assert!(distinctive.len() > 20, "{name}: {} lines", distinctive.len());
        // The search finds what is there.
        let title = lab.bugs[0].title.as_str();
        let sought = &distinctive | &BTreeSet::from([title]);
        assert_eq!(found(&sought, &program), BTreeSet::from([title]), "{name}: in the program");
    }
}

/// Those of the lines that stand somewhere in a text, found in one pass over it.
fn found<'a>(lines: &BTreeSet<&'a str>, text: &str) -> BTreeSet<&'a str> {
    let lines: Vec<&str> = lines.iter().copied().collect();
    let search = AhoCorasick::new(&lines).unwrap();
    search.find_overlapping_iter(text).map(|place| lines[place.pattern().as_usize()]).collect()
}

/// What `strings` finds in a program: runs of printable characters, from a length on.
fn strings(program: &[u8], shortest: usize) -> String {
    let runs = program.split(|&byte| byte != b'\t' && !(b' '..=b'~').contains(&byte));
    let long = runs.filter(|run| run.len() >= shortest);
    long.map(|run| String::from_utf8_lossy(run).into_owned() + "\n").collect()
}

#[test]
fn every_lab_catches_and_names_some_known_mistakes_and_no_right_program() {
    // Of lab 04: a wrong answer, a walk that does not come back, one that looks at everything. Of each other lab the
    // first, one from the middle and the last. All of them: `dcel lab verify`.
    let chosen = [(30, Verdict::Wrong), (64, Verdict::DoesNotComeBack), (66, Verdict::TooSlow)];
    for name in LabFiles::bundled_names() {
        let room = tempfile::tempdir().unwrap();
        let lab = Lab::read(&folder(&name)).unwrap();
        let all: Vec<u32> = lab.bugs.iter().map(|bug| bug.number).collect();
        let spread = [all[0], all[all.len() / 2], all[all.len() - 1]];
        let numbers = if name == "04-half-edge" { chosen.map(|(number, _)| number) } else { spread };
        let found = verify_some(&lab, room.path(), &numbers).unwrap();
        assert!(found.holds(), "{name}:\n{}\n{}", found.problems.join("\n"), found.matrix());
        assert_eq!(found.rows.iter().map(|row| row.number).collect::<Vec<_>>(), numbers, "{name}");
        assert!(found.rows.iter().all(|row| !row.named.is_empty()), "{name}:\n{}", found.matrix());
        if name == "04-half-edge" {
            for (row, (number, verdict)) in found.rows.iter().zip(chosen) {
                assert!(row.verdicts.contains(&verdict), "{number}: {:?}", row.verdicts);
            }
        }
    }
}

#[test]
fn a_lab_that_grades_wrongly_is_found_out() {
    // Of the whole lab only one bug is kept, and its name is taken away.
    let mut lab = Lab::read(&folder("04-half-edge")).unwrap();
    lab.bugs.truncate(1);
    lab.signatures = Default::default();
    let room = tempfile::tempdir().unwrap();
    let found = verify(&lab, room.path()).unwrap();
    let has = |words: &str| found.problems.iter().any(|problem| problem.contains(words));
    assert!(has("signatures.toml is not how the bugs fail"), "{:?}", found.problems);
    assert!(has("bug 1 is called nothing"), "{:?}", found.problems);
    assert!(has("vertex_star catches no bug"), "{:?}", found.problems);
    assert_eq!(found.rows.len(), 1);
}

#[test]
fn what_a_lab_lacks_is_told_before_anything_is_built() {
    let archive = LabFiles::read(&folder("09-two-primitives")).unwrap().to_archive();
    for (from, to, told) in [
        ("file hints/task-3.md ", "file hints/other.md ", "hints/task-3.md is not there: `dcel lab hint` reads it"),
        ("file solution/lab.rs ", "file solution/other.rs ", "solution/lab.rs is not there: the starter"),
        ("fn genus() {", "fn genius() {", "tests/graded.rs has no function `genus`"),
        (
            ".origin = Some(new);'''\nreplace = '''\n'''",
            ".origin = Some(nwe);'''\nreplace = '''\n'''",
            "bugs/03-origins-forgotten.toml:7:8: \"",
        ),
    ] {
        let lab = Lab::new(LabFiles::from_archive(&archive.replacen(from, to, 1)).unwrap()).unwrap();
        let room = tempfile::tempdir().unwrap();
        let found = verify(&lab, room.path()).unwrap();
        assert!(found.problems.len() == 1 && found.problems[0].contains(told), "{:?}", found.problems);
        assert_eq!(std::fs::read_dir(room.path()).unwrap().count(), 0, "{told}");
    }
}
