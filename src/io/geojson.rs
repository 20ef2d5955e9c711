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
//! Own reader on serde_json: crate geojson names neither line nor element in its errors.
//!
//! Source: RFC 7946.

use super::arrays::Arrays;
use super::json::{Fault, Node, Place, Skipped, lacks, named, polygons, shape};
use super::problem::ReadProblem;
use super::rings::Rings;

struct Reader<'a> {
    file: &'a str,
    rings: Rings,
    skipped: Skipped,
    heights: usize,
}

/// Reads the rings of a GeoJSON object; `file` is the text it is a part of.
pub(super) fn read(root: &Node<'_>, file: &str, notes: &mut Vec<String>) -> Result<Rings, Fault> {
    let mut reader = Reader { file, rings: Rings::default(), skipped: Skipped::default(), heights: 0 };
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
    if reader.heights > 0 {
        notes.push(format!("the third coordinate of {} points was dropped", reader.heights));
    }
    Ok(reader.rings)
}

impl Reader<'_> {
    fn feature(&mut self, feature: &Node<'_>, path: &str) -> Result<(), Fault> {
        let name = feature.name();
        let path = named(path, name.as_deref());
        if feature.need_kind(&path)? != "Feature" {
            return Err(shape(&path, "an object of type \"Feature\"").into());
        }
        match &feature.geometry {
            None => Ok(()),
            Some(geometry) => self.geometry(geometry, &path, name.as_deref()),
        }
    }

    fn geometry(&mut self, geometry: &Node<'_>, path: &str, name: Option<&str>) -> Result<(), Fault> {
        let kind = geometry.need_kind(path)?;
        match kind.as_ref() {
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
