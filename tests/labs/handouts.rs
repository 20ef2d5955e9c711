//! What a handout tells to type works in the student's folder, with a right solution.

use crate::shell::Folder;
use dcel_lab::LabFiles;
use std::path::Path;
use std::process::Command;

/// The two lines of a handout that draw the lab's picture and compare it with the reference.
fn drawing(handout: &str) -> Option<[&str; 2]> {
    let lines: Vec<&str> = handout.lines().map(|line| line.split(" #").next().unwrap_or(line).trim()).collect();
    let at = lines
        .windows(2)
        .position(|pair| pair[0].starts_with("cargo run -- ") && pair[1].starts_with("dcel compare figures/lab-"))?;
    Some([lines[at], lines[at + 1]])
}

/// A check that says "passed" and a command that says "differs" would leave a student without a way on.
#[test]
fn the_solutions_pictures_are_those_of_the_handouts_for_the_commands_that_they_name() {
    let folder = Folder::empty();
    let labs = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../labs");
    for name in LabFiles::bundled_names() {
        let room = folder.path(&name);
        folder.dcel(&format!("lab start {name} {name}")).fine();
        std::fs::copy(labs.join(&name).join("solution/lab.rs"), room.join("src/lab.rs")).unwrap();
        let handout = std::fs::read_to_string(room.join("README.md")).unwrap();
        let [draw, compare] = drawing(&handout).unwrap_or_else(|| panic!("{name}: no command draws and compares"));
        let words: Vec<&str> = draw.split(' ').skip(1).collect();
        let mut cargo = Command::new("cargo");
        cargo.args(&words).current_dir(&room).env("CARGO_TARGET_DIR", folder.path("target"));
        let built = cargo.output().unwrap();
        assert!(built.status.success(), "{name}: {draw}: {}", String::from_utf8_lossy(&built.stderr));
        let told =
            Command::new(env!("CARGO_BIN_EXE_dcel")).args(compare.split(' ').skip(1)).current_dir(&room).output();
        let told = told.unwrap();
        let [out, err] = [&told.stdout, &told.stderr].map(|text| String::from_utf8_lossy(text).into_owned());
        assert!(told.status.success() && out.starts_with("equal"), "{name}: {compare}: {out}{err}");
    }
}
