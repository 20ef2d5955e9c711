//! Paths and fields over links of a surface against a plain program that relaxes all pairs of places, the legs between
//! which are asked for one by one.

use crate::maps::{Map, Random};
use crate::routes::is_close;
use crate::surface::{check, far, list};
use dcel_kit::navmesh::{
    Floor, LinkError, NavSurface, PathAlgorithm, SurfaceLink, SurfacePlanner, SurfacePoint, SurfaceRoute,
};
use dcel_kit::{FaceMap, VertexId};

/// Hills in several pieces, and `count` places on them.
fn hills(seed: u64, count: usize, random: &mut Random) -> (Map, NavSurface, Vec<SurfacePoint>) {
    let map = Map::random(seed + 1200, 4, 0.65, 0.4);
    let points: Vec<[f64; 3]> = map.points.iter().map(|p| [p.x, p.y, random.unit()]).collect();
    let faces: Vec<Vec<u32>> = map.triangles.iter().map(|t| t.to_vec()).collect();
    let surface = NavSurface::new(&points, &list(&faces), None).expect("a surface");
    let place = |_| {
        let p = map.inside(random.below(map.triangles.len()), random);
        surface.place([p.x, p.y], Floor::Any).expect("inside")
    };
    let places = (0..count).map(place).collect();
    (map, surface, places)
}

/// The least costs of all places from the first one, by relaxing every pair until nothing changes. Place 1 is the goal; 2
/// and 3, 4 and 5, ... are links. Legs lead from the start and from ends of links to the goal and to where links begin.
fn least(
    places: &[SurfacePoint],
    links: &[SurfaceLink],
    mut leg: impl FnMut(&SurfacePoint, &SurfacePoint) -> Option<f64>,
) -> Vec<f64> {
    let mut edges: Vec<(usize, usize, f64)> =
        links.iter().enumerate().map(|(i, link)| (2 * i + 2, 2 * i + 3, link.cost)).collect();
    let is_begin = |i: usize| i == 1 || (i > 1 && i.is_multiple_of(2));
    for (a, from) in places.iter().enumerate().filter(|&(a, _)| !is_begin(a)) {
        let to = places.iter().enumerate().filter(|&(b, _)| is_begin(b));
        edges.extend(to.filter_map(|(b, to)| Some((a, b, leg(from, to)?))));
    }
    let mut costs = vec![f64::INFINITY; places.len()];
    costs[0] = 0.0;
    for _ in 0..places.len() {
        for &(a, b, cost) in &edges {
            costs[b] = costs[b].min(costs[a] + cost);
        }
    }
    costs
}

fn links_of(places: &[SurfacePoint], random: &mut Random) -> Vec<SurfaceLink> {
    let link = |pair: &[SurfacePoint]| {
        let cost = [0.0, 0.2, 0.6][random.below(3)] * random.unit();
        SurfaceLink { from: pair[0], to: pair[1], cost }
    };
    places[2..].chunks_exact(2).map(link).collect()
}

#[test]
fn a_path_over_links_of_a_surface_is_the_cheapest_of_all_with_and_without_costs() {
    let mut planner = SurfacePlanner::new();
    let (mut linked, mut apart, mut several) = (0, 0, 0);
    for seed in 0..60 {
        let mut random = Random::new(seed + 18_400);
        let count = 2 + 2 * (3 + random.below(5));
        let (_, surface, places) = hills(seed, count, &mut random);
        let links = links_of(&places, &mut random);
        // Faces that cost nothing, and such that all of them cost less than 1.
        let prices = [[0.0, 0.4, 1.0, 3.0], [0.2, 0.3, 0.6, 0.9]][seed as usize % 2];
        let costs: Vec<f64> = (0..surface.face_bound()).map(|_| prices[random.below(4)]).collect();
        let costs = FaceMap::from(costs);
        for costs in [None, Some(&costs)] {
            let context = format!("seed {seed}, {}", if costs.is_some() { "costs" } else { "lengths" });
            let mut find = |from: &SurfacePoint, to: &SurfacePoint| {
                let route = match costs {
                    Some(costs) => planner.weighted_route(&surface, PathAlgorithm::Closest, costs, from, to),
                    None => planner.route(&surface, PathAlgorithm::Exact, from, to),
                };
                route.ok().map(|route: SurfaceRoute| route.cost)
            };
            let expected = least(&places, &links, &mut find)[1];
            let algorithm = if costs.is_some() { PathAlgorithm::Closest } else { PathAlgorithm::Exact };
            let found = planner.linked_route(&surface, &links, algorithm, costs, [&places[0], &places[1]]);
            let Ok(path) = found else {
                assert_eq!((found, expected), (Err(LinkError::Unreachable), f64::INFINITY), "{context}");
                apart += 1;
                continue;
            };
            assert!((path.cost - expected).abs() <= 1e-9 * (1.0 + expected), "{context}: {path:?}, not {expected}");
            // The legs begin and end where the links do, and their costs are the whole.
            assert_eq!(path.legs.len(), path.links.len() + 1, "{context}");
            let mut sum: f64 = path.links.iter().map(|&i| links[i].cost).sum();
            for (i, leg) in path.legs.iter().enumerate() {
                let from = i.checked_sub(1).map_or(places[0], |before| links[path.links[before]].to);
                let to = path.links.get(i).map_or(places[1], |&link| links[link].from);
                if far(from.point, to.point) > 0.0 {
                    check(&surface, leg, [&from, &to], &context);
                }
                sum += leg.cost;
            }
            assert!((sum - path.cost).abs() <= 1e-9 * (1.0 + sum), "{context}: {sum} and not {}", path.cost);
            linked += usize::from(!path.links.is_empty());
            several += usize::from(path.links.len() > 1);
        }
    }
    assert!(linked > 20 && several > 5 && apart > 5, "{linked} linked, {several} by several, {apart} apart");
}

#[test]
fn a_field_over_links_of_a_surface_has_the_lengths_of_the_paths_over_them() {
    let mut planner = SurfacePlanner::new();
    let (mut compared, mut linked, mut beyond) = (0, 0, 0);
    for seed in 0..16 {
        let mut random = Random::new(seed + 18_500);
        let (map, surface, places) = hills(seed, 10, &mut random);
        let links = links_of(&places, &mut random);
        let limit = if seed % 3 == 0 { 2.0 } else { f64::INFINITY };
        let field = planner.linked_distance_field(&surface, &links, &places[0], limit).expect("costs");
        let mut find = |from: &SurfacePoint, to: &SurfacePoint| {
            planner.route(&surface, PathAlgorithm::Exact, from, to).ok().map(|route| route.cost)
        };
        let ends = least(&places, &links, &mut find);
        for (v, p) in (0..).map(VertexId::new).zip(&map.points) {
            // From the start and from the end of each link, to the vertex from whichever side.
            let goals = surface.places([p.x, p.y]);
            let starts = std::iter::once(0).chain((0..links.len()).map(|i| 2 * i + 3));
            let by = |i: usize| {
                let legs: Vec<f64> = goals.iter().filter_map(|goal| find(&places[i], goal)).collect();
                ends[i] + legs.into_iter().fold(f64::INFINITY, f64::min)
            };
            let lengths: Vec<f64> = starts.map(by).collect();
            let least = lengths.iter().copied().fold(f64::INFINITY, f64::min);
            match field.distance(v) {
                Some(found) => assert!(is_close(found, least), "seed {seed}, {v}: {found} and not {least}"),
                None => assert!(least > limit || least.is_infinite(), "seed {seed}, {v}: {least}"),
            }
            compared += usize::from(least.is_finite());
            linked += usize::from(least.is_finite() && least < lengths[0] * (1.0 - 1e-9));
            beyond += usize::from(least.is_finite() && least > limit);
        }
    }
    assert!(compared > 150 && linked > 50 && beyond > 20, "{compared} vertices, {linked} by links, {beyond} beyond");
}
