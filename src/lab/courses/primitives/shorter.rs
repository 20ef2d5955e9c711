//! Shorter cases than a failing one: the same function on the smallest surfaces, at every place of them.
//!
//! ```text
//!   a triangle, a torus of two edges ─▶ the same with one split or spur more ─▶ with two more
//! ```

use super::asked::call;
use super::reference::{ring, round, split_face, split_vertex, turned};
use crate::protocol::{Case, Step};
use dcel_kit::HalfEdgeId;
use dcel_kit::topology::{Dcel, Table};

/// How many are tried at a time.
const TRIED: usize = 900;
/// How many primitives the largest of the surfaces have grown by.
const GROWN: usize = 2;

/// The same function on smaller surfaces, the smallest first.
pub(super) fn shorter(case: &Case) -> Vec<Case> {
    let [Step::Dump, Step::Call { function, arguments }, ..] = case.steps.as_slice() else { return Vec::new() };
    let Some(most) = case.start.half_edges().map(|table| table.half_edges.len()) else { return Vec::new() };
    let has_dump = case.steps.len() > 2;
    let smaller = small().into_iter().filter(|table| table.half_edges.len() < most);
    let cases = smaller.flat_map(|table| {
        let words = words(function, arguments, table.half_edges.len());
        let cases = words.into_iter().map(|words| call(case.name.clone(), &table, function, &words));
        cases.collect::<Vec<_>>()
    });
    let without_dump = |mut case: Case| {
        case.steps.truncate(if has_dump { 3 } else { 2 });
        case
    };
    cases.take(TRIED).map(without_dump).collect()
}

/// What a function can be asked with in a surface of so many half-edges.
fn words(function: &str, given: &[String], count: usize) -> Vec<Vec<String>> {
    let half_edges = || (0..count).map(|h| format!("h{h}"));
    match function {
        "euler" | "genus" => vec![Vec::new()],
        "pole" | "extrude" => half_edges().map(|h| vec![h]).collect(),
        "divide" => half_edges().map(|h| std::iter::once(h).chain(given.get(1).cloned()).collect()).collect(),
        "split_vertex" | "split_face" => {
            let pairs = half_edges().flat_map(|h| half_edges().map(move |other| vec![h.clone(), other]));
            // The handout says that a face is not split at one half-edge.
            pairs.filter(|pair| function == "split_vertex" || pair[0] != pair[1]).collect()
        }
        _ => Vec::new(),
    }
}

/// Surfaces of both kinds, grown by few primitives, the smallest first.
fn small() -> Vec<Table> {
    let mut all: Vec<Table> = ring(3).into_iter().chain([Table::from_view(&Dcel::torus())]).collect();
    let mut last = all.clone();
    for _ in 0..GROWN {
        last = last.iter().flat_map(grown).collect();
        all.extend_from_slice(&last);
    }
    all.sort_by_key(|table| table.half_edges.len());
    all
}

/// A surface with one primitive more: at its first half-edge, and at its last one.
fn grown(table: &Table) -> Vec<Table> {
    let count = table.half_edges.len() as u32;
    let mut all = Vec::new();
    for first in [0, count.saturating_sub(1)].map(HalfEdgeId::new) {
        for last in [Some(first), turned(table, first)].into_iter().flatten() {
            let mut more = table.clone();
            all.extend(split_vertex(&mut more, first, last).map(|_| more));
        }
        for other in round(table, first).unwrap_or_default().into_iter().skip(1).step_by(2) {
            let mut more = table.clone();
            all.extend(split_face(&mut more, first, other).map(|_| more));
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;
    use dcel_kit::topology::violations;

    #[test]
    fn small_surfaces_obey_the_laws_and_are_of_both_kinds() {
        let all = small();
        assert!((50..200).contains(&all.len()), "{}", all.len());
        for table in &all {
            assert_eq!(violations(table), []);
        }
        assert!([0, 1].iter().all(|&genus| all.iter().any(|table| super::super::growth::genus(table) == genus)));
    }

    #[test]
    fn shorter_cases_ask_the_same_function_of_a_smaller_surface() {
        let large = super::super::reference::cube(2).unwrap();
        for (function, given) in [
            ("split_vertex", vec!["h3", "h9"]),
            ("split_face", vec!["h1", "h2"]),
            ("pole", vec!["h5"]),
            ("divide", vec!["h7", "4"]),
            ("genus", vec![]),
        ] {
            let given: Vec<String> = given.into_iter().map(str::to_owned).collect();
            let case = call("x".to_owned(), &large, function, &given);
            let all = shorter(&case);
            assert!(all.len() > 20, "{function}: {}", all.len());
            let size = |case: &Case| case.start.half_edges().map(|table| table.half_edges.len());
            assert!(all.iter().all(|short| size(short) < size(&case)));
            assert!(all.windows(2).all(|pair| size(&pair[0]) <= size(&pair[1])), "{function}");
            for short in &all {
                let Step::Call { function: asked, arguments } = &short.steps[1] else { panic!("{}", short.script()) };
                assert!(asked == function && arguments.len() == given.len(), "{}", short.script());
                assert!(function != "divide" || arguments[1] == "4");
                assert!(function != "split_face" || arguments[0] != arguments[1]);
            }
            let shortest = &all[0];
            assert_eq!(shorter(shortest), [], "nothing is smaller");
        }
    }
}
