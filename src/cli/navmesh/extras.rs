//! Costs of faces and links between places, as the command line gives them.

use super::super::failure::Failure;
use super::areas::{Area, area};
use super::ends::Snap;
use super::map::Map;
use super::numbers::number;
use super::space::{Ground, Wish};
use super::tell::point;
use dcel_kit::navmesh::{Link, PathAlgorithm, Stop, SurfaceLink, SurfacePoint};

/// What changes the length of a path beside walls.
#[derive(clap::Args, Debug)]
#[command(next_help_heading = "Costs and links")]
pub(super) struct Extras {
    #[command(flatten)]
    costs: CostArgs,
    #[command(flatten)]
    links: LinkArgs,
}

/// Areas with costs.
#[derive(clap::Args, Debug)]
#[command(next_help_heading = "Costs and links")]
pub(super) struct CostArgs {
    /// A unit of length in an area costs as much; may be given several times. An area is faces (f3,f7-f9=2),
    /// a name of them (a group, object or material of an .obj, a feature of GeoJSON: mud=2), or corners
    /// (x,y,x,y,x,y=2), along which faces are cut. Answers are good ones for these costs, not the best of
    /// all; a path needs a quicker rule than --algorithm exact
    #[arg(long, value_name = "AREA=COST", value_parser = area, allow_hyphen_values = true)]
    cost: Vec<Area>,
}

/// Links between places.
#[derive(clap::Args, Debug)]
#[command(next_help_heading = "Costs and links")]
pub(super) struct LinkArgs {
    /// A teleport, ladder or jump from one point to another, one way, that costs as much as this
    /// length; may be given several times. On a floor whose heights differ points may have three
    /// coordinates, as the file has them
    #[arg(long, value_name = "X0,Y0,X1,Y1,COST", value_parser = link, allow_hyphen_values = true)]
    link: Vec<LinkWish>,
}

/// A link of the command line: two points of two or of three numbers, and what it costs.
#[derive(Clone, Debug)]
struct LinkWish {
    numbers: Vec<f64>,
    cost: f64,
}

fn link(text: &str) -> Result<LinkWish, String> {
    let mut numbers: Vec<f64> = text.split(',').map(|word| number(word.trim())).collect::<Result<_, String>>()?;
    if ![5, 7].contains(&numbers.len()) {
        return Err("give five numbers: x0,y0,x1,y1,cost; or seven on a floor in space".to_owned());
    }
    let cost = numbers.pop().unwrap_or_default();
    if cost < 0.0 { Err("a cost is 0 or more".to_owned()) } else { Ok(LinkWish { numbers, cost }) }
}

impl Extras {
    /// Refuses costs for searches that know none.
    pub(super) fn check(&self, algorithm: PathAlgorithm, word: &str) -> Result<(), Failure> {
        if self.areas().is_empty() || !matches!(algorithm, PathAlgorithm::Exact | PathAlgorithm::Breadth) {
            return Ok(());
        }
        let what = format!("--cost cannot be used with --algorithm {word}: it counts lengths or faces");
        Err(Failure::input(what, "choose a quicker rule, for example --algorithm closest"))
    }

    /// The links between places.
    pub(super) fn links(&self) -> &LinkArgs {
        &self.links
    }

    /// The areas with costs.
    pub(super) fn areas(&self) -> &[Area] {
        self.costs.areas()
    }
}

impl CostArgs {
    /// The areas with costs.
    pub(super) fn areas(&self) -> &[Area] {
        &self.cost
    }
}

impl LinkArgs {
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
        let link = |wish: &LinkWish| match wish.numbers[..] {
            [x0, y0, x1, y1] => {
                Ok(Link { from: stop([x0, y0], "start")?, to: stop([x1, y1], "end")?, cost: wish.cost })
            }
            _ => Err(Failure::input(
                format!("{}: --link: its points have three coordinates, those of the map have two", map.source),
                "give x0,y0,x1,y1,cost",
            )),
        };
        self.link.iter().map(link).collect()
    }

    /// The links of a surface.
    pub(super) fn on(&self, ground: &Ground, snap: &Snap) -> Result<Vec<SurfaceLink>, Failure> {
        let place = |numbers: &[f64], what: &str| -> Result<SurfacePoint, Failure> {
            let wish = Wish { what, numbers, layer: None, face: None };
            Ok(ground.end(&wish, snap)?.places[0])
        };
        let link = |LinkWish { numbers, cost }: &LinkWish| {
            let [from, to] = [&numbers[..numbers.len() / 2], &numbers[numbers.len() / 2..]];
            Ok(SurfaceLink { from: place(from, "link's start")?, to: place(to, "link's end")?, cost: *cost })
        };
        self.link.iter().map(link).collect()
    }
}
