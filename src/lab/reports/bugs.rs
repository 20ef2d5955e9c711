//! The named bugs of a class: what to talk about in the next lecture.

use super::{rows::rows, words};
use crate::Report;
use std::collections::{BTreeMap, BTreeSet};

/// The bugs by name with those who have them, the most frequent first, equal ones by name.
pub(super) fn count(reports: &[Report]) -> Vec<(String, Vec<String>)> {
    let mut found: BTreeMap<&str, Vec<String>> = BTreeMap::new();
    for report in reports {
        let names: BTreeSet<&str> = report.tests.iter().flat_map(|t| &t.bugs).map(String::as_str).collect();
        for name in names {
            found.entry(name).or_default().push(words::author(report));
        }
    }
    let mut bugs: Vec<_> = found.into_iter().map(|(bug, authors)| (bug.to_owned(), authors)).collect();
    bugs.sort_by_key(|(_, authors)| std::cmp::Reverse(authors.len()));
    bugs
}

/// A row for each bug.
pub(super) fn write(reports: &[Report]) -> String {
    let all = count(reports)
        .into_iter()
        .map(|(bug, authors)| vec![bug, authors.len().to_string(), authors.join("; ")])
        .collect::<Vec<_>>();
    rows(&["bug", "submissions", "who"], all)
}
