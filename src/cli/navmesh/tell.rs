//! Words and JSON forms that several commands have in common.

use super::super::Output;
use super::super::output;
use super::map::Map;
use dcel_kit::io::Places;
use dcel_kit::navmesh::{Location, MeshFault, QueryPointError};
use dcel_kit::plane::{self, Point};
use serde::Serialize;
use std::io::{self, Write};

/// Where a point lies. The names are those of the JSON form.
#[derive(Serialize)]
pub(super) struct Spot {
    /// As the file has it.
    pub(super) point: [f64; 2],
    /// `vertex`, `edge`, `face`, `hole` or `outer`.
    pub(super) on: &'static str,
    /// The vertex, half-edge or face.
    pub(super) element: Option<String>,
}

impl Spot {
    pub(super) fn of(map: &Map, point: Point, location: Location) -> Self {
        let (on, element) = match in_map(map, point, location) {
            Location::Vertex(v) => ("vertex", Some(v.to_string())),
            Location::Edge(h) => ("edge", Some(h.to_string())),
            Location::Face(f) => ("face", Some(f.to_string())),
            Location::Hole(f) => ("hole", Some(f.to_string())),
            Location::Outer => ("outer", None),
        };
        Self { point: map.in_file(point), on, element }
    }
}

/// The same location, by the very face of the file if a hole is cut into several.
pub(super) fn in_map(map: &Map, p: Point, location: Location) -> Location {
    match location {
        Location::Hole(_) => match map.subdivision.locate(p) {
            plane::Location::Face(f) if map.subdivision.is_hole(f) => Location::Hole(f),
            _ => location,
        },
        other => other,
    }
}

/// `(3, 4)`, as the file has it.
pub(super) fn point(map: &Map, p: Point) -> String {
    output::point(&map.in_file(p))
}

/// `1 face`, `2 faces`.
pub(super) fn faces(count: usize) -> String {
    format!("{count} {}", if count == 1 { "face" } else { "faces" })
}

/// Why one cannot stand at a point of the file, with its numbers.
pub(super) fn refusal(map: &Map, error: &QueryPointError) -> String {
    match error {
        QueryPointError::OffMesh { point: p, location } => {
            format!("{} is not on the mesh: it is {}", point(map, *p), in_map(map, *p, *location))
        }
        QueryPointError::Blocked { point: p, location } => format!("{} is blocked: it is {location}", point(map, *p)),
        QueryPointError::Ambiguous { point: p, location, faces } => {
            let faces: Vec<String> = faces.iter().map(ToString::to_string).collect();
            let sides = faces.len();
            let faces = faces.join(", ");
            format!("{} is {location}, where {sides} sides meet that nobody passes between: {faces}", point(map, *p))
        }
        QueryPointError::NotInFace { point: p, location, face } => {
            format!("{} is {location}, and {face} is no free face there", point(map, *p))
        }
        other => other.to_string(),
    }
}

/// A fault, with its place in the file. The names are those of the JSON form.
#[derive(Serialize)]
pub(super) struct Told {
    pub(super) kind: &'static str,
    pub(super) warning: bool,
    place: String,
    message: String,
}

impl Told {
    pub(super) fn of(fault: &MeshFault, places: &Places) -> Self {
        let face = fault.faces().first().map(|&f| places.face(f as usize));
        let place = face.or_else(|| fault.vertices().first().map(|&v| places.vertex(v as usize)));
        Self::at(place.unwrap_or_else(|| places.source.clone()), fault)
    }

    pub(super) fn at(place: String, fault: &MeshFault) -> Self {
        Self { kind: fault.kind(), warning: fault.is_warning(), place, message: fault.to_string() }
    }

    pub(super) fn print(&self, out: &mut Output) -> io::Result<()> {
        let kind = if self.warning { "warning" } else { self.kind };
        writeln!(out, "{}: {kind}: {}", self.place, self.message)
    }
}
