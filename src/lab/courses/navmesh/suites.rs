//! The cases of lab 06, test by test.
//!
//! ```text
//!   small, that a student can type ─▶ every triangle of odd meshes ─▶ random ─▶ blind, rounding ─▶ large, with reads
//! ```

use super::answers::FUNCTIONS;
use super::funnel::{Sleeve, among, fan, nearly_straight, random_sleeve, winding};
use super::mesh::{Spot, build, cells, corners, corridor, neighbours, random_mesh, random_tree, relabelled, triangles};
use super::{costs, features, picture};
use crate::answers;
use crate::cases::random::Random;
use crate::cases::starts::{self, wheel};
use crate::checks::walks::{BLIND, IN_THE_BLIND, blind};
use crate::fault::{Exchange, Fault};
use crate::judge::{Asked, Judge, Suite};
use crate::pictures;
use crate::plan::Plan;
use crate::protocol::{Case, CaseAnswer, Start, Step, Structure};
use dcel_kit::topology::Table;
use dcel_kit::{Element, FaceId};
use std::sync::Arc;

/// The judge of lab 06.
pub struct NavMeshJudge;

/// How many random meshes are asked for each test, and how many sleeves.
const MESHES: usize = 8;
const SLEEVES: usize = 120;

impl Judge for NavMeshJudge {
    fn suites(&self, plan: &Plan) -> Vec<Suite> {
        let suite = |tests: &'static [&'static str], fixed: Vec<Case>, make: fn(&str, &mut Random) -> Vec<Case>| {
            let name = tests[0];
            let random = |seed, _| make(name, &mut Random::new(seed, name));
            let mut asked = Asked::fixed_and_seeded(fixed, plan, MESHES, random);
            asked.extend(Asked::fixed(large(name)));
            Suite::of(tests, asked)
        };
        let case = Case::new("corridor_svg", picture::start()).step(Step::Dump).step(Step::Svg);
        vec![
            suite(&["neighbours"], fixed_neighbours(), random_neighbours),
            suite(&["locate_by_scan"], fixed_points("locate_by_scan", false), random_points),
            suite(&["locate"], fixed_points("locate", true), random_points),
            suite(&["corridor"], fixed_corridors(), random_corridors),
            suite(&["portals"], with_blind("portals", |table, _| all_portals(table)), random_portals),
            suite(&["funnel"], fixed_sleeves(), random_sleeves),
            suite(&["path"], fixed_paths(), random_paths),
            Suite::of(&["corridor_svg"], Asked::fixed([case])),
        ]
    }

    fn judge(&self, suite: &Suite, case: &Case, answer: &CaseAnswer) -> Vec<Fault> {
        let mut faults = answers::judge(FUNCTIONS, case, answer);
        faults.extend(costs::judge(suite.tests[0], case, answer));
        faults.extend(pictures::judge_case(suite.tests[0], case, answer, picture::reference));
        if case.name.ends_with(BLIND) {
            faults.iter_mut().for_each(|fault| fault.words.push_str(IN_THE_BLIND));
        }
        faults
    }

    crate::features_of!(features);

    fn promise(&self, fault: &Fault) -> &'static str {
        match fault.test {
            "neighbours" => "neighbours lists the triangles across the sides of a triangle, counter-clockwise",
            "locate_by_scan" => {
                "locate_by_scan finds a triangle with the point in it or on its border, if there is one"
            }
            "locate" => "locate finds a triangle with the point in it or on its border, if there is one",
            "corridor" => "a corridor leads from neighbour to neighbour with as few triangles as possible",
            "portals" => "each portal has its left end on the left and its right end on the right",
            "funnel" => "the path through the portals is the shortest, and lists the points where it turns",
            "path" => "the path is the shortest one in the corridor",
            _ => "the picture shows the corridor, all edges, and the path",
        }
    }

    fn expected(&self, exchange: &Exchange) -> Option<Table> {
        let is_small = |table: &&Arc<Table>| table.half_edges.len() < 200 && exchange.function != "funnel";
        exchange.before().filter(is_small).map(|table| table.as_ref().clone())
    }

    fn answer(&self, exchange: &Exchange) -> Vec<Element> {
        let Some(table) = exchange.before() else { return Vec::new() };
        let ids = super::answers::asked(exchange).ids;
        let faces = match (exchange.function, &ids[..]) {
            ("neighbours", &[f]) => neighbours(table, f),
            ("corridor", &[start, goal]) => corridor(table, start, goal).unwrap_or_default(),
            _ => Vec::new(),
        };
        faces.into_iter().map(|f| FaceId::new(f).into()).collect()
    }
}

/// A mesh as the line that a student would type.
fn typed(points: &[Spot], triangles: &[[usize; 3]]) -> Start {
    let line = format!("mesh{} /{}", starts::points(points), starts::words(triangles.iter().flatten()));
    Start::known(line, Structure::HalfEdges(Arc::new(build(points, triangles))))
}

fn large_cells(n: usize, m: usize) -> Start {
    Start::known(format!("cells {n} {m}"), Structure::HalfEdges(Arc::new(cells(n, m))))
}

/// A mesh by its name, its points and its triangles.
type Small = (&'static str, Vec<Spot>, Vec<[usize; 3]>);

/// Two triangles; five round a point with a gap; two that meet at a corner only; a ring round a hole; two parts.
fn small() -> Vec<Small> {
    let ring = [[0.0, 0.0], [9.0, 0.0], [9.0, 9.0], [0.0, 9.0], [3.0, 3.0], [6.0, 3.0], [6.0, 6.0], [3.0, 6.0]];
    let round = [[0, 1, 5], [0, 5, 4], [1, 2, 6], [1, 6, 5], [2, 3, 7], [2, 7, 6], [3, 0, 4], [3, 4, 7]];
    let fan = [[0.0, 0.0], [5.0, 0.0], [4.0, 4.0], [0.0, 5.0], [-4.0, 4.0], [-5.0, 0.0]];
    vec![
        ("one", vec![[0.0, 0.0], [6.0, 1.0], [2.0, 5.0]], vec![[0, 1, 2]]),
        ("two", vec![[0.0, 0.0], [6.0, 0.0], [6.0, 4.0], [0.0, 4.0]], vec![[0, 1, 2], [0, 2, 3]]),
        ("fan", fan.to_vec(), vec![[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 5]]),
        ("corner", vec![[0.0, 0.0], [6.0, -4.0], [6.0, 4.0], [-6.0, 4.0], [-6.0, -4.0]], vec![[0, 1, 2], [0, 3, 4]]),
        ("ring", ring.to_vec(), round.to_vec()),
        (
            "parts",
            vec![[0.0, 0.0], [4.0, 0.0], [0.0, 3.0], [4.0, 3.0], [7.0, 0.0], [9.0, 0.0], [8.0, 2.0]],
            vec![[0, 1, 2], [1, 3, 2], [4, 5, 6]],
        ),
    ]
}

/// The small meshes and the map, as typed, then each with other numbers.
fn meshes() -> Vec<(String, Start, Table)> {
    let mut random = Random::new(6, "labels");
    let mut all: Vec<(String, Start, Table)> = small()
        .into_iter()
        .map(|(name, points, triangles)| (name.to_owned(), typed(&points, &triangles), build(&points, &triangles)))
        .collect();
    all.push(("map".to_owned(), picture::start(), picture::map()));
    for i in 0..all.len() {
        let other = relabelled(&all[i].2, &mut random);
        all.push((format!("{}.renamed", all[i].0), Start::table(other.clone()), other));
    }
    all
}

fn case(name: String, start: &Start, lines: impl IntoIterator<Item: AsRef<str>>) -> Case {
    costs::asks(name, start, lines, &[])
}

fn all_neighbours(table: &Table) -> Vec<String> {
    triangles(table).map(|f| format!("neighbours f{f}")).collect()
}

fn fixed_neighbours() -> Vec<Case> {
    let mut cases = Vec::new();
    for (name, start, table) in meshes() {
        cases.push(case(format!("neighbours.{name}"), &start, all_neighbours(&table)));
        let dark = blind(&table);
        cases.push(case(format!("neighbours.{name}{BLIND}"), &Start::table(dark), all_neighbours(&table)));
    }
    cases.push(case("neighbours.wheel".to_owned(), &wheel(40), (1..=40).map(|f| format!("neighbours f{f}"))));
    cases
}

/// Points of a mesh: the corners, the middles of the sides and of each triangle, and some outside.
fn points_of(table: &Table) -> Vec<Spot> {
    let mut points: Vec<Spot> = Vec::new();
    let half = |a: Spot, b: Spot| [0, 1].map(|axis| a[axis] / 2.0 + b[axis] / 2.0);
    for [a, b, c] in triangles(table).filter_map(|f| corners(table, f)) {
        points.extend([half(a, half(b, c)), half(a, b), half(b, c), half(c, a), a, b, c]);
    }
    let mut met: Vec<Spot> = Vec::new();
    points.retain(|p| {
        let is_new = !met.contains(p);
        met.push(*p);
        is_new
    });
    let far = points.iter().flatten().fold(0.0_f64, |far, x| far.max(x.abs())) + 1.0;
    points.extend([[far, 0.25], [-far, -far], [0.5, far]]);
    // In the hole of the ring, between the parts, in the pillar of the map.
    points.extend([[4.5, 4.5], [5.5, 1.0], [185.0, -5.0]]);
    points
}

fn fixed_points(function: &str, walks: bool) -> Vec<Case> {
    let mut cases: Vec<Case> = meshes()
        .into_iter()
        .map(|(name, start, table)| {
            let from: Vec<u32> = triangles(&table).collect();
            let line = |(i, [x, y]): (usize, Spot)| match walks {
                true => format!("{function} f{} {x} {y}", from[i % from.len()]),
                false => format!("{function} {x} {y}"),
            };
            case(format!("{function}.{name}"), &start, points_of(&table).into_iter().enumerate().map(line))
        })
        .collect();
    for (name, [[a, b], [c, d]]) in near_lines() {
        let points = [a, b, c, d];
        let start = typed(&points, &[[0, 1, 2], [1, 0, 3]]);
        // Points beside the common side, by the smallest steps that a coordinate can make.
        let lines = (0..40).map(|i| {
            let t = f64::from(i) / 40.0;
            let [x, y] = [0, 1].map(|axis| a[axis] + (b[axis] - a[axis]) * t);
            let y = [y, y.next_up(), y.next_down()][i as usize % 3];
            if walks { format!("{function} f{} {x} {y}", 1 + i % 2) } else { format!("{function} {x} {y}") }
        });
        cases.push(case(format!("{function}.{name}"), &start, lines));
    }
    cases
}

/// Two points with a line between them on which no point has a short name, and a point on each side of it.
fn near_lines() -> [(&'static str, [[Spot; 2]; 2]); 3] {
    let scaled = |unit: f64| {
        let at = |x: f64, y: f64| [x * unit, y * unit];
        [[at(0.1, 0.1), at(1.7, 0.8)], [at(0.2, 1.9), at(1.3, -0.9)]]
    };
    [("rounding", scaled(1.0)), ("rounding.large", scaled(1e15)), ("rounding.tiny", scaled(1e-30))]
}

fn all_corridors(table: &Table, with_outer: bool) -> Vec<String> {
    let faces = 0..table.faces.len() as u32;
    let kept = |f: &u32| with_outer || super::mesh::is_triangle(table, *f);
    let faces: Vec<u32> = faces.filter(kept).collect();
    faces.iter().flat_map(|f| faces.iter().map(move |g| format!("corridor f{f} f{g}"))).collect()
}

/// Questions about the meshes, and about those with their first numbers without places; `ask` is told whether a mesh
/// has places.
fn with_blind(function: &str, ask: impl Fn(&Table, bool) -> Vec<String>) -> Vec<Case> {
    let mut cases = Vec::new();
    for (name, start, table) in meshes() {
        cases.push(case(format!("{function}.{name}"), &start, ask(&table, true)));
        if !name.contains("renamed") {
            let dark = Start::table(blind(&table));
            cases.push(case(format!("{function}.{name}{BLIND}"), &dark, ask(&table, false)));
        }
    }
    cases
}

fn fixed_corridors() -> Vec<Case> {
    let mut cases = with_blind("corridor", all_corridors);
    let lines = [[1, 21], [1, 20], [7, 30], [40, 1]].map(|[f, g]| format!("corridor f{f} f{g}"));
    cases.push(case("corridor.wheel".to_owned(), &wheel(40), lines));
    cases
}

fn all_portals(table: &Table) -> Vec<String> {
    let line = |corridor: Vec<u32>| {
        let words: Vec<String> = corridor.iter().map(u32::to_string).collect();
        format!("portals {}", words.join(" "))
    };
    let pairs = triangles(table).flat_map(|f| triangles(table).map(move |g| (f, g)));
    pairs.filter_map(|(f, g)| corridor(table, f, g)).map(line).collect()
}

fn sleeve_line(sleeve: &Sleeve) -> String {
    let mut all = vec![sleeve.start, sleeve.goal];
    all.extend(sleeve.portals.iter().flatten());
    format!("funnel{}", starts::points(&all))
}

/// A case needs a structure to begin with, although this function looks at none.
fn sleeve_case(name: String, sleeves: impl IntoIterator<Item = Sleeve>) -> Case {
    let start = small().remove(0);
    case(name, &typed(&start.1, &start.2), sleeves.into_iter().map(|sleeve| sleeve_line(&sleeve)))
}

fn fixed_sleeves() -> Vec<Case> {
    let sleeve = |start, goal, portals: &[[Spot; 2]]| Sleeve { start, goal, portals: portals.to_vec() };
    let gate = [[2.0, 2.0], [2.0, -2.0]];
    let corner = [[2.0, 2.0], [5.0, 1.0]];
    let first = [
        ("alone", sleeve([0.0, 0.0], [3.0, 1.0], &[])),
        ("same", sleeve([1.0, 1.0], [1.0, 1.0], &[])),
        ("straight", sleeve([0.0, 0.0], [4.0, 0.0], &[gate])),
        ("left", sleeve([0.0, 0.0], [3.0, 4.0], &[gate, corner])),
        ("right", sleeve([0.0, 0.0], [3.0, -4.0], &[gate, [[5.0, -1.0], [2.0, -2.0]]])),
        ("two_moves", sleeve([0.0, 0.0], [2.0, -6.0], &[[[5.0, 3.0], [2.0, 0.0]], [[5.0, 3.0], [3.0, -2.0]]])),
        ("touches", sleeve([0.0, 0.0], [4.0, 4.0], &[gate, corner])),
        ("start_on_portal", sleeve([2.0, 1.0], [3.0, 5.0], &[gate, corner])),
        ("start_is_end", sleeve([2.0, 2.0], [3.0, 5.0], &[gate, corner])),
        ("start_is_other_end", sleeve([2.0, -2.0], [3.0, 5.0], &[gate, corner])),
        ("goal_on_portal", sleeve([0.0, 0.0], [3.5, 1.5], &[gate, corner])),
        ("goal_is_end", sleeve([0.0, 0.0], [2.0, 2.0], &[gate, corner])),
        ("round_and_back", sleeve([2.0, 2.0], [2.0, 2.0], &[gate, corner])),
        ("two_corners", winding(2)),
        ("six_corners", winding(6)),
        ("fan", fan(6)),
    ];
    let mut cases: Vec<Case> =
        first.into_iter().map(|(name, sleeve)| sleeve_case(format!("funnel.{name}"), [sleeve])).collect();
    cases.push(sleeve_case("funnel.nearly_straight".to_owned(), nearly_straight()));
    let mut random = Random::new(6, "rounding");
    for (name, unit) in [("rounding", 0.1), ("rounding.tiny", 1.1e-30), ("rounding.large", 0.7e15)] {
        let sleeves = (0..80).map(|i| random_sleeve(&mut random, 1 + i % 7, unit));
        cases.push(sleeve_case(format!("funnel.{name}"), sleeves.collect::<Vec<_>>()));
    }
    cases
}

fn paths(table: &Table, random: &mut Random, count: usize) -> Vec<String> {
    let all: Vec<[Spot; 3]> = triangles(table).filter_map(|f| corners(table, f)).collect();
    let any = |random: &mut Random| random.pick(&all).copied().map_or([0.0; 2], |corners| among(random, corners));
    (0..count)
        .map(|i| {
            let [start, goal] = [any(random), any(random)];
            let [goal, start] = match i % 9 {
                7 => [goal, [900.0, 900.0]],
                8 => [[-900.0, 900.0], start],
                6 => [start, start],
                _ => [goal, start],
            };
            format!("path {} {} {} {}", start[0], start[1], goal[0], goal[1])
        })
        .collect()
}

fn fixed_paths() -> Vec<Case> {
    let map = ["path -150 -120 235 60", "path 235 60 -150 -120", "path -150 -120 -80 60", "path 0 0 300 0"];
    let mut cases = vec![case("path.map".to_owned(), &picture::start(), map)];
    for (name, points, triangles) in small() {
        // One corridor only, and no point that is in triangles which do not hang together.
        if matches!(name, "one" | "two" | "fan") {
            let mut random = Random::new(6, name);
            let table = build(&points, &triangles);
            let lines = paths(&table, &mut random, 27);
            cases.push(case(format!("path.{name}"), &typed(&points, &triangles), lines));
        }
    }
    let parts = small().remove(5);
    let apart = ["path 1 1 8 1", "path 8 1 1 1", "path 8 1 8 0.5"];
    cases.push(case("path.parts".to_owned(), &typed(&parts.1, &parts.2), apart));
    cases
}

/// Some random meshes, half of them with other numbers; `ask` has what is asked of each.
fn random_cases(
    name: &str,
    random: &mut Random,
    trees: bool,
    ask: impl Fn(&Table, &mut Random) -> Vec<String>,
) -> Vec<Case> {
    let mut cases = Vec::new();
    for i in 0..MESHES {
        let table = if trees { Some(random_tree(random, 2 + i)) } else { random_mesh(random, 5 + 2 * i) };
        let Some(table) = table else { continue };
        let table = if i % 2 == 0 { table } else { relabelled(&table, random) };
        let lines = ask(&table, random);
        cases.push(case(format!("{name}.random_{i}"), &Start::table(table), lines));
    }
    cases
}

fn random_neighbours(name: &str, random: &mut Random) -> Vec<Case> {
    random_cases(name, random, false, |table, _| all_neighbours(table))
}

fn random_points(name: &str, random: &mut Random) -> Vec<Case> {
    let walks = name == "locate";
    random_cases(name, random, false, |table, random| {
        let from: Vec<u32> = triangles(table).collect();
        let mut line = |_| {
            let [x, y] = [random.below(27) as f64 / 2.0 - 0.5, random.below(23) as f64 / 2.0 - 0.5];
            let f = random.pick(&from).copied().unwrap_or_default();
            if walks { format!("{name} f{f} {x} {y}") } else { format!("{name} {x} {y}") }
        };
        (0..30).map(&mut line).collect()
    })
}

fn some(lines: &[String], random: &mut Random, count: usize) -> Vec<String> {
    random.order(lines.len()).into_iter().take(count).map(|i| lines[i].clone()).collect()
}

fn random_corridors(name: &str, random: &mut Random) -> Vec<Case> {
    random_cases(name, random, false, |table, random| some(&all_corridors(table, true), random, 40))
}

fn random_portals(name: &str, random: &mut Random) -> Vec<Case> {
    random_cases(name, random, false, |table, random| some(&all_portals(table), random, 40))
}

fn random_sleeves(name: &str, random: &mut Random) -> Vec<Case> {
    let mut sleeves: Vec<Sleeve> = (0..SLEEVES).map(|i| random_sleeve(random, 1 + i % 12, 1.0)).collect();
    // Those with few portals first.
    sleeves.sort_by_key(|sleeve| sleeve.portals.len());
    vec![sleeve_case(format!("{name}.random"), sleeves)]
}

fn random_paths(name: &str, random: &mut Random) -> Vec<Case> {
    random_cases(name, random, true, |table, random| paths(table, random, 18))
}

/// Large ones: numbers past 65,536, long corridors, and how many records are looked at.
fn large(test: &str) -> Vec<Case> {
    let big = || large_cells(130, 130);
    match test {
        "neighbours" => {
            let asked = [33_800, 33_799, 17_000, 17_001, 260, 261, 1, 2, 3, 33_541];
            vec![costs::with_reads(format!("{test}.large"), &big(), asked.map(|f| format!("neighbours f{f}")))]
        }
        "locate_by_scan" => vec![case(format!("{test}.large"), &big(), ["locate_by_scan 128.75 129.5"])],
        "locate" => {
            let asked = ["f1 129.75 128.5", "f33800 0.5 0.25", "f260 0.25 129.5", "f16900 64.5 65.5", "f2 130 130"];
            vec![costs::with_reads(format!("{test}.large"), &big(), asked.map(|words| format!("locate {words}")))]
        }
        "corridor" => vec![case(format!("{test}.large"), &big(), ["corridor f1 f33800", "corridor f33800 f520"])],
        "portals" => {
            let table = cells(300, 1);
            let line = corridor(&table, 1, 600).unwrap_or_default().iter().map(u32::to_string).collect::<Vec<_>>();
            let line = format!("portals {}", line.join(" "));
            vec![costs::with_reads(format!("{test}.large"), &large_cells(300, 1), [line])]
        }
        "funnel" => vec![
            sleeve_case(format!("{test}.fan_40"), [fan(40)]),
            sleeve_case(format!("{test}.winding_300"), [winding(300)]),
        ],
        "path" => {
            vec![case(format!("{test}.large"), &large_cells(400, 1), ["path 0 0 400 1", "path 399.5 0.25 0 0.75"])]
        }
        _ => Vec::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::super::funnel::shortest;
    use super::*;

    #[test]
    fn most_sleeves_have_corners_and_some_are_decided_by_rounding() {
        let naive = |a: Spot, b: Spot, c: Spot| (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        let mut random = Random::new(6, "rounding");
        let (mut corners, mut differ) = (0, 0);
        for i in 0..400 {
            let sleeve = random_sleeve(&mut random, 1 + i % 7, 0.1);
            corners += usize::from(shortest(&sleeve).len() > 2);
            let [first, last] = [sleeve.portals[0], sleeve.portals[sleeve.portals.len() - 1]];
            let [a, b, c] = [first[0], last[0], sleeve.goal];
            differ += usize::from(super::super::mesh::turn(a, b, c) != naive(a, b, c).total_cmp(&0.0));
        }
        assert!(corners > 100 && differ > 5, "{corners} {differ}");
    }
}
