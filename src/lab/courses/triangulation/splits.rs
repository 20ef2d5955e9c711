//! `split(u, v)`: what it should leave, compared corner by corner.
//!
//! ```text
//!      ●──── v ────●             ●──── v   w ────●        the two new corners may have either of the next two numbers;
//!      │           │      =>     │     │   │     │        x, the copy of u, is returned
//!      ●──── u ────●             ●──── u   x ────●
//! ```

use super::lists::{next, place, prev};
use crate::fault::{Exchange, Fault, FaultKind, Instead};
use crate::protocol::{CallEnd, Cell, Records, Value};

/// The tests of a call by itself: refusals, cuts.
pub(super) const TESTS: [&str; 2] = ["split_refuses", "split"];
/// How many differences are told.
const TOLD: usize = 4;

/// Why a split must be refused.
pub(super) fn refusal(before: &Records, u: u32, v: u32) -> Option<&'static str> {
    if u == v {
        return Some("both are the same corner");
    }
    if next(before, u) == Some(v) {
        return Some("the second is next of the first");
    }
    (next(before, v) == Some(u)).then_some("the first is next of the second")
}

/// What a split should leave, and the part that each corner plays; the copy of u has this number, the copy of v the
/// other new one.
fn expected(before: &Records, u: u32, v: u32, copy_of_u: u32) -> Option<(Records, Vec<(u32, &'static str)>)> {
    let count = before.len(0) as u32;
    let copy_of_v = if copy_of_u == count { count + 1 } else { count };
    let (first, last) = (next(before, u)?, prev(before, v)?);
    let mut after = before.clone();
    let corner = |of: u32, next: u32, prev: u32| {
        let [x, y] = place(before, of)?;
        Some([Cell::Number(x), Cell::Number(y), Cell::Link(Some(next)), Cell::Link(Some(prev))])
    };
    let rows = [corner(u, first, copy_of_v)?, corner(v, copy_of_u, last)?];
    let in_order = if copy_of_u == count { [0, 1] } else { [1, 0] };
    in_order.iter().for_each(|&i| after.push(0, &rows[i]));
    let mut link = |corner: u32, column: usize, to: u32| {
        after.row_mut(0, corner as usize)?[column] = Cell::Link(Some(to));
        Some(())
    };
    link(u, 2, v)?;
    link(v, 3, u)?;
    link(first, 3, copy_of_u)?;
    link(last, 2, copy_of_v)?;
    let mut parts = vec![(u, "u"), (v, "v"), (copy_of_u, "the copy of u"), (copy_of_v, "the copy of v")];
    if first == last {
        parts.push((first, "the corner between u and v"));
    } else {
        parts.extend([(first, "the old next of u"), (last, "the old prev of v")]);
    }
    Some((after, parts))
}

/// What is wrong with one call, charged to the test of refusals or to that of cuts.
pub(super) fn judge(exchange: &Exchange, tests: [&'static str; 2]) -> Vec<Fault> {
    let Some((&[u, v], end)) = exchange.called else { return Vec::new() };
    let Some(before) = exchange.records_before() else { return Vec::new() };
    let refused = refusal(before, u, v);
    let test = tests[usize::from(refused.is_none())];
    let call = exchange.line();
    let rule = if refused.is_some() { "split.refusal" } else { "split.cut" };
    let fault =
        |kind, tag: &str, words: String| Fault::new(test, kind, exchange.step, [rule, tag], format!("{call}: {words}"));
    let returned = match end {
        CallEnd::Returned(values) => values.as_slice(),
        end => {
            let kind = FaultKind::of_end(end).unwrap_or(FaultKind::Wrong);
            return vec![fault(kind, "end", end.words())];
        }
    };
    let after = exchange.records_after();
    if let Some(because) = refused {
        if !matches!(returned, [Value::Refusal(_)]) {
            let words = format!("it is carried out, expected None: {because}");
            return vec![fault(FaultKind::Wrong, "carried out", words)];
        }
        if after.is_some_and(|after| after != before) {
            let words = "None is returned, but something has changed".to_owned();
            return vec![fault(FaultKind::Wrong, "changed", words)];
        }
        return Vec::new();
    }
    let &[Value::Id(corner)] = returned else {
        // To refuse what may be cut is as wrong as to cut what must be refused; of the cut it says nothing.
        let words = "None is returned, but the two corners are neither the same nor neighbours".to_owned();
        let own = fault(FaultKind::Wrong, "refused", words);
        return vec![Fault { test: tests[0], rule: "split.refusal".to_owned(), ..own }];
    };
    // Of a very large polygon only the cost is looked at.
    let Some(after) = after else { return Vec::new() };
    let count = before.len(0) as u32;
    if after.len(0) as u32 != count + 2 {
        let words = format!("there are {} corners, expected {}: two new ones", after.len(0), count + 2);
        return vec![fault(FaultKind::Wrong, &format!("count {}", after.len(0) as i64 - i64::from(count)), words)];
    }
    let differences = |copy_of_u| {
        let (expected, parts) = expected(before, u, v, copy_of_u)?;
        Some((differences(before, after, &expected, &parts), copy_of_u))
    };
    let best = [differences(count), differences(count + 1)];
    let Some((found, copy_of_u)) = best.into_iter().flatten().min_by_key(|(all, _)| all.len()) else {
        return Vec::new();
    };
    let mut faults: Vec<Fault> = Vec::new();
    for Difference { part, field, words, is } in found.into_iter().take(TOLD) {
        let subject = format!("{field} of {part}");
        let is = is.into_iter().collect();
        let wrong = fault(FaultKind::Wrong, &format!("{field} {part}"), words);
        faults.push(Fault { instead: Some(Instead { subject, is }), ..wrong });
    }
    if faults.is_empty() && corner != copy_of_u {
        let what = match corner {
            _ if corner == u => "u itself",
            _ if corner == v => "v",
            _ if corner >= count => "the copy of v",
            _ => "another corner",
        };
        let words = format!("c{corner} is returned, {what}, expected c{copy_of_u}, the copy of u");
        faults.push(fault(FaultKind::Wrong, &format!("returned {what}"), words));
    }
    faults
}

/// A field of a corner that is not what it should be.
struct Difference {
    part: &'static str,
    field: &'static str,
    words: String,
    is: Option<&'static str>,
}

fn differences(
    before: &Records,
    after: &Records,
    expected: &Records,
    parts: &[(u32, &'static str)],
) -> Vec<Difference> {
    let part_of = |corner: u32| parts.iter().find(|(other, _)| *other == corner).map(|(_, part)| *part);
    let name = |cell: Cell| match cell {
        Cell::Number(x) => x.to_string(),
        Cell::Link(None) => "not set".to_owned(),
        Cell::Link(Some(to)) => part_of(to).map_or_else(|| format!("c{to}"), |part| format!("c{to} ({part})")),
    };
    let mut out = Vec::new();
    for (corner, (found, right)) in (0..).zip(after.rows(0).zip(expected.rows(0))) {
        for (column, field) in ["x", "y", "next", "prev"].into_iter().enumerate() {
            if found[column] == right[column] {
                continue;
            }
            let part = part_of(corner).unwrap_or("a corner elsewhere");
            let old = before.row(0, corner as usize).map(|row| row[column]);
            let is = match found[column] {
                Cell::Link(None) => Some("unset still"),
                other if old == Some(other) => Some("what it was before the call: nothing sets it"),
                Cell::Link(Some(to)) => part_of(to),
                Cell::Number(_) => None,
            };
            let words =
                format!("c{corner} ({part}).{field} is {}, expected {}", name(found[column]), name(right[column]));
            out.push(Difference { part, field, words, is });
        }
    }
    out
}
