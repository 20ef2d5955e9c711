//! Geometries of the two JSON formats: their polygons, read ring by ring, and the others, counted.

use super::arrays::Arrays;
use super::nodes::{Fault, Place, shape};
use super::rings::Rings;
use super::words::note;

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
    let (mut empty, before) = (0, rings.polygon_count());
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
    rings.left_out.groups += usize::from(rings.polygon_count() > before + 1);
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
        let only = " skipped: only polygons are read";
        note(notes, self.lines, "line geometry was", "line geometries were", only);
        note(notes, self.points, "point geometry was", "point geometries were", only);
        note(notes, self.empty, "polygon without any ring was", "polygons without any ring were", " skipped");
    }
}
