//! A figure as a page of paper. Cargo feature `png`.
//!
//! ```text
//!   Figure ──> SVG ──> usvg, with the fonts of `fonts/` and no others ──> krilla ──> PDF, its letters as letters
//! ```
//!
//! Lines stay lines, and text can be searched and copied: the letters that are used are embedded.

use super::png::{fonts, tree_of};
use crate::figure::Figure;
use krilla::Document;
use krilla::geom::Size;
use krilla::metadata::Metadata;
use krilla::page::PageSettings;
use krilla_svg::{SurfaceExt, SvgSettings};

/// Points of paper for each px of the size that a figure states: 72 and 96 to an inch.
const POINTS: f32 = 0.75;

/// Why a figure cannot become a page of paper.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum PdfError {
    /// The page would have no size, or be too large for paper.
    #[error("a page of {width} x {height} points is none that paper can have: choose another width")]
    Size {
        /// In points.
        width: String,
        /// In points.
        height: String,
    },
    /// The writer refused the drawing.
    #[error("the writer gave up: {message}; fewer elements may help, for example --detail tiles")]
    Writer {
        /// What it said.
        message: String,
    },
}

impl Figure {
    /// The figure as a PDF file of one page, of the size of the figure: a px is 0.75 points. The letters are those of the
    /// bundled DejaVu Sans, embedded; colours are those for light pages. Needs the feature `png`.
    ///
    /// Cost: as for the SVG.
    ///
    /// # Errors
    /// [`PdfError`].
    ///
    /// ```
    /// use dcel_kit::{figure, plane::Subdivision};
    /// let figure = figure::structure(&Subdivision::lab_rectangle(), &Default::default())?;
    /// assert!(figure.to_pdf()?.starts_with(b"%PDF-"));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn to_pdf(&self) -> Result<Vec<u8>, PdfError> {
        let refused = |message: String| PdfError::Writer { message };
        let tree = tree_of(self, fonts()).map_err(refused)?;
        let [width, height] = [tree.size().width(), tree.size().height()].map(|side| side * POINTS);
        let none = || PdfError::Size { width: width.to_string(), height: height.to_string() };
        let page = PageSettings::from_wh(width, height).ok_or_else(none)?;
        let size = Size::from_wh(width, height).ok_or_else(none)?;
        let mut document = Document::new();
        document.set_metadata(Metadata::new().title(self.scene.title.clone()));
        let mut page = document.start_page_with(page);
        let mut surface = page.surface();
        surface.draw_svg(&tree, size, SvgSettings::default()).ok_or_else(none)?;
        surface.finish();
        page.finish();
        document.finish().map_err(|error| refused(format!("{error:?}")))
    }
}
