//! Costs of faces and links between places, as the command line gives them.

use super::super::failure::Failure;
use super::areas::{Area, area};
use super::ends::Snap;
use super::map::Map;
use super::numbers::number;
use super::routes::Links;
use super::space::{Ground, Wish};
use super::tell::point;
use dcel_kit::navmesh::{Link, PathAlgorithm, Stop, SurfaceLink};

/// What changes the length of a path beside walls.
#[derive(clap::Args, Debug)]
#[command(next_help_heading = "Costs and links")]
pub(super) struct Extras {
    #[command(flatten)]
    pub(super) costs: CostArgs,
    #[command(flatten)]
    pub(super) links: LinkArgs,
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
    pub(super) cost: Vec<Area>,
}

/// Links between places.
#[derive(clap::Args, Debug)]
#[command(next_help_heading = "Costs and links")]
pub(super) struct LinkArgs {
    /// A teleport, ladder or jump from one point to another, one way, that costs as much as this
    /// length; may be given several times. At a point where holes touch, or on a wall, it begins or ends on
    /// all sides. On a floor in space (--up) points may have three coordinates, as the file has them
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
        let (why, rule) = match algorithm {
            PathAlgorithm::Exact => ("exact finds the shortest path, whatever faces cost", "a quicker rule"),
            PathAlgorithm::Breadth => ("bfs counts faces, whatever they cost", "a rule that counts lengths"),
            _ => return Ok(()),
        };
        if self.costs.cost.is_empty() {
            return Ok(());
        }
        let what = format!("--cost cannot be used with --algorithm {word}: {why}");
        Err(Failure::input(what, format!("choose {rule}, for example --algorithm closest")))
    }
}

impl LinkArgs {
    /// The links; their ends must be on the mesh.
    pub(super) fn links(&self, map: &Map) -> Result<Links<Link>, Failure> {
        let stops = |numbers: &[f64], what: &str| -> Result<Vec<Stop>, Failure> {
            let Some([at]) = map.flat(numbers)? else {
                let why = "its points have three coordinates, those of the map have two";
                return Err(Failure::input(format!("{}: --link: {why}", map.source), "give x0,y0,x1,y1,cost"));
            };
            let p = map.point(at);
            let places = map.mesh.places(p).map_err(|error| {
                let nearest = map.mesh.nearest_point(p);
                let help = nearest.map(|nearest| format!("the nearest place is {}", point(map, nearest.place.point)));
                let why = super::tell::refusal(map, &error);
                Failure::input(format!("{}: --link: its {what} {why}", map.source), help.unwrap_or_default())
            })?;
            Ok(places.into_iter().map(|place| Stop { layer: 0, place }).collect())
        };
        self.between(stops, |&from, &to, cost| Link { from, to, cost })
    }

    /// The links of a surface.
    pub(super) fn on(&self, ground: &Ground, snap: &Snap) -> Result<Links<SurfaceLink>, Failure> {
        let places = |numbers: &[f64], what: &str| {
            let wish = Wish { what: &format!("link's {what}"), numbers, layer: None, face: None };
            ground.end(&wish, snap).map(|end| end.places)
        };
        self.between(places, |&from, &to, cost| SurfaceLink { from, to, cost })
    }

    /// The links, from each of the places at a start to each at an end.
    fn between<P, L>(
        &self,
        places: impl Fn(&[f64], &str) -> Result<Vec<P>, Failure>,
        link: impl Fn(&P, &P, f64) -> L,
    ) -> Result<Links<L>, Failure> {
        let mut links = Links::new();
        for LinkWish { numbers, cost } in &self.link {
            let (from, to) = numbers.split_at(numbers.len() / 2);
            let [from, to] = [places(from, "start")?, places(to, "end")?];
            links.add([&from, &to], |from, to| link(from, to, *cost));
        }
        Ok(links)
    }
}
