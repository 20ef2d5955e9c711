//! `dcel navmesh distances` on a floor whose heights differ.

use super::super::super::failure::Failure;
use super::super::super::output::{point as told, table};
use super::super::super::{Answer, Output};
use super::super::drawing::{Canvas, save};
use super::super::ends::Snap;
use super::super::extras::{CostArgs, LinkArgs};
use super::{Ground, Wish};
use dcel_kit::VertexId;
use dcel_kit::figure::navmesh::Storeys;
use dcel_kit::navmesh::SurfacePlanner;
use serde::Serialize;
use std::collections::BTreeMap;
use std::io::Write;

/// The answer. The names are those of the JSON form.
#[derive(Serialize)]
struct Answered {
    source: String,
    start: [f64; 3],
    limit: Option<f64>,
    vertices: Vec<Row>,
    /// The faces of which every corner is within the limit.
    faces: Vec<String>,
}

#[derive(Serialize)]
struct Row {
    vertex: String,
    point: [f64; 3],
    distance: f64,
}

/// What is asked for.
pub(in super::super) struct Question<'a> {
    pub(in super::super) wish: Wish<'a>,
    pub(in super::super) limit: Option<f64>,
    pub(in super::super) costs: &'a CostArgs,
    pub(in super::super) links: &'a LinkArgs,
    pub(in super::super) json: bool,
    pub(in super::super) target: Option<&'a Canvas>,
    pub(in super::super) title: String,
}

pub(in super::super) fn run(ground: &Ground, question: &Question<'_>, out: &mut Output) -> Result<Answer, Failure> {
    let surface = &ground.surface;
    let start = ground.end(&question.wish, &Snap::none())?.places[0];
    let links = question.links.on(ground, &Snap::none())?;
    let limit = question.limit.unwrap_or(f64::INFINITY);
    let field = match ground.costs(question.costs.areas())? {
        Some(costs) => SurfacePlanner::new().weighted_distance_field(surface, &costs, &links, &start, limit),
        None => SurfacePlanner::new().linked_distance_field(surface, &links, &start, limit),
    };
    let field = field.map_err(|error| Failure::input(format!("{}: {error}", ground.source), ""))?;
    if let Some(target) = question.target {
        let options = ground.options(target, &format!("Distances on {}", question.title));
        save(target, Storeys::new(surface).reach(&field, &start, &options), out)?;
    }
    let vertices: BTreeMap<VertexId, [f64; 3]> = surface.faces().flat_map(|f| surface.vertices(f)).collect();
    let row = |(&v, &p): (&VertexId, &[f64; 3])| {
        Some(Row { vertex: v.to_string(), point: ground.in_file(p), distance: field.distance(v)? })
    };
    let is_within = |f: &dcel_kit::FaceId| surface.vertices(*f).all(|(v, _)| field.distance(v).is_some());
    let answer = Answered {
        source: ground.source.clone(),
        start: ground.in_file(start.point),
        limit: question.limit,
        vertices: vertices.iter().filter_map(row).collect(),
        faces: surface.faces().filter(is_within).map(|f| f.to_string()).collect(),
    };
    if question.json {
        out.json(&answer)?;
        return Ok(Answer::Yes);
    }
    let within = question.limit.map_or_else(|| "can be reached".to_owned(), |limit| format!("are within {limit}"));
    let count = answer.vertices.len();
    let (plural, reached) =
        (if count == 1 { "vertex" } else { "vertices" }, super::super::tell::faces(answer.faces.len()));
    writeln!(out, "from {}: {count} {plural} and {reached} {within}, along the surface", told(&answer.start))?;
    let rows: Vec<_> =
        answer.vertices.iter().map(|row| [row.vertex.clone(), told(&row.point), row.distance.to_string()]).collect();
    table(out, &rows)?;
    Ok(Answer::Yes)
}
