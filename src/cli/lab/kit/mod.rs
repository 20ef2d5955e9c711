//! The sources of the whole program, for a grader that is built elsewhere: those that the packages below carry along,
//! and its own.

use dcel_kit::sources::{Texts, include_dir};
use dcel_lab::{KitBuild, Package, Sources};

/// What this package carries.
#[rustfmt::skip]
static TEXTS: Texts = dcel_kit::texts!(
    "src/cli/", "../../",
    folders: [
        "$CARGO_MANIFEST_DIR/compare", "$CARGO_MANIFEST_DIR/film", "$CARGO_MANIFEST_DIR/gallery",
        "$CARGO_MANIFEST_DIR/grade", "$CARGO_MANIFEST_DIR/lab", "$CARGO_MANIFEST_DIR/navmesh",
        "$CARGO_MANIFEST_DIR/play", "$CARGO_MANIFEST_DIR/sample", "$CARGO_MANIFEST_DIR/solid",
        "$CARGO_MANIFEST_DIR/walk",
    ],
    files: [
        "LICENSE-APACHE", "LICENSE-MIT", "answer.rs", "build.rs", "choice.rs", "completions.rs", "convert.rs",
        "delaunay.rs", "failure.rs", "figure.rs", "figure_kind.rs", "figures.rs", "gradebook.rs", "info.rs", "input.rs",
        "lib.rs", "locate.rs", "looks.rs", "main.rs", "man.rs", "old_words.rs", "output.rs", "overlay.rs", "picture.rs",
        "results.rs", "save.rs", "saved.rs", "script.rs", "signals.rs", "subject.rs", "tour.rs", "triangulate.rs",
        "validate.rs", "voronoi.rs", "waiting.rs",
    ]
);

/// What is generated beside the sources: where it goes, and its text.
const MADE: [(&str, &str); 4] = [
    ("Cargo.toml", include_str!("dcel-kit.toml.txt")),
    ("src/lab/Cargo.toml", include_str!("dcel-lab.toml.txt")),
    ("src/cli/Cargo.toml", include_str!("dcel.toml.txt")),
    ("Cargo.lock", include_str!("Cargo.lock.txt")),
];

/// The files of a folder in which `cargo install --locked --path src/cli` makes this program: path and text.
pub fn program_sources() -> Sources {
    let mut all = dcel_lab::sources(KitBuild::Program);
    all.extend(dcel_lab::texts_of(KitBuild::Program, &[(Package::Program, &TEXTS)]));
    all.extend(MADE.map(|(path, text)| (path.to_owned(), text)));
    all
}
