//! `dcel navmesh locate` on a floor whose heights differ: every storey at a point.

use super::super::super::output::point as told;
use super::super::super::{Answer, Failure, Output, fields};
use super::Ground;
use dcel_kit::navmesh::Floor;
use std::io::Write;

pub(in super::super) fn run(
    ground: &Ground,
    points: &[&[f64]],
    json: bool,
    out: &mut Output,
) -> Result<Answer, Failure> {
    let mut all = Vec::new();
    for numbers in points {
        let (at, height) = ground.point(numbers);
        let places = match height {
            Some(height) => ground.surface.places_on(at, Floor::Height(height)).unwrap_or_default(),
            None => ground.surface.places(at),
        };
        let floor = height.map_or(Floor::Any, Floor::Height);
        let near = if places.is_empty() { ground.surface.nearest(at, floor) } else { None };
        all.push(fields! {
            point: *numbers,
            // From the lowest to the highest; for a point with a height the one at it or below it.
            places: places.iter().map(|place| ground.spot(place)).collect::<Vec<_>>(),
            // Where one can stand instead, if not there, and how far that is, in the plan.
            nearest: near.as_ref().map(|(place, _)| ground.in_file(place.point)),
            distance: near.map(|(_, distance)| distance),
        });
    }
    if json {
        return out.json(&all);
    }
    writeln!(out, "{}:", ground.source)?;
    for found in &all {
        let given = told(found.point);
        for place in &found.places {
            let component = place.component.map(|c| format!(", component {c}")).unwrap_or_default();
            writeln!(out, "  {given}  on {} at {}, layer {}{component}", place.face, told(&place.point), place.layer)?;
        }
        if let Some(nearest) = found.nearest {
            writeln!(out, "  {given}  not on the surface; the nearest place is {}", told(&nearest))?;
        } else if found.places.is_empty() {
            writeln!(out, "  {given}  below the surface")?;
        }
    }
    Ok(Answer::Yes)
}
