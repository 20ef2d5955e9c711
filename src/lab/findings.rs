//! The faults of one case, as they stand in a report.

use super::fault::Fault;
use super::judge::Judge;
use super::report::Finding;

/// How many findings are listed.
const FINDINGS: usize = 10;

/// The faults of one case as findings: each sentence once. Of hidden cases only the promise is said.
pub(super) fn findings(judge: &dyn Judge, faults: &[&Fault], section: &str, hidden: bool) -> Vec<Finding> {
    let mut out: Vec<Finding> = Vec::new();
    for fault in faults {
        let words =
            if hidden { format!("broken in a hidden case: {}", judge.promise(fault)) } else { fault.words.clone() };
        let finding = Finding { rule: fault.rule.clone(), words, section: section.to_owned() };
        if out.len() < FINDINGS && !out.contains(&finding) {
            out.push(finding);
        }
    }
    out
}
