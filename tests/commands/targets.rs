//! Every program of tests is a target of exactly one package: one that no manifest names would never run.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

#[test]
fn every_test_program_is_a_target_of_one_package() {
    let checkout = &Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut programs = BTreeSet::new();
    for entry in fs::read_dir(checkout.join("tests")).unwrap().map(Result::unwrap) {
        let name = entry.file_name().into_string().unwrap();
        if entry.path().join("main.rs").is_file() {
            programs.insert(format!("{name}/main.rs"));
        } else if name.ends_with(".rs") {
            programs.insert(name);
        }
    }
    assert!(programs.len() > 10, "{programs:?}");
    let mut named = Vec::new();
    for (manifest, up) in [("tests/Cargo.toml", ""), ("src/cli/Cargo.toml", "../../tests/")] {
        let text = fs::read_to_string(checkout.join(manifest)).unwrap();
        let targets = text.split("[[test]]").skip(1).filter_map(|target| {
            let path = target.lines().find_map(|line| line.strip_prefix("path = \""))?;
            Some(path.trim_end_matches('"').strip_prefix(up)?.to_owned())
        });
        named.extend(targets);
    }
    named.sort();
    assert_eq!(named, programs.into_iter().collect::<Vec<_>>());
}
