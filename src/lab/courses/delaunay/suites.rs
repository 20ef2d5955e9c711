//! The cases of lab 07, test by test.

use super::meshes::{self, Mesh, odd, renumbered};
use super::{angles, costs, delaunify, edges, features, flip, picture};
use crate::answers::{self, Function};
use crate::cases::random::Random;
use crate::cases::starts::wheel;
use crate::checks::walks::{blind, half_edges};
use crate::fault::{Exchange, Fault, exchanges};
use crate::judge::{Asked, Judge, Suite};
use crate::pictures;
use crate::plan::Plan;
use crate::protocol::{Case, CaseAnswer, Start, Step};
use dcel_kit::topology::Table;

/// How many random cases each test has.
const RANDOM: usize = 8;
/// How many vertices these have at most, beside four.
const MOST: usize = 12;
/// For how many half-edges of a triangulation a question is asked, and how many of them are flipped.
const QUESTIONS: usize = 40;
const FLIPS: usize = 12;
const PICTURE: &str = "picture";

/// The functions of the lab that answer, each with the test that it decides.
const FUNCTIONS: &[Function] = &[
    Function { word: "is_legal", test: "is_legal", wrong: edges::wrong_legal },
    Function { word: "can_flip", test: "can_flip", wrong: edges::wrong_can_flip },
    Function { word: "delaunify", test: "delaunify", wrong: delaunify::wrong },
    Function { word: "smallest_angle", test: "smallest_angle", wrong: angles::wrong },
];
/// The same flips in large triangulations.
const LARGE: &[Function] = &[Function { word: "delaunify", test: costs::LARGE, wrong: delaunify::wrong }];

/// The judge of lab 07.
pub struct Delaunay;

impl Judge for Delaunay {
    fn suites(&self, plan: &Plan) -> Vec<Suite> {
        let suite = |name, tests, case: CaseOf, more: Vec<Case>| {
            let fixed = fixed(name, case).into_iter().chain(more);
            let random = |seed, count| random(name, case, seed, count);
            Suite { name, tests, asked: Asked::fixed_and_seeded(fixed, plan, RANDOM, random) }
        };
        let drawn = Case::new(PICTURE, Start::line("sites")).step(Step::of_line("delaunify")).step(Step::Svg);
        vec![
            suite("is_legal", &["is_legal"], asks, vec![asks_wheel("is_legal"), costs::questions()]),
            suite("can_flip", &["can_flip"], asks, vec![asks_wheel("can_flip")]),
            suite("flip", &flip::TESTS[1..], flips, vec![costs::flips()]),
            suite("delaunify", &["delaunify"], whole, Vec::new()),
            Suite::of(&[costs::LARGE], Asked::fixed(costs::delaunify())),
            suite("smallest_angle", &["smallest_angle"], whole, Vec::new()),
            Suite::of(&[PICTURE], Asked::fixed([drawn])),
        ]
    }

    fn judge(&self, suite: &Suite, case: &Case, answer: &CaseAnswer) -> Vec<Fault> {
        let test = suite.tests[0];
        match suite.name {
            PICTURE => pictures::told_apart(PICTURE, case, answer, picture::plain),
            costs::LARGE => {
                let mut faults = costs::judge(test, case, answer);
                if faults.is_empty() {
                    faults = answers::judge(LARGE, case, answer);
                }
                faults
            }
            name => {
                let mut faults: Vec<Fault> = match name {
                    "flip" => exchanges(case, answer).iter().flat_map(flip::judge).collect(),
                    _ => answers::judge(FUNCTIONS, case, answer),
                };
                faults.extend(costs::judge(test, case, answer));
                faults
            }
        }
    }

    crate::features_of!(features);

    fn promise(&self, fault: &Fault) -> &'static str {
        fault.kind.unfinished().unwrap_or(match fault.test {
            "is_legal" => "is_legal says whether a corner lies inside of the circle across an edge",
            "can_flip" => "can_flip refuses edges of the border and of quadrilaterals that are not convex",
            "flip_1_origins" => "flip sets the origins of both halves, and what the vertices refer to",
            "flip_2_links" => "flip sets next and prev in both triangles",
            "flip_3_faces" => "flip sets the faces, and what they refer to",
            "delaunify" => "delaunify flips edges that are not legal until all are, and tells which",
            costs::LARGE => "delaunify looks again at the edges round a flip, and at no others",
            "smallest_angle" => "smallest_angle is the smallest angle of all triangles",
            _ => "the picture shows the edges, the circles and the sites",
        })
    }

    fn expected(&self, exchange: &Exchange) -> Option<Table> {
        if exchange.function == "flip" { flip::expected(exchange) } else { None }
    }

    /// The same of two triangles only: each two of the case that have an edge in common.
    fn shorter(&self, case: &Case) -> Vec<Case> {
        let Some(call) = case.steps.iter().find(|step| matches!(step, Step::Call { .. })) else { return Vec::new() };
        let Step::Call { function, .. } = call else { return Vec::new() };
        let Some((points, corners)) = stated(&case.start).filter(|(_, corners)| corners.len() > 2) else {
            return Vec::new();
        };
        let mut all = Vec::new();
        for (i, one) in corners.iter().enumerate() {
            for other in &corners[i + 1..] {
                let shared = (0..3).find(|&k| other.contains(&one[k]) && other.contains(&one[(k + 1) % 3]));
                let (Some(k), Some(&d)) = (shared, other.iter().find(|v| !one.contains(v))) else { continue };
                let [a, b, c] = [0, 1, 2].map(|j| one[(k + j) % 3]);
                let places = [a, b, c, d].map(|v| points[v as usize]);
                let start = crate::cases::starts::triangles(&places, &[[0, 1, 2], [1, 0, 3]]);
                let of = |step: Step| Case::new(case.name.clone(), start.clone()).step(Step::Dump).step(step);
                match function.as_str() {
                    "delaunify" => all.push(of(call.clone()).step(Step::Dump)),
                    "smallest_angle" => all.push(of(call.clone())),
                    _ => all.extend(["h0", "h1"].map(|h| of(Step::call(function, [h])))),
                }
            }
        }
        all
    }
}

/// The case of a triangulation; the generator decides whether it is told by a line or by its records.
type CaseOf = fn(&str, &Mesh, &mut Random) -> Case;

fn fixed(name: &str, case: CaseOf) -> Vec<Case> {
    let mut order = Random::new(7, name);
    let mut all: Vec<Case> = meshes::fixed().iter().map(|mesh| case(name, mesh, &mut order)).collect();
    if name == "flip" {
        // Flips that no plane allows.
        for mesh in meshes::fixed().iter().filter(|mesh| (3..30).contains(&mesh.triangles.len())) {
            let table = odd(mesh, &mut order);
            all.push(flips_of(format!("flip.odd.{}", mesh.name), Start::table(table.clone()), &table));
        }
    }
    all
}

fn random(name: &str, case: CaseOf, seed: u64, count: usize) -> Vec<Case> {
    let mut numbers = Random::new(seed, name);
    let mut all = Vec::new();
    while all.len() < count {
        if let Some(mesh) = meshes::random(&mut numbers, &format!("random.{}", all.len()), MOST) {
            all.push(case(name, &mesh, &mut numbers));
        }
    }
    all
}

/// Half of the triangulations are told by points and corners, the others by records whose numbers mean nothing.
fn start(mesh: &Mesh, order: &mut Random) -> Start {
    if order.below(2) == 0 { mesh.start() } else { Start::table(renumbered(&mesh.table(), order)) }
}

/// Questions about half-edges: in a small triangulation about all of them.
fn asks(function: &str, mesh: &Mesh, order: &mut Random) -> Case {
    let start = start(mesh, order);
    let count = mesh.table().half_edges.len();
    ask(Case::new(format!("{function}.{}", mesh.name), start), function, count)
}

fn ask(case: Case, function: &str, count: usize) -> Case {
    let some = (0..count).step_by(count.div_ceil(QUESTIONS));
    some.fold(case.step(Step::Dump), |case, h| case.step(Step::call(function, [format!("h{h}")])))
}

fn asks_wheel(function: &str) -> Case {
    ask(Case::new(format!("{function}.wheel"), wheel(40)), function, 160)
}

/// Flips of inner edges, each of the same structure. Half of the structures have all vertices at one place.
fn flips(_: &str, mesh: &Mesh, order: &mut Random) -> Case {
    let mut table = renumbered(&mesh.table(), order);
    if order.below(2) == 0 {
        table = blind(&table);
    }
    flips_of(format!("flip.{}", mesh.name), Start::table(table.clone()), &table)
}

fn flips_of(name: String, start: Start, table: &Table) -> Case {
    let inner: Vec<_> = half_edges(table).filter(|&h| flip::is_plain(table, h)).collect();
    let mut case = Case::new(name, start).step(Step::Dump);
    for h in inner.iter().step_by(inner.len().div_ceil(FLIPS).max(1)) {
        case = case.step(Step::Save).step(Step::call("flip", [h])).step(Step::Dump).step(Step::Restore);
    }
    case
}

/// One call for the whole triangulation.
fn whole(function: &str, mesh: &Mesh, order: &mut Random) -> Case {
    let start = start(mesh, order);
    let case = Case::new(format!("{function}.{}", mesh.name), start).step(Step::Dump).step(Step::of_line(function));
    if function == "delaunify" { case.step(Step::Dump) } else { case }
}

/// Points, and the corners of triangles.
type Stated = (Vec<[f64; 2]>, Vec<[u32; 3]>);

/// The points and triangles of a start of that word.
fn stated(start: &Start) -> Option<Stated> {
    let (points, corners) = start.text().strip_prefix("triangles ")?.split_once(" / ")?;
    let numbers: Vec<f64> = points.split(' ').map(|word| word.parse().ok()).collect::<Option<_>>()?;
    let corners: Vec<u32> = corners.split(' ').map(|word| word.parse().ok()).collect::<Option<_>>()?;
    Some((
        numbers.chunks_exact(2).map(|pair| [pair[0], pair[1]]).collect(),
        corners.chunks_exact(3).map(|three| [three[0], three[1], three[2]]).collect(),
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shorter_cases_have_two_triangles_of_the_given_one() {
        let all = meshes::fixed();
        let sites = all.iter().find(|mesh| mesh.name == "sites").unwrap();
        let case = Case::new("x", sites.start()).step(Step::Dump).step(Step::call("is_legal", ["h9"]));
        let shorter = Delaunay.shorter(&case);
        // 25 edges, 8 of them on the border; each inner one is asked by both halves.
        assert_eq!(shorter.len(), 2 * (25 - 8));
        assert!(
            shorter
                .iter()
                .all(|case| stated(&case.start).is_some_and(|(points, two)| (points.len(), two.len()) == (4, 2)))
        );
    }
}
