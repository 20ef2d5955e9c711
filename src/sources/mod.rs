//! Texts of this package, for the packages `dcel-lab` and `dcel`: a published package reads nothing outside of its own
//! folder, so each of them hands out its own files.
//!
//! ```text
//!   dcel-kit ──▶ TEXTS             the files that a student's folder and an autograder are built from
//!            └─▶ the constants     the playground; the map, the grid and the scripts that samples, tour and figures begin with
//! ```
//!
//! Folders are carried whole: which of their files a build reads is found out by whoever lays them out. No part of the
//! public interface: it changes with every file.

pub use include_dir;

use include_dir::Dir;

/// Texts of a package, by where they stand in the checkout.
#[derive(Debug)]
pub struct Texts {
    /// The folder of the package, with a `/` at the end unless it is the root.
    pub package: &'static str,
    /// Its folders: path from `$CARGO_MANIFEST_DIR/` on, and what is in it.
    pub folders: &'static [(&'static str, Dir<'static>)],
    /// Files beside them: path inside of the package, and text.
    pub files: &'static [(&'static str, &'static str)],
}

impl Texts {
    /// The text of a file by its path in the checkout, if this package carries it.
    #[must_use]
    pub fn get(&self, path: &str) -> Option<&'static str> {
        let inside = path.strip_prefix(self.package)?;
        let file = self.files.iter().find(|(name, _)| *name == inside).map(|(_, text)| *text);
        file.or_else(|| {
            self.folders.iter().find_map(|(folder, files)| {
                let folder = folder.strip_prefix("$CARGO_MANIFEST_DIR/")?;
                files.get_file(inside.strip_prefix(folder)?.strip_prefix('/')?)?.contents_utf8()
            })
        })
    }
}

/// The [`Texts`] of a package: its folder, the way there from the file that calls this, its folders, its other files.
#[doc(hidden)]
#[macro_export]
macro_rules! texts {
    ($package:literal, $up:literal, folders: [$($folder:tt),* $(,)?], files: [$($file:literal),* $(,)?]) => {
        $crate::sources::Texts {
            package: $package,
            folders: &[$(($folder, include_dir::include_dir!($folder))),*],
            files: &[$(($file, include_str!(concat!($up, $file)))),*],
        }
    };
}

/// What this package carries.
#[rustfmt::skip]
pub static TEXTS: Texts = texts!(
    "", "../../",
    folders: [
        "$CARGO_MANIFEST_DIR/figures/data", "$CARGO_MANIFEST_DIR/figures/scripts", "$CARGO_MANIFEST_DIR/src/compare",
        "$CARGO_MANIFEST_DIR/src/edits", "$CARGO_MANIFEST_DIR/src/figure", "$CARGO_MANIFEST_DIR/src/files",
        "$CARGO_MANIFEST_DIR/src/geometry", "$CARGO_MANIFEST_DIR/src/io", "$CARGO_MANIFEST_DIR/src/navmesh",
        "$CARGO_MANIFEST_DIR/src/plane", "$CARGO_MANIFEST_DIR/src/play", "$CARGO_MANIFEST_DIR/src/script",
        "$CARGO_MANIFEST_DIR/src/solid", "$CARGO_MANIFEST_DIR/src/sources", "$CARGO_MANIFEST_DIR/src/topology",
    ],
    files: [
        "LICENSE-APACHE", "LICENSE-MIT", "figures/cube.svg", "figures/difference.svg", "figures/dual.svg",
        "figures/playground.html", "figures/rectangle.svg", "figures/rings.svg", "figures/triangulation.svg", "src/ids.rs", "src/lib.rs",
        "src/old_words.rs", "src/progress.rs",
    ]
);

/// The playground, as one page.
pub const PLAYGROUND: &str = include_str!("../../figures/playground.html");
/// The states of the USA, as TopoJSON with y down.
pub const STATES: &[u8] = include_bytes!("../../figures/data/states-albers-10m.json");
/// A grid map of some rooms.
pub const ROOMS_MAP: &[u8] = include_bytes!("../../figures/data/rooms.map");
/// Queries on [`ROOMS_MAP`], with the lengths of the paths.
pub const ROOMS_SCEN: &[u8] = include_bytes!("../../figures/data/rooms.scen");
/// The lab's structure from a rectangle.
pub const LAB: &str = include_str!("../../figures/scripts/lab.dcels");
/// The drawing of lab 04.
pub const LAB_04_DRAWING: &str = include_str!("../../figures/scripts/lab-04-drawing.dcels");
/// The colours of its faces.
pub const LAB_04_COLOURS: &str = include_str!("../../figures/scripts/lab-04-drawing.colours");
/// One join of two faces.
pub const JOIN_FACES: &str = include_str!("../../figures/scripts/join-faces.dcels");
/// One split of a face.
pub const SPLIT_FACE: &str = include_str!("../../figures/scripts/split-face.dcels");
/// One split of an edge at its midpoint.
pub const SPLIT_IN_HALF: &str = include_str!("../../figures/scripts/split-in-half.dcels");
