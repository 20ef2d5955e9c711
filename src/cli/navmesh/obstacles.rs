//! Walls and obstacles of the command line, put into a map before anything is asked of it.

use super::super::failure::Failure;
use super::super::output;
use super::map::Frame;
use super::numbers::number;
use dcel_kit::FaceMap;
use dcel_kit::navmesh::{LiveMesh, NavMesh, NavMeshError, ObstacleError};
use dcel_kit::plane::{ConvertError, InsertSegmentError, Point, Subdivision, is_counter_clockwise};

/// What is put into the map.
#[derive(clap::Args, Debug, Default)]
#[command(next_help_heading = "Obstacles")]
pub(super) struct ObstacleArgs {
    /// Put up a wall between two points; may be given several times
    ///
    /// Time and memory grow as k log k with the number k of sides of the faces along the wall; where borders or other walls
    /// cut it into pieces that lie in one large hole, as the product of the number of pieces and the size of the hole.
    ///
    /// Where another wall crosses a slanted one, rounding bends it by a few last places: a point that lies exactly on the
    /// line may be on either side of it there.
    #[arg(long, value_name = "X0,Y0,X1,Y1", value_parser = wall, allow_hyphen_values = true)]
    wall: Vec<Corners>,
    /// Put in an obstacle with these corners, in order, either way round; may be given several times
    ///
    /// It costs what its sides cost as walls, and the faces inside; as the square if it is thin and lies round many vertices
    /// that nothing but edges across it hold.
    #[arg(long, value_name = "X,Y,X,Y,X,Y", value_parser = polygon, allow_hyphen_values = true)]
    obstacle: Vec<Corners>,
}

/// Points as the file has them, and the words they were given by.
#[derive(Clone, Debug)]
pub(super) struct Corners {
    points: Vec<[f64; 2]>,
    text: String,
}

fn corners(text: &str) -> Result<Corners, String> {
    let numbers: Result<Vec<f64>, String> = text.split(',').map(|word| number(word.trim())).collect();
    let numbers = numbers?;
    if !numbers.len().is_multiple_of(2) {
        return Err(format!("{} numbers are no points: give x and y of each", numbers.len()));
    }
    let points = numbers.chunks_exact(2).map(|p| [p[0], p[1]]).collect();
    Ok(Corners { points, text: text.to_owned() })
}

fn wall(text: &str) -> Result<Corners, String> {
    let ends = corners(text)?;
    if ends.points.len() == 2 { Ok(ends) } else { Err("a wall has two ends: give x0,y0,x1,y1".to_owned()) }
}

fn polygon(text: &str) -> Result<Corners, String> {
    let corners = corners(text)?;
    if corners.points.len() > 2 { Ok(corners) } else { Err("an obstacle has three corners or more".to_owned()) }
}

impl ObstacleArgs {
    /// Whether there is anything to put in.
    pub(super) fn are_given(&self) -> bool {
        !self.wall.is_empty() || !self.obstacle.is_empty()
    }

    /// The map with everything put in, its navmesh, and what faces cost in it if they had costs before. `frame` is
    /// that of the file.
    pub(super) fn put_in(
        &self,
        source: &str,
        map: Subdivision,
        costs: Option<&FaceMap<f64>>,
        frame: Frame,
    ) -> Result<(Subdivision, NavMesh, Option<FaceMap<f64>>), Failure> {
        // Faces of one cost are one area.
        let mut areas: Vec<f64> = costs.iter().flat_map(|costs| costs.as_slice()).copied().collect();
        areas.sort_by(f64::total_cmp);
        areas.dedup();
        let live = match costs {
            None => LiveMesh::new(map),
            Some(costs) => LiveMesh::with_areas(map, |f| {
                let cost = costs.get(f).copied().unwrap_or(1.0);
                areas.partition_point(|area| area.total_cmp(&cost).is_lt()) as u32
            }),
        };
        let mut live = live.map_err(|error: NavMeshError| Failure::about(source, error))?;
        let given = self.wall.iter().map(|corners| ("--wall", corners));
        for (flag, Corners { points, text }) in given.chain(self.obstacle.iter().map(|corners| ("--obstacle", corners)))
        {
            let refused = |why: String, help: &str| Failure::input(format!("{source}: {flag} {text}: {why}"), help);
            let next = points.iter().cycle().skip(1);
            if let Some((side, (&p, _))) =
                points.iter().zip(next).enumerate().find(|&(_, (&p, &q))| Point::from(p) == Point::from(q))
            {
                let (what, help) = match points.len() {
                    2 => ("wall", "give two different ends"),
                    _ => ("obstacle", "give the corners in order, each once"),
                };
                let place = output::point(&p);
                return Err(refused(
                    format!("side {side} of the {what} has no length: both its ends are {place}"),
                    help,
                ));
            }
            let mut points: Vec<Point> = points.iter().map(|&p| frame.point(p)).collect();
            if !is_counter_clockwise(&points) {
                points.reverse();
            }
            let put = match points[..] {
                [p, q] => live.insert_wall(p, q),
                _ => live.insert_obstacle(&points),
            };
            put.map_err(|error| match error {
                ObstacleError::Polygon(error) => {
                    let help = match error {
                        ConvertError::ZeroArea { .. } => "give corners round an area, or put up a --wall",
                        _ => "give the corners in order, each once",
                    };
                    refused(format!("the obstacle is no simple polygon: {}", of_polygon(&error, &points, frame)), help)
                }
                ObstacleError::Side { error: InsertSegmentError::Split { half_edge, at, error }, .. } => {
                    let at = Point::from(frame.in_file(at));
                    let error = InsertSegmentError::Split { half_edge, at, error };
                    refused(
                        error.to_string(),
                        "move it a little: corners lie as near to that place as rounding reaches",
                    )
                }
                // The numbers of sides are those of the corners in counter-clockwise order.
                ObstacleError::Side { error, .. } => refused(error.to_string(), ""),
                error => refused(error.to_string(), ""),
            })?;
        }
        let costs = costs.map(|_| {
            let mut costs = FaceMap::filled(live.mesh().face_bound(), 1.0);
            for f in live.mesh().faces() {
                costs[f] = live.area(f).and_then(|area| areas.get(area as usize)).copied().unwrap_or(1.0);
            }
            costs
        });
        let (map, mesh) = live.into_parts();
        Ok((map, mesh, costs))
    }
}

/// What is wrong with the polygon of these corners, with their places in the file.
fn of_polygon(error: &ConvertError, corners: &[Point], frame: Frame) -> String {
    let corner = |v: u32| match corners.get(v as usize) {
        Some(&p) => output::point(&frame.in_file(p)),
        None => format!("corner {v}"),
    };
    let side = |&(a, b): &(u32, u32)| format!("its side {} -> {}", corner(a), corner(b));
    match error {
        ConvertError::ZeroArea { .. } => "its corners lie on one line".to_owned(),
        ConvertError::SelfCrossing { first, second, .. } => format!("{} crosses {}", side(first), side(second)),
        ConvertError::SelfTouching { vertex, side: touched, .. } => {
            format!("its corner {} lies on {}", corner(*vertex), side(touched))
        }
        other => other.to_string(),
    }
}
