//! Floors in space whose heights differ: hills, ramps, storeys over each other.
//!
//! ```text
//!   path ── distances ── locate ── info      the commands that know them; lengths are along the surface
//!   raycast
//! ```
//!
//! Points are given by the two axes that lie flat, or by all three, as the file has them; they are told by all three.

pub(super) mod distances;
pub(super) mod info;
pub(super) mod locate;
pub(super) mod path;
pub(super) mod raycast;

use super::super::failure::Failure;
use super::super::output::point as told;
use super::areas::{Area, Faces, Names, middle};
use super::drawing::Canvas;
use super::ends::{Snap, tell_moved};
use dcel_kit::figure::FigureOptions;
use dcel_kit::io::{Axis, Format, PolygonSoup};
use dcel_kit::navmesh::{Floor, MeshFault, NavSurface, SurfaceError, SurfacePoint, SurfacePointError};
use dcel_kit::plane::Point;
use dcel_kit::{FaceId, FaceMap};
use serde::Serialize;

/// A surface, and a path between its coordinates and those of its file.
pub(super) struct Ground {
    pub(super) source: String,
    pub(super) format: Format,
    pub(super) up: Axis,
    pub(super) surface: NavSurface,
    /// What the file calls its faces.
    pub(super) names: Names,
    /// What nearly meets, and where in the file.
    pub(super) faults: Vec<(String, MeshFault)>,
}

/// A point of the command line, and how a storey is chosen where there are several.
pub(super) struct Wish<'a> {
    /// `start` or `goal`.
    pub(super) what: &'a str,
    /// Two numbers, or three.
    pub(super) numbers: &'a [f64],
    pub(super) layer: Option<usize>,
    pub(super) face: Option<FaceId>,
}

/// A start or goal.
pub(super) struct End {
    pub(super) places: Vec<SurfacePoint>,
    /// How far it was moved, in the plan.
    pub(super) moved: Option<f64>,
}

/// Where a place is. The names are those of the JSON form.
#[derive(Serialize)]
pub(super) struct Spot {
    pub(super) point: [f64; 3],
    pub(super) face: String,
    pub(super) layer: usize,
    pub(super) component: Option<u32>,
}

impl Ground {
    /// A point of the plan, and its height if it has one.
    pub(super) fn point(&self, numbers: &[f64]) -> ([f64; 2], Option<f64>) {
        let (point, has_height) = match *numbers {
            [x, y, z] => ([x, y, z], true),
            [a, b] => (
                match self.up {
                    Axis::X => [0.0, a, b],
                    Axis::Y => [a, 0.0, b],
                    Axis::Z => [a, b, 0.0],
                },
                false,
            ),
            _ => ([f64::NAN; 3], false),
        };
        let [x, y, height] = self.up.standing(point);
        ([x, y], has_height.then_some(height))
    }

    /// A point, as the file has it.
    pub(super) fn in_file(&self, p: [f64; 3]) -> [f64; 3] {
        self.up.lying(p)
    }

    /// `(1, 2, 3)`, as the file has it.
    pub(super) fn told(&self, p: [f64; 3]) -> String {
        told(&self.in_file(p))
    }

    pub(super) fn spot(&self, place: &SurfacePoint) -> Spot {
        Spot {
            point: self.in_file(place.point),
            face: place.face.to_string(),
            layer: place.layer,
            component: self.surface.component(place.face),
        }
    }

    /// `layer 0 at (1, 2, 3), layer 1 at (1, 2, 6)`.
    fn storeys(&self, places: &[SurfacePoint]) -> String {
        let words: Vec<String> =
            places.iter().map(|place| format!("layer {} at {}", place.layer, self.told(place.point))).collect();
        words.join(", ")
    }

    /// Which storey is meant.
    fn floor(wish: &Wish<'_>, height: Option<f64>) -> Floor {
        match (wish.layer, height) {
            (Some(layer), _) => Floor::Layer(layer),
            (None, Some(height)) => Floor::Height(height),
            (None, None) => Floor::Any,
        }
    }

    /// What to try if there is no place near any point: all faces stand upright then, and mostly another axis points up.
    fn help_to_lie_down(&self) -> String {
        let triangles = || self.surface.faces().flat_map(|f| self.surface.triangles(f));
        // How large the shadows of the triangles are along an axis of the file.
        let shadow = |axis: usize| {
            let [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
            let of = |[a, b, c]: [[f64; 3]; 3]| (b[u] - a[u]) * (c[v] - a[v]) - (b[v] - a[v]) * (c[u] - a[u]);
            triangles().map(|triangle| of(triangle.map(|p| self.in_file(p))).abs()).sum::<f64>()
        };
        let largest = [0, 1, 2].into_iter().max_by(|&a, &b| shadow(a).total_cmp(&shadow(b))).unwrap_or_default();
        let name = |axis: usize| ["x", "y", "z"][axis];
        let up = name(self.up as usize);
        let all = format!("with --up {up} all faces stand upright, and there is nothing to stand on");
        if largest == self.up as usize { all } else { format!("{all}: try --up {}", name(largest)) }
    }

    /// The places of an end, moved if need be.
    pub(super) fn end(&self, wish: &Wish<'_>, snap: &Snap) -> Result<End, Failure> {
        let (at, height) = self.point(wish.numbers);
        let what = wish.what;
        if let Some(layer) = wish.layer.filter(|&layer| layer >= self.surface.layer_count()) {
            let count = self.surface.layer_count();
            let what = format!("{}: there is no layer {layer} for the {what}", self.source);
            return Err(Failure::input(what, format!("there are {count}, from 0; dcel navmesh info tells them")));
        }
        let floor = Self::floor(wish, height);
        if let Some(face) = wish.face {
            let mut places = self.surface.places(at);
            places.retain(|place| place.face == face);
            if places.is_empty() {
                let what = format!("{}: {face} does not have the {what} {}", self.source, told(wish.numbers));
                return Err(Failure::input(what, format!("leave --{}-face out, or name a face there", wish.what)));
            }
            return Ok(End { places, moved: None });
        }
        let error = match self.surface.places_on(at, floor) {
            Ok(places) => return Ok(End { places, moved: None }),
            Err(error) => error,
        };
        let given = told(wish.numbers);
        // The ends of links have no flags of their own.
        let by_layer = |layer: usize| match wish.what {
            "start" | "goal" => format!(", or choose with --{what}-layer {layer}"),
            _ => String::new(),
        };
        let (why, help) = match &error {
            SurfacePointError::Ambiguous { places, .. } => (
                format!("{given} is on {} storeys: {}", places.len(), self.storeys(places)),
                format!("give all three coordinates of the points{}", by_layer(places[0].layer)),
            ),
            SurfacePointError::NothingBelow { lowest, .. } => (
                format!("{given} is below the surface, which is at {} there", self.told(lowest.point)),
                format!("the surface at a point or below it is taken: give a greater height{}", by_layer(lowest.layer)),
            ),
            SurfacePointError::NotOnLayer { layer, others, .. } => {
                (format!("{given} is not on layer {layer}, but on {}", self.storeys(others)), String::new())
            }
            _ => (format!("{given} is not on the surface"), String::new()),
        };
        let is_off = matches!(error, SurfacePointError::Off { .. } | SurfacePointError::NotOnLayer { .. });
        let nearest = if is_off { self.surface.nearest(at, floor) } else { None };
        if let Some((place, distance)) = nearest {
            let at = self.told(place.point);
            if snap.limit().is_some_and(|limit| distance <= limit) {
                tell_moved(&format!("{what} {why}"), distance, &at, place.face);
                return Ok(End { places: vec![place], moved: Some(distance) });
            }
            let help = snap.help(what, &at, distance);
            return Err(Failure::input(format!("{}: the {what} {why}", self.source), help));
        }
        let is_nowhere = matches!(error, SurfacePointError::Off { .. });
        let help = if is_nowhere { self.help_to_lie_down() } else { help };
        Err(Failure::input(format!("{}: the {what} {why}", self.source), help))
    }

    /// What a unit of length costs in each face; `None` if there are no areas.
    pub(super) fn costs(&self, areas: &[Area]) -> Result<Option<FaceMap<f64>>, Failure> {
        let inside = |f: FaceId| {
            let corners: Vec<Point> = self.surface.vertices(f).map(|(_, [x, y, _])| Point::new(x, y)).collect();
            middle(&corners)
        };
        let faces = Faces {
            source: &self.source,
            bound: self.surface.face_bound(),
            all: self.surface.faces().collect(),
            names: &self.names,
            inside: &inside,
            place: None,
        };
        faces.costs(areas)
    }

    /// The choices about the size of a figure.
    pub(super) fn options(&self, canvas: &Canvas, title: &str) -> FigureOptions {
        canvas.options_with(title, |p| {
            let ([x, y], _) = self.point(&p);
            Point::new(x, y)
        })
    }
}

/// Numbers of the command line as points of two or three.
pub(super) fn points_of(numbers: &[f64], points: usize, in_space: bool) -> Result<Vec<&[f64]>, Failure> {
    let size = if in_space && numbers.len() == 3 * points { 3 } else { 2 };
    if numbers.len() == size * points {
        return Ok(numbers.chunks_exact(size).collect());
    }
    let what = format!("{} numbers are not {points} points", numbers.len());
    let help = if in_space { "give two numbers for each point, or all three" } else { "give x and y of each point" };
    Err(Failure::input(what, help))
}

/// What is wrong with a surface, with places in its file.
pub(super) fn surface_failure(source: &str, soup: &PolygonSoup, error: &SurfaceError) -> Failure {
    let faces = error.faces();
    let place = match (faces.first(), error.vertices().first()) {
        (Some(&face), _) => soup.places.face(face as usize),
        (None, Some(&vertex)) => soup.places.vertex(vertex as usize),
        (None, None) => source.to_owned(),
    };
    let help = match error {
        SurfaceError::FacesDown { .. } => {
            "--orient turns faces over; of the model of a whole house --max-slope 45 leaves the floors"
        }
        SurfaceError::ThreeAtEdge { .. } => "--max-slope 60 leaves out walls; else leave one of the faces out",
        SurfaceError::SamePath { .. } => "turn one of them round, or leave it out",
        SurfaceError::NoFaces => "a greater --max-slope leaves out less; --orient turns over what faces down",
        _ => "",
    };
    let failure = Failure::input(format!("{place}: {error}"), help);
    let others: Vec<String> =
        faces.iter().skip(1).map(|&f| format!("face {f}: {}", soup.places.face(f as usize))).collect();
    if others.is_empty() { failure } else { failure.with_notes([format!("counted from 0; {}", others.join(", "))]) }
}
