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
//! and points are skipped with a note. Each polygon becomes one face, so that a MultiPolygon gives several
//! faces of the same name: `properties.name`, `properties.NAME` or `id`. Rings are taken as they come, clockwise
//! or not. Heights are dropped with a note.
//!
//! Own reader: crate geojson names neither line nor element in its errors.
//!
//! Source: RFC 7946.

use super::json::{Fault, Skipped, array, feature_name, items, polygons, shape, typed};
use super::problem::ReadProblem;
use super::rings::Rings;
use serde_json::Value;

#[derive(Default)]
struct Reader {
    rings: Rings,
    skipped: Skipped,
    heights: usize,
    empty: usize,
}

/// Reads the rings of a GeoJSON value.
pub(super) fn read(value: &Value, notes: &mut Vec<String>) -> Result<Rings, Fault> {
    let mut reader = Reader::default();
    let (object, kind) = typed(value, "the file")?;
    match kind {
        "FeatureCollection" => {
            for (i, feature) in array(object, "features", "the file")?.iter().enumerate() {
                reader.feature(feature, &format!("features[{i}]"))?;
            }
        }
        "Feature" => reader.feature(value, "feature")?,
        _ => reader.geometry(value, "geometry", None)?,
    }
    reader.skipped.note(notes);
    if reader.heights > 0 {
        notes.push(format!("the third coordinate of {} points was dropped", reader.heights));
    }
    if reader.empty > 0 {
        notes.push(format!("{} polygons without any ring were skipped", reader.empty));
    }
    Ok(reader.rings)
}

impl Reader {
    fn feature(&mut self, value: &Value, place: &str) -> Result<(), ReadProblem> {
        let (feature, kind) = typed(value, place)?;
        if kind != "Feature" {
            return Err(shape(place, "an object of type \"Feature\""));
        }
        let name = feature_name(feature);
        let place = name.as_ref().map_or_else(|| place.to_owned(), |name| format!("{place} {name:?}"));
        match feature.get("geometry") {
            None | Some(Value::Null) => Ok(()),
            Some(geometry) => self.geometry(geometry, &place, name.as_deref()),
        }
    }

    fn geometry(&mut self, value: &Value, place: &str, name: Option<&str>) -> Result<(), ReadProblem> {
        let (geometry, kind) = typed(value, place)?;
        match kind {
            "Polygon" | "MultiPolygon" => {
                let coordinates = array(geometry, "coordinates", place)?;
                let heights = &mut self.heights;
                let mut read = |value: &Value, place: &str, rings: &mut Rings| ring(value, place, rings, heights);
                self.empty += polygons(coordinates, kind == "Polygon", place, name, &mut self.rings, &mut read)?;
                Ok(())
            }
            "GeometryCollection" => {
                for (i, part) in array(geometry, "geometries", place)?.iter().enumerate() {
                    self.geometry(part, &format!("{place} geometries[{i}]"), name)?;
                }
                Ok(())
            }
            kind if self.skipped.add(kind) => Ok(()),
            kind => Err(shape(place, format!("a geometry, not the type {kind:?}"))),
        }
    }
}

fn ring(value: &Value, place: &str, rings: &mut Rings, heights: &mut usize) -> Result<(), ReadProblem> {
    for (i, position) in items(value, place, "an array of positions")?.iter().enumerate() {
        let place = || format!("{place} position {i}");
        let number = |k: usize| position.get(k).and_then(Value::as_f64);
        let (Some(x), Some(y)) = (number(0), number(1)) else {
            return Err(shape(&place(), "a position [x, y] of numbers"));
        };
        *heights += usize::from(position.get(2).is_some());
        rings.point([x, y], place)?;
    }
    rings.end_ring(|| place.to_owned())
}
