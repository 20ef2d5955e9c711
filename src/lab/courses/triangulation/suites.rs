//! The cases of lab 02, test by test.

use super::geometry::{Diagonal, diagonal, ear};
use super::lists::{SCHEMA, convex, cycle, of_places, places, start};
use super::polygons::{DRAWING, comb, random_star, rounding, small, spiral};
use super::splits::refusal;
use super::{drawing, features, soups, splits};
use crate::answers::{self, Function, Wrong};
use crate::cases::random::Random;
use crate::fault::{Exchange, Fault, FaultKind, answered, exchanges};
use crate::judge::{Asked, Judge, Suite, ToldBy};
use crate::many::too_many_reads;
use crate::pictures;
use crate::plan::Plan;
use crate::protocol::{Case, CaseAnswer, Reply, Schema, Start, Step, Structure, Value};
use std::sync::Arc;

/// The test of the picture.
const PICTURE: &str = "triangulation_svg";
/// The functions that only read.
const READING: &[Function] = &[
    Function { word: "corners_of", test: "corners_of", wrong: corners },
    Function { word: "is_diagonal", test: "is_diagonal", wrong: diagonals },
    Function { word: "is_ear", test: "is_ear", wrong: ears },
];
/// What the names of sequences of splits begin with.
const SEQUENCE: &str = "split.sequence.";
/// How many records a split may look at. The solution needs 20.
const READS_OF_A_SPLIT: u64 = 500;
/// How many random polygons each test has, and how many corners these have at least and at most.
const RANDOM: usize = 10;
const SIZES: [usize; 2] = [5, 12];
/// How many splits a random sequence has.
const SPLITS: usize = 6;

/// The judge of lab 02.
pub struct Triangulation;

impl Judge for Triangulation {
    fn schema(&self) -> Schema {
        Schema::Records(&SCHEMA)
    }

    fn suites(&self, plan: &Plan) -> Vec<Suite> {
        let suite = |name: &'static str, tests: &'static [&'static str], fixed: Vec<Case>| Suite {
            name,
            tests,
            asked: Asked::fixed_and_seeded(fixed, plan, RANDOM, |seed, _| random(name, seed)),
        };
        let picture =
            Case::new("triangulation", start(&DRAWING)).step(Step::call("triangulate", ["c0"])).step(Step::Svg);
        vec![
            suite("corners_of", &["corners_of"], corner_cases()),
            suite("split", &splits::TESTS, split_cases().into_iter().chain(sequence_cases()).collect()),
            suite("is_diagonal", &["is_diagonal"], reading_cases("is_diagonal")),
            suite("is_ear", &["is_ear"], reading_cases("is_ear")),
            suite("triangulate", &["triangulate"], soup_cases()),
            Suite::of(&[PICTURE], Asked::fixed([picture])),
        ]
    }

    fn judge(&self, suite: &Suite, case: &Case, answer: &CaseAnswer) -> Vec<Fault> {
        match suite.name {
            "split" if case.name.starts_with(SEQUENCE) => sequence(case, answer),
            "split" => {
                let mut faults: Vec<Fault> = exchanges(case, answer)
                    .iter()
                    .flat_map(|exchange| splits::judge(exchange, splits::TESTS))
                    .collect();
                faults.extend(costs(case, answer));
                faults
            }
            "triangulate" => exchanges(case, answer).iter().filter_map(soups::judge).collect(),
            PICTURE => pictures::told_apart(PICTURE, case, answer, drawing::picture),
            _ => answers::judge(READING, case, answer),
        }
    }

    fn concerns(&self, suite: &Suite, step: &Step, exchange: Option<&Exchange>) -> Vec<&'static str> {
        let refused = || {
            let (before, (arguments, _)) = exchange?.records_before().zip(exchange?.called)?;
            let &[u, v] = arguments else { return None };
            refusal(before, u, v)
        };
        match suite.name {
            "split" => vec![splits::TESTS[usize::from(refused().is_none())]],
            PICTURE if *step != Step::Svg => Vec::new(),
            _ => suite.tests.to_vec(),
        }
    }

    fn blames(&self, fault: &Fault) -> Option<&'static str> {
        match fault.rule.as_str() {
            "split.refusal" => Some(splits::TESTS[0]),
            "split.cut" => Some(splits::TESTS[1]),
            _ => None,
        }
    }

    fn told_by(&self, test: &str) -> ToldBy {
        if test == "triangulate" { ToldBy::Answer } else { ToldBy::Words }
    }

    crate::features_of!(features);

    fn promise(&self, fault: &Fault) -> &'static str {
        match fault.test {
            "corners_of" => "corners_of lists each corner once, counter-clockwise, from the one that is given",
            "split_refuses" => "split refuses neighbours and a corner with itself, without changing anything",
            "split" => "after split, both polygons are closed lists, and the copy of u is returned",
            "is_diagonal" => "is_diagonal holds for lines that lie inside and touch the boundary at their ends only",
            "is_ear" => "is_ear holds where the line between the neighbours is a diagonal",
            "triangulate" => "triangulate leaves triangles that cover the polygon once, and returns one corner of each",
            _ => "the picture shows all triangles, their sides and their corners",
        }
    }

    /// A failing triangulation with a smaller polygon of the fixed ones; a sequence with fewer splits.
    fn shorter(&self, case: &Case) -> Vec<Case> {
        let calls: Vec<&Step> = case.steps.iter().filter(|step| matches!(step, Step::Call { .. })).collect();
        let Some(&Step::Call { function, .. }) = calls.last() else { return Vec::new() };
        match (function.as_str(), calls.len()) {
            ("triangulate", 1) => {
                let long = case.start.structure().map_or(0, Structure::len);
                let smaller = small().into_iter().filter(|(_, polygon)| polygon.len() < long);
                smaller
                    .map(|(_, polygon)| Case {
                        start: start(&polygon),
                        steps: vec![Step::Dump, Step::call("triangulate", ["c0"]), Step::Dump],
                        ..case.clone()
                    })
                    .collect()
            }
            ("split", 2..) => {
                let kept = (0..calls.len() - 1).rev().map(|left_out| {
                    let mut kept: Vec<Step> = vec![Step::Dump];
                    let others =
                        calls.iter().enumerate().filter(|(i, _)| *i != left_out).map(|(_, call)| (*call).clone());
                    kept.extend(others.flat_map(|call| [call, Step::Dump]));
                    Case { steps: kept, ..case.clone() }
                });
                kept.collect()
            }
            _ => Vec::new(),
        }
    }
}

/// The corners of a polygon after a given one, and their places.
fn polygon_of(exchange: &Exchange) -> Option<(Vec<u32>, Vec<[f64; 2]>)> {
    let (records, first) = (exchange.records_before()?, *exchange.called?.0.first()?);
    Some((cycle(records, first)?, places(records, first)?))
}

fn corners(exchange: &Exchange, found: &[Value]) -> Option<Wrong> {
    let (expected, _) = polygon_of(exchange)?;
    let found: Option<Vec<u32>> = found.iter().map(Value::id).collect();
    let Some(found) = found else { return Some(Wrong::kind("a list of corners")) };
    if found == expected {
        return None;
    }
    let list = Value::List(expected.iter().map(|&corner| Value::Id(corner)).collect());
    let mut backwards = expected.clone();
    backwards[1..].reverse();
    let mut rotated = expected.clone();
    rotated.rotate_left(1);
    let mut sorted = expected.clone();
    sorted.sort_unstable();
    let n = expected.len();
    Some(Wrong::value(&list, "counter-clockwise along next, each once, the given one first").is([
        (found == backwards, "the right list the opposite way round"),
        (found == rotated, "the right corners, beginning with the next of the one that is given"),
        (found == expected[..n - 1], "the right list without its last one"),
        (found == expected[1..], "the right list without the one that is given"),
        (
            found.len() == n + 1 && found[..n] == expected && found[n] == expected[0],
            "the right list with the first one again",
        ),
        (found == sorted, "the right corners in the order of their numbers"),
        (found == [expected[0]], "only the corner that is given"),
    ]))
}

fn diagonals(exchange: &Exchange, found: &[Value]) -> Option<Wrong> {
    let (corners, polygon) = polygon_of(exchange)?;
    let &[_, v] = exchange.called?.0 else { return None };
    let kind = diagonal(&polygon, 0, corners.iter().position(|&corner| corner == v)?);
    let [Value::Truth(found)] = *found else { return Some(Wrong::kind("yes or no")) };
    let expected = kind == Diagonal::Yes;
    (found != expected).then(|| Wrong::value(&Value::Truth(expected), kind.because()))
}

fn ears(exchange: &Exchange, found: &[Value]) -> Option<Wrong> {
    let (_, polygon) = polygon_of(exchange)?;
    let kind = ear(&polygon, 0);
    let [Value::Truth(found)] = *found else { return Some(Wrong::kind("yes or no")) };
    let expected = kind == Diagonal::Yes;
    let because = match kind {
        Diagonal::Yes => "the line between its neighbours lies inside and touches nothing",
        Diagonal::Outside => "the line between its neighbours begins outside of the polygon",
        Diagonal::Touches => "a corner lies on the line between its neighbours",
        _ => "the line between its neighbours crosses a side",
    };
    (found != expected).then(|| Wrong::value(&Value::Truth(expected), because))
}

/// The first fault of a sequence; what comes after it has no right start.
fn sequence(case: &Case, answer: &CaseAnswer) -> Vec<Fault> {
    for exchange in exchanges(case, answer) {
        if exchange.called.is_none() {
            let words = format!("{}: a link of it is not set", exchange.line());
            let rule = ["split.cut", "unresolved"];
            return vec![Fault::new(splits::TESTS[1], FaultKind::Wrong, exchange.step, rule, words)];
        }
        let faults = splits::judge(&exchange, splits::TESTS);
        if !faults.is_empty() {
            return faults;
        }
    }
    Vec::new()
}

/// Splits that look at everything.
fn costs(case: &Case, answer: &CaseAnswer) -> Vec<Fault> {
    let too_many = answered(case, answer).find_map(|(step, _, reply)| match reply {
        Reply::Reads(reads) if *reads > READS_OF_A_SPLIT => Some((step, *reads)),
        _ => None,
    });
    let fault = |(step, reads)| {
        let size = ("polygon", case.start.structure().map_or(0, Structure::len), "corners");
        too_many_reads(splits::TESTS[1], step, ("split", reads), size, "two dozen")
    };
    too_many.map(fault).into_iter().collect()
}

fn shown(name: String, start: Start) -> Case {
    let dump = start.dump();
    Case::new(name, start).step(dump)
}

/// Two polygons with their corners numbered in another order than they follow each other.
fn mixed() -> Start {
    let mut records =
        of_places(&[vec![[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]], vec![[9.0, 0.0], [12.0, 0.0], [9.0, 5.0]]]);
    let order = [3_u32, 5, 0, 6, 2, 4, 1];
    let old = records.clone();
    for (from, &to) in order.iter().enumerate() {
        let (Some(row), Some(place)) = (old.row(0, from), records.row_mut(0, to as usize)) else { continue };
        place.copy_from_slice(row);
        for cell in &mut place[2..] {
            *cell = crate::protocol::Cell::Link(cell.to().map(|corner| order[corner as usize]));
        }
    }
    Start::structure_of(Structure::Records(Arc::new(records)))
}

fn corner_cases() -> Vec<Case> {
    let call = |c: usize| Step::call("corners_of", [format!("c{c}")]);
    let mut cases = Vec::new();
    for (name, polygon) in
        small().into_iter().filter(|(name, _)| ["square", "arrow", "pentagon", "comb"].contains(name))
    {
        cases.push(shown(format!("corners_of.{name}"), start(&polygon)).calls((0..polygon.len()).map(call), &[]));
    }
    cases.push(shown("corners_of.two".to_owned(), mixed()).calls((0..7).map(call), &[]));
    cases.push(shown("corners_of.convex".to_owned(), convex(300)).step(Step::call("corners_of", ["c256"])));
    cases
}

/// Corners on a parabola.
fn regular(n: usize) -> Vec<[f64; 2]> {
    (0..n).map(|i| [i as f64, (i * i) as f64]).collect()
}

fn split_cases() -> Vec<Case> {
    let one = |name: &str, polygon: &[[f64; 2]], words: &str| {
        let case = shown(format!("split.{name}"), start(polygon));
        case.step(Step::of_line(&format!("split {words}"))).step(Step::Dump)
    };
    let mut cases = vec![
        one("across", &regular(5), "c0 c2"),
        one("back", &regular(5), "c2 c0"),
        one("square", &regular(4), "c0 c2"),
        one("same", &regular(4), "c1 c1"),
        one("next", &regular(4), "c1 c2"),
        one("prev", &regular(4), "c2 c1"),
        one("triangle", &regular(3), "c0 c2"),
    ];
    let blind = |n: usize| vec![[1.0, 2.0]; n];
    for (name, polygon) in
        [("four", regular(4)), ("five", regular(5)), ("six", regular(6)), ("blind", blind(5)), ("seven", regular(7))]
    {
        let n = polygon.len();
        let case = shown(format!("split.all.{name}"), start(&polygon));
        let mut pairs: Vec<(usize, usize)> = (0..n * n).map(|k| (k / n, k % n)).collect();
        // Those to be refused first: as long as nothing changes, it is printed once.
        pairs.sort_by_key(|&(u, v)| !(u == v || (u + 1) % n == v || (v + 1) % n == u));
        let call = |(u, v)| Step::call("split", [format!("c{u}"), format!("c{v}")]);
        cases.push(case.each_alone(pairs.into_iter().map(call)));
    }
    let pairs = ["c3 c0", "c0 c3", "c5 c6", "c6 c5", "c2 c4"].map(|pair| Step::of_line(&format!("split {pair}")));
    cases.push(shown("split.two".to_owned(), mixed()).each_alone(pairs));
    let convex_300 = shown("split.convex".to_owned(), convex(300));
    cases.push(convex_300.step(Step::of_line("split c299 c256")).step(Step::Dump));
    let large = shown("split.large".to_owned(), convex(100_000));
    let far = ["split c65537 c90000", "split c100 c50000"].map(Step::of_line);
    cases.push(large.calls(far, &[Step::Reads, Step::Changes]));
    cases
}

/// Splits after splits, by links from what the ones before have made.
fn sequence_cases() -> Vec<Case> {
    let lists: [(&str, &[&str]); 4] = [
        ("fan", &["c0 c2", "c0 c3", "c0 c4", "c0 c5"]),
        ("halves", &["c0 c4", "c0.prev c0.next", "c2 c2.next.next", "c2 c2.prev"]),
        ("copies", &["c0 c4", "c1.prev c1.next.next", "c1.prev c1", "c4 c4.prev.prev"]),
        ("there_and_back", &["c5 c1", "c1 c5", "c2 c0", "c5.next.next c5"]),
    ];
    let case = |(name, calls): (&str, &[&str])| {
        let case = shown(format!("{SEQUENCE}{name}"), start(&regular(8)));
        calls.iter().fold(case, |case, pair| case.step(Step::of_line(&format!("split {pair}"))).step(Step::Dump))
    };
    lists.into_iter().map(case).collect()
}

/// Every corner, or every pair of corners, of the small polygons and of those where doubles go wrong.
fn reading_cases(word: &str) -> Vec<Case> {
    let all = small().into_iter().chain(rounding());
    all.map(|(name, polygon)| all_calls(word, name, &polygon)).collect()
}

fn all_calls(word: &str, name: &str, polygon: &[[f64; 2]]) -> Case {
    let n = polygon.len();
    let case = shown(format!("{word}.{name}"), start(polygon));
    let corner = |c: usize| format!("c{c}");
    match word {
        "is_ear" => case.calls((0..n).map(|c| Step::call(word, [corner(c)])), &[]),
        _ => case.calls((0..n * n).map(|k| Step::call(word, [corner(k / n), corner(k % n)])), &[]),
    }
}

fn soup_cases() -> Vec<Case> {
    let call = |name: &str, start: Start, first: usize| {
        shown(format!("triangulate.{name}"), start)
            .step(Step::call("triangulate", [format!("c{first}")]))
            .step(Step::Dump)
    };
    let mut cases = vec![call("triangle", start(&[[0.0, 0.0], [4.0, 0.0], [3.0, 3.0]]), 0)];
    for (name, polygon) in small().into_iter().chain(rounding()) {
        let others = [0, 1, polygon.len() - 1];
        cases.extend(others.map(|first| call(&format!("{name}.{first}"), start(&polygon), first)));
    }
    cases.push(call("convex", convex(300), 7));
    cases.push(call("comb_large", start(&comb(30)), 0));
    cases.push(call("spiral_large", start(&spiral(9)), 3));
    cases
}

fn random(name: &str, seed: u64) -> Vec<Case> {
    let mut random = Random::new(seed, name);
    let mut case = |k: usize| {
        let polygon = random_star(&mut random, SIZES[0] + random_size(k));
        let corner = |random: &mut Random| format!("c{}", random.below(polygon.len()));
        let case = shown(format!("{name}.random.{k}"), start(&polygon));
        match name {
            "split" if k % 2 == 1 => {
                let case = shown(format!("{SEQUENCE}random.{k}"), start(&polygon));
                (0..SPLITS).fold(case, |case, _| {
                    let first = corner(&mut random);
                    let steps = 1 + random.below(5);
                    let words = format!("split {first} {first}{}", ".next".repeat(steps));
                    case.step(Step::of_line(&words)).step(Step::Dump)
                })
            }
            "triangulate" => case.step(Step::call(name, [corner(&mut random)])).step(Step::Dump),
            "split" => case.step(Step::call(name, [(); 2].map(|()| corner(&mut random)))).step(Step::Dump),
            "corners_of" => case.step(Step::call(name, [corner(&mut random)])),
            _ => all_calls(name, &format!("random.{k}"), &polygon),
        }
    };
    (0..RANDOM).map(&mut case).collect()
}

/// From few corners to many.
fn random_size(k: usize) -> usize {
    k * (SIZES[1] - SIZES[0]) / (RANDOM - 1).max(1)
}
