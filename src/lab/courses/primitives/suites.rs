//! The cases of lab 09, test by test. Each begins with a surface that the kit has made, so a mistake in one function
//! costs that function.

use super::asked::{call, start};
use super::features;
use super::growth;
use super::reference::{self, turned};
use super::{costs, picture, revolve, shorter};
use crate::answers::{self, Function};
use crate::cases::random::Random;
use crate::checks::faults::Faults;
use crate::fault::{Fault, exchanges};
use crate::judge::{Asked, Judge, Suite, ToldBy};
use crate::pictures;
use crate::plan::Plan;
use crate::protocol::{Case, CaseAnswer, Step};
use dcel_kit::HalfEdgeId;
use dcel_kit::topology::{Dcel, Table};

/// How many random surfaces are asked for each test.
const RANDOM: usize = 12;

/// The tests whose cases are not like the others.
const LARGE: &str = "large";
const PICTURE: &str = "picture";
const REVOLVE: &str = "revolve";

/// The function that gives places back.
const FUNCTIONS: &[Function] = &[Function { word: REVOLVE, test: REVOLVE, wrong: revolve::wrong }];

/// The judge of lab 09.
pub struct Primitives;

/// Small surfaces of both kinds.
fn surfaces() -> Vec<Table> {
    let seed = Some(Table::from_view(&Dcel::torus()));
    let grown = [reference::cube(1), reference::torus(3, 3), reference::tube(5, 1, [true, false])];
    [reference::ring(3), reference::ring(6), seed].into_iter().chain(grown).flatten().collect()
}

/// Surfaces with more records than a byte can count, and a face of 300 sides.
fn large() -> Vec<Table> {
    [reference::tube(40, 0, [true, false]), reference::tube(300, 1, [false; 2])].into_iter().flatten().collect()
}

/// A surface that has grown from a seed by primitives at random places, spurs included.
fn random(numbers: &mut Random) -> Table {
    let seeds = surfaces();
    let mut table = numbers.pick(&seeds).cloned().unwrap_or_default();
    for _ in 0..numbers.below(7) {
        let first = HalfEdgeId::new(numbers.below(table.half_edges.len()) as u32);
        if numbers.below(2) == 0 {
            let mut last = first;
            for _ in 0..numbers.below(3) {
                last = turned(&table, last).unwrap_or(last);
            }
            reference::split_vertex(&mut table, first, last);
        } else if let Some(&other) = reference::round(&table, first).as_deref().and_then(|all| numbers.pick(&all[1..]))
        {
            reference::split_face(&mut table, first, other);
        }
    }
    table
}

/// The cases of one surface: all pairs of half-edges if there are few, else some pairs.
fn on(name: &str, function: &str, table: &Table, numbers: &mut Random) -> Vec<Case> {
    let count = table.half_edges.len();
    if count <= 6 {
        let pairs = (0..count * count).map(|i| [i / count, i % count]);
        // The handout says that a face is not split at one half-edge.
        let pairs = pairs.filter(|[h, other]| h != other || function == "split_vertex");
        let case = |[h, other]: [usize; 2]| {
            call(format!("{name}.{h}.{other}"), table, function, &[format!("h{h}"), format!("h{other}")])
        };
        return pairs.map(case).collect();
    }
    let few: Vec<usize> =
        if count > 12 { (0..4).map(|_| numbers.below(count)).collect() } else { (0..count).step_by(2).collect() };
    let word = |h: HalfEdgeId| format!("h{}", h.number());
    let mut out = Vec::new();
    for (i, h) in few.into_iter().map(|h| HalfEdgeId::new(h as u32)).enumerate() {
        let others: Vec<HalfEdgeId> = match function {
            "split_vertex" => {
                let mut last = h;
                (0..i % 4).for_each(|_| last = turned(table, last).unwrap_or(last));
                let stranger = HalfEdgeId::new(numbers.below(count) as u32);
                vec![last, stranger]
            }
            _ => {
                let all = reference::round(table, h).unwrap_or_default();
                let same = numbers.pick(all.get(1..).unwrap_or(&[])).copied();
                same.into_iter()
                    .chain([HalfEdgeId::new(numbers.below(count) as u32)])
                    .filter(|&other| other != h)
                    .collect()
            }
        };
        for (k, other) in others.into_iter().enumerate() {
            out.push(call(format!("{name}.{i}.{k}"), table, function, &[word(h), word(other)]));
        }
    }
    out
}

fn one(name: &str, function: &str, table: &Table, numbers: &mut Random) -> Vec<Case> {
    let h = numbers.below(table.half_edges.len());
    let mut words = vec![format!("h{h}")];
    if function == "divide" {
        words.push((1 + numbers.below(5)).to_string());
    }
    vec![call(name.to_owned(), table, function, &words)]
}

/// Every half-edge of small surfaces with a spur, cut in two or three: at the tip there is nothing to be moved.
fn at_spurs() -> Vec<Case> {
    let seeds = reference::ring(3).into_iter().chain([Table::from_view(&Dcel::torus())]);
    let mut out = Vec::new();
    for (i, mut table) in seeds.enumerate() {
        let first = HalfEdgeId::new(0);
        reference::split_vertex(&mut table, first, first);
        for h in 0..table.half_edges.len() {
            let words = [format!("h{h}"), (2 + h % 2).to_string()];
            out.push(call(format!("divide.spur.{i}.{h}"), &table, "divide", &words));
        }
    }
    out
}

/// A polygon of 2(n + m) sides, or a torus whose two edges are cut.
fn to_fill(name: &str, n: usize, m: usize, is_torus: bool) -> Option<Case> {
    let (table, first) =
        if is_torus { reference::torus_to_fill(n, m)? } else { (reference::ring(2 * (n + m))?, HalfEdgeId::new(0)) };
    let words = [format!("h{}", first.number()), n.to_string(), m.to_string()];
    Some(call(format!("{name}.{n}.{m}.{is_torus}"), &table, "fill", &words))
}

fn counted(name: String, table: &Table, function: &str) -> Case {
    Case::new(name, start(table)).step(Step::Dump).step(Step::of_line(function))
}

type Made = fn(&str, &str, &Table, &mut Random) -> Vec<Case>;

fn asked(test: &str, function: &str, make: Made, plan: &Plan) -> Vec<Asked> {
    let mut order = Random::new(0, test);
    let known = surfaces().into_iter().chain(large()).enumerate();
    let fixed = known.flat_map(|(i, table)| make(&format!("{test}.{i}"), function, &table, &mut order));
    let some = |seed: u64, count: usize| {
        let mut numbers = Random::new(seed, test);
        let mut all = Vec::new();
        for i in 0..count {
            let table = random(&mut numbers);
            all.extend(make(&format!("{test}.random.{i}"), function, &table, &mut numbers));
        }
        all
    };
    Asked::fixed_and_seeded(fixed.collect::<Vec<_>>(), plan, RANDOM, some)
}

fn shapes(function: &str, numbers: &[&[usize]]) -> Vec<Asked> {
    let case = |numbers: &&[usize]| {
        let words: Vec<String> = numbers.iter().map(usize::to_string).collect();
        Case::new(format!("{function}.{}", words.join(".")), start(&Table::from_view(&Dcel::torus())))
            .step(Step::call(function, words))
            .step(Step::Dump)
    };
    Asked::fixed(numbers.iter().map(case).collect::<Vec<_>>())
}

/// Surfaces in space: all kinds of poles, small and large, then random ones.
fn revolved(plan: &Plan) -> Vec<Asked> {
    let mut number = 0;
    let mut case = |sides: usize, rings: usize, poles: Option<[bool; 2]>, numbers: &mut Random| {
        let revolve::Asked { table, h, rows } = revolve::asked(sides, rings, poles, numbers)?;
        let numbers = rows.iter().flatten().map(f64::to_string);
        let words: Vec<String> = std::iter::once(format!("h{}", h.number())).chain(numbers).collect();
        number += 1;
        let case = Case::new(format!("revolve.{number}"), start(&table));
        Some(case.step(Step::Dump).step(Step::call(REVOLVE, words)))
    };
    let kinds = [Some([false; 2]), Some([true, false]), Some([false, true]), Some([true; 2])];
    let mut fixed = Random::new(9, REVOLVE);
    let mut small = Vec::new();
    for (sides, rings) in [(3, 1), (3, 2), (4, 2), (4, 3), (5, 4), (40, 7)] {
        // A ring with one pole has no wall on the left of some of its half-edges.
        let kinds = kinds.into_iter().filter(|kind| rings > 1 || *kind != Some([false, true]));
        small.extend(kinds.filter_map(|kind| case(sides, rings, kind, &mut fixed)));
    }
    small.extend([(3, 3), (4, 3), (3, 5), (20, 15)].iter().filter_map(|&(n, m)| case(n, m, None, &mut fixed)));
    let some = |seed: u64, count: usize| {
        let mut numbers = Random::new(seed, REVOLVE);
        let mut all = Vec::new();
        for _ in 0..count {
            let kind = numbers.pick(&kinds).copied();
            let (sides, rings) = (3 + numbers.below(6), 2 + numbers.below(4));
            all.extend(case(sides, rings, kind.unwrap_or_default(), &mut numbers));
        }
        all
    };
    Asked::fixed_and_seeded(small, plan, RANDOM, some)
}

impl Judge for Primitives {
    fn suites(&self, plan: &Plan) -> Vec<Suite> {
        let count: Made = |name, function, table, _| vec![counted(name.to_owned(), table, function)];
        let sizes = [(1, 1), (2, 1), (1, 2), (2, 2), (3, 2), (2, 4), (5, 5)];
        let all = sizes.iter().flat_map(|&(n, m)| [to_fill("fill", n, m, false), to_fill("fill", n, m, true)]);
        let fill = all.chain([to_fill("fill", 30, 20, false)]).flatten().collect::<Vec<_>>();
        let two: &[&[usize]] = &[&[3, 1], &[4, 2], &[6, 3], &[5, 5], &[40, 7]];
        let cells: &[&[usize]] = &[&[1, 1], &[2, 1], &[1, 3], &[4, 3], &[20, 15]];
        let wrapped: &[&[usize]] = &[&[3, 3], &[4, 3], &[3, 5], &[20, 15]];
        let bands: &[&[usize]] = &[&[3, 2], &[4, 3], &[6, 4], &[40, 9]];
        let mut rings = shapes("ring", &[&[3], &[4], &[7], &[300]]);
        rings.extend(shapes("torus_seed", &[&[]]));
        let mut divide = Asked::fixed(at_spurs());
        divide.extend(asked("divide", "divide", one, plan));
        let drawn = Case::new("picture", start(&Table::from_view(&Dcel::torus()))).step(Step::Svg);
        vec![
            Suite::of(&["seeds"], rings),
            Suite::of(&["split_vertex"], asked("split_vertex", "split_vertex", on, plan)),
            Suite::of(&["split_face"], asked("split_face", "split_face", on, plan)),
            Suite::of(&[LARGE], Asked::fixed([costs::questions()])),
            Suite::of(&["euler"], asked("euler", "euler", count, plan)),
            Suite::of(&["genus"], asked("genus", "genus", count, plan)),
            Suite::of(&["pole"], asked("pole", "pole", one, plan)),
            Suite::of(&["divide"], divide),
            Suite::of(&["fill"], Asked::fixed(fill)),
            Suite::of(&["grid"], shapes("grid", cells)),
            Suite::of(&["torus"], shapes("torus", wrapped)),
            Suite::of(&["extrude"], asked("extrude", "extrude", one, plan)),
            Suite::of(&["cylinder"], shapes("cylinder", two)),
            Suite::of(&["cube"], shapes("cube", &[&[1], &[2], &[3], &[8]])),
            Suite::of(&["cone"], shapes("cone", two)),
            Suite::of(&["sphere"], shapes("sphere", bands)),
            Suite::of(&[REVOLVE], revolved(plan)),
            Suite::of(&[PICTURE], Asked::fixed([drawn])),
        ]
    }

    fn judge(&self, suite: &Suite, case: &Case, answer: &CaseAnswer) -> Vec<Fault> {
        match suite.name {
            REVOLVE => answers::judge(FUNCTIONS, case, answer),
            PICTURE => pictures::judge_case(PICTURE, case, answer, picture::plain),
            test => {
                let calls = exchanges(case, answer);
                let judge = |exchange| Faults::found(exchange, |faults| growth::judge(exchange, test, faults));
                let wrong = calls.iter().flat_map(judge);
                let cost = (test == LARGE).then(|| costs::judge(LARGE, case, answer));
                wrong.chain(cost.into_iter().flatten()).collect()
            }
        }
    }

    fn told_by(&self, test: &str) -> ToldBy {
        if matches!(test, "split_vertex" | "split_face" | LARGE | PICTURE) { ToldBy::Words } else { ToldBy::Answer }
    }

    crate::features_of!(features);

    fn promise(&self, fault: &Fault) -> &'static str {
        match fault.test {
            "seeds" => "the seeds are the double-sided disc and the torus of one vertex",
            "split_vertex" => "split_vertex moves the half-edges from first up to last to a new vertex, or refuses",
            "split_face" => "split_face puts the new face on the left of the half-edge that it returns, or refuses",
            LARGE => "both splits are right, and look at what is near only, in a surface of 100,000 records",
            REVOLVE => "revolve gives each vertex the place of its row and of its turn",
            PICTURE => "the picture shows the six surfaces",
            "euler" | "genus" => "V - E + F and the genus are counted rightly",
            "pole" => "pole joins a new vertex to each corner of the face",
            "divide" => "divide cuts an edge in as many pieces as are asked for",
            "fill" => "fill cuts the face in n times m quads",
            "extrude" => "extrude moves the face up and puts a wall under each of its sides",
            _ => "the surface has the right vertices, edges and faces, joined as they should be",
        }
    }

    fn shorter(&self, case: &Case) -> Vec<Case> {
        shorter::shorter(case)
    }
}
