//! The cases of lab 11, test by test.
//!
//! ```text
//!   small, that a student can type ─▶ random edits, a dump after each ─▶ large ─▶ 10,000 edits, dumps by changes
//! ```

use super::answers::is_edit;
use super::model::{Model, Place};
use super::solids::{SCHEMA, Solid, cube, empty, gem, nested, soup};
use super::{answers, features, picture};
use crate::cases::random::Random;
use crate::fault::{Exchange, Fault};
use crate::judge::{Asked, Judge, Source, Suite};
use crate::pictures;
use crate::plan::Plan;
use crate::protocol::{Case, CaseAnswer, Schema, Start, Step};
use std::sync::LazyLock;

/// The judge of lab 11.
pub struct SupportJudge;

/// How many random sequences are asked for each test of edits, and of how many edits.
const SEQUENCES: usize = 12;
const EDITS: usize = 16;
/// How many edits the long sequence makes, and how often it is looked at.
const MANY: usize = 10_000;
const LOOK: usize = 50;

/// The starts by their names, which are the first part of the name of a case: `gem.…`.
fn starts() -> Vec<Solid> {
    let tetrahedron = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0], [0.0, 0.0, 4.0]];
    let closed = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]];
    // Two fans that meet at one vertex only.
    let bow = [[0.0; 3], [3.0, 0.0, 1.0], [3.0, 2.0, 0.0], [1.0, 3.0, 1.0], [-3.0, 0.0, 1.0], [-3.0, -2.0, 0.0]];
    let far = 2.0_f64.powi(56);
    let near = [[far, 0.0, 0.0], [far, 1.0, 0.0], [far, 0.0, 1.0], [-far, 0.0, 0.0]];
    let low = tetrahedron.map(|p: Place| p.map(|x| x - 9.0));
    // A pyramid whose side is pushed in: not convex. The climb from v1 along x ends below v4.
    let dented =
        [[0.0, 0.0, 6.0], [-6.0, 0.0, 0.0], [0.0, -6.0, 0.0], [1.0, 0.0, 0.0], [6.0, 4.0, 0.0], [5.0, -5.0, 0.0]];
    let dents = [[0, 1, 2], [0, 2, 5], [0, 5, 3], [0, 3, 4], [0, 4, 1], [2, 1, 3], [2, 3, 5], [1, 4, 3]];
    // Vertices without triangles, some of them free.
    let loose = [&tetrahedron[..], &[[9.0, 8.0, 7.0], [-1.0, 5.0, -2.0], [-8.0, 6.0, 9.0]]].concat();
    vec![
        empty(),
        soup("triangle", &tetrahedron[..3], &[[0, 1, 2]]),
        soup("tetrahedron", &tetrahedron, &closed),
        soup("bow", &bow, &[[0, 1, 2], [0, 2, 3], [0, 4, 5]]),
        soup("loose", &loose, &closed).with_free(&[6, 4]),
        soup("dented", &dented, &dents),
        gem(),
        cube("cube_1", 1),
        cube("cube_2", 2),
        cube("cube_4", 4),
        nested("nested_1", 1),
        nested("nested_2", 2),
        nested("nested_3", 3),
        soup("low", &low, &closed),
        soup("near", &near, &[[0, 1, 2], [0, 3, 1], [1, 3, 2], [2, 3, 0]]),
        cube("cube_45", 45),
    ]
}

/// A start, and what is made of it once: the large cube takes a while.
struct Known {
    name: &'static str,
    start: Start,
    model: Model,
}

static KNOWN: LazyLock<Vec<Known>> = LazyLock::new(|| {
    let known = |solid: Solid| Known { name: solid.name, start: solid.start(), model: solid.model() };
    starts().into_iter().map(known).collect()
});

fn start(name: &str) -> Option<&'static Known> {
    KNOWN.iter().find(|start| start.name == name)
}

impl Judge for SupportJudge {
    fn schema(&self) -> Schema {
        Schema::Records(&SCHEMA)
    }

    fn suites(&self, plan: &Plan) -> Vec<Suite> {
        let edits = |tests: &'static [&'static str], fixed: &[(&str, &str)], kinds: [usize; 4]| {
            let name = tests[0];
            let fixed = fixed.iter().enumerate();
            let fixed = fixed.filter_map(|(i, (on, lines))| shown(&format!("{on}.{name}_{i}"), lines));
            let sequences = |seed: u64, _| {
                let mut random = Random::new(seed, name);
                let on = ["empty", "tetrahedron", "loose", "gem", "cube_1", "bow"];
                (0..SEQUENCES)
                    .map(|i| (on[i % on.len()], format!("{name}_{i}")))
                    .filter_map(|(on, name)| random_edits(on, &name, kinds, EDITS, 1, &mut random))
                    .filter(|case| case.steps.len() > 1)
                    .collect::<Vec<_>>()
            };
            Suite::of(tests, Asked::fixed_and_seeded(fixed, plan, SEQUENCES, sequences))
        };
        let mut remove_vertex = edits(&["remove_vertex"], REMOVE_VERTEX, [1, 0, 0, 3]);
        remove_vertex.asked.extend(with_reads("remove_vertex", ["9000", "11000"]));
        let mut remove_face = edits(&["remove_face"], REMOVE_FACE, [0, 0, 1, 0]);
        remove_face.asked.extend(with_reads("remove_face", ["9000 9001", "11000 11001"]));
        let mut many_edits = edits(&["many_edits"], MANY_EDITS, [3, 6, 4, 1]);
        // The long sequence decides: short ones are there to be read.
        many_edits.asked.retain(|asked| {
            let number = asked.case.name.rsplit('_').next().and_then(|number| number.parse().ok());
            asked.source == Source::Fixed || number.is_some_and(|number: usize| number.is_multiple_of(3))
        });
        let mut random = Random::new(plan.seed, "many");
        let many = random_edits("empty", "many_edits", [4, 6, 3, 1], MANY, LOOK, &mut random);
        many_edits.asked.extend(Asked::random(many));
        vec![
            edits(&["add_vertex"], ADD_VERTEX, [1, 0, 0, 0]),
            edits(&["add_face"], ADD_FACE, [1, 4, 0, 0]),
            remove_face,
            remove_vertex,
            many_edits,
            Suite::of(&["support_by_scan"], heights("support_by_scan", plan)),
            Suite::of(&["climb"], heights("climb", plan)),
            Suite::of(&["support"], heights("support", plan)),
            Suite::of(
                &["climb_svg"],
                Asked::fixed(Some(Case::new("gem.climb_svg", gem().start()).step(Step::Dump).step(Step::Svg))),
            ),
        ]
    }

    fn judge(&self, suite: &Suite, case: &Case, answer: &CaseAnswer) -> Vec<Fault> {
        let name = case.name.split('.').next().unwrap_or_default();
        let empty = Model::default();
        let model = start(name).map_or(&empty, |start| &start.model);
        let mut faults = answers::judge(suite.tests[0], model, case, answer);
        faults.extend(pictures::judge_case(suite.tests[0], case, answer, picture::reference));
        faults
    }

    crate::features_of!(features);

    fn concerns(&self, suite: &Suite, step: &Step, exchange: Option<&Exchange>) -> Vec<&'static str> {
        // In a long row of edits, those after which the mesh is not looked at say nothing by themselves.
        let is_edit = matches!(step, Step::Call { function, .. } if is_edit(function));
        let is_unseen = exchange.is_some_and(|exchange| exchange.structure_after.is_none());
        if is_edit && is_unseen { Vec::new() } else { suite.tests.to_vec() }
    }

    fn blames(&self, fault: &Fault) -> Option<&'static str> {
        // What goes wrong in a mixed sequence may be the fault of any call before it; a vertex is removed with its faces.
        let all = ["add_vertex", "add_face", "remove_face", "climb"];
        all.into_iter().find(|&name| fault.rule == name && fault.test != "many_edits")
    }

    fn promise(&self, fault: &Fault) -> &'static str {
        match fault.test {
            "add_vertex" => "add_vertex uses the vertex that became free last, or else makes the list longer",
            "add_face" => "add_face makes a triangle with all its references, or refuses and changes nothing",
            "remove_face" => "remove_face takes away the triangle, and its edges that have no other",
            "remove_vertex" => "remove_vertex takes away the vertex and all triangles at it",
            "many_edits" => "all references are right after any sequence of edits",
            "climb" => "a climb goes to the highest neighbour as long as that one is higher",
            "support_by_scan" | "support" => "no vertex is higher than the support vertex",
            _ => "the picture shows all edges and the vertices of the climb",
        }
    }

    /// The case without some of the calls before the last one: without all, a half, a quarter of them and so on, as long as
    /// every call that is left may be asked.
    fn shorter(&self, case: &Case) -> Vec<Case> {
        let is_call = |step: &usize| matches!(case.steps[*step], Step::Call { .. });
        let mut calls: Vec<usize> = (0..case.steps.len()).filter(is_call).collect();
        calls.pop();
        let mut out = Vec::new();
        let mut size = calls.len();
        while size > 0 {
            out.extend(calls.chunks(size).map(|left_out| {
                let steps = case.steps.iter().enumerate().filter(|(i, _)| !left_out.contains(i));
                Case { steps: steps.map(|(_, step)| step.clone()).collect(), ..case.clone() }
            }));
            size /= 2;
        }
        out.retain(may_be_asked);
        out
    }
}

/// Whether every call is for what is there when it is made.
fn may_be_asked(case: &Case) -> bool {
    let name = case.name.split('.').next().unwrap_or_default();
    let mut model = start(name).map_or_else(Model::default, |start| start.model.clone());
    case.steps.iter().all(|step| match step {
        Step::Call { function, arguments } => answers::may_be_asked(&mut model, function, arguments),
        _ => true,
    })
}

/// Fixed edits: a start, then lines.
const ADD_VERTEX: &[(&str, &str)] = &[
    ("empty", "add_vertex 1 2 3"),
    ("empty", "add_vertex 0 0 0; add_vertex 0.1 1e-30 1e15; add_vertex 0 0 0"),
    ("gem", "add_vertex 5 5 500"),
    ("loose", "add_vertex 1 1 1"),
    ("loose", "add_vertex 1 2 3; add_vertex 4 5 6; add_vertex 7 8 9; add_vertex 1 2 3"),
];
const ADD_FACE: &[(&str, &str)] = &[
    ("empty", "add_vertex 0 0 0; add_vertex 1 0 0; add_vertex 0 1 0; add_face 0 1 2"),
    ("empty", "add_vertex 0 0 0; add_vertex 1 0 0; add_vertex 0 1 0; add_face 0 1 2; add_face 2 1 0"),
    ("triangle", "add_vertex 3 3 3; add_face 1 0 3; add_face 2 1 3; add_face 0 2 3"),
    ("triangle", "add_vertex 3 3 3; add_face 0 1 3; add_face 2 0 3; add_face 3 0 1"),
    ("triangle", "add_face 0 0 1; add_face 1 0 0; add_face 0 1 0; add_face 1 1 1; add_face 0 1 7; add_face 9 8 7"),
    ("triangle", "add_vertex 3 3 3; add_vertex 4 4 4; add_face 0 3 4; add_face 0 4 3; add_face 0 4 3"),
    ("tetrahedron", "add_face 0 1 2; add_face 0 2 1; add_face 3 1 0"),
    ("bow", "add_face 0 3 4; add_face 0 5 1"),
    ("loose", "add_face 0 5 4; add_face 6 5 0; add_face 5 1 4"),
    ("loose", "add_face 0 5 7; add_face 0 5 5"),
];
const REMOVE_FACE: &[(&str, &str)] = &[
    ("triangle", "remove_face 0 1"),
    ("triangle", "remove_face 2 0"),
    ("tetrahedron", "remove_face 0 1; remove_face 1 2; remove_face 2 0"),
    ("tetrahedron", "remove_face 0 1; remove_face 1 0; remove_face 1 2; remove_face 2 0"),
    ("bow", "remove_face 0 4; remove_face 0 2"),
    ("bow", "remove_face 1 2; remove_face 3 0"),
    ("gem", "remove_face 1 2; remove_face 2 1; remove_face 3 4; remove_face 7 2"),
    ("cube_1", "remove_face 0 2; remove_face 0 1"),
];
const REMOVE_VERTEX: &[(&str, &str)] = &[
    ("triangle", "remove_vertex 1"),
    ("tetrahedron", "remove_vertex 3; remove_vertex 0"),
    ("bow", "remove_vertex 0"),
    ("bow", "remove_vertex 2; remove_vertex 5"),
    ("gem", "remove_vertex 7; remove_vertex 0; remove_vertex 3"),
    ("gem", "remove_vertex 1; remove_vertex 4; add_vertex 1 1 1; add_vertex 2 2 2; add_vertex 3 3 3"),
    (
        "empty",
        "add_vertex 0 0 0; add_vertex 1 0 0; remove_vertex 0; add_vertex 2 0 0; remove_vertex 1; remove_vertex 0",
    ),
];

/// Numbers are used again; what was there once is made anew.
const MANY_EDITS: &[(&str, &str)] = &[
    ("tetrahedron", "remove_face 0 1; add_face 0 1 3"),
    ("tetrahedron", "remove_face 0 1; remove_face 1 2; add_face 1 2 3; add_face 0 1 3"),
    ("triangle", "remove_face 0 1; add_face 0 1 2"),
    ("triangle", "remove_face 0 1; add_face 2 1 0"),
    ("triangle", "add_vertex 3 3 3; remove_face 0 1; add_face 1 0 3; add_face 0 2 3; add_face 0 1 2"),
    ("gem", "remove_vertex 7; add_vertex 0 0 200; add_face 1 2 7; add_face 2 3 7; add_face 3 4 7"),
    ("gem", "remove_vertex 0; remove_vertex 7; add_vertex 5 5 5; add_vertex 6 6 6; add_face 0 1 2; add_face 2 1 7"),
    ("cube_1", "remove_vertex 0; remove_vertex 3; add_vertex 9 9 9; add_vertex 8 8 8; add_face 0 3 1"),
];

/// A case whose structure is shown after each line.
fn shown(name: &str, lines: &str) -> Option<Case> {
    let case = Case::new(name, start(name.split('.').next()?)?.start.clone()).step(Step::Dump);
    Some(case.calls(lines.split(';').map(Step::of_line), &[Step::Dump]))
}

/// Edits of a large mesh: numbers of half-edges past 65,536, and how many records are looked at.
fn with_reads(function: &str, edits: [&str; 2]) -> Vec<Asked> {
    let case = start("cube_45").map(|cube| Case::new(format!("cube_45.{function}"), cube.start.clone()));
    let calls = edits.map(|words| Step::of_line(&format!("{function} {words}")));
    Asked::fixed(case.map(|case| case.calls(calls, &[Step::Reads, Step::Changes])))
}

/// Random edits that can be made, and triangles that have to be refused; `kinds` says how often each of add_vertex, add_face, remove_face and remove_vertex is made.
fn random_edits(
    on: &str,
    name: &str,
    kinds: [usize; 4],
    count: usize,
    look: usize,
    random: &mut Random,
) -> Option<Case> {
    const VERTICES: usize = 40;
    let start = start(on)?;
    let mut model = start.model.clone();
    let is_long = look > 1;
    let show = || if is_long { Step::Changes } else { Step::Dump };
    let mut case = Case::new(format!("{on}.{name}"), start.start.clone()).step(show());
    let deck: Vec<usize> = (0..4).flat_map(|kind| std::iter::repeat_n(kind, kinds[kind])).collect();
    let mut made = 0;
    for _ in 0..20 * count {
        let live: Vec<usize> = model.live().collect();
        let line = match random.pick(&deck)? {
            0 if live.len() < VERTICES => {
                let place = [0; 3].map(|_| random.below(41) as f64 / 2.0 - 10.0);
                model.add_vertex(place);
                format!("add_vertex {} {} {}", place[0], place[1], place[2])
            }
            1 if live.len() > 2 => {
                // Now and then a number that may be that of no vertex.
                let any = |random: &mut Random| match random.below(16) {
                    0 => random.below(model.vertices.len() + 2),
                    _ => random.pick(&live).copied().unwrap_or_default(),
                };
                // Mostly beside another triangle; now and then one that must be refused.
                let border: Vec<(usize, usize)> =
                    model.across.keys().map(|&(a, b)| (b, a)).filter(|side| !model.across.contains_key(side)).collect();
                let corners = match random.pick(&border).filter(|_| random.clone().below(4) > 0) {
                    Some(&(a, b)) => [a, b, any(random)],
                    None => [any(random), any(random), any(random)],
                };
                model.add_face(corners);
                format!("add_face {} {} {}", corners[0], corners[1], corners[2])
            }
            2 if !model.across.is_empty() => {
                let sides: Vec<(usize, usize)> = model.across.keys().copied().collect();
                let &(a, b) = random.pick(&sides)?;
                model.remove_face(a, b);
                format!("remove_face {a} {b}")
            }
            3 if !live.is_empty() => {
                let &v = random.pick(&live)?;
                model.remove_vertex(v);
                format!("remove_vertex {v}")
            }
            _ => continue,
        };
        made += 1;
        case = case.step(Step::of_line(&line));
        if made % look == 0 {
            case = case.step(show());
        }
        if made == count {
            break;
        }
    }
    Some(case)
}

/// Questions for a highest vertex.
fn heights(function: &str, plan: &Plan) -> Vec<Asked> {
    let mut asked: Vec<Case> = Vec::new();
    let axes: [Place; 6] =
        [[0.0, 0.0, 1.0], [0.0, 0.0, -1.0], [1.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, -1.0, 0.0]];
    let others: [Place; 5] = [[1.0, 2.0, 5.0], [-3.0, 1.0, 2.0], [1.0, 1.0, 0.0], [-1.0, -1.0, -1.0], [2.0, -7.0, 1.0]];
    for start in KNOWN.iter() {
        let is_asked = match start.name {
            "triangle" | "bow" | "near" | "cube_45" => false,
            "empty" => function == "support_by_scan",
            // A climb from a vertex without triangles ends there, and one that is not convex ends anywhere.
            "loose" | "dented" => function != "support",
            _ => true,
        };
        if !is_asked {
            continue;
        }
        let model = &start.model;
        let vertices = model.vertices.len().max(1);
        let mut case = Case::new(format!("{}.{function}", start.name), start.start.clone()).step(Step::Dump);
        for (i, d) in axes.iter().chain(&others).enumerate() {
            // From every vertex of the small ones, from some of the others.
            for from in (0..vertices).filter(|from| vertices <= 30 || (from + i) % 7 == 0) {
                let is_vertex = model.place(from).is_some();
                let asks = if function == "support_by_scan" { from == 0 } else { is_vertex };
                if asks {
                    case = case.step(question(function, from, *d));
                }
            }
        }
        asked.push(case);
    }
    let far = 2.0_f64.powi(56);
    if let Some(start) = start("near") {
        let mut case = Case::new(format!("near.{function}"), start.start.clone()).step(Step::Dump);
        for [y, z] in [[1.0, 2.0], [2.0, 1.0], [-1.0, -2.0], [0.0, 1.0]] {
            case.steps.extend((0..4).map(|from| question(function, from, [far, y, z])));
        }
        asked.push(case);
    }
    let random = |seed: u64, _| {
        let mut random = Random::new(seed, function);
        let case = start("cube_4").map(|start| {
            let case = Case::new(format!("cube_4.{function}_random"), start.start.clone()).step(Step::Dump);
            let any = |_| {
                let d = [0; 3].map(|_| random.below(7) as f64 - 3.0);
                question(function, random.below(98), d)
            };
            case.calls((0..40).map(any), &[])
        });
        Vec::from_iter(case)
    };
    let mut all = Asked::fixed_and_seeded(asked, plan, 1, random);
    if function != "support_by_scan" {
        let large = start("cube_45").map(|start| {
            let case = Case::new(format!("cube_45.{function}"), start.start.clone());
            let asked = [(0, [3.0, 2.0, 1.0]), (11_000, [-5.0, 7.0, 1.0]), (6_543, [1.0, -3.0, 9.0])];
            case.calls(asked.map(|(from, d)| question(function, from, d)), &[Step::Reads])
        });
        all.extend(Asked::fixed(large));
    }
    all
}

fn question(function: &str, from: usize, [x, y, z]: Place) -> Step {
    let from = if function == "support_by_scan" { String::new() } else { format!(" v{from}") };
    Step::of_line(&format!("{function}{from} {x} {y} {z}"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeMap;

    #[test]
    fn shorter_cases_ask_for_what_is_there_and_keep_the_last_call() {
        let mut random = Random::new(3, "shorter");
        let case = random_edits("tetrahedron", "mixed", [3, 6, 4, 1], 12, 1, &mut random).unwrap();
        let calls = |case: &Case| {
            let calls = case.steps.iter().filter(|step| matches!(step, Step::Call { .. }));
            calls.cloned().collect::<Vec<_>>()
        };
        let (all, shorter) = (calls(&case), SupportJudge.shorter(&case));
        assert!(shorter.len() > 5, "{}", shorter.len());
        for short in &shorter {
            assert!(calls(short).len() < all.len() && calls(short).last() == all.last(), "{}", short.script());
            assert_eq!(illegal(short), [""; 0], "{}", short.script());
        }
        assert!(shorter.iter().any(|short| calls(short).len() + 1 == all.len()), "one call is left out");
    }

    /// Makes the edits of a case in a model; says which of them cannot be made.
    fn illegal(case: &Case) -> Vec<String> {
        let name = case.name.split('.').next().unwrap();
        let mut model = start(name).unwrap().model.clone();
        let mut out = Vec::new();
        for step in &case.steps {
            let Step::Call { function, arguments } = step else { continue };
            let ids: Vec<usize> = arguments.iter().filter_map(|word| word.parse().ok()).collect();
            let can_be_made = match (function.as_str(), &ids[..]) {
                ("remove_face", &[a, b]) => model.remove_face(a, b),
                ("remove_vertex", &[v]) => {
                    let is_vertex = model.place(v).is_some();
                    model.remove_vertex(v);
                    is_vertex
                }
                ("add_face", &[a, b, c]) => {
                    model.add_face([a, b, c]);
                    true
                }
                ("add_vertex", _) => {
                    model.add_vertex([0.0; 3]);
                    true
                }
                _ => true,
            };
            if !can_be_made {
                out.push(format!("{}: {function} {}", case.name, arguments.join(" ")));
            }
        }
        out
    }

    #[test]
    fn only_what_is_there_is_removed() {
        let mut calls: BTreeMap<&str, usize> = BTreeMap::new();
        for suite in SupportJudge.suites(&Plan::with_seed(3)) {
            for asked in &suite.asked {
                assert_eq!(illegal(&asked.case), Vec::<String>::new());
                let made = asked.case.steps.iter().filter(|step| matches!(step, Step::Call { .. })).count();
                *calls.entry(suite.name).or_default() += made;
            }
        }
        assert!(calls.values().filter(|&&calls| calls > 50).count() == 8, "{calls:?}");
    }

    #[test]
    fn random_edits_do_everything_and_use_numbers_again() {
        let mut random = Random::new(1, "many");
        let case = random_edits("empty", "x", [4, 6, 3, 1], MANY, LOOK, &mut random).unwrap();
        for word in ["add_vertex", "add_face", "remove_face", "remove_vertex"] {
            let calls =
                case.steps.iter().filter(|step| matches!(step, Step::Call { function, .. } if function == word));
            assert!(calls.count() > 200, "{word}");
        }
        assert_eq!(case.steps.iter().filter(|step| matches!(step, Step::Call { .. })).count(), MANY);
        assert_eq!(case.steps.iter().filter(|step| step.shows()).count(), MANY / LOOK + 1);
    }
}
