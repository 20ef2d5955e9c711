//! What a reader gives back, and how it is asked.

use super::format::Format;
use super::soup::{PolygonSoup, SegmentSoup};
use crate::topology::{Table, TableColumns};

/// What a file holds.
#[derive(Clone, PartialEq, Debug)]
pub enum Document {
    /// Points and polygons, to be joined to a structure.
    Polygons(PolygonSoup),
    /// A half-edge structure, right or wrong.
    Table(Table),
    /// The same in columns, if it was asked for: see [`ReadOptions::columns`].
    Columns(TableColumns),
    /// Points and segments, to be cut and joined to a structure.
    Segments(SegmentSoup),
}

/// What was read, and what had to be left out.
#[derive(Clone, PartialEq, Debug)]
pub struct Read {
    /// The contents.
    pub document: Document,
    /// What was dropped, repaired or chosen, one sentence each: for the user.
    pub notes: Vec<String>,
    /// The format it was: of a JSON file what it says of itself, whatever its name.
    pub format: Format,
}

impl Read {
    /// How many rings were closed or dropped on the way, as the notes say.
    #[must_use]
    pub fn mended_rings(&self) -> usize {
        match &self.document {
            Document::Polygons(soup) => soup.mended_rings,
            Document::Segments(soup) => soup.mended_rings,
            Document::Table(_) | Document::Columns(_) => 0,
        }
    }
}

/// How to read.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct ReadOptions {
    /// The y of the file points down: negate it. That of grid maps is known to, and negated without this.
    pub y_down: bool,
    /// Drop rings of GeoJSON, TopoJSON and well-known text that enclose nothing, with a note, instead of refusing them: those
    /// with fewer than three distinct points, and those whose points all lie on one line, decided exactly. An outer ring takes
    /// its polygon with it.
    pub drop_degenerate_rings: bool,
    /// With the same, let an outer ring go by itself, for [`LoadOptions::mend`](super::LoadOptions::mend): the other rings
    /// of its polygon stay, behind an outer ring without corners, and [`mend_polygons`] takes them as outlines.
    ///
    /// [`mend_polygons`]: crate::plane::Subdivision::mend_polygons
    pub keep_inner_rings: bool,
    /// Close rings of GeoJSON and well-known text that do not end where they start, with a note, instead of refusing them.
    pub close_rings: bool,
    /// The object of a TopoJSON file to read; without it, the one with the most polygons, then lines, then points.
    pub object: Option<String>,
    /// Read polygons of GeoJSON, TopoJSON and well-known text as their outlines, together with the lines and points.
    /// Without it lines are read only if there is no polygon.
    pub outlines: bool,
    /// Give a half-edge structure in columns, which take less than half of the memory of a table.
    pub columns: bool,
    /// The format; without it, the file name or the first bytes decide.
    pub format: Option<Format>,
}
