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

#[cfg(all(test, feature = "lab-04"))]
mod tests {
    use super::*;
    use crate::fault::FaultKind;

    fn fault(words: &str) -> Fault {
        Fault::new("face_walk", FaultKind::Wrong, 0, ["W1", ""], words.to_owned())
    }

    #[test]
    fn each_sentence_is_listed_once_and_no_more_than_ten() {
        let judge = crate::courses::judge_of("04-half-edge").unwrap();
        let words: Vec<String> = (0..12).flat_map(|i| [format!("wrong {i}"), "wrong 0".to_owned()]).collect();
        let faults: Vec<Fault> = words.iter().map(|words| fault(words)).collect();
        let listed = findings(judge, &faults.iter().collect::<Vec<_>>(), "1", false);
        let expected: Vec<String> = (0..10).map(|i| format!("wrong {i}")).collect();
        assert_eq!(listed.iter().map(|finding| finding.words.clone()).collect::<Vec<_>>(), expected);
    }

    #[test]
    fn of_hidden_cases_nothing_is_said_but_the_promise() {
        let judge = crate::courses::judge_of("04-half-edge").unwrap();
        let faults = [fault("h3.next = h5"), fault("h4.next = h6")];
        let listed = findings(judge, &faults.iter().collect::<Vec<_>>(), "1", true);
        assert_eq!(listed.len(), 1, "{listed:?}");
        assert!(listed[0].words.starts_with("broken in a hidden case: ") && !listed[0].words.contains("h3"));
    }
}
