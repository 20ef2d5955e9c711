//! The programs of `examples/`: each prints what its first comment says it prints.
//!
//! They are compiled into this test program with a `println!` that keeps what it gets.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Once;

thread_local! {
    static PRINTED: RefCell<String> = const { RefCell::new(String::new()) };
}

fn keep(line: std::fmt::Arguments<'_>) {
    PRINTED.with_borrow_mut(|printed| printed.write_fmt(line).unwrap());
}

/// What the examples see in the place of the standard one.
macro_rules! println {
    ($($arguments:tt)*) => {{
        crate::examples::keep(format_args!($($arguments)*));
        crate::examples::keep(format_args!("\n"));
    }};
}

macro_rules! examples {
    ($($name:ident: $path:literal),+ $(,)?) => {
        $(#[path = $path]
        pub(crate) mod $name;)+

        /// The examples by name, each with what it does.
        const EXAMPLES: &[(&str, fn() -> Result<(), Box<dyn std::error::Error>>)] = &[
            $((stringify!($name), $name::main)),+
        ];

        $(#[test]
        fn $name() {
            prints_what_it_says(stringify!($name));
        })+
    };
}

examples! {
    build_and_walk: "../../examples/build_and_walk.rs",
    comparison: "../../examples/comparison.rs",
    delaunay_svg: "../../examples/delaunay_svg.rs",
    film: "../../examples/film.rs",
    map_path: "../../examples/map_path.rs",
    overlay: "../../examples/overlay.rs",
    own_data: "../../examples/own_data.rs",
    own_edit: "../../examples/own_edit.rs",
    segments_and_locate: "../../examples/segments_and_locate.rs",
    solid: "../../examples/solid.rs",
}

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The block that the first comment promises.
fn promised(source: &str) -> String {
    let header = source.lines().take_while(|line| line.starts_with("//!"));
    let text: Vec<&str> = header.map(|line| line[3..].strip_prefix(' ').unwrap_or("")).collect();
    let prints = text.iter().position(|line| *line == "It prints:").expect("`It prints:` in the first comment");
    let block = text[prints..].iter().skip_while(|line| **line != "```text").skip(1);
    block.take_while(|line| **line != "```").map(|line| format!("{line}\n")).collect()
}

fn prints_what_it_says(name: &str) {
    // As from the root of the checkout, where the comments say to run them.
    static GO: Once = Once::new();
    GO.call_once(|| std::env::set_current_dir(root()).unwrap());
    let source = fs::read_to_string(root().join("examples").join(name).with_extension("rs")).unwrap();
    let (_, main) = EXAMPLES.iter().find(|(example, _)| *example == name).unwrap();
    PRINTED.take();
    main().unwrap();
    assert_eq!(PRINTED.take(), promised(&source), "{name}");
}

#[test]
fn every_example_is_run_short_and_says_how_to_run_it() {
    let entries = fs::read_dir(root().join("examples")).unwrap().map(|entry| entry.unwrap().path());
    let files: BTreeMap<String, String> = entries
        .filter(|path| path.extension().is_some_and(|extension| extension == "rs"))
        .map(|path| (path.file_stem().unwrap().to_str().unwrap().to_owned(), fs::read_to_string(path).unwrap()))
        .collect();
    let mut run: Vec<&str> = EXAMPLES.iter().map(|(name, _)| *name).collect();
    run.sort_unstable();
    assert_eq!(files.keys().map(String::as_str).collect::<Vec<_>>(), run);
    let readme = fs::read_to_string(root().join("README.md")).unwrap();
    for (name, text) in &files {
        assert!(text.contains(&format!("//! Run it: `cargo run --example {name}`\n")), "{name}");
        assert!(readme.contains(&format!("(examples/{name}.rs)")), "the README does not show {name}");
        let code = text.lines().filter(|line| !line.trim().is_empty() && !line.trim().starts_with("//")).count();
        // An edit of one's own has an error of its own.
        let most = if name == "own_edit" { 90 } else { 60 };
        assert!((15..=most).contains(&code), "{name} has {code} lines of code");
    }
}
