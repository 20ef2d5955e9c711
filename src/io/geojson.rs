//! GeoJSON: polygons with holes and names.
//!
//! ```text
//!   {"type": "FeatureCollection", "features": [
//!     {"type": "Feature", "properties": {"name": "Ohio"},
//!      "geometry": {"type": "Polygon", "coordinates": [[[0,0],[4,0],[4,4],[0,0]],      the outer ring
//!                                                      [[1,1],[2,2],[2,1],[1,1]]]}}]}  a hole
//! ```
//!
//! Read are Polygon and MultiPolygon, alone, in a Feature, a FeatureCollection or a GeometryCollection; lines
//! and points beside them are skipped with a note. A file without any polygon is read as segments and points; on
//! request every file is, polygons by their outlines. Each polygon becomes one face, so that a MultiPolygon gives several
//! faces of the same name: `properties.name`, `properties.NAME` or `id`. Rings are taken as they come, clockwise
//! or not. Heights are dropped with a note.
//!
//! Own reader on serde_json: crate geojson names neither line nor element in its errors.
//!
//! Source: RFC 7946.

use super::arrays::Arrays;
use super::document::ReadOptions;
use super::geometries::{Skipped, polygons};
use super::nodes::{Fault, Node, Place, lacks, named, shape};
use super::problem::ReadProblem;
use super::repaired::Repaired;
use super::rings::Rings;
use super::soup::SegmentSoup;
use super::text::LineCounter;
use super::words::counted;
use crate::plane::check_coordinate;

struct Reader<'a> {
    file: &'a str,
    rings: Rings,
    skipped: Skipped,
    heights: usize,
    /// Takes everything, if the file is read as segments.
    soup: Option<SegmentSoup>,
    lines: LineCounter<'a>,
    /// Of a file that is read as segments: whether rings are closed that do not end where they start, and which were.
    closes: bool,
    closed: Repaired,
}

/// What a GeoJSON object holds.
pub(super) enum Shapes {
    /// The rings of its polygons.
    Rings(Rings),
    /// Segments and points.
    Segments(SegmentSoup),
}

/// Reads a GeoJSON object; `file` is the text it is a part of. Everything is read as segments if `options.outlines` asks for
/// that or if there is no polygon, but a line.
pub(super) fn read(
    root: &Node<'_>,
    file: &str,
    source: &str,
    options: &ReadOptions,
    notes: &mut Vec<String>,
) -> Result<Shapes, Fault> {
    let outlines = options.outlines;
    let only_lines = || !has(root, "Polygon") && has(root, "LineString");
    let soup = (outlines || only_lines()).then(|| SegmentSoup::new(source));
    let mut reader = Reader {
        file,
        rings: Rings::of_file(file.len()),
        skipped: Skipped::default(),
        heights: 0,
        soup,
        lines: LineCounter::new(file),
        closes: options.close_rings,
        closed: Repaired::default(),
    };
    if options.close_rings {
        reader.rings.close_rings();
    }
    match root.need_kind("the file")?.as_ref() {
        "FeatureCollection" => {
            let features = root.features.as_ref().ok_or_else(|| lacks("the file", "features"))?;
            for (i, feature) in features.iter().enumerate() {
                reader.feature(feature, &format!("features[{i}]"))?;
            }
        }
        "Feature" => reader.feature(root, "feature")?,
        _ => reader.geometry(root, "geometry", None)?,
    }
    reader.skipped.note(notes);
    reader.closed.note_closed(notes);
    if reader.heights > 0 {
        notes.push(format!("the third coordinate of {} was dropped", counted(reader.heights, "point", "points")));
    }
    Ok(match reader.soup {
        Some(soup) => Shapes::Segments(SegmentSoup { mended_rings: reader.closed.count(), ..soup }),
        None => Shapes::Rings(reader.rings),
    })
}

/// Whether a geometry of this kind, or of several such, is in the object.
fn has(node: &Node<'_>, kind: &str) -> bool {
    let own = node.kind().is_some_and(|own| own.strip_prefix("Multi").unwrap_or(&own) == kind);
    let parts = node.features.iter().chain(&node.geometries).flatten();
    own || node.geometry.as_ref().is_some_and(|geometry| has(geometry, kind))
        || parts.into_iter().any(|part| has(part, kind))
}

impl Reader<'_> {
    fn feature(&mut self, feature: &Node<'_>, path: &str) -> Result<(), Fault> {
        let name = feature.name();
        let path = named(path, name.as_deref());
        if feature.need_kind(&path)? != "Feature" {
            return Err(shape(&path, "an object of type \"Feature\"").into());
        }
        let Some(geometry) = &feature.geometry else { return Ok(()) };
        feature.count_left_out(&mut self.rings.left_out);
        self.geometry(geometry, &path, name.as_deref())
    }

    fn geometry(&mut self, geometry: &Node<'_>, path: &str, name: Option<&str>) -> Result<(), Fault> {
        let kind = geometry.need_kind(path)?;
        match kind.as_ref() {
            "Polygon" | "MultiPolygon" | "LineString" | "MultiLineString" | "Point" | "MultiPoint"
                if self.soup.is_some() =>
            {
                let coordinates = geometry.coordinates.ok_or_else(|| lacks(path, "coordinates"))?;
                let depth = match kind.as_ref() {
                    "Point" => 0,
                    "LineString" | "MultiPoint" => 1,
                    "MultiPolygon" => 3,
                    _ => 2,
                };
                let (chains, closed) = (!kind.ends_with("Point"), kind.ends_with("Polygon"));
                let first = if kind == "Polygon" { format!("{path} polygon 0") } else { path.to_owned() };
                self.positions(&mut Arrays::new(coordinates, self.file), &first, depth, chains, closed)
            }
            "Polygon" | "MultiPolygon" => {
                let coordinates = geometry.coordinates.ok_or_else(|| lacks(path, "coordinates"))?;
                let (one, heights) = (kind == "Polygon", &mut self.heights);
                let mut read =
                    |arrays: &mut Arrays<'_>, place: Place<'_>, rings: &mut Rings| ring(arrays, place, rings, heights);
                let mut arrays = Arrays::new(coordinates, self.file);
                self.skipped.empty += polygons(&mut arrays, one, path, name, &mut self.rings, &mut read)?;
                Ok(())
            }
            "GeometryCollection" => {
                let parts = geometry.geometries.as_ref().ok_or_else(|| lacks(path, "geometries"))?;
                for (i, part) in parts.iter().enumerate() {
                    self.geometry(part, &format!("{path} geometries[{i}]"), name)?;
                }
                Ok(())
            }
            kind if self.skipped.add(kind) => Ok(()),
            kind => Err(shape(path, format!("a geometry, not the type {kind:?}")).into()),
        }
    }

    /// Reads positions in so many arrays; the innermost ones are chains, of which those of polygons are closed.
    fn positions(
        &mut self,
        arrays: &mut Arrays<'_>,
        path: &str,
        depth: u32,
        chains: bool,
        closed: bool,
    ) -> Result<(), Fault> {
        if depth == 0 {
            return self.position(arrays, path);
        }
        let first = self.soup.as_ref().map_or(0, |soup| soup.points.len());
        let at = arrays.offset();
        let wrong = || shape(path, "an array of positions");
        arrays.each(wrong, |arrays, i| {
            let item = match (depth, closed) {
                (1, _) => "position",
                (2, true) => "ring",
                (_, true) => "polygon",
                (_, false) => "part",
            };
            let place = format!("{path} {item} {i}");
            self.positions(arrays, &place, depth - 1, chains, closed)
        })?;
        let Some(soup) = self.soup.as_mut().filter(|_| depth == 1 && chains) else { return Ok(()) };
        if soup.points.len() == first + 1 {
            return Err(Fault::at(at, shape(path, "two positions or more")));
        }
        if closed {
            let ended = soup.end_ring(first, path, self.closes.then_some(&mut self.closed));
            ended.map_err(|problem| Fault::at(at, problem))?;
        }
        soup.begin_path(path);
        soup.chain(first as u32, closed);
        Ok(())
    }

    fn position(&mut self, arrays: &mut Arrays<'_>, path: &str) -> Result<(), Fault> {
        let at = arrays.offset();
        let found = arrays.position();
        let ([x, y], more) = found.ok_or_else(|| Fault::at(at, shape(path, "a position [x, y] of numbers")))?;
        let checked = check_coordinate('x', x).and_then(|()| check_coordinate('y', y));
        checked.map_err(|error| Fault::at(at, ReadProblem::CoordinateAt { place: path.to_owned(), error }))?;
        self.heights += usize::from(more);
        if let Some(soup) = &mut self.soup {
            soup.point([x, y], self.lines.line(at));
        }
        Ok(())
    }
}

fn ring(arrays: &mut Arrays<'_>, place: Place<'_>, rings: &mut Rings, heights: &mut usize) -> Result<(), Fault> {
    let wrong = || shape(&place.to_string(), "an array of positions");
    arrays.each(wrong, |arrays, i| {
        let at = arrays.offset();
        let path = || format!("{place} position {i}");
        let position = arrays.position();
        let (point, more) = position.ok_or_else(|| Fault::at(at, shape(&path(), "a position [x, y] of numbers")))?;
        *heights += usize::from(more);
        rings.point(point, path).map_err(|problem: ReadProblem| Fault::at(at, problem))
    })
}
