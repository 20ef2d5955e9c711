//! Ways over maps and places on them, by one program in a process of its own: what the race starts for its rows of navmeshes.
//!
//! `ways version` prints the release of the peer, `ways PROGRAM exact|locate caves|blocks` nanoseconds a way or a place: the
//! median of three runs after a first one. The kit prepares itself in the first run, the peer is baked before it.

use cpu_time::ProcessTime;
use dcel_kit::navmesh::{Location, NavMesh, PathAlgorithm, Planner};
use dcel_kit::plane::{Point, Subdivision};
use dcel_kit_ways::Random;
use dcel_kit_ways::maps::{anywhere, blocks, caves, merged_peer, pairs, peer, triangles, vec};
use std::hint::black_box;
use std::process::ExitCode;

const LOCK: &str = include_str!("../Cargo.lock");

fn main() -> ExitCode {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = words.iter().flat_map(|word| word.split(' ')).collect();
    match words[..] {
        ["version"] => {
            let rest = LOCK.split_once("name = \"polyanya\"\nversion = \"").map_or("", |(_, rest)| rest);
            println!("{}", rest.split('"').next().unwrap_or_default());
            ExitCode::SUCCESS
        }
        [program, task, name] => match work(program, task, name) {
            Some((count, mut work)) => {
                work();
                let mut times = [(); 3].map(|()| {
                    let start = ProcessTime::now();
                    black_box(work());
                    start.elapsed().as_nanos() as f64 / count as f64
                });
                times.sort_by(f64::total_cmp);
                println!("{}", times[1]);
                ExitCode::SUCCESS
            }
            None => usage(),
        },
        _ => usage(),
    }
}

fn usage() -> ExitCode {
    eprintln!("error: ways version, or ways dcel-kit|polyanya|merged exact|locate caves|blocks");
    ExitCode::from(2)
}

/// How many ways or places there are, and finding them all; what it gives back is the number of those found.
type Work = (usize, Box<dyn FnMut() -> usize>);

fn work(program: &str, task: &str, name: &str) -> Option<Work> {
    let mut random = Random::new(5);
    let map = match name {
        "caves" => triangles(caves(400, false, &mut random).regions().ok()?),
        "blocks" => blocks(75, &mut random),
        _ => return None,
    };
    let mesh = NavMesh::new(&map).ok()?;
    let points = anywhere(&mesh, &mut random);
    match task {
        "locate" => locate(program, &map, mesh, points),
        "exact" => ways(program, &map, mesh, &points),
        _ => None,
    }
}

fn locate(program: &str, map: &Subdivision, mesh: NavMesh, points: Vec<Point>) -> Option<Work> {
    let count = points.len();
    Some(match program {
        "dcel-kit" => {
            let is_inside = move |p: &&Point| matches!(mesh.locate(**p), Location::Face(_));
            (count, Box::new(move || points.iter().filter(&is_inside).count()))
        }
        "polyanya" => {
            let peer = peer(map, &mesh);
            (count, Box::new(move || points.iter().filter(|p| peer.point_in_mesh(vec(**p))).count()))
        }
        _ => return None,
    })
}

fn ways(program: &str, map: &Subdivision, mesh: NavMesh, points: &[Point]) -> Option<Work> {
    let inside: Vec<Point> = points.iter().copied().filter(|&p| matches!(mesh.locate(p), Location::Face(_))).collect();
    let queries = pairs(&mesh, &inside);
    let count = queries.len();
    let peer = match program {
        "dcel-kit" => {
            let mut planner = Planner::new();
            let find = move || {
                let mut way = |from, to| planner.route_between(&mesh, PathAlgorithm::Exact, from, to).is_ok();
                queries.iter().filter(|&&(from, to)| way(from, to)).count()
            };
            return Some((count, Box::new(find)));
        }
        "polyanya" => peer(map, &mesh),
        "merged" => merged_peer(map, &mesh),
        _ => return None,
    };
    let find = move || queries.iter().filter(|&&(from, to)| peer.path(vec(from), vec(to)).is_some()).count();
    Some((count, Box::new(find)))
}
