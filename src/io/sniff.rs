//! The format of a file by its first bytes.

use super::format::Format;
use super::segments::is_segment;
use super::stl::is_binary;
use super::wkt::starts_geometry;

impl Format {
    /// The format that the first bytes of a file show: for standard input and unknown names.
    #[must_use]
    pub fn from_content(bytes: &[u8]) -> Option<Self> {
        if is_binary(bytes) {
            return Some(Self::Stl);
        }
        let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
        let text = String::from_utf8_lossy(&bytes[..bytes.len().min(4096)]);
        let mut lines = text.lines().map(str::trim).filter(|line| !line.is_empty() && !line.starts_with('#'));
        let first = lines.next()?;
        let word = first.split_ascii_whitespace().next()?;
        match word {
            "ply" => Some(Self::Ply),
            "solid" => Some(Self::Stl),
            "mesh" => Some(Self::Mesh),
            "type" => Some(Self::Map),
            "dcel" => Some(Self::Dcel),
            "v" | "vn" | "vt" | "f" | "o" | "g" | "s" | "mtllib" | "usemtl" => Some(Self::Obj),
            _ if word.starts_with(['{', '[']) => Some(Self::GeoJson),
            _ if starts_geometry(word) => Some(Self::Wkt),
            _ if is_segment(first) => Some(Self::Segments),
            _ if word.trim_start_matches(['S', 'T', 'C', 'N', '4', 'n']).starts_with("OFF") => Some(Self::Off),
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn first_bytes_tell_the_format() {
        let cases: [(&[u8], Option<Format>); 13] = [
            (b"solid cube\n facet normal 0 0 1\n", Some(Format::Stl)),
            (b"linestring(0 0, 1 1)", Some(Format::Wkt)),
            (b"# x y x y\n0 0 1.5 -2e3\n", Some(Format::Segments)),
            (b"0 0 1\n", None),
            (b"# a comment\n\nv 0 0 0\n", Some(Format::Obj)),
            (b"\xef\xbb\xbfCOFF\n", Some(Format::Off)),
            (b"ply\nformat ascii 1.0\n", Some(Format::Ply)),
            (b"  {\"type\":\"Topology\"}", Some(Format::GeoJson)),
            (b"mesh\r\n2\r\n", Some(Format::Mesh)),
            (b"type octile\nheight 1\n", Some(Format::Map)),
            (b"dcel 1\n", Some(Format::Dcel)),
            (b"hello\n", None),
            (b"", None),
        ];
        for (bytes, format) in cases {
            assert_eq!(Format::from_content(bytes), format, "{}", String::from_utf8_lossy(bytes));
        }
    }
}
