//! Every lab grades rightly, and what is compiled into the kit is what stands in `labs/`.

use dcel_kit::lab::{Lab, LabFiles, verify};
use std::path::Path;

fn folder(name: &str) -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("labs").join(name)
}

#[test]
fn the_labs_of_the_program_are_those_of_the_repository() {
    let mut folders: Vec<String> = std::fs::read_dir(folder(""))
        .unwrap()
        .map(Result::unwrap)
        .filter(|entry| entry.file_type().unwrap().is_dir())
        .map(|entry| entry.file_name().into_string().unwrap())
        .collect();
    folders.sort();
    assert_eq!(folders, LabFiles::bundled_names());
    for name in folders {
        let bundled = LabFiles::bundled(&name).unwrap();
        let there = LabFiles::read(&folder(&name)).unwrap();
        let differing: Vec<&str> =
            there.iter().filter(|&(path, text)| bundled.get(path) != Some(text)).map(|f| f.0).collect();
        assert_eq!(differing, [""; 0], "{name}: write the bundle anew with `dcel lab bundle`");
        assert_eq!(bundled, there, "{name}: write the bundle anew with `dcel lab bundle`");
    }
}

#[test]
fn every_lab_catches_and_names_every_bug_and_no_right_program() {
    for name in LabFiles::bundled_names() {
        let room = tempfile::tempdir().unwrap();
        let found = verify(&Lab::read(&folder(&name)).unwrap(), room.path()).unwrap();
        assert!(found.holds(), "{name}:\n{}\n{}", found.problems.join("\n"), found.matrix());
        let uniquely = found.rows.iter().filter(|row| row.named.len() == 1).count();
        assert!(found.rows.len() >= 23 && uniquely >= 20, "{name}: {} bugs, {uniquely} with names", found.rows.len());
    }
}

#[test]
fn a_lab_that_grades_wrongly_is_found_out() {
    // Of the whole lab only one bug is kept, and its name is taken away.
    let mut lab = Lab::bundled("04").unwrap();
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
