//! Hill climbing over a convex solid, seen so that the direction points up.

use super::numbered;
use super::space::{Moment, film};
use crate::figure::SketchFilm;
use crate::figure::sketch::Role;
use crate::ids::VertexId;
use crate::solid::{ClimbEvent, Convex, Direction, Polyhedron};
use std::collections::BTreeSet;

/// The film of a climb to the vertex furthest in a direction: a frame for each vertex on the way, with the neighbours that
/// were looked at, at most `most` of them. The direction points up on the paper.
///
/// `convex` is what [`check_convex`](Polyhedron::check_convex) says of `solid`.
///
/// ```
/// use dcel_kit::figure::algorithms;
/// use dcel_kit::solid::{Direction, Platonic, Polyhedron};
/// use dcel_kit::VertexId;
/// let cube = Polyhedron::platonic(Platonic::Cube);
/// let convex = cube.check_convex()?;
/// let direction = Direction::try_from([1.0, 2.0, 3.0])?;
/// let film = algorithms::hill_climbing(&cube, &convex, direction, VertexId::new(0), 40);
/// assert_eq!(film.len(), convex.climb(direction, VertexId::new(0)).len() + 1);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn hill_climbing(
    solid: &Polyhedron,
    convex: &Convex<'_>,
    direction: Direction,
    start: VertexId,
    most: usize,
) -> SketchFilm {
    let mut events = Vec::new();
    convex.climb_observed(direction, start, &mut events);
    // Each vertex of the way with those that are looked at from there.
    let mut way: Vec<VertexId> = Vec::new();
    let mut looked: Vec<BTreeSet<VertexId>> = Vec::new();
    for event in events {
        match event {
            ClimbEvent::At(v) => {
                way.push(v);
                looked.push(BTreeSet::new());
            }
            ClimbEvent::Looked(v) => {
                if let Some(looked) = looked.last_mut() {
                    looked.insert(v);
                }
            }
        }
    }
    let mut moments = Vec::new();
    let point = |v: VertexId| solid.point(v);
    let base = |moment: &mut Moment, way: &[VertexId]| {
        if way.len() > 1 {
            moment.lines.push((Role::Main, way.iter().map(|&v| point(v)).collect(), "the climb so far"));
        }
    };
    for (i, number) in numbered(way.len(), most) {
        let at = way[i];
        let text = match way.get(i + 1) {
            Some(next) => format!("{next} is the highest of its neighbours, and higher than {at}: go there"),
            None => "none of its neighbours is higher: no vertex of a convex solid is".to_owned(),
        };
        let mut moment = Moment::new(format!("Vertex {number}: {at}"), text, 0);
        base(&mut moment, &way[..=i]);
        moment.level = Some(point(at));
        for &next in looked[i].iter().filter(|&&v| v != at) {
            let role = if way.get(i + 1) == Some(&next) { Role::Right } else { Role::Secondary };
            let key = if role == Role::Right { "highest neighbour" } else { "neighbour that is looked at" };
            moment.lines.push((role, vec![point(at), point(next)], key));
        }
        moment.points.push((Role::Event, point(at), "where the climb is", Some(at.to_string())));
        moments.push(moment);
    }
    let top = way.last().copied().unwrap_or(start);
    let text = format!("{} of {} vertices were met", way.len(), solid.vertex_count());
    let mut end = Moment::new(format!("{top} is the furthest"), text, 0);
    base(&mut end, &way);
    end.points.push((Role::Start, point(start), "where it began", Some(start.to_string())));
    end.points.push((Role::Goal, point(top), "the furthest vertex", Some(top.to_string())));
    moments.push(end);
    film(std::slice::from_ref(solid), &moments, direction.into(), true)
}
