//! From a failing case to a short one: try shorter ones, many in one process, and go on from the shortest that fails.

use super::Shown;
use crate::protocol::Case;

/// How often the shortest one is tried to be made shorter still.
const ROUNDS: usize = 6;

/// The shortest case found. `shorter` gives candidates, the best first; `failing` runs some and keeps those that fail
/// in the same way, in their order.
pub(super) fn shrink(
    mut best: Shown,
    shorter: impl Fn(&Case) -> Vec<Case>,
    failing: impl Fn(Vec<Case>) -> Vec<Shown>,
) -> Shown {
    for _ in 0..ROUNDS {
        let candidates = shorter(&best.case);
        if candidates.is_empty() {
            break;
        }
        match failing(candidates).into_iter().next() {
            Some(shown) => best = shown,
            None => break,
        }
    }
    best
}
