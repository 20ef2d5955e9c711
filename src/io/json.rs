//! GeoJSON or TopoJSON, whichever the file says it is.
//!
//! A JSON file says itself whether it is GeoJSON or TopoJSON (`"type": "Topology"`). Members that the kit does
//! not use are stepped over. Coordinates and arcs stay text until their place is known (see `arrays.rs`), so
//! that an error can name both the line and the element: `features[3] "Ohio" polygon 0 ring 1`.

use super::document::{Document, Read, ReadOptions};
use super::format::Format;
use super::nodes::{Fault, Node, shape};
use super::problem::{ReadError, ReadProblem};
use super::text::{check_text, line_and_column};
use super::{geojson, topojson};
use std::borrow::Cow;

/// Reads GeoJSON or TopoJSON. O(length), and O(n log n) to join n equal points.
pub(super) fn read(bytes: &[u8], source: &str, options: &ReadOptions) -> Result<Read, ReadError> {
    check_text(bytes, source)?;
    let at_byte =
        |at: usize, what, help: Cow<'static, str>| ReadError::at(source, line_and_column(bytes, at), what, help);
    let text = std::str::from_utf8(bytes)
        .map_err(|error| at_byte(error.valid_up_to(), ReadProblem::NotText, "save the file as UTF-8 text".into()))?;
    let root: Node<'_> = parse(text.strip_prefix('\u{feff}').unwrap_or(text), source)?;
    let mut notes = Vec::new();
    let (format, shapes) = match root.kind().as_deref() {
        Some("Topology") => (Format::TopoJson, topojson::read(&root, text, source, options, &mut notes)),
        _ => (Format::GeoJson, geojson::read(&root, text, source, options, &mut notes)),
    };
    let named = |fault: Fault| match fault.at {
        Some(at) => at_byte(at, fault.what, fault.help),
        None => ReadError::whole(source, fault.what, fault.help),
    };
    let rings = match shapes.map_err(named)? {
        geojson::Shapes::Rings(rings) => rings,
        geojson::Shapes::Segments(soup) => {
            return Ok(Read { document: Document::Segments(soup.checked()?), notes, format });
        }
    };
    let soup = rings.finish(source, options, bytes, &mut notes).map_err(named)?;
    Ok(Read { document: Document::Polygons(soup), notes, format })
}

fn parse<'a>(text: &'a str, source: &str) -> Result<Node<'a>, ReadError> {
    if text.trim_start().starts_with('[') {
        let wanted = "a GeoJSON or TopoJSON object with a \"type\"";
        return Err(ReadError::whole(source, shape("the file", wanted), ""));
    }
    serde_json::from_str(text).map_err(|error| {
        let message = error.to_string();
        let message = message.rfind(" at line ").map_or(message.as_str(), |end| &message[..end]);
        // The parser ends lines at LF alone and counts bytes.
        let before: usize = text.split_inclusive('\n').take(error.line().max(1) - 1).map(str::len).sum();
        let place = line_and_column(text.as_bytes(), before + error.column().saturating_sub(1));
        ReadError::at(source, place, ReadProblem::Json { message: message.to_owned() }, "")
    })
}
