//! Words and JSON forms that several commands have in common.

use super::super::output;
use super::super::{Output, say};
use super::map::{Frame, Map};
use dcel_kit::io::{PolygonSoup, counted};
use dcel_kit::navmesh::{FaultNames, Location, MeshFault, QueryPointError, RouteError};
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
    counted(count, "face", "faces")
}

/// How many components there are, and how many faces the largest have: `2, of 14, 3 faces`.
pub(super) fn sizes(components: &[usize]) -> String {
    const SHOWN: usize = 10;
    let shown = output::names(components.iter().take(SHOWN)).join(", ");
    let rest = if components.len() > SHOWN { ", ..." } else { "" };
    let plural = if components == [1] { "face" } else { "faces" };
    format!("{}, of {shown}{rest} {plural}", components.len())
}

/// Why one cannot stand at a point of the file, with its numbers.
pub(super) fn refusal(map: &Map, error: &QueryPointError) -> String {
    match error {
        QueryPointError::OffMesh { point: p, location } => {
            format!("{} is not on the mesh: it is {}", point(map, *p), in_map(map, *p, *location))
        }
        QueryPointError::Blocked { point: p, location } => format!("{} is blocked: it is {location}", point(map, *p)),
        QueryPointError::Ambiguous { point: p, location, faces } => {
            let (sides, faces) = (faces.len(), output::names(faces).join(", "));
            format!("{} is {location}, where {sides} sides meet that nobody passes between: {faces}", point(map, *p))
        }
        QueryPointError::NotInFace { point: p, location, face } => {
            format!("{} is {location}, and {face} is no free face there", point(map, *p))
        }
        other => other.to_string(),
    }
}

/// Why there is no path between two points of the file, with its numbers.
pub(super) fn no_route(map: &Map, error: &RouteError) -> String {
    match error {
        RouteError::Start(error) => format!("the start {}", refusal(map, error)),
        RouteError::Goal(error) => format!("the goal {}", refusal(map, error)),
        RouteError::Unreachable { from, start, to, goal } => {
            format!("there is no path: {from} is in {start}, {to} is in {goal}")
        }
        other => other.to_string(),
    }
}

/// A fault, with its place in the file. The names are those of the JSON form.
#[derive(Serialize)]
pub(super) struct Told {
    pub(super) kind: &'static str,
    pub(super) warning: bool,
    pub(super) place: String,
    pub(super) message: String,
    /// An option that mends it, or lets one live with it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) help: Option<&'static str>,
}

impl Told {
    /// A fault of polygons in the frame of their file.
    pub(super) fn of(fault: &MeshFault, soup: &PolygonSoup, frame: Frame) -> Self {
        let places = &soup.places;
        let outline = |f: u32| places.outline(f as usize, soup.faces.cycle_range(f as usize).start);
        let vertex_at = |v: &u32| places.vertex(*v as usize);
        // What nearly meets is told where its later vertex stands, if vertices have lines of their own.
        let place = match fault.kind() {
            "nearly-welded" if !soup.any_direction => fault.vertices().last().map(vertex_at),
            _ => fault.faces().first().map(|&f| outline(f)).or_else(|| fault.vertices().first().map(vertex_at)),
        };
        // Formats that give coordinates only have no numbers for their vertices.
        let face = |f: u32| places.face_path(f as usize).map(str::to_owned);
        let vertex = |v: u32| {
            let &[x, y, _] = soup.points.get(v as usize).filter(|_| soup.any_direction)?;
            Some(output::point(&frame.in_file(Point::new(x, y))))
        };
        let fault = fault.clone().with_points(|p| frame.in_file(p).into());
        let message = fault.sentence(&FaultNames { face: &face, vertex: &vertex });
        let help = help(&fault, soup.any_direction);
        Self { message, help, ..Self::at(place.unwrap_or_else(|| places.source.clone()), &fault) }
    }

    pub(super) fn at(place: String, fault: &MeshFault) -> Self {
        Self { kind: fault.kind(), warning: fault.is_warning(), place, message: fault.to_string(), help: None }
    }

    pub(super) fn print(&self, out: &mut Output) -> io::Result<()> {
        let kind = if self.warning { "warning" } else { self.kind };
        // Some sentences begin with the kind themselves.
        if self.message.get(..kind.len()).is_some_and(|start| start.eq_ignore_ascii_case(kind)) {
            return writeln!(out, "{}: {}", self.place, self.message);
        }
        writeln!(out, "{}: {kind}: {}", self.place, self.message)
    }
}

/// Which option mends a fault.
fn help(fault: &MeshFault, coordinates_only: bool) -> Option<&'static str> {
    match fault.kind() {
        "not-convex" => Some("--triangles cuts faces up that are not convex"),
        "winding" if matches!(fault, MeshFault::Clockwise { .. }) => {
            Some("--orient turns faces round that run clockwise; if y points down in the file, say --y-down")
        }
        "t-junction" | "same-place" => Some("--weld 0 joins vertices at one place and puts corners into sides"),
        "overlap" => Some("--mend cuts the polygons where they meet"),
        "winding" if coordinates_only => Some("--mend cuts the polygons where they meet"),
        _ => None,
    }
}

/// Tells each help once.
pub(super) fn tell_helps(faults: &[Told]) {
    let mut told = Vec::new();
    for help in faults.iter().filter_map(|fault| fault.help) {
        if !told.contains(&help) {
            told.push(help);
            say("help", help);
        }
    }
}
