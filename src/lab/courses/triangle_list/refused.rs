//! What a function returned that builds or refuses.

use crate::checks::faults::Faults;
use crate::fault::Exchange;
use crate::protocol::Value;
use std::collections::BTreeSet;

/// Whether a call has built what it should, so that it can be looked at; else what is wrong is added.
///
/// `allowed` are the refusals that are true: one of them must be given if there are any.
pub(super) fn built(
    exchange: &Exchange,
    tests: &[&'static str],
    allowed: &BTreeSet<String>,
    faults: &mut Faults,
) -> Option<()> {
    let values = faults.returned(exchange.called?.1, tests)?;
    let mut wrong = |rule, words: String| tests.iter().for_each(|test| faults.wrong(test, rule, &words, &[]));
    let all = || allowed.iter().map(|why| format!("\"{why}\"")).collect::<Vec<_>>().join(" or ");
    match values {
        [Value::Truth(true)] if allowed.is_empty() => return Some(()),
        [Value::Truth(true)] => wrong("accepted", format!("returned Ok, expected the refusal {}", all())),
        [Value::Refusal(why)] if allowed.is_empty() => {
            wrong("refused", format!("refused \"{why}\", but nothing is wrong with it"));
        }
        [Value::Refusal(why)] if !allowed.contains(why) => {
            wrong("reason", format!("refused \"{why}\", which is not so; expected {}", all()));
        }
        [Value::Refusal(_)] => {}
        _ => wrong("type", "returned neither Ok nor a refusal".to_owned()),
    }
    None
}
