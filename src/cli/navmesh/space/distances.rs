//! `dcel navmesh distances` on a floor whose heights differ.

use super::super::super::output::point as told;
use super::super::super::{Answer, Failure, Output};
use super::super::distances::Args;
use super::super::drawing::{Canvas, save};
use super::super::routes::{WHERE_FACES_TOUCH, from_each};
use super::{End, Ground, Wish};
use dcel_kit::figure::navmesh::Storeys;
use dcel_kit::navmesh::{SurfacePlanner, SurfacePoint};
use dcel_kit::{FaceId, VertexId};
use std::collections::BTreeMap;

pub(in super::super) fn run(
    ground: &Ground,
    args: &Args,
    target: Option<&Canvas>,
    out: &mut Output,
) -> Result<Answer, Failure> {
    let surface = &ground.surface;
    let wish = Wish { what: "start", numbers: &args.start, layer: args.start_layer, face: args.start_face };
    let End { places, moved } = ground.end(&wish, &args.snap)?;
    from_each(&told(&args.start), WHERE_FACES_TOUCH, places.iter().map(|place| place.face));
    let start = places[0];
    let links = &args.links.on(ground, &args.snap)?.sides;
    let limit = args.limit.unwrap_or(f64::INFINITY);
    let costs = ground.costs(&args.costs.cost)?;
    let from = |start: &SurfacePoint| {
        let field = match &costs {
            Some(costs) => SurfacePlanner::new().weighted_distance_field(surface, costs, links, start, limit),
            None => SurfacePlanner::new().linked_distance_field(surface, links, start, limit),
        };
        field.map_err(|error| Failure::about(&ground.source, error))
    };
    let mut field = from(&start)?;
    for other in &places[1..] {
        field.join(&from(other)?, 0.0);
    }
    if let Some(target) = target {
        let options = ground.options(target, &format!("Distances on {}", args.map.title()));
        save(target, Storeys::new(surface).reach(&field, &start, &options), out)?;
    }
    let vertices: BTreeMap<VertexId, [f64; 3]> = surface.faces().flat_map(|f| surface.vertices(f)).collect();
    let vertices = vertices.into_iter().filter_map(|(v, p)| Some((v, ground.in_file(p), field.distance(v)?)));
    let is_within = |f: &FaceId| surface.vertices(*f).all(|(v, _)| field.distance(v).is_some());
    let start = (ground.in_file(start.point), moved);
    args.tell(&ground.source, start, vertices, surface.faces().filter(is_within), ", along the surface", out)
}
