//! `dcel navmesh distances`: how far everything is from one place.

use super::super::output::{names, point as told, table};
use super::super::{Answer, Failure, Output, fields, tell};
use super::drawing::{Drawing, save};
use super::ends::{End, Snap, Wish};
use super::extras::{CostArgs, LinkArgs};
use super::numbers::number;
use super::reading::{Input, MapArgs};
use super::routes::{ON_SIDES, from_each};
use super::space;
use super::tell::point;
use dcel_kit::figure::navmesh::Floor;
use dcel_kit::io::counted;
use dcel_kit::navmesh::{DistanceField, Planner, Stop};
use dcel_kit::{FaceId, VertexId};
use std::io::Write;

/// Tell how far every vertex is from a point, by the shortest paths
///
/// With --limit: what can be reached within a length: vertices, and faces all of whose corners can be
/// reached; a face of which a part only is within the limit does not count, that of the start neither.
/// From a start where holes touch, or on a wall, the nearest of its sides
/// counts. With --cost: how much it costs to get there, by
/// paths that pass the sides of faces at their ends and some points between: never less than the least
/// cost, and seldom more than it by a tenth where costs are between 1 and 20. Thin dear faces among
/// faces that cost nothing can make it more.
#[derive(clap::Args, Debug)]
#[command(after_help = "\
Many vertices inside an open floor take long: twice as many \
up to four times; so do rows of pillars. --limit bounds it.

Examples:
  dcel navmesh distances rooms.map 1 1 --limit 6
  dcel navmesh distances rooms.map 1 1 --json \\
    -o distances.svg
  dcel navmesh distances rooms.map 1 1 \\
    --link 2,1,22,11,0.5
  dcel navmesh distances rooms.map 1 1 \\
    --cost 9,0,14,0,14,9=2
  dcel navmesh distances house.obj --up z 1 1 0")]
pub(super) struct Args {
    #[command(flatten)]
    pub(super) map: MapArgs,
    /// The point: x y, as the file has it; on a floor in space (--up) x y z, too
    #[arg(value_names = ["X", "Y"], num_args = 2..=3, required = true, allow_negative_numbers = true, value_parser = number)]
    pub(super) start: Vec<f64>,
    /// Leave out what is further away than this
    #[arg(long, value_name = "LENGTH", value_parser = number)]
    pub(super) limit: Option<f64>,
    /// The face to start from, where holes touch in the start
    #[arg(long, value_name = "f3")]
    pub(super) start_face: Option<FaceId>,
    /// The layer of the start, where storeys lie over each other
    #[arg(long, value_name = "N")]
    pub(super) start_layer: Option<usize>,
    #[command(flatten)]
    pub(super) snap: Snap,
    #[command(flatten)]
    pub(super) costs: CostArgs,
    #[command(flatten)]
    pub(super) links: LinkArgs,
    /// Answer in JSON
    #[arg(long)]
    pub(super) json: bool,
    #[command(flatten)]
    drawing: Drawing,
}

pub(super) fn run(args: &Args, out: &mut Output) -> Result<Answer, Failure> {
    if let Some(limit) = args.limit.filter(|&limit| limit < 0.0) {
        return Err(Failure::input(format!("a limit of {limit}"), "give a length of 0 or more"));
    }
    args.snap.check()?;
    let target = args.drawing.target(&args.map.file)?;
    let draft = match args.map.read_as(!args.map.obstacles.are_given())? {
        Input::Plane(draft) => *draft,
        Input::Space(ground) => return space::distances::run(&ground, args, target.as_ref(), out),
    };
    let map = args.map.open_draft(draft, &args.costs.cost)?;
    let what = format!("{} numbers are no point", args.start.len());
    let [start] = map.points(&args.start, &what, "give x and y")?;
    let wish = Wish { what: "start", coordinates: start, face: args.start_face };
    let End { asked, places, moved } = args.snap.wished(&map, &wish)?;
    from_each(&point(&map, asked), ON_SIDES, places.iter().map(|place| place.face));
    let start = places.first().map_or(asked, |place| place.point);
    let links = &args.links.links(&map)?.sides;
    let limit = args.limit.unwrap_or(f64::INFINITY);
    let layers = std::slice::from_ref(&map.mesh);
    let costs = map.costs(&args.costs.cost)?;
    let mut nearest: Option<DistanceField> = None;
    for place in places {
        let fields = match &costs {
            Some(costs) => {
                Planner::new().weighted_distance_field(&map.mesh, costs, links, &place, limit).map(|field| vec![field])
            }
            None => Planner::new().linked_distance_field(layers, links, &Stop { layer: 0, place }, limit),
        };
        for field in fields.map_err(|error| Failure::about(&map.source, error))? {
            match &mut nearest {
                Some(nearest) => nearest.join(&field, 0.0),
                None => nearest = Some(field),
            }
        }
    }
    let field = &nearest.ok_or_else(|| Failure::kit("a start has a place"))?;
    if let Some(target) = &target {
        let options = target.options(&map, &format!("Distances in {}", args.map.title()));
        save(target, Floor::new(&map.subdivision, &map.mesh).reach(field, &options), out)?;
    }
    let vertices = (0..map.mesh.vertex_bound() as u32).map(VertexId::new);
    let vertices = vertices.filter_map(|v| Some((v, map.in_file(map.mesh.point(v)), field.distance(v)?)));
    let faces = field.faces_within(&map.mesh);
    args.tell(&map.source, (map.in_file(start), moved), vertices, faces, "", out)
}

impl Args {
    /// Tells how far vertices are, by their points in the file, and which faces have every corner within the limit.
    pub(super) fn tell<const N: usize>(
        &self,
        source: &str,
        (start, start_moved): ([f64; N], Option<f64>),
        vertices: impl Iterator<Item = (VertexId, [f64; N], f64)>,
        faces: impl Iterator<Item = FaceId>,
        along: &str,
        out: &mut Output,
    ) -> Result<Answer, Failure> {
        let vertex = |(v, p, distance): (VertexId, [f64; N], f64)| {
            fields! { vertex: v.to_string(), point: p.to_vec(), distance }
        };
        let answer = fields! {
            source,
            start: start.to_vec(),
            start_moved,
            limit: self.limit,
            vertices: vertices.map(vertex).collect::<Vec<_>>(),
            faces: names(faces),
        };
        tell(&answer, self.json, out, |out| {
            let within = self.limit.map_or_else(|| "can be reached".to_owned(), |limit| format!("are within {limit}"));
            let reached = counted(answer.faces.len(), "face", "faces");
            let vertices = counted(answer.vertices.len(), "vertex", "vertices");
            writeln!(out, "from {}: {vertices} and {reached} {within}{along}", told(&start))?;
            let rows = answer.vertices.iter().map(|of| [of.vertex.clone(), told(&of.point), of.distance.to_string()]);
            table(out, &rows.collect::<Vec<_>>())
        })
    }
}
