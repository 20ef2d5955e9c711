//! Lab 04 as it stands in `labs/`: the manifest, the starter and the bugs fit the one marked solution.
#![cfg(feature = "lab")]

use dcel_kit::lab::{Manifest, starter};
use std::fs;
use std::path::{Path, PathBuf};

fn lab() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("labs/04-half-edge")
}

fn read(path: &str) -> String {
    fs::read_to_string(lab().join(path)).unwrap()
}

/// `BLESS=1 cargo test --test lab_04` writes the starter anew.
#[test]
fn the_starter_is_the_solution_with_its_blocks_replaced() {
    let made = starter(&read("solution/lab.rs")).unwrap();
    if std::env::var_os("BLESS").is_some() {
        fs::write(lab().join("src/lab.rs"), &made).unwrap();
    }
    assert_eq!(read("src/lab.rs"), made, "BLESS=1 cargo test --test lab_04 writes src/lab.rs anew");
    assert!(!made.contains("SOLUTION") && !made.contains("STARTER"));
}

#[test]
fn the_manifest_is_the_one_that_the_handout_promises() {
    let manifest = Manifest::parse(&read("lab.toml"), "lab.toml").unwrap();
    assert_eq!((manifest.name.as_str(), manifest.package.as_str()), ("04-half-edge", "lab-04-half-edge"));
    assert_eq!(manifest.graded, ["src/lab.rs"]);
    assert_eq!(manifest.tests.len(), 18);
    assert_eq!(manifest.max_points(), 100);
    assert_eq!(manifest.test("drawing").unwrap().task, 7);
    assert!(manifest.task(9).is_none());
}
