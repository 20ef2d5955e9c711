//! `dcel navmesh raycast` on a floor whose heights differ.

use super::super::super::output::point as told;
use super::super::super::{Answer, Failure, Output, fields, tell};
use super::super::drawing::{Canvas, save};
use super::super::raycast::Args;
use super::super::routes::{WHERE_FACES_TOUCH, furthest};
use super::super::tell::faces;
use super::{End, Ground, Wish, points_of};
use dcel_kit::figure::navmesh::Storeys;
use dcel_kit::navmesh::{SurfaceRaycast, SurfaceRoute};
use std::io::Write;

pub(in super::super) fn run(
    ground: &Ground,
    args: &Args,
    target: Option<&Canvas>,
    out: &mut Output,
) -> Result<Answer, Failure> {
    let points = points_of(&args.ends, 2, true)?;
    let wish = Wish { what: "start", numbers: points[0], layer: args.start_layer, face: args.start_face };
    let End { places, moved } = ground.end(&wish, &args.snap)?;
    let (to, _) = ground.point(points[1]);
    let mut casts = Vec::new();
    for start in places {
        let cast = ground.surface.raycast(&start, to);
        let refused = |error| Failure::input(format!("{}: the end of the line: {error}", ground.source), "");
        casts.push((start, cast.map_err(refused)?));
    }
    let reach = |cast: &SurfaceRaycast| if cast.hit.is_some() { cast.length } else { f64::INFINITY };
    let best = furthest((&told(points[0]), WHERE_FACES_TOUCH), casts, |place| place.face, reach);
    let (start, cast) = best.ok_or_else(|| Failure::kit("a start has a place"))?;
    let end = cast.points.last().copied().unwrap_or(start.point);
    if let Some(target) = target {
        let options = ground.options(target, &format!("A ray over {}", args.map.title()));
        let line = SurfaceRoute {
            faces: cast.faces.clone(),
            points: cast.points.clone(),
            layers: cast.layers.clone(),
            length: cast.length,
            cost: cast.length,
            ..SurfaceRoute::default()
        };
        let goal = ground.surface.places(to).into_iter().next().unwrap_or(start);
        save(target, Storeys::new(&ground.surface).paths(&[&line], &[], &[start, goal], &options), out)?;
    }
    let answer = fields! {
        source: &ground.source,
        start: ground.in_file(start.point),
        start_moved: moved,
        end: ground.in_file(end),
        clear: cast.hit.is_none(),
        hit: cast.hit.map(|hit| fields! {
            point: ground.in_file(hit.point),
            face: hit.face.to_string(),
            // The ends of the side that was hit.
            side: hit.side.map(|v| v.to_string()),
            vertex: hit.vertex.map(|v| v.to_string()),
        }),
        // Along the surface.
        length: cast.length,
        faces: cast.faces.iter().map(ToString::to_string).collect::<Vec<_>>(),
    };
    tell(&answer, args.json, out, |out| {
        let through = faces(answer.faces.len());
        let away = format!("{} away along the surface", answer.length);
        match &answer.hit {
            None => {
                let [start, end] = [&answer.start, &answer.end].map(|p| told(p));
                writeln!(out, "clear: {end} is in sight of {start} in the plan, {away}, through {through}")
            }
            Some(hit) => {
                let vertex = hit.vertex.as_ref().map(|v| format!(" at its end {v}")).unwrap_or_default();
                let (face, [a, b], at) = (&hit.face, &hit.side, told(&hit.point));
                writeln!(out, "hit: the side {a} {b} of {face}{vertex}, at {at}, {away}, through {through}")
            }
        }
    })
}
