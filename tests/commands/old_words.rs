//! Words that have been replaced are still read, with a note on stderr, and mean the same.

use crate::shell::{Folder, TRIANGLE};
use dcel_kit::old_words::{Language, OLD_WORDS, OldWord};

fn notes(err: &str) -> Vec<&str> {
    err.lines().filter(|line| line.starts_with("note: `")).collect()
}

fn rows(language: Language) -> impl Iterator<Item = &'static OldWord> {
    OLD_WORDS.iter().filter(move |row| row.language == language)
}

#[test]
fn old_words_of_dcel_files_give_the_same_structure() {
    let folder = Folder::new();
    let mut text = TRIANGLE.to_owned();
    rows(Language::DcelFile).for_each(|row| text = text.replace(row.new, row.old));
    assert_ne!(text, TRIANGLE);
    folder.write("old.dcel", &text);
    let told = folder.dcel("convert old.dcel - --to dcel");
    assert_eq!(
        notes(&told.err),
        [
            "note: `boundary` is now called `half_edge`; the old word is read until version 1.0",
            "note: `rings` is now called `inner`; the old word is read until version 1.0",
        ],
    );
    assert_eq!(told.fine(), TRIANGLE);
    folder.write("both.dcel", &TRIANGLE.replace("inner none", "inner none boundary h1"));
    folder.dcel("info both.dcel").fails(2, "`half_edge`", "give each word once in a record");
}

#[test]
fn old_words_of_scripts_do_the_same() {
    let folder = Folder::new();
    let new = "rectangle\nsplit_face f1.half_edge.next f1.half_edge.prev.prev\ninsert_dangling_edge v0 -100 -100\n";
    let mut old = new.to_owned();
    rows(Language::Script).for_each(|row| old = old.replace(row.new, row.old));
    let [new, old] = [new, &old].map(|script| folder.dcel_with(script, "script - --dump"));
    assert_eq!((notes(&new.err).len(), notes(&old.err).len()), (0, rows(Language::Script).count()), "{old:?}");
    let dump = |out: &str| out[out.find("dcel 1").expect("a dump")..].to_owned();
    assert_eq!(dump(&new.fine()), dump(&old.fine()));
}

#[test]
fn old_arguments_do_the_same() {
    let folder = Folder::new();
    folder.write("a.dcel", TRIANGLE);
    let new = folder.dcel("figure a.dcel --pointers half-edge");
    let old = folder.dcel("figure a.dcel --pointers boundary");
    assert_eq!((notes(&new.err).len(), notes(&old.err).len()), (0, 1), "{}", old.err);
    assert_eq!(new.fine(), old.fine());
}
