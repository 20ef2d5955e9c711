//! The cases of lab 08, test by test.

use super::starts::{self, Given};
use super::{cells, centres, costs, duals, features, picture};
use crate::answers::{self, Function};
use crate::cases::random::Random;
use crate::cases::starts::{convex, grid, polygon, wheel};
use crate::fault::Fault;
use crate::judge::{Asked, Judge, Suite, ToldBy};
use crate::plan::Plan;
use crate::protocol::{Case, CaseAnswer, Start, Step};
use crate::{many, pictures};

/// How many random cases each test has.
const RANDOM: usize = 8;
/// For how many elements of a triangulation a function is asked.
const ELEMENTS: usize = 40;
const PICTURE: &str = "picture";
const LARGE: &str = "cell_large";

/// The functions of the lab, each with the test that it decides.
const FUNCTIONS: &[Function] = &[
    Function { word: "circle_centre", test: "circle_centre", wrong: centres::wrong },
    Function { word: "dual", test: "dual", wrong: duals::wrong },
    Function { word: "voronoi", test: "voronoi", wrong: duals::wrong_voronoi },
    Function { word: "ray", test: "ray", wrong: cells::wrong_ray },
    Function { word: "cell", test: "cell", wrong: cells::wrong_cell },
];

/// The same questions in the large triangulation.
const IN_LARGE: &[Function] = &[Function { word: "cell", test: LARGE, wrong: cells::wrong_cell }];

/// The judge of lab 08.
pub struct VoronoiDiagrams;

impl Judge for VoronoiDiagrams {
    fn suites(&self, plan: &Plan) -> Vec<Suite> {
        let suite = |function: &'static Function| {
            let random = |seed, count| random(function.word, seed, count);
            // Each suite decides the one test that has the function's name.
            Suite::of(
                std::slice::from_ref(&function.test),
                Asked::fixed_and_seeded(fixed(function.word), plan, RANDOM, random),
            )
        };
        let mut suites: Vec<Suite> = FUNCTIONS.iter().map(suite).collect();
        suites.push(Suite::of(&[LARGE], Asked::fixed([costs::questions()])));
        let drawn = Case::new(PICTURE, Start::line("sites")).step(Step::Dump).step(Step::Svg);
        suites.push(Suite::of(&[PICTURE], Asked::fixed([drawn])));
        suites
    }

    fn judge(&self, suite: &Suite, case: &Case, answer: &CaseAnswer) -> Vec<Fault> {
        match suite.name {
            LARGE => many::judge(IN_LARGE, LARGE, &costs::LARGE, case, answer),
            PICTURE => pictures::told_apart(PICTURE, case, answer, picture::plain),
            _ => answers::judge(FUNCTIONS, case, answer),
        }
    }

    fn told_by(&self, test: &str) -> ToldBy {
        if matches!(test, "dual" | "voronoi") { ToldBy::Answer } else { ToldBy::Words }
    }

    crate::features_of!(features);

    fn promise(&self, fault: &Fault) -> &'static str {
        fault.kind.unfinished().unwrap_or(match fault.test {
            "circle_centre" => "circle_centre is as far from all three points, and refuses points on one line",
            "dual" => "the dual has a vertex for each face, a face for each vertex, and crosses each half-edge",
            "voronoi" => "the vertices of the dual are the centres of the triangles",
            "ray" => "a ray begins at the centre of its triangle and runs away from the triangulation",
            "cell" | LARGE => "cell lists the centres of the triangles at a vertex, counter-clockwise",
            _ => "the picture shows the edges and rays of the diagram, and its sites",
        })
    }
}

/// Triangles, some of them far away, thin, tiny or none at all.
fn triples() -> Vec<[f64; 6]> {
    let mut all = vec![
        [0., 0., 4., 0., 0., 2.],
        [0., 0., 0., 2., 4., 0.],
        [1., 1., 5., 2., 2., 6.],
        [-3., 4., 2., -5., 7., 1.],
        [0., 0., 10., 0., 4., 2.],
        [0., 0., 1., 1., 2., 2.],
        [3., 1., 3., 1., 5., 2.],
        [2., 2., 2., 2., 2., 2.],
        [0., 0., 5., 0., 2., 0.],
        [0., 0., 0., 3., 0., 9.],
        [0.1, 0.1, 0.2, 0.2, 0.7, 0.7],
        [0.1, 0.1, 0.3, 0.3, 0.7, 0.7000000000000001],
        [0.1, 0.2, 0.9, 0.3, 0.4, 0.8],
        // Exactly, they turn by 1; the products of doubles are equal.
        [0., 0., 94_906_267., 94_906_266., 94_906_266., 94_906_265.],
        [1e-30, 0., 0., 2e-30, 3e-30, 3e-30],
        [1e15, 1e15, 1e15 + 4., 1e15, 1e15, 1e15 + 2.],
        [1e9, -1e9, 1e9 + 3., -1e9 + 1., 1e9 + 1., -1e9 + 4.],
        [1e6, 1e6, 1e6 + 1., 1e6, 1e6 + 0.25, 1e6 + 1.],
        [1e8, 1., 1e8 + 5., 3., 1e8 + 1., 7.],
    ];
    // One triangle, seen from each of its corners.
    for turned in [[5., 1., 2., 6., 1., 2.], [2., 6., 1., 2., 5., 1.], [1., 2., 2., 6., 5., 1.]] {
        all.push(turned);
    }
    all
}

fn centre_case(name: String, points: &[f64]) -> Case {
    Case::new(name, Start::line("sites")).step(Step::call("circle_centre", points))
}

fn fixed(function: &str) -> Vec<Case> {
    if function == "circle_centre" {
        let named = |(i, points): (usize, [f64; 6])| centre_case(format!("circle_centre.{i}"), &points);
        return triples().into_iter().enumerate().map(named).collect();
    }
    let mut all: Vec<Case> = starts::fixed().iter().map(|given| case(function, given)).collect();
    if function == "dual" {
        let triangle = [[0., 0.], [4., 0.], [3., 3.]];
        let others = [polygon(&triangle), polygon(&[[0., 0.]; 5]), wheel(40), convex(300), grid(3, 2), grid(20, 15)];
        for (i, start) in others.into_iter().enumerate() {
            all.push(Case::new(format!("dual.other.{i}"), start).step(Step::Dump).step(Step::of_line("dual")));
        }
    }
    all
}

fn random(function: &str, seed: u64, count: usize) -> Vec<Case> {
    let mut random = Random::new(seed, function);
    let mut one = |i: usize| {
        if function == "circle_centre" {
            let points: Vec<f64> = (0..6).map(|_| random.below(41) as f64 - 20.0).collect();
            return Some(centre_case(format!("circle_centre.random.{i}"), &points));
        }
        starts::random(&mut random, &format!("random.{i}"), 12).map(|given| case(function, &given))
    };
    (0..count).filter_map(&mut one).collect()
}

/// A function, asked for the elements of a triangulation: of a small one for all of them.
fn case(function: &str, given: &Given) -> Case {
    let case = Case::new(format!("{function}.{}", given.name), given.start.clone()).step(Step::Dump);
    let (letter, count) = match function {
        "ray" => ('h', given.half_edges),
        "cell" => ('v', given.sites),
        _ => return case.step(Step::of_line(function)),
    };
    let some = (0..count).step_by(count.div_ceil(ELEMENTS));
    some.fold(case, |case, i| case.step(Step::call(function, [format!("{letter}{i}")])))
}
