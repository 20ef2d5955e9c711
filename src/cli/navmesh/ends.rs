//! The start and the goal of a path: where one can stand there, and where else if one cannot.

use super::super::failure::{Failure, say};
use super::map::Map;
use super::numbers::{above, number};
use super::routes::{ON_SIDES, choose};
use super::tell::{point, refusal};
use dcel_kit::FaceId;
use dcel_kit::io::Number;
use dcel_kit::navmesh::{Nearest, QueryPoint, QueryPointError};
use dcel_kit::plane::Point;
use serde::Serialize;

/// What to do with a start or goal off the mesh.
#[derive(clap::Args, Debug)]
pub(super) struct Snap {
    /// Move a start or goal that is off the mesh to the nearest place, if that is no further away than
    /// this; the distance is told
    #[arg(long, value_name = "D", value_parser = number, allow_negative_numbers = true)]
    snap: Option<f64>,
}

/// How many ends were moved, and how far at most.
#[derive(Serialize, Clone, Copy, Default)]
pub(super) struct Moves {
    pub(super) count: usize,
    pub(super) farthest: f64,
}

/// A start or goal.
pub(super) struct End {
    /// Where it was asked for.
    pub(super) asked: Point,
    /// The places there: one on each side of a double corner or a wall.
    pub(super) places: Vec<QueryPoint>,
    /// How far they are from where it was asked for, if it was moved.
    pub(super) moved: Option<f64>,
}

/// An end that there is no place for.
pub(super) struct Lost {
    pub(super) asked: Point,
    pub(super) nearest: Option<Nearest>,
    pub(super) failure: Failure,
}

/// Where an end is asked for.
pub(super) struct Wish<'a> {
    /// `start` or `goal`.
    pub(super) what: &'a str,
    /// As the file has it.
    pub(super) coordinates: [f64; 2],
    pub(super) face: Option<FaceId>,
}

impl Snap {
    /// Ends stay where they are.
    pub(super) const fn none() -> Self {
        Self { snap: None }
    }

    /// How far an end may be moved.
    pub(super) fn limit(&self) -> Option<f64> {
        self.snap
    }

    /// Refuses what is no distance.
    pub(super) fn check(&self) -> Result<(), Failure> {
        match self.snap.filter(|&snap| snap < 0.0) {
            Some(snap) => Err(Failure::input(format!("a distance of {snap}"), "give a number such as --snap 0.5")),
            None => Ok(()),
        }
    }

    /// How `what` comes to the nearest place, `at`, which is further away than an end may be moved.
    pub(super) fn help(&self, what: &str, at: &str, distance: f64) -> String {
        let nearest = format!("the nearest place is {at}");
        match self.snap {
            Some(snap) => format!("{nearest}, {} away: more than --snap {}", Number(distance), Number(snap)),
            None => format!("{nearest}; --snap {} moves the {what} there", Number(above(distance))),
        }
    }

    /// The places at a point, or the nearest one.
    pub(super) fn place(&self, map: &Map, p: Point, moves: &mut Moves) -> Result<Vec<QueryPoint>, QueryPointError> {
        map.mesh.places(p).or_else(|error| {
            let near = self.nearest(map, p).ok_or(error)?;
            moves.count += 1;
            moves.farthest = moves.farthest.max(near.distance);
            Ok(vec![near.place])
        })
    }

    /// The end that is wished for, or why there is none.
    pub(super) fn wished(&self, map: &Map, wish: &Wish<'_>) -> Result<End, Failure> {
        self.end(map, wish, |_| None).map_err(|lost| lost.failure)
    }

    /// The nearest place, if it is near enough.
    fn nearest(&self, map: &Map, p: Point) -> Option<Nearest> {
        let limit = self.snap?;
        map.mesh.nearest_point(p).filter(|near| near.distance <= limit)
    }

    /// The end that is wished for. `why` says more about a point that is off the mesh, if there is more to say.
    pub(super) fn end(
        &self,
        map: &Map,
        wish: &Wish<'_>,
        why: impl Fn(&QueryPointError) -> Option<String>,
    ) -> Result<End, Box<Lost>> {
        let Wish { what, coordinates, face } = *wish;
        let asked = map.point(coordinates);
        let found = match face {
            Some(face) => map.mesh.place_in(face, asked).map(|place| vec![place]),
            None => map.mesh.places(asked),
        };
        let error = match found {
            Ok(places) => return Ok(End { asked, places, moved: None }),
            Err(error) => error,
        };
        let why = why(&error).unwrap_or_else(|| refusal(map, &error));
        let is_off = !matches!(error, QueryPointError::NotInFace { .. });
        if let Some(near) = self.nearest(map, asked).filter(|_| is_off) {
            let Nearest { place, distance } = near;
            tell_moved(&format!("{what} {why}"), distance, &point(map, place.point), place.face);
            return Ok(End { asked, places: vec![place], moved: Some(distance) });
        }
        let nearest = map.mesh.nearest_point(asked);
        let place = nearest.map(|near| (point(map, near.place.point), near.place.face, near.distance));
        let help = match place {
            None => String::new(),
            Some((_, face, _)) if !is_off => {
                format!("leave --{what}-face out, or name a face at the point: {face} is the nearest")
            }
            Some((at, face, distance)) => self.help(what, &format!("{at} in {face}"), distance),
        };
        let failure = Failure::input(format!("{}: the {what} {why}", map.source), help);
        Err(Box::new(Lost { asked, nearest, failure }))
    }
}

/// Tells that an end was moved, and why.
pub(super) fn tell_moved(why: &str, distance: f64, at: &str, face: FaceId) {
    say("note", format_args!("the {why}; moved by {} to {at} in {face}", Number(distance)));
}

/// Of several places at the ends those of the shortest path. Tells which.
pub(super) fn choose_side(
    map: &Map,
    wishes: &[Wish<'_>; 2],
    ends: &[End; 2],
    shortest: impl FnOnce() -> Option<[usize; 2]>,
) -> [QueryPoint; 2] {
    let ends = [0, 1].map(|i| (wishes[i].what, point(map, ends[i].asked), ends[i].places.as_slice()));
    choose(&ends, ON_SIDES, |place| place.face, shortest)
}
