//! What is right in this lab: its cases, and what the student's functions should answer.
//!
//! ```text
//!   suites()   the cases of each graded test: a start, then calls      polygon 0 0 4 0 3 3
//!                                                                      dump
//!                                                                      border_edges
//!   judge()    what is wrong with the answers to a case
//! ```
//!
//! The student's program runs as a process of its own; all that is known of it is what it printed. The functions of
//! the answer are computed here once more, from the structure that was printed before the call.

use dcel_lab::answers::{self, Function, Wrong};
use dcel_lab::cases::cycles::from_cycles;
use dcel_lab::cases::starts::{convex, grid, polygon, wheel};
use dcel_lab::fault::{Exchange, Fault};
use dcel_lab::judge::{Asked, Judge, Suite};
use dcel_lab::protocol::{Case, CaseAnswer, Start, Step, Value};
use dcel_lab::{FeatureSet, HalfEdgeId, Plan, Table, View};
use std::path::Path;

/// The judge of this lab.
pub static JUDGE: BorderEdges = BorderEdges;

/// The judge of this lab.
pub struct BorderEdges;

// What can be said of a call before it is made. The report says which of these all failing calls have in common.
dcel_lab::features! {
    Bridge "bridge" "an edge has the outer face on both sides",
    Inside "inside" "an edge has the outer face on neither side",
    Large "large" "there are more than 100 half-edges",
}

impl Judge for BorderEdges {
    fn suites(&self, _: &Plan) -> Vec<Suite> {
        // A square with a diagonal and an edge that dangles outside; two triangles that an edge joins.
        let points = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0], [7.0, 0.0]];
        let dangling = from_cycles(&points, &[&[0, 3, 2, 1, 4, 1], &[0, 1, 2], &[0, 2, 3]]);
        let points = [[0.0, 0.0], [-5.0, 4.0], [-5.5, -3.0], [6.0, 1.0], [11.0, -3.5], [11.0, 5.0]];
        let bridge = from_cycles(&points, &[&[0, 3, 5, 4, 3, 0, 2, 1], &[0, 1, 2], &[3, 4, 5]]);
        let small = [
            ("triangle", polygon(&[[0.0, 0.0], [7.0, 1.0], [2.0, 6.0]])),
            ("wheel", wheel(4)),
            ("cells", grid(2, 2)),
            ("one_row", grid(5, 1)),
            ("dangling", Start::table(dangling)),
            ("bridge", Start::table(bridge)),
        ];
        let large = [
            ("polygon", convex(300)),
            ("wheel", wheel(120)),
            ("cells", grid(30, 30)),
            ("tails", Start::table(tails())),
        ];
        let asked = |test: &str, starts: &[(&str, Start)]| {
            Asked::fixed(starts.iter().map(|(name, start)| {
                let case = Case::new(format!("{test}.{name}"), start.clone());
                case.step(Step::Dump).step(Step::of_line("border_edges"))
            }))
        };
        vec![
            Suite { name: "small", tests: &["small"], asked: asked("small", &small) },
            Suite { name: "large", tests: &["large"], asked: asked("large", &large) },
        ]
    }

    fn judge(&self, suite: &Suite, case: &Case, answer: &CaseAnswer) -> Vec<Fault> {
        let functions = [Function { word: "border_edges", test: suite.tests[0], wrong }];
        answers::judge(&functions, case, answer)
    }

    fn vocabulary(&self) -> &'static [dcel_lab::judge::Feature] {
        VOCABULARY
    }

    fn features(&self, _: &[&Exchange], exchange: &Exchange) -> Option<u128> {
        let sides = sides(exchange)?;
        let mut set = FeatureSet::default();
        set.add(Word::Bridge as u32, sides[2] > 0);
        set.add(Word::Inside as u32, sides[0] > 0);
        set.add(Word::Large as u32, exchange.before()?.half_edges.len() > 100);
        Some(set.bits())
    }

    fn promise(&self, _: &Fault) -> &'static str {
        "border_edges counts the edges with the outer face on exactly one side"
    }
}

/// A path of 60 edges that begins at a corner of a triangle.
fn tails() -> Table {
    const LENGTH: u32 = 60;
    let mut points = vec![[0.0, 0.0], [-1.0, 2.0], [-2.0, -1.0]];
    points.extend((1..=LENGTH).map(|i| [f64::from(i), 0.0]));
    let there = (3..LENGTH + 3).chain((3..LENGTH + 2).rev());
    let outer: Vec<u32> = [0, 2, 1, 0].into_iter().chain(there).collect();
    from_cycles(&points, &[&outer, &[0, 1, 2]])
}

/// How many edges of the structure that was printed before a call have the outer face on no, one and both sides.
fn sides(exchange: &Exchange) -> Option<[usize; 3]> {
    let table = exchange.before()?;
    let mut sides = [0; 3];
    for h in (0..table.half_edges.len() as u32).map(HalfEdgeId::new) {
        let twin = table.twin(h)?;
        if h < twin {
            sides[[h, twin].into_iter().filter(|&h| table.face(h) == table.outer_face).count()] += 1;
        }
    }
    Some(sides)
}

fn wrong(exchange: &Exchange, values: &[Value]) -> Option<Wrong> {
    let [inside, expected, bridges] = sides(exchange)?;
    let [Value::Id(found)] = values else { return Some(Wrong::kind("one whole number")) };
    let found = *found as usize;
    let wrong = Wrong::value(&Value::Id(expected as u32), "so many edges have the outer face on exactly one side");
    (found != expected).then(|| {
        wrong.is([
            (found == expected + bridges, "the number of edges with the outer face on at least one side"),
            (found == expected + 2 * bridges, "the number of half-edges of the outer face"),
            (found == inside + expected + bridges, "the number of all edges"),
        ])
    })
}

/// Judges one graded test in the folder of a student, for `tests/graded.rs`.
///
/// # Panics
/// If the test is not passed: this is how a test fails.
#[track_caller]
pub fn graded(folder: &Path, work: &Path, test: &str) {
    dcel_lab::graded_by(&JUDGE, Path::new(env!("CARGO_MANIFEST_DIR")), folder, work, test);
}
