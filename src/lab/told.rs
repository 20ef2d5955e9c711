//! What a call that fails says of the mistake behind it, as far as it is the same with every numbering and on every machine.
//!
//! ```text
//!   pole h4: 5 edges, expected 6      ──▶  pole h: 5 edges, expected 6       the words of the fault
//!   vertex 0 0.30000000000000004 …    ──▶  vertex 0 3.00000e-1 …             the whole answer, where the judge asks for it
//! ```
//!
//! The last and the first corner left out of a pole break the same law by the same number of edges: only the answer tells
//! one from the other. It is that of one numbering, so that the same mistake made in another one has no name: better
//! than a wrong one.

use super::fault::{Exchange, answered};
use super::protocol::{CallEnd, Case, CaseAnswer, Reply, Structure, Value};

/// The answer to a step: what was returned and the structure after it, or the picture as it is written.
pub(super) fn answer(exchange: Option<&Exchange>, step: usize, case: &Case, answer: &CaseAnswer) -> String {
    let mut out = String::new();
    if let Some(exchange) = exchange {
        if let Some((_, CallEnd::Returned(values))) = exchange.called {
            values.iter().for_each(|value| returned(value, &mut out));
        }
        out.extend(exchange.structure_after.map(Structure::text));
    } else if let Some((_, _, Reply::Svg(svg))) = answered(case, answer).find(|(number, ..)| *number == step) {
        out.push_str(svg);
    }
    as_told(&out)
}

fn returned(value: &Value, out: &mut String) {
    match value {
        Value::List(values) => values.iter().for_each(|value| returned(value, out)),
        Value::Structure(structure) => out.push_str(&structure.text()),
        value => out.push_str(&value.words()),
    }
    out.push('\n');
}

/// Words with ids left as their letters, and six digits of fractions, because the last ones of a sine are not the same
/// everywhere.
pub(super) fn as_told(words: &str) -> String {
    let mut out = String::with_capacity(words.len());
    let mut rest = words;
    while let Some(first) = rest.chars().next() {
        let joined = |c: char| c.is_alphanumeric() || c == '_';
        let at_begin = !out.ends_with(joined);
        let length = match first {
            'v' | 'h' | 'e' | 'f' if at_begin => {
                let digits = digits(&rest[1..]);
                if digits > 0 && !rest[1 + digits..].starts_with(joined) {
                    out.push(first);
                    1 + digits
                } else {
                    0
                }
            }
            '0'..='9' if at_begin => {
                let length = number(rest);
                match rest[..length].parse::<f64>() {
                    Ok(x) if rest[..length].contains(['.', 'e']) => out.push_str(&format!("{x:.5e}")),
                    _ => out.push_str(&rest[..length]),
                }
                length
            }
            _ => 0,
        };
        if length == 0 {
            out.push(first);
            rest = &rest[first.len_utf8()..];
        } else {
            rest = &rest[length..];
        }
    }
    out
}

/// How many digits a text begins with.
fn digits(text: &str) -> usize {
    text.bytes().take_while(u8::is_ascii_digit).count()
}

/// How long the number is that a text begins with: digits, a fraction, an exponent.
fn number(text: &str) -> usize {
    let mut length = digits(text);
    if let Some(fraction) = text[length..].strip_prefix('.')
        && digits(fraction) > 0
    {
        length += 1 + digits(fraction);
    }
    if let Some(exponent) = text[length..].strip_prefix('e') {
        let signless = exponent.strip_prefix(['-', '+']).unwrap_or(exponent);
        if digits(signless) > 0 {
            length += 1 + (exponent.len() - signless.len()) + digits(signless);
        }
    }
    length
}

#[cfg(test)]
mod tests {
    use super::super::fault::exchanges;
    use super::super::protocol::{Called, Start, Step};
    use super::*;

    #[test]
    fn an_answer_is_all_that_was_returned_or_the_picture() {
        let case = Case::new("x", Start::none()).step(Step::of_line("pole 4")).step(Step::Svg);
        let values = vec![Value::List(vec![Value::Number(0.1 + 0.2), Value::Id(7)]), Value::Truth(true)];
        let called = Called { arguments: vec![4], end: CallEnd::Returned(values) };
        let replies = vec![Reply::Called(called), Reply::Svg("<svg width=\"0.5\"/>".to_owned())];
        let answers = CaseAnswer { replies, complete: true, broken: None };
        let exchanges = exchanges(&case, &answers);
        assert_eq!(answer(exchanges.first(), 0, &case, &answers), "3.00000e-1\n7\n\ntrue\n");
        assert_eq!(answer(None, 1, &case, &answers), "<svg width=\"5.00000e-1\"/>");
    }

    #[test]
    fn what_is_said_is_the_same_with_every_numbering_and_to_six_digits() {
        for (one, other) in [
            ("next of h7 is h12, expected h3", "next of h1 is h40, expected h0"),
            ("v3 is not at (0.30000000000000004, 1)", "v8 is not at (0.3, 1)"),
            ("the edge (1.5e-7, -2.25) is missing", "the edge (0.00000015, -2.2500000001) is missing"),
        ] {
            assert_eq!(as_told(one), as_told(other));
        }
        for (one, other) in [
            ("euler 12 returned 3, expected 2", "euler 12 returned 4, expected 2"),
            ("v3 is not at (0.3, 1)", "h3 is not at (0.3, 1)"),
            ("at (0.3, 1)", "at (0.30001, 1)"),
            ("-1.5", "1.5"),
            ("face 12", "face 13"),
            ("half2 9007199254740993", "half3 9007199254740993"),
            ("9007199254740993", "9007199254740992"),
        ] {
            assert_ne!(as_told(one), as_told(other));
        }
        assert_eq!(as_told("f1: é 3.e h_2 e7e 1e5x"), "f: é 3.e h_2 e7e 1.00000e5x");
        assert_eq!(as_told(""), "");
    }
}
