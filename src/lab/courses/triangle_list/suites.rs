//! The cases of lab 05, test by test. Steps are asked on tables that hold what the steps before should have made, so a
//! mistake in one step costs that step.

use super::lists::{self, Named};
use super::soup::Soup;
use super::steps::{ADD_FACE, BORDER};
use super::{drawing, features, steps, whole};
use crate::cases::handouts::LIST_POINTS;
use crate::cases::random::Random;
use crate::cases::starts;
use crate::checks::faults::Faults;
use crate::fault::{Exchange, Fault, exchanges};
use crate::judge::{Asked, Judge, Suite, ToldBy};
use crate::pictures;
use crate::plan::Plan;
use crate::protocol::{Case, CaseAnswer, Start, Step};

/// How many random lists are asked for each test.
const RANDOM: usize = 12;
/// How many lists are drawn at random until as many as are wanted are of the kind that a test asks for.
const DRAWN: usize = 100;

/// The judge of lab 05.
pub struct TriangleList;

/// Whether a list may be asked for a test.
type Fits = fn(&Soup) -> bool;
/// The case of a list; the generator decides how its half-edges are numbered.
type CaseOf = fn(String, &Soup, &mut Random) -> Case;

impl Judge for TriangleList {
    fn suites(&self, plan: &Plan) -> Vec<Suite> {
        let with_good = |bad: Vec<Named>| lists::good().into_iter().chain(bad).collect::<Vec<_>>();
        let good_and_large = || lists::good().into_iter().chain(lists::large()).collect::<Vec<_>>();
        let all_faces_right: Fits = |soup| soup.bad_faces().is_empty();
        let matched: Fits = |soup| soup.bad_faces().is_empty() && soup.edges_twice().is_empty();
        let right: Fits = |soup| soup.refusals().is_empty();
        let index: Fits = |soup| soup.bad_faces().iter().all(|why| why.contains("no vertex"));
        let corners: Fits = |soup| soup.bad_faces().iter().all(|why| !why.contains("no vertex"));
        let twice: Fits = |soup| soup.bad_faces().is_empty() && !soup.edges_twice().is_empty();
        let pinched: Fits =
            |soup| soup.bad_faces().is_empty() && soup.edges_twice().is_empty() && !soup.pinched().is_empty();
        let suite = |name, tests, lists: Vec<Named>, fits: Fits, small: Fits, case: CaseOf| Suite {
            name,
            tests,
            asked: asked(name, &lists, [fits, small], case, plan),
        };
        let never: Fits = |_| false;
        let whole_lists =
            [good_and_large(), lists::with_edges_twice(), lists::pinched(), lists::bad_index(), lists::bad_corners()]
                .concat();
        let mut suites = vec![
            suite("check_faces_index", &["check_faces_index"], with_good(lists::bad_index()), index, never, check),
            suite(
                "check_faces_corners",
                &["check_faces_corners"],
                with_good(lists::bad_corners()),
                corners,
                never,
                check,
            ),
            suite("add_face", &ADD_FACE, good_and_large(), all_faces_right, never, add),
            suite("match_twins", &["match_twins"], good_and_large(), matched, matched, twins),
            suite("match_twins_refused", &["match_twins_refused"], lists::with_edges_twice(), twice, twice, twins),
            suite("close_border", &BORDER, good_and_large(), right, right, border),
            suite("close_border_refused", &["close_border_refused"], lists::pinched(), pinched, pinched, border),
            suite("from_faces", &["from_faces"], whole_lists, |_| true, |_| true, build),
        ];
        if let Some(last) = suites.last_mut() {
            last.asked.extend(Asked::fixed([rounding()]));
        }
        let vertices = (whole::CELLS + 1) * (whole::CELLS + 1);
        let mut large = Case::new("from_faces.large", Start::line(format!("vertices {vertices}")));
        large.steps.extend(whole::large_steps());
        suites.push(Suite::of(&["from_faces_large"], Asked::fixed([large])));
        let picture = Case::new("picture", Start::line(format!("points{}", starts::points(&LIST_POINTS))));
        let picture = picture.step(Step::call("from_faces", drawing::soup().words())).step(Step::Svg);
        suites.push(Suite::of(&["structure_svg"], Asked::fixed([picture])));
        suites
    }

    fn judge(&self, suite: &Suite, case: &Case, answer: &CaseAnswer) -> Vec<Fault> {
        let test = suite.tests[0];
        match suite.name {
            "from_faces_large" => return whole::large(test, case, answer),
            "structure_svg" => return pictures::judge_case(test, case, answer, drawing::reference),
            _ => {}
        }
        let judge = |exchange: &Exchange, faults: &mut Faults| match exchange.function {
            "check_faces" => steps::check_faces(exchange, test, faults),
            "add_face" => steps::add_face(exchange, faults),
            "match_twins" => steps::match_twins(exchange, test, faults),
            "close_border" => steps::close_border(exchange, suite.tests, faults),
            _ => whole::from_faces(exchange, test, faults),
        };
        let found = |exchange| Faults::found(exchange, |faults| judge(exchange, faults));
        exchanges(case, answer).iter().flat_map(found).collect()
    }

    fn told_by(&self, test: &str) -> ToldBy {
        if test == "from_faces" { ToldBy::Answer } else { ToldBy::Words }
    }

    crate::features_of!(features);

    fn promise(&self, fault: &Fault) -> &'static str {
        match fault.test {
            "check_faces_index" => {
                "check_faces refuses a number that no vertex has, names it, and refuses nothing else"
            }
            "check_faces_corners" => {
                "check_faces refuses vertices that come twice in a face and faces of fewer than three corners, and names \
                 them"
            }
            "add_face_records" => "add_face makes a face and its half-edges: origins, face, representatives",
            "add_face_links" => "add_face links next and prev all the way round",
            "match_twins" => "match_twins finds the other half of every inner edge and changes nothing else",
            "match_twins_refused" => "match_twins refuses a directed edge that comes twice, and names it",
            "close_border_half_edges" => "close_border gives every half-edge without a twin a twin in the outer face",
            "close_border_links" => "close_border links the half-edges of every border cycle",
            "close_border_refused" => "close_border refuses a pinched vertex, and names it",
            "structure_svg" => "the picture shows each face but the outer one, each edge and each vertex",
            _ => "from_faces builds the structure of the whole list, or says truly what is wrong with it",
        }
    }

    fn shorter(&self, case: &Case) -> Vec<Case> {
        let [Step::Dump, Step::Call { function, arguments }, ..] = case.steps.as_slice() else { return Vec::new() };
        let Some(soup) = Soup::of_words(0, arguments).filter(|_| matches!(&**function, "check_faces" | "from_faces"))
        else {
            return Vec::new();
        };
        let without = |f: usize| {
            let mut less = soup.clone();
            less.faces.remove(f);
            let mut case = case.clone();
            case.steps[1] = Step::call(function, less.words());
            case
        };
        (0..soup.faces.len()).map(without).collect()
    }
}

/// The cases of the named lists, of the small ones that fit, and of random ones that fit.
fn asked(name: &str, named: &[Named], [fits, small]: [Fits; 2], case: CaseOf, plan: &Plan) -> Vec<Asked> {
    let mut order = Random::new(5, name);
    let mut all: Vec<Case> = named.iter().map(|(of, soup)| case(format!("{name}.{of}"), soup, &mut order)).collect();
    let every = lists::exhaustive().into_iter().filter(small).enumerate();
    all.extend(every.map(|(i, soup)| case(format!("{name}.four_vertices.{i}"), &soup, &mut order)));
    let random = |seed, count| {
        let mut numbers = Random::new(seed, name);
        let mut all = Vec::new();
        for _ in 0..DRAWN {
            let soup = lists::random(&mut numbers);
            let soup = if numbers.below(2) == 0 { lists::with_a_slip(soup, &mut numbers) } else { soup };
            if fits(&soup) && !soup.has_vertex_of_two_fans_only() && all.len() < count {
                all.push(case(format!("{name}.random.{}", all.len()), &soup, &mut numbers));
            }
        }
        all
    };
    Asked::fixed_and_seeded(all, plan, RANDOM, random)
}

fn vertices(soup: &Soup) -> Start {
    Start::line(format!("vertices {}", soup.vertices))
}

fn check(name: String, soup: &Soup, _: &mut Random) -> Case {
    Case::new(name, vertices(soup)).step(Step::Dump).step(Step::call("check_faces", soup.words()))
}

/// The faces one by one.
fn add(name: String, soup: &Soup, _: &mut Random) -> Case {
    let case = Case::new(name, vertices(soup)).step(Step::Dump);
    let few = soup.faces.iter().take(FACES);
    few.fold(case, |case, face| case.step(Step::call("add_face", face)).step(Step::Dump))
}

/// How many faces of a list are added one by one.
const FACES: usize = 12;

fn of_table(name: String, soup: &Soup, order: &mut Random, twins: bool, function: &str) -> Case {
    let corners: usize = soup.faces.iter().map(Vec::len).sum();
    // Half of the tables are numbered face by face, as students make them.
    let numbers = if order.below(2) == 0 { (0..corners).collect() } else { order.order(corners) };
    let case = Case::new(name, Start::table(soup.table(&numbers, twins)));
    case.step(Step::Dump).step(Step::of_line(function)).step(Step::Dump)
}

fn twins(name: String, soup: &Soup, order: &mut Random) -> Case {
    of_table(name, soup, order, false, "match_twins")
}

fn border(name: String, soup: &Soup, order: &mut Random) -> Case {
    of_table(name, soup, order, true, "close_border")
}

fn build(name: String, soup: &Soup, _: &mut Random) -> Case {
    let case = Case::new(name, vertices(soup)).step(Step::Dump);
    case.step(Step::call("from_faces", soup.words())).step(Step::Dump)
}

/// Points whose coordinates need all of their bits.
fn rounding() -> Case {
    let points = [[0.1, 1e-30], [1e15 + 0.5, 0.2], [0.1 + 0.2, 1e15 + 0.125], [-1.0 / 3.0, 5e-324]];
    let case = Case::new("from_faces.rounding", Start::line(format!("points{}", starts::points(&points))));
    case.step(Step::Dump).step(Step::of_line("from_faces 3 0 1 2 3 0 2 3")).step(Step::Dump)
}
