//! What is fuzzed: plain functions of bytes that panic where a promise of the kit is broken.
//!
//! ```text
//!   bytes ──▶ target ──▶ Outcome (what came of it, roughly)      or a panic: a promise is broken
//!     ▲                      │
//!     └── mutate.rs ◀────────┘ new outcomes are mutated further     replay.rs  the runner for the stable toolchain
//!                                                                   libFuzzer  the same functions, led by coverage
//! ```
//!
//! Promises of every target: no panic, no hang, no more memory than the input justifies; an error says something and
//! names a place; what was read and built obeys all invariants; what is written is read back as the same.
//!
//! ```text
//!   readers.rs     every format of `dcel_kit::io`, lists of points, scenarios; then built, written and read again
//!   structures.rs  polygons and segments out of bytes, with all options of the builders
//!   texts.rs       scripts, figure styles, drawings that are compared
//!   labs.rs        what a student's program prints, the files of a lab, a file that is handed in
//! ```

#![forbid(unsafe_code)]
#![warn(missing_docs)]

mod bytes;
mod labs;
mod readers;
mod structures;
mod texts;

/// What came of an input: equal numbers for the same kind of answer. Leads the runner, which sees no coverage.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Outcome(pub u64);

impl Outcome {
    /// Out of a message or a description. Numbers and what is quoted do not count.
    #[must_use]
    pub fn of(text: &str) -> Self {
        let mut hash = 0xcbf2_9ce4_8422_2325_u64;
        let mut quoted = false;
        for c in text.chars().take(400) {
            if matches!(c, '`' | '"') {
                quoted = !quoted;
            } else if !quoted && !c.is_ascii_digit() {
                hash = (hash ^ u64::from(c)).wrapping_mul(0x0000_0100_0000_01b3);
            }
        }
        Self(hash)
    }

    /// Both outcomes.
    #[must_use]
    pub fn and(self, other: Self) -> Self {
        Self(self.0.rotate_left(7) ^ other.0)
    }
}

/// A function that panics where a promise is broken.
pub type Target = fn(&[u8]) -> Outcome;

/// The targets by name. The name is that of the folder in `corpus/`, of the dictionary in `words/`, and of the program
/// for libFuzzer.
pub const TARGETS: [(&str, Target); 23] = [
    ("obj", readers::obj),
    ("off", readers::off),
    ("ply", readers::ply),
    ("stl", readers::stl),
    ("triangle", readers::triangle),
    ("geojson", readers::geojson),
    ("topojson", readers::topojson),
    ("mesh", readers::mesh),
    ("map", readers::map),
    ("wkt", readers::wkt),
    ("poly", readers::poly),
    ("segments", readers::segments),
    ("dcel", readers::dcel),
    ("points", readers::points),
    ("scenario", readers::scenario),
    ("from_polygons", structures::from_polygons),
    ("from_segments", structures::from_segments),
    ("script", texts::script),
    ("compare", texts::compare),
    ("figure_files", texts::figure_files),
    ("protocol", labs::protocol),
    ("lab_files", labs::lab_files),
    ("submission", labs::submission),
];

/// The target of this name.
#[must_use]
pub fn find(name: &str) -> Option<Target> {
    TARGETS.iter().find(|(known, _)| *known == name).map(|(_, target)| *target)
}

/// The program of a target for libFuzzer.
#[cfg(feature = "libfuzzer")]
#[macro_export]
macro_rules! program {
    ($name:literal) => {
        $crate::fuzz_target!(|data: &[u8]| {
            $crate::find($name).expect("a target of this name")(data);
        });
    };
}
#[cfg(feature = "libfuzzer")]
#[doc(hidden)]
pub use libfuzzer_sys::fuzz_target;

/// The two files of an input that holds two: what stands before and after a line of two percent signs.
fn halves(data: &[u8]) -> (&[u8], &[u8]) {
    const CUT: &[u8] = b"%%\n";
    match data.windows(CUT.len()).position(|window| window == CUT) {
        Some(at) => (&data[..at], &data[at + CUT.len()..]),
        None => (data, &[]),
    }
}

/// What ends a line.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Ends {
    /// LF, CR LF or CR: in the formats of [`dcel_kit::io`].
    Any,
    /// LF or CR LF.
    Lf,
}

/// Claims that a place is one of the text, with lines that end as `ends` says: the line is there, and the column is no
/// further than just behind its end.
fn assert_place(text: &[u8], ends: Ends, line: u64, column: Option<u64>, message: &str) {
    let text = String::from_utf8_lossy(text);
    let mut text = text.strip_prefix('\u{feff}').unwrap_or(&text).replace("\r\n", "\n");
    if ends == Ends::Any {
        text = text.replace('\r', "\n");
    }
    let lines: Vec<&str> = text.split('\n').collect();
    let wanted = usize::try_from(line).unwrap_or(usize::MAX).checked_sub(1);
    let found = wanted.and_then(|i| lines.get(i));
    assert!(found.is_some(), "line {line} of {}: {message}", lines.len());
    if let (Some(column), Some(found)) = (column, found) {
        let end = found.chars().count() as u64 + 1;
        assert!((1..=end).contains(&column), "column {column} of a line of {}: {message}", end - 1);
    }
}

#[cfg(test)]
mod tests {
    use super::TARGETS;
    use std::collections::BTreeSet;
    use std::path::Path;

    /// A target that nobody runs, and a corpus that nobody reads, are told here.
    #[test]
    fn every_target_has_its_corpus_its_words_and_its_program() {
        let home = Path::new(env!("CARGO_MANIFEST_DIR"));
        let names: BTreeSet<String> = TARGETS.iter().map(|(name, _)| (*name).to_owned()).collect();
        for folder in ["corpus", "words", "libfuzzer"] {
            let entries = std::fs::read_dir(home.join(folder)).unwrap_or_else(|error| panic!("{folder}: {error}"));
            let found = entries.map(|entry| Path::new(&entry.expect("an entry").file_name()).with_extension(""));
            let found: BTreeSet<String> = found.map(|name| name.display().to_string()).collect();
            assert_eq!(found, names, "{folder}");
        }
        let manifest = std::fs::read_to_string(home.join("Cargo.toml")).expect("a manifest");
        for name in names {
            assert!(manifest.contains(&format!("name = \"{name}\"\n")), "Cargo.toml names no program {name}");
        }
    }
}
