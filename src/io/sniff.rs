//! The format of a file by its first bytes.

use super::blocks::Blocks;
use super::format::Format;
use super::problem::ReadError;
use super::segments::is_segment;
use super::stl::{is_binary, length_of_binary};
use super::text::LARGEST_FILE;
use super::wkt::starts_geometry;

impl Format {
    /// The format that the first bytes of a file show: for standard input and unknown names.
    #[must_use]
    pub fn from_content(bytes: &[u8]) -> Option<Self> {
        if is_binary(bytes) { Some(Self::Stl) } else { Self::from_text(bytes) }
    }

    /// The same of a text that is still to be read. If only its length can tell, it is read to its end.
    pub(super) fn from_start(blocks: &mut Blocks<'_>) -> Result<Option<Self>, ReadError> {
        let length = length_of_binary(blocks.peek()?).filter(|&length| length < LARGEST_FILE);
        if length.is_some() && blocks.known_length().is_none() {
            blocks.rest()?;
        }
        let known = blocks.known_length().map(|known| known as u64);
        let is_binary = length.is_some() && length == known;
        Ok(if is_binary { Some(Self::Stl) } else { Self::from_text(blocks.peek()?) })
    }

    fn from_text(bytes: &[u8]) -> Option<Self> {
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
