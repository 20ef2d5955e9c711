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

use std::path::Path;
use std::str::FromStr;

crate::named! {
    /// A file format.
    #[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
    #[non_exhaustive]
    pub enum Format {
        /// Wavefront [OBJ](super::obj).
        Obj = "obj",
        /// [Object File Format](super::off) of Geomview.
        Off = "off",
        /// [Polygon File Format](super::ply) of Stanford, any encoding; written as text.
        Ply = "ply",
        /// The same, written as binary, little endian.
        PlyBinary = "ply-binary",
        /// [Stereolithography](super::stl), text or binary; written as text.
        Stl = "stl",
        /// The same, written as binary, in single precision.
        StlBinary = "stl-binary",
        /// The [`.node` and `.ele`](super::triangle) files of Triangle.
        Triangle = "triangle",
        /// [GeoJSON](super::geojson) (RFC 7946).
        GeoJson = "geojson",
        /// [TopoJSON](super::topojson).
        TopoJson = "topojson",
        /// [Navigation mesh](super::mesh) of polyanya, version 2 or 3; written as version 2.
        Mesh = "mesh",
        /// [Grid map](super::grid) of the Moving AI benchmarks, read as rectangles.
        Map = "map",
        /// [Well-known text](super::wkt): polygons, or segments if there is none.
        Wkt = "wkt",
        /// The [`.poly`](super::poly) files of Triangle.
        Poly = "poly",
        /// [Plain segments](super::segments), four numbers a line.
        Segments = "segments",
        /// The kit's own [text](super::dcel).
        Dcel = "dcel",
        /// The vertex, half-edge and face [tables](super::tables) of the lecture slides.
        Tables = "tables",
    }

    /// The word that names the format on the command line.
    fn name as Display;
    /// All formats, in the order in which they are listed to people.
    const ALL;
}

/// Ends of file names without the dot, and one line for people, in the order of [`Format::ALL`].
const ROWS: [(&[&str], &str); 16] = [
    (&["obj"], "Wavefront OBJ: vertices and polygons in space"),
    (&["off"], "Geomview OFF: vertices and polygons in space"),
    (&["ply"], "Stanford PLY, text or binary: vertices and polygons in space"),
    (&["ply"], "Stanford PLY, written as binary (little endian)"),
    (&["stl"], "STL, text or binary: triangles in space; written as text"),
    (&["stl"], "STL, written as binary, in single precision"),
    (&["node", "ele"], "Triangle's .node and .ele: triangles in the plane, two files"),
    (&["geojson", "json"], "GeoJSON: polygons with holes and names; lines, if there is no polygon"),
    (&["topojson"], "TopoJSON: polygons with shared borders (read only)"),
    (&["mesh"], "polyanya .mesh, versions 2 and 3: a navigation mesh"),
    (&["map"], "Moving AI .map: a grid of cells, as rectangles (read only)"),
    (&["wkt"], "well-known text: polygons with holes; lines and points, if there is no polygon (read only)"),
    (&["poly"], "Triangle's .poly: points, segments and holes (read only)"),
    (&["segments", "seg", "cin"], "plain segments: four numbers a line (read only)"),
    (&["dcel"], "the kit's text: the whole structure, broken ones included"),
    (&["tables", "txt"], "the vertex, half-edge and face tables of the slides (write only)"),
];

/// The word is not the name of a format.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("`{name}` is not a format: choose one of {}", Format::ALL.map(Format::name).join(", "))]
pub struct UnknownFormat {
    name: String,
}

impl Format {
    /// The ends of file names that belong to it, without the dot.
    #[must_use]
    pub const fn extensions(self) -> &'static [&'static str] {
        ROWS[self as usize].0
    }

    /// One line for people.
    #[must_use]
    pub const fn describe(self) -> &'static str {
        ROWS[self as usize].1
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
