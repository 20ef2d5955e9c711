//! `examples/notebook.ipynb` holds the cells of the program beside this file, and what they print and show.

use dcel_kit::Subdivision;
use dcel_kit::figure::{self, Camera, Figure, FigureOptions, HiddenLines};
use dcel_kit::solid::Polyhedron;
use serde_json::{Value, json};
use std::cell::RefCell;
use std::fs;
use std::path::Path;

thread_local! {
    /// What the cell that runs has put out so far.
    static OUTPUTS: RefCell<Vec<Value>> = const { RefCell::new(Vec::new()) };
}

/// What the cells see in the place of the standard one.
macro_rules! println {
    ($($arguments:tt)*) => { super::printed(&format!($($arguments)*)) };
}

mod cells;

fn printed(line: &str) {
    OUTPUTS.with_borrow_mut(|out| {
        out.push(json!({"name": "stdout", "output_type": "stream", "text": [format!("{line}\n")]}));
    });
}

/// What a kernel shows. Pictures of structures are numbered.
trait Shown {
    fn figure(&self, number: &mut u32) -> Figure;
}

fn numbered(name: &str, number: &mut u32) -> FigureOptions {
    *number += 1;
    FigureOptions::new(format!("{name} {number}"))
}

impl Shown for Subdivision {
    fn figure(&self, number: &mut u32) -> Figure {
        figure::structure(self, &numbered("Subdivision", number)).unwrap()
    }
}

impl Shown for Polyhedron {
    fn figure(&self, number: &mut u32) -> Figure {
        figure::solid(self, &Camera::default(), HiddenLines::default(), &numbered("Polyhedron", number)).unwrap()
    }
}

impl Shown for Figure {
    fn figure(&self, _: &mut u32) -> Figure {
        self.clone()
    }
}

/// Lines as a notebook keeps them: each with its line break, but for the last one.
fn lines(text: &str) -> Vec<String> {
    text.trim().split_inclusive('\n').map(str::to_owned).collect()
}

/// The cells of the source text: whether it is code, and its text.
fn source() -> Vec<(bool, String)> {
    let program = include_str!("cells.rs");
    let (_, body) = program.split_once("    // %%").unwrap();
    let (body, _) = body.rsplit_once("    Ok(())\n}").unwrap();
    let cell = |text: &str| {
        let (kind, text) = text.split_once('\n').unwrap();
        let is_code = kind.trim().is_empty();
        let line = |line: &str| {
            let line = line.strip_prefix("    ").unwrap_or(line);
            let comment = line.strip_prefix("//").map(|rest| rest.strip_prefix(' ').unwrap_or(rest));
            match (comment, line.strip_prefix("show(&").and_then(|rest| rest.strip_suffix(");"))) {
                (Some(comment), _) => comment.to_owned(),
                (None, Some(shown)) => shown.to_owned(),
                (None, None) => line.to_owned(),
            }
        };
        (is_code, text.lines().map(line).collect::<Vec<_>>().join("\n"))
    };
    body.split("    // %%").map(cell).collect()
}

/// The outputs of the code cells, in order: a cell ends where it shows something, or after its last line of print.
fn outputs() -> Vec<Value> {
    OUTPUTS.take();
    let mut number = 0;
    let mut show = |shown: &dyn Shown| {
        let svg = shown.figure(&mut number).to_svg();
        let data = json!({"image/svg+xml": lines(&svg)});
        OUTPUTS.with_borrow_mut(|out| {
            out.push(json!({"data": data, "execution_count": null, "metadata": {}, "output_type": "execute_result"}));
        });
    };
    cells::run(&mut show).unwrap();
    OUTPUTS.take()
}

fn notebook() -> String {
    let mut outputs = outputs().into_iter();
    let mut count = 0;
    let cell = |(i, (is_code, text)): (usize, (bool, String))| {
        let id = format!("cell-{}", i + 1);
        if !is_code {
            return json!({"cell_type": "markdown", "id": id, "metadata": {}, "source": lines(&text)});
        }
        count += 1;
        let shows = text.lines().last().is_some_and(|last| !last.ends_with(';') && !last.starts_with(':'));
        let puts_out = text.matches("println!").count() + usize::from(shows);
        let mut mine: Vec<Value> = outputs.by_ref().take(puts_out).collect();
        mine.iter_mut()
            .filter(|out| out.get("execution_count").is_some())
            .for_each(|out| out["execution_count"] = json!(count));
        json!({"cell_type": "code", "execution_count": count, "id": id, "metadata": {}, "outputs": mine, "source": lines(&text)})
    };
    let cells: Vec<Value> = source().into_iter().enumerate().map(cell).collect();
    assert_eq!(outputs.next(), None, "every output belongs to a cell");
    let metadata = json!({
        "kernelspec": {"display_name": "Rust", "language": "rust", "name": "rust"},
        "language_info": {"codemirror_mode": "rust", "file_extension": ".rs", "mimetype": "text/rust", "name": "Rust"},
    });
    let book = json!({"cells": cells, "metadata": metadata, "nbformat": 4, "nbformat_minor": 5});
    format!("{}\n", serde_json::to_string_pretty(&book).unwrap())
}

#[test]
fn the_notebook_holds_the_cells_and_what_they_show() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples/notebook.ipynb");
    let there = fs::read_to_string(&file).unwrap_or_default();
    let made = notebook();
    let book: Value = serde_json::from_str(&made).unwrap();
    let shown =
        book["cells"].as_array().unwrap().iter().flat_map(|cell| cell["outputs"].as_array().into_iter().flatten());
    assert_eq!(shown.filter(|out| out["data"].is_object()).count(), 4);
    if there.replace("\r\n", "\n") != made {
        let fresh = std::env::temp_dir().join("notebook.ipynb");
        fs::write(&fresh, &made).unwrap();
        panic!("{} is not what its cells make: {} is", file.display(), fresh.display());
    }
}
