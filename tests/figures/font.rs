//! The width table of the figures is that of the bundled fonts, read from the font files by a parser not ours.

use std::fmt::Write;
use std::path::{Path, PathBuf};
use ttf_parser::Face;

const REGULAR: &[u8] = include_bytes!("../../src/figure/canvas/fonts/DejaVuSans.ttf");
const BOLD: &[u8] = include_bytes!("../../src/figure/canvas/fonts/DejaVuSans-Bold.ttf");
const OBLIQUE: &[u8] = include_bytes!("../../src/figure/canvas/fonts/DejaVuSans-BoldOblique.ttf");

fn faces() -> [Face<'static>; 3] {
    [REGULAR, BOLD, OBLIQUE].map(|bytes| Face::parse(bytes, 0).unwrap())
}

fn advance(face: &Face<'_>, c: char) -> u16 {
    face.glyph_hor_advance(face.glyph_index(c).unwrap()).unwrap()
}

/// The characters of a face, in order.
fn characters(face: &Face<'_>) -> Vec<char> {
    let mut out = Vec::new();
    for table in face.tables().cmap.unwrap().subtables.into_iter().filter(ttf_parser::cmap::Subtable::is_unicode) {
        table.codepoints(|c| out.extend(char::from_u32(c).filter(|&c| face.glyph_index(c).is_some())));
    }
    out.sort_unstable();
    out.dedup();
    out
}

/// The widest of the two bold faces counts: labels of faces are oblique, names of vertices are not.
fn table() -> String {
    let [regular, bold, oblique] = faces();
    let characters = characters(&regular);
    assert!(characters == self::characters(&bold) && characters == self::characters(&oblique));
    let mut runs: Vec<Vec<char>> = Vec::new();
    for c in characters {
        match runs.last_mut() {
            Some(run) if *run.last().unwrap() as u32 + 1 == c as u32 => run.push(c),
            _ => runs.push(vec![c]),
        }
    }
    let mut out = String::from(
        "//! Advance widths of the bundled fonts. Written by `BLESS=1 cargo test --test figures`, which reads the fonts.\n\n\
         /// How many units the em has.\npub(crate) const EM: u16 = ",
    );
    let _ = write!(
        out,
        "{};\n\n/// Runs of characters: the first, the widths of the regular face, those of the wider bold one.\n\
         #[rustfmt::skip]\npub(crate) static RUNS: [(char, &[u16], &[u16]); {}] = [\n",
        regular.units_per_em(),
        runs.len()
    );
    for run in runs {
        let widths = |faces: &[&Face<'_>]| -> Vec<u16> {
            run.iter().map(|&c| faces.iter().map(|face| advance(face, c)).max().unwrap()).collect()
        };
        let lists = [widths(&[&regular]), widths(&[&bold, &oblique])];
        let _ = writeln!(out, "    ('\\u{{{:x}}}', {}, {}),", run[0] as u32, list(&lists[0]), list(&lists[1]));
    }
    out.push_str("];\n");
    out
}

/// `&[1, 2, 3]`, with a line break after every twentieth number.
fn list(numbers: &[u16]) -> String {
    let lines: Vec<String> =
        numbers.chunks(20).map(|line| line.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ")).collect();
    if lines.len() == 1 {
        format!("&[{}]", lines[0])
    } else {
        format!("&[\n        {},\n    ]", lines.join(",\n        "))
    }
}

#[test]
fn the_width_table_is_that_of_the_bundled_fonts() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../src/figure/canvas/advances.rs");
    if std::env::var_os("BLESS").is_some() {
        std::fs::write(&path, table()).unwrap();
    }
    let written = std::fs::read_to_string(&path).unwrap();
    assert!(written == table(), "advances.rs is not of these fonts: BLESS=1 cargo test --test figures");
}

#[test]
fn the_three_faces_are_what_their_names_say_and_all_light_enough() {
    let [regular, bold, oblique] = faces();
    let style = |face: &Face<'_>| (face.is_bold(), face.is_oblique() || face.is_italic());
    assert_eq!([style(&regular), style(&bold), style(&oblique)], [(false, false), (true, false), (true, true)]);
    assert!([REGULAR, BOLD, OBLIQUE].iter().map(|bytes| bytes.len()).sum::<usize>() < 128_000);
    for face in &faces() {
        let names =
            face.names().into_iter().filter(ttf_parser::name::Name::is_unicode).filter_map(|name| name.to_string());
        let names: Vec<String> = names.collect();
        assert!(names.iter().any(|name| name == "DejaVu Sans"), "the family that figures ask for: {names:?}");
        let licence = std::fs::read_to_string(fonts().join("LICENSE-dejavu")).unwrap();
        let first = licence.lines().next().unwrap();
        assert!(names.iter().any(|name| name.contains(first)), "the licence is inside, too");
    }
}

fn fonts() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../src/figure/canvas/fonts")
}

/// Every character that a reference figure writes is in the bundled fonts.
#[test]
fn the_fonts_have_all_that_the_reference_figures_write() {
    let known = characters(&faces()[0]);
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../figures");
    let mut texts = 0;
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|extension| extension != "svg") {
            continue;
        }
        let svg = std::fs::read_to_string(&path).unwrap();
        let document = roxmltree::Document::parse(&svg).unwrap();
        for text in document.descendants().filter(|node| node.tag_name().name() == "text") {
            let words = text.text().unwrap_or_default().trim();
            let strange: String = words.chars().filter(|c| !known.contains(c)).collect();
            assert!(strange.is_empty(), "{}: {words:?} has {strange:?}", path.display());
            texts += 1;
        }
    }
    assert!(texts > 500, "{texts}");
}
