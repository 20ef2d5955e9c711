//! The house: which files use which. Arrows between rooms run downwards only, and no files of a room stand in a circle
//! that is not a parent and its child.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// Each room of the library with the rooms that it may use.
const ROOMS: [(&str, &[&str]); 17] = [
    ("ids", &[]),
    ("files", &[]),
    ("sources", &[]),
    ("geometry", &[]),
    ("old_words", &[]),
    ("progress", &[]),
    ("topology", &["geometry", "ids", "progress"]),
    ("plane", &["geometry", "ids", "progress", "topology"]),
    ("solid", &["geometry", "ids", "plane", "progress", "topology"]),
    ("navmesh", &["geometry", "ids", "plane", "topology"]),
    ("io", &["files", "geometry", "ids", "old_words", "plane", "progress", "solid", "topology"]),
    ("interop", &["geometry", "ids", "navmesh", "plane", "solid", "topology"]),
    ("edits", &["geometry", "ids", "old_words", "plane", "solid", "topology"]),
    ("script", &["edits", "geometry", "ids", "old_words", "plane", "solid", "topology"]),
    ("figure", &["edits", "geometry", "ids", "navmesh", "plane", "script", "solid", "topology"]),
    ("play", &["edits", "figure", "geometry", "ids", "io", "old_words", "plane", "script", "solid", "topology"]),
    ("compare", &["figure", "geometry", "ids", "plane", "topology"]),
];

/// Files by the path of their module, without the name of the package.
type Files = BTreeMap<Vec<String>, PathBuf>;
/// Which modules a module uses.
type Uses = BTreeMap<Vec<String>, BTreeSet<Vec<String>>>;

fn package(folder: &str) -> Files {
    fn gather(folder: &Path, module: &[String], apart: &[PathBuf], files: &mut Files) {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            let name = path.file_stem().unwrap().to_str().unwrap().to_owned();
            let mut inner = module.to_vec();
            inner.push(name.clone());
            if path.is_dir() {
                if !apart.contains(&path) {
                    gather(&path, &inner, apart, files);
                }
            } else if path.extension().is_some_and(|extension| extension == "rs") && name != "build" {
                if ["mod", "lib", "main"].contains(&name.as_str()) {
                    inner.pop();
                }
                files.insert(inner, path);
            }
        }
    }
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(folder);
    // Packages of their own within the folder.
    let apart = ["lab", "cli"].map(|name| root.join(name)).into_iter().filter(|path| path.join("Cargo.toml").is_file());
    let mut files = Files::new();
    gather(&root, &[], &apart.collect::<Vec<_>>(), &mut files);
    files
}

/// The code of a file without comments and without its tests.
fn code(text: &str) -> String {
    let lines = text.lines().map(|line| line.split_once("//").map_or(line, |(code, _)| code));
    let lines: Vec<&str> = lines.collect();
    let tests = lines.windows(2).position(|pair| {
        pair[0].trim() == "#[cfg(test)]" && pair[1].starts_with("mod ") && pair[1].trim_end().ends_with('{')
    });
    lines[..tests.unwrap_or(lines.len())].join("\n")
}

/// `a::{b, c::{d, e}}` as `a::b`, `a::c::d`, `a::c::e`.
fn branches(tree: &str) -> Vec<String> {
    let Some((stem, rest)) = tree.split_once('{') else {
        return vec![tree.split(" as ").next().unwrap_or_default().trim().to_owned()];
    };
    let inner = rest.rsplit_once('}').map_or(rest, |(inner, _)| inner);
    let (mut depth, mut from, mut out) = (0, 0, Vec::new());
    for (at, c) in inner.char_indices().chain([(inner.len(), ',')]) {
        match c {
            '{' => depth += 1,
            '}' => depth -= 1,
            ',' if depth == 0 => {
                out.extend(
                    branches(inner[from..at].trim()).into_iter().map(|branch| format!("{}{branch}", stem.trim())),
                );
                from = at + 1;
            }
            _ => {}
        }
    }
    out
}

/// All paths in a piece of code: those of `use`, and those that begin with `crate` or `super`.
fn paths(code: &str) -> Vec<String> {
    let flat = code.split_whitespace().collect::<Vec<_>>().join(" ");
    let mut out = Vec::new();
    for statement in flat.split(';') {
        if let Some(at) =
            statement.rfind("use ").filter(|&at| at == 0 || statement[..at].ends_with([' ', ')', '}', '{', ']']))
        {
            out.extend(branches(statement[at + 4..].trim()));
        }
    }
    let is_word = |c: char| c.is_alphanumeric() || c == '_' || c == ':';
    out.extend(
        flat.split(|c| !is_word(c))
            .filter(|word| (word.starts_with("crate::") || word.starts_with("super::")) && !word.ends_with(':'))
            .map(str::to_owned),
    );
    out
}

/// Which module of the package a path in a module leads to.
fn target(path: &str, module: &[String], files: &Files) -> Option<Vec<String>> {
    let mut parts: Vec<&str> = path.split("::").map(str::trim).filter(|part| !part.is_empty()).collect();
    let mut at: Vec<String> = match *parts.first()? {
        "crate" => Vec::new(),
        "super" | "self" => module.to_vec(),
        first => {
            let mut inner = module.to_vec();
            inner.push(first.to_owned());
            files.contains_key(&inner).then(|| module.to_vec())?
        }
    };
    if parts[0] == "crate" || parts[0] == "self" {
        parts.remove(0);
    }
    while parts.first() == Some(&"super") {
        at.pop();
        parts.remove(0);
    }
    for part in parts {
        at.push(part.to_owned());
        if !files.contains_key(&at) {
            at.pop();
            break;
        }
    }
    Some(at)
}

fn uses(files: &Files) -> Uses {
    let of = |(module, path): (&Vec<String>, &PathBuf)| {
        let text = fs::read_to_string(path).unwrap();
        let all = paths(&code(&text)).iter().filter_map(|path| target(path, module, files)).collect::<BTreeSet<_>>();
        (module.clone(), all.into_iter().filter(|to| to != module).collect())
    };
    files.iter().map(of).collect()
}

/// Whether one of two modules stands in the other.
fn akin(a: &[String], b: &[String]) -> bool {
    a.starts_with(b) || b.starts_with(a)
}

/// Modules that reach each other, parents and children aside.
fn circles(uses: &Uses) -> Vec<String> {
    let next =
        |module: &Vec<String>| uses[module].iter().filter(move |to| !akin(module, to)).cloned().collect::<Vec<_>>();
    let reach: Uses = uses
        .keys()
        .map(|module| {
            let (mut seen, mut open) = (BTreeSet::new(), next(module));
            while let Some(at) = open.pop() {
                if seen.insert(at.clone()) {
                    open.extend(next(&at));
                }
            }
            (module.clone(), seen)
        })
        .collect();
    let mut out = BTreeSet::new();
    for (module, seen) in &reach {
        let circle: Vec<String> =
            seen.iter().filter(|other| reach[*other].contains(module)).map(|other| other.join("/")).collect();
        if circle.len() > 1 {
            out.insert(circle.join(" "));
        }
    }
    out.into_iter().collect()
}

#[test]
fn arrows_between_rooms_run_downwards() {
    let files = package("src");
    assert!(files.len() > 300, "{} files: the house was not found", files.len());
    let mut wrong = Vec::new();
    for (module, to) in uses(&files) {
        let (Some(room), false) = (module.first(), module.is_empty()) else { continue };
        let Some((_, below)) = ROOMS.iter().find(|(name, _)| name == room) else {
            wrong.push(format!("{room} is no room that this test knows"));
            continue;
        };
        for other in to.iter().filter_map(|to| to.first()).filter(|other| *other != room) {
            if !below.contains(&other.as_str()) {
                wrong.push(format!("{} uses {other}", module.join("/")));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn no_files_stand_in_a_circle() {
    let all: Vec<String> = ["src", "src/lab", "src/cli"]
        .into_iter()
        .flat_map(|folder| {
            circles(&uses(&package(folder))).into_iter().map(move |circle| format!("{folder}: {circle}"))
        })
        .collect();
    assert!(all.is_empty(), "these files use each other in a circle: {all:#?}");
}

#[test]
fn a_circle_and_an_arrow_are_seen() {
    let module = |name: &str| vec!["room".to_owned(), name.to_owned()];
    let files: Files =
        [vec!["room".to_owned()], module("a"), module("b"), module("c")].map(|m| (m, PathBuf::new())).into();
    let read = |name: &str, text: &str| {
        let to =
            paths(&code(text)).iter().filter_map(|path| target(path, &module(name), &files)).collect::<BTreeSet<_>>();
        (module(name), to)
    };
    let a = read("a", "use super::{b::{B, Other}, c};\nfn f() {}\n");
    assert_eq!(a.1, [module("b"), module("c")].into());
    // Neither comments nor tests count; paths in the middle of code do.
    let b = read(
        "b",
        "// super::c\nfn g() -> u8 { crate::room::a::f() }\n#[cfg(test)]\nmod tests {\n    use super::super::c;\n}\n",
    );
    assert_eq!(b.1, [module("a")].into());
    let mut uses: Uses = [a, b, read("c", "")].into();
    uses.insert(vec!["room".to_owned()], BTreeSet::new());
    assert_eq!(circles(&uses), ["room/a room/b"]);
}

/// The map of a folder is the first comment of its `mod.rs`.
#[test]
fn every_file_is_named_in_the_map_of_its_folder() {
    fn missing(folder: &Path, out: &mut Vec<String>) {
        let mut names = Vec::new();
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() && !path.join("Cargo.toml").is_file() {
                names.extend(path.join("mod.rs").is_file().then(|| path.clone()));
                missing(&path, out);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                names.push(path);
            }
        }
        let Ok(text) = fs::read_to_string(folder.join("mod.rs")) else { return };
        let map: String = text.lines().take_while(|line| line.starts_with("//") || line.is_empty()).collect();
        let words: BTreeSet<&str> = map.split(|c: char| !(c.is_alphanumeric() || c == '_')).collect();
        let stem = |path: &PathBuf| path.file_stem().unwrap().to_str().unwrap().to_owned();
        let lacks = |name: &String| name != "mod" && !words.contains(name.as_str());
        out.extend(names.iter().map(stem).filter(lacks).map(|name| format!("{}: {name}", folder.display())));
    }
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut out = Vec::new();
    ["src", "src/cli"].into_iter().for_each(|folder| missing(&root.join(folder), &mut out));
    // Written by a command.
    out.retain(|line| !line.contains("kit: ") && !line.contains("sources: "));
    assert!(out.is_empty(), "not named in the first comment of mod.rs: {out:#?}");
}

/// What is built, what is made by the program, and what no student's folder has a use for.
const APART: [&str; 3] = ["target", "bundle", "interop"];

/// Students' folders, the picture of the rooms and the autograder are made of the sources that each package carries: a file
/// that is not among them would be missing there.
#[test]
fn packages_carry_all_of_their_sources() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    for (folder, list, before) in [
        ("src", "src/sources/mod.rs", "src/"),
        ("src/cli", "src/cli/lab/kit/mod.rs", ""),
        ("src/lab", "src/lab/kit/mod.rs", ""),
    ] {
        let text = fs::read_to_string(root.join(list)).unwrap();
        let mut files = 0;
        for entry in fs::read_dir(root.join(folder)).unwrap() {
            let path = entry.unwrap().path();
            let name = path.file_name().unwrap().to_str().unwrap().to_owned();
            if path.extension().is_some_and(|extension| extension == "rs") {
                assert!(text.contains(&format!("\"{before}{name}\"")), "{list} does not name {folder}/{name}");
                files += 1;
            } else if path.is_dir() && !path.join("Cargo.toml").exists() && !APART.contains(&name.as_str()) {
                let named = format!("\"$CARGO_MANIFEST_DIR/{before}{name}\"");
                assert!(text.contains(&named), "{list} does not name the folder {folder}/{name}");
            }
        }
        assert!(files > 3, "{folder}");
    }
}
