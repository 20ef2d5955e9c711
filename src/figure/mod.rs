//! Figures: a half-edge structure as SVG.
//!
//! | task | begin with |
//! |---|---|
//! | draw a structure | [`structure()`], [`FigureOptions`] |
//! | enlarge a part of it | [`inset()`] |
//! | show its pointers | [`pointers`], [`focus()`], [`tables()`] |
//! | edits, step by step | [`Film`] |
//! | an algorithm, event by event | [`algorithms`], [`SketchFilm`] |
//! | a page to click through | [`page()`], [`Page`] |
//! | duals, Voronoi diagrams | [`dual()`], [`voronoi_cells`] |
//! | something of your own, alone or over a structure | [`sketch`] |
//! | colours, sizes | [`Style`], [`Palette`], [`Unit`], [`Overrides`] |
//!
//! Reading rules of every figure: arrows run on the left of their edge and their one-sided barb points to
//! their face; the outer face is hatched and named like any other; a hole face is hatched the other way.
//! Any view can be drawn, a broken one too: what cannot be drawn is listed in the [notes](Figure::notes).
//!
//! The bytes depend on the input alone: only `+ - * /` and `sqrt` are used on the way to a coordinate.
//!
//! ```
//! use dcel_kit::figure::{self, FigureOptions};
//! use dcel_kit::topology::{Dcel, Table};
//!
//! let mut table = Table::from_view(&Dcel::polygon(3)?);
//! for (vertex, position) in table.vertices.iter_mut().flatten().zip([[0.0, 0.0], [4.0, 0.0], [1.0, 3.0]]) {
//!     vertex.position = Some(position);
//! }
//! table.outer_face = Some(dcel_kit::FaceId::new(0));
//! let figure = figure::structure(&table, &FigureOptions::new("A triangle"))?;
//! assert!(figure.to_svg().contains("id=\"a-triangle-h0\""));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

// The files of this folder:
//
//   view ──> layout/  scale, level of detail, free places ──> structure/  elements, names, pointers ──> canvas/  SVG
//
//   canvas/     ink: shapes with classes, styles, widths of texts, SVG          knows nothing of structures
//   layout/     where things go                                                 knows the canvas
//   structure/  the structure figure, element by element                        knows both
//   sketch/     paths, cones, circles, badges …: drawings made of named parts, alone or over a structure
//   kinds/      one subject each: duals, Voronoi diagrams, paths, solids, records, tables …
//   flatten/    structures without coordinates, laid out
//   film/       edits, frame by frame                      page/   a page of HTML with a picture to walk in
//   notebook.rs  pictures below the cells of a notebook

pub(crate) mod canvas;
mod film;
mod flatten;
mod kinds;
pub(crate) mod layout;
mod notebook;
mod page;
pub mod sketch;
pub(crate) mod structure;

#[cfg(feature = "png")]
pub use canvas::pdf::PdfError;
#[cfg(feature = "png")]
pub use canvas::png::PngError;
pub use canvas::style::file::{ParseColourError, StyleError};
pub use canvas::style::{Colour, Palette, Style, Theme};
pub use canvas::unit::{ParseLengthError, Unit};
pub use film::{Fate, Film, Frame, SketchFilm, Slip, SlipError, SlipFilm, Written, algorithms};
#[cfg(feature = "script")]
pub use film::{Filmed, ScriptFilm};
pub use kinds::dual::{DualFigureError, dual};
pub use kinds::focus::focus;
pub use kinds::inset::inset;
pub use kinds::located::located;
#[cfg(feature = "navmesh")]
pub use kinds::navmesh;
pub use kinds::overlay::{overlay, region};
pub use kinds::panels::pointers;
pub use kinds::records::records;
pub use kinds::robustness::{NearlyCollinear, robustness};
#[cfg(feature = "solid")]
pub use kinds::solid::{Camera, HiddenLines, solid};
pub use kinds::structure::structure;
pub use kinds::tables::tables;
pub use kinds::triangulation::{delaunay, diagonals_of, triangulation};
pub use kinds::voronoi::{voronoi_cells, voronoi_edges};
pub use layout::options::{Detail, FaceLabels, FigureOptions};
pub use page::{Page, escaped, page};
pub use structure::overrides::{Overrides, OverridesError};
pub use structure::pointer::Pointers;

use crate::ids::{Element, FaceId, HalfEdgeId, VertexId};
use crate::plane::CoordinateError;

/// Why a structure cannot be drawn.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum FigureError {
    /// There are vertices, but none has a position.
    #[error(
        "{}: a figure needs x and y for at least one, for example {example}", if *.vertices == 1 { "the only vertex has no position".to_owned() } else { format!("none of the {vertices} vertices has a position") }
    )]
    NoPosition {
        /// The number of vertices.
        vertices: usize,
        /// The first of them.
        example: VertexId,
    },
    /// A face that was asked for does not exist.
    #[error("{}", crate::ids::Element::from(*face).missing(*faces, *faces))]
    UnknownFace {
        /// The face.
        face: FaceId,
        /// The number of faces.
        faces: usize,
    },
    /// A coordinate is not a number, infinite, or too large to compute with.
    #[error("{vertex}: {error}")]
    Coordinate {
        /// The vertex.
        vertex: VertexId,
        /// What is wrong with it.
        error: CoordinateError,
    },
    /// There is no such half-edge.
    #[error("{}", crate::ids::Element::from(*half_edge).missing(*count, *bound))]
    NoHalfEdge {
        /// The half-edge asked for.
        half_edge: HalfEdgeId,
        /// How many half-edges there are.
        count: usize,
        /// One more than the greatest number of a half-edge.
        bound: usize,
    },
    /// An element that is to be shown is not there, or not in the faces that are to be drawn.
    #[error("{element} is not in the drawing: check its number, and the faces that are to be drawn")]
    NotDrawn {
        /// The element.
        element: Element,
    },
    /// Pointers need half-edges, and these would be too short or too many.
    #[error(
        "no room for pointers: the half-edges are too short or too many to be drawn ({detail:?} is the level that \
         fits); try a greater width, or fix the level of detail"
    )]
    NoRoom {
        /// The level there is room for.
        detail: Detail,
    },
}

/// A finished drawing.
#[derive(Clone, Debug)]
pub struct Figure {
    pub(crate) scene: canvas::scene::Scene,
    pub(crate) detail: Detail,
    pub(crate) notes: Vec<String>,
}

impl Figure {
    /// The SVG document, with a line break at its end. The same figure always gives the same bytes.
    #[must_use]
    pub fn to_svg(&self) -> String {
        canvas::svg_out::document(&self.scene)
    }

    /// Width and height of the canvas in px.
    #[must_use]
    pub fn size(&self) -> (f64, f64) {
        (self.scene.size.x, self.scene.size.y)
    }

    /// How much is drawn.
    #[must_use]
    pub fn detail(&self) -> Detail {
        self.detail
    }

    /// What could not be drawn, one sentence a kind, with the elements. Empty for a sound structure.
    #[must_use]
    pub fn notes(&self) -> &[String] {
        &self.notes
    }
}
