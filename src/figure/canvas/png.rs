//! A figure as pixels. Cargo feature `png`.
//!
//! ```text
//!   Figure ──> SVG ──> usvg, with the three fonts of `fonts/` and no others ──> tiny-skia ──> PNG
//! ```
//!
//! The pixels depend on the figure and the scale alone: fonts of the machine are never asked for. Whatever family the
//! style names, the letters are those of DejaVu Sans, since a family that is not there would mean no letters at all.
//! The colours are those for light pages, unless the style has none but dark ones.

use crate::figure::Figure;
use crate::figure::canvas::scene::{Group, Node};
use crate::figure::canvas::{svg_out, text};
use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{Options, Tree, fontdb};
use std::collections::BTreeSet;
use std::sync::Arc;

const FAMILY: &str = "DejaVu Sans";
const FONTS: [&[u8]; 3] = [
    include_bytes!("fonts/DejaVuSans.ttf"),
    include_bytes!("fonts/DejaVuSans-Bold.ttf"),
    include_bytes!("fonts/DejaVuSans-BoldOblique.ttf"),
];
/// No picture has more pixels: four bytes each.
const LARGEST: f64 = 1e8;

/// Why a figure cannot become pixels.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PngError {
    /// The scale is no number of pixels.
    #[error("a scale of {scale} draws nothing: choose 0.1 to 20, for example 2")]
    Scale {
        /// The scale asked for.
        scale: f64,
    },
    /// There would be more than 10^8 pixels.
    #[error("{width} x {height} pixels are too many: choose a smaller scale or a smaller width")]
    TooLarge {
        /// Pixels of a row.
        width: f64,
        /// Rows.
        height: f64,
    },
    /// The renderer refused the drawing.
    #[error("the renderer gave up: {message}; fewer elements may help, for example --detail tiles")]
    Renderer {
        /// What it said.
        message: String,
    },
}

impl Figure {
    /// The figure as a PNG file with `scale` (0.1 to 20) pixels for each px: 1 for screens, 2 for sharp ones, 4 for
    /// paper. The same figure and scale always give the same bytes. Needs the feature `png`.
    ///
    /// The letters are those of the bundled DejaVu Sans; characters it does not have become boxes, see
    /// [`without_glyph`](Self::without_glyph). A stepper is drawn as its strip.
    ///
    /// Cost: as for the SVG, and the pixels: a figure of 640 x 640 px takes some 20 ms at scale 2.
    ///
    /// # Errors
    /// [`PngError`].
    ///
    /// ```
    /// use dcel_kit::{figure, plane::Subdivision};
    /// let figure = figure::structure(&Subdivision::lab_rectangle(), &Default::default())?;
    /// assert!(figure.to_png(2.0)?.starts_with(b"\x89PNG"));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn to_png(&self, scale: f64) -> Result<Vec<u8>, PngError> {
        if !(0.1..=20.0).contains(&scale) {
            return Err(PngError::Scale { scale });
        }
        let [width, height] = [self.scene.size.x, self.scene.size.y].map(|side| (side * scale).round().max(1.0));
        if width * height > LARGEST {
            return Err(PngError::TooLarge { width, height });
        }
        let refused = |message: String| PngError::Renderer { message };
        let tree = tree_of(self, fonts()).map_err(refused)?;
        let mut pixels =
            Pixmap::new(width as u32, height as u32).ok_or_else(|| refused("no room for the pixels".to_owned()))?;
        // From the size that the file states (perhaps in cm) to that of the canvas, then to pixels.
        let stretch = |stated: f32, pixels: f64| pixels as f32 / stated;
        let by = Transform::from_scale(stretch(tree.size().width(), width), stretch(tree.size().height(), height));
        resvg::render(&tree, by, &mut pixels.as_mut());
        pixels.encode_png().map_err(|error| refused(error.to_string()))
    }

    /// The characters of the figure that the bundled font has no glyph for, each once, in order; empty as a rule.
    #[must_use]
    pub fn without_glyph(&self) -> String {
        let mut strange = BTreeSet::new();
        for node in &self.scene.nodes {
            collect(node, &mut strange);
        }
        strange.into_iter().collect()
    }
}

fn collect(node: &Node, strange: &mut BTreeSet<char>) {
    match node {
        Node::Group(Group { nodes, .. }) => nodes.iter().for_each(|node| collect(node, strange)),
        Node::Text { text, .. } => strange.extend(text.chars().filter(|&c| !text::has_glyph(c))),
        _ => {}
    }
}

/// The figure as the renderers read it, or what they say against it.
pub(super) fn tree_of(figure: &Figure, fonts: fontdb::Database) -> Result<Tree, String> {
    let options = Options { font_family: FAMILY.to_owned(), fontdb: Arc::new(fonts), ..Options::default() };
    Tree::from_str(&svg_out::document(&figure.scene), &options).map_err(|error| error.to_string())
}

/// The bundled fonts, and nothing else, for every family that can be asked for.
pub(super) fn fonts() -> fontdb::Database {
    let mut fonts = fontdb::Database::new();
    FONTS.into_iter().for_each(|font| fonts.load_font_data(font.to_vec()));
    fonts.set_serif_family(FAMILY);
    fonts.set_sans_serif_family(FAMILY);
    fonts.set_cursive_family(FAMILY);
    fonts.set_fantasy_family(FAMILY);
    fonts.set_monospace_family(FAMILY);
    fonts
}
