//! A map with its navmesh, and the way its file has its coordinates.

use super::super::failure::Failure;
use super::super::output::point as told;
use super::areas::{Area, Faces, Names, middle};
use dcel_kit::io::{Axis, Format};
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
    /// Of a floor in space all of whose heights are equal.
    pub(super) level: Option<Level>,
}

/// How high a level floor lies in space.
#[derive(Clone, Copy)]
pub(super) struct Level {
    /// The axis that points up.
    pub(super) up: Axis,
    pub(super) height: f64,
    /// How much lower a point may be given.
    pub(super) slack: f64,
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

    /// `N` points of the command line by their two coordinates, in one row of numbers. On a level floor each may have three,
    /// as where heights differ: the height is that of the floor, or above it. None for any other count of numbers.
    pub(super) fn flat<const N: usize>(&self, numbers: &[f64]) -> Result<Option<[[f64; 2]; N]>, Failure> {
        let mut points = [[0.0; 2]; N];
        if numbers.len() == 2 * N {
            points.iter_mut().zip(numbers.chunks_exact(2)).for_each(|(point, given)| point.copy_from_slice(given));
            return Ok(Some(points));
        }
        let Some(level) = self.level.filter(|_| numbers.len() == 3 * N) else { return Ok(None) };
        for (point, given) in points.iter_mut().zip(numbers.chunks_exact(3)) {
            let [x, y, z] = [given[0], given[1], given[2]];
            let (flat, height) = match level.up {
                Axis::X => ([y, z], x),
                Axis::Y => ([x, z], y),
                Axis::Z => ([x, y], z),
            };
            if height < level.height - level.slack {
                let what = format!("{} is below the floor, whose height is {}", told(given), level.height);
                let help = "the floor at a point or below it is taken: give a greater height";
                return Err(Failure::input(format!("{}: {what} everywhere", self.source), help));
            }
            *point = flat;
        }
        Ok(Some(points))
    }

    /// So many points; `what` is wrong if there are others.
    pub(super) fn points<const N: usize>(
        &self,
        numbers: &[f64],
        what: &str,
        help: &str,
    ) -> Result<[[f64; 2]; N], Failure> {
        if let Some(points) = self.flat(numbers)? {
            return Ok(points);
        }
        if numbers.len() == 3 * N {
            let why = "three coordinates are for floors in space (--up) that are measured along the surface";
            return Err(Failure::input(format!("{}: {why}", self.source), help));
        }
        Err(Failure::input(what, help))
    }

    /// The same map without the margin of a radius.
    pub(super) fn inset(&self, inset: Inset) -> Self {
        let (subdivision, mesh) = inset.into_parts();
        let names = Names::default();
        let source = self.source.clone();
        let Self { format, frame, level, .. } = *self;
        Self { source, format, subdivision, mesh, names, known_costs: None, frame, level }
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
