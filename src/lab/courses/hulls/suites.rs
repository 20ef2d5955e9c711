//! The cases of lab 03, test by test: small ones that a student can type, all choices of nine points, random ones.

use super::polygons::SCHEMA;
use super::starts::{
    bowl, degenerate, of_a_small_grid, pairs, plain, points, polygons, random, random_pair, random_polygon, stated,
    stated_polygons, with_a_point, with_an_odd_point,
};
use super::{features, hull, merge, picture, tangents};
use crate::answers::{self, Function};
use crate::cases::random::Random;
use crate::fault::Fault;
use crate::judge::{Asked, Judge, Suite};
use crate::pictures;
use crate::plan::{Plan, Secret};
use crate::protocol::{Case, CaseAnswer, Schema, Start, Step};
use dcel_kit::plane::Point;

/// How many random cases there are of each test.
const RANDOM: usize = 24;
/// How many points the scan is asked for, to see how its time grows.
const MANY: usize = 300_000;
/// The function that has a hull made of two, and its test.
const HALVES: &str = "hull_by_halves";

/// The judge of lab 03.
pub struct Hulls;

impl Judge for Hulls {
    fn schema(&self) -> Schema {
        Schema::Records(&SCHEMA)
    }

    fn suites(&self, plan: &Plan) -> Vec<Suite> {
        let mut suites = Vec::new();
        for (tests, function) in [
            ([&["gift_wrapping"], &["gift_wrapping_odd"]], "gift_wrapping"),
            ([&["graham_scan"], &["graham_scan_odd"]], "graham_scan"),
        ] {
            for (i, tests) in tests.into_iter().enumerate() {
                let is_odd = i == 1;
                let fixed = hull_cases(tests[0], function, is_odd);
                let made = |random: &mut Random, n| {
                    let size = if is_odd { 1 + random.below(6) } else { 1_000_000 };
                    let count = 3 + random.below(3 * n);
                    points_case(tests[0], function, &self::random(random, count, size))
                };
                suites.push(Suite::of(tests, asked(tests[0], fixed, made, plan)));
            }
        }
        let large = Case::new("graham_scan_large.bowl", bowl(MANY)).step(Step::Changes);
        suites.push(Suite::of(&["graham_scan_large"], Asked::fixed([large.step(Step::of_line("graham_scan"))])));
        suites.push(tangent_suite(&["tangents"], &with_a_point(), false, plan));
        suites.push(tangent_suite(&["tangents_odd"], &with_an_odd_point(), true, plan));
        suites.push(pair_suite(&["common_tangents"], plan));
        suites.push(pair_suite(&["merge"], plan));
        suites.push(Suite::of(&[HALVES], Asked::fixed(halves_cases())));
        let drawn = Case::new("picture", Start::line("handout")).step(Step::Dump).step(Step::Svg);
        suites.push(Suite::of(&["picture"], Asked::fixed([drawn])));
        suites
    }

    fn judge(&self, suite: &Suite, case: &Case, answer: &CaseAnswer) -> Vec<Fault> {
        let test = suite.tests[0];
        if test == "picture" {
            return pictures::judge_case(test, case, answer, picture::plain);
        }
        let functions = [
            Function { word: "gift_wrapping", test, wrong: hull::wrong },
            Function { word: "graham_scan", test, wrong: hull::wrong },
            Function { word: HALVES, test, wrong: hull::wrong },
            Function { word: "tangents", test, wrong: tangents::wrong },
            Function { word: "common_tangents", test, wrong: tangents::wrong_common },
            Function { word: "merge", test, wrong: merge::wrong },
        ];
        answers::judge(&functions, case, answer)
    }

    crate::features_of!(features);

    fn promise(&self, fault: &Fault) -> &'static str {
        fault.kind.unfinished().unwrap_or(match fault.rule.as_str() {
            "tangents" => "tangents finds the two corners, or refuses a point that is not outside",
            "common_tangents" => "common_tangents finds the outermost corners on both tangents",
            "merge" => "merge leaves one convex polygon, linked both ways",
            _ => "the polygon has the corners of the hull, counter-clockwise, and no other points",
        })
    }

    fn shorter(&self, case: &Case) -> Vec<Case> {
        let Some(points) = stated(&case.start) else { return with_fewer_corners(case) };
        let without = |left_out: usize| {
            let mut kept = points.clone();
            kept.remove(left_out);
            Case { start: self::points(&kept), ..case.clone() }
        };
        let half = points.len() / 2;
        let halves = [&points[..half], &points[half..]].map(|part| Case { start: self::points(part), ..case.clone() });
        let halves = halves.into_iter().filter(|_| points.len() > 3);
        halves.chain((0..points.len().min(40)).map(without)).collect()
    }
}

/// The same calls for polygons with fewer corners: with one half of a polygon, or without one corner of it. Corners that
/// are gone are named by the next one that is left.
fn with_fewer_corners(case: &Case) -> Vec<Case> {
    let Some(all) = stated_polygons(&case.start) else { return Vec::new() };
    let mut shorter = Vec::new();
    let mut first = 0;
    for (i, corners) in all.iter().enumerate() {
        let count = corners.len();
        let half = if count > 3 { vec![0..count / 2, count / 2..count] } else { Vec::new() };
        let halves = half.into_iter().map(Iterator::collect::<Vec<usize>>);
        let without = |gone: usize| (0..count).filter(|&k| k != gone).collect::<Vec<usize>>();
        let one = (0..count.min(40)).filter(|_| count > 1).map(without);
        for kept in halves.chain(one) {
            let mut polygons = all.clone();
            polygons[i] = kept.iter().map(|&k| corners[k]).collect();
            let left = |c: usize| match c.checked_sub(first) {
                None => c,
                Some(k) if k >= count => c + kept.len() - count,
                Some(k) => first + kept.iter().position(|&other| other >= k).unwrap_or(kept.len() - 1),
            };
            let named = |word: &String| {
                let number = word.strip_prefix('c').and_then(|number| number.parse().ok());
                number.map_or_else(|| word.clone(), |number| format!("c{}", left(number)))
            };
            let steps = case.steps.iter().map(|step| match step {
                Step::Call { function, arguments } => {
                    Step::Call { function: function.clone(), arguments: arguments.iter().map(named).collect() }
                }
                other => other.clone(),
            });
            let (start, steps) = (self::polygons(&polygons), steps.collect());
            shorter.push(Case { start, steps, ..case.clone() });
        }
        first += count;
    }
    shorter
}

/// Fixed cases, then random ones from the seed of the report, then those of the instructor.
fn asked(name: &str, fixed: Vec<Case>, mut made: impl FnMut(&mut Random, usize) -> Case, plan: &Plan) -> Vec<Asked> {
    let mut cases = |seed: u64, stream: &str, count: usize, size: usize| -> Vec<Case> {
        let mut random = Random::new(seed, &format!("{name}.{stream}"));
        let numbered = (0..count).map(|i| {
            let case = made(&mut random, size);
            Case { name: format!("{name}.{stream}.{i}"), ..case }
        });
        numbered.collect()
    };
    let random = cases(plan.seed, "random", RANDOM, 10);
    let mut all = Asked::fixed(fixed);
    all.extend(Asked::random(random));
    if let Some(secret @ Secret { seed, .. }) = &plan.secret {
        all.extend(Asked::hidden(cases(*seed, "hidden", secret.sequences, secret.calls)));
    }
    all
}

fn points_case(name: &str, function: &str, points: &[Point]) -> Case {
    Case::new(name, self::points(points)).step(Step::Dump).step(Step::of_line(function))
}

fn hull_cases(test: &str, function: &str, is_odd: bool) -> Vec<Case> {
    let named = |(name, points): (&str, Vec<Point>)| points_case(&format!("{test}.{name}"), function, &points);
    if !is_odd {
        return plain().into_iter().map(named).collect();
    }
    let of_a_grid = of_a_small_grid().into_iter().enumerate();
    let of_a_grid = of_a_grid.map(|(i, points)| points_case(&format!("{test}.grid.{i}"), function, &points));
    degenerate().into_iter().map(named).chain(of_a_grid).collect()
}

fn halves_cases() -> Vec<Case> {
    let all = plain().into_iter().chain(degenerate());
    // What `merge` does wrong shows in the random cases of its own test; these look random, and are always the same.
    let mut from = Random::new(3, "halves");
    let more = (0..RANDOM).map(|i| ("mixed", random(&mut from, 4 + 3 * i, 2 + i)));
    let named = all.chain(more).enumerate();
    named.map(|(i, (name, points))| points_case(&format!("{HALVES}.{i}.{name}"), HALVES, &points)).collect()
}

/// A polygon, and tangents from a point, asked from each of its corners if there are few.
fn tangent_case(name: &str, corners: &[Point], p: Point) -> Case {
    let case = Case::new(name, polygons(&[corners.to_vec()])).step(Step::Dump);
    let call = |c: usize| Step::call("tangents", [format!("c{c}"), p.x.to_string(), p.y.to_string()]);
    let step = corners.len().div_ceil(6);
    (0..corners.len()).step_by(step).fold(case, |case, c| case.step(call(c)))
}

fn tangent_suite(
    tests: &'static [&'static str],
    all: &[(&str, Vec<Point>, Point)],
    is_odd: bool,
    plan: &Plan,
) -> Suite {
    let name = tests[0];
    let fixed = all.iter().map(|(of, corners, p)| tangent_case(&format!("{name}.{of}"), corners, *p)).collect();
    let made = |random: &mut Random, n: usize| {
        let size = if is_odd { 1 + random.below(4) } else { 1000 };
        let count = 3 + random.below(3 * n);
        let corners = random_polygon(random, count, size);
        let reach = 2 * size;
        let mut number = || random.below(2 * reach + 1) as f64 - reach as f64;
        // A plain point is outside, and on no line of a side.
        let mut p = Point::new(number(), number());
        while !is_odd && p.x.abs() <= size as f64 && p.y.abs() <= size as f64 {
            p = Point::new(number(), number());
        }
        tangent_case(name, &corners, p)
    };
    Suite::of(tests, asked(name, fixed, made, plan))
}

/// Two polygons, named by each of a few of their corners.
fn pair_case(name: &str, function: &str, pair: &[Vec<Point>]) -> Case {
    let case = Case::new(name, polygons(pair)).step(Step::Dump);
    let (n, m) = (pair[0].len(), pair[1].len());
    let some = |count: usize| (0..count).step_by(count.div_ceil(3));
    let calls = some(n).flat_map(|a| some(m).map(move |b| (a, n + b)));
    let calls = calls.map(|(a, b)| Step::call(function, [format!("c{a}"), format!("c{b}")]));
    if function == "merge" { case.each_alone(calls) } else { case.calls(calls, &[]) }
}

fn pair_suite(tests: &'static [&'static str], plan: &Plan) -> Suite {
    let name = tests[0];
    let fixed = pairs().iter().map(|(of, pair)| pair_case(&format!("{name}.{of}"), name, pair)).collect();
    let made = |random: &mut Random, n: usize| {
        let (count, size) = (2 + random.below(3 * n), 1 + random.below(12));
        pair_case(name, name, &random_pair(random, count, size))
    };
    Suite::of(tests, asked(name, fixed, made, plan))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_failing_case_is_made_shorter_by_leaving_points_out() {
        let case = points_case("x", "graham_scan", &[[0., 0.], [1., 2.], [3., 0.]].map(Point::from));
        let shorter: Vec<String> = Hulls.shorter(&case).iter().map(|case| case.start.text().to_owned()).collect();
        assert_eq!(shorter, ["points 1 2 3 0", "points 0 0 3 0", "points 0 0 1 2"]);
    }

    #[test]
    fn polygons_lose_corners_and_the_calls_are_about_what_is_left() {
        let at = |points: &[[f64; 2]]| points.iter().copied().map(Point::from).collect::<Vec<_>>();
        let pair = [at(&[[0., 0.], [2., 0.], [1., 2.]]), at(&[[5., 0.], [6., 1.]])];
        let case = Case::new("x", polygons(&pair)).step(Step::of_line("common_tangents c2 c3"));
        let told = |case: &Case| {
            let Some(Step::Call { arguments, .. }) = case.steps.first() else { return String::new() };
            format!("{}: {}", case.start.text(), arguments.join(" "))
        };
        let shorter: Vec<String> = Hulls.shorter(&case).iter().map(told).collect();
        assert_eq!(
            shorter,
            [
                "polygons 2 0 1 2 / 5 0 6 1: c1 c2",
                "polygons 0 0 1 2 / 5 0 6 1: c1 c2",
                "polygons 0 0 2 0 / 5 0 6 1: c1 c2",
                "polygons 0 0 2 0 1 2 / 6 1: c2 c3",
                "polygons 0 0 2 0 1 2 / 5 0: c2 c3",
            ]
        );
    }
}
