//! An instructor's own lab: what `dcel lab new` makes grades rightly, and is found by all commands that know labs.
//! `BLESS=1` writes anew how its known mistake fails.

use dcel_lab::{Kit, Lab, LabFiles, courses, new_lab, student_files, verify};
use std::fs;
use std::process::Command;

// The judge that every new lab begins with, as it stands in the kit.
#[path = "../../src/lab/template/judge/lib.rs"]
#[allow(dead_code, unreachable_pub)]
mod judge;

#[test]
fn a_new_lab_is_whole_and_grades_rightly() {
    let dir = tempfile::tempdir().unwrap();
    // Its folder may be called anything: the name is that of `lab.toml`.
    let folder = dir.path().join("some where");
    for (path, text) in new_lab("77-border", &Kit::Path("/kit".into())).unwrap() {
        let path = folder.join(path);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
    }
    // Without its judge nobody can say anything about it.
    let room = dir.path().join("room");
    let unjudged = verify(&Lab::new(LabFiles::read(&folder).unwrap()).unwrap(), &room).unwrap();
    assert!(!unjudged.holds() && unjudged.problems[0].contains("nothing judges this lab"), "{:?}", unjudged.problems);

    courses::add_own(&folder.join("judge/.."), &judge::JUDGE);
    assert!(LabFiles::known_names().contains(&"77-border".to_owned()));
    for name in ["77", "border", "77-border"] {
        assert_eq!(LabFiles::bundled(name).unwrap().name(), "77-border");
    }
    let handed_out = LabFiles::bundled("77").unwrap();
    assert!(handed_out.get("solution/lab.rs").is_none() && handed_out.get("src/lab.rs").is_some());

    let lab = Lab::read(&folder).unwrap();
    assert_eq!(lab, Lab::with_judge(LabFiles::read(&folder).unwrap(), &judge::JUDGE).unwrap());
    let found = verify(&lab, &room).unwrap();
    if std::env::var_os("BLESS").is_some() {
        let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../lab/template/bugs/signatures.toml");
        fs::write(file, found.signatures.to_text()).unwrap();
        return;
    }
    assert!(found.holds(), "{}\n{}", found.problems.join("\n"), found.matrix());
    assert_eq!((found.rows.len(), found.tests.len()), (1, 2));
    assert_eq!(found.rows[0].named.len(), 1);

    // What a student gets: the judge and the lab as it was handed out, the kit by its sources, no solution.
    let files = student_files(&handed_out, &Kit::Inside);
    for there in ["judge/lib.rs", "judge/lab.txt", "kit/src/lab/lib.rs", "src/harness/mod.rs", "tests/graded.rs"] {
        assert!(files.contains_key(there), "{there}");
    }
    assert!(files.keys().all(|path| !["solution/", "program/", "bugs/"].iter().any(|kept| path.starts_with(kept))));
    assert!(files["judge/Cargo.toml"].contains("dcel-lab = { path = \"../kit/src/lab\", default-features = false }"));
    assert_eq!(files["Cargo.toml"].matches("[workspace]").count(), 1, "{}", files["Cargo.toml"]);
    assert!(files.values().all(|text| !text.contains("let on_border")), "the solution was handed out");
    assert!(!files.keys().any(|path| path.contains("courses/half_edge")), "the judges of other labs are not needed");
}

#[test]
fn the_command_makes_a_lab_and_its_starter_anew() {
    let dir = tempfile::tempdir().unwrap();
    let dcel = |words: &[&str]| {
        let output = Command::new(env!("CARGO_BIN_EXE_dcel")).args(words).current_dir(dir.path()).output().unwrap();
        let said = [&output.stdout[..], &output.stderr[..]].concat();
        (output.status.code(), String::from_utf8(said).unwrap())
    };
    let (code, said) = dcel(&["lab", "new", "12-mine"]);
    assert!(code == Some(0) && said.contains("cd 12-mine/program") && said.contains("lab verify 12"), "{said}");
    // No checkout is around: the published kit.
    let version = format!("dcel = {{ version = \"{}\" }}", env!("CARGO_PKG_VERSION"));
    assert!(fs::read_to_string(dir.path().join("12-mine/program/Cargo.toml")).unwrap().contains(&version));
    for (words, told) in [
        (&["lab", "new", "12-mine"][..], "12-mine: is not empty"),
        (&["lab", "new", "mine"], "`mine` cannot be a lab"),
        (&["lab", "new", "13-x", "--kit", "path=nowhere"], "nowhere: no checkout of the kit is there"),
    ] {
        let (code, said) = dcel(words);
        assert!(code == Some(2) && said.contains(told), "{said}");
    }
    let solution = dir.path().join("12-mine/solution/lab.rs");
    let text = fs::read_to_string(&solution).unwrap().replace("todo!(\"border_edges\")", "todo!(\"count them\")");
    fs::write(&solution, text).unwrap();
    let known = || fs::read_to_string(dir.path().join("12-mine/bugs/signatures.toml")).unwrap();
    let before = known();
    let (code, said) = dcel(&["lab", "verify", "--from", "12-mine", "--write"]);
    assert!(
        code == Some(1) && said.contains("nothing judges this lab") && said.contains("src/lab.rs: written"),
        "{said}"
    );
    assert!(fs::read_to_string(dir.path().join("12-mine/src/lab.rs")).unwrap().contains("count them"));
    assert_eq!(known(), before, "nothing is known of how the mistakes fail");
}
