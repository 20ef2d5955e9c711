//! The formats and how a file name or its first bytes decide between them.
//!
//! ```text
//!   name        extensions        read  write   holds
//!   obj         .obj               x     x      polygons, in space
//!   off         .off               x     x      polygons, in space
//!   ply         .ply               x     x      polygons, in space; text or binary
//!   ply-binary  .ply               x     x      the same, written as binary (little endian)
//!   stl         .stl               x     x      triangles in space, nothing shared; text or binary, written as text
//!   stl-binary  .stl               x     x      the same, written as binary, in single precision
//!   triangle    .node + .ele       x     x      triangles in the plane, two files
//!   geojson     .geojson .json     x     x      polygons with holes and names
//!   topojson    .topojson .json    x            the same, with shared borders
//!   mesh        .mesh              x     x      navigation meshes (polyanya; versions 2 and 3, written as 2)
//!   map         .map               x            grid maps of Moving AI, read as rectangles
//!   wkt         .wkt               x            polygons with holes; or points and segments
//!   poly        .poly              x            points, segments and holes of Triangle
//!   segments    .segments .cin     x            four numbers a line
//!   dcel        .dcel              x     x      everything, broken structures included
//!   tables      .tables .txt             x      the tables of the lecture slides
//! ```

use std::fmt;
use std::path::Path;
use std::str::FromStr;

/// A file format.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[non_exhaustive]
pub enum Format {
    /// Wavefront [OBJ](super::obj).
    Obj,
    /// [Object File Format](super::off) of Geomview.
    Off,
    /// [Polygon File Format](super::ply) of Stanford, any encoding; written as text.
    Ply,
    /// The same, written as binary, little endian.
    PlyBinary,
    /// [Stereolithography](super::stl), text or binary; written as text.
    Stl,
    /// The same, written as binary, in single precision.
    StlBinary,
    /// The [`.node` and `.ele`](super::triangle) files of Triangle.
    Triangle,
    /// [GeoJSON](super::geojson) (RFC 7946).
    GeoJson,
    /// [TopoJSON](super::topojson).
    TopoJson,
    /// [Navigation mesh](super::mesh) of polyanya, version 2 or 3; written as version 2.
    Mesh,
    /// [Grid map](super::grid) of the Moving AI benchmarks, read as rectangles.
    Map,
    /// [Well-known text](super::wkt): polygons, or segments if there is none.
    Wkt,
    /// The [`.poly`](super::poly) files of Triangle.
    Poly,
    /// [Plain segments](super::segments), four numbers a line.
    Segments,
    /// The kit's own [text](super::dcel).
    Dcel,
    /// The vertex, half-edge and face [tables](super::tables) of the lecture slides.
    Tables,
}

/// Name, ends of file names without the dot, and one line for people, in the order of [`Format::ALL`].
const ROWS: [(&str, &[&str], &str); 16] = [
    ("obj", &["obj"], "Wavefront OBJ: vertices and polygons in space"),
    ("off", &["off"], "Geomview OFF: vertices and polygons in space"),
    ("ply", &["ply"], "Stanford PLY, text or binary: vertices and polygons in space"),
    ("ply-binary", &["ply"], "Stanford PLY, written as binary (little endian)"),
    ("stl", &["stl"], "STL, text or binary: triangles in space; written as text"),
    ("stl-binary", &["stl"], "STL, written as binary, in single precision"),
    ("triangle", &["node", "ele"], "Triangle's .node and .ele: triangles in the plane, two files"),
    ("geojson", &["geojson", "json"], "GeoJSON: polygons with holes and names; lines, if there is no polygon"),
    ("topojson", &["topojson"], "TopoJSON: polygons with shared borders (read only)"),
    ("mesh", &["mesh"], "polyanya .mesh, versions 2 and 3: a navigation mesh"),
    ("map", &["map"], "Moving AI .map: a grid of cells, as rectangles (read only)"),
    ("wkt", &["wkt"], "well-known text: polygons with holes; lines and points, if there is no polygon (read only)"),
    ("poly", &["poly"], "Triangle's .poly: points, segments and holes (read only)"),
    ("segments", &["segments", "seg", "cin"], "plain segments: four numbers a line (read only)"),
    ("dcel", &["dcel"], "the kit's text: the whole structure, broken ones included"),
    ("tables", &["tables", "txt"], "the vertex, half-edge and face tables of the slides (write only)"),
];

/// The word is not the name of a format.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("`{name}` is not a format: choose one of {}", Format::ALL.map(Format::name).join(", "))]
pub struct UnknownFormat {
    name: String,
}

impl Format {
    /// All formats, in the order in which they are listed to people.
    pub const ALL: [Self; 16] = [
        Self::Obj,
        Self::Off,
        Self::Ply,
        Self::PlyBinary,
        Self::Stl,
        Self::StlBinary,
        Self::Triangle,
        Self::GeoJson,
        Self::TopoJson,
        Self::Mesh,
        Self::Map,
        Self::Wkt,
        Self::Poly,
        Self::Segments,
        Self::Dcel,
        Self::Tables,
    ];

    /// The word that names the format on the command line.
    #[must_use]
    pub const fn name(self) -> &'static str {
        ROWS[self as usize].0
    }

    /// The ends of file names that belong to it, without the dot.
    #[must_use]
    pub const fn extensions(self) -> &'static [&'static str] {
        ROWS[self as usize].1
    }

    /// One line for people.
    #[must_use]
    pub const fn describe(self) -> &'static str {
        ROWS[self as usize].2
    }

    /// Whether the kit can read it.
    #[must_use]
    pub const fn can_read(self) -> bool {
        !matches!(self, Self::Tables)
    }

    /// Whether the kit can write it.
    #[must_use]
    pub const fn can_write(self) -> bool {
        !matches!(self, Self::TopoJson | Self::Map | Self::Wkt | Self::Poly | Self::Segments)
    }

    /// The format that the end of a file name stands for, in capitals or not. A `.json` file counts as
    /// GeoJSON; its reader turns to TopoJSON when the file says that it is a topology.
    #[must_use]
    pub fn from_path(path: &Path) -> Option<Self> {
        let extension = path.extension()?.to_str()?.to_ascii_lowercase();
        Self::ALL.into_iter().find(|format| format.extensions().contains(&extension.as_str()))
    }
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for Format {
    type Err = UnknownFormat;

    /// Reads the [`name`](Format::name) of a format, or one of its extensions.
    fn from_str(name: &str) -> Result<Self, UnknownFormat> {
        let wanted = name.to_ascii_lowercase();
        let by_name = Self::ALL.into_iter().find(|format| format.name() == wanted);
        let by_extension = || Self::ALL.into_iter().find(|format| format.extensions().contains(&wanted.as_str()));
        by_name.or_else(by_extension).ok_or_else(|| UnknownFormat { name: name.to_owned() })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_and_extensions_lead_back_to_the_format() {
        for (i, format) in Format::ALL.into_iter().enumerate() {
            assert_eq!((format as usize, format.name().parse()), (i, Ok(format)));
        }
        assert_eq!(Format::from_path(Path::new("a/cube.OBJ")), Some(Format::Obj));
        assert_eq!(Format::from_path(Path::new("spiral.1.ele")), Some(Format::Triangle));
        assert_eq!(Format::from_path(Path::new("states.json")), Some(Format::GeoJson));
        assert_eq!(Format::from_path(Path::new("obj")), None);
        assert!("step".parse::<Format>().is_err());
    }
}
