//! The pages for people at the root: what they name is there.

use std::fs;
use std::path::{Path, PathBuf};

const PAGES: [&str; 4] = ["README.md", "CONTRIBUTING.md", "CHANGELOG.md", "labs/README.md"];

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

fn read(path: &str) -> String {
    fs::read_to_string(root().join(path)).unwrap()
}

/// What stands between one text and the next other one, everywhere.
fn between<'a>(text: &'a str, start: &str, end: &str) -> Vec<&'a str> {
    text.split(start).skip(1).filter_map(|rest| rest.split(end).next()).collect()
}

#[test]
fn links_lead_to_files() {
    let mut links = 0;
    for page in PAGES {
        let folder = root().join(page).parent().unwrap().to_owned();
        let text = read(page);
        for target in between(&text, "](", ")") {
            let is_of_the_repository = !target.contains("://") && !target.starts_with('#');
            let path = folder.join(target.split('#').next().unwrap());
            assert!(!is_of_the_repository || path.exists(), "{page}: there is no {target}");
            links += usize::from(is_of_the_repository);
        }
    }
    assert!(links > 20, "{links}");
}

/// Paths in backticks that have no room for a name of one's own, and tests that commands run.
#[test]
fn what_a_contributor_is_told_to_touch_is_there() {
    let text = read("CONTRIBUTING.md");
    let manifests = [read("tests/Cargo.toml"), read("src/cli/Cargo.toml")].concat();
    let mut found = [0, 0];
    for word in between(&text, "`", "`") {
        let is_path = ["src/", "tests/", "labs/", "figures/", "examples/"].iter().any(|start| word.starts_with(start));
        if is_path && !word.contains(' ') && !word.contains("NAME") && !word.contains("NN") {
            assert!(root().join(word).exists(), "CONTRIBUTING.md: there is no {word}");
            found[0] += 1;
        }
    }
    for test in between(&text, "--test ", " ").into_iter().flat_map(|word| word.lines().next()) {
        let test = test.trim_matches(['`', ',', '.', '|']);
        assert!(manifests.contains(&format!("name = \"{test}\"\n")), "CONTRIBUTING.md: there is no test `{test}`");
        found[1] += 1;
    }
    assert!(found[0] > 30 && found[1] > 10, "{found:?}");
}
