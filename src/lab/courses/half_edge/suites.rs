//! The cases of lab 04, test by test.
//!
//! A deterministic case of a task calls the functions of that task only, so that what fails does not depend on
//! other tasks. Small cases that a student can type come first, then one case for each small structure with every
//! call that can be made on it, then random sequences.

use super::classes::classes;
use super::costs::{self, small_grid};
use super::sequences::{Mix, polygon, random, sequence};
use super::shorter::shorter;
use super::spec::{Legal, may_split_face};
use super::starts::{odd, rectangle, relabelled, rounding, window};
use super::{drawing, features, sequences, split_face, split_in_half, walk, walks};
use crate::cases::random::Random;
use crate::cases::starts::{convex, polygon as polygon_at, triangles, wheel};
use crate::checks::walks::{BLIND, IN_THE_BLIND, blind, half_edges};
use crate::fault::{Exchange, Fault, FaultKind};
use crate::judge::{Asked, Judge, Suite, ToldBy};
use crate::plan::Plan;
use crate::protocol::{Case, CaseAnswer, Start, Step};
use dcel_kit::Element;
use dcel_kit::topology::{HalfEdgeRow, Table};

/// How many random sequences are asked for each test, and of how many calls.
const RANDOM: (usize, usize) = (16, 10);
/// How many small structures are asked with other names, too.
const RELABELLED: usize = 8;

/// The judge of lab 04.
pub struct HalfEdge;

impl Judge for HalfEdge {
    fn suites(&self, plan: &Plan) -> Vec<Suite> {
        let reads =
            |tests: &'static [&'static str], function| Suite::of(tests, Asked::fixed(reading(tests[0], function)));
        let edits = |name, tests, cases| Suite { name, tests, asked: Asked::fixed(cases) };
        let sequences = |tests: &'static [&'static str], fixed, weights| {
            Suite::of(tests, sequence_cases(tests[0], fixed, weights, plan))
        };
        let structures = structures();
        let case = Case::new("drawing", rectangle());
        let case = case.step(Step::Dump).step(Step::call::<&str>("drawing", [])).step(Step::Dump).step(Step::Svg);
        vec![
            reads(&["face_walk"], "walk_face"),
            reads(&["face_vertices"], "walk_vertices"),
            reads(&["destination_by_twin"], "destination"),
            reads(&["destination_by_next"], "destination_by_next"),
            reads(&["vertex_star"], "walk_vertex"),
            edits("split_face", &split_face::TESTS, split_face_cases(&structures)),
            sequences(&["split_face_sequences"], face_sequences(), [1, 0]),
            edits("split_in_half", &split_in_half::TESTS[1..], split_in_half_cases(&structures)),
            sequences(&["split_in_half_sequences"], mixed_sequences(), [1, 1]),
            edits("drawing", &drawing::TESTS, vec![case]),
        ]
    }

    fn judge(&self, suite: &Suite, case: &Case, answer: &CaseAnswer) -> Vec<Fault> {
        let mut faults = match suite.name {
            "split_face" => by_call(case, answer, |exchange| split_face::judge(exchange, &split_face::TESTS)),
            "split_in_half" => by_call(case, answer, |exchange| split_in_half::judge(exchange, &split_in_half::TESTS)),
            "split_face_sequences" | "split_in_half_sequences" => sequences::judge(suite.tests[0], case, answer),
            "drawing" => drawing::judge(case, answer),
            _ => walks::judge(suite.tests[0], case, answer),
        };
        if is_blind(&case.start) {
            faults.iter_mut().for_each(|fault| fault.words.push_str(IN_THE_BLIND));
        }
        faults
    }

    fn concerns(&self, suite: &Suite, step: &Step, exchange: Option<&Exchange>) -> Vec<&'static str> {
        match (suite.name, exchange) {
            // Where only the reads of a split are counted, nobody sees what has come of it.
            (_, Some(exchange)) if is_unseen(exchange) => Vec::new(),
            // A call that must be refused is the matter of step 0 alone.
            ("split_face", Some(exchange)) if !split_face::is_legal(exchange) => vec![split_face::TESTS[0]],
            // To refuse a call is easy: what a sequence shows is shown by calls that are carried out.
            ("split_face_sequences" | "split_in_half_sequences", Some(exchange))
                if exchange.function == "split_face" && !split_face::is_legal(exchange) =>
            {
                Vec::new()
            }
            ("drawing", _) => vec![drawing::TESTS[usize::from(*step == Step::Svg)]],
            _ => suite.tests.to_vec(),
        }
    }

    fn blames(&self, fault: &Fault) -> Option<&'static str> {
        let (function, step) = fault.rule.split_once('.')?;
        let tests: &[&'static str] = match function {
            "split_face" => &split_face::TESTS,
            "split_in_half" => &split_in_half::TESTS,
            _ => return None,
        };
        tests.get(step.parse::<usize>().ok()?).copied()
    }

    fn told_by(&self, test: &str) -> ToldBy {
        if test.starts_with("drawing") { ToldBy::Words } else { ToldBy::Law }
    }

    crate::features_of!(features);

    fn promise(&self, fault: &Fault) -> &'static str {
        match (&fault.kind, fault.rule.as_str()) {
            (FaultKind::Crashed { .. }, _) => "after some splits, the next one panics or ends the program",
            (FaultKind::TimedOut | FaultKind::OutOfMemory, _) => "after some splits, the next one does not come back",
            (_, "split_face.0") => "split_face refuses illegal calls, and only these, without changing anything",
            (_, "split_face.1") => "split_face makes one face and no vertex",
            (_, "split_face.2") => "split_face makes two half-edges, twins with the right origins",
            (_, "split_face.3") => "after split_face, next and prev close both cycles",
            (_, "split_face.4") => "after split_face, every half-edge knows its face",
            (_, "split_face.5") => "after split_face, faces and vertices know a half-edge of their own",
            (_, "split_in_half.1") => "split_in_half makes one vertex, at the midpoint",
            (_, "split_in_half.2") => "split_in_half makes two half-edges with the right origins and twins",
            (_, "split_in_half.3") => "after split_in_half, links, faces and what vertices refer to are right",
            _ => "after some splits, all laws of the structure hold",
        }
    }

    fn weighted(&self) -> &'static [&'static str] {
        &["split_face", "split_in_half"]
    }

    fn expected(&self, exchange: &Exchange) -> Option<Table> {
        super::expected(exchange)
    }

    fn answer(&self, exchange: &Exchange) -> Vec<Element> {
        let asked = exchange.before().zip(exchange.called);
        let walk =
            asked.and_then(|(table, (arguments, _))| walk::expected(table, exchange.function, *arguments.first()?));
        walk.map_or_else(Vec::new, |walk| walk.elements.iter().map(|&number| (walk.element)(number)).collect())
    }

    fn shorter(&self, case: &Case) -> Vec<Case> {
        shorter(case)
    }
}

/// Whether all vertices are at one place. A case that was made shorter has another name, and the same start.
fn is_blind(start: &Start) -> bool {
    let Some(table) = start.half_edges() else { return false };
    let mut places = table.vertices.iter().flatten().map(|row| row.position);
    places.next().is_some_and(|first| places.all(|other| other == first))
}

/// Whether the structure that a split has left is not shown.
fn is_unseen(exchange: &Exchange) -> bool {
    matches!(exchange.function, "split_face" | "split_in_half") && exchange.after().is_none()
}

fn by_call(case: &Case, answer: &CaseAnswer, judge: impl Fn(&Exchange) -> Vec<Fault>) -> Vec<Fault> {
    crate::fault::exchanges(case, answer).iter().flat_map(judge).collect()
}

/// The structures of the exhaustive cases, with their names: those on which corners and vertices differ, one of
/// every small kind, some of these with other names.
fn structures() -> Vec<(String, Table)> {
    let mut all: Vec<(String, Table)> = odd().map(|(name, table)| (name.to_owned(), table)).into();
    all.extend(odd().into_iter().take(4).map(|(name, table)| (format!("{}.{name}", &BLIND[1..]), blind(&table))));
    let classes = small_classes();
    let mut random = Random::new(4, "relabelled");
    let step = (classes.len() / RELABELLED).max(1);
    let others: Vec<Table> = classes.iter().step_by(step).map(|class| relabelled(class, &mut random)).collect();
    all.extend(classes.into_iter().enumerate().map(|(i, class)| (format!("class.{i}"), class)));
    all.extend(others.into_iter().enumerate().map(|(i, other)| (format!("relabelled.{i}"), other)));
    all
}

/// One of every kind that up to three splits make of triangles, squares and pentagons. (A hexagon is a pentagon
/// with an edge split.)
pub(super) fn small_classes() -> Vec<Table> {
    classes(3..=5, 3)
}

/// Cases for a function that only reads: all elements of a few structures.
fn reading(name: &str, function: &str) -> Vec<Case> {
    let letter = match function {
        "walk_face" | "walk_vertices" => 'f',
        "walk_vertex" => 'v',
        _ => 'h',
    };
    let first = format!("{letter}{}", u8::from(letter == 'f'));
    let mut cases =
        vec![Case::new(format!("{name}.first"), rectangle()).step(Step::Dump).step(Step::call(function, [first]))];
    let fan = triangles(&[[0.0, 0.0], [8.0, 0.0], [6.0, 5.0], [-1.0, 7.0]], &[[0, 1, 2], [0, 2, 3]]);
    let mut random = Random::new(4, name);
    let starts = [
        ("rectangle", rectangle(), [2, 6, 12]),
        ("triangle", polygon(3), [2, 3, 6]),
        ("two_triangles", fan, [3, 4, 10]),
        ("window", Start::table(window()), [5, 9, 24]),
        ("window_again", Start::table(relabelled(&window(), &mut random)), [5, 9, 24]),
    ];
    let mut starts: Vec<_> =
        starts.into_iter().map(|(start_name, start, counts)| (start_name.to_owned(), start, counts)).collect();
    for (odd_name, odd) in odd() {
        let counts = [odd.faces.len(), odd.vertices.len(), odd.half_edges.len()];
        starts.push((odd_name.to_owned(), Start::table(odd.clone()), counts));
        starts.push((format!("{odd_name}_again"), Start::table(relabelled(&odd, &mut random)), counts));
        starts.push((format!("{odd_name}{BLIND}"), Start::table(blind(&odd)), counts));
    }
    starts.push((format!("window{BLIND}"), Start::table(blind(&window())), [5, 9, 24]));
    starts.push(("wheel".to_owned(), wheel(40), [3, 3, 9]));
    starts.push(("convex".to_owned(), convex(300), [2, 2, 4]));
    let call = |number: usize| Step::call(function, [format!("{letter}{number}")]);
    for (start_name, start, [faces, vertices, half_edges]) in starts {
        let count = match letter {
            'f' => faces,
            'v' => vertices,
            _ => half_edges,
        };
        let case = Case::new(format!("{name}.{start_name}"), start).step(Step::Dump);
        cases.push(case.calls((0..count).map(call), &[]));
    }
    let grid = Case::new(format!("{name}.grid"), small_grid()).step(Step::Dump);
    let far = match letter {
        'f' => [0, 256, 257, 300],
        'v' => [255, 256, 257, 335],
        _ => [255, 256, 600, 1269],
    };
    cases.push(grid.calls(far.map(call), &[]));
    cases.push(costs::questions(name, function, letter));
    // The two ways to a destination are two: each must do without the pointers of the other.
    let without: Option<fn(&mut HalfEdgeRow)> = match function {
        "destination" => Some(|row| (row.next, row.prev) = (None, None)),
        "destination_by_next" => Some(|row| row.twin = None),
        _ => None,
    };
    if let Some(without) = without {
        let mut start = window();
        start.half_edges.iter_mut().flatten().for_each(without);
        let case = Case::new(format!("{name}.alone"), Start::table(start)).step(Step::Dump);
        cases.push(case.step(Step::call(function, ["h0"])).step(Step::call(function, ["h9"])));
    }
    cases
}

fn split_face_cases(structures: &[(String, Table)]) -> Vec<Case> {
    let one = |name: &str, start: Start, pair: &str| {
        sequence(&format!("split_face.{name}"), start, &format!("split_face {pair}"))
    };
    let mut cases = vec![
        one("across", rectangle(), "h2 h8"),
        one("back", rectangle(), "h8 h2"),
        one("square", polygon(4), "h0 h4"),
        one("outside", rectangle(), "h1 h5"),
        one("outside_back", rectangle(), "h9 h3"),
        one("same", rectangle(), "h4 h4"),
        one("next", rectangle(), "h0 h2"),
        one("prev", rectangle(), "h2 h0"),
        one("other_face", rectangle(), "h0 h5"),
        one("other_face_back", rectangle(), "h5 h0"),
        one("twelve", polygon_at(&TWELVE), "h0 h4"),
        one("convex", convex(300), "h0 h8"),
        one("convex_outside", convex(300), "h1 h201"),
        one("wheel", wheel(40), "h3 h83"),
        one("grid", small_grid(), "h1200 h1200.next.next"),
        one("grid_outside", small_grid(), "h1 h41"),
    ];
    for (name, structure) in structures {
        let case = Case::new(format!("split_face.{name}"), Start::table(structure.clone())).step(Step::Dump);
        let pairs = half_edges(structure).flat_map(|h1| half_edges(structure).map(move |h2| (h1, h2)));
        let mut asked: Vec<_> =
            pairs.map(|(h1, h2)| (may_split_face(structure, h1, h2) == Legal::Yes, h1, h2)).collect();
        // Those to be refused first: as long as the structure stays the same, it is printed once.
        asked.sort_unstable();
        cases.push(case.each_alone(asked.into_iter().map(|(_, h1, h2)| Step::call("split_face", [h1, h2]))));
    }
    cases
}

fn split_in_half_cases(structures: &[(String, Table)]) -> Vec<Case> {
    let one = |name: &str, start: Start, h: &str| {
        sequence(&format!("split_in_half.{name}"), start, &format!("split_in_half {h}"))
    };
    let mut cases = vec![
        one("inside", rectangle(), "h0"),
        one("outside", rectangle(), "h5"),
        one("triangle", polygon(3), "h2"),
        one("triangle_outside", polygon(3), "h3"),
        one("convex", convex(300), "h598"),
        one("grid", small_grid(), "h1200"),
    ];
    for (i, start) in rounding().into_iter().enumerate() {
        let case = Case::new(format!("split_in_half.rounding.{i}"), start).step(Step::Dump);
        cases.push(case.each_alone(["h0", "h2", "h4"].map(|h| Step::call("split_in_half", [h]))));
    }
    for (name, structure) in structures {
        let case = Case::new(format!("split_in_half.{name}"), Start::table(structure.clone())).step(Step::Dump);
        cases.push(case.each_alone(half_edges(structure).map(|h| Step::call("split_in_half", [h]))));
    }
    cases
}

/// A convex polygon with more corners than any structure of the classes.
const TWELVE: [[f64; 2]; 12] = [
    [-40.0, -150.0],
    [40.0, -150.0],
    [110.0, -110.0],
    [150.0, -40.0],
    [150.0, 40.0],
    [110.0, 110.0],
    [40.0, 150.0],
    [-40.0, 150.0],
    [-110.0, 110.0],
    [-150.0, 40.0],
    [-150.0, -40.0],
    [-110.0, -110.0],
];

/// Sequences of `split_face` with stored representatives, on both sides.
fn face_sequences() -> Vec<Case> {
    vec![
        sequence("fan", rectangle(), "split_face h2 h6; split_face h2 h8; split_face h2 h10"),
        sequence(
            "stored",
            rectangle(),
            "split_face h2 h8; split_face f1.half_edge f1.half_edge.next.next; \
             split_face h8.face.half_edge h8.face.half_edge.next.next; \
             split_face f1.half_edge f1.half_edge.next",
        ),
        sequence(
            "both_sides",
            rectangle(),
            "split_face h2 h8; split_face h8.prev.twin h4; split_face h8.prev h8.next.next; \
             split_face h2.prev h6",
        ),
        sequence(
            "outside",
            polygon(5),
            "split_face f0.half_edge f0.half_edge.next.next; \
             split_face h1.face.half_edge h1.face.half_edge.prev.prev; \
             split_face f0.half_edge f0.half_edge.next.next; \
             split_face v0.outgoing v0.outgoing.next.next",
        ),
        sequence(
            "many_corners",
            polygon_at(&TWELVE),
            "split_face h0 h4; split_face h10 h4.prev.twin; split_face h1 h15",
        ),
        sequence(
            "refused_between",
            polygon(4),
            "split_face h0 h2; split_face h0 h4; split_face h0 h4; split_face h0.prev h4.prev; \
             split_face h0.prev.twin h2",
        ),
    ]
}

/// Sequences of both splits, from both twins.
fn mixed_sequences() -> Vec<Case> {
    vec![
        sequence(
            "halves",
            polygon(3),
            "split_in_half h0; split_in_half h0; split_in_half h0.next.twin; split_in_half h0.prev",
        ),
        sequence("halves_of_halves", rectangle(), &["split_in_half h0"; 8].join("; ")),
        sequence("forty_halves", polygon(3), &["split_in_half h2"; 40].join("; ")),
        sequence(
            "door",
            rectangle(),
            "split_face h2 h8; split_in_half h8.prev; split_in_half h8.prev.twin; \
             split_face h8.prev h10.next; split_face h2.prev h4",
        ),
        sequence(
            "stored",
            rectangle(),
            "split_in_half f1.half_edge; split_in_half f0.half_edge; \
             split_face f1.half_edge f1.half_edge.next.next; split_in_half f0.half_edge.twin; \
             split_face f0.half_edge f0.half_edge.prev.prev; split_in_half v3.outgoing; \
             split_face v3.outgoing v3.outgoing.next.next",
        ),
        sequence(
            "ends",
            polygon(4),
            "split_in_half h1; split_in_half v1.outgoing; split_in_half v0.outgoing; \
             split_face v0.outgoing v0.outgoing.next.next; split_in_half v0.outgoing.twin; \
             split_face h4 h4.next.next.next",
        ),
    ]
}

fn sequence_cases(name: &str, fixed_ones: Vec<Case>, weights: [usize; 2], plan: &Plan) -> Vec<Asked> {
    let named = fixed_ones.into_iter().map(|case| Case { name: format!("{name}.{}", case.name), ..case });
    let mut named: Vec<Case> = named.collect();
    named.push(costs::splits(name, if weights[1] == 0 { "split_face" } else { "split_in_half" }));
    let mut asked = Asked::fixed(named);
    let cases = |seed: u64, stream: &str, count: usize, mix: Mix| -> Vec<Case> {
        let mut numbers = Random::new(seed, name);
        (0..count).map(|i| random(&format!("{name}.{stream}.{i}"), mix, &mut numbers)).collect()
    };
    let (count, calls) = RANDOM;
    asked.extend(Asked::random(cases(plan.seed, "random", count, Mix { calls, weights })));
    if let Some(secret) = &plan.secret {
        let weights =
            if weights[1] == 0 { weights } else { [secret.weight("split_face"), secret.weight("split_in_half")] };
        let mix = Mix { calls: secret.calls, weights };
        asked.extend(Asked::hidden(cases(secret.seed, "hidden", secret.sequences, mix)));
    }
    asked
}
