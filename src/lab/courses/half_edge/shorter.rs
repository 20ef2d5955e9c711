//! Shorter sequences that may fail like a given one, so that a student has less to read.
//!
//! ```text
//!   polygon 0 0 7 1 8 6 1 5                       polygon 0 0 7 1 2 6
//!   split_in_half v1.outgoing.twin         ──▶    split_in_half h1
//!   split_face h3 h3.next.next                    split_in_half h1
//!   split_in_half h1
//! ```

use super::sequences::{followed, polygon};
use super::starts::{dangling, rectangle};
use crate::protocol::{Case, Start, Step};

/// How many are tried at a time.
const TRIED: usize = 240;
/// How many are tried in place of a start that is a table.
const TRIED_ONCE: usize = 900;
/// With at most so many earlier calls, every choice of them is tried.
const CHOICES: usize = 5;

/// Sequences with fewer calls, a smaller start or simpler words, the shortest first. Every one ends with a dump.
pub(super) fn shorter(case: &Case) -> Vec<Case> {
    let calls: Vec<&Step> = case.steps.iter().filter(|step| matches!(step, Step::Call { .. })).collect();
    let Some((&last, earlier)) = calls.split_last() else { return Vec::new() };
    if earlier.is_empty() {
        // One call on a start of one line is as short as can be.
        return if case.start.is_table() { without_table(case, last) } else { Vec::new() };
    }
    let starts = starts(&case.start);
    let mut all = Vec::new();
    for chosen in choices(earlier.len()) {
        let kept: Vec<Step> = chosen.iter().map(|&i| earlier[i].clone()).chain([last.clone()]).collect();
        all.extend(starts.iter().map(|start| followed(&case.name, start.clone(), &kept)));
    }
    let steps: Vec<Step> = calls.into_iter().cloned().collect();
    for (i, step) in steps.iter().enumerate() {
        for simpler in simpler(step) {
            let mut steps = steps.clone();
            steps[i] = simpler;
            all.extend(starts.iter().map(|start| followed(&case.name, start.clone(), &steps)));
        }
    }
    shortest(case, all, TRIED)
}

/// The shortest of some cases, and only those that are shorter than a given one.
fn shortest(case: &Case, all: Vec<Case>, most: usize) -> Vec<Case> {
    let size = size(case);
    let mut all: Vec<(_, Case)> = all.into_iter().map(|case| (self::size(&case), case)).collect();
    all.retain(|(other, _)| *other < size);
    all.sort_by(|a, b| a.0.cmp(&b.0));
    all.dedup_by(|a, b| a.1 == b.1);
    all.truncate(most);
    all.into_iter().map(|(_, case)| case).collect()
}

/// One call on other starts: polygons, with none, one or two calls before it that are sure to be right, and the smallest
/// structures with a dangling edge or a bridge.
///
/// ```text
///   table … 21 lines            polygon 0 0 7 1 8 6 1 5
///   split_face h6 h0     ──▶    split_in_half h0
///                               split_face h0 h0.next.next
/// ```
fn without_table(case: &Case, last: &Step) -> Vec<Case> {
    let Step::Call { function, arguments } = last else { return Vec::new() };
    if !matches!(function.as_str(), "split_face" | "split_in_half") {
        return Vec::new();
    }
    let call = |function: &str, words: &[&str]| Step::call(function, words);
    let half = |word| call("split_in_half", &[word]);
    let face = |words| call("split_face", words);
    let before: [Vec<Step>; 8] = [
        vec![],
        vec![half("h0")],
        vec![half("h1")],
        vec![face(&["h0", "h4"])],
        vec![face(&["h1", "h5"])],
        vec![half("h0"), half("h0")],
        vec![half("h0"), face(&["h0", "h4"])],
        vec![face(&["h0", "h4"]), half("h1")],
    ];
    let words = |count: usize| -> Vec<Vec<String>> {
        let base = (0..count).map(|h| format!("h{h}"));
        if arguments.len() == 1 {
            return base.map(|word| vec![word]).collect();
        }
        let pairs = |word: String| {
            let other = ["", ".next", ".prev", ".twin", ".next.next", ".next.next.next", ".prev.prev"];
            other.map(|links| vec![word.clone(), format!("{word}{links}")])
        };
        base.flat_map(pairs).collect()
    };
    let mut all = Vec::new();
    for corners in 3..=5 {
        for before in &before {
            // A triangle has no corners to join.
            if corners == 3 && before.first().is_some_and(|step| *step != half("h0") && *step != half("h1")) {
                continue;
            }
            for words in words(2 * corners) {
                let steps: Vec<Step> = before.iter().cloned().chain([Step::call(function, words)]).collect();
                all.push(followed(&case.name, polygon(corners), &steps));
            }
        }
    }
    for small in dangling() {
        let count = small.half_edges.len();
        let start = Start::table(small);
        all.extend(
            words(count).into_iter().map(|words| followed(&case.name, start.clone(), &[Step::call(function, words)])),
        );
    }
    shortest(case, all, TRIED_ONCE)
}

/// What makes a case long: its calls, then its links, then its corners, then its letters. Three lines of a table are as
/// long to read as a call.
fn size(case: &Case) -> (usize, usize, usize, String) {
    let script = case.script();
    let calls = case.steps.iter().filter(|step| matches!(step, Step::Call { .. })).count();
    let calls = if case.start.is_table() { calls + script.lines().count() / 3 } else { calls };
    let links = script.lines().skip(1).flat_map(str::chars).filter(|&c| c == '.').count();
    let corners = corners(&case.start).unwrap_or(usize::MAX);
    (calls, links, corners, script)
}

/// How many corners a start shows, as far as a reader minds: the rectangle is one word.
fn corners(start: &Start) -> Option<usize> {
    let mut words = start.text().split(' ');
    let kind = words.next()?;
    let numbers: Vec<usize> = words.clone().map_while(|word| word.parse().ok()).collect();
    match (kind, &numbers[..]) {
        ("rectangle", _) => Some(0),
        ("polygon", _) => Some(words.count() / 2),
        ("convex", [corners]) => Some(*corners),
        ("wheel", [spokes]) => Some(2 * spokes),
        ("grid", [columns, rows]) => Some(4 * columns * rows),
        _ => None,
    }
}

/// The start itself and those with fewer corners.
fn starts(start: &Start) -> Vec<Start> {
    let corners = match start.text().split_once(' ') {
        Some(("polygon", _)) => corners(start).unwrap_or(6),
        _ => 6,
    };
    [rectangle()].into_iter().chain((3..corners).map(polygon)).chain([start.clone()]).collect()
}

/// Which of the earlier calls to keep: every choice if they are few; else all but one, the last ones, or one.
fn choices(count: usize) -> Vec<Vec<usize>> {
    if count <= CHOICES {
        return (0..1_u32 << count).map(|bits| (0..count).filter(|i| bits >> i & 1 == 1).collect()).collect();
    }
    let but_one = (0..count).map(|left_out| (0..count).filter(|&i| i != left_out).collect());
    let last = (0..count).map(|from| (from..count).collect());
    let one = (0..count).map(|i| vec![i]);
    let half = [(0..count / 2).collect(), (0..count).step_by(2).collect()];
    but_one.chain(last).chain(one).chain(half).collect()
}

/// Whether the links of a word fit each other, and lead to a half-edge.
fn names_half_edge(word: &str) -> bool {
    let mut links = word.split('.');
    let first = links.next().and_then(|base| base.chars().next());
    let end = links.try_fold(first, |kind, link| match (kind, link) {
        (Some('h'), "next" | "prev" | "twin") => Some(Some('h')),
        (Some('h'), "origin") => Some(Some('v')),
        (Some('h'), "face") => Some(Some('f')),
        (Some('v'), "outgoing") | (Some('f'), "half_edge") => Some(Some('h')),
        _ => None,
    });
    end == Some(Some('h'))
}

/// The same call with one of its words a link shorter, or given by number.
fn simpler(step: &Step) -> Vec<Step> {
    let Step::Call { function, arguments } = step else { return Vec::new() };
    let mut out = Vec::new();
    for (i, word) in arguments.iter().enumerate() {
        let links: Vec<&str> = word.split('.').collect();
        let mut words: Vec<String> = Vec::new();
        if links.len() > 1 {
            words.extend((0..12).map(|h| format!("h{h}")));
            for left_out in 1..links.len() {
                let kept = links.iter().enumerate().filter(|&(at, _)| at != left_out).map(|(_, link)| *link);
                words.push(kept.collect::<Vec<_>>().join("."));
            }
        }
        for word in words {
            if !names_half_edge(&word) {
                continue;
            }
            let mut arguments = arguments.clone();
            arguments[i] = word;
            out.push(Step::Call { function: function.clone(), arguments });
        }
    }
    out
}
