//! `dcel navmesh raycast` on a floor whose heights differ.

use super::super::super::failure::Failure;
use super::super::super::output::point as told;
use super::super::super::{Answer, Output};
use super::super::drawing::{Canvas, save};
use super::super::ends::Snap;
use super::super::tell::faces;
use super::{Ground, Wish};
use dcel_kit::figure::navmesh::Storeys;
use dcel_kit::navmesh::{SurfaceRoute, Work};
use serde::Serialize;
use std::io::Write;

/// The answer. The names are those of the JSON form.
#[derive(Serialize)]
struct Answered {
    source: String,
    start: [f64; 3],
    end: [f64; 3],
    clear: bool,
    hit: Option<Hit>,
    /// Along the surface.
    length: f64,
    faces: Vec<String>,
}

#[derive(Serialize)]
struct Hit {
    point: [f64; 3],
    face: String,
    /// The ends of the side that was hit.
    side: [String; 2],
    vertex: Option<String>,
}

/// What is asked for.
pub(in super::super) struct Question<'a> {
    pub(in super::super) wish: Wish<'a>,
    pub(in super::super) to: &'a [f64],
    pub(in super::super) json: bool,
    pub(in super::super) target: Option<&'a Canvas>,
    pub(in super::super) title: String,
}

pub(in super::super) fn run(ground: &Ground, question: &Question<'_>, out: &mut Output) -> Result<Answer, Failure> {
    let start = ground.end(&question.wish, &Snap::none())?.places[0];
    let (to, _) = ground.point(question.to);
    let cast = ground.surface.raycast(&start, to);
    let cast = cast.map_err(|error| Failure::input(format!("{}: the end of the line: {error}", ground.source), ""))?;
    let end = cast.points.last().copied().unwrap_or(start.point);
    if let Some(target) = question.target {
        let options = ground.options(target, &format!("A ray over {}", question.title));
        let line = SurfaceRoute {
            faces: cast.faces.clone(),
            points: cast.points.clone(),
            layers: cast.layers.clone(),
            corners: Vec::new(),
            length: cast.length,
            cost: cast.length,
            work: Work::default(),
        };
        let goal = ground.surface.places(to).into_iter().next().unwrap_or(start);
        save(target, Storeys::new(&ground.surface).paths(&[&line], &[], &[start, goal], &options), out)?;
    }
    let answer = Answered {
        source: ground.source.clone(),
        start: ground.in_file(start.point),
        end: ground.in_file(end),
        clear: cast.hit.is_none(),
        hit: cast.hit.map(|hit| Hit {
            point: ground.in_file(hit.point),
            face: hit.face.to_string(),
            side: hit.side.map(|v| v.to_string()),
            vertex: hit.vertex.map(|v| v.to_string()),
        }),
        length: cast.length,
        faces: cast.faces.iter().map(ToString::to_string).collect(),
    };
    if question.json {
        out.json(&answer)?;
        return Ok(Answer::Yes);
    }
    let through = faces(answer.faces.len());
    let length = answer.length;
    match &answer.hit {
        None => {
            let ends = [&answer.start, &answer.end].map(|p| told(p));
            writeln!(
                out,
                "clear: {} is in sight of {} in the plan, {length} away along the surface, through {through}",
                ends[1], ends[0]
            )?;
        }
        Some(hit) => {
            let vertex = hit.vertex.as_ref().map(|v| format!(" at its end {v}")).unwrap_or_default();
            let (face, [a, b], at) = (&hit.face, &hit.side, told(&hit.point));
            writeln!(
                out,
                "hit: the side {a} {b} of {face}{vertex}, at {at}, {length} away along the surface, through {through}"
            )?;
        }
    }
    Ok(Answer::Yes)
}
