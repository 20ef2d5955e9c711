//! A convex hull in space, point by point: what the new point sees, the horizon, the new triangles.

use super::space::{Moment, film};
use super::{number, shown};
use crate::figure::SketchFilm;
use crate::figure::kinds::solid::UP;
use crate::figure::sketch::Role;
use crate::solid::{HullError, HullEvent, HullFaces, Polyhedron};
use crate::topology::PolygonList;
use std::collections::{BTreeMap, BTreeSet};

/// So many points outside of the hull are drawn at most.
const MOST_POINTS: usize = 200;

/// The film of the convex hull of points in space: two frames for each point that is outside, one with the triangles that
/// it sees, one with those that it makes; at most `most` points are shown.
///
/// # Errors
/// [`HullError`] if the points do not span a solid.
///
/// ```
/// use dcel_kit::figure::algorithms;
/// let points = [[0., 0., 0.], [4., 0., 0.], [0., 4., 0.], [0., 0., 4.], [3., 3., 3.], [1., 1., 1.]];
/// let film = algorithms::convex_hull_in_space(&points, 40)?;
/// assert_eq!(film.len(), 1 + 2 + 1);
/// # Ok::<(), dcel_kit::solid::HullError>(())
/// ```
pub fn convex_hull_in_space(points: &[[f64; 3]], most: usize) -> Result<SketchFilm, HullError> {
    let mut events = Vec::new();
    let hull = Polyhedron::convex_hull_observed(points, HullFaces::Whole, &mut events)?;
    let added: Vec<usize> = (0..events.len()).filter(|&i| matches!(events[i], HullEvent::Added { .. })).collect();
    let place = |i: u32| points[i as usize];
    // Which points are known to be corners or inside.
    let mut done: BTreeSet<u32> = BTreeSet::new();
    let mut now: BTreeSet<[u32; 3]> = BTreeSet::new();
    let mut solids: Vec<Polyhedron> = Vec::new();
    let mut moments: Vec<Moment> = Vec::new();
    let kept: BTreeSet<usize> = shown(added.len(), most).into_iter().collect();
    let (mut step, mut before) = (0, None);
    let outside = |moment: &mut Moment, done: &BTreeSet<u32>| {
        for (p, &at) in (0..).zip(points).filter(|(p, _)| !done.contains(p)).take(MOST_POINTS) {
            let name = (points.len() <= 24).then(|| p.to_string());
            moment.points.push((Role::Dimmed, at, "point that has not come yet", name));
        }
    };
    for event in &events {
        match event {
            HullEvent::Tetrahedron(triangles) => {
                now.extend(triangles);
                done.extend(triangles.as_flattened());
                solids.push(solid(points, &now));
                let text = "four points that do not lie in one plane".to_owned();
                let mut moment = Moment::new("It begins with a tetrahedron".to_owned(), text, 0);
                outside(&mut moment, &done);
                moments.push(moment);
            }
            HullEvent::Inside(p) => {
                done.insert(*p);
            }
            HullEvent::Added { point, seen, horizon } => {
                let is_kept = kept.contains(&step);
                done.insert(*point);
                if is_kept {
                    // The hull before, and what the point sees of it.
                    solids.push(solid(points, &now));
                    let number = number(step, before, added.len());
                    let text = format!("it sees {} of {} triangles: they go", seen.len(), now.len());
                    let mut moment = Moment::new(format!("Point {number}: {point}"), text, solids.len() - 1);
                    outside(&mut moment, &done);
                    let sees = |t: &[u32; 3]| (Role::Wrong, t.map(place).to_vec(), "triangle that the point sees");
                    moment.faces.extend(seen.iter().map(sees));
                    let edge = |edge: &[u32; 2]| (Role::Event, edge.map(place).to_vec(), "the horizon");
                    moment.lines.extend(horizon.iter().map(edge));
                    moment.points.push((Role::Main, place(*point), "new point", Some(point.to_string())));
                    moments.push(moment);
                }
                seen.iter().for_each(|gone| remove(&mut now, *gone));
                now.extend(horizon.iter().map(|&[from, to]| [from, to, *point]));
                if is_kept {
                    before = Some(step);
                    solids.push(solid(points, &now));
                    let text = format!("{} new triangles, one from each edge of the horizon", horizon.len());
                    let mut moment = Moment::new(format!("Point {point} is a corner"), text, solids.len() - 1);
                    outside(&mut moment, &done);
                    let corners = |&[from, to]: &[u32; 2]| [from, to, *point].map(place).to_vec();
                    moment.faces.extend(horizon.iter().map(|edge| (Role::Right, corners(edge), "new triangle")));
                    moment.points.push((Role::Main, place(*point), "new point", Some(point.to_string())));
                    moments.push(moment);
                }
                step += 1;
            }
        }
    }
    let (vertices, faces) = (hull.solid.vertex_count(), hull.solid.face_count());
    solids.push(hull.solid);
    let text = format!("{vertices} vertices, {faces} faces; triangles in one plane are one face");
    moments.push(Moment::new("The convex hull".to_owned(), text, solids.len() - 1));
    Ok(film(&solids, &moments, UP, false))
}

/// The same triangle may begin with any of its corners.
fn remove(now: &mut BTreeSet<[u32; 3]>, [a, b, c]: [u32; 3]) {
    now.retain(|known| ![[a, b, c], [b, c, a], [c, a, b]].contains(known));
}

/// The hull so far: its corners alone, renumbered.
fn solid(points: &[[f64; 3]], triangles: &BTreeSet<[u32; 3]>) -> Polyhedron {
    let corners: BTreeSet<u32> = triangles.iter().flatten().copied().collect();
    let number: BTreeMap<u32, u32> = corners.iter().copied().zip(0..).collect();
    let places = corners.iter().map(|&p| points[p as usize]).collect();
    let list: Vec<[u32; 3]> = triangles.iter().map(|t| t.map(|p| number[&p])).collect();
    Polyhedron::from_polygons(places, &PolygonList::from_triangles(&list)).expect("a hull is closed at each step")
}
