//! Costs of faces and links between places, as the command line gives them.

use super::super::failure::Failure;
use super::map::Map;
use super::tell::{number, point};
use dcel_kit::navmesh::{Link, NavMesh, Stop};
use dcel_kit::{FaceId, FaceMap};

/// What changes the length of a path beside walls.
#[derive(clap::Args, Debug)]
#[command(next_help_heading = "Costs and links")]
pub(super) struct Extras {
    /// A unit of length in these faces costs as much; may be given several times. Not for
    /// --rung exact: the corridor is a good one for these costs, not the best of all
    #[arg(long, value_name = "f3,f7-f9=COST", value_parser = area, conflicts_with_all = ["radius", "link"])]
    cost: Vec<Area>,
    /// A teleport, ladder or jump from one point to another, one way, that costs as much as this
    /// length; may be given several times
    #[arg(long, value_name = "X0,Y0,X1,Y1,COST", value_parser = link, allow_hyphen_values = true)]
    link: Vec<[f64; 5]>,
}

/// Faces and what they cost.
#[derive(Clone, Debug)]
struct Area {
    faces: Vec<[FaceId; 2]>,
    cost: f64,
}

fn area(text: &str) -> Result<Area, String> {
    let form = || "write it like f3=2.5, or f3,f7-f9=2.5".to_owned();
    let (faces, cost) = text.split_once('=').ok_or_else(form)?;
    let face = |word: &str| word.trim().parse::<FaceId>().map_err(|_| form());
    let range = |word: &str| match word.split_once('-') {
        Some((first, last)) => Ok([face(first)?, face(last)?]),
        None => face(word).map(|f| [f, f]),
    };
    let cost = number(cost.trim())?;
    if cost < 0.0 {
        return Err("a cost is 0 or more".to_owned());
    }
    Ok(Area { faces: faces.split(',').map(range).collect::<Result<_, String>>()?, cost })
}

fn link(text: &str) -> Result<[f64; 5], String> {
    let numbers: Vec<f64> = text.split(',').map(|word| number(word.trim())).collect::<Result<_, String>>()?;
    let link: [f64; 5] = numbers.try_into().map_err(|_| "give five numbers: x0,y0,x1,y1,cost".to_owned())?;
    if link[4] < 0.0 { Err("a cost is 0 or more".to_owned()) } else { Ok(link) }
}

impl Extras {
    /// The costs of all faces; `None` if none was given.
    pub(super) fn costs(&self, source: &str, mesh: &NavMesh) -> Result<Option<FaceMap<f64>>, Failure> {
        if self.cost.is_empty() {
            return Ok(None);
        }
        let mut costs = FaceMap::filled(mesh.face_bound(), 1.0);
        for Area { faces, cost } in &self.cost {
            for &[first, last] in faces {
                for f in (first.number()..=last.number()).map(FaceId::new) {
                    if !mesh.has_face(f) {
                        let what = format!("{source}: --cost: {f} is no face of the mesh");
                        return Err(Failure::input(what, "dcel navmesh locate tells the face of a point"));
                    }
                    costs[f] = *cost;
                }
            }
        }
        Ok(Some(costs))
    }

    /// The links; their ends must be on the mesh.
    pub(super) fn links(&self, map: &Map) -> Result<Vec<Link>, Failure> {
        let stop = |at: [f64; 2], what: &str| -> Result<Stop, Failure> {
            let p = map.point(at);
            let place = map.mesh.place(p).map_err(|error| {
                let nearest = map.mesh.nearest_point(p);
                let help = nearest.map(|nearest| format!("the nearest place is {}", point(map, nearest.place.point)));
                let why = super::tell::refusal(map, &error);
                Failure::input(format!("{}: --link: its {what} {why}", map.source), help.unwrap_or_default())
            })?;
            Ok(Stop { layer: 0, place })
        };
        let link = |&[x0, y0, x1, y1, cost]: &[f64; 5]| {
            Ok(Link { from: stop([x0, y0], "start")?, to: stop([x1, y1], "end")?, cost })
        };
        self.link.iter().map(link).collect()
    }
}
