//! A map with its navmesh, and the way its file has its coordinates.

use super::super::failure::Failure;
use super::areas::{Area, Faces, Names, middle};
use dcel_kit::io::Format;
use dcel_kit::navmesh::{Inset, NavMesh};
use dcel_kit::plane::{Point, Subdivision};
use dcel_kit::{FaceId, FaceMap};

/// A map, and a path between its coordinates and those of its file.
pub(super) struct Map {
    pub(super) source: String,
    pub(super) format: Format,
    pub(super) subdivision: Subdivision,
    pub(super) mesh: NavMesh,
    /// What the file calls its faces.
    pub(super) names: Names,
    /// What faces cost, if obstacles have changed them since that was said.
    pub(super) known_costs: Option<FaceMap<f64>>,
    pub(super) frame: Frame,
}

/// Whether the second coordinate of the file points down.
#[derive(Clone, Copy)]
pub(super) struct Frame {
    pub(super) down: bool,
}

impl Frame {
    /// A point of the file.
    pub(super) fn point(self, [x, y]: [f64; 2]) -> Point {
        Point::new(x, if self.down { 0.0 - y } else { y })
    }

    /// A point of the map, as the file has it.
    pub(super) fn in_file(self, p: Point) -> [f64; 2] {
        [p.x, if self.down { 0.0 - p.y } else { p.y }]
    }
}

impl Map {
    /// A point of the file.
    pub(super) fn point(&self, coordinates: [f64; 2]) -> Point {
        self.frame.point(coordinates)
    }

    /// The same map without the margin of a radius.
    pub(super) fn inset(&self, inset: Inset) -> Self {
        let (subdivision, mesh) = inset.into_parts();
        let names = Names::default();
        let source = self.source.clone();
        Self { source, format: self.format, subdivision, mesh, names, known_costs: None, frame: self.frame }
    }

    /// A point of the map, as the file has it.
    pub(super) fn in_file(&self, p: Point) -> [f64; 2] {
        self.frame.in_file(p)
    }

    /// What a unit of length costs in each face; `None` if there are no areas.
    pub(super) fn costs(&self, areas: &[Area]) -> Result<Option<FaceMap<f64>>, Failure> {
        if self.known_costs.is_some() {
            return Ok(self.known_costs.clone());
        }
        let inside = |f: FaceId| middle(&self.mesh.corners(f).map(|v| self.mesh.point(v)).collect::<Vec<_>>());
        let faces = Faces {
            source: &self.source,
            bound: self.mesh.face_bound(),
            all: self.mesh.faces().collect(),
            names: &self.names,
            inside: &inside,
            place: Some(&|p| self.point(p)),
        };
        faces.costs(areas)
    }
}
