//! What the two JSON formats have in common: the way in, the members they use, the path of an element.
//!
//! A JSON file says itself whether it is GeoJSON or TopoJSON (`"type": "Topology"`). Members that the kit does
//! not use are stepped over. Coordinates and arcs stay text until their place is known (see `arrays.rs`), so
//! that an error can name both the line and the element: `features[3] "Ohio" polygon 0 ring 1`.

use super::arrays::Arrays;
use super::format::Format;
use super::problem::{ReadError, ReadProblem};
use super::read::{Document, Read, ReadOptions};
use super::rings::Rings;
use super::text::{check_text, line_and_column, lines_and_columns};
use super::words::counted;
use super::{geojson, topojson};
use serde::Deserialize;
use serde_json::value::RawValue;
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::fmt;

/// Any object of the two formats with the members the kit uses.
#[derive(Deserialize)]
#[serde(expecting = "an object")]
pub(super) struct Node<'a> {
    #[serde(borrow, rename = "type")]
    kind: Option<&'a RawValue>,
    #[serde(borrow)]
    pub(super) features: Option<Vec<Node<'a>>>,
    #[serde(borrow)]
    pub(super) geometry: Option<Box<Node<'a>>>,
    #[serde(borrow)]
    pub(super) geometries: Option<Vec<Node<'a>>>,
    #[serde(borrow)]
    pub(super) objects: Option<BTreeMap<String, Node<'a>>>,
    #[serde(borrow)]
    pub(super) transform: Option<Box<Transform<'a>>>,
    #[serde(borrow)]
    pub(super) coordinates: Option<&'a RawValue>,
    #[serde(borrow)]
    pub(super) arcs: Option<&'a RawValue>,
    #[serde(borrow)]
    properties: Option<Properties<'a>>,
    #[serde(borrow)]
    id: Option<&'a RawValue>,
}

/// The transform of a quantised topology.
#[derive(Deserialize)]
#[serde(expecting = "an object")]
pub(super) struct Transform<'a> {
    #[serde(borrow)]
    pub(super) scale: Option<&'a RawValue>,
    #[serde(borrow)]
    pub(super) translate: Option<&'a RawValue>,
}

#[derive(Deserialize)]
#[serde(expecting = "an object")]
struct Properties<'a> {
    #[serde(borrow)]
    name: Option<&'a RawValue>,
    #[serde(borrow, rename = "NAME")]
    upper_name: Option<&'a RawValue>,
}

/// Reads GeoJSON or TopoJSON. O(length), and O(n log n) to join n equal points.
pub(super) fn read(bytes: &[u8], source: &str, options: &ReadOptions) -> Result<Read, ReadError> {
    check_text(bytes, source)?;
    let at_byte = |at: usize, what, help: Cow<'static, str>| {
        let (line, column) = line_and_column(bytes, at);
        ReadError { line: Some(line), column: Some(column), ..ReadError::whole(source, what, help) }
    };
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
    let soup = rings
        .finish(source, options.drop_degenerate_rings, |offsets| lines_and_columns(bytes, offsets), &mut notes)
        .map_err(named)?;
    if soup.faces.face_count() == 0 {
        notes.push("the file holds no polygon".to_owned());
    }
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
        let line = error.line().max(1);
        // The parser counts bytes; people count characters.
        let before = text.split('\n').nth(line - 1).unwrap_or("").as_bytes();
        let (_, column) = line_and_column(before, error.column().saturating_sub(1));
        let problem = ReadProblem::Json { message: message.to_owned() };
        ReadError { line: Some(line as u32), column: Some(column), ..ReadError::whole(source, problem, "") }
    })
}

/// A problem with what to try, and where in the file it is.
pub(super) struct Fault {
    pub(super) what: ReadProblem,
    pub(super) help: Cow<'static, str>,
    pub(super) at: Option<usize>,
}

impl Fault {
    /// A problem at a byte of the file.
    pub(super) fn at(at: usize, what: ReadProblem) -> Self {
        Self { at: Some(at), ..Self::from(what) }
    }
}

impl From<ReadProblem> for Fault {
    fn from(what: ReadProblem) -> Self {
        let help = match &what {
            ReadProblem::UnclosedRing { .. } => {
                "repeat the first point of the ring at its end, or close such rings with --mend"
            }
            ReadProblem::DegenerateRing { .. } => {
                "correct the data, or drop such rings with --drop-degenerate-rings or --mend"
            }
            _ => "",
        };
        Self { what, help: help.into(), at: None }
    }
}

/// The problem that an element has the wrong shape.
pub(super) fn shape(place: &str, wanted: impl Into<Cow<'static, str>>) -> ReadProblem {
    ReadProblem::Shape { place: place.to_owned(), wanted: wanted.into() }
}

/// The problem that an element lacks a member.
pub(super) fn lacks(place: &str, member: &str) -> ReadProblem {
    shape(place, format!("an array \"{member}\""))
}

impl<'a> Node<'a> {
    /// The `type`; none if there is none.
    pub(super) fn kind(&self) -> Option<Cow<'a, str>> {
        self.kind.and_then(string)
    }

    /// The `type`, which must be there.
    pub(super) fn need_kind(&self, place: &str) -> Result<Cow<'a, str>, ReadProblem> {
        self.kind().ok_or_else(|| shape(place, "a \"type\""))
    }

    /// The name of a feature: `properties.name`, `properties.NAME`, or its `id`.
    pub(super) fn name(&self) -> Option<Cow<'a, str>> {
        let properties = self.properties.as_ref();
        let names = [properties.and_then(|p| p.name), properties.and_then(|p| p.upper_name), self.id];
        names.into_iter().flatten().find_map(|value| match value.get().as_bytes() {
            [b'\"', ..] => string(value),
            [b'-' | b'0'..=b'9', ..] => Some(value.get().into()),
            _ => None,
        })
    }
}

/// The text of a JSON string.
fn string(value: &RawValue) -> Option<Cow<'_, str>> {
    let inside = value.get().strip_prefix('"')?.strip_suffix('"')?;
    if inside.contains('\\') { serde_json::from_str(value.get()).ok().map(Cow::Owned) } else { Some(inside.into()) }
}

/// The path of an element with its name: `features[3] "Ohio"`.
pub(super) fn named(path: &str, name: Option<&str>) -> String {
    name.map_or_else(|| path.to_owned(), |name| format!("{path} {name:?}"))
}

/// The place of a ring in a geometry.
#[derive(Clone, Copy)]
pub(super) struct Place<'a> {
    pub(super) path: &'a str,
    pub(super) polygon: usize,
    pub(super) ring: usize,
}

impl fmt::Display for Place<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { path, polygon, ring } = self;
        write!(f, "{path} polygon {polygon} ring {ring}")
    }
}

/// How a format reads the ring at hand.
pub(super) type ReadRing<'r> = dyn FnMut(&mut Arrays<'_>, Place<'_>, &mut Rings) -> Result<(), Fault> + 'r;

/// Reads the one polygon or the many of a geometry. Returns how many of them had no ring and were left out.
pub(super) fn polygons(
    arrays: &mut Arrays<'_>,
    one: bool,
    path: &str,
    name: Option<&str>,
    rings: &mut Rings,
    read_ring: &mut ReadRing<'_>,
) -> Result<usize, Fault> {
    let mut empty = 0;
    let mut polygon = |arrays: &mut Arrays<'_>, polygon: usize| {
        rings.begin_polygon(format_args!("{path} polygon {polygon}"), name);
        arrays.each(
            || shape(&format!("{path} polygon {polygon}"), "an array of rings"),
            |arrays, ring| {
                let at = arrays.offset();
                let place = Place { path, polygon, ring };
                read_ring(arrays, place, rings)?;
                rings.end_ring(at, || place.to_string()).map_err(|problem| Fault::at(at, problem))
            },
        )?;
        empty += usize::from(rings.end_polygon());
        Ok(())
    };
    if one {
        polygon(arrays, 0)?;
    } else {
        arrays.each(|| shape(path, "an array of polygons"), polygon)?;
    }
    Ok(empty)
}

/// Geometries that are not polygons, counted.
#[derive(Default)]
pub(super) struct Skipped {
    points: usize,
    lines: usize,
    /// Polygons without any ring.
    pub(super) empty: usize,
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
        let mut add = |count: usize, one: &str, many: &str, why: &str| {
            if count > 0 {
                notes.push(counted(count, one, many) + why);
            }
        };
        let only = " skipped: only polygons are read";
        add(self.lines, "line geometry was", "line geometries were", only);
        add(self.points, "point geometry was", "point geometries were", only);
        add(self.empty, "polygon without any ring was", "polygons without any ring were", " skipped");
    }
}
