//! The cases of lab 01, test by test.

use super::functions::FUNCTIONS;
use super::points::{FAR, PLAIN, line, nearly_collinear, of_points, random_nearly, random_sum, random_whole, sums};
use super::{features, functions, map};
use crate::answers::{self, Function};
use crate::cases::random::Random;
use crate::fault::Fault;
use crate::judge::{Asked, Judge, Suite, ToldBy};
use crate::pictures;
use crate::plan::Plan;
use crate::protocol::{Case, CaseAnswer, RecordSchema, Schema, Start, Step};

/// The test of the picture.
const MAP: &str = "wrong_signs";
/// How many calls a random case makes, and how many random cases there are.
const CALLS: usize = 24;
const RANDOM: usize = 4;

/// The judge of lab 01.
pub struct Predicates;

/// There are no records.
static NOTHING: RecordSchema = RecordSchema { singles: &[], tables: &[] };

impl Judge for Predicates {
    fn schema(&self) -> Schema {
        Schema::Records(&NOTHING)
    }

    fn suites(&self, plan: &Plan) -> Vec<Suite> {
        let suite = |function: &'static Function| {
            let name = function.word;
            let asked = Asked::fixed_and_seeded(fixed(name), plan, RANDOM, |seed, _| random(name, seed));
            Suite::of(std::slice::from_ref(&function.test), asked)
        };
        let map = Case::new("wrong_signs.map", Start::none()).step(Step::Svg);
        FUNCTIONS.iter().map(suite).chain([Suite::of(&[MAP], Asked::fixed([map]))]).collect()
    }

    fn judge(&self, suite: &Suite, case: &Case, answer: &CaseAnswer) -> Vec<Fault> {
        if suite.name == MAP {
            return pictures::told_apart(MAP, case, answer, map::picture);
        }
        answers::judge(FUNCTIONS, case, answer)
    }

    fn told_by(&self, test: &str) -> ToldBy {
        if test == "wrong_signs" { ToldBy::Answer } else { ToldBy::Words }
    }

    crate::features_of!(features);

    fn promise(&self, fault: &Fault) -> &'static str {
        match fault.test {
            "parallelogram_area" | "triangle_area" => {
                "areas are right but for the last digits, also far from the origin"
            }
            "turn" => "turn is the sign of the formula of the handout in doubles",
            "in_triangle" => "in_triangle holds inside and on the boundary, either way round",
            "in_circle" => "in_circle is 1 inside, 0 on the circle and -1 outside, either way round",
            "sign_of_sum" => "sign_of_sum is the sign of the sum before any rounding",
            "filter" => "filter is never wrong, and gives up only near a line",
            MAP => "the map shows the cells where doubles are wrong",
            _ => "the sign is that of the points as they are, before any rounding",
        }
    }

    /// The failing sum with one or two numbers less; the failing call by itself.
    fn shorter(&self, case: &Case) -> Vec<Case> {
        let Some(Step::Call { function, arguments }) =
            case.steps.iter().rfind(|step| matches!(step, Step::Call { .. })).filter(|_| case.start.text().is_empty())
        else {
            return Vec::new();
        };
        let calls = case.steps.iter().filter(|step| matches!(step, Step::Call { .. })).count();
        if function != "sign_of_sum" || calls != 1 || arguments.len() > 40 {
            return Vec::new();
        }
        let without = |left_out: &[usize]| {
            let kept = arguments.iter().enumerate().filter(|(i, _)| !left_out.contains(i)).map(|(_, word)| word);
            Case::new(case.name.clone(), Start::none()).step(Step::call(function, kept))
        };
        let n = arguments.len();
        let pairs = (0..n).flat_map(|i| (i + 1..n).map(move |j| vec![i, j]));
        pairs.chain((0..n).map(|i| vec![i])).take(240).map(|left_out| without(&left_out)).collect()
    }
}

/// The cases of a function that are always the same.
fn fixed(word: &str) -> Vec<Case> {
    let points = |name: &str, all: &[[[f64; 2]; 3]]| case(word, name, all.iter().map(|three| of_points(word, three)));
    match word {
        "in_triangle" => in_triangle(),
        "in_circle" => in_circle(),
        "sign_of_sum" => {
            let short = case(word, "short", sums().iter().map(|numbers| line(word, numbers.iter().copied())));
            let mut random = Random::new(1, "long sums");
            let long = (0..6).map(|_| line(word, random_sum(&mut random, 100)));
            vec![short, case(word, "long", long)]
        }
        // Areas where doubles can be as good as the handout says; signs where they cannot.
        "parallelogram_area" | "triangle_area" => {
            let mut rounding = nearly_collinear();
            rounding.retain(|&three| functions::is_clear(three));
            vec![points("plain", &PLAIN), points("far", &FAR), points("rounding", &rounding)]
        }
        _ => vec![
            points("plain", &PLAIN),
            case(word, "grid", grid().map(|three| of_points(word, &three))),
            points("far", &FAR),
            points("rounding", &nearly_collinear()),
        ],
    }
}

/// Cases from a seed.
fn random(word: &str, seed: u64) -> Vec<Case> {
    let mut random = Random::new(seed, word);
    let mut call = |i: usize| match word {
        "in_triangle" => of_points(word, &with_triangle(&mut random)),
        "in_circle" => of_points(word, &with_circle(&mut random)),
        "sign_of_sum" => line(word, random_sum(&mut random, 1 + i % 4)),
        // Doubles are as good there as the handout says.
        "parallelogram_area" | "triangle_area" | "turn" => of_points(word, &random_whole::<3>(&mut random, 20)),
        _ if i.is_multiple_of(3) => of_points(word, &random_whole::<3>(&mut random, 20)),
        _ => of_points(word, &random_nearly(&mut random)),
    };
    (0..RANDOM).map(|k| case(word, &format!("random.{k}"), (0..CALLS).map(&mut call).collect::<Vec<_>>())).collect()
}

fn case(word: &str, name: &str, lines: impl IntoIterator<Item = String>) -> Case {
    let calls = lines.into_iter().map(|line| Step::of_line(&line));
    Case::new(format!("{word}.{name}"), Start::none()).calls(calls, &[])
}

/// Every place of a third point on a grid of 5 times 5, seen from two others.
fn grid() -> impl Iterator<Item = [[f64; 2]; 3]> {
    (0..25).map(|k| [[1.0, 2.0], [3.0, 1.0], [f64::from(k % 5), f64::from(k / 5)]])
}

/// A point that is not on the line of the three corners, and corners that are not on one line.
fn with_triangle(random: &mut Random) -> [[f64; 2]; 4] {
    loop {
        let points: [[f64; 2]; 4] = random_whole(random, 6);
        if functions::orientation(points[1], points[2], points[3]) != 0 {
            return points;
        }
    }
}

/// Three points that are not on one line, and a fourth; often on the circle, which goes through twelve whole points.
fn with_circle(random: &mut Random) -> [[f64; 2]; 4] {
    loop {
        let centre = random_whole::<1>(random, 40)[0];
        let on = |random: &mut Random| {
            let [x, y] = CIRCLE[random.below(CIRCLE.len())];
            [centre[0] + x, centre[1] + y]
        };
        let [a, b, c] = [on(random), on(random), on(random)];
        let d = if random.below(2) == 0 { on(random) } else { random_whole::<1>(random, 40)[0] };
        if functions::orientation(a, b, c) != 0 {
            return [a, b, c, d];
        }
    }
}

/// Whole points at distance 5 from the origin.
const CIRCLE: [[f64; 2]; 12] = [
    [5.0, 0.0],
    [4.0, 3.0],
    [3.0, 4.0],
    [0.0, 5.0],
    [-3.0, 4.0],
    [-4.0, 3.0],
    [-5.0, 0.0],
    [-4.0, -3.0],
    [-3.0, -4.0],
    [0.0, -5.0],
    [3.0, -4.0],
    [4.0, -3.0],
];

/// Every point of a grid, asked of a few triangles; the first calls are the ones to read.
fn in_triangle() -> Vec<Case> {
    let word = "in_triangle";
    let triangle = [[0.0, 0.0], [4.0, 0.0], [0.0, 4.0]];
    let first = [[1.0, 1.0], [3.0, 3.0], [2.0, 2.0], [2.0, 0.0], [0.0, 2.0], [0.0, 0.0], [6.0, 0.0], [-1.0, 5.0]];
    let [a, b, c] = triangle;
    let asked = |p: [f64; 2], [a, b, c]: [[f64; 2]; 3]| of_points(word, &[p, a, b, c]);
    let mut cases = vec![
        case(word, "first", first.map(|p| asked(p, [a, b, c]))),
        case(word, "clockwise", first.map(|p| asked(p, [a, c, b]))),
    ];
    let triangles = [
        [[1.0, 0.0], [6.0, 2.0], [2.0, 5.0]],
        [[1.0, 0.0], [2.0, 5.0], [6.0, 2.0]],
        [[0.0, 3.0], [0.0, 0.0], [6.0, 3.0]],
        [[5.0, 5.0], [1.0, 1.0], [6.0, 1.0]],
    ];
    for (i, triangle) in triangles.into_iter().enumerate() {
        let points = (0..64).map(|k| [f64::from(k % 8 - 1), f64::from(k / 8 - 1)]);
        cases.push(case(word, &format!("grid.{i}"), points.map(|p| asked(p, triangle))));
    }
    cases
}

fn in_circle() -> Vec<Case> {
    let word = "in_circle";
    let [a, b, c] = [[5.0, 0.0], [0.0, 5.0], [-5.0, 0.0]];
    let first = [[0.0, 0.0], [1.0, 4.0], [6.0, 0.0], [0.0, -5.0], [3.0, -4.0], [-5.0, -1.0]];
    let asked = |d: [f64; 2], [a, b, c]: [[f64; 2]; 3]| of_points(word, &[a, b, c, d]);
    let mut cases = vec![
        case(word, "first", first.map(|d| asked(d, [a, b, c]))),
        case(word, "clockwise", first.map(|d| asked(d, [c, b, a]))),
    ];
    let threes = [
        [[2.0, 3.0], [5.0, 2.0], [4.0, 5.0]],
        [[4.0, 5.0], [5.0, 2.0], [2.0, 3.0]],
        [[0.0, 0.0], [6.0, 0.0], [0.0, 2.0]],
    ];
    for (i, three) in threes.into_iter().enumerate() {
        let points = (0..100).map(|k| [f64::from(k % 10 - 1), f64::from(k / 10 - 2)]);
        cases.push(case(word, &format!("grid.{i}"), points.map(|d| asked(d, three))));
    }
    let far = |[x, y]: [f64; 2]| [x + 700.0, y - 900.0];
    let far_calls = CIRCLE.map(|d| asked(far(d), [a, b, c].map(far))).into_iter();
    let off = first.map(|d| asked(far(d), [b, a, c].map(far)));
    cases.push(case(word, "far", far_calls.chain(off)));
    cases
}
