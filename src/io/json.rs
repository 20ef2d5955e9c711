//! What the two JSON formats have in common: the way in, the path of an element, the reading of values.
//!
//! A JSON file says itself whether it is GeoJSON or TopoJSON (`"type": "Topology"`). Errors of the syntax name
//! line and column; errors of the contents name the path of the element, as `features[3] "Ohio" polygon 0`.

use super::format::Format;
use super::problem::{ReadError, ReadProblem};
use super::read::{Document, Read, ReadOptions};
use super::rings::Rings;
use super::text::{check_text, line_and_column};
use super::{geojson, topojson};
use serde_json::{Map, Value};
use std::borrow::Cow;

/// A JSON object.
pub(super) type Object = Map<String, Value>;

/// Reads GeoJSON or TopoJSON. O(length), and O(n log n) to join n equal points.
pub(super) fn read(bytes: &[u8], source: &str, options: &ReadOptions) -> Result<Read, ReadError> {
    check_text(bytes, source)?;
    let text = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    let value: Value = serde_json::from_slice(text).map_err(|error| syntax_error(text, source, &error))?;
    let fail = |problem| ReadError::whole(source, problem, "");
    let mut notes = Vec::new();
    let kind = value.as_object().and_then(|root| root.get("type")).and_then(Value::as_str);
    let format = if kind == Some("Topology") { Format::TopoJson } else { Format::GeoJson };
    let rings = match kind {
        Some("Topology") => topojson::read(&value, options, &mut notes),
        Some(_) => geojson::read(&value, &mut notes),
        None => Err(Fault::from(shape("the file", "a GeoJSON or TopoJSON object with a \"type\""))),
    };
    let rings = rings.map_err(|fault| ReadError { help: fault.help, ..fail(fault.what) })?;
    let soup = rings.finish(source, options.drop_degenerate_rings, &mut notes)?;
    if soup.faces.face_count() == 0 {
        notes.push("the file holds no polygon".to_owned());
    }
    Ok(Read { document: Document::Polygons(soup), notes, format })
}

fn syntax_error(text: &[u8], source: &str, error: &serde_json::Error) -> ReadError {
    let message = error.to_string();
    let message = message.rfind(" at line ").map_or(message.as_str(), |end| &message[..end]);
    let line = error.line().max(1) as u32;
    // The parser counts bytes; people count characters.
    let starts = text.split(|&b| b == b'\n').take(line as usize - 1).map(|line| line.len() + 1).sum::<usize>();
    let (_, column) = line_and_column(&text[starts.min(text.len())..], error.column().saturating_sub(1));
    let problem = ReadProblem::Json { message: message.to_owned() };
    ReadError { line: Some(line), column: Some(column), ..ReadError::whole(source, problem, "") }
}

/// A problem with what to try.
pub(super) struct Fault {
    pub(super) what: ReadProblem,
    pub(super) help: Cow<'static, str>,
}

impl From<ReadProblem> for Fault {
    fn from(what: ReadProblem) -> Self {
        let help = match &what {
            ReadProblem::UnclosedRing { .. } => "repeat the first point of the ring at its end",
            _ => "",
        };
        Self { what, help: help.into() }
    }
}

/// The problem that a value has the wrong shape.
pub(super) fn shape(place: &str, wanted: impl Into<Cow<'static, str>>) -> ReadProblem {
    ReadProblem::Shape { place: place.to_owned(), wanted: wanted.into() }
}

/// The member `key` of an object, if it is an array.
pub(super) fn array<'a>(object: &'a Object, key: &str, place: &str) -> Result<&'a [Value], ReadProblem> {
    match object.get(key) {
        Some(Value::Array(values)) => Ok(values),
        _ => Err(shape(place, format!("an array \"{key}\""))),
    }
}

/// The array `value`.
pub(super) fn items<'a>(value: &'a Value, place: &str, what: &'static str) -> Result<&'a [Value], ReadProblem> {
    value.as_array().map(Vec::as_slice).ok_or_else(|| shape(place, what))
}

/// The object `value` and its `type`.
pub(super) fn typed<'a>(value: &'a Value, place: &str) -> Result<(&'a Object, &'a str), ReadProblem> {
    let object = value.as_object().ok_or_else(|| shape(place, "an object"))?;
    let name = object.get("type").and_then(Value::as_str).ok_or_else(|| shape(place, "a \"type\""))?;
    Ok((object, name))
}

/// The name of a feature: `properties.name`, `properties.NAME`, or its `id`.
pub(super) fn feature_name(feature: &Object) -> Option<String> {
    let properties = feature.get("properties").and_then(Value::as_object);
    let named = properties.and_then(|p| p.get("name").filter(|v| v.is_string()).or_else(|| p.get("NAME")));
    [named, feature.get("id")].into_iter().flatten().find_map(|value| match value {
        Value::String(name) => Some(name.clone()),
        Value::Number(number) => Some(number.to_string()),
        _ => None,
    })
}

/// Geometries that are not polygons, counted.
#[derive(Default)]
pub(super) struct Skipped {
    points: usize,
    lines: usize,
}

impl Skipped {
    /// Counts a geometry by its type; false if there is no such type.
    pub(super) fn add(&mut self, kind: &str) -> bool {
        match kind {
            "Point" | "MultiPoint" => self.points += 1,
            "LineString" | "MultiLineString" => self.lines += 1,
            _ => return false,
        }
        true
    }

    /// Says what was skipped.
    pub(super) fn note(&self, notes: &mut Vec<String>) {
        let mut add = |count: usize, what: &str| {
            if count > 0 {
                notes.push(format!("{count} {what} skipped: only polygons are read"));
            }
        };
        add(self.lines, "line geometries were");
        add(self.points, "point geometries were");
    }
}

/// Reads the polygons of a geometry with the help of a reader of rings. `one` says whether `value` is a single
/// polygon rather than an array of them.
pub(super) fn polygons(
    value: &[Value],
    one: bool,
    place: &str,
    name: Option<&str>,
    rings: &mut Rings,
    read_ring: &mut dyn FnMut(&Value, &str, &mut Rings) -> Result<(), ReadProblem>,
) -> Result<usize, ReadProblem> {
    let mut polygon = |p: usize, polygon: &[Value]| {
        let path = format!("{place} polygon {p}");
        rings.begin_polygon(&path, name);
        for (r, ring) in polygon.iter().enumerate() {
            read_ring(ring, &format!("{path} ring {r}"), rings)?;
        }
        Ok(usize::from(rings.end_polygon()))
    };
    if one {
        return polygon(0, value);
    }
    let mut empty = 0;
    for (p, value) in value.iter().enumerate() {
        empty += polygon(p, items(value, &format!("{place} polygon {p}"), "an array of rings")?)?;
    }
    Ok(empty)
}
